//! Other values in mid-life.

use super::mind::Mind;
use super::moment::NO_ACTION;
use super::step::{MindError, check_reward};
use super::voices::Voices;
use crate::reason::Reasoning;
use crate::word::ItemId;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS>,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// From now on it is worth so much when an item is on after an action, negative for harm.
    ///
    /// What was lived is judged anew: samples at once, trees as they grow from them, plans as they are
    /// thought through. Habits, counts of the model and the record of the voices were about the old
    /// values and begin again, from what is remembered and from what comes.
    /// An action is taken to have led to the item when that was on in what was perceived next; where
    /// nothing was, as at the end of an episode, when it brought just what this item was worth, and no
    /// other: of two that are worth the same such actions keep what they brought, so that of several
    /// values those go first that others are to have.
    /// Who is put elsewhere says so ([`interrupt`](Self::interrupt)), or tells what led there
    /// ([`observe`](Self::observe)).
    /// Where nothing that is remembered would bring anything now, and something is worth having, it sets
    /// out at once, as after a long time without reward (`MindConfig::burst`).
    /// One pass over the samples and the habits: a call for a robot that stands still.
    ///
    /// # Errors
    /// [`MindError::Unborn`], [`MindError::NoSuchItem`], or [`MindError::Reward`]; nothing has changed.
    ///
    /// ```
    /// use cla_core::word::ItemId;
    /// use cla_core::forest::{Mind, MindConfig, MindError};
    /// let mut mind = Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new();
    /// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 7)?;
    /// mind.revalue(ItemId(1), -2.0)?;
    /// assert_eq!(mind.value(ItemId(1)), -2.0);
    /// assert_eq!(mind.revalue(ItemId(2), 1.0), Err(MindError::NoSuchItem(ItemId(2))));
    /// # Ok::<(), MindError>(())
    /// ```
    pub fn revalue(&mut self, item: ItemId, value: f32) -> Result<(), MindError> {
        self.born()?;
        check_reward(value)?;
        let place = self.values.get_mut(usize::from(item.0));
        let place = place.ok_or(MindError::NoSuchItem(item))?;
        let old = core::mem::replace(place, value);
        if old == value {
            return Ok(());
        }
        let others = self.values.iter().enumerate();
        let alone = others
            .filter(|(at, _)| *at != usize::from(item.0))
            .all(|(_, value)| *value != old);
        let ends = self.forest.revalue(item, (old, value), alone);
        self.reason.revalue(item, value);
        self.habits.begin_anew(ends);
        self.model.clear();
        self.did = NO_ACTION;
        self.voices = Voices::new();
        self.led = false;
        self.doubt.get_acquainted();
        if old > 0.0 || value > 0.0 {
            // How long the new values take to come is not known.
            (self.since, self.wait, self.earned) = (0, 0.0, self.earned.min(1));
            let hopes = self.values.iter().any(|it| *it > 0.0);
            let sets_out = hopes && ends.1 <= 0.0;
            self.burst = if sets_out { self.config.burst } else { 0 };
        }
        self.begin_health();
        Ok(())
    }
}

//! A look inside a mind: what matters to it, how much it knows, who decided well, its contexts.
//!
//! Nothing here changes anything.

use super::config::Voice;
use super::mind::Mind;
use super::moment::Feature;
use super::tree::DEEP;
use crate::word::{ActionId, ItemId, ItemSet};

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// Items that matter.
    #[must_use]
    pub const fn relevant(&self) -> &ItemSet<WORDS> {
        self.forest.mask()
    }

    /// How clearly an item tells values apart: a running mean of its best F statistic.
    #[must_use]
    pub fn relevance(&self, item: ItemId) -> f32 {
        self.forest.relevance(item)
    }

    /// States or links of the model that were given up for others.
    #[must_use]
    pub const fn given_up(&self) -> u32 {
        self.model.given_up()
    }

    /// Whether it doubts in what it knew.
    #[must_use]
    pub const fn doubts(&self) -> bool {
        self.doubt.lasts()
    }

    /// How often it has begun to doubt in what it knew.
    #[must_use]
    pub const fn alarms(&self) -> u32 {
        self.doubt.alarms()
    }

    /// The share of steps that find their row taken by another step; above one half, items that do
    /// not matter are left out of what is keyed by whole percepts.
    #[must_use]
    pub const fn crowding(&self) -> f32 {
        self.habits.crowding()
    }

    /// Items that count as off because they are stuck.
    #[must_use]
    pub fn stuck(&self) -> u16 {
        self.runs.stuck()
    }

    /// Samples in memory, leaves of the newest trees, and how often trees were grown.
    #[must_use]
    pub fn size(&self) -> (u16, u16, u32) {
        (
            self.forest.samples(),
            self.forest.leaves(),
            self.forest.grown(),
        )
    }

    /// The track record of a voice: what an action under it brought, now and later, and in how many
    /// blocks it has led.
    #[must_use]
    pub fn record(&self, voice: Voice) -> (f32, u16) {
        self.voices.record(voice as u8)
    }

    /// The contexts in which the newest trees see an action, and what it is worth there, in the
    /// order of the tree: simple schemas without their results.
    pub fn contexts(&self, action: ActionId, mut see: impl FnMut(&[(Feature, bool)], f32)) {
        self.forest.visit(action.0 as u8, &mut |path, value| {
            let mut context = [(Feature::Now(ItemId(0)), false); DEEP];
            for (place, (feature, yes)) in context.iter_mut().zip(path) {
                *place = (Feature::of::<ITEMS>(*feature), *yes);
            }
            see(context.get(..path.len()).unwrap_or(&[]), value);
        });
    }
}

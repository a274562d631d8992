//! A mind looks itself through: what cannot be so is mended, dropped, or named.

use super::mind::{Age, Mind};
use super::moment::NO_ACTION;
use super::step::check_reward;
use crate::reason::Reasoning;
use crate::snapshot::{Audit, Mender, Snapshot, Stored, mend_sections, refuses};

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS> + Stored,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// Parts in which a mind can look itself through: samples and trees, habits, model, reason, and
    /// where its life stands.
    pub const AUDIT_PARTS: usize = 5;

    /// Looks everything through once, and mends what a memory that lost a bit may have done: links,
    /// ids, ranges, numbers that are none.
    ///
    /// A sound mind lives on to the bit; values that are wrong and possible are not seen.
    /// What is not [`Audit::Lost`] afterwards can be saved.
    /// A model or imagined states whose lists are broken begin anew.
    ///
    /// ```
    /// use cla_core::forest::{Mind, MindConfig};
    /// use cla_core::snapshot::Audit;
    /// let mut mind = Box::new(Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new());
    /// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 7)?;
    /// assert_eq!(mind.audit(), Audit::Sound);
    /// # Ok::<(), cla_core::forest::MindError>(())
    /// ```
    pub fn audit(&mut self) -> Audit {
        let mut found = Audit::Sound;
        for part in 0..Self::AUDIT_PARTS {
            found = found.and(self.audit_part(part));
            if matches!(found, Audit::Lost(_)) {
                return found;
            }
        }
        found
    }

    /// Looks one part through, of [`AUDIT_PARTS`](Self::AUDIT_PARTS); there is nothing in others.
    ///
    /// Where something is lost the part is as it was.
    pub fn audit_part(&mut self, part: usize) -> Audit {
        if self.age == Age::Unborn || part >= Self::AUDIT_PARTS {
            return Audit::Sound;
        }
        if let Some(lost) = self.lost() {
            return Audit::Lost(lost);
        }
        let mended = match part {
            0 => self.forest.audit(),
            1 => 0,
            2 => self.model.audit(),
            3 => self.reason.audit(self.values),
            _ => self.audit_life(),
        };
        let rest = mend_sections(self, part..part + 1, <Self as Snapshot>::limits());
        Audit::of(mended).and(rest)
    }

    fn lost(&self) -> Option<&'static str> {
        let mut look = Mender::of(<Self as Snapshot>::limits());
        if refuses(&self.config, &mut look) {
            return Some("the configuration");
        }
        if !self.rng.is_seeded() {
            return Some("the generator");
        }
        let worth = self.values.iter();
        let lost = worth.map(|it| check_reward(*it)).any(|it| it.is_err());
        lost.then_some("what is worth having")
    }

    fn audit_life(&mut self) -> u32 {
        let mut mended = 0;
        for action in [&mut self.did, &mut self.last, &mut self.chosen] {
            if !Self::is_action(action) {
                *action = NO_ACTION;
                mended += 1;
            }
        }
        mended
    }
}

#[cfg(test)]
#[path = "audit_tests.rs"]
mod tests;

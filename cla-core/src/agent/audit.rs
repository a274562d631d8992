//! An agent looks itself through: what cannot be so is mended, dropped, or named.

use super::image::BEFORE_MAPS;
use super::life::{Agent, Stage};
use crate::snapshot::{Audit, Limits, Mender, Snapshot, Stored, mend_sections, refuses};
use crate::som::Prototypes;
use crate::word::ActionId;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
    M: Prototypes<WIDTH, HEIGHT> + Stored,
> Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    /// Parts in which an agent can look itself through: what it knows, what it prefers and where its
    /// life stands, and each map.
    pub const AUDIT_PARTS: usize = 2 + ACTIONS;

    /// Looks everything through once, and mends what a memory that lost a bit may have done: links,
    /// ids, ranges, numbers that are none.
    ///
    /// A sound brain lives on to the bit; values that are wrong and possible are not seen.
    /// What is not [`Audit::Lost`] afterwards can be saved.
    /// For times when nothing has to be done: it takes as long as eight harvests, its longest part as two and a half;
    /// [`audit_part`](Self::audit_part) does it in steps.
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
    /// Where something is lost that part is as it was, so that the last image can be compared with it.
    ///
    /// ```
    /// use cla_core::forager::small;
    /// use cla_core::snapshot::Audit;
    /// use cla_core::AgentConfig;
    /// let mut brain = Box::new(small::brain());
    /// small::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
    /// for tick in 0..100 {
    ///     // … one control step, and a part of the audit …
    ///     assert_eq!(brain.audit_part(tick % small::Brain::AUDIT_PARTS), Audit::Sound);
    /// }
    /// # Ok::<(), cla_core::ConfigError>(())
    /// ```
    pub fn audit_part(&mut self, part: usize) -> Audit {
        if self.stage == Stage::Unborn {
            return Audit::Sound;
        }
        if let Some(lost) = self.lost() {
            return Audit::Lost(lost);
        }
        match part {
            0 => {
                let mended = self.audit_knowledge();
                let rest = mend_sections(self, 0..2, <Self as Snapshot>::limits());
                Audit::of(mended).and(rest)
            }
            1 => {
                let mended = self.audit_life();
                Audit::of(mended).and(mend_sections(self, 2..4, self.counted()))
            }
            _ => {
                let action = part - 2;
                let Some(map) = self.bank.maps.get_mut(action) else {
                    return Audit::Sound;
                };
                let mended = map.audit();
                let section = BEFORE_MAPS + action;
                let rest = mend_sections(self, section..section + 1, self.counted());
                Audit::of(mended).and(rest)
            }
        }
    }

    /// What is lost and cannot be found again from the rest.
    fn lost(&self) -> Option<&'static str> {
        let mut look = Mender::of(<Self as Snapshot>::limits());
        if refuses(&self.config, &mut look) {
            return Some("the configuration");
        }
        if !self.rng.is_seeded() {
            return Some("the generator");
        }
        self.faculties.knowledge.lost(ACTIONS as u16)
    }

    /// How many there are of what links point at.
    fn counted(&self) -> Limits {
        let mut limits = <Self as Snapshot>::limits();
        limits.patterns = self.faculties.knowledge.patterns();
        limits.schemas = self.faculties.knowledge.schemas().len() as u16;
        limits.synthetic = self.faculties.level2.rows();
        limits
    }

    fn audit_knowledge(&mut self) -> u32 {
        let before = self.faculties.knowledge.schemas().len();
        let mut mended = self.faculties.knowledge.audit(ACTIONS as u16);
        let moved = self.faculties.knowledge.schemas().len() < before;
        let knowledge = &mut self.faculties.knowledge;
        mended += self.faculties.level2.audit(knowledge, moved);
        let level2 = &self.faculties.level2;
        let trail = self.faculties.trail.item();
        self.faculties
            .trail
            .keep(|item| level2.schema(item).is_some());
        mended + u32::from(trail != self.faculties.trail.item())
    }

    fn audit_life(&mut self) -> u32 {
        let mut mended = self.faculties.habits.audit();
        mended += u32::from(self.faculties.alarm.audit());
        if self.chosen.is_some_and(|it| it >= ActionId(ACTIONS as u16)) {
            self.chosen = None;
            mended += 1;
        }
        mended
    }
}

#[cfg(test)]
#[path = "audit_tests.rs"]
mod tests;

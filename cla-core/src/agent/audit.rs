//! An agent looks itself through: what cannot be so is mended, dropped, or named.

use super::config::Settings;
use super::life::{Agent, Stage};
use crate::check::Config;
use crate::som::Prototypes;
use crate::word::ActionId;

/// What an agent found when it looked itself through.
///
/// ```
/// use cla_core::agent::Audit;
/// assert_eq!(Audit::Sound.to_string(), "all is sound");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Audit {
    /// Nothing that cannot be so.
    Sound,
    /// So many rows, values and nodes were dropped or forgotten; it can live on.
    Mended(u32),
    /// The part of that name is lost and cannot be found again from the rest: load the last image, or
    /// let it be born again.
    Lost(&'static str),
}

impl core::fmt::Display for Audit {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Sound => f.write_str("all is sound"),
            Self::Mended(many) => write!(f, "{many} entries were mended or dropped"),
            Self::Lost(part) => write!(f, "{part} cannot be mended: load the last image"),
        }
    }
}

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
    M: Prototypes<WIDTH, HEIGHT>,
> Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    /// Looks everything through once, and mends what a memory that lost a bit may have done: links,
    /// ids, ranges, numbers that are none.
    ///
    /// A sound brain lives on to the bit; values that are wrong and possible are not seen.
    /// For times when nothing has to be done: it takes about as long as a harvest.
    pub fn audit(&mut self) -> Audit {
        if self.stage == Stage::Unborn {
            return Audit::Sound;
        }
        match &self.config {
            Settings::Present(config) if config.check().is_ok() => {}
            _ => return Audit::Lost("the configuration"),
        }
        if !self.rng.is_seeded() {
            return Audit::Lost("the generator");
        }
        let before = self.faculties.knowledge.schemas().len();
        let Some(mut mended) = self.faculties.knowledge.audit(ACTIONS as u16) else {
            return Audit::Lost("what is worth having");
        };
        if before > 0 && self.faculties.knowledge.schemas().is_empty() {
            return Audit::Lost("all that was known");
        }
        let moved = self.faculties.knowledge.schemas().len() < before;
        let knowledge = &mut self.faculties.knowledge;
        mended += self.faculties.level2.audit(knowledge, moved);
        mended += self.faculties.habits.audit();
        mended += u32::from(self.faculties.alarm.audit());
        let level2 = &self.faculties.level2;
        self.faculties
            .trail
            .keep(|item| level2.schema(item).is_some());
        if self.chosen.is_some_and(|it| it >= ActionId(ACTIONS as u16)) {
            self.chosen = None;
            mended += 1;
        }
        for map in &mut self.bank.maps {
            mended += map.audit();
        }
        match mended {
            0 => Audit::Sound,
            many => Audit::Mended(many),
        }
    }
}

#[cfg(test)]
#[path = "audit_tests.rs"]
mod tests;

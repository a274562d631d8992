//! An agent's image: what is kept of its life, and in which order.
//!
//! Everything that makes the next step what it would have been; the maps' work memory is left out, and
//! what can be computed from the rest is computed again.

use super::life::{Agent, Stage};
use crate::choice::Habits;
use crate::knowledge::KnowledgeBase;
use crate::level2::SecondLevel;
use crate::map::ActionSom;
use crate::num::Rng;
use crate::snapshot::{
    Flip, Limits, Mender, Profile, Reader, Snapshot, Stored, Writer, check_fields, flip_fields,
    mend_fields, restore_fields, store_fields,
};
use crate::som::Prototypes;

/// Sections before the maps, of which each is one.
pub(super) const BEFORE_MAPS: usize = 4;
/// The names of the sections, for as many actions as there may be.
const SECTIONS: [&str; BEFORE_MAPS + 256] = {
    let mut names = ["maps"; BEFORE_MAPS + 256];
    let (first, _) = names.split_at_mut(BEFORE_MAPS);
    first.copy_from_slice(&["knowledge", "second level", "habits", "life"]);
    names
};

/// The fields of the section "life", each with what it may be.
macro_rules! life {
    ($each:ident, $by:tt) => {
        $each! {
            $by;
            config,
            exploration,
            rng if Rng::is_seeded,
            stage if |it: &Stage| *it != Stage::Unborn,
            context,
            chosen,
            decided_after,
            since_harvest,
            faculties.trail,
            faculties.alarm,
            faculties.practised,
            bank.scratch.cost,
        }
    };
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
    M: Prototypes<WIDTH, HEIGHT> + Stored,
> Snapshot
    for Agent<WORDS, ITEMS, WIDTH, HEIGHT, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS, M>
{
    const PROFILE: Profile = Profile {
        kind: 1,
        weights: M::STORED_AS,
        capacities: &[
            ("words", WORDS as u32),
            ("items", ITEMS as u32),
            ("columns", WIDTH as u32),
            ("rows", HEIGHT as u32),
            ("actions", ACTIONS as u32),
            ("patterns", PATTERNS as u32),
            ("schemas", SCHEMAS as u32),
            ("synthetic items", SYNTHETIC as u32),
            ("beliefs", BELIEFS as u32),
        ],
    };

    const SECTIONS: &'static [&'static str] = SECTIONS.split_at(BEFORE_MAPS + ACTIONS).0;

    fn is_born(&self) -> bool {
        self.stage != Stage::Unborn
    }

    fn limits() -> Limits {
        Limits::of(ACTIONS as u16)
    }

    fn store_section(&self, number: usize, to: &mut Writer<'_>) {
        match number {
            0 => self.faculties.knowledge.store(to),
            1 => self.faculties.level2.store(to),
            2 => self.faculties.habits.store(to),
            3 => life!(store_fields, (self, to)),
            _ => {
                if let Some(map) = self.bank.maps().get(number - BEFORE_MAPS) {
                    map.store(to);
                }
            }
        }
    }

    fn check_section(number: usize, from: &mut Reader<'_>) {
        match number {
            0 => KnowledgeBase::<WORDS, PATTERNS, SCHEMAS>::check(from),
            1 => SecondLevel::<ACTIONS, SYNTHETIC, BELIEFS>::check(from),
            2 => Habits::<WORDS, ITEMS, ACTIONS, SYNTHETIC>::check(from),
            3 => life!(check_fields, from),
            _ => ActionSom::<WIDTH, HEIGHT, ITEMS, M>::check(from),
        }
    }

    fn restore_section(&mut self, number: usize, from: &mut Reader<'_>) {
        match number {
            0 => self.faculties.knowledge.restore(from),
            1 => self.faculties.level2.restore(from),
            2 => self.faculties.habits.restore(from),
            3 => life!(restore_fields, (self, from)),
            _ => {
                if let Some(map) = self.bank.maps.get_mut(number - BEFORE_MAPS) {
                    map.restore(from);
                }
            }
        }
    }

    fn mend_section(&mut self, number: usize, by: &mut Mender) {
        match number {
            0 => self.faculties.knowledge.mend(by),
            1 => self.faculties.level2.mend(by),
            2 => self.faculties.habits.mend(by),
            3 => life!(mend_fields, (self, by)),
            _ => {
                if let Some(map) = self.bank.maps.get_mut(number - BEFORE_MAPS) {
                    map.mend(by);
                }
            }
        }
    }

    fn flip_section(&mut self, number: usize, by: &mut Flip) {
        match number {
            0 => self.faculties.knowledge.flip(by),
            1 => self.faculties.level2.flip(by),
            2 => self.faculties.habits.flip(by),
            3 => life!(flip_fields, (self, by)),
            _ => {
                if let Some(map) = self.bank.maps.get_mut(number - BEFORE_MAPS) {
                    map.flip(by);
                }
            }
        }
    }

    fn rebuild(&mut self) {
        self.faculties.knowledge.rebuild();
        self.faculties.level2.rebuild();
        for map in &mut self.bank.maps {
            map.rebuild();
        }
        self.begin_health();
    }

    fn forsake(&mut self) {
        self.stage = Stage::Unborn;
    }
}

//! A mind's image: everything that makes its next step what it would have been.

use super::mind::{Age, Mind};
use super::model::Model;
use super::moment::NO_ACTION;
use super::sarsa::Sarsa;
use super::step::{MOST_EARNED, MOST_REWARD};
use super::trees::Forest;
use crate::num::Rng;
use crate::reason::Reasoning;
use crate::snapshot::{
    Flip, LARGEST_COUNT, Limits, Mender, Profile, Reader, Snapshot, Stored, Writer, check_fields,
    flip_fields, mend_fields, restore_fields, store_fields,
};

/// The fields of the section "life", each with what it may be.
macro_rules! life {
    ($each:ident, $by:tt) => {
        $each! {
            $by;
            state,
            did if Self::is_action,
            brought => within MOST_EARNED,
            voices,
            runs,
            doubt,
            values => within MOST_REWARD,
            config,
            rng if Rng::is_seeded,
            age if |it: &Age| *it != Age::Unborn,
            before,
            last if Self::is_action,
            chosen if Self::is_action,
            now,
            since,
            wait => up_to LARGEST_COUNT,
            earned,
            burst,
            led,
            stroll,
            said,
        }
    };
}

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
> Snapshot for Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    const PROFILE: Profile = Profile {
        kind: 2,
        weights: 0,
        capacities: &[
            ("words", WORDS as u32),
            ("items", ITEMS as u32),
            ("actions", ACTIONS as u32),
            ("stretches", STRETCHES as u32),
            ("leaves", LEAVES as u32),
            ("rows", ROWS as u32),
            ("states", STATES as u32),
            ("links", LINKS as u32),
            ("remembered samples of an action", R::CAPACITIES[0]),
            ("schemas", R::CAPACITIES[1]),
            ("imagined states", R::CAPACITIES[2]),
        ],
    };

    const SECTIONS: &'static [&'static str] =
        &["memory and trees", "habits", "model", "reason", "life"];

    fn is_born(&self) -> bool {
        self.age != Age::Unborn
    }

    fn limits() -> Limits {
        Limits::of(ACTIONS as u16)
    }

    fn store_section(&self, number: usize, to: &mut Writer<'_>) {
        match number {
            0 => self.forest.store(to),
            1 => self.habits.store(to),
            2 => self.model.store(to),
            3 => self.reason.store(to),
            _ => life!(store_fields, (self, to)),
        }
    }

    fn check_section(number: usize, from: &mut Reader<'_>) {
        match number {
            0 => checked::<Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>>(from),
            1 => checked::<Sarsa<WORDS, ITEMS, ACTIONS, ROWS>>(from),
            2 => checked::<Model<ACTIONS, STATES, LINKS>>(from),
            3 => checked::<R>(from),
            _ => life!(check_fields, from),
        }
    }

    fn restore_section(&mut self, number: usize, from: &mut Reader<'_>) {
        match number {
            0 => restored(&mut self.forest, from),
            1 => restored(&mut self.habits, from),
            2 => restored(&mut self.model, from),
            3 => restored(&mut self.reason, from),
            _ => life!(restore_fields, (self, from)),
        }
    }

    fn mend_section(&mut self, number: usize, by: &mut Mender) {
        match number {
            0 => self.forest.mend(by),
            1 => self.habits.mend(by),
            2 => self.model.mend(by),
            3 => self.reason.mend(by),
            _ => life!(mend_fields, (self, by)),
        }
    }

    fn flip_section(&mut self, number: usize, by: &mut Flip) {
        match number {
            0 => self.forest.flip(by),
            1 => self.habits.flip(by),
            2 => self.model.flip(by),
            3 => self.reason.flip(by),
            _ => life!(flip_fields, (self, by)),
        }
    }

    fn rebuild(&mut self) {
        self.begin_health();
    }

    fn forsake(&mut self) {
        self.age = Age::Unborn;
    }
}

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
    /// Whether a number is that of an action, or of none.
    pub(super) const fn is_action(number: &u8) -> bool {
        *number == NO_ACTION || (*number as usize) < ACTIONS
    }
}

/// A function of its own for each part: a compiler that puts all of them into one takes minutes over it.
#[inline(never)]
fn checked<T: Stored>(from: &mut Reader<'_>) {
    T::check(from);
}

/// Likewise.
#[inline(never)]
fn restored<T: Stored>(it: &mut T, from: &mut Reader<'_>) {
    it.restore(from);
}

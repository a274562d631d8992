//! Habits of the learner: Sarsa(λ) over the items that are on and matter, the last step, and a
//! constant (Rummery and Niranjan 1994; Sutton and Barto 2018, 12.7).
//!
//! Traces accumulate: every feature of a deed is traced alike, which keeps values from drifting for
//! ever, as replacing traces do not.
//! The last step (percept, action, percept, each seen through the mask) is hashed to a row, so its
//! table needs no keys and is never full.

use super::growth::mix;
use super::moment::{Moment, NO_ACTION};
use super::step::MOST_EARNED;
use crate::snapshot::{MOST_CHANGE, Reader, Stored, Writer, bounded, stored};
use crate::word::{ItemId, ItemSet};

/// Deeds that are felt; what is older has faded to a ten-thousandth.
const FELT: usize = 24;

/// How habits learn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rates {
    pub(super) rate: f32,
    pub(super) discount: f32,
    pub(super) lambda: f32,
    /// A feature that came again belongs to the newer deed alone: quick, and for a short time only.
    pub(super) replacing: bool,
}

/// How habits learn from what was lived before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Replaying {
    pub(super) rate: f32,
    pub(super) discount: f32,
    pub(super) lambda: f32,
}

/// Where something was done, as habits see it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scene<const WORDS: usize> {
    /// Items that are on and matter.
    pub(super) on: ItemSet<WORDS>,
    /// The last step: its row, and a number that tells it from most others in the same row.
    pub(super) row: u16,
    pub(super) owner: u16,
}

impl<const WORDS: usize> Scene<WORDS> {
    /// A moment as habits with so many rows see it, through the mask.
    pub(super) fn of(moment: &Moment<WORDS>, mask: &ItemSet<WORDS>, rows: u16) -> Self {
        let step = step_of(moment, mask);
        Self {
            on: moment.now.on().intersection(mask),
            row: row(step, rows),
            owner: step as u16,
        }
    }
}

/// The number of the step that led to a moment, seen through the mask.
pub(super) fn step_of<const WORDS: usize>(moment: &Moment<WORDS>, mask: &ItemSet<WORDS>) -> u32 {
    let before = if moment.action == NO_ACTION {
        ItemSet::EMPTY
    } else {
        moment.before.on().intersection(mask)
    };
    number(&before, moment.action, &moment.now.on().intersection(mask))
}

/// The number of a step, the same for equal steps, and hardly ever for others.
pub(super) fn number<const WORDS: usize>(
    before: &ItemSet<WORDS>,
    action: u8,
    now: &ItemSet<WORDS>,
) -> u32 {
    let mut hash = mix(u32::from(action) + 1);
    for word in before.words().iter().chain(now.words()) {
        hash = mix(hash.rotate_left(5) ^ *word);
    }
    hash.max(1)
}

/// The row of a step with this number.
fn row(number: u32, rows: u16) -> u16 {
    // The high half of the product is uniform in 0..rows.
    ((u64::from(number) * u64::from(rows)) >> 32) as u16
}

#[derive(Clone, Copy, Debug)]
struct Deed<const WORDS: usize> {
    scene: Scene<WORDS>,
    action: u8,
}

/// What each action has brought, for each feature; the worth of an action is their sum.
#[derive(Clone, Debug)]
pub(super) struct Sarsa<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const ROWS: usize,
> {
    always: [f32; ACTIONS],
    items: [[f32; ACTIONS]; ITEMS],
    rows: [[f32; ACTIONS]; ROWS],
    /// Whose each row was last, and how often a step finds its row taken by another.
    owners: [u16; ROWS],
    crowding: f32,
    /// The last deeds in a ring, where the newest is, and how many there are.
    deeds: [Deed<WORDS>; FELT],
    newest: u8,
    count: u8,
    /// What the newest has brought; what followed it is not known yet.
    reward: f32,
    /// The least and the greatest reward of a step.
    least: f32,
    most: f32,
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const ROWS: usize>
    Sarsa<WORDS, ITEMS, ACTIONS, ROWS>
{
    pub(super) const fn new() -> Self {
        let none = Deed {
            scene: Scene {
                on: ItemSet::EMPTY,
                row: 0,
                owner: 0,
            },
            action: 0,
        };
        Self {
            always: [0.0; ACTIONS],
            items: [[0.0; ACTIONS]; ITEMS],
            rows: [[0.0; ACTIONS]; ROWS],
            owners: [0; ROWS],
            crowding: 0.0,
            deeds: [none; FELT],
            newest: 0,
            count: 0,
            reward: 0.0,
            least: 0.0,
            most: 0.0,
        }
    }

    /// Forgets everything, in place.
    pub(super) fn clear(&mut self) {
        self.always = [0.0; ACTIONS];
        for worth in &mut self.items {
            *worth = [0.0; ACTIONS];
        }
        self.forget_rows();
        self.owners.fill(0);
        self.crowding = 0.0;
        self.least = 0.0;
        self.most = 0.0;
    }

    /// Forgets everything but what can be earned in a step, at least and at most.
    pub(super) fn begin_anew(&mut self, (least, most): (f32, f32)) {
        self.clear();
        (self.least, self.most) = (least, most);
    }

    /// What each action has been worth in a scene, within what can be earned.
    pub(super) fn worth(&self, scene: &Scene<WORDS>, discount: f32) -> [f32; ACTIONS] {
        let mut worth = self.always;
        for item in scene.on.iter() {
            add(&mut worth, self.items.get(usize::from(item.0)));
        }
        add(&mut worth, self.rows.get(usize::from(scene.row)));
        let horizon = 1.0 / (1.0 - discount);
        let (least, most) = (self.least * horizon, self.most * horizon);
        for value in &mut worth {
            // Not `clamp`, which panics where the bounds are the wrong way round.
            if *value < least {
                *value = least;
            } else if *value > most {
                *value = most;
            }
        }
        worth
    }

    /// Rows that some step has.
    pub(super) fn rows(&self) -> u32 {
        let mut rows = 0;
        for owner in self.owners {
            rows += u32::from(owner != 0);
        }
        rows
    }

    /// What an item that is on adds to each action.
    pub(super) fn of_item(&self, item: ItemId) -> [f32; ACTIONS] {
        let worth = self.items.get(usize::from(item.0));
        worth.copied().unwrap_or([0.0; ACTIONS])
    }

    /// The share of steps that find their row taken by another step, a running mean over some 500.
    pub(super) const fn crowding(&self) -> f32 {
        self.crowding
    }

    fn worth_of(&self, deed: &Deed<WORDS>, discount: f32) -> f32 {
        let worth = self.worth(&deed.scene, discount);
        worth.get(usize::from(deed.action)).copied().unwrap_or(0.0)
    }

    /// Other items matter now: rows no longer mean what they meant.
    pub(super) fn forget_rows(&mut self) {
        for worth in &mut self.rows {
            *worth = [0.0; ACTIONS];
        }
        self.count = 0;
    }

    /// Learns what the deed before this one was good for, now that it is known what followed.
    pub(super) fn feel(&mut self, scene: Scene<WORDS>, action: u8, reward: f32, rates: &Rates) {
        let deed = Deed { scene, action };
        let follows = rates.discount * self.worth_of(&deed, rates.discount);
        self.learn(follows, rates);
        self.newest = self.newest.wrapping_add(1) % FELT as u8;
        if let Some(place) = self.deeds.get_mut(usize::from(self.newest)) {
            *place = deed;
        }
        if usize::from(self.count) < FELT {
            self.count += 1;
        }
        if let Some(owner) = self.owners.get_mut(usize::from(scene.row)) {
            let taken = if *owner == scene.owner { 0.0 } else { 1.0 };
            *owner = scene.owner;
            self.crowding += 0.002 * (taken - self.crowding);
        }
        self.reward = reward;
        self.least = self.least.min(reward);
        self.most = self.most.max(reward);
    }

    /// What the best action in a scene is worth.
    pub(super) fn best(&self, scene: &Scene<WORDS>, discount: f32) -> f32 {
        let worth = self.worth(scene, discount);
        worth.into_iter().fold(f32::MIN, f32::max)
    }

    /// Moves what an action in a scene is worth towards a target.
    pub(super) fn approach(
        &mut self,
        scene: &Scene<WORDS>,
        action: u8,
        target: f32,
        how: &Replaying,
    ) {
        let deed = Deed {
            scene: *scene,
            action,
        };
        let surprise = target - self.worth_of(&deed, how.discount);
        let change = bounded(Self::share(how.rate, scene) * surprise, MOST_CHANGE);
        let action = usize::from(action);
        shift(Some(&mut self.always), action, change);
        for item in scene.on.iter() {
            shift(self.items.get_mut(usize::from(item.0)), action, change);
        }
        let row = self.rows.get_mut(usize::from(scene.row));
        shift(row, action, change);
    }

    /// Keeps a share of every value: what was known is believed less.
    pub(super) fn fade(&mut self, kept: f32) {
        let items = self.items.iter_mut().chain(&mut self.rows);
        for worth in items.chain(core::iter::once(&mut self.always)) {
            for value in worth {
                *value *= kept;
            }
        }
    }

    /// All features of a deed move; together no farther than to what was felt.
    fn share(rate: f32, scene: &Scene<WORDS>) -> f32 {
        let features = 2 + scene.on.len();
        rate.min(1.0 / f32::from(features))
    }

    /// The last deed was followed by nothing.
    pub(super) fn end(&mut self, rates: &Rates) {
        self.learn(0.0, rates);
        self.count = 0;
    }

    fn learn(&mut self, follows: f32, rates: &Rates) {
        let Some(before) = self.deeds.get(usize::from(self.newest)).copied() else {
            return;
        };
        if self.count == 0 {
            return;
        }
        let surprise = self.reward + follows - self.worth_of(&before, rates.discount);
        let change = Self::share(rates.rate, &before.scene) * surprise;
        let change = bounded(change, MOST_CHANGE);
        self.spread(change, rates.discount * rates.lambda, rates.replacing);
    }

    /// Moves the values of the last deeds, the older the less.
    fn spread(&mut self, mut change: f32, fading: f32, replacing: bool) {
        let mut seen = ItemSet::EMPTY;
        for age in 0..usize::from(self.count).min(FELT) {
            let place = (usize::from(self.newest) + FELT - age) % FELT;
            let Some(deed) = self.deeds.get(place).copied() else {
                return;
            };
            let action = usize::from(deed.action);
            if age == 0 || !replacing {
                shift(Some(&mut self.always), action, change);
            }
            for item in deed.scene.on.difference(&seen).iter() {
                shift(self.items.get_mut(usize::from(item.0)), action, change);
            }
            shift(
                self.rows.get_mut(usize::from(deed.scene.row)),
                action,
                change,
            );
            if replacing {
                seen = seen.union(&deed.scene.on);
            }
            change *= fading;
        }
    }
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const ROWS: usize>
    Sarsa<WORDS, ITEMS, ACTIONS, ROWS>
{
    /// Writes what actions are worth always and where an item is on, and the ends of the rewards.
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        to.require(are_ends(self.least, self.most));
        (self.least, self.most).store(to);
        self.always.store(to);
        self.items.store(to);
    }

    /// Reads that from a robot of so many items and actions, over what is there if there is anybody.
    pub(super) fn take(
        mut into: Option<&mut Self>,
        (items, actions): (usize, usize),
        from: &mut Reader<'_>,
    ) {
        let read = |from: &mut Reader<'_>| {
            let mut worth = [0.0; ACTIONS];
            for value in worth.iter_mut().take(actions) {
                value.restore(from);
            }
            worth
        };
        let mut ends = (0.0, 0.0);
        ends.restore(from);
        from.require(are_ends(ends.0, ends.1));
        let always = read(from);
        if let Some(it) = &mut into {
            it.clear();
            (it.least, it.most) = ends;
            it.always = always;
        }
        for item in 0..items {
            let worth = read(from);
            if let Some(place) = into.as_mut().and_then(|it| it.items.get_mut(item)) {
                *place = worth;
            }
        }
    }
}

/// Whether rewards can lie between two numbers: that of an action that brought nothing, too.
fn are_ends(least: f32, most: f32) -> bool {
    (-MOST_EARNED..=0.0).contains(&least) && (0.0..=MOST_EARNED).contains(&most)
}

fn shift<const ACTIONS: usize>(worth: Option<&mut [f32; ACTIONS]>, action: usize, change: f32) {
    if let Some(worth) = worth.and_then(|worth| worth.get_mut(action)) {
        *worth += change;
    }
}

fn add<const ACTIONS: usize>(sums: &mut [f32; ACTIONS], values: Option<&[f32; ACTIONS]>) {
    if let Some(values) = values {
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += value;
        }
    }
}

stored! { impl[const WORDS: usize] Scene<WORDS> { on, row, owner } }
stored! { impl[const WORDS: usize] Deed<WORDS> { scene, action } }
stored! {
    impl[const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const ROWS: usize]
    Sarsa<WORDS, ITEMS, ACTIONS, ROWS> {
        always, items, rows, owners, crowding => up_to 1.1, deeds,
        newest if |it: &u8| usize::from(*it) < FELT,
        count if |it: &u8| usize::from(*it) <= FELT,
        reward => within MOST_EARNED,
        least if |it: &f32| *it <= 0.0 => within MOST_EARNED,
        most => up_to MOST_EARNED
    }
}

#[cfg(test)]
#[path = "sarsa_tests.rs"]
mod tests;

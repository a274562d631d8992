//! What follows what: counts of the steps that were lived, and values spread over them.
//!
//! A state is the last step (percept, action, percept, seen through the mask), as the schema that has
//! just succeeded is on level 2 of the book (6.2.4); where a state is hardly known, what is known of
//! its present percept alone speaks for it.
//! New trials weigh more than old ones, so the model follows a world that changes.
//! Rows and links lie in fixed tables; a full one gives up what was not met for longest.

use super::step::{MOST_EARNED, MOST_WORTH};
use crate::snapshot::{LARGEST_COUNT, bounded, stored};
use crate::word::Told;

/// Places in which a row may lie.
const PROBES: u32 = 8;
/// A link that is followed less often than this among its like is given up.
const FAINT: f32 = 0.01;
/// Chains that a doubt begins, and links that it passes, in the time of a unit.
const HEADS_AT_ONCE: u32 = 4;
const LINKS_AT_ONCE: u32 = 3;
/// No link, or no row.
const NONE: u16 = 0;

/// How the model learns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ModelRates {
    pub(super) discount: f32,
    /// Trials that a count remembers.
    pub(super) remembered: f32,
    /// Trials that what is known of the percept alone weighs.
    pub(super) prior: f32,
    /// The share of what really followed in what a state is worth.
    pub(super) felt: f32,
}

/// A state: a step, or a percept alone.
#[derive(Clone, Copy, Debug)]
struct Row<const ACTIONS: usize> {
    /// The hash by which it is found; 0 when the place is free.
    key: u32,
    /// The percept alone; its own key where it is that.
    percept: u32,
    worth: f32,
    /// A running mean of what really followed.
    felt: f32,
    /// The first link of each action, its place and 1.
    links: [u16; ACTIONS],
    /// What each action is worth, when this was last looked at.
    values: [f32; ACTIONS],
    met: u32,
}

impl<const ACTIONS: usize> Row<ACTIONS> {
    const FREE: Self = Self {
        key: 0,
        percept: 0,
        worth: 0.0,
        felt: 0.0,
        links: [NONE; ACTIONS],
        values: [0.0; ACTIONS],
        met: 0,
    };
}

/// A state that followed an action.
#[derive(Clone, Copy, Debug)]
struct Link {
    /// The key of what followed, 0 where the episode ended, and where it lies.
    key: u32,
    to: u16,
    /// The next link of the same state and action, or the next free one; its place and 1.
    next: u16,
    weight: f32,
    reward: f32,
}

impl Link {
    const FREE: Self = Self {
        key: 0,
        to: 0,
        next: NONE,
        weight: 0.0,
        reward: 0.0,
    };
}

/// A step as the model sees it: its own key, and that of the percept it led to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct State {
    pub(super) step: u32,
    pub(super) percept: u32,
}

/// Counts of steps, and what states are worth.
#[derive(Clone, Debug)]
pub(super) struct Model<const ACTIONS: usize, const STATES: usize, const LINKS: usize> {
    rows: [Row<ACTIONS>; STATES],
    links: [Link; LINKS],
    /// The first free link, its place and 1, and the first that was never used.
    free: u16,
    fresh: u16,
    /// Steps so far.
    clock: u32,
    /// Where the next value is brought up to date.
    at: u16,
    given_up: u32,
}

impl<const ACTIONS: usize, const STATES: usize, const LINKS: usize> Model<ACTIONS, STATES, LINKS> {
    pub(super) const fn new() -> Self {
        const {
            assert!(STATES < 65_535 && LINKS < 65_535, "places are 16 bits");
        }
        Self {
            rows: [Row::FREE; STATES],
            links: [Link::FREE; LINKS],
            free: NONE,
            fresh: 0,
            clock: 0,
            at: 0,
            given_up: 0,
        }
    }

    /// Forgets everything.
    pub(super) fn clear(&mut self) {
        for row in &mut self.rows {
            row.key = 0;
        }
        self.free = NONE;
        self.fresh = 0;
        self.at = 0;
    }

    /// How many rows or links were given up for others.
    pub(super) const fn given_up(&self) -> u32 {
        self.given_up
    }

    /// Rows and links that are in use.
    pub(super) fn filled(&self) -> (u32, u32) {
        let mut rows = 0;
        for row in &self.rows {
            rows += u32::from(row.key != 0);
        }
        let mut links = 0;
        for row in self.rows.iter().filter(|row| row.key != 0) {
            for first in row.links {
                links += self.length(first);
            }
        }
        (rows, links)
    }

    /// Links behind each other; never more than there are.
    fn length(&self, first: u16) -> u32 {
        let (mut place, mut length) = (first, 0);
        while place != NONE && (length as usize) < LINKS {
            place = self.link(place).map_or(NONE, |it| it.next);
            length += 1;
        }
        length
    }

    fn place(key: u32, probe: u32) -> usize {
        let place = (u64::from(key) * STATES as u64) >> 32;
        (place as usize + probe as usize) % STATES.max(1)
    }

    fn find(&self, key: u32) -> Option<u16> {
        if key == 0 {
            return None;
        }
        for probe in 0..PROBES {
            let place = Self::place(key, probe);
            if self.rows.get(place).is_some_and(|row| row.key == key) {
                return Some(place as u16);
            }
        }
        None
    }

    /// The place of a state, made when it is new.
    fn enter(&mut self, key: u32, percept: u32) -> u16 {
        // 0 is the key of what is free.
        let key = key.max(1);
        let mut oldest = (u32::MAX, 0);
        for probe in 0..PROBES {
            let place = Self::place(key, probe);
            let Some(row) = self.rows.get_mut(place) else {
                continue;
            };
            if row.key == key {
                row.met = self.clock;
                return place as u16;
            }
            let met = if row.key == 0 { 0 } else { row.met };
            if met < oldest.0 {
                oldest = (met, place);
            }
        }
        let place = oldest.1;
        let old = self.rows.get(place).copied().unwrap_or(Row::FREE);
        if old.key != 0 {
            self.given_up = self.given_up.wrapping_add(1);
            for first in old.links {
                self.release(first);
            }
        }
        if let Some(row) = self.rows.get_mut(place) {
            *row = Row {
                key,
                percept,
                met: self.clock,
                ..Row::FREE
            };
        }
        place as u16
    }

    fn link(&self, place: u16) -> Option<&Link> {
        self.links.get(usize::from(place.checked_sub(1)?))
    }

    fn link_mut(&mut self, place: u16) -> Option<&mut Link> {
        self.links.get_mut(usize::from(place.checked_sub(1)?))
    }

    /// Gives back a whole chain of links.
    fn release(&mut self, first: u16) {
        let mut place = first;
        for _ in 0..LINKS {
            let free = self.free;
            let Some(link) = self.link_mut(place) else {
                return;
            };
            let next = link.next;
            link.next = free;
            self.free = place;
            place = next;
        }
    }

    fn take(&mut self) -> Option<u16> {
        if let Some(link) = self.link(self.free) {
            let place = self.free;
            self.free = link.next;
            return Some(place);
        }
        if usize::from(self.fresh) < LINKS {
            self.fresh += 1;
            return Some(self.fresh);
        }
        None
    }

    /// An action in a state has led to another (`None` when the episode has ended) and brought a
    /// reward; answers whether anything was known of the action there, and whether it had led there
    /// before.
    pub(super) fn learn(
        &mut self,
        from: State,
        action: u8,
        reward: f32,
        to: Option<State>,
        rates: &ModelRates,
    ) -> Told {
        self.clock = self.clock.wrapping_add(1);
        let (key, place) = match to {
            Some(to) => (to.step, self.enter(to.step, to.percept)),
            None => (0, 0),
        };
        let percept = self.enter(from.percept, from.percept);
        let told = self.count(percept, action, (key, place), reward, rates);
        let step = self.enter(from.step, from.percept);
        self.count(step, action, (key, place), reward, rates);
        let next = self.find(key).and_then(|to| self.rows.get(usize::from(to)));
        let follows = next.map_or(0.0, |row| row.worth);
        if let Some(row) = self.rows.get_mut(usize::from(step)) {
            let felt = row.felt + 0.1 * (reward + rates.discount * follows - row.felt);
            row.felt = bounded(felt, MOST_WORTH);
        }
        self.refresh(percept, rates);
        self.refresh(step, rates);
        told
    }

    fn count(
        &mut self,
        row: u16,
        action: u8,
        (key, to): (u32, u16),
        reward: f32,
        rates: &ModelRates,
    ) -> Told {
        let head = |model: &Self| {
            let row = model.rows.get(usize::from(row));
            let first = row.and_then(|row| row.links.get(usize::from(action)).copied());
            first.unwrap_or(NONE)
        };
        let first = head(self);
        // What it was, without what is hardly followed any more.
        let kept = 1.0 - 1.0 / rates.remembered;
        let (mut place, mut before, mut found) = (first, NONE, NONE);
        let mut sum = 0.0;
        for _ in 0..LINKS {
            let Some(link) = self.link_mut(place) else {
                break;
            };
            sum += link.weight;
            place = link.next;
        }
        let fades = sum + 1.0 > rates.remembered;
        place = first;
        for _ in 0..LINKS {
            let free = self.free;
            let Some(link) = self.link_mut(place) else {
                break;
            };
            let next = link.next;
            if fades {
                link.weight *= kept;
            }
            if link.key == key {
                link.to = to;
                link.weight += 1.0;
                link.reward += (reward - link.reward) / link.weight.min(8.0);
                found = place;
                before = place;
            } else if link.weight < FAINT * sum {
                link.next = free;
                self.free = place;
                match self.link_mut(before) {
                    Some(before) => before.next = next,
                    None => self.set_head(row, action, next),
                }
            } else {
                before = place;
            }
            place = next;
        }
        let told = Told {
            foreseen: found != NONE,
            unknown: first == NONE,
        };
        if told.foreseen {
            return told;
        }
        let Some(place) = self.take() else {
            self.given_up = self.given_up.wrapping_add(1);
            self.make_room();
            return told;
        };
        let first = head(self);
        if let Some(link) = self.link_mut(place) {
            *link = Link {
                key,
                to,
                next: first,
                weight: 1.0,
                reward,
            };
        }
        self.set_head(row, action, place);
        told
    }

    fn set_head(&mut self, row: u16, action: u8, place: u16) {
        if let Some(row) = self.rows.get_mut(usize::from(row))
            && let Some(first) = row.links.get_mut(usize::from(action))
        {
            *first = place;
        }
    }

    /// Gives up the links of the state that was not met for longest among a few.
    fn make_room(&mut self) {
        let mut oldest: Option<(u32, usize)> = None;
        for step in 0..32 {
            let place = (usize::from(self.at) + step) % STATES.max(1);
            if let Some(row) = self.rows.get(place)
                && row.key != 0
                && oldest.is_none_or(|(met, _)| row.met < met)
            {
                oldest = Some((row.met, place));
            }
        }
        self.at = ((usize::from(self.at) + 32) % STATES.max(1)) as u16;
        if let Some((_, place)) = oldest
            && let Some(row) = self.rows.get_mut(place)
        {
            let links = row.links;
            row.key = 0;
            row.links = [NONE; ACTIONS];
            for first in links {
                self.release(first);
            }
        }
    }

    /// What the links of a state and action promise, summed, their weight, and how many there are.
    fn promise(&self, row: &Row<ACTIONS>, action: usize, discount: f32) -> (f32, f32, u32) {
        let (mut sum, mut weight, mut count) = (0.0, 0.0, 0);
        let mut place = row.links.get(action).copied().unwrap_or(NONE);
        for _ in 0..LINKS {
            let Some(link) = self.link(place) else {
                break;
            };
            let to = self.rows.get(usize::from(link.to));
            // A state that was given up is worth what is not known: nothing.
            let worth = to.map_or(0.0, |to| {
                if to.key == link.key && link.key != 0 {
                    to.worth
                } else {
                    0.0
                }
            });
            sum += link.weight * (link.reward + discount * worth);
            weight += link.weight;
            count += 1;
            place = link.next;
        }
        (sum, weight, count)
    }

    /// Brings what a state's actions are worth up to date; answers the units.
    fn refresh(&mut self, place: u16, rates: &ModelRates) -> u32 {
        let Some(row) = self.rows.get(usize::from(place)) else {
            return 1;
        };
        if row.key == 0 {
            return 1;
        }
        let mut units = 2;
        let is_step = row.key != row.percept;
        let prior = if is_step {
            let percept = self.find(row.percept);
            percept.and_then(|place| self.rows.get(usize::from(place)))
        } else {
            None
        };
        let mut values = [0.0; ACTIONS];
        let mut best = f32::MIN;
        for (action, value) in values.iter_mut().enumerate() {
            let (sum, weight, count) = self.promise(row, action, rates.discount);
            let says = prior.and_then(|prior| prior.values.get(action).copied());
            let believed = if is_step { rates.prior } else { 0.5 };
            let sum = sum + believed * says.unwrap_or(0.0);
            *value = bounded(sum / (weight + believed), MOST_WORTH);
            best = best.max(*value);
            units += 1 + count;
        }
        if let Some(row) = self.rows.get_mut(usize::from(place)) {
            row.values = values;
            row.worth = if is_step {
                bounded(
                    (1.0 - rates.felt) * best + rates.felt * row.felt,
                    MOST_WORTH,
                )
            } else {
                best
            };
        }
        units
    }

    /// What was counted may be of another world: it weighs no more than so many trials of an action
    /// in a state; answers the units.
    pub(super) fn doubt(&mut self, trials: f32) -> u32 {
        // Every link is in one chain at most, and is passed twice.
        let mut left = 2 * LINKS;
        for at in 0..STATES {
            let Some(row) = self.rows.get(at) else { break };
            for first in row.links {
                let (mut sum, mut place) = (0.0, first);
                while let Some(link) = self.link(place).filter(|_| left > 0) {
                    sum += link.weight;
                    place = link.next;
                    left -= 1;
                }
                if sum <= trials {
                    continue;
                }
                let kept = trials / sum;
                place = first;
                while let Some(link) = self.link_mut(place).filter(|_| left > 0) {
                    link.weight *= kept;
                    place = link.next;
                    left -= 1;
                }
            }
        }
        (STATES * ACTIONS) as u32 / HEADS_AT_ONCE + (2 * LINKS) as u32 / LINKS_AT_ONCE
    }

    /// Brings values up to date, one state after the other, for about so many units.
    pub(super) fn spread(&mut self, units: u32, rates: &ModelRates) -> u32 {
        let mut done = 0;
        for _ in 0..STATES {
            if done >= units {
                break;
            }
            self.at = if usize::from(self.at) + 1 < STATES {
                self.at + 1
            } else {
                0
            };
            done += self.refresh(self.at, rates);
        }
        done
    }

    /// What each action is worth in a state, as far as anybody knows.
    pub(super) fn values(&self, state: State) -> [f32; ACTIONS] {
        let row = self.find(state.step).or_else(|| self.find(state.percept));
        let row = row.and_then(|place| self.rows.get(usize::from(place)));
        row.map_or([0.0; ACTIONS], |row| row.values)
    }
}

stored! { impl[] State { step, percept } }
stored! { impl[] Link { key, to, next, weight => up_to LARGEST_COUNT, reward => within MOST_EARNED } }
stored! {
    impl[const ACTIONS: usize] Row<ACTIONS> {
        key, percept, worth => within MOST_WORTH, felt => within MOST_WORTH, links,
        values => within MOST_WORTH, met
    }
}
stored! {
    impl[const ACTIONS: usize, const STATES: usize, const LINKS: usize]
    Model<ACTIONS, STATES, LINKS> { rows, links, free, fresh, clock, at, given_up }
}

impl<const ACTIONS: usize, const STATES: usize, const LINKS: usize> Model<ACTIONS, STATES, LINKS> {
    /// Begins anew when its lists cannot be so; answers how many things could not.
    pub(super) fn audit(&mut self) -> u32 {
        let mut mended = 0;
        if usize::from(self.at) >= STATES {
            self.at = 0;
            mended += 1;
        }
        if !self.is_sound() {
            self.clear();
            mended += 1;
        }
        mended
    }

    /// Whether each link that was ever used stands in one list, once.
    fn is_sound(&self) -> bool {
        if usize::from(self.fresh) > LINKS {
            return false;
        }
        let lived = self.rows.iter().filter(|row| row.key != 0);
        let heads = lived.flat_map(|row| row.links);
        let mut left = self.fresh;
        for first in heads.chain([self.free]) {
            let mut place = first;
            while place != NONE {
                let (Some(link), Some(fewer)) = (self.link(place), left.checked_sub(1)) else {
                    return false;
                };
                if place > self.fresh {
                    return false;
                }
                (left, place) = (fewer, link.next);
            }
        }
        left == 0
    }
}

#[cfg(test)]
#[path = "model_tests.rs"]
mod tests;

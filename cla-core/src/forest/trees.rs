//! The forest: a few members that each hold a context tree for every action, and one that grows.
//!
//! What an action is worth is the mean of the members.
//! Work goes round: targets for all samples are made anew, newest first, then one member is grown
//! anew from some of them and takes the place of the oldest.

use super::budget::WorkBudget;
use super::growth::{Growth, mix};
use super::memory::{Memory, Sample};
use super::moment::Moment;
use super::relevance::Relevance;
use super::tree::{See, Trees};
use crate::snapshot::{Reader, Writer, stored, stored_codes};
use crate::word::{ItemId, ItemSet};

/// Members that speak; one more grows.
const MEMBERS: usize = 3;

/// Units of a sample's target, without what it takes to judge the moment after it.
const STEP: u32 = 8;

/// Whether the taken action was the best one as far as anybody can tell.
const CLOSE: f32 = 1.0e-6;

/// How far the future counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Horizon {
    pub(super) discount: f32,
    pub(super) lambda: f32,
}

/// What is being done.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Work {
    Rest,
    Sweep,
    Grow,
}

/// Samples, the trees that were grown from them, and what they say about items.
#[derive(Clone, Debug)]
pub(super) struct Forest<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
> {
    memory: Memory<WORDS, STRETCHES>,
    members: [Trees<ITEMS, ACTIONS, LEAVES>; MEMBERS + 1],
    growth: Growth<ITEMS, ACTIONS, STRETCHES, LEAVES>,
    relevance: Relevance<WORDS, ITEMS>,
    /// The member that grows.
    spare: u8,
    work: Work,
    /// Where the sweep is, how many samples are left to it.
    at: u16,
    left: u16,
    /// Samples since the last sweep began.
    fresh: u16,
    /// Members that were grown.
    grown: u32,
    seed: u32,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
> Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>
{
    pub(super) const fn new() -> Self {
        Self {
            memory: Memory::new(),
            members: [const { Trees::new() }; MEMBERS + 1],
            growth: Growth::new(),
            relevance: Relevance::new(),
            spare: 0,
            work: Work::Rest,
            at: 0,
            left: 0,
            fresh: 0,
            grown: 0,
            seed: 0,
        }
    }

    pub(super) fn begin(&mut self, seed: u32) {
        self.memory.clear();
        for member in &mut self.members {
            member.clear();
        }
        self.relevance.begin();
        self.spare = 0;
        self.work = Work::Rest;
        self.fresh = 0;
        self.grown = 0;
        self.seed = seed;
    }

    pub(super) const fn mask(&self) -> &ItemSet<WORDS> {
        self.relevance.mask()
    }

    pub(super) fn relevance(&self, item: ItemId) -> f32 {
        self.relevance.mean(item)
    }

    pub(super) const fn samples(&self) -> u16 {
        self.memory.len()
    }

    pub(super) const fn grown(&self) -> u32 {
        self.grown
    }

    pub(super) fn remember(&mut self, sample: Sample<WORDS>) {
        self.memory.push(sample);
        self.fresh = self.fresh.saturating_add(1);
    }

    /// What is on counts for more or less than it did: samples are worth that at once, and trees grow
    /// anew from them. Those of the old values are gone: what follows would be judged by them.
    /// Answers the least and the greatest reward that it remembers, 0 among them.
    pub(super) fn revalue(&mut self, item: ItemId, values: (f32, f32), alone: bool) -> (f32, f32) {
        let ends = self.memory.revalue(item, values, alone);
        for member in &mut self.members {
            member.clear();
        }
        self.work = Work::Rest;
        self.fresh = u16::MAX;
        ends
    }

    pub(super) const fn memory(&self) -> &Memory<WORDS, STRETCHES> {
        &self.memory
    }

    pub(super) fn interrupt(&mut self) {
        self.memory.interrupt();
    }

    pub(super) const fn doubt(&mut self) {
        self.memory.doubt();
    }

    fn live(&self) -> impl Iterator<Item = &Trees<ITEMS, ACTIONS, LEAVES>> {
        let spare = usize::from(self.spare);
        let members = self.members.iter().enumerate();
        members.filter_map(move |(at, member)| (at != spare).then_some(member))
    }

    /// What each action is worth at a moment, and the nodes that were passed.
    pub(super) fn values(&self, moment: &Moment<WORDS>) -> ([f32; ACTIONS], u32) {
        let mut values = [0.0; ACTIONS];
        let mut units = 0;
        for (action, value) in values.iter_mut().enumerate() {
            for member in self.live() {
                let (said, passed) = member.value(action as u8, moment);
                *value += said;
                units += passed;
            }
            *value *= 1.0 / MEMBERS as f32;
        }
        (values, units)
    }

    /// The contexts of an action in the newest member, and what each is worth.
    pub(super) fn visit(&self, action: u8, see: See<'_>) {
        let newest = (usize::from(self.spare) + MEMBERS) % (MEMBERS + 1);
        if let Some(member) = self.members.get(newest) {
            member.visit(action, see);
        }
    }

    pub(super) fn leaves(&self) -> u16 {
        let newest = (usize::from(self.spare) + MEMBERS) % (MEMBERS + 1);
        self.members.get(newest).map_or(0, Trees::leaves)
    }

    /// Whether there is anything to do: trees that are not grown yet, or enough that is new.
    pub(super) const fn is_pending(&self) -> bool {
        match self.work {
            Work::Rest => self.fresh >= 16 + self.memory.len() / 64,
            Work::Sweep | Work::Grow => true,
        }
    }

    /// Works as long as the budget lasts and there is something to do; answers whether the mask of
    /// items has changed.
    pub(super) fn work(
        &mut self,
        budget: &mut WorkBudget,
        horizon: Horizon,
        crowded: bool,
    ) -> bool {
        let mut changed = false;
        while !budget.is_spent() && self.is_pending() {
            match self.work {
                Work::Rest => {
                    self.fresh = 0;
                    self.left = self.memory.len();
                    self.at = self.memory.newest().unwrap_or(0);
                    self.work = Work::Sweep;
                }
                Work::Sweep => budget.spend(self.sweep(horizon)),
                Work::Grow => {
                    let Some(spare) = self.members.get_mut(usize::from(self.spare)) else {
                        return changed;
                    };
                    let (units, done) = self.growth.step(&self.memory, spare, &mut self.relevance);
                    budget.spend(units);
                    if done {
                        changed |= self.relevance.settle(crowded);
                        self.spare = self.spare.wrapping_add(1) % (MEMBERS as u8 + 1);
                        self.grown = self.grown.wrapping_add(1);
                        self.work = Work::Rest;
                    }
                }
            }
        }
        changed
    }

    /// One sample's target: its reward, and what the moment after it is worth.
    fn sweep(&mut self, horizon: Horizon) -> u32 {
        let at = self.at;
        let mut units = STEP;
        if let Some(sample) = self.memory.get(at) {
            let (reward, ends) = (sample.reward, sample.ends());
            if ends {
                self.memory.set_target(at, reward);
            } else if let Some(next) = self.memory.later(at) {
                let (worth, passed) = self.worth(next, horizon.lambda);
                units += passed;
                self.memory
                    .set_target(at, reward + horizon.discount * worth);
            }
        }
        self.left = self.left.saturating_sub(1);
        match self.memory.earlier(at) {
            Some(earlier) if self.left > 0 => self.at = earlier,
            _ => {
                self.seed = self.seed.wrapping_add(1);
                self.growth.begin(mix(self.seed));
                self.work = Work::Grow;
            }
        }
        units
    }

    /// What a moment of the memory is worth: the best action's value, mixed with what was felt
    /// where the best action was taken; where somebody else acted, what was felt.
    fn worth(&self, at: u16, lambda: f32) -> (f32, u32) {
        let Some(sample) = self.memory.get(at) else {
            return (0.0, 0);
        };
        if sample.is_watched()
            && let Some(felt) = sample.target()
        {
            return (felt, 1);
        }
        let (values, units) = self.values(&self.memory.moment(at));
        let mut best = f32::MIN;
        for value in values {
            best = best.max(value);
        }
        let taken = values.get(usize::from(sample.action)).copied();
        match sample.target() {
            Some(felt) if taken.is_some_and(|taken| taken >= best - CLOSE) => {
                ((1.0 - lambda) * best + lambda * felt, units)
            }
            _ => (best, units),
        }
    }
}

stored_codes!(Work {
    0: (Self::Rest),
    1: (Self::Sweep),
    2: (Self::Grow)
});
stored! {
    impl[
        const WORDS: usize,
        const ITEMS: usize,
        const ACTIONS: usize,
        const STRETCHES: usize,
        const LEAVES: usize
    ]
    Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES> {
        memory, members, growth, relevance, spare, work, at, left, fresh, grown, seed
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
> Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>
{
    /// Mends samples and trees; answers how many.
    pub(super) fn audit(&mut self) -> u32 {
        let mut mended = u32::from(self.memory.audit());
        for member in &mut self.members {
            mended += member.audit();
        }
        if usize::from(self.spare) > MEMBERS {
            self.spare = 0;
            mended += 1;
        }
        mended
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
> Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>
{
    /// Writes which items matter, and the samples.
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        self.relevance.carry(to);
        self.memory.carry(to);
    }

    /// Reads them from a robot of so many words, items and actions, over what is there if there is
    /// anybody, whose trees grow anew from them.
    pub(super) fn take(
        mut into: Option<&mut Self>,
        robot: (usize, usize, usize),
        from: &mut Reader<'_>,
    ) {
        if let Some(it) = &mut into {
            it.begin(it.seed);
            it.fresh = u16::MAX;
        }
        let (memory, relevance) = into.map(|it| (&mut it.memory, &mut it.relevance)).unzip();
        Relevance::take(relevance, robot, from);
        Memory::take(memory, robot, from);
    }
}

#[cfg(test)]
#[path = "trees_tests.rs"]
mod tests;

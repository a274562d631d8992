//! Trees grow anew from a part of the memory, a few units at a time.
//!
//! Best first: of all leaves of all actions the one is split whose best question takes away most
//! squared error, until none is clear or the table is full.
//! Samples may be overwritten while trees grow: what no longer belongs to a leaf is passed over.

use super::memory::{Memory, STRETCH};
use super::relevance::Relevance;
use super::step::{MOST_SQUARES, MOST_WORTH};
use super::tally::{Split, Tally};
use super::tree::{Place, Trees};
use crate::snapshot::{bounded, stored, stored_codes};

/// Samples that are looked at before the budget is asked again.
const AT_ONCE: u16 = 8;
/// Units that it takes to see whether a sample is drawn, to put it into its place, to find its
/// moment.
const SEEN: u32 = 3;
const PLACED: u32 = 4;
const FOUND: u32 = 9;
/// How many samples a parent's value counts for.
const PRIOR: f32 = 8.0;
/// The share of the samples from which a member grows, in 2³².
const DRAWN: u32 = 3_006_477_107;

/// What is being done.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Rest,
    /// How many samples each action has.
    Count,
    /// Their places in the index.
    Place,
    /// The counts of a leaf.
    Tally,
    /// The samples of a leaf in two parts.
    Part,
}

/// A leaf that may still be split, and its part of the index.
#[derive(Clone, Copy, Debug)]
struct Leaf {
    start: u16,
    len: u16,
    /// The node: a root, or a pair and which of the two.
    pair: u16,
    side: Side,
    action: u8,
    feature: u8,
    share: u8,
    /// What the node above says, and then what it says itself.
    value: f32,
    /// The squared error that its best split takes away; 0 for none.
    gain: f32,
}

#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Root,
    Yes,
    No,
}

impl Leaf {
    const ZERO: Self = Self {
        start: 0,
        len: 0,
        pair: 0,
        side: Side::Root,
        action: 0,
        feature: 0,
        share: 0,
        value: 0.0,
        gain: 0.0,
    };

    const fn place(&self) -> Place {
        match self.side {
            Side::Root => Place::Root(self.action),
            Side::Yes => Place::Yes(self.pair),
            Side::No => Place::No(self.pair),
        }
    }
}

/// The state of trees that grow.
#[derive(Clone, Debug)]
pub(super) struct Growth<
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
> {
    index: [[u16; STRETCH]; STRETCHES],
    leaves: [Leaf; LEAVES],
    tally: Tally<ITEMS, ACTIONS>,
    /// Where each action's samples begin in the index, and where the next goes.
    starts: [u16; ACTIONS],
    ends: [u16; ACTIONS],
    phase: Phase,
    /// The leaf in work, how many there are, and whether its brother is next.
    leaf: u16,
    count: u16,
    brother: bool,
    /// A place in the memory or the index, and the end of what is undecided.
    at: u16,
    end: u16,
    drawn: u16,
    sum: f32,
    seed: u32,
}

impl<const ITEMS: usize, const ACTIONS: usize, const STRETCHES: usize, const LEAVES: usize>
    Growth<ITEMS, ACTIONS, STRETCHES, LEAVES>
{
    pub(super) const fn new() -> Self {
        const {
            assert!(LEAVES >= 2 * ACTIONS, "trees have two leaves an action");
        }
        Self {
            index: [[0; STRETCH]; STRETCHES],
            leaves: [Leaf::ZERO; LEAVES],
            tally: Tally::new(),
            starts: [0; ACTIONS],
            ends: [0; ACTIONS],
            phase: Phase::Rest,
            leaf: 0,
            count: 0,
            brother: false,
            at: 0,
            end: 0,
            drawn: 0,
            sum: 0.0,
            seed: 0,
        }
    }

    /// Begins to grow trees from samples drawn by `seed`.
    pub(super) fn begin(&mut self, seed: u32) {
        self.seed = seed;
        self.phase = Phase::Count;
        self.at = 0;
        self.drawn = 0;
        self.sum = 0.0;
        self.starts = [0; ACTIONS];
        self.ends = [0; ACTIONS];
    }

    /// Goes on for a few units; answers how many, and whether the trees are grown.
    pub(super) fn step<const WORDS: usize>(
        &mut self,
        memory: &Memory<WORDS, STRETCHES>,
        trees: &mut Trees<ITEMS, ACTIONS, LEAVES>,
        relevance: &mut Relevance<WORDS, ITEMS>,
    ) -> (u32, bool) {
        match self.phase {
            Phase::Rest => (1, true),
            Phase::Count => (self.count_some(memory), false),
            Phase::Place => (self.place_some(memory, trees), false),
            Phase::Tally => self.tally_some(memory, trees, relevance),
            Phase::Part => (self.part_some(memory, trees), false),
        }
    }

    fn is_drawn(&self, at: u16) -> bool {
        mix(u32::from(at) ^ self.seed) < DRAWN
    }

    fn count_some<const WORDS: usize>(&mut self, memory: &Memory<WORDS, STRETCHES>) -> u32 {
        for _ in 0..AT_ONCE {
            let Some(sample) = memory.get(self.at) else {
                let mut next = 0;
                for (start, end) in self.starts.iter_mut().zip(&mut self.ends) {
                    let count = *end;
                    *start = next;
                    *end = next;
                    next = next.wrapping_add(count);
                }
                self.phase = Phase::Place;
                self.at = 0;
                return SEEN * u32::from(AT_ONCE);
            };
            if self.is_drawn(self.at)
                && let Some(target) = sample.target()
                && let Some(count) = self.ends.get_mut(usize::from(sample.action))
            {
                *count = count.wrapping_add(1);
                self.drawn = self.drawn.wrapping_add(1);
                self.sum += target;
            }
            self.at = self.at.wrapping_add(1);
        }
        SEEN * u32::from(AT_ONCE)
    }

    fn place_some<const WORDS: usize>(
        &mut self,
        memory: &Memory<WORDS, STRETCHES>,
        trees: &mut Trees<ITEMS, ACTIONS, LEAVES>,
    ) -> u32 {
        for _ in 0..AT_ONCE {
            let Some(sample) = memory.get(self.at) else {
                self.plant(trees);
                break;
            };
            let action = usize::from(sample.action);
            if self.is_drawn(self.at) && sample.target().is_some() {
                let limit = self.starts.get(action + 1).copied().unwrap_or(self.drawn);
                if let Some(end) = self.ends.get_mut(action)
                    && *end < limit
                {
                    let place = *end;
                    *end += 1;
                    self.set_index(place, self.at);
                }
            }
            self.at = self.at.wrapping_add(1);
        }
        PLACED * u32::from(AT_ONCE)
    }

    /// A root for each action, all of which say the mean of all.
    fn plant(&mut self, trees: &mut Trees<ITEMS, ACTIONS, LEAVES>) {
        let value = if self.drawn > 0 {
            bounded(self.sum / f32::from(self.drawn), MOST_WORTH)
        } else {
            0.0
        };
        trees.clear();
        let bounds = self.starts.iter().zip(&self.ends);
        for (action, (leaf, (start, end))) in self.leaves.iter_mut().zip(bounds).enumerate() {
            *leaf = Leaf {
                start: *start,
                len: end.saturating_sub(*start),
                action: action as u8,
                value,
                ..Leaf::ZERO
            };
        }
        self.count = ACTIONS as u16;
        self.brother = false;
        self.begin_tally(0);
    }

    fn begin_tally(&mut self, leaf: u16) {
        self.leaf = leaf;
        self.at = 0;
        self.tally.clear();
        self.phase = Phase::Tally;
    }

    fn leaf_in_work(&self) -> Leaf {
        let leaf = self.leaves.get(usize::from(self.leaf));
        leaf.copied().unwrap_or(Leaf::ZERO)
    }

    fn tally_some<const WORDS: usize>(
        &mut self,
        memory: &Memory<WORDS, STRETCHES>,
        trees: &mut Trees<ITEMS, ACTIONS, LEAVES>,
        relevance: &mut Relevance<WORDS, ITEMS>,
    ) -> (u32, bool) {
        let leaf = self.leaf_in_work();
        let mut units = 0;
        for _ in 0..AT_ONCE {
            if self.at >= leaf.len {
                units += 4 * (2 * ITEMS + ACTIONS) as u32;
                return (units, self.judge(leaf, trees, relevance));
            }
            let at = self.index_at(leaf.start.wrapping_add(self.at));
            self.at = self.at.wrapping_add(1);
            units += FOUND;
            if let Some(sample) = memory.get(at)
                && sample.action == leaf.action
                && let Some(target) = sample.target()
            {
                units += self.tally.add(
                    &memory.moment(at),
                    target - leaf.value,
                    memory.is_recent(at),
                );
            }
        }
        (units, false)
    }

    /// A leaf has its counts: it says what they say, and knows its best split; answers whether the
    /// trees are grown.
    fn judge<const WORDS: usize>(
        &mut self,
        mut leaf: Leaf,
        trees: &mut Trees<ITEMS, ACTIONS, LEAVES>,
        relevance: &mut Relevance<WORDS, ITEMS>,
    ) -> bool {
        leaf.value = bounded(leaf.value + self.tally.shift(PRIOR), MOST_WORTH);
        trees.settle(leaf.place(), leaf.value);
        let is_root = leaf.side == Side::Root;
        leaf.gain = 0.0;
        if let Some(Split {
            gain,
            feature,
            share,
        }) = self.tally.best(is_root, relevance)
        {
            leaf.gain = gain;
            leaf.feature = feature;
            leaf.share = share;
        }
        if let Some(place) = self.leaves.get_mut(usize::from(self.leaf)) {
            *place = leaf;
        }
        if is_root && usize::from(self.leaf) + 1 < ACTIONS {
            self.begin_tally(self.leaf.wrapping_add(1));
            return false;
        }
        if self.brother {
            self.brother = false;
            // The brother was entered last.
            self.begin_tally(self.count.saturating_sub(1));
            return false;
        }
        self.pick(trees)
    }

    /// The leaf whose split takes away most; ties go to the first.
    fn pick(&mut self, trees: &Trees<ITEMS, ACTIONS, LEAVES>) -> bool {
        let mut best = (0.0, None);
        let leaves = self.leaves.iter().take(usize::from(self.count));
        for (at, leaf) in leaves.enumerate() {
            if leaf.gain > best.0 {
                best = (leaf.gain, Some((at as u16, leaf.start, leaf.len)));
            }
        }
        let full = usize::from(self.count) >= LEAVES || !trees.has_room();
        match best.1 {
            Some((leaf, start, len)) if !full => {
                self.leaf = leaf;
                self.at = start;
                self.end = start.wrapping_add(len);
                self.phase = Phase::Part;
                false
            }
            _ => {
                self.phase = Phase::Rest;
                true
            }
        }
    }

    /// Samples that answer yes come first; who does not know goes by lot.
    fn part_some<const WORDS: usize>(
        &mut self,
        memory: &Memory<WORDS, STRETCHES>,
        trees: &mut Trees<ITEMS, ACTIONS, LEAVES>,
    ) -> u32 {
        let leaf = self.leaf_in_work();
        for _ in 0..AT_ONCE {
            if self.at >= self.end {
                self.divide(leaf, trees);
                return FOUND * u32::from(AT_ONCE) + u32::from(self.count) / 2;
            }
            let at = self.index_at(self.at);
            let yes = match memory.moment(at).holds::<ITEMS>(leaf.feature) {
                Some(yes) => yes,
                None => {
                    let lot = mix(u32::from(at) ^ u32::from(leaf.feature) << 20 ^ self.seed);
                    lot >> 24 <= u32::from(leaf.share)
                }
            };
            if yes {
                self.at += 1;
            } else {
                self.end -= 1;
                let other = self.index_at(self.end);
                self.set_index(self.end, at);
                self.set_index(self.at, other);
            }
        }
        FOUND * u32::from(AT_ONCE)
    }

    /// Two leaves in the place of one.
    fn divide(&mut self, leaf: Leaf, trees: &mut Trees<ITEMS, ACTIONS, LEAVES>) {
        let Some(pair) = trees.split(leaf.place(), leaf.feature, leaf.share) else {
            self.phase = Phase::Rest;
            return;
        };
        let yes = self.at.wrapping_sub(leaf.start);
        let kid = |side, start, len| Leaf {
            start,
            len,
            pair,
            side,
            gain: 0.0,
            ..leaf
        };
        if let Some(place) = self.leaves.get_mut(usize::from(self.leaf)) {
            *place = kid(Side::Yes, leaf.start, yes);
        }
        if let Some(place) = self.leaves.get_mut(usize::from(self.count)) {
            *place = kid(Side::No, self.at, leaf.len.wrapping_sub(yes));
            self.count = self.count.wrapping_add(1);
            self.brother = true;
        }
        self.begin_tally(self.leaf);
    }

    fn index_at(&self, at: u16) -> u16 {
        let at = usize::from(at);
        let found = self.index.get(at / STRETCH);
        found
            .and_then(|stretch| stretch.get(at % STRETCH))
            .copied()
            .unwrap_or(0)
    }

    fn set_index(&mut self, at: u16, sample: u16) {
        let at = usize::from(at);
        if let Some(place) = self
            .index
            .get_mut(at / STRETCH)
            .and_then(|stretch| stretch.get_mut(at % STRETCH))
        {
            *place = sample;
        }
    }
}

/// Bits that look random, from bits that do not.
pub(super) const fn mix(x: u32) -> u32 {
    let x = x.wrapping_mul(0x9E37_79B1);
    let x = x ^ (x >> 15);
    let x = x.wrapping_mul(0x85EB_CA77);
    let x = x ^ (x >> 13);
    let x = x.wrapping_mul(0xC2B2_AE3D);
    x ^ (x >> 16)
}

stored_codes!(Phase {
    0: (Self::Rest),
    1: (Self::Count),
    2: (Self::Place),
    3: (Self::Tally),
    4: (Self::Part),
});
stored_codes!(Side {
    0: (Self::Root),
    1: (Self::Yes),
    2: (Self::No)
});
stored! {
    impl[] Leaf {
        start, len, pair, side, action, feature, share, value => within MOST_WORTH,
        gain => up_to MOST_SQUARES
    }
}
stored! {
    impl[const ITEMS: usize, const ACTIONS: usize, const STRETCHES: usize, const LEAVES: usize]
    Growth<ITEMS, ACTIONS, STRETCHES, LEAVES> {
        index, leaves, tally, starts, ends, phase, leaf, count, brother, at, end, drawn, sum, seed
    }
}

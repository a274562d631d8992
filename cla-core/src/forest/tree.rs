//! Context trees: for each action a tree of questions, whose leaves say what the action is worth.
//!
//! The path to a leaf is a context that says no more than it must, so a leaf is a simple schema's
//! left side (book, 5.1.1; McCallum 1996, U-Tree).
//! Where the answer to a question is unknown both branches are taken, each as much as samples took
//! it: an unknown item costs what it was worth.

use super::moment::Moment;
use super::step::MOST_WORTH;
use crate::snapshot::stored;

/// A node that asks nothing.
const LEAF: u8 = u8::MAX;

/// Branches that a descent keeps for later; beyond these it takes the likelier one only.
const OPEN: usize = 16;

/// Units that a descent takes before its first node.
const BEGUN: u32 = 3;

/// A question, or what a leaf says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// What the action is worth here.
    value: f32,
    /// The pair of nodes below: yes, then no.
    kids: u16,
    /// What it asks, or [`LEAF`].
    feature: u8,
    /// The share of the samples that answered yes, in 1/256.
    share: u8,
}

impl Node {
    const ZERO: Self = Self {
        value: 0.0,
        kids: 0,
        feature: 0,
        share: 0,
    };

    const fn leaf(value: f32) -> Self {
        Self {
            value,
            kids: 0,
            feature: LEAF,
            share: 0,
        }
    }
}

/// Which node: a root, or one of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// The root of this action.
    Root(u8),
    /// The kid of this pair for yes.
    Yes(u16),
    /// The kid of this pair for no.
    No(u16),
}

/// One tree for each action.
#[derive(Clone, Debug)]
pub(super) struct Trees<const ITEMS: usize, const ACTIONS: usize, const LEAVES: usize> {
    roots: [Node; ACTIONS],
    pairs: [[Node; 2]; LEAVES],
    /// Pairs in use.
    used: u16,
}

impl<const ITEMS: usize, const ACTIONS: usize, const LEAVES: usize> Trees<ITEMS, ACTIONS, LEAVES> {
    pub(super) const fn new() -> Self {
        Self {
            roots: [Node::ZERO; ACTIONS],
            pairs: [[Node::ZERO; 2]; LEAVES],
            used: 0,
        }
    }

    /// A leaf for each action that says 0.
    pub(super) fn clear(&mut self) {
        self.roots = [Node::leaf(0.0); ACTIONS];
        self.used = 0;
    }

    /// Leaves of all actions.
    pub(super) const fn leaves(&self) -> u16 {
        self.used.saturating_add(ACTIONS as u16)
    }

    fn node(&self, place: Place) -> Node {
        let found = match place {
            Place::Root(action) => self.roots.get(usize::from(action)),
            Place::Yes(pair) => self.pairs.get(usize::from(pair)).map(|[yes, _]| yes),
            Place::No(pair) => self.pairs.get(usize::from(pair)).map(|[_, no]| no),
        };
        found.copied().unwrap_or(Node::leaf(0.0))
    }

    fn node_mut(&mut self, place: Place) -> Option<&mut Node> {
        match place {
            Place::Root(action) => self.roots.get_mut(usize::from(action)),
            Place::Yes(pair) => self.pairs.get_mut(usize::from(pair)).map(|[yes, _]| yes),
            Place::No(pair) => self.pairs.get_mut(usize::from(pair)).map(|[_, no]| no),
        }
    }

    /// Makes a node a leaf that says this.
    pub(super) fn settle(&mut self, place: Place, value: f32) {
        if let Some(node) = self.node_mut(place) {
            *node = Node::leaf(value);
        }
    }

    /// Whether another leaf can be split.
    pub(super) const fn has_room(&self) -> bool {
        (self.used as usize) < LEAVES
    }

    /// Makes a leaf ask a question; answers the pair below it, or `None` when there is no room.
    pub(super) fn split(&mut self, place: Place, feature: u8, share: u8) -> Option<u16> {
        let pair = self.used;
        let value = self.node(place).value;
        *self.pairs.get_mut(usize::from(pair))? = [Node::leaf(value); 2];
        let node = self.node_mut(place)?;
        node.kids = pair;
        node.feature = feature;
        node.share = share;
        self.used += 1;
        Some(pair)
    }

    /// What an action is worth at a moment, and the units that it took to say so.
    pub(super) fn value<const WORDS: usize>(
        &self,
        action: u8,
        moment: &Moment<WORDS>,
    ) -> (f32, u32) {
        let mut node = self.node(Place::Root(action));
        let mut open = [(0_u16, 0.0_f32); OPEN];
        let mut kept = 0;
        let (mut weight, mut sum, mut passed) = (1.0, 0.0, BEGUN);
        // Every node is passed at most once, so this ends.
        for _ in 0..=2 * LEAVES {
            passed += 1;
            if node.feature == LEAF {
                sum += weight * node.value;
                if kept == 0 {
                    break;
                }
                kept -= 1;
                let (pair, later) = open.get(kept).copied().unwrap_or((0, 0.0));
                weight = later;
                node = self.node(Place::No(pair));
                continue;
            }
            let yes = match moment.holds::<ITEMS>(node.feature) {
                Some(yes) => yes,
                None => {
                    let share = (f32::from(node.share) + 0.5) * (1.0 / 256.0);
                    if let Some(place) = open.get_mut(kept) {
                        *place = (node.kids, weight * (1.0 - share));
                        kept += 1;
                        weight *= share;
                        true
                    } else {
                        share >= 0.5
                    }
                }
            };
            let pair = node.kids;
            node = self.node(if yes {
                Place::Yes(pair)
            } else {
                Place::No(pair)
            });
        }
        (sum, passed)
    }

    /// The contexts of an action's leaves, with what each says, in the order of the tree.
    pub(super) fn visit(&self, action: u8, see: See<'_>) {
        let mut path = [(0_u8, false); DEEP];
        // Every node is passed at most once, whatever its answers lead to.
        let mut left = 2 * LEAVES + 1;
        self.walk(Place::Root(action), &mut path, 0, &mut left, see);
    }

    fn walk(
        &self,
        place: Place,
        path: &mut [(u8, bool); DEEP],
        depth: usize,
        left: &mut usize,
        see: See<'_>,
    ) {
        let Some(fewer) = left.checked_sub(1) else {
            return;
        };
        *left = fewer;
        let node = self.node(place);
        if node.feature == LEAF || depth >= DEEP {
            see(path.get(..depth).unwrap_or(&[]), node.value);
            return;
        }
        for (yes, kid) in [(true, Place::Yes(node.kids)), (false, Place::No(node.kids))] {
            if let Some(step) = path.get_mut(depth) {
                *step = (node.feature, yes);
            }
            self.walk(kid, path, depth + 1, left, see);
        }
    }
}

/// The longest context that is shown to people; what is deeper is shown as one leaf.
pub(super) const DEEP: usize = 24;

/// Who is shown contexts: features and whether they hold, and what the action is worth there.
pub(super) type See<'a> = &'a mut dyn FnMut(&[(u8, bool)], f32);

stored! { impl[] Node { value => within MOST_WORTH, kids, feature, share } }
stored! {
    impl[const ITEMS: usize, const ACTIONS: usize, const LEAVES: usize]
    Trees<ITEMS, ACTIONS, LEAVES> { roots, pairs, used }
}

impl<const ITEMS: usize, const ACTIONS: usize, const LEAVES: usize> Trees<ITEMS, ACTIONS, LEAVES> {
    /// Makes questions that are none, and those whose answers lead nowhere, leaves; answers how many.
    pub(super) fn audit(&mut self) -> u32 {
        let mut mended = 0;
        let full = usize::from(self.used) > LEAVES;
        if full {
            self.used = LEAVES as u16;
            mended += 1;
        }
        let features = 2 * ITEMS + ACTIONS;
        for node in self.roots.iter_mut().chain(self.pairs.as_flattened_mut()) {
            let asks = usize::from(node.feature) < features && usize::from(node.kids) < LEAVES;
            if node.feature != LEAF && !asks {
                *node = Node::leaf(node.value);
                mended += 1;
            }
        }
        mended
    }
}

#[cfg(test)]
#[path = "tree_tests.rs"]
mod tests;

//! Imagined states: what each action leads to, predicted by schemas or lived through.
//!
//! States that were perceived and states that schemas predict are nodes of a graph; what they are
//! worth and how far a goal is goes back along its links, some nodes a tick.
//! So a plan is never searched for anew: whoever stands in a state reads its best action there
//! (book, 5.1.1; in the field: value iteration on a learned model, as in Dyna).
//! A full graph forgets what was only imagined, and begins anew when that is not enough.

use crate::word::{ItemSet, SignedItems};

/// A link to a state that cannot be, or that found no place.
const REFUSED: u16 = u16::MAX;
/// A goal that is farther cannot be reached, as far as anybody knows.
pub(super) const NEVER: u8 = u8::MAX;
/// The most actions to a goal.
const FARTHEST: u8 = 100;

/// It was perceived.
const VISITED: u8 = 1;
/// What arriving here brings was felt.
const FELT: u8 = 2;

/// One state.
#[derive(Clone, Copy, Debug)]
struct Node<const WORDS: usize, const ACTIONS: usize> {
    on: ItemSet<WORDS>,
    /// For each action the node that it leads to, and one more; 0 is unknown.
    links: [u16; ACTIONS],
    /// The actions whose link was lived through, as bits.
    lived: u32,
    /// The actions that once led elsewhere, as bits.
    doubted: u32,
    /// What arriving here brings, and what may be had from here on.
    worth: f32,
    value: f32,
    /// The next node with the same hash, and one more.
    next: u16,
    /// Actions to the goal.
    distance: u8,
    marks: u8,
}

impl<const WORDS: usize, const ACTIONS: usize> Node<WORDS, ACTIONS> {
    const fn was_visited(&self) -> bool {
        self.marks & VISITED != 0
    }
}

/// A graph of at most `NODES` states.
#[derive(Clone, Debug)]
pub(super) struct Imagined<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const NODES: usize,
> {
    nodes: [Node<WORDS, ACTIONS>; NODES],
    /// For each hash its first node, and one more.
    buckets: [u16; NODES],
    len: u16,
    /// For each item, the items that were on together with it.
    together: [ItemSet<WORDS>; ITEMS],
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const NODES: usize>
    Imagined<WORDS, ITEMS, ACTIONS, NODES>
{
    pub(super) const fn new() -> Self {
        const {
            assert!(ITEMS <= WORDS * 32, "an item needs a bit: 32 for each word");
            assert!(
                NODES > 1 && NODES < u16::MAX as usize - 1,
                "2 to 65,533 imagined states"
            );
            assert!(ACTIONS > 0 && ACTIONS <= 32, "a robot has 1 to 32 actions");
        }
        Self {
            nodes: [Node {
                on: ItemSet::EMPTY,
                links: [0; ACTIONS],
                lived: 0,
                doubted: 0,
                worth: 0.0,
                value: 0.0,
                next: 0,
                distance: 0,
                marks: 0,
            }; NODES],
            buckets: [0; NODES],
            len: 0,
            together: [ItemSet::EMPTY; ITEMS],
        }
    }

    pub(super) fn clear(&mut self) {
        self.forget();
        self.together = [ItemSet::EMPTY; ITEMS];
    }

    fn forget(&mut self) {
        self.len = 0;
        self.buckets = [0; NODES];
    }

    pub(super) const fn len(&self) -> u16 {
        self.len
    }

    fn node(&self, at: u16) -> Option<&Node<WORDS, ACTIONS>> {
        (at < self.len).then_some(())?;
        self.nodes.get(usize::from(at))
    }

    fn node_mut(&mut self, at: u16) -> Option<&mut Node<WORDS, ACTIONS>> {
        (at < self.len).then_some(())?;
        self.nodes.get_mut(usize::from(at))
    }

    /// The items that are on in a state.
    pub(super) fn on(&self, at: u16) -> Option<&ItemSet<WORDS>> {
        self.node(at).map(|node| &node.on)
    }

    fn bucket(on: &ItemSet<WORDS>) -> usize {
        let mut hash = 0x811C_9DC5_u32;
        for word in on.words() {
            hash = (hash ^ word).wrapping_mul(0x0100_0193);
            hash ^= hash >> 15;
        }
        hash as usize % NODES
    }

    /// The node of a state.
    pub(super) fn find(&self, on: &ItemSet<WORDS>) -> Option<u16> {
        let mut at = self.buckets.get(Self::bucket(on)).copied()?;
        // A chain has at most as many nodes as there are.
        for _ in 0..NODES {
            let here = at.checked_sub(1)?;
            let node = self.node(here)?;
            if node.on == *on {
                return Some(here);
            }
            at = node.next;
        }
        None
    }

    /// The node of a state, which is made when there is room.
    fn intern(&mut self, on: &ItemSet<WORDS>, worth: f32) -> Option<u16> {
        if let Some(at) = self.find(on) {
            return Some(at);
        }
        let at = self.len;
        let bucket = self.buckets.get_mut(Self::bucket(on))?;
        let node = self.nodes.get_mut(usize::from(at))?;
        *node = Node {
            on: *on,
            links: [0; ACTIONS],
            lived: 0,
            doubted: 0,
            worth,
            value: 0.0,
            next: *bucket,
            distance: NEVER,
            marks: 0,
        };
        *bucket = at + 1;
        self.len += 1;
        Some(at)
    }

    /// The node of a state that is perceived, worth so much as far as anybody can tell.
    ///
    /// A full graph makes room.
    pub(super) fn visit(&mut self, on: &ItemSet<WORDS>, worth: f32) -> u16 {
        for item in on.iter() {
            if let Some(row) = self.together.get_mut(usize::from(item.0)) {
                *row = row.union(on);
            }
        }
        let at = self.intern(on, worth).or_else(|| {
            self.make_room();
            self.intern(on, worth)
        });
        let at = at.unwrap_or(0);
        if let Some(node) = self.node_mut(at) {
            node.marks |= VISITED;
        }
        at
    }

    /// What arriving in a state has brought.
    pub(super) fn feel(&mut self, at: u16, worth: f32) {
        if let Some(node) = self.node_mut(at) {
            let share = if node.marks & FELT != 0 { 0.25 } else { 1.0 };
            node.worth += share * (worth - node.worth);
            node.marks |= FELT;
        }
    }

    /// Keeps the states that were perceived, or none when those alone fill it.
    fn make_room(&mut self) {
        let mut kept = 0;
        for at in 0..self.len {
            if let Some(node) = self.node_mut(at)
                && node.was_visited()
            {
                kept += 1;
                // Where it goes, and one more.
                node.next = kept;
            }
        }
        if usize::from(kept) >= NODES {
            self.forget();
            return;
        }
        for at in 0..self.len {
            let Some(mut node) = self.node(at).copied() else {
                continue;
            };
            for (action, link) in node.links.iter_mut().enumerate() {
                let target = link.checked_sub(1).and_then(|to| self.moved(to));
                match target {
                    Some(to) => *link = to,
                    None => {
                        *link = 0;
                        node.lived &= !(1 << action);
                    }
                }
            }
            if let Some(node_mut) = self.node_mut(at) {
                *node_mut = node;
            }
        }
        self.buckets = [0; NODES];
        let all = self.len;
        self.len = kept;
        for at in 0..all {
            let Some(mut node) = self.nodes.get(usize::from(at)).copied() else {
                continue;
            };
            if !node.was_visited() {
                continue;
            }
            let to = node.next;
            if let Some(bucket) = self.buckets.get_mut(Self::bucket(&node.on)) {
                node.next = *bucket;
                *bucket = to;
            }
            let place = self.nodes.get_mut(usize::from(to.saturating_sub(1)));
            if let Some(place) = place {
                *place = node;
            }
        }
    }

    /// While room is made: where a node that is kept goes, and one more.
    fn moved(&self, at: u16) -> Option<u16> {
        let node = self.node(at)?;
        node.was_visited().then_some(node.next)
    }

    /// Whether all items of a state were seen together, two by two.
    fn plausible(&self, on: &ItemSet<WORDS>) -> bool {
        on.iter().all(|item| {
            let row = self.together.get(usize::from(item.0));
            row.is_some_and(|row| on.is_subset(row))
        })
    }

    /// Whether nobody knows yet what an action does in a state.
    pub(super) fn is_open(&self, at: u16, action: u8) -> bool {
        let link = self.link(at, action);
        link == Some(0)
    }

    fn link(&self, at: u16, action: u8) -> Option<u16> {
        self.node(at)?.links.get(usize::from(action)).copied()
    }

    fn set_link(&mut self, at: u16, action: u8, to: u16) -> bool {
        let Some(node) = self.node_mut(at) else {
            return false;
        };
        let Some(link) = node.links.get_mut(usize::from(action)) else {
            return false;
        };
        let changed = *link != to;
        *link = to;
        changed
    }

    /// Whether an action led where it was foreseen to lead; `None` where nothing was foreseen.
    pub(super) fn kept(&self, from: u16, action: u8, to: u16) -> Option<bool> {
        let link = self.link(from, action)?;
        (link != 0).then_some(link == to + 1)
    }

    /// The states that were lived through: an action led from one to the other. Where it does not
    /// always do the same, what was predicted is given up only after the second time.
    pub(super) fn live(&mut self, from: u16, action: u8, to: u16, exact: bool) -> bool {
        let bit = 1_u32 << (action & 31);
        let same = self.link(from, action) == Some(to + 1);
        let Some(node) = self.node_mut(from) else {
            return false;
        };
        if same {
            node.doubted &= !bit;
            node.lived |= bit;
            return false;
        }
        if !exact && node.doubted & bit == 0 {
            node.doubted |= bit;
            return false;
        }
        node.doubted &= !bit;
        node.lived |= bit;
        self.set_link(from, action, to + 1)
    }

    /// Whether the link of an action was lived through.
    pub(super) fn was_lived(&self, at: u16, action: u8) -> bool {
        let bit = 1_u32 << (action & 31);
        self.node(at).is_some_and(|node| node.lived & bit != 0)
    }

    /// An action is predicted to lead to a state with these items on, worth so much; answers whether
    /// that is news. What was lived through stays.
    pub(super) fn foresee(
        &mut self,
        from: u16,
        action: u8,
        on: &ItemSet<WORDS>,
        worth: f32,
    ) -> bool {
        if self.was_lived(from, action) {
            return false;
        }
        let to = if self.on(from) == Some(on) {
            Some(from)
        } else if self.plausible(on) {
            self.intern(on, worth)
        } else {
            None
        };
        self.set_link(from, action, to.map_or(REFUSED, |to| to + 1))
    }

    /// Brings one state up to date with those around it; answers whether that changed it.
    pub(super) fn sweep(
        &mut self,
        at: u16,
        goal: Option<&SignedItems<WORDS>>,
        discount: f32,
    ) -> bool {
        let Some(node) = self.node(at) else {
            return false;
        };
        let mut value: Option<f32> = None;
        let mut distance = NEVER;
        for link in &node.links {
            let to = link.checked_sub(1).and_then(|to| self.node(to));
            if let Some(to) = to {
                let had = to.worth + discount * to.value;
                value = Some(value.map_or(had, |best| best.max(had)));
                distance = distance.min(to.distance);
            }
        }
        distance = match goal {
            Some(goal) if holds(goal, &node.on) => 0,
            // What it relied on has gone: those that rely on it shall see that before it looks for
            // another way, or all of them would count up together.
            Some(_) if distance >= node.distance && node.distance != NEVER => NEVER,
            Some(_) if distance < FARTHEST => distance + 1,
            _ => NEVER,
        };
        let value = value.unwrap_or(0.0);
        let near = (value - node.value).abs() <= 1e-3 * (1.0 + value.abs());
        let changed = !near || distance != node.distance;
        if let Some(node) = self.node_mut(at) {
            node.value = value;
            node.distance = distance;
        }
        changed
    }

    /// A new goal: nobody knows how far it is.
    pub(super) fn lose_sight(&mut self) {
        for at in 0..self.len {
            if let Some(node) = self.node_mut(at) {
                node.distance = NEVER;
            }
        }
    }

    /// What each action is worth in a state; `None` for those of which nothing is known.
    pub(super) fn values(&self, at: u16, discount: f32) -> [Option<f32>; ACTIONS] {
        let mut values = [None; ACTIONS];
        if let Some(node) = self.node(at) {
            for (value, link) in values.iter_mut().zip(node.links) {
                let to = link.checked_sub(1).and_then(|to| self.node(to));
                *value = to.map(|to| to.worth + discount * to.value);
            }
        }
        values
    }

    /// How far a goal is after each action in a state.
    pub(super) fn distances(&self, at: u16) -> [u8; ACTIONS] {
        let mut distances = [NEVER; ACTIONS];
        if let Some(node) = self.node(at) {
            for (distance, link) in distances.iter_mut().zip(node.links) {
                let to = link.checked_sub(1).and_then(|to| self.node(to));
                *distance = to.map_or(NEVER, |to| to.distance);
            }
        }
        distances
    }
}

fn holds<const WORDS: usize>(goal: &SignedItems<WORDS>, on: &ItemSet<WORDS>) -> bool {
    goal.positive().is_subset(on) && goal.negative().is_disjoint(on)
}

#[cfg(test)]
#[path = "imagined_tests.rs"]
mod tests;

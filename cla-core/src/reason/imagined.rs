//! Imagined states: what each action leads to, predicted by schemas or lived through.
//!
//! States that were perceived and states that schemas predict are nodes of a graph; what they are
//! worth and how far a goal is goes back along its links, some nodes a tick.
//! So a plan is never searched for anew: whoever stands in a state reads its best action there
//! (book, 5.1.1; in the field: value iteration on a learned model, as in Dyna).
//! A full graph forgets, some states a tick, what was only imagined, and begins anew when that is not
//! enough.

use crate::snapshot::{bounded, stored, stored_codes};
use crate::word::{ItemId, ItemSet, SignedItems};

/// A link to a state that cannot be, or that found no place.
const REFUSED: u16 = u16::MAX;
/// A goal that is farther cannot be reached, as far as anybody knows.
pub(super) const NEVER: u8 = u8::MAX;
/// The most actions to a goal.
const FARTHEST: u8 = 100;

/// The most that arriving in a state brings: a million for each of up to 255 items.
const MOST_WORTH: f32 = 256.0e6;
/// The most that may be had from there on, discounted by .95, and what rounding adds.
const MOST_VALUE: f32 = 1.0e10;

/// It was perceived.
const VISITED: u8 = 1;
/// What arriving here brings was felt.
const FELT: u8 = 2;
/// It was given up, and its place waits for another.
const FREE: u8 = 4;

/// How room is made for states that were perceived: what was only imagined leaves, a part at a time.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Room {
    /// There is some, or nobody asked.
    Enough,
    /// Links to what leaves are cut.
    Cutting,
    /// Places are given back.
    Clearing,
}

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

    const fn is_free(&self) -> bool {
        self.marks & FREE != 0
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
    /// The first free place, and one more, and how many there are.
    free: u16,
    vacant: u16,
    room: Room,
    /// The next state to make room with.
    at: u16,
    /// For each item, the items that were on together with it.
    together: [ItemSet<WORDS>; ITEMS],
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const NODES: usize>
    Imagined<WORDS, ITEMS, ACTIONS, NODES>
{
    /// Places that are kept for what is perceived; when half of them is taken room is made.
    const RESERVE: usize = NODES / 16;

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
            free: 0,
            vacant: 0,
            room: Room::Enough,
            at: 0,
            together: [ItemSet::EMPTY; ITEMS],
        }
    }

    pub(super) fn clear(&mut self) {
        self.forget();
        self.together = [ItemSet::EMPTY; ITEMS];
    }

    fn forget(&mut self) {
        self.len = 0;
        self.free = 0;
        self.vacant = 0;
        self.room = Room::Enough;
        self.buckets = [0; NODES];
    }

    /// Places that were ever taken: every state's number is below.
    pub(super) const fn len(&self) -> u16 {
        self.len
    }

    /// How many states there are.
    pub(super) const fn count(&self) -> u16 {
        self.len.saturating_sub(self.vacant)
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
        let at = self.free.checked_sub(1).unwrap_or(self.len);
        let bucket = self.buckets.get_mut(Self::bucket(on))?;
        let node = self.nodes.get_mut(usize::from(at))?;
        if self.free > 0 {
            self.free = node.next;
            self.vacant = self.vacant.saturating_sub(1);
        } else {
            self.len = self.len.saturating_add(1);
        }
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
        *bucket = at.wrapping_add(1);
        Some(at)
    }

    /// The node of a state that is perceived, worth so much as far as anybody can tell.
    ///
    /// `None` while a full graph makes room.
    pub(super) fn visit(&mut self, on: &ItemSet<WORDS>, worth: f32) -> Option<u16> {
        for item in on.iter() {
            if let Some(row) = self.together.get_mut(usize::from(item.0)) {
                *row = row.union(on);
            }
        }
        let at = self.intern(on, worth);
        if let Some(node) = at.and_then(|at| self.node_mut(at)) {
            node.marks |= VISITED;
        }
        let scarce = Self::RESERVE > 0 && self.is_scarce();
        if self.room == Room::Enough && (at.is_none() || scarce) {
            self.room = Room::Cutting;
            self.at = 0;
        }
        at
    }

    fn is_scarce(&self) -> bool {
        usize::from(self.count()) + Self::RESERVE / 2 >= NODES
    }

    /// Whether room is being made: nothing is imagined meanwhile.
    pub(super) fn makes_room(&self) -> bool {
        self.room != Room::Enough
    }

    /// Makes room with one state more; answers whether that was the last.
    ///
    /// States that were perceived stay, unless they alone fill the graph: then it begins anew.
    pub(super) fn make_room(&mut self) -> bool {
        let at = self.at;
        self.at = self.at.saturating_add(1);
        match self.room {
            Room::Enough => return false,
            Room::Cutting if at >= self.len => {
                self.room = Room::Clearing;
                self.at = 0;
            }
            Room::Cutting => self.cut(at),
            Room::Clearing if at >= self.len => {
                self.room = Room::Enough;
                // What would be cut again at once is not kept.
                if self.is_scarce() {
                    self.forget();
                }
                return true;
            }
            // From the end, so that the first places are taken first.
            Room::Clearing => self.clear_place(self.len - 1 - at),
        }
        false
    }

    /// Cuts the links of a state to what was only imagined.
    fn cut(&mut self, at: u16) {
        let Some(mut links) = self.node(at).map(|node| node.links) else {
            return;
        };
        for link in &mut links {
            let to = link.checked_sub(1).and_then(|to| self.node(to));
            if !to.is_some_and(Node::was_visited) {
                *link = 0;
            }
        }
        if let Some(node) = self.node_mut(at) {
            node.links = links;
        }
    }

    /// Gives back the place of a state that was only imagined.
    fn clear_place(&mut self, at: u16) {
        let Some(node) = self.node(at) else { return };
        if node.was_visited() || node.is_free() {
            return;
        }
        let (bucket, next) = (Self::bucket(&node.on), node.next);
        let first = self.buckets.get(bucket).copied().unwrap_or(0);
        if first == at + 1 {
            if let Some(bucket) = self.buckets.get_mut(bucket) {
                *bucket = next;
            }
        } else {
            let mut before = first;
            // A chain has at most as many nodes as there are.
            for _ in 0..NODES {
                let here = before.saturating_sub(1);
                let Some(node) = self.node_mut(here) else {
                    break;
                };
                if node.next == at + 1 {
                    node.next = next;
                    break;
                }
                before = node.next;
            }
        }
        let free = self.free;
        if let Some(node) = self.node_mut(at) {
            node.links = [0; ACTIONS];
            node.marks = FREE;
            node.next = free;
        }
        self.free = at + 1;
        self.vacant = self.vacant.saturating_add(1);
    }

    /// Every state in which an item is on is worth so much more.
    pub(super) fn revalue(&mut self, item: ItemId, more: f32) {
        for at in 0..self.len {
            if let Some(node) = self.node_mut(at)
                && !node.is_free()
                && node.on.contains(item)
            {
                node.worth = bounded(node.worth + more, MOST_WORTH);
            }
        }
    }

    /// What arriving in a state has brought.
    pub(super) fn feel(&mut self, at: u16, worth: f32) {
        if let Some(node) = self.node_mut(at) {
            let share = if node.marks & FELT != 0 { 0.25 } else { 1.0 };
            node.worth += share * (worth - node.worth);
            node.marks |= FELT;
        }
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
        self.node(at).is_some_and(|node| !node.is_free()) && self.link(at, action) == Some(0)
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

    /// Whether an action led where it was foreseen to lead; `None` where nothing was foreseen, or what
    /// was foreseen was refused.
    pub(super) fn kept(&self, from: u16, action: u8, to: u16) -> Option<bool> {
        let link = self.link(from, action)?;
        (link != 0 && link != REFUSED).then_some(link == to.wrapping_add(1))
    }

    /// The states that were lived through: an action led from one to the other. Where it does not
    /// always do the same, what was predicted is given up only after the second time.
    pub(super) fn live(&mut self, from: u16, action: u8, to: u16, exact: bool) -> bool {
        let perceived = |at: u16| self.node(at).is_some_and(Node::was_visited);
        if !perceived(from) || !perceived(to) {
            return false;
        }
        let bit = 1_u32 << (action & 31);
        let same = self.link(from, action) == Some(to.wrapping_add(1));
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
        self.set_link(from, action, to.wrapping_add(1))
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
        let gone = self.node(from).is_none_or(Node::is_free);
        if gone || self.makes_room() || self.was_lived(from, action) {
            return false;
        }
        let to = if self.on(from) == Some(on) {
            Some(from)
        } else if usize::from(self.count()) + Self::RESERVE >= NODES {
            self.find(on)
        } else if self.plausible(on) {
            self.intern(on, worth)
        } else {
            None
        };
        self.set_link(from, action, to.map_or(REFUSED, |to| to.wrapping_add(1)))
    }

    /// Brings one state up to date with those around it; answers whether that changed it.
    pub(super) fn sweep(
        &mut self,
        at: u16,
        goal: Option<&SignedItems<WORDS>>,
        discount: f32,
    ) -> bool {
        let Some(node) = self.node(at).filter(|node| !node.is_free()) else {
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

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const NODES: usize>
    Imagined<WORDS, ITEMS, ACTIONS, NODES>
{
    /// Forgets all states when their lists cannot be so; whether they could not.
    pub(super) fn audit(&mut self) -> bool {
        let sound = self.is_sound();
        if !sound {
            self.forget();
        }
        !sound
    }

    /// Whether each state stands in the list of its hash, once, and each free place in that of free
    /// ones.
    fn is_sound(&self) -> bool {
        if usize::from(self.len) > NODES || self.vacant > self.len {
            return false;
        }
        let mut left = self.len;
        for (bucket, first) in self.buckets.iter().enumerate() {
            let mut at = *first;
            while let Some(here) = at.checked_sub(1) {
                let node = self.node(here).filter(|node| !node.is_free());
                let Some(node) = node.filter(|node| Self::bucket(&node.on) == bucket) else {
                    return false;
                };
                // A ring has no end, and there are no more states than places.
                let Some(fewer) = left.checked_sub(1) else {
                    return false;
                };
                (left, at) = (fewer, node.next);
            }
        }
        let mut at = self.free;
        while let Some(here) = at.checked_sub(1) {
            let Some(node) = self.node(here).filter(|node| node.is_free()) else {
                return false;
            };
            let Some(fewer) = left.checked_sub(1) else {
                return false;
            };
            (left, at) = (fewer, node.next);
        }
        left == 0
    }
}

stored_codes!(Room {
    0: (Self::Enough),
    1: (Self::Cutting),
    2: (Self::Clearing)
});
stored! {
    impl[const WORDS: usize, const ACTIONS: usize] Node<WORDS, ACTIONS> {
        on, links, lived, doubted, worth => within MOST_WORTH, value => within MOST_VALUE, next,
        distance, marks
    }
}
stored! {
    impl[const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const NODES: usize]
    Imagined<WORDS, ITEMS, ACTIONS, NODES> {
        nodes, buckets, len if |it: &u16| usize::from(*it) <= NODES, free, vacant, room, at, together
    }
}

#[cfg(test)]
#[path = "imagined_tests.rs"]
mod tests;

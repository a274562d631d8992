//! The faculty: learns from each action, works for some units, says what may be had and how.

use super::accommodating::{Accommodating, PASSED};
use super::experience::Experience;
use super::imagined::{Imagined, NEVER};
use super::pursuit::{Aim, Pursuit, Way};
use crate::growth::SimpleSchema;
use crate::snapshot::{Reader, Writer, bounded, stored};
use crate::word::{ActionId, ItemId, ItemSet, ItemStates, SchemaText, SignedItems};

/// The discount of what may be had.
const DISCOUNT: f32 = 0.95;
/// How much the newest action makes of what is said of promises.
const KEEPING: f32 = 0.01;
/// The number of no state.
const NOWHERE: u16 = u16::MAX;
/// Units that room with one state takes.
const ROOM: u32 = 8;
/// Units that one state's update takes.
const SWEEP: u32 = 6;

/// What each action is worth, as far as anybody can foresee.
///
/// ```
/// let none = cla_core::reason::Prospects::<2>::NONE;
/// assert_eq!((none.values, none.way), ([None; 2], cla_core::reason::Way::Unknown));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prospects<const ACTIONS: usize> {
    /// The discounted worth of what may be had after each action; `None` where nothing is known.
    pub values: [Option<f32>; ACTIONS],
    /// The next action towards the goal that is pursued.
    pub towards: Option<ActionId>,
    /// How far that goal is.
    pub way: Way,
    /// How far it is when each action comes first.
    pub ways: [Way; ACTIONS],
}

impl<const ACTIONS: usize> Prospects<ACTIONS> {
    /// Nothing is foreseen.
    pub const NONE: Self = Self {
        values: [None; ACTIONS],
        towards: None,
        way: Way::Unknown,
        ways: [Way::Unknown; ACTIONS],
    };
}

/// Schemas, imagined states and a goal, in fixed memory.
///
/// Capacities: words of an item set, items, actions, remembered samples an action, schemas, imagined
/// states.
///
/// In the field: incremental rule induction with replay, and planning on the model that it makes.
///
/// ```
/// use cla_core::reason::Reason;
/// use cla_core::word::{ActionId, ItemId, ItemStates};
/// // One item, a lamp; action 1 toggles it, action 0 does nothing.
/// let mut reason = Reason::<1, 1, 2, 8, 8, 4>::new();
/// reason.begin([1.0], 7);
/// let lamp = |on: bool| {
///     let mut now = ItemStates::<1>::all_off(1);
///     now.set(ItemId(0), Some(on)).map(|()| now)
/// };
/// let mut on = false;
/// for step in 0..20 {
///     let action = ActionId(step / 2 % 2);
///     let next = on != (action == ActionId(1));
///     reason.observe(&lamp(on)?, action, &lamp(next)?, f32::from(u8::from(next)));
///     reason.work(200);
///     on = next;
/// }
/// assert_eq!(reason.schemas().len(), 2);
/// let values = reason.prospects(&lamp(false)?).values;
/// assert!(values[1] > values[0]);
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Debug)]
pub struct Reason<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> {
    known: Accommodating<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS>,
    imagined: Imagined<WORDS, ITEMS, ACTIONS, NODES>,
    /// What is believed to be on now, and its state.
    believed: ItemSet<WORDS>,
    here: u16,
    /// Where imagining stands: the next link to predict, the next state to bring up to date.
    next: (u16, u8),
    /// From here on states are new: while a goal is pursued their links come first.
    front: (u16, u8),
    sweep: u16,
    upward: bool,
    /// Whether anything changed in this round of sweeps, and in the last one.
    moving: bool,
    moved: bool,
    /// Whether schemas changed since the links were predicted, and in this round.
    stale: bool,
    fresher: bool,
    values: [f32; ITEMS],
    aim: Aim<WORDS>,
    /// The share of its links that led where they promised, lately.
    kept: f32,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    /// Nothing known, nothing valued.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(ITEMS < 255, "a simple schema speaks of items 0 to 254");
        }
        Self {
            known: Accommodating::new(),
            imagined: Imagined::new(),
            believed: ItemSet::EMPTY,
            here: 0,
            next: (0, 0),
            front: (0, 0),
            sweep: 0,
            upward: false,
            moving: false,
            moved: false,
            stale: false,
            fresher: false,
            values: [0.0; ITEMS],
            aim: Aim::NONE,
            kept: 0.0,
        }
    }

    /// Begins anew; `values` says what it is worth when an item is on after an action.
    ///
    /// What is no number is worth nothing, and nothing is worth more than a million, or less.
    pub fn begin(&mut self, values: [f32; ITEMS], seed: u64) {
        self.known.begin(seed);
        self.imagined.clear();
        self.believed = ItemSet::EMPTY;
        self.here = 0;
        self.next = (0, 0);
        self.front = (0, 0);
        self.sweep = 0;
        self.upward = false;
        self.stale = false;
        self.fresher = false;
        self.moving = false;
        self.moved = false;
        self.values = values.map(|it| bounded(it, MOST));
        self.aim = Aim::NONE;
        self.kept = 0.0;
    }

    /// What it is worth from now on when an item is on, within the bounds of [`begin`](Self::begin).
    ///
    /// Schemas and imagined states stay; their values follow as [`work`](Self::work) goes on.
    pub fn revalue(&mut self, item: ItemId, value: f32) {
        let value = bounded(value, MOST);
        if let Some(old) = self.values.get_mut(usize::from(item.0)) {
            let more = value - core::mem::replace(old, value);
            self.imagined.revalue(item, more);
            self.moving = true;
        }
    }

    /// The schemas that are believed now, in no order that means anything.
    #[must_use]
    pub fn schemas(&self) -> &[SimpleSchema] {
        self.known.table.all()
    }

    /// Schemas that made room for others, and schemas that found none.
    #[must_use]
    pub const fn losses(&self) -> (u32, u32) {
        self.known.table.losses()
    }

    /// The number of imagined states.
    #[must_use]
    pub const fn imagined(&self) -> u16 {
        self.imagined.count()
    }

    /// Whether values and the distance of the goal have gone as far as they go, for the time being.
    #[must_use]
    pub const fn is_settled(&self) -> bool {
        !self.moving && !self.moved
    }

    /// How much of what it foresees comes true, of whole states and lately, in `[0, 1]`.
    #[must_use]
    pub const fn reliability(&self) -> f32 {
        self.kept
    }

    /// How often an action does not do what it mostly does, as far as its record tells, in `[0, 0.2]`.
    #[must_use]
    pub fn noise(&self, action: ActionId) -> f32 {
        self.known.noise(action)
    }

    /// What is believed to be on, of what is perceived and, where that is unknown, of what was
    /// foreseen.
    fn believe(&self, now: &ItemStates<WORDS>, foreseen: &ItemSet<WORDS>) -> ItemSet<WORDS> {
        foreseen.difference(&now.known()).union(now.on())
    }

    /// Learns from one completed action, and what it brought; an action that the brain does not have
    /// changes nothing.
    ///
    /// Schemas that applied are tested, the sample is filed; contexts grow while it works.
    pub fn observe(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        reward: f32,
    ) {
        let index = usize::from(action.0);
        if index >= ACTIONS {
            return;
        }
        let from = self.believe(before, &self.believed);
        let foreseen = self.known.table.predict(&from, action.0 as u8);
        let sample = Experience {
            before: *before,
            after: *after,
        };
        self.known.compare(action, &sample);
        let to = self.believe(after, &foreseen);
        let exact = self.noise(action) <= 0.0;
        let worth = bounded(reward, MOST);
        let (here, there) = self.arrive_from(&from, &to);
        self.imagined.feel(there, worth);
        if here != NOWHERE && there != NOWHERE {
            if let Some(kept) = self.imagined.kept(here, action.0 as u8, there) {
                let kept = if kept { 1.0 } else { 0.0 };
                self.kept += KEEPING * (kept - self.kept);
            }
            let changed = self.imagined.live(here, action.0 as u8, there, exact);
            let goal = self.aim.goal();
            let news = self.imagined.sweep(here, goal, DISCOUNT);
            self.moving |= changed || news;
        }
        self.believed = to;
        self.here = there;
        self.aim.count(after);
    }

    /// The node of a state that is perceived; none while room is made for it.
    fn arrive(&mut self, on: &ItemSet<WORDS>) -> u16 {
        let count = self.imagined.count();
        let at = self
            .imagined
            .visit(on, self.worth_of(on))
            .unwrap_or(NOWHERE);
        if self.imagined.count() > count {
            self.front = (at, 0);
        }
        at
    }

    /// The nodes of the two ends of an action; where both are new, both are yet to be looked at.
    fn arrive_from(&mut self, from: &ItemSet<WORDS>, to: &ItemSet<WORDS>) -> (u16, u16) {
        let count = self.imagined.count();
        let here = self.arrive(from);
        let is_new = self.imagined.count() > count;
        let there = self.arrive(to);
        if is_new {
            self.front = (here.min(there), 0);
        }
        (here, there)
    }

    /// This is perceived now: where it is not what the last action led to, that is where it stands.
    pub fn perceive(&mut self, now: &ItemStates<WORDS>) {
        let on = self.believe(now, &self.believed);
        self.believed = on;
        if self.imagined.on(self.here) != Some(&on) {
            self.here = self.arrive(&on);
        }
    }

    /// The episode is over: what is unknown at first is believed to be off.
    pub fn interrupt(&mut self) {
        self.believed = ItemSet::EMPTY;
    }

    fn worth_of(&self, on: &ItemSet<WORDS>) -> f32 {
        let mut worth = 0.0;
        for item in on.iter() {
            worth += self.values.get(usize::from(item.0)).copied().unwrap_or(0.0);
        }
        worth
    }

    /// Works for about so many units on what is pending; answers how many it took.
    ///
    /// A unit is some 55 instructions on a Cortex-M4F with 76 items. Three quarters go to contexts and
    /// the rest to imagined states, and what one of them does not need to the other; while a new goal
    /// spreads over the states that takes three quarters.
    pub fn work(&mut self, units: u32) -> u32 {
        let mut spent = self.look_around();
        while self.aim.goal().is_some() && spent < units - units / 4 {
            let took = self.sweep_next();
            if took == 0 {
                break;
            }
            spent += took;
        }
        while spent < units {
            let most = units - (units - spent) / 4;
            let mut did = 0;
            while spent < most {
                let took = self.known.grow();
                if took == 0 {
                    break;
                }
                spent += took;
                did += took;
            }
            self.stale |= self.known.take_news();
            while spent < units {
                let took = self.imagine();
                if took == 0 {
                    break;
                }
                spent += took;
                did += took;
            }
            if did == 0 {
                break;
            }
        }
        spent
    }

    /// Whether there is work to do.
    #[must_use]
    pub fn pending(&self) -> bool {
        self.known.pending()
            || self.stale
            || self.imagined.makes_room()
            || self.fresher
            || self.moving
            || self.moved
            || self.next.0 < self.imagined.len()
    }

    /// What each action leads to here, if nobody knows; the units that it took.
    fn look_around(&mut self) -> u32 {
        let mut units = 0;
        if self.imagined.makes_room() {
            return 0;
        }
        for action in 0..ACTIONS as u8 {
            if self.imagined.is_open(self.here, action) {
                units += self.foresee(self.here, action);
            }
        }
        if units > 0 {
            let goal = self.aim.goal();
            self.moving |= self.imagined.sweep(self.here, goal, DISCOUNT);
        }
        units
    }

    fn foresee(&mut self, at: u16, action: u8) -> u32 {
        let Some(on) = self.imagined.on(at).copied() else {
            return 1;
        };
        let after = self.known.table.predict(&on, action);
        let worth = self.worth_of(&after);
        let news = self.imagined.foresee(at, action, &after, worth);
        self.moving |= news;
        8 + self.known.table.of(action).len() as u32 / PASSED
    }

    /// A part of the work on imagined states; 0 units when there is none.
    fn imagine(&mut self) -> u32 {
        if self.imagined.makes_room() {
            if self.imagined.make_room() {
                // What was imagined is imagined anew, as far as it still can be.
                self.stale = true;
                self.moving = true;
                self.next = (0, 0);
                let believed = self.believed;
                self.here = self.arrive(&believed);
                self.front = (self.here, 0);
            }
            return ROOM;
        }
        let foreseen = self.predict_next();
        let mut units = foreseen;
        let swept = if foreseen == 0 { SWEEP } else { foreseen };
        let mut sweeping = 0;
        while sweeping < swept {
            let took = self.sweep_next();
            if took == 0 {
                break;
            }
            sweeping += took;
        }
        units += sweeping;
        units
    }

    /// Predicts one link, of states in the order in which they were found.
    fn predict_next(&mut self) -> u32 {
        let (at, action) = self.front;
        if self.aim.goal().is_some() && at < self.imagined.len() {
            self.front = after::<ACTIONS>(at, action);
            return if self.imagined.is_open(at, action) {
                self.foresee(at, action)
            } else {
                1
            };
        }
        let (at, action) = self.next;
        if at >= self.imagined.len() {
            // A round is over; another one when schemas have changed since.
            if !self.stale {
                self.fresher = false;
                return 0;
            }
            self.stale = false;
            self.fresher = true;
            self.next = (0, 0);
            return 1;
        }
        self.next = after::<ACTIONS>(at, action);
        if self.imagined.was_lived(at, action) {
            1
        } else {
            self.foresee(at, action)
        }
    }

    /// Brings the next state up to date; 0 units when all are.
    fn sweep_next(&mut self) -> u32 {
        if !self.moving && !self.moved {
            return 0;
        }
        let len = self.imagined.len();
        if self.sweep >= len {
            self.sweep = 0;
            self.upward = !self.upward;
            self.moved = self.moving;
            self.moving = false;
            return 1;
        }
        let at = if self.upward {
            self.sweep
        } else {
            len - 1 - self.sweep
        };
        self.sweep += 1;
        let goal = self.aim.goal();
        self.moving |= self.imagined.sweep(at, goal, DISCOUNT);
        SWEEP
    }

    /// What may be had from here, and how a goal that is pursued is reached.
    ///
    /// Nothing where this state was never met or imagined.
    #[must_use]
    pub fn prospects(&self, now: &ItemStates<WORDS>) -> Prospects<ACTIONS> {
        let on = self.believe(now, &self.believed);
        let Some(here) = self.imagined.find(&on) else {
            return Prospects::NONE;
        };
        let mut ways = [Way::Unknown; ACTIONS];
        let mut nearest: Option<(u8, ActionId)> = None;
        if self.aim.goal().is_some() {
            let distances = self.imagined.distances(here);
            for (action, (way, distance)) in (0..).zip(ways.iter_mut().zip(distances)) {
                if distance < NEVER {
                    *way = Way::Actions(distance + 1);
                }
                if distance < nearest.map_or(NEVER, |(least, _)| least) {
                    nearest = Some((distance, ActionId(action)));
                }
            }
        }
        Prospects {
            values: self.imagined.values(here, DISCOUNT),
            towards: nearest.map(|(_, action)| action),
            way: nearest.map_or(Way::Unknown, |(left, _)| Way::Actions(left + 1)),
            ways,
        }
    }

    /// Pursues a goal for at most `limit` actions, beginning now; it replaces the last one.
    pub fn pursue(&mut self, goal: SignedItems<WORDS>, limit: u16, now: &ItemStates<WORDS>) {
        self.perceive(now);
        self.aim = Aim::begin(goal, limit, now);
        self.imagined.lose_sight();
        self.moving = true;
    }

    /// Pursues nothing any more.
    pub fn give_up(&mut self) {
        self.aim = Aim::NONE;
    }

    /// How the pursuit of the last goal stands.
    #[must_use]
    pub const fn pursuit(&self) -> Pursuit {
        self.aim.state
    }

    /// Why something is expected of an action, as one schema: the contexts of those that foresee a
    /// change together, and all that changes.
    ///
    /// Without context and result where nothing is foreseen.
    #[must_use]
    pub fn explain(&self, now: &ItemStates<WORDS>, action: ActionId) -> SchemaText<WORDS> {
        let on = self.believe(now, &self.believed);
        let index = u8::try_from(action.0).unwrap_or(u8::MAX);
        let after = self.known.table.predict(&on, index);
        self.known.table.reason(&on, &after, action)
    }

    /// What is expected to be on after an action.
    #[must_use]
    pub fn predict(&self, now: &ItemStates<WORDS>, action: ActionId) -> ItemSet<WORDS> {
        let on = self.believe(now, &self.believed);
        self.known
            .table
            .predict(&on, u8::try_from(action.0).unwrap_or(u8::MAX))
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Default for Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    fn default() -> Self {
        Self::new()
    }
}

/// The next action, or the first of the next state.
const fn after<const ACTIONS: usize>(at: u16, action: u8) -> (u16, u8) {
    if action as usize + 1 < ACTIONS {
        (at, action + 1)
    } else {
        (at.saturating_add(1), 0)
    }
}

/// The most that anything is worth.
const MOST: f32 = 1.0e6;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    /// Drops what cannot be so: schemas, and all that is imagined when its lists are broken; what is
    /// worth having is `values` again. Answers how many.
    pub(super) fn audit(&mut self, values: [f32; ITEMS]) -> u32 {
        let mut mended = self.known.audit();
        let values = values.map(|it| bounded(it, MOST));
        if self.values.map(f32::to_bits) != values.map(f32::to_bits) {
            self.values = values;
            mended += 1;
        }
        if self.imagined.audit() {
            mended += 1;
            self.stale = true;
            self.moving = true;
            self.next = (0, 0);
            let believed = self.believed;
            self.here = self.arrive(&believed);
            self.front = (self.here, 0);
        }
        mended
    }
}

stored! {
    impl[
        const WORDS: usize,
        const ITEMS: usize,
        const ACTIONS: usize,
        const SAMPLES: usize,
        const SCHEMAS: usize,
        const NODES: usize
    ]
    Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES> {
        known, imagined, believed, here, next, front, sweep, upward, moving, moved, stale, fresher,
        values => within MOST,
        aim,
        kept => up_to 1.1
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    /// Writes schemas and remembered samples; what is imagined is imagined anew.
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        self.known.carry(to);
    }

    /// Reads that from one of so many words and actions, over what is there if there is anybody, which
    /// has just begun.
    pub(super) fn take(into: Option<&mut Self>, robot: (usize, usize), from: &mut Reader<'_>) {
        let known = into.map(|it| {
            it.stale = true;
            &mut it.known
        });
        Accommodating::take(known, robot, from);
    }
}

#[cfg(test)]
#[path = "faculty_tests.rs"]
mod tests;

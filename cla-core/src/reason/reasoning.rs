//! What a learner asks of its reason, so that it can also have none.

use super::faculty::{Prospects, Reason};
use super::pursuit::Pursuit;
use crate::snapshot::{Reader, Writer};
use crate::word::{ActionId, ItemId, ItemStates, SchemaText, SignedItems};

/// A faculty of schemas and goals, or `()`: none at all, which takes 0 bytes and does nothing.
///
/// The methods are those of [`Reason`].
///
/// ```
/// use cla_core::reason::{Prospects, Reason, Reasoning};
/// use cla_core::word::ItemStates;
/// fn of<R: Reasoning<1, 2, 3>>(mind: &R) -> Prospects<3> {
///     mind.prospects(&ItemStates::all_off(2))
/// }
/// assert_eq!(of(&()), Prospects::NONE);
/// assert_eq!(of(&Reason::<1, 2, 3, 8, 8, 8>::new()), Prospects::NONE);
/// assert_eq!(size_of::<()>(), 0);
/// ```
pub trait Reasoning<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> {
    /// Nothing known.
    const NEW: Self;

    /// Whether there is anything at all.
    const THERE: bool;

    /// Remembered samples of an action, schemas, imagined states; 0 where there is nothing.
    const CAPACITIES: [u32; 3];

    /// Schemas that found no room or made some for others, since birth.
    fn losses(&self) -> u32;

    /// Schemas that are believed.
    fn filled(&self) -> u32;

    /// Drops what cannot be so, `values` being what is worth having; answers how many.
    fn audit(&mut self, values: [f32; ITEMS]) -> u32;

    /// Writes schemas and samples, as knowledge alone.
    #[doc(hidden)]
    fn carry(&self, to: &mut Writer<'_>);

    /// Reads what was written in that way by one with `capacities` and so many words and actions, over
    /// what is there if there is anybody.
    #[doc(hidden)]
    fn take(
        into: Option<&mut Self>,
        capacities: [usize; 3],
        robot: (usize, usize),
        from: &mut Reader<'_>,
    );

    /// See [`Reason::begin`].
    fn begin(&mut self, values: [f32; ITEMS], seed: u64);

    /// See [`Reason::revalue`].
    fn revalue(&mut self, item: ItemId, value: f32);

    /// See [`Reason::observe`].
    fn observe(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        reward: f32,
    );

    /// See [`Reason::perceive`].
    fn perceive(&mut self, now: &ItemStates<WORDS>);

    /// See [`Reason::interrupt`].
    fn interrupt(&mut self);

    /// See [`Reason::work`].
    fn work(&mut self, units: u32) -> u32;

    /// See [`Reason::pending`].
    fn pending(&self) -> bool;

    /// See [`Reason::prospects`].
    fn prospects(&self, now: &ItemStates<WORDS>) -> Prospects<ACTIONS>;

    /// See [`Reason::pursue`].
    fn pursue(&mut self, goal: SignedItems<WORDS>, limit: u16, now: &ItemStates<WORDS>);

    /// See [`Reason::give_up`].
    fn give_up(&mut self);

    /// See [`Reason::pursuit`].
    fn pursuit(&self) -> Pursuit;

    /// See [`Reason::is_settled`].
    fn is_settled(&self) -> bool;

    /// See [`Reason::reliability`].
    fn reliability(&self) -> f32;

    /// See [`Reason::explain`].
    fn explain(&self, now: &ItemStates<WORDS>, action: ActionId) -> SchemaText<WORDS>;
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> Reasoning<WORDS, ITEMS, ACTIONS>
    for ()
{
    const NEW: Self = ();
    const THERE: bool = false;
    const CAPACITIES: [u32; 3] = [0; 3];

    fn losses(&self) -> u32 {
        0
    }

    fn filled(&self) -> u32 {
        0
    }

    fn audit(&mut self, _: [f32; ITEMS]) -> u32 {
        0
    }

    fn carry(&self, _: &mut Writer<'_>) {}

    fn take(
        _: Option<&mut Self>,
        [_, schemas, _]: [usize; 3],
        _: (usize, usize),
        from: &mut Reader<'_>,
    ) {
        // Where there could be none, nothing was kept.
        let _ = from.fit("schemas", schemas as u32, 0);
    }

    fn begin(&mut self, _: [f32; ITEMS], _: u64) {}

    fn revalue(&mut self, _: ItemId, _: f32) {}

    fn observe(&mut self, _: &ItemStates<WORDS>, _: ActionId, _: &ItemStates<WORDS>, _: f32) {}

    fn perceive(&mut self, _: &ItemStates<WORDS>) {}

    fn interrupt(&mut self) {}

    fn work(&mut self, _: u32) -> u32 {
        0
    }

    fn pending(&self) -> bool {
        false
    }

    fn prospects(&self, _: &ItemStates<WORDS>) -> Prospects<ACTIONS> {
        Prospects::NONE
    }

    fn pursue(&mut self, _: SignedItems<WORDS>, _: u16, _: &ItemStates<WORDS>) {}

    fn give_up(&mut self) {}

    fn pursuit(&self) -> Pursuit {
        Pursuit::Nothing
    }

    fn is_settled(&self) -> bool {
        true
    }

    fn reliability(&self) -> f32 {
        0.0
    }

    fn explain(&self, _: &ItemStates<WORDS>, action: ActionId) -> SchemaText<WORDS> {
        SchemaText {
            context: SignedItems::EMPTY,
            action,
            result: SignedItems::EMPTY,
        }
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Reasoning<WORDS, ITEMS, ACTIONS> for Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    const NEW: Self = Self::new();
    const THERE: bool = true;
    const CAPACITIES: [u32; 3] = [SAMPLES as u32, SCHEMAS as u32, NODES as u32];

    fn losses(&self) -> u32 {
        let (evicted, refused) = Self::losses(self);
        evicted.wrapping_add(refused)
    }

    fn filled(&self) -> u32 {
        self.schemas().len() as u32
    }

    fn audit(&mut self, values: [f32; ITEMS]) -> u32 {
        Self::audit(self, values)
    }

    fn carry(&self, to: &mut Writer<'_>) {
        Self::carry(self, to);
    }

    fn take(
        into: Option<&mut Self>,
        [_, schemas, _]: [usize; 3],
        robot: (usize, usize),
        from: &mut Reader<'_>,
    ) {
        // A mind without a reason had none of it.
        if schemas > 0 {
            Self::take(into, robot, from);
        }
    }

    fn begin(&mut self, values: [f32; ITEMS], seed: u64) {
        Self::begin(self, values, seed);
    }

    fn revalue(&mut self, item: ItemId, value: f32) {
        Self::revalue(self, item, value);
    }

    fn observe(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        reward: f32,
    ) {
        Self::observe(self, before, action, after, reward);
    }

    fn perceive(&mut self, now: &ItemStates<WORDS>) {
        Self::perceive(self, now);
    }

    fn interrupt(&mut self) {
        Self::interrupt(self);
    }

    fn work(&mut self, units: u32) -> u32 {
        Self::work(self, units)
    }

    fn pending(&self) -> bool {
        Self::pending(self)
    }

    fn prospects(&self, now: &ItemStates<WORDS>) -> Prospects<ACTIONS> {
        Self::prospects(self, now)
    }

    fn pursue(&mut self, goal: SignedItems<WORDS>, limit: u16, now: &ItemStates<WORDS>) {
        Self::pursue(self, goal, limit, now);
    }

    fn give_up(&mut self) {
        Self::give_up(self);
    }

    fn pursuit(&self) -> Pursuit {
        Self::pursuit(self)
    }

    fn is_settled(&self) -> bool {
        Self::is_settled(self)
    }

    fn reliability(&self) -> f32 {
        Self::reliability(self)
    }

    fn explain(&self, now: &ItemStates<WORDS>, action: ActionId) -> SchemaText<WORDS> {
        Self::explain(self, now, action)
    }
}

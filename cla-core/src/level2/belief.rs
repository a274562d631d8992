//! What a schema's success says about the schemas that could come next: counters of beliefs (5.1.1).
//!
//! A synthetic item `[schema]` is the hypothetical state in which its schema would succeed.
//! Whether it was on is known one action later, in hindsight: on if its schema succeeded, off if
//! another result of the same action came, unknown if another action was done.
//! Each item keeps these labels per *trace*, the schema that had succeeded just before, and they
//! become a belief when that trace comes again: from the past alone.

use crate::knowledge::{SchemaId, SyntheticId};
use crate::num::ordered::{insert, remove};
use crate::snapshot::{LARGEST, LARGEST_COUNT, stored};
use crate::word::{ActionId, Cost};

/// Stands for a schema that may have left; no table is as large.
const LOST: SchemaId = SchemaId(u16::MAX);

/// How often `item` was on right after `trace` had succeeded.
///
/// In the field: a bigram count that forgets.
///
/// ```
/// assert_eq!(core::mem::size_of::<cla_core::level2::Belief>(), 8);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Belief {
    /// The item of the schema that had just succeeded.
    pub trace: SyntheticId,
    /// The item that was then on.
    pub item: SyntheticId,
    /// Verified occasions on which it was on; older ones weigh less.
    pub on: f32,
}

/// One synthetic item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row<const ACTIONS: usize> {
    /// The schema that it stands for; `None` for a free row.
    pub(crate) schema: Option<SchemaId>,
    /// That schema's action.
    pub(crate) action: ActionId,
    /// What being in the state after its success is worth.
    pub(crate) value: f32,
    /// The discounted reward that has really followed, on average.
    pub(crate) experienced: f32,
    /// What that is worth a step before: kept, because it is read more often than it changes.
    pub(crate) then: f32,
    /// How often its schema has succeeded.
    pub(crate) visits: f32,
    /// How much a TD error now still concerns it, its eligibility; it fades with time.
    pub(crate) eligibility: f32,
    /// When its schema last succeeded, by the table's clock.
    pub(crate) used: u32,
    /// How often each action was done right after its success; older times weigh less.
    pub(crate) tried: [f32; ACTIONS],
}

/// What did not fit the second level's tables.
///
/// ```
/// assert_eq!(cla_core::level2::BeliefLosses::default().refused_items, 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BeliefLosses {
    /// Items that were out of use, or hardly ever used, and made room for new ones.
    pub evicted_items: u32,
    /// Schemas that found no room to become items.
    pub refused_items: u32,
    /// Counters with the lowest count that made room for new ones.
    pub evicted_beliefs: u32,
}

/// The synthetic items of `ACTIONS` actions and the beliefs about them, in fixed memory.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BeliefTable<const ACTIONS: usize, const ITEMS: usize, const BELIEFS: usize> {
    pub(crate) rows: heapless::Vec<Row<ACTIONS>, ITEMS, u16>,
    /// In ascending order of (trace, item).
    pub(crate) beliefs: heapless::Vec<Belief, BELIEFS, u16>,
    pub(crate) losses: BeliefLosses,
    /// Occasions recorded so far; it wraps.
    pub(super) clock: u32,
    /// Items and beliefs gone through in this step.
    pub(crate) cost: Cost,
}

/// Occasions after which an item that was not met again gives way to a new one: the world that it
/// belonged to may be gone.
const OUT_OF_USE: u32 = 1000;
/// Uses up to which an item gives way to a new one when all rows are taken.
const HARDLY_USED: f32 = 2.0;

impl<const ACTIONS: usize, const ITEMS: usize, const BELIEFS: usize>
    BeliefTable<ACTIONS, ITEMS, BELIEFS>
{
    pub(crate) const fn new() -> Self {
        const {
            assert!(
                ITEMS < u16::MAX as usize && BELIEFS < u16::MAX as usize,
                "at most 65,534 synthetic items and beliefs"
            );
        }
        Self {
            rows: heapless::Vec::new(),
            beliefs: heapless::Vec::new(),
            losses: BeliefLosses {
                evicted_items: 0,
                refused_items: 0,
                evicted_beliefs: 0,
            },
            clock: 0,
            cost: Cost::NONE,
        }
    }

    pub(crate) fn clear(&mut self) {
        self.clock = 0;
        self.rows.clear();
        self.beliefs.clear();
        self.losses = BeliefLosses::default();
    }

    /// A row for a schema: a new one, a free one, that of the item that has been out of use the
    /// longest, or of the one with the fewest uses if they are hardly any.
    pub(crate) fn add(
        &mut self,
        schema: SchemaId,
        action: ActionId,
        value: f32,
    ) -> Option<SyntheticId> {
        let row = Row {
            schema: Some(schema),
            action,
            value,
            experienced: value,
            then: 0.0,
            visits: 0.0,
            eligibility: 0.0,
            used: self.clock,
            tried: [0.0; ACTIONS],
        };
        if self.rows.push(row).is_ok() {
            return Some(SyntheticId(self.rows.len() as u16 - 1));
        }
        self.cost.items = self.cost.items.wrapping_add(self.rows.len() as u32);
        // The less there is to lose the larger.
        let mut found: Option<(Loss, usize)> = None;
        for (index, other) in self.rows.iter().enumerate() {
            let idle = self.clock.wrapping_sub(other.used);
            let loss = if other.schema.is_none() {
                Loss::Nothing
            } else if idle > OUT_OF_USE {
                Loss::Idle(idle)
            } else {
                Loss::Uses(uses(other))
            };
            if found.is_none_or(|(least, _)| loss.is_less(least)) {
                found = Some((loss, index));
            }
        }
        match found {
            Some((loss, index)) if loss.is_small() => {
                if loss != Loss::Nothing {
                    self.losses.evicted_items = self.losses.evicted_items.saturating_add(1);
                }
                let id = SyntheticId(index as u16);
                self.count_beliefs(self.beliefs.len());
                self.free(id);
                *self.rows.get_mut(index)? = row;
                Some(id)
            }
            _ => {
                self.losses.refused_items = self.losses.refused_items.saturating_add(1);
                None
            }
        }
    }

    /// An item's schema has just succeeded.
    pub(crate) fn meet(&mut self, item: SyntheticId) {
        if let Some(row) = self.rows.get_mut(usize::from(item.0)) {
            row.used = self.clock;
        }
    }

    /// Makes a row free and drops every belief that mentions it.
    pub(crate) fn free(&mut self, id: SyntheticId) {
        if let Some(row) = self.rows.get_mut(usize::from(id.0)) {
            row.schema = None;
        }
        self.beliefs
            .retain(|belief| belief.trace != id && belief.item != id);
    }

    /// No item has a schema until one is found for it.
    pub(super) fn lose_all(&mut self) {
        for row in &mut self.rows {
            row.schema = row.schema.map(|_| LOST);
        }
    }

    /// Drops the items for which none was found, and all beliefs about them.
    pub(super) fn free_lost(&mut self) {
        let Self { rows, beliefs, .. } = self;
        let is_lost = |id: SyntheticId| {
            let row = rows.get(usize::from(id.0));
            row.is_some_and(|row| row.schema == Some(LOST))
        };
        if rows.iter().all(|row| row.schema != Some(LOST)) {
            return;
        }
        beliefs.retain(|belief| !is_lost(belief.trace) && !is_lost(belief.item));
        for row in rows {
            row.schema = row.schema.filter(|&schema| schema != LOST);
        }
    }

    pub(crate) fn row(&self, id: SyntheticId) -> Option<&Row<ACTIONS>> {
        self.rows.get(usize::from(id.0))
    }

    /// All beliefs, in ascending order of (trace, item).
    pub(crate) fn all(&self) -> &[Belief] {
        &self.beliefs
    }

    /// The beliefs that follow from a trace.
    pub(crate) fn after(&self, trace: SyntheticId) -> &[Belief] {
        self.beliefs.get(self.range(trace)).unwrap_or(&[])
    }

    fn range(&self, trace: SyntheticId) -> core::ops::Range<usize> {
        let from = self.beliefs.partition_point(|belief| belief.trace < trace);
        let behind = self.beliefs.get(from..).unwrap_or(&[]);
        // Few follow a trace: going on is faster than another search.
        let after = behind.iter().take_while(|belief| belief.trace == trace);
        from..from + after.count()
    }

    /// Labels the items of an action done after `trace`: `item`, if any, was on, the others off.
    ///
    /// With `forgetting` above 0 the oldest labels weigh less, so that at most 1 / `forgetting` of
    /// them count.
    pub(crate) fn record(
        &mut self,
        trace: SyntheticId,
        action: ActionId,
        item: Option<SyntheticId>,
        forgetting: f32,
    ) {
        self.clock = self.clock.wrapping_add(1);
        let row = self.rows.get_mut(usize::from(trace.0));
        let Some(tried) = row.and_then(|row| row.tried.get_mut(usize::from(action.0))) else {
            return;
        };
        // What never forgets is halved before a count of floats stands still.
        let kept = if *tried >= LARGEST_COUNT / 2.0 {
            0.5
        } else if *tried * forgetting >= 1.0 {
            1.0 - forgetting
        } else {
            1.0
        };
        let full = kept < 1.0;
        if full {
            *tried *= kept;
        }
        *tried += 1.0;
        if full {
            self.weaken(trace, action, kept);
        }
        if let Some(item) = item {
            self.count(trace, item);
        }
    }

    /// Lets the beliefs about one action after a trace count for less: `share` in `[0, 1]`.
    pub(super) fn weaken(&mut self, trace: SyntheticId, action: ActionId, share: f32) {
        let range = self.range(trace);
        self.count_beliefs(range.len());
        let Self { rows, beliefs, .. } = self;
        for belief in beliefs.get_mut(range).unwrap_or_default() {
            let row = rows.get(usize::from(belief.item.0));
            if row.is_some_and(|row| row.action == action) {
                belief.on *= share;
            }
        }
    }

    /// Lets all that is believed about an action after a trace count for `share` of what it did.
    pub(crate) fn forget(&mut self, trace: SyntheticId, action: ActionId, share: f32) {
        let row = self.rows.get_mut(usize::from(trace.0));
        if let Some(tried) = row.and_then(|row| row.tried.get_mut(usize::from(action.0))) {
            *tried *= share;
        }
        self.weaken(trace, action, share);
    }

    fn count(&mut self, trace: SyntheticId, item: SyntheticId) {
        let key = |belief: &Belief| (belief.trace, belief.item);
        match self.beliefs.binary_search_by_key(&(trace, item), key) {
            Ok(index) => {
                if let Some(belief) = self.beliefs.get_mut(index) {
                    belief.on += 1.0;
                }
            }
            Err(index) => {
                self.count_beliefs(self.beliefs.len() - index);
                let new = Belief {
                    trace,
                    item,
                    on: 1.0,
                };
                if insert(&mut self.beliefs, index, new) {
                    return;
                }
                self.drop_weakest();
                let index = self.beliefs.partition_point(|it| key(it) < (trace, item));
                // There is room now, unless the capacity is 0.
                let _ = insert(&mut self.beliefs, index, new);
            }
        }
    }

    /// Counts beliefs that are gone through or moved.
    fn count_beliefs(&mut self, beliefs: usize) {
        self.cost.beliefs = self.cost.beliefs.wrapping_add(beliefs as u32);
    }

    fn drop_weakest(&mut self) {
        self.count_beliefs(2 * self.beliefs.len());
        let mut least: Option<(f32, usize)> = None;
        for (index, belief) in self.beliefs.iter().enumerate() {
            if least.is_none_or(|(other, _)| belief.on < other) {
                least = Some((belief.on, index));
            }
        }
        if let Some((_, index)) = least {
            remove(&mut self.beliefs, index);
        }
        self.losses.evicted_beliefs = self.losses.evicted_beliefs.saturating_add(1);
    }
}

/// What is lost with an item.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Loss {
    /// The row is free.
    Nothing,
    /// It was met so many occasions ago.
    Idle(u32),
    /// It is in use, and was used so often.
    Uses(f32),
}

impl Loss {
    /// Whether something new is worth it.
    fn is_small(self) -> bool {
        match self {
            Self::Nothing | Self::Idle(_) => true,
            Self::Uses(uses) => uses <= HARDLY_USED,
        }
    }

    fn is_less(self, other: Self) -> bool {
        match (self, other) {
            (Self::Nothing, _) => other != Self::Nothing,
            (_, Self::Nothing) => false,
            (Self::Idle(here), Self::Idle(there)) => here > there,
            (Self::Idle(_), Self::Uses(_)) => true,
            (Self::Uses(_), Self::Idle(_)) => false,
            (Self::Uses(here), Self::Uses(there)) => here < there,
        }
    }
}

/// How often anything was done right after the item's schema had succeeded.
pub(crate) fn uses<const ACTIONS: usize>(row: &Row<ACTIONS>) -> f32 {
    let mut total = 0.0;
    for tried in row.tried {
        total += tried;
    }
    total
}

stored! {
    impl[] Belief { trace, item, on }
    sound |it, limits| it.on >= 0.0
        && it.on <= LARGEST_COUNT
        && limits.ascends(u32::from(it.trace.0) << 16 | u32::from(it.item.0))
}

// What that is worth a step before is found again.
stored! {
    impl[const ACTIONS: usize] Row<ACTIONS> {
        schema,
        action,
        value => up_to LARGEST,
        experienced,
        visits => up_to LARGEST_COUNT,
        eligibility => up_to 1.0,
        used,
        tried => up_to LARGEST_COUNT
        ;
        then: 0.0
    }
    counted synthetic
}

stored! { impl[] BeliefLosses { evicted_items, refused_items, evicted_beliefs } }

stored! {
    impl[const ACTIONS: usize, const ITEMS: usize, const BELIEFS: usize]
    BeliefTable<ACTIONS, ITEMS, BELIEFS> { rows, beliefs, losses, clock, cost }
}

#[cfg(test)]
#[path = "belief_tests.rs"]
mod tests;

//! Looking ahead: a bounded best-first search over predicted states.
//!
//! A state is predicted by applying all reliable schemas of an action at once, so what is lost on
//! the way counts too (the backward chain of `composite_action` walks to the mouth without the ball).
//! States with items that were never seen together are refused, schemas that failed in this attempt
//! are suspended, and a plan that meets what it did not foresee is made anew.
//! Memory is `NODES` states of 20 bytes (for three words) and a table of item pairs.

use super::composite_action::holds;
use crate::check::{Config, ConfigError, Range};
use crate::growth::simple_schema::SimpleSchema;
use crate::num::ln;
use crate::word::{ActionId, ItemId, ItemSet, SignedItems};

/// The cost of one action; unreliability adds to it.
const STEP: u16 = 100;
/// An estimate for what cannot be reached.
const UNREACHABLE: u16 = u16::MAX;
/// The longest plan that is kept.
const PLAN: usize = 32;

/// How the planner searches.
///
/// ```
/// assert!(cla_core::growth::PlannerConfig::DEFAULT.reliable > 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannerConfig {
    /// Schemas below this reliability predict nothing, in `[0, 1]`.
    pub reliable: f32,
    /// Schemas with fewer trials predict nothing.
    pub trials: u16,
    /// Number of primitive actions.
    pub actions: u8,
}

impl PlannerConfig {
    /// Ten actions, schemas that hold nine times in ten.
    pub const DEFAULT: Self = Self {
        reliable: 0.9,
        trials: 1,
        actions: 10,
    };
}

impl Config for PlannerConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::SHARE.check("PlannerConfig::reliable", self.reliable)?;
        Range::AT_LEAST_ONE.check("PlannerConfig::actions", f32::from(self.actions))
    }
}

/// A state on the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Node<const WORDS: usize> {
    on: ItemSet<WORDS>,
    /// Cost so far.
    cost: u16,
    /// Estimated cost to the goal.
    rest: u16,
    parent: u16,
    action: u8,
    open: bool,
}

/// A planner and its memory.
///
/// In the field: best-first search over predicted states.
///
/// ```
/// use cla_core::growth::{Planner, PlannerConfig, SimpleSchema};
/// use cla_core::word::{ItemSet, SchemaText, SignedItems, Vocabulary};
/// let words = Vocabulary { items: &["a", "b", "c"], actions: &["walk", "leap"] };
/// let schemas = ["+a/walk/+b", "+b/leap/+c"]
///     .map(|text| SimpleSchema::pack(&SchemaText::<1>::parse(text, &words).unwrap()).unwrap());
/// let mut planner = Planner::<1, 3, 16>::new();
/// planner.see(&ItemSet::first(3)); // all three may be on at once
/// let config = PlannerConfig { trials: 0, ..PlannerConfig::DEFAULT };
/// let mut goal = SignedItems::EMPTY;
/// goal.insert(words.item("c").unwrap(), true)?;
/// let walk = planner.next_action(&goal, &ItemSet::first(1), &schemas, &config);
/// assert_eq!(walk, words.action("walk"));
/// let leap = planner.next_action(&goal, &ItemSet::first(2), &schemas, &config);
/// assert_eq!(leap, words.action("leap"));
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Debug)]
pub struct Planner<const WORDS: usize, const ITEMS: usize, const NODES: usize> {
    nodes: heapless::Vec<Node<WORDS>, NODES, u16>,
    /// For each item, the items that were on together with it.
    together: [ItemSet<WORDS>; ITEMS],
    /// Actions to do, the next one last.
    plan: heapless::Vec<u8, PLAN, u8>,
    /// What the last action was done in, what it is, and what was expected of it.
    expected: Option<(ItemSet<WORDS>, ActionId, ItemSet<WORDS>)>,
    suspended: heapless::Vec<SimpleSchema, 16, u8>,
}

impl<const WORDS: usize, const ITEMS: usize, const NODES: usize> Planner<WORDS, ITEMS, NODES> {
    /// A planner that has seen nothing: it refuses every state with two items on.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(ITEMS <= WORDS * 32, "an item needs a bit: 32 for each word");
            assert!(NODES > 1 && NODES < u16::MAX as usize, "2 to 65,534 nodes");
        }
        Self {
            nodes: heapless::Vec::new(),
            together: [ItemSet::EMPTY; ITEMS],
            plan: heapless::Vec::new(),
            expected: None,
            suspended: heapless::Vec::new(),
        }
    }

    /// Notes which items are on together.
    pub fn see(&mut self, on: &ItemSet<WORDS>) {
        for item in on.iter() {
            if let Some(row) = self.together.get_mut(usize::from(item.0)) {
                *row = row.union(on);
            }
        }
    }

    /// Begins a new attempt: no plan, no schema suspended.
    pub fn begin(&mut self) {
        self.plan.clear();
        self.expected = None;
        self.suspended.clear();
    }

    /// The next action towards the goal; `None` when the search finds no way.
    ///
    /// Call it before every action of an attempt with what is on then: a plan is kept as long as
    /// everything comes as expected.
    pub fn next_action(
        &mut self,
        goal: &SignedItems<WORDS>,
        on: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
        config: &PlannerConfig,
    ) -> Option<ActionId> {
        if let Some((before, action, after)) = self.expected
            && after != *on
        {
            self.plan.clear();
            self.suspend(&before, action, on, schemas);
        }
        if self.plan.is_empty() {
            self.search(goal, on, schemas, config);
        }
        let action = ActionId(self.plan.pop()?.into());
        let (after, _) = self.predict(on, action, schemas, config);
        self.expected = Some((*on, action, after));
        Some(action)
    }

    /// What the brain expects to be on when it has reached the goal, following its own predictions
    /// all the way; `None` when it sees no way.
    ///
    /// Begins a new attempt.
    pub fn foresee(
        &mut self,
        goal: &SignedItems<WORDS>,
        on: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
        config: &PlannerConfig,
    ) -> Option<ItemSet<WORDS>> {
        let mut expected = *on;
        self.begin();
        for _ in 0..PLAN {
            if holds(goal, &expected) {
                return Some(expected);
            }
            let action = self.next_action(goal, &expected, schemas, config)?;
            expected = self.predict(&expected, action, schemas, config).0;
        }
        None
    }

    /// Suspends the schemas that promised something else.
    fn suspend(
        &mut self,
        before: &ItemSet<WORDS>,
        action: ActionId,
        after: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
    ) {
        let wrong = schemas
            .iter()
            .filter(|it| it.action() == action && it.applies(before) && !it.succeeds(after));
        for schema in wrong {
            push_out(&mut self.suspended, *schema);
        }
    }

    fn trusts(&self, schema: &SimpleSchema, config: &PlannerConfig) -> bool {
        schema.reliability() >= config.reliable
            && schema.activations() >= config.trials
            && !self.suspended.iter().any(|it| it.says_as(schema))
    }

    /// What an action leads to, and the least reliability among the schemas that say so.
    ///
    /// Of two that contradict each other the one with more successes is believed.
    fn predict(
        &self,
        on: &ItemSet<WORDS>,
        action: ActionId,
        schemas: &[SimpleSchema],
        config: &PlannerConfig,
    ) -> (ItemSet<WORDS>, f32) {
        let mut after = *on;
        let mut least = 1.0;
        let mut stay = [[0_u16; 32]; WORDS];
        let mut change = [[0_u16; 32]; WORDS];
        for schema in schemas.iter().filter(|it| it.action() == action) {
            if !schema.applies(on) || !self.trusts(schema, config) {
                continue;
            }
            let votes = if schema.succeeds(on) {
                &mut stay
            } else {
                &mut change
            };
            let slot = votes
                .as_flattened_mut()
                .get_mut(usize::from(schema.result_item().0));
            let Some(most) = slot else { continue };
            *most = schema.successes().saturating_add(1).max(*most);
            if !schema.succeeds(on) {
                let trials = f32::from(schema.activations());
                let reliability = (f32::from(schema.successes()) + 1.0) / (trials + 2.0);
                if reliability < least {
                    least = reliability;
                }
            }
        }
        let votes = change.as_flattened().iter().zip(stay.as_flattened());
        for (item, (&change, &stay)) in (0_u16..).zip(votes) {
            if change > stay {
                let item = ItemId(item);
                if on.contains(item) {
                    after.remove(item);
                } else {
                    // The item came from a set of this capacity.
                    let _ = after.insert(item);
                }
            }
        }
        (after, least)
    }

    /// Whether all items of a state have been seen together, two by two.
    fn plausible(&self, on: &ItemSet<WORDS>) -> bool {
        on.iter().all(|item| {
            let row = self.together.get(usize::from(item.0));
            row.is_some_and(|row| on.is_subset(row))
        })
    }

    fn search(
        &mut self,
        goal: &SignedItems<WORDS>,
        on: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
        config: &PlannerConfig,
    ) {
        self.nodes.clear();
        let rest = self.estimate(goal, on, schemas, config);
        self.remember(on, 0, rest, 0, u8::MAX);
        while let Some(here) = self.most_promising() {
            let Some(node) = self.nodes.get_mut(usize::from(here)) else {
                return;
            };
            node.open = false;
            let node = *node;
            if holds(goal, &node.on) {
                self.trace_back(here);
                return;
            }
            for action in 0..config.actions {
                if self.nodes.is_full() {
                    break;
                }
                let (next, reliability) =
                    self.predict(&node.on, ActionId(action.into()), schemas, config);
                if next == node.on || !self.plausible(&next) {
                    continue;
                }
                let risk = -300.0 * ln(reliability);
                let cost = node.cost.saturating_add(STEP).saturating_add(risk as u16);
                let same = |other: &Node<WORDS>| other.on == next;
                if let Some(old) = self.nodes.iter_mut().find(|it| same(it)) {
                    if old.open && cost < old.cost {
                        old.cost = cost;
                        old.parent = here;
                        old.action = action;
                    }
                    continue;
                }
                let rest = self.estimate(goal, &next, schemas, config);
                if rest != UNREACHABLE {
                    self.remember(&next, cost, rest, here, action);
                }
            }
        }
        // No way was found: go where the goal seems nearest, and learn on the way what fails.
        let nearest = (0_u16..)
            .zip(&self.nodes)
            .min_by_key(|(_, node)| (node.rest, node.cost));
        if let Some((index, _)) = nearest {
            self.trace_back(index);
        }
    }

    fn remember(&mut self, on: &ItemSet<WORDS>, cost: u16, rest: u16, parent: u16, action: u8) {
        // A full search goes on with the states that it has.
        let _ = self.nodes.push(Node {
            on: *on,
            cost,
            rest,
            parent,
            action,
            open: true,
        });
    }

    fn most_promising(&self) -> Option<u16> {
        let mut best: Option<(u16, u16)> = None;
        for (index, node) in (0_u16..).zip(&self.nodes) {
            let total = node.cost.saturating_add(node.rest);
            if node.open && best.is_none_or(|(least, _)| total < least) {
                best = Some((total, index));
            }
        }
        best.map(|(_, index)| index)
    }

    fn trace_back(&mut self, end: u16) {
        let mut at = end;
        // Parents were stored before their children, so the way back ends at node 0.
        while at != 0 {
            let Some(node) = self.nodes.get(usize::from(at)).copied() else {
                return;
            };
            // The far end of a plan that is too long is found again on the way.
            push_out(&mut self.plan, node.action);
            at = node.parent;
        }
    }

    /// The cost of the goal if nothing ever turned an item back: each signed item costs one step
    /// more than all context items of its cheapest schema together.
    fn estimate(
        &self,
        goal: &SignedItems<WORDS>,
        on: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
        config: &PlannerConfig,
    ) -> u16 {
        let mut costs = [[[UNREACHABLE; 32]; WORDS]; 2];
        let place = |costs: &mut [[[u16; 32]; WORDS]; 2], item: ItemId, sign: bool, cost: u16| {
            let [off, of_on] = costs;
            let side = if sign { of_on } else { off };
            match side.as_flattened_mut().get_mut(usize::from(item.0)) {
                Some(old) if cost < *old => {
                    *old = cost;
                    true
                }
                _ => false,
            }
        };
        let read = |costs: &[[[u16; 32]; WORDS]; 2], item: ItemId, sign: bool| {
            let [off, of_on] = costs;
            let side = if sign { of_on } else { off };
            side.as_flattened()
                .get(usize::from(item.0))
                .copied()
                .unwrap_or(UNREACHABLE)
        };
        for item in 0..ITEMS as u16 {
            place(&mut costs, ItemId(item), on.contains(ItemId(item)), 0);
        }
        // As many sweeps as a plan may be long.
        for _ in 0..PLAN {
            let mut changed = false;
            for schema in schemas {
                let result = read(&costs, schema.result_item(), schema.result_sign());
                if result <= STEP || !self.trusts(schema, config) {
                    continue;
                }
                let mut cost = STEP;
                for (item, sign) in schema.context() {
                    cost = cost.saturating_add(read(&costs, item, sign));
                }
                if cost < result {
                    changed |= place(&mut costs, schema.result_item(), schema.result_sign(), cost);
                }
            }
            if !changed {
                break;
            }
        }
        let mut total = 0_u16;
        for item in goal.positive().iter() {
            total = total.saturating_add(read(&costs, item, true));
        }
        for item in goal.negative().iter() {
            total = total.saturating_add(read(&costs, item, false));
        }
        total
    }
}

impl<const WORDS: usize, const ITEMS: usize, const NODES: usize> Default
    for Planner<WORDS, ITEMS, NODES>
{
    fn default() -> Self {
        Self::new()
    }
}

/// Appends an element; a full vector loses its first.
fn push_out<T, const N: usize>(vec: &mut heapless::Vec<T, N, u8>, element: T) {
    if let Err(mut shifted) = vec.push(element) {
        for slot in vec.iter_mut().rev() {
            core::mem::swap(slot, &mut shifted);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Planner, PlannerConfig};
    use crate::growth::{SimpleSchema, chain_backward};
    use crate::word::{ActionId, ItemId, ItemSet, SchemaText, SignedItems, Vocabulary};

    /// To eat one needs bread in hand at the table; the bread lies on the shelf.
    const WORDS: Vocabulary = Vocabulary {
        items: &["shelf", "table", "bread", "eaten"],
        actions: &["walk", "take", "eat"],
    };
    const CONFIG: PlannerConfig = PlannerConfig {
        reliable: 0.9,
        trials: 0,
        actions: 3,
    };

    fn schemas() -> std::vec::Vec<SimpleSchema> {
        [
            "+shelf/walk/+table",
            "+shelf/walk/-shelf",
            "+table/walk/+shelf",
            "+table/walk/-table",
            "+shelf/take/+bread",
            "+table+bread/eat/+eaten",
        ]
        .map(|text| SimpleSchema::pack(&SchemaText::<1>::parse(text, &WORDS).unwrap()).unwrap())
        .to_vec()
    }

    fn set(names: &[&str]) -> ItemSet<1> {
        let mut set = ItemSet::EMPTY;
        for name in names {
            set.insert(WORDS.item(name).unwrap()).unwrap();
        }
        set
    }

    fn goal() -> SignedItems<1> {
        let mut goal = SignedItems::EMPTY;
        goal.insert(ItemId(3), true).unwrap();
        goal
    }

    fn experienced() -> Planner<1, 4, 32> {
        let mut planner = Planner::new();
        planner.see(&set(&["shelf", "bread"]));
        planner.see(&set(&["table", "bread", "eaten"]));
        planner
    }

    #[test]
    fn the_search_fetches_the_bread_where_the_chain_goes_to_the_table_without_it() {
        let schemas = schemas();
        assert_eq!(
            chain_backward(&goal(), &set(&["shelf"]), &schemas, 0.9),
            WORDS.action("walk")
        );
        let mut planner = experienced();
        let mut on = set(&["table"]);
        let mut done = std::vec::Vec::new();
        while !on.contains(ItemId(3)) {
            let action = planner
                .next_action(&goal(), &on, &schemas, &CONFIG)
                .unwrap();
            done.push(WORDS.action_name(action));
            on = planner.predict(&on, action, &schemas, &CONFIG).0;
        }
        assert_eq!(done, ["walk", "take", "walk", "eat"]);
    }

    #[test]
    fn a_state_with_items_never_seen_together_is_no_way() {
        let mut planner = Planner::<1, 4, 32>::new();
        planner.see(&set(&["shelf", "bread"]));
        let here = set(&["table", "bread"]);
        let expected = planner.foresee(&goal(), &here, &schemas(), &CONFIG);
        assert_eq!(expected, None, "eaten was never seen with table and bread");
        let meal = set(&["table", "bread", "eaten"]);
        let expected = experienced().foresee(&goal(), &here, &schemas(), &CONFIG);
        assert_eq!(expected, Some(meal));
    }

    #[test]
    fn a_full_memory_loses_what_is_oldest() {
        let mut vec = heapless::Vec::<u8, 3, u8>::new();
        for element in 1..=5 {
            super::push_out(&mut vec, element);
        }
        assert_eq!(vec, [3, 4, 5]);
    }

    #[test]
    fn a_schema_that_fails_is_not_tried_twice_in_one_attempt() {
        let (schemas, mut planner) = (schemas(), experienced());
        let here = set(&["table", "bread"]);
        let first = planner.next_action(&goal(), &here, &schemas, &CONFIG);
        assert_eq!(first, Some(ActionId(2)));
        // Eating did not work.
        let second = planner.next_action(&goal(), &here, &schemas, &CONFIG);
        assert_ne!(second, Some(ActionId(2)));
        planner.begin();
        assert_eq!(
            planner.next_action(&goal(), &here, &schemas, &CONFIG),
            Some(ActionId(2))
        );
    }
}

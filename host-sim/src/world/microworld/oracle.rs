//! The truth about the Microworld: every reachable state and what every action does there.
//!
//! Judges schemas: how often they apply, how reliable they truly are, how much of all that changes
//! they predict (recall) and how much of what they predict comes (precision).
//! States count alike; the agent never reads any of this.

use std::collections::BTreeMap;

use cla_core::word::{ActionId, ItemId, SchemaText, SignedItems};
use serde::{Deserialize, Serialize};

use super::items::{self, ACTIONS, Family, ITEMS, Items, WORDS};
use super::state::{Body, Cell, Hand, State};

/// A set of the oracle's states.
///
/// ```
/// use host_sim::world::microworld::{Body, Oracle};
/// let oracle = Oracle::new(Body::Visible);
/// assert_eq!(oracle.all().len(), 1539);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StateSet(Vec<u64>);

impl StateSet {
    fn empty(states: usize) -> Self {
        Self(vec![0; states.div_ceil(64)])
    }

    fn insert(&mut self, state: usize) {
        self.0[state / 64] |= 1 << (state % 64);
    }

    /// Whether a state is in the set.
    #[must_use]
    pub fn contains(&self, state: usize) -> bool {
        self.0[state / 64] >> (state % 64) & 1 == 1
    }

    /// The number of states in the set.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether no state is in the set.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.iter().all(|&word| word == 0)
    }

    fn combine(&mut self, other: &Self, with: impl Fn(u64, u64) -> u64) {
        for (word, &theirs) in self.0.iter_mut().zip(&other.0) {
            *word = with(*word, theirs);
        }
    }

    /// Keeps the states that are in the other set too.
    pub fn keep(&mut self, other: &Self) {
        self.combine(other, |a, b| a & b);
    }

    fn remove(&mut self, other: &Self) {
        self.combine(other, |a, b| a & !b);
    }

    /// Adds the states of the other set.
    pub fn add(&mut self, other: &Self) {
        self.combine(other, |a, b| a | b);
    }
}

/// How much of what happens a set of schemas predicts.
///
/// ```
/// let it = host_sim::world::microworld::Recall::default();
/// assert_eq!((it.total(), it.precision()), (0.0, 0.0));
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Recall {
    /// For every family, the changes that were predicted and all changes.
    pub families: BTreeMap<Family, (usize, usize)>,
    /// Changes that were predicted but do not come.
    pub wrong: usize,
}

impl Recall {
    /// The share of all changes that are predicted, in `[0, 1]`.
    #[must_use]
    pub fn total(&self) -> f64 {
        let (hits, all) = self.sum();
        share(hits, all)
    }

    /// The share of one family's changes that are predicted, in `[0, 1]`.
    #[must_use]
    pub fn of(&self, family: Family) -> f64 {
        let (hits, all) = self.families.get(&family).copied().unwrap_or_default();
        share(hits, all)
    }

    /// The share of the predicted changes that come, in `[0, 1]`; 0 when none is predicted.
    #[must_use]
    pub fn precision(&self) -> f64 {
        let (hits, _) = self.sum();
        share(hits, hits + self.wrong)
    }

    fn sum(&self) -> (usize, usize) {
        self.families
            .values()
            .fold((0, 0), |sum, it| (sum.0 + it.0, sum.1 + it.1))
    }
}

/// All reachable states, all transitions.
///
/// ```
/// use cla_core::word::SchemaText;
/// use host_sim::world::microworld::{Body, Oracle, VOCABULARY};
/// let oracle = Oracle::new(Body::Visible);
/// let schema = SchemaText::parse("+text1+text3/grasp/+hcl+hgr", &VOCABULARY)?;
/// let reliability = oracle.reliability(&schema).unwrap();
/// assert!((reliability - 2.0 / 3.0).abs() < 1e-9); // a fist on the ball does not grip it
/// # Ok::<(), cla_core::word::NotationError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Oracle {
    states: Vec<State>,
    index: BTreeMap<State, usize>,
    items: Vec<Items>,
    /// `successors[state][action]`.
    successors: Vec<[usize; ACTIONS.len()]>,
    /// The states in which each item is on.
    on: Vec<StateSet>,
    /// `on_after[action][item]`: the states from which the item is on after the action.
    on_after: Vec<Vec<StateSet>>,
}

impl Oracle {
    /// Explores everything that the ten actions can reach from a start of the book.
    #[must_use]
    pub fn new(body: Body) -> Self {
        let start = State {
            hand_at: Cell { x: 0, y: 0 },
            eye_at: Cell { x: 0, y: 0 },
            ball_at: Cell { x: 1, y: 1 },
            hand: Hand::Open,
        };
        let mut states = vec![start];
        let mut index = BTreeMap::from([(start, 0)]);
        let mut successors = Vec::new();
        while let Some(&state) = states.get(successors.len()) {
            successors.push(std::array::from_fn(|action| {
                let next = state.after(action);
                *index.entry(next).or_insert_with(|| {
                    states.push(next);
                    states.len() - 1
                })
            }));
        }
        let items: Vec<Items> = states.iter().map(|it| items::perceive(it, body)).collect();
        let count = states.len();
        let mut on = vec![StateSet::empty(count); ITEMS.len()];
        let mut on_after = vec![on.clone(); ACTIONS.len()];
        for (state, its) in items.iter().enumerate() {
            for item in its.iter() {
                on[usize::from(item.0)].insert(state);
            }
            for (action, &next) in successors[state].iter().enumerate() {
                for item in items[next].iter() {
                    on_after[action][usize::from(item.0)].insert(state);
                }
            }
        }
        Self {
            states,
            index,
            items,
            successors,
            on,
            on_after,
        }
    }

    /// All reachable states; a state's number is its index here.
    #[must_use]
    pub fn states(&self) -> &[State] {
        &self.states
    }

    /// The number of a state; `None` when it cannot be reached.
    #[must_use]
    pub fn index(&self, state: &State) -> Option<usize> {
        self.index.get(state).copied()
    }

    /// The items that are on in a state.
    ///
    /// # Panics
    /// When there is no such state.
    #[must_use]
    pub fn items(&self, state: usize) -> &Items {
        &self.items[state]
    }

    /// The number of the state that an action leads to.
    ///
    /// # Panics
    /// When there is no such state or action.
    #[must_use]
    pub fn successor(&self, state: usize, action: usize) -> usize {
        self.successors[state][action]
    }

    /// All states.
    #[must_use]
    pub fn all(&self) -> StateSet {
        let mut set = StateSet::empty(self.states.len());
        (0..self.states.len()).for_each(|state| set.insert(state));
        set
    }

    /// No state.
    #[must_use]
    pub fn nowhere(&self) -> StateSet {
        StateSet::empty(self.states.len())
    }

    /// The states in which a schema of a primitive action applies and its result holds afterwards.
    ///
    /// # Panics
    /// When the action is not a primitive one.
    #[must_use]
    pub fn where_succeeds(&self, schema: &SchemaText<WORDS>) -> StateSet {
        let on_after = &self.on_after[usize::from(schema.action.0)];
        self.filter(self.where_holds(&schema.context), &schema.result, on_after)
    }

    /// The states, by number, of which something is true.
    #[must_use]
    pub fn states_where(&self, is_so: impl Fn(usize) -> bool) -> StateSet {
        let mut set = self.nowhere();
        (0..self.states.len())
            .filter(|&state| is_so(state))
            .for_each(|state| set.insert(state));
        set
    }

    /// The states in which a conjunction holds.
    #[must_use]
    pub fn where_holds(&self, items: &SignedItems<WORDS>) -> StateSet {
        self.filter(self.all(), items, &self.on)
    }

    fn filter(&self, mut set: StateSet, items: &SignedItems<WORDS>, on: &[StateSet]) -> StateSet {
        for item in items.positive().iter() {
            set.keep(&on[usize::from(item.0)]);
        }
        for item in items.negative().iter() {
            set.remove(&on[usize::from(item.0)]);
        }
        set
    }

    /// The share of the states where a schema of a primitive action applies in which its result
    /// holds afterwards; `None` when it applies nowhere.
    ///
    /// # Panics
    /// When the action is not a primitive one.
    #[must_use]
    pub fn reliability(&self, schema: &SchemaText<WORDS>) -> Option<f64> {
        let all = self.where_holds(&schema.context).len();
        let successes = self.where_succeeds(schema).len();
        (all > 0).then(|| share(successes, all))
    }

    /// What schemas of a true reliability of at least `threshold` predict: the book's knowledge,
    /// with the unreliable taken out by the truth.
    #[must_use]
    pub fn recall(&self, schemas: &[SchemaText<WORDS>], threshold: f64) -> Recall {
        let reliable: Vec<_> = schemas
            .iter()
            .filter(|it| self.reliability(it).is_some_and(|r| r >= threshold))
            .copied()
            .collect();
        self.predicted(&reliable)
    }

    /// What all of these schemas together predict, right and wrong.
    ///
    /// Only changes count: that something stays as it is needs no schema.
    #[must_use]
    pub fn predicted(&self, schemas: &[SchemaText<WORDS>]) -> Recall {
        let mut recall = Recall::default();
        for action in 0..ACTIONS.len() {
            let nothing = self.nowhere();
            let mut turned = vec![[nothing.clone(), nothing.clone()]; ITEMS.len()];
            let own = schemas
                .iter()
                .filter(|it| usize::from(it.action.0) == action);
            for schema in own {
                let applicable = self.where_holds(&schema.context);
                for item in schema.result.positive().iter() {
                    turned[usize::from(item.0)][1].add(&applicable);
                }
                for item in schema.result.negative().iter() {
                    turned[usize::from(item.0)][0].add(&applicable);
                }
            }
            for (item, [off, on]) in turned.into_iter().enumerate() {
                let family = Family::of(ActionId(action as u16), ItemId(item as u16));
                let entry = recall.families.entry(family).or_default();
                for (predicted, to_on) in [(off, false), (on, true)] {
                    let mut changes = self.all();
                    let (before, after) = (&self.on[item], &self.on_after[action][item]);
                    let mut candidates = predicted;
                    if to_on {
                        changes.remove(before);
                        candidates.remove(before);
                        changes.keep(after);
                    } else {
                        changes.keep(before);
                        candidates.keep(before);
                        changes.remove(after);
                    }
                    let all = candidates.len();
                    candidates.keep(&changes);
                    entry.0 += candidates.len();
                    entry.1 += changes.len();
                    recall.wrong += all - candidates.len();
                }
            }
        }
        recall
    }
}

fn share(part: usize, whole: usize) -> f64 {
    if whole == 0 {
        0.0
    } else {
        part as f64 / whole as f64
    }
}

#[cfg(test)]
mod tests {
    use super::{Body, Family, Oracle};
    use crate::world::microworld::{ITEMS, VOCABULARY};
    use cla_core::word::SchemaText;
    use std::collections::BTreeSet;

    #[test]
    fn there_are_1539_states_and_no_two_look_alike() {
        for body in [Body::Visible, Body::Hidden] {
            let oracle = Oracle::new(body);
            let distinct: BTreeSet<_> = oracle.items.iter().collect();
            assert_eq!((oracle.states.len(), distinct.len()), (1539, 1539));
        }
    }

    #[test]
    fn eleven_items_are_never_on() {
        let oracle = Oracle::new(Body::Visible);
        let never: Vec<_> = (0..ITEMS.len())
            .filter(|&item| oracle.on[item].is_empty())
            .map(|item| ITEMS[item])
            .collect();
        assert_eq!(never.len(), 11, "{never:?}");
    }

    #[test]
    fn two_schemas_recall_exactly_what_they_say() {
        let oracle = Oracle::new(Body::Visible);
        let parse = |text| SchemaText::parse(text, &VOCABULARY).unwrap();
        let schemas = [parse("+vp23/eyer/+vp33"), parse("+vp23/eyer/-vp23")];
        let recall = oracle.predicted(&schemas);
        // 2 of the 48 changes of the eye (12 moves, one item on and one off, each way).
        let eye = recall.of(Family::EyeProprioception);
        assert!((eye - 2.0 / 48.0).abs() < 1e-9, "{eye}");
        assert_eq!((recall.wrong, recall.of(Family::Touch)), (0, 0.0));
        let wrong = oracle.predicted(&[parse("/eyer/+vp33")]);
        assert!(wrong.precision() < 0.5);
    }

    #[test]
    fn equation_5_30_holds_in_one_state_and_is_certain_there() {
        let oracle = Oracle::new(Body::Visible);
        let text = "+hp22+vp22+text1+text3+hcl+hgr+vf22+fovx1+fovx2/handb/+hp21-hp22+bodyf+taste1\
                    +taste3+vf21-vf22+fovb1+fovb2-fovx1-fovx2";
        let schema = SchemaText::parse(text, &VOCABULARY).unwrap();
        assert_eq!(oracle.where_holds(&schema.context).len(), 1);
        assert_eq!(oracle.reliability(&schema), Some(1.0));
    }
}

//! Synthetic items of the Microworld: persistent objects that are known without looking (book,
//! 5.1.1, 5.4.3: 5.34 and 5.35; after Drescher).
//!
//! Reified is what is unreliable: touches and tastes that an action may or may not bring, and what
//! the maps of level 2 say may be found where a composite action ends.
//! A life of random primitive and composite actions labels samples in hindsight and grows schemas of
//! one action about the items of another; the oracle judges them.

use cla_core::growth::{
    Accommodation, AccommodationConfig, GrowthConfig, HindsightSample, SimpleSchema, SyntheticItems,
};
use cla_core::num::Rng;
use cla_core::word::{ActionId, ItemId, ItemStates, SchemaText, SignedItems};
use serde::{Deserialize, Serialize};

use super::goals::{Chains, STEP_LIMIT};
use super::level1::{ACTION_COUNT, ITEM_COUNT};
use super::level2::{GOALS, end_of};
use super::picture;
use crate::world::microworld::{Cell, Items, Oracle, REACH, State, StateSet, item, set_of};

/// Words of a set with the 76 primitive items and room for 178 synthetic ones.
pub const WIDE: usize = 8;
/// The synthetic items.
pub type Synthetic = SyntheticItems<WIDE, 178>;
/// What is remembered of each primitive action, and the schemas about synthetic items.
pub type Memory = Accommodation<WIDE, 384, 2048, ACTION_COUNT, HindsightSample<WIDE>>;
/// What the literal rule gets to learn in.
type LiteralMemory = Accommodation<WIDE, 64, 512, ACTION_COUNT, HindsightSample<WIDE>>;

/// Random primitive actions that show which touches are unreliable.
pub const LOOKING: u32 = 5_000;
/// Composite actions of the life.
pub const COMPOSITES: u32 = 20_000;
/// At most so many random primitive actions before each, at least one.
const BETWEEN: u32 = 4;
/// From this reliability on the agent believes a schema about a synthetic item.
const RELIABLE: f32 = 0.9;
/// And after so many trials: few of its activations are labelled, and what was known may be stale.
pub const TRIALS: u16 = 10;

/// What is known then may be stale, so schemas about synthetic items may fail now and then.
const CONFIG_OF_GROWTH: AccommodationConfig = AccommodationConfig {
    growth: GrowthConfig {
        support: 2,
        tolerance: 0.05,
        attention: 0.0,
        ..GrowthConfig::EXACT
    },
    keep: 0.9,
    grace: 1,
    revisits: 1,
    untested: 0,
    ..AccommodationConfig::EXACT
};

/// What a life with synthetic items showed.
///
/// ```
/// let it = host_sim::experiment::microworld::synthetic::Findings::default();
/// assert_eq!(it.schemas, 0);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Findings {
    /// Synthetic items.
    pub items: usize,
    /// Believed schemas with a synthetic item of another action in their result, on.
    pub schemas: usize,
    /// Their mean true reliability.
    pub reliability: f64,
    /// The same count where an item is on only right after its own schema succeeded.
    pub literal: usize,
    /// Of the items whose context holds, the share that was known, over the life's second half.
    pub known: f64,
    /// Of those, the share that was known rightly.
    pub right: f64,
    /// Composite actions at the end of the life: the action, the world after it, and where the ball
    /// is believed to be felt.
    pub pictures: Vec<[String; 3]>,
}

/// Composite actions that are pictured.
const PICTURED: usize = 12;

/// A life with synthetic items.
pub struct Believer<'a> {
    oracle: &'a Oracle,
    state: State,
    items: Synthetic,
    memory: Box<Memory>,
    literal: Box<LiteralMemory>,
    /// What the literal rule says is on now.
    literally_on: ItemStates<WIDE>,
    waiting: Option<(ActionId, HindsightSample<WIDE>)>,
    rng: Rng,
}

impl<'a> Believer<'a> {
    /// Looks around for a while, and reifies what is unreliable; `objects` come from level 2.
    #[must_use]
    pub fn new(seed: u64, oracle: &'a Oracle, objects: &[(usize, u16)]) -> Self {
        let mut rng = Rng::stream(seed, 59);
        let states = oracle.states();
        let mut it = Self {
            oracle,
            state: states[rng.below(states.len() as u32) as usize],
            items: Synthetic::new(ITEM_COUNT as u16),
            memory: Box::default(),
            literal: Box::default(),
            literally_on: ItemStates::UNKNOWN,
            waiting: None,
            rng,
        };
        for schema in it.unreliable_touches() {
            it.items.reify(&schema).expect("room for every touch");
        }
        for &(composite, found) in objects {
            let place = item(GOALS[composite]).expect("a goal is an item");
            let schema = schema(&[], composite_action(composite), &[place, ItemId(found)]);
            // More than fit are left out, the last ones first.
            let _ = it.items.reify(&schema);
        }
        it
    }

    /// `-item/action/+item` for every touch or taste that an action brought and did not always bring;
    /// the ball's second details come and go with its first and would say the same again.
    fn unreliable_touches(&mut self) -> Vec<SchemaText<WIDE>> {
        let touches = set_of(&["tact", "text1", "body", "taste1", "hgr"]);
        let mut counts = vec![[(0_u32, 0_u32); ITEM_COUNT]; ACTION_COUNT];
        for _ in 0..LOOKING {
            let action = self.rng.below(ACTION_COUNT as u32) as usize;
            let before = self.on();
            self.state = self.state.after(action);
            let after = self.on();
            for item in touches.difference(&before).iter() {
                let count = &mut counts[action][usize::from(item.0)];
                count.0 += 1;
                count.1 += u32::from(after.contains(item));
            }
        }
        let mut schemas = Vec::new();
        for (action, counts) in counts.iter().enumerate() {
            for (item, &(trials, successes)) in counts.iter().enumerate() {
                if successes >= 3 && 10 * successes < 9 * trials {
                    let item = ItemId(item as u16);
                    schemas.push(schema(&[item], ActionId(action as u16), &[item]));
                }
            }
        }
        schemas
    }

    /// Lives, and counts what was known in the second half.
    pub fn live(&mut self, chains: &mut Chains, composites: u32) -> Findings {
        let truth = Truth::of(self.oracle, &self.items);
        let (mut open, mut known, mut right) = (0_u64, 0_u64, 0_u64);
        let mut composite = 0;
        for round in 0..composites {
            for _ in 0..=self.rng.below(BETWEEN) {
                let action = self.rng.below(ACTION_COUNT as u32) as usize;
                self.primitive(ActionId(action as u16));
                if round >= composites / 2 {
                    let (sensed, view) = (self.sensed(), self.items.view(&self.sensed()));
                    let state = self.oracle.index(&self.state).expect("a reachable state");
                    let open_now = self.items.ids().difference(&self.items.ruled_out(&sensed));
                    for item in open_now.iter() {
                        open += 1;
                        if let Some(value) = view.get(item) {
                            known += 1;
                            right += u64::from(truth.is_on(item, state) == value);
                        }
                    }
                }
            }
            // Often the same again: what stays is seen only by looking twice.
            if self.rng.chance(0.5) {
                composite = self.rng.below(18) as usize;
            }
            self.composite(composite, chains);
        }
        let about_others = |schemas: &[SimpleSchema]| -> Vec<SimpleSchema> {
            let of_another = |it: &&SimpleSchema| {
                let about = self.items.get(it.result_item());
                it.result_sign() && about.is_some_and(|about| about.schema().action != it.action())
            };
            let believed =
                |it: &&SimpleSchema| it.activations() >= TRIALS && it.reliability() >= RELIABLE;
            let found = schemas.iter().filter(of_another).filter(believed);
            found.copied().collect()
        };
        let schemas = about_others(self.memory.schemas());
        let reliabilities = schemas.iter().filter_map(|it| truth.reliability(it));
        let share = |part: u64, whole: u64| part as f64 / whole.max(1) as f64;
        Findings {
            items: self.items.as_slice().len(),
            schemas: schemas.len(),
            reliability: reliabilities.sum::<f64>() / schemas.len().max(1) as f64,
            literal: about_others(self.literal.schemas()).len(),
            known: share(known, open),
            right: share(right, known),
            pictures: self.pictures(chains),
        }
    }

    /// A few composite actions more, each with what is there and what is believed at its end.
    fn pictures(&mut self, chains: &mut Chains) -> Vec<[String; 3]> {
        let mut pictures = Vec::new();
        for _ in 0..PICTURED {
            let composite = self.rng.below(18) as usize;
            self.composite(composite, chains);
            pictures.push([
                format!("<+{}>", GOALS[composite]),
                picture::world(&self.state),
                self.felt_ball(),
            ]);
        }
        pictures
    }

    /// For every cell of the reach, rows from the front, whether the palpable objects of level 2 say
    /// that the ball is there: `o` one does, `.` those that are known say no, `?` none is known.
    ///
    /// Nothing is sensed and nothing is foreseen for it: it is what the items remember.
    #[must_use]
    pub fn felt_ball(&self) -> String {
        const SIDES: [(&str, i8, i8); 5] = [
            ("tactf", 0, 1),
            ("tactb", 0, -1),
            ("tactr", 1, 0),
            ("tactl", -1, 0),
            ("text1", 0, 0),
        ];
        let view = self.items.view(&self.sensed());
        let mut cells = [[None; REACH as usize]; REACH as usize];
        for (id, about) in (self.items.first().0..)
            .map(ItemId)
            .zip(self.items.as_slice())
        {
            let composite = usize::from(about.schema().action.0).checked_sub(ACTION_COUNT);
            let Some(place) = composite.and_then(|it| Cell::all().take(9).nth(it)) else {
                continue;
            };
            let felt = about.schema().result.positive();
            let side = SIDES
                .into_iter()
                .find(|&(name, _, _)| item(name).is_some_and(|side| felt.contains(side)));
            let Some((_, dx, dy)) = side else { continue };
            let (x, y) = (
                place.x.wrapping_add_signed(dx),
                place.y.wrapping_add_signed(dy),
            );
            let row = cells.get_mut(usize::from(y));
            let cell = row.and_then(|row| row.get_mut(usize::from(x)));
            if let (Some(cell), Some(value)) = (cell, view.get(id)) {
                *cell = Some(cell.unwrap_or(false) || value);
            }
        }
        let mut text = String::new();
        for row in cells.iter().rev() {
            let marks = row.map(|cell| match cell {
                Some(true) => "o",
                Some(false) => ".",
                None => "?",
            });
            text.push_str(&marks.join(" "));
            text.push('\n');
        }
        text
    }

    /// The synthetic items.
    #[must_use]
    pub const fn items(&self) -> &Synthetic {
        &self.items
    }

    /// The schemas about them.
    #[must_use]
    pub fn schemas(&self) -> &[SimpleSchema] {
        self.memory.schemas()
    }

    fn on(&self) -> Items {
        let index = self.oracle.index(&self.state);
        *self.oracle.items(index.expect("a reachable state"))
    }

    fn sensed(&self) -> ItemStates<WIDE> {
        widened(&self.on())
    }

    /// One primitive action: labels the sample that waits, learns from it, and waits itself.
    fn primitive(&mut self, action: ActionId) {
        let before = self.items.view(&self.sensed());
        self.state = self.state.after(usize::from(action.0));
        let after = self.sensed();
        let revealed = self.items.revealed(&before, action, &after);
        if let Some((earlier, mut sample)) = self.waiting.take() {
            sample.label(&revealed);
            self.learn(earlier, &sample);
        }
        self.learn_literally(action, &after, &revealed);
        let sample = HindsightSample::waiting(&before, &after, &self.items);
        self.waiting = Some((action, sample));
        self.items.complete(&before, action, &after);
        let schemas = self.memory.schemas();
        self.items
            .expect(&sample, action, schemas, RELIABLE, TRIALS);
    }

    /// One composite action by the book's chain; when it reaches its goal it labels the sample that
    /// waited for it.
    fn composite(&mut self, composite: usize, chains: &mut Chains) {
        let action = composite_action(composite);
        let place = item(GOALS[composite]).expect("a goal is an item");
        let (waited, before) = (self.waiting, self.items.view(&self.sensed()));
        for _ in 0..STEP_LIMIT {
            if self.on().contains(place) {
                break;
            }
            let Some(next) = chains.next(composite, &self.state) else {
                return;
            };
            self.primitive(next);
        }
        if !self.on().contains(place) {
            return;
        }
        let after = self.sensed();
        if let Some((earlier, mut sample)) = waited {
            sample.label(&self.items.revealed(&before, action, &after));
            self.learn(earlier, &sample);
        }
        self.items.try_out(&before, action, &after);
    }

    fn learn(&mut self, action: ActionId, sample: &HindsightSample<WIDE>) {
        self.memory
            .observe(action, sample, &CONFIG_OF_GROWTH, &mut self.rng);
    }

    /// The book's rule: an item is on when its schema has just succeeded, and off otherwise.
    fn learn_literally(
        &mut self,
        action: ActionId,
        after: &ItemStates<WIDE>,
        revealed: &ItemStates<WIDE>,
    ) {
        let off = self.items.ids().difference(revealed.on());
        let literal = ItemStates::from_sets(revealed.on(), &off);
        let mut sample = HindsightSample::waiting(&self.literally_on, after, &self.items);
        sample.label(&literal);
        self.literal
            .observe(action, &sample, &CONFIG_OF_GROWTH, &mut self.rng);
        self.literally_on =
            ItemStates::from_sets(&after.on().union(revealed.on()), &after.off().union(&off));
    }
}

/// The number of a composite action among all actions.
#[must_use]
pub const fn composite_action(composite: usize) -> ActionId {
    ActionId((ACTION_COUNT + composite) as u16)
}

fn schema(off: &[ItemId], action: ActionId, on_after: &[ItemId]) -> SchemaText<WIDE> {
    let items = |items: &[ItemId], sign: bool| {
        let mut signed = SignedItems::EMPTY;
        for &item in items {
            signed.insert(item, sign).expect("room for all items");
        }
        signed
    };
    SchemaText {
        context: items(off, false),
        action,
        result: items(on_after, true),
    }
}

/// A percept in sets that have room for synthetic items.
#[must_use]
pub fn widened(on: &Items) -> ItemStates<WIDE> {
    let mut states = ItemStates::all_off(ITEM_COUNT as u16);
    for item in on.iter() {
        states.set(item, Some(true)).expect("room for all items");
    }
    states
}

/// In which states each item, synthetic ones included, is truly on.
pub struct Truth {
    on: Vec<StateSet>,
    /// `successors[action][state]`.
    successors: Vec<Vec<usize>>,
}

impl Truth {
    /// Asks the oracle what would happen.
    #[must_use]
    pub fn of(oracle: &Oracle, items: &Synthetic) -> Self {
        let states = oracle.states();
        let index = |state: State| oracle.index(&state).expect("a reachable state");
        let successors: Vec<Vec<usize>> = (0..ACTION_COUNT)
            .map(|action| states.iter().map(|it| index(it.after(action))).collect())
            .collect();
        let ends: Vec<Vec<usize>> = (0..18)
            .map(|composite| {
                states
                    .iter()
                    .map(|&it| index(end_of(composite, it)))
                    .collect()
            })
            .collect();
        let mut on: Vec<StateSet> = Vec::new();
        for item in (0..ITEM_COUNT as u16).map(ItemId) {
            on.push(oracle.states_where(|state| oracle.items(state).contains(item)));
        }
        let wide: Vec<ItemStates<WIDE>> = (0..states.len())
            .map(|state| widened(oracle.items(state)))
            .collect();
        for item in items.as_slice() {
            let action = usize::from(item.schema().action.0);
            let end = successors.iter().chain(&ends).nth(action);
            let end = end.expect("a primitive or composite action");
            on.push(oracle.states_where(|state| {
                item.tried(&wide[state], item.schema().action, &wide[end[state]]) == Some(true)
            }));
        }
        Self { on, successors }
    }

    /// Whether an item is on in a state.
    #[must_use]
    pub fn is_on(&self, item: ItemId, state: usize) -> bool {
        self.on[usize::from(item.0)].contains(state)
    }

    /// The share of the states where a schema of a primitive action applies in which its result
    /// item is what it says afterwards; `None` when it applies nowhere.
    #[must_use]
    pub fn reliability(&self, schema: &SimpleSchema) -> Option<f64> {
        let applies = |&state: &usize| {
            schema
                .context()
                .all(|(item, sign)| self.is_on(item, state) == sign)
        };
        let next = &self.successors[usize::from(schema.action().0)];
        let (mut all, mut came) = (0_u32, 0_u32);
        for state in (0..next.len()).filter(applies) {
            all += 1;
            let on = self.is_on(schema.result_item(), next[state]);
            came += u32::from(on == schema.result_sign());
        }
        (all > 0).then(|| f64::from(came) / f64::from(all))
    }
}

#[cfg(test)]
mod tests {
    use super::{Believer, ItemId, Truth, schema};
    use crate::experiment::microworld::goals::Chains;
    use crate::experiment::microworld::level2::GOALS;
    use crate::experiment::microworld::trial;
    use crate::world::microworld::{Body, Oracle, item};

    #[test]
    fn a_short_life_believes_things_about_other_actions_and_the_literal_rule_none() {
        let oracle = Oracle::new(Body::Visible);
        let (mind, _) = trial::educated(1, 3_000);
        let mut chains = Chains::new(&oracle, mind.schemas(), &GOALS);
        let touch = item("tactl").unwrap();
        let mut believer = Believer::new(1, &oracle, &[(3, touch.0)]);
        let findings = believer.live(&mut chains, 3_000);
        assert!(findings.items > 20, "{}", findings.items);
        assert!(findings.schemas > 40, "{}", findings.schemas);
        assert_eq!(findings.literal, 0);
        assert!((0.8..=1.0).contains(&findings.reliability));
        assert!((0.7..=1.0).contains(&findings.right), "{}", findings.right);
        assert_eq!(findings.pictures.len(), 12);
    }

    #[test]
    fn the_truth_about_a_palpable_object_is_where_the_ball_is_beside_the_goal() {
        let oracle = Oracle::new(Body::Visible);
        let (hp21, tactl) = (item("hp21").unwrap(), item("tactl").unwrap());
        assert_eq!(GOALS[3], "hp21");
        let believer = Believer::new(1, &oracle, &[(3, tactl.0)]);
        let palpable = schema(&[], super::composite_action(3), &[hp21, tactl]);
        let mut reified = believer.items().as_slice().iter();
        let at = reified.position(|it| *it.schema() == palpable).unwrap();
        let id = ItemId(believer.items().first().0 + at as u16);
        let truth = Truth::of(&oracle, believer.items());
        for (index, state) in oracle.states().iter().enumerate() {
            let beside = (state.ball_at.x, state.ball_at.y) == (0, 0);
            let held = state.hand == crate::world::microworld::Hand::Gripping;
            assert_eq!(truth.is_on(id, index), beside && !held, "{state:?}");
        }
    }
}

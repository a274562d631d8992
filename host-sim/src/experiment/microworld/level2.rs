//! Level 2: what composite actions reveal (book, 5.4.3: 5.33 to 5.36).
//!
//! Nineteen composite actions (nine hand goals, nine eye goals, the hand in the centre of vision) are
//! run by the book's chain between random primitive actions; each success is one sample.
//! Maps per mode on end states bring out palpable and visible objects; the growing of accommodation
//! with the context from one mode and the result from another brings out cross-modal schemas.

use cla_core::growth::{Accommodation, Entry, GrowthConfig, SimpleSchema};
use cla_core::map::{
    ActionSomBank, HarvestConfig, ResultCoding, Sample, TrainingConfig, harvest_node,
};
use cla_core::num::{Rng, Schedule};
use cla_core::word::{ActionId, ItemId, ItemStates};
use serde::{Deserialize, Serialize};

use super::goals::{Chains, Course, goal, pursue};
use super::level1::{ITEM_COUNT, Life, Step, training};
use crate::world::microworld::{Body, Cell, Hand, Items, Oracle, State, WORDS, item, set_of};

/// The goals of the composite actions: every hand and eye position, and the hand in the centre of
/// vision (5.33).
pub const GOALS: [&str; 19] = [
    "hp11", "hp12", "hp13", "hp21", "hp22", "hp23", "hp31", "hp32", "hp33", "vp11", "vp12", "vp13",
    "vp21", "vp22", "vp23", "vp31", "vp32", "vp33", "fovx2",
];
/// Successes of each composite action that are learned from.
pub const SAMPLES: u32 = 1500;
/// Random primitive actions between two composite ones.
const BETWEEN: u32 = 12;

/// The maps of one mode.
pub type Maps = ActionSomBank<10, 10, ITEM_COUNT, 19>;
/// What is remembered of each composite action, and the cross-modal schemas.
pub type Memory = Accommodation<WORDS, 512, 1024, 19>;

/// What level 2 found.
///
/// ```
/// let it = host_sim::experiment::microworld::level2::Level2::default();
/// assert_eq!(it.palpable, 0);
/// ```
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Level2 {
    /// Palpable objects, `/<+hp21>/+hp21+tactl`, of 24.
    pub palpable: u32,
    /// Visible objects, `/<+vp22>/+vp22+vf33`, of 81.
    pub visible: u32,
    /// `/<+fovx2>/+tactb+fovx2`.
    pub eq_5_33: bool,
    /// `/<+hp21>/+hp21+tactl`.
    pub eq_5_34: bool,
    /// `/<+vp22>/+vp22+vf33`.
    pub eq_5_35a: bool,
    /// Goals and fovea regions foreseen from touch, of 33.
    pub touch_to_vision: u32,
    /// Goals and sides of the hand foreseen from vision, of 24.
    pub vision_to_touch: u32,
    /// `+vp12+fovb1/<+hp21>/+hp21+tactl`, exactly.
    pub eq_5_35b: bool,
    /// `+hp21+tactl/<+vp12>/+vp12+fovb1`, exactly.
    pub eq_5_36: bool,
    /// Attempts, and those that reached their goal.
    pub attempts: (u32, u32),
    /// What the maps of touch and of vision say may be found where a composite action ends, and may
    /// not be: the composite action's place in [`GOALS`], and the number of the item.
    pub objects: Vec<(usize, u16)>,
}

/// Runs the composite actions with the schemas of level 1 and learns from their successes; each
/// primitive action that they run is shown to `primitive`, for level 1 to learn from.
#[must_use]
pub fn learn(
    seed: u64,
    oracle: &Oracle,
    chains: &mut Chains,
    primitive: impl FnMut(ActionId, &Step),
) -> Level2 {
    let mut rng = Rng::stream(seed, 55);
    let mut found = Level2::default();
    let samples = explore(seed, oracle, chains, primitive, &mut found, &mut rng);
    found.judge_modes(&samples, &mut rng);
    found.judge_cross_modal(&samples, oracle, &mut rng);
    found
}

/// The successes of every composite action.
fn explore(
    seed: u64,
    oracle: &Oracle,
    chains: &mut Chains,
    mut primitive: impl FnMut(ActionId, &Step),
    found: &mut Level2,
    rng: &mut Rng,
) -> Vec<Vec<Step>> {
    let mut life = Life::new(seed.wrapping_add(1 << 32), Body::Visible, 0.0);
    let mut samples = vec![Vec::new(); GOALS.len()];
    for round in 0..SAMPLES {
        for (composite, name) in GOALS.iter().enumerate() {
            for _ in 0..BETWEEN {
                life.step();
            }
            let world = life.world_mut();
            let item = item(name).expect("a goal is an item");
            let before = world.on();
            let perceive =
                |state: &State| *oracle.items(oracle.index(state).expect("a reachable state"));
            let start = world.state();
            let next = |state: &State, _: &Items| chains.next(composite, state);
            let Course { reached, steps } = pursue(goal(item), start, perceive, next);
            if let Some(&(_, end)) = steps.last() {
                world.set_state(end);
            }
            let mut at = before;
            for &(action, state) in &steps {
                let after = perceive(&state);
                primitive(action, &Step { before: at, after });
                at = after;
            }
            found.attempts.0 += 1;
            if reached {
                found.attempts.1 += 1;
                let after = world.on();
                samples[composite].push(Step { before, after });
            }
        }
        // The order of the goals must not become a habit of the world.
        for _ in 0..rng.below(BETWEEN) + round % 2 {
            life.step();
        }
    }
    samples
}

impl Level2 {
    fn judge_modes(&mut self, samples: &[Vec<Step>], rng: &mut Rng) {
        let touch = set_of(&["hp", "tact", "text"]);
        let vision = set_of(&["vp", "vf"]);
        let joint = set_of(&["hp", "vp", "tact", "text", "hgr", "fov"]);
        let shows = |results: &[Vec<Items>], goal: &str, items: &[&str]| {
            let at = GOALS.iter().position(|&it| it == goal).expect("a goal");
            let wanted = items.iter().map(|name| item(name).expect("an item"));
            let wanted: Vec<ItemId> = wanted.collect();
            results[at]
                .iter()
                .any(|result| wanted.iter().all(|&item| result.contains(item)))
        };
        let felt = results_of(samples, &touch, rng);
        for (place, side) in palpable() {
            let (hp, tact) = (named("hp", place), SIDES[side].0);
            self.palpable += u32::from(shows(&felt, &hp, &[&hp, tact]));
        }
        let seen = results_of(samples, &vision, rng);
        for eye in Cell::all() {
            for ball in Cell::all() {
                let vp = named("vp", eye);
                let vf = format!("vf{}{}", ball.x + 2 - eye.x, ball.y + 2 - eye.y);
                self.visible += u32::from(shows(&seen, &vp, &[&vp, &vf]));
            }
        }
        self.objects = unreliable(&felt, &set_of(&["tact", "text1"]), samples);
        self.objects
            .extend(unreliable(&seen, &set_of(&["vf"]), samples));
        let both = results_of(samples, &joint, rng);
        self.eq_5_33 = shows(&both, "fovx2", &["tactb", "fovx2"]);
        self.eq_5_34 = shows(&felt, "hp21", &["hp21", "tactl"]);
        self.eq_5_35a = shows(&seen, "vp22", &["vp22", "vf33"]);
    }

    fn judge_cross_modal(&mut self, samples: &[Vec<Step>], oracle: &Oracle, rng: &mut Rng) {
        let vision = set_of(&["vp", "fov"]);
        let (felt, place_felt) = (set_of(&["tact", "text"]), set_of(&["hp", "tact", "text"]));
        let seen = set_of(&["fov"]);
        let mut memory = Box::<Memory>::default();
        for (composite, samples) in samples.iter().enumerate().take(18) {
            let action = ActionId(composite as u16);
            for sample in samples {
                memory.remember(action, sample, rng);
            }
            let by_hand = composite < 9;
            let (mode, results) = if by_hand {
                (&vision, &felt)
            } else {
                (&place_felt, &seen)
            };
            let seeds: Vec<Step> = memory.reservoirs()[composite].samples().to_vec();
            for seed in &seeds {
                for item in seed.after.intersection(results).iter() {
                    let _: Option<Entry> = memory.explain(action, seed, item, mode, &CROSS_MODAL);
                }
            }
        }
        let reliable = |schema: &SimpleSchema| truth(schema, oracle) >= 1.0 - 0.2;
        let says = |goal: &str, result: &str| {
            let at = GOALS.iter().position(|&it| it == goal).expect("a goal");
            let wanted = item(result).expect("an item");
            memory.schemas().iter().any(|schema| {
                usize::from(schema.action().0) == at
                    && schema.result_item() == wanted
                    && schema.context().count() > 0
                    && reliable(schema)
            })
        };
        for (place, side) in palpable() {
            self.vision_to_touch += u32::from(says(&named("hp", place), SIDES[side].0));
        }
        for (place, side) in palpable() {
            let fov = format!("{}1", SIDES[side].1);
            self.touch_to_vision += u32::from(says(&named("vp", place), &fov));
        }
        for eye in Cell::all() {
            self.touch_to_vision += u32::from(says(&named("vp", eye), "fovx1"));
        }
        let exactly = |context: [&str; 2], goal: &str, result: &str| {
            let at = GOALS.iter().position(|&it| it == goal).expect("a goal");
            let mut asked = context.map(|name| (item(name).expect("an item"), true));
            asked.sort_unstable();
            memory.schemas().iter().any(|schema| {
                usize::from(schema.action().0) == at
                    && schema.result_item() == item(result).expect("an item")
                    && schema.context().eq(asked)
            })
        };
        self.eq_5_35b = exactly(["vp12", "fovb1"], "hp21", "tactl");
        self.eq_5_36 = exactly(["hp21", "tactl"], "vp12", "fovb1");
    }
}

/// Cross-modal schemas hold mostly: the ball may be in the hand and come along.
/// The most telling items first, however rare: a place (hp21) says more than a touch (tactb).
const CROSS_MODAL: GrowthConfig = GrowthConfig {
    tolerance: 0.2,
    negatives: 0.0,
    generality: 0,
    support: 3,
    attention: 0.0,
};

/// The sides of the hand and the regions of the fovea, front, back, right, left.
const SIDES: [(&str, &str); 4] = [
    ("tactf", "fovf"),
    ("tactb", "fovb"),
    ("tactr", "fovr"),
    ("tactl", "fovl"),
];

/// The 24 places and sides where the ball can be beside.
fn palpable() -> impl Iterator<Item = (Cell, usize)> {
    const STEPS: [(i8, i8); 4] = [(0, 1), (0, -1), (1, 0), (-1, 0)];
    Cell::all().flat_map(|place| {
        (0..4)
            .filter(move |&side| place.moved(STEPS[side].0, STEPS[side].1) != place)
            .map(move |side| (place, side))
    })
}

fn named(prefix: &str, cell: Cell) -> String {
    format!("{prefix}{}{}", cell.x + 1, cell.y + 1)
}

/// For every composite action, the results that the nodes of its map in one mode stand for.
fn results_of(samples: &[Vec<Step>], mode: &Items, rng: &mut Rng) -> Vec<Vec<Items>> {
    let all = Items::first(ITEM_COUNT as u16);
    let known = |on: &Items| ItemStates::from_sets(&on.intersection(mode), &all);
    let config = TrainingConfig {
        alpha: Schedule::geometric(0.5, 0.1, SAMPLES).expect("a valid schedule"),
        sigma: Schedule::geometric(3.0, 0.05, SAMPLES).expect("a valid schedule"),
        ..training()
    };
    let mut maps = Box::<Maps>::default();
    maps.randomize(rng);
    for (composite, samples) in samples.iter().enumerate() {
        for step in samples {
            let (before, after) = (known(&step.before), known(&step.after));
            let coding = ResultCoding::EndState;
            let sample = Sample::<WORDS>::new(&before, &after, coding, ITEM_COUNT as u16);
            maps.train(ActionId(composite as u16), &sample, &config);
        }
    }
    let read = |map| {
        let nodes = (0..100).map(cla_core::som::NodeId);
        nodes
            .filter_map(|node| {
                harvest_node::<WORDS, 10, 10, ITEM_COUNT, _, _>(
                    map,
                    node,
                    ResultCoding::EndState,
                    &HarvestConfig::FORAGER,
                )
            })
            .map(|node| *node.result.positive())
            .collect()
    };
    maps.maps().iter().map(read).collect()
}

/// The results `/<goal>/+item` that the maps' nodes have among `items` and that come in fewer than
/// nine of ten samples, the goals of one hand or eye position only.
fn unreliable(results: &[Vec<Items>], items: &Items, samples: &[Vec<Step>]) -> Vec<(usize, u16)> {
    let mut found = Vec::new();
    for (composite, (results, samples)) in results.iter().zip(samples).enumerate().take(18) {
        let goal = item(GOALS[composite]).expect("a goal is an item");
        for item in items.iter() {
            let said = |result: &Items| result.contains(goal) && result.contains(item);
            let comes = samples.iter().filter(|it| it.after.contains(item)).count();
            if results.iter().any(said) && 10 * comes < 9 * samples.len() {
                found.push((composite, item.0));
            }
        }
    }
    found
}

/// The share of the states where a cross-modal schema applies in which its result comes when its
/// goal is reached; the ball comes along in a hand that grips it.
fn truth(schema: &SimpleSchema, oracle: &Oracle) -> f64 {
    let composite = usize::from(schema.action().0);
    let (mut applies, mut succeeds) = (0, 0);
    for (index, &state) in oracle.states().iter().enumerate() {
        if !schema.applies(oracle.items(index)) {
            continue;
        }
        let end = oracle.index(&end_of(composite, state));
        let end = end.expect("a reachable state");
        applies += 1;
        succeeds += u32::from(schema.succeeds(oracle.items(end)));
    }
    if applies == 0 {
        0.0
    } else {
        f64::from(succeeds) / f64::from(applies)
    }
}

/// Where a composite action that moves the hand (places 0 to 8 of [`GOALS`]) or the eye (9 to 17)
/// ends: the ball comes along in a hand that grips it.
#[must_use]
pub fn end_of(composite: usize, state: State) -> State {
    let place = Cell::all().nth(composite % 9).expect("nine places");
    let mut end = state;
    if composite >= 9 {
        end.eye_at = place;
    } else {
        end.hand_at = place;
        if state.hand == Hand::Gripping {
            end.ball_at = place;
        }
    }
    end
}

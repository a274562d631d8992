//! Level 1 in its four forms: the book's raw harvest, the same simplified, maps that seed
//! accommodation, and accommodation alone.
//!
//! Owns how a life of random actions is lived and what it leaves; measuring against the truth is the
//! oracle's work.

use cla_core::growth::{Accommodation, AccommodationConfig, GrowthConfig, Transition, simplify};
use cla_core::map::{
    ActionSomBank, BaseRates, HarvestConfig, ResultCoding, Sample, TrainingConfig, harvest_node,
};
use cla_core::num::{Rng, Schedule};
use cla_core::som::{ByteSom, NodeId, best_match};
use cla_core::word::{ActionId, ItemStates};

use super::catalogue::Schema;
use crate::world::World;
use crate::world::microworld::{ACTIONS, Body, ITEMS, Items, Microworld, WORDS};

/// Actions of the Microworld.
pub const ACTION_COUNT: usize = ACTIONS.len();
/// Items of the Microworld.
pub const ITEM_COUNT: usize = ITEMS.len();

/// One completed primitive action.
pub type Step = Transition<WORDS>;

/// Maps of 10 × 10 nodes with weights of four bytes: the book's size (5.4.2).
pub type FloatBank = ActionSomBank<10, 10, ITEM_COUNT, ACTION_COUNT>;
/// The same with weights of one byte.
pub type ByteBank =
    ActionSomBank<10, 10, ITEM_COUNT, ACTION_COUNT, ByteSom<10, 10, ITEM_COUNT, ()>>;
/// Accommodation alone, in at most 64 kB.
pub type Mind = Accommodation<WORDS, 150, 1500, ACTION_COUNT>;
/// Accommodation alone, in at most 200 kB.
pub type RoomyMind = Accommodation<WORDS, 448, 5400, ACTION_COUNT>;
/// What fits beside byte maps in 200 kB.
pub type SeededMind = Accommodation<WORDS, 88, 1250, ACTION_COUNT>;

/// A life of random actions in one world.
#[derive(Clone, Debug)]
pub struct Life {
    world: Microworld,
    rng: Rng,
}

impl Life {
    /// Begins a life; slip is the probability that an action does nothing.
    #[must_use]
    pub fn new(seed: u64, body: Body, slip: f32) -> Self {
        Self {
            world: Microworld::new(seed, body, slip),
            rng: Rng::stream(seed, 52),
        }
    }

    /// Does one random action.
    pub fn step(&mut self) -> (ActionId, Step) {
        let action = self.rng.below(ACTION_COUNT as u32) as usize;
        let before = self.world.on();
        self.world.act(action);
        let after = self.world.on();
        (ActionId(action as u16), Transition { before, after })
    }

    /// The world, to look at or to rearrange.
    pub const fn world_mut(&mut self) -> &mut Microworld {
        &mut self.world
    }
}

/// Everything known: what is not on is off.
#[must_use]
pub fn known(on: &Items) -> ItemStates<WORDS> {
    ItemStates::from_sets(on, &Items::first(ITEM_COUNT as u16))
}

/// How the maps of the Microworld are trained: a neighbourhood that settles, results that weigh
/// double.
///
/// # Panics
/// Never: the schedules are valid.
#[must_use]
pub fn training() -> TrainingConfig {
    TrainingConfig {
        alpha: Schedule::geometric(0.5, 0.1, MAP_SAMPLES).expect("a valid schedule"),
        sigma: Schedule::geometric(3.0, 0.05, MAP_SAMPLES).expect("a valid schedule"),
        result_weight: 2.0,
        ..TrainingConfig::BOOK
    }
}

/// Samples over which the schedules run: of 10,000 a map about six in ten change something.
const MAP_SAMPLES: u32 = 6_000;
/// Negative items are harvested only of items that are on at this share of the moments or more.
const TELLING_RATE: f32 = 0.1;

/// Maps trained by the book's method.
pub struct Maps<B> {
    bank: Box<B>,
    rates: BaseRates<WORDS>,
    /// A plain replay buffer for simplification: the last samples of each action.
    replay: Vec<Vec<Step>>,
}

impl Maps<FloatBank> {
    /// Trains on `steps` random actions.
    #[must_use]
    pub fn train(seed: u64, body: Body, steps: u32) -> Self {
        let mut rng = Rng::stream(seed, 53);
        let mut maps = Self {
            bank: Box::default(),
            rates: BaseRates::new(),
            replay: vec![Vec::new(); ACTION_COUNT],
        };
        maps.bank.randomize(&mut rng);
        let (mut life, config) = (Life::new(seed, body, 0.0), training());
        for _ in 0..steps {
            let (action, step) = life.step();
            maps.rates.observe(&step.before);
            let replay = &mut maps.replay[usize::from(action.0)];
            if replay.len() == REPLAY {
                replay[rng.below(REPLAY as u32) as usize] = step;
            } else {
                replay.push(step);
            }
            // What changes nothing teaches a map nothing but to forget.
            if step.before != step.after {
                let sample = sample_of(&step);
                maps.bank.train(action, &sample, &config);
            }
        }
        maps
    }

    /// The raw harvest: every node that says something, each schema once.
    #[must_use]
    pub fn harvest(&self) -> Vec<Schema> {
        let telling = self.rates.at_least(TELLING_RATE);
        let mut schemas: Vec<Schema> = Vec::new();
        for (action, map) in self.bank.maps().iter().enumerate() {
            for node in map.nodes() {
                let read = harvest_node(map, node, ResultCoding::Change, &HarvestConfig::BOOK);
                let Some(node) = read else { continue };
                let schema = Schema {
                    context: node.context.with_negatives_among(&telling),
                    action: ActionId(action as u16),
                    result: node.result,
                };
                if !schemas.contains(&schema) {
                    schemas.push(schema);
                }
            }
        }
        schemas
    }

    /// The raw harvest, simplified on the replay buffer; 5 % of contradiction is tolerated.
    #[must_use]
    pub fn simplified(&self) -> Vec<Schema> {
        let config = GrowthConfig {
            tolerance: 0.05,
            ..GrowthConfig::EXACT
        };
        let mut simple: Vec<Schema> = Vec::new();
        for schema in self.harvest() {
            let samples = &self.replay[usize::from(schema.action.0)];
            for one in simplify(&schema, samples, &config) {
                let text = one.text();
                if !simple.contains(&text) {
                    simple.push(text);
                }
            }
        }
        simple
    }
}

/// Samples of each action that simplification may look at.
const REPLAY: usize = 3000;

fn sample_of(step: &Step) -> Sample<WORDS> {
    let (before, after) = (known(&step.before), known(&step.after));
    Sample::new(&before, &after, ResultCoding::Change, ITEM_COUNT as u16)
}

/// Byte maps whose nodes seed accommodation: the complete CLASM of this experiment.
pub struct Clasm {
    bank: Box<ByteBank>,
    mind: Box<SeededMind>,
    rng: Rng,
    training: TrainingConfig,
}

impl Clasm {
    /// Nodes besides the best matching unit that seed schemas at every step.
    const REVISITED: u32 = 3;

    /// Its memory: maps, table and reservoirs, in bytes.
    pub const BYTES: usize = size_of::<ByteBank>() + size_of::<SeededMind>();

    /// A newborn.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut rng = Rng::stream(seed, 54);
        let mut bank = Box::new(ByteBank::zeroed());
        bank.randomize(&mut rng);
        Self {
            bank,
            mind: Box::default(),
            rng,
            training: training(),
        }
    }

    /// Learns from one action.
    pub fn learn(&mut self, action: ActionId, step: &Step) {
        let mut seeds = Vec::new();
        if step.before != step.after {
            self.bank.train(action, &sample_of(step), &self.training);
            let best = best_match(self.bank.last_distances()).node;
            seeds.push(self.rounded(action, best));
        }
        for _ in 0..Self::REVISITED {
            let node = NodeId(self.rng.below(100) as u16);
            seeds.push(self.rounded(action, node));
        }
        let config = AccommodationConfig::EXACT;
        self.mind
            .observe_seeded(action, step, seeds, &config, &mut self.rng);
    }

    /// What is known now.
    #[must_use]
    pub fn schemas(&self) -> Vec<Schema> {
        self.mind.schemas().iter().map(|it| it.text()).collect()
    }

    /// What a node stands for, rounded to on and off.
    fn rounded(&self, action: ActionId, node: NodeId) -> Step {
        let map = &self.bank.maps()[usize::from(action.0)];
        let mut before = Items::EMPTY;
        let mut after = Items::EMPTY;
        for (item, id) in (0..ITEM_COUNT as u16).map(|item| (item, cla_core::word::ItemId(item))) {
            let on = map.context_weight(node, item) > 0.5;
            let change = map.result_weight(node, item);
            let fits = "the Microworld's items fit its words";
            if on {
                before.insert(id).expect(fits);
            }
            if change > 0.5 || (on && change >= -0.5) {
                after.insert(id).expect(fits);
            }
        }
        Transition { before, after }
    }
}

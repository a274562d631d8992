//! One seed of the Microworld experiment: everything that is measured, as numbers.
//!
//! A trial trains every form of level 1 on the same life, drives the goals, runs level 2 and lets
//! Drescher's mechanism live the same life; `claims` judges.

use std::time::Instant;

use cla_core::growth::{AccommodationConfig, SimpleSchema};
use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::catalogue::{
    Found, Schema, VALID, among_simple_schemas, among_whole_schemas, equations, saying,
};
use super::goals::{Chains, GOALS, Planning, Strategy, success};
use super::level1::{Clasm, Life, Maps, Mind, RoomyMind};
use super::level2::{self, Level2};
use super::synthetic::{self, Believer, Findings};
use crate::baseline::drescher::{Drescher, DrescherConfig};
use crate::progress::Ticker;
use crate::world::microworld::{Body, Family, Oracle, Recall};

/// Total steps at which growth is measured.
pub const MOMENTS: [u32; 5] = [1_000, 3_000, 10_000, 30_000, 100_000];
/// Steps of a whole life: 10,000 samples a map.
pub const STEPS: u32 = 100_000;
/// Steps after which the goals are tried a first time.
pub const EARLY: u32 = 10_000;
/// Steps that Drescher's mechanism lives with unbounded memory (its time per step grows).
pub const DRESCHER_STEPS: u32 = 10_000;
/// Steps that it lives in bounded memory; full after the first 3,000, it changes no more.
pub const BOUNDED_STEPS: u32 = 30_000;
/// Steps that it lives literally.
pub const LITERAL_STEPS: u32 = 3_000;
/// Steps that it lives with synthetic items.
pub const COMPLETE_STEPS: u32 = 3_000;
/// Steps that its unrestricted variant lives; it is full not much later.
pub const UNRESTRICTED_STEPS: u32 = 1_000;
/// The memory of the comparison at equal memory, bytes.
pub const EQUAL_MEMORY: usize = 200_000;
const _: () = assert!(size_of::<RoomyMind>() <= EQUAL_MEMORY && Clasm::BYTES <= EQUAL_MEMORY);
/// A simple schema has to be tried or remembered so often before the agent believes it.
pub const BELIEVED_TRIALS: u16 = 4;
/// The slip of the noisy world.
pub const SLIP: f32 = 0.05;

/// What a learner knows at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// Total steps so far.
    pub steps: u32,
    /// Share of all changes predicted by truly reliable schemas.
    pub recall: f64,
    /// Share of all changes predicted by schemas that the learner itself believes.
    pub own_recall: f64,
    /// Share of the changes predicted so that come.
    pub precision: f64,
    /// Schemas.
    pub schemas: usize,
    /// Memory, bytes.
    pub bytes: usize,
    /// Mean time of a step of learning so far, µs (of this machine, others running).
    pub micros: f64,
}

/// What one seed gave.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// Recall, family by family, of the raw harvest.
    pub raw: Recall,
    /// Schemas of the raw harvest.
    pub raw_schemas: usize,
    /// The share of them that always hold.
    pub valid: f64,
    /// Each equation in the raw harvest.
    pub raw_equations: Vec<Found>,
    /// Recall of the raw harvest simplified on a replay buffer.
    pub harvest_simplified: f64,
    /// Recall of byte maps that seed accommodation.
    pub clasm: Recall,
    /// Recall of accommodation alone, family by family.
    pub simplified: Recall,
    /// Each equation in accommodation alone.
    pub simplified_equations: Vec<Found>,
    /// The share of the states where each equation comes true in which accommodation alone foresees
    /// it.
    pub foreseen: Vec<f64>,
    /// Accommodation alone at the [`MOMENTS`].
    pub growth: Vec<Growth>,
    /// The same in [`EQUAL_MEMORY`], up to [`BOUNDED_STEPS`].
    pub roomy: Vec<Growth>,
    /// Recall at 10,000 steps where 5 % of the actions slip.
    pub slipping: f64,
    /// For each of [`GOALS`], success after [`EARLY`] and after all steps by search, and after all
    /// by the book's chain.
    pub goals: Vec<[f64; 3]>,
    /// Recall of accommodation alone after it has learned from the primitive actions of the composite
    /// ones too.
    pub practised: f64,
    /// What level 2 found.
    pub level2: Level2,
    /// What a life with synthetic items showed.
    pub synthetic: Findings,
    /// Drescher's mechanism as well tuned as we could.
    pub drescher: Vec<Growth>,
    /// As Drescher words it.
    pub literal: Vec<Growth>,
    /// Tuned, with synthetic items.
    pub complete: Vec<Growth>,
    /// For each of [`GOALS`], success by the book's chain over its schemas after
    /// [`DRESCHER_STEPS`].
    pub drescher_goals: Vec<f64>,
    /// Tuned, with conjunctive results.
    pub conjunctive: Vec<Growth>,
    /// Its schemas with such a result after [`DRESCHER_STEPS`].
    pub conjunctive_schemas: usize,
    /// For each of [`GOALS`], success by the book's chain over its schemas then.
    pub conjunctive_goals: Vec<f64>,
    /// Every relevant item of every schema spins off.
    pub unrestricted: Vec<Growth>,
    /// Tuned, in no more than [`EQUAL_MEMORY`].
    pub bounded: Vec<Growth>,
}

/// Runs one seed; ticks once a part, [`PARTS`] in all.
#[must_use]
pub fn run(seed: u64, ticker: &Ticker) -> Trial {
    let oracle = &Oracle::new(Body::Visible);
    let maps = Maps::train(seed, Body::Visible, STEPS);
    let raw = maps.harvest();
    let always = raw.iter().filter(|it| oracle.reliability(it) == Some(1.0));
    let valid = always.count() as f64 / raw.len().max(1) as f64;
    let raw_equations = equations()
        .iter()
        .map(|it| among_whole_schemas(&it.schema, &raw, oracle))
        .collect();
    let harvest_simplified = oracle.recall(&maps.simplified(), VALID).total();
    drop(maps);
    ticker.advance(1);
    let clasm = oracle.recall(&seeded(seed), VALID);
    ticker.advance(1);
    let grown = grow(seed, oracle);
    ticker.advance(1);
    let mut chains = Chains::new(oracle, grown.mind.schemas(), &level2::GOALS);
    let mut practised = grown.mind.clone();
    let mut rng = Rng::stream(seed, 60);
    let level2 = level2::learn(seed, oracle, &mut chains, |action, step| {
        practised.observe(action, step, &AccommodationConfig::EXACT, &mut rng);
    });
    ticker.advance(1);
    let mut believer = Believer::new(seed, oracle, &level2.objects);
    let synthetic = believer.live(&mut chains, synthetic::COMPOSITES);
    ticker.advance(1);
    let known = texts(grown.mind.schemas());
    let (drescher, mechanism) =
        attribution(seed, oracle, DrescherConfig::RESTRICTED, DRESCHER_STEPS);
    let (conjunctive, whole) =
        attribution(seed, oracle, DrescherConfig::CONJUNCTIVE, DRESCHER_STEPS);
    let trial = Trial {
        raw: oracle.recall(&raw, VALID),
        raw_schemas: raw.len(),
        valid,
        raw_equations,
        harvest_simplified,
        clasm,
        simplified: oracle.recall(&known, VALID),
        simplified_equations: equations()
            .iter()
            .map(|it| among_simple_schemas(&it.schema, &known, oracle))
            .collect(),
        foreseen: equations()
            .iter()
            .map(|it| saying(&it.schema, &known, oracle).foreseen)
            .collect(),
        growth: grown.growth,
        roomy: roomy(seed, oracle),
        slipping: slipping(seed, oracle),
        goals: grown.goals,
        practised: oracle.recall(&texts(practised.schemas()), VALID).total(),
        level2,
        synthetic,
        drescher,
        drescher_goals: chained(seed, oracle, &mechanism),
        conjunctive,
        conjunctive_schemas: whole.conjunctive().len(),
        conjunctive_goals: chained(seed, oracle, &whole),
        literal: attribution(seed, oracle, DrescherConfig::LITERAL, LITERAL_STEPS).0,
        complete: attribution(seed, oracle, DrescherConfig::COMPLETE, COMPLETE_STEPS).0,
        unrestricted: attribution(
            seed,
            oracle,
            DrescherConfig::UNRESTRICTED,
            UNRESTRICTED_STEPS,
        )
        .0,
        bounded: attribution(
            seed,
            oracle,
            DrescherConfig {
                memory: EQUAL_MEMORY,
                ..DrescherConfig::RESTRICTED
            },
            BOUNDED_STEPS,
        )
        .0,
    };
    ticker.advance(1);
    trial
}

/// Ticks of one trial.
pub const PARTS: u64 = 6;

/// A mind and what was measured while it grew.
struct Grown {
    mind: Box<Mind>,
    growth: Vec<Growth>,
    goals: Vec<[f64; 3]>,
}

fn grow(seed: u64, oracle: &Oracle) -> Grown {
    let mut life = Life::new(seed, Body::Visible, 0.0);
    let mut rng = Rng::stream(seed, 56);
    let mut mind = Box::<Mind>::default();
    let mut planner = Box::new(Planning::new());
    let mut growth = Vec::new();
    let mut goals = vec![[0.0; 3]; GOALS.len()];
    let mut spent = 0.0;
    for step in 1..=STEPS {
        let (action, sample) = life.step();
        planner.see(&sample.before);
        planner.see(&sample.after);
        let begun = Instant::now();
        mind.observe(action, &sample, &AccommodationConfig::EXACT, &mut rng);
        spent += begun.elapsed().as_secs_f64() * 1e6;
        if MOMENTS.contains(&step) {
            let bytes = size_of::<Mind>();
            growth.push(measured(oracle, mind.schemas(), step, bytes, spent));
        }
        if step == EARLY || step == STEPS {
            let mut tries = Rng::stream(seed, 57);
            for (group, shares) in GOALS.iter().zip(&mut goals) {
                let mut attempt = |strategy| {
                    success(
                        group,
                        oracle,
                        mind.schemas(),
                        &mut planner,
                        strategy,
                        &mut tries,
                    )
                };
                if step == EARLY {
                    shares[0] = attempt(Strategy::Search);
                } else {
                    shares[1] = attempt(Strategy::Search);
                    shares[2] = attempt(Strategy::Chain);
                }
            }
        }
    }
    Grown {
        mind,
        growth,
        goals,
    }
}

/// A mind that has lived `steps` random actions, with its planner: what the goal mode drives.
#[must_use]
pub fn educated(seed: u64, steps: u32) -> (Box<Mind>, Box<Planning>) {
    let mut life = Life::new(seed, Body::Visible, 0.0);
    let mut rng = Rng::stream(seed, 56);
    let mut mind = Box::<Mind>::default();
    let mut planner = Box::new(Planning::new());
    for _ in 0..steps {
        let (action, sample) = life.step();
        planner.see(&sample.before);
        planner.see(&sample.after);
        mind.observe(action, &sample, &AccommodationConfig::EXACT, &mut rng);
    }
    (mind, planner)
}

/// What simple schemas know after so many steps, in so many bytes and µs of learning.
fn measured(
    oracle: &Oracle,
    schemas: &[SimpleSchema],
    steps: u32,
    bytes: usize,
    spent: f64,
) -> Growth {
    let believed = schemas
        .iter()
        .filter(|it| it.reliability() >= VALID as f32 && it.activations() >= BELIEVED_TRIALS);
    let believed: Vec<Schema> = believed.map(|it| it.text()).collect();
    let predicted = oracle.predicted(&believed);
    Growth {
        steps,
        recall: oracle.recall(&texts(schemas), VALID).total(),
        own_recall: predicted.total(),
        precision: predicted.precision(),
        schemas: schemas.len(),
        bytes,
        micros: spent / f64::from(steps),
    }
}

fn roomy(seed: u64, oracle: &Oracle) -> Vec<Growth> {
    let mut life = Life::new(seed, Body::Visible, 0.0);
    let mut rng = Rng::stream(seed, 56);
    let mut mind = Box::<RoomyMind>::default();
    let (mut growth, mut spent) = (Vec::new(), 0.0);
    for step in 1..=BOUNDED_STEPS {
        let (action, sample) = life.step();
        let begun = Instant::now();
        mind.observe(action, &sample, &AccommodationConfig::ROOMY, &mut rng);
        spent += begun.elapsed().as_secs_f64() * 1e6;
        if MOMENTS.contains(&step) {
            let bytes = size_of::<RoomyMind>();
            growth.push(measured(oracle, mind.schemas(), step, bytes, spent));
        }
    }
    growth
}

fn texts(schemas: &[SimpleSchema]) -> Vec<Schema> {
    schemas.iter().map(SimpleSchema::text).collect()
}

fn seeded(seed: u64) -> Vec<Schema> {
    let (mut life, mut clasm) = (Life::new(seed, Body::Visible, 0.0), Clasm::new(seed));
    for _ in 0..STEPS {
        let (action, sample) = life.step();
        clasm.learn(action, &sample);
    }
    clasm.schemas()
}

fn slipping(seed: u64, oracle: &Oracle) -> f64 {
    let mut life = Life::new(seed, Body::Visible, SLIP);
    let mut rng = Rng::stream(seed, 56);
    let mut mind = Box::<Mind>::default();
    for _ in 0..EARLY {
        let (action, sample) = life.step();
        mind.observe(action, &sample, &AccommodationConfig::TOLERANT, &mut rng);
    }
    // The truth is that of the world without slip: what the schemas say about what actions do.
    oracle.recall(&texts(mind.schemas()), VALID).total()
}

/// What the book's chain reaches with the schemas of Drescher's mechanism.
fn chained(seed: u64, oracle: &Oracle, mechanism: &Drescher) -> Vec<f64> {
    let trials = u8::try_from(BELIEVED_TRIALS).unwrap_or(u8::MAX);
    let (schemas, mut planner) = (mechanism.chainable(trials), Box::new(Planning::new()));
    let mut tries = Rng::stream(seed, 57);
    let reached = GOALS.iter().map(|group| {
        success(
            group,
            oracle,
            &schemas,
            &mut planner,
            Strategy::Chain,
            &mut tries,
        )
    });
    reached.collect()
}

fn attribution(
    seed: u64,
    oracle: &Oracle,
    config: DrescherConfig,
    steps: u32,
) -> (Vec<Growth>, Drescher) {
    let mut life = Life::new(seed, Body::Visible, 0.0);
    let mut mechanism = Drescher::new(config);
    let (mut growth, mut spent) = (Vec::new(), 0.0);
    for step in 1..=steps {
        let (action, sample) = life.step();
        let begun = Instant::now();
        mechanism.learn(action, &sample);
        spent += begun.elapsed().as_secs_f64() * 1e6;
        if MOMENTS.contains(&step) {
            let known = mechanism.schemas();
            let trials = u8::try_from(BELIEVED_TRIALS).unwrap_or(u8::MAX);
            let predicted = oracle.predicted(&mechanism.believed(VALID as f32, trials));
            growth.push(Growth {
                steps: step,
                recall: oracle.recall(&known, VALID).total(),
                own_recall: predicted.total(),
                precision: predicted.precision(),
                schemas: mechanism.len(),
                bytes: mechanism.bytes(),
                micros: spent / f64::from(step),
            });
        }
    }
    (growth, mechanism)
}

/// The families' names with a recall each, for tables.
pub fn by_family(recall: &Recall) -> impl Iterator<Item = (&'static str, f64)> + '_ {
    Family::ALL
        .into_iter()
        .map(|family| (family.name(), recall.of(family)))
}

/// One learner's growth: its name, and where a trial has it.
pub(super) type Learner = (&'static str, fn(&Trial) -> &Vec<Growth>);

/// All learners.
pub(super) const LEARNERS: [Learner; 8] = [
    ("accommodation, 62 kB", |it| &it.growth),
    ("accommodation, 198 kB", |it| &it.roomy),
    ("Drescher, tuned", |it| &it.drescher),
    ("Drescher, literal", |it| &it.literal),
    ("Drescher, with conjunctive results", |it| &it.conjunctive),
    ("Drescher, with synthetic items", |it| &it.complete),
    ("Drescher, unrestricted", |it| &it.unrestricted),
    ("Drescher, tuned, in 200 kB", |it| &it.bounded),
];

/// A number of each seed at one moment of a learner's growth.
pub(super) fn means(
    trials: &[Trial],
    learner: Learner,
    steps: u32,
    of: fn(&Growth) -> f64,
) -> Vec<f64> {
    trials
        .iter()
        .filter_map(|it| learner.1(it).iter().find(|it| it.steps == steps))
        .map(of)
        .collect()
}

//! One seed of the foraging experiment: a brain's childhood, its tests on the way, its rivals.
//!
//! Measures only; what the numbers mean is said in `claims`.

use std::cell::Cell;

use cla_core::agent::AgentConfig;
use cla_core::choice::{ChoiceRule, ValueConfig};
use cla_core::forager::pioneer::{Brain, Item, VOCABULARY};
use cla_core::knowledge::{Estimate, SchemaId};
use cla_core::word::{Detail, ItemId, SchemaText};
use serde::{Deserialize, Serialize};

use super::approach::{Approach, approach};
use super::bench::{Bench, Captures, born};
use super::harvested::{Harvested, harvested};
use super::measure::{Record, promises, record_of};
use super::options::{BOOK_SCHEMAS, ForageOptions, SNAPSHOT};
use super::second::{self, Ablation, Insight, LARGE, Pair};

use crate::baseline::random::Random;
use crate::baseline::sector::Sector;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::progress::Ticker;
use crate::world::World;
use crate::world::config::PioneerConfig;
use crate::world::pioneer::Pioneer;
use crate::world::setting::WorldOptions;

/// A schema of the first brain, for the table of what was learned.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// In the book's notation, positive items only.
    pub text: String,
    /// Successes / activations.
    pub reliability: f64,
    /// Trials.
    pub activations: u32,
}

/// Everything measured for one seed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Trial {
    /// Tests of the knowledge after 0, 1000, 2000 … actions of training.
    pub snapshots: Vec<Captures>,
    /// The same of both levels, after 0, 1000, 2000 … actions of the second half of training.
    pub snapshots_level2: Vec<Captures>,
    /// Actions of training when the first schema promised `ingrip`; `None` when none did.
    pub first_ingrip: Option<u32>,
    /// Captures while training.
    pub training_captures: u32,
    /// A brain like the book's in everything: straight schedules, no recruitment, its choice rule.
    pub book: Captures,
    /// Our learner, but with the book's choice rule and its values.
    pub lexicographic: Captures,
    /// Random actions.
    pub random: Captures,
    /// The Stage controller, which sees every sector that holds a blob.
    pub sector: Captures,
    /// The same controller on the learner's percept: the nearest blob only.
    pub sector_nearest: Captures,
    /// The learner and the Stage controller in the noise-free twin of the world.
    pub noise_free: Captures,
    /// As `noise_free`, for the Stage controller.
    pub noise_free_sector: Captures,
    /// After as many actions again, with and without the second level.
    pub second: Pair,
    /// What the second level of that brain was like.
    pub insight: Insight,
    /// The second level and habits apart.
    pub apart: Ablation,
    /// As `second`, without noise.
    pub second_noise_free: Pair,
    /// As `second`, in the large room.
    pub second_large: Pair,
    /// The second level harvested from Action SOMs.
    pub harvested: Harvested,
    /// Deferred values of s1 to s5 after training.
    pub deferred: [f64; 5],
    /// What the trained brain knows of each of [`BOOK_SCHEMAS`].
    pub records: Vec<Record>,
    /// Mean reliability of all schemas that have been tried.
    pub mean_reliability: f64,
    /// Reliability of each schema.
    pub reliabilities: Vec<f64>,
    /// Reliability of each level-2 schema in the book's way: labelled in hindsight.
    pub reliabilities_level2: Vec<f64>,
    /// How it gets at a specimen with level 1, and after as long again with both levels.
    pub approaches: [Approach; 2],
    /// The schemas, the most tried first.
    pub found: Vec<Found>,
    /// What the worst step of all these brains would have cost; the one harvested from maps apart.
    pub load: Load,
}

/// How many actions one seed takes, for the progress bar.
#[must_use]
pub(super) fn work(options: &ForageOptions) -> u64 {
    let tests = 2 * u64::from(options.actions / SNAPSHOT + 1) + 7 + 6 + 3 + 2;
    u64::from(options.actions) * 21 + tests * 2 * u64::from(options.test_actions)
}

/// Runs one seed.
///
/// # Errors
/// [`Failure`] when a world cannot be built or the brain's configuration cannot work.
pub(super) fn run(options: &ForageOptions, seed: u64, ticker: &Ticker) -> Result<Trial, Failure> {
    let bench = Bench {
        options,
        seed,
        ticker,
        load: Cell::default(),
    };
    let mut brain = born(options.brain, seed)?;
    let mut world = options.world.build(seed)?;
    let mut snapshots = vec![bench.test(&brain, &options.world)?];
    let (mut first_ingrip, mut training_captures, mut done) = (None, 0, 0);
    while done < options.actions {
        let chunk = options.brain.harvest_every.min(options.actions - done);
        training_captures += bench.live(&mut brain, &mut world, chunk)?;
        done += chunk;
        if first_ingrip.is_none() && promises(brain.knowledge(), Item::ingrip.id()) {
            first_ingrip = Some(done);
        }
        if done % SNAPSHOT == 0 {
            snapshots.push(bench.test(&brain, &options.world)?);
        }
    }
    let watched = second::watched(&bench, &brain, &options.world)?;
    for (name, brain) in [("level1", &brain), ("both", &watched.brain)] {
        let names = VOCABULARY.names();
        ticker.keep(&format!("forage-{seed}-{name}"), || brain.image(names))?;
    }
    let approaches = [
        approach(&brain, options.world.config, seed)?,
        approach(&watched.brain, options.world.config, seed)?,
    ];
    let apart = second::apart(&bench, &brain, &options.world)?;
    brain.harvest();
    brain.knowledge_mut().defer_values(&options.brain.values);
    let knowledge = brain.knowledge();
    let records = BOOK_SCHEMAS
        .iter()
        .map(|(_, text, ..)| Ok(record_of(knowledge, &SchemaText::parse(text, &VOCABULARY)?)))
        .collect::<Result<Vec<Record>, Failure>>()?;
    let book = AgentConfig {
        rule: ChoiceRule::Lexicographic,
        values: ValueConfig::BOOK,
        ..options.brain
    };
    let quiet = WorldOptions {
        config: PioneerConfig {
            drop_out: 0.0,
            step_noise: 0.0,
            turn_noise: 0.0,
            ..options.world.config
        },
        layout: options.world.layout.clone(),
        path: options.world.path.clone(),
    };
    let forward = options.world.config.forward;
    let all_by_the_book = bench.trained(AgentConfig::BOOK, &options.world)?;
    let by_the_book = bench.trained(book, &options.world)?;
    let in_the_quiet = bench.trained(options.brain, &quiet)?;
    let large = WorldOptions {
        config: PioneerConfig {
            radius: LARGE,
            ..options.world.config
        },
        layout: None,
        path: None,
    };
    let (second_noise_free, _) = second::compare(&bench, &in_the_quiet, &quiet)?;
    let in_the_large = bench.trained(options.brain, &large)?;
    let (second_large, _) = second::compare(&bench, &in_the_large, &large)?;
    Ok(Trial {
        snapshots,
        snapshots_level2: watched.snapshots,
        reliabilities_level2: watched.reliabilities,
        approaches,
        second: watched.pair,
        insight: watched.insight,
        apart,
        second_noise_free,
        second_large,
        harvested: harvested(&bench, &large)?,
        first_ingrip,
        training_captures,
        book: bench.test(&all_by_the_book, &options.world)?,
        lexicographic: bench.test(&by_the_book, &options.world)?,
        random: bench.rival(
            &mut Random { actions: 6 },
            <Pioneer as World>::sense,
            &options.world,
        )?,
        sector: bench.rival(
            &mut Sector::new(forward),
            Pioneer::sense_all_sectors,
            &options.world,
        )?,
        sector_nearest: bench.rival(
            &mut Sector::new(forward),
            <Pioneer as World>::sense,
            &options.world,
        )?,
        noise_free: bench.test(&in_the_quiet, &quiet)?,
        noise_free_sector: bench.rival(
            &mut Sector::new(forward),
            Pioneer::sense_all_sectors,
            &quiet,
        )?,
        deferred: core::array::from_fn(|i| f64::from(knowledge.deferred_value(ItemId(i as u16)))),
        records,
        mean_reliability: f64::from(knowledge.mean_reliability(Estimate::Plain)),
        reliabilities: knowledge
            .schemas()
            .iter()
            .map(|schema| f64::from(schema.reliability.value(Estimate::Plain)))
            .collect(),
        found: found(&brain),
        load: bench.load.get(),
    })
}

fn found(brain: &Brain) -> Vec<Found> {
    let knowledge = brain.knowledge();
    let mut found: Vec<Found> = (0..knowledge.schemas().len())
        .filter_map(|index| {
            let schema = knowledge.schemas().get(index)?;
            let text = knowledge.text(SchemaId(index as u16))?;
            Some(Found {
                text: text.display(&VOCABULARY, Detail::Abbreviated).to_string(),
                reliability: f64::from(schema.reliability.value(Estimate::Plain)),
                activations: schema.reliability.activations(),
            })
        })
        .collect();
    found.sort_by(|a, b| {
        b.activations
            .cmp(&a.activations)
            .then_with(|| a.text.cmp(&b.text))
    });
    found
}

/// A number of each seed.
pub(super) fn of(trials: &[Trial], number: impl Fn(&Trial) -> f64) -> Vec<f64> {
    trials.iter().map(number).collect()
}

/// The last test of a seed: what training has come to.
pub(super) fn last(trial: &Trial) -> Captures {
    trial.snapshots.last().copied().unwrap_or_default()
}

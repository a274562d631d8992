//! Damage and recovery: a robot whose camera was knocked, and what it makes of it (book, 6.3, 7.1.1).
//!
//! `life` is the protocol, `trial` one seed of it for everybody who takes part, `rivals` how the others
//! were tuned, `recovery` what it is to recover, `claims` what is concluded, `figures` and `forest`
//! what is drawn; `film` and `replay` show one robot's life.

mod claims;
mod figures;
pub mod film;
mod forest;
pub mod life;
mod options;
pub mod recovery;
pub mod replay;
pub mod rivals;
mod tables;
mod trial;

pub use options::RecoverOptions;
pub use trial::{Entrant, Trial};

use self::replay::Scene;
use super::plan::Experiment;
use super::settled::SETTINGS;
use crate::device::meter::Load;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Claim, Results};
use crate::world::config::PioneerConfig;
use crate::world::damage::Damage;
use crate::world::pioneer::{ACTIONS, ITEMS};
use crate::world::setting::WorldOptions;

/// The experiment.
#[derive(Clone, Copy, Debug)]
pub struct Recover;

impl Experiment for Recover {
    type Options = RecoverOptions;
    type Case = u64;
    type Trial = Trial;

    const NAME: &'static str = "recover";
    const PHASE: &'static str = "recovering";

    fn cases(options: &RecoverOptions) -> Vec<u64> {
        options.seeds.clone()
    }

    fn part(options: &RecoverOptions, seeds: &[u64]) -> Option<RecoverOptions> {
        let seeds = seeds.to_vec();
        Some(RecoverOptions {
            seeds,
            ..options.clone()
        })
    }

    fn work(options: &RecoverOptions) -> u64 {
        trial::work(options)
    }

    fn trial(options: &RecoverOptions, &seed: &u64, ticker: &Ticker) -> Result<Trial, Failure> {
        trial::run(options, seed, ticker)
    }

    /// With the page of the first seed.
    fn judge(options: &RecoverOptions, trials: &[Trial]) -> Result<Results, Failure> {
        let results = Results::new(claims::summary(options, trials));
        let first = options.damages.first().map(Damage::id).unwrap_or_default();
        let id = |name: &str| format!("recover.{first}.{name}");
        let mut results = results.headline(
            "captures in the first 3000 damaged actions, as a share of an undamaged twin's",
            &[
                ("both levels with habits", &id("relearn_3000")),
                ("without habits", &id("no_habits_3000")),
                ("without surprise", &id("plain_3000")),
                ("without level 2", &id("no_level2_3000")),
                ("level 1", &id("level1_3000")),
            ],
        );
        results.worst_ticks = Load::of(trials.iter().map(|trial| &trial.load)).by_processor();
        results = results.file(SETTINGS, options.file()?);
        let drawn = forest::all(options, trials)?.into_iter();
        for (name, picture) in drawn.chain(figures::all(options, trials)?) {
            results = results.picture(&name, picture);
        }
        let first = options
            .seeds
            .iter()
            .zip(trials)
            .zip(&options.damages)
            .next();
        if let Some((
            (
                &seed,
                Trial {
                    film: Some(film), ..
                },
            ),
            &damage,
        )) = first
        {
            let scene = Scene::of(film, options, damage, seed);
            let replay = replay::replay(film, &scene);
            results = results
                .section("A life to watch", replay)
                .section("What it acted on", replay::spoken(film));
        }
        Ok(results)
    }
}

/// What is claimed of every damage and of none, with nothing measured.
pub(super) fn declared() -> Vec<Claim> {
    let parse = |text: &&str| Damage::parse(text, &ITEMS, &ACTIONS).ok();
    let reported = Damage::REPORTED.iter().filter_map(parse);
    let options = RecoverOptions {
        seeds: Vec::new(),
        world: WorldOptions {
            config: PioneerConfig::NOISY,
            layout: None,
            path: None,
        },
        damages: reported.chain([Damage::None]).collect(),
        protocol: life::Protocol::STANDARD,
    };
    claims::summary(&options, &[]).claims
}

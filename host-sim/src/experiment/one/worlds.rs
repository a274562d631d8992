//! Lives elsewhere: the lake, the shuttle, the vacuum cleaner, keys and doors, worlds by chance.
//!
//! A learner trains, then acts as well as it can; what it earns then is what counts.

use std::sync::Arc;

use cla_core::forest::Mind;
use cla_core::snapshot::Names;

use super::measured::Trial;
use super::options::OneOptions;
use crate::baseline::linear::Linear;
use crate::baseline::tabular::Tabular;
use crate::baseline::worlds as rivals;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::controller::{Controller, Untaught};
use crate::learner::mind::Minded;
use crate::learner::rewarded::{Income, rewarded};
use crate::progress::Ticker;
use crate::world::World;
use crate::world::generated::{Generated, Spec};
use crate::world::keys::Keys;
use crate::world::lake::Lake;
use crate::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
use crate::world::vacuum::Vacuum;

/// A world, how long one lives there, and by what one is judged.
struct Place<W> {
    name: &'static str,
    world: W,
    train: &'static [u32],
    test: u32,
    /// Of a test: the world before and after, and what was earned between.
    score: fn(&W, &W, &Income) -> f64,
}

impl<W: World + Clone> Place<W> {
    /// What a learner earns after so much training.
    fn life(
        &self,
        options: &OneOptions,
        train: u32,
        learner: &mut dyn Learner,
    ) -> Result<f64, Failure> {
        let mut world = self.world.clone();
        rewarded(learner, &mut world, options.length(train))?;
        learner.act()?;
        let before = world.clone();
        let income = rewarded(learner, &mut world, options.length(self.test))?;
        Ok((self.score)(&before, &world, &income))
    }

    /// A mind and the rival that was written by hand, after each training.
    fn lives<const WORDS: usize, const ALL: usize, const N: usize, C: Controller>(
        &self,
        options: &OneOptions,
        seed: u64,
        ticker: &Ticker,
        by_hand: fn() -> C,
        trial: &mut Trial,
    ) -> Result<(), Failure> {
        for &train in self.train {
            let mut mind = Minded::<WORDS, ALL, N>::born(options.config, [0.0; ALL], seed)?;
            let name = format!("{}.{train}", self.name);
            trial.note(name.clone(), self.life(options, train, &mut mind)?);
            let names = Names::of(self.world.items(), self.world.actions());
            ticker.keep(&format!("one-{seed}-{name}"), || mind.image(names))?;
            let mut hand = Untaught::new(by_hand(), seed);
            trial.note(
                format!("{name}.hand"),
                self.life(options, train, &mut hand)?,
            );
        }
        Ok(())
    }
}

/// Share of the episodes on the lake that end at the goal.
pub(super) fn lake(
    options: &OneOptions,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let place = Place {
        name: "lake",
        world: Lake::new(seed),
        train: &[20_000],
        test: 20_000,
        score: |_, _, income| income.per_episode(),
    };
    place.lives::<1, 16, 4, _>(options, seed, ticker, || rivals::lake::Careful, trial)
}

/// Reward an action of the shuttle.
pub(super) fn shuttle(
    options: &OneOptions,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let place = Place {
        name: "shuttle",
        world: PomdpWorld::new(Arc::new(Pomdp::parse(SHUTTLE)?), seed),
        train: &[20_000],
        test: 10_000,
        score: |_, _, income| income.per_action(),
    };
    place.lives::<1, 5, 3, _>(
        options,
        seed,
        ticker,
        rivals::shuttle::Docker::default,
        trial,
    )
}

/// A vacuum cleaner that tells fewer situations apart: `samples: 7_168, states: 128` in `brain!`.
pub(super) type LeanVacuum = Mind<1, 15, 5, 448, 200, 128, 128, 512>;

/// What the vacuum cleaner earns in its test.
pub(super) fn vacuum(
    options: &OneOptions,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let place = Place {
        name: "vacuum",
        world: Vacuum::new(seed),
        train: &[3_000, 20_000],
        test: 3000,
        score: |_, _, income| income.earned,
    };
    place.lives::<1, 15, 5, _>(
        options,
        seed,
        ticker,
        rivals::vacuum::Sweeper::default,
        trial,
    )?;
    let mut lean = Box::new(LeanVacuum::new());
    lean.be_born(options.config, [0.0; 15], seed)?;
    trial.note(
        "vacuum.20000.lean",
        place.life(options, 20_000, &mut *lean)?,
    );
    Ok(())
}

/// Shortest way over the way taken, mean of all tries; 0 for one that failed.
pub(super) fn keys(
    options: &OneOptions,
    seed: u64,
    ticker: &Ticker,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let place = Place {
        name: "keys",
        world: Keys::new(seed),
        train: &[50_000],
        test: 10_000,
        score: |before: &Keys, after, _| {
            let tries = (after.tries() - before.tries()).max(1);
            (after.efficiency() - before.efficiency()) / f64::from(tries)
        },
    };
    place.lives::<2, 48, 6, _>(
        options,
        seed,
        ticker,
        rivals::keys::Searcher::default,
        trial,
    )
}

/// The rivals in worlds by chance, as they are named in what is measured.
pub(super) const GENERATED_RIVALS: [&str; 4] = [
    "generated.sarsa",
    "generated.sarsa_history",
    "generated.linear",
    "generated.linear_history",
];

/// Share of the optimum in a world that the seed has made.
pub(super) fn generated(options: &OneOptions, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    const TRAIN: u32 = 20_000;
    let place = Place {
        name: "generated",
        world: Generated::new(Arc::new(Spec::random(seed)), seed),
        train: &[TRAIN],
        test: 5000,
        score: |_, world: &Generated, income| income.per_action() / world.optimum(),
    };
    // A generated world has its own number of actions.
    let earned = match place.world.actions().len() {
        3 => chance::<3>(&place, options, TRAIN, seed)?,
        4 => chance::<4>(&place, options, TRAIN, seed)?,
        5 => chance::<5>(&place, options, TRAIN, seed)?,
        6 => chance::<6>(&place, options, TRAIN, seed)?,
        7 => chance::<7>(&place, options, TRAIN, seed)?,
        8 => chance::<8>(&place, options, TRAIN, seed)?,
        9 => chance::<9>(&place, options, TRAIN, seed)?,
        10 => chance::<10>(&place, options, TRAIN, seed)?,
        11 => chance::<11>(&place, options, TRAIN, seed)?,
        _ => chance::<12>(&place, options, TRAIN, seed)?,
    };
    trial.note("generated.mind", earned);
    let actions = place.world.actions();
    let tuned = rivals::generated::TUNED;
    let learners: [Box<dyn Learner>; 4] = [
        Box::new(Tabular::with_actions(tuned.sarsa, actions, seed)),
        Box::new(Tabular::with_actions(tuned.sarsa_history, actions, seed)),
        Box::new(Linear::new(tuned.linear, &place.world, seed)),
        Box::new(Linear::new(tuned.linear_history, &place.world, seed)),
    ];
    for (name, mut rival) in GENERATED_RIVALS.into_iter().zip(learners) {
        trial.note(name, place.life(options, TRAIN, &mut *rival)?);
    }
    Ok(())
}

/// A mind with room for the most items, and for so many actions.
fn chance<const N: usize>(
    place: &Place<Generated>,
    options: &OneOptions,
    train: u32,
    seed: u64,
) -> Result<f64, Failure> {
    let mut mind = Minded::<2, 64, N>::born(options.config, [0.0; 64], seed)?;
    place.life(options, train, &mut mind)
}

//! What everybody earns in the worlds that are not the Pioneer's, and the grid of the learners' rivals.
//!
//! `cargo run --release -p host-sim --example worlds -- WORLD [SEEDS] [tune]`, where `WORLD` is
//! `lake`, `shuttle`, `vacuum`, `keys` or `generated`, and `SEEDS` how many from 0 on (10).
//! Every learner trains (20,000 actions; keys 50,000), then acts as well as it can; shown is what it
//! earns then, mean ± standard deviation over the seeds.
//! With `tune` it prints the best parameters of each rival instead.

use std::sync::Arc;

use cla_core::agent::{Adaptation, AgentConfig};
use host_sim::baseline::linear::{Linear, LinearConfig};
use host_sim::baseline::random::Random;
use host_sim::baseline::tabular::{History, Method, Tabular, TabularConfig, Traces};
use host_sim::baseline::worlds::believer::Believer;
use host_sim::baseline::worlds::{Tuned, generated, keys, lake, shuttle, vacuum};
use host_sim::failure::Failure;
use host_sim::learner::Learner;
use host_sim::learner::controller::Untaught;
use host_sim::learner::native::Native;
use host_sim::learner::rewarded::{Income, driven, rewarded};
use host_sim::world::World;
use host_sim::world::generated::{Generated, Spec, dweller};
use host_sim::world::keys::{Keys, seeker};
use host_sim::world::lake::{Lake, skater};
use host_sim::world::pomdp::planner::{Plan, PlanConfig};
use host_sim::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE, shuttle as shuttle_brain};
use host_sim::world::vacuum::{Vacuum, cleaner, planner};
use rayon::prelude::*;

type Learned = Result<Box<dyn Learner>, Failure>;

/// What to do, for who sees all of the world.
type Decide<W> = Box<dyn Fn(&W) -> usize>;

/// A world, how long one lives there, and by what one is judged.
struct Place<W> {
    make: fn(u64) -> W,
    train: u32,
    test: u32,
    /// Of a life: the world before and after, and what was earned between.
    score: fn(&W, &W, &Income) -> f64,
    planner: fn(&W) -> Decide<W>,
    hand: fn(&W, u64) -> Box<dyn Learner>,
    brain: fn(AgentConfig, u64) -> Learned,
    tuned: Tuned,
}

macro_rules! born {
    ($module:ident) => {
        |config, seed| {
            let mut brain = Box::new($module::brain());
            $module::be_born(&mut brain, config, seed)?;
            Ok(Box::new(Native::new(brain, Adaptation::Relearning)) as Box<dyn Learner>)
        }
    };
}

fn life<W: World + Clone>(
    place: &Place<W>,
    seed: u64,
    train: u32,
    mut learner: Box<dyn Learner>,
) -> Result<f64, Failure> {
    let mut world = (place.make)(seed);
    rewarded(&mut *learner, &mut world, train)?;
    learner.act()?;
    let before = world.clone();
    let income = rewarded(&mut *learner, &mut world, place.test)?;
    Ok((place.score)(&before, &world, &income))
}

/// Scores over the seeds, in their order.
fn lives<W: World + Clone + Send>(
    place: &Place<W>,
    seeds: u64,
    train: u32,
    learner: impl Fn(&W, u64) -> Learned + Sync,
) -> Result<Vec<f64>, Failure> {
    let seeds: Vec<u64> = (0..seeds).collect();
    let one = |&seed: &u64| life(place, seed, train, learner(&(place.make)(seed), seed)?);
    seeds.par_iter().map(one).collect()
}

fn mean(scores: &[f64]) -> f64 {
    scores.iter().fold(0.0, |sum, it| sum + it) / scores.len() as f64
}

fn show(name: &str, scores: &[f64]) {
    let middle = mean(scores);
    let squares = scores
        .iter()
        .fold(0.0, |sum, it| sum + (it - middle).powi(2));
    let spread = (squares / (scores.len().max(2) - 1) as f64).sqrt();
    println!("{name:24} {middle:9.4} ± {spread:.4}  n = {}", scores.len());
}

fn report<W: World + Clone + Send>(place: &Place<W>, seeds: u64) -> Result<(), Failure> {
    let tabular = |config: TabularConfig| {
        lives(place, seeds, place.train, move |world, seed| {
            Ok(Box::new(Tabular::with_actions(
                config,
                world.actions(),
                seed,
            )))
        })
    };
    let linear = |config: LinearConfig| {
        lives(place, seeds, place.train, move |world, seed| {
            Ok(Box::new(Linear::new(config, world, seed)))
        })
    };
    let brain = |config: AgentConfig| {
        lives(place, seeds, place.train, move |_, seed| {
            (place.brain)(config, seed)
        })
    };
    let planned: Vec<u64> = (0..seeds).collect();
    let planned: Vec<f64> = planned
        .par_iter()
        .map(|&seed| {
            let mut world = (place.make)(seed);
            let plan = (place.planner)(&world);
            let before = world.clone();
            let income = driven(&mut world, place.test, plan);
            (place.score)(&before, &world, &income)
        })
        .collect();
    show("planner", &planned);
    let random = |world: &W, seed| -> Learned {
        let actions = world.actions().len() as u32;
        Ok(Box::new(Untaught::new(Random { actions }, seed)))
    };
    show("random", &lives(place, seeds, 0, random)?);
    let hand = lives(place, seeds, place.train, |world, seed| {
        Ok((place.hand)(world, seed))
    })?;
    show("by hand", &hand);
    let Tuned {
        q,
        q_history,
        sarsa,
        sarsa_history,
        linear: votes,
        linear_history,
    } = place.tuned;
    show("Q", &tabular(q)?);
    show("Q, two steps", &tabular(q_history)?);
    show("Sarsa(λ)", &tabular(sarsa)?);
    show("Sarsa(λ), two steps", &tabular(sarsa_history)?);
    show("linear Sarsa(λ)", &linear(votes)?);
    show("linear, two steps", &linear(linear_history)?);
    show("FORAGER", &brain(AgentConfig::FORAGER)?);
    show("RESILIENT_LEVEL2", &brain(AgentConfig::RESILIENT_LEVEL2)?);
    Ok(())
}

/// The grid: α .03 .1 .3 .6, discount .8 .9 .98, λ .5 .9, untried actions worth 0 or `optimism`.
fn tune<W: World + Clone + Send>(place: &Place<W>, seeds: u64) -> Result<(), Failure> {
    for history in [History::None, History::TwoSteps] {
        let mut table: Vec<(f64, TabularConfig)> = Vec::new();
        let mut votes: Vec<(f64, LinearConfig)> = Vec::new();
        for alpha in [0.03, 0.1, 0.3, 0.6] {
            for discount in [0.8, 0.9, 0.98] {
                for (method, lambdas) in [
                    (Method::QLearning, &[0.0][..]),
                    (Method::Sarsa(Traces::Replacing), &[0.5, 0.9]),
                ] {
                    for &lambda in lambdas {
                        for optimism in [0.0, place.tuned.sarsa.optimism.max(0.5)] {
                            let config = TabularConfig {
                                method,
                                history,
                                alpha,
                                discount,
                                lambda,
                                optimism,
                                escape: None,
                                ..TabularConfig::Q
                            };
                            let scores = lives(place, seeds, place.train, |world, seed| {
                                let it = Tabular::with_actions(config, world.actions(), seed);
                                Ok(Box::new(it))
                            })?;
                            table.push((mean(&scores), config));
                        }
                    }
                }
                for lambda in [0.5, 0.9] {
                    let config = LinearConfig {
                        history,
                        alpha,
                        discount,
                        lambda,
                        ..LinearConfig::DEFAULT
                    };
                    let scores = lives(place, seeds, place.train, |world, seed| {
                        Ok(Box::new(Linear::new(config, world, seed)))
                    })?;
                    votes.push((mean(&scores), config));
                }
            }
        }
        table.sort_by(|a, b| b.0.total_cmp(&a.0));
        votes.sort_by(|a, b| b.0.total_cmp(&a.0));
        for q in [true, false] {
            let of_kind = table
                .iter()
                .filter(|it| (it.1.method == Method::QLearning) == q);
            for (score, it) in of_kind.take(3) {
                let (name, lambda) = (if q { "Q" } else { "Sarsa" }, it.lambda);
                println!(
                    "{history:?} {name}: {score:.4} alpha {} discount {} lambda {lambda} optimism {}",
                    it.alpha, it.discount, it.optimism
                );
            }
        }
        for (score, it) in votes.iter().take(3) {
            println!(
                "{history:?} linear: {score:.4} alpha {} discount {} lambda {}",
                it.alpha, it.discount, it.lambda
            );
        }
    }
    Ok(())
}

fn the_shuttle() -> Arc<Pomdp> {
    Arc::new(Pomdp::parse(SHUTTLE).expect("the project's own file can be read"))
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let world = arguments.first().map_or("", String::as_str);
    let seeds = arguments.get(1).map_or(Ok(10), |text| text.parse())?;
    let tuning = arguments.iter().any(|it| it == "tune");
    println!("{}", arguments.join(" "));
    // The largest brain passes over the stack once, on its way to the heap.
    let pool = rayon::ThreadPoolBuilder::new().stack_size(32 << 20);
    pool.build_global()?;
    match world {
        "lake" => {
            println!("optimum {:.4} of episodes", Lake::optimum().value(0));
            run(
                &Place {
                    make: Lake::new,
                    train: 20_000,
                    test: 20_000,
                    score: |_, _, income| income.per_episode(),
                    planner: |_| {
                        let plan = Lake::optimum();
                        Box::new(move |it| plan.action(it.field(), it.left() as usize))
                    },
                    hand: |_, seed| Box::new(Untaught::new(lake::Careful, seed)),
                    brain: born!(skater),
                    tuned: lake::TUNED,
                },
                seeds,
                tuning,
            )
        }
        "shuttle" => {
            let plan = Arc::new(Plan::new(the_shuttle(), PlanConfig::DEFAULT));
            let place = Place {
                make: |seed| PomdpWorld::new(the_shuttle(), seed),
                train: 20_000,
                test: 10_000,
                score: |_, _, income| income.per_action(),
                planner: |world: &PomdpWorld| {
                    let rate = world.model().model().rate(1e-9);
                    Box::new(move |it| rate.policy[it.state()])
                },
                hand: |_, seed| Box::new(Untaught::new(shuttle::Docker::default(), seed)),
                brain: born!(shuttle_brain),
                tuned: shuttle::TUNED,
            };
            let believing = lives(&place, seeds, 0, |_, seed| {
                let believer = Believer::new(Arc::clone(&plan));
                Ok(Box::new(Untaught::new(believer, seed)))
            })?;
            show("planner with a belief", &believing);
            let known = the_shuttle().model().rate(1e-9).gain;
            println!("optimum, states known {known:.4} an action");
            run(&place, seeds, tuning)
        }
        "vacuum" => run(
            &Place {
                make: Vacuum::new,
                train: 20_000,
                test: 3000,
                score: |_, _, income| income.earned,
                planner: |_| Box::new(planner::action),
                hand: |_, seed| Box::new(Untaught::new(vacuum::Sweeper::default(), seed)),
                brain: born!(cleaner),
                tuned: vacuum::TUNED,
            },
            seeds,
            tuning,
        ),
        "keys" => run(
            &Place {
                make: Keys::new,
                train: 50_000,
                test: 10_000,
                score: |before: &Keys, after, _| {
                    let tries = (after.tries() - before.tries()).max(1);
                    (after.efficiency() - before.efficiency()) / f64::from(tries)
                },
                planner: |_| Box::new(Keys::planned),
                hand: |_, seed| Box::new(Untaught::new(keys::Searcher::default(), seed)),
                brain: born!(seeker),
                tuned: keys::TUNED,
            },
            seeds,
            tuning,
        ),
        "generated" => run(
            &Place {
                make: |seed| Generated::new(Arc::new(Spec::random(seed)), seed),
                train: 20_000,
                test: 5000,
                score: |_, world: &Generated, income| income.per_action() / world.optimum(),
                planner: |world: &Generated| {
                    let rate = world.spec().model().rate(1e-6);
                    Box::new(move |it| rate.policy[it.state()])
                },
                hand: |world: &Generated, seed| {
                    let engineer = generated::Engineer::new(Arc::clone(world.spec()));
                    Box::new(Untaught::new(engineer, seed))
                },
                brain: born!(dweller),
                tuned: generated::TUNED,
            },
            seeds,
            tuning,
        ),
        other => Err(format!(
            "{other:?} is no world: there are lake, shuttle, vacuum, keys and generated"
        )
        .into()),
    }
}

fn run<W: World + Clone + Send>(place: &Place<W>, seeds: u64, tuning: bool) -> Result<(), Failure> {
    if tuning {
        tune(place, seeds)
    } else {
        report(place, seeds)
    }
}

//! What an action of the forager does, learned by each kind of module: prototypes as candidate schemas
//! (book, 5.3.1).
//!
//! A random forager goes forward now and then; what its seven items were before and after is a stimulus.
//! Components have no prototypes: theirs are the means of what each of their units was most active in.

use std::collections::BTreeSet;

use cla_core::map::{ActionSomBank, ResultCoding, Sample, TrainingConfig};
use cla_core::num::Rng;
use cla_core::word::{ActionId, ItemId};
use serde::{Deserialize, Serialize};

use super::make::made;
use super::module::{Kind, Module, Plan, least, squared_distance};
use crate::failure::Failure;
use crate::world::config::PioneerConfig;
use crate::world::pioneer::{ACTIONS, FORWARD, ITEMS, Pioneer};
use crate::world::{Percept, World};

/// Items of the forager.
const COUNT: usize = ITEMS.len();
/// Nodes on each side of a map.
const SIDE: usize = 10;
/// The thresholds of the book's harvest: on above the first, off below the second.
const HARVEST: (f32, f32) = (0.9, 0.1);
/// Contexts that differ by no more than this are the same: the one that has won most often is meant.
const SAME: f32 = 0.01;

/// What the prototypes of one action are worth on transitions that were not trained.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Schemas {
    /// Prototypes that have won at least once.
    pub prototypes: f64,
    /// Different candidate schemas among them, by the book's thresholds.
    pub candidates: f64,
    /// Mean distance of a transition from the nearest prototype.
    pub quantization: f64,
    /// The share of transitions whose whole result the prototype with the nearest context says.
    pub predicted: f64,
    /// The share that a candidate has said: its context held and so did its result.
    pub covered: f64,
    /// Of all results that candidates said whose context held, the share that came true.
    pub reliability: f64,
    /// Bytes while it learns.
    pub bytes: f64,
}

/// One transition.
type Step = (Percept, Percept);

/// The transitions of an action in a life of random actions, those to learn and those to test.
pub(super) struct Transitions {
    learned: Vec<Step>,
    tested: Vec<Step>,
}

impl Transitions {
    /// A life of so many actions.
    pub(super) fn lived(actions: u32, seed: u64) -> Result<Self, Failure> {
        let mut world = Pioneer::new(PioneerConfig::NOISY, seed)?;
        let mut rng = Rng::stream(seed, 6);
        let mut steps = Vec::new();
        for _ in 0..actions {
            let action = rng.below(ACTIONS.len() as u32) as usize;
            let before = world.sense();
            world.act(action);
            if action == FORWARD {
                steps.push((before, world.sense()));
            }
            while world.reflex().is_some() {}
        }
        let tested = steps.split_off(2 * steps.len() / 3);
        Ok(Self {
            learned: steps,
            tested,
        })
    }

    /// What is right most often: the most frequent result of each context, as often as it was there.
    pub(super) fn ceiling(&self) -> f64 {
        let codes = |steps: &[Step]| -> Vec<(u32, u32)> {
            let code = |it: &Percept| it.on().words()[0];
            steps.iter().map(|(a, b)| (code(a), code(b))).collect()
        };
        let learned = codes(&self.learned);
        let said = |context: u32| -> Option<u32> {
            let results: Vec<u32> = learned
                .iter()
                .filter(|it| it.0 == context)
                .map(|it| it.1)
                .collect();
            let often = |it: u32| results.iter().filter(|&&other| other == it).count();
            let all: BTreeSet<u32> = results.iter().copied().collect();
            // Of equals the first: the larger codes do not replace it.
            all.into_iter().rev().max_by_key(|&it| often(it))
        };
        let tested = codes(&self.tested);
        let right = tested.iter().filter(|it| said(it.0) == Some(it.1)).count();
        right as f64 / tested.len() as f64
    }
}

fn values(it: &Percept) -> impl Iterator<Item = f32> {
    let on = *it;
    (0..COUNT as u16).map(move |item| f32::from(u8::from(on.get(ItemId(item)) == Some(true))))
}

fn joined((before, after): &Step) -> Vec<f32> {
    values(before).chain(values(after)).collect()
}

/// Teaches a module of a kind, and reads it.
pub(super) fn run(
    kind: Kind,
    trial: usize,
    transitions: &Transitions,
    seed: u64,
) -> Result<Schemas, Failure> {
    let plan = Plan {
        side: SIDE,
        features: 2 * COUNT,
        samples: transitions.learned.len() as u32,
        ..Plan::DEFAULT
    };
    let mut module = made(kind, &plan, trial, &mut Rng::stream(seed, 7))?;
    let stimuli: Vec<Vec<f32>> = transitions.learned.iter().map(joined).collect();
    for stimulus in &stimuli {
        module.learn(stimulus);
    }
    module.settle();
    let prototypes = module
        .prototypes()
        .unwrap_or_else(|| stood_for(&*module, &stimuli));
    Ok(judged(&prototypes, &transitions.tested, module.bytes()))
}

/// The same of the core's own Action SOM, which recruits nodes for what is rare.
pub(super) fn action_som(transitions: &Transitions, seed: u64) -> Schemas {
    let mut bank = Box::new(ActionSomBank::<SIDE, SIDE, COUNT, 1>::new());
    bank.randomize(&mut Rng::stream(seed, 7));
    for (before, after) in &transitions.learned {
        let sample = Sample::new(before, after, ResultCoding::EndState, COUNT as u16);
        bank.train(ActionId(0), &sample, &TrainingConfig::FORAGER);
    }
    let map = &bank.maps()[0];
    let read = map.nodes().map(|node| {
        let items = 0..COUNT as u16;
        let context = items.clone().map(|it| map.context_weight(node, it));
        let result = items.map(|it| map.result_weight(node, it));
        (context.chain(result).collect(), u32::from(map.wins(node)))
    });
    let prototypes: Vec<_> = read.collect();
    judged(&prototypes, &transitions.tested, size_of_val(&*bank))
}

/// The mean of the stimuli that each unit was most active in.
fn stood_for(module: &dyn Module, stimuli: &[Vec<f32>]) -> Vec<(Vec<f32>, u32)> {
    let mut means = vec![(vec![0.0; 2 * COUNT], 0_u32); module.units()];
    let mut units = vec![0.0; module.units()];
    for stimulus in stimuli {
        module.respond(stimulus, &mut units);
        let silence: Vec<f32> = units.iter().map(|it| -it).collect();
        let (mean, wins) = &mut means[least(&silence)];
        *wins += 1;
        super::module::approach(mean, stimulus, 1.0 / *wins as f32);
    }
    means
}

fn judged(prototypes: &[(Vec<f32>, u32)], tested: &[Step], bytes: usize) -> Schemas {
    let won: Vec<&(Vec<f32>, u32)> = prototypes.iter().filter(|it| it.1 > 0).collect();
    let candidates: BTreeSet<Vec<i8>> = won
        .iter()
        .map(|it| harvested(&it.0))
        .filter(|it| it[COUNT..].iter().any(|&sign| sign != 0))
        .collect();
    let mut found = Schemas {
        prototypes: won.len() as f64,
        candidates: candidates.len() as f64,
        bytes: bytes as f64,
        ..Schemas::default()
    };
    let (mut said, mut came_true) = (0_u32, 0_u32);
    let share = 1.0 / tested.len() as f64;
    for step in tested {
        let stimulus = joined(step);
        let all: Vec<f32> = won
            .iter()
            .map(|it| squared_distance(&stimulus, &it.0))
            .collect();
        found.quantization += share * f64::from(all[least(&all)]).sqrt();
        let (context, result) = stimulus.split_at(COUNT);
        let says = &meant(&won, context)[COUNT..];
        let right = says
            .iter()
            .zip(result)
            .all(|(says, is)| (*says > 0.5) == (*is > 0.5));
        found.predicted += share * f64::from(u8::from(right));
        let mut covered = false;
        for candidate in &candidates {
            if holds(&candidate[..COUNT], context) {
                let true_now = holds(&candidate[COUNT..], result);
                said += 1;
                came_true += u32::from(true_now);
                covered |= true_now;
            }
        }
        found.covered += share * f64::from(u8::from(covered));
    }
    found.reliability = f64::from(came_true) / f64::from(said.max(1));
    found
}

/// The prototype with the nearest context; of equally near ones that which has won most often.
fn meant<'a>(won: &[&'a (Vec<f32>, u32)], context: &[f32]) -> &'a [f32] {
    let distances: Vec<f32> = won
        .iter()
        .map(|it| squared_distance(context, &it.0[..COUNT]))
        .collect();
    let nearest = least(&distances);
    let mut best = won[nearest];
    for (&it, distance) in won.iter().zip(&distances) {
        if *distance <= distances[nearest] + SAME && it.1 > best.1 {
            best = it;
        }
    }
    &best.0
}

/// 1 for a positive item, −1 for a negative one, 0 for neither.
fn harvested(prototype: &[f32]) -> Vec<i8> {
    let sign = |&it: &f32| i8::from(it > HARVEST.0) - i8::from(it < HARVEST.1);
    prototype.iter().map(sign).collect()
}

fn holds(signs: &[i8], values: &[f32]) -> bool {
    let mut pairs = signs.iter().zip(values);
    pairs.all(|(&sign, &is)| match sign {
        0 => true,
        _ => (sign > 0) == (is > 0.5),
    })
}

#[cfg(test)]
mod tests {
    use super::{COUNT, Percept, judged, meant};
    use cla_core::word::ItemId;

    #[test]
    fn of_prototypes_with_one_context_the_one_that_won_most_is_meant() {
        let result = |on: usize, wins| {
            let mut prototype = vec![0.0; 2 * COUNT];
            prototype[COUNT + on] = 1.0;
            (prototype, wins)
        };
        let all = [result(1, 2), result(2, 5), result(3, 4)];
        let won: Vec<_> = all.iter().collect();
        assert_eq!(meant(&won, &[0.0; COUNT]), all[1].0);
    }

    #[test]
    fn a_prototype_says_what_it_was_taught_and_covers_nothing_else() {
        let off = Percept::all_off(COUNT as u16);
        let mut on = off;
        on.set(ItemId(2), Some(true)).unwrap();
        let mut prototype = vec![0.0; 2 * COUNT];
        prototype[COUNT + 2] = 1.0;
        let unused = (vec![0.5; 2 * COUNT], 0);
        let found = judged(&[(prototype, 5), unused], &[(off, on), (off, off)], 1);
        assert_eq!((found.prototypes, found.candidates), (1.0, 1.0));
        assert_eq!((found.predicted, found.covered), (0.5, 0.5));
        assert_eq!((found.reliability, found.quantization), (0.5, 0.5));
    }
}

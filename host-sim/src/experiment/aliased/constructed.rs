//! What the items that a second level has constructed say of the state that no percept shows.
//!
//! The measure is mutual information given the percept, in bits: how much less uncertain the state is
//! for who sees the percept and knows the item, than for who sees the percept alone.
//! Counts of few moments overstate it, so the same is counted with items exchanged by chance among
//! moments of the same percept, and taken off.

use std::collections::BTreeMap;

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::who::Living;
use crate::failure::Failure;
use crate::world::World;
use crate::world::pomdp::PomdpWorld;

/// Actions that are looked at.
pub(super) const ACTIONS: u32 = 10_000;
/// Items that are told apart.
const MOST: usize = 3;

/// What is known of the state in one world.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Constructed {
    /// Entropy of the state given the percept, bits.
    pub hidden: f64,
    /// What the constructed item says of it, bits, less what chance says.
    pub told: f64,
    /// The same of the percept and action before: all that one step of history knows.
    pub step: f64,
    /// Items that were ever on.
    pub items: u32,
    /// Those that say most.
    pub best: Vec<Item>,
}

/// A constructed item and the state that it stands for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Item {
    /// Its schema, in the book's notation.
    pub schema: String,
    /// The percept with which it says most.
    pub percept: String,
    /// The state that is likeliest then.
    pub state: String,
    /// How likely that is.
    pub sure: f64,
    /// How likely the state is when the percept alone is known.
    pub without: f64,
    /// Its part of all that is told, bits.
    pub bits: f64,
}

/// A moment: percept, what is known beside it, state.
type Moment = (usize, usize, usize);

/// Watches a learner act.
pub(super) fn of(
    learner: &mut dyn Living,
    mut world: PomdpWorld,
    actions: u32,
    seed: u64,
) -> Result<Constructed, Failure> {
    learner.act()?;
    let kinds = world.actions().len();
    let (mut by_item, mut by_step) = (Vec::new(), Vec::new());
    let mut before = 0;
    for _ in 0..actions {
        let now = world.sense();
        let seen = now.on().iter().next().map_or(0, |it| usize::from(it.0) + 1);
        let item = learner.believes().map_or(0, |it| usize::from(it) + 1);
        by_item.push((seen, item, world.state()));
        by_step.push((seen, before, world.state()));
        let action = learner.choose(&now)?;
        let had = world.earned();
        world.act(action);
        learner.learn_with(&world.sense(), (world.earned() - had) as f32)?;
        before = 1 + seen * kinds + action;
    }
    let mut rng = Rng::stream(seed, 65);
    let hidden = entropy(&by_item);
    let names = (world.items(), world.actions());
    let best = best(&by_item)
        .into_iter()
        .map(|(bits, seen, item, state, sure, without)| Item {
            schema: learner.tells(item as u16, names),
            percept: seen
                .checked_sub(1)
                .map_or("nothing", |it| names.0[it])
                .to_owned(),
            state: world.model().states()[state].to_owned(),
            sure,
            without,
            bits,
        });
    let met: std::collections::BTreeSet<usize> = by_item.iter().map(|it| it.1).collect();
    Ok(Constructed {
        hidden,
        told: beyond_chance(&by_item, &mut rng),
        step: beyond_chance(&by_step, &mut rng),
        items: met.iter().filter(|&&it| it > 0).count() as u32,
        best: best.collect(),
    })
}

/// States by what is known of them.
fn counted<K: Ord>(
    moments: &[Moment],
    known: impl Fn(&Moment) -> K,
) -> BTreeMap<K, BTreeMap<usize, f64>> {
    let mut counts: BTreeMap<K, BTreeMap<usize, f64>> = BTreeMap::new();
    for moment in moments {
        *counts
            .entry(known(moment))
            .or_default()
            .entry(moment.2)
            .or_insert(0.0) += 1.0;
    }
    counts
}

fn total(states: &BTreeMap<usize, f64>) -> f64 {
    states.values().fold(0.0, |sum, it| sum + it)
}

/// Entropy of the state given what is known, bits.
fn uncertain<K: Ord>(moments: &[Moment], known: impl Fn(&Moment) -> K) -> f64 {
    let all = moments.len().max(1) as f64;
    let mut sum = 0.0;
    for states in counted(moments, known).values() {
        let total = total(states);
        for count in states.values() {
            sum -= count / all * libm::log2(count / total);
        }
    }
    sum
}

fn entropy(moments: &[Moment]) -> f64 {
    uncertain(moments, |it| it.0)
}

/// What is told beside the percept, bits.
pub(super) fn told(moments: &[Moment]) -> f64 {
    entropy(moments) - uncertain(moments, |it| (it.0, it.1))
}

/// The same, less what it is when what is known is exchanged among moments of the same percept.
pub(super) fn beyond_chance(moments: &[Moment], rng: &mut Rng) -> f64 {
    let mut exchanged = moments.to_vec();
    let mut places: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (at, moment) in moments.iter().enumerate() {
        places.entry(moment.0).or_default().push(at);
    }
    for places in places.values() {
        for last in (1..places.len()).rev() {
            let other = rng.below(last as u32 + 1) as usize;
            let (a, b) = (places[last], places[other]);
            let kept = exchanged[a].1;
            exchanged[a].1 = exchanged[b].1;
            exchanged[b].1 = kept;
        }
    }
    told(moments) - told(&exchanged)
}

/// Bits, percept, item, state, how likely it is, and how likely without the item; the most bits first.
fn best(moments: &[Moment]) -> Vec<(f64, usize, usize, usize, f64, f64)> {
    let all = moments.len().max(1) as f64;
    let alone = counted(moments, |it| it.0);
    let mut rows: BTreeMap<usize, (f64, usize, usize, usize, f64, f64)> = BTreeMap::new();
    for ((seen, item), states) in counted(moments, |it| (it.0, it.1)) {
        // Moments in which no item was on have no row.
        let Some(item) = item.checked_sub(1) else {
            continue;
        };
        let here = total(&states);
        let others = &alone[&seen];
        let among = total(others);
        let mut bits = 0.0;
        let mut likeliest = (0.0, 0, 0.0);
        for (&state, &count) in &states {
            let (sure, without) = (count / here, others[&state] / among);
            bits += count / all * libm::log2(sure / without);
            if sure > likeliest.0 {
                likeliest = (sure, state, without);
            }
        }
        let row = (bits, seen, item, likeliest.1, likeliest.0, likeliest.2);
        let kept = rows.entry(item).or_insert(row);
        if row.0 > kept.0 {
            *kept = row;
        }
    }
    let mut rows: Vec<_> = rows.into_values().collect();
    rows.sort_by(|a, b| b.0.total_cmp(&a.0));
    rows.truncate(MOST);
    rows
}

//! Goals that no schema has as its result: what neighbours on the map offer instead.
//!
//! A schema is a node, an action and the node that most often followed; none is known that begins or ends
//! at the goal's node.
//! A plan spreads the goal's value backwards through schemas.
//! With neighbours a node is worth a share of what the best of its neighbours is; where no schema leads
//! nearer, the schema of the neighbour that one came from is done once more.

use cla_core::num::Rng;

use super::places::{NODES, Places};
use super::room::{ACTIONS, Place, anywhere, apart, stepped};
use super::values::REACHED;
use crate::failure::Failure;

/// An attempt begins at least so many metres from the goal.
const FAR: f32 = 3.0;
/// Steps of exploring.
const EXPLORED: u32 = 6000;
/// Steps in which a goal must be reached.
const LIMIT: u32 = 40;
/// Attempts at a goal.
const ATTEMPTS: u32 = 10;
/// What a step towards the goal leaves of its value.
const DISCOUNT: f32 = 0.95;
/// Rounds of a plan; values have spread through the whole map before.
const ROUNDS: usize = 60;

/// The share of attempts that reach goals without a schema; `shared` is what a node is worth of the best
/// of its neighbours, 0 without neighbours.
pub(super) fn reached(places: &Places, goals: u32, shared: f32, seed: u64) -> Result<f64, Failure> {
    let mut rng = Rng::stream(seed, 3);
    let mut sum = 0.0;
    for _ in 0..goals {
        let goal = anywhere(&mut rng);
        let node = places.node(goal)?;
        let results = explored(places, node, &mut rng)?;
        let plan = Plan::new(&results, node, shared);
        for _ in 0..ATTEMPTS {
            sum += f64::from(u8::from(attempt(places, &plan, goal, &mut rng)?));
        }
    }
    Ok(sum / f64::from(goals * ATTEMPTS))
}

/// The node that each action most often led to from each node; nothing of the goal's own.
fn explored(
    places: &Places,
    goal: usize,
    rng: &mut Rng,
) -> Result<Vec<[Option<usize>; ACTIONS]>, Failure> {
    let mut counts = vec![[[0_u32; NODES]; ACTIONS]; NODES];
    for _ in 0..EXPLORED {
        let before = anywhere(rng);
        let action = rng.below(ACTIONS as u32) as usize;
        let after = stepped(before, action, false, rng);
        let [from, to] = [places.node(before)?, places.node(after)?];
        if from != goal && to != goal {
            counts[from][action][to] += 1;
        }
    }
    let most = |counts: &[u32; NODES]| {
        let mut most = None;
        for (node, &count) in counts.iter().enumerate() {
            if count > 0 && most.is_none_or(|it: usize| count > counts[it]) {
                most = Some(node);
            }
        }
        most
    };
    Ok(counts.iter().map(|it| it.each_ref().map(most)).collect())
}

/// What to do at a node.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Strategy {
    /// The action of one of its own schemas.
    Own(usize),
    /// Once more what was done last, which is a schema of the neighbour that one came from.
    Again,
    /// Anything: nothing leads to the goal.
    Chance,
}

/// What to do at each node.
struct Plan {
    strategies: Vec<Strategy>,
}

impl Plan {
    fn new(results: &[[Option<usize>; ACTIONS]], goal: usize, shared: f32) -> Self {
        let mut worth = vec![0.0_f32; NODES];
        let mut strategies = vec![Strategy::Chance; NODES];
        for _ in 0..ROUNDS {
            let before = worth.clone();
            for (node, value) in worth.iter_mut().enumerate() {
                let own = best(&results[node], &before, node);
                let lent = Places::neighbours(node).map(|it| before[it]);
                let lent = shared * lent.fold(0.0, f32::max);
                (strategies[node], *value) = match own {
                    Some((action, own)) if own >= lent => (Strategy::Own(action), own),
                    _ if lent > 0.0 => (Strategy::Again, lent),
                    _ => (Strategy::Chance, 0.0),
                };
            }
            worth[goal] = 1.0;
        }
        Self { strategies }
    }
}

/// The action whose result is worth most, and that; none when no result that is another node is worth
/// anything.
fn best(results: &[Option<usize>; ACTIONS], worth: &[f32], node: usize) -> Option<(usize, f32)> {
    let mut best: Option<(usize, f32)> = None;
    for (action, result) in results.iter().enumerate() {
        let Some(result) = result.filter(|&it| it != node) else {
            continue;
        };
        let value = DISCOUNT * worth[result];
        if value > 0.0 && best.is_none_or(|it| value > it.1) {
            best = Some((action, value));
        }
    }
    best
}

fn attempt(places: &Places, plan: &Plan, goal: Place, rng: &mut Rng) -> Result<bool, Failure> {
    let mut place = loop {
        let place = anywhere(rng);
        if apart(place, goal) >= FAR {
            break place;
        }
    };
    let by_chance = |rng: &mut Rng| rng.below(ACTIONS as u32) as usize;
    let mut last = by_chance(rng);
    for _ in 0..LIMIT {
        last = match plan.strategies[places.node(place)?] {
            Strategy::Own(action) => action,
            Strategy::Again => last,
            Strategy::Chance => by_chance(rng),
        };
        place = stepped(place, last, false, rng);
        if apart(place, goal) < REACHED {
            return Ok(true);
        }
    }
    Ok(false)
}

#[cfg(test)]
mod tests {
    use super::{Plan, Strategy};
    use crate::experiment::neighbours::places::NODES;

    #[test]
    fn a_goal_without_a_schema_has_a_plan_only_by_its_neighbours() {
        // Node 0 leads to node 1, which is beside the goal, node 2, and nothing leads to that.
        let mut results = vec![[None; 4]; NODES];
        results[0][3] = Some(1);
        let alone = Plan::new(&results, 2, 0.0);
        assert!(alone.strategies.iter().all(|&it| it == Strategy::Chance));
        let plan = Plan::new(&results, 2, 0.5);
        assert_eq!(plan.strategies[0], Strategy::Own(3));
        assert_eq!(plan.strategies[1], Strategy::Again);
    }
}

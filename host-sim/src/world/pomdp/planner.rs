//! The best that can be done in a world of a file by who knows the file, but not the state.
//!
//! Point-based value iteration (Pineau, Gordon and Thrun 2003): the value of a belief is the best of
//! some linear functions, one backed up for each of the beliefs that a random life has met.

use std::sync::Arc;

use cla_core::num::Rng;

use super::model::{Pomdp, draw};

/// How a plan is made.
///
/// ```
/// use host_sim::world::pomdp::planner::PlanConfig;
/// assert!(PlanConfig::DEFAULT.discount < 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanConfig {
    /// Discount of the future, in `[0, 1)`.
    pub discount: f64,
    /// Beliefs, at most.
    pub points: usize,
    /// Steps of the random life that meets them.
    pub steps: u32,
    /// Least distance between two of them: the sum over the states.
    pub apart: f64,
    /// Backups of all of them.
    pub sweeps: u32,
}

impl PlanConfig {
    /// Enough for worlds of a few dozen states, in seconds.
    pub const DEFAULT: Self = Self {
        discount: 0.98,
        points: 200,
        steps: 20_000,
        apart: 0.08,
        sweeps: 250,
    };
}

/// What to do in every belief.
///
/// ```
/// use std::sync::Arc;
/// use host_sim::world::pomdp::planner::{Plan, PlanConfig};
/// use host_sim::world::pomdp::{Pomdp, SHUTTLE};
/// let quick = PlanConfig { points: 20, sweeps: 20, ..PlanConfig::DEFAULT };
/// let plan = Plan::new(Arc::new(Pomdp::parse(SHUTTLE)?), quick);
/// // At a dock, whose back is to the other: forward.
/// assert_eq!(plan.action(plan.model().start()), 1);
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plan {
    model: Arc<Pomdp>,
    /// A value for each state, and the action that it begins with.
    vectors: Vec<(Vec<f64>, usize)>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (x, y)| sum + x * y)
}

/// What is believed after an action and what is seen then; as before if that cannot be.
#[must_use]
pub fn believed(model: &Pomdp, belief: &[f64], action: usize, seen: usize) -> Vec<f64> {
    let mut after = vec![0.0; belief.len()];
    for (state, &share) in belief.iter().enumerate().filter(|it| *it.1 > 0.0) {
        for (next, &chance) in model.next(action, state).iter().enumerate() {
            if chance > 0.0 {
                after[next] += share * chance * model.observed(action, next)[seen];
            }
        }
    }
    let total = after.iter().fold(0.0, |sum, it| sum + it);
    if total <= 0.0 {
        return belief.to_vec();
    }
    for it in &mut after {
        *it /= total;
    }
    after
}

impl Plan {
    /// Plans; the same for the same file and configuration.
    #[must_use]
    pub fn new(model: Arc<Pomdp>, config: PlanConfig) -> Self {
        let points = points(&model, config);
        let (states, actions) = (model.states.len(), model.actions.len());
        let earned: Vec<Vec<f64>> = (0..actions)
            .map(|action| (0..states).map(|it| model.expected(action, it)).collect())
            .collect();
        // The worst for ever: no backup can be below.
        let least = earned.iter().flatten().copied().fold(0.0, f64::min);
        let mut vectors = vec![(vec![least / (1.0 - config.discount); states], 0)];
        for _ in 0..config.sweeps {
            vectors = backed_up(&model, config.discount, &earned, &points, &vectors);
        }
        Self { model, vectors }
    }

    /// The file that it was made for.
    #[must_use]
    pub const fn model(&self) -> &Arc<Pomdp> {
        &self.model
    }

    /// The best action of a belief.
    #[must_use]
    pub fn action(&self, belief: &[f64]) -> usize {
        let mut best = (f64::NEG_INFINITY, 0);
        for (vector, action) in &self.vectors {
            let worth = dot(belief, vector);
            if worth > best.0 {
                best = (worth, *action);
            }
        }
        best.1
    }
}

/// Beliefs that a random life meets, none near another.
fn points(model: &Pomdp, config: PlanConfig) -> Vec<Vec<f64>> {
    let mut rng = Rng::stream(0, 63);
    let mut belief = model.start.clone();
    let mut points = vec![belief.clone()];
    for _ in 0..config.steps {
        if points.len() >= config.points {
            break;
        }
        let action = rng.below(model.actions.len() as u32) as usize;
        let state = draw(&belief, &mut rng);
        let next = draw(model.next(action, state), &mut rng);
        let seen = draw(model.observed(action, next), &mut rng);
        belief = believed(model, &belief, action, seen);
        let distance = |other: &Vec<f64>| {
            let pairs = other.iter().zip(&belief);
            pairs.fold(0.0, |sum, (x, y)| sum + (x - y).abs())
        };
        if points.iter().all(|it| distance(it) > config.apart) {
            points.push(belief.clone());
        }
    }
    points
}

fn backed_up(
    model: &Pomdp,
    discount: f64,
    earned: &[Vec<f64>],
    points: &[Vec<f64>],
    vectors: &[(Vec<f64>, usize)],
) -> Vec<(Vec<f64>, usize)> {
    let states = model.states.len();
    // By action, observation, vector: what the vector is worth before the action, if this is seen.
    let before: Vec<Vec<Vec<Vec<f64>>>> = (0..model.actions.len())
        .map(|action| {
            let seen_by = |seen: usize| {
                let through = |(vector, _): &(Vec<f64>, usize)| -> Vec<f64> {
                    let worth = |state: usize| {
                        let next = model.next(action, state).iter().enumerate();
                        next.fold(0.0, |sum, (next, &chance)| {
                            let sight = model.observed(action, next)[seen];
                            sum + discount * chance * sight * vector[next]
                        })
                    };
                    (0..states).map(worth).collect()
                };
                vectors.iter().map(through).collect()
            };
            (0..model.observations.len()).map(seen_by).collect()
        })
        .collect();
    let mut new: Vec<(Vec<f64>, usize)> = Vec::new();
    for point in points {
        let mut best: (f64, Vec<f64>, usize) = (f64::NEG_INFINITY, Vec::new(), 0);
        for (action, by_seen) in before.iter().enumerate() {
            let mut vector = earned[action].clone();
            for candidates in by_seen {
                let worth = |it: &&Vec<f64>| dot(point, it);
                let most = candidates
                    .iter()
                    .max_by(|a, b| worth(a).total_cmp(&worth(b)));
                for (sum, value) in vector.iter_mut().zip(most.into_iter().flatten()) {
                    *sum += value;
                }
            }
            let worth = dot(point, &vector);
            if worth > best.0 {
                best = (worth, vector, action);
            }
        }
        let same = |other: &(Vec<f64>, usize)| {
            let mut pairs = other.0.iter().zip(&best.1);
            other.1 == best.2 && pairs.all(|(x, y)| (x - y).abs() < 1e-6)
        };
        if !new.iter().any(same) {
            new.push((best.1, best.2));
        }
    }
    new
}

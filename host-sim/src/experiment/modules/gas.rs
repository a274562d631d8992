//! Growing neural gas (Fritzke 1995): units grow where the error is, edges tell who is whose neighbour.

use super::module::{FUNCTION, Module, Plan, Work, activate, approach, squared_distance};

/// An edge that no stimulus has renewed for so many of its ends' wins is cut (Fritzke's a_max).
const OLDEST: u16 = 50;
/// What is left of the errors of both parents of a new unit (Fritzke's α).
const PARENTS: f32 = 0.5;
/// What is left of all errors after each stimulus (Fritzke's d).
const DECAY: f32 = 0.995;
/// The neighbours of a winner move by this share of its rate; Fritzke has .006 of .2.
const NEIGHBOURS: f32 = 0.03;

/// Units and their edges; there is memory for as many units as a map has.
pub(super) struct Gas {
    weights: Vec<f32>,
    errors: Vec<f32>,
    wins: Vec<u32>,
    alive: Vec<bool>,
    /// units · units: 0 without an edge, else its age and one.
    edges: Vec<u16>,
    features: usize,
    width: f32,
    rate: f32,
    /// Stimuli from one new unit to the next (Fritzke's λ).
    every: u32,
    samples: u32,
    moved: u64,
}

impl Gas {
    /// No units yet; all are there after half of the samples of `plan`. A winner moves by `rate`.
    pub(super) fn new(plan: &Plan, rate: f32) -> Self {
        let units = plan.units();
        Self {
            weights: vec![0.0; units * plan.features],
            errors: vec![0.0; units],
            wins: vec![0; units],
            alive: vec![false; units],
            edges: vec![0; units * units],
            features: plan.features,
            width: plan.width,
            rate,
            every: (plan.samples / (2 * units as u32)).max(1),
            samples: 0,
            moved: 0,
        }
    }

    fn living(&self) -> usize {
        self.alive.iter().filter(|&&it| it).count()
    }

    fn weights(&self, unit: usize) -> &[f32] {
        &self.weights[unit * self.features..][..self.features]
    }

    fn weights_mut(&mut self, unit: usize) -> &mut [f32] {
        &mut self.weights[unit * self.features..][..self.features]
    }

    fn distances(&self, stimulus: &[f32]) -> Vec<f32> {
        let all = (0..self.alive.len()).map(|unit| {
            if self.alive[unit] {
                squared_distance(stimulus, self.weights(unit))
            } else {
                f32::INFINITY
            }
        });
        all.collect()
    }

    fn edge(&self, a: usize, b: usize) -> u16 {
        self.edges[a * self.alive.len() + b]
    }

    fn set_edge(&mut self, a: usize, b: usize, age: u16) {
        let units = self.alive.len();
        self.edges[a * units + b] = age;
        self.edges[b * units + a] = age;
    }

    fn neighbours(&self, unit: usize) -> Vec<usize> {
        let all = 0..self.alive.len();
        all.filter(|&it| self.edge(unit, it) > 0).collect()
    }

    /// The living unit with the largest error among these; of equals the first.
    fn worst(&self, among: &[usize]) -> Option<usize> {
        let mut worst: Option<usize> = None;
        for &it in among {
            if self.alive[it] && worst.is_none_or(|than| self.errors[it] > self.errors[than]) {
                worst = Some(it);
            }
        }
        worst
    }

    /// A new unit half-way between the worst one and the worst of its neighbours.
    fn insert(&mut self) {
        let all: Vec<usize> = (0..self.alive.len()).collect();
        let Some(new) = self.alive.iter().position(|&it| !it) else {
            return;
        };
        let Some(worst) = self.worst(&all) else {
            return;
        };
        let Some(other) = self.worst(&self.neighbours(worst)) else {
            return;
        };
        let halves = self.weights(worst).iter().zip(self.weights(other));
        let between: Vec<f32> = halves.map(|(a, b)| 0.5 * (a + b)).collect();
        self.weights_mut(new).copy_from_slice(&between);
        self.alive[new] = true;
        self.wins[new] = 0;
        self.set_edge(worst, other, 0);
        self.set_edge(worst, new, 1);
        self.set_edge(other, new, 1);
        self.errors[worst] *= PARENTS;
        self.errors[other] *= PARENTS;
        self.errors[new] = self.errors[worst];
    }

    /// Ages the winner's edges; cuts what is too old, and forgets who has no edge left.
    fn age(&mut self, winner: usize, second: usize) {
        for neighbour in self.neighbours(winner) {
            let older = self.edge(winner, neighbour) + 1;
            let cut = older > OLDEST + 1 && neighbour != second;
            self.set_edge(winner, neighbour, if cut { 0 } else { older });
            if cut && self.neighbours(neighbour).is_empty() {
                self.alive[neighbour] = false;
                self.errors[neighbour] = 0.0;
            }
        }
        self.set_edge(winner, second, 1);
    }
}

impl Module for Gas {
    fn units(&self) -> usize {
        self.alive.len()
    }

    fn learn(&mut self, stimulus: &[f32]) {
        self.samples += 1;
        if self.living() < 2 {
            // Fritzke draws the first two by chance; here they are the first two stimuli.
            let first = self.living();
            self.weights_mut(first).copy_from_slice(stimulus);
            self.alive[first] = true;
            self.wins[first] = 1;
            if first == 1 {
                self.set_edge(0, 1, 1);
            }
            return;
        }
        let mut distances = self.distances(stimulus);
        let winner = super::module::least(&distances);
        let error = std::mem::replace(&mut distances[winner], f32::INFINITY);
        let second = super::module::least(&distances);
        self.errors[winner] += error;
        self.wins[winner] += 1;
        self.age(winner, second);
        let rate = self.rate;
        approach(self.weights_mut(winner), stimulus, rate);
        let near = self.neighbours(winner);
        self.moved += 1 + near.len() as u64;
        for neighbour in near {
            approach(self.weights_mut(neighbour), stimulus, NEIGHBOURS * rate);
        }
        if self.samples.is_multiple_of(self.every) {
            self.insert();
        }
        for error in &mut self.errors {
            *error *= DECAY;
        }
    }

    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32 {
        activations.copy_from_slice(&self.distances(stimulus));
        activate(activations, self.width)
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        let all = (0..self.alive.len()).filter(|&it| self.alive[it]);
        let all = all.map(|it| (self.weights(it).to_vec(), self.wins[it]));
        Some(all.collect())
    }

    fn bytes(&self) -> usize {
        let units = self.alive.len();
        4 * self.weights.len() + units * (4 + 4 + 1 + 4) + 2 * self.edges.len() + size_of::<Self>()
    }

    fn work(&self) -> Work {
        let (living, units) = (self.living(), self.alive.len());
        let search = living * self.features;
        let moved = self.moved as f64 / f64::from(self.samples.max(1));
        Work {
            respond: (search + living * FUNCTION) as f64,
            // The errors decay, and a row of edges is looked through.
            learn: (search + 2 * units) as f64 + moved * self.features as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use cla_core::num::Rng;

    use super::Gas;
    use crate::experiment::modules::module::{Module, Plan};

    #[test]
    fn it_grows_to_its_size_and_hardly_an_edge_is_left_between_clusters_that_lie_apart() {
        let plan = Plan {
            side: 4,
            features: 2,
            samples: 4000,
            ..Plan::DEFAULT
        };
        let mut gas = Gas::new(&plan, 0.1);
        let mut rng = Rng::new(1);
        let mut far = 0.0;
        for t in 0..4000 {
            let corner = if rng.chance(0.5) { 0.0 } else { 10.0 };
            let stimulus = [corner + rng.unit(), rng.unit()];
            gas.learn(&stimulus);
            if t >= 3000 {
                far += gas.respond(&stimulus, &mut [0.0; 16]) / 1000.0;
            }
        }
        assert_eq!(gas.living(), 16);
        // Eight units on each unit square: a regular lattice of 8 has 1 / 48 or so.
        assert!(far < 0.05, "{far}");
        let left = |unit: usize| gas.weights(unit)[0] < 5.0;
        let across = (0..16).flat_map(|a| (0..16).map(move |b| (a, b)));
        let across = across.filter(|&(a, b)| left(a) != left(b) && gas.edge(a, b) > 0);
        // The units between the clusters that nobody wins keep the one that they began with.
        assert!(across.count() <= 2);
    }
}

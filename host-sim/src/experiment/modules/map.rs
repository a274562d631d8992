//! The map of the core as a module: its winner, its neighbourhood, its distances.

use cla_core::num::{Neighbourhood, Rng, Schedule};
use cla_core::som::{DenseSom, Grid, best_match};

use super::module::{FUNCTION, Module, Plan, Work, activate};
use crate::failure::Failure;

/// Neighbours whose factor is below this stay, as in a layer of the core.
const CUT: f32 = 0.01;

/// A map of `SIDE` × `SIDE` nodes that reads `FEATURES` values.
pub(super) struct Map<const SIDE: usize, const FEATURES: usize> {
    som: Box<DenseSom<SIDE, SIDE, FEATURES>>,
    wins: Vec<u32>,
    width: f32,
    alpha: Schedule,
    neighbourhood: Schedule,
    samples: u32,
    moved: u64,
}

impl<const SIDE: usize, const FEATURES: usize> Map<SIDE, FEATURES> {
    /// A map with weights by chance, whose rate and neighbourhood have ended after the samples of `plan`.
    pub(super) fn new(plan: &Plan, rng: &mut Rng) -> Result<Self, Failure> {
        let mut som = Box::new(DenseSom::new());
        som.randomize(rng);
        let schedule = |from, to| Schedule::geometric(from, to, plan.samples.max(1));
        Ok(Self {
            som,
            wins: vec![0; SIDE * SIDE],
            width: plan.width,
            alpha: schedule(plan.alpha.0, plan.alpha.1)?,
            neighbourhood: schedule(plan.side as f32 / 2.0, plan.neighbourhood)?,
            samples: 0,
            moved: 0,
        })
    }

    fn distances(&self, stimulus: &[f32]) -> Grid<f32, SIDE, SIDE> {
        let mut distances = Grid::filled(0.0);
        self.som
            .squared_distances(read(stimulus), &mut distances)
            .expect("stimuli are finite");
        distances
    }
}

fn read<const FEATURES: usize>(stimulus: &[f32]) -> &[f32; FEATURES] {
    stimulus.try_into().expect("a stimulus of the map's length")
}

impl<const SIDE: usize, const FEATURES: usize> Module for Map<SIDE, FEATURES> {
    fn units(&self) -> usize {
        SIDE * SIDE
    }

    fn learn(&mut self, stimulus: &[f32]) {
        let winner = best_match(&self.distances(stimulus)).node;
        let width = self.neighbourhood.at(self.samples);
        let near = Neighbourhood::gaussian(width, CUT).expect("schedules are positive");
        let alpha = self.alpha.at(self.samples);
        self.som.train(read(stimulus), winner, alpha, &near);
        self.wins[usize::from(winner.0)] += 1;
        self.samples += 1;
        let (column, row) = (usize::from(winner.0) % SIDE, usize::from(winner.0) / SIDE);
        let reached =
            |at: usize, radius: usize| (at + radius).min(SIDE - 1) - at.saturating_sub(radius) + 1;
        let nodes =
            reached(column, near.horizontal_radius()) * reached(row, near.vertical_radius());
        self.moved += nodes as u64;
    }

    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32 {
        activations.copy_from_slice(self.distances(stimulus).as_slice());
        activate(activations, self.width)
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        let nodes = self.som.prototypes().as_slice().iter();
        let nodes = nodes.zip(&self.wins);
        Some(nodes.map(|(it, &wins)| (it.to_vec(), wins)).collect())
    }

    fn bytes(&self) -> usize {
        // Weights, and a distance of each node; wins are counted for the harvest alone.
        4 * SIDE * SIDE * (FEATURES + 1) + size_of::<Self>()
    }

    fn work(&self) -> Work {
        let search = SIDE * SIDE * FEATURES;
        let moved = self.moved as f64 / f64::from(self.samples.max(1));
        Work {
            respond: (search + SIDE * SIDE * FUNCTION) as f64,
            learn: search as f64 + moved * FEATURES as f64,
        }
    }
}

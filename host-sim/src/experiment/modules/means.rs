//! Incremental k-means (MacQueen 1967): the nearest mean moves, the others do not.

use super::module::{FUNCTION, Module, Plan, Work, activate, approach, least, squared_distance};

/// Means that move by one over the number of stimuli that each has won.
///
/// The first stimuli that are not there yet become means themselves.
pub(super) struct Means {
    means: Vec<f32>,
    wins: Vec<u32>,
    /// Means that there are so far.
    filled: usize,
    features: usize,
    width: f32,
    /// A mean moves by at least this share: 0 for MacQueen's own, more to forget.
    floor: f32,
}

impl Means {
    /// No means yet.
    pub(super) fn new(plan: &Plan, floor: f32) -> Self {
        Self {
            means: vec![0.0; plan.units() * plan.features],
            wins: vec![0; plan.units()],
            filled: 0,
            features: plan.features,
            width: plan.width,
            floor,
        }
    }

    fn distances(&self, stimulus: &[f32]) -> Vec<f32> {
        let filled = self.means.chunks_exact(self.features).take(self.filled);
        filled.map(|it| squared_distance(stimulus, it)).collect()
    }
}

impl Module for Means {
    fn units(&self) -> usize {
        self.wins.len()
    }

    fn learn(&mut self, stimulus: &[f32]) {
        let distances = self.distances(stimulus);
        let nearest = least(&distances);
        let unit = if self.filled < self.wins.len() && distances.iter().all(|&it| it > 0.0) {
            self.filled += 1;
            self.filled - 1
        } else {
            nearest
        };
        self.wins[unit] += 1;
        let rate = (1.0 / self.wins[unit] as f32).max(self.floor);
        let mean = &mut self.means[unit * self.features..][..self.features];
        approach(
            mean,
            stimulus,
            if self.wins[unit] == 1 { 1.0 } else { rate },
        );
    }

    fn respond(&self, stimulus: &[f32], activations: &mut [f32]) -> f32 {
        activations.fill(0.0);
        let distances = self.distances(stimulus);
        let there = &mut activations[..self.filled];
        there.copy_from_slice(&distances);
        activate(there, self.width)
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        let means = self.means.chunks_exact(self.features).zip(&self.wins);
        let means = means.take(self.filled);
        Some(means.map(|(it, &wins)| (it.to_vec(), wins)).collect())
    }

    fn bytes(&self) -> usize {
        4 * (self.means.len() + 2 * self.wins.len()) + size_of::<Self>()
    }

    fn work(&self) -> Work {
        let search = self.filled * self.features;
        Work {
            respond: (search + self.filled * FUNCTION) as f64,
            learn: (search + self.features) as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Means;
    use crate::experiment::modules::module::{Module, Plan};

    fn means(floor: f32) -> Means {
        let plan = Plan {
            side: 1,
            features: 1,
            ..Plan::DEFAULT
        };
        Means::new(&plan, floor)
    }

    #[test]
    fn a_mean_is_the_mean_of_what_it_has_won() {
        let mut one = means(0.0);
        for value in [1.0, 2.0, 6.0, 7.0] {
            one.learn(&[value]);
        }
        let [(mean, 4)] = &one.prototypes().unwrap()[..] else {
            panic!("one mean with four wins")
        };
        assert!((mean[0] - 4.0).abs() < 1e-6, "{mean:?}");
        let mut forgets = means(0.5);
        for value in [0.0, 0.0, 0.0, 8.0] {
            forgets.learn(&[value]);
        }
        assert!((forgets.prototypes().unwrap()[0].0[0] - 4.0).abs() < 1e-6);
    }

    #[test]
    fn the_first_different_stimuli_become_means() {
        let plan = Plan {
            side: 2,
            features: 1,
            ..Plan::DEFAULT
        };
        let mut four = Means::new(&plan, 0.0);
        for value in [1.0, 1.0, 3.0] {
            four.learn(&[value]);
        }
        let there = four.prototypes().unwrap();
        assert_eq!(there, [(vec![1.0], 2), (vec![3.0], 1)]);
        let mut answer = [9.0; 4];
        assert_eq!(four.respond(&[3.0], &mut answer), 0.0);
        assert_eq!(answer[1..], [1.0, 0.0, 0.0]);
    }
}

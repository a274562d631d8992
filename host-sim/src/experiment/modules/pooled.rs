//! Invariance to translation: a module reads a window, and each unit answers its best place (book, 7.1.3).
//!
//! The same module reads every place of the window on a line of cells, beyond the ends of which nothing
//! is; a unit is as active as it is in the window where it is most (max pooling).
//! It learns from the windows that hold all there is.

use super::module::{Module, Work};

/// What a window may miss of all there is, and still hold it.
const MISSED: f32 = 1e-4;

/// A module, and the line that it is moved along.
pub(super) struct Pooled {
    module: Box<dyn Module>,
    window: usize,
    windows: u64,
    samples: u64,
}

impl Pooled {
    /// Moves a module that reads `window` cells.
    pub(super) fn new(module: Box<dyn Module>, window: usize) -> Self {
        Self {
            module,
            window,
            windows: 0,
            samples: 0,
        }
    }

    /// The windows in which there is anything, each with whether it holds everything.
    fn seen(&self, line: &[f32]) -> Vec<(bool, Vec<f32>)> {
        let whole: f32 = line.iter().sum();
        let beyond = self.window - 1;
        let mut padded = vec![0.0; beyond];
        padded.extend_from_slice(line);
        padded.resize(line.len() + 2 * beyond, 0.0);
        let windows = padded.windows(self.window).map(|it| {
            let sum: f32 = it.iter().sum();
            (sum, it)
        });
        let windows = windows.filter(|(sum, _)| *sum > 0.0);
        windows
            .map(|(sum, it)| (sum >= whole - MISSED, it.to_vec()))
            .collect()
    }
}

impl Module for Pooled {
    fn units(&self) -> usize {
        self.module.units()
    }

    fn learn(&mut self, line: &[f32]) {
        self.samples += 1;
        for (whole, window) in self.seen(line) {
            if whole {
                self.module.learn(&window);
                self.windows += 1;
            }
        }
    }

    fn settle(&mut self) {
        self.module.settle();
    }

    fn respond(&self, line: &[f32], activations: &mut [f32]) -> f32 {
        activations.fill(0.0);
        let mut answer = vec![0.0; self.units()];
        let mut novelty = f32::INFINITY;
        for (whole, window) in self.seen(line) {
            let new = self.module.respond(&window, &mut answer);
            if whole {
                novelty = novelty.min(new);
            }
            for (most, it) in activations.iter_mut().zip(&answer) {
                *most = most.max(*it);
            }
        }
        // What no window holds as a whole is as new as nothing known.
        if novelty.is_finite() {
            novelty
        } else {
            line.iter().map(|it| it * it).sum()
        }
    }

    fn prototypes(&self) -> Option<Vec<(Vec<f32>, u32)>> {
        self.module.prototypes()
    }

    fn bytes(&self) -> usize {
        self.module.bytes() + 4 * self.units() + size_of::<Self>()
    }

    fn work(&self) -> Work {
        // Two balls are in most windows of a line that is not much longer than a window.
        let Work { respond, learn } = self.module.work();
        let share = self.windows as f64 / self.samples.max(1) as f64;
        Work {
            respond: respond * (2 * self.window - 1) as f64,
            learn: learn * share,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Pooled;
    use crate::experiment::modules::means::Means;
    use crate::experiment::modules::module::{Module, Plan};

    #[test]
    fn what_is_shifted_is_answered_alike_and_what_is_changed_is_not() {
        let plan = Plan {
            side: 3,
            features: 4,
            width: 0.3,
            ..Plan::DEFAULT
        };
        let mut pooled = Pooled::new(Box::new(Means::new(&plan, 0.0)), 4);
        let line = |places: [usize; 2]| {
            let mut line = [0.0; 10];
            for it in places {
                line[it] = 1.0;
            }
            line
        };
        let answer = |pooled: &Pooled, places| {
            let mut units = vec![0.0; 9];
            let novelty = pooled.respond(&line(places), &mut units);
            (units, novelty)
        };
        pooled.learn(&line([4, 6]));
        let trained = answer(&pooled, [4, 6]);
        assert_eq!(trained.1, 0.0);
        for shift in 0..8 {
            assert_eq!(answer(&pooled, [shift, shift + 2]), trained);
        }
        let other = answer(&pooled, [4, 5]);
        assert!(
            other.0.iter().all(|&it| it < 0.1) && other.1 > 0.9,
            "{other:?}"
        );
    }
}

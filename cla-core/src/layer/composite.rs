//! Activation composites: what a layer did over a whole event (book, 4.3.2–4.3.4).
//!
//! Their isolates and differences are the book's measures of what a layer tells apart.

use crate::som::Grid;

/// The sum of a layer's activations over the steps of an event (book, 4.3.2).
///
/// ```
/// use cla_core::layer::ActivationComposite;
/// use cla_core::som::Grid;
///
/// let (mut direct, mut gap) = (ActivationComposite::<2, 1>::new(), ActivationComposite::new());
/// let mut activation = Grid::filled(0.5);
/// direct.add(&activation);
/// direct.add(&activation);
/// activation.as_mut_slice()[0] = 0.25;
/// gap.add(&activation);
/// assert_eq!(direct.nodes().as_slice(), [1.0, 1.0]);
/// assert_eq!(direct.difference(&gap), 0.75 + 0.5);
/// assert_eq!(direct.isolate(&[&gap]).nodes().as_slice(), [0.75, 0.5]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ActivationComposite<const WIDTH: usize, const HEIGHT: usize>(Grid<f32, WIDTH, HEIGHT>);

impl<const WIDTH: usize, const HEIGHT: usize> ActivationComposite<WIDTH, HEIGHT> {
    /// The composite of an event without steps: 0 everywhere.
    #[must_use]
    pub const fn new() -> Self {
        Self(Grid::filled(0.0))
    }

    /// Adds the activation of one step.
    pub fn add(&mut self, activation: &Grid<f32, WIDTH, HEIGHT>) {
        for (sum, &a) in self.0.as_mut_slice().iter_mut().zip(activation.as_slice()) {
            *sum += a;
        }
    }

    /// The summed activation of each node, at least 0.
    #[must_use]
    pub const fn nodes(&self) -> &Grid<f32, WIDTH, HEIGHT> {
        &self.0
    }

    /// The summed activation of the layer.
    #[must_use]
    pub fn total(&self) -> f32 {
        let mut total = 0.0;
        for &sum in self.0.as_slice() {
            total += sum;
        }
        total
    }

    /// What is active in this event alone: less all the `others`, clipped at 0 (book, 4.3.3).
    #[must_use]
    pub fn isolate(&self, others: &[&Self]) -> Self {
        let mut alone = self.clone();
        for other in others {
            for (sum, &o) in alone.0.as_mut_slice().iter_mut().zip(other.0.as_slice()) {
                *sum -= o;
            }
        }
        for sum in alone.0.as_mut_slice() {
            if *sum < 0.0 {
                *sum = 0.0;
            }
        }
        alone
    }

    /// How differently the layer sees two events: Σ |a − b| over its nodes (book, 4.3.4).
    #[must_use]
    pub fn difference(&self, other: &Self) -> f32 {
        let mut total = 0.0;
        for (&a, &b) in self.0.as_slice().iter().zip(other.0.as_slice()) {
            total += (a - b).abs();
        }
        total
    }

    /// How many nodes have more than `threshold`.
    #[must_use]
    pub fn nodes_above(&self, threshold: f32) -> u16 {
        let mut count = 0;
        for &sum in self.0.as_slice() {
            count += u16::from(sum > threshold);
        }
        count
    }
}

impl<const WIDTH: usize, const HEIGHT: usize> Default for ActivationComposite<WIDTH, HEIGHT> {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::ActivationComposite;
    use crate::som::Grid;

    fn of(nodes: [f32; 3]) -> ActivationComposite<3, 1> {
        let mut activation = Grid::filled(0.0);
        activation.as_mut_slice().copy_from_slice(&nodes);
        let mut composite = ActivationComposite::new();
        composite.add(&activation);
        composite
    }

    #[test]
    fn an_isolate_takes_away_the_sum_of_the_others_and_is_never_negative() {
        let alone = of([3.0, 1.0, 0.5]).isolate(&[&of([1.0, 0.5, 0.0]), &of([1.5, 0.75, 0.0])]);
        assert_eq!(alone, of([0.5, 0.0, 0.5]));
        assert_eq!((alone.nodes_above(0.5), alone.nodes_above(0.4)), (0, 2));
    }

    #[test]
    fn a_difference_is_symmetric_and_zero_only_for_equals() {
        let (a, b) = (of([1.0, 2.0, 0.0]), of([0.5, 2.0, 1.0]));
        assert_eq!((a.difference(&b), b.difference(&a)), (1.5, 1.5));
        assert_eq!(a.difference(&a.clone()), 0.0);
        assert_eq!(a.total(), 3.0);
    }
}

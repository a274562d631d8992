//! Recurrence: a structure that also reads what it gave before (book, 3.3).
//!
//! The loop runs through a delay line, without which it could not exist.
//! What it can remember is not bounded by a window, only by how well its states keep apart.

use core::slice::IterMut;

use super::delay::DelayLine;
use super::signal::Signal;
use super::structure::Structure;
use crate::som::StimulusError;

/// A structure whose second sensor is its own output of `STEPS` steps ago.
///
/// `source` reads pairs `(X, [f32; LEN])` and gives `LEN` values; the recurrent structure reads `X`.
/// At the start of an event the output before is zeros.
/// A higher layer's activation enters a lower layer when `source` is a stack of both.
///
/// ```
/// use cla_core::layer::{Input, Join, Layer, LayerConfig, Recurrent, Stack, Structure};
/// use cla_core::num::{Rng, Schedule};
///
/// // A layer of 16 nodes that reads 2 features and its own 16 activations of the last step.
/// type Loop = Stack<Join<Input<2>, Input<16>>, 4, 4, 18>;
/// let mut memory = Recurrent::<Loop, 16, 1>::new();
/// let config = LayerConfig::try_new(0.5, Schedule::constant(0.1)?, Schedule::constant(0.5)?)?;
/// memory.source.upper.start(&config, &mut Rng::new(1));
/// memory.learn(&[1.0, 0.0], 0)?;
/// let before = memory.source.upper.activation().clone();
/// memory.learn(&[1.0, 0.0], 1)?; // the same sensors in another context
/// assert_ne!(memory.source.upper.activation(), &before);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// An output that does not fit the loop does not compile:
///
/// ```compile_fail,E0080
/// use cla_core::layer::{Input, Join, Recurrent, Stack, Structure};
///
/// // The layer gives 16 values, the loop takes 15 back.
/// type Loop = Stack<Join<Input<2>, Input<15>>, 4, 4, 17>;
/// let mut wrong = Recurrent::<Loop, 15, 1>::new();
/// wrong.activate(&[1.0, 0.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recurrent<S, const LEN: usize, const STEPS: usize> {
    /// The structure inside the loop.
    pub source: S,
    line: DelayLine<LEN, STEPS>,
}

impl<X: Clone, S, const LEN: usize, const STEPS: usize> Recurrent<S, LEN, STEPS>
where
    S: Structure<Sensors = (X, [f32; LEN])>,
{
    /// A loop that was not started yet: zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }
}

impl<X: Clone, S, const LEN: usize, const STEPS: usize> Default for Recurrent<S, LEN, STEPS>
where
    S: Structure<Sensors = (X, [f32; LEN])>,
{
    fn default() -> Self {
        Self::NEW
    }
}

impl<S: Signal, const LEN: usize, const STEPS: usize> Signal for Recurrent<S, LEN, STEPS> {
    const LEN: usize = S::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.source.write(out);
    }
}

impl<X: Clone, S, const LEN: usize, const STEPS: usize> Structure for Recurrent<S, LEN, STEPS>
where
    S: Structure<Sensors = (X, [f32; LEN])>,
{
    const NEW: Self = Self {
        source: S::NEW,
        line: DelayLine::new(),
    };

    type Sensors = X;

    fn activate(&mut self, sensors: &X) -> Result<(), StimulusError> {
        self.source
            .activate(&(sensors.clone(), *self.line.oldest()))?;
        self.line.push(&self.source);
        Ok(())
    }

    fn train(&mut self, samples: u32) {
        self.source.train(samples);
    }

    fn forget_context(&mut self) {
        self.source.forget_context();
        self.line.clear();
    }
}

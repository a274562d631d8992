//! Stack and tree, and what every structure of layers can do (book, 3.2, 3.3).
//!
//! A [`Structure`] is activated bottom-up and then trained, in one pass; its output is a signal for
//! the structure around it, so structures nest.
//! Time is in [`delay`](super::Delayed) and [`recurrent`](super::Recurrent).

use core::slice::IterMut;

use super::cla_layer::Layer;
use super::signal::{Scaled, Signal};
use crate::som::StimulusError;

/// Layers joined into one: sensors in, one activation vector out.
///
/// [`Layer`], [`Input`], [`Stack`], [`Join`], [`Delayed`](super::Delayed),
/// [`Window`](super::Window), [`Recurrent`](super::Recurrent) and [`Scaled`] are structures.
///
/// ```
/// use cla_core::layer::{Layer, LayerConfig, Stack, Structure};
/// use cla_core::num::{Rng, Schedule};
///
/// fn last_novelty<S: Structure>(structure: &mut S, sensors: &S::Sensors) -> bool {
///     structure.learn(sensors, 0).is_ok()
/// }
/// let mut stack = Stack::<Layer<2, 2, 1>, 2, 1, 4>::new();
/// assert!(last_novelty(&mut stack, &[0.5]));
/// assert!(!last_novelty(&mut stack, &[f32::NAN]));
/// ```
pub trait Structure: Signal + Sized {
    /// The structure before it is started: zeros, so that a static one costs RAM and no flash.
    const NEW: Self;

    /// What the structure reads at one moment: arrays, in pairs where structures are joined.
    type Sensors;

    /// Activates every layer, bottom-up.
    ///
    /// # Errors
    /// [`StimulusError`] of the first layer that met a value that is not finite; layers above it
    /// keep the activations of before.
    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError>;

    /// Trains every layer on what it was last activated by, as sample number `samples`.
    fn train(&mut self, samples: u32);

    /// Empties all that is held over time: a new event begins, with nothing before it.
    fn forget_context(&mut self);

    /// One pass: activates every layer, then trains every layer (book, 3.2).
    ///
    /// # Errors
    /// As [`activate`](Self::activate); nothing is trained then.
    fn learn(&mut self, sensors: &Self::Sensors, samples: u32) -> Result<(), StimulusError> {
        self.activate(sensors)?;
        self.train(samples);
        Ok(())
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Structure
    for Layer<WIDTH, HEIGHT, FEATURES>
{
    const NEW: Self = Self::new();

    type Sensors = [f32; FEATURES];

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        Self::activate(self, sensors)
    }

    fn train(&mut self, samples: u32) {
        Self::train(self, samples);
    }

    fn forget_context(&mut self) {}
}

/// Sensors that go to a higher layer as they are, with no layer between.
///
/// ```
/// use cla_core::layer::{Input, Join, Layer, Stack, Structure};
/// // The top layer reads the 4 activations of a layer and 2 raw values.
/// let mut top = Stack::<Join<Layer<2, 2, 3>, Input<2>>, 3, 3, 6>::new();
/// top.activate(&([0.1, 0.2, 0.3], [1.0, 0.0]))?;
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Input<const LEN: usize> {
    values: [f32; LEN],
}

impl<const LEN: usize> Input<LEN> {
    /// An input that has read zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self { values: [0.0; LEN] }
    }
}

impl<const LEN: usize> Default for Input<LEN> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const LEN: usize> Signal for Input<LEN> {
    const LEN: usize = LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.values.write(out);
    }
}

impl<const LEN: usize> Structure for Input<LEN> {
    const NEW: Self = Self::new();

    type Sensors = [f32; LEN];

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        self.values = *sensors;
        Ok(())
    }

    fn train(&mut self, _samples: u32) {}

    fn forget_context(&mut self) {}
}

/// A layer of `WIDTH` × `HEIGHT` nodes on top of `lower` (book, Fig 3.1).
///
/// `FEATURES` must be the number of values that `lower` gives; another number does not compile.
///
/// ```
/// use cla_core::layer::{Layer, Signal, Stack, Structure};
/// // Three levels: 5 features → 16 nodes → 9 nodes → 4 nodes.
/// type Deep = Stack<Stack<Layer<4, 4, 5>, 3, 3, 16>, 2, 2, 9>;
/// let mut deep = Deep::new();
/// deep.activate(&[0.1, 0.2, 0.3, 0.4, 0.5])?;
/// assert_eq!(Deep::LEN, 4);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stack<Lower, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> {
    /// What lies below: a layer or any other structure.
    pub lower: Lower,
    /// The layer that reads it.
    pub upper: Layer<WIDTH, HEIGHT, FEATURES>,
}

impl<Lower: Structure, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize>
    Stack<Lower, WIDTH, HEIGHT, FEATURES>
{
    /// A stack that was not started yet: zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }
}

impl<Lower: Structure, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Default
    for Stack<Lower, WIDTH, HEIGHT, FEATURES>
{
    fn default() -> Self {
        Self::NEW
    }
}

impl<Lower: Signal, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Signal
    for Stack<Lower, WIDTH, HEIGHT, FEATURES>
{
    const LEN: usize = Layer::<WIDTH, HEIGHT, FEATURES>::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.upper.write(out);
    }
}

impl<Lower: Structure, const WIDTH: usize, const HEIGHT: usize, const FEATURES: usize> Structure
    for Stack<Lower, WIDTH, HEIGHT, FEATURES>
{
    const NEW: Self = Self {
        lower: Lower::NEW,
        upper: Layer::new(),
    };

    type Sensors = Lower::Sensors;

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        self.lower.activate(sensors)?;
        self.upper.activate(&self.lower)
    }

    fn train(&mut self, samples: u32) {
        self.lower.train(samples);
        self.upper.train(samples);
    }

    fn forget_context(&mut self) {
        self.lower.forget_context();
    }
}

/// Two structures side by side, read together by the layer above: the tree (book, 3.3).
///
/// More than two: `Join<A, Join<B, C>>`.
///
/// ```
/// use cla_core::layer::{Join, Layer, Signal, Structure};
/// type Senses = Join<Layer<3, 3, 4>, Join<Layer<2, 2, 1>, Layer<2, 1, 6>>>;
/// let mut senses = Senses::new();
/// senses.activate(&([0.0; 4], ([1.0], [0.5; 6])))?;
/// assert_eq!(Senses::LEN, 9 + 4 + 2);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Join<A, B> {
    /// Its values come first.
    pub first: A,
    /// Its values come second.
    pub second: B,
}

impl<A: Structure, B: Structure> Join<A, B> {
    /// A join that was not started yet: zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }
}

impl<A: Structure, B: Structure> Default for Join<A, B> {
    fn default() -> Self {
        Self::NEW
    }
}

impl<A: Signal, B: Signal> Signal for Join<A, B> {
    const LEN: usize = A::LEN + B::LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.first.write(out);
        self.second.write(out);
    }
}

impl<A: Structure, B: Structure> Structure for Join<A, B> {
    const NEW: Self = Self {
        first: A::NEW,
        second: B::NEW,
    };

    type Sensors = (A::Sensors, B::Sensors);

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        self.first.activate(&sensors.0)?;
        self.second.activate(&sensors.1)
    }

    fn train(&mut self, samples: u32) {
        self.first.train(samples);
        self.second.train(samples);
    }

    fn forget_context(&mut self) {
        self.first.forget_context();
        self.second.forget_context();
    }
}

impl<S: Structure, const PERCENT: u32> Structure for Scaled<S, PERCENT> {
    const NEW: Self = Self { source: S::NEW };

    type Sensors = S::Sensors;

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        self.source.activate(sensors)
    }

    fn train(&mut self, samples: u32) {
        self.source.train(samples);
    }

    fn forget_context(&mut self) {
        self.source.forget_context();
    }
}

#[cfg(test)]
#[path = "structure_tests.rs"]
mod tests;

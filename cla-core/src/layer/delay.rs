//! Time delay: a signal held for some steps, alone or as a sliding window (book, 3.3).
//!
//! [`DelayLine`] is the memory, [`Delayed`] and [`Window`] put it behind a structure.
//! Before a line is full it gives zeros.

use core::slice::IterMut;

use super::signal::{Signal, write_slice};
use super::structure::Structure;
use crate::som::StimulusError;

/// The last `STEPS` values of a signal of `LEN` numbers.
///
/// ```
/// use cla_core::layer::DelayLine;
///
/// let mut line = DelayLine::<1, 3>::new();
/// for value in [1.0, 2.0, 3.0, 4.0] {
///     line.push(&[value]);
/// }
/// assert_eq!(line.oldest(), &[2.0]);
/// assert_eq!(line.tap(0), Some(&[4.0]));
/// assert_eq!(line.tap(3), None); // no longer held
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct DelayLine<const LEN: usize, const STEPS: usize> {
    held: [[f32; LEN]; STEPS],
    /// Where the next value goes: the place of the oldest one.
    next: u16,
}

impl<const LEN: usize, const STEPS: usize> DelayLine<LEN, STEPS> {
    /// A line that holds zeros.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                STEPS > 0 && STEPS <= u16::MAX as usize,
                "a delay line holds 1 to 65,535 steps"
            )
        }
        Self {
            held: [[0.0; LEN]; STEPS],
            next: 0,
        }
    }

    /// Holds `signal` and forgets the oldest value.
    ///
    /// A signal with another number of values than `LEN` does not compile:
    ///
    /// ```compile_fail,E0080
    /// let mut line = cla_core::layer::DelayLine::<2, 4>::new();
    /// line.push(&[1.0, 2.0, 3.0]);
    /// ```
    pub fn push<S: Signal>(&mut self, signal: &S) {
        const {
            assert!(
                S::LEN == LEN,
                "a delay line's LEN must be the number of values it is given"
            )
        }
        if let Some(place) = self.held.get_mut(usize::from(self.next)) {
            signal.write(&mut place.iter_mut());
        }
        self.next = if usize::from(self.next) + 1 < STEPS {
            self.next + 1
        } else {
            0
        };
    }

    /// The value of `STEPS` pushes ago: with one step, the last value pushed.
    #[must_use]
    pub fn oldest(&self) -> &[f32; LEN] {
        self.held.get(usize::from(self.next)).unwrap_or(&[0.0; LEN])
    }

    /// The value pushed `age` pushes before the last one; `None` when it is no longer held.
    #[must_use]
    pub fn tap(&self, age: usize) -> Option<&[f32; LEN]> {
        let next = usize::from(self.next);
        let back = age.checked_add(1).filter(|&back| back <= STEPS)?;
        self.held.get(if back <= next {
            next - back
        } else {
            next + STEPS - back
        })
    }

    /// Holds zeros again.
    pub fn clear(&mut self) {
        self.held.as_flattened_mut().fill(0.0);
        self.next = 0;
    }
}

impl<const LEN: usize, const STEPS: usize> Default for DelayLine<LEN, STEPS> {
    fn default() -> Self {
        Self::new()
    }
}

/// All that is held, oldest first: the sliding window.
impl<const LEN: usize, const STEPS: usize> Signal for DelayLine<LEN, STEPS> {
    const LEN: usize = LEN * STEPS;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        let next = usize::from(self.next);
        for value in self
            .held
            .iter()
            .skip(next)
            .chain(self.held.iter().take(next))
        {
            write_slice(value, out);
        }
    }
}

/// What `source` gave `STEPS` steps ago: its activation vector, held (book, 3.3).
///
/// `LEN` must be the number of values that `source` gives.
///
/// ```
/// use cla_core::layer::{Delayed, Input, Signal, Structure};
///
/// let mut late = Delayed::<Input<1>, 1, 2>::new();
/// let mut seen = [[9.0]; 4];
/// for (value, seen) in [1.0, 2.0, 3.0, 4.0].into_iter().zip(&mut seen) {
///     late.activate(&[value])?;
///     late.write(&mut seen.iter_mut());
/// }
/// assert_eq!(seen, [[0.0], [0.0], [1.0], [2.0]]);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Delayed<S, const LEN: usize, const STEPS: usize> {
    /// The structure whose output is held.
    pub source: S,
    line: DelayLine<LEN, STEPS>,
    /// Whether `source` holds an output of this event that the line has not taken yet.
    pending: bool,
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Delayed<S, LEN, STEPS> {
    /// A delay that was not started yet: zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Default for Delayed<S, LEN, STEPS> {
    fn default() -> Self {
        Self::NEW
    }
}

impl<S: Signal, const LEN: usize, const STEPS: usize> Signal for Delayed<S, LEN, STEPS> {
    const LEN: usize = LEN;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        write_slice(self.line.oldest(), out);
    }
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Structure for Delayed<S, LEN, STEPS> {
    const NEW: Self = Self {
        source: S::NEW,
        line: DelayLine::new(),
        pending: false,
    };

    type Sensors = S::Sensors;

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        // The output of the step before is taken now, so that `STEPS` values are enough to look
        // `STEPS` steps back.
        if self.pending {
            self.line.push(&self.source);
        }
        self.pending = true;
        self.source.activate(sensors)
    }

    fn train(&mut self, samples: u32) {
        self.source.train(samples);
    }

    fn forget_context(&mut self) {
        self.source.forget_context();
        self.line.clear();
        self.pending = false;
    }
}

/// The last `STEPS` outputs of `source`, oldest first, the present one last: a sliding window.
///
/// `LEN` must be the number of values that `source` gives; the window gives `LEN`·`STEPS`.
///
/// ```
/// use cla_core::layer::{Input, Signal, Structure, Window};
///
/// let mut window = Window::<Input<1>, 1, 3>::new();
/// for value in [1.0, 2.0, 3.0, 4.0] {
///     window.activate(&[value])?;
/// }
/// let mut seen = [0.0; 3];
/// window.write(&mut seen.iter_mut());
/// assert_eq!(seen, [2.0, 3.0, 4.0]);
/// # Ok::<(), cla_core::som::StimulusError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Window<S, const LEN: usize, const STEPS: usize> {
    /// The structure whose outputs are held.
    pub source: S,
    line: DelayLine<LEN, STEPS>,
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Window<S, LEN, STEPS> {
    /// A window that was not started yet: zeros.
    #[must_use]
    pub const fn new() -> Self {
        Self::NEW
    }
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Default for Window<S, LEN, STEPS> {
    fn default() -> Self {
        Self::NEW
    }
}

impl<S: Signal, const LEN: usize, const STEPS: usize> Signal for Window<S, LEN, STEPS> {
    const LEN: usize = LEN * STEPS;

    fn write(&self, out: &mut IterMut<'_, f32>) {
        self.line.write(out);
    }
}

impl<S: Structure, const LEN: usize, const STEPS: usize> Structure for Window<S, LEN, STEPS> {
    const NEW: Self = Self {
        source: S::NEW,
        line: DelayLine::new(),
    };

    type Sensors = S::Sensors;

    fn activate(&mut self, sensors: &Self::Sensors) -> Result<(), StimulusError> {
        self.source.activate(sensors)?;
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

#[cfg(test)]
mod tests {
    use super::{DelayLine, Delayed, Window};
    use crate::layer::{Input, Signal, Structure};

    #[test]
    fn a_line_is_read_oldest_first_wherever_its_ring_begins() {
        let mut line = DelayLine::<2, 3>::new();
        for step in 1..=7_u8 {
            line.push(&[f32::from(step), -f32::from(step)]);
            let mut values = [9.0; 6];
            line.write(&mut values.iter_mut());
            let expected: [f32; 6] = core::array::from_fn(|i| {
                let value = (f32::from(step) - 2.0 + (i / 2) as f32).max(0.0);
                if i % 2 == 0 { value } else { -value }
            });
            assert_eq!(values, expected);
            assert_eq!(line.tap(0).unwrap()[0], f32::from(step));
            assert_eq!(line.tap(2), Some(line.oldest()));
        }
        assert_eq!((line.tap(3), line.tap(usize::MAX)), (None, None));
    }

    #[test]
    fn a_new_event_finds_nothing_of_the_old_one() {
        let mut late = Delayed::<Window<Input<1>, 1, 2>, 2, 1>::new();
        for value in [1.0, 2.0, 3.0] {
            late.activate(&[value]).unwrap();
        }
        let mut seen = [0.0; 2];
        late.write(&mut seen.iter_mut());
        assert_eq!(seen, [1.0, 2.0]);
        late.forget_context();
        late.activate(&[4.0]).unwrap();
        late.write(&mut seen.iter_mut());
        assert_eq!(seen, [0.0, 0.0]);
        late.activate(&[5.0]).unwrap();
        late.write(&mut seen.iter_mut());
        assert_eq!(seen, [0.0, 4.0]);
    }
}

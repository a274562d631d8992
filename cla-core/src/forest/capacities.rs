//! How large the parts of a mind are that remembers so many samples.

use super::memory::STRETCH;

/// The capacities of a [`Mind`](super::Mind), in proportion to the samples that it remembers.
///
/// With 7168 samples and six actions they are those with which the learner was tuned and measured.
///
/// ```
/// use cla_core::forest::Capacities;
/// let it = Capacities::of(7168, 6);
/// assert_eq!((it.stretches, it.leaves, it.rows, it.states, it.links), (448, 200, 512, 512, 2048));
/// // The least: two stretches, and two leaves an action.
/// let it = Capacities::of(1, 12);
/// assert_eq!((it.stretches, it.leaves, it.rows, it.states, it.links), (2, 24, 64, 64, 256));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Capacities {
    /// Stretches of sixteen samples, at least 2 and less than 4096.
    pub stretches: usize,
    /// Leaves of the trees of a member, for all actions.
    pub leaves: usize,
    /// Rows of the habits.
    pub rows: usize,
    /// States of the model.
    pub states: usize,
    /// Links of the model.
    pub links: usize,
}

impl Capacities {
    /// Of a mind that remembers at least so many samples of a robot with so many actions.
    #[must_use]
    pub const fn of(samples: usize, actions: usize) -> Self {
        let stretches = at_least(samples.div_ceil(STRETCH), 2);
        let states = at_least(samples / 14, 64);
        Self {
            stretches,
            leaves: at_least(samples * 25 / 896, 2 * actions),
            rows: states,
            states,
            links: 4 * states,
        }
    }

    /// With so many states of the model, rows of the habits, and four links a state.
    ///
    /// A small world in which places look alike asks for more of them than of samples: the forager with
    /// 1024 samples and 512 states earns what it earns with 7168 and 512, in half of the memory.
    ///
    /// ```
    /// use cla_core::forest::Capacities;
    /// let it = Capacities::of(1024, 6).with_states(512);
    /// assert_eq!((it.stretches, it.leaves, it.rows, it.states, it.links), (64, 28, 512, 512, 2048));
    /// ```
    #[must_use]
    pub const fn with_states(self, states: usize) -> Self {
        let states = at_least(states, 64);
        Self {
            rows: states,
            states,
            links: 4 * states,
            ..self
        }
    }

    /// Of what a mind thinks with that imagines so many states at once.
    #[must_use]
    pub const fn thoughts(imagines: usize) -> Thoughts {
        Thoughts {
            samples: at_least(imagines * 3 / 34, 16),
            schemas: at_least(imagines * 15 / 17, 16),
        }
    }
}

/// The capacities of a [`Reason`](crate::reason::Reason) beside the states that it imagines.
///
/// ```
/// use cla_core::forest::Capacities;
/// let it = Capacities::thoughts(1700);
/// assert_eq!((it.samples, it.schemas), (150, 1500));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Thoughts {
    /// Samples of each action.
    pub samples: usize,
    /// Schemas of all actions.
    pub schemas: usize,
}

const fn at_least(number: usize, least: usize) -> usize {
    if number < least { least } else { number }
}

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
    /// 1024 samples and 512 states keeps .98 of what it captures with 7168 and 512 (claim
    /// `one.forager.small`, interval .91 to 1.04), in two fifths of the memory.
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

    /// Bytes of a mind without a reason, for a robot with so many items and actions; never less than it
    /// takes, and at most 4 more.
    ///
    /// ```
    /// use cla_core::forest::{Capacities, Mind};
    /// let it = Capacities::of(7168, 6);
    /// let takes = size_of::<Mind<1, 7, 6, 448, 200, 512, 512, 2048>>();
    /// assert!((takes..=takes + 4).contains(&it.bytes(7, 6).all()));
    /// ```
    #[must_use]
    pub const fn bytes(&self, items: usize, actions: usize) -> Bytes {
        let words = items.div_ceil(32);
        // Of the model's rows: a link for each action is two bytes.
        let links = (2 * actions).next_multiple_of(4);
        Bytes {
            // What was perceived, twice a word, what it brought, and its place in an index.
            samples: self.stretches * (STRETCH * (8 * words + 12) + 2 * STRETCH),
            trees: 84 * self.leaves + 52 * actions,
            habits: self.rows * (4 * actions + 2) + 4 * actions * items + 116 * words,
            model: self.states * (20 + links + 4 * actions) + 16 * self.links,
            rest: 40 * items + 564,
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

/// The bytes of a mind's parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bytes {
    /// The memory of samples.
    pub samples: usize,
    /// The trees that are grown from them.
    pub trees: usize,
    /// Habits, and the steps that they are about.
    pub habits: usize,
    /// The model.
    pub model: usize,
    /// Relevance, counts of a leaf, configuration, records.
    pub rest: usize,
}

impl Bytes {
    /// All of them.
    #[must_use]
    pub const fn all(&self) -> usize {
        (self.samples + self.trees + self.habits + self.model + self.rest).next_multiple_of(4)
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

#[cfg(test)]
mod tests {
    use super::Capacities;
    use crate::forest::Mind;

    macro_rules! takes {
        ($items:literal, $actions:literal, $stretches:literal, $leaves:literal, $rows:literal, $states:literal, $links:literal) => {{
            let it = Capacities {
                stretches: $stretches,
                leaves: $leaves,
                rows: $rows,
                states: $states,
                links: $links,
            };
            let takes = size_of::<
                Mind<
                    { $items / 33 + 1 },
                    $items,
                    $actions,
                    $stretches,
                    $leaves,
                    $rows,
                    $states,
                    $links,
                >,
            >();
            let said = it.bytes($items, $actions).all();
            assert!(said >= takes && said <= takes + 4, "{said} for {takes}");
        }};
    }

    #[test]
    fn the_bytes_of_a_mind_are_those_that_it_takes() {
        takes!(7, 6, 448, 200, 512, 512, 2048);
        takes!(7, 6, 64, 28, 512, 512, 2048);
        takes!(15, 5, 448, 200, 128, 128, 512);
        takes!(4, 3, 20, 10, 33, 33, 97);
        takes!(1, 1, 2, 2, 1, 1, 1);
        takes!(32, 32, 3, 64, 65, 67, 255);
        takes!(33, 7, 5, 17, 64, 77, 256);
        takes!(48, 6, 448, 201, 513, 511, 2047);
        takes!(64, 12, 100, 60, 77, 301, 1001);
    }
}

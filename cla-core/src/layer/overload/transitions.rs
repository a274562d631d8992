//! Overload by order: a winner that has never followed the winner before it.
//!
//! One bit for each pair of nodes, set late in training; 512 bytes for a layer of 64 nodes.
//! Our extension of section 3.4: dropped or exchanged moments are each familiar, and only their
//! order is not.

use super::{OverloadDetector, Response};

/// Which winner has followed which, in a layer of at most `NODES` nodes.
///
/// `WORDS` must be `NODES` / 32, rounded up; another number does not compile.
/// The first winner of an event follows nothing and is never an overload.
///
/// ```
/// use cla_core::layer::overload::{OverloadDetector, Response, Transitions};
/// use cla_core::som::{BestMatch, NodeId};
///
/// let winner = |node| Response {
///     best_match: BestMatch { node: NodeId(node), squared_distance: 0.0 },
///     total_activation: 1.0,
/// };
/// let mut detector = Transitions::<64, 2>::new();
/// for node in [1, 2, 3] {
///     detector.record(&winner(node));
/// }
/// detector.forget_context();
/// assert!(!detector.overloaded(&winner(2)));
/// assert!(!detector.overloaded(&winner(3)));
/// assert!(detector.overloaded(&winner(1))); // 3 → 1 is new
/// ```
///
/// ```compile_fail,E0080
/// let too_small = cla_core::layer::overload::Transitions::<64, 1>::new();
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Transitions<const NODES: usize, const WORDS: usize> {
    followed: [[u32; WORDS]; NODES],
    /// The last winner plus 1; 0 at the start of an event.
    last: u32,
}

impl<const NODES: usize, const WORDS: usize> Transitions<NODES, WORDS> {
    /// A table without transitions.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                WORDS == NODES.div_ceil(32),
                "a transition table of NODES nodes has NODES / 32 WORDS, rounded up"
            )
        }
        Self {
            followed: [[0; WORDS]; NODES],
            last: 0,
        }
    }

    /// How many transitions were recorded.
    #[must_use]
    pub fn recorded(&self) -> u32 {
        let mut count = 0;
        for word in self.followed.as_flattened() {
            count += word.count_ones();
        }
        count
    }

    /// The word and bit of the transition from the last winner to `next`; `None` without one.
    fn place(&mut self, next: u16) -> Option<(&mut u32, u32)> {
        let row = usize::try_from(self.last.checked_sub(1)?).ok()?;
        let word = self
            .followed
            .get_mut(row)?
            .get_mut(usize::from(next / 32))?;
        Some((word, 1 << (next % 32)))
    }
}

impl<const NODES: usize, const WORDS: usize> Default for Transitions<NODES, WORDS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const NODES: usize, const WORDS: usize> OverloadDetector for Transitions<NODES, WORDS> {
    fn record(&mut self, response: &Response) {
        let next = response.best_match.node.0;
        if let Some((word, bit)) = self.place(next) {
            *word |= bit;
        }
        self.last = u32::from(next) + 1;
    }

    /// 0 for a transition that was recorded and for the first winner of an event, 2 for a new one.
    fn strain(&mut self, response: &Response) -> f32 {
        let next = response.best_match.node.0;
        let new = self.place(next).is_some_and(|(word, bit)| *word & bit == 0);
        self.last = u32::from(next) + 1;
        if new { 2.0 } else { 0.0 }
    }

    fn forget_context(&mut self) {
        self.last = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::Transitions;
    use crate::layer::overload::{OverloadDetector, Response};
    use crate::som::{BestMatch, NodeId};

    fn winner(node: u16) -> Response {
        let best_match = BestMatch {
            node: NodeId(node),
            squared_distance: 0.0,
        };
        Response {
            best_match,
            total_activation: 1.0,
        }
    }

    #[test]
    fn exactly_the_recorded_pairs_are_familiar() {
        let mut table = Transitions::<40, 2>::new();
        for (a, b) in [(0, 39), (39, 39), (31, 32)] {
            table.forget_context();
            table.record(&winner(a));
            table.record(&winner(b));
        }
        assert_eq!(table.recorded(), 3);
        for (a, b, new) in [
            (0, 39, false),
            (39, 39, false),
            (31, 32, false),
            (32, 31, true),
        ] {
            table.forget_context();
            assert!(!table.overloaded(&winner(a)));
            assert_eq!(table.overloaded(&winner(b)), new, "{a} {b}");
        }
    }

    #[test]
    fn winners_outside_the_table_are_not_judged() {
        let mut table = Transitions::<4, 1>::new();
        table.record(&winner(900));
        table.record(&winner(u16::MAX));
        assert_eq!(table.recorded(), 0);
        assert!(!table.overloaded(&winner(1)));
    }
}

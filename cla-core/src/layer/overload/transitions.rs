//! Overload by order: a winner that has never followed the winner before it.
//!
//! One bit for each pair of nodes, set late in training; 512 bytes for a layer of 64 nodes.
//! Our extension of section 3.4: dropped or exchanged moments are each familiar, and only their
//! order is not.
//! On a map near nodes mean near things, so a slack of one node may be given to the second winner.

use super::{OverloadDetector, Response};
use crate::som::{Grid, NodeId};

/// Which winner has followed which, in a layer of `WIDTH` × `HEIGHT` nodes.
///
/// `WORDS` must be the number of nodes / 32, rounded up; another number does not compile.
/// The first winner of an event follows nothing and is never an overload.
/// RAM: nodes · `WORDS` · 4 bytes and 8 bytes.
///
/// ```
/// use cla_core::layer::overload::{OverloadDetector, Response, Transitions};
/// use cla_core::som::{BestMatch, NodeId};
///
/// let winner = |node| Response {
///     best_match: BestMatch { node: NodeId(node), squared_distance: 0.0 },
///     total_activation: 1.0,
/// };
/// let mut detector = Transitions::<8, 8, 2>::new();
/// for node in [1, 20, 40] {
///     detector.record(&winner(node));
/// }
/// detector.forget_context();
/// assert!(!detector.overloaded(&winner(20)));
/// assert!(!detector.overloaded(&winner(40)));
/// assert!(detector.overloaded(&winner(1))); // 40 → 1 is new
/// ```
///
/// ```compile_fail,E0080
/// let too_small = cla_core::layer::overload::Transitions::<8, 8, 1>::new();
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Transitions<const WIDTH: usize, const HEIGHT: usize, const WORDS: usize> {
    followed: Grid<[u32; WORDS], WIDTH, HEIGHT>,
    /// The last winner plus 1; 0 at the start of an event.
    last: u32,
    slack: u8,
}

impl<const WIDTH: usize, const HEIGHT: usize, const WORDS: usize>
    Transitions<WIDTH, HEIGHT, WORDS>
{
    /// A table without transitions, and without slack.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                WORDS == (WIDTH * HEIGHT).div_ceil(32),
                "a transition table has as many WORDS as its nodes / 32, rounded up"
            )
        }
        Self {
            followed: Grid::filled([0; WORDS]),
            last: 0,
            slack: 0,
        }
    }

    /// Lets a winner within `slack` columns and rows of a recorded one pass as familiar.
    pub const fn set_slack(&mut self, slack: u8) {
        self.slack = slack;
    }

    /// How many transitions were recorded.
    #[must_use]
    pub fn recorded(&self) -> u32 {
        let mut count = 0;
        for word in self.followed.as_slice().as_flattened() {
            count += word.count_ones();
        }
        count
    }

    /// The nodes that have followed the last winner; `None` at the start of an event.
    fn followers(&self) -> Option<&[u32; WORDS]> {
        let row = usize::try_from(self.last.checked_sub(1)?).ok()?;
        self.followed.as_slice().get(row)
    }

    /// Whether a node within the slack of `next` is among `followers`.
    fn familiar(&self, followers: &[u32; WORDS], next: NodeId) -> bool {
        let (column, row) = self.followed.position(next);
        let slack = usize::from(self.slack);
        let rows = row.saturating_sub(slack)..HEIGHT.min(row + slack + 1);
        rows.into_iter().any(|y| {
            let mut columns = column.saturating_sub(slack)..WIDTH.min(column + slack + 1);
            columns.any(|x| {
                let node = y * WIDTH + x;
                followers
                    .get(node / 32)
                    .is_some_and(|word| word >> (node % 32) & 1 == 1)
            })
        })
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const WORDS: usize> Default
    for Transitions<WIDTH, HEIGHT, WORDS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const WORDS: usize> OverloadDetector
    for Transitions<WIDTH, HEIGHT, WORDS>
{
    fn record(&mut self, response: &Response) {
        let next = response.best_match.node.0;
        if let Some(row) = self
            .last
            .checked_sub(1)
            .and_then(|row| usize::try_from(row).ok())
            && let Some(followers) = self.followed.as_mut_slice().get_mut(row)
            && let Some(word) = followers.get_mut(usize::from(next / 32))
        {
            *word |= 1 << (next % 32);
        }
        self.last = u32::from(next) + 1;
    }

    /// 0 for a transition that was recorded and for the first winner of an event, 2 for a new one.
    fn strain(&mut self, response: &Response) -> f32 {
        let next = response.best_match.node;
        let new = self
            .followers()
            .is_some_and(|followers| !self.familiar(followers, next));
        self.last = u32::from(next.0) + 1;
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

    fn table() -> Transitions<8, 5, 2> {
        let mut table = Transitions::new();
        for (a, b) in [(0, 39), (39, 39), (31, 32)] {
            table.forget_context();
            table.record(&winner(a));
            table.record(&winner(b));
        }
        table
    }

    fn is_new(table: &mut Transitions<8, 5, 2>, a: u16, b: u16) -> bool {
        table.forget_context();
        assert!(!table.overloaded(&winner(a)));
        table.overloaded(&winner(b))
    }

    #[test]
    fn exactly_the_recorded_pairs_are_familiar() {
        let mut table = table();
        assert_eq!(table.recorded(), 3);
        for a in 0..40 {
            for b in 0..40 {
                let known = [(0, 39), (39, 39), (31, 32)].contains(&(a, b));
                assert_eq!(is_new(&mut table, a, b), !known, "{a} {b}");
            }
        }
    }

    #[test]
    fn slack_is_given_to_grid_neighbours_and_to_no_one_across_an_edge() {
        let mut table = table();
        table.set_slack(1);
        // Node 32 is column 0 of row 4: its neighbours are 24, 25 and 33, not 31.
        for (b, new) in [
            (32, false),
            (24, false),
            (25, false),
            (33, false),
            (31, true),
            (34, true),
        ] {
            assert_eq!(is_new(&mut table, 31, b), new, "{b}");
        }
    }

    #[test]
    fn winners_outside_the_table_are_not_judged() {
        let mut table = Transitions::<2, 2, 1>::new();
        table.record(&winner(900));
        table.record(&winner(u16::MAX));
        assert_eq!(table.recorded(), 0);
        assert!(!table.overloaded(&winner(1)));
    }

    #[test]
    fn a_new_transition_strains_by_two_and_what_is_asked_about_is_the_last_winner() {
        let mut table = table();
        table.forget_context();
        assert_eq!(table.strain(&winner(31)), 0.0);
        assert_eq!(table.strain(&winner(32)), 0.0);
        assert_eq!(table.strain(&winner(0)), 2.0);
        assert_eq!(table.strain(&winner(39)), 0.0);
        assert_eq!(table.recorded(), 3, "asking records nothing");
    }

    #[test]
    fn a_wider_slack_reaches_as_many_columns_and_rows() {
        let mut table = Transitions::<8, 5, 2>::new();
        table.record(&winner(0));
        // Column 3 of row 2.
        table.record(&winner(19));
        table.set_slack(2);
        for b in 0..40_u16 {
            let near = (b % 8).abs_diff(3) <= 2 && (b / 8).abs_diff(2) <= 2;
            assert_eq!(is_new(&mut table, 0, b), !near, "{b}");
        }
    }
}

//! A mind before its birth: all of it zero, with or without reason.

use super::mind::Mind;
use crate::reason::Reasoning;

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS>
{
    /// An unborn mind of all-zero memory, without reason.
    #[must_use]
    pub const fn new() -> Self {
        Self::unborn()
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS>,
> Default for Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    fn default() -> Self {
        Self::unborn()
    }
}

//! The table of lives in the loop.

use super::trial::Life;
use crate::report::Table;

/// A life of each seed.
pub(super) fn lives(seeds: &[u64], lives: &[Life]) -> Table {
    let mut table = Table::new(&[
        "seed",
        "choices",
        "same as the host's",
        "captures in the test",
        "round trips",
    ]);
    for (seed, life) in seeds.iter().zip(lives) {
        let cells = [
            *seed,
            life.choices.into(),
            life.same.into(),
            life.captures.into(),
            life.round_trips.into(),
        ];
        table.row(cells.map(Into::into));
    }
    table
}

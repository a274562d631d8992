//! Synthetic items and beliefs as knowledge alone: for a table and a robot of another size.

use super::belief::{Belief, Row};
use super::rates::Rates;
use super::second_level::SecondLevel;
use crate::knowledge::Reliability;
use crate::snapshot::{LARGEST, LARGEST_COUNT, Reader, Stored, Writer};

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// Writes items, beliefs, and how often predictions came true.
    pub(crate) fn carry(&self, to: &mut Writer<'_>) {
        self.rates.store(to);
        self.predictions.store(to);
        (self.slow, self.fast).store(to);
        self.table.clock.store(to);
        self.rows().store(to);
        to.limits.synthetic = self.rows();
        for row in &self.table.rows {
            row.schema.store(to);
            row.action.store(to);
            for number in [row.value, row.experienced, row.visits] {
                number.store(to);
            }
            row.used.store(to);
            row.tried.store(to);
        }
        self.table.beliefs.store(to);
    }

    /// Reads that from a brain of so many actions, over what is there if there is anybody.
    pub(crate) fn take(mut into: Option<&mut Self>, actions: usize, from: &mut Reader<'_>) {
        let (mut rates, mut predictions) = (Rates::NONE, Reliability::ZERO);
        let (mut shares, mut clock) = ((0.0, 0.0), 0);
        rates.restore(from);
        predictions.restore(from);
        shares.restore(from);
        clock.restore(from);
        let share = 0.0..=1.1;
        from.require(share.contains(&shares.0) && share.contains(&shares.1));
        if let Some(it) = &mut into {
            it.clear();
            (it.rates, it.predictions) = (rates, predictions);
            (it.slow, it.fast) = shares;
            it.table.clock = clock;
        }
        let rows = from.count("synthetic items", SYNTHETIC);
        from.limits.synthetic = rows as u16;
        for _ in 0..rows {
            let row = row(actions, from);
            if from.is_wrong() {
                return;
            }
            if let Some(it) = &mut into {
                from.require(it.table.rows.push(row).is_ok());
            }
        }
        let beliefs = from.count("beliefs", BELIEFS);
        for _ in 0..beliefs {
            let mut belief = Belief::BLANK;
            belief.restore(from);
            if from.is_wrong() {
                return;
            }
            if let Some(it) = &mut into {
                from.require(it.table.beliefs.push(belief).is_ok());
            }
        }
    }
}

fn row<const ACTIONS: usize>(actions: usize, from: &mut Reader<'_>) -> Row<ACTIONS> {
    let mut row = Row::BLANK;
    row.schema.restore(from);
    row.action.restore(from);
    for number in [&mut row.value, &mut row.experienced, &mut row.visits] {
        number.restore(from);
    }
    row.used.restore(from);
    for tried in row.tried.iter_mut().take(actions) {
        tried.restore(from);
        from.require((0.0..=LARGEST_COUNT).contains(tried));
    }
    let sound = (0.0..=LARGEST).contains(&row.value) && (0.0..=LARGEST_COUNT).contains(&row.visits);
    from.require(sound);
    row
}

//! Synthetic items and beliefs as knowledge alone: for a table and a robot of another size.

use super::belief::{Belief, Row};
use super::rates::Rates;
use super::second_level::{MOST_SHARE, SecondLevel};
use crate::knowledge::Reliability;
use crate::snapshot::{LARGEST, LARGEST_COUNT, Reader, Stored, Writer};

impl<const ACTIONS: usize, const SYNTHETIC: usize, const BELIEFS: usize>
    SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>
{
    /// Writes items, beliefs, and how often predictions came true.
    pub(crate) fn carry(&self, to: &mut Writer<'_>) {
        self.rates.store(to);
        self.predictions.store(to);
        to.limits.up_to(MOST_SHARE);
        (self.slow, self.fast).store(to);
        to.limits.within(LARGEST);
        self.table.clock.store(to);
        self.rows().store(to);
        to.limits.synthetic = self.rows();
        for row in &self.table.rows {
            row.carry(to);
        }
        self.table.beliefs.store(to);
    }

    /// Reads that from a brain of so many actions, over what is there if there is anybody.
    pub(crate) fn take(mut into: Option<&mut Self>, actions: usize, from: &mut Reader<'_>) {
        let (mut rates, mut predictions) = (Rates::NONE, Reliability::ZERO);
        let (mut shares, mut clock) = ((0.0, 0.0), 0);
        rates.restore(from);
        predictions.restore(from);
        from.limits.up_to(MOST_SHARE);
        shares.restore(from);
        from.limits.within(LARGEST);
        clock.restore(from);
        if let Some(it) = &mut into {
            it.clear();
            (it.rates, it.predictions) = (rates, predictions);
            (it.slow, it.fast) = shares;
            it.table.clock = clock;
        }
        let rows = from.count("synthetic items", SYNTHETIC);
        from.limits.synthetic = rows as u16;
        for _ in 0..rows {
            let row = Row::taken(actions, from);
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

impl<const ACTIONS: usize> Row<ACTIONS> {
    fn carry(&self, to: &mut Writer<'_>) {
        self.schema.store(to);
        self.action.store(to);
        to.limits.up_to(LARGEST);
        self.value.store(to);
        to.limits.within(LARGEST);
        self.experienced.store(to);
        to.limits.up_to(LARGEST_COUNT);
        self.visits.store(to);
        self.used.store(to);
        self.tried.store(to);
        to.limits.within(LARGEST);
    }

    fn taken(actions: usize, from: &mut Reader<'_>) -> Self {
        let mut row = Self::BLANK;
        row.schema.restore(from);
        row.action.restore(from);
        from.limits.up_to(LARGEST);
        row.value.restore(from);
        from.limits.within(LARGEST);
        row.experienced.restore(from);
        from.limits.up_to(LARGEST_COUNT);
        row.visits.restore(from);
        row.used.restore(from);
        for tried in row.tried.iter_mut().take(actions) {
            tried.restore(from);
        }
        from.limits.within(LARGEST);
        row
    }
}

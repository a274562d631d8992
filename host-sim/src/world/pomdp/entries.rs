//! Reads the chances and rewards of a file: each may be one number, a row or a whole matrix, and what
//! stands later holds.

use super::model::Reward;
use super::parser::{Body, Parser, Rows, Which, Word};
use super::words::PomdpError;

impl Parser<'_> {
    pub(super) fn transition(&mut self) -> Result<(), PomdpError> {
        let action = self.one("action")?;
        let from = if self.words.colon() {
            Some(self.one("state")?)
        } else {
            None
        };
        let to = if from.is_some() && self.words.colon() {
            Some(self.one("state")?)
        } else {
            None
        };
        let allowed: &[(&str, Word)] = match (from, to) {
            (None, _) => &[("uniform", Word::Uniform), ("identity", Word::Identity)],
            (_, None) => &[("uniform", Word::Uniform), ("reset", Word::Reset)],
            _ => &[],
        };
        let start = self.head.start.clone();
        self.fill("an end state", action, from, to, allowed, |body| {
            (&mut body.transitions, start)
        })
    }

    pub(super) fn observation(&mut self) -> Result<(), PomdpError> {
        let action = self.one("action")?;
        let at = if self.words.colon() {
            Some(self.one("state")?)
        } else {
            None
        };
        let what = if at.is_some() && self.words.colon() {
            Some(self.one("observation")?)
        } else {
            None
        };
        let allowed: &[(&str, Word)] = match what {
            None => &[("uniform", Word::Uniform)],
            _ => &[],
        };
        self.fill("an observation", action, at, what, allowed, |body| {
            (&mut body.observes, None)
        })
    }

    /// Reads one chance, a row of them or a whole matrix into the rows that are meant.
    fn fill(
        &mut self,
        of: &str,
        action: Which,
        row: Option<Which>,
        column: Option<Which>,
        allowed: &[(&str, Word)],
        table: impl FnOnce(&mut Body) -> (&mut Rows, Option<Vec<f64>>),
    ) -> Result<(), PomdpError> {
        let place = self.words.peek().map_or(self.words.end(), |it| it.place);
        let word = self.instead(allowed);
        let Some(mut body) = self.body.take() else {
            return Ok(());
        };
        let [states, actions, _] = body.sizes;
        let (rows, start) = table(&mut body);
        let width = rows.width;
        let wanted = match (row, column) {
            (_, Some(_)) => 1,
            (Some(_), None) => width,
            (None, None) => states * width,
        };
        let mut numbers = Vec::new();
        if word.is_none() {
            for _ in 0..wanted {
                let place = self.words.peek().map_or(place, |it| it.place);
                numbers.push((self.words.probability(of)?, place));
            }
        }
        for action in each(action, actions) {
            for (line, state) in each(row.flatten(), states).enumerate() {
                let row_index = action * states + state;
                for to in each(column.flatten(), width) {
                    // A row stands where its first number does.
                    let (chance, place) = match word {
                        Some(Word::Uniform) => (1.0 / width as f64, place),
                        Some(Word::Identity) => (f64::from(u8::from(state == to)), place),
                        Some(Word::Reset) => {
                            let start = start.as_ref().map(|start| start[to]);
                            (start.unwrap_or(1.0 / width as f64), place)
                        }
                        None if column.is_some() => numbers[0],
                        None if row.is_some() => (numbers[to].0, place),
                        None => (numbers[line * width + to].0, numbers[line * width].1),
                    };
                    rows.set(row_index, to, chance, place);
                }
            }
        }
        self.body = Some(body);
        Ok(())
    }

    pub(super) fn reward(&mut self) -> Result<(), PomdpError> {
        let sign = if self.head.cost == Some(true) {
            -1.0
        } else {
            1.0
        };
        let action = self.one("action")?;
        self.words.need_colon("the action of a reward")?;
        let from = self.one("state")?;
        let to = if self.words.colon() {
            Some(self.one("state")?)
        } else {
            None
        };
        let seen = if to.is_some() && self.words.colon() {
            Some(self.one("observation")?)
        } else {
            None
        };
        let Some(body) = &mut self.body else {
            return Ok(());
        };
        let [states, _, observations] = body.sizes;
        // What is not one number stands for as many as there are end states or observations.
        let ends: Vec<Which> = match to {
            Some(to) => vec![to],
            None => (0..states).map(Some).collect(),
        };
        let sights: Vec<Which> = match seen {
            Some(seen) => vec![seen],
            None => (0..observations).map(Some).collect(),
        };
        for &to in &ends {
            for &seen in &sights {
                let value = sign * self.words.number("a reward")?.0;
                body.rewards.push(Reward {
                    action,
                    from,
                    to,
                    seen,
                    value,
                });
            }
        }
        Ok(())
    }
}

/// The index that is meant, or all below `count`.
fn each(which: Which, count: usize) -> core::ops::Range<usize> {
    which.map_or(0..count, |it| it..it + 1)
}

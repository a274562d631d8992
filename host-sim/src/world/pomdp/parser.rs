//! A file half read: its words, its names and its tables, with what all readers of parts need.

use super::model::Reward;
use super::words::{Place, PomdpError, Words, quoted};
use crate::world::names::Names;

/// By how much the chances of a row may miss 1.
pub(super) const ROUNDING: f64 = 1e-4;

/// An index, or any.
pub(super) type Which = Option<usize>;

/// What a row of numbers may be replaced by.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    Uniform,
    Identity,
    Reset,
}

/// What is known before the first chance is read.
#[derive(Default)]
pub(super) struct Head {
    pub(super) discount: Option<f64>,
    pub(super) cost: Option<bool>,
    pub(super) states: Option<Names>,
    pub(super) actions: Option<Names>,
    pub(super) observations: Option<Names>,
    pub(super) start: Option<Vec<f64>>,
}

pub(super) struct Parser<'a> {
    pub(super) words: Words<'a>,
    pub(super) head: Head,
    /// Rows of transitions and of observations, with the place that filled each last.
    pub(super) body: Option<Body>,
}

/// The tables of a file.
pub(super) struct Body {
    /// States, actions, observations.
    pub(super) sizes: [usize; 3],
    pub(super) transitions: Rows,
    pub(super) observes: Rows,
    pub(super) rewards: Vec<Reward>,
}

/// Chances by row, with the place that filled each last.
pub(super) struct Rows {
    pub(super) width: usize,
    pub(super) chances: Vec<f64>,
    filled: Vec<Option<Place>>,
}

impl Rows {
    pub(super) fn new(rows: usize, width: usize) -> Self {
        Self {
            width,
            chances: vec![0.0; rows * width],
            filled: vec![None; rows],
        }
    }

    pub(super) fn set(&mut self, row: usize, column: usize, chance: f64, place: Place) {
        self.chances[row * self.width + column] = chance;
        self.filled[row] = Some(place);
    }

    /// Every row must have been filled with chances that sum up to 1; scales them to it.
    pub(super) fn close(
        &mut self,
        end: Place,
        name: impl Fn(usize) -> String,
    ) -> Result<(), PomdpError> {
        for (row, chances) in self.chances.chunks_mut(self.width.max(1)).enumerate() {
            let total = chances.iter().fold(0.0, |sum, chance| sum + chance);
            let Some(place) = self.filled[row] else {
                let sentence = format!("the file ends without the chances of {}", name(row));
                return Err(PomdpError::new(end, sentence));
            };
            if (total - 1.0).abs() > ROUNDING {
                let sentence = format!("the chances of {} sum up to {total}, not to 1", name(row));
                return Err(PomdpError::new(place, sentence));
            }
            for chance in chances {
                *chance /= total;
            }
        }
        Ok(())
    }
}

impl Parser<'_> {
    /// One of `names` by name or number, or `*` for each.
    pub(super) fn which(&mut self, kind: &str, names: Names) -> Result<Which, PomdpError> {
        let word = self.words.word(&format!("an index or name: the {kind}"))?;
        if word.text == "*" {
            return Ok(None);
        }
        let number = || word.text.parse::<usize>().ok();
        let named = names.iter().position(|&name| name == word.text);
        let found = named.or_else(|| number().filter(|&it| it < names.len()));
        if found.is_some() {
            return Ok(found);
        }
        let few: Vec<&str> = names.iter().copied().take(6).collect();
        let (found, few) = (quoted(word.text), few.join(", "));
        let sentence = format!("{found} is no {kind}: there are {}, {few}", names.len());
        Err(PomdpError::new(word.place, sentence))
    }

    pub(super) fn list(&self, kind: &str) -> Names {
        let names = match kind {
            "state" => self.head.states,
            "action" => self.head.actions,
            _ => self.head.observations,
        };
        names.unwrap_or(&[])
    }

    pub(super) fn one(&mut self, kind: &str) -> Result<Which, PomdpError> {
        self.which(kind, self.list(kind))
    }

    /// A word in place of numbers, if one of `allowed` stands there.
    pub(super) fn instead(&mut self, allowed: &[(&str, Word)]) -> Option<Word> {
        let text = self.words.peek()?.text;
        let found = allowed.iter().find(|it| it.0 == text)?.1;
        self.words.word("").ok()?;
        Some(found)
    }
}

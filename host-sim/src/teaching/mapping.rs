//! How the columns of a log become items and actions: thresholds with a band, bins, categories.

use std::path::Path;

use cla_core::word::Threshold;
use serde::Deserialize;

use crate::failure::Impossible;
use crate::settings::{of_tree, read};

/// Most edges of one column's bins, and most of its categories.
const MOST: usize = 32;

/// What a mapping file says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mapping {
    /// Between the fields of a row: one character.
    #[serde(default = "comma")]
    pub separator: char,
    /// Whether the first row has the names of the columns; else they are called 1, 2 and so on.
    #[serde(default = "yes")]
    pub header: bool,
    /// What stands where a reading is missing; an item that is made of it is unknown then. Without any,
    /// a reading that is missing is an error.
    #[serde(default)]
    pub unknown: Vec<String>,
    /// A column whose value is another one when another episode begins.
    pub episode: Option<String>,
    /// The column of the actions.
    pub action: ActionColumn,
    /// The columns of the items.
    #[serde(rename = "item")]
    pub items: Vec<ItemColumn>,
}

/// Where the action of a row stands: what was done next.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ActionColumn {
    /// The column.
    pub column: String,
    /// The names of the actions as they stand there, in the order of their numbers.
    pub names: Vec<String>,
}

/// One column of readings and how it becomes items: exactly one of `above`, `below`, `bins` and
/// `categories`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ItemColumn {
    /// The column.
    pub column: String,
    /// What its item is called, or what stands before the number of a bin or a category [the column].
    pub name: Option<String>,
    /// On above this reading.
    pub above: Option<f32>,
    /// On below this reading.
    pub below: Option<f32>,
    /// The edges between bins, rising; each bin is an item, and one of them is on.
    pub bins: Option<Vec<f32>>,
    /// Texts that may stand there; each is an item, and one of them is on.
    pub categories: Option<Vec<String>>,
    /// Hysteresis: what was on or off stays so within this distance of a level or an edge.
    #[serde(default)]
    pub band: f32,
    /// Readings in a row that must agree before an item changes.
    #[serde(default = "one")]
    pub debounced: u8,
}

const fn comma() -> char {
    ','
}

const fn yes() -> bool {
    true
}

const fn one() -> u8 {
    1
}

/// How one column is read.
#[derive(Clone, Debug)]
pub enum Reading {
    /// A number that makes one item.
    Level(Threshold),
    /// A number that makes an item for each bin, of which one is on: the edges, each held by itself.
    Bins(Vec<Threshold>),
    /// A text, one of these.
    Categories(Vec<String>),
}

impl Mapping {
    /// Reads a mapping from a file.
    ///
    /// # Errors
    /// [`Impossible`] for a file that cannot be read, and for the first thing in it that cannot be.
    pub fn read(path: &Path) -> Result<Self, Impossible> {
        let wrong = |why: Impossible| Impossible::new(format!("{}: {why}", path.display()));
        let mapping: Self = of_tree(read(path)?, "the mapping").map_err(wrong)?;
        mapping.check().map_err(wrong)?;
        Ok(mapping)
    }

    fn check(&self) -> Result<(), Impossible> {
        let no = |why: String| Err(Impossible::new(why));
        // A quote is what stands around a field, and the end of a line ends a row.
        if !self.separator.is_ascii() || matches!(self.separator, '"' | '\n' | '\r') {
            return no(format!("{:?} cannot separate fields", self.separator));
        }
        if let Some(name) = twice(&self.action.names) {
            return no(format!("the action {name:?} is named twice"));
        }
        for column in &self.items {
            column.reading()?;
        }
        match twice(&self.names()) {
            Some(name) => no(format!("two items are called {name}")),
            None => Ok(()),
        }
    }

    /// The names of all items, in their order.
    #[must_use]
    pub fn names(&self) -> Vec<String> {
        self.items.iter().flat_map(ItemColumn::names).collect()
    }
}

/// The first name that is there twice.
fn twice(names: &[String]) -> Option<&String> {
    let mut all = names.iter().enumerate();
    all.find_map(|(at, name)| names[..at].contains(name).then_some(name))
}

impl ItemColumn {
    /// The names of its items.
    fn names(&self) -> Vec<String> {
        let name = self.name.as_ref().unwrap_or(&self.column);
        match (&self.bins, &self.categories) {
            (Some(edges), _) => (0..=edges.len()).map(|it| format!("{name}_{it}")).collect(),
            (_, Some(texts)) => texts.iter().map(|it| format!("{name}_{it}")).collect(),
            _ => vec![name.clone()],
        }
    }

    /// How its readings become items.
    ///
    /// # Errors
    /// [`Impossible`] for levels that are no numbers or do not rise, and for none or several ways.
    pub fn reading(&self) -> Result<Reading, Impossible> {
        let column = &self.column;
        let no = |why: &str| Err(Impossible::new(format!("column {column}: {why}")));
        let ways = [
            self.above.is_some(),
            self.below.is_some(),
            self.bins.is_some(),
            self.categories.is_some(),
        ];
        if ways.iter().filter(|&&it| it).count() != 1 {
            return no("it takes one of above, below, bins and categories");
        }
        if !(self.band >= 0.0 && self.band.is_finite()) {
            return no("its band is a number from 0 on");
        }
        if let Some(texts) = &self.categories {
            if self.band != 0.0 || self.debounced != one() {
                return no("categories have no band, and are not debounced");
            }
            let sized = (1..=MOST).contains(&texts.len());
            return match twice(texts) {
                None if sized => Ok(Reading::Categories(texts.clone())),
                None => no("it takes 1 to 32 categories"),
                Some(_) => no("a category is named twice"),
            };
        }
        let edges = match (&self.bins, self.above.or(self.below)) {
            (Some(edges), _) => edges.clone(),
            (None, level) => level.into_iter().collect(),
        };
        if !(1..=MOST).contains(&edges.len()) {
            return no("it takes 1 to 32 edges of bins");
        }
        if edges.iter().any(|it| !it.is_finite()) {
            return no("a level is no number");
        }
        // Bands that meet would let two bins be on.
        let apart = |pair: &[f32]| pair[1] - pair[0] > 2.0 * self.band;
        if !edges.windows(2).all(apart) {
            return no("its edges rise, each by more than two bands");
        }
        let level = |edge: f32| {
            let level = if self.below.is_some() {
                Threshold::below(edge)
            } else {
                Threshold::above(edge)
            };
            level.band(self.band).debounced(self.debounced)
        };
        Ok(match edges[..] {
            [only] if self.bins.is_none() => Reading::Level(level(only)),
            _ => Reading::Bins(edges.into_iter().map(level).collect()),
        })
    }
}

impl Reading {
    /// The states of its items after a text was read; `None` for what is missing.
    ///
    /// # Errors
    /// A sentence for a text that is no such reading.
    pub fn states(&mut self, text: Option<&str>) -> Result<Vec<Option<bool>>, String> {
        match self {
            Self::Level(level) => Ok(vec![level.read(number(text)?)]),
            Self::Bins(edges) => {
                let number = number(text)?;
                let passed = edges.iter_mut().map(|it| it.read(number) == Some(true));
                let bin = passed.filter(|&it| it).count();
                let state = |it| text.map(|_| it == bin);
                Ok((0..=edges.len()).map(state).collect())
            }
            Self::Categories(all) => {
                let Some(text) = text else {
                    return Ok(vec![None; all.len()]);
                };
                match all.iter().position(|it| it == text) {
                    Some(place) => Ok((0..all.len()).map(|it| Some(it == place)).collect()),
                    None => Err(format!("{text:?} is none of {}", all.join(", "))),
                }
            }
        }
    }
}

/// NaN for what is missing.
fn number(text: Option<&str>) -> Result<f32, String> {
    let Some(text) = text else {
        return Ok(f32::NAN);
    };
    let number = text.parse::<f32>().ok().filter(|it| !it.is_nan());
    number.ok_or_else(|| format!("{text:?} is no number"))
}

//! A recorded log as steps: what was perceived, what was done then, and what that led to.

use std::path::Path;

use cla_core::word::{ActionId, ItemId, ItemStates};
use csv::{ReaderBuilder, StringRecord};

use super::mapping::{Mapping, Reading};
use crate::failure::Impossible;
use crate::whole::read;

/// Words of an item set.
pub const WORDS: usize = 2;
/// Most items of a log.
pub const ITEMS: usize = 64;
/// Most actions of a log.
pub const ACTIONS: usize = 12;
/// Most bytes of a log.
const MOST_BYTES: u64 = 1 << 30;

/// What was perceived at one moment.
pub type Percept = ItemStates<WORDS>;

/// One action and what it led to.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Before it.
    pub before: Percept,
    /// The action.
    pub action: ActionId,
    /// After it.
    pub after: Percept,
    /// Whether an episode begins with it.
    pub begins: bool,
}

/// A log whose columns have become items and actions.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// The names of the items.
    pub items: Vec<String>,
    /// The names of the actions.
    pub actions: Vec<String>,
    /// The rows.
    pub rows: usize,
    /// The steps, in their order.
    pub steps: Vec<Step>,
}

/// Where the columns of a mapping stand in a row.
struct Columns {
    names: Vec<String>,
    items: Vec<(usize, Reading)>,
    /// The readings as they are when an episode begins.
    fresh: Vec<(usize, Reading)>,
    action: usize,
    episode: Option<usize>,
    /// The episode of the row before.
    during: String,
}

/// A row that was read.
struct Row {
    percept: Percept,
    action: ActionId,
    episode: String,
}

impl Log {
    /// Reads a log as a mapping says.
    ///
    /// The action of a row is what was done in it, and the next row is what that led to; what the last
    /// row of an episode led to is not known.
    ///
    /// # Errors
    /// [`Impossible`] with line and column of the first thing that cannot be.
    pub fn read(path: &Path, mapping: &Mapping) -> Result<Self, Impossible> {
        let wrong = |why: String| Impossible::new(format!("{}: {why}", path.display()));
        let bytes =
            read(path, MOST_BYTES).map_err(|why| wrong(format!("cannot read it: {why}")))?;
        Self::parse(&bytes, mapping).map_err(wrong)
    }

    /// As [`read`](Self::read), of the bytes of a log.
    ///
    /// # Errors
    /// A sentence with line and column of the first thing that cannot be.
    pub fn parse(bytes: &[u8], mapping: &Mapping) -> Result<Self, String> {
        let items = mapping.names();
        let actions = mapping.action.names.clone();
        if !(1..=ITEMS).contains(&items.len()) || !(1..=ACTIONS).contains(&actions.len()) {
            return Err(format!(
                "a log has 1 to {ITEMS} items and 1 to {ACTIONS} actions, not {} and {}",
                items.len(),
                actions.len()
            ));
        }
        let mut rows = ReaderBuilder::new()
            .delimiter(u8::try_from(mapping.separator).unwrap_or(b','))
            .has_headers(false)
            // How many fields there are is looked at here, to say which row has another number.
            .flexible(true)
            .from_reader(bytes)
            .into_records();
        let mut ahead = None;
        let first = match rows.next() {
            None => return Err("the log is empty".to_owned()),
            Some(row) => row.map_err(|why| unread(&why))?,
        };
        let names: Vec<String> = if mapping.header {
            first.iter().map(|it| it.trim().to_owned()).collect()
        } else {
            let numbers = (1..=first.len()).map(|it| it.to_string()).collect();
            ahead = Some(Ok(first));
            numbers
        };
        let mut columns = Columns::find(names, mapping)?;
        let mut log = Self {
            items,
            actions,
            rows: 0,
            steps: Vec::new(),
        };
        let mut last: Option<Row> = None;
        let mut begins = true;
        for record in ahead.into_iter().chain(rows) {
            let record = record.map_err(|why| unread(&why))?;
            let row = columns.row(&record, mapping)?;
            match last.take() {
                Some(before) if before.episode == row.episode => {
                    log.steps.push(Step {
                        before: before.percept,
                        action: before.action,
                        after: row.percept,
                        begins,
                    });
                    begins = false;
                }
                _ => begins = true,
            }
            last = Some(row);
            log.rows += 1;
        }
        Ok(log)
    }
}

impl Columns {
    fn find(names: Vec<String>, mapping: &Mapping) -> Result<Self, String> {
        let at = |column: &String| {
            let mut places = names.iter().enumerate().filter(|(_, it)| *it == column);
            match (places.next(), places.next()) {
                (Some((place, _)), None) => Ok(place),
                (Some(_), Some(_)) => Err(format!("line 1: there are two columns {column}")),
                (None, _) => {
                    let known = names.join(", ");
                    Err(format!(
                        "line 1: there is no column {column}: there are {known}"
                    ))
                }
            }
        };
        let mut items = Vec::new();
        for column in &mapping.items {
            let reading = column.reading().map_err(|why| why.to_string())?;
            items.push((at(&column.column)?, reading));
        }
        Ok(Self {
            action: at(&mapping.action.column)?,
            episode: mapping.episode.as_ref().map(at).transpose()?,
            during: String::new(),
            fresh: items.clone(),
            items,
            names,
        })
    }

    fn row(&mut self, record: &StringRecord, mapping: &Mapping) -> Result<Row, String> {
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != self.names.len() {
            let (fields, columns) = (record.len(), self.names.len());
            return Err(format!(
                "line {line} has {fields} fields, and there are {columns} columns"
            ));
        }
        let field = |at: usize| record.get(at).unwrap_or_default().trim();
        let episode = self.episode.map_or("", field);
        if episode != self.during {
            self.items.clone_from(&self.fresh);
            episode.clone_into(&mut self.during);
        }
        let names = &self.names;
        let wrong = |at: usize, why: String| format!("line {line}, column {}: {why}", names[at]);
        let mut states = Vec::new();
        for (at, reading) in &mut self.items {
            let text = field(*at);
            let missing = mapping.unknown.iter().any(|it| it == text);
            if text.is_empty() && !missing {
                return Err(wrong(*at, "the reading is missing".to_owned()));
            }
            let read = reading.states((!missing).then_some(text));
            states.extend(read.map_err(|why| wrong(*at, why))?);
        }
        let mut percept = Percept::all_off(ITEMS as u16);
        for (item, state) in (0..).map(ItemId).zip(states) {
            // There are at most as many items as fit.
            let _ = percept.set(item, state);
        }
        let (name, known) = (field(self.action), &mapping.action.names);
        let action = known.iter().position(|it| it == name).ok_or_else(|| {
            let known = known.join(", ");
            wrong(
                self.action,
                format!("there is no action {name:?}: there are {known}"),
            )
        })?;
        Ok(Row {
            percept,
            action: ActionId(action as u16),
            episode: episode.to_owned(),
        })
    }
}

fn unread(why: &csv::Error) -> String {
    match why.position() {
        Some(at) => format!("line {}: it is no row of a table in UTF-8", at.line()),
        None => "it is no table".to_owned(),
    }
}

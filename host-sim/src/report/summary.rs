//! The record of one run of one experiment: everything that is printed, drawn or written.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::claims::Claim;

/// What an experiment returns; as JSON it is the claims file.
///
/// ```
/// use host_sim::report::{Summary, Table};
/// let mut summary = Summary::new("forage", &[100, 101]);
/// summary.parameter("radius", 5.0);
/// let mut table = Table::new(&["actions", "captures"]);
/// table.row([1000.into(), 17.5.into()]);
/// summary.table("learning curve", table);
/// assert_eq!(summary.to_json().lines().next(), Some("{"));
/// assert_eq!(Summary::from_json(&summary.to_json())?, summary);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The name of the experiment, which is that of its subcommand.
    pub experiment: String,
    /// The version of the program.
    pub version: String,
    /// The command line that gives this result again.
    pub command: String,
    /// The seeds, in the order of every claim's measurements.
    pub seeds: Vec<u64>,
    /// Everything else that decides the result.
    pub parameters: BTreeMap<String, Value>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// Further numbers, by title.
    pub tables: BTreeMap<String, Table>,
}

/// Rows of numbers and words under named columns.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// The heads of the columns.
    pub columns: Vec<String>,
    /// The rows, as long as the heads.
    pub rows: Vec<Vec<Value>>,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(columns: &[&str]) -> Self {
        Self {
            columns: columns.iter().map(|&column| column.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row; numbers that are not finite become `null`.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Value>) {
        self.rows.push(cells.into_iter().collect());
    }
}

impl Summary {
    /// A summary without claims yet; the command line is filled in by whoever was called by it.
    #[must_use]
    pub fn new(experiment: &str, seeds: &[u64]) -> Self {
        Self {
            experiment: experiment.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            command: String::new(),
            seeds: seeds.to_vec(),
            parameters: BTreeMap::new(),
            claims: Vec::new(),
            tables: BTreeMap::new(),
        }
    }

    /// Notes a parameter that decides the result.
    pub fn parameter(&mut self, name: &str, value: impl Into<Value>) {
        self.parameters.insert(name.to_owned(), value.into());
    }

    /// Adds a claim.
    pub fn claim(&mut self, claim: Claim) {
        self.claims.push(claim);
    }

    /// Adds a table, in place of one with the same title.
    pub fn table(&mut self, title: &str, table: Table) {
        self.tables.insert(title.to_owned(), table);
    }

    /// The claim with this id.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<&Claim> {
        self.claims.iter().find(|claim| claim.id == id)
    }

    /// The summary as JSON: whole numbers and fractions come back to the last bit.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut text = serde_json::to_string_pretty(self)
            .expect("a summary has only string keys and finite numbers");
        text.push('\n');
        text
    }

    /// Reads a summary back.
    ///
    /// # Errors
    /// When the text is no summary.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}

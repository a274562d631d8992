//! What a brain knows and how it is, as data: everything that is told, drawn, compared or exported of
//! it is made from this.

use serde::Serialize;

/// A brain, seen from outside.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Portrait {
    /// For which robot and world it is.
    pub robot: String,
    /// `agent`, the book's learner, or `mind`, the one learner.
    pub kind: String,
    /// Bytes of its image.
    pub bytes: u32,
    /// What it does with its life.
    pub stage: String,
    /// What its maps were shown, or what is in its memory.
    pub samples: u64,
    /// How often it suspected that the world has changed.
    pub alarms: u32,
    /// The names of its actions.
    pub actions: Vec<String>,
    /// Its primitive items.
    pub items: Vec<Item>,
    /// What it expects: of an agent its schemas, of a mind the contexts of its trees; by worth.
    pub schemas: Vec<Schema>,
    /// What an agent believes after what; by how often it was so.
    pub beliefs: Vec<Belief>,
    /// Who decides in a mind.
    pub voices: Vec<Voice>,
    /// How full its tables are.
    pub tables: Vec<Filling>,
    /// What found no room or made room, and other counts of its health.
    pub losses: Vec<Count>,
}

/// A primitive item.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Item {
    /// Its name.
    pub name: String,
    /// What being on is worth for its own sake.
    pub inherent: f64,
    /// Of an agent, what it is worth for what it leads to.
    pub deferred: Option<f64>,
    /// Of a mind, how clearly it tells values apart.
    pub relevance: Option<f64>,
    /// What being on adds to the habit of each action.
    pub habits: Vec<f64>,
}

/// A signed item of a context or a result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Sign {
    /// Its name; what was before has `was_` before it, the last action `did_`.
    pub item: String,
    /// Whether it is to be on.
    pub on: bool,
}

/// A schema, or a context of a tree, which has no result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Schema {
    /// In the book's notation, all signs.
    pub text: String,
    /// The same without items that are off.
    pub brief: String,
    /// What must hold before.
    pub context: Vec<Sign>,
    /// What is done.
    pub action: String,
    /// What is expected afterwards.
    pub result: Vec<Sign>,
    /// What its result, or the action in this context, is worth.
    pub value: f64,
    /// How often what it says came true; a context has none.
    pub reliability: Option<f64>,
    /// How often it was tried.
    pub trials: Option<u32>,
}

impl Schema {
    /// Value times reliability.
    #[must_use]
    pub fn worth(&self) -> f64 {
        self.value * self.reliability.unwrap_or(1.0)
    }
}

/// After the schema `after` has succeeded, `item` would succeed next.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Belief {
    /// The schema that has just succeeded.
    pub after: String,
    /// The schema that is believed to be next.
    pub item: String,
    /// Occasions on which it was so; older ones weigh less.
    pub on: f64,
    /// Occasions in all.
    pub tried: f64,
}

/// Who may decide in a mind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Voice {
    /// Its name.
    pub name: String,
    /// What an action under it brought, now and later.
    pub brought: f64,
    /// Blocks that it has led.
    pub blocks: u32,
}

/// A table and how full it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Filling {
    /// What it holds.
    pub table: String,
    /// How many.
    pub used: u32,
    /// At most.
    pub capacity: u32,
}

/// Something counted or measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Count {
    /// What.
    pub what: String,
    /// How much.
    pub count: f64,
}

impl Count {
    pub(super) fn new(what: &str, count: impl Into<f64>) -> Self {
        Self {
            what: what.to_owned(),
            count: count.into(),
        }
    }
}

impl Filling {
    pub(super) fn new(table: &str, used: u32, capacity: u32) -> Self {
        Self {
            table: table.to_owned(),
            used,
            capacity,
        }
    }
}

/// Signed items in the book's notation; those that are off only where all are asked for.
pub(super) fn written(signs: &[Sign], all: bool) -> String {
    let asked = signs.iter().filter(|it| all || it.on);
    let written = asked.map(|it| format!("{}{}", if it.on { '+' } else { '-' }, it.item));
    written.collect()
}

/// By worth, then by reliability, the rest as it was.
pub(super) fn by_worth(schemas: &mut [Schema]) {
    schemas.sort_by(|a, b| {
        let reliable = b.reliability.partial_cmp(&a.reliability);
        b.worth()
            .total_cmp(&a.worth())
            .then(reliable.unwrap_or(core::cmp::Ordering::Equal))
    });
}

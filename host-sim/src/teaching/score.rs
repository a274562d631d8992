//! How well the next percept is foretold: by the learner, and by two who know nothing of what leads
//! where.

use cla_core::growth::SimpleSchema;
use cla_core::word::{ItemId, ItemSet};
use serde_json::{Value, json};

use super::log::{ACTIONS, ITEMS, Percept, Step, WORDS};
use crate::report::Table;

/// What is foretold of a percept: the items that will be on.
pub type Foretold = ItemSet<WORDS>;

/// How often somebody was right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Score {
    /// Items that were known before and after, and those of them that were foretold.
    pub items: [u64; 2],
    /// Items that changed, and those of them whose change was foretold.
    pub changed: [u64; 2],
    /// Changes that were foretold, and those of them that came.
    pub foretold: [u64; 2],
    /// Percepts, and those of which every known item was foretold.
    pub percepts: [u64; 2],
}

impl Score {
    /// Counts one step, of a log with so many items.
    pub fn count(&mut self, step: &Step, items: usize, foretold: &Foretold) {
        let mut whole = true;
        for item in (0..items as u16).map(ItemId) {
            let (Some(was), Some(is)) = (step.before.get(item), step.after.get(item)) else {
                continue;
            };
            let said = foretold.contains(item);
            let right = u64::from(said == is);
            let add = |to: &mut [u64; 2]| *to = [to[0] + 1, to[1] + right];
            add(&mut self.items);
            if was != is {
                add(&mut self.changed);
            }
            if said != was {
                add(&mut self.foretold);
            }
            whole &= said == is;
        }
        self.percepts = [self.percepts[0] + 1, self.percepts[1] + u64::from(whole)];
    }
}

/// A share of a count; NaN of nothing.
#[must_use]
pub fn share([all, some]: [u64; 2]) -> f64 {
    some as f64 / all as f64
}

/// Who says that nothing changes.
#[must_use]
pub fn unchanged(now: &Percept) -> Foretold {
    *now.on()
}

/// Who says of every item what it has mostly become after an action, from what it was.
#[derive(Clone, Debug)]
pub struct Frequent(Vec<[[u32; 2]; 2]>);

impl Default for Frequent {
    fn default() -> Self {
        Self(vec![[[0; 2]; 2]; ACTIONS * ITEMS])
    }
}

impl Frequent {
    fn place(step: &Step, item: ItemId) -> usize {
        usize::from(step.action.0) * ITEMS + usize::from(item.0)
    }

    /// Takes in what was seen.
    pub fn learn(&mut self, step: &Step) {
        for item in (0..ITEMS as u16).map(ItemId) {
            if let (Some(was), Some(is)) = (step.before.get(item), step.after.get(item)) {
                self.0[Self::place(step, item)][usize::from(was)][usize::from(is)] += 1;
            }
        }
    }

    /// What is to come; what was never seen does not change.
    #[must_use]
    pub fn foretell(&self, step: &Step) -> Foretold {
        let mut all = Foretold::EMPTY;
        for item in (0..ITEMS as u16).map(ItemId) {
            let Some(was) = step.before.get(item) else {
                continue;
            };
            let [off, on] = self.0[Self::place(step, item)][usize::from(was)];
            if on > off || on == off && was {
                // It is an item of the percept.
                let _ = all.insert(item);
            }
        }
        all
    }
}

/// What a schema says: which item becomes what after an action, and where.
#[derive(Clone, Debug, PartialEq)]
struct Said {
    context: Vec<(ItemId, bool)>,
    item: ItemId,
    becomes: bool,
    /// Steps of the lesson in which it said so, and those of them in which it came.
    record: [u32; 2],
}

impl Said {
    /// Whether it says that something changes now.
    fn applies(&self, now: &Percept) -> bool {
        let holds = |&(item, on): &(ItemId, bool)| now.get(item) == Some(on);
        now.get(self.item) == Some(!self.becomes) && self.context.iter().all(holds)
    }
}

/// A learner's schemas, held against the lesson that they were learned from.
///
/// A schema is grown from what surprised, and so it says more than mostly comes; here it speaks where
/// what it said came in more than half of the taught steps.
#[derive(Clone, Debug)]
pub struct Held(Vec<Vec<Said>>);

impl Held {
    /// These schemas, with their record in these steps.
    #[must_use]
    pub fn new(schemas: &[SimpleSchema], taught: &[Step]) -> Self {
        let mut all = vec![Vec::new(); ACTIONS];
        for it in schemas {
            if let Some(of_action) = all.get_mut(usize::from(it.action().0)) {
                of_action.push(Said {
                    context: it.context().collect(),
                    item: it.result_item(),
                    becomes: it.result_sign(),
                    record: [0; 2],
                });
            }
        }
        for step in taught {
            for said in &mut all[usize::from(step.action.0)] {
                if let Some(is) = step.after.get(said.item)
                    && said.applies(&step.before)
                {
                    said.record[0] += 1;
                    said.record[1] += u32::from(is == said.becomes);
                }
            }
        }
        Self(all)
    }

    /// What is to come after the action of a step; what no schema speaks of stays.
    #[must_use]
    pub fn foretell(&self, step: &Step) -> Foretold {
        let mut all = *step.before.on();
        for said in &self.0[usize::from(step.action.0)] {
            let [tried, came] = said.record;
            if 2 * came > tried && said.applies(&step.before) {
                if said.becomes {
                    // It is an item of the percept.
                    let _ = all.insert(said.item);
                } else {
                    all.remove(said.item);
                }
            }
        }
        all
    }
}

/// Everybody's scores in numbers.
#[must_use]
pub fn table(scores: &[(&str, Score)]) -> Table {
    let mut table = Table::new(&[
        "who foretells",
        "items right",
        "of those that changed",
        "changes foretold that came",
        "whole percepts right",
    ]);
    let cell = |counts: [u64; 2]| -> Value {
        if counts[0] == 0 {
            json!("–")
        } else {
            json!((share(counts) * 1e4).round() / 1e4)
        }
    };
    for (who, score) in scores {
        table.row([
            json!(who),
            cell(score.items),
            cell(score.changed),
            cell(score.foretold),
            cell(score.percepts),
        ]);
    }
    table
}

//! The one learner, taught by a recorded log: what somebody's sensors said and what was done.
//!
//! `mapping` says how columns become items and actions, `log` reads the rows, `score` counts what was
//! foretold.
//! The first part of a log is taught, the rest is held out: there the learner foretells the next
//! percept of every row and learns nothing more.

mod log;
mod mapping;
mod score;

use std::path::PathBuf;

use cla_core::forest::{Mind, MindConfig};
use cla_core::reason::Reason;
use cla_core::snapshot::Names;
use serde_json::json;

pub use log::{ACTIONS, ITEMS, Log, Percept, Step, WORDS};
pub use mapping::{ActionColumn, ItemColumn, Mapping, Reading};
pub use score::{Foretold, Frequent, Held, Score, share, table, unchanged};

use crate::failure::{Failure, Impossible};
use crate::learner::image::image_of;
use crate::report::{Section, Table, leaf, rows, table_text};
use crate::whole::write;

/// Schemas and what they lead to: 150 samples an action, 1500 schemas, 1700 imagined states.
type Thoughts = Reason<WORDS, ITEMS, ACTIONS, 150, 1500, 1700>;
/// The mind that is taught; it has the sizes of Python's profile `planner` of 64 items and 12 actions.
pub type Pupil = Mind<WORDS, ITEMS, ACTIONS, 48, 64, 256, 64, 64, Thoughts>;

/// Most thoughts after the last lesson, and the units of one.
const THOUGHTS: u32 = 100;
const THOUGHT: u32 = 10_000;
/// Schemas on a page.
const SHOWN: usize = 400;

/// What is to be done.
#[derive(Clone, Debug)]
pub struct Teaching {
    /// The log, a table of text.
    pub log: PathBuf,
    /// How its columns become items and actions.
    pub mapping: PathBuf,
    /// The share of its steps that is taught, above 0 and below 1.
    pub taught: f64,
    /// Of the learner.
    pub seed: u64,
    /// Where the brain is kept.
    pub save: Option<PathBuf>,
    /// Where the page goes.
    pub page: Option<PathBuf>,
}

/// What came of it.
#[derive(Clone, Debug)]
pub struct Lesson {
    /// The learner after its last lesson.
    pub pupil: Box<Pupil>,
    /// Steps that were taught.
    pub taught: usize,
    /// Steps that were held out.
    pub held_out: usize,
    /// The learner by those of its schemas that mostly held in the lesson, which is counted here and not
    /// kept with it, and by all of them, as a kept one foretells; who says that nothing changes, and who
    /// says what is most frequent.
    pub scores: [(&'static str, Score); 4],
}

/// Reads, teaches, keeps and draws as an order says; what came of it in words.
///
/// # Errors
/// [`Impossible`] for a mapping or a log that cannot be, [`Failure`] for a file that cannot be written.
pub fn taught(order: &Teaching) -> Result<String, Failure> {
    let mapping = Mapping::read(&order.mapping)?;
    let log = Log::read(&order.log, &mapping)?;
    let lesson = teach(&log, order.taught, order.seed)?;
    let said = format!(
        "{} rows, {} items, {} actions: {} steps taught, {} held out",
        log.rows,
        log.items.len(),
        log.actions.len(),
        lesson.taught,
        lesson.held_out
    );
    let scores = table(&lesson.scores);
    let mut text = format!("{said}\n\n{}", table_text(&scores).trim_end());
    if let Some(path) = &order.page {
        let section = |title: &str, html| Section {
            title: title.to_owned(),
            html,
        };
        let sections = [
            section("What was foretold of the next percept", rows(&scores)),
            section("Schemas", rows(&schemas(&lesson.pupil, &log))),
        ];
        let title = format!("taught by {}", order.log.display());
        write(path, leaf(&title, &said, &sections).as_bytes())?;
        text.push_str(&format!("\n\nthe page is {}", path.display()));
    }
    if let Some(path) = &order.save {
        let items: Vec<&str> = log.items.iter().map(String::as_str).collect();
        let actions: Vec<&str> = log.actions.iter().map(String::as_str).collect();
        let image = image_of(&*lesson.pupil, Names::of(&items, &actions))?;
        write(path, &image)?;
        text.push_str(&format!(
            "\nsaved {}, {} bytes",
            path.display(),
            image.len()
        ));
    }
    Ok(text)
}

/// What the learner holds to follow from what, the most often tried first.
fn schemas(pupil: &Pupil, log: &Log) -> Table {
    let mut all: Vec<_> = pupil.reason().schemas().iter().collect();
    all.sort_by_key(|it| core::cmp::Reverse(it.activations()));
    let mut table = Table::new(&["context/action/result", "tried", "right"]);
    let signed = |item: usize, on: bool| {
        let name = log.items.get(item).map_or("?", String::as_str);
        format!("{}{name}", if on { '+' } else { '-' })
    };
    for it in all.into_iter().take(SHOWN) {
        let context: String = it
            .context()
            .map(|(item, on)| signed(usize::from(item.0), on))
            .collect();
        let action = log.actions.get(usize::from(it.action().0));
        let action = action.map_or("?", String::as_str);
        let result = signed(usize::from(it.result_item().0), it.result_sign());
        let right = f64::from(it.successes()) / f64::from(it.activations().max(1));
        table.row([
            json!(format!("{context}/{action}/{result}")),
            json!(it.activations()),
            json!((right * 1e3).round() / 1e3),
        ]);
    }
    table
}

/// Teaches the first steps of a log and foretells the rest.
///
/// # Errors
/// [`Impossible`] for a log that is too short, [`Failure`] of the learner.
pub fn teach(log: &Log, taught: f64, seed: u64) -> Result<Lesson, Failure> {
    let cut = (log.steps.len() as f64 * taught) as usize;
    let (first, rest) = log.steps.split_at(cut.min(log.steps.len()));
    if first.is_empty() || rest.is_empty() {
        let steps = log.steps.len();
        let sentence = format!("a log of {steps} steps is too short to be taught and held out");
        return Err(Impossible::new(sentence).into());
    }
    let mut pupil = Box::new(Pupil::unborn());
    pupil.be_born(MindConfig::DEFAULT, [0.0; ITEMS], seed)?;
    let mut frequent = Frequent::default();
    for step in first {
        if step.begins {
            pupil.interrupt()?;
        }
        pupil.observe(&step.before, step.action, &step.after)?;
        frequent.learn(step);
    }
    // What is left to think is thought; nothing new is seen.
    for _ in 0..THOUGHTS {
        if !pupil.pending() {
            break;
        }
        pupil.idle(THOUGHT);
    }
    let mut scores = [
        ("the learner, by what mostly held", Score::default()),
        ("the learner, by all its schemas", Score::default()),
        ("nothing changes", Score::default()),
        ("the most frequent result", Score::default()),
    ];
    let items = log.items.len();
    let mut reason = Box::new(pupil.reason().clone());
    let held = Held::new(reason.schemas(), first);
    for step in rest {
        if step.begins {
            reason.interrupt();
        }
        reason.perceive(&step.before);
        let foretold = [
            held.foretell(step),
            reason.predict(&step.before, step.action),
            unchanged(&step.before),
            frequent.foretell(step),
        ];
        for ((_, score), said) in scores.iter_mut().zip(&foretold) {
            score.count(step, items, said);
        }
    }
    Ok(Lesson {
        pupil,
        taught: first.len(),
        held_out: rest.len(),
        scores,
    })
}

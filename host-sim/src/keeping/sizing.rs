//! How large a brain should be, before there is one.
//!
//! Bytes are those of `Capacities::bytes`, which a test of the core holds; how many situations there are
//! is counted in a log.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};

use cla_core::forest::Capacities;

use crate::failure::{Failure, Impossible};
use crate::logs::read_log;
use crate::report::{Table, grouped, table_text};

/// The samples that are proposed, smallest first.
const SAMPLES: [usize; 5] = [512, 1024, 2048, 4096, 7168];
/// Samples of a stretch.
const STRETCH: usize = 16;
/// The most that a brain remembers: less than 4096 stretches.
const MOST_SAMPLES: usize = 4095 * STRETCH;
/// The fewest and the most states of its model.
const STATES: RangeInclusive<usize> = 64..=16_383;
/// The most items and actions of a learner, `2 * items + actions` being below this.
const FEATURES: usize = 255;
const ACTIONS: usize = 32;
/// Situations that have come no more often are not counted.
const RARE: u32 = 1;

/// What is asked of a brain.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// Items; with a log, those of the log.
    pub items: Option<usize>,
    /// Actions, likewise.
    pub actions: Option<usize>,
    /// So many samples alone.
    pub samples: Option<usize>,
    /// So many states, in place of a fourteenth of the samples.
    pub states: Option<usize>,
    /// The bytes that there are.
    pub ram: Option<u64>,
    /// A log of its life, or of one like it.
    pub log: Option<PathBuf>,
}

/// What a log says of a world.
struct World {
    items: usize,
    actions: usize,
    /// Actions that were done.
    done: usize,
    /// Different percepts.
    percepts: usize,
    /// Steps of a percept, an action and the percept after it that came more than once.
    situations: usize,
}

/// Sizes for a robot, each with its bytes.
///
/// # Errors
/// [`Impossible`] when items or actions are missing, and for numbers that no brain can have; those of
/// the log.
///
/// ```
/// use host_sim::keeping::{Wanted, size};
/// let text = size(&Wanted { items: Some(7), actions: Some(6), ..Wanted::default() })?;
/// assert!(text.contains("250,688"), "{text}");
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
pub fn size(wanted: &Wanted) -> Result<String, Failure> {
    check(wanted)?;
    let world = wanted.log.as_deref().map(seen).transpose()?;
    let of_log = |it: fn(&World) -> usize| world.as_ref().map(it);
    let items = wanted.items.or_else(|| of_log(|it| it.items));
    let actions = wanted.actions.or_else(|| of_log(|it| it.actions));
    let (Some(items), Some(actions)) = (items, actions) else {
        let sentence = "size needs --items N and --actions N, or --log FILE of a life";
        return Err(Impossible::new(sentence).into());
    };
    let fits = (1..FEATURES).contains(&items) && (1..=ACTIONS).contains(&actions);
    if !fits || 2 * items + actions >= FEATURES {
        let sentence = format!(
            "--items {items} --actions {actions}: a brain has 1 to {ACTIONS} actions, and twice its items \
             and its actions together are less than {FEATURES}"
        );
        return Err(Impossible::new(sentence).into());
    }
    let states = wanted.states.or_else(|| of_log(proposed));
    let mut text = format!("a brain for {items} items and {actions} actions");
    if let Some(world) = &world {
        text.push_str(&format!(
            "\nthe log has {} actions, {} percepts, and {} steps of percept, action and percept that came more \
             than once: that is how many states it asks for; proposed are {}",
            world.done,
            world.percepts,
            world.situations,
            proposed(world)
        ));
    }
    let mut head = vec![
        "samples",
        "states",
        "bytes",
        "of samples",
        "trees",
        "habits",
        "model",
    ];
    if wanted.ram.is_some() {
        head.push("fits");
    }
    let mut table = Table::new(&head);
    let asked = wanted.samples.map_or(SAMPLES.to_vec(), |it| vec![it]);
    for samples in asked {
        let usual = Capacities::of(samples, actions);
        let it = states.map_or(usual, |states| usual.with_states(states));
        let bytes = it.bytes(items, actions);
        let parts = [bytes.samples, bytes.trees, bytes.habits, bytes.model];
        let mut row = vec![
            (STRETCH * it.stretches).into(),
            it.states.into(),
            grouped(bytes.all() as u64).into(),
        ];
        row.extend(parts.map(|part| grouped(part as u64).into()));
        if let Some(ram) = wanted.ram {
            row.push(
                if bytes.all() as u64 <= ram {
                    "yes"
                } else {
                    "no"
                }
                .into(),
            );
        }
        table.row(row);
    }
    text.push_str("\n\n");
    text.push_str(&table_text(&table));
    text.push_str(
        "\nIn brain!: samples: SAMPLES, states: STATES, ram: BYTES. What a call takes does not hang on the \
         sizes: see memory-budget.md. A brain that is too small says so (health, cramped).",
    );
    Ok(text)
}

/// Whether a brain can have the samples and states that are wanted.
fn check(wanted: &Wanted) -> Result<(), Impossible> {
    let bounds = [
        ("samples", wanted.samples, 1..=MOST_SAMPLES),
        ("states", wanted.states, STATES),
    ];
    for (what, number, range) in bounds {
        if let Some(number) = number.filter(|it| !range.contains(it)) {
            let [least, most] = [*range.start(), *range.end()].map(|it| grouped(it as u64));
            let sentence = format!("--{what} {number}: a brain has {least} to {most} {what}");
            return Err(Impossible::new(sentence));
        }
    }
    Ok(())
}

/// States for the situations of a world: the next power of two, 64 to 4096.
fn proposed(world: &World) -> usize {
    world.situations.next_power_of_two().clamp(64, 4096)
}

fn seen(path: &Path) -> Result<World, Failure> {
    let (life, steps) = read_log(path)?;
    let mut percepts = BTreeSet::new();
    let mut situations = BTreeMap::new();
    for step in &steps {
        percepts.insert(&step.percept.on);
    }
    for pair in steps.windows(2) {
        let [before, after] = pair else { continue };
        if let Some(choice) = &before.choice {
            let step = (&before.percept.on, &choice.action, &after.percept.on);
            *situations.entry(step).or_insert(0_u32) += 1;
        }
    }
    Ok(World {
        items: life.items.len(),
        actions: life.actions.len(),
        done: steps.iter().filter(|it| it.choice.is_some()).count(),
        percepts: percepts.len(),
        situations: situations.values().filter(|&&it| it > RARE).count(),
    })
}

#[cfg(test)]
mod tests {
    use super::{Wanted, size};
    use crate::logs::{Chosen, Life, Perceived, Pose, Rewarded, Step, write_log};

    fn of(items: usize, actions: usize) -> Wanted {
        Wanted {
            items: Some(items),
            actions: Some(actions),
            ..Wanted::default()
        }
    }

    #[test]
    fn a_proposal_says_its_bytes_and_whether_it_fits() {
        let small = Wanted {
            samples: Some(1024),
            states: Some(512),
            ram: Some(128 * 1024),
            ..of(7, 6)
        };
        let text = size(&small).unwrap();
        assert!(text.contains("101,072") && text.contains("yes"), "{text}");
        let text = size(&Wanted {
            ram: Some(101_071),
            ..small
        });
        assert!(text.unwrap().contains("no"));
    }

    #[test]
    fn what_no_brain_can_have_is_refused_in_a_sentence() {
        for wanted in [Wanted::default(), of(0, 3), of(3, 0), of(3, 33), of(126, 3)] {
            let sentence = size(&wanted).unwrap_err().to_string();
            assert!(sentence.contains("--items"), "{sentence}");
        }
        assert!(size(&of(100, 12)).is_ok());
        for (items, actions) in [(usize::MAX, 3), (3, usize::MAX)] {
            let sentence = size(&of(items, actions)).unwrap_err().to_string();
            assert!(sentence.contains("--items"), "{sentence}");
        }
        for (samples, states, words) in [
            (Some(0), None, "--samples 0: a brain has 1 to 65,520"),
            (Some(65_521), None, "--samples 65521: "),
            (Some(70_000), None, "--samples 70000: "),
            (Some(usize::MAX), None, "--samples 18446744073709551615: "),
            (None, Some(1), "--states 1: a brain has 64 to 16,383"),
            (None, Some(16_384), "--states 16384: "),
            (None, Some(usize::MAX), "--states 18446744073709551615: "),
        ] {
            let wanted = Wanted {
                samples,
                states,
                ..of(7, 6)
            };
            let sentence = size(&wanted).unwrap_err().to_string();
            assert!(sentence.contains(words), "{sentence}");
        }
    }

    /// The least brain has two stretches, and samples come in sixteens.
    #[test]
    fn what_a_brain_has_is_said_and_not_what_was_asked_for() {
        for (samples, has) in [(1, "32"), (1000, "1008"), (65_520, "65520")] {
            let wanted = Wanted {
                samples: Some(samples),
                ..of(7, 6)
            };
            let text = size(&wanted).unwrap();
            let row = text
                .lines()
                .find(|line| line.split_whitespace().next() == Some(has));
            assert!(row.is_some(), "{text}");
        }
    }

    #[test]
    fn every_action_and_every_percept_of_a_log_is_counted() {
        let step = |number: usize, on: &[&str], action: Option<&str>| Step {
            step: number,
            percept: Perceived {
                on: on.iter().map(|&it| it.to_owned()).collect(),
            },
            choice: action.map(|action| Chosen {
                action: action.to_owned(),
                schema: String::new(),
                value: 0.0,
            }),
            reward: Rewarded {
                obtained: 0,
                in_all: 0,
            },
            alarm: None,
            pose: Pose {
                x: 0.0,
                y: 0.0,
                heading: 0.0,
            },
            specimens: Vec::new(),
        };
        let steps = [
            step(0, &["light"], Some("stay")),
            step(1, &["light"], Some("stay")),
            step(2, &["light"], Some("go")),
            // Only the end shows the lamp.
            step(3, &["lamp"], None),
        ];
        let life = Life {
            about: "a moth".to_owned(),
            items: ["light", "lamp"].map(str::to_owned).to_vec(),
            actions: ["stay", "go"].map(str::to_owned).to_vec(),
            radius: 1.0,
            camera_range: 1.0,
            specimens: Vec::new(),
        };
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("moth.jsonl");
        write_log(&log, &life, &steps).unwrap();
        let wanted = Wanted {
            log: Some(log),
            ..Wanted::default()
        };
        let text = size(&wanted).unwrap();
        let said =
            "a brain for 2 items and 2 actions\nthe log has 3 actions, 2 percepts, and 1 steps";
        assert!(text.starts_with(said), "{text}");
    }
}

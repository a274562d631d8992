//! What a log says of a life: once what it is about, then each action.

use serde::{Deserialize, Serialize};

use crate::experiment::recover::film::Film;
use crate::world::pioneer::{ACTIONS, ITEMS};

/// What stands in the place of a thought when the log ends.
const END: &str = "the log ends here";

/// What a log is about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Life {
    /// The command that wrote it, or who lived, in words.
    pub about: String,
    /// The names of the items.
    pub items: Vec<String>,
    /// The names of the actions.
    pub actions: Vec<String>,
    /// Radius of the room, metres.
    pub radius: f64,
    /// How far the camera sees, metres.
    pub camera_range: f64,
    /// The places of the specimens at the beginning, metres; `null` for one that is not there.
    pub specimens: Vec<Option<[f64; 2]>>,
}

/// What was perceived.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Perceived {
    /// The items that are on.
    pub on: Vec<String>,
}

/// What was chosen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chosen {
    /// The action.
    pub action: String,
    /// The schema that spoke for it, or why none did.
    pub schema: String,
    /// What it was worth.
    pub value: f64,
}

/// What had been obtained before the choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Rewarded {
    /// Since the action before.
    pub obtained: u32,
    /// Since the life began.
    pub in_all: u32,
}

/// Whether the robot suspects that its world has changed; noted when that changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Alarmed {
    /// Whether it does from now on.
    pub doubts: bool,
}

/// Where the robot is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Metres from the room's centre.
    pub x: f64,
    /// Metres from the room's centre.
    pub y: f64,
    /// Degrees, to the left when positive.
    pub heading: f64,
}

/// A specimen that is elsewhere than it was.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moved {
    /// Its number.
    pub specimen: usize,
    /// Where it is now, metres; `null` when it is gone.
    pub to: Option<[f64; 2]>,
}

/// One action; the last record of a log has no choice, and says what the last action has led to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Step {
    /// Its number, from 0.
    pub step: usize,
    /// What was perceived.
    pub percept: Perceived,
    /// What was chosen; nothing at the end of the life.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub choice: Option<Chosen>,
    /// What had been obtained.
    pub reward: Rewarded,
    /// Only where it changes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub alarm: Option<Alarmed>,
    /// Where the robot was.
    pub pose: Pose,
    /// What had moved.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub specimens: Vec<Moved>,
}

impl Life {
    /// Of a film.
    #[must_use]
    pub fn of(film: &Film, about: &str, radius: f64, camera_range: f64) -> Self {
        let names = |all: &[&str]| all.iter().map(|&it| it.to_owned()).collect();
        Self {
            about: about.to_owned(),
            items: names(&ITEMS),
            actions: names(&ACTIONS),
            radius,
            camera_range,
            specimens: film.first.clone(),
        }
    }
}

/// The steps of a film, whose last frame shows what the last action has led to.
#[must_use]
pub fn steps(film: &Film) -> Vec<Step> {
    let doubts = |frame: usize| film.doubts.iter().any(|it| (it[0]..it[1]).contains(&frame));
    let mut before = film.captures.first().copied().unwrap_or(0);
    let mut all = Vec::with_capacity(film.poses.len());
    let end = film.poses.len().saturating_sub(1);
    for (step, (pose, on)) in film.poses.iter().zip(&film.on).enumerate() {
        let in_all = film.captures.get(step).copied().unwrap_or(before);
        let thought = film.thoughts.get(step).and_then(|&it| film.spoken.get(it));
        let action = film.actions.get(step).and_then(|&it| ACTIONS.get(it));
        let moved = film.moved.get(step).map_or(&[][..], Vec::as_slice);
        let (now, then) = (doubts(step), step > 0 && doubts(step - 1));
        all.push(Step {
            step,
            percept: Perceived {
                on: (0..)
                    .zip(ITEMS)
                    .filter(|(bit, _)| on >> bit & 1 == 1)
                    .map(|(_, name)| name.to_owned())
                    .collect(),
            },
            choice: (step < end).then(|| Chosen {
                action: action.map_or("", |it| it).to_owned(),
                schema: thought.cloned().unwrap_or_default(),
                value: film.values.get(step).copied().unwrap_or(0.0),
            }),
            reward: Rewarded {
                obtained: in_all - before,
                in_all,
            },
            alarm: (now != then).then_some(Alarmed { doubts: now }),
            pose: Pose {
                x: pose[0],
                y: pose[1],
                heading: pose[2],
            },
            specimens: moved
                .iter()
                .map(|&(specimen, to)| Moved { specimen, to })
                .collect(),
        });
        before = in_all;
    }
    all
}

/// Whether these are all steps of a life: numbered from 0 on, each with a choice but the last.
///
/// # Errors
/// A sentence for what is missing.
pub(super) fn complete(steps: &[Step]) -> Result<(), String> {
    if let Some((place, _)) = (0..).zip(steps).find(|(place, it)| it.step != *place) {
        return Err(format!("action {place} is missing"));
    }
    let Some((end, before)) = steps.split_last() else {
        return Err("the log has no actions".to_owned());
    };
    if let Some(it) = before.iter().find(|it| it.choice.is_none()) {
        return Err(format!("action {} has no choice", it.step));
    }
    match end.choice {
        None => Ok(()),
        Some(_) => Err("the log is cut off: what its last action has led to is missing".to_owned()),
    }
}

/// The film of a log; in words what the log has that no film can show.
///
/// # Errors
/// A sentence for an item, an action or a specimen that the Pioneer does not have.
///
/// The frame of the end goes on with the action before it.
pub fn film(life: &Life, steps: &[Step]) -> Result<Film, String> {
    let mut film = Film {
        first: life.specimens.clone(),
        knocked: steps.len(),
        ..Film::default()
    };
    let mut doubting = None;
    for (frame, step) in steps.iter().enumerate() {
        let wrong = |what: &str| format!("action {}: {what}", step.step);
        let mut on = 0;
        for name in &step.percept.on {
            let item = ITEMS.iter().position(|it| it == name);
            on |= 1 << item.ok_or_else(|| wrong(&format!("there is no item {name:?}")))?;
        }
        let before = film.actions.last().copied().unwrap_or_default();
        let (action, schema, value) = match &step.choice {
            Some(Chosen {
                action,
                schema,
                value,
            }) => {
                let place = ACTIONS.iter().position(|it| it == action);
                let place = place.ok_or_else(|| wrong(&format!("there is no action {action:?}")));
                (place?, schema.as_str(), *value)
            }
            None => (before, END, 0.0),
        };
        if let Some(it) = step
            .specimens
            .iter()
            .find(|it| it.specimen >= film.first.len())
        {
            return Err(wrong(&format!("there is no specimen {}", it.specimen)));
        }
        let spoken = film.spoken.iter().position(|it| it == schema);
        let spoken = spoken.unwrap_or_else(|| {
            film.spoken.push(schema.to_owned());
            film.spoken.len() - 1
        });
        film.poses
            .push([step.pose.x, step.pose.y, step.pose.heading]);
        film.on.push(on);
        film.actions.push(action);
        film.values.push(value);
        film.captures.push(step.reward.in_all);
        film.thoughts.push(spoken);
        let moved = step.specimens.iter().map(|it| (it.specimen, it.to));
        film.moved.push(moved.collect());
        match (step.alarm.map(|it| it.doubts), doubting) {
            (Some(true), None) => doubting = Some(frame),
            (Some(false), Some(from)) => {
                film.doubts.push([from, frame]);
                doubting = None;
            }
            _ => {}
        }
    }
    if let Some(from) = doubting {
        film.doubts.push([from, steps.len()]);
    }
    Ok(film)
}

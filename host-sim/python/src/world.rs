//! The worlds, as the class `World` of the module; the environments of Gymnasium stand on it.

use std::collections::HashMap;
use std::sync::Arc;

use host_sim::world::config::{AfterCapture, PioneerConfig};
use host_sim::world::generated::{Generated, Spec};
use host_sim::world::keys::Keys;
use host_sim::world::lake::Lake;
use host_sim::world::microworld::{Body, Microworld};
use host_sim::world::pioneer::Pioneer;
use host_sim::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
use host_sim::world::vacuum::Vacuum;
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::guard::{guarded, refused};
use crate::percept;
use crate::stage::{Stage, Step};

/// Numbers and texts by name.
type Options = HashMap<String, f64>;

/// A world that a seed has made.
#[pyclass(module = "cla._native")]
pub(crate) struct World {
    pub(crate) stage: Stage,
}

type Reflex<'py> = (Bound<'py, PyArray1<i8>>, usize, Bound<'py, PyArray1<i8>>);
type Outcome<'py> = (Bound<'py, PyArray1<i8>>, f64, Vec<Reflex<'py>>);

#[pymethods]
impl World {
    /// A world of that name; `options` are its numbers, `text` is a file's where it is made of one.
    #[new]
    #[pyo3(signature = (name, seed, options, text=None))]
    fn new(name: &str, seed: u64, options: Options, text: Option<&str>) -> PyResult<Self> {
        guarded(|| {
            let stage = made(name, seed, options, text).map_err(refused)?;
            Ok(Self { stage })
        })
    }

    /// The names of its items.
    fn items(&self) -> Vec<&'static str> {
        self.stage.look().items().to_vec()
    }

    /// The names of its actions.
    fn actions(&self) -> Vec<&'static str> {
        self.stage.look().actions().to_vec()
    }

    /// What is sensed now.
    fn sense<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i8>>> {
        guarded(|| {
            let world = self.stage.look();
            Ok(percept::written(py, &world.sense(), world.items().len()))
        })
    }

    /// Does an action; what was felt before any reflex, what was earned with them, the reflexes.
    fn step<'py>(&mut self, py: Python<'py>, action: usize) -> PyResult<Outcome<'py>> {
        let count = self.stage.look().actions().len();
        if action >= count {
            return Err(refused(format_args!(
                "there are {count} actions, and {action} is none of them"
            )));
        }
        let step = guarded(|| self.stage.step(action).map_err(refused))?;
        let Step {
            felt,
            earned,
            reflexes,
        } = step;
        let items = self.stage.look().items().len();
        let array = |percept| percept::written(py, percept, items);
        let reflexes = reflexes
            .iter()
            .map(|(before, by, after)| (array(before), *by, array(after)))
            .collect();
        Ok((array(&felt), earned, reflexes))
    }

    /// Whether the episode has ended, and whether it was for want of time.
    fn ended(&self) -> PyResult<(bool, bool)> {
        guarded(|| {
            let world = self.stage.look();
            let over = world.episode_ended() || world.finished();
            Ok((over, over && self.stage.out_of_time()))
        })
    }

    /// Begins the next episode.
    fn begin_episode(&mut self) -> PyResult<()> {
        guarded(|| {
            self.stage.world().begin_episode();
            Ok(())
        })
    }

    /// Something breaks after so many actions of this life; at once when they are done.
    fn break_after(&mut self, damage: &str, actions: u64) -> PyResult<()> {
        guarded(|| self.stage.break_after(damage, actions).map_err(refused))
    }

    /// Numbers about it that nobody in it perceives.
    fn facts(&self) -> PyResult<HashMap<&'static str, f64>> {
        guarded(|| Ok(self.stage.facts().into_iter().collect()))
    }
}

/// Makes a world, and sees to it that every option was one of its own.
fn made(name: &str, seed: u64, mut options: Options, text: Option<&str>) -> Result<Stage, String> {
    let mut take = |field: &str, default: f64| options.remove(field).unwrap_or(default);
    let stage = match name {
        "pioneer" => {
            let config = pioneer(&mut take)?;
            let world = Pioneer::new(config, seed).map_err(|it| it.to_string())?;
            Stage::new(world, seed)
        }
        "microworld" => {
            let slip = within("slip", take("slip", 0.0), 0.0, 1.0)? as f32;
            let hidden = take("hidden_body", 0.0) != 0.0;
            let body = if hidden { Body::Hidden } else { Body::Visible };
            Stage::new(Microworld::new(seed, body, slip), seed)
        }
        "shuttle" => Stage::new(file(SHUTTLE, seed)?, seed),
        "pomdp" => {
            let text = text.ok_or("a world of a file needs its text")?;
            Stage::new(file(text, seed)?, seed)
        }
        "vacuum" => Stage::new(Vacuum::new(seed), seed),
        "lake" => Stage::new(Lake::new(seed), seed),
        "keys" => Stage::new(Keys::new(seed), seed),
        "generated" => {
            let most = 9_007_199_254_740_992.0; // 2⁵³
            let world = within("world", take("world", 0.0), 0.0, most)? as u64;
            Stage::new(Generated::new(Arc::new(Spec::random(world)), seed), seed)
        }
        _ => return Err(format!("there is no world {name:?}")),
    };
    match options.keys().min() {
        None => Ok(stage),
        Some(unknown) => Err(format!("the world {name} has no option {unknown:?}")),
    }
}

fn file(text: &str, seed: u64) -> Result<PomdpWorld, String> {
    let model = Pomdp::parse(text).map_err(|it| it.to_string())?;
    Ok(PomdpWorld::new(Arc::new(model), seed))
}

fn within(field: &str, value: f64, least: f64, most: f64) -> Result<f64, String> {
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(format!(
            "{field} must be from {least} to {most}, not {value}"
        ))
    }
}

/// The parameters of the Pioneer's room; what they may be its own configuration says.
fn pioneer(take: &mut dyn FnMut(&str, f64) -> f64) -> Result<PioneerConfig, String> {
    let usual = PioneerConfig::NOISY;
    let specimens = within(
        "specimens",
        take("specimens", usual.specimens as f64),
        1.0,
        1000.0,
    )?;
    if specimens.fract() != 0.0 {
        return Err(format!("specimens must be a whole number, not {specimens}"));
    }
    let replaced = take("replaced", 1.0) != 0.0;
    Ok(PioneerConfig {
        radius: take("radius", usual.radius),
        specimens: specimens as usize,
        forward: take("forward", usual.forward),
        backward: take("backward", usual.backward),
        turn: take("turn", usual.turn),
        camera_offset: take("camera_offset", usual.camera_offset),
        camera_range: take("camera_range", usual.camera_range),
        drop_out: take("drop_out", usual.drop_out),
        step_noise: take("step_noise", usual.step_noise),
        turn_noise: take("turn_noise", usual.turn_noise),
        after_capture: if replaced {
            AfterCapture::Replaced
        } else {
            AfterCapture::Removed
        },
    })
}

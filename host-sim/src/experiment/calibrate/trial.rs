//! One condition of the calibration: a controller of the Stage runs drives our robot on their
//! layouts.
//!
//! Measures only; what the numbers mean is said in `compare`.

use cla_core::num::Rng;
use cla_core::word::ItemId;
use serde::{Deserialize, Serialize};

use super::yardstick::{LAYOUTS, RADII, Run, Stage, layout_text, stage_runs};
use crate::baseline::lock::Lock;
use crate::baseline::random::Random;
use crate::baseline::sector::Sector;
use crate::learner::controller::Controller;
use crate::world::camera::SECTORS;
use crate::world::config::PioneerConfig;
use crate::world::layout::Layout;
use crate::world::pioneer::{ACTIONS, FORWARD, Pioneer, PioneerError, S1};
use crate::world::{Percept, World};

/// The forward steps of the Stage runs, metres.
pub const STEPS: [f64; 2] = [0.1, 0.5];
/// Actions after which a run ends.
pub const MOST_ACTIONS: u32 = 3000;

/// A controller that drove Stage, and drives our robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Driver {
    /// The visual servo; see [`Sector`].
    Sector,
    /// The servo with hysteresis; see [`Lock`].
    Lock,
    /// Uniform over the actions; see [`Random`].
    Random,
}

impl Driver {
    /// The name in the Stage data and in claim ids.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sector => "sector",
            Self::Lock => "lock",
            Self::Random => "random",
        }
    }

    fn controller(self, forward: f64) -> Box<dyn Controller> {
        match self {
            Self::Sector => Box::new(Sector::new(forward)),
            Self::Lock => Box::new(Lock::new(forward)),
            Self::Random => Box::new(Random {
                actions: ACTIONS.len() as u32,
            }),
        }
    }
}

/// One condition: a controller in rooms of one radius with one step.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Condition {
    /// The controller.
    pub driver: Driver,
    /// Radius of the rooms, metres.
    pub radius: u32,
    /// Forward step, metres.
    pub forward: f64,
}

impl Condition {
    /// Every radius and step of a controller.
    #[must_use]
    pub fn all(driver: Driver) -> Vec<Self> {
        let of = |radius| {
            STEPS.map(|forward| Self {
                driver,
                radius,
                forward,
            })
        };
        RADII.into_iter().flat_map(of).collect()
    }

    /// As claim ids name it: `R5_f0_5`.
    #[must_use]
    pub fn id(&self) -> String {
        format!("R{}_f{:.1}", self.radius, self.forward).replace('.', "_")
    }
}

/// What was counted in one condition.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    /// The condition.
    pub condition: Condition,
    /// Our runs, one a layout.
    pub ours: Vec<Run>,
    /// Stage 1.3.4's runs on the first of the same layouts; none where it was not run.
    pub stage_1_3_4: Vec<Run>,
    /// Stage 4.3.0's runs on the first of the same layouts.
    pub stage_4_3_0: Vec<Run>,
}

/// Runs one controller in one condition on its ten layouts; the layout's number is the seed.
///
/// # Errors
/// [`PioneerError`] when a radius has no layouts that fit.
pub fn run_row(condition: Condition) -> Result<Row, PioneerError> {
    let Condition {
        driver,
        radius,
        forward,
    } = condition;
    let config = PioneerConfig::stage(f64::from(radius), forward);
    let mut ours = Vec::new();
    for number in 1..=LAYOUTS {
        let text = layout_text(radius, number).unwrap_or_default();
        let layout = Layout::parse(text, config.radius)?;
        let mut world = Pioneer::with_layout(config, &layout, u64::from(number))?;
        let mut rng = Rng::stream(u64::from(number), 3);
        let mut controller = driver.controller(forward);
        ours.push(run(&mut world, controller.as_mut(), &mut rng));
    }
    Ok(Row {
        condition,
        ours,
        stage_1_3_4: stage_runs(Stage::V1_3_4, driver.name(), radius, forward),
        stage_4_3_0: stage_runs(Stage::V4_3_0, driver.name(), radius, forward),
    })
}

/// Lets a controller drive until nothing is left or the actions are used up, and counts.
///
/// The controller sees every sector with a blob, as in the Stage runs.
pub fn run(world: &mut Pioneer, controller: &mut dyn Controller, rng: &mut Rng) -> Run {
    let mut counted = Run::default();
    for action in 1..=MOST_ACTIONS {
        if world.finished() {
            break;
        }
        let before = Sight::of(world);
        let chosen = controller.choose(&before.all, rng);
        world.act(chosen);
        let gripped = world.beam_broken();
        while world.reflex().is_some() {}
        if chosen == FORWARD {
            count_forward(&mut counted, &before, &Sight::of(world), gripped);
        }
        if world.obtained() > counted.captured {
            counted.captured = world.obtained();
            counted.actions_last = action;
        }
    }
    counted.bump_reflexes = world.bump_reflexes();
    counted
}

/// The sectors at one moment: the nearest blob's, and all blobs'.
struct Sight {
    near: Percept,
    all: Percept,
}

impl Sight {
    fn of(world: &Pioneer) -> Self {
        Self {
            near: world.sense(),
            all: world.sense_all_sectors(),
        }
    }
}

fn count_forward(counted: &mut Run, before: &Sight, after: &Sight, gripped: bool) {
    const S2: u16 = S1 + 1;
    const S3: u16 = S1 + 2;
    const S4: u16 = S1 + 3;
    let on = |percept: &Percept, item: u16| percept.get(ItemId(item)) == Some(true);
    if on(&before.near, S3) {
        counted.near[0] += 1;
        for (count, item) in counted.near[1..4].iter_mut().zip([S3, S2, S4]) {
            *count += u32::from(on(&after.near, item));
        }
        counted.near[4] += u32::from(gripped);
    }
    if on(&before.all, S3) {
        let stays = u32::from(on(&after.all, S3));
        counted.any[0] += 1;
        counted.any[1] += stays;
        let others =
            (0..SECTORS as u16).any(|sector| S1 + sector != S3 && on(&before.all, S1 + sector));
        if !others {
            counted.exclusive[0] += 1;
            counted.exclusive[1] += stays;
        }
    }
}

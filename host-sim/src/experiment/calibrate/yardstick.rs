//! The Stage runs and their layouts, embedded in the binary.
//!
//! Source and meaning: `host-sim/data/stage/README.md`.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Radii of the rooms, metres.
pub const RADII: [u32; 3] = [3, 5, 8];
/// Layouts of each radius, numbered from 1.
pub const LAYOUTS: u32 = 10;

const RUNS_1_3_4: &str = include_str!("../../../data/stage/stage-1.3.4.jsonl");
const RUNS_4_3_0: &str = include_str!("../../../data/stage/stage-4.3.0.jsonl");

macro_rules! layouts {
    ($radius:literal) => {
        layouts!($radius: 1 2 3 4 5 6 7 8 9 10)
    };
    ($radius:literal: $($number:literal)*) => {
        [$(include_str!(concat!(
            "../../../data/stage/layouts/R", $radius, "_s", $number, ".txt"
        ))),*]
    };
}

const TEXTS: [[&str; LAYOUTS as usize]; 3] = [layouts!(3), layouts!(5), layouts!(8)];

/// The layout file of a radius and a number from 1 to 10; `None` when there is none.
#[must_use]
pub fn layout_text(radius: u32, number: u32) -> Option<&'static str> {
    let of_radius = RADII.iter().position(|&known| known == radius)?;
    let index = number.checked_sub(1)? as usize;
    TEXTS[of_radius].get(index).copied()
}

/// What was counted in one run, in Stage or in our world.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Run {
    /// Captures of 28.
    pub captured: u32,
    /// How often the bump reflex ran.
    pub bump_reflexes: u32,
    /// Actions until the last capture; 0 without any.
    pub actions_last: u32,
    /// Forward actions that began with the nearest blob in s3; of these after it: in s3, in s2, in
    /// s4, in the grip.
    pub near: [u32; 5],
    /// Forward actions that began with any blob in s3; of these after it: any blob in s3.
    pub any: [u32; 2],
    /// Forward actions that began with s3 as the only sector on; of these after it: s3 still on.
    pub exclusive: [u32; 2],
}

impl Run {
    /// P(s3 stays s3, nearest); `None` when no forward began so.
    #[must_use]
    pub fn p_s3(&self) -> Option<f64> {
        (self.near[0] > 0).then(|| f64::from(self.near[1]) / f64::from(self.near[0]))
    }
}

/// A version of the original simulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Of 2004, the book's era.
    V1_3_4,
    /// Of 2016; another contact model.
    V4_3_0,
}

/// The runs of a Stage version with one controller, radius and step, in the order of the layouts.
#[must_use]
pub fn stage_runs(stage: Stage, controller: &str, radius: u32, forward: f64) -> Vec<Run> {
    let text = match stage {
        Stage::V1_3_4 => RUNS_1_3_4,
        Stage::V4_3_0 => RUNS_4_3_0,
    };
    let number = |value: &Value, key: &str| value[key].as_f64().unwrap_or(f64::NAN);
    text.lines()
        .filter_map(|line| serde_json::from_str::<Value>(line).ok())
        .filter(|run| {
            run["tag"] == controller
                && number(run, "radius") == f64::from(radius)
                && number(run, "forward") == forward
        })
        .map(|run| Run {
            captured: number(&run, "captured") as u32,
            bump_reflexes: number(&run, "reflex_bump") as u32,
            actions_last: number(&run, "acts_last") as u32,
            near: counts(&run["near"]),
            any: counts(&run["any"]),
            exclusive: counts(&run["excl"]),
        })
        .collect()
}

fn counts<const N: usize>(list: &Value) -> [u32; N] {
    core::array::from_fn(|index| list[index].as_u64().unwrap_or(0) as u32)
}

#[cfg(test)]
mod tests {
    use super::{LAYOUTS, RADII, Stage, layout_text, stage_runs};
    use crate::world::layout::Layout;

    #[test]
    fn every_layout_is_there_and_fits_its_room() {
        for radius in RADII {
            for number in 1..=LAYOUTS {
                let text = layout_text(radius, number).unwrap();
                let layout = Layout::parse(text, f64::from(radius)).unwrap();
                assert_eq!(layout.specimens.len(), 28);
            }
        }
        assert_eq!(layout_text(3, 0), None);
        assert_eq!(layout_text(3, 11), None);
        assert_eq!(layout_text(4, 1), None);
    }

    #[test]
    fn the_stage_runs_give_the_medians_of_their_readme() {
        let runs = stage_runs(Stage::V1_3_4, "sector", 5, 0.5);
        let mut actions: Vec<u32> = runs.iter().map(|run| run.actions_last).collect();
        actions.sort_unstable();
        assert_eq!(actions.len(), 10);
        assert_eq!((actions[4] + actions[5]) / 2, 345);
        let kept: u32 = runs.iter().map(|run| run.near[1]).sum();
        let begun: u32 = runs.iter().map(|run| run.near[0]).sum();
        assert!((f64::from(kept) / f64::from(begun) - 0.50).abs() < 0.005);
    }
}

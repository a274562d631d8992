//! The parameters of the Pioneer's world, with their units, ranges and sources.
//!
//! Named sets: the reference world [`NOISY`](PioneerConfig::NOISY), its noise-free twin, and the
//! conditions of the Stage runs.
//! A world is only built from a set that passes [`validate`](PioneerConfig::validate).

use core::fmt;
use serde::{Deserialize, Serialize};

/// What happens to the specimens that the gripper takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum AfterCapture {
    /// They are gone; the run is over when none is left (28 of 28).
    #[serde(alias = "removed")]
    Removed,
    /// They reappear at a random free place, so that captures do not saturate.
    #[serde(alias = "replaced")]
    Replaced,
}

/// Every number of the world that an experiment may vary.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PioneerConfig {
    /// Radius of the round room, metres; 1 to 50, default 5.
    ///
    /// The book does not give it; the Stage runs cover 3, 5 and 8.
    pub radius: f64,
    /// Specimens in a random layout; 1 to 1000, default 28 (book, 6.2.1).
    pub specimens: usize,
    /// Distance of the action `forward`, metres; 0.02 to 2, default 0.5 (ours).
    ///
    /// Book: 0.5 in 6.2.1, 0.1 in Table 6.1; only 0.5 fits the printed reliabilities.
    pub forward: f64,
    /// Distance of the action `backward`, metres; 0.02 to 2, default 0.5 (book, 6.2.1).
    ///
    /// The Stage runs back 0.1.
    pub backward: f64,
    /// Angle of `turnl` and `turnr`, degrees; above 0 to 180, default 5 (book, 6.2.1).
    pub turn: f64,
    /// Direction of the camera, degrees to the left of the heading; −180 to 180, default 0.
    ///
    /// The book's damage knocks it 12° to the left (6.3).
    pub camera_offset: f64,
    /// How far the camera sees, metres; above 0 to 100, default 8 (Stage).
    pub camera_range: f64,
    /// Probability that a blob is missed in one percept; 0 to 1, default 0.17 (ours).
    pub drop_out: f64,
    /// Standard deviation of the distance of a drive, as a share of it; 0 to 1, default 0.03 (ours).
    pub step_noise: f64,
    /// Standard deviation of the angle of a turn, degrees; 0 to 45, default 0.5 (ours).
    pub turn_noise: f64,
    /// What happens to taken specimens; default replaced.
    pub after_capture: AfterCapture,
}

/// A parameter is impossible.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConfigError {
    /// The field, in words.
    pub field: &'static str,
    /// What it was.
    pub value: f64,
    /// The smallest legal value.
    pub least: f64,
    /// The largest legal value.
    pub most: f64,
}

impl fmt::Display for ConfigError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} must be from {} to {}, not {}",
            self.field, self.least, self.most, self.value
        )
    }
}

impl core::error::Error for ConfigError {}

impl PioneerConfig {
    /// The reference world: 5 m, 0.5 m steps, noise in perception and motion, replacement.
    pub const NOISY: Self = Self {
        radius: 5.0,
        specimens: 28,
        forward: 0.5,
        backward: 0.5,
        turn: 5.0,
        camera_offset: 0.0,
        camera_range: 8.0,
        drop_out: 0.17,
        step_noise: 0.03,
        turn_noise: 0.5,
        after_capture: AfterCapture::Replaced,
    };

    /// The noise-free twin of [`NOISY`](Self::NOISY).
    pub const NOISE_FREE: Self = Self {
        drop_out: 0.0,
        step_noise: 0.0,
        turn_noise: 0.0,
        ..Self::NOISY
    };

    /// The conditions of the Stage runs: no noise, removal.
    #[must_use]
    pub const fn stage(radius: f64, forward: f64) -> Self {
        Self {
            radius,
            forward,
            backward: 0.1,
            after_capture: AfterCapture::Removed,
            ..Self::NOISE_FREE
        }
    }

    /// Checks every field.
    ///
    /// # Errors
    /// [`ConfigError`] names the first field that is out of its range (NaN always is).
    pub fn validate(&self) -> Result<(), ConfigError> {
        let tiny = f64::MIN_POSITIVE;
        let fields = [
            ("the room's radius in metres", self.radius, 1.0, 50.0),
            (
                "the number of specimens",
                self.specimens as f64,
                1.0,
                1000.0,
            ),
            ("the forward step in metres", self.forward, 0.02, 2.0),
            ("the backward step in metres", self.backward, 0.02, 2.0),
            ("the turn in degrees", self.turn, tiny, 180.0),
            (
                "the camera's offset in degrees",
                self.camera_offset,
                -180.0,
                180.0,
            ),
            (
                "the camera's range in metres",
                self.camera_range,
                tiny,
                100.0,
            ),
            ("the blob drop-out probability", self.drop_out, 0.0, 1.0),
            ("the step noise as a share", self.step_noise, 0.0, 1.0),
            ("the turn noise in degrees", self.turn_noise, 0.0, 45.0),
        ];
        for (field, value, least, most) in fields {
            if !(least..=most).contains(&value) {
                return Err(ConfigError {
                    field,
                    value,
                    least,
                    most,
                });
            }
        }
        Ok(())
    }
}

impl Default for PioneerConfig {
    fn default() -> Self {
        Self::NOISY
    }
}

#[cfg(test)]
mod tests {
    use super::PioneerConfig;

    #[test]
    fn the_named_worlds_are_legal() {
        for config in [
            PioneerConfig::NOISY,
            PioneerConfig::NOISE_FREE,
            PioneerConfig::stage(3.0, 0.1),
        ] {
            assert_eq!(config.validate(), Ok(()));
        }
    }

    #[test]
    fn nan_and_impossible_values_are_refused_in_one_sentence() {
        let spoil: [fn(&mut PioneerConfig); 5] = [
            |c| c.drop_out = f64::NAN,
            |c| c.step_noise = -0.1,
            |c| c.specimens = 0,
            |c| c.radius = f64::INFINITY,
            |c| c.turn = 0.0,
        ];
        for spoil in spoil {
            let mut config = PioneerConfig::NOISY;
            spoil(&mut config);
            let error = config.validate().unwrap_err();
            assert!(!error.to_string().contains('\n'), "{error}");
        }
        let nan = PioneerConfig {
            turn_noise: f64::NAN,
            ..PioneerConfig::NOISY
        };
        assert_eq!(
            nan.validate().unwrap_err().to_string(),
            "the turn noise in degrees must be from 0 to 45, not NaN"
        );
    }
}

//! What can break in a body: faults that only the world itself can show, because they change its
//! physics.
//!
//! A sensor or a wire can be cut by whoever stands between world and brain
//! ([`damage`](super::damage)); a camera that is turned sees other things, and a wheel that pulls
//! leads elsewhere, so these are asked of the world.

use core::fmt;

/// Something in the body that breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// The camera now looks this many degrees to the left of the heading; −180 to 180 (book, 6.3).
    Camera(f64),
    /// Driving forward one step turns the robot this many degrees to the left; −90 to 90.
    Pull(f64),
    /// The motion of an action, by its index, is done at this share of its length; 0 to 1.
    Weak {
        /// Index of the action.
        action: usize,
        /// What is left of it; 0 is nothing.
        gain: f64,
    },
    /// The wheels spin on the spot in this share of all motions; 0 to 1.
    Slip(f64),
    /// The gripper's beams.
    Beam(Beam),
}

/// What the gripper's beams report.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beam {
    /// What is there.
    #[default]
    Works,
    /// Something, always: dirt on the sensor.
    Blocked,
}

/// A fault that this world cannot have, in one sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unbreakable(pub(crate) String);

impl Unbreakable {
    /// The answer of a world without such a part.
    #[must_use]
    pub fn no_such_part() -> Self {
        Self("this world has no such part that could break".to_owned())
    }
}

impl fmt::Display for Unbreakable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl core::error::Error for Unbreakable {}

/// The faults of the Pioneer's motors and beams; none at first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Faults {
    /// Degrees to the left in one forward step.
    pub(super) pull: f64,
    /// What is left of each action's motion.
    pub(super) gain: [f64; 6],
    /// The share of motions in which the wheels spin on the spot.
    pub(super) slip: f64,
    /// The gripper's beams.
    pub(super) beam: Beam,
}

impl Faults {
    /// A body as it was built.
    pub(super) const NONE: Self = Self {
        pull: 0.0,
        gain: [1.0; 6],
        slip: 0.0,
        beam: Beam::Works,
    };

    /// Adds a fault of motors or beams; the camera is not among them.
    pub(super) fn add(&mut self, fault: &Fault) -> Result<(), Unbreakable> {
        let within = |what: &str, value: f64, least: f64, most: f64| {
            if (least..=most).contains(&value) {
                Ok(value)
            } else {
                let sentence = format!("{what} must be from {least} to {most}, not {value}");
                Err(Unbreakable(sentence))
            }
        };
        match *fault {
            Fault::Pull(degrees) => {
                self.pull = within("the pull in degrees", degrees, -90.0, 90.0)?;
            }
            Fault::Weak { action, gain } => {
                let gain = within("what is left of a motion", gain, 0.0, 1.0)?;
                let slot = self.gain.get_mut(action);
                *slot.ok_or_else(Unbreakable::no_such_part)? = gain;
            }
            Fault::Slip(share) => self.slip = within("the share of slips", share, 0.0, 1.0)?,
            Fault::Beam(beam) => self.beam = beam,
            Fault::Camera(_) => return Err(Unbreakable::no_such_part()),
        }
        Ok(())
    }
}

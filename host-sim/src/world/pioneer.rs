//! The Pioneer: a robot with a gripper and a camera among specimens in a round room (book, 6.1–6.2).
//!
//! Owns what the robot does and senses: six actions in ticks of 0.1 s, gripper beams, bump sensor,
//! five exclusive sectors, two reflexes, and the noise on them.
//! Contacts are the arena's, visibility the camera's; measures are in [`body`](super::body).
//! Calibrated against Stage 1.3.4 (`experiment::calibrate`).

use core::fmt;

use cla_core::num::Rng;
use cla_core::word::{ItemId, ItemStates};

use super::arena::{Arena, Barrier};
use super::body::{
    REFLEX_BACK, TICK_METRES, TICK_SECONDS, breaks_a_beam, corners, may_be_touched,
    may_break_a_beam,
};
use super::camera::{Blob, Camera, SECTORS};
use super::config::{AfterCapture, ConfigError, PioneerConfig};
use super::fault::{Beam, Fault, Faults, Unbreakable};
use super::geometry::{Point, Pose};
use super::layout::{Layout, LayoutError, free_place};
use super::{Percept, World};

/// The names of the Pioneer's primitive items, in the order of their ids.
pub const ITEMS: [&str; 7] = ["s1", "s2", "s3", "s4", "s5", "ingrip", "bump"];
/// The names of the Pioneer's primitive actions, in the order of their indices.
pub const ACTIONS: [&str; 6] = [
    "forward",
    "backward",
    "turnl",
    "turnr",
    "turnaround",
    "grip",
];

/// Index of the item s1; s2 to s5 follow it.
pub const S1: u16 = 0;
/// Index of the item `ingrip`: a specimen breaks a beam of the gripper.
pub const INGRIP: u16 = 5;
/// Index of the item `bump`: a wall refused the last motion.
pub const BUMP: u16 = 6;

/// Index of the action `forward`.
pub const FORWARD: usize = 0;
/// Index of the action `backward`.
pub const BACKWARD: usize = 1;
/// Index of the action `turnl`.
pub const TURN_LEFT: usize = 2;
/// Index of the action `turnr`.
pub const TURN_RIGHT: usize = 3;
/// Index of the action `turnaround`.
pub const TURN_AROUND: usize = 4;
/// Index of the action `grip`: close the gripper and open it again.
pub const GRIP: usize = 5;

/// The largest turn in one tick, degrees: 180° take 2.3 s in the Stage runs.
const TICK_DEGREES: f64 = 8.0;
/// The length of a straight piece in the drive of a robot that pulls to one side, metres.
const PULL_METRES: f64 = 0.05;
/// Ticks of standing still after each action, as in the Stage runs; sliding specimens slide on.
const SETTLING_TICKS: u32 = 3;

/// Why there is no such world.
#[derive(Clone, Debug, PartialEq)]
pub enum PioneerError {
    /// A parameter is impossible.
    Config(ConfigError),
    /// There is no such layout.
    Layout(LayoutError),
}

impl fmt::Display for PioneerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Config(error) => error.fmt(f),
            Self::Layout(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for PioneerError {}

impl From<ConfigError> for PioneerError {
    fn from(error: ConfigError) -> Self {
        Self::Config(error)
    }
}

impl From<LayoutError> for PioneerError {
    fn from(error: LayoutError) -> Self {
        Self::Layout(error)
    }
}

/// The Pioneer in its room.
///
/// ```
/// use host_sim::world::World;
/// use host_sim::world::config::PioneerConfig;
/// use host_sim::world::pioneer::{FORWARD, Pioneer};
/// let mut world = Pioneer::new(PioneerConfig::NOISY, 100)?;
/// world.act(FORWARD);
/// while world.reflex().is_some() {}
/// assert_eq!(world.items().len(), 7);
/// # Ok::<(), host_sim::world::pioneer::PioneerError>(())
/// ```
pub struct Pioneer {
    config: PioneerConfig,
    arena: Arena,
    camera: Camera,
    robot: Pose,
    blobs: Vec<Blob>,
    bumped: bool,
    captures: u32,
    left: usize,
    bump_reflexes: u32,
    faults: Faults,
    /// Whether the gripper has closed since the last action: a blocked beam asks for it once.
    gripped: bool,
    chance: Rng,
}

impl Pioneer {
    /// A world with a random layout; `seed` decides layout and noise.
    ///
    /// # Errors
    /// [`PioneerError`] when a parameter is impossible or the room too small.
    pub fn new(config: PioneerConfig, seed: u64) -> Result<Self, PioneerError> {
        config.validate()?;
        let mut places = Rng::stream(seed, 1);
        let layout = Layout::random(config.radius, config.specimens, &mut places)?;
        Self::with_layout(config, &layout, seed)
    }

    /// A world with a given layout; `seed` decides the noise.
    ///
    /// `config.specimens` is not used: the layout decides.
    ///
    /// # Errors
    /// [`PioneerError`] when a parameter is impossible or the layout is for a larger room.
    pub fn with_layout(
        config: PioneerConfig,
        layout: &Layout,
        seed: u64,
    ) -> Result<Self, PioneerError> {
        config.validate()?;
        layout.check(config.radius)?;
        let mut world = Self {
            arena: Arena::new(config.radius, &layout.specimens),
            camera: Camera::new(config.camera_offset, config.camera_range),
            robot: layout.robot,
            blobs: Vec::with_capacity(layout.specimens.len()),
            bumped: false,
            captures: 0,
            left: layout.specimens.len(),
            bump_reflexes: 0,
            faults: Faults::NONE,
            gripped: false,
            chance: Rng::stream(seed, 2),
            config,
        };
        world.look();
        Ok(world)
    }

    /// The parameters of this world.
    #[must_use]
    pub const fn config(&self) -> &PioneerConfig {
        &self.config
    }

    /// The robot's centre of rotation and heading.
    #[must_use]
    pub const fn robot(&self) -> &Pose {
        &self.robot
    }

    /// The corners of the robot's body.
    #[must_use]
    pub fn body(&self) -> [Point; 4] {
        corners(&self.robot)
    }

    /// Where each specimen is; `None` for one that was taken.
    #[must_use]
    pub fn specimens(&self) -> &[Option<Point>] {
        self.arena.positions()
    }

    /// The blobs of the present percept from left to right, without those that noise hid.
    #[must_use]
    pub fn blobs(&self) -> &[Blob] {
        &self.blobs
    }

    /// The blob that decides the exclusive sector: the nearest, the leftmost of equals.
    #[must_use]
    pub fn nearest_blob(&self) -> Option<&Blob> {
        self.blobs
            .iter()
            .reduce(|best, blob| if blob.range < best.range { blob } else { best })
    }

    /// Whether a beam of the gripper reports something: a specimen, or dirt.
    #[must_use]
    pub fn beam_broken(&self) -> bool {
        self.faults.beam == Beam::Blocked || self.in_beams().is_some()
    }

    /// How often the bump reflex has run.
    #[must_use]
    pub const fn bump_reflexes(&self) -> u32 {
        self.bump_reflexes
    }

    /// Puts up a barrier that neither the camera nor a beam sees.
    pub fn raise(&mut self, barrier: Barrier) {
        self.arena.raise(barrier);
    }

    /// The percept with every sector on that holds a blob, not only the nearest blob's.
    ///
    /// What the controllers of the Stage runs steer by.
    #[must_use]
    pub fn sense_all_sectors(&self) -> Percept {
        self.percept(self.blobs.iter().map(Blob::sector))
    }

    /// Turns the camera on its mount (damage), in degrees to the left; the percept changes at once.
    ///
    /// # Errors
    /// [`ConfigError`] outside −180 to 180 or NaN; nothing has changed.
    pub fn set_camera_offset(&mut self, degrees: f64) -> Result<(), ConfigError> {
        let config = PioneerConfig {
            camera_offset: degrees,
            ..self.config
        };
        config.validate()?;
        self.config = config;
        self.camera.set_offset(degrees);
        self.look();
        Ok(())
    }

    /// A camera that does not say where a blob is says nothing: its items are unknown, not off.
    fn percept(&self, sectors: impl Iterator<Item = Option<usize>>) -> Percept {
        let mut percept = ItemStates::all_off(ITEMS.len() as u16);
        let mut set = |item, state| {
            // Seven items always fit.
            let _ = percept.set(ItemId(item), state);
        };
        for sector in sectors {
            match sector {
                Some(sector) => set(S1 + sector.min(SECTORS - 1) as u16, Some(true)),
                None => {
                    (S1..S1 + SECTORS as u16).for_each(|item| set(item, None));
                    break;
                }
            }
        }
        if self.beam_broken() {
            set(INGRIP, Some(true));
        }
        if self.bumped {
            set(BUMP, Some(true));
        }
        percept
    }

    /// The first specimen that breaks a beam.
    fn in_beams(&self) -> Option<usize> {
        let in_beam = |at: &Point| breaks_a_beam(self.robot.to_local(*at));
        let specimens = self.arena.positions();
        specimens
            .iter()
            .position(|at| at.as_ref().is_some_and(in_beam))
    }

    /// Takes a new picture; each blob is missed with the drop-out probability.
    fn look(&mut self) {
        self.camera
            .look(&self.robot, self.arena.positions(), &mut self.blobs);
        if self.config.drop_out > 0.0 {
            let (chance, miss) = (&mut self.chance, self.config.drop_out as f32);
            self.blobs.retain(|_| !chance.chance(miss));
        }
    }

    /// Drives until the distance is done, a wall refuses a tick or a beam breaks.
    ///
    /// Straight, or, when the robot pulls to one side, in short straight pieces with a turn after
    /// each.
    fn drive(&mut self, metres: f64) {
        let metres = metres * (1.0 + self.config.step_noise * self.normal()).max(0.0);
        if self.slips() {
            return;
        }
        if self.faults.pull == 0.0 {
            self.drive_straight(metres);
            return;
        }
        let pieces = libm::ceil(metres.abs() / PULL_METRES).max(1.0);
        let piece = metres / pieces;
        let turn = (self.faults.pull * piece / self.config.forward).to_radians();
        for _ in 0..pieces as u32 {
            let next = self.robot.turned(turn);
            if !self.drive_straight(piece) || self.arena.body_hits_wall(&next) {
                break;
            }
            self.robot = self.robot.turned(turn);
        }
    }

    /// Whether the wheels spin on the spot this time; draws nothing on wheels that hold.
    fn slips(&mut self) -> bool {
        self.faults.slip > 0.0 && self.chance.chance(self.faults.slip as f32)
    }

    /// Drives straight; whether nothing ended the motion early.
    fn drive_straight(&mut self, metres: f64) -> bool {
        let ticks = libm::ceil(metres.abs() / TICK_METRES - 1e-9).max(1.0);
        let step = metres / ticks;
        let quiet = !self.arena.anything_moves() && !self.any_specimen(metres, may_be_touched);
        let end = self.robot.ahead(metres);
        if quiet
            && self.faults.beam == Beam::Works
            && self.arena.far_from_walls(&self.robot)
            && self.arena.far_from_walls(&end)
            && !self.any_specimen(metres, may_break_a_beam)
        {
            // Nothing can happen on the way.
            self.robot = end;
            return true;
        }
        for _ in 0..ticks as u32 {
            let next = self.robot.ahead(step);
            if self.arena.body_hits_wall(&next) {
                self.bumped = true;
                return false;
            }
            if !quiet {
                self.arena.tick(&self.robot, step / TICK_SECONDS);
            }
            self.robot = next;
            if self.beam_broken() {
                return false;
            }
        }
        true
    }

    fn any_specimen(&self, metres: f64, concerned: fn(Point, f64) -> bool) -> bool {
        let specimens = self.arena.positions().iter().flatten();
        specimens
            .map(|&at| self.robot.to_local(at))
            .any(|local| concerned(local, metres))
    }

    /// Turns on the spot, to the left, until a wall refuses a tick; it kicks nothing.
    ///
    /// A beam that breaks on the way does not end a turn: with a stop in mid-turn the controller
    /// `random` captures almost twice as much as in the Stage runs.
    fn turn(&mut self, degrees: f64) {
        let degrees = degrees + self.config.turn_noise * self.normal();
        if self.slips() {
            return;
        }
        let ticks = libm::ceil(degrees.abs() / TICK_DEGREES).max(1.0);
        let step = (degrees / ticks).to_radians();
        for _ in 0..ticks as u32 {
            let next = self.robot.turned(step);
            if self.arena.body_hits_wall(&next) {
                self.bumped = true;
                break;
            }
            self.robot = next;
            self.wait(1);
        }
    }

    /// Closes the gripper, which swallows what breaks a beam, and opens it.
    fn grip(&mut self) {
        while let Some(taken) = self.in_beams() {
            self.captures += 1;
            self.arena.remove(taken);
            match self.config.after_capture {
                AfterCapture::Removed => self.left -= 1,
                AfterCapture::Replaced => {
                    let others: Vec<Point> =
                        self.arena.positions().iter().flatten().copied().collect();
                    let robot = self.robot.position;
                    let at = free_place(self.config.radius, robot, &others, &mut self.chance);
                    self.arena.place(taken, at);
                }
            }
        }
    }

    /// Lets sliding specimens slide while the robot stands.
    fn wait(&mut self, ticks: u32) {
        for _ in 0..ticks {
            if !self.arena.anything_moves() {
                break;
            }
            self.arena.tick(&self.robot, 0.0);
        }
    }

    /// About standard normal, within ±6: the sum of twelve uniform numbers (Irwin–Hall).
    fn normal(&mut self) -> f64 {
        (0..12).fold(-6.0, |sum, _| sum + f64::from(self.chance.unit()))
    }
}

impl World for Pioneer {
    fn items(&self) -> &'static [&'static str] {
        &ITEMS
    }

    fn actions(&self) -> &'static [&'static str] {
        &ACTIONS
    }

    /// Sectors are exclusive: the nearest blob decides. Noise hides a blob until the next action.
    fn sense(&self) -> Percept {
        self.percept(self.nearest_blob().map(Blob::sector).into_iter())
    }

    /// Does an action; walls end a motion early (`bump`), a broken beam a straight one (`ingrip`).
    ///
    /// An index without an action does nothing, not even a new percept.
    fn act(&mut self, action: usize) {
        if action >= ACTIONS.len() {
            return;
        }
        self.bumped = false;
        self.gripped = false;
        let gain = self.faults.gain.get(action).copied().unwrap_or(0.0);
        match action {
            // A motor without any power does nothing, not even noise.
            _ if gain == 0.0 => {}
            FORWARD => self.drive(gain * self.config.forward),
            BACKWARD => self.drive(-gain * self.config.backward),
            TURN_LEFT => self.turn(gain * self.config.turn),
            TURN_RIGHT => self.turn(-gain * self.config.turn),
            TURN_AROUND => self.turn(gain * 180.0),
            _ => self.grip(),
        }
        self.wait(SETTLING_TICKS);
        self.look();
    }

    /// `ingrip` → grip; else `bump` → back 0.10 m and turn 180°, which ends as a turn around.
    ///
    /// After a reflex `bump` is off, even where the robot is so cornered that it could not move.
    /// A robot whose beam is blocked takes every reflex for a grip, because `ingrip` stays on.
    fn reflex(&mut self) -> Option<usize> {
        let blocked = self.faults.beam == Beam::Blocked;
        let ingrip = self.beam_broken();
        let ends_as = Some(if ingrip { GRIP } else { TURN_AROUND });
        if ingrip && !(blocked && self.gripped) {
            self.gripped = true;
            self.grip();
            if blocked && self.bumped {
                // The bump's reflex is still to come.
                return ends_as;
            }
        } else if self.bumped {
            self.bump_reflexes += 1;
            self.drive(-REFLEX_BACK);
            self.turn(180.0);
        } else {
            return None;
        }
        self.bumped = false;
        self.wait(SETTLING_TICKS);
        self.look();
        ends_as
    }

    fn obtained(&self) -> u32 {
        self.captures
    }

    fn suffer(&mut self, fault: &Fault) -> Result<(), Unbreakable> {
        match *fault {
            Fault::Camera(degrees) => self
                .set_camera_offset(degrees)
                .map_err(|error| Unbreakable(error.to_string())),
            _ => self.faults.add(fault),
        }
    }

    fn finished(&self) -> bool {
        self.left == 0
    }
}

#[cfg(test)]
#[path = "pioneer_tests.rs"]
mod tests;

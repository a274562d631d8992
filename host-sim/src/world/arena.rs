//! The room as rigid bodies: robot, walls and specimens that push each other (rapier2d).
//!
//! The only file that names the physics engine.
//! The target is Stage 1.3.4 (`host-sim/data/stage/README.md`): a moving body kicks a specimen away
//! at twice its speed, specimens never stop the robot, walls refuse a step.
//! It follows from real contacts: the robot is kinematic (infinitely heavy) and perfectly elastic,
//! so a specimen at rest leaves at 2·v along the contact normal; damping takes 5 % a tick.
//! It does not know beams, cameras or actions.

use rapier2d::prelude::{
    ColliderBuilder, Group, InteractionGroups, InteractionTestMode, PhysicsWorld, Pose2,
    QueryFilter, RigidBodyBuilder, RigidBodyHandle, Rot2, SharedShape, Vector,
};

use super::body::{
    BODY_LENGTH, BODY_REACH, BODY_SETBACK, BODY_WIDTH, SPECIMEN_RADIUS, TICK_SECONDS,
};
use super::geometry::{Point, Pose};

/// Straight wall pieces that form the round room; at 5 m its corners lie 3 mm outside the circle.
const WALL_PIECES: u32 = 96;
/// Thickness of a wall, metres: more than a specimen travels or is squeezed in one tick.
const WALL_THICKNESS: f64 = 0.4;
/// Below this speed, in m/s, a specimen rests; 5 % of a kick by the robot at 0.2 m/s.
///
/// A specimen would creep on for ever: it loses a share of its speed, not an amount.
const REST_SPEED: f32 = 0.02;
/// Damping per second that takes 5 % of the speed in a tick of 0.1 s: 1/(1 + 0.1·c) = 0.95.
const DAMPING: f32 = 0.526_316;

const ROBOT: Group = Group::GROUP_1;
const WALL: Group = Group::GROUP_2;
const SPECIMEN: Group = Group::GROUP_3;

/// Thickness of a barrier, metres.
pub const BARRIER_THICKNESS: f64 = 0.1;
/// Half of the longest drive, metres: no point of it is farther from both of its ends.
const HALF_DRIVE: f64 = 1.2;

/// A straight barrier in the room, which stops the robot and nothing else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barrier {
    /// Its centre; it stands across the heading.
    pub pose: Pose,
    /// From one end to the other, metres.
    pub length: f64,
}

/// The bodies in the room and the engine that moves them.
///
/// Where it departs from Stage 1.3.4:
/// - a kick goes along the contact normal, so a corner that grazes a specimen pushes it aside, more
///   slowly;
/// - a resting specimen leaves one tick (2 cm) after the first touch: the engine wakes it first;
/// - a specimen comes to rest below 0.02 m/s, after 0.72 m of Stage's 0.8;
/// - a sliding specimen stops at a wall, takes another one along at half its speed, and bounces off
///   a standing robot;
/// - a specimen under the body after a turn stays there (a turn kicks nothing), and is pushed out by
///   the next tick of the engine.
pub struct Arena {
    physics: PhysicsWorld,
    robot: RigidBodyHandle,
    body: SharedShape,
    specimens: Vec<RigidBodyHandle>,
    positions: Vec<Option<Point>>,
    moving: bool,
    radius: f64,
    barriers: Vec<Barrier>,
}

impl Arena {
    /// A round room of `radius` metres with resting specimens.
    #[must_use]
    pub fn new(radius: f64, specimens: &[Point]) -> Self {
        let mut physics = PhysicsWorld::new();
        physics.gravity = Vector::ZERO;
        physics.integration_parameters.dt = TICK_SECONDS as f32;
        // One substep, so that damping acts once a tick as in Stage.
        physics.integration_parameters.num_solver_iterations = 1;
        // Recycled contacts tolerate 5 cm of motion: here the body would be inside a specimen before
        // the first push, which would then go sideways.
        physics.integration_parameters.contact_recycling = false;

        insert_walls(&mut physics, radius);
        let body = SharedShape::cuboid((0.5 * BODY_LENGTH) as f32, (0.5 * BODY_WIDTH) as f32);
        let (robot, _) = physics.insert(
            RigidBodyBuilder::kinematic_velocity_based(),
            ColliderBuilder::new(body.clone())
                .translation(Vector::new(-BODY_SETBACK as f32, 0.0))
                .friction(0.0)
                .restitution(1.0)
                .restitution_combine_rule(rapier2d::prelude::CoefficientCombineRule::Max)
                .collision_groups(groups(ROBOT, SPECIMEN)),
        );
        let handles = specimens
            .iter()
            .map(|&at| insert_specimen(&mut physics, at))
            .collect();
        // Registers every body and makes the walls known to queries; nothing moves.
        physics.step();
        Self {
            physics,
            robot,
            body,
            specimens: handles,
            positions: specimens.iter().map(|&at| Some(rounded(at))).collect(),
            moving: false,
            radius,
            barriers: Vec::new(),
        }
    }

    /// Puts a barrier up.
    pub fn raise(&mut self, barrier: Barrier) {
        self.physics.insert_collider(
            ColliderBuilder::cuboid(
                (0.5 * BARRIER_THICKNESS) as f32,
                (0.5 * barrier.length) as f32,
            )
            .position(engine_pose(&barrier.pose))
            .collision_groups(groups(WALL, ROBOT)),
            None,
        );
        self.barriers.push(barrier);
        // Makes it known to queries; nothing moves.
        self.physics.step();
    }

    /// Where each specimen is; `None` for one that was taken.
    #[must_use]
    pub fn positions(&self) -> &[Option<Point>] {
        &self.positions
    }

    /// Whether a specimen slides.
    #[must_use]
    pub const fn anything_moves(&self) -> bool {
        self.moving
    }

    /// Whether no heading could bring the robot's body to a wall at `pose`.
    ///
    /// The room is round: between two such poses all are; and a barrier is farther than half a drive.
    #[must_use]
    pub fn far_from_walls(&self, pose: &Pose) -> bool {
        let free = (self.radius - BODY_REACH).max(0.0);
        let far = |barrier: &Barrier| {
            let reach = 0.5 * (barrier.length + BARRIER_THICKNESS) + BODY_REACH + HALF_DRIVE;
            pose.position.distance_squared(barrier.pose.position) > reach * reach
        };
        pose.position.distance_squared(Point::default()) < free * free
            && self.barriers.iter().all(far)
    }

    /// Whether the robot's body would reach into a wall at `pose`.
    #[must_use]
    pub fn body_hits_wall(&self, pose: &Pose) -> bool {
        if self.far_from_walls(pose) {
            return false;
        }
        let centre = pose.ahead(-BODY_SETBACK);
        self.physics
            .intersect_shape(
                engine_pose(&centre),
                &*self.body.0,
                QueryFilter::new().groups(groups(ROBOT, WALL)),
            )
            .next()
            .is_some()
    }

    /// Moves everything on by one tick while the robot drives from `pose` at `speed` m/s.
    pub fn tick(&mut self, pose: &Pose, speed: f64) {
        let (cos, sin) = pose.direction();
        let robot = &mut self.physics.bodies[self.robot];
        robot.set_position(engine_pose(pose), true);
        robot.set_linvel(
            Vector::new((speed * cos) as f32, (speed * sin) as f32),
            true,
        );
        self.physics.step();
        self.read_specimens();
    }

    /// Takes a specimen out of the room; nothing happens when it is not there.
    pub fn remove(&mut self, specimen: usize) {
        let position = self.positions.get_mut(specimen);
        if position.is_some_and(|position| position.take().is_some()) {
            self.physics.remove_body(self.specimens[specimen]);
        }
    }

    /// Puts a specimen to rest at a place; nothing happens when there is no such specimen.
    pub fn place(&mut self, specimen: usize, at: Point) {
        self.remove(specimen);
        if let Some(position) = self.positions.get_mut(specimen) {
            *position = Some(rounded(at));
            self.specimens[specimen] = insert_specimen(&mut self.physics, at);
        }
    }

    /// Copies the specimens' places out of the engine and stops the slow ones.
    ///
    /// A kinematic robot can squeeze a specimen into a wall; such a specimen is put back inside.
    fn read_specimens(&mut self) {
        self.moving = false;
        let limit = self.radius - SPECIMEN_RADIUS;
        for (position, &handle) in self.positions.iter_mut().zip(&self.specimens) {
            let Some(position) = position else { continue };
            let body = &mut self.physics.bodies[handle];
            if body.is_sleeping() {
                continue;
            }
            let at = body.translation();
            let mut now = Point::new(f64::from(at.x), f64::from(at.y));
            let squared = now.distance_squared(Point::default());
            if squared > limit * limit {
                let back = limit / libm::sqrt(squared);
                now = Point::new(now.x * back, now.y * back);
                body.set_translation(Vector::new(now.x as f32, now.y as f32), false);
                body.set_linvel(Vector::ZERO, false);
            }
            *position = now;
            if body.linvel().length_squared() < REST_SPEED * REST_SPEED {
                body.set_linvel(Vector::ZERO, false);
            } else {
                self.moving = true;
            }
        }
    }
}

fn groups(membership: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(membership, filter, InteractionTestMode::And)
}

/// As precise as the engine keeps places, so that a resting specimen never seems to move.
fn rounded(at: Point) -> Point {
    Point::new(f64::from(at.x as f32), f64::from(at.y as f32))
}

fn engine_pose(pose: &Pose) -> Pose2 {
    let (cos, sin) = pose.direction();
    Pose2::from_parts(
        Vector::new(pose.position.x as f32, pose.position.y as f32),
        Rot2 {
            re: cos as f32,
            im: sin as f32,
        },
    )
}

fn insert_walls(physics: &mut PhysicsWorld, radius: f64) {
    let step = core::f64::consts::TAU / f64::from(WALL_PIECES);
    // Half the length of the outer face, so that neighbours leave no gap.
    let half_length = (radius + WALL_THICKNESS) * libm::tan(0.5 * step);
    for piece in 0..WALL_PIECES {
        let outwards = Pose::new(Point::default(), f64::from(piece) * step)
            .ahead(radius + 0.5 * WALL_THICKNESS);
        physics.insert_collider(
            ColliderBuilder::cuboid((0.5 * WALL_THICKNESS) as f32, half_length as f32)
                .position(engine_pose(&outwards))
                .friction(0.0)
                .collision_groups(groups(WALL, ROBOT | SPECIMEN)),
            None,
        );
    }
}

fn insert_specimen(physics: &mut PhysicsWorld, at: Point) -> RigidBodyHandle {
    let (handle, _) = physics.insert(
        RigidBodyBuilder::dynamic()
            .translation(Vector::new(at.x as f32, at.y as f32))
            .linear_damping(DAMPING)
            .lock_rotations()
            .sleeping(true),
        ColliderBuilder::ball(SPECIMEN_RADIUS as f32)
            .friction(0.0)
            .collision_groups(groups(SPECIMEN, ROBOT | WALL | SPECIMEN)),
    );
    // The engine's own threshold is a speed of 0.1 m/s: a quarter of a kick.
    let activation = physics.bodies[handle].activation_mut();
    activation.normalized_linear_threshold = 0.5 * REST_SPEED;
    handle
}

#[cfg(test)]
mod tests {
    use super::super::body::TICK_METRES;
    use super::{Arena, Barrier, Point, Pose, TICK_SECONDS};

    /// Drives `ticks` ticks forward from `pose` and lets everything come to rest.
    fn drive(arena: &mut Arena, mut pose: Pose, ticks: u32) {
        for _ in 0..ticks {
            arena.tick(&pose, TICK_METRES / TICK_SECONDS);
            pose = pose.ahead(TICK_METRES);
        }
        for _ in 0..200 {
            arena.tick(&pose, 0.0);
        }
        assert!(!arena.anything_moves());
    }

    #[test]
    fn a_kicked_specimen_slides_about_four_times_the_speed() {
        let mut arena = Arena::new(5.0, &[Point::new(0.30, 0.0)]);
        drive(&mut arena, Pose::new(Point::default(), 0.0), 10);
        let slid = arena.positions()[0].unwrap().x - 0.30;
        // 4 · 0.2 m/s, less what is left below the speed of rest.
        assert!((0.70..=0.85).contains(&slid), "{slid} m");
    }

    #[test]
    fn an_off_centre_specimen_is_kicked_straight_ahead_by_the_flat_front() {
        let mut arena = Arena::new(5.0, &[Point::new(0.30, 0.15)]);
        drive(&mut arena, Pose::new(Point::default(), 0.0), 10);
        let at = arena.positions()[0].unwrap();
        assert!((at.y - 0.15).abs() < 0.01 && at.x > 0.95, "{at:?}");
    }

    #[test]
    fn a_specimen_beside_the_path_stays() {
        let at = Point::new(0.30, 0.25);
        let mut arena = Arena::new(5.0, &[at]);
        drive(&mut arena, Pose::new(Point::default(), 0.0), 25);
        assert!(arena.positions()[0].unwrap().distance(at) < 1e-6);
    }

    #[test]
    fn a_sliding_specimen_stops_at_the_wall_and_takes_another_one_along() {
        let mut arena = Arena::new(2.0, &[Point::new(1.7, 0.0)]);
        drive(&mut arena, Pose::new(Point::new(1.4, 0.0), 0.0), 8);
        let at = arena.positions()[0].unwrap();
        assert!((1.94..=1.97).contains(&at.x), "{at:?}");

        let mut arena = Arena::new(5.0, &[Point::new(0.3, 0.0), Point::new(0.5, 0.0)]);
        drive(&mut arena, Pose::new(Point::default(), 0.0), 8);
        let [first, second] = [0, 1].map(|index| arena.positions()[index].unwrap().x);
        let gap = second - first;
        assert!(
            (0.07..0.12).contains(&gap) && second > 0.7,
            "{first} {second}"
        );
    }

    #[test]
    fn a_specimen_squeezed_against_the_wall_stays_inside() {
        let mut arena = Arena::new(2.0, &[Point::new(1.9, 0.1)]);
        drive(&mut arena, Pose::new(Point::new(1.6, 0.0), 0.0), 20);
        let at = arena.positions()[0].unwrap();
        assert!(at.distance(Point::default()) <= 1.9601, "{at:?}");
    }

    #[test]
    fn the_body_hits_a_wall_ahead_and_not_free_space() {
        let arena = Arena::new(3.0, &[]);
        let facing = |x: f64| Pose::new(Point::new(x, 0.0), 0.0);
        assert!(!arena.body_hits_wall(&facing(2.80)));
        assert!(arena.body_hits_wall(&facing(2.83)));
        assert!(arena.body_hits_wall(&facing(3.5)));
    }

    #[test]
    fn a_barrier_stops_the_robot_and_no_specimen() {
        let mut arena = Arena::new(5.0, &[Point::new(0.30, 0.0)]);
        arena.raise(Barrier {
            pose: Pose::new(Point::new(0.9, 0.0), 0.0),
            length: 1.0,
        });
        let facing = |x: f64| Pose::new(Point::new(x, 0.0), 0.0);
        assert!(!arena.body_hits_wall(&facing(0.60)));
        assert!(arena.body_hits_wall(&facing(0.75)));
        assert!(!arena.far_from_walls(&facing(0.0)));
        assert!(!arena.body_hits_wall(&facing(1.5)));
        drive(&mut arena, facing(0.0), 10);
        assert!(arena.positions()[0].unwrap().x > 0.95);
    }

    #[test]
    fn a_removed_specimen_is_neither_there_nor_pushed_and_can_come_back() {
        let mut arena = Arena::new(5.0, &[Point::new(0.30, 0.0)]);
        arena.remove(0);
        drive(&mut arena, Pose::new(Point::default(), 0.0), 10);
        assert_eq!(arena.positions()[0], None);
        arena.place(0, Point::new(0.6, 0.0));
        drive(&mut arena, Pose::new(Point::default(), 0.0), 25);
        assert!(arena.positions()[0].unwrap().x > 1.0);
    }
}

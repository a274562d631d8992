//! A room of square fields with obstacles and a dock, and the shortest ways through it.

use std::collections::VecDeque;

use cla_core::num::Rng;

/// Fields along one side.
pub const SIDE: usize = 7;

/// Fields, row by row.
pub const FIELDS: usize = SIDE * SIDE;

/// Fields with obstacles.
const OBSTACLES: usize = 6;

/// A field and a heading: 0 up, 1 right, 2 down, 3 left.
///
/// ```
/// use host_sim::world::vacuum::Pose;
/// let pose = Pose { field: 8, heading: 3 };
/// assert_eq!(pose.turned(1).heading, 0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pose {
    /// Where.
    pub field: usize,
    /// Which way.
    pub heading: usize,
}

impl Pose {
    /// Poses in a room.
    pub(super) const COUNT: usize = FIELDS * 4;

    /// The same field after so many quarter turns to the right.
    #[must_use]
    pub const fn turned(self, quarters: usize) -> Self {
        Self {
            field: self.field,
            heading: (self.heading + quarters) % 4,
        }
    }

    pub(super) const fn index(self) -> usize {
        self.field * 4 + self.heading
    }
}

/// A room.
///
/// ```
/// use host_sim::world::vacuum::{FIELDS, Room};
/// let room = Room::random(&mut cla_core::num::Rng::new(1));
/// assert_eq!((0..FIELDS).filter(|&it| room.is_free(it)).count(), 43);
/// assert_eq!(room.to_dock(room.dock()), 0);
/// ```
#[derive(Clone, Debug)]
pub struct Room {
    free: [bool; FIELDS],
    to_dock: [usize; FIELDS],
}

impl Room {
    /// Obstacles by chance, in such a way that every free field can be reached.
    #[must_use]
    pub fn random(rng: &mut Rng) -> Self {
        loop {
            let mut free = [true; FIELDS];
            let mut left = OBSTACLES;
            while left > 0 {
                let field = rng.below(FIELDS as u32) as usize;
                if field != 0 && free[field] {
                    free[field] = false;
                    left -= 1;
                }
            }
            let room = Self {
                free,
                to_dock: distances(&free),
            };
            if (0..FIELDS).all(|it| !free[it] || room.to_dock[it] < FIELDS) {
                return room;
            }
        }
    }

    /// The field of the dock: a corner.
    #[must_use]
    pub const fn dock(&self) -> usize {
        0
    }

    /// Whether a field has no obstacle.
    #[must_use]
    pub fn is_free(&self, field: usize) -> bool {
        self.free.get(field).is_some_and(|&it| it)
    }

    /// Fields on the shortest way to the dock.
    #[must_use]
    pub fn to_dock(&self, field: usize) -> usize {
        self.to_dock.get(field).map_or(FIELDS, |&it| it)
    }

    /// The field ahead, if nothing stands there.
    #[must_use]
    pub fn ahead(&self, pose: Pose) -> Option<usize> {
        next(pose.field, pose.heading).filter(|&it| self.free[it])
    }

    /// The fields ahead as far as an obstacle, the nearest first.
    pub(super) fn line(&self, pose: Pose) -> impl Iterator<Item = usize> {
        let heading = pose.heading;
        let step = move |&field: &usize| self.ahead(Pose { field, heading });
        core::iter::successors(self.ahead(pose), step)
    }

    /// Actions from a pose to every other, without those that nothing leads to.
    pub(super) fn ways(&self, from: Pose) -> [u32; Pose::COUNT] {
        let mut actions = [u32::MAX; Pose::COUNT];
        actions[from.index()] = 0;
        let mut queue = VecDeque::from([from]);
        while let Some(pose) = queue.pop_front() {
            let ahead = self.ahead(pose).map(|field| Pose { field, ..pose });
            for next in [Some(pose.turned(1)), Some(pose.turned(3)), ahead] {
                if let Some(next) = next.filter(|it| actions[it.index()] == u32::MAX) {
                    actions[next.index()] = actions[pose.index()] + 1;
                    queue.push_back(next);
                }
            }
        }
        actions
    }
}

fn next(field: usize, heading: usize) -> Option<usize> {
    let (row, column) = (field / SIDE, field % SIDE);
    match heading {
        0 if row > 0 => Some(field - SIDE),
        1 if column + 1 < SIDE => Some(field + 1),
        2 if row + 1 < SIDE => Some(field + SIDE),
        3 if column > 0 => Some(field - 1),
        _ => None,
    }
}

fn distances(free: &[bool; FIELDS]) -> [usize; FIELDS] {
    let mut steps = [FIELDS; FIELDS];
    steps[0] = 0;
    let mut queue = VecDeque::from([0]);
    while let Some(field) = queue.pop_front() {
        for heading in 0..4 {
            let to = next(field, heading).filter(|&it| free[it] && steps[it] == FIELDS);
            if let Some(to) = to {
                steps[to] = steps[field] + 1;
                queue.push_back(to);
            }
        }
    }
    steps
}

//! A robot that knows the whole room: where it is, where dirt lies, how long the battery lasts.
//!
//! It goes for the piece of dirt with which it collects two pieces in the fewest actions, and turns
//! back to the dock before it could not reach it any more.
//! What falls next is not known to anybody, so planning further ahead hardly helps.

use super::room::{FIELDS, Pose};
use super::{CHARGE, FULL, Vacuum};

/// The nearest pieces that are compared.
const COMPARED: usize = 5;

/// What getting somewhere takes.
#[derive(Clone, Copy)]
struct Trip {
    to: Pose,
    actions: u32,
}

/// The next action.
///
/// ```
/// use host_sim::learner::rewarded::driven;
/// use host_sim::world::vacuum::{Vacuum, planner};
/// let income = driven(&mut Vacuum::new(1), 1000, planner::action);
/// assert!(income.earned > 150.0);
/// ```
#[must_use]
pub fn action(world: &Vacuum) -> usize {
    let (here, battery) = (world.pose(), world.battery());
    let dock = world.room().dock();
    if here.field == dock && battery + CHARGE <= FULL {
        return 4;
    }
    if world.is_dirty(here.field) && battery > 1 + back(world, here) {
        return 3;
    }
    let trips = nearest(world, here, None);
    let in_reach = trips.iter().filter(|trip| {
        // There, cleaning, and back.
        battery > trip.actions + 1 + back(world, trip.to)
    });
    let both = |trip: &&Trip| {
        let then = nearest(world, trip.to, Some(trip.to.field));
        trip.actions + then.first().map_or(FIELDS as u32, |it| it.actions)
    };
    let target = in_reach.min_by_key(both).map(|trip| trip.to);
    let target = target.or_else(|| trip(&world.room().ways(here), dock).map(|trip| trip.to));
    target.map_or(4, |target| first(world, here, target))
}

/// Actions back to the dock.
fn back(world: &Vacuum, from: Pose) -> u32 {
    let way = trip(&world.room().ways(from), world.room().dock());
    way.map_or(u32::MAX / 4, |trip| trip.actions)
}

/// The shortest way to a field, whatever the heading there.
fn trip(ways: &[u32; Pose::COUNT], field: usize) -> Option<Trip> {
    let poses = (0..4).map(|heading| Pose { field, heading });
    let trips = poses.map(|to| Trip {
        to,
        actions: ways[to.index()],
    });
    let reached = trips.filter(|trip| trip.actions < u32::MAX);
    reached.min_by_key(|trip| trip.actions)
}

/// The trips to the nearest pieces of dirt.
fn nearest(world: &Vacuum, from: Pose, without: Option<usize>) -> Vec<Trip> {
    let ways = world.room().ways(from);
    let dirty = (0..FIELDS).filter(|&it| world.is_dirty(it) && Some(it) != without);
    let mut trips: Vec<Trip> = dirty.filter_map(|it| trip(&ways, it)).collect();
    trips.sort_by_key(|trip| (trip.actions, trip.to.field));
    trips.truncate(COMPARED);
    trips
}

/// The first action of the shortest way.
fn first(world: &Vacuum, here: Pose, target: Pose) -> usize {
    let left = |from: Pose| world.room().ways(from)[target.index()];
    let ahead = world.room().ahead(here);
    let ahead = ahead.map_or(u32::MAX, |field| left(Pose { field, ..here }));
    let turns = [left(here.turned(3)), left(here.turned(1))];
    let costs = [ahead, turns[0], turns[1]];
    (0..3).min_by_key(|&it| costs[it]).unwrap_or(0)
}

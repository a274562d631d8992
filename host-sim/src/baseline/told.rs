//! The servo `sector` that is told what broke: the upper reference of a recovery.
//!
//! It undoes in its head what can be undone: it reads turned or swapped sectors as what they are,
//! steers crossed motors the other way round, and remembers where a blob must be that its dead or
//! stuck sector cannot show.
//! What it cannot undo (a weak motor, a pull, slip) it meets as any servo does, by looking.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use super::sector::Sector;
use crate::failure::Failure;
use crate::learner::Learner;
use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::camera::{FIELD_OF_VIEW, SECTORS};
use crate::world::damage::Damage;
use crate::world::pioneer::{ACTIONS, INGRIP, TURN_LEFT, TURN_RIGHT};

/// A servo on the learner's percept that knows its damage.
#[derive(Clone, Debug)]
pub struct Told {
    servo: Sector,
    damage: Damage,
    rng: Rng,
    /// The sector in which a blob was seen last, and the action since.
    last: (Option<usize>, usize),
    since_capture: u16,
    burst: u16,
}

/// A servo can shuttle for ever between two walls: after so many actions without a capture …
const PATIENCE: u16 = 100;
/// … it does so many random ones, as the brain does.
const BURST: u16 = 10;

impl Told {
    /// A servo for a robot that drives `forward` metres in one action; whole until it is told.
    #[must_use]
    pub fn new(forward: f64, seed: u64) -> Self {
        Self {
            servo: Sector::new(forward),
            damage: Damage::None,
            rng: Rng::stream(seed, 3),
            last: (None, 0),
            since_capture: 0,
            burst: 0,
        }
    }

    /// The sector that a whole camera would report; `None` when there is nothing or no telling.
    fn seen(&self, now: &Percept) -> Option<usize> {
        let on = |index: usize| now.get(ItemId(index as u16)) == Some(true);
        let shifted = |places: i32| {
            let seen = (0..SECTORS).find(|&index| on(index))?;
            let place = seen as i32 - places;
            // Beyond the edge it is farther out than any sector says.
            Some(place.clamp(0, SECTORS as i32 - 1) as usize)
        };
        match self.damage {
            Damage::Camera(degrees) => {
                let places = degrees * SECTORS as f64 / FIELD_OF_VIEW;
                shifted(libm::round(places) as i32)
            }
            Damage::Shift(places) => shifted(places),
            Damage::SwapItems(a, b) => (0..SECTORS).find(|&index| {
                let from = match index {
                    _ if index == a.index => b.index,
                    _ if index == b.index => a.index,
                    _ => index,
                };
                on(from)
            }),
            Damage::Dead(part) | Damage::Stuck(part) if part.index < SECTORS => {
                let others = (0..SECTORS).filter(|&index| index != part.index);
                others.into_iter().find(|&index| on(index)).or_else(|| {
                    // It was in a neighbour or there already, and has not been lost on the other
                    // side: a turn moves it one sector at most.
                    let (place, action) = self.last;
                    let moved = match (place?, action) {
                        (place, TURN_LEFT) => place + 1,
                        (place, TURN_RIGHT) => place.checked_sub(1)?,
                        (place, _) => place,
                    };
                    let near = moved == part.index || place == Some(part.index);
                    near.then_some(part.index)
                })
            }
            _ => (0..SECTORS).find(|&index| on(index)),
        }
    }
}

impl Learner for Told {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        if self.since_capture >= PATIENCE {
            (self.since_capture, self.burst) = (0, BURST);
        }
        if self.burst > 0 {
            self.burst -= 1;
            self.last = (None, 0);
            return Ok(self.rng.below(ACTIONS.len() as u32) as usize);
        }
        let seen = self.seen(now);
        let mut percept = Percept::all_off(SECTORS as u16);
        if let Some(sector) = seen {
            // Where one turn is lost everything lies on the side of the other, the long way round.
            let mirrored = SECTORS - 1 - sector;
            let place = match self.damage {
                Damage::Lost(part) if part.index == TURN_LEFT => sector.max(mirrored),
                Damage::Lost(part) if part.index == TURN_RIGHT => sector.min(mirrored),
                _ => sector,
            };
            percept.set(ItemId(place as u16), Some(true))?;
        }
        let action = self.servo.choose(&percept, &mut self.rng);
        self.last = (seen, action);
        Ok(match self.damage {
            Damage::SwapActions(a, b) if action == a.index => b.index,
            Damage::SwapActions(a, b) if action == b.index => a.index,
            // It looks round the other way, too.
            Damage::Lost(part) if part.index == action && action == TURN_LEFT => {
                self.servo.did(TURN_RIGHT);
                TURN_RIGHT
            }
            _ => action,
        })
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        let captured = now.get(ItemId(INGRIP)) == Some(true);
        self.since_capture = if captured { 0 } else { self.since_capture + 1 };
        Ok(())
    }

    fn observe(&mut self, _: &Percept, _: usize, _: &Percept) -> Result<(), Failure> {
        // A reflex has turned the robot: what was seen is elsewhere.
        self.last.0 = None;
        Ok(())
    }

    fn act(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    fn hear(&mut self, damage: &Damage) {
        self.damage = *damage;
    }
}

#[cfg(test)]
mod tests {
    use super::{Damage, Learner, Percept, Told};
    use crate::world::pioneer::{ACTIONS, FORWARD, ITEMS, TURN_LEFT, TURN_RIGHT};
    use cla_core::word::ItemId;

    fn first(damage: &str, seen: &[&[u16]]) -> usize {
        let mut told = Told::new(0.5, 1);
        told.hear(&Damage::parse(damage, &ITEMS, &ACTIONS).unwrap());
        let mut action = usize::MAX;
        for &sectors in seen {
            let mut percept = Percept::all_off(7);
            for &sector in sectors {
                percept.set(ItemId(sector), Some(true)).unwrap();
            }
            action = told.choose(&percept).unwrap();
        }
        action
    }

    #[test]
    fn what_is_ahead_is_known_in_spite_of_the_damage() {
        for (damage, seen) in [
            ("none", &[&[2][..]][..]),
            ("camera:+12", &[&[3]]),
            ("camera:-12", &[&[1]]),
            ("shift:+1", &[&[3]]),
            ("swap:s3,s5", &[&[4]]),
            // It was in s2, and the turn to the left moved it to where nothing is shown.
            ("dead:s3", &[&[1], &[]]),
            ("stuck:s3", &[&[1, 2], &[2]]),
        ] {
            assert_eq!(first(damage, seen), FORWARD, "{damage}");
        }
        assert_eq!(first("camera:+12", &[&[2]]), TURN_LEFT);
    }

    #[test]
    fn crossed_and_lost_turns_are_steered_around() {
        assert_eq!(first("swap:turnl,turnr", &[&[0]]), TURN_RIGHT);
        assert_eq!(first("lost:turnl", &[&[0]]), TURN_RIGHT);
        assert_eq!(first("lost:turnr", &[&[4]]), TURN_LEFT);
        // Round once and there it is, on the other side: it does not take that for a turn undone.
        assert_eq!(first("lost:turnl", &[&[1], &[0], &[], &[4]]), TURN_RIGHT);
    }

    #[test]
    fn nothing_is_made_up_where_nothing_was_seen() {
        assert_eq!(first("dead:s3", &[&[]]), TURN_LEFT);
        assert_eq!(first("dead:s3", &[&[4], &[]]), TURN_LEFT);
    }
}

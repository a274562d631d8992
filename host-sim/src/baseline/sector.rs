//! The controller `sector`: a visual servo on the five sectors, with a one-action memory.
//!
//! Source: `host-sim/data/stage/README.md`.
//! There it saw every sector with a blob in it (`Pioneer::sense_all_sectors`).
//! On the exclusive percept that learners get it captures half as much again, because the nearest
//! blob never gives way to another: the harder baseline.

use cla_core::num::Rng;
use cla_core::word::ItemId;

use crate::learner::controller::Controller;
use crate::world::Percept;
use crate::world::pioneer::{FORWARD, S1, TURN_LEFT, TURN_RIGHT};

/// Turns in a full circle of 5° each: so long it looks round before it goes elsewhere.
const CIRCLE: u32 = 72;

/// Drives at what is ahead, turns to what is not, searches when nothing is seen.
#[derive(Clone, Debug)]
pub struct Sector {
    last: Option<usize>,
    looked_round: u32,
    search: Search,
    drives: u32,
}

/// The rest of a trip to another place, taken when a look round showed nothing.
#[derive(Clone, Copy, Debug, Default)]
struct Search {
    turns: u32,
    drives: u32,
}

impl Sector {
    /// A servo for a robot that drives `forward` metres in one action.
    ///
    /// Its trips are 1 m long, or a single action for longer steps and for anything that is not a
    /// positive number.
    #[must_use]
    pub fn new(forward: f64) -> Self {
        Self {
            last: None,
            looked_round: 0,
            search: Search::default(),
            // A cast of NaN gives 0, of infinity the largest number.
            drives: (libm::round(1.0 / forward) as u32).clamp(1, 100),
        }
    }

    /// Was made to do another action than it chose.
    pub(super) const fn did(&mut self, action: usize) {
        self.last = Some(action);
    }

    fn steer(&self, percept: &Percept) -> Option<usize> {
        let on = |sector: u16| percept.get(ItemId(S1 + sector)) == Some(true);
        // The order in which the sectors matter, s3 first.
        let towards = [
            (2, FORWARD),
            (1, TURN_LEFT),
            (3, TURN_RIGHT),
            (0, TURN_LEFT),
            (4, TURN_RIGHT),
        ];
        let action = towards.iter().find(|(sector, _)| on(*sector))?.1;
        let undone = match action {
            TURN_LEFT => Some(TURN_RIGHT),
            TURN_RIGHT => Some(TURN_LEFT),
            _ => None,
        };
        // Never undo the last turn: between two blobs that would go on for ever.
        Some(if undone.is_some() && undone == self.last {
            FORWARD
        } else {
            action
        })
    }

    fn look_elsewhere(&mut self, rng: &mut Rng) -> usize {
        if self.search.turns == 0 && self.search.drives == 0 {
            if self.looked_round < CIRCLE {
                self.looked_round += 1;
                return TURN_LEFT;
            }
            self.looked_round = 0;
            self.search = Search {
                turns: rng.below(CIRCLE),
                drives: self.drives,
            };
        }
        if self.search.turns > 0 {
            self.search.turns -= 1;
            TURN_LEFT
        } else {
            self.search.drives -= 1;
            FORWARD
        }
    }
}

impl Controller for Sector {
    fn choose(&mut self, percept: &Percept, rng: &mut Rng) -> usize {
        let action = match self.steer(percept) {
            Some(action) => {
                self.looked_round = 0;
                self.search = Search::default();
                action
            }
            None => self.look_elsewhere(rng),
        };
        self.last = Some(action);
        action
    }
}

#[cfg(test)]
mod tests {
    use super::{CIRCLE, Controller, FORWARD, Sector, TURN_LEFT, TURN_RIGHT};
    use crate::world::Percept;
    use cla_core::num::Rng;
    use cla_core::word::ItemId;

    fn seeing(sectors: &[u16]) -> Percept {
        let mut percept = Percept::all_off(7);
        for &sector in sectors {
            percept.set(ItemId(sector), Some(true)).unwrap();
        }
        percept
    }

    #[test]
    fn what_is_ahead_comes_first_then_the_inner_sectors() {
        let choice = |sectors: &[u16]| Sector::new(0.5).choose(&seeing(sectors), &mut Rng::new(1));
        assert_eq!(choice(&[0, 2, 4]), FORWARD);
        assert_eq!(choice(&[0, 3]), TURN_RIGHT);
        assert_eq!(choice(&[1, 3]), TURN_LEFT);
        assert_eq!(choice(&[0, 4]), TURN_LEFT);
        assert_eq!(choice(&[4]), TURN_RIGHT);
    }

    #[test]
    fn a_turn_is_never_undone() {
        let (mut sector, mut rng) = (Sector::new(0.5), Rng::new(1));
        assert_eq!(sector.choose(&seeing(&[1]), &mut rng), TURN_LEFT);
        assert_eq!(sector.choose(&seeing(&[3]), &mut rng), FORWARD);
        assert_eq!(sector.choose(&seeing(&[3]), &mut rng), TURN_RIGHT);
    }

    #[test]
    fn a_blind_servo_looks_round_once_and_then_drives_a_metre() {
        let (mut sector, mut rng) = (Sector::new(0.5), Rng::new(1));
        let blind = seeing(&[]);
        let actions: Vec<usize> = (0..1000).map(|_| sector.choose(&blind, &mut rng)).collect();
        let circle = CIRCLE as usize;
        assert!(actions[..circle].iter().all(|&action| action == TURN_LEFT));
        let first = actions.iter().position(|&a| a == FORWARD).unwrap();
        assert!(first < 2 * circle);
        assert_eq!(actions[first..first + 3], [FORWARD, FORWARD, TURN_LEFT]);
    }
}

//! A small world for the forager: one specimen, seen in one of five sectors, driven to and gripped.

use std::hint::black_box;

use cla_core::forager::pioneer::{Action, Brain, ITEMS, Item, Percept};

/// Where the specimen is, seen from the robot.
#[derive(Default)]
pub(crate) struct Garden {
    /// 0 the first sector, 4 the last; forward leads to what is in the middle one.
    sector: u8,
    distance: u8,
    holds: bool,
    lives: u32,
}

impl Garden {
    /// One step of a life: sense, choose, act, learn.
    pub(crate) fn tick(&mut self, brain: &mut Brain) {
        let choice = brain.choose(black_box(&self.sense()));
        let choice = choice.expect("a life that has begun");
        self.act(Action::of(choice.action).expect("an action of the forager"));
        let lesson = brain.learn(black_box(&self.sense()));
        black_box(lesson.expect("an action was chosen"));
    }

    fn sense(&self) -> Percept {
        let mut now = Percept::all_off(ITEMS.len() as u16);
        let sectors = [Item::s1, Item::s2, Item::s3, Item::s4, Item::s5];
        for (sector, item) in sectors.into_iter().enumerate() {
            let seen = !self.holds && usize::from(self.sector) == sector;
            now.set(item.id(), Some(seen)).expect("an item it has");
        }
        now.set(Item::ingrip.id(), Some(self.holds))
            .expect("an item it has");
        now
    }

    fn act(&mut self, action: Action) {
        match action {
            Action::forward if self.sector == 2 && self.distance > 0 => self.distance -= 1,
            Action::forward | Action::backward => {
                self.distance = (self.distance + 1).min(5);
            }
            Action::turnl => self.sector = (self.sector + 1).min(4),
            Action::turnr => self.sector = self.sector.saturating_sub(1),
            Action::turnaround => self.sector = 4 - self.sector,
            Action::grip if self.holds => {
                self.lives += 1;
                let place = self.lives.wrapping_mul(2_654_435_761) >> 16;
                *self = Self {
                    sector: (place % 5) as u8,
                    distance: (place / 5 % 6) as u8,
                    holds: false,
                    lives: self.lives,
                };
            }
            Action::grip => self.holds = self.distance == 0,
        }
    }
}

//! A world of one's own, without touching the library: `cargo run -p host-sim --example new_world`.
//!
//! A snail creeps to a leaf and eats it; a touch makes it shrink, a reflex of its own, which its
//! brain is shown as the action that the world says.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::word::ActionId;
use host_sim::failure::Failure;
use host_sim::learner::native::narrowed;
use host_sim::learner::{Learner, live};
use host_sim::world::{Percept, World};
use snail::Item;

cla_core::brain! {
    /// A snail.
    pub mod snail {
        items: [near, at_leaf, touched, fed],
        actions: [creep, shrink, eat],
        values: [fed = 10.0],
        maps: 6 x 6,
        patterns: 48,
        schemas: 160,
        ram: 24_000,
    }
}

/// The index of the action that its reflex ends as.
const SHRINK: usize = 1;

/// A stalk of seven places with a leaf at its end; every ninth action something touches the snail.
#[derive(Default)]
struct Stalk {
    place: u8,
    acted: u32,
    touched: bool,
    fed: bool,
    meals: u32,
}

impl World for Stalk {
    fn items(&self) -> &'static [&'static str] {
        snail::VOCABULARY.items
    }

    fn actions(&self) -> &'static [&'static str] {
        snail::VOCABULARY.actions
    }

    fn sense(&self) -> Percept {
        let mut now = Percept::all_off(4);
        for (item, on) in [
            (Item::near, self.place > 3),
            (Item::at_leaf, self.place == 6),
            (Item::touched, self.touched),
            (Item::fed, self.fed),
        ] {
            now.set(item.id(), Some(on)).expect("four items fit");
        }
        now
    }

    fn act(&mut self, action: usize) {
        self.acted += 1;
        self.fed = action == 2 && self.place == 6;
        self.meals += u32::from(self.fed);
        self.place = match action {
            _ if self.fed => 0,
            0 => (self.place + 1).min(6),
            _ => self.place.saturating_sub(1),
        };
        self.touched = self.acted.is_multiple_of(9);
    }

    /// Touched, it shrinks, and loses a place as if it had chosen to.
    fn reflex(&mut self) -> Option<usize> {
        std::mem::take(&mut self.touched).then(|| {
            (self.place, self.fed) = (self.place.saturating_sub(1), false);
            SHRINK
        })
    }

    fn obtained(&self) -> u32 {
        self.meals
    }
}

/// Its brain, and the reflexes that it was shown.
struct Snail(Box<snail::Brain>, Vec<(Option<bool>, usize)>);

impl Learner for Snail {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        Ok(usize::from(self.0.choose(&narrowed(now))?.action.0))
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.0.learn(&narrowed(now))?;
        Ok(())
    }

    fn observe(&mut self, before: &Percept, by: usize, now: &Percept) -> Result<(), Failure> {
        self.1.push((before.get(Item::touched.id()), by));
        let (before, now) = (narrowed(before), narrowed(now));
        self.0.observe(&before, ActionId(by as u16), &now)?;
        Ok(())
    }
}

fn main() -> Result<(), Failure> {
    let mut stalk = Stalk::default();
    let mut snail = Snail(Box::new(snail::brain()), vec![]);
    snail::be_born(&mut snail.0, AgentConfig::FORAGER, 1)?;
    let young = live(&mut snail, &mut stalk, 4000)?.total();
    snail.0.act(Adaptation::Reliabilities)?;
    let grown = live(&mut snail, &mut stalk, 4000)?.total();
    println!("{young} meals in 4000 actions of training, {grown} in as many after it");
    assert!(grown > 2 * young && grown > 200, "{young} {grown}");
    assert_eq!(snail.1, vec![(Some(true), SHRINK); 8000 / 9]);
    Ok(())
}

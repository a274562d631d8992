//! A bee needs a memory: what one level cannot know, and two can.
//!
//! Two flowers stand at the ends of a passage, and a flower has nectar again only when the other one
//! has been visited.
//! In the passage both ways look the same: whoever does not remember where it came from turns back
//! to the empty flower half of the time.
//! The second level's state is the schema that has just succeeded, which says where the bee was.
//! `cargo run --release -p cla-core --example two_levels`

use std::error::Error;

use cla_core::agent::{Adaptation, AgentConfig};

cla_core::brain! {
    /// A bee between two flowers.
    pub mod bee {
        items: [flower, passage, nectar, petals_red],
        actions: [west, east],
        values: [nectar = 10.0],
        maps: 6 x 6,
        patterns: 32,
        schemas: 64,
        synthetic: 64,
        beliefs: 512,
        ram: 16_000,
    }
}
use bee::{Action, Item, Percept};

/// Where the bee is, and which flower has nectar.
struct Meadow {
    /// 0 the western flower, 1 the passage, 2 the eastern flower.
    place: u8,
    full: u8,
    tasted: bool,
}

impl Meadow {
    fn sense(&self) -> Result<Percept, Box<dyn Error>> {
        let mut now = Percept::all_off(bee::ITEMS.len() as u16);
        for (item, on) in [
            (Item::flower, self.place != 1),
            (Item::passage, self.place == 1),
            (Item::nectar, self.tasted),
            (Item::petals_red, self.place == 2),
        ] {
            now.set(item.id(), Some(on))?;
        }
        Ok(now)
    }

    fn act(&mut self, action: Action) {
        self.place = match action {
            Action::west => self.place.saturating_sub(1),
            Action::east => (self.place + 1).min(2),
        };
        self.tasted = self.place == self.full;
        if self.tasted {
            self.full = 2 - self.full;
        }
    }
}

/// A whole life with that configuration: learns, then acts; returns the nectar of 2000 steps.
fn nectar(config: AgentConfig) -> Result<u32, Box<dyn Error>> {
    let mut brain = bee::brain();
    bee::be_born(&mut brain, config, 7)?;
    let mut meadow = Meadow {
        place: 1,
        full: 0,
        tasted: false,
    };
    let mut nectar = 0;
    for step in 0..8000 {
        if step == 6000 {
            brain.act(Adaptation::Relearning)?;
        }
        let choice = brain.choose(&meadow.sense()?)?;
        meadow.act(Action::of(choice.action).ok_or("not an action of the bee")?);
        brain.learn(&meadow.sense()?)?;
        if step >= 6000 && meadow.tasted {
            nectar += 1;
        }
    }
    Ok(nectar)
}

fn main() -> Result<(), Box<dyn Error>> {
    let one = nectar(AgentConfig::FORAGER)?;
    let two = nectar(AgentConfig::FORAGER_LEVEL2)?;
    println!("nectar in 2000 steps, of at most 1000: level 1 {one}, both levels {two}");
    println!("both levels take {} bytes", bee::RAM);
    assert!(two > one + one / 2, "{two} {one}");
    Ok(())
}

//! A moth learns to fly to a lamp: one brain, from the first step to a policy.
//!
//! It is told what it can see and do and that the lamp is worth having, and nothing else.
//! `cargo run --release -p cla-core --example moth`

use std::error::Error;

use cla_core::agent::{Adaptation, AgentConfig};

cla_core::brain! {
    /// A robot that wants to stand in the light.
    pub mod moth {
        items: [light_left, light_ahead, light_right, at_lamp],
        actions: [left, forward, right],
        values: [at_lamp = 10.0],
        maps: 6 x 6,
        patterns: 32,
        schemas: 128,
        ram: 12_000,
    }
}
use moth::{Action, Item, Percept};

/// A room with one lamp, which is moved when it has been reached.
struct Room {
    /// Where the lamp is: −2 far to the right, 0 ahead, 2 far to the left.
    bearing: i32,
    distance: i32,
    moved: i32,
}

impl Room {
    fn sense(&self) -> Result<Percept, Box<dyn Error>> {
        let mut now = Percept::all_off(moth::ITEMS.len() as u16);
        for (item, on) in [
            (Item::light_left, self.bearing > 0),
            (Item::light_ahead, self.bearing == 0),
            (Item::light_right, self.bearing < 0),
            (Item::at_lamp, self.distance == 0),
        ] {
            now.set(item.id(), Some(on))?;
        }
        Ok(now)
    }

    fn act(&mut self, action: Action) {
        if self.distance == 0 {
            self.moved += 1;
            self.distance = 3 + self.moved % 3;
            self.bearing = self.moved % 5 - 2;
            return;
        }
        match action {
            Action::left => self.bearing = (self.bearing - 1).max(-2),
            Action::right => self.bearing = (self.bearing + 1).min(2),
            Action::forward if self.bearing == 0 => self.distance -= 1,
            Action::forward => {}
        }
    }
}

/// Lives so many steps; returns how often the lamp was reached.
fn live(brain: &mut moth::Brain, room: &mut Room, steps: u32) -> Result<u32, Box<dyn Error>> {
    let mut visits = 0;
    for _ in 0..steps {
        let choice = brain.choose(&room.sense()?)?;
        let action = Action::of(choice.action).ok_or("not an action of the moth")?;
        room.act(action);
        if brain.learn(&room.sense()?)?.reward > 0.0 {
            visits += 1;
        }
    }
    Ok(visits)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut brain = moth::brain();
    moth::be_born(&mut brain, AgentConfig::FORAGER, 42)?;
    let mut room = Room {
        bearing: 1,
        distance: 3,
        moved: 0,
    };
    let exploring = live(&mut brain, &mut room, 2000)?;
    brain.act(Adaptation::Reliabilities)?;
    let acting = live(&mut brain, &mut room, 2000)?;
    println!("a moth's brain takes {} bytes", moth::RAM);
    println!("visits to the lamp in 2000 steps: {exploring} exploring, {acting} acting");
    // Away from the lamp a visit takes five or six steps at best.
    assert!(acting > 250 && acting > 2 * exploring);
    Ok(())
}

//! A world behind a door that does not show which one it is, and what breaks in it in mid-life.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use cla_core::word::ItemId;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::fault::{Fault, Unbreakable};
use host_sim::world::generated::Generated;
use host_sim::world::keys::Keys;
use host_sim::world::lake::{self, Lake};
use host_sim::world::microworld::Microworld;
use host_sim::world::pioneer::Pioneer;
use host_sim::world::pomdp::PomdpWorld;
use host_sim::world::vacuum::Vacuum;
use host_sim::world::{Percept, World};

/// What stands beside the percept: the truth, for whoever watches.
pub(crate) type Facts = Vec<(&'static str, f64)>;

/// A world that a Python object may own.
pub(crate) trait Place: World + Send {
    /// Numbers about it that nobody in it perceives.
    fn facts(&self) -> Facts;

    /// Whether the episode ended because its time was up.
    fn out_of_time(&self) -> bool {
        false
    }
}

impl Place for Pioneer {
    fn facts(&self) -> Facts {
        let robot = self.robot();
        vec![
            ("x", robot.position.x),
            ("y", robot.position.y),
            ("heading", robot.heading()),
            ("captures", f64::from(self.obtained())),
            ("bump_reflexes", f64::from(self.bump_reflexes())),
        ]
    }
}

impl Place for Microworld {
    fn facts(&self) -> Facts {
        let state = self.state();
        vec![
            ("hand_x", f64::from(state.hand_at.x)),
            ("hand_y", f64::from(state.hand_at.y)),
            ("eye_x", f64::from(state.eye_at.x)),
            ("eye_y", f64::from(state.eye_at.y)),
            ("ball_x", f64::from(state.ball_at.x)),
            ("ball_y", f64::from(state.ball_at.y)),
        ]
    }
}

impl Place for PomdpWorld {
    fn facts(&self) -> Facts {
        vec![("state", self.state() as f64)]
    }
}

impl Place for Lake {
    fn facts(&self) -> Facts {
        vec![
            ("field", self.field() as f64),
            ("left", f64::from(self.left())),
        ]
    }

    fn out_of_time(&self) -> bool {
        !lake::is_end(self.field()) && self.left() == 0
    }
}

impl Place for Keys {
    fn facts(&self) -> Facts {
        vec![
            ("cell", self.situation().cell as f64),
            ("shortest", f64::from(self.shortest())),
            ("tries", f64::from(self.tries())),
            ("efficiency", self.efficiency()),
        ]
    }

    fn out_of_time(&self) -> bool {
        let prize = self.items().iter().position(|&name| name == "prize");
        let on = prize.and_then(|it| self.sense().get(cla_core::word::ItemId(it as u16)));
        self.episode_ended() && on != Some(true)
    }
}

impl Place for Vacuum {
    fn facts(&self) -> Facts {
        vec![
            ("field", self.pose().field as f64),
            ("heading", f64::from(self.pose().heading as u8)),
            ("battery", f64::from(self.battery())),
            ("times_carried", f64::from(self.times_carried())),
        ]
    }
}

impl Place for Generated {
    fn facts(&self) -> Facts {
        vec![("state", self.state() as f64)]
    }
}

/// A world that can be damaged as it stands: who wraps it does not own it.
#[derive(Clone)]
struct Shared(Arc<Mutex<Box<dyn Place>>>);

impl Shared {
    fn new(place: impl Place + 'static) -> Self {
        Self(Arc::new(Mutex::new(Box::new(place))))
    }

    /// A world in which something panicked is as far as it came.
    fn open(&self) -> MutexGuard<'_, Box<dyn Place>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl World for Shared {
    fn items(&self) -> &'static [&'static str] {
        self.open().items()
    }

    fn actions(&self) -> &'static [&'static str] {
        self.open().actions()
    }

    /// Without items that have no name, which a generated world has up to the largest of its kind.
    fn sense(&self) -> Percept {
        let place = self.open();
        let (percept, items) = (place.sense(), place.items().len());
        if usize::from(percept.known().len()) <= items {
            return percept;
        }
        let mut named = Percept::UNKNOWN;
        for item in (0..items).map(|index| ItemId(index as u16)) {
            // As many items as a percept has fit another.
            let _ = named.set(item, percept.get(item));
        }
        named
    }

    fn act(&mut self, action: usize) {
        self.open().act(action);
    }

    fn reflex(&mut self) -> Option<usize> {
        self.open().reflex()
    }

    fn obtained(&self) -> u32 {
        self.open().obtained()
    }

    fn finished(&self) -> bool {
        self.open().finished()
    }

    fn earned(&self) -> f64 {
        self.open().earned()
    }

    fn episode_ended(&self) -> bool {
        self.open().episode_ended()
    }

    fn begin_episode(&mut self) {
        self.open().begin_episode();
    }

    fn suffer(&mut self, fault: &Fault) -> Result<(), Unbreakable> {
        self.open().suffer(fault)
    }
}

impl Place for Damaged<Shared> {
    fn facts(&self) -> Facts {
        self.world().open().facts()
    }

    fn out_of_time(&self) -> bool {
        self.world().open().out_of_time()
    }
}

/// A world, how much was done in it, and what will break.
pub(crate) struct Stage {
    world: Shared,
    seed: u64,
    done: u64,
    /// By the number of actions after which they come.
    coming: BTreeMap<u64, Vec<Damage>>,
}

/// What one action has led to.
pub(crate) struct Step {
    /// What was sensed before any reflex.
    pub(crate) felt: Percept,
    /// What the action itself earned.
    pub(crate) reward: f64,
    /// What was earned with the reflexes.
    pub(crate) earned: f64,
    /// Each reflex: what was sensed before, the action it ended as, what was sensed after.
    pub(crate) reflexes: Vec<(Percept, usize, Percept)>,
}

impl Stage {
    /// A world that `seed` has made.
    pub(crate) fn new(place: impl Place + 'static, seed: u64) -> Self {
        Self {
            world: Shared::new(place),
            seed,
            done: 0,
            coming: BTreeMap::new(),
        }
    }

    /// The world, to live in.
    pub(crate) fn world(&mut self) -> &mut dyn World {
        &mut self.world
    }

    /// Its items, actions and percept, for whoever only looks.
    pub(crate) fn look(&self) -> &dyn World {
        &self.world
    }

    /// Numbers about it, with the actions done.
    pub(crate) fn facts(&self) -> Facts {
        let mut facts = self.world.open().facts();
        facts.push(("actions", self.done as f64));
        facts
    }

    /// Whether the episode ended because its time was up.
    pub(crate) fn out_of_time(&self) -> bool {
        self.world.open().out_of_time()
    }

    /// Something will break after so many actions of this life, or now.
    ///
    /// # Errors
    /// A sentence when it is no damage of this world; nothing has changed. What only the body can say,
    /// it says when it breaks.
    pub(crate) fn break_after(&mut self, text: &str, actions: u64) -> Result<(), String> {
        let (items, its_actions) = (self.world.items(), self.world.actions());
        let damage = Damage::parse(text, items, its_actions).map_err(|it| it.to_string())?;
        if actions <= self.done {
            return self.suffer(damage);
        }
        self.coming.entry(actions).or_default().push(damage);
        Ok(())
    }

    fn suffer(&mut self, damage: Damage) -> Result<(), String> {
        let damaged = Damaged::new(self.world.clone(), damage, self.seed);
        self.world = Shared::new(damaged.map_err(|it| it.to_string())?);
        Ok(())
    }

    /// Actions until something breaks; `None` when nothing will.
    pub(crate) fn until_next(&self) -> Option<u64> {
        let (at, _) = self.coming.first_key_value()?;
        Some(at.saturating_sub(self.done))
    }

    /// So many actions were done; what is due breaks.
    ///
    /// # Errors
    /// A sentence when the body has no such part.
    pub(crate) fn pass(&mut self, actions: u64) -> Result<(), String> {
        self.done += actions;
        while let Some(entry) = self.coming.first_entry() {
            if *entry.key() > self.done {
                break;
            }
            for damage in entry.remove() {
                self.suffer(damage)?;
            }
        }
        Ok(())
    }

    /// Does one action, its reflexes, and breaks what is due.
    ///
    /// # Errors
    /// As [`pass`](Self::pass).
    pub(crate) fn step(&mut self, action: usize) -> Result<Step, String> {
        let world = &mut self.world;
        let before = world.earned();
        world.act(action);
        let reward = world.earned() - before;
        let felt = world.sense();
        let mut reflexes = Vec::new();
        loop {
            let before = world.sense();
            let Some(by) = world.reflex() else { break };
            reflexes.push((before, by, world.sense()));
        }
        let earned = world.earned() - before;
        self.pass(1)?;
        Ok(Step {
            felt,
            reward,
            earned,
            reflexes,
        })
    }
}

#[cfg(test)]
mod tests {
    use host_sim::world::config::PioneerConfig;
    use host_sim::world::pioneer::Pioneer;

    use super::Stage;

    fn stage() -> Stage {
        Stage::new(Pioneer::new(PioneerConfig::NOISY, 1).unwrap(), 1)
    }

    #[test]
    fn what_breaks_in_mid_life_breaks_after_so_many_actions() {
        let mut stage = stage();
        stage.break_after("stuck:s1", 3).unwrap();
        let on = |stage: &Stage| stage.look().sense().get(cla_core::word::ItemId(0));
        for done in 1..=3 {
            assert_eq!(stage.until_next(), Some(4 - done));
            // The robot turns on the spot; s1 may be on by itself, but not three times in a row.
            stage.step(2).unwrap();
        }
        assert_eq!((stage.until_next(), on(&stage)), (None, Some(true)));
    }

    #[test]
    fn a_damage_that_cannot_be_leaves_the_world_as_it_was() {
        let mut stage = stage();
        assert!(stage.break_after("dead:s9", 0).is_err());
        assert!(stage.break_after("swap:s1", 0).is_err());
        let before = stage.look().sense();
        stage.break_after("camera:+12", 0).unwrap();
        stage.break_after("dead:ingrip", 0).unwrap();
        assert_eq!(stage.look().items().len(), 7);
        let _ = before;
        assert!(stage.step(0).is_ok());
    }
}

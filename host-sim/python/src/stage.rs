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

/// Damages that a world may have in its life: each lies around all that came before it.
const MOST_DAMAGES: usize = 32;

/// A world, how much was done in it, and what will break.
pub(crate) struct Stage {
    world: Shared,
    seed: u64,
    done: u64,
    /// What has broken, and what will.
    damages: usize,
    /// By the number of actions after which they come.
    coming: BTreeMap<u64, Vec<Damage>>,
}

/// What one action has led to.
pub(crate) struct Step {
    /// What was sensed before any reflex.
    pub(crate) felt: Percept,
    /// What the action has earned, and the reflexes that it led to.
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
            damages: 0,
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
        if self.damages >= MOST_DAMAGES {
            return Err(format!(
                "a world has at most {MOST_DAMAGES} damages; reset makes it anew"
            ));
        }
        if actions <= self.done {
            self.suffer(damage)?;
        } else {
            self.coming.entry(actions).or_default().push(damage);
        }
        self.damages += 1;
        Ok(())
    }

    fn suffer(&mut self, damage: Damage) -> Result<(), String> {
        let damaged = Damaged::new(self.world.clone(), damage, self.seed);
        self.world = Shared::new(damaged.map_err(|it| it.to_string())?);
        Ok(())
    }

    /// An action was done; what is due breaks.
    fn pass(&mut self) -> Result<(), String> {
        self.done += 1;
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
    /// A sentence when the body has no such part.
    pub(crate) fn step(&mut self, action: usize) -> Result<Step, String> {
        let world = &mut self.world;
        let before = world.earned();
        world.act(action);
        let felt = world.sense();
        let mut reflexes = Vec::new();
        loop {
            let before = world.sense();
            let Some(by) = world.reflex() else { break };
            reflexes.push((before, by, world.sense()));
        }
        let earned = world.earned() - before;
        self.pass()?;
        Ok(Step {
            felt,
            earned,
            reflexes,
        })
    }
}

#[cfg(test)]
mod tests {
    use cla_core::word::ItemId;
    use host_sim::world::config::PioneerConfig;
    use host_sim::world::pioneer::Pioneer;

    use super::{MOST_DAMAGES, Stage};

    /// Turns on the spot.
    const TURN: usize = 2;

    fn stage() -> Stage {
        Stage::new(Pioneer::new(PioneerConfig::NOISY, 1).unwrap(), 1)
    }

    fn sensed(stage: &Stage) -> Vec<Option<bool>> {
        let items = 0..stage.look().items().len() as u16;
        let now = stage.look().sense();
        items.map(|item| now.get(ItemId(item))).collect()
    }

    #[test]
    fn what_breaks_in_mid_life_breaks_after_so_many_actions_and_not_before() {
        let (mut whole, mut broken) = (stage(), stage());
        // An item that is off after three turns.
        for _ in 0..3 {
            whole.step(TURN).unwrap();
        }
        let off = sensed(&whole).iter().position(|it| *it == Some(false));
        let off = off.expect("some item is off");
        let name = whole.look().items()[off];
        broken.break_after(&format!("stuck:{name}"), 3).unwrap();
        let mut whole = stage();
        for _ in 1..3 {
            whole.step(TURN).unwrap();
            broken.step(TURN).unwrap();
            assert_eq!(sensed(&whole), sensed(&broken));
        }
        whole.step(TURN).unwrap();
        broken.step(TURN).unwrap();
        assert_eq!(sensed(&whole)[off], Some(false));
        assert_eq!(sensed(&broken)[off], Some(true));
    }

    #[test]
    fn a_damage_that_cannot_be_leaves_the_world_as_it_was() {
        let (mut stage, mut whole) = (stage(), stage());
        for wrong in ["dead:s9", "swap:s1", "camera:", ""] {
            assert!(stage.break_after(wrong, 0).is_err(), "{wrong}");
            assert!(stage.break_after(wrong, 5).is_err(), "{wrong}");
        }
        for action in [TURN, 0, TURN, 1, 0, 0, 0, TURN] {
            let (one, other) = (stage.step(action).unwrap(), whole.step(action).unwrap());
            assert_eq!((one.earned, one.felt), (other.earned, other.felt));
            assert_eq!(sensed(&stage), sensed(&whole));
        }
    }

    #[test]
    fn a_world_breaks_so_often_and_no_more() {
        let mut stage = stage();
        for time in 0..MOST_DAMAGES {
            let later = (time % 2) as u64 * 9;
            stage.break_after("camera:+1", later).unwrap();
        }
        let refused = stage.break_after("dead:s1", 0).unwrap_err();
        assert!(refused.contains("at most 32"), "{refused}");
        assert!(stage.step(0).is_ok());
    }

    #[test]
    fn what_a_reflex_earns_is_earned_by_the_action_that_led_to_it() {
        let (mut stage, mut earned) = (stage(), 0.0);
        for action in [0, 0, 0, TURN, 0, 0, 3].into_iter().cycle().take(3000) {
            earned += stage.step(action).unwrap().earned;
        }
        assert!(earned > 0.0);
        assert_eq!(earned, f64::from(stage.look().obtained()));
    }
}

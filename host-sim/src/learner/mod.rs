//! What learns by doing, whatever it is made of: one trait for the brain and for its rivals.
//!
//! A [`Learner`] sees percepts and says actions; [`live`] is its life in a world, in which reflexes
//! run by themselves and are shown to it.
//! To enter a new learner into an experiment is to write one struct.

#[macro_use]
mod within;

pub mod controller;
pub mod digest;
pub mod folded;
pub mod forager;
pub mod image;
pub mod mind;
pub mod native;
pub mod rewarded;

use crate::device::meter::Load;
use crate::failure::Failure;
use crate::world::damage::Damage;
use crate::world::{Percept, World};
use cla_core::snapshot::Names;
use cla_core::word::Cost;

/// Something that chooses actions and learns from what they lead to.
pub trait Learner {
    /// The index of the next action; reflexes have run, so `now` is what it will be done in.
    ///
    /// # Errors
    /// Whatever keeps it from choosing.
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure>;

    /// The action that was chosen last has led to `now`; reflexes have not run yet.
    ///
    /// # Errors
    /// Whatever keeps it from learning.
    fn learn(&mut self, now: &Percept) -> Result<(), Failure>;

    /// As [`learn`](Self::learn), in a world that gives a reward beside what is sensed: a finite
    /// number, negative for a cost.
    ///
    /// Who learns from valued items alone does not hear it.
    ///
    /// # Errors
    /// Whatever keeps it from learning.
    fn learn_with(&mut self, now: &Percept, _reward: f32) -> Result<(), Failure> {
        self.learn(now)
    }

    /// An episode is over: what comes next does not follow from what was.
    ///
    /// # Errors
    /// Whatever keeps it from learning.
    fn interrupt(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    /// A reflex, which ended as the action with this index, has led from `before` to `after`.
    ///
    /// # Errors
    /// Whatever keeps it from learning.
    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure>;

    /// Training is over: from now on it acts as well as it can, and adapts in its own way.
    ///
    /// # Errors
    /// Whatever keeps it from acting.
    fn act(&mut self) -> Result<(), Failure> {
        Ok(())
    }

    /// What its last step has touched; `None` for who does not count.
    fn cost(&self) -> Option<Cost> {
        None
    }

    /// Is told what broke; whoever learns does not listen.
    fn hear(&mut self, _: &Damage) {}

    /// The reliability of every schema it has tried; none for who has no schemas.
    fn reliabilities(&self) -> Vec<f64> {
        Vec::new()
    }

    /// What a second level has predicted: right predictions and all of them, since its birth.
    fn predictions(&self) -> (u32, u32) {
        (0, 0)
    }

    /// How often it suspected that the world has changed.
    fn alarms(&self) -> u32 {
        0
    }

    /// What its last choice was worth, which was made where `now` was sensed.
    fn worth(&self, _now: &Percept) -> Worth {
        Worth::default()
    }

    /// All that makes its next step what it will be, as an image of `cla_core::snapshot`; `None` for
    /// who has none. `names` are those of its world's items and actions.
    ///
    /// # Errors
    /// When it is not born or is damaged.
    fn image(&self, _: Names) -> Result<Option<Vec<u8>>, Failure> {
        Ok(None)
    }

    /// Goes on from an image; answers its bytes.
    ///
    /// # Errors
    /// When it is no whole image of such a learner, which is as it was then; and for who has none.
    fn go_on_from(&mut self, _: Names, _image: &[u8]) -> Result<u32, Failure> {
        Err("this learner has no image".into())
    }

    /// Why the last choice was made, for people.
    fn reason(&self) -> Thought {
        Thought::default()
    }
}

/// What a choice was worth, in the units of the inherent values.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worth {
    /// What the chosen action was held to be worth; 0 when nothing was compared.
    pub choice: f32,
    /// What habits alone hold the best action to be worth; 0 without habits.
    pub habit: f32,
}

/// The reason of a choice in words and in number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Thought {
    /// The schema that spoke for it in the book's notation, or why none did.
    pub schema: String,
    /// The index of the chosen action.
    pub action: usize,
    /// What it was worth; 0 when nothing was compared.
    pub value: f32,
    /// Whether it suspects that the world has changed.
    pub alarmed: bool,
}

/// What can be watched after every action.
pub type Watch<'a, W> = &'a mut dyn FnMut(&dyn Learner, &W);

/// Actions between two looks at what has been obtained.
pub const STRIDE: u32 = 25;

/// What came of a life.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lived {
    /// What was obtained in each [`STRIDE`] of actions.
    pub obtained: Vec<u32>,
    /// What its worst step would have cost.
    pub load: Load,
}

impl Lived {
    /// All that was obtained.
    #[must_use]
    pub fn total(&self) -> u32 {
        self.obtained.iter().sum()
    }
}

/// Lets a learner do up to `actions` actions.
///
/// Reflexes run in between and are not counted; a rest that is shorter counts like a whole stride.
/// A world that ends early ends the life: the strides that did not begin are not there.
///
/// # Errors
/// Those of the learner; what it has learned until then stays.
pub fn live<W: World>(
    learner: &mut dyn Learner,
    world: &mut W,
    actions: u32,
) -> Result<Lived, Failure> {
    watched(learner, world, actions, &mut |_, _| {})
}

/// As [`live`]; `watch` sees learner and world after each choice, before it is done.
///
/// # Errors
/// Those of the learner.
pub fn watched<W: World>(
    learner: &mut dyn Learner,
    world: &mut W,
    actions: u32,
    watch: Watch<'_, W>,
) -> Result<Lived, Failure> {
    let mut lived = Lived::default();
    let mut before = world.obtained();
    for done in 0..actions {
        if world.finished() {
            break;
        }
        if done % STRIDE == 0 {
            lived.obtained.push(0);
        }
        let action = learner.choose(&world.sense())?;
        watch(learner, world);
        world.act(action);
        learner.learn(&world.sense())?;
        if let Some(cost) = learner.cost() {
            lived.load.note(&cost);
        }
        feel_reflexes(learner, world)?;
        if let Some(stride) = lived.obtained.last_mut() {
            *stride += world.obtained() - before;
        }
        before = world.obtained();
    }
    Ok(lived)
}

fn feel_reflexes<W: World + ?Sized>(
    learner: &mut dyn Learner,
    world: &mut W,
) -> Result<(), Failure> {
    loop {
        let before = world.sense();
        let Some(action) = world.reflex() else {
            return Ok(());
        };
        learner.observe(&before, action, &world.sense())?;
    }
}

#[cfg(test)]
mod tests {
    use cla_core::agent::{Adaptation, AgentConfig};

    use super::forager::Forager;
    use super::{Learner, STRIDE, live};
    use crate::failure::Failure;
    use crate::world::config::{AfterCapture, PioneerConfig};
    use crate::world::pioneer::Pioneer;
    use crate::world::{Percept, World};

    /// A robot that springs back when it has gone ahead twice: its reflexes end as its action 1.
    #[derive(Default)]
    struct Spring {
        ahead: u32,
        sprung: u32,
    }

    impl World for Spring {
        fn items(&self) -> &'static [&'static str] {
            &["tense"]
        }

        fn actions(&self) -> &'static [&'static str] {
            &["ahead", "back"]
        }

        fn sense(&self) -> Percept {
            let mut percept = Percept::all_off(1);
            percept
                .set(cla_core::word::ItemId(0), Some(self.ahead == 2))
                .unwrap();
            percept
        }

        fn act(&mut self, action: usize) {
            self.ahead = if action == 0 { self.ahead + 1 } else { 0 };
        }

        fn reflex(&mut self) -> Option<usize> {
            (self.ahead == 2).then(|| {
                self.ahead = 0;
                self.sprung += 1;
                1
            })
        }

        fn obtained(&self) -> u32 {
            self.sprung
        }
    }

    /// Goes ahead, and writes down what it is shown.
    #[derive(Default)]
    struct Witness(Vec<(Option<bool>, usize, Option<bool>)>);

    impl Learner for Witness {
        fn choose(&mut self, _: &Percept) -> Result<usize, Failure> {
            Ok(0)
        }

        fn learn(&mut self, _: &Percept) -> Result<(), Failure> {
            Ok(())
        }

        fn observe(&mut self, before: &Percept, by: usize, now: &Percept) -> Result<(), Failure> {
            let tense = |percept: &Percept| percept.get(cla_core::word::ItemId(0));
            self.0.push((tense(before), by, tense(now)));
            Ok(())
        }
    }

    #[test]
    fn a_reflex_of_any_robot_is_shown_as_the_action_that_its_world_says() {
        let mut witness = Witness::default();
        let lived = live(&mut witness, &mut Spring::default(), 50).unwrap();
        assert_eq!(witness.0, [(Some(true), 1, Some(false)); 25]);
        // Each second action brought something.
        assert_eq!(lived.obtained, [12, 13]);
    }

    #[test]
    fn a_world_that_ends_early_ends_the_life_and_the_brain_goes_on_in_the_next() {
        let config = PioneerConfig {
            radius: 2.0,
            specimens: 1,
            after_capture: AfterCapture::Removed,
            ..PioneerConfig::NOISY
        };
        let mut forager = Forager::born(AgentConfig::FORAGER, Adaptation::Frozen, 5).unwrap();
        let mut world = Pioneer::new(config, 5).unwrap();
        let lived = live(&mut forager, &mut world, 100_000).unwrap();
        assert!(world.finished());
        assert_eq!(lived.total(), 1);
        let actions = lived.obtained.len() as u32 * STRIDE;
        assert!(actions < 100_000);
        // No action was left without its result: all that was done has been learned.
        let samples = |forager: &Forager| -> u32 {
            let maps = forager.brain().bank().maps();
            maps.iter().map(|map| map.samples()).sum()
        };
        let learned = samples(&forager);
        assert!(learned + STRIDE > actions, "{learned} of {actions}");
        // Nothing happens in a world that has ended, and nothing is lost.
        assert_eq!(live(&mut forager, &mut world, 100).unwrap().total(), 0);
        assert_eq!(samples(&forager), learned);
        let next = &mut Pioneer::new(PioneerConfig::NOISY, 6).unwrap();
        live(&mut forager, next, 500).unwrap();
        assert!(samples(&forager) >= learned + 500);
        forager.act().unwrap();
        assert!(!forager.brain().knowledge().schemas().is_empty());
    }
}

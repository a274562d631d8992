//! Any calls of the book's learner, in any order; after each of them it must be sound.

use arbitrary::Arbitrary;
use cla_core::agent::{Adaptation, Agent, AgentConfig, Audit, Escape, Stage};
use cla_core::choice::HabitConfig;
use cla_core::snapshot::{self, Names, Stored};
use cla_core::som::Prototypes;
use cla_core::word::{ActionId, ItemId};

use super::are_shares;
use super::operations::{Number, Percept, list};
use super::robots::{bytes, floats};
use cla_core::forager::pioneer;

/// A configuration: a named one, with other numbers here and there.
#[derive(Clone, Copy, Debug, Arbitrary)]
struct Tweaked {
    named: u8,
    changed: [Option<(u8, Number)>; 2],
    every: u8,
    run: u8,
}

impl Tweaked {
    fn config(&self) -> AgentConfig {
        let mut it = [
            AgentConfig::BOOK,
            AgentConfig::FORAGER,
            AgentConfig::FORAGER_LEVEL2,
            AgentConfig::RESILIENT,
            AgentConfig::RESILIENT_LEVEL2,
            AgentConfig::RESILIENT_LASTING,
        ][usize::from(self.named % 6)];
        // Often enough that maps are read within a list.
        it.harvest_every = u32::from(self.every % 16);
        it.training_run = u16::from(self.run);
        for (field, Number(number)) in self.changed.iter().flatten() {
            change(&mut it, *field, *number);
        }
        it
    }
}

/// Puts a number in the place of another.
fn change(it: &mut AgentConfig, field: u8, number: f32) {
    let habits = it.habits.get_or_insert(HabitConfig::FORAGER);
    match field % 14 {
        0 => habits.weight = number,
        1 => habits.discount = number,
        2 => habits.lambda = number,
        3 => habits.learning_rate = number,
        4 => habits.doubting_rate = number,
        5 => it.forgetting = number,
        6 => it.greedy_share = number,
        7 => {
            if let Some(surprise) = &mut it.surprise {
                surprise.missing = number;
            }
        }
        8 => {
            if let Some(surprise) = &mut it.surprise {
                surprise.enough = number;
            }
        }
        9 => {
            if let Some(surprise) = &mut it.surprise {
                (surprise.optimism, surprise.doubt) = (number, 3);
            }
        }
        10 => {
            it.escape = Some(Escape {
                after: number as u16,
                burst: 3,
            });
        }
        11 => it.values.discount = number,
        12 => it.values_per_step = number as u16,
        _ => it.habits = None,
    }
}

/// A call.
#[derive(Clone, Copy, Debug, Arbitrary)]
enum Call {
    Begin {
        config: Tweaked,
        values: [(u8, Number); 2],
        seed: u64,
    },
    Choose(Percept),
    Learn(Percept),
    /// A step as a robot takes it, and many of them.
    Steps(Percept, Percept, u8),
    Observe(Percept, u8, Percept),
    Redirect(u8),
    Act(u8),
    Reconfigure(Tweaked),
    Doubt,
    Harvest,
    Value(u8, Number),
    /// Each part looks itself through.
    Audit,
    Resume,
}

/// What must be so after every call.
fn sound<
    const I: usize,
    const W: usize,
    const H: usize,
    const A: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
>(
    agent: &mut Agent<1, I, W, H, A, P, S, Y, B, M>,
    image: &mut Vec<u8>,
    call: &str,
) {
    assert_eq!(agent.audit(), Audit::Sound, "after {call}");
    are_shares(&agent.health());
    image.clear();
    let saved = snapshot::save(agent, Names::UNKNOWN, &mut Growing(image));
    match agent.stage() {
        Stage::Unborn => assert_eq!(saved, Err(snapshot::SaveError::NotBorn)),
        _ => assert!(saved.is_ok(), "{saved:?} after {call}"),
    }
}

/// An image that grows.
pub(super) struct Growing<'a>(pub(super) &'a mut Vec<u8>);

impl snapshot::Sink for Growing<'_> {
    type Error = core::convert::Infallible;

    fn write(&mut self, piece: &[u8]) -> Result<(), Self::Error> {
        self.0.extend_from_slice(piece);
        Ok(())
    }
}

fn follow<
    const I: usize,
    const W: usize,
    const H: usize,
    const A: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
>(
    agent: &mut Agent<1, I, W, H, A, P, S, Y, B, M>,
    call: Call,
    image: &[u8],
) {
    let items = I as u16;
    let now = |it: &Percept| it.states::<1>(items);
    let finite = |it: f32| assert!(it.is_finite(), "{it} of {call:?}");
    match call {
        Call::Begin {
            config,
            values,
            seed,
        } => {
            let values = values.map(|(item, Number(value))| (ItemId(item.into()), value));
            // What cannot be is refused, and the agent is as it was.
            let _ = agent.be_born(config.config(), &values, seed);
        }
        Call::Choose(percept) => {
            if let Ok(choice) = agent.choose(&now(&percept)) {
                assert!(usize::from(choice.action.0) < A);
                finite(choice.value);
            }
        }
        Call::Learn(percept) => {
            if let Ok(lesson) = agent.learn(&now(&percept)) {
                finite(lesson.reward);
            }
        }
        Call::Steps(before, after, times) => {
            for _ in 0..times % 32 {
                let Ok(choice) = agent.choose(&now(&before)) else {
                    return;
                };
                finite(choice.value);
                finite(agent.learn(&now(&after)).expect("it has chosen").reward);
            }
        }
        Call::Observe(before, action, after) => {
            let action = ActionId(action.into());
            if let Ok(lesson) = agent.observe(&now(&before), action, &now(&after)) {
                finite(lesson.reward);
            }
        }
        Call::Redirect(action) => drop(agent.redirect(ActionId(action.into()))),
        Call::Act(how) => {
            let how = [
                Adaptation::Frozen,
                Adaptation::Reliabilities,
                Adaptation::Relearning,
            ][usize::from(how % 3)];
            let _ = agent.act(how);
        }
        Call::Reconfigure(config) => drop(agent.reconfigure(config.config())),
        Call::Doubt => agent.doubt(),
        Call::Harvest => agent.harvest(),
        Call::Value(item, Number(value)) => {
            let _ = agent
                .knowledge_mut()
                .set_inherent_value(ItemId(item.into()), value);
        }
        Call::Audit => {
            for part in 0..=Agent::<1, I, W, H, A, P, S, Y, B, M>::AUDIT_PARTS {
                assert_eq!(agent.audit_part(part), Audit::Sound, "part {part}");
            }
        }
        Call::Resume => {
            // What was saved after the call before.
            if !image.is_empty() {
                let loaded = snapshot::load(agent, Names::UNKNOWN, &mut &*image);
                assert_eq!(loaded, Ok(image.len() as u32));
            }
        }
    }
}

/// All calls; soundness is asked after each of them, or in a large brain after some.
fn live<
    const I: usize,
    const W: usize,
    const H: usize,
    const A: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M: Prototypes<W, H> + Stored,
>(
    agent: &mut Agent<1, I, W, H, A, P, S, Y, B, M>,
    calls: &[Call],
    every: usize,
) {
    let mut image = Vec::new();
    for (index, call) in calls.iter().enumerate() {
        follow(agent, *call, &image);
        if index % every == 0 || index + 1 == calls.len() {
            sound(agent, &mut image, &format!("{call:?}"));
        }
    }
}

/// Tables that are full at once, with maps of floats and of bytes.
pub(super) fn tiny(input: &[u8]) {
    let Some((which, rest)) = input.split_first() else {
        return;
    };
    let calls = list(rest);
    match which % 2 {
        0 => live(&mut floats::brain(), &calls, 1),
        _ => live(&mut bytes::brain(), &calls, 1),
    }
}

/// A whole forager.
pub(super) fn full(input: &[u8]) {
    let mut agent: Box<pioneer::Brain> = Box::default();
    live(&mut *agent, &list(input), 16);
}

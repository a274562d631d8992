//! Any calls of the one learner, in any order; what it says must be numbers, and after each of them it
//! must be sound and worth an image.

use arbitrary::Arbitrary;
use cla_core::forest::{Actions, Doubting, Heard, Mind, MindConfig, Voice};
use cla_core::reason::Reasoning;
use cla_core::snapshot::{self, Audit, Names, SaveError, Stored};
use cla_core::word::{ActionId, ItemId, SignedItems};

use super::agents::Growing;
use super::are_shares;
use super::operations::{Number, Percept, list};
use super::robots::{Mite, moth};
use firmware_example::mind::Forager;

/// A configuration with other numbers here and there.
#[derive(Clone, Copy, Debug, Arbitrary)]
struct Tweaked {
    changed: [Option<(u8, Number)>; 3],
    heard: u8,
    doubts: bool,
    block: u8,
}

impl Tweaked {
    fn config(&self) -> MindConfig {
        let mut it = MindConfig::DEFAULT;
        it.block = u16::from(self.block);
        if !self.doubts {
            it.doubting = Doubting::Never;
        }
        if self.heard > 127 {
            for (bit, voice) in Voice::ALL.into_iter().enumerate() {
                if self.heard >> bit & 1 == 1 {
                    it.heard = it.heard.and(voice);
                } else {
                    it.heard = it.heard.without(voice);
                }
            }
        } else if self.heard > 100 {
            it.heard = Heard::only(Voice::ALL[usize::from(self.heard) % Voice::ALL.len()]);
        }
        for (field, Number(number)) in self.changed.iter().flatten() {
            let place = match field % 22 {
                0 => &mut it.exploring,
                1 => &mut it.exploring_acting,
                2 => &mut it.discount,
                3 => &mut it.lambda,
                4 => &mut it.habit_discount,
                5 => &mut it.habit_lambda,
                6 => &mut it.habit_rate,
                7 => &mut it.replay_rate,
                8 => &mut it.replay_rate_doubting,
                9 => &mut it.kept_doubting,
                10 => &mut it.trying,
                11 => &mut it.trying_acting,
                12 => &mut it.habit_rate_doubting,
                13 => &mut it.model_discount,
                14 => &mut it.remembered,
                15 => &mut it.remembered_doubting,
                16 => &mut it.prior,
                17 => &mut it.felt,
                18 => {
                    it.replayed = *number as u16 % 64;
                    continue;
                }
                19 => {
                    it.spread = *number as u32 % 4096;
                    continue;
                }
                20 => {
                    it.work = *number as u32 % 4096;
                    continue;
                }
                _ => {
                    (it.patience, it.burst) = (*number as u16, 3);
                    continue;
                }
            };
            *place = *number;
        }
        it
    }
}

/// A call.
#[derive(Clone, Copy, Debug, Arbitrary)]
enum Call {
    Begin {
        config: Tweaked,
        values: [Number; 3],
        seed: u64,
    },
    Choose(Percept),
    ChooseAmong(Percept, u32),
    Learn(Percept, Number),
    /// A step as a robot takes it, and many of them.
    Steps(Percept, Percept, u8),
    Observe(Percept, u8, Percept),
    Interrupt,
    Idle(u16),
    Act,
    Pursue(Percept, [(u8, bool); 2], u16),
    GiveUp,
    Value(u8, Number),
    Look(Percept),
    Resume,
}

fn actions(mask: u32) -> Actions {
    let chosen = (0..32_u16).filter(|bit| mask >> bit & 1 == 1);
    chosen.fold(Actions::NONE, |all, bit| all.with(ActionId(bit)))
}

fn follow<
    const I: usize,
    const A: usize,
    const T: usize,
    const L: usize,
    const R: usize,
    const S: usize,
    const K: usize,
    Q: Reasoning<1, I, A>,
>(
    mind: &mut Mind<1, I, A, T, L, R, S, K, Q>,
    call: Call,
) {
    let now = |it: &Percept| it.states::<1>(I as u16);
    let finite = |it: f32| assert!(it.is_finite(), "{it} of {call:?}");
    match call {
        Call::Begin {
            config,
            values,
            seed,
        } => {
            let values = core::array::from_fn(|item| values[item % values.len()].0);
            let _ = mind.be_born(config.config(), values, seed);
        }
        Call::Choose(percept) => {
            if let Ok(choice) = mind.choose(&now(&percept)) {
                assert!(usize::from(choice.action.0) < A);
                finite(choice.value);
            }
        }
        Call::ChooseAmong(percept, mask) => {
            let allowed = actions(mask);
            if let Ok(choice) = mind.choose_among(&now(&percept), allowed) {
                assert!(allowed.contains(choice.action), "{choice:?} of {mask:b}");
                finite(choice.value);
            }
        }
        Call::Learn(percept, Number(reward)) => {
            if let Ok(taught) = mind.learn_with(&now(&percept), reward) {
                finite(taught.reward);
            }
        }
        Call::Steps(before, after, times) => {
            for _ in 0..times % 64 {
                let Ok(choice) = mind.choose(&now(&before)) else {
                    return;
                };
                finite(choice.value);
                finite(mind.learn(&now(&after)).expect("it has chosen").reward);
            }
        }
        Call::Observe(before, action, after) => {
            let action = ActionId(action.into());
            if let Ok(taught) = mind.observe(&now(&before), action, &now(&after)) {
                finite(taught.reward);
            }
        }
        Call::Interrupt => drop(mind.interrupt()),
        Call::Idle(units) => drop(mind.idle(units.into())),
        Call::Act => drop(mind.act()),
        Call::Pursue(percept, items, limit) => {
            let mut goal = SignedItems::EMPTY;
            for (item, on) in items {
                let _ = goal.insert(ItemId(item.into()), on);
            }
            let _ = mind.pursue(goal, limit, &now(&percept));
        }
        Call::GiveUp => mind.give_up(),
        Call::Value(item, Number(value)) => drop(mind.revalue(ItemId(item.into()), value)),
        Call::Look(percept) => {
            let _ = mind.way(&now(&percept));
            let _ = (mind.pursuit(), mind.size(), mind.stuck());
            if let Some(why) = mind.explain() {
                finite(why.value);
            }
            for item in 0..I as u16 {
                finite(mind.relevance(ItemId(item)));
            }
            for action in 0..A as u16 {
                mind.contexts(ActionId(action), |_, value| finite(value));
            }
            for voice in Voice::ALL {
                finite(mind.record(voice).0);
            }
            finite(mind.crowding());
        }
        Call::Resume => {}
    }
}

/// All calls; an image is made after each of them, or in a large mind after some.
fn live<
    const I: usize,
    const A: usize,
    const T: usize,
    const L: usize,
    const R: usize,
    const S: usize,
    const K: usize,
    Q: Reasoning<1, I, A> + Stored,
>(
    mind: &mut Mind<1, I, A, T, L, R, S, K, Q>,
    calls: &[Call],
    every: usize,
) {
    let mut image = Vec::new();
    let mut born = false;
    for (index, call) in calls.iter().enumerate() {
        match call {
            Call::Resume if born => {
                let loaded = snapshot::load(mind, Names::UNKNOWN, &mut &*image);
                assert_eq!(loaded, Ok(image.len() as u32));
            }
            _ => follow(mind, *call),
        }
        if index % every == 0 || index + 1 == calls.len() {
            assert_eq!(mind.audit(), Audit::Sound, "after {call:?}");
            are_shares(&mind.health());
            image.clear();
            match snapshot::save(mind, Names::UNKNOWN, &mut Growing(&mut image)) {
                Ok(_) => born = true,
                Err(SaveError::NotBorn) => assert!(!born),
                Err(refused) => panic!("{refused:?} after {call:?}"),
            }
        }
    }
}

/// Tables that are full at once, without a reason and with one.
pub(super) fn tiny(input: &[u8]) {
    let Some((which, rest)) = input.split_first() else {
        return;
    };
    let calls = list(rest);
    if which % 2 == 0 {
        live(&mut Mite::new(), &calls, 1);
    } else {
        let mut mind = moth::brain();
        live(&mut *mind, &calls, 1);
    }
}

/// The forager's.
pub(super) fn full(input: &[u8]) {
    let mut mind: Box<Forager> = Box::new(Forager::new());
    live(&mut *mind, &list(input), 16);
}

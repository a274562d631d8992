//! What a configuration refuses, and that each voice is heard for itself.

use super::{Heard, MindConfig, Voice};
use crate::check::Config;

#[test]
fn every_number_that_cannot_work_is_named() {
    let good = MindConfig::DEFAULT;
    assert_eq!(good.check(), Ok(()));
    let bad = |change: fn(&mut MindConfig)| {
        let mut config = good;
        change(&mut config);
        config.check().unwrap_err().field
    };
    let fields = [
        bad(|it| it.exploring = 1.1),
        bad(|it| it.exploring_acting = -0.1),
        bad(|it| it.trying = 2.0),
        bad(|it| it.trying_acting = f32::NAN),
        bad(|it| it.lambda = -0.1),
        bad(|it| it.habit_lambda = 1.1),
        bad(|it| it.habit_rate = f32::INFINITY),
        bad(|it| it.habit_rate_doubting = 2.0),
        bad(|it| it.replay_rate = -1.0),
        bad(|it| it.replay_rate_doubting = f32::NAN),
        bad(|it| it.kept_doubting = 1.5),
        bad(|it| it.felt = f32::NAN),
        bad(|it| it.discount = 1.0),
        bad(|it| it.habit_discount = -0.5),
        bad(|it| it.model_discount = 1.0),
        bad(|it| it.remembered = 1.0),
        bad(|it| it.remembered_doubting = f32::INFINITY),
        bad(|it| it.prior = f32::INFINITY),
        bad(|it| it.prior = 0.0),
        bad(|it| it.block = 0),
        bad(|it| it.patience = 0),
        bad(|it| it.heard = Heard::NOBODY),
        bad(|it| it.heard_doubting = Heard::NOBODY),
        bad(|it| it.trials_doubting = -0.5),
        bad(|it| it.doubt_lasts = 0),
    ];
    let named = [
        "exploring",
        "exploring_acting",
        "trying",
        "trying_acting",
        "lambda",
        "habit_lambda",
        "habit_rate",
        "habit_rate_doubting",
        "replay_rate",
        "replay_rate_doubting",
        "kept_doubting",
        "felt",
        "discount",
        "habit_discount",
        "model_discount",
        "remembered",
        "remembered_doubting",
        "prior",
        "prior",
        "block",
        "patience",
        "heard",
        "heard_doubting",
        "trials_doubting",
        "doubt_lasts",
    ];
    for (field, name) in fields.into_iter().zip(named) {
        assert_eq!(field.strip_prefix("MindConfig::"), Some(name));
    }
}

#[test]
fn each_voice_has_its_own_place() {
    for voice in Voice::ALL {
        let only = Heard::only(voice);
        let heard = Voice::ALL.into_iter().filter(|&other| only.contains(other));
        assert_eq!(heard.collect::<std::vec::Vec<_>>(), [voice]);
        assert_eq!(Voice::ALL[voice as usize], voice);
    }
}

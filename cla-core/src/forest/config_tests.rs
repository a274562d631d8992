//! What a configuration refuses, and that each voice is heard for itself.

use super::{Heard, MindConfig, MindConfigError, Voice};

#[test]
fn every_number_that_cannot_work_is_named() {
    let good = MindConfig::DEFAULT;
    assert_eq!(good.check(), Ok(()));
    let bad = [
        (
            MindConfig {
                exploring: 1.1,
                ..good
            },
            MindConfigError::Share,
        ),
        (
            MindConfig {
                trying_acting: f32::NAN,
                ..good
            },
            MindConfigError::Share,
        ),
        (
            MindConfig {
                lambda: -0.1,
                ..good
            },
            MindConfigError::Rate,
        ),
        (
            MindConfig {
                habit_rate_doubting: 2.0,
                ..good
            },
            MindConfigError::Rate,
        ),
        (
            MindConfig {
                felt: f32::NAN,
                ..good
            },
            MindConfigError::Rate,
        ),
        (
            MindConfig {
                discount: 1.0,
                ..good
            },
            MindConfigError::Discount,
        ),
        (
            MindConfig {
                model_discount: -0.5,
                ..good
            },
            MindConfigError::Discount,
        ),
        (
            MindConfig {
                remembered: 1.0,
                ..good
            },
            MindConfigError::Trials,
        ),
        (
            MindConfig {
                prior: f32::INFINITY,
                ..good
            },
            MindConfigError::Trials,
        ),
        (MindConfig { block: 0, ..good }, MindConfigError::NoActions),
        (
            MindConfig {
                patience: 0,
                ..good
            },
            MindConfigError::NoActions,
        ),
        (
            MindConfig {
                heard: Heard::NOBODY,
                ..good
            },
            MindConfigError::Nobody,
        ),
    ];
    for (config, error) in bad {
        assert_eq!(config.check(), Err(error), "{config:?}");
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

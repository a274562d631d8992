//! Whatever is accepted stays finite: numbers at the end of their range, and lives without end.

mod lamp;

use cla_core::choice::InherentValueError;
use cla_core::map::{ActionSomBank, ResultCoding, Sample, TrainingConfig};
use cla_core::num::{Neighbourhood, Rng, Schedule};
use cla_core::snapshot::{self, Names};
use cla_core::som::{BinarySom, DenseSom, Grid, NodeId, SparseStimulus, StimulusError};
use cla_core::som::{quantization_error, topographic_error};
use cla_core::word::{ActionId, ItemId, ItemStates};
use cla_core::{Adaptation, AgentConfig, Level};
use lamp::{Lamp, bytes, floats};

/// A brain is saved only while every number in it is finite.
fn is_sound(brain: &floats::Brain) -> bool {
    snapshot::save(brain, Names::UNKNOWN, &mut 0_u32).is_ok()
}

fn percept(on: &[u16]) -> ItemStates<1> {
    let mut now = ItemStates::all_off(4);
    for &item in on {
        now.set(ItemId(item), Some(true)).unwrap();
    }
    now
}

#[test]
fn a_world_in_which_all_but_one_thing_fails_for_ever_makes_no_infinity() {
    let mut brain = Box::new(floats::brain());
    // With habits a choice of infinite value would be none, and hidden.
    let config = AgentConfig {
        habits: None,
        ..AgentConfig::FORAGER_LEVEL2
    };
    floats::be_born(&mut brain, config, 3).unwrap();
    let mut lamp = Lamp::new(9);
    lamp.live(&mut brain, 3000);
    brain.act(Adaptation::Reliabilities).unwrap();
    // It turns and turns; what it has just done still succeeds, so that level 2 is asked, and nothing
    // else ever does.
    let (left, ahead) = (percept(&[0]), percept(&[1]));
    let mut asked = 0;
    for step in 0..200_000 {
        brain.observe(&left, ActionId(0), &ahead).unwrap();
        let choice = brain.choose(&ahead).unwrap();
        asked += u32::from(choice.level == Some(Level::Two));
        assert!(choice.value.is_finite(), "{step}: {choice:?}");
        brain.learn(&percept(&[0, 1, 2])).unwrap();
        if step % 10_000 == 0 {
            assert!(is_sound(&brain), "{step}");
        }
    }
    assert!(is_sound(&brain) && asked > 10_000, "{asked}");
}

#[test]
fn the_largest_values_that_are_accepted_stay_finite_and_larger_ones_are_refused() {
    let born = |value: f32| {
        let mut brain = Box::new(floats::brain());
        let config = AgentConfig {
            values: cla_core::choice::ValueConfig {
                discount: 0.999_999_94,
                ..AgentConfig::RESILIENT_LEVEL2.values
            },
            ..AgentConfig::RESILIENT_LEVEL2
        };
        let values: Vec<(ItemId, f32)> = (0..4).map(|item| (ItemId(item), value)).collect();
        brain.be_born(config, &values, 3).map(|()| brain)
    };
    for value in [1.1e9, 1e30, f32::MAX, f32::INFINITY, f32::NAN, -1.0] {
        assert!(born(value).is_err(), "{value}");
    }
    let mut brain = born(1e9).unwrap();
    let mut lamp = Lamp::new(9);
    lamp.live(&mut brain, 3000);
    for how in [Adaptation::Reliabilities, Adaptation::Relearning] {
        brain.act(how).unwrap();
        lamp.live(&mut brain, 3000);
    }
    assert!(is_sound(&brain));
    let refused = brain.knowledge_mut().set_inherent_value(ItemId(0), 1e10);
    assert_eq!(refused, Err(InherentValueError::TooLarge));
}

#[test]
fn a_configuration_with_numbers_beyond_all_use_is_refused() {
    let born = |spoil: fn(&mut AgentConfig)| {
        let mut config = AgentConfig::RESILIENT_LEVEL2;
        spoil(&mut config);
        bytes::be_born(&mut bytes::brain(), config, 1).map_err(|it| it.to_string())
    };
    let refused = born(|it| it.training.result_weight = 3.4e38).unwrap_err();
    let sentence = "TrainingConfig::result_weight is huge and must be at least 0 and at most 1e20";
    assert_eq!(refused, sentence);
    assert!(born(|it| it.training.alpha = Schedule::linear(0.1, 1.1, 9).unwrap()).is_err());
    assert!(born(|it| it.training.sigma = Schedule::constant(1e30).unwrap()).is_err());
    assert!(born(|it| it.training.result_weight = 1e20).is_ok());
}

#[test]
fn a_dense_map_refuses_what_no_squared_distance_holds_and_keeps_the_largest_it_takes() {
    let mut som = DenseSom::<7, 7, 3>::new();
    som.randomize(&mut Rng::new(1));
    let near = Neighbourhood::gaussian(2.0, 0.01).unwrap();
    let before = som.clone();
    for bad in [f32::MAX, -f32::MAX, 1.1e15] {
        let refused = som.best_matching_unit(&[0.0, bad, 0.0]);
        assert_eq!(refused, Err(StimulusError::TooLarge { feature: 1 }));
        som.train(&[0.0, bad, 0.0], NodeId(3), 0.5, &near);
    }
    som.train(&[0.0, f32::NAN, 0.0], NodeId(3), 0.5, &near);
    for alpha in [-0.1, 1.1, f32::NAN, f32::INFINITY] {
        som.train(&[0.5; 3], NodeId(3), alpha, &near);
    }
    assert_eq!(som, before);
    for turn in 0..1000 {
        let far = if turn % 2 == 0 { 1e15 } else { -1e15 };
        let best = som.best_matching_unit(&[far; 3]).unwrap();
        som.train(&[far; 3], best.node, 0.9, &near);
    }
    let stimuli = [[1e15; 3], [-1e15; 3], [0.0; 3]];
    assert!(
        quantization_error(&som, stimuli.iter())
            .unwrap()
            .is_finite()
    );
    assert!(topographic_error(&som, stimuli.iter()).unwrap() <= 1.0);
    let refused = StimulusError::TooLarge { feature: 1 }.to_string();
    assert!(refused.contains("1e15"));
}

#[test]
fn a_binary_map_is_not_moved_by_a_rate_that_is_none() {
    let mut som = BinarySom::<4, 4, 3>::new();
    som.randomize(&mut Rng::new(1));
    let before = som.clone();
    let x = SparseStimulus {
        on: &[0b101],
        minus: &[],
        unknown: &[],
    };
    for alpha in [-0.5, 1.5, f32::NAN, f32::INFINITY] {
        som.train(&x, NodeId(5), alpha, &Neighbourhood::winner_only(), |_| {
            true
        });
    }
    assert_eq!(som, before);
    som.train(&x, NodeId(5), 1.0, &Neighbourhood::winner_only(), |_| true);
    let mut distances = Grid::filled(0.0);
    som.squared_distances(&x, &mut Grid::filled(0.0), &mut distances);
    assert_eq!(distances.as_slice()[5], 0.0);
}

#[test]
fn wins_keep_their_shares_however_long_a_map_is_trained() {
    let mut bank = ActionSomBank::<2, 2, 2, 1>::new();
    bank.randomize(&mut Rng::new(8));
    let before = ItemStates::<1>::all_off(2);
    let sample = |item: u16| {
        let mut after = before;
        after.set(ItemId(item), Some(true)).unwrap();
        Sample::new(&before, &after, ResultCoding::EndState, 2)
    };
    let samples = [sample(0), sample(1)];
    for turn in 0..600_000_u32 {
        let often = usize::from(turn % 10 == 0);
        bank.train(ActionId(0), &samples[often], &TrainingConfig::FORAGER);
    }
    let map = &bank.maps()[0];
    let wins: Vec<u32> = map.nodes().map(|node| u32::from(map.wins(node))).collect();
    let all: u32 = wins.iter().sum();
    let most = wins.iter().max().unwrap();
    assert!(all <= 65_535, "{wins:?}");
    let share = f64::from(*most) / f64::from(all);
    assert!((share - 0.9).abs() < 0.01, "{wins:?}");
}

//! Whatever is accepted stays finite: numbers at the end of their range, and lives without end.

mod lamp;

use cla_core::choice::{ChoiceRule, InherentValueError, ValueConfig};
use cla_core::knowledge::{Estimate, KnowledgeBase, PatternId, Reliability, SchemaId, SyntheticId};
use cla_core::layer::overload::{OverloadDetector, Response, TotalActivation};
use cla_core::layer::{Layer, LayerConfig};
use cla_core::level2::Level2Config;
use cla_core::map::{ActionSomBank, ResultCoding, Sample, TrainingConfig};
use cla_core::num::{Neighbourhood, Rng, Schedule};
use cla_core::snapshot::{self, Names};
use cla_core::som::{BestMatch, BinarySom, ByteSom, DenseSom, Grid, NodeId, Prototypes};
use cla_core::som::{SparseStimulus, StimulusError, quantization_error, topographic_error};
use cla_core::word::{ActionId, ItemId, ItemStates, SchemaText, Vocabulary};
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

/// A conjunction that leads to gold, and two that lead to each other.
fn walks() -> KnowledgeBase<1, 8, 8> {
    let words = Vocabulary {
        items: &["here", "there", "gold"],
        actions: &["walk", "leap"],
    };
    let mut it = KnowledgeBase::new();
    it.set_inherent_value(ItemId(2), 1e9).unwrap();
    for text in [
        "+here/walk/+there",
        "+there/walk/+here",
        "+there/leap/+gold",
    ] {
        let text = SchemaText::parse(text, &words).unwrap();
        it.insert(&text, 3, 4).unwrap();
    }
    it
}

fn values_by(discount: f32) -> Vec<f32> {
    let config = ValueConfig {
        discount,
        ..ValueConfig::BOOK
    };
    let mut it = walks();
    it.defer_values(&config);
    it.improve_values::<2>(2, &config);
    it.settle_values::<2>(100, &config);
    let mut said: Vec<f32> = (0..3).map(|item| it.deferred_value(ItemId(item))).collect();
    said.extend((0..it.patterns()).map(|id| it.value(PatternId(id)).unwrap()));
    let here = percept(&[1]);
    said.extend(it.expected_values::<2>(&here, &config).map(|it| it.value));
    for rule in [ChoiceRule::Lexicographic, ChoiceRule::ExpectedValue] {
        said.extend(it.prefer::<2>(&here, rule, &config).map(|it| it.value));
    }
    said
}

/// Values by the other numbers of their configuration, which are compared.
fn chains_by(number: f32) -> Vec<f32> {
    let config = ValueConfig {
        chain_reliability: number,
        chain_relevance: number,
        ..ValueConfig::BOOK
    };
    let mut it = walks();
    it.defer_values(&config);
    (0..3).map(|item| it.deferred_value(ItemId(item))).collect()
}

fn reliabilities_by(forgetting: f32) -> Vec<f32> {
    let mut said = Vec::new();
    let mut it = Reliability::from_counts(1, 3);
    let mut table = walks();
    let (here, there, nowhere) = (percept(&[0]), percept(&[1]), percept(&[]));
    for trial in 0..50 {
        let success = trial % 3 == 0;
        it.record(success, forgetting);
        let after = if success { &there } else { &nowhere };
        table.record(&here, ActionId(0), after, forgetting);
        for estimate in [Estimate::Plain, Estimate::Recent] {
            let schemas = table.schemas().iter();
            said.extend(schemas.map(|schema| schema.reliability.value(estimate)));
            said.extend([it.value(estimate), table.mean_reliability(estimate)]);
        }
    }
    said
}

fn beliefs_by(prior: f32) -> Vec<f32> {
    let mut brain = Box::new(floats::brain());
    floats::be_born(&mut brain, AgentConfig::FORAGER_LEVEL2, 3).unwrap();
    Lamp::new(9).live(&mut brain, 700);
    let config = Level2Config {
        prior,
        ..Level2Config::FORAGER
    };
    let (level, known) = (brain.second_level(), brain.knowledge());
    let mut said = Vec::new();
    // Two of these traces are none, and nothing was tried after them.
    for trace in (0..14).map(SyntheticId) {
        for schema in (0..known.schemas().len() as u16).map(SchemaId) {
            said.push(level.belief(known, trace, schema, &ValueConfig::FORAGER, &config));
        }
    }
    said
}

fn maps_by(result_weight: f32) -> Vec<f32> {
    let (one, other) = (percept(&[0]), percept(&[1, 2, 3]));
    let samples = [
        Sample::new(&one, &other, ResultCoding::EndState, 4),
        Sample::new(&other, &one, ResultCoding::Change, 4),
    ];
    let mut said = Vec::new();
    for config in [TrainingConfig::BOOK, TrainingConfig::FORAGER] {
        let config = TrainingConfig {
            result_weight,
            ..config
        };
        let mut bank = ActionSomBank::<2, 2, 4, 1>::new();
        bank.randomize(&mut Rng::new(8));
        for turn in 0..20 {
            let _ = bank.train(ActionId(0), &samples[turn % 2], &config);
            said.extend(bank.last_distances().as_slice());
            let _ = bank.train_node(ActionId(0), &samples[0], &config);
            said.extend(bank.last_distances().as_slice());
        }
        let map = &bank.maps()[0];
        for node in map.nodes() {
            said.extend((0..4).map(|item| map.result_weight(node, item)));
        }
    }
    said
}

fn distances_by<M: Prototypes<2, 2>>(factor: f32) -> Vec<f32> {
    let mut map = M::ZERO;
    map.randomize(&mut Rng::new(1));
    let mut distances = Grid::filled(0.0);
    let few = SparseStimulus {
        on: &[0b101],
        minus: &[],
        unknown: &[],
    };
    let any = SparseStimulus {
        on: &[0b1],
        minus: &[0b10],
        unknown: &[0b100],
    };
    for stimulus in [few, any] {
        let mut scratch = Grid::filled(0.0);
        map.add_squared_distances(&stimulus, factor, &mut scratch, &mut distances);
    }
    distances.as_slice().to_vec()
}

/// A layer is made by what works, and there is none by what does not.
fn layers_by(alpha: f32) -> Vec<f32> {
    let width = Schedule::constant(1.0).unwrap();
    let Ok(alpha) = Schedule::constant(alpha) else {
        return Vec::new();
    };
    let Ok(config) = LayerConfig::try_new(0.5, alpha, width) else {
        return Vec::new();
    };
    let mut layer = Layer::<2, 2, 1>::new();
    layer.start(&config, &mut Rng::new(1));
    for turn in 0..20 {
        layer
            .activate(&[if turn % 2 == 0 { 0.0 } else { 9.0 }])
            .unwrap();
        layer.train(turn);
    }
    layer.activation().as_slice().to_vec()
}

fn strains_by(number: f32) -> Vec<f32> {
    let response = |total_activation| Response {
        best_match: BestMatch {
            node: NodeId(0),
            squared_distance: 0.0,
        },
        total_activation,
    };
    let mut said = Vec::new();
    for normal in [number, 0.5] {
        let mut detector = TotalActivation::new();
        detector.record(&response(normal));
        said.extend(detector.minimum());
        for total in [number, 0.0, 1e-30, 2.0] {
            said.push(detector.strain(&response(total)));
        }
    }
    said
}

#[test]
fn whatever_number_is_handed_to_what_checks_none_all_that_is_read_is_finite() {
    /// What it is, all that can be read afterwards, and at most what that is.
    type Row = (&'static str, fn(f32) -> Vec<f32>, f32);
    let rows: [Row; 9] = [
        ("a discount", values_by, 1e20),
        ("what a chain asks", chains_by, 1e9),
        ("forgetting", reliabilities_by, 1.0),
        ("a prior", beliefs_by, 1.0),
        ("the weight of results", maps_by, f32::MAX),
        ("a factor", distances_by::<BinarySom<2, 2, 4>>, f32::MAX),
        (
            "a factor for bytes",
            distances_by::<ByteSom<2, 2, 4>>,
            f32::MAX,
        ),
        ("a learning rate", layers_by, 1.0),
        ("a total activation", strains_by, f32::MAX),
    ];
    let numbers = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        -1.0,
        0.0,
        0.5,
        1e30,
        f32::MAX,
    ];
    for (what, read, most) in rows {
        for number in numbers {
            let said = read(number);
            let within = said.iter().all(|it| (-most..=most).contains(it));
            assert!(within, "{what} of {number:e}: {said:?}");
            // A change may be one downwards; nothing else is below 0.
            let signed = what == "the weight of results";
            assert!(
                signed || said.iter().all(|it| *it >= 0.0),
                "{what}: {said:?}"
            );
        }
        assert!(!read(0.5).is_empty(), "{what}");
    }
}

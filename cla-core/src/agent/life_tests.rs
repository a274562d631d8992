//! Tests of the agent's life.

use super::{Adaptation, AgentError, Reason, Stage};
use crate::agent::{AgentConfig, Escape, Level};
use crate::check::Range;
use crate::choice::ChoiceRule;
use crate::level2::{Fallback, Level2Config};
use crate::word::{ActionId, ItemId, ItemStates, Vocabulary};
use std::boxed::Box;

const GOLD: [(ItemId, f32); 1] = [(ItemId(3), 10.0)];

/// A corridor of four cells; the last one holds what is valuable and leads back to the first.
type Walker = super::Agent<1, 4, 6, 6, 2, 64, 256, 0, 0>;

const WORDS: Vocabulary = Vocabulary {
    items: &["a", "b", "c", "gold"],
    actions: &["on", "back"],
};

struct Corridor(u16);

impl Corridor {
    fn sense(&self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(4);
        now.set(ItemId(self.0), Some(true)).unwrap();
        now
    }

    fn act(&mut self, action: ActionId) {
        self.0 = match action {
            _ if self.0 == 3 => 0,
            ActionId(0) => self.0 + 1,
            _ => self.0.saturating_sub(1),
        };
    }
}

fn walker(config: AgentConfig, seed: u64) -> Box<Walker> {
    let mut agent = Box::new(Walker::new());
    agent.be_born(config, &[(ItemId(3), 10.0)], seed).unwrap();
    agent
}

/// Lives for `steps`; returns how often the valuable cell was reached.
fn live(agent: &mut Walker, world: &mut Corridor, steps: u32) -> u32 {
    let mut rewards = 0;
    for _ in 0..steps {
        let choice = agent.choose(&world.sense()).unwrap();
        world.act(choice.action);
        let lesson = agent.learn(&world.sense()).unwrap();
        rewards += u32::from(lesson.reward > 0.0);
    }
    rewards
}

#[test]
fn both_rules_learn_the_shortest_way_of_a_certain_world() {
    for rule in [ChoiceRule::Lexicographic, ChoiceRule::ExpectedValue] {
        let config = AgentConfig {
            rule,
            ..AgentConfig::FORAGER
        };
        let (mut agent, mut world) = (walker(config, 3), Corridor(0));
        live(&mut agent, &mut world, 2000);
        agent.act(Adaptation::Frozen).unwrap();
        world.0 = 0;
        // Three steps there, one back: chance needs about twelve.
        assert_eq!(live(&mut agent, &mut world, 400), 100, "{rule:?}");
    }
}

#[test]
fn the_same_seed_gives_the_same_life_and_another_seed_another() {
    let life = |seed| {
        let (mut agent, mut world) = (walker(AgentConfig::FORAGER, seed), Corridor(0));
        let rewards = live(&mut agent, &mut world, 700);
        (rewards, agent.knowledge().clone())
    };
    assert_eq!(life(5), life(5));
    assert_ne!(life(5), life(6));
}

#[test]
fn every_step_says_what_it_has_touched_and_begins_at_nothing() {
    let (mut agent, mut world) = (walker(AgentConfig::FORAGER, 5), Corridor(0));
    live(&mut agent, &mut world, 700);
    let patterns = u32::from(agent.knowledge().patterns());
    let before = world.sense();
    let action = agent.choose(&before).unwrap().action;
    let chosen = agent.cost();
    assert_eq!((chosen.units, chosen.moved), (0, 0));
    world.act(action);
    agent.learn(&world.sense()).unwrap();
    let whole = agent.cost();
    // Two halves of a map of 36 nodes, and one item on in each.
    assert_eq!((whole.units, whole.weights), (72, 72));
    assert!(whole.moved >= 2, "{whole:?}");
    // Once for what came of it, once for each value.
    let looks = 1 + u32::from(AgentConfig::FORAGER.values_per_step);
    assert_eq!(whole.patterns, chosen.patterns + looks * patterns);
    assert!(whole.schemas > chosen.schemas);
    // A reflex is a step of its own.
    agent.observe(&before, action, &world.sense()).unwrap();
    assert_eq!(agent.cost().patterns, looks * patterns);
    agent.act(Adaptation::Frozen).unwrap();
    agent.choose(&before).unwrap();
    agent.learn(&world.sense()).unwrap();
    assert_eq!(agent.cost().units, 0);
}

#[test]
fn calls_out_of_turn_are_refused_and_change_nothing() {
    let mut agent = Box::new(Walker::new());
    let now = Corridor(0).sense();
    assert_eq!(agent.choose(&now), Err(AgentError::NotBorn));
    assert_eq!(agent.learn(&now), Err(AgentError::NotBorn));
    assert_eq!(agent.act(Adaptation::Frozen), Err(AgentError::NotBorn));
    assert_eq!(agent.stage(), Stage::Unborn);
    let mut agent = walker(AgentConfig::FORAGER, 1);
    assert_eq!(agent.learn(&now), Err(AgentError::NothingChosen));
    let unknown = agent.observe(&now, ActionId(2), &now);
    assert_eq!(unknown, Err(AgentError::NoSuchAction(ActionId(2))));
    assert_eq!(
        agent.bank().maps().each_ref().map(|map| map.samples()),
        [0, 0]
    );
}

#[test]
fn a_bad_configuration_is_refused_by_name_and_the_old_life_goes_on() {
    let mut agent = walker(AgentConfig::FORAGER, 1);
    let mut world = Corridor(0);
    live(&mut agent, &mut world, 600);
    let before = agent.knowledge().clone();
    let nan = AgentConfig {
        forgetting: f32::NAN,
        ..AgentConfig::FORAGER
    };
    let refused = agent.be_born(nan, &GOLD, 1).unwrap_err();
    assert_eq!(refused.field, "AgentConfig::forgetting");
    assert!(refused.value.is_nan() && refused.range == Range::SHARE);
    let never = AgentConfig {
        training_run: 0,
        ..AgentConfig::FORAGER
    };
    let refused = agent.be_born(never, &GOLD, 1).unwrap_err();
    assert_eq!(refused.field, "AgentConfig::training_run");
    assert_eq!((refused.value, refused.range), (0.0, Range::AT_LEAST_ONE));
    assert_eq!(*agent.knowledge(), before);
}

#[test]
fn nobody_is_born_without_anything_that_is_worth_having() {
    let mut agent = Box::new(Walker::new());
    for (values, field) in [
        (&[][..], "values: the largest"),
        (&[(ItemId(3), 0.0)], "values: the largest"),
        (&[(ItemId(4), 1.0)], "values: an item"),
        (&[(ItemId(3), 1.0), (ItemId(0), -1.0)], "values: a value"),
        (&[(ItemId(3), f32::INFINITY)], "values: a value"),
    ] {
        let refused = agent.be_born(AgentConfig::FORAGER, values, 1).unwrap_err();
        assert_eq!(refused.field, field);
        let now = Corridor(0).sense();
        assert_eq!(agent.choose(&now), Err(AgentError::NotBorn));
    }
    // Another birth forgets what was worth having in the life before.
    for (item, others) in [(3, 0), (0, 3)] {
        let values = [(ItemId(item), 2.0)];
        agent.be_born(AgentConfig::FORAGER, &values, 1).unwrap();
        let worth = |item| agent.knowledge().inherent_value(ItemId(item));
        assert_eq!((worth(item), worth(others)), (2.0, 0.0));
    }
}

#[test]
fn a_frozen_agent_learns_nothing_and_an_adapting_one_no_new_schema() {
    let mut agent = walker(AgentConfig::FORAGER, 2);
    let mut world = Corridor(0);
    live(&mut agent, &mut world, 1000);
    let mut frozen = agent.clone();
    frozen.act(Adaptation::Frozen).unwrap();
    let before = frozen.knowledge().clone();
    live(&mut frozen, &mut world, 300);
    // Only what held at the last look may differ; the records must not.
    assert_eq!(frozen.knowledge().schemas(), before.schemas());
    agent.act(Adaptation::Reliabilities).unwrap();
    let (schemas, samples) = (
        agent.knowledge().schemas().len(),
        agent.bank().maps()[0].samples(),
    );
    let trials = |agent: &Walker| -> u32 {
        agent
            .knowledge()
            .schemas()
            .iter()
            .map(|s| s.reliability.activations())
            .sum()
    };
    let trials_before = trials(&agent);
    live(&mut agent, &mut world, 300);
    assert_eq!(agent.knowledge().schemas().len(), schemas);
    assert_eq!(agent.bank().maps()[0].samples(), samples);
    assert!(trials(&agent) >= trials_before + 300);
}

#[test]
fn a_step_ends_however_many_values_it_is_to_bring_up_to_date() {
    let lived = |level1: u16, level2: u16| {
        let config = AgentConfig {
            values_per_step: level1,
            level2: Some(Level2Config {
                values_per_step: level2,
                ..Level2Config::FORAGER
            }),
            ..AgentConfig::FORAGER
        };
        let mut agent = Box::new(super::Agent::<1, 4, 6, 6, 2, 64, 256, 8, 16>::new());
        agent.be_born(config, &GOLD, 4).unwrap();
        let mut world = Corridor(0);
        for _ in 0..300 {
            let choice = agent.choose(&world.sense()).unwrap();
            world.act(choice.action);
            agent.learn(&world.sense()).unwrap();
        }
        agent.cost()
    };
    assert_eq!(lived(u16::MAX, 4), lived(1024, 4));
    assert_eq!(lived(4, u16::MAX), lived(4, 1024));
    let fewer = [lived(512, 4), lived(4, 512)];
    assert!(fewer[0] != lived(1024, 4) && fewer[1] != lived(4, 1024));
}

#[test]
fn a_long_time_without_reward_ends_in_a_burst_of_random_actions() {
    let escape = Some(Escape {
        after: 20,
        burst: 5,
    });
    let config = AgentConfig {
        escape,
        greedy_share: 1.0,
        ..AgentConfig::FORAGER
    };
    let mut agent = walker(config, 4);
    let now = Corridor(0).sense();
    let reasons: std::vec::Vec<Reason> = (0..50)
        .map(|_| {
            let choice = agent.choose(&now).unwrap();
            agent.learn(&now).unwrap();
            choice.reason
        })
        .collect();
    let bursts = |range: core::ops::Range<usize>| {
        reasons[range]
            .iter()
            .filter(|&&reason| reason == Reason::Escape)
            .count()
    };
    assert_eq!(
        (
            bursts(0..20),
            bursts(20..25),
            bursts(25..40),
            bursts(40..45)
        ),
        (0, 5, 0, 5)
    );
}

#[test]
fn training_is_by_value_in_runs_and_in_the_configured_share() {
    let config = AgentConfig {
        training_run: 10,
        escape: None,
        ..AgentConfig::FORAGER
    };
    let (mut agent, mut world) = (walker(config, 9), Corridor(0));
    live(&mut agent, &mut world, 1000);
    let mut explored = std::vec::Vec::new();
    for _ in 0..4000 {
        let choice = agent.choose(&world.sense()).unwrap();
        explored.push(choice.reason == Reason::Exploration);
        world.act(choice.action);
        agent.learn(&world.sense()).unwrap();
    }
    let share = explored.iter().filter(|&&it| !it).count() as f32 / 4000.0;
    assert!((0.14..0.26).contains(&share), "{share}");
    assert!(
        explored
            .chunks(10)
            .all(|run| run.iter().all(|&it| it == run[0]))
    );
}

#[test]
fn an_action_that_does_not_complete_teaches_nothing() {
    let mut agent = walker(AgentConfig::FORAGER, 1);
    let now = Corridor(1).sense();
    agent.choose(&now).unwrap();
    agent.choose(&now).unwrap();
    agent.learn(&now).unwrap();
    let samples: u32 = agent.bank().maps().iter().map(|map| map.samples()).sum();
    assert_eq!(samples, 1);
}

#[test]
fn schemas_are_written_in_the_books_notation() {
    use crate::knowledge::SchemaId;
    use crate::word::Detail;
    use std::string::ToString;
    let (mut agent, mut world) = (walker(AgentConfig::FORAGER, 3), Corridor(0));
    live(&mut agent, &mut world, 1000);
    let knowledge = agent.knowledge();
    let found = (0..knowledge.schemas().len()).any(|index| {
        let text = knowledge.text(SchemaId(index as u16)).unwrap();
        text.display(&WORDS, Detail::Abbreviated).to_string() == "+c/on/+gold"
    });
    assert!(found);
}

/// The corridor with a lamp that is always on, and a sensor that reads NaN.
type Distracted = super::Agent<1, 6, 6, 6, 2, 64, 256, 0, 0>;

fn distracted(world: &Corridor) -> ItemStates<1> {
    let mut now = world.sense();
    now.set_above(ItemId(4), 1.0, 0.5).unwrap();
    now.set_above(ItemId(5), f32::NAN, 0.5).unwrap();
    now
}

#[test]
fn an_item_that_never_varies_and_a_sensor_that_always_fails_are_no_obstacle() {
    let (mut agent, mut world) = (Box::new(Distracted::new()), Corridor(0));
    agent
        .be_born(AgentConfig::FORAGER, &[(ItemId(3), 10.0)], 3)
        .unwrap();
    let mut rewards = 0;
    for step in 0..2400 {
        if step == 2000 {
            agent.act(Adaptation::Frozen).unwrap();
            (world.0, rewards) = (0, 0);
        }
        let choice = agent.choose(&distracted(&world)).unwrap();
        world.act(choice.action);
        let lesson = agent.learn(&distracted(&world)).unwrap();
        rewards += u32::from(lesson.reward > 0.0);
    }
    assert_eq!(rewards, 100);
    // What nobody knows stands in no schema.
    for schema in agent.knowledge().schemas() {
        for pattern in [schema.context, schema.result] {
            let items = agent.knowledge().pattern(pattern).unwrap();
            assert!(!items.positive().contains(ItemId(5)) && !items.negative().contains(ItemId(5)));
        }
    }
}

#[test]
fn sensors_that_fail_for_a_while_take_nothing_that_was_learned() {
    for adaptation in [Adaptation::Reliabilities, Adaptation::Relearning] {
        let config = AgentConfig {
            escape: None,
            ..AgentConfig::FORAGER
        };
        let (mut agent, mut world) = (walker(config, 3), Corridor(0));
        live(&mut agent, &mut world, 2000);
        agent.act(adaptation).unwrap();
        let before = agent.knowledge().clone();
        for _ in 0..300 {
            let choice = agent.choose(&ItemStates::UNKNOWN).unwrap();
            assert_eq!(choice.reason, Reason::NothingApplies);
            world.act(choice.action);
            let lesson = agent.learn(&ItemStates::UNKNOWN).unwrap();
            assert_eq!((lesson.reward, lesson.outcome.activated), (0.0, 0));
        }
        let records = |schemas: &[crate::knowledge::Schema]| -> std::vec::Vec<_> {
            let record = |it: &crate::knowledge::Schema| (it.context, it.action, it.reliability);
            schemas.iter().map(record).collect()
        };
        assert_eq!(
            records(agent.knowledge().schemas()),
            records(before.schemas()),
            "{adaptation:?}"
        );
        world.0 = 0;
        assert_eq!(live(&mut agent, &mut world, 400), 100, "{adaptation:?}");
    }
}

/// A door that opens by `press` only right after `pull`, and looks the same before and after that.
struct Door {
    pulled: bool,
    open: bool,
}

type Keeper = super::Agent<1, 2, 4, 4, 2, 8, 32, 16, 64>;

impl Door {
    fn sense(&self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(2);
        now.set(ItemId(u16::from(self.open)), Some(true)).unwrap();
        now
    }

    fn act(&mut self, action: ActionId) {
        let press = action == ActionId(1);
        self.open = press && self.pulled;
        self.pulled = !press;
    }
}

fn keeper(level2: Option<Level2Config>) -> (Box<Keeper>, Door) {
    let config = AgentConfig {
        level2,
        escape: None,
        ..AgentConfig::FORAGER
    };
    let mut agent = Box::new(Keeper::new());
    agent.be_born(config, &[(ItemId(1), 10.0)], 4).unwrap();
    let door = Door {
        pulled: false,
        open: false,
    };
    (agent, door)
}

fn keep(agent: &mut Keeper, door: &mut Door, steps: u32) -> u32 {
    let mut opened = 0;
    for _ in 0..steps {
        let choice = agent.choose(&door.sense()).unwrap();
        door.act(choice.action);
        agent.learn(&door.sense()).unwrap();
        opened += u32::from(door.open);
    }
    opened
}

#[test]
fn the_second_level_sees_what_a_snapshot_cannot_tell() {
    let opened = |level2| {
        let (mut agent, mut door) = keeper(level2);
        keep(&mut agent, &mut door, 1500);
        agent.act(Adaptation::Frozen).unwrap();
        keep(&mut agent, &mut door, 400)
    };
    // Pull, press, pull, press: at most every second action opens.
    assert!(opened(Some(Level2Config::FORAGER)) > 190);
    assert!(opened(None) < 100);
}

#[test]
fn what_happens_later_changes_no_earlier_belief_and_no_earlier_choice() {
    let config = Level2Config::FORAGER;
    let life = |turn: u32, seed: u64| {
        let (mut agent, mut door) = keeper(Some(config));
        let mut other = crate::num::Rng::new(seed);
        let mut history = std::vec::Vec::new();
        for step in 0..600 {
            let choice = agent.choose(&door.sense()).unwrap();
            history.push((choice, agent.second_level().clone()));
            // From the turn on another world answers.
            door.act(choice.action);
            if step >= turn {
                door.open = other.chance(0.5);
            }
            agent.learn(&door.sense()).unwrap();
        }
        history
    };
    let (one, two) = (life(400, 1), life(400, 2));
    assert_eq!(one[..=400], two[..=400]);
    assert_ne!(one[599].1, two[599].1);
}

#[test]
fn an_overloaded_level_leaves_the_decision_to_the_one_below() {
    let config = Level2Config {
        fallback: Fallback::MeanReliability(0.7),
        ..Level2Config::FORAGER
    };
    let (mut agent, mut door) = keeper(Some(config));
    keep(&mut agent, &mut door, 3000);
    agent.act(Adaptation::Reliabilities).unwrap();
    keep(&mut agent, &mut door, 200);
    let now = door.sense();
    assert_eq!(agent.choose(&now).unwrap().level, Some(Level::Two));
    // A door that opens at random: nothing that was believed comes true reliably.
    let mut rng = crate::num::Rng::new(7);
    let mut fallen = false;
    for _ in 0..200 {
        let choice = agent.choose(&door.sense()).unwrap();
        fallen |= choice.level == Some(Level::One);
        door.open = rng.chance(0.5);
        agent.learn(&door.sense()).unwrap();
    }
    assert!(fallen);
}

#[test]
fn items_follow_their_schemas_through_harvests() {
    let (mut agent, mut door) = keeper(Some(Level2Config::FORAGER));
    for _ in 0..20 {
        keep(&mut agent, &mut door, 100);
        let level = agent.second_level();
        let schemas = agent.knowledge().schemas();
        for (index, schema) in schemas.iter().enumerate() {
            if let Some(item) = schema.synthetic() {
                assert_eq!(level.schema(item).map(|id| id.0), Some(index as u16));
            }
        }
        // What follows a schema begins where that schema ends.
        for belief in level.beliefs() {
            let of = |item| schemas[usize::from(level.schema(item).unwrap().0)];
            assert_eq!(of(belief.trace).result, of(belief.item).context);
        }
    }
    assert!(agent.second_level().items() > 0);
}

#[test]
fn an_item_in_the_row_of_the_trace_is_not_taken_for_it() {
    let mut agent = Box::new(super::Agent::<1, 4, 6, 6, 2, 64, 256, 1, 64>::new());
    let mut world = Corridor(0);
    let config = AgentConfig {
        level2: Some(Level2Config::FORAGER),
        ..AgentConfig::FORAGER
    };
    agent.be_born(config, &GOLD, 4).unwrap();
    for _ in 0..2000 {
        let choice = agent.choose(&world.sense()).unwrap();
        world.act(choice.action);
        agent.learn(&world.sense()).unwrap();
        let level = agent.second_level();
        for belief in level.beliefs() {
            let schema =
                |item| agent.knowledge().schemas()[usize::from(level.schema(item).unwrap().0)];
            assert_eq!(schema(belief.trace).result, schema(belief.item).context);
        }
    }
    assert!(agent.second_level().losses().evicted_items > 0);
}

#[test]
fn what_is_only_watched_counts_for_health_too() {
    let mut agent = walker(AgentConfig::FORAGER, 3);
    let here = Corridor(0).sense();
    for _ in 0..7 {
        agent.observe(&here, ActionId(1), &here).unwrap();
    }
    assert_eq!(agent.health().steps, 7);
}

//! What surprises an agent and what it makes of that, as tests.

use super::{ActionId, KnowledgeBase, PatternId, SurpriseConfig};
use crate::adaptation::Alarm;
use crate::agent::{Adaptation, Agent, AgentConfig};
use crate::choice::ValueConfig;
use crate::knowledge::Estimate;
use crate::word::{ItemId, ItemStates, SchemaText, SignedItems, Vocabulary};

const WORDS: Vocabulary = Vocabulary {
    items: &["here", "there", "gold"],
    actions: &["walk", "wait"],
};
const CONFIG: SurpriseConfig = SurpriseConfig::FORAGER;

/// Alarms of 20,000 actions, of which `rewarded` says which are.
fn alarms(rewarded: impl Fn(u32) -> bool) -> u32 {
    let mut alarm = Alarm::NONE;
    for action in 0..20_000 {
        alarm.feel(&CONFIG, rewarded(action));
    }
    alarm.alarms()
}

#[test]
fn reward_that_stays_away_alarms_and_steady_or_growing_reward_does_not() {
    assert_eq!(alarms(|action| action % 12 == 0), 0);
    assert_eq!(alarms(|_| false), 0);
    assert_eq!(
        alarms(|action| action % if action < 9000 { 20 } else { 10 } == 0),
        0
    );
    let fallen = alarms(|action| action % if action < 9000 { 12 } else { 60 } == 0);
    // What is usual follows: it does not ring for ever.
    assert!((1..=6).contains(&fallen), "{fallen}");
}

fn state(on: &[u16]) -> ItemStates<1> {
    let mut state = ItemStates::all_off(3);
    for &item in on {
        state.set(ItemId(item), Some(true)).unwrap();
    }
    state
}

/// From here walking leads to gold, from there to nothing; waiting does nothing.
fn knowledge() -> KnowledgeBase<1, 16, 16> {
    let mut it = KnowledgeBase::new();
    it.set_inherent_value(ItemId(2), 10.0).unwrap();
    for (text, successes) in [
        ("+here-there-gold/walk/-here-there+gold", 90),
        ("+here-there-gold/walk/-here-there-gold", 10),
        ("-here+there-gold/walk/-here-there-gold", 100),
        ("+here-there-gold/wait/+here-there-gold", 100),
        ("-here+there-gold/wait/-here+there-gold", 100),
    ] {
        let text = SchemaText::parse(text, &WORDS).unwrap();
        it.insert(&text, successes, 100).unwrap();
    }
    it.settle_values::<2>(50, &ValueConfig::FORAGER);
    it.begin_doubt();
    it
}

fn context(it: &KnowledgeBase<1, 16, 16>, schema: usize) -> (PatternId, ActionId) {
    let schema = it.schemas()[schema];
    (schema.context, schema.action)
}

fn survival(it: &KnowledgeBase<1, 16, 16>, schema: usize) -> f32 {
    let (context, action) = context(it, schema);
    it.survival(context, action)
}

const WALK: ActionId = ActionId(0);

#[test]
fn what_goes_on_as_before_survives_and_what_fails_does_not() {
    let mut it = knowledge();
    assert!(
        (survival(&it, 0) - 1.0).abs() < 1e-6,
        "nothing was seen yet"
    );
    for trial in 0..20 {
        let gold = trial % 10 != 9;
        it.count_hits(&state(&[0]), WALK, &state(if gold { &[2] } else { &[] }));
        it.count_hits(&state(&[1]), WALK, &state(&[2]));
    }
    let (kept, lost) = (survival(&it, 0), survival(&it, 2));
    assert!((0.6..1.0).contains(&kept), "{kept}");
    assert!((0.0..0.1).contains(&lost), "{lost}");
}

#[test]
fn a_model_that_lost_its_hold_becomes_what_was_seen() {
    let mut it = knowledge();
    for _ in 0..20 {
        it.count_hits(&state(&[1]), WALK, &state(&[2]));
    }
    it.weigh::<2>(&CONFIG, &ValueConfig::FORAGER);
    let recent = |index: usize| it.schemas()[index].reliability.value(Estimate::Recent);
    // What no schema said became one at once.
    assert_eq!(it.schemas().len(), 6);
    assert!(
        recent(5) > 0.9 && recent(2) < 0.1,
        "{} {}",
        recent(5),
        recent(2)
    );
    // What was not tried is as it was.
    assert!((recent(0) - 0.9).abs() < 0.01, "{}", recent(0));
}

#[test]
fn hope_is_for_what_an_action_is_worth_elsewhere() {
    let mut it = knowledge();
    for _ in 0..6 {
        it.count_hits(&state(&[0]), WALK, &state(&[]));
    }
    it.weigh::<2>(&CONFIG, &ValueConfig::FORAGER);
    let bonus = |it: &KnowledgeBase<1, 16, 16>, index: usize| it.schemas()[index].doubt.bonus;
    // Walking brought gold from one place; perhaps it now does from the other.
    assert!(bonus(&it, 2) > 0.1, "{}", bonus(&it, 2));
    assert_eq!(bonus(&it, 0), 0.0, "nowhere is walking worth more");
    it.end_doubt();
    assert_eq!(bonus(&it, 2), 0.0);
    assert!(
        (survival(&it, 0) - 1.0).abs() < 1e-6,
        "nothing is doubted any more"
    );
}

#[test]
fn a_full_table_in_a_doubt_is_a_counted_loss() {
    let mut it = KnowledgeBase::<1, 2, 1>::new();
    let text = SchemaText::parse("+here-there-gold/walk/-here-there-gold", &WORDS).unwrap();
    it.insert(&text, 50, 50).unwrap();
    it.begin_doubt();
    it.count_hits(&state(&[0]), WALK, &state(&[2]));
    assert_eq!(it.schemas().len(), 1);
    let losses = it.losses();
    assert_eq!(losses.refused_patterns + losses.refused_schemas, 1);
    it.weigh::<1>(&CONFIG, &ValueConfig::FORAGER);
    let kept = it.schemas()[0].reliability.value(Estimate::Recent);
    assert!((kept - 1.0).abs() < 0.01, "{kept}");
}

#[test]
fn trials_of_a_long_doubt_are_halved_and_keep_their_shares() {
    let mut it = knowledge();
    let (here, gold, nothing) = (state(&[0]), state(&[2]), state(&[]));
    for trial in 0..60_000_u32 {
        let after = if trial % 4 == 0 { &nothing } else { &gold };
        it.count_hits(&here, WALK, after);
    }
    let hits = [0, 1].map(|schema| it.schemas()[schema].doubt.hits);
    assert!((2_000..4_224).contains(&(hits[0] + hits[1])), "{hits:?}");
    it.weigh::<2>(&CONFIG, &ValueConfig::FORAGER);
    let seen = it.schemas()[0].reliability.value(Estimate::Recent);
    assert!((seen - 0.75).abs() < 0.02, "{seen}");
}

#[test]
fn what_came_once_among_many_results_is_not_forgotten_by_counting() {
    let mut it = KnowledgeBase::<1, 128, 128>::new();
    let on = |number: u16| {
        let mut state = ItemStates::<1>::all_off(7);
        for item in 0..7 {
            state
                .set(ItemId(item), Some(number >> item & 1 == 1))
                .unwrap();
        }
        state
    };
    let here = on(1);
    for number in 0..64 {
        let text = SchemaText {
            context: SignedItems::of(&here),
            action: WALK,
            result: SignedItems::of(&on(number)),
        };
        it.insert(&text, 1, 64).unwrap();
    }
    it.begin_doubt();
    it.count_hits(&here, WALK, &on(9));
    for _ in 0..64 {
        it.count_hits(&here, WALK, &on(5));
    }
    let counted = |hits: u16| {
        it.schemas()
            .iter()
            .filter(|it| it.doubt.hits == hits)
            .count()
    };
    assert_eq!((counted(0), counted(1), counted(64)), (62, 1, 1));
}

#[test]
fn more_trials_than_can_be_counted_weigh_as_the_most_that_can() {
    let mut it = knowledge();
    for schema in &mut it.schemas {
        schema.doubt.hits = u16::MAX;
    }
    it.weigh::<2>(&CONFIG, &ValueConfig::FORAGER);
    for (index, schema) in it.schemas().iter().enumerate() {
        let p = schema.reliability.value(Estimate::Recent);
        assert!((0.0..=1.0).contains(&p), "{index} {p}");
        assert!((0.0..=1.0).contains(&survival(&it, index)));
    }
}

#[test]
fn a_surprise_that_cannot_work_is_refused_and_nothing_changes() {
    let mut agent = std::boxed::Box::new(Agent::<1, 3, 4, 4, 2, 16, 16>::new());
    agent
        .be_born(AgentConfig::RESILIENT, &[(ItemId(2), 10.0)], 1)
        .unwrap();
    let spoil: [fn(&mut SurpriseConfig); 5] = [
        |it| it.missing = f32::NAN,
        |it| it.missing = 0.0,
        |it| it.enough = 1.5,
        |it| it.optimism = f32::INFINITY,
        |it| it.doubt = 0,
    ];
    for spoil in spoil {
        let mut config = CONFIG;
        spoil(&mut config);
        let refused = agent.set_surprise(Some(config)).unwrap_err();
        assert!(refused.field.starts_with("SurpriseConfig::"), "{refused}");
    }
    assert_eq!(agent.set_surprise(None), Ok(()));
    // Without a surprise there is nothing to doubt with.
    agent.act(Adaptation::Relearning).unwrap();
    agent.doubt();
    assert!(!agent.doubts() && agent.alarms() == 0);
    agent.set_surprise(Some(CONFIG)).unwrap();
    agent.doubt();
    assert!(agent.doubts());
}

#[test]
fn a_doubt_ends_with_what_it_needs() {
    let ends: [fn(&mut Agent<1, 3, 4, 4, 2, 16, 16>); 3] = [
        |it| it.set_surprise(None).unwrap(),
        |it| it.reconfigure(AgentConfig::FORAGER).unwrap(),
        |it| it.act(Adaptation::Frozen).unwrap(),
    ];
    for end in ends {
        let mut agent = std::boxed::Box::new(Agent::<1, 3, 4, 4, 2, 16, 16>::new());
        agent
            .be_born(AgentConfig::RESILIENT, &[(ItemId(2), 10.0)], 1)
            .unwrap();
        agent.act(Adaptation::Relearning).unwrap();
        agent.doubt();
        assert!(agent.doubts());
        end(&mut agent);
        assert!(!agent.doubts());
    }
}

#[test]
fn the_same_seed_gives_the_same_doubt_to_the_bit() {
    let life = || {
        let mut agent = std::boxed::Box::new(Agent::<1, 3, 4, 4, 2, 16, 16>::new());
        agent
            .be_born(AgentConfig::RESILIENT, &[(ItemId(2), 10.0)], 7)
            .unwrap();
        let mut on = 0;
        for step in 0..4000_u32 {
            if step == 1000 {
                agent.act(Adaptation::Relearning).unwrap();
            }
            let choice = agent.choose(&state(&[on])).unwrap();
            // After 2500 steps the ways are exchanged.
            let way = u16::from(choice.action == WALK) ^ u16::from(step >= 2500);
            on = if way == 1 { (on + 1) % 3 } else { 0 };
            agent.learn(&state(&[on])).unwrap();
        }
        let values = agent.knowledge().schemas().iter();
        let bits = values.map(|it| it.reliability.value(Estimate::Recent).to_bits());
        (agent.alarms(), bits.collect::<std::vec::Vec<u32>>())
    };
    assert_eq!(life(), life());
    assert!(life().0 >= 1);
}

#[test]
fn a_doubt_of_an_agent_ends_after_its_actions_and_leaves_nothing_doubted() {
    let mut agent = std::boxed::Box::new(Agent::<1, 3, 4, 4, 2, 16, 16>::new());
    let surprise = Some(SurpriseConfig {
        doubt: 40,
        ..CONFIG
    });
    let config = AgentConfig {
        surprise,
        ..AgentConfig::RESILIENT
    };
    agent.be_born(config, &[(ItemId(2), 10.0)], 1).unwrap();
    let live = |agent: &mut Agent<1, 3, 4, 4, 2, 16, 16>, steps: u32| {
        for _ in 0..steps {
            let action = agent.choose(&state(&[0])).unwrap().action;
            let on = if action == WALK { 2 } else { 0 };
            agent.learn(&state(&[on])).unwrap();
        }
    };
    live(&mut agent, 300);
    agent.act(Adaptation::Relearning).unwrap();
    let nothing = crate::knowledge::Doubt::default();
    let doubted = |agent: &Agent<1, 3, 4, 4, 2, 16, 16>| {
        let schemas = agent.knowledge().schemas().iter();
        schemas.filter(|schema| schema.doubt != nothing).count()
    };
    assert_eq!(doubted(&agent), 0);
    agent.doubt();
    assert_eq!((agent.doubts(), agent.alarms()), (true, 1));
    assert!(doubted(&agent) > 0);
    live(&mut agent, 39);
    assert!(agent.doubts() && doubted(&agent) > 0);
    live(&mut agent, 1);
    assert_eq!((agent.doubts(), doubted(&agent)), (false, 0));
}

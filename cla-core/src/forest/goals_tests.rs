//! Goals and plans of a mind with reason, why it says what it does, and a mind without.

use std::boxed::Box;

use super::super::{Actions, Heard, Mind, MindConfig, MindError, Motive, Voice};
use crate::reason::{Prospects, Pursuit, Reason, Reasoning, Way};
use crate::word::{ActionId, ItemId, ItemStates, SchemaText, SignedItems, Vocabulary};

/// A corridor of five places; the door at its end opens only with the key, which lies at its
/// beginning and is lost when it was used. Actions: back, on, take, open.
#[derive(Clone, Copy)]
struct Corridor {
    at: u16,
    key: bool,
    open: bool,
}

const WORDS: Vocabulary = Vocabulary {
    items: &["p0", "p1", "p2", "p3", "p4", "key", "open"],
    actions: &["back", "on", "take", "unlock"],
};
const KEY: ItemId = ItemId(5);
const OPEN: ItemId = ItemId(6);
const TAKE: ActionId = ActionId(2);

type Thinker = Mind<1, 7, 4, 16, 16, 32, 32, 64, Reason<1, 7, 4, 32, 64, 64>>;
type Thoughtless = Mind<1, 7, 4, 16, 16, 32, 32, 64>;

impl Corridor {
    const START: Self = Self {
        at: 2,
        key: false,
        open: false,
    };

    fn act(&mut self, action: ActionId) {
        self.open = false;
        match action.0 {
            0 => self.at = self.at.saturating_sub(1),
            1 => self.at = (self.at + 1).min(4),
            2 => self.key |= self.at == 0,
            _ if self.at == 4 && self.key => (self.key, self.open) = (false, true),
            _ => {}
        }
    }

    fn see(self) -> ItemStates<1> {
        let mut now = ItemStates::all_off(7);
        now.set(ItemId(self.at), Some(true)).unwrap();
        now.set(KEY, Some(self.key)).unwrap();
        now.set(OPEN, Some(self.open)).unwrap();
        now
    }
}

/// A life of so many actions in which an open door is worth something; who lived it, where it ended,
/// and how often the door was opened.
fn lived<R: Reasoning<1, 7, 4> + Clone>(
    config: MindConfig,
    actions: u32,
    seed: u64,
) -> (Box<Mind<1, 7, 4, 16, 16, 32, 32, 64, R>>, Corridor, u32) {
    let mut mind = Box::new(Mind::unborn());
    let mut values = [0.0; 7];
    values[usize::from(OPEN.0)] = 1.0;
    mind.be_born(config, values, seed).unwrap();
    let (mut world, mut opened) = (Corridor::START, 0);
    for _ in 0..actions {
        let choice = mind.choose(&world.see()).unwrap();
        world.act(choice.action);
        mind.learn(&world.see()).unwrap();
        opened += u32::from(world.open);
    }
    (mind, world, opened)
}

fn goal(items: &[(ItemId, bool)]) -> SignedItems<1> {
    let mut goal = SignedItems::EMPTY;
    for &(item, sign) in items {
        goal.insert(item, sign).unwrap();
    }
    goal
}

fn thinker(actions: u32, seed: u64) -> Box<Thinker> {
    lived(MindConfig::DEFAULT, actions, seed).0
}

#[test]
fn a_goal_at_run_time_is_reached_by_the_shortest_way() {
    let mut mind = thinker(1_500, 1);
    mind.interrupt().unwrap();
    mind.act().unwrap();
    let mut world = Corridor::START;
    // The key at the other end: two back, take, four on.
    let there = goal(&[(KEY, true), (ItemId(4), true)]);
    let begun = mind.pursue(there, 20, &world.see()).unwrap();
    assert_eq!(begun, Pursuit::Underway { left: 20 });
    mind.idle(10_000);
    assert_eq!(mind.way(&world.see()), Way::Actions(7));
    let mut steps = 0;
    while mind.pursuit().is_underway() {
        let choice = mind.choose(&world.see()).unwrap();
        assert_eq!(choice.motive, Motive::Goal);
        world.act(choice.action);
        mind.learn(&world.see()).unwrap();
        steps += 1;
        assert_eq!(steps < 7, mind.pursuit().is_underway());
    }
    assert_eq!(mind.pursuit(), Pursuit::Reached);
    assert!(world.key && world.at == 4);
    let after = mind.choose(&world.see()).unwrap();
    assert_ne!(after.motive, Motive::Goal);
}

#[test]
fn a_goal_that_cannot_be_times_out_and_one_can_be_given_up() {
    let mut mind = thinker(800, 2);
    let mut world = Corridor::START;
    mind.interrupt().unwrap();
    mind.pursue(
        goal(&[(ItemId(0), true), (ItemId(4), true)]),
        3,
        &world.see(),
    )
    .unwrap();
    for _ in 0..3 {
        assert!(mind.pursuit().is_underway());
        let choice = mind.choose(&world.see()).unwrap();
        world.act(choice.action);
        mind.learn(&world.see()).unwrap();
    }
    assert_eq!(mind.pursuit(), Pursuit::TimedOut);
    mind.pursue(goal(&[(KEY, true)]), 30, &world.see()).unwrap();
    mind.give_up();
    assert_eq!(mind.pursuit(), Pursuit::Nothing);
}

#[test]
fn an_action_that_is_not_allowed_leads_to_no_goal() {
    let mut mind = thinker(1_500, 3);
    mind.interrupt().unwrap();
    let now = Corridor::START.see();
    mind.pursue(goal(&[(ItemId(0), true)]), 20, &now).unwrap();
    mind.idle(10_000);
    assert_eq!(mind.way(&now), Way::Actions(2));
    let choice = mind
        .choose_among(&now, Actions::ALL.without(ActionId(0)))
        .unwrap();
    assert_ne!(choice.action, ActionId(0));
}

#[test]
fn of_two_steps_that_lead_as_near_the_allowed_one_is_taken() {
    let mind = thinker(0, 3);
    let mut prospects = Prospects::<4>::NONE;
    prospects.ways = [3, 2, 2, 4].map(Way::Actions);
    prospects.way = Way::Actions(2);
    prospects.values = [Some(9.0), Some(0.5), Some(0.25), None];
    let step = |allowed| mind.step(&prospects, allowed);
    let taken = |allowed| step(allowed).map(|step| (step.action.0, step.value));
    assert_eq!(taken(Actions::ALL), Some((1, 0.5)));
    assert_eq!(taken(Actions::ALL.without(ActionId(1))), Some((2, 0.25)));
    // A longer way is none: the next step might undo it.
    let longer = Actions::NONE.with(ActionId(0)).with(ActionId(3));
    assert_eq!(taken(longer), None);
    assert_eq!(mind.step(&Prospects::NONE, Actions::ALL), None);
}

#[test]
fn plans_are_followed_for_what_an_allowed_action_promises() {
    let mut prospects = Prospects::<4>::NONE;
    prospects.values = [Some(1.0), Some(0.0), None, None];
    let all = Thinker::planned(&prospects, Actions::ALL);
    assert_eq!(all, Some([1.0, 0.0, 0.0, 0.0]));
    // Without the first there is nothing to choose between.
    let others = Actions::ALL.without(ActionId(0));
    assert_eq!(Thinker::planned(&prospects, others), None);
    // A mind whose promises are kept does not trust in what it may not do.
    let mind = thinker(1_500, 1);
    assert!(mind.reason().reliability() >= 0.8);
    prospects.values = [Some(1.0), Some(-1.0), Some(0.0), None];
    assert!(mind.trusts(&prospects, Actions::ALL));
    assert!(!mind.trusts(&prospects, others));
    let newborn = thinker(0, 1);
    assert!(!newborn.trusts(&prospects, Actions::ALL));
}

#[test]
fn with_a_reason_random_actions_come_twenty_in_a_row() {
    let mut mind = Box::new(Thinker::unborn());
    let config = MindConfig {
        exploring: 0.3,
        ..MindConfig::DEFAULT
    };
    mind.be_born(config, [0.0; 7], 1).unwrap();
    let (mut world, mut row, mut rows) = (Corridor::START, 0, 0);
    for _ in 0..4_000 {
        let choice = mind.choose(&world.see()).unwrap();
        if choice.motive == Motive::Chance {
            row += 1;
        } else if row > 0 {
            assert_eq!(row % 20, 0);
            (row, rows) = (0, rows + 1);
        }
        world.act(choice.action);
        mind.learn(&world.see()).unwrap();
    }
    // 1200 actions in rows of twenty, some of which follow each other.
    assert!((35..=85).contains(&rows), "{rows}");
}

#[test]
fn the_reason_of_a_choice_is_a_schema() {
    let mut mind = thinker(1_500, 4);
    mind.interrupt().unwrap();
    // What was learned from is explained no more: its moment is gone.
    assert_eq!(mind.explain(), None);
    let world = Corridor {
        at: 0,
        ..Corridor::START
    };
    mind.pursue(goal(&[(KEY, true)]), 20, &world.see()).unwrap();
    mind.idle(10_000);
    let choice = mind.choose(&world.see()).unwrap();
    assert_eq!(choice.action, TAKE);
    let why = mind.explain().unwrap();
    assert_eq!((why.motive, why.value), (Motive::Goal, choice.value));
    let said = SchemaText::parse("+p0/take/+key", &WORDS).unwrap();
    assert_eq!(why.schema.result, said.result);
    assert!(why.schema.context.positive().contains(ItemId(0)));
}

#[test]
fn whose_plans_come_true_is_led_by_them_and_earns_more() {
    let voices = MindConfig {
        heard: Heard::DEFAULT.without(Voice::Plans),
        ..MindConfig::DEFAULT
    };
    let (mut with, mut without) = (0, 0);
    for seed in 0..4 {
        let (mind, _, opened) =
            lived::<Reason<1, 7, 4, 32, 64, 64>>(MindConfig::DEFAULT, 1_500, seed);
        assert!(mind.reason().reliability() > 0.9);
        with += opened;
        without += lived::<()>(voices, 1_500, seed).2;
    }
    assert!(with > without, "{with} {without}");
    // A round takes eleven actions: back, take, on, unlock.
    assert!(with > 4 * 1_500 / 11 / 2, "{with}");
}

#[test]
fn without_reason_it_is_what_it_was_and_pursues_nothing() {
    let mut mind = Thoughtless::new();
    let now = Corridor::START.see();
    let anything = goal(&[(KEY, true)]);
    assert_eq!(mind.pursue(anything, 3, &now), Err(MindError::Unborn));
    mind.be_born(MindConfig::DEFAULT, [0.0; 7], 1).unwrap();
    assert_eq!(mind.pursue(anything, 3, &now), Err(MindError::NoReason));
    assert_eq!(
        (mind.pursuit(), mind.way(&now)),
        (Pursuit::Nothing, Way::Unknown)
    );
    // To hear plans or not makes no difference where nobody plans.
    let deaf = MindConfig {
        heard: Heard::DEFAULT.without(Voice::Plans),
        ..MindConfig::DEFAULT
    };
    let lives = [MindConfig::DEFAULT, deaf].map(|config| lived::<()>(config, 700, 5));
    let ends = lives.map(|(mind, world, opened)| (mind.size(), world.see(), opened));
    assert_eq!(ends[0], ends[1]);
    assert!(size_of::<Thinker>() > size_of::<Thoughtless>());
    // Only plans may speak, and there are none: habits do.
    let config = MindConfig {
        heard: Heard::only(Voice::Plans),
        ..MindConfig::DEFAULT
    };
    assert!(lived::<()>(config, 700, 5).2 > 0);
}

#[test]
fn what_is_pending_is_done_in_idle_hours() {
    let config = MindConfig {
        work: 0,
        ..MindConfig::DEFAULT
    };
    let mut mind = lived::<Reason<1, 7, 4, 32, 64, 64>>(config, 300, 6).0;
    assert!(mind.pending());
    let mut calls = 0;
    while mind.pending() {
        mind.idle(100);
        calls += 1;
        assert!(calls < 2_000);
    }
    assert!(calls > 10, "{calls}");
    assert!(!mind.reason().schemas().is_empty());
}

//! Goals in a small world, bounded work, unknown items, and how much schemas are forgiven.

use std::vec::Vec;

use super::super::pursuit::{Pursuit, Way};
use super::Reason;
use crate::num::Rng;
use crate::word::{ActionId, ItemId, ItemSet, ItemStates, SignedItems};

/// To eat one needs bread in hand at the table; the bread lies on the shelf. Items: shelf, middle,
/// table, bread, eaten, and two that blink; actions: left, right, take, eat.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Kitchen {
    at: u16,
    bread: bool,
    eaten: bool,
}

const ITEMS: u16 = 7;
const BREAD: ItemId = ItemId(3);
const EATEN: ItemId = ItemId(4);

type Cook = Reason<1, 7, 4, 32, 64, 128>;

impl Kitchen {
    const START: Self = Self {
        at: 1,
        bread: false,
        eaten: false,
    };

    fn act(&mut self, action: u32) {
        self.eaten = false;
        match action {
            0 => self.at = self.at.saturating_sub(1),
            1 => self.at = (self.at + 1).min(2),
            2 => self.bread |= self.at == 0,
            _ if self.at == 2 && self.bread => (self.bread, self.eaten) = (false, true),
            _ => {}
        }
    }

    fn see(self, blinking: bool, rng: &mut Rng) -> ItemStates<1> {
        let mut now = ItemStates::all_off(ITEMS);
        now.set(ItemId(self.at), Some(true)).unwrap();
        now.set(BREAD, Some(self.bread)).unwrap();
        now.set(EATEN, Some(self.eaten)).unwrap();
        if blinking {
            for item in 5..7 {
                now.set(ItemId(item), Some(rng.chance(0.5))).unwrap();
            }
        }
        now
    }
}

/// A life of random actions, of which a share slips and of whose readings a share is lost.
fn lived(actions: u32, slip: f32, lost: f32, units: u32, seed: u64) -> std::boxed::Box<Cook> {
    let mut reason = std::boxed::Box::new(Cook::new());
    reason.begin([0.0; 7], seed);
    let (mut world, mut rng) = (Kitchen::START, Rng::new(seed));
    let mut now = world.see(false, &mut rng);
    for _ in 0..actions {
        let action = rng.below(4);
        if !rng.chance(slip) {
            world.act(action);
        }
        let mut next = world.see(false, &mut rng);
        for item in 0..ITEMS {
            if rng.chance(lost) {
                next.set(ItemId(item), None).unwrap();
            }
        }
        reason.observe(&now, ActionId(action as u16), &next, 0.0);
        reason.work(units);
        now = next;
    }
    reason
}

fn on(item: ItemId) -> SignedItems<1> {
    let mut goal = SignedItems::EMPTY;
    goal.insert(item, true).unwrap();
    goal
}

/// Actions until the goal, or `None`.
fn steps_to(reason: &Cook, goal: SignedItems<1>, limit: u16) -> Option<u32> {
    let (mut reason, mut rng) = (reason.clone(), Rng::new(1));
    let mut world = Kitchen::START;
    let mut now = world.see(false, &mut rng);
    reason.interrupt();
    reason.pursue(goal, limit, &now);
    reason.work(10_000);
    let mut steps = 0;
    while reason.pursuit().is_underway() {
        let action = reason.prospects(&now).towards.unwrap_or(ActionId(0));
        world.act(action.0.into());
        let next = world.see(false, &mut rng);
        reason.observe(&now, action, &next, 0.0);
        reason.work(500);
        now = next;
        steps += 1;
    }
    (reason.pursuit() == Pursuit::Reached).then_some(steps)
}

#[test]
fn the_bread_is_fetched_before_it_is_eaten() {
    let reason = lived(600, 0.0, 0.0, 500, 1);
    // Left, take, right, right, eat.
    assert_eq!(steps_to(&reason, on(EATEN), 20), Some(5));
    let mut bare = on(BREAD);
    bare.insert(ItemId(2), true).unwrap();
    assert_eq!(steps_to(&reason, bare, 20), Some(4));
}

#[test]
fn a_goal_that_holds_is_reached_and_one_that_cannot_be_times_out() {
    let reason = lived(600, 0.0, 0.0, 500, 2);
    let mut held = SignedItems::EMPTY;
    held.insert(BREAD, false).unwrap();
    assert_eq!(steps_to(&reason, held, 20), Some(0));
    let mut both = on(ItemId(0));
    both.insert(ItemId(2), true).unwrap();
    assert_eq!(steps_to(&reason, both, 20), None);
    assert_eq!(steps_to(&reason, on(EATEN), 4), None);
    let mut reason = reason.clone();
    let now = Kitchen::START.see(false, &mut Rng::new(1));
    reason.pursue(on(EATEN), 3, &now);
    assert_eq!(reason.pursuit(), Pursuit::Underway { left: 3 });
    reason.work(10_000);
    assert_eq!(reason.prospects(&now).way, Way::Actions(5));
    reason.give_up();
    assert_eq!(reason.pursuit(), Pursuit::Nothing);
    assert_eq!(reason.prospects(&now).towards, None);
}

#[test]
fn from_a_state_never_met_schemas_know_the_way() {
    let mut reason = lived(800, 0.0, 0.0, 500, 11);
    // Nobody has just eaten and has bread.
    let odd = Kitchen {
        at: 0,
        bread: true,
        eaten: true,
    };
    let now = odd.see(false, &mut Rng::new(1));
    reason.interrupt();
    assert_eq!(reason.prospects(&now).values, [None; 4]);
    let states = reason.imagined();
    reason.pursue(on(ItemId(2)), 20, &now);
    assert_eq!(reason.imagined(), states + 1);
    reason.work(10_000);
    let prospects = reason.prospects(&now);
    assert_eq!(
        (prospects.towards, prospects.way),
        (Some(ActionId(1)), Way::Actions(2))
    );
    // It is believed what is perceived, not what the last action led to.
    reason.perceive(&Kitchen::START.see(false, &mut Rng::new(1)));
    assert_eq!(reason.imagined(), states + 1);
}

#[test]
fn what_arriving_brought_counts_and_not_what_items_promise() {
    // Item 0 is worth 1, but whoever takes the bread is given 5.
    let mut reason = Cook::new();
    let mut values = [0.0; 7];
    values[0] = 1.0;
    reason.begin(values, 12);
    let (mut world, mut rng) = (Kitchen::START, Rng::new(12));
    let mut now = world.see(false, &mut rng);
    for _ in 0..600 {
        let action = rng.below(4);
        let had = world.bread;
        world.act(action);
        let next = world.see(false, &mut rng);
        let taken = world.bread && !had;
        let reward = f32::from(u8::from(world.at == 0)) + if taken { 5.0 } else { 0.0 };
        reason.observe(&now, ActionId(action as u16), &next, reward);
        reason.work(500);
        now = next;
    }
    reason.work(50_000);
    let shelf = Kitchen {
        at: 0,
        ..Kitchen::START
    };
    let values = reason.prospects(&shelf.see(false, &mut rng)).values;
    assert!(values[2] > values[0], "{values:?}");
}

#[test]
fn what_is_worth_having_is_seen_from_afar() {
    let mut reason = Cook::new();
    let mut values = [0.0; 7];
    values[usize::from(EATEN.0)] = 1.0;
    reason.begin(values, 3);
    let (mut world, mut rng) = (Kitchen::START, Rng::new(3));
    let mut now = world.see(false, &mut rng);
    for _ in 0..800 {
        let action = rng.below(4);
        world.act(action);
        let next = world.see(false, &mut rng);
        let reward = f32::from(u8::from(world.eaten));
        reason.observe(&now, ActionId(action as u16), &next, reward);
        reason.work(500);
        now = next;
    }
    reason.work(20_000);
    let values = reason
        .prospects(&Kitchen::START.see(false, &mut rng))
        .values;
    let best = (0..4).max_by(|&a, &b| values[a].partial_cmp(&values[b]).unwrap());
    assert_eq!(best, Some(0), "{values:?}");
}

#[test]
fn an_unknown_item_costs_only_itself() {
    // What is predicted of the other items, and that the goal is reached, is as ever.
    let reason = lived(2_000, 0.0, 0.1, 500, 4);
    assert_eq!(steps_to(&reason, on(EATEN), 20), Some(5));
    let mut now = Kitchen::START.see(false, &mut Rng::new(1));
    now.set(BREAD, None).unwrap();
    let mut moved = ItemSet::EMPTY;
    moved.insert(ItemId(2)).unwrap();
    let mut clear = reason.clone();
    clear.interrupt();
    assert_eq!(clear.predict(&now, ActionId(1)), moved);
    // No schema has a trial by what nobody knows.
    let trials =
        |it: &Cook| -> Vec<u16> { it.schemas().iter().map(|it| it.activations()).collect() };
    let before = trials(&clear);
    clear.observe(&ItemStates::UNKNOWN, ActionId(1), &ItemStates::UNKNOWN, 0.0);
    assert_eq!(trials(&clear), before);
}

#[test]
fn what_is_unknown_now_is_believed_to_be_what_was_foreseen() {
    let mut reason = lived(1_000, 0.0, 0.0, 500, 5);
    let mut rng = Rng::new(1);
    let mut world = Kitchen::START;
    reason.interrupt();
    let mut now = world.see(false, &mut rng);
    for action in [0, 2] {
        world.act(action);
        let mut next = world.see(false, &mut rng);
        // The hand feels nothing any more.
        next.set(BREAD, None).unwrap();
        reason.observe(&now, ActionId(action as u16), &next, 0.0);
        now = next;
    }
    reason.pursue(on(EATEN), 20, &now);
    reason.work(10_000);
    // With the bread in hand it goes to the table; without it it would take it again.
    let prospects = reason.prospects(&now);
    assert_eq!(
        (prospects.towards, prospects.way),
        (Some(ActionId(1)), Way::Actions(3))
    );
}

#[test]
fn how_much_is_forgiven_is_learned_from_what_actions_do() {
    let exact = lived(2_000, 0.0, 0.0, 500, 6);
    let slips = lived(2_000, 0.1, 0.0, 500, 6);
    for action in 0..4 {
        assert_eq!(exact.noise(ActionId(action)), 0.0);
    }
    // Moving: always somewhere to go, so that every slip shows.
    let noise = slips.noise(ActionId(0));
    assert!((0.02..0.2).contains(&noise), "{noise}");
    assert!(exact.schemas().iter().all(|it| it.reliability() >= 1.0));
    assert_eq!(steps_to(&slips, on(EATEN), 20), Some(5));
}

#[test]
fn a_call_does_not_much_more_than_its_units() {
    let (mut reason, mut rng) = (Cook::new(), Rng::new(7));
    reason.begin([0.0; 7], 7);
    let mut world = Kitchen::START;
    let mut now = world.see(true, &mut rng);
    let mut all = 0;
    for _ in 0..2_000 {
        let action = rng.below(4);
        world.act(action);
        let next = world.see(true, &mut rng);
        reason.observe(&now, ActionId(action as u16), &next, 0.0);
        // A part of the work takes at most the table, or the last look at all items.
        let units = reason.work(200);
        assert!(units < 200 + 4 * 50 + 64, "{units}");
        all += units;
        now = next;
    }
    assert!(all > 100 * 2_000, "{all}");
}

#[test]
fn work_ends_when_nothing_is_left_to_do() {
    let mut reason = lived(1_000, 0.0, 0.0, 500, 8);
    let mut calls = 0;
    while reason.pending() {
        reason.work(1_000);
        calls += 1;
        assert!(calls < 1_000);
    }
    assert_eq!(reason.work(1_000), 0);
}

#[test]
fn the_same_seed_grows_the_same_schemas() {
    let [one, other] = [(); 2].map(|()| lived(700, 0.05, 0.05, 300, 9));
    assert_eq!(one.schemas(), other.schemas());
    assert_eq!(one.imagined(), other.imagined());
}

#[test]
fn what_it_does_not_have_teaches_nothing_and_breaks_nothing() {
    let mut reason = lived(200, 0.0, 0.0, 300, 10);
    let schemas = reason.schemas().to_vec();
    let everything = ItemStates::from_sets(&ItemSet::first(32), &ItemSet::EMPTY);
    reason.observe(&everything, ActionId(4), &ItemStates::UNKNOWN, 1.0);
    assert_eq!(reason.schemas(), schemas);
    reason.observe(&everything, ActionId(3), &everything, f32::NAN);
    reason.observe(
        &ItemStates::UNKNOWN,
        ActionId(3),
        &everything,
        f32::INFINITY,
    );
    reason.work(100_000);
    let prospects = reason.prospects(&everything);
    assert!(prospects.values.iter().flatten().all(|it| it.is_finite()));
    assert_eq!(
        reason.predict(&everything, ActionId(999)),
        ItemSet::first(32)
    );
    assert_eq!(Cook::new().work(1_000), 0);
}

#[test]
fn of_an_action_between_two_new_states_both_are_looked_at_first() {
    let mut reason = lived(400, 0.0, 0.0, 0, 3);
    let mut rng = Rng::new(1);
    reason.pursue(on(EATEN), 9, &Kitchen::START.see(false, &mut rng));
    // What was imagined is at its end.
    reason.front = (reason.imagined.len(), 0);
    let at = |at, blinks: [bool; 2]| {
        let mut now = ItemStates::<1>::all_off(ITEMS);
        now.set(ItemId(at), Some(true)).unwrap();
        for (item, on) in (5..).zip(blinks) {
            now.set(ItemId(item), Some(on)).unwrap();
        }
        now
    };
    let (from, to) = (at(0, [true, false]), at(1, [false, true]));
    let known = reason.imagined.len();
    reason.observe(&from, ActionId(1), &to, 0.0);
    assert_eq!(reason.imagined.len(), known + 2);
    assert_eq!(reason.front, (known, 0));
    let [here, there] = [from, to].map(|it| reason.imagined.find(it.on()).unwrap());
    assert_eq!((here, there), (known, known + 1));
    // Where only the end is new it is looked at.
    let again = at(2, [true, true]);
    reason.observe(&to, ActionId(1), &again, 0.0);
    assert_eq!(reason.front, (known + 2, 0));
}

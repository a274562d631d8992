//! What `brain!` says and makes, as far as it compiles; what must not stands in its documentation.

use super::message::Message;

#[test]
fn the_message_has_the_bytes_as_they_are_written() {
    for (takes, text) in [
        (9, "9"),
        (1000, "1_000"),
        (33_024, "33_024"),
        (1_204_567, "1_204_567"),
    ] {
        let expected = std::format!(
            "the brain takes {text} bytes, and `ram` allows 0: allow more, or give it less"
        );
        assert_eq!(Message::of_ram(takes, 0).as_str(), expected);
    }
}

crate::brain! {
    /// The keys in another order, and all of them.
    #[allow(dead_code, unreachable_pub)]
    mod shuffled {
        ram: 9_000,
        beliefs: 8,
        maps: 2 x 2 of bytes,
        values: [gold = 2.0, silver = 1.0],
        schemas: 16,
        synthetic: 4,
        actions: [dig],
        patterns: 16,
        items: [earth, silver, gold],
        safe: dig,
    }
}

#[test]
fn the_keys_of_a_robot_may_stand_in_any_order() {
    let mut brain = shuffled::brain();
    shuffled::be_born(&mut brain, crate::AgentConfig::FORAGER_LEVEL2, 1).unwrap();
    let worth = |item: shuffled::Item| brain.knowledge().inherent_value(item.id());
    assert_eq!(worth(shuffled::Item::gold), 2.0);
    assert_eq!(worth(shuffled::Item::silver), 1.0);
    assert_eq!(worth(shuffled::Item::earth), 0.0);
    assert_eq!(shuffled::SAFE, shuffled::Action::dig);
    let actions: std::vec::Vec<_> = (0..2)
        .map(|id| shuffled::Action::of(crate::ActionId(id)))
        .collect();
    assert_eq!(actions, [Some(shuffled::Action::dig), None]);
}

crate::brain! {
    /// The one learner, with harm and in another order.
    #[allow(dead_code, unreachable_pub)]
    mod one {
        samples: 100,
        values: [hot = -2.5, gold = 1.0],
        ram: 30_000,
        actions: [dig, leave],
        items: [earth, gold, hot],
        safe: leave,
    }
}

crate::brain! {
    /// One that tells more situations apart than it remembers.
    #[allow(dead_code, unreachable_pub)]
    mod two {
        items: [earth, gold], actions: [dig, leave], values: [gold = 1.0],
        states: 200, samples: 100, ram: 40_000,
    }
}

#[test]
fn states_say_how_many_situations_are_told_apart() {
    type Expected = crate::forest::Mind<1, 2, 2, 7, 4, 200, 200, 800>;
    let _: &Expected = &two::brain();
    let mut brain = two::brain();
    two::be_born(&mut brain, crate::MindConfig::DEFAULT, 1).unwrap();
    brain.revalue(two::Item::earth, -1.0).unwrap();
    assert_eq!(brain.value(two::Item::earth.id()), -1.0);
    assert!(!brain.health().cramped);
}

#[test]
fn samples_make_the_one_learner_with_capacities_in_proportion() {
    assert_eq!(one::VALUES, [0.0, 1.0, -2.5]);
    type Expected = crate::forest::Mind<1, 3, 2, 7, 4, 64, 64, 256>;
    let mut brain = one::brain();
    let _: &Expected = &brain;
    assert_eq!(one::RAM, size_of::<Expected>());
    one::be_born(&mut brain, crate::MindConfig::DEFAULT, 1).unwrap();
    let now = one::percept(|item| item == one::Item::gold);
    let choice = brain.choose(&now).unwrap();
    assert!(one::ACTIONS.contains(&choice.action));
    assert_eq!(brain.learn(&now).unwrap().reward, 1.0);
}

#[test]
fn a_percept_asks_for_every_item_and_unknown_must_be_said() {
    use one::Item;
    let now = one::percept(|item| match item {
        Item::earth => Some(true),
        Item::gold => Some(false),
        Item::hot => None,
    });
    let states = [Item::earth, Item::gold, Item::hot].map(|item| now.get(item));
    assert_eq!(states, [Some(true), Some(false), None]);
    // By name: what is not named is off, and unknown only when said.
    let named = one::Percept::of(&[Item::earth]);
    assert_eq!(named.with(Item::hot, None), now);
    assert_eq!(named.get(Item::hot), Some(false));
    assert_eq!(one::Percept::from(*now.states()), now);
}

#[test]
fn a_robot_knows_a_safe_action_for_when_its_brain_cannot_choose() {
    let (mut brain, now) = (one::brain(), one::Percept::UNKNOWN);
    assert_eq!(brain.choose_or_safe(&now), one::SAFE);
    assert_eq!(one::SAFE, one::Action::leave);
    one::be_born(&mut brain, crate::MindConfig::DEFAULT, 1).unwrap();
    let dug = (0..50).any(|_| brain.choose_or_safe(&now) == one::Action::dig);
    assert!(dug, "a brain that can choose is asked");
}

#[test]
fn what_is_said_in_names_is_what_the_mind_is_told() {
    use one::{Action, Item};
    let mut brain = one::brain();
    one::be_born(&mut brain, crate::MindConfig::DEFAULT, 5).unwrap();
    let mut named_twin = brain.clone();
    let twin: &mut one::Mind = &mut named_twin;
    for step in 0..300_u32 {
        let now = one::percept(|item| step % 3 == item as u32);
        let choice = brain.choose(&now).unwrap();
        let same = twin.choose(now.states()).unwrap();
        assert_eq!(
            (choice.action.id(), choice.value),
            (same.action, same.value)
        );
        let taught = brain.learn_with(&now, 0.5).unwrap();
        assert_eq!(twin.learn_with(now.states(), 0.5), Ok(taught));
        let seen = one::Percept::of(&[Item::gold]);
        let taught = brain.observe(&now, Action::dig, &seen).unwrap();
        let action = Action::dig.id();
        assert_eq!(
            twin.observe(now.states(), action, seen.states()),
            Ok(taught)
        );
    }
    // Only what is allowed is chosen, also when nothing is.
    let now = one::Percept::UNKNOWN;
    for _ in 0..30 {
        let choice = brain.choose_among(&now, &[Action::leave]).unwrap();
        assert_eq!(choice.action, Action::leave);
    }
    let nothing = brain.choose_among(&now, &[]);
    assert_eq!(nothing, Err(crate::forest::MindError::NothingAllowed));
}

crate::brain! {
    /// A corridor of four places, and a robot that plans.
    #[allow(dead_code, unreachable_pub)]
    mod planner {
        items: [first, second, third, fourth],
        actions: [back, on],
        values: [fourth = 1.0],
        samples: 64,
        imagines: 32,
        ram: 40_000,
    }
}

#[test]
fn a_robot_that_imagines_pursues_a_goal_which_is_worth_nothing() {
    use crate::reason::Pursuit;
    use planner::{Action, Item};
    let mut brain = planner::brain();
    planner::be_born(&mut brain, crate::MindConfig::DEFAULT, 1).unwrap();
    let sense = |place: usize| planner::percept(|item| item as usize == place);
    let mut place = 0;
    let mut live = |brain: &mut planner::Brain| {
        let choice = brain.choose(&sense(place)).unwrap();
        place = match choice.action {
            Action::on => (place + 1).min(3),
            Action::back => place.saturating_sub(1),
        };
        brain.learn(&sense(place)).unwrap();
        place
    };
    for _ in 0..400 {
        live(&mut brain);
    }
    brain.act().unwrap();
    // Now it stays at the fourth place; the first is worth nothing, and is reached all the same.
    brain.pursue(&[Item::first], &[], 50, &sense(3)).unwrap();
    let reached = (0..50).any(|_| {
        live(&mut brain);
        brain.pursuit() == Pursuit::Reached
    });
    assert!(reached, "{:?}", brain.pursuit());
}

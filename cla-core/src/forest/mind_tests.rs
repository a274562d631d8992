//! Whole lives in small worlds: what the learner finds, avoids, refuses and keeps apart.

use super::{Actions, Heard, Mind, MindConfig, MindError, Voice};
use crate::forest::{Feature, Motive};
use crate::num::Rng;
use crate::word::{ActionId, ItemId, ItemStates};
use std::boxed::Box;

type Small = Mind<1, 8, 3, 64, 48, 64, 64, 256>;

fn born(values: &[(u16, f32)], seed: u64) -> std::boxed::Box<Small> {
    let mut all = [0.0; 8];
    for &(item, value) in values {
        all[usize::from(item)] = value;
    }
    let mut mind = std::boxed::Box::new(Small::new());
    mind.be_born(MindConfig::DEFAULT, all, seed).unwrap();
    mind
}

fn at(place: u16) -> ItemStates<1> {
    let mut now = ItemStates::all_off(8);
    now.set(ItemId(place), Some(true)).unwrap();
    now
}

/// Five places in a row: action 0 leads back, 1 leads on, 2 stays; at the last place item 5 is on.
fn step(place: u16, action: ActionId) -> u16 {
    match action.0 {
        0 => place.saturating_sub(1),
        1 => (place + 1).min(5),
        _ => place,
    }
}

/// Lives in the corridor, thrown back when it arrives; answers how often it arrived.
fn corridor(mind: &mut Small, actions: u32) -> u32 {
    let (mut place, mut arrived) = (0, 0);
    for _ in 0..actions {
        let choice = mind.choose(&at(place)).unwrap();
        place = step(place, choice.action);
        mind.learn(&at(place)).unwrap();
        if place == 5 {
            arrived += 1;
            mind.interrupt().unwrap();
            place = 0;
        }
    }
    arrived
}

#[test]
fn a_delayed_reward_is_found_and_walked_to_without_detours() {
    for seed in 0..5 {
        let mut mind = born(&[(5, 10.0)], seed);
        corridor(&mut mind, 3_000);
        mind.act().unwrap();
        let arrived = corridor(&mut mind, 500);
        assert!(arrived >= 95, "seed {seed}: {arrived} of 100");
    }
}

#[test]
fn the_same_seed_lives_the_same_life_and_another_seed_another() {
    let lives = |seed| {
        let mut mind = born(&[(5, 10.0)], seed);
        let mut deeds = std::vec::Vec::new();
        let mut place = 0;
        for _ in 0..600 {
            let choice = mind.choose(&at(place)).unwrap();
            deeds.push((choice.action, choice.value.to_bits()));
            place = step(place, choice.action) % 5;
            mind.learn(&at(place)).unwrap();
        }
        deeds
    };
    assert_eq!(lives(3), lives(3));
    assert_ne!(lives(3), lives(4));
}

#[test]
fn harm_is_avoided() {
    // Action 1 brings what item 6 means, action 0 harm, action 2 nothing.
    let mut mind = born(&[(6, 1.0), (7, -1.0)], 2);
    let mut harmed = [0, 0];
    for harmed in &mut harmed {
        for _ in 0..1_000 {
            let choice = mind.choose(&at(0)).unwrap();
            let mut after = at(0);
            let item = [7, 6, 1][usize::from(choice.action.0)];
            after.set(ItemId(item), Some(true)).unwrap();
            let taught = mind.learn(&after).unwrap();
            assert_eq!(
                taught.reward,
                [-1.0, 1.0, 0.0][usize::from(choice.action.0)]
            );
            *harmed += u32::from(choice.action == ActionId(0));
        }
        mind.act().unwrap();
    }
    assert!(harmed[0] > 5 && harmed[1] <= 5, "{harmed:?}");
}

#[test]
fn where_everything_harms_it_does_what_harms_least() {
    let mut mind = born(&[], 6);
    let mut least = 0;
    for step in 0..2_000 {
        if step == 1_000 {
            mind.act().unwrap();
        }
        let choice = mind.choose(&at(0)).unwrap();
        let reward = [-3.0, -1.0, -2.0][usize::from(choice.action.0)];
        mind.learn_with(&at(0), reward).unwrap();
        least += u32::from(step >= 1_000 && choice.action == ActionId(1));
    }
    assert!(least > 950, "{least}");
}

#[test]
fn nothing_is_learned_across_an_interruption() {
    // Place 1 is left by interruption, and the next episode begins beside a reward.
    let lives = |interrupted: bool| {
        // Trees alone: the constant of habits is worth something everywhere.
        let trees = MindConfig {
            heard: Heard::only(Voice::Trees),
            ..MindConfig::DEFAULT
        };
        let mut mind = born(&[(5, 10.0)], 8);
        mind.be_born(trees, [0.0, 0.0, 0.0, 0.0, 0.0, 10.0, 0.0, 0.0], 8)
            .unwrap();
        for _ in 0..300 {
            mind.choose(&at(1)).unwrap();
            mind.learn(&at(1)).unwrap();
            if interrupted {
                mind.interrupt().unwrap();
            }
            mind.choose(&at(4)).unwrap();
            mind.learn(&at(5)).unwrap();
            mind.interrupt().unwrap();
        }
        mind.act().unwrap();
        mind.choose(&at(1)).unwrap().value
    };
    let (apart, joined) = (lives(true), lives(false));
    assert!(joined > 4.0, "{joined}");
    assert!(apart.abs() < 0.25 * joined, "{apart}");
}

#[test]
fn only_what_is_allowed_is_chosen() {
    let mut mind = born(&[(5, 10.0)], 1);
    corridor(&mut mind, 2_000);
    let not_on = Actions::ALL.without(ActionId(1));
    for _ in 0..200 {
        let choice = mind.choose_among(&at(4), not_on).unwrap();
        assert_ne!(choice.action, ActionId(1));
        mind.learn(&at(4)).unwrap();
    }
    let nothing = mind.choose_among(&at(4), Actions::NONE);
    assert_eq!(nothing, Err(MindError::NothingAllowed));
    // Action 3 does not exist.
    let none = mind.choose_among(&at(4), Actions::NONE.with(ActionId(3)));
    assert_eq!(none, Err(MindError::NothingAllowed));
}

#[test]
fn a_teacher_is_learned_from_without_an_own_action() {
    let mut mind = born(&[(5, 10.0)], 5);
    let mut rng = Rng::new(21);
    for _ in 0..200 {
        let mut place = 0;
        while place < 5 {
            let action = ActionId(if rng.chance(0.8) {
                1
            } else {
                rng.below(3) as u16
            });
            let next = step(place, action);
            mind.observe(&at(place), action, &at(next)).unwrap();
            place = next;
        }
        mind.interrupt().unwrap();
    }
    mind.act().unwrap();
    let arrived = corridor(&mut mind, 100);
    assert!(arrived >= 17, "{arrived} of 20");
    let beyond = mind.observe(&at(0), ActionId(3), &at(0));
    assert_eq!(beyond, Err(MindError::NoSuchAction(ActionId(3))));
}

#[test]
fn what_cannot_be_is_refused_and_teaches_nothing() {
    let mut mind = Small::new();
    assert_eq!(mind.choose(&at(0)), Err(MindError::Unborn));
    assert_eq!(mind.learn(&at(0)), Err(MindError::Unborn));
    assert_eq!(mind.interrupt(), Err(MindError::Unborn));
    assert_eq!(mind.act(), Err(MindError::Unborn));
    assert!(!mind.pending() && !mind.idle(1_000));
    let mut values = [0.0; 8];
    values[0] = f32::NAN;
    assert_eq!(
        mind.be_born(MindConfig::DEFAULT, values, 1),
        Err(MindError::Reward)
    );
    let mut mind = born(&[], 1);
    assert_eq!(mind.learn(&at(0)), Err(MindError::NothingChosen));
    mind.choose(&at(0)).unwrap();
    for reward in [f32::NAN, f32::INFINITY, -f32::INFINITY, 1.1e4, -1.1e4] {
        assert_eq!(mind.learn_with(&at(0), reward), Err(MindError::Reward));
    }
    assert_eq!(mind.size().0, 0);
    mind.learn_with(&at(0), 1.0e4).unwrap();
    assert_eq!(mind.size().0, 1);
    assert_eq!(mind.learn(&at(0)), Err(MindError::NothingChosen));
}

#[test]
fn the_greatest_rewards_and_harms_give_finite_values_for_ever() {
    let mut mind = born(&[], 3);
    let mut rng = Rng::new(31);
    for _ in 0..5_000 {
        let place = rng.below(5) as u16;
        let choice = mind.choose(&at(place)).unwrap();
        assert!(choice.value.is_finite());
        let reward = if rng.chance(0.5) { 1.0e4 } else { -1.0e4 };
        mind.learn_with(&at(place), reward).unwrap();
    }
}

#[test]
fn work_is_pending_while_trees_grow_and_idle_time_ends_it() {
    let mut mind = std::boxed::Box::new(Small::new());
    let slow = MindConfig {
        work: 10,
        ..MindConfig::DEFAULT
    };
    mind.be_born(slow, [0.0; 8], 1).unwrap();
    for place in 0..200 {
        mind.choose(&at(place % 5)).unwrap();
        mind.learn_with(&at(0), f32::from(place % 3)).unwrap();
    }
    assert!(mind.pending());
    let before = mind.size().2;
    mind.idle(1_000_000);
    assert!(!mind.pending());
    assert!(mind.size().2 > before);
}

#[test]
fn leaves_are_shown_as_contexts() {
    let mut mind = born(&[(5, 10.0)], 1);
    corridor(&mut mind, 2_000);
    let mut best: Option<(f32, std::vec::Vec<(Feature, bool)>)> = None;
    mind.contexts(ActionId(1), |context, value| {
        if best.as_ref().is_none_or(|(most, _)| value > *most) {
            best = Some((value, context.to_vec()));
        }
    });
    // Going on is worth most at the last place.
    let (_, context) = best.unwrap();
    assert!(
        context.contains(&(Feature::Now(ItemId(4)), true)),
        "{context:?}"
    );
}

#[test]
fn it_escapes_only_where_something_was_earned_before() {
    let escapes = |earns: bool| {
        let mut mind = born(&[(5, 10.0)], 9);
        corridor(&mut mind, if earns { 1_000 } else { 0 });
        mind.act().unwrap();
        let mut escapes = 0;
        for _ in 0..1_000 {
            let choice = mind.choose(&at(0)).unwrap();
            escapes += u32::from(choice.motive == Motive::Escape);
            mind.learn_with(&at(0), -0.1).unwrap();
        }
        escapes
    };
    assert!(escapes(true) >= 50);
    assert_eq!(escapes(false), 0);
}

/// A life in which rewards come for so long and then stay away until it doubts; the mind at that moment.
fn doubting(config: MindConfig) -> std::boxed::Box<Small> {
    let mut mind = born(&[], 7);
    mind.be_born(config, [0.0; 8], 7).unwrap();
    for step in 0..3_000 {
        let choice = mind.choose(&at(0)).unwrap();
        let brings = step < 1_000 && choice.action == ActionId(1);
        mind.learn_with(&at(0), f32::from(u8::from(brings)))
            .unwrap();
        if mind.doubts() {
            return mind;
        }
    }
    panic!("it never doubts");
}

#[test]
fn in_a_doubt_those_lead_who_may_lead_then() {
    let after = |heard, heard_doubting| {
        let mut mind = doubting(MindConfig {
            heard,
            heard_doubting,
            doubt_lasts: 700,
            ..MindConfig::DEFAULT
        });
        assert_eq!(mind.alarms(), 1);
        let (mut led, mut actions) = (std::vec::Vec::new(), 0);
        while mind.doubts() {
            let choice = mind.choose(&at(0)).unwrap();
            if let Motive::Voice(voice) = choice.motive
                && !led.contains(&voice)
            {
                led.push(voice);
            }
            mind.learn_with(&at(0), 0.0).unwrap();
            actions += 1;
        }
        assert_eq!(actions, 700);
        led
    };
    let habits = Heard::only(Voice::Habits);
    assert_eq!(after(Heard::DEFAULT, habits), [Voice::Habits]);
    assert!(after(Heard::DEFAULT, Heard::DEFAULT).len() > 1);
    // Who may never lead does not lead in a doubt either.
    let trees = Heard::only(Voice::Trees);
    assert_eq!(after(trees, habits), [Voice::Trees]);
}

#[test]
fn an_alarm_fades_habits_and_what_the_model_counted() {
    // What a voice says some actions after the alarm.
    let said = |voice, change: fn(&mut MindConfig)| {
        let mut config = MindConfig {
            heard: Heard::only(voice),
            exploring: 0.0,
            patience: u16::MAX,
            replayed: 0,
            ..MindConfig::DEFAULT
        };
        change(&mut config);
        let mut mind = doubting(config);
        for _ in 0..10 {
            mind.choose(&at(0)).unwrap();
            mind.learn(&at(0)).unwrap();
        }
        mind.choose(&at(0)).unwrap().value
    };
    let keeps = said(Voice::Habits, |it| it.kept_doubting = 1.0);
    let fades = said(Voice::Habits, |it| it.kept_doubting = 0.0);
    assert!(keeps > 1.0 && fades < 0.5 * keeps, "{keeps} {fades}");
    let sure = said(Voice::Model, |it| it.trials_doubting = 1.0e6);
    let unsure = said(Voice::Model, |it| it.trials_doubting = 0.0);
    assert!(unsure < 0.75 * sure, "{sure} {unsure}");
}

#[test]
fn an_interruption_ends_what_habits_and_model_expect() {
    // The step before the end brings nothing; what comes after the end is another episode.
    let value = |voice, interrupted: bool| {
        let mut mind = born(&[], 8);
        let config = MindConfig {
            heard: Heard::only(voice),
            replayed: 0,
            ..MindConfig::DEFAULT
        };
        mind.be_born(config, [0.0; 8], 8).unwrap();
        for _ in 0..400 {
            mind.choose(&at(1)).unwrap();
            mind.learn(&at(1)).unwrap();
            if interrupted {
                mind.interrupt().unwrap();
            }
            mind.choose(&at(4)).unwrap();
            mind.learn_with(&at(5), 10.0).unwrap();
            mind.interrupt().unwrap();
        }
        mind.act().unwrap();
        mind.choose(&at(1)).unwrap().value
    };
    for voice in [Voice::Habits, Voice::Model] {
        let (apart, joined) = (value(voice, true), value(voice, false));
        assert!(joined > 4.0, "{voice:?} {joined}");
        assert!(apart < 0.6 * joined, "{voice:?} {apart} {joined}");
    }
}

/// Seven places in a row, from the middle to either end, where items 0 and 6 are on, and back from
/// there by any action, or thrown back; answers how often each end was reached.
fn ends(mind: &mut Small, actions: u32, thrown_back: bool) -> (u32, u32) {
    let (mut place, mut was_at_end, mut left, mut right) = (3, false, 0, 0);
    for _ in 0..actions {
        let choice = mind.choose(&at(place)).unwrap();
        place = match choice.action.0 {
            0 => place.max(1) - 1,
            1 => (place + 1).min(6),
            _ => place,
        };
        if was_at_end {
            place = 3;
        }
        mind.learn(&at(place)).unwrap();
        was_at_end = place == 0 || place == 6;
        left += u32::from(place == 0);
        right += u32::from(place == 6);
        if was_at_end && thrown_back {
            mind.interrupt().unwrap();
            (place, was_at_end) = (3, false);
        }
    }
    (left, right)
}

/// Left and right ends that six minds reach in 300 actions after they lived for so long and what is
/// worth having has changed; and how often six newborns reach the right one. Before, they go to the left.
fn changed(lived: u32, thrown_back: bool) -> ((u32, u32), u32) {
    let (mut before, mut after, mut newborns) = ((0, 0), (0, 0), 0);
    for seed in 0..6 {
        let mut mind = born(&[(0, 10.0), (6, 1.0)], seed);
        let (left, right) = ends(&mut mind, lived, thrown_back);
        before = (before.0 + left, before.1 + right);
        mind.act().unwrap();
        mind.revalue(ItemId(0), -5.0).unwrap();
        mind.revalue(ItemId(6), 10.0).unwrap();
        let (left, right) = ends(&mut mind, 300, thrown_back);
        after = (after.0 + left, after.1 + right);
        let mut newborn = born(&[(0, -5.0), (6, 10.0)], seed);
        newborns += ends(&mut newborn, 300, thrown_back).1;
    }
    std::println!("{lived} {thrown_back} {before:?} {after:?} {newborns}");
    assert!(before.0 > 4 * before.1, "{before:?}");
    (after, newborns)
}

#[test]
fn what_is_worth_having_may_change_in_mid_life() {
    for thrown_back in [false, true] {
        // What it remembers of the way is worth something.
        let (after, newborns) = changed(800, thrown_back);
        assert!(
            after.1 > newborns && after.1 > 8 * after.0,
            "{after:?} {newborns}"
        );
        // Where it remembers nothing it looks for a way, as a newborn does.
        let (after, newborns) = changed(3_000, thrown_back);
        assert!(
            10 * after.1 > 9 * newborns && after.1 > 8 * after.0,
            "{after:?} {newborns}"
        );
    }
}

#[test]
fn who_looks_for_a_new_value_does_not_take_that_for_the_usual_wait() {
    // Nothing is worth anything at first, and so nothing that is remembered brings anything later.
    let mut mind = born(&[(0, -1.0)], 4);
    corridor(&mut mind, 300);
    mind.act().unwrap();
    mind.revalue(ItemId(5), 10.0).unwrap();
    let escapes = (0..10).filter(|_| {
        let choice = mind.choose(&at(3)).unwrap();
        mind.learn(&at(3)).unwrap();
        choice.motive == Motive::Escape
    });
    assert!(escapes.count() >= 8);
    assert!(corridor(&mut mind, 2_000) > 100);
    assert!(mind.wait < 30.0, "{}", mind.wait);
}

#[test]
fn nobody_sets_out_where_nothing_is_worth_having() {
    let mut mind = born(&[(0, -1.0), (5, 10.0)], 4);
    corridor(&mut mind, 600);
    mind.act().unwrap();
    let (wait, earned) = (mind.wait, mind.earned);
    // Another harm says nothing of how long rewards take.
    mind.revalue(ItemId(0), -5.0).unwrap();
    assert_eq!((mind.wait, mind.earned, mind.burst), (wait, earned, 0));
    assert!(wait > 0.0 && earned > 1);
    mind.revalue(ItemId(5), -1.0).unwrap();
    assert_eq!(mind.burst, 0);
}

#[test]
fn a_value_that_cannot_be_changes_nothing() {
    let mut mind = Small::new();
    assert_eq!(mind.revalue(ItemId(0), 1.0), Err(MindError::Unborn));
    let mut mind = born(&[(5, 10.0)], 1);
    corridor(&mut mind, 100);
    let mut same = mind.clone();
    assert_eq!(
        mind.revalue(ItemId(8), 1.0),
        Err(MindError::NoSuchItem(ItemId(8)))
    );
    assert_eq!(mind.revalue(ItemId(5), f32::NAN), Err(MindError::Reward));
    assert_eq!(corridor(&mut mind, 500), corridor(&mut same, 500));
    assert_eq!(mind.value(ItemId(5)), 10.0);
}

#[test]
fn habits_say_what_is_remembered_of_a_new_value_before_anything_is_earned() {
    let mut mind = Box::new(Small::new());
    let heard = Heard::only(Voice::Habits);
    let config = MindConfig {
        heard,
        heard_doubting: heard,
        ..MindConfig::DEFAULT
    };
    let mut values = [0.0; 8];
    values[0] = 10.0;
    mind.be_born(config, values, 3).unwrap();
    ends(&mut mind, 2_000, false);
    for _ in 0..20 {
        mind.observe(&at(5), ActionId(1), &at(6)).unwrap();
        mind.observe(&at(6), ActionId(2), &at(5)).unwrap();
    }
    mind.act().unwrap();
    mind.revalue(ItemId(6), 20.0).unwrap();
    mind.revalue(ItemId(0), 0.0).unwrap();
    // Nothing is earned from now on: the robot is held in the middle.
    let mut most = 0.0_f32;
    for _ in 0..300 {
        most = most.max(mind.choose(&at(5)).unwrap().value);
        mind.learn(&at(3)).unwrap();
        mind.interrupt().unwrap();
    }
    assert!(most > 2.0, "{most}");
}

#[test]
fn the_value_that_there_is_changes_nothing() {
    let mut mind = born(&[(5, 10.0)], 2);
    corridor(&mut mind, 600);
    let mut same = mind.clone();
    mind.revalue(ItemId(5), 10.0).unwrap();
    assert_eq!(corridor(&mut mind, 600), corridor(&mut same, 600));
    assert_eq!(mind.filled(), same.filled());
}

#[test]
fn a_mind_that_knows_nothing_any_more_is_not_full() {
    let mut mind = born(&[(5, 10.0)], 2);
    corridor(&mut mind, 600);
    assert!(mind.filled().links.0 > 5);
    mind.revalue(ItemId(5), 1.0).unwrap();
    let filled = mind.filled();
    assert_eq!((filled.states.0, filled.links.0), (0, 0));
}

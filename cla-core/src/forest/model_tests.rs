//! The model against chains whose values are known, changing worlds and full tables.

use super::{Model, ModelRates, State};
use crate::num::Rng;

const RATES: ModelRates = ModelRates {
    discount: 0.9,
    remembered: 100.0,
    prior: 2.0,
    felt: 0.0,
};

type Small = Model<2, 64, 128>;

/// A state whose percept tells everything.
const fn state(number: u32) -> State {
    State {
        step: number.wrapping_mul(0x9E37_79B1).wrapping_add(1),
        percept: number.wrapping_mul(0x85EB_CA77).wrapping_add(2),
    }
}

fn settle<const S: usize, const L: usize>(model: &mut Model<2, S, L>, rates: &ModelRates) {
    for _ in 0..60 {
        model.spread(100_000, rates);
    }
}

#[test]
fn values_are_those_of_the_chain_that_was_lived() {
    let mut model = Small::new();
    // 0 → 1 → 2 by action 1, the last step brings 10 and ends; action 0 stays and costs 1.
    for _ in 0..200 {
        for place in 0..3 {
            model.learn(state(place), 0, -1.0, Some(state(place)), &RATES);
            let to = (place < 2).then(|| state(place + 1));
            let reward = if place == 2 { 10.0 } else { 0.0 };
            model.learn(state(place), 1, reward, to, &RATES);
        }
    }
    settle(&mut model, &RATES);
    for (place, wanted) in [(2, 10.0), (1, 9.0), (0, 8.1)] {
        let [stay, on] = model.values(state(place));
        assert!((on - wanted).abs() < 0.15, "{place}: {on}");
        let wanted = 0.9 * wanted - 1.0;
        assert!((stay - wanted).abs() < 0.3, "{place}: {stay}");
    }
    assert_eq!(model.given_up(), 0);
}

#[test]
fn an_outcome_counts_as_often_as_it_came_and_recent_ones_more() {
    let mut model = Small::new();
    let mut rng = Rng::new(5);
    let bring = |model: &mut Small, share: f32, times: u32, rng: &mut Rng| {
        for _ in 0..times {
            let (to, reward) = if rng.chance(share) {
                (1, 1.0)
            } else {
                (2, 0.0)
            };
            model.learn(state(0), 0, reward, Some(state(to)), &RATES);
        }
    };
    bring(&mut model, 0.8, 400, &mut rng);
    let before = model.values(state(0))[0];
    assert!((before - 0.8).abs() < 0.1, "{before}");
    // Another world: 300 trials are three times what is remembered.
    bring(&mut model, 0.1, 300, &mut rng);
    let after = model.values(state(0))[0];
    assert!((after - 0.1).abs() < 0.1, "{after}");
}

#[test]
fn a_step_that_is_hardly_known_is_judged_by_its_percept() {
    let mut model = Small::new();
    let percept = state(0).percept;
    for _ in 0..50 {
        model.learn(state(0), 1, 4.0, None, &RATES);
    }
    let new = State { step: 99, percept };
    let [_, value] = model.values(new);
    assert!((value - 4.0).abs() < 0.1, "{value}");
    // One trial that brought nothing weighs against two of the percept alone.
    model.learn(new, 1, 0.0, None, &RATES);
    let [_, value] = model.values(new);
    assert!((2.3..2.8).contains(&value), "{value}");
    // And many trials say it alone.
    for _ in 0..60 {
        model.learn(new, 1, 0.0, None, &RATES);
    }
    assert!(model.values(new)[1] < 0.2);
    assert_eq!(model.values(state(7)), [0.0; 2]);
}

#[test]
fn more_states_than_there_is_room_for_leave_those_that_are_met() {
    let mut model = Small::new();
    let mut rng = Rng::new(6);
    for _ in 0..20_000 {
        // One state in two is an old friend, the others are hardly ever met again.
        let number = if rng.chance(0.5) {
            3
        } else {
            rng.below(100_000)
        };
        let to = (number != 3).then(|| state(rng.below(100_000)));
        let reward = if number == 3 { 2.0 } else { 0.0 };
        model.learn(state(number), 0, reward, to, &RATES);
        model.spread(20, &RATES);
        assert!(
            model
                .values(state(number))
                .iter()
                .all(|value| value.is_finite())
        );
    }
    assert!(model.given_up() > 1_000);
    let [value, _] = model.values(state(3));
    assert!((value - 2.0).abs() < 0.1, "{value}");
}

#[test]
fn what_is_rarely_followed_gives_its_link_back() {
    // Every outcome is new, so each soon fades: a few hundred links are enough for ever.
    let mut model = Model::<2, 512, 300>::new();
    let rates = ModelRates {
        remembered: 10.0,
        ..RATES
    };
    for number in 1..50_000 {
        model.learn(state(0), 0, 1.0, Some(state(number % 200)), &rates);
    }
    assert_eq!(model.given_up(), 0);
    let [value, _] = model.values(state(0));
    assert!(value > 0.9, "{value}");
}

#[test]
fn what_was_felt_holds_back_what_could_be() {
    // The better action is hardly ever taken.
    let lived = |felt| {
        let rates = ModelRates { felt, ..RATES };
        let mut model = Small::new();
        for step in 0..2_000 {
            let action = u8::from(step % 50 == 0);
            model.learn(state(0), 0, 0.0, Some(state(1)), &rates);
            model.learn(state(1), action, f32::from(action), None, &rates);
        }
        settle(&mut model, &rates);
        model.values(state(0))[0]
    };
    let (could, mixed, was) = (lived(0.0), lived(0.5), lived(1.0));
    assert!((could - 0.9).abs() < 0.1, "{could}");
    assert!(was < 0.2, "{was}");
    assert!(mixed > was + 0.2 && mixed < could - 0.2, "{mixed}");
}

#[test]
fn spreading_stops_at_its_units() {
    let mut model = Small::new();
    for number in 0..20 {
        model.learn(state(number), 0, 1.0, Some(state(number + 1)), &RATES);
    }
    // A state costs a few units more at most.
    let done = model.spread(50, &RATES);
    assert!((50..60).contains(&done), "{done}");
    assert!(model.spread(0, &RATES) == 0);
}

#[test]
fn in_a_doubt_one_trial_of_the_new_weighs_what_all_the_old_do() {
    let lived = |doubts: bool| {
        let mut model = Small::new();
        for _ in 0..200 {
            model.learn(state(0), 0, 1.0, None, &RATES);
            model.learn(state(0), 0, 1.0, Some(state(1)), &RATES);
            model.learn(state(0), 1, -1.0, None, &RATES);
        }
        if doubts {
            let units = model.doubt(1.0);
            // Two actions of 64 states, and 128 links twice.
            assert_eq!(units, 64 * 2 / 4 + 2 * 128 / 3);
        }
        let before = model.values(state(0));
        model.learn(state(0), 0, 0.0, Some(state(2)), &RATES);
        (before, model.values(state(0)))
    };
    let ((before, sure), (same, doubting)) = (lived(false), lived(true));
    // What is believed stays, until something is lived.
    assert_eq!(before, same);
    assert!(sure[0] > 0.9, "{sure:?}");
    assert!((0.3..0.6).contains(&doubting[0]), "{doubting:?}");
    assert!(doubting[1] < 0.0, "{doubting:?}");
    // Few trials are not made more.
    let mut model = Small::new();
    model.learn(state(0), 0, 1.0, None, &RATES);
    model.doubt(3.0);
    model.learn(state(0), 0, 0.0, Some(state(2)), &RATES);
    assert!((0.3..0.6).contains(&model.values(state(0))[0]));
}

#[test]
fn a_state_without_a_number_takes_no_free_place() {
    let mut model = Small::new();
    let nothing = State {
        step: 0,
        percept: 0,
    };
    for _ in 0..3 {
        model.learn(nothing, 1, 1.0, Some(state(1)), &RATES);
        assert_eq!(model.audit(), 0);
    }
}

//! Habits: what they converge to, what bounds them, how traces and rows behave.

use super::{Rates, Sarsa, Scene, number, row};
use crate::num::Rng;
use crate::word::{ItemId, ItemSet};

const RATES: Rates = Rates {
    rate: 0.1,
    discount: 0.8,
    lambda: 0.5,
    replacing: false,
};

type Habits = Sarsa<1, 4, 2, 8>;

fn scene(items: &[u16], row: u16) -> Scene<1> {
    let mut on = ItemSet::EMPTY;
    for &item in items {
        on.insert(ItemId(item)).unwrap();
    }
    Scene {
        on,
        row,
        owner: row + 1,
    }
}

#[test]
fn what_leads_to_a_reward_at_the_end_is_worth_the_discounted_reward() {
    let mut habits = Habits::new();
    let (far, near) = (scene(&[0], 0), scene(&[1], 1));
    for _ in 0..2_000 {
        habits.feel(far, 0, 0.0, &RATES);
        habits.feel(near, 0, 5.0, &RATES);
        habits.end(&RATES);
    }
    let [worth, other] = habits.worth(&near, RATES.discount);
    assert!((worth - 5.0).abs() < 0.05, "{worth}");
    assert_eq!(other, 0.0);
    let [worth, _] = habits.worth(&far, RATES.discount);
    assert!((worth - 4.0).abs() < 0.05, "{worth}");
}

#[test]
fn worth_stays_within_what_can_be_earned_whatever_the_features_add_up_to() {
    let mut habits = Habits::new();
    let mut rng = Rng::new(4);
    for _ in 0..20_000 {
        let items: std::vec::Vec<u16> = (0..4).filter(|_| rng.chance(0.5)).collect();
        let reward = if rng.chance(0.5) { 3.0 } else { -1.0 };
        let action = rng.below(2) as u8;
        habits.feel(scene(&items, rng.below(8) as u16), action, reward, &RATES);
        for worth in habits.worth(&scene(&[0, 1, 2, 3], 0), RATES.discount) {
            // Rewards from −1 to 3, and a discount of .8: five times as much.
            assert!((-5.0001..=15.0001).contains(&worth), "{worth}");
        }
    }
}

/// How far the items of a deed move when the same items were on in the two deeds before a reward.
fn moved(replacing: bool) -> f32 {
    let rates = Rates {
        rate: 0.01,
        discount: 0.8,
        lambda: 0.5,
        replacing,
    };
    let mut habits = Habits::new();
    habits.feel(scene(&[2], 0), 1, 0.0, &rates);
    habits.feel(scene(&[2], 1), 1, 1.0, &rates);
    habits.end(&rates);
    // Without rows: only item and constant, which move alike.
    habits.worth(&scene(&[2], 7), rates.discount)[1] / 2.0
}

#[test]
fn traces_accumulate_and_replace_only_where_they_are_told_to() {
    // A deed that came twice moves by the rate, and by the faded rate for the first time.
    assert!(
        (moved(false) - 0.01 * (1.0 + 0.4)).abs() < 1e-6,
        "{}",
        moved(false)
    );
    assert!((moved(true) - 0.01).abs() < 1e-6, "{}", moved(true));
}

#[test]
fn forgotten_rows_leave_what_items_are_worth() {
    let mut habits = Habits::new();
    for _ in 0..200 {
        habits.feel(scene(&[3], 2), 0, 1.0, &RATES);
        habits.end(&RATES);
    }
    let with_row = habits.worth(&scene(&[3], 2), RATES.discount)[0];
    let without = habits.worth(&scene(&[3], 5), RATES.discount)[0];
    assert!(with_row > without && without > 0.5, "{with_row} {without}");
    habits.forget_rows();
    assert_eq!(habits.worth(&scene(&[3], 2), RATES.discount)[0], without);
}

#[test]
fn steps_that_differ_have_other_numbers_and_rows_are_filled_evenly() {
    let mut rows = [0; 8];
    let mut numbers = std::collections::BTreeSet::new();
    for step in 0..4_000_u16 {
        let set = |bits: u16| {
            let mut set = ItemSet::<1>::EMPTY;
            for bit in (0..10).filter(|bit| bits >> bit & 1 == 1) {
                set.insert(ItemId(bit)).unwrap();
            }
            set
        };
        let number = number(&set(step % 64), (step / 64 % 4) as u8, &set(step / 256));
        rows[usize::from(row(number, 8))] += 1;
        numbers.insert(number);
    }
    assert_eq!(numbers.len(), 4_000);
    // Five standard deviations of a binomial with n = 4000 and p = 1/8.
    assert!(
        rows.iter().all(|count| (395..=605).contains(count)),
        "{rows:?}"
    );
}

#[test]
fn rows_are_crowded_when_steps_find_them_taken() {
    let crowding = |owners: u16| {
        let mut habits = Habits::new();
        let mut rng = Rng::new(8);
        for _ in 0..4_000 {
            let mut scene = scene(&[0], 3);
            scene.owner = rng.below(u32::from(owners)) as u16;
            habits.feel(scene, 0, 0.0, &RATES);
        }
        habits.crowding()
    };
    assert!(crowding(1) < 0.01);
    assert!((crowding(2) - 0.5).abs() < 0.1);
    assert!(crowding(1000) > 0.9);
}

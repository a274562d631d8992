//! When the alarm rings, when it does not, and that a doubt ends.

use super::Doubt;
use crate::num::Rng;

/// Alarms of a life with these shares of rewarded actions, one after the other.
fn alarms(life: &[(f32, u32)], seed: u64) -> u32 {
    let (mut doubt, mut rng) = (Doubt::new(), Rng::new(seed));
    for &(share, actions) in life {
        for _ in 0..actions {
            doubt.notice(rng.chance(share), 800);
        }
    }
    doubt.alarms()
}

#[test]
fn rewards_that_stay_away_ring_and_rewards_as_ever_do_not() {
    let calm: u32 = (0..10).map(|seed| alarms(&[(0.1, 10_000)], seed)).sum();
    assert!(calm <= 3, "{calm}");
    for seed in 0..10 {
        assert!(alarms(&[(0.1, 3_000), (0.0, 400)], seed) >= 1, "{seed}");
        assert!(alarms(&[(0.1, 3_000), (0.02, 1_000)], seed) >= 1, "{seed}");
    }
}

#[test]
fn a_doubt_ends_and_what_became_usual_is_asked_for_no_more() {
    let (mut doubt, mut rng) = (Doubt::new(), Rng::new(1));
    for _ in 0..3_000 {
        doubt.notice(rng.chance(0.1), 800);
    }
    assert!(!doubt.lasts());
    let rang = (0..400).any(|_| doubt.notice(false, 800));
    assert!(rang && doubt.lasts());
    for _ in 0..20_000 {
        doubt.notice(false, 800);
    }
    let before = doubt.alarms();
    for _ in 0..20_000 {
        doubt.notice(false, 800);
    }
    assert!(!doubt.lasts());
    assert_eq!(doubt.alarms(), before);
}

#[test]
fn a_doubt_lasts_as_long_as_it_is_told() {
    for lasts in [1, 300] {
        let mut doubt = Doubt::new();
        for step in 0..1_000 {
            doubt.notice(step % 4 == 0, lasts);
        }
        while !doubt.notice(false, lasts) {
            assert!(!doubt.lasts());
        }
        let mut actions = 0;
        while doubt.lasts() {
            assert!(!doubt.notice(false, lasts));
            actions += 1;
        }
        assert_eq!(actions, lasts);
    }
}

#[test]
fn nobody_doubts_before_anything_is_usual() {
    assert_eq!(alarms(&[(0.0, 20_000)], 2), 0);
    assert_eq!(alarms(&[(1.0, 100), (0.0, 300)], 2), 0);
}

//! Who leads when voices earn differently, and when that changes.

use super::Voices;
use crate::num::Rng;

/// What each voice earns an action; answers the share of the later half that each has led.
fn shares(earns: [f32; 3], noise: f32, seed: u64) -> [f32; 3] {
    let (mut voices, mut rng) = (Voices::<3>::new(), Rng::new(seed));
    let mut led = [0.0; 3];
    for step in 0..20_000 {
        let leader = usize::from(voices.lead(50, 0.1, 0b111, &mut rng));
        voices.gather(earns[leader] + noise * (rng.unit() - 0.5));
        if step >= 10_000 {
            led[leader] += 1.0 / 10_000.0;
        }
    }
    led
}

#[test]
fn the_voice_that_earns_most_leads_and_the_others_are_tried_now_and_then() {
    for best in 0..3 {
        let mut earns = [0.1; 3];
        earns[best] = 0.2;
        let led = shares(earns, 0.2, 5);
        assert!(led[best] > 0.85, "{led:?}");
        assert!(led.iter().all(|&share| share > 0.005), "{led:?}");
    }
}

#[test]
fn a_voice_that_has_become_bad_is_left() {
    let (mut voices, mut rng) = (Voices::<2>::new(), Rng::new(3));
    let mut led = 0;
    for step in 0..30_000 {
        let leader = voices.lead(50, 0.2, 0b11, &mut rng);
        let earns = if (leader == 0) == (step < 10_000) {
            1.0
        } else {
            0.2
        };
        voices.gather(earns);
        led += u32::from(step >= 20_000 && leader == 1);
    }
    assert!(led > 8_500, "{led}");
}

#[test]
fn harm_is_worse_than_nothing() {
    let led = shares([-0.1, 0.0, -0.2], 0.0, 1);
    assert!(led[1] > 0.85, "{led:?}");
}

#[test]
fn who_is_not_heard_never_leads() {
    let (mut voices, mut rng) = (Voices::<3>::new(), Rng::new(9));
    for _ in 0..10_000 {
        let leader = voices.lead(5, 0.5, 0b101, &mut rng);
        assert_ne!(leader, 1);
        voices.gather(if leader == 2 { 1.0 } else { 0.0 });
    }
    assert!(voices.record(2).1 > voices.record(0).1);
    assert_eq!(voices.record(1).1, 0);
}

#[test]
fn who_is_not_heard_any_more_stops_at_once_and_is_judged_for_what_was_lived() {
    let (mut voices, mut rng) = (Voices::<3>::new(), Rng::new(4));
    for _ in 0..20 {
        assert_eq!(voices.lead(50, 0.0, 0b111, &mut rng), 0);
        voices.gather(1.0);
    }
    assert_eq!(voices.lead(50, 0.0, 0b100, &mut rng), 2);
    let (earned, blocks) = voices.record(0);
    // Each reward counts for the actions before it, too.
    assert!(blocks == 1 && (9.0..11.0).contains(&earned), "{earned}");
    // Its own block is whole, whoever is heard again meanwhile.
    for _ in 1..50 {
        voices.gather(0.0);
        assert_eq!(voices.lead(50, 0.0, 0b111, &mut rng), 2);
    }
    voices.gather(0.0);
    assert_eq!(voices.record(2).1, 0);
    assert_eq!(voices.lead(50, 0.0, 0b111, &mut rng), 1);
    assert_eq!(voices.record(2).1, 1);
}

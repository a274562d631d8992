//! Thresholds: bands, bounces, sensors that fail.

use super::Threshold;

fn told<const N: usize>(mut threshold: Threshold, readings: [f32; N]) -> [Option<bool>; N] {
    readings.map(|reading| threshold.read(reading))
}

#[test]
fn without_a_band_an_item_is_on_on_one_side_and_off_at_the_level() {
    let readings = [1.0, 2.0, 3.0, 2.0, 1.0];
    assert_eq!(
        told(Threshold::above(2.0), readings),
        [false, false, true, false, false].map(Some)
    );
    assert_eq!(
        told(Threshold::below(2.0), readings),
        [true, false, false, false, true].map(Some)
    );
}

#[test]
fn a_band_keeps_what_was_on_both_of_its_sides() {
    let band = Threshold::above(2.0).band(0.5);
    assert_eq!(
        told(band, [2.4, 2.6, 1.6, 1.5, 1.4, 2.5, 2.6]),
        [false, true, true, true, false, false, true].map(Some)
    );
    // Noise within the band never changes anything.
    let mut noisy = Threshold::above(2.0).band(0.5);
    noisy.read(3.0);
    for step in 0..100 {
        let noise = if step % 2 == 0 { 0.4 } else { -0.4 };
        assert_eq!(noisy.read(2.0 + noise), Some(true));
    }
}

#[test]
fn a_change_needs_as_many_readings_in_a_row_as_it_was_told() {
    let bumper = Threshold::above(0.5).debounced(2);
    assert_eq!(
        told(bumper, [0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0]),
        [false, false, false, false, true, true, false].map(Some)
    );
    assert_eq!(Threshold::above(0.5).debounced(0), Threshold::above(0.5));
    let mut slow = Threshold::above(0.5).debounced(u8::MAX);
    slow.read(0.0);
    let changed = (1..=300).find(|_| slow.read(1.0) == Some(true));
    assert_eq!(changed, Some(255));
}

#[test]
fn a_sensor_that_fails_makes_the_item_unknown_and_is_believed_at_once_when_it_is_back() {
    let debounced = Threshold::above(0.5).debounced(3);
    assert_eq!(
        told(debounced, [1.0, f32::NAN, 0.0, 1.0, f32::NAN, 1.0]),
        [Some(true), None, Some(false), Some(false), None, Some(true)]
    );
    let range = Threshold::below(0.5);
    assert_eq!(
        told(range, [f32::INFINITY, f32::NEG_INFINITY]),
        [Some(false), Some(true)]
    );
}

#[test]
fn a_level_or_a_band_that_cannot_be_makes_every_reading_unknown() {
    for broken in [
        Threshold::above(f32::NAN),
        Threshold::below(1.0).band(-0.1),
        Threshold::below(1.0).band(f32::NAN),
        Threshold::above(f32::INFINITY).band(f32::INFINITY),
    ] {
        assert_eq!(told(broken, [0.0, 1.0, 2.0]), [None; 3], "{broken:?}");
    }
}

//! When a damaged life is as good as its undamaged twin again, so that chance cannot win.
//!
//! A life is compared, window by window, with that of its twin: the same learner with the same past,
//! in the same room with the same chance, to whom nothing happens.
//! It has recovered at the first window from which on
//!
//! 1. all that it captures until the end is at least [`SHARE`] of what the twin captures meanwhile,
//! 2. the share never falls below that by more than one standard error, however few windows of the
//!    rest are counted,
//! 3. and the rest is long enough to tell: one standard error of its share is no more than what is
//!    allowed to be missing.
//!
//! The error is the one that undamaged lives show: the twin's own windows say how much captures vary
//! from one to the next, and never less than counts of chance do.
//! Who captures too little to tell a loss of a tenth from chance never recovers by this measure, and
//! so random actions do not.

/// The share of the twin's captures that counts as recovered.
pub const SHARE: f64 = 0.9;

/// The number of the window with which recovery begins; `None` is never.
///
/// ```
/// use host_sim::experiment::recover::recovery::recovered_at;
/// let twin = [100; 13];
/// let damaged = [20, 40, 60, 100, 96, 103, 99, 98, 101, 100, 97, 100, 102];
/// assert_eq!(recovered_at(&damaged, &twin), Some(3));
/// assert_eq!(recovered_at(&[70; 13], &twin), None);
/// // Three captures in a thousand actions are too few to tell anything.
/// assert_eq!(recovered_at(&[3; 13], &[3; 13]), None);
/// ```
#[must_use]
pub fn recovered_at(damaged: &[u32], twin: &[u32]) -> Option<usize> {
    let windows = damaged.len().min(twin.len());
    let spread = spread(twin);
    (0..windows).find(|&start| {
        let rest = windows - start;
        let error = |counted: usize| spread * (2.0 / counted as f64).sqrt();
        if error(rest) > 1.0 - SHARE {
            return false;
        }
        let (mut ours, mut whole) = (0.0, 0.0);
        let pairs = damaged.iter().zip(twin).skip(start).take(rest);
        let holds = pairs.enumerate().all(|(index, (&a, &b))| {
            (ours, whole) = (ours + f64::from(a), whole + f64::from(b));
            ours >= (SHARE - error(index + 1)) * whole
        });
        holds && ours >= SHARE * whole
    })
}

/// How much the captures of a window vary in a life, as a share of their mean: what its windows show,
/// and no less than counts of events by chance; infinite where nothing is captured.
fn spread(twin: &[u32]) -> f64 {
    let counts: Vec<f64> = twin.iter().copied().map(f64::from).collect();
    let mean = crate::report::mean(&counts);
    if mean > 0.0 {
        let shown = crate::report::sample_sd(&counts) / mean;
        shown.max(1.0 / mean.sqrt())
    } else {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::recovered_at;
    use cla_core::num::Rng;

    /// Windows of a life; its captures come by chance, so many in the mean of each window.
    fn life(rng: &mut Rng, means: &[f32]) -> Vec<u32> {
        let captures = |&mean: &f32| (0..1000).filter(|_| rng.chance(mean / 1000.0)).count() as u32;
        means.iter().map(captures).collect()
    }

    /// In how many of a thousand lives it recovers at these windows, and in how many never.
    fn of_1000(damaged: &[f32], twin: &[f32], at: core::ops::Range<usize>) -> (u32, u32) {
        let mut rng = Rng::new(4);
        let (mut there, mut never) = (0, 0);
        for _ in 0..1000 {
            let (damaged, twin) = (life(&mut rng, damaged), life(&mut rng, twin));
            match recovered_at(&damaged, &twin) {
                Some(window) => there += u32::from(at.contains(&window)),
                None => never += 1,
            }
        }
        (there, never)
    }

    #[test]
    fn chance_never_recovers() {
        // What random actions capture in a room of the reference world.
        let (_, never) = of_1000(&[2.9; 13], &[2.9; 13], 0..13);
        assert_eq!(never, 1000);
        let (_, never) = of_1000(&[2.9; 13], &[100.0; 13], 0..13);
        assert_eq!(never, 1000);
    }

    #[test]
    fn who_was_not_damaged_has_recovered_at_once() {
        let (at_once, never) = of_1000(&[100.0; 13], &[100.0; 13], 0..1);
        assert!(at_once > 900 && never < 20, "{at_once} {never}");
    }

    #[test]
    fn who_stays_behind_does_not_recover() {
        for (mean, most) in [(60.0, 0), (70.0, 20), (80.0, 250)] {
            let (_, never) = of_1000(&[mean; 13], &[100.0; 13], 0..13);
            assert!(1000 - never <= most, "{mean}: {never}");
        }
    }

    #[test]
    fn a_recovery_is_found_where_it_is() {
        let mut means = [100.0; 13];
        means[..4].fill(40.0);
        let (there, never) = of_1000(&means, &[100.0; 13], 4..6);
        assert!(there > 900 && never < 20, "{there} {never}");
        // One lucky window is none.
        let mut lucky = [40; 13];
        lucky[2] = 150;
        assert_eq!(recovered_at(&lucky, &[100; 13]), None);
    }

    #[test]
    fn lives_without_windows_or_captures_do_not_recover() {
        assert_eq!(recovered_at(&[], &[]), None);
        assert_eq!(recovered_at(&[0; 13], &[0; 13]), None);
        assert_eq!(recovered_at(&[100; 1], &[100; 1]), None);
    }
}

//! Launching events that are shifted: a Position layer that pools over shifts beside one that does not.
//!
//! Events are half as large as those of the causal study, so that they can be shifted by cells; three
//! shifts are trained and the seven between and beside them are not.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::launched::{hierarchy, nearest, training, view};
use super::module::Kind;
use crate::experiment::causal::network::CausalConfig;
use crate::failure::Failure;
use crate::world::launching::{Event, Frame};

/// Shifts in training, in cells.
const TRAINED: [u8; 3] = [2, 5, 8];
/// Shifts that are never trained.
const UNTRAINED: [u8; 7] = [0, 1, 3, 4, 6, 7, 9];
/// New events of each kind and shift.
const TESTS: usize = 8;

/// The share of new events that are told by the nearest composite of a clean event of a trained shift.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Told {
    /// At the shifts of training.
    pub trained: f64,
    /// At the others.
    pub untrained: f64,
    /// At the others, whether there was a gap, which Position alone can tell.
    pub gap: f64,
    /// At the others, whether there was a delay, which Movement tells wherever it is.
    pub delay: f64,
    /// Multiply-adds to answer a stimulus.
    pub respond: f64,
}

/// Both hierarchies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Invariance {
    /// Position reads the line as it is.
    pub plain: Told,
    /// Position pools over shifts.
    pub pooled: Told,
}

/// Half as large, and moved by so many cells.
fn shifted(config: &CausalConfig, event: Event, shift: u8) -> Vec<Frame> {
    let mut frames = config.launching.frames(event);
    for place in frames.iter_mut().flat_map(|it| &mut it.position) {
        *place = 0.5 * *place + f32::from(shift);
    }
    frames
}

/// Trains both hierarchies of a kind on so many events, and tests them.
pub(super) fn run(kind: Kind, trial: usize, events: u32, seed: u64) -> Result<Invariance, Failure> {
    Ok(Invariance {
        plain: told(kind, trial, events, seed, false)?,
        pooled: told(kind, trial, events, seed, true)?,
    })
}

fn told(kind: Kind, trial: usize, events: u32, seed: u64, pooled: bool) -> Result<Told, Failure> {
    let config = CausalConfig::standard();
    let mut rng = Rng::stream(seed, 4);
    let stimuli = training(&config, &[0.25; 4], events, &mut rng, |event, rng| {
        let shift = TRAINED[rng.below(TRAINED.len() as u32) as usize];
        shifted(&config, event, shift)
    });
    let mut weights = Rng::stream(seed, 0);
    let mut network = hierarchy(kind, trial, &config, stimuli.len(), pooled, &mut weights)?;
    network.learn(&stimuli);

    let all = TRAINED
        .iter()
        .flat_map(|&shift| Event::ALL.map(|event| (event, shift)));
    let known: Vec<Vec<f32>> = all
        .map(|(event, shift)| view(&network, &shifted(&config, event, shift)).top)
        .collect();
    let mut rng = Rng::stream(seed, 5);
    let mut right = |shifts: &[u8]| {
        let share = 1.0 / (shifts.len() * 4 * TESTS) as f64;
        let [mut both, mut gap, mut delay] = [0.0; 3];
        for &shift in shifts {
            for event in Event::ALL {
                for _ in 0..TESTS {
                    let clean = shifted(&config, event, shift);
                    let seen = view(&network, &config.launching.jittered(&clean, &mut rng)).top;
                    let said = Event::ALL[nearest(&known, &seen) % 4];
                    let is = [
                        said == event,
                        said.has_gap() == event.has_gap(),
                        said.has_delay() == event.has_delay(),
                    ];
                    for (sum, is) in [&mut both, &mut gap, &mut delay].into_iter().zip(is) {
                        *sum += share * f64::from(u8::from(is));
                    }
                }
            }
        }
        [both, gap, delay]
    };
    let [trained, ..] = right(&TRAINED);
    let [untrained, gap, delay] = right(&UNTRAINED);
    Ok(Told {
        trained,
        untrained,
        gap,
        delay,
        respond: network.cost().respond,
    })
}

#[cfg(test)]
mod tests {
    use super::{TRAINED, UNTRAINED, shifted};
    use crate::experiment::causal::network::CausalConfig;
    use crate::experiment::modules::launched::WINDOW;
    use crate::world::launching::{CELLS, Event};

    #[test]
    fn shifted_events_fit_the_line_and_a_window_and_no_shift_is_in_both_sets() {
        let config = CausalConfig::standard();
        assert!(UNTRAINED.iter().all(|it| !TRAINED.contains(it)));
        for shift in TRAINED.into_iter().chain(UNTRAINED) {
            for event in Event::ALL {
                for frame in shifted(&config, event, shift) {
                    let [first, second] = frame.position;
                    assert!(first >= 0.0 && second <= (CELLS - 1) as f32);
                    assert!(second - first + 2.5 < WINDOW as f32);
                }
            }
        }
    }
}

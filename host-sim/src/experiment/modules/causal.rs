//! The causal study with each kind of module (book, 4): what the Top tells apart, and what it takes for new.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::launched::{Seen, difference, hierarchy, nearest, training, view};
use super::module::Kind;
use crate::experiment::causal::measure::SPECIAL;
use crate::experiment::causal::network::CausalConfig;
use crate::failure::Failure;
use crate::world::launching::{Event, Noise};

/// New events of each kind that are told apart.
const TESTS: usize = 50;

/// What a hierarchy does over launching events.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Causality {
    /// Direct – Delay+Gap at the Top, the causal pair of Leslie (1984).
    pub direct_delaygap: f64,
    /// Direct – Gap, that of Cohen and Amsel (1998).
    pub direct_gap: f64,
    /// Delay – Gap: no causal difference.
    pub delay_gap: f64,
    /// Nodes that are special to each of [`Event::ALL`] (book, 4.3.3).
    pub special: [u32; 4],
    /// The share of new events that are told by the nearest composite of a clean one.
    pub told: f64,
    /// How likely a Noisy event is newer to the Top than a clean one: the area under the ROC curve.
    pub noisy: f64,
    /// Units of the Top that were above .5 in a new event.
    pub used: f64,
    /// Units of the Top that share the work of a step.
    pub sharing: f64,
    /// Bytes of all three modules while they learn.
    pub bytes: f64,
    /// Multiply-adds to answer a stimulus.
    pub respond: f64,
    /// Multiply-adds to learn one.
    pub learn: f64,
}

impl Causality {
    /// Direct – Delay+Gap over Delay – Gap: above 1 where the causal view is acquired (book, 4.3.4).
    #[must_use]
    pub fn leslie(&self) -> f64 {
        self.direct_delaygap / self.delay_gap
    }

    /// Whether Direct and Delay+Gap have special nodes and Delay and Gap have none.
    #[must_use]
    pub fn has_full_pattern(&self) -> bool {
        let [direct, delay, gap, delay_gap] = self.special;
        direct > 0 && delay_gap > 0 && delay == 0 && gap == 0
    }
}

/// Trains a hierarchy of a kind on so many events, and looks at it.
pub(super) fn run(kind: Kind, trial: usize, events: u32, seed: u64) -> Result<Causality, Failure> {
    let config = CausalConfig::standard();
    let launching = config.launching;
    let mut rng = Rng::stream(seed, 1);
    let clean = |event: Event, _: &mut Rng| launching.frames(event);
    let stimuli = training(&config, &config.shares, events, &mut rng, clean);
    let mut weights = Rng::stream(seed, 0);
    let mut top = hierarchy(kind, trial, &config, stimuli.len(), false, &mut weights)?;
    top.learn(&stimuli);

    let known = Event::ALL.map(|event| view(&top, &launching.frames(event)).top);
    let [direct, delay, gap, delay_gap] = &known;
    let cost = top.cost();
    let mut found = Causality {
        direct_delaygap: difference(direct, delay_gap),
        direct_gap: difference(direct, gap),
        delay_gap: difference(delay, gap),
        special: special(&known),
        bytes: cost.bytes,
        respond: cost.respond,
        learn: cost.learn,
        ..Causality::default()
    };
    let mut rng = Rng::stream(seed, 2);
    let mut seen = |event: Event, noise: Option<Noise>| -> Seen {
        let frames = launching.frames(event);
        let frames = noise.map_or_else(|| frames.clone(), |it| it.disturb(&frames, &mut rng));
        view(&top, &launching.jittered(&frames, &mut rng))
    };
    let mut most = vec![0.0_f32; direct.len()];
    let mut familiar = Vec::new();
    let share = 1.0 / (4 * TESTS) as f64;
    for (place, event) in Event::ALL.into_iter().enumerate() {
        for _ in 0..TESTS {
            let it = seen(event, None);
            if nearest(&known, &it.top) == place {
                found.told += share;
            }
            found.sharing += share * it.sharing;
            for (most, it) in most.iter_mut().zip(&it.most) {
                *most = most.max(*it);
            }
            if event == Event::Direct {
                familiar.push(it.novelty);
            }
        }
    }
    found.used = most.iter().filter(|&&it| it > SPECIAL).count() as f64;
    let noisy: Vec<f64> = (0..TESTS)
        .map(|_| seen(Event::Direct, Some(Noise::Noisy)).novelty)
        .collect();
    found.noisy = larger(&noisy, &familiar);
    Ok(found)
}

/// Nodes whose composite in an event is above all others together by more than [`SPECIAL`].
fn special(known: &[Vec<f32>; 4]) -> [u32; 4] {
    [0, 1, 2, 3].map(|event| {
        let alone = (0..known[event].len()).filter(|&node| {
            let all: f32 = known.iter().map(|it| it[node]).sum();
            2.0 * known[event][node] - all > SPECIAL
        });
        alone.count() as u32
    })
}

/// How likely one of the first is larger than one of the second; ties count half.
pub(super) fn larger(first: &[f64], second: &[f64]) -> f64 {
    let pairs = first
        .iter()
        .flat_map(|a| second.iter().map(move |b| (a, b)));
    let wins = pairs.map(|(a, b)| {
        if a > b {
            1.0
        } else if a == b {
            0.5
        } else {
            0.0
        }
    });
    wins.sum::<f64>() / (first.len() * second.len()) as f64
}

#[cfg(test)]
mod tests {
    use super::{larger, special};

    #[test]
    fn a_node_is_special_to_the_event_that_outweighs_all_others() {
        let known = [
            vec![2.0, 1.0, 0.0],
            vec![0.5, 1.0, 0.0],
            vec![0.5, 0.0, 0.6],
            vec![0.0, 0.0, 0.0],
        ];
        assert_eq!(special(&known), [1, 0, 1, 0]);
    }

    #[test]
    fn an_area_is_the_share_of_pairs() {
        assert_eq!(larger(&[3.0, 1.0], &[2.0, 1.0]), 0.625);
    }
}

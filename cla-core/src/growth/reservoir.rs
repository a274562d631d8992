//! A bounded memory of what one action did: the counterexamples that keep schemas honest.
//!
//! Every context once; when it is full, what was not foreseen stays and what was foreseen leaves.
//! Schemas are grown against it (see `grow`); without it a context would be as general as the few
//! samples at hand allow.

use super::evidence::{Evidence, Transition};
use crate::num::Rng;
use crate::snapshot::{Stored, Writer, stored};

/// Up to `SAMPLES` pieces of evidence of one action, each context once; at most 65,535.
///
/// In the field: a replay buffer that keeps what was not foreseen.
///
/// ```
/// use cla_core::growth::{Reservoir, Transition};
/// use cla_core::num::Rng;
/// use cla_core::word::ItemSet;
/// let mut reservoir = Reservoir::<1, 2>::new();
/// let mut rng = Rng::new(1);
/// let from = |items| Transition { before: ItemSet::<1>::first(items), after: ItemSet::EMPTY };
/// for (items, hardness) in [(1, 3), (2, 0), (1, 3), (3, 5)] {
///     reservoir.offer(&from(items), hardness, &mut rng);
/// }
/// assert_eq!(reservoir.samples(), [from(1), from(3)]); // the easy one has left
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reservoir<const WORDS: usize, const SAMPLES: usize, E = Transition<WORDS>> {
    samples: heapless::Vec<E, SAMPLES, u16>,
    hardness: [u8; SAMPLES],
}

impl<const WORDS: usize, const SAMPLES: usize, E: Evidence<WORDS>> Reservoir<WORDS, SAMPLES, E> {
    /// Of a full reservoir, this many random samples compete for leaving.
    const CANDIDATES: u8 = 4;
    /// Of the samples that were foreseen, one in this many enters a full reservoir.
    const ONE_IN: u32 = 20;

    /// A reservoir without samples.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(
                SAMPLES > 0 && SAMPLES < u16::MAX as usize,
                "1 to 65,534 samples"
            );
        }
        Self {
            samples: heapless::Vec::new(),
            hardness: [0; SAMPLES],
        }
    }

    /// What is in memory.
    #[must_use]
    pub fn samples(&self) -> &[E] {
        &self.samples
    }

    /// Forgets all samples.
    pub fn clear(&mut self) {
        self.samples.clear();
    }

    /// Offers a sample; `hardness` counts what was wrong about the predictions for it.
    ///
    /// A context that is known takes the new outcome and the larger hardness.
    /// A full reservoir takes every unforeseen sample and one in twenty of the others, in place of the least
    /// hard of four random samples.
    pub fn offer(&mut self, sample: &E, hardness: u8, rng: &mut Rng) {
        let known = self.samples.iter().position(|old| old.began_as(sample));
        let place = match known {
            Some(place) => place,
            None if self.samples.push(*sample).is_ok() => self.samples.len() - 1,
            None if hardness == 0 && rng.below(Self::ONE_IN) != 0 => return,
            None => self.easiest(rng),
        };
        if let Some(old) = self.samples.get_mut(place) {
            *old = match known {
                Some(_) => old.renewed(sample),
                None => *sample,
            };
        }
        if let Some(old) = self.hardness.get_mut(place) {
            *old = if known.is_some() {
                hardness.max(*old)
            } else {
                hardness
            };
        }
    }

    fn easiest(&self, rng: &mut Rng) -> usize {
        let mut easiest = (u8::MAX, 0);
        for _ in 0..Self::CANDIDATES {
            let place = rng.below(SAMPLES as u32) as usize;
            let hardness = self.hardness.get(place).copied().unwrap_or(u8::MAX);
            if (hardness, place) < easiest || easiest == (u8::MAX, 0) {
                easiest = (hardness, place);
            }
        }
        easiest.1
    }
}

impl<const WORDS: usize, const SAMPLES: usize, E: Evidence<WORDS>> Default
    for Reservoir<WORDS, SAMPLES, E>
{
    fn default() -> Self {
        Self::new()
    }
}

stored! {
    impl[const WORDS: usize, const SAMPLES: usize, E: Stored] Reservoir<WORDS, SAMPLES, E> {
        samples, hardness
    }
}

impl<const WORDS: usize, const SAMPLES: usize, E: Evidence<WORDS> + Stored>
    Reservoir<WORDS, SAMPLES, E>
{
    /// Writes each sample, and how hard it was.
    pub(crate) fn carry(&self, to: &mut Writer<'_>) {
        (self.samples.len() as u16).store(to);
        for (sample, hardness) in self.samples.iter().zip(&self.hardness) {
            sample.store(to);
            hardness.store(to);
        }
    }

    /// Puts a sample behind the others, if there is room.
    pub(crate) fn put(&mut self, sample: E, hardness: u8) {
        let place = self.samples.len();
        if self.samples.push(sample).is_ok()
            && let Some(its) = self.hardness.get_mut(place)
        {
            *its = hardness;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Reservoir;
    use crate::growth::Transition;
    use crate::num::Rng;
    use crate::word::{ItemId, ItemSet};

    fn numbered(bits: u16) -> Transition<1> {
        let mut before = ItemSet::EMPTY;
        for bit in 0..16 {
            if bits >> bit & 1 == 1 {
                before.insert(ItemId(bit)).unwrap();
            }
        }
        Transition {
            before,
            after: ItemSet::EMPTY,
        }
    }

    #[test]
    fn surprises_outlive_a_flood_of_the_ordinary() {
        let mut reservoir = Reservoir::<1, 32>::new();
        let mut rng = Rng::new(4);
        for hard in 0..16 {
            reservoir.offer(&numbered(hard), 2, &mut rng);
        }
        for easy in 100..3000 {
            reservoir.offer(&numbered(easy), 0, &mut rng);
        }
        let kept = (0..16)
            .filter(|&hard| reservoir.samples().contains(&numbered(hard)))
            .count();
        // Four random candidates of 32 are all hard in one draw of sixteen.
        assert!((3..=16).contains(&kept), "{kept} of 16");
        let plain = 16.0 * (1.0 - 1.0 / 32.0_f32).powi(145);
        assert!(plain < 1.0, "eviction at random would keep {plain}");
    }

    #[test]
    fn a_context_is_kept_once_with_its_newest_outcome() {
        let mut reservoir = Reservoir::<1, 8>::new();
        let mut rng = Rng::new(4);
        let mut second = numbered(5);
        second.after = ItemSet::first(3);
        reservoir.offer(&numbered(5), 0, &mut rng);
        reservoir.offer(&second, 1, &mut rng);
        assert_eq!(reservoir.samples(), [second]);
    }
}

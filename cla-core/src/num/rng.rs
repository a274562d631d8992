//! A small seeded generator, the same on host and microcontroller.
//!
//! xoshiro128++ (Blackman and Vigna 2019) seeded through SplitMix64: 16 bytes of state, 32-bit
//! operations only, period 2¹²⁸ − 1.
//! Not for secrets.

use crate::snapshot::stored;

/// A seeded random generator.
///
/// Every source of chance in the brain is an `Rng` that the caller hands in, so one seed decides a
/// whole run.
///
/// ```
/// use cla_core::num::Rng;
/// let mut a = Rng::new(7);
/// let mut b = Rng::new(7);
/// assert_eq!(a.next_u32(), b.next_u32());
/// assert!(a.below(6) < 6);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rng {
    state: [u32; 4],
}

impl Rng {
    /// All-zero memory in place of a generator that will be seeded: it only ever draws 0.
    pub(crate) const UNSEEDED: Self = Self { state: [0; 4] };

    /// Whether it was seeded.
    pub(crate) fn is_seeded(&self) -> bool {
        self.state != [0; 4]
    }

    /// A generator for `seed`; different seeds give unrelated sequences.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        let (x, first) = split_mix(seed);
        let (_, second) = split_mix(x);
        let state = [
            first as u32,
            (first >> 32) as u32,
            second as u32,
            (second >> 32) as u32,
        ];
        // The all-zero state is the one fixed point of the generator.
        if state[0] == 0 && state[1] == 0 && state[2] == 0 && state[3] == 0 {
            return Self {
                state: [1, 2, 3, 4],
            };
        }
        Self { state }
    }

    /// A generator for one of many independent streams of the same seed.
    ///
    /// Worlds, agents and tests take different streams, so that a change in one does not shift the
    /// draws of another.
    #[must_use]
    pub const fn stream(seed: u64, stream: u64) -> Self {
        let (_, mixed) = split_mix(stream);
        Self::new(seed ^ mixed)
    }

    /// The next 32 random bits.
    pub fn next_u32(&mut self) -> u32 {
        let [s0, s1, s2, s3] = &mut self.state;
        let result = s0.wrapping_add(*s3).rotate_left(7).wrapping_add(*s0);
        let t = *s1 << 9;
        *s2 ^= *s0;
        *s3 ^= *s1;
        *s1 ^= *s2;
        *s0 ^= *s3;
        *s2 ^= t;
        *s3 = s3.rotate_left(11);
        result
    }

    /// 64 random bits, to seed another generator with.
    pub fn next_seed(&mut self) -> u64 {
        u64::from(self.next_u32()) << 32 | u64::from(self.next_u32())
    }

    /// A uniform number in `[0, 1)` with 24 random bits.
    pub fn unit(&mut self) -> f32 {
        (self.next_u32() >> 8) as f32 * (1.0 / 16_777_216.0)
    }

    /// A uniform number in `0..bound`; 0 when `bound` is 0.
    ///
    /// The high half of a 64-bit product: for bounds below 2¹⁶ the bias is under 2⁻¹⁶.
    pub fn below(&mut self, bound: u32) -> u32 {
        ((u64::from(self.next_u32()) * u64::from(bound)) >> 32) as u32
    }

    /// True with probability `p`; never for `p ≤ 0` or NaN, always for `p ≥ 1`.
    pub fn chance(&mut self, p: f32) -> bool {
        self.unit() < p
    }
}

const fn split_mix(state: u64) -> (u64, u64) {
    let next = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = next;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (next, z ^ (z >> 31))
}

stored!(impl[] Rng { state });

#[cfg(test)]
mod tests {
    use super::Rng;

    #[test]
    fn the_sequence_is_the_published_one() {
        // First outputs of the reference C code of xoshiro128++ for the state 1, 2, 3, 4.
        let mut rng = Rng {
            state: [1, 2, 3, 4],
        };
        let drawn: [u32; 4] = core::array::from_fn(|_| rng.next_u32());
        assert_eq!(drawn, [641, 1_573_767, 3_222_811_527, 3_517_856_514]);
    }

    #[test]
    fn bounded_draws_are_uniform() {
        let mut rng = Rng::new(1);
        let mut counts = [0_u32; 6];
        for _ in 0..60_000 {
            counts[rng.below(6) as usize] += 1;
        }
        for count in counts {
            // Five standard deviations of a binomial with n = 60,000 and p = 1/6.
            assert!((9_543..=10_457).contains(&count), "{counts:?}");
        }
    }

    #[test]
    fn a_bound_of_zero_gives_zero_and_chances_at_the_edges_are_certain() {
        let mut rng = Rng::new(2);
        assert_eq!(rng.below(0), 0);
        for _ in 0..1000 {
            assert!(!rng.chance(0.0) && !rng.chance(f32::NAN) && rng.chance(1.0));
        }
    }

    #[test]
    fn streams_of_one_seed_differ() {
        assert_ne!(Rng::stream(5, 0).next_u32(), Rng::stream(5, 1).next_u32());
        assert_ne!(Rng::new(0).next_u32(), Rng::new(1).next_u32());
    }

    #[test]
    fn a_seed_is_mixed_as_published() {
        // First outputs of the reference C code of SplitMix64 for the seed 0.
        let (next, first) = super::split_mix(0);
        let (next, second) = super::split_mix(next);
        let (_, third) = super::split_mix(next);
        assert_eq!(
            [first, second, third],
            [
                0xE220_A839_7B1D_CDAF,
                0x6E78_9E6A_A1B9_65F4,
                0x06C4_5D18_8009_454F
            ]
        );
        let words = [first, second].map(|it| [it as u32, (it >> 32) as u32]);
        assert_eq!(
            Rng::new(0).state,
            [words[0][0], words[0][1], words[1][0], words[1][1]]
        );
    }

    #[test]
    fn no_two_streams_of_no_two_seeds_begin_alike() {
        let mut drawn = std::vec::Vec::new();
        for stream in 0..5 {
            drawn.push(Rng::stream(0, stream).next_u32());
            for bit in 0..64 {
                drawn.push(Rng::stream(1 << bit, stream).next_u32());
            }
        }
        let all = drawn.len();
        drawn.sort_unstable();
        drawn.dedup();
        assert_eq!(drawn.len(), all);
    }

    #[test]
    fn a_seed_drawn_is_two_draws_high_word_first() {
        let (mut one, mut two) = (Rng::new(6), Rng::new(6));
        let (high, low) = (two.next_u32(), two.next_u32());
        assert_eq!(one.next_seed(), u64::from(high) << 32 | u64::from(low));
    }

    #[test]
    fn unit_numbers_fill_zero_to_one_evenly() {
        let mut rng = Rng::new(11);
        let mut counts = [0_u32; 10];
        for _ in 0..10_000 {
            let x = rng.unit();
            assert!((0.0..1.0).contains(&x));
            counts[(x * 10.0) as usize] += 1;
        }
        // Five standard deviations of a binomial with n = 10,000 and p = .1.
        assert!(
            counts.iter().all(|count| (850..=1150).contains(count)),
            "{counts:?}"
        );
        let hits = (0..10_000).filter(|_| rng.chance(0.3)).count();
        assert!((2770..=3230).contains(&hits), "{hits}");
    }

    #[test]
    fn a_generator_that_was_not_seeded_draws_zero_and_takes_no_chance() {
        let mut rng = Rng::UNSEEDED;
        assert_eq!((rng.next_u32(), rng.unit(), rng.below(9)), (0, 0.0, 0));
        assert!(!rng.chance(0.0) && rng.chance(1e-9));
    }
}

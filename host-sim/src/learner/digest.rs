//! One number for a life: equal where two lives are, to the bit, in whatever language they were led.

use super::Learner;
use crate::failure::Failure;
use crate::world::Percept;

/// All that was perceived, done and felt, in its order, as 64 bits (FNV-1a).
///
/// A percept goes in as the words of what is on and of what is off, an action as its index, a reward as
/// the bits of an `f32`.
///
/// ```
/// use host_sim::learner::digest::Digest;
/// use host_sim::world::Percept;
/// let (mut one, mut other) = (Digest::NEW, Digest::NEW);
/// one.percept(&Percept::all_off(7));
/// other.percept(&Percept::all_off(6));
/// assert_ne!(one, other);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest(u64);

impl Digest {
    /// Of a life that has not begun.
    pub const NEW: Self = Self(0xcbf2_9ce4_8422_2325);

    /// Of a life that goes on, by the number of its part so far.
    #[must_use]
    pub const fn of(value: u64) -> Self {
        Self(value)
    }

    /// The number.
    #[must_use]
    pub const fn value(self) -> u64 {
        self.0
    }

    /// Something was perceived.
    pub fn percept(&mut self, now: &Percept) {
        for word in now.on().words().iter().chain(now.off().words()) {
            self.word(*word);
        }
    }

    /// Something was done.
    pub fn action(&mut self, action: usize) {
        self.word(action as u32);
    }

    /// Something was felt beside the percept.
    pub fn reward(&mut self, reward: f32) {
        self.word(reward.to_bits());
    }

    fn word(&mut self, word: u32) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }
}

/// Any learner, and the digest of its life; its load is not kept.
///
/// ```
/// use host_sim::baseline::random::Random;
/// use host_sim::learner::controller::Untaught;
/// use host_sim::learner::digest::{Digest, Digested};
/// use host_sim::learner::rewarded::rewarded;
/// use host_sim::world::lake::Lake;
/// let digest = |seed| {
///     let mut random = Untaught::new(Random { actions: 4 }, seed);
///     let mut it = Digested::new(&mut random, Digest::NEW);
///     rewarded(&mut it, &mut Lake::new(1), 50).map(|_| it.digest())
/// };
/// assert_eq!(digest(1)?, digest(1)?);
/// assert_ne!(digest(1)?, digest(2)?);
/// # Ok::<(), host_sim::failure::Failure>(())
/// ```
pub struct Digested<'a> {
    learner: &'a mut dyn Learner,
    digest: Digest,
}

impl<'a> Digested<'a> {
    /// A learner whose life so far had this digest.
    pub fn new(learner: &'a mut dyn Learner, digest: Digest) -> Self {
        Self { learner, digest }
    }

    /// The digest of all that was lived.
    #[must_use]
    pub const fn digest(&self) -> Digest {
        self.digest
    }
}

impl Learner for Digested<'_> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        let action = self.learner.choose(now)?;
        self.digest.percept(now);
        self.digest.action(action);
        Ok(action)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.digest.percept(now);
        self.learner.learn(now)
    }

    fn learn_with(&mut self, now: &Percept, reward: f32) -> Result<(), Failure> {
        self.digest.percept(now);
        self.digest.reward(reward);
        self.learner.learn_with(now, reward)
    }

    fn observe(&mut self, before: &Percept, action: usize, now: &Percept) -> Result<(), Failure> {
        self.digest.percept(before);
        self.digest.action(action);
        self.digest.percept(now);
        self.learner.observe(before, action, now)
    }

    within!(self => *self.learner;
        interrupt act cost hear reliabilities predictions alarms worth image go_on_from reason);
}

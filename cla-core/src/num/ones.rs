//! The bits of a bit set as indices, in ascending order: what items, samples and stimuli are made of.

/// The indices of the bits that are 1, in ascending order.
///
/// ```
/// use cla_core::num::Ones;
/// assert_eq!(Ones::of(&[0b101, 0b10]).collect::<Vec<_>>(), [0, 2, 33]);
/// ```
#[derive(Clone, Debug)]
pub struct Ones<'a> {
    words: &'a [u32],
    base: u16,
    rest: u32,
}

impl<'a> Ones<'a> {
    /// The bits of `words`; of more than 2,047 words the first 2,047.
    #[must_use]
    pub const fn of(words: &'a [u32]) -> Self {
        Self {
            words,
            base: 0,
            rest: 0,
        }
    }
}

impl Iterator for Ones<'_> {
    type Item = u16;

    fn next(&mut self) -> Option<u16> {
        while self.rest == 0 {
            let (&word, others) = self.words.split_first()?;
            self.base = self.base.checked_add(32)?;
            self.words = others;
            self.rest = word;
        }
        let bit = self.rest.trailing_zeros() as u16;
        self.rest &= self.rest - 1;
        Some(self.base - 32 + bit)
    }
}

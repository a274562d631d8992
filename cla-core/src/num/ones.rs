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

#[cfg(test)]
mod tests {
    use super::Ones;

    #[test]
    fn bits_are_listed_in_order_over_all_words() {
        let words = [0, 1 << 31 | 0b110, 0, 1];
        let all = Ones::of(&words).collect::<std::vec::Vec<_>>();
        assert_eq!(all, [33, 34, 63, 96]);
        assert_eq!(Ones::of(&[]).next(), None);
    }

    #[test]
    fn of_more_words_than_bits_have_names_the_first_count() {
        let words = std::vec![1_u32 << 31; 2049];
        assert_eq!(Ones::of(&words).count(), 2047);
    }
}

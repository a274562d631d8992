//! Binary stimuli as bit words: feature j is bit j mod 32 of word j div 32.

/// A stimulus of mostly zeros: the features at +1, at −1 and those that nobody knows.
///
/// All others are 0; no feature stands in two of the sets; missing words are 0.
///
/// ```
/// use cla_core::som::SparseStimulus;
/// let stimulus = SparseStimulus { on: &[0b1001, 0b1], minus: &[], unknown: &[0b10] };
/// assert_eq!(stimulus.on().collect::<Vec<_>>(), [0, 3, 32]);
/// assert!(stimulus.is_unknown(1) && !stimulus.is_unknown(700));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SparseStimulus<'a> {
    /// Features at +1.
    pub on: &'a [u32],
    /// Features at −1 (an item that has turned off, in change coding).
    pub minus: &'a [u32],
    /// Features that are left out of the comparison and of the update.
    pub unknown: &'a [u32],
}

impl<'a> SparseStimulus<'a> {
    /// Features at +1 in ascending order.
    #[must_use]
    pub const fn on(&self) -> Ones<'a> {
        Ones::of(self.on)
    }

    /// Features at −1 in ascending order.
    #[must_use]
    pub const fn minus(&self) -> Ones<'a> {
        Ones::of(self.minus)
    }

    /// Unknown features in ascending order.
    #[must_use]
    pub const fn unknown(&self) -> Ones<'a> {
        Ones::of(self.unknown)
    }

    /// Whether a feature is unknown.
    #[must_use]
    pub fn is_unknown(&self, feature: u16) -> bool {
        match self.unknown.get(usize::from(feature / 32)) {
            Some(word) => word >> (feature % 32) & 1 == 1,
            None => false,
        }
    }
}

/// The indices of the bits that are 1, in ascending order.
///
/// ```
/// use cla_core::som::Ones;
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

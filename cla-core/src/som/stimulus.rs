//! Binary stimuli as bit words: feature j is bit j mod 32 of word j div 32.

use crate::num::Ones;

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

#[cfg(test)]
mod tests {
    use super::SparseStimulus;

    #[test]
    fn features_are_listed_by_what_is_known_of_them() {
        let stimulus = SparseStimulus {
            on: &[0, 0b110],
            minus: &[0b1000],
            unknown: &[1, 1 << 5],
        };
        assert!(stimulus.on().eq([33, 34]));
        assert!(stimulus.minus().eq([3]));
        assert!(stimulus.unknown().eq([0, 37]));
        for feature in 0..70 {
            let unknown = feature == 0 || feature == 37;
            assert_eq!(stimulus.is_unknown(feature), unknown, "{feature}");
        }
    }
}

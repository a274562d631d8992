//! Fallback: which level answers when higher ones are overloaded (book, 3.4).
//!
//! The detectors that say *overloaded* are in [`overload`](super::overload).

use core::fmt;

/// A level of the hierarchy; 1 is the lowest, as in the book.
///
/// ```
/// use cla_core::layer::Level;
/// assert!(Level(2) > Level(1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Level(pub u8);

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Level {}", self.0)
    }
}

/// The highest level that is not overloaded; `None` when all are.
///
/// `overloaded` begins with Level 1; levels above 255 are not looked at.
///
/// ```
/// use cla_core::layer::{Level, answering_level};
/// assert_eq!(answering_level([false, false, false]), Some(Level(3)));
/// assert_eq!(answering_level([false, true, true]), Some(Level(1)));
/// // A lower overload does not silence a level that still knows the stimulus.
/// assert_eq!(answering_level([true, false]), Some(Level(2)));
/// assert_eq!(answering_level([true, true]), None);
/// ```
#[must_use]
pub fn answering_level(overloaded: impl IntoIterator<Item = bool>) -> Option<Level> {
    let mut answering = None;
    for (level, overloaded) in (1..=u8::MAX).zip(overloaded) {
        if !overloaded {
            answering = Some(Level(level));
        }
    }
    answering
}

#[cfg(test)]
mod tests {
    use super::{Level, answering_level};

    #[test]
    fn the_highest_level_that_is_not_overloaded_answers() {
        for mask in 0..16_u8 {
            let overloaded: [bool; 4] = core::array::from_fn(|i| mask >> i & 1 == 1);
            let expected = (1..=4)
                .rev()
                .find(|&l| !overloaded[usize::from(l) - 1])
                .map(Level);
            assert_eq!(answering_level(overloaded), expected);
        }
        assert_eq!(answering_level([]), None);
    }

    #[test]
    fn a_level_is_called_by_its_number() {
        assert_eq!(std::format!("{}", Level(2)), "Level 2");
    }
}

//! Which seeds a run used, and so what its results may be called.
//!
//! Seeds 0 to 99 are for tuning; 100 to 199 have been looked at and serve for validation, look,
//! decide, look again; 200 to 699 were used in trials.
//! A final result is made once, on a block that nobody has looked at; `docs/claims.md` names the
//! blocks and every run that touched them.

use core::fmt;
use core::ops::Range;

use serde::{Deserialize, Serialize};

/// The blocks of final results, from the first seed to the one after the last, oldest first; a
/// renewal takes the next and is added here.
pub const FINAL_BLOCKS: [(u64, u64); 1] = [(700, 730)];

/// What the results of some seeds may be called.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// Seeds 0 to 99.
    Tuning,
    /// Seeds 100 to 199.
    Validation,
    /// Other seeds, or a mixture.
    Trial,
    /// All seeds of one of [`FINAL_BLOCKS`].
    Final,
    /// No seeds: the numbers of layouts that another simulator was run on, or counts.
    Layouts,
}

impl Status {
    /// The status that goes with these seeds.
    ///
    /// ```
    /// use host_sim::report::Status;
    /// assert_eq!(Status::of(&[100, 119]), Status::Validation);
    /// assert_eq!(Status::of(&[99, 100]), Status::Trial);
    /// assert_eq!(Status::of(&(700..730).collect::<Vec<u64>>()), Status::Final);
    /// assert_eq!(Status::of(&[700]), Status::Trial);
    /// ```
    #[must_use]
    pub fn of(seeds: &[u64]) -> Self {
        let all_in =
            |range: Range<u64>| !seeds.is_empty() && seeds.iter().all(|it| range.contains(it));
        let whole = |&(from, to): &(u64, u64)| seeds.iter().copied().eq(from..to);
        if FINAL_BLOCKS.iter().any(whole) {
            Self::Final
        } else if all_in(0..100) {
            Self::Tuning
        } else if all_in(100..200) {
            Self::Validation
        } else {
            Self::Trial
        }
    }

    /// Whether results that are called so may come from these seeds.
    #[must_use]
    pub fn fits(self, seeds: &[u64]) -> bool {
        match self {
            Self::Layouts => seeds.iter().copied().eq(1..=10),
            status => status == Self::of(seeds),
        }
    }
}

/// How many seeds and which, for the caption of a figure.
///
/// ```
/// use host_sim::report::sample;
/// assert_eq!(sample(&[100, 101, 102]), "n = 3 (seeds 100–102)");
/// assert_eq!(sample(&[7]), "n = 1 (seed 7)");
/// assert_eq!(sample(&[1, 3]), "n = 2 (seeds 1, 3)");
/// ```
#[must_use]
pub fn sample(seeds: &[u64]) -> String {
    let in_a_row = seeds
        .windows(2)
        .all(|pair| pair[0].checked_add(1) == Some(pair[1]));
    let which = match seeds {
        [only] => format!("seed {only}"),
        [first, .., last] if in_a_row => format!("seeds {first}–{last}"),
        several => {
            let texts: Vec<String> = several.iter().map(u64::to_string).collect();
            format!("seeds {}", texts.join(", "))
        }
    };
    format!("n = {} ({which})", seeds.len())
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Tuning => "tuning",
            Self::Validation => "validation",
            Self::Trial => "trial",
            Self::Final => "final",
            Self::Layouts => "layouts",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{FINAL_BLOCKS, Status};

    #[test]
    fn a_status_fits_its_own_seeds_and_no_others() {
        let block: Vec<u64> = (FINAL_BLOCKS[0].0..FINAL_BLOCKS[0].1).collect();
        let layouts: Vec<u64> = (1..=10).collect();
        assert!(Status::Final.fits(&block) && !Status::Validation.fits(&block));
        assert!(
            !Status::Final.fits(&block[1..]),
            "a part of a block is not final"
        );
        assert!(Status::Validation.fits(&[100, 101]) && !Status::Final.fits(&[100, 101]));
        assert!(!Status::Validation.fits(&[199, 200]) && !Status::Validation.fits(&[]));
        assert!(Status::Layouts.fits(&layouts) && !Status::Layouts.fits(&[100]));
    }

    #[test]
    fn no_block_overlaps_another_or_what_has_been_looked_at() {
        let mut before = 699;
        for (from, to) in FINAL_BLOCKS {
            assert!(from > before && to - from >= 30, "{from}..{to}");
            before = to - 1;
        }
    }
}

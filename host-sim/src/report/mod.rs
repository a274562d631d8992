//! What an experiment hands over: claims with their verdicts, tables, figures, files.
//!
//! An experiment measures and returns a [`Summary`]; everything that is printed, drawn or written
//! is made from it, so that the terminal, the figures and the JSON cannot disagree.
//! The module knows nothing of worlds or brains.

mod brief;
mod circumstances;
mod claims;
mod expectation;
pub mod figure;
mod html;
mod inference;
mod journal;
mod judge;
mod output;
mod place;
mod results;
mod rule;
mod rule_text;
mod seeds;
mod statistics;
mod summary;
mod table;

pub use circumstances::Circumstances;
pub use claims::{Claim, Estimator, Origin, Ours, Range, Reference, Tested, Verdict};
pub use expectation::Expectation;
pub use html::{Section, escaped, leaf, rows};
pub use inference::{
    LEVEL, Outcome, Printed, RESAMPLES, binomial_test, holm, median_interval, one_sample_t,
    paired_t, ratio_interval, share_interval, welch_of_printed,
};
pub use journal::{Begin, Journal, JournalError};
pub use judge::{AHEAD, EQUIVALENCE, LEAST};
pub use output::{Output, OutputError};
pub use place::Place;
pub use results::Results;
pub use rule::{Better, Bound, Evidence, Rule, Statistic};
pub use rule_text::NoRule;
pub use seeds::{FINAL_BLOCKS, Status, sample};
pub use statistics::{
    Interval, Welch, cohens_d, confidence_interval, mean, median, quantile, sample_sd, welch_t,
};
pub use summary::{FORMAT, Summary, Table};
pub(crate) use table::grouped;
pub use table::{claims_text, ours_text, table_text};

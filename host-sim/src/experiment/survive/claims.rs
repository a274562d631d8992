//! What is claimed of all parts that were run.

use super::options::SurviveOptions;
use super::part::Scale;
use crate::experiment::measured::{Trial, table};
use crate::report::Summary;

pub(super) fn summary(options: &SurviveOptions, trials: &[Trial]) -> Summary {
    let mut summary = Summary::new("survive", &options.seeds);
    let parts = options.parts.iter().map(|part| part.name);
    summary.parameter("parts", parts.collect::<Vec<_>>().join(" "));
    summary.parameter("lives shorter by", options.shorter.0);
    let mut rest = trials;
    for part in &options.parts {
        let (own, others) = rest.split_at(options.seeds.len().min(rest.len()));
        rest = others;
        summary.claims.extend((part.claims)(own));
        if !own.is_empty() {
            let title = format!("what {} has measured", part.name);
            summary.table(&title, table(own));
        }
    }
    if options.shorter != Scale(1) {
        summary.vary();
    }
    summary
}

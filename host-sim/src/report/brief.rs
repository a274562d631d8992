//! What a run ends with on the terminal: ten lines at most, what was missed first.

use std::path::Path;

use super::claims::{Claim, Verdict};
use super::judge::LEAST;
use super::summary::Summary;
use super::table::{ours_text, reference};

/// Misses that are told one by one.
const TOLD: usize = 4;

/// The last lines of a run: what is said first and last, and where the page is.
pub(super) fn brief(
    summary: &Summary,
    headline: Option<&str>,
    remark: Option<&str>,
    page: &Path,
) -> String {
    let mut lines = vec![format!(
        "{}: {}, {}",
        summary.experiment,
        summary.status,
        summary.sample()
    )];
    lines.extend(headline.map(|it| it.replace('\n', " ")));
    let missed: Vec<&Claim> = summary.missed().collect();
    if !missed.is_empty() {
        let told = missed.len().min(TOLD);
        lines.extend(missed[..told].iter().map(|claim| miss(claim)));
        if missed.len() > told {
            let rest = missed.len() - told;
            lines.push(format!("missed: {rest} more, see report.html or --table"));
        }
    }
    if !summary.claims.is_empty() {
        lines.push(counts(summary));
    }
    lines.extend(remark.map(str::to_owned));
    lines.push(format!("everything is in {}", page.display()));
    lines.join("\n")
}

/// A claim that was missed, in a line.
fn miss(claim: &Claim) -> String {
    let beside = claim.reference.as_ref();
    let beside = beside.map_or_else(
        || claim.rule.to_string(),
        |it| format!("{} {}", it.of, reference(it)),
    );
    let word = match claim.verdict {
        Verdict::NotReproduced => "not reproduced",
        _ => "missed",
    };
    let ours = ours_text(&claim.ours);
    format!("{word}: {}: {ours}, {beside}", claim.id)
}

/// How many claims came out how; with too few seeds for a verdict, how to get one.
fn counts(summary: &Summary) -> String {
    let claims = &summary.claims;
    let small = claims.iter().filter(|it| it.verdict == Verdict::TooSmall);
    let small = small.count();
    if small * 2 < claims.len() {
        return format!("{} claims: {}", claims.len(), summary.verdict_line());
    }
    let seeds = &summary.seeds;
    let first = seeds.first().copied().unwrap_or(100);
    format!(
        "no verdicts from fewer than {LEAST} seeds; {small} of {} claims get one with --seeds \
         {first}..{}",
        claims.len(),
        first.saturating_add(20)
    )
}

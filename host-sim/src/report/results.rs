//! Everything that an experiment hands over at its end: the record, its pictures, a last word.

use std::path::{Path, PathBuf};

use super::brief::brief;
use super::figure::Picture;
use super::html::{self, Section};
use super::output::{Output, OutputError};
use super::summary::Summary;
use super::table::{claims_text, ours_text, table_text};

/// The summary of a run with the figures drawn from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// The record.
    pub summary: Summary,
    /// The instructions of the worst control step by the name of the processor; empty when no brain
    /// counted its steps.
    pub worst_ticks: Vec<(&'static str, u64)>,
    /// What came out, in one sentence with numbers.
    pub headline: Option<String>,
    /// What is told on the terminal before anything else.
    pub story: Option<String>,
    /// A last line for the terminal.
    pub remark: Option<String>,
    /// Why the run has failed although it came to its end, in one sentence.
    pub over_budget: Option<String>,
    pictures: Vec<(String, Picture)>,
    sections: Vec<Section>,
    files: Vec<(String, String)>,
}

impl Results {
    /// The name of the page.
    pub const PAGE: &'static str = "report.html";

    /// Results without pictures yet; the claims are judged together.
    #[must_use]
    pub fn new(summary: Summary) -> Self {
        Self {
            summary: summary.judged(),
            worst_ticks: Vec::new(),
            headline: None,
            story: None,
            remark: None,
            over_budget: None,
            pictures: Vec::new(),
            sections: Vec::new(),
            files: Vec::new(),
        }
    }

    /// Adds a text, which is written as a file of that name.
    #[must_use]
    pub fn file(mut self, name: &str, text: String) -> Self {
        self.files.push((name.to_owned(), text));
        self
    }

    /// Adds a picture, which is written as `name.svg` and `name.png`, and its points as `name.csv`.
    #[must_use]
    pub fn picture(mut self, name: &str, picture: Picture) -> Self {
        self.pictures.push((name.to_owned(), picture));
        self
    }

    /// Says in one sentence what came out: what is counted, then names with the ids of claims, whose
    /// numbers stand beside them; a claim that is not there is left out.
    ///
    /// ```
    /// use host_sim::report::{Expectation, Results, Summary};
    /// let mut summary = Summary::new("forage", &[1, 2]);
    /// summary.claim(Expectation::new("forage.ours", "6.2", "captures").judge(&[4.0, 6.0]));
    /// let results = Results::new(summary);
    /// let results = results.headline("captures", &[("ours", "forage.ours"), ("other", "forage.no")]);
    /// assert_eq!(results.headline.as_deref(), Some("captures: ours 5 ± 1.41"));
    /// ```
    #[must_use]
    pub fn headline(mut self, what: &str, named: &[(&str, &str)]) -> Self {
        let number = |&(name, id): &(&str, &str)| {
            let ours = ours_text(&self.summary.find(id)?.ours);
            // How many seeds there are is told once.
            let ours = ours.rsplit_once(" (").map_or(ours.as_str(), |(it, _)| it);
            Some(format!("{name} {ours}"))
        };
        let numbers: Vec<String> = named.iter().filter_map(number).collect();
        if !numbers.is_empty() {
            self.headline = Some(format!("{what}: {}", numbers.join(", ")));
        }
        self
    }

    /// Adds a part to the page, as HTML.
    #[must_use]
    pub fn section(mut self, title: &str, html: String) -> Self {
        let title = title.to_owned();
        self.sections.push(Section { title, html });
        self
    }

    /// The last ten lines of a run whose files are in a directory: what was missed, counts, where
    /// everything is.
    #[must_use]
    pub fn brief(&self, directory: &Path) -> String {
        let (headline, remark) = (self.headline.as_deref(), self.remark.as_deref());
        brief(&self.summary, headline, remark, &directory.join(Self::PAGE))
    }

    /// The page: one file that asks the network for nothing.
    #[must_use]
    pub fn page(&self) -> String {
        let mut sections = Vec::new();
        if let Some(story) = &self.story {
            let html = format!("<pre>{}</pre>", html::escaped(story));
            let title = "What happened".to_owned();
            sections.push(Section { title, html });
        }
        sections.extend(self.sections.iter().cloned());
        let headline = self.headline.as_deref().unwrap_or_default();
        html::page(headline, &self.summary, &self.pictures, &sections)
    }

    /// Everything as text: the story, all tables, then the claims, then the last line.
    ///
    /// ```
    /// use host_sim::report::{Results, Summary, Table};
    /// let mut summary = Summary::new("forage", &[1]);
    /// let mut schemas = Table::new(&["schema", "reliability"]);
    /// schemas.row(["+s3/forward/+ingrip".into(), 0.31.into()]);
    /// summary.table("schemas", schemas);
    /// assert!(Results::new(summary).text().contains("+s3/forward/+ingrip"));
    /// ```
    #[must_use]
    pub fn text(&self) -> String {
        let mut text = String::new();
        if let Some(story) = &self.story {
            text.push_str(&format!("{story}\n"));
        }
        for (title, table) in &self.summary.tables {
            text.push_str(&format!("{title}\n\n{}\n", table_text(table)));
        }
        if !self.summary.claims.is_empty() {
            text.push_str(&claims_text(&self.summary.claims));
            text.push_str(&format!(
                "\n{} ({} seeds): {}\n",
                self.summary.status,
                self.summary.seeds.len(),
                self.summary.verdict_line()
            ));
        }
        if let Some(remark) = &self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        text
    }

    /// Writes the texts, the pictures, the page and, last, the summary; returns the paths.
    ///
    /// # Errors
    /// [`OutputError`] for the first file that cannot be written.
    pub fn write(&self, output: &Output) -> Result<Vec<PathBuf>, OutputError> {
        let mut paths = Vec::new();
        for (name, text) in &self.files {
            paths.push(output.write(name, text.as_bytes())?);
        }
        for (name, picture) in &self.pictures {
            paths.push(output.write_picture(name, picture)?);
        }
        paths.push(output.write(Self::PAGE, self.page().as_bytes())?);
        paths.push(output.write_summary(&self.summary)?);
        Ok(paths)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::Results;
    use crate::report::{Bound, Expectation, Rule, Summary};

    fn results(seeds: u64, claims: usize, least: f64) -> Results {
        let mut summary = Summary::new("a", &(100..100 + seeds).collect::<Vec<u64>>());
        let values: Vec<f64> = (0..seeds).map(|it| it as f64 / 7.0).collect();
        for claim in 0..claims {
            let claim = Expectation::new(format!("a.c{claim}"), "6.1", "captures").extension();
            let rule = Rule::mean(Bound::AtLeast(least));
            summary.claim(claim.rule(rule).judge(&values));
        }
        let mut results = Results::new(summary);
        results.headline = Some("first words".to_owned());
        results.remark = Some("last words".to_owned());
        results
    }

    #[test]
    fn ten_lines_at_most_and_misses_before_counts() {
        let text = results(12, 30, 9.0).brief(Path::new("here"));
        assert!(text.lines().count() <= 10, "{text}");
        let at = |part: &str| text.find(part).unwrap_or_else(|| panic!("{part}: {text}"));
        assert!(at("missed: a.c0: 0.7857 ± 0.515 (12)") < at("missed: 26 more"));
        assert!(at("missed: 26 more") < at("30 claims: 30 extension: missed"));
        assert!(at("first words") < at("last words"));
        assert!(
            text.ends_with("everything is in here/report.html"),
            "{text}"
        );
    }

    #[test]
    fn one_seed_is_told_how_to_get_verdicts_and_no_list() {
        let text = results(1, 30, 9.0).brief(Path::new("here"));
        assert!(
            text.contains("30 of 30 claims get one with --seeds 100..120"),
            "{text}"
        );
        assert!(
            !text.contains("n too small") && text.lines().count() <= 5,
            "{text}"
        );
    }
}

//! Everything that an experiment hands over at its end: the record, its pictures, a last word.

use std::path::PathBuf;

use super::figure::Picture;
use super::output::{Output, OutputError};
use super::summary::Summary;
use super::table::{claims_text, table_text};

/// The summary of a run with the figures drawn from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Results {
    /// The record.
    pub summary: Summary,
    /// The instructions of the worst control step by the name of the processor; empty when no brain
    /// counted its steps.
    pub worst_ticks: Vec<(&'static str, u64)>,
    /// What is told on the terminal before anything else.
    pub story: Option<String>,
    /// A last line for the terminal.
    pub remark: Option<String>,
    /// Why the run has failed although it came to its end, in one sentence.
    pub over_budget: Option<String>,
    pictures: Vec<(String, Picture)>,
    files: Vec<(String, Vec<u8>)>,
}

impl Results {
    /// Results without pictures yet; the claims are judged together.
    #[must_use]
    pub fn new(summary: Summary) -> Self {
        Self {
            summary: summary.judged(),
            worst_ticks: Vec::new(),
            story: None,
            remark: None,
            over_budget: None,
            pictures: Vec::new(),
            files: Vec::new(),
        }
    }

    /// Adds a picture, which is written as `name.svg` and `name.png`.
    #[must_use]
    pub fn picture(mut self, name: &str, picture: Picture) -> Self {
        self.pictures.push((name.to_owned(), picture));
        self
    }

    /// Adds a file of any other kind, such as a page, under its whole name.
    #[must_use]
    pub fn file(mut self, name: &str, bytes: Vec<u8>) -> Self {
        self.files.push((name.to_owned(), bytes));
        self
    }

    /// What the terminal shows: the story, all tables, then the claims, then the last line.
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

    /// Writes the pictures and, last, the summary; returns the paths.
    ///
    /// # Errors
    /// [`OutputError`] for the first file that cannot be written.
    pub fn write(&self, output: &Output) -> Result<Vec<PathBuf>, OutputError> {
        let mut paths = Vec::new();
        for (name, picture) in &self.pictures {
            paths.push(output.write_picture(name, picture)?);
        }
        for (name, bytes) in &self.files {
            paths.push(output.write(name, bytes)?);
        }
        paths.push(output.write_summary(&self.summary)?);
        Ok(paths)
    }
}

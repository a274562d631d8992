//! The record of one run of one experiment: everything that is printed, drawn or written.
//!
//! As JSON it is the claims file; its form is described in `docs/summary.schema.json`, what stands
//! in it in `docs/claims.md`.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::claims::{Claim, Origin, Verdict};
use super::judge::judge;
use super::seeds::{Status, sample};

/// The version of the form of the file.
pub const FORMAT: u32 = 2;

/// What an experiment returns; as JSON it is the claims file.
///
/// ```
/// use host_sim::report::{Summary, Table};
/// let mut summary = Summary::new("forage", &[100, 101]);
/// summary.parameter("radius", 5.0);
/// let mut table = Table::new(&["actions", "captures"]);
/// table.row([1000.into(), 17.5.into()]);
/// summary.table("learning curve", table);
/// let text = summary.to_json();
/// assert_eq!(Summary::from_json(&text)?.to_json(), text);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// The version of this form.
    pub format: u32,
    /// The name of the experiment, which is that of its subcommand.
    pub experiment: String,
    /// The version of the program.
    pub version: String,
    /// The command line that gives this result again.
    pub command: String,
    /// The commit that the program was built from, `-dirty` with changes; not in older files.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub commit: Option<String>,
    /// What the results may be called, by their seeds.
    pub status: Status,
    /// The seeds, in the order of every claim's measurements.
    pub seeds: Vec<u64>,
    /// Everything else that decides the result, in words.
    pub parameters: BTreeMap<String, Value>,
    /// All options of the experiment as they were given to it; not in older files.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub options: Option<Value>,
    /// How many claims came out how.
    pub verdicts: BTreeMap<String, u32>,
    /// The claims.
    pub claims: Vec<Claim>,
    /// Further numbers, by title.
    pub tables: BTreeMap<String, Table>,
    /// Fingerprint of everything above, so that no digit changes unnoticed.
    pub seal: String,
}

/// Rows of numbers and words under named columns.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Table {
    /// The heads of the columns.
    pub columns: Vec<String>,
    /// The rows, as long as the heads.
    pub rows: Vec<Vec<Value>>,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new(columns: &[&str]) -> Self {
        Self {
            columns: columns.iter().map(|&column| column.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row; numbers that are not finite become `null`.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Value>) {
        self.rows.push(cells.into_iter().collect());
    }
}

impl Summary {
    /// A summary without claims yet; the command line is filled in by whoever was called by it.
    #[must_use]
    pub fn new(experiment: &str, seeds: &[u64]) -> Self {
        Self {
            format: FORMAT,
            experiment: experiment.to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            command: String::new(),
            commit: None,
            status: Status::of(seeds),
            seeds: seeds.to_vec(),
            parameters: BTreeMap::new(),
            options: None,
            verdicts: BTreeMap::new(),
            claims: Vec::new(),
            tables: BTreeMap::new(),
            seal: String::new(),
        }
    }

    /// Notes a parameter that decides the result.
    pub fn parameter(&mut self, name: &str, value: impl Into<Value>) {
        self.parameters.insert(name.to_owned(), value.into());
    }

    /// Adds a claim.
    pub fn claim(&mut self, claim: Claim) {
        self.claims.push(claim);
    }

    /// Adds a table, in place of one with the same title.
    pub fn table(&mut self, title: &str, table: Table) {
        self.tables.insert(title.to_owned(), table);
    }

    /// Takes every verdict back: numbers of another world or length say nothing of the book's.
    pub fn vary(&mut self) {
        let claims = self.claims.iter_mut();
        claims.for_each(|claim| claim.origin = Origin::Varied);
    }

    /// The claim with this id; an id without its version finds the claim that has it now.
    #[must_use]
    pub fn find(&self, id: &str) -> Option<&Claim> {
        let mut claims = self.claims.iter();
        claims.find(|claim| claim.id == id || claim.name() == id)
    }

    /// The same run judged anew from what its seeds measured: families together, verdicts counted.
    #[must_use]
    pub fn judged(&self) -> Self {
        let mut again = self.clone();
        judge(&mut again.claims);
        again.verdicts = BTreeMap::new();
        for claim in &again.claims {
            *again.verdicts.entry(claim.verdict.to_string()).or_default() += 1;
        }
        again
    }

    /// How many seeds and which; those of layouts are their numbers.
    #[must_use]
    pub fn sample(&self) -> String {
        let seeds = sample(&self.seeds);
        match self.status {
            Status::Layouts => seeds.replacen("seeds", "layouts", 1),
            _ => seeds,
        }
    }

    /// The claims whose rule did not hold: the book's first, then our own aims.
    pub fn missed(&self) -> impl Iterator<Item = &Claim> {
        let of = |verdict| self.claims.iter().filter(move |it| it.verdict == verdict);
        of(Verdict::NotReproduced).chain(of(Verdict::Missed))
    }

    /// One line: how many claims came out how.
    ///
    /// ```
    /// use host_sim::report::{Expectation, Summary};
    /// let mut summary = Summary::new("forage", &[100]);
    /// summary.claim(Expectation::new("a.b", "6.1", "captures").judge(&[1.0]));
    /// assert_eq!(summary.verdict_line(), "1 measured");
    /// ```
    #[must_use]
    pub fn verdict_line(&self) -> String {
        let counts = Verdict::ALL.map(|verdict| {
            let same = self.claims.iter().filter(|it| it.verdict == verdict);
            (same.count(), verdict)
        });
        let parts: Vec<String> = counts
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, verdict)| format!("{count} {verdict}"))
            .collect();
        parts.join(", ")
    }

    /// The summary as JSON, judged and sealed: numbers come back to the last bit.
    #[must_use]
    pub fn to_json(&self) -> String {
        let mut judged = self.judged();
        judged.seal = String::new();
        judged.seal = format!("{:016x}", fnv1a(judged.text().as_bytes()));
        judged.text()
    }

    fn text(&self) -> String {
        let mut text = serde_json::to_string_pretty(self)
            .expect("a summary has only string keys and finite numbers");
        text.push('\n');
        text
    }

    /// Reads a summary back, as it stands.
    ///
    /// # Errors
    /// When the text is no summary.
    pub fn from_json(text: &str) -> Result<Self, serde_json::Error> {
        serde_json::from_str(text)
    }
}

/// Fowler, Noll and Vo's hash: finds accidents and oversights, and is no signature.
fn fnv1a(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[cfg(test)]
mod tests {
    use super::{Summary, fnv1a};
    use crate::report::{Bound, Expectation, Rule, Verdict};

    fn summary() -> Summary {
        let mut summary = Summary::new("a", &(100..112).collect::<Vec<u64>>());
        let seeds: Vec<f64> = (0..12).map(|it| f64::from(it) / 7.0).collect();
        for (id, least) in [("a.b", 0.5), ("a.c@2", 1.5)] {
            let claim = Expectation::new(id, "6.1", "captures").extension();
            summary.claim(claim.rule(Rule::mean(Bound::AtLeast(least))).judge(&seeds));
        }
        summary
    }

    #[test]
    fn a_file_is_what_its_seeds_say() {
        let text = summary().to_json();
        let read = Summary::from_json(&text).unwrap();
        assert_eq!(read.to_json(), text);
        assert_eq!(read.verdict_line(), "1 extension: met, 1 extension: missed");
        assert_eq!(read.verdicts["extension: met"], 1);
        assert_eq!(read.claims[0].tested.as_ref().unwrap().members, 2);
        // An altered verdict, seed or mean is not what is written again.
        for (from, to) in [
            ("\"extension: missed\"", "\"extension: met\""),
            ("0.14285714285714285", "0.14285714285714284"),
            ("mean >= 1.5", "mean >= 1.4"),
        ] {
            let altered = text.replacen(from, to, 1);
            assert_ne!(altered, text, "{from}");
            assert_ne!(
                Summary::from_json(&altered).unwrap().to_json(),
                altered,
                "{from}"
            );
        }
    }

    #[test]
    fn a_claim_is_found_by_its_id_with_and_without_version() {
        let summary = summary();
        assert!(summary.find("a.c").is_some() && summary.find("a.c@2").is_some());
        assert!(summary.find("a.c@1").is_none());
    }

    #[test]
    fn varied_numbers_have_no_verdict() {
        let mut summary = summary();
        summary.vary();
        let judged = summary.judged();
        assert!(
            judged
                .claims
                .iter()
                .all(|it| it.verdict == Verdict::Measured && it.met.is_none())
        );
    }

    #[test]
    fn the_fingerprint_is_the_published_one() {
        // Test vectors of the authors.
        assert_eq!(fnv1a(b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv1a(b"foobar"), 0x8594_4171_f739_67e8);
    }
}

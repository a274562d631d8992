//! What the experiment on survival varies.

use serde::{Deserialize, Serialize};

use super::part::{Part, Scale};
use super::parts::ALL;
use crate::failure::Impossible;

/// A part with a seed.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Case {
    /// The part's name.
    pub part: String,
    /// The seed.
    pub seed: u64,
}

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SurviveOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// What is run, each once and in the order of the list of parts.
    pub parts: Vec<Part>,
    /// By what everything is tried less often and lived shorter than the claims ask.
    pub shorter: Scale,
}

impl SurviveOptions {
    /// All parts but those that stand apart, at the lengths that the claims ask for.
    #[must_use]
    pub fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            parts: ALL.iter().filter(|it| !it.is_apart).copied().collect(),
            shorter: Scale(1),
        }
    }

    /// Parts by their names, `all`, or where none is named those that take minutes at most.
    ///
    /// # Errors
    /// [`Impossible`] for a name that is none, and for a part whose tools are missing.
    ///
    /// ```
    /// use host_sim::experiment::survive::SurviveOptions;
    /// let options = SurviveOptions::new(vec![1], &["resume".into()])?;
    /// assert_eq!(options.parts.len(), 1);
    /// assert!(SurviveOptions::new(vec![1], &["moon".into()]).is_err());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(seeds: Vec<u64>, names: &[String]) -> Result<Self, Impossible> {
        let everything = names.iter().any(|it| it == "all");
        for name in names {
            if name != "all" && ALL.iter().all(|part| part.name != name) {
                let known: Vec<&str> = ALL.iter().map(|part| part.name).collect();
                let known = known.join(", ");
                let sentence = format!("--part: there is no {name:?}; there are {known} and all");
                return Err(Impossible::new(sentence));
            }
        }
        let asked = |part: &&Part| {
            everything && !part.is_apart
                || names.is_empty() && !part.is_slow
                || names.iter().any(|it| it == part.name)
        };
        let parts: Vec<Part> = ALL.iter().filter(asked).copied().collect();
        for part in &parts {
            (part.look_for_tools)()?;
        }
        Ok(Self {
            parts,
            ..Self::standard(seeds)
        })
    }

    /// All seeds of the first part, then of the next.
    pub(super) fn cases(&self) -> Vec<Case> {
        let of_part = |part: &Part| {
            let part = part.name.to_owned();
            self.seeds.iter().map(move |&seed| Case {
                part: part.clone(),
                seed,
            })
        };
        self.parts.iter().flat_map(of_part).collect()
    }

    /// The options of which these are all the cases; some parts with the same seeds.
    pub(super) fn of_cases(&self, cases: &[Case]) -> Option<Self> {
        let has = |part: &&Part| cases.iter().any(|it| it.part == part.name);
        let parts: Vec<Part> = self.parts.iter().filter(has).copied().collect();
        let first = parts.first()?;
        let seeds = cases.iter().filter(|it| it.part == first.name);
        let it = Self {
            seeds: seeds.map(|it| it.seed).collect(),
            parts,
            shorter: self.shorter,
        };
        (it.cases() == cases).then_some(it)
    }
}

//! What the experiment with one learner varies.

use cla_core::forest::MindConfig;
use serde::Serialize;
use serde_json::json;

use crate::experiment::settled::file;
use crate::failure::Impossible;
use crate::settings::tree_of;

/// A part of the experiment, which can be run without the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Part {
    /// Specimens collected after trainings of several lengths.
    Forager,
    /// The forager is damaged in mid-life.
    Recover,
    /// The forager's readings get lost.
    Unknown,
    /// Items blink beside the forager's own.
    Distractors,
    /// The slippery lake.
    Lake,
    /// Chrisman's shuttle.
    Shuttle,
    /// The vacuum cleaner.
    Vacuum,
    /// Keys and doors.
    Keys,
    /// Worlds by chance.
    Generated,
    /// A forager to whom bumping is worth less than nothing.
    Harm,
    /// A forager that watches another robot.
    Teach,
}

impl Part {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Forager,
        Self::Recover,
        Self::Unknown,
        Self::Distractors,
        Self::Lake,
        Self::Shuttle,
        Self::Vacuum,
        Self::Keys,
        Self::Generated,
        Self::Harm,
        Self::Teach,
    ];

    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Forager => "forager",
            Self::Recover => "recover",
            Self::Unknown => "unknown",
            Self::Distractors => "distractors",
            Self::Lake => "lake",
            Self::Shuttle => "shuttle",
            Self::Vacuum => "vacuum",
            Self::Keys => "keys",
            Self::Generated => "generated",
            Self::Harm => "harm",
            Self::Teach => "teach",
        }
    }

    /// Whether the same trained forager begins it.
    pub(super) const fn begins_with_the_forager(self) -> bool {
        matches!(
            self,
            Self::Forager | Self::Recover | Self::Unknown | Self::Distractors | Self::Harm
        )
    }
}

/// What is varied.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OneOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// What is run, in the order of [`Part::ALL`], each once.
    pub parts: Vec<Part>,
    /// Whether the forager also lives 200,000 and then ten million actions.
    pub long: bool,
    /// By what all lives are shorter than the claims ask; at least 1.
    pub shorter: u32,
    /// The learner's configuration, one in every world.
    #[serde(skip_serializing_if = "is_standard")]
    pub config: MindConfig,
}

fn is_standard(config: &MindConfig) -> bool {
    *config == MindConfig::DEFAULT
}

impl OneOptions {
    /// All parts at the lengths that the claims ask for, without the long lives.
    #[must_use]
    pub fn standard(seeds: Vec<u64>) -> Self {
        Self {
            seeds,
            parts: Part::ALL.to_vec(),
            long: false,
            shorter: 1,
            config: MindConfig::DEFAULT,
        }
    }

    /// Parts by their names, all where none is named.
    ///
    /// # Errors
    /// [`Impossible`] for a name that is none.
    ///
    /// ```
    /// use host_sim::experiment::one::{OneOptions, Part};
    /// let options = OneOptions::new(vec![1], &["keys".into(), "lake".into()], false)?;
    /// assert_eq!(options.parts, [Part::Lake, Part::Keys]);
    /// assert!(OneOptions::new(vec![1], &["moon".into()], false).is_err());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(seeds: Vec<u64>, names: &[String], long: bool) -> Result<Self, Impossible> {
        for name in names {
            if Part::ALL.iter().all(|part| part.name() != name) {
                let known = Part::ALL.map(Part::name).join(", ");
                let sentence = format!("--parts: there is no {name:?}; there are {known}");
                return Err(Impossible::new(sentence));
            }
        }
        let asked = |part: &Part| names.is_empty() || names.iter().any(|it| it == part.name());
        let parts: Vec<Part> = Part::ALL.into_iter().filter(asked).collect();
        if long && !parts.contains(&Part::Forager) {
            return Err(Impossible::new("--long goes with the part forager alone"));
        }
        Ok(Self {
            parts,
            long,
            ..Self::standard(seeds)
        })
    }

    /// Whether these are other lives than those that the claims are about.
    #[must_use]
    pub fn is_varied(&self) -> bool {
        self.shorter > 1 || !is_standard(&self.config)
    }

    /// All settings as a file, of which the same options come.
    ///
    /// # Errors
    /// [`Impossible`] for a value that TOML cannot say.
    pub fn file(&self) -> Result<String, Impossible> {
        let parts: Vec<&str> = self.parts.iter().map(|it| it.name()).collect();
        file(
            &self.seeds,
            json!({
                "parts": parts,
                "long": self.long,
                "shorter": self.shorter,
                "agent": tree_of(&self.config)?,
            }),
        )
    }

    /// A length of the claims, as it is lived here.
    pub(super) fn length(&self, actions: u32) -> u32 {
        (actions / self.shorter.max(1)).max(1)
    }

    /// Whether a part is run.
    pub(super) fn has(&self, part: Part) -> bool {
        self.parts.contains(&part)
    }
}

//! Which of the book's level-2 schemas a forager has (6.2.6): 6.6, 6.9, 6.10, 6.13 and 6.14.
//!
//! A printed schema stands for every stored one with the same positive items.
//! It counts as *generated* when the item in its result is on clearly more often after it than the
//! item's own schema succeeds at level 1: that is what the book says each of them means.

use cla_core::forager::pioneer::VOCABULARY;
use cla_core::knowledge::SyntheticId;
use cla_core::word::{NotationError, SchemaText};
use serde::{Deserialize, Serialize};
use statrs::distribution::{Binomial, DiscreteCDF};

use super::measure::record_of;
use super::som_level2::TwoLevels;

/// One of the book's level-2 schemas, as the schemas that its items stand for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Printed {
    /// Its number.
    pub number: &'static str,
    /// As the book prints it.
    pub text: &'static str,
    /// What has succeeded before, if its context tells that.
    pub trace: Option<&'static str>,
    /// Its primitive part, the schema that succeeds with it.
    pub host: &'static str,
    /// The schema whose item is in its result.
    pub item: &'static str,
}

/// The five schemas.
///
/// 6.6's context item is its own host's: it is on when the host succeeds, "of course".
/// 6.9 is about a robot that sees nothing, turns right and still sees nothing: else its second
/// turn could reveal nothing.
/// 6.14's context is the result of 6.13, so what has succeeded before is 6.13's host: the robot
/// turns left twice.
pub const PRINTED: [Printed; 5] = [
    Printed {
        number: "6_6",
        text: "+[+s1/turnl/+s1]/turnl/+s1+[+s1/turnl/+s2]",
        trace: None,
        host: "+s1/turnl/+s1",
        item: "+s1/turnl/+s2",
    },
    Printed {
        number: "6_9",
        text: "[/turnr/+s5]/turnr/[/turnr/+s5]",
        trace: None,
        host: "/turnr/",
        item: "/turnr/+s5",
    },
    Printed {
        number: "6_10",
        text: "+s5/turnl/-s5+[/turnr/+s5]",
        trace: None,
        host: "+s5/turnl/",
        item: "/turnr/+s5",
    },
    Printed {
        number: "6_13",
        text: "+s2/turnl/+s3+[+s3/forward/+s2]",
        trace: None,
        host: "+s2/turnl/+s3",
        item: "+s3/forward/+s2",
    },
    Printed {
        number: "6_14",
        text: "+s3+[+s3/forward/+s2]/turnl/+s3+[+s3/forward/+s3]",
        trace: Some("+s2/turnl/+s3"),
        host: "+s3/turnl/+s3",
        item: "+s3/forward/+s3",
    },
];

/// How improbable it must be that the item was on so often by the chance with which its schema
/// succeeds anyway: one-sided, by the binomial distribution, which holds for few occasions too.
pub const CLEARLY: f64 = 0.05;
/// Times that the item must have been on: once is an accident.
pub const LEAST: u64 = 2;

/// What a forager knows of a printed schema.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Occasions on which the item was verified after the schema, the newest weighing most.
    pub tried: f64,
    /// Those on which it was on.
    pub on: f64,
    /// Reliability of the item's own schema at level 1; 0 when it is unknown there.
    pub level1: f64,
    /// How often the primitive part succeeds when its action is done in its context.
    pub host: f64,
}

impl Finding {
    /// The book's way: of the occasions on which the primitive part succeeded and the item was
    /// verified, the share on which it was on; `None` without evidence.
    #[must_use]
    pub fn hindsight(&self) -> Option<f64> {
        (self.tried > 0.0).then(|| self.on / self.tried)
    }

    /// How probable it is before the action that all of the result comes.
    #[must_use]
    pub fn prospective(&self) -> Option<f64> {
        Some(self.host * self.hindsight()?)
    }

    /// Whether the item is on clearly more often than its schema succeeds at level 1.
    ///
    /// ```
    /// use host_sim::experiment::forage::level2_schemas::Finding;
    /// let finding = Finding { tried: 40.0, on: 20.0, level1: 0.3, host: 0.5 };
    /// assert!(finding.is_generated());
    /// assert!(!Finding { on: 14.0, ..finding }.is_generated());
    /// // Two of two where one in three is usual says nothing, three of three does.
    /// assert!(!Finding { tried: 2.0, on: 2.0, ..finding }.is_generated());
    /// assert!(Finding { tried: 3.0, on: 3.0, ..finding }.is_generated());
    /// // Neither once nor where level 1 knows nothing to compare with.
    /// assert!(!Finding { tried: 1.0, on: 1.0, level1: 0.01, ..finding }.is_generated());
    /// assert!(!Finding { level1: 0.0, ..finding }.is_generated());
    /// ```
    #[must_use]
    pub fn is_generated(&self) -> bool {
        // Older occasions weigh less, so that the counts are no whole numbers: rounded against us.
        let (on, tried) = (self.on.floor() as u64, self.tried.ceil() as u64);
        // A reliability is a probability; that of a schema which level 1 does not know is 0.
        let chance = Binomial::new(self.level1, tried);
        on >= LEAST && self.level1 > 0.0 && chance.is_ok_and(|it| it.sf(on - 1) < CLEARLY)
    }
}

/// What a forager knows of each of [`PRINTED`].
///
/// # Errors
/// [`NotationError`] of a printed schema that the robot has no words for.
pub fn findings(forager: &TwoLevels) -> Result<[Finding; 5], NotationError> {
    let mut findings = [Finding::default(); 5];
    for (finding, printed) in findings.iter_mut().zip(&PRINTED) {
        *finding = find(forager, printed)?;
    }
    Ok(findings)
}

fn find(forager: &TwoLevels, printed: &Printed) -> Result<Finding, NotationError> {
    let parse = |text: &str| SchemaText::<1>::parse(text, &VOCABULARY);
    let (host, item) = (parse(printed.host)?, parse(printed.item)?);
    let trace = printed.trace.map(parse).transpose()?;
    let level = &forager.level;
    let reads = |id: SyntheticId, text: &SchemaText<1>| {
        level.text(id).is_some_and(|stored| alike(&stored, text))
    };
    let items: Vec<SyntheticId> = (0..level.items())
        .map(SyntheticId)
        .filter(|&id| reads(id, &item))
        .collect();
    let knowledge = forager.brain.knowledge();
    let reliability = |text| record_of(knowledge, text).reliability().unwrap_or(0.0);
    let mut finding = Finding {
        level1: reliability(&item),
        host: reliability(&host),
        ..Finding::default()
    };
    let (mut host_tried, mut host_on) = (0.0, 0.0);
    for (row, before) in level.schemas() {
        let right_trace = match (&trace, before) {
            (None, None) => true,
            (Some(trace), Some(before)) => reads(before, trace),
            _ => false,
        };
        if right_trace && reads(row, &host) {
            finding.tried += f64::from(level.tried(row, before, item.action));
            for &item in &items {
                finding.on += f64::from(level.on(row, before, item));
            }
        }
        if let (Some(trace), None) = (&trace, before)
            && reads(row, trace)
        {
            host_tried += f64::from(level.tried(row, None, host.action));
            for id in (0..level.items()).map(SyntheticId) {
                if reads(id, &host) {
                    host_on += f64::from(level.on(row, None, id));
                }
            }
        }
    }
    if host_tried > 0.0 {
        finding.host = host_on / host_tried;
    }
    Ok(finding)
}

/// Whether the book would print both the same way.
fn alike(one: &SchemaText<1>, other: &SchemaText<1>) -> bool {
    one.action == other.action
        && one.context.positive() == other.context.positive()
        && one.result.positive() == other.result.positive()
}

#[cfg(test)]
mod tests {
    use super::{PRINTED, alike, findings};
    use crate::experiment::forage::ForageOptions;
    use crate::experiment::forage::harvested::trained;
    use crate::world::config::PioneerConfig;
    use crate::world::setting::WorldOptions;
    use cla_core::agent::{Adaptation, AgentConfig};
    use cla_core::forager::pioneer::VOCABULARY;
    use cla_core::level2::SomLevelConfig;
    use cla_core::word::SchemaText;

    #[test]
    fn negative_items_make_no_difference_in_print() {
        let text = |schema| SchemaText::<1>::parse(schema, &VOCABULARY).unwrap();
        assert!(alike(&text("-s1+s5/turnl/-s5"), &text("+s5/turnl/")));
        assert!(!alike(&text("+s5/turnl/+s5"), &text("+s5/turnl/")));
        assert!(!alike(&text("+s5/turnr/"), &text("+s5/turnl/")));
    }

    #[test]
    fn a_sector_is_refined_by_what_has_succeeded() {
        let options = ForageOptions {
            seeds: vec![3],
            world: WorldOptions {
                config: PioneerConfig::NOISY,
                layout: None,
                path: None,
            },
            brain: AgentConfig::FORAGER,
            actions: 10_000,
            test_actions: 0,
        };
        let mut forager = trained(&options, SomLevelConfig::FORAGER, 0.8, 3).unwrap();
        forager.act(Adaptation::Reliabilities).unwrap();
        let findings = findings(&forager).unwrap();
        let (printed, finding) = (&PRINTED[0], &findings[0]);
        assert_eq!(printed.number, "6_6");
        assert!(finding.is_generated(), "{finding:?}");
        // What is known only afterwards looks better than what can be foreseen.
        assert!(finding.hindsight() > finding.prospective());
    }
}

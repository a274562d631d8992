//! Bits of a living brain that turn while the robot moves: between a choice and its result, in what is
//! learned and in what is computed from it, one in so many actions.
//!
//! Beside the undisturbed life stand those of a brain that nobody looks after, of one that looks itself
//! through before every call, and of one that is sealed after every call and checked before the next.
//! What cannot be mended goes on from the last image, which is made every few hundred actions.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::small;
use cla_core::forest::MindConfig;
use cla_core::num::Rng;
use cla_core::snapshot::{self, Audit, Names, Scrub, Snapshot, faults};

use super::super::configurations::VALUE;
use super::super::part::{Part, Scale, claim, never, tried};
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::learner::mind::{Brain, Minded};
use crate::learner::native::Native;
use crate::learner::{Learner, live};
use crate::report::{Bound, Claim, Rule};
use crate::world::config::PioneerConfig;
use crate::world::pioneer::{ACTIONS, INGRIP, ITEMS, Pioneer};
use crate::world::{Percept, World};

/// The part.
pub(crate) const PART: Part = Part {
    name: "ram_flips",
    is_slow: true,
    measure,
    claims,
    ..Part::QUICK
};

/// Actions of the training, and of each life that is disturbed; and how many lives there are of each
/// kind after one training.
const TRAINING: u32 = 10_000;
const ACTING: u32 = 1000;
const LIVES: u64 = 5;
/// Actions between two images.
const SAVED_EVERY: u32 = 250;
/// How often bits turn, and how many at once; the last is more than a seal can turn back.
const HITS: [Hits; 3] = [
    Hits {
        name: "100",
        every: 100,
        at_once: 1,
        least: Some(0.97),
    },
    Hits {
        name: "10",
        every: 10,
        at_once: 1,
        least: Some(0.9),
    },
    Hits {
        name: "10x4",
        every: 10,
        at_once: 4,
        least: None,
    },
];
/// Sums of the largest seal.
const SUMS: usize = 1024;

/// How a memory is hit.
#[derive(Clone, Copy, Debug)]
struct Hits {
    name: &'static str,
    /// Once in so many actions; 0 is never.
    every: u32,
    at_once: u32,
    /// Of the undisturbed captures what is asked of a brain that is scrubbed.
    least: Option<f64>,
}

/// No hit at all.
const UNDISTURBED: Hits = Hits {
    name: "undisturbed",
    every: 0,
    at_once: 0,
    least: None,
};

/// Who looks after a brain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Care {
    Nobody,
    /// It looks itself through before every call.
    Audit,
    /// It is sealed after every call and checked before the next.
    Scrub,
}

const CARES: [(&str, Care); 3] = [
    ("unguarded", Care::Nobody),
    ("audited", Care::Audit),
    ("scrubbed", Care::Scrub),
];

/// A learner whose memory can be hit.
trait Exposed: Learner + Clone {
    type Memory: Snapshot;
    fn memory(&mut self) -> &mut Self::Memory;
    fn look_through(&mut self) -> Audit;
}

impl Exposed for Native<small::Brain> {
    type Memory = small::Brain;

    fn memory(&mut self) -> &mut small::Brain {
        self.brain_mut()
    }

    fn look_through(&mut self) -> Audit {
        self.brain_mut().audit()
    }
}

impl Exposed for Minded<1, 7, 6> {
    type Memory = Brain<1, 7, 6>;

    fn memory(&mut self) -> &mut Brain<1, 7, 6> {
        self.mind_mut()
    }

    fn look_through(&mut self) -> Audit {
        self.mind_mut().audit()
    }
}

/// What came of it.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    flips: u32,
    mended: u32,
    lost: u32,
    /// Choices of a value that is no number.
    not_finite: u32,
    /// Whether the brain could not be saved at the end of its life.
    unsaved: u32,
    panicked: u32,
}

/// A learner that is hit, and who looks after it.
struct Hit<L> {
    learner: L,
    care: Care,
    hits: Hits,
    /// Whether its brain was lost since the last choice.
    lost: bool,
    actions: u32,
    rng: Rng,
    scrub: Scrub<SUMS>,
    image: Vec<u8>,
    counts: Counts,
}

impl<L: Exposed> Hit<L> {
    /// What is done before a call.
    fn before(&mut self) -> Result<(), Failure> {
        let found = match self.care {
            Care::Nobody => return Ok(()),
            Care::Audit => self.learner.look_through(),
            Care::Scrub => match self.scrub.check(self.learner.memory()) {
                Some(found) => found,
                None => return Ok(()),
            },
        };
        match found {
            Audit::Sound => {}
            Audit::Mended(_) => self.counts.mended += 1,
            Audit::Lost(_) => {
                self.counts.lost += 1;
                self.lost = true;
                self.learner.go_on_from(names(), &self.image)?;
            }
        }
        Ok(())
    }

    /// What is done after a call.
    fn after(&mut self) -> Result<(), Failure> {
        if self.care == Care::Scrub {
            self.scrub.seal(self.learner.memory())?;
        }
        Ok(())
    }

    /// Whether the brain cannot be saved: it holds a number that is none, or a link to nothing.
    fn is_damaged(&mut self) -> bool {
        snapshot::length(&*self.learner.memory()).is_err()
    }
}

impl<L: Exposed> Learner for Hit<L> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        self.before()?;
        self.lost = false;
        if self.care != Care::Nobody && self.actions.is_multiple_of(SAVED_EVERY) {
            let image = self.learner.image(names())?;
            self.image = image.ok_or("a brain has an image")?;
        }
        let chosen = self.learner.choose(now)?;
        let value = self.learner.reason().value;
        self.counts.not_finite += u32::from(!value.is_finite());
        self.after()?;
        self.actions += 1;
        if self.hits.every > 0 && self.actions.is_multiple_of(self.hits.every) {
            let bits = faults::bits(self.learner.memory());
            for _ in 0..self.hits.at_once {
                faults::flip(self.learner.memory(), self.rng.below(bits));
                self.counts.flips += 1;
            }
        }
        Ok(chosen)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.before()?;
        let learned = self.learner.learn(now);
        self.after()?;
        // Who lost what it had chosen has nothing to learn from; that is no end.
        if self.lost { Ok(()) } else { learned }
    }

    fn observe(&mut self, before: &Percept, action: usize, after: &Percept) -> Result<(), Failure> {
        self.before()?;
        self.learner.observe(before, action, after)?;
        self.after()
    }
}

fn names() -> Names {
    Names::of(&ITEMS, &ACTIONS)
}

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let mut brain = Box::new(small::brain());
    small::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, seed)?;
    lives(
        "agent",
        Native::new(brain, Adaptation::Relearning),
        scale,
        seed,
        trial,
    )?;
    let mut values = [0.0; ITEMS.len()];
    values[usize::from(INGRIP)] = VALUE;
    let mind = Minded::<1, 7, 6>::born(MindConfig::DEFAULT, values, seed)?;
    lives("mind", mind, scale, seed, trial)
}

/// Trains, and lives on in every way.
fn lives<L: Exposed>(
    name: &str,
    mut learner: L,
    scale: Scale,
    seed: u64,
    trial: &mut Trial,
) -> Result<(), Failure> {
    let mut room = Pioneer::new(PioneerConfig::NOISY, seed)?;
    live(&mut learner, &mut room, scale.of(TRAINING))?;
    learner.act()?;
    let acting = scale.of(ACTING);
    let life = |care, hits, number| -> Result<(u32, Counts, bool), Failure> {
        let mut hit = Hit {
            learner: learner.clone(),
            care,
            hits,
            lost: false,
            actions: 0,
            rng: Rng::stream(seed, 75 + number),
            scrub: Scrub::new(),
            image: Vec::new(),
            counts: Counts::default(),
        };
        let mut room = Pioneer::new(PioneerConfig::NOISY, seed + 1000 * (number + 1))?;
        // What it has counted is read after a panic, and nothing else.
        let life = AssertUnwindSafe(|| live(&mut hit, &mut room, acting).is_err());
        let ended = catch_unwind(life);
        hit.counts.panicked = u32::from(ended.is_err());
        if ended.is_ok() {
            // Choices show what is wrong where they meet it, and an image wherever it is.
            hit.counts.unsaved = u32::from(hit.is_damaged());
        }
        Ok((room.obtained(), hit.counts, ended.unwrap_or(true)))
    };
    let mut undisturbed = 0;
    for number in 0..LIVES {
        undisturbed += life(Care::Nobody, UNDISTURBED, number)?.0;
    }
    trial.note(format!("ram_flips.{name}.undisturbed"), undisturbed);
    for hits in HITS {
        for (how, care) in CARES {
            let mut sums = [0; 8];
            for number in 0..LIVES {
                let (captures, counts, ended) = life(care, hits, number)?;
                let of_life = [
                    captures,
                    counts.flips,
                    counts.mended,
                    counts.lost,
                    counts.not_finite,
                    counts.unsaved,
                    counts.panicked,
                    u32::from(ended),
                ];
                sums.iter_mut()
                    .zip(of_life)
                    .for_each(|(sum, it)| *sum += it);
            }
            let what = [
                "captures",
                "flips",
                "mended",
                "lost",
                "not_finite",
                "unsaved",
                "panicked",
                "ended",
            ];
            for (what, sum) in what.into_iter().zip(sums) {
                let hits = hits.name;
                trial.note(format!("ram_flips.{name}.{how}.{hits}.{what}"), sum);
            }
        }
    }
    Ok(())
}

/// The sums of what was measured under this care of an agent and a mind, seed by seed, with one flip
/// at a time or with several.
fn sums(trials: &[Trial], care: &str, several: bool, what: &str) -> Vec<f64> {
    let mut sums = vec![0.0; trials.len()];
    for name in ["agent", "mind"] {
        for hits in HITS.iter().filter(|it| (it.at_once > 1) == several) {
            let hits = hits.name;
            let more = of(trials, &format!("ram_flips.{name}.{care}.{hits}.{what}"));
            sums.iter_mut().zip(more).for_each(|(sum, it)| *sum += it);
        }
    }
    sums
}

/// What is claimed of all brains under a care, whatever else is done for them.
fn of_care(trials: &[Trial], care: &str) -> Vec<Claim> {
    let one = |what| sums(trials, care, false, what);
    let id = format!("ram_flips.{care}");
    let rule = match care {
        "unguarded" => Rule::Measured,
        _ => Rule::every_seed(Bound::AtMost(0.0)),
    };
    vec![
        never(
            &id,
            "choices",
            "choices of a value that is no finite number, of an agent and a mind, at one flip in 100 and \
             in 10 actions",
            &one("not_finite"),
        ),
        never(
            &format!("{id}.panics"),
            "lives",
            "of twenty lives those that panicked; a hang would have kept the run from its end",
            &one("panicked"),
        ),
        claim(&format!("{id}.unsaved"), "lives")
            .rule(rule.clone())
            .note(
                "of twenty lives those at whose end a number was not finite or a link led nowhere",
            )
            .judge(&one("unsaved")),
        claim(&format!("{id}.ended"), "lives")
            .rule(rule)
            .note("lives that ended because a call was refused, but for learning after a loss")
            .judge(&one("ended")),
        tried(&format!("{id}.flips"), "bits", 5_000.0, &one("flips")),
    ]
}

/// Captures as a share of the undisturbed ones, seed by seed.
fn shares(trials: &[Trial], name: &str, care: &str, hits: &str) -> Vec<f64> {
    let undisturbed = of(trials, &format!("ram_flips.{name}.undisturbed"));
    let captures = of(trials, &format!("ram_flips.{name}.{care}.{hits}.captures"));
    let pairs = captures.iter().zip(undisturbed);
    pairs.map(|(some, all)| some / all.max(1.0)).collect()
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    const UNIT: &str = "of the undisturbed captures";
    let mut claims = Vec::new();
    for (care, _) in CARES {
        claims.extend(of_care(trials, care));
        let several = sums(trials, care, true, "not_finite");
        let id = format!("ram_flips.{care}.several");
        let note =
            "choices of a value that is no finite number, at four flips at once in 10 actions";
        claims.push(claim(&id, "choices").note(note).judge(&several));
    }
    for name in ["agent", "mind"] {
        for hits in HITS {
            for (care, _) in CARES {
                let shares = shares(trials, name, care, hits.name);
                // The rule of one that is scrubbed was there first.
                let (id, rule) = match (care, hits.least) {
                    ("scrubbed", Some(least)) => (
                        format!("ram_flips.{name}.{}", hits.name),
                        Rule::mean(Bound::AtLeast(least)),
                    ),
                    _ => (
                        format!("ram_flips.{name}.{}.{care}", hits.name),
                        Rule::Measured,
                    ),
                };
                claims.push(claim(&id, UNIT).rule(rule).note(care).judge(&shares));
            }
        }
    }
    claims
}

#[cfg(test)]
#[path = "ram_flips_tests.rs"]
mod tests;

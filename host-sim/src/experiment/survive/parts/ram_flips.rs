//! Bits of a living brain that turn while the robot moves: between a choice and its result, in what is
//! learned and in what is computed from it, one in so many actions.
//!
//! Beside the undisturbed life stand those of a brain that nobody looks after, of one that looks itself
//! through before every call, and of one that is sealed after every call and checked before the next.
//! What cannot be mended goes on from the last image, which is made every few hundred actions.

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::small;
use cla_core::forest::MindConfig;
use cla_core::num::Rng;
use cla_core::snapshot::{Audit, Names, Scrub, Snapshot, faults};

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
/// A bit turns once in so many actions.
const EVERY: [u32; 2] = [100, 10];
/// Sums of the largest seal.
const SUMS: usize = 1024;

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
    not_finite: u32,
}

/// A learner that is hit, and who looks after it.
struct Hit<L> {
    learner: L,
    care: Care,
    every: u32,
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
}

impl<L: Exposed> Learner for Hit<L> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        self.before()?;
        if self.care != Care::Nobody && self.actions.is_multiple_of(SAVED_EVERY) {
            let image = self.learner.image(names())?;
            self.image = image.ok_or("a brain has an image")?;
        }
        let chosen = self.learner.choose(now)?;
        let value = self.learner.reason().value;
        self.counts.not_finite += u32::from(!value.is_finite());
        self.after()?;
        self.actions += 1;
        if self.every > 0 && self.actions.is_multiple_of(self.every) {
            let bits = faults::bits(self.learner.memory());
            faults::flip(self.learner.memory(), self.rng.below(bits));
            self.counts.flips += 1;
        }
        Ok(chosen)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.before()?;
        let learned = self.learner.learn(now);
        self.after()?;
        // Who lost what it had chosen has nothing to learn from; that is no end.
        match self.care {
            Care::Nobody => learned,
            Care::Audit | Care::Scrub => Ok(()),
        }
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
    let life = |care, every, number| -> Result<(u32, Counts, bool), Failure> {
        let mut hit = Hit {
            learner: learner.clone(),
            care,
            every,
            actions: 0,
            rng: Rng::stream(seed, 75 + number),
            scrub: Scrub::new(),
            image: Vec::new(),
            counts: Counts::default(),
        };
        let mut room = Pioneer::new(PioneerConfig::NOISY, seed + 1000 * (number + 1))?;
        let ended = live(&mut hit, &mut room, acting).is_err();
        Ok((room.obtained(), hit.counts, ended))
    };
    let mut undisturbed = 0;
    for number in 0..LIVES {
        undisturbed += life(Care::Nobody, 0, number)?.0;
    }
    trial.note(format!("ram_flips.{name}.undisturbed"), undisturbed);
    for every in EVERY {
        for (how, care) in CARES {
            let mut sums = [0; 6];
            for number in 0..LIVES {
                let (captures, counts, ended) = life(care, every, number)?;
                let of_life = [
                    captures,
                    counts.flips,
                    counts.mended,
                    counts.lost,
                    counts.not_finite,
                    u32::from(ended),
                ];
                sums.iter_mut()
                    .zip(of_life)
                    .for_each(|(sum, it)| *sum += it);
            }
            let what = ["captures", "flips", "mended", "lost", "not_finite", "ended"];
            for (what, sum) in what.into_iter().zip(sums) {
                trial.note(format!("ram_flips.{name}.{how}.{every}.{what}"), sum);
            }
        }
    }
    Ok(())
}

/// All numbers of an ending of what was measured under this care, seed by seed.
fn all(trials: &[Trial], care: &str, what: &str) -> Vec<f64> {
    let mut sums = vec![0.0; trials.len()];
    for name in ["agent", "mind"] {
        for every in EVERY {
            let more = of(trials, &format!("ram_flips.{name}.{care}.{every}.{what}"));
            sums.iter_mut().zip(more).for_each(|(sum, it)| *sum += it);
        }
    }
    sums
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let with_care = |what| -> Vec<f64> {
        let (audited, scrubbed) = (all(trials, "audited", what), all(trials, "scrubbed", what));
        audited
            .iter()
            .zip(scrubbed)
            .map(|(one, two)| one + two)
            .collect()
    };
    let mut claims = vec![
        never(
            "ram_flips",
            "choices",
            "choices of a value that is no finite number, of an agent and a mind that are audited or \
             scrubbed, at one flip in 100 and in 10 actions",
            &with_care("not_finite"),
        ),
        never(
            "ram_flips.ended",
            "lives",
            "lives of these that ended before their time",
            &with_care("ended"),
        ),
        tried("ram_flips.flips", "bits", 10_000.0, &with_care("flips")),
    ];
    for name in ["agent", "mind"] {
        let undisturbed = of(trials, &format!("ram_flips.{name}.undisturbed"));
        for (every, least) in EVERY.into_iter().zip([0.97, 0.9]) {
            let captures = of(
                trials,
                &format!("ram_flips.{name}.scrubbed.{every}.captures"),
            );
            let shares = captures.iter().zip(&undisturbed);
            let shares: Vec<f64> = shares.map(|(one, all)| one / all.max(1.0)).collect();
            claims.push(
                claim(
                    &format!("ram_flips.{name}.{every}"),
                    "of the undisturbed captures",
                )
                .rule(Rule::mean(Bound::AtLeast(least)))
                .note("sealed after every call and checked before the next")
                .judge(&shares),
            );
        }
    }
    claims
}

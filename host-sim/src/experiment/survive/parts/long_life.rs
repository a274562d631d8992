//! Lives without an end in a world that does not change: the named configurations in the Pioneer's
//! room and at the lamp, block by block.
//!
//! After its training each acts and goes on learning (`Adaptation::Relearning`).

use cla_core::agent::AgentConfig;
use cla_core::forest::MindConfig;

use super::super::configurations::{self, CONFIGURATIONS, Named, VALUE, forager, moth};
use super::super::lamp::{Lamp, names as lamp_names};
use super::super::part::{Part, Scale, claim, never};
use crate::device::target::Target;
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::learner::{Learner, live, watched};
use crate::report::{Bound, Claim, Rule, mean};
use crate::world::World;
use crate::world::config::PioneerConfig;
use crate::world::pioneer::{ACTIONS, ITEMS, Pioneer};
use cla_core::snapshot::Names;

/// Ten million actions of the configurations of other parts, in both worlds.
pub(crate) const LONG: Part = Part {
    name: LONG_LIVES.part,
    is_slow: true,
    measure: |scale, seed, trial| LONG_LIVES.measure(scale, seed, trial),
    claims: |trials| LONG_LIVES.claims(trials),
    ..Part::QUICK
};

/// The same of those whose habits last.
pub(crate) const LASTING: Part = Part {
    name: LASTING_LIVES.part,
    is_slow: true,
    measure: |scale, seed, trial| LASTING_LIVES.measure(scale, seed, trial),
    claims: |trials| LASTING_LIVES.claims(trials),
    ..Part::QUICK
};

/// A hundred million at the lamp, of everybody: 800 million actions a seed.
pub(crate) const LONGEST: Part = Part {
    name: LONGEST_LIVES.part,
    is_slow: true,
    is_apart: true,
    measure: |scale, seed, trial| LONGEST_LIVES.measure(scale, seed, trial),
    claims: |trials| LONGEST_LIVES.claims(trials),
    ..Part::QUICK
};

/// Who lives where, and how long.
struct Lives {
    part: &'static str,
    configurations: &'static [Named],
    /// Blocks in each of `WORLDS`; none is lived where there are 0.
    blocks: [usize; 2],
}

const LONG_LIVES: Lives = Lives {
    part: "long_life",
    configurations: &CONFIGURATIONS,
    blocks: [100, 100],
};
const LASTING_LIVES: Lives = Lives {
    part: "lasting",
    configurations: &configurations::LASTING,
    blocks: [100, 100],
};
const LONGEST_LIVES: Lives = Lives {
    part: "longest_life",
    configurations: &configurations::ALL,
    blocks: [0, 1000],
};

/// Actions of the training.
const TRAINING: u32 = 20_000;
/// Actions of a block.
const BLOCK: u32 = 100_000;
/// Actions between two looks at what choices are held to be worth.
const LOOK: u32 = 97;
/// What every block has to reach: of the best one's mean, and of the best that its own life had before.
const SHARE: f64 = 0.9;

/// Where they live, as claims name it.
const WORLDS: [&str; 2] = ["forager", "lamp"];

impl Lives {
    fn measure(&self, scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
        let [in_room, at_lamp] = self.blocks;
        for &(name, config) in self.configurations {
            if in_room > 0 {
                let room = Pioneer::new(PioneerConfig::NOISY, seed)?;
                let names = Names::of(&ITEMS, &ACTIONS);
                let mut life = Life::new(scale, config, forager(config, seed)?, room)?;
                life.live(scale, in_room, names)?;
                life.note(&self.life("forager", name), trial);
            }
            if at_lamp > 0 {
                let lamp = Lamp::new(seed);
                let mut life = Life::new(scale, config, moth(config, seed)?, lamp)?;
                life.live(scale, at_lamp, lamp_names())?;
                life.note(&self.life("lamp", name), trial);
            }
        }
        Ok(())
    }

    /// How what is measured of a life is called.
    fn life(&self, world: &str, name: &str) -> String {
        format!("{}.{world}.{name}", self.part)
    }

    /// Where somebody lives, and for how many blocks.
    fn worlds(&self) -> impl Iterator<Item = (&'static str, usize)> {
        let all = WORLDS.into_iter().zip(self.blocks);
        all.filter(|&(_, blocks)| blocks > 0)
    }
}

/// A life after its training, and what is seen of it.
struct Life<W> {
    learner: Box<dyn Learner>,
    world: W,
    /// What can be earned at most: a reward with every action, for ever, discounted as choices and as
    /// habits do.
    earned: (f64, f64),
    obtained: Vec<f64>,
    /// The most instructions of a step on a Cortex-M4F, block by block.
    worst: Vec<f64>,
    /// The largest worth of a choice or a habit, over what can be earned.
    value: f64,
    /// Blocks after which it could not be stored, because something in it cannot be so.
    unsound: u32,
}

impl<W: World> Life<W> {
    fn new(
        scale: Scale,
        config: Option<AgentConfig>,
        mut learner: Box<dyn Learner>,
        mut world: W,
    ) -> Result<Self, Failure> {
        live(&mut *learner, &mut world, scale.of(TRAINING))?;
        learner.act()?;
        let discounts = match config {
            Some(config) => (
                config.values.discount,
                config.habits.map_or(0.0, |it| it.discount),
            ),
            None => {
                let it = MindConfig::DEFAULT;
                let all = it.discount.max(it.habit_discount).max(it.model_discount);
                (all, 0.0)
            }
        };
        let at_most = |discount: f32| f64::from(VALUE) / (1.0 - f64::from(discount));
        Ok(Self {
            learner,
            world,
            earned: (at_most(discounts.0), at_most(discounts.1)),
            obtained: Vec::new(),
            worst: Vec::new(),
            value: 0.0,
            unsound: 0,
        })
    }

    fn live(&mut self, scale: Scale, blocks: usize, names: Names) -> Result<(), Failure> {
        for _ in 0..blocks {
            let (mut done, mut most) = (0, (0.0_f32, 0.0_f32));
            let mut watch = |learner: &dyn Learner, world: &W| {
                if done % LOOK == 0 {
                    let worth = learner.worth(&world.sense());
                    most = (most.0.max(worth.choice.abs()), most.1.max(worth.habit));
                }
                done += 1;
            };
            let actions = scale.of(BLOCK);
            let lived = watched(&mut *self.learner, &mut self.world, actions, &mut watch)?;
            self.obtained.push(f64::from(lived.total()));
            self.worst.push(lived.load.worst(Target::M4f) as f64);
            let of_most = f64::from(most.0) / self.earned.0;
            self.value = self
                .value
                .max(of_most)
                .max(f64::from(most.1) / self.earned.1);
            self.unsound += u32::from(self.learner.image(names).is_err());
        }
        Ok(())
    }

    fn note(self, name: &str, trial: &mut Trial) {
        let (first, last) = (self.worst.first(), self.worst.last());
        for (what, number) in [
            ("value", self.value),
            ("unsound", f64::from(self.unsound)),
            ("alarms", f64::from(self.learner.alarms())),
            ("schemas", self.learner.reliabilities().len() as f64),
            ("instructions.first", first.copied().unwrap_or_default()),
            ("instructions.last", last.copied().unwrap_or_default()),
        ] {
            trial.note(format!("{name}.{what}"), number);
        }
        trial.note_all(name, self.obtained);
    }
}

impl Lives {
    fn claims(&self, trials: &[Trial]) -> Vec<Claim> {
        let lives: Vec<String> = self
            .worlds()
            .flat_map(|(world, _)| {
                let names = self.configurations.iter();
                names.map(move |(name, _)| self.life(world, name))
            })
            .collect();
        let unsound = |trial: &Trial| {
            let of_life = |life: &String| trial.sum(&format!("{life}.unsound"), 1);
            lives.iter().map(of_life).fold(0.0, |sum, it| sum + it)
        };
        let mut all = vec![never(
            &format!("{}.unsound", self.part),
            "blocks",
            "blocks of all lives after which a number was not finite, or a link led nowhere",
            &trials.iter().map(unsound).collect::<Vec<_>>(),
        )];
        for (world, blocks) in self.worlds() {
            for (name, _) in self.configurations {
                all.extend(of_life(&self.life(world, name), blocks, trials));
            }
        }
        all
    }
}

/// What is claimed of one configuration in one world.
fn of_life(life: &str, blocks: usize, trials: &[Trial]) -> [Claim; 4] {
    let note = format!(
        "the seeds in the one of {blocks} blocks of 100,000 actions in which their mean is least, over \
         their mean in the best block"
    );
    let means = block_means(trials, life);
    let best = means.iter().copied().fold(0.0, f64::max);
    [
        claim(life, "share of the best block")
            .rule(Rule::mean(Bound::AtLeast(SHARE)))
            .note(note)
            .judge(&worst_block(trials, life, &means, best)),
        claim(&format!("{life}.fall"), "share of what was")
            .rule(Rule::every_seed(Bound::AtLeast(SHARE)))
            .note("the seed's least block over the best one that it had before")
            .judge(&deepest_falls(trials, life)),
        claim(&format!("{life}.value"), "share of what can be earned")
            .rule(Rule::every_seed(Bound::AtMost(1.0)))
            .note(
                "the largest worth of a choice or of a habit, over the largest value with every \
                 action for ever, discounted as they are",
            )
            .judge(&of(trials, &format!("{life}.value"))),
        claim(&format!("{life}.best_block"), "obtained").judge_count(best),
    ]
}

/// The mean of all seeds in each block.
fn block_means(trials: &[Trial], life: &str) -> Vec<f64> {
    let blocks = trials.first().map_or(0, |it| it.several(life).len());
    let of_block = |block: usize| {
        let seeds = trials.iter().filter_map(|it| it.several(life).get(block));
        mean(&seeds.copied().collect::<Vec<_>>())
    };
    (0..blocks).map(of_block).collect()
}

/// Each seed in the block whose mean is least, over the best mean.
fn worst_block(trials: &[Trial], life: &str, means: &[f64], best: f64) -> Vec<f64> {
    let blocks = means.iter().enumerate();
    let worst = blocks.min_by(|one, other| one.1.total_cmp(other.1));
    let worst = worst.map_or(0, |it| it.0);
    let of_trial = |it: &Trial| it.several(life).get(worst).copied();
    // Who earned nothing kept no share of anything.
    let all = trials.iter().filter_map(of_trial);
    all.map(|obtained| obtained / best.max(1.0)).collect()
}

/// How deep each seed's life fell: its least block over the best before it, 1 where there was nothing to
/// fall from.
fn deepest_falls(trials: &[Trial], life: &str) -> Vec<f64> {
    trials
        .iter()
        .map(|it| deepest_fall(it.several(life)))
        .collect()
}

fn deepest_fall(blocks: &[f64]) -> f64 {
    let (mut best, mut fall) = (0.0_f64, 1.0_f64);
    for &obtained in blocks {
        if best > 0.0 {
            fall = fall.min(obtained / best);
        }
        best = best.max(obtained);
    }
    fall
}

#[cfg(test)]
mod tests {
    use super::{Trial, block_means, deepest_fall, worst_block};

    #[test]
    fn a_life_that_grows_does_not_fall_and_the_worst_block_is_that_of_all_seeds() {
        assert_eq!(deepest_fall(&[2.0, 4.0, 3.0, 5.0, 4.5]), 0.75);
        assert_eq!(deepest_fall(&[0.0, 0.0]), 1.0);
        assert_eq!(deepest_fall(&[8.0, 0.0, 8.0]), 0.0);
        let lives = [[4.0, 2.0, 8.0], [2.0, 2.0, 0.0]];
        let trials = lives.map(|life| {
            let mut trial = Trial::default();
            trial.note_all("it", life.to_vec());
            trial
        });
        let means = block_means(&trials, "it");
        assert_eq!(means, [3.0, 2.0, 4.0]);
        assert_eq!(worst_block(&trials, "it", &means, 4.0), [0.5, 0.5]);
    }
}

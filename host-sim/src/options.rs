//! The command line, validated: only what can be run gets through.
//!
//! Whatever is impossible is an [`Impossible`]: one sentence, exit code 2, and nothing has been
//! written or trained yet.

use std::path::{Path, PathBuf};

use cla_core::agent::AgentConfig;
use cla_core::forager;
use cla_core::word::ItemId;
use clap::Parser;

use crate::cli::{
    AngleArgs, BudgetArgs, CalibrateArgs, CausalArgs, Cli, Command, ForageArgs, HilArgs,
    MicroworldArgs, OutArgs, RecoverArgs, SeedArgs, WorldArgs,
};
use crate::device::budget::Budget;
use crate::experiment::angle::{self, AngleConfig};
use crate::experiment::causal;
use crate::experiment::causal::network::CausalConfig;
use crate::experiment::forage::{self, ForageOptions};
use crate::experiment::microworld::{self, MicroworldOptions};
use crate::experiment::recover::life::Protocol;
use crate::experiment::recover::{self, RecoverOptions};
use crate::experiment::{calibrate, mcu};
use crate::failure::{Failure, Impossible};
use crate::progress::Progress;
use crate::report::Results;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::damage::{Damage, Damaged};
use crate::world::microworld::{Body, Oracle, item};
use crate::world::pioneer;
use crate::world::setting::{WorldOptions, read_layout};

/// Most seeds of one run.
const MOST_SEEDS: u64 = 100_000;

/// An experiment with options that can be run.
#[derive(Clone, Debug)]
pub enum Job {
    /// See [`forage`].
    Forage(Box<ForageOptions>),
    /// See [`calibrate`].
    Calibrate,
    /// See [`causal`]: the standard parameters with these seeds.
    Causal(Vec<u64>),
    /// See [`angle`]: the standard parameters with these seeds.
    Angle(Vec<u64>),
    /// See [`recover`].
    Recover(Box<RecoverOptions>),
    /// See [`microworld`].
    Microworld(MicroworldOptions),
    /// See [`mcu`]: with these seeds.
    Mcu(Vec<u64>),
    /// See [`mcu::hil`]: with these seeds, actions of training and actions of the test.
    Hil(Vec<u64>, (u32, u32)),
}

/// A job, and where its files go.
#[derive(Clone, Debug)]
pub struct Order {
    /// What to run.
    pub job: Job,
    /// The directory of its files.
    pub out: PathBuf,
    /// What its brain may cost; `None` where there is no brain with a budget.
    pub budget: Option<Budget>,
}

impl Order {
    /// Checks everything that can be checked without running.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    pub fn new(cli: &Cli) -> Result<Self, Impossible> {
        let Some(command) = &cli.command else {
            // What the parser makes of the name alone: every default from one place.
            let forage = Cli::try_parse_from(["host-sim", "forage"]);
            return Self::new(&forage.map_err(Impossible::new)?);
        };
        match command {
            Command::Forage(args) => Ok(Self {
                job: Job::Forage(Box::new(forage_options(args)?)),
                out: directory(&args.out, "forage"),
                budget: Some(budget(&args.budget)?),
            }),
            Command::Calibrate(CalibrateArgs { out }) => Ok(Self {
                job: Job::Calibrate,
                out: directory(out, "calibrate"),
                budget: None,
            }),
            Command::Causal(CausalArgs { seeds: args, out }) => Ok(Self {
                job: Job::Causal(seeds(args)?),
                out: directory(out, "causal"),
                budget: None,
            }),
            Command::Angle(AngleArgs { seeds: args, out }) => Ok(Self {
                job: Job::Angle(seeds(args)?),
                out: directory(out, "angle"),
                budget: None,
            }),
            Command::Recover(args) => Ok(Self {
                job: Job::Recover(Box::new(recover_options(args)?)),
                out: directory(&args.out, "recover"),
                budget: Some(budget(&args.budget)?),
            }),
            Command::Microworld(args) => Ok(Self {
                job: Job::Microworld(microworld_options(args)?),
                out: directory(&args.out, "microworld"),
                budget: None,
            }),
            Command::Mcu(args) => Ok(Self {
                job: Job::Mcu(seeds(&args.seeds)?),
                out: directory(&args.out, "mcu"),
                budget: Some(budget(&args.budget)?),
            }),
            Command::Hil(args) => Ok(Self {
                job: hil(args)?,
                out: directory(&args.out, "hil"),
                budget: Some(budget(&args.budget)?),
            }),
        }
    }
}

impl Order {
    /// Runs the job, and holds what it cost against its budget.
    ///
    /// # Errors
    /// [`Failure`] when it fails, or its brain is too large; nothing has been written.
    pub fn run(&self, progress: &Progress) -> Result<Results, Failure> {
        let Some(budget) = &self.budget else {
            return self.job.run(progress);
        };
        // All of them run the same brain.
        let bytes = forager::pioneer::RAM;
        budget.check_ram(bytes)?;
        Ok(budget.judge(self.job.run(progress)?, bytes))
    }
}

impl Job {
    /// Runs the experiment.
    ///
    /// # Errors
    /// [`Failure`] when it fails; nothing has been written.
    pub fn run(&self, progress: &Progress) -> Result<Results, Failure> {
        match self {
            Self::Forage(options) => forage::run(options, progress),
            Self::Calibrate => calibrate::report::run(progress),
            Self::Causal(seeds) => {
                let study = causal::run(seeds, &CausalConfig::standard(), progress);
                Ok(study.report()?)
            }
            Self::Angle(seeds) => {
                let study = angle::run(seeds, &AngleConfig::STANDARD, progress);
                Ok(study.report()?)
            }
            Self::Recover(options) => recover::run(options, progress),
            Self::Microworld(options) => microworld::run(options, progress),
            Self::Mcu(seeds) => mcu::run(seeds, progress),
            Self::Hil(seeds, actions) => mcu::run_hil(seeds, *actions, progress),
        }
    }
}

fn forage_options(args: &ForageArgs) -> Result<ForageOptions, Impossible> {
    if args.actions == 0 || !args.actions.is_multiple_of(forage::SNAPSHOT) {
        return Err(Impossible::new(
            "--actions must be a multiple of 1000, at least 1000",
        ));
    }
    if args.test_actions == 0 {
        return Err(Impossible::new("--test-actions must be at least 1"));
    }
    if args.world.removed {
        let sentence = "--removed does not go with forage: it tests both ways of counting";
        return Err(Impossible::new(sentence));
    }
    let options = ForageOptions {
        seeds: seeds(&args.seeds)?,
        world: world(&args.world)?,
        brain: AgentConfig::FORAGER,
        actions: args.actions,
        test_actions: args.test_actions,
    };
    for &seed in &options.seeds {
        options.world.build(seed)?;
    }
    Ok(options)
}

fn recover_options(args: &RecoverArgs) -> Result<RecoverOptions, Impossible> {
    if args.world.removed {
        let sentence = "--removed does not go with recover: a cleared room teaches nothing more";
        return Err(Impossible::new(sentence));
    }
    let world = world(&args.world)?;
    let mut damages = Vec::new();
    let read = |text: &str| {
        let damage = Damage::parse(text, &pioneer::ITEMS, &pioneer::ACTIONS);
        damage.map_err(|error| Impossible::new(format!("--damage: {error}")))
    };
    for text in &args.damage {
        if text == "all" {
            for text in Damage::REPORTED {
                damages.push(read(text)?);
            }
        } else {
            damages.push(read(text)?);
        }
    }
    let options = RecoverOptions {
        seeds: seeds(&args.seeds)?,
        world,
        damages,
        protocol: Protocol::STANDARD,
    };
    for &seed in &options.seeds {
        options.world.build(seed)?;
    }
    for &damage in &options.damages {
        Damaged::new(options.world.build(0)?, damage, 0).map_err(Impossible::new)?;
    }
    Ok(options)
}

fn hil(args: &HilArgs) -> Result<Job, Impossible> {
    if args.actions == 0 || args.test_actions == 0 {
        return Err(Impossible::new(
            "--actions and --test-actions must be at least 1",
        ));
    }
    Ok(Job::Hil(
        seeds(&args.seeds)?,
        (args.actions, args.test_actions),
    ))
}

fn microworld_options(args: &MicroworldArgs) -> Result<MicroworldOptions, Impossible> {
    let goal = args.goal.as_deref().map(microworld_goal).transpose()?;
    Ok(MicroworldOptions {
        seeds: seeds(&args.seeds)?,
        goal,
    })
}

/// The item that a goal such as `+taste1` turns on.
fn microworld_goal(text: &str) -> Result<ItemId, Impossible> {
    let named = text.strip_prefix('+').and_then(item).ok_or_else(|| {
        Impossible::new(format!(
            "--goal takes + and an item (such as +hp22, +vp33, +vf12, +tactl, +hgr or +taste1), \
             not {text:?}"
        ))
    })?;
    let oracle = Oracle::new(Body::Visible);
    let on = |state: &usize| oracle.items(*state).contains(named);
    match (0..oracle.states().len()).filter(on).count() {
        0 => Err(Impossible::new(format!(
            "--goal {text}: nothing in the Microworld turns this item on"
        ))),
        all if all == oracle.states().len() => Err(Impossible::new(format!(
            "--goal {text}: this item is always on"
        ))),
        _ => Ok(named),
    }
}

fn budget(args: &BudgetArgs) -> Result<Budget, Impossible> {
    Budget::new(&args.budget, &args.processor)
}

fn directory(args: &OutArgs, experiment: &str) -> PathBuf {
    let default = || Path::new("runs").join(experiment);
    args.out.clone().unwrap_or_else(default)
}

/// The seeds of `A..B` (half-open) or `A`.
///
/// # Errors
/// [`Impossible`] for anything else, an empty range and more than 100,000 seeds.
pub fn seeds(args: &SeedArgs) -> Result<Vec<u64>, Impossible> {
    let text = args.seeds.trim();
    let number = |part: &str| {
        let digits = part.parse::<u64>();
        digits.map_err(|_| Impossible::new(format!("--seeds takes A..B or A, not {text:?}")))
    };
    let (from, to) = match text.split_once("..") {
        Some((from, to)) => (number(from)?, number(to)?),
        None => {
            let only = number(text)?;
            let past = only.checked_add(1);
            let past = past.ok_or_else(|| Impossible::new("the seed is too large"))?;
            (only, past)
        }
    };
    if from >= to {
        let sentence = format!("--seeds {text} has no seed in it: the last is left out");
        return Err(Impossible::new(sentence));
    }
    if to - from > MOST_SEEDS {
        let sentence = format!("--seeds {text} has more than {MOST_SEEDS} seeds");
        return Err(Impossible::new(sentence));
    }
    Ok((from..to).collect())
}

/// The world that the arguments describe.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub fn world(args: &WorldArgs) -> Result<WorldOptions, Impossible> {
    let base = match args.world.as_str() {
        "noisy" => PioneerConfig::NOISY,
        "noise-free" => PioneerConfig::NOISE_FREE,
        other => {
            let sentence = format!("--world is noisy or noise-free, not {other:?}");
            return Err(Impossible::new(sentence));
        }
    };
    let config = PioneerConfig {
        radius: args.radius.unwrap_or(base.radius),
        specimens: args.specimens.unwrap_or(base.specimens),
        forward: args.forward.unwrap_or(base.forward),
        drop_out: args.drop_out.unwrap_or(base.drop_out),
        step_noise: args.step_noise.unwrap_or(base.step_noise),
        turn_noise: args.turn_noise.unwrap_or(base.turn_noise),
        after_capture: if args.removed {
            AfterCapture::Removed
        } else {
            base.after_capture
        },
        ..base
    };
    config.validate().map_err(Impossible::new)?;
    if args.layout.is_some() && args.specimens.is_some() {
        let sentence = "--specimens does not go with --layout: the file says how many there are";
        return Err(Impossible::new(sentence));
    }
    let layout = args.layout.as_deref();
    let layout = layout
        .map(|path| read_layout(path, config.radius))
        .transpose()?;
    WorldOptions::new(config, layout)
}

#[cfg(test)]
mod tests {
    use super::{microworld_goal, seeds, world};
    use crate::cli::{SeedArgs, WorldArgs};
    use crate::failure::Impossible;

    fn read(text: &str) -> Result<Vec<u64>, Impossible> {
        seeds(&SeedArgs {
            seeds: text.to_owned(),
        })
    }

    #[test]
    fn a_range_of_seeds_leaves_out_its_end() {
        assert_eq!(read("3..6"), Ok(vec![3, 4, 5]));
        assert_eq!(read("7"), Ok(vec![7]));
    }

    #[test]
    fn what_is_no_range_is_refused_in_one_sentence() {
        for wrong in [
            "",
            "6..6",
            "6..3",
            "-1",
            "1..2..3",
            "0..100001",
            "x",
            "1..",
            "18446744073709551615",
        ] {
            let sentence = read(wrong).unwrap_err().to_string();
            assert!(!sentence.contains('\n') && !sentence.is_empty(), "{wrong}");
        }
    }

    #[test]
    fn a_goal_is_an_item_that_comes_and_goes() {
        assert!(microworld_goal("+hp22").is_ok() && microworld_goal("+taste1").is_ok());
        for wrong in ["", "+", "hp22", "-hp22", "+nothing", "+fovx0", "+hp22+vp22"] {
            let sentence = microworld_goal(wrong).unwrap_err().to_string();
            assert!(!sentence.contains('\n'), "{wrong}: {sentence}");
            assert!(sentence.starts_with("--goal"), "{wrong}: {sentence}");
        }
    }

    fn noisy() -> WorldArgs {
        WorldArgs {
            world: "noisy".to_owned(),
            radius: None,
            specimens: None,
            forward: None,
            drop_out: None,
            step_noise: None,
            turn_noise: None,
            removed: false,
            layout: None,
        }
    }

    #[test]
    fn impossible_worlds_are_refused_before_anything_runs() {
        assert!(world(&noisy()).is_ok());
        let spoil: [fn(&mut WorldArgs); 6] = [
            |w| w.specimens = Some(0),
            |w| w.drop_out = Some(f64::NAN),
            |w| w.world = "quiet".to_owned(),
            |w| w.layout = Some("no/such/file".into()),
            // 500 specimens of 0.1 m do not fit a room of 1 m.
            |w| (w.radius, w.specimens) = (Some(1.0), Some(500)),
            |w| w.step_noise = Some(-1.0),
        ];
        for (index, spoil) in spoil.iter().enumerate() {
            let mut args = noisy();
            spoil(&mut args);
            let sentence = world(&args).unwrap_err().to_string();
            assert!(!sentence.contains('\n'), "{index}: {sentence}");
        }
    }
}

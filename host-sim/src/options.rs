//! The command line, validated: only what can be run gets through.
//!
//! Whatever is impossible is an [`Impossible`]: one sentence, exit code 2, and nothing has been
//! written or trained yet.

use std::path::Path;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager;
use clap::Parser;

use crate::cli::{BudgetArgs, Cli, Command, Errand, OutArgs, SeedArgs, WorldArgs};
use crate::device::budget::Budget;
use crate::experiment::angle::{Angle, AngleOptions};
use crate::experiment::calibrate::{Calibrate, CalibrateOptions};
use crate::experiment::causal::{Causal, CausalOptions};
use crate::experiment::forage::{Forage, ForageOptions};
use crate::experiment::hil::{Hil, HilOptions};
use crate::experiment::mcu::{Mcu, McuOptions};
use crate::experiment::microworld::{Chapter5, MicroworldOptions, Pursuit, PursuitOptions};
use crate::experiment::noted::{Plan, Planned};
use crate::experiment::one::{One, OneOptions};
use crate::experiment::plan::Experiment;
use crate::experiment::recover::{Recover, RecoverOptions};
use crate::failure::{Failure, Impossible};
use crate::keeping::Training;
use crate::progress::Progress;
use crate::report::{Begin, Journal, Place, Results};
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::setting::{MOST_ACTIONS, WorldOptions, read_layout};

/// Most seeds of one run.
const MOST_SEEDS: u64 = 100_000;

/// An experiment with options that can be run, and where its files go.
#[derive(Debug)]
pub struct Order {
    /// What to run.
    pub plan: Box<dyn Planned>,
    /// Where its files go.
    pub place: Place,
    /// What its brain may cost; `None` where there is no brain with a budget.
    pub budget: Option<Budget>,
    /// Whether all tables and claims are printed.
    pub table: bool,
}

/// A plan and the arguments that all experiments share: where its files go, what its brain may cost.
type Asked<'a> = (Box<dyn Planned>, &'a OutArgs, Option<&'a BudgetArgs>);

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
        let (plan, out, budget) = asked(command)?;
        let budget = budget
            .map(|args| Budget::new(&args.budget, &args.processor))
            .transpose()?;
        Ok(Self {
            place: Place {
                home: Path::new("runs").join(plan.name()),
                asked: out.out.clone(),
                begin: match (out.force, out.resume) {
                    (_, true) => Begin::Resume,
                    (true, false) => Begin::Force,
                    (false, false) => Begin::Fresh,
                },
            },
            plan,
            budget,
            table: out.table,
        })
    }

    /// Runs the plan, and holds what it cost against its budget.
    ///
    /// # Errors
    /// [`Failure`] when it fails, or its brain is too large; nothing has been written.
    pub fn run(&self, progress: &Progress, journal: &Journal) -> Result<Results, Failure> {
        let Some(budget) = &self.budget else {
            return self.plan.run(progress, journal);
        };
        // All of them run the same brain.
        let bytes = forager::pioneer::RAM;
        budget.check_ram(bytes)?;
        Ok(budget.judge(self.plan.run(progress, journal)?, bytes))
    }
}

/// What a command asks for: the one place where arguments become options.
fn asked(command: &Command) -> Result<Asked<'_>, Impossible> {
    Ok(match command {
        Command::Forage {
            seeds: which,
            world: place,
            actions,
            test_actions,
            budget,
            out,
        } => {
            let options = ForageOptions::new(seeds(which)?, world(place)?, *actions, *test_actions);
            (plan::<Forage>(options?), out, Some(budget))
        }
        Command::Calibrate { out } => (plan::<Calibrate>(CalibrateOptions::standard()), out, None),
        Command::Causal { seeds: which, out } => {
            let options = CausalOptions::standard(seeds(which)?);
            (plan::<Causal>(options), out, None)
        }
        Command::Angle { seeds: which, out } => {
            let options = AngleOptions::standard(seeds(which)?);
            (plan::<Angle>(options), out, None)
        }
        Command::Recover {
            damage,
            seeds: which,
            world: place,
            budget,
            out,
        } => {
            let options = RecoverOptions::new(seeds(which)?, world(place)?, damage)?;
            (plan::<Recover>(options), out, Some(budget))
        }
        Command::Microworld {
            seeds: which,
            goal,
            out,
        } => match (goal, seeds(which)?) {
            (Some(goal), seeds) => {
                let first = seeds.first().copied().unwrap_or_default();
                (
                    plan::<Pursuit>(PursuitOptions::new(first, goal)?),
                    out,
                    None,
                )
            }
            (None, seeds) => (plan::<Chapter5>(MicroworldOptions { seeds }), out, None),
        },
        Command::One {
            seeds: which,
            parts,
            long,
            out,
        } => {
            let options = OneOptions::new(seeds(which)?, parts, *long)?;
            (plan::<One>(options), out, None)
        }
        Command::Mcu {
            seeds: which,
            budget,
            out,
        } => {
            let options = McuOptions {
                seeds: seeds(which)?,
            };
            (plan::<Mcu>(options), out, Some(budget))
        }
        Command::Hil {
            seeds: which,
            actions,
            test_actions,
            budget,
            out,
        } => {
            let options = HilOptions::new(seeds(which)?, *actions, *test_actions)?;
            (plan::<Hil>(options), out, Some(budget))
        }
        Command::Errand(_) => return Err(Impossible::new("this is no experiment")),
    })
}

/// The training of one brain that the arguments ask for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub fn training(errand: &Errand) -> Result<Option<Training>, Impossible> {
    let Errand::Train {
        seed,
        world: place,
        brain,
        actions,
        act,
        load,
        save,
    } = errand
    else {
        return Ok(None);
    };
    if *actions > MOST_ACTIONS {
        let sentence = format!("--actions must be at most {MOST_ACTIONS}, not {actions}");
        return Err(Impossible::new(sentence));
    }
    let no = |option: &str, names: &str, it: &str| {
        Impossible::new(format!("{option} is {names}, not {it:?}"))
    };
    Ok(Some(Training {
        seed: *seed,
        world: world(place)?,
        brain: match brain.as_str() {
            "book" => AgentConfig::BOOK,
            "forager" => AgentConfig::FORAGER,
            "forager-level2" => AgentConfig::FORAGER_LEVEL2,
            "resilient" => AgentConfig::RESILIENT,
            "resilient-level2" => AgentConfig::RESILIENT_LEVEL2,
            other => {
                let names = "book, forager, forager-level2, resilient or resilient-level2";
                return Err(no("--brain", names, other));
            }
        },
        actions: *actions,
        act: match act.as_deref() {
            None => None,
            Some("frozen") => Some(Adaptation::Frozen),
            Some("reliabilities") => Some(Adaptation::Reliabilities),
            Some("relearning") => Some(Adaptation::Relearning),
            Some(other) => return Err(no("--act", "frozen, reliabilities or relearning", other)),
        },
        load: load.clone(),
        save: save.clone(),
    }))
}

fn plan<E: Experiment + std::fmt::Debug + 'static>(options: E::Options) -> Box<dyn Planned> {
    Box::new(Plan::<E>(options))
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
    use super::{seeds, world};
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

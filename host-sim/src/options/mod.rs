//! The command line, validated: only what can be run gets through.
//!
//! Whatever is impossible is an [`Impossible`]: one sentence, exit code 2, and nothing has been
//! written or trained yet.

mod live;
mod settled;
mod shared;
mod training;

use std::path::{Path, PathBuf};

use cla_core::forager;
use clap::Parser;

use crate::cli::{BudgetArgs, Cli, Command, OutArgs};
use crate::device::budget::Budget;
use crate::experiment::aliased::{Aliased, AliasedOptions};
use crate::experiment::angle::{Angle, AngleOptions};
use crate::experiment::calibrate::{Calibrate, CalibrateOptions};
use crate::experiment::causal::{Causal, CausalOptions};
use crate::experiment::forage::Forage;
use crate::experiment::hil::{Hil, HilOptions};
use crate::experiment::live::Live;
use crate::experiment::mcu::{Mcu, McuOptions};
use crate::experiment::microworld::{Chapter5, MicroworldOptions, Pursuit, PursuitOptions};
use crate::experiment::modules::{Modules, ModulesOptions};
use crate::experiment::neighbours::{Neighbours, NeighboursOptions};
use crate::experiment::noted::{Plan, Planned};
use crate::experiment::one::One;
use crate::experiment::plan::Experiment;
use crate::experiment::recover::Recover;
use crate::experiment::survive::{Scale, Survive, SurviveOptions};
use crate::experiment::sweep::{Shard, Sweep};
use crate::experiment::words::{Words, WordsOptions};
use crate::failure::{Failure, Impossible};
use crate::progress::Progress;
use crate::report::{Begin, Journal, Place, Results};

pub use settled::foraging;
pub use shared::{seeds, world};
pub use training::{sizing, teaching, training};

/// The experiments whose trained brains can be kept.
const BRAINS: [&str; 5] = ["forage", "recover", "one", "live", "aliased"];

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
    /// Where trained brains are kept.
    pub brains: Option<PathBuf>,
    /// Whether the same command goes on with what it has begun.
    goes_on: bool,
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
        if out.save_brains.is_some() && !BRAINS.contains(&plan.name()) {
            let sentence = format!(
                "--save-brains: {} does not keep its brains; {} do",
                plan.name(),
                BRAINS.join(", ")
            );
            return Err(Impossible::new(sentence));
        }
        let budget = budget
            .map(|args| Budget::new(&args.budget, &args.processor))
            .transpose()?;
        Ok(Self {
            place: place(command, plan.name(), out)?,
            plan,
            budget,
            table: out.table,
            brains: out.save_brains.clone(),
            goes_on: matches!(command, Command::Sweep { .. }) && out.out.is_some(),
        })
    }

    /// How the run in this directory is gone on with, in words.
    #[must_use]
    pub fn go_on(&self, directory: &Path) -> String {
        if self.goes_on {
            return "the same command goes on".to_owned();
        }
        let directory = directory.display();
        format!("the same command with --resume --out {directory} goes on")
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

/// Where files go: a shard has a directory of its own, and a sweep goes on by itself.
fn place(command: &Command, name: &str, out: &OutArgs) -> Result<Place, Impossible> {
    let mut asked = out.out.clone();
    let mut begin = match (out.force, out.resume) {
        (_, true) => Begin::Resume,
        (true, false) => Begin::Force,
        (false, false) => Begin::Fresh,
    };
    if let Command::Sweep { shard, .. } = command {
        if let (Some(directory), Some(text)) = (&mut asked, shard) {
            *directory = directory.join(Shard::parse(text)?.directory());
        }
        let begun = asked.as_ref().map(|it| it.join(Journal::NAME));
        if begin != Begin::Force {
            begin = match begun {
                Some(journal) if journal.exists() => Begin::Resume,
                Some(_) => Begin::Fresh,
                None => begin,
            };
        }
    }
    Ok(Place {
        home: Path::new("runs").join(name),
        asked,
        begin,
    })
}

/// What a command asks for: the one place where arguments become options.
fn asked(command: &Command) -> Result<Asked<'_>, Impossible> {
    Ok(match command {
        Command::Forage {
            seeds: which,
            world: place,
            length,
            settings,
            budget,
            out,
        } => {
            let options = settled::forage(which, place, *length, settings)?;
            (plan::<Forage>(options), out, Some(budget))
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
            settings,
            budget,
            out,
        } => {
            let options = settled::recover(which, place, damage, settings)?;
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
            settings,
            out,
        } => {
            let options = settled::one(which, parts, *long, settings)?;
            (plan::<One>(options), out, None)
        }
        Command::Aliased {
            seeds: which,
            worlds,
            out,
        } => {
            let options = AliasedOptions::new(seeds(which)?, worlds)?;
            (plan::<Aliased>(options), out, None)
        }
        Command::Words { seeds: which, out } => {
            let options = WordsOptions::standard(seeds(which)?);
            (plan::<Words>(options), out, None)
        }
        Command::Modules {
            seeds: which,
            trial,
            out,
        } => {
            let options = ModulesOptions::new(seeds(which)?, *trial)?;
            (plan::<Modules>(options), out, None)
        }
        Command::Neighbours {
            seeds: which,
            trial,
            out,
        } => {
            let options = NeighboursOptions::new(seeds(which)?, *trial)?;
            (plan::<Neighbours>(options), out, None)
        }
        Command::Live {
            seeds: which,
            live: args,
            out,
        } => (plan::<Live>(live::live(which, args)?), out, None),
        Command::Survive {
            seeds: which,
            part,
            shorter,
            out,
        } => {
            let options = SurviveOptions {
                shorter: Scale(*shorter),
                ..SurviveOptions::new(seeds(which)?, part)?
            };
            (plan::<Survive>(options), out, None)
        }
        Command::Sweep {
            grid,
            seeds: which,
            shard,
            live: args,
            out,
        } => {
            let options = live::sweep(grid, which, shard.as_ref(), args)?;
            (plan::<Sweep>(options), out, None)
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
            length,
            budget,
            out,
        } => {
            let options = HilOptions::new(
                seeds(which)?,
                length.actions.unwrap_or(10_000),
                length.test_actions.unwrap_or(3_000),
            )?;
            (plan::<Hil>(options), out, Some(budget))
        }
        Command::Errand(_) => return Err(Impossible::new("this is no experiment")),
    })
}

fn plan<E: Experiment + std::fmt::Debug + 'static>(options: E::Options) -> Box<dyn Planned> {
    Box::new(Plan::<E>(options))
}

//! The command line, declared: names, defaults and help of every option, and nothing else.
//!
//! To add an experiment: a variant of [`Command`] with its arguments here, and what plan they make in
//! `options`; what is done with one brain is an [`Errand`].

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Robots that build their own world: the experiments of Chaput 2004, with their verdicts.
///
/// Exit code 0 when the experiment ran, 1 when it failed or exceeded its --budget, 2 for impossible
/// options.
#[derive(Clone, Debug, Parser)]
#[command(name = "host-sim", version, max_term_width = 100)]
pub struct Cli {
    /// What to run; without a name, forage with its defaults.
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// One variant an experiment.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// A Pioneer learns to collect specimens from one valued item (book, 6.2).
    Forage {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where they are lived.
        #[command(flatten)]
        world: WorldArgs,
        /// Actions of training, a multiple of 1000.
        #[arg(
            long,
            value_name = "N",
            default_value_t = 10_000,
            allow_negative_numbers = true
        )]
        actions: u32,
        /// Actions of a test.
        #[arg(
            long,
            value_name = "N",
            default_value_t = 3_000,
            allow_negative_numbers = true
        )]
        test_actions: u32,
        /// What the brain may cost.
        #[command(flatten)]
        budget: BudgetArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Compare our Pioneer with the original simulator, Stage 1.3.4 and 4.3.0, on the same layouts.
    Calibrate {
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Learn launching events with a hierarchy of maps: causal perception, stages and fallback.
    Causal {
        /// The seeds.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Learn angles as infants do: young networks see lines, old ones angles.
    Angle {
        /// The seeds.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// A robot is damaged in mid-life and recovers, beside its rivals (book, 6.3, 7.1.1).
    Recover {
        /// What breaks: camera:DEGREES, shift:N, dead:ITEM, stuck:ITEM, swap:A,B, pull:DEGREES,
        /// weak:ACTION, slip:SHARE, lost:ACTION, beam, none; or all. May be given several times.
        #[arg(long, value_name = "DAMAGE", default_value = "camera:+12")]
        damage: Vec<String>,
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where they are lived.
        #[command(flatten)]
        world: WorldArgs,
        /// What the brain may cost.
        #[command(flatten)]
        budget: BudgetArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// An eye, a hand and a ball: schemas, goals and persistent objects (book, 5.4).
    Microworld {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Pursue this item, such as +hp22 or +taste1, and show the steps instead of the experiment.
        #[arg(long, value_name = "+ITEM", allow_hyphen_values = true)]
        goal: Option<String>,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// One learner, one configuration: what it earns in every world, damaged and taught.
    One {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Some parts only: forager, recover, unknown, distractors, lake, shuttle, vacuum, keys,
        /// generated, harm, teach.
        #[arg(long, value_name = "PART,…", value_delimiter = ',')]
        parts: Vec<String>,
        /// The forager also lives 200,000 and then ten million actions.
        #[arg(long)]
        long: bool,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// The brain on emulated microcontrollers: the same bits, what it costs, others beside it.
    Mcu {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// What the brain may cost.
        #[command(flatten)]
        budget: BudgetArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// The simulated robot lives with a brain in an emulated controller.
    Hil {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Actions of training.
        #[arg(
            long,
            value_name = "N",
            default_value_t = 10_000,
            allow_negative_numbers = true
        )]
        actions: u32,
        /// Actions of the test.
        #[arg(
            long,
            value_name = "N",
            default_value_t = 3_000,
            allow_negative_numbers = true
        )]
        test_actions: u32,
        /// What the brain may cost.
        #[command(flatten)]
        budget: BudgetArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// No experiment.
    #[command(flatten)]
    Errand(Errand),
}

/// What is done with one brain, beside the experiments.
#[derive(Clone, Debug, Subcommand)]
pub enum Errand {
    /// Train one Pioneer for a while, and keep its brain in a file or go on with one.
    Train {
        /// The seed of the world, and of the brain unless it is loaded.
        #[arg(long, value_name = "N", default_value_t = 100)]
        seed: u64,
        /// Where it lives.
        #[command(flatten)]
        world: Box<WorldArgs>,
        /// How it learns, unless it is loaded: book, forager, forager-level2, resilient or
        /// resilient-level2.
        #[arg(long, value_name = "NAME", default_value = "forager")]
        brain: String,
        /// Own actions.
        #[arg(long, value_name = "N", default_value_t = 10_000)]
        actions: u32,
        /// End training first and adapt in this way: frozen, reliabilities or relearning.
        #[arg(long, value_name = "HOW")]
        act: Option<String>,
        /// Go on with the brain of this file; the world begins anew.
        #[arg(long, value_name = "FILE")]
        load: Option<PathBuf>,
        /// Keep the brain in this file, in place of what it held.
        #[arg(long, value_name = "FILE")]
        save: Option<PathBuf>,
    },
    /// Show what a kept brain knows: items, schemas by value and reliability, habits, beliefs.
    Inspect {
        /// The brain's file.
        file: PathBuf,
        /// Rows of each table.
        #[arg(long, value_name = "N", default_value_t = 20)]
        most: usize,
    },
}

/// Where the files of a run go, and what is printed.
#[derive(Clone, Debug, Args)]
pub struct OutArgs {
    /// Directory for report.html, summary.json, trials.jsonl and the figures [default: `runs/`, the experiment and
    /// the time; `latest` leads to it].
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace the run that the directory holds.
    #[arg(long, requires = "out")]
    pub force: bool,
    /// Go on with the run that the directory holds, or with the latest; to the bit as if it had never
    /// been interrupted.
    #[arg(long, conflicts_with = "force")]
    pub resume: bool,
    /// Print all tables and claims, not only the summary of ten lines.
    #[arg(long)]
    pub table: bool,
}

/// The seeds of a run.
#[derive(Clone, Debug, Args)]
pub struct SeedArgs {
    /// Seeds, without the last: 100..120 are twenty; or a single one.
    #[arg(
        long,
        value_name = "A..B",
        default_value = "100",
        allow_negative_numbers = true
    )]
    pub seeds: String,
}

/// What the brain may cost on a microcontroller.
#[derive(Clone, Debug, Args)]
pub struct BudgetArgs {
    /// Limits that the run must keep: instructions of a control step, bytes of RAM of the brain; N
    /// is a number, or one with k (1000) or KiB (1024).
    #[arg(long, value_name = "instructions=N,ram=N", value_delimiter = ',')]
    pub budget: Vec<String>,
    /// The processor whose instructions are estimated: cortex-m4f, cortex-m0+ or rv32imac.
    #[arg(long, value_name = "NAME", default_value = "cortex-m4f")]
    pub processor: String,
}

/// The Pioneer's world.
#[derive(Clone, Debug, Args)]
pub struct WorldArgs {
    /// The set of parameters that the options below change: noisy or noise-free.
    #[arg(long, value_name = "NAME", default_value = "noisy")]
    pub world: String,
    /// Radius of the room, metres [noisy: 5].
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub radius: Option<f64>,
    /// Specimens in a random layout [noisy: 28].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub specimens: Option<usize>,
    /// Distance of one `forward`, metres [noisy: 0.5].
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    pub forward: Option<f64>,
    /// Probability that a blob is missed in one percept [noisy: 0.17].
    #[arg(long, value_name = "P", allow_negative_numbers = true)]
    pub drop_out: Option<f64>,
    /// Standard deviation of a drive's distance, as a share of it [noisy: 0.03].
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true)]
    pub step_noise: Option<f64>,
    /// Standard deviation of a turn, degrees [noisy: 0.5].
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    pub turn_noise: Option<f64>,
    /// Specimens that are taken are gone, instead of appearing elsewhere.
    #[arg(long)]
    pub removed: bool,
    /// File with the places of the specimens, instead of random ones: the robot's heading in degrees
    /// on a line, then a line `x y` for each, metres from the room's centre, where the robot stands;
    /// `#` begins a comment.
    #[arg(long, value_name = "FILE")]
    pub layout: Option<PathBuf>,
}

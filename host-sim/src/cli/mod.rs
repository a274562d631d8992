//! The command line, declared: names, defaults and help of every option, and nothing else.
//!
//! To add an experiment: a variant of [`Command`] with its arguments here, and what plan they make in
//! `options`; whatever is no experiment is an [`Errand`]; arguments that several of them share are in
//! `args`.

mod args;
mod errand;
mod sentence;

use clap::{Parser, Subcommand};

pub use args::{BudgetArgs, LengthArgs, LiveArgs, OutArgs, SeedArgs, SettingArgs, WorldArgs};
pub use errand::{Errand, SizeArgs, TeachArgs, TrainArgs};
pub use sentence::sentence;

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
        /// How long they are.
        #[command(flatten)]
        length: LengthArgs,
        /// Everything by name.
        #[command(flatten)]
        settings: SettingArgs,
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
        /// weak:ACTION, slip:SHARE, lost:ACTION, beam, none; or all. May be given several times
        /// [default: camera:+12].
        #[arg(long, value_name = "DAMAGE")]
        damage: Vec<String>,
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where they are lived.
        #[command(flatten)]
        world: WorldArgs,
        /// Everything by name.
        #[command(flatten)]
        settings: SettingArgs,
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
        /// Everything by name.
        #[command(flatten)]
        settings: SettingArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Worlds in which places look alike: what constructed items are worth there (book, 7.1.5).
    Aliased {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Some worlds only: barriers, shuttle, cheese, t_maze_2, t_maze_4, t_maze_8, t_maze_16,
        /// hallway.
        #[arg(long, value_name = "WORLD,…", value_delimiter = ',')]
        worlds: Vec<String>,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Words in a stream of syllables, rules in sentences: what infants find (book, 7.3.3).
    Words {
        /// The infants.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Layers made of other modules than the map, and layers that pool over shifts (book, 7.1.2, 7.1.3).
    Modules {
        /// The networks.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Tuning: the setting of this number for every kind of module, not those that were kept.
        #[arg(long, value_name = "0..=5")]
        trial: Option<usize>,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// What neighbours on the map are worth to values and to goals without a schema (book, 7.1.4).
    Neighbours {
        /// The robots.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Tuning: the setting of this number, not those that were kept.
        #[arg(long, value_name = "0..=5")]
        trial: Option<usize>,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Any learner in any world, or in that of a file, damaged in mid-life; all settings by name.
    Live {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Who lives where.
        #[command(flatten)]
        live: LiveArgs,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// What a failing memory, stops in mid-life and more may not take from a brain.
    Survive {
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Some parts only, or all but longest_life, which takes many hours; without it those that take
        /// minutes at most; a name that is none lists them.
        #[arg(long, value_name = "PART,…", value_delimiter = ',')]
        part: Vec<String>,
        /// Everything is tried N times less often and lived N times shorter; nothing is concluded then.
        #[arg(long, value_name = "N", default_value_t = 1)]
        shorter: u32,
        /// Where the files go.
        #[command(flatten)]
        out: OutArgs,
    },
    /// Lives on a grid of settings and seeds, in one go or in shards; what was made is not made again.
    Sweep {
        /// A setting and the values that it takes in turn; may be given several times.
        #[arg(long, value_name = "KEY=VALUE,VALUE…", allow_hyphen_values = true)]
        grid: Vec<String>,
        /// Which lives.
        #[command(flatten)]
        seeds: SeedArgs,
        /// Make the trials I, I + N, I + 2 N … alone, in a directory of their own below --out.
        #[arg(long, value_name = "I/N", requires = "out")]
        shard: Option<String>,
        /// Who lives where.
        #[command(flatten)]
        live: LiveArgs,
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
        /// How long they are.
        #[command(flatten)]
        length: LengthArgs,
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

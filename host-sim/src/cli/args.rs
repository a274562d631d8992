//! Arguments that several commands share.

use std::path::PathBuf;

use clap::Args;

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
    /// Keep the trained brains of every trial that is made as files in this directory, in forage, recover,
    /// one, live and aliased; see inspect.
    #[arg(long, value_name = "DIR")]
    pub save_brains: Option<PathBuf>,
}

/// The seeds of a run.
#[derive(Clone, Debug, Default, Args)]
pub struct SeedArgs {
    /// Seeds, without the last: 100..120 are twenty; or a single one [default: 100, or what a file with
    /// settings says].
    #[arg(long, value_name = "A..B", allow_negative_numbers = true)]
    pub seeds: Option<String>,
}

/// Settings by name.
#[derive(Clone, Debug, Default, Args)]
pub struct SettingArgs {
    /// File with settings in TOML, such as settings.toml of an earlier run of the same command. What is
    /// said beside it goes before.
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// One setting, such as agent.discount=0.9 or protocol.training=20000; may be given several times,
    /// and the last holds.
    #[arg(long = "set", value_name = "KEY=VALUE", allow_hyphen_values = true)]
    pub set: Vec<String>,
}

/// How long a life is.
#[derive(Clone, Copy, Debug, Args)]
pub struct LengthArgs {
    /// Actions of training; in forage a multiple of 1000 [default: 10000].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub actions: Option<u32>,
    /// Actions of a test [default: 3000].
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub test_actions: Option<u32>,
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
    /// The set of parameters that the options below change: noisy or noise-free [default: noisy].
    #[arg(long, value_name = "NAME")]
    pub world: Option<String>,
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

/// Who lives where, and what happens.
#[derive(Clone, Debug, Default, Args)]
pub struct LiveArgs {
    /// Seeds, rivals, damages, and the tables world, agent and protocol.
    #[command(flatten)]
    pub settings: SettingArgs,
    /// pioneer, noise-free, microworld, vacuum, keys, lake, shuttle, generated, or a .POMDP file.
    #[arg(long, value_name = "NAME|FILE")]
    pub world: Option<String>,
    /// mind, book, forager, forager-level2, resilient, resilient-level2, forager-lasting,
    /// resilient-lasting, q, q-history, sarsa, sarsa-history, linear, linear-history, servo, told or
    /// random.
    #[arg(long, value_name = "NAME")]
    pub agent: Option<String>,
    /// Learners beside it, with the settings that they have by themselves.
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub rival: Vec<String>,
    /// What breaks, as recover takes it; may be given several times.
    #[arg(long, value_name = "DAMAGE")]
    pub damage: Vec<String>,
}

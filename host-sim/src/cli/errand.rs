//! What is done beside the experiments: the command lines of errands.

use std::path::PathBuf;

use clap::{Args, Subcommand};

use super::args::WorldArgs;

/// What is done with one brain, beside the experiments.
#[derive(Clone, Debug, Subcommand)]
pub enum Errand {
    /// Train one Pioneer for a while, and keep its brain in a file or go on with one.
    Train(TrainArgs),
    /// Teach the one learner by a recorded log, and see how well it foretells what was held out.
    Teach(TeachArgs),
    /// Put the shards of a sweep together and judge them, if they are all there and nothing else is.
    Merge {
        /// The directory of the sweep, or those of its shards.
        #[arg(required = true, value_name = "DIR")]
        shards: Vec<PathBuf>,
        /// Directory for results.jsonl, report.html and summary.json.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Replace what the directory holds.
        #[arg(long)]
        force: bool,
    },
    /// Show what a kept brain knows: health, items, schemas by value and reliability, habits, beliefs.
    Inspect {
        /// The brain's file.
        file: PathBuf,
        /// Rows of each table.
        #[arg(long, value_name = "N", default_value_t = 20)]
        most: usize,
        /// Write the page of the brain, too: everything, and a graph from sensors to reward.
        #[arg(long, value_name = "FILE.html")]
        page: Option<PathBuf>,
    },
    /// Show what was learned, lost and revalued from one kept brain to another.
    Diff {
        /// The file of the earlier brain.
        before: PathBuf,
        /// The file of the later one.
        after: PathBuf,
        /// Rows of each list.
        #[arg(long, value_name = "N", default_value_t = 20)]
        most: usize,
    },
    /// Make the page that replays a log.
    Replay {
        /// The log, .mcap or .jsonl; see train --log.
        file: PathBuf,
        /// Where the page goes [default: the log's name with .html].
        #[arg(long, value_name = "FILE.html")]
        page: Option<PathBuf>,
    },
    /// Print what a kept brain knows, for programs.
    Export {
        /// The brain's file.
        file: PathBuf,
        /// As JSON, which is the only form.
        #[arg(long, required = true)]
        json: bool,
        /// Write it into this file.
        #[arg(long, value_name = "FILE")]
        out: Option<PathBuf>,
    },
    /// Say how many bytes a brain takes that remembers so much, before there is one.
    Size(SizeArgs),
}

/// How one Pioneer is trained.
#[derive(Clone, Debug, Args)]
pub struct TrainArgs {
    /// The seed of the world, and of the brain unless it is loaded.
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub seed: u64,
    /// Where it lives.
    #[command(flatten)]
    pub world: Box<WorldArgs>,
    /// How it learns, unless it is loaded: book, forager, forager-level2, resilient,
    /// resilient-level2, forager-lasting, resilient-lasting, or mind for the one learner.
    #[arg(long, value_name = "NAME", default_value = "forager")]
    pub brain: String,
    /// Own actions.
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    pub actions: u32,
    /// End training first and adapt in this way: frozen, reliabilities or relearning.
    #[arg(long, value_name = "HOW")]
    pub act: Option<String>,
    /// Go on with the brain of this file; the world begins anew.
    #[arg(long, value_name = "FILE")]
    pub load: Option<PathBuf>,
    /// Keep the brain in this file, in place of what it held.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// Log every action: FILE.mcap for robotics tools, FILE.jsonl with an action a line, FILE.csv
    /// with what each thousand brought. May be given several times.
    #[arg(long, value_name = "FILE")]
    pub log: Vec<PathBuf>,
}

/// By what the one learner is taught.
#[derive(Clone, Debug, Args)]
pub struct TeachArgs {
    /// The log: a table of text, the sensors' readings and the action of a moment in each row.
    #[arg(long, value_name = "FILE.csv")]
    pub log: PathBuf,
    /// How its columns become items and actions; see docs/bench.md.
    #[arg(long, value_name = "FILE.toml")]
    pub mapping: PathBuf,
    /// The share of the log that is taught; the rest is held out.
    #[arg(
        long,
        value_name = "SHARE",
        default_value_t = 0.75,
        allow_negative_numbers = true
    )]
    pub taught: f64,
    /// The seed of the learner.
    #[arg(long, value_name = "N", default_value_t = 100)]
    pub seed: u64,
    /// Keep the brain in this file.
    #[arg(long, value_name = "FILE")]
    pub save: Option<PathBuf>,
    /// Write a page: who foretold how much, and what the learner holds to follow from what.
    #[arg(long, value_name = "FILE.html")]
    pub page: Option<PathBuf>,
}

/// For what a brain is sized.
#[derive(Clone, Debug, Args)]
pub struct SizeArgs {
    /// Items of the robot.
    #[arg(long, value_name = "N")]
    pub items: Option<usize>,
    /// Its actions.
    #[arg(long, value_name = "N")]
    pub actions: Option<usize>,
    /// So many samples alone.
    #[arg(long, value_name = "N")]
    pub samples: Option<usize>,
    /// So many states [default: a fourteenth of the samples, or what the log asks for].
    #[arg(long, value_name = "N")]
    pub states: Option<usize>,
    /// The memory that there is, such as 100000, 100k or 128KiB: what fits is marked.
    #[arg(long, value_name = "BYTES")]
    pub ram: Option<String>,
    /// A log of its life, or of one like it, .mcap or .jsonl: its items, its actions, and how many
    /// situations there are.
    #[arg(long, value_name = "FILE")]
    pub log: Option<PathBuf>,
}

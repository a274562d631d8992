//! Lives by settings: what a file says, then what the command line says.

use serde_json::Value;

use super::settled::{named, seeds_of, set_over};
use crate::cli::{LiveArgs, SeedArgs};
use crate::experiment::live::LiveOptions;
use crate::experiment::sweep::{Axis, Shard, SweepOptions};
use crate::failure::Impossible;
use crate::settings::{of_tree, put};

/// The lives that are asked for; their seeds stand in the file when the command line has none.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn live(asked: &SeedArgs, args: &LiveArgs) -> Result<LiveOptions, Impossible> {
    let mut given = given(args)?;
    let seeds = seeds_of(asked, &mut given)?;
    LiveOptions::new(seeds, given)
}

/// The sweep that is asked for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn sweep(
    grid: &[String],
    asked: &SeedArgs,
    shard: Option<&String>,
    args: &LiveArgs,
) -> Result<SweepOptions, Impossible> {
    let mut given = given(args)?;
    let seeds = seeds_of(asked, &mut given)?;
    let written = given.as_object_mut().and_then(|it| it.remove("grid"));
    let grid = match written {
        // The command line goes before the file.
        Some(axes) if grid.is_empty() => of_tree(axes, "grid")?,
        _ => {
            let grid = grid.iter().map(|text| Axis::parse(text));
            grid.collect::<Result<_, _>>()?
        }
    };
    let shard = shard.map(|text| Shard::parse(text)).transpose()?;
    SweepOptions::new(seeds, &given, grid, shard)
}

/// All settings that are given, as a tree.
///
/// # Errors
/// [`Impossible`] for a file or a setting that cannot be read.
pub(super) fn given(args: &LiveArgs) -> Result<Value, Impossible> {
    let asked = [
        ("world", args.world.as_deref()),
        ("agent", args.agent.as_deref()),
    ];
    let (mut tree, set) = named(&args.settings, &asked)?;
    if !args.rival.is_empty() {
        put(&mut tree, "rivals", args.rival.clone().into())?;
    }
    if !args.damage.is_empty() {
        put(&mut tree, "damages", args.damage.clone().into())?;
    }
    set_over(&mut tree, set)?;
    Ok(tree)
}

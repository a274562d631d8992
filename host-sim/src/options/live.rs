//! Lives by settings: what a file says, then what the command line says.

use serde_json::Value;

use super::settled::{seeds_of, written};
use crate::cli::{LiveArgs, SeedArgs};
use crate::experiment::live::LiveOptions;
use crate::experiment::sweep::{Axis, Shard, SweepOptions};
use crate::failure::Impossible;
use crate::settings::{empty, of_tree, pair, put};

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
    let mut tree = written(&args.settings)?;
    let set = args.settings.set.iter().map(|text| pair(text));
    let set = set.collect::<Result<Vec<_>, _>>()?;
    // Another world or agent than that of the file begins with its own settings.
    for (part, asked) in [("world", &args.world), ("agent", &args.agent)] {
        let key = format!("{part}.name");
        let last = set.iter().rev().find(|(it, _)| *it == key);
        let name = last.map(|(_, name)| name.clone());
        let Some(name) = name.or_else(|| asked.as_deref().map(Value::from)) else {
            continue;
        };
        let was = tree.get(part).and_then(|it| it.get("name"));
        if was.is_some_and(|was| *was != name) {
            put(&mut tree, part, empty())?;
        }
        put(&mut tree, &key, name)?;
    }
    if !args.rival.is_empty() {
        put(&mut tree, "rivals", args.rival.clone().into())?;
    }
    if !args.damage.is_empty() {
        put(&mut tree, "damages", args.damage.clone().into())?;
    }
    for (key, value) in set {
        put(&mut tree, key, value)?;
    }
    Ok(tree)
}

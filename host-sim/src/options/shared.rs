//! What several commands ask for: seeds, and the Pioneer's world.

use crate::cli::{SeedArgs, WorldArgs};
use crate::failure::Impossible;
use crate::world::config::{AfterCapture, PioneerConfig};
use crate::world::setting::{WorldOptions, read_layout};

/// Most seeds of one run.
const MOST_SEEDS: u64 = 100_000;

/// The seeds of `A..B` (half-open) or `A`.
///
/// # Errors
/// [`Impossible`] for anything else, an empty range and more than 100,000 seeds.
pub fn seeds(args: &SeedArgs) -> Result<Vec<u64>, Impossible> {
    let text = args.seeds.as_deref().unwrap_or("100").trim();
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

/// The name, as settings have it, of the world that the arguments ask for.
///
/// # Errors
/// [`Impossible`] for a name that is none of the Pioneer's.
pub(super) fn world_name(args: &WorldArgs) -> Result<Option<&'static str>, Impossible> {
    match args.world.as_deref() {
        None => Ok(None),
        Some("noisy") => Ok(Some("pioneer")),
        Some("noise-free") => Ok(Some("noise-free")),
        Some(other) => {
            let sentence = format!("--world is noisy or noise-free, not {other:?}");
            Err(Impossible::new(sentence))
        }
    }
}

/// The world that the arguments describe.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub fn world(args: &WorldArgs) -> Result<WorldOptions, Impossible> {
    let base = match world_name(args)? {
        Some("noise-free") => PioneerConfig::NOISE_FREE,
        _ => PioneerConfig::NOISY,
    };
    changed(&WorldOptions::new(base, None)?, args)
}

/// A world with what the arguments change.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn changed(world: &WorldOptions, args: &WorldArgs) -> Result<WorldOptions, Impossible> {
    let base = world.config;
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
    let path = args.layout.as_ref().or(world.path.as_ref());
    if path.is_some() && args.specimens.is_some() {
        let sentence = "--specimens does not go with a layout: the file says how many there are";
        return Err(Impossible::new(sentence));
    }
    let layout = path
        .map(|path| read_layout(path, config.radius))
        .transpose()?;
    let world = WorldOptions::new(config, layout)?;
    Ok(WorldOptions {
        path: path.cloned(),
        ..world
    })
}

#[cfg(test)]
mod tests {
    use super::{seeds, world};
    use crate::cli::{SeedArgs, WorldArgs};
    use crate::failure::Impossible;

    fn read(text: &str) -> Result<Vec<u64>, Impossible> {
        seeds(&SeedArgs {
            seeds: Some(text.to_owned()),
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
            world: None,
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
            |w| w.world = Some("quiet".to_owned()),
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

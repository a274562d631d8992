//! Settings of the other experiments: what a file says, then what the command line says.

use cla_core::check::Config;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};

use super::shared::{changed, seeds, world_name};
use crate::cli::{LengthArgs, SeedArgs, SettingArgs, WorldArgs};
use crate::experiment::forage::{ForageOptions, Lengths};
use crate::experiment::live::{Place, full_agent};
use crate::experiment::one::OneOptions;
use crate::experiment::recover::RecoverOptions;
use crate::failure::Impossible;
use crate::settings::{self, empty, no_setting, of_tree, overlay, pair, put, take, tree_of};
use crate::world::setting::WorldOptions;

/// What a file with settings says; nothing where there is none.
///
/// # Errors
/// [`Impossible`] for a file that cannot be read.
pub(super) fn written(args: &SettingArgs) -> Result<Value, Impossible> {
    args.config
        .as_deref()
        .map_or_else(|| Ok(empty()), settings::read)
}

/// The seeds of the command line, or of the file, or one.
pub(super) fn seeds_of(asked: &SeedArgs, given: &mut Value) -> Result<Vec<u64>, Impossible> {
    let written = given.as_object_mut().and_then(|it| it.remove("seeds"));
    let text = match (&asked.seeds, written) {
        (Some(text), _) => Some(text.clone()),
        (None, Some(Value::String(text))) => Some(text),
        (None, Some(Value::Number(number))) => Some(number.to_string()),
        (None, Some(other)) => {
            let sentence = format!("seeds are a text such as \"100..110\", not {other}");
            return Err(Impossible::new(sentence));
        }
        (None, None) => None,
    };
    seeds(&SeedArgs { seeds: text })
}

/// What is set by name on the command line, in its order.
pub(super) type Set<'a> = Vec<(&'a str, Value)>;

/// A file with the names that are asked for, and what is to be set over it.
///
/// Another world or agent than that of the file begins with its own settings.
///
/// # Errors
/// [`Impossible`] for a file or a setting that cannot be read.
pub(super) fn named<'a>(
    args: &'a SettingArgs,
    asked: &[(&str, Option<&str>)],
) -> Result<(Value, Set<'a>), Impossible> {
    let mut tree = written(args)?;
    let set = args.set.iter().map(|text| pair(text));
    let set = set.collect::<Result<Set<'a>, _>>()?;
    for &(part, asked) in asked {
        let key = format!("{part}.name");
        let last = set.iter().rev().find(|(it, _)| *it == key);
        let name = last.map(|(_, name)| name.clone());
        let Some(name) = name.or_else(|| asked.map(Value::from)) else {
            continue;
        };
        let was = tree.get(part).and_then(|it| it.get("name"));
        if was.is_some_and(|was| *was != name) {
            put(&mut tree, part, empty())?;
        }
        put(&mut tree, &key, name)?;
    }
    Ok((tree, set))
}

/// Puts what is set over settings.
///
/// # Errors
/// [`Impossible`] for a key that leads through a value.
pub(super) fn set_over(tree: &mut Value, set: Set<'_>) -> Result<(), Impossible> {
    let mut set = set.into_iter();
    set.try_for_each(|(key, value)| put(tree, key, value))
}

/// A file with what is asked for and set by name over it.
fn given(args: &SettingArgs, asked: &[(&str, Option<&str>)]) -> Result<Value, Impossible> {
    let (mut tree, set) = named(args, asked)?;
    set_over(&mut tree, set)?;
    Ok(tree)
}

/// Settings with what is given laid over them.
fn laid<T: Serialize + DeserializeOwned>(
    base: &T,
    full: &Value,
    given: &mut Value,
    part: &str,
) -> Result<T, Impossible> {
    let mut tree = tree_of(base)?;
    overlay(&mut tree, full, &take(given, part)?, part)?;
    of_tree(tree, part)
}

/// Refuses what is left of settings when all that are known were taken.
fn nothing_else(given: &Value, known: &[&str]) -> Result<(), Impossible> {
    let name = given.as_object().and_then(|rest| rest.keys().next());
    name.map_or(Ok(()), |name| Err(no_setting("", name, known)))
}

/// The Pioneer's room as settings and arguments have it.
fn room(given: &mut Value, args: &WorldArgs) -> Result<WorldOptions, Impossible> {
    let place = Place::new(take(given, "world")?)?;
    let room = place.bare_pioneer().ok_or_else(|| {
        let sentence = format!(
            "it is lived in the Pioneer's bare room, not in {}",
            place.name()
        );
        Impossible::new(sentence)
    })?;
    changed(room, args)
}

/// A text, or a list of texts.
fn texts(given: &mut Value, key: &str) -> Result<Vec<String>, Impossible> {
    let found = given.as_object_mut().and_then(|table| table.remove(key));
    match found {
        None => Ok(Vec::new()),
        Some(Value::String(text)) => Ok(vec![text]),
        Some(list) => of_tree(list, key),
    }
}

/// The foraging that is asked for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn forage(
    asked: &SeedArgs,
    place: &WorldArgs,
    length: LengthArgs,
    args: &SettingArgs,
) -> Result<ForageOptions, Impossible> {
    let given = given(args, &[("world", world_name(place)?)])?;
    foraging(given, asked, place, length)
}

/// The foraging that settings say, such as those of a file, with what is asked for beside them.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub fn foraging(
    mut given: Value,
    asked: &SeedArgs,
    place: &WorldArgs,
    length: LengthArgs,
) -> Result<ForageOptions, Impossible> {
    let seeds = seeds_of(asked, &mut given)?;
    let world = room(&mut given, place)?;
    let lengths = laid(&Lengths::BOOK, &json!({}), &mut given, "protocol")?;
    let training = length.actions.unwrap_or(lengths.training);
    let test = length.test_actions.unwrap_or(lengths.test);
    let options = ForageOptions::new(seeds, world, training, test)?;
    let brain = laid(&options.brain, &full_agent()?, &mut given, "agent")?;
    brain.check().map_err(Impossible::new)?;
    nothing_else(&given, &["world", "agent", "protocol", "seeds"])?;
    Ok(ForageOptions { brain, ..options })
}

/// The recovery that is asked for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn recover(
    asked: &SeedArgs,
    place: &WorldArgs,
    damages: &[String],
    args: &SettingArgs,
) -> Result<RecoverOptions, Impossible> {
    let mut given = given(args, &[("world", world_name(place)?)])?;
    let seeds = seeds_of(asked, &mut given)?;
    let world = room(&mut given, place)?;
    let written = texts(&mut given, "damages")?;
    let damages = match (damages, &written[..]) {
        ([], []) => vec!["camera:+12".to_owned()],
        ([], _) => written,
        (asked, _) => asked.to_vec(),
    };
    let options = RecoverOptions::new(seeds, world, &damages)?;
    let protocol = laid(&options.protocol, &json!({}), &mut given, "protocol")?;
    nothing_else(&given, &["world", "damages", "protocol", "seeds"])?;
    options.with_protocol(protocol)
}

/// The lives of the one learner that are asked for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub(super) fn one(
    asked: &SeedArgs,
    parts: &[String],
    long: bool,
    args: &SettingArgs,
) -> Result<OneOptions, Impossible> {
    let mut given = given(args, &[])?;
    let seeds = seeds_of(asked, &mut given)?;
    let written = texts(&mut given, "parts")?;
    let parts = if parts.is_empty() { &written } else { parts };
    let is_long = given.as_object_mut().and_then(|it| it.remove("long"));
    let is_long: bool = is_long.map_or(Ok(false), |it| of_tree(it, "long"))?;
    let options = OneOptions::new(seeds, parts, long || is_long)?;
    let config = laid(&options.config, &json!({}), &mut given, "agent")?;
    config.check().map_err(Impossible::new)?;
    let shorter = given.as_object_mut().and_then(|it| it.remove("shorter"));
    let shorter: u32 = shorter.map_or(Ok(options.shorter), |it| of_tree(it, "shorter"))?;
    nothing_else(&given, &["agent", "parts", "long", "shorter", "seeds"])?;
    if shorter == 0 {
        return Err(Impossible::new("shorter is at least 1"));
    }
    Ok(OneOptions {
        config,
        shorter,
        ..options
    })
}

//! Settings in files: trees of names and values, read from TOML or from `KEY=VALUE`, laid over a tree
//! that says which names there are, and written again.
//!
//! What a setting means and in which range it lies is known to whoever owns it; here names are held
//! against those that exist, and what is none is refused with the nearest that is.
//! A part that may be missing is the word `none` in a file.

use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::failure::Impossible;
use crate::whole::read_text;

/// Most bytes of a file with settings.
const MOST_BYTES: u64 = 1 << 20;
/// The word for a part that is missing.
const NONE: &str = "none";

/// A tree without anything.
#[must_use]
pub fn empty() -> Value {
    Value::Object(Map::new())
}

/// Reads a file in TOML.
///
/// # Errors
/// [`Impossible`] with line and column for what is no TOML, and with its name for a value that is
/// neither text, number, yes or no, list nor table.
pub fn read(path: &Path) -> Result<Value, Impossible> {
    let name = path.display();
    let text = read_text(path, MOST_BYTES)
        .map_err(|why| Impossible::new(format!("cannot read {name}: {why}")))?;
    parse(&text).map_err(|error| Impossible::new(format!("{name}, {error}")))
}

/// Reads TOML.
///
/// # Errors
/// [`Impossible`] as [`read`].
///
/// ```
/// use host_sim::settings::parse;
/// let tree = parse("[agent]\nname = \"q\"\nalpha = 0.1\n")?;
/// assert_eq!(tree["agent"]["alpha"], 0.1);
/// let wrong = parse("[agent]\nalpha = 0..1\n").unwrap_err().to_string();
/// assert!(wrong.starts_with("line 2, column 11: "), "{wrong}");
/// # Ok::<(), host_sim::failure::Impossible>(())
/// ```
pub fn parse(text: &str) -> Result<Value, Impossible> {
    let table = text.parse::<toml::Table>().map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let before = text.get(..at).unwrap_or(text);
        let line = before.matches('\n').count() + 1;
        let column = before.chars().rev().take_while(|&it| it != '\n').count() + 1;
        Impossible::new(format!("line {line}, column {column}: {}", error.message()))
    })?;
    tree("", toml::Value::Table(table))
}

fn tree(path: &str, value: toml::Value) -> Result<Value, Impossible> {
    Ok(match value {
        toml::Value::String(text) => text.into(),
        toml::Value::Integer(number) => number.into(),
        toml::Value::Boolean(yes) => yes.into(),
        // JSON has no NaN, and no setting is one.
        toml::Value::Float(number) if number.is_finite() => number.into(),
        toml::Value::Float(number) => {
            return Err(Impossible::new(format!("{path} cannot be {number}")));
        }
        toml::Value::Datetime(_) => {
            return Err(Impossible::new(format!("{path} cannot be a time")));
        }
        toml::Value::Array(list) => {
            let each = list.into_iter().map(|it| tree(path, it));
            Value::Array(each.collect::<Result<_, _>>()?)
        }
        toml::Value::Table(table) => {
            let each = table.into_iter().map(|(key, it)| {
                let below = tree(&join(path, &key), it)?;
                Ok((key, below))
            });
            Value::Object(each.collect::<Result<_, _>>()?)
        }
    })
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// Splits `KEY=VALUE`; a value that is no TOML is a text.
///
/// # Errors
/// [`Impossible`] for a text without `=`, and for a value that no setting can have.
///
/// ```
/// use host_sim::settings::pair;
/// assert_eq!(pair("agent.alpha=0.1")?, ("agent.alpha", 0.1.into()));
/// assert_eq!(pair("world.name=lake")?, ("world.name", "lake".into()));
/// assert!(pair("agent.alpha").is_err() && pair("agent.alpha=nan").is_err());
/// # Ok::<(), host_sim::failure::Impossible>(())
/// ```
pub fn pair(text: &str) -> Result<(&str, Value), Impossible> {
    let (key, value) = text
        .split_once('=')
        .filter(|(key, _)| !key.trim().is_empty())
        .ok_or_else(|| Impossible::new(format!("a setting is KEY=VALUE, not {text:?}")))?;
    let key = key.trim();
    Ok((key, value_of(key, value)?))
}

/// The value of a setting as it is written on a command line.
///
/// # Errors
/// [`Impossible`] for a value that no setting can have, such as NaN.
pub fn value_of(key: &str, text: &str) -> Result<Value, Impossible> {
    let text = text.trim();
    match format!("it = {text}").parse::<toml::Table>() {
        Ok(mut table) if table.len() == 1 => match table.remove("it") {
            Some(value) => tree(key, value),
            None => Ok(text.into()),
        },
        _ => Ok(text.into()),
    }
}

/// Puts a value where a dotted key says, in place of what was there.
///
/// # Errors
/// [`Impossible`] for a key that leads through a value.
///
/// ```
/// use host_sim::settings::{empty, put};
/// let mut tree = empty();
/// put(&mut tree, "agent.habits.weight", 0.25.into())?;
/// assert_eq!(tree["agent"]["habits"]["weight"], 0.25);
/// assert!(put(&mut tree, "agent.habits.weight.more", 1.into()).is_err());
/// # Ok::<(), host_sim::failure::Impossible>(())
/// ```
pub fn put(tree: &mut Value, key: &str, value: Value) -> Result<(), Impossible> {
    let mut at = tree;
    for part in key.split('.') {
        let Value::Object(table) = at else {
            let sentence = format!("{key} is no setting: what stands before {part:?} is a value");
            return Err(Impossible::new(sentence));
        };
        at = table.entry(part).or_insert_with(empty);
    }
    *at = value;
    Ok(())
}

/// Takes a part out of a tree, the empty one where there is none.
///
/// # Errors
/// [`Impossible`] when it is no table.
pub fn take(tree: &mut Value, key: &str) -> Result<Value, Impossible> {
    match tree.as_object_mut().and_then(|table| table.remove(key)) {
        None => Ok(empty()),
        Some(part @ Value::Object(_)) => Ok(part),
        Some(other) => {
            let sentence = format!("{key} is a table of settings, not {other}");
            Err(Impossible::new(sentence))
        }
    }
}

/// Lays settings over a tree that has a value for each; what `base` has not, `full` has where it may
/// be there.
///
/// # Errors
/// [`Impossible`] for a name that is none, with the nearest that is, and for a table in the place of a
/// value.
///
/// ```
/// use host_sim::settings::overlay;
/// use serde_json::json;
/// let full = json!({"alpha": 0.1, "escape": {"after": 100, "burst": 10}});
/// let mut base = json!({"alpha": 0.2, "escape": null});
/// overlay(&mut base, &full, &json!({"escape": {"after": 50}}), "agent")?;
/// assert_eq!(base, json!({"alpha": 0.2, "escape": {"after": 50, "burst": 10}}));
/// overlay(&mut base, &full, &json!({"escape": "none"}), "agent")?;
/// assert!(base["escape"].is_null());
/// overlay(&mut base, &full, &json!({"escape": null}), "agent")?;
/// let wrong = overlay(&mut base, &full, &json!({"alhpa": 1}), "agent").unwrap_err();
/// assert_eq!(wrong.to_string(), "agent has no setting \"alhpa\": did you mean agent.alpha?");
/// # Ok::<(), host_sim::failure::Impossible>(())
/// ```
pub fn overlay(
    base: &mut Value,
    full: &Value,
    given: &Value,
    path: &str,
) -> Result<(), Impossible> {
    let is_part = full.is_object();
    // In JSON what is missing is also null.
    if (given == NONE || given.is_null()) && (is_part || base.is_null()) {
        *base = Value::Null;
        return Ok(());
    }
    if is_part && base.is_null() {
        *base = full.clone();
    }
    let (Value::Object(base_table), Value::Object(given_table)) = (&mut *base, given) else {
        if base.is_object() && !is_variant(base) {
            let sentence = format!("{path} is a table of settings, not {given}");
            return Err(Impossible::new(sentence));
        }
        *base = given.clone();
        return Ok(());
    };
    let other_variant =
        base_table.len() == 1 && given_table.len() == 1 && given_table.keys().ne(base_table.keys());
    if other_variant {
        *base = given.clone();
        return Ok(());
    }
    for (key, value) in given_table {
        let below = join(path, key);
        let Some(slot) = base_table.get_mut(key) else {
            let names: Vec<&str> = base_table.keys().map(String::as_str).collect();
            return Err(no_setting(path, key, &names));
        };
        let full = full.get(key).unwrap_or(&Value::Null);
        overlay(slot, full, value, &below)?;
    }
    Ok(())
}

/// A choice that takes settings of its own is a table of one entry.
fn is_variant(value: &Value) -> bool {
    value.as_object().is_some_and(|table| table.len() == 1)
}

/// That a name is none, and which was meant.
#[must_use]
pub fn no_setting(path: &str, name: &str, names: &[&str]) -> Impossible {
    let of = if path.is_empty() {
        "there is".to_owned()
    } else {
        format!("{path} has")
    };
    let ending = match nearest(name, names) {
        Some(near) => format!("did you mean {}?", join(path, near)),
        None => format!("there are {}", names.join(", ")),
    };
    Impossible::new(format!("{of} no setting {name:?}: {ending}"))
}

/// That a name is none of these, and which was meant.
#[must_use]
pub fn no_name(what: &str, name: &str, names: &[&str]) -> Impossible {
    let meant = nearest(name, names).map(|near| format!("; did you mean {near}?"));
    let (known, meant) = (names.join(", "), meant.unwrap_or_default());
    Impossible::new(format!("{name:?} is no {what}: there are {known}{meant}"))
}

/// The name that is most like another one, if any is.
fn nearest<'a>(name: &str, names: &[&'a str]) -> Option<&'a str> {
    let alike = |it: &&str| strsim::jaro_winkler(name, it);
    let best = names
        .iter()
        .copied()
        .max_by(|a, b| alike(a).total_cmp(&alike(b)))?;
    (alike(&best) >= 0.75).then_some(best)
}

/// Settings as a tree; a number of few digits keeps them.
///
/// # Errors
/// [`Impossible`] for what has no form in JSON.
pub fn tree_of<T: Serialize>(it: &T) -> Result<Value, Impossible> {
    // Through text: the shortest that gives an `f32` again is no longer the number that a double has.
    let text = serde_json::to_string(it).map_err(Impossible::new)?;
    serde_json::from_str(&text).map_err(Impossible::new)
}

/// Settings that a tree says.
///
/// # Errors
/// [`Impossible`] names the setting whose value cannot be.
///
/// ```
/// use host_sim::settings::of_tree;
/// use cla_core::choice::HabitConfig;
/// use serde_json::json;
/// let wrong = json!({"weight": "much"});
/// let wrong = of_tree::<HabitConfig>(wrong, "agent.habits").unwrap_err().to_string();
/// assert!(wrong.starts_with("agent.habits.weight: "), "{wrong}");
/// ```
pub fn of_tree<T: DeserializeOwned>(tree: Value, path: &str) -> Result<T, Impossible> {
    serde_path_to_error::deserialize(tree).map_err(|error| {
        let at = error.path().to_string();
        let at = if at == "." {
            path.to_owned()
        } else {
            join(path, &at)
        };
        Impossible::new(format!("{at}: {}", error.inner()))
    })
}

/// Settings as TOML, which is read as the same tree.
///
/// # Errors
/// [`Impossible`] for a tree that TOML cannot say.
///
/// ```
/// use host_sim::settings::{parse, text};
/// use serde_json::json;
/// let tree = json!({"b": {"c": 0.03, "d": null}, "a": ["x"]});
/// let written = text(&tree)?;
/// assert!(written.contains("c = 0.03") && written.contains("d = \"none\""));
/// assert_eq!(parse(&written)?["a"], tree["a"]);
/// # Ok::<(), host_sim::failure::Impossible>(())
/// ```
pub fn text(tree: &Value) -> Result<String, Impossible> {
    fn spoken(value: &Value) -> Value {
        match value {
            Value::Null => NONE.into(),
            Value::Object(table) => {
                let each = table.iter().map(|(key, it)| (key.clone(), spoken(it)));
                Value::Object(each.collect())
            }
            other => other.clone(),
        }
    }
    toml::to_string(&spoken(tree)).map_err(Impossible::new)
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use cla_core::agent::AgentConfig;
    use cla_core::check::Config;
    use cla_core::forest::{Heard, MindConfig, Voice};
    use cla_core::level2::{Fallback, Level2Config};
    use serde::Serialize;
    use serde::de::DeserializeOwned;
    use serde_json::{Value, json};

    use super::{of_tree, overlay, pair, parse, text, tree_of};

    fn comes_back<T: Serialize + DeserializeOwned + PartialEq + Debug>(it: &T) {
        let written = text(&tree_of(it).unwrap()).unwrap();
        let mut read = parse(&written).unwrap();
        // As it is read: laid over the tree that has `none` as what it is.
        let mut base = tree_of(it).unwrap();
        overlay(&mut base, &tree_of(it).unwrap(), &read, "agent").unwrap();
        assert_eq!(of_tree::<T>(base, "agent").unwrap(), *it, "{written}");
        read.as_object_mut()
            .unwrap()
            .insert("more".into(), 1.into());
        assert!(of_tree::<T>(read, "agent").is_err());
    }

    #[test]
    fn every_configuration_of_the_core_comes_back_from_a_file_to_the_bit() {
        comes_back(&MindConfig::DEFAULT);
        comes_back(&MindConfig {
            heard: Heard::only(Voice::Plans).and(Voice::Habits),
            prior: 1.0e-20,
            ..MindConfig::DEFAULT
        });
        for config in [
            AgentConfig::BOOK,
            AgentConfig::FORAGER,
            AgentConfig::FORAGER_LEVEL2,
            AgentConfig::RESILIENT,
            AgentConfig::RESILIENT_LEVEL2,
            AgentConfig::RESILIENT_LASTING,
        ] {
            comes_back(&config);
            let level2 = config.level2.map(|it| Level2Config {
                fallback: Fallback::MeanReliability(0.8),
                ..it
            });
            comes_back(&AgentConfig { level2, ..config });
        }
    }

    fn changed(given: Value) -> Result<AgentConfig, String> {
        let full = tree_of(&AgentConfig::RESILIENT_LEVEL2).unwrap();
        let mut base = tree_of(&AgentConfig::FORAGER).unwrap();
        overlay(&mut base, &full, &given, "agent").map_err(|it| it.to_string())?;
        let config: AgentConfig = of_tree(base, "agent").map_err(|it| it.to_string())?;
        config.check().map_err(|it| it.to_string())?;
        Ok(config)
    }

    #[test]
    fn what_may_be_missing_is_put_in_and_taken_out() {
        let config = changed(json!({"surprise": {"doubt": 90}, "escape": "none"})).unwrap();
        assert_eq!(config.surprise.map(|it| it.doubt), Some(90));
        assert_eq!(config.escape, None);
        let linear = json!({"linear": {"from": 0.3, "to": 0.1, "steps": 9}});
        let config = changed(json!({"training": {"alpha": linear}})).unwrap();
        assert_eq!(config.training.alpha.at(9), 0.1);
        let fallback = json!({"fallback": {"mean_reliability": 0.5}});
        let config = changed(json!({"level2": fallback})).unwrap();
        let fallback = config.level2.map(|it| it.fallback);
        assert_eq!(fallback, Some(Fallback::MeanReliability(0.5)));
    }

    #[test]
    fn what_cannot_be_is_refused_in_one_sentence_that_names_the_place() {
        for (given, words) in [
            (
                json!({"greedy_shar": 1}),
                "did you mean agent.greedy_share?",
            ),
            (
                json!({"escape": {"aftr": 1}}),
                "did you mean agent.escape.after?",
            ),
            (json!({"escape": {"after": -1}}), "agent.escape.after: "),
            (json!({"escape": {"after": 1e9}}), "agent.escape.after: "),
            (json!({"escape": 3}), "agent.escape is a table"),
            (
                json!({"rule": "best"}),
                "agent.rule: unknown variant `best`",
            ),
            (json!({"forgetting": "none"}), "agent.forgetting: "),
            (json!({"forgetting": 1.5}), "AgentConfig::forgetting"),
            (json!({"zzz": 1}), "there are coding"),
            (
                json!({"training": {"alpha": {"decay": {"from": 0.1, "to": 0.1, "time_constant": 0}}}}),
                "at least one step",
            ),
            (json!({"training": {"alpha": {"cubic": {}}}}), "`cubic`"),
        ] {
            let sentence = changed(given.clone()).unwrap_err();
            assert!(sentence.contains(words), "{given}: {sentence}");
            assert!(!sentence.contains('\n'), "{sentence}");
        }
        for wrong in ["a", "=1", "a=inf", "a=[nan]", "a={b=-inf}", "a=1979-05-27"] {
            assert!(pair(wrong).is_err(), "{wrong}");
        }
        assert_eq!(pair("a=[\"x\", 2]").unwrap().1, json!(["x", 2]));
        assert_eq!(pair("a=1 2").unwrap().1, json!("1 2"));
    }
}

//! What a sweep varies: settings on a grid, seeds, and which part of it all is made here.

use core::fmt;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use crate::experiment::live::LiveOptions;
use crate::experiment::settled::file;
use crate::failure::Impossible;
use crate::settings::{empty, put, tree_of, value_of};

/// Most trials of a sweep.
const MOST: usize = 1_000_000;
/// Most points of a grid: each of them is kept with all of its settings.
const MOST_POINTS: usize = 10_000;

/// A setting with the values that it takes in turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// The setting, with dots.
    pub key: String,
    /// Its values.
    pub values: Vec<Value>,
}

impl Axis {
    /// Reads `KEY=VALUE,VALUE…`.
    ///
    /// # Errors
    /// [`Impossible`] for anything else.
    ///
    /// ```
    /// use host_sim::experiment::sweep::Axis;
    /// let axis = Axis::parse("agent.discount=0.9,0.95")?;
    /// assert_eq!((axis.key.as_str(), axis.values.len()), ("agent.discount", 2));
    /// assert!(Axis::parse("agent.discount").is_err());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, Impossible> {
        let (key, values) = text
            .split_once('=')
            .map(|(key, values)| (key.trim(), values.trim()))
            .filter(|(key, values)| !key.is_empty() && !values.is_empty())
            .ok_or_else(|| {
                Impossible::new(format!("--grid takes KEY=VALUE,VALUE…, not {text:?}"))
            })?;
        // Tables and lists have commas of their own.
        let values = match value_of(key, &format!("[{values}]"))? {
            Value::Array(values) => values,
            _ => {
                let each = values.split(',').map(|it| value_of(key, it));
                each.collect::<Result<_, _>>()?
            }
        };
        for (index, value) in values.iter().enumerate() {
            // 1 and 1.0 are one number.
            let number = value.as_f64();
            let same = |it: &Value| it == value || number.is_some() && it.as_f64() == number;
            if values[..index].iter().any(same) {
                let sentence = format!("--grid: {key} takes {value} twice");
                return Err(Impossible::new(sentence));
            }
        }
        let key = key.to_owned();
        Ok(Self { key, values })
    }
}

/// A part of a sweep: of so many shards the one with this number, from 0 on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shard {
    /// Which.
    pub index: u32,
    /// Of how many.
    pub of: u32,
}

impl Shard {
    /// Reads `I/N`.
    ///
    /// # Errors
    /// [`Impossible`] for anything else, and for a number that is not below `N`.
    ///
    /// ```
    /// use host_sim::experiment::sweep::Shard;
    /// assert_eq!(Shard::parse("2/12")?, Shard { index: 2, of: 12 });
    /// assert!(Shard::parse("12/12").is_err());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, Impossible> {
        let numbers = text.split_once('/').and_then(|(index, of)| {
            let (index, of) = (index.trim().parse().ok()?, of.trim().parse().ok()?);
            (index < of).then_some(Self { index, of })
        });
        numbers.ok_or_else(|| {
            let sentence = format!("--shard takes I/N with I from 0 to N - 1, not {text:?}");
            Impossible::new(sentence)
        })
    }

    /// The name of its directory, below that of the sweep.
    #[must_use]
    pub fn directory(&self) -> String {
        let width = self.of.to_string().len();
        format!("shard-{:0width$}-of-{}", self.index, self.of)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// A place on the grid.
#[derive(Clone, Debug)]
pub struct Point {
    /// What is varied, by key.
    pub varied: Map<String, Value>,
    /// The lives there.
    pub live: LiveOptions,
}

impl Point {
    /// Where it lies, in words.
    #[must_use]
    pub fn named(&self) -> String {
        let each = self.varied.iter();
        let all: Vec<String> = each
            .map(|(key, value)| format!("{key} = {value}"))
            .collect();
        if all.is_empty() {
            "as it was given".to_owned()
        } else {
            all.join(", ")
        }
    }
}

/// Refuses axes that overwrite each other, and settings that would be lived with under another name.
fn check_grid(grid: &[Axis], given: &Value) -> Result<(), Impossible> {
    for (index, axis) in grid.iter().enumerate() {
        if axis.values.is_empty() {
            let sentence = format!("--grid has no values for {}", axis.key);
            return Err(Impossible::new(sentence));
        }
        if grid[..index].iter().any(|it| it.key == axis.key) {
            let sentence = format!("--grid names {} twice", axis.key);
            return Err(Impossible::new(sentence));
        }
        let below = format!("{}.", axis.key);
        if let Some(part) = grid.iter().find(|it| it.key.starts_with(&below)) {
            let sentence = format!("--grid: {} is a part of {}", part.key, axis.key);
            return Err(Impossible::new(sentence));
        }
        let Some(part) = axis.key.strip_suffix(".name") else {
            continue;
        };
        let settings = given.get(part).and_then(Value::as_object);
        let Some((settings, name)) = settings.and_then(|it| Some((it, it.get("name")?))) else {
            continue;
        };
        if settings.len() > 1 && axis.values.iter().any(|it| it != name) {
            let sentence = format!(
                "--grid changes {}, and there are settings of {name}: leave the others or the name out",
                axis.key
            );
            return Err(Impossible::new(sentence));
        }
    }
    Ok(())
}

/// What is varied.
#[derive(Clone, Debug)]
pub struct SweepOptions {
    /// The seeds of every point.
    pub seeds: Vec<u64>,
    /// The settings that all points share, as they were given.
    given: Value,
    /// The settings that are varied.
    pub grid: Vec<Axis>,
    /// All places on the grid, the last setting varied fastest.
    pub points: Vec<Point>,
    /// Which part is made; `None` is all.
    pub shard: Option<Shard>,
}

impl SweepOptions {
    /// Puts every combination of the grid's values into settings.
    ///
    /// # Errors
    /// [`Impossible`] for the first point that cannot be.
    ///
    /// ```
    /// use host_sim::experiment::sweep::{Axis, SweepOptions};
    /// use serde_json::json;
    /// let grid = vec![Axis::parse("agent.alpha=0.1,0.2")?, Axis::parse("world.name=lake,keys")?];
    /// let given = json!({"agent": {"name": "q"}});
    /// let sweep = SweepOptions::new(vec![1, 2, 3], &given, grid, None)?;
    /// assert_eq!(sweep.points.len(), 4);
    /// assert_eq!(sweep.points[1].varied["world.name"], "keys");
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(
        seeds: Vec<u64>,
        given: &Value,
        grid: Vec<Axis>,
        shard: Option<Shard>,
    ) -> Result<Self, Impossible> {
        check_grid(&grid, given)?;
        let count = grid
            .iter()
            .try_fold(1_usize, |count, axis| count.checked_mul(axis.values.len()))
            .filter(|&it| it <= MOST_POINTS && it.saturating_mul(seeds.len()) <= MOST);
        let Some(count) = count else {
            let sentence =
                format!("a sweep has at most {MOST_POINTS} points and {MOST} trials in all");
            return Err(Impossible::new(sentence));
        };
        let point = |index: usize| {
            let (mut left, mut settings) = (index, given.clone());
            let mut varied = Map::new();
            for axis in grid.iter().rev() {
                let value = &axis.values[left % axis.values.len()];
                left /= axis.values.len();
                put(&mut settings, &axis.key, value.clone())?;
                varied.insert(axis.key.clone(), value.clone());
            }
            let live = LiveOptions::new(seeds.clone(), settings)?;
            Ok(Point { varied, live })
        };
        let points = (0..count)
            .map(point)
            .collect::<Result<Vec<_>, Impossible>>()?;
        let mut seen = BTreeMap::new();
        for (index, point) in points.iter().enumerate() {
            let says = serde_json::to_string(&point.live).map_err(Impossible::new)?;
            if let Some(earlier) = seen.insert(says, index) {
                let sentence = format!(
                    "points {earlier} and {index} of the grid are the same lives: {}",
                    point.named()
                );
                return Err(Impossible::new(sentence));
            }
        }
        let sweep = Self {
            seeds,
            given: given.clone(),
            grid,
            points,
            shard,
        };
        match shard {
            Some(shard) if sweep.cases().is_empty() => {
                let all = sweep.points.len() * sweep.seeds.len();
                let sentence = format!("there is nothing in shard {shard}: there are {all} trials");
                Err(Impossible::new(sentence))
            }
            _ => Ok(sweep),
        }
    }

    /// The trials that are made here, in their order.
    #[must_use]
    pub fn cases(&self) -> Vec<Case> {
        let points = 0..self.points.len() as u32;
        let all = points.flat_map(|point| self.seeds.iter().map(move |&seed| Case { point, seed }));
        match self.shard {
            None => all.collect(),
            Some(Shard { index, of }) => {
                let ours = |&(at, _): &(usize, Case)| at % of as usize == index as usize;
                all.enumerate().filter(ours).map(|(_, case)| case).collect()
            }
        }
    }

    /// The sweep as a file, with all settings that its points share; the same sweep comes of it.
    ///
    /// # Errors
    /// [`Impossible`] for a value that TOML cannot say.
    pub fn file(&self) -> Result<String, Impossible> {
        // What follows a setting that is varied, such as how a rival was tuned for a world, is not shared.
        let all = self.points.iter().map(|it| it.live.settings());
        let mut all = all.reduce(|all, it| shared(all, &it)).unwrap_or_else(empty);
        for axis in &self.grid {
            remove(&mut all, &axis.key);
        }
        if !self.grid.is_empty() {
            all["grid"] = tree_of(&self.grid)?;
        }
        file(&self.seeds, all)
    }

    /// The same sweep, all of it.
    #[must_use]
    pub fn whole(&self) -> Self {
        Self {
            shard: None,
            ..self.clone()
        }
    }

    /// The sweep of which a journal tells.
    ///
    /// # Errors
    /// [`Impossible`] for options that are none of ours, or of which a world's file is gone.
    pub fn of_journal(options: &Value) -> Result<Self, Impossible> {
        #[derive(Deserialize)]
        struct Written {
            seeds: Vec<u64>,
            grid: Vec<Axis>,
            settings: Value,
            shard: Option<Shard>,
        }
        let written: Written = serde_json::from_value(options.clone()).map_err(Impossible::new)?;
        let it = Self::new(
            written.seeds,
            &written.settings,
            written.grid,
            written.shard,
        )?;
        let again = serde_json::to_value(&it).map_err(Impossible::new)?;
        if again == *options {
            Ok(it)
        } else {
            let sentence = "its worlds or learners are not what they were when it was made";
            Err(Impossible::new(sentence))
        }
    }
}

/// What two trees say alike.
fn shared(one: Value, other: &Value) -> Value {
    let (Value::Object(table), Some(other)) = (one, other.as_object()) else {
        return empty();
    };
    let kept = table.into_iter().filter_map(|(key, it)| {
        let there = other.get(&key)?;
        if it == *there {
            return Some((key, it));
        }
        let below = (it.is_object() && there.is_object()).then(|| shared(it, there))?;
        Some((key, below))
    });
    Value::Object(kept.collect())
}

/// Takes a setting out of a tree.
fn remove(tree: &mut Value, key: &str) {
    let Some(table) = tree.as_object_mut() else {
        return;
    };
    match key.split_once('.') {
        None => drop(table.remove(key)),
        Some((part, rest)) => {
            if let Some(below) = table.get_mut(part) {
                remove(below, rest);
            }
        }
    }
}

/// With every setting of every point, so that two sweeps that say the same are the same.
impl Serialize for SweepOptions {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let points = self.points.iter().map(|it| {
            let mut live = json!(it.live);
            if let Some(table) = live.as_object_mut() {
                table.remove("seeds");
            }
            live
        });
        json!({
            "seeds": self.seeds,
            "grid": self.grid,
            "settings": self.given,
            "points": points.collect::<Vec<Value>>(),
            "shard": self.shard,
        })
        .serialize(to)
    }
}

/// What one trial is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Case {
    /// The number of the point.
    pub point: u32,
    /// The seed.
    pub seed: u64,
}

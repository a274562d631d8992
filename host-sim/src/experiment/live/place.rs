//! Where a life is lived: every world of the project by its name, and any `.POMDP` file, each with its
//! settings.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::failure::{Failure, Impossible};
use crate::settings::{empty, no_name, of_tree, overlay, tree_of};
use crate::whole::read_text;
use crate::world::config::PioneerConfig;
use crate::world::distracted::Distracted;
use crate::world::generated::{Generated, Spec};
use crate::world::keys::Keys;
use crate::world::lake::Lake;
use crate::world::microworld::{Body, Microworld};
use crate::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
use crate::world::setting::{WorldOptions, read_layout};
use crate::world::sought::Sought;
use crate::world::vacuum::Vacuum;
use crate::world::veil::{Lost, Veil, Veiled};
use crate::world::{WORLD_WORDS, World};

/// The names of the worlds; whatever has a `.` in it is a file.
pub const WORLDS: [&str; 8] = [
    "pioneer",
    "noise-free",
    "microworld",
    "vacuum",
    "keys",
    "lake",
    "shuttle",
    "generated",
];

/// Most bytes of a `.POMDP` file.
const MOST_BYTES: u64 = 1 << 24;

/// A world that can be built for any seed.
#[derive(Clone, Debug)]
pub struct Place {
    settings: Value,
    pub(super) kind: Kind,
    pub(super) around: Around,
    items: &'static [&'static str],
    actions: &'static [&'static str],
}

/// Which world.
#[derive(Clone, Debug)]
pub(super) enum Kind {
    Pioneer(Box<WorldOptions>),
    Microworld(Microworldly),
    Vacuum,
    Keys,
    Lake,
    Shuttle(Arc<Pomdp>),
    Generated(Option<u64>),
    /// What it says, and a checksum of its text.
    File(Arc<Pomdp>, u64),
}

/// Settings of the Microworld.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Microworldly {
    body: Body,
    slip: f32,
}

/// The Pioneer's settings that are no parameters of its room.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Layouts {
    layout: Option<String>,
}

/// Which generated world; without a number each life has its own.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Drawn {
    spec: Option<u64>,
}

/// What is put around any world.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Around {
    /// The item that is sought in place of the world's own rewards.
    pub(super) valued: Option<String>,
    /// Items that blink beside its own.
    pub(super) distractors: usize,
    /// Share of the readings that get lost.
    lost: f32,
    /// What stands in their place.
    lost_shows: Lost,
}

const ALONE: Around = Around {
    valued: None,
    distractors: 0,
    lost: 0.0,
    lost_shows: Lost::Unknown,
};

impl Place {
    /// The world that settings describe: `name`, and what that world has.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    ///
    /// ```
    /// use host_sim::experiment::live::Place;
    /// use serde_json::json;
    /// let place = Place::new(json!({"name": "lake", "distractors": 4}))?;
    /// assert_eq!((place.items().len(), place.actions().len()), (20, 4));
    /// let wrong = Place::new(json!({"name": "laek"})).unwrap_err().to_string();
    /// assert!(wrong.ends_with("did you mean lake?"), "{wrong}");
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(mut given: Value) -> Result<Self, Impossible> {
        let name = given.as_object_mut().and_then(|table| table.remove("name"));
        let name = match name {
            None => "pioneer".to_owned(),
            Some(Value::String(name)) => name,
            Some(other) => {
                let sentence = format!("world.name is a name or a file, not {other}");
                return Err(Impossible::new(sentence));
            }
        };
        let own = match name.as_str() {
            "pioneer" => pioneer(&PioneerConfig::NOISY)?,
            "noise-free" => pioneer(&PioneerConfig::NOISE_FREE)?,
            "microworld" => tree_of(&Microworldly {
                body: Body::Visible,
                slip: 0.0,
            })?,
            "generated" => tree_of(&Drawn { spec: None })?,
            "vacuum" | "keys" | "lake" | "shuttle" => empty(),
            file if file.contains('.') => empty(),
            other => return Err(no_name("world", other, &WORLDS)),
        };
        let mut around = tree_of(&ALONE)?;
        if name == "microworld" {
            // Nothing is rewarded there by itself.
            around["valued"] = "taste1".into();
        }
        let around_names = around.clone();
        let mut all = own;
        join(&mut all, around);
        overlay(&mut all, &json!({"layout": ""}), &given, "world")?;
        let (around, own) = split(&all, &around_names);
        let around: Around = of_tree(around, "world")?;
        if !(0.0..=1.0).contains(&around.lost) {
            let sentence = format!("world.lost is a share from 0 to 1, not {}", around.lost);
            return Err(Impossible::new(sentence));
        }
        let layout = own.get("layout").cloned();
        let kind = Kind::new(&name, own)?;
        let mut settings = json!({ "name": name });
        join(&mut settings, kind.settings()?);
        if let Some(layout) = layout {
            join(&mut settings, json!({ "layout": layout }));
        }
        join(&mut settings, tree_of(&around)?);
        let bare = kind.build(0, 0).map_err(Impossible::new)?;
        let place = Self {
            settings,
            kind,
            around,
            items: bare.items(),
            actions: bare.actions(),
        };
        place.valued()?;
        let most = 32 * WORLD_WORDS - place.items.len().min(32 * WORLD_WORDS);
        if place.around.distractors > most {
            let more = place.around.distractors;
            let sentence = format!("world.distractors is at most {most} here, not {more}");
            return Err(Impossible::new(sentence));
        }
        let whole = place.build(0, 0).map_err(Impossible::new)?;
        Ok(Self {
            items: whole.items(),
            ..place
        })
    }

    /// Its name, or that of its file.
    #[must_use]
    pub fn name(&self) -> &str {
        self.settings["name"].as_str().unwrap_or_default()
    }

    /// All of its settings.
    #[must_use]
    pub const fn settings(&self) -> &Value {
        &self.settings
    }

    /// The names of its items, distractors among them.
    #[must_use]
    pub const fn items(&self) -> &'static [&'static str] {
        self.items
    }

    /// The names of its actions.
    #[must_use]
    pub const fn actions(&self) -> &'static [&'static str] {
        self.actions
    }

    /// The Pioneer's room with nothing put around it.
    #[must_use]
    pub fn bare_pioneer(&self) -> Option<&WorldOptions> {
        let bare =
            self.around.valued.is_none() && self.around.distractors == 0 && self.around.lost == 0.0;
        match &self.kind {
            Kind::Pioneer(options) if bare => Some(options),
            _ => None,
        }
    }

    /// Whether whoever lives here hears rewards as numbers, and not by valued items alone.
    #[must_use]
    pub const fn gives_numbers(&self) -> bool {
        !matches!(self.kind, Kind::Pioneer(_)) || self.around.valued.is_some()
    }

    /// The index of the item that is sought in place of the world's own rewards.
    fn valued(&self) -> Result<Option<usize>, Impossible> {
        let Some(name) = &self.around.valued else {
            return Ok(None);
        };
        let place = self.items.iter().position(|it| it == name);
        place
            .map(Some)
            .ok_or_else(|| no_name("item of this world", name, self.items))
    }

    /// The item that its own inhabitants value; `None` where a number says what a step was worth.
    pub(super) fn valued_item(&self) -> Option<usize> {
        let own = match self.kind {
            Kind::Pioneer(_) => "ingrip",
            Kind::Vacuum => "cleaned",
            Kind::Keys => "prize",
            Kind::Lake => "goal",
            Kind::Shuttle(_) => "docked_LRV",
            Kind::Generated(_) => "reward",
            Kind::Microworld(_) | Kind::File(..) => "",
        };
        let name = self.around.valued.as_deref().unwrap_or(own);
        self.items.iter().position(|&it| it == name)
    }

    /// The world of a life, with the chance of a seed of its own.
    ///
    /// # Errors
    /// [`Failure`] when specimens do not fit the Pioneer's room.
    pub fn build(&self, life: u64, seed: u64) -> Result<Box<dyn World>, Failure> {
        let mut world = self.kind.build(life, seed)?;
        if let Some(item) = self.valued()? {
            world = Box::new(Sought::new(world, item));
        }
        let Around {
            distractors,
            lost,
            lost_shows,
            ..
        } = self.around;
        if distractors > 0 {
            world = Box::new(Distracted::new(world, distractors, seed));
        }
        if lost > 0.0 {
            world = Box::new(Veiled::new(world, Veil::Share(lost, lost_shows), seed));
        }
        Ok(world)
    }
}

/// Settings with what a file says, so that another file under the same name is another world.
impl Serialize for Place {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut all = self.settings.clone();
        match &self.kind {
            Kind::Pioneer(options) => join(&mut all, json!({ "places": options.layout })),
            Kind::File(_, checksum) => {
                join(&mut all, json!({ "checksum": format!("{checksum:016x}") }));
            }
            _ => {}
        }
        all.serialize(to)
    }
}

impl Kind {
    fn new(name: &str, own: Value) -> Result<Self, Impossible> {
        Ok(match name {
            "pioneer" | "noise-free" => {
                let (layout, config) = split(&own, &json!({"layout": null}));
                let config: PioneerConfig = of_tree(config, "world")?;
                config.validate().map_err(Impossible::new)?;
                let layout = of_tree::<Layouts>(layout, "world")?.layout;
                let path = layout.map(PathBuf::from);
                let layout = path
                    .as_deref()
                    .map(|path| read_layout(path, config.radius))
                    .transpose()?;
                let world = WorldOptions::new(config, layout)?;
                Self::Pioneer(Box::new(WorldOptions { path, ..world }))
            }
            "microworld" => {
                let it: Microworldly = of_tree(own, "world")?;
                if !(0.0..=1.0).contains(&it.slip) {
                    let sentence = format!("world.slip is a share from 0 to 1, not {}", it.slip);
                    return Err(Impossible::new(sentence));
                }
                Self::Microworld(it)
            }
            "vacuum" => Self::Vacuum,
            "keys" => Self::Keys,
            "lake" => Self::Lake,
            "shuttle" => Self::Shuttle(Arc::new(Pomdp::parse(SHUTTLE).map_err(Impossible::new)?)),
            "generated" => Self::Generated(of_tree::<Drawn>(own, "world")?.spec),
            file => {
                let (model, checksum) = read_pomdp(Path::new(file))?;
                Self::File(Arc::new(model), checksum)
            }
        })
    }

    /// The settings as they are lived with, but for the name of a layout's file.
    fn settings(&self) -> Result<Value, Impossible> {
        match self {
            Self::Pioneer(options) => tree_of(&options.config),
            Self::Microworld(it) => tree_of(it),
            Self::Generated(spec) => tree_of(&Drawn { spec: *spec }),
            Self::Vacuum | Self::Keys | Self::Lake | Self::Shuttle(_) | Self::File(..) => {
                Ok(empty())
            }
        }
    }

    fn build(&self, life: u64, seed: u64) -> Result<Box<dyn World>, Failure> {
        Ok(match self {
            Self::Pioneer(options) => Box::new(options.build(seed)?),
            Self::Microworld(it) => Box::new(Microworld::new(seed, it.body, it.slip)),
            Self::Vacuum => Box::new(Vacuum::new(seed)),
            Self::Keys => Box::new(Keys::new(seed)),
            Self::Lake => Box::new(Lake::new(seed)),
            Self::Shuttle(model) | Self::File(model, _) => {
                Box::new(PomdpWorld::new(Arc::clone(model), seed))
            }
            Self::Generated(spec) => {
                let spec = Spec::random(spec.unwrap_or(life));
                Box::new(Generated::new(Arc::new(spec), seed))
            }
        })
    }
}

fn pioneer(config: &PioneerConfig) -> Result<Value, Impossible> {
    let mut own = tree_of(config)?;
    join(&mut own, tree_of(&Layouts { layout: None })?);
    Ok(own)
}

/// Puts the entries of a table into another.
fn join(to: &mut Value, from: Value) {
    if let (Value::Object(to), Value::Object(from)) = (to, from) {
        to.extend(from);
    }
}

/// The entries of a table that another has, and the rest.
fn split(all: &Value, like: &Value) -> (Value, Value) {
    let (mut those, mut rest) = (empty(), empty());
    if let Value::Object(all) = all {
        for (key, value) in all {
            let to = if like.get(key).is_some() {
                &mut those
            } else {
                &mut rest
            };
            join(to, json!({ key.as_str(): value }));
        }
    }
    (those, rest)
}

/// Reads a world in Cassandra's format; with a checksum of its text.
///
/// # Errors
/// [`Impossible`] for a file that cannot be read, and with line and column for one that is no POMDP.
fn read_pomdp(path: &Path) -> Result<(Pomdp, u64), Impossible> {
    let name = path.display();
    let text = read_text(path, MOST_BYTES)
        .map_err(|why| Impossible::new(format!("cannot read the world {name}: {why}")))?;
    let model = Pomdp::parse(&text);
    let model = model.map_err(|error| Impossible::new(format!("{name}, {error}")))?;
    let checksum = crc::Crc::<u64>::new(&crc::CRC_64_XZ).checksum(text.as_bytes());
    Ok((model, checksum))
}

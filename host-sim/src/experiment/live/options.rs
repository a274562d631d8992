//! What a life varies: everything by name, from files and from the command line alike.

use serde::Serialize;
use serde_json::{Value, json};

use super::inhabitant::Inhabitant;
use super::place::Place;
use crate::experiment::recover::life::Protocol;
use crate::experiment::settled::file;
use crate::failure::Impossible;
use crate::settings::{no_setting, of_tree, overlay, take, tree_of};
use crate::world::damage::{Damage, Damaged};

/// Most damages, and most rivals, of one run.
const MOST: usize = 100;

/// What is varied.
#[derive(Clone, Debug)]
pub struct LiveOptions {
    /// The seeds.
    pub seeds: Vec<u64>,
    /// Where everybody lives.
    pub world: Place,
    /// Who is looked at.
    pub agent: Inhabitant,
    /// Whom it is compared with, each by its name once.
    pub rivals: Vec<Inhabitant>,
    /// What breaks in mid-life, in lives of their own; nothing is a life without damage.
    pub damages: Vec<Damage>,
    /// How long each part of a life is.
    pub protocol: Protocol,
}

impl LiveOptions {
    /// Reads settings: `world`, `agent`, `protocol`, `damages`, `rivals`; what is not there is as usual.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be.
    ///
    /// ```
    /// use host_sim::experiment::live::LiveOptions;
    /// use serde_json::json;
    /// let given = json!({"world": {"name": "lake"}, "agent": {"name": "q"}});
    /// let options = LiveOptions::new(vec![1], given)?;
    /// // All of it is written, and read again as the same.
    /// let again = LiveOptions::new(vec![1], options.settings())?;
    /// assert_eq!(again.settings(), options.settings());
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(seeds: Vec<u64>, mut given: Value) -> Result<Self, Impossible> {
        let world = Place::new(take(&mut given, "world")?)?;
        let agent = Inhabitant::new(take(&mut given, "agent")?, &world, "agent")?;
        let protocol = protocol(&take(&mut given, "protocol")?)?;
        let rivals = names(&mut given, "rivals")?;
        let damages = names(&mut given, "damages")?;
        if let Some(name) = given.as_object().and_then(|rest| rest.keys().next()) {
            let known = ["world", "agent", "protocol", "damages", "rivals"];
            return Err(no_setting("", name, &known));
        }
        let mut entered: Vec<Inhabitant> = Vec::new();
        for name in &rivals {
            let rival = Inhabitant::new(json!({ "name": name }), &world, "rivals")?;
            if rival.name() == agent.name() || entered.iter().any(|it| it.name() == name) {
                let sentence = format!("{name} cannot take part twice");
                return Err(Impossible::new(sentence));
            }
            entered.push(rival);
        }
        let mut read = Vec::new();
        for text in &damages {
            let texts = match text.as_str() {
                "all" => &Damage::REPORTED[..],
                one => &[one],
            };
            for text in texts {
                read.push(damage(text, &world)?);
            }
        }
        few("damages", read.len())?;
        let options = Self {
            seeds,
            world,
            agent,
            rivals: entered,
            damages: read,
            protocol,
        };
        for &seed in &options.seeds {
            let whole = options.world.build(seed, seed);
            whole.map_err(Impossible::new)?;
        }
        Ok(options)
    }

    /// All settings, those that were not given among them; the same options come of them.
    #[must_use]
    pub fn settings(&self) -> Value {
        let names = |all: Vec<String>| Value::from(all);
        json!({
            "world": self.world.settings(),
            "agent": self.agent.settings(),
            "protocol": self.protocol,
            "rivals": names(self.rivals.iter().map(|it| it.name().to_owned()).collect()),
            "damages": names(self.damages.iter().map(Damage::to_string).collect()),
        })
    }

    /// The settings as a file, with the seeds, which follow each other.
    ///
    /// # Errors
    /// [`Impossible`] for a value that TOML cannot say.
    pub fn file(&self) -> Result<String, Impossible> {
        file(&self.seeds, self.settings())
    }

    /// Everybody who lives, the agent first.
    pub(super) fn everybody(&self) -> impl Iterator<Item = &Inhabitant> {
        core::iter::once(&self.agent).chain(&self.rivals)
    }
}

impl Serialize for LiveOptions {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut all = self.settings();
        all["seeds"] = json!(self.seeds);
        all["world"] = json!(self.world);
        let rivals = self.rivals.iter().map(|it| it.settings().clone());
        all["rivals"] = Value::Array(rivals.collect());
        all.serialize(to)
    }
}

fn protocol(given: &Value) -> Result<Protocol, Impossible> {
    let mut all = tree_of(&Protocol::STANDARD)?;
    overlay(&mut all, &json!({}), given, "protocol")?;
    let protocol: Protocol = of_tree(all, "protocol")?;
    protocol.check()?;
    Ok(protocol)
}

/// A list of names; a single one may stand alone.
fn names(given: &mut Value, key: &str) -> Result<Vec<String>, Impossible> {
    let found = given.as_object_mut().and_then(|table| table.remove(key));
    let names: Vec<String> = match found {
        None => Vec::new(),
        Some(Value::String(name)) => vec![name],
        Some(list) => of_tree(list, key)?,
    };
    few(key, names.len())?;
    Ok(names)
}

fn few(key: &str, number: usize) -> Result<(), Impossible> {
    if number > MOST {
        let sentence = format!("{key} are at most {MOST}, not {number}");
        return Err(Impossible::new(sentence));
    }
    Ok(())
}

fn damage(text: &str, world: &Place) -> Result<Damage, Impossible> {
    let wrong = |why: String| Impossible::new(format!("damages: {why}"));
    let damage = Damage::parse(text, world.items(), world.actions());
    let damage = damage.map_err(|error| wrong(error.to_string()))?;
    let whole = world.build(0, 0).map_err(Impossible::new)?;
    Damaged::new(whole, damage, 0).map_err(|error| wrong(format!("{text}: {error}")))?;
    Ok(damage)
}

//! Who lives: every learner of the project by its name, with its settings, for any world.
//!
//! A world has what suits its size: where there is a brain that was described for it, that one, with
//! the same bits as everywhere; else one with room for more items and actions than there are.

use cla_core::agent::{Adaptation, Agent, AgentConfig};
use cla_core::check::Config;
use cla_core::forest::MindConfig;
use cla_core::map::TrainingConfig;
use cla_core::snapshot::Names;
use cla_core::som::BinarySom;
use cla_core::word::ItemId;
use serde_json::{Value, json};

use super::place::{Kind, Place};
use crate::baseline::linear::{Linear, LinearConfig};
use crate::baseline::random::Random;
use crate::baseline::sector::Sector;
use crate::baseline::tabular::{Tabular, TabularConfig};
use crate::baseline::told::Told;
use crate::baseline::worlds::{Tuned, generated, keys, lake, shuttle, vacuum};
use crate::experiment::recover::rivals::{Pupil, Rival, Setup};
use crate::failure::{Failure, Impossible};
use crate::learner::controller::Untaught;
use crate::learner::folded::Folded;
use crate::learner::mind::Minded;
use crate::learner::native::Native;
use crate::settings::{no_name, of_tree, overlay, tree_of};
use crate::world::generated::{Spec, dweller};
use crate::world::keys::seeker;
use crate::world::lake::skater;
use crate::world::pomdp::shuttle as docking;
use crate::world::vacuum::cleaner;

/// The names of the learners.
pub const LEARNERS: [&str; 17] = [
    "mind",
    "book",
    "forager",
    "forager-level2",
    "resilient",
    "resilient-level2",
    "forager-lasting",
    "resilient-lasting",
    "q",
    "q-history",
    "sarsa",
    "sarsa-history",
    "linear",
    "linear-history",
    "servo",
    "told",
    "random",
];

/// Items of a brain with room for any world, and its actions.
const ROOM: usize = 120;
const ROOM_ACTIONS: usize = 12;

/// The book's agent with room for any world.
pub type Settler =
    Agent<4, ROOM, 16, 16, ROOM_ACTIONS, 512, 2048, 384, 3072, BinarySom<16, 16, ROOM>>;

/// What an item is worth that is worth having.
const VALUE: f32 = 10.0;

/// A learner with its settings, not born yet.
#[derive(Clone, Debug)]
pub struct Inhabitant {
    name: String,
    settings: Value,
    nature: Nature,
}

#[derive(Clone, Debug)]
enum Nature {
    Mind(Box<MindConfig>),
    Agent(Box<AgentConfig>, Adaptation),
    Table(TabularConfig),
    Linear(LinearConfig),
    Servo,
    Told,
    Random,
}

impl Inhabitant {
    /// The learner that settings describe: `name`, and what that learner has.
    ///
    /// # Errors
    /// [`Impossible`] for the first thing that cannot be, also for a learner that the world has no room
    /// for.
    ///
    /// ```
    /// use host_sim::experiment::live::{Inhabitant, Place};
    /// use serde_json::json;
    /// let lake = Place::new(json!({"name": "lake"}))?;
    /// let q = Inhabitant::new(json!({"name": "q", "alpha": 0.25}), &lake, "agent")?;
    /// assert_eq!(q.settings()["alpha"], 0.25);
    /// let wrong = Inhabitant::new(json!({"name": "q", "alhpa": 1}), &lake, "agent").unwrap_err();
    /// assert!(wrong.to_string().ends_with("did you mean agent.alpha?"));
    /// # Ok::<(), host_sim::failure::Impossible>(())
    /// ```
    pub fn new(mut given: Value, place: &Place, path: &str) -> Result<Self, Impossible> {
        let name = given.as_object_mut().and_then(|table| table.remove("name"));
        let name = match name {
            None => "mind".to_owned(),
            Some(Value::String(name)) => name,
            Some(other) => {
                let sentence = format!("{path}.name is the name of a learner, not {other}");
                return Err(Impossible::new(sentence));
            }
        };
        let (base, full) = settings_of(&name, place)?;
        let mut settings = base;
        overlay(&mut settings, &full, &given, path)?;
        let nature = Nature::new(&name, settings, path)?;
        let mut whole = json!({ "name": name });
        if let (Some(to), Value::Object(from)) = (whole.as_object_mut(), nature.settings()?) {
            to.extend(from);
        }
        let it = Self {
            name,
            settings: whole,
            nature,
        };
        it.fits(place)?;
        Ok(it)
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// All of its settings.
    #[must_use]
    pub const fn settings(&self) -> &Value {
        &self.settings
    }

    /// Whether it has a brain, which has an image; tables, votes and servos have none.
    pub(super) const fn has_brain(&self) -> bool {
        matches!(self.nature, Nature::Mind(_) | Nature::Agent(..))
    }

    /// What the items and actions of the brain are called that is born into the world of a life.
    ///
    /// # Errors
    /// [`Failure`] when that world cannot be built.
    pub(super) fn names(&self, place: &Place, life: u64) -> Result<Names, Failure> {
        if let (Nature::Agent(..), Kind::Generated(_), true) =
            (&self.nature, &place.kind, is_described(place))
        {
            // One brain for all of these worlds; each has the first of its items and actions.
            return Ok(dweller::VOCABULARY.names());
        }
        let world = place.build(life, life)?;
        Ok(Names::of(world.items(), world.actions()))
    }

    fn fits(&self, place: &Place) -> Result<(), Impossible> {
        let (items, actions) = (place.items().len(), place.actions().len());
        let no = |why: String| Err(Impossible::new(format!("{}: {why}", self.name)));
        let brain = self.has_brain();
        if brain && items > ROOM {
            return no(format!(
                "a brain has room for {ROOM} items, and there are {items}"
            ));
        }
        if brain && actions > ROOM_ACTIONS {
            let most = ROOM_ACTIONS;
            return no(format!(
                "a brain has room for {most} actions, and there are {actions}"
            ));
        }
        match (&self.nature, &place.kind) {
            (Nature::Agent(..), _) if place.valued_item().is_none() => no(
                "it learns from a valued item: say which with --set world.valued=ITEM".to_owned(),
            ),
            (Nature::Servo, Kind::File(..) | Kind::Microworld(_)) => {
                no("nobody has written one for this world".to_owned())
            }
            (Nature::Servo | Nature::Told, _) if place.around.valued.is_some() => {
                no("it seeks what its world rewards, and nothing else".to_owned())
            }
            (Nature::Told, Kind::Pioneer(_)) => Ok(()),
            (Nature::Told, _) => no("only the Pioneer's servo can be told what broke".to_owned()),
            _ => Ok(()),
        }
    }

    /// Is born into the world of a life.
    ///
    /// # Errors
    /// [`Failure`] when a configuration cannot work.
    pub fn born(&self, place: &Place, seed: u64) -> Result<Box<dyn Pupil>, Failure> {
        Ok(match &self.nature {
            Nature::Mind(config) => mind(**config, place, seed)?,
            Nature::Agent(config, adaptation) => agent(**config, *adaptation, place, seed)?,
            Nature::Table(config) => {
                Box::new(Tabular::with_actions(*config, place.actions(), seed))
            }
            Nature::Linear(config) => {
                Box::new(Linear::new(*config, &place.build(seed, seed)?, seed))
            }
            Nature::Servo => servo(place, seed),
            Nature::Told => Box::new(Told::new(forward(place), seed)),
            Nature::Random => {
                let actions = place.actions().len() as u32;
                Box::new(Untaught::new(Random { actions }, seed))
            }
        })
    }
}

impl Nature {
    fn new(name: &str, mut settings: Value, path: &str) -> Result<Self, Impossible> {
        let wrong = |error: cla_core::check::ConfigError| Impossible::new(error);
        Ok(match name {
            "mind" => {
                let config: MindConfig = of_tree(settings, path)?;
                config.check().map_err(wrong)?;
                Self::Mind(Box::new(config))
            }
            "q" | "q-history" | "sarsa" | "sarsa-history" => {
                let config: TabularConfig = of_tree(settings, path)?;
                config.check().map_err(wrong)?;
                Self::Table(config)
            }
            "linear" | "linear-history" => {
                let config: LinearConfig = of_tree(settings, path)?;
                config.check().map_err(wrong)?;
                Self::Linear(config)
            }
            "servo" => Self::Servo,
            "told" => Self::Told,
            "random" => Self::Random,
            _ => {
                let how = settings
                    .as_object_mut()
                    .and_then(|it| it.remove("adaptation"));
                let how = how.unwrap_or(Value::Null);
                let adaptation = of_tree(how, &format!("{path}.adaptation"))?;
                let config: AgentConfig = of_tree(settings, path)?;
                config.check().map_err(wrong)?;
                Self::Agent(Box::new(config), adaptation)
            }
        })
    }

    /// The settings as they are lived with: numbers as the learner has them, not as they were written.
    fn settings(&self) -> Result<Value, Impossible> {
        match self {
            Self::Mind(config) => tree_of(config),
            Self::Agent(config, adaptation) => {
                let mut tree = tree_of(config)?;
                tree["adaptation"] = tree_of(adaptation)?;
                Ok(tree)
            }
            Self::Table(config) => tree_of(config),
            Self::Linear(config) => tree_of(config),
            Self::Servo | Self::Told | Self::Random => Ok(json!({})),
        }
    }
}

/// The settings that a learner has by its name, and with all parts that may be missing.
fn settings_of(name: &str, place: &Place) -> Result<(Value, Value), Impossible> {
    let tuned = tuned(place);
    let table = |rival: Rival, elsewhere: fn(&Tuned) -> TabularConfig| {
        let config = match (&tuned, rival.tuned().setup) {
            (Some(tuned), _) => elsewhere(tuned),
            (None, Setup::Table(config)) => config,
            (None, _) => TabularConfig::SARSA,
        };
        let full = TabularConfig {
            escape: AgentConfig::FORAGER.escape,
            ..config
        };
        Ok((tree_of(&config)?, tree_of(&full)?))
    };
    let linear = |elsewhere: fn(&Tuned) -> LinearConfig| {
        let config = match (&tuned, Rival::Linear.tuned().setup) {
            (Some(tuned), _) => elsewhere(tuned),
            (None, Setup::Linear(config)) => config,
            (None, _) => LinearConfig::DEFAULT,
        };
        let full = LinearConfig {
            escape: AgentConfig::FORAGER.escape,
            ..config
        };
        Ok((tree_of(&config)?, tree_of(&full)?))
    };
    match name {
        "mind" => Ok((tree_of(&MindConfig::DEFAULT)?, json!({}))),
        "book" => book(&AgentConfig::BOOK, Adaptation::Reliabilities),
        "forager" => book(&AgentConfig::FORAGER, Adaptation::Relearning),
        "forager-level2" => book(&AgentConfig::FORAGER_LEVEL2, Adaptation::Relearning),
        "resilient" => book(&AgentConfig::RESILIENT, Adaptation::Relearning),
        "resilient-level2" => book(&AgentConfig::RESILIENT_LEVEL2, Adaptation::Relearning),
        "forager-lasting" => book(&AgentConfig::FORAGER_LASTING, Adaptation::Relearning),
        "resilient-lasting" => book(&AgentConfig::RESILIENT_LASTING, Adaptation::Relearning),
        "q" => table(Rival::Q, |it| it.q),
        "q-history" => table(Rival::QHistory, |it| it.q_history),
        "sarsa" => table(Rival::Sarsa, |it| it.sarsa),
        "sarsa-history" => table(Rival::SarsaHistory, |it| it.sarsa_history),
        "linear" => linear(|it| it.linear),
        "linear-history" => linear(|it| it.linear_history),
        "servo" | "told" | "random" => Ok((json!({}), json!({}))),
        other => Err(no_name("learner", other, &LEARNERS)),
    }
}

/// The book's agent with all parts that may be missing.
///
/// # Errors
/// [`Impossible`] for what has no form in JSON.
pub fn full_agent() -> Result<Value, Impossible> {
    tree_of(&AgentConfig {
        training: TrainingConfig::FORAGER,
        escape: AgentConfig::FORAGER.escape,
        ..AgentConfig::RESILIENT_LEVEL2
    })
}

fn book(config: &AgentConfig, adaptation: Adaptation) -> Result<(Value, Value), Impossible> {
    let mut base = tree_of(config)?;
    base["adaptation"] = tree_of(&adaptation)?;
    Ok((base, full_agent()?))
}

/// The rivals as they did best where a life is lived; the Pioneer's are those of `recover`, and where
/// nobody has tuned any, those of generated worlds.
fn tuned(place: &Place) -> Option<Tuned> {
    match place.kind {
        Kind::Pioneer(_) => None,
        Kind::Vacuum => Some(vacuum::TUNED),
        Kind::Keys => Some(keys::TUNED),
        Kind::Lake => Some(lake::TUNED),
        Kind::Shuttle(_) => Some(shuttle::TUNED),
        Kind::Generated(_) | Kind::Microworld(_) | Kind::File(..) => Some(generated::TUNED),
    }
}

fn forward(place: &Place) -> f64 {
    match &place.kind {
        Kind::Pioneer(options) => options.config.forward,
        _ => 1.0,
    }
}

/// Whoever was written by hand for a world.
fn servo(place: &Place, seed: u64) -> Box<dyn Pupil> {
    match &place.kind {
        Kind::Vacuum => Box::new(Untaught::new(vacuum::Sweeper::default(), seed)),
        Kind::Keys => Box::new(Untaught::new(keys::Searcher::default(), seed)),
        Kind::Lake => Box::new(Untaught::new(lake::Careful, seed)),
        Kind::Shuttle(_) => Box::new(Untaught::new(shuttle::Docker::default(), seed)),
        Kind::Generated(spec) => {
            let spec = Spec::random(spec.unwrap_or(seed));
            let engineer = generated::Engineer::new(std::sync::Arc::new(spec));
            Box::new(Untaught::new(engineer, seed))
        }
        _ => Box::new(Untaught::new(Sector::new(forward(place)), seed)),
    }
}

/// The one learner; where rewards are numbers, no item is worth anything by itself.
fn mind(config: MindConfig, place: &Place, seed: u64) -> Result<Box<dyn Pupil>, Failure> {
    let valued = place.valued_item().filter(|_| !place.gives_numbers());
    let actions = place.actions().len();
    macro_rules! of {
        ($words:literal, $items:literal, $actions:literal) => {{
            let mut values = [0.0; $items];
            if let Some(value) = valued.and_then(|item| values.get_mut(item)) {
                *value = VALUE;
            }
            let mind = Minded::<$words, $items, $actions>::born_among;
            Box::new(mind(config, values, actions, seed)?) as Box<dyn Pupil>
        }};
    }
    // Each size is compiled by itself: those of described worlds, those of `one`, and one for the rest.
    Ok(match (place.items().len(), actions) {
        (7, 6) => of!(1, 7, 6),
        (16, 4) => of!(1, 16, 4),
        (5, 3) => of!(1, 5, 3),
        (15, 5) => of!(1, 15, 5),
        (48, 6) => of!(2, 48, 6),
        (..=64, 3) => of!(2, 64, 3),
        (..=64, 4) => of!(2, 64, 4),
        (..=64, 5) => of!(2, 64, 5),
        (..=64, 6) => of!(2, 64, 6),
        (..=64, 7) => of!(2, 64, 7),
        (..=64, 8) => of!(2, 64, 8),
        (..=64, 9) => of!(2, 64, 9),
        (..=64, 10) => of!(2, 64, 10),
        (..=64, 11) => of!(2, 64, 11),
        (..=64, 12) => of!(2, 64, 12),
        _ => of!(4, 120, 12),
    })
}

/// Whether a world has the items, and the value, for which its own brain was described.
const fn is_described(place: &Place) -> bool {
    place.around.distractors == 0 && place.around.valued.is_none()
}

/// The book's agent: the one that was described for its world, or one with room for any.
fn agent(
    config: AgentConfig,
    adaptation: Adaptation,
    place: &Place,
    seed: u64,
) -> Result<Box<dyn Pupil>, Failure> {
    macro_rules! of {
        ($described:path) => {{
            use $described as described;
            let mut brain = Box::new(described::brain());
            described::be_born(&mut brain, config, seed)?;
            Box::new(Native::new(brain, adaptation)) as Box<dyn Pupil>
        }};
    }
    let actions = place.actions().len();
    let own = is_described(place);
    Ok(match &place.kind {
        Kind::Pioneer(_) if own => of!(cla_core::forager::pioneer),
        Kind::Vacuum if own => of!(cleaner),
        Kind::Keys if own => of!(seeker),
        Kind::Lake if own => of!(skater),
        Kind::Shuttle(_) if own => of!(docking),
        Kind::Generated(_) if own => {
            let mut brain = Box::new(dweller::brain());
            dweller::be_born(&mut brain, config, seed)?;
            Box::new(Folded::new(Native::new(brain, adaptation), actions))
        }
        _ => {
            let valued = place.valued_item().unwrap_or_default() as u16;
            let mut brain = Box::new(Settler::zeroed());
            brain.be_born(config, &[(ItemId(valued), VALUE)], seed)?;
            Box::new(Folded::new(Native::new(brain, adaptation), actions))
        }
    })
}

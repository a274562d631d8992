//! CLASM: sensorimotor schemas grown from maps, and a controller that uses them (book, 5.3, 6.1–6.2).
//!
//! The pipeline, file by file: items (`item`, `signed_items`, `action`, `notation`) → one completed
//! action (`sample`) → its map (`action_som`) → `harvest` → tables (`schema`, `reliability`,
//! `knowledge`) → `value` → `choice` → the whole (`config`, `agent`, `brain`).
//! It stands on `som` and knows nothing of `layer`.

mod accommodation;
mod action;
mod action_som;
mod agent;
mod applicable;
mod attention;
mod base_rate;
mod belief;
mod brain;
mod choice;
mod composite_action;
mod config;
mod cost;
mod deciding;
mod doubting;
mod evidence;
mod grow;
mod habit;
mod harvest;
mod hindsight;
mod implication;
mod item;
mod knowledge;
mod labels;
mod notation;
mod ordered;
mod planner;
mod reliability;
mod reservoir;
mod sample;
mod schema;
mod second_level;
mod signed_items;
mod simple_schema;
mod simplify;
mod som_level;
mod som_reading;
mod step;
mod surprise;
mod synthetic;
mod value;

pub use accommodation::{Accommodation, AccommodationConfig, Surprise};
pub use action::{ActionId, Vocabulary};
pub use action_som::{ActionSom, ActionSomBank, Recruitment, Trained, TrainingConfig};
pub use agent::{Agent, Stage};
pub use base_rate::BaseRates;
pub use belief::{Belief, BeliefLosses, SyntheticId};
pub use choice::{ChoiceRule, Preference};
pub use composite_action::{Attempt, Progress, chain_backward};
pub use config::{Adaptation, AgentConfig, ConfigError, Escape, SomLevelConfig};
pub use cost::Cost;
pub use evidence::{Evidence, Transition};
pub use grow::GrowthConfig;
pub use habit::{HabitConfig, Habits};
pub use harvest::{HarvestConfig, HarvestedNode, harvest_node};
pub use hindsight::HindsightSample;
pub use implication::Reading;
pub use item::{ItemId, ItemOutOfRange, ItemSet, ItemStates, Items};
pub use knowledge::{KnowledgeBase, Losses, Outcome, TableFull};
pub use notation::{Detail, NotationError, SchemaText, Written};
pub use planner::{Planner, PlannerConfig};
pub use reliability::{Estimate, Reliability};
pub use reservoir::Reservoir;
pub use sample::{ResultCoding, Sample};
pub use schema::{PatternId, Schema, SchemaId};
pub use second_level::{Fallback, Level2Config, SecondLevel};
pub use signed_items::SignedItems;
pub use simple_schema::{Entry, SimpleSchema, SimpleSchemas};
pub use simplify::simplify;
pub use som_level::{Learning, SomLevel, SomLevelLosses};
pub use step::{AgentError, Choice, Lesson, Level, Reason};
pub use surprise::{Doubt, SurpriseConfig};
pub use synthetic::{NoRoomForItem, SyntheticItem, SyntheticItems};
pub use value::{Appraisal, InherentValueError, ValueConfig};

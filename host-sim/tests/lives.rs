//! Lives that are the same in every language: what Python's tests hold is held here, too.
//!
//! `UPDATE_LIVES=1 cargo test -p host-sim --test lives` writes the file that both read.

use std::path::PathBuf;
use std::sync::Arc;

use cla_core::forest::{Mind, MindConfig};
use cla_core::reason::Reason;
use cla_core::snapshot::{Names, Snapshot};
use cla_core::word::{ActionId, ItemId};
use host_sim::failure::Failure;
use host_sim::learner::digest::{Digest, Digested};
use host_sim::learner::image::image_of;
use host_sim::learner::mind::Minded;
use host_sim::learner::native::narrowed;
use host_sim::learner::rewarded::rewarded;
use host_sim::learner::{Learner, live};
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::generated::{Generated, Spec};
use host_sim::world::keys::Keys;
use host_sim::world::lake::Lake;
use host_sim::world::microworld::{Body, Microworld};
use host_sim::world::pioneer::Pioneer;
use host_sim::world::pomdp::{Pomdp, PomdpWorld, SHUTTLE};
use host_sim::world::vacuum::Vacuum;
use host_sim::world::{Percept, World};
use serde_json::{Value, json};

const SEED: u64 = 3;

fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("python/tests/lives.json")
}

fn image(mind: &impl Snapshot, world: &dyn World) -> Result<String, Failure> {
    let image = image_of(mind, Names::of(world.items(), world.actions()))?;
    // An image ends with its own checksum.
    let checksum = image.last_chunk().ok_or("an image has bytes")?;
    Ok(format!("{:08x}", u32::from_le_bytes(*checksum)))
}

/// A mind with reason, as the example `microworld` has it.
type Planner = Mind<3, 76, 10, 48, 64, 256, 64, 64, Reason<3, 76, 10, 150, 1500, 1700>>;

struct Planning(Box<Planner>);

impl Learner for Planning {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        Ok(usize::from(self.0.choose(&narrowed(now))?.action.0))
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.learn_with(now, 0.0)
    }

    fn learn_with(&mut self, now: &Percept, reward: f32) -> Result<(), Failure> {
        self.0.learn_with(&narrowed(now), reward)?;
        Ok(())
    }

    fn observe(&mut self, before: &Percept, by: usize, after: &Percept) -> Result<(), Failure> {
        let by = ActionId(by as u16);
        self.0.observe(&narrowed(before), by, &narrowed(after))?;
        Ok(())
    }
}

fn worth<const ITEMS: usize>(world: &dyn World, item: &str) -> [f32; ITEMS] {
    let mut values = [0.0; ITEMS];
    let at = world.items().iter().position(|&name| name == item);
    values[at.expect("an item of this world")] = 10.0;
    values
}

/// A life that the world pays for, of a mind that values nothing.
fn paid<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize>(
    name: &str,
    mut world: impl World,
    actions: u32,
) -> Result<Value, Failure> {
    let mut mind = Minded::<WORDS, ITEMS, ACTIONS>::born(MindConfig::DEFAULT, [0.0; ITEMS], SEED)?;
    let mut it = Digested::new(&mut mind, Digest::NEW);
    let income = rewarded(&mut it, &mut world, actions)?;
    let digest = format!("{:016x}", it.digest().value());
    let image = image(mind.mind(), &world)?;
    Ok(json!({
        "env": name, "profile": "standard", "value": null, "seed": SEED, "actions": actions,
        "damage": null, "damage_at": 0,
        "earned": income.earned, "episodes": income.episodes, "digest": digest, "image": image,
    }))
}

/// Lives of a forager, in a body that may break in the middle.
fn foraging(damage: Option<&str>, actions: u32) -> Result<Value, Failure> {
    let mut world = Pioneer::new(PioneerConfig::NOISY, SEED)?;
    let values = worth(&world, "ingrip");
    let mut mind = Minded::<1, 7, 6>::born(MindConfig::DEFAULT, values, SEED)?;
    let mut it = Paid(Digested::new(&mut mind, Digest::NEW));
    live(&mut it, &mut world, actions / 2)?;
    let damaged = match damage {
        Some(text) => Damage::parse(text, world.items(), world.actions())?,
        None => Damage::None,
    };
    let mut world = Damaged::new(world, damaged, SEED)?;
    live(&mut it, &mut world, actions / 2)?;
    let digest = format!("{:016x}", it.0.digest().value());
    let image = image(mind.mind(), &world)?;
    Ok(json!({
        "env": "cla/Pioneer-v0", "profile": "standard", "value": "ingrip", "seed": SEED,
        "actions": actions, "damage": damage, "damage_at": actions / 2,
        "earned": world.earned(), "episodes": 0, "digest": digest, "image": image,
    }))
}

/// Whoever is paid by the valued items alone feels a reward of 0 beside them.
struct Paid<'a>(Digested<'a>);

impl Learner for Paid<'_> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        self.0.choose(now)
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.0.learn_with(now, 0.0)
    }

    fn observe(&mut self, before: &Percept, by: usize, after: &Percept) -> Result<(), Failure> {
        self.0.observe(before, by, after)
    }
}

fn planning(actions: u32) -> Result<Value, Failure> {
    let mut world = Microworld::new(SEED, Body::Visible, 0.0);
    let mut mind = Planning(Box::new(Mind::unborn()));
    mind.0
        .be_born(MindConfig::DEFAULT, worth(&world, "hgr"), SEED)?;
    let mut it = Digested::new(&mut mind, Digest::NEW);
    rewarded(&mut it, &mut world, actions)?;
    let digest = format!("{:016x}", it.digest().value());
    Ok(json!({
        "env": "cla/Microworld-v0", "profile": "planner", "value": "hgr", "seed": SEED,
        "actions": actions, "damage": null, "damage_at": 0,
        "earned": 0.0, "episodes": 0, "digest": digest, "image": null,
    }))
}

/// What is sensed of the items that have names, as Python has it.
fn named(world: &dyn World) -> Percept {
    let (whole, mut named) = (world.sense(), Percept::UNKNOWN);
    for item in (0..world.items().len()).map(|index| ItemId(index as u16)) {
        named.set(item, whole.get(item)).expect("it fits");
    }
    named
}

/// A world in which the actions follow a rule that anybody can repeat, and what was sensed.
fn driven(name: &str, options: Value, mut world: impl World, actions: u32) -> Value {
    let (mut digest, mut reflexes) = (Digest::NEW, 0_u32);
    for step in 0..actions as usize {
        digest.percept(&named(&world));
        world.act((step * step / 3) % world.actions().len());
        digest.percept(&named(&world));
        while world.reflex().is_some() {
            reflexes += 1;
        }
        if world.episode_ended() {
            world.begin_episode();
        }
    }
    json!({
        "env": name, "options": options, "seed": SEED, "actions": actions,
        "earned": world.earned(), "reflexes": reflexes, "digest": format!("{:016x}", digest.value()),
    })
}

fn shuttle() -> Result<PomdpWorld, Failure> {
    Ok(PomdpWorld::new(Arc::new(Pomdp::parse(SHUTTLE)?), SEED))
}

fn lived() -> Result<Value, Failure> {
    let pioneer = Pioneer::new(PioneerConfig::NOISY, SEED)?;
    let small = PioneerConfig {
        radius: 3.0,
        specimens: 5,
        drop_out: 0.0,
        after_capture: host_sim::world::config::AfterCapture::Removed,
        ..PioneerConfig::NOISY
    };
    let stage = Pioneer::new(small, SEED)?;
    let made = Generated::new(Arc::new(Spec::random(5)), SEED);
    Ok(json!({
        "worlds": [
            driven("cla/Pioneer-v0", json!({}), pioneer, 2000),
            driven(
                "cla/Pioneer-v0",
                json!({"radius": 3.0, "specimens": 5, "drop_out": 0.0, "replaced": 0}),
                stage,
                300,
            ),
            driven("cla/Microworld-v0", json!({}), Microworld::new(SEED, Body::Visible, 0.0), 2000),
            driven("cla/Microworld-v0", json!({"slip": 0.25, "hidden_body": 1}),
                Microworld::new(SEED, Body::Hidden, 0.25), 2000),
            driven("cla/Shuttle-v0", json!({}), shuttle()?, 2000),
            driven("cla/Vacuum-v0", json!({}), Vacuum::new(SEED), 2000),
            driven("cla/Lake-v0", json!({}), Lake::new(SEED), 2000),
            driven("cla/Keys-v0", json!({}), Keys::new(SEED), 2000),
            driven("cla/Generated-v0", json!({"world": 5}), made, 2000),
        ],
        "lives": [
            foraging(None, 4000)?,
            foraging(Some("camera:+12"), 4000)?,
            foraging(Some("slip:0.2"), 1000)?,
            paid::<1, 5, 3>("cla/Shuttle-v0", shuttle()?, 2000)?,
            paid::<1, 15, 5>("cla/Vacuum-v0", Vacuum::new(SEED), 2000)?,
            paid::<1, 16, 4>("cla/Lake-v0", Lake::new(SEED), 2000)?,
            paid::<2, 48, 6>("cla/Keys-v0", Keys::new(SEED), 2000)?,
            paid::<3, 76, 10>("cla/Microworld-v0", Microworld::new(SEED, Body::Visible, 0.0), 500)?,
            planning(1500)?,
        ],
    }))
}

#[test]
fn lives_are_those_that_python_lives() {
    let lived = lived().expect("everybody lives");
    if std::env::var_os("UPDATE_LIVES").is_some() {
        let text = serde_json::to_string_pretty(&lived).expect("it can be written");
        std::fs::write(file(), text + "\n").expect("the file can be written");
    }
    let committed = std::fs::read_to_string(file()).expect("the file is there");
    let committed: Value = serde_json::from_str(&committed).expect("it is JSON");
    for kind in ["worlds", "lives"] {
        let both = [&lived, &committed].map(|it| it[kind].as_array().expect("a list"));
        assert_eq!(both[0].len(), both[1].len());
        for (lived, committed) in both[0].iter().zip(both[1]) {
            assert_eq!(lived, committed);
        }
    }
}

//! Knowledge alone moves into another life, and into a robot that has grown.

mod fixtures;

use cla_core::forest::{Mind, MindConfig};
use cla_core::num::Rng;
use cla_core::reason::Reason;
use cla_core::snapshot::{
    Knowing, LoadError, Names, SliceSink, SourceEnd, load, load_knowledge, save, save_knowledge,
};
use cla_core::{ActionId, Adaptation, AgentConfig, ItemId, Percept};

macro_rules! robot {
    ($name:ident, [$($item:ident),+], [$($action:ident),+], $size:literal, $($maps:tt)+) => {
        cla_core::brain! {
            /// A robot that wants to stand in the light.
            pub mod $name {
                items: [$($item),+],
                actions: [$($action),+],
                values: [at_lamp = 10.0],
                maps: $($maps)+,
                patterns: $size,
                schemas: $size,
                synthetic: $size,
                beliefs: 96,
                ram: 120_000,
            }
        }
    };
}

robot!(little, [light_left, light_ahead, light_right, at_lamp], [left, forward, right], 32, 4 x 4);
robot!(
    grown,
    [
        light_left, light_ahead, light_right, at_lamp, bell, i5, i6, i7, i8, i9, i10, i11, i12, i13,
        i14, i15, i16, i17, i18, i19, i20, i21, i22, i23, i24, i25, i26, i27, i28, i29, i30, i31, i32
    ],
    [left, forward, right, ring],
    48,
    5 x 4 of bytes
);
robot!(renamed, [light_left, light_right, light_ahead, at_lamp], [left, forward, right], 32, 4 x 4);
robot!(narrow, [light_left, light_ahead, light_right, at_lamp], [left, forward, right], 4, 4 x 4);
robot!(cramped, [light_left, light_ahead, light_right, at_lamp], [left, forward, right], 32, 2 x 2);
robot!(
    blind,
    [light_left, light_ahead, at_lamp],
    [left, forward],
    32,
    4 x 4
);

/// The lamp is to the left, ahead or to the right, and near or far.
#[derive(Clone)]
struct Lamp {
    rng: Rng,
    bearing: u16,
    near: bool,
    reached: u32,
}

impl Lamp {
    fn new(seed: u64) -> Self {
        Self {
            rng: Rng::new(seed),
            bearing: 0,
            near: false,
            reached: 0,
        }
    }

    /// What is on; a bell rings at random, where there is an item for it.
    fn sense<const WORDS: usize>(&mut self, items: u16) -> Percept<WORDS> {
        let mut now = Percept::all_off(items);
        now.set(ItemId(self.bearing), Some(true)).unwrap();
        now.set(ItemId(3), Some(self.near)).unwrap();
        if items > 4 {
            now.set(ItemId(4), Some(self.rng.chance(0.5))).unwrap();
        }
        now
    }

    fn act(&mut self, action: ActionId) {
        if self.near || self.rng.chance(0.05) {
            (self.bearing, self.near) = (self.rng.below(3) as u16, false);
            return;
        }
        match (action.0, self.bearing) {
            (0, 0) | (2, 2) => self.bearing = 1,
            (1, 1) => self.near = true,
            _ => {}
        }
        self.reached += u32::from(self.near);
    }
}

macro_rules! live {
    ($brain:expr, $lamp:expr, $items:expr, $actions:expr) => {{
        let mut lamp = $lamp;
        for _ in 0..$actions {
            let choice = $brain.choose(&lamp.sense($items)).unwrap();
            lamp.act(choice.action);
            $brain.learn(&lamp.sense($items)).unwrap();
        }
        lamp.reached
    }};
}

fn knowledge<B: Knowing>(brain: &B, names: Names) -> Vec<u8> {
    let mut image = vec![0; 1 << 18];
    let length = save_knowledge(brain, names, &mut SliceSink::new(&mut image)).unwrap();
    image.truncate(length as usize);
    image
}

fn learned() -> (Box<little::Brain>, Vec<u8>) {
    let mut brain = Box::new(little::brain());
    little::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
    live!(brain, Lamp::new(9), 4, 1500);
    brain.act(Adaptation::Relearning).unwrap();
    let image = knowledge(&*brain, little::VOCABULARY.names());
    (brain, image)
}

fn take<B: Knowing>(
    brain: &mut B,
    words: cla_core::Vocabulary,
    image: &[u8],
) -> Result<u32, LoadError<SourceEnd>> {
    load_knowledge(brain, words.items, words.actions, &mut &*image)
}

macro_rules! born {
    ($robot:ident, $seed:expr) => {{
        let mut brain = Box::new($robot::brain());
        $robot::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, $seed).unwrap();
        brain
    }};
}

#[test]
fn another_life_of_the_same_robot_acts_on_it_at_once_and_its_maps_say_the_same() {
    let (brain, image) = learned();
    let mut whole = vec![0; 1 << 18];
    let bytes = save(&*brain, Names::UNKNOWN, &mut SliceSink::new(&mut whole)).unwrap();
    assert!((image.len() as u32) < bytes, "{} of {bytes}", image.len());
    let mut other = born!(little, 77);
    live!(other, Lamp::new(1), 4, 300);
    assert_eq!(
        take(&mut *other, little::VOCABULARY, &image),
        Ok(image.len() as u32)
    );
    assert!(knowledge(&*other, little::VOCABULARY.names()) == image);
    let said = |it: &little::Brain| {
        let schemas = it.knowledge().schemas().iter().enumerate();
        let mut said: Vec<String> = schemas
            .map(|(id, _)| {
                let text = it
                    .knowledge()
                    .text(cla_core::knowledge::SchemaId(id as u16));
                format!("{text:?}")
            })
            .collect();
        said.sort();
        said
    };
    assert_eq!(said(&other), said(&brain));
    other.harvest();
    assert_eq!(said(&other), said(&brain), "the maps say the same");
    other.act(Adaptation::Relearning).unwrap();
    let mut newborn = born!(little, 77);
    newborn.act(Adaptation::Relearning).unwrap();
    let (knows, does_not) = (
        live!(other, Lamp::new(4), 4, 300),
        live!(newborn, Lamp::new(4), 4, 300),
    );
    assert!(
        knows > 80 && knows > does_not + 20,
        "{knows} and {does_not}"
    );
}

#[test]
fn a_robot_that_has_grown_knows_what_it_knew_and_nothing_of_what_is_new() {
    let (brain, image) = learned();
    let mut other = born!(grown, 5);
    take(&mut *other, grown::VOCABULARY, &image).unwrap();
    assert_eq!(
        other.knowledge().schemas().len(),
        brain.knowledge().schemas().len()
    );
    for schema in other.knowledge().schemas() {
        assert!(schema.action < ActionId(3));
        for pattern in [schema.context, schema.result] {
            let items = other.knowledge().pattern(pattern).unwrap();
            let named = items.positive().union(items.negative());
            assert!(named.iter().all(|item| item < ItemId(4)));
        }
    }
    other.act(Adaptation::Relearning).unwrap();
    let mut newborn = born!(grown, 5);
    newborn.act(Adaptation::Relearning).unwrap();
    let (knows, does_not) = (
        live!(other, Lamp::new(4), 33, 400),
        live!(newborn, Lamp::new(4), 33, 400),
    );
    assert!(
        knows > 90 && knows > does_not + 20,
        "{knows} and {does_not}"
    );
    // It learns on, and what it knows can be kept.
    let again = knowledge(&*other, grown::VOCABULARY.names());
    let mut third = born!(grown, 6);
    take(&mut *third, grown::VOCABULARY, &again).unwrap();
}

#[test]
fn what_does_not_fit_is_named_and_the_brain_is_as_it_was() {
    let (_, image) = learned();
    let sentence = |refused: Result<u32, LoadError<SourceEnd>>| refused.unwrap_err().to_string();
    macro_rules! refused {
        ($robot:ident) => {{
            let mut brain = born!($robot, 2);
            let before = knowledge(&*brain, Names::UNKNOWN);
            let said = sentence(take(&mut *brain, $robot::VOCABULARY, &image));
            assert!(knowledge(&*brain, Names::UNKNOWN) == before);
            said
        }};
    }
    assert_eq!(
        refused!(renamed),
        "the image is of a robot whose items have other names"
    );
    let said = refused!(narrow);
    assert!(said.ends_with(", and this one has 4"), "{said}");
    // Its tables have room, and its maps have no nodes that would say it at the next harvest.
    let said = refused!(cramped);
    let nodes = " schemas of an action, and this one has 4";
    assert!(said.ends_with(nodes), "{said}");
    assert_eq!(
        refused!(blind),
        "the image is of a brain with 4 items, and this one has 3"
    );
    let mut unborn = Box::new(little::brain());
    let refused = take(&mut *unborn, little::VOCABULARY, &image);
    assert_eq!(refused, Err(LoadError::NotBorn));
    // A life is no knowledge, and knowledge is no life.
    let mut brain = born!(little, 2);
    let refused = load(&mut *brain, Names::UNKNOWN, &mut &*image);
    let kind = |image, here| Err(LoadError::Kind { image, here });
    assert_eq!(refused, kind("an agent's knowledge", "an agent"));
    let mut mind = Box::new(Mind::<1, 4, 3, 8, 12, 32, 48, 160>::new());
    mind.be_born(MindConfig::DEFAULT, [0.0; 4], 1).unwrap();
    let refused = take(&mut *mind, little::VOCABULARY, &image);
    assert_eq!(refused, kind("an agent's knowledge", "a mind's knowledge"));
}

/// Written when version 1 was new, after 1500 actions; it is never written again.
#[test]
fn knowledge_of_every_version_is_read_for_ever() {
    let taken = |golden: &[u8]| {
        let mut brain = born!(little, 2);
        let taken = take(&mut *brain, little::VOCABULARY, golden);
        assert_eq!(taken, Ok(golden.len() as u32));
        brain
    };
    let again = |golden: &[u8]| knowledge(&*taken(golden), little::VOCABULARY.names());
    for golden in fixtures::versions("lamp-v?.knowledge", again) {
        let mut brain = taken(&golden);
        assert_eq!(brain.knowledge().schemas().len(), 28);
        assert!(live!(brain, Lamp::new(4), 4, 300) > 60);
    }
}

#[test]
fn damaged_knowledge_is_refused() {
    let (_, image) = learned();
    let mut brain = born!(little, 2);
    let before = knowledge(&*brain, Names::UNKNOWN);
    for bit in (0..image.len() * 8).step_by(3) {
        let mut damaged = image.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(
            take(&mut *brain, little::VOCABULARY, &damaged).is_err(),
            "bit {bit}"
        );
    }
    for length in 0..image.len() {
        let refused = take(&mut *brain, little::VOCABULARY, &image[..length]);
        assert_eq!(refused, Err(LoadError::Truncated));
    }
    assert!(knowledge(&*brain, Names::UNKNOWN) == before);
}

type Small = Mind<1, 4, 3, 24, 24, 32, 64, 256, Reason<1, 4, 3, 16, 32, 64>>;
type Grown = Mind<2, 40, 4, 48, 32, 64, 64, 256, Reason<2, 40, 4, 24, 48, 64>>;

/// A mind that wants to stand in the light.
fn small(seed: u64) -> Box<Small> {
    let mut mind = Box::new(Small::unborn());
    let values = [0.0, 0.0, 0.0, 10.0];
    mind.be_born(MindConfig::DEFAULT, values, seed).unwrap();
    mind
}

/// The items that are known in each sample of what a mind of so many words and items knows, at most 64
/// of them, as bits.
fn known_in_samples(image: &[u8], words: usize, items: usize) -> Vec<u64> {
    let number = |at: usize| usize::from(u16::from_le_bytes([image[at], image[at + 1]]));
    // Header, number of the first section, and its bytes.
    let (length, fields) = (number(82), 86);
    // What each item tells, which of them matter, and whether any trees were grown.
    let memory = fields + 4 * items + 4 * words + 1;
    // How many samples, how many of them recent; of each what was on, what was off, what it brought,
    // its action and its marks.
    let (samples, size) = (number(memory), 8 * words + 4 + 2);
    assert_eq!(fields + length, memory + 4 + samples * size);
    let set = |bytes: &[u8]| {
        let mut set = 0;
        for (word, of) in bytes.chunks_exact(4).enumerate() {
            let of = u32::from_le_bytes(of.try_into().unwrap());
            set |= u64::from(of) << (32 * word);
        }
        set
    };
    let all = image[memory + 4..].chunks_exact(size).take(samples);
    all.map(|it| set(&it[..4 * words]) | set(&it[4 * words..8 * words]))
        .collect()
}

/// Written with 0.2.0, after 1500 actions; it is never written again.
#[test]
fn knowledge_of_a_mind_of_every_version_is_read_for_ever() {
    let names = little::VOCABULARY.names();
    let taken = |golden: &[u8], seed| {
        let mut mind = small(seed);
        let taken = take(&mut *mind, little::VOCABULARY, golden);
        assert_eq!(taken, Ok(golden.len() as u32));
        mind
    };
    // Where the other life ended is kept no longer; the rest is taken as it was, and again.
    let again = |golden: &[u8]| knowledge(&*taken(golden, 9), names);
    for golden in fixtures::versions("lamp-mind-v?.knowledge", again) {
        let mut mind = taken(&golden, 8);
        assert_eq!(mind.size().0, 384);
        assert!(!mind.reason().schemas().is_empty());
        assert_eq!(knowledge(&*mind, names).len(), golden.len());
        mind.act().unwrap();
        live!(mind, Lamp::new(4), 4, 300);
    }
}

#[test]
fn a_mind_takes_samples_and_schemas_along_and_its_trees_grow_anew() {
    let mut mind = small(3);
    live!(mind, Lamp::new(9), 4, 1500);
    let image = knowledge(&*mind, little::VOCABULARY.names());
    let mut values = [0.0; 40];
    values[3] = 10.0;
    let newborn = |seed| {
        let mut mind = Box::new(Grown::unborn());
        mind.be_born(MindConfig::DEFAULT, values, seed).unwrap();
        mind
    };
    let mut other = newborn(8);
    let refused = take(&mut *other, renamed::VOCABULARY, &image);
    assert_eq!(refused, Err(LoadError::Items));
    take(&mut *other, grown::VOCABULARY, &image).unwrap();
    assert_eq!(other.size().0, mind.size().0, "samples");
    // Of the items that were added nobody knows what they were then.
    let known = known_in_samples(&knowledge(&*other, grown::VOCABULARY.names()), 2, 40);
    assert_eq!(known.len(), usize::from(mind.size().0));
    assert!(known.iter().all(|&items| items == 0b1111), "{known:?}");
    assert_eq!(
        other.reason().schemas().len(),
        mind.reason().schemas().len()
    );
    for _ in 0..400 {
        other.idle(2000);
    }
    let mut ignorant = newborn(8);
    for it in [&mut other, &mut ignorant] {
        it.act().unwrap();
    }
    let (knows, does_not) = (
        live!(other, Lamp::new(4), 33, 300),
        live!(ignorant, Lamp::new(4), 33, 300),
    );
    assert!(knows > 70 && knows > does_not, "{knows} and {does_not}");
    // One without a reason has no place for what it knows.
    let mut plain = Box::new(Mind::<1, 4, 3, 24, 24, 32, 64, 256>::unborn());
    plain.be_born(MindConfig::DEFAULT, [0.0; 4], 1).unwrap();
    let refused = take(&mut *plain, little::VOCABULARY, &image);
    assert!(
        matches!(
            refused,
            Err(LoadError::Capacity {
                name: "schemas",
                ..
            })
        ),
        "{refused:?}"
    );
    // Nor has it one for what a mind knows that has not reasoned yet.
    let mut newborn = Box::new(Small::unborn());
    newborn.be_born(MindConfig::DEFAULT, [0.0; 4], 1).unwrap();
    let image = knowledge(&*newborn, little::VOCABULARY.names());
    let refused = take(&mut *plain, little::VOCABULARY, &image).unwrap_err();
    let sentence = "the image is of a brain with 32 schemas, and this one has 0";
    assert_eq!(refused.to_string(), sentence);
}

//! A life that is saved, loaded and gone on with is the life that was never interrupted.

mod fixtures;
mod lamp;

use cla_core::choice::{HabitConfig, Traces};
use cla_core::num::Rng;
use cla_core::snapshot::{self, LoadError, Names, SaveError, SinkFull, SliceSink, Snapshot};
use cla_core::{Adaptation, AgentConfig, ItemId};
use lamp::{Lamp, bytes, floats};

/// What is done with a life before it is saved.
#[derive(Clone, Copy, Debug)]
enum Until {
    Training,
    Acting(Adaptation),
    Doubting,
    /// Between a choice and what comes of it.
    Chosen,
}

fn image<B: Snapshot>(brain: &B) -> Vec<u8> {
    let mut image = vec![0; 1 << 20];
    let names = floats::VOCABULARY.names();
    let mut sink = SliceSink::new(&mut image);
    let length = snapshot::save(brain, names, &mut sink).unwrap();
    assert_eq!(sink.written(), length as usize);
    image.truncate(length as usize);
    image
}

fn load<B: Snapshot>(brain: &mut B, image: &[u8]) -> Result<u32, LoadError<snapshot::SourceEnd>> {
    snapshot::load(brain, floats::VOCABULARY.names(), &mut &*image)
}

macro_rules! goes_on {
    ($robot:ident, $config:expr, $until:expr) => {{
        let (config, until): (AgentConfig, Until) = ($config, $until);
        let mut brain = Box::new($robot::brain());
        $robot::be_born(&mut brain, config, 3).unwrap();
        let mut lamp = Lamp::new(9);
        lamp.live(&mut brain, 700);
        match until {
            Until::Training => {}
            Until::Acting(adaptation) => {
                brain.act(adaptation).unwrap();
                lamp.live(&mut brain, 300);
            }
            Until::Doubting => {
                brain.act(Adaptation::Relearning).unwrap();
                lamp.live(&mut brain, 200);
                lamp.turned = true;
                brain.doubt();
                lamp.live(&mut brain, 77);
                assert_eq!(brain.doubts(), config.surprise.is_some());
            }
            Until::Chosen => {
                brain.act(Adaptation::Relearning).unwrap();
                lamp.live(&mut brain, 50);
                brain.choose(&lamp.sense()).unwrap();
            }
        }
        let saved = image(&*brain);
        // The other brain has lived, so that what is not read over would be seen.
        let mut other = Box::new($robot::brain());
        $robot::be_born(&mut other, AgentConfig::RESILIENT_LEVEL2, 77).unwrap();
        Lamp::new(5).live(&mut other, 400);
        assert_ne!(image(&*other), saved);
        assert_eq!(load(&mut *other, &saved), Ok(saved.len() as u32));
        assert_eq!(image(&*other), saved, "{until:?}");
        assert_eq!((other.stage(), other.cost()), (brain.stage(), brain.cost()));
        let mut there = lamp.clone();
        if matches!(until, Until::Chosen) {
            let lessons = [&mut brain, &mut other].map(|it| it.learn(&lamp.sense()).unwrap());
            assert_eq!(lessons[0], lessons[1]);
        }
        for hundred in 0..12 {
            let (here, elsewhere) = (lamp.live(&mut brain, 100), there.live(&mut other, 100));
            assert_eq!(here, elsewhere, "{until:?}, after {hundred} hundred");
        }
        for adaptation in [Adaptation::Relearning, Adaptation::Frozen] {
            for it in [&mut brain, &mut other] {
                it.act(adaptation).unwrap();
            }
            assert_eq!(lamp.live(&mut brain, 300), there.live(&mut other, 300));
        }
        assert_eq!(image(&*brain), image(&*other));
        saved.len()
    }};
}

const UNTIL: [Until; 6] = [
    Until::Training,
    Until::Acting(Adaptation::Frozen),
    Until::Acting(Adaptation::Reliabilities),
    Until::Acting(Adaptation::Relearning),
    Until::Doubting,
    Until::Chosen,
];

#[test]
fn every_named_configuration_goes_on_to_the_bit_from_every_stage() {
    for config in [
        AgentConfig::BOOK,
        AgentConfig::FORAGER,
        AgentConfig::FORAGER_LEVEL2,
        AgentConfig::RESILIENT,
        AgentConfig::RESILIENT_LEVEL2,
        AgentConfig::FORAGER_LASTING,
        AgentConfig::RESILIENT_LASTING,
    ] {
        for until in UNTIL {
            goes_on!(floats, config, until);
        }
    }
}

#[test]
fn maps_of_bytes_go_on_to_the_bit_too() {
    for until in UNTIL {
        goes_on!(bytes, AgentConfig::RESILIENT_LEVEL2, until);
    }
}

#[test]
fn a_second_birth_leaves_nothing_of_the_first_life() {
    for until in UNTIL {
        let mut brain = Box::new(bytes::brain());
        bytes::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
        let mut lamp = Lamp::new(9);
        lamp.live(&mut brain, 900);
        match until {
            Until::Training => {}
            Until::Acting(adaptation) => brain.act(adaptation).unwrap(),
            Until::Doubting => {
                brain.act(Adaptation::Relearning).unwrap();
                brain.doubt();
            }
            Until::Chosen => {}
        }
        lamp.live(&mut brain, 100);
        brain.choose(&lamp.sense()).unwrap();
        bytes::be_born(&mut brain, AgentConfig::FORAGER, 5).unwrap();
        let mut newborn = Box::new(bytes::brain());
        bytes::be_born(&mut newborn, AgentConfig::FORAGER, 5).unwrap();
        assert!(image(&*brain) == image(&*newborn), "{until:?}");
    }
}

/// A small brain that has learned something, and its image.
fn learned() -> (Box<bytes::Brain>, Vec<u8>) {
    let mut brain = Box::new(bytes::brain());
    bytes::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, 3).unwrap();
    Lamp::new(9).live(&mut brain, 700);
    let image = image(&*brain);
    (brain, image)
}

/// A brain that is not that of the image; it must stay as it is.
fn living() -> (Box<bytes::Brain>, Vec<u8>) {
    let mut brain = Box::new(bytes::brain());
    bytes::be_born(&mut brain, AgentConfig::FORAGER, 5).unwrap();
    Lamp::new(1).live(&mut brain, 50);
    let image = image(&*brain);
    (brain, image)
}

#[test]
fn an_image_with_any_bit_flipped_is_refused_and_the_living_brain_stays() {
    let (_, whole) = learned();
    let (mut brain, before) = living();
    for bit in 0..whole.len() * 8 {
        let mut damaged = whole.clone();
        damaged[bit / 8] ^= 1 << (bit % 8);
        assert!(load(&mut *brain, &damaged).is_err(), "bit {bit}");
    }
    assert_eq!(image(&*brain), before);
}

#[test]
fn images_with_several_bits_flipped_are_refused() {
    // `tests/run all` asks for more.
    let many = std::env::var("CLA_FLIPS").map_or(100_000, |it| it.parse().unwrap());
    let (_, whole) = learned();
    let (mut brain, before) = living();
    let mut rng = Rng::new(20);
    let mut damaged = whole.clone();
    for trial in 0..many {
        let flips = 2 + rng.below(7);
        // Scattered, or all within a few bytes as a failing cell has them.
        let near = rng
            .chance(0.5)
            .then(|| rng.below(whole.len() as u32 - 4) * 8);
        let mut bits = std::collections::BTreeSet::new();
        for _ in 0..flips {
            let bit = match near {
                Some(base) => base + rng.below(32),
                None => rng.below(whole.len() as u32 * 8),
            };
            bits.insert(bit as usize);
        }
        for &bit in &bits {
            damaged[bit / 8] ^= 1 << (bit % 8);
        }
        assert!(load(&mut *brain, &damaged).is_err(), "trial {trial}");
        for &bit in &bits {
            damaged[bit / 8] ^= 1 << (bit % 8);
        }
    }
    assert_eq!(damaged, whole);
    assert_eq!(image(&*brain), before);
}

#[test]
fn an_image_without_its_end_is_refused_at_every_length() {
    let (_, whole) = learned();
    let (mut brain, before) = living();
    for length in 0..whole.len() {
        let refused = load(&mut *brain, &whole[..length]);
        assert_eq!(refused, Err(LoadError::Truncated), "{length}");
    }
    assert_eq!(image(&*brain), before);
    // What lies behind an image, as in a slot of flash, is nobody's business.
    let mut slot = whole.clone();
    slot.resize(whole.len() + 1000, 0xff);
    assert_eq!(load(&mut *brain, &slot), Ok(whole.len() as u32));
}

#[test]
fn an_image_of_another_robot_is_refused_with_what_differs() {
    let (_, whole) = learned();
    let mut other = Box::new(lamp::larger::brain());
    let refused = load(&mut *other, &whole).unwrap_err();
    let sentence = "the image is of a brain with 16 patterns, and this one has 24";
    assert_eq!(refused.to_string(), sentence);
    let mut other = Box::new(floats::brain());
    assert_eq!(load(&mut *other, &whole), Err(LoadError::Weights));
    let mut brain = Box::new(bytes::brain());
    let named = |items: &[&str], actions: &[&str]| Names::of(items, actions);
    let (items, actions) = (bytes::VOCABULARY.items, bytes::VOCABULARY.actions);
    let mut swapped = items.to_vec();
    swapped.swap(0, 1);
    let mut load = |names| snapshot::load(&mut *brain, names, &mut &*whole);
    assert_eq!(load(named(&swapped, actions)), Err(LoadError::Items));
    assert_eq!(
        load(named(items, &["a", "b", "c"])),
        Err(LoadError::Actions)
    );
    assert!(load(named(items, actions)).is_ok() && load(Names::UNKNOWN).is_ok());
}

#[test]
fn an_unborn_brain_has_nothing_to_save_and_a_full_sink_says_so() {
    let mut brain = Box::new(bytes::brain());
    let mut few = [0; 100];
    let names = bytes::VOCABULARY.names();
    let saved = snapshot::save(&*brain, names, &mut SliceSink::new(&mut few));
    assert_eq!(saved, Err(SaveError::NotBorn));
    bytes::be_born(&mut brain, AgentConfig::FORAGER, 1).unwrap();
    let saved = snapshot::save(&*brain, names, &mut SliceSink::new(&mut few));
    assert_eq!(saved, Err(SaveError::Sink(SinkFull)));
}

/// A medium that loses a bit after it was read once.
struct Fading {
    image: Vec<u8>,
    reads: u32,
    after: u32,
}

impl snapshot::Source for Fading {
    type Error = snapshot::SourceEnd;

    fn length(&self) -> u32 {
        self.image.len() as u32
    }

    fn read(&mut self, at: u32, piece: &mut [u8]) -> Result<(), Self::Error> {
        self.reads += 1;
        if self.reads == self.after {
            let middle = self.image.len() / 2;
            self.image[middle] ^= 1;
        }
        (&*self.image).read(at, piece)
    }
}

#[test]
fn a_medium_that_fails_between_two_readings_leaves_the_brain_unborn() {
    let (_, whole) = learned();
    let mut all = Fading {
        image: whole.clone(),
        reads: 0,
        after: 0,
    };
    let (mut brain, _) = living();
    snapshot::load(&mut *brain, Names::UNKNOWN, &mut all).unwrap();
    let mut fading = Fading {
        image: whole.clone(),
        reads: 0,
        after: all.reads / 2 + 1,
    };
    let (mut brain, _) = living();
    let refused = snapshot::load(&mut *brain, Names::UNKNOWN, &mut fading);
    assert_eq!(refused, Err(LoadError::Changed));
    assert!(brain.choose(&bytes::Percept::all_off(4)).is_err());
    // In the first reading nothing has been taken yet.
    let mut fading = Fading {
        image: whole,
        reads: 0,
        after: 2,
    };
    let (mut brain, before) = living();
    assert!(snapshot::load(&mut *brain, Names::UNKNOWN, &mut fading).is_err());
    assert_eq!(image(&*brain), before);
}

/// A medium that can be read so many times.
struct Broken {
    image: Vec<u8>,
    reads: u32,
}

impl snapshot::Source for Broken {
    type Error = snapshot::SourceEnd;

    fn length(&self) -> u32 {
        self.image.len() as u32
    }

    fn read(&mut self, at: u32, piece: &mut [u8]) -> Result<(), Self::Error> {
        self.reads = self.reads.checked_sub(1).ok_or(snapshot::SourceEnd)?;
        (&*self.image).read(at, piece)
    }
}

#[test]
fn a_medium_that_cannot_be_read_again_is_told_as_such() {
    let (_, whole) = learned();
    let (mut taken, mut interrupted) = (0, 0);
    for reads in 0..400 {
        let (mut brain, before) = living();
        let mut source = Broken {
            image: whole.clone(),
            reads,
        };
        match snapshot::load(&mut *brain, Names::UNKNOWN, &mut source) {
            Err(LoadError::Source(_)) => assert_eq!(image(&*brain), before),
            Err(LoadError::Interrupted(_)) => {
                interrupted += 1;
                assert!(brain.choose(&bytes::Percept::all_off(4)).is_err());
            }
            loaded => {
                assert_eq!(loaded, Ok(whole.len() as u32));
                taken += 1;
            }
        }
    }
    assert!(taken > 0 && interrupted > 10, "{taken}, {interrupted}");
    let said = LoadError::Interrupted(snapshot::SourceEnd).to_string();
    assert!(said.starts_with("the brain is unborn"), "{said}");
}

/// Written when version 1 was new, after 700 actions; it is never written again.
#[test]
fn the_image_of_every_version_is_read_for_ever() {
    let taken = |golden: &[u8]| {
        let mut brain = Box::new(bytes::brain());
        assert_eq!(load(&mut *brain, golden), Ok(golden.len() as u32));
        brain
    };
    for golden in fixtures::versions("lamp-v?.image", |golden| image(&*taken(golden))) {
        let mut brain = taken(&golden);
        assert_eq!(brain.knowledge().inherent_value(ItemId(3)), 10.0);
        let samples: u32 = brain.bank().maps().iter().map(|map| map.samples()).sum();
        assert_eq!((samples, brain.knowledge().schemas().len()), (719, 32));
        Lamp::new(21).live(&mut brain, 500);
    }
}

/// The same of maps of floats, written with 0.2.0; it is never written again.
#[test]
fn the_image_of_every_version_with_maps_of_floats_is_read_for_ever() {
    let taken = |golden: &[u8]| {
        let mut brain = Box::new(floats::brain());
        assert_eq!(load(&mut *brain, golden), Ok(golden.len() as u32));
        brain
    };
    for golden in fixtures::versions("lamp-floats-v?.image", |golden| image(&*taken(golden))) {
        let mut brain = taken(&golden);
        assert_eq!(brain.knowledge().inherent_value(ItemId(3)), 10.0);
        let samples: u32 = brain.bank().maps().iter().map(|map| map.samples()).sum();
        assert_eq!(samples, 719);
        assert!(!brain.knowledge().schemas().is_empty());
        assert!(!brain.second_level().beliefs().is_empty());
        Lamp::new(21).live(&mut brain, 500);
    }
}

/// The image with bytes of its sections changed, each a number and what lies in it, and its checksums made
/// right.
fn resealed(whole: &[u8], mut change: impl FnMut(usize, &mut [u8])) -> Vec<u8> {
    let of_sections = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI);
    let mut image = whole.to_vec();
    let end = image.len() - 4;
    let mut at = 80;
    while at < end {
        let length = u32::from_le_bytes(image[at + 2..at + 6].try_into().unwrap());
        let to = at + 6 + length as usize;
        change(at + 6, &mut image[at + 6..to]);
        let sum = of_sections.checksum(&image[at..to]);
        image[to..to + 4].copy_from_slice(&sum.to_le_bytes());
        at = to + 4;
    }
    let sum = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC).checksum(&image[..end]);
    image[end..].copy_from_slice(&sum.to_le_bytes());
    image
}

/// The image with other bytes here and there.
fn lying(whole: &[u8], rng: &mut Rng) -> Vec<u8> {
    resealed(whole, |_, section| {
        if rng.chance(0.3) {
            for _ in 0..1 + rng.below(3) {
                let place = rng.below(section.len() as u32) as usize;
                section[place] = match rng.below(4) {
                    0 => 0xff,
                    1 => section[place] ^ 1 << rng.below(8),
                    _ => rng.next_u32() as u8,
                };
            }
        }
    })
}

/// The byte in which version 2 is longer than version 1.
#[test]
fn the_kind_of_traces_is_a_byte_that_is_0_or_1_and_0_in_what_version_1_becomes() {
    let born = |traces| {
        let mut brain = Box::new(bytes::brain());
        let habits = AgentConfig::RESILIENT_LASTING.habits.unwrap();
        let config = AgentConfig {
            habits: Some(HabitConfig { traces, ..habits }),
            ..AgentConfig::RESILIENT_LASTING
        };
        bytes::be_born(&mut brain, config, 3).unwrap();
        image(&*brain)
    };
    let (replacing, accumulating) = (born(Traces::Replacing), born(Traces::Accumulating));
    let mut place = None;
    let same = resealed(&accumulating, |from, section| {
        for (at, byte) in (from..).zip(section) {
            if *byte != replacing[at] {
                assert_eq!((*byte, replacing[at], place), (1, 0, None));
                place = Some(at);
                *byte = 0;
            }
        }
    });
    assert!(same == replacing);
    let place = place.unwrap();
    for code in 0..=255 {
        let other = resealed(&accumulating, |from, section| {
            if (from..from + section.len()).contains(&place) {
                section[place - from] = code;
            }
        });
        let taken = load(&mut *Box::new(bytes::brain()), &other);
        assert_eq!(taken.is_ok(), code < 2, "{code}: {taken:?}");
    }
    let first = fixtures::kept("lamp-v1.image", || panic!("it is there"));
    let mut brain = Box::new(bytes::brain());
    load(&mut *brain, &first).unwrap();
    let second = image(&*brain);
    assert_eq!((second.len(), second[place]), (first.len() + 1, 0));
}

/// Written when version 2 was new, after 700 actions; it is never written again.
#[test]
fn the_image_of_a_brain_whose_habits_last_is_read_for_ever() {
    let golden = fixtures::kept("lamp-lasting-v2.image", || {
        let mut brain = Box::new(floats::brain());
        floats::be_born(&mut brain, AgentConfig::RESILIENT_LASTING, 3).unwrap();
        Lamp::new(9).live(&mut brain, 700);
        image(&*brain)
    });
    let mut brain = Box::new(floats::brain());
    assert_eq!(load(&mut *brain, &golden), Ok(golden.len() as u32));
    assert!(image(&*brain) == golden);
    Lamp::new(21).live(&mut brain, 500);
}

#[test]
fn an_image_that_lies_under_right_checksums_is_refused_or_does_no_harm() {
    let (_, whole) = learned();
    let mut rng = Rng::new(4);
    let mut taken = 0;
    for trial in 0..4000 {
        let image = lying(&whole, &mut rng);
        let mut brain = Box::new(bytes::brain());
        if load(&mut *brain, &image).is_err() {
            continue;
        }
        taken += 1;
        // Numbers may be absurd, and are finite; a life goes on.
        let mut lamp = Lamp::new(trial);
        lamp.live(&mut brain, 60);
        brain.act(Adaptation::Relearning).unwrap();
        lamp.live(&mut brain, 60);
    }
    assert!((400..3600).contains(&taken), "{taken}");
}

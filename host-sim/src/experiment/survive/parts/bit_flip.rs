//! Bits of stored images that are flipped: one, several, or an end that is missing.
//!
//! Every image is offered to a brain that lives another life; it must be refused, and that life must
//! go on as it was.

use std::collections::BTreeSet;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forest::MindConfig;
use cla_core::num::Rng;

use super::super::configurations::VALUE;
use super::super::lamp::{Lamp, SmallMind, bytes, floats, names};
use super::super::part::{Part, Scale, never, tried};
use crate::experiment::measured::{Trial, of};
use crate::failure::Failure;
use crate::learner::native::Native;
use crate::learner::{Learner, live};
use crate::report::Claim;

/// The part.
pub(crate) const PART: Part = Part {
    name: "bit_flip",
    measure,
    claims,
    ..Part::QUICK
};

/// Images with several flipped bits, of each brain with each seed.
const SEVERAL: u32 = 34_000;
/// Actions before a brain is stored.
const LIFE: u32 = 700;
/// Actions of the life into which nothing may come.
const OTHER_LIFE: u32 = 50;

/// What is left of a brain's image is refused, bit by bit.
#[derive(Default)]
struct Counts {
    single: u32,
    several: u32,
    shorter: u32,
    accepted: u32,
    changed: u32,
}

fn measure(scale: Scale, seed: u64, trial: &mut Trial) -> Result<(), Failure> {
    let mut counts = Counts::default();
    for image in 0..3 {
        let (stored, mut living) = match image {
            0 => (of_floats(seed, LIFE)?, of_floats(seed + 1, OTHER_LIFE)?),
            1 => (of_bytes(seed, LIFE)?, of_bytes(seed + 1, OTHER_LIFE)?),
            _ => (of_mind(seed, LIFE)?, of_mind(seed + 1, OTHER_LIFE)?),
        };
        let whole = image_of(&*stored)?;
        damage(scale, seed, &whole, &mut *living, &mut counts)?;
        // What was refused every time is taken when nothing is wrong with it.
        living.go_on_from(names(), &whole)?;
        counts.changed += u32::from(image_of(&*living)? != whole);
        trial.note(format!("bit_flip.bytes.{image}"), whole.len() as u32);
    }
    for (name, number) in [
        ("single", counts.single),
        ("several", counts.several),
        ("shorter", counts.shorter),
        ("accepted", counts.accepted),
        ("changed", counts.changed),
    ] {
        trial.note(format!("bit_flip.{name}"), number);
    }
    Ok(())
}

fn image_of(learner: &dyn Learner) -> Result<Vec<u8>, Failure> {
    Ok(learner.image(names())?.ok_or("a brain has an image")?)
}

macro_rules! of_agent {
    ($name:ident, $robot:ident) => {
        fn $name(seed: u64, actions: u32) -> Result<Box<dyn Learner>, Failure> {
            let mut brain = Box::new($robot::brain());
            $robot::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, seed)?;
            let mut learner = Native::new(brain, Adaptation::Relearning);
            live(&mut learner, &mut Lamp::new(seed), actions)?;
            Ok(Box::new(learner))
        }
    };
}

of_agent!(of_floats, floats);
of_agent!(of_bytes, bytes);

fn of_mind(seed: u64, actions: u32) -> Result<Box<dyn Learner>, Failure> {
    let mut brain = Box::new(SmallMind::new());
    brain.be_born(MindConfig::DEFAULT, [0.0, 0.0, 0.0, VALUE], seed)?;
    live(&mut *brain, &mut Lamp::new(seed), actions)?;
    Ok(brain)
}

/// Offers damaged images of all kinds.
fn damage(
    scale: Scale,
    seed: u64,
    whole: &[u8],
    living: &mut dyn Learner,
    counts: &mut Counts,
) -> Result<(), Failure> {
    let before = image_of(living)?;
    let mut damaged = whole.to_vec();
    let mut accepted = 0;
    let mut offer = |image: &[u8]| accepted += u32::from(living.go_on_from(names(), image).is_ok());
    let bits = whole.len() * 8;
    for bit in (0..bits).step_by(scale.step()) {
        flip(&mut damaged, bit);
        offer(&damaged);
        flip(&mut damaged, bit);
        counts.single += 1;
    }
    let mut rng = Rng::stream(seed, 72);
    for _ in 0..scale.of(SEVERAL) {
        let bits = several(&mut rng, whole.len() as u32);
        bits.iter().for_each(|&bit| flip(&mut damaged, bit));
        offer(&damaged);
        bits.iter().for_each(|&bit| flip(&mut damaged, bit));
        counts.several += 1;
    }
    for length in (0..whole.len()).step_by(scale.step()) {
        offer(&whole[..length]);
        counts.shorter += 1;
    }
    counts.accepted += accepted;
    counts.changed += u32::from(image_of(living)? != before || damaged != whole);
    Ok(())
}

fn flip(image: &mut [u8], bit: usize) {
    if let Some(byte) = image.get_mut(bit / 8) {
        *byte ^= 1 << (bit % 8);
    }
}

/// Two to eight different bits, scattered or all within four bytes, as a failing cell has them.
fn several(rng: &mut Rng, bytes: u32) -> BTreeSet<usize> {
    let flips = 2 + rng.below(7);
    let near = rng.chance(0.5).then(|| rng.below(bytes - 4) * 8);
    let mut bits = BTreeSet::new();
    while bits.len() < flips as usize {
        bits.insert(match near {
            Some(base) => base + rng.below(32),
            None => rng.below(bytes * 8),
        } as usize);
    }
    bits
}

fn claims(trials: &[Trial]) -> Vec<Claim> {
    let of = |name: &str| of(trials, &format!("bit_flip.{name}"));
    vec![
        never(
            "bit_flip",
            "images",
            "images that were accepted: each flipped bit, several flipped bits, each missing end, of \
             two agents and a mind",
            &of("accepted"),
        ),
        never(
            "bit_flip.changed",
            "brains",
            "living brains that were not as before after all images were refused",
            &of("changed"),
        ),
        tried("bit_flip.single", "images", 1_000_000.0, &of("single")),
        tried("bit_flip.several", "images", 1_000_000.0, &of("several")),
        tried("bit_flip.shorter", "images", 100_000.0, &of("shorter")),
    ]
}

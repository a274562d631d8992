//! Any bytes as an image of a life or of knowledge alone, and images that lie under right checksums.

use cla_core::agent::{Agent, AgentConfig, Audit};
use cla_core::forest::{Mind, MindConfig};
use cla_core::reason::Reasoning;
use cla_core::snapshot::{self, Knowing, Names, Snapshot};
use cla_core::som::Prototypes;
use cla_core::word::ItemStates;

use super::agents::Growing;
use super::robots::{Mite, Muse, bytes, floats};

/// Bytes of the header, and of a section's number and length.
const HEADER: usize = 80;
/// The bit of the first byte of an input that says: an image of knowledge alone.
///
/// The three lowest say what is written, the next one which robot takes it.
const ALONE: u8 = 64;

/// The image of a brain.
fn image<B: Snapshot>(brain: &B) -> Vec<u8> {
    let mut image = Vec::new();
    snapshot::save(brain, Names::UNKNOWN, &mut Growing(&mut image)).expect("it was born");
    image
}

/// What must be so of a brain that was taken from an image, whatever its bytes were.
///
/// As it is it lives on with numbers.
/// An audit never gives it up: it leaves a brain that is sound, is itself when it was saved and loaded,
/// lives, and is sound afterwards.
fn harmless<B: Snapshot + Clone>(
    brain: &mut B,
    audit: impl Fn(&mut B) -> Audit,
    live: impl Fn(&mut B),
) {
    live(&mut brain.clone());
    let found = audit(brain);
    assert!(!matches!(found, Audit::Lost(_)), "{found:?}");
    assert_eq!(audit(brain), Audit::Sound);
    let kept = image(brain);
    let again = snapshot::load(brain, Names::UNKNOWN, &mut &*kept);
    assert_eq!(again, Ok(kept.len() as u32));
    assert!(image(brain) == kept, "it is another one");
    live(brain);
    assert_eq!(audit(brain), Audit::Sound);
}

/// A percept that changes from step to step.
fn percept(step: u32) -> ItemStates<1> {
    let mut now = ItemStates::all_off(3);
    for item in 0..3 {
        let on = (step * 5 + step / 3) >> item & 1 == 1;
        now.set(cla_core::word::ItemId(item), Some(on))
            .expect("there are three items");
    }
    now
}

/// The input itself, or the good image with the bytes that the input says, under right checksums.
fn written(good: &[u8], input: &[u8]) -> Vec<u8> {
    let Some((kind, rest)) = input.split_first() else {
        return Vec::new();
    };
    if *kind % 8 == 0 {
        return rest.to_vec();
    }
    let mut image = good.to_vec();
    for change in rest.as_chunks::<3>().0 {
        let place = usize::from(u16::from_le_bytes([change[0], change[1]])) % image.len();
        image[place] = change[2];
    }
    if *kind % 8 > 1 {
        seal(&mut image);
    }
    image
}

/// Whether an input is one of knowledge alone.
fn is_alone(input: &[u8]) -> bool {
    input.first().is_some_and(|kind| kind & ALONE != 0)
}

/// The input as what a brain knows, or with the bytes that it says in that: a newborn one of the same
/// shape takes it, or stays as it was.
fn known<B: Knowing + Clone>(
    brain: &B,
    newborn: &mut B,
    input: &[u8],
    audit: impl Fn(&mut B) -> Audit,
    live: impl Fn(&mut B),
) {
    let mut good = Vec::new();
    snapshot::save_knowledge(brain, Names::UNKNOWN, &mut Growing(&mut good)).expect("it was born");
    let before = image(newborn);
    let other = written(&good, input);
    match snapshot::load_knowledge(newborn, &[], &[], &mut &*other) {
        Ok(_) => harmless(newborn, audit, live),
        Err(refused) => {
            assert!(other != good, "what it knows is refused: {refused}");
            assert!(image(newborn) == before, "it is not as it was");
        }
    }
}

/// Makes the checksums right: of sections as far as lengths can be followed, and of the whole.
fn seal(image: &mut [u8]) {
    let of_sections = crc::Crc::<u32>::new(&crc::CRC_32_ISCSI);
    let end = image.len() - 4;
    let sum = of_sections.checksum(&image[..HEADER - 4]);
    image[HEADER - 4..HEADER].copy_from_slice(&sum.to_le_bytes());
    let mut at = HEADER;
    while at + 6 < end {
        let length = [image[at + 2], image[at + 3], image[at + 4], image[at + 5]];
        let length = u32::from_le_bytes(length) as usize;
        let Some(to) = (at + 6).checked_add(length).filter(|to| to + 4 <= end) else {
            break;
        };
        let sum = of_sections.checksum(&image[at..to]);
        image[to..to + 4].copy_from_slice(&sum.to_le_bytes());
        at = to + 4;
    }
    let sum = crc::Crc::<u32>::new(&crc::CRC_32_ISO_HDLC).checksum(&image[..end]);
    image[end..].copy_from_slice(&sum.to_le_bytes());
}

fn agent_of<
    const W: usize,
    const H: usize,
    const P: usize,
    const S: usize,
    const Y: usize,
    const B: usize,
    M,
>(
    mut brain: Agent<1, 3, W, H, 2, P, S, Y, B, M>,
    input: &[u8],
) where
    M: Prototypes<W, H> + snapshot::Stored + Clone,
{
    let live = |brain: &mut Agent<1, 3, W, H, 2, P, S, Y, B, M>| {
        for step in 0..60 {
            let choice = brain.choose(&percept(step)).expect("it was born");
            assert!(choice.value.is_finite());
            let lesson = brain.learn(&percept(step + 1)).expect("it has chosen");
            assert!(lesson.reward.is_finite());
        }
    };
    let config = AgentConfig {
        harvest_every: 20,
        ..AgentConfig::RESILIENT_LEVEL2
    };
    brain
        .be_born(config, &[(cla_core::word::ItemId(2), 10.0)], 3)
        .expect("it can work");
    let mut newborn = brain.clone();
    live(&mut brain);
    if is_alone(input) {
        known(&brain, &mut newborn, input, Agent::audit, live);
        return;
    }
    let good = image(&brain);
    let other = written(&good, input);
    match snapshot::load(&mut brain, Names::UNKNOWN, &mut &*other) {
        Ok(_) => harmless(&mut brain, Agent::audit, live),
        Err(_) => assert!(image(&brain) == good, "it is not as it was"),
    }
}

/// Images of the book's learner, with maps of floats and of bytes.
pub(super) fn agent(input: &[u8]) {
    match input.first() {
        Some(first) if first / 8 % 2 == 0 => agent_of(floats::brain(), input),
        _ => agent_of(bytes::brain(), input),
    }
}

fn mind_of<R: Reasoning<1, 3, 2> + snapshot::Stored + Clone>(
    mut mind: Mind<1, 3, 2, 4, 4, 4, 6, 8, R>,
    input: &[u8],
) {
    let live = |mind: &mut Mind<1, 3, 2, 4, 4, 4, 6, 8, R>| {
        for step in 0..60 {
            let choice = mind.choose(&percept(step)).expect("it was born");
            assert!(choice.value.is_finite());
            let taught = mind.learn(&percept(step + 1)).expect("it has chosen");
            assert!(taught.reward.is_finite());
        }
    };
    mind.be_born(MindConfig::DEFAULT, [0.0, -1.0, 5.0], 3)
        .expect("it can work");
    let mut newborn = mind.clone();
    live(&mut mind);
    if is_alone(input) {
        known(&mind, &mut newborn, input, Mind::audit, live);
        return;
    }
    let good = image(&mind);
    let other = written(&good, input);
    match snapshot::load(&mut mind, Names::UNKNOWN, &mut &*other) {
        Ok(_) => harmless(&mut mind, Mind::audit, live),
        Err(_) => assert!(image(&mind) == good, "it is not as it was"),
    }
}

/// Images of the one learner, without a reason and with one.
pub(super) fn mind(input: &[u8]) {
    match input.first() {
        Some(first) if first / 8 % 2 == 1 => mind_of(Muse::unborn(), input),
        _ => mind_of(Mite::new(), input),
    }
}

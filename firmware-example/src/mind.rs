//! The learner for any world, along the recording: it chooses at every percept and learns that what
//! was recorded came of it.
//!
//! The recording does not listen, so nothing can be learned about the world from what is chosen; but a
//! tick does everything that a tick of a life does, and host and board can be compared to the bit
//! without a world on the board.

use cla_core::forest::{Mind, MindConfig, MindError};

use crate::fingerprint::Fingerprint;
use crate::trace;

/// The forager's learner: 7168 samples, 200 leaves, 512 rows, 512 states and 2048 links.
pub type Forager = Mind<1, 7, 6, 448, 200, 512, 512, 2048>;

/// The same for parts with 128 KiB of RAM: 1024 samples, and as many states.
pub type Small = Mind<1, 7, 6, 64, 28, 512, 512, 2048>;

/// What a specimen is worth: item 5 is `ingrip`.
pub const VALUES: [f32; 7] = [0.0, 0.0, 0.0, 0.0, 0.0, 10.0, 0.0];

/// Relives the first `actions` recorded actions; `tick` is called after a choice and after what was
/// learned from it. Answers a number that stands for every choice and value.
///
/// # Errors
/// [`MindError`] when the mind refuses.
pub fn relive(
    mind: &mut Forager,
    actions: u32,
    mut tick: impl FnMut(Part),
) -> Result<Fingerprint, MindError> {
    let mut print = Fingerprint::new();
    mind.be_born(MindConfig::DEFAULT, VALUES, trace::SEED)?;
    for step in trace::steps(actions) {
        if !step.reflex {
            tick(Part::Sensed);
            let choice = mind.choose(&step.before)?;
            tick(Part::Chosen);
            print.number(u32::from(choice.action.0));
            print.float(choice.value);
        }
        tick(Part::Sensed);
        if step.reflex {
            mind.observe(&step.before, step.action, &step.after)?;
        } else {
            mind.learn(&step.after)?;
        }
        tick(Part::Learned);
    }
    Ok(print)
}

/// Lives the recorded actions from one to another, whatever was lived before; answers a number that stands
/// for every choice and every lesson.
///
/// # Errors
/// [`MindError`] when the mind refuses.
pub fn live(mind: &mut Small, from: u32, to: u32) -> Result<Fingerprint, MindError> {
    let mut print = Fingerprint::new();
    let mut begun = 0;
    for step in trace::steps(to) {
        begun += u32::from(!step.reflex);
        // The reflexes of the last action before belong to it.
        if begun <= from {
            continue;
        }
        if step.reflex {
            mind.observe(&step.before, step.action, &step.after)?;
            continue;
        }
        let choice = mind.choose(&step.before)?;
        print.number(u32::from(choice.action.0));
        print.float(choice.value);
        let taught = mind.learn(&step.after)?;
        print.float(taught.reward);
        print.number(u32::from(taught.refocused));
    }
    Ok(print)
}

/// Where a tick is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Nothing of the mind's has happened.
    Sensed,
    /// An action was chosen.
    Chosen,
    /// What it led to was learned, and work was done.
    Learned,
}

//! The training of one brain, in a world or by a log, and the size of one that there is not yet.

use cla_core::agent::{Adaptation, AgentConfig};

use super::shared::world;
use crate::cli::{SizeArgs, TeachArgs, TrainArgs};
use crate::device::budget::number;
use crate::failure::Impossible;
use crate::keeping::{Raised, Training, Wanted};
use crate::logs::check_name;
use crate::teaching::Teaching;
use crate::world::setting::MOST_ACTIONS;

/// The size that the arguments ask for.
///
/// # Errors
/// [`Impossible`] for a memory that is no number of bytes.
pub fn sizing(args: &SizeArgs) -> Result<Wanted, Impossible> {
    let SizeArgs {
        items,
        actions,
        samples,
        states,
        ram,
        log,
    } = args;
    let bytes = |text: &String| {
        let sentence =
            format!("--ram is a number of bytes such as 100000, 100k or 128KiB, not {text:?}");
        number(text).ok_or_else(|| Impossible::new(sentence))
    };
    Ok(Wanted {
        items: *items,
        actions: *actions,
        samples: *samples,
        states: *states,
        ram: ram.as_ref().map(bytes).transpose()?,
        log: log.clone(),
    })
}

/// The training of one brain that the arguments ask for.
///
/// # Errors
/// [`Impossible`] for the first thing that cannot be.
pub fn training(args: &TrainArgs) -> Result<Training, Impossible> {
    let TrainArgs {
        seed,
        world: place,
        brain,
        actions,
        act,
        load,
        save,
        log,
    } = args;
    if *actions > MOST_ACTIONS {
        let sentence = format!("--actions must be at most {MOST_ACTIONS}, not {actions}");
        return Err(Impossible::new(sentence));
    }
    for path in log {
        check_name(path)?;
    }
    let no = |option: &str, names: &str, it: &str| {
        Impossible::new(format!("{option} is {names}, not {it:?}"))
    };
    if brain == "mind" && load.is_none() && act.as_deref().is_some_and(|it| it != "relearning") {
        let sentence = "--act: a mind adapts in its own way, which is relearning";
        return Err(Impossible::new(sentence));
    }
    Ok(Training {
        seed: *seed,
        world: world(place)?,
        brain: match brain.as_str() {
            "book" => Raised::Agent(AgentConfig::BOOK),
            "forager" => Raised::Agent(AgentConfig::FORAGER),
            "forager-level2" => Raised::Agent(AgentConfig::FORAGER_LEVEL2),
            "resilient" => Raised::Agent(AgentConfig::RESILIENT),
            "resilient-level2" => Raised::Agent(AgentConfig::RESILIENT_LEVEL2),
            "forager-lasting" => Raised::Agent(AgentConfig::FORAGER_LASTING),
            "resilient-lasting" => Raised::Agent(AgentConfig::RESILIENT_LASTING),
            "mind" => Raised::Mind,
            other => {
                let names = "book, forager, forager-level2, resilient, resilient-level2, \
                             forager-lasting, resilient-lasting or mind";
                return Err(no("--brain", names, other));
            }
        },
        actions: *actions,
        act: match act.as_deref() {
            None => None,
            Some("frozen") => Some(Adaptation::Frozen),
            Some("reliabilities") => Some(Adaptation::Reliabilities),
            Some("relearning") => Some(Adaptation::Relearning),
            Some(other) => return Err(no("--act", "frozen, reliabilities or relearning", other)),
        },
        load: load.clone(),
        save: save.clone(),
        log: log.clone(),
    })
}

/// The teaching by a log that the arguments ask for.
///
/// # Errors
/// [`Impossible`] for a share that leaves nothing to teach or to hold out.
pub fn teaching(args: &TeachArgs) -> Result<Teaching, Impossible> {
    let TeachArgs {
        log,
        mapping,
        taught,
        seed,
        save,
        page,
    } = args;
    if !(*taught > 0.0 && *taught < 1.0) {
        let sentence = format!("--taught is a share above 0 and below 1, not {taught}");
        return Err(Impossible::new(sentence));
    }
    Ok(Teaching {
        log: log.clone(),
        mapping: mapping.clone(),
        taught: *taught,
        seed: *seed,
        save: save.clone(),
        page: page.clone(),
    })
}

//! What the Microworld experiment varies, and the goal that is pursued in its place.

use cla_core::word::ItemId;
use serde::Serialize;

use crate::failure::Impossible;
use crate::world::microworld::{Body, ITEMS, Oracle, VOCABULARY, item};

/// The experiment's seeds.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct MicroworldOptions {
    /// Which lives.
    pub seeds: Vec<u64>,
}

/// One brain and its goal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PursuitOptions {
    /// Which life.
    pub seed: u64,
    /// The name of the item that the goal turns on.
    pub goal: String,
}

impl PursuitOptions {
    /// A goal such as `+taste1`, which turns on an item that comes and goes.
    ///
    /// # Errors
    /// [`Impossible`] for anything else.
    pub fn new(seed: u64, text: &str) -> Result<Self, Impossible> {
        let named = text.strip_prefix('+').and_then(item).ok_or_else(|| {
            Impossible::new(format!(
                "--goal takes + and an item (such as +hp22, +vp33, +vf12, +tactl, +hgr or +taste1), \
                 not {text:?}"
            ))
        })?;
        let oracle = Oracle::new(Body::Visible);
        let on = |state: &usize| oracle.items(*state).contains(named);
        match (0..oracle.states().len()).filter(on).count() {
            0 => Err(Impossible::new(format!(
                "--goal {text}: nothing in the Microworld turns this item on"
            ))),
            all if all == oracle.states().len() => Err(Impossible::new(format!(
                "--goal {text}: this item is always on"
            ))),
            _ => Ok(Self {
                seed,
                goal: VOCABULARY.item_name(named).to_owned(),
            }),
        }
    }

    /// The item.
    pub(super) fn item(&self) -> Result<ItemId, Impossible> {
        item(&self.goal).ok_or_else(|| {
            Impossible::new(format!(
                "{:?} is none of the Microworld's {} items",
                self.goal,
                ITEMS.len()
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::PursuitOptions;

    #[test]
    fn a_goal_is_an_item_that_comes_and_goes() {
        let goal = |text| PursuitOptions::new(100, text);
        assert!(goal("+hp22").is_ok() && goal("+taste1").is_ok());
        for wrong in ["", "+", "hp22", "-hp22", "+nothing", "+fovx0", "+hp22+vp22"] {
            let sentence = goal(wrong).unwrap_err().to_string();
            assert!(!sentence.contains('\n'), "{wrong}: {sentence}");
            assert!(sentence.starts_with("--goal"), "{wrong}: {sentence}");
        }
    }
}

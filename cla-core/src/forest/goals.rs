//! What reason adds to a mind: plans as a voice, goals at run time, and why an action was chosen.

use super::config::Voice;
use super::mind::Mind;
use super::moment::{Feature, Moment};
use super::step::{Actions, Deliberation, MindError, Motive};
use crate::reason::{Prospects, Pursuit, Reasoning, Way};
use crate::word::{ActionId, ItemStates, SchemaText, SignedItems};

/// What nearer values than this differ by is nothing.
const SAME: f32 = 1.0e-6;

/// The share of foreseen states that must have come, lately, for plans to be followed whoever leads.
const RELIABLE: f32 = 0.8;

/// Why an action was chosen: who decided, what it was held to be worth, and a schema.
///
/// ```
/// use cla_core::forest::{Mind, MindConfig};
/// use cla_core::word::{ItemStates, Detail, Vocabulary};
/// let words = Vocabulary { items: &["light", "lamp"], actions: &["stay", "go", "turn"] };
/// let mut mind = Mind::<1, 2, 3, 16, 32, 32, 64, 256>::new();
/// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 7)?;
/// assert_eq!(mind.explain(), None);
/// let choice = mind.choose(&ItemStates::all_off(2))?;
/// let why = mind.explain().unwrap();
/// assert_eq!((why.schema.action, why.motive), (choice.action, choice.motive));
/// // Nothing is known yet: no context, no result.
/// assert!(format!("{}", why.schema.display(&words, Detail::Full)).starts_with('/'));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Explanation<const WORDS: usize> {
    /// The context that counted, the action, and what is foreseen of it; the result stays empty where
    /// nothing is foreseen.
    pub schema: SchemaText<WORDS>,
    /// What the action was held to be worth, in discounted rewards.
    pub value: f32,
    /// Who decided.
    pub motive: Motive,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS>,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// Pursues a goal for at most `limit` actions from now on; it replaces the last goal.
    ///
    /// While a way is known its steps are chosen before everything else, without exploring; while none
    /// is known it lives by its habits and thinks ([`idle`](Mind::idle) lets it think more), and when all
    /// is thought through it tries anything.
    ///
    /// # Errors
    /// [`MindError::Unborn`], or [`MindError::NoReason`] when it has none.
    pub fn pursue(
        &mut self,
        goal: SignedItems<WORDS>,
        limit: u16,
        now: &ItemStates<WORDS>,
    ) -> Result<Pursuit, MindError> {
        self.born()?;
        if !R::THERE {
            return Err(MindError::NoReason);
        }
        self.reason.pursue(goal, limit, now);
        Ok(self.reason.pursuit())
    }

    /// Pursues nothing any more.
    pub fn give_up(&mut self) {
        self.reason.give_up();
    }

    /// How the pursuit of the last goal stands.
    #[must_use]
    pub fn pursuit(&self) -> Pursuit {
        self.reason.pursuit()
    }

    /// How far the goal is from here.
    #[must_use]
    pub fn way(&self, now: &ItemStates<WORDS>) -> Way {
        self.reason.prospects(now).way
    }

    /// Its reason.
    #[must_use]
    pub const fn reason(&self) -> &R {
        &self.reason
    }

    /// Why the last action was chosen; `None` before any, and once what came of it was learned.
    ///
    /// What reason foresees of it is told as one schema; where it foresees nothing, the context is
    /// that of the newest tree's leaf.
    #[must_use]
    pub fn explain(&self) -> Option<Explanation<WORDS>> {
        let said = self.said.get()?;
        let mut schema = self.reason.explain(&self.now, said.action);
        if schema.result.is_empty() {
            schema.context = self.context_of(said.action);
        }
        Some(Explanation {
            schema,
            value: said.value,
            motive: said.motive,
        })
    }

    /// What the newest tree asked of the items now, on the way to the leaf that speaks of an action.
    fn context_of(&self, action: ActionId) -> SignedItems<WORDS> {
        let moment: Moment<WORDS> = self.moment(&self.now);
        let mut context = SignedItems::EMPTY;
        self.forest.visit(action.0 as u8, &mut |path, _| {
            let holds = |&(feature, yes): &(u8, bool)| moment.holds::<ITEMS>(feature) == Some(yes);
            if path.iter().all(holds) {
                for &(feature, yes) in path {
                    if let Feature::Now(item) = Feature::of::<ITEMS>(feature) {
                        let _ = context.insert(item, yes);
                    }
                }
            }
        });
        context
    }

    /// Whether it pursues a goal and, all thought through, no step is known that leads nearer and is
    /// allowed, for which it was asked before: it tries anything.
    pub(super) fn is_lost(&self) -> bool {
        self.reason.pursuit().is_underway() && self.reason.is_settled()
    }

    /// The next step to the goal that is pursued: the first allowed one of those that lead nearest.
    ///
    /// No other step will do: one that leads away, or nowhere, would be undone by the next.
    pub(super) fn step(
        &self,
        prospects: &Prospects<ACTIONS>,
        allowed: Actions,
    ) -> Option<Deliberation> {
        let nearest = prospects.way;
        let mut steps = (0..).zip(prospects.ways.iter().zip(prospects.values));
        let (action, (_, value)) = steps.find(|&(action, (&way, _))| {
            way != Way::Unknown && way == nearest && allowed.contains(ActionId(action))
        })?;
        Some(Deliberation {
            action: ActionId(action),
            value: value.unwrap_or(0.0),
            motive: Motive::Goal,
        })
    }

    /// Whether plans are to be followed whoever leads: what was promised came, and something worth
    /// having is in sight of what is allowed.
    pub(super) fn trusts(&self, prospects: &Prospects<ACTIONS>, allowed: Actions) -> bool {
        let promises = |(action, value): (u16, Option<f32>)| {
            allowed.contains(ActionId(action)) && value.is_some_and(|value| value > 0.0)
        };
        R::THERE
            && self.config.heard.contains(Voice::Plans)
            && self.reason.reliability() >= RELIABLE
            && Self::planned(prospects, allowed).is_some()
            && (0..).zip(prospects.values).any(promises)
    }

    /// What reason holds each action to be worth; `None` where it prefers none of those that are
    /// allowed.
    pub(super) fn planned(
        prospects: &Prospects<ACTIONS>,
        allowed: Actions,
    ) -> Option<[f32; ACTIONS]> {
        let values = prospects.values.map(|value| value.unwrap_or(0.0));
        let (mut least, mut most) = (f32::MAX, f32::MIN);
        for (action, value) in (0..).zip(values) {
            if allowed.contains(ActionId(action)) {
                least = least.min(value);
                most = most.max(value);
            }
        }
        (most > least + SAME).then_some(values)
    }
}

#[cfg(test)]
#[path = "goals_tests.rs"]
mod tests;

//! What experience says of the predictions: every applicable schema counted right or wrong (6.2.4).

use super::applicable::Others;
use super::schema::{PatternId, Schema, SchemaId};
use super::tables::KnowledgeBase;
use crate::word::{ActionId, ItemStates};

/// What experience said about the predictions for one completed action.
///
/// ```
/// assert!(!cla_core::knowledge::Outcome::default().foreseen());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outcome {
    /// Schemas that were applicable and whose result could be checked.
    pub activated: u16,
    /// Those whose result came.
    pub succeeded: u16,
    /// The one of those that says most, by the number of its items; of equals the first.
    pub schema: Option<SchemaId>,
}

impl Outcome {
    /// Whether some schema had foreseen the result.
    #[must_use]
    pub const fn foreseen(&self) -> bool {
        self.succeeded > 0
    }
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    /// Corrects the reliability of every applicable schema of an action that was completed.
    ///
    /// A schema whose result hangs on an unknown item is not counted.
    /// `forgetting`, in `[0, 1]`, is that of [`Reliability::record`](super::Reliability::record): a number
    /// out of its range counts as the nearest in it, NaN as 0.
    pub fn record(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        forgetting: f32,
    ) -> Outcome {
        self.check(before, action, after, |schema, success| {
            schema.reliability.record(success, forgetting);
        })
    }

    /// As [`record`](Self::record), but nothing is learned: which schemas the action has proved
    /// right.
    pub fn explain(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Outcome {
        self.check(before, action, after, |_, _| {})
    }

    #[inline(never)]
    fn check(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        mut found: impl FnMut(&mut Schema, bool),
    ) -> Outcome {
        let mut outcome = Outcome::default();
        let mut most = 0;
        let mut others = Others::none();
        let mut applicable = self.applicable(before, &mut others);
        while let Some(index) = applicable.next(self) {
            let Some(schema) = self.schemas.get_mut(index) else {
                continue;
            };
            if schema.action != action {
                continue;
            }
            let held = |id: PatternId| self.patterns.get(usize::from(id.0));
            let (Some(context), Some(result)) = (held(schema.context), held(schema.result)) else {
                continue;
            };
            let Some(success) = result.items.truth(after) else {
                continue;
            };
            found(schema, success);
            outcome.activated = outcome.activated.saturating_add(1);
            outcome.succeeded = outcome.succeeded.saturating_add(u16::from(success));
            if !success {
                continue;
            }
            let says = context.items.len() + result.items.len();
            if outcome.schema.is_none() || says > most {
                most = says;
                outcome.schema = Some(SchemaId(index as u16));
            }
        }
        self.count_schemas(applicable.seen());
        outcome
    }
}

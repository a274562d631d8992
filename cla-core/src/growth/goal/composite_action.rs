//! Composite actions: reaching a goal by chaining schemas (book, 5.1.1, 5.4.3: `<+hp22>`).
//!
//! A composite action counts as one action: its context is what was on at its start, its result what
//! is on when the goal is reached; it fails when no schema applies or after too many steps.
//! Here are the goal, the course of one attempt and the book's way of choosing steps, backward
//! chaining over reliable schemas; `planner` looks ahead instead.

use crate::growth::evidence::Transition;
use crate::growth::simple_schema::SimpleSchema;
use crate::word::{ActionId, ItemId, ItemSet, SignedItems};

/// A level that no chain has.
const NEVER: u8 = u8::MAX;

/// What one attempt to reach a goal has come to.
///
/// In the field: the execution of an option (Sutton, Precup and Singh 1999).
///
/// ```
/// use cla_core::growth::{Attempt, Progress};
/// use cla_core::word::{ItemId, ItemSet, SignedItems};
/// let mut goal = SignedItems::<1>::EMPTY;
/// goal.insert(ItemId(0), true)?;
/// let mut attempt = Attempt::begin(goal, ItemSet::EMPTY, 2);
/// assert_eq!(attempt.progress(&ItemSet::EMPTY), Progress::Underway);
/// attempt.count_step();
/// let Progress::Reached(sample) = attempt.progress(&ItemSet::first(1)) else { panic!() };
/// assert_eq!(sample.before, ItemSet::EMPTY); // one sample for the whole way
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attempt<const WORDS: usize> {
    goal: SignedItems<WORDS>,
    start: ItemSet<WORDS>,
    steps_left: u16,
}

/// Where an [`Attempt`] stands.
///
/// ```
/// assert_ne!(cla_core::growth::Progress::<1>::Underway, cla_core::growth::Progress::TimedOut);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress<const WORDS: usize> {
    /// The goal holds: the sample that the composite action's own map is trained on.
    Reached(Transition<WORDS>),
    /// Not yet.
    Underway,
    /// The step limit is used up; nothing is to be learned of the composite action.
    TimedOut,
}

impl<const WORDS: usize> Attempt<WORDS> {
    /// Begins an attempt of at most `step_limit` primitive actions.
    #[must_use]
    pub const fn begin(goal: SignedItems<WORDS>, on: ItemSet<WORDS>, step_limit: u16) -> Self {
        Self {
            goal,
            start: on,
            steps_left: step_limit,
        }
    }

    /// The goal.
    #[must_use]
    pub const fn goal(&self) -> &SignedItems<WORDS> {
        &self.goal
    }

    /// A primitive action was done.
    pub const fn count_step(&mut self) {
        self.steps_left = self.steps_left.saturating_sub(1);
    }

    /// Where it stands when exactly these items are on.
    #[must_use]
    pub fn progress(&self, on: &ItemSet<WORDS>) -> Progress<WORDS> {
        if holds(&self.goal, on) {
            Progress::Reached(Transition {
                before: self.start,
                after: *on,
            })
        } else if self.steps_left == 0 {
            Progress::TimedOut
        } else {
            Progress::Underway
        }
    }
}

/// Whether a conjunction holds when exactly these items are on.
pub(crate) fn holds<const WORDS: usize>(items: &SignedItems<WORDS>, on: &ItemSet<WORDS>) -> bool {
    items.positive().is_subset(on) && items.negative().is_disjoint(on)
}

/// The book's step towards a goal: the action of an applicable reliable schema that is nearest to
/// the goal in the backward chain; `None` when none is in it.
///
/// The chain judges schemas one by one: it is enough that one context item of the next schema comes
/// true, so a goal that needs two things at once (taste: the ball *and* the mouth) leads it astray.
///
/// ```
/// use cla_core::growth::{SimpleSchema, chain_backward};
/// use cla_core::word::{ItemSet, SchemaText, SignedItems, Vocabulary};
/// let words = Vocabulary { items: &["a", "b", "c"], actions: &["walk", "leap"] };
/// let schemas = ["+a/walk/+b", "+b/leap/+c"]
///     .map(|text| SimpleSchema::pack(&SchemaText::<1>::parse(text, &words).unwrap()).unwrap());
/// let mut goal = SignedItems::<1>::EMPTY;
/// goal.insert(words.item("c").unwrap(), true)?;
/// let next = chain_backward(&goal, &ItemSet::first(1), &schemas, 0.9);
/// assert_eq!(next, words.action("walk"));
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[must_use]
pub fn chain_backward<const WORDS: usize>(
    goal: &SignedItems<WORDS>,
    on: &ItemSet<WORDS>,
    schemas: &[SimpleSchema],
    reliable: f32,
) -> Option<ActionId> {
    let mut levels = Levels::<WORDS>::of(goal);
    while levels.chain(schemas, reliable) {}
    let useful = schemas.iter().filter(|schema| {
        schema.reliability() >= reliable && schema.applies(on) && !schema.succeeds(on)
    });
    let mut best = (NEVER, None);
    for schema in useful {
        let level = levels.get(schema.result_item(), schema.result_sign());
        if level < best.0 {
            best = (level, Some(schema.action()));
        }
    }
    best.1
}

/// For every signed item, how many schemas lie between it and the goal.
struct Levels<const WORDS: usize> {
    off: [[u8; 32]; WORDS],
    on: [[u8; 32]; WORDS],
}

impl<const WORDS: usize> Levels<WORDS> {
    fn of(goal: &SignedItems<WORDS>) -> Self {
        let mut levels = Self {
            off: [[NEVER; 32]; WORDS],
            on: [[NEVER; 32]; WORDS],
        };
        for item in goal.positive().iter() {
            levels.lower(item, true, 0);
        }
        for item in goal.negative().iter() {
            levels.lower(item, false, 0);
        }
        levels
    }

    fn get(&self, item: ItemId, sign: bool) -> u8 {
        let side = if sign { &self.on } else { &self.off };
        let level = side.as_flattened().get(usize::from(item.0));
        level.copied().unwrap_or(NEVER)
    }

    fn lower(&mut self, item: ItemId, sign: bool, level: u8) -> bool {
        let side = if sign { &mut self.on } else { &mut self.off };
        match side.as_flattened_mut().get_mut(usize::from(item.0)) {
            Some(old) if level < *old => {
                *old = level;
                true
            }
            _ => false,
        }
    }

    /// One sweep: the contexts of schemas whose results are in the chain join it. Whether any did;
    /// every sweep lowers a level of a finite number, so sweeping ends.
    fn chain(&mut self, schemas: &[SimpleSchema], reliable: f32) -> bool {
        let mut changed = false;
        for schema in schemas.iter().filter(|it| it.reliability() >= reliable) {
            let level = self.get(schema.result_item(), schema.result_sign());
            if level >= NEVER - 1 {
                continue;
            }
            for (item, sign) in schema.context() {
                changed |= self.lower(item, sign, level + 1);
            }
        }
        changed
    }
}

#[cfg(test)]
mod tests {
    use super::{Attempt, Progress, chain_backward};
    use crate::growth::SimpleSchema;
    use crate::word::{ItemId, ItemSet, SchemaText, SignedItems, Vocabulary};

    const WORDS: Vocabulary = Vocabulary {
        items: &["a", "b", "c", "d"],
        actions: &["x", "y", "z"],
    };

    fn goal(item: u16) -> SignedItems<1> {
        let mut goal = SignedItems::EMPTY;
        goal.insert(ItemId(item), true).unwrap();
        goal
    }

    #[test]
    fn an_attempt_ends_at_its_step_limit() {
        let mut attempt = Attempt::begin(goal(3), ItemSet::EMPTY, 1);
        attempt.count_step();
        assert_eq!(attempt.progress(&ItemSet::first(2)), Progress::TimedOut);
    }

    #[test]
    fn the_chain_takes_the_shorter_way_and_none_where_there_is_no_way() {
        let pack =
            |text| SimpleSchema::pack(&SchemaText::<1>::parse(text, &WORDS).unwrap()).unwrap();
        let schemas = ["+a/x/+b", "+b/x/+c", "+c/x/+d", "+a/y/+c", "/z/-a"].map(pack);
        let here = ItemSet::first(1);
        assert_eq!(
            chain_backward(&goal(3), &here, &schemas, 0.9),
            WORDS.action("y")
        );
        assert_eq!(
            chain_backward(&goal(3), &ItemSet::EMPTY, &schemas, 0.9),
            None
        );
    }
}

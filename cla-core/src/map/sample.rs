//! One completed action as a stimulus: the items before it, the items after it (book, 5.3.1).

use crate::snapshot::stored_codes;
use crate::som::SparseStimulus;
use crate::word::{ItemSet, ItemStates, SignedItems};

/// How the result half of a stimulus is written (book, 5.3.1 and 6.2.2).
///
/// ```
/// use cla_core::map::{ResultCoding, Sample};
/// use cla_core::word::{ItemId, ItemStates};
/// let mut before = ItemStates::<1>::all_off(2);
/// before.set(ItemId(0), Some(true))?;
/// let mut after = before;
/// after.set(ItemId(1), Some(true))?;
/// let end = Sample::new(&before, &after, ResultCoding::EndState, 2);
/// assert_eq!(end.result().on().collect::<Vec<_>>(), [0, 1]);
/// let change = Sample::new(&before, &after, ResultCoding::Change, 2);
/// assert_eq!(change.result().on().collect::<Vec<_>>(), [1]);
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum ResultCoding {
    /// −1 turned off, 0 unchanged, +1 turned on: where every action moves something (5.3.1).
    Change,
    /// 1 on, 0 off: where an action may leave the coarse sensors as they were (6.2.2).
    EndState,
}

/// The stimulus that one completed action gives its map.
///
/// See [`ResultCoding`] for an example.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sample<const WORDS: usize> {
    context_on: ItemSet<WORDS>,
    context_unknown: ItemSet<WORDS>,
    result_on: ItemSet<WORDS>,
    result_minus: ItemSet<WORDS>,
    result_unknown: ItemSet<WORDS>,
}

impl<const WORDS: usize> Sample<WORDS> {
    /// The stimulus for items `0..items` that were `before` and are `after`.
    ///
    /// In change coding an item counts as unknown unless it is known before and after.
    #[must_use]
    pub fn new(
        before: &ItemStates<WORDS>,
        after: &ItemStates<WORDS>,
        coding: ResultCoding,
        items: u16,
    ) -> Self {
        let all = ItemSet::first(items);
        let known = match coding {
            ResultCoding::EndState => after.known(),
            ResultCoding::Change => after.known().intersection(&before.known()),
        };
        let (result_on, result_minus) = match coding {
            ResultCoding::EndState => (*after.on(), ItemSet::EMPTY),
            ResultCoding::Change => (
                after.on().intersection(before.off()),
                after.off().intersection(before.on()),
            ),
        };
        Self {
            context_on: *before.on(),
            context_unknown: all.difference(&before.known()),
            result_on,
            result_minus,
            result_unknown: all.difference(&known),
        }
    }

    /// The stimulus that says what a schema says, and nothing of other items.
    pub(crate) fn of_schema(
        context: &SignedItems<WORDS>,
        result: &SignedItems<WORDS>,
        coding: ResultCoding,
        items: u16,
    ) -> Self {
        let all = ItemSet::first(items);
        let named = |it: &SignedItems<WORDS>| it.positive().union(it.negative());
        let result_minus = match coding {
            ResultCoding::EndState => ItemSet::EMPTY,
            ResultCoding::Change => *result.negative(),
        };
        Self {
            context_on: *context.positive(),
            context_unknown: all.difference(&named(context)),
            result_on: *result.positive(),
            result_minus,
            result_unknown: all.difference(&named(result)),
        }
    }

    /// The first half of the stimulus.
    #[must_use]
    pub const fn context(&self) -> SparseStimulus<'_> {
        SparseStimulus {
            on: self.context_on.words(),
            minus: &[],
            unknown: self.context_unknown.words(),
        }
    }

    /// The second half of the stimulus.
    #[must_use]
    pub const fn result(&self) -> SparseStimulus<'_> {
        SparseStimulus {
            on: self.result_on.words(),
            minus: self.result_minus.words(),
            unknown: self.result_unknown.words(),
        }
    }
}

stored_codes!(ResultCoding {
    0: (Self::Change),
    1: (Self::EndState)
});

//! One completed action as it was perceived, unknown items included.

use crate::growth::Evidence;
use crate::snapshot::stored;
use crate::word::{ItemId, ItemSet, ItemStates};

/// What was perceived before an action and after it; what was unknown says nothing.
///
/// ```
/// use cla_core::growth::Evidence;
/// use cla_core::reason::Experience;
/// use cla_core::word::{ItemId, ItemStates};
/// let before = ItemStates::<1>::all_off(3);
/// let mut after = before;
/// after.set(ItemId(0), Some(true))?;
/// after.set(ItemId(1), None)?;
/// let it = Experience { before, after };
/// assert_eq!(it.telling().iter().map(|item| item.0).collect::<Vec<_>>(), [0]);
/// assert_eq!(it.outcome(ItemId(1)), None);
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Experience<const WORDS: usize> {
    /// What was perceived before the action.
    pub before: ItemStates<WORDS>,
    /// What was perceived after it.
    pub after: ItemStates<WORDS>,
}

impl<const WORDS: usize> Experience<WORDS> {
    /// Nothing is known.
    pub(super) const UNKNOWN: Self = Self {
        before: ItemStates::UNKNOWN,
        after: ItemStates::UNKNOWN,
    };

    /// Whether the other led elsewhere: at least half of the items that either changed are known to
    /// have ended otherwise.
    pub(super) fn differs(&self, other: &Self) -> bool {
        let on = self.after.on().intersection(other.after.off());
        let otherwise = on.union(&self.after.off().intersection(other.after.on()));
        let changed = self.telling().union(&other.telling());
        !otherwise.is_empty() && 2 * otherwise.len() >= changed.len()
    }
}

impl<const WORDS: usize> Evidence<WORDS> for Experience<WORDS> {
    const CHANGES: bool = true;

    fn on_before(&self) -> ItemSet<WORDS> {
        *self.before.on()
    }

    fn off_before(&self) -> ItemSet<WORDS> {
        *self.before.off()
    }

    fn outcome(&self, item: ItemId) -> Option<bool> {
        self.after.get(item)
    }

    fn telling(&self) -> ItemSet<WORDS> {
        let began = self.before.off().intersection(self.after.on());
        began.union(&self.before.on().intersection(self.after.off()))
    }

    /// The newer outcome, and of items that are unknown there the older one.
    fn renewed(&self, newer: &Self) -> Self {
        let known = newer.after.known();
        let on = self.after.on().difference(&known).union(newer.after.on());
        let off = self.after.off().difference(&known).union(newer.after.off());
        Self {
            before: newer.before,
            after: ItemStates::from_sets(&on, &off),
        }
    }
}

stored! { impl[const WORDS: usize] Experience<WORDS> { before, after } }

//! Actions, and the names of items and actions (book, 5.1.1).

use super::item::ItemId;
use crate::snapshot::{Names, stored_as};

/// The index of an action: primitive actions first, composite actions after them.
///
/// ```
/// use cla_core::word::ActionId;
/// assert!(ActionId(0) < ActionId(1));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ActionId(pub u16);

/// The names of a robot's primitive items and actions, in the order of their ids.
///
/// ```
/// use cla_core::word::{ActionId, ItemId, Vocabulary};
/// let words = Vocabulary { items: &["s3", "ingrip"], actions: &["forward"] };
/// assert_eq!(words.item("ingrip"), Some(ItemId(1)));
/// assert_eq!(words.action("forward"), Some(ActionId(0)));
/// assert_eq!(words.action("fly"), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vocabulary {
    /// Names of the items; at most 65,535.
    pub items: &'static [&'static str],
    /// Names of the actions; at most 65,535.
    pub actions: &'static [&'static str],
}

impl Vocabulary {
    /// The item of that name.
    #[must_use]
    pub fn item(&self, name: &str) -> Option<ItemId> {
        self.items
            .iter()
            .position(|&other| other == name)
            .map(|index| ItemId(index as u16))
    }

    /// The action of that name.
    #[must_use]
    pub fn action(&self, name: &str) -> Option<ActionId> {
        self.actions
            .iter()
            .position(|&other| other == name)
            .map(|index| ActionId(index as u16))
    }

    /// The names as checksums, for an image of a brain.
    #[must_use]
    pub fn names(&self) -> Names {
        Names::of(self.items, self.actions)
    }

    /// The name of an item; `?` when it has none.
    #[must_use]
    pub fn item_name(&self, item: ItemId) -> &'static str {
        self.items.get(usize::from(item.0)).copied().unwrap_or("?")
    }

    /// The name of an action; `?` when it has none.
    #[must_use]
    pub fn action_name(&self, action: ActionId) -> &'static str {
        self.actions
            .get(usize::from(action.0))
            .copied()
            .unwrap_or("?")
    }
}

stored_as!(impl[] ActionId, below actions);

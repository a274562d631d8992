//! What every module that [`brain!`](crate::brain!) makes has: the robot's names, its bytes, its safe
//! action.

#[doc(hidden)]
#[macro_export]
macro_rules! brain_words {
    // Names and their ids, for every kind of brain.
    (@words [$($item:ident)+] [$($action:ident)+]) => {
        /// The primitive items, in the order of their ids.
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Item { $(
            #[doc = concat!("The item `", stringify!($item), "`.")]
            $item
        ),+ }

        /// The primitive actions, in the order of their ids.
        #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Action { $(
            #[doc = concat!("The action `", stringify!($action), "`.")]
            $action
        ),+ }

        /// The names of the items and actions.
        pub static VOCABULARY: $crate::word::Vocabulary = $crate::word::Vocabulary {
            items: &[$(stringify!($item)),+],
            actions: &[$(stringify!($action)),+],
        };

        /// All items in the order of their ids.
        pub const ITEMS: &[Item] = &[$(Item::$item),+];
        /// All actions in the order of their ids.
        pub const ACTIONS: &[Action] = &[$(Action::$action),+];

        impl Item {
            /// The item's id.
            #[must_use]
            pub const fn id(self) -> $crate::word::ItemId {
                $crate::word::ItemId(self as u16)
            }
        }

        impl Action {
            /// The action's id.
            #[must_use]
            pub const fn id(self) -> $crate::word::ActionId {
                $crate::word::ActionId(self as u16)
            }

            /// The action with that id; `None` for an id that is not the robot's.
            #[must_use]
            pub fn of(id: $crate::word::ActionId) -> Option<Self> {
                ACTIONS.get(usize::from(id.0)).copied()
            }
        }

        /// Words of an item set.
        pub const WORDS: usize = ITEMS.len().div_ceil(32);

        /// A goal: these items on, those off.
        #[must_use]
        pub fn goal(on: &[Item], off: &[Item]) -> $crate::word::SignedItems<WORDS> {
            let mut goal = $crate::word::SignedItems::EMPTY;
            for (items, sign) in [(on, true), (off, false)] {
                for item in items {
                    // An item of the robot fits its goals.
                    let _ = goal.insert(item.id(), sign);
                }
            }
            goal
        }
    };
    // What its sensors report, and what it does when it cannot choose; the book's learner takes it as it is.
    (@states) => {
        /// What the robot's sensors report.
        pub type Percept = $crate::word::ItemStates<WORDS>;

        /// What the sensors report: each item is asked for, and is on, off, or unknown (`None`).
        #[must_use]
        pub fn percept<S: Into<Option<bool>>>(mut sense: impl FnMut(Item) -> S) -> Percept {
            let mut now = Percept::UNKNOWN;
            for &item in ITEMS {
                // An item of the robot fits its percept.
                let _ = now.set(item.id(), sense(item).into());
            }
            now
        }
    };
    (@safe) => {};
    (@safe $safe:ident) => {
        /// What the robot does when its brain cannot choose.
        pub const SAFE: Action = Action::$safe;
    };
    // What it thinks with: nothing, or room for so many imagined states.
    (@reason) => { () };
    (@reason $imagines:expr) => {
        $crate::reason::Reason<
            WORDS,
            { ITEMS.len() },
            { ACTIONS.len() },
            { $crate::forest::Capacities::thoughts($imagines).samples },
            { $crate::forest::Capacities::thoughts($imagines).schemas },
            { $imagines },
        >
    };
    // Its bytes, and whether they are as many as it may take.
    (@ram $ram:expr) => {
        /// Bytes of static memory that a brain takes.
        pub const RAM: usize = core::mem::size_of::<Brain>();

        const _: () = assert!(
            RAM <= $ram,
            "{}",
            $crate::brain::message::Message::of_ram(RAM, $ram).as_str()
        );
    };
}

//! The one place where a robot is described: names, values, capacities (book, tables 6.1 and 6.2).

/// Describes a robot's brain: its items, actions, valued items, capacities and memory.
///
/// Makes a module with
/// - `Item` and `Action`, enums of the names, each with `id()`;
/// - `VOCABULARY`, the names for printing;
/// - `Brain`, the [`Agent`](crate::agent::Agent) of these capacities;
/// - `brain()`, a `const` constructor, and `be_born(&mut Brain, config, seed)`, which begins it and
///   sets the inherent values;
/// - `RAM`, the bytes that it costs, all of them in `.bss`.
///
/// A map's weight takes four bytes, or one with `maps: 6 x 6 of bytes`, which is for parts that are
/// small or have no floating-point unit: a numerics of its own, with the same bits everywhere.
///
/// A brain larger than its `ram` does not compile:
///
/// ```compile_fail
/// cla_core::brain! {
///     /// Too large for its part.
///     pub mod tiny {
///         items: [light],
///         actions: [go],
///         values: [light = 1.0],
///         maps: 20 x 20,
///         patterns: 16,
///         schemas: 16,
///         ram: 1_000,
///     }
/// }
/// ```
///
/// A robot that fits:
///
/// ```
/// cla_core::brain! {
///     /// A moth.
///     pub mod moth {
///         items: [light_left, light_right, at_lamp],
///         actions: [left, right, forward],
///         values: [at_lamp = 10.0],
///         maps: 6 x 6,
///         patterns: 32,
///         schemas: 64,
///         ram: 9_000,
///     }
/// }
/// use cla_core::agent::AgentConfig;
/// let mut brain = moth::brain();
/// moth::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// assert!(moth::RAM <= 9_000);
/// assert_eq!(moth::VOCABULARY.items[2], "at_lamp");
/// # Ok::<(), cla_core::check::ConfigError>(())
/// ```
#[macro_export]
macro_rules! brain {
    (@map $width:literal, $height:literal) => {
        $crate::som::BinarySom<$width, $height, { ITEMS.len() }>
    };
    (@map $width:literal, $height:literal, bytes) => {
        $crate::som::ByteSom<$width, $height, { ITEMS.len() }>
    };
    (
        $(#[$meta:meta])*
        $visibility:vis mod $name:ident {
            items: [$($item:ident),+ $(,)?],
            actions: [$($action:ident),+ $(,)?],
            values: [$($valued:ident = $value:expr),+ $(,)?],
            maps: $width:literal x $height:literal $(of $weights:ident)?,
            patterns: $patterns:expr,
            schemas: $schemas:expr,
            $(synthetic: $synthetic:expr,
            beliefs: $beliefs:expr,)?
            ram: $ram:expr $(,)?
        }
    ) => {
        $(#[$meta])*
        $visibility mod $name {
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

            /// What the robot's sensors report.
            pub type Percept = $crate::word::ItemStates<WORDS>;

            /// The brain.
            pub type Brain = $crate::agent::Agent<
                WORDS,
                { ITEMS.len() },
                $width,
                $height,
                { ACTIONS.len() },
                $patterns,
                $schemas,
                { 0 $(+ $synthetic)? },
                { 0 $(+ $beliefs)? },
                $crate::brain!(@map $width, $height $(, $weights)?),
            >;

            /// Bytes of static memory that a brain takes.
            pub const RAM: usize = core::mem::size_of::<Brain>();

            const _: () = assert!(RAM <= $ram, "the brain is larger than the RAM it may take");

            /// A brain before its birth: all memory zero.
            #[must_use]
            pub const fn brain() -> Brain {
                Brain::zeroed()
            }

            /// Begins a brain's life and says what is valuable.
            ///
            /// # Errors
            /// `ConfigError` for a configuration that cannot work.
            pub fn be_born(
                brain: &mut Brain,
                config: $crate::agent::AgentConfig,
                seed: u64,
            ) -> Result<(), $crate::check::ConfigError> {
                brain.begin(config, seed)?;
                $(
                    const _: () = {
                        let value: f32 = $value;
                        assert!(value.is_finite() && value >= 0.0, "an inherent value is finite, not below 0");
                    };
                    // The item and the value were checked at compile time.
                    let _ = brain.knowledge_mut().set_inherent_value(Item::$valued.id(), $value);
                )+
                Ok(())
            }
        }
    };
}

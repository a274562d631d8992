//! The one place where a robot is described: names, values, capacities (book, tables 6.1 and 6.2).

/// What `brain!` needs and nobody else: the message for too little RAM.
#[doc(hidden)]
pub mod message {
    /// A sentence that a constant can make.
    pub struct Message {
        text: [u8; 96],
        length: usize,
    }

    // Evaluated at compile time only: no panic is left in the code.
    #[allow(clippy::indexing_slicing)]
    impl Message {
        /// How many bytes a brain takes, and how many it may take.
        #[must_use]
        pub const fn of_ram(takes: usize, may_take: usize) -> Self {
            let empty = Self {
                text: [0; 96],
                length: 0,
            };
            let takes = empty.add("the brain takes ").number(takes);
            let limit = takes.add(" bytes, and `ram` allows ").number(may_take);
            limit.add(": allow more, or give it less")
        }

        const fn add(mut self, words: &str) -> Self {
            let words = words.as_bytes();
            let mut at = 0;
            while at < words.len() {
                self.text[self.length] = words[at];
                self.length += 1;
                at += 1;
            }
            self
        }

        /// As it is written in Rust: `12_000`.
        const fn number(mut self, number: usize) -> Self {
            let mut place = 1;
            let mut digits = 1;
            while number / place >= 10 {
                place *= 10;
                digits += 1;
            }
            while place > 0 {
                self.text[self.length] = b'0' + (number / place % 10) as u8;
                self.length += 1;
                place /= 10;
                digits -= 1;
                if digits > 0 && digits % 3 == 0 {
                    self.text[self.length] = b'_';
                    self.length += 1;
                }
            }
            self
        }

        /// The sentence.
        #[must_use]
        pub const fn as_str(&self) -> &str {
            let (text, _) = self.text.split_at(self.length);
            match core::str::from_utf8(text) {
                Ok(text) => text,
                Err(_) => "the brain takes more bytes than `ram` allows",
            }
        }
    }
}

/// Describes a robot's brain: its items, actions, valued items, capacities and memory.
///
/// Makes a module with
/// - `Item` and `Action`, enums of the names, each with `id()`;
/// - `percept(|item| …)`, what the sensors report, each item on, off or unknown;
/// - `VOCABULARY`, the names for printing, and `VALUES`, what is worth having;
/// - `Brain`, the [`Mind`](crate::forest::Mind) that remembers so many `samples`, with
///   [`Capacities`](crate::forest::Capacities) in proportion to them;
/// - `brain()`, a `const` constructor, and `be_born(&mut Brain, config, seed)`, its birth with these
///   values: before it the brain refuses to choose and to learn;
/// - `RAM`, the bytes that it costs, all of them in `.bss`.
///
/// The keys may stand in any order: `items`, `actions`, `values` (negative for harm), `samples`, `ram`,
/// and `imagines` for a brain that plans: so many states it imagines at once, with schemas that foresee
/// them ([`Reason`](crate::reason::Reason)), and it can [`pursue`](crate::forest::Mind::pursue) a goal;
/// it cannot be saved yet.
/// A key that is missing is named, one that is unknown or stands twice is pointed at, and so is a
/// value of something that is no item.
///
/// ```
/// cla_core::brain! {
///     /// A moth.
///     pub mod moth {
///         items: [light_left, light_right, at_lamp, singed],
///         actions: [left, right, forward],
///         values: [at_lamp = 10.0, singed = -5.0],
///         samples: 512,
///         ram: 24_000,
///     }
/// }
/// use cla_core::MindConfig;
/// let mut brain = moth::brain();
/// moth::be_born(&mut brain, MindConfig::DEFAULT, 1)?;
/// let choice = brain.choose(&moth::percept(|item| item == moth::Item::light_left))?;
/// assert!(moth::Action::of(choice.action).is_some());
/// # Ok::<(), cla_core::forest::MindError>(())
/// ```
///
/// # The book's learner
///
/// With `maps`, `patterns` and `schemas` in the place of `samples`, and for a second level `synthetic`
/// and `beliefs`, `Brain` is the [`Agent`](crate::agent::Agent) of the book: maps that become schemas.
/// The two do not mix:
///
/// ```compile_fail
/// cla_core::brain! {
///     mod moth {
///         ram: 24_000, items: [light], actions: [go], values: [light = 1.0],
///         maps: 2 x 2, samples: 512,
///     }
/// }
/// ```
///
/// A map's weight takes four bytes, or one with `maps: 6 x 6 of bytes`, which is for parts that are
/// small or have no floating-point unit: a numerics of its own, with the same bits everywhere.
///
/// A brain larger than its `ram` does not compile, and the error says how many bytes it takes:
///
/// ```compile_fail,E0080
/// cla_core::brain! {
///     /// Too large for its part.
///     pub mod tiny {
///         items: [light],
///         actions: [go],
///         values: [light = 1.0],
///         maps: 20 x 20,
///         patterns: 16,
///         schemas: 16,
///         ram: 1_000, // the error says how many bytes it takes
///     }
/// }
/// ```
///
/// A valued item that the robot does not have, and one that is valued twice:
///
/// ```compile_fail,E0599
/// cla_core::brain! {
///     mod moth {
///         ram: 9_000, items: [light], actions: [go], values: [lamp = 1.0],
///         maps: 2 x 2, patterns: 16, schemas: 16,
///     }
/// }
/// ```
///
/// ```compile_fail,E0428
/// cla_core::brain! {
///     mod moth {
///         ram: 9_000, items: [light], actions: [go], values: [light = 1.0, light = 2.0],
///         maps: 2 x 2, patterns: 16, schemas: 16,
///     }
/// }
/// ```
///
/// A key that stands twice:
///
/// ```compile_fail,E0428
/// cla_core::brain! {
///     mod moth {
///         ram: 9_000, items: [light], actions: [go], values: [light = 1.0],
///         maps: 2 x 2, patterns: 16, patterns: 32, schemas: 16,
///     }
/// }
/// ```
///
/// A robot that fits:
///
/// ```
/// cla_core::brain! {
///     /// A moth with the book's learner.
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
/// use cla_core::AgentConfig;
/// let mut brain = moth::brain();
/// moth::be_born(&mut brain, AgentConfig::FORAGER, 1)?;
/// assert!(moth::RAM <= 9_000);
/// assert_eq!(moth::VOCABULARY.items[2], "at_lamp");
/// # Ok::<(), cla_core::ConfigError>(())
/// ```
#[macro_export]
macro_rules! brain {
    (@map $items:expr; $width:literal, $height:literal) => {
        $crate::som::BinarySom<$width, $height, { $items }>
    };
    (@map $items:expr; $width:literal, $height:literal, bytes) => {
        $crate::som::ByteSom<$width, $height, { $items }>
    };
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
    // The keys one by one: each is noted as it was written and its value put in its place.
    (@keys $head:tt [$($seen:ident)*] $places:tt $key:ident: $($rest:tt)*) => {
        $crate::brain! { @key $head [$($seen)* $key] $places $key: $($rest)* }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] items: [$($new:ident),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [{$($new)+} $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] actions: [$($new:ident),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 {$($new)+} $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] values: [$($new:ident = $value:expr),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 {$($new = $value,)+} $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] maps: $width:literal x $height:literal $(of $weights:ident)? $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 {$width, $height $(, $weights)?} $s4 $s5 $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] patterns: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 {$new} $s5 $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] schemas: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 {$new} $s6 $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] synthetic: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 {$new} $s7 $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] beliefs: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 {$new} $s8 $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] ram: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 {$new} $s9 $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] samples: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 {$new} $s10] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt] imagines: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 {$new}] $($($rest)*)? }
    };
    (@keys $head:tt $seen:tt [{} $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt]) => {
        compile_error!("brain!: a key is missing: `items: [light, at_lamp]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt {} $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt]) => {
        compile_error!("brain!: a key is missing: `actions: [left, right]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt {} $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt]) => {
        compile_error!("brain!: a key is missing: `values: [at_lamp = 10.0]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt {} $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt {} $s10:tt]) => {
        compile_error!("brain!: a key is missing: `samples: 1_024`, or for the book's learner `maps: 6 x 6`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt {} $s5:tt $s6:tt $s7:tt $s8:tt {} $s10:tt]) => {
        compile_error!("brain!: a key is missing: `patterns: 32`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt {} $s6:tt $s7:tt $s8:tt {} $s10:tt]) => {
        compile_error!("brain!: a key is missing: `schemas: 128`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt {} $s9:tt $s10:tt]) => {
        compile_error!("brain!: a key is missing: `ram: 12_000`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt {} {} {} {} {} $s8:tt {$samples:expr} $s10:tt]) => {
        $crate::brain! { @mind $head $seen $s0 $s1 $s2 $s8 {$samples} $s10 }
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt {$samples:expr} $s10:tt]) => {
        compile_error!("brain!: `samples` is for the one learner; `maps`, `patterns`, `schemas`, `synthetic` and `beliefs` are for the book's");
    };
    (
        @mind { $(#[$meta:meta])* $visibility:vis mod $name:ident } [$($seen:ident)*]
        { $($item:ident)+ } { $($action:ident)+ } { $($valued:ident = $value:expr,)+ }
        { $ram:expr } { $samples:expr } { $($imagines:expr)? }
    ) => {
        $(#[$meta])*
        $visibility mod $name {
            $crate::brain! { @words [$($item)+] [$($action)+] }

            /// What it is worth when an item is on after an action, negative for harm.
            pub const VALUES: [f32; ITEMS.len()] = {
                let mut values = [0.0; ITEMS.len()];
                $(values[Item::$valued as usize] = $value;)+
                values
            };

            // What stands twice is pointed at by the compiler, and so is a value that is no value.
            const _: () = {
                #[allow(dead_code, non_camel_case_types)]
                enum Keys { $($seen),+ }
                #[allow(dead_code, non_camel_case_types)]
                enum Valued { $($valued),+ }
                $(
                    let value: f32 = $value;
                    assert!(
                        value >= -$crate::forest::MOST_REWARD && value <= $crate::forest::MOST_REWARD,
                        concat!("the value of `", stringify!($valued), "` is not within ten thousand")
                    );
                )+
            };

            const CAPACITIES: $crate::forest::Capacities =
                $crate::forest::Capacities::of($samples, ACTIONS.len());

            /// The brain.
            pub type Brain = $crate::forest::Mind<
                WORDS,
                { ITEMS.len() },
                { ACTIONS.len() },
                { CAPACITIES.stretches },
                { CAPACITIES.leaves },
                { CAPACITIES.rows },
                { CAPACITIES.states },
                { CAPACITIES.links },
                $crate::brain!(@reason $($imagines)?),
            >;

            $crate::brain! { @ram $ram }

            /// A brain before its birth: all memory zero.
            #[must_use]
            pub const fn brain() -> Brain {
                Brain::unborn()
            }

            /// A brain's birth: what is in `VALUES` is worth having, or harm, from now on.
            ///
            /// # Errors
            /// `MindError` for a configuration that cannot work; the brain is as it was.
            pub fn be_born(
                brain: &mut Brain,
                config: $crate::forest::MindConfig,
                seed: u64,
            ) -> Result<(), $crate::forest::MindError> {
                brain.be_born(config, VALUES, seed)
            }
        }
    };
    (
        @keys { $(#[$meta:meta])* $visibility:vis mod $name:ident } [$($seen:ident)*]
        [
            { $($item:ident)+ } { $($action:ident)+ } { $($valued:ident = $value:expr,)+ }
            { $width:literal, $height:literal $(, $weights:ident)? }
            { $patterns:expr } { $schemas:expr } { $($synthetic:expr)? } { $($beliefs:expr)? }
            { $ram:expr } {} {}
        ]
    ) => {
        $(#[$meta])*
        $visibility mod $name {
            $crate::brain! { @words [$($item)+] [$($action)+] }

            /// What is worth having for its own sake.
            pub const VALUES: &[($crate::word::ItemId, f32)] =
                &[$((Item::$valued.id(), $value)),+];

            // What stands twice is pointed at by the compiler, and so is a value that is no value.
            const _: () = {
                #[allow(dead_code, non_camel_case_types)]
                enum Keys { $($seen),+ }
                #[allow(dead_code, non_camel_case_types)]
                enum Valued { $($valued),+ }
                $(
                    let value: f32 = $value;
                    assert!(
                        value.is_finite() && value > 0.0,
                        concat!("the value of `", stringify!($valued), "` is not finite and above 0")
                    );
                )+
            };

            /// The brain.
            pub type Brain = $crate::agent::Agent<
                WORDS,
                { ITEMS.len() },
                $width,
                $height,
                { ACTIONS.len() },
                { $patterns },
                { $schemas },
                { 0 $(+ $synthetic)? },
                { 0 $(+ $beliefs)? },
                $crate::brain!(@map ITEMS.len(); $width, $height $(, $weights)?),
            >;

            $crate::brain! { @ram $ram }

            /// A brain before its birth: all memory zero.
            #[must_use]
            pub const fn brain() -> Brain {
                Brain::zeroed()
            }

            /// A brain's birth: what is in `VALUES` is worth having from now on.
            ///
            /// # Errors
            /// `ConfigError` for a configuration that cannot work; the brain is as it was.
            pub fn be_born(
                brain: &mut Brain,
                config: $crate::agent::AgentConfig,
                seed: u64,
            ) -> Result<(), $crate::check::ConfigError> {
                brain.be_born(config, VALUES, seed)
            }
        }
    };
    (
        $(#[$meta:meta])*
        $visibility:vis mod $name:ident { $($keys:tt)* }
    ) => {
        $crate::brain! {
            @keys { $(#[$meta])* $visibility mod $name } [] [{} {} {} {} {} {} {} {} {} {} {}] $($keys)*
        }
    };
}

#[cfg(test)]
#[path = "brain_tests.rs"]
mod tests;

//! The one place where a robot is described: names, values, capacities (book, tables 6.1 and 6.2).

#[doc(hidden)]
pub mod message;
mod mind;
mod words;

/// Describes a robot's brain: its items, actions, valued items, capacities and memory.
///
/// Makes a module with
/// - `Item` and `Action`, enums of the names, each with `id()`;
/// - `percept(|item| …)`, what the sensors report, each item on, off or unknown, and
///   `Percept::of(&[Item::a])`, these on and all others off; no other robot's brain takes it;
/// - `VOCABULARY`, the names for printing, and `VALUES`, what is worth having;
/// - `Brain`, the [`Mind`](crate::forest::Mind) that remembers so many `samples`, with
///   [`Capacities`](crate::forest::Capacities) in proportion to them: it takes a `Percept` and answers
///   with an `Action`;
/// - `brain()`, a `const` constructor, and `be_born(&mut Brain, config, seed)`, its birth with these
///   values: before it the brain refuses to choose and to learn;
/// - `RAM`, the bytes that it costs, all of them in `.bss`.
///
/// The keys may stand in any order: `items`, `actions`, `values` (negative for harm), `samples`, `ram`;
/// `states` for how many situations it tells apart, where a fourteenth of the samples is not enough
/// ([`health`](crate::forest::Mind::health) says so); `imagines` for a brain that plans: so many states it
/// imagines at once, with schemas that foresee them ([`Reason`](crate::reason::Reason)), and it can
/// [`pursue`](crate::forest::Mind::pursue) a goal; and `safe` names the action for when the brain cannot
/// choose (`SAFE`, `choose_or_safe`).
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
/// assert!(moth::ACTIONS.contains(&choice.action));
/// # Ok::<(), cla_core::forest::MindError>(())
/// ```
///
/// A brain is saved and loaded as the mind that it is, `&*brain`, see [`snapshot`](crate::snapshot):
///
/// ```
/// cla_core::brain! {
///     pub mod moth {
///         items: [light_left, light_right, at_lamp, singed],
///         actions: [left, right, forward],
///         values: [at_lamp = 10.0, singed = -5.0],
///         samples: 64,
///         imagines: 16,
///         ram: 24_000,
///     }
/// }
/// use cla_core::MindConfig;
/// use cla_core::snapshot::{self, SliceSink};
/// let names = moth::VOCABULARY.names();
/// let mut brain = moth::brain();
/// moth::be_born(&mut brain, MindConfig::DEFAULT, 1)?;
/// let mut image = vec![0; 65_536];
/// let length = snapshot::save(&*brain, names, &mut SliceSink::new(&mut image))?;
/// let mut other = moth::brain();
/// snapshot::load(&mut *other, names, &mut &image[..length as usize])?;
/// let now = moth::percept(|_| false);
/// assert_eq!(other.choose(&now)?, brain.choose(&now)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A percept of another robot is another type:
///
/// ```compile_fail,E0308
/// cla_core::brain! {
///     pub mod moth { items: [light], actions: [fly], values: [light = 1.0], samples: 64, ram: 20_000 }
/// }
/// cla_core::brain! {
///     pub mod mole { items: [earth], actions: [dig], values: [earth = 1.0], samples: 64, ram: 20_000 }
/// }
/// let _ = moth::brain().choose(&mole::Percept::UNKNOWN);
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
    // The keys one by one: each is noted as it was written and its value put in its place.
    (@keys $head:tt [$($seen:ident)*] $places:tt $key:ident: $($rest:tt)*) => {
        $crate::brain! { @key $head [$($seen)* $key] $places $key: $($rest)* }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] items: [$($new:ident),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [{$($new)+} $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] actions: [$($new:ident),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 {$($new)+} $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] values: [$($new:ident = $value:expr),+ $(,)?] $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 {$($new = $value,)+} $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] maps: $width:literal x $height:literal $(of $weights:ident)? $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 {$width, $height $(, $weights)?} $s4 $s5 $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] patterns: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 {$new} $s5 $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] schemas: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 {$new} $s6 $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] synthetic: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 {$new} $s7 $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] beliefs: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 {$new} $s8 $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] ram: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 {$new} $s9 $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] samples: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 {$new} $s10 $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] imagines: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 {$new} $s11 $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] safe: $new:ident $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10 {$new} $s12] $($($rest)*)? }
    };
    (@key $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt] states: $new:expr $(, $($rest:tt)*)?) => {
        $crate::brain! { @keys $head $seen [$s0 $s1 $s2 $s3 $s4 $s5 $s6 $s7 $s8 $s9 $s10 $s11 {$new}] $($($rest)*)? }
    };
    (@keys $head:tt $seen:tt [{} $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `items: [light, at_lamp]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt {} $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `actions: [left, right]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt {} $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt $s9:tt $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `values: [at_lamp = 10.0]`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt {} $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt {} $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `samples: 1_024`, or for the book's learner `maps: 6 x 6`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt {} $s5:tt $s6:tt $s7:tt $s8:tt {} $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `patterns: 32`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt {} $s6:tt $s7:tt $s8:tt {} $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `schemas: 128`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt {} $s9:tt $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: a key is missing: `ram: 12_000`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt {} {} {} {} {} $s8:tt {$samples:expr} $s10:tt $s11:tt $s12:tt]) => {
        $crate::brain_with_a_mind! { $head $seen $s0 $s1 $s2 $s8 {$samples} $s10 $s11 $s12 }
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt {} $s10:tt $s11:tt {$states:expr}]) => {
        compile_error!("brain!: `states` is for the one learner, beside `samples`");
    };
    (@keys $head:tt $seen:tt [$s0:tt $s1:tt $s2:tt $s3:tt $s4:tt $s5:tt $s6:tt $s7:tt $s8:tt {$samples:expr} $s10:tt $s11:tt $s12:tt]) => {
        compile_error!("brain!: `samples` is for the one learner; `maps`, `patterns`, `schemas`, `synthetic` and `beliefs` are for the book's");
    };
    (
        @keys { $(#[$meta:meta])* $visibility:vis mod $name:ident } [$($seen:ident)*]
        [
            { $($item:ident)+ } { $($action:ident)+ } { $($valued:ident = $value:expr,)+ }
            { $width:literal, $height:literal $(, $weights:ident)? }
            { $patterns:expr } { $schemas:expr } { $($synthetic:expr)? } { $($beliefs:expr)? }
            { $ram:expr } {} {} { $($safe:ident)? } {}
        ]
    ) => {
        $(#[$meta])*
        $visibility mod $name {
            $crate::brain_words! { @words [$($item)+] [$($action)+] }

            $crate::brain_words! { @states }
            $crate::brain_words! { @safe $($safe)? }

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

            $crate::brain_words! { @ram $ram }

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
            @keys { $(#[$meta])* $visibility mod $name } [] [{} {} {} {} {} {} {} {} {} {} {} {} {}] $($keys)*
        }
    };
}

#[cfg(test)]
#[path = "brain_tests.rs"]
mod tests;

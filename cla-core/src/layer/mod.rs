//! Layers of maps that turn components into wholes: the propositional half of CLA (book, 3 and 4).
//!
//! A [`Layer`] is a map together with the activations of its nodes, and its activations are the
//! stimulus of the next layer.
//! Four structures join layers: a stack ([`Stack`]), a tree ([`Join`]), a time delay ([`Delayed`],
//! [`Window`]) and a loop ([`Recurrent`]); they nest in any way, in static memory, and shapes that
//! do not fit together do not compile.
//! [`overload`] tells when a stimulus is too much for a layer, and [`answering_level`] which level
//! then answers.
//! Sensorimotor schemas are not here: they stand on the same maps in [`crate::knowledge`].
//!
//! A perception of two senses, whose top layer sees both at this moment and the one before:
//!
//! ```
//! use cla_core::layer::{Join, Layer, LayerConfig, Stack, Structure, Window};
//! use cla_core::num::{Rng, Schedule};
//!
//! // Two level-1 layers of 9 nodes, joined, held for two steps: 2 · (9 + 9) = 36 features.
//! type Senses = Join<Layer<3, 3, 4>, Layer<3, 3, 2>>;
//! type Perception = Stack<Window<Senses, 18, 2>, 4, 4, 36>;
//!
//! static PERCEPTION: Perception = Perception::new(); // all zeros: no flash, only RAM
//!
//! let mut perception = PERCEPTION.clone();
//! let config = LayerConfig::try_new(
//!     0.5,
//!     Schedule::geometric(0.5, 0.02, 1000)?,
//!     Schedule::geometric(2.0, 0.5, 1000)?,
//! )?;
//! let mut rng = Rng::new(1);
//! perception.lower.source.first.start(&config, &mut rng);
//! perception.lower.source.second.start(&config, &mut rng);
//! perception.upper.start(&config, &mut rng);
//! for t in 0..1000 {
//!     let (eye, ear) = ([rng.unit(), 0.0, 1.0, 0.0], [rng.unit(), 0.5]);
//!     perception.learn(&(eye, ear), t)?; // the whole hierarchy in one pass
//! }
//! assert!(perception.upper.best_match().squared_distance < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A layer whose features are not the activations below it is refused by the compiler:
//!
//! ```compile_fail,E0080
//! use cla_core::layer::{Layer, Stack, Structure};
//!
//! // The lower layer has 3 · 3 = 9 nodes, the upper one reads 10 features.
//! let mut wrong = Stack::<Layer<3, 3, 4>, 2, 2, 10>::new();
//! wrong.activate(&[0.0; 4]);
//! ```

mod cla_layer;
mod composite;
mod delay;
mod fallback;
pub mod overload;
mod recurrent;
mod signal;
mod structure;

pub use cla_layer::{Layer, LayerConfig};
pub use composite::ActivationComposite;
pub use delay::{DelayLine, Delayed, Window};
pub use fallback::{Level, answering_level};
pub use recurrent::Recurrent;
pub use signal::{Scaled, Signal};
pub use structure::{Input, Join, Stack, Structure};

//! Maps whose size is known at run time, for `cla.SOM`.
//!
//! The core's maps have their size in their type, as memory without a heap wants it; Python gives it in
//! the constructor.
//! So the weights lie in an array of numpy, feature by feature, and these functions work on it in place:
//! the dense map (`dense`) does what `cla_core::som::DenseSom` does, weight by weight in the same order, to
//! the same bits (a test holds it to them); the map of binary stimuli (`binary`) does the arithmetic
//! of `BinarySom`, folding all nodes at once.
//! A node's number is `i · y + j` for the place `(i, j)`.

mod binary;
mod dense;
mod rates;
mod table;

pub(crate) use table::{
    som_binary_distances, som_binary_fold, som_binary_train, som_distances, som_train,
};

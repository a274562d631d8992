//! What both ways to independent components share: how components become units.
//!
//! A component may lie on either side of its mean, and a unit may not be less than silent; so each
//! component has two units, one a side, and there are half as many components as units at most.
//! What no component says is how new a stimulus is.

use super::module::{FUNCTION, Work};

/// A direction with less than this share of all variance is none.
pub(super) const NEGLIGIBLE: f64 = 1e-4;
/// Components farther from 0 than this count as so far: one stimulus does not turn everything.
pub(super) const FARTHEST: f32 = 8.0;

/// Writes the two units of each component; those without a component are silent.
pub(super) fn units(components: &[f32], gain: f32, activations: &mut [f32]) {
    activations.fill(0.0);
    for (pair, &it) in activations.chunks_exact_mut(2).zip(components) {
        let side = usize::from(it < 0.0);
        pair[side] = libm::tanhf(gain * it.abs());
    }
}

/// Σ a·b.
pub(super) fn dot(a: &[f32], b: &[f32]) -> f32 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// What it costs to answer by so many components of so many features, `turned` among themselves.
pub(super) fn responding(components: usize, features: usize, turned: bool) -> f64 {
    let turn = if turned { components * components } else { 0 };
    (2 * components * features + turn + components * FUNCTION) as f64
}

/// The work of a module that has computed so much for so many stimuli.
pub(super) fn work(respond: f64, computed: f64, samples: u32) -> Work {
    Work {
        respond,
        learn: computed / f64::from(samples.max(1)),
    }
}

//! The float functions of the `libm` crate: portable code, the same bits on every target.

pub(super) fn exp(x: f32) -> f32 {
    libm::expf(x)
}

pub(super) fn sqrt(x: f32) -> f32 {
    libm::sqrtf(x)
}

pub(super) fn ln(x: f32) -> f32 {
    libm::logf(x)
}

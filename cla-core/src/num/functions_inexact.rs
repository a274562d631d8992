//! The float functions of the `micromath` crate (feature `micromath`): approximations with few
//! instructions, within some thousandths of the value, and other bits than everywhere else.

use micromath::F32;

pub(super) fn exp(x: f32) -> f32 {
    F32::exp(F32(x)).0
}

pub(super) fn sqrt(x: f32) -> f32 {
    F32::sqrt(F32(x)).0
}

pub(super) fn ln(x: f32) -> f32 {
    F32::ln(F32(x)).0
}

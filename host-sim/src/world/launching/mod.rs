//! Launching events: two balls on a line, one of which may set the other going (book, 4.1, 4.2).
//!
//! `event` shows what the sensors report of each of the four, `noise` disturbs them.

mod event;
mod noise;

pub use event::{
    CELLS, Event, Frame, LaunchingConfig, LaunchingConfigError, MOVEMENT, SPEED_ELEMENTS, Stimulus,
    stimuli,
};
pub use noise::Noise;

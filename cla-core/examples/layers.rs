//! Layers of maps: the order of two sounds is heard one layer above the sounds.
//!
//! A lower layer learns the sounds; an upper layer sees the lower one's activations of this moment
//! and of the one before, side by side.
//! "do, re" and "re, do" end alike for nobody but the upper layer, which answers them with different
//! nodes, and an unheard order with less certainty.
//! `cargo run --release -p cla-core --example layers`

use std::error::Error;

use cla_core::layer::{Layer, LayerConfig, Stack, Structure, Window};
use cla_core::num::{Rng, Schedule};
use cla_core::som::NodeId;

/// A sound: how loud each of four pitches is.
type Sound = [f32; 4];
/// Nine nodes for the sounds, held for two moments: 18 features.
type Ear = Stack<Window<Layer<3, 3, 4>, 9, 2>, 5, 5, 18>;

const DO: Sound = [1.0, 0.2, 0.0, 0.0];
const RE: Sound = [0.0, 0.1, 1.0, 0.3];
const MI: Sound = [0.3, 0.0, 0.1, 1.0];
const MOMENTS: u32 = 6000;

/// Hears one sound after the other without learning; returns the upper layer's node and how far the
/// pair is from what it knows.
fn hear(ear: &mut Ear, pair: [Sound; 2]) -> Result<(NodeId, f32), Box<dyn Error>> {
    for sound in pair {
        ear.activate(&sound)?;
    }
    let best = ear.upper.best_match();
    Ok((best.node, best.squared_distance))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut ear = Ear::new();
    let config = LayerConfig::try_new(
        0.5,
        Schedule::geometric(0.5, 0.02, MOMENTS)?,
        Schedule::geometric(2.0, 0.4, MOMENTS)?,
    )?;
    let mut rng = Rng::new(3);
    ear.lower.source.start(&config, &mut rng);
    ear.upper.start(&config, &mut rng);
    // Songs of two sounds, in both orders of the first two; MI follows nobody.
    let songs = [[DO, RE], [RE, DO]];
    for moment in 0..MOMENTS {
        let song = songs[(moment / 2) as usize % 2];
        let mut sound = song[moment as usize % 2];
        for pitch in &mut sound {
            *pitch += 0.1 * (rng.unit() - 0.5);
        }
        ear.learn(&sound, moment)?;
    }
    let (up, near_up) = hear(&mut ear, [DO, RE])?;
    let (down, near_down) = hear(&mut ear, [RE, DO])?;
    let (_, strange) = hear(&mut ear, [MI, MI])?;
    println!("do, re is node {up:?}; re, do is node {down:?}");
    println!("distance: {near_up:.3} and {near_down:.3}; never heard, mi, mi: {strange:.3}");
    assert_ne!(up, down);
    assert!(near_up.max(near_down) < 0.1 && strange > 1.0);
    Ok(())
}

//! A map without a brain: a sheet of prototypes spreads over the colours it is shown.
//!
//! Before training neighbours on the map are strangers; afterwards near colours lie near each other,
//! which two standard measures say in numbers.
//! `cargo run --release -p cla-core --example map_alone`

use std::error::Error;

use cla_core::num::{Neighbourhood, Rng, Schedule};
use cla_core::som::{DenseSom, quantization_error, topographic_error};

/// Colours: red, green and blue, each between 0 and 1.
type Colour = [f32; 3];

const STEPS: u32 = 20_000;

fn main() -> Result<(), Box<dyn Error>> {
    let mut rng = Rng::new(1);
    // Colours of a garden: greens, and flowers from yellow to red.
    let mut colour = || -> Colour {
        let (light, hue) = (rng.unit(), rng.unit());
        if rng.unit() < 0.5 {
            [0.2 * light, 0.4 + 0.5 * light, 0.3 * hue]
        } else {
            [0.9, 0.8 * hue, 0.2 * light]
        }
    };
    let garden: Vec<Colour> = (0..500).map(|_| colour()).collect();

    let mut map = DenseSom::<12, 12, 3>::new();
    map.randomize(&mut Rng::new(2));
    let before = (
        quantization_error(&map, garden.iter())?,
        topographic_error(&map, garden.iter())?,
    );
    let alpha = Schedule::geometric(0.5, 0.02, STEPS)?;
    let sigma = Schedule::geometric(5.0, 0.6, STEPS)?;
    for step in 0..STEPS {
        let stimulus = colour();
        let best = map.best_matching_unit(&stimulus)?;
        let near = Neighbourhood::gaussian(sigma.at(step), 0.01)?;
        map.train(&stimulus, best.node, alpha.at(step), &near);
    }
    let after = (
        quantization_error(&map, garden.iter())?,
        topographic_error(&map, garden.iter())?,
    );
    println!(
        "distance to the nearest prototype: {:.3} before, {:.3} after",
        before.0, after.0
    );
    println!(
        "colours whose two nearest prototypes are no neighbours: {:.0} % before, {:.0} % after",
        100.0 * before.1,
        100.0 * after.1
    );
    assert!(after.0 < before.0 / 2.0);
    assert!(before.1 > 0.5 && after.1 < 0.25);
    Ok(())
}

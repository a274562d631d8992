//! What an action of the life in `speed.py` takes in Rust, without Python.
//!
//! `cargo run --release --example life -- [REPEATS]`, in `host-sim/python`.

use std::time::Instant;
use std::{fs, sync::LazyLock};

use cla_core::forest::MindConfig;
use host_sim::failure::Failure;
use host_sim::learner::live;
use host_sim::learner::mind::Minded;
use host_sim::world::config::PioneerConfig;
use host_sim::world::pioneer::{INGRIP, Pioneer};

const ACTIONS: u32 = 20_000;

/// Seconds of CPU time of this thread, where Linux tells them; of the clock elsewhere.
fn seconds() -> f64 {
    static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);
    let told = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|it| it.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGUN.elapsed().as_secs_f64(), |it| 1e-9 * it)
}

fn main() -> Result<(), Failure> {
    let repeats = match std::env::args().nth(1) {
        Some(text) => text.parse()?,
        None => 5,
    };
    let mut values = [0.0; 7];
    values[usize::from(INGRIP)] = 10.0;
    let mut least = f64::INFINITY;
    for _ in 0..repeats {
        let begun = seconds();
        let mut world = Pioneer::new(PioneerConfig::NOISY, 1)?;
        let mut mind = Minded::<1, 7, 6>::born(MindConfig::DEFAULT, values, 1)?;
        live(&mut mind, &mut world, ACTIONS)?;
        least = least.min(seconds() - begun);
    }
    println!(
        "  in Rust            {:8.2} us",
        1e6 * least / f64::from(ACTIONS)
    );
    Ok(())
}

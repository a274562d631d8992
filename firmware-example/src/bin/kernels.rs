#![no_std]
#![no_main]
//! What the kernels of the maps cost at the shapes of the budget, in instructions.
//!
//! Every line: kernel, shape, features on, instructions. `cargo run --release --bin kernels`.
//! The shapes are those of the book's level 1 and 2 and of the specification's trials; the radius of
//! an update is 3 nodes or the whole map.

use core::hint::black_box;

use cla_core::num::{Neighbourhood, Rng};
use cla_core::som::{BinarySom, ByteSom, Grid, NodeId, Prototypes, SparseStimulus};
use firmware_example::board::Counter;
use semihosting::{println, process};

/// Words of the largest stimulus: 150 features.
const WORDS: usize = 5;

/// A stimulus with `on` of `features` on, spread evenly.
fn stimulus(features: usize, on: usize) -> [u32; WORDS] {
    let mut words = [0; WORDS];
    for bit in (0..on).map(|i| (i * features) / on) {
        if let Some(word) = words.get_mut(bit / 32) {
            *word |= 1 << (bit % 32);
        }
    }
    words
}

/// Measures one kind of map in one shape.
fn measure<M: Prototypes<W, H>, const W: usize, const H: usize>(
    name: &str,
    map: &mut M,
    features: usize,
    on: usize,
) {
    map.randomize(&mut Rng::new(1));
    let words = stimulus(features, on);
    let x = black_box(SparseStimulus {
        on: &words,
        minus: &[],
        unknown: &[],
    });
    let (mut scratch, mut distances) = (Grid::<f32, W, H>::filled(0.0), Grid::filled(0.0));
    let mut counter = Counter::start();
    let best = black_box(map.best_match(&x, &mut scratch, &mut distances));
    let search = counter.lap();
    let shape = (W * H, features, on);
    println!(
        "{name} best_match {}x{} on {} = {search}",
        shape.0, shape.1, shape.2
    );
    let near = [
        ("radius_3", Neighbourhood::gaussian(1.0, 0.01)),
        ("whole", Neighbourhood::gaussian(9.0, 0.0)),
    ];
    // The middle of the map: the largest neighbourhood.
    let middle = NodeId((H / 2 * W + W / 2) as u16);
    for (reach, near) in near {
        let Ok(near) = near else { continue };
        counter.lap();
        map.train(black_box(&x), middle, 0.1, &near, |_| true);
        let update = counter.lap();
        println!(
            "{name} update_{reach} {}x{} on {} = {update}",
            shape.0, shape.1, shape.2
        );
    }
    black_box(best);
}

/// Runs one shape on a map in static memory, which each kind of map has for itself.
macro_rules! shape {
    ($name:literal, $map:ident<$w:literal, $h:literal, $d:literal>, $on:literal) => {{
        static mut MAP: $map<$w, $h, $d> = <$map<$w, $h, $d> as Prototypes<$w, $h>>::ZERO;
        let map = &raw mut MAP;
        // SAFETY: each expansion has a static of its own and runs once.
        #[allow(unsafe_code)]
        let map = unsafe { &mut *map };
        measure::<_, $w, $h>($name, map, $d, $on);
    }};
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    shape!("f32", BinarySom<20, 20, 14>, 4);
    shape!("f32", BinarySom<20, 20, 142>, 10);
    shape!("f32", BinarySom<10, 10, 150>, 12);
    shape!("u8", ByteSom<20, 20, 14>, 4);
    shape!("u8", ByteSom<20, 20, 142>, 10);
    shape!("u8", ByteSom<10, 10, 150>, 12);
    process::exit(0);
}

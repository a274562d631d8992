//! What the maps' kernels and a tick of an agent cost on this machine, beside a plain dense loop.
//!
//! `cargo bench` from the root of the project; it ends with a table of ratios, each against the
//! plain loop that was timed in the same run.
//! Nothing is asserted, for clocks differ: what is promised are instructions on microcontrollers
//! (`memory-budget.md`), which tests hold.

mod garden;
mod plain;
mod ratios;

use std::hint::black_box;
use std::time::Duration;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer;
use cla_core::num::{Neighbourhood, Rng};
use cla_core::som::{
    BinarySom, ByteSom, DenseSom, Grid, NodeId, Prototypes, SparseStimulus, best_match,
};
use criterion::Criterion;
use garden::Garden;
use plain::PlainMap;
use ratios::{PEER, Ratios};

/// Learning rate of the updates.
const ALPHA: f32 = 0.1;
/// Width of the updates' neighbourhood, nodes.
const SIGMA: f32 = 2.0;

/// A stimulus in both forms.
struct Stimulus<const FEATURES: usize> {
    dense: [f32; FEATURES],
    words: Vec<u32>,
}

impl<const FEATURES: usize> Stimulus<FEATURES> {
    /// `on` features are on, spread evenly, in every rotation: each feature is on now and then, as
    /// otherwise its weights would shrink to numbers that the processor is slow with.
    fn rotations(on: usize) -> Vec<Self> {
        (0..FEATURES).map(|shift| Self::with(on, shift)).collect()
    }

    fn with(on: usize, shift: usize) -> Self {
        let mut dense = [0.0; FEATURES];
        let mut words = vec![0; FEATURES.div_ceil(32)];
        for feature in (0..on).map(|k| (k * FEATURES / on + shift) % FEATURES) {
            dense[feature] = 1.0;
            words[feature / 32] |= 1 << (feature % 32);
        }
        Self { dense, words }
    }

    fn sparse(&self) -> SparseStimulus<'_> {
        SparseStimulus {
            on: &self.words,
            minus: &[],
            unknown: &[],
        }
    }
}

/// Times search and update of every kind of map in one shape, with `on` features on.
fn maps<const W: usize, const H: usize, const FEATURES: usize>(
    criterion: &mut Criterion,
    ratios: &mut Ratios,
    on: usize,
) {
    let stimuli = Stimulus::<FEATURES>::rotations(on);
    let mut turns = stimuli.iter().cycle();
    let mut next = || black_box(turns.next().expect("a cycle has no end"));
    let near = Neighbourhood::<W, H>::gaussian(SIGMA, 0.01).expect("a width above 0");
    let winner = NodeId((H / 2 * W + W / 2) as u16);
    let shape = format!("{W}x{H} nodes, {FEATURES} features, {on} on");

    let mut plain = Box::new(PlainMap::<W, H, FEATURES>::random());
    let mut dense = Box::new(DenseSom::<W, H, FEATURES>::new());
    dense.randomize(&mut Rng::new(1));
    let mut binary = randomized::<BinarySom<W, H, FEATURES>, W, H>();
    let mut byte = randomized::<ByteSom<W, H, FEATURES>, W, H>();

    let mut group = ratios.group(criterion, &format!("search, {shape}"));
    group.time(PEER, || plain.search(&next().dense));
    group.time("DenseSom", || dense.best_matching_unit(&next().dense));
    group.time("BinarySom", || search(&*binary, &next().sparse()));
    group.time("ByteSom", || search(&*byte, &next().sparse()));
    drop(group);

    let mut group = ratios.group(criterion, &format!("update, {shape}"));
    group.time(PEER, || {
        plain.train(&next().dense, winner, ALPHA, &near);
    });
    group.time("DenseSom", || {
        dense.train(&next().dense, winner, ALPHA, &near);
    });
    group.time("BinarySom", || {
        binary.train(&next().sparse(), winner, ALPHA, &near, |_| true);
    });
    group.time("ByteSom", || {
        byte.train(&next().sparse(), winner, ALPHA, &near, |_| true);
    });
}

fn randomized<M: Prototypes<W, H>, const W: usize, const H: usize>() -> Box<M> {
    let mut map = Box::new(M::ZERO);
    map.randomize(&mut Rng::new(1));
    map
}

fn search<M: Prototypes<W, H>, const W: usize, const H: usize>(
    map: &M,
    stimulus: &SparseStimulus<'_>,
) -> NodeId {
    let (mut scratch, mut distances) = (Grid::filled(0.0), Grid::filled(0.0));
    map.squared_distances(stimulus, &mut scratch, &mut distances);
    best_match(&distances).node
}

/// Times a tick of the book's forager, `choose` and `learn`, beside one search and one update of a
/// map of its size by the plain loop: the least that a tick takes whose map is dense.
fn ticks(criterion: &mut Criterion, ratios: &mut Ratios) {
    let stimuli = Stimulus::<14>::rotations(4);
    let mut turns = stimuli.iter().cycle();
    let near = Neighbourhood::gaussian(SIGMA, 0.01).expect("a width above 0");
    let mut plain = Box::new(PlainMap::<20, 20, 14>::random());
    let mut group = ratios.group(criterion, "tick of the forager");
    group.time(PEER, || {
        let stimulus = black_box(turns.next().expect("a cycle has no end"));
        let winner = plain.search(&stimulus.dense);
        plain.train(&stimulus.dense, winner, ALPHA, &near);
    });
    for (name, config, adaptation) in [
        ("level 1, frozen", AgentConfig::FORAGER, Adaptation::Frozen),
        (
            "level 1, learning",
            AgentConfig::FORAGER,
            Adaptation::Relearning,
        ),
        (
            "both levels, learning",
            AgentConfig::FORAGER_LEVEL2,
            Adaptation::Relearning,
        ),
    ] {
        let mut brain = Box::new(pioneer::brain());
        pioneer::be_born(&mut brain, config, 1).expect("a sound configuration");
        let mut garden = Garden::default();
        for _ in 0..5000 {
            garden.tick(&mut brain);
        }
        brain.act(adaptation).expect("a life that has begun");
        group.time(name, || garden.tick(&mut brain));
    }
}

fn main() {
    let mut criterion = Criterion::default()
        .without_plots()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_millis(1000))
        .output_directory(&ratios::directory())
        .configure_from_args();
    let mut ratios = Ratios::default();
    // The shapes of the book's levels 1 and 2, and of a small part.
    maps::<20, 20, 14>(&mut criterion, &mut ratios, 4);
    maps::<20, 20, 142>(&mut criterion, &mut ratios, 10);
    maps::<10, 10, 150>(&mut criterion, &mut ratios, 12);
    ticks(&mut criterion, &mut ratios);
    criterion.final_summary();
    ratios.print();
}

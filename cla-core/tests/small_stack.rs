//! Brains larger than the stack: made on the heap as constants, copied by an image.

use std::thread;

use cla_core::forager::pioneer;
use cla_core::forest::{Mind, MindConfig};
use cla_core::snapshot::{self, Names, SliceSink, Snapshot};
use cla_core::{AgentConfig, Percept};

/// As many samples as the forager's.
type Forest = Mind<1, 7, 6, 448, 200, 512, 512, 2048>;

/// Bytes of a stack that holds no third of a brain.
const SMALL: usize = 64 * 1024;
const _: () = assert!(size_of::<pioneer::Brain>() > 3 * SMALL && size_of::<Forest>() > 3 * SMALL);

fn on_a_small_stack(work: fn()) {
    let thread = thread::Builder::new().stack_size(SMALL).spawn(work);
    thread.unwrap().join().unwrap();
}

fn image<B: Snapshot>(brain: &B) -> Vec<u8> {
    let mut image = vec![0; snapshot::length(brain).unwrap() as usize];
    snapshot::save(brain, Names::UNKNOWN, &mut SliceSink::new(&mut image)).unwrap();
    image
}

#[test]
fn a_thread_with_a_small_stack_makes_and_copies_a_forager() {
    on_a_small_stack(|| {
        let mut brain = Box::new(const { pioneer::brain() });
        pioneer::be_born(&mut brain, AgentConfig::FORAGER, 1).unwrap();
        let now = Percept::all_off(7);
        for _ in 0..300 {
            brain.choose(&now).unwrap();
            brain.learn(&now).unwrap();
        }
        let kept = image(&*brain);
        let mut copy = Box::new(const { pioneer::brain() });
        snapshot::load(&mut *copy, Names::UNKNOWN, &mut &*kept).unwrap();
        assert!(image(&*copy) == kept);
        assert_eq!(copy.choose(&now), brain.choose(&now));
    });
}

#[test]
fn and_a_mind() {
    on_a_small_stack(|| {
        let mut mind = Box::new(const { Forest::new() });
        mind.be_born(MindConfig::DEFAULT, [1.0; 7], 1).unwrap();
        let now = Percept::all_off(7);
        for _ in 0..300 {
            mind.choose(&now).unwrap();
            mind.learn(&now).unwrap();
        }
        let kept = image(&*mind);
        let mut copy = Box::new(const { Forest::new() });
        snapshot::load(&mut *copy, Names::UNKNOWN, &mut &*kept).unwrap();
        assert!(image(&*copy) == kept);
        assert_eq!(copy.choose(&now), mind.choose(&now));
    });
}

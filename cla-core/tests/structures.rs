//! What each structure of layers is for: a task that it solves and that cannot be solved without it
//! (book, 3.3).
//!
//! No layer ever sees a label.
//! Afterwards every winner is named by the majority of its stimuli, and the accuracy on new stimuli
//! is the share of those whose winner has the right name.

use cla_core::layer::{Input, Join, Layer, LayerConfig, Recurrent, Stack, Structure, Window};
use cla_core::num::{Rng, Schedule};
use cla_core::som::NodeId;

fn config(activation_width: f32, side: f32, last: f32, samples: u32) -> LayerConfig {
    let alpha = Schedule::geometric(0.5, 0.02, samples).unwrap();
    let near = Schedule::geometric(side / 2.0, last, samples).unwrap();
    LayerConfig::try_new(activation_width, alpha, near).unwrap()
}

/// The accuracy of winners named by the first half of `seen`, on the second half.
fn accuracy(seen: &[(NodeId, bool)]) -> f32 {
    let (named, new) = seen.split_at(seen.len() / 2);
    let name = |node| {
        let votes = named.iter().filter(|(winner, _)| *winner == node);
        votes
            .map(|(_, label)| if *label { 1 } else { -1 })
            .sum::<i32>()
            > 0
    };
    let right = new
        .iter()
        .filter(|(winner, label)| name(*winner) == *label)
        .count();
    right as f32 / new.len() as f32
}

/// A point of a disc (true) or of the ring around it, with equal chance.
fn disc_or_ring(rng: &mut Rng) -> ([f32; 2], bool) {
    let disc = rng.chance(0.5);
    loop {
        let point = [rng.unit() * 2.0 - 1.0, rng.unit() * 2.0 - 1.0];
        let radius = (point[0] * point[0] + point[1] * point[1]).sqrt();
        if (disc && radius < 0.25) || (!disc && (0.75..1.0).contains(&radius)) {
            return (point, disc);
        }
    }
}

#[test]
fn a_stack_of_two_tells_a_disc_from_the_ring_around_it_by_two_nodes() {
    const SAMPLES: u32 = 6000;
    let mut rng = Rng::new(1);
    let mut flat = Layer::<2, 1, 2>::new();
    let mut stack = Stack::<Layer<8, 8, 2>, 2, 1, 64>::new();
    flat.start(&config(0.3, 2.0, 0.2, SAMPLES), &mut rng);
    stack
        .lower
        .start(&config(0.35, 8.0, 0.5, SAMPLES), &mut rng);
    stack.upper.start(&config(0.5, 2.0, 0.2, SAMPLES), &mut rng);
    for t in 0..SAMPLES {
        let (point, _) = disc_or_ring(&mut rng);
        flat.learn(&point, t).unwrap();
        stack.learn(&point, t).unwrap();
    }
    let (mut by_flat, mut by_stack) = (Vec::new(), Vec::new());
    for _ in 0..2000 {
        let (point, disc) = disc_or_ring(&mut rng);
        flat.activate(&point).unwrap();
        stack.activate(&point).unwrap();
        by_flat.push((flat.best_match().node, disc));
        by_stack.push((stack.upper.best_match().node, disc));
    }
    // Two nodes part the plane by a line: at best all of the disc and half of the ring.
    assert!(
        (0.5..0.8).contains(&accuracy(&by_flat)),
        "{}",
        accuracy(&by_flat)
    );
    assert!(accuracy(&by_stack) > 0.97, "{}", accuracy(&by_stack));
}

fn one_hot<const N: usize>(on: usize) -> [f32; N] {
    core::array::from_fn(|i| f32::from(u8::from(i == on)))
}

#[test]
fn a_tree_tells_whether_two_senses_agree_and_neither_sense_does() {
    const SAMPLES: u32 = 2000;
    let mut rng = Rng::new(2);
    let mut tree = Stack::<Join<Layer<2, 1, 2>, Layer<2, 1, 2>>, 2, 2, 4>::new();
    tree.lower
        .first
        .start(&config(0.5, 2.0, 0.2, SAMPLES), &mut rng);
    tree.lower
        .second
        .start(&config(0.5, 2.0, 0.2, SAMPLES), &mut rng);
    tree.upper.start(&config(0.5, 2.0, 0.2, SAMPLES), &mut rng);
    let mut seen = [const { Vec::new() }; 3];
    for t in 0..SAMPLES + 1000 {
        let (eye, ear) = (rng.below(2) as usize, rng.below(2) as usize);
        let sensors = (one_hot(eye), one_hot(ear));
        if t < SAMPLES {
            tree.learn(&sensors, t).unwrap();
        } else {
            tree.activate(&sensors).unwrap();
            let join = &tree.lower;
            let winners = [&join.first, &join.second].map(|layer| layer.best_match().node);
            seen[0].push((winners[0], eye == ear));
            seen[1].push((winners[1], eye == ear));
            seen[2].push((tree.upper.best_match().node, eye == ear));
        }
    }
    let [eye, ear, top] = seen.map(|seen| accuracy(&seen));
    assert!(
        (0.4..0.6).contains(&eye) && (0.4..0.6).contains(&ear),
        "{eye} {ear}"
    );
    assert_eq!(top, 1.0);
}

#[test]
fn a_window_tells_which_way_a_light_moves_and_a_snapshot_does_not() {
    const SAMPLES: u32 = 8000;
    let mut rng = Rng::new(3);
    let mut snapshot = Stack::<Layer<4, 4, 8>, 4, 4, 16>::new();
    let mut window = Stack::<Window<Layer<4, 4, 8>, 16, 2>, 6, 6, 32>::new();
    snapshot
        .lower
        .start(&config(0.4, 4.0, 0.3, SAMPLES), &mut rng);
    snapshot
        .upper
        .start(&config(0.5, 4.0, 0.3, SAMPLES), &mut rng);
    window
        .lower
        .source
        .start(&config(0.4, 4.0, 0.3, SAMPLES), &mut rng);
    window
        .upper
        .start(&config(0.5, 6.0, 0.3, SAMPLES), &mut rng);
    let (mut by_snapshot, mut by_window) = (Vec::new(), Vec::new());
    for t in (0..SAMPLES + 2000).step_by(4) {
        let (start, right) = (rng.below(8), rng.chance(0.5));
        window.forget_context();
        for step in 0..4 {
            // Eight lights in a circle.
            let place = if right {
                start + step
            } else {
                start + 8 - step
            } % 8;
            let light = one_hot(place as usize);
            if t < SAMPLES {
                snapshot.learn(&light, t).unwrap();
                window.learn(&light, t).unwrap();
            } else {
                snapshot.activate(&light).unwrap();
                window.activate(&light).unwrap();
            }
        }
        if t >= SAMPLES {
            by_snapshot.push((snapshot.upper.best_match().node, right));
            by_window.push((window.upper.best_match().node, right));
        }
    }
    let (snapshot, window) = (accuracy(&by_snapshot), accuracy(&by_window));
    assert!((0.35..0.65).contains(&snapshot), "{snapshot}");
    assert!(window > 0.97, "{window}");
}

/// Steps between a cue and the moment that asks for it; each has a symbol of its own.
const WORD: usize = 6;

/// Two cues and the word.
const SYMBOLS: usize = 2 + WORD;

/// What is heard at a step: one of two cues, then the word, the same after both.
fn heard(cue: bool, step: usize) -> [f32; SYMBOLS] {
    one_hot(if step == 0 {
        usize::from(cue)
    } else {
        step + 1
    })
}

/// A layer of 36 nodes that reads a symbol and its own activations of one step before.
type Memory = Recurrent<Stack<Join<Input<SYMBOLS>, Input<36>>, 6, 6, 44>, 36, 1>;

fn memory(rng: &mut Rng, sequences: u32) -> Memory {
    let mut memory = Memory::new();
    memory
        .source
        .upper
        .start(&config(0.4, 3.0, 0.4, sequences), rng);
    memory
}

/// The accuracy of a window of `STEPS` steps, `FEATURES` = `SYMBOLS`·`STEPS`, at the word's end.
fn window_accuracy<const STEPS: usize, const FEATURES: usize>(rng: &mut Rng) -> f32 {
    const SEQUENCES: u32 = 1000;
    let mut window = Stack::<Window<Input<SYMBOLS>, SYMBOLS, STEPS>, 4, 4, FEATURES>::new();
    window.upper.start(&config(0.4, 4.0, 0.4, SEQUENCES), rng);
    let mut seen = Vec::new();
    for t in 0..SEQUENCES + 1000 {
        let cue = rng.chance(0.5);
        window.forget_context();
        for step in 0..=WORD {
            window.activate(&heard(cue, step)).unwrap();
            if t < SEQUENCES {
                window.train(t);
            }
        }
        if t >= SEQUENCES {
            seen.push((window.upper.best_match().node, cue));
        }
    }
    accuracy(&seen)
}

#[test]
fn a_loop_of_one_step_remembers_a_cue_that_no_window_reaches_back_to() {
    const SEQUENCES: u32 = 3000;
    for seed in 0..5 {
        let mut rng = Rng::new(seed);
        let mut memory = memory(&mut rng, SEQUENCES);
        let mut seen = Vec::new();
        for t in 0..SEQUENCES + 1000 {
            let cue = rng.chance(0.5);
            memory.forget_context();
            for step in 0..=WORD {
                memory.activate(&heard(cue, step)).unwrap();
                if t < SEQUENCES {
                    memory.train(t);
                }
            }
            if t >= SEQUENCES {
                seen.push((memory.source.upper.best_match().node, cue));
            }
        }
        assert!(accuracy(&seen) > 0.97, "seed {seed}: {}", accuracy(&seen));
    }
    let mut rng = Rng::new(9);
    let windows = [
        window_accuracy::<1, { SYMBOLS }>(&mut rng),
        window_accuracy::<3, { SYMBOLS * 3 }>(&mut rng),
        window_accuracy::<6, { SYMBOLS * 6 }>(&mut rng),
    ];
    assert!(
        windows.iter().all(|share| (0.4..0.6).contains(share)),
        "{windows:?}"
    );
}

#[test]
fn a_tree_of_a_loop_and_a_window_relates_an_old_cue_to_a_present_movement() {
    const SEQUENCES: u32 = 5000;
    type Motion = Stack<Window<Input<4>, 4, 2>, 4, 4, 8>;
    type Both = Stack<Join<Memory, Motion>, 8, 8, 52>;
    let mut rng = Rng::new(8);
    let mut both = Both::new();
    both.lower.first = memory(&mut rng, SEQUENCES);
    both.lower
        .second
        .upper
        .start(&config(0.5, 4.0, 0.2, SEQUENCES), &mut rng);
    both.upper
        .start(&config(0.5, 8.0, 0.3, SEQUENCES), &mut rng);
    let mut seen = [const { Vec::new() }; 3];
    for t in 0..SEQUENCES + 1000 {
        let (cue, right) = (rng.chance(0.5), rng.chance(0.5));
        both.forget_context();
        for step in 0..=WORD {
            // Four lights in a circle; after six steps either way the same one is on.
            let light = if right { step } else { 4 * WORD - step } % 4;
            both.activate(&(heard(cue, step), one_hot(light))).unwrap();
            if t < SEQUENCES {
                both.train(t);
            }
        }
        if t >= SEQUENCES {
            let join = &both.lower;
            seen[0].push((join.first.source.upper.best_match().node, cue == right));
            seen[1].push((join.second.upper.best_match().node, cue == right));
            seen[2].push((both.upper.best_match().node, cue == right));
        }
    }
    let [memory, motion, both] = seen.map(|seen| accuracy(&seen));
    assert!(
        (0.4..0.6).contains(&memory) && (0.4..0.6).contains(&motion),
        "{memory} {motion}"
    );
    assert!(both > 0.97, "{both}");
}

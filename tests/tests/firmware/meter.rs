//! The cost meter against QEMU: what the host estimates is what the board takes, nearly.

use firmware_example::meter::Part;
use host_sim::device::meter::{Step, Weights, steps, weights_file};
use host_sim::device::target::Target;

use super::budget::{HEAD, Rows, Tolerance, hold};

/// By which share an estimated mean and an estimated worst tick may be off.
const SHARES: [f64; 2] = [0.05, 0.2];

/// Mean and worst of a part of the life.
fn mean_and_worst(steps: &[Step], part: Part, instructions: impl Fn(&Step) -> f64) -> [f64; 2] {
    let of: Vec<f64> = steps
        .iter()
        .filter(|step| step.part == part)
        .map(instructions)
        .collect();
    let mean = of.iter().sum::<f64>() / of.len() as f64;
    [mean, of.iter().copied().fold(0.0, f64::max)]
}

#[test]
fn the_estimated_ticks_are_those_that_qemu_counts() {
    let update = std::env::var_os("UPDATE_BUDGET").is_some();
    let lived = Target::ALL.map(|target| steps(target).unwrap_or_else(|error| panic!("{error}")));
    let weights = if update {
        let fitted = lived.each_ref().map(|steps| Weights::fit(steps));
        let text = serde_json::to_string_pretty(&fitted).expect("numbers");
        std::fs::write(weights_file(), text + "\n").expect("it can be written");
        fitted
    } else {
        Target::ALL.map(Weights::of)
    };
    let (mut rows, mut off) = (Rows::new(), Vec::new());
    for (part, name) in [
        (Part::Level1, "tick at level 1"),
        (Part::Level2, "tick at level 2"),
        (Part::Acting, "tick without training"),
    ] {
        for (index, word) in ["mean", "worst"].into_iter().enumerate() {
            let (mut counted, mut estimated) = (Vec::new(), Vec::new());
            for (steps, weights) in lived.iter().zip(&weights) {
                let truth = mean_and_worst(steps, part, |it| it.instructions)[index];
                let guess = mean_and_worst(steps, part, |it| weights.instructions(&it.cost))[index];
                let share = guess / truth - 1.0;
                if share.abs() > SHARES[index] {
                    off.push(format!("{name}, {word}: off by {:+.1} %", 100.0 * share));
                }
                counted.push(Some(truth as u64));
                estimated.push(Some(guess as u64));
            }
            rows.push((format!("{name}, {word}, counted"), counted));
            rows.push((format!("{name}, {word}, estimated"), estimated));
        }
    }
    hold("estimate", HEAD, &rows, Tolerance::Percent);
    assert!(off.is_empty(), "{off:#?}");
}

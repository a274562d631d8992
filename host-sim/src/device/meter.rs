//! What a brain's steps would cost on a microcontroller, estimated on the host.
//!
//! The core counts what a step touches ([`Cost`]); here each count has a weight in instructions for
//! each processor, fitted to a recorded life that QEMU counted step by step.
//! `UPDATE_BUDGET=1 cargo test -p cla-tests --test firmware -- --test-threads=1` fits them anew.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use cla_core::forager::pioneer;
use cla_core::word::Cost;
use firmware_example::meter::{self, Part};
use firmware_example::trace;
use serde::{Deserialize, Serialize};

use super::board::Build;
use super::target::Target;
use crate::failure::Failure;

/// Numbers of a step that are weighed: a constant, and the counts.
const TERMS: usize = 9;

/// Instructions for each count on one processor, and for a step whatever it touches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Weights {
    /// Every step; may be below 0, because where a brain knows little few schemas apply.
    pub step: f64,
    /// [`Cost::units`].
    pub unit: f64,
    /// [`Cost::weights`].
    pub weight: f64,
    /// [`Cost::moved`].
    pub moved: f64,
    /// [`Cost::patterns`].
    pub pattern: f64,
    /// [`Cost::schemas`].
    pub schema: f64,
    /// [`Cost::items`].
    pub item: f64,
    /// [`Cost::beliefs`].
    pub belief: f64,
    /// [`Cost::habits`].
    pub habit: f64,
}

/// The weights of [`Target::ALL`], in their order.
static WEIGHTS: LazyLock<[Weights; Target::ALL.len()]> = LazyLock::new(|| {
    let text = include_str!("../../data/meter.json");
    serde_json::from_str(text).expect("the committed weights are whole: a test reads them")
});

/// A step as the board and the host lived it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The part of the life.
    pub part: Part,
    /// What QEMU counted.
    pub instructions: f64,
    /// What the core counted.
    pub cost: Cost,
}

impl Weights {
    /// The committed weights of a processor.
    #[must_use]
    pub fn of(target: Target) -> Self {
        WEIGHTS[target as usize]
    }

    /// The estimated instructions of a step.
    #[must_use]
    pub fn instructions(&self, cost: &Cost) -> f64 {
        let terms = terms(cost).into_iter().zip(self.as_terms());
        let sum: f64 = terms.map(|(count, weight)| count * weight).sum();
        sum.max(0.0)
    }

    /// The weights whose squared errors are least.
    ///
    /// A count that would get a weight below 0 says nothing that the others do not, and gets 0.
    #[must_use]
    pub fn fit(steps: &[Step]) -> Self {
        let mut used = [true; TERMS];
        loop {
            let mut equations = [[0.0; TERMS + 1]; TERMS];
            for step in steps {
                let terms = terms(&step.cost);
                for (i, equation) in equations.iter_mut().enumerate() {
                    for (sum, term) in equation.iter_mut().zip(terms) {
                        *sum += terms[i] * term;
                    }
                    equation[TERMS] += terms[i] * step.instructions;
                }
            }
            for i in (0..TERMS).filter(|&i| !used[i]) {
                for equation in &mut equations {
                    equation[i] = 0.0;
                }
                equations[i] = [0.0; TERMS + 1];
            }
            let solution = solved(equations);
            let worst = (1..TERMS).min_by(|&a, &b| solution[a].total_cmp(&solution[b]));
            match worst {
                Some(i) if solution[i] < 0.0 => used[i] = false,
                _ => return Self::from_terms(solution),
            }
        }
    }

    fn as_terms(&self) -> [f64; TERMS] {
        let Self {
            step,
            unit,
            weight,
            moved,
            pattern,
            schema,
            item,
            belief,
            habit,
        } = *self;
        [
            step, unit, weight, moved, pattern, schema, item, belief, habit,
        ]
    }

    fn from_terms(
        [
            step,
            unit,
            weight,
            moved,
            pattern,
            schema,
            item,
            belief,
            habit,
        ]: [f64; TERMS],
    ) -> Self {
        let rounded = |it: f64| (it * 100.0).round() / 100.0;
        Self {
            step: rounded(step),
            unit: rounded(unit),
            weight: rounded(weight),
            moved: rounded(moved),
            pattern: rounded(pattern),
            schema: rounded(schema),
            item: rounded(item),
            belief: rounded(belief),
            habit: rounded(habit),
        }
    }
}

fn terms(cost: &Cost) -> [f64; TERMS] {
    let Cost {
        units,
        weights,
        moved,
        patterns,
        schemas,
        items,
        beliefs,
        habits,
    } = *cost;
    [
        1, units, weights, moved, patterns, schemas, items, beliefs, habits,
    ]
    .map(f64::from)
}

/// The solution of linear equations, each with its right side last; 0 for an unknown that none has.
fn solved(mut equations: [[f64; TERMS + 1]; TERMS]) -> [f64; TERMS] {
    // Counts differ by orders of magnitude; the diagonal of squares says by how many.
    let scale: [f64; TERMS] = core::array::from_fn(|i| equations[i][i].sqrt().max(1.0));
    for (equation, own) in equations.iter_mut().zip(scale) {
        for (cell, scale) in equation.iter_mut().zip(scale.into_iter().chain([1.0])) {
            *cell /= own * scale;
        }
    }
    for i in 0..TERMS {
        let pivot = (i..TERMS).max_by(|&a, &b| {
            let size = |row: usize| equations[row][i].abs();
            size(a).total_cmp(&size(b))
        });
        equations.swap(i, pivot.unwrap_or(i));
        let own = equations[i];
        if own[i].abs() < 1e-9 {
            continue;
        }
        for (row, equation) in equations.iter_mut().enumerate() {
            if row != i {
                let factor = equation[i] / own[i];
                for (cell, own) in equation.iter_mut().zip(own) {
                    *cell -= factor * own;
                }
            }
        }
    }
    core::array::from_fn(|i| {
        let [own, right] = [equations[i][i], equations[i][TERMS]];
        if own.abs() < 1e-9 {
            0.0
        } else {
            right / own / scale[i]
        }
    })
}

/// Lives a life on a board and on the host, and puts both records side by side.
///
/// # Errors
/// [`Failure`] when the program cannot be built or run, or prints something else than it should.
pub fn steps(target: Target) -> Result<Vec<Step>, Failure> {
    let actions = match target {
        Target::M4f => trace::ACTIONS,
        Target::M0 | Target::Riscv => trace::ACTIONS / 10,
    };
    let printed = Build::new(target, "meter").run()?;
    let mut counted = printed.text().lines().map(str::parse::<f64>);
    let mut steps = Vec::new();
    let mut short = false;
    let mut brain = Box::new(pioneer::brain());
    meter::steps(
        &mut brain,
        actions,
        || 0,
        |part, _, cost| match counted.next() {
            Some(Ok(instructions)) => steps.push(Step {
                part,
                instructions,
                cost,
            }),
            _ => short = true,
        },
    )?;
    if short || counted.next().is_some() {
        return Err("the firmware did not count the steps of this life".into());
    }
    Ok(steps)
}

/// Where the committed weights lie.
#[must_use]
pub fn weights_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data/meter.json")
}

/// The largest estimate of a step so far, on each processor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Load {
    worst: [f64; Target::ALL.len()],
}

impl Load {
    /// Takes note of a step.
    pub fn note(&mut self, cost: &Cost) {
        for (worst, target) in self.worst.iter_mut().zip(Target::ALL) {
            *worst = worst.max(Weights::of(target).instructions(cost));
        }
    }

    /// Takes note of all that another has noted.
    pub fn merge(&mut self, other: &Self) {
        for (worst, other) in self.worst.iter_mut().zip(other.worst) {
            *worst = worst.max(other);
        }
    }

    /// Takes note of all that several have noted.
    #[must_use]
    pub fn of<'a>(loads: impl IntoIterator<Item = &'a Self>) -> Self {
        let mut all = Self::default();
        loads.into_iter().for_each(|load| all.merge(load));
        all
    }

    /// The worst step of each processor, by its name; nothing when no step was noted.
    #[must_use]
    pub fn by_processor(&self) -> Vec<(&'static str, u64)> {
        let noted = |&target: &Target| self.worst(target) > 0;
        let targets = Target::ALL.into_iter().filter(noted);
        targets
            .map(|target| (target.name(), self.worst(target)))
            .collect()
    }

    /// Instructions of the worst step, rounded up.
    #[must_use]
    pub fn worst(&self, target: Target) -> u64 {
        self.worst[target as usize].ceil() as u64
    }
}

#[cfg(test)]
mod tests {
    use super::{Load, Part, Step, Target, Weights};
    use cla_core::word::Cost;

    #[test]
    fn weights_are_found_again_from_steps_that_were_made_with_them() {
        let made = Weights {
            step: 900.0,
            unit: 7.5,
            moved: 110.0,
            schema: 14.25,
            ..Weights::default()
        };
        let mut steps: Vec<Step> = (0..200_u32)
            .map(|i| Cost {
                units: 800 * (i % 2),
                weights: 400 * (i % 5),
                moved: i % 31,
                schemas: 300 + 7 * (i % 13),
                ..Cost::default()
            })
            .map(|cost| Step {
                part: Part::Level1,
                instructions: made.instructions(&cost),
                cost,
            })
            .collect();
        assert_eq!(Weights::fit(&steps), made);
        // More weights make it cheaper? Then they explain nothing.
        for step in &mut steps {
            step.instructions -= 0.1 * f64::from(step.cost.weights);
        }
        assert_eq!(Weights::fit(&steps).weight, 0.0);
    }

    #[test]
    fn a_load_keeps_the_worst_step_of_each_processor() {
        let (mut load, mut other) = (Load::default(), Load::default());
        let step = |schemas| Cost {
            schemas,
            ..Cost::default()
        };
        load.note(&step(5_000));
        load.note(&step(10));
        other.note(&step(6_000));
        let before = load.worst(Target::M0);
        load.merge(&other);
        assert!(load.worst(Target::M0) > before && before > load.worst(Target::M4f));
    }
}

//! Modules side by side and one that reads them all: the tree of the studies, of any kind of module.
//!
//! One level trains after the other, on the same stimuli in the same order: what learns from a batch can
//! be no part of a level that trains while the one below it still changes.

use super::module::Module;

/// Two levels.
pub(super) struct Hierarchy {
    /// Each with the number of values that it reads, in the order of the stimulus.
    lower: Vec<(usize, Box<dyn Module>)>,
    top: Box<dyn Module>,
}

/// What a hierarchy answers to a stimulus.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Answer {
    /// The activations of level 1, module by module.
    pub(super) lower: Vec<f32>,
    /// Those of the Top.
    pub(super) top: Vec<f32>,
    /// How new level 1's answer is to the Top.
    pub(super) novelty: f32,
}

/// What a hierarchy holds and computes, all modules together.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Cost {
    /// Bytes while it learns.
    pub(super) bytes: f64,
    /// Multiply-adds to answer a stimulus.
    pub(super) respond: f64,
    /// And to learn one, without answering it.
    pub(super) learn: f64,
}

impl Hierarchy {
    /// A hierarchy of these; the Top must read as many values as all of them have units.
    pub(super) fn new(lower: Vec<(usize, Box<dyn Module>)>, top: Box<dyn Module>) -> Self {
        Self { lower, top }
    }

    /// Learns stimuli, once each.
    pub(super) fn learn(&mut self, stimuli: &[Vec<f32>]) {
        let mut from = 0;
        for (length, module) in &mut self.lower {
            for stimulus in stimuli {
                module.learn(&stimulus[from..from + *length]);
            }
            module.settle();
            from += *length;
        }
        for stimulus in stimuli {
            let joined = self.joined(stimulus);
            self.top.learn(&joined);
        }
        self.top.settle();
    }

    /// What level 1 answers.
    fn joined(&self, stimulus: &[f32]) -> Vec<f32> {
        let units = self.lower.iter().map(|it| it.1.units()).sum();
        let mut joined = vec![0.0; units];
        let (mut from, mut place) = (0, 0);
        for (length, module) in &self.lower {
            let part = &stimulus[from..from + *length];
            module.respond(part, &mut joined[place..place + module.units()]);
            from += *length;
            place += module.units();
        }
        joined
    }

    /// What it answers, without learning.
    pub(super) fn answer(&self, stimulus: &[f32]) -> Answer {
        let lower = self.joined(stimulus);
        let mut top = vec![0.0; self.top.units()];
        let novelty = self.top.respond(&lower, &mut top);
        Answer {
            lower,
            top,
            novelty,
        }
    }

    /// What it costs.
    pub(super) fn cost(&self) -> Cost {
        let mut cost = Cost::default();
        let modules = self.lower.iter().map(|it| &it.1).chain([&self.top]);
        for module in modules {
            let work = module.work();
            cost.bytes += module.bytes() as f64;
            cost.respond += work.respond;
            cost.learn += work.learn;
        }
        cost
    }
}

//! Doubt: how much of what was known survives, weighed by what is seen after an alarm.
//!
//! After an alarm every prediction is doubted: how much of the model of each context and action survives
//! what is seen from then on is weighed by its evidence ([`KnowledgeBase::survival`]), and where it
//! lost its hold each action is imagined to be worth what it is worth where it is worth most.
//! The book leaves this open (7.1.1); bounded memory, no tables of its own.

use super::alarm::SurpriseConfig;
use crate::choice::{ValueConfig, state_of};
use crate::knowledge::{Doubt, Estimate, KnowledgeBase, Others, PatternId, Schema};
use crate::num::{exp, ln};
use crate::snapshot::{LARGEST, bounded};
use crate::word::{ActionId, ItemStates, SchemaText, SignedItems};

/// How strongly an old model may hold: as if it had been seen so many times.
const STRENGTHS: [f32; 3] = [1.0, 10.0, 100.0];
/// How probable each of them is before anything was seen.
const HOLD: [f32; 3] = [0.3, 0.3, 0.4];
/// The least probability of anything, so that nothing is impossible.
const LEAST: f32 = 0.005;
/// Sweeps over all values after each weighing of evidence.
const SWEEPS: u16 = 10;
/// Trials of a context and action at which those of all its schemas count half from then on: the work
/// of weighing them ends, and what the old model was worth has long been decided.
const MOST_TRIALS: u16 = 4096;
/// At every such number of hits of a schema the trials are added up.
const ADDED_UP: u16 = 64;

/// What the evidence since a doubt began says of one context and action.
///
/// In the field: the posterior over three strengths of a Dirichlet prior whose mean is the old model;
/// the new model is their mixture.
#[derive(Clone, Copy, Debug)]
struct Posterior {
    /// The probabilities of the [`STRENGTHS`]; they sum to 1.
    weights: [f32; 3],
    trials: f32,
}

impl Posterior {
    /// The share of the old model in the new one, in `[0, 1]`.
    fn survival(&self) -> f32 {
        let mut survival = 0.0;
        for (weight, strength) in self.weights.iter().zip(STRENGTHS) {
            survival += weight * strength / (strength + self.trials);
        }
        survival
    }

    /// The share of hope, for `optimism` imagined trials.
    fn hope(&self, optimism: f32) -> f32 {
        let mut hope = 0.0;
        for (weight, strength) in self.weights.iter().zip(STRENGTHS) {
            hope += weight * optimism / (strength + self.trials + optimism);
        }
        hope
    }
}

/// Probabilities from logarithms, weighed by a prior.
fn normalized(logs: [f32; 3], prior: [f32; 3]) -> [f32; 3] {
    let mut most = f32::NEG_INFINITY;
    for log in logs {
        if log > most {
            most = log;
        }
    }
    let mut weights = [0.0; 3];
    let mut total = 0.0;
    for ((weight, log), prior) in weights.iter_mut().zip(logs).zip(prior) {
        *weight = prior * exp(log - most);
        total += *weight;
    }
    for weight in &mut weights {
        *weight /= total;
    }
    weights
}

impl<const WORDS: usize, const PATTERNS: usize, const SCHEMAS: usize>
    KnowledgeBase<WORDS, PATTERNS, SCHEMAS>
{
    fn came(&self, schema: &Schema, after: &ItemStates<WORDS>) -> bool {
        let result = self.patterns.get(usize::from(schema.result.0));
        result.is_some_and(|result| result.items.truth(after) == Some(true))
    }

    /// Begins a doubt: every schema notes how reliable it was.
    pub(crate) fn begin_doubt(&mut self) {
        for schema in &mut self.schemas {
            let p = schema.reliability.value(Estimate::Recent);
            schema.doubt = Doubt {
                old: (p * 65_535.0) as u16,
                ..Doubt::default()
            };
        }
    }

    /// In a doubt: what has just been harvested notes how reliable it is held to be, too.
    pub(crate) fn doubt_new(&mut self) {
        for schema in &mut self.schemas {
            if schema.doubt == Doubt::default() {
                let p = schema.reliability.value(Estimate::Recent);
                schema.doubt.old = (p * 65_535.0) as u16;
            }
        }
    }

    /// Ends it: the reliabilities stay as they have become.
    pub(crate) fn end_doubt(&mut self) {
        for schema in &mut self.schemas {
            schema.doubt = Doubt::default();
        }
    }

    /// Counts what happened in a doubt; what no schema says becomes one at once.
    pub(crate) fn count_hits(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) {
        let (mut found, mut any) = (false, false);
        let mut others = Others::none();
        let mut applicable = self.applicable(before, &mut others);
        while let Some(index) = applicable.next(self) {
            let Some(schema) = self.schemas.get(index).copied() else {
                continue;
            };
            if schema.action != action {
                continue;
            }
            any = true;
            if self.came(&schema, after) {
                found = true;
                if let Some(schema) = self.schemas.get_mut(index) {
                    schema.doubt.hits = schema.doubt.hits.saturating_add(1);
                }
                if schema.doubt.hits % ADDED_UP == ADDED_UP - 1 {
                    self.bound_trials(schema.context, action);
                }
            }
        }
        self.count_schemas(applicable.seen());
        if found || !any {
            return;
        }
        let text = SchemaText {
            context: SignedItems::of(before),
            action,
            result: SignedItems::of(after),
        };
        // A full table refuses and counts the loss; the maps remember the transition anyway.
        if let Ok(id) = self.insert(&text, 1, 1)
            && let Some(schema) = self.schemas.get_mut(usize::from(id.0))
        {
            schema.doubt.hits = 1;
        }
    }

    /// Halves the trials of a context and action when they are many.
    fn bound_trials(&mut self, context: PatternId, action: ActionId) {
        let (mut trials, mut schemas) = (0_u32, 0);
        for (_, schema) in self.of_group(context, action) {
            trials = trials.saturating_add(u32::from(schema.doubt.hits));
            schemas += 1;
        }
        self.count_schemas(schemas);
        if trials >= u32::from(MOST_TRIALS) {
            self.change_group(context, action, |schema| schema.doubt.hits /= 2);
        }
    }

    /// The evidence about a context and action, given how strong other models proved.
    fn posterior(&self, context: PatternId, action: ActionId, prior: [f32; 3]) -> Posterior {
        let mut logs = [0.0; 3];
        let mut trials = 0_u16;
        for (_, schema) in self.of_group(context, action) {
            let Doubt { old, hits, .. } = schema.doubt;
            // An image can hold more, and a context with more than sixty results.
            let hits = hits.min(2 * MOST_TRIALS - trials);
            let p = f32::from(old) / 65_535.0;
            let p = if p > LEAST { p } else { LEAST };
            for (log, strength) in logs.iter_mut().zip(STRENGTHS) {
                for hit in 0..hits {
                    *log += ln(strength * p + f32::from(hit));
                }
            }
            trials += hits;
        }
        for (log, strength) in logs.iter_mut().zip(STRENGTHS) {
            for trial in 0..trials {
                *log -= ln(strength + f32::from(trial));
            }
        }
        Posterior {
            weights: normalized(logs, prior),
            trials: f32::from(trials),
        }
    }

    /// How much of what was known of a context and action survives the evidence, in `[0, 1]`; 1
    /// when nothing is doubted.
    #[must_use]
    pub fn survival(&self, context: PatternId, action: ActionId) -> f32 {
        self.posterior(context, action, HOLD).survival()
    }

    /// How many observations of a context and action still count: those of a doubt, and as many
    /// older ones as the evidence lets the old model be worth, 1 to 100.
    pub(crate) fn hold(&self, context: PatternId, action: ActionId) -> f32 {
        let posterior = self.posterior(context, action, HOLD);
        let mut strength = 0.0;
        for (weight, of) in posterior.weights.iter().zip(STRENGTHS) {
            strength += weight * of;
        }
        strength + posterior.trials
    }

    /// Rebuilds every doubted reliability from what survives of it and what was seen since.
    pub(crate) fn weigh<const ACTIONS: usize>(
        &mut self,
        config: &SurpriseConfig,
        values: &ValueConfig,
    ) {
        // What became of the models that were tried says what to think of the others.
        let mut prior = HOLD;
        let mut groups = 1.0;
        for index in 0..self.schemas.len() {
            if let Some((context, action)) = self.tried_first(index) {
                let posterior = self.posterior(context, action, HOLD);
                for (sum, weight) in prior.iter_mut().zip(posterior.weights) {
                    *sum += weight;
                }
                groups += 1.0;
            }
        }
        for sum in &mut prior {
            *sum /= groups;
        }
        self.over_groups(|it, context, action| {
            let posterior = it.posterior(context, action, prior);
            it.believe(context, action, &posterior);
        });
        self.settle_values::<ACTIONS>(SWEEPS, values);
        let best = self.best_places::<ACTIONS>(values);
        self.over_groups(|it, context, action| {
            let posterior = it.posterior(context, action, prior);
            let hope = posterior.hope(config.optimism);
            let Some(state) = it.pattern(context) else {
                return;
            };
            let here = it.expected_values::<ACTIONS>(&state_of(&state), values);
            let index = usize::from(action.0);
            if let (Some(here), Some(best)) = (here.get(index), best.get(index)) {
                let gap = best - here.value;
                let bonus = if gap > 0.0 {
                    bounded(hope * gap, LARGEST)
                } else {
                    0.0
                };
                it.change_group(context, action, |schema| schema.doubt.bonus = bonus);
            }
        });
    }

    /// Does something for every context and action that a schema is about.
    fn over_groups(&mut self, mut work: impl FnMut(&mut Self, PatternId, ActionId)) {
        for index in 0..self.schemas.len() {
            if let Some(schema) = self.schemas.get(index).copied()
                && self.first_of(schema.context, schema.action, |_| true) == Some(index)
            {
                work(self, schema.context, schema.action);
            }
        }
    }

    /// What each action is worth where it is worth most.
    fn best_places<const ACTIONS: usize>(&mut self, values: &ValueConfig) -> [f32; ACTIONS] {
        let mut best = [0.0; ACTIONS];
        for index in 0..self.patterns.len() {
            let Some(items) = self.patterns.get(index).map(|pattern| pattern.items) else {
                continue;
            };
            let here = self.expected_values::<ACTIONS>(&state_of(&items), values);
            for (best, here) in best.iter_mut().zip(here) {
                if here.value > *best {
                    *best = here.value;
                }
            }
        }
        best
    }

    /// Context and action of a schema, if it is the first of them with a success since the doubt.
    fn tried_first(&self, index: usize) -> Option<(PatternId, ActionId)> {
        let &Schema {
            context, action, ..
        } = self.schemas.get(index)?;
        let first = self.first_of(context, action, |schema| schema.doubt.hits > 0);
        (first == Some(index)).then_some((context, action))
    }

    /// The first schema of a context and action that is so.
    fn first_of(
        &self,
        context: PatternId,
        action: ActionId,
        is: impl Fn(&Schema) -> bool,
    ) -> Option<usize> {
        let mut group = self.of_group(context, action);
        group.find(|(_, schema)| is(schema)).map(|(index, _)| index)
    }

    fn believe(&mut self, context: PatternId, action: ActionId, posterior: &Posterior) {
        let survival = posterior.survival();
        self.change_group(context, action, |schema| {
            schema.doubt.bonus = 0.0;
            let old = f32::from(schema.doubt.old) / 65_535.0;
            let seen = if posterior.trials > 0.0 {
                (f32::from(schema.doubt.hits) / posterior.trials).min(1.0)
            } else {
                0.0
            };
            schema
                .reliability
                .revise(survival * old + (1.0 - survival) * seen);
        });
    }
}

#[cfg(test)]
#[path = "doubt_tests.rs"]
mod tests;

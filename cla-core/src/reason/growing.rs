//! A context that grows over several ticks: one sample of the memory at a time.
//!
//! The rule is that of `growth`: begin with the item's own state before; while remembered samples
//! contradict, add the signed item of the seed that rules out contradictions at the least loss of
//! agreement; then take out what is not needed.
//! Where it stands is kept in fixed memory, so that a call does as many units as it is given.

use super::experience::Experience;
use crate::growth::{Attention, Evidence, GrowthConfig, SimpleSchema, Tally, gain};
use crate::snapshot::{stored, stored_codes};
use crate::word::{ActionId, ItemId, ItemSet, SchemaText, SignedItems};

/// Items counted in a unit of work.
const COUNTED: u32 = 3;

/// What is being done.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Phase {
    Rest,
    /// What contradicts, and which items would rule it out.
    Counting,
    /// Which items of the context can be done without.
    Pruning,
}

/// Where growing stands after some work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Growth {
    /// There is more to do.
    Underway,
    /// A context that the samples do not contradict.
    Grown(SimpleSchema),
    /// No context of seven items explains it.
    Unexplained,
}

/// One context, and the counts that it grows by.
#[derive(Clone, Debug)]
pub(super) struct Growing<const WORDS: usize> {
    phase: Phase,
    action: u8,
    sign: bool,
    item: ItemId,
    tolerance: f32,
    /// The next sample to look at.
    at: u16,
    seed: Experience<WORDS>,
    eligible: ItemSet<WORDS>,
    context: SignedItems<WORDS>,
    attention: Attention<WORDS>,
    tally: Tally,
    /// Of agreeing and contradicting samples, those that an item would leave out; while pruning,
    /// those that would come in without it.
    agree: [[u16; 32]; WORDS],
    contradict: [[u16; 32]; WORDS],
}

impl<const WORDS: usize> Growing<WORDS> {
    pub(super) const fn new() -> Self {
        Self {
            phase: Phase::Rest,
            action: 0,
            sign: false,
            item: ItemId(0),
            tolerance: 0.0,
            at: 0,
            seed: Experience::UNKNOWN,
            eligible: ItemSet::EMPTY,
            context: SignedItems::EMPTY,
            attention: Attention::NONE,
            tally: Tally {
                agree: 0,
                contradict: 0,
            },
            agree: [[0; 32]; WORDS],
            contradict: [[0; 32]; WORDS],
        }
    }

    pub(super) const fn rests(&self) -> bool {
        matches!(self.phase, Phase::Rest)
    }

    pub(super) const fn action(&self) -> u8 {
        self.action
    }

    pub(super) const fn stop(&mut self) {
        self.phase = Phase::Rest;
    }

    /// Begins to explain what became of an item; only `eligible` items may stand in the context.
    ///
    /// Nothing begins where nobody knows what became of it.
    pub(super) fn begin(
        &mut self,
        action: u8,
        seed: &Experience<WORDS>,
        item: ItemId,
        eligible: &ItemSet<WORDS>,
        schemas: &[SimpleSchema],
        tolerance: f32,
    ) {
        let Some(sign) = seed.outcome(item) else {
            return;
        };
        self.action = action;
        self.sign = sign;
        self.item = item;
        self.tolerance = tolerance;
        self.seed = *seed;
        self.eligible = eligible.intersection(&seed.before.known());
        self.context = SignedItems::EMPTY;
        if self.eligible.contains(item) {
            let _ = self.context.insert(item, seed.before.on().contains(item));
        }
        self.attention = Attention::of(ActionId(action.into()), schemas);
        self.start(Phase::Counting);
    }

    fn start(&mut self, phase: Phase) {
        self.phase = phase;
        self.at = 0;
        if phase == Phase::Counting {
            self.tally = Tally::default();
        }
        self.agree = [[0; 32]; WORDS];
        self.contradict = [[0; 32]; WORDS];
    }

    /// Looks at one sample more, or draws a conclusion from all; and the units that it took.
    pub(super) fn step(
        &mut self,
        samples: &[Experience<WORDS>],
        config: &GrowthConfig,
    ) -> (Growth, u32) {
        if self.rests() {
            return (Growth::Unexplained, 1);
        }
        if let Some(sample) = samples.get(usize::from(self.at)) {
            self.at += 1;
            return (Growth::Underway, 1 + self.count(sample) / COUNTED);
        }
        match self.phase {
            Phase::Counting => (self.extend(config), u32::from(self.eligible.len())),
            _ => (self.shorten(), 4),
        }
    }

    /// What a context lacks in a sample to apply to it.
    fn lacks(&self, sample: &Experience<WORDS>) -> ItemSet<WORDS> {
        let on = self.context.positive().difference(sample.before.on());
        on.union(&self.context.negative().difference(sample.before.off()))
    }

    fn count(&mut self, sample: &Experience<WORDS>) -> u32 {
        let lacks = self.lacks(sample);
        let counted = match self.phase {
            Phase::Counting if lacks.is_empty() => {
                let used = self.context.positive().union(self.context.negative());
                let open = self.eligible.difference(&used);
                open.difference(&self.seed.shared(sample))
            }
            Phase::Pruning if lacks.len() == 1 => lacks,
            _ => return 0,
        };
        let Some(outcome) = sample.outcome(self.item) else {
            return 0;
        };
        let agrees = outcome == self.sign;
        if self.phase == Phase::Counting {
            let side = if agrees {
                &mut self.tally.agree
            } else {
                &mut self.tally.contradict
            };
            *side = side.saturating_add(1);
        }
        let counts = if agrees {
            &mut self.agree
        } else {
            &mut self.contradict
        };
        let mut items = 0;
        for item in counted.iter() {
            items += 1;
            if let Some(count) = counts.as_flattened_mut().get_mut(usize::from(item.0)) {
                *count = count.saturating_add(1);
            }
        }
        items
    }

    fn counted(&self, item: ItemId) -> Tally {
        let count = |counts: &[[u16; 32]; WORDS]| {
            let counts = counts.as_flattened();
            counts.get(usize::from(item.0)).copied().unwrap_or(0)
        };
        Tally {
            agree: count(&self.agree),
            contradict: count(&self.contradict),
        }
    }

    fn accepts(&self, tally: Tally) -> bool {
        let all = f32::from(tally.agree) + f32::from(tally.contradict);
        f32::from(tally.contradict) <= self.tolerance * all
    }

    /// All samples are counted: one item more, or pruning.
    fn extend(&mut self, config: &GrowthConfig) -> Growth {
        if self.accepts(self.tally) {
            if self.tally.agree < config.support {
                return self.give_up();
            }
            self.start(Phase::Pruning);
            return Growth::Underway;
        }
        let full = usize::from(self.context.len()) >= SimpleSchema::CONTEXT_ITEMS;
        match self.best_item(config).filter(|_| !full) {
            Some(item) => {
                let on = self.seed.before.on().contains(item);
                let _ = self.context.insert(item, on);
                self.start(Phase::Counting);
                Growth::Underway
            }
            None => self.give_up(),
        }
    }

    const fn give_up(&mut self) -> Growth {
        self.phase = Phase::Rest;
        Growth::Unexplained
    }

    /// The item of the seed whose state rules out contradictions at the least loss of agreement.
    fn best_item(&self, config: &GrowthConfig) -> Option<ItemId> {
        let used = self.context.positive().union(self.context.negative());
        let mut best: Option<(f32, ItemId)> = None;
        for item in self.eligible.difference(&used).iter() {
            let out = self.counted(item);
            if out.contradict == 0 {
                continue;
            }
            let left = Tally {
                agree: self.tally.agree.saturating_sub(out.agree),
                contradict: self.tally.contradict.saturating_sub(out.contradict),
            };
            let weight = if self.seed.before.on().contains(item) {
                1.0
            } else {
                config.negatives
            };
            let familiar = self.attention.weight(item, config.attention);
            let gain = weight * familiar * gain(self.tally, left, config.generality);
            if gain > best.map_or(0.0, |(other, _)| other) {
                best = Some((gain, item));
            }
        }
        best.map(|(_, item)| item)
    }

    /// Takes out one item that the samples do not need, negatives first; a schema when all are needed.
    fn shorten(&mut self) -> Growth {
        let context = self.context;
        let items = context.negative().iter().chain(context.positive().iter());
        for item in items {
            let more = self.counted(item);
            let without = Tally {
                agree: self.tally.agree.saturating_add(more.agree),
                contradict: self.tally.contradict.saturating_add(more.contradict),
            };
            if self.accepts(without) {
                self.context.remove(item);
                self.tally = without;
                self.start(Phase::Pruning);
                return Growth::Underway;
            }
        }
        self.phase = Phase::Rest;
        match self.schema() {
            Some(schema) => Growth::Grown(schema),
            None => Growth::Unexplained,
        }
    }

    fn schema(&self) -> Option<SimpleSchema> {
        let mut result = SignedItems::EMPTY;
        result.insert(self.item, self.sign).ok()?;
        let mut schema = SimpleSchema::pack(&SchemaText {
            context: self.context,
            action: ActionId(self.action.into()),
            result,
        })?;
        let Tally { agree, contradict } = self.tally;
        schema.begin_with(agree, agree.saturating_add(contradict));
        Some(schema)
    }
}

stored_codes!(Phase {
    0: (Self::Rest),
    1: (Self::Counting),
    2: (Self::Pruning)
});
stored! {
    impl[const WORDS: usize] Growing<WORDS> {
        phase, action, sign, item, tolerance, at, seed, eligible, context, attention, tally, agree,
        contradict
    }
}

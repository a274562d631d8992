//! Accommodation in parts: what an action did tests its schemas, and what nobody foresaw grows new ones
//! a few units at a time.

use super::experience::Experience;
use super::growing::{Growing, Growth};
use super::record::{MATURE, Record};
use super::table::Table;
use crate::growth::{Entry, Evidence, GrowthConfig, Reservoir, SimpleSchema};
use crate::num::Rng;
use crate::snapshot::{Reader, Stored, Writer, stored};
use crate::word::{ActionId, ItemId, ItemSet, ItemStates};

/// Remembered samples that are looked at again for each action, while something is unforeseen there.
const REVISITS: u8 = 16;
/// While a reservoir has room, a change whose explanations have fewer successes is explained twice.
const UNTESTED: u16 = 8;
/// Schemas passed in a unit of work.
pub(super) const PASSED: u32 = 2;

/// The schemas of all actions, and what they grow from.
#[derive(Clone, Debug)]
pub(super) struct Accommodating<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
> {
    pub(super) table: Table<SCHEMAS, ACTIONS>,
    reservoirs: [Reservoir<WORDS, SAMPLES, Experience<WORDS>>; ACTIONS],
    records: [Record; ACTIONS],
    growing: Growing<WORDS>,
    /// The last action, and its changes that wait for an explanation, or for another one.
    newest: Experience<WORDS>,
    action: u8,
    open: ItemSet<WORDS>,
    again: ItemSet<WORDS>,
    revisits: u8,
    /// Whether schemas came or went since somebody asked.
    news: bool,
    rng: Rng,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
> Accommodating<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS>
{
    pub(super) const fn new() -> Self {
        Self {
            table: Table::new(),
            reservoirs: [const { Reservoir::new() }; ACTIONS],
            records: [Record::NEW; ACTIONS],
            growing: Growing::new(),
            newest: Experience::UNKNOWN,
            action: 0,
            open: ItemSet::EMPTY,
            again: ItemSet::EMPTY,
            revisits: 0,
            news: false,
            rng: Rng::UNSEEDED,
        }
    }

    pub(super) fn begin(&mut self, seed: u64) {
        self.table.clear();
        for reservoir in &mut self.reservoirs {
            reservoir.clear();
        }
        self.records = [Record::NEW; ACTIONS];
        self.growing.stop();
        self.open = ItemSet::EMPTY;
        self.again = ItemSet::EMPTY;
        self.revisits = 0;
        self.news = false;
        self.rng = Rng::stream(seed, 11);
    }

    /// How often an action does not do what it mostly does.
    pub(super) fn noise(&self, action: ActionId) -> f32 {
        let record = self.records.get(usize::from(action.0));
        record.map_or(0.0, Record::noise)
    }

    /// Whether schemas came or went since this was asked last.
    pub(super) const fn take_news(&mut self) -> bool {
        let news = self.news;
        self.news = false;
        news
    }

    /// Whether a context grows or waits.
    pub(super) fn pending(&self) -> bool {
        !self.growing.rests()
            || !self.open.is_empty()
            || !self.again.is_empty()
            || self.revisits > 0
    }

    /// Tests the schemas and files the sample; what nobody foresaw waits for an explanation.
    pub(super) fn compare(&mut self, action: ActionId, sample: &Experience<WORDS>) {
        let noise = self.noise(action);
        // Three times the failures that the action's own record excuses.
        let keep = 1.0 - 3.0 * noise;
        let mut foreseen = ItemSet::<WORDS>::EMPTY;
        let mut tested = ItemSet::<WORDS>::EMPTY;
        let (mut failed, mut held, mut betrayed) = (0_u16, 0_u16, 0_u16);
        let mut dropped = false;
        self.table.record(action, sample, |schema, success| {
            let before = schema.successes().saturating_sub(u16::from(success));
            if before >= MATURE {
                held += u16::from(success);
                betrayed += u16::from(!success);
            }
            if success {
                let _ = foreseen.insert(schema.result_item());
                if schema.successes() >= UNTESTED {
                    let _ = tested.insert(schema.result_item());
                }
                return true;
            }
            failed = failed.saturating_add(1);
            let failures = schema.activations().saturating_sub(schema.successes());
            let kept = noise > 0.0 && (failures <= 1 || schema.reliability() >= keep);
            dropped |= !kept;
            kept
        });
        self.news |= dropped;
        let telling = sample.telling();
        self.open = telling.difference(&foreseen);
        let hardness = failed.saturating_add(self.open.len());
        let index = usize::from(action.0);
        if let (Some(reservoir), Some(record)) =
            (self.reservoirs.get_mut(index), self.records.get_mut(index))
        {
            if held + betrayed > 0 {
                record.trust(betrayed > held);
            }
            let known = reservoir.samples().iter().find(|old| old.began_as(sample));
            if let Some(known) = known {
                record.repeat(known.differs(sample));
            }
            let hardness = u8::try_from(hardness).unwrap_or(u8::MAX);
            reservoir.offer(sample, hardness, &mut self.rng);
            let roomy = reservoir.samples().len() < SAMPLES;
            self.again = if roomy {
                telling.intersection(&foreseen).difference(&tested)
            } else {
                ItemSet::EMPTY
            };
        }
        self.newest = *sample;
        self.action = action.0 as u8;
        self.revisits = REVISITS;
    }

    /// A part of the work on contexts; 0 units when there is none.
    pub(super) fn grow(&mut self) -> u32 {
        if !self.growing.rests() {
            return self.grow_on();
        }
        let first = |items: &ItemSet<WORDS>| items.iter().next();
        let everything = ItemSet::first(ITEMS as u16);
        if let Some(item) = first(&self.open) {
            self.open.remove(item);
            let (action, seed) = (self.action, self.newest);
            return self.explain(action, &seed, item, &everything);
        }
        if let Some(item) = first(&self.again) {
            self.again.remove(item);
            let (action, seed) = (self.action, self.newest);
            let eligible = self.unnamed(action, &seed, item);
            return self.explain(action, &seed, item, &eligible);
        }
        let Some(revisits) = self.revisits.checked_sub(1) else {
            return 0;
        };
        self.revisits = revisits;
        self.revisit(&everything)
    }

    fn grow_on(&mut self) -> u32 {
        let action = usize::from(self.growing.action());
        let Some(reservoir) = self.reservoirs.get(action) else {
            self.growing.stop();
            return 1;
        };
        let (growth, mut units) = self.growing.step(reservoir.samples(), &GrowthConfig::EXACT);
        if let Growth::Grown(schema) = growth {
            if self.table.enter(schema) == Entry::Stored {
                self.news = true;
            }
            units += self.table.of(action as u8).len() as u32 + SCHEMAS as u32 / 8;
        }
        units
    }

    fn explain(
        &mut self,
        action: u8,
        seed: &Experience<WORDS>,
        item: ItemId,
        eligible: &ItemSet<WORDS>,
    ) -> u32 {
        let schemas = self.table.of(action);
        let tolerance = 2.0 * self.noise(ActionId(action.into()));
        self.growing
            .begin(action, seed, item, eligible, schemas, tolerance);
        4 + schemas.len() as u32 / PASSED
    }

    /// The items that no explanation of a change names.
    fn unnamed(&self, action: u8, seed: &Experience<WORDS>, item: ItemId) -> ItemSet<WORDS> {
        let mut eligible = ItemSet::first(ITEMS as u16);
        for schema in self.table.of(action) {
            let explains = schema.result_item() == item
                && schema.applied(seed)
                && schema.success(seed) == Some(true);
            if explains {
                for (named, _) in schema.context().filter(|&(named, _)| named != item) {
                    eligible.remove(named);
                }
            }
        }
        eligible
    }

    /// Looks at a remembered sample again: a change that no schema foresees grows one.
    fn revisit(&mut self, everything: &ItemSet<WORDS>) -> u32 {
        // Half of them are of the last action, half of any.
        let action = if self.revisits.is_multiple_of(2) {
            self.action
        } else {
            self.rng.below(ACTIONS as u32) as u8
        };
        let Some(reservoir) = self.reservoirs.get(usize::from(action)) else {
            return 1;
        };
        let samples = reservoir.samples();
        let which = self.rng.below(samples.len() as u32) as usize;
        let Some(seed) = samples.get(which).copied() else {
            return 1;
        };
        let units = 2 + self.table.of(action).len() as u32 / PASSED;
        let open = seed
            .telling()
            .difference(&self.table.foreseen(action, &seed));
        let which = self.rng.below(u32::from(open.len())) as usize;
        match open.iter().nth(which) {
            Some(item) => units + self.explain(action, &seed, item, everything),
            None => units,
        }
    }
}

stored! {
    impl[
        const WORDS: usize,
        const ITEMS: usize,
        const ACTIONS: usize,
        const SAMPLES: usize,
        const SCHEMAS: usize
    ]
    Accommodating<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS> {
        table, reservoirs, records, growing, newest, action, open, again, revisits, news, rng
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
> Accommodating<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS>
{
    /// Drops schemas that cannot be so and stops a context of an action that there is not; answers how
    /// many.
    pub(super) fn audit(&mut self) -> u32 {
        let (dropped, moved) = self.table.audit();
        self.news |= dropped > 0 || moved;
        let lost = !self.growing.rests() && usize::from(self.growing.action()) >= ACTIONS;
        if lost {
            self.growing.stop();
        }
        dropped + u32::from(moved) + u32::from(lost)
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
> Accommodating<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS>
{
    /// Writes schemas, records and samples.
    pub(super) fn carry(&self, to: &mut Writer<'_>) {
        (self.table.all().len() as u16).store(to);
        for schema in self.table.all() {
            schema.store(to);
        }
        for (record, reservoir) in self.records.iter().zip(&self.reservoirs) {
            record.store(to);
            reservoir.carry(to);
        }
    }

    /// Reads them from one of so many words and actions, over what is there if there is anybody.
    pub(super) fn take(
        mut into: Option<&mut Self>,
        (words, actions): (usize, usize),
        from: &mut Reader<'_>,
    ) {
        for _ in 0..from.count("schemas", SCHEMAS) {
            let mut schema = SimpleSchema::BLANK;
            schema.restore(from);
            if from.is_wrong() {
                return;
            }
            if let Some(it) = &mut into {
                // They stood beside each other by themselves, so none covers another.
                let _ = it.table.enter(schema);
            }
        }
        for action in 0..actions {
            let mut record = Record::NEW;
            record.restore(from);
            if let Some(place) = into.as_mut().and_then(|it| it.records.get_mut(action)) {
                *place = record;
            }
            let samples = from.count("remembered samples of an action", SAMPLES);
            for _ in 0..samples {
                let (before, after) =
                    (ItemStates::take(words, from), ItemStates::take(words, from));
                let mut hardness = 0;
                hardness.restore(from);
                if from.is_wrong() {
                    return;
                }
                let place = into.as_mut().and_then(|it| it.reservoirs.get_mut(action));
                if let Some(place) = place {
                    place.put(Experience { before, after }, hardness);
                }
            }
        }
        if let Some(it) = into {
            it.news = true;
        }
    }
}

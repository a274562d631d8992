#![no_std]
#![no_main]
//! Proof by linking that the core has no panic path: its panic handler calls a function that does
//! not exist.
//!
//! `ENTRY=choose cargo build --release --bin panic_free` links one public entry point, without
//! `ENTRY` all of them at once; the test `panic_free` in `../../tests` builds it at opt-level 3 and s.
//! It is never run, and what it links is also what the budget counts as the core's code.

#[macro_use]
mod proof;
mod kept;

use core::fmt::Write;
use core::hint::black_box;

use cla_core::adaptation::*;
use cla_core::agent::*;
use cla_core::check::{Config, ConfigError};
use cla_core::choice::*;
use cla_core::flash::{
    Fault, FlashCounts, FlashStore, FlashTiming, LayoutError, RamFlash, ResumeError, SaveCost,
    Saved, StoreError,
};
use cla_core::forager::pioneer::{
    Action, Brain, Item, Percept, VOCABULARY, be_born, goal, percept,
};
use cla_core::forager::small;
use cla_core::forest::{self, Actions, Deliberation, MindConfig, MindError};
use cla_core::growth::*;
use cla_core::knowledge::*;
use cla_core::layer::overload::{
    MatchDistance, OverloadDetector, Response, TotalActivation, Transitions,
};
use cla_core::layer::*;
use cla_core::level2::*;
use cla_core::map::*;
use cla_core::num::{Neighbourhood, Rng, Schedule, ScheduleError, exp, ln, sqrt};
use cla_core::reason::{Prospects, Pursuit, Reason as Faculty, Way};
use cla_core::snapshot::{
    self, Audit, LoadError, Names, SaveError, Scrub, SinkFull, SliceSink, SourceEnd,
};
use cla_core::som::*;
use cla_core::word::*;
use embedded_storage::nor_flash::NorFlashErrorKind;
use kept::crab;

type Agent6 = Brain;
type Binary = BinarySom<20, 20, 7>;
type Bytes = ByteSom<12, 12, 7>;
type Dense = DenseSom<6, 6, 4>;
type Near<const N: usize> = Neighbourhood<N, N>;
type Tables = KnowledgeBase<1, 128, 1024>;
type Mind = Accommodation<3, 32, 200, 10>;
type Forest = forest::Mind<1, 7, 6, 448, 200, 512, 512, 2048>;
type Plans = Planner<3, 76, 100>;
type Reasoning = Faculty<3, 76, 10, 32, 200, 100>;
type Thinker = forest::Mind<3, 76, 10, 32, 64, 64, 64, 64, Reasoning>;
type Items3 = ItemSet<3>;
type Reified = SyntheticItems<3, 16>;
type Maps = SomLevel<1, 7, 2, 39, 6, 6, 6, 128, 512>;
type Signed = SignedItems<3>;
type Hierarchy = Stack<Join<Layer<4, 4, 3>, Delayed<Input<2>, 2, 3>>, 3, 3, 18>;
type Sliding = Window<Layer<3, 3, 2>, 9, 3>;
type Loop = Recurrent<Stack<Join<Input<2>, Input<16>>, 4, 4, 18>, 16, 1>;

type Memory<'a> = RamFlash<'a, 4, 4096>;
type Store<'a> = FlashStore<Memory<'a>, 2>;

/// Where displayed text goes.
struct Nowhere(u32);

impl Write for Nowhere {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        self.0 = self.0.wrapping_add(text.len() as u32);
        Ok(())
    }
}

entries! {
    sets {
        // What a robot needs that only acts, and what one needs that learns.
        "acting" = ["choose", "knowledge_record", "improve_values"],
        "training" = ["be_born", "reconfigure", "choose", "learn", "observe", "act"],
        // The same with its life in flash, looked through before each save.
        "keeping" = [
            "be_born", "reconfigure", "choose", "learn", "observe", "act", "flash_open", "flash_save",
            "flash_resume", "audited",
        ],
    }
    "control" (slice: &[u8], index: usize) -> u8 { slice[index] }

    "exp" (x: f32) -> f32 { exp(x) }
    "ln" (x: f32) -> f32 { ln(x) }
    "sqrt" (x: f32) -> f32 { sqrt(x) }
    "rng" (seed: u64, bound: u32, p: f32) -> (u64, u32, f32, bool) {
        let mut rng = Rng::stream(seed, seed);
        (rng.next_seed(), rng.below(bound) ^ rng.next_u32(), rng.unit(), rng.chance(p) ^ (Rng::new(seed) == rng))
    }
    "neighbourhood" (sigma: f32, cut: f32, dx: usize, dy: usize) -> Option<f32> {
        let near = Near::<20>::gaussian(sigma, cut).ok()?;
        Some(near.weight(dx, dy) + near.horizontal_radius() as f32)
    }
    "schedule" (it: &Schedule, samples: u32) -> f32 { it.at(samples) }
    "schedules" (from: f32, to: f32, steps: u32) -> [Result<Schedule, ScheduleError>; 4] {
        [
            Schedule::constant(from),
            Schedule::linear(from, to, steps),
            Schedule::geometric(from, to, steps),
            Schedule::decay(from, to, to),
        ]
    }

    "dense_randomize" (som: &mut Dense, rng: &mut Rng) { som.randomize(rng) }
    "dense_best_match" (som: &Dense, x: &[f32; 4]) -> Result<BestMatch, StimulusError> {
        som.best_matching_unit(x)
    }
    "dense_train" (som: &mut Dense, x: &[f32; 4], winner: NodeId, near: &Near<6>, alpha: f32) {
        som.train(x, winner, alpha, near)
    }
    "quality" (som: &Dense, x: &[[f32; 4]]) -> Option<f32> {
        Some(quantization_error(som, x.iter()).ok()? + topographic_error(som, x.iter()).ok()?)
    }
    "binary_randomize" (som: &mut Binary, rng: &mut Rng) { som.randomize(rng) }
    "binary_distances" (
        som: &Binary, x: &SparseStimulus<'_>, factor: f32,
        scratch: &mut Grid<f32, 20, 20>, out: &mut Grid<f32, 20, 20>,
    ) { som.add_squared_distances(x, factor, scratch, out) }
    "binary_train" (
        som: &mut Binary, x: &SparseStimulus<'_>, winner: NodeId, alpha: f32, near: &Near<20>,
    ) { som.train(x, winner, alpha, near, |node| node != winner) }
    "binary_imprint" (som: &mut Binary, x: &SparseStimulus<'_>, node: NodeId) -> f32 {
        som.imprint(x, node);
        som.weight(node, node.0)
    }
    "byte_randomize" (som: &mut Bytes, rng: &mut Rng) { som.randomize(rng) }
    "byte_distances" (
        som: &Bytes, x: &SparseStimulus<'_>, factor: f32,
        scratch: &mut Grid<f32, 12, 12>, out: &mut Grid<f32, 12, 12>,
    ) { som.add_squared_distances(x, factor, scratch, out) }
    "byte_train" (
        som: &mut Bytes, x: &SparseStimulus<'_>, winner: NodeId, alpha: f32, near: &Near<12>,
    ) { som.train(x, winner, alpha, near, |node| node != winner) }
    "byte_imprint" (som: &mut Bytes, x: &SparseStimulus<'_>, node: NodeId) -> f32 {
        som.imprint(x, node);
        som.weight(node, node.0)
    }
    "binary_squared_distances" (
        som: &Binary, x: &SparseStimulus<'_>, scratch: &mut Grid<f32, 20, 20>, out: &mut Grid<f32, 20, 20>,
    ) { som.squared_distances(x, scratch, out) }
    "dense_squared_distances" (
        som: &Dense, x: &[f32; 4], out: &mut Grid<f32, 6, 6>,
    ) -> Result<(), StimulusError> { som.squared_distances(x, out) }
    "stimulus" (x: &SparseStimulus<'_>, feature: u16) -> bool {
        x.is_unknown(feature) ^ (x.minus().count() > 3)
    }
    "best_match" (distances: &Grid<f32, 20, 20>) -> BestMatch { best_match(distances) }
    "position" (grid: &Grid<f32, 20, 20>, node: NodeId) -> (usize, usize) { grid.position(node) }

    "layer" (
        layer: &mut Layer<4, 4, 3>, config: &LayerConfig, rng: &mut Rng, x: &[f32; 3], t: u32,
    ) -> Result<Response, StimulusError> {
        layer.start(config, rng);
        layer.configure(config);
        layer.activate(x)?;
        layer.train(t);
        Ok(Response { total_activation: layer.total_activation(), ..layer.response() })
    }
    "hierarchy" (
        it: &mut Hierarchy, x: &<Hierarchy as Structure>::Sensors, t: u32,
    ) -> Result<(), StimulusError> {
        it.forget_context();
        it.learn(x, t)
    }
    "window" (it: &mut Sliding, x: &<Sliding as Structure>::Sensors, t: u32) -> Result<(), StimulusError> {
        it.learn(x, t)
    }
    "recurrent" (it: &mut Loop, x: &[f32; 2], t: u32) -> Result<(), StimulusError> {
        it.learn(x, t)
    }
    "delay" (it: &mut DelayLine<9, 4>, x: &[f32; 9], age: usize) -> Option<f32> {
        it.clear();
        it.push(x);
        let _ = it.oldest();
        it.tap(age)?.first().copied()
    }
    "composite" (
        it: &mut ActivationComposite<4, 4>, x: &Grid<f32, 4, 4>, others: &[&ActivationComposite<4, 4>],
    ) -> f32 {
        it.add(x);
        let alone = it.isolate(others);
        alone.difference(it) + alone.total() + f32::from(alone.nodes_above(0.5))
    }
    "total_activation" (it: &mut TotalActivation, x: &Response) -> bool {
        it.record(x);
        it.overloaded(x) ^ it.minimum().is_none()
    }
    "match_distance" (it: &mut MatchDistance<6, 6>, x: &Response) -> bool {
        it.record(x);
        it.overloaded(x)
    }
    "transitions" (it: &mut Transitions<6, 6, 2>, x: &Response) -> bool {
        it.record(x);
        it.overloaded(x) ^ (it.recorded() > 3)
    }
    "fallback" (overloaded: [bool; 3]) -> Option<cla_core::layer::Level> { answering_level(overloaded) }

    "be_born" (brain: &mut Agent6, config: AgentConfig, seed: u64) -> Result<(), ConfigError> {
        config.check()?;
        be_born(brain, config, seed)
    }
    "named" (id: ActionId, on: bool) -> Option<bool> { Action::of(id).and(goal(&[Item::s1], &[Item::bump]).truth(&percept(|_| on))) }
    "be_born_with" (brain: &mut Agent6, config: AgentConfig, seed: u64) -> Result<(), ConfigError> { brain.be_born(config, &[(ItemId(1), 1.0)], seed) }
    "reconfigure" (brain: &mut Agent6, config: AgentConfig) -> Result<(), ConfigError> { brain.reconfigure(config) }
    "choose" (brain: &mut Agent6, now: &Percept) -> Result<Choice, AgentError> { brain.choose(now) }
    "learn" (brain: &mut Agent6, now: &Percept) -> Result<Lesson, AgentError> { brain.learn(now) }
    "observe" (
        brain: &mut Agent6, before: &Percept, action: ActionId, after: &Percept,
    ) -> Result<Lesson, AgentError> { brain.observe(before, action, after) }
    "harvest" (brain: &mut Agent6) { brain.harvest() }
    "cost" (brain: &Agent6, sum: &mut Cost) { sum.add(&brain.cost()) }
    "act" (brain: &mut Agent6, how: Adaptation) -> Result<(), AgentError> { brain.act(how) }
    "maps_of_bytes" (
        brain: &mut small::Brain, config: AgentConfig, seed: u64, now: &Percept, how: Adaptation,
    ) -> Option<Lesson> {
        small::be_born(brain, config, seed).ok()?;
        brain.choose(now).ok()?;
        let lesson = brain.learn(now).ok()?;
        brain.act(how).ok()?;
        Some(lesson)
    }

    "save" (brain: &Agent6, mind: &Forest, to: &mut SliceSink<'_>) -> Result<u32, SaveError<SinkFull>> {
        let length = snapshot::save(brain, VOCABULARY.names(), to)? + snapshot::save(mind, Names::UNKNOWN, to)?;
        Ok(length.min(to.written() as u32))
    }
    "load" (it: &mut Agent6, mind: &mut Forest, from: &mut &[u8]) -> Option<u32> {
        snapshot::load(mind, Names::UNKNOWN, from).ok().or(snapshot::load(it, Names::UNKNOWN, from).ok())
    }
    "length" (brain: &Agent6) -> Option<u32> { snapshot::length(brain).ok() }
    "flash_open" (memory: &mut [u8], start: u32, bytes: u32) -> Result<FlashCounts, LayoutError> {
        let store = Store::open(Memory::new(memory), start, bytes)?;
        let counts = store.counts();
        core::mem::drop(store.release());
        Ok(counts)
    }
    "flash_save" (it: &mut Store<'_>, brain: &Agent6, tick: u32) -> Result<Saved, StoreError<NorFlashErrorKind>> {
        it.save(brain, VOCABULARY.names(), tick)
    }
    "flash_resume" (it: &mut Store<'_>, brain: &mut Agent6) -> Result<u32, ResumeError> {
        let tick = it.resume(brain, VOCABULARY.names())?.tick;
        Ok(tick + it.generation().unwrap_or(it.wear(1)))
    }
    "flash_erase_ahead" (it: &mut Store<'_>) -> Result<u32, Fault<NorFlashErrorKind>> { it.erase_ahead() }
    "flash_cost" (it: &Store<'_>, image: u32, timing: &FlashTiming) -> (SaveCost, u64) {
        let cost = it.cost(image.min(it.capacity()));
        (cost, cost.microseconds(timing))
    }
    "flash_errors" (a: &StoreError<u8>, b: &ResumeError, c: &LayoutError, to: &mut Nowhere) {
        let _ = write!(to, "{a} {b} {c}");
    }
    "audit" (brain: &mut Agent6, to: &mut Nowhere) { let _ = write!(to, "{}", brain.audit()); }
    "audited" (brain: &mut Agent6) -> Audit { brain.audit() }
    "audit_part" (brain: &mut Agent6, mind: &mut Forest, part: usize) -> Audit { kept::audit_in_parts(brain, mind, part) }
    "scrub" (brain: &mut Agent6, it: &mut Scrub<256>) -> bool { kept::sealed(brain, it).is_ok() }
    "save_knowledge" (brain: &Agent6, mind: &Forest, to: &mut SliceSink<'_>) -> bool { kept::known(brain, mind, to).is_ok() }
    "load_knowledge" (it: &mut Agent6, mind: &mut Forest, from: &mut &[u8]) -> bool { kept::taken(it, mind, from).is_ok() }
    "mind_asked" (mind: &Forest, item: ItemId) -> bool { kept::asked(mind, item).2 }
    "health" (brain: &Agent6, mind: &Forest) -> bool { kept::well(brain, mind).iter().any(|it| it.cramped) }
    "in_words" (brain: &mut crab::Brain, now: &crab::Percept) -> Option<crab::Action> { kept::in_words(brain, now) }
    "load_bytes" (it: &mut small::Brain, from: &mut &[u8]) -> Result<u32, LoadError<SourceEnd>> { snapshot::load(it, Names::of(&["a"], &["b"]), from) }
    "say_snapshot" (a: &SaveError<SinkFull>, b: &LoadError<SourceEnd>, to: &mut Nowhere) { let _ = write!(to, "{a}{b}"); }

    "maps" (brain: &Agent6, node: NodeId, item: u16) -> Option<f32> {
        let map = brain.bank().maps().get(usize::from(item))?;
        let weights = map.context_weight(node, item) + map.result_weight(node, item);
        Some(weights + f32::from(map.wins(node)) + map.nodes().count() as f32)
    }
    "harvest_node" (brain: &Agent6, node: NodeId, coding: ResultCoding, config: &HarvestConfig) -> bool {
        let [map, ..] = brain.bank().maps();
        harvest_node::<1, 20, 20, 7, _, _>(map, node, coding, config).is_some()
    }

    "second_level" (
        it: &mut SecondLevel<6, 384, 3072>, tables: &Tables, trace: SyntheticId, action: ActionId,
        schema: SchemaId, values: &ValueConfig, config: &Level2Config,
    ) -> f32 {
        let item = it.most_believed(trace, action).filter(|_| it.items() > 1).unwrap_or(trace);
        let known = it.schema(item).is_some() ^ it.is_overloaded(0.5) ^ it.beliefs().is_empty();
        let evidence = it.tried(trace, action) + it.uses(item) + it.value(item);
        evidence + it.belief(tables, trace, schema, values, config) + f32::from(u8::from(known))
    }
    "knowledge_read" (it: &Tables, pattern: PatternId) -> Option<SignedItems<1>> {
        let found = it.pattern(pattern).or(it.pattern(it.schemas().last()?.context));
        found.filter(|_| it.patterns() > 3)
    }
    "knowledge_values" (it: &mut Tables, now: &Percept, items: &SignedItems<1>, config: &ValueConfig) -> f32 {
        let [first, ..] = it.expected_values::<6>(now, config);
        it.largest_value(items) + it.reward(now) + first.value
    }
    "knowledge_insert" (it: &mut Tables, text: &SchemaText<1>, n: u32) -> Result<SchemaId, TableFull> {
        it.insert(text, n, n)
    }
    "knowledge_record" (
        it: &mut Tables, before: &Percept, action: ActionId, after: &Percept, forgetting: f32,
    ) -> Outcome { it.record(before, action, after, forgetting) }
    "knowledge_text" (it: &Tables, schema: SchemaId) -> Option<SchemaText<1>> { it.text(schema) }
    "mean_reliability" (it: &Tables) -> f32 { it.mean_reliability(Estimate::Recent) }
    "inherent_value" (it: &mut Tables, item: ItemId, value: f32) -> Result<f32, InherentValueError> {
        it.set_inherent_value(item, value)?;
        Ok(it.inherent_value(item))
    }
    "defer_values" (it: &mut Tables, config: &ValueConfig, item: ItemId) -> f32 {
        it.defer_values(config);
        it.deferred_value(item)
    }
    "improve_values" (it: &mut Tables, count: u16, config: &ValueConfig) {
        it.improve_values::<6>(count, config)
    }
    "settle_values" (it: &mut Tables, sweeps: u16, config: &ValueConfig) {
        it.settle_values::<6>(sweeps, config)
    }
    "prefer" (
        it: &mut Tables, now: &Percept, rule: ChoiceRule, config: &ValueConfig,
    ) -> Option<Preference> { it.prefer::<6>(now, rule, config) }
    "habits_worth" (
        it: &Habits<1, 7, 6, 384>, on: &ItemSet<1>, trace: Option<SyntheticId>,
    ) -> [f32; 6] { it.worth(on, trace) }
    "parse" (text: &str, words: &Vocabulary) -> Result<SchemaText<1>, NotationError> {
        SchemaText::parse(text, words)
    }
    "display" (text: &SchemaText<1>, words: &Vocabulary, detail: Detail) -> core::fmt::Result {
        write!(Nowhere(0), "{}", text.display(words, detail))
    }
    "display_errors" (
        agent: AgentError, config: ConfigError, notation: NotationError, item: ItemOutOfRange,
    ) -> core::fmt::Result { write!(Nowhere(0), "{agent} {config} {notation} {item}") }

    "vocabulary" (words: &Vocabulary, name: &str, item: ItemId, action: ActionId) -> bool {
        let known = words.item(name).is_some() || words.action(name).is_some();
        known && words.item_name(item).len() < words.action_name(action).len()
    }

    "item_set" (a: &mut Items3, b: &Items3, item: ItemId) -> Result<u16, ItemOutOfRange> {
        a.insert(item)?;
        *a = a.union(b).difference(&a.intersection(b)).symmetric_difference(&Items3::first(item.0));
        a.remove(item);
        Ok(a.len() + a.iter().count() as u16 + u16::from(a.is_subset(b) ^ a.contains(item)))
    }
    "item_states" (it: &mut ItemStates<3>, item: ItemId, state: Option<bool>) -> Option<bool> {
        it.set(item, state).ok()?;
        it.set_above(item, 0.5, f32::from(item.0)).ok()?;
        let other = ItemStates::<3>::from_sets(&it.known(), ItemStates::<3>::all_off(item.0).off());
        other.get(item).or(it.get(ItemId(item.0 / 2))).filter(|_| it.on().is_disjoint(other.on()))
    }
    "signed_items" (it: &mut Signed, now: &ItemStates<3>, item: ItemId) -> Option<bool> {
        it.insert(item, item.0 > 7).ok()?;
        it.remove(ItemId(item.0 / 2));
        Some(it.truth(now)? ^ it.follows_from(&Signed::EMPTY) ^ (it.len() > 4))
    }
    "base_rates" (it: &mut BaseRates<3>, now: &Items3, rate: f32, items: &Signed) -> Signed {
        it.observe(now);
        items.with_negatives_among(&it.at_least(rate))
    }
    "reliability" (it: &mut Reliability, success: bool, forgetting: f32) -> f32 {
        it.record(success, forgetting);
        it.value(Estimate::Recent) + Reliability::from_counts(1, it.activations()).value(Estimate::Plain)
    }
    "simplify" (text: &SchemaText<3>, samples: &[Transition<3>], growth: &GrowthConfig) -> u32 {
        simplify(text, samples, growth).map(|it| u32::from(it.activations())).fold(0, u32::wrapping_add)
    }
    "reservoir" (it: &mut Reservoir<3, 32>, sample: &Transition<3>, rng: &mut Rng) -> usize {
        it.clear();
        it.offer(sample, 3, rng);
        it.samples().len() + usize::from(sample.changed().len())
    }
    "simple_schema" (
        text: &SchemaText<3>, other: &SimpleSchema, now: &Items3, after: &Items3,
    ) -> Option<SchemaText<3>> {
        let mut it = SimpleSchema::pack(text)?;
        it.record(it.applies(now) && it.succeeds(after));
        (it.says_as(other) ^ it.covers(other) ^ (it.context().count() > 2)).then(|| it.text())
    }
    "simple_schemas" (
        it: &mut SimpleSchemas<100>, new: SimpleSchema, action: ActionId, sample: &HindsightSample<3>,
    ) -> Entry {
        it.record(action, sample, |schema, _| schema.reliability() > 0.5);
        let entry = it.enter(new);
        if it.as_slice().len() > 90 {
            it.clear();
        }
        entry
    }
    "accommodation" (
        it: &mut Mind, action: ActionId, sample: &Transition<3>, config: &AccommodationConfig, rng: &mut Rng,
    ) -> Accommodated {
        if it.schemas().len() > 190 {
            it.clear();
        }
        it.remember(action, sample, rng);
        it.observe(action, sample, config, rng)
    }
    "accommodation_seeded" (
        it: &mut Mind, action: ActionId, sample: &Transition<3>, config: &AccommodationConfig, rng: &mut Rng,
    ) -> Accommodated { it.observe_seeded(action, sample, [*sample], config, rng) }
    "explain" (
        it: &mut Mind, action: ActionId, seed: &Transition<3>, item: ItemId, mode: &Items3, growth: &GrowthConfig,
    ) -> Option<Entry> { it.explain(action, seed, item, mode, growth) }
    "plan" (
        it: &mut Plans, goal: &Signed, on: &Items3, schemas: &[SimpleSchema], config: &PlannerConfig,
    ) -> Option<ActionId> {
        it.see(on);
        it.next_action(goal, on, schemas, config)
    }
    "foresee" (
        it: &mut Plans, goal: &Signed, on: &Items3, schemas: &[SimpleSchema], config: &PlannerConfig,
    ) -> Option<Items3> {
        it.begin();
        it.foresee(goal, on, schemas, config)
    }
    "chain_backward" (
        goal: &Signed, on: &Items3, schemas: &[SimpleSchema], reliable: f32,
    ) -> Option<ActionId> { chain_backward(goal, on, schemas, reliable) }
    "attempt" (goal: Signed, on: Items3, limit: u16) -> Progress<3> {
        let mut attempt = Attempt::begin(goal, on, limit);
        attempt.count_step();
        attempt.progress(&on)
    }
    "train_node" (
        it: &mut ActionSomBank<20, 20, 7, 6>, action: ActionId, sample: &Sample<1>, config: &TrainingConfig,
    ) -> Option<(Trained, NodeId)> { it.train_node(action, sample, config) }
    "redirect" (it: &mut Agent6, action: ActionId) { let _ = it.redirect(action); }
    "set_surprise" (it: &mut Agent6, surprise: Option<SurpriseConfig>) -> Result<(), ConfigError> {
        it.set_surprise(surprise)
    }
    "doubt" (it: &mut Agent6) { it.doubt() }
    "survival" (it: &Tables, context: PatternId, action: ActionId) -> f32 { it.survival(context, action) }
    "hindsight" (
        it: &mut HindsightSample<3>, items: &Reified, sensed: &ItemStates<3>,
    ) -> HindsightSample<3> {
        it.label(sensed);
        HindsightSample::waiting(it.before(), sensed, items)
    }
    "synthetic_items" (
        it: &mut Reified, schema: &SchemaText<3>, sensed: &ItemStates<3>,
    ) -> Result<ItemId, NoRoomForItem> {
        let view = it.view(sensed);
        let known = it.ids().intersection(&it.ruled_out(&view));
        let id = it.reify(schema)?;
        Ok(if known.contains(id) { ItemId(0) } else { id })
    }
    "synthetic_trials" (
        it: &mut Reified, before: &ItemStates<3>, action: ActionId, after: &ItemStates<3>,
    ) -> ItemStates<3> {
        it.try_out(before, action, after);
        it.complete(before, action, after);
        it.revealed(before, action, after)
    }
    "expect" (
        it: &mut Reified, sample: &HindsightSample<3>, action: ActionId, schemas: &[SimpleSchema],
        reliable: f32, trials: u16,
    ) { it.expect(sample, action, schemas, reliable, trials) }
    "evidence" (schema: &SimpleSchema, sample: &HindsightSample<3>) -> Option<bool> {
        schema.success(sample).filter(|_| schema.applied(sample))
    }
    "som_level" (
        it: &mut Maps, tables: &mut Tables, before: &ItemStates<1>, action: ActionId, after: &ItemStates<1>,
        values: &ValueConfig, learning: Learning,
    ) -> SomLevelLosses {
        it.learn(tables, before, action, after, values, learning);
        it.follow(tables);
        it.losses()
    }
    "forest_be_born" (
        it: &mut Forest, config: MindConfig, values: [f32; 7], seed: u64,
    ) -> Result<(), MindError> {
        it.be_born(config, values, seed)?;
        it.act()
    }
    "forest_lives" (
        it: &mut Forest, now: &ItemStates<1>, allowed: Actions, reward: f32,
    ) -> Result<Deliberation, MindError> {
        it.choose(now)?;
        it.learn(now)?;
        let choice = it.choose_among(now, allowed)?;
        it.learn_with(now, reward)?;
        it.observe(now, choice.action, now)?;
        it.interrupt()?;
        Ok(choice)
    }
    "forest_idle" (it: &mut Forest, units: u32) -> bool { it.idle(units) && it.pending() }
    "forest_inspect" (
        it: &Forest, item: ItemId, action: ActionId, voice: forest::Voice,
    ) -> (f32, u16, u32) {
        let mut nodes = 0;
        it.contexts(action, |path, _| nodes += path.len() as u32);
        let (share, blocks) = it.record(voice);
        (it.relevance(item) + share, it.stuck() ^ blocks, it.size().2 ^ nodes)
    }
    "mind_reasons" (it: &mut Thinker, now: &ItemStates<3>, goal: Signed, values: [f32; 76]) -> Option<Way> {
        *it = Thinker::unborn();
        let heard = forest::Heard::DEFAULT.without(forest::Voice::Plans);
        it.be_born(MindConfig { heard, ..MindConfig::DEFAULT }, values, 1).ok()?;
        it.pursue(goal, 9, now).ok()?;
        let choice = it.choose_among(now, Actions::ALL).ok()?;
        it.learn_with(now, 1.0).and_then(|_| it.observe(now, choice.action, now)).ok()?;
        it.interrupt().ok()?;
        it.explain().filter(|_| it.idle(9) || it.pursuit().is_underway())?;
        it.give_up();
        Some(it.way(now)).filter(|_| it.reason().is_settled())
    }
    "reason" (it: &mut Reasoning, now: &ItemStates<3>, goal: Signed, values: [f32; 76], by: ActionId) -> (Pursuit, f32, u32) {
        it.begin(values, 1);
        it.observe(now, by, now, 1.0);
        it.interrupt();
        it.perceive(now);
        it.give_up();
        it.pursue(goal, 9, now);
        let all = it.work(u32::from(it.pending())) ^ it.schemas().len() as u32 ^ it.losses().0;
        (it.pursuit(), it.noise(by) + it.reliability(), all ^ u32::from(it.imagined()))
    }
    "reason_foresees" (it: &Reasoning, now: &ItemStates<3>, by: ActionId) -> (Prospects<10>, Items3, SchemaText<3>) {
        (it.prospects(now), it.predict(now, by), it.explain(now, by))
    }
}

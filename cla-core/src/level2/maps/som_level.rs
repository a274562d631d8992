//! A second level harvested from Action SOMs of its own, as in the book (5.3.1, 6.2.6).
//!
//! Its maps see [primitive items | trace, which schema has just succeeded | primitive items after];
//! what the next action reveals labels the synthetic items after, and each node counts these labels.
//! Nodes are read into level-2 schemas and their counters added up; the level-2 schema that has just
//! succeeded says what to believe.
//! It stands beside an [`Agent`](super::Agent) whose own second level is off.

use super::config::SomLevelConfig;
use super::implication::{Implications, Synthetic};
use super::labels::Labels;
use super::reading::{Bank, read, widened};
use crate::check::{Checked, Config, ConfigError};
use crate::choice::{MOST_A_STEP, Preference, ValueConfig};
use crate::knowledge::{KnowledgeBase, Reliability, SchemaId, SyntheticId};
use crate::map::{ActionSomBank, ResultCoding, Sample, Trained};
use crate::num::Rng;
use crate::som::Grid;
use crate::word::{ActionId, ItemId, ItemStates, SchemaText};

/// What goes on learning at the second level.
///
/// ```
/// use cla_core::level2::Learning;
/// assert_ne!(Learning::Maps, Learning::Counters);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Learning {
    /// Nothing; it only follows what happens.
    Nothing,
    /// The counters of the level-2 schemas that there are, and values.
    Counters,
    /// Maps, items and level-2 schemas too.
    Maps,
}

/// What did not fit, and what was said twice.
///
/// ```
/// assert_eq!(cla_core::level2::SomLevelLosses::default().refused_items, 0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SomLevelLosses {
    /// Successes of schemas that found no room to become items: first come, first served.
    pub refused_items: u32,
    /// Patterns that a full map has forgotten to represent new ones.
    pub displaced_nodes: u32,
    /// Level-2 schemas that found no room.
    pub refused_schemas: u32,
    /// Counters with the lowest count that made room for new ones.
    pub evicted_labels: u32,
    /// Nodes of the last harvest that say nothing about an item's schema.
    pub unread_nodes: u32,
}

impl SomLevelLosses {
    const NONE: Self = Self {
        refused_items: 0,
        displaced_nodes: 0,
        refused_schemas: 0,
        evicted_labels: 0,
        unread_nodes: 0,
    };
}

/// Where the robot is: what has just succeeded.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Here<const WORDS: usize> {
    item: Option<SyntheticId>,
    trace: Option<SyntheticId>,
    node: Option<u16>,
    arrived: ItemStates<WORDS>,
}

/// A second level with maps of `FEATURES` features: `ITEMS` primitive ones and a trace for each
/// synthetic item.
///
/// `WORDS` words hold the primitive items, `WIDE` the features; there are `FEATURES − ITEMS`
/// synthetic items, up to `ROWS` level-2 schemas and `LABELS` counters of nodes and of schemas.
///
/// ```
/// use cla_core::choice::ValueConfig;
/// use cla_core::knowledge::KnowledgeBase;
/// use cla_core::level2::{Learning, SomLevel, SomLevelConfig};
/// use cla_core::num::Rng;
/// use cla_core::word::{ActionId, ItemId, ItemStates};
/// let mut knowledge = KnowledgeBase::<1, 16, 16>::new();
/// let mut level = Box::new(SomLevel::<1, 2, 1, 32, 4, 4, 1, 64, 256>::new());
/// level.be_born(SomLevelConfig::FORAGER, &mut Rng::new(1))?;
/// let now = ItemStates::all_off(2);
/// level.learn(&mut knowledge, &now, ActionId(0), &now, &ValueConfig::FORAGER, Learning::Maps);
/// assert_eq!(level.items(), 0); // no schema of level 1 has succeeded
/// # Ok::<(), cla_core::ConfigError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SomLevel<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDE: usize,
    const FEATURES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
> {
    bank: Bank<ITEMS, FEATURES, WIDTH, HEIGHT, ACTIONS>,
    /// How often each action followed each node; older times weigh less.
    tried: [Grid<[f32; ACTIONS], WIDTH, HEIGHT>; ACTIONS],
    labels: Labels<LABELS>,
    implied: Implications<WORDS, FEATURES, ACTIONS, ROWS, LABELS>,
    config: Option<Checked<SomLevelConfig>>,
    here: Option<Here<WORDS>>,
    predictions: Reliability,
    next_value: u16,
    since_harvest: u32,
    losses: SomLevelLosses,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDE: usize,
    const FEATURES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
> SomLevel<WORDS, ITEMS, WIDE, FEATURES, WIDTH, HEIGHT, ACTIONS, ROWS, LABELS>
{
    /// A level that is not born.
    ///
    /// It is made for a host: as a static it would lie in flash as well as in RAM.
    #[must_use]
    pub const fn new() -> Self {
        const {
            assert!(ITEMS < FEATURES, "a level without a synthetic item is none");
            assert!(ITEMS <= WORDS * 32, "an item needs a bit: 32 for each word");
            assert!(
                FEATURES <= WIDE * 32,
                "a feature needs a bit: 32 for each word"
            );
            assert!(
                WIDTH * HEIGHT * ACTIONS < u16::MAX as usize,
                "at most 65,534 nodes"
            );
        }
        Self {
            bank: ActionSomBank::zeroed(),
            tried: [const { Grid::filled([0.0; ACTIONS]) }; ACTIONS],
            labels: Labels::new(),
            implied: Implications::new(),
            config: None,
            here: None,
            predictions: Reliability::ZERO,
            next_value: 0,
            since_harvest: 0,
            losses: SomLevelLosses::NONE,
        }
    }

    /// Is born: random maps, no item, no level-2 schema.
    ///
    /// # Errors
    /// [`ConfigError`]; the level is as it was.
    pub fn be_born(&mut self, config: SomLevelConfig, rng: &mut Rng) -> Result<(), ConfigError> {
        self.config = Some(config.checked()?);
        self.bank.randomize(rng);
        for grid in &mut self.tried {
            grid.as_mut_slice().fill([0.0; ACTIONS]);
        }
        self.labels.clear();
        self.implied.clear();
        self.here = None;
        self.predictions = Reliability::ZERO;
        self.next_value = 0;
        self.since_harvest = 0;
        self.losses = SomLevelLosses::NONE;
        Ok(())
    }

    /// The number of synthetic items.
    #[must_use]
    pub fn items(&self) -> u16 {
        self.implied.items.len() as u16
    }

    /// What an item's schema says.
    #[must_use]
    pub fn text(&self, item: SyntheticId) -> Option<SchemaText<WORDS>> {
        Some(self.implied.item(item)?.text)
    }

    /// All level-2 schemas: the item of the schema that they extend, and that of the one that must
    /// have succeeded before it, if any.
    pub fn schemas(&self) -> impl Iterator<Item = (SyntheticId, Option<SyntheticId>)> {
        self.implied.rows.iter().map(|row| (row.host, row.trace))
    }

    /// How often `action` was done right after a level-2 schema had succeeded, newer times weighing
    /// more: how often the items of that action were known.
    #[must_use]
    pub fn tried(&self, host: SyntheticId, trace: Option<SyntheticId>, action: ActionId) -> f32 {
        let place = self.implied.place(host, trace);
        let row = place.and_then(|place| self.implied.row(place));
        let tried = row.and_then(|row| row.tried.get(usize::from(action.0)));
        tried.copied().unwrap_or(0.0)
    }

    /// How often an item was on then.
    #[must_use]
    pub fn on(&self, host: SyntheticId, trace: Option<SyntheticId>, item: SyntheticId) -> f32 {
        let place = self.implied.place(host, trace);
        let (Some(place), Some(it)) = (place, self.implied.item(item)) else {
            return 0.0;
        };
        let mut labels = self.implied.labels.after(place, it.text.action).iter();
        labels.find(|it| it.item == item).map_or(0.0, |it| it.on)
    }

    /// What did not fit so far.
    #[must_use]
    pub fn losses(&self) -> SomLevelLosses {
        let mut losses = self.losses;
        for map in self.bank.maps() {
            losses.displaced_nodes = losses.displaced_nodes.saturating_add(map.displaced());
        }
        losses.refused_schemas = self.implied.refused;
        losses.evicted_labels = self
            .labels
            .evicted
            .saturating_add(self.implied.labels.evicted);
        losses
    }

    /// How often what was believed most before an action came true: predicted first, then done,
    /// then compared.
    #[must_use]
    pub const fn predictions(&self) -> Reliability {
        self.predictions
    }

    /// The belief in an item where `host` has succeeded after `trace`, in `[0, 1]`: the probability
    /// that its schema succeeds if its action is done.
    #[must_use]
    pub fn belief<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        host: SyntheticId,
        trace: Option<SyntheticId>,
        item: SyntheticId,
        values: &ValueConfig,
    ) -> f32 {
        let schema = self.implied.item(item).and_then(|item| item.schema);
        let schema = schema.and_then(|id| knowledge.schemas.get(usize::from(id.0)));
        let below = schema.map_or(0.0, |it| it.reliability.value(values.estimate));
        match &self.config {
            Some(config) => self
                .implied
                .belief(host, trace, item, below, config.reading),
            None => below,
        }
    }

    /// The best action `now`, or `None` where this level knows nothing.
    pub fn prefer<const PATTERNS: usize, const SCHEMAS: usize>(
        &self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        now: &ItemStates<WORDS>,
        values: &ValueConfig,
    ) -> Option<Preference> {
        let config = self.config.as_ref()?;
        let here = self.here.filter(|here| here.arrived == *now)?;
        let host = here.item?;
        let appraisals =
            self.implied
                .expected_values(knowledge, now, host, here.trace, values, config.reading);
        let mut best: Option<Preference> = None;
        for (action, appraisal) in appraisals.iter().enumerate() {
            if appraisal.value > best.map_or(0.0, |other| other.value) {
                best = Some(Preference {
                    action: ActionId(action as u16),
                    schema: None,
                    value: appraisal.value,
                });
            }
        }
        let mut best = best?;
        let believed = self.most_believed(host, here.trace, best.action);
        best.schema = believed
            .and_then(|item| self.implied.item(item)?.schema)
            .or_else(|| knowledge.most_reliable_applicable(now, best.action, values));
        Some(best)
    }

    /// The item of an action that was on most often after `host` after `trace`.
    fn most_believed(
        &self,
        host: SyntheticId,
        trace: Option<SyntheticId>,
        action: ActionId,
    ) -> Option<SyntheticId> {
        let special = trace.and_then(|trace| self.implied.place(host, Some(trace)));
        let most = |place| self.implied.labels.most(place, action);
        special
            .and_then(most)
            .or_else(|| self.implied.place(host, None).and_then(most))
    }

    /// Learns from a completed action; to be told before level 1 is, which may harvest.
    pub fn learn<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        values: &ValueConfig,
        learning: Learning,
    ) {
        let Some(config) = self.config else { return };
        if usize::from(action.0) >= ACTIONS {
            return;
        }
        let succeeded = knowledge.explain(before, action, after).schema;
        let item = succeeded.and_then(|schema| self.reify(knowledge, schema, learning));
        let here = self.here.filter(|here| here.arrived == *before);
        if let (Some(here), Some(item)) = (here, item) {
            self.label(&here, action, item, &config, learning);
        }
        let trace = here.and_then(|here| here.item);
        let node = match learning {
            Learning::Maps => self.train(before, trace, action, after, &config),
            Learning::Nothing | Learning::Counters => None,
        };
        self.here = Some(Here {
            item,
            trace,
            node,
            arrived: *after,
        });
        if learning == Learning::Nothing {
            return;
        }
        if learning == Learning::Maps {
            self.since_harvest = self.since_harvest.saturating_add(1);
            if self.since_harvest >= config.harvest_every {
                self.harvest();
            }
        }
        if let Some(item) = item {
            self.implied
                .improve(knowledge, item, values, config.reading);
        }
        self.improve_values(knowledge, config.values_per_step.min(MOST_A_STEP), values);
    }

    /// Follows the schemas of level 1 after a harvest there.
    pub fn follow<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    ) {
        for (index, item) in self.implied.items.iter_mut().enumerate() {
            let id = Some(SyntheticId(index as u16));
            let place = knowledge
                .schemas
                .iter()
                .position(|schema| schema.synthetic() == id);
            item.schema = place.map(|place| SchemaId(place as u16));
        }
    }

    /// Brings the values of the next `count` items up to date, in turn.
    pub fn improve_values<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        count: u16,
        values: &ValueConfig,
    ) {
        let Some(config) = self.config else { return };
        for _ in 0..count {
            if self.next_value >= self.items() {
                self.next_value = 0;
            }
            let item = SyntheticId(self.next_value);
            self.implied
                .improve(knowledge, item, values, config.reading);
            self.next_value = self.next_value.saturating_add(1);
        }
    }

    /// Reads the maps into level-2 schemas and adds up the counters of the nodes that say the same.
    ///
    /// What no node says any more leaves; every node also counts for the schema without its trace.
    pub fn harvest(&mut self) {
        let Some(config) = self.config else { return };
        self.since_harvest = 0;
        self.implied.labels.clear();
        for row in &mut self.implied.rows {
            row.tried = [0.0; ACTIONS];
            row.said = false;
        }
        let Self {
            bank,
            tried,
            labels,
            implied,
            ..
        } = self;
        read::<WORDS, ITEMS, WIDE, _, _, _, _, _, _>(bank, implied, &config, |implied, it| {
            let general = implied.place(it.host, None).and_then(|it| implied.row(it));
            let general = general.map_or(0.0, |row| row.value);
            implied.say(it.host, None, general);
            if it.trace.is_some() {
                implied.say(it.host, it.trace, general);
            }
        });
        implied.rows.retain(|row| row.said);
        let unread =
            read::<WORDS, ITEMS, WIDE, _, _, _, _, _, _>(bank, implied, &config, |implied, it| {
                let nodes = Grid::<f32, WIDTH, HEIGHT>::NODES;
                let tried = tried.get(usize::from(it.node) / nodes);
                let tried = tried.and_then(|map| map.as_slice().get(usize::from(it.node) % nodes));
                let special = it
                    .trace
                    .and_then(|trace| implied.place(it.host, Some(trace)));
                for place in [implied.place(it.host, None), special]
                    .into_iter()
                    .flatten()
                {
                    if let (Some(row), Some(more)) =
                        (implied.rows.get_mut(usize::from(place)), tried)
                    {
                        for (tried, more) in row.tried.iter_mut().zip(more) {
                            *tried += more;
                        }
                    }
                    for label in labels.of(it.node) {
                        implied
                            .labels
                            .add(place, label.action, label.item, label.on);
                    }
                }
            });
        self.losses.unread_nodes = unread;
        if config.forgetting > 0.0 {
            self.implied.limit(1.0 / config.forgetting);
        }
    }

    /// The item of a schema that has succeeded; a new one if there is room.
    fn reify<const PATTERNS: usize, const SCHEMAS: usize>(
        &mut self,
        knowledge: &mut KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
        id: SchemaId,
        learning: Learning,
    ) -> Option<SyntheticId> {
        let known = knowledge.schemas.get(usize::from(id.0))?.synthetic();
        // A mark may be another level's, or from before this one began.
        if let Some(item) = known
            && let Some(synthetic) = self.implied.items.get(usize::from(item.0))
            && knowledge.text(id).as_ref() == Some(&synthetic.text)
        {
            return known;
        }
        if learning != Learning::Maps {
            return None;
        }
        let text = knowledge.text(id)?;
        let item = match self.implied.item_of(&text) {
            Some(item) => item,
            None if self.implied.items.len() < FEATURES - ITEMS => {
                let new = Synthetic { text, schema: None };
                self.implied.items.push(new).ok()?;
                SyntheticId(self.implied.items.len() as u16 - 1)
            }
            None => {
                self.losses.refused_items = self.losses.refused_items.saturating_add(1);
                return None;
            }
        };
        self.implied.items.get_mut(usize::from(item.0))?.schema = Some(id);
        knowledge
            .schemas
            .get_mut(usize::from(id.0))?
            .set_synthetic(Some(item));
        Some(item)
    }

    /// Labels in hindsight what was on before `action`, at the node and at the level-2 schemas.
    fn label(
        &mut self,
        here: &Here<WORDS>,
        action: ActionId,
        item: SyntheticId,
        config: &SomLevelConfig,
        learning: Learning,
    ) {
        if let Some(host) = here.item
            && let Some(believed) = self.most_believed(host, here.trace, action)
        {
            self.predictions.record(believed == item, 0.0);
        }
        if learning == Learning::Nothing {
            return;
        }
        if let Some(node) = here.node {
            let nodes = Grid::<f32, WIDTH, HEIGHT>::NODES;
            let map = self.tried.get_mut(usize::from(node) / nodes);
            let tried = map.and_then(|it| it.as_mut_slice().get_mut(usize::from(node) % nodes));
            if let Some(tried) = tried.and_then(|it| it.get_mut(usize::from(action.0))) {
                self.labels
                    .record(node, action, item, tried, config.forgetting);
            }
        }
        if let Some(host) = here.item {
            self.implied
                .record(host, here.trace, action, item, config.forgetting);
        }
    }

    /// Trains the map of an action; which of all nodes the sample has won.
    fn train(
        &mut self,
        before: &ItemStates<WORDS>,
        trace: Option<SyntheticId>,
        action: ActionId,
        after: &ItemStates<WORDS>,
        config: &SomLevelConfig,
    ) -> Option<u16> {
        let mut context = widened::<WORDS, WIDE>(before, ITEMS as u16)?;
        for item in ITEMS as u16..FEATURES as u16 {
            let on = trace.is_some_and(|trace| trace.0 == item - ITEMS as u16);
            context.set(ItemId(item), Some(on)).ok()?;
        }
        // No weight stands for the synthetic items after the action, so what they are said to be
        // takes part in nothing; the next action labels them.
        let mut result = widened::<WORDS, WIDE>(after, ITEMS as u16)?;
        for item in ITEMS as u16..FEATURES as u16 {
            result.set(ItemId(item), Some(false)).ok()?;
        }
        let sample = Sample::new(&context, &result, ResultCoding::EndState, FEATURES as u16);
        let (trained, node) = self.bank.train_node(action, &sample, &config.training)?;
        let nodes = Grid::<f32, WIDTH, HEIGHT>::NODES;
        let place = (usize::from(action.0) * nodes) as u16 + node.0;
        if trained != Trained::Adapted {
            self.labels.forget(place);
            let map = self.tried.get_mut(usize::from(action.0))?;
            *map.as_mut_slice().get_mut(usize::from(node.0))? = [0.0; ACTIONS];
        }
        Some(place)
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const WIDE: usize,
    const FEATURES: usize,
    const WIDTH: usize,
    const HEIGHT: usize,
    const ACTIONS: usize,
    const ROWS: usize,
    const LABELS: usize,
> Default for SomLevel<WORDS, ITEMS, WIDE, FEATURES, WIDTH, HEIGHT, ACTIONS, ROWS, LABELS>
{
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
#[path = "som_level_tests.rs"]
mod tests;

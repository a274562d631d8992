//! Action SOMs: one map for each action, trained only when that action was done (book, 5.3.1).
//!
//! A map clusters [context | result] stimuli; its nodes are candidate schemas.
//! The bank holds the maps of all actions; after harvest no weight is read, so a robot that only
//! acts needs no bank.

use super::sample::Sample;
use crate::check::{Config, ConfigError, Range, check_some};
use crate::num::{Neighbourhood, Rng, Schedule};
use crate::snapshot::{Stored, stored};
use crate::som::{BestMatch, BinarySom, Grid, NodeId, Prototypes, SparseStimulus, best_match};
use crate::word::{ActionId, Cost};

/// How Action SOMs are trained.
///
/// ```
/// use cla_core::map::TrainingConfig;
/// let book = TrainingConfig::BOOK;
/// assert_eq!(book.alpha.at(0), 0.3);
/// assert!(TrainingConfig::FORAGER.recruitment.is_some());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct TrainingConfig {
    /// Learning rate α as a function of the samples that a map has seen; in `[0, 1]`.
    pub alpha: Schedule,
    /// Width σ of the neighbourhood in nodes, likewise.
    pub sigma: Schedule,
    /// Neighbours whose h has a factor below this stay; in `[0, 1]`.
    pub cut: f32,
    /// Weight of the result half in the distance (the context half has 1), in `[0, 1e20]`.
    pub result_weight: f32,
    /// Nodes for rare events; without it a rare event is averaged away.
    pub recruitment: Option<Recruitment>,
}

/// When a stimulus takes a node of its own.
///
/// A map represents what is frequent: a neighbourhood average drowns an event of one sample in a
/// thousand (the capture of a specimen).
/// A stimulus that is further than `vigilance` from every prototype therefore takes a node that has
/// not been recruited, the one that has won least, or else the recruited one that has won least;
/// a recruited node no longer follows its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct Recruitment {
    /// Squared distance from which on a stimulus is not represented.
    /// Below .25, the best unit's weights round to the stimulus in every feature.
    pub vigilance: f32,
    /// Samples of this map before recruitment begins: the map unfolds first.
    pub after: u32,
}

// Evaluated at compile time only: no panic is left in the code.
#[allow(clippy::panic)]
const fn valid(schedule: Result<Schedule, crate::num::ScheduleError>) -> Schedule {
    match schedule {
        Ok(schedule) => schedule,
        // Reached at compile time only: the constants below are checked when the crate is built.
        Err(_) => panic!("a constant schedule of this crate is invalid"),
    }
}

impl TrainingConfig {
    /// The book's: α .3 → .01 and σ 15 → 0 in a straight line over a map's share of 10,000
    /// actions, no recruitment (6.2.4).
    pub const BOOK: Self = Self {
        alpha: const { valid(Schedule::linear(0.3, 0.01, 1_667)) },
        sigma: const { valid(Schedule::linear(15.0, 0.0, 1_667)) },
        cut: 0.01,
        result_weight: 1.0,
        recruitment: None,
    };

    /// What finds rare events: every pattern that no node represents recruits one, from the first
    /// sample on, so that no node is left half-way between two patterns.
    pub const FORAGER: Self = Self {
        alpha: const { valid(Schedule::decay(0.3, 0.02, 300.0)) },
        sigma: const { valid(Schedule::decay(5.0, 0.0, 80.0)) },
        cut: 0.01,
        result_weight: 1.0,
        recruitment: Some(Recruitment {
            vigilance: 0.25,
            after: 0,
        }),
    };
}

impl Config for Recruitment {
    fn check(&self) -> Result<(), ConfigError> {
        Range::NOT_NEGATIVE.check("Recruitment::vigilance", self.vigilance)
    }
}

impl Config for TrainingConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::SHARE.check("TrainingConfig::alpha", self.alpha.most())?;
        let sigma = self.sigma.at(0);
        Range::NOT_NEGATIVE.check("TrainingConfig::sigma", sigma)?;
        Range::SHARE.check("TrainingConfig::cut", self.cut)?;
        Range::NOT_NEGATIVE.check("TrainingConfig::result_weight", self.result_weight)?;
        check_some(&self.recruitment)
    }
}

/// What a map did with a sample.
///
/// ```
/// use cla_core::map::Trained;
/// assert_ne!(Trained::Recruited, Trained::Adapted);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Trained {
    /// The winner and its neighbours moved towards the sample.
    Adapted,
    /// The sample took the least used node for itself.
    Recruited,
    /// As `Recruited`, but that node had won before: the map is full and forgot what it stood for.
    Displaced,
}

/// Samples of a map after which all its wins are halved: so many and what is left of those before
/// fit 16 bits however they are spread, and shares stay what they are.
const HALVED_EVERY: u32 = 32_000;

/// Work memory for one map at a time, shared by a whole bank.
#[derive(Clone, Debug)]
pub(crate) struct MapScratch<const WIDTH: usize, const HEIGHT: usize> {
    dots: Grid<f32, WIDTH, HEIGHT>,
    distances: Grid<f32, WIDTH, HEIGHT>,
    /// What training has touched in this step.
    pub(crate) cost: Cost,
}

/// The map of one action: a context half `M` and a result half `R`.
///
/// In the field: a Kohonen map of the transitions under one action, a vector quantizer; recruitment by a
/// vigilance is that of adaptive resonance (ART).
///
/// ```
/// use cla_core::map::{ActionSom, ResultCoding, Sample, TrainingConfig};
/// use cla_core::num::Rng;
/// use cla_core::word::{ItemId, ItemStates};
///
/// let mut bank = cla_core::map::ActionSomBank::<8, 8, 2, 1>::new();
/// bank.randomize(&mut Rng::new(1));
/// let before = ItemStates::<1>::all_off(2);
/// let mut after = before;
/// after.set(ItemId(1), Some(true))?;
/// let sample = Sample::new(&before, &after, ResultCoding::EndState, 2);
/// for _ in 0..300 {
///     bank.train(cla_core::word::ActionId(0), &sample, &TrainingConfig::FORAGER);
/// }
/// let map: &ActionSom<8, 8, 2> = &bank.maps()[0];
/// assert_eq!(map.samples(), 300);
/// assert!(map.nodes().any(|node| map.result_weight(node, 1) > 0.9));
/// # Ok::<(), cla_core::word::ItemOutOfRange>(())
/// ```
#[derive(Clone, Debug)]
pub struct ActionSom<
    const WIDTH: usize,
    const HEIGHT: usize,
    const ITEMS: usize,
    M = BinarySom<WIDTH, HEIGHT, ITEMS>,
    R = M,
> {
    context: M,
    result: R,
    wins: Grid<u16, WIDTH, HEIGHT>,
    recruited: Grid<bool, WIDTH, HEIGHT>,
    samples: u32,
    displaced: u32,
}

impl<
    const WIDTH: usize,
    const HEIGHT: usize,
    const ITEMS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
    R: Prototypes<WIDTH, HEIGHT>,
> ActionSom<WIDTH, HEIGHT, ITEMS, M, R>
{
    const fn new() -> Self {
        Self {
            context: M::ZERO,
            result: R::ZERO,
            wins: Grid::filled(0),
            recruited: Grid::filled(false),
            samples: 0,
            displaced: 0,
        }
    }

    fn randomize(&mut self, rng: &mut Rng) {
        self.context.randomize(rng);
        self.result.randomize(rng);
        self.wins.as_mut_slice().fill(0);
        self.recruited.as_mut_slice().fill(false);
        self.samples = 0;
        self.displaced = 0;
    }

    /// All nodes in ascending order.
    pub fn nodes(&self) -> impl Iterator<Item = NodeId> + use<WIDTH, HEIGHT, ITEMS, M, R> {
        (0..Grid::<f32, WIDTH, HEIGHT>::NODES as u16).map(NodeId)
    }

    /// Weight of an item in a node's context half, in `[0, 1]`.
    #[must_use]
    pub fn context_weight(&self, node: NodeId, item: u16) -> f32 {
        self.context.weight(node, item)
    }

    /// Weight of an item in a node's result half, in `[0, 1]` or, in change coding, `[−1, 1]`.
    #[must_use]
    pub fn result_weight(&self, node: NodeId, item: u16) -> f32 {
        self.result.weight(node, item)
    }

    /// How often a node was the best matching unit; halved for all nodes every 32,000 samples.
    #[must_use]
    pub fn wins(&self, node: NodeId) -> u16 {
        self.wins
            .as_slice()
            .get(usize::from(node.0))
            .copied()
            .unwrap_or(0)
    }

    /// Patterns that a full map has forgotten to represent new ones.
    #[must_use]
    pub const fn displaced(&self) -> u32 {
        self.displaced
    }

    /// Samples trained on.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    // Search, update and recruitment have frames of their own: inlined, each would lie on top of
    // everything below the others.
    #[inline(never)]
    fn train<const WORDS: usize>(
        &mut self,
        sample: &Sample<WORDS>,
        config: &TrainingConfig,
        scratch: &mut MapScratch<WIDTH, HEIGHT>,
    ) -> (Trained, NodeId) {
        let best = self.search(sample, config.result_weight, scratch);
        let samples = self.samples;
        self.samples = samples.saturating_add(1);
        if self.samples.is_multiple_of(HALVED_EVERY) {
            self.halve_wins();
        }
        let novel = |it: &Recruitment| samples >= it.after && best.squared_distance > it.vigilance;
        if config.recruitment.as_ref().is_some_and(novel) {
            scratch.cost.moved = scratch.cost.moved.wrapping_add(2);
            return self.recruit(sample);
        }
        // Wins of a map that is still unfolding say nothing about what its nodes became.
        if config
            .recruitment
            .as_ref()
            .is_none_or(|it| samples >= it.after)
        {
            self.count_win(best.node);
        }
        let reached = self.adapt(sample, best.node, config, samples);
        scratch.cost.moved = scratch.cost.moved.wrapping_add(2 * reached);
        (Trained::Adapted, best.node)
    }

    #[inline(never)]
    fn search<const WORDS: usize>(
        &self,
        sample: &Sample<WORDS>,
        result_weight: f32,
        scratch: &mut MapScratch<WIDTH, HEIGHT>,
    ) -> BestMatch {
        let MapScratch {
            dots,
            distances,
            cost,
        } = scratch;
        let features = features_on(&sample.context()) + features_on(&sample.result());
        let nodes = Grid::<f32, WIDTH, HEIGHT>::NODES as u32;
        cost.units = cost.units.wrapping_add(2 * nodes);
        cost.weights = cost.weights.wrapping_add(nodes * features);
        self.context
            .squared_distances(&sample.context(), dots, distances);
        self.result
            .add_squared_distances(&sample.result(), result_weight, dots, distances);
        best_match(distances)
    }

    /// Moves the winner and its neighbours towards the sample, the map's `samples`th; answers how
    /// many nodes within reach follow.
    #[inline(never)]
    fn adapt<const WORDS: usize>(
        &mut self,
        sample: &Sample<WORDS>,
        winner: NodeId,
        config: &TrainingConfig,
        samples: u32,
    ) -> u32 {
        let mut near = Neighbourhood::winner_only();
        // Schedules and cut were validated with the configuration; a bad value moves the winner.
        let _ = near.widen(config.sigma.at(samples), config.cut);
        let alpha = config.alpha.at(samples);
        let recruited = self.recruited.as_slice();
        let may_move = |node: NodeId| {
            node == winner || !recruited.get(usize::from(node.0)).copied().unwrap_or(false)
        };
        self.context
            .train(&sample.context(), winner, alpha, &near, may_move);
        self.result
            .train(&sample.result(), winner, alpha, &near, may_move);
        let (column, row) = self.wins.position(winner);
        let (left, top) = (
            column.saturating_sub(near.horizontal_radius()),
            row.saturating_sub(near.vertical_radius()),
        );
        let columns = (column + near.horizontal_radius()).min(WIDTH - 1) + 1 - left;
        let rows = (row + near.vertical_radius()).min(HEIGHT - 1) + 1 - top;
        let near = recruited.chunks_exact(WIDTH.max(1)).skip(top).take(rows);
        let near = near.flat_map(|row| row.iter().skip(left).take(columns));
        let moved = near.filter(|&&recruited| !recruited).count();
        let alone = recruited.get(usize::from(winner.0)) == Some(&true);
        moved as u32 + u32::from(alone)
    }

    /// Gives the sample the node with the fewest wins: a free one, or else a recruited one.
    #[inline(never)]
    fn recruit<const WORDS: usize>(&mut self, sample: &Sample<WORDS>) -> (Trained, NodeId) {
        let mut least = (true, u16::MAX, 0_usize);
        let nodes = self.recruited.as_slice().iter().zip(self.wins.as_slice());
        for (index, (&recruited, &wins)) in nodes.enumerate() {
            let candidate = (recruited, wins, index);
            if candidate < least {
                least = candidate;
            }
        }
        let (_, wins, index) = least;
        let node = NodeId(index as u16);
        self.context.imprint(&sample.context(), node);
        self.result.imprint(&sample.result(), node);
        if let Some(recruited) = self.recruited.as_mut_slice().get_mut(index) {
            *recruited = true;
        }
        if let Some(wins) = self.wins.as_mut_slice().get_mut(index) {
            *wins = 1;
        }
        if wins > 0 {
            self.displaced = self.displaced.saturating_add(1);
            (Trained::Displaced, node)
        } else {
            (Trained::Recruited, node)
        }
    }

    /// Makes what follows from the weights anew.
    pub(crate) fn rebuild(&mut self) {
        self.context.rebuild();
        self.result.rebuild();
    }

    /// Gives a sample a node of its own, as if it had won so often.
    pub(crate) fn imprint<const WORDS: usize>(&mut self, sample: &Sample<WORDS>, wins: u16) {
        let (_, node) = self.recruit(sample);
        if let Some(place) = self.wins.as_mut_slice().get_mut(usize::from(node.0)) {
            *place = wins.max(1);
        }
    }

    /// Makes nodes whose weights cannot be so free ones; answers how many.
    pub(crate) fn audit(&mut self) -> u32 {
        let mut mended = u32::from(self.context.audit_whole());
        mended += u32::from(self.result.audit_whole());
        for node in self.nodes() {
            if !(self.context.audit(node) | self.result.audit(node)) {
                continue;
            }
            mended += 1;
            let index = usize::from(node.0);
            if let Some(wins) = self.wins.as_mut_slice().get_mut(index) {
                *wins = 0;
            }
            if let Some(recruited) = self.recruited.as_mut_slice().get_mut(index) {
                *recruited = false;
            }
        }
        mended
    }

    /// Lets all wins count for half; a node that has won has won at least once.
    #[inline(never)]
    fn halve_wins(&mut self) {
        for wins in self.wins.as_mut_slice() {
            *wins = wins.div_ceil(2);
        }
    }

    fn count_win(&mut self, node: NodeId) {
        if let Some(wins) = self.wins.as_mut_slice().get_mut(usize::from(node.0)) {
            *wins = wins.saturating_add(1);
        }
    }
}

/// The Action SOMs of `ACTIONS` actions and the work memory they share.
///
/// See [`ActionSom`] for an example.
#[derive(Clone, Debug)]
pub struct ActionSomBank<
    const WIDTH: usize,
    const HEIGHT: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    M = BinarySom<WIDTH, HEIGHT, ITEMS>,
    R = M,
> {
    pub(crate) maps: [ActionSom<WIDTH, HEIGHT, ITEMS, M, R>; ACTIONS],
    pub(crate) scratch: MapScratch<WIDTH, HEIGHT>,
}

impl<const WIDTH: usize, const HEIGHT: usize, const ITEMS: usize, const ACTIONS: usize>
    ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS>
{
    /// A bank of all-zero memory in the reference numerics; call [`randomize`](Self::randomize)
    /// before training.
    #[must_use]
    pub const fn new() -> Self {
        Self::zeroed()
    }
}

impl<
    const WIDTH: usize,
    const HEIGHT: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    M: Prototypes<WIDTH, HEIGHT>,
    R: Prototypes<WIDTH, HEIGHT>,
> ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS, M, R>
{
    /// As `new`, for weights of any kind; results may have fewer features than contexts.
    #[must_use]
    pub const fn zeroed() -> Self {
        Self {
            maps: [const { ActionSom::new() }; ACTIONS],
            scratch: MapScratch {
                dots: Grid::filled(0.0),
                distances: Grid::filled(0.0),
                cost: Cost::NONE,
            },
        }
    }

    /// Draws all weights anew and forgets all samples: the start of a level.
    pub fn randomize(&mut self, rng: &mut Rng) {
        for map in &mut self.maps {
            map.randomize(rng);
        }
    }

    /// Trains the map of the action that was just completed; an action without a map changes
    /// nothing and answers `None`.
    ///
    /// Nothing is checked here: a `result_weight` out of its range counts as the nearest in it, NaN as
    /// 0; by a rate α beyond 1 no node moves towards a sample, though a new pattern may still take one; with a `cut` beyond `[0, 1]` the winner alone does, and a
    /// vigilance that is no number finds nothing new.
    pub fn train<const WORDS: usize>(
        &mut self,
        action: ActionId,
        sample: &Sample<WORDS>,
        config: &TrainingConfig,
    ) -> Option<Trained> {
        let (trained, _) = self.train_node(action, sample, config)?;
        Some(trained)
    }

    /// As [`train`](Self::train), and says which node the sample has won.
    pub fn train_node<const WORDS: usize>(
        &mut self,
        action: ActionId,
        sample: &Sample<WORDS>,
        config: &TrainingConfig,
    ) -> Option<(Trained, NodeId)> {
        let map = self.maps.get_mut(usize::from(action.0))?;
        Some(map.train(sample, config, &mut self.scratch))
    }

    /// The maps in the order of their actions.
    #[must_use]
    pub const fn maps(&self) -> &[ActionSom<WIDTH, HEIGHT, ITEMS, M, R>; ACTIONS] {
        &self.maps
    }

    /// What training has touched since [`forget_cost`](Self::forget_cost).
    pub(crate) const fn cost(&self) -> Cost {
        self.scratch.cost
    }

    pub(crate) const fn forget_cost(&mut self) {
        self.scratch.cost = Cost::NONE;
    }

    /// ‖x − m‖² of every node to the last trained sample, for checks of bit identity.
    #[must_use]
    pub const fn last_distances(&self) -> &Grid<f32, WIDTH, HEIGHT> {
        &self.scratch.distances
    }
}

impl<const WIDTH: usize, const HEIGHT: usize, const ITEMS: usize, const ACTIONS: usize> Default
    for ActionSomBank<WIDTH, HEIGHT, ITEMS, ACTIONS>
{
    fn default() -> Self {
        Self::new()
    }
}

fn features_on(stimulus: &SparseStimulus<'_>) -> u32 {
    let mut features = 0;
    for word in stimulus.on.iter().chain(stimulus.minus) {
        features += word.count_ones();
    }
    features
}

stored! {
    impl[
        const WIDTH: usize,
        const HEIGHT: usize,
        const ITEMS: usize,
        M: Stored,
        R: Stored
    ]
    ActionSom<WIDTH, HEIGHT, ITEMS, M, R> { context, result, wins, recruited, samples, displaced }
}

stored! { impl[] TrainingConfig { alpha, sigma, cut, result_weight, recruitment } }
stored! { impl[] Recruitment { vigilance, after } }

#[cfg(test)]
mod tests {
    use super::{ActionSomBank, Trained, TrainingConfig};
    use crate::map::{ResultCoding, Sample};
    use crate::num::Rng;
    use crate::word::{ActionId, ItemId, ItemStates};

    fn sample(before: u16, after: u16) -> Sample<1> {
        let state = |on: u16| {
            let mut states = ItemStates::all_off(4);
            states.set(ItemId(on), Some(true)).unwrap();
            states
        };
        Sample::new(&state(before), &state(after), ResultCoding::EndState, 4)
    }

    fn trained(config: &TrainingConfig) -> ActionSomBank<10, 10, 4, 1> {
        let mut bank = ActionSomBank::new();
        let mut rng = Rng::new(1);
        bank.randomize(&mut rng);
        for t in 0..1600 {
            // One sample in four hundred is the rare event: item 3 comes on.
            let rare = t % 400 == 399;
            let from = rng.below(3) as u16;
            bank.train(
                ActionId(0),
                &sample(from, if rare { 3 } else { from }),
                config,
            );
        }
        bank
    }

    fn has_rare(bank: &ActionSomBank<10, 10, 4, 1>) -> bool {
        let map = &bank.maps()[0];
        map.nodes().any(|node| map.result_weight(node, 3) > 0.9)
    }

    #[test]
    fn recruitment_keeps_a_rare_event_that_the_plain_map_averages_away() {
        assert!(has_rare(&trained(&TrainingConfig::FORAGER)));
        assert!(!has_rare(&trained(&TrainingConfig::BOOK)));
    }

    #[test]
    fn a_full_map_says_that_it_forgot_a_pattern() {
        let mut bank = ActionSomBank::<2, 1, 4, 1>::new();
        bank.randomize(&mut Rng::new(3));
        let mut config = TrainingConfig::FORAGER;
        config.recruitment = Some(super::Recruitment {
            vigilance: 0.25,
            after: 0,
        });
        let mut train = |from, to| bank.train(ActionId(0), &sample(from, to), &config);
        assert_eq!(train(0, 0), Some(Trained::Recruited));
        assert_eq!(train(1, 1), Some(Trained::Recruited));
        assert_eq!(train(2, 2), Some(Trained::Displaced));
        assert_eq!(train(2, 2), Some(Trained::Adapted));
    }

    #[test]
    fn an_action_without_a_map_changes_nothing() {
        let mut bank = trained(&TrainingConfig::FORAGER);
        assert_eq!(
            bank.train(ActionId(1), &sample(0, 0), &TrainingConfig::FORAGER),
            None
        );
        assert_eq!(bank.maps()[0].samples(), 1600);
    }
}

//! Habits: what doing an action has brought, by experience alone.
//!
//! Schemas say what an action leads to, and values follow by inference; where the percept hides what
//! matters, inference chains guesses.
//! A habit infers nothing: temporal differences along what was really done, Sarsa(λ) (Rummery and
//! Niranjan 1994) with eligibility traces that accumulate or replace each other (Singh and Sutton
//! 1996), over few features: every item that is on, the synthetic item of the schema that has
//! succeeded last, and one that is always there.
//! An agent weighs both voices, as animals seem to (Daw, Niv and Dayan 2005).

use crate::check::{Config, ConfigError, Range};
use crate::knowledge::SyntheticId;
use crate::snapshot::{
    Flip, LARGEST, MOST_CHANGE, Mender, Reader, Stored, Writer, bounded, stored,
};
use crate::word::{ActionId, ItemSet};

/// How habits form, and how much they say.
///
/// ```
/// use cla_core::agent::AgentConfig;
/// use cla_core::choice::HabitConfig;
/// assert_eq!(AgentConfig::FORAGER.habits, None);
/// assert_eq!(AgentConfig::FORAGER_LEVEL2.habits, Some(HabitConfig::FORAGER));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(deny_unknown_fields)
)]
pub struct HabitConfig {
    /// Share of an action's value that is habit, in `[0, 1]`; the rest is what schemas promise.
    pub weight: f32,
    /// Discount of the future, in `[0, 1)`.
    pub discount: f32,
    /// λ: how far back a reward is felt, in `[0, 1]`; never farther than the last 16 actions.
    pub lambda: f32,
    /// Share of a TD error that each feature learns, in `[0, 1]`; together, and with accumulating traces
    /// all times together, they learn no more than all.
    pub learning_rate: f32,
    /// The same while the agent doubts what it knows.
    pub doubting_rate: f32,
    /// Whether a feature that comes again is still part of the deeds before.
    #[cfg_attr(feature = "serde", serde(default))]
    pub traces: Traces,
}

/// What a reward is felt by when a feature comes again within the last deeds: the eligibility trace.
///
/// ```
/// use cla_core::choice::{HabitConfig, Traces};
/// assert_eq!(HabitConfig::FORAGER.traces, Traces::Replacing);
/// assert_eq!(HabitConfig::LASTING.traces, Traces::Accumulating);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "snake_case")
)]
pub enum Traces {
    /// By its newest deed alone.
    ///
    /// Many features share an action's worth, and one that is nearly always on then feels of every
    /// surprise only what belongs to the newest step: over millions of actions the sum drifts, in some
    /// lives above what can be earned (docs/findings/long-life.md).
    #[default]
    Replacing,
    /// By every deed that it was part of, as the gradient says; by the newest alone while the agent
    /// doubts, when fast is better than right.
    Accumulating,
}

impl HabitConfig {
    /// Tuned on the simulated Pioneer, seeds 0 to 79.
    pub const FORAGER: Self = Self {
        weight: 0.5,
        discount: 0.85,
        lambda: 0.8,
        learning_rate: 0.03,
        doubting_rate: 0.2,
        traces: Traces::Replacing,
    };

    /// Habits for a life without an end: traces accumulate, and each of them learns a third.
    ///
    /// Chosen on seeds 0 and 1 of the simulated Pioneer; ten lives of ten million actions in two worlds
    /// are the claims `survive.lasting.*`.
    pub const LASTING: Self = Self {
        learning_rate: 0.01,
        traces: Traces::Accumulating,
        ..Self::FORAGER
    };
}

impl Config for HabitConfig {
    fn check(&self) -> Result<(), ConfigError> {
        Range::SHARE.check("HabitConfig::weight", self.weight)?;
        Range::BELOW_ONE.check("HabitConfig::discount", self.discount)?;
        Range::SHARE.check("HabitConfig::lambda", self.lambda)?;
        Range::SHARE.check("HabitConfig::learning_rate", self.learning_rate)?;
        Range::SHARE.check("HabitConfig::doubting_rate", self.doubting_rate)
    }
}

/// Actions that still feel a reward: where discount · λ is .68, less than half a percent of it is lost.
const FELT: usize = 16;

/// What was done in what.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Deed<const WORDS: usize> {
    on: ItemSet<WORDS>,
    trace: Option<SyntheticId>,
    action: ActionId,
}

impl<const WORDS: usize> Deed<WORDS> {
    const NONE: Self = Self {
        on: ItemSet::EMPTY,
        trace: None,
        action: ActionId(0),
    };

    /// One that is always there, the items that are on, and the trace.
    fn features(&self) -> u16 {
        1 + self.on.len() + u16::from(self.trace.is_some())
    }
}

/// What each action has brought, for each feature; the worth of an action is their sum.
///
/// In the field: Sarsa(λ) with linear function approximation and eligibility traces, the model-free half
/// of the learner.
///
/// ```
/// use cla_core::choice::Habits;
/// use cla_core::word::ItemSet;
/// let habits = Habits::<1, 7, 6, 64>::new();
/// assert_eq!(habits.worth(&ItemSet::EMPTY, None), [0.0; 6]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Habits<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SYNTHETIC: usize,
> {
    always: [f32; ACTIONS],
    items: [[f32; ACTIONS]; ITEMS],
    traces: [[f32; ACTIONS]; SYNTHETIC],
    /// The last deeds in a ring.
    deeds: [Deed<WORDS>; FELT],
    /// Where the newest is, and how many there are.
    newest: u8,
    count: u8,
    /// What the newest has brought; what followed it is not known yet.
    reward: f32,
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const SYNTHETIC: usize>
    Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC>
{
    /// No habit at all, of all-zero memory.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            always: [0.0; ACTIONS],
            items: [[0.0; ACTIONS]; ITEMS],
            traces: [[0.0; ACTIONS]; SYNTHETIC],
            deeds: [Deed::NONE; FELT],
            newest: 0,
            count: 0,
            reward: 0.0,
        }
    }

    /// What each action has been worth where these items are on and the schema of `trace` has just
    /// succeeded: discounted rewards, in the units of the inherent values.
    #[must_use]
    pub fn worth(&self, on: &ItemSet<WORDS>, trace: Option<SyntheticId>) -> [f32; ACTIONS] {
        let mut worth = self.always;
        for item in on.iter() {
            add(&mut worth, self.items.get(usize::from(item.0)));
        }
        if let Some(trace) = trace {
            add(&mut worth, self.traces.get(usize::from(trace.0)));
        }
        worth
    }

    fn worth_of(&self, deed: &Deed<WORDS>) -> f32 {
        let worth = self.worth(&deed.on, deed.trace);
        worth
            .get(usize::from(deed.action.0))
            .copied()
            .unwrap_or(0.0)
    }

    /// Forgets everything.
    pub(crate) fn clear(&mut self) {
        *self = Self::new();
    }

    /// A synthetic item stands for another schema from now on: nothing was ever done after it.
    pub(crate) fn renew(&mut self, item: SyntheticId) {
        if let Some(worth) = self.traces.get_mut(usize::from(item.0)) {
            *worth = [0.0; ACTIONS];
        }
        for deed in &mut self.deeds {
            if deed.trace == Some(item) {
                deed.trace = None;
            }
        }
    }

    /// What happened without a decision, a reflex or a teacher's action, is what followed the last
    /// deed, and so is its reward.
    pub(crate) fn add(&mut self, reward: f32) {
        if self.count > 0 {
            self.reward += reward;
        }
    }

    /// The deeds so far have no bearing on what comes; what followed the last of them is not learned.
    pub(crate) const fn pause(&mut self) {
        self.count = 0;
    }

    /// Forgets values that are none, and the last deeds when their ring is broken; answers how many.
    pub(crate) fn audit(&mut self) -> u32 {
        let mut mended = 0;
        let items = self.items.as_flattened_mut().iter_mut();
        let traces = self.traces.as_flattened_mut().iter_mut();
        for worth in self.always.iter_mut().chain(items).chain(traces) {
            if !(-LARGEST..=LARGEST).contains(worth) {
                *worth = 0.0;
                mended += 1;
            }
        }
        let deeds = self.deeds.iter();
        let known = |deed: &Deed<WORDS>| usize::from(deed.action.0) < ACTIONS;
        let ring = usize::from(self.newest) < FELT
            && usize::from(self.count) <= FELT
            && self.reward.abs() <= LARGEST
            && deeds.fold(true, |all, it| all & known(it));
        if !ring {
            self.deeds = [Deed::NONE; FELT];
            (self.newest, self.count, self.reward) = (0, 0, 0.0);
            mended += 1;
        }
        mended
    }

    /// Learns from an action, done where these items were on and `trace` had just succeeded, and
    /// from the reward that it brought, faster while it `doubts`; answers how many values have moved.
    pub(crate) fn feel(
        &mut self,
        (on, trace, action): (ItemSet<WORDS>, Option<SyntheticId>, ActionId),
        reward: f32,
        doubts: bool,
        config: &HabitConfig,
    ) -> u32 {
        let (rate, traces) = if doubts {
            (config.doubting_rate, Traces::Replacing)
        } else {
            (config.learning_rate, config.traces)
        };
        let deed = Deed { on, trace, action };
        let mut moved = 0;
        if self.count > 0
            && let Some(before) = self.deeds.get(usize::from(self.newest)).copied()
        {
            // Only now it is known what the deed before was good for.
            let error =
                self.reward + config.discount * self.worth_of(&deed) - self.worth_of(&before);
            let share = self.most_share(&before, traces, config);
            let rate = if rate < share { rate } else { share };
            if error.abs() <= LARGEST {
                let change = bounded(rate * error, MOST_CHANGE);
                moved = self.spread(change, config.discount * config.lambda, traces);
            }
        }
        self.newest = self.newest.wrapping_add(1) % FELT as u8;
        if let Some(place) = self.deeds.get_mut(usize::from(self.newest)) {
            *place = deed;
        }
        if usize::from(self.count) < FELT {
            self.count += 1;
        }
        self.reward = reward;
        moved
    }

    /// The share of an error by which each feature may move.
    ///
    /// All features of a deed move, together no farther than to what was felt; where traces accumulate a
    /// feature may be one of all the last deeds and is moved by each, so that the largest of them counts,
    /// and the sum of what it moves by.
    fn most_share(&self, before: &Deed<WORDS>, traces: Traces, config: &HabitConfig) -> f32 {
        let (deeds, sum): (&[Deed<WORDS>], f32) = match traces {
            Traces::Replacing => (&[], 1.0),
            Traces::Accumulating => (&self.deeds, 1.0 - config.discount * config.lambda),
        };
        let most = deeds
            .iter()
            .map(Deed::features)
            .fold(before.features(), u16::max);
        sum / f32::from(most)
    }

    /// Moves the values of the last deeds, the older the less; where traces replace each other, a feature
    /// that came again belongs to the newer deed alone.
    fn spread(&mut self, change: f32, fading: f32, traces: Traces) -> u32 {
        let replacing = traces == Traces::Replacing;
        let mut change = change;
        let mut seen = ItemSet::EMPTY;
        let mut moved = 0;
        for age in 0..usize::from(self.count).min(FELT) {
            let place = (usize::from(self.newest) + FELT - age) % FELT;
            let Some(deed) = self.deeds.get(place).copied() else {
                continue;
            };
            let action = usize::from(deed.action.0);
            let mut shift = |worth: Option<&mut [f32; ACTIONS]>| {
                if let Some(worth) = worth.and_then(|worth| worth.get_mut(action)) {
                    *worth += change;
                    moved += 1;
                }
            };
            if age == 0 || !replacing {
                shift(Some(&mut self.always));
            }
            for item in deed.on.difference(&seen).iter() {
                shift(self.items.get_mut(usize::from(item.0)));
            }
            if let Some(trace) = deed.trace {
                let newer = replacing
                    && (0..age).any(|newer| {
                        let place = (usize::from(self.newest) + FELT - newer) % FELT;
                        let newer = self.deeds.get(place);
                        newer.is_some_and(|newer| newer.trace == Some(trace))
                    });
                if !newer {
                    shift(self.traces.get_mut(usize::from(trace.0)));
                }
            }
            if replacing {
                seen = seen.union(&deed.on);
            }
            change *= fading;
        }
        moved
    }
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const SYNTHETIC: usize>
    Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC>
{
    /// Writes values alone, those of so many synthetic items.
    pub(crate) fn carry(&self, synthetic: u16, to: &mut Writer<'_>) {
        self.always.store(to);
        self.items.store(to);
        synthetic.store(to);
        for worth in self.traces.iter().take(synthetic.into()) {
            worth.store(to);
        }
    }

    /// Reads them from a robot of so many items and actions, over what is there if there is anybody.
    pub(crate) fn take(
        mut into: Option<&mut Self>,
        (items, actions): (usize, usize),
        from: &mut Reader<'_>,
    ) {
        let read = |from: &mut Reader<'_>| {
            let mut worth = [0.0; ACTIONS];
            for value in worth.iter_mut().take(actions) {
                value.restore(from);
            }
            worth
        };
        let always = read(from);
        if let Some(it) = &mut into {
            it.clear();
            it.always = always;
        }
        for item in 0..items {
            let worth = read(from);
            if let Some(place) = into.as_mut().and_then(|it| it.items.get_mut(item)) {
                *place = worth;
            }
        }
        for item in 0..from.count("synthetic items", SYNTHETIC) {
            let worth = read(from);
            if let Some(place) = into.as_mut().and_then(|it| it.traces.get_mut(item)) {
                *place = worth;
            }
        }
    }
}

fn add<const ACTIONS: usize>(sums: &mut [f32; ACTIONS], values: Option<&[f32; ACTIONS]>) {
    if let Some(values) = values {
        for (sum, value) in sums.iter_mut().zip(values) {
            *sum += value;
        }
    }
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const SYNTHETIC: usize> Default
    for Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC>
{
    fn default() -> Self {
        Self::new()
    }
}

stored! { impl[] HabitConfig { weight, discount, lambda, learning_rate, doubting_rate, traces } }

impl Traces {
    const fn of(code: u8) -> Option<Self> {
        match code {
            0 => Some(Self::Replacing),
            1 => Some(Self::Accumulating),
            _ => None,
        }
    }

    const fn code(self) -> u8 {
        match self {
            Self::Replacing => 0,
            Self::Accumulating => 1,
        }
    }
}

impl Stored for Traces {
    const BLANK: Self = Self::Replacing;

    fn store(&self, to: &mut Writer<'_>) {
        self.code().store(to);
    }

    // Version 1 knew one kind.
    fn restore(&mut self, from: &mut Reader<'_>) {
        *self = Self::Replacing;
        if from.is_before(2) {
            return;
        }
        let mut code = 0_u8;
        code.restore(from);
        match Self::of(code) {
            Some(it) => *self = it,
            None => from.refuse(),
        }
    }

    fn mend(&mut self, _: &mut Mender) {}

    // A code that means nothing cannot be held.
    fn flip(&mut self, by: &mut Flip) {
        if let Some(bit) = by.field(8)
            && let Some(it) = Self::of(self.code() ^ 1_u8.wrapping_shl(bit))
        {
            *self = it;
        }
    }
}

stored! { impl[const WORDS: usize] Deed<WORDS> { on, trace, action } }
stored! {
    impl[const WORDS: usize, const ITEMS: usize, const ACTIONS: usize, const SYNTHETIC: usize]
    Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC> {
        always, items, traces, deeds,
        newest if |it: &u8| usize::from(*it) < FELT,
        count if |it: &u8| usize::from(*it) <= FELT,
        reward
    }
}

#[cfg(test)]
#[path = "habit_tests.rs"]
mod tests;

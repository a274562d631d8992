//! A look inside a mind: what matters to it, how much it knows, who decided well, its contexts.
//!
//! Nothing here changes anything.

use super::config::{MindConfig, Voice};
use super::mind::{Age, Mind};
use super::moment::Feature;
use super::tree::DEEP;
use crate::reason::Reasoning;
use crate::word::{ActionId, BEARABLE, Health, ItemId, ItemSet, State, fullest};

/// How far the tables of a mind are filled, each with its capacity.
///
/// ```
/// use cla_core::forest::Mind;
/// let mind = Mind::<1, 2, 2, 32, 16, 32, 64, 256>::new();
/// assert_eq!(mind.filled().states, (0, 64));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Filled {
    /// Samples in memory.
    pub samples: (u32, u32),
    /// Leaves of the newest trees.
    pub leaves: (u32, u32),
    /// Rows of the habits that some step has.
    pub rows: (u32, u32),
    /// States of the model.
    pub states: (u32, u32),
    /// Links between them.
    pub links: (u32, u32),
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// Items that matter.
    #[must_use]
    pub const fn relevant(&self) -> &ItemSet<WORDS> {
        self.forest.mask()
    }

    /// How clearly an item tells values apart: a running mean of its best F statistic.
    #[must_use]
    pub fn relevance(&self, item: ItemId) -> f32 {
        self.forest.relevance(item)
    }

    /// States or links of the model that were given up for others.
    #[must_use]
    pub const fn given_up(&self) -> u32 {
        self.model.given_up()
    }

    /// Whether it doubts in what it knew.
    #[must_use]
    pub const fn doubts(&self) -> bool {
        self.doubt.lasts()
    }

    /// How often it has begun to doubt in what it knew.
    #[must_use]
    pub const fn alarms(&self) -> u32 {
        self.doubt.alarms()
    }

    /// The share of steps that find their row taken by another step; above one half, items that do
    /// not matter are left out of what is keyed by whole percepts.
    #[must_use]
    pub const fn crowding(&self) -> f32 {
        self.habits.crowding()
    }

    /// Items that count as off because they are stuck.
    #[must_use]
    pub fn stuck(&self) -> u16 {
        self.runs.stuck()
    }

    /// Samples in memory, leaves of the newest trees, and how often trees were grown.
    #[must_use]
    pub fn size(&self) -> (u16, u16, u32) {
        (
            self.forest.samples(),
            self.forest.leaves(),
            self.forest.grown(),
        )
    }

    /// How far its tables are filled.
    #[must_use]
    pub fn filled(&self) -> Filled {
        let (states, links) = self.model.filled();
        Filled {
            samples: (u32::from(self.forest.samples()), 16 * STRETCHES as u32),
            leaves: (u32::from(self.forest.leaves()), LEAVES as u32),
            rows: (self.habits.rows(), ROWS as u32),
            states: (states, STATES as u32),
            links: (links, LINKS as u32),
        }
    }

    /// What an item is worth when it is on after an action, negative for harm; 0 for one that it does
    /// not have.
    #[must_use]
    pub fn value(&self, item: ItemId) -> f32 {
        let value = self.values.get(usize::from(item.0));
        value.copied().unwrap_or(0.0)
    }

    /// How it learns and chooses.
    #[must_use]
    pub const fn config(&self) -> &MindConfig {
        &self.config
    }

    /// What an item that is on adds to what habits hold each action to be worth, in discounted rewards.
    #[must_use]
    pub fn habit(&self, item: ItemId) -> [f32; ACTIONS] {
        self.habits.of_item(item)
    }

    /// Whether its training is over.
    #[must_use]
    pub fn acts(&self) -> bool {
        self.age == Age::Acting
    }

    /// The track record of a voice: what an action under it brought, now and later, and in how many
    /// blocks it has led.
    #[must_use]
    pub fn record(&self, voice: Voice) -> (f32, u16) {
        self.voices.record(voice as u8)
    }

    /// The contexts in which the newest trees see an action, and what it is worth there, in the
    /// order of the tree: simple schemas without their results.
    pub fn contexts(&self, action: ActionId, mut see: impl FnMut(&[(Feature, bool)], f32)) {
        self.forest.visit(action.0 as u8, &mut |path, value| {
            let mut context = [(Feature::Now(ItemId(0)), false); DEEP];
            for (place, (feature, yes)) in context.iter_mut().zip(path) {
                *place = (Feature::of::<ITEMS>(*feature), *yes);
            }
            see(context.get(..path.len()).unwrap_or(&[]), value);
        });
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<WORDS, ITEMS, ACTIONS>,
> Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>
{
    /// All that its tables have lost so far: what found no room, and what had to make some.
    pub(super) fn losses(&self) -> u32 {
        self.model.given_up().wrapping_add(self.reason.losses())
    }

    pub(super) fn begin_health(&mut self) {
        self.gauge.begin(self.losses());
    }

    /// How it is doing: what it foresees, what found no room, whether it is too small.
    ///
    /// Foreseen is what has followed an action on the same percept before; unknown, an action that was
    /// not done there yet, or not for so long that it was given up.
    #[must_use]
    pub fn health(&self) -> Health {
        let it = self.filled();
        let schemas = (self.reason.filled(), R::CAPACITIES[1]);
        let tables = [it.leaves, it.rows, it.states, it.links, schemas];
        self.gauge.health(State {
            fullest: fullest(&tables),
            alarms: self.alarms(),
            pending: self.pending(),
            bearable: BEARABLE,
        })
    }
}

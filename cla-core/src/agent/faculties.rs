//! What an agent knows and what it makes of it: tables, second level, habits, alarm.
//!
//! They are asked what they prefer and told what came of an action; the agent around them has the
//! maps, the stage of life and its turns.

use super::config::AgentConfig;
use super::step::{Level, Transition};
use super::trail::Trail;
use crate::adaptation::{Alarm, SurpriseConfig};
use crate::choice::{ChoiceRule, Habits, MOST_A_STEP, Preference, Voice};
use crate::knowledge::{KnowledgeBase, Outcome, SchemaId, SyntheticId};
use crate::level2::{Fallback, SecondLevel};
use crate::map::ActionSom;
use crate::som::Prototypes;
use crate::word::{Cost, ItemId, ItemStates};

/// What an agent knows, prefers and feels.
#[derive(Clone, Debug)]
pub(super) struct Faculties<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
> {
    pub(super) knowledge: KnowledgeBase<WORDS, PATTERNS, SCHEMAS>,
    pub(super) level2: SecondLevel<ACTIONS, SYNTHETIC, BELIEFS>,
    pub(super) habits: Habits<WORDS, ITEMS, ACTIONS, SYNTHETIC>,
    pub(super) trail: Trail<WORDS>,
    pub(super) alarm: Alarm,
    /// Values of habits that have moved in this step.
    pub(super) practised: u32,
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const PATTERNS: usize,
    const SCHEMAS: usize,
    const SYNTHETIC: usize,
    const BELIEFS: usize,
> Faculties<WORDS, ITEMS, ACTIONS, PATTERNS, SCHEMAS, SYNTHETIC, BELIEFS>
{
    /// Faculties that know nothing, of all-zero memory.
    pub(super) const fn new() -> Self {
        Self {
            knowledge: KnowledgeBase::new(),
            level2: SecondLevel::new(),
            habits: Habits::new(),
            trail: Trail::NONE,
            alarm: Alarm::NONE,
            practised: 0,
        }
    }

    /// Forgets everything; these items alone are worth having from now on.
    pub(super) fn be_born(&mut self, values: &[(ItemId, f32)]) {
        self.knowledge.clear();
        self.knowledge.set_inherent_values(values);
        self.level2.clear();
        self.habits.clear();
        self.trail = Trail::NONE;
        self.alarm = Alarm::NONE;
    }

    /// All that its tables have lost so far: schemas and patterns that found no room or made some, and
    /// schemas that found none at level 2; items and beliefs that give way to new ones are out of use.
    pub(super) fn losses(&self) -> u32 {
        let (one, two) = (self.knowledge.losses(), self.level2.losses());
        let lost = [
            one.evicted_schemas,
            one.refused_schemas,
            one.refused_patterns,
            two.refused_items,
        ];
        lost.into_iter().fold(0, u32::wrapping_add)
    }

    /// Schemas, patterns and synthetic items, each with the room for them.
    pub(super) fn filled(&self) -> [(u32, u32); 3] {
        [
            (self.knowledge.schemas().len() as u32, SCHEMAS as u32),
            (u32::from(self.knowledge.patterns()), PATTERNS as u32),
            (u32::from(self.level2.rows()), SYNTHETIC as u32),
        ]
    }

    /// What they have touched in this step.
    pub(super) fn cost(&self) -> Cost {
        let mut cost = self.knowledge.cost;
        cost.add(&self.level2.cost());
        cost.habits = self.practised;
        cost
    }

    /// A new step: nothing is touched yet.
    pub(super) fn forget_cost(&mut self) {
        self.knowledge.cost = Cost::NONE;
        self.level2.set_cost(Cost::NONE);
        self.practised = 0;
    }

    /// What the highest level that has something to say prefers; in a doubt that is level 1.
    pub(super) fn prefer(
        &mut self,
        config: &AgentConfig,
        now: &ItemStates<WORDS>,
    ) -> Option<(Level, Preference)> {
        let values = &config.values;
        let trace = self.trail.item_in(now);
        let voice = config.habits.as_ref().map(|habits| Voice {
            weight: habits.weight,
            worth: self.habits.worth(now.on(), trace),
        });
        let trace = trace.filter(|_| !self.alarm.doubts());
        if let (Some(level2), Some(trace)) = (&config.level2, trace) {
            let overloaded = match level2.fallback {
                Fallback::MeanReliability(share) => self.level2.is_overloaded(share),
                Fallback::Never | Fallback::ValueThenReliability => false,
            };
            let knowledge = &mut self.knowledge;
            let above = self
                .level2
                .prefer(knowledge, now, trace, values, level2, voice.as_ref())
                .filter(|_| !overloaded);
            if let Some(above) = above {
                let below = match level2.fallback {
                    Fallback::ValueThenReliability => {
                        knowledge.prefer_with(now, config.rule, values, voice.as_ref())
                    }
                    Fallback::Never | Fallback::MeanReliability(_) => None,
                };
                return match below {
                    Some(below) if below.value > above.value => Some((Level::One, below)),
                    _ => Some((Level::Two, above)),
                };
            }
        }
        let found = self
            .knowledge
            .prefer_with(now, config.rule, values, voice.as_ref());
        found.map(|preference| (Level::One, preference))
    }

    /// Learns from an own action by experience alone; `decided_after` is the trace at its choice.
    #[inline(never)]
    pub(super) fn practise(
        &mut self,
        config: &AgentConfig,
        step: &Transition<WORDS>,
        decided_after: Option<SyntheticId>,
    ) {
        let Some(habits) = &config.habits else {
            return;
        };
        let deed = (*step.before.on(), decided_after, step.action);
        let doubts = self.alarm.doubts();
        self.practised = self.habits.feel(deed, step.reward, doubts, habits);
    }

    /// Counts every prediction about the action right or wrong; in a doubt that can be resolved
    /// `relearns`, what no schema says becomes one first.
    pub(super) fn record(
        &mut self,
        config: &AgentConfig,
        step: &Transition<WORDS>,
        relearns: bool,
        frozen: bool,
    ) -> Outcome {
        let Transition {
            before,
            action,
            after,
            ..
        } = step;
        if relearns && self.alarm.doubts() {
            self.knowledge.count_hits(before, *action, after);
        }
        if frozen {
            self.knowledge.explain(before, *action, after)
        } else {
            self.knowledge
                .record(before, *action, after, config.forgetting)
        }
    }

    /// Follows what has succeeded to the second level, which learns from it unless `frozen`.
    #[inline(never)]
    pub(super) fn follow(
        &mut self,
        config: &AgentConfig,
        step: &Transition<WORDS>,
        succeeded: Option<SchemaId>,
        frozen: bool,
    ) {
        let Some(level2) = &config.level2 else {
            return;
        };
        let trace = self.trail.item_in(&step.before);
        let meant = trace.and_then(|trace| self.level2.schema(trace));
        let item = succeeded.and_then(|schema| {
            let known = self.level2.item_of(&self.knowledge, schema);
            if known.is_some() || frozen {
                return known;
            }
            let item = self.level2.reify(&mut self.knowledge, schema)?;
            self.habits.renew(item);
            Some(item)
        });
        if !frozen {
            // A new item may have taken the row of the trace.
            let trace = trace.filter(|&trace| self.level2.schema(trace) == meant);
            if let Some(trace) = trace {
                let discount = config.values.discount;
                self.level2
                    .learn(trace, step.action, item, step.reward, discount, level2);
            }
            if let Some(item) = item {
                self.level2.meet(item);
            }
        }
        self.trail.arrive(item, &step.after);
    }

    /// Brings some values of both levels up to date.
    #[inline(never)]
    pub(super) fn improve_values(&mut self, config: &AgentConfig) {
        let (values, knowledge) = (&config.values, &mut self.knowledge);
        knowledge.improve_values::<ACTIONS>(config.values_per_step.min(MOST_A_STEP), values);
        if let Some(level2) = &config.level2 {
            if let Some(trace) = self.trail.item() {
                self.level2.improve(knowledge, trace, values, level2);
            }
            let count = level2.values_per_step.min(MOST_A_STEP);
            self.level2.improve_values(knowledge, count, values, level2);
        }
    }

    /// Takes what the maps say now for the schemas.
    pub(super) fn harvest<const WIDTH: usize, const HEIGHT: usize, M: Prototypes<WIDTH, HEIGHT>>(
        &mut self,
        config: &AgentConfig,
        maps: &[ActionSom<WIDTH, HEIGHT, ITEMS, M>],
    ) {
        self.knowledge.harvest(maps, config.coding, &config.harvest);
        if config.rule == ChoiceRule::Lexicographic {
            self.knowledge.defer_values(&config.values);
        }
        if self.alarm.doubts() {
            self.knowledge.doubt_new();
        }
        self.level2.follow(&self.knowledge);
        let level2 = &self.level2;
        self.trail.keep(|item| level2.schema(item).is_some());
    }

    /// Settles the values, so that the first action of acting is already the best known.
    pub(super) fn settle(&mut self, config: &AgentConfig) {
        if config.rule != ChoiceRule::ExpectedValue {
            return;
        }
        let (values, knowledge) = (&config.values, &mut self.knowledge);
        knowledge.settle_values::<ACTIONS>(100, values);
        if let Some(level2) = &config.level2 {
            let rows = self.level2.rows();
            for _ in 0..30 {
                self.level2.improve_values(knowledge, rows, values, level2);
            }
        }
    }

    /// Doubts everything from now on.
    pub(super) fn doubt(&mut self, surprise: &SurpriseConfig) {
        self.alarm.ring(surprise);
        self.knowledge.begin_doubt();
    }

    /// Doubts what it knows after an alarm, and weighs the evidence while it doubts.
    #[inline(never)]
    pub(super) fn feel(&mut self, config: &AgentConfig, surprise: &SurpriseConfig, rewarded: bool) {
        let doubted = self.alarm.doubts();
        if self.alarm.feel(surprise, rewarded) {
            self.knowledge.begin_doubt();
        }
        if self.alarm.weighs() {
            // Like a harvest, it comes now and then and is no part of a tick.
            let cost = (self.knowledge.cost, self.level2.cost());
            self.knowledge.weigh::<ACTIONS>(surprise, &config.values);
            let knowledge = &self.knowledge;
            self.level2
                .doubt(knowledge, |context, action| knowledge.hold(context, action));
            self.knowledge.cost = cost.0;
            self.level2.set_cost(cost.1);
        }
        if !self.alarm.doubts() && doubted {
            self.believe();
        }
    }

    /// Ends a doubt that nothing can be learned from any more.
    #[inline(never)]
    pub(super) fn end_doubt(&mut self) {
        if self.alarm.doubts() {
            self.alarm.end();
            self.believe();
        }
    }

    /// What has become of the doubted is believed from now on.
    fn believe(&mut self) {
        self.knowledge.end_doubt();
        self.level2.forget_experience();
    }
}

//! The whole learner: senses, chooses, learns, within fixed memory and a fixed amount of work.
//!
//! One control step is [`choose`](Mind::choose), the action, [`learn`](Mind::learn).
//! All memory is inside the value, all of it zero at first: a static mind costs no flash.

use super::budget::WorkBudget;
use super::config::{Doubting, Heard, MindConfig, NO_CONFIG, Voice};
use super::doubt::Doubt;
use super::memory::Sample;
use super::model::{Model, State};
use super::moment::{Moment, NO_ACTION};
use super::replay::{drawn, replay};
use super::runs::Runs;
use super::sarsa::{Sarsa, Scene, number, step_of};
use super::step::{Actions, Deliberation, MindError, Motive, Said, Taught, check_reward};
use super::trees::{Forest, Horizon};
use super::voices::Voices;
use crate::check::Config;
use crate::num::Rng;
use crate::reason::Reasoning;
use crate::snapshot::stored_codes;
use crate::word::{ActionId, BEARABLE, Gauge, ItemSet, ItemStates};

/// How many voices there are.
const VOICES: usize = Voice::ALL.len();

/// The share of taken rows above which tables are crowded.
const CROWDED: f32 = 0.5;

/// Values that fade in the time of a unit.
const FADED_AT_ONCE: u32 = 6;

/// Values closer than this are the same.
const CLOSE: f32 = 1.0e-6;

/// What a mind is doing with its life.
#[repr(u8)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Age {
    Unborn,
    Training,
    Acting,
}

stored_codes!(Age {
    0: (Self::Unborn),
    1: (Self::Training),
    2: (Self::Acting)
});

/// A learner in fixed memory, the same in every world.
///
/// Capacities: words of an item set, items, actions, stretches of sixteen samples, leaves of a tree
/// of all actions, rows of the habits' last step, states and links of the model; and a reason, `()` for
/// none.
///
/// ```
/// use cla_core::word::{ActionId, ItemId, ItemStates};
/// use cla_core::forest::{Mind, MindConfig};
/// // Two items (a light is on, at the lamp) and two actions (stay, go): going when there is light
/// // leads to the lamp.
/// let mut mind = Box::new(Mind::<1, 2, 2, 32, 16, 32, 64, 256>::new());
/// mind.be_born(MindConfig::DEFAULT, [0.0, 1.0], 1)?;
/// let light = |on: bool| {
///     let mut now = ItemStates::all_off(2);
///     now.set(ItemId(0), Some(on)).map(|()| now)
/// };
/// for step in 0..400 {
///     let on = step % 2 == 0;
///     let choice = mind.choose(&light(on)?)?;
///     let mut after = light(!on)?;
///     after.set(ItemId(1), Some(on && choice.action == ActionId(1)))?;
///     mind.learn(&after)?;
/// }
/// assert_eq!(mind.choose(&light(true)?)?.action, ActionId(1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Mind<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R = (),
> {
    pub(super) forest: Forest<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES>,
    pub(super) habits: Sarsa<WORDS, ITEMS, ACTIONS, ROWS>,
    pub(super) model: Model<ACTIONS, STATES, LINKS>,
    /// The last deed as the model sees it, its action and what it brought.
    pub(super) state: State,
    pub(super) did: u8,
    pub(super) brought: f32,
    pub(super) voices: Voices<VOICES>,
    pub(super) runs: Runs<ITEMS>,
    pub(super) doubt: Doubt,
    pub(super) values: [f32; ITEMS],
    pub(super) config: MindConfig,
    pub(super) rng: Rng,
    pub(super) age: Age,
    /// What was perceived when the last action was chosen, and that action.
    pub(super) before: ItemStates<WORDS>,
    pub(super) last: u8,
    /// The action whose result is awaited, where it was chosen, and why.
    pub(super) chosen: u8,
    pub(super) now: ItemStates<WORDS>,
    /// Actions since anything was earned, how long that mostly is, and how often it happened.
    pub(super) since: u16,
    pub(super) wait: f32,
    pub(super) earned: u16,
    pub(super) burst: u16,
    pub(super) reason: R,
    /// Whether the leader of the block chose.
    pub(super) led: bool,
    /// Actions of chance that follow each other, those that are left.
    pub(super) stroll: u16,
    /// What the last choice was, for whom asks why.
    pub(super) said: Said,
    pub(super) gauge: Gauge,
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
    /// An unborn mind of all-zero memory, with the reason of its type, if any.
    #[must_use]
    pub const fn unborn() -> Self {
        const {
            assert!(ITEMS <= WORDS * 32, "an item needs a bit: 32 for each word");
            assert!(ACTIONS > 0 && ACTIONS <= 32, "a robot has 1 to 32 actions");
            assert!(
                2 * ITEMS + ACTIONS < 255,
                "twice the items and the actions are less than 255"
            );
            assert!(ROWS > 0 && ROWS < 65_536, "habits have 1 to 65,535 rows");
        }
        Self {
            forest: Forest::new(),
            habits: Sarsa::new(),
            model: Model::new(),
            state: State {
                step: 0,
                percept: 0,
            },
            did: 0,
            brought: 0.0,
            voices: Voices::new(),
            runs: Runs::new(),
            doubt: Doubt::new(),
            values: [0.0; ITEMS],
            config: NO_CONFIG,
            rng: Rng::UNSEEDED,
            age: Age::Unborn,
            before: ItemStates::UNKNOWN,
            last: 0,
            chosen: 0,
            now: ItemStates::UNKNOWN,
            since: 0,
            wait: 0.0,
            earned: 0,
            burst: 0,
            reason: R::NEW,
            led: false,
            stroll: 0,
            said: Said::NOTHING,
            gauge: Gauge::NONE,
        }
    }

    /// A life begins: `values` says what it is worth when an item is on after an action, negative
    /// for harm; `seed` decides everything that is left to chance.
    ///
    /// # Errors
    /// When the configuration cannot work or a value is no number; the mind is as it was.
    pub fn be_born(
        &mut self,
        config: MindConfig,
        values: [f32; ITEMS],
        seed: u64,
    ) -> Result<(), MindError> {
        config.check().map_err(MindError::Config)?;
        for value in values {
            check_reward(value)?;
        }
        self.rng = Rng::stream(seed, 9);
        self.forest.begin(self.rng.next_u32());
        self.habits.clear();
        self.model.clear();
        self.did = NO_ACTION;
        self.voices = Voices::new();
        self.runs = Runs::new();
        self.doubt = Doubt::new();
        self.reason.begin(values, seed);
        self.led = false;
        self.stroll = 0;
        self.said = Said::NOTHING;
        self.values = values;
        self.config = config;
        self.age = Age::Training;
        self.last = NO_ACTION;
        self.chosen = NO_ACTION;
        self.since = 0;
        self.wait = 0.0;
        self.earned = 0;
        self.burst = 0;
        self.begin_health();
        Ok(())
    }

    /// Training is over: it goes on learning, and tries less.
    ///
    /// # Errors
    /// [`MindError::Unborn`].
    pub fn act(&mut self) -> Result<(), MindError> {
        self.born()?;
        self.age = Age::Acting;
        self.since = 0;
        self.burst = 0;
        self.stroll = 0;
        Ok(())
    }

    pub(super) fn born(&self) -> Result<(), MindError> {
        if self.age == Age::Unborn {
            return Err(MindError::Unborn);
        }
        Ok(())
    }

    /// What to do now.
    ///
    /// # Errors
    /// [`MindError::Unborn`].
    pub fn choose(&mut self, now: &ItemStates<WORDS>) -> Result<Deliberation, MindError> {
        self.choose_among(now, Actions::ALL)
    }

    /// What to do now, of the actions that are allowed.
    ///
    /// # Errors
    /// [`MindError::Unborn`], or [`MindError::NothingAllowed`].
    pub fn choose_among(
        &mut self,
        now: &ItemStates<WORDS>,
        allowed: Actions,
    ) -> Result<Deliberation, MindError> {
        self.born()?;
        let mut count = 0;
        for action in 0..ACTIONS as u16 {
            count += u32::from(allowed.contains(ActionId(action)));
        }
        if count == 0 {
            return Err(MindError::NothingAllowed);
        }
        let seen = self.runs.believed(now);
        self.reason.perceive(&seen);
        let prospects = self.reason.prospects(&seen);
        if let Some(step) = self.step(&prospects, allowed) {
            self.led = false;
            return Ok(self.settle(step, seen));
        }
        self.led = !self.trusts(&prospects, allowed);
        let leader = if self.led {
            self.leader()
        } else {
            Voice::Plans
        };
        let values = match leader {
            Voice::Plans => Self::planned(&prospects, allowed),
            _ => None,
        };
        let values = values.unwrap_or_else(|| self.speak(leader, &seen));
        let mut motive = Motive::Voice(leader);
        let mut best = f32::MIN;
        for (action, value) in values.iter().enumerate() {
            if allowed.contains(ActionId(action as u16)) {
                best = best.max(*value);
            }
        }
        let mut candidates = allowed;
        if let Some(reason) = self.restless() {
            motive = reason;
        } else {
            count = 0;
            for (action, value) in values.iter().enumerate() {
                let action = ActionId(action as u16);
                if *value < best - CLOSE {
                    candidates = candidates.without(action);
                } else if candidates.contains(action) {
                    count += 1;
                }
            }
        }
        let mut drawn = self.rng.below(count);
        let mut action = ActionId(0);
        for candidate in 0..ACTIONS as u16 {
            if candidates.contains(ActionId(candidate)) {
                action = ActionId(candidate);
                if drawn == 0 {
                    break;
                }
                drawn -= 1;
            }
        }
        let value = values.get(usize::from(action.0)).copied().unwrap_or(0.0);
        let choice = Deliberation {
            action,
            value,
            motive,
        };
        Ok(self.settle(choice, seen))
    }

    fn settle(&mut self, choice: Deliberation, seen: ItemStates<WORDS>) -> Deliberation {
        self.chosen = choice.action.0 as u8;
        self.now = seen;
        self.said = Said::of(choice);
        choice
    }

    fn leader(&mut self) -> Voice {
        let trying = match self.age {
            Age::Acting => self.config.trying_acting,
            _ => self.config.trying,
        };
        let mut heard = self.config.heard;
        if !R::THERE && heard != Heard::only(Voice::Plans) {
            heard = heard.without(Voice::Plans);
        }
        let doubting = heard.among(self.config.heard_doubting);
        if self.doubt.lasts() && doubting != Heard::NOBODY {
            heard = doubting;
        }
        let heard = heard.bits();
        let leader = self
            .voices
            .lead(self.config.block, trying, heard, &mut self.rng);
        let voice = Voice::ALL.get(usize::from(leader)).copied();
        voice.unwrap_or(Voice::TreesAndHabits)
    }

    pub(super) fn moment(&self, now: &ItemStates<WORDS>) -> Moment<WORDS> {
        let mut moment = Moment::first(now);
        if self.last != NO_ACTION {
            moment.before = self.before;
            moment.action = self.last;
        }
        moment
    }

    fn scene(&self, now: &ItemStates<WORDS>) -> (Scene<WORDS>, State) {
        let (mask, moment) = (self.forest.mask(), self.moment(now));
        let scene = Scene::of(&moment, mask, ROWS as u16);
        let step = step_of(&moment, mask);
        let percept = number(&ItemSet::<WORDS>::EMPTY, 254, &scene.on);
        (scene, State { step, percept })
    }

    /// What a voice holds each action to be worth.
    fn speak(&self, voice: Voice, now: &ItemStates<WORDS>) -> [f32; ACTIONS] {
        let (scene, state) = self.scene(now);
        let trees = || self.forest.values(&self.moment(now)).0;
        let habits = || self.habits.worth(&scene, self.config.habit_discount);
        let model = || self.model.values(state);
        match voice {
            Voice::TreesAndHabits => halves(trees(), habits()),
            Voice::Trees => trees(),
            // Where plans prefer nothing, habits speak for them.
            Voice::Habits | Voice::Plans => habits(),
            Voice::Model => model(),
            Voice::ModelAndHabits => halves(model(), habits()),
        }
    }

    /// The action that was chosen last has led to `now`.
    ///
    /// # Errors
    /// [`MindError::Unborn`], or [`MindError::NothingChosen`].
    pub fn learn(&mut self, now: &ItemStates<WORDS>) -> Result<Taught, MindError> {
        self.learn_with(now, 0.0)
    }

    /// The same, and it brought a reward, or harm, beside that of the valued items.
    ///
    /// # Errors
    /// As [`learn`](Self::learn), and [`MindError::Reward`].
    pub fn learn_with(
        &mut self,
        now: &ItemStates<WORDS>,
        reward: f32,
    ) -> Result<Taught, MindError> {
        self.born()?;
        check_reward(reward)?;
        if self.chosen == NO_ACTION {
            return Err(MindError::NothingChosen);
        }
        let reward = reward + self.worth_of(now);
        let (seen, action) = (self.now, self.chosen);
        self.chosen = NO_ACTION;
        if self.led {
            self.voices.gather(reward);
        }
        self.runs.count(now);
        self.notice(reward);
        let mut budget = WorkBudget::of(self.config.work);
        let doubts = self.config.doubting == Doubting::WhenRewardsStayAway;
        if doubts && self.doubt.notice(reward > 0.0, self.config.doubt_lasts) {
            self.forest.doubt();
            self.habits.fade(self.config.kept_doubting);
            budget.spend((ROWS * ACTIONS) as u32 / FADED_AT_ONCE);
            let trials = self.config.trials_doubting;
            if trials < self.config.remembered {
                budget.spend(self.model.doubt(trials));
            }
        }
        let after = self.runs.believed(now);
        self.reason
            .observe(&seen, ActionId(action.into()), &after, reward);
        self.take_in(&seen, action, reward, false);
        budget.spend(self.replay());
        Ok(Taught {
            reward,
            refocused: self.idle(budget.left()),
            cramped: self.gauge.cramped(BEARABLE),
        })
    }

    /// Somebody else's action, a reflex or a teacher, has led from `before` to `after`: it is learned
    /// from as from one's own.
    ///
    /// # Errors
    /// [`MindError::Unborn`], or [`MindError::NoSuchAction`].
    pub fn observe(
        &mut self,
        before: &ItemStates<WORDS>,
        action: ActionId,
        after: &ItemStates<WORDS>,
    ) -> Result<Taught, MindError> {
        self.born()?;
        if usize::from(action.0) >= ACTIONS {
            return Err(MindError::NoSuchAction(action));
        }
        let seen = self.runs.believed(before);
        let reward = self.worth_of(after);
        let then = self.runs.believed(after);
        self.reason.observe(&seen, action, &then, reward);
        self.take_in(&seen, action.0 as u8, reward, true);
        let mut budget = WorkBudget::of(self.config.work);
        budget.spend(self.replay());
        Ok(Taught {
            reward,
            refocused: self.idle(budget.left()),
            cramped: self.gauge.cramped(BEARABLE),
        })
    }

    /// The episode is over: what comes next has nothing to do with what was.
    ///
    /// # Errors
    /// [`MindError::Unborn`].
    pub fn interrupt(&mut self) -> Result<(), MindError> {
        self.born()?;
        self.forest.interrupt();
        self.voices.interrupt();
        self.reason.interrupt();
        let rates = self.config.habit_rates(self.doubt.lasts());
        self.habits.end(&rates);
        self.follow(None);
        self.last = NO_ACTION;
        self.chosen = NO_ACTION;
        Ok(())
    }

    /// Works for up to so many units on what is pending, as a robot that has time may; answers
    /// whether other items matter from now on.
    pub fn idle(&mut self, units: u32) -> bool {
        if self.age == Age::Unborn {
            return false;
        }
        // Reason takes three quarters, or what it needs.
        let units = units.saturating_sub(self.reason.work(units - units / 4));
        let crowded = self.habits.crowding() > CROWDED;
        let horizon = Horizon {
            discount: self.config.discount,
            lambda: self.config.lambda,
        };
        let changed = self
            .forest
            .work(&mut WorkBudget::of(units), horizon, crowded);
        if changed {
            self.habits.forget_rows();
            self.model.clear();
            self.did = NO_ACTION;
        }
        changed
    }

    /// Whether there is work that [`idle`](Self::idle) could do.
    #[must_use]
    pub fn pending(&self) -> bool {
        self.age != Age::Unborn && (self.forest.is_pending() || self.reason.pending())
    }

    /// Habits learn again from a stretch of the memory; answers the units.
    fn replay(&mut self) -> u32 {
        let how = self.config.replaying(self.doubt.lasts());
        let (memory, mask) = (self.forest.memory(), self.forest.mask());
        match drawn(memory, &mut self.rng) {
            Some(at) => replay(
                &mut self.habits,
                memory,
                mask,
                at,
                self.config.replayed,
                &how,
            ),
            None => 0,
        }
    }

    fn worth_of(&self, now: &ItemStates<WORDS>) -> f32 {
        let mut worth = 0.0;
        for item in now.on().iter() {
            worth += self.values.get(usize::from(item.0)).copied().unwrap_or(0.0);
        }
        worth
    }

    /// The last deed was followed by this state, or by nothing.
    fn follow(&mut self, to: Option<State>) {
        let rates = self.config.model_rates(self.doubt.lasts());
        if self.did != NO_ACTION {
            let told = self
                .model
                .learn(self.state, self.did, self.brought, to, &rates);
            self.gauge.count(told, self.losses());
        }
        self.did = NO_ACTION;
        self.model.spread(self.config.spread, &rates);
    }

    /// How long rewards mostly take to come.
    fn notice(&mut self, reward: f32) {
        self.since = self.since.saturating_add(1);
        if reward > 0.0 {
            self.earned = self.earned.saturating_add(1);
            let share = (1.0 / f32::from(self.earned)).max(0.05);
            self.wait += share * (f32::from(self.since) - self.wait);
            self.since = 0;
        }
    }

    fn take_in(&mut self, seen: &ItemStates<WORDS>, action: u8, reward: f32, watched: bool) {
        let (scene, state) = self.scene(seen);
        let rates = self.config.habit_rates(self.doubt.lasts());
        self.habits.feel(scene, action, reward, &rates);
        self.follow(Some(state));
        self.state = state;
        self.did = action;
        self.brought = reward;
        let mut sample = Sample::new(seen, action, reward);
        if watched {
            sample = sample.watched();
        }
        if self.last == NO_ACTION {
            sample = sample.beginning();
        }
        self.forest.remember(sample);
        self.before = *seen;
        self.last = action;
        self.said = Said::NOTHING;
    }
}

fn halves<const ACTIONS: usize>(one: [f32; ACTIONS], other: [f32; ACTIONS]) -> [f32; ACTIONS] {
    let mut mean = one;
    for (mean, other) in mean.iter_mut().zip(other) {
        *mean = 0.5 * (*mean + other);
    }
    mean
}

#[cfg(test)]
#[path = "mind_tests.rs"]
mod tests;

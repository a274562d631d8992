//! The one learner behind a door that does not show its capacities, which Python chooses at run time.

use cla_core::forest::{Actions, Deliberation, Feature, Mind, MindConfig, MindError, Voice};
use cla_core::growth::SimpleSchema;
use cla_core::reason::{Pursuit, Reason, Reasoning, Way};
use cla_core::snapshot::{self, Names, Stored};
use cla_core::word::{ActionId, ItemId, ItemStates, SignedItems};
use host_sim::learner::image::image_of;
use host_sim::world::Percept;

/// A context, an action and what follows, by the numbers of items.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Said {
    pub(crate) context: Vec<(u16, bool)>,
    /// What held, or did not, when the action before was chosen; asked by trees alone.
    pub(crate) before: Vec<(u16, bool)>,
    /// The action before and whether it was that one; asked by trees alone.
    pub(crate) after: Vec<(u16, bool)>,
    pub(crate) action: u16,
    pub(crate) result: Vec<(u16, bool)>,
    /// What the action is held to be worth there, in discounted rewards.
    pub(crate) value: Option<f32>,
    /// Successes and activations.
    pub(crate) tried: Option<(u16, u16)>,
}

/// What a look inside says.
#[derive(Clone, Debug)]
pub(crate) struct Inside {
    pub(crate) samples: u16,
    pub(crate) leaves: u16,
    pub(crate) grown: u32,
    pub(crate) alarms: u32,
    pub(crate) doubts: bool,
    pub(crate) stuck: u16,
    pub(crate) crowding: f32,
    pub(crate) given_up: u32,
    pub(crate) schemas: usize,
    pub(crate) imagined: u16,
    pub(crate) bytes: usize,
    /// What an action under each voice brought, and the blocks it has led.
    pub(crate) voices: Vec<(Voice, f32, u16)>,
}

/// What every mind can be asked, whatever its capacities.
pub(crate) trait Being: Send + Sync {
    fn choose(&mut self, now: &Percept, allowed: Actions) -> Result<Deliberation, MindError>;
    fn learn(&mut self, now: &Percept, reward: f32) -> Result<f32, MindError>;
    fn observe(&mut self, before: &Percept, by: u16, after: &Percept) -> Result<f32, MindError>;
    fn interrupt(&mut self) -> Result<(), MindError>;
    fn act(&mut self) -> Result<(), MindError>;
    fn idle(&mut self, units: u32);
    fn pending(&self) -> bool;
    fn pursue(&mut self, goal: &[(u16, bool)], limit: u16, now: &Percept) -> Result<(), String>;
    fn give_up(&mut self);
    fn pursuit(&self) -> Pursuit;
    fn way(&self, now: &Percept) -> Way;
    fn explain(&self) -> Option<(Said, Deliberation)>;
    fn schemas(&self) -> Vec<Said>;
    fn inside(&self) -> Inside;
    /// What each item of the robot is worth.
    fn values(&self) -> Vec<f32>;
    fn config(&self) -> MindConfig;
    fn save(&self, names: Names) -> Result<Vec<u8>, String>;
    fn load(&mut self, names: Names, image: &[u8]) -> Result<(), String>;
}

/// What Python asks of a reason, if there is one.
pub(crate) trait Thinking<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize>:
    Reasoning<WORDS, ITEMS, ACTIONS> + Stored + Send + Sync + 'static
{
    /// Every schema that it has.
    fn all(&self) -> &[SimpleSchema];
    /// States that it imagines.
    fn states(&self) -> u16;
}

impl<const WORDS: usize, const ITEMS: usize, const ACTIONS: usize> Thinking<WORDS, ITEMS, ACTIONS>
    for ()
{
    fn all(&self) -> &[SimpleSchema] {
        &[]
    }

    fn states(&self) -> u16 {
        0
    }
}

impl<
    const WORDS: usize,
    const ITEMS: usize,
    const ACTIONS: usize,
    const SAMPLES: usize,
    const SCHEMAS: usize,
    const NODES: usize,
> Thinking<WORDS, ITEMS, ACTIONS> for Reason<WORDS, ITEMS, ACTIONS, SAMPLES, SCHEMAS, NODES>
{
    fn all(&self) -> &[SimpleSchema] {
        self.schemas()
    }

    fn states(&self) -> u16 {
        self.imagined()
    }
}

/// A mind of a robot that may have fewer items and actions than fit.
pub(crate) struct Life<M> {
    mind: Box<M>,
    items: usize,
    actions: usize,
}

/// A percept in the words of a mind; items that the robot does not have are off for ever.
fn seen<const WORDS: usize, const ITEMS: usize>(now: &Percept, items: usize) -> ItemStates<WORDS> {
    let mut states = ItemStates::all_off(ITEMS as u16);
    for index in 0..items.min(ITEMS) {
        let item = ItemId(index as u16);
        let state = now.get(item);
        if state != Some(false) {
            // As many items as there are fit.
            let _ = states.set(item, state);
        }
    }
    states
}

fn listed<const WORDS: usize>(items: &SignedItems<WORDS>) -> Vec<(u16, bool)> {
    let on = items.positive().iter().map(|item| (item.0, true));
    on.chain(items.negative().iter().map(|item| (item.0, false)))
        .collect()
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
> Life<Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>>
where
    R: Thinking<WORDS, ITEMS, ACTIONS>,
{
    /// A newborn of a robot with so many actions and an item for each value.
    pub(crate) fn born(
        config: MindConfig,
        values: &[f32],
        actions: usize,
        seed: u64,
    ) -> Result<Box<dyn Being>, MindError> {
        let mut worth = [0.0; ITEMS];
        for (place, value) in worth.iter_mut().zip(values) {
            *place = *value;
        }
        let mut mind = Box::new(Mind::unborn());
        mind.be_born(config, worth, seed)?;
        Ok(Box::new(Self {
            mind,
            items: values.len(),
            actions,
        }))
    }

    fn see(&self, now: &Percept) -> ItemStates<WORDS> {
        seen::<WORDS, ITEMS>(now, self.items)
    }

    /// Contexts of the trees, where there is no reason to ask.
    fn contexts(&self) -> Vec<Said> {
        let mut all = Vec::new();
        for action in 0..self.actions as u16 {
            self.mind.contexts(ActionId(action), |path, value| {
                let mut said = Said {
                    action,
                    value: Some(value),
                    ..Said::default()
                };
                for &(feature, yes) in path {
                    match feature {
                        Feature::Now(item) => said.context.push((item.0, yes)),
                        Feature::Before(item) => said.before.push((item.0, yes)),
                        Feature::After(action) => said.after.push((action.0, yes)),
                    }
                }
                all.push(said);
            });
        }
        all
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
    R,
> Being for Life<Mind<WORDS, ITEMS, ACTIONS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>>
where
    R: Thinking<WORDS, ITEMS, ACTIONS>,
{
    fn choose(&mut self, now: &Percept, allowed: Actions) -> Result<Deliberation, MindError> {
        let mut possible = Actions::ALL;
        for action in 0..ACTIONS as u16 {
            let id = ActionId(action);
            if usize::from(action) >= self.actions || !allowed.contains(id) {
                possible = possible.without(id);
            }
        }
        self.mind.choose_among(&self.see(now), possible)
    }

    fn learn(&mut self, now: &Percept, reward: f32) -> Result<f32, MindError> {
        let now = self.see(now);
        Ok(self.mind.learn_with(&now, reward)?.reward)
    }

    fn observe(&mut self, before: &Percept, by: u16, after: &Percept) -> Result<f32, MindError> {
        if usize::from(by) >= self.actions {
            return Err(MindError::NoSuchAction(ActionId(by)));
        }
        let (before, after) = (self.see(before), self.see(after));
        Ok(self.mind.observe(&before, ActionId(by), &after)?.reward)
    }

    fn interrupt(&mut self) -> Result<(), MindError> {
        self.mind.interrupt()
    }

    fn act(&mut self) -> Result<(), MindError> {
        self.mind.act()
    }

    fn idle(&mut self, units: u32) {
        self.mind.idle(units);
    }

    fn pending(&self) -> bool {
        self.mind.pending()
    }

    fn pursue(&mut self, goal: &[(u16, bool)], limit: u16, now: &Percept) -> Result<(), String> {
        let mut items = SignedItems::EMPTY;
        for &(item, sign) in goal {
            let entered = items.insert(ItemId(item), sign);
            entered.map_err(|it| it.to_string())?;
        }
        let now = self.see(now);
        let begun = self.mind.pursue(items, limit, &now);
        begun.map(|_| ()).map_err(|it| it.to_string())
    }

    fn give_up(&mut self) {
        self.mind.give_up();
    }

    fn pursuit(&self) -> Pursuit {
        self.mind.pursuit()
    }

    fn way(&self, now: &Percept) -> Way {
        self.mind.way(&self.see(now))
    }

    fn explain(&self) -> Option<(Said, Deliberation)> {
        let why = self.mind.explain()?;
        let said = Said {
            context: listed(&why.schema.context),
            action: why.schema.action.0,
            result: listed(&why.schema.result),
            value: Some(why.value),
            ..Said::default()
        };
        let decided = Deliberation {
            action: why.schema.action,
            value: why.value,
            motive: why.motive,
        };
        Some((said, decided))
    }

    fn schemas(&self) -> Vec<Said> {
        if !R::THERE {
            return self.contexts();
        }
        let told = |it: &SimpleSchema| Said {
            context: it.context().map(|(item, sign)| (item.0, sign)).collect(),
            action: it.action().0,
            result: vec![(it.result_item().0, it.result_sign())],
            tried: Some((it.successes(), it.activations())),
            ..Said::default()
        };
        self.mind.reason().all().iter().map(told).collect()
    }

    fn inside(&self) -> Inside {
        let (samples, leaves, grown) = self.mind.size();
        let told = |voice| {
            let (earned, led) = self.mind.record(voice);
            (voice, earned, led)
        };
        Inside {
            samples,
            leaves,
            grown,
            alarms: self.mind.alarms(),
            doubts: self.mind.doubts(),
            stuck: self.mind.stuck(),
            crowding: self.mind.crowding(),
            given_up: self.mind.given_up(),
            schemas: self.mind.reason().all().len(),
            imagined: self.mind.reason().states(),
            bytes: size_of_val(&*self.mind),
            voices: Voice::ALL.map(told).to_vec(),
        }
    }

    fn values(&self) -> Vec<f32> {
        let items = (0..self.items).map(|index| ItemId(index as u16));
        items.map(|item| self.mind.value(item)).collect()
    }

    fn config(&self) -> MindConfig {
        *self.mind.config()
    }

    fn save(&self, names: Names) -> Result<Vec<u8>, String> {
        image_of(&*self.mind, names).map_err(|it| it.to_string())
    }

    fn load(&mut self, names: Names, image: &[u8]) -> Result<(), String> {
        // Whoever loads an image with something behind it keeps what it was.
        let mut fresh = Box::new(Mind::unborn());
        let mut source = image;
        let length = snapshot::load(&mut *fresh, names, &mut source);
        let length = length.map_err(|it| it.to_string())?;
        if length as usize != image.len() {
            return Err("there are bytes behind the image".to_owned());
        }
        self.mind = fresh;
        Ok(())
    }
}

//! The learner, as the class `Agent` of the module; the class that Python sees stands on it.

use std::collections::HashMap;

use cla_core::forest::{Actions, Deliberation, MindConfig, Motive, Voice};
use cla_core::reason::{Pursuit, Way};
use cla_core::snapshot::Names;
use cla_core::word::ActionId;
use host_sim::failure::Failure;
use host_sim::learner::Learner;
use host_sim::learner::digest::{Digest, Digested};
use host_sim::learner::rewarded::{Income, rewarded};
use host_sim::world::Percept;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::being::{Being, Said};
use crate::guard::{guarded, refused};
use crate::percept;
use crate::profile;
use crate::world::World;

/// Actions of a life after which Python may interrupt it.
const BLOCK: u64 = 2_000;

/// A mind that was born.
#[pyclass(module = "cla._native")]
pub(crate) struct Agent {
    mind: Box<dyn Being>,
    items: Vec<String>,
    actions: Vec<String>,
    form: (usize, usize),
    digest: Digest,
}

/// A mind in a world that pays it, or that is paid by its valued items alone.
struct Living<'a> {
    mind: &'a mut dyn Being,
    paid: bool,
}

impl Learner for Living<'_> {
    fn choose(&mut self, now: &Percept) -> Result<usize, Failure> {
        Ok(usize::from(self.mind.choose(now, Actions::ALL)?.action.0))
    }

    fn learn(&mut self, now: &Percept) -> Result<(), Failure> {
        self.learn_with(now, 0.0)
    }

    fn learn_with(&mut self, now: &Percept, reward: f32) -> Result<(), Failure> {
        self.mind.learn(now, if self.paid { reward } else { 0.0 })?;
        Ok(())
    }

    fn interrupt(&mut self) -> Result<(), Failure> {
        Ok(self.mind.interrupt()?)
    }

    fn observe(&mut self, before: &Percept, by: usize, after: &Percept) -> Result<(), Failure> {
        self.mind.observe(before, by as u16, after)?;
        Ok(())
    }
}

#[pymethods]
impl Agent {
    /// A newborn of a profile, with a value for every item.
    #[new]
    fn new(
        items: Vec<String>,
        actions: Vec<String>,
        values: Vec<f32>,
        profile: &str,
        seed: u64,
        config: HashMap<String, f64>,
    ) -> PyResult<Self> {
        guarded(|| {
            if values.len() != items.len() {
                let (values, items) = (values.len(), items.len());
                return Err(refused(format_args!(
                    "{items} items have {items} values, not {values}"
                )));
            }
            let config = configured(config).map_err(refused)?;
            let form = profile::form(profile, items.len(), actions.len()).map_err(refused)?;
            let mind = profile::born(profile, config, &values, actions.len(), seed);
            Ok(Self {
                mind: mind.map_err(refused)?,
                items,
                actions,
                form,
                digest: Digest::NEW,
            })
        })
    }

    /// Chooses among the actions of a mask; the action, its value, and who decided.
    fn choose(
        &mut self,
        now: PyReadonlyArray1<'_, i8>,
        allowed: Option<Vec<usize>>,
    ) -> PyResult<(u16, f32, String)> {
        let now = percept::read(&now, self.items.len())?;
        let allowed = match allowed {
            None => Actions::ALL,
            Some(some) => self.mask(&some)?,
        };
        guarded(|| {
            let choice = self.mind.choose(&now, allowed).map_err(refused)?;
            self.digest.percept(&now);
            self.digest.action(usize::from(choice.action.0));
            Ok((choice.action.0, choice.value, motive(&choice)))
        })
    }

    /// What was chosen has led here; `reward` beside the valued items; answers all that it brought.
    fn learn(&mut self, now: PyReadonlyArray1<'_, i8>, reward: f32) -> PyResult<f32> {
        let now = percept::read(&now, self.items.len())?;
        guarded(|| {
            let felt = self.mind.learn(&now, reward).map_err(refused)?;
            self.digest.percept(&now);
            self.digest.reward(reward);
            Ok(felt)
        })
    }

    /// Somebody else's action, or a reflex, has led from one percept to another.
    fn observe(
        &mut self,
        before: PyReadonlyArray1<'_, i8>,
        action: u16,
        after: PyReadonlyArray1<'_, i8>,
    ) -> PyResult<f32> {
        let before = percept::read(&before, self.items.len())?;
        let after = percept::read(&after, self.items.len())?;
        guarded(|| {
            let felt = self.mind.observe(&before, action, &after);
            let felt = felt.map_err(refused)?;
            self.digest.percept(&before);
            self.digest.action(usize::from(action));
            self.digest.percept(&after);
            Ok(felt)
        })
    }

    /// The episode is over.
    fn interrupt(&mut self) -> PyResult<()> {
        guarded(|| self.mind.interrupt().map_err(refused))
    }

    /// Training is over.
    fn act(&mut self) -> PyResult<()> {
        guarded(|| self.mind.act().map_err(refused))
    }

    /// Works on what is pending.
    fn idle(&mut self, py: Python<'_>, units: u32) -> PyResult<bool> {
        let mind = &mut self.mind;
        guarded(|| {
            py.detach(|| mind.idle(units));
            Ok(mind.pending())
        })
    }

    /// Pursues a goal of item numbers and signs for so many actions.
    fn pursue(
        &mut self,
        goal: Vec<(u16, bool)>,
        limit: u16,
        now: PyReadonlyArray1<'_, i8>,
    ) -> PyResult<(String, u16)> {
        let now = percept::read(&now, self.items.len())?;
        guarded(|| self.mind.pursue(&goal, limit, &now).map_err(refused))?;
        Ok(self.pursuit())
    }

    /// Pursues nothing any more.
    fn give_up(&mut self) {
        self.mind.give_up();
    }

    /// How the last pursuit stands, and the actions that are left.
    fn pursuit(&self) -> (String, u16) {
        let (word, left) = match self.mind.pursuit() {
            Pursuit::Nothing => ("nothing", 0),
            Pursuit::Underway { left } => ("underway", left),
            Pursuit::Reached => ("reached", 0),
            Pursuit::TimedOut => ("timed out", 0),
        };
        (word.to_owned(), left)
    }

    /// Actions to the goal from here; none when no way is known.
    fn way(&self, now: PyReadonlyArray1<'_, i8>) -> PyResult<Option<u8>> {
        let now = percept::read(&now, self.items.len())?;
        Ok(match self.mind.way(&now) {
            Way::Actions(actions) => Some(actions),
            Way::Unknown => None,
        })
    }

    /// Why the last action was chosen: the schema, its value, who decided.
    fn explain(&self) -> Option<(String, f32, String)> {
        let (said, choice) = self.mind.explain()?;
        let text = format!(
            "{}/{}/{}",
            self.conjunction(&said.context),
            self.name_of(said.action),
            self.conjunction(&said.result)
        );
        Some((text, choice.value, motive(&choice)))
    }

    /// Every schema, or every context of the trees, as a dictionary.
    fn schemas<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let told = |said: Said| {
            let row = PyDict::new(py);
            row.set_item("context", self.conjunction(&said.context))?;
            row.set_item("before", self.conjunction(&said.before))?;
            let sign = |yes: bool| if yes { '+' } else { '-' };
            let after = said.after.iter();
            let after =
                after.map(|&(action, yes)| format!("{}{}", sign(yes), self.name_of(action)));
            row.set_item("after", after.collect::<String>())?;
            row.set_item("action", self.name_of(said.action))?;
            row.set_item("result", self.conjunction(&said.result))?;
            row.set_item("value", said.value)?;
            let (successes, activations) = said.tried.unzip();
            let share = said.tried.filter(|&(_, all)| all > 0);
            row.set_item(
                "reliability",
                share.map(|(good, all)| f64::from(good) / f64::from(all)),
            )?;
            row.set_item("successes", successes)?;
            row.set_item("activations", activations)?;
            Ok(row)
        };
        self.mind.schemas().into_iter().map(told).collect()
    }

    /// A look inside, as a dictionary.
    fn inside<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let it = self.mind.inside();
        let all = PyDict::new(py);
        all.set_item("samples", it.samples)?;
        all.set_item("leaves", it.leaves)?;
        all.set_item("grown", it.grown)?;
        all.set_item("alarms", it.alarms)?;
        all.set_item("doubts", it.doubts)?;
        all.set_item("stuck", it.stuck)?;
        all.set_item("crowding", it.crowding)?;
        all.set_item("given_up", it.given_up)?;
        all.set_item("schemas", it.schemas)?;
        all.set_item("imagined", it.imagined)?;
        all.set_item("bytes", it.bytes)?;
        let voices = PyDict::new(py);
        for (voice, earned, led) in it.voices {
            voices.set_item(voice_name(voice), (earned, led))?;
        }
        all.set_item("voices", voices)?;
        Ok(all)
    }

    /// Items and actions of the form that it lives in.
    #[getter]
    const fn form(&self) -> (usize, usize) {
        self.form
    }

    /// All that was perceived, chosen and felt, as one number.
    #[getter]
    const fn digest(&self) -> u64 {
        self.digest.value()
    }

    /// Lives in a world of the module; what it earned, the actions, the episodes.
    fn live(
        &mut self,
        py: Python<'_>,
        world: &mut World,
        actions: u64,
        paid: bool,
    ) -> PyResult<(f64, u64, u64)> {
        let items = world.stage.look().items();
        if items.len() != self.items.len()
            || world.stage.look().actions().len() != self.actions.len()
        {
            return Err(refused(format_args!(
                "the world has {} items and {} actions, and the agent {} and {}",
                items.len(),
                world.stage.look().actions().len(),
                self.items.len(),
                self.actions.len()
            )));
        }
        let (mut earned, mut done, mut episodes) = (0.0, 0, 0);
        while done < actions && !world.stage.look().finished() {
            let left = actions - done;
            let block = left
                .min(BLOCK)
                .min(world.stage.until_next().unwrap_or(BLOCK));
            let income = self.block(py, world, block, paid)?;
            earned += income.earned;
            episodes += u64::from(income.episodes);
            done += u64::from(income.actions);
            py.check_signals()?;
        }
        Ok((earned, done, episodes))
    }

    /// The image of its life.
    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        guarded(|| {
            let image = self.mind.save(self.names()).map_err(refused)?;
            Ok(PyBytes::new(py, &image))
        })
    }

    /// Takes a life from its image; with an error it is as it was.
    fn load(&mut self, image: &[u8], digest: u64) -> PyResult<()> {
        let names = self.names();
        guarded(|| self.mind.load(names, image).map_err(refused))?;
        self.digest = Digest::of(digest);
        Ok(())
    }
}

impl Agent {
    fn block(
        &mut self,
        py: Python<'_>,
        world: &mut World,
        actions: u64,
        paid: bool,
    ) -> PyResult<Income> {
        let (mind, digest) = (&mut *self.mind, self.digest);
        let stage = &mut world.stage;
        let lived = guarded(|| {
            py.detach(|| {
                let mut living = Living { mind, paid };
                let mut it = Digested::new(&mut living, digest);
                let income = rewarded(&mut it, stage.world(), actions as u32);
                let income = income.map_err(|it| it.to_string())?;
                let digest = it.digest();
                stage.pass(u64::from(income.actions))?;
                Ok((income, digest))
            })
            .map_err(|it: String| refused(it))
        })?;
        self.digest = lived.1;
        Ok(lived.0)
    }

    fn names(&self) -> Names {
        let [items, actions] = [&self.items, &self.actions].map(|names| {
            let names = names.iter().map(String::as_str);
            names.collect::<Vec<&str>>()
        });
        Names::of(&items, &actions)
    }

    fn mask(&self, some: &[usize]) -> PyResult<Actions> {
        let mut mask = Actions::NONE;
        for &action in some {
            if action >= self.actions.len() {
                let count = self.actions.len();
                return Err(refused(format_args!(
                    "there are {count} actions, and {action} is none of them"
                )));
            }
            mask = mask.with(ActionId(action as u16));
        }
        Ok(mask)
    }

    fn name_of(&self, action: u16) -> &str {
        self.actions
            .get(usize::from(action))
            .map_or("", String::as_str)
    }

    /// Signed items as the book writes them; those that the robot does not have say nothing.
    fn conjunction(&self, items: &[(u16, bool)]) -> String {
        let mut text = String::new();
        for &(item, sign) in items {
            if let Some(name) = self.items.get(usize::from(item)) {
                text.push(if sign { '+' } else { '-' });
                text.push_str(name);
            }
        }
        text
    }
}

const fn voice_name(voice: Voice) -> &'static str {
    match voice {
        Voice::TreesAndHabits => "trees and habits",
        Voice::Trees => "trees",
        Voice::Habits => "habits",
        Voice::Model => "model",
        Voice::ModelAndHabits => "model and habits",
        Voice::Plans => "plans",
    }
}

fn motive(choice: &Deliberation) -> String {
    let word = match choice.motive {
        Motive::Voice(voice) => voice_name(voice),
        Motive::Chance => "chance",
        Motive::Escape => "escape",
        Motive::Goal => "goal",
    };
    word.to_owned()
}

/// The default configuration with some numbers of its own.
fn configured(numbers: HashMap<String, f64>) -> Result<MindConfig, String> {
    let mut config = MindConfig::DEFAULT;
    for (field, number) in numbers {
        macro_rules! fields {
            (shares: $($share:ident),*; counts: $($count:ident: $most:ident),*) => {
                match field.as_str() {
                    $(stringify!($share) => config.$share = number as f32,)*
                    $(stringify!($count) => {
                        let fits = number >= 0.0 && number <= f64::from($most::MAX);
                        if !fits || number.fract() != 0.0 {
                            let most = $most::MAX;
                            return Err(format!("{field} is a whole number up to {most}, not {number}"));
                        }
                        config.$count = number as $most;
                    })*
                    _ => {
                        let known = [$(stringify!($share),)* $(stringify!($count)),*].join(", ");
                        return Err(format!("the configuration has no {field:?}: there are {known}"));
                    }
                }
            };
        }
        fields! {
            shares: exploring, exploring_acting, discount, lambda, habit_discount, habit_lambda,
                habit_rate, replay_rate, replay_rate_doubting, kept_doubting, trying, trying_acting,
                habit_rate_doubting, model_discount, remembered, remembered_doubting, prior, felt;
            counts: replayed: u16, block: u16, patience: u16, burst: u16, spread: u32, work: u32
        }
    }
    Ok(config)
}

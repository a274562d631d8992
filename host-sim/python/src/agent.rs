//! The learner, as the class `Agent` of the module; the class that Python sees stands on it.

use cla_core::forest::{Actions, Deliberation, MindConfig, Motive, Voice};
use cla_core::reason::{Pursuit, Way};
use cla_core::snapshot::Names;
use cla_core::word::ActionId;
use host_sim::failure::Impossible;
use host_sim::learner::digest::Digest;
use host_sim::settings;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

use crate::being::{Being, Said};
use crate::guard::{guarded, refused, with_room};
use crate::percept;
use crate::profile;
use crate::stage::Stage;
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

/// What came of a part of a life.
#[derive(Default)]
struct Income {
    earned: f64,
    actions: u64,
    episodes: u64,
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
        config: &str,
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
            let mind = with_room(|| {
                let born = profile::born(profile, config, &values, actions.len(), seed);
                born.map_err(|it| it.to_string())
            })?;
            Ok(Self {
                mind,
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
    fn give_up(&mut self) -> PyResult<()> {
        guarded(|| {
            self.mind.give_up();
            Ok(())
        })
    }

    /// What each item is worth.
    fn values(&self) -> Vec<f32> {
        self.mind.values()
    }

    /// The configuration as JSON.
    fn config(&self) -> PyResult<String> {
        let tree = settings::tree_of(&self.mind.config()).map_err(refused)?;
        Ok(tree.to_string())
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
        guarded(|| {
            Ok(match self.mind.way(&now) {
                Way::Actions(actions) => Some(actions),
                Way::Unknown => None,
            })
        })
    }

    /// Why the last action was chosen: the schema, its value, who decided.
    fn explain(&self) -> PyResult<Option<(String, f32, String)>> {
        let Some((said, choice)) = guarded(|| Ok(self.mind.explain()))? else {
            return Ok(None);
        };
        let text = format!(
            "{}/{}/{}",
            self.conjunction(&said.context),
            self.name_of(said.action),
            self.conjunction(&said.result)
        );
        Ok(Some((text, choice.value, motive(&choice))))
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
        let all = guarded(|| Ok(self.mind.schemas()))?;
        all.into_iter().map(told).collect()
    }

    /// A look inside, as a dictionary.
    fn inside<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let it = guarded(|| Ok(self.mind.inside()))?;
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
        let (mut income, stage) = (Income::default(), &mut world.stage);
        while income.actions < actions && !stage.look().finished() {
            let block = (actions - income.actions).min(BLOCK);
            guarded(|| {
                let lived = py.detach(|| self.block(stage, block, paid, &mut income));
                lived.map_err(refused)
            })?;
            py.check_signals()?;
        }
        Ok((income.earned, income.actions, income.episodes))
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
        let mind = &mut self.mind;
        with_room(|| mind.load(names, image))?;
        self.digest = Digest::of(digest);
        Ok(())
    }
}

impl Agent {
    /// Lives for so many actions or to the end of the world; `income` is what came of it so far, also
    /// where an error ends it.
    fn block(
        &mut self,
        stage: &mut Stage,
        actions: u64,
        paid: bool,
        income: &mut Income,
    ) -> Result<(), String> {
        for _ in 0..actions {
            if stage.look().finished() {
                break;
            }
            let now = stage.look().sense();
            let choice = self.mind.choose(&now, Actions::ALL);
            let action = usize::from(choice.map_err(|it| it.to_string())?.action.0);
            self.digest.percept(&now);
            self.digest.action(action);
            let step = stage.step(action)?;
            let reward = if paid { step.earned as f32 } else { 0.0 };
            let felt = self.mind.learn(&step.felt, reward);
            felt.map_err(|it| it.to_string())?;
            self.digest.percept(&step.felt);
            self.digest.reward(reward);
            for (before, by, after) in &step.reflexes {
                let felt = self.mind.observe(before, *by as u16, after);
                felt.map_err(|it| it.to_string())?;
                self.digest.percept(before);
                self.digest.action(*by);
                self.digest.percept(after);
            }
            income.earned += step.earned;
            income.actions += 1;
            if stage.look().episode_ended() {
                self.mind.interrupt().map_err(|it| it.to_string())?;
                stage.world().begin_episode();
                income.episodes += 1;
            }
        }
        Ok(())
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

/// The default configuration with what a JSON object says otherwise.
fn configured(given: &str) -> Result<MindConfig, String> {
    let told = |it: Impossible| it.to_string();
    let given = serde_json::from_str(given).map_err(|it| format!("no configuration: {it}"))?;
    let full = settings::tree_of(&MindConfig::DEFAULT).map_err(told)?;
    let mut tree = full.clone();
    settings::overlay(&mut tree, &full, &given, "config").map_err(told)?;
    settings::of_tree(tree, "config").map_err(told)
}

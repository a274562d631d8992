//! Goals: composite actions driven from random states (book, 5.4.3: `<+hp22>`, `+taste1` as a goal).
//!
//! Owns the attempts and their count; the ways of choosing steps are `cla-core`'s.
//! Nothing is learned during an attempt, so that experience is what was said.

use cla_core::growth::{Attempt, Planner, PlannerConfig, Progress, SimpleSchema, chain_backward};
use cla_core::num::Rng;
use cla_core::word::{ActionId, ItemId, SignedItems};

use super::level1::{ACTION_COUNT, ITEM_COUNT};
use crate::world::microworld::{Items, Oracle, State, WORDS, item};

/// Primitive actions after which an attempt has failed.
pub const STEP_LIMIT: u16 = 20;

/// The planner of the Microworld, in less than 8 kB.
pub type Planning = Planner<WORDS, ITEM_COUNT, 300>;

/// How it searches.
pub const CONFIG: PlannerConfig = PlannerConfig {
    actions: ACTION_COUNT as u8,
    ..PlannerConfig::DEFAULT
};

/// How the next step is chosen.
///
/// ```
/// use host_sim::experiment::microworld::goals::Strategy;
/// assert_ne!(Strategy::Chain, Strategy::Search);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// The book's backward chaining over reliable schemas.
    Chain,
    /// Best-first search over predicted states.
    Search,
}

/// Goals that belong together in the claims.
///
/// ```
/// use host_sim::experiment::microworld::goals::GOALS;
/// assert_eq!(GOALS[0].name, "hand");
/// ```
#[derive(Clone, Copy, Debug)]
pub struct GoalGroup {
    /// The name in the claim id.
    pub name: &'static str,
    /// The items to turn on.
    pub items: &'static [&'static str],
    /// Attempts for each.
    pub attempts: u32,
}

/// The groups, about 100 attempts each, and the book's new actions 5.24 to 5.29.
pub const GOALS: [GoalGroup; 12] = [
    GoalGroup {
        name: "hand",
        items: &[
            "hp11", "hp12", "hp13", "hp21", "hp22", "hp23", "hp31", "hp32", "hp33",
        ],
        attempts: 12,
    },
    GoalGroup {
        name: "eye",
        items: &[
            "vp11", "vp12", "vp13", "vp21", "vp22", "vp23", "vp31", "vp32", "vp33",
        ],
        attempts: 12,
    },
    GoalGroup {
        name: "taste",
        items: &["taste1"],
        attempts: 100,
    },
    GoalGroup {
        name: "touch",
        items: &["tactf", "tactb", "tactr", "tactl"],
        attempts: 25,
    },
    GoalGroup {
        name: "texture",
        items: &["text1"],
        attempts: 100,
    },
    GoalGroup {
        name: "grip",
        items: &["hgr"],
        attempts: 100,
    },
    positional("5_24", &["hp22"]),
    positional("5_25", &["hp33"]),
    positional("5_26", &["vp22"]),
    positional("5_27", &["vp33"]),
    positional("5_28", &["vf34"]),
    positional("5_29", &["vf12"]),
];

/// One of the book's positional actions (5.24 to 5.29), by its number.
const fn positional(name: &'static str, items: &'static [&'static str]) -> GoalGroup {
    GoalGroup {
        name,
        items,
        attempts: 20,
    }
}

/// The goal that one item is on.
#[must_use]
pub fn goal(item: ItemId) -> SignedItems<WORDS> {
    let mut goal = SignedItems::EMPTY;
    goal.insert(item, true)
        .expect("the Microworld's items fit its words");
    goal
}

/// The course of one attempt.
///
/// ```
/// let it = host_sim::experiment::microworld::goals::Course::default();
/// assert!(!it.reached);
/// ```
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// Whether the goal was reached within the step limit.
    pub reached: bool,
    /// The actions done and the states that they led to.
    pub steps: Vec<(ActionId, State)>,
}

/// Pursues a goal from a state of the world; `next` chooses each action, and gives up with `None`.
pub fn pursue(
    goal: SignedItems<WORDS>,
    start: State,
    perceive: impl Fn(&State) -> Items,
    mut next: impl FnMut(&State, &Items) -> Option<ActionId>,
) -> Course {
    let (mut state, mut course) = (start, Course::default());
    let mut on = perceive(&state);
    let mut attempt = Attempt::begin(goal, on, STEP_LIMIT);
    loop {
        match attempt.progress(&on) {
            Progress::Reached(_) => {
                course.reached = true;
                return course;
            }
            Progress::TimedOut => return course,
            Progress::Underway => {}
        }
        let Some(action) = next(&state, &on) else {
            return course;
        };
        state = state.after(usize::from(action.0));
        on = perceive(&state);
        course.steps.push((action, state));
        attempt.count_step();
    }
}

/// The steps of a strategy towards a goal, for [`pursue`]; begins a new attempt.
pub fn steps<'a>(
    goal: SignedItems<WORDS>,
    schemas: &'a [SimpleSchema],
    planner: &'a mut Planning,
    strategy: Strategy,
) -> impl FnMut(&State, &Items) -> Option<ActionId> + 'a {
    planner.begin();
    move |_, on| match strategy {
        Strategy::Chain => chain_backward(&goal, on, schemas, CONFIG.reliable),
        Strategy::Search => planner.next_action(&goal, on, schemas, &CONFIG),
    }
}

/// The book's chains of schemas that change no more: each step is worked out once for a goal and a
/// state, and remembered.
#[derive(Clone, Debug)]
pub struct Chains<'a> {
    oracle: &'a Oracle,
    schemas: &'a [SimpleSchema],
    goals: Vec<SignedItems<WORDS>>,
    known: Vec<Option<Option<ActionId>>>,
}

impl<'a> Chains<'a> {
    /// Nothing worked out; the goals are that one of these items each is on.
    ///
    /// # Panics
    /// When a name is not an item.
    #[must_use]
    pub fn new(oracle: &'a Oracle, schemas: &'a [SimpleSchema], names: &[&str]) -> Self {
        let goals = names.iter().map(|name| goal(item(name).expect("an item")));
        Self {
            oracle,
            schemas,
            goals: goals.collect(),
            known: vec![None; names.len() * oracle.states().len()],
        }
    }

    /// The next action of the chain towards a goal, by its number.
    ///
    /// # Panics
    /// When there is no such goal or the state cannot be reached.
    pub fn next(&mut self, number: usize, state: &State) -> Option<ActionId> {
        let index = self.oracle.index(state).expect("a reachable state");
        let slot = &mut self.known[number * self.oracle.states().len() + index];
        *slot.get_or_insert_with(|| {
            let on = self.oracle.items(index);
            chain_backward(&self.goals[number], on, self.schemas, CONFIG.reliable)
        })
    }
}

/// The share of attempts of a group that reach their goal, from random reachable states in which it
/// does not hold.
pub fn success(
    group: &GoalGroup,
    oracle: &Oracle,
    schemas: &[SimpleSchema],
    planner: &mut Planning,
    strategy: Strategy,
    rng: &mut Rng,
) -> f64 {
    let (mut reached, mut attempts) = (0, 0);
    let index = |state: &State| oracle.index(state).expect("a reachable state");
    for name in group.items {
        let item = item(name).expect("a goal is an item");
        for _ in 0..group.attempts {
            let start = loop {
                let state = rng.below(oracle.states().len() as u32) as usize;
                if !oracle.items(state).contains(item) {
                    break oracle.states()[state];
                }
            };
            let perceive = |state: &State| *oracle.items(index(state));
            let steps = steps(goal(item), schemas, planner, strategy);
            let course = pursue(goal(item), start, perceive, steps);
            reached += u32::from(course.reached);
            attempts += 1;
        }
    }
    f64::from(reached) / f64::from(attempts)
}

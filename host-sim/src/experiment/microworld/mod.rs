//! The Microworld experiment (book, chapter 5): what is run, what is claimed.
//!
//! `trial` measures one seed, `claims` judges all of them, `report` prints and draws; `level1`,
//! `goals` and `level2` are the parts of a life, `catalogue` the book's equations.
//! The goal mode drives one composite action and shows its steps.

pub mod catalogue;
pub mod claims;
pub mod goals;
pub mod level1;
pub mod level2;
pub mod picture;
pub mod report;
pub mod synthetic;
pub mod trial;

use cla_core::num::Rng;
use cla_core::word::ItemId;

use crate::failure::Failure;
use crate::progress::Progress;
use crate::report::{Results, Summary, Table};
use crate::world::microworld::{Body, Microworld, Oracle, State, VOCABULARY};

/// Stack of a thread that trains maps: they are built on it before they move to the heap.
const STACK: usize = 32 << 20;

/// What to run.
#[derive(Clone, Debug)]
pub struct MicroworldOptions {
    /// Which lives.
    pub seeds: Vec<u64>,
    /// In place of the experiment: pursue this item with the first seed's brain.
    pub goal: Option<ItemId>,
}

/// Runs the experiment, or pursues the goal.
///
/// # Errors
/// [`Failure`] when a figure cannot be drawn.
///
/// # Panics
/// When the system has no thread to give.
pub fn run(options: &MicroworldOptions, progress: &Progress) -> Result<Results, Failure> {
    let oracle = Oracle::new(Body::Visible);
    let mut summary = Summary::new("microworld", &options.seeds);
    summary.parameter("body", "visible");
    if let Some(goal) = options.goal {
        let seed = options.seeds.first().copied().unwrap_or(100);
        pursue(goal, seed, &oracle, &mut summary);
        return Ok(Results::new(summary));
    }
    summary.parameter("steps", trial::STEPS);
    summary.parameter("maps", "10 x 10");
    summary.parameter("slip", f64::from(trial::SLIP));
    summary.parameter("goal steps", goals::STEP_LIMIT);
    summary.parameter("samples of a composite action", level2::SAMPLES);
    summary.parameter("believed after trials", trial::BELIEVED_TRIALS);
    summary.parameter(
        "composite actions labelled in hindsight",
        synthetic::COMPOSITES,
    );
    summary.parameter("an item believed after trials", synthetic::TRIALS);
    let work = |&seed: &u64, ticker: &_| {
        std::thread::scope(|scope| {
            let thread = std::thread::Builder::new().stack_size(STACK);
            let handle = thread.spawn_scoped(scope, || trial::run(seed, &oracle, ticker));
            let handle = handle.expect("a thread for a trial");
            handle.join().expect("a trial does not panic")
        })
    };
    let trials = progress.over(
        "living in the Microworld",
        &options.seeds,
        trial::PARTS,
        work,
    );
    summary.claims = claims::claims(&trials);
    summary.table("equations 5.4 to 5.32", report::catalogue(&trials, &oracle));
    summary.table("recall by family, 100,000 steps", report::families(&trials));
    summary.table("growth", report::growth(&trials));
    summary.table("persistent objects", report::believed(&trials));
    summary.table("memory", report::memory());
    let mut results = Results::new(summary);
    for (name, figure) in report::figures(&trials)? {
        results = results.picture(name, figure);
    }
    Ok(results)
}

/// Educates a brain, lets it pursue the goal from a random state, and writes down every step.
fn pursue(item: ItemId, seed: u64, oracle: &Oracle, summary: &mut Summary) {
    let (mind, mut planner) = trial::educated(seed, trial::STEPS);
    let mut pursuing = planner.clone();
    let perceive = |state: &State| {
        let mut world = Microworld::new(0, Body::Visible, 0.0);
        world.set_state(*state);
        world.on()
    };
    let mut rng = Rng::stream(seed, 58);
    let start = loop {
        let state = oracle.states()[rng.below(oracle.states().len() as u32) as usize];
        if !perceive(&state).contains(item) {
            break state;
        }
    };
    let text1 = crate::world::microworld::item("text1").expect("an item");
    let mut show = |state: &State| {
        let expected =
            picture::expected_ball(&perceive(state), mind.schemas(), &mut planner, text1);
        let rows = picture::world(state);
        let pairs = rows
            .lines()
            .zip(expected.lines().chain(std::iter::repeat("")));
        let lines: Vec<String> = pairs
            .map(|(world, ball)| format!("{world:7}{ball}"))
            .collect();
        lines.join("\n")
    };
    println!("<+{}>, seed {seed}", VOCABULARY.item_name(item));
    println!("left: the world (h hand, o ball, E eye, G gripping, ^ mouth)");
    println!("right: where the brain expects the ball, without looking\n");
    println!("{}", show(&start));
    let course = goals::pursue(
        goals::goal(item),
        start,
        perceive,
        goals::steps(
            goals::goal(item),
            mind.schemas(),
            &mut pursuing,
            goals::Strategy::Search,
        ),
    );
    let mut table = Table::new(&["step", "action"]);
    for (step, (action, state)) in course.steps.iter().enumerate() {
        let name = VOCABULARY.action_name(*action);
        println!("{name}\n{}", show(state));
        table.row([(step + 1).into(), name.into()]);
    }
    let end = if course.reached { "reached" } else { "failed" };
    let steps = course.steps.len();
    println!(
        "{end} after {steps} step{}\n",
        if steps == 1 { "" } else { "s" }
    );
    summary.parameter("goal", VOCABULARY.item_name(item));
    summary.parameter("reached", course.reached);
    summary.table("steps", table);
}

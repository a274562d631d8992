//! In place of the experiment: one brain pursues one goal, and every step is shown.

use cla_core::num::Rng;
use serde::{Deserialize, Serialize};

use super::options::PursuitOptions;
use super::{goals, picture, trial};
use crate::experiment::plan::Experiment;
use crate::failure::Failure;
use crate::progress::Ticker;
use crate::report::{Results, Summary, Table};
use crate::world::microworld::{Body, Microworld, Oracle, State, VOCABULARY, item};

/// The pursuit.
#[derive(Clone, Copy, Debug)]
pub struct Pursuit;

/// How the goal was pursued: the world beside where the brain expects the ball, step by step.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Pursued {
    /// Where it began.
    pub start: String,
    /// The actions, and what each led to.
    pub steps: Vec<(String, String)>,
    /// Whether the goal was reached.
    pub reached: bool,
}

impl Experiment for Pursuit {
    type Options = PursuitOptions;
    type Case = u64;
    type Trial = Pursued;

    const NAME: &'static str = "microworld";
    const PHASE: &'static str = "learning and pursuing the goal";

    fn cases(options: &PursuitOptions) -> Vec<u64> {
        vec![options.seed]
    }

    fn trial(options: &PursuitOptions, &seed: &u64, ticker: &Ticker) -> Result<Pursued, Failure> {
        let pursued = pursue(options, seed)?;
        ticker.advance(1);
        Ok(pursued)
    }

    fn judge(options: &PursuitOptions, trials: &[Pursued]) -> Result<Results, Failure> {
        let mut summary = Summary::new(Self::NAME, &[options.seed]);
        summary.parameter("body", "visible");
        summary.parameter("goal", options.goal.as_str());
        let mut story = format!(
            "<+{}>, seed {}\n\
             left: the world (h hand, o ball, E eye, G gripping, ^ mouth)\n\
             right: where the brain expects the ball, without looking\n\n",
            options.goal, options.seed
        );
        for Pursued {
            start,
            steps,
            reached,
        } in trials
        {
            story.push_str(&format!("{start}\n"));
            let mut table = Table::new(&["step", "action"]);
            for (step, (action, shown)) in steps.iter().enumerate() {
                story.push_str(&format!("{action}\n{shown}\n"));
                table.row([(step + 1).into(), action.as_str().into()]);
            }
            let end = if *reached { "reached" } else { "failed" };
            let plural = if steps.len() == 1 { "" } else { "s" };
            story.push_str(&format!("{end} after {} step{plural}\n", steps.len()));
            summary.parameter("reached", *reached);
            summary.table("steps", table);
        }
        let mut results = Results::new(summary);
        results.story = Some(story);
        Ok(results)
    }
}

/// Educates a brain, lets it pursue the goal from a random state, and draws every step.
fn pursue(options: &PursuitOptions, seed: u64) -> Result<Pursued, Failure> {
    let oracle = Oracle::new(Body::Visible);
    let item_of_goal = options.item()?;
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
        if !perceive(&state).contains(item_of_goal) {
            break state;
        }
    };
    let text1 = item("text1").ok_or("the ball has a texture")?;
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
    let first = show(&start);
    let goal = goals::goal(item_of_goal);
    let steps = goals::steps(goal, mind.schemas(), &mut pursuing, goals::Strategy::Search);
    let course = goals::pursue(goal, start, perceive, steps);
    let shown = course
        .steps
        .iter()
        .map(|(action, state)| (VOCABULARY.action_name(*action).to_owned(), show(state)));
    Ok(Pursued {
        start: first,
        steps: shown.collect(),
        reached: course.reached,
    })
}

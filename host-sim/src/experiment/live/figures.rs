//! The figures of lives anywhere: what everybody obtains, thousand by thousand.

use super::options::LiveOptions;
use super::trial::{Course, Lives, Trial};
use crate::learner::STRIDE;
use crate::report::figure::{Axes, FigureError, Line, Picture, Point, line_chart};
use crate::report::sample;
use crate::world::damage::Damage;

/// Actions of a point.
const POINT: u32 = 1000;

/// Everything that is drawn, with the names of the files; nothing of lives shorter than a point.
pub(super) fn all(
    options: &LiveOptions,
    trials: &[Trial],
) -> Result<Vec<(String, Picture)>, FigureError> {
    if options.protocol.after < POINT || trials.is_empty() {
        return Ok(Vec::new());
    }
    let mut pictures = Vec::new();
    if options.damages.is_empty() {
        let title = "What everybody obtains, after a childhood";
        let course = |it: &Lives| Some(it.twin.clone());
        pictures.push(("lives".to_owned(), chart(options, trials, title, &course)?));
    }
    for (index, damage) in options.damages.iter().enumerate() {
        let title = format!("What everybody obtains before and after the damage {damage}");
        let course = |it: &Lives| it.damaged.get(index).cloned();
        let name = format!("lives-{}", Damage::id(damage));
        pictures.push((name, chart(options, trials, &title, &course)?));
    }
    Ok(pictures)
}

/// What was obtained in each thousand actions; those before the damage stand at negative places.
fn points(course: &Course) -> Vec<(f64, f64)> {
    let strides = (POINT / STRIDE) as usize;
    let [before, after] = &course.obtained;
    let sums = |part: &[u32]| -> Vec<f64> {
        let chunks = part.chunks_exact(strides);
        chunks.map(|it| f64::from(it.iter().sum::<u32>())).collect()
    };
    let before = sums(before);
    let start = -f64::from(POINT) * before.len() as f64;
    let all = before.into_iter().chain(sums(after));
    let at = |index: usize| start + f64::from(POINT) * (index as f64 + 0.5);
    all.enumerate()
        .map(|(index, sum)| (at(index), sum))
        .collect()
}

/// What each life obtained in each thousand actions, as a table: those before the damage stand at
/// negative places.
pub(super) fn windows(options: &LiveOptions, trials: &[Trial]) -> String {
    let mut text = "seed,learner,damage,from,obtained\n".to_owned();
    for (seed, trial) in options.seeds.iter().zip(trials) {
        for lives in &trial.0 {
            let twin = core::iter::once(("none".to_owned(), &lives.twin));
            let names = options.damages.iter().map(Damage::to_string);
            for (damage, course) in twin.chain(names.zip(&lives.damaged)) {
                for (middle, obtained) in points(course) {
                    let from = middle - 0.5 * f64::from(POINT);
                    let who = &lives.who;
                    // A damage may have a comma in it, and nothing has a quote.
                    text.push_str(&format!("{seed},{who},\"{damage}\",{from},{obtained}\n"));
                }
            }
        }
    }
    text
}

fn chart(
    options: &LiveOptions,
    trials: &[Trial],
    title: &str,
    course: &dyn Fn(&Lives) -> Option<Course>,
) -> Result<Picture, FigureError> {
    let line = |who: usize| -> Option<Line> {
        let lives = trials.iter().filter_map(|it| it.0.get(who));
        let name = &trials.first()?.0.get(who)?.who;
        let courses: Vec<_> = lives.filter_map(course).map(|it| points(&it)).collect();
        // A world that ended early has fewer.
        let most = courses.iter().max_by_key(|it| it.len())?;
        let points = most.iter().enumerate().map(|(index, point)| {
            let at = courses.iter().filter_map(|it| it.get(index));
            let seeds: Vec<f64> = at.map(|point| point.1).collect();
            Point::mean_of(point.0, &seeds).of_count()
        });
        Some(Line::new(name, points.collect()))
    };
    let lines: Vec<Line> = (0..options.everybody().count()).filter_map(line).collect();
    let caption = format!(
        "{}. World: {}. Line: mean; band: 95 % interval of the mean, from seed to seed. Each point is \
         {POINT} actions.",
        sample(&options.seeds),
        options.world.name(),
    );
    let (x, y) = ("actions since the damage", "obtained in 1000 actions");
    let x = if options.damages.is_empty() {
        "actions since the middle of the test"
    } else {
        x
    };
    line_chart(&Axes::new(title, x, y).caption(caption), &lines)
}

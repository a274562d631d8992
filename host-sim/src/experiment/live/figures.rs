//! The figures of lives anywhere: what everybody obtains, thousand by thousand.

use std::collections::BTreeMap;

use csv::Writer;

use super::options::LiveOptions;
use super::trial::{Course, Lives, Trial};
use crate::failure::Failure;
use crate::learner::STRIDE;
use crate::report::figure::{Axes, FigureError, Line, Picture, Point, line_chart};
use crate::report::sample;
use crate::world::damage::Damage;

/// Actions of a point.
const POINT: u32 = 1000;

/// Everything that is drawn, with the names of the files; nothing of lives that are too short for two
/// points, between which a line could be drawn.
pub(super) fn all(
    options: &LiveOptions,
    trials: &[Trial],
) -> Result<Vec<(String, Picture)>, FigureError> {
    let mut pictures = Vec::new();
    let mut draw = |name: String, title: &str, course: &dyn Fn(&Lives) -> Option<Course>| {
        let lives = trials.iter().flat_map(|it| &it.0);
        let mut courses = lives.filter_map(course);
        if courses.any(|it| points(&it).len() > 1) {
            pictures.push((name, chart(options, trials, title, course)?));
        }
        Ok::<(), FigureError>(())
    };
    if options.damages.is_empty() {
        let title = "What everybody obtains, after a childhood";
        draw("lives".to_owned(), title, &|it| Some(it.twin.clone()))?;
    }
    for (index, damage) in options.damages.iter().enumerate() {
        let title = format!("What everybody obtains before and after the damage {damage}");
        let name = format!("lives-{}", Damage::id(damage));
        draw(name, &title, &|it| it.damaged.get(index).cloned())?;
    }
    Ok(pictures)
}

/// What was obtained in up to a thousand actions, `from` one `to` another, counted from the damage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Window {
    from: i64,
    to: i64,
    obtained: u32,
}

impl Window {
    /// Whether it has as many actions as a point.
    fn is_whole(&self) -> bool {
        self.to - self.from == i64::from(POINT)
    }
}

/// The windows of a life in their order: those before the damage are counted back from it, those after
/// it onwards, and so the shorter ones are the first and the last.
fn windows_of(course: &Course) -> Vec<Window> {
    let strides = (POINT / STRIDE) as usize;
    let window = |first: usize, part: &[u32], start: i64, end: i64| {
        let place = |stride: usize| (start + stride as i64 * i64::from(STRIDE)).min(end);
        Window {
            from: place(first),
            to: place(first + part.len()),
            obtained: part.iter().sum(),
        }
    };
    let [before, after] = &course.obtained;
    let [lived, left] = course.actions.map(i64::from);
    let mut all = Vec::new();
    let mut first = before.len();
    for part in before.rchunks(strides) {
        first -= part.len();
        all.push(window(first, part, -lived, 0));
    }
    all.reverse();
    for (index, part) in after.chunks(strides).enumerate() {
        all.push(window(index * strides, part, 0, left));
    }
    all
}

/// The whole windows: the middle of each, and what was obtained.
fn points(course: &Course) -> Vec<(i64, f64)> {
    let whole = windows_of(course).into_iter().filter(Window::is_whole);
    whole
        .map(|it| (i64::midpoint(it.from, it.to), f64::from(it.obtained)))
        .collect()
}

/// What each life obtained in each thousand actions, as a table: the places are actions from the
/// damage on, those before it negative, and the first and the last window may be shorter.
pub(super) fn windows(options: &LiveOptions, trials: &[Trial]) -> Result<String, Failure> {
    let mut table = Writer::from_writer(Vec::new());
    table.write_record(["seed", "learner", "damage", "from", "to", "obtained"])?;
    for (seed, trial) in options.seeds.iter().zip(trials) {
        for lives in &trial.0 {
            let twin = core::iter::once(("none".to_owned(), &lives.twin));
            let names = options.damages.iter().map(Damage::to_string);
            for (damage, course) in twin.chain(names.zip(&lives.damaged)) {
                for it in windows_of(course) {
                    let [from, to] = [it.from, it.to].map(|it| it.to_string());
                    let (seed, obtained) = (seed.to_string(), it.obtained.to_string());
                    table.write_record([&seed, &lives.who, &damage, &from, &to, &obtained])?;
                }
            }
        }
    }
    let bytes = table.into_inner().map_err(|it| it.to_string())?;
    Ok(String::from_utf8(bytes)?)
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
        // By their places: a world that ended early has fewer.
        let mut places: BTreeMap<i64, Vec<f64>> = BTreeMap::new();
        for (place, obtained) in lives.filter_map(course).flat_map(|it| points(&it)) {
            places.entry(place).or_default().push(obtained);
        }
        let points = places.iter();
        let points = points.map(|(&place, seeds)| Point::mean_of(place as f64, seeds).of_count());
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

#[cfg(test)]
mod tests {
    use super::{points, windows_of};
    use crate::experiment::live::Course;

    /// 2,110 and 1,040 actions in strides of 25, one obtained in each.
    #[test]
    fn windows_are_counted_from_the_damage_and_lose_no_action() {
        let course = Course {
            obtained: [vec![1; 85], vec![1; 42]],
            actions: [2_110, 1_040],
            ..Course::default()
        };
        let all = windows_of(&course);
        let said = all.iter().map(|it| (it.from, it.to, it.obtained));
        let there = [
            (-2_110, -1_985, 5),
            (-1_985, -985, 40),
            (-985, 0, 40),
            (0, 1_000, 40),
            (1_000, 1_040, 2),
        ];
        assert_eq!(said.collect::<Vec<_>>(), there);
        let lived: i64 = all.iter().map(|it| it.to - it.from).sum();
        assert_eq!((lived, all[0].from), (3_150, -2_110));
        // The last stride before the damage is shorter, and so is that window.
        assert_eq!(points(&course), [(-1_485, 40.0), (500, 40.0)]);
        assert!(windows_of(&Course::default()).is_empty());
    }
}

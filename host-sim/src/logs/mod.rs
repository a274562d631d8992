//! Logs of a life, action by action, in forms that other tools open, and the page that is made of one.
//!
//! By the name's end: `.mcap` for robotics tools (channels of JSON with schemas), `.jsonl` with an
//! action a line, `.csv` with what was obtained in each thousand actions.
//! The time of a log is the number of the action in seconds: the robot has no clock.

mod lines;
mod mcap;
mod step;

use std::path::Path;

pub use step::{Alarmed, Chosen, Life, Moved, Perceived, Pose, Rewarded, Step, film, steps};

use step::complete;

use crate::experiment::recover::replay::{Scene, replay};
use crate::failure::{Failure, Impossible};
use crate::report::{Section, leaf};
use crate::whole::{read, write};

/// Most bytes of a log: a life of ten million actions has fewer.
const MOST_BYTES: u64 = 1 << 34;
/// Actions of a window.
const WINDOW: usize = 1000;

/// The form of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Mcap,
    Lines,
    Windows,
}

fn form(path: &Path) -> Option<Form> {
    Some(match path.extension()?.to_str()? {
        "mcap" => Form::Mcap,
        "jsonl" => Form::Lines,
        "csv" => Form::Windows,
        _ => return None,
    })
}

/// Whether a log can have that name.
///
/// # Errors
/// [`Impossible`] for a name with another end.
///
/// ```
/// use std::path::Path;
/// use host_sim::logs::check_name;
/// assert!(check_name(Path::new("run.mcap")).is_ok());
/// assert!(check_name(Path::new("run.bag")).is_err());
/// ```
pub fn check_name(path: &Path) -> Result<(), Impossible> {
    match form(path) {
        Some(_) => Ok(()),
        None => Err(Impossible::new(format!(
            "a log ends in .mcap, .jsonl or .csv, and {} does not",
            path.display()
        ))),
    }
}

/// Writes a log in the form that its name says.
///
/// # Errors
/// When the name says none, or the file cannot be written.
pub fn write_log(path: &Path, life: &Life, steps: &[Step]) -> Result<(), Failure> {
    check_name(path)?;
    let bytes = match form(path) {
        Some(Form::Mcap) => mcap::bytes(life, steps)?,
        Some(Form::Lines) => lines::bytes(life, steps)?,
        _ => windows(steps).into_bytes(),
    };
    write(path, &bytes)
}

/// Reads a log; its last step is the end of the life, without a choice.
///
/// # Errors
/// One sentence, for a file that cannot be read, is cut off or damaged, has a gap, or is no such log.
pub fn read_log(path: &Path) -> Result<(Life, Vec<Step>), Failure> {
    let failed = |why: String| -> Failure { format!("{}: {why}", path.display()).into() };
    let bytes = read(path, MOST_BYTES).map_err(|it| failed(it.to_string()))?;
    let log = match form(path) {
        Some(Form::Mcap) => mcap::read(&bytes),
        Some(Form::Lines) => lines::read(&bytes),
        _ => Err("a log that can be replayed ends in .mcap or .jsonl".to_owned()),
    };
    let (life, steps) = log.map_err(failed)?;
    complete(&steps).map_err(failed)?;
    Ok((life, steps))
}

/// Makes the page that replays a log.
///
/// # Errors
/// As [`read_log`], and for a life that was not a Pioneer's.
pub fn replayed(path: &Path, onto: &Path) -> Result<String, Failure> {
    let (life, steps) = read_log(path)?;
    let film = film(&life, &steps).map_err(|why| format!("{}: {why}", path.display()))?;
    let all = steps.last().map_or(0, |it| it.reward.in_all);
    // The last step is the end.
    let actions = steps.len().saturating_sub(1);
    let said = format!("{actions} actions, {all} captures");
    let scene = Scene {
        radius: life.radius,
        camera_range: life.camera_range,
        camera: 0.0,
        damage: String::new(),
        title: said.clone(),
        subtitle: life.about.clone(),
    };
    let section = Section {
        title: "A life to watch".to_owned(),
        html: replay(&film, &scene),
    };
    write(onto, leaf("replay", &life.about, &[section]).as_bytes())?;
    Ok(format!("{said}; the page is {}", onto.display()))
}

/// What was obtained in each thousand actions, and how often the robot was alarmed.
fn windows(steps: &[Step]) -> String {
    let mut text = "from,to,obtained,alarms\n".to_owned();
    let before = |step: Option<&Step>| step.map_or(0, |it| it.reward.in_all);
    let actions = steps.len().saturating_sub(1);
    for (place, window) in steps[..actions].chunks(WINDOW).enumerate() {
        let from = place * WINDOW;
        // What the last action of a window has brought is told with what comes next.
        let end = steps.get(from + window.len());
        let obtained = before(end) - before(window.first());
        let alarmed = |it: &&Step| it.alarm.is_some_and(|it| it.doubts);
        let alarms = window.iter().filter(alarmed).count();
        text.push_str(&format!(
            "{from},{},{obtained},{alarms}\n",
            from + window.len()
        ));
    }
    text
}

#[cfg(test)]
#[path = "logs_tests.rs"]
mod tests;

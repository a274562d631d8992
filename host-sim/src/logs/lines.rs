//! A log as lines of JSON: the first says what it is about, each other is an action.

use super::step::{Life, Step};
use crate::failure::Failure;

pub(super) fn bytes(life: &Life, steps: &[Step]) -> Result<Vec<u8>, Failure> {
    let mut text = serde_json::to_string(life)?;
    text.push('\n');
    for step in steps {
        text.push_str(&serde_json::to_string(step)?);
        text.push('\n');
    }
    Ok(text.into_bytes())
}

pub(super) fn read(bytes: &[u8]) -> Result<(Life, Vec<Step>), String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "the log is no text".to_owned())?;
    if !text.ends_with('\n') {
        return Err("the log is cut off in its last line".to_owned());
    }
    let mut lines = (1..).zip(text.lines());
    let wrong = |line: usize, why: serde_json::Error| format!("line {line}: {why}");
    let (_, first) = lines.next().ok_or("the log is empty")?;
    let life = serde_json::from_str(first).map_err(|why| wrong(1, why))?;
    let step =
        |(line, text): (usize, &str)| serde_json::from_str(text).map_err(|why| wrong(line, why));
    let steps = lines.map(step).collect::<Result<Vec<Step>, _>>()?;
    Ok((life, steps))
}

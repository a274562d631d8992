//! A board whose flash is a file, killed at random moments and started again.
//!
//! Before each start the file is opened as a reset would open it: the generation that the firmware had
//! said to be saved must be there, or a newer one, and its brain must be to the byte the brain of a
//! life that was never interrupted.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use cla_core::agent::AgentConfig;
use cla_core::flash::{FlashStore, RamFlash, Resumed};
use cla_core::forager::small::{self, Brain};
use cla_core::num::Rng;
use firmware_example::keeper::along;
use firmware_example::resume::names;
use firmware_example::trace::SEED;

use super::toy::image;
use crate::device::board::Build;
use crate::device::target::Target;
use crate::failure::Failure;

/// As in the firmware with the feature `small`.
const SLOTS: usize = 3;
/// See [`SLOTS`].
const SLOT: u32 = 96 * 1024;
/// Longer than anything takes; a board that is silent so long hangs.
const LONG: Duration = Duration::from_secs(120);

/// What came of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Kills {
    /// Kills.
    pub kills: u32,
    /// Those that fell into a save.
    pub within: u32,
    /// Those before the brain was saved for the first time.
    pub before: u32,
    /// Saves that were answered for.
    pub saves: u32,
    /// Saved generations that were not there afterwards, or were not resumed.
    pub lost: u32,
    /// Brains that were there and are not those of the uninterrupted life.
    pub wrong: u32,
    /// Saves that the firmware could not make.
    pub refused: u32,
    /// The last generation, and its tick.
    pub last: (u32, u32),
}

/// The firmware that is killed.
///
/// # Errors
/// The compiler's words.
pub fn program() -> Result<PathBuf, Failure> {
    let build = Build {
        features: "small",
        ..Build::new(Target::M4f, "survivor")
    };
    build.build()
}

/// Kills the firmware so many times; its flash is in a folder of its own for each seed and process.
///
/// # Errors
/// When the emulator does not start, or its program hangs.
pub fn kill_again_and_again(program: &Path, kills: u32, seed: u64) -> Result<Kills, Failure> {
    let name = format!("kills-{}-{seed}", std::process::id());
    let folder = Folder(std::env::temp_dir().join(name));
    fs::create_dir_all(&folder.0)?;
    let (mut rng, mut whole) = (Rng::stream(seed, 73), Whole::born()?);
    let mut brain = Box::new(small::brain());
    let mut count = Kills {
        kills,
        ..Kills::default()
    };
    for _ in 0..kills {
        let heard = one_run(program, &folder.0, &mut rng)?;
        let resumed = heard.iter().find_map(|line| said(line, "resumed "));
        let born = heard.iter().any(|line| line.starts_with("born"));
        let nothing = (0, 0);
        if resumed.is_some_and(|it| it != count.last) || born && count.last != nothing {
            count.lost += 1;
        }
        let saved: Vec<_> = heard
            .iter()
            .filter_map(|line| said(line, "saved "))
            .collect();
        count.saves += saved.len() as u32;
        count.refused += heard.iter().filter(|it| it.starts_with("refused")).count() as u32;
        let torn = heard.last().is_some_and(|it| it.starts_with("saving"));
        count.within += u32::from(torn);
        count.last = saved.last().copied().unwrap_or(count.last);
        let there = found(&folder.0, &mut brain)?;
        let there = there.map_or(nothing, |it| (it.generation, it.tick));
        count.before += u32::from(there == nothing);
        if there < count.last {
            count.lost += 1;
        } else if there != nothing {
            count.wrong += u32::from(image(&*brain) != whole.at(there.1)?);
        }
        count.last = there;
    }
    Ok(count)
}

/// Starts the board, lets it live and kills it; what it said. A tenth of them die while they start,
/// half of the others while they save.
fn one_run(program: &Path, folder: &Path, rng: &mut Rng) -> Result<Vec<String>, Failure> {
    let mut board = Board::start(program, folder)?;
    let mut heard = Vec::new();
    let how = rng.below(10);
    if how > 0 {
        for _ in 0..rng.below(3) {
            board.wait("saved", &mut heard)?;
        }
        if how > 5 {
            board.wait("saving", &mut heard)?;
        }
    }
    let longest = if how > 5 { 25_000 } else { 120_000 };
    std::thread::sleep(Duration::from_micros(rng.below(longest).into()));
    heard.extend(board.kill());
    Ok(heard)
}

/// A folder that is removed at its end.
struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        // What the system cannot remove now it removes with its temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A board that runs, killed at the latest when it is dropped.
struct Board {
    emulator: Child,
    lines: Receiver<String>,
}

impl Drop for Board {
    fn drop(&mut self) {
        let _ = self.emulator.kill();
        let _ = self.emulator.wait();
    }
}

impl Board {
    fn start(program: &Path, folder: &Path) -> Result<Self, Failure> {
        let mut emulator = Target::M4f.emulator(program);
        emulator.current_dir(folder);
        emulator.stdin(Stdio::null()).stdout(Stdio::piped());
        let mut emulator = emulator.spawn()?;
        let output = emulator.stdout.take().ok_or("its output is piped")?;
        let (say, lines) = channel();
        std::thread::spawn(move || {
            let lines = BufReader::new(output).lines().map_while(Result::ok);
            for line in lines {
                if say.send(line).is_err() {
                    break;
                }
            }
        });
        Ok(Self { emulator, lines })
    }

    /// Waits for a line that begins so, and notes all lines.
    fn wait(&self, start: &str, heard: &mut Vec<String>) -> Result<(), Failure> {
        loop {
            let line = self.lines.recv_timeout(LONG);
            let line = line.map_err(|error| format!("no {start:?}: {error}, {heard:?}"))?;
            let found = line.starts_with(start);
            heard.push(line);
            if found {
                return Ok(());
            }
        }
    }

    /// SIGKILL; then what else it had said.
    fn kill(&mut self) -> Vec<String> {
        // One that has ended by itself is seen by what it said.
        let _ = self.emulator.kill();
        let _ = self.emulator.wait();
        let mut heard = Vec::new();
        loop {
            match self.lines.recv_timeout(LONG) {
                Ok(line) => heard.push(line),
                Err(RecvTimeoutError::Disconnected | RecvTimeoutError::Timeout) => return heard,
            }
        }
    }
}

/// Generation and tick of a line; of a line that the kill has cut, nothing.
fn said(line: &str, start: &str) -> Option<(u32, u32)> {
    let mut words = line.strip_prefix(start)?.split(' ');
    let mut number = |name: &str| {
        (words.next()? == name).then_some(())?;
        words.next()?.parse().ok()
    };
    let both = (number("generation")?, number("tick")?);
    (words.next() == Some("slot")).then_some(both)
}

/// What a reset would find in the file.
fn found(folder: &Path, brain: &mut Brain) -> Result<Option<Resumed>, Failure> {
    let mut bytes = fs::read(folder.join("flash.bin")).unwrap_or_default();
    // One that was killed while it was made is short.
    bytes.resize(SLOTS * SLOT as usize, 0xff);
    let flash = RamFlash::<4, 4096>::new(&mut bytes);
    let mut store = FlashStore::<_, SLOTS>::open(flash, 0, SLOT)?;
    Ok(store.resume(brain, names()).ok())
}

/// The life that nobody interrupts.
struct Whole {
    brain: Box<Brain>,
    tick: u32,
}

impl Whole {
    fn born() -> Result<Self, Failure> {
        let mut brain = Box::new(small::brain());
        small::be_born(&mut brain, AgentConfig::RESILIENT_LEVEL2, SEED)?;
        Ok(Self { brain, tick: 0 })
    }

    /// Its image at a tick that is not before the last one.
    fn at(&mut self, tick: u32) -> Result<Vec<u8>, Failure> {
        along(&mut *self.brain, self.tick, tick, |_, _, _| {})?;
        self.tick = self.tick.max(tick);
        Ok(image(&*self.brain))
    }
}

#[cfg(test)]
mod tests {
    use super::said;

    #[test]
    fn a_line_that_was_cut_says_nothing() {
        let line = "saved generation 12 tick 1200 slot 0 bytes 3";
        assert_eq!(said(line, "saved "), Some((12, 1200)));
        assert_eq!(said("saved generation 12 tick 12", "saved "), None);
        assert_eq!(said(line, "resumed "), None);
    }
}

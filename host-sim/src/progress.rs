//! Work on many seeds at once, with its progress while it lasts, until it is done or interrupted.
//!
//! Results come in the order of the seeds whatever the number of threads.
//! A terminal shows a bar; elsewhere standard error gets a line a minute.
//! The first SIGINT or SIGTERM ends the work where it next counts a step; the second ends the process.

use std::fs;
use std::io::{self, IsTerminal, Write};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use signal_hook::consts::TERM_SIGNALS;
use signal_hook::flag;

use crate::failure::Failure;
use crate::whole::write;

/// From one line to the next where there is no terminal.
const A_LINE: Duration = Duration::from_secs(60);

/// Where the progress of an experiment is shown, and whether it has been interrupted.
#[derive(Clone, Debug)]
pub struct Progress {
    shown: Shown,
    /// The number of the signal that ends the work; 0 for none yet.
    signal: Arc<AtomicUsize>,
    /// Where brains are kept.
    brains: Option<Arc<Path>>,
}

/// How progress is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shown {
    Nowhere,
    Bar,
    Lines,
}

/// Counts the work done in one phase; cheap to call from any thread.
#[derive(Clone, Debug)]
pub struct Ticker {
    phase: &'static str,
    bar: ProgressBar,
    shown: Shown,
    begun: Instant,
    /// Lines written so far.
    lines: Arc<AtomicU64>,
    signal: Arc<AtomicUsize>,
    brains: Option<Arc<Path>>,
}

/// What unwinds a job that is interrupted.
struct Interrupted;

impl Ticker {
    /// So many units of work are done.
    ///
    /// Does not return when the work has been interrupted: [`Progress::unless_stopped`] does.
    pub fn advance(&self, units: u64) {
        self.bar.inc(units);
        if self.signal.load(Ordering::Relaxed) != 0 {
            // Past the hook of panics: nothing went wrong, and nothing is printed.
            resume_unwind(Box::new(Interrupted));
        }
        if self.shown == Shown::Lines {
            self.line(self.begun.elapsed());
        }
    }

    /// Keeps the image of a brain in a file of this name, where brains are kept; elsewhere it is not
    /// asked for. A trial measures the same with it and without.
    ///
    /// # Errors
    /// When there is no such image, or it cannot be written.
    pub fn keep(
        &self,
        name: &str,
        image: impl FnOnce() -> Result<Option<Vec<u8>>, Failure>,
    ) -> Result<(), Failure> {
        let Some(folder) = &self.brains else {
            return Ok(());
        };
        let image = image()?.ok_or_else(|| format!("{name} has no image"))?;
        write(&folder.join(format!("{name}.brain")), &image)
    }

    /// Writes a line when one is due.
    fn line(&self, elapsed: Duration) {
        let due = elapsed.as_secs() / A_LINE.as_secs();
        if self.lines.fetch_max(due, Ordering::Relaxed) < due {
            let done = self.bar.position();
            let text = line(self.phase, done, self.bar.length().unwrap_or(done), elapsed);
            // Whoever does not listen misses nothing but this.
            let _ = writeln!(io::stderr(), "{text}");
        }
    }
}

/// How far the work is and how long the rest takes if it goes on as it went.
fn line(phase: &str, done: u64, all: u64, elapsed: Duration) -> String {
    let share = done as f64 / all.max(1) as f64;
    let left = elapsed.as_secs_f64() * (1.0 - share) / share.max(f64::MIN_POSITIVE);
    // A year is as good as never.
    let left = Duration::from_secs(left.clamp(0.0, 3.2e7).round() as u64);
    format!(
        "{phase}: {:.0} % after {}, about {} left",
        100.0 * share,
        humantime::format_duration(Duration::from_secs(elapsed.as_secs())),
        humantime::format_duration(left)
    )
}

impl Progress {
    /// A bar on standard error if that is a terminal, else lines; signals end the work.
    ///
    /// # Errors
    /// When the system does not let signals be heard.
    pub fn of_program() -> io::Result<Self> {
        let progress = Self {
            shown: if io::stderr().is_terminal() {
                Shown::Bar
            } else {
                Shown::Lines
            },
            ..Self::hidden()
        };
        let again = Arc::new(AtomicBool::new(false));
        for &signal in TERM_SIGNALS {
            // In this order: the first signal arms the second.
            flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&again))?;
            flag::register(signal, Arc::clone(&again))?;
            flag::register_usize(signal, Arc::clone(&progress.signal), signal as usize)?;
        }
        Ok(progress)
    }

    /// Shown nowhere and interrupted by nothing.
    #[must_use]
    pub fn hidden() -> Self {
        Self {
            shown: Shown::Nowhere,
            signal: Arc::new(AtomicUsize::new(0)),
            brains: None,
        }
    }

    /// The same, and trained brains are kept in this folder.
    ///
    /// # Errors
    /// When there is no such folder and it cannot be made.
    pub fn keeping_brains(self, folder: &Path) -> Result<Self, Failure> {
        let failed = |error| format!("cannot make {}: {error}", folder.display());
        fs::create_dir_all(folder).map_err(failed)?;
        Ok(Self {
            brains: Some(folder.into()),
            ..self
        })
    }

    /// The number of the signal that has interrupted the work.
    #[must_use]
    pub fn stopped(&self) -> Option<u8> {
        match self.signal.load(Ordering::Relaxed) {
            0 => None,
            signal => u8::try_from(signal).ok(),
        }
    }

    /// Does a job; `None` when the work is interrupted before it is done.
    ///
    /// ```
    /// use host_sim::progress::Progress;
    /// assert_eq!(Progress::hidden().unless_stopped(|| 7), Some(7));
    /// ```
    pub fn unless_stopped<T>(&self, job: impl FnOnce() -> T) -> Option<T> {
        if self.stopped().is_some() {
            return None;
        }
        // What the job has half done is dropped with it.
        match catch_unwind(AssertUnwindSafe(job)) {
            Ok(done) => Some(done),
            Err(payload) if payload.is::<Interrupted>() => None,
            Err(panic) => resume_unwind(panic),
        }
    }

    /// Runs `job` for each item on all cores and returns the results in the order of the items.
    ///
    /// `units` is the work of one item, in what the job reports to its [`Ticker`].
    /// A job gets all its chance from its item, so threads cannot change a result.
    ///
    /// ```
    /// use host_sim::progress::Progress;
    /// let squares = Progress::hidden().over("squaring", &[3, 1, 2], 1, |&seed, ticker| {
    ///     ticker.advance(1);
    ///     seed * seed
    /// });
    /// assert_eq!(squares, [9, 1, 4]);
    /// ```
    pub fn over<I: Sync, T: Send>(
        &self,
        phase: &'static str,
        items: &[I],
        units: u64,
        job: impl Fn(&I, &Ticker) -> T + Sync,
    ) -> Vec<T> {
        let ticker = self.ticker(phase, items.len() as u64 * units);
        let results = items
            .par_iter()
            .map(|item| job(item, &ticker))
            .collect::<Vec<T>>();
        ticker.bar.finish_and_clear();
        results
    }

    fn ticker(&self, phase: &'static str, length: u64) -> Ticker {
        let target = match self.shown {
            Shown::Bar => ProgressDrawTarget::stderr(),
            Shown::Nowhere | Shown::Lines => ProgressDrawTarget::hidden(),
        };
        let bar = ProgressBar::with_draw_target(Some(length), target).with_message(phase);
        let template = "{msg} {wide_bar} {pos}/{len}, {eta} left";
        let bar = match ProgressStyle::with_template(template) {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        };
        Ticker {
            phase,
            bar,
            shown: self.shown,
            begun: Instant::now(),
            lines: Arc::new(AtomicU64::new(0)),
            signal: Arc::clone(&self.signal),
            brains: self.brains.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::Ordering;
    use std::time::Duration;

    use super::{Progress, line};

    #[test]
    fn the_number_of_threads_changes_no_result() {
        let seeds: Vec<u64> = (0..50).collect();
        let run = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
            pool.build().unwrap().install(|| {
                Progress::hidden().over("drawing", &seeds, 1, |&seed, ticker| {
                    ticker.advance(1);
                    cla_core::num::Rng::new(seed).next_u32()
                })
            })
        };
        assert_eq!(run(1), run(3));
    }

    #[test]
    fn a_signal_ends_the_work_where_it_next_counts_a_step() {
        let progress = Progress::hidden();
        let seeds: Vec<u64> = (0..50).collect();
        let done = progress.over("counting", &seeds, 2, |&seed, ticker| {
            progress.unless_stopped(|| {
                ticker.advance(1);
                if seed == 0 {
                    progress.signal.store(15, Ordering::Relaxed);
                }
                ticker.advance(1);
                seed
            })
        });
        assert_eq!(progress.stopped(), Some(15));
        assert_eq!(done[0], None);
        assert!(done.iter().any(Option::is_none));
        let kept = done.iter().enumerate();
        assert!(
            kept.clone()
                .all(|(at, it)| it.is_none_or(|it| it == at as u64))
        );
        // A panic is no interruption.
        let panics = || Progress::hidden().unless_stopped(|| panic!("as it should"));
        assert!(std::panic::catch_unwind(panics).is_err());
    }

    #[test]
    fn a_line_says_what_is_done_and_what_is_left() {
        let quarter = line("foraging", 25, 100, Duration::from_secs(120));
        assert_eq!(quarter, "foraging: 25 % after 2m, about 6m left");
        let nothing = line("foraging", 0, 100, Duration::from_secs(60));
        assert!(
            nothing.starts_with("foraging: 0 % after 1m, about 1year"),
            "{nothing}"
        );
    }
}

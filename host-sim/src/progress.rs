//! Work on many seeds at once, with a progress bar while it lasts.
//!
//! Results come in the order of the seeds whatever the number of threads, and nothing is drawn where
//! nobody watches (standard error is no terminal).

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;

/// Where the progress of an experiment is shown.
#[derive(Clone, Debug)]
pub struct Progress {
    visible: bool,
}

/// Counts the work done in one phase; cheap to call from any thread.
#[derive(Clone, Debug)]
pub struct Ticker(ProgressBar);

impl Ticker {
    /// So many units of work are done.
    pub fn advance(&self, units: u64) {
        self.0.inc(units);
    }
}

impl Progress {
    /// A bar on standard error, if that is a terminal.
    #[must_use]
    pub const fn on_terminal() -> Self {
        Self { visible: true }
    }

    /// No bar.
    #[must_use]
    pub const fn hidden() -> Self {
        Self { visible: false }
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
        let ticker = Ticker(self.bar(phase, items.len() as u64 * units));
        let results = items
            .par_iter()
            .map(|item| job(item, &ticker))
            .collect::<Vec<T>>();
        ticker.0.finish_and_clear();
        results
    }

    fn bar(&self, phase: &'static str, length: u64) -> ProgressBar {
        let target = if self.visible {
            ProgressDrawTarget::stderr()
        } else {
            ProgressDrawTarget::hidden()
        };
        let bar = ProgressBar::with_draw_target(Some(length), target).with_message(phase);
        let template = "{msg} {wide_bar} {pos}/{len}, {eta} left";
        match ProgressStyle::with_template(template) {
            Ok(style) => bar.with_style(style),
            Err(_) => bar,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Progress;

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
}

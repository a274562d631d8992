//! Health: whether a brain is as large as its world asks for, told from its last thousand steps.
//!
//! A brain whose tables are too small works on, earns less, and says so here alone.
//! What is counted here decides nothing, and an image does not keep it.

/// Steps of a window.
pub const WINDOW: u16 = 1000;

/// Losses of its tables in a window with which a brain is still well.
pub(crate) const BEARABLE: u32 = 20;

/// How a brain is doing.
///
/// Shares and rates are those of the last whole [`WINDOW`] of steps; before there is one, of the steps so
/// far.
///
/// ```
/// use cla_core::{Agent, AgentConfig, ItemId, Percept};
/// let mut agent = Box::new(Agent::<1, 7, 8, 8, 6, 64, 256>::new());
/// agent.be_born(AgentConfig::FORAGER, &[(ItemId(6), 10.0)], 1)?;
/// for _ in 0..500 {
///     agent.choose(&Percept::all_off(7))?;
///     agent.learn(&Percept::all_off(7))?;
/// }
/// let health = agent.health();
/// assert_eq!(health.steps, 500);
/// // Nothing ever happens, and once that is known it is foreseen.
/// assert!(health.foreseen > 0.4 && !health.cramped);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Health {
    /// The steps that the shares and rates are about, 0 to [`WINDOW`].
    pub steps: u16,
    /// The share of steps whose outcome something had foreseen, in `[0, 1]`.
    pub foreseen: f32,
    /// The share of steps in which nothing that is known applied, in `[0, 1]`.
    pub unknown: f32,
    /// Entries of tables that found no room, or gave theirs up for others, in a thousand steps.
    pub lost: f32,
    /// How full the fullest of the tables is, in `[0, 1]`.
    pub fullest: f32,
    /// Alarms since birth.
    pub alarms: u32,
    /// Whether work is outstanding that `idle` could do.
    pub pending: bool,
    /// Whether larger tables are likely to bring more: in the last whole window of a thousand steps more
    /// than 20 entries were lost, of an agent as of a mind.
    pub cramped: bool,
}

/// What happened in some steps.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Window {
    steps: u16,
    foreseen: u16,
    unknown: u16,
    lost: u32,
}

impl Window {
    const NONE: Self = Self {
        steps: 0,
        foreseen: 0,
        unknown: 0,
        lost: 0,
    };
}

/// Counts of the last thousand steps, all zero at first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gauge {
    now: Window,
    last: Window,
    /// All that was ever lost, when it was looked at last.
    lost: u32,
}

/// What a step says of the brain's knowledge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Told {
    /// Something had foreseen the outcome.
    pub(crate) foreseen: bool,
    /// Nothing that is known applied.
    pub(crate) unknown: bool,
}

/// What a brain adds to its counts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct State {
    pub(crate) fullest: f32,
    pub(crate) alarms: u32,
    pub(crate) pending: bool,
    /// Losses in a thousand steps up to which a brain is well.
    pub(crate) bearable: u32,
}

impl Gauge {
    pub(crate) const NONE: Self = Self {
        now: Window::NONE,
        last: Window::NONE,
        lost: 0,
    };

    /// Counts from now on, in a life in which so much was lost before.
    pub(crate) const fn begin(&mut self, lost: u32) {
        *self = Self { lost, ..Self::NONE };
    }

    /// Counts a step, after which so much was lost in all.
    pub(crate) fn count(&mut self, told: Told, lost: u32) {
        if self.now.steps == WINDOW {
            self.last = self.now;
            self.now = Window::NONE;
        }
        let it = &mut self.now;
        it.steps += 1;
        it.foreseen += u16::from(told.foreseen);
        it.unknown += u16::from(told.unknown);
        it.lost = it.lost.saturating_add(lost.wrapping_sub(self.lost));
        self.lost = lost;
    }

    /// What the counts say, and the rest.
    pub(crate) fn health(&self, state: State) -> Health {
        let of = if self.now.steps < WINDOW && self.last.steps == WINDOW {
            self.last
        } else {
            self.now
        };
        let share = |count: f32| {
            if of.steps == 0 {
                0.0
            } else {
                count / f32::from(of.steps)
            }
        };
        let lost = share(of.lost as f32) * f32::from(WINDOW);
        Health {
            steps: of.steps,
            foreseen: share(f32::from(of.foreseen)),
            unknown: share(f32::from(of.unknown)),
            lost,
            fullest: state.fullest,
            alarms: state.alarms,
            pending: state.pending,
            cramped: self.cramped(state.bearable),
        }
    }

    /// Whether more than so much was lost in the last whole window.
    pub(crate) fn cramped(&self, bearable: u32) -> bool {
        let whole = if self.now.steps == WINDOW {
            self.now
        } else {
            self.last
        };
        whole.lost > bearable
    }
}

/// The fullest of some tables, each with what is in it and what it holds; one that holds nothing is none.
pub(crate) fn fullest(tables: &[(u32, u32)]) -> f32 {
    let mut fullest = 0.0;
    for &(used, all) in tables {
        let share = if all == 0 {
            0.0
        } else {
            used.min(all) as f32 / all as f32
        };
        if share > fullest {
            fullest = share;
        }
    }
    fullest
}

#[cfg(test)]
mod tests {
    use super::{Gauge, State, Told, WINDOW, fullest};

    const KNOWN: Told = Told {
        foreseen: true,
        unknown: false,
    };
    const NEW: Told = Told {
        foreseen: false,
        unknown: true,
    };

    const FULL: State = State {
        fullest: 1.0,
        alarms: 2,
        pending: true,
        bearable: 50,
    };

    #[test]
    fn shares_are_those_of_the_last_whole_window_and_before_it_of_what_there_was() {
        let mut gauge = Gauge::NONE;
        let nothing = gauge.health(FULL);
        assert_eq!(
            (nothing.steps, nothing.foreseen, nothing.lost),
            (0, 0.0, 0.0)
        );
        for step in 0..100 {
            gauge.count(if step % 4 == 0 { NEW } else { KNOWN }, step);
        }
        let young = gauge.health(FULL);
        assert_eq!(
            (young.steps, young.foreseen, young.unknown),
            (100, 0.75, 0.25)
        );
        assert_eq!(young.lost, 990.0);
        for _ in 100..WINDOW {
            gauge.count(KNOWN, 99);
        }
        let whole = gauge.health(FULL);
        assert_eq!(
            (whole.steps, whole.foreseen, whole.lost),
            (WINDOW, 0.975, 99.0)
        );
        // The next window is not looked at before it is whole.
        for _ in 0..WINDOW - 1 {
            gauge.count(NEW, 99);
            assert_eq!(gauge.health(FULL), whole);
        }
        gauge.count(NEW, 99);
        let next = gauge.health(FULL);
        assert_eq!((next.unknown, next.lost), (1.0, 0.0));
        assert_eq!((next.alarms, next.pending), (2, true));
    }

    #[test]
    fn a_brain_is_cramped_when_a_whole_window_has_lost_more_than_is_bearable() {
        let of = |steps: u16, lost: u32| {
            let mut gauge = Gauge::NONE;
            gauge.begin(7);
            gauge.count(KNOWN, 7);
            for _ in 1..steps {
                gauge.count(KNOWN, 7 + lost);
            }
            gauge.health(FULL).cramped
        };
        assert!(of(WINDOW, 51) && !of(WINDOW, 50) && !of(WINDOW - 1, 5000));
        // It stays so until the next window is whole.
        assert!(of(2 * WINDOW - 1, 51) && !of(2 * WINDOW, 51));
    }

    #[test]
    fn counts_that_wrap_are_still_told_apart() {
        let mut gauge = Gauge::NONE;
        gauge.begin(u32::MAX - 1);
        gauge.count(KNOWN, 3);
        assert_eq!(gauge.health(FULL).lost, 5000.0);
    }

    #[test]
    fn the_fullest_table_counts_and_one_without_places_does_not() {
        assert_eq!(fullest(&[(1, 4), (3, 4), (0, 0)]), 0.75);
        // Trees have a leaf for each action beside those that they were given.
        assert_eq!(fullest(&[(28, 24)]), 1.0);
        assert_eq!(fullest(&[]), 0.0);
    }
}

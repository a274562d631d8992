#![no_std]
#![no_main]
//! What calls of the learner for any world take at their worst, in instructions: lives of robots whose
//! percepts are chance, so that tables fill, and whose reward stays away at last, so that they doubt.
//!
//! `cargo run --release --bin calls` in this folder; a line for each robot: its bytes, and of `choose` and
//! `learn` the mean, the 99th percentile (to within 256) and the worst; and how full the fullest table was.

use cla_core::forest::{Capacities, Mind, MindConfig, MindError};
use cla_core::num::Rng;
use cla_core::reason::{Reason, Reasoning};
use cla_core::word::{ItemId, ItemStates};
use firmware_example::board::Counter;
use firmware_example::mind::{Forager, Small};
use semihosting::{println, process};

/// Actions of a life, and those of them before training is over and before reward stays away.
const ACTIONS: u32 = 9000;
const TRAINING: u32 = 4000;
const PAID: u32 = 6000;
/// How often an item is on.
const ON: f32 = 0.5;
/// How often the valued item, the last one, comes where the item of the action's number was on, and where
/// it was off, while reward comes.
const PAY: (f32, f32) = (0.6, 0.1);

const OF: Capacities = Capacities::of(4096, 5);
/// Twelve items and five actions, as a vacuum cleaner's.
type Twelve =
    Mind<1, 12, 5, { OF.stretches }, { OF.leaves }, { OF.rows }, { OF.states }, { OF.links }>;

const SOME: Capacities = Capacities::of(1024, 5);
/// The same with a reason that imagines 400 states.
type Planner = Mind<
    1,
    12,
    5,
    { SOME.stretches },
    { SOME.leaves },
    { SOME.rows },
    { SOME.states },
    { SOME.links },
    Reason<
        1,
        12,
        5,
        { Capacities::thoughts(400).samples },
        { Capacities::thoughts(400).schemas },
        400,
    >,
>;

static mut FORAGER: Forager = Forager::unborn();
static mut SMALL: Small = Small::unborn();
static mut TWELVE: Twelve = Twelve::unborn();
static mut PLANNER: Planner = Planner::unborn();

/// Steps of 256 instructions; what takes more than all of them counts as the last.
const BINS: usize = 1024;

/// Instructions of the calls of a kind.
struct Calls {
    sum: u64,
    count: u32,
    worst: u32,
    bins: [u16; BINS],
}

impl Calls {
    const NONE: Self = Self {
        sum: 0,
        count: 0,
        worst: 0,
        bins: [0; BINS],
    };

    fn add(&mut self, instructions: u32) {
        self.sum += u64::from(instructions);
        self.count += 1;
        self.worst = self.worst.max(instructions);
        let bin = (instructions / 256).min(BINS as u32 - 1);
        if let Some(bin) = self.bins.get_mut(bin as usize) {
            *bin = bin.saturating_add(1);
        }
    }

    /// The number that 99 of 100 calls do not exceed, to within a bin.
    fn most(&self) -> u32 {
        let mut left = self.count - self.count / 100;
        for (bin, &calls) in (1..).zip(&self.bins) {
            left = left.saturating_sub(u32::from(calls));
            if left == 0 {
                return (256 * bin).min(self.worst);
            }
        }
        self.worst
    }

    fn mean(&self) -> u32 {
        (self.sum / u64::from(self.count.max(1))) as u32
    }
}

/// A percept by chance, in which the valued item is on as often as `pay`: every item matters, and none is
/// foreseen.
fn chance<const ITEMS: usize>(rng: &mut Rng, pay: f32) -> ItemStates<1> {
    let mut now = ItemStates::all_off(ITEMS as u16);
    for item in 0..ITEMS {
        let often = if item + 1 == ITEMS { pay } else { ON };
        // It has as many items.
        let _ = now.set(ItemId(item as u16), Some(rng.chance(often)));
    }
    now
}

fn live<
    const ITEMS: usize,
    const ACTS: usize,
    const STRETCHES: usize,
    const LEAVES: usize,
    const ROWS: usize,
    const STATES: usize,
    const LINKS: usize,
    R: Reasoning<1, ITEMS, ACTS>,
>(
    name: &str,
    work: u32,
    mind: &mut Mind<1, ITEMS, ACTS, STRETCHES, LEAVES, ROWS, STATES, LINKS, R>,
    counter: &mut Counter,
) -> Result<(), MindError> {
    static mut CALLS: [Calls; 2] = [const { Calls::NONE }; 2];
    let calls = &raw mut CALLS;
    // SAFETY: lives follow each other, and no interrupt touches the counts.
    #[allow(unsafe_code)]
    let [choosing, learning] = unsafe { &mut *calls };
    (*choosing, *learning) = (Calls::NONE, Calls::NONE);
    let mut values = [0.0; ITEMS];
    if let Some(last) = values.last_mut() {
        *last = 1.0;
    }
    let config = MindConfig {
        work,
        ..MindConfig::DEFAULT
    };
    mind.be_born(config, values, 1)?;
    let mut rng = Rng::new(2);
    // A model that begins anew, because other items matter now, is not full for a while.
    let mut fullest = 0.0_f32;
    for action in 0..ACTIONS {
        if action % 64 == 0 {
            fullest = fullest.max(mind.health().fullest);
        }
        if action == TRAINING {
            mind.act()?;
        }
        let now = chance::<ITEMS>(&mut rng, 0.0);
        counter.lap();
        let choice = mind.choose(&now)?;
        choosing.add(counter.lap());
        let pay = match now.get(ItemId(choice.action.0)) {
            _ if action >= PAID => 0.0,
            Some(true) => PAY.0,
            _ => PAY.1,
        };
        let after = chance::<ITEMS>(&mut rng, pay);
        counter.lap();
        mind.learn(&after)?;
        learning.add(counter.lap());
    }
    let health = mind.health();
    println!(
        "{name}: bytes {} choose mean {} most {} worst {} learn mean {} most {} worst {} alarms {} fullest {}",
        size_of_val(mind),
        choosing.mean(),
        choosing.most(),
        choosing.worst,
        learning.mean(),
        learning.most(),
        learning.worst,
        health.alarms,
        (100.0 * fullest) as u32
    );
    Ok(())
}

/// The lives, one after the other.
fn all() -> Result<(), MindError> {
    let mut counter = Counter::start();
    let (forager, small) = (&raw mut FORAGER, &raw mut SMALL);
    let (twelve, planner) = (&raw mut TWELVE, &raw mut PLANNER);
    // SAFETY: this runs once, and no interrupt touches the minds.
    #[allow(unsafe_code)]
    let (forager, small, twelve, planner) =
        unsafe { (&mut *forager, &mut *small, &mut *twelve, &mut *planner) };
    const USUAL: u32 = MindConfig::DEFAULT.work;
    live("forager", USUAL, forager, &mut counter)?;
    live("small", USUAL, small, &mut counter)?;
    live("twelve items", USUAL, twelve, &mut counter)?;
    live("twelve items and plans", USUAL, planner, &mut counter)?;
    live(
        "twelve items and plans, at 1200 units",
        1200,
        planner,
        &mut counter,
    )
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    if let Err(error) = all() {
        println!("{error}");
        process::exit(1);
    }
    process::exit(0);
}

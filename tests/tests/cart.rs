//! The cart of `firmware-example/nrf52840`, without its part: what its sensors mean, who moves it when
//! the brain is late, and that it learns to find its charger.

// There these files are a library.
#![allow(unreachable_pub)]

#[path = "../../firmware-example/nrf52840/src/pace.rs"]
mod pace;
#[path = "../../firmware-example/nrf52840/src/robot.rs"]
mod robot;

use cla_core::MindConfig;
use cla_core::num::Rng;
use pace::{Pace, Turn, WhenLate};
use robot::cart::{self, Action, Item, Percept, SAFE};
use robot::{Readings, Senses, wheels};

const CLEAR: Readings = Readings {
    ranges: [0.4; 3],
    lights: [0.5; 2],
    bumped: false,
    charging: false,
};

/// The end of an action that began when it was due.
fn ended(done: Action) -> Turn {
    Turn::Ended { done, late: false }
}

#[test]
fn an_answer_that_comes_in_time_lasts_its_ticks() {
    let mut pace = Pace::new(3, WhenLate::Safe);
    let first = [None; 3].map(|answer| pace.tick(answer));
    assert_eq!(first, [Turn::Began(SAFE), Turn::On(SAFE), ended(SAFE)]);
    let left = Some(Action::left);
    let turns = [left, None, None].map(|answer| pace.tick(answer));
    let (began, on) = (Turn::Began(Action::left), Turn::On(Action::left));
    assert_eq!(turns, [began, on, ended(Action::left)]);
    assert_eq!(pace.missed(), 0);
    // An answer in mid-action is none: nobody asked.
    pace.tick(Some(Action::right));
    assert_eq!(pace.tick(Some(Action::back)).action(), Action::right);
}

#[test]
fn a_late_brain_is_counted_and_the_last_action_is_held_or_the_safe_one_done() {
    for (when_late, meanwhile) in [(WhenLate::Hold, Action::left), (WhenLate::Safe, SAFE)] {
        let mut pace = Pace::new(2, when_late);
        pace.tick(None);
        assert_eq!(pace.tick(None), ended(SAFE));
        pace.tick(Some(Action::left));
        assert_eq!(pace.tick(None), ended(Action::left));
        for late in 1..=5 {
            assert_eq!(pace.tick(None), Turn::On(meanwhile));
            assert_eq!(pace.missed(), late);
        }
        // Its answer is followed when it comes, and that it came late is said at its end.
        assert_eq!(pace.tick(Some(Action::back)), Turn::Began(Action::back));
        let (done, late) = (Action::back, true);
        assert_eq!(pace.tick(None), Turn::Ended { done, late });
        assert_eq!(pace.missed(), 5);
        pace.tick(Some(Action::left));
        assert_eq!(pace.tick(None), ended(Action::left));
    }
}

#[test]
fn the_watchdog_is_fed_only_while_the_brain_answers() {
    let mut pace = Pace::new(2, WhenLate::Hold);
    for tick in 0..200 {
        let answer = (tick < 100).then_some(Action::forward);
        pace.tick(answer);
        assert_eq!(pace.lives(50), tick < 148, "{tick}");
    }
}

#[test]
fn a_sensor_that_is_shorted_or_cut_is_unknown_and_a_bumper_counts_at_once() {
    let mut senses = Senses::new();
    let broken = Readings {
        ranges: [0.0, 3.3, 1.5],
        lights: [f32::NAN, 2.0],
        bumped: true,
        ..CLEAR
    };
    senses.sense(&CLEAR);
    // One reading alone may be a spike.
    let spike = senses.sense(&broken);
    assert_eq!(spike.get(Item::near_right), Some(false));
    assert_eq!(spike.get(Item::bump), Some(true));
    let now = senses.sense(&broken);
    assert_eq!(now.get(Item::near_left), None);
    assert_eq!(now.get(Item::near_ahead), None);
    assert_eq!(now.get(Item::near_right), Some(true));
    assert_eq!(now.get(Item::light_left), None);
    assert_eq!(now.get(Item::light_right), Some(true));
    assert_eq!(now.get(Item::bump), Some(true));
    assert_eq!(wheels(Action::forward, true), (0.0, 0.0));
    assert_ne!(wheels(Action::back, true), (0.0, 0.0));
}

#[test]
fn a_cable_that_is_cut_reads_as_no_voltage_on_every_analogue_line() {
    // The part's program is not run here; what it says is read.
    let main = include_str!("../../firmware-example/nrf52840/src/main.rs");
    let lines = main.matches("ChannelConfig::single_ended(").count();
    let pulled = "for channel in &mut channels {";
    let down = "channel.resistor = Resistor::Pulldown;";
    assert_eq!(lines, 5);
    let (_, after) = main.split_once(pulled).expect("all lines are set up alike");
    let (each, _) = after.split_once('}').expect("a block ends");
    assert!(each.contains(down) && !main.contains("Resistor::Bypass"));
    let mut senses = Senses::new();
    let cut = Readings {
        ranges: [0.0; 3],
        lights: [0.0; 2],
        ..CLEAR
    };
    senses.sense(&cut);
    let now = senses.sense(&cut);
    let items = [Item::near_left, Item::near_ahead, Item::near_right];
    for item in items
        .into_iter()
        .chain([Item::light_left, Item::light_right])
    {
        assert_eq!(now.get(item), None);
    }
}

#[test]
fn its_page_says_the_bytes_of_its_brain() {
    let page = include_str!("../../firmware-example/nrf52840/README.md");
    let bytes = format!("{},{:03}", cart::RAM / 1000, cart::RAM % 1000);
    let words = format!("It takes {bytes} bytes of RAM");
    assert!(page.contains(&words), "{words}");
}

/// A room with a lamp over the charger, measured as the part would. When it has charged, somebody
/// puts it down elsewhere.
struct Room {
    x: f32,
    y: f32,
    heading: f32,
    rng: Rng,
    charges: u32,
}

/// As the control task on the part tells its brain: see `Report` there.
struct Report {
    began: Percept,
    done: Action,
    now: Percept,
    late: bool,
}

/// From the charger to the walls, metres.
const WALL: f32 = 1.0;
/// How near the charger's contacts are, metres.
const REACH: f32 = 0.15;
/// Wheels at full speed, metres a tick of 20 ms; half of the distance between them, metres.
const SPEED: f32 = 0.012;
const HALF_AXLE: f32 = 0.06;

impl Room {
    fn new(seed: u64) -> Self {
        let mut room = Self {
            x: 0.0,
            y: 0.0,
            heading: 0.0,
            rng: Rng::stream(seed, 3),
            charges: 0,
        };
        room.put_down();
        room
    }

    fn put_down(&mut self) {
        self.x = (self.rng.unit() * 1.6 - 0.8) * WALL;
        self.y = 0.8 * WALL;
        self.heading = self.rng.unit() * std::f32::consts::TAU;
    }

    /// Whether it stands at a wall and looks at it.
    fn bumped(&self) -> bool {
        let (dx, dy) = (self.heading.cos(), self.heading.sin());
        self.x.abs() >= WALL && self.x * dx > 0.0 || self.y.abs() >= WALL && self.y * dy > 0.0
    }

    fn charging(&self) -> bool {
        self.x.hypot(self.y) < REACH
    }

    fn readings(&mut self) -> Readings {
        let mut noise = || (self.rng.unit() - 0.5) * 0.1;
        let towards = (-self.y).atan2(-self.x) - self.heading;
        // Each light sensor looks half a radian to its side.
        let light = |side: f32| 0.6 + 2.0 * (towards - side).cos().max(0.0);
        let near = |side: f32| {
            let (dx, dy) = ((self.heading + side).cos(), (self.heading + side).sin());
            let ahead = (self.x + 0.25 * dx).abs().max((self.y + 0.25 * dy).abs());
            if ahead > WALL { 1.6 } else { 0.4 }
        };
        let (ranges, lights) = (
            [near(0.8), near(0.0), near(-0.8)],
            [light(0.5), light(-0.5)],
        );
        Readings {
            ranges: ranges.map(|it| it + noise()),
            lights: lights.map(|it| it + noise()),
            bumped: self.bumped(),
            charging: self.charging(),
        }
    }

    fn drive(&mut self, (left, right): (f32, f32)) {
        let forward = (left + right) / 2.0 * SPEED;
        self.heading += (right - left) * SPEED / (2.0 * HALF_AXLE);
        self.x = (self.x + forward * self.heading.cos()).clamp(-WALL, WALL);
        self.y = (self.y + forward * self.heading.sin()).clamp(-WALL, WALL);
    }

    /// As the control task and the brain on the part do it; answers the charges in the last 2000
    /// actions. A brain that is `late` needs a tick more for every third answer.
    fn live(&mut self, actions: u32, late: bool, mut brain: impl FnMut(&Report) -> Action) -> u32 {
        let (mut senses, mut pace) = (Senses::new(), Pace::new(10, WhenLate::Safe));
        let (mut ended, mut before, mut began) = (0, 0, Percept::UNKNOWN);
        let (mut answer, mut delayed) = (None, None);
        while ended < actions {
            let readings = self.readings();
            let now = senses.sense(&readings);
            let turn = pace.tick(answer.take());
            answer = delayed.take();
            self.drive(wheels(turn.action(), readings.bumped));
            if let Turn::Began(_) = turn {
                began = now;
            }
            if let Turn::Ended { done, late: behind } = turn {
                let decided = Some(brain(&Report {
                    began,
                    done,
                    now,
                    late: behind,
                }));
                if late && ended % 3 == 0 {
                    delayed = decided;
                } else {
                    answer = decided;
                }
                ended += 1;
                if self.charging() && now.get(Item::charging) == Some(true) {
                    self.charges += 1;
                    self.put_down();
                }
            }
            if ended + 2000 == actions {
                before = self.charges;
            }
        }
        self.charges - before
    }
}

/// Charges of a brain, and how often it learned from an action that had begun late.
fn learned(seed: u64, late: bool) -> (u32, u32) {
    let mut brain = Box::new(cart::brain());
    cart::be_born(&mut brain, MindConfig::DEFAULT, seed).expect("the default works");
    let (mut actions, mut observed) = (0, 0);
    let charges = Room::new(seed).live(8_000, late, |it| {
        if it.late {
            observed += 1;
            let learned = brain.observe(&it.began, it.done, &it.now);
            learned.expect("it is born");
        } else if actions > 0 {
            brain.learn(&it.now).expect("it has chosen");
        }
        if actions == 6_000 {
            brain.act().expect("it is born");
        }
        actions += 1;
        brain.choose_or_safe(&it.now)
    });
    (charges, observed)
}

#[test]
fn the_cart_learns_to_find_its_charger_also_when_its_brain_is_late() {
    let mut totals = [0; 3];
    for seed in 0..4 {
        let mut rng = Rng::stream(seed, 4);
        let drawn = |_: &Report| cart::ACTIONS[rng.below(5) as usize];
        totals[0] += Room::new(seed).live(8_000, false, drawn);
        let (in_time, none) = learned(seed, false);
        let (late, observed) = learned(seed, true);
        // Every third answer.
        assert_eq!((none, observed), (0, 2_667));
        totals[1] += in_time;
        totals[2] += late;
    }
    println!(
        "charges in 4 lives: by chance {}, learned {}, late {}",
        totals[0], totals[1], totals[2]
    );
    let [chance, learned, late] = totals;
    assert!(learned > 50 * chance.max(1), "{totals:?}");
    assert!(f64::from(late) > 0.8 * f64::from(learned), "{totals:?}");
}

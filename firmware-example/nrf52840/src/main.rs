//! The cart on an nRF52840 with embassy: sensors through GPIO and ADC, motors by PWM.
//!
//! Two priorities. The control task runs in an interrupt, twenty milliseconds a tick: it measures,
//! moves the wheels, stops at the bumper, and feeds the watchdog as long as the brain answers. The brain
//! runs in the program's own thread, learns and chooses when an action ends, and works on what is
//! pending until the next one; however long it takes, it never keeps the control task waiting.
#![no_std]
#![no_main]

use cart::pace::{Pace, Turn, WhenLate};
use cart::robot::cart::{Action, Item, Percept, be_born, brain};
use cart::robot::{Readings, Senses, cart as robot, wheels};
use cla_core::MindConfig;
use cortex_m_rt::interrupt;
use defmt::{error, info, warn};
use defmt_rtt as _;
use embassy_executor::{InterruptExecutor, Spawner};
use embassy_futures::yield_now;
use embassy_nrf::gpio::{Input, Pull};
use embassy_nrf::interrupt::{self, InterruptExt, Priority};
use embassy_nrf::pwm::{DutyCycle, SimpleConfig, SimplePwm};
use embassy_nrf::saadc::{self, ChannelConfig, Resistor, Saadc};
use embassy_nrf::wdt::{HaltConfig, Watchdog, WatchdogHandle};
use embassy_nrf::{bind_interrupts, wdt};
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use embassy_time::{Duration, Ticker};
use panic_probe as _;

/// A tick of the control task.
const TICK: Duration = Duration::from_millis(20);
/// An action lasts 200 ms.
const TICKS_AN_ACTION: u16 = 10;
/// What the cart does while its brain is late.
const WHEN_LATE: WhenLate = WhenLate::Safe;
/// The watchdog is fed no more when the brain has not answered for 3 s.
const PATIENCE: u32 = 150;
/// The watchdog resets the part after so many ticks of 32,768 Hz without food: a second.
const WATCHDOG: u32 = 32_768;
/// Actions of training: 20 minutes.
const TRAINING: u32 = 6_000;
/// Units of work between two looks at whether the next percept is there; a unit is about forty
/// instructions.
const WORK: u32 = 200;
/// Of everything that is left to chance: the same percepts make the same life.
const SEED: u64 = 42;
/// Twelve bits of 3.6 V.
const VOLTS: f32 = 3.6 / 4096.0;

bind_interrupts!(struct Irqs {
    SAADC => saadc::InterruptHandler;
});

/// The part's hands and eyes.
struct Body {
    adc: Saadc<'static, 5>,
    bumper: Input<'static>,
    charger: Input<'static>,
    motors: SimplePwm<'static>,
    watchdog: WatchdogHandle,
}

/// An action is over: what was perceived when it began, what was done, what is perceived now, and
/// whether it had begun later than it was due.
struct Report {
    began: Percept,
    done: Action,
    now: Percept,
    late: bool,
}

static SENSED: Signal<CriticalSectionRawMutex, Report> = Signal::new();
static DECIDED: Signal<CriticalSectionRawMutex, Action> = Signal::new();
static CONTROL: InterruptExecutor = InterruptExecutor::new();
static mut BRAIN: robot::Brain = brain();

#[allow(unsafe_code)]
#[interrupt]
fn EGU1_SWI1() {
    // SAFETY: this is the executor's own interrupt, enabled by `start`; nobody else calls it.
    unsafe { CONTROL.on_interrupt() }
}

impl Body {
    async fn measure(&mut self) -> Readings {
        let mut raw = [0; 5];
        self.adc.sample(&mut raw).await;
        let [left, ahead, right, light_left, light_right] = raw.map(|it| f32::from(it) * VOLTS);
        Readings {
            ranges: [left, ahead, right],
            lights: [light_left, light_right],
            // The switch pulls down.
            bumped: self.bumper.is_low(),
            charging: self.charger.is_high(),
        }
    }

    /// Two bridges with two inputs each: the one or the other is driven.
    fn drive(&mut self, (left, right): (f32, f32)) {
        let most = f32::from(self.motors.max_duty());
        let duty = |speed: f32| DutyCycle::inverted((speed.clamp(0.0, 1.0) * most) as u16);
        self.motors
            .set_all_duties([duty(left), duty(-left), duty(right), duty(-right)]);
    }
}

#[embassy_executor::task]
async fn control(mut body: Body) {
    let mut senses = Senses::new();
    let mut pace = Pace::new(TICKS_AN_ACTION, WHEN_LATE);
    let mut ticker = Ticker::every(TICK);
    let (mut missed, mut began) = (0, Percept::UNKNOWN);
    loop {
        let readings = body.measure().await;
        let now = senses.sense(&readings);
        let turn = pace.tick(DECIDED.try_take());
        body.drive(wheels(turn.action(), readings.bumped));
        match turn {
            Turn::Began(_) => began = now,
            Turn::On(_) => {}
            Turn::Ended { done, late } => SENSED.signal(Report {
                began,
                done,
                now,
                late,
            }),
        }
        if pace.missed() != missed {
            missed = pace.missed();
            warn!("the brain is late: {} ticks so far", missed);
        }
        if pace.lives(PATIENCE) {
            body.watchdog.pet();
        }
        ticker.next().await;
    }
}

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let p = embassy_nrf::init(Default::default());
    let mut config = wdt::Config::default();
    config.timeout_ticks = WATCHDOG;
    config.action_during_debug_halt = HaltConfig::Pause;
    let Ok((_, [watchdog])) = Watchdog::try_new(p.WDT, config) else {
        error!("a watchdog of another program runs: it will reset the part");
        core::future::pending().await
    };
    let mut channels = [
        ChannelConfig::single_ended(p.P0_02),
        ChannelConfig::single_ended(p.P0_03),
        ChannelConfig::single_ended(p.P0_28),
        ChannelConfig::single_ended(p.P0_29),
        ChannelConfig::single_ended(p.P0_30),
    ];
    for channel in &mut channels {
        // Else the line of a cable that is cut floats, and reads as anything.
        channel.resistor = Resistor::Pulldown;
    }
    let pwm = SimpleConfig::default();
    let body = Body {
        adc: Saadc::new(p.SAADC, Irqs, saadc::Config::default(), channels),
        bumper: Input::new(p.P0_11, Pull::Up),
        charger: Input::new(p.P0_12, Pull::Down),
        motors: SimplePwm::new_4ch(p.PWM0, p.P0_13, p.P0_14, p.P0_15, p.P0_16, &pwm),
        watchdog,
    };
    interrupt::EGU1_SWI1.set_priority(Priority::P6);
    match control(body) {
        Ok(control) => CONTROL.start(interrupt::EGU1_SWI1).spawn(control),
        Err(_) => defmt::panic!("the control task runs once"),
    }
    think().await
}

/// The brain's life: it learns what each action led to, chooses the next, and works in between.
async fn think() -> ! {
    let brain = &raw mut BRAIN;
    // SAFETY: `main` runs once, and nobody else names the static.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    if be_born(brain, MindConfig::DEFAULT, SEED).is_err() {
        defmt::panic!("the default configuration works");
    }
    let (mut actions, mut charged) = (0_u32, 0_u32);
    loop {
        let Report {
            began,
            done,
            now,
            late,
        } = SENSED.wait().await;
        // What was really done is learned from, in the moment in which it was.
        let learned = if actions == 0 {
            Ok(())
        } else if late {
            brain.observe(&began, done, &now).map(drop)
        } else {
            brain.learn(&now).map(drop)
        };
        if learned.is_err() {
            warn!("nothing was learned from action {}", actions);
        }
        if actions == TRAINING && brain.act().is_err() {
            warn!("training goes on");
        }
        DECIDED.signal(brain.choose_or_safe(&now));
        charged += u32::from(now.get(Item::charging) == Some(true));
        actions = actions.saturating_add(1);
        if actions % 100 == 0 {
            info!(
                "{} actions, {} of them in the charger, {} alarms",
                actions,
                charged,
                brain.alarms()
            );
        }
        while brain.pending() && !SENSED.signaled() {
            brain.idle(WORK);
            yield_now().await;
        }
    }
}

#![no_std]
#![no_main]
//! A robot that keeps its brain in flash: it resumes the life that it finds there, lives on along the
//! recording and saves by a policy, until somebody takes its power.
//!
//! `cargo run --release --features small --bin survivor`, as often as you like; the flash is the file
//! `flash.bin`. The test `kills` in `../../tests` kills it hundreds of times.

use cla_core::flash::{FlashStore, ResumeError};
use firmware_example::hal;
use firmware_example::keeper::{End, Event, Keeper, Policy, live};
use firmware_example::profile::{self, Brain};
use firmware_example::resume::{SLOT, SLOTS};
use firmware_example::shelf::Shelf;
use semihosting::{println, process};

static mut BRAIN: Brain = profile::brain();

/// Lives for ever.
fn survive() -> Result<(), &'static str> {
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let flash = hal::flash(SLOTS * SLOT as usize).ok_or("there is no flash")?;
    let store = FlashStore::<_, SLOTS>::open(flash, 0, SLOT);
    let mut shelf = Shelf::new(store.map_err(|_| "the slots do not fit the flash")?);
    println!("opened {:?}", shelf.counts());
    let mut keeper = Keeper::new(Policy::EMULATED);
    let lived = live(
        brain,
        &mut shelf,
        &mut keeper,
        u32::MAX,
        hal::power_is_failing,
        |event| match event {
            Event::Resumed(it) => println!(
                "resumed generation {} tick {} slot {} bytes {}",
                it.generation, it.tick, it.slot, it.image
            ),
            Event::Born(ResumeError::Nothing) => println!("born: the flash is empty"),
            Event::Born(why) => println!("born, and nothing is saved: {why}"),
            Event::Saving(cause, tick) => println!("saving tick {tick} cause {cause:?}"),
            Event::Saved(it) => println!(
                "saved generation {} tick {} slot {} bytes {} erased {} written {}",
                it.generation, it.tick, it.slot, it.image, it.cost.erased, it.cost.written
            ),
            Event::Mended(many) => println!("mended {many} entries"),
            Event::Refused(why) => println!("refused: {why}"),
            Event::Lost(part) => println!("lost {part}: the last life is brought back"),
            Event::Gone(why) => println!("nothing can be brought back: {why}"),
        },
    );
    lived.map_err(|end| match end {
        End::Config(_) => "the brain could not be born",
        End::Agent(_) => "the brain refused to live",
    })
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    match survive() {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("{why}");
            process::exit(1);
        }
    }
}

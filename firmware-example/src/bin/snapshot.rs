#![no_std]
#![no_main]
//! Takes over a life from the host: loads the image `to-board.brain`, lives on along the recording and
//! writes `from-board.brain`; says what loading and saving took, what keeping the brain in flash takes
//! beside the flash's own time, what it takes to find a bit that turned, and to look the brain through.
//!
//! The test `snapshots` in `../../tests` makes the first file and compares the second.

use cla_core::flash::{FlashStore, RamFlash};
use cla_core::snapshot::{self, Audit, Scrub, SliceSink};
use firmware_example::resume::{BACK, SLOT, THERE, live, names};
use firmware_example::{board, profile};
use semihosting::io::{Read, Write};
use semihosting::{fs, println, process};

/// Larger than any image of the brain.
const MOST: usize = 384 * 1024;

/// Sums of chunks of the whole brain.
const SUMS: usize = 160;

static mut BRAIN: profile::Brain = profile::brain();
static mut IMAGE: [u8; MOST] = [0; MOST];
/// Memory that behaves as flash, for two generations.
static mut FLASH: [u8; 2 * SLOT as usize] = [0; 2 * SLOT as usize];

/// Instructions and stack of saving into flash, opening it after a reset and resuming, the flash itself
/// being as fast as memory.
fn keep(brain: &mut profile::Brain, counter: &mut board::Counter) -> Result<(), &'static str> {
    type Flash<'a> = RamFlash<'a, 4, 4096>;
    let memory = &raw mut FLASH;
    // SAFETY: this runs once, and no interrupt touches it.
    #[allow(unsafe_code)]
    let memory: &mut [u8] = unsafe { &mut *memory };
    let store = FlashStore::<_, 2>::open(Flash::new(memory), 0, SLOT);
    let mut store = store.map_err(|_| "the slots do not fit")?;
    println!("store bytes {}", size_of_val(&store));
    board::paint_stack();
    counter.lap();
    let saved = store.save(brain, names(), BACK);
    let instructions = counter.lap();
    let saved = saved.map_err(|_| "it is not kept")?;
    println!("flash save instructions {instructions}");
    println!("flash save stack {}", board::stack_used());
    println!("flash save pages {}", saved.cost.erased);
    println!("flash save written {}", saved.cost.written);
    let flash = store.release();
    board::paint_stack();
    counter.lap();
    let store = FlashStore::<_, 2>::open(flash, 0, SLOT);
    let instructions = counter.lap();
    println!("flash open instructions {instructions}");
    println!("flash open stack {}", board::stack_used());
    let mut store = store.map_err(|_| "the slots do not fit")?;
    board::paint_stack();
    counter.lap();
    let resumed = store.resume(brain, names());
    let instructions = counter.lap();
    println!("flash resume instructions {instructions}");
    println!("flash resume stack {}", board::stack_used());
    match resumed {
        Ok(it) if it.tick == BACK => Ok(()),
        _ => Err("it is not resumed"),
    }
}

/// Instructions and stack of sealing a whole brain between two ticks, and of looking whether it is as
/// it was.
fn scrub(brain: &mut profile::Brain, counter: &mut board::Counter) -> Result<(), &'static str> {
    let mut scrub = Scrub::<SUMS>::new();
    println!("scrub bytes {}", size_of_val(&scrub));
    board::paint_stack();
    counter.lap();
    let sealed = scrub.seal(brain);
    let instructions = counter.lap();
    println!("scrub seal instructions {instructions}");
    println!("scrub seal stack {}", board::stack_used());
    sealed.map_err(|_| "it has more chunks")?;
    board::paint_stack();
    counter.lap();
    let found = scrub.check(brain);
    let instructions = counter.lap();
    println!("scrub check instructions {instructions}");
    println!("scrub check stack {}", board::stack_used());
    match found {
        Some(Audit::Sound) => Ok(()),
        _ => Err("a bit has turned"),
    }
}

/// Instructions and stack of looking a whole brain through, and the most that one part of it takes.
fn audit(brain: &mut profile::Brain, counter: &mut board::Counter) -> Result<(), &'static str> {
    board::paint_stack();
    counter.lap();
    let mut found = brain.audit();
    let instructions = counter.lap();
    println!("audit whole instructions {instructions}");
    println!("audit whole stack {}", board::stack_used());
    println!("audit parts {}", profile::Brain::AUDIT_PARTS);
    let mut worst = 0;
    for part in 0..profile::Brain::AUDIT_PARTS {
        counter.lap();
        found = found.and(brain.audit_part(part));
        worst = worst.max(counter.lap());
    }
    println!("audit part instructions {worst}");
    match found {
        Audit::Sound => Ok(()),
        _ => Err("a sound brain is mended"),
    }
}

/// Goes from host to board and back.
fn take_over() -> Result<(), &'static str> {
    let (brain, image) = (&raw mut BRAIN, &raw mut IMAGE);
    // SAFETY: this runs once, and no interrupt touches either.
    #[allow(unsafe_code)]
    let (brain, image) = unsafe { (&mut *brain, &mut *image) };
    let mut file = fs::File::open(c"to-board.brain").map_err(|_| "there is no image")?;
    let mut length = 0;
    loop {
        let rest = image.get_mut(length..).unwrap_or_default();
        match file.read(rest) {
            Ok(0) => break,
            Ok(more) => length += more,
            Err(_) => return Err("the image cannot be read"),
        }
    }
    let mut whole = image.get(..length).unwrap_or_default();
    board::paint_stack();
    let mut counter = board::Counter::start();
    counter.lap();
    let loaded = snapshot::load(brain, names(), &mut whole);
    let instructions = counter.lap();
    match loaded {
        Ok(bytes) => println!("loaded {bytes}"),
        Err(refused) => {
            println!("{refused}");
            return Err("the image was refused");
        }
    }
    println!("load instructions {instructions}");
    println!("load stack {}", board::stack_used());
    let print = live(brain, THERE, BACK).map_err(|_| "the brain refused to live")?;
    println!("life {print}");
    board::paint_stack();
    counter.lap();
    let mut sink = SliceSink::new(image);
    let saved = snapshot::save(brain, names(), &mut sink);
    let instructions = counter.lap();
    let Ok(saved) = saved else {
        return Err("the brain could not be saved");
    };
    println!("saved {saved}");
    println!("save instructions {instructions}");
    println!("save stack {}", board::stack_used());
    keep(brain, &mut counter)?;
    scrub(brain, &mut counter)?;
    audit(brain, &mut counter)?;
    let image = image.get(..saved as usize).unwrap_or_default();
    let mut file = fs::File::create(c"from-board.brain").map_err(|_| "there is no room")?;
    file.write_all(image)
        .map_err(|_| "the image cannot be written")
}

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    match take_over() {
        Ok(()) => process::exit(0),
        Err(why) => {
            println!("{why}");
            process::exit(1);
        }
    }
}

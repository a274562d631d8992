#![no_std]
#![no_main]
//! Takes over a life of the learner for any world from the host, as `snapshot` does with a forager: loads
//! the image `to-board.brain`, lives on along the recording and writes `from-board.brain`.
//!
//! The test `snapshots` in `../../tests` makes the first file and compares the second.

use cla_core::snapshot::{self, SliceSink};
use firmware_example::mind::{Small, live};
use firmware_example::resume::{BACK, THERE, names};
use semihosting::io::{Read, Write};
use semihosting::{fs, println, process};

/// Larger than any image of the mind.
const MOST: usize = 160 * 1024;

static mut MIND: Small = Small::new();
static mut IMAGE: [u8; MOST] = [0; MOST];

/// Goes from host to board and back.
fn take_over() -> Result<(), &'static str> {
    let (mind, image) = (&raw mut MIND, &raw mut IMAGE);
    // SAFETY: this runs once, and no interrupt touches either.
    #[allow(unsafe_code)]
    let (mind, image) = unsafe { (&mut *mind, &mut *image) };
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
    match snapshot::load(mind, names(), &mut whole) {
        Ok(bytes) => println!("loaded {bytes}"),
        Err(refused) => {
            println!("{refused}");
            return Err("the image was refused");
        }
    }
    let print = live(mind, THERE, BACK).map_err(|_| "the mind refused to live")?;
    println!("life {print}");
    let mut sink = SliceSink::new(image);
    let saved = snapshot::save(mind, names(), &mut sink);
    let saved = saved.map_err(|_| "the mind could not be saved")?;
    println!("saved {saved}");
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

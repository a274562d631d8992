#![no_std]
#![no_main]
//! The forager's brain as a controller: a body at the other end of a wire asks, the brain answers.
//!
//! Wire, motors and end are those of `hal.rs`; in the emulator the body is a simulated robot
//! (`host-sim hil`).
//! With the feature `flash` it keeps its brain when that is ordered, by the policy of `hal.rs` and when
//! the supply fails, and at boot the life that it finds in its flash goes on.
//! Exit code 0 when told to stop, 3 when the other side is gone.

use firmware_example::controller::{Service, serve};
use firmware_example::hal::{self, Motors, Serial};
use firmware_example::profile::{self, Brain};

/// The flash, and the life in it.
#[cfg(feature = "flash")]
mod kept {
    use cla_core::flash::{FlashStore, ResumeError};
    use embedded_storage::nor_flash::NorFlashErrorKind;
    use firmware_example::controller::Keep;
    use firmware_example::hal;
    use firmware_example::keeper::{ByPolicy, Event};
    use firmware_example::link::Life;
    use firmware_example::resume::{SLOT, SLOTS};
    use firmware_example::shelf::Shelf;
    use semihosting::eprintln;

    use super::{Brain, Service};

    /// Says what becomes of the brain.
    fn say(event: Event<NorFlashErrorKind>) {
        match event {
            Event::Saved(it) => eprintln!("kept generation {} of life {}", it.generation, it.tick),
            Event::Mended(many) => eprintln!("{many} entries were mended or dropped"),
            Event::Refused(why) => eprintln!("not kept: {why}"),
            Event::Lost(part) => eprintln!("{part} is lost"),
            Event::Resumed(it) => eprintln!("brought generation {} back", it.generation),
            Event::Gone(why) => eprintln!("nothing was brought back: {why}"),
            // Of a life along the recording.
            Event::Born(_) | Event::Saving(..) => {}
        }
    }

    /// Opens the flash and resumes the life that lies there, and says so; `None` when there is no flash.
    pub(super) fn bring_back(
        brain: &mut Brain,
        service: Service,
    ) -> Option<(impl Keep<Brain> + use<>, Service)> {
        let flash = hal::flash(SLOTS * SLOT as usize)?;
        let mut shelf = Shelf::<_, SLOTS>::new(FlashStore::open(flash, 0, SLOT).ok()?);
        let life = match shelf.resume(brain) {
            Ok(it) => {
                eprintln!("resumed generation {} of life {}", it.generation, it.tick);
                Life(it.tick)
            }
            Err(ResumeError::Nothing) => {
                eprintln!("nobody lives here yet");
                Life::UNBORN
            }
            Err(why) => {
                eprintln!("nothing is saved over the brain that lies here: {why}");
                Life::UNBORN
            }
        };
        let kept = ByPolicy::new(shelf, hal::POLICY, hal::power_is_failing, say);
        Some((kept, Service { life, ..service }))
    }
}

/// Without flash every life begins anew.
#[cfg(not(feature = "flash"))]
mod kept {
    use super::{Brain, Service};

    pub(super) fn bring_back(_: &mut Brain, service: Service) -> Option<((), Service)> {
        Some(((), service))
    }
}

static mut BRAIN: Brain = profile::brain();

#[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
#[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
fn main() -> ! {
    let brain = &raw mut BRAIN;
    // SAFETY: this runs once, and no interrupt touches the brain.
    #[allow(unsafe_code)]
    let brain = unsafe { &mut *brain };
    let kept = hal::service().and_then(|service| kept::bring_back(brain, service));
    let end = Serial::open()
        .zip(kept)
        .map(|(mut serial, (mut kept, service))| {
            serve(brain, &mut serial, &mut Motors::start(), &mut kept, service)
        });
    hal::end(end)
}

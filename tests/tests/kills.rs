//! The firmware in QEMU is killed at random moments, its flash in a file, and started again: it goes
//! on from a life that it had saved, and the life is to the byte that of a part that never lost its
//! power.
//!
//! `CLA_KILLS` says how often (`tests/run firmware_kills`). Moments are of chance, what is asked of
//! each is not. Needs qemu-system-arm and the target; `tests/run` gets them.

use host_sim::device::flash::kills::{kill_again_and_again, program};

#[test]
fn killed_at_random_moments_the_firmware_loses_nothing_that_it_had_saved() {
    let kills = std::env::var("CLA_KILLS").ok();
    let kills: u32 = kills.map_or(20, |it| it.parse().expect("CLA_KILLS is a number"));
    let program = program().unwrap_or_else(|error| panic!("{error}"));
    let seed = u64::from(kills);
    let came = kill_again_and_again(&program, kills, seed);
    let came = came.unwrap_or_else(|error| panic!("{error}"));
    println!("{came:?}");
    assert_eq!((came.lost, came.wrong, came.refused), (0, 0, 0), "{came:?}");
    assert!(
        came.saves > 0 && came.within > 0 && came.last.0 > 0,
        "{came:?}"
    );
}

//! The committed results of `mcu` are the ones that were promised, and a part of them comes out
//! again: what needs no emulator here, the rest in `firmware`, `hil` and `panic_free`.

use host_sim::device::board::{Build, section_bytes};
use host_sim::device::target::Target;
use host_sim::report::Summary;

fn committed() -> Summary {
    let text = include_str!("../claims/mcu.json");
    Summary::from_json(text).expect("the claims file can be read")
}

#[test]
fn the_committed_claims_are_the_ones_that_were_promised() {
    let committed = committed();
    assert_eq!(committed.seeds, (100..120).collect::<Vec<u64>>());
    for id in [
        "mcu.hash.m4f",
        "mcu.hash.m0",
        "mcu.hash.riscv",
        "mcu.tick.level2.m4f",
        "mcu.tick.level2.m0",
        "mcu.bmu.vs_cmsis",
        "mcu.ram.small_profile",
        "mcu.small_profile.captures",
        "mcu.stack",
        "mcu.flash",
        "mcu.hil.captures",
        "mcu.hil.round_trips",
        "host.som.vs_minisom",
    ] {
        assert!(committed.find(id).is_some(), "{id}");
    }
    for id in [
        "mcu.hash.m4f",
        "mcu.hash.m0",
        "mcu.hash.riscv",
        "mcu.hil.same",
    ] {
        let claim = committed.find(id).expect("it is claimed");
        assert_eq!(claim.ours.value, Some(1.0), "{id}");
    }
}

#[test]
fn code_and_static_memory_come_out_as_committed() {
    let committed = committed();
    let claimed = |id| committed.find(id).and_then(|claim| claim.ours.value);
    let proof = Build {
        opt_level: "s",
        entry: "training",
        ..Build::new(Target::M4f, "panic_free")
    };
    let program = proof.build().unwrap_or_else(|error| panic!("{error}"));
    let bytes = |name| section_bytes(&program, name).expect("a program");
    let flash = (bytes(".text") + bytes(".rodata")) as f64;
    let claim = claimed("mcu.flash").expect("a claim");
    // The order of functions, and so their padding, hangs on the folder of the checkout.
    assert!((flash - claim).abs() <= 32.0, "{flash} for {claim}");
    assert_eq!(
        claimed("mcu.ram.small_profile"),
        Some(cla_core::forager::small::RAM as f64)
    );
}

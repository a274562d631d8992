//! Gives the linker the memory of one part: `PART` names a file in `memory/`.
//!
//! Without `PART` the part is the emulated board.
//! A brain that does not fit the part beside 4 KiB of stack does not link.

use std::path::Path;
use std::{env, fs};

fn main() {
    let target = env::var("TARGET").expect("cargo sets it");
    println!("cargo::rerun-if-env-changed=PART");
    println!("cargo::rerun-if-changed=memory");
    if env::var("CARGO_CFG_TARGET_OS").as_deref() != Ok("none") {
        return;
    }
    let riscv = target.starts_with("riscv");
    let bench = env::var_os("CARGO_FEATURE_KERNELS").is_some();
    let usual = match (riscv, bench) {
        (true, false) => "riscv-virt",
        (true, true) => "riscv-virt-bench",
        (false, _) => "mps2",
    };
    let part = env::var("PART").unwrap_or_else(|_| usual.to_owned());
    let from = Path::new("memory").join(format!("{part}.x"));
    let memory = fs::read_to_string(&from)
        .unwrap_or_else(|error| panic!("PART={part}: there is no {}: {error}", from.display()));
    let out = env::var("OUT_DIR").expect("cargo sets it");
    fs::write(Path::new(&out).join("memory.x"), memory).expect("cargo's folder can be written");
    println!("cargo::rustc-link-search={out}");
    // The proof of panic-freedom is not a program: it brings its own entry and has no memory.
    for program in [
        "firmware",
        "meter",
        "kernels",
        "controller",
        "mind",
        "calls",
        "snapshot",
        "mind_snapshot",
        "survivor",
        "wire",
        "wired",
    ] {
        println!("cargo::rustc-link-arg-bin={program}=-Tlink.x");
        if env::var_os("CARGO_FEATURE_DEFMT").is_some() {
            println!("cargo::rustc-link-arg-bin={program}=-Tdefmt.x");
        }
    }
}

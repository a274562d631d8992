#![no_main]
//! Its body is that of the same name in `cla_fuzz_bodies`.

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| cla_fuzz_bodies::run("calls", bytes));

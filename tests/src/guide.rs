//! The guide: every Rust snippet of `docs/guide` is compiled and run as a documentation test.

#![doc = include_str!("../../docs/guide/src/hello.md")]
#![doc = include_str!("../../docs/guide/src/robot.md")]
#![doc = include_str!("../../docs/guide/src/sizing.md")]
#![doc = include_str!("../../docs/guide/src/cortex-m.md")]
#![doc = include_str!("../../docs/guide/src/reading.md")]

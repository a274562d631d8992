//! What the wire costs on three processors: sessions, frames and the safe stop, against
//! `memory-budget.md`.

use host_sim::device::board::{Build, Printed, section_bytes};
use host_sim::device::target::Target;

use super::budget::{HEAD, Rows, Tolerance, hold, number};
use super::run_once;

/// How frames are sealed, and the features of the firmware for it.
const SEALS: [(&str, &str); 2] = [("checksum", ""), ("key", "authentic")];

#[test]
fn an_order_over_the_wire_takes_the_memory_and_the_instructions_of_the_budget() {
    let (mut ram, mut instructions) = (Rows::new(), Rows::new());
    for (seal, features) in SEALS {
        let printed = Target::ALL.map(|target| {
            let build = Build {
                features,
                ..Build::new(target, "wire")
            };
            run_once(&build)
        });
        for it in &printed {
            // A whole life's orders, in whose midst the robot was stopped.
            let text = it.text();
            assert!(number(it, "answered", "") > 2_000, "{text}");
            assert_eq!(number(it, "interrupted", ""), 1, "{text}");
            // At the beginning, for want of orders, to be kept, and at the end.
            assert_eq!(number(it, "stopped", ""), 4, "{text}");
            assert_eq!(number(it, "lost", ""), 0, "{text}");
        }
        let row = |(what, start, word): (&str, &str, &str)| -> (String, Vec<Option<u64>>) {
            let cell = |it: &Printed| Some(number(it, start, word));
            (
                format!("{seal}: {what}"),
                printed.iter().map(cell).collect(),
            )
        };
        let bytes = [
            ("session and clock of the stop", "session bytes", ""),
            ("frame that comes in", "receiver bytes", ""),
            (
                "buffers of what was heard and what is said",
                "buffer bytes",
                "",
            ),
            ("deepest stack", "stack bytes", ""),
        ];
        let counted = [
            ("an order, mean", "order instructions", "mean"),
            ("an order, worst", "order instructions", "worst"),
            ("a handshake, worst", "hello instructions", "worst"),
            ("a broken frame, worst", "broken instructions", "worst"),
            (
                "a look at the clock, or the stop, worst",
                "pause instructions",
                "worst",
            ),
        ];
        ram.extend(bytes.map(row));
        instructions.extend(counted.map(row));
    }
    hold("wire", HEAD, &ram, Tolerance::None);
    hold("wire instructions", HEAD, &instructions, Tolerance::Percent);
}

#[test]
fn bytes_of_the_wires_code_are_those_of_the_budget() {
    let bytes = |build: &Build| {
        let program = build.build().unwrap_or_else(|error| panic!("{error}"));
        let bytes = |name| section_bytes(&program, name).expect("a program");
        bytes(".text") + bytes(".rodata")
    };
    let mut rows = Rows::new();
    for opt_level in ["3", "s"] {
        let bare = Target::ALL.map(|target| {
            bytes(&Build {
                opt_level,
                entry: "bare",
                ..Build::new(target, "wired")
            })
        });
        for (seal, features) in SEALS {
            let cell = |(&target, bare): (&Target, &u64)| {
                let wired = Build {
                    features,
                    opt_level,
                    ..Build::new(target, "wired")
                };
                Some(bytes(&wired) - bare)
            };
            rows.push((
                format!("{seal}, opt-level {opt_level}"),
                Target::ALL.iter().zip(&bare).map(cell).collect(),
            ));
        }
    }
    hold("wire flash", HEAD, &rows, Tolerance::Padding);
}

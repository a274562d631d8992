//! What the brain costs on three processors, measured in QEMU and read from the programs, against
//! `memory-budget.md`: 1 % of the instructions may differ, not a byte of memory, and of code what
//! the compiler pads.

use std::fs;

use host_sim::device::board::{Build, Printed, section_bytes};
use host_sim::device::target::Target;

use super::run_once;

/// Rows of a table: what, and a number for each column; `None` where nothing was measured.
pub(super) type Rows = Vec<(String, Vec<Option<u64>>)>;

/// How much a number may differ from the committed one.
#[derive(Clone, Copy)]
pub(super) enum Tolerance {
    /// Not at all.
    None,
    /// One in a hundred.
    Percent,
    /// Padding between functions: their order hangs on the folder of the checkout.
    Padding,
}

fn table(head: &str, rows: &Rows) -> String {
    let columns = head.matches('|').count() - 2;
    let mut text = format!("{head}\n|---|{}\n", "---:|".repeat(columns));
    for (name, numbers) in rows {
        let cell = |number: &Option<u64>| number.map_or("–".to_owned(), grouped);
        let cells: Vec<String> = numbers.iter().map(cell).collect();
        text.push_str(&format!("| {name} | {} |\n", cells.join(" | ")));
    }
    text
}

fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|it| str::from_utf8(it).expect("digits"))
        .collect();
    groups.join(",")
}

/// Compares a table with the one between its markers, or writes it there.
pub(super) fn hold(name: &str, head: &str, rows: &Rows, tolerance: Tolerance) {
    let path = cla_tests::root().join("memory-budget.md");
    let text = fs::read_to_string(&path).expect("the budget can be read");
    let marker = format!("<!-- budget: {name} -->\n");
    let (before, rest) = text.split_once(&marker).expect("the table has its marker");
    let (committed, after) = rest
        .split_once("<!-- end -->")
        .expect("the table has an end");
    let measured = table(head, rows);
    if std::env::var_os("UPDATE_BUDGET").is_some() {
        fs::write(
            &path,
            format!("{before}{marker}{measured}<!-- end -->{after}"),
        )
        .expect("it can be written");
        return;
    }
    let complaint = format!(
        "{name}: run UPDATE_BUDGET=1 cargo test -p cla-tests --test firmware -- --test-threads=1 \
         when that is meant\ncommitted\n{committed}measured\n{measured}"
    );
    let (old, new): (Vec<&str>, Vec<&str>) = (
        committed.split('|').collect(),
        measured.split('|').collect(),
    );
    assert_eq!(old.len(), new.len(), "{complaint}");
    for (old, new) in old.iter().zip(new) {
        let number = |cell: &str| cell.trim().replace(',', "").parse::<f64>().ok();
        let near = match (tolerance, number(old), number(new)) {
            (Tolerance::Percent, Some(old), Some(new)) => (old - new).abs() <= 0.01 * old,
            (Tolerance::Padding, Some(old), Some(new)) => (old - new).abs() <= 32.0,
            _ => *old == new,
        };
        assert!(near, "{old} became {new}\n{complaint}");
    }
}

fn program(target: Target, features: &'static str) -> Build {
    Build {
        features,
        ..Build::new(target, "firmware")
    }
}

/// The number after `start` and, in the same line, after `word`.
pub(super) fn number(printed: &Printed, start: &str, word: &str) -> u64 {
    printed
        .number(start, word)
        .unwrap_or_else(|error| panic!("{error}"))
}

pub(super) const HEAD: &str = "| | Cortex-M4F | Cortex-M0+ | RV32IMAC |";

const PROFILES: [(&str, &str); 2] = [("forager", ""), ("small", "small")];

#[test]
fn instructions_of_every_part_of_a_step_are_those_of_the_budget() {
    let mut rows = Rows::new();
    for (profile, features) in PROFILES {
        let printed = Target::ALL.map(|target| run_once(&program(target, features)));
        for (part, words) in [
            ("tick_level1", &["mean", "worst"][..]),
            ("choose_level2", &["mean", "worst"]),
            ("learn_level2", &["mean", "worst"]),
            ("tick_level2", &["mean", "worst"]),
            ("harvest", &["worst"]),
            ("settle", &["worst"]),
            ("weighing", &["worst"]),
        ] {
            for word in words {
                let cell = |printed: &Printed| {
                    let number = number(printed, &format!("{part} instructions"), word);
                    (number > 0).then_some(number)
                };
                rows.push((
                    format!(
                        "{profile}: {}, {word}",
                        part.replace("_level", " at level ")
                    ),
                    printed.iter().map(cell).collect(),
                ));
            }
        }
    }
    hold("instructions", HEAD, &rows, Tolerance::Percent);
    hold("time", TIME_HEAD, &times(&rows), Tolerance::Percent);
}

const TIME_HEAD: &str =
    "| | MHz | tick at level 2, mean, µs | tick, worst, µs | harvest, worst, µs |";

/// Parts with the largest profile that fits them, their column and their clock in MHz.
const PARTS: [(&str, &str, usize, u64); 5] = [
    ("nRF52840", "small", 0, 64),
    ("STM32F405", "small", 0, 168),
    ("RP2350", "forager", 0, 150),
    ("STM32H743", "forager", 0, 480),
    ("RP2040", "forager", 1, 133),
];

/// What the instructions take where each is one cycle of the part's clock.
fn times(instructions: &Rows) -> Rows {
    let of = |name: String, column: usize, clock: u64| {
        let row = instructions.iter().find(|(row, _)| *row == name);
        let number = row.and_then(|(_, cells)| cells[column]);
        number.map(|number| number.div_ceil(clock))
    };
    let row = |&(part, profile, column, clock): &(&str, &str, usize, u64)| {
        let time = |what: &str| of(format!("{profile}: {what}"), column, clock);
        let cells = [
            Some(clock),
            time("tick at level 2, mean"),
            time("tick at level 2, worst"),
            time("harvest, worst"),
        ];
        (format!("{part}, {profile}"), cells.to_vec())
    };
    PARTS.iter().map(row).collect()
}

#[test]
fn instructions_of_the_kernels_are_those_of_the_budget() {
    let printed = Target::ALL.map(|target| {
        let bench = Build {
            features: "kernels",
            ..Build::new(target, "kernels")
        };
        bench.run().unwrap_or_else(|error| panic!("{error}"))
    });
    let mut rows = Rows::new();
    for line in printed[0].text().lines() {
        let (name, _) = line.split_once(" = ").expect("name = number");
        let cell = |printed: &Printed| Some(number(printed, &format!("{name} ="), ""));
        rows.push((name.replace('_', " "), printed.iter().map(cell).collect()));
    }
    let on_m4f = |name: &str| {
        let row = rows.iter().find(|row| row.0 == name);
        row.and_then(|row| row.1[0])
            .expect("the shape of the issue")
    };
    let (floats, bytes) = (
        on_m4f("f32 best match 400x142 on 10"),
        on_m4f("u8 best match 400x142 on 10"),
    );
    assert!(floats <= 15_000 && bytes <= 10_900, "{floats} {bytes}");
    hold("kernels", HEAD, &rows, Tolerance::Percent);
}

#[test]
fn bytes_of_ram_and_stack_are_those_of_the_budget() {
    let mut rows = Rows::new();
    for (profile, features) in PROFILES {
        let printed = Target::ALL.map(|target| run_once(&program(target, features)));
        for what in ["static", "stack", "doubting"] {
            let cell = |printed: &Printed| Some(number(printed, &format!("{what} bytes"), ""));
            let name = match what {
                "static" => "all statics of the program",
                "doubting" => "deepest stack in a doubt",
                _ => "deepest stack",
            };
            rows.push((
                format!("{profile}: {name}"),
                printed.iter().map(cell).collect(),
            ));
        }
        for target in Target::ALL {
            let program = program(target, features).build();
            let program = program.unwrap_or_else(|error| panic!("{error}"));
            let data = section_bytes(&program, ".data").expect("a program");
            assert_eq!(data, 0, "{profile}: the brain would lie in flash as well");
        }
    }
    hold("ram", HEAD, &rows, Tolerance::None);
}

#[test]
fn bytes_of_the_cores_code_are_those_of_the_budget() {
    let mut rows = Rows::new();
    let mut at_s = Vec::new();
    for opt_level in ["3", "s"] {
        for (name, entry) in [
            ("a robot that acts", "acting"),
            ("a robot that learns", "training"),
            ("a robot that keeps its life", "keeping"),
        ] {
            let bytes = Target::ALL.map(|target| {
                let proof = Build {
                    opt_level,
                    entry,
                    ..Build::new(target, "panic_free")
                };
                let program = proof.build().unwrap_or_else(|error| panic!("{error}"));
                let bytes = |name| section_bytes(&program, name).expect("a program");
                Some(bytes(".text") + bytes(".rodata"))
            });
            if opt_level == "s" {
                at_s.extend(bytes[0]);
            }
            rows.push((format!("{name}, opt-level {opt_level}"), bytes.to_vec()));
        }
    }
    assert!(at_s[0] <= 16 * 1024 && at_s[1] <= 32 * 1024, "{at_s:?}");
    hold("flash", HEAD, &rows, Tolerance::Padding);
}

const CALLS_HEAD: &str =
    "| Cortex-M4F | choose, mean | 99 % of them | worst | learn, mean | 99 % of them | worst |";

/// Robots of `calls`, the most that a call may take, `None` for one that says what it takes, and the
/// percent of a table that its life fills: with 1024 samples no more leaves grow than that.
const ROBOTS: [(&str, Option<u64>, u64); 5] = [
    ("forager", Some(120_000), 95),
    ("small", Some(105_000), 70),
    ("twelve items", Some(120_000), 95),
    ("twelve items and plans", None, 95),
    ("twelve items and plans, at 1200 units", Some(120_000), 95),
];

#[test]
fn calls_of_the_learner_for_any_world_are_bounded_whatever_the_robot() {
    let mind = run_once(&Build::new(Target::M4f, "mind"));
    let calls = run_once(&Build::new(Target::M4f, "calls"));
    let recorded = |kind: &str, word: &str| Some(number(&mind, kind, word));
    let mut rows = Rows::new();
    rows.push((
        "forager, the recorded life".to_owned(),
        vec![
            recorded("choose", "mean"),
            None,
            recorded("choose", "worst"),
            recorded("learn", "mean"),
            None,
            recorded("learn", "worst"),
        ],
    ));
    for (robot, most, full) in ROBOTS {
        let line = calls.after(&format!("{robot}:")).expect("its life");
        let (_, kinds) = line.split_once(" choose ").expect("both kinds");
        let (choose, learn) = kinds.split_once(" learn ").expect("both kinds");
        let word = |kind: &str, word: &str| -> u64 {
            let mut words = kind.split_whitespace().skip_while(|&it| it != word);
            let number = words.nth(1).and_then(|it| it.parse().ok());
            number.unwrap_or_else(|| panic!("{word}: {line}"))
        };
        let words = ["mean", "most", "worst"];
        let numbers = [choose, learn].map(|kind| words.map(|it| word(kind, it)));
        if let Some(most) = most {
            assert!(numbers[0][2].max(numbers[1][2]) <= most, "{robot}: {line}");
        }
        // A life whose tables fill, and in which the reward stayed away.
        assert!(
            word(learn, "alarms") > 0 && word(learn, "fullest") >= full,
            "{line}"
        );
        rows.push((
            robot.to_owned(),
            numbers.concat().into_iter().map(Some).collect(),
        ));
    }
    hold("calls", CALLS_HEAD, &rows, Tolerance::Percent);
}

//! `memory-budget.md` is true, and so is what README says of bytes: each is measured here.
//!
//! `UPDATE_BUDGET=1 cargo test -p cla-tests --test budget` writes its tables anew.

use std::fs;
use std::mem::{size_of, size_of_val};

use cla_core::forager::pioneer::{self, WORDS};
use cla_core::forager::small;
use cla_core::knowledge::Schema;
use cla_core::num::Rng;
use cla_core::word::{ItemStates, SignedItems};
use host_sim::experiment::microworld::goals::Planning;
use host_sim::experiment::microworld::level1::{ByteBank, Clasm, FloatBank, Mind, SeededMind};
use host_sim::experiment::microworld::{level2, synthetic};
use host_sim::learner::mind::Brain;

/// Rows of a table: a structure, how many of them, bytes of all.
type Rows = Vec<(&'static str, usize, usize)>;

fn forager() -> Rows {
    let brain = Box::new(pioneer::brain());
    let maps = brain.bank().maps();
    let knowledge = size_of_val(brain.knowledge());
    let bank = size_of_val(brain.bank());
    let level2 = size_of_val(brain.second_level());
    let habits = size_of_val(brain.habits());
    vec![
        ("**brain**", 1, pioneer::RAM),
        ("bank of Action SOMs, with its scratch distances", 1, bank),
        (
            "· Action SOM of 20 × 20 nodes",
            maps.len(),
            size_of_val(maps),
        ),
        ("knowledge base", 1, knowledge),
        ("· schema", 704, 704 * size_of::<Schema>()),
        (
            "· pattern of items",
            128,
            128 * size_of::<SignedItems<WORDS>>(),
        ),
        ("second level: synthetic items and beliefs", 1, level2),
        ("habits", 1, habits),
        (
            "the rest: configuration, last percept, generator, counters",
            1,
            pioneer::RAM - knowledge - bank - level2 - habits,
        ),
        ("· percept", 1, size_of::<ItemStates<WORDS>>()),
        ("· random generator", 1, size_of::<Rng>()),
    ]
}

/// What README says of whole brains.
fn brains() -> String {
    format!(
        "The forager takes {} bytes with the one learner and 7168 samples; with the book's it takes {} \
         bytes with 20 × 20 maps and both levels, and {} with maps of 10 × 10 and a byte for each weight.\n",
        grouped(size_of::<Brain<1, 7, 6>>()),
        grouped(pioneer::RAM),
        grouped(small::RAM)
    )
}

fn one_learner() -> Rows {
    vec![
        (
            "forager: 7 items, 6 actions",
            1,
            size_of::<Brain<1, 7, 6>>(),
        ),
        (
            "vacuum: 15 items, 5 actions",
            1,
            size_of::<Brain<1, 15, 5>>(),
        ),
        (
            "largest generated world: 64 items, 12 actions",
            1,
            size_of::<Brain<2, 64, 12>>(),
        ),
    ]
}

/// The host profile keeps everything in `f32`; the other fits a part of 256 KiB.
fn microworld() -> Rows {
    let floats = size_of::<FloatBank>()
        + size_of::<Mind>()
        + size_of::<Planning>()
        + size_of::<level2::Maps>()
        + size_of::<level2::Memory>()
        + size_of::<synthetic::Synthetic>()
        + size_of::<synthetic::Memory>();
    vec![
        ("**host profile**", 1, floats),
        ("· maps of 10 × 10 nodes, `f32`", 10, size_of::<FloatBank>()),
        (
            "· accommodation: 1500 schemas, 150 samples an action",
            1,
            size_of::<Mind>(),
        ),
        ("· planner: 300 states", 1, size_of::<Planning>()),
        (
            "· level 2: maps of one mode, `f32`",
            19,
            size_of::<level2::Maps>(),
        ),
        (
            "· cross-modal: 1024 schemas, 512 samples a composite action",
            1,
            size_of::<level2::Memory>(),
        ),
        ("· synthetic items", 178, size_of::<synthetic::Synthetic>()),
        (
            "· schemas about them: 2048, 384 samples an action",
            1,
            size_of::<synthetic::Memory>(),
        ),
        (
            "**profile for 256 KiB**",
            1,
            Clasm::BYTES + size_of::<Planning>(),
        ),
        (
            "· maps of 10 × 10 nodes, a byte a weight",
            10,
            size_of::<ByteBank>(),
        ),
        (
            "· accommodation: 1250 schemas, 88 samples an action",
            1,
            size_of::<SeededMind>(),
        ),
        ("· planner: 300 states", 1, size_of::<Planning>()),
    ]
}

fn markdown(rows: &Rows) -> String {
    let mut text = String::from("| structure | number | bytes |\n|---|---:|---:|\n");
    for (name, number, bytes) in rows {
        text.push_str(&format!("| {name} | {number} | {} |\n", grouped(*bytes)));
    }
    text
}

/// 206172 as 206,172.
fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The text with the part between a table's markers replaced.
fn with_table(text: &str, name: &str, table: &str) -> String {
    let marker = format!("<!-- budget: {name} -->\n");
    let (before, rest) = text.split_once(&marker).expect("the table has its marker");
    let (_, after) = rest
        .split_once("<!-- end -->")
        .expect("the table has an end");
    format!("{before}{marker}{table}<!-- end -->{after}")
}

#[test]
fn the_budget_says_what_the_brain_costs() {
    held("memory-budget.md", |text| {
        let text = with_table(text, "forager", &markdown(&forager()));
        let text = with_table(&text, "mind", &markdown(&one_learner()));
        with_table(&text, "microworld", &markdown(&microworld()))
    });
}

#[test]
fn readme_says_what_a_brain_costs() {
    held("README.md", |text| with_table(text, "brains", &brains()));
}

/// Compares a document with what is measured, or writes it anew.
fn held(document: &str, measured: impl Fn(&str) -> String) {
    let path = cla_tests::root().join(document);
    let text = fs::read_to_string(&path).expect("the document can be read");
    let measured = measured(&text);
    if std::env::var_os("UPDATE_BUDGET").is_some() {
        fs::write(&path, measured).expect("the document can be written");
    } else {
        assert_eq!(
            text, measured,
            "run UPDATE_BUDGET=1 cargo test -p cla-tests --test budget"
        );
    }
}

#[test]
fn the_parts_of_the_brain_are_the_whole() {
    let rows = forager();
    let parts: usize = [1, 3, 6, 7, 8].iter().map(|&row| rows[row].2).sum();
    assert_eq!(parts, rows[0].2);
    assert!(rows[2].2 <= rows[1].2 && rows[4].2 + rows[5].2 <= rows[3].2);
}

#[test]
fn the_microworld_keeps_the_bounds_that_its_claims_name() {
    let rows = microworld();
    assert!(size_of::<Mind>() <= 64_000 && Clasm::BYTES <= 200_000);
    assert!(size_of::<Planning>() <= 8_000);
    let small = rows
        .iter()
        .find(|row| row.0 == "**profile for 256 KiB**")
        .expect("a profile");
    assert!(small.2 <= 256 * 1024 && rows[0].2 > small.2);
    let parts: usize = rows[1..8].iter().map(|row| row.2).sum();
    assert_eq!(parts, rows[0].2);
}

#[test]
fn thousands_are_grouped() {
    assert_eq!(grouped(206_172), "206,172");
    assert_eq!(grouped(999), "999");
    assert_eq!(grouped(1_000), "1,000");
}

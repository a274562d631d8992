//! Any text where people write texts: it is read, or refused in one sentence; what is read is written
//! and read again.

use cla_core::forager::pioneer::VOCABULARY;
use cla_core::word::{Detail, SchemaText};
use clap::Parser;
use host_sim::cli::Cli;
use host_sim::device::budget::Budget;
use host_sim::options::Order;
use host_sim::report::Rule;
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::Damage;
use host_sim::world::layout::Layout;
use host_sim::world::pomdp::Pomdp;

/// Bytes as text; what is none in UTF-8 is replaced.
fn text(bytes: &[u8]) -> std::borrow::Cow<'_, str> {
    String::from_utf8_lossy(bytes)
}

fn sentence(refused: &impl std::fmt::Display) {
    let sentence = refused.to_string();
    assert!(
        !sentence.is_empty() && !sentence.contains('\n'),
        "{sentence:?}"
    );
}

/// Places of specimens.
pub(super) fn layouts(bytes: &[u8]) {
    let radius = PioneerConfig::NOISY.radius;
    match Layout::parse(&text(bytes), radius) {
        Ok(layout) => layout
            .check(radius)
            .expect("what was read lies in the room"),
        Err(refused) => sentence(&refused),
    }
}

/// Damages of a robot.
pub(super) fn damages(bytes: &[u8]) {
    match Damage::parse(&text(bytes), VOCABULARY.items, VOCABULARY.actions) {
        Ok(damage) => {
            let written = damage.to_string();
            let again = Damage::parse(&written, VOCABULARY.items, VOCABULARY.actions);
            assert_eq!(again.as_ref().ok(), Some(&damage), "{written}");
        }
        Err(refused) => sentence(&refused),
    }
}

/// A command line, and limits as `--budget` takes them; nothing is run.
pub(super) fn configs(bytes: &[u8]) {
    let text = text(bytes);
    // No file of this machine is read.
    let words = text.split_whitespace().filter(|it| !it.contains('/'));
    let words: Vec<String> = words.map(str::to_owned).collect();
    if let Err(refused) = Budget::new(&words, "cortex-m4f") {
        sentence(&refused);
    }
    let line = [String::from("host-sim")].into_iter().chain(words);
    let Ok(cli) = Cli::try_parse_from(line) else {
        return;
    };
    if let Err(refused) = Order::new(&cli) {
        sentence(&refused);
    }
}

/// Rules of verdicts, as claims have them.
pub(super) fn rules(bytes: &[u8]) {
    match text(bytes).parse::<Rule>() {
        Ok(rule) => {
            let written = rule.to_string();
            assert_eq!(written.parse::<Rule>().as_ref(), Ok(&rule), "{written}");
        }
        Err(refused) => sentence(&refused),
    }
}

/// Schemas in the book's notation.
pub(super) fn notation(bytes: &[u8]) {
    match SchemaText::<1>::parse(&text(bytes), &VOCABULARY) {
        Ok(schema) => {
            let written = schema.display(&VOCABULARY, Detail::Full).to_string();
            let again = SchemaText::<1>::parse(&written, &VOCABULARY);
            assert_eq!(again.as_ref(), Ok(&schema), "{written}");
            assert!(
                !schema
                    .display(&VOCABULARY, Detail::Abbreviated)
                    .to_string()
                    .is_empty()
            );
        }
        Err(refused) => sentence(&refused),
    }
}

/// Files in Cassandra's format.
pub(super) fn pomdps(bytes: &[u8]) {
    match Pomdp::parse(&text(bytes)) {
        Ok(pomdp) => {
            let sums = |chances: &[f64]| {
                let sum: f64 = chances.iter().sum();
                assert!((sum - 1.0).abs() < 1e-3, "{sum}");
            };
            sums(pomdp.start());
            sums(pomdp.next(0, 0));
            sums(pomdp.observed(0, 0));
            assert!(pomdp.expected(0, 0).is_finite());
        }
        Err(refused) => sentence(&refused),
    }
}

//! Any text where people write texts: it is read, or refused in one sentence; what is read is written
//! and read again.

use cla_core::forager::pioneer::VOCABULARY;
use cla_core::word::{Detail, SchemaText};
use clap::Parser;
use host_sim::cli::{Cli, Command};
use host_sim::device::budget::Budget;
use host_sim::experiment::live::LiveOptions;
use host_sim::options::{Order, foraging};
use host_sim::report::Rule;
use host_sim::settings;
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

/// A file with settings as `--config` takes it, a command line, and limits as `--budget` takes them;
/// nothing is run.
pub(super) fn configs(bytes: &[u8]) {
    let text = text(bytes);
    settings_of_a_file(&text);
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

/// Settings of `live` and of `forage`; those of a life are written, and read again as the same.
fn settings_of_a_file(text: &str) {
    let tree = match settings::parse(text) {
        Ok(tree) => tree,
        Err(refused) => {
            sentence(&refused);
            return;
        }
    };
    // No file of this machine is read.
    let world = &tree["world"];
    let is_file = |name: &str| name.contains('.');
    let is_layout = |path: &str| path != "none";
    if world["name"].as_str().is_some_and(is_file)
        || world["layout"].as_str().is_some_and(is_layout)
    {
        return;
    }
    match LiveOptions::new(vec![1], tree.clone()) {
        Ok(options) => {
            let taken = options.settings();
            let written = settings::text(&taken).expect("what is taken can be written");
            let again = settings::parse(&written).and_then(|it| LiveOptions::new(vec![1], it));
            let again = again.map(|it| it.settings());
            assert_eq!(again.as_ref(), Ok(&taken), "{written}");
        }
        Err(refused) => sentence(&refused),
    }
    let forage = Cli::try_parse_from(["host-sim", "forage"]).map(|cli| cli.command);
    let Ok(Some(Command::Forage {
        seeds,
        world,
        length,
        ..
    })) = forage
    else {
        panic!("forage has a default for everything");
    };
    if let Err(refused) = foraging(tree, &seeds, &world, length) {
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

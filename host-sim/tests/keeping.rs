//! Brains in files, as the program's user and its library meet them.

use std::fs;
use std::process::{Command, Output};
use std::thread;

use cla_core::agent::{Adaptation, AgentConfig};
use cla_core::forager::pioneer::VOCABULARY;
use cla_core::forest::MindConfig;
use cla_core::snapshot::Names;
use cla_core::word::ItemId;
use host_sim::experiment::aliased::{self, Aliased, AliasedOptions};
use host_sim::experiment::live::{Inhabitant, Place};
use host_sim::experiment::plan::trials;
use host_sim::keeping::{inspect, keep, recall};
use host_sim::learner::forager::Forager;
use host_sim::learner::mind::Minded;
use host_sim::learner::rewarded::{Hears, paced};
use host_sim::learner::{Learner, live};
use host_sim::progress::Progress;
use host_sim::world::config::PioneerConfig;
use host_sim::world::damage::{Damage, Damaged};
use host_sim::world::pioneer::Pioneer;
use host_sim::world::setting::rooms;
use serde_json::json;
use tempfile::{TempDir, tempdir};

fn run(folder: &TempDir, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
    let command = command
        .args(arguments.split(' '))
        .current_dir(folder.path());
    command.output().unwrap()
}

fn said(folder: &TempDir, arguments: &str) -> String {
    let output = run(folder, arguments);
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn a_life_that_is_stopped_and_gone_on_with_ends_in_the_same_bytes() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    for (index, config) in [AgentConfig::FORAGER, AgentConfig::RESILIENT_LEVEL2]
        .into_iter()
        .enumerate()
    {
        let seed = 7 + index as u64;
        let born = || Forager::born(config, Adaptation::Relearning, seed).unwrap();
        let end = |stops: &[u32]| {
            let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
            let mut forager = born();
            for (done, stop) in stops.iter().enumerate() {
                if done == 2 {
                    forager.act().unwrap();
                }
                let lived = live(&mut forager, &mut world, *stop).unwrap();
                assert!(lived.total() < 1000);
                keep(forager.brain(), VOCABULARY.names(), &file("life")).unwrap();
                let mut other =
                    Forager::born(AgentConfig::BOOK, Adaptation::Relearning, 1).unwrap();
                recall(other.brain_mut(), VOCABULARY.names(), &file("life")).unwrap();
                forager = other;
            }
            fs::read(file("life")).unwrap()
        };
        let whole = {
            let mut world = Pioneer::new(PioneerConfig::NOISY, seed).unwrap();
            let mut forager = born();
            live(&mut forager, &mut world, 1500).unwrap();
            forager.act().unwrap();
            live(&mut forager, &mut world, 1000).unwrap();
            keep(forager.brain(), VOCABULARY.names(), &file("whole")).unwrap();
            fs::read(file("whole")).unwrap()
        };
        assert!(end(&[700, 800, 1000]) == whole, "{config:?}");
    }
    let left: Vec<_> = fs::read_dir(folder.path()).unwrap().flatten().collect();
    assert_eq!(left.len(), 2, "{left:?}");
}

#[test]
fn a_brain_is_trained_kept_gone_on_with_and_looked_into() {
    let folder = tempdir().expect("a folder");
    let first = said(
        &folder,
        "train --actions 1500 --brain forager-level2 --save a.brain",
    );
    assert!(first.contains("trained for 1500 actions") && first.contains("saved a.brain"));
    let second = said(
        &folder,
        "train --actions 300 --act relearning --load a.brain --save b.brain",
    );
    assert!(second.contains("loaded a.brain") && second.contains("acted for 300"));
    let again = said(
        &folder,
        "train --actions 300 --act relearning --load a.brain --save c.brain",
    );
    assert_eq!(again, second.replace("b.brain", "c.brain"));
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("b.brain") == read("c.brain") && read("a.brain") != read("b.brain"));
    let seen = said(&folder, "inspect a.brain --most 5");
    for word in [
        "Training",
        "ingrip",
        "agent of the forager",
        "10.00",
        "/forward/",
        "synthetic items",
        "→",
    ] {
        assert!(seen.contains(word), "{word}: {seen}");
    }
}

#[test]
fn a_mind_is_trained_kept_gone_on_with_and_looked_into() {
    let folder = tempdir().expect("a folder");
    let first = said(&folder, "train --actions 1500 --brain mind --save a.brain");
    assert!(first.contains("trained for 1500 actions") && first.contains("leaves"));
    // The file says what it is.
    let go_on = "train --actions 300 --act relearning --load a.brain --save";
    let second = said(&folder, &format!("{go_on} b.brain"));
    assert!(second.contains("loaded a.brain") && second.contains("acted for 300"));
    assert_eq!(
        said(&folder, &format!("{go_on} c.brain")),
        second.replace("b.brain", "c.brain")
    );
    // It has one way to adapt, and no other is promised.
    for (arguments, code) in [
        ("train --act frozen --load a.brain", 1),
        ("train --brain mind --act frozen", 2),
    ] {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(code), "{output:?}");
        assert!(
            String::from_utf8(output.stderr)
                .unwrap()
                .contains("adapts in its own way")
        );
    }
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("b.brain") == read("c.brain") && read("a.brain") != read("b.brain"));
    let seen = said(&folder, "inspect a.brain --most 5 --page a.html");
    for word in [
        "mind of the forager",
        "Training",
        "ingrip",
        "10.00",
        "/forward/",
        "samples 15",
    ] {
        assert!(seen.contains(word), "{word}: {seen}");
    }
    assert!(
        fs::read_to_string(folder.path().join("a.html"))
            .unwrap()
            .contains("<svg class=\"graph\"")
    );
    let exported = said(&folder, "export a.brain --json");
    let whole: serde_json::Value = serde_json::from_str(&exported).unwrap();
    assert_eq!(whole["kind"], "mind");
    assert_eq!(whole["items"].as_array().unwrap().len(), 7);
    said(&folder, "export a.brain --json --out a.json");
    assert_eq!(
        fs::read_to_string(folder.path().join("a.json")).unwrap(),
        exported
    );
}

#[test]
fn the_brains_of_a_run_are_kept_in_files_that_can_be_looked_into() {
    let folder = tempdir().expect("a folder");
    let forage = "forage --seeds 3 --actions 1000 --test-actions 100 --out here";
    said(&folder, &format!("{forage} --save-brains brains"));
    for name in ["forage-3-level1", "forage-3-both"] {
        let seen = said(&folder, &format!("inspect brains/{name}.brain --most 5"));
        for word in ["agent of the forager", "ingrip", "10.00"] {
            assert!(seen.contains(word), "{name}, {word}: {seen}");
        }
    }
    let kept = fs::read_dir(folder.path().join("brains")).unwrap();
    assert_eq!(kept.count(), 2);
    // Who has none to keep says so, and who has.
    let output = run(&folder, "causal --save-brains others");
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let sentence = String::from_utf8(output.stderr).unwrap();
    let who = "forage, recover, one, live, aliased do";
    assert!(sentence.contains(who), "{sentence}");
    assert!(!folder.path().join("others").exists());
}

/// The image of a brain at the end of the life that `live` gives it with seed 3, lived by hand: two
/// rooms of 300 actions, 100 in a third, 200 damaged.
fn end_of_life(name: &str, damage: &str) -> Vec<u8> {
    let place = Place::new(json!({})).unwrap();
    let who = Inhabitant::new(json!({ "name": name }), &place, "agent").unwrap();
    let damage = Damage::parse(damage, place.items(), place.actions()).unwrap();
    let mut learner = who.born(&place, 3).unwrap();
    let [first, second, fresh] = rooms(3);
    for room in [first, second] {
        let mut room = place.build(3, room).unwrap();
        paced(&mut *learner, &mut room, 300, Hears::Items).unwrap();
    }
    learner.act().unwrap();
    let mut world = Damaged::new(place.build(3, fresh).unwrap(), Damage::None, 3).unwrap();
    paced(&mut *learner, &mut world, 100, Hears::Items).unwrap();
    let mut world = Damaged::new(world.into_world(), damage, 3).unwrap();
    paced(&mut *learner, &mut world, 200, Hears::Items).unwrap();
    learner.image(VOCABULARY.names()).unwrap().unwrap()
}

#[test]
fn live_keeps_every_brain_as_it_is_at_the_end_of_each_of_its_lives() {
    let folder = tempdir().expect("a folder");
    let agents = [
        "book",
        "forager",
        "forager-level2",
        "resilient",
        "resilient-level2",
        "forager-lasting",
        "resilient-lasting",
    ];
    let short = "--set protocol.training=300 --set protocol.before=100 --set protocol.after=200";
    let rivals = agents.join(",");
    let who = format!("--agent mind --rival {rivals},q --damage camera:+12");
    said(
        &folder,
        &format!("live --seeds 3 {who} {short} --out here --save-brains brains"),
    );
    let everybody = [&["mind"][..], &agents[..]].concat();
    for name in &everybody {
        for (damage, ending) in [("none", "none"), ("camera:+12", "camera_+12")] {
            let file = folder.path().join("brains");
            let file = file.join(format!("live-3-{name}-{ending}.brain"));
            // The largest brain that could be born passes over the stack.
            let lived = thread::scope(|scope| {
                let builder = thread::Builder::new().stack_size(64 << 20);
                let by_hand = builder.spawn_scoped(scope, || end_of_life(name, damage));
                by_hand.unwrap().join().unwrap()
            });
            assert!(fs::read(&file).unwrap() == lived, "{name}, {damage}");
            let seen = inspect(&file, 10, None).unwrap();
            for word in ["of the forager", "Acting", "ingrip", "10.00"] {
                assert!(seen.contains(word), "{name}, {damage}, {word}: {seen}");
            }
        }
    }
    // A table has no image and is left out.
    let kept = fs::read_dir(folder.path().join("brains")).unwrap();
    assert_eq!(kept.count(), 2 * everybody.len());
    // Where nobody has one, that is said before anybody lives.
    let output = run(
        &folder,
        "live --seeds 3 --agent q --out there --save-brains others",
    );
    assert_eq!(output.status.code(), Some(1), "{output:?}");
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert!(sentence.contains("nobody here has a brain"), "{sentence}");
}

#[test]
fn the_brains_of_any_world_in_which_one_can_live_are_looked_into() {
    let folder = tempdir().expect("a folder");
    let short = "--set protocol.training=50 --set protocol.before=25 --set protocol.after=50";
    let unnamed = "not known here";
    for (name, world, said_of) in [
        ("lake", "lake", ["frozen lake"; 2]),
        ("vacuum", "vacuum", ["vacuum cleaner"; 2]),
        ("chance", "generated", [unnamed, "world by chance"]),
        ("micro", "microworld", [unnamed; 2]),
        ("wide", "pioneer --set world.distractors=60", [unnamed; 2]),
    ] {
        let live = format!("live --seeds 3 --world {world} --agent mind --rival forager {short}");
        said(
            &folder,
            &format!("{live} --out {name} --save-brains {name}-brains"),
        );
        for (who, robot) in ["mind", "forager"].into_iter().zip(said_of) {
            let file = folder.path().join(format!("{name}-brains"));
            let file = file.join(format!("live-3-{who}-none.brain"));
            let seen = inspect(&file, 5, None).unwrap();
            assert!(seen.contains(robot), "{name}, {who}: {seen}");
        }
    }
    // Of one size, and of two worlds.
    let of = |name: &str| format!("{name}-brains/live-3-forager-none.brain");
    let output = run(&folder, &format!("diff {} {}", of("micro"), of("wide")));
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert!(sentence.contains("nothing to compare"), "{sentence}");
}

#[test]
fn aliased_keeps_its_brains_and_they_are_looked_into() {
    use aliased::Place;
    let folder = tempdir().expect("a folder");
    let options = AliasedOptions {
        places: vec![
            Place::Barriers,
            Place::Shuttle,
            Place::Cheese,
            Place::TMaze16,
        ],
        shorter: 500,
        ..AliasedOptions::standard(vec![3])
    };
    let progress = Progress::hidden().keeping_brains(folder.path());
    trials::<Aliased>(&options, &progress.unwrap()).unwrap();
    let file = |place: Place, who: &str| {
        let name = format!("aliased-3-{}-{who}.brain", place.name());
        folder.path().join(name)
    };
    // Planning in the hallway takes a while: newborn ones stand for those that lived there.
    let hallway = Place::Hallway.model().unwrap().unwrap();
    let names = Names::of(hallway.observations(), hallway.actions());
    let mut book = Box::new(aliased::Book::<21, 5>::new());
    let config = AgentConfig::RESILIENT_LEVEL2;
    book.be_born(config, &[(ItemId(20), 10.0)], 3).unwrap();
    keep(&*book, names, &file(Place::Hallway, "level1")).unwrap();
    keep(&*book, names, &file(Place::Hallway, "level2")).unwrap();
    let mind = Minded::<1, 21, 5>::born(MindConfig::DEFAULT, [0.0; 21], 3).unwrap();
    keep(mind.mind(), names, &file(Place::Hallway, "mind")).unwrap();
    for (place, robot) in [
        (Place::Barriers, "forager"),
        (Place::Shuttle, "shuttle"),
        (Place::Cheese, "cheese maze"),
        (Place::TMaze16, "corridor"),
        (Place::Hallway, "hallway"),
    ] {
        for (who, kind) in [("mind", "mind"), ("level1", "agent"), ("level2", "agent")] {
            let seen = inspect(&file(place, who), 30, None).unwrap();
            for word in [&*format!("{kind} of the {robot}"), place.valued()] {
                assert!(seen.contains(word), "{place:?}, {who}, {word}: {seen}");
            }
        }
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 15);
}

#[test]
fn the_brains_of_readme_are_trained_looked_into_and_compared_as_it_says() {
    let folder = tempdir().expect("a folder");
    let readme = include_str!("../../README.md");
    let errands = ["train", "inspect", "diff", "replay", "export"];
    let commands = readme.lines().filter_map(|line| {
        let command = line.strip_prefix("cargo run --release -- ")?;
        let command = command.split('#').next().unwrap_or_default().trim();
        let errand = command.split(' ').next()?;
        errands.contains(&errand).then_some(command)
    });
    let mut done = 0;
    for command in commands {
        let shorter = if command.starts_with("train") {
            " --actions 300"
        } else {
            ""
        };
        let said = said(&folder, &format!("{command}{shorter}"));
        assert!(!said.is_empty(), "{command}");
        done += 1;
    }
    assert!(done >= 6, "{done} commands");
}

#[test]
fn a_difference_names_what_was_learned_lost_and_revalued() {
    let folder = tempdir().expect("a folder");
    said(
        &folder,
        "train --actions 1000 --brain forager-level2 --save a.brain",
    );
    said(
        &folder,
        "train --actions 1000 --load a.brain --save b.brain",
    );
    let same = said(&folder, "diff a.brain a.brain");
    for none in [
        "learned: 0",
        "lost: 0",
        "revalued: 0",
        "items and habits: 0",
    ] {
        assert!(same.contains(none), "{same}");
    }
    let there = said(&folder, "diff a.brain b.brain --most 100000");
    let back = said(&folder, "diff b.brain a.brain --most 100000");
    let rows = |text: &str, part: &str| -> Vec<String> {
        let begins = text.lines().skip_while(|it| !it.starts_with(part));
        let rows = begins.skip(1).take_while(|it| !it.is_empty());
        let mut rows: Vec<String> = rows.map(str::to_owned).collect();
        rows.sort();
        rows
    };
    assert!(rows(&there, "learned:").len() > 10, "{there}");
    // What is learned one way is lost the other way.
    assert_eq!(rows(&there, "learned:"), rows(&back, "lost:"));
    assert_eq!(rows(&there, "lost:"), rows(&back, "learned:"));
    assert!(there.contains("habit forward of s3"), "{there}");
    said(&folder, "train --actions 100 --brain mind --save m.brain");
    let output = run(&folder, "diff a.brain m.brain");
    assert_eq!(output.status.code(), Some(1));
    let sentence = String::from_utf8(output.stderr).unwrap();
    assert!(sentence.contains("nothing to compare"), "{sentence}");
}

#[test]
fn a_file_that_is_no_brain_is_refused_in_a_sentence_and_stays() {
    let folder = tempdir().expect("a folder");
    said(&folder, "train --actions 200 --save a.brain");
    let whole = fs::read(folder.path().join("a.brain")).unwrap();
    let refused = |arguments: &str| {
        let output = run(&folder, arguments);
        assert_eq!(output.status.code(), Some(1), "{output:?}");
        let sentence = String::from_utf8(output.stderr).unwrap();
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
        sentence
    };
    let mut damaged = whole.clone();
    damaged[5000] ^= 4;
    let with = |bytes: &[u8]| fs::write(folder.path().join("b.brain"), bytes).unwrap();
    with(&damaged);
    assert!(refused("inspect b.brain").contains("damaged in its"));
    assert!(refused("train --load b.brain --save b.brain").contains("damaged"));
    assert!(fs::read(folder.path().join("b.brain")).unwrap() == damaged);
    with(&whole[..whole.len() - 1]);
    assert!(refused("inspect b.brain").contains("the end of the image is missing"));
    with(&[&whole[..], &[0]].concat());
    assert!(refused("inspect b.brain").contains("bytes behind the image"));
    with(b"no brain at all, but long enough to have a header: it goes on and on and on and on");
    assert!(refused("inspect b.brain").contains("no image of a brain"));
    assert!(refused("inspect none.brain").contains("cannot read"));
    let output = run(&folder, "train --act never");
    assert_eq!(output.status.code(), Some(2));
}

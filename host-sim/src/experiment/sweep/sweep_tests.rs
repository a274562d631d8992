//! A sweep in one go and in shards, and shards that do not fit together.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::{TempDir, tempdir};

use super::{Axis, Shard, Sweep, SweepOptions, merge};
use crate::experiment::live::LiveOptions;
use crate::experiment::noted::run_noted;
use crate::experiment::record::judged_again;
use crate::progress::Progress;
use crate::report::{Begin, Journal, Output, Results};
use crate::settings::parse;

/// Two points of six lives.
fn sweep(alphas: &str, shard: Option<&str>) -> SweepOptions {
    let grid = vec![Axis::parse(&format!("agent.alpha={alphas}")).unwrap()];
    let given = json!({
        "world": {"name": "lake"},
        "agent": {"name": "q"},
        "damages": ["lost:up"],
        "protocol": {"training": 100, "before": 25, "after": 100},
    });
    let shard = shard.map(|text| Shard::parse(text).unwrap());
    SweepOptions::new((0..6).collect(), &given, grid, shard).unwrap()
}

fn run(options: &SweepOptions, directory: &Path) -> Results {
    let output = Output::prepare(directory).unwrap();
    let begin = if directory.join(Journal::NAME).exists() {
        Begin::Resume
    } else {
        Begin::Fresh
    };
    let journal = Journal::open(&output, begin).unwrap();
    let results = run_noted::<Sweep>(options, &Progress::hidden(), &journal).unwrap();
    results.write(&output).unwrap();
    results
}

/// Makes these shards of four.
fn shards(folder: &TempDir, which: &[u32]) -> Vec<PathBuf> {
    let make = |index: &u32| {
        let options = sweep("0.1,0.2", Some(&format!("{index}/4")));
        let directory = folder.path().join(options.shard.unwrap().directory());
        run(&options, &directory);
        directory
    };
    which.iter().map(make).collect()
}

#[test]
fn shards_are_judged_as_one_process_would_have_to_the_bit() {
    let folder = tempdir().expect("a folder");
    let whole = run(&sweep("0.1,0.2", None), &folder.path().join("one"));
    let below = tempdir().expect("a folder");
    // The last one dies with its last life half written, and goes on.
    let made = shards(&below, &[2, 0, 3, 1]);
    let journal = made[3].join(Journal::NAME);
    let text = fs::read_to_string(&journal).unwrap();
    assert_eq!(text.lines().count(), 4);
    fs::write(&journal, &text[..text.len() - 9]).unwrap();
    let refused = merge(&[below.path().to_owned()]).unwrap_err().to_string();
    assert!(refused.contains("1 of 12 trials are missing") && refused.contains("shard 1/4"));
    run(&sweep("0.1,0.2", Some("1/4")), &made[3]);
    let merged = merge(&[below.path().to_owned()]).unwrap();
    assert_eq!(merged, whole);
    let (one, other) = (folder.path().join("one"), folder.path().join("merged"));
    merged.write(&Output::prepare(&other).unwrap()).unwrap();
    for name in [Sweep::LINES, Output::SUMMARY, Results::PAGE] {
        let read = |folder: &Path| fs::read(folder.join(name)).unwrap();
        assert_eq!(read(&one), read(&other), "{name}");
    }
    let lines = fs::read_to_string(one.join(Sweep::LINES)).unwrap();
    assert_eq!(lines.lines().count(), 12);
    let first: Value = serde_json::from_str(lines.lines().next().unwrap()).unwrap();
    assert_eq!((&first["seed"], &first["point"]), (&json!(0), &json!(0)));
    assert_eq!(first["settings"], json!({"agent.alpha": 0.1}));
    // The directories may be named one by one, in any order, and a whole sweep by itself.
    assert_eq!(merge(&made).unwrap(), whole);
    assert_eq!(merge(&[one]).unwrap(), whole);
    assert_eq!(
        judged_again::<Sweep>(&sweep("0.1,0.2", None))
            .unwrap()
            .summary
            .claims,
        whole.summary.claims
    );
}

#[test]
fn shards_that_do_not_fit_are_refused_with_a_sentence() {
    let folder = tempdir().expect("a folder");
    let made = shards(&folder, &[0, 1, 2, 3]);
    let refused = |directories: &[PathBuf]| {
        let sentence = merge(directories).unwrap_err().to_string();
        assert!(!sentence.contains('\n'), "{sentence}");
        sentence
    };
    // Missing.
    let sentence = refused(&made[..3]);
    assert!(
        sentence.contains("3 of 12 trials are missing, first seed 3 of point 0, which shard 3/4")
    );
    // Twice.
    let twice: Vec<PathBuf> = made.iter().chain(&made[..1]).cloned().collect();
    assert!(refused(&twice).contains("seed 0 of point 0 is there twice"));
    let journal = |directory: &Path| directory.join(Journal::NAME);
    let whole = fs::read_to_string(journal(&made[1])).unwrap();
    let last = whole.lines().last().unwrap();
    fs::write(journal(&made[1]), format!("{whole}{last}\n")).unwrap();
    assert!(refused(&made).contains("is there twice in "));
    // Another build.
    let other = whole.replacen(
        "\"checksum of the program\":\"",
        "\"checksum of the program\":\"0",
        1,
    );
    fs::write(journal(&made[1]), other).unwrap();
    assert!(refused(&made).contains("were made by different builds"));
    let other = whole.replacen("\"version\":\"", "\"version\":\"9.", 1);
    fs::write(journal(&made[1]), other).unwrap();
    assert!(refused(&made).contains("were made by different builds"));
    fs::write(journal(&made[1]), &whole).unwrap();
    // All of them by a build that is not the one that judges.
    let each: Vec<String> = made
        .iter()
        .map(|it| fs::read_to_string(journal(it)).unwrap())
        .collect();
    for (shard, text) in made.iter().zip(&each) {
        let from = "\"checksum of the program\":\"";
        fs::write(journal(shard), text.replacen(from, &format!("{from}0"), 1)).unwrap();
    }
    assert!(refused(&made).contains("made by another build than the one that is to judge"));
    for (shard, text) in made.iter().zip(&each) {
        fs::write(journal(shard), text).unwrap();
    }
    // Another configuration, other seeds, another cut.
    let other = folder.path().join("other");
    run(&sweep("0.1,0.3", Some("1/4")), &other);
    let with = |it: &Path| [&made[..1], &[it.to_owned()], &made[2..]].concat();
    let sentence = refused(&with(&other));
    assert!(
        sentence.contains("different sweeps: grid[0].values[1] was 0.2 and is 0.3"),
        "{sentence}"
    );
    let cut = folder.path().join("cut");
    run(&sweep("0.1,0.2", Some("1/3")), &cut);
    assert!(refused(&with(&cut)).contains("into 4 shards and the other into 3"));
    // No shard at all.
    let none = folder.path().join("none");
    fs::create_dir_all(&none).unwrap();
    assert!(refused(&with(&none)).contains("holds no shard of a sweep"));
    assert!(refused(&[folder.path().join("nowhere")]).contains("cannot read"));
    for (text, words) in [
        ("", "does not say what it is about"),
        ("{\"experiment\":\"forage\"}\n", "is about forage"),
        (
            "{\"experiment\":\"sweep\",\"options\":{\"shard\":7}}\n",
            "holds no shard",
        ),
        (
            &whole.replacen("\"trial\":", "\"trail\":", 1),
            "line 2 of its journal",
        ),
    ] {
        fs::write(journal(&none), text).unwrap();
        let sentence = refused(&with(&none));
        assert!(sentence.contains(words), "{words}: {sentence}");
    }
    // Options that are no longer what they say.
    let changed = whole.replace("\"discount\":0.98", "\"discount\":0.97");
    assert_ne!(changed, whole);
    fs::write(journal(&none), &changed).unwrap();
    assert!(refused(&[none]).contains("not what they were when it was made"));
}

/// The sweep that a file with settings asks for.
fn of_file(text: &str) -> SweepOptions {
    let mut given = parse(text).unwrap();
    let table = given.as_object_mut().unwrap();
    assert_eq!(table.remove("seeds").unwrap(), "0..6");
    let grid = table.remove("grid").unwrap_or_else(|| json!([]));
    let grid: Vec<Axis> = serde_json::from_value(grid).unwrap();
    SweepOptions::new((0..6).collect(), &given, grid, None).unwrap()
}

#[test]
fn a_sweep_is_written_with_all_settings_and_made_again_from_them() {
    let points = |it: &SweepOptions| json!(it)["points"].clone();
    let whole = sweep("0.1,0.2", None);
    let text = whole.file().unwrap();
    assert!(
        text.contains("discount") && !text.contains("\nalpha"),
        "{text}"
    );
    assert_eq!(points(&of_file(&text)), points(&whole));
    // Who is varied by name has settings of its own at each point.
    let grid = ["world.name=lake,keys", "agent.name=q,mind"];
    let grid = grid.map(|it| Axis::parse(it).unwrap()).to_vec();
    let given = json!({"world": {"distractors": 2}, "protocol": {"training": 100}});
    let named = SweepOptions::new((0..6).collect(), &given, grid, None).unwrap();
    assert_eq!(named.points.len(), 4);
    let again = of_file(&named.file().unwrap());
    assert_eq!(points(&again), points(&named));
    assert_eq!(again.points[3].live.world.settings()["distractors"], 2);
}

#[test]
fn settings_of_one_learner_are_not_lived_with_under_the_name_of_another() {
    let forager = LiveOptions::new(vec![1], json!({"agent": {"name": "forager"}})).unwrap();
    let grid = |key: &str| vec![Axis::parse(key).unwrap()];
    for key in ["agent.name=book,forager", "world.name=noise-free,pioneer"] {
        let refused = SweepOptions::new(vec![1], &forager.settings(), grid(key), None);
        let sentence = refused.unwrap_err().to_string();
        assert!(sentence.contains("there are settings of"), "{sentence}");
    }
    // A name alone says nothing that the grid may not change.
    let given = json!({"agent": {"name": "forager"}, "world": {"radius": 8}});
    let sweep = SweepOptions::new(vec![1], &given, grid("agent.name=book,forager"), None).unwrap();
    let own = |name: &str| {
        let given = json!({"agent": {"name": name}, "world": {"radius": 8}});
        json!(LiveOptions::new(vec![1], given).unwrap())
    };
    assert_eq!(json!(sweep.points[0].live), own("book"));
    assert_eq!(json!(sweep.points[1].live), own("forager"));
}

#[test]
fn impossible_sweeps_are_refused_in_one_sentence() {
    for text in [
        "",
        "a",
        "=1",
        "a=",
        "a=1,1",
        "a=0.9,0.90",
        "a=1,1.0",
        "a=nan,1",
    ] {
        let sentence = Axis::parse(text).unwrap_err().to_string();
        assert!(!sentence.contains('\n') && !sentence.is_empty(), "{text}");
    }
    assert_eq!(Axis::parse("a=x, y").unwrap().values, ["x", "y"]);
    assert_eq!(
        Axis::parse("a={b=1,c=2},{b=2,c=2}").unwrap().values.len(),
        2
    );
    for text in ["", "1", "1/1", "2/1", "-1/3", "a/b", "1/0"] {
        assert!(Shard::parse(text).is_err(), "{text}");
    }
    let new = |seeds: u64, axes: &[&str], shard: Option<Shard>| {
        let grid = axes.iter().map(|it| Axis::parse(it).unwrap()).collect();
        let given = json!({"agent": {"name": "q"}});
        let sweep = SweepOptions::new((0..seeds).collect(), &given, grid, shard);
        sweep.map(|_| ()).unwrap_err().to_string()
    };
    assert!(new(1, &["agent.alpha=0.1", "agent.alpha=0.2"], None).contains("twice"));
    assert!(
        new(1, &["agent.alpha=0.1", "agent={name=\"q\"}"], None).contains("is a part of agent")
    );
    // As an `f32` they are one number.
    let grid = vec![Axis::parse("agent.discount=0.9,0.89999999").unwrap()];
    let same = SweepOptions::new(vec![1], &json!({}), grid, None).unwrap_err();
    let said = "points 0 and 1 of the grid are the same lives";
    assert!(same.to_string().contains(said), "{same}");
    assert!(new(1, &["agent.alhpa=0.1"], None).contains("did you mean agent.alpha?"));
    assert!(new(1, &["agent.alpha=0.1,7"], None).contains("TabularConfig::alpha"));
    let shard = Some(Shard { index: 3, of: 4 });
    assert!(new(1, &["agent.alpha=0.1,0.2"], shard).contains("nothing in shard 3/4"));
    let many: Vec<String> = (0..101).map(|it| it.to_string()).collect();
    let many = |key: &str| format!("{key}={}", many.join(","));
    assert!(new(1, &[&many("a"), &many("b")], None).contains("at most"));
}

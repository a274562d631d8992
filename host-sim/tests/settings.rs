//! Settings by file and by name: what is written is taken again, and nothing else is.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::tempdir;

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
    let command = command.args(arguments).current_dir(folder);
    command.output().expect("the program starts")
}

#[test]
fn a_life_is_lived_again_from_the_settings_that_it_has_written() {
    let folder = tempdir().expect("a folder");
    let arguments = "live --agent q --rival random --seeds 3..5 --damage dead:s3 --set agent.alpha=0.2 \
         --set protocol={training=50,before=50,after=100} --set world.distractors=2 --out first";
    let arguments: Vec<&str> = arguments.split_whitespace().collect();
    assert!(run(folder.path(), &arguments).status.success());
    let again = ["live", "--config", "first/settings.toml", "--out", "again"];
    assert!(run(folder.path(), &again).status.success());
    let read = |path: &str| fs::read_to_string(folder.path().join(path)).expect(path);
    assert_eq!(read("again/settings.toml"), read("first/settings.toml"));
    let measured = |path: &str| {
        let mut summary: serde_json::Value = serde_json::from_str(&read(path)).expect(path);
        let summary = summary.as_object_mut().expect("a table");
        summary.retain(|key, _| key != "command" && key != "seal");
        serde_json::to_string(summary).expect("JSON")
    };
    assert_eq!(
        measured("again/summary.json"),
        measured("first/summary.json")
    );
    assert!(read("first/settings.toml").contains("alpha = 0.2"));
}

#[test]
fn another_name_than_that_of_the_file_is_another_life_not_another_label() {
    let folder = tempdir().expect("a folder");
    let short = "protocol={training=25,before=25,after=25}";
    let live = |more: &[&str]| {
        let output = run(
            folder.path(),
            &[&["live", "--set", short][..], more].concat(),
        );
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{more:?}: {sentence}");
    };
    live(&["--agent", "forager", "--out", "forager"]);
    live(&["--agent", "book", "--world", "noise-free", "--out", "book"]);
    let file = ["--config", "forager/settings.toml"];
    let names = ["--set", "agent.name=book", "--set", "world.name=noise-free"];
    live(&[&file[..], &names, &["--out", "set"]].concat());
    let read = |path: &str| fs::read_to_string(folder.path().join(path)).expect(path);
    assert_eq!(read("set/settings.toml"), read("book/settings.toml"));
    assert_ne!(read("set/settings.toml"), read("forager/settings.toml"));
    // On a grid it is refused.
    let grid = ["sweep", "--grid", "agent.name=book,forager"];
    let output = run(folder.path(), &[&grid[..], &file].concat());
    let sentence = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{sentence}");
    assert!(
        sentence.contains("there are settings of \"forager\""),
        "{sentence}"
    );
}

/// What is said beside a file goes before it, and another world begins with its own numbers.
#[test]
fn another_world_than_that_of_the_file_begins_with_its_own_numbers_and_keeps_what_is_set() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str, text: &str| {
        fs::write(folder.path().join(name), text).expect("a file");
    };
    file(
        "noisy.toml",
        "[world]\nname = \"pioneer\"\ndrop_out = 0.3\nstep_noise = 0.2\n",
    );
    file("specimens.layout", "0\n2 0\n0 2\n");
    file("laid.toml", "[world]\nlayout = \"specimens.layout\"\n");
    let short = "--seeds 3 --set protocol.training=1000 --set protocol.test=1";
    let forage = |asked: &str, out: &str| {
        let all = format!("forage {asked} {short} --out {out}");
        run(folder.path(), &all.split(' ').collect::<Vec<_>>())
    };
    let lived = |asked: &str, out: &str| {
        let output = forage(asked, out);
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{asked}: {sentence}");
        fs::read_to_string(folder.path().join(out).join("settings.toml")).expect("it was written")
    };
    let asked = lived("--world noise-free --radius 4", "asked");
    assert!(asked.contains("drop_out = 0.0") && asked.contains("radius = 4.0"));
    for (index, again) in [
        "--world noise-free --set world.radius=4",
        "--config noisy.toml --world noise-free --set world.radius=4",
        "--config noisy.toml --world noise-free --radius 4",
        "--config noisy.toml --set world.radius=4 --set world.name=noise-free",
    ]
    .into_iter()
    .enumerate()
    {
        assert_eq!(lived(again, &format!("again-{index}")), asked, "{again}");
    }
    let kept = lived("--config noisy.toml --world noisy", "kept");
    assert!(kept.contains("drop_out = 0.3") && kept.contains("step_noise = 0.2"));
    let output = forage("--config laid.toml --specimens 5", "laid");
    let sentence = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{sentence}");
    assert!(sentence.contains("--specimens does not go with a layout"));
}

#[test]
fn an_experiment_is_made_again_from_the_settings_that_it_has_written() {
    let folder = tempdir().expect("a folder");
    fs::write(
        folder.path().join("room.toml"),
        "seeds = \"3..4\"\n[world]\nradius = 6.0\n[agent.habits]\nweight = 0.25\n",
    )
    .expect("a file");
    let short = "protocol={training=300,before=1000,after=3000}";
    for (name, arguments, said) in [
        (
            "forage",
            "--config room.toml --set protocol.training=1000 --test-actions 100",
            &[
                "radius = 6.0",
                "weight = 0.25",
                "training = 1000",
                "test = 100",
            ][..],
        ),
        (
            "recover",
            &format!("--seeds 3 --radius 6 --damage dead:s3 --set {short}"),
            &["radius = 6.0", "\"dead:s3\"", "after = 3000"],
        ),
        (
            "one",
            "--seeds 3 --parts lake --set shorter=200 --set agent.discount=0.9",
            &[
                "\"lake\"",
                "shorter = 200",
                "discount = 0.9",
                "long = false",
            ],
        ),
    ] {
        let words = |text: &str| -> Vec<String> { text.split(' ').map(str::to_owned).collect() };
        let (first, again) = (format!("{name}-first"), format!("{name}-again"));
        let run = |arguments: &str, out: &str| {
            let all = words(&format!("{name} {arguments} --out {out}"));
            let all: Vec<&str> = all.iter().map(String::as_str).collect();
            let output = run(folder.path(), &all);
            let sentence = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{all:?}: {sentence}");
        };
        run(arguments, &first);
        run(&format!("--config {first}/settings.toml"), &again);
        let read = |folder_: &str, file: &str| {
            let path = folder.path().join(folder_).join(file);
            fs::read_to_string(path).expect("it was written")
        };
        let settings = read(&first, "settings.toml");
        assert_eq!(read(&again, "settings.toml"), settings, "{name}");
        for word in said {
            assert!(settings.contains(word), "{name}: {word}: {settings}");
        }
        let claims = |of: &str| {
            let summary = read(of, "summary.json");
            let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
            summary["claims"].clone()
        };
        assert_eq!(claims(&again), claims(&first), "{name}");
        // Nothing is concluded of changed settings.
        let all = claims(&first);
        let all = all.as_array().expect("claims");
        assert!(!all.is_empty());
        for claim in all {
            assert_eq!(claim["origin"], "varied", "{name}: {claim}");
        }
    }
    for (arguments, words) in [
        (
            "forage --set agent.gama=0.9",
            "agent has no setting \"gama\"",
        ),
        ("forage --set world.radios=7", "did you mean world.radius?"),
        (
            "forage --set world.distractors=3",
            "the Pioneer's bare room",
        ),
        (
            "forage --set world.name=lake",
            "the Pioneer's bare room, not in lake",
        ),
        (
            "forage --set protocol.tests=3",
            "did you mean protocol.test?",
        ),
        (
            "recover --set agent.discount=0.9",
            "there is no setting \"agent\"",
        ),
        (
            "recover --set protocol.after=0",
            "protocol.after is at least 1",
        ),
        (
            "recover --set protocol.after=100",
            "protocol.after is at least 3000 here, not 100",
        ),
        (
            "one --set agent.discuont=0.9",
            "did you mean agent.discount?",
        ),
        ("one --set agent.discount=1.5", "MindConfig::discount"),
        ("one --set part=lake", "did you mean parts?"),
        ("one --set shorter=0", "shorter is at least 1"),
    ] {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let output = run(folder.path(), &arguments);
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {sentence}");
        assert!(sentence.contains(words), "{arguments:?}: {sentence}");
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
    }
}

/// Worlds for which a rival was tuned, each with numbers of its own.
#[test]
fn a_sweep_is_made_again_from_the_settings_that_it_has_written() {
    let folder = tempdir().expect("a folder");
    let short = "--set protocol={training=50,before=25,after=50}";
    for (name, asked, points) in [
        (
            "worlds",
            "--agent q --grid agent.alpha=0.1,0.2 --grid world.name=lake,keys",
            4,
        ),
        ("rooms", "--agent sarsa --grid world.name=pioneer,lake", 2),
        (
            "learners",
            "--grid agent.name=linear,q,mind --grid world.name=lake,vacuum --set agent.discount=0.9",
            6,
        ),
        (
            "parts",
            "--agent forager --grid agent.escape.after=50,90 --grid agent.escape.burst=3,5",
            4,
        ),
    ] {
        let (first, again) = (format!("{name}-first"), format!("{name}-again"));
        let run = |arguments: &str| {
            let arguments: Vec<&str> = arguments.split_whitespace().collect();
            let output = run(folder.path(), &arguments);
            let sentence = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{arguments:?}: {sentence}");
        };
        run(&format!("sweep {asked} --seeds 3..5 {short} --out {first}"));
        run(&format!(
            "sweep --config {first}/settings.toml --out {again}"
        ));
        let read = |of: &str, file: &str| {
            let path = folder.path().join(of).join(file);
            fs::read_to_string(path).expect("it was written")
        };
        for file in ["settings.toml", "results.jsonl"] {
            assert_eq!(read(&again, file), read(&first, file), "{name}");
        }
        assert_eq!(read(&first, "results.jsonl").lines().count(), 2 * points);
        // With every setting of every point.
        let lived = |of: &str| {
            let summary = read(of, "summary.json");
            let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
            summary["options"]["points"].clone()
        };
        assert_eq!(lived(&first).as_array().map(Vec::len), Some(points));
        assert_eq!(lived(&again), lived(&first), "{name}");
    }
}

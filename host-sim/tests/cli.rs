//! The program as its user meets it: exit codes, sentences, and what is on disk afterwards.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use tempfile::tempdir;

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder can be read");
    let name = |entry: fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
    entries.flatten().map(name).collect()
}

fn program(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
    command.args(arguments).current_dir(folder);
    command.stdin(Stdio::null());
    command
}

fn run(folder: &Path, arguments: &[&str]) -> Output {
    let output = program(folder, arguments).output();
    output.expect("the program starts")
}

#[test]
fn impossible_options_get_one_sentence_and_exit_code_2_and_nothing_is_written() {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("outside.txt"), "9 9\n").expect("a layout");
    fs::write(folder.path().join("malformed.txt"), "1 one\n").expect("a layout");
    fs::write(folder.path().join("under.txt"), "0\n0 0\n").expect("a layout");
    for arguments in [
        &["--colour"][..],
        &["forage", "--layout", "under.txt"],
        &["forage", "--layout", "/dev/zero"],
        &["forage", "--actions", "4000000000"],
        &["forage", "--test-actions", "4000000000"],
        &["recover", "--damage", "camera:0"],
        &["forage", "--seeds", "-1"],
        &["forage", "--force"],
        &["forage", "--force", "--resume", "--out", "here"],
        &["fly"],
        &["forage", "--seeds", "20..10"],
        &["forage", "--seeds", "ten"],
        &["forage", "--specimens", "0"],
        &["forage", "--specimens", "many"],
        &["forage", "--radius", "1", "--specimens", "900"],
        &["forage", "--drop-out", "NaN"],
        &["forage", "--step-noise=-1"],
        &["forage", "--world", "mars"],
        &["forage", "--actions", "0"],
        &["forage", "--layout", "outside.txt"],
        &["forage", "--layout", "malformed.txt"],
        &["forage", "--layout", "none.txt"],
        &["calibrate", "--seeds", "1..2"],
        &["recover", "--damage", "flood"],
        &["one", "--parts", "moon"],
        &["aliased", "--worlds", "moon"],
        &["modules", "--trial", "6"],
        &["neighbours", "--trial", "6"],
        &["live", "--world", "mars"],
        &["live", "--world", "none.POMDP"],
        &["live", "--agent", "sarsaa"],
        &["live", "--set", "agent.discount"],
        &["live", "--set", "agent.discount=1.5"],
        &["live", "--set", "world.radius=nan"],
        &["live", "--config", "none.toml"],
        &["live", "--config", "/dev/zero"],
        &["live", "--rival", "mind"],
        &["sweep", "--grid", "agent.discount=0.9,0.90"],
        &["sweep", "--grid", "agent.name=mind,mind"],
        &["sweep", "--grid", "agent.discount=0.9", "--shard", "0/2"],
        &["live", "--seeds", "5..5"],
        &["one", "--parts", "lake", "--long"],
        &["recover", "--damage", "camera:left"],
        &["recover", "--damage", "dead:s9"],
        &["recover", "--removed"],
        &["forage", "--budget", "60000"],
        &["recover", "--budget", "time=3"],
        &["hil", "--budget", "ram=1,ram=2"],
        &["mcu", "--processor", "z80"],
    ] {
        let output = run(folder.path(), arguments);
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {sentence}");
        assert_eq!(sentence.lines().count(), 1, "{arguments:?}: {sentence}");
        assert!(sentence.starts_with("host-sim: "), "{sentence}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
    assert_eq!(names(folder.path()).len(), 3, "{:?}", names(folder.path()));
}

#[test]
fn a_negative_number_is_answered_alike_with_and_without_an_equals_sign() {
    let folder = tempdir().expect("a folder");
    for (name, value) in [
        ("--radius", "-5"),
        ("--forward", "-0.5"),
        ("--specimens", "-1"),
        ("--drop-out", "-1"),
        ("--seeds", "-1"),
        ("--actions", "-1000"),
    ] {
        let apart = run(folder.path(), &["forage", name, value]);
        let together = run(folder.path(), &["forage", &format!("{name}={value}")]);
        assert_eq!(apart.status.code(), Some(2));
        assert_eq!(apart.stderr, together.stderr);
        let sentence = String::from_utf8_lossy(&apart.stderr);
        assert!(sentence.contains(value), "{name}: {sentence}");
    }
}

#[test]
fn what_experiments_need_is_looked_for_before_anything_runs() {
    let folder = tempdir().expect("a folder");
    for experiment in ["mcu", "hil"] {
        let mut command = program(folder.path(), &[experiment]);
        let command = command.env("PATH", "").env_remove("CARGO");
        let output = command.output().expect("the program starts");
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{sentence}");
        let said =
            format!("host-sim: {experiment} needs cargo, which is missing: https://rustup.rs");
        assert!(sentence.starts_with(&said), "{sentence}");
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
    }
    assert!(names(folder.path()).is_empty());
}

#[cfg(unix)]
#[test]
fn a_path_may_have_any_bytes() {
    use std::os::unix::ffi::OsStrExt;
    let folder = tempdir().expect("a folder");
    let name = std::ffi::OsStr::from_bytes(b"r\xffun");
    let mut command = program(folder.path(), &["calibrate", "--out"]);
    let output = command.arg(name).output().expect("the program starts");
    let sentence = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{sentence}");
    let summary = fs::read_to_string(folder.path().join(name).join("summary.json"));
    let summary = host_sim::report::Summary::from_json(&summary.expect("a claims file"));
    assert_eq!(
        summary.expect("a summary").command,
        "host-sim calibrate --out r\u{fffd}un"
    );
}

#[test]
fn a_run_that_cannot_write_says_so_before_it_trains() {
    let folder = tempdir().expect("a folder");
    fs::write(folder.path().join("taken"), "a file").expect("a file");
    let started = std::time::Instant::now();
    let output = run(
        folder.path(),
        &["forage", "--seeds", "0..1000", "--out", "taken"],
    );
    let sentence = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{sentence}");
    assert!(sentence.contains("cannot write to taken"), "{sentence}");
    assert!(started.elapsed() < Duration::from_secs(5));
}

#[test]
fn an_interrupted_run_leaves_whole_files_or_none() {
    let folder = tempdir().expect("a folder");
    let mut child = program(
        folder.path(),
        &["forage", "--seeds", "0..1000", "--out", "here"],
    )
    .stdout(Stdio::null())
    .stderr(Stdio::null())
    .spawn()
    .expect("the program starts");
    // A thousand worlds are looked at before the folder is made.
    for _ in 0..600 {
        if folder.path().join("here").is_dir() {
            break;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    std::thread::sleep(Duration::from_millis(200));
    assert_eq!(
        child.try_wait().expect("it can be asked"),
        None,
        "it trains"
    );
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    let left = fs::read_dir(folder.path().join("here")).expect("it was prepared");
    // The journal has whole lines, and one that was cut off is no line.
    let names = left.flatten().map(|it| it.file_name());
    assert!(names.into_iter().all(|name| name == "trials.jsonl"));
}

#[test]
fn calibrate_writes_its_claims_and_pictures_and_shows_them() {
    let folder = tempdir().expect("a folder");
    let output = run(folder.path(), &["calibrate", "--table", "--out", "here"]);
    assert!(output.status.success());
    let out = String::from_utf8_lossy(&output.stdout);
    assert!(out.contains("calibrate.actions.R5_f0_5"));
    assert!(out.contains("24 claims: "), "{out}");
    let here = folder.path().join("here");
    let summary = fs::read_to_string(here.join("summary.json")).expect("a claims file");
    let summary = host_sim::report::Summary::from_json(&summary).expect("a summary");
    assert_eq!(summary.command, "host-sim calibrate --out here");
    assert!(summary.find("calibrate.p_s3.R3_f0_1").is_some());
    for name in [
        "actions.svg",
        "actions.png",
        "p-s3.svg",
        "p-s3.png",
        "report.html",
    ] {
        assert!(here.join(name).is_file(), "{name}");
    }
    let about = fs::read_to_string(here.join("run.json")).expect("it is told how it was made");
    let about: serde_json::Value = serde_json::from_str(&about).expect("JSON");
    assert_eq!(about["command"], summary.command);
    assert_eq!(about["commit"].as_str(), summary.commit.as_deref());
    let options = summary.options.expect("it says what it was given");
    assert_eq!(options["conditions"][0]["driver"], "Sector");
    assert_eq!(about["host"]["architecture"], std::env::consts::ARCH);
    assert!(about["seconds"].as_f64().is_some_and(|it| it > 0.0));
    // Without a terminal there is no progress bar.
    assert!(output.stderr.is_empty());
}

#[test]
fn a_run_that_exceeds_its_budget_says_so_and_ends_with_exit_code_1() {
    let folder = tempdir().expect("a folder");
    let forage = |budget: &str| {
        let arguments = [
            "forage",
            "--seeds",
            "3",
            "--actions",
            "1000",
            "--test-actions",
            "100",
            "--out",
            "here",
            "--force",
            "--budget",
            budget,
        ];
        let output = run(folder.path(), &arguments);
        let [out, err] = [&output.stdout, &output.stderr]
            .map(|stream| String::from_utf8_lossy(stream).into_owned());
        (output.status.code(), out, err)
    };
    // Too large before anything is trained, and nothing is written.
    let (code, out, sentence) = forage("ram=128KiB");
    assert_eq!((code, out.as_str()), (Some(1), ""), "{sentence}");
    assert!(
        sentence.contains("more than ram=131072 allows"),
        "{sentence}"
    );
    assert!(!folder.path().join("here/summary.json").exists());
    // Too slow is known at the end: the results are there, and the run has failed.
    let (code, out, sentence) = forage("instructions=20k");
    assert_eq!(code, Some(1), "{sentence}");
    assert_eq!(sentence.lines().count(), 1, "{sentence}");
    let start = "host-sim: over budget: the worst tick takes ";
    assert!(sentence.starts_with(start), "{sentence}");
    assert!(
        out.contains("instructions of 20,000 (Cortex-M4F, estimated"),
        "{out}"
    );
    assert!(folder.path().join("here/summary.json").is_file());
    let (code, out, _) = forage("instructions=1000k,ram=264KiB");
    assert_eq!(code, Some(0));
    // A life of one seed has no verdicts, and ends in a few lines that say how to get them.
    assert!(out.lines().count() <= 10, "{out}");
    assert!(!out.contains("n too small"), "{out}");
    assert!(out.contains("captures in a test: level 1 "), "{out}");
    assert!(
        out.ends_with("everything is in here/report.html\n"),
        "{out}"
    );
    assert!(
        out.contains("instructions of 1,000,000") && out.contains("of 264 KiB"),
        "{out}"
    );
}

#[cfg(unix)]
#[test]
fn a_pipe_is_no_file_and_nobody_waits_for_its_end() {
    let folder = tempdir().expect("a folder");
    for name in ["pipe.toml", "pipe.mcap", "pipe.brain", "pipe.POMDP"] {
        let made = Command::new("mkfifo")
            .arg(folder.path().join(name))
            .status();
        assert!(made.expect("there is mkfifo").success());
    }
    for (arguments, code) in [
        (&["live", "--config", "pipe.toml"][..], 2),
        (&["live", "--world", "pipe.POMDP"], 2),
        (&["forage", "--layout", "pipe.toml"], 2),
        (&["replay", "pipe.mcap"], 1),
        (&["inspect", "pipe.brain"], 1),
        (&["train", "--load", "pipe.brain"], 1),
        (&["train", "--actions", "1", "--save", "pipe.brain"], 1),
    ] {
        let mut child = program(folder.path(), arguments)
            .stderr(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .expect("the program starts");
        let begun = std::time::Instant::now();
        while child.try_wait().expect("it can be asked").is_none() {
            if begun.elapsed() > Duration::from_secs(60) {
                child.kill().expect("it can be killed");
                panic!("{arguments:?} waits for ever");
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        let output = child.wait_with_output().expect("it has ended");
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert_eq!(
            output.status.code(),
            Some(code),
            "{arguments:?}: {sentence}"
        );
        assert!(sentence.contains("it is no file"), "{sentence}");
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
    }
    assert_eq!(names(folder.path()).len(), 4, "{:?}", names(folder.path()));
}

#[test]
fn a_world_that_is_written_wrong_is_refused_with_its_place() {
    let folder = tempdir().expect("a folder");
    let shuttle = include_str!("../data/pomdp/shuttle_95.POMDP");
    let spoiled = shuttle.replacen("0.0 0.4 0.3 0.0 0.3", "0.0 0.4 0.3 0.0 0.4", 1);
    fs::write(folder.path().join("sum.POMDP"), &spoiled).expect("a file");
    fs::write(
        folder.path().join("half.toml"),
        "[agent]\nname = \"q\"\nalpha = 0..1\n",
    )
    .expect("a file");
    fs::write(
        folder.path().join("name.toml"),
        "[agent]\nname = \"q\"\nalhpa = 0.1\n",
    )
    .expect("a file");
    let line = spoiled
        .lines()
        .position(|it| it.contains("0.3 0.0 0.4"))
        .expect("it is there")
        + 1;
    for (arguments, words) in [
        (
            ["live", "--world", "sum.POMDP"],
            format!("sum.POMDP, line {line}, column 1: "),
        ),
        (
            ["live", "--config", "half.toml"],
            "half.toml, line 3, column 11: ".to_owned(),
        ),
        (
            ["live", "--config", "name.toml"],
            "did you mean agent.alpha?".to_owned(),
        ),
    ] {
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2));
        let sentence = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(sentence.contains(&words), "{words}: {sentence}");
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
    }
}

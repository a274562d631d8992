//! Runs that are killed, meet each other or a full disk, and lose nothing.
//!
//! `tests/run kills` kills a hundred times.

#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use cla_core::num::Rng;
use host_sim::report::Summary;
use tempfile::TempDir;

/// A folder of this test's own, removed at its end.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn read(&self, name: &str) -> String {
        let path = self.0.path().join(name);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// The trials that a run has noted in full.
    fn trials(&self, directory: &str) -> usize {
        let journal = fs::read(self.0.path().join(directory).join("trials.jsonl"));
        let lines = journal.unwrap_or_default();
        let lines = lines.iter().filter(|&&byte| byte == b'\n').count();
        lines.saturating_sub(1)
    }
}

/// Short lives; the seeds say how many.
fn forage(folder: &Path, seeds: &str, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
    command.args(["forage", "--actions", "1000", "--test-actions", "100"]);
    command.args(["--seeds", seeds]).args(more);
    command.current_dir(folder).stdin(Stdio::null());
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn run(folder: &Path, seeds: &str, more: &[&str]) -> Output {
    let output = forage(folder, seeds, more).output();
    output.expect("the program starts")
}

fn start(folder: &Path, seeds: &str, more: &[&str]) -> Child {
    let child = forage(folder, seeds, more).spawn();
    child.expect("the program starts")
}

fn sentence(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn terminate(child: &Child) {
    let kill = Command::new("kill")
        .args(["-TERM", &child.id().to_string()])
        .status();
    assert!(kill.expect("there is kill").success());
}

/// Waits until a run has noted so many trials.
fn wait_for(folder: &Folder, directory: &str, trials: usize) {
    let begun = Instant::now();
    while folder.trials(directory) < trials {
        assert!(
            begun.elapsed() < Duration::from_secs(120),
            "nothing is noted"
        );
        sleep(Duration::from_millis(5));
    }
}

#[test]
fn a_run_that_was_killed_again_and_again_ends_as_one_that_was_left_alone() {
    let kills = std::env::var("KILLS").map_or(6, |it| it.parse().expect("a number"));
    let (left_alone, killed) = (Folder::new(), Folder::new());
    let begun = Instant::now();
    assert!(
        run(left_alone.0.path(), "0..4", &["--out", "here"])
            .status
            .success()
    );
    let whole = begun.elapsed().as_millis() as u32;
    let mut rng = Rng::new(12);
    let (mut dealt, mut rounds, mut gone_on) = (0, 0, 0);
    while dealt < kills {
        let journal = killed.0.path().join("here/trials.jsonl");
        let begin: &[&str] = if journal.exists() {
            gone_on += usize::from(killed.trials("here") > 0);
            &["--out", "here", "--resume"]
        } else {
            &["--out", "here"]
        };
        let mut child = start(killed.0.path(), "0..4", begin);
        sleep(Duration::from_millis(u64::from(rng.below(whole))));
        if rng.below(2) == 0 {
            child.kill().expect("it can be killed");
        } else {
            terminate(&child);
        }
        let ended = child.wait().expect("it ends");
        dealt += usize::from(!ended.success());
        if ended.success() || killed.trials("here") == 4 {
            // All is done: what it says is compared, and another run is begun.
            let last = run(killed.0.path(), "0..4", &["--out", "here", "--resume"]);
            assert!(last.status.success(), "{}", sentence(&last));
            compare(&left_alone, &killed);
            fs::remove_dir_all(killed.0.path().join("here")).expect("it can be removed");
            rounds += 1;
        }
    }
    let begin: &[&str] = if killed.0.path().join("here/trials.jsonl").exists() {
        &["--out", "here", "--resume"]
    } else {
        &["--out", "here"]
    };
    let last = run(killed.0.path(), "0..4", begin);
    assert!(last.status.success(), "{}", sentence(&last));
    compare(&left_alone, &killed);
    println!(
        "{dealt} kills, {} runs ended, {gone_on} went on with trials",
        rounds + 1
    );
}

/// Every file is the same to the byte but the journal, whose trials may stand in another order, and
/// what tells of the time.
fn compare(left_alone: &Folder, killed: &Folder) {
    let entries = fs::read_dir(left_alone.0.path().join("here")).expect("it was written");
    let mut compared = 0;
    for entry in entries.flatten() {
        let name = entry.file_name();
        if name != "trials.jsonl" && name != "run.json" {
            let ours = fs::read(entry.path()).expect("it can be read");
            let other = fs::read(killed.0.path().join("here").join(&name)).expect("it was written");
            assert!(ours == other, "{} differs", name.display());
            compared += 1;
        }
    }
    assert!(compared > 1);
    let sorted = |folder: &Folder| {
        let text = folder.read("here/trials.jsonl");
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.sort();
        lines
    };
    assert_eq!(sorted(left_alone), sorted(killed));
}

#[test]
fn a_run_that_is_asked_to_end_says_what_it_has_and_goes_on_another_day() {
    let folder = Folder::new();
    let mut child = start(folder.0.path(), "0..200", &["--out", "here"]);
    wait_for(&folder, "here", 2);
    assert_eq!(child.try_wait().expect("it can be asked"), None);
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(143), "{}", sentence(&output));
    let done = folder.trials("here");
    let says = format!("{done} of 200 trials");
    assert_eq!(
        sentence(&output),
        format!(
            "host-sim: interrupted: the summary is of {says}; \
             the same command with --resume --out here goes on\n"
        )
    );
    let summary = Summary::from_json(&folder.read("here/summary.json")).expect("a summary");
    assert_eq!(summary.seeds.len(), done);
    assert_eq!(summary.parameters["unfinished"], says);
    // Only the same run goes on.
    for (seeds, more, why) in [
        ("0..3", &[][..], "options.seeds had 200 entries and has 3"),
        (
            "0..200",
            &["--radius", "6"],
            "options.world.config.radius was 5.0 and is 6.0",
        ),
    ] {
        let other = run(
            folder.0.path(),
            seeds,
            &[&["--out", "here", "--resume"], more].concat(),
        );
        assert_eq!(other.status.code(), Some(1));
        assert_eq!(
            sentence(&other),
            format!("host-sim: cannot resume: {why}\n")
        );
    }
    assert_eq!(folder.trials("here"), done);
    let child = start(folder.0.path(), "0..200", &["--out", "here", "--resume"]);
    wait_for(&folder, "here", done + 1);
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(143), "{}", sentence(&output));
}

#[test]
fn a_shard_that_is_asked_to_end_goes_on_by_the_same_command() {
    let folder = Folder::new();
    let sweep = |after: u32| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
        command.args(["sweep", "--agent", "q", "--grid", "agent.alpha=0.1,0.2"]);
        command.args(["--seeds", "0..4", "--shard", "1/2", "--out", "here"]);
        let protocol = format!("protocol={{training=40000,before=100,after={after}}}");
        command.args(["--set", &protocol]);
        command.current_dir(folder.0.path()).stdin(Stdio::null());
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    };
    let below = "here/shard-1-of-2";
    let child = sweep(100).spawn().expect("the program starts");
    wait_for(&folder, below, 1);
    terminate(&child);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(143), "{}", sentence(&output));
    let done = folder.trials(below);
    let said =
        format!("host-sim: interrupted after {done} of 4 trials; the same command goes on\n");
    assert_eq!(sentence(&output), said);
    assert!(!folder.0.path().join(below).join("summary.json").exists());
    // Another sweep does not go on there.
    let other = sweep(125).output().expect("the program starts");
    assert_eq!(other.status.code(), Some(1), "{}", sentence(&other));
    assert!(sentence(&other).contains("cannot resume: "));
    assert_eq!(folder.trials(below), done);
    let output = sweep(100).output().expect("the program starts");
    assert!(output.status.success(), "{}", sentence(&output));
    assert_eq!(folder.trials(below), 4);
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("shard 1/2 is made"), "{said}");
    assert!(folder.0.path().join(below).join("settings.toml").is_file());
}

#[test]
fn of_two_runs_into_one_folder_one_is_refused_and_none_harmed() {
    let folder = Folder::new();
    let first = start(folder.0.path(), "0..4", &["--out", "here"]);
    wait_for(&folder, "here", 1);
    for more in [&[][..], &["--force"], &["--resume"]] {
        let second = run(
            folder.0.path(),
            "0..4",
            &[&["--out", "here"], more].concat(),
        );
        assert_eq!(second.status.code(), Some(1), "{more:?}");
        assert_eq!(
            sentence(&second),
            "host-sim: another run is writing to here\n",
            "{more:?}"
        );
    }
    let first = first.wait_with_output().expect("it ends");
    assert!(first.status.success(), "{}", sentence(&first));
    assert_eq!(folder.trials("here"), 4);
    // Afterwards it is not overwritten by chance, and on demand it is.
    let summary = folder.read("here/summary.json");
    let again = run(folder.0.path(), "0..1", &["--out", "here"]);
    assert_eq!(again.status.code(), Some(1));
    assert!(
        sentence(&again).contains("--force replaces it"),
        "{}",
        sentence(&again)
    );
    assert_eq!(folder.read("here/summary.json"), summary);
    assert!(
        run(folder.0.path(), "0..1", &["--out", "here", "--force"])
            .status
            .success()
    );
    assert_eq!(folder.trials("here"), 1);
}

#[test]
fn runs_without_a_directory_have_one_each_and_latest_leads_to_the_last() {
    let folder = Folder::new();
    assert!(run(folder.0.path(), "0", &[]).status.success());
    assert!(run(folder.0.path(), "1", &[]).status.success());
    let runs = fs::read_dir(folder.0.path().join("runs/forage")).expect("it is there");
    let directories: Vec<_> = runs
        .flatten()
        .filter(|it| it.file_type().is_ok_and(|it| it.is_dir()))
        .collect();
    assert_eq!(directories.len(), 2);
    let latest = folder.read("runs/forage/latest/summary.json");
    assert_eq!(Summary::from_json(&latest).expect("a summary").seeds, [1]);
    // The latest is gone on with, though there is nothing left to do.
    assert!(run(folder.0.path(), "1", &["--resume"]).status.success());
    assert_eq!(folder.read("runs/forage/latest/summary.json"), latest);
    let none = run(&folder.0.path().join("runs"), "1", &["--resume"]);
    assert!(sentence(&none).contains("there is no run to resume"));
}

#[test]
fn a_full_disk_stops_a_run_that_goes_on_when_there_is_room() {
    let (left_alone, full) = (Folder::new(), Folder::new());
    assert!(
        run(left_alone.0.path(), "0..3", &["--out", "here"])
            .status
            .success()
    );
    let journal = left_alone.read("here/trials.jsonl").len();
    let command = forage(full.0.path(), "0..3", &["--out", "here"]);
    let words = command.get_args().map(|it| it.to_str().expect("text"));
    let words: Vec<&str> = words.collect();
    // Files may have no more than half of what the journal needs.
    let script = format!(
        "trap '' XFSZ; ulimit -f {}; exec {} {}",
        journal / 1024 / 2,
        env!("CARGO_BIN_EXE_host-sim"),
        words.join(" ")
    );
    let output = Command::new("bash")
        .args(["-c", &script])
        .current_dir(full.0.path())
        .output();
    let output = output.expect("there is bash");
    assert_eq!(output.status.code(), Some(1));
    let why = sentence(&output);
    assert!(
        why.starts_with("host-sim: cannot write to here/trials.jsonl: "),
        "{why}"
    );
    let text = full.read("here/trials.jsonl");
    assert!(
        text.ends_with('\n') && full.trials("here") < 3,
        "{}",
        text.len()
    );
    let output = run(full.0.path(), "0..3", &["--out", "here", "--resume"]);
    assert!(output.status.success(), "{}", sentence(&output));
    compare(&left_alone, &full);
}

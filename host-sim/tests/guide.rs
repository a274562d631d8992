//! The chapter of the guide on sweeps: its commands run, one after the other, and do what it says.

use std::fs;
use std::path::Path;
use std::process::Command;

use tempfile::tempdir;

#[test]
fn the_commands_of_the_chapter_on_sweeps_do_what_it_says() {
    let chapter = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide/src/cluster.md");
    let text = fs::read_to_string(chapter).expect("the chapter can be read");
    let blocks = text.split("```sh\n").skip(1);
    let commands: Vec<&str> = blocks
        .filter_map(|block| block.split("```").next())
        .flat_map(str::lines)
        .collect();
    assert!(commands.len() >= 5, "{commands:?}");
    let folder = tempdir().expect("a folder");
    for command in commands {
        let (program, arguments) = command.split_once(' ').expect("a command with arguments");
        let program = match program {
            "host-sim" => env!("CARGO_BIN_EXE_host-sim"),
            other => other,
        };
        let ran = Command::new(program)
            .args(arguments.split_whitespace())
            .current_dir(folder.path())
            .output()
            .expect("the program starts");
        assert!(ran.status.success(), "{command}: {ran:?}");
    }
    let results =
        fs::read_to_string(folder.path().join("merged/results.jsonl")).expect("they are merged");
    assert_eq!(results.lines().count(), 4);
}

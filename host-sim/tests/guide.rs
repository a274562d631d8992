//! The chapter of the guide on sweeps: its commands run, one after the other, and do what it says.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A folder of this test's own, removed at its end.
struct Folder(PathBuf);

impl Drop for Folder {
    fn drop(&mut self) {
        // What the system cannot remove now it removes with its temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

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
    let folder = Folder(std::env::temp_dir().join(format!("guide-{}", std::process::id())));
    fs::create_dir_all(&folder.0).expect("a folder");
    for command in commands {
        let (program, arguments) = command.split_once(' ').expect("a command with arguments");
        let program = match program {
            "host-sim" => env!("CARGO_BIN_EXE_host-sim"),
            other => other,
        };
        let ran = Command::new(program)
            .args(arguments.split_whitespace())
            .current_dir(&folder.0)
            .output()
            .expect("the program starts");
        assert!(ran.status.success(), "{command}: {ran:?}");
    }
    let results =
        fs::read_to_string(folder.0.join("merged/results.jsonl")).expect("they are merged");
    assert_eq!(results.lines().count(), 4);
}

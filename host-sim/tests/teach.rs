//! A recorded log teaches the learner: what is foretold of the rest, and what cannot be read.

// Its `main` is the example's own.
#[allow(dead_code)]
#[path = "../examples/ranges.rs"]
mod ranges;

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

use cla_core::snapshot::{Names, check};
use host_sim::teaching::{Log, Mapping, Pupil, share, teach};
use tempfile::TempDir;

/// A folder of this test's own, removed at its end.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.path().join(name);
        fs::write(&path, text).unwrap();
        path
    }

    fn mapping(&self, text: &str) -> Mapping {
        Mapping::read(&self.write("mapping.toml", text)).unwrap()
    }

    fn run(&self, arguments: &str) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_host-sim"));
        let command = command
            .args(arguments.split(' '))
            .current_dir(self.0.path());
        command.output().unwrap()
    }
}

#[test]
fn what_24_ranges_will_be_is_foretold_better_than_that_nothing_changes() {
    let folder = Folder::new();
    let mapping = folder.mapping(&ranges::mapping());
    let log = Log::parse(ranges::log(5000, 7).as_bytes(), &mapping).unwrap();
    assert_eq!((log.items.len(), log.actions.len()), (36, 4));
    assert_eq!((log.rows, log.steps.len()), (5000, 4999));
    let lesson = teach(&log, 0.75, 1).unwrap();
    assert_eq!((lesson.taught, lesson.held_out), (3749, 1250));
    let [learner, all, unchanged, frequent] = lesson.scores.map(|(_, score)| score);
    println!("{:?}", lesson.scores);
    // All are asked the same.
    assert_eq!(learner.items[0], 36 * 1250);
    assert_eq!(learner.items[0], frequent.items[0]);
    assert!(learner.changed[0] > 2000 && learner.changed[0] == unchanged.changed[0]);
    assert_eq!((unchanged.changed[1], unchanged.foretold), (0, [0, 0]));
    assert_eq!(
        unchanged.items[1],
        unchanged.items[0] - unchanged.changed[0]
    );
    // All schemas together foretell more changes, and more that do not come.
    assert!(share(all.changed) > share(learner.changed), "{all:?}");
    assert!(share(all.foretold) < share(learner.foretold), "{all:?}");
    // Changes are foretold, and more of them come than do not.
    assert!(share(learner.changed) > 0.3, "{learner:?}");
    assert!(share(learner.foretold) > 0.5, "{learner:?}");
    for other in [unchanged, frequent] {
        assert!(learner.items[1] > other.items[1], "{learner:?} {other:?}");
        assert!(share(learner.changed) > share(other.changed), "{other:?}");
        assert!(learner.percepts[1] > other.percepts[1], "{other:?}");
    }
}

#[test]
fn a_log_whose_actions_say_nothing_of_what_comes_teaches_nothing() {
    let folder = Folder::new();
    let mapping = folder.mapping(
        "[action]\ncolumn = \"act\"\nnames = [\"a\", \"b\"]\n[[item]]\ncolumn = \"x\"\nabove = 0.5\n",
    );
    let mut rng = cla_core::num::Rng::new(3);
    let mut text = "x,act\n".to_owned();
    for _ in 0..4000 {
        let (reading, act) = (rng.below(2), ["a", "b"][rng.below(2) as usize]);
        text.push_str(&format!("{reading},{act}\n"));
    }
    let log = Log::parse(text.as_bytes(), &mapping).unwrap();
    let [learner, ..] = teach(&log, 0.75, 1).unwrap().scores;
    let right = share(learner.1.items);
    assert!((0.45..0.55).contains(&right), "{right}");
}

#[test]
fn a_brain_is_taught_kept_and_shown_by_the_program() {
    let folder = Folder::new();
    folder.write("ranges.csv", &ranges::log(1200, 3));
    folder.write("ranges.toml", &ranges::mapping());
    let teach = "teach --log ranges.csv --mapping ranges.toml --page a.html --save";
    let said = |name: &str| {
        let output = folder.run(&format!("{teach} {name}"));
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let first = said("a.brain");
    let begins = "1200 rows, 36 items, 4 actions: 899 steps taught, 300 held out";
    assert!(first.starts_with(begins), "{first}");
    for who in ["the learner", "nothing changes", "the most frequent result"] {
        assert!(first.contains(who), "{first}");
    }
    assert_eq!(said("b.brain"), first.replace("a.brain", "b.brain"));
    let read = |name: &str| fs::read(folder.0.path().join(name)).unwrap();
    let image = read("a.brain");
    assert!(image == read("b.brain"));
    let mapping = Mapping::read(&folder.0.path().join("ranges.toml")).unwrap();
    let items = mapping.names();
    let items: Vec<&str> = items.iter().map(String::as_str).collect();
    let actions: Vec<&str> = mapping.action.names.iter().map(String::as_str).collect();
    let names = Names::of(&items, &actions);
    assert_eq!(
        check::<Pupil, _>(names, &mut &*image).unwrap() as usize,
        image.len()
    );
    let page = String::from_utf8(read("a.html")).unwrap();
    assert!(page.contains("near0") && page.contains("nothing changes"));
}

const MAPPING: &str = "unknown = [\"?\"]\nepisode = \"run\"\n\
    [action]\ncolumn = \"act\"\nnames = [\"go\", \"stay\"]\n\
    [[item]]\ncolumn = \"range\"\nname = \"near\"\nbelow = 1.0\nband = 0.1\n\
    [[item]]\ncolumn = \"range\"\nbins = [1.0, 2.0]\n\
    [[item]]\ncolumn = \"mode\"\ncategories = [\"day\", \"night\"]\n";

#[test]
fn columns_become_items_by_thresholds_bins_and_categories() {
    let folder = Folder::new();
    let mapping = folder.mapping(MAPPING);
    let log = "range,mode,run,act\n0.8,day,1,go\n1.05,night,1,stay\n?,day,1,go\n2.5,day,2,go\n1.05,day,2,go\n";
    let log = Log::parse(log.as_bytes(), &mapping).unwrap();
    let names = [
        "near",
        "range_0",
        "range_1",
        "range_2",
        "mode_day",
        "mode_night",
    ];
    assert_eq!(log.items, names);
    assert_eq!((log.rows, log.steps.len()), (5, 3));
    let states = |percept: &host_sim::teaching::Percept| -> Vec<Option<bool>> {
        let items = (0..6).map(cla_core::word::ItemId);
        items.map(|item| percept.get(item)).collect()
    };
    let on = |bits: &str| -> Vec<Option<bool>> {
        let state = |it| match it {
            '?' => None,
            it => Some(it == '1'),
        };
        bits.chars().map(state).collect()
    };
    let steps = &log.steps;
    assert_eq!(states(&steps[0].before), on("110010"));
    // Within the band it stays near, and the bin is another one; what is missing is unknown.
    assert_eq!(states(&steps[0].after), on("101001"));
    assert_eq!(states(&steps[1].after), on("????10"));
    // Another episode: nothing leads there, and the band forgets.
    assert_eq!(states(&steps[2].before), on("000110"));
    assert_eq!(states(&steps[2].after), on("001010"));
    assert_eq!([0, 1, 2].map(|it| steps[it].begins), [true, false, true]);
    assert_eq!([0, 1, 2].map(|it| steps[it].action.0), [0, 1, 0]);
}

#[test]
fn a_log_without_names_has_numbers_for_its_columns() {
    let folder = Folder::new();
    let mapping = folder.mapping(
        "header = false\nseparator = \";\"\n[action]\ncolumn = \"2\"\nnames = [\"a\"]\n\
         [[item]]\ncolumn = \"1\"\nabove = 0\n",
    );
    let log = Log::parse(b"1;a\n-1;a\n2;a", &mapping).unwrap();
    assert_eq!(
        (log.rows, log.steps.len(), log.items[0].as_str()),
        (3, 2, "1")
    );
}

#[test]
fn what_is_wrong_in_a_log_is_named_with_line_and_column() {
    let folder = Folder::new();
    let mapping = folder.mapping(MAPPING);
    let whole = "range,mode,run,act\n0.8,day,1,go\n1.05,night,1,stay\n";
    assert!(Log::parse(whole.as_bytes(), &mapping).is_ok());
    for (from, to, words) in [
        ("1.05", "NaN", "line 3, column range: \"NaN\" is no number"),
        ("1.05", "far", "line 3, column range: \"far\" is no number"),
        ("1.05", "", "line 3, column range: the reading is missing"),
        (
            "night",
            "dusk",
            "line 3, column mode: \"dusk\" is none of day, night",
        ),
        (
            "stay",
            "fly",
            "line 3, column act: there is no action \"fly\": there are go, stay",
        ),
        ("night,", "", "line 3 has 3 fields, and there are 4 columns"),
        (
            "stay",
            "stay,1",
            "line 3 has 5 fields, and there are 4 columns",
        ),
        (
            "mode,",
            "mood,",
            "line 1: there is no column mode: there are range, mood",
        ),
        ("mode,", "range,", "line 1: there are two columns range"),
        (whole, "", "the log is empty"),
    ] {
        let why = Log::parse(whole.replace(from, to).as_bytes(), &mapping).unwrap_err();
        assert!(why.contains(words), "{words}: {why}");
        assert!(!why.contains('\n'), "{why}");
    }
    let why = Log::parse(b"range,mode,run,act\n0.8,\xff,1,go\n", &mapping).unwrap_err();
    assert!(why.contains("line 2"), "{why}");
    for (from, to, words) in [
        (
            "below = 1.0",
            "below = 1.0\nabove = 2.0",
            "column range: it takes one of above",
        ),
        ("bins = [1.0, 2.0]", "bins = [2.0, 1.0]", "its edges rise"),
        ("bins = [1.0, 2.0]", "bins = []", "1 to 32 edges"),
        ("band = 0.1", "band = -1", "its band is a number from 0 on"),
        ("band", "bond", "unknown field `bond`"),
        (
            "column = \"mode\"\n",
            "column = \"mode\"\nband = 0.1\n",
            "column mode: categories have no band",
        ),
        (
            "column = \"mode\"\n",
            "column = \"mode\"\ndebounced = 3\n",
            "column mode: categories have no band, and are not debounced",
        ),
        (
            "episode = ",
            "separator = '\"'\nepisode = ",
            "'\"' cannot separate fields",
        ),
        (
            "episode = ",
            "separator = \"\\n\"\nepisode = ",
            "'\\n' cannot separate fields",
        ),
        (
            "names = [\"go\", \"stay\"]",
            "names = [\"go\", \"go\"]",
            "\"go\" is named twice",
        ),
        (
            "name = \"near\"",
            "name = \"range_1\"",
            "two items are called range_1",
        ),
        ("[action]", "[[action]]", "action"),
        ("below = 1.0", "below = 0..1", "line "),
    ] {
        let path = folder.write("wrong.toml", &MAPPING.replace(from, to));
        let why = Mapping::read(&path).unwrap_err().to_string();
        assert!(
            why.contains(words) && why.contains("wrong.toml"),
            "{words}: {why}"
        );
        assert!(!why.contains('\n'), "{why}");
    }
    folder.write("mapping.toml", MAPPING);
    folder.write("a.csv", whole);
    for arguments in [
        "teach --log none.csv --mapping mapping.toml",
        "teach --log a.csv --mapping none.toml",
        "teach --log a.csv --mapping mapping.toml --taught 1",
        "teach --log a.csv --mapping mapping.toml --taught 0.1",
        "teach --log /dev/zero --mapping mapping.toml",
    ] {
        let output = folder.run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments}: {output:?}");
        let sentence = String::from_utf8(output.stderr).unwrap();
        assert_eq!(sentence.lines().count(), 1, "{sentence}");
    }
}

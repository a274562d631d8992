//! A life that is logged, read back in both forms, and spoilt.

use super::{Life, Step, complete, film, lines, mcap, steps, windows};
use crate::experiment::recover::film::Film;

/// Three thousand actions with captures, a doubt, specimens that move, and what the last has led to.
fn shot() -> Film {
    let frames = 0..3001_usize;
    Film {
        poses: frames
            .clone()
            .map(|it| [0.001 * it as f64, -0.5, 12.5])
            .collect(),
        on: frames.clone().map(|it| (it % 128) as u32).collect(),
        actions: frames.clone().map(|it| it % 6).collect(),
        values: frames.clone().map(|it| it as f64 / 7.0).collect(),
        captures: frames.clone().map(|it| (it / 10) as u32).collect(),
        thoughts: frames.clone().map(|it| usize::from(it > 5)).collect(),
        moved: frames
            .clone()
            .map(|it| match it % 500 {
                3 => vec![(1, Some([1.5, it as f64]))],
                4 => vec![(1, None), (0, Some([0.0, 0.1]))],
                _ => Vec::new(),
            })
            .collect(),
        spoken: vec!["exploring".to_owned(), "+s3/forward/+\"ingrip\"".to_owned()],
        first: vec![Some([0.25, 0.5]), None],
        doubts: vec![[7, 90], [2990, 3001]],
        knocked: 3001,
    }
}

fn logged() -> (Life, Vec<Step>) {
    let film = shot();
    (Life::of(&film, "a life", 5.0, 8.0), steps(&film))
}

#[test]
fn a_log_in_both_forms_is_read_back_as_the_life_that_was_filmed() {
    let (life, steps) = logged();
    let mcap = mcap::read(&mcap::bytes(&life, &steps).unwrap()).unwrap();
    let lines = lines::read(&lines::bytes(&life, &steps).unwrap()).unwrap();
    for (again, of) in [&mcap, &lines] {
        assert_eq!((again, of), (&life, &steps));
        let mut shown = shot();
        let last = shown.poses.len() - 1;
        shown.actions[last] = shown.actions[last - 1];
        shown.values[last] = 0.0;
        shown.thoughts[last] = shown.spoken.len();
        shown.spoken.push("the log ends here".to_owned());
        assert_eq!(film(again, of).unwrap(), shown);
    }
}

#[test]
fn a_log_that_is_cut_off_is_refused_at_every_length_in_a_sentence() {
    let (life, mut steps) = logged();
    steps.truncate(20);
    steps.last_mut().unwrap().choice = None;
    for (whole, read) in [
        (
            mcap::bytes(&life, &steps).unwrap(),
            mcap::read as fn(&[u8]) -> _,
        ),
        (lines::bytes(&life, &steps).unwrap(), lines::read),
    ] {
        for length in 0..whole.len() {
            let part = &whole[..length];
            let log = read(part).and_then(|(_, steps)| complete(&steps));
            let why = log.unwrap_err();
            assert!(!why.is_empty() && !why.contains('\n'), "{why}");
        }
        let again = read(&whole).unwrap().1;
        assert_eq!(again, steps);
        complete(&again).unwrap();
    }
}

#[test]
fn a_gap_is_named_by_the_first_action_that_is_missing() {
    let (_, whole) = logged();
    let why = |spoil: fn(&mut Vec<Step>)| {
        let mut steps = whole.clone();
        spoil(&mut steps);
        complete(&steps).unwrap_err()
    };
    complete(&whole).unwrap();
    assert_eq!(why(|it| drop(it.remove(7))), "action 7 is missing");
    assert_eq!(why(|it| drop(it.remove(0))), "action 0 is missing");
    assert_eq!(why(|it| it.swap(7, 8)), "action 7 is missing");
    assert_eq!(why(|it| it[7].choice = None), "action 7 has no choice");
    assert!(why(|it| drop(it.pop())).starts_with("the log is cut off"));
    assert_eq!(why(Vec::clear), "the log has no actions");
}

#[test]
fn what_no_pioneer_has_is_named_with_its_action() {
    let (life, steps) = logged();
    let spoilt = |spoil: fn(&mut Step)| {
        let mut steps = steps.clone();
        spoil(&mut steps[11]);
        film(&life, &steps).unwrap_err()
    };
    let no_item = spoilt(|it| it.percept.on.push("s9".to_owned()));
    assert_eq!(no_item, "action 11: there is no item \"s9\"");
    let no_action = spoilt(|it| it.choice.as_mut().unwrap().action = "fly".to_owned());
    assert_eq!(no_action, "action 11: there is no action \"fly\"");
    let no_specimen = spoilt(|it| {
        it.specimens.push(super::Moved {
            specimen: 2,
            to: None,
        });
    });
    assert_eq!(no_specimen, "action 11: there is no specimen 2");
}

#[test]
fn each_thousand_actions_has_what_it_brought() {
    let (_, steps) = logged();
    let expected = "from,to,obtained,alarms\n0,1000,100,1\n1000,2000,100,0\n2000,3000,100,1\n";
    assert_eq!(windows(&steps), expected);
}

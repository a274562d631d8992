//! What files say, what is refused and where, and what the shuttle's planner and rivals earn.

use std::sync::Arc;

use super::planner::{Plan, PlanConfig};
use super::{CHEESE, Place, Pomdp, PomdpWorld, SHUTTLE, hallway, shuttle, t_maze};
use crate::baseline::random::Random;
use crate::baseline::worlds::believer::Believer;
use crate::baseline::worlds::shuttle::Docker;
use crate::learner::Learner;
use crate::learner::controller::Untaught;
use crate::learner::rewarded::{driven, rewarded};
use crate::world::World;

const HEAD: &str =
    "discount: 0.9\nvalues: reward\nstates: a b\nactions: go stay\nobservations: x y\n";
const BODY: &str = "T: go\n0 1\n1 0\nT: stay identity\nO: *\n.9 .1\n.1 .9\nR: go : a : b : * 5\n";

fn shuttle_model() -> Arc<Pomdp> {
    Arc::new(Pomdp::parse(SHUTTLE).unwrap())
}

#[test]
fn all_three_forms_of_chances_and_rewards_say_the_same() {
    let matrices = Pomdp::parse(&format!("{HEAD}{BODY}")).unwrap();
    let rows = "T: go : a\n0 1\nT: go : b 1 0\nT: 1 : *\n0 1\nT: stay : 0 1 0\n\
                O: go : a\n.9 .1\nO: go : b\n.1 .9\nO: stay : a .9 .1\nO: stay : b .1 .9\n\
                R: go : a : b\n5 5\n";
    assert_eq!(
        Pomdp::parse(&format!("{HEAD}{rows}")).unwrap().transitions,
        matrices.transitions
    );
    let single = "T: * : * : * 0\nT: go : a : b 1.0\nT: go : b : a 1\nT: stay : a : a 1\n\
                  T: stay : b : b 1\nO: * : a : x .9 O: * : a : y .1 O: * : 1 : 0 1e-1 O: * : b : 1 0.9\n\
                  R: go : a\n0 0\n5 5\n";
    let single = Pomdp::parse(&format!("{HEAD}{single}")).unwrap();
    assert_eq!(single.transitions, matrices.transitions);
    for ((action, from), (to, seen)) in [((0, 0), (1, 0)), ((0, 0), (0, 0)), ((1, 0), (1, 1))] {
        let reward = matrices.reward(action, from, to, seen);
        assert_eq!(single.reward(action, from, to, seen), reward);
    }
    assert_eq!(matrices.expected(0, 0), 5.0);
    assert_eq!(matrices.discount(), 0.9);
}

#[test]
fn costs_are_negative_rewards_and_the_last_of_two_rewards_holds() {
    let costs = HEAD.replace("reward", "cost");
    let more = "R: * : * : * : * 1\nR: go : a : b : y 2\n";
    let model = Pomdp::parse(&format!("{costs}{BODY}{more}")).unwrap();
    assert_eq!(model.reward(0, 0, 1, 0), -1.0);
    assert_eq!(model.reward(0, 0, 1, 1), -2.0);
}

#[test]
fn a_start_is_a_list_of_chances_a_name_a_number_or_a_list_of_states() {
    let start = |line: &str| {
        let text = HEAD.replace("states: a b", "states: a b c") + line;
        let body = "\nT: * uniform\nO: * uniform\n";
        Pomdp::parse(&(text + body)).unwrap().start
    };
    assert_eq!(start("start: 0.25 0.25 0.5"), [0.25, 0.25, 0.5]);
    assert_eq!(start("start: b"), [0.0, 1.0, 0.0]);
    assert_eq!(start("start: 2"), [0.0, 0.0, 1.0]);
    assert_eq!(start("start include: a 2"), [0.5, 0.0, 0.5]);
    assert_eq!(start("start exclude: a"), [0.0, 0.5, 0.5]);
    let third = 1.0 / 3.0;
    assert_eq!(start("start: uniform"), [third; 3]);
    assert_eq!(start(""), [third; 3]);
}

#[test]
fn a_reset_leads_to_the_start_and_numbers_of_things_make_names() {
    let text = "states: 3\nactions: 1\nobservations: 2\nstart: 1\n# all of it\n\
                T: 0 : * reset\nO: 0 : * uniform\n";
    let model = Pomdp::parse(text).unwrap();
    assert_eq!(model.next(0, 2), [0.0, 1.0, 0.0]);
    assert_eq!(model.observations(), ["observation0", "observation1"]);
}

/// Each line: what is wrong, where, and a word of the sentence.
#[test]
fn what_is_no_pomdp_is_refused_in_one_sentence_with_line_and_column() {
    let whole = format!("{HEAD}{BODY}");
    let changed = |from: &str, to: &str| {
        assert!(whole.contains(from), "{from}");
        whole.replace(from, to)
    };
    let cases = [
        (String::new(), (1, 1), "\"states:\" must stand before"),
        ("garbage".to_owned(), (1, 1), "a part such as"),
        (":".to_owned(), (1, 1), "a part such as"),
        (changed("0.9\n", "1.9\n"), (1, 11), "between 0 and 1"),
        (changed("0.9\n", "NaN\n"), (1, 11), "not \"NaN\""),
        (changed("reward", "money"), (2, 9), "\"reward\" or \"cost\""),
        (changed("a b\n", "a a\n"), (3, 11), "two states \"a\""),
        (changed("a b\n", "0\n"), (3, 9), "from 1 on"),
        (changed("a b\n", "2.5\n"), (3, 9), "whole"),
        (
            changed("a b\n", "99999999999999999999\n"),
            (3, 9),
            "do not fit",
        ),
        (changed("a b\n", "2049\n"), (3, 9), "more than 2048 states"),
        (changed("a b\n", "2048\n"), (6, 1), "more chances"),
        (
            changed("x y\n", "129\n"),
            (5, 15),
            "more than 128 observations",
        ),
        (
            changed("x y\n", "x %y\n"),
            (5, 17),
            "the name of a observation",
        ),
        (
            changed("states: a b\n", ""),
            (5, 1),
            "\"states:\" must stand",
        ),
        (
            changed("states: a b\n", "states:\n"),
            (4, 1),
            "a number of states",
        ),
        (changed("states:", "states"), (3, 1), "a part such as"),
        (
            changed("values:", "discount: 1 values:"),
            (2, 1),
            "second time",
        ),
        (
            changed("T: go\n", "T: fly\n"),
            (6, 4),
            "\"fly\" is no action: there are 2, go, stay",
        ),
        (changed("T: go\n", "T: 2\n"), (6, 4), "\"2\" is no action"),
        (
            changed("T: go\n", "T: go : c\n"),
            (6, 9),
            "\"c\" is no state",
        ),
        (
            changed("0 1\n1 0", "0 1\n1"),
            (9, 1),
            "the probability of an end state",
        ),
        (changed("0 1\n", "0 1.5\n"), (7, 3), "not at 1.5"),
        (changed("0 1\n", "0 -1\n"), (7, 3), "not at -1"),
        (changed("0 1\n", "0 .9\n"), (7, 1), "sum up to 0.9"),
        (changed("1 0\n", ".9 0\n"), (8, 1), "sum up to 0.9"),
        (changed("0 1\n", "0 1 0\n"), (8, 3), "should begin here"),
        (
            changed("T: stay identity\n", ""),
            (12, 20),
            "without the chances of action \"stay\"",
        ),
        (
            changed("O: *\n.9 .1\n.1 .9\n", ""),
            (10, 20),
            "observations in state \"a\"",
        ),
        (changed(".1 .9", ".1 x"), (12, 4), "not \"x\""),
        (
            changed("* 5", "* lots"),
            (13, 19),
            "a reward should stand here",
        ),
        (
            changed("* 5", "* inf"),
            (13, 19),
            "a reward should stand here",
        ),
        (changed("* 5", "*"), (13, 18), "the end of the file"),
        (changed("R: go : a", "R: go a"), (13, 7), "a colon after"),
        (
            changed("R: go", "start: 0.5 0.6\nR: go"),
            (13, 8),
            "sum up to 1.1",
        ),
        (
            changed("R: go", "start exclude: *\nR: go"),
            (13, 7),
            "no state is left",
        ),
        (
            changed("R: go", "start: c\nR: go"),
            (13, 8),
            "a state to start in",
        ),
        (
            format!("start: uniform\n{whole}"),
            (1, 6),
            "before \"start\"",
        ),
    ];
    for (text, (line, column), word) in cases {
        let error = Pomdp::parse(&text).unwrap_err();
        let sentence = error.to_string();
        assert!(sentence.contains(word), "{sentence}\n{text}");
        assert_eq!(error.place, Place { line, column }, "{sentence}\n{text}");
        assert!(
            !sentence.contains('\n') && sentence.len() < 200,
            "{sentence}"
        );
    }
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_file_with_any_word_cut_out_doubled_or_replaced_never_panics() {
    let words: Vec<&str> = SHUTTLE.split_inclusive(char::is_whitespace).collect();
    let mut refused = 0;
    for at in 0..words.len() {
        for by in ["", ":", "*", "99", "-1", "T:", "états", "uniform "] {
            let mut changed = words.clone();
            changed[at] = by;
            refused += u32::from(Pomdp::parse(&changed.concat()).is_err());
        }
        refused += u32::from(Pomdp::parse(&words[..at].concat()).is_err());
    }
    assert!(refused > 500, "{refused}");
}

#[test]
fn the_shuttle_is_what_its_file_says_and_its_brain_has_the_same_words() {
    let model = shuttle_model();
    assert_eq!(model.observations(), shuttle::VOCABULARY.items);
    assert_eq!(model.actions(), shuttle::VOCABULARY.actions);
    assert_eq!(model.states().len(), 8);
    assert_eq!(model.start()[7], 1.0);
    assert_eq!(model.reward(1, 1, 1, 0), -3.0);
    assert_eq!(model.observed(0, 2), [0.0, 0.7, 0.0, 0.3, 0.0]);
}

#[test]
fn a_life_follows_the_chances_of_the_file() {
    let model = shuttle_model();
    let mut world = PomdpWorld::new(Arc::clone(&model), 5);
    assert!(world.sense().on().is_empty());
    let mut rng = cla_core::num::Rng::new(5);
    let (mut tries, mut moves, mut seen) = (0, 0, 0);
    for _ in 0..60_000 {
        let (state, before) = (world.state(), world.earned());
        let action = rng.below(3) as usize;
        world.act(action);
        assert!(model.chance(action, state, world.state()) > 0.0);
        let docked = (action, state, world.state()) == (2, 3, 0);
        assert_eq!(world.earned() - before == 10.0, docked);
        if (action, state) == (2, 3) {
            tries += 1;
            moves += i32::from(docked);
        }
        let lrv = world.sense().get(cla_core::word::ItemId(0)) == Some(true);
        seen += i32::from(world.state() == 5 && lrv) * 10 - i32::from(world.state() == 5) * 7;
    }
    let share = f64::from(moves) / f64::from(tries);
    assert!((share - 0.7).abs() < 0.02, "{share}");
    assert!(seen.abs() < 1000, "{seen}");
}

#[test]
fn the_planner_earns_the_shuttles_optimum_and_the_rival_three_quarters_of_it() {
    let model = shuttle_model();
    // Four steps to the other dock, then attempts that succeed in .7.
    let bound = model.model().rate(1e-9);
    assert!((bound.gain - 10.0 / (4.0 + 1.0 / 0.7)).abs() < 1e-6);
    assert!((bound.gain - 1.842).abs() < 5e-4);
    let world = |seed| PomdpWorld::new(Arc::clone(&model), seed);
    let all = driven(&mut world(1), 200_000, |it| bound.policy[it.state()]);
    assert!((all.per_action() - bound.gain).abs() < 0.02);
    let plan = Arc::new(Plan::new(Arc::clone(&model), PlanConfig::DEFAULT));
    let lived = |learner: &mut dyn Learner, seed| {
        let income = rewarded(learner, &mut world(seed), 100_000);
        income.unwrap().per_action()
    };
    let planned = lived(&mut Untaught::new(Believer::new(plan), 1), 1);
    assert!((planned - bound.gain).abs() < 0.02, "{planned}");
    let rival = lived(&mut Untaught::new(Docker::default(), 1), 1);
    assert!((0.75 * bound.gain..bound.gain).contains(&rival), "{rival}");
    let random = lived(&mut Untaught::new(Random { actions: 3 }, 1), 1);
    assert!(random < 0.25 * rival, "{random}");
}

#[test]
fn the_same_seed_gives_the_same_life_in_a_world_of_a_file() {
    let model = shuttle_model();
    let life = |seed| {
        let mut world = PomdpWorld::new(Arc::clone(&model), seed);
        let step = |it: usize| {
            world.act(it % 3);
            (world.state(), world.sense())
        };
        (0..300).map(step).collect::<Vec<_>>()
    };
    assert_eq!(life(1), life(1));
    assert_ne!(life(1), life(2));
}

/// From the table of Littman, Cassandra and Kaelbling: action, state, next state, chance.
const HALLWAY_MOVES: [(usize, usize, usize, f64); 23] = [
    (1, 0, 5, 0.05),
    (1, 0, 0, 0.95),
    (1, 3, 5, 0.025),
    (1, 3, 7, 0.025),
    (1, 4, 9, 0.05),
    (1, 4, 3, 0.05),
    (1, 4, 4, 0.9),
    (1, 5, 9, 0.8),
    (1, 5, 1, 0.025),
    (1, 5, 5, 0.15),
    (1, 8, 44, 0.025),
    (1, 8, 8, 0.85),
    (1, 10, 46, 0.8),
    (1, 10, 13, 0.05),
    (1, 44, 8, 0.8),
    (1, 54, 24, 0.025),
    (2, 0, 1, 0.7),
    (2, 1, 0, 0.1),
    (3, 0, 2, 0.6),
    (3, 1, 0, 0.15),
    (4, 2, 1, 0.7),
    (0, 7, 7, 1.0),
    (3, 57, 12, 1.0 / 56.0),
];

/// State, percept, chance.
const HALLWAY_SIGHTS: [(usize, usize, f64); 8] = [
    (0, 11, 0.692_55),
    (0, 15, 0.036_464),
    (1, 7, 0.692_55),
    (4, 10, 0.731_024),
    (8, 8, 0.771_637),
    (9, 1, 0.771_637),
    (10, 16, 1.0),
    (58, 20, 1.0),
];

#[test]
fn the_hallway_has_the_chances_of_its_published_table() {
    let hallway = Pomdp::parse(&hallway()).unwrap();
    for (action, from, to, chance) in HALLWAY_MOVES {
        let ours = hallway.chance(action, from, to);
        assert!((ours - chance).abs() < 2e-5, "{action} {from} {to} {ours}");
    }
    for (state, seen, chance) in HALLWAY_SIGHTS {
        let ours = hallway.observed(0, state)[seen];
        assert!((ours - chance).abs() < 2e-5, "{state} {seen} {ours}");
    }
    assert_eq!(
        (hallway.reward(1, 30, 57, 20), hallway.reward(1, 30, 3, 0)),
        (1.0, 0.0)
    );
    assert!((hallway.start()[55] - 1.0 / 56.0).abs() < 1e-9 && hallway.start()[56] == 0.0);
}

#[test]
fn the_cheese_maze_is_the_one_of_its_picture() {
    let maze = Pomdp::parse(CHEESE).unwrap();
    // Of each place: what lies north, south, east and west of it, itself for a wall.
    let beside = [
        [0, 5, 1, 0],
        [1, 1, 2, 0],
        [2, 6, 3, 1],
        [3, 3, 4, 2],
        [4, 7, 4, 3],
        [0, 8, 5, 5],
        [2, 10, 6, 6],
        [4, 9, 7, 7],
        [5, 8, 8, 8],
        [7, 9, 9, 9],
    ];
    for (place, ends) in beside.iter().enumerate() {
        for (action, &end) in ends.iter().enumerate() {
            assert_eq!(maze.chance(action, place, end), 1.0, "{place} {action}");
        }
    }
    for action in 0..4 {
        let elsewhere = &maze.next(action, 10)[..10];
        assert!(elsewhere.iter().all(|it| (it - 0.1).abs() < 1e-12));
    }
    // Three corridors look alike, and two ends of one.
    let seen = |place: usize| maze.observed(0, place).iter().position(|&it| it == 1.0);
    assert_eq!([5, 6, 7].map(seen), [seen(5); 3]);
    assert_eq!((seen(1), seen(8)), (seen(3), seen(9)));
    assert_eq!(maze.reward(1, 6, 10, 6), 1.0);
}

#[test]
fn in_a_corridor_the_cue_alone_tells_where_the_prize_is() {
    for delay in [1, 2, 16] {
        let maze = Pomdp::parse(&t_maze(delay)).unwrap();
        for (side, turn) in [(0, 1), (1, 2)] {
            let first = side * (delay + 1);
            let mut state = first;
            assert_eq!(maze.observed(0, first)[side], 1.0);
            for _ in 0..delay {
                state = maze
                    .next(0, state)
                    .iter()
                    .position(|&it| it == 1.0)
                    .unwrap();
                assert_eq!(maze.observed(0, state)[1 - side], 0.0);
            }
            assert_eq!(maze.observed(0, state)[3], 1.0);
            let prize = 2 * (delay + 1);
            assert_eq!(maze.chance(turn, state, prize), 1.0);
            assert_eq!(maze.chance(3 - turn, state, prize + 1), 1.0);
            assert_eq!(maze.expected(turn, state), 4.0);
            assert_eq!(maze.chance(0, prize, first), 0.5);
        }
    }
}

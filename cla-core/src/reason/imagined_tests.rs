//! Values and goals along links, what stays when the graph is full, and what cannot be.

use super::{Imagined, NEVER};
use crate::num::Rng;
use crate::word::{ItemId, ItemSet, SignedItems};

fn place(at: u16) -> ItemSet<1> {
    let mut set = ItemSet::EMPTY;
    set.insert(ItemId(at)).unwrap();
    set
}

fn goal(at: u16) -> SignedItems<1> {
    let mut goal = SignedItems::EMPTY;
    goal.insert(ItemId(at), true).unwrap();
    goal
}

/// Places in a row; action 0 leads on, action 1 back; the last brings 1.
fn row<const NODES: usize>(places: u16) -> Imagined<1, 32, 2, NODES> {
    let mut row = Imagined::new();
    for at in 0..places {
        let here = row.visit(&place(at), 0.0).unwrap();
        row.feel(here, f32::from(u8::from(at == places - 1)));
    }
    for at in 0..places {
        let here = row.find(&place(at)).unwrap();
        for (action, to) in [(0, (at + 1).min(places - 1)), (1, at.saturating_sub(1))] {
            let there = row.find(&place(to)).unwrap();
            row.live(here, action, there, true);
        }
    }
    row
}

fn settle<const NODES: usize>(row: &mut Imagined<1, 32, 2, NODES>, goal: Option<&SignedItems<1>>) {
    for _ in 0..2_000 {
        let mut moved = false;
        for at in 0..row.len() {
            moved |= row.sweep(at, goal, 0.5);
        }
        if !moved {
            return;
        }
    }
    panic!("it never settles");
}

#[test]
fn values_and_distances_go_back_along_the_links() {
    let mut row = row::<8>(6);
    settle(&mut row, Some(&goal(5)));
    for at in 0..5 {
        let here = row.find(&place(at)).unwrap();
        assert_eq!(row.distances(here)[0], (4 - at) as u8);
        let [on, back] = row.values(here, 0.5).map(Option::unwrap);
        // Whoever stays at the end gets 1 for ever: 2 in all, half as much a step earlier.
        let wanted = 2.0 * 0.5_f32.powi(i32::from(4 - at));
        assert!((on - wanted).abs() < 0.02, "{at}: {on}");
        assert!(back < on);
    }
    row.lose_sight();
    settle(&mut row, Some(&goal(0)));
    assert_eq!(row.distances(row.find(&place(4)).unwrap()), [5, 3]);
    // A goal that is nowhere is far from everywhere.
    row.lose_sight();
    settle(&mut row, Some(&goal(20)));
    assert_eq!(row.distances(0), [NEVER; 2]);
}

#[test]
fn a_way_that_is_cut_is_seen_no_more() {
    let mut row = row::<8>(6);
    settle(&mut row, Some(&goal(5)));
    let [three, four] = [3, 4].map(|at| row.find(&place(at)).unwrap());
    row.live(three, 0, three, true);
    // Within as many rounds as there are places, not by counting up.
    for _ in 0..6 {
        for at in 0..row.len() {
            row.sweep(at, Some(&goal(5)), 0.5);
        }
    }
    assert_eq!(row.distances(three), [NEVER; 2]);
    assert_eq!(row.distances(four)[0], 0);
}

#[test]
fn what_was_lived_through_is_not_imagined_otherwise() {
    let mut row = row::<8>(3);
    let here = row.find(&place(1)).unwrap();
    assert!(!row.foresee(here, 0, &place(0), 0.0));
    // Where actions slip one exception changes nothing, a second one does.
    let [back, there] = [0, 2].map(|at| row.find(&place(at)).unwrap());
    assert!(!row.live(here, 0, back, false));
    assert!(!row.live(here, 0, there, false));
    assert!(!row.live(here, 0, back, false));
    assert!(row.live(here, 0, back, false));
}

#[test]
fn items_never_seen_together_make_no_state() {
    let mut row = row::<8>(3);
    let len = row.len();
    let start = row.visit(&place(9), 0.0).unwrap();
    assert!(row.is_open(start, 0));
    assert!(row.foresee(start, 0, &place(1).union(&place(2)), 0.0));
    assert!(!row.is_open(start, 0));
    assert_eq!(row.len(), len + 1);
    assert_eq!(row.values(start, 0.5), [None; 2]);
}

#[test]
fn a_full_graph_keeps_what_was_perceived() {
    let mut row = row::<8>(5);
    // Seen elsewhere, so that they may be imagined.
    for at in 10..13 {
        row.together[usize::from(at)] = place(at);
        let start = row.visit(&place(0), 0.0).unwrap();
        row.intern(&place(at), 1.0);
        if at == 10 {
            row.set_link(start, 1, row.find(&place(10)).unwrap() + 1);
        }
    }
    assert_eq!((row.count(), row.makes_room()), (8, false));
    assert_eq!(row.visit(&place(20), 0.0), None);
    assert!(row.makes_room());
    // Meanwhile nothing is imagined, and what is perceived is found and stays.
    assert!(!row.foresee(0, 1, &place(11), 0.0));
    row.visit(&place(12), 0.0).unwrap();
    make_room(&mut row);
    assert_eq!((row.count(), row.find(&place(11))), (6, None));
    assert!(row.find(&place(12)).is_some());
    assert!(row.is_open(row.find(&place(0)).unwrap(), 1));
    for at in [20, 21] {
        assert!(row.visit(&place(at), 0.0).is_some());
    }
    assert_eq!(row.count(), 8);
    settle(&mut row, Some(&goal(4)));
    for at in 0..4 {
        let here = row.find(&place(at)).unwrap();
        assert_eq!(row.distances(here)[0], (3 - at) as u8);
    }
    // When all was perceived it begins anew.
    assert_eq!(row.visit(&place(22), 0.0), None);
    make_room(&mut row);
    assert_eq!(row.count(), 0);
    assert_eq!(row.visit(&place(22), 0.0), Some(0));
}

fn make_room<const NODES: usize>(row: &mut Imagined<1, 32, 2, NODES>) {
    for _ in 0..3 * NODES {
        if row.make_room() {
            return;
        }
    }
    panic!("it never ends");
}

#[test]
fn whatever_is_asked_of_it_nothing_breaks() {
    let mut graph = Imagined::<1, 32, 2, 8>::new();
    let mut rng = Rng::new(4);
    assert_eq!(graph.distances(3), [NEVER; 2]);
    for _ in 0..5_000 {
        let mut set = ItemSet::EMPTY;
        for item in 0..4 {
            if rng.chance(0.5) {
                set.insert(ItemId(item)).unwrap();
            }
        }
        let (at, action) = (rng.below(10) as u16, rng.below(4) as u8);
        match rng.below(5) {
            4 => {
                graph.make_room();
            }
            0 => {
                let here = graph.visit(&set, rng.unit());
                assert_eq!(graph.find(&set), here);
                assert_eq!(
                    here.is_none(),
                    graph.makes_room() && graph.find(&set).is_none()
                );
            }
            1 => {
                graph.foresee(at, action, &set, 0.5);
            }
            2 => {
                let to = rng.below(u32::from(graph.len()).max(1)) as u16;
                graph.live(at, action, to, rng.chance(0.5));
            }
            _ => {
                graph.sweep(at, Some(&goal(2)), 0.9);
            }
        }
        for at in 0..graph.len() {
            if graph.node(at).unwrap().is_free() {
                continue;
            }
            let on = *graph.on(at).unwrap();
            assert_eq!(graph.find(&on), Some(at));
            for link in graph.node(at).unwrap().links {
                let to = link.checked_sub(1).and_then(|to| graph.node(to));
                assert!(link == 0 || link == super::REFUSED || to.is_some_and(|to| !to.is_free()));
            }
            assert!(
                graph
                    .values(at, 0.9)
                    .iter()
                    .flatten()
                    .all(|it| it.is_finite())
            );
        }
    }
}

#[test]
fn a_goal_does_not_hold_where_an_item_that_it_forbids_is_on() {
    let mut goal = goal(1);
    goal.insert(ItemId(2), false).unwrap();
    let mut both = place(1);
    assert!(super::holds(&goal, &both));
    both.insert(ItemId(2)).unwrap();
    assert!(!super::holds(&goal, &both));
}

#[test]
fn room_is_made_to_an_end_however_many_states_were_perceived() {
    for perceived in 50..=64 {
        let mut full = Imagined::<1, 32, 2, 64>::new();
        // Five items and twenty-six: all pairs are other states.
        let pairs = (0..5).flat_map(|one| (5..31).map(move |other| (one, other)));
        let mut last = ItemSet::EMPTY;
        for (one, other) in pairs.take(perceived) {
            last = place(one).union(&place(other));
            full.visit(&last, 0.0);
        }
        let mut steps = 0;
        while full.makes_room() {
            // Whoever made room is told where it is.
            if full.make_room() {
                full.visit(&last, 0.0);
            }
            steps += 1;
            assert!(steps < 1_000, "{perceived}");
        }
    }
}

#[test]
fn what_was_refused_is_no_broken_promise() {
    let mut row = row::<8>(3);
    let [zero, one] = [0, 1].map(|at| row.find(&place(at)).unwrap());
    assert_eq!(row.kept(zero, 0, one), Some(true));
    assert_eq!(row.kept(zero, 0, zero), Some(false));
    let new = row.visit(&place(7), 0.0).unwrap();
    assert_eq!(row.kept(new, 0, one), None);
    // Places 0 and 1 at once cannot be: nothing is foreseen.
    row.foresee(new, 0, &place(0).union(&place(1)), 0.0);
    assert!(!row.is_open(new, 0));
    assert_eq!(row.kept(new, 0, one), None);
}

//! Mazes of the literature, written in the format of the files.
//!
//! In all of them the percept does not say where one is.

use std::fmt::Write;

/// McCallum's cheese maze: eleven places, of which seven percepts tell.
pub const CHEESE: &str = include_str!("../../../data/pomdp/cheese.POMDP");

/// A corridor with a cue at its beginning and a choice at its end (after Bakker 2002).
///
/// The cue says on which side the prize will be; `delay` actions later, at the junction, nothing does.
/// The prize is worth 4, the other side −.1; then a new corridor begins.
///
/// ```
/// use host_sim::world::pomdp::{Pomdp, t_maze};
/// let maze = Pomdp::parse(&t_maze(4))?;
/// assert_eq!(maze.states().len(), 2 * 5 + 2);
/// // Ahead, from the cue of the left into the corridor.
/// assert_eq!(maze.chance(0, 0, 1), 1.0);
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[must_use]
pub fn t_maze(delay: usize) -> String {
    let delay = delay.max(1);
    let sides = ["left", "right"];
    let place = |side: &str, at: usize| format!("{side}{at}");
    let mut text = String::from("discount: 0.98\nvalues: reward\nstates:");
    let mut moves = String::new();
    let mut sights = String::new();
    for side in sides {
        for at in 0..=delay {
            let here = place(side, at);
            line(&mut text, format_args!(" {here}"));
            let seen = match at {
                0 => format!("cue_{side}"),
                _ if at == delay => "junction".to_owned(),
                _ => "corridor".to_owned(),
            };
            line(&mut sights, format_args!("O: * : {here} : {seen} 1\n"));
            let ahead = place(side, (at + 1).min(delay));
            line(&mut moves, format_args!("T: ahead : {here} : {ahead} 1\n"));
            for turn in sides {
                let to = match at {
                    _ if at < delay => here.as_str(),
                    _ if turn == side => "prize",
                    _ => "nothing",
                };
                line(&mut moves, format_args!("T: {turn} : {here} : {to} 1\n"));
            }
        }
    }
    let ends = ["prize", "nothing"];
    for end in ends {
        line(&mut sights, format_args!("O: * : {end} : {end} 1\n"));
        for side in sides {
            line(&mut moves, format_args!("T: * : {end} : {side}0 0.5\n"));
        }
    }
    text += " prize nothing\nactions: ahead left right\n";
    text += "observations: cue_left cue_right corridor junction prize nothing\n";
    text += "start include: left0 right0\n";
    text + &moves + &sights + "R: * : * : prize : * 4\nR: * : * : nothing : * -0.1\n"
}

fn line(text: &mut String, what: std::fmt::Arguments<'_>) {
    // A text has always room.
    let _ = text.write_fmt(what);
}

/// The cells of the hallway east of each, from the west: eleven in a row.
const ROW: usize = 11;
/// The cells that have a bay to the south.
const BAYS: [usize; 4] = [2, 4, 6, 8];
/// The bay with the goal.
const GOAL: usize = 14;

/// The cell beside a cell: directions are north, east, south, west.
fn beside(cell: usize, direction: usize) -> Option<usize> {
    let bay = BAYS.iter().position(|&it| it == cell);
    match direction {
        0 if cell >= ROW => Some(BAYS[cell - ROW]),
        2 if cell < ROW => bay.map(|it| ROW + it),
        1 if cell + 1 < ROW => Some(cell + 1),
        3 if cell > 0 && cell < ROW => Some(cell - 1),
        _ => None,
    }
}

/// The hallway of Littman, Cassandra and Kaelbling (1995): sixty states, twenty-one percepts.
///
/// A robot in a corridor with four bays knows neither its place nor its direction; it sees a wall
/// beside it with .9 where there is one and with .05 where there is none, one of four landmarks when it
/// looks into a bay from the corridor, and the goal when it has reached it.
///
/// ```
/// use host_sim::world::pomdp::{Pomdp, hallway};
/// let hallway = Pomdp::parse(&hallway())?;
/// assert_eq!([hallway.states().len(), hallway.actions().len(), hallway.observations().len()], [60, 5, 21]);
/// # Ok::<(), host_sim::world::pomdp::PomdpError>(())
/// ```
#[must_use]
pub fn hallway() -> String {
    let mut text = String::from(
        "discount: 0.95\nvalues: reward\nstates: 60\n\
         actions: stay forward right around left\nobservations:",
    );
    for walls in 0..16 {
        line(&mut text, format_args!(" walls{walls}"));
    }
    text += " landmark0 landmark1 landmark2 landmark3 goal\n";
    text += "start exclude: 56 57 58 59\nT: stay identity\n";
    for cell in 0..GOAL {
        for facing in 0..4 {
            moves(&mut text, cell, facing);
            sights(&mut text, cell, facing);
        }
    }
    for facing in 0..4 {
        let state = 4 * GOAL + facing;
        line(
            &mut text,
            format_args!("T: * : {state} reset\nO: * : {state} : goal 1\n"),
        );
        line(&mut text, format_args!("R: * : * : {state} : * 1\n"));
    }
    text
}

/// What the actions that move lead to.
fn moves(text: &mut String, cell: usize, facing: usize) {
    let here = 4 * cell + facing;
    let mut forward = [0.0; 60];
    forward[here] += 0.05;
    let mut go = |direction: usize, faces: &[usize], chance: f64| match beside(cell, direction) {
        Some(to) => {
            for &face in faces {
                forward[4 * to + face] += chance / faces.len() as f64;
            }
        }
        None => forward[here] += chance,
    };
    let [right, back, left] = [1, 2, 3].map(|it| (facing + it) % 4);
    go(facing, &[facing], 0.8);
    go(right, &[right], 0.05);
    go(left, &[left], 0.05);
    // Who slips backwards may have turned round or not.
    go(back, &[facing, back], 0.05);
    for (to, chance) in forward.iter().enumerate().filter(|it| *it.1 > 0.0) {
        line(
            text,
            format_args!("T: forward : {here} : {to} {chance:.6}\n"),
        );
    }
    // The chances of having turned by no, one, two and three quarters to the right.
    for (action, quarters) in [
        ("right", [0.1, 0.7, 0.1, 0.1]),
        ("around", [0.1, 0.15, 0.6, 0.15]),
        ("left", [0.1, 0.1, 0.1, 0.7]),
    ] {
        for (quarter, chance) in quarters.iter().enumerate() {
            let to = 4 * cell + (facing + quarter) % 4;
            line(text, format_args!("T: {action} : {here} : {to} {chance}\n"));
        }
    }
}

/// What is seen in a cell.
fn sights(text: &mut String, cell: usize, facing: usize) {
    let here = 4 * cell + facing;
    let bay = BAYS.iter().position(|&it| it == cell);
    if let (Some(bay), 2) = (bay, facing) {
        line(text, format_args!("O: * : {here} : landmark{bay} 1\n"));
        return;
    }
    for walls in 0..16_usize {
        let mut chance = 1.0;
        // Ahead is the highest bit, then right, behind and left.
        for quarter in 0..4 {
            let there = beside(cell, (facing + quarter) % 4).is_none();
            let seen = walls >> (3 - quarter) & 1 == 1;
            let sees = if there { 0.9 } else { 0.05 };
            chance *= if seen { sees } else { 1.0 - sees };
        }
        line(
            text,
            format_args!("O: * : {here} : walls{walls} {chance:.8}\n"),
        );
    }
}

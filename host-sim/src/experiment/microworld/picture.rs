//! The world as text, and what a brain expects of it without looking.
//!
//! The right half is the persistent object: for every cell, whether the brain, by the schemas that
//! it has and without moving, expects to find the ball there (book, 5.4.3: palpable objects).

use cla_core::growth::SimpleSchema;
use cla_core::word::ItemId;

use super::goals::Planning;
use crate::world::microworld::{Cell, Hand, Items, REACH, State};

/// Draws the reach, forwards up: `E` eye, `h` hand (`H` closed, `G` gripping), `o` ball, `*` hand and
/// ball in one cell, and below it the mouth `^`.
///
/// ```
/// use host_sim::experiment::microworld::picture::world;
/// use host_sim::world::microworld::{Cell, Hand, State};
/// let state = State {
///     hand_at: Cell { x: 0, y: 0 },
///     eye_at: Cell { x: 1, y: 1 },
///     ball_at: Cell { x: 2, y: 2 },
///     hand: Hand::Open,
/// };
/// assert_eq!(world(&state), ". . o\n. E .\nh . .\n  ^\n");
/// ```
#[must_use]
pub fn world(state: &State) -> String {
    let mut text = String::new();
    for y in (0..REACH).rev() {
        let row: Vec<&str> = (0..REACH).map(|x| mark(state, Cell { x, y })).collect();
        text.push_str(&row.join(" "));
        text.push('\n');
    }
    text.push_str("  ^\n");
    text
}

fn mark(state: &State, cell: Cell) -> &'static str {
    match (cell == state.hand_at, cell == state.ball_at) {
        (true, true) if state.hand == Hand::Gripping => "G",
        (true, true) => "*",
        (true, false) if state.hand == Hand::Open => "h",
        (true, false) => "H",
        (false, true) => "o",
        (false, false) if cell == state.eye_at => "E",
        (false, false) => ".",
    }
}

/// For every cell of the reach, row by row from the front, whether the brain expects to feel the ball
/// when its hand gets there: it follows its own predictions, not the world.
#[must_use]
pub fn expected_ball(
    on: &Items,
    schemas: &[SimpleSchema],
    planner: &mut Planning,
    text1: ItemId,
) -> String {
    let mut text = String::new();
    for y in (0..REACH).rev() {
        let row: Vec<&str> = (0..REACH)
            .map(|x| {
                let name = format!("hp{}{}", x + 1, y + 1);
                let place = crate::world::microworld::item(&name).expect("an item");
                match planner.foresee(
                    &super::goals::goal(place),
                    on,
                    schemas,
                    &super::goals::CONFIG,
                ) {
                    Some(there) if there.contains(text1) => "o",
                    Some(_) => ".",
                    None => "?",
                }
            })
            .collect();
        text.push_str(&row.join(" "));
        text.push('\n');
    }
    text
}

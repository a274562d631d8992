//! Where keys, doors and prize are, what actions do, and the shortest way from everywhere.

use cla_core::num::Rng;

/// Actions that the shortest way takes at least, wherever a try begins.
pub const LEAST: u32 = 10;

/// Columns, two for each room.
pub const COLUMNS: usize = 6;

/// Rows.
pub const ROWS: usize = 3;

/// Cells, row by row.
const CELLS: usize = ROWS * COLUMNS;

/// Situations: a cell and four yes or no.
const SITUATIONS: usize = CELLS * 16;

/// Where the seeker is, what it has and what it has opened.
///
/// ```
/// use host_sim::world::keys::Situation;
/// assert!(!Situation::START.has_red && !Situation::START.blue_open);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Situation {
    /// The cell, row by row from the north west.
    pub cell: usize,
    /// Whether it has the red key.
    pub has_red: bool,
    /// Whether it has the blue key.
    pub has_blue: bool,
    /// Whether the door to the second room is open.
    pub red_open: bool,
    /// Whether the door to the third room is open.
    pub blue_open: bool,
}

impl Situation {
    /// The north west corner, without anything.
    pub const START: Self = Self {
        cell: 0,
        has_red: false,
        has_blue: false,
        red_open: false,
        blue_open: false,
    };

    fn index(self) -> usize {
        let bits = [self.has_red, self.has_blue, self.red_open, self.blue_open];
        let all = bits.iter().fold(0, |all, &bit| all * 2 + usize::from(bit));
        self.cell * 16 + all
    }

    const fn of(index: usize) -> Self {
        Self {
            cell: index / 16,
            has_red: index & 8 != 0,
            has_blue: index & 4 != 0,
            red_open: index & 2 != 0,
            blue_open: index & 1 != 0,
        }
    }
}

/// Where keys, doors and prize are.
///
/// ```
/// use host_sim::world::keys::{Layout, Situation};
/// let layout = Layout::random(&mut cla_core::num::Rng::new(1));
/// let start = Situation::START;
/// let next = layout.after(start, layout.planned(start));
/// assert_eq!(layout.distance(next) + 1, layout.distance(start));
/// ```
#[derive(Clone, Debug)]
pub struct Layout {
    /// The cell of the red key.
    pub red: usize,
    /// The cell of the blue key.
    pub blue: usize,
    /// The cell of the prize.
    pub prize: usize,
    /// The row of the door between the first two rooms.
    pub red_row: usize,
    /// The row of the door between the last two rooms.
    pub blue_row: usize,
    /// Actions to the prize, by situation.
    distances: Vec<u32>,
}

impl Layout {
    /// Everything anywhere in its room, so that no way is shorter than [`LEAST`] actions.
    #[must_use]
    pub fn random(rng: &mut Rng) -> Self {
        loop {
            let row = |rng: &mut Rng| rng.below(ROWS as u32) as usize;
            let in_room = |rng: &mut Rng, room: usize| {
                let column = room * 2 + rng.below(2) as usize;
                row(rng) * COLUMNS + column
            };
            let mut layout = Self {
                red: in_room(rng, 0),
                blue: in_room(rng, 1),
                prize: in_room(rng, 2),
                red_row: row(rng),
                blue_row: row(rng),
                distances: Vec::new(),
            };
            layout.distances = layout.measured();
            let first = (0..CELLS).filter(|cell| cell % COLUMNS < 2);
            let mut starts = first.map(|cell| Situation {
                cell,
                ..Situation::START
            });
            if starts.all(|it| (LEAST..u32::MAX).contains(&layout.distance(it))) {
                return layout;
            }
        }
    }

    /// Whether the door to the second room is beside this cell of the first.
    #[must_use]
    pub const fn at_red_door(&self, cell: usize) -> bool {
        cell == self.red_row * COLUMNS + 1
    }

    /// Whether the door to the third room is beside this cell of the second.
    #[must_use]
    pub const fn at_blue_door(&self, cell: usize) -> bool {
        cell == self.blue_row * COLUMNS + 3
    }

    /// Whether an action takes the prize.
    #[must_use]
    pub const fn takes_prize(&self, now: Situation, action: usize) -> bool {
        action == 4 && now.cell == self.prize
    }

    /// What an action leads to; the prize apart.
    #[must_use]
    pub fn after(&self, now: Situation, action: usize) -> Situation {
        let mut next = now;
        let (row, column) = (now.cell / COLUMNS, now.cell % COLUMNS);
        match action {
            0 if row > 0 => next.cell -= COLUMNS,
            1 if column + 1 < COLUMNS && self.passes(now, column, row) => next.cell += 1,
            2 if row + 1 < ROWS => next.cell += COLUMNS,
            3 if column > 0 && self.passes(now, column - 1, row) => next.cell -= 1,
            4 => {
                next.has_red |= now.cell == self.red;
                next.has_blue |= now.cell == self.blue;
            }
            5 => {
                next.red_open |= now.has_red && self.at_red_door(now.cell);
                next.blue_open |= now.has_blue && self.at_blue_door(now.cell);
            }
            _ => {}
        }
        next
    }

    /// Whether nothing is between a column and the next.
    const fn passes(&self, now: Situation, column: usize, row: usize) -> bool {
        match column {
            1 => now.red_open && row == self.red_row,
            3 => now.blue_open && row == self.blue_row,
            _ => true,
        }
    }

    /// Actions to the prize from everywhere, the last one included.
    fn measured(&self) -> Vec<u32> {
        let mut distances = vec![u32::MAX; SITUATIONS];
        loop {
            let mut changed = false;
            for index in 0..SITUATIONS {
                let now = Situation::of(index);
                let through = |action: usize| match self.takes_prize(now, action) {
                    true => 1,
                    false => distances[self.after(now, action).index()].saturating_add(1),
                };
                let best = (0..6).map(through).min().unwrap_or(u32::MAX);
                if best < distances[index] {
                    distances[index] = best;
                    changed = true;
                }
            }
            if !changed {
                return distances;
            }
        }
    }

    /// Actions to the prize.
    #[must_use]
    pub fn distance(&self, now: Situation) -> u32 {
        self.distances[now.index()]
    }

    /// The first action of a shortest way.
    #[must_use]
    pub fn planned(&self, now: Situation) -> usize {
        let left = |action: &usize| match self.takes_prize(now, *action) {
            true => 0,
            false => self.distance(self.after(now, *action)),
        };
        (0..6).min_by_key(left).unwrap_or(0)
    }
}

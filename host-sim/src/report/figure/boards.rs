//! Boards: worlds of a few cells with a mark in each, side by side.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::text::{Pen, leading, wrapped};
use super::{Axes, FigureError, LABEL, MARGIN, Picture, SMALL, TITLE, palette, picture};

/// One board: its rows from the top, a mark a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Board {
    /// Above the board.
    pub title: String,
    /// The marks; `.` is an empty cell, `?` one of which nothing is known, `o` an object.
    pub rows: Vec<Vec<String>>,
}

impl Board {
    /// A board from lines of marks with spaces between them.
    #[must_use]
    pub fn new(title: &str, lines: &str) -> Self {
        let row = |line: &str| line.split_whitespace().map(str::to_owned).collect();
        Self {
            title: title.to_owned(),
            rows: lines.lines().map(row).collect(),
        }
    }
}

/// Pairs of boards, the second beside the first, in rows of `columns` pairs; the size follows from
/// the boards.
///
/// # Errors
/// [`FigureError`] without a pair or a column.
///
/// ```
/// use host_sim::report::figure::{Axes, Board, board_pairs};
/// let pair = [Board::new("handl", "o .\n. h"), Board::new("believed", "o ?\n. .")];
/// let axes = Axes::new("Where the ball is", "", "").caption("h hand, o ball");
/// let picture = board_pairs(&axes, 4, &[pair])?;
/// assert!(picture.svg.contains("believed"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn board_pairs(
    axes: &Axes,
    columns: usize,
    pairs: &[[Board; 2]],
) -> Result<Picture, FigureError> {
    let boards = || pairs.iter().flatten();
    let wide = boards().flat_map(|it| &it.rows).map(Vec::len).max();
    let tall = boards().map(|it| it.rows.len()).max();
    let columns = columns.min(pairs.len());
    let (Some(wide), Some(tall), true) = (wide, tall, columns > 0) else {
        return Err(FigureError("no boards".to_owned()));
    };
    let board = (wide as i32 * SIDE, tall as i32 * SIDE);
    let titled = |it: &Board| wrapped(&it.title, SMALL, board.0 + GAP);
    let most = boards().map(|it| titled(it).len()).max().unwrap_or(1);
    let head = most as i32 * leading(SMALL) + 4;
    let pair = (2 * board.0 + GAP + 2 * MARGIN, board.1 + head + MARGIN);
    let rows = pairs.len().div_ceil(columns) as i32;
    let width = (columns as i32 * pair.0).max(560);
    let lines = wrapped(&axes.title, TITLE, width - 2 * MARGIN).len().max(1) as i32;
    let height = 2 * MARGIN + lines * leading(TITLE) + rows * pair.1;
    let axes = axes.clone().sized(width as u32, height as u32);
    picture(&axes, |page, area| {
        for (index, boards) in pairs.iter().enumerate() {
            let corner = (
                area.left + (index % columns) as i32 * pair.0,
                area.top + (index / columns) as i32 * pair.1,
            );
            for (which, it) in boards.iter().enumerate() {
                let left = corner.0 + which as i32 * (board.0 + GAP);
                Pen::new(SMALL).lines(page, &titled(it), (left, corner.1))?;
                draw(page, it, (left, corner.1 + head))?;
            }
        }
        Ok(())
    })
}

const SIDE: i32 = 26;
const GAP: i32 = 20;

fn draw(page: &super::Canvas<'_>, board: &Board, corner: (i32, i32)) -> super::Drawing {
    for (y, row) in board.rows.iter().enumerate() {
        for (x, mark) in row.iter().enumerate() {
            let left = corner.0 + x as i32 * SIDE;
            let top = corner.1 + y as i32 * SIDE;
            let corners = [(left, top), (left + SIDE, top + SIDE)];
            if mark == "?" {
                let unknown = RGBColor(0xE4, 0xE4, 0xE4);
                page.draw(&Rectangle::new(corners, unknown.filled()))?;
            }
            page.draw(&Rectangle::new(corners, RGBColor(0x99, 0x99, 0x99)))?;
            let middle = (left + SIDE / 2, top + SIDE / 2);
            if matches!(mark.as_str(), "o" | "G" | "*") {
                let ball = palette::category(1).filled();
                page.draw(&Circle::new(middle, SIDE / 2 - 4, ball))?;
            }
            if !matches!(mark.as_str(), "o" | ".") {
                let style = TextStyle::from(("sans-serif", LABEL).into_font());
                let style = style.pos(Pos::new(HPos::Center, VPos::Center));
                page.draw_text(mark, &style, middle)?;
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Axes, Board, board_pairs};

    #[test]
    fn no_boards_make_an_error_and_no_panic() {
        let axes = Axes::new("none", "", "");
        assert!(board_pairs(&axes, 4, &[]).is_err());
        let empty = [Board::new("", ""), Board::new("", "")];
        assert!(board_pairs(&axes, 4, &[empty]).is_err());
    }
}

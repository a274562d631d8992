//! Strokes that are told apart without colour: dashes, and marks at their points.

use plotters::prelude::*;

use super::{Canvas, Drawing, palette};

/// A place on the page.
pub(super) type Place = (i32, i32);

/// Lengths of strokes and gaps in turn; none for a full line.
const DASHES: [&[f64]; 5] = [
    &[],
    &[9.0, 5.0],
    &[2.0, 4.0],
    &[11.0, 4.0, 2.0, 4.0],
    &[16.0, 5.0],
];

/// How the line of a category is drawn.
#[derive(Clone, Copy)]
pub(super) struct Stroke {
    pub(super) colour: RGBColor,
    pub(super) width: u32,
    dashes: &'static [f64],
    mark: Option<usize>,
}

impl Stroke {
    /// Of the category with this index: its own colour, dashes and mark.
    pub(super) fn of(index: usize) -> Self {
        Self {
            colour: palette::category(index),
            width: 2,
            dashes: DASHES[index % DASHES.len()],
            mark: Some(index),
        }
    }

    /// Of a number to compare with.
    pub(super) const fn reference() -> Self {
        Self {
            colour: BLACK,
            width: 1,
            dashes: &[7.0, 5.0],
            mark: None,
        }
    }

    /// In the background.
    pub(super) const fn context() -> Self {
        Self {
            colour: RGBColor(0x88, 0x88, 0x88),
            width: 1,
            dashes: &[4.0, 3.0],
            mark: None,
        }
    }

    /// From the end of a line to its name.
    pub(super) const fn leader() -> Self {
        Self {
            colour: RGBColor(0xB4, 0xB4, 0xB4),
            width: 1,
            dashes: &[],
            mark: None,
        }
    }

    /// Without marks.
    pub(super) const fn bare(mut self) -> Self {
        self.mark = None;
        self
    }

    /// The line itself.
    pub(super) fn line(&self, page: &Canvas<'_>, path: &[Place]) -> Drawing {
        for piece in dashed(path, self.dashes) {
            page.draw(&PathElement::new(
                piece,
                self.colour.stroke_width(self.width),
            ))?;
        }
        Ok(())
    }

    /// The mark of a point.
    pub(super) fn mark(&self, page: &Canvas<'_>, (x, y): Place) -> Drawing {
        let Some(mark) = self.mark else {
            return Ok(());
        };
        let around = |corners: &[Place]| -> Vec<Place> {
            corners.iter().map(|&(dx, dy)| (x + dx, y + dy)).collect()
        };
        let corners = match mark % 5 {
            0 => {
                page.draw(&Circle::new((x, y), 4, self.colour.filled()))?;
                return Ok(());
            }
            1 => around(&[(-4, -4), (4, -4), (4, 4), (-4, 4)]),
            2 => around(&[(0, -5), (5, 4), (-5, 4)]),
            3 => around(&[(0, -6), (5, 0), (0, 6), (-5, 0)]),
            _ => around(&[(-5, -4), (5, -4), (0, 5)]),
        };
        page.draw(&Polygon::new(corners, self.colour.filled()))?;
        Ok(())
    }
}

/// A path cut into its dashes; all of it without any.
fn dashed(path: &[Place], dashes: &[f64]) -> Vec<Vec<Place>> {
    if dashes.is_empty() {
        return vec![path.to_vec()];
    }
    let round = |(x, y): (f64, f64)| (x.round() as i32, y.round() as i32);
    let (mut pieces, mut piece) = (Vec::new(), Vec::new());
    let (mut turn, mut left) = (0, dashes[0]);
    for ends in path.windows(2) {
        let &[from, to] = ends else { continue };
        let (from, to) = (
            (f64::from(from.0), f64::from(from.1)),
            (f64::from(to.0), f64::from(to.1)),
        );
        let length = libm::hypot(to.0 - from.0, to.1 - from.1);
        let at = |along: f64| {
            let share = along / length;
            (
                from.0 + share * (to.0 - from.0),
                from.1 + share * (to.1 - from.1),
            )
        };
        let mut along = 0.0;
        if piece.is_empty() && turn % 2 == 0 {
            piece.push(round(from));
        }
        while length - along >= left {
            along += left;
            if turn % 2 == 0 {
                piece.push(round(at(along)));
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece.push(round(at(along)));
            }
            turn += 1;
            left = dashes[turn % dashes.len()];
        }
        left -= length - along;
        if turn % 2 == 0 && length > along {
            piece.push(round(to));
        }
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::dashed;

    #[test]
    fn dashes_and_gaps_take_turns_around_corners() {
        let path = [(0, 0), (10, 0), (10, 10)];
        assert_eq!(dashed(&path, &[]), [path.to_vec()]);
        let pieces = dashed(&path, &[4.0, 2.0]);
        assert_eq!(pieces[0], [(0, 0), (4, 0)]);
        assert_eq!(pieces[1], [(6, 0), (10, 0)]);
        assert_eq!(pieces[2], [(10, 2), (10, 6)]);
        assert_eq!(pieces[3], [(10, 8), (10, 10)]);
        assert_eq!(dashed(&path, &[14.0, 2.0])[0], [(0, 0), (10, 0), (10, 4)]);
    }
}

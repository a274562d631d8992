//! Letters: a line of text as an outline, in the font that is compiled in (DejaVu Sans).
//!
//! Letters stand side by side by their widths and the font's kerning pairs; there are no ligatures.

use ab_glyph::{Font, FontRef, GlyphId, OutlineCurve, Point};
use plotters_backend::FontTransform;
use plotters_backend::text_anchor::HPos;

use super::outline::{Outline, Place};

/// The font, ready to be read.
pub(super) struct Letters {
    font: FontRef<'static>,
}

/// A line of text and where it stands.
pub(super) struct Line<'a> {
    pub(super) text: &'a str,
    /// The size, pixels.
    pub(super) em: f64,
    /// The place that it is anchored to and turned around.
    pub(super) at: Place,
    /// How far below that the baseline lies, in ems, before the turn.
    pub(super) down: f64,
    /// Which part of the line stands at the place.
    pub(super) anchor: HPos,
    /// By how much the line is turned.
    pub(super) turned: FontTransform,
}

impl Letters {
    /// The font that is compiled in.
    pub(super) fn compiled_in() -> Self {
        let font = FontRef::try_from_slice(dejavu::sans::regular());
        Self {
            font: font.expect("the font that is compiled in can be read"),
        }
    }

    /// The outline of a line of text.
    pub(super) fn outline(&self, line: &Line<'_>) -> Outline {
        // Pixels to one unit of the font.
        let unit = line.em / f64::from(self.font.units_per_em().unwrap_or(1000.0));
        let (glyphs, width) = self.set(line.text);
        let left = match line.anchor {
            HPos::Left => 0.0,
            HPos::Center => -width / 2.0,
            HPos::Right => -width,
        };
        let mut outline = Outline::default();
        for (glyph, x) in glyphs {
            let place = |point: Point| {
                let across = (left + x + f64::from(point.x)) * unit;
                let down = line.down * line.em - f64::from(point.y) * unit;
                turned(&line.turned, (across, down), line.at)
            };
            let shape = self.font.outline(glyph);
            for curve in shape.iter().flat_map(|shape| &shape.curves) {
                match *curve {
                    OutlineCurve::Line(from, to) => outline.edge(place(from), place(to)),
                    OutlineCurve::Quad(from, control, to) => {
                        outline.bend(place(from), place(control), place(to));
                    }
                    OutlineCurve::Cubic(from, first, second, to) => {
                        outline.bend_twice(place(from), [place(first), place(second)], place(to));
                    }
                }
            }
        }
        outline
    }

    /// The width of a line of text, in ems.
    pub(super) fn ems(&self, text: &str) -> f64 {
        self.set(text).1 / f64::from(self.font.units_per_em().unwrap_or(1000.0))
    }

    /// Each letter with its distance from the start, and the width of them all, units of the font.
    fn set(&self, text: &str) -> (Vec<(GlyphId, f64)>, f64) {
        let mut glyphs = Vec::new();
        let mut x = 0.0;
        let mut before = None;
        for letter in text.chars() {
            let glyph = self.font.glyph_id(letter);
            if let Some(before) = before {
                x += f64::from(self.font.kern_unscaled(before, glyph));
            }
            glyphs.push((glyph, x));
            x += f64::from(self.font.h_advance_unscaled(glyph));
            before = Some(glyph);
        }
        (glyphs, x)
    }
}

/// A distance from a place, turned around it; turns go clockwise.
fn turned(turn: &FontTransform, (x, y): Place, around: Place) -> Place {
    let (x, y) = match turn {
        FontTransform::None => (x, y),
        FontTransform::Rotate90 => (-y, x),
        FontTransform::Rotate180 => (-x, -y),
        FontTransform::Rotate270 => (y, -x),
    };
    (around.0 + x, around.1 + y)
}

#[cfg(test)]
mod tests {
    use plotters_backend::FontTransform;
    use plotters_backend::text_anchor::HPos;

    use super::{Letters, Line};

    /// Left, top, right and bottom of a line of text at (100, 200), 10 pixels an em.
    fn extent(text: &str, anchor: HPos, turned: FontTransform) -> [f64; 4] {
        let outline = Letters::compiled_in().outline(&Line {
            text,
            em: 10.0,
            at: (100.0, 200.0),
            down: 0.0,
            anchor,
            turned,
        });
        let ends = outline.edges().iter().flat_map(|(from, to)| [*from, *to]);
        ends.fold(
            [f64::MAX, f64::MAX, f64::MIN, f64::MIN],
            |[left, top, right, bottom], (x, y)| {
                [left.min(x), top.min(y), right.max(x), bottom.max(y)]
            },
        )
    }

    fn near(ours: [f64; 4], expected: [f64; 4]) {
        for (ours, expected) in ours.iter().zip(expected) {
            assert!((ours - expected).abs() < 0.2, "{ours} {expected}");
        }
    }

    #[test]
    fn letters_stand_on_the_line_at_their_anchor() {
        // DejaVu Sans: a capital H is .729 ems high, .752 wide, and has .098 on either side.
        near(
            extent("H", HPos::Left, FontTransform::None),
            [101.0, 192.7, 106.5, 200.0],
        );
        near(
            extent("HH", HPos::Center, FontTransform::None),
            [93.5, 192.7, 106.5, 200.0],
        );
        near(
            extent("H", HPos::Right, FontTransform::None),
            [93.5, 192.7, 99.0, 200.0],
        );
        let [_, _, _, bottom] = extent("p", HPos::Left, FontTransform::None);
        assert!(bottom > 201.5, "{bottom}");
    }

    #[test]
    fn a_turned_line_reads_upwards() {
        near(
            extent("H", HPos::Left, FontTransform::Rotate270),
            [92.7, 193.5, 100.0, 199.0],
        );
    }

    #[test]
    fn pairs_are_kerned_and_an_empty_line_is_nothing() {
        let width = |text| {
            let [left, _, right, _] = extent(text, HPos::Left, FontTransform::None);
            right - left
        };
        let apart = width("AHV") - width("H");
        assert!(width("AV") < apart, "{} {apart}", width("AV"));
        assert!(width("") < 0.0, "no edges");
    }
}

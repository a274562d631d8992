//! Words on a page: how wide they are, where lines break, where they stand.

use std::sync::OnceLock;

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::letters::Letters;
use super::page::Page;

/// What is drawn on.
pub(super) type Canvas<'a> = DrawingArea<Page<'a>, Shift>;
/// Whether it could be.
pub(super) type Drawing = Result<(), Box<dyn std::error::Error>>;

/// What nearly all letters are drawn in.
pub(super) const INK: RGBColor = RGBColor(0x1A, 0x1A, 0x1A);
/// What stands in the background: captions, notes, rules.
pub(super) const DIM: RGBColor = RGBColor(0x55, 0x55, 0x55);

/// The width of a line of text of that size, in units of the SVG.
pub(super) fn width(text: &str, size: i32) -> i32 {
    static LETTERS: OnceLock<Letters> = OnceLock::new();
    let letters = LETTERS.get_or_init(Letters::compiled_in);
    (letters.ems(text) * em(size)).ceil() as i32
}

/// The size of an em, as the backend of SVG has it.
pub(super) fn em(size: i32) -> f64 {
    f64::from(size) / 1.24
}

/// Breaks text between words so that no line is wider; a word that is wider stands alone.
pub(super) fn wrapped(text: &str, size: i32, room: i32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match (lines.last_mut(), longer) {
            (Some(line), Some(longer)) if width(&longer, size) <= room => *line = longer,
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// How a line of text stands at its place.
#[derive(Clone, Copy)]
pub(super) struct Pen {
    pub(super) size: i32,
    pub(super) colour: RGBColor,
    pub(super) across: HPos,
    pub(super) down: VPos,
}

impl Pen {
    /// From the left, the place is its upper corner.
    pub(super) const fn new(size: i32) -> Self {
        Self {
            size,
            colour: INK,
            across: HPos::Left,
            down: VPos::Top,
        }
    }

    pub(super) const fn dim(mut self) -> Self {
        self.colour = DIM;
        self
    }

    pub(super) const fn across(mut self, across: HPos) -> Self {
        self.across = across;
        self
    }

    pub(super) const fn down(mut self, down: VPos) -> Self {
        self.down = down;
        self
    }

    /// Writes a line.
    pub(super) fn write(&self, page: &Canvas<'_>, text: &str, at: (i32, i32)) -> Drawing {
        let font = ("sans-serif", self.size).into_font().color(&self.colour);
        let style = font.pos(Pos::new(self.across, self.down));
        page.draw_text(text, &style, at)?;
        Ok(())
    }

    /// Writes lines below each other.
    pub(super) fn lines(&self, page: &Canvas<'_>, lines: &[String], at: (i32, i32)) -> Drawing {
        for (row, line) in lines.iter().enumerate() {
            self.write(page, line, (at.0, at.1 + row as i32 * leading(self.size)))?;
        }
        Ok(())
    }
}

/// From one line of text to the next.
pub(super) const fn leading(size: i32) -> i32 {
    size * 5 / 4
}

#[cfg(test)]
mod tests {
    use super::{width, wrapped};

    #[test]
    fn lines_break_between_words_and_none_is_too_wide() {
        let text = "captures in 3000 actions when specimens reappear elsewhere";
        let lines = wrapped(text, 15, 150);
        assert!(lines.len() > 2 && lines.iter().all(|line| width(line, 15) <= 150));
        assert_eq!(lines.join(" "), text);
        assert_eq!(wrapped("unbreakable", 15, 5), ["unbreakable"]);
        assert!(wrapped("", 15, 100).is_empty());
    }
}

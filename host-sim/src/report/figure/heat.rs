//! Maps of activation: one square a node, many small maps side by side on one scale.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{FigureError, Picture, SMALL, TITLE, fitted, palette, picture};

/// One value a node, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatMap {
    /// Above the map.
    pub title: String,
    /// Nodes in a row.
    pub width: usize,
    /// The values; one that is not finite is drawn grey.
    pub values: Vec<f64>,
}

impl HeatMap {
    /// A map with `width` nodes in a row.
    #[must_use]
    pub fn new(title: &str, width: usize, values: Vec<f64>) -> Self {
        Self {
            title: title.to_owned(),
            width,
            values,
        }
    }

    fn height(&self) -> usize {
        self.values.len().div_ceil(self.width.max(1))
    }
}

/// Maps in rows of `columns`, all on the scale beside them.
///
/// Without a `scale` it spans the values.
///
/// # Errors
/// [`FigureError`] without a map, a column or a finite value.
///
/// ```
/// use host_sim::report::figure::{HeatMap, heat_maps};
/// let maps = [HeatMap::new("Direct", 2, vec![0.0, 0.3, 0.7, 1.0])];
/// let picture = heat_maps("Isolates of the Top layer", 4, &maps, Some((0.0, 1.0)))?;
/// assert!(picture.svg.contains("Direct"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn heat_maps(
    title: &str,
    columns: usize,
    maps: &[HeatMap],
    scale: Option<(f64, f64)>,
) -> Result<Picture, FigureError> {
    let none = || FigureError("maps without nodes or values".to_owned());
    let values = maps.iter().flat_map(|map| &map.values).copied();
    let (low, high) = scale.or_else(|| fitted(values, 0.0)).ok_or_else(none)?;
    let columns = columns.min(maps.len());
    let wide = maps.iter().map(|map| map.width).max().filter(|&w| w > 0);
    let high_map = maps.iter().map(HeatMap::height).max().filter(|&h| h > 0);
    let (Some(wide), Some(tall), true) = (wide, high_map, columns > 0) else {
        return Err(none());
    };
    let page_layout = Layout::new(columns, maps.len().div_ceil(columns), wide, tall, title);
    let share = |value: f64| {
        if high > low {
            (value - low) / (high - low)
        } else {
            0.5
        }
    };
    picture(page_layout.page, |page| {
        let style = TextStyle::from(("sans-serif", TITLE).into_font());
        let style = style.pos(Pos::new(HPos::Center, VPos::Top));
        page.draw_text(title, &style, (page_layout.page.0 as i32 / 2, 12))?;
        for (index, map) in maps.iter().enumerate() {
            let (left, top) = page_layout.corner(index % columns, index / columns);
            let style = TextStyle::from(("sans-serif", SMALL).into_font());
            let style = style.pos(Pos::new(HPos::Center, VPos::Bottom));
            let side = page_layout.side;
            let middle = left + side * wide as i32 / 2;
            page.draw_text(&map.title, &style, (middle, top - 6))?;
            for (node, &value) in map.values.iter().enumerate() {
                let x = left + (node % map.width) as i32 * side;
                let y = top + (node / map.width) as i32 * side;
                let corners = [(x, y), (x + side, y + side)];
                page.draw(&Rectangle::new(
                    corners,
                    palette::ramp(share(value)).filled(),
                ))?;
            }
        }
        page_layout.draw_scale(page, (low, high))
    })
}

/// Sizes and places, in units of the SVG.
struct Layout {
    page: (u32, u32),
    side: i32,
    cell: (i32, i32),
}

impl Layout {
    const MARGIN: i32 = 20;
    const HEAD: i32 = 48;
    const CAPTION: i32 = 28;
    const SCALE: i32 = 84;

    fn new(columns: usize, rows: usize, wide: usize, tall: usize, title: &str) -> Self {
        // Squares are as large as fits a page of about 900 units, within reason.
        let across = 900 / (columns * wide).max(1) as i32;
        let side = across.clamp(6, 24);
        let cell = (
            (side * wide as i32 + Self::MARGIN).max(120),
            side * tall as i32 + Self::CAPTION + 8,
        );
        let maps = Self::MARGIN + cell.0 * columns as i32 + Self::SCALE;
        let letters = title.chars().count() as i32 * 12 + 2 * Self::MARGIN;
        let height = (Self::HEAD + cell.1 * rows as i32).max(200) + Self::MARGIN;
        Self {
            page: (maps.max(letters) as u32, height as u32),
            side,
            cell,
        }
    }

    fn corner(&self, column: usize, row: usize) -> (i32, i32) {
        (
            Self::MARGIN + self.cell.0 * column as i32,
            Self::HEAD + Self::CAPTION + self.cell.1 * row as i32,
        )
    }

    fn draw_scale(&self, page: &super::Canvas<'_>, (low, high): (f64, f64)) -> super::Drawing {
        let left = self.page.0 as i32 - Self::SCALE + 8;
        let (top, bottom) = (
            Self::HEAD + Self::CAPTION,
            self.page.1 as i32 - Self::MARGIN - 8,
        );
        for y in top..bottom {
            let share = f64::from(bottom - y) / f64::from(bottom - top);
            let stroke = palette::ramp(share).filled();
            page.draw(&Rectangle::new([(left, y), (left + 14, y + 1)], stroke))?;
        }
        let style = TextStyle::from(("sans-serif", SMALL).into_font());
        let style = style.pos(Pos::new(HPos::Left, VPos::Center));
        for (value, y) in [
            (high, top),
            (f64::midpoint(low, high), (top + bottom) / 2),
            (low, bottom),
        ] {
            page.draw_text(&format!("{value:.2}"), &style, (left + 20, y))?;
        }
        Ok(())
    }
}

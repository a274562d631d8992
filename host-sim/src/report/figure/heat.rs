//! Maps of activation: one square a node, many small maps side by side on one scale.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::scale::{Scale, label};
use super::text::{DIM, Pen, leading, wrapped};
use super::{
    Axes, Canvas, Drawing, FigureError, MARGIN, Picture, SMALL, TITLE, fitted, palette, picture,
};

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
}

/// Maps in rows of `columns`, equally large, all on the scale beside them; the label of the vertical
/// axis is its unit, the size follows from the maps.
///
/// Without a `scale` it spans the values from 0.
///
/// # Errors
/// [`FigureError`] without a map, a column or a finite value.
///
/// ```
/// use host_sim::report::figure::{Axes, HeatMap, heat_maps};
/// let maps = [HeatMap::new("Direct", 2, vec![0.0, 0.3, 0.7, 1.0])];
/// let axes = Axes::new("Isolates of the Top layer", "", "activation");
/// let picture = heat_maps(&axes, 4, &maps, Some((0.0, 1.0)))?;
/// assert!(picture.svg.contains("Direct"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn heat_maps(
    axes: &Axes,
    columns: usize,
    maps: &[HeatMap],
    scale: Option<(f64, f64)>,
) -> Result<Picture, FigureError> {
    let none = || FigureError("maps without nodes or values".to_owned());
    let values = maps.iter().flat_map(|map| &map.values).copied();
    let spanned = || fitted(values, 0.0).map(|(low, high)| (low.min(0.0), high));
    let scale = Scale::new(scale.or_else(spanned).ok_or_else(none)?, false).ok_or_else(none)?;
    let columns = columns.min(maps.len());
    if columns == 0
        || maps
            .iter()
            .any(|map| map.width == 0 || map.values.is_empty())
    {
        return Err(none());
    }
    let rows = maps.len().div_ceil(columns) as i32;
    let columns = columns as i32;
    let side = ((WIDTH - SCALE - (columns - 1) * MARGIN) / columns).clamp(60, 200);
    let titles: Vec<Vec<String>> = maps
        .iter()
        .map(|map| wrapped(&map.title, SMALL, side))
        .collect();
    let most = titles.iter().map(Vec::len).max().unwrap_or(1) as i32;
    let head = most * leading(SMALL) + 4;
    let wide = columns * (side + MARGIN) + SCALE + MARGIN;
    let lines = wrapped(&axes.title, TITLE, wide - 2 * MARGIN).len().max(1) as i32;
    let tall = rows * (side + head + 10) + 2 * MARGIN + lines * leading(TITLE) + 4;
    let axes = axes.clone().sized(wide as u32, tall as u32);
    picture(&axes, |page, area| {
        for (index, (map, title)) in maps.iter().zip(&titles).enumerate() {
            let (column, row) = (index as i32 % columns, index as i32 / columns);
            let left = area.left + column * (side + MARGIN);
            let top = area.top + row * (side + head + 10);
            let above = top + (most - title.len() as i32) * leading(SMALL);
            Pen::new(SMALL).lines(page, title, (left, above))?;
            draw(page, map, (left, top + head), side, scale)?;
        }
        let left = area.left + columns * (side + MARGIN);
        let bottom = area.top + (rows - 1) * (side + head + 10) + head + side;
        key(page, (left, area.top + head, bottom), &axes.y_label, scale)
    })
}

/// Of a page, units of the SVG.
const WIDTH: i32 = 860;
/// Of the scale beside the maps.
const SCALE: i32 = 110;

fn draw(
    page: &Canvas<'_>,
    map: &HeatMap,
    (left, top): (i32, i32),
    side: i32,
    scale: Scale,
) -> Drawing {
    let height = map.values.len().div_ceil(map.width) as i32;
    let wide = map.width as i32;
    let edge = |part: i32, of: i32| part * side / of;
    for (node, &value) in map.values.iter().enumerate() {
        let (x, y) = (node as i32 % wide, node as i32 / wide);
        let corners = [
            (left + edge(x, wide), top + edge(y, height)),
            (left + edge(x + 1, wide), top + edge(y + 1, height)),
        ];
        let share = if value.is_finite() {
            scale.share(value)
        } else {
            f64::NAN
        };
        page.draw(&Rectangle::new(corners, palette::ramp(share).filled()))?;
    }
    let frame = [(left, top), (left + side, top + side)];
    page.draw(&Rectangle::new(frame, DIM.stroke_width(1)))?;
    Ok(())
}

/// The scale from bottom to top, with its unit below.
fn key(
    page: &Canvas<'_>,
    (left, top, bottom): (i32, i32, i32),
    unit: &str,
    scale: Scale,
) -> Drawing {
    let unit = wrapped(unit, SMALL, SCALE - 4);
    let bottom = (bottom - unit.len() as i32 * leading(SMALL) - 6).max(top + 60);
    let bottom = bottom.min(top + 240);
    for y in top..bottom {
        let share = f64::from(bottom - y) / f64::from(bottom - top);
        let stroke = palette::ramp(share).filled();
        page.draw(&Rectangle::new([(left, y), (left + 16, y + 1)], stroke))?;
    }
    let frame = [(left, top), (left + 16, bottom)];
    page.draw(&Rectangle::new(frame, DIM.stroke_width(1)))?;
    for value in scale.ticks(5) {
        let along = scale.share(value) * f64::from(bottom - top);
        let y = bottom - along.round() as i32;
        let pen = Pen::new(SMALL).down(VPos::Center).across(HPos::Left);
        pen.write(page, &label(value), (left + 22, y))?;
    }
    Pen::new(SMALL).lines(page, &unit, (left, bottom + 10))
}

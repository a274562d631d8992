//! Rows: a name, and beside it one or more numbers with their intervals on a common axis.

use plotters::style::text_anchor::{HPos, VPos};

use super::plot::{Plot, Scales};
use super::point::Point;
use super::strokes::Stroke;
use super::text::{Pen, width};
use super::{Area, Axes, FigureError, LABEL, Picture, SMALL, fitted, picture};
use plotters::prelude::PathElement;

/// A number and the ends of its interval.
pub type Value = (f64, Option<(f64, f64)>);

/// A name with its numbers, one a series; `None` where there is none.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Left of the axis.
    pub label: String,
    /// The number and the ends of its interval, in the order of the series.
    pub values: Vec<Option<Value>>,
}

impl Row {
    /// Means of seeds with their 95 % intervals; what was not measured is left out.
    #[must_use]
    pub fn means_of(label: &str, samples: &[Vec<f64>]) -> Self {
        let value = |seeds: &Vec<f64>| {
            let point = Point::mean_of(0.0, seeds).of_count();
            point.y.is_finite().then_some((point.y, point.band))
        };
        Self {
            label: label.to_owned(),
            values: samples.iter().map(value).collect(),
        }
    }
}

/// Rows below each other, with what each mark is above them; `upright` is a place to compare with,
/// such as 1 of ratios.
///
/// # Errors
/// [`FigureError`] without a finite number.
///
/// ```
/// use host_sim::report::figure::{Axes, Row, row_chart};
/// let rows = [Row::means_of("Sarsa(λ)", &[vec![120.0, 130.0], vec![250.0, 240.0]])];
/// let axes = Axes::new("Captures", "captures in 3000 actions", "").x(0.0, 300.0);
/// let picture = row_chart(&axes, &["first", "last"], &rows, None)?;
/// assert!(picture.svg.contains("Sarsa(λ)"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn row_chart(
    axes: &Axes,
    series: &[&str],
    rows: &[Row],
    upright: Option<f64>,
) -> Result<Picture, FigureError> {
    let points: Vec<Point> = rows
        .iter()
        .flat_map(|row| row.values.iter().flatten())
        .flat_map(|&(value, interval)| {
            let (low, high) = interval.unwrap_or((value, value));
            [low, value, high].map(|it| Point::at(it, 0.0))
        })
        .collect();
    let mut axes = axes.clone().y(0.0, 1.0);
    if axes.x_range.is_none() {
        let fit = fitted(points.iter().map(|it| it.x), 0.0);
        let (low, high) = fit.ok_or_else(|| FigureError("rows without a number".to_owned()))?;
        // From nothing on, and never of no length.
        let low = low.min(0.0);
        axes = axes.x(low, high.max(low + 1e-6));
    }
    let scales = Scales::of(&axes, points.iter())?;
    picture(&axes, |page, area| {
        let mut left = area.left;
        for (index, name) in series.iter().enumerate() {
            let stroke = Stroke::of(index);
            stroke.mark(page, (left + 7, area.top + 8))?;
            Pen::new(SMALL).write(page, name, (left + 18, area.top))?;
            left += width(name, SMALL) + 44;
        }
        let widest = rows.iter().map(|row| width(&row.label, SMALL)).max();
        let left = area.left + widest.unwrap_or(0) + 12;
        let around = Area {
            left: left - 14,
            top: area.top + 28,
            right: area.right - 16,
            bottom: area.bottom - 24,
        };
        let plot = Plot::upright_only(page, around, scales)?;
        if let Some(x) = upright {
            plot.upright(x, Stroke::reference())?;
        }
        let tall = plot.inner.height() / rows.len().max(1) as i32;
        for (index, row) in rows.iter().enumerate() {
            let middle = plot.inner.top + tall * index as i32 + tall / 2;
            let pen = Pen::new(SMALL).across(HPos::Right).down(VPos::Center);
            pen.write(page, &row.label, (plot.inner.left - 8, middle))?;
            let apart = (tall / (row.values.len() as i32 + 1)).min(13);
            let first = middle - apart * (row.values.len() as i32 - 1) / 2;
            for (which, value) in row.values.iter().enumerate() {
                let Some((value, interval)) = *value else {
                    continue;
                };
                let (stroke, y) = (Stroke::of(which), first + apart * which as i32);
                if let Some((low, high)) = interval {
                    let (from, to) = (plot.place(low, 0.0).0, plot.place(high, 0.0).0);
                    for path in [
                        [(from, y), (to, y)],
                        [(from, y - 3), (from, y + 3)],
                        [(to, y - 3), (to, y + 3)],
                    ] {
                        let line = plotters::style::Color::stroke_width(&stroke.colour, 2);
                        page.draw(&PathElement::new(path, line))?;
                    }
                }
                stroke.mark(page, (plot.place(value, 0.0).0, y))?;
            }
        }
        let middle = (plot.inner.left + plot.inner.right) / 2;
        let pen = Pen::new(LABEL).across(HPos::Center);
        pen.write(page, &axes.x_label, (middle, around.bottom + 4))
    })
}

#[cfg(test)]
mod tests {
    use super::{Row, row_chart};
    use crate::report::figure::Axes;

    #[test]
    fn rows_of_nothing_but_zeros_are_drawn_and_rows_without_a_number_are_not() {
        let axes = Axes::new("t", "captures", "");
        let rows = |value: f64| [Row::means_of("a", &[vec![value]])];
        assert!(row_chart(&axes, &["first"], &rows(0.0), None).is_ok());
        assert!(row_chart(&axes, &["first"], &rows(f64::NAN), None).is_err());
    }
}

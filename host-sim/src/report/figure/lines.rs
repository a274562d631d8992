//! Line charts with bands, and ROC curves.

use plotters::prelude::*;

use super::{
    Axes, Canvas, Drawing, FigureError, LABEL, Picture, SMALL, TITLE, fitted, palette, picture,
    tick,
};
use crate::report::{confidence_interval, mean};

/// A point of a line, with the ends of its band where it has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The horizontal place.
    pub x: f64,
    /// The height of the line.
    pub y: f64,
    /// The lower and upper end of the band.
    pub band: Option<(f64, f64)>,
}

impl Point {
    /// A point without a band.
    #[must_use]
    pub const fn at(x: f64, y: f64) -> Self {
        Self { x, y, band: None }
    }

    /// The mean of the seeds, with its 95 % confidence interval as the band; one seed has none.
    #[must_use]
    pub fn mean_of(x: f64, seeds: &[f64]) -> Self {
        let interval = confidence_interval(seeds, 0.95);
        Self {
            x,
            y: mean(seeds),
            band: (seeds.len() > 1).then_some((interval.low, interval.high)),
        }
    }
}

/// Whether the points of a line are joined by a stroke or a dashed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A full stroke.
    Solid,
    /// Dashes, in black: for references such as the book's numbers.
    Dashed,
}

/// A labelled line; points that are not finite are left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What the legend says.
    pub label: String,
    /// The points, from left to right.
    pub points: Vec<Point>,
    /// How it is drawn.
    pub mark: Mark,
}

impl Line {
    /// A full line.
    #[must_use]
    pub fn new(label: &str, points: Vec<Point>) -> Self {
        Self {
            label: label.to_owned(),
            points,
            mark: Mark::Solid,
        }
    }

    /// A dashed black line at one height, for a number to compare with.
    #[must_use]
    pub fn reference(label: &str, height: f64, span: Span) -> Self {
        Self {
            label: label.to_owned(),
            points: vec![Point::at(span.from, height), Point::at(span.to, height)],
            mark: Mark::Dashed,
        }
    }
}

/// The horizontal extent of a reference line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// The left end.
    pub from: f64,
    /// The right end.
    pub to: f64,
}

/// Lines over a common horizontal axis, with a legend when there are several.
///
/// # Errors
/// [`FigureError`] when no point is finite or a given range is empty.
///
/// ```
/// use host_sim::report::figure::{Axes, Line, Point, line_chart};
/// let captures = [[1.0, 2.0, 1.0], [9.0, 12.0, 11.0], [19.0, 20.0, 22.0]];
/// let points = captures.iter().enumerate();
/// let points = points.map(|(k, seeds)| Point::mean_of(1000.0 * k as f64, seeds)).collect();
/// let axes = Axes::new("Learning curve", "actions", "captures");
/// let picture = line_chart(&axes, &[Line::new("level 1", points)])?;
/// assert!(picture.svg.starts_with("<svg"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn line_chart(axes: &Axes, lines: &[Line]) -> Result<Picture, FigureError> {
    let lines: Vec<Line> = lines.iter().map(finite_part).collect();
    let points = || lines.iter().flat_map(|line| &line.points);
    let heights = points().flat_map(|point| {
        let (low, high) = point.band.unwrap_or((point.y, point.y));
        [low, point.y, high]
    });
    let none = || FigureError("no line has a finite point".to_owned());
    let x = axes
        .x_range
        .or_else(|| fitted(points().map(|point| point.x), 0.0));
    let (left, right) = x.ok_or_else(none)?;
    let y = axes.y_range.or_else(|| fitted(heights, 0.05));
    let (bottom, top) = y.ok_or_else(none)?;
    if !(left < right && bottom < top) {
        return Err(FigureError("an axis has no extent".to_owned()));
    }
    picture(axes.size, |page| {
        let crowded = lines.len() > CROWD;
        let width = axes.size.0 - if crowded { SIDE } else { 0 };
        let (plot, side) = page.split_horizontally(width);
        let mut chart = ChartBuilder::on(&plot)
            .caption(&axes.title, ("sans-serif", TITLE))
            .margin(12)
            .margin_right(24)
            .x_label_area_size(48)
            .y_label_area_size(64)
            .build_cartesian_2d(left..right, bottom..top)?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_label_formatter(&tick)
            .x_desc(&axes.x_label)
            .y_label_formatter(&tick)
            .y_desc(&axes.y_label)
            .axis_desc_style(("sans-serif", LABEL))
            .label_style(("sans-serif", SMALL))
            .draw()?;
        for (line, colour) in coloured(&lines) {
            if let Some(outline) = band(line) {
                chart.draw_series(std::iter::once(Polygon::new(outline, colour.mix(0.2))))?;
            }
            let points: Vec<(f64, f64)> = line.points.iter().map(|p| (p.x, p.y)).collect();
            let drawn = match line.mark {
                Mark::Solid => {
                    chart.draw_series(LineSeries::new(points, colour.stroke_width(2)))?
                }
                Mark::Dashed => chart.draw_series(DashedLineSeries::new(
                    points,
                    7,
                    5,
                    colour.stroke_width(2),
                ))?,
            };
            let dashed = line.mark == Mark::Dashed;
            drawn.label(&line.label).legend(move |(x, y)| {
                let end = if dashed { x + 9 } else { x + 22 };
                PathElement::new(vec![(x, y), (end, y)], colour.stroke_width(2))
            });
        }
        if crowded {
            return beside(&side, &lines);
        }
        if lines.len() > 1 {
            chart
                .configure_series_labels()
                .position(emptiest_corner(&lines, (left, right), (bottom, top)))
                .margin(10)
                .legend_area_size(30)
                .background_style(WHITE.mix(0.85))
                .border_style(BLACK.mix(0.3))
                .label_font(("sans-serif", SMALL))
                .draw()?;
        }
        Ok(())
    })
}

/// Lines from which on the legend has no room within the axes.
const CROWD: usize = 6;
/// Width of a legend beside the axes, pixels.
const SIDE: u32 = 240;

fn coloured(lines: &[Line]) -> impl Iterator<Item = (&Line, RGBColor)> {
    let mut solid = 0;
    lines.iter().map(move |line| match line.mark {
        Mark::Dashed => (line, BLACK),
        Mark::Solid => {
            solid += 1;
            (line, palette::category(solid - 1))
        }
    })
}

/// The legend in an area of its own.
fn beside(area: &Canvas<'_>, lines: &[Line]) -> Drawing {
    for (row, (line, colour)) in coloured(lines).enumerate() {
        let y = 60 + 24 * row as i32;
        let end = if line.mark == Mark::Dashed { 9 } else { 22 };
        area.draw(&PathElement::new(
            [(0, y), (end, y)],
            colour.stroke_width(2),
        ))?;
        let font = ("sans-serif", SMALL).into_font().color(&BLACK);
        area.draw(&Text::new(line.label.clone(), (30, y - 7), font))?;
    }
    Ok(())
}

/// ROC curves from scores of positives and negatives; the label gets the area under the curve.
///
/// # Errors
/// [`FigureError`] when a curve has no positives or no negatives.
///
/// ```
/// use host_sim::report::figure::roc;
/// let picture = roc("Overload", &[("total activation", &[0.9, 0.7], &[0.8, 0.1])])?;
/// assert!(picture.svg.contains("total activation (AUC 0.750)"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn roc(title: &str, curves: &[(&str, &[f64], &[f64])]) -> Result<Picture, FigureError> {
    let mut lines = vec![Line {
        label: "chance".to_owned(),
        points: vec![Point::at(0.0, 0.0), Point::at(1.0, 1.0)],
        mark: Mark::Dashed,
    }];
    for (label, positives, negatives) in curves {
        if positives.is_empty() || negatives.is_empty() {
            return Err(FigureError(format!("{label}: nothing to tell apart")));
        }
        let (points, area) = roc_points(positives, negatives);
        lines.push(Line::new(&format!("{label} (AUC {area:.3})"), points));
    }
    let axes = Axes::new(title, "false alarms", "hits");
    line_chart(&axes.x(0.0, 1.0).y(0.0, 1.0).sized(560, 560), &lines)
}

/// The curve from (0, 0) to (1, 1), one point a distinct score, and the area under it.
fn roc_points(positives: &[f64], negatives: &[f64]) -> (Vec<Point>, f64) {
    let mut scores: Vec<(f64, bool)> = positives.iter().map(|&score| (score, true)).collect();
    scores.extend(negatives.iter().map(|&score| (score, false)));
    scores.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (mut hits, mut alarms, mut area) = (0.0, 0.0, 0.0);
    let mut points = vec![Point::at(0.0, 0.0)];
    for tied in scores.chunk_by(|a, b| a.0 == b.0) {
        let (before, start) = (hits, alarms);
        for &(_, positive) in tied {
            if positive {
                hits += 1.0 / positives.len() as f64;
            } else {
                alarms += 1.0 / negatives.len() as f64;
            }
        }
        area += (alarms - start) * (hits + before) / 2.0;
        points.push(Point::at(alarms, hits));
    }
    (points, area)
}

fn finite_part(line: &Line) -> Line {
    let finite = |point: &&Point| point.x.is_finite() && point.y.is_finite();
    Line {
        points: line.points.iter().filter(finite).copied().collect(),
        ..line.clone()
    }
}

/// The outline of the band: its upper edge to the right, its lower edge back.
fn band(line: &Line) -> Option<Vec<(f64, f64)>> {
    let edge = |point: &Point| point.band.map(|(low, high)| (point.x, low, high));
    let edges: Option<Vec<(f64, f64, f64)>> = line.points.iter().map(edge).collect();
    let edges = edges.filter(|edges| edges.len() > 1)?;
    let upper = edges.iter().map(|&(x, _, high)| (x, high));
    let lower = edges.iter().rev().map(|&(x, low, _)| (x, low));
    Some(upper.chain(lower).collect())
}

/// Where the legend hides the fewest points.
fn emptiest_corner(lines: &[Line], x: (f64, f64), y: (f64, f64)) -> SeriesLabelPosition {
    use SeriesLabelPosition::{LowerLeft, LowerRight, UpperLeft, UpperRight};
    let corners = [
        (LowerRight, true, false),
        (UpperLeft, false, true),
        (UpperRight, true, true),
        (LowerLeft, false, false),
    ];
    let share = |value: f64, (from, to): (f64, f64)| (value - from) / (to - from);
    let hidden = |right: bool, up: bool| {
        let points = lines.iter().flat_map(|line| &line.points);
        let inside = points.filter(|point| {
            let (across, height) = (share(point.x, x), share(point.y, y));
            (if right { across > 0.55 } else { across < 0.45 })
                && (if up { height > 0.65 } else { height < 0.35 })
        });
        inside.count()
    };
    let mut best = (usize::MAX, LowerRight);
    for (corner, right, up) in corners {
        let count = hidden(right, up);
        if count < best.0 {
            best = (count, corner);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::roc_points;

    #[test]
    fn the_area_counts_a_tie_as_half() {
        let area = |positives: &[f64], negatives: &[f64]| roc_points(positives, negatives).1;
        assert_eq!(area(&[2.0, 3.0], &[0.0, 1.0]), 1.0);
        assert_eq!(area(&[0.0, 1.0], &[2.0, 3.0]), 0.0);
        assert_eq!(area(&[1.0, 1.0], &[1.0, 1.0]), 0.5);
        assert_eq!(area(&[2.0, 1.0], &[1.0, 0.0]), 0.875);
    }
}

//! Line charts with bands, and ROC curves; every line is named where it ends.

use plotters::style::text_anchor::VPos;

use super::plot::{Plot, Scales};
use super::point::Point;
use super::strokes::{Place, Stroke};
use super::text::{Pen, leading, width, wrapped};
use super::{Area, Axes, Canvas, Drawing, FigureError, LABEL, Picture, SMALL, picture};
/// Whether a line is one of several measured ones, or what they are compared with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Measured: a colour, dashes and marks of its own.
    Solid,
    /// Black dashes: for references such as the book's numbers.
    Dashed,
}

/// A labelled line; points that are not finite are left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Its name, which stands at its end.
    pub label: String,
    /// The points, from left to right.
    pub points: Vec<Point>,
    /// How it is drawn.
    pub mark: Mark,
}

impl Line {
    /// A measured line.
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

    pub(super) fn finite(&self) -> Self {
        let finite = |point: &&Point| point.x.is_finite() && point.y.is_finite();
        Self {
            points: self.points.iter().filter(finite).copied().collect(),
            ..self.clone()
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

/// Lines over a common horizontal axis, each with its name at its end.
///
/// Up to three measured lines have bands; those of more would hide each other, and are error bars.
///
/// # Errors
/// [`FigureError`] when no point is finite or a given range is empty.
///
/// ```
/// use host_sim::report::figure::{Axes, Line, Point, line_chart};
/// let captures = [[1.0, 2.0, 1.0], [9.0, 12.0, 11.0], [19.0, 20.0, 22.0]];
/// let points = captures.iter().enumerate();
/// let points = points.map(|(k, seeds)| Point::mean_of(1000.0 * k as f64, seeds)).collect();
/// let axes = Axes::new("Learning curve", "actions", "captures").caption("n = 3; band: 95 %");
/// let picture = line_chart(&axes, &[Line::new("level 1", points)])?;
/// assert!(picture.svg.starts_with("<svg"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn line_chart(axes: &Axes, lines: &[Line]) -> Result<Picture, FigureError> {
    let lines: Vec<Line> = lines.iter().map(Line::finite).collect();
    let scales = Scales::of(axes, lines.iter().flat_map(|line| &line.points))?;
    let drawn = picture(axes, |page, area| chart(page, area, axes, scales, &lines))?;
    drawn.with_points(axes, lines.iter())
}

/// Widest name at the end of a line.
const NAME: i32 = 200;
/// The sample of a line before its name.
const SAMPLE: i32 = 30;

fn chart(page: &Canvas<'_>, area: Area, axes: &Axes, scales: Scales, lines: &[Line]) -> Drawing {
    let names: Vec<Vec<String>> = lines
        .iter()
        .map(|line| wrapped(&line.label, SMALL, NAME))
        .collect();
    let alone = lines.len() == 1;
    let widest = names.iter().flatten().map(|it| width(it, SMALL)).max();
    let side = match widest {
        Some(widest) if !alone => widest + SAMPLE + 34,
        _ => 0,
    };
    Pen::new(SMALL).write(page, &axes.y_label, (area.left, area.top))?;
    let foot = if axes.x_label.is_empty() { 0 } else { 24 };
    let around = Area {
        top: area.top + 26,
        right: area.right - side.max(24),
        bottom: area.bottom - foot,
        ..area
    };
    let plot = Plot::draw(page, around, scales)?;
    let middle = f64::midpoint(f64::from(plot.inner.left), f64::from(plot.inner.right));
    Pen::new(LABEL)
        .across(plotters::style::text_anchor::HPos::Center)
        .write(page, &axes.x_label, (middle as i32, around.bottom + 4))?;
    let strokes = strokes(lines);
    let measured = lines.iter().filter(|it| it.mark == Mark::Solid).count();
    let drawn = || lines.iter().zip(&strokes);
    let mut aside = -(measured as i32);
    for (line, stroke) in drawn() {
        if measured <= 3 {
            plot.band(&line.points, stroke.colour)?;
        } else {
            plot.whiskers(&line.points, *stroke, aside)?;
            aside += 2;
        }
    }
    for (line, stroke) in drawn() {
        plot.line(&line.points, *stroke)?;
    }
    if alone {
        return Ok(());
    }
    let ends: Vec<Option<Place>> = lines
        .iter()
        .map(|line| line.points.last().map(|it| plot.place(it.x, it.y)))
        .collect();
    let heights: Vec<i32> = names
        .iter()
        .map(|lines| lines.len().max(1) as i32 * leading(SMALL))
        .collect();
    let places = apart(&ends, &heights, (around.top, area.bottom));
    let left = plot.inner.right + 26;
    for (index, (end, y)) in ends.iter().zip(places).enumerate() {
        let Some(end) = *end else { continue };
        let middle = y + leading(SMALL) / 2 - 2;
        let leader = [(end.0 + 5, end.1), (left - 4, middle)];
        Stroke::leader().line(page, &leader)?;
        let stroke = strokes[index];
        stroke.line(page, &[(left, middle), (left + SAMPLE - 6, middle)])?;
        stroke.mark(page, (left + SAMPLE / 2 - 3, middle))?;
        let pen = Pen::new(SMALL).down(VPos::Top);
        pen.lines(page, &names[index], (left + SAMPLE, y))?;
    }
    Ok(())
}

fn strokes(lines: &[Line]) -> Vec<Stroke> {
    let mut measured = 0;
    let stroke = |line: &Line| match line.mark {
        Mark::Dashed => Stroke::reference(),
        Mark::Solid => {
            measured += 1;
            Stroke::of(measured - 1)
        }
    };
    lines.iter().map(stroke).collect()
}

/// The upper ends of names beside the ends of their lines, moved so that none covers another.
fn apart(ends: &[Option<Place>], heights: &[i32], (top, bottom): (i32, i32)) -> Vec<i32> {
    let mut order: Vec<usize> = (0..ends.len()).filter(|&it| ends[it].is_some()).collect();
    order.sort_by_key(|&it| ends[it].map_or(0, |end| end.1));
    let mut places = vec![0; ends.len()];
    let mut free = top;
    for &it in &order {
        let wanted = ends[it].map_or(0, |end| end.1) - heights[it] / 2;
        places[it] = wanted.max(free);
        free = places[it] + heights[it] + 3;
    }
    let mut limit = bottom;
    for &it in order.iter().rev() {
        places[it] = places[it].min(limit - heights[it]);
        limit = places[it] - 3;
    }
    places
}

/// ROC curves from scores of positives and negatives; the label gets the area under the curve.
///
/// # Errors
/// [`FigureError`] when a curve has no positives or no negatives.
///
/// ```
/// use host_sim::report::figure::{Axes, roc};
/// let axes = Axes::new("Overload", "false alarms", "hits");
/// let picture = roc(&axes, &[("total activation", &[0.9, 0.7], &[0.8, 0.1])])?;
/// assert!(picture.svg.contains("area .750"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn roc(axes: &Axes, curves: &[(&str, &[f64], &[f64])]) -> Result<Picture, FigureError> {
    let mut lines = Vec::new();
    for (label, positives, negatives) in curves {
        if positives.is_empty() || negatives.is_empty() {
            return Err(FigureError(format!("{label}: nothing to tell apart")));
        }
        let (points, area) = roc_points(positives, negatives);
        let area = format!("{area:.3}");
        let area = area.strip_prefix('0').unwrap_or(&area);
        lines.push(Line::new(&format!("{label}, area {area}"), points));
    }
    lines.push(Line {
        label: "chance".to_owned(),
        points: vec![Point::at(0.0, 0.0), Point::at(1.0, 1.0)],
        mark: Mark::Dashed,
    });
    line_chart(
        &axes.clone().x(0.0, 1.0).y(0.0, 1.0).sized(800, 600),
        &lines,
    )
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

#[cfg(test)]
mod tests {
    use super::{apart, roc_points};

    #[test]
    fn the_area_counts_a_tie_as_half() {
        let area = |positives: &[f64], negatives: &[f64]| roc_points(positives, negatives).1;
        assert_eq!(area(&[2.0, 3.0], &[0.0, 1.0]), 1.0);
        assert_eq!(area(&[0.0, 1.0], &[2.0, 3.0]), 0.0);
        assert_eq!(area(&[1.0, 1.0], &[1.0, 1.0]), 0.5);
        assert_eq!(area(&[2.0, 1.0], &[1.0, 0.0]), 0.875);
    }

    #[test]
    fn names_of_lines_that_end_together_stand_below_each_other() {
        let ends = [Some((0, 100)), None, Some((0, 102)), Some((0, 101))];
        let places = apart(&ends, &[16, 16, 16, 32], (0, 140));
        let mut order = [places[0], places[3], places[2]];
        assert!(order[0] + 16 <= order[1] && order[1] + 32 <= order[2]);
        assert!(order[2] + 16 <= 140, "{order:?}");
        order.sort_unstable();
        assert_eq!(order, [places[0], places[3], places[2]]);
    }
}

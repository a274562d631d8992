//! One pair of axes in a part of the page: grid, numbers, lines with their bands.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::point::Point;
use super::scale::{Scale, label};
use super::strokes::{Place, Stroke};
use super::text::{Pen, width};
use super::{Area, Axes, Canvas, Drawing, FigureError, SMALL, fitted};

/// Both scales of a chart.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scales {
    pub(super) x: Scale,
    pub(super) y: Scale,
}

impl Scales {
    /// Those that were asked for, or that show all points and their bands.
    pub(super) fn of<'a>(
        axes: &Axes,
        points: impl Iterator<Item = &'a Point> + Clone,
    ) -> Result<Self, FigureError> {
        let error = |what: &str| FigureError(what.to_owned());
        let heights = points.clone().flat_map(|point| {
            let (low, high) = point.band.unwrap_or((point.y, point.y));
            [low, point.y, high]
        });
        // What is not positive has no place on an axis of factors.
        let placed = |log: bool| move |it: &f64| !log || *it > 0.0;
        let air = if axes.y_log { 0.0 } else { 0.05 };
        let x = axes
            .x_range
            .or_else(|| fitted(points.map(|it| it.x).filter(placed(axes.x_log)), 0.0));
        let y = axes
            .y_range
            .or_else(|| fitted(heights.filter(placed(axes.y_log)), air));
        let (Some(x), Some(y)) = (x, y) else {
            return Err(error("no line has a finite point"));
        };
        // Around a number alone the axis goes from its half to its double.
        let y = match y {
            (low, high) if axes.y_log && low == high => (low / 2.0, high * 2.0),
            other => other,
        };
        let scales = (Scale::new(x, axes.x_log), Scale::new(y, axes.y_log));
        let (Some(x), Some(y)) = scales else {
            return Err(error("an axis has no extent"));
        };
        Ok(Self { x, y })
    }
}

/// Axes in their place.
pub(super) struct Plot<'p, 'a> {
    page: &'p Canvas<'a>,
    /// What the axes enclose.
    pub(super) inner: Area,
    scales: Scales,
}

/// Units between two numbers at an axis, at least.
const APART: (i32, i32) = (74, 34);

impl<'p, 'a> Plot<'p, 'a> {
    /// Draws grid and numbers around the place that they leave.
    pub(super) fn draw(
        page: &'p Canvas<'a>,
        area: Area,
        scales: Scales,
    ) -> Result<Self, Box<dyn std::error::Error>> {
        let heights = scales.y.ticks((area.height() / APART.1).max(2) as usize);
        let widest = heights.iter().map(|&it| width(&label(it), SMALL)).max();
        let inner = Area {
            left: area.left + widest.unwrap_or(0) + 10,
            top: area.top,
            right: area.right,
            bottom: area.bottom - 24,
        };
        let plot = Self {
            page,
            inner,
            scales,
        };
        let grid = RGBColor(0xDC, 0xDC, 0xDC).stroke_width(1);
        for value in heights {
            let y = plot.height(value);
            page.draw(&PathElement::new([(inner.left, y), (inner.right, y)], grid))?;
            let pen = Pen::new(SMALL).across(HPos::Right).down(VPos::Center);
            pen.write(page, &label(value), (inner.left - 7, y))?;
        }
        plot.horizontal()?;
        Ok(plot)
    }

    /// As [`draw`](Self::draw), with numbers at the horizontal axis alone, whose grid is upright.
    pub(super) fn upright_only(
        page: &'p Canvas<'a>,
        area: Area,
        scales: Scales,
    ) -> Result<Self, Box<dyn std::error::Error>> {
        let inner = Area {
            left: area.left + 10,
            bottom: area.bottom - 24,
            ..area
        };
        let plot = Self {
            page,
            inner,
            scales,
        };
        let grid = RGBColor(0xDC, 0xDC, 0xDC).stroke_width(1);
        for value in scales.x.ticks((inner.width() / APART.0).max(2) as usize) {
            let x = plot.across(value);
            page.draw(&PathElement::new([(x, inner.top), (x, inner.bottom)], grid))?;
        }
        plot.horizontal()?;
        Ok(plot)
    }

    /// Both axes, and the numbers of the horizontal one.
    fn horizontal(&self) -> Drawing {
        let Self {
            page,
            inner,
            scales,
        } = self;
        let axis = RGBColor(0x55, 0x55, 0x55).stroke_width(1);
        let corner = (inner.left, inner.bottom);
        let path = [(inner.left, inner.top), corner, (inner.right, inner.bottom)];
        page.draw(&PathElement::new(path, axis))?;
        for value in scales.x.ticks((inner.width() / APART.0).max(2) as usize) {
            let x = self.across(value);
            let down = inner.bottom;
            page.draw(&PathElement::new([(x, down), (x, down + 5)], axis))?;
            let text = label(value);
            // A number at the end of the axis may reach beyond it, but not off the page.
            let half = width(&text, SMALL) / 2;
            let most = page.dim_in_pixel().0 as i32 - half - 2;
            let at = (x.min(most), down + 8);
            Pen::new(SMALL)
                .across(HPos::Center)
                .write(page, &text, at)?;
        }
        Ok(())
    }

    fn across(&self, x: f64) -> i32 {
        let along = self.scales.x.share(x) * f64::from(self.inner.width());
        self.inner.left + along.round() as i32
    }

    fn height(&self, y: f64) -> i32 {
        let along = self.scales.y.share(y) * f64::from(self.inner.height());
        self.inner.bottom - along.round() as i32
    }

    /// Where a point lies; what is beyond an axis lies at its end.
    pub(super) fn place(&self, x: f64, y: f64) -> Place {
        (self.across(x), self.height(y))
    }

    /// The band of a line, from point to point.
    pub(super) fn band(&self, points: &[Point], colour: RGBColor) -> Drawing {
        let ends = |it: &Point| it.band.map(|(low, high)| (it.x, low, high));
        let ends: Option<Vec<_>> = points.iter().map(ends).collect();
        let Some(ends) = ends.filter(|it| it.len() > 1) else {
            return Ok(());
        };
        let upper = ends.iter().map(|&(x, _, high)| self.place(x, high));
        let lower = ends.iter().rev().map(|&(x, low, _)| self.place(x, low));
        let outline: Vec<Place> = upper.chain(lower).collect();
        self.page.draw(&Polygon::new(outline, colour.mix(0.2)))?;
        Ok(())
    }

    /// The ends of each point's band, as an error bar moved aside so that several can be told apart.
    pub(super) fn whiskers(&self, points: &[Point], stroke: Stroke, aside: i32) -> Drawing {
        for point in points {
            let Some((low, high)) = point.band else {
                continue;
            };
            let (x, from) = self.place(point.x, low);
            let (_, to) = self.place(point.x, high);
            let x = x + aside;
            let thin = stroke.colour.stroke_width(1);
            self.page
                .draw(&PathElement::new([(x, from), (x, to)], thin))?;
            for end in [from, to] {
                let path = [(x - 3, end), (x + 3, end)];
                self.page.draw(&PathElement::new(path, thin))?;
            }
        }
        Ok(())
    }

    /// A line with the marks at its points.
    pub(super) fn line(&self, points: &[Point], stroke: Stroke) -> Drawing {
        let path: Vec<Place> = points.iter().map(|it| self.place(it.x, it.y)).collect();
        stroke.line(self.page, &path)?;
        // Marks that would touch each other are no marks.
        let room = self.inner.width() / 14;
        let mut last = i32::MIN / 2;
        for &(x, y) in &path {
            if x - last >= room {
                stroke.mark(self.page, (x, y))?;
                last = x;
            }
        }
        Ok(())
    }

    /// An upright line from the bottom to the top.
    pub(super) fn upright(&self, x: f64, stroke: Stroke) -> Drawing {
        let x = self.across(x);
        stroke.line(self.page, &[(x, self.inner.bottom), (x, self.inner.top)])
    }
}

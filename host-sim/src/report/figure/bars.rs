//! Bars with their errors, ours beside the number that they are compared with.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};

use super::scale::{Scale, label};
use super::text::{DIM, Pen, leading, width, wrapped};
use super::{
    Area, Axes, Canvas, Drawing, FigureError, LABEL, MARGIN, Picture, SMALL, fitted, palette,
    picture,
};
use crate::report::{mean, sample_sd};

/// A bar, with the number to compare it with where there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Below the bar.
    pub label: String,
    /// Its height; not finite where nothing was measured.
    pub value: f64,
    /// Half the length of its error bar.
    pub error: Option<f64>,
    /// What it is compared with, as a bar beside it, and half the length of that one's error bar.
    pub reference: Option<(f64, Option<f64>)>,
}

impl Bar {
    /// A bar without an error bar.
    #[must_use]
    pub fn new(label: &str, value: f64) -> Self {
        Self {
            label: label.to_owned(),
            value,
            error: None,
            reference: None,
        }
    }

    /// The mean of the seeds with their standard deviation as the error bar.
    #[must_use]
    pub fn mean_of(label: &str, seeds: &[f64]) -> Self {
        Self {
            error: Some(sample_sd(seeds)).filter(|it| it.is_finite()),
            ..Self::new(label, mean(seeds))
        }
    }

    /// Adds the number to compare with.
    #[must_use]
    pub const fn beside(mut self, reference: f64) -> Self {
        self.reference = Some((reference, None));
        self
    }

    /// Adds the number to compare with, and its deviation.
    #[must_use]
    pub const fn beside_with(mut self, reference: f64, deviation: f64) -> Self {
        self.reference = Some((reference, Some(deviation)));
        self
    }

    /// Where the bar and what stands beside it end, with their errors.
    fn ends(&self) -> [f64; 4] {
        let error = self.error.unwrap_or(0.0);
        let (beside, beside_error) = self.reference.unwrap_or((f64::NAN, None));
        let beside_error = beside_error.unwrap_or(0.0);
        [
            self.value - error,
            self.value + error,
            beside - beside_error,
            beside + beside_error,
        ]
    }
}

/// One bar a label, from 0, with its number; ours are full, those beside them hatched.
///
/// `names` says what the full and the hatched bars are.
///
/// # Errors
/// [`FigureError`] without a bar of finite height.
///
/// ```
/// use host_sim::report::figure::{Axes, Bar, bar_chart};
/// let bars = [Bar::mean_of("level 1", &[27.0, 28.0]).beside(20.4), Bar::new("random", 3.0)];
/// let axes = Axes::new("Captures", "", "captures in 3000 actions");
/// let picture = bar_chart(&axes, ["ours", "book"], &bars)?;
/// assert!(picture.svg.contains("level 1") && picture.svg.contains("20.4"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn bar_chart(axes: &Axes, names: [&str; 2], bars: &[Bar]) -> Result<Picture, FigureError> {
    bar_charts(axes, names, &[(axes.y_label.as_str(), bars)])
}

/// Charts of bars side by side, each with its own unit and scale.
///
/// # Errors
/// As [`bar_chart`].
pub fn bar_charts(
    axes: &Axes,
    names: [&str; 2],
    charts: &[(&str, &[Bar])],
) -> Result<Picture, FigureError> {
    let scales: Option<Vec<Scale>> = charts.iter().map(|(_, bars)| scale(axes, bars)).collect();
    let scales = scales.filter(|it| !it.is_empty());
    let scales = scales.ok_or_else(|| FigureError("no bar has a height".to_owned()))?;
    picture(axes, |page, area| {
        let foot = if axes.x_label.is_empty() { 0 } else { 24 };
        Pen::new(LABEL)
            .across(HPos::Center)
            .down(VPos::Bottom)
            .write(
                page,
                &axes.x_label,
                ((area.left + area.right) / 2, area.bottom),
            )?;
        let beside = charts.iter().flat_map(|(_, bars)| *bars);
        let top = if beside.clone().any(|it| it.reference.is_some()) {
            key(page, area, names)?;
            area.top + 26
        } else {
            area.top
        };
        // Bars of all charts are equally wide.
        let most = beside.count().max(1) as i32;
        let gaps = MARGIN * 2 * (charts.len() as i32 - 1);
        let mut left = area.left;
        for ((unit, bars), scale) in charts.iter().zip(&scales) {
            let room = (area.width() - gaps) * bars.len() as i32 / most;
            let part = Area {
                left,
                top,
                right: left + room,
                bottom: area.bottom - foot,
            };
            chart(page, part, unit, bars, *scale)?;
            left = part.right + 2 * MARGIN;
        }
        Ok(())
    })
}

fn scale(axes: &Axes, bars: &[Bar]) -> Option<Scale> {
    let (low, high) = fitted(bars.iter().flat_map(Bar::ends), 0.0)?;
    let (low, high) = (low.min(0.0), high.max(0.0));
    // Room for a number above the highest bar.
    let air = 0.12 * if high > low { high - low } else { 1.0 };
    let fit = (if low < 0.0 { low - air } else { 0.0 }, high + air);
    Scale::new(axes.y_range.unwrap_or(fit), false)
}

/// What the full and the hatched bars are.
fn key(page: &Canvas<'_>, area: Area, [full, hatched]: [&str; 2]) -> Drawing {
    let mut left = area.right - width(full, SMALL) - width(hatched, SMALL) - 84;
    for (name, ours) in [(full, true), (hatched, false)] {
        let corners = [(left, area.top + 1), (left + 22, area.top + 15)];
        column(page, corners, ours)?;
        Pen::new(SMALL).write(page, name, (left + 30, area.top))?;
        left += width(name, SMALL) + 52;
    }
    Ok(())
}

fn chart(page: &Canvas<'_>, area: Area, unit: &str, bars: &[Bar], scale: Scale) -> Drawing {
    let unit = wrapped(unit, SMALL, area.width());
    Pen::new(SMALL).lines(page, &unit, (area.left, area.top))?;
    let top = area.top + unit.len() as i32 * leading(SMALL) + 8;
    let ticks = scale.ticks(6);
    let widest = ticks.iter().map(|&it| width(&label(it), SMALL)).max();
    let left = area.left + widest.unwrap_or(0) + 10;
    let room = (area.right - left) / bars.len().max(1) as i32;
    let names: Vec<Vec<String>> = bars
        .iter()
        .map(|bar| wrapped(&bar.label, SMALL, room - 8))
        .collect();
    let most = names.iter().map(Vec::len).max().unwrap_or(1) as i32;
    let bottom = area.bottom - most * leading(SMALL) - 8;
    let height =
        |value: f64| bottom - (scale.share(value) * f64::from(bottom - top)).round() as i32;
    let grid = RGBColor(0xDC, 0xDC, 0xDC).stroke_width(1);
    for value in ticks {
        let y = height(value);
        page.draw(&PathElement::new([(left, y), (area.right, y)], grid))?;
        let pen = Pen::new(SMALL).across(HPos::Right).down(VPos::Center);
        pen.write(page, &label(value), (left - 7, y))?;
    }
    for (index, (bar, name)) in bars.iter().zip(&names).enumerate() {
        let middle = left + room * index as i32 + room / 2;
        let half = if bar.reference.is_some() {
            room * 3 / 16
        } else {
            room / 4
        };
        let half = half.clamp(3, 44);
        let mut place = if bar.reference.is_some() {
            middle - half
        } else {
            middle
        };
        let ours = bar
            .value
            .is_finite()
            .then_some((bar.value, bar.error, true));
        let beside = bar.reference.map(|(value, error)| (value, error, false));
        if ours.is_none() {
            let pen = Pen::new(SMALL)
                .dim()
                .across(HPos::Center)
                .down(VPos::Bottom);
            pen.write(page, "no value", (place, height(0.0) - 4))?;
            place += 2 * half + 2;
        }
        for (value, error, ours) in ours.into_iter().chain(beside) {
            let (from, to) = (height(value.max(0.0)), height(value.min(0.0)));
            column(
                page,
                [(place - half + 1, from), (place + half - 1, to)],
                ours,
            )?;
            let mut end = if value < 0.0 { to } else { from };
            if let Some(error) = error {
                let ends = [height(value + error), height(value - error)];
                whisker(page, place, ends)?;
                end = if value < 0.0 { ends[1] } else { ends[0] };
            }
            let number = short(value);
            let pen = Pen::new(SMALL).across(HPos::Center);
            if value < 0.0 {
                pen.write(page, &number, (place, end + 5))?;
            } else {
                pen.down(VPos::Bottom)
                    .write(page, &number, (place, end - 5))?;
            }
            place += 2 * half + 2;
        }
        for (row, line) in name.iter().enumerate() {
            let y = bottom + 8 + row as i32 * leading(SMALL);
            Pen::new(SMALL)
                .across(HPos::Center)
                .write(page, line, (middle, y))?;
        }
    }
    let axis = RGBColor(0x55, 0x55, 0x55).stroke_width(1);
    page.draw(&PathElement::new(
        [(left, height(0.0)), (area.right, height(0.0))],
        axis,
    ))?;
    Ok(())
}

/// A full bar, or a hatched one.
fn column(page: &Canvas<'_>, corners: [(i32, i32); 2], full: bool) -> Drawing {
    let [(left, top), (right, bottom)] = corners;
    if full {
        let colour = palette::category(0).filled();
        page.draw(&Rectangle::new(corners, colour))?;
        return Ok(());
    }
    page.draw(&Rectangle::new(corners, WHITE.filled()))?;
    // Lines that rise by as much as they go aside, cut off at the frame.
    let mut start = top - (right - left);
    start -= start.rem_euclid(HATCH);
    while start < bottom {
        let from = (left.max(left + top - start), start.max(top));
        let reach = (right - from.0).min(bottom - from.1);
        if reach > 0 {
            let path = [from, (from.0 + reach, from.1 + reach)];
            page.draw(&PathElement::new(path, DIM.stroke_width(1)))?;
        }
        start += HATCH;
    }
    page.draw(&Rectangle::new(corners, DIM.stroke_width(1)))?;
    Ok(())
}

/// From one line of the hatching to the next.
const HATCH: i32 = 6;

fn whisker(page: &Canvas<'_>, x: i32, [from, to]: [i32; 2]) -> Drawing {
    let paths = [
        [(x, from), (x, to)],
        [(x - 4, from), (x + 4, from)],
        [(x - 4, to), (x + 4, to)],
    ];
    for path in paths {
        page.draw(&PathElement::new(path, BLACK.stroke_width(2)))?;
    }
    Ok(())
}

/// A number at a bar: three digits are enough there.
fn short(value: f64) -> String {
    let size = value.abs();
    let decimals = match size {
        100.0.. => 0,
        10.0.. => 1,
        _ => 2,
    };
    let text = format!("{size:.decimals$}");
    let text = text
        .strip_prefix("0.")
        .map_or(text.clone(), |part| format!(".{part}"));
    if value < 0.0 {
        format!("−{text}")
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::{Bar, bar_chart, short};
    use crate::report::figure::Axes;

    #[test]
    fn numbers_at_bars_are_short() {
        for (value, text) in [
            (0.405, ".41"),
            (27.95, "27.9"),
            (303.4, "303"),
            (-0.5, "−.50"),
        ] {
            assert_eq!(short(value), text);
        }
    }

    #[test]
    fn what_was_not_measured_has_no_bar_and_the_other_has() {
        let axes = Axes::new("t", "", "u");
        let bars = [
            Bar::new("a", f64::NAN).beside_with(0.7, 0.1),
            Bar::new("b", -1.0),
        ];
        let picture = bar_chart(&axes, ["ours", "book"], &bars).unwrap();
        assert!(picture.svg.contains(".70") && picture.svg.contains("−1.00"));
        assert!(bar_chart(&axes, ["ours", "book"], &[Bar::new("a", f64::NAN)]).is_err());
    }
}

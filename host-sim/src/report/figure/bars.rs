//! Bar charts with error bars, and histograms.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{Axes, FigureError, LABEL, Picture, SMALL, TITLE, fitted, palette, picture, tick};
use crate::report::{mean, sample_sd};

/// A bar, with the number to compare it with where there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Below the bar.
    pub label: String,
    /// Its height.
    pub value: f64,
    /// Half the length of its error bar.
    pub error: Option<f64>,
    /// The number to compare it with: a stroke across the bar.
    pub reference: Option<f64>,
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
            error: Some(sample_sd(seeds)),
            ..Self::new(label, mean(seeds))
        }
    }

    /// Adds the number to compare with.
    #[must_use]
    pub const fn beside(mut self, reference: f64) -> Self {
        self.reference = Some(reference);
        self
    }
}

/// One bar a label, from 0; labels are drawn slanted when they would run into each other.
///
/// # Errors
/// [`FigureError`] without a bar of finite height.
///
/// ```
/// use host_sim::report::figure::{Axes, Bar, bar_chart};
/// let bars = [Bar::mean_of("level 1", &[27.0, 28.0]).beside(20.4), Bar::new("random", 3.0)];
/// let picture = bar_chart(&Axes::new("Captures", "", "captures in 3000 actions"), &bars)?;
/// assert!(picture.svg.contains("level 1"));
/// # Ok::<(), host_sim::report::figure::FigureError>(())
/// ```
pub fn bar_chart(axes: &Axes, bars: &[Bar]) -> Result<Picture, FigureError> {
    let heights = bars.iter().flat_map(|bar| {
        let error = bar.error.filter(|error| error.is_finite()).unwrap_or(0.0);
        let reference = bar.reference.unwrap_or(bar.value);
        [bar.value - error, bar.value + error, reference]
    });
    let none = || FigureError("no bar has a height".to_owned());
    let (low, high) = fitted(heights, 0.0).ok_or_else(none)?;
    let (low, high) = (low.min(0.0), high.max(0.0));
    let air = 0.06 * if high > low { high - low } else { 1.0 };
    let fit = (if low < 0.0 { low - air } else { 0.0 }, high + air);
    let (bottom, top) = axes.y_range.unwrap_or(fit);
    let room = f64::from(axes.size.0) / bars.len() as f64;
    let longest = bars.iter().map(|bar| bar.label.chars().count()).max();
    let slanted = longest.unwrap_or(0) as f64 * 8.0 > room;
    picture(axes.size, |page| {
        let mut chart = ChartBuilder::on(page)
            .caption(&axes.title, ("sans-serif", TITLE))
            .margin(12)
            .margin_right(24)
            .x_label_area_size(if slanted { 110 } else { 52 })
            .y_label_area_size(64)
            .build_cartesian_2d(-0.6..bars.len() as f64 - 0.4, bottom..top)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_labels(0)
            .y_label_formatter(&tick)
            .y_desc(&axes.y_label)
            .axis_desc_style(("sans-serif", LABEL))
            .label_style(("sans-serif", SMALL))
            .draw()?;
        for (index, bar) in bars.iter().enumerate() {
            let x = index as f64;
            if bar.value.is_finite() {
                let corners = [(x - 0.36, 0.0), (x + 0.36, bar.value)];
                let colour = palette::category(0).mix(0.8).filled();
                chart.draw_series(std::iter::once(Rectangle::new(corners, colour)))?;
            }
            if let Some(error) = bar.error.filter(|error| error.is_finite()) {
                let (from, to) = (bar.value - error, bar.value + error);
                let strokes = [
                    [(x, from), (x, to)],
                    [(x - 0.08, from), (x + 0.08, from)],
                    [(x - 0.08, to), (x + 0.08, to)],
                ];
                let stroke = BLACK.stroke_width(1);
                chart.draw_series(strokes.map(|path| PathElement::new(path, stroke)))?;
            }
            if let Some(height) = bar.reference {
                let path = [(x - 0.44, height), (x + 0.44, height)];
                let stroke = palette::category(1).stroke_width(3);
                chart.draw_series(std::iter::once(PathElement::new(path, stroke)))?;
            }
            let (left, below) = chart.backend_coord(&(x, bottom));
            let style = TextStyle::from(("sans-serif", SMALL).into_font());
            page.draw_text(
                &bar.label,
                &if slanted {
                    style
                        .transform(FontTransform::Rotate270)
                        .pos(Pos::new(HPos::Right, VPos::Center))
                } else {
                    style.pos(Pos::new(HPos::Center, VPos::Top))
                },
                (left, below + 8),
            )?;
        }
        let style = TextStyle::from(("sans-serif", LABEL).into_font());
        let style = style.pos(Pos::new(HPos::Center, VPos::Bottom));
        let middle = (axes.size.0 as i32 / 2, axes.size.1 as i32 - 8);
        page.draw_text(&axes.x_label, &style, middle)?;
        Ok(())
    })
}

/// How many values fall in each of `bins` equal parts of the horizontal range.
///
/// Without a given range the bins span the data; values outside it, and those that are not finite,
/// are not counted; the last bin includes its right end.
///
/// # Errors
/// [`FigureError`] when there is nothing to count or no bin.
///
/// ```
/// use host_sim::report::figure::{Axes, histogram};
/// let axes = Axes::new("Reliability", "reliability", "schemas").x(0.0, 1.0);
/// assert!(histogram(&axes, &[0.1, 0.97, 1.0], 20).is_ok());
/// assert!(histogram(&axes, &[], 20).is_err());
/// ```
pub fn histogram(axes: &Axes, values: &[f64], bins: usize) -> Result<Picture, FigureError> {
    let none = || FigureError("a histogram without values or bins".to_owned());
    let fit = fitted(values.iter().copied(), 0.0).ok_or_else(none)?;
    let (left, right) = axes.x_range.unwrap_or(fit);
    let right = if right > left { right } else { left + 1.0 };
    let counts = counts(values, bins, (left, right));
    let highest = counts.iter().copied().max().ok_or_else(none)?;
    let width = (right - left) / bins as f64;
    let (bottom, top) = axes
        .y_range
        .unwrap_or((0.0, f64::from(highest.max(1)) * 1.06));
    picture(axes.size, |page| {
        let mut chart = ChartBuilder::on(page)
            .caption(&axes.title, ("sans-serif", TITLE))
            .margin(12)
            .margin_right(24)
            .x_label_area_size(48)
            .y_label_area_size(64)
            .build_cartesian_2d(left..right, bottom..top)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.12))
            .x_label_formatter(&tick)
            .x_desc(&axes.x_label)
            .y_label_formatter(&tick)
            .y_desc(&axes.y_label)
            .axis_desc_style(("sans-serif", LABEL))
            .label_style(("sans-serif", SMALL))
            .draw()?;
        chart.draw_series(counts.iter().enumerate().map(|(bin, &count)| {
            let from = left + width * (bin as f64 + 0.04);
            let to = left + width * (bin as f64 + 0.96);
            let colour = palette::category(0).mix(0.8).filled();
            Rectangle::new([(from, 0.0), (to, f64::from(count))], colour)
        }))?;
        Ok(())
    })
}

fn counts(values: &[f64], bins: usize, (left, right): (f64, f64)) -> Vec<u32> {
    let mut counts = vec![0; bins];
    for &value in values
        .iter()
        .filter(|&&value| left <= value && value <= right)
    {
        let place = (value - left) / (right - left) * bins as f64;
        let last = bins.saturating_sub(1);
        if let Some(count) = counts.get_mut((place as usize).min(last)) {
            *count += 1;
        }
    }
    counts
}

#[cfg(test)]
mod tests {
    use super::counts;

    #[test]
    fn the_right_end_belongs_to_the_last_bin_and_strangers_to_none() {
        let values = [0.0, 0.5, 1.0, 1.1, -0.1, f64::NAN];
        assert_eq!(counts(&values, 2, (0.0, 1.0)), [1, 2]);
        assert!(counts(&values, 0, (0.0, 1.0)).is_empty());
    }
}

//! Histograms of one or two samples, side by side in each bin.

use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

use super::plot::{Plot, Scales};
use super::scale::Scale;
use super::text::{Pen, width};
use super::{Area, Axes, FigureError, LABEL, Picture, SMALL, fitted, palette, picture};

/// How many values of each sample fall in each of `bins` equal parts of the horizontal range.
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
/// assert!(histogram(&axes, &[("level 1", &[0.1, 0.97, 1.0])], 20).is_ok());
/// assert!(histogram(&axes, &[("level 1", &[])], 20).is_err());
/// ```
pub fn histogram(
    axes: &Axes,
    samples: &[(&str, &[f64])],
    bins: usize,
) -> Result<Picture, FigureError> {
    let none = || FigureError("a histogram without values or bins".to_owned());
    let values = samples.iter().flat_map(|(_, values)| *values).copied();
    let (left, right) = fitted(values, 0.0).ok_or_else(none)?;
    let (left, right) = axes.x_range.unwrap_or((left, right.max(left + 1e-9)));
    let counts: Vec<Vec<u32>> = samples
        .iter()
        .map(|(_, values)| counts(values, bins, (left, right)))
        .collect();
    let highest = counts.iter().flatten().copied().max().ok_or_else(none)?;
    let height = (0.0, f64::from(highest.max(1)) * 1.06);
    let x = Scale::new((left, right), false);
    let y = Scale::new(axes.y_range.unwrap_or(height), false);
    let (Some(x), Some(y)) = (x, y) else {
        return Err(none());
    };
    picture(axes, |page, area| {
        Pen::new(SMALL).write(page, &axes.y_label, (area.left, area.top))?;
        let colours = [palette::category(5), RGBColor(0x1B, 0x3A, 0x5C)];
        let mut key = area.right;
        for ((name, _), colour) in samples.iter().zip(colours).rev() {
            key -= width(name, SMALL) + 48;
            let corners = [(key, area.top + 1), (key + 20, area.top + 15)];
            page.draw(&Rectangle::new(corners, colour.filled()))?;
            Pen::new(SMALL).write(page, name, (key + 26, area.top))?;
        }
        let around = Area {
            top: area.top + 28,
            bottom: area.bottom - 24,
            right: area.right - 16,
            ..area
        };
        let plot = Plot::draw(page, around, Scales { x, y })?;
        let bin_width = (right - left) / bins as f64;
        let part = 0.92 / samples.len().max(1) as f64;
        for (which, (counts, colour)) in counts.iter().zip(colours).enumerate() {
            for (bin, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
                let from = left + bin_width * (bin as f64 + 0.04 + part * which as f64);
                let to = from + bin_width * part;
                let corners = [plot.place(from, f64::from(count)), plot.place(to, 0.0)];
                page.draw(&Rectangle::new(corners, colour.filled()))?;
            }
        }
        let middle = (plot.inner.left + plot.inner.right) / 2;
        let pen = Pen::new(LABEL).across(HPos::Center);
        pen.write(page, &axes.x_label, (middle, around.bottom + 4))
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

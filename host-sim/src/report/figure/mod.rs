//! Figures: drawn once as SVG, and rasterized from that SVG to PNG.
//!
//! Both come out of the same drawing, and the font is compiled in: a machine without fonts makes
//! the same picture to the last pixel.
//! Colours are Okabe and Ito's, which colour-blind readers tell apart.

mod bars;
mod boards;
mod heat;
mod lines;
mod palette;

use std::sync::{Arc, Once};
use std::{error, fmt};

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea, SVGBackend};
use plotters::style::{FontStyle, WHITE, register_font};
use resvg::{tiny_skia, usvg};

pub use bars::{Bar, bar_chart, histogram};
pub use boards::{Board, board_pairs};
pub use heat::{HeatMap, heat_maps};
pub use lines::{Line, Mark, Point, Span, line_chart, roc};

/// PNG pixels to one unit of the SVG.
const PIXELS: f32 = 2.0;

/// Sizes of letters, in units of the SVG.
const TITLE: i32 = 20;
const LABEL: i32 = 15;
const SMALL: i32 = 13;

/// A finished figure in both formats.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The text of an SVG file.
    pub svg: String,
    /// The bytes of a PNG file, two pixels to one unit of the SVG.
    pub png: Vec<u8>,
}

/// A figure that could not be drawn, such as one without a finite number in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FigureError(String);

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a figure could not be drawn: {}", self.0)
    }
}

impl error::Error for FigureError {}

/// Title, labels and ranges of a chart; a range that is not given fits the data.
///
/// ```
/// use host_sim::report::figure::Axes;
/// let axes = Axes::new("Learning curve", "actions", "captures").y(0.0, 28.0);
/// assert_eq!(axes.y_range, Some((0.0, 28.0)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Above the chart.
    pub title: String,
    /// Below the horizontal axis.
    pub x_label: String,
    /// Beside the vertical axis.
    pub y_label: String,
    /// The horizontal range.
    pub x_range: Option<(f64, f64)>,
    /// The vertical range.
    pub y_range: Option<(f64, f64)>,
    /// Width and height in units of the SVG.
    pub size: (u32, u32),
}

impl Axes {
    /// Labelled axes that fit the data.
    #[must_use]
    pub fn new(title: &str, x_label: &str, y_label: &str) -> Self {
        Self {
            title: title.to_owned(),
            x_label: x_label.to_owned(),
            y_label: y_label.to_owned(),
            x_range: None,
            y_range: None,
            size: (800, 480),
        }
    }

    /// Fixes the horizontal range.
    #[must_use]
    pub const fn x(mut self, from: f64, to: f64) -> Self {
        self.x_range = Some((from, to));
        self
    }

    /// Fixes the vertical range.
    #[must_use]
    pub const fn y(mut self, from: f64, to: f64) -> Self {
        self.y_range = Some((from, to));
        self
    }

    /// Sets width and height in units of the SVG.
    #[must_use]
    pub const fn sized(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }
}

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawing = Result<(), Box<dyn error::Error>>;

/// Runs a drawing on an empty page and makes both formats of it.
fn picture(
    size: (u32, u32),
    draw: impl FnOnce(&Canvas<'_>) -> Drawing,
) -> Result<Picture, FigureError> {
    register_the_font();
    let mut svg = String::new();
    let drawn: Drawing = (|| {
        let page = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        page.fill(&WHITE)?;
        draw(&page)?;
        page.present()?;
        Ok(())
    })();
    drawn.map_err(|error| FigureError(error.to_string()))?;
    let png = rasterize(&svg).map_err(FigureError)?;
    Ok(Picture { svg, png })
}

fn register_the_font() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        for (style, font) in [
            (FontStyle::Normal, dejavu::sans::regular()),
            (FontStyle::Bold, dejavu::sans::bold()),
        ] {
            assert!(
                register_font("sans-serif", style, font).is_ok(),
                "the font that is compiled in can be read"
            );
        }
    });
}

fn rasterize(svg: &str) -> Result<Vec<u8>, String> {
    let mut fonts = usvg::fontdb::Database::new();
    fonts.load_font_source(usvg::fontdb::Source::Binary(Arc::new(
        dejavu::sans::regular(),
    )));
    fonts.set_sans_serif_family("DejaVu Sans");
    let options = usvg::Options {
        fontdb: Arc::new(fonts),
        ..usvg::Options::default()
    };
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| error.to_string())?;
    let size = tree.size().to_int_size();
    let pixels = |length: u32| (length as f32 * PIXELS).ceil() as u32;
    let mut page = tiny_skia::Pixmap::new(pixels(size.width()), pixels(size.height()))
        .ok_or_else(|| "a picture needs a width and a height".to_owned())?;
    let scale = tiny_skia::Transform::from_scale(PIXELS, PIXELS);
    resvg::render(&tree, scale, &mut page.as_mut());
    page.encode_png().map_err(|error| error.to_string())
}

/// A number on an axis, without the zeros that say nothing.
fn tick(value: &f64) -> String {
    let text = format!("{value:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" {
        return "0".to_owned();
    }
    text.to_owned()
}

/// The range of the finite values with some air around it; `None` without any.
fn fitted(values: impl Iterator<Item = f64>, air: f64) -> Option<(f64, f64)> {
    let ends = values
        .filter(|value| value.is_finite())
        .fold(None, |ends, value| match ends {
            None => Some((value, value)),
            Some((low, high)) => Some((value.min(low), value.max(high))),
        });
    let (low, high) = ends?;
    let width = if high > low { high - low } else { 1.0 };
    Some((low - air * width, high + air * width))
}

#[cfg(test)]
mod tests {
    use super::{Axes, Line, Point, line_chart};

    #[test]
    fn a_picture_has_letters_in_it_and_is_the_same_every_time() {
        let draw = |title: &str| {
            let line = Line::new(
                "ours",
                (0..5).map(|x| Point::at(f64::from(x), 2.0)).collect(),
            );
            line_chart(&Axes::new(title, "x", "y"), &[line]).unwrap()
        };
        let picture = draw("Captures & > 3");
        assert_eq!(picture, draw("Captures & > 3"));
        assert!(picture.svg.contains("Captures &amp; &gt; 3"));
        assert!(picture.png.starts_with(b"\x89PNG"));
        // Without a font both pictures would be equally blank where the title is.
        assert_ne!(picture.png, draw("").png);
    }

    #[test]
    fn a_figure_without_a_finite_number_is_an_error_and_no_panic() {
        let line = Line::new("nothing", vec![Point::at(f64::NAN, 1.0)]);
        assert!(line_chart(&Axes::new("t", "x", "y"), &[line]).is_err());
        assert!(line_chart(&Axes::new("t", "x", "y"), &[]).is_err());
    }
}

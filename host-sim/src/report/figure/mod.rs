//! Figures: drawn once, as SVG and as PNG.
//!
//! Every stroke goes into both (`page`), and the font is compiled in: a machine without
//! fonts makes the same picture to the last pixel.
//! Colours are Okabe and Ito's, which colour-blind readers tell apart.

mod bars;
mod boards;
mod heat;
mod letters;
mod lines;
mod outline;
mod page;
mod palette;
mod png;
mod raster;

use std::sync::Once;
use std::{error, fmt};

use plotters::coord::Shift;
use plotters::prelude::{DrawingArea, IntoDrawingArea};
use plotters::style::{FontStyle, WHITE, register_font};

pub use bars::{Bar, bar_chart, histogram};
pub use boards::{Board, board_pairs};
pub use heat::{HeatMap, heat_maps};
pub use lines::{Line, Mark, Point, Span, line_chart, roc};

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

type Canvas<'a> = DrawingArea<page::Page<'a>, Shift>;
type Drawing = Result<(), Box<dyn error::Error>>;

/// Runs a drawing on an empty page and makes both formats of it.
fn picture(
    size: (u32, u32),
    draw: impl FnOnce(&Canvas<'_>) -> Drawing,
) -> Result<Picture, FigureError> {
    register_the_font();
    let (mut svg, mut pixels) = (String::new(), page::pixels_for(size));
    let drawn: Drawing = (|| {
        let page = page::Page::new(&mut svg, &mut pixels, size).into_drawing_area();
        page.fill(&WHITE)?;
        draw(&page)?;
        page.present()?;
        Ok(())
    })();
    drawn.map_err(|error| FigureError(error.to_string()))?;
    let png = png::encode(&pixels);
    Ok(Picture { svg, png })
}

/// The layout of a chart measures its letters in this font.
fn register_the_font() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        let font = register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular());
        assert!(font.is_ok(), "the font that is compiled in can be read");
    });
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
    use std::io::Cursor;

    use super::{Axes, Line, Picture, Point, line_chart};

    fn drawn(title: &str) -> Picture {
        let line = Line::new(
            "ours",
            (0..5).map(|x| Point::at(f64::from(x), 2.0)).collect(),
        );
        line_chart(&Axes::new(title, "x", "y").sized(400, 300), &[line]).unwrap()
    }

    /// The pixels of a PNG as columns and rows of red, green and blue.
    fn pixels(png: &[u8]) -> (usize, Vec<[u8; 3]>) {
        let mut reader = png::Decoder::new(Cursor::new(png)).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut bytes).unwrap();
        let pixels = bytes.as_chunks().0.to_vec();
        assert_eq!(pixels.len(), (frame.width * frame.height) as usize);
        (frame.width as usize, pixels)
    }

    #[test]
    fn a_picture_has_letters_in_it_and_is_the_same_every_time() {
        let picture = drawn("Captures & > 3");
        assert_eq!(picture, drawn("Captures & > 3"));
        assert!(picture.svg.contains("Captures &amp; &gt; 3"));
        // Without a font both pictures would be equally blank where the title is.
        let (width, titled) = pixels(&picture.png);
        let (_, blank) = pixels(&drawn("").png);
        let changed: Vec<usize> = (0..titled.len())
            .filter(|&at| titled[at] != blank[at])
            .collect();
        assert!(changed.len() > 500, "{}", changed.len());
        // Above the chart, in the middle of the page, black on white.
        for at in changed {
            let (x, y) = (at % width, at / width);
            assert!((200..600).contains(&x) && y < 80, "{x} {y}");
            assert_eq!(titled[at][0], titled[at][2]);
        }
    }

    #[test]
    fn the_pixels_show_what_the_svg_says_two_to_one_unit() {
        let picture = drawn("t");
        assert!(picture.svg.contains("width=\"400\" height=\"300\""));
        let (width, pixels) = pixels(&picture.png);
        assert_eq!((width, pixels.len() / width), (800, 600));
        // The line's own colour, on the row that the SVG names for it.
        let line = picture.svg.lines().find(|it| it.contains("#0072B2"));
        let points = line.unwrap().split("points=\"").nth(1).unwrap();
        let ends: Vec<usize> = points
            .split([',', ' ', '"'])
            .map_while(|number| number.parse().ok())
            .collect();
        let (x, y) = (2 * ends[0], 2 * ends[1]);
        // It is two units wide, half of it on either side.
        for row in 0..8 {
            let pixel = pixels[(y - 4 + row) * width + x + 21];
            let inside = (2..6).contains(&row);
            assert_eq!(pixel == [0x00, 0x72, 0xB2], inside, "{row}: {pixel:?}");
        }
        assert_eq!(pixels[0], [255, 255, 255]);
    }

    #[test]
    fn a_figure_without_a_finite_number_is_an_error_and_no_panic() {
        let line = Line::new("nothing", vec![Point::at(f64::NAN, 1.0)]);
        assert!(line_chart(&Axes::new("t", "x", "y"), &[line]).is_err());
        assert!(line_chart(&Axes::new("t", "x", "y"), &[]).is_err());
    }
}

//! Figures: drawn once, as SVG and as PNG, to be read on a printed page.
//!
//! Above a figure stands what it shows, below it what was measured: n, seeds, what a band or an
//! error bar is, the world.
//! Every stroke goes into both formats (`page`), and the font is compiled in: a machine without
//! fonts makes the same picture to the last pixel.
//! Colours are Okabe and Ito's, which colour-blind readers tell apart; dashes, marks and hatching
//! tell the same apart in grey.

mod bars;
mod boards;
mod heat;
mod histogram;
mod letters;
mod lines;
mod outline;
mod page;
mod palette;
mod panels;
mod plot;
mod png;
mod point;
mod points;
mod raster;
mod rows;
mod scale;
mod strokes;
mod text;

use std::sync::Once;
use std::{error, fmt};

use plotters::prelude::IntoDrawingArea;
use plotters::style::{FontStyle, WHITE, register_font};

use text::{Canvas, Drawing, Pen, leading, wrapped};

pub use bars::{Bar, bar_chart, bar_charts};
pub use boards::{Board, board_pairs};
pub use heat::{HeatMap, heat_maps};
pub use histogram::histogram;
pub use lines::{Line, Mark, Span, line_chart, roc};
pub use panels::{Panel, panels};
pub use point::Point;
pub use rows::{Row, Value, row_chart};

/// Sizes of letters, in units of the SVG.
const TITLE: i32 = 20;
const LABEL: i32 = 16;
const SMALL: i32 = 14;
const CAPTION: i32 = 13;

/// From the edge of the page to what is drawn.
const MARGIN: i32 = 16;

/// A finished figure in both formats, with its words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// What it shows.
    pub title: String,
    /// What was measured, and how.
    pub caption: String,
    /// The text of an SVG file.
    pub svg: String,
    /// The bytes of a PNG file, two pixels to one unit of the SVG.
    pub png: Vec<u8>,
    /// What its lines show, as a table of text; nothing of figures without lines.
    pub csv: Option<String>,
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

/// The words around a chart and its ranges; a range that is not given fits the data.
///
/// ```
/// use host_sim::report::figure::Axes;
/// let axes = Axes::new("Learning curve", "actions", "captures").y(0.0, 28.0);
/// assert_eq!(axes.y_range, Some((0.0, 28.0)));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// Above the chart: what it shows.
    pub title: String,
    /// Below it: n, seeds, what the band is, the world.
    pub caption: String,
    /// Below the horizontal axis.
    pub x_label: String,
    /// Above the vertical axis.
    pub y_label: String,
    /// The horizontal range.
    pub x_range: Option<(f64, f64)>,
    /// The vertical range.
    pub y_range: Option<(f64, f64)>,
    /// Whether equal horizontal distances are equal factors.
    pub x_log: bool,
    /// Whether equal vertical distances are equal factors.
    pub y_log: bool,
    /// Width and height in units of the SVG; the caption comes on top of it.
    pub size: (u32, u32),
}

impl Axes {
    /// Labelled axes that fit the data.
    #[must_use]
    pub fn new(title: &str, x_label: &str, y_label: &str) -> Self {
        Self {
            title: title.to_owned(),
            caption: String::new(),
            x_label: x_label.to_owned(),
            y_label: y_label.to_owned(),
            x_range: None,
            y_range: None,
            x_log: false,
            y_log: false,
            size: (800, 480),
        }
    }

    /// Says below the chart what was measured.
    #[must_use]
    pub fn caption(mut self, caption: impl Into<String>) -> Self {
        self.caption = caption.into();
        self
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

    /// Makes equal horizontal distances equal factors.
    #[must_use]
    pub const fn x_log(mut self) -> Self {
        self.x_log = true;
        self
    }

    /// Makes equal vertical distances equal factors.
    #[must_use]
    pub const fn y_log(mut self) -> Self {
        self.y_log = true;
        self
    }

    /// Sets width and height in units of the SVG.
    #[must_use]
    pub const fn sized(mut self, width: u32, height: u32) -> Self {
        self.size = (width, height);
        self
    }
}

/// A part of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Area {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Area {
    const fn width(&self) -> i32 {
        self.right - self.left
    }

    const fn height(&self) -> i32 {
        self.bottom - self.top
    }
}

/// Draws in the area between title and caption, and makes both formats of it.
fn picture(
    axes: &Axes,
    draw: impl FnOnce(&Canvas<'_>, Area) -> Drawing,
) -> Result<Picture, FigureError> {
    register_the_font();
    let (width, height) = axes.size;
    let room = width as i32 - 2 * MARGIN;
    let title = wrapped(&axes.title, TITLE, room);
    let caption = wrapped(&axes.caption, CAPTION, room);
    let head = MARGIN + title.len().max(1) as i32 * leading(TITLE) + 4;
    let foot = match caption.len() as i32 {
        0 => 0,
        lines => lines * leading(CAPTION) + 10,
    };
    let size = (width, height + foot as u32);
    let area = Area {
        left: MARGIN,
        top: head,
        right: width as i32 - MARGIN,
        bottom: height as i32 - MARGIN / 2,
    };
    let (mut svg, mut pixels) = (String::new(), page::pixels_for(size));
    let drawn: Drawing = (|| {
        let page = page::Page::new(&mut svg, &mut pixels, size).into_drawing_area();
        page.fill(&WHITE)?;
        Pen::new(TITLE).lines(&page, &title, (MARGIN, MARGIN))?;
        draw(&page, area)?;
        let below = (MARGIN, height as i32 + 2);
        Pen::new(CAPTION).dim().lines(&page, &caption, below)?;
        page.present()?;
        Ok(())
    })();
    drawn.map_err(|error| FigureError(error.to_string()))?;
    Ok(Picture {
        title: axes.title.clone(),
        caption: axes.caption.clone(),
        svg,
        png: png::encode(&pixels),
        csv: None,
    })
}

/// The layout of a chart measures its letters in this font.
fn register_the_font() {
    static REGISTERED: Once = Once::new();
    REGISTERED.call_once(|| {
        let font = register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular());
        assert!(font.is_ok(), "the font that is compiled in can be read");
    });
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
    fn a_picture_of_lines_has_their_points_beside_it() {
        let band = Point::mean_of(1.0, &[1.0, 2.0, 3.0]);
        let lines = [
            Line::new("a, b", vec![Point::at(0.0, 0.5), band]),
            Line::new("c", vec![Point::at(f64::NAN, 1.0), Point::at(2.0, 1.0)]),
        ];
        let axes = Axes::new("t", "actions", "captures").sized(400, 300);
        let table = line_chart(&axes, &lines).unwrap().csv.unwrap();
        let rows: Vec<&str> = table.lines().collect();
        assert_eq!(rows[0], "line,actions,captures,low,high");
        assert_eq!(rows[1], "\"a, b\",0,0.5,,");
        let (low, high) = band.band.unwrap();
        assert_eq!(rows[2], format!("\"a, b\",1,2,{low},{high}"));
        // What is no number is not drawn.
        assert_eq!(rows[3..], ["c,2,1,,"]);
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
        // Above the chart, from the left of the page, black on white.
        for at in changed {
            let (x, y) = (at % width, at / width);
            assert!((30..600).contains(&x) && y < 90, "{x} {y}");
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
        // One number is enough for an axis of factors; none that is positive is not.
        let level = |height| Line::new("a", [1.0, 2.0].map(|x| Point::at(x, height)).to_vec());
        let factors = Axes::new("t", "x", "y").y_log();
        assert!(line_chart(&factors, &[level(200.0)]).is_ok());
        assert!(line_chart(&factors, &[level(0.0)]).is_err());
    }
}

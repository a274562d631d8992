//! The page that figures are drawn on: every stroke goes into the SVG and into the pixels.
//!
//! What a stroke, a filled shape or a line of text means is said by SVG 1.1; the pixels follow it,
//! with the letters of the font that is compiled in.

use std::io;

use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters_backend::text_anchor::VPos;
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};

use super::letters::{Letters, Line};
use super::outline::{Outline, Place};
use super::raster::Raster;

/// Pixels to one unit of the SVG.
const PIXELS: u32 = 2;

/// One drawing in two formats.
pub(super) struct Page<'a> {
    svg: SVGBackend<'a>,
    pixels: &'a mut Raster,
    letters: Letters,
}

type Drawn = Result<(), DrawingErrorKind<io::Error>>;

/// White pixels for a page of that size, in units of the SVG.
pub(super) fn pixels_for((width, height): (u32, u32)) -> Raster {
    Raster::white(width * PIXELS, height * PIXELS)
}

impl<'a> Page<'a> {
    /// An empty page whose SVG is written to `svg` and whose pixels are `pixels`.
    pub(super) fn new(svg: &'a mut String, pixels: &'a mut Raster, size: (u32, u32)) -> Self {
        Self {
            svg: SVGBackend::with_string(svg, size),
            pixels,
            letters: Letters::compiled_in(),
        }
    }
}

/// A place on the page in pixels.
fn place((x, y): BackendCoord) -> Place {
    (
        f64::from(x) * f64::from(PIXELS),
        f64::from(y) * f64::from(PIXELS),
    )
}

fn stroke_width<S: BackendStyle>(style: &S) -> f64 {
    f64::from(style.stroke_width()) * f64::from(PIXELS)
}

impl DrawingBackend for Page<'_> {
    type ErrorType = io::Error;

    fn get_size(&self) -> (u32, u32) {
        self.svg.get_size()
    }

    fn ensure_prepared(&mut self) -> Drawn {
        self.svg.ensure_prepared()
    }

    fn present(&mut self) -> Drawn {
        self.svg.present()
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Drawn {
        let end = (point.0 + 1, point.1 + 1);
        let outline = Outline::rectangle(place(point), place(end));
        self.pixels.fill(&outline, color);
        self.svg.draw_pixel(point, color)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Drawn {
        let outline = Outline::stroke(&[place(from), place(to)], stroke_width(style));
        self.pixels.fill(&outline, style.color());
        self.svg.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let (from, to) = (place(upper_left), place(bottom_right));
        let outline = if fill {
            Outline::rectangle(from, to)
        } else {
            // The SVG names no width here, which makes it one unit.
            Outline::frame(from, to, f64::from(PIXELS))
        };
        self.pixels.fill(&outline, style.color());
        self.svg.draw_rect(upper_left, bottom_right, style, fill)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Drawn {
        let path: Vec<BackendCoord> = path.into_iter().collect();
        let places: Vec<Place> = path.iter().copied().map(place).collect();
        let outline = Outline::stroke(&places, stroke_width(style));
        self.pixels.fill(&outline, style.color());
        self.svg.draw_path(path, style)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Drawn {
        let reach = f64::from(radius) * f64::from(PIXELS);
        let outline = if fill {
            Outline::circle(place(center), reach)
        } else {
            Outline::ring(place(center), reach, stroke_width(style))
        };
        self.pixels.fill(&outline, style.color());
        self.svg.draw_circle(center, radius, style, fill)
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        corners: I,
        style: &S,
    ) -> Drawn {
        let corners: Vec<BackendCoord> = corners.into_iter().collect();
        let places: Vec<Place> = corners.iter().copied().map(place).collect();
        self.pixels.fill(&Outline::polygon(&places), style.color());
        self.svg.fill_polygon(corners, style)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        pos: BackendCoord,
    ) -> Drawn {
        // The size of an em, and where the baseline lies, as the SVG says them.
        let em = style.size() / 1.24;
        let down = match style.anchor().v_pos {
            VPos::Top => 0.76,
            VPos::Center => 0.5 * EX,
            VPos::Bottom => -0.5 * EX,
        };
        let outline = self.letters.outline(&Line {
            text,
            em: em * f64::from(PIXELS),
            at: place(pos),
            down,
            anchor: style.anchor().h_pos,
            turned: style.transform(),
        });
        self.pixels.fill(&outline, style.color());
        self.svg.draw_text(text, style, pos)
    }
}

/// The height of an x, in ems.
const EX: f64 = 0.5;

//! Pixels, and the filling of outlines with a colour.
//!
//! How much of a pixel an outline covers is exact across and measured on sixteen lines down; the
//! colour is mixed in by that share, as a browser does it.
//! The same drawing gives the same pixels on every machine.

use plotters_backend::BackendColor;

use super::outline::Outline;

/// Lines through a pixel on which is measured how much of it is covered.
const LINES: usize = 16;

/// An image of three bytes a pixel, row by row from the top.
#[derive(Clone, Debug)]
pub(super) struct Raster {
    width: usize,
    height: usize,
    rgb: Vec<u8>,
}

/// Where a line through the pixels meets an edge, and whether the edge goes down (1) or up (−1).
#[derive(Clone, Copy)]
struct Crossing {
    x: f64,
    winds: i32,
}

impl Raster {
    /// A white image of so many pixels.
    pub(super) fn white(width: u32, height: u32) -> Self {
        let (width, height) = (width as usize, height as usize);
        Self {
            width,
            height,
            rgb: vec![u8::MAX; 3 * width * height],
        }
    }

    /// Pixels in a row.
    pub(super) const fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    pub(super) const fn height(&self) -> usize {
        self.height
    }

    /// The bytes, red, green and blue for each pixel.
    pub(super) fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// Mixes a colour into what the outline covers; what lies outside the image is left out.
    pub(super) fn fill(&mut self, outline: &Outline, colour: BackendColor) {
        let (first, mut lines) = self.crossings(outline);
        let mut covered = vec![0.0; self.width];
        for (row, lines) in lines.chunks_mut(LINES).enumerate() {
            let mut reach = (self.width, 0);
            for line in lines {
                let touched = cover(line, &mut covered);
                reach = (reach.0.min(touched.0), reach.1.max(touched.1));
            }
            let (from, to) = reach;
            if from >= to {
                continue;
            }
            let start = (first + row) * self.width;
            let pixels = &mut self.rgb[3 * (start + from)..3 * (start + to)];
            for (pixel, covered) in pixels.chunks_exact_mut(3).zip(&mut covered[from..to]) {
                let share = (*covered / LINES as f64).min(1.0) * colour.alpha;
                mix(pixel, colour, share);
                *covered = 0.0;
            }
        }
    }

    /// The first row that the outline touches, and for each line from there on what it meets.
    fn crossings(&self, outline: &Outline) -> (usize, Vec<Vec<Crossing>>) {
        let heights = || outline.edges().iter().flat_map(|(from, to)| [from.1, to.1]);
        let clip = |row: f64| row.clamp(0.0, self.height as f64) as usize;
        let first = clip(heights().fold(f64::INFINITY, f64::min).floor());
        let end = clip(heights().fold(f64::NEG_INFINITY, f64::max).ceil());
        let mut lines = vec![Vec::new(); LINES * end.saturating_sub(first)];
        for &(from, to) in outline.edges() {
            let winds = if to.1 > from.1 { 1 } else { -1 };
            let (top, bottom) = if winds > 0 { (from, to) } else { (to, from) };
            // A line lies in the middle of its strip; an edge owns its upper end and not its lower.
            let strip = |y: f64| {
                let strip = ((y - first as f64) * LINES as f64 - 0.5).ceil();
                strip.clamp(0.0, lines.len() as f64) as usize
            };
            let strips = strip(top.1)..strip(bottom.1);
            let slope = (bottom.0 - top.0) / (bottom.1 - top.1);
            for strip in strips {
                let y = first as f64 + (strip as f64 + 0.5) / LINES as f64;
                let x = top.0 + (y - top.1) * slope;
                lines[strip].push(Crossing { x, winds });
            }
        }
        (first, lines)
    }
}

/// Adds what a line has inside; returns the pixels that it may have touched.
fn cover(line: &mut [Crossing], covered: &mut [f64]) -> (usize, usize) {
    line.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut winding = 0;
    let mut reach = (covered.len(), 0);
    for ends in line.windows(2) {
        winding += ends[0].winds;
        if winding == 0 {
            continue;
        }
        let right_end = covered.len() as f64;
        let (from, to) = (
            ends[0].x.clamp(0.0, right_end),
            ends[1].x.clamp(0.0, right_end),
        );
        let pixels = (from.floor() as usize, to.ceil() as usize);
        for (x, covered) in covered[pixels.0..pixels.1].iter_mut().enumerate() {
            let left = (pixels.0 + x) as f64;
            *covered += to.min(left + 1.0) - from.max(left);
        }
        reach = (reach.0.min(pixels.0), reach.1.max(pixels.1));
    }
    reach
}

/// Moves a pixel towards a colour by a share between 0 and 1.
fn mix(pixel: &mut [u8], colour: BackendColor, share: f64) {
    let (red, green, blue) = colour.rgb;
    for (now, colour) in pixel.iter_mut().zip([red, green, blue]) {
        let mixed = f64::from(*now) + (f64::from(colour) - f64::from(*now)) * share;
        *now = (mixed + 0.5) as u8;
    }
}

#[cfg(test)]
mod tests {
    use plotters_backend::BackendColor;

    use super::Raster;
    use crate::report::figure::outline::Outline;

    const BLACK: BackendColor = BackendColor {
        alpha: 1.0,
        rgb: (0, 0, 0),
    };
    const HALF: BackendColor = BackendColor {
        alpha: 0.5,
        ..BLACK
    };

    fn grey(image: &Raster, x: usize, y: usize) -> u8 {
        image.rgb()[3 * (y * image.width() + x)]
    }

    #[test]
    fn a_pixel_is_as_dark_as_it_is_covered() {
        let mut image = Raster::white(4, 3);
        let outline = Outline::rectangle((0.5, 0.75), (3.0, 2.0));
        image.fill(&outline, BLACK);
        let row = |y| [0, 1, 2, 3].map(|x| grey(&image, x, y));
        assert_eq!(row(0), [223, 191, 191, 255]);
        assert_eq!(row(1), [128, 0, 0, 255]);
        assert_eq!(row(2), [255; 4]);
    }

    #[test]
    fn what_lies_outside_the_image_is_left_out() {
        let mut image = Raster::white(2, 2);
        image.fill(&Outline::rectangle((-9.0, -9.0), (1.0, 99.0)), BLACK);
        image.fill(&Outline::circle((500.0, -500.0), 3.0), BLACK);
        assert_eq!([grey(&image, 0, 0), grey(&image, 1, 1)], [0, 255]);
        Raster::white(0, 0).fill(&Outline::circle((0.0, 0.0), 3.0), BLACK);
    }

    #[test]
    fn a_stroke_that_crosses_itself_and_turns_is_nowhere_darker() {
        let mut image = Raster::white(40, 40);
        let path = [
            (5.0, 20.0),
            (35.0, 20.0),
            (35.0, 5.0),
            (20.0, 5.0),
            (20.0, 35.0),
        ];
        image.fill(&Outline::stroke(&path, 4.0), HALF);
        let crossing = grey(&image, 20, 20);
        assert_eq!(crossing, 128);
        for place in [(6, 20), (34, 19), (36, 21), (36, 3), (18, 3), (20, 34)] {
            assert_eq!(grey(&image, place.0, place.1), crossing, "{place:?}");
        }
        // Flat ends, and nothing beyond a corner's tip.
        for place in [(4, 20), (37, 22), (20, 35), (25, 10)] {
            assert_eq!(grey(&image, place.0, place.1), 255, "{place:?}");
        }
    }

    #[test]
    fn frames_and_rings_are_empty_inside() {
        let mut image = Raster::white(20, 20);
        image.fill(&Outline::frame((2.0, 2.0), (18.0, 18.0), 2.0), BLACK);
        image.fill(&Outline::ring((10.0, 10.0), 5.0, 2.0), BLACK);
        let middle: Vec<u8> = (0..10).map(|x| grey(&image, x, 10)).collect();
        assert_eq!(middle[..4], [255, 0, 0, 255]);
        assert!(middle[4] < 30 && middle[5] < 30, "{middle:?}");
        assert_eq!(middle[7..], [255, 255, 255]);
    }
}

//! Outlines of what is filled: shapes, and strokes as the shapes that they cover.
//!
//! An outline is a set of directed edges that close; a place is inside where they wind around it,
//! in either direction (SVG's rule "nonzero"), so that parts that overlap are one shape.
//! Everything here is made by additions, multiplications and square roots: the same outline on
//! every machine.

/// A place in pixels, the second coordinate downwards.
pub(super) type Place = (f64, f64);

/// A miter longer than so many strokes is cut off, as in SVG.
const MITER: f64 = 4.0;
/// Corners of a circle: for radii up to 100 pixels they are within a tenth of a pixel of it.
const CORNERS: usize = 64;
/// Straight pieces of a curve in a letter.
const PIECES: u32 = 8;

/// Directed edges that close.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    edges: Vec<(Place, Place)>,
}

impl Outline {
    /// The edges.
    pub(super) fn edges(&self) -> &[(Place, Place)] {
        &self.edges
    }

    /// A closed polygon.
    pub(super) fn polygon(corners: &[Place]) -> Self {
        let mut outline = Self::default();
        outline.close(corners);
        outline
    }

    /// The rectangle between two corners.
    pub(super) fn rectangle(from: Place, to: Place) -> Self {
        Self::polygon(&[from, (to.0, from.1), to, (from.0, to.1)])
    }

    /// The stroke around a rectangle, half of it inside.
    pub(super) fn frame((left, top): Place, (right, bottom): Place, width: f64) -> Self {
        let half = width / 2.0;
        let mut frame = Self::rectangle((left - half, top - half), (right + half, bottom + half));
        frame.cut_out(&Self::rectangle(
            (left + half, top + half),
            (right - half, bottom - half),
        ));
        frame
    }

    /// A filled circle.
    pub(super) fn circle(middle: Place, radius: f64) -> Self {
        let corners = (0..CORNERS).map(|corner| {
            let angle = std::f64::consts::TAU * corner as f64 / CORNERS as f64;
            let (sine, cosine) = libm::sincos(angle);
            (middle.0 + radius * cosine, middle.1 + radius * sine)
        });
        Self::polygon(&corners.collect::<Vec<_>>())
    }

    /// The stroke around a circle, half of it inside.
    pub(super) fn ring(middle: Place, radius: f64, width: f64) -> Self {
        let mut ring = Self::circle(middle, radius + width / 2.0);
        let hole = (radius - width / 2.0).max(0.0);
        ring.cut_out(&Self::circle(middle, hole));
        ring
    }

    /// The stroke along a path: flat at its ends, mitered where it turns.
    pub(super) fn stroke(path: &[Place], width: f64) -> Self {
        let mut outline = Self::default();
        let half = width / 2.0;
        let mut before: Option<Place> = None;
        for ends in path.windows(2) {
            let &[from, to] = ends else { continue };
            let (x, y) = (to.0 - from.0, to.1 - from.1);
            let length = (x * x + y * y).sqrt();
            if length == 0.0 {
                continue;
            }
            let way = (x / length, y / length);
            let aside = (-way.1 * half, way.0 * half);
            outline.close(&[
                (from.0 - aside.0, from.1 - aside.1),
                (to.0 - aside.0, to.1 - aside.1),
                (to.0 + aside.0, to.1 + aside.1),
                (from.0 + aside.0, from.1 + aside.1),
            ]);
            if let Some(earlier) = before {
                outline.join(from, earlier, way, half);
            }
            before = Some(way);
        }
        outline
    }

    /// Fills the gap that two pieces of a stroke leave outside a turn.
    fn join(&mut self, at: Place, before: Place, after: Place, half: f64) {
        let turn = before.0 * after.1 - before.1 * after.0;
        // The outside is to the left of a turn to the right.
        let side = if turn > 0.0 { -half } else { half };
        let out = |way: Place| (at.0 - way.1 * side, at.1 + way.0 * side);
        let (first, last) = (out(before), out(after));
        // The tip lies where the outer edges meet: beyond the middle of their ends, by 1 / cos² of
        // half the turn.
        let along = before.0 * after.0 + before.1 * after.1;
        let cosine_squared = f64::midpoint(1.0, along);
        let mut corners = vec![at, first];
        if cosine_squared * MITER * MITER >= 1.0 {
            let middle = f64::midpoint(first.0, last.0);
            let middle = (middle, f64::midpoint(first.1, last.1));
            corners.push((
                at.0 + (middle.0 - at.0) / cosine_squared,
                at.1 + (middle.1 - at.1) / cosine_squared,
            ));
        }
        corners.push(last);
        // In the same direction as the pieces, or what they share would count as outside.
        if turn < 0.0 {
            corners.reverse();
        }
        self.close(&corners);
    }

    /// Adds a curve with one control point as straight pieces.
    pub(super) fn bend(&mut self, from: Place, control: Place, to: Place) {
        self.pieces(from, |t| {
            let (a, b, c) = ((1.0 - t) * (1.0 - t), 2.0 * t * (1.0 - t), t * t);
            let mix = |from: f64, control: f64, to: f64| a * from + b * control + c * to;
            (mix(from.0, control.0, to.0), mix(from.1, control.1, to.1))
        });
    }

    /// Adds a curve with two control points as straight pieces.
    pub(super) fn bend_twice(&mut self, from: Place, controls: [Place; 2], to: Place) {
        let [first, second] = controls;
        self.pieces(from, |t| {
            let s = 1.0 - t;
            let (a, b, c, d) = (s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t);
            let mix = |p: f64, q: f64, r: f64, u: f64| a * p + b * q + c * r + d * u;
            (
                mix(from.0, first.0, second.0, to.0),
                mix(from.1, first.1, second.1, to.1),
            )
        });
    }

    /// Adds one edge.
    pub(super) fn edge(&mut self, from: Place, to: Place) {
        self.edges.push((from, to));
    }

    fn pieces(&mut self, from: Place, at: impl Fn(f64) -> Place) {
        let mut last = from;
        for piece in 1..=PIECES {
            let next = at(f64::from(piece) / f64::from(PIECES));
            self.edge(last, next);
            last = next;
        }
    }

    fn close(&mut self, corners: &[Place]) {
        let next = corners.iter().cycle().skip(1);
        self.edges
            .extend(corners.iter().copied().zip(next.copied()));
    }

    fn cut_out(&mut self, hole: &Self) {
        self.edges
            .extend(hole.edges.iter().map(|&(from, to)| (to, from)));
    }
}

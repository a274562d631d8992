//! How far each node moves: the neighbourhood of a winner times the learning rate.

use cla_core::num::exp;

/// A rate nearer to 0 than this is 0: what it would move is nothing, and such numbers are slow.
const NEGLIGIBLE: f32 = 1e-18;
/// The distance of rows on a hexagonal map, in nodes.
const HEXAGONAL_ROW: f32 = 0.866_025_4;

/// What of a map its neighbourhoods need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lattice {
    pub(crate) x: usize,
    pub(crate) y: usize,
    pub(crate) hexagonal: bool,
    pub(crate) shape: Shape,
}

/// Which function of the distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    Gaussian,
    MexicanHat,
    Bubble,
    Triangle,
}

impl Shape {
    pub(crate) fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "gaussian" => Self::Gaussian,
            "mexican_hat" => Self::MexicanHat,
            "bubble" => Self::Bubble,
            "triangle" => Self::Triangle,
            _ => return None,
        })
    }
}

/// Tables for one width of the neighbourhood, made again when it changes.
#[derive(Clone, Debug)]
pub(crate) struct Rates {
    lattice: Lattice,
    sigma: f32,
    /// exp(−d²/2σ²) for whole distances along x, and for half ones.
    along: Vec<f32>,
    halves: Vec<f32>,
    across: Vec<f32>,
    /// The rate of every node.
    pub(crate) of: Vec<f32>,
    /// The nodes of which any moves: all others have a rate of 0.
    pub(crate) moving: std::ops::Range<usize>,
}

impl Rates {
    pub(crate) fn new(lattice: Lattice) -> Self {
        let Lattice { x, y, .. } = lattice;
        Self {
            lattice,
            sigma: f32::NAN,
            along: vec![0.0; x],
            halves: vec![0.0; x + 1],
            across: vec![0.0; y],
            of: vec![0.0; x * y],
            moving: 0..0,
        }
    }

    /// The rates around a winner: `alpha` times the neighbourhood of width `sigma`.
    #[inline(always)]
    pub(crate) fn around(&mut self, winner: usize, sigma: f32, alpha: f32) {
        let Lattice { x, y, shape, .. } = self.lattice;
        let (i, j) = (winner / y, winner % y);
        match shape {
            Shape::Gaussian => {
                if sigma != self.sigma {
                    self.tabulate(sigma);
                }
                self.gaussian(i, j, alpha);
            }
            _ => {
                for (node, rate) in self.of.iter_mut().enumerate() {
                    *rate = alpha * other(&self.lattice, (i, j), (node / y, node % y), sigma);
                }
            }
        }
        // Rows of x in which nothing moves are left out.
        let moves = |row: &usize| self.of[row * y..][..y].iter().any(|&rate| rate != 0.0);
        let first = (0..x).find(moves).unwrap_or(0);
        let last = (0..x).rev().find(moves).map_or(first, |row| row + 1);
        self.moving = first * y..last * y;
    }

    fn tabulate(&mut self, sigma: f32) {
        self.sigma = sigma;
        let width = 2.0 * sigma * sigma;
        let factor = |d: f32| {
            if d == 0.0 {
                1.0
            } else if width < f32::MIN_POSITIVE {
                0.0
            } else {
                exp(-(d * d) / width)
            }
        };
        let row = if self.lattice.hexagonal {
            HEXAGONAL_ROW
        } else {
            1.0
        };
        for (d, it) in self.along.iter_mut().enumerate() {
            *it = factor(d as f32);
        }
        if self.lattice.hexagonal {
            for (d, it) in self.halves.iter_mut().enumerate() {
                *it = factor(d as f32 + 0.5);
            }
        } else if self.along.len() == self.across.len() {
            // The same numbers.
            self.across.copy_from_slice(&self.along);
            return;
        }
        for (d, it) in self.across.iter_mut().enumerate() {
            *it = factor(d as f32 * row);
        }
    }

    #[inline(always)]
    fn gaussian(&mut self, i: usize, j: usize, alpha: f32) {
        let y = self.lattice.y;
        let hexagonal = self.lattice.hexagonal;
        let row = |k: usize, along: f32, rate: &mut f32, across: &[f32]| {
            let it = alpha * (across[k.abs_diff(j)] * along);
            *rate = if it.abs() < NEGLIGIBLE { 0.0 } else { it };
        };
        for (h, rates) in self.of.chunks_exact_mut(y).enumerate() {
            let whole = self.along[h.abs_diff(i)];
            if !hexagonal {
                for (k, rate) in rates.iter_mut().enumerate() {
                    row(k, whole, rate, &self.across);
                }
                continue;
            }
            for (k, rate) in rates.iter_mut().enumerate() {
                let along = match shift(y, k) - shift(y, j) {
                    // The difference of places in halves is odd: their tables begin at a half.
                    0 => whole,
                    halves => {
                        let twice = 2 * (h as i64 - i as i64) + halves;
                        self.halves[(twice.unsigned_abs() as usize - 1) / 2]
                    }
                };
                row(k, along, rate, &self.across);
            }
        }
    }
}

/// The place of a row along x on a hexagonal map, in halves: every second row, counted from the last,
/// lies half a node back.
const fn shift(y: usize, j: usize) -> i64 {
    if (y - 1 - j).is_multiple_of(2) { -1 } else { 0 }
}

fn other(lattice: &Lattice, (i, j): (usize, usize), (h, k): (usize, usize), sigma: f32) -> f32 {
    let (dx, dy) = (h.abs_diff(i) as f32, k.abs_diff(j) as f32);
    match lattice.shape {
        Shape::Bubble => f32::from(u8::from(dx < sigma && dy < sigma)),
        Shape::Triangle => (sigma - dx).max(0.0) * (sigma - dy).max(0.0),
        _ => {
            let (mut dx, mut dy) = (h as f32 - i as f32, dy);
            if lattice.hexagonal {
                dx += 0.5 * (shift(lattice.y, k) - shift(lattice.y, j)) as f32;
                dy *= HEXAGONAL_ROW;
            }
            let p = dx * dx + dy * dy;
            let width = 2.0 * sigma * sigma;
            if p == 0.0 {
                1.0
            } else if width < f32::MIN_POSITIVE {
                0.0
            } else {
                exp(-p / width) * (1.0 - 2.0 / width * p)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Lattice, Rates, Shape};

    #[test]
    fn on_a_hexagonal_map_all_six_neighbours_are_equally_near() {
        let lattice = Lattice {
            x: 5,
            y: 5,
            hexagonal: true,
            shape: Shape::Gaussian,
        };
        for (winner, neighbours) in [
            // Row 2 lies half a node back, as the last does.
            (12, [7, 17, 11, 13, 6, 8]),
            (11, [6, 16, 10, 12, 15, 17]),
        ] {
            let mut rates = Rates::new(lattice);
            rates.around(winner, 1.0, 1.0);
            assert_eq!(rates.of[winner], 1.0);
            let near = (-0.5_f32).exp();
            for node in neighbours {
                assert!(
                    (rates.of[node] - near).abs() < 1e-6,
                    "{winner} {node} {:?}",
                    rates.of
                );
            }
            let as_near = rates.of.iter().filter(|it| (**it - near).abs() < 1e-6);
            assert_eq!(as_near.count(), 6);
        }
    }

    #[test]
    fn what_does_not_move_is_left_out() {
        let lattice = Lattice {
            x: 20,
            y: 3,
            hexagonal: false,
            shape: Shape::Bubble,
        };
        let mut rates = Rates::new(lattice);
        rates.around(3 * 10 + 1, 2.0, 0.5);
        assert_eq!(rates.moving, 27..36);
        assert_eq!(rates.of.iter().sum::<f32>(), 4.5);
    }
}

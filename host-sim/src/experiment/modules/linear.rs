//! The little linear algebra that components need, in double precision: symmetric eigenvectors.

/// Rotations go on until what is off the diagonal is this small a share of the whole.
const SMALL: f64 = 1e-12;
/// Sweeps at most; a symmetric matrix needs six or so.
const SWEEPS: u32 = 30;

/// Eigenvalues with their unit eigenvectors, the largest first, and how many rotations it took.
pub(super) struct Eigen {
    /// Value and vector.
    pub(super) pairs: Vec<(f64, Vec<f64>)>,
    /// Rotations of two rows and two columns.
    pub(super) rotations: u64,
}

/// The eigenvectors of a symmetric matrix of `n` rows, row by row, by cyclic Jacobi rotations.
pub(super) fn eigen(mut matrix: Vec<f64>, n: usize) -> Eigen {
    let mut vectors = vec![0.0; n * n];
    for at in 0..n {
        vectors[at * n + at] = 1.0;
    }
    let whole: f64 = matrix.iter().map(|it| it * it).sum();
    let mut rotations = 0;
    for _ in 0..SWEEPS {
        let mut off = 0.0;
        for p in 0..n {
            for q in p + 1..n {
                off += matrix[p * n + q] * matrix[p * n + q];
            }
        }
        if off <= SMALL * SMALL * whole {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if matrix[p * n + q] != 0.0 {
                    rotate(&mut matrix, &mut vectors, n, p, q);
                    rotations += 1;
                }
            }
        }
    }
    let mut pairs: Vec<(f64, Vec<f64>)> = (0..n)
        .map(|at| (matrix[at * n + at], vectors[at * n..][..n].to_vec()))
        .collect();
    pairs.sort_by(|a, b| b.0.total_cmp(&a.0));
    Eigen { pairs, rotations }
}

/// One Jacobi rotation, after which the matrix is 0 at row `p`, column `q`; eigenvectors are rows.
fn rotate(matrix: &mut [f64], vectors: &mut [f64], n: usize, p: usize, q: usize) {
    let theta = (matrix[q * n + q] - matrix[p * n + p]) / (2.0 * matrix[p * n + q]);
    let tangent = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let cosine = 1.0 / (tangent * tangent + 1.0).sqrt();
    let sine = tangent * cosine;
    let turn = |a: &mut f64, b: &mut f64| {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    };
    for row in matrix.chunks_exact_mut(n) {
        let (left, right) = row.split_at_mut(q);
        turn(&mut left[p], &mut right[0]);
    }
    for it in [matrix, vectors] {
        let (above, below) = it.split_at_mut(q * n);
        let rows = above[p * n..][..n].iter_mut().zip(&mut below[..n]);
        for (a, b) in rows {
            turn(a, b);
        }
    }
}

/// Rows made orthonormal without a first one among them: M ← (M Mᵀ)^(−1/2) M; `n` rows of `n`.
pub(super) fn decorrelated(matrix: &[f64], n: usize) -> Vec<f64> {
    let row = |at: usize| &matrix[at * n..][..n];
    let mut square = vec![0.0; n * n];
    for a in 0..n {
        for b in 0..n {
            square[a * n + b] = dot(row(a), row(b));
        }
    }
    let mut result = vec![0.0; n * n];
    for (value, vector) in eigen(square, n).pairs {
        let scale = 1.0 / value.max(f64::MIN_POSITIVE).sqrt();
        let mut along = vec![0.0; n];
        for (at, weight) in vector.iter().enumerate() {
            for (sum, it) in along.iter_mut().zip(row(at)) {
                *sum += weight * it;
            }
        }
        for (at, weight) in vector.iter().enumerate() {
            for (sum, it) in result[at * n..][..n].iter_mut().zip(&along) {
                *sum += scale * weight * it;
            }
        }
    }
    result
}

/// Σ a·b.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::{decorrelated, dot, eigen};

    #[test]
    fn eigenvectors_are_kept_by_the_matrix_and_come_in_order() {
        let matrix = vec![4.0, 1.0, 0.5, 1.0, 3.0, -1.0, 0.5, -1.0, 2.0];
        let found = eigen(matrix.clone(), 3).pairs;
        assert!(found[0].0 > found[1].0 && found[1].0 > found[2].0);
        for (value, vector) in found {
            assert!((dot(&vector, &vector) - 1.0).abs() < 1e-9);
            for row in 0..3 {
                let image = dot(&matrix[3 * row..][..3], &vector);
                assert!((image - value * vector[row]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn decorrelated_rows_are_orthonormal() {
        let rows = decorrelated(&[2.0, 1.0, 0.0, 1.0], 2);
        let (a, b) = rows.split_at(2);
        assert!((dot(a, a) - 1.0).abs() < 1e-9 && dot(a, b).abs() < 1e-9);
    }
}

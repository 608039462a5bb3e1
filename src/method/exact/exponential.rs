//! Solution by the exponential of the matrix of states and waves together:
//!
//! ```text
//! [y]'   [A C] [y]
//! [w]  = [0 E] [w]      w = s^j e^(g s) (cos w s, sin w s)
//! ```

use nalgebra::linalg::balancing::unbalance;
use nalgebra::{Complex, DMatrix, DVector};

use super::Solution;
use super::piece::{Piece, Wave};
use crate::dense::balance;
use crate::method::Stretch;

/// Maximum number of rows; larger machines are better stepped.
const MOST_ROWS: usize = 600;
/// The same limit where the cost of steps is only a few times the number of rows.
const MOST_ROWS_OF_BANDED: usize = 120;
/// Maximum number of exponentials kept for spans that recur.
const KEPT: usize = 128;
/// Rounding error per squaring: this times the norm of the exponent.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// Solution of a piece by exponentials, from one settled state to the next.
pub(super) struct Exponential<'a> {
    piece: &'a Piece,
    /// Matrix of states and waves.
    matrix: DMatrix<f64>,
    settled: (f64, DVector<f64>),
    /// Number of parts of a span whose exponentials are multiplied. Results do not depend on it but
    /// for rounding, which the difference of two runs then shows.
    parts: u16,
    /// Exponentials by span.
    known: Vec<(f64, DMatrix<f64>)>,
}

impl<'a> Exponential<'a> {
    /// Returns the reason if the solution would not meet the tolerance.
    pub(super) fn new(
        piece: &'a Piece,
        stretch: &Stretch<'_>,
        state: &[f64],
    ) -> Result<Self, String> {
        let rtol = stretch.rtol;
        let is_banded = stretch.system.simulator().border().is_some();
        let most = if is_banded { MOST_ROWS_OF_BANDED } else { MOST_ROWS };
        let waves: usize = piece.waves.iter().map(rows).sum();
        let size = piece.states() + waves;
        if size > most {
            return Err(format!(
                "{size} rows are too many for the exponential of a matrix (at most {most}); \
                 try the method `auto`"
            ));
        }
        let matrix = augmented(piece, size);
        if matrix.iter().any(|value| !value.is_finite()) {
            return Err("a coefficient of its equations is not finite".to_owned());
        }
        let mut balanced = matrix.clone();
        balance(&mut balanced);
        let norm = balanced.column_iter().map(|column| column.lp_norm(1)).fold(0.0, f64::max);
        let error = ROUNDINGS * norm * piece.span();
        if error.is_nan() || error > rtol {
            return Err(format!(
                "the exponential of a matrix of norm {norm:.1e} 1/s over {} s has a relative \
                 rounding error of {error:.0e}, more than the tolerance; try the method `auto`",
                piece.span()
            ));
        }
        let settled = (piece.from, DVector::from_column_slice(state));
        let parts = if stretch.shortens { 3 } else { 1 };
        Ok(Self { piece, matrix, settled, parts, known: Vec::new() })
    }

    /// Returns the index of e^(matrix h); spans that differ by the rounding of times are the same.
    fn exponential(&mut self, h: f64) -> usize {
        let rounding = 2.0 * f64::EPSILON * self.piece.from.abs().max(self.piece.until.abs());
        let known = self.known.iter().position(|(span, _)| (span - h).abs() <= rounding);
        known.unwrap_or_else(|| {
            let mut exponent = &self.matrix * (h / f64::from(self.parts));
            let scales = balance(&mut exponent);
            let part = exponent.exp();
            let mut exponential = part.clone();
            for _ in 1..self.parts {
                exponential *= &part;
            }
            unbalance(&mut exponential, &scales);
            if self.known.len() == KEPT {
                self.known.clear();
            }
            self.known.push((h, exponential));
            self.known.len() - 1
        })
    }
}

impl Solution for Exponential<'_> {
    fn state_at(&mut self, time: f64, state: &mut [f64]) {
        let (start, settled) = (self.settled.0, self.settled.1.clone());
        let kept = self.exponential(time - start);
        let mut both = settled;
        both.extend(waves(self.piece, start - self.piece.from));
        let exponential = &self.known[kept].1;
        let rows = exponential.rows(0, self.piece.states());
        state.copy_from_slice((rows * both).as_slice());
    }

    fn settle(&mut self, time: f64, state: &[f64]) {
        self.settled = (time, DVector::from_column_slice(state));
    }
}

/// Returns the number of rows of a wave: two for each power of time up to its own.
fn rows(wave: &Wave) -> usize {
    2 * (wave.power as usize + 1)
}

/// Returns w at s.
fn waves(piece: &Piece, s: f64) -> Vec<f64> {
    let mut values = Vec::new();
    for wave in &piece.waves {
        let mut value = (wave.mu * s).exp();
        for _ in 0..=wave.power {
            values.extend([value.re, value.im]);
            value *= s;
        }
    }
    values
}

fn augmented(piece: &Piece, size: usize) -> DMatrix<f64> {
    let n = piece.states();
    let mut matrix = DMatrix::zeros(size, size);
    matrix.view_mut((0, 0), (n, n)).copy_from(&piece.matrix());
    let mut first = n;
    for wave in &piece.waves {
        let Complex { re: growth, im: frequency } = wave.mu;
        for (j, coefficient) in piece.local(wave).into_iter().enumerate() {
            let row = first + 2 * j;
            for (entry, amplitude) in &wave.amplitudes {
                // The real part of (amplitude coefficient) (cosine + i sine).
                let factor = amplitude * coefficient;
                matrix[(*entry, row)] += factor.re;
                matrix[(*entry, row + 1)] -= factor.im;
            }
            matrix[(row, row)] = growth;
            matrix[(row + 1, row + 1)] = growth;
            matrix[(row, row + 1)] = -frequency;
            matrix[(row + 1, row)] = frequency;
            if j > 0 {
                matrix[(row, row - 2)] = j as f64;
                matrix[(row + 1, row - 1)] = j as f64;
            }
        }
        first += rows(wave);
    }
    matrix
}

//! Sensitivities in closed form: S' = A S + df/dp along the series of the motion, by
//!
//! ```text
//! S(t + h) = e^(A h) S(t) + integral over [0, h] of e^(A (h - s)) df/dp(t + s) ds
//! ```
//!
//! The integrand is as smooth as the motion, so Gauss's rule is exact to rounding.

use super::equations::Equations;
use crate::method::sensitivity::Tangents;
use crate::method::taylor::quadrature::Gauss;

/// Number of points of a step: with [`Carried::LONGEST`] = x, the error is below
/// (2 x)^(2 n)/(2^(2 n) (2 n)!).
const POINTS: usize = 16;
/// Maximum number of terms of an exponential over the distance of two points.
const TERMS: usize = 40;

/// Memory for sensitivities.
pub(super) struct Carried {
    rule: Gauss,
    directions: usize,
    zero: Vec<f64>,
    drive: Vec<f64>,
    column: Vec<f64>,
    term: Vec<f64>,
    next: Vec<f64>,
}

impl Carried {
    /// Longest step, in units of the inverse norm of A.
    pub(super) const LONGEST: f64 = 3.0;

    pub(super) fn new(tangents: &Tangents<'_>) -> Self {
        let zeros = || vec![0.0; tangents.len()];
        Self {
            rule: Gauss::new(POINTS),
            directions: tangents.by().len(),
            zero: zeros(),
            drive: zeros(),
            column: Vec::new(),
            term: Vec::new(),
            next: Vec::new(),
        }
    }

    /// Carries S over a span; `drive` computes df/dp at a time, given zeros.
    pub(super) fn carry(
        &mut self,
        equations: &Equations,
        [from, until]: [f64; 2],
        (start, into): (&[f64], &mut [f64]),
        drive: impl Fn(f64, &[f64], &mut [f64]),
    ) {
        into.copy_from_slice(start);
        let mut points: Vec<(f64, f64)> = self.rule.points(from, until).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut reached = from;
        for (time, weight) in points {
            self.propagate(equations, time - reached, into);
            drive(time, &self.zero, &mut self.drive);
            for (value, drive) in into.iter_mut().zip(&self.drive) {
                *value += weight * drive;
            }
            reached = time;
        }
        self.propagate(equations, until - reached, into);
    }

    /// Replaces S by e^(A h) S.
    fn propagate(&mut self, equations: &Equations, h: f64, tangents: &mut [f64]) {
        let states = tangents.len() / self.directions;
        for buffer in [&mut self.column, &mut self.term, &mut self.next] {
            buffer.clear();
            buffer.resize(equations.size(), 0.0);
        }
        for direction in 0..self.directions {
            let rows = || tangents.chunks_exact(self.directions).map(|row| row[direction]);
            for (value, tangent) in self.term.iter_mut().zip(rows()) {
                *value = tangent;
            }
            // Waves do not depend on S.
            self.term[states..].fill(0.0);
            self.column.copy_from_slice(&self.term);
            for order in 1..=TERMS {
                equations.apply(h / order as f64, &self.term, &mut self.next);
                std::mem::swap(&mut self.term, &mut self.next);
                let mut has_changed = false;
                for (sum, term) in self.column.iter_mut().zip(&self.term) {
                    has_changed |= (*sum + term).to_bits() != sum.to_bits();
                    *sum += term;
                }
                if !has_changed {
                    break;
                }
            }
            for (row, value) in tangents.chunks_exact_mut(self.directions).zip(&self.column) {
                row[direction] = *value;
            }
        }
    }
}

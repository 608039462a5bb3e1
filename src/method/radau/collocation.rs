//! Polynomials and matrices of a collocation method, derived from its nodes.

use crate::method::tableau::Radau;

/// A Radau method and the polynomials through its nodes.
pub(super) struct Collocation {
    pub(super) coefficients: &'static Radau,
    /// Weights of z_i in u'(0) of the polynomial through 0 at 0 and z_i at c_i.
    pub(super) slope: Vec<f64>,
    /// A, row by row: integrals of Lagrange's polynomials.
    pub(super) integrals: Vec<f64>,
    /// A^-1, row by row: slopes at the nodes of the polynomial through 0 at 0 and z_i at c_i.
    pub(super) slopes: Vec<f64>,
    /// Nodes of the divided differences: c from the last to the first, then 0.
    nodes: Vec<f64>,
}

impl Collocation {
    pub(super) fn new(coefficients: &'static Radau) -> Self {
        let c = coefficients.nodes;
        let slope = c.iter().enumerate().map(|(index, at)| {
            let others = c.iter().enumerate().filter(|(other, _)| *other != index);
            others.fold(1.0 / at, |product, (_, other)| product * other / (other - at))
        });
        Self {
            coefficients,
            slope: slope.collect(),
            integrals: integrals(coefficients),
            slopes: slopes(coefficients),
            nodes: c.iter().rev().copied().chain([0.0]).collect(),
        }
    }

    pub(super) fn stages(&self) -> usize {
        self.coefficients.nodes.len()
    }

    /// Computes divided differences of the polynomial u(theta) through the start and the stages,
    /// which are relative to the start.
    pub(super) fn differences(&self, start: &[f64], stages: &[f64], into: &mut [f64]) {
        let (len, count) = (start.len(), self.stages());
        for (node, stage) in (0..count).rev().enumerate() {
            let into = &mut into[node * len..][..len];
            for ((into, start), z) in into.iter_mut().zip(start).zip(&stages[stage * len..]) {
                *into = start + z;
            }
        }
        into[count * len..][..len].copy_from_slice(start);
        for order in 1..=count {
            for node in (order..=count).rev() {
                let inverse_span = 1.0 / (self.nodes[node] - self.nodes[node - order]);
                let (before, this) = into.split_at_mut(node * len);
                for (this, before) in this[..len].iter_mut().zip(&before[(node - 1) * len..]) {
                    *this = (*this - before) * inverse_span;
                }
            }
        }
    }

    /// Computes u(theta) from its divided differences.
    pub(super) fn evaluate(&self, differences: &[f64], theta: f64, into: &mut [f64]) {
        let (len, count) = (into.len(), self.stages());
        into.copy_from_slice(&differences[count * len..][..len]);
        for (node, at) in self.nodes[..count].iter().enumerate().rev() {
            for (into, difference) in into.iter_mut().zip(&differences[node * len..]) {
                *into = difference + (theta - at) * *into;
            }
        }
    }

    /// Computes u'(theta) from its divided differences.
    pub(super) fn slope_at(&self, differences: &[f64], theta: f64, into: &mut [f64]) {
        let (len, count) = (into.len(), self.stages());
        for (index, into) in into.iter_mut().enumerate() {
            let (mut value, mut slope) = (differences[count * len + index], 0.0);
            for (node, at) in self.nodes[..count].iter().enumerate().rev() {
                slope = value + (theta - at) * slope;
                value = differences[node * len + index] + (theta - at) * value;
            }
            *into = slope;
        }
    }
}

/// Returns A = T D^-1 T^-1 with the block diagonal D.
fn integrals(coefficients: &Radau) -> Vec<f64> {
    between(coefficients, 1.0 / coefficients.real, |(a, b)| {
        let size = a * a + b * b;
        (a / size, -b / size)
    })
}

/// Returns A^-1 = T D T^-1.
fn slopes(coefficients: &Radau) -> Vec<f64> {
    between(coefficients, coefficients.real, |pair| pair)
}

/// Returns T B T^-1 of a block diagonal B, with a number first and then blocks \[a, -b; b, a\].
fn between(coefficients: &Radau, first: f64, block: impl Fn((f64, f64)) -> (f64, f64)) -> Vec<f64> {
    let count = coefficients.nodes.len();
    let mut matrix = vec![0.0; count * count];
    for column in 0..count {
        let of = |row: usize| coefficients.inverse[row * count + column];
        let mut inner = vec![first * of(0)];
        for (pair, blocks) in coefficients.pairs.iter().enumerate() {
            let (upper, lower) = (of(1 + 2 * pair), of(2 + 2 * pair));
            let (a, b) = block(*blocks);
            inner.push(a * upper - b * lower);
            inner.push(b * upper + a * lower);
        }
        for row in 0..count {
            let transform = &coefficients.transform[row * count..][..count];
            matrix[row * count + column] =
                transform.iter().zip(&inner).map(|(t, inner)| t * inner).sum();
        }
    }
    matrix
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::tableau::RADAU;

    #[test]
    fn the_methods_integrate_polynomials_exactly_and_their_last_stage_twice_as_high() {
        for coefficients in &RADAU {
            let method = Collocation::new(coefficients);
            let count = method.stages();
            let c = coefficients.nodes;
            for power in 0..2 * count as i32 - 1 {
                for row in 0..count {
                    let exact = c[row].powi(power + 1) / f64::from(power + 1);
                    let weights = &method.integrals[row * count..][..count];
                    let sum: f64 = weights.iter().zip(c).map(|(a, c)| a * c.powi(power)).sum();
                    let is_exact = (sum - exact).abs() < 1e-13;
                    if power < count as i32 || row + 1 == count {
                        assert!(is_exact, "{count} stages, row {row}, {power}: {sum} {exact}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_polynomial_is_met_everywhere_and_so_is_its_slope_at_the_start() {
        for coefficients in &RADAU {
            let method = Collocation::new(coefficients);
            let count = method.stages();
            let value = |theta: f64| 3.0 - 2.0 * theta + theta.powi(count as i32);
            let stages: Vec<f64> =
                coefficients.nodes.iter().map(|c| value(*c) - value(0.0)).collect();
            let mut differences = vec![0.0; count + 1];
            method.differences(&[value(0.0)], &stages, &mut differences);
            for theta in [0.0, 0.17, 0.9, 1.0, 2.5] {
                let mut found = [0.0];
                method.evaluate(&differences, theta, &mut found);
                assert!((found[0] / value(theta) - 1.0).abs() < 1e-11, "{theta}: {found:?}");
            }
            for theta in [0.0, 0.5, 1.0] {
                let mut found = [0.0];
                method.slope_at(&differences, theta, &mut found);
                let exact = -2.0 + count as f64 * theta.powi(count as i32 - 1);
                assert!((found[0] - exact).abs() < 1e-10, "{theta}: {found:?}");
            }
            let slope: f64 = method.slope.iter().zip(&stages).map(|(w, z)| w * z).sum();
            assert!((slope + 2.0).abs() < 1e-12, "{slope}");
        }
    }
}

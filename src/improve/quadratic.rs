//! Small convex quadratic problems with inequalities, solved by an interior-point method.
//!
//! ```text
//! min 1/2 x^T H x + g^T x,   C x <= b
//! ```
//!
//! With slacks w = b - C x and multipliers z, both positive, the method applies Newton's method to
//! w z = sigma mu (S. Mehrotra, On the implementation of a primal-dual interior point method, SIAM
//! J. Optim. 2, 1992). H need not be positive definite if the problem is bounded.

use nalgebra::{DMatrix, DVector};

const ITERATIONS: usize = 100;
const ACCURACY: f64 = 1e-11;

/// A convex quadratic problem.
pub(super) struct Quadratic {
    /// H.
    pub hessian: DMatrix<f64>,
    /// g.
    pub gradient: DVector<f64>,
    /// C.
    pub rows: DMatrix<f64>,
    /// b.
    pub limits: DVector<f64>,
}

impl Quadratic {
    /// Returns x and the multipliers z, accurate to rounding, from a guess; `None` if there is no
    /// solution.
    pub fn solve(&self, guess: &DVector<f64>) -> Option<(DVector<f64>, DVector<f64>)> {
        let (n, m) = (self.gradient.len(), self.limits.len());
        let mut x = guess.clone();
        let mut w = (&self.limits - &self.rows * &x).map(|slack| slack.max(1.0));
        let mut z = DVector::from_element(m, 1.0);
        let size = 1.0 + self.gradient.amax().max(self.limits.amax());
        for _ in 0..ITERATIONS {
            let dual = &self.hessian * &x + &self.gradient + self.rows.tr_mul(&z);
            let primal = &self.rows * &x + &w - &self.limits;
            let gap = w.dot(&z) / m as f64;
            if dual.amax().max(primal.amax()).max(gap) <= ACCURACY * size {
                return Some((x, z));
            }
            let mut matrix = self.hessian.clone();
            for row in 0..m {
                let weight = z[row] / w[row];
                let entries = self.rows.row(row);
                matrix.ger(weight, &entries.transpose(), &entries.transpose(), 1.0);
            }
            // Regularizes directions that nothing restrains yet.
            for index in 0..n {
                matrix[(index, index)] += 1e-13 * (1.0 + self.hessian[(index, index)]);
            }
            let factors = matrix.lu();
            let step = |complement: &DVector<f64>| {
                let shift = (z.component_mul(&primal) - complement).component_div(&w);
                let dx = factors.solve(&(-&dual - self.rows.tr_mul(&shift)))?;
                let of_rows = &self.rows * &dx;
                let dz = shift + z.component_mul(&of_rows).component_div(&w);
                Some((dx, -&primal - of_rows, dz))
            };
            let (_, dw, dz) = step(&w.component_mul(&z))?;
            let share = longest(&w, &dw).min(longest(&z, &dz));
            let ahead = (&w + &dw * share).dot(&(&z + &dz * share)) / m as f64;
            let sigma = (ahead / gap).clamp(0.0, 1.0).powi(3);
            // The gap must not decrease faster than the other conditions are met, since products of
            // zero lose all digits.
            let target = (sigma * gap).max(0.01 * ACCURACY * size);
            let complement =
                w.component_mul(&z) + dw.component_mul(&dz) - DVector::from_element(m, target);
            let (dx, dw, dz) = step(&complement)?;
            let share = (0.995 * longest(&w, &dw).min(longest(&z, &dz))).min(1.0);
            x += dx * share;
            w += dw * share;
            z += dz * share;
            if !x.iter().chain(&z).all(|value| value.is_finite()) {
                return None;
            }
        }
        let dual = &self.hessian * &x + &self.gradient + self.rows.tr_mul(&z);
        let gap = w.dot(&z) / m as f64;
        (gap.max(dual.amax()) <= ACCURACY.sqrt() * size).then_some((x, z))
    }
}

/// Returns the longest step, at most 1, for which positive numbers stay positive.
fn longest(values: &DVector<f64>, steps: &DVector<f64>) -> f64 {
    let ends = values.iter().zip(steps).filter(|(_, step)| **step < 0.0);
    ends.map(|(value, step)| -value / step).fold(1.0, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Solutions of random problems fulfil the Karush-Kuhn-Tucker conditions.
    #[test]
    fn solutions_fulfil_their_conditions() {
        let mut random = fastrand::Rng::with_seed(7);
        for (n, m) in [(1_usize, 1), (2, 5), (5, 3), (8, 40), (15, 30)] {
            for rank in [n, n.div_ceil(2)] {
                let of = |rng: &mut fastrand::Rng| rng.f64() - 0.5;
                let root = DMatrix::from_fn(rank, n, |_, _| of(&mut random));
                let mut rows = DMatrix::from_fn(m, n, |_, _| of(&mut random))
                    .resize_vertically(m + 2 * n, 0.0);
                let mut limits = DVector::from_fn(m + 2 * n, |_, _| random.f64() + 0.05);
                // A box makes the problem bounded.
                for k in 0..n {
                    rows[(m + 2 * k, k)] = 1.0;
                    rows[(m + 2 * k + 1, k)] = -1.0;
                    limits[m + 2 * k] = 3.0;
                    limits[m + 2 * k + 1] = 3.0;
                }
                let problem = Quadratic {
                    hessian: root.transpose() * &root,
                    gradient: DVector::from_fn(n, |_, _| 4.0 * of(&mut random)),
                    rows,
                    limits,
                };
                let (x, z) = problem.solve(&DVector::zeros(n)).expect("it has a solution");
                let slack = &problem.limits - &problem.rows * &x;
                assert!(slack.min() > -1e-9 && z.min() >= 0.0, "{slack} {z}");
                let gradient = &problem.hessian * &x + &problem.gradient + problem.rows.tr_mul(&z);
                assert!(gradient.amax() < 1e-8, "{gradient}");
                assert!(slack.component_mul(&z).amax() < 1e-8);
            }
        }
    }
}

//! Coefficients of methods as data, for programs that run a method elsewhere, such as a page that
//! runs a machine.

use serde::Serialize;

use super::tableau::{DOP853, Pair, RODAS5P, Row, TSIT5};

/// Coefficients of an explicit Runge-Kutta pair whose last stage is the rate at the end of the
/// step. Rows are nonzeros, as (stage, coefficient).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExplicitTable {
    /// Name of the method.
    pub name: &'static str,
    /// Order of the solution.
    pub order: u32,
    /// c of the stages, then of those that only the dense output needs.
    pub nodes: &'static [f64],
    /// a of the stages; the last row is b.
    pub rows: Vec<Row>,
    /// a of stages that only the dense output needs.
    pub extra: Vec<Row>,
    /// Differences of b and embedded weights. If there are two, E of order 5 and G of order 3,
    /// the error is |E|^2 / sqrt(|E|^2 + 0.01 |G|^2).
    pub estimates: Vec<Row>,
    /// The error is proportional to the step to the power of this plus one.
    pub estimate_order: u32,
    /// b_i(theta) of y(t + theta h) = y + h sum b_i(theta) k_i, by powers of theta from 0 on.
    pub dense: Vec<Vec<f64>>,
    /// |h lambda| on the negative real axis from which on stability limits steps.
    pub stability: f64,
}

/// Coefficients of a Rosenbrock method of eight stages:
///
/// ```text
/// (I / (gamma h) - J) U_i = f(t + c_i h, Y_i) + sum_j C_ij U_j / h + d_i h f_t
/// Y_i = y + sum_j a_ij U_j
/// ```
///
/// with the last stage as error estimate.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RosenbrockTable {
    /// Name of the method.
    pub name: &'static str,
    /// Coefficient gamma.
    pub gamma: f64,
    /// Nodes c.
    pub nodes: &'static [f64],
    /// Weights d of the time derivative.
    pub time_weights: &'static [f64],
    /// a of the stages, then of the state at the end of the step. A row that begins with the
    /// previous stage continues the previous row.
    pub states: &'static [Row],
    /// Coefficients C.
    pub stages: &'static [Row],
    /// Weights of D_1, D_2, D_3 in the dense output, with s = 1 - theta,
    /// y(t + theta h) = s y + theta (y_new + s (D_1 + theta (D_2 + theta D_3))).
    pub dense: &'static [[f64; 8]; 3],
}

/// Returns the coefficients of `tsit5`.
#[must_use]
pub fn tsit5() -> ExplicitTable {
    explicit("tsit5", &TSIT5, 4)
}

/// Returns the coefficients of `dop853`.
#[must_use]
pub fn dop853() -> ExplicitTable {
    explicit("dop853", &DOP853, 7)
}

/// Returns the coefficients of `rodas5p`.
#[must_use]
pub fn rodas5p() -> RosenbrockTable {
    RosenbrockTable {
        name: "rodas5p",
        gamma: RODAS5P.gamma,
        nodes: RODAS5P.nodes,
        time_weights: RODAS5P.time_weights,
        states: RODAS5P.states,
        stages: RODAS5P.stages,
        dense: RODAS5P.dense,
    }
}

/// Returns the coefficients of a pair whose dense output has this degree in theta.
fn explicit(name: &'static str, pair: &Pair, degree: usize) -> ExplicitTable {
    let stages = pair.nodes.len();
    ExplicitTable {
        name,
        order: pair.order,
        nodes: pair.nodes,
        rows: pair.rows.to_vec(),
        extra: pair.dense.extra.to_vec(),
        estimates: pair.estimates.to_vec(),
        estimate_order: pair.estimate_order,
        dense: polynomials(pair.dense.weights, stages, degree),
        stability: pair.stability,
    }
}

/// Returns the coefficients of the polynomials that `weights` evaluates, from values between 0 and
/// 1 by Newton's divided differences.
fn polynomials(weights: fn(f64, &mut [f64]), stages: usize, degree: usize) -> Vec<Vec<f64>> {
    let nodes: Vec<f64> = (0..=degree).map(|k| k as f64 / degree as f64).collect();
    let mut rows = vec![vec![0.0; stages]; nodes.len()];
    nodes.iter().zip(&mut rows).for_each(|(theta, row)| weights(*theta, row));
    let of_stage = |stage: usize| {
        let mut differences: Vec<f64> = rows.iter().map(|row| row[stage]).collect();
        for order in 1..=degree {
            for k in (order..=degree).rev() {
                let span = nodes[k] - nodes[k - order];
                differences[k] = (differences[k] - differences[k - 1]) / span;
            }
        }
        let mut polynomial = vec![0.0; degree + 1];
        for k in (0..=degree).rev() {
            // p <- p (theta - node) + difference
            for power in (1..=degree).rev() {
                polynomial[power] = polynomial[power - 1] - nodes[k] * polynomial[power];
            }
            polynomial[0] = differences[k] - nodes[k] * polynomial[0];
        }
        polynomial
    };
    (0..stages).map(of_stage).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_the_weights_of_the_dense_output() {
        for (table, pair) in [(tsit5(), &TSIT5), (dop853(), &DOP853)] {
            let mut weights = vec![0.0; pair.nodes.len()];
            for theta in [0.0, 0.07, 0.31, 0.5, 0.77, 0.95, 1.0] {
                (pair.dense.weights)(theta, &mut weights);
                for (polynomial, weight) in table.dense.iter().zip(&weights) {
                    let value = polynomial.iter().rev().fold(0.0, |sum, c| sum * theta + c);
                    assert!((value - weight).abs() < 1e-12, "{} at {theta}", table.name);
                }
            }
        }
    }
}

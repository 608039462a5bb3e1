//! Coefficients of methods, as published.

#[cfg(all(test, feature = "implicit"))]
mod conditions;
mod dop853;
#[cfg(feature = "implicit")]
mod radau;
#[cfg(feature = "implicit")]
mod rodas5p;
mod tsit5;

pub(super) use dop853::DOP853;
#[cfg(feature = "implicit")]
pub(super) use radau::{RADAU, Radau};
#[cfg(feature = "implicit")]
pub(super) use rodas5p::RODAS5P;
pub(super) use tsit5::TSIT5;

/// Nonzeros of a row of coefficients, as (stage, coefficient).
pub(super) type Row = &'static [(usize, f64)];

/// An explicit Runge-Kutta pair whose last stage is the rate at the end of the step, and so the
/// first stage of the next one:
///
/// ```text
/// Y_i = y + h sum_j a_ij k_j     k_i = f(t + c_i h, Y_i)     y_new = Y_s
/// ```
pub(super) struct Pair {
    /// Order of the solution.
    pub(super) order: u32,
    /// c of the stages, then of the extra stages.
    pub(super) nodes: &'static [f64],
    /// a of the stages; the last row is b.
    pub(super) rows: &'static [Row],
    /// Differences of b and embedded weights. If there are two, E of order 5 and G of order 3, the
    /// error is |E|^2 / sqrt(|E|^2 + 0.01 |G|^2).
    pub(super) estimates: &'static [Row],
    /// The error is proportional to the step to the power of this plus one.
    pub(super) estimate_order: u32,
    /// Dense output.
    pub(super) dense: Dense,
    /// |h lambda| on the negative real axis from which on stability limits steps.
    #[cfg_attr(not(feature = "implicit"), expect(dead_code, reason = "only `auto` asks"))]
    pub(super) stability: f64,
}

/// Dense output, y(t + theta h) = y + h sum b_i(theta) k_i.
pub(super) struct Dense {
    /// a of stages that only the dense output needs.
    pub(super) extra: &'static [Row],
    /// Writes b_i(theta) of all stages, with the extra ones last.
    pub(super) weights: fn(f64, &mut [f64]),
}

/// A Rosenbrock method, transformed so that no product of the Jacobian J and a stage occurs
/// (Hairer, Wanner, section IV.7):
///
/// ```text
/// (I / (gamma h) - J) U_i = f(t + c_i h, Y_i) + sum_j C_ij U_j / h + d_i h f_t
/// Y_i = y + sum_j a_ij U_j
/// ```
///
/// with the last stage as error estimate.
#[cfg(feature = "implicit")]
pub(super) struct Rosenbrock {
    pub(super) gamma: f64,
    /// Nodes c.
    pub(super) nodes: &'static [f64],
    /// Weights d of the time derivative.
    pub(super) time_weights: &'static [f64],
    /// a of the stages, then of the state at the end of the step. A row that begins with the
    /// previous stage continues the previous row.
    pub(super) states: &'static [Row],
    /// Coefficients C.
    pub(super) stages: &'static [Row],
    /// Weights of D_1, D_2, D_3 in the dense output, with s = 1 - theta,
    /// y(t + theta h) = s y + theta (y_new + s (D_1 + theta (D_2 + theta D_3))).
    pub(super) dense: &'static [[f64; 8]; 3],
}

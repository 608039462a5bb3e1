// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   ef48162a946ddc57dd12cffaaaec9577a23b3bf16158d2ca3a5ee610a9bdf6ef  bench/m6_2.toml
//
// Benchmark M6: planar pendulum of 2 links
//
// Point masses on 2 massless links, angles from the downward vertical, released
// horizontal and at rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        0
//   states                    4
//   parameters                0
//   outputs                   4
//   discontinuities           0
//
// State:
//     0  chain.theta_1  [rad]    angle of link 1 from the vertical
//     1  chain.theta_2  [rad]    angle of link 2 from the vertical
//     2  chain.omega_1  [rad/s]  rate of angle of link 1 from the vertical
//     3  chain.omega_2  [rad/s]  rate of angle of link 2 from the vertical
//
// Nonzeros:
//   mass_matrix               4 of 2 by 2
//   rate_jacobian            10 of 4 by 4
//   parameter_jacobian        0 of 4 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     29
//   mass_matrix               2
//   forcing                  13
//   rate_jacobian            68
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                   22
//   power_balance            68

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 4;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (0, 1), (1, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 4,
    entries: &[
        (0, 2), (1, 3), (2, 0), (2, 1), (2, 2), (2, 3), (3, 0), (3, 1), (3, 2), (3, 3),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 0,
    entries: &[],
};

/// Benchmark M6: planar pendulum of 2 links
///
/// Point masses on 2 massless links, angles from the downward vertical, released
/// horizontal and at rest.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M62;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// Nothing; there are no numbers here.
    pub real: core::marker::PhantomData<R>,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(_values: [R; PARAMETERS]) -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        []
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// theta_1: angle of link 1 from the vertical \[rad\].
    pub theta_1: R,
    /// theta_2: angle of link 2 from the vertical \[rad\].
    pub theta_2: R,
    /// omega_1: rate of angle of link 1 from the vertical \[rad/s\].
    pub omega_1: R,
    /// omega_2: rate of angle of link 2 from the vertical \[rad/s\].
    pub omega_2: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            theta_1: values[0],
            theta_2: values[1],
            omega_1: values[2],
            omega_2: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.theta_1, self.theta_2, self.omega_1, self.omega_2]
    }
}

/// Where to find what in the state.
pub mod state {
    /// chain.theta_1: angle of link 1 from the vertical \[rad\].
    pub const CHAIN_THETA_1: usize = 0;
    /// chain.theta_2: angle of link 2 from the vertical \[rad\].
    pub const CHAIN_THETA_2: usize = 1;
    /// chain.omega_1: rate of angle of link 1 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_1: usize = 2;
    /// chain.omega_2: rate of angle of link 2 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_2: usize = 3;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 29 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    ] = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2)
        .sub_product(cos_chain_theta_1, sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2)
        .add_product(sin_chain_theta_1, sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = (-(R::literal(19.62) * sin_chain_theta_1))
        .sub_product(chain_omega_2 * chain_omega_2, t0);
    let chain_omega_2_dot = (-(R::literal(9.81) * sin_chain_theta_2))
        .add_product(chain_omega_1 * chain_omega_1, t0)
        .sub_product(t2, t3) * (R::literal(1.0) / R::literal(1.0).sub_product(t2, t1));
    let chain_omega_1_dot = (t3 * R::literal(0.5)).sub_product(t2, chain_omega_2_dot);
    [chain_omega_1, chain_omega_2, chain_omega_1_dot, chain_omega_2_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 4] {
    let [chain_theta_1, chain_theta_2, ..] = *state;
    let t0 = (chain_theta_1 - chain_theta_2).cos();
    [R::literal(2.0), t0, t0, R::literal(1.0)]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 13 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, _), (sin_chain_theta_2, _), (t0, _)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_1 - chain_theta_2,
    ]);
    let chain_theta_1_forcing = (-(R::literal(19.62) * sin_chain_theta_1))
        .sub_product(chain_omega_2 * chain_omega_2, t0);
    let chain_theta_2_forcing = (-(R::literal(9.81) * sin_chain_theta_2))
        .add_product(chain_omega_1 * chain_omega_1, t0);
    [chain_theta_1_forcing, chain_theta_2_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 68 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 10] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    ] = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2)
        .sub_product(cos_chain_theta_1, sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2)
        .add_product(sin_chain_theta_1, sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = R::literal(1.0) / R::literal(1.0).sub_product(t2, t1);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t4 = (-(R::literal(19.62) * sin_chain_theta_1))
        .sub_product(chain_omega_2_squared, t0);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_omega_2_dot = (-(R::literal(9.81) * sin_chain_theta_2))
        .add_product(chain_omega_1_squared, t0)
        .sub_product(t2, t4) * t3;
    let chain_omega_1_dot = (t4 * R::literal(0.5)).sub_product(t2, chain_omega_2_dot);
    let t5 = chain_omega_2_squared * t1;
    let t6 = chain_omega_1_squared * t1;
    let t7 = t0 * chain_omega_2_dot;
    let t8 = (-t5).sub_product(R::literal(19.62), cos_chain_theta_1) + t7;
    let t9 = t0 * chain_omega_1_dot;
    let chain_omega_2_dot_by_chain_theta_1 = (t6 + t9).sub_product(t2, t8) * t3;
    let chain_omega_1_dot_by_chain_theta_1 = (t8 * R::literal(0.5))
        .sub_product(t2, chain_omega_2_dot_by_chain_theta_1);
    let t10 = t5 - t7;
    let chain_omega_2_dot_by_chain_theta_2 = ((-t6)
        .sub_product(R::literal(9.81), cos_chain_theta_2) - t9)
        .sub_product(t2, t10) * t3;
    let chain_omega_1_dot_by_chain_theta_2 = (t10 * R::literal(0.5))
        .sub_product(t2, chain_omega_2_dot_by_chain_theta_2);
    let chain_omega_2_dot_by_chain_omega_1 = R::literal(2.0) * chain_omega_1 * t0 * t3;
    let chain_omega_1_dot_by_chain_omega_1 = -(t2 * chain_omega_2_dot_by_chain_omega_1);
    let t11 = R::literal(2.0) * chain_omega_2 * t0;
    let chain_omega_2_dot_by_chain_omega_2 = t2 * t11 * t3;
    let chain_omega_1_dot_by_chain_omega_2 = (-(t11 * R::literal(0.5)))
        .sub_product(t2, chain_omega_2_dot_by_chain_omega_2);
    [
        R::literal(1.0),
        R::literal(1.0),
        chain_omega_1_dot_by_chain_theta_1,
        chain_omega_1_dot_by_chain_theta_2,
        chain_omega_1_dot_by_chain_omega_1,
        chain_omega_1_dot_by_chain_omega_2,
        chain_omega_2_dot_by_chain_theta_1,
        chain_omega_2_dot_by_chain_theta_2,
        chain_omega_2_dot_by_chain_omega_1,
        chain_omega_2_dot_by_chain_omega_2,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time.
///
/// No operations.
#[must_use]
pub fn time_derivative<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 22 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    ] = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    Energy {
        kinetic: R::literal(0.5)
            * (chain_u_1 * chain_u_1)
                .add_product(chain_v_1, chain_v_1)
                .add_product(chain_u_2, chain_u_2)
                .add_product(chain_v_2, chain_v_2),
        potential: R::literal(9.81)
            * (-cos_chain_theta_2).sub_product(R::literal(2.0), cos_chain_theta_1),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 68 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    (t0, t1)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_1_minus_chain_theta_2,
    ]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = R::literal(19.62) * sin_chain_theta_1;
    let t4 = (-t3).sub_product(chain_omega_2 * chain_omega_2, t0);
    let t5 = R::literal(9.81) * sin_chain_theta_2;
    let chain_omega_2_dot = (-t5)
        .add_product(chain_omega_1 * chain_omega_1, t0)
        .sub_product(t2, t4) * (R::literal(1.0) / R::literal(1.0).sub_product(t2, t1));
    let chain_omega_1_dot = (t4 * R::literal(0.5)).sub_product(t2, chain_omega_2_dot);
    let t6 = R::literal(2.0) * chain_omega_2;
    let t7 = R::literal(2.0) * chain_v_1;
    let t8 = R::literal(2.0) * chain_u_1;
    let t9 = R::literal(2.0) * chain_u_2;
    let t10 = R::literal(2.0) * chain_v_2;
    PowerBalance {
        stored_rate: (t3
            .add_product(R::literal(0.5), (t8 * chain_v_2).sub_product(t7, chain_u_2))
            * chain_omega_1)
            .add_product(
                t5
                    .add_product(
                        R::literal(0.5),
                        (t6 * chain_v_2 * cos_chain_theta_2)
                            .sub_product(t6 * chain_u_2, sin_chain_theta_2),
                    ),
                chain_omega_2,
            )
            .add_product(
                R::literal(0.5)
                    * (t8 * cos_chain_theta_1)
                        .add_product(t7, sin_chain_theta_1)
                        .add_product(t9, cos_chain_theta_1)
                        .add_product(t10, sin_chain_theta_1),
                chain_omega_1_dot,
            )
            .add_product(
                R::literal(0.5)
                    * (t9 * cos_chain_theta_2).add_product(t10, sin_chain_theta_2),
                chain_omega_2_dot,
            ),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 30 recurrences. 12 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let t0 = chain_theta_1 - chain_theta_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let sin_chain_theta_1 = chain_theta_1.sin();
    let cos_chain_theta_1 = chain_theta_1.cos();
    let sin_chain_theta_2 = chain_theta_2.sin();
    let cos_chain_theta_2 = chain_theta_2.cos();
    let t3 = sin_chain_theta_1 * R::literal(19.62);
    let t4 = chain_omega_2 * chain_omega_2;
    let t5 = t4 * t1;
    let t6 = -t3;
    let t7 = t6 - t5;
    let t8 = sin_chain_theta_2 * R::literal(9.81);
    let t9 = chain_omega_1 * chain_omega_1;
    let t10 = t9 * t1;
    let t11 = t10 - t8;
    let factored = Factored::new([
        [R::literal(2.0), R::literal(0.0)],
        [t2, R::literal(1.0)],
    ]);
    let [chain_omega_1_dot, chain_omega_2_dot] = factored.solve([t7, t11]);
    let mut rates = [chain_omega_1, chain_omega_2, chain_omega_1_dot, chain_omega_2_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_theta_1_k, chain_theta_2_k, chain_omega_1_k, chain_omega_2_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_1[2]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_1[3]);
        let sin_chain_theta_1_k = chain_theta_1_k
            .mul_add(cos_chain_theta_1, inverse * sums[2]);
        let cos_chain_theta_1_k = -chain_theta_1_k
            .mul_add(sin_chain_theta_1, inverse * sums[3]);
        let sin_chain_theta_2_k = chain_theta_2_k
            .mul_add(cos_chain_theta_2, inverse * sums_1[0]);
        let cos_chain_theta_2_k = -chain_theta_2_k
            .mul_add(sin_chain_theta_2, inverse * sums_1[1]);
        let t3_k = sin_chain_theta_1_k * R::literal(19.62);
        let t4_k = (chain_omega_2 + chain_omega_2).mul_add(chain_omega_2_k, sums[0]);
        let t5_k = t4.mul_add(t1_k, t1.mul_add(t4_k, sums_2[0]));
        let t6_k = -t3_k;
        let t7_k = t6_k - t5_k;
        let t9_k = (chain_omega_1 + chain_omega_1).mul_add(chain_omega_1_k, sums[1]);
        let t10_k = t9.mul_add(t1_k, t1.mul_add(t9_k, sums_2[1]));
        let t11_k = (-sin_chain_theta_2_k).mul_add(R::literal(9.81), t10_k);
        let n26_k = t2_k.mul_add(chain_omega_2_dot, sums_2[2]);
        let n27_k = t2_k.mul_add(chain_omega_1_dot, sums_2[3]);
        let t7_k_2 = t7_k - n26_k;
        let t11_k_2 = t11_k - n27_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k] = factored
            .solve([t7_k_2, t11_k_2]);
        lanes
            .set(
                order,
                [
                    chain_omega_2_k,
                    chain_omega_1_k,
                    k * chain_theta_1_k,
                    k * chain_theta_1_k,
                ],
                [
                    chain_omega_2_k,
                    chain_omega_1_k,
                    cos_chain_theta_1_k,
                    sin_chain_theta_1_k,
                ],
            );
        lanes_1
            .set(
                order,
                [k * chain_theta_2_k, k * chain_theta_2_k, k * t0_k, k * t0_k],
                [cos_chain_theta_2_k, sin_chain_theta_2_k, t2_k, t1_k],
            );
        lanes_2
            .set(
                order,
                [t1_k, t1_k, t2_k, t2_k],
                [t4_k, t9_k, chain_omega_2_dot_k, chain_omega_1_dot_k],
            );
        rates = [
            chain_omega_1_k,
            chain_omega_2_k,
            chain_omega_1_dot_k,
            chain_omega_2_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M62 {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1)
    }
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    ) {
        let (coefficients, rest) = coefficients.as_chunks_mut();
        assert!(rest.is_empty(), "every order has STATES coefficients");
        let p = parameters_of(parameters);
        series(time, state_of(state), &p, coefficients, workspace);
    }
}

impl Describe for M62 {
    fn name(&self) -> &'static str {
        "m6_2"
    }
    fn title(&self) -> &'static str {
        "Benchmark M6: planar pendulum of 2 links"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
            first_order: 0,
            quadratures: 0,
            parameters: PARAMETERS,
            outputs: OUTPUTS,
            discontinuities: DISCONTINUITIES,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        STATE_QUANTITIES[index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        STATE_SCALES[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        PARAMETER_QUANTITIES[index]
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETER_DEFAULTS[index]
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        OUTPUT_QUANTITIES[index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        RATE_JACOBIAN_PATTERN
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        PARAMETER_JACOBIAN_PATTERN
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        MASS_MATRIX_PATTERN
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RUN_DEFAULTS
    }
}

impl<R: Real> Simulator<R> for M62 {
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = initial_state(&parameters_of(parameters));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = discontinuities(&parameters_of(parameters));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate(time, state_of(state), &parameters_of(parameters));
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = time_derivative(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = mass_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = forcing(time, state_of(state), &parameters_of(parameters));
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = outputs(time, state_of(state), &parameters_of(parameters))
            .to_array();
    }
    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        energy(time, state_of(state), &parameters_of(parameters))
    }
    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        power_balance(time, state_of(state), &parameters_of(parameters))
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
}

#[inline]
fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there is one place for each value")
}

#[inline]
fn state_of<R>(state: &[R]) -> &[R; STATES] {
    state.try_into().expect("the state has STATES entries")
}

#[inline]
fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
    let values: &[R; PARAMETERS] = parameters
        .try_into()
        .expect("there are PARAMETERS parameters");
    Parameters::from_array(*values)
}

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "chain.theta_1",
        unit: "rad",
        doc: "angle of link 1 from the vertical",
    },
    Quantity {
        name: "chain.theta_2",
        unit: "rad",
        doc: "angle of link 2 from the vertical",
    },
    Quantity {
        name: "chain.omega_1",
        unit: "rad/s",
        doc: "rate of angle of link 1 from the vertical",
    },
    Quantity {
        name: "chain.omega_2",
        unit: "rad/s",
        doc: "rate of angle of link 2 from the vertical",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 5.0, 5.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "theta_1",
        unit: "rad",
        doc: "angle of link 1 from the vertical",
    },
    Quantity {
        name: "theta_2",
        unit: "rad",
        doc: "angle of link 2 from the vertical",
    },
    Quantity {
        name: "omega_1",
        unit: "rad/s",
        doc: "rate of angle of link 1 from the vertical",
    },
    Quantity {
        name: "omega_2",
        unit: "rad/s",
        doc: "rate of angle of link 2 from the vertical",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   7d388a47fd1dfbf90012cc740a5f629fa5ae966ab909b9171f20f156f5c8b876  bench/m6_2.toml
//
// Benchmark M6: planar pendulum of 2 links
//
// Point masses on 2 massless links, angles from the downward vertical, released horizontal and at
// rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 2, states 4, outputs 4.
// Nonzeros: mass_matrix 4 of 2 by 2, rate_jacobian 10 of 4 by 4, parameter_jacobian 0 of 4 by 0.
// Operations: rate 28, mass_matrix 2, forcing 12, rate_jacobian 64, energy 21, power_balance 67.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Benchmark M6: planar pendulum of 2 links
    ///
    /// Point masses on 2 massless links, angles from the downward vertical, released horizontal and at
    /// rest.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M62: "m6_2", "Benchmark M6: planar pendulum of 2 links";
    run from 0.0, until 5.0, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    series 12;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    theta_1: "rad", "theta_1", "angle of link 1 from the vertical";
    theta_2: "rad", "theta_2", "angle of link 2 from the vertical";
    omega_1: "rad/s", "omega_1", "rate of angle of link 1 from the vertical";
    omega_2: "rad/s", "omega_2", "rate of angle of link 2 from the vertical";
}

::machinist_contract::states! {
    CHAIN_THETA_1: position, 1.0, "rad", "chain.theta_1", "angle of link 1 from the vertical";
    CHAIN_THETA_2: position, 1.0, "rad", "chain.theta_2", "angle of link 2 from the vertical";
    CHAIN_OMEGA_1: velocity, 5.0, "rad/s", "chain.omega_1", "rate of angle of link 1 from the vertical";
    CHAIN_OMEGA_2: velocity, 5.0, "rad/s", "chain.omega_2", "rate of angle of link 2 from the vertical";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0 1] 1 [0 1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 4 by 4 { 0 [2] 1 [3] 2 [0 1 2 3] 3 [0 1 2 3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 4 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(core::f64::consts::FRAC_PI_2), R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 28 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = (R::literal(19.62) * sin_chain_theta_1).add_product(chain_omega_2 * chain_omega_2, t0);
    let chain_omega_2_dot = (R::literal(-9.81) * sin_chain_theta_2).add_product(chain_omega_1
        * chain_omega_1, t0).add_product(t2, t3) * (R::literal(1.0) / R::literal(1.0)
        .sub_product(t2, t1));
    let chain_omega_1_dot = (t3 * R::literal(-0.5)).sub_product(t2, chain_omega_2_dot);
    [chain_omega_1, chain_omega_2, chain_omega_1_dot, chain_omega_2_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 4] {
    let [chain_theta_1, chain_theta_2, ..] = *state;
    let t0 = (chain_theta_1 - chain_theta_2).cos();
    [R::literal(2.0), t0, t0, R::literal(1.0)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 12 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, _), (sin_chain_theta_2, _), (t0, _)] = R::sin_cos_each([chain_theta_1,
        chain_theta_2, chain_theta_1 - chain_theta_2]);
    let chain_theta_1_forcing = (R::literal(-19.62) * sin_chain_theta_1).sub_product(chain_omega_2
        * chain_omega_2, t0);
    let chain_theta_2_forcing = (R::literal(-9.81) * sin_chain_theta_2).add_product(chain_omega_1
        * chain_omega_1, t0);
    [chain_theta_1_forcing, chain_theta_2_forcing]
}

/// `dy'/dy`, values in the order of its pattern. 64 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 10] {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2).sub_product(cos_chain_theta_1,
        sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2).add_product(sin_chain_theta_1,
        sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = R::literal(1.0) / R::literal(1.0).sub_product(t2, t1);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t4 = (R::literal(19.62) * sin_chain_theta_1).add_product(chain_omega_2_squared, t0);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_omega_2_dot = (R::literal(-9.81) * sin_chain_theta_2)
        .add_product(chain_omega_1_squared, t0).add_product(t2, t4) * t3;
    let t5 = chain_omega_2_squared * t1;
    let t6 = chain_omega_1_squared * t1;
    let t7 = t0 * chain_omega_2_dot;
    let t8 = t7 - t5.add_product(R::literal(19.62), cos_chain_theta_1);
    let t9 = t0 * (t4 * R::literal(0.5)).add_product(t2, chain_omega_2_dot);
    let chain_omega_2_dot_by_chain_theta_1 = (t6 - t9).sub_product(t2, t8) * t3;
    let chain_omega_1_dot_by_chain_theta_1 = (t8 * R::literal(0.5)).sub_product(t2,
        chain_omega_2_dot_by_chain_theta_1);
    let t10 = t5 - t7;
    let chain_omega_2_dot_by_chain_theta_2 = (t9 - t6.add_product(R::literal(9.81),
        cos_chain_theta_2)).sub_product(t2, t10) * t3;
    let chain_omega_1_dot_by_chain_theta_2 = (t10 * R::literal(0.5)).sub_product(t2,
        chain_omega_2_dot_by_chain_theta_2);
    let chain_omega_2_dot_by_chain_omega_1 = R::literal(2.0) * chain_omega_1 * t0 * t3;
    let chain_omega_1_dot_by_chain_omega_1 = -(t2 * chain_omega_2_dot_by_chain_omega_1);
    let t11 = R::literal(2.0) * chain_omega_2 * t0;
    let chain_omega_2_dot_by_chain_omega_2 = t2 * t11 * t3;
    let chain_omega_1_dot_by_chain_omega_2 = (t11 * R::literal(-0.5)).sub_product(t2,
        chain_omega_2_dot_by_chain_omega_2);
    [R::literal(1.0), R::literal(1.0), chain_omega_1_dot_by_chain_theta_1,
        chain_omega_1_dot_by_chain_theta_2, chain_omega_1_dot_by_chain_omega_1,
        chain_omega_1_dot_by_chain_omega_2, chain_omega_2_dot_by_chain_theta_1,
        chain_omega_2_dot_by_chain_theta_2, chain_omega_2_dot_by_chain_omega_1,
        chain_omega_2_dot_by_chain_omega_2]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
    }
}

/// T, V and the energy of first-order states \[J\]. 21 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    Energy {
        kinetic: R::literal(0.5) * (chain_u_1 * chain_u_1).add_product(chain_v_1, chain_v_1)
            .add_product(chain_u_2, chain_u_2).add_product(chain_v_2, chain_v_2),
        potential: R::literal(-9.81) * cos_chain_theta_2.add_product(R::literal(2.0),
            cos_chain_theta_1),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 67 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES],
        _p: &Parameters<R>) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_omega_1, chain_omega_2] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2), (t0, t1)]
        = R::sin_cos_each([chain_theta_1, chain_theta_2, chain_theta_1_minus_chain_theta_2]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let t2 = t1 * R::literal(0.5);
    let t3 = R::literal(19.62) * sin_chain_theta_1;
    let t4 = t3.add_product(chain_omega_2 * chain_omega_2, t0);
    let t5 = R::literal(9.81) * sin_chain_theta_2;
    let chain_omega_2_dot = (-t5).add_product(chain_omega_1 * chain_omega_1, t0).add_product(t2,
        t4) * (R::literal(1.0) / R::literal(1.0).sub_product(t2, t1));
    let t6 = R::literal(2.0) * chain_omega_2;
    let t7 = R::literal(2.0) * chain_v_1;
    let t8 = R::literal(2.0) * chain_u_1;
    let t9 = R::literal(2.0) * chain_u_2;
    let t10 = R::literal(2.0) * chain_v_2;
    PowerBalance {
        stored_rate: (t3.add_product(R::literal(0.5), (t8 * chain_v_2).sub_product(t7, chain_u_2))
            * chain_omega_1).add_product(t5.add_product(R::literal(0.5), (t6 * chain_v_2
            * cos_chain_theta_2).sub_product(t6 * chain_u_2, sin_chain_theta_2)), chain_omega_2)
            .sub_product(R::literal(0.5) * (t8 * cos_chain_theta_1).add_product(t7,
            sin_chain_theta_1).add_product(t9, cos_chain_theta_1).add_product(t10,
            sin_chain_theta_1), (t4 * R::literal(0.5)).add_product(t2, chain_omega_2_dot))
            .add_product(R::literal(0.5) * (t9 * cos_chain_theta_2).add_product(t10,
            sin_chain_theta_2), chain_omega_2_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 29 recurrences. 12 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
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
    let t3 = chain_omega_2 * chain_omega_2;
    let t4 = t3 * t1;
    let t5 = sin_chain_theta_1 * R::literal(-19.62);
    let t6 = t5 - t4;
    let t7 = sin_chain_theta_2 * R::literal(9.81);
    let t8 = chain_omega_1 * chain_omega_1;
    let t9 = t8 * t1;
    let t10 = t9 - t7;
    let factored = Factored::new([[R::literal(2.0), R::literal(0.0)], [t2, R::literal(1.0)]]);
    let [chain_omega_1_dot, chain_omega_2_dot] = factored.solve([t6, t10]);
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
        let sin_chain_theta_1_k = chain_theta_1_k.mul_add(cos_chain_theta_1, inverse * sums[2]);
        let cos_chain_theta_1_k = -chain_theta_1_k.mul_add(sin_chain_theta_1, inverse * sums[3]);
        let sin_chain_theta_2_k = chain_theta_2_k.mul_add(cos_chain_theta_2, inverse * sums_1[0]);
        let cos_chain_theta_2_k = -chain_theta_2_k.mul_add(sin_chain_theta_2, inverse * sums_1[1]);
        let t3_k = (chain_omega_2 + chain_omega_2).mul_add(chain_omega_2_k, sums[0]);
        let t4_k = t3.mul_add(t1_k, t1.mul_add(t3_k, sums_2[0]));
        let t6_k = sin_chain_theta_1_k.mul_add(R::literal(-19.62), -t4_k);
        let t8_k = (chain_omega_1 + chain_omega_1).mul_add(chain_omega_1_k, sums[1]);
        let t9_k = t8.mul_add(t1_k, t1.mul_add(t8_k, sums_2[1]));
        let t10_k = (-sin_chain_theta_2_k).mul_add(R::literal(9.81), t9_k);
        let n25_k = t2_k.mul_add(chain_omega_2_dot, sums_2[2]);
        let n26_k = t2_k.mul_add(chain_omega_1_dot, sums_2[3]);
        let t6_k_2 = t6_k - n25_k;
        let t10_k_2 = t10_k - n26_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k] = factored.solve([t6_k_2, t10_k_2]);
        lanes.set(order, [chain_omega_2_k, chain_omega_1_k, k * chain_theta_1_k,
            k * chain_theta_1_k], [chain_omega_2_k, chain_omega_1_k, cos_chain_theta_1_k,
            sin_chain_theta_1_k]);
        lanes_1.set(order, [k * chain_theta_2_k, k * chain_theta_2_k, k * t0_k, k * t0_k],
            [cos_chain_theta_2_k, sin_chain_theta_2_k, t2_k, t1_k]);
        lanes_2.set(order, [t1_k, t1_k, t2_k, t2_k], [t3_k, t8_k, chain_omega_2_dot_k,
            chain_omega_1_dot_k]);
        rates = [chain_omega_1_k, chain_omega_2_k, chain_omega_1_dot_k, chain_omega_2_dot_k];
    }
}

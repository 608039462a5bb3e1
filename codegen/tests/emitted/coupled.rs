// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo build
//
// Sources, with SHA-256:
//   e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  scenes/pendulum.toml
//
// Damped pendulum
//
// A point mass on a rod.
//
// Its torque follows a table with a lag.
//
// Source:
//   Worked out on paper.
//
// All quantities are in SI units.
// Shapes: coordinates 2, states 4, parameters 6.
// Nonzeros: mass_matrix 4 of 2 by 2, rate_jacobian 0 of 4 by 4, parameter_jacobian 0 of 4 by 6.
// Operations: rate 27, mass_matrix 2, forcing 16, energy 10, power_balance 4, prepare 2,
//     prepared_rate 25.

use ::machinist_contract::{
    CubicTable, Energy, PowerBalance, Real, taylor::{Factored, Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Damped pendulum
    ///
    /// A point mass on a rod.
    ///
    /// Its torque follows a table with a lag.
    ///
    /// Source: Worked out on paper.
    Coupled: "coupled", "Damped pendulum";
    run from 0.0, until 2.0, points 1001, rtol 1e-8, method "bdf";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 12;
}

::machinist_contract::parameters! {
    arm_mass: 4.2, "kg", "arm.mass", "mass of the bob";
    arm_length: 0.75, "m", "arm.length", "length of the rod";
    arm_gravity: 9.80665, "m/s^2", "arm.gravity", "acceleration of free fall";
    arm_damping: 0.128_534_6, "N m s/rad", "arm.damping", "viscous damping of the pivot";
    drive_lag: 0.01, "s", "drive.lag", "time constant of the drive";
    start: 0.1, "s", "start", "time at which the drive starts";
}

::machinist_contract::outputs! {}

::machinist_contract::states! {
    Q_0: position, 1.0, "rad", "q_0", "";
    Q_1: position, 1.0, "rad", "q_1", "";
    Q_0_DOT: velocity, 10.0, "rad/s", "q_0_dot", "";
    Q_1_DOT: velocity, 10.0, "rad/s", "q_1_dot", "";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0 1] 1 [0 1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 4 by 4 {  }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 4 by 6 {  }
}

::machinist_contract::constants! {
    t0, t1
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 2 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.arm_gravity;
    let t1 = R::literal(1.0) * p.arm_gravity;
    Constants { t0, t1 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 25 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let q_0_minus_q_1 = q_0 - q_1;
    let [(sin_q_0_minus_q_1, cos_q_0_minus_q_1), (sin_q_1_minus_q_0, _), (sin_q_0, _),
        (sin_q_1, _)] = R::sin_cos_each([q_0_minus_q_1, q_1 - q_0, q_0, q_1]);
    let t0 = (-(c.t0 * sin_q_0)).add_product(sin_q_1_minus_q_0, q_1_dot.powi(2));
    let t1 = (-(c.t1 * sin_q_1)).add_product(sin_q_0_minus_q_1, q_0_dot.powi(2));
    let t2 = R::literal(2.0).sub_product(cos_q_0_minus_q_1, cos_q_0_minus_q_1);
    let q_0_dot_dot = (R::literal(1.0) * t0).sub_product(cos_q_0_minus_q_1, t1) / t2;
    let q_1_dot_dot = (R::literal(2.0) * t1).sub_product(cos_q_0_minus_q_1, t0) / t2;
    [q_0_dot, q_1_dot, q_0_dot_dot, q_1_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; 4] {
    let [q_0, q_1, ..] = *state;
    let cos_q_0_minus_q_1 = (q_0 - q_1).cos();
    [R::literal(2.0), cos_q_0_minus_q_1, cos_q_0_minus_q_1, R::literal(1.0)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 16 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let [(sin_q_1_minus_q_0, _), (sin_q_0, _), (sin_q_0_minus_q_1, _), (sin_q_1, _)]
        = R::sin_cos_each([q_1 - q_0, q_0, q_0 - q_1, q_1]);
    let q_0_forcing = (R::literal(-2.0) * p.arm_gravity * sin_q_0).add_product(sin_q_1_minus_q_0,
        q_1_dot.powi(2));
    let q_1_forcing = (R::literal(-1.0) * p.arm_gravity * sin_q_1).add_product(sin_q_0_minus_q_1,
        q_0_dot.powi(2));
    [q_0_forcing, q_1_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 0] {
    []
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// No operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    Outputs {
        real: core::marker::PhantomData,
    }
}

/// T, V and the energy of first-order states \[J\]. 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [q_0, q_1, ..] = *state;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    Energy {
        kinetic: inertia * q_1.powi(2) / R::literal(2.0),
        potential: p.arm_mass * p.arm_gravity * (p.arm_length * (R::literal(1.0) - q_0.cos())),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 4 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, q_1, q_0_dot, ..] = *state;
    let supplied = q_0_dot * q_1;
    let dissipated = p.arm_damping * q_1.powi(2);
    PowerBalance {
        stored_rate: supplied - dissipated,
        supplied,
        dissipated,
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 31 recurrences. 12 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [q_0, q_1, q_0_dot, q_1_dot] = *state;
    let t0 = q_0 - q_1;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = -t1;
    let t4 = q_1_dot * q_1_dot;
    let t5 = t3 * t4;
    let t6 = R::literal(2.0) * p.arm_gravity;
    let sin_q_0 = q_0.sin();
    let cos_q_0 = q_0.cos();
    let t7 = sin_q_0 * t6;
    let t8 = t5 - t7;
    let t9 = q_0_dot * q_0_dot;
    let t10 = t1 * t9;
    let t11 = R::literal(1.0) * p.arm_gravity;
    let sin_q_1 = q_1.sin();
    let cos_q_1 = q_1.cos();
    let t12 = sin_q_1 * t11;
    let t13 = t10 - t12;
    let factored = Factored::new([[R::literal(2.0), R::literal(0.0)], [t2, R::literal(1.0)]]);
    let [q_0_dot_dot, q_1_dot_dot] = factored.solve([t8, t13]);
    let mut rates = [q_0_dot, q_1_dot, q_0_dot_dot, q_1_dot_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [q_0_k, q_1_k, q_0_dot_k, q_1_dot_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let t0_k = q_0_k - q_1_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_1[2]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_1[3]);
        let t3_k = -t1_k;
        let t4_k = (q_1_dot + q_1_dot).mul_add(q_1_dot_k, sums[0]);
        let t5_k = t4.mul_add(t3_k, t3.mul_add(t4_k, sums_2[1]));
        let sin_q_0_k = q_0_k.mul_add(cos_q_0, inverse * sums[2]);
        let cos_q_0_k = -q_0_k.mul_add(sin_q_0, inverse * sums[3]);
        let t8_k = (-sin_q_0_k).mul_add(t6, t5_k);
        let t9_k = (q_0_dot + q_0_dot).mul_add(q_0_dot_k, sums[1]);
        let t10_k = t9.mul_add(t1_k, t1.mul_add(t9_k, sums_2[0]));
        let sin_q_1_k = q_1_k.mul_add(cos_q_1, inverse * sums_1[0]);
        let cos_q_1_k = -q_1_k.mul_add(sin_q_1, inverse * sums_1[1]);
        let t13_k = (-sin_q_1_k).mul_add(t11, t10_k);
        let n27_k = t2_k.mul_add(q_1_dot_dot, sums_2[2]);
        let n28_k = t2_k.mul_add(q_0_dot_dot, sums_2[3]);
        let t8_k_2 = t8_k - n27_k;
        let t13_k_2 = t13_k - n28_k;
        let [q_0_dot_dot_k, q_1_dot_dot_k] = factored.solve([t8_k_2, t13_k_2]);
        lanes.set(order, [q_1_dot_k, q_0_dot_k, k * q_0_k, k * q_0_k], [q_1_dot_k, q_0_dot_k,
            cos_q_0_k, sin_q_0_k]);
        lanes_1.set(order, [k * q_1_k, k * q_1_k, k * t0_k, k * t0_k], [cos_q_1_k, sin_q_1_k, t2_k,
            t1_k]);
        lanes_2.set(order, [t1_k, t3_k, t2_k, t2_k], [t9_k, t4_k, q_1_dot_dot_k, q_0_dot_dot_k]);
        rates = [q_0_dot_k, q_1_dot_k, q_0_dot_dot_k, q_1_dot_dot_k];
    }
}

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

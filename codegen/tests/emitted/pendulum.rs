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
// Shapes: coordinates 1, first-order states 1, states 3, parameters 6, outputs 2, discontinuities 1.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 5 of 3 by 3, parameter_jacobian 2 of 3 by 6.
// Operations: rate 14, mass_matrix 2, forcing 7, rate_jacobian 13, parameter_jacobian 7,
//     time_derivative 3, outputs 3, energy 10, power_balance 4, prepare 9, prepared_rate 10,
//     prepared_rate_jacobian 4, prepared_jacobians 9.

use ::machinist_contract::{
    CubicTable, Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Damped pendulum
    ///
    /// A point mass on a rod.
    ///
    /// Its torque follows a table with a lag.
    ///
    /// Source: Worked out on paper.
    Pendulum: "pendulum", "Damped pendulum";
    run from 0.0, until 2.0, points 1001, rtol 1e-8, method "bdf";
    quadratures 0, discontinuities 1;
    prepared; jacobians_at_once; series 4 has_corners;
}

::machinist_contract::parameters! {
    arm_mass: 4.2, "kg", "arm.mass", "mass of the bob";
    arm_length: 0.75, "m", "arm.length", "length of the rod";
    arm_gravity: 9.80665, "m/s^2", "arm.gravity", "acceleration of free fall";
    arm_damping: 0.128_534_6, "N m s/rad", "arm.damping", "viscous damping of the pivot";
    drive_lag: 0.01, "s", "drive.lag", "time constant of the drive";
    start: 0.1, "s", "start", "time at which the drive starts";
}

::machinist_contract::outputs! {
    height: "m", "height", "height of the bob";
    deflection: "rad", "deflection", "";
}

::machinist_contract::states! {
    ARM_PHI: position, 1.0, "rad", "arm.phi", "angle from the vertical";
    ARM_PHI_DOT: velocity, 10.0, "rad/s", "arm.phi_dot", "speed of arm.phi";
    DRIVE_TORQUE: first_order, 100.0, "N m", "drive.torque", "torque on the arm";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1] 1 [0 1 2] 2 [2] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 6 { 1 [2 3] }
}

::machinist_contract::constants! {
    t0, inertia, arm_phi_dot_dot_by_arm_phi_dot, arm_phi_dot_dot_by_drive_torque,
    drive_torque_dot_by_drive_torque
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = p.arm_mass * p.arm_gravity * p.arm_length;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    let arm_phi_dot_dot_by_arm_phi_dot = -(p.arm_damping / inertia);
    let arm_phi_dot_dot_by_drive_torque = R::literal(1.0) / inertia;
    let drive_torque_dot_by_drive_torque = -(R::literal(1.0) / p.drive_lag);
    Constants { t0, inertia, arm_phi_dot_dot_by_arm_phi_dot, arm_phi_dot_dot_by_drive_torque,
        drive_torque_dot_by_drive_torque }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.5), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    [p.start]
}

/// As `rate`, with the constants of the parameters from `prepare`. 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let arm_phi_dot_dot = drive_torque.sub_product(p.arm_damping, arm_phi_dot).sub_product(c.t0,
        arm_phi.sin()) / c.inertia;
    let load = R::select_less(time, p.start, R::literal(0.0), R::interpolate(&DRIVE_LOAD_TABLE, 0,
        time));
    let drive_torque_dot = (load - drive_torque) / p.drive_lag;
    [arm_phi_dot, arm_phi_dot_dot, drive_torque_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    let inertia = p.arm_mass * p.arm_length.powi(2);
    [inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 7 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let arm_phi_forcing = drive_torque.sub_product(p.arm_damping, arm_phi_dot)
        .sub_product(p.arm_mass * p.arm_gravity * p.arm_length, arm_phi.sin());
    [arm_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 5] {
    let [arm_phi, ..] = *state;
    let arm_phi_dot_dot_by_arm_phi = -(c.t0 * arm_phi.cos() / c.inertia);
    [R::literal(1.0), arm_phi_dot_dot_by_arm_phi, c.arm_phi_dot_dot_by_arm_phi_dot,
        c.arm_phi_dot_dot_by_drive_torque, c.drive_torque_dot_by_drive_torque]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 9 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 7] {
    let [arm_phi, arm_phi_dot, ..] = *state;
    let (sin_arm_phi, cos_arm_phi) = arm_phi.sin_cos();
    let arm_phi_dot_dot_by_arm_phi = -(c.t0 * cos_arm_phi / c.inertia);
    let arm_phi_dot_dot_by_arm_gravity = -(sin_arm_phi / p.arm_length);
    let arm_phi_dot_dot_by_arm_damping = -(arm_phi_dot / c.inertia);
    [R::literal(1.0), arm_phi_dot_dot_by_arm_phi, c.arm_phi_dot_dot_by_arm_phi_dot,
        c.arm_phi_dot_dot_by_drive_torque, c.drive_torque_dot_by_drive_torque,
        arm_phi_dot_dot_by_arm_gravity, arm_phi_dot_dot_by_arm_damping]
}

/// Partial derivative of `y'` with respect to time. 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let drive_torque_dot_by_time = R::select_less(time, p.start, R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 1, time)) / p.drive_lag;
    [R::literal(0.0), R::literal(0.0), drive_torque_dot_by_time]
}

/// Wanted outputs. 3 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [arm_phi, ..] = *state;
    Outputs {
        height: p.arm_length * (R::literal(1.0) - arm_phi.cos()),
        deflection: arm_phi,
    }
}

/// T, V and the energy of first-order states \[J\]. 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [arm_phi, arm_phi_dot, ..] = *state;
    let inertia = p.arm_mass * p.arm_length.powi(2);
    Energy {
        kinetic: inertia * arm_phi_dot.powi(2) / R::literal(2.0),
        potential: p.arm_mass * p.arm_gravity * (p.arm_length * (R::literal(1.0) - arm_phi.cos())),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 4 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, arm_phi_dot, drive_torque] = *state;
    let supplied = drive_torque * arm_phi_dot;
    let dissipated = p.arm_damping * arm_phi_dot.powi(2);
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
/// 31 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [arm_phi, arm_phi_dot, drive_torque] = *state;
    let t0 = arm_phi_dot * p.arm_damping;
    let t1 = drive_torque - t0;
    let sin_arm_phi = arm_phi.sin();
    let cos_arm_phi = arm_phi.cos();
    let t2 = p.arm_mass * p.arm_gravity;
    let t3 = t2 * p.arm_length;
    let t4 = sin_arm_phi * t3;
    let t5 = t1 - t4;
    let t6 = p.arm_length.powi(2);
    let inertia = p.arm_mass * t6;
    let t7 = R::literal(1.0) / inertia;
    let t8 = t5 * t7;
    let t9 = R::interpolate(&DRIVE_LOAD_TABLE, 0, time);
    let load = R::select_less(time, p.start, R::literal(0.0), t9);
    let t10 = load - drive_torque;
    let t11 = R::literal(1.0) / p.drive_lag;
    let t12 = t10 * t11;
    let t9_first = R::interpolate(&DRIVE_LOAD_TABLE, 1, time);
    let t9_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 2, time);
    let t9_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 3, time);
    let mut rates = [arm_phi_dot, t8, t12];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [arm_phi_k, arm_phi_dot_k, drive_torque_k] = *state_k;
        let sums = lanes.sums(order);
        let t1_k = (-arm_phi_dot_k).mul_add(p.arm_damping, drive_torque_k);
        let sin_arm_phi_k = arm_phi_k.mul_add(cos_arm_phi, inverse * sums[1]);
        let cos_arm_phi_k = -arm_phi_k.mul_add(sin_arm_phi, inverse * sums[2]);
        let t5_k = (-sin_arm_phi_k).mul_add(t3, t1_k);
        let t8_k = t5_k * t7;
        let time_k = R::literal(if order == 1 { 1.0 } else { 0.0 });
        let t9_k = t9_first * time_k + t9_second * sums[0] + t9_third * sums[3];
        let load_k = R::select_less(time, p.start, R::literal(0.0), t9_k);
        let t10_k = load_k - drive_torque_k;
        let t12_k = t10_k * t11;
        lanes.set(order, [time_k, k * arm_phi_k, k * arm_phi_k, time_k], [time_k, cos_arm_phi_k,
            sin_arm_phi_k, sums[0]]);
        rates = [arm_phi_dot_k, t8_k, t12_k];
    }
}

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

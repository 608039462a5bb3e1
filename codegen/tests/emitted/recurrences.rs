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
// Shapes: coordinates 1, first-order states 63, states 65, parameters 6.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 0 of 65 by 65, parameter_jacobian 0 of 65 by 6.
// Operations: rate 70, forcing 1, energy 10, power_balance 4, prepare 1, prepared_rate 69.

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
    Recurrences: "recurrences", "Damped pendulum";
    run from 0.0, until 2.0, points 1001, rtol 1e-8, method "bdf";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 41 has_corners;
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
    ARM_PHI: position, 1.0, "rad", "arm.phi", "angle from the vertical";
    ARM_PHI_DOT: velocity, 10.0, "rad/s", "arm.phi_dot", "speed of arm.phi";
    Z_2: first_order, 1.0, "1", "z_2", "";
    Z_3: first_order, 1.0, "1", "z_3", "";
    Z_4: first_order, 1.0, "1", "z_4", "";
    Z_5: first_order, 1.0, "1", "z_5", "";
    Z_6: first_order, 1.0, "1", "z_6", "";
    Z_7: first_order, 1.0, "1", "z_7", "";
    Z_8: first_order, 1.0, "1", "z_8", "";
    Z_9: first_order, 1.0, "1", "z_9", "";
    Z_10: first_order, 1.0, "1", "z_10", "";
    Z_11: first_order, 1.0, "1", "z_11", "";
    Z_12: first_order, 1.0, "1", "z_12", "";
    Z_13: first_order, 1.0, "1", "z_13", "";
    Z_14: first_order, 1.0, "1", "z_14", "";
    Z_15: first_order, 1.0, "1", "z_15", "";
    Z_16: first_order, 1.0, "1", "z_16", "";
    Z_17: first_order, 1.0, "1", "z_17", "";
    Z_18: first_order, 1.0, "1", "z_18", "";
    Z_19: first_order, 1.0, "1", "z_19", "";
    Z_20: first_order, 1.0, "1", "z_20", "";
    Z_21: first_order, 1.0, "1", "z_21", "";
    Z_22: first_order, 1.0, "1", "z_22", "";
    Z_23: first_order, 1.0, "1", "z_23", "";
    Z_24: first_order, 1.0, "1", "z_24", "";
    Z_25: first_order, 1.0, "1", "z_25", "";
    Z_26: first_order, 1.0, "1", "z_26", "";
    Z_27: first_order, 1.0, "1", "z_27", "";
    Z_28: first_order, 1.0, "1", "z_28", "";
    Z_29: first_order, 1.0, "1", "z_29", "";
    Z_30: first_order, 1.0, "1", "z_30", "";
    Z_31: first_order, 1.0, "1", "z_31", "";
    Z_32: first_order, 1.0, "1", "z_32", "";
    Z_33: first_order, 1.0, "1", "z_33", "";
    Z_34: first_order, 1.0, "1", "z_34", "";
    Z_35: first_order, 1.0, "1", "z_35", "";
    Z_36: first_order, 1.0, "1", "z_36", "";
    Z_37: first_order, 1.0, "1", "z_37", "";
    Z_38: first_order, 1.0, "1", "z_38", "";
    Z_39: first_order, 1.0, "1", "z_39", "";
    Z_40: first_order, 1.0, "1", "z_40", "";
    Z_41: first_order, 1.0, "1", "z_41", "";
    Z_42: first_order, 1.0, "1", "z_42", "";
    Z_43: first_order, 1.0, "1", "z_43", "";
    Z_44: first_order, 1.0, "1", "z_44", "";
    Z_45: first_order, 1.0, "1", "z_45", "";
    Z_46: first_order, 1.0, "1", "z_46", "";
    Z_47: first_order, 1.0, "1", "z_47", "";
    Z_48: first_order, 1.0, "1", "z_48", "";
    Z_49: first_order, 1.0, "1", "z_49", "";
    Z_50: first_order, 1.0, "1", "z_50", "";
    Z_51: first_order, 1.0, "1", "z_51", "";
    Z_52: first_order, 1.0, "1", "z_52", "";
    Z_53: first_order, 1.0, "1", "z_53", "";
    Z_54: first_order, 1.0, "1", "z_54", "";
    Z_55: first_order, 1.0, "1", "z_55", "";
    Z_56: first_order, 1.0, "1", "z_56", "";
    Z_57: first_order, 1.0, "1", "z_57", "";
    Z_58: first_order, 1.0, "1", "z_58", "";
    Z_59: first_order, 1.0, "1", "z_59", "";
    Z_60: first_order, 1.0, "1", "z_60", "";
    Z_61: first_order, 1.0, "1", "z_61", "";
    Z_62: first_order, 1.0, "1", "z_62", "";
    Z_63: first_order, 1.0, "1", "z_63", "";
    Z_64: first_order, 1.0, "1", "z_64", "";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 65 by 65 {  }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 65 by 6 {  }
}

::machinist_contract::constants! {
    t0
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = p.arm_length * R::literal(2.0);
    Constants { t0 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 69 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [arm_phi, arm_phi_dot, ..] = *state;
    let arm_phi_minus_arm_phi_dot = arm_phi - arm_phi_dot;
    let arm_phi_dot_minus_arm_phi = arm_phi_dot - arm_phi;
    let z_50_dot = (-p.drive_lag).add_product(p.arm_length, time);
    let minus_z_50_dot = -z_50_dot;
    let [(z_8_dot, z_10_dot), (z_9_dot, z_11_dot), (z_55_dot, z_57_dot), (z_56_dot, z_58_dot)]
        = R::sin_cos_each([arm_phi_minus_arm_phi_dot, arm_phi_dot_minus_arm_phi, z_50_dot,
        minus_z_50_dot]);
    let [z_24_dot, z_25_dot, z_63_dot, z_64_dot] = R::tanh_each([arm_phi_minus_arm_phi_dot,
        arm_phi_dot_minus_arm_phi, z_50_dot, minus_z_50_dot]);
    let arm_phi_dot_dot = -arm_phi;
    let t0 = R::literal(2.0) + arm_phi;
    let z_2_dot = t0.sqrt();
    let z_3_dot = t0.ln();
    let z_4_dot = arm_phi_minus_arm_phi_dot.abs();
    let z_5_dot = arm_phi_dot_minus_arm_phi.abs();
    let z_6_dot = arm_phi_minus_arm_phi_dot.exp();
    let z_7_dot = arm_phi_dot_minus_arm_phi.exp();
    let z_12_dot = arm_phi_minus_arm_phi_dot.tan();
    let z_13_dot = arm_phi_dot_minus_arm_phi.tan();
    let z_14_dot = arm_phi_minus_arm_phi_dot.asin();
    let z_15_dot = arm_phi_dot_minus_arm_phi.asin();
    let z_16_dot = arm_phi_minus_arm_phi_dot.acos();
    let z_17_dot = arm_phi_dot_minus_arm_phi.acos();
    let z_18_dot = arm_phi_minus_arm_phi_dot.atan();
    let z_19_dot = arm_phi_dot_minus_arm_phi.atan();
    let z_20_dot = arm_phi_minus_arm_phi_dot.sinh();
    let z_21_dot = arm_phi_dot_minus_arm_phi.sinh();
    let z_22_dot = arm_phi_minus_arm_phi_dot.cosh();
    let z_23_dot = arm_phi_dot_minus_arm_phi.cosh();
    let z_26_dot = R::interpolate(&DRIVE_LOAD_TABLE, 0, t0);
    let z_27_dot = R::interpolate(&DRIVE_LOAD_TABLE, 1, t0);
    let z_28_dot = R::interpolate(&DRIVE_LOAD_TABLE, 2, t0);
    let z_29_dot = R::interpolate(&DRIVE_LOAD_TABLE, 3, t0);
    let t1 = arm_phi + R::literal(2.0);
    let z_30_dot = arm_phi * arm_phi_dot;
    let z_31_dot = p.arm_length * arm_phi_dot;
    let z_32_dot = arm_phi / p.arm_length;
    let z_33_dot = arm_phi / R::literal(2.0);
    let z_34_dot = arm_phi_dot / t1;
    let z_35_dot = p.arm_length / t1;
    let z_36_dot = p.arm_length - arm_phi;
    let z_38_dot = t1.powi(-3);
    let z_39_dot = t1.powi(-1);
    let z_40_dot = t1.powi(0);
    let z_41_dot = t1.powi(1);
    let z_42_dot = t1.powi(2);
    let z_43_dot = t1.powi(3);
    let z_44_dot = t1.powi(7);
    let z_45_dot = t1.powf(p.arm_length);
    let z_46_dot = t1.powf(R::literal(-2.5));
    let z_47_dot = t1.powf(arm_phi_dot);
    let z_48_dot = R::select_less(arm_phi, arm_phi_dot, arm_phi, t1);
    let z_49_dot = R::select_less(arm_phi_dot, arm_phi, p.arm_length, t1);
    let z_51_dot = time * arm_phi;
    let z_52_dot = z_50_dot * minus_z_50_dot;
    let z_53_dot = z_50_dot + arm_phi;
    let z_54_dot = R::interpolate(&DRIVE_LOAD_TABLE, 0, z_50_dot);
    let z_59_dot = z_50_dot.exp();
    let z_60_dot = minus_z_50_dot.exp();
    let z_61_dot = z_50_dot.sinh();
    let z_62_dot = minus_z_50_dot.sinh();
    [arm_phi_dot, arm_phi_dot_dot, z_2_dot, z_3_dot, z_4_dot, z_5_dot, z_6_dot, z_7_dot, z_8_dot,
        z_9_dot, z_10_dot, z_11_dot, z_12_dot, z_13_dot, z_14_dot, z_15_dot, z_16_dot, z_17_dot,
        z_18_dot, z_19_dot, z_20_dot, z_21_dot, z_22_dot, z_23_dot, z_24_dot, z_25_dot, z_26_dot,
        z_27_dot, z_28_dot, z_29_dot, z_30_dot, z_31_dot, z_32_dot, z_33_dot, z_34_dot, z_35_dot,
        z_36_dot, c.t0, z_38_dot, z_39_dot, z_40_dot, z_41_dot, z_42_dot, z_43_dot, z_44_dot,
        z_45_dot, z_46_dot, z_47_dot, z_48_dot, z_49_dot, z_50_dot, z_51_dot, z_52_dot, z_53_dot,
        z_54_dot, z_55_dot, z_56_dot, z_57_dot, z_58_dot, z_59_dot, z_60_dot, z_61_dot, z_62_dot,
        z_63_dot, z_64_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 1] {
    [R::literal(1.0)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 1 operation.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [arm_phi, ..] = *state;
    let arm_phi_forcing = -arm_phi;
    [arm_phi_forcing]
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
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
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
    let [_, arm_phi_dot, z_2, ..] = *state;
    let supplied = z_2 * arm_phi_dot;
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
/// 96 recurrences. 41 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_7, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_8, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_9, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_10, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [arm_phi, arm_phi_dot, ..] = *state;
    let t0 = -arm_phi;
    let t1 = R::literal(2.0) + arm_phi;
    let t2 = t1.sqrt();
    let t3 = t1.ln();
    let t4 = arm_phi - arm_phi_dot;
    let t5 = -t4;
    let t6 = R::select_less(t4, R::literal(0.0), t5, t4);
    let t7 = t4.exp();
    let t8 = t5.exp();
    let t9 = t4.sin();
    let t10 = t4.cos();
    let t11 = -t9;
    let t12 = t4.tan();
    let t13 = t12 * t12;
    let t14 = R::literal(1.0) + t13;
    let t15 = -t12;
    let t16 = t4 * t4;
    let t17 = R::literal(1.0) - t16;
    let t18 = t17.sqrt();
    let t19 = t4.asin();
    let t20 = -t19;
    let t21 = t4.acos();
    let t22 = t5 * t5;
    let t23 = R::literal(1.0) - t22;
    let t24 = t23.sqrt();
    let t25 = t5.acos();
    let t26 = R::literal(1.0) + t16;
    let t27 = t4.atan();
    let t28 = -t27;
    let t29 = t4.sinh();
    let t30 = t4.cosh();
    let t31 = -t29;
    let t32 = t4.tanh();
    let t33 = t32 * t32;
    let t34 = R::literal(1.0) - t33;
    let t35 = -t32;
    let t36 = R::interpolate(&DRIVE_LOAD_TABLE, 0, t1);
    let t37 = R::interpolate(&DRIVE_LOAD_TABLE, 1, t1);
    let t38 = R::interpolate(&DRIVE_LOAD_TABLE, 2, t1);
    let t39 = R::interpolate(&DRIVE_LOAD_TABLE, 3, t1);
    let t40 = arm_phi + R::literal(2.0);
    let t41 = arm_phi * arm_phi_dot;
    let t42 = arm_phi_dot * p.arm_length;
    let t43 = R::literal(1.0) / p.arm_length;
    let t44 = arm_phi * t43;
    let t45 = arm_phi * R::literal(0.5);
    let t46 = arm_phi_dot / t40;
    let t47 = p.arm_length / t40;
    let t48 = p.arm_length - arm_phi;
    let t49 = p.arm_length * R::literal(2.0);
    let t50 = t40 * t40;
    let t51 = t40 * t50;
    let t52 = R::literal(1.0) / t51;
    let t53 = R::literal(1.0) / t40;
    let t54 = t50 * t50;
    let t55 = t51 * t54;
    let t56 = t40.powf(p.arm_length);
    let t57 = t40.powf(R::literal(-2.5));
    let t58 = t40.ln();
    let t59 = arm_phi_dot * t58;
    let t60 = t59.exp();
    let t61 = R::select_less(arm_phi, arm_phi_dot, arm_phi, t40);
    let t62 = R::select_less(arm_phi_dot, arm_phi, p.arm_length, t40);
    let t63 = time * p.arm_length;
    let t64 = t63 - p.drive_lag;
    let t65 = -t64;
    let t66 = time * arm_phi;
    let t67 = t64 * t65;
    let t68 = t64 + arm_phi;
    let t69 = R::interpolate(&DRIVE_LOAD_TABLE, 0, t64);
    let t70 = t64.sin();
    let t71 = t64.cos();
    let t72 = -t70;
    let t73 = t64.exp();
    let t74 = t65.exp();
    let t75 = t64.sinh();
    let t76 = t64.cosh();
    let t77 = -t75;
    let t78 = t64.tanh();
    let t79 = t78 * t78;
    let t80 = R::literal(1.0) - t79;
    let t81 = -t78;
    let inverse_t2 = R::literal(1.0) / (t2 + t2);
    let inverse_t1 = R::literal(1.0) / t1;
    let inverse_t18 = R::literal(1.0) / (t18 + t18);
    let inverse_t18_2 = R::literal(1.0) / t18;
    let inverse_t18_3 = R::literal(1.0) / t18;
    let inverse_t24 = R::literal(1.0) / (t24 + t24);
    let inverse_t24_2 = R::literal(1.0) / t24;
    let inverse_t26 = R::literal(1.0) / t26;
    let t36_first = R::interpolate(&DRIVE_LOAD_TABLE, 1, t1);
    let t36_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 2, t1);
    let t36_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 3, t1);
    let t37_first = R::interpolate(&DRIVE_LOAD_TABLE, 2, t1);
    let t37_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 3, t1);
    let t37_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 4, t1);
    let t38_first = R::interpolate(&DRIVE_LOAD_TABLE, 3, t1);
    let t38_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 4, t1);
    let t38_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 5, t1);
    let t39_first = R::interpolate(&DRIVE_LOAD_TABLE, 4, t1);
    let t39_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 5, t1);
    let t39_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 6, t1);
    let inverse_t40 = R::literal(1.0) / t40;
    let inverse_t40_2 = R::literal(1.0) / t40;
    let inverse_t51 = R::literal(1.0) / t51;
    let inverse_t40_3 = R::literal(1.0) / t40;
    let inverse_t40_4 = R::literal(1.0) / t40;
    let inverse_t40_5 = R::literal(1.0) / t40;
    let inverse_t40_6 = R::literal(1.0) / t40;
    let t69_first = R::interpolate(&DRIVE_LOAD_TABLE, 1, t64);
    let t69_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 2, t64);
    let t69_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 3, t64);
    let t65_slope = -p.arm_length;
    let mut arm_phi_before = arm_phi;
    let mut t65_before = t65;
    let mut t70_before = t70;
    let mut t71_before = t71;
    let mut t73_before = t73;
    let mut t74_before = t74;
    let mut t75_before = t75;
    let mut t76_before = t76;
    let mut t80_before = t80;
    let mut rates = [arm_phi_dot, t0, t2, t3, t6, t6, t7, t8, t9, t11, t10, t10, t12, t15, t19,
        t20, t21, t25, t27, t28, t29, t31, t30, t30, t32, t35, t36, t37, t38, t39, t41, t42, t44,
        t45, t46, t47, t48, t49, t52, t53, R::literal(1.0), t40, t50, t51, t55, t56, t57, t60, t61,
        t62, t64, t66, t67, t68, t69, t70, t72, t71, t71, t73, t74, t75, t77, t78, t81];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [arm_phi_k, arm_phi_dot_k, ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let sums_7 = lanes_7.sums(order);
        let sums_8 = lanes_8.sums(order);
        let sums_9 = lanes_9.sums(order);
        let sums_10 = lanes_10.sums(order);
        let t0_k = -arm_phi_k;
        let t2_k = (arm_phi_k - sums_1[2]) * inverse_t2;
        let t3_k = (arm_phi_k - inverse * sums_6[1]) * inverse_t1;
        let t4_k = arm_phi_k - arm_phi_dot_k;
        let t5_k = -t4_k;
        let t6_k = R::select_less(t4, R::literal(0.0), t5_k, t4_k);
        let t7_k = t4_k.mul_add(t7, inverse * sums_1[3]);
        let t8_k = t5_k.mul_add(t8, inverse * sums_6[2]);
        let t9_k = t4_k.mul_add(t10, inverse * sums_2[0]);
        let t10_k = -t4_k.mul_add(t9, inverse * sums_2[1]);
        let t11_k = -t9_k;
        let t12_k = t4_k.mul_add(t14, inverse * sums_8[0]);
        let t13_k = (t12 + t12).mul_add(t12_k, sums_2[2]);
        let t15_k = -t12_k;
        let t16_k = (t4 + t4).mul_add(t4_k, sums[1]);
        let t17_k = -t16_k;
        let t18_k = (t17_k - sums_8[1]) * inverse_t18;
        let t19_k = (t4_k - inverse * sums_8[2]) * inverse_t18_2;
        let t20_k = -t19_k;
        let t21_k = (-t4_k - inverse * sums_8[3]) * inverse_t18_3;
        let t22_k = (t5 + t5).mul_add(t5_k, sums_2[3]);
        let t23_k = -t22_k;
        let t24_k = (t23_k - sums_9[3]) * inverse_t24;
        let t25_k = (-t5_k - inverse * sums_10[0]) * inverse_t24_2;
        let t27_k = (t4_k - inverse * sums_6[3]) * inverse_t26;
        let t28_k = -t27_k;
        let t29_k = t4_k.mul_add(t30, inverse * sums_3[0]);
        let t30_k = t4_k.mul_add(t29, inverse * sums_3[1]);
        let t31_k = -t29_k;
        let t32_k = t4_k.mul_add(t34, inverse * sums_9[0]);
        let t33_k = (t32 + t32).mul_add(t32_k, sums_3[2]);
        let t34_k = -t33_k;
        let t35_k = -t32_k;
        let t36_k = t36_first * arm_phi_k + t36_second * sums[2] + t36_third * sums[3];
        let t37_k = t37_first * arm_phi_k + t37_second * sums[2] + t37_third * sums[3];
        let t38_k = t38_first * arm_phi_k + t38_second * sums[2] + t38_third * sums[3];
        let t39_k = t39_first * arm_phi_k + t39_second * sums[2] + t39_third * sums[3];
        let t41_k = arm_phi.mul_add(arm_phi_dot_k, arm_phi_dot.mul_add(arm_phi_k, sums[0]));
        let t42_k = arm_phi_dot_k * p.arm_length;
        let t44_k = arm_phi_k * t43;
        let t45_k = arm_phi_k * R::literal(0.5);
        let t46_k = (-arm_phi_k).mul_add(t46, arm_phi_dot_k - sums_3[3]) * inverse_t40;
        let t47_k = -arm_phi_k.mul_add(t47, sums_4[0]) * inverse_t40_2;
        let t48_k = -arm_phi_k;
        let t50_k = (t40 + t40).mul_add(arm_phi_k, sums_1[0]);
        let t51_k = t40.mul_add(t50_k, t50.mul_add(arm_phi_k, sums_4[1]));
        let t52_k = -t51_k.mul_add(t52, sums_9[1]) * inverse_t51;
        let t53_k = -arm_phi_k.mul_add(t53, sums_4[2]) * inverse_t40_3;
        let t54_k = (t50 + t50).mul_add(t50_k, sums_4[3]);
        let t55_k = t51.mul_add(t54_k, t54.mul_add(t51_k, sums_7[0]));
        let t56_k = (p.arm_length * arm_phi_k.mul_add(t56, inverse * sums_5[0]) - inverse
            * sums_7[1]) * inverse_t40_4;
        let t57_k = (R::literal(-2.5) * arm_phi_k.mul_add(t57, inverse * sums_5[1]) - inverse
            * sums_7[2]) * inverse_t40_5;
        let t58_k = (arm_phi_k - inverse * sums_7[3]) * inverse_t40_6;
        let t59_k = arm_phi_dot.mul_add(t58_k, t58.mul_add(arm_phi_dot_k, sums_5[2]));
        let t60_k = t59_k.mul_add(t60, inverse * sums_9[2]);
        let t61_k = R::select_less(arm_phi, arm_phi_dot, arm_phi_k, arm_phi_k);
        let t62_k = R::select_less(arm_phi_dot, arm_phi, R::literal(0.0), arm_phi_k);
        let time_k = R::literal(if order == 1 { 1.0 } else { 0.0 });
        let t65_k = -time_k * p.arm_length;
        let t66_k = time.mul_add(arm_phi_k, R::literal(1.0) * arm_phi_before);
        let t67_k = t64.mul_add(t65_k, p.arm_length * t65_before);
        let t68_k = time_k * p.arm_length + arm_phi_k;
        let t69_k = t69_first * time_k * p.arm_length + t69_second * sums_5[3] + t69_third
            * sums_6[0];
        let t70_k = inverse * p.arm_length * t71_before;
        let t71_k = -inverse * p.arm_length * t70_before;
        let t72_k = -t70_k;
        let t73_k = inverse * p.arm_length * t73_before;
        let t74_k = inverse * t65_slope * t74_before;
        let t75_k = inverse * p.arm_length * t76_before;
        let t76_k = inverse * p.arm_length * t75_before;
        let t77_k = -t75_k;
        let t78_k = inverse * p.arm_length * t80_before;
        let t79_k = (t78 + t78).mul_add(t78_k, sums_1[1]);
        let t80_k = -t79_k;
        let t81_k = -t78_k;
        lanes.set(order, [arm_phi_k, t4_k, arm_phi_k, arm_phi_k], [arm_phi_dot_k, t4_k, arm_phi_k,
            sums[2]]);
        lanes_1.set(order, [arm_phi_k, t78_k, t2_k, k * t4_k], [arm_phi_k, t78_k, t2_k, t7_k]);
        lanes_2.set(order, [k * t4_k, k * t4_k, t12_k, t5_k], [t10_k, t9_k, t12_k, t5_k]);
        lanes_3.set(order, [k * t4_k, k * t4_k, t32_k, arm_phi_k], [t30_k, t29_k, t32_k, t46_k]);
        lanes_4.set(order, [arm_phi_k, arm_phi_k, arm_phi_k, t50_k], [t47_k, t50_k, t53_k, t50_k]);
        lanes_5.set(order, [k * arm_phi_k, k * arm_phi_k, arm_phi_dot_k, time_k * p.arm_length],
            [t56_k, t57_k, t58_k, time_k * p.arm_length]);
        lanes_6.set(order, [time_k * p.arm_length, k * t3_k, k * t5_k, k * t27_k],
            [sums_5[3], arm_phi_k, t8_k, t16_k]);
        lanes_7.set(order, [t51_k, k * t56_k, k * t57_k, k * t58_k], [t54_k, arm_phi_k, arm_phi_k,
            arm_phi_k]);
        lanes_8.set(order, [k * t4_k, t18_k, k * t19_k, k * t21_k], [t13_k, t18_k, t18_k, t18_k]);
        lanes_9.set(order, [k * t4_k, t51_k, k * t59_k, t24_k], [t34_k, t52_k, t60_k, t24_k]);
        lanes_10.set(order, [k * t25_k], [t24_k]);
        arm_phi_before = arm_phi_k;
        t65_before = t65_k;
        t70_before = t70_k;
        t71_before = t71_k;
        t73_before = t73_k;
        t74_before = t74_k;
        t75_before = t75_k;
        t76_before = t76_k;
        t80_before = t80_k;
        rates = [arm_phi_dot_k, t0_k, t2_k, t3_k, t6_k, t6_k, t7_k, t8_k, t9_k, t11_k, t10_k,
            t10_k, t12_k, t15_k, t19_k, t20_k, t21_k, t25_k, t27_k, t28_k, t29_k, t31_k, t30_k,
            t30_k, t32_k, t35_k, t36_k, t37_k, t38_k, t39_k, t41_k, t42_k, t44_k, t45_k, t46_k,
            t47_k, t48_k, R::literal(0.0), t52_k, t53_k, R::literal(0.0), arm_phi_k, t50_k, t51_k,
            t55_k, t56_k, t57_k, t60_k, t61_k, t62_k, time_k * p.arm_length, t66_k, t67_k, t68_k,
            t69_k, t70_k, t72_k, t71_k, t71_k, t73_k, t74_k, t75_k, t77_k, t78_k, t81_k];
    }
}

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

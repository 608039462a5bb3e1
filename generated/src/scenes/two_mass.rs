// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   1d197923252f4b769a62441c20a4bf06c5f8c973e644a600bf6f6b9cbb070c7a  scenes/two_mass.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//   512419e5aa73ad1710ef3556037050e97b898e87a7d5d8a4e9c4b03a7a8b0141  units/coupling.toml
//
// Two rotors on a spring-damper coupling
//
// Motor rotor and saw cylinder on their coupling, driven and loaded by prescribed torques.
//
// Source:
//   Saw-gin study (2020), equations (1).
//
// All quantities are in SI units.
// Shapes: coordinates 2, states 3, parameters 11, outputs 4.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 8 of 3 by 3, parameter_jacobian 13 of 3 by 11.
// Operations: rate 20, forcing 16, rate_jacobian 16, parameter_jacobian 50, time_derivative 6,
//     outputs 5, energy 10, power_balance 35, prepare 19, prepared_rate 16, prepared_jacobians 43.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Two rotors on a spring-damper coupling
    ///
    /// Motor rotor and saw cylinder on their coupling, driven and loaded by prescribed torques.
    ///
    /// Source: Saw-gin study (2020), equations (1).
    TwoMass: "two_mass", "Two rotors on a spring-damper coupling";
    run from 0.0, until 0.5, points 1001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    coordinates; prepared; jacobians_at_once; linear; series 0;
}

::machinist_contract::parameters! {
    drive_torque: 974.4, "N m", "drive_torque", "constant driving torque";
    load_torque: 843.72, "N m", "load_torque", "constant resisting torque";
    load_amplitude: 0.0, "N m", "load_amplitude", "amplitude of the harmonic resisting torque";
    load_frequency: 241.8051, "rad/s", "load_frequency", "angular frequency of the harmonic resisting torque";
    initial_twist: 0.0, "rad", "initial_twist", "initial twist";
    initial_twist_rate: 0.0, "rad/s", "initial_twist_rate", "initial rate of twist";
    driver_inertia: 4.2, "kg m^2", "driver.inertia", "moment of inertia";
    coupling_stiffness: 23065.2, "N m/rad", "coupling.stiffness", "torsional stiffness";
    coupling_damping: 128.5346, "N m s/rad", "coupling.damping", "torsional damping";
    coupling_ratio: 1.0, "1", "coupling.ratio", "turns of the driving end per turn of the driven end";
    cylinder_inertia: 1.244, "kg m^2", "cylinder.inertia", "moment of inertia";
}

::machinist_contract::outputs! {
    twist: "rad", "twist", "twist";
    coupling_torque: "N m", "coupling_torque", "torque at the driving end";
    driver_speed: "rad/s", "driver_speed", "rate of angle";
    cylinder_speed: "rad/s", "cylinder_speed", "rate of angle";
}

::machinist_contract::states! {
    COUPLING_TWIST: position, 1.0, "rad", "coupling.twist", "twist";
    DRIVER_OMEGA: velocity, 78.5, "rad/s", "driver.omega", "rate of angle";
    CYLINDER_OMEGA: velocity, 78.5, "rad/s", "cylinder.omega", "rate of angle";
}

::machinist_contract::coordinates! {
    "driver.phi", "rad", "angle";
    "cylinder.phi", "rad", "angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1 2] 1 [0 1 2] 2 [0 1 2] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 11 { 0 [9] 1 [0 6 7 8 9] 2 [1 2 3 7 8 9 10] }
}

::machinist_contract::constants! {
    inverse_driver_inertia, inverse_cylinder_inertia, t0, t1, cylinder_omega_dot_by_coupling_twist,
    driver_omega_dot_by_coupling_twist, cylinder_omega_dot_by_driver_omega,
    driver_omega_dot_by_driver_omega, cylinder_omega_dot_by_cylinder_omega,
    driver_omega_dot_by_cylinder_omega, coupling_twist_dot_by_cylinder_omega,
    minus_inverse_cylinder_inertia, t2
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 19 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_driver_inertia = R::literal(1.0) / p.driver_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t0 = p.coupling_stiffness * p.coupling_ratio;
    let t1 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot_by_coupling_twist = t0 * inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_twist = -(p.coupling_stiffness * inverse_driver_inertia);
    let cylinder_omega_dot_by_driver_omega = t1 * inverse_cylinder_inertia;
    let driver_omega_dot_by_driver_omega = -(p.coupling_damping * inverse_driver_inertia);
    let cylinder_omega_dot_by_cylinder_omega = -(p.coupling_damping * (p.coupling_ratio
        * p.coupling_ratio) * inverse_cylinder_inertia);
    let driver_omega_dot_by_cylinder_omega = t1 * inverse_driver_inertia;
    let coupling_twist_dot_by_cylinder_omega = -p.coupling_ratio;
    let minus_inverse_cylinder_inertia = -inverse_cylinder_inertia;
    let t2 = R::literal(2.0) * p.coupling_damping * p.coupling_ratio;
    Constants { inverse_driver_inertia, inverse_cylinder_inertia, t0, t1,
        cylinder_omega_dot_by_coupling_twist, driver_omega_dot_by_coupling_twist,
        cylinder_omega_dot_by_driver_omega, driver_omega_dot_by_driver_omega,
        cylinder_omega_dot_by_cylinder_omega, driver_omega_dot_by_cylinder_omega,
        coupling_twist_dot_by_cylinder_omega, minus_inverse_cylinder_inertia, t2 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_twist, p.initial_twist_rate, R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 16 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p.load_torque.add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let cylinder_omega_dot = ((c.t0 * coupling_twist).add_product(c.t1, coupling_twist_rate)
        - resistance) * c.inverse_cylinder_inertia;
    let driver_omega_dot = (p.drive_torque - coupling_torque) * c.inverse_driver_inertia;
    [coupling_twist_rate, driver_omega_dot, cylinder_omega_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    [p.driver_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 16 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p.load_torque.add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    let driver_phi_forcing = p.drive_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate) - resistance;
    [driver_phi_forcing, cylinder_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 8] {
    [R::literal(1.0), c.coupling_twist_dot_by_cylinder_omega, c.driver_omega_dot_by_coupling_twist,
        c.driver_omega_dot_by_driver_omega, c.driver_omega_dot_by_cylinder_omega,
        c.cylinder_omega_dot_by_coupling_twist, c.cylinder_omega_dot_by_driver_omega,
        c.cylinder_omega_dot_by_cylinder_omega]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 43 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 21] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let load_frequency_times_time = p.load_frequency * time;
    let (sin_load_frequency_times_time, cos_load_frequency_times_time) = load_frequency_times_time
        .sin_cos();
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = driver_omega - coupling_ratio_times_cylinder_omega;
    let resistance = p.load_torque.add_product(p.load_amplitude, sin_load_frequency_times_time);
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let cylinder_omega_dot = ((c.t0 * coupling_twist).add_product(c.t1, coupling_twist_rate)
        - resistance) * c.inverse_cylinder_inertia;
    let driver_omega_dot = (p.drive_torque - coupling_torque) * c.inverse_driver_inertia;
    let cylinder_omega_dot_by_load_amplitude = -(sin_load_frequency_times_time
        * c.inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_frequency = -(p.load_amplitude * time
        * cos_load_frequency_times_time * c.inverse_cylinder_inertia);
    let driver_omega_dot_by_driver_inertia = -(driver_omega_dot * c.inverse_driver_inertia);
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * c.inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_stiffness = -(coupling_twist * c.inverse_driver_inertia);
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * c.inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega - driver_omega)
        * c.inverse_driver_inertia;
    let cylinder_omega_dot_by_coupling_ratio = t0.add_product(p.coupling_damping, driver_omega)
        .sub_product(c.t2, cylinder_omega) * c.inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_ratio = p.coupling_damping * cylinder_omega
        * c.inverse_driver_inertia;
    let coupling_twist_dot_by_coupling_ratio = -cylinder_omega;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot * c.inverse_cylinder_inertia);
    [R::literal(1.0), c.coupling_twist_dot_by_cylinder_omega, c.driver_omega_dot_by_coupling_twist,
        c.driver_omega_dot_by_driver_omega, c.driver_omega_dot_by_cylinder_omega,
        c.cylinder_omega_dot_by_coupling_twist, c.cylinder_omega_dot_by_driver_omega,
        c.cylinder_omega_dot_by_cylinder_omega, coupling_twist_dot_by_coupling_ratio,
        c.inverse_driver_inertia, driver_omega_dot_by_driver_inertia,
        driver_omega_dot_by_coupling_stiffness, driver_omega_dot_by_coupling_damping,
        driver_omega_dot_by_coupling_ratio, c.minus_inverse_cylinder_inertia,
        cylinder_omega_dot_by_load_amplitude, cylinder_omega_dot_by_load_frequency,
        cylinder_omega_dot_by_coupling_stiffness, cylinder_omega_dot_by_coupling_damping,
        cylinder_omega_dot_by_coupling_ratio, cylinder_omega_dot_by_cylinder_inertia]
}

/// Partial derivative of `y'` with respect to time. 6 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let cylinder_omega_dot_by_time = p.load_amplitude * p.load_frequency * (p.load_frequency * time)
        .cos() * (R::literal(-1.0) / p.cylinder_inertia);
    [R::literal(0.0), R::literal(0.0), cylinder_omega_dot_by_time]
}

/// Wanted outputs. 5 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist).add_product(p.coupling_damping,
        coupling_twist_rate);
    Outputs {
        twist: coupling_twist,
        coupling_torque,
        driver_speed: driver_omega,
        cylinder_speed: cylinder_omega,
    }
}

/// T, V and the energy of first-order states \[J\]. 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.driver_inertia * (driver_omega * driver_omega))
            .add_product(R::literal(0.5) * p.cylinder_inertia, cylinder_omega * cylinder_omega),
        potential: R::literal(0.5) * p.coupling_stiffness * (coupling_twist * coupling_twist),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 35 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p.load_torque.add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let t1 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(t1, coupling_twist_rate) - resistance) * (R::literal(1.0)
        / p.cylinder_inertia);
    let driver_omega_dot = (p.drive_torque - coupling_torque) * (R::literal(1.0)
        / p.driver_inertia);
    PowerBalance {
        stored_rate: (t0 * coupling_twist_rate).add_product(p.driver_inertia * driver_omega,
            driver_omega_dot).add_product(p.cylinder_inertia * cylinder_omega, cylinder_omega_dot),
        supplied: (p.drive_torque * driver_omega).sub_product(cylinder_omega, resistance),
        dissipated: (p.coupling_damping * driver_omega * coupling_twist_rate).sub_product(t1
            * cylinder_omega, coupling_twist_rate),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 35 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let t0 = cylinder_omega * p.coupling_ratio;
    let coupling_twist_rate = driver_omega - t0;
    let t1 = time * p.load_frequency;
    let t2 = t1.sin();
    let t3 = t1.cos();
    let t4 = t2 * p.load_amplitude;
    let resistance = p.load_torque + t4;
    let t5 = coupling_twist * p.coupling_stiffness;
    let t6 = coupling_twist_rate * p.coupling_damping;
    let coupling_torque = t5 + t6;
    let t7 = R::literal(1.0) / p.driver_inertia;
    let t8 = R::literal(1.0) / p.cylinder_inertia;
    let t9 = p.drive_torque - coupling_torque;
    let t10 = p.coupling_stiffness * p.coupling_ratio;
    let t11 = coupling_twist * t10;
    let t12 = p.coupling_damping * p.coupling_ratio;
    let t13 = coupling_twist_rate * t12;
    let t14 = t11 + t13;
    let t15 = t14 - resistance;
    let cylinder_omega_dot = t15 * t8;
    let driver_omega_dot = t9 * t7;
    let mut t2_before = t2;
    let mut t3_before = t3;
    let mut rates = [coupling_twist_rate, driver_omega_dot, cylinder_omega_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [coupling_twist_k, driver_omega_k, cylinder_omega_k] = *state_k;
        let coupling_twist_rate_k = (-cylinder_omega_k).mul_add(p.coupling_ratio, driver_omega_k);
        let t2_k = inverse * p.load_frequency * t3_before;
        let t3_k = -inverse * p.load_frequency * t2_before;
        let coupling_torque_k = coupling_twist_rate_k.mul_add(p.coupling_damping, coupling_twist_k
            * p.coupling_stiffness);
        let t9_k = -coupling_torque_k;
        let t14_k = coupling_twist_rate_k.mul_add(t12, coupling_twist_k * t10);
        let t15_k = t14_k - t2_k * p.load_amplitude;
        let cylinder_omega_dot_k = t15_k * t8;
        let driver_omega_dot_k = t9_k * t7;
        t2_before = t2_k;
        t3_before = t3_k;
        rates = [coupling_twist_rate_k, driver_omega_dot_k, cylinder_omega_dot_k];
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(1, 0), (2, 0), (2, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 7 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 12] {
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    [R::literal(0.0), R::literal(0.0), p.drive_torque * (R::literal(1.0) / p.driver_inertia),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), -(p.load_torque
        * inverse_cylinder_inertia), R::literal(0.0), R::literal(0.0), p.load_frequency,
        R::literal(0.0), -(p.load_amplitude * inverse_cylinder_inertia)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   7d11b427e35d3b5e342aeab78644622db3f121423f6c82e2f25a2bc4b9d6bb13  scenes/two_mass.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//
// Two rotors on an elasto-dissipative coupling
//
// Rotor of the motor and saw cylinder on their coupling, driven and loaded by given torques.
//
// Source:
//   Saw-gin study (2020), equations (1).
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        0
//   states                    3
//   parameters               11
//   outputs                   4
//   discontinuities           0
//
// State:
//     0  coupling.twist  [rad]    twist
//     1  driver.omega    [rad/s]  rate of angle
//     2  cylinder.omega  [rad/s]  rate of angle
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian             8 of 3 by 3
//   parameter_jacobian       13 of 3 by 11
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     20
//   mass_matrix               0
//   forcing                  16
//   rate_jacobian            16
//   parameter_jacobian       50
//   time_derivative           7
//   outputs                   5
//   energy                   10
//   power_balance            35
// With constants of the parameters, prepared once a run:
//   prepare                  16
//   prepared_rate            16
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, linear::LinearEquations,
    taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 11;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 11,
    entries: &[
        (0, 9), (1, 0), (1, 6), (1, 7), (1, 8), (1, 9), (2, 1), (2, 2), (2, 3), (2, 7), (2, 8),
        (2, 9), (2, 10),
    ],
};

/// Two rotors on an elasto-dissipative coupling
///
/// Rotor of the motor and saw cylinder on their coupling, driven and loaded by given torques.
///
/// Source: Saw-gin study (2020), equations (1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TwoMass;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// drive_torque: constant driving torque \[N m\]. In the spec: 974.4.
    pub drive_torque: R,
    /// load_torque: constant resisting torque \[N m\]. In the spec: 843.72.
    pub load_torque: R,
    /// load_amplitude: amplitude of the harmonic resisting torque \[N m\]. In the spec: 0.0.
    pub load_amplitude: R,
    /// load_frequency: angular frequency of the harmonic resisting torque \[rad/s\]. In the spec: 241.8051.
    pub load_frequency: R,
    /// initial_twist: twist at the start \[rad\]. In the spec: 0.0.
    pub initial_twist: R,
    /// initial_twist_rate: rate of twist at the start \[rad/s\]. In the spec: 0.0.
    pub initial_twist_rate: R,
    /// driver.inertia: moment of inertia \[kg m^2\]. In the spec: 4.2.
    pub driver_inertia: R,
    /// coupling.stiffness: torsional stiffness \[N m/rad\]. In the spec: 23065.2.
    pub coupling_stiffness: R,
    /// coupling.damping: torsional damping \[N m s/rad\]. In the spec: 128.5346.
    pub coupling_damping: R,
    /// coupling.ratio: turns of the driving end for one turn of the driven end \[1\]. In the spec: 1.0.
    pub coupling_ratio: R,
    /// cylinder.inertia: moment of inertia \[kg m^2\]. In the spec: 1.244.
    pub cylinder_inertia: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            drive_torque: values[0],
            load_torque: values[1],
            load_amplitude: values[2],
            load_frequency: values[3],
            initial_twist: values[4],
            initial_twist_rate: values[5],
            driver_inertia: values[6],
            coupling_stiffness: values[7],
            coupling_damping: values[8],
            coupling_ratio: values[9],
            cylinder_inertia: values[10],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.drive_torque,
            self.load_torque,
            self.load_amplitude,
            self.load_frequency,
            self.initial_twist,
            self.initial_twist_rate,
            self.driver_inertia,
            self.coupling_stiffness,
            self.coupling_damping,
            self.coupling_ratio,
            self.cylinder_inertia,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            drive_torque: R::literal(974.4),
            load_torque: R::literal(843.72),
            load_amplitude: R::literal(0.0),
            load_frequency: R::literal(241.8051),
            initial_twist: R::literal(0.0),
            initial_twist_rate: R::literal(0.0),
            driver_inertia: R::literal(4.2),
            coupling_stiffness: R::literal(23065.2),
            coupling_damping: R::literal(128.5346),
            coupling_ratio: R::literal(1.0),
            cylinder_inertia: R::literal(1.244),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// twist: twist \[rad\].
    pub twist: R,
    /// coupling_torque: torque carried, on the driving side \[N m\].
    pub coupling_torque: R,
    /// driver_speed: rate of angle \[rad/s\].
    pub driver_speed: R,
    /// cylinder_speed: rate of angle \[rad/s\].
    pub cylinder_speed: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            twist: values[0],
            coupling_torque: values[1],
            driver_speed: values[2],
            cylinder_speed: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.twist, self.coupling_torque, self.driver_speed, self.cylinder_speed]
    }
}

/// Where to find what in the state.
pub mod state {
    /// coupling.twist: twist \[rad\].
    pub const COUPLING_TWIST: usize = 0;
    /// driver.omega: rate of angle \[rad/s\].
    pub const DRIVER_OMEGA: usize = 1;
    /// cylinder.omega: rate of angle \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 11;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_driver_inertia: R,
    pub inverse_cylinder_inertia: R,
    pub t0: R,
    pub t1: R,
    pub cylinder_omega_dot_by_coupling_twist: R,
    pub driver_omega_dot_by_coupling_twist: R,
    pub cylinder_omega_dot_by_driver_omega: R,
    pub driver_omega_dot_by_driver_omega: R,
    pub cylinder_omega_dot_by_cylinder_omega: R,
    pub driver_omega_dot_by_cylinder_omega: R,
    pub coupling_twist_dot_by_cylinder_omega: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_driver_inertia: values[0],
            inverse_cylinder_inertia: values[1],
            t0: values[2],
            t1: values[3],
            cylinder_omega_dot_by_coupling_twist: values[4],
            driver_omega_dot_by_coupling_twist: values[5],
            cylinder_omega_dot_by_driver_omega: values[6],
            driver_omega_dot_by_driver_omega: values[7],
            cylinder_omega_dot_by_cylinder_omega: values[8],
            driver_omega_dot_by_cylinder_omega: values[9],
            coupling_twist_dot_by_cylinder_omega: values[10],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_driver_inertia,
            self.inverse_cylinder_inertia,
            self.t0,
            self.t1,
            self.cylinder_omega_dot_by_coupling_twist,
            self.driver_omega_dot_by_coupling_twist,
            self.cylinder_omega_dot_by_driver_omega,
            self.driver_omega_dot_by_driver_omega,
            self.cylinder_omega_dot_by_cylinder_omega,
            self.driver_omega_dot_by_cylinder_omega,
            self.coupling_twist_dot_by_cylinder_omega,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 16 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_driver_inertia = R::literal(1.0) / p.driver_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t0 = p.coupling_stiffness * p.coupling_ratio;
    let t1 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot_by_coupling_twist = t0 * inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_twist = -(p.coupling_stiffness
        * inverse_driver_inertia);
    let cylinder_omega_dot_by_driver_omega = t1 * inverse_cylinder_inertia;
    let driver_omega_dot_by_driver_omega = -(p.coupling_damping
        * inverse_driver_inertia);
    let cylinder_omega_dot_by_cylinder_omega = -(p.coupling_damping
        * (p.coupling_ratio * p.coupling_ratio) * inverse_cylinder_inertia);
    let driver_omega_dot_by_cylinder_omega = t1 * inverse_driver_inertia;
    let coupling_twist_dot_by_cylinder_omega = -p.coupling_ratio;
    Constants {
        inverse_driver_inertia,
        inverse_cylinder_inertia,
        t0,
        t1,
        cylinder_omega_dot_by_coupling_twist,
        driver_omega_dot_by_coupling_twist,
        cylinder_omega_dot_by_driver_omega,
        driver_omega_dot_by_driver_omega,
        cylinder_omega_dot_by_cylinder_omega,
        driver_omega_dot_by_cylinder_omega,
        coupling_twist_dot_by_cylinder_omega,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_twist, p.initial_twist_rate, R::literal(0.0)]
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
/// 20 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 16 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p
        .load_torque
        .add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let cylinder_omega_dot = ((c.t0 * coupling_twist)
        .add_product(c.t1, coupling_twist_rate) - resistance)
        * c.inverse_cylinder_inertia;
    let driver_omega_dot = (p.drive_torque - coupling_torque) * c.inverse_driver_inertia;
    [coupling_twist_rate, driver_omega_dot, cylinder_omega_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
    [p.driver_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 16 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p
        .load_torque
        .add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let driver_phi_forcing = p.drive_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - resistance;
    [driver_phi_forcing, cylinder_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 16 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 8] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 8] {
    [
        R::literal(1.0),
        c.coupling_twist_dot_by_cylinder_omega,
        c.driver_omega_dot_by_coupling_twist,
        c.driver_omega_dot_by_driver_omega,
        c.driver_omega_dot_by_cylinder_omega,
        c.cylinder_omega_dot_by_coupling_twist,
        c.cylinder_omega_dot_by_driver_omega,
        c.cylinder_omega_dot_by_cylinder_omega,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 50 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 13] {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let load_frequency_times_time = p.load_frequency * time;
    let (sin_load_frequency_times_time, cos_load_frequency_times_time) = load_frequency_times_time
        .sin_cos();
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = driver_omega - coupling_ratio_times_cylinder_omega;
    let resistance = p
        .load_torque
        .add_product(p.load_amplitude, sin_load_frequency_times_time);
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let inverse_driver_inertia = R::literal(1.0) / p.driver_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - resistance) * inverse_cylinder_inertia;
    let driver_omega_dot = (p.drive_torque - coupling_torque) * inverse_driver_inertia;
    let cylinder_omega_dot_by_load_torque = -inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_amplitude = -(sin_load_frequency_times_time
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_frequency = -(p.load_amplitude * time
        * cos_load_frequency_times_time * inverse_cylinder_inertia);
    let driver_omega_dot_by_driver_inertia = -(driver_omega_dot
        * inverse_driver_inertia);
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_stiffness = -(coupling_twist
        * inverse_driver_inertia);
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega
        - driver_omega) * inverse_driver_inertia;
    let cylinder_omega_dot_by_coupling_ratio = t0
        .add_product(p.coupling_damping, driver_omega)
        .sub_product(
            R::literal(2.0) * p.coupling_damping * p.coupling_ratio,
            cylinder_omega,
        ) * inverse_cylinder_inertia;
    let driver_omega_dot_by_coupling_ratio = p.coupling_damping * cylinder_omega
        * inverse_driver_inertia;
    let coupling_twist_dot_by_coupling_ratio = -cylinder_omega;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot
        * inverse_cylinder_inertia);
    [
        coupling_twist_dot_by_coupling_ratio,
        inverse_driver_inertia,
        driver_omega_dot_by_driver_inertia,
        driver_omega_dot_by_coupling_stiffness,
        driver_omega_dot_by_coupling_damping,
        driver_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_load_torque,
        cylinder_omega_dot_by_load_amplitude,
        cylinder_omega_dot_by_load_frequency,
        cylinder_omega_dot_by_coupling_stiffness,
        cylinder_omega_dot_by_coupling_damping,
        cylinder_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_cylinder_inertia,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 7 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let cylinder_omega_dot_by_time = -(p.load_amplitude * p.load_frequency
        * (p.load_frequency * time).cos() * (R::literal(1.0) / p.cylinder_inertia));
    [R::literal(0.0), R::literal(0.0), cylinder_omega_dot_by_time]
}

/// Wanted outputs.
///
/// 5 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    Outputs {
        twist: coupling_twist,
        coupling_torque,
        driver_speed: driver_omega,
        cylinder_speed: cylinder_omega,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.driver_inertia * (driver_omega * driver_omega))
            .add_product(
                R::literal(0.5) * p.cylinder_inertia,
                cylinder_omega * cylinder_omega,
            ),
        potential: R::literal(0.5) * p.coupling_stiffness
            * (coupling_twist * coupling_twist),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 35 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [coupling_twist, driver_omega, cylinder_omega] = *state;
    let coupling_twist_rate = driver_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let resistance = p
        .load_torque
        .add_product(p.load_amplitude, (p.load_frequency * time).sin());
    let t0 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t0.add_product(p.coupling_damping, coupling_twist_rate);
    let t1 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(t1, coupling_twist_rate) - resistance)
        * (R::literal(1.0) / p.cylinder_inertia);
    let driver_omega_dot = (p.drive_torque - coupling_torque)
        * (R::literal(1.0) / p.driver_inertia);
    PowerBalance {
        stored_rate: (t0 * coupling_twist_rate)
            .add_product(p.driver_inertia * driver_omega, driver_omega_dot)
            .add_product(p.cylinder_inertia * cylinder_omega, cylinder_omega_dot),
        supplied: (p.drive_torque * driver_omega)
            .sub_product(cylinder_omega, resistance),
        dissipated: (p.coupling_damping * driver_omega * coupling_twist_rate)
            .sub_product(t1 * cylinder_omega, coupling_twist_rate),
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
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
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
        let coupling_twist_rate_k = (-cylinder_omega_k)
            .mul_add(p.coupling_ratio, driver_omega_k);
        let t2_k = inverse * p.load_frequency * t3_before;
        let t3_k = -inverse * p.load_frequency * t2_before;
        let coupling_torque_k = coupling_twist_rate_k
            .mul_add(p.coupling_damping, coupling_twist_k * p.coupling_stiffness);
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

impl<R: Real> TaylorSeries<R> for TwoMass {
    fn series_workspace(&self, _order: usize) -> usize {
        0
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

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(1, 0), (2, 0), (2, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// 7 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, p: &Parameters<R>) -> [R; 12] {
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    [
        R::literal(0.0),
        R::literal(0.0),
        p.drive_torque * (R::literal(1.0) / p.driver_inertia),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        -(p.load_torque * inverse_cylinder_inertia),
        R::literal(0.0),
        R::literal(0.0),
        p.load_frequency,
        R::literal(0.0),
        -(p.load_amplitude * inverse_cylinder_inertia),
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for TwoMass {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        &EXCITATION_TERMS
    }
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&excitation(time, &parameters_of(parameters)));
    }
    fn switches(&self) -> usize {
        SWITCHES
    }
    fn switch_times(&self, parameters: &[R], times: &mut [R]) {
        times.copy_from_slice(&switches(&parameters_of(parameters)));
    }
}

impl Describe for TwoMass {
    fn name(&self) -> &'static str {
        "two_mass"
    }
    fn title(&self) -> &'static str {
        "Two rotors on an elasto-dissipative coupling"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
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
    fn state_kind(&self, index: usize) -> StateKind {
        STATE_KINDS[index]
    }
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        COORDINATE_QUANTITIES[index]
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

impl<R: Real> Simulator<R> for TwoMass {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate(time, state_of(state), &p, &c);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate_jacobian(time, state_of(state), &p, &c);
    }
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
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
        Some(self)
    }
}

#[inline]
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
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

static STATE_KINDS: [StateKind; STATES] = [
    StateKind::Position,
    StateKind::Velocity,
    StateKind::Velocity,
];

static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [
    Quantity {
        name: "driver.phi",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "cylinder.phi",
        unit: "rad",
        doc: "angle",
    },
];

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "coupling.twist",
        unit: "rad",
        doc: "twist",
    },
    Quantity {
        name: "driver.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "cylinder.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 78.5, 78.5];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "drive_torque",
        unit: "N m",
        doc: "constant driving torque",
    },
    Quantity {
        name: "load_torque",
        unit: "N m",
        doc: "constant resisting torque",
    },
    Quantity {
        name: "load_amplitude",
        unit: "N m",
        doc: "amplitude of the harmonic resisting torque",
    },
    Quantity {
        name: "load_frequency",
        unit: "rad/s",
        doc: "angular frequency of the harmonic resisting torque",
    },
    Quantity {
        name: "initial_twist",
        unit: "rad",
        doc: "twist at the start",
    },
    Quantity {
        name: "initial_twist_rate",
        unit: "rad/s",
        doc: "rate of twist at the start",
    },
    Quantity {
        name: "driver.inertia",
        unit: "kg m^2",
        doc: "moment of inertia",
    },
    Quantity {
        name: "coupling.stiffness",
        unit: "N m/rad",
        doc: "torsional stiffness",
    },
    Quantity {
        name: "coupling.damping",
        unit: "N m s/rad",
        doc: "torsional damping",
    },
    Quantity {
        name: "coupling.ratio",
        unit: "1",
        doc: "turns of the driving end for one turn of the driven end",
    },
    Quantity {
        name: "cylinder.inertia",
        unit: "kg m^2",
        doc: "moment of inertia",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    974.4,
    843.72,
    0.0,
    241.8051,
    0.0,
    0.0,
    4.2,
    23065.2,
    128.5346,
    1.0,
    1.244,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "twist",
        unit: "rad",
        doc: "twist",
    },
    Quantity {
        name: "coupling_torque",
        unit: "N m",
        doc: "torque carried, on the driving side",
    },
    Quantity {
        name: "driver_speed",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "cylinder_speed",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.5,
    points: 1001,
    rtol: 1e-8,
    method: "tsit45",
};

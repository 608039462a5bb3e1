// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   a84965a91db7cfa103c22695ba1ae6324662522399db683b4171fce80e13d5b7  scenes/saw_gin.toml
//   fe2f2deb5f36655ff87e1d6f2bb763716b1c76007878e37e8e41643655074862  units/induction_motor.toml
//   a479b553f0542fe4aecc9e2a030097bc5b34e101f44a5e7297713fb52484327b  units/coupling.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//   c25829d257d53d2e48562bcbdac2bfe42940eb3fdb1c5913863f1432683f6420  units/technological_load.toml
//
// Saw gin: motor, coupling and saw cylinder
//
// The machine runs up empty; the technological load engages at 1.2 s and opposes
// motion.
//
// Source:
//   Saw-gin study (2020), equations (1) and (2), in their consistent reading.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        4
//   states                    7
//   parameters               21
//   outputs                   8
//   discontinuities           0
//
// State:
//     0  coupling.twist  [rad]    twist
//     1  motor.omega     [rad/s]  rate of rotor angle
//     2  cylinder.omega  [rad/s]  rate of angle
//     3  motor.psi_sx    [V s]    stator flux linkage along x
//     4  motor.psi_sy    [V s]    stator flux linkage along y
//     5  motor.psi_rx    [V s]    rotor flux linkage along x
//     6  motor.psi_ry    [V s]    rotor flux linkage along y
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian            26 of 7 by 7
//   parameter_jacobian       39 of 7 by 21
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     78
//   mass_matrix               0
//   forcing                  43
//   rate_jacobian            73
//   parameter_jacobian      184
//   time_derivative          32
//   outputs                  55
//   energy                   39
//   power_balance           152
// With constants of the parameters, prepared once a run:
//   prepare                  44
//   prepared_rate            55
//   prepared_rate_jacobian   34

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, StateKind, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 7;

/// Parameters.
pub const PARAMETERS: usize = 21;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

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
    rows: 7,
    columns: 7,
    entries: &[
        (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (2, 0), (2, 1),
        (2, 2), (3, 3), (3, 4), (3, 5), (4, 3), (4, 4), (4, 6), (5, 1), (5, 3), (5, 5), (5, 6),
        (6, 1), (6, 4), (6, 5), (6, 6),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 7,
    columns: 21,
    entries: &[
        (0, 12), (1, 0), (1, 2), (1, 4), (1, 5), (1, 6), (1, 7), (1, 10), (1, 11), (1, 12), (2, 10),
        (2, 11), (2, 12), (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20),
        (3, 1), (3, 2), (3, 3), (3, 6), (3, 8), (4, 1), (4, 2), (4, 3), (4, 6), (4, 8), (5, 2),
        (5, 4), (5, 5), (5, 9), (6, 2), (6, 4), (6, 5), (6, 9),
    ],
};

/// Saw gin: motor, coupling and saw cylinder
///
/// The machine runs up empty; the technological load engages at 1.2 s and opposes
/// motion.
///
/// Source: Saw-gin study (2020), equations (1) and (2), in their consistent reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SawGin;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// motor.inertia: moment of inertia of the rotor \[kg m^2\]. In the spec: 4.2.
    pub motor_inertia: R,
    /// motor.phase_voltage: root mean square of the phase voltage \[V\]. In the spec: 220.0.
    pub motor_phase_voltage: R,
    /// motor.supply_frequency: frequency of the supply \[Hz\]. In the spec: 50.0.
    pub motor_supply_frequency: R,
    /// motor.supply_phase: phase of the supply at the start \[rad\]. In the spec: 0.0.
    pub motor_supply_phase: R,
    /// motor.pole_pairs: pairs of poles \[1\]. In the spec: 4.0.
    pub motor_pole_pairs: R,
    /// motor.k_s: stator coupling factor x_mu/x_s \[1\]. In the spec: 0.956.
    pub motor_k_s: R,
    /// motor.k_r: rotor coupling factor x_mu/x_r \[1\]. In the spec: 0.952.
    pub motor_k_r: R,
    /// motor.x_s: stator reactance at supply frequency \[ohm\]. In the spec: 4.14.
    pub motor_x_s: R,
    /// motor.alpha_s: stator decay r_s/(sigma x_s) \[1\]. In the spec: 0.115.
    pub motor_alpha_s: R,
    /// motor.alpha_r: rotor decay r_r/(sigma x_r) \[1\]. In the spec: 0.0858.
    pub motor_alpha_r: R,
    /// coupling.stiffness: torsional stiffness \[N m/rad\]. In the spec: 23065.2.
    pub coupling_stiffness: R,
    /// coupling.damping: torsional damping \[N m s/rad\]. In the spec: 128.5346.
    pub coupling_damping: R,
    /// coupling.ratio: turns of the driving end for one turn of the driven end \[1\]. In the spec: 1.0.
    pub coupling_ratio: R,
    /// cylinder.inertia: moment of inertia \[kg m^2\]. In the spec: 1.244.
    pub cylinder_inertia: R,
    /// load.mean: mean torque \[N m\]. In the spec: 843.72.
    pub load_mean: R,
    /// load.amplitude: amplitude of the harmonic part \[N m\]. In the spec: 78.78.
    pub load_amplitude: R,
    /// load.speed: nominal speed in revolutions per minute, a count as the study gives it \[1\]. In the spec: 735.0.
    pub load_speed: R,
    /// load.phase: phase of the harmonic part \[rad\]. In the spec: 0.0.
    pub load_phase: R,
    /// load.engagement_time: time at which half of the load acts \[s\]. In the spec: 1.2.
    pub load_engagement_time: R,
    /// load.engagement_width: time constant of engagement \[s\]. In the spec: 0.02.
    pub load_engagement_width: R,
    /// load.standstill_band: speed below which the load fades out \[rad/s\]. In the spec: 0.5.
    pub load_standstill_band: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            motor_inertia: values[0],
            motor_phase_voltage: values[1],
            motor_supply_frequency: values[2],
            motor_supply_phase: values[3],
            motor_pole_pairs: values[4],
            motor_k_s: values[5],
            motor_k_r: values[6],
            motor_x_s: values[7],
            motor_alpha_s: values[8],
            motor_alpha_r: values[9],
            coupling_stiffness: values[10],
            coupling_damping: values[11],
            coupling_ratio: values[12],
            cylinder_inertia: values[13],
            load_mean: values[14],
            load_amplitude: values[15],
            load_speed: values[16],
            load_phase: values[17],
            load_engagement_time: values[18],
            load_engagement_width: values[19],
            load_standstill_band: values[20],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.motor_inertia,
            self.motor_phase_voltage,
            self.motor_supply_frequency,
            self.motor_supply_phase,
            self.motor_pole_pairs,
            self.motor_k_s,
            self.motor_k_r,
            self.motor_x_s,
            self.motor_alpha_s,
            self.motor_alpha_r,
            self.coupling_stiffness,
            self.coupling_damping,
            self.coupling_ratio,
            self.cylinder_inertia,
            self.load_mean,
            self.load_amplitude,
            self.load_speed,
            self.load_phase,
            self.load_engagement_time,
            self.load_engagement_width,
            self.load_standstill_band,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            motor_inertia: R::literal(4.2),
            motor_phase_voltage: R::literal(220.0),
            motor_supply_frequency: R::literal(50.0),
            motor_supply_phase: R::literal(0.0),
            motor_pole_pairs: R::literal(4.0),
            motor_k_s: R::literal(0.956),
            motor_k_r: R::literal(0.952),
            motor_x_s: R::literal(4.14),
            motor_alpha_s: R::literal(0.115),
            motor_alpha_r: R::literal(0.0858),
            coupling_stiffness: R::literal(23065.2),
            coupling_damping: R::literal(128.5346),
            coupling_ratio: R::literal(1.0),
            cylinder_inertia: R::literal(1.244),
            load_mean: R::literal(843.72),
            load_amplitude: R::literal(78.78),
            load_speed: R::literal(735.0),
            load_phase: R::literal(0.0),
            load_engagement_time: R::literal(1.2),
            load_engagement_width: R::literal(0.02),
            load_standstill_band: R::literal(0.5),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// motor_speed: rate of rotor angle \[rad/s\].
    pub motor_speed: R,
    /// cylinder_speed: rate of angle \[rad/s\].
    pub cylinder_speed: R,
    /// motor_torque: electromagnetic torque \[N m\].
    pub motor_torque: R,
    /// coupling_torque: torque carried, on the driving side \[N m\].
    pub coupling_torque: R,
    /// load_torque: resisting torque \[N m\].
    pub load_torque: R,
    /// twist: twist \[rad\].
    pub twist: R,
    /// cylinder_acceleration: rate of rate of angle \[rad/s^2\].
    pub cylinder_acceleration: R,
    /// stator_current: amplitude of the stator current \[A\].
    pub stator_current: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            motor_speed: values[0],
            cylinder_speed: values[1],
            motor_torque: values[2],
            coupling_torque: values[3],
            load_torque: values[4],
            twist: values[5],
            cylinder_acceleration: values[6],
            stator_current: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.motor_speed,
            self.cylinder_speed,
            self.motor_torque,
            self.coupling_torque,
            self.load_torque,
            self.twist,
            self.cylinder_acceleration,
            self.stator_current,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// coupling.twist: twist \[rad\].
    pub const COUPLING_TWIST: usize = 0;
    /// motor.omega: rate of rotor angle \[rad/s\].
    pub const MOTOR_OMEGA: usize = 1;
    /// cylinder.omega: rate of angle \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 2;
    /// motor.psi_sx: stator flux linkage along x \[V s\].
    pub const MOTOR_PSI_SX: usize = 3;
    /// motor.psi_sy: stator flux linkage along y \[V s\].
    pub const MOTOR_PSI_SY: usize = 4;
    /// motor.psi_rx: rotor flux linkage along x \[V s\].
    pub const MOTOR_PSI_RX: usize = 5;
    /// motor.psi_ry: rotor flux linkage along y \[V s\].
    pub const MOTOR_PSI_RY: usize = 6;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 26;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub motor_omega_0: R,
    pub motor_u_x: R,
    pub motor_u_y: R,
    pub inverse_load_engagement_width: R,
    pub t2: R,
    pub t3: R,
    pub inverse_load_standstill_band: R,
    pub inverse_motor_inertia: R,
    pub inverse_cylinder_inertia: R,
    pub t4: R,
    pub t5: R,
    pub motor_alpha_s_times_motor_omega_0: R,
    pub motor_alpha_r_times_motor_omega_0: R,
    pub cylinder_omega_dot_by_coupling_twist: R,
    pub motor_omega_dot_by_coupling_twist: R,
    pub cylinder_omega_dot_by_motor_omega: R,
    pub motor_omega_dot_by_motor_omega: R,
    pub t6: R,
    pub motor_omega_dot_by_cylinder_omega: R,
    pub coupling_twist_dot_by_cylinder_omega: R,
    pub t7: R,
    pub motor_psi_sx_dot_by_motor_psi_sx: R,
    pub motor_psi_sy_dot_by_motor_psi_sx: R,
    pub motor_psi_rx_dot_by_motor_psi_sx: R,
    pub motor_psi_sx_dot_by_motor_psi_rx: R,
    pub motor_psi_rx_dot_by_motor_psi_rx: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            motor_omega_0: values[0],
            motor_u_x: values[1],
            motor_u_y: values[2],
            inverse_load_engagement_width: values[3],
            t2: values[4],
            t3: values[5],
            inverse_load_standstill_band: values[6],
            inverse_motor_inertia: values[7],
            inverse_cylinder_inertia: values[8],
            t4: values[9],
            t5: values[10],
            motor_alpha_s_times_motor_omega_0: values[11],
            motor_alpha_r_times_motor_omega_0: values[12],
            cylinder_omega_dot_by_coupling_twist: values[13],
            motor_omega_dot_by_coupling_twist: values[14],
            cylinder_omega_dot_by_motor_omega: values[15],
            motor_omega_dot_by_motor_omega: values[16],
            t6: values[17],
            motor_omega_dot_by_cylinder_omega: values[18],
            coupling_twist_dot_by_cylinder_omega: values[19],
            t7: values[20],
            motor_psi_sx_dot_by_motor_psi_sx: values[21],
            motor_psi_sy_dot_by_motor_psi_sx: values[22],
            motor_psi_rx_dot_by_motor_psi_sx: values[23],
            motor_psi_sx_dot_by_motor_psi_rx: values[24],
            motor_psi_rx_dot_by_motor_psi_rx: values[25],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.motor_omega_0,
            self.motor_u_x,
            self.motor_u_y,
            self.inverse_load_engagement_width,
            self.t2,
            self.t3,
            self.inverse_load_standstill_band,
            self.inverse_motor_inertia,
            self.inverse_cylinder_inertia,
            self.t4,
            self.t5,
            self.motor_alpha_s_times_motor_omega_0,
            self.motor_alpha_r_times_motor_omega_0,
            self.cylinder_omega_dot_by_coupling_twist,
            self.motor_omega_dot_by_coupling_twist,
            self.cylinder_omega_dot_by_motor_omega,
            self.motor_omega_dot_by_motor_omega,
            self.t6,
            self.motor_omega_dot_by_cylinder_omega,
            self.coupling_twist_dot_by_cylinder_omega,
            self.t7,
            self.motor_psi_sx_dot_by_motor_psi_sx,
            self.motor_psi_sy_dot_by_motor_psi_sx,
            self.motor_psi_rx_dot_by_motor_psi_sx,
            self.motor_psi_sx_dot_by_motor_psi_rx,
            self.motor_psi_rx_dot_by_motor_psi_rx,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 44 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let (sin_motor_supply_phase, cos_motor_supply_phase) = p
        .motor_supply_phase
        .sin_cos();
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t0 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t0 * cos_motor_supply_phase;
    let motor_u_y = t0 * sin_motor_supply_phase;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t1 = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0;
    let t2 = t1 / (p.motor_x_s * motor_sigma);
    let t3 = R::literal(core::f64::consts::PI) * load_omega_2;
    let inverse_load_standstill_band = R::literal(1.0) / p.load_standstill_band;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let t4 = p.coupling_stiffness * p.coupling_ratio;
    let t5 = p.coupling_damping * p.coupling_ratio;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let cylinder_omega_dot_by_coupling_twist = t4 * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_twist = -(p.coupling_stiffness
        * inverse_motor_inertia);
    let cylinder_omega_dot_by_motor_omega = t5 * inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_omega = -(p.coupling_damping * inverse_motor_inertia);
    let t6 = -(p.coupling_damping * (p.coupling_ratio * p.coupling_ratio));
    let motor_omega_dot_by_cylinder_omega = t5 * inverse_motor_inertia;
    let coupling_twist_dot_by_cylinder_omega = -p.coupling_ratio;
    let t7 = t1 / (p.motor_x_s * (motor_k_s_times_motor_k_r - R::literal(1.0)));
    let motor_psi_sx_dot_by_motor_psi_sx = -motor_alpha_s_times_motor_omega_0;
    let motor_psi_sy_dot_by_motor_psi_sx = -motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_sx = p.motor_k_s * p.motor_alpha_r * motor_omega_0;
    let motor_psi_sx_dot_by_motor_psi_rx = p.motor_k_r * p.motor_alpha_s * motor_omega_0;
    let motor_psi_rx_dot_by_motor_psi_rx = -motor_alpha_r_times_motor_omega_0;
    Constants {
        motor_omega_0,
        motor_u_x,
        motor_u_y,
        inverse_load_engagement_width,
        t2,
        t3,
        inverse_load_standstill_band,
        inverse_motor_inertia,
        inverse_cylinder_inertia,
        t4,
        t5,
        motor_alpha_s_times_motor_omega_0,
        motor_alpha_r_times_motor_omega_0,
        cylinder_omega_dot_by_coupling_twist,
        motor_omega_dot_by_coupling_twist,
        cylinder_omega_dot_by_motor_omega,
        motor_omega_dot_by_motor_omega,
        t6,
        motor_omega_dot_by_cylinder_omega,
        coupling_twist_dot_by_cylinder_omega,
        t7,
        motor_psi_sx_dot_by_motor_psi_sx,
        motor_psi_sy_dot_by_motor_psi_sx,
        motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_psi_rx,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
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
/// 78 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 55 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_slip_speed = c.motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(c.inverse_load_engagement_width * (time - p.load_engagement_time)))
                .exp());
    let motor_torque = c.t2
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(p.load_amplitude, p.load_phase.add_product(c.t3, time).sin())
        * (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((c.t4 * coupling_twist)
        .add_product(c.t5, coupling_twist_rate) - load_resistance)
        * c.inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * c.inverse_motor_inertia;
    let motor_psi_sx_dot = c
        .motor_u_x
        .add_product(c.motor_omega_0, motor_psi_sy)
        .sub_product(
            c.motor_alpha_s_times_motor_omega_0,
            motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx),
        );
    let motor_psi_sy_dot = c
        .motor_u_y
        .sub_product(c.motor_omega_0, motor_psi_sx)
        .sub_product(
            c.motor_alpha_s_times_motor_omega_0,
            motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry),
        );
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(
            c.motor_alpha_r_times_motor_omega_0,
            (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx),
        );
    let motor_psi_ry_dot = (c.motor_alpha_r_times_motor_omega_0
        * (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy))
        .sub_product(motor_psi_rx, motor_slip_speed);
    [
        coupling_twist_rate,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
    ]
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
    [p.motor_inertia, p.cylinder_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 43 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / (p.motor_x_s * motor_sigma)
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(
                p.load_amplitude,
                p
                    .load_phase
                    .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)
                    .sin(),
            ) * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let motor_phi_forcing = motor_torque - coupling_torque;
    let cylinder_phi_forcing = (p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance;
    [motor_phi_forcing, cylinder_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 73 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 26] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 34 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 26] {
    let [_, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy, motor_psi_rx,
    motor_psi_ry] = *state;
    let motor_pole_pairs_times_motor_omega = p.motor_pole_pairs * motor_omega;
    let motor_slip_speed = c.motor_omega_0 - motor_pole_pairs_times_motor_omega;
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(c.inverse_load_engagement_width * (time - p.load_engagement_time)))
                .exp());
    let t0 = (c.inverse_load_standstill_band * cylinder_omega).tanh();
    let motor_psi_rx_dot_by_motor_omega = -(p.motor_pole_pairs * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_omega = p.motor_pole_pairs * motor_psi_rx;
    let cylinder_omega_dot_by_cylinder_omega = c
        .t6
        .sub_product(
            c.inverse_load_standstill_band * load_engagement
                * R::literal(1.0).sub_product(t0, t0),
            p
                .load_mean
                .add_product(
                    p.load_amplitude,
                    p.load_phase.add_product(c.t3, time).sin(),
                ),
        ) * c.inverse_cylinder_inertia;
    let motor_omega_dot_by_motor_psi_sx = c.t7 * motor_psi_ry * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_sy = c.t2 * motor_psi_rx * c.inverse_motor_inertia;
    let motor_omega_dot_by_motor_psi_rx = c.t2 * motor_psi_sy * c.inverse_motor_inertia;
    let motor_psi_ry_dot_by_motor_psi_rx = motor_pole_pairs_times_motor_omega
        - c.motor_omega_0;
    let motor_omega_dot_by_motor_psi_ry = c.t7 * motor_psi_sx * c.inverse_motor_inertia;
    [
        R::literal(1.0),
        c.coupling_twist_dot_by_cylinder_omega,
        c.motor_omega_dot_by_coupling_twist,
        c.motor_omega_dot_by_motor_omega,
        c.motor_omega_dot_by_cylinder_omega,
        motor_omega_dot_by_motor_psi_sx,
        motor_omega_dot_by_motor_psi_sy,
        motor_omega_dot_by_motor_psi_rx,
        motor_omega_dot_by_motor_psi_ry,
        c.cylinder_omega_dot_by_coupling_twist,
        c.cylinder_omega_dot_by_motor_omega,
        cylinder_omega_dot_by_cylinder_omega,
        c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_omega_0,
        c.motor_psi_sx_dot_by_motor_psi_rx,
        c.motor_psi_sy_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_sx,
        c.motor_psi_sx_dot_by_motor_psi_rx,
        motor_psi_rx_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx,
        c.motor_psi_rx_dot_by_motor_psi_rx,
        motor_slip_speed,
        motor_psi_ry_dot_by_motor_omega,
        c.motor_psi_rx_dot_by_motor_psi_sx,
        motor_psi_ry_dot_by_motor_psi_rx,
        c.motor_psi_rx_dot_by_motor_psi_rx,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 184 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 39] {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p
        .load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time);
    let [(sin_motor_supply_phase, cos_motor_supply_phase), (t1, t2)] = R::sin_cos_each([
        p.motor_supply_phase,
        t0,
    ]);
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_k_s_times_motor_k_r = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - motor_k_s_times_motor_k_r;
    let t3 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t3 * cos_motor_supply_phase;
    let motor_u_y = t3 * sin_motor_supply_phase;
    let coupling_ratio_times_cylinder_omega = p.coupling_ratio * cylinder_omega;
    let coupling_twist_rate = motor_omega - coupling_ratio_times_cylinder_omega;
    let t4 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t4.add_product(p.coupling_damping, coupling_twist_rate);
    let time_minus_load_engagement_time = time - p.load_engagement_time;
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t5 = (-(inverse_load_engagement_width * time_minus_load_engagement_time)).exp();
    let t6 = R::literal(1.0) + t5;
    let load_engagement = R::literal(1.0) / t6;
    let t7 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t8 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_psi_sx_times_motor_psi_ry = motor_psi_sx * motor_psi_ry;
    let motor_psi_sy_times_motor_psi_rx = motor_psi_sy * motor_psi_rx;
    let t9 = motor_psi_sy_times_motor_psi_rx - motor_psi_sx_times_motor_psi_ry;
    let t10 = R::literal(1.5) * p.motor_pole_pairs;
    let motor_torque = t10 * p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma
        * t9;
    let t11 = p.load_mean.add_product(p.load_amplitude, t1);
    let t12 = (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let load_resistance = load_engagement * t11 * t12;
    let inverse_motor_inertia = R::literal(1.0) / p.motor_inertia;
    let inverse_cylinder_inertia = R::literal(1.0) / p.cylinder_inertia;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance) * inverse_cylinder_inertia;
    let motor_omega_dot = (motor_torque - coupling_torque) * inverse_motor_inertia;
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let t13 = (-motor_psi_rx).add_product(p.motor_k_s, motor_psi_sx);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let t14 = (-motor_psi_ry).add_product(p.motor_k_s, motor_psi_sy);
    let t15 = motor_k_s_times_motor_k_r - R::literal(1.0);
    let motor_omega_dot_by_motor_inertia = -(motor_omega_dot * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * cos_motor_supply_phase;
    let motor_psi_sy_dot_by_motor_phase_voltage = R::literal(core::f64::consts::SQRT_2)
        * sin_motor_supply_phase;
    let motor_omega_dot_by_motor_supply_frequency = R::literal(
        3.0 * core::f64::consts::PI,
    ) * p.motor_pole_pairs * p.motor_k_r / motor_x_s_times_motor_sigma * t9
        * inverse_motor_inertia;
    let t16 = R::literal(core::f64::consts::TAU) * p.motor_alpha_s;
    let motor_psi_sx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_sy)
        .sub_product(t16, t7);
    let motor_psi_sy_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_sx))
        .sub_product(t16, t8);
    let t17 = R::literal(core::f64::consts::TAU) * p.motor_alpha_r;
    let motor_psi_rx_dot_by_motor_supply_frequency = (R::literal(core::f64::consts::TAU)
        * motor_psi_ry)
        .add_product(t17, t13);
    let motor_psi_ry_dot_by_motor_supply_frequency = (-(R::literal(
        core::f64::consts::TAU,
    ) * motor_psi_rx))
        .add_product(t17, t14);
    let motor_psi_sx_dot_by_motor_supply_phase = -motor_u_y;
    let motor_omega_dot_by_motor_pole_pairs = R::literal(1.5) * p.motor_k_r
        * motor_omega_0 / motor_x_s_times_motor_sigma * t9 * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_pole_pairs = -(motor_omega * motor_psi_ry);
    let motor_psi_ry_dot_by_motor_pole_pairs = motor_omega * motor_psi_rx;
    let motor_omega_dot_by_motor_k_s = p.motor_k_r / motor_sigma * motor_torque
        * inverse_motor_inertia;
    let motor_psi_rx_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sx;
    let motor_psi_ry_dot_by_motor_k_s = motor_alpha_r_times_motor_omega_0 * motor_psi_sy;
    let motor_omega_dot_by_motor_k_r = -(t10 * motor_omega_0
        / (p.motor_x_s * (t15 * t15))
        * (motor_psi_sx_times_motor_psi_ry - motor_psi_sy_times_motor_psi_rx)
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_rx;
    let motor_psi_sy_dot_by_motor_k_r = motor_alpha_s_times_motor_omega_0 * motor_psi_ry;
    let motor_omega_dot_by_motor_x_s = -(R::literal(1.0) / p.motor_x_s * motor_torque
        * inverse_motor_inertia);
    let motor_psi_sx_dot_by_motor_alpha_s = -(motor_omega_0 * t7);
    let motor_psi_sy_dot_by_motor_alpha_s = -(motor_omega_0 * t8);
    let motor_psi_rx_dot_by_motor_alpha_r = motor_omega_0 * t13;
    let motor_psi_ry_dot_by_motor_alpha_r = motor_omega_0 * t14;
    let cylinder_omega_dot_by_coupling_stiffness = p.coupling_ratio * coupling_twist
        * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_stiffness = -(coupling_twist
        * inverse_motor_inertia);
    let cylinder_omega_dot_by_coupling_damping = p.coupling_ratio * coupling_twist_rate
        * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_damping = (coupling_ratio_times_cylinder_omega
        - motor_omega) * inverse_motor_inertia;
    let cylinder_omega_dot_by_coupling_ratio = t4
        .add_product(p.coupling_damping, motor_omega)
        .sub_product(
            R::literal(2.0) * p.coupling_damping * p.coupling_ratio,
            cylinder_omega,
        ) * inverse_cylinder_inertia;
    let motor_omega_dot_by_coupling_ratio = p.coupling_damping * cylinder_omega
        * inverse_motor_inertia;
    let coupling_twist_dot_by_coupling_ratio = -cylinder_omega;
    let cylinder_omega_dot_by_cylinder_inertia = -(cylinder_omega_dot
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_mean = -(load_engagement * t12
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_amplitude = -(load_engagement * t1 * t12
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_speed = -(R::literal(0.328_986_813_369_645_25)
        * p.load_amplitude * time * load_engagement * t2 * t12
        * inverse_cylinder_inertia);
    let cylinder_omega_dot_by_load_phase = -(p.load_amplitude * load_engagement * t2
        * t12 * inverse_cylinder_inertia);
    let t18 = t6 * t6;
    let cylinder_omega_dot_by_load_engagement_time = inverse_load_engagement_width * t11
        * t5 * t12 / t18 * inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_engagement_width = R::literal(1.0)
        / (p.load_engagement_width * p.load_engagement_width)
        * time_minus_load_engagement_time * t11 * t5 * t12 / t18
        * inverse_cylinder_inertia;
    let cylinder_omega_dot_by_load_standstill_band = R::literal(1.0)
        / (p.load_standstill_band * p.load_standstill_band) * cylinder_omega
        * load_engagement * R::literal(1.0).sub_product(t12, t12) * t11
        * inverse_cylinder_inertia;
    [
        coupling_twist_dot_by_coupling_ratio,
        motor_omega_dot_by_motor_inertia,
        motor_omega_dot_by_motor_supply_frequency,
        motor_omega_dot_by_motor_pole_pairs,
        motor_omega_dot_by_motor_k_s,
        motor_omega_dot_by_motor_k_r,
        motor_omega_dot_by_motor_x_s,
        motor_omega_dot_by_coupling_stiffness,
        motor_omega_dot_by_coupling_damping,
        motor_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_coupling_stiffness,
        cylinder_omega_dot_by_coupling_damping,
        cylinder_omega_dot_by_coupling_ratio,
        cylinder_omega_dot_by_cylinder_inertia,
        cylinder_omega_dot_by_load_mean,
        cylinder_omega_dot_by_load_amplitude,
        cylinder_omega_dot_by_load_speed,
        cylinder_omega_dot_by_load_phase,
        cylinder_omega_dot_by_load_engagement_time,
        cylinder_omega_dot_by_load_engagement_width,
        cylinder_omega_dot_by_load_standstill_band,
        motor_psi_sx_dot_by_motor_phase_voltage,
        motor_psi_sx_dot_by_motor_supply_frequency,
        motor_psi_sx_dot_by_motor_supply_phase,
        motor_psi_sx_dot_by_motor_k_r,
        motor_psi_sx_dot_by_motor_alpha_s,
        motor_psi_sy_dot_by_motor_phase_voltage,
        motor_psi_sy_dot_by_motor_supply_frequency,
        motor_u_x,
        motor_psi_sy_dot_by_motor_k_r,
        motor_psi_sy_dot_by_motor_alpha_s,
        motor_psi_rx_dot_by_motor_supply_frequency,
        motor_psi_rx_dot_by_motor_pole_pairs,
        motor_psi_rx_dot_by_motor_k_s,
        motor_psi_rx_dot_by_motor_alpha_r,
        motor_psi_ry_dot_by_motor_supply_frequency,
        motor_psi_ry_dot_by_motor_pole_pairs,
        motor_psi_ry_dot_by_motor_k_s,
        motor_psi_ry_dot_by_motor_alpha_r,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 32 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let [_, _, cylinder_omega, ..] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p
        .load_phase
        .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time);
    let (t1, t2) = t0.sin_cos();
    let inverse_load_engagement_width = R::literal(1.0) / p.load_engagement_width;
    let t3 = (-(inverse_load_engagement_width * (time - p.load_engagement_time))).exp();
    let t4 = R::literal(1.0) + t3;
    let load_engagement = R::literal(1.0) / t4;
    let t5 = (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot_by_time = (-(inverse_load_engagement_width
        * p.load_mean.add_product(p.load_amplitude, t1) * t3 * t5 / (t4 * t4)))
        .sub_product(
            R::literal(core::f64::consts::PI) * p.load_amplitude * load_omega_2
                * load_engagement * t2,
            t5,
        ) * (R::literal(1.0) / p.cylinder_inertia);
    [
        R::literal(0.0),
        R::literal(0.0),
        cylinder_omega_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 55 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let coupling_torque = (p.coupling_stiffness * coupling_twist)
        .add_product(p.coupling_damping, coupling_twist_rate);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t0 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let load_resistance = load_engagement
        * p
            .load_mean
            .add_product(
                p.load_amplitude,
                p
                    .load_phase
                    .add_product(R::literal(core::f64::consts::PI) * load_omega_2, time)
                    .sin(),
            ) * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(p.coupling_damping * p.coupling_ratio, coupling_twist_rate)
        - load_resistance) * (R::literal(1.0) / p.cylinder_inertia);
    Outputs {
        motor_speed: motor_omega,
        cylinder_speed: cylinder_omega,
        motor_torque,
        coupling_torque,
        load_torque: load_resistance,
        twist: coupling_twist,
        cylinder_acceleration: cylinder_omega_dot,
        stator_current: (motor_i_sx * motor_i_sx)
            .add_product(motor_i_sy, motor_i_sy)
            .sqrt(),
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 39 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t0 = motor_omega_0 / (p.motor_x_s * motor_sigma);
    let motor_i_sx = t0 * motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_i_sy = t0 * motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let t1 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t1 * motor_psi_rx.sub_product(p.motor_k_s, motor_psi_sx);
    let motor_i_ry = t1 * motor_psi_ry.sub_product(p.motor_k_s, motor_psi_sy);
    Energy {
        kinetic: (R::literal(0.5) * p.motor_inertia * (motor_omega * motor_omega))
            .add_product(
                R::literal(0.5) * p.cylinder_inertia,
                cylinder_omega * cylinder_omega,
            ),
        potential: R::literal(0.5) * p.coupling_stiffness
            * (coupling_twist * coupling_twist),
        stored: R::literal(0.75)
            * (motor_psi_sx * motor_i_sx)
                .add_product(motor_psi_sy, motor_i_sy)
                .add_product(motor_psi_rx, motor_i_rx)
                .add_product(motor_psi_ry, motor_i_ry),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 152 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let [(sin_motor_supply_phase, cos_motor_supply_phase), (t0, _)] = R::sin_cos_each([
        p.motor_supply_phase,
        p.load_phase.add_product(R::literal(core::f64::consts::PI) * load_omega_2, time),
    ]);
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let motor_sigma = R::literal(1.0).sub_product(p.motor_k_s, p.motor_k_r);
    let motor_x_r = p.motor_k_s * p.motor_x_s / p.motor_k_r;
    let t1 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t1 * cos_motor_supply_phase;
    let motor_u_y = t1 * sin_motor_supply_phase;
    let coupling_twist_rate = motor_omega.sub_product(p.coupling_ratio, cylinder_omega);
    let motor_slip_speed = motor_omega_0.sub_product(p.motor_pole_pairs, motor_omega);
    let t2 = p.coupling_stiffness * coupling_twist;
    let coupling_torque = t2.add_product(p.coupling_damping, coupling_twist_rate);
    let load_engagement = R::literal(1.0)
        / (R::literal(1.0)
            + (-(R::literal(1.0) / p.load_engagement_width
                * (time - p.load_engagement_time)))
                .exp());
    let t3 = motor_psi_sx.sub_product(p.motor_k_r, motor_psi_rx);
    let motor_x_s_times_motor_sigma = p.motor_x_s * motor_sigma;
    let t4 = motor_omega_0 / motor_x_s_times_motor_sigma;
    let motor_i_sx = t4 * t3;
    let t5 = motor_psi_sy.sub_product(p.motor_k_r, motor_psi_ry);
    let motor_i_sy = t4 * t5;
    let motor_k_s_times_motor_psi_sx = p.motor_k_s * motor_psi_sx;
    let t6 = motor_omega_0 / (motor_sigma * motor_x_r);
    let motor_i_rx = t6 * (motor_psi_rx - motor_k_s_times_motor_psi_sx);
    let motor_k_s_times_motor_psi_sy = p.motor_k_s * motor_psi_sy;
    let motor_i_ry = t6 * (motor_psi_ry - motor_k_s_times_motor_psi_sy);
    let motor_torque = R::literal(1.5) * p.motor_pole_pairs * p.motor_k_r * motor_omega_0
        / motor_x_s_times_motor_sigma
        * (motor_psi_sy * motor_psi_rx).sub_product(motor_psi_sx, motor_psi_ry);
    let load_resistance = load_engagement * p.load_mean.add_product(p.load_amplitude, t0)
        * (R::literal(1.0) / p.load_standstill_band * cylinder_omega).tanh();
    let t7 = p.coupling_damping * p.coupling_ratio;
    let cylinder_omega_dot = ((p.coupling_stiffness * p.coupling_ratio * coupling_twist)
        .add_product(t7, coupling_twist_rate) - load_resistance)
        * (R::literal(1.0) / p.cylinder_inertia);
    let motor_omega_dot = (motor_torque - coupling_torque)
        * (R::literal(1.0) / p.motor_inertia);
    let motor_alpha_s_times_motor_omega_0 = p.motor_alpha_s * motor_omega_0;
    let motor_psi_sx_dot = motor_u_x
        .add_product(motor_omega_0, motor_psi_sy)
        .sub_product(motor_alpha_s_times_motor_omega_0, t3);
    let motor_psi_sy_dot = motor_u_y
        .sub_product(motor_omega_0, motor_psi_sx)
        .sub_product(motor_alpha_s_times_motor_omega_0, t5);
    let motor_alpha_r_times_motor_omega_0 = p.motor_alpha_r * motor_omega_0;
    let motor_psi_rx_dot = (motor_psi_ry * motor_slip_speed)
        .add_product(
            motor_alpha_r_times_motor_omega_0,
            motor_k_s_times_motor_psi_sx - motor_psi_rx,
        );
    let motor_psi_ry_dot = (motor_alpha_r_times_motor_omega_0
        * (motor_k_s_times_motor_psi_sy - motor_psi_ry))
        .sub_product(motor_psi_rx, motor_slip_speed);
    let t8 = p.motor_k_r * motor_omega_0 / motor_x_s_times_motor_sigma;
    PowerBalance {
        stored_rate: (t2 * coupling_twist_rate)
            .add_product(p.motor_inertia * motor_omega, motor_omega_dot)
            .add_product(p.cylinder_inertia * cylinder_omega, cylinder_omega_dot)
            .add_product(
                R::literal(0.75)
                    * motor_i_sx
                        .add_product(t4, motor_psi_sx)
                        .sub_product(t8, motor_psi_rx),
                motor_psi_sx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_sy
                        .add_product(t4, motor_psi_sy)
                        .sub_product(t8, motor_psi_ry),
                motor_psi_sy_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_rx
                        .add_product(t6, motor_psi_rx)
                        .sub_product(t8, motor_psi_sx),
                motor_psi_rx_dot,
            )
            .add_product(
                R::literal(0.75)
                    * motor_i_ry
                        .add_product(t6, motor_psi_ry)
                        .sub_product(t8, motor_psi_sy),
                motor_psi_ry_dot,
            ),
        supplied: (R::literal(1.5)
            * (motor_u_x * motor_i_sx).add_product(motor_u_y, motor_i_sy))
            .sub_product(cylinder_omega, load_resistance),
        dissipated: (p.coupling_damping * motor_omega * coupling_twist_rate)
            .add_product(
                R::literal(1.5),
                (p.motor_x_s * p.motor_alpha_s * motor_sigma
                    * (motor_i_sx * motor_i_sx).add_product(motor_i_sy, motor_i_sy))
                    .add_product(
                        p.motor_alpha_r * motor_sigma * motor_x_r,
                        (motor_i_rx * motor_i_rx).add_product(motor_i_ry, motor_i_ry),
                    ),
            )
            .sub_product(t7 * cylinder_omega, coupling_twist_rate),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 116 recurrences. 9 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [coupling_twist, motor_omega, cylinder_omega, motor_psi_sx, motor_psi_sy,
    motor_psi_rx, motor_psi_ry] = *state;
    let motor_omega_0 = R::literal(core::f64::consts::TAU) * p.motor_supply_frequency;
    let load_omega_2 = R::literal(0.104_719_755_119_659_77) * p.load_speed;
    let t0 = p.motor_k_s * p.motor_k_r;
    let motor_sigma = R::literal(1.0) - t0;
    let t1 = p.motor_supply_phase.cos();
    let t2 = p.motor_phase_voltage * R::literal(core::f64::consts::SQRT_2);
    let motor_u_x = t2 * t1;
    let t3 = p.motor_supply_phase.sin();
    let motor_u_y = t2 * t3;
    let t4 = cylinder_omega * p.coupling_ratio;
    let coupling_twist_rate = motor_omega - t4;
    let t5 = motor_omega * p.motor_pole_pairs;
    let motor_slip_speed = motor_omega_0 - t5;
    let t6 = coupling_twist * p.coupling_stiffness;
    let t7 = coupling_twist_rate * p.coupling_damping;
    let coupling_torque = t6 + t7;
    let t8 = time - p.load_engagement_time;
    let t9 = R::literal(1.0) / p.load_engagement_width;
    let t10 = t8 * t9;
    let t11 = -t10;
    let t12 = t11.exp();
    let t13 = R::literal(1.0) + t12;
    let load_engagement = R::literal(1.0) / t13;
    let t14 = motor_psi_rx * p.motor_k_r;
    let t15 = motor_psi_sx - t14;
    let t16 = p.motor_x_s * motor_sigma;
    let t17 = motor_psi_ry * p.motor_k_r;
    let t18 = motor_psi_sy - t17;
    let t19 = motor_psi_sx * p.motor_k_s;
    let t20 = motor_psi_sy * p.motor_k_s;
    let t21 = motor_psi_sx * motor_psi_ry;
    let t22 = motor_psi_sy * motor_psi_rx;
    let t23 = t22 - t21;
    let t24 = R::literal(1.5) * p.motor_pole_pairs;
    let t25 = t24 * p.motor_k_r;
    let t26 = t25 * motor_omega_0;
    let t27 = t26 / t16;
    let motor_torque = t23 * t27;
    let t28 = R::literal(core::f64::consts::PI) * load_omega_2;
    let t29 = time * t28;
    let t30 = p.load_phase + t29;
    let t31 = t30.sin();
    let t32 = t30.cos();
    let t33 = t31 * p.load_amplitude;
    let t34 = p.load_mean + t33;
    let t35 = R::literal(1.0) / p.load_standstill_band;
    let t36 = cylinder_omega * t35;
    let t37 = t36.tanh();
    let t38 = t37 * t37;
    let t39 = R::literal(1.0) - t38;
    let t40 = load_engagement * t34;
    let load_resistance = t40 * t37;
    let t41 = R::literal(1.0) / p.motor_inertia;
    let t42 = R::literal(1.0) / p.cylinder_inertia;
    let t43 = motor_torque - coupling_torque;
    let t44 = p.coupling_stiffness * p.coupling_ratio;
    let t45 = coupling_twist * t44;
    let t46 = p.coupling_damping * p.coupling_ratio;
    let t47 = coupling_twist_rate * t46;
    let t48 = t45 + t47;
    let t49 = t48 - load_resistance;
    let cylinder_omega_dot = t49 * t42;
    let motor_omega_dot = t43 * t41;
    let t50 = p.motor_alpha_s * motor_omega_0;
    let t51 = t15 * t50;
    let t52 = motor_psi_sy * motor_omega_0;
    let t53 = motor_u_x + t52;
    let motor_psi_sx_dot = t53 - t51;
    let t54 = motor_psi_sx * motor_omega_0;
    let t55 = t18 * t50;
    let t56 = motor_u_y - t54;
    let motor_psi_sy_dot = t56 - t55;
    let t57 = motor_psi_ry * motor_slip_speed;
    let t58 = t19 - motor_psi_rx;
    let t59 = p.motor_alpha_r * motor_omega_0;
    let t60 = t58 * t59;
    let motor_psi_rx_dot = t57 + t60;
    let t61 = motor_psi_rx * motor_slip_speed;
    let t62 = t20 - motor_psi_ry;
    let t63 = t62 * t59;
    let motor_psi_ry_dot = t63 - t61;
    let t10_slope = R::literal(1.0) * t9;
    let t11_slope = -t10_slope;
    let inverse_t13 = R::literal(1.0) / t13;
    let mut t12_before = t12;
    let mut t31_before = t31;
    let mut t32_before = t32;
    let mut rates = [
        coupling_twist_rate,
        motor_omega_dot,
        cylinder_omega_dot,
        motor_psi_sx_dot,
        motor_psi_sy_dot,
        motor_psi_rx_dot,
        motor_psi_ry_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [coupling_twist_k, motor_omega_k, cylinder_omega_k, motor_psi_sx_k,
        motor_psi_sy_k, motor_psi_rx_k, motor_psi_ry_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let coupling_twist_rate_k = (-cylinder_omega_k)
            .mul_add(p.coupling_ratio, motor_omega_k);
        let motor_slip_speed_k = -motor_omega_k * p.motor_pole_pairs;
        let coupling_torque_k = coupling_twist_rate_k
            .mul_add(p.coupling_damping, coupling_twist_k * p.coupling_stiffness);
        let t12_k = inverse * t11_slope * t12_before;
        let load_engagement_k = -t12_k.mul_add(load_engagement, sums_1[1]) * inverse_t13;
        let t15_k = (-motor_psi_rx_k).mul_add(p.motor_k_r, motor_psi_sx_k);
        let t18_k = (-motor_psi_ry_k).mul_add(p.motor_k_r, motor_psi_sy_k);
        let t21_k = motor_psi_sx
            .mul_add(motor_psi_ry_k, motor_psi_ry.mul_add(motor_psi_sx_k, sums[0]));
        let t22_k = motor_psi_sy
            .mul_add(motor_psi_rx_k, motor_psi_rx.mul_add(motor_psi_sy_k, sums[1]));
        let t23_k = t22_k - t21_k;
        let t31_k = inverse * t28 * t32_before;
        let t32_k = -inverse * t28 * t31_before;
        let t36_k = cylinder_omega_k * t35;
        let t37_k = t36_k.mul_add(t39, inverse * sums_1[3]);
        let t38_k = (t37 + t37).mul_add(t37_k, sums[2]);
        let t39_k = -t38_k;
        let t40_k = load_engagement
            .mul_add(
                t31_k * p.load_amplitude,
                t34.mul_add(load_engagement_k, sums_1[2]),
            );
        let load_resistance_k = t37.mul_add(t40_k, t40.mul_add(t37_k, sums_2[0]));
        let t43_k = t23_k.mul_add(t27, -coupling_torque_k);
        let t48_k = coupling_twist_rate_k.mul_add(t46, coupling_twist_k * t44);
        let t49_k = t48_k - load_resistance_k;
        let cylinder_omega_dot_k = t49_k * t42;
        let motor_omega_dot_k = t43_k * t41;
        let motor_psi_sx_dot_k = (-t15_k).mul_add(t50, motor_psi_sy_k * motor_omega_0);
        let t56_k = -motor_psi_sx_k * motor_omega_0;
        let motor_psi_sy_dot_k = (-t18_k).mul_add(t50, t56_k);
        let t57_k = motor_psi_ry
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_ry_k, sums[3]),
            );
        let t58_k = motor_psi_sx_k.mul_add(p.motor_k_s, -motor_psi_rx_k);
        let motor_psi_rx_dot_k = t58_k.mul_add(t59, t57_k);
        let t61_k = motor_psi_rx
            .mul_add(
                motor_slip_speed_k,
                motor_slip_speed.mul_add(motor_psi_rx_k, sums_1[0]),
            );
        let t62_k = motor_psi_sy_k.mul_add(p.motor_k_s, -motor_psi_ry_k);
        let motor_psi_ry_dot_k = t62_k.mul_add(t59, -t61_k);
        lanes
            .set(
                order,
                [motor_psi_sx_k, motor_psi_rx_k, t37_k, motor_slip_speed_k],
                [motor_psi_ry_k, motor_psi_sy_k, t37_k, motor_psi_ry_k],
            );
        lanes_1
            .set(
                order,
                [motor_slip_speed_k, t12_k, load_engagement_k, k * t36_k],
                [motor_psi_rx_k, load_engagement_k, t31_k * p.load_amplitude, t39_k],
            );
        lanes_2.set(order, [t37_k], [t40_k]);
        t12_before = t12_k;
        t31_before = t31_k;
        t32_before = t32_k;
        rates = [
            coupling_twist_rate_k,
            motor_omega_dot_k,
            cylinder_omega_dot_k,
            motor_psi_sx_dot_k,
            motor_psi_sy_dot_k,
            motor_psi_rx_dot_k,
            motor_psi_ry_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for SawGin {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 1>::workspace(order + 1)
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
    fn bends(&self) -> Bends {
        Bends::Saturates
    }
}

impl Describe for SawGin {
    fn name(&self) -> &'static str {
        "saw_gin"
    }
    fn title(&self) -> &'static str {
        "Saw gin: motor, coupling and saw cylinder"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 4,
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

impl<R: Real> Simulator<R> for SawGin {
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
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
    StateKind::FirstOrder,
];

static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [
    Quantity {
        name: "motor.phi",
        unit: "rad",
        doc: "rotor angle",
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
        name: "motor.omega",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "cylinder.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "motor.psi_sx",
        unit: "V s",
        doc: "stator flux linkage along x",
    },
    Quantity {
        name: "motor.psi_sy",
        unit: "V s",
        doc: "stator flux linkage along y",
    },
    Quantity {
        name: "motor.psi_rx",
        unit: "V s",
        doc: "rotor flux linkage along x",
    },
    Quantity {
        name: "motor.psi_ry",
        unit: "V s",
        doc: "rotor flux linkage along y",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 78.5, 78.5, 1.0, 1.0, 1.0, 1.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "motor.inertia",
        unit: "kg m^2",
        doc: "moment of inertia of the rotor",
    },
    Quantity {
        name: "motor.phase_voltage",
        unit: "V",
        doc: "root mean square of the phase voltage",
    },
    Quantity {
        name: "motor.supply_frequency",
        unit: "Hz",
        doc: "frequency of the supply",
    },
    Quantity {
        name: "motor.supply_phase",
        unit: "rad",
        doc: "phase of the supply at the start",
    },
    Quantity {
        name: "motor.pole_pairs",
        unit: "1",
        doc: "pairs of poles",
    },
    Quantity {
        name: "motor.k_s",
        unit: "1",
        doc: "stator coupling factor x_mu/x_s",
    },
    Quantity {
        name: "motor.k_r",
        unit: "1",
        doc: "rotor coupling factor x_mu/x_r",
    },
    Quantity {
        name: "motor.x_s",
        unit: "ohm",
        doc: "stator reactance at supply frequency",
    },
    Quantity {
        name: "motor.alpha_s",
        unit: "1",
        doc: "stator decay r_s/(sigma x_s)",
    },
    Quantity {
        name: "motor.alpha_r",
        unit: "1",
        doc: "rotor decay r_r/(sigma x_r)",
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
    Quantity {
        name: "load.mean",
        unit: "N m",
        doc: "mean torque",
    },
    Quantity {
        name: "load.amplitude",
        unit: "N m",
        doc: "amplitude of the harmonic part",
    },
    Quantity {
        name: "load.speed",
        unit: "1",
        doc: "nominal speed in revolutions per minute, a count as the study gives it",
    },
    Quantity {
        name: "load.phase",
        unit: "rad",
        doc: "phase of the harmonic part",
    },
    Quantity {
        name: "load.engagement_time",
        unit: "s",
        doc: "time at which half of the load acts",
    },
    Quantity {
        name: "load.engagement_width",
        unit: "s",
        doc: "time constant of engagement",
    },
    Quantity {
        name: "load.standstill_band",
        unit: "rad/s",
        doc: "speed below which the load fades out",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    4.2,
    220.0,
    50.0,
    0.0,
    4.0,
    0.956,
    0.952,
    4.14,
    0.115,
    0.0858,
    23065.2,
    128.5346,
    1.0,
    1.244,
    843.72,
    78.78,
    735.0,
    0.0,
    1.2,
    0.02,
    0.5,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "motor_speed",
        unit: "rad/s",
        doc: "rate of rotor angle",
    },
    Quantity {
        name: "cylinder_speed",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "motor_torque",
        unit: "N m",
        doc: "electromagnetic torque",
    },
    Quantity {
        name: "coupling_torque",
        unit: "N m",
        doc: "torque carried, on the driving side",
    },
    Quantity {
        name: "load_torque",
        unit: "N m",
        doc: "resisting torque",
    },
    Quantity {
        name: "twist",
        unit: "rad",
        doc: "twist",
    },
    Quantity {
        name: "cylinder_acceleration",
        unit: "rad/s^2",
        doc: "rate of rate of angle",
    },
    Quantity {
        name: "stator_current",
        unit: "A",
        doc: "amplitude of the stator current",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 2001,
    rtol: 1e-8,
    method: "tsit45",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5aa30d4253a9899d4f39237de04cfe3095f1ceeaee0ffeccd40e4148beadb747  scenes/slider_crank.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//
// Slider-crank turned at constant speed
//
// Crank, rod and slider as three bodies in a plane, held together by pins, a guide and a
// drive that turns the crank. The force of the drive's constraint is the torque it takes.
//
// Source:
//   Textbook.
//
// Shapes; all quantities are in SI units:
//   coordinates               8
//   first-order states        0
//   states                   16
//   parameters               12
//   outputs                   7
//   discontinuities           0
//   constraints               8
//
// State:
//     0  crank.x      [m]      centre of mass, sideways
//     1  crank.y      [m]      centre of mass, upwards
//     2  crank.phi    [rad]    angle of the bar from sideways
//     3  rod.x        [m]      centre of mass, sideways
//     4  rod.y        [m]      centre of mass, upwards
//     5  rod.phi      [rad]    angle of the bar from sideways
//     6  slider.x     [m]      centre of mass, sideways
//     7  slider.y     [m]      centre of mass, upwards
//     8  crank.v_x    [m/s]    rate of centre of mass, sideways
//     9  crank.v_y    [m/s]    rate of centre of mass, upwards
//    10  crank.omega  [rad/s]  rate of angle of the bar from sideways
//    11  rod.v_x      [m/s]    rate of centre of mass, sideways
//    12  rod.v_y      [m/s]    rate of centre of mass, upwards
//    13  rod.omega    [rad/s]  rate of angle of the bar from sideways
//    14  slider.v_x   [m/s]    rate of centre of mass, sideways
//    15  slider.v_y   [m/s]    rate of centre of mass, upwards
//
// Nonzeros:
//   mass_matrix               8 of 8 by 8
//   rate_jacobian            28 of 16 by 16
//   parameter_jacobian       10 of 16 by 12
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     63
//   mass_matrix               0
//   forcing                   6
//   rate_jacobian           133
//   parameter_jacobian       94
//   time_derivative           0
//   outputs                 101
//   energy                   33
//   power_balance           124
//   constraint_values        25
//   constraint_rates         25
//   constraint_matrix        12
// With constants of the parameters, prepared once a run:
//   prepare                   5
//   prepared_rate            58
//   prepared_rate_jacobian  128

use ::machinist_contract::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern,
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 8;

/// Length of the state y.
pub const STATES: usize = 16;

/// Parameters.
pub const PARAMETERS: usize = 12;

/// Wanted outputs.
pub const OUTPUTS: usize = 7;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 16,
    entries: &[
        (0, 8), (1, 9), (2, 10), (3, 11), (4, 12), (5, 13), (6, 14), (7, 15), (8, 2), (8, 10),
        (9, 2), (9, 10), (11, 2), (11, 5), (11, 10), (11, 13), (12, 2), (12, 5), (12, 10), (12, 13),
        (13, 2), (13, 5), (13, 10), (13, 13), (14, 2), (14, 5), (14, 10), (14, 13),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 12,
    entries: &[
        (8, 2), (9, 2), (11, 2), (11, 6), (12, 2), (12, 6), (13, 2), (13, 6), (14, 2), (14, 6),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 8;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[
        (0, 0), (0, 2), (1, 1), (1, 2), (2, 0), (2, 2), (2, 3), (2, 5), (3, 1), (3, 2), (3, 4),
        (3, 5), (4, 3), (4, 5), (4, 6), (5, 4), (5, 5), (5, 7), (6, 7), (7, 2),
    ],
};

/// Slider-crank turned at constant speed
///
/// Crank, rod and slider as three bodies in a plane, held together by pins, a guide and a
/// drive that turns the crank. The force of the drive's constraint is the torque it takes.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SliderCrank;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// speed: speed of the crank \[rad/s\]. In the spec: 30.0.
    pub speed: R,
    /// start: angle of the crank at the start \[rad\]. In the spec: 0.4.
    pub start: R,
    /// crank.length: length of the bar \[m\]. In the spec: 0.05.
    pub crank_length: R,
    /// crank.mass: the mass \[kg\]. In the spec: 0.8.
    pub crank_mass: R,
    /// crank.inertia: moment of inertia about the centre of mass \[kg m^2\]. In the spec: 0.0002.
    pub crank_inertia: R,
    /// crank.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub crank_gravity: R,
    /// rod.length: length of the bar \[m\]. In the spec: 0.2.
    pub rod_length: R,
    /// rod.mass: the mass \[kg\]. In the spec: 0.6.
    pub rod_mass: R,
    /// rod.inertia: moment of inertia about the centre of mass \[kg m^2\]. In the spec: 0.002.
    pub rod_inertia: R,
    /// rod.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub rod_gravity: R,
    /// slider.mass: the mass \[kg\]. In the spec: 1.1.
    pub slider_mass: R,
    /// slider.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub slider_gravity: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            speed: values[0],
            start: values[1],
            crank_length: values[2],
            crank_mass: values[3],
            crank_inertia: values[4],
            crank_gravity: values[5],
            rod_length: values[6],
            rod_mass: values[7],
            rod_inertia: values[8],
            rod_gravity: values[9],
            slider_mass: values[10],
            slider_gravity: values[11],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.speed,
            self.start,
            self.crank_length,
            self.crank_mass,
            self.crank_inertia,
            self.crank_gravity,
            self.rod_length,
            self.rod_mass,
            self.rod_inertia,
            self.rod_gravity,
            self.slider_mass,
            self.slider_gravity,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            speed: R::literal(30.0),
            start: R::literal(0.4),
            crank_length: R::literal(0.05),
            crank_mass: R::literal(0.8),
            crank_inertia: R::literal(0.0002),
            crank_gravity: R::literal(9.81),
            rod_length: R::literal(0.2),
            rod_mass: R::literal(0.6),
            rod_inertia: R::literal(0.002),
            rod_gravity: R::literal(9.81),
            slider_mass: R::literal(1.1),
            slider_gravity: R::literal(9.81),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// angle: angle of the bar from sideways \[rad\].
    pub angle: R,
    /// rod_angle: angle of the bar from sideways \[rad\].
    pub rod_angle: R,
    /// stroke: centre of mass, sideways \[m\].
    pub stroke: R,
    /// slider_speed: rate of centre of mass, sideways \[m/s\].
    pub slider_speed: R,
    /// slider_acceleration: acceleration of the slider \[m/s^2\].
    pub slider_acceleration: R,
    /// torque: torque of the drive on the crank \[N m\].
    pub torque: R,
    /// guide_force: force of the guide on the slider, upwards \[N\].
    pub guide_force: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            angle: values[0],
            rod_angle: values[1],
            stroke: values[2],
            slider_speed: values[3],
            slider_acceleration: values[4],
            torque: values[5],
            guide_force: values[6],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.angle,
            self.rod_angle,
            self.stroke,
            self.slider_speed,
            self.slider_acceleration,
            self.torque,
            self.guide_force,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// crank.x: centre of mass, sideways \[m\].
    pub const CRANK_X: usize = 0;
    /// crank.y: centre of mass, upwards \[m\].
    pub const CRANK_Y: usize = 1;
    /// crank.phi: angle of the bar from sideways \[rad\].
    pub const CRANK_PHI: usize = 2;
    /// rod.x: centre of mass, sideways \[m\].
    pub const ROD_X: usize = 3;
    /// rod.y: centre of mass, upwards \[m\].
    pub const ROD_Y: usize = 4;
    /// rod.phi: angle of the bar from sideways \[rad\].
    pub const ROD_PHI: usize = 5;
    /// slider.x: centre of mass, sideways \[m\].
    pub const SLIDER_X: usize = 6;
    /// slider.y: centre of mass, upwards \[m\].
    pub const SLIDER_Y: usize = 7;
    /// crank.v_x: rate of centre of mass, sideways \[m/s\].
    pub const CRANK_V_X: usize = 8;
    /// crank.v_y: rate of centre of mass, upwards \[m/s\].
    pub const CRANK_V_Y: usize = 9;
    /// crank.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const CRANK_OMEGA: usize = 10;
    /// rod.v_x: rate of centre of mass, sideways \[m/s\].
    pub const ROD_V_X: usize = 11;
    /// rod.v_y: rate of centre of mass, upwards \[m/s\].
    pub const ROD_V_Y: usize = 12;
    /// rod.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const ROD_OMEGA: usize = 13;
    /// slider.v_x: rate of centre of mass, sideways \[m/s\].
    pub const SLIDER_V_X: usize = 14;
    /// slider.v_y: rate of centre of mass, upwards \[m/s\].
    pub const SLIDER_V_Y: usize = 15;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 5;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub t1: R,
    pub inverse_rod_mass: R,
    pub minus_inverse_rod_mass: R,
    pub inverse_rod_inertia: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            t1: values[1],
            inverse_rod_mass: values[2],
            minus_inverse_rod_mass: values[3],
            inverse_rod_inertia: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.t1,
            self.inverse_rod_mass,
            self.minus_inverse_rod_mass,
            self.inverse_rod_inertia,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 5 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = R::literal(0.5) * p.rod_length;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let minus_inverse_rod_mass = -inverse_rod_mass;
    let inverse_rod_inertia = R::literal(1.0) / p.rod_inertia;
    Constants {
        t0,
        t1,
        inverse_rod_mass,
        minus_inverse_rod_mass,
        inverse_rod_inertia,
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
        R::literal(0.15),
        R::literal(0.0),
        R::literal(-0.1),
        R::literal(0.24),
        R::literal(0.0),
        R::literal(0.0),
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

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda` with `g'' = 0`, `h`; in the units of the states per second.
///
/// 63 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 58 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega,
    rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = c.t1 * cos_rod_phi;
    let t1 = t0 * c.inverse_rod_inertia;
    let t2 = t1 * t0;
    let t3 = c.minus_inverse_rod_mass - t2;
    let t4 = R::literal(1.0) / t3;
    let t5 = c.inverse_rod_mass - t2;
    let t6 = t5 * t4;
    let crank_omega_squared = crank_omega * crank_omega;
    let t7 = c.t0 * crank_omega_squared;
    let t8 = t7 * cos_crank_phi;
    let crank_v_x_dot = -t8;
    let t9 = t7 * sin_crank_phi;
    let crank_v_y_dot = -t9;
    let t10 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t11 = c.t1 * rod_omega_squared;
    let t12 = (-t9)
        .sub_product(
            R::literal(0.5),
            (t10 * sin_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, sin_rod_phi),
        );
    let t13 = (-(t11 * sin_rod_phi)).sub_product(t6, t12)
        * (R::literal(1.0) / t3.sub_product(t6, t5));
    let t14 = (t12 * t4).sub_product(t6, t13);
    let rod_omega_dot = (t1 * t13).add_product(t1, t14);
    let rod_v_y_dot = (c.inverse_rod_mass * t13).sub_product(c.inverse_rod_mass, t14);
    let t15 = (-t8)
        .sub_product(
            R::literal(0.5),
            (t10 * cos_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, cos_rod_phi),
        );
    let t16 = c.t1 * sin_rod_phi * rod_omega_dot;
    let rod_v_x_dot = t15 - t16;
    let slider_v_x_dot = (-t16).sub_product(t11, cos_rod_phi) - (t16 - t15);
    [
        crank_v_x,
        crank_v_y,
        crank_omega,
        rod_v_x,
        rod_v_y,
        rod_omega,
        slider_v_x,
        slider_v_y,
        crank_v_x_dot,
        crank_v_y_dot,
        R::literal(0.0),
        rod_v_x_dot,
        rod_v_y_dot,
        rod_omega_dot,
        slider_v_x_dot,
        R::literal(0.0),
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
) -> [R; 8] {
    [
        p.crank_mass,
        p.crank_mass,
        p.crank_inertia,
        p.rod_mass,
        p.rod_mass,
        p.rod_inertia,
        p.slider_mass,
        p.slider_mass,
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 6 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let crank_y_forcing = -(p.crank_mass * p.crank_gravity);
    let rod_y_forcing = -(p.rod_mass * p.rod_gravity);
    let slider_y_forcing = -(p.slider_mass * p.slider_gravity);
    [
        R::literal(0.0),
        crank_y_forcing,
        R::literal(0.0),
        R::literal(0.0),
        rod_y_forcing,
        R::literal(0.0),
        R::literal(0.0),
        slider_y_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 133 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 28] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 128 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 28] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = c.t1 * cos_rod_phi;
    let t1 = c.t1 * sin_rod_phi;
    let t2 = t0 * c.inverse_rod_inertia;
    let t3 = t2 * t0;
    let t4 = c.minus_inverse_rod_mass - t3;
    let t5 = R::literal(1.0) / t4;
    let t6 = c.inverse_rod_mass - t3;
    let t7 = t6 * t5;
    let t8 = R::literal(1.0) / t4.sub_product(t7, t6);
    let crank_omega_squared = crank_omega * crank_omega;
    let t9 = c.t0 * crank_omega_squared;
    let t10 = t9 * cos_crank_phi;
    let crank_v_x_dot = -t10;
    let crank_v_x_dot_by_crank_phi = t9 * sin_crank_phi;
    let rod_omega_squared = rod_omega * rod_omega;
    let t11 = c.t1 * rod_omega_squared;
    let t12 = t11 * sin_rod_phi;
    let t13 = (-crank_v_x_dot_by_crank_phi)
        .sub_product(
            R::literal(0.5),
            (p.crank_length * crank_omega_squared * sin_crank_phi)
                .add_product(p.rod_length * rod_omega_squared, sin_rod_phi),
        );
    let t14 = (-t12).sub_product(t7, t13) * t8;
    let rod_omega_dot = (t2 * t14).add_product(t2, (t13 * t5).sub_product(t7, t14));
    let t15 = (-(t11 * cos_rod_phi)).sub_product(t1, rod_omega_dot);
    let t16 = crank_v_x_dot - t10;
    let t17 = t7 * t16 * t8;
    let t18 = (t16 * t5).add_product(t7, t17);
    let rod_omega_dot_by_crank_phi = (-(t2 * t17)).add_product(t2, t18);
    let rod_v_y_dot_by_crank_phi = (-(c.inverse_rod_mass * t17))
        .sub_product(c.inverse_rod_mass, t18);
    let t19 = crank_v_x_dot_by_crank_phi + crank_v_x_dot_by_crank_phi;
    let t20 = t1 * rod_omega_dot_by_crank_phi;
    let rod_v_x_dot_by_crank_phi = t19 - t20;
    let slider_v_x_dot_by_crank_phi = -(t20 - t19 + t20);
    let t21 = t12.sub_product(t0, rod_omega_dot);
    let t22 = t15.sub_product(t7, t15) * t8;
    let t23 = (t15 * t5).sub_product(t7, t22);
    let rod_omega_dot_by_rod_phi = (t2 * t22).add_product(t2, t23);
    let rod_v_y_dot_by_rod_phi = (c.inverse_rod_mass * t22)
        .sub_product(c.inverse_rod_mass, t23);
    let t24 = t1 * rod_omega_dot_by_rod_phi;
    let rod_v_x_dot_by_rod_phi = t21 - t24;
    let slider_v_x_dot_by_rod_phi = rod_v_x_dot_by_rod_phi - (t24 - t21);
    let crank_length_times_crank_omega = p.crank_length * crank_omega;
    let t25 = crank_length_times_crank_omega * cos_crank_phi;
    let crank_v_x_dot_by_crank_omega = -t25;
    let t26 = crank_length_times_crank_omega * sin_crank_phi;
    let crank_v_y_dot_by_crank_omega = -t26;
    let t27 = crank_v_y_dot_by_crank_omega - t26;
    let t28 = t7 * t27 * t8;
    let t29 = (t27 * t5).add_product(t7, t28);
    let rod_omega_dot_by_crank_omega = (-(t2 * t28)).add_product(t2, t29);
    let rod_v_y_dot_by_crank_omega = (-(c.inverse_rod_mass * t28))
        .sub_product(c.inverse_rod_mass, t29);
    let t30 = crank_v_x_dot_by_crank_omega - t25;
    let t31 = t1 * rod_omega_dot_by_crank_omega;
    let rod_v_x_dot_by_crank_omega = t30 - t31;
    let slider_v_x_dot_by_crank_omega = -(t31 - t30 + t31);
    let rod_length_times_rod_omega = p.rod_length * rod_omega;
    let t32 = rod_length_times_rod_omega * cos_rod_phi;
    let t33 = rod_length_times_rod_omega * sin_rod_phi;
    let t34 = (-t33).add_product(t7, t33) * t8;
    let t35 = (-(t33 * t5)).sub_product(t7, t34);
    let rod_omega_dot_by_rod_omega = (t2 * t34).add_product(t2, t35);
    let rod_v_y_dot_by_rod_omega = (c.inverse_rod_mass * t34)
        .sub_product(c.inverse_rod_mass, t35);
    let t36 = t1 * rod_omega_dot_by_rod_omega;
    let t37 = t36 + t32;
    let rod_v_x_dot_by_rod_omega = -t37;
    let slider_v_x_dot_by_rod_omega = -t32 - t36 - t37;
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        crank_v_x_dot_by_crank_phi,
        crank_v_x_dot_by_crank_omega,
        crank_v_x_dot,
        crank_v_y_dot_by_crank_omega,
        rod_v_x_dot_by_crank_phi,
        rod_v_x_dot_by_rod_phi,
        rod_v_x_dot_by_crank_omega,
        rod_v_x_dot_by_rod_omega,
        rod_v_y_dot_by_crank_phi,
        rod_v_y_dot_by_rod_phi,
        rod_v_y_dot_by_crank_omega,
        rod_v_y_dot_by_rod_omega,
        rod_omega_dot_by_crank_phi,
        rod_omega_dot_by_rod_phi,
        rod_omega_dot_by_crank_omega,
        rod_omega_dot_by_rod_omega,
        slider_v_x_dot_by_crank_phi,
        slider_v_x_dot_by_rod_phi,
        slider_v_x_dot_by_crank_omega,
        slider_v_x_dot_by_rod_omega,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 94 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 10] {
    let crank_phi = state[2];
    let rod_phi = state[5];
    let crank_omega = state[10];
    let rod_omega = state[13];
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.rod_length;
    let t1 = t0 * cos_rod_phi;
    let t2 = t0 * sin_rod_phi;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let t3 = t1 * (R::literal(1.0) / p.rod_inertia);
    let t4 = t3 * t1;
    let t5 = -inverse_rod_mass - t4;
    let t6 = R::literal(1.0) / t5;
    let t7 = inverse_rod_mass - t4;
    let t8 = t7 * t6;
    let t9 = R::literal(1.0) / t5.sub_product(t8, t7);
    let crank_omega_squared = crank_omega * crank_omega;
    let rod_omega_squared = rod_omega * rod_omega;
    let t10 = (-(R::literal(0.5) * p.crank_length * crank_omega_squared * sin_crank_phi))
        .sub_product(
            R::literal(0.5),
            (p.crank_length * crank_omega_squared * sin_crank_phi)
                .add_product(p.rod_length * rod_omega_squared, sin_rod_phi),
        );
    let t11 = (-(t0 * rod_omega_squared * sin_rod_phi)).sub_product(t8, t10) * t9;
    let rod_omega_dot = (t3 * t11).add_product(t3, (t10 * t6).sub_product(t8, t11));
    let t12 = R::literal(0.5) * crank_omega_squared;
    let t13 = t12 * cos_crank_phi;
    let crank_v_x_dot_by_crank_length = -t13;
    let t14 = t12 * sin_crank_phi;
    let crank_v_y_dot_by_crank_length = -t14;
    let t15 = crank_v_y_dot_by_crank_length - t14;
    let t16 = t8 * t15 * t9;
    let t17 = (t15 * t6).add_product(t8, t16);
    let rod_omega_dot_by_crank_length = (-(t3 * t16)).add_product(t3, t17);
    let rod_v_y_dot_by_crank_length = (-(inverse_rod_mass * t16))
        .sub_product(inverse_rod_mass, t17);
    let t18 = crank_v_x_dot_by_crank_length - t13;
    let t19 = t2 * rod_omega_dot_by_crank_length;
    let rod_v_x_dot_by_crank_length = t18 - t19;
    let slider_v_x_dot_by_crank_length = -(t19 - t18 + t19);
    let t20 = R::literal(0.5) * rod_omega_squared;
    let t21 = (-(t20 * cos_rod_phi))
        .sub_product(R::literal(0.5) * sin_rod_phi, rod_omega_dot);
    let t22 = (-(t20 * sin_rod_phi))
        .add_product(R::literal(0.5) * cos_rod_phi, rod_omega_dot);
    let t23 = t22.sub_product(t8, t22) * t9;
    let t24 = (t22 * t6).sub_product(t8, t23);
    let rod_omega_dot_by_rod_length = (t3 * t23).add_product(t3, t24);
    let rod_v_y_dot_by_rod_length = (inverse_rod_mass * t23)
        .sub_product(inverse_rod_mass, t24);
    let t25 = t2 * rod_omega_dot_by_rod_length;
    let rod_v_x_dot_by_rod_length = t21 - t25;
    let slider_v_x_dot_by_rod_length = rod_v_x_dot_by_rod_length - (t25 - t21);
    [
        crank_v_x_dot_by_crank_length,
        crank_v_y_dot_by_crank_length,
        rod_v_x_dot_by_crank_length,
        rod_v_x_dot_by_rod_length,
        rod_v_y_dot_by_crank_length,
        rod_v_y_dot_by_rod_length,
        rod_omega_dot_by_crank_length,
        rod_omega_dot_by_rod_length,
        slider_v_x_dot_by_crank_length,
        slider_v_x_dot_by_rod_length,
    ]
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
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 101 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, crank_phi, _, _, rod_phi, slider_x, _, _, _, crank_omega, _, _, rod_omega,
    slider_v_x, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let t5 = t3 * sin_rod_phi;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let t6 = t4 * (R::literal(1.0) / p.rod_inertia);
    let t7 = t6 * t4;
    let t8 = -inverse_rod_mass - t7;
    let t9 = R::literal(1.0) / t8;
    let t10 = inverse_rod_mass - t7;
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / t8.sub_product(t11, t10);
    let crank_omega_squared = crank_omega * crank_omega;
    let t13 = t0 * crank_omega_squared;
    let t14 = t13 * cos_crank_phi;
    let t15 = t13 * sin_crank_phi;
    let t16 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t17 = t3 * rod_omega_squared;
    let t18 = (-t15)
        .sub_product(
            R::literal(0.5),
            (t16 * sin_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, sin_rod_phi),
        );
    let t19 = (-(t17 * sin_rod_phi)).sub_product(t11, t18) * t12;
    let t20 = (t18 * t9).sub_product(t11, t19);
    let rod_omega_dot = (t6 * t19).add_product(t6, t20);
    let rod_v_y_dot = (inverse_rod_mass * t19).sub_product(inverse_rod_mass, t20);
    let t21 = (-t14)
        .sub_product(
            R::literal(0.5),
            (t16 * cos_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, cos_rod_phi),
        );
    let t22 = t5 * rod_omega_dot;
    let rod_v_x_dot = t21 - t22;
    let slider_v_x_dot = (-t22).sub_product(t17, cos_rod_phi) - (t22 - t21);
    let pin_b_x = p.slider_mass * slider_v_x_dot;
    let pin_a_x = pin_b_x.add_product(p.rod_mass, rod_v_x_dot);
    let t23 = inverse_rod_mass
        * (-(p.rod_mass * p.rod_gravity)).sub_product(p.rod_mass, rod_v_y_dot);
    let t24 = t6
        * (-(p.rod_inertia * rod_omega_dot))
            .add_product(t5, pin_b_x)
            .add_product(t5, pin_a_x);
    let t25 = t24 - t23;
    let t26 = t25 * t9;
    let t27 = (t23 + t24).sub_product(t11, t25) * t12;
    let t28 = t11 * t27;
    let guide = t27.add_product(p.slider_mass, p.slider_gravity);
    let pin_a_y = t28 - t26;
    let drive = (-(t2 * pin_a_x)
        .add_product(t1, t26 - t28)
        .add_product(
            t1,
            (-(p.crank_mass * p.crank_gravity)).add_product(p.crank_mass, t15) - pin_a_y,
        ))
        .add_product(t2, (-pin_a_x).add_product(p.crank_mass, t14));
    Outputs {
        angle: crank_phi,
        rod_angle: rod_phi,
        stroke: slider_x,
        slider_speed: slider_v_x,
        slider_acceleration: slider_v_x_dot,
        torque: drive,
        guide_force: guide,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 33 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, crank_y, _, _, rod_y, _, _, slider_y, crank_v_x, crank_v_y, crank_omega,
    rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.crank_inertia * (crank_omega * crank_omega))
            .add_product(
                R::literal(0.5) * p.crank_mass,
                (crank_v_x * crank_v_x).add_product(crank_v_y, crank_v_y),
            )
            .add_product(
                R::literal(0.5) * p.rod_mass,
                (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y),
            )
            .add_product(R::literal(0.5) * p.rod_inertia, rod_omega * rod_omega)
            .add_product(
                R::literal(0.5) * p.slider_mass,
                (slider_v_x * slider_v_x).add_product(slider_v_y, slider_v_y),
            ),
        potential: (p.crank_mass * p.crank_gravity * crank_y)
            .add_product(p.rod_mass * p.rod_gravity, rod_y)
            .add_product(p.slider_mass * p.slider_gravity, slider_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 124 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega,
    rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let t2 = t0 * sin_crank_phi;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let t5 = t3 * sin_rod_phi;
    let inverse_rod_mass = R::literal(1.0) / p.rod_mass;
    let t6 = t4 * (R::literal(1.0) / p.rod_inertia);
    let t7 = t6 * t4;
    let t8 = -inverse_rod_mass - t7;
    let t9 = R::literal(1.0) / t8;
    let t10 = inverse_rod_mass - t7;
    let t11 = t10 * t9;
    let t12 = R::literal(1.0) / t8.sub_product(t11, t10);
    let crank_mass_times_crank_gravity = p.crank_mass * p.crank_gravity;
    let rod_mass_times_rod_gravity = p.rod_mass * p.rod_gravity;
    let crank_omega_squared = crank_omega * crank_omega;
    let t13 = t0 * crank_omega_squared;
    let t14 = t13 * cos_crank_phi;
    let t15 = t13 * sin_crank_phi;
    let t16 = p.crank_length * crank_omega_squared;
    let rod_omega_squared = rod_omega * rod_omega;
    let rod_length_times_rod_omega_squared = p.rod_length * rod_omega_squared;
    let t17 = t3 * rod_omega_squared;
    let t18 = (-t15)
        .sub_product(
            R::literal(0.5),
            (t16 * sin_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, sin_rod_phi),
        );
    let t19 = (-(t17 * sin_rod_phi)).sub_product(t11, t18) * t12;
    let t20 = (t18 * t9).sub_product(t11, t19);
    let rod_omega_dot = (t6 * t19).add_product(t6, t20);
    let rod_v_y_dot = (inverse_rod_mass * t19).sub_product(inverse_rod_mass, t20);
    let t21 = (-t14)
        .sub_product(
            R::literal(0.5),
            (t16 * cos_crank_phi)
                .add_product(rod_length_times_rod_omega_squared, cos_rod_phi),
        );
    let t22 = t5 * rod_omega_dot;
    let rod_v_x_dot = t21 - t22;
    let slider_v_x_dot = (-t22).sub_product(t17, cos_rod_phi) - (t22 - t21);
    let pin_b_x = p.slider_mass * slider_v_x_dot;
    let pin_a_x = pin_b_x.add_product(p.rod_mass, rod_v_x_dot);
    let t23 = inverse_rod_mass
        * (-rod_mass_times_rod_gravity).sub_product(p.rod_mass, rod_v_y_dot);
    let t24 = t6
        * (-(p.rod_inertia * rod_omega_dot))
            .add_product(t5, pin_b_x)
            .add_product(t5, pin_a_x);
    let t25 = t24 - t23;
    let t26 = t25 * t9;
    let t27 = t11 * ((t23 + t24).sub_product(t11, t25) * t12);
    let pin_a_y = t27 - t26;
    let drive = (-(t2 * pin_a_x)
        .add_product(t1, t26 - t27)
        .add_product(
            t1,
            (-crank_mass_times_crank_gravity).add_product(p.crank_mass, t15) - pin_a_y,
        ))
        .add_product(t2, (-pin_a_x).add_product(p.crank_mass, t14));
    PowerBalance {
        stored_rate: (crank_mass_times_crank_gravity * crank_v_y)
            .add_product(rod_mass_times_rod_gravity, rod_v_y)
            .add_product(p.slider_mass * p.slider_gravity, slider_v_y)
            .sub_product(p.crank_mass * crank_v_x, t14)
            .sub_product(p.crank_mass * crank_v_y, t15)
            .add_product(p.rod_mass * rod_v_x, rod_v_x_dot)
            .add_product(p.rod_mass * rod_v_y, rod_v_y_dot)
            .add_product(p.rod_inertia * rod_omega, rod_omega_dot)
            .add_product(p.slider_mass * slider_v_x, slider_v_x_dot),
        supplied: p.speed * drive,
        dissipated: R::literal(0.0),
    }
}

/// `g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.
///
/// 25 operations.
#[must_use]
pub fn constraint_values<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [crank_x, crank_y, crank_phi, rod_x, rod_y, rod_phi, slider_x, slider_y, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * cos_crank_phi;
    let crank_start_x = crank_x - t1;
    let t2 = t0 * sin_crank_phi;
    let crank_start_y = crank_y - t2;
    let crank_end_x = crank_x + t1;
    let crank_end_y = crank_y + t2;
    let t3 = R::literal(0.5) * p.rod_length;
    let t4 = t3 * cos_rod_phi;
    let rod_start_x = rod_x - t4;
    let t5 = t3 * sin_rod_phi;
    let rod_start_y = rod_y - t5;
    let rod_end_x = rod_x + t4;
    let rod_end_y = rod_y + t5;
    let pin_a_x_value = rod_start_x - crank_end_x;
    let pin_a_y_value = rod_start_y - crank_end_y;
    let pin_b_x_value = slider_x - rod_end_x;
    let pin_b_y_value = slider_y - rod_end_y;
    let drive_value = (crank_phi - p.start).sub_product(p.speed, time);
    [
        crank_start_x,
        crank_start_y,
        pin_a_x_value,
        pin_a_y_value,
        pin_b_x_value,
        pin_b_y_value,
        slider_y,
        drive_value,
    ]
}

/// `g'`, zero on the constraints too.
///
/// 25 operations.
#[must_use]
pub fn constraint_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [_, _, crank_phi, _, _, rod_phi, _, _, crank_v_x, crank_v_y, crank_omega,
    rod_v_x, rod_v_y, rod_omega, slider_v_x, slider_v_y] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length * crank_omega;
    let t1 = t0 * sin_crank_phi;
    let pin_o_x_rate = crank_v_x + t1;
    let t2 = t0 * cos_crank_phi;
    let pin_o_y_rate = crank_v_y - t2;
    let t3 = R::literal(0.5) * p.rod_length * rod_omega;
    let t4 = t3 * sin_rod_phi;
    let pin_a_x_rate = rod_v_x + t1 + t4 - crank_v_x;
    let t5 = t3 * cos_rod_phi;
    let pin_a_y_rate = rod_v_y - crank_v_y - t2 - t5;
    let pin_b_x_rate = slider_v_x + t4 - rod_v_x;
    let pin_b_y_rate = slider_v_y - rod_v_y - t5;
    let drive_rate = crank_omega - p.speed;
    [
        pin_o_x_rate,
        pin_o_y_rate,
        pin_a_x_rate,
        pin_a_y_rate,
        pin_b_x_rate,
        pin_b_y_rate,
        slider_v_y,
        drive_rate,
    ]
}

/// `G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.
///
/// 12 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 20] {
    let [_, _, crank_phi, _, _, rod_phi, ..] = *state;
    let [(sin_crank_phi, cos_crank_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        crank_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.5) * p.crank_length;
    let t1 = t0 * sin_crank_phi;
    let t2 = R::literal(0.5) * p.rod_length;
    let t3 = t2 * sin_rod_phi;
    let t4 = -(t0 * cos_crank_phi);
    let t5 = -(t2 * cos_rod_phi);
    [
        R::literal(1.0),
        t1,
        R::literal(1.0),
        t4,
        R::literal(-1.0),
        t1,
        R::literal(1.0),
        t3,
        R::literal(-1.0),
        t4,
        R::literal(1.0),
        t5,
        R::literal(-1.0),
        t3,
        R::literal(1.0),
        R::literal(-1.0),
        t5,
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
    ]
}

impl Describe for SliderCrank {
    fn name(&self) -> &'static str {
        "slider_crank"
    }
    fn title(&self) -> &'static str {
        "Slider-crank turned at constant speed"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 8,
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
    fn constraints(&self) -> usize {
        CONSTRAINTS
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        CONSTRAINT_SHAPES[index]
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        CONSTRAINT_MATRIX_PATTERN
    }
    fn is_given(&self, _index: usize) -> bool {
        false
    }
}

impl<R: Real> Simulator<R> for SliderCrank {
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
    fn constraint_values(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_values(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_rates(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_matrix(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
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

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "crank.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "crank.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "crank.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "rod.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "rod.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "rod.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "slider.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "slider.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "crank.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "crank.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "crank.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "rod.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "rod.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "rod.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "slider.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "slider.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
];

static STATE_SCALES: [f64; STATES] = [
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "speed",
        unit: "rad/s",
        doc: "speed of the crank",
    },
    Quantity {
        name: "start",
        unit: "rad",
        doc: "angle of the crank at the start",
    },
    Quantity {
        name: "crank.length",
        unit: "m",
        doc: "length of the bar",
    },
    Quantity {
        name: "crank.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "crank.inertia",
        unit: "kg m^2",
        doc: "moment of inertia about the centre of mass",
    },
    Quantity {
        name: "crank.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "rod.length",
        unit: "m",
        doc: "length of the bar",
    },
    Quantity {
        name: "rod.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "rod.inertia",
        unit: "kg m^2",
        doc: "moment of inertia about the centre of mass",
    },
    Quantity {
        name: "rod.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "slider.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "slider.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    30.0,
    0.4,
    0.05,
    0.8,
    0.0002,
    9.81,
    0.2,
    0.6,
    0.002,
    9.81,
    1.1,
    9.81,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "rod_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "stroke",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "slider_speed",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "slider_acceleration",
        unit: "m/s^2",
        doc: "acceleration of the slider",
    },
    Quantity {
        name: "torque",
        unit: "N m",
        doc: "torque of the drive on the crank",
    },
    Quantity {
        name: "guide_force",
        unit: "N",
        doc: "force of the guide on the slider, upwards",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 1.0,
    points: 1001,
    rtol: 1e-8,
    method: "dop853",
};

/// What coordinates must fulfil.
pub static CONSTRAINT_SHAPES: [Constraint<'static>; CONSTRAINTS] = [
    Constraint {
        name: "pin_o_x",
        unit: "m",
        doc: "the crank's pin in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_o_y",
        unit: "m",
        doc: "the crank's pin in the frame, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_a_x",
        unit: "m",
        doc: "pin between crank and rod, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_a_y",
        unit: "m",
        doc: "pin between crank and rod, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_b_x",
        unit: "m",
        doc: "pin between rod and slider, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_b_y",
        unit: "m",
        doc: "pin between rod and slider, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "guide",
        unit: "m",
        doc: "the slider on its guide",
        is_of_positions: true,
    },
    Constraint {
        name: "drive",
        unit: "1",
        doc: "the crank turns at constant speed",
        is_of_positions: true,
    },
];

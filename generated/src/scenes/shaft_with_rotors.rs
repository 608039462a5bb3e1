// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   fc1cdb3ca56a33fa759c8ce2b77e6c8b100853a6c2a63c2a7667c226dbc6d398  scenes/shaft_with_rotors.toml
//   8ae49de7bb57cc4bcfe2e842d8df5b555ca8c8262fc1581e0de72f321816947c  units/shaft.toml
//   ba9b76a100d91a8597c44349f557e301fa971bdcc9a7e0cf5da5ce4fd6af94b2  units/rotor.toml
//
// Shaft with a rotor at each end, released twisted
//
// The shaft of the saw gin with a rotor at each end, otherwise free. It is released at rest, twisted
// by a cosine with zero slope at the ends. Without rotor inertia this is an eigenmode of the free
// shaft, which decays by Kelvin-Voigt damping.
//
// Source:
//   Saw-gin study (2020), distributed subsystem; closed forms by hand.
//
// All quantities are in SI units.
// Shapes: coordinates 2, states 4, parameters 15, outputs 2.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 2 of 4 by 4, parameter_jacobian 6 of 4 by 15.
// Operations: initial_state 1, rate 6, mass_matrix 2, parameter_jacobian 10, energy 13,
//     power_balance 18, prepare 4, prepared_rate 2, prepared_parameter_jacobian 6.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Shaft with a rotor at each end, released twisted
    ///
    /// The shaft of the saw gin with a rotor at each end, otherwise free. It is released at rest, twisted
    /// by a cosine with zero slope at the ends. Without rotor inertia this is an eigenmode of the free
    /// shaft, which decays by Kelvin-Voigt damping.
    ///
    /// Source: Saw-gin study (2020), distributed subsystem; closed forms by hand.
    ShaftWithRotors: "shaft_with_rotors", "Shaft with a rotor at each end, released twisted";
    run from 0.0, until 0.02, points 401, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    prepared; jacobians_apart; linear;
}

::machinist_contract::parameters! {
    twist: 0.01, "rad", "twist", "half of the initial twist";
    shaft_length: 2.322, "m", "shaft.length", "length";
    shaft_density: 0.535_745_047_372_954_3, "kg m", "shaft.density", "moment of inertia per unit length; the default spreads 1.244 kg m^2 over 2.322 m";
    shaft_stiffness: 785_360.0, "N m^2", "shaft.stiffness", "torsional rigidity, shear modulus times polar moment";
    shaft_damping_time: 1e-5, "s", "shaft.damping_time", "Kelvin-Voigt damping time";
    driven_inertia: 1.244, "kg m^2", "driven.inertia", "moment of inertia";
    driving_inertia: 4.2, "kg m^2", "driving.inertia", "moment of inertia";
    shaft_start_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.start_field_inertia", "inertia of the field's node; the field sets it";
    shaft_start_field_force: 0.0, "J/(rad)", "shaft.start_field_force", "force of the field on its node; the field sets it";
    shaft_start_phi_x_before: 0.0, "rad/m", "shaft.start_phi_x_before", "slope of the field before the port; the field sets it";
    shaft_start_phi_x_after: 0.0, "rad/m", "shaft.start_phi_x_after", "slope of the field after the port; the field sets it";
    shaft_end_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.end_field_inertia", "inertia of the field's node; the field sets it";
    shaft_end_field_force: 0.0, "J/(rad)", "shaft.end_field_force", "force of the field on its node; the field sets it";
    shaft_end_phi_x_before: 0.0, "rad/m", "shaft.end_phi_x_before", "slope of the field before the port; the field sets it";
    shaft_end_phi_x_after: 0.0, "rad/m", "shaft.end_phi_x_after", "slope of the field after the port; the field sets it";
}

::machinist_contract::outputs! {
    start_angle: "rad", "start_angle", "angle of the section, at port start";
    end_angle: "rad", "end_angle", "angle of the section, at port end";
}

::machinist_contract::states! {
    SHAFT_START: position, 1.0, "rad", "shaft.start", "angle of the section, at port start";
    SHAFT_END: position, 1.0, "rad", "shaft.end", "angle of the section, at port end";
    SHAFT_START_DOT: velocity, 78.5, "rad/s", "shaft.start_dot", "rate of angle of the section, at port start";
    SHAFT_END_DOT: velocity, 78.5, "rad/s", "shaft.end_dot", "rate of angle of the section, at port end";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 4 by 4 { 0 [2] 1 [3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 4 by 15 { 2 [6 7 8] 3 [5 11 12] }
}

::machinist_contract::constants! {
    t0, t1
}

::machinist_contract::field_scene! {
    ShaftWithRotors: jacobian_reads_forces false;
    0 shaft_phi: linear true, local true, forces [Zero, Varying], derivatives [Zero, Zero, Zero,
        Zero, Zero, Constant, Zero, Constant], scale [1.0, 78.5], fixed [false, false],
        length 2.322, elements 16, order 4;
    value "rad", "shaft.phi", "angle of the section";
    rate "rad/s", "shaft.phi_dot", "rate of angle of the section";
    slope "rad/m", "shaft.phi_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(0), handed 7;
    at 2.322 => End, coordinate Some(1), handed 11;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(1.0) / (p.driving_inertia + p.shaft_start_field_inertia);
    let t1 = R::literal(1.0) / (p.driven_inertia + p.shaft_end_field_inertia);
    Constants { t0, t1 }
}

/// State at the start of the run, in the units of the states. 1 operation.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.twist, -p.twist, R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 2 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_dot = p.shaft_end_field_force * c.t1;
    let shaft_start_dot_dot = p.shaft_start_field_force * c.t0;
    [shaft_start_dot, shaft_end_dot, shaft_start_dot_dot, shaft_end_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    [p.driving_inertia + p.shaft_start_field_inertia, p.driven_inertia + p.shaft_end_field_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. No operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    [p.shaft_start_field_force, p.shaft_end_field_force]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 2] {
    [R::literal(1.0), R::literal(1.0)]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 6 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 6] {
    let shaft_end_dot_dot = p.shaft_end_field_force * c.t1;
    let shaft_start_dot_dot = p.shaft_start_field_force * c.t0;
    let shaft_end_dot_dot_by_driven_inertia = -(shaft_end_dot_dot * c.t1);
    let shaft_start_dot_dot_by_driving_inertia = -(shaft_start_dot_dot * c.t0);
    [shaft_start_dot_dot_by_driving_inertia, shaft_start_dot_dot_by_driving_inertia, c.t0,
        shaft_end_dot_dot_by_driven_inertia, shaft_end_dot_dot_by_driven_inertia, c.t1]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [shaft_start, shaft_end, ..] = *state;
    Outputs {
        start_angle: shaft_start,
        end_angle: shaft_end,
    }
}

/// T, V and the energy of first-order states \[J\]. 13 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_squared = shaft_end_dot * shaft_end_dot;
    let shaft_start_dot_squared = shaft_start_dot * shaft_start_dot;
    Energy {
        kinetic: (R::literal(0.5) * p.driven_inertia * shaft_end_dot_squared)
            .add_product(R::literal(0.5) * p.driving_inertia, shaft_start_dot_squared)
            .add_product(R::literal(0.5) * p.shaft_start_field_inertia, shaft_start_dot_squared)
            .add_product(R::literal(0.5) * p.shaft_end_field_inertia, shaft_end_dot_squared),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 18 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_dot = p.shaft_end_field_force * (R::literal(1.0) / (p.driven_inertia
        + p.shaft_end_field_inertia));
    let shaft_start_dot_dot = p.shaft_start_field_force * (R::literal(1.0) / (p.driving_inertia
        + p.shaft_start_field_inertia));
    PowerBalance {
        stored_rate: ((p.driving_inertia * shaft_start_dot).add_product(shaft_start_dot,
            p.shaft_start_field_inertia) * shaft_start_dot_dot).add_product((p.driven_inertia
            * shaft_end_dot).add_product(shaft_end_dot, p.shaft_end_field_inertia),
            shaft_end_dot_dot),
        supplied: (shaft_start_dot * p.shaft_start_field_force).add_product(shaft_end_dot,
            p.shaft_end_field_force),
        dissipated: R::literal(0.0),
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 2] = [(2, 0), (3, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 6 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 8] {
    [R::literal(0.0), R::literal(0.0), p.shaft_start_field_force * (R::literal(1.0)
        / (p.driving_inertia + p.shaft_start_field_inertia)), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), p.shaft_end_field_force * (R::literal(1.0) / (p.driven_inertia
        + p.shaft_end_field_inertia)), R::literal(0.0)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

/// The field shaft.phi: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_phi {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 4] = [1, 2, 3, 4];
    /// m, the inertia a length. No operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        [p.shaft_density]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`. No operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 5] {
        [R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 4 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [R::literal(0.0), -(p.shaft_stiffness * phi_x.add_product(p.shaft_damping_time, phi_x_dot))]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 3 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(_time: R, _x: R, _point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            -p.shaft_stiffness, R::literal(0.0), -(p.shaft_stiffness * p.shaft_damping_time)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 5 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(_time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 12] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            -phi_x.add_product(p.shaft_damping_time, phi_x_dot), R::literal(0.0),
            -(p.shaft_stiffness * phi_x_dot)]
    }
    /// T and V a length \[J/m\]. 6 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, phi_x, phi_dot, _] = *point;
        [R::literal(0.5) * p.shaft_density * (phi_dot * phi_dot),
            R::literal(0.5) * p.shaft_stiffness * (phi_x * phi_x)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 5 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [p.shaft_stiffness * phi_x * phi_x_dot, R::literal(0.0),
            p.shaft_stiffness * p.shaft_damping_time * (phi_x_dot * phi_x_dot)]
    }
    /// x of the attachments, then the length \[m\]. No operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row. No operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 12] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(1.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0)]
    }
    /// u and u_t at the start. 4 operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(x: R, p: &Parameters<R>) -> [R; 2] {
        [p.twist * (R::literal(core::f64::consts::PI) / p.shaft_length * x).cos(), R::literal(0.0)]
    }
    /// f_0 alone, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            force: &mut [R]) {
        for (((_, _), _), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = R::literal(0.0);
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_jacobian<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            by_u: &mut [R], by_u_t: &mut [R]) {
        for ((((_, _), _), by_u), by_u_t) in at.iter().zip(u).zip(u_t).zip(by_u).zip(by_u_t) {
            *by_u = R::literal(0.0);
            *by_u_t = R::literal(0.0);
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_by_time<R: Real>(_time: R, at: &[R], u: &[R], u_t: &[R], _p: &Parameters<R>,
            by_time: &mut [R]) {
        for (((_, _), _), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            *by_time = R::literal(0.0);
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 0 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        for ((&phi_x, &phi_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(p.shaft_stiffness * phi_x.add_product(p.shaft_damping_time, phi_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 3 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let minus_shaft_stiffness = -p.shaft_stiffness;
        let t0 = -(p.shaft_stiffness * p.shaft_damping_time);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = minus_shaft_stiffness;
            *by_u_xt = t0;
        }
    }
}

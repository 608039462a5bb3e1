// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0ce436add02169f3fe010e02246886554075914589a54b66f3dbd56c3928e384  scenes/shaft_step_torque.toml
//   8ae49de7bb57cc4bcfe2e842d8df5b555ca8c8262fc1581e0de72f321816947c  units/shaft.toml
//
// Uniform shaft under a step of end torque
//
// The shaft of the saw gin with the cylinder's inertia spread along it, fixed at one end. A constant
// torque acts on the other from t = 0.
//
// Source:
//   Saw-gin study (2020), distributed subsystem; d'Alembert's solution.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 13, outputs 3.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 1 of 2 by 2, parameter_jacobian 3 of 2 by 13.
// Operations: rate 3, forcing 1, parameter_jacobian 5, outputs 1, energy 3, power_balance 6,
//     prepare 1, prepared_rate 2, prepared_parameter_jacobian 4.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Uniform shaft under a step of end torque
    ///
    /// The shaft of the saw gin with the cylinder's inertia spread along it, fixed at one end. A constant
    /// torque acts on the other from t = 0.
    ///
    /// Source: Saw-gin study (2020), distributed subsystem; d'Alembert's solution.
    ShaftStepTorque: "shaft_step_torque", "Uniform shaft under a step of end torque";
    run from 0.0, until 0.01, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    prepared; jacobians_apart; linear;
}

::machinist_contract::parameters! {
    torque: 843.72, "N m", "torque", "torque at the free end";
    shaft_length: 2.322, "m", "shaft.length", "length";
    shaft_density: 0.535_745_047_372_954_3, "kg m", "shaft.density", "moment of inertia per unit length; the default spreads 1.244 kg m^2 over 2.322 m";
    shaft_stiffness: 785_360.0, "N m^2", "shaft.stiffness", "torsional rigidity, shear modulus times polar moment";
    shaft_damping_time: 0.0, "s", "shaft.damping_time", "Kelvin-Voigt damping time";
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
    end_angle: "rad", "end_angle", "angle of the section, at port end";
    end_speed: "rad/s", "end_speed", "rate of angle of the section, at port end";
    wall_torque: "N m", "wall_torque", "torque in the shaft at the wall";
}

::machinist_contract::states! {
    SHAFT_END: position, 1.0, "rad", "shaft.end", "angle of the section, at port end";
    SHAFT_END_DOT: velocity, 78.5, "rad/s", "shaft.end_dot", "rate of angle of the section, at port end";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 2 by 2 { 0 [1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 2 by 13 { 1 [0 9 10] }
}

::machinist_contract::constants! {
    inverse_shaft_end_field_inertia
}

::machinist_contract::field_scene! {
    ShaftStepTorque: jacobian_reads_forces false;
    0 shaft_phi: linear true, local true, forces [Zero, Varying], derivatives [Zero, Zero, Zero,
        Zero, Zero, Constant, Zero, Constant], scale [1.0, 78.5], fixed [true, false],
        length 2.322, elements 64, order 4;
    value "rad", "shaft.phi", "angle of the section";
    rate "rad/s", "shaft.phi_dot", "rate of angle of the section";
    slope "rad/m", "shaft.phi_x", "slope of angle of the section";
    at 0.0 => Start, coordinate None, handed 5;
    at 2.322 => End, coordinate Some(0), handed 9;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_shaft_end_field_inertia = R::literal(1.0) / p.shaft_end_field_inertia;
    Constants { inverse_shaft_end_field_inertia }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
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
    let [_, shaft_end_dot] = *state;
    let shaft_end_dot_dot = (p.torque + p.shaft_end_field_force)
        * c.inverse_shaft_end_field_inertia;
    [shaft_end_dot, shaft_end_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.shaft_end_field_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 1 operation.
#[must_use]
pub fn forcing<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let shaft_end_forcing = p.torque + p.shaft_end_field_force;
    [shaft_end_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        _c: &Constants<R>) -> [R; 1] {
    [R::literal(1.0)]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 4 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    let shaft_end_dot_dot = (p.torque + p.shaft_end_field_force)
        * c.inverse_shaft_end_field_inertia;
    let shaft_end_dot_dot_by_shaft_end_field_inertia = -(shaft_end_dot_dot
        * c.inverse_shaft_end_field_inertia);
    [c.inverse_shaft_end_field_inertia, shaft_end_dot_dot_by_shaft_end_field_inertia,
        c.inverse_shaft_end_field_inertia]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 1 operation.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [shaft_end, shaft_end_dot] = *state;
    Outputs {
        end_angle: shaft_end,
        end_speed: shaft_end_dot,
        wall_torque: p.shaft_stiffness * p.shaft_start_phi_x_after,
    }
}

/// T, V and the energy of first-order states \[J\]. 3 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, shaft_end_dot] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.shaft_end_field_inertia * (shaft_end_dot * shaft_end_dot),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 6 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, shaft_end_dot] = *state;
    let torque_plus_shaft_end_field_force = p.torque + p.shaft_end_field_force;
    let shaft_end_dot_dot = torque_plus_shaft_end_field_force * (R::literal(1.0)
        / p.shaft_end_field_inertia);
    PowerBalance {
        stored_rate: shaft_end_dot * p.shaft_end_field_inertia * shaft_end_dot_dot,
        supplied: shaft_end_dot * torque_plus_shaft_end_field_force,
        dissipated: R::literal(0.0),
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 1] = [(1, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 3 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 4] {
    [R::literal(0.0), R::literal(0.0), (p.torque + p.shaft_end_field_force) * (R::literal(1.0)
        / p.shaft_end_field_inertia), R::literal(0.0)]
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
    /// u and u_t at the start. No operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 2] {
        [R::literal(0.0), R::literal(0.0)]
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

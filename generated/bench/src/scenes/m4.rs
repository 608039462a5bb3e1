// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   379f2982d21b7d8247ee0f159dad488e1340b43a34c47ba92c149fb53a137e90  bench/m4.toml
//
// Benchmark M4: reed as a torsional shaft
//
// An undamped shaft is driven by a spring at one end. The reed and a spring to ground act at four
// sevenths of its length. Elements of order 1 are the benchmark's lumped masses: M4:70 has 70 of them.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 2, states 4, parameters 17, outputs 4.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 4 of 4 by 4, parameter_jacobian 8 of 4 by 17.
// Operations: rate 15, mass_matrix 3, forcing 8, rate_jacobian 9, parameter_jacobian 30,
//     time_derivative 6, energy 23, power_balance 35, prepare 11, prepared_rate 10,
//     prepared_parameter_jacobian 23.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Benchmark M4: reed as a torsional shaft
    ///
    /// An undamped shaft is driven by a spring at one end. The reed and a spring to ground act at four
    /// sevenths of its length. Elements of order 1 are the benchmark's lumped masses: M4:70 has 70 of them.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M4: "m4", "Benchmark M4: reed as a torsional shaft";
    run from 0.0, until 0.5, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    prepared; jacobians_apart; linear;
}

::machinist_contract::parameters! {
    shaft_length: 1.75, "m", "shaft.length", "length";
    shaft_radius: 0.025, "m", "shaft.radius", "radius";
    shaft_density: 7659.0, "kg/m^3", "shaft.density", "density";
    shaft_elasticity: 2e11, "Pa", "shaft.elasticity", "Young's modulus";
    shaft_poisson: 0.3, "1", "shaft.poisson", "Poisson's ratio";
    reed_mass: 3.56, "kg", "reed.mass", "mass";
    reed_radius: 0.12, "m", "reed.radius", "distance from the axis";
    drive_spring_stiffness: 45200.0, "N m/rad", "drive_spring.stiffness", "stiffness";
    ground_spring_stiffness: 15600.0, "N m/rad", "ground_spring.stiffness", "stiffness";
    shaft_driven_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.driven_field_inertia", "inertia of the field's node; the field sets it";
    shaft_driven_field_force: 0.0, "J/(rad)", "shaft.driven_field_force", "force of the field on its node; the field sets it";
    shaft_driven_theta_x_before: 0.0, "rad/m", "shaft.driven_theta_x_before", "slope of the field before the port; the field sets it";
    shaft_driven_theta_x_after: 0.0, "rad/m", "shaft.driven_theta_x_after", "slope of the field after the port; the field sets it";
    shaft_reed_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.reed_field_inertia", "inertia of the field's node; the field sets it";
    shaft_reed_field_force: 0.0, "J/(rad)", "shaft.reed_field_force", "force of the field on its node; the field sets it";
    shaft_reed_theta_x_before: 0.0, "rad/m", "shaft.reed_theta_x_before", "slope of the field before the port; the field sets it";
    shaft_reed_theta_x_after: 0.0, "rad/m", "shaft.reed_theta_x_after", "slope of the field after the port; the field sets it";
}

::machinist_contract::outputs! {
    driven_angle: "rad", "driven_angle", "angle of the section, at port driven";
    driven_speed: "rad/s", "driven_speed", "rate of angle of the section, at port driven";
    reed_angle: "rad", "reed_angle", "angle of the section, at port reed";
    reed_speed: "rad/s", "reed_speed", "rate of angle of the section, at port reed";
}

::machinist_contract::states! {
    SHAFT_DRIVEN: position, 0.12, "rad", "shaft.driven", "angle of the section, at port driven";
    SHAFT_REED: position, 0.12, "rad", "shaft.reed", "angle of the section, at port reed";
    SHAFT_DRIVEN_DOT: velocity, 3.0, "rad/s", "shaft.driven_dot", "rate of angle of the section, at port driven";
    SHAFT_REED_DOT: velocity, 3.0, "rad/s", "shaft.reed_dot", "rate of angle of the section, at port reed";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 4 by 4 { 0 [2] 1 [3] 2 [0] 3 [1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 4 by 17 { 2 [7 9 10] 3 [5 6 8 13 14] }
}

::machinist_contract::constants! {
    inverse_shaft_driven_field_inertia, t0, shaft_driven_dot_dot_by_shaft_driven,
    shaft_reed_dot_dot_by_shaft_reed, reed_radius_squared, t1
}

::machinist_contract::field_scene! {
    M4: jacobian_reads_forces false;
    0 shaft_theta: linear true, local true, forces [Zero, Varying], derivatives [Zero, Zero, Zero,
        Zero, Zero, Constant, Zero, Zero], scale [0.12, 3.0], fixed [false, false], length 1.75,
        elements 70, order 1;
    value "rad", "shaft.theta", "angle of the section";
    rate "rad/s", "shaft.theta_dot", "rate of angle of the section";
    slope "rad/m", "shaft.theta_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(0), handed 9;
    at 1.0 => Inside, coordinate Some(1), handed 13;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 11 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let reed_radius_squared = p.reed_radius * p.reed_radius;
    let inverse_shaft_driven_field_inertia = R::literal(1.0) / p.shaft_driven_field_inertia;
    let t0 = R::literal(1.0) / p.shaft_reed_field_inertia.add_product(p.reed_mass,
        reed_radius_squared);
    let shaft_driven_dot_dot_by_shaft_driven = -(p.drive_spring_stiffness
        * inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed = -(p.ground_spring_stiffness * t0);
    let t1 = R::literal(-2.0) * p.reed_mass * p.reed_radius;
    Constants { inverse_shaft_driven_field_inertia, t0, shaft_driven_dot_dot_by_shaft_driven,
        shaft_reed_dot_dot_by_shaft_reed, reed_radius_squared, t1 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_reed_dot_dot = p.shaft_reed_field_force.sub_product(p.ground_spring_stiffness,
        shaft_reed) * c.t0;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.drive_spring_stiffness,
        shaft_driven - drive) * c.inverse_shaft_driven_field_inertia;
    [shaft_driven_dot, shaft_reed_dot, shaft_driven_dot_dot, shaft_reed_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 3 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    [p.shaft_driven_field_inertia, p.shaft_reed_field_inertia.add_product(p.reed_mass,
        p.reed_radius * p.reed_radius)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 8 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [shaft_driven, shaft_reed, ..] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_driven_forcing = p.shaft_driven_field_force.sub_product(p.drive_spring_stiffness,
        shaft_driven - drive);
    let shaft_reed_forcing = p.shaft_reed_field_force.sub_product(p.ground_spring_stiffness,
        shaft_reed);
    [shaft_driven_forcing, shaft_reed_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 4] {
    [R::literal(1.0), R::literal(1.0), c.shaft_driven_dot_dot_by_shaft_driven,
        c.shaft_reed_dot_dot_by_shaft_reed]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 23 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 8] {
    let [shaft_driven, shaft_reed, ..] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_reed_dot_dot = p.shaft_reed_field_force.sub_product(p.ground_spring_stiffness,
        shaft_reed) * c.t0;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.drive_spring_stiffness,
        shaft_driven - drive) * c.inverse_shaft_driven_field_inertia;
    let shaft_reed_dot_dot_by_reed_mass = -(c.reed_radius_squared * shaft_reed_dot_dot * c.t0);
    let shaft_reed_dot_dot_by_reed_radius = c.t1 * shaft_reed_dot_dot * c.t0;
    let shaft_driven_dot_dot_by_drive_spring_stiffness = (drive - shaft_driven)
        * c.inverse_shaft_driven_field_inertia;
    let shaft_reed_dot_dot_by_ground_spring_stiffness = -(shaft_reed * c.t0);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * c.inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot * c.t0);
    [shaft_driven_dot_dot_by_drive_spring_stiffness,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia, c.inverse_shaft_driven_field_inertia,
        shaft_reed_dot_dot_by_reed_mass, shaft_reed_dot_dot_by_reed_radius,
        shaft_reed_dot_dot_by_ground_spring_stiffness,
        shaft_reed_dot_dot_by_shaft_reed_field_inertia, c.t0]
}

/// Partial derivative of `y'` with respect to time. 6 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let shaft_driven_dot_dot_by_time = R::literal(3.015_928_947_446_201) * p.drive_spring_stiffness
        * (R::literal(8.0 * core::f64::consts::PI) * time).cos() * (R::literal(1.0)
        / p.shaft_driven_field_inertia);
    [R::literal(0.0), R::literal(0.0), shaft_driven_dot_dot_by_time, R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    Outputs {
        driven_angle: shaft_driven,
        driven_speed: shaft_driven_dot,
        reed_angle: shaft_reed,
        reed_speed: shaft_reed_dot,
    }
}

/// T, V and the energy of first-order states \[J\]. 23 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let shaft_driven_minus_drive = shaft_driven - drive;
    let shaft_reed_dot_squared = shaft_reed_dot * shaft_reed_dot;
    Energy {
        kinetic: (R::literal(0.5) * p.shaft_driven_field_inertia * (shaft_driven_dot
            * shaft_driven_dot)).add_product(R::literal(0.5) * p.reed_mass * (p.reed_radius
            * p.reed_radius), shaft_reed_dot_squared).add_product(R::literal(0.5)
            * p.shaft_reed_field_inertia, shaft_reed_dot_squared),
        potential: (R::literal(0.5) * p.ground_spring_stiffness * (shaft_reed * shaft_reed))
            .add_product(R::literal(0.5) * p.drive_spring_stiffness, shaft_driven_minus_drive
            * shaft_driven_minus_drive),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 35 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [shaft_driven, shaft_reed, shaft_driven_dot, shaft_reed_dot] = *state;
    let t0 = R::literal(8.0 * core::f64::consts::PI) * time;
    let (t1, t2) = t0.sin_cos();
    let drive = R::literal(0.12) * t1;
    let reed_mass_times_reed_radius_squared = p.reed_mass * (p.reed_radius * p.reed_radius);
    let shaft_driven_minus_drive = shaft_driven - drive;
    let t3 = p.drive_spring_stiffness * shaft_driven_minus_drive;
    let t4 = p.ground_spring_stiffness * shaft_reed;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t4) * (R::literal(1.0)
        / (reed_mass_times_reed_radius_squared + p.shaft_reed_field_inertia));
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t3) * (R::literal(1.0)
        / p.shaft_driven_field_inertia);
    let t5 = R::literal(3.015_928_947_446_201) * p.drive_spring_stiffness
        * shaft_driven_minus_drive * t2;
    PowerBalance {
        stored_rate: (-t5).add_product(t3, shaft_driven_dot).add_product(t4, shaft_reed_dot)
            .add_product(shaft_driven_dot * p.shaft_driven_field_inertia, shaft_driven_dot_dot)
            .add_product((shaft_reed_dot * p.shaft_reed_field_inertia)
            .add_product(reed_mass_times_reed_radius_squared, shaft_reed_dot), shaft_reed_dot_dot),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force).add_product(shaft_reed_dot,
            p.shaft_reed_field_force) - t5,
        dissipated: R::literal(0.0),
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(2, 0), (2, 0), (3, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 9 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 12] {
    let inverse_shaft_driven_field_inertia = R::literal(1.0) / p.shaft_driven_field_inertia;
    [R::literal(0.0), R::literal(0.0),
        p.shaft_driven_field_force * inverse_shaft_driven_field_inertia, R::literal(0.0),
        R::literal(0.0), R::literal(8.0 * core::f64::consts::PI), R::literal(0.0),
        R::literal(0.12) * p.drive_spring_stiffness * inverse_shaft_driven_field_inertia,
        R::literal(0.0), R::literal(0.0), p.shaft_reed_field_force * (R::literal(1.0)
        / p.shaft_reed_field_inertia.add_product(p.reed_mass, p.reed_radius * p.reed_radius)),
        R::literal(0.0)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

/// The field shaft.theta: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_theta {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 5] = [0, 1, 2, 3, 4];
    /// m, the inertia a length. 4 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_density * (shaft_radius_squared
            * shaft_radius_squared)]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`. 6 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 6] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(0.0),
            R::literal(core::f64::consts::TAU) * p.shaft_density * (shaft_radius_squared
            * p.shaft_radius), R::literal(core::f64::consts::FRAC_PI_2) * (shaft_radius_squared
            * shaft_radius_squared), R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 7 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, theta_x, _, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(-0.785_398_163_397_448_3) * p.shaft_elasticity
            * (shaft_radius_squared * shaft_radius_squared) / (R::literal(1.0)
            + p.shaft_poisson) * theta_x]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 6 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(_time: R, _x: R, _point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-0.785_398_163_397_448_3) * p.shaft_elasticity * (shaft_radius_squared
            * shaft_radius_squared) / (R::literal(1.0) + p.shaft_poisson), R::literal(0.0),
            R::literal(0.0)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 16 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(_time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 14] {
        let [_, theta_x, _, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(1.0) + p.shaft_poisson;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0),
            R::literal(-3.141_592_653_589_793) * p.shaft_elasticity * (shaft_radius_squared
            * p.shaft_radius) / t0 * theta_x, R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-0.785_398_163_397_448_3) * shaft_radius_squared_squared / t0 * theta_x,
            R::literal(0.0), R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity
            * shaft_radius_squared_squared / (t0 * t0) * theta_x]
    }
    /// T and V a length \[J/m\]. 12 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, theta_x, theta_dot, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        [R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_density * shaft_radius_squared_squared
            * (theta_dot * theta_dot), R::literal(0.392_699_081_698_724_14) * p.shaft_elasticity
            * shaft_radius_squared_squared / (R::literal(1.0) + p.shaft_poisson) * (theta_x
            * theta_x)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 8 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, theta_x, _, theta_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_elasticity * (shaft_radius_squared
            * shaft_radius_squared) / (R::literal(1.0) + p.shaft_poisson) * theta_x * theta_x_dot,
            R::literal(0.0), R::literal(0.0)]
    }
    /// x of the attachments, then the length \[m\]. 1 operation.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), R::literal(0.571_428_571_428_571_4) * p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row. No operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 15] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.571_428_571_428_571_4), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0)]
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
    /// 6 operations for all points, 1 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(-0.785_398_163_397_448_3) * p.shaft_elasticity * (shaft_radius_squared
            * shaft_radius_squared) / (R::literal(1.0) + p.shaft_poisson);
        for ((&theta_x, _), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = t0 * theta_x;
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 6 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(-0.785_398_163_397_448_3) * p.shaft_elasticity * (shaft_radius_squared
            * shaft_radius_squared) / (R::literal(1.0) + p.shaft_poisson);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = t0;
            *by_u_xt = R::literal(0.0);
        }
    }
}

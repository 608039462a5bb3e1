// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   a6ee874010f8945cb90f07599ae45eec7f624b52d5c4c36749d736ddead3c1fa  scenes/reed_beat_up_one_sided.toml
//   61dcd916f7f041da71fe3e7a0138c556cf14aac1ac3599a978dcc6586260475d  units/textile/imposed_drive.toml
//   dfe11eec2c46ab2845d6693f49f4f3634573d8ca64fadaf874b71b4c8dcafb3a  units/textile/loom_shaft.toml
//   26e14d50834ad425bb0bc762e8b125d605c2c6b5f805586de92628a7bf67982c  units/textile/reed.toml
//   3a33e0f0fd97ebb0d7f12af38f509dbe1cdc9ad0d7ab3d55ed20138f78410531  units/textile/cloth_fell_one_sided.toml
//
// Beat-up of a reed against a one-sided fell
//
// The shaft and reed of `reed_beat_up` against a cloth fell that only pushes, as in the machine: the
// reed leaves the fell on its way back. This reading decides the effect of a stiffer fell.
//
// Source:
//   Reed study, in its consistent reading; that the fell only pushes is ours.
//
// All quantities are in SI units.
// Shapes: coordinates 4, states 8, parameters 25, outputs 8, kinks 1, relations 1.
// Nonzeros: mass_matrix 4 of 4 by 4, rate_jacobian 9 of 8 by 8, parameter_jacobian 14 of 8 by 25.
// Operations: rate 24, mass_matrix 2, forcing 14, rate_jacobian 17, parameter_jacobian 54,
//     time_derivative 7, outputs 9, energy 35, power_balance 54, prepare 14, prepared_rate 18,
//     prepared_rate_jacobian 7, prepared_parameter_jacobian 45.

use ::machinist_contract::{Energy, PowerBalance, Real, field::FieldPoint};

::machinist_contract::simulator! {
    /// Beat-up of a reed against a one-sided fell
    ///
    /// The shaft and reed of \`reed_beat_up\` against a cloth fell that only pushes, as in the machine: the
    /// reed leaves the fell on its way back. This reading decides the effect of a stiffer fell.
    ///
    /// Source: Reed study, in its consistent reading; that the fell only pushes is ours.
    ReedBeatUpOneSided: "reed_beat_up_one_sided", "Beat-up of a reed against a one-sided fell";
    run from 0.0, until 0.0527, points 501, rtol 1e-8, method "radau";
    quadratures 0, discontinuities 0;
    prepared; jacobians_apart; linear; kinks 1; relations;
}

::machinist_contract::parameters! {
    drive_stiffness: 45200.0, "N m/rad", "drive.stiffness", "stiffness C0 of the drive spring";
    drive_amplitude: 0.251_719_699_449_452_3, "rad", "drive.amplitude", "amplitude of the prescribed angle";
    drive_frequency: 119.180_183_615_403_86, "rad/s", "drive.frequency", "angular frequency of the prescribed angle";
    shaft_length: 1.75, "m", "shaft.length", "half length of the shaft";
    shaft_reed_position: 1.0, "m", "shaft.reed_position", "position of the reed";
    shaft_radius: 0.025, "m", "shaft.radius", "radius";
    shaft_density: 7659.0, "kg/m^3", "shaft.density", "density";
    shaft_shear_modulus: 7.692_307_692_307_692e10, "Pa", "shaft.shear_modulus", "shear modulus, E/(2 (1 + nu)) with E = 2e11 Pa, nu = 0.3";
    shaft_damping_time: 0.0, "s", "shaft.damping_time", "Kelvin-Voigt damping time";
    reed_mass: 3.56, "kg", "reed.mass", "mass";
    reed_arm: 0.025, "m", "reed.arm", "lever arm of the mass";
    reed_stiffness: 15600.0, "N m/rad", "reed.stiffness", "stiffness C1 of the spring between shaft and reed";
    fell_stiffness: 7800.0, "N m/rad", "fell.stiffness", "stiffness C2 of the contact";
    shaft_driven_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.driven_field_inertia", "inertia of the field's node; the field sets it";
    shaft_driven_field_force: 0.0, "J/(rad)", "shaft.driven_field_force", "force of the field on its node; the field sets it";
    shaft_driven_u_x_before: 0.0, "rad/m", "shaft.driven_u_x_before", "slope of the field before the port; the field sets it";
    shaft_driven_u_x_after: 0.0, "rad/m", "shaft.driven_u_x_after", "slope of the field after the port; the field sets it";
    shaft_reed_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.reed_field_inertia", "inertia of the field's node; the field sets it";
    shaft_reed_field_force: 0.0, "J/(rad)", "shaft.reed_field_force", "force of the field on its node; the field sets it";
    shaft_reed_u_x_before: 0.0, "rad/m", "shaft.reed_u_x_before", "slope of the field before the port; the field sets it";
    shaft_reed_u_x_after: 0.0, "rad/m", "shaft.reed_u_x_after", "slope of the field after the port; the field sets it";
    shaft_middle_field_inertia: 1.0, "J s^2/(rad)^2", "shaft.middle_field_inertia", "inertia of the field's node; the field sets it";
    shaft_middle_field_force: 0.0, "J/(rad)", "shaft.middle_field_force", "force of the field on its node; the field sets it";
    shaft_middle_u_x_before: 0.0, "rad/m", "shaft.middle_u_x_before", "slope of the field before the port; the field sets it";
    shaft_middle_u_x_after: 0.0, "rad/m", "shaft.middle_u_x_after", "slope of the field after the port; the field sets it";
    @ held_1: Branch;
}

::machinist_contract::outputs! {
    drive_angle: "rad", "drive_angle", "prescribed angle u0";
    driven_angle: "rad", "driven_angle", "angle of the section, at port driven";
    shaft_angle: "rad", "shaft_angle", "angle of the section, at port reed";
    middle_angle: "rad", "middle_angle", "angle of the section, at port middle";
    reed_angle: "rad", "reed_angle", "angle of the reed";
    stress_before: "Pa", "stress_before", "shear stress at the surface, on the driven side of the reed";
    stress_after: "Pa", "stress_after", "shear stress at the surface, beyond the reed";
    fell_torque: "N m", "fell_torque", "torque of the fell against the reed";
}

::machinist_contract::states! {
    SHAFT_DRIVEN: position, 1.0, "rad", "shaft.driven", "angle of the section, at port driven";
    SHAFT_REED: position, 1.0, "rad", "shaft.reed", "angle of the section, at port reed";
    SHAFT_MIDDLE: position, 1.0, "rad", "shaft.middle", "angle of the section, at port middle";
    REED_ANGLE: position, 1.0, "rad", "reed.angle", "angle of the reed";
    SHAFT_DRIVEN_DOT: velocity, 100.0, "rad/s", "shaft.driven_dot", "rate of angle of the section, at port driven";
    SHAFT_REED_DOT: velocity, 100.0, "rad/s", "shaft.reed_dot", "rate of angle of the section, at port reed";
    SHAFT_MIDDLE_DOT: velocity, 100.0, "rad/s", "shaft.middle_dot", "rate of angle of the section, at port middle";
    REED_SPEED: velocity, 100.0, "rad/s", "reed.speed", "rate of angle of the reed";
}

::machinist_contract::relations! {
    Branch [Rate, Above(0)];
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 4 by 4 { 0 [0] 1 [1] 2 [2] 3 [3] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [4] 1 [5] 2 [6] 3 [7] 4 [0] 5 [1 3] 7 [1 3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 25 { 4 [0 1 2 13 14] 5 [11 17 18] 6 [21 22] 7 [9 10 11 12] }
}

::machinist_contract::constants! {
    inverse_shaft_driven_field_inertia, inverse_shaft_reed_field_inertia,
    inverse_shaft_middle_field_inertia, t0, shaft_driven_dot_dot_by_shaft_driven,
    reed_speed_dot_by_shaft_reed, t1, shaft_reed_dot_dot_by_shaft_reed, reed_arm_squared, t2, t3
}

::machinist_contract::field_scene! {
    ReedBeatUpOneSided: jacobian_reads_forces false;
    0 shaft_u: linear true, local true, forces [Zero, Varying], derivatives [Zero, Zero, Zero,
        Zero, Zero, Constant, Zero, Constant], scale [1.0, 100.0], fixed [false, false],
        length 1.75, elements 24, order 4;
    value "rad", "shaft.u", "angle of the section";
    rate "rad/s", "shaft.u_dot", "rate of angle of the section";
    slope "rad/m", "shaft.u_x", "slope of angle of the section";
    at 0.0 => Start, coordinate Some(0), handed 13;
    at 1.0 => Inside, coordinate Some(1), handed 17;
    at 1.75 => End, coordinate Some(2), handed 21;
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 14 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let reed_arm_squared = p.reed_arm * p.reed_arm;
    let inverse_shaft_driven_field_inertia = R::literal(1.0) / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let inverse_shaft_middle_field_inertia = R::literal(1.0) / p.shaft_middle_field_inertia;
    let t0 = R::literal(1.0) / (p.reed_mass * reed_arm_squared);
    let shaft_driven_dot_dot_by_shaft_driven = -(p.drive_stiffness
        * inverse_shaft_driven_field_inertia);
    let reed_speed_dot_by_shaft_reed = p.reed_stiffness * t0;
    let t1 = p.reed_stiffness * inverse_shaft_reed_field_inertia;
    let shaft_reed_dot_dot_by_shaft_reed = -t1;
    let t2 = p.drive_stiffness * p.drive_amplitude;
    let t3 = R::literal(-2.0) * p.reed_mass * p.reed_arm;
    Constants { inverse_shaft_driven_field_inertia, inverse_shaft_reed_field_inertia,
        inverse_shaft_middle_field_inertia, t0, shaft_driven_dot_dot_by_shaft_driven,
        reed_speed_dot_by_shaft_reed, t1, shaft_reed_dot_dot_by_shaft_reed, reed_arm_squared, t2,
        t3 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 18 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
        shaft_middle_dot, reed_speed] = *state;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let reed_angle_plus_held_1 = reed_angle + p.held_1;
    let fell_torque = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0),
        p.fell_stiffness * reed_angle);
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let reed_speed_dot = (t0 - R::select_less(reed_angle_plus_held_1, R::literal(0.0),
        R::literal(0.0), fell_torque)) * c.t0;
    let shaft_middle_dot_dot = p.shaft_middle_field_force * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t0) * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.drive_stiffness,
        shaft_driven - drive_angle) * c.inverse_shaft_driven_field_inertia;
    [shaft_driven_dot, shaft_reed_dot, shaft_middle_dot, reed_speed, shaft_driven_dot_dot,
        shaft_reed_dot_dot, shaft_middle_dot_dot, reed_speed_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 4] {
    [p.shaft_driven_field_inertia, p.shaft_reed_field_inertia, p.shaft_middle_field_inertia,
        p.reed_mass * (p.reed_arm * p.reed_arm)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 14 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [shaft_driven, shaft_reed, _, reed_angle, ..] = *state;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let reed_angle_plus_held_1 = reed_angle + p.held_1;
    let fell_torque = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0),
        p.fell_stiffness * reed_angle);
    let shaft_driven_forcing = p.shaft_driven_field_force.sub_product(p.drive_stiffness,
        shaft_driven - drive_angle);
    let t0 = p.reed_stiffness * (shaft_reed - reed_angle);
    let shaft_reed_forcing = p.shaft_reed_field_force - t0;
    let reed_angle_forcing = t0 - R::select_less(reed_angle_plus_held_1, R::literal(0.0),
        R::literal(0.0), fell_torque);
    [shaft_driven_forcing, shaft_reed_forcing, p.shaft_middle_field_force, reed_angle_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 7 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 9] {
    let [_, _, _, reed_angle, ..] = *state;
    let t0 = R::select_less(reed_angle + p.held_1, R::literal(0.0), R::literal(0.0),
        R::literal(1.0));
    let reed_speed_dot_by_reed_angle = -(p.reed_stiffness.add_product(p.fell_stiffness, t0 * t0)
        * c.t0);
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        c.shaft_driven_dot_dot_by_shaft_driven, c.shaft_reed_dot_dot_by_shaft_reed, c.t1,
        c.reed_speed_dot_by_shaft_reed, reed_speed_dot_by_reed_angle]
}

/// As `parameter_jacobian`, with the constants of the parameters from `prepare`. 45 operations.
#[must_use]
pub fn prepared_parameter_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 14] {
    let [shaft_driven, shaft_reed, _, reed_angle, ..] = *state;
    let drive_frequency_times_time = p.drive_frequency * time;
    let (sin_drive_frequency_times_time,
        cos_drive_frequency_times_time) = drive_frequency_times_time.sin_cos();
    let drive_angle = p.drive_amplitude * sin_drive_frequency_times_time;
    let reed_angle_plus_held_1 = reed_angle + p.held_1;
    let fell_torque = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0),
        p.fell_stiffness * reed_angle);
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    let t0 = p.reed_stiffness * shaft_reed_minus_reed_angle;
    let reed_speed_dot = (t0 - R::select_less(reed_angle_plus_held_1, R::literal(0.0),
        R::literal(0.0), fell_torque)) * c.t0;
    let shaft_middle_dot_dot = p.shaft_middle_field_force * c.inverse_shaft_middle_field_inertia;
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t0) * c.inverse_shaft_reed_field_inertia;
    let shaft_driven_dot_dot = p.shaft_driven_field_force.sub_product(p.drive_stiffness,
        shaft_driven - drive_angle) * c.inverse_shaft_driven_field_inertia;
    let t1 = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0),
        R::literal(1.0));
    let shaft_driven_dot_dot_by_drive_stiffness = (drive_angle - shaft_driven)
        * c.inverse_shaft_driven_field_inertia;
    let shaft_driven_dot_dot_by_drive_amplitude = p.drive_stiffness
        * sin_drive_frequency_times_time * c.inverse_shaft_driven_field_inertia;
    let shaft_driven_dot_dot_by_drive_frequency = c.t2 * time * cos_drive_frequency_times_time
        * c.inverse_shaft_driven_field_inertia;
    let reed_speed_dot_by_reed_mass = -(c.reed_arm_squared * reed_speed_dot * c.t0);
    let reed_speed_dot_by_reed_arm = c.t3 * reed_speed_dot * c.t0;
    let reed_speed_dot_by_reed_stiffness = shaft_reed_minus_reed_angle * c.t0;
    let shaft_reed_dot_dot_by_reed_stiffness = (reed_angle - shaft_reed)
        * c.inverse_shaft_reed_field_inertia;
    let reed_speed_dot_by_fell_stiffness = -(reed_angle * (t1 * t1) * c.t0);
    let shaft_driven_dot_dot_by_shaft_driven_field_inertia = -(shaft_driven_dot_dot
        * c.inverse_shaft_driven_field_inertia);
    let shaft_reed_dot_dot_by_shaft_reed_field_inertia = -(shaft_reed_dot_dot
        * c.inverse_shaft_reed_field_inertia);
    let shaft_middle_dot_dot_by_shaft_middle_field_inertia = -(shaft_middle_dot_dot
        * c.inverse_shaft_middle_field_inertia);
    [shaft_driven_dot_dot_by_drive_stiffness, shaft_driven_dot_dot_by_drive_amplitude,
        shaft_driven_dot_dot_by_drive_frequency,
        shaft_driven_dot_dot_by_shaft_driven_field_inertia, c.inverse_shaft_driven_field_inertia,
        shaft_reed_dot_dot_by_reed_stiffness, shaft_reed_dot_dot_by_shaft_reed_field_inertia,
        c.inverse_shaft_reed_field_inertia, shaft_middle_dot_dot_by_shaft_middle_field_inertia,
        c.inverse_shaft_middle_field_inertia, reed_speed_dot_by_reed_mass,
        reed_speed_dot_by_reed_arm, reed_speed_dot_by_reed_stiffness,
        reed_speed_dot_by_fell_stiffness]
}

/// Partial derivative of `y'` with respect to time. 7 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let shaft_driven_dot_dot_by_time = p.drive_stiffness * p.drive_amplitude * p.drive_frequency
        * (p.drive_frequency * time).cos() * (R::literal(1.0) / p.shaft_driven_field_inertia);
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        shaft_driven_dot_dot_by_time, R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 9 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [shaft_driven, shaft_reed, shaft_middle, reed_angle, ..] = *state;
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let fell_torque = R::select_less(reed_angle + p.held_1, R::literal(0.0), R::literal(0.0),
        p.fell_stiffness * reed_angle);
    let t0 = p.shaft_radius * p.shaft_shear_modulus;
    Outputs {
        drive_angle,
        driven_angle: shaft_driven,
        shaft_angle: shaft_reed,
        middle_angle: shaft_middle,
        reed_angle,
        stress_before: t0 * p.shaft_reed_u_x_before,
        stress_after: t0 * p.shaft_reed_u_x_after,
        fell_torque,
    }
}

/// T, V and the energy of first-order states \[J\]. 35 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
        shaft_middle_dot, reed_speed] = *state;
    let fell_pressed = R::select_less(reed_angle + p.held_1, R::literal(0.0), R::literal(0.0),
        reed_angle);
    let drive_angle = p.drive_amplitude * (p.drive_frequency * time).sin();
    let shaft_driven_minus_drive_angle = shaft_driven - drive_angle;
    let shaft_reed_minus_reed_angle = shaft_reed - reed_angle;
    Energy {
        kinetic: (R::literal(0.5) * p.shaft_driven_field_inertia * (shaft_driven_dot
            * shaft_driven_dot)).add_product(R::literal(0.5) * p.reed_mass * (p.reed_arm
            * p.reed_arm), reed_speed * reed_speed).add_product(R::literal(0.5)
            * p.shaft_reed_field_inertia, shaft_reed_dot * shaft_reed_dot)
            .add_product(R::literal(0.5) * p.shaft_middle_field_inertia, shaft_middle_dot
            * shaft_middle_dot),
        potential: (R::literal(0.5) * p.reed_stiffness * (shaft_reed_minus_reed_angle
            * shaft_reed_minus_reed_angle)).add_product(R::literal(0.5) * p.drive_stiffness,
            shaft_driven_minus_drive_angle * shaft_driven_minus_drive_angle)
            .add_product(R::literal(0.5) * p.fell_stiffness, fell_pressed * fell_pressed),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 54 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [shaft_driven, shaft_reed, _, reed_angle, shaft_driven_dot, shaft_reed_dot,
        shaft_middle_dot, reed_speed] = *state;
    let drive_frequency_times_time = p.drive_frequency * time;
    let (sin_drive_frequency_times_time,
        cos_drive_frequency_times_time) = drive_frequency_times_time.sin_cos();
    let drive_angle = p.drive_amplitude * sin_drive_frequency_times_time;
    let reed_angle_plus_held_1 = reed_angle + p.held_1;
    let fell_torque = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0),
        p.fell_stiffness * reed_angle);
    let reed_mass_times_reed_arm_squared = p.reed_mass * (p.reed_arm * p.reed_arm);
    let shaft_driven_minus_drive_angle = shaft_driven - drive_angle;
    let t0 = p.drive_stiffness * shaft_driven_minus_drive_angle;
    let t1 = p.reed_stiffness * (shaft_reed - reed_angle);
    let t2 = R::select_less(reed_angle_plus_held_1, R::literal(0.0), R::literal(0.0), fell_torque);
    let reed_speed_dot = (t1 - t2) * (R::literal(1.0) / reed_mass_times_reed_arm_squared);
    let shaft_middle_dot_dot = p.shaft_middle_field_force * (R::literal(1.0)
        / p.shaft_middle_field_inertia);
    let shaft_reed_dot_dot = (p.shaft_reed_field_force - t1) * (R::literal(1.0)
        / p.shaft_reed_field_inertia);
    let shaft_driven_dot_dot = (p.shaft_driven_field_force - t0) * (R::literal(1.0)
        / p.shaft_driven_field_inertia);
    let t3 = p.drive_stiffness * p.drive_amplitude * p.drive_frequency
        * shaft_driven_minus_drive_angle * cos_drive_frequency_times_time;
    PowerBalance {
        stored_rate: (-t3).add_product(t0, shaft_driven_dot).add_product(t1, shaft_reed_dot)
            .add_product(t2 - t1, reed_speed).add_product(shaft_driven_dot
            * p.shaft_driven_field_inertia, shaft_driven_dot_dot).add_product(shaft_reed_dot
            * p.shaft_reed_field_inertia, shaft_reed_dot_dot).add_product(shaft_middle_dot
            * p.shaft_middle_field_inertia, shaft_middle_dot_dot)
            .add_product(reed_mass_times_reed_arm_squared * reed_speed, reed_speed_dot),
        supplied: (shaft_driven_dot * p.shaft_driven_field_force).add_product(shaft_reed_dot,
            p.shaft_reed_field_force).add_product(shaft_middle_dot, p.shaft_middle_field_force)
            - t3,
        dissipated: R::literal(0.0),
    }
}

/// What passes zero where the rate has a kink or a jump: arguments of `abs` and `sign`, differences
/// of what `min` and `max` compare, ends of tables. No operations.
#[must_use]
pub fn kink_guards<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; KINKS] {
    let [_, _, _, reed_angle, ..] = *state;
    [reed_angle]
}

/// Rates along the motion of what passes zero at kinks. No operations.
#[must_use]
pub fn kink_rates<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; KINKS] {
    let [_, _, _, _, _, _, _, reed_speed] = *state;
    [reed_speed]
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 4] = [(4, 0), (4, 0), (5, 0), (6, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 10] = [(0, 4), (1, 5), (2, 6), (3, 7), (4, 0), (5, 1), (5, 3),
    (7, 1), (7, 3), (8, 3)];
/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 21 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 26] {
    let inverse_shaft_driven_field_inertia = R::literal(1.0) / p.shaft_driven_field_inertia;
    let inverse_shaft_reed_field_inertia = R::literal(1.0) / p.shaft_reed_field_inertia;
    let t0 = R::literal(1.0) / (p.reed_mass * (p.reed_arm * p.reed_arm));
    let t1 = p.reed_stiffness * inverse_shaft_reed_field_inertia;
    [R::literal(0.0), R::literal(0.0),
        p.shaft_driven_field_force * inverse_shaft_driven_field_inertia, R::literal(0.0),
        R::literal(0.0), p.drive_frequency, R::literal(0.0),
        p.drive_amplitude * p.drive_stiffness * inverse_shaft_driven_field_inertia,
        R::literal(0.0), R::literal(0.0),
        p.shaft_reed_field_force * inverse_shaft_reed_field_inertia, R::literal(0.0),
        R::literal(0.0), R::literal(0.0), p.shaft_middle_field_force * (R::literal(1.0)
        / p.shaft_middle_field_inertia), R::literal(0.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), -(p.drive_stiffness
        * inverse_shaft_driven_field_inertia), -t1, t1, p.reed_stiffness * t0,
        -((p.reed_stiffness + R::select_less(p.held_1, R::literal(0.0), R::literal(0.0),
        R::select_less(p.held_1, R::literal(0.0), R::literal(0.0), p.fell_stiffness))) * t0),
        R::literal(1.0)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

/// The field shaft.u: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_u {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 6] = [3, 4, 5, 6, 7, 8];
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
    pub fn inertia_gradient<R: Real>(_x: R, p: &Parameters<R>) -> [R; 7] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(core::f64::consts::TAU) * p.shaft_density * (shaft_radius_squared
            * p.shaft_radius), R::literal(core::f64::consts::FRAC_PI_2) * (shaft_radius_squared
            * shaft_radius_squared), R::literal(0.0), R::literal(0.0)]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x. 7 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        [R::literal(0.0), R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * (shaft_radius_squared * shaft_radius_squared) * u_x_2
            .add_product(p.shaft_damping_time, u_x_dot)]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt. 8 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(_time: R, _x: R, _point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 8] {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            -(t0 * shaft_radius_squared_squared), R::literal(0.0), -(t0 * p.shaft_damping_time
            * shaft_radius_squared_squared)]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`. 13 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(_time: R, _x: R, point: &FieldPoint<R>,
            p: &Parameters<R>) -> [R; 16] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = u_x_2.add_product(p.shaft_damping_time, u_x_dot);
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-6.283_185_307_179_586) * p.shaft_shear_modulus * (shaft_radius_squared
            * p.shaft_radius) * t0, R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(-1.570_796_326_794_896_6) * shaft_radius_squared_squared * t0,
            R::literal(0.0), R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * shaft_radius_squared_squared * u_x_dot]
    }
    /// T and V a length \[J/m\]. 10 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 2] {
        let [_, u_x_2, u_dot, _] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        [R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_density * shaft_radius_squared_squared
            * (u_dot * u_dot), R::literal(core::f64::consts::FRAC_PI_4) * p.shaft_shear_modulus
            * shaft_radius_squared_squared * (u_x_2 * u_x_2)]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\]. 10 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(_time: R, _x: R, point: &FieldPoint<R>, p: &Parameters<R>) -> [R; 3] {
        let [_, u_x_2, _, u_x_dot] = *point;
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        [t0 * shaft_radius_squared_squared * u_x_2 * u_x_dot, R::literal(0.0),
            t0 * p.shaft_damping_time * shaft_radius_squared_squared * (u_x_dot * u_x_dot)]
    }
    /// x of the attachments, then the length \[m\]. No operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 4] {
        [R::literal(0.0), p.shaft_reed_position, p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row. No operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 24] {
        [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(1.0), R::literal(0.0),
            R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
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
    /// 4 operations for all points, 3 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let t0 = R::literal(-1.570_796_326_794_896_6) * p.shaft_shear_modulus
            * (shaft_radius_squared * shaft_radius_squared);
        for ((&u_x_2, &u_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = t0 * u_x_2.add_product(p.shaft_damping_time, u_x_dot);
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 8 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, by_u_x: &mut [R],
            by_u_xt: &mut [R]) {
        let shaft_radius_squared = p.shaft_radius * p.shaft_radius;
        let shaft_radius_squared_squared = shaft_radius_squared * shaft_radius_squared;
        let t0 = R::literal(core::f64::consts::FRAC_PI_2) * p.shaft_shear_modulus;
        let t1 = -(t0 * shaft_radius_squared_squared);
        let t2 = -(t0 * p.shaft_damping_time * shaft_radius_squared_squared);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt) {
            *by_u_x = t1;
            *by_u_xt = t2;
        }
    }
}

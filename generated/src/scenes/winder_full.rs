// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5202d2d35892601f6ba5b28bd27c0b0ed8bb1ecf42433bfc55a02e9e6fb27c60  scenes/winder_full.toml
//   eb674f68fba406afed2e40adeec933d314b879e6c7b1b61caba2bfbf006c57fb  units/textile/pressed_bobbin.toml
//   fa1b5ddc99916b8dd02f89ac526a43dcac856f183bce2271f3569fe77c705a32  units/textile/yarn_layer_one_sided.toml
//   84277344885bd4f7d86b8058ec1e26c987ebdcef7706a8e9ab70c549c0be3761  units/textile/winding_pair.toml
//
// Bobbin on a winding drum, all nonlinearities
//
// The bobbin of `winder_nonlinear` on a layer that only pushes, so that it may leave the drum; the
// package turned by friction, which is lost with the pressure; and the package grows. Third stage
// of modelling. As long as there is contact, its deflection is that of `winder_nonlinear`.
//
// Source:
//   Winder study, third stage of modelling; mass, viscosity, stiffnesses and disturbances of its bench model M5. Arms, speed, radii, frictions and pressure are plausible ones.
//
// All quantities are in SI units.
// Shapes: coordinates 2, first-order states 4, states 8, parameters 30, outputs 8, events 9.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 14 of 8 by 8, parameter_jacobian 51 of 8 by 30.
// Operations: initial_state 5, rate 101, mass_matrix 17, forcing 80, rate_jacobian 183,
//     parameter_jacobian 459, time_derivative 80, outputs 75, energy 59, power_balance 144,
//     guards 63, guard_rates 198, resets 66, prepare 67, prepared_rate 82,
//     prepared_rate_jacobian 159, prepared_jacobians 468.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Bobbin on a winding drum, all nonlinearities
    ///
    /// The bobbin of \`winder_nonlinear\` on a layer that only pushes, so that it may leave the drum; the
    /// package turned by friction, which is lost with the pressure; and the package grows. Third stage
    /// of modelling. As long as there is contact, its deflection is that of \`winder_nonlinear\`.
    ///
    /// Source: Winder study, third stage of modelling; mass, viscosity, stiffnesses and disturbances of its bench model M5. Arms, speed, radii, frictions and pressure are plausible ones.
    WinderFull: "winder_full", "Bobbin on a winding drum, all nonlinearities";
    run from 0.0, until 0.5, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    events; prepared; jacobians_at_once; series 19;
}

::machinist_contract::parameters! {
    winding_speed: 5.5, "m/s", "winding_speed", "speed of the drum's surface";
    drum_radius: 0.05, "m", "drum_radius", "R0, radius of the drum";
    force_amplitude: 25.0, "N", "force_amplitude", "F0, force once a turn of the drum, from its unbalance";
    force_phase: 0.0, "rad", "force_phase", "phase of that force";
    package_force: 0.0, "N", "package_force", "amplitude of the force once a turn of the package";
    package_phase: 0.0, "rad", "package_phase", "phase of that force";
    ovality: 0.0002, "m", "ovality", "Y0, amplitude of the drum's shape twice a turn";
    ovality_phase: 0.0, "rad", "ovality_phase", "phase of that shape";
    eccentricity: 0.0, "m", "eccentricity", "amplitude of the drum's shape once a turn";
    initial_deflection: 0.0, "m", "initial_deflection", "deflection at the start";
    initial_velocity: 0.0, "m/s", "initial_velocity", "velocity at the start";
    holder_bobbin_mass: 1.5, "kg", "holder.bobbin_mass", "m0, mass of bobbin and plate";
    holder_link_mass: 0.9, "kg", "holder.link_mass", "mn, mass of the links";
    holder_link_arm: 0.1, "m", "holder.link_arm", "lbc, arm of the links' mass";
    holder_holder_arm: 0.15, "m", "holder.holder_arm", "lab, arm of the bobbin";
    holder_stiffness: 3800.0, "N/m", "holder.stiffness", "c_p, spring of the holder, reduced to the bobbin's centre";
    holder_preload: 40.0, "N", "holder.preload", "N0, pressure at rest";
    layer_stiffness: 42000.0, "N/m", "layer.stiffness", "c, stiffness of the layer";
    layer_cubic_stiffness: 2e9, "N/m^3", "layer.cubic_stiffness", "c3, stiffening of the layer: a fifth of the stiffness at 2 mm";
    layer_viscosity: 95.0, "N s/m", "layer.viscosity", "h, viscosity of the layer, above zero";
    pair_bobbin_radius: 0.03, "m", "pair.bobbin_radius", "Rmin, radius of the empty bobbin";
    pair_package_radius: 0.03, "m", "pair.package_radius", "radius of the package at the start";
    pair_package_width: 0.15, "m", "pair.package_width", "H, width of the package";
    pair_yarn_density: 350.0, "kg/m^3", "pair.yarn_density", "rho, density of the wound yarn";
    pair_thread_area: 5.7e-8, "m^2", "pair.thread_area", "volume that a length of thread takes up on the package: that of 20 tex";
    pair_bobbin_inertia: 0.0006, "kg m^2", "pair.bobbin_inertia", "moment of inertia of the empty bobbin";
    pair_tension: 0.6, "N", "pair.tension", "Pn, tension of the thread";
    pair_friction: 0.18, "1", "pair.friction", "f, between drum and package";
    pair_support_arm: 0.0004, "m", "pair.support_arm", "fa r, friction of the support times its radius";
    pair_rolling_arm: 0.0006, "m", "pair.rolling_arm", "k, arm of rolling friction";
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the bobbin's centre";
    pressure: "N", "pressure", "N, force of the layer on the bobbin";
    mass: "kg", "mass", "reduced mass m(R)";
    radius: "m", "radius", "R, radius of the package";
    friction: "N", "friction", "friction of the drum on the package";
    slip: "1", "slip", "nu, share by which the package lags behind the drum";
    force: "N", "force", "force disturbance";
    shape: "m", "shape", "shape of the drum";
}

::machinist_contract::states! {
    HOLDER_X: position, 0.001, "m", "holder.x", "deflection of the bobbin's centre";
    PAIR_PHI: position, 1.0, "rad", "pair.phi", "angle of the package";
    HOLDER_V: velocity, 0.1, "m/s", "holder.v", "rate of deflection of the bobbin's centre";
    PAIR_OMEGA: velocity, 100.0, "rad/s", "pair.omega", "rate of angle of the package";
    LAYER_SURFACE: first_order, 0.001, "m", "layer.surface", "s, compression of the layer beyond that at rest, while nothing touches it";
    LAYER_CLOSED: mode, 1.0, "1", "layer.closed", "1 while bobbin and drum touch";
    PAIR_RADIUS: first_order, 0.03, "m", "pair.radius", "R, radius of the package";
    PAIR_SLIP: mode, 1.0, "1", "pair.slip", "-1 while the package lags behind the drum, 0 while it sticks to it, 1 while it runs ahead; -2 while it stands still" as "pair.slip: \\-1 while the package lags behind the drum, 0 while it sticks to it, 1 while it runs ahead; -2 while it stands still \\[1\\].";
}

::machinist_contract::events! {
    "layer.touches": Rising, when [(5, 0.0)], sets [5], "the bobbin is back on the layer";
    "layer.opens": Falling, when [(5, 1.0)], sets [5, 4], "the layer would pull";
    "pair.begins": Rising, when [(7, 0.0)], sets [7], "at the start: whether friction suffices";
    "pair.breaks_back": Rising, when [(7, 0.0)], sets [7], "friction suffices no longer: the package lags behind";
    "pair.breaks_forth": Falling, when [(7, 0.0)], sets [7], "friction suffices no longer: the package runs ahead";
    "pair.ends_back": Rising, when [(7, -1.0)], sets [3, 7], "the package has caught up; it sticks or runs ahead";
    "pair.ends_forth": Falling, when [(7, 1.0)], sets [3, 7], "the drum has caught up; the package sticks or lags behind";
    "pair.halts": Falling, when [(7, -1.0)], sets [3, 7], "friction cannot turn the package, which stands still";
    "pair.turns": Rising, when [(7, -2.0)], sets [7], "friction turns the package again";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [2] 1 [3] 2 [0 1 2 3 6] 3 [0 2 3 6] 4 [2 4] 6 [3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 30 { 2 [0 1 2 3 4 5 6 7 8 11 12 13 14 15 16 17 18 19 20 22 23
        24] 3 [0 1 6 7 8 16 17 18 19 20 22 23 24 25 26 27 28 29] 4 [0 1 6 7 8 16 17 18 19]
        6 [22 24] }
}

::machinist_contract::constants! {
    drum_speed, t1, pair_bobbin_radius_squared, t2, pair_bobbin_radius_squared_squared, t4, t6, t7, t9,
    eccentricity_times_drum_speed, t10, t11, t12, inverse_layer_viscosity, t13,
    minus_layer_viscosity, t14, t15, t0, t3, force_amplitude_over_drum_radius, t16,
    eccentricity_over_drum_radius, t18, t19, t20, t21, t22, t23, t24, t25, t26,
    ovality_times_layer_stiffness, layer_viscosity_times_drum_speed, t27, t28, t29,
    minus_inverse_layer_viscosity, inverse_layer_viscosity_squared, t31, t32, t33, t34, t35, t36,
    t37, t38, t39
}

/// What `rate` and its Jacobians need of the parameters, once a run. 67 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let drum_speed = p.winding_speed / p.drum_radius;
    let t0 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let t1 = R::literal(0.5) * p.pair_thread_area / t0;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let t2 = t0 * p.pair_yarn_density;
    let pair_bobbin_radius_squared_squared = pair_bobbin_radius_squared
        * pair_bobbin_radius_squared;
    let t3 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let t4 = t3 * p.pair_yarn_density;
    let t5 = p.holder_link_mass * p.holder_link_arm;
    let t6 = p.holder_bobbin_mass + t5 / p.holder_holder_arm;
    let t7 = R::literal(2.0) * drum_speed;
    let t8 = R::literal(2.0) * p.ovality;
    let t9 = t8 * drum_speed;
    let eccentricity_times_drum_speed = p.eccentricity * drum_speed;
    let t10 = p.pair_support_arm + p.pair_rolling_arm;
    let t11 = p.pair_yarn_density * p.pair_thread_area;
    let t12 = R::literal(-1.0) / p.layer_viscosity;
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let t13 = R::literal(3.0) * p.layer_cubic_stiffness;
    let minus_layer_viscosity = -p.layer_viscosity;
    let t14 = -t10;
    let t15 = R::literal(core::f64::consts::TAU) * p.pair_package_width * p.pair_yarn_density;
    let force_amplitude_over_drum_radius = p.force_amplitude / p.drum_radius;
    let t16 = t8 / p.drum_radius;
    let eccentricity_over_drum_radius = p.eccentricity / p.drum_radius;
    let t17 = R::literal(4.0) * p.ovality;
    let t18 = t17 * drum_speed / p.drum_radius;
    let t19 = eccentricity_times_drum_speed / p.drum_radius;
    let t20 = p.force_amplitude * drum_speed / p.drum_radius;
    let t21 = t9 / p.drum_radius;
    let drum_speed_squared = drum_speed * drum_speed;
    let t22 = t17 * drum_speed_squared / p.drum_radius;
    let t23 = p.eccentricity * drum_speed_squared / p.drum_radius;
    let t24 = R::literal(2.0) * p.layer_viscosity * drum_speed;
    let t25 = t8 * p.layer_viscosity * drum_speed;
    let t26 = R::literal(3.0) * p.ovality * p.layer_cubic_stiffness;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let layer_viscosity_times_drum_speed = p.layer_viscosity * drum_speed;
    let t27 = p.holder_link_arm / p.holder_holder_arm;
    let t28 = p.holder_link_mass / p.holder_holder_arm;
    let t29 = t5 / (p.holder_holder_arm * p.holder_holder_arm);
    let minus_inverse_layer_viscosity = -inverse_layer_viscosity;
    let inverse_layer_viscosity_squared = R::literal(1.0) / (p.layer_viscosity * p.layer_viscosity);
    let t30 = pair_bobbin_radius_squared * p.pair_bobbin_radius;
    let t31 = t11 * t30;
    let t32 = R::literal(core::f64::consts::TAU) * p.pair_bobbin_radius * p.pair_package_width
        * p.pair_yarn_density;
    let t33 = t15 * t30;
    let t34 = p.pair_bobbin_inertia / p.pair_package_width;
    let t35 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_yarn_density;
    let t36 = R::literal(-3.141_592_653_589_793) * p.pair_yarn_density;
    let t37 = R::literal(-1.0) / p.pair_package_width;
    let t38 = R::literal(-0.25) * p.pair_thread_area;
    let t39 = R::literal(0.5) / t0;
    Constants { drum_speed, t1, pair_bobbin_radius_squared, t2, pair_bobbin_radius_squared_squared,
        t4, t6, t7, t9, eccentricity_times_drum_speed, t10, t11, t12, inverse_layer_viscosity, t13,
        minus_layer_viscosity, t14, t15, t0, t3, force_amplitude_over_drum_radius, t16,
        eccentricity_over_drum_radius, t18, t19, t20, t21, t22, t23, t24, t25, t26,
        ovality_times_layer_stiffness, layer_viscosity_times_drum_speed, t27, t28, t29,
        minus_inverse_layer_viscosity, inverse_layer_viscosity_squared, t31, t32, t33, t34, t35,
        t36, t37, t38, t39 }
}

/// State at the start of the run, in the units of the states. 5 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_deflection, R::literal(0.0), p.initial_velocity,
        p.winding_speed / p.pair_package_radius, p.eccentricity.add_product(p.ovality,
        p.ovality_phase.cos()) - p.initial_deflection, R::literal(1.0), p.pair_package_radius,
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 82 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let t0 = p.ovality_phase.add_product(c.t7, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3), (sin_drum_speed_times_time,
        cos_drum_speed_times_time)] = R::sin_cos_each([p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi, t0, drum_speed_times_time]);
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let pair_growth = c.t1 * pair_omega;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t2 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t4,
        (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let holder_mass = c.t6 + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let t4 = (c.eccentricity_times_drum_speed * sin_drum_speed_times_time).add_product(c.t9, t2)
        + holder_v;
    let layer_compression_rate = -t4;
    let t5 = p.layer_viscosity * t4;
    let t6 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression);
    let layer_push = t6 - t5;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), c.t10 * layer_push / pair_radius);
    let pair_held = pair_resistance - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance)) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t5)).sub_product(c.t11 * holder_v * pair_omega, pair_radius) - (p.holder_preload
        .add_product(p.holder_stiffness, holder_x) + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t6))) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), c.t12 * layer_swelling,
        layer_compression_rate);
    [holder_v, pair_omega, holder_v_dot, pair_omega_dot, layer_surface_dot, R::literal(0.0),
        pair_growth, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 17 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    let [_, _, _, _, _, _, pair_radius, ..] = *state;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    [holder_mass, pair_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 80 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius, pair_slip]
        = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3), (sin_drum_speed_times_time,
        cos_drum_speed_times_time)] = R::sin_cos_each([p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi, t0, drum_speed_times_time]);
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let t4 = p.layer_viscosity * ((p.eccentricity * drum_speed * sin_drum_speed_times_time)
        .add_product(R::literal(2.0) * p.ovality * drum_speed, t2) + holder_v);
    let t5 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression);
    let layer_push = t5 - t4;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius);
    let pair_held = pair_resistance - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let holder_x_forcing = (force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t4)).sub_product(p.pair_yarn_density * p.pair_thread_area * holder_v * pair_omega,
        pair_radius) - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t5));
    let pair_phi_forcing = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance));
    [holder_x_forcing, pair_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 159 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 14] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t0 = p.ovality_phase.add_product(c.t7, time);
    let [(_, t1), (sin_package_phase_plus_pair_phi, cos_package_phase_plus_pair_phi), (t2, t3),
        (sin_drum_speed_times_time, cos_drum_speed_times_time)]
        = R::sin_cos_each([p.force_phase + drum_speed_times_time, package_phase_plus_pair_phi, t0,
        drum_speed_times_time]);
    let pair_growth = c.t1 * pair_omega;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t2 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t4,
        (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let holder_mass = c.t6 + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t4 = p.layer_viscosity * ((c.eccentricity_times_drum_speed * sin_drum_speed_times_time)
        .add_product(c.t9, t2) + holder_v);
    let t5 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression_squared * layer_compression);
    let layer_push = t5 - t4;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t6 = c.t10 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t6 / pair_radius);
    let pair_held = pair_resistance - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t7 = c.t11 * holder_v;
    let t8 = t7 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance)) * inverse_pair_inertia;
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t4)).sub_product(t8, pair_radius) - (p.holder_preload.add_product(p.holder_stiffness,
        holder_x) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t5)))
        * inverse_holder_mass;
    let t9 = p.layer_stiffness.add_product(c.t13, layer_compression_squared);
    let t10 = c.t10 * t9 / pair_radius;
    let t11 = p.pair_friction * t9;
    let t12 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), R::literal(1.0));
    let pair_omega_dot_by_holder_x = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t11, R::select_less(pair_slip,
        R::literal(0.5), -t10, t11)) + t10) * t12) * inverse_pair_inertia;
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t9)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let pair_friction_times_pair_radius = p.pair_friction * pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        p.layer_viscosity * (c.t10 + R::select_less(pair_slip, R::literal(-0.5),
        -pair_friction_times_pair_radius, R::select_less(pair_slip, R::literal(0.5), c.t14,
        pair_friction_times_pair_radius))) * t12) * inverse_pair_inertia;
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t11 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        R::literal(-2.0) * pair_growth * pair_inertia * R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::literal(1.0)) * R::select_less(pair_slip, R::literal(0.5),
        R::literal(1.0), R::literal(0.0)) / pair_radius) * inverse_pair_inertia;
    let holder_v_dot_by_pair_omega = -(t7 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t13, layer_surface
        * layer_surface)), R::literal(0.0));
    let t13 = t6 / pair_radius_squared;
    let t14 = pair_radius_squared * pair_radius;
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t13) + R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), (R::literal(2.0) * pair_omega
        * pair_growth * pair_inertia / t14 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t13)).sub_product(c.t11 * pair_radius, pair_omega * pair_omega),
        R::literal(0.0)))) - pair_resistance).sub_product(c.t15 * t14, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = -(t8.add_product(c.t15 * pair_radius, holder_v_dot)
        * inverse_holder_mass);
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, c.t1]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 468 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 65] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let t0 = p.force_phase + drum_speed_times_time;
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t1 = p.ovality_phase.add_product(c.t7, time);
    let [(t2, t3), (sin_package_phase_plus_pair_phi, cos_package_phase_plus_pair_phi), (t4, t5),
        (sin_drum_speed_times_time, cos_drum_speed_times_time)]
        = R::sin_cos_each([t0, package_phase_plus_pair_phi, t1, drum_speed_times_time]);
    let layer_surface_squared = layer_surface * layer_surface;
    let pair_growth = c.t1 * pair_omega;
    let pair_radius_squared = pair_radius * pair_radius;
    let t6 = pair_radius_squared - c.pair_bobbin_radius_squared;
    let pair_package_mass = c.t2 * t6;
    let t7 = (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t4, t7);
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t3);
    let holder_mass = c.t6 + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t5);
    let layer_compression = shape - holder_x;
    let t8 = (c.eccentricity_times_drum_speed * sin_drum_speed_times_time).add_product(c.t9, t4)
        + holder_v;
    let layer_compression_squared = layer_compression * layer_compression;
    let t9 = layer_compression_squared * layer_compression;
    let t10 = p.layer_viscosity * t8;
    let t11 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, t9);
    let layer_push = t11 - t10;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t12 = c.t10 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t12 / pair_radius);
    let pair_omega_times_pair_growth = pair_omega * pair_growth;
    let pair_held = pair_resistance - pair_omega_times_pair_growth * pair_inertia
        / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t13 = c.t11 * holder_v;
    let t14 = t13 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance)) * inverse_pair_inertia;
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t10)).sub_product(t14, pair_radius) - (p.holder_preload.add_product(p.holder_stiffness,
        holder_x) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t11)))
        * inverse_holder_mass;
    let t15 = c.t13 * layer_compression_squared;
    let t16 = p.layer_stiffness + t15;
    let t17 = c.t10 * t16 / pair_radius;
    let t18 = p.pair_friction * t16;
    let t19 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), R::literal(1.0));
    let pair_omega_dot_by_holder_x = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t18, R::select_less(pair_slip,
        R::literal(0.5), -t17, t18)) + t17) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t16)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let pair_friction_times_pair_radius = p.pair_friction * pair_radius;
    let t20 = -pair_friction_times_pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        p.layer_viscosity * (c.t10 + R::select_less(pair_slip, R::literal(-0.5), t20,
        R::select_less(pair_slip, R::literal(0.5), c.t14, pair_friction_times_pair_radius))) * t19)
        * inverse_pair_inertia;
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t11 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let t21 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::literal(1.0));
    let t22 = R::select_less(pair_slip, R::literal(0.5), R::literal(1.0), R::literal(0.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        R::literal(-2.0) * pair_growth * pair_inertia * t21 * t22 / pair_radius)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_omega = -(t13 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t13, layer_surface_squared)),
        R::literal(0.0));
    let t23 = t12 / pair_radius_squared;
    let pair_omega_squared = pair_omega * pair_omega;
    let t24 = pair_radius_squared * pair_radius;
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t23) + R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), (R::literal(2.0) * pair_omega
        * pair_growth * pair_inertia / t24 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t23)).sub_product(c.t11 * pair_radius, pair_omega_squared),
        R::literal(0.0)))) - pair_resistance).sub_product(c.t15 * t24, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = -(t14.add_product(c.t15 * pair_radius, holder_v_dot)
        * inverse_holder_mass);
    let t25 = layer_surface_squared * layer_surface;
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, t25);
    let layer_compression_rate = -t8;
    let t26 = (c.eccentricity_over_drum_radius * time * sin_drum_speed_times_time)
        .add_product(c.t16 * time, t4);
    let t27 = c.t19 * time;
    let t28 = (c.t18 * time * t5).add_product(c.t16, t4).add_product(t27, cos_drum_speed_times_time)
        .add_product(c.eccentricity_over_drum_radius, sin_drum_speed_times_time);
    let t29 = (p.layer_stiffness * t26).add_product(c.t13 * t26, layer_compression_squared)
        .add_product(p.layer_viscosity, t28);
    let t30 = c.t10 * t29 / pair_radius;
    let t31 = p.pair_friction * t29;
    let pair_omega_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t31,
        R::select_less(pair_slip, R::literal(0.5), -t30, t31)) + t30) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t29).sub_product(c.force_amplitude_over_drum_radius * time, t2)
        * inverse_holder_mass;
    let layer_surface_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t28);
    let t32 = (t27 * sin_drum_speed_times_time).add_product(c.t21 * time, t4);
    let t33 = (c.t21 * t4).add_product(c.t22 * time, t5).add_product(c.t23 * time,
        cos_drum_speed_times_time).add_product(c.t19, sin_drum_speed_times_time);
    let t34 = (p.layer_stiffness * t32).add_product(c.t13 * t32, layer_compression_squared)
        .add_product(p.layer_viscosity, t33);
    let t35 = c.t10 * t34 / pair_radius;
    let t36 = p.pair_friction * t34;
    let pair_omega_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), t36,
        R::select_less(pair_slip, R::literal(0.5), t35, -t36)) - t35) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t34).add_product(c.t20 * time, t2) * inverse_holder_mass;
    let layer_surface_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t33);
    let holder_v_dot_by_force_amplitude = t3 * inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * t2 * inverse_holder_mass);
    let holder_v_dot_by_package_force = cos_package_phase_plus_pair_phi * inverse_holder_mass;
    let t37 = (p.layer_stiffness * t5).add_product(t15, t5).sub_product(c.t24, t4);
    let t38 = c.t10 * t37 / pair_radius;
    let t39 = p.pair_friction * t37;
    let pair_omega_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_radius * (R::select_less(pair_slip, R::literal(-0.5), t39, R::select_less(pair_slip,
        R::literal(0.5), t38, -t39)) - t38) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        t37) * inverse_holder_mass;
    let layer_surface_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(c.t7 * t4));
    let t40 = c.t25 * t5;
    let t41 = c.t26 * layer_compression_squared * t4;
    let t42 = c.ovality_times_layer_stiffness * t4;
    let t43 = t41 + t40 + t42;
    let t44 = c.t10 * t43 / pair_radius;
    let t45 = p.pair_friction * t43;
    let pair_omega_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t45,
        R::select_less(pair_slip, R::literal(0.5), -t44, t45)) + t44) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t40 + (t41 + t42))) * inverse_holder_mass;
    let layer_surface_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(c.t9 * t5));
    let t46 = (p.layer_stiffness * cos_drum_speed_times_time).add_product(t15,
        cos_drum_speed_times_time).sub_product(c.layer_viscosity_times_drum_speed,
        sin_drum_speed_times_time);
    let t47 = c.t10 * t46 / pair_radius;
    let t48 = p.pair_friction * t46;
    let pair_omega_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), t48,
        R::select_less(pair_slip, R::literal(0.5), t47, -t48)) - t47) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t46) * inverse_holder_mass;
    let layer_surface_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(c.drum_speed * sin_drum_speed_times_time));
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t27 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t28 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t29 * holder_v_dot * inverse_holder_mass;
    let holder_v_dot_by_holder_stiffness = -(holder_x * inverse_holder_mass);
    let pair_omega_dot_by_holder_preload = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), pair_friction_times_pair_radius,
        R::select_less(pair_slip, R::literal(0.5), c.t10, t20)) - p.pair_support_arm
        - p.pair_rolling_arm)) * inverse_pair_inertia;
    let holder_v_dot_by_holder_preload = (R::literal(-1.0) - layer_surface_dot_by_holder_v)
        * inverse_holder_mass;
    let layer_surface_dot_by_holder_preload = R::select_less(layer_closed, R::literal(0.5),
        c.minus_inverse_layer_viscosity, R::literal(0.0));
    let t49 = c.t10 * layer_compression / pair_radius;
    let t50 = p.pair_friction * layer_compression;
    let pair_omega_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), t50,
        R::select_less(pair_slip, R::literal(0.5), t49, -t50)) - t49) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), layer_compression) * inverse_holder_mass;
    let layer_surface_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * layer_surface), R::literal(0.0));
    let t51 = c.t10 * t9 / pair_radius;
    let t52 = p.pair_friction * t9;
    let pair_omega_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), t52,
        R::select_less(pair_slip, R::literal(0.5), t51, -t52)) - t51) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t9) * inverse_holder_mass;
    let layer_surface_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * t25), R::literal(0.0));
    let t53 = c.t10 * t8 / pair_radius;
    let t54 = p.pair_friction * t8;
    let pair_omega_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t54,
        R::select_less(pair_slip, R::literal(0.5), -t53, t54)) + t53) * t19) * inverse_pair_inertia;
    let holder_v_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), layer_compression_rate) * inverse_holder_mass;
    let layer_surface_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        c.inverse_layer_viscosity_squared * layer_swelling, R::literal(0.0));
    let pair_omega_dot_by_pair_bobbin_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), c.t31 * pair_omega_squared * t21 * t22 / pair_radius).add_product(c.t33,
        pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_bobbin_radius = c.t32 * holder_v_dot * inverse_holder_mass;
    let pair_omega_dot_by_pair_package_width = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), c.t34 * pair_omega * pair_growth * t21 * t22 / pair_radius)
        .sub_product(c.t35 * t7, pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_package_width = c.t36 * t6 * holder_v_dot * inverse_holder_mass;
    let pair_radius_dot_by_pair_package_width = c.t37 * pair_growth;
    let pair_omega_dot_by_pair_yarn_density = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), c.t38 * t7 * pair_omega_squared * t21 * t22 / pair_radius)
        .sub_product(c.t3 * t7, pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_yarn_density = -((p.pair_thread_area * holder_v * pair_omega
        * pair_radius).add_product(c.t0 * t6, holder_v_dot) * inverse_holder_mass);
    let pair_omega_dot_by_pair_thread_area = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), -(c.t39 * pair_inertia * pair_omega_squared * t21 * t22 / pair_radius))
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_thread_area = -(p.pair_yarn_density * holder_v * pair_omega
        * pair_radius * inverse_holder_mass);
    let pair_radius_dot_by_pair_thread_area = c.t39 * pair_omega;
    let pair_omega_dot_by_pair_bobbin_inertia = (R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), -(pair_omega_times_pair_growth * t21 * t22 / pair_radius))
        - pair_omega_dot) * inverse_pair_inertia;
    let pair_omega_dot_by_pair_tension = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(0.5), pair_radius, R::literal(0.0))) - pair_radius)
        * inverse_pair_inertia;
    let pair_omega_dot_by_pair_friction = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * t19 * R::select_less(pair_slip, R::literal(-0.5),
        layer_push, R::select_less(pair_slip, R::literal(0.5), R::literal(0.0), t10 - t11)))
        * inverse_pair_inertia;
    let layer_push_over_pair_radius = layer_push / pair_radius;
    let pair_omega_dot_by_pair_support_arm = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_radius * (R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), layer_push_over_pair_radius,
        R::literal(0.0))) - layer_push_over_pair_radius) * t19) * inverse_pair_inertia;
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, c.t1, holder_v_dot_by_winding_speed,
        holder_v_dot_by_drum_radius, holder_v_dot_by_force_amplitude, holder_v_dot_by_force_phase,
        holder_v_dot_by_package_force, holder_v_dot_by_pair_phi, holder_v_dot_by_ovality,
        holder_v_dot_by_ovality_phase, holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass, holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm, holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_stiffness, holder_v_dot_by_holder_preload,
        holder_v_dot_by_layer_stiffness, holder_v_dot_by_layer_cubic_stiffness,
        holder_v_dot_by_layer_viscosity, holder_v_dot_by_pair_bobbin_radius,
        holder_v_dot_by_pair_package_width, holder_v_dot_by_pair_yarn_density,
        holder_v_dot_by_pair_thread_area, pair_omega_dot_by_winding_speed,
        pair_omega_dot_by_drum_radius, pair_omega_dot_by_ovality, pair_omega_dot_by_ovality_phase,
        pair_omega_dot_by_eccentricity, pair_omega_dot_by_holder_preload,
        pair_omega_dot_by_layer_stiffness, pair_omega_dot_by_layer_cubic_stiffness,
        pair_omega_dot_by_layer_viscosity, pair_omega_dot_by_pair_bobbin_radius,
        pair_omega_dot_by_pair_package_width, pair_omega_dot_by_pair_yarn_density,
        pair_omega_dot_by_pair_thread_area, pair_omega_dot_by_pair_bobbin_inertia,
        pair_omega_dot_by_pair_tension, pair_omega_dot_by_pair_friction,
        pair_omega_dot_by_pair_support_arm, pair_omega_dot_by_pair_support_arm,
        layer_surface_dot_by_winding_speed, layer_surface_dot_by_drum_radius,
        layer_surface_dot_by_ovality, layer_surface_dot_by_ovality_phase,
        layer_surface_dot_by_eccentricity, layer_surface_dot_by_holder_preload,
        layer_surface_dot_by_layer_stiffness, layer_surface_dot_by_layer_cubic_stiffness,
        layer_surface_dot_by_layer_viscosity, pair_radius_dot_by_pair_package_width,
        pair_radius_dot_by_pair_thread_area]
}

/// Partial derivative of `y'` with respect to time. 80 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [holder_x, _, _, _, _, layer_closed, pair_radius, pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t3, _)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time]);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    let t4 = p.eccentricity * cos_drum_speed_times_time;
    let shape = t4.add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t5 = (p.eccentricity * drum_speed * sin_drum_speed_times_time).add_product(R::literal(2.0)
        * p.ovality * drum_speed, t1);
    let t6 = R::literal(4.0) * p.ovality;
    let drum_speed_squared = drum_speed * drum_speed;
    let t7 = (p.layer_stiffness * t5).add_product(R::literal(3.0) * p.layer_cubic_stiffness * t5,
        layer_compression * layer_compression).add_product(p.layer_viscosity, (p.eccentricity
        * drum_speed_squared * cos_drum_speed_times_time).add_product(t6 * drum_speed_squared, t2));
    let t8 = (p.pair_support_arm + p.pair_rolling_arm) * t7 / pair_radius;
    let t9 = p.pair_friction * t7;
    let pair_omega_dot_by_time = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_radius * (R::select_less(pair_slip, R::literal(-0.5), -t9, R::select_less(pair_slip,
        R::literal(0.5), -t8, t9)) + t8) * R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), R::literal(1.0))) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot_by_time = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t7)
        .sub_product(p.force_amplitude * drum_speed, t3) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot_by_time = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(drum_speed_squared * t4.add_product(t6, t2)));
    [R::literal(0.0), R::literal(0.0), holder_v_dot_by_time, pair_omega_dot_by_time,
        layer_surface_dot_by_time, R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 75 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius, pair_slip]
        = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3), (sin_drum_speed_times_time,
        cos_drum_speed_times_time)] = R::sin_cos_each([p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi, t0, drum_speed_times_time]);
    let pair_sliding = (-p.winding_speed).add_product(pair_omega, pair_radius);
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t4 * p.pair_yarn_density * (pair_radius_squared
        - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * drum_speed
        * sin_drum_speed_times_time).add_product(R::literal(2.0) * p.ovality * drum_speed, t2)
        + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius);
    let pair_held = pair_resistance - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    Outputs {
        deflection: holder_x,
        pressure: R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), layer_push),
        mass: holder_mass,
        radius: pair_radius,
        friction: pair_carried,
        slip: R::literal(-1.0) / p.winding_speed * pair_sliding,
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\]. 59 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let [(_, t0), (_, cos_drum_speed_times_time)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed * time]);
    let layer_surface_squared = layer_surface * layer_surface;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t1 = R::literal(0.25) * p.layer_cubic_stiffness;
    let t2 = R::literal(0.5) * p.layer_stiffness;
    Energy {
        kinetic: (R::literal(0.5) * pair_inertia * (pair_omega * pair_omega))
            .add_product(R::literal(0.5) * holder_mass, holder_v * holder_v),
        potential: (p.holder_preload * holder_x).add_product(R::literal(0.5) * p.holder_stiffness,
            holder_x * holder_x) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
            (t2 * layer_compression_squared).add_product(t1, layer_compression_squared
            * layer_compression_squared).add_product(p.holder_preload, layer_compression)),
        stored: R::select_less(layer_closed, R::literal(0.5), (t2 * layer_surface_squared)
            .add_product(t1, layer_surface_squared * layer_surface_squared)
            .add_product(p.holder_preload, layer_surface), R::literal(0.0)),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 144 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3), (sin_drum_speed_times_time,
        cos_drum_speed_times_time)] = R::sin_cos_each([p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi, t0, drum_speed_times_time]);
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let t5 = t4 * p.pair_yarn_density;
    let pair_package_mass = t5 * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let t6 = (p.eccentricity * drum_speed * sin_drum_speed_times_time).add_product(R::literal(2.0)
        * p.ovality * drum_speed, t2);
    let t7 = t6 + holder_v;
    let layer_compression_rate = -t7;
    let t8 = p.layer_stiffness * layer_compression;
    let t9 = layer_compression * layer_compression * layer_compression;
    let t10 = p.layer_viscosity * t7;
    let t11 = (p.holder_preload + t8).add_product(p.layer_cubic_stiffness, t9);
    let layer_push = t11 - t10;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius);
    let pair_held = pair_resistance - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let t12 = p.pair_yarn_density * p.pair_thread_area;
    let t13 = p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t11);
    let t14 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance));
    let pair_omega_dot = t14 * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t10)).sub_product(t12 * holder_v * pair_omega, pair_radius) - t13) * (R::literal(1.0)
        / holder_mass);
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), -(inverse_layer_viscosity
        * layer_swelling), layer_compression_rate);
    let pair_omega_squared = pair_omega * pair_omega;
    let t15 = pair_radius_squared * pair_radius;
    let t16 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.holder_preload
        * t6).add_product(t8, t6).add_product(p.layer_cubic_stiffness * t6, t9));
    let t17 = (t5 * pair_radius * (holder_v * holder_v)).add_product(t5 * pair_omega_squared, t15)
        * pair_growth;
    PowerBalance {
        stored_rate: t16.add_product(t13, holder_v).add_product(holder_v * holder_mass,
            holder_v_dot).add_product(pair_omega * pair_inertia, pair_omega_dot)
            .add_product(R::select_less(layer_closed, R::literal(0.5), layer_swelling,
            R::literal(0.0)), layer_surface_dot) + t17,
        supplied: (holder_v * force).add_product(pair_omega, t14.add_product(t12
            * pair_omega_squared, t15)) + t16 - t17,
        dissipated: R::select_less(layer_closed, R::literal(0.5), inverse_layer_viscosity
            * (layer_swelling * layer_swelling), p.layer_viscosity * holder_v * t7),
    }
}

/// What passes zero where events happen, one for each event. 63 operations.
#[must_use]
pub fn guards<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time)]
        = R::sin_cos_each([t0, drum_speed_times_time]);
    let pair_sliding = (-p.winding_speed).add_product(pair_omega, pair_radius);
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * drum_speed
        * sin_drum_speed_times_time).add_product(R::literal(2.0) * p.ovality * drum_speed, t1)
        + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3);
    let t4 = pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let layer_touches_guard = layer_compression - layer_surface;
    let pair_breaks_back_guard = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3 - pair_friction_times_layer_push) - t4;
    let pair_breaks_forth_guard = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t3) - t4;
    let pair_turns_guard = pair_limit - pair_resistance;
    [layer_touches_guard, layer_push, time, pair_breaks_back_guard, pair_breaks_forth_guard,
        pair_sliding, pair_sliding, pair_omega, pair_turns_guard]
}

/// `dg/dt` of the guards along the motion. 198 operations.
#[must_use]
pub fn guard_rates<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3), (sin_drum_speed_times_time,
        cos_drum_speed_times_time)] = R::sin_cos_each([p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi, t0, drum_speed_times_time]);
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t4 * p.pair_yarn_density * (pair_radius_squared
        - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        t1);
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * p.holder_link_arm
        / p.holder_holder_arm + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let t5 = R::literal(2.0) * p.ovality;
    let t6 = (p.eccentricity * drum_speed * sin_drum_speed_times_time).add_product(t5 * drum_speed,
        t2);
    let t7 = t6 + holder_v;
    let layer_compression_rate = -t7;
    let layer_compression_squared = layer_compression * layer_compression;
    let t8 = p.layer_viscosity * t7;
    let t9 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression_squared * layer_compression);
    let layer_push = t9 - t8;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t10 = p.pair_support_arm + p.pair_rolling_arm;
    let t11 = t10 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t11 / pair_radius);
    let pair_omega_times_pair_growth = pair_omega * pair_growth;
    let pair_held = pair_resistance - pair_omega_times_pair_growth * pair_inertia
        / pair_radius_squared;
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_held, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let t12 = p.pair_yarn_density * p.pair_thread_area;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance)) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t8)).sub_product(t12 * holder_v * pair_omega, pair_radius) - (p.holder_preload
        .add_product(p.holder_stiffness, holder_x) + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t9))) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), R::literal(-1.0)
        / p.layer_viscosity * layer_swelling, layer_compression_rate);
    let t13 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t14 = p.layer_stiffness.add_product(t13, layer_compression_squared);
    let t15 = t10 * t14 / pair_radius;
    let t16 = p.pair_friction * t14;
    let t17 = t11 / pair_radius_squared;
    let drum_speed_squared = drum_speed * drum_speed;
    let t18 = (p.layer_stiffness * t6).add_product(t13 * t6, layer_compression_squared)
        .add_product(p.layer_viscosity, (p.eccentricity * drum_speed_squared
        * cos_drum_speed_times_time).add_product(R::literal(4.0) * p.ovality * drum_speed_squared,
        t3));
    let t19 = t10 * t18 / pair_radius;
    let t20 = p.pair_friction * t18;
    let layer_touches_guard_rate = -(holder_v.add_product(drum_speed, (p.eccentricity
        * sin_drum_speed_times_time).add_product(t5, t2)) + layer_surface_dot);
    let layer_opens_guard_rate = -t18.add_product(t14, holder_v).add_product(p.layer_viscosity,
        holder_v_dot);
    let t21 = p.layer_viscosity * t10 / pair_radius;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t22 = R::literal(2.0) * pair_growth * pair_inertia / pair_radius_squared * pair_omega_dot;
    let t23 = (R::literal(2.0) * pair_omega * pair_growth * pair_inertia / (pair_radius_squared
        * pair_radius) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t17))
        .sub_product(t12 * pair_radius, pair_omega * pair_omega) * pair_growth;
    let pair_breaks_back_guard_rate = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t20 - t19).add_product(R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t16 - t15), holder_v).add_product(R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), layer_viscosity_times_pair_friction - t21), holder_v_dot)
        - t22 + t23;
    let pair_breaks_forth_guard_rate = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t20 + t19)).add_product(R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t16 + t15)), holder_v).add_product(R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(layer_viscosity_times_pair_friction + t21)),
        holder_v_dot) - t22 + t23;
    let pair_ends_back_guard_rate = pair_omega_times_pair_growth.add_product(pair_radius,
        pair_omega_dot);
    let pair_turns_guard_rate = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t19
        - t20).add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15
        - t16), holder_v).add_product(R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t21 - layer_viscosity_times_pair_friction), holder_v_dot)
        .add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t17),
        pair_growth);
    [layer_touches_guard_rate, layer_opens_guard_rate, R::literal(1.0),
        pair_breaks_back_guard_rate, pair_breaks_forth_guard_rate, pair_ends_back_guard_rate,
        pair_ends_back_guard_rate, pair_omega_dot, pair_turns_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. 66 operations.
#[must_use]
pub fn resets<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [holder_x, _, holder_v, pair_omega, _, layer_closed, pair_radius, ..] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time)]
        = R::sin_cos_each([t0, drum_speed_times_time]);
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * drum_speed
        * sin_drum_speed_times_time).add_product(R::literal(2.0) * p.ovality * drum_speed, t1)
        + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3);
    let t4 = pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_held = pair_resistance - t4;
    let t5 = R::select_less(p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t3) - t4, R::literal(0.0),
        R::literal(-1.0), R::literal(1.0));
    let t6 = R::select_less(pair_limit - pair_held, R::literal(0.0), R::literal(-1.0),
        R::literal(1.0));
    let pair_slip_after_pair_begins = R::literal(0.5) * (t6 - t5);
    let pair_omega_after_pair_ends_back = p.winding_speed / pair_radius;
    let pair_slip_after_pair_ends_back = R::literal(0.5) * (R::literal(1.0) - t5);
    let pair_slip_after_pair_ends_forth = R::literal(0.5) * (t6 - R::literal(1.0));
    [R::literal(1.0), R::literal(0.0), layer_compression, pair_slip_after_pair_begins,
        R::literal(-1.0), R::literal(1.0), pair_omega_after_pair_ends_back,
        pair_slip_after_pair_ends_back, pair_omega_after_pair_ends_back,
        pair_slip_after_pair_ends_forth, R::literal(0.0), R::literal(-2.0), R::literal(-1.0)]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 148 recurrences. 19 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, _) = Lanes::<R, 3>::new(workspace, coefficients.len());
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let t0 = layer_surface * p.layer_stiffness;
    let t1 = layer_surface * layer_surface;
    let t2 = t1 * layer_surface;
    let t3 = t2 * p.layer_cubic_stiffness;
    let t4 = p.holder_preload + t0;
    let layer_swelling = t4 + t3;
    let t5 = R::literal(0.5) * p.pair_thread_area;
    let t6 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let t7 = t5 / t6;
    let pair_growth = pair_omega * t7;
    let t8 = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let t9 = pair_radius * pair_radius;
    let t10 = t9 - t8;
    let t11 = t6 * p.pair_yarn_density;
    let pair_package_mass = t10 * t11;
    let t12 = t8 * t8;
    let t13 = t9 * t9;
    let t14 = t13 - t12;
    let t15 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let t16 = t15 * p.pair_yarn_density;
    let t17 = t14 * t16;
    let pair_inertia = p.pair_bobbin_inertia + t17;
    let t18 = time * drum_speed;
    let t19 = p.force_phase + t18;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = t21 * p.force_amplitude;
    let t23 = p.package_phase + pair_phi;
    let t24 = t23.sin();
    let t25 = t23.cos();
    let t26 = t25 * p.package_force;
    let force = t22 + t26;
    let t27 = p.holder_link_mass * p.holder_link_arm;
    let t28 = t27 / p.holder_holder_arm;
    let t29 = p.holder_bobbin_mass + t28;
    let holder_mass = t29 + pair_package_mass;
    let t30 = R::literal(2.0) * drum_speed;
    let t31 = time * t30;
    let t32 = p.ovality_phase + t31;
    let t33 = t32.sin();
    let t34 = t32.cos();
    let t35 = t34 * p.ovality;
    let t36 = t18.sin();
    let t37 = t18.cos();
    let t38 = t37 * p.eccentricity;
    let shape = t35 + t38;
    let layer_compression = shape - holder_x;
    let t39 = R::literal(2.0) * p.ovality;
    let t40 = t39 * drum_speed;
    let t41 = t33 * t40;
    let t42 = p.eccentricity * drum_speed;
    let t43 = t36 * t42;
    let t44 = t41 + t43;
    let t45 = t44 + holder_v;
    let layer_compression_rate = -t45;
    let t46 = layer_compression * p.layer_stiffness;
    let t47 = layer_compression * layer_compression;
    let t48 = t47 * layer_compression;
    let t49 = t48 * p.layer_cubic_stiffness;
    let t50 = t45 * p.layer_viscosity;
    let t51 = -t50;
    let t52 = p.holder_preload + t46;
    let t53 = t52 + t49;
    let layer_push = t53 - t50;
    let t54 = layer_push * p.pair_friction;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t54);
    let t55 = p.pair_support_arm + p.pair_rolling_arm;
    let t56 = layer_push * t55;
    let t57 = t56 / pair_radius;
    let t58 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t57);
    let pair_resistance = p.pair_tension + t58;
    let t59 = pair_omega * pair_growth;
    let t60 = t59 * pair_inertia;
    let t61 = t60 / t9;
    let pair_held = pair_resistance - t61;
    let t62 = -t54;
    let t63 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t62);
    let t64 = R::select_less(pair_slip, R::literal(0.5), pair_held, t63);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit, t64);
    let t65 = R::literal(1.0) / holder_mass;
    let t66 = R::literal(1.0) / pair_inertia;
    let t67 = p.pair_yarn_density * p.pair_thread_area;
    let t68 = holder_v * t67;
    let t69 = t68 * pair_omega;
    let t70 = t69 * pair_radius;
    let t71 = holder_x * p.holder_stiffness;
    let t72 = -t53;
    let t73 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t72);
    let t74 = p.holder_preload + t71;
    let t75 = t74 + t73;
    let t76 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t51);
    let t77 = force + t76;
    let t78 = t77 - t70;
    let t79 = t78 - t75;
    let t80 = pair_carried - pair_resistance;
    let t81 = pair_radius * t80;
    let t82 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t81);
    let pair_omega_dot = t82 * t66;
    let holder_v_dot = t79 * t65;
    let t83 = R::literal(-1.0) / p.layer_viscosity;
    let t84 = layer_swelling * t83;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), t84,
        layer_compression_rate);
    let inverse_pair_radius = R::literal(1.0) / pair_radius;
    let inverse_t9 = R::literal(1.0) / t9;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let mut t20_before = t20;
    let mut t21_before = t21;
    let mut t33_before = t33;
    let mut t34_before = t34;
    let mut t36_before = t36;
    let mut t37_before = t37;
    let mut rates = [holder_v, pair_omega, holder_v_dot, pair_omega_dot, layer_surface_dot,
        R::literal(0.0), pair_growth, R::literal(0.0)];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [holder_x_k, pair_phi_k, holder_v_k, pair_omega_k, layer_surface_k, _, pair_radius_k,
            ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let t1_k = (layer_surface + layer_surface).mul_add(layer_surface_k, sums[0]);
        let t2_k = layer_surface.mul_add(t1_k, t1.mul_add(layer_surface_k, sums[2]));
        let layer_swelling_k = t2_k.mul_add(p.layer_cubic_stiffness, layer_surface_k
            * p.layer_stiffness);
        let pair_growth_k = pair_omega_k * t7;
        let t9_k = (pair_radius + pair_radius).mul_add(pair_radius_k, sums[1]);
        let t13_k = (t9 + t9).mul_add(t9_k, sums[3]);
        let t20_k = inverse * drum_speed * t21_before;
        let t21_k = -inverse * drum_speed * t20_before;
        let t24_k = pair_phi_k.mul_add(t25, inverse * sums_1[2]);
        let t25_k = -pair_phi_k.mul_add(t24, inverse * sums_1[3]);
        let force_k = t25_k.mul_add(p.package_force, t21_k * p.force_amplitude);
        let t33_k = inverse * t30 * t34_before;
        let t34_k = -inverse * t30 * t33_before;
        let t36_k = inverse * drum_speed * t37_before;
        let t37_k = -inverse * drum_speed * t36_before;
        let shape_k = t37_k.mul_add(p.eccentricity, t34_k * p.ovality);
        let layer_compression_k = shape_k - holder_x_k;
        let t44_k = t36_k.mul_add(t42, t33_k * t40);
        let t45_k = t44_k + holder_v_k;
        let layer_compression_rate_k = -t45_k;
        let t47_k = (layer_compression + layer_compression).mul_add(layer_compression_k, sums_2[1]);
        let t48_k = layer_compression.mul_add(t47_k, t47.mul_add(layer_compression_k, sums_2[2]));
        let t50_k = t45_k * p.layer_viscosity;
        let t51_k = -t50_k;
        let t53_k = t48_k.mul_add(p.layer_cubic_stiffness, layer_compression_k * p.layer_stiffness);
        let layer_push_k = t53_k - t50_k;
        let t54_k = layer_push_k * p.pair_friction;
        let pair_limit_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t54_k);
        let t56_k = layer_push_k * t55;
        let t57_k = (-pair_radius_k).mul_add(t57, t56_k - sums_3[3]) * inverse_pair_radius;
        let t58_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t57_k);
        let t59_k = pair_omega.mul_add(pair_growth_k, pair_growth.mul_add(pair_omega_k, sums_1[0]));
        let t60_k = t59.mul_add(t13_k * t16, pair_inertia.mul_add(t59_k, sums_2[3]));
        let t61_k = (-t9_k).mul_add(t61, t60_k - sums_3[2]) * inverse_t9;
        let pair_held_k = t58_k - t61_k;
        let t62_k = -t54_k;
        let t63_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t62_k);
        let t64_k = R::select_less(pair_slip, R::literal(0.5), pair_held_k, t63_k);
        let pair_carried_k = R::select_less(pair_slip, R::literal(-0.5), pair_limit_k, t64_k);
        let t65_k = -(t9_k * t11).mul_add(t65, sums_3[0]) * inverse_holder_mass;
        let t66_k = -(t13_k * t16).mul_add(t66, sums_3[1]) * inverse_pair_inertia;
        let t68_k = holder_v_k * t67;
        let t69_k = pair_omega.mul_add(t68_k, t68.mul_add(pair_omega_k, sums_1[1]));
        let t70_k = pair_radius.mul_add(t69_k, t69.mul_add(pair_radius_k, sums_2[0]));
        let t72_k = -t53_k;
        let t73_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t72_k);
        let t75_k = holder_x_k * p.holder_stiffness + t73_k;
        let t76_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t51_k);
        let t77_k = force_k + t76_k;
        let t78_k = t77_k - t70_k;
        let t79_k = t78_k - t75_k;
        let t80_k = pair_carried_k - t58_k;
        let t81_k = pair_radius.mul_add(t80_k, t80.mul_add(pair_radius_k, sums_4[1]));
        let t82_k = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t81_k);
        let pair_omega_dot_k = t66.mul_add(t82_k, t82.mul_add(t66_k, sums_4[2]));
        let holder_v_dot_k = t65.mul_add(t79_k, t79.mul_add(t65_k, sums_4[0]));
        let t84_k = layer_swelling_k * t83;
        let layer_surface_dot_k = R::select_less(layer_closed, R::literal(0.5), t84_k,
            layer_compression_rate_k);
        lanes.set(order, [layer_surface_k, pair_radius_k, layer_surface_k, t9_k], [layer_surface_k,
            pair_radius_k, t1_k, t9_k]);
        lanes_1.set(order, [pair_omega_k, pair_omega_k, k * pair_phi_k, k * pair_phi_k],
            [pair_growth_k, t68_k, t25_k, t24_k]);
        lanes_2.set(order, [pair_radius_k, layer_compression_k, layer_compression_k, t13_k * t16],
            [t69_k, layer_compression_k, t47_k, t59_k]);
        lanes_3.set(order, [t9_k * t11, t13_k * t16, t9_k, pair_radius_k], [t65_k, t66_k, t61_k,
            t57_k]);
        lanes_4.set(order, [t65_k, pair_radius_k, t66_k], [t79_k, t80_k, t82_k]);
        t20_before = t20_k;
        t21_before = t21_k;
        t33_before = t33_k;
        t34_before = t34_k;
        t36_before = t36_k;
        t37_before = t37_k;
        rates = [holder_v_k, pair_omega_k, holder_v_dot_k, pair_omega_dot_k, layer_surface_dot_k,
            R::literal(0.0), pair_growth_k, R::literal(0.0)];
    }
}

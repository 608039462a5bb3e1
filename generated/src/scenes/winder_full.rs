// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   b0777112c10792aedb2374cadacd873b6b4d78dfb288e3bc9ed2fc9d027ed5b1  scenes/winder_full.toml
//   496e31a2c43e3bf46e48a1bf46877ff5ab1f1b94d06e928363569cc44f7a3b4f  units/textile/pressed_bobbin.toml
//   4523628caac5f68f1a18bee3f7880ce2eeff3e8fe2b093aa6e909eb732e6e265  units/textile/yarn_layer_one_sided.toml
//   29b14fc823c78edd8ef4b5c4e4491cadea276950db454d4c332f5592bfd9e04c  units/textile/winding_pair.toml
//
// Bobbin on a winding drum, all nonlinearities
//
// The bobbin of `winder_nonlinear` on a one-sided layer, so it may leave the drum. Friction, which is
// lost with the contact force, turns the package, and the package grows. Third stage of modelling.
// While in contact, its deflection is that of `winder_nonlinear`.
//
// Source:
//   Winder study, third stage of modelling; frictions lie within its ranges. Every mass, stiffness, dimension, speed, pressure and disturbance is ours, for the study gives none.
//
// All quantities are in SI units.
// Shapes: coordinates 2, first-order states 4, states 8, parameters 32, outputs 8, discontinuities 1,
//     events 9.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 14 of 8 by 8, parameter_jacobian 55 of 8 by 32.
// Operations: initial_state 5, discontinuities 4, rate 119, mass_matrix 19, forcing 96,
//     rate_jacobian 233, parameter_jacobian 684, time_derivative 138, outputs 91, energy 64,
//     power_balance 177, guards 77, guard_rates 268, resets 81, prepare 70, prepared_rate 100,
//     prepared_rate_jacobian 207, prepared_jacobians 724.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Bobbin on a winding drum, all nonlinearities
    ///
    /// The bobbin of \`winder_nonlinear\` on a one-sided layer, so it may leave the drum. Friction, which is
    /// lost with the contact force, turns the package, and the package grows. Third stage of modelling.
    /// While in contact, its deflection is that of \`winder_nonlinear\`.
    ///
    /// Source: Winder study, third stage of modelling; frictions lie within its ranges. Every mass, stiffness, dimension, speed, pressure and disturbance is ours, for the study gives none.
    WinderFull: "winder_full", "Bobbin on a winding drum, all nonlinearities";
    run from 0.0, until 0.5, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 1;
    events; prepared; jacobians_at_once; series 28 Corners;
}

::machinist_contract::parameters! {
    winding_speed: 5.5, "m/s", "winding_speed", "initial speed of the drum's surface";
    acceleration: 0.0, "m/s^2", "acceleration", "acceleration of the drum's surface; below zero the drum brakes";
    drum_radius: 0.05, "m", "drum_radius", "R0, radius of the drum";
    force_amplitude: 25.0, "N", "force_amplitude", "F0, amplitude of the unbalance force, once per drum revolution";
    force_phase: 0.0, "rad", "force_phase", "phase of the unbalance force";
    package_force: 0.0, "N", "package_force", "amplitude of the force once per package revolution";
    package_phase: 0.0, "rad", "package_phase", "phase of the package force";
    ovality: 0.0002, "m", "ovality", "Y0, amplitude of the drum profile, twice per revolution";
    ovality_phase: 0.0, "rad", "ovality_phase", "phase of the drum profile";
    eccentricity: 0.0, "m", "eccentricity", "amplitude of the drum profile, once per revolution";
    initial_deflection: 0.0, "m", "initial_deflection", "initial deflection";
    initial_velocity: 0.0, "m/s", "initial_velocity", "initial velocity";
    holder_bobbin_mass: 1.5, "kg", "holder.bobbin_mass", "m0, mass of bobbin and plate";
    holder_link_mass: 0.9, "kg", "holder.link_mass", "mn, mass of the links";
    holder_link_arm: 0.1, "m", "holder.link_arm", "lbc, lever arm of the link mass";
    holder_holder_arm: 0.15, "m", "holder.holder_arm", "lab, lever arm of the bobbin";
    holder_stiffness: 3800.0, "N/m", "holder.stiffness", "c_p, stiffness of the holder, reduced to the bobbin centre";
    holder_preload: 40.0, "N", "holder.preload", "N0, contact force at rest";
    layer_stiffness: 42000.0, "N/m", "layer.stiffness", "c, stiffness of the layer";
    layer_cubic_stiffness: 2e9, "N/m^3", "layer.cubic_stiffness", "c3, cubic stiffness of the layer: a fifth of the stiffness at 2 mm";
    layer_viscosity: 95.0, "N s/m", "layer.viscosity", "h, damping of the layer, above zero";
    pair_bobbin_radius: 0.03, "m", "pair.bobbin_radius", "Rmin, radius of the empty bobbin";
    pair_package_radius: 0.03, "m", "pair.package_radius", "initial radius of the package";
    pair_package_width: 0.15, "m", "pair.package_width", "H, width of the package";
    pair_yarn_density: 350.0, "kg/m^3", "pair.yarn_density", "rho, density of the wound yarn";
    pair_thread_area: 5.7e-8, "m^2", "pair.thread_area", "volume on the package per unit length of thread, for 20 tex";
    pair_bobbin_inertia: 0.0006, "kg m^2", "pair.bobbin_inertia", "moment of inertia of the empty bobbin";
    pair_tension: 0.6, "N", "pair.tension", "Pn, tension of the thread";
    pair_friction: 0.18, "1", "pair.friction", "f, coefficient of friction between drum and package";
    pair_support_arm: 0.0004, "m", "pair.support_arm", "fa r, coefficient of support friction times its radius";
    pair_rolling_arm: 0.0006, "m", "pair.rolling_arm", "k, arm of rolling friction";
    pair_greatest_slip: 0.0, "1", "pair.greatest_slip", "greatest elastic slip nu, below 1; at 0 the package sticks";
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the bobbin centre";
    pressure: "N", "pressure", "N, force of the layer on the bobbin";
    mass: "kg", "mass", "reduced mass m(R)";
    radius: "m", "radius", "R, radius of the package";
    friction: "N", "friction", "friction force of the drum on the package";
    slip: "1", "slip", "nu, relative slip of the package behind the drum";
    force: "N", "force", "disturbance force";
    shape: "m", "shape", "drum profile";
}

::machinist_contract::states! {
    HOLDER_X: position, 0.001, "m", "holder.x", "deflection of the bobbin centre";
    PAIR_PHI: position, 1.0, "rad", "pair.phi", "angle of the package";
    HOLDER_V: velocity, 0.1, "m/s", "holder.v", "rate of deflection of the bobbin centre";
    PAIR_OMEGA: velocity, 100.0, "rad/s", "pair.omega", "rate of angle of the package";
    LAYER_SURFACE: first_order, 0.001, "m", "layer.surface", "s, compression of the free layer, relative to rest";
    LAYER_CLOSED: mode, 1.0, "1", "layer.closed", "1 while in contact";
    PAIR_RADIUS: first_order, 0.03, "m", "pair.radius", "R, radius of the package";
    PAIR_SLIP: mode, 1.0, "1", "pair.slip", "-1 while the package slips behind the drum, 0 while it sticks or slips elastically, 1 while it runs ahead; -2 at standstill" as "pair.slip: \\-1 while the package slips behind the drum, 0 while it sticks or slips elastically, 1 while it runs ahead; -2 at standstill \\[1\\].";
}

::machinist_contract::events! {
    "layer.touches": Rising, when [(5, 0.0)], sets [5], "the bobbin meets the layer again";
    "layer.opens": Falling, when [(5, 1.0)], sets [5, 4], "the layer would pull";
    "pair.begins": Rising, when [(7, 0.0)], sets [7], "initial choice of stick or slip";
    "pair.breaks_back": Rising, when [(7, 0.0)], sets [7], "the friction limit is reached: the package slips behind";
    "pair.breaks_forth": Falling, when [(7, 0.0)], sets [7], "the friction limit is reached: the package runs ahead";
    "pair.ends_back": Rising, when [(7, -1.0)], sets [3, 7], "the package catches up: it sticks or runs ahead";
    "pair.ends_forth": Falling, when [(7, 1.0)], sets [3, 7], "the drum catches up: the package sticks or lags behind";
    "pair.halts": Falling, when [(7, -1.0)], sets [3, 7], "the package comes to a standstill";
    "pair.turns": Rising, when [(7, -2.0)], sets [7], "friction turns the package again";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [2] 1 [3] 2 [0 1 2 3 6] 3 [0 2 3 6] 4 [2 4] 6 [3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 32 { 2 [0 1 2 3 4 5 6 7 8 9 12 13 14 15 16 17 18 19 20 21 23
        24 25] 3 [0 1 2 7 8 9 17 18 19 20 21 23 24 25 26 27 28 29 30 31]
        4 [0 1 2 7 8 9 17 18 19 20] 6 [23 25] }
}

::machinist_contract::constants! {
    inverse_drum_radius, t1, t2, pair_bobbin_radius_squared, t3, pair_bobbin_radius_squared_squared,
    t5, t6, t7, t8, t9, t10, inverse_layer_viscosity, t11, minus_layer_viscosity, t12,
    layer_viscosity_times_pair_friction, t13, t14, t0, t4, force_amplitude_over_drum_radius, t15,
    eccentricity_over_drum_radius, t16, t17, ovality_over_drum_radius, t18, t19, t20, t21,
    ovality_times_layer_stiffness, t22, t24, t25, minus_pair_friction,
    minus_inverse_layer_viscosity, inverse_layer_viscosity_squared, t26, t28, t29, t30, t31, t32,
    t33, t34, t35, t36, t37, t38
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 70 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let t0 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let t1 = R::literal(0.5) * p.pair_thread_area / t0;
    let t2 = R::literal(0.5) * p.acceleration;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let t3 = t0 * p.pair_yarn_density;
    let pair_bobbin_radius_squared_squared = pair_bobbin_radius_squared
        * pair_bobbin_radius_squared;
    let t4 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let t5 = t4 * p.pair_yarn_density;
    let holder_link_arm_squared = p.holder_link_arm * p.holder_link_arm;
    let holder_holder_arm_squared = p.holder_holder_arm * p.holder_holder_arm;
    let t6 = p.holder_bobbin_mass + p.holder_link_mass * holder_link_arm_squared
        / holder_holder_arm_squared;
    let t7 = R::literal(2.0) * p.ovality;
    let t8 = p.pair_support_arm + p.pair_rolling_arm;
    let t9 = p.pair_yarn_density * p.pair_thread_area;
    let t10 = R::literal(-1.0) / p.layer_viscosity;
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let t11 = R::literal(3.0) * p.layer_cubic_stiffness;
    let minus_layer_viscosity = -p.layer_viscosity;
    let t12 = p.layer_viscosity * t8;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t13 = -layer_viscosity_times_pair_friction;
    let t14 = R::literal(core::f64::consts::TAU) * p.pair_package_width * p.pair_yarn_density;
    let force_amplitude_over_drum_radius = p.force_amplitude / p.drum_radius;
    let t15 = t7 / p.drum_radius;
    let eccentricity_over_drum_radius = p.eccentricity / p.drum_radius;
    let t16 = R::literal(4.0) * p.ovality / p.drum_radius;
    let t17 = R::literal(0.5) * p.force_amplitude / p.drum_radius;
    let ovality_over_drum_radius = p.ovality / p.drum_radius;
    let t18 = R::literal(0.5) * p.eccentricity / p.drum_radius;
    let t19 = R::literal(2.0) * p.layer_viscosity;
    let t20 = t7 * p.layer_viscosity;
    let t21 = R::literal(3.0) * p.ovality * p.layer_cubic_stiffness;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let t22 = holder_link_arm_squared / holder_holder_arm_squared;
    let t23 = R::literal(2.0) * p.holder_link_mass;
    let t24 = t23 * p.holder_link_arm / holder_holder_arm_squared;
    let t25 = t23 * holder_link_arm_squared / (holder_holder_arm_squared * p.holder_holder_arm);
    let minus_pair_friction = -p.pair_friction;
    let minus_inverse_layer_viscosity = -inverse_layer_viscosity;
    let inverse_layer_viscosity_squared = R::literal(1.0) / (p.layer_viscosity * p.layer_viscosity);
    let t26 = R::literal(core::f64::consts::TAU) * p.acceleration * p.pair_package_width;
    let t27 = pair_bobbin_radius_squared * p.pair_bobbin_radius;
    let t28 = p.pair_yarn_density * t27;
    let t29 = R::literal(core::f64::consts::TAU) * p.pair_bobbin_radius * p.pair_package_width
        * p.pair_yarn_density;
    let t30 = t14 * t27;
    let t31 = R::literal(core::f64::consts::FRAC_PI_2) * p.acceleration * p.pair_yarn_density;
    let t32 = t31 * pair_bobbin_radius_squared_squared;
    let t33 = p.pair_bobbin_inertia / p.pair_package_width;
    let t34 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_yarn_density;
    let t35 = R::literal(-3.141_592_653_589_793) * p.pair_yarn_density;
    let t36 = R::literal(-1.0) / p.pair_package_width;
    let t37 = R::literal(0.5) / t0;
    let t38 = p.pair_friction / p.pair_greatest_slip;
    Constants { inverse_drum_radius, t1, t2, pair_bobbin_radius_squared, t3,
        pair_bobbin_radius_squared_squared, t5, t6, t7, t8, t9, t10, inverse_layer_viscosity, t11,
        minus_layer_viscosity, t12, layer_viscosity_times_pair_friction, t13, t14, t0, t4,
        force_amplitude_over_drum_radius, t15, eccentricity_over_drum_radius, t16, t17,
        ovality_over_drum_radius, t18, t19, t20, t21, ovality_times_layer_stiffness, t22, t24, t25,
        minus_pair_friction, minus_inverse_layer_viscosity, inverse_layer_viscosity_squared, t26,
        t28, t29, t30, t31, t32, t33, t34, t35, t36, t37, t38 }
}

/// State at the start of the run, in the units of the states. 5 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_deflection, R::literal(0.0), p.initial_velocity,
        p.winding_speed / p.pair_package_radius, p.eccentricity.add_product(p.ovality,
        p.ovality_phase.cos()) - p.initial_deflection, R::literal(1.0), p.pair_package_radius,
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. 4 operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    [R::select_less(R::literal(0.0), p.acceleration.abs(), -(p.winding_speed / p.acceleration),
        R::literal(0.0))]
}

/// As `rate`, with the constants of the parameters from `prepare`. 100 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_angle = c.inverse_drum_radius * time * p.winding_speed.add_product(c.t2, time);
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (_, cos_package_phase_plus_pair_phi), (t1, t2),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([p.force_phase + drum_angle,
        p.package_phase + pair_phi, t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = c.inverse_drum_radius * surface_speed;
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let pair_growth = c.t1 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t3 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t5,
        (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared));
    let holder_mass = c.t6 + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t3 = (p.eccentricity * turning * sin_drum_angle).add_product(c.t7 * turning, t1) + holder_v;
    let layer_compression_rate = -t3;
    let t4 = p.layer_viscosity * t3;
    let t5 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression);
    let layer_push = t5 - t4;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), c.t8 * layer_push / pair_radius);
    let pair_held = pair_resistance + pair_inertia * p.acceleration.sub_product(pair_omega,
        pair_growth) / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * (R::literal(1.0) / pair_inertia));
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t4)).sub_product(c.t9 * holder_v * pair_omega, pair_radius) - (p.holder_preload
        .add_product(p.holder_stiffness, holder_x) + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t5))) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), c.t10 * layer_swelling,
        layer_compression_rate);
    [holder_v, pair_omega, holder_v_dot, pair_omega_dot, layer_surface_dot, R::literal(0.0),
        pair_growth, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 19 operations.
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
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    [holder_mass, pair_inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 96 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius, pair_slip]
        = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let drum_angle = inverse_drum_radius * time * p.winding_speed.add_product(R::literal(0.5)
        * p.acceleration, time);
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (_, cos_package_phase_plus_pair_phi), (t1, t2),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([p.force_phase + drum_angle,
        p.package_phase + pair_phi, t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t3 = p.layer_viscosity * ((p.eccentricity * turning * sin_drum_angle)
        .add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let t4 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression);
    let layer_push = t4 - t3;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius);
    let pair_held = pair_resistance + pair_inertia * p.acceleration.sub_product(pair_omega,
        pair_growth) / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let holder_x_forcing = (force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t3)).sub_product(p.pair_yarn_density * p.pair_thread_area * holder_v * pair_omega,
        pair_radius) - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t4));
    let pair_phi_forcing = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance));
    [holder_x_forcing, pair_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 207 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 14] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_angle = c.inverse_drum_radius * time * p.winding_speed.add_product(c.t2, time);
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (sin_package_phase_plus_pair_phi,
        cos_package_phase_plus_pair_phi), (t1, t2), (sin_drum_angle, cos_drum_angle)]
        = R::sin_cos_each([p.force_phase + drum_angle, package_phase_plus_pair_phi, t0,
        drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = c.inverse_drum_radius * surface_speed;
    let pair_growth = c.t1 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t3 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t5,
        (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared));
    let holder_mass = c.t6 + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t3 = p.layer_viscosity * ((p.eccentricity * turning * sin_drum_angle).add_product(c.t7
        * turning, t1) + holder_v);
    let t4 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression_squared * layer_compression);
    let layer_push = t4 - t3;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t5 = c.t8 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t5 / pair_radius);
    let t6 = p.acceleration.sub_product(pair_omega, pair_growth);
    let pair_held = pair_resistance + pair_inertia * t6 / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t7 = c.t9 * holder_v;
    let t8 = t7 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * inverse_pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t3)).sub_product(t8, pair_radius) - (p.holder_preload.add_product(p.holder_stiffness,
        holder_x) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t4)))
        * inverse_holder_mass;
    let t9 = p.layer_stiffness.add_product(c.t11, layer_compression_squared);
    let t10 = c.t8 * t9 / pair_radius;
    let t11 = p.pair_friction * t9;
    let pair_omega_dot_by_holder_x = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t11, R::literal(0.0)) + t10)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t11)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), p.pair_friction * pair_sliding * t9 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t10)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t9)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let t12 = c.t12 / pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t12
        + R::select_less(pair_slip, R::literal(-0.5), c.t13, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), c.layer_viscosity_times_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.layer_viscosity_times_pair_friction * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t12)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t9 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.pair_friction
        * pair_radius * layer_push / pair_elastic)), R::literal(-2.0) * pair_growth * pair_inertia
        / pair_radius_squared) * R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::literal(1.0)) * R::select_less(pair_slip, R::literal(0.5), R::literal(1.0),
        R::literal(0.0)) * inverse_pair_inertia);
    let holder_v_dot_by_pair_omega = -(t7 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t11, layer_surface
        * layer_surface)), R::literal(0.0));
    let t13 = t5 / pair_radius_squared;
    let t14 = pair_radius_squared * pair_radius;
    let t15 = c.t14 * pair_radius;
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t13) + R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(p.pair_friction * pair_omega * layer_push / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -t13).add_product(t15, t6) - R::literal(2.0)
        * pair_inertia * t6 / t14), R::literal(0.0)))) - pair_resistance).sub_product(c.t14 * t14,
        pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = -(t8.add_product(t15, holder_v_dot) * inverse_holder_mass);
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, c.t1]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 724 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 69] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let drum_angle = c.inverse_drum_radius * time * p.winding_speed.add_product(c.t2, time);
    let force_phase_plus_drum_angle = p.force_phase + drum_angle;
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(sin_force_phase_plus_drum_angle, cos_force_phase_plus_drum_angle),
        (sin_package_phase_plus_pair_phi, cos_package_phase_plus_pair_phi), (t1, t2),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([force_phase_plus_drum_angle,
        package_phase_plus_pair_phi, t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let abs_surface_speed = surface_speed.abs();
    let pair_elastic = p.pair_greatest_slip * abs_surface_speed;
    let turning = c.inverse_drum_radius * surface_speed;
    let layer_surface_squared = layer_surface * layer_surface;
    let pair_growth = c.t1 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_radius_squared = pair_radius * pair_radius;
    let t3 = pair_radius_squared - c.pair_bobbin_radius_squared;
    let pair_package_mass = c.t3 * t3;
    let t4 = (-c.pair_bobbin_radius_squared_squared).add_product(pair_radius_squared,
        pair_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(c.t5, t4);
    let holder_mass = c.t6 + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t5 = c.t7 * turning;
    let t6 = (p.eccentricity * turning * sin_drum_angle).add_product(t5, t1) + holder_v;
    let layer_compression_squared = layer_compression * layer_compression;
    let t7 = layer_compression_squared * layer_compression;
    let t8 = p.layer_viscosity * t6;
    let t9 = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, t7);
    let layer_push = t9 - t8;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t10 = c.t8 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t10 / pair_radius);
    let t11 = p.acceleration.sub_product(pair_omega, pair_growth);
    let pair_held = pair_resistance + pair_inertia * t11 / pair_radius_squared;
    let t12 = pair_friction_times_layer_push * pair_sliding;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(t12 / pair_elastic)),
        pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t13 = c.t9 * holder_v;
    let t14 = t13 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * inverse_pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t8)).sub_product(t14, pair_radius) - (p.holder_preload.add_product(p.holder_stiffness,
        holder_x) + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t9)))
        * inverse_holder_mass;
    let t15 = c.t11 * layer_compression_squared;
    let t16 = p.layer_stiffness + t15;
    let t17 = c.t8 * t16 / pair_radius;
    let t18 = p.pair_friction * t16;
    let pair_friction_times_pair_sliding = p.pair_friction * pair_sliding;
    let pair_omega_dot_by_holder_x = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t18, R::literal(0.0)) + t17)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t18)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), pair_friction_times_pair_sliding * t16 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t17)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t16)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let t19 = c.t12 / pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t19
        + R::select_less(pair_slip, R::literal(-0.5), c.t13, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), c.layer_viscosity_times_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.layer_viscosity_times_pair_friction * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t19)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t9 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let t20 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::literal(1.0));
    let t21 = R::select_less(pair_slip, R::literal(0.5), R::literal(1.0), R::literal(0.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.pair_friction
        * pair_radius * layer_push / pair_elastic)), R::literal(-2.0) * pair_growth * pair_inertia
        / pair_radius_squared) * t20 * t21 * inverse_pair_inertia);
    let holder_v_dot_by_pair_omega = -(t13 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t11, layer_surface_squared)),
        R::literal(0.0));
    let t22 = t10 / pair_radius_squared;
    let t23 = pair_radius_squared * pair_radius;
    let t24 = c.t14 * pair_radius;
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t22) + R::select_less(pair_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(p.pair_friction * pair_omega * layer_push / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -t22).add_product(t24, t11) - R::literal(2.0)
        * pair_inertia * t11 / t23), R::literal(0.0)))) - pair_resistance).sub_product(c.t14 * t23,
        pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = -(t14.add_product(t24, holder_v_dot) * inverse_holder_mass);
    let t25 = layer_surface_squared * layer_surface;
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, t25);
    let t26 = c.t15 * time * t1;
    let t27 = c.eccentricity_over_drum_radius * time;
    let t28 = t27 * sin_drum_angle;
    let t29 = t26 + t28;
    let t30 = (c.t16 * time * turning * t2).add_product(c.t15, t1).add_product(t27 * turning,
        cos_drum_angle).add_product(c.eccentricity_over_drum_radius, sin_drum_angle);
    let t31 = (p.layer_stiffness * t29).add_product(c.t11 * t29, layer_compression_squared)
        .add_product(p.layer_viscosity, t30);
    let t32 = c.t8 * t31 / pair_radius;
    let t33 = p.pair_friction * t31;
    let t34 = R::select_less(surface_speed, R::literal(0.0), R::literal(-1.0), R::literal(1.0));
    let pair_elastic_times_abs_surface_speed = pair_elastic * abs_surface_speed;
    let pair_omega_dot_by_winding_speed = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t33, R::literal(0.0)) + t32)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t33)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t12 * t34 / pair_elastic_times_abs_surface_speed
        + pair_friction_times_layer_push / pair_elastic + pair_friction_times_pair_sliding * t31
        / pair_elastic), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t32)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t31).sub_product(c.force_amplitude_over_drum_radius * time,
        sin_force_phase_plus_drum_angle) * inverse_holder_mass;
    let layer_surface_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t30);
    let time_squared = time * time;
    let t35 = (c.t18 * time_squared * sin_drum_angle).add_product(c.ovality_over_drum_radius
        * time_squared, t1);
    let t36 = c.t15 * turning;
    let t37 = (t26.add_product(t36 * time_squared, t2) + t28).add_product(c.t18 * turning
        * time_squared, cos_drum_angle);
    let t38 = (p.layer_stiffness * t35).add_product(c.t11 * t35, layer_compression_squared)
        .add_product(p.layer_viscosity, t37);
    let t39 = c.t8 * t38 / pair_radius;
    let t40 = p.pair_friction * t38;
    let t41 = p.pair_friction * time * layer_push;
    let t42 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t40, R::literal(0.0)) + t39)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t40)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t41 * pair_sliding * t34
        / pair_elastic_times_abs_surface_speed + t41 / pair_elastic
        + pair_friction_times_pair_sliding * t38 / pair_elastic), pair_inertia
        / pair_radius_squared + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t39)), R::literal(0.0)));
    let pair_omega_dot_by_acceleration = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * t42 * inverse_pair_inertia);
    let holder_v_dot_by_acceleration = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t38).sub_product(c.t17 * time_squared, sin_force_phase_plus_drum_angle)
        * inverse_holder_mass;
    let layer_surface_dot_by_acceleration = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t37);
    let t43 = c.eccentricity_over_drum_radius * drum_angle;
    let t44 = (t43 * sin_drum_angle).add_product(c.t15 * drum_angle, t1);
    let t45 = (t36 * t1).add_product(c.t16 * drum_angle * turning, t2).add_product(t43 * turning,
        cos_drum_angle).add_product(c.eccentricity_over_drum_radius * turning, sin_drum_angle);
    let t46 = (p.layer_stiffness * t44).add_product(c.t11 * t44, layer_compression_squared)
        .add_product(p.layer_viscosity, t45);
    let t47 = c.t8 * t46 / pair_radius;
    let t48 = p.pair_friction * t46;
    let pair_omega_dot_by_drum_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t48, R::literal(0.0)) - t47)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t48)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t46
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t47)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t46).add_product(c.force_amplitude_over_drum_radius * drum_angle,
        sin_force_phase_plus_drum_angle) * inverse_holder_mass;
    let layer_surface_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t45);
    let holder_v_dot_by_force_amplitude = cos_force_phase_plus_drum_angle * inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * sin_force_phase_plus_drum_angle
        * inverse_holder_mass);
    let holder_v_dot_by_package_force = cos_package_phase_plus_pair_phi * inverse_holder_mass;
    let t49 = (p.layer_stiffness * t2).add_product(t15, t2).sub_product(c.t19 * turning, t1);
    let t50 = c.t8 * t49 / pair_radius;
    let t51 = p.pair_friction * t49;
    let pair_omega_dot_by_ovality = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), t51, R::literal(0.0)) - t50)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t51)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t49
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t50)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        t49 * inverse_holder_mass);
    let layer_surface_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-2.0) * turning * t1);
    let t52 = c.t20 * turning * t2;
    let t53 = c.t21 * layer_compression_squared * t1;
    let t54 = c.ovality_times_layer_stiffness * t1;
    let t55 = t53 + t52 + t54;
    let t56 = c.t8 * t55 / pair_radius;
    let t57 = p.pair_friction * t55;
    let pair_omega_dot_by_ovality_phase = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t57, R::literal(0.0)) + t56)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t57)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), pair_friction_times_pair_sliding * t55 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t56)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -((t52 + (t53 + t54)) * inverse_holder_mass));
    let layer_surface_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t5 * t2));
    let t58 = (p.layer_stiffness * cos_drum_angle).add_product(t15, cos_drum_angle)
        .sub_product(p.layer_viscosity * turning, sin_drum_angle);
    let t59 = c.t8 * t58 / pair_radius;
    let t60 = p.pair_friction * t58;
    let pair_omega_dot_by_eccentricity = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t60, R::literal(0.0)) - t59)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t60)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t58
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t59)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t58 * inverse_holder_mass);
    let layer_surface_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(turning * sin_drum_angle));
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t22 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t24 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t25 * holder_v_dot * inverse_holder_mass;
    let holder_v_dot_by_holder_stiffness = -(holder_x * inverse_holder_mass);
    let t61 = c.t8 / pair_radius;
    let pair_omega_dot_by_holder_preload = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), p.pair_friction,
        R::literal(0.0)) - t61) + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), c.minus_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_pair_sliding / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t61)), R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_holder_preload = (R::literal(-1.0) - layer_surface_dot_by_holder_v)
        * inverse_holder_mass;
    let layer_surface_dot_by_holder_preload = R::select_less(layer_closed, R::literal(0.5),
        c.minus_inverse_layer_viscosity, R::literal(0.0));
    let t62 = c.t8 * layer_compression / pair_radius;
    let t63 = p.pair_friction * layer_compression;
    let pair_omega_dot_by_layer_stiffness = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t63, R::literal(0.0)) - t62)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t63)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(t63 * pair_sliding / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t62)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), layer_compression * inverse_holder_mass);
    let layer_surface_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * layer_surface), R::literal(0.0));
    let t64 = c.t8 * t7 / pair_radius;
    let t65 = p.pair_friction * t7;
    let pair_omega_dot_by_layer_cubic_stiffness = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t65, R::literal(0.0)) - t64)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t65)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t7 / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t64)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t7 * inverse_holder_mass);
    let layer_surface_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * t25), R::literal(0.0));
    let t66 = c.t8 * t6 / pair_radius;
    let t67 = p.pair_friction * t6;
    let pair_omega_dot_by_layer_viscosity = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t67, R::literal(0.0)) + t66)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t67)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t67 * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t66)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t6 * inverse_holder_mass));
    let layer_surface_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        c.inverse_layer_viscosity_squared * layer_swelling, R::literal(0.0));
    let pair_omega_squared = pair_omega * pair_omega;
    let t68 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), R::literal(1.0));
    let pair_omega_dot_by_pair_bobbin_radius = R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), c.t28 * (-c.t26).add_product(p.pair_thread_area,
        pair_omega_squared) * t68 * t20 * t21 / pair_radius).add_product(c.t30, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_bobbin_radius = c.t29 * holder_v_dot * inverse_holder_mass;
    let pair_omega_dot_by_pair_package_width = R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(0.5), (c.t33 * pair_omega * pair_growth / pair_radius)
        .add_product(c.t31, t23) - c.t32 / pair_radius, R::literal(0.0))))).sub_product(c.t34 * t4,
        pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_package_width = c.t35 * t3 * holder_v_dot * inverse_holder_mass;
    let pair_radius_dot_by_pair_package_width = c.t36 * pair_growth;
    let pair_omega_dot_by_pair_yarn_density = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), c.t4 * t11 * t4 * t68 * t20 * t21 / pair_radius).sub_product(c.t4 * t4,
        pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_yarn_density = -((p.pair_thread_area * holder_v * pair_omega
        * pair_radius).add_product(c.t0 * t3, holder_v_dot) * inverse_holder_mass);
    let pair_omega_dot_by_pair_thread_area = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), -(c.t37 * pair_inertia * pair_omega_squared * t68 * t20 * t21
        / pair_radius * inverse_pair_inertia));
    let holder_v_dot_by_pair_thread_area = -(p.pair_yarn_density * holder_v * pair_omega
        * pair_radius * inverse_holder_mass);
    let pair_radius_dot_by_pair_thread_area = c.t37 * pair_omega;
    let pair_omega_dot_by_pair_bobbin_inertia = (R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), t11 * t68 * t20 * t21 / pair_radius)
        - pair_omega_dot) * inverse_pair_inertia;
    let pair_omega_dot_by_pair_tension = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), t21))
        - R::literal(1.0)) * inverse_pair_inertia);
    let pair_omega_dot_by_pair_friction = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), layer_push, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        -(layer_push * pair_sliding / pair_elastic), R::literal(0.0))), R::literal(0.0))
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), t8 - t9)))) * inverse_pair_inertia);
    let layer_push_over_pair_radius = layer_push / pair_radius;
    let pair_omega_dot_by_pair_support_arm = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), layer_push_over_pair_radius, R::literal(0.0)))))
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -layer_push_over_pair_radius)) * inverse_pair_inertia);
    let pair_omega_dot_by_pair_greatest_slip = R::select_less(R::literal(0.0),
        p.pair_greatest_slip, c.t38 * pair_radius * layer_push * pair_sliding
        * R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::literal(1.0)) * t68
        * t20 * t21 / pair_elastic * inverse_pair_inertia, R::literal(0.0));
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, c.t1, holder_v_dot_by_winding_speed,
        holder_v_dot_by_acceleration, holder_v_dot_by_drum_radius, holder_v_dot_by_force_amplitude,
        holder_v_dot_by_force_phase, holder_v_dot_by_package_force, holder_v_dot_by_pair_phi,
        holder_v_dot_by_ovality, holder_v_dot_by_ovality_phase, holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass, holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm, holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_stiffness, holder_v_dot_by_holder_preload,
        holder_v_dot_by_layer_stiffness, holder_v_dot_by_layer_cubic_stiffness,
        holder_v_dot_by_layer_viscosity, holder_v_dot_by_pair_bobbin_radius,
        holder_v_dot_by_pair_package_width, holder_v_dot_by_pair_yarn_density,
        holder_v_dot_by_pair_thread_area, pair_omega_dot_by_winding_speed,
        pair_omega_dot_by_acceleration, pair_omega_dot_by_drum_radius, pair_omega_dot_by_ovality,
        pair_omega_dot_by_ovality_phase, pair_omega_dot_by_eccentricity,
        pair_omega_dot_by_holder_preload, pair_omega_dot_by_layer_stiffness,
        pair_omega_dot_by_layer_cubic_stiffness, pair_omega_dot_by_layer_viscosity,
        pair_omega_dot_by_pair_bobbin_radius, pair_omega_dot_by_pair_package_width,
        pair_omega_dot_by_pair_yarn_density, pair_omega_dot_by_pair_thread_area,
        pair_omega_dot_by_pair_bobbin_inertia, pair_omega_dot_by_pair_tension,
        pair_omega_dot_by_pair_friction, pair_omega_dot_by_pair_support_arm,
        pair_omega_dot_by_pair_support_arm, pair_omega_dot_by_pair_greatest_slip,
        layer_surface_dot_by_winding_speed, layer_surface_dot_by_acceleration,
        layer_surface_dot_by_drum_radius, layer_surface_dot_by_ovality,
        layer_surface_dot_by_ovality_phase, layer_surface_dot_by_eccentricity,
        layer_surface_dot_by_holder_preload, layer_surface_dot_by_layer_stiffness,
        layer_surface_dot_by_layer_cubic_stiffness, layer_surface_dot_by_layer_viscosity,
        pair_radius_dot_by_pair_package_width, pair_radius_dot_by_pair_thread_area]
}

/// Partial derivative of `y'` with respect to time. 138 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [holder_x, _, holder_v, pair_omega, _, layer_closed, pair_radius, pair_slip] = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let t0 = R::literal(0.5) * p.acceleration;
    let t1 = p.winding_speed.add_product(t0, time);
    let drum_angle = inverse_drum_radius * time * t1;
    let t2 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(t3, t4), (sin_drum_angle, cos_drum_angle), (sin_force_phase_plus_drum_angle, _)]
        = R::sin_cos_each([t2, drum_angle, p.force_phase + drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let abs_surface_speed = surface_speed.abs();
    let pair_elastic = p.pair_greatest_slip * abs_surface_speed;
    let turning = inverse_drum_radius * surface_speed;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t5 = R::literal(2.0) * p.ovality * turning;
    let eccentricity_times_turning = p.eccentricity * turning;
    let layer_compression_squared = layer_compression * layer_compression;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression_squared * layer_compression)
        .sub_product(p.layer_viscosity, (eccentricity_times_turning * sin_drum_angle)
        .add_product(t5, t3) + holder_v);
    let t6 = (inverse_drum_radius * t1).add_product(t0 / p.drum_radius, time);
    let t7 = (R::literal(2.0) / p.drum_radius * t1).add_product(p.acceleration / p.drum_radius,
        time);
    let t8 = (p.eccentricity * t6 * sin_drum_angle).add_product(p.ovality * t7, t3);
    let t9 = (R::literal(2.0) * p.acceleration * p.ovality / p.drum_radius * t3).add_product(t5
        * t7, t4).add_product(p.acceleration * p.eccentricity / p.drum_radius, sin_drum_angle)
        .add_product(eccentricity_times_turning * t6, cos_drum_angle);
    let t10 = (p.layer_stiffness * t8).add_product(R::literal(3.0) * p.layer_cubic_stiffness * t8,
        layer_compression_squared).add_product(p.layer_viscosity, t9);
    let t11 = (p.pair_support_arm + p.pair_rolling_arm) * t10 / pair_radius;
    let t12 = p.pair_friction * t10;
    let t13 = p.acceleration * p.pair_friction * layer_push;
    let t14 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), t12)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t13 * pair_sliding * R::select_less(surface_speed,
        R::literal(0.0), R::literal(-1.0), R::literal(1.0)) / (pair_elastic * abs_surface_speed)
        + t13 / pair_elastic + p.pair_friction * pair_sliding * t10 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t11)), R::literal(0.0)));
    let pair_omega_dot_by_time = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t12, R::literal(0.0)) + t11) + t14)
        * (R::literal(1.0) / pair_inertia));
    let holder_v_dot_by_time = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t10)
        .sub_product(p.force_amplitude * t6, sin_force_phase_plus_drum_angle) * (R::literal(1.0)
        / holder_mass);
    let layer_surface_dot_by_time = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t9);
    [R::literal(0.0), R::literal(0.0), holder_v_dot_by_time, pair_omega_dot_by_time,
        layer_surface_dot_by_time, R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 91 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius, pair_slip]
        = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let drum_angle = inverse_drum_radius * time * p.winding_speed.add_product(R::literal(0.5)
        * p.acceleration, time);
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (_, cos_package_phase_plus_pair_phi), (t1, t2),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([p.force_phase + drum_angle,
        p.package_phase + pair_phi, t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let t3 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t3 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t3 * p.pair_yarn_density * (pair_radius_squared
        - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * turning
        * sin_drum_angle).add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius);
    let pair_held = pair_resistance + pair_inertia * p.acceleration.sub_product(pair_omega,
        pair_growth) / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    Outputs {
        deflection: holder_x,
        pressure: R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), layer_push),
        mass: holder_mass,
        radius: pair_radius,
        friction: pair_carried,
        slip: -(pair_sliding / surface_speed),
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\]. 64 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..] = *state;
    let drum_angle = R::literal(1.0) / p.drum_radius * time * p.winding_speed
        .add_product(R::literal(0.5) * p.acceleration, time);
    let [(_, t0), (_, cos_drum_angle)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0), drum_angle), drum_angle]);
    let layer_surface_squared = layer_surface * layer_surface;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t0);
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

/// `dE/dt`, power supplied and power dissipated \[W\]. 177 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let t0 = R::literal(0.5) * p.acceleration;
    let t1 = p.winding_speed.add_product(t0, time);
    let drum_angle = inverse_drum_radius * time * t1;
    let t2 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (_, cos_package_phase_plus_pair_phi), (t3, t4),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([p.force_phase + drum_angle,
        p.package_phase + pair_phi, t2, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let t5 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t5 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let t6 = t5 * p.pair_yarn_density;
    let pair_package_mass = t6 * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t7 = (p.eccentricity * turning * sin_drum_angle).add_product(R::literal(2.0) * p.ovality
        * turning, t3) + holder_v;
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
    let pair_held = pair_resistance + pair_inertia * p.acceleration.sub_product(pair_omega,
        pair_growth) / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let t12 = p.pair_yarn_density * p.pair_thread_area;
    let t13 = p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t11);
    let t14 = pair_radius * (pair_carried - pair_resistance);
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t14
        * (R::literal(1.0) / pair_inertia));
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t10)).sub_product(t12 * holder_v * pair_omega, pair_radius) - t13) * (R::literal(1.0)
        / holder_mass);
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), -(inverse_layer_viscosity
        * layer_swelling), layer_compression_rate);
    let t15 = pair_radius_squared * pair_radius;
    let pair_omega_squared = pair_omega * pair_omega;
    let t16 = (p.eccentricity * (inverse_drum_radius * t1).add_product(t0 / p.drum_radius, time)
        * sin_drum_angle).add_product(p.ovality * (R::literal(2.0) / p.drum_radius * t1)
        .add_product(p.acceleration / p.drum_radius, time), t3);
    let t17 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.holder_preload
        * t16).add_product(t8, t16).add_product(p.layer_cubic_stiffness * t16, t9));
    let t18 = (t6 * pair_radius * (holder_v * holder_v)).add_product(t6 * pair_omega_squared, t15)
        * pair_growth;
    PowerBalance {
        stored_rate: t17.add_product(t13, holder_v).add_product(holder_v * holder_mass,
            holder_v_dot).add_product(pair_omega * pair_inertia, pair_omega_dot)
            .add_product(R::select_less(layer_closed, R::literal(0.5), layer_swelling,
            R::literal(0.0)), layer_surface_dot) + t18,
        supplied: (holder_v * force).add_product(pair_omega, R::select_less(pair_slip,
            R::literal(-1.5), R::literal(0.0), t14).add_product(t12 * pair_omega_squared, t15))
            + t17 - t18,
        dissipated: R::select_less(layer_closed, R::literal(0.5), inverse_layer_viscosity
            * (layer_swelling * layer_swelling), p.layer_viscosity * holder_v * t7),
    }
}

/// What passes zero where events happen, one for each event. 77 operations.
#[must_use]
pub fn guards<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..] = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let drum_angle = inverse_drum_radius * time * p.winding_speed.add_product(R::literal(0.5)
        * p.acceleration, time);
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(t1, t2), (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * turning
        * sin_drum_angle).add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3);
    let layer_touches_guard = layer_compression - layer_surface;
    let pair_sliding_plus_pair_elastic = pair_sliding + pair_elastic;
    let t4 = p.pair_tension + pair_inertia * p.acceleration.sub_product(pair_omega, pair_growth)
        / pair_radius_squared;
    let pair_breaks_back_guard = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        -pair_sliding_plus_pair_elastic, t4 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3 - pair_friction_times_layer_push));
    let pair_breaks_forth_guard = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        pair_elastic - pair_sliding, t4 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t3));
    let pair_ends_forth_guard = pair_sliding - pair_elastic;
    let pair_turns_guard = pair_limit - pair_resistance;
    [layer_touches_guard, layer_push, time, pair_breaks_back_guard, pair_breaks_forth_guard,
        pair_sliding_plus_pair_elastic, pair_ends_forth_guard, pair_omega, pair_turns_guard]
}

/// `dg/dt` of the guards along the motion. 268 operations.
#[must_use]
pub fn guard_rates<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let t0 = R::literal(0.5) * p.acceleration;
    let t1 = p.winding_speed.add_product(t0, time);
    let drum_angle = inverse_drum_radius * time * t1;
    let t2 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(_, cos_force_phase_plus_drum_angle), (_, cos_package_phase_plus_pair_phi), (t3, t4),
        (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([p.force_phase + drum_angle,
        p.package_phase + pair_phi, t2, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let layer_swelling = p.holder_preload.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let t5 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t5 * pair_omega;
    let pair_sliding = (-surface_speed).add_product(pair_omega, pair_radius);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t5 * p.pair_yarn_density * (pair_radius_squared
        - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t6 = R::literal(2.0) * p.ovality * turning;
    let eccentricity_times_turning = p.eccentricity * turning;
    let t7 = (eccentricity_times_turning * sin_drum_angle).add_product(t6, t3) + holder_v;
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
    let t12 = p.acceleration - pair_omega_times_pair_growth;
    let pair_held = pair_resistance + pair_inertia * t12 / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * (R::literal(1.0) / pair_inertia));
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t8)).sub_product(p.pair_yarn_density * p.pair_thread_area * holder_v * pair_omega,
        pair_radius) - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t9))) * (R::literal(1.0)
        / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), R::literal(-1.0)
        / p.layer_viscosity * layer_swelling, layer_compression_rate);
    let t13 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t14 = p.layer_stiffness.add_product(t13, layer_compression_squared);
    let t15 = t10 * t14 / pair_radius;
    let t16 = p.pair_friction * t14;
    let t17 = p.layer_viscosity * t10 / pair_radius;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t18 = t11 / pair_radius_squared;
    let t19 = R::select_less(surface_speed, R::literal(0.0), R::literal(-1.0), R::literal(1.0));
    let t20 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::literal(1.0));
    let t21 = (inverse_drum_radius * t1).add_product(t0 / p.drum_radius, time);
    let t22 = (R::literal(2.0) / p.drum_radius * t1).add_product(p.acceleration / p.drum_radius,
        time);
    let t23 = (p.eccentricity * t21 * sin_drum_angle).add_product(p.ovality * t22, t3);
    let t24 = R::literal(2.0) * p.acceleration * p.ovality;
    let acceleration_times_eccentricity = p.acceleration * p.eccentricity;
    let t25 = (p.layer_stiffness * t23).add_product(t13 * t23, layer_compression_squared)
        .add_product(p.layer_viscosity, (t24 / p.drum_radius * t3).add_product(t6 * t22, t4)
        .add_product(acceleration_times_eccentricity / p.drum_radius, sin_drum_angle)
        .add_product(eccentricity_times_turning * t21, cos_drum_angle));
    let t26 = t10 * t25 / pair_radius;
    let t27 = p.pair_friction * t25;
    let layer_touches_guard_rate = (-holder_v).add_product(inverse_drum_radius, (R::literal(-2.0)
        * p.winding_speed * p.ovality * t3).sub_product(t24 * time, t3)
        .sub_product(acceleration_times_eccentricity * time, sin_drum_angle)
        .sub_product(p.winding_speed * p.eccentricity, sin_drum_angle)) - layer_surface_dot;
    let layer_opens_guard_rate = -t25.add_product(t14, holder_v).add_product(p.layer_viscosity,
        holder_v_dot);
    let t28 = p.acceleration * p.pair_greatest_slip * t19;
    let t29 = R::select_less(R::literal(0.0), p.pair_greatest_slip, -pair_radius, R::literal(-2.0)
        * pair_growth * pair_inertia / pair_radius_squared) * pair_omega_dot;
    let t30 = R::select_less(R::literal(0.0), p.pair_greatest_slip, -pair_omega,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t18)
        .add_product(R::literal(core::f64::consts::TAU) * p.pair_package_width
        * p.pair_yarn_density * pair_radius, t12) - R::literal(2.0) * pair_inertia * t12
        / (pair_radius_squared * pair_radius)) * pair_growth;
    let pair_breaks_back_guard_rate = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        p.acceleration - t28, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t27
        - t26)).add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip, R::literal(0.0),
        (t16 - t15) * t20), holder_v).add_product(R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), (layer_viscosity_times_pair_friction - t17) * t20),
        holder_v_dot) + t29 + t30;
    let pair_breaks_forth_guard_rate = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        p.acceleration + t28, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(t27 + t26))).add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), -((t16 + t15) * t20)), holder_v)
        .add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip, R::literal(0.0),
        -((layer_viscosity_times_pair_friction + t17) * t20)), holder_v_dot) + t29 + t30;
    let pair_radius_times_pair_omega_dot = pair_radius * pair_omega_dot;
    let pair_ends_back_guard_rate = t28 - p.acceleration + pair_radius_times_pair_omega_dot
        + pair_omega_times_pair_growth;
    let pair_ends_forth_guard_rate = pair_radius_times_pair_omega_dot.sub_product(p.acceleration,
        R::literal(1.0).add_product(p.pair_greatest_slip, t19)) + pair_omega_times_pair_growth;
    let pair_turns_guard_rate = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t26
        - t27).add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15
        - t16), holder_v).add_product(R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t17 - layer_viscosity_times_pair_friction), holder_v_dot)
        .add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t18),
        pair_growth);
    [layer_touches_guard_rate, layer_opens_guard_rate, R::literal(1.0),
        pair_breaks_back_guard_rate, pair_breaks_forth_guard_rate, pair_ends_back_guard_rate,
        pair_ends_forth_guard_rate, pair_omega_dot, pair_turns_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. 81 operations.
#[must_use]
pub fn resets<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [holder_x, _, holder_v, pair_omega, _, layer_closed, pair_radius, ..] = *state;
    let inverse_drum_radius = R::literal(1.0) / p.drum_radius;
    let drum_angle = inverse_drum_radius * time * p.winding_speed.add_product(R::literal(0.5)
        * p.acceleration, time);
    let t0 = p.ovality_phase.add_product(R::literal(2.0), drum_angle);
    let [(t1, t2), (sin_drum_angle, cos_drum_angle)] = R::sin_cos_each([t0, drum_angle]);
    let surface_speed = p.winding_speed.add_product(p.acceleration, time);
    let pair_elastic = p.pair_greatest_slip * surface_speed.abs();
    let turning = inverse_drum_radius * surface_speed;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / (R::literal(core::f64::consts::PI)
        * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = p.holder_preload.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * turning
        * sin_drum_angle).add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t3);
    let t4 = pair_inertia * p.acceleration.sub_product(pair_omega, pair_growth)
        / pair_radius_squared;
    let pair_held = pair_resistance + t4;
    let t5 = R::select_less(p.pair_tension + t4 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t3), R::literal(0.0), R::literal(-1.0),
        R::literal(1.0));
    let t6 = R::select_less(pair_limit - pair_held, R::literal(0.0), R::literal(-1.0),
        R::literal(1.0));
    let pair_slip_after_pair_begins = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (t6 - t5));
    let pair_omega_after_pair_ends_back = (surface_speed - pair_elastic) / pair_radius;
    let pair_slip_after_pair_ends_back = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (R::literal(1.0) - t5));
    let pair_omega_after_pair_ends_forth = (pair_elastic + surface_speed) / pair_radius;
    let pair_slip_after_pair_ends_forth = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (t6 - R::literal(1.0)));
    [R::literal(1.0), R::literal(0.0), layer_compression, pair_slip_after_pair_begins,
        R::literal(-1.0), R::literal(1.0), pair_omega_after_pair_ends_back,
        pair_slip_after_pair_ends_back, pair_omega_after_pair_ends_forth,
        pair_slip_after_pair_ends_forth, R::literal(0.0), R::literal(-2.0), R::literal(-1.0)]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 170 recurrences. 28 sums of products an order.
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
    let (mut lanes_6, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed, pair_radius,
        pair_slip] = *state;
    let t0 = time * p.acceleration;
    let surface_speed = p.winding_speed + t0;
    let t1 = -surface_speed;
    let t2 = R::select_less(surface_speed, R::literal(0.0), t1, surface_speed);
    let pair_elastic = t2 * p.pair_greatest_slip;
    let t3 = R::literal(1.0) / p.drum_radius;
    let t4 = layer_surface * p.layer_stiffness;
    let t5 = layer_surface * layer_surface;
    let t6 = t5 * layer_surface;
    let t7 = t6 * p.layer_cubic_stiffness;
    let t8 = p.holder_preload + t4;
    let layer_swelling = t8 + t7;
    let t9 = R::literal(0.5) * p.pair_thread_area;
    let t10 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let t11 = t9 / t10;
    let pair_growth = pair_omega * t11;
    let t12 = pair_omega * pair_radius;
    let pair_sliding = t12 - surface_speed;
    let t13 = R::literal(0.5) * p.acceleration;
    let t14 = time * t13;
    let t15 = p.winding_speed + t14;
    let t16 = time * t3;
    let drum_angle = t16 * t15;
    let t17 = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let t18 = pair_radius * pair_radius;
    let t19 = t18 - t17;
    let t20 = t10 * p.pair_yarn_density;
    let pair_package_mass = t19 * t20;
    let t21 = t17 * t17;
    let t22 = t18 * t18;
    let t23 = t22 - t21;
    let t24 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let t25 = t24 * p.pair_yarn_density;
    let t26 = t23 * t25;
    let pair_inertia = p.pair_bobbin_inertia + t26;
    let t27 = p.holder_link_arm * p.holder_link_arm;
    let t28 = p.holder_holder_arm * p.holder_holder_arm;
    let t29 = p.holder_link_mass * t27;
    let t30 = t29 / t28;
    let t31 = p.holder_bobbin_mass + t30;
    let holder_mass = t31 + pair_package_mass;
    let t32 = p.force_phase + drum_angle;
    let t33 = t32.sin();
    let t34 = t32.cos();
    let t35 = t34 * p.force_amplitude;
    let t36 = p.package_phase + pair_phi;
    let t37 = t36.sin();
    let t38 = t36.cos();
    let t39 = t38 * p.package_force;
    let force = t35 + t39;
    let t40 = drum_angle * R::literal(2.0);
    let t41 = p.ovality_phase + t40;
    let t42 = t41.sin();
    let t43 = t41.cos();
    let t44 = t43 * p.ovality;
    let sin_drum_angle = drum_angle.sin();
    let cos_drum_angle = drum_angle.cos();
    let t45 = cos_drum_angle * p.eccentricity;
    let shape = t44 + t45;
    let layer_compression = shape - holder_x;
    let t46 = R::literal(2.0) * p.ovality;
    let t47 = t3 * t46;
    let t48 = surface_speed * t47;
    let t49 = t48 * t42;
    let t50 = t3 * p.eccentricity;
    let t51 = surface_speed * t50;
    let t52 = t51 * sin_drum_angle;
    let t53 = t49 + t52;
    let t54 = t53 + holder_v;
    let layer_compression_rate = -t54;
    let t55 = layer_compression * p.layer_stiffness;
    let t56 = layer_compression * layer_compression;
    let t57 = t56 * layer_compression;
    let t58 = t57 * p.layer_cubic_stiffness;
    let t59 = t54 * p.layer_viscosity;
    let t60 = -t59;
    let t61 = p.holder_preload + t55;
    let t62 = t61 + t58;
    let layer_push = t62 - t59;
    let t63 = layer_push * p.pair_friction;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t63);
    let t64 = p.pair_support_arm + p.pair_rolling_arm;
    let t65 = layer_push * t64;
    let t66 = t65 / pair_radius;
    let t67 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t66);
    let pair_resistance = p.pair_tension + t67;
    let t68 = pair_omega * pair_growth;
    let t69 = p.acceleration - t68;
    let t70 = pair_inertia * t69;
    let t71 = t70 / t18;
    let pair_held = pair_resistance + t71;
    let t72 = t63 * pair_sliding;
    let t73 = t72 / pair_elastic;
    let t74 = -t73;
    let t75 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t74);
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip, t75, pair_held);
    let t76 = -t63;
    let t77 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t76);
    let t78 = R::select_less(pair_slip, R::literal(0.5), pair_adhering, t77);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit, t78);
    let t79 = R::literal(1.0) / holder_mass;
    let t80 = R::literal(1.0) / pair_inertia;
    let t81 = p.pair_yarn_density * p.pair_thread_area;
    let t82 = holder_v * t81;
    let t83 = t82 * pair_omega;
    let t84 = t83 * pair_radius;
    let t85 = holder_x * p.holder_stiffness;
    let t86 = -t62;
    let t87 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t86);
    let t88 = p.holder_preload + t85;
    let t89 = t88 + t87;
    let t90 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t60);
    let t91 = force + t90;
    let t92 = t91 - t84;
    let t93 = t92 - t89;
    let t94 = pair_carried - pair_resistance;
    let t95 = pair_radius * t94;
    let t96 = t95 * t80;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t96);
    let holder_v_dot = t93 * t79;
    let t97 = R::literal(-1.0) / p.layer_viscosity;
    let t98 = layer_swelling * t97;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), t98,
        layer_compression_rate);
    let t48_slope = p.acceleration * t47;
    let t51_slope = p.acceleration * t50;
    let inverse_pair_radius = R::literal(1.0) / pair_radius;
    let inverse_t18 = R::literal(1.0) / t18;
    let inverse_pair_elastic = R::literal(1.0) / pair_elastic;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let mut t15_before = t15;
    let mut t42_before = t42;
    let mut sin_drum_angle_before = sin_drum_angle;
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
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let time_k = R::literal(if order == 1 { 1.0 } else { 0.0 });
        let t1_k = -time_k * p.acceleration;
        let t2_k = R::select_less(surface_speed, R::literal(0.0), t1_k, time_k * p.acceleration);
        let pair_elastic_k = t2_k * p.pair_greatest_slip;
        let t5_k = (layer_surface + layer_surface).mul_add(layer_surface_k, sums[0]);
        let t6_k = layer_surface.mul_add(t5_k, t5.mul_add(layer_surface_k, sums[3]));
        let layer_swelling_k = t6_k.mul_add(p.layer_cubic_stiffness, layer_surface_k
            * p.layer_stiffness);
        let pair_growth_k = pair_omega_k * t11;
        let t12_k = pair_omega.mul_add(pair_radius_k, pair_radius.mul_add(pair_omega_k, sums[1]));
        let pair_sliding_k = t12_k - time_k * p.acceleration;
        let drum_angle_k = t16.mul_add(time_k * t13, t3 * t15_before);
        let t18_k = (pair_radius + pair_radius).mul_add(pair_radius_k, sums[2]);
        let t22_k = (t18 + t18).mul_add(t18_k, sums_1[0]);
        let t33_k = drum_angle_k.mul_add(t34, inverse * sums_3[0]);
        let t34_k = -drum_angle_k.mul_add(t33, inverse * sums_3[1]);
        let t37_k = pair_phi_k.mul_add(t38, inverse * sums_1[3]);
        let t38_k = -pair_phi_k.mul_add(t37, inverse * sums_2[0]);
        let force_k = t38_k.mul_add(p.package_force, t34_k * p.force_amplitude);
        let t42_k = (drum_angle_k * R::literal(2.0)).mul_add(t43, inverse * sums_4[0]);
        let t43_k = -(drum_angle_k * R::literal(2.0)).mul_add(t42, inverse * sums_4[1]);
        let sin_drum_angle_k = drum_angle_k.mul_add(cos_drum_angle, inverse * sums_2[2]);
        let cos_drum_angle_k = -drum_angle_k.mul_add(sin_drum_angle, inverse * sums_2[3]);
        let shape_k = cos_drum_angle_k.mul_add(p.eccentricity, t43_k * p.ovality);
        let layer_compression_k = shape_k - holder_x_k;
        let t49_k = t48.mul_add(t42_k, t48_slope * t42_before);
        let t52_k = t51.mul_add(sin_drum_angle_k, t51_slope * sin_drum_angle_before);
        let t53_k = t49_k + t52_k;
        let t54_k = t53_k + holder_v_k;
        let layer_compression_rate_k = -t54_k;
        let t56_k = (layer_compression + layer_compression).mul_add(layer_compression_k, sums_5[0]);
        let t57_k = layer_compression.mul_add(t56_k, t56.mul_add(layer_compression_k, sums_5[1]));
        let t59_k = t54_k * p.layer_viscosity;
        let t60_k = -t59_k;
        let t62_k = t57_k.mul_add(p.layer_cubic_stiffness, layer_compression_k * p.layer_stiffness);
        let layer_push_k = t62_k - t59_k;
        let t63_k = layer_push_k * p.pair_friction;
        let pair_limit_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t63_k);
        let t65_k = layer_push_k * t64;
        let t66_k = (-pair_radius_k).mul_add(t66, t65_k - sums_5[3]) * inverse_pair_radius;
        let t67_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t66_k);
        let t68_k = pair_omega.mul_add(pair_growth_k, pair_growth.mul_add(pair_omega_k, sums_1[1]));
        let t69_k = -t68_k;
        let t70_k = t69.mul_add(t22_k * t25, pair_inertia.mul_add(t69_k, sums_3[2]));
        let t71_k = (-t18_k).mul_add(t71, t70_k - sums_4[3]) * inverse_t18;
        let pair_held_k = t67_k + t71_k;
        let t72_k = pair_sliding.mul_add(t63_k, t63.mul_add(pair_sliding_k, sums_5[2]));
        let t73_k = (-pair_elastic_k).mul_add(t73, t72_k - sums_6[0]) * inverse_pair_elastic;
        let t74_k = -t73_k;
        let t75_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t74_k);
        let pair_adhering_k = R::select_less(R::literal(0.0), p.pair_greatest_slip, t75_k,
            pair_held_k);
        let t76_k = -t63_k;
        let t77_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t76_k);
        let t78_k = R::select_less(pair_slip, R::literal(0.5), pair_adhering_k, t77_k);
        let pair_carried_k = R::select_less(pair_slip, R::literal(-0.5), pair_limit_k, t78_k);
        let t79_k = -(t18_k * t20).mul_add(t79, sums_3[3]) * inverse_holder_mass;
        let t80_k = -(t22_k * t25).mul_add(t80, sums_4[2]) * inverse_pair_inertia;
        let t82_k = holder_v_k * t81;
        let t83_k = pair_omega.mul_add(t82_k, t82.mul_add(pair_omega_k, sums_1[2]));
        let t84_k = pair_radius.mul_add(t83_k, t83.mul_add(pair_radius_k, sums_2[1]));
        let t86_k = -t62_k;
        let t87_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t86_k);
        let t89_k = holder_x_k * p.holder_stiffness + t87_k;
        let t90_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t60_k);
        let t91_k = force_k + t90_k;
        let t92_k = t91_k - t84_k;
        let t93_k = t92_k - t89_k;
        let t94_k = pair_carried_k - t67_k;
        let t95_k = pair_radius.mul_add(t94_k, t94.mul_add(pair_radius_k, sums_6[2]));
        let t96_k = t80.mul_add(t95_k, t95.mul_add(t80_k, sums_6[3]));
        let pair_omega_dot_k = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t96_k);
        let holder_v_dot_k = t79.mul_add(t93_k, t93.mul_add(t79_k, sums_6[1]));
        let t98_k = layer_swelling_k * t97;
        let layer_surface_dot_k = R::select_less(layer_closed, R::literal(0.5), t98_k,
            layer_compression_rate_k);
        lanes.set(order, [layer_surface_k, pair_omega_k, pair_radius_k, layer_surface_k],
            [layer_surface_k, pair_radius_k, pair_radius_k, t5_k]);
        lanes_1.set(order, [t18_k, pair_omega_k, pair_omega_k, k * pair_phi_k],
            [t18_k, pair_growth_k, t82_k, t38_k]);
        lanes_2.set(order, [k * pair_phi_k, pair_radius_k, k * drum_angle_k, k * drum_angle_k],
            [t37_k, t83_k, cos_drum_angle_k, sin_drum_angle_k]);
        lanes_3.set(order, [k * drum_angle_k, k * drum_angle_k, t22_k * t25, t18_k * t20],
            [t34_k, t33_k, t69_k, t79_k]);
        lanes_4.set(order, [k * drum_angle_k * R::literal(2.0), k * drum_angle_k * R::literal(2.0),
            t22_k * t25, t18_k], [t43_k, t42_k, t80_k, t71_k]);
        lanes_5.set(order, [layer_compression_k, layer_compression_k, pair_sliding_k,
            pair_radius_k], [layer_compression_k, t56_k, t63_k, t66_k]);
        lanes_6.set(order, [pair_elastic_k, t79_k, pair_radius_k, t80_k], [t73_k, t93_k, t94_k,
            t95_k]);
        t15_before = time_k * t13;
        t42_before = t42_k;
        sin_drum_angle_before = sin_drum_angle_k;
        rates = [holder_v_k, pair_omega_k, holder_v_dot_k, pair_omega_dot_k, layer_surface_dot_k,
            R::literal(0.0), pair_growth_k, R::literal(0.0)];
    }
}

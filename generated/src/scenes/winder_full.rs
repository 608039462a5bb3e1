// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   832bc5af5a38f712efcd22cd3db84d9f8f8a8b441b8a72f5e3dc8aa11433a5a2  scenes/winder_full.toml
//   89ab201764c4228ac1f65d8a04b0cd2cc5bc6c75ef0b3ad4ba9d28d0ee4e9cb7  units/textile/pressed_bobbin.toml
//   dbabd24f6896648f12c02667cae50c2c763444a317d2163ea084a823993f857f  units/textile/yarn_layer_one_sided.toml
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
// Shapes: coordinates 2, first-order states 4, states 8, parameters 34, outputs 8, discontinuities 1,
//     events 9.
// Nonzeros: mass_matrix 2 of 2 by 2, rate_jacobian 15 of 8 by 8, parameter_jacobian 66 of 8 by 34.
// Operations: initial_state 5, discontinuities 4, rate 126, mass_matrix 19, forcing 106,
//     rate_jacobian 262, parameter_jacobian 864, time_derivative 144, outputs 97, energy 58,
//     power_balance 189, guards 86, guard_rates 294, resets 90, prepare 91, prepared_rate 106,
//     prepared_rate_jacobian 232, prepared_jacobians 906.

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
    events; prepared; jacobians_at_once; series 28 has_corners;
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
    holder_preload: 40.0, "N", "holder.preload", "N0, contact force of the empty bobbin at rest";
    holder_spring_share: 1.0, "1", "holder.spring_share", "share of the growth of the package's radius that deflects the spring; 0 where its seat follows";
    holder_gravity: 9.81, "m/s^2", "holder.gravity", "acceleration of free fall; 0 for a bobbin beside its drum";
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
    "pair.ends_back": Rising moves_guard, when [(7, -1.0)], sets [3, 7], "the package catches up: it sticks or runs ahead";
    "pair.ends_forth": Falling moves_guard, when [(7, 1.0)], sets [3, 7], "the drum catches up: the package sticks or lags behind";
    "pair.halts": Falling moves_guard, when [(7, -1.0)], sets [3, 7], "the package comes to a standstill";
    "pair.turns": Rising, when [(7, -2.0)], sets [7], "friction turns the package again";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 2 by 2 { 0 [0] 1 [1] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 8 by 8 { 0 [2] 1 [3] 2 [0 1 2 3 6] 3 [0 2 3 6] 4 [2 4 6] 6 [3] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 8 by 34 { 2 [0 1 2 3 4 5 6 7 8 9 12 13 14 15 16 17 18 19 20 21 22
        23 25 26 27] 3 [0 1 2 7 8 9 16 17 18 19 20 21 22 23 25 26 27 28 29 30 31 32 33]
        4 [0 1 2 7 8 9 16 17 18 19 20 21 22 23 25 26] 6 [25 27] }
}

::machinist_contract::constants! {
    inverse_drum_radius, t1, t2, pair_bobbin_radius_squared, t3, pair_bobbin_radius_squared_squared,
    t5, t6, t7, t8, t9, t10, t11, inverse_layer_viscosity, t12, minus_layer_viscosity, t13,
    layer_viscosity_times_pair_friction, t14, t16, t17, t0, t4, force_amplitude_over_drum_radius,
    t18, eccentricity_over_drum_radius, t19, t20, ovality_over_drum_radius, t21, t22, t23, t24,
    ovality_times_layer_stiffness, t25, t27, t28, t29, t30, t31, minus_pair_friction,
    minus_inverse_layer_viscosity, t32, holder_stiffness_times_pair_friction, t33,
    inverse_layer_viscosity_squared, t34, t35, t36, t37, t38, t39, t40, t41, t43, t44, t45, t46,
    inverse_pair_package_width, t47, t48, t49, t50, t51, t52, t53, t54
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 91 operations.
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
    let t7 = p.holder_stiffness * p.holder_spring_share;
    let t8 = R::literal(2.0) * p.ovality;
    let t9 = p.pair_support_arm + p.pair_rolling_arm;
    let t10 = p.pair_yarn_density * p.pair_thread_area;
    let t11 = R::literal(-1.0) / p.layer_viscosity;
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let t12 = R::literal(3.0) * p.layer_cubic_stiffness;
    let minus_layer_viscosity = -p.layer_viscosity;
    let t13 = p.layer_viscosity * t9;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t14 = -layer_viscosity_times_pair_friction;
    let t15 = R::literal(core::f64::consts::TAU) * p.holder_gravity;
    let t16 = t15 * p.pair_package_width * p.pair_yarn_density;
    let t17 = R::literal(core::f64::consts::TAU) * p.pair_package_width * p.pair_yarn_density;
    let force_amplitude_over_drum_radius = p.force_amplitude / p.drum_radius;
    let t18 = t8 / p.drum_radius;
    let eccentricity_over_drum_radius = p.eccentricity / p.drum_radius;
    let t19 = R::literal(4.0) * p.ovality / p.drum_radius;
    let t20 = R::literal(0.5) * p.force_amplitude / p.drum_radius;
    let ovality_over_drum_radius = p.ovality / p.drum_radius;
    let t21 = R::literal(0.5) * p.eccentricity / p.drum_radius;
    let t22 = R::literal(2.0) * p.layer_viscosity;
    let t23 = t8 * p.layer_viscosity;
    let t24 = R::literal(3.0) * p.ovality * p.layer_cubic_stiffness;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let t25 = holder_link_arm_squared / holder_holder_arm_squared;
    let t26 = R::literal(2.0) * p.holder_link_mass;
    let t27 = t26 * p.holder_link_arm / holder_holder_arm_squared;
    let t28 = t26 * holder_link_arm_squared / (holder_holder_arm_squared * p.holder_holder_arm);
    let t29 = p.holder_spring_share * t9;
    let t30 = p.holder_spring_share * p.pair_friction;
    let t31 = p.holder_spring_share / p.layer_viscosity;
    let minus_pair_friction = -p.pair_friction;
    let minus_inverse_layer_viscosity = -inverse_layer_viscosity;
    let t32 = p.holder_stiffness * t9;
    let holder_stiffness_times_pair_friction = p.holder_stiffness * p.pair_friction;
    let t33 = p.holder_stiffness / p.layer_viscosity;
    let inverse_layer_viscosity_squared = R::literal(1.0) / (p.layer_viscosity * p.layer_viscosity);
    let t34 = t7.add_product(t15 * p.pair_bobbin_radius * p.pair_package_width,
        p.pair_yarn_density);
    let t35 = -t34;
    let t36 = t9 * t34;
    let t37 = p.pair_friction * t34;
    let t38 = -t37;
    let t39 = t17 * (pair_bobbin_radius_squared * p.pair_bobbin_radius);
    let t40 = R::literal(core::f64::consts::TAU) * p.pair_bobbin_radius * p.pair_package_width
        * p.pair_yarn_density;
    let t41 = t34 / p.layer_viscosity;
    let t42 = R::literal(core::f64::consts::PI) * p.holder_gravity;
    let t43 = t42 * p.pair_yarn_density;
    let t44 = t43 * t9;
    let t45 = t43 * p.pair_friction;
    let t46 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_yarn_density;
    let inverse_pair_package_width = R::literal(1.0) / p.pair_package_width;
    let t47 = R::literal(core::f64::consts::PI) * p.pair_yarn_density;
    let t48 = t43 / p.layer_viscosity;
    let t49 = t42 * p.pair_package_width;
    let t50 = t49 * t9;
    let t51 = t49 * p.pair_friction;
    let t52 = t49 / p.layer_viscosity;
    let t53 = R::literal(0.5) / t0;
    let t54 = p.pair_friction / p.pair_greatest_slip;
    Constants { inverse_drum_radius, t1, t2, pair_bobbin_radius_squared, t3,
        pair_bobbin_radius_squared_squared, t5, t6, t7, t8, t9, t10, t11, inverse_layer_viscosity,
        t12, minus_layer_viscosity, t13, layer_viscosity_times_pair_friction, t14, t16, t17, t0,
        t4, force_amplitude_over_drum_radius, t18, eccentricity_over_drum_radius, t19, t20,
        ovality_over_drum_radius, t21, t22, t23, t24, ovality_times_layer_stiffness, t25, t27, t28,
        t29, t30, t31, minus_pair_friction, minus_inverse_layer_viscosity, t32,
        holder_stiffness_times_pair_friction, t33, inverse_layer_viscosity_squared, t34, t35, t36,
        t37, t38, t39, t40, t41, t43, t44, t45, t46, inverse_pair_package_width, t47, t48, t49,
        t50, t51, t52, t53, t54 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 106 operations.
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
    let holder_pressure = p.holder_preload.add_product(c.t7, pair_radius - p.pair_bobbin_radius)
        .add_product(p.holder_gravity, pair_package_mass);
    let layer_swelling = holder_pressure.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t3 = (p.eccentricity * turning * sin_drum_angle).add_product(c.t8 * turning, t1) + holder_v;
    let layer_compression_rate = -t3;
    let t4 = p.layer_stiffness * layer_compression;
    let t5 = p.layer_cubic_stiffness * (layer_compression * layer_compression * layer_compression);
    let t6 = p.layer_viscosity * t3;
    let layer_push = holder_pressure + t4 + t5 - t6;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), c.t9 * layer_push / pair_radius);
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
        holder_pressure - t6)).sub_product(c.t10 * holder_v * pair_omega, pair_radius)
        - holder_pressure - R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(t4 + t5)).add_product(p.holder_stiffness, holder_x)) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), c.t11 * layer_swelling,
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 106 operations.
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
    let force = (p.package_force * cos_package_phase_plus_pair_phi).add_product(p.force_amplitude,
        cos_force_phase_plus_drum_angle);
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t4 = p.layer_stiffness * layer_compression;
    let t5 = p.layer_cubic_stiffness * (layer_compression * layer_compression * layer_compression);
    let t6 = p.layer_viscosity * ((p.eccentricity * turning * sin_drum_angle)
        .add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let layer_push = holder_pressure + t4 + t5 - t6;
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
        holder_pressure - t6)).sub_product(p.pair_yarn_density * p.pair_thread_area * holder_v
        * pair_omega, pair_radius) - holder_pressure - R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(t4 + t5)).add_product(p.holder_stiffness, holder_x);
    let pair_phi_forcing = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance));
    [holder_x_forcing, pair_phi_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 232 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 15] {
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
    let holder_pressure = p.holder_preload.add_product(c.t7, pair_radius - p.pair_bobbin_radius)
        .add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t3 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t4 = p.layer_cubic_stiffness * (layer_compression_squared * layer_compression);
    let t5 = p.layer_viscosity * ((p.eccentricity * turning * sin_drum_angle).add_product(c.t8
        * turning, t1) + holder_v);
    let layer_push = holder_pressure + t3 + t4 - t5;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t6 = c.t9 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t6 / pair_radius);
    let t7 = p.acceleration.sub_product(pair_omega, pair_growth);
    let pair_held = pair_resistance + pair_inertia * t7 / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t8 = c.t10 * holder_v;
    let t9 = t8 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * inverse_pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        holder_pressure - t5)).sub_product(t9, pair_radius) - holder_pressure
        - R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(t3 + t4))
        .add_product(p.holder_stiffness, holder_x)) * inverse_holder_mass;
    let t10 = p.layer_stiffness.add_product(c.t12, layer_compression_squared);
    let t11 = c.t9 * t10 / pair_radius;
    let t12 = p.pair_friction * t10;
    let pair_friction_times_pair_sliding = p.pair_friction * pair_sliding;
    let pair_omega_dot_by_holder_x = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t12, R::literal(0.0)) + t11)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t12)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), pair_friction_times_pair_sliding * t10 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t11)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t10)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let t13 = c.t13 / pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t13
        + R::select_less(pair_slip, R::literal(-0.5), c.t14, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), c.layer_viscosity_times_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.layer_viscosity_times_pair_friction * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t13)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t10 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.pair_friction
        * pair_radius * layer_push / pair_elastic)), R::literal(-2.0) * pair_growth * pair_inertia
        / pair_radius_squared) * R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::literal(1.0)) * R::select_less(pair_slip, R::literal(0.5), R::literal(1.0),
        R::literal(0.0)) * inverse_pair_inertia);
    let holder_v_dot_by_pair_omega = -(t8 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t12, layer_surface
        * layer_surface)), R::literal(0.0));
    let t14 = c.t7.add_product(c.t16, pair_radius);
    let t15 = c.t9 * t14 / pair_radius - t6 / pair_radius_squared;
    let t16 = p.pair_friction * t14;
    let t17 = pair_radius_squared * pair_radius;
    let t18 = c.t17 * pair_radius;
    let t19 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), -t16)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(p.pair_friction * pair_omega * layer_push
        / pair_elastic + pair_friction_times_pair_sliding * t14 / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15).add_product(t18, t7)
        - R::literal(2.0) * pair_inertia * t7 / t17), R::literal(0.0)));
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t16,
        R::literal(0.0)) - t15) + t19) - pair_resistance).sub_product(c.t17 * t17, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t14) - t9 - t14).sub_product(t18, holder_v_dot) * inverse_holder_mass;
    let layer_surface_dot_by_pair_radius = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * t14), R::literal(0.0));
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, layer_surface_dot_by_pair_radius, c.t1]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 906 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 81] {
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
    let pair_radius_minus_pair_bobbin_radius = pair_radius - p.pair_bobbin_radius;
    let holder_pressure = p.holder_preload.add_product(c.t7, pair_radius_minus_pair_bobbin_radius)
        .add_product(p.holder_gravity, pair_package_mass);
    let layer_surface_squared = layer_surface * layer_surface;
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let t5 = c.t8 * turning;
    let t6 = (p.eccentricity * turning * sin_drum_angle).add_product(t5, t1) + holder_v;
    let t7 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t8 = layer_compression_squared * layer_compression;
    let t9 = p.layer_cubic_stiffness * t8;
    let t10 = p.layer_viscosity * t6;
    let t11 = holder_pressure + t7 + t9;
    let layer_push = t11 - t10;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t12 = c.t9 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t12 / pair_radius);
    let t13 = p.acceleration.sub_product(pair_omega, pair_growth);
    let pair_held = pair_resistance + pair_inertia * t13 / pair_radius_squared;
    let t14 = pair_friction_times_layer_push * pair_sliding;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(t14 / pair_elastic)),
        pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t15 = c.t10 * holder_v;
    let t16 = t15 * pair_omega;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * inverse_pair_inertia);
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        holder_pressure - t10)).sub_product(t16, pair_radius) - holder_pressure
        - R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(t7 + t9))
        .add_product(p.holder_stiffness, holder_x)) * inverse_holder_mass;
    let t17 = c.t12 * layer_compression_squared;
    let t18 = p.layer_stiffness + t17;
    let t19 = c.t9 * t18 / pair_radius;
    let t20 = p.pair_friction * t18;
    let pair_friction_times_pair_sliding = p.pair_friction * pair_sliding;
    let pair_omega_dot_by_holder_x = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t20, R::literal(0.0)) + t19)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t20)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), pair_friction_times_pair_sliding * t18 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t19)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t18)) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let t21 = c.t13 / pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t21
        + R::select_less(pair_slip, R::literal(-0.5), c.t14, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), c.layer_viscosity_times_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.layer_viscosity_times_pair_friction * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t21)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        c.minus_layer_viscosity).sub_product(c.t10 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-1.0));
    let t22 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::literal(1.0));
    let t23 = R::select_less(pair_slip, R::literal(0.5), R::literal(1.0), R::literal(0.0));
    let pair_omega_dot_by_pair_omega = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(p.pair_friction
        * pair_radius * layer_push / pair_elastic)), R::literal(-2.0) * pair_growth * pair_inertia
        / pair_radius_squared) * t22 * t23 * inverse_pair_inertia);
    let holder_v_dot_by_pair_omega = -(t15 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * p.layer_stiffness.add_product(c.t12, layer_surface_squared)),
        R::literal(0.0));
    let t24 = c.t7.add_product(c.t16, pair_radius);
    let t25 = c.t9 * t24 / pair_radius - t12 / pair_radius_squared;
    let t26 = p.pair_friction * t24;
    let t27 = pair_radius_squared * pair_radius;
    let t28 = c.t17 * pair_radius;
    let t29 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), -t26)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(p.pair_friction * pair_omega * layer_push
        / pair_elastic + pair_friction_times_pair_sliding * t24 / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t25).add_product(t28, t13)
        - R::literal(2.0) * pair_inertia * t13 / t27), R::literal(0.0)));
    let pair_omega_dot_by_pair_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_carried.add_product(pair_radius, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t26,
        R::literal(0.0)) - t25) + t29) - pair_resistance).sub_product(c.t17 * t27, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t24) - t16 - t24).sub_product(t28, holder_v_dot) * inverse_holder_mass;
    let layer_surface_dot_by_pair_radius = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * t24), R::literal(0.0));
    let t30 = layer_surface_squared * layer_surface;
    let layer_swelling = holder_pressure.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, t30);
    let t31 = c.t18 * time * t1;
    let t32 = c.eccentricity_over_drum_radius * time;
    let t33 = t32 * sin_drum_angle;
    let t34 = t31 + t33;
    let t35 = (c.t19 * time * turning * t2).add_product(c.t18, t1).add_product(t32 * turning,
        cos_drum_angle).add_product(c.eccentricity_over_drum_radius, sin_drum_angle);
    let t36 = (p.layer_stiffness * t34).add_product(c.t12 * t34, layer_compression_squared)
        .add_product(p.layer_viscosity, t35);
    let t37 = c.t9 * t36 / pair_radius;
    let t38 = p.pair_friction * t36;
    let t39 = R::select_less(surface_speed, R::literal(0.0), R::literal(-1.0), R::literal(1.0));
    let pair_elastic_times_abs_surface_speed = pair_elastic * abs_surface_speed;
    let pair_omega_dot_by_winding_speed = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t38, R::literal(0.0)) + t37)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t38)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t14 * t39 / pair_elastic_times_abs_surface_speed
        + pair_friction_times_layer_push / pair_elastic + pair_friction_times_pair_sliding * t36
        / pair_elastic), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t37)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t36).sub_product(c.force_amplitude_over_drum_radius * time,
        sin_force_phase_plus_drum_angle) * inverse_holder_mass;
    let layer_surface_dot_by_winding_speed = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t35);
    let time_squared = time * time;
    let t40 = (c.t21 * time_squared * sin_drum_angle).add_product(c.ovality_over_drum_radius
        * time_squared, t1);
    let t41 = c.t18 * turning;
    let t42 = (t31.add_product(t41 * time_squared, t2) + t33).add_product(c.t21 * turning
        * time_squared, cos_drum_angle);
    let t43 = (p.layer_stiffness * t40).add_product(c.t12 * t40, layer_compression_squared)
        .add_product(p.layer_viscosity, t42);
    let t44 = c.t9 * t43 / pair_radius;
    let t45 = p.pair_friction * t43;
    let t46 = p.pair_friction * time * layer_push;
    let t47 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), -t45, R::literal(0.0)) + t44)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t45)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t46 * pair_sliding * t39
        / pair_elastic_times_abs_surface_speed + t46 / pair_elastic
        + pair_friction_times_pair_sliding * t43 / pair_elastic), pair_inertia
        / pair_radius_squared + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -t44)), R::literal(0.0)));
    let pair_omega_dot_by_acceleration = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * t47 * inverse_pair_inertia);
    let holder_v_dot_by_acceleration = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t43).sub_product(c.t20 * time_squared, sin_force_phase_plus_drum_angle)
        * inverse_holder_mass;
    let layer_surface_dot_by_acceleration = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -t42);
    let t48 = c.eccentricity_over_drum_radius * drum_angle;
    let t49 = (t48 * sin_drum_angle).add_product(c.t18 * drum_angle, t1);
    let t50 = (t41 * t1).add_product(c.t19 * drum_angle * turning, t2).add_product(t48 * turning,
        cos_drum_angle).add_product(c.eccentricity_over_drum_radius * turning, sin_drum_angle);
    let t51 = (p.layer_stiffness * t49).add_product(c.t12 * t49, layer_compression_squared)
        .add_product(p.layer_viscosity, t50);
    let t52 = c.t9 * t51 / pair_radius;
    let t53 = p.pair_friction * t51;
    let pair_omega_dot_by_drum_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t53, R::literal(0.0)) - t52)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t53)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t51
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t52)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t51).add_product(c.force_amplitude_over_drum_radius * drum_angle,
        sin_force_phase_plus_drum_angle) * inverse_holder_mass;
    let layer_surface_dot_by_drum_radius = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t50);
    let holder_v_dot_by_force_amplitude = cos_force_phase_plus_drum_angle * inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * sin_force_phase_plus_drum_angle
        * inverse_holder_mass);
    let holder_v_dot_by_package_force = cos_package_phase_plus_pair_phi * inverse_holder_mass;
    let t54 = (p.layer_stiffness * t2).add_product(t17, t2).sub_product(c.t22 * turning, t1);
    let t55 = c.t9 * t54 / pair_radius;
    let t56 = p.pair_friction * t54;
    let pair_omega_dot_by_ovality = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0),
        pair_radius * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), t56, R::literal(0.0)) - t55)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t56)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t54
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t55)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        t54 * inverse_holder_mass);
    let layer_surface_dot_by_ovality = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::literal(-2.0) * turning * t1);
    let t57 = c.t23 * turning * t2;
    let t58 = c.t24 * layer_compression_squared * t1;
    let t59 = c.ovality_times_layer_stiffness * t1;
    let t60 = t58 + t57 + t59;
    let t61 = c.t9 * t60 / pair_radius;
    let t62 = p.pair_friction * t60;
    let pair_omega_dot_by_ovality_phase = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t62, R::literal(0.0)) + t61)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t62)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), pair_friction_times_pair_sliding * t60 / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t61)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -((t57 + (t58 + t59)) * inverse_holder_mass));
    let layer_surface_dot_by_ovality_phase = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t5 * t2));
    let t63 = (p.layer_stiffness * cos_drum_angle).add_product(t17, cos_drum_angle)
        .sub_product(p.layer_viscosity * turning, sin_drum_angle);
    let t64 = c.t9 * t63 / pair_radius;
    let t65 = p.pair_friction * t63;
    let pair_omega_dot_by_eccentricity = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t65, R::literal(0.0)) - t64)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t65)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t63
        / pair_elastic)), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t64)),
        R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t63 * inverse_holder_mass);
    let layer_surface_dot_by_eccentricity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(turning * sin_drum_angle));
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t25 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t27 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t28 * holder_v_dot * inverse_holder_mass;
    let t66 = p.holder_spring_share * pair_radius_minus_pair_bobbin_radius;
    let t67 = c.t29 * pair_radius_minus_pair_bobbin_radius / pair_radius;
    let t68 = c.t30 * pair_radius_minus_pair_bobbin_radius;
    let pair_omega_dot_by_holder_stiffness = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t68, R::literal(0.0)) - t67)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t68)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(c.t30 * pair_sliding
        * pair_radius_minus_pair_bobbin_radius / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t67)), R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_holder_stiffness = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t66) - holder_x - t66) * inverse_holder_mass;
    let layer_surface_dot_by_holder_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.t31 * pair_radius_minus_pair_bobbin_radius), R::literal(0.0));
    let t69 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::literal(1.0));
    let t70 = c.t9 / pair_radius;
    let pair_omega_dot_by_holder_preload = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), p.pair_friction,
        R::literal(0.0)) - t70) + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), c.minus_pair_friction)) + R::select_less(pair_slip,
        R::literal(0.5), R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_pair_sliding / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t70)), R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_holder_preload = (t69 - R::literal(1.0)) * inverse_holder_mass;
    let layer_surface_dot_by_holder_preload = R::select_less(layer_closed, R::literal(0.5),
        c.minus_inverse_layer_viscosity, R::literal(0.0));
    let t71 = p.holder_stiffness * pair_radius_minus_pair_bobbin_radius;
    let t72 = c.t32 * pair_radius_minus_pair_bobbin_radius / pair_radius;
    let t73 = c.holder_stiffness_times_pair_friction * pair_radius_minus_pair_bobbin_radius;
    let pair_omega_dot_by_holder_spring_share = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t73, R::literal(0.0)) - t72)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t73)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(c.holder_stiffness_times_pair_friction * pair_sliding
        * pair_radius_minus_pair_bobbin_radius / pair_elastic)), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t72)), R::literal(0.0)))) * inverse_pair_inertia);
    let holder_v_dot_by_holder_spring_share = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t71) - t71) * inverse_holder_mass;
    let layer_surface_dot_by_holder_spring_share = R::select_less(layer_closed, R::literal(0.5),
        -(c.t33 * pair_radius_minus_pair_bobbin_radius), R::literal(0.0));
    let t74 = c.t9 * pair_package_mass / pair_radius;
    let t75 = p.pair_friction * pair_package_mass;
    let pair_omega_dot_by_holder_gravity = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t75, R::literal(0.0)) - t74)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t75)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(t75 * pair_sliding / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t74)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_holder_gravity = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_package_mass) - pair_package_mass) * inverse_holder_mass;
    let layer_surface_dot_by_holder_gravity = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * pair_package_mass), R::literal(0.0));
    let t76 = c.t9 * layer_compression / pair_radius;
    let t77 = p.pair_friction * layer_compression;
    let pair_omega_dot_by_layer_stiffness = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t77, R::literal(0.0)) - t76)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t77)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(t77 * pair_sliding / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t76)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), layer_compression * inverse_holder_mass);
    let layer_surface_dot_by_layer_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * layer_surface), R::literal(0.0));
    let t78 = c.t9 * t8 / pair_radius;
    let t79 = p.pair_friction * t8;
    let pair_omega_dot_by_layer_cubic_stiffness = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t79, R::literal(0.0)) - t78)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), -t79)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(pair_friction_times_pair_sliding * t8 / pair_elastic)),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t78)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t8 * inverse_holder_mass);
    let layer_surface_dot_by_layer_cubic_stiffness = R::select_less(layer_closed, R::literal(0.5),
        -(c.inverse_layer_viscosity * t30), R::literal(0.0));
    let t80 = c.t9 * t6 / pair_radius;
    let t81 = p.pair_friction * t6;
    let pair_omega_dot_by_layer_viscosity = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), -t81, R::literal(0.0)) + t80)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), t81)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), t81 * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t80)), R::literal(0.0))))
        * inverse_pair_inertia);
    let holder_v_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), -(t6 * inverse_holder_mass));
    let layer_surface_dot_by_layer_viscosity = R::select_less(layer_closed, R::literal(0.5),
        c.inverse_layer_viscosity_squared * layer_swelling, R::literal(0.0));
    let t82 = c.t36 / pair_radius;
    let pair_omega_dot_by_pair_bobbin_radius = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), c.t38, R::literal(0.0)) + t82)
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        R::literal(0.0), c.t37)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), c.t37 * pair_sliding / pair_elastic),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t82) - c.t39 * t13
        / pair_radius_squared), R::literal(0.0))))).add_product(c.t39, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_bobbin_radius = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), c.t35) + c.t34).add_product(c.t40, holder_v_dot) * inverse_holder_mass;
    let layer_surface_dot_by_pair_bobbin_radius = R::select_less(layer_closed, R::literal(0.5),
        c.t41, R::literal(0.0));
    let t83 = c.t43 * t3;
    let t84 = c.t44 * t3 / pair_radius;
    let t85 = c.t45 * t3;
    let t86 = R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), -t85)) + R::select_less(pair_slip, R::literal(0.5),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(c.t45 * pair_sliding * t3 / pair_elastic)), c.t46 * t13
        * t4 / pair_radius_squared + c.inverse_pair_package_width * pair_omega * pair_growth
        * pair_inertia / pair_radius_squared + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t84)), R::literal(0.0)));
    let pair_omega_dot_by_pair_package_width = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), t85, R::literal(0.0)) - t84)
        + t86)).sub_product(c.t46 * t4, pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_package_width = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t83) - t83).sub_product(c.t47 * t3, holder_v_dot) * inverse_holder_mass;
    let layer_surface_dot_by_pair_package_width = R::select_less(layer_closed, R::literal(0.5),
        -(c.t48 * t3), R::literal(0.0));
    let pair_radius_dot_by_pair_package_width = -(c.inverse_pair_package_width * pair_growth);
    let t87 = c.t49 * t3;
    let t88 = c.t50 * t3 / pair_radius;
    let t89 = c.t51 * t3;
    let t90 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(-0.5), t89, R::literal(0.0)) - t88) + R::select_less(pair_slip,
        R::literal(-0.5), R::literal(0.0), R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(0.5), R::literal(0.0), -t89))
        + R::select_less(pair_slip, R::literal(0.5), R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(c.t51 * pair_sliding * t3 / pair_elastic)), c.t4 * t13 * t4 / pair_radius_squared
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t88)), R::literal(0.0)))));
    let pair_omega_dot_by_pair_yarn_density = t90.sub_product(c.t4 * t4, pair_omega_dot)
        * inverse_pair_inertia;
    let holder_v_dot_by_pair_yarn_density = (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t87) - t87).sub_product(p.pair_thread_area * holder_v * pair_omega,
        pair_radius).sub_product(c.t0 * t3, holder_v_dot) * inverse_holder_mass;
    let layer_surface_dot_by_pair_yarn_density = R::select_less(layer_closed, R::literal(0.5),
        -(c.t52 * t3), R::literal(0.0));
    let t91 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), R::literal(1.0));
    let pair_omega_dot_by_pair_thread_area = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), -(c.t53 * pair_inertia * (pair_omega * pair_omega) * t91 * t22 * t23
        / pair_radius * inverse_pair_inertia));
    let holder_v_dot_by_pair_thread_area = -(p.pair_yarn_density * holder_v * pair_omega
        * pair_radius * inverse_holder_mass);
    let pair_radius_dot_by_pair_thread_area = c.t53 * pair_omega;
    let pair_omega_dot_by_pair_bobbin_inertia = (R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), t13 * t91 * t22 * t23 / pair_radius)
        - pair_omega_dot) * inverse_pair_inertia;
    let pair_omega_dot_by_pair_tension = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), t23))
        - R::literal(1.0)) * inverse_pair_inertia);
    let pair_omega_dot_by_pair_friction = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), R::select_less(pair_slip, R::literal(-0.5), layer_push, R::literal(0.0)))
        + R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(R::literal(0.0), p.pair_greatest_slip, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), R::select_less(pair_slip, R::literal(0.5),
        -(layer_push * pair_sliding / pair_elastic), R::literal(0.0))), R::literal(0.0))
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), R::literal(0.0), t10 - t11)))) * inverse_pair_inertia);
    let layer_push_over_pair_radius = layer_push / pair_radius;
    let pair_omega_dot_by_pair_support_arm = R::select_less(pair_slip, R::literal(-1.5),
        R::literal(0.0), pair_radius * (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        R::select_less(pair_slip, R::literal(-0.5), R::literal(0.0), R::select_less(pair_slip,
        R::literal(0.5), layer_push_over_pair_radius, R::literal(0.0)))))
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -layer_push_over_pair_radius)) * inverse_pair_inertia);
    let pair_omega_dot_by_pair_greatest_slip = R::select_less(R::literal(0.0),
        p.pair_greatest_slip, c.t54 * pair_radius * layer_push * pair_sliding * t69 * t91 * t22
        * t23 / pair_elastic * inverse_pair_inertia, R::literal(0.0));
    [R::literal(1.0), R::literal(1.0), holder_v_dot_by_holder_x, holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v, holder_v_dot_by_pair_omega, holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x, pair_omega_dot_by_holder_v, pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius, layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface, layer_surface_dot_by_pair_radius, c.t1,
        holder_v_dot_by_winding_speed, holder_v_dot_by_acceleration, holder_v_dot_by_drum_radius,
        holder_v_dot_by_force_amplitude, holder_v_dot_by_force_phase,
        holder_v_dot_by_package_force, holder_v_dot_by_pair_phi, holder_v_dot_by_ovality,
        holder_v_dot_by_ovality_phase, holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass, holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm, holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_stiffness, holder_v_dot_by_holder_preload,
        holder_v_dot_by_holder_spring_share, holder_v_dot_by_holder_gravity,
        holder_v_dot_by_layer_stiffness, holder_v_dot_by_layer_cubic_stiffness,
        holder_v_dot_by_layer_viscosity, holder_v_dot_by_pair_bobbin_radius,
        holder_v_dot_by_pair_package_width, holder_v_dot_by_pair_yarn_density,
        holder_v_dot_by_pair_thread_area, pair_omega_dot_by_winding_speed,
        pair_omega_dot_by_acceleration, pair_omega_dot_by_drum_radius, pair_omega_dot_by_ovality,
        pair_omega_dot_by_ovality_phase, pair_omega_dot_by_eccentricity,
        pair_omega_dot_by_holder_stiffness, pair_omega_dot_by_holder_preload,
        pair_omega_dot_by_holder_spring_share, pair_omega_dot_by_holder_gravity,
        pair_omega_dot_by_layer_stiffness, pair_omega_dot_by_layer_cubic_stiffness,
        pair_omega_dot_by_layer_viscosity, pair_omega_dot_by_pair_bobbin_radius,
        pair_omega_dot_by_pair_package_width, pair_omega_dot_by_pair_yarn_density,
        pair_omega_dot_by_pair_thread_area, pair_omega_dot_by_pair_bobbin_inertia,
        pair_omega_dot_by_pair_tension, pair_omega_dot_by_pair_friction,
        pair_omega_dot_by_pair_support_arm, pair_omega_dot_by_pair_support_arm,
        pair_omega_dot_by_pair_greatest_slip, layer_surface_dot_by_winding_speed,
        layer_surface_dot_by_acceleration, layer_surface_dot_by_drum_radius,
        layer_surface_dot_by_ovality, layer_surface_dot_by_ovality_phase,
        layer_surface_dot_by_eccentricity, layer_surface_dot_by_holder_stiffness,
        layer_surface_dot_by_holder_preload, layer_surface_dot_by_holder_spring_share,
        layer_surface_dot_by_holder_gravity, layer_surface_dot_by_layer_stiffness,
        layer_surface_dot_by_layer_cubic_stiffness, layer_surface_dot_by_layer_viscosity,
        layer_surface_dot_by_pair_bobbin_radius, layer_surface_dot_by_pair_package_width,
        layer_surface_dot_by_pair_yarn_density, pair_radius_dot_by_pair_package_width,
        pair_radius_dot_by_pair_thread_area]
}

/// Partial derivative of `y'` with respect to time. 144 operations.
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
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t5 = R::literal(2.0) * p.ovality * turning;
    let eccentricity_times_turning = p.eccentricity * turning;
    let layer_compression_squared = layer_compression * layer_compression;
    let layer_push = holder_pressure.add_product(p.layer_stiffness, layer_compression)
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

/// Wanted outputs. 97 operations.
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
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = holder_pressure.add_product(p.layer_stiffness, layer_compression)
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

/// T, V and the energy of first-order states \[J\]. 58 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..] = *state;
    let drum_angle = R::literal(1.0) / p.drum_radius * time * p.winding_speed
        .add_product(R::literal(0.5) * p.acceleration, time);
    let [(_, t0), (_, cos_drum_angle)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0), drum_angle), drum_angle]);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_mass = p.holder_bobbin_mass + p.holder_link_mass * (p.holder_link_arm
        * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm) + pair_package_mass;
    let layer_surface_squared = layer_surface * layer_surface;
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t1 = R::literal(0.25) * p.layer_cubic_stiffness;
    let t2 = R::literal(0.5) * p.layer_stiffness;
    Energy {
        kinetic: (R::literal(0.5) * pair_inertia * (pair_omega * pair_omega))
            .add_product(R::literal(0.5) * holder_mass, holder_v * holder_v),
        potential: R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
            (t2 * layer_compression_squared).add_product(t1, layer_compression_squared
            * layer_compression_squared)).add_product(R::literal(0.5) * p.holder_stiffness,
            holder_x * holder_x),
        stored: R::select_less(layer_closed, R::literal(0.5), (t2 * layer_surface_squared)
            .add_product(t1, layer_surface_squared * layer_surface_squared), R::literal(0.0)),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 189 operations.
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
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let layer_stiffness_times_layer_surface = p.layer_stiffness * layer_surface;
    let t7 = p.layer_cubic_stiffness * (layer_surface * layer_surface * layer_surface);
    let layer_swelling = holder_pressure + layer_stiffness_times_layer_surface + t7;
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t8 = (p.eccentricity * turning * sin_drum_angle).add_product(R::literal(2.0) * p.ovality
        * turning, t3) + holder_v;
    let layer_compression_rate = -t8;
    let t9 = p.layer_stiffness * layer_compression;
    let t10 = layer_compression * layer_compression * layer_compression;
    let t11 = p.layer_cubic_stiffness * t10;
    let t12 = p.layer_viscosity * t8;
    let layer_push = holder_pressure + t9 + t11 - t12;
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
    let t13 = p.pair_yarn_density * p.pair_thread_area;
    let t14 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -(t9 + t11))
        .add_product(p.holder_stiffness, holder_x);
    let t15 = pair_radius * (pair_carried - pair_resistance);
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t15
        * (R::literal(1.0) / pair_inertia));
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        holder_pressure - t12)).sub_product(t13 * holder_v * pair_omega, pair_radius)
        - holder_pressure - t14) * (R::literal(1.0) / holder_mass);
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), -(inverse_layer_viscosity
        * layer_swelling), layer_compression_rate);
    let t16 = pair_radius_squared * pair_radius;
    let pair_omega_squared = pair_omega * pair_omega;
    let t17 = (p.eccentricity * (inverse_drum_radius * t1).add_product(t0 / p.drum_radius, time)
        * sin_drum_angle).add_product(p.ovality * (R::literal(2.0) / p.drum_radius * t1)
        .add_product(p.acceleration / p.drum_radius, time), t3);
    let t18 = -(t9 * t17).add_product(p.layer_cubic_stiffness * t17, t10);
    let t19 = (t6 * pair_radius * (holder_v * holder_v)).add_product(t6 * pair_omega_squared, t16)
        * pair_growth;
    PowerBalance {
        stored_rate: R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t18)
            .add_product(t14, holder_v).add_product(holder_v * holder_mass, holder_v_dot)
            .add_product(pair_omega * pair_inertia, pair_omega_dot)
            .add_product(R::select_less(layer_closed, R::literal(0.5),
            layer_stiffness_times_layer_surface + t7, R::literal(0.0)), layer_surface_dot) + t19,
        supplied: (holder_v * (force + R::select_less(layer_closed, R::literal(0.5),
            R::literal(0.0), holder_pressure) - holder_pressure)).add_product(pair_omega,
            R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t15).add_product(t13
            * pair_omega_squared, t16)) + R::select_less(layer_closed, R::literal(0.5),
            inverse_layer_viscosity * holder_pressure * layer_swelling, t18) - t19,
        dissipated: R::select_less(layer_closed, R::literal(0.5), inverse_layer_viscosity
            * (layer_swelling * layer_swelling), p.layer_viscosity * holder_v * t8),
    }
}

/// What passes zero where events happen, one for each event. 86 operations.
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
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = holder_pressure.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * turning
        * sin_drum_angle).add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t4 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t4);
    let layer_touches_guard = layer_compression - layer_surface;
    let pair_sliding_plus_pair_elastic = pair_sliding + pair_elastic;
    let t5 = p.pair_tension + pair_inertia * p.acceleration.sub_product(pair_omega, pair_growth)
        / pair_radius_squared;
    let pair_breaks_back_guard = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        -pair_sliding_plus_pair_elastic, t5 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t4 - pair_friction_times_layer_push));
    let pair_breaks_forth_guard = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        pair_elastic - pair_sliding, t5 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t4));
    let pair_ends_forth_guard = pair_sliding - pair_elastic;
    let pair_turns_guard = pair_limit - pair_resistance;
    [layer_touches_guard, layer_push, time, pair_breaks_back_guard, pair_breaks_forth_guard,
        pair_sliding_plus_pair_elastic, pair_ends_forth_guard, pair_omega, pair_turns_guard]
}

/// `dg/dt` of the guards along the motion. 294 operations.
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
    let t6 = p.holder_stiffness * p.holder_spring_share;
    let holder_pressure = p.holder_preload.add_product(t6, pair_radius - p.pair_bobbin_radius)
        .add_product(p.holder_gravity, pair_package_mass);
    let layer_swelling = holder_pressure.add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, layer_surface * layer_surface * layer_surface);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let t7 = R::literal(2.0) * p.ovality * turning;
    let eccentricity_times_turning = p.eccentricity * turning;
    let t8 = (eccentricity_times_turning * sin_drum_angle).add_product(t7, t3) + holder_v;
    let layer_compression_rate = -t8;
    let t9 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t10 = p.layer_cubic_stiffness * (layer_compression_squared * layer_compression);
    let t11 = p.layer_viscosity * t8;
    let layer_push = holder_pressure + t9 + t10 - t11;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t12 = p.pair_support_arm + p.pair_rolling_arm;
    let t13 = t12 * layer_push;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t13 / pair_radius);
    let pair_omega_times_pair_growth = pair_omega * pair_growth;
    let t14 = p.acceleration - pair_omega_times_pair_growth;
    let pair_held = pair_resistance + pair_inertia * t14 / pair_radius_squared;
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(pair_friction_times_layer_push * pair_sliding / pair_elastic)), pair_held);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit,
        R::select_less(pair_slip, R::literal(0.5), pair_adhering, R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -pair_friction_times_layer_push)));
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), pair_radius
        * (pair_carried - pair_resistance) * (R::literal(1.0) / pair_inertia));
    let holder_v_dot = ((force + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        holder_pressure - t11)).sub_product(p.pair_yarn_density * p.pair_thread_area * holder_v
        * pair_omega, pair_radius) - holder_pressure - R::select_less(layer_closed,
        R::literal(0.5), R::literal(0.0), -(t9 + t10)).add_product(p.holder_stiffness, holder_x))
        * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), R::literal(-1.0)
        / p.layer_viscosity * layer_swelling, layer_compression_rate);
    let t15 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t16 = p.layer_stiffness.add_product(t15, layer_compression_squared);
    let t17 = t12 * t16 / pair_radius;
    let t18 = p.pair_friction * t16;
    let t19 = p.layer_viscosity * t12 / pair_radius;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t20 = t6.add_product(R::literal(core::f64::consts::TAU) * p.holder_gravity
        * p.pair_package_width * p.pair_yarn_density, pair_radius);
    let t21 = t13 / pair_radius_squared;
    let t22 = t12 * t20 / pair_radius;
    let t23 = p.pair_friction * t20;
    let t24 = R::literal(2.0) * pair_inertia * t14 / (pair_radius_squared * pair_radius);
    let t25 = R::literal(core::f64::consts::TAU) * p.pair_package_width * p.pair_yarn_density
        * pair_radius * t14;
    let t26 = R::select_less(surface_speed, R::literal(0.0), R::literal(-1.0), R::literal(1.0));
    let t27 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), R::literal(1.0));
    let t28 = (inverse_drum_radius * t1).add_product(t0 / p.drum_radius, time);
    let t29 = (R::literal(2.0) / p.drum_radius * t1).add_product(p.acceleration / p.drum_radius,
        time);
    let t30 = (p.eccentricity * t28 * sin_drum_angle).add_product(p.ovality * t29, t3);
    let t31 = R::literal(2.0) * p.acceleration * p.ovality;
    let acceleration_times_eccentricity = p.acceleration * p.eccentricity;
    let t32 = (p.layer_stiffness * t30).add_product(t15 * t30, layer_compression_squared)
        .add_product(p.layer_viscosity, (t31 / p.drum_radius * t3).add_product(t7 * t29, t4)
        .add_product(acceleration_times_eccentricity / p.drum_radius, sin_drum_angle)
        .add_product(eccentricity_times_turning * t28, cos_drum_angle));
    let t33 = t12 * t32 / pair_radius;
    let t34 = p.pair_friction * t32;
    let layer_touches_guard_rate = (-holder_v).add_product(inverse_drum_radius, (R::literal(-2.0)
        * p.winding_speed * p.ovality * t3).sub_product(t31 * time, t3)
        .sub_product(acceleration_times_eccentricity * time, sin_drum_angle)
        .sub_product(p.winding_speed * p.eccentricity, sin_drum_angle)) - layer_surface_dot;
    let layer_opens_guard_rate = (-t32.add_product(t16, holder_v).add_product(p.layer_viscosity,
        holder_v_dot)).add_product(t20, pair_growth);
    let t35 = p.acceleration * p.pair_greatest_slip * t26;
    let t36 = R::select_less(R::literal(0.0), p.pair_greatest_slip, -pair_radius, R::literal(-2.0)
        * pair_growth * pair_inertia / pair_radius_squared) * pair_omega_dot;
    let minus_pair_omega = -pair_omega;
    let pair_breaks_back_guard_rate = (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        p.acceleration - t35, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t34
        - t33)).add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip, R::literal(0.0),
        (t18 - t17) * t27), holder_v).add_product(R::select_less(R::literal(0.0),
        p.pair_greatest_slip, R::literal(0.0), (layer_viscosity_times_pair_friction - t19) * t27),
        holder_v_dot) + t36).add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip,
        minus_pair_omega, t25 + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t22
        - t23 - t21) - t24), pair_growth);
    let pair_breaks_forth_guard_rate = (R::select_less(R::literal(0.0), p.pair_greatest_slip,
        p.acceleration + t35, R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        -(t34 + t33))).add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), -((t18 + t17) * t27)), holder_v)
        .add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip, R::literal(0.0),
        -((layer_viscosity_times_pair_friction + t19) * t27)), holder_v_dot) + t36)
        .add_product(R::select_less(R::literal(0.0), p.pair_greatest_slip, minus_pair_omega, t25
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t23 + t22 - t21) - t24),
        pair_growth);
    let pair_radius_times_pair_omega_dot = pair_radius * pair_omega_dot;
    let pair_ends_back_guard_rate = t35 - p.acceleration + pair_radius_times_pair_omega_dot
        + pair_omega_times_pair_growth;
    let pair_ends_forth_guard_rate = pair_radius_times_pair_omega_dot.sub_product(p.acceleration,
        R::literal(1.0).add_product(p.pair_greatest_slip, t26)) + pair_omega_times_pair_growth;
    let pair_turns_guard_rate = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t33
        - t34).add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t17
        - t18), holder_v).add_product(R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t19 - layer_viscosity_times_pair_friction), holder_v_dot)
        .add_product(R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t23
        - (t22 - t21)), pair_growth);
    [layer_touches_guard_rate, layer_opens_guard_rate, R::literal(1.0),
        pair_breaks_back_guard_rate, pair_breaks_forth_guard_rate, pair_ends_back_guard_rate,
        pair_ends_forth_guard_rate, pair_omega_dot, pair_turns_guard_rate]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. 90 operations.
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
    let t3 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t3 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t3 * p.pair_yarn_density * (pair_radius_squared
        - pair_bobbin_radius_squared);
    let pair_inertia = p.pair_bobbin_inertia.add_product(R::literal(core::f64::consts::FRAC_PI_2)
        * p.pair_package_width * p.pair_yarn_density, (pair_radius_squared * pair_radius_squared)
        .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared));
    let holder_pressure = p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
        pair_radius - p.pair_bobbin_radius).add_product(p.holder_gravity, pair_package_mass);
    let shape = (p.eccentricity * cos_drum_angle).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let layer_push = holder_pressure.add_product(p.layer_stiffness, layer_compression)
        .add_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression).sub_product(p.layer_viscosity, (p.eccentricity * turning
        * sin_drum_angle).add_product(R::literal(2.0) * p.ovality * turning, t1) + holder_v);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0),
        pair_friction_times_layer_push);
    let t4 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), t4);
    let t5 = pair_inertia * p.acceleration.sub_product(pair_omega, pair_growth)
        / pair_radius_squared;
    let pair_held = pair_resistance + t5;
    let t6 = R::select_less(p.pair_tension + t5 + R::select_less(layer_closed, R::literal(0.5),
        R::literal(0.0), pair_friction_times_layer_push + t4), R::literal(0.0), R::literal(-1.0),
        R::literal(1.0));
    let t7 = R::select_less(pair_limit - pair_held, R::literal(0.0), R::literal(-1.0),
        R::literal(1.0));
    let pair_slip_after_pair_begins = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (t7 - t6));
    let pair_omega_after_pair_ends_back = (surface_speed - pair_elastic) / pair_radius;
    let pair_slip_after_pair_ends_back = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (R::literal(1.0) - t6));
    let pair_omega_after_pair_ends_forth = (pair_elastic + surface_speed) / pair_radius;
    let pair_slip_after_pair_ends_forth = R::select_less(R::literal(0.0), p.pair_greatest_slip,
        R::literal(0.0), R::literal(0.5) * (t7 - R::literal(1.0)));
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
/// 180 recurrences. 28 sums of products an order.
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
    let t4 = R::literal(0.5) * p.pair_thread_area;
    let t5 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let t6 = t4 / t5;
    let pair_growth = pair_omega * t6;
    let t7 = pair_omega * pair_radius;
    let pair_sliding = t7 - surface_speed;
    let t8 = R::literal(0.5) * p.acceleration;
    let t9 = time * t8;
    let t10 = p.winding_speed + t9;
    let t11 = time * t3;
    let drum_angle = t11 * t10;
    let t12 = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let t13 = pair_radius * pair_radius;
    let t14 = t13 - t12;
    let t15 = t5 * p.pair_yarn_density;
    let pair_package_mass = t14 * t15;
    let t16 = t12 * t12;
    let t17 = t13 * t13;
    let t18 = t17 - t16;
    let t19 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let t20 = t19 * p.pair_yarn_density;
    let t21 = t18 * t20;
    let pair_inertia = p.pair_bobbin_inertia + t21;
    let t22 = p.holder_link_arm * p.holder_link_arm;
    let t23 = p.holder_holder_arm * p.holder_holder_arm;
    let t24 = p.holder_link_mass * t22;
    let t25 = t24 / t23;
    let t26 = p.holder_bobbin_mass + t25;
    let holder_mass = t26 + pair_package_mass;
    let t27 = p.force_phase + drum_angle;
    let t28 = t27.sin();
    let t29 = t27.cos();
    let t30 = t29 * p.force_amplitude;
    let t31 = p.package_phase + pair_phi;
    let t32 = t31.sin();
    let t33 = t31.cos();
    let t34 = t33 * p.package_force;
    let force = t30 + t34;
    let t35 = pair_radius - p.pair_bobbin_radius;
    let t36 = p.holder_stiffness * p.holder_spring_share;
    let t37 = t35 * t36;
    let t38 = t15 * p.holder_gravity;
    let t39 = t14 * t38;
    let t40 = p.holder_preload + t37;
    let holder_pressure = t40 + t39;
    let t41 = layer_surface * p.layer_stiffness;
    let t42 = layer_surface * layer_surface;
    let t43 = t42 * layer_surface;
    let t44 = t43 * p.layer_cubic_stiffness;
    let t45 = holder_pressure + t41;
    let layer_swelling = t45 + t44;
    let t46 = drum_angle * R::literal(2.0);
    let t47 = p.ovality_phase + t46;
    let t48 = t47.sin();
    let t49 = t47.cos();
    let t50 = t49 * p.ovality;
    let sin_drum_angle = drum_angle.sin();
    let cos_drum_angle = drum_angle.cos();
    let t51 = cos_drum_angle * p.eccentricity;
    let shape = t50 + t51;
    let layer_compression = shape - holder_x;
    let t52 = R::literal(2.0) * p.ovality;
    let t53 = t3 * t52;
    let t54 = surface_speed * t53;
    let t55 = t54 * t48;
    let t56 = t3 * p.eccentricity;
    let t57 = surface_speed * t56;
    let t58 = t57 * sin_drum_angle;
    let t59 = t55 + t58;
    let t60 = t59 + holder_v;
    let layer_compression_rate = -t60;
    let t61 = layer_compression * p.layer_stiffness;
    let t62 = layer_compression * layer_compression;
    let t63 = t62 * layer_compression;
    let t64 = t63 * p.layer_cubic_stiffness;
    let t65 = t60 * p.layer_viscosity;
    let t66 = holder_pressure + t61;
    let t67 = t66 + t64;
    let layer_push = t67 - t65;
    let t68 = layer_push * p.pair_friction;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t68);
    let t69 = p.pair_support_arm + p.pair_rolling_arm;
    let t70 = layer_push * t69;
    let t71 = t70 / pair_radius;
    let t72 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t71);
    let pair_resistance = p.pair_tension + t72;
    let t73 = pair_omega * pair_growth;
    let t74 = p.acceleration - t73;
    let t75 = pair_inertia * t74;
    let t76 = t75 / t13;
    let pair_held = pair_resistance + t76;
    let t77 = t68 * pair_sliding;
    let t78 = t77 / pair_elastic;
    let t79 = -t78;
    let t80 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t79);
    let pair_adhering = R::select_less(R::literal(0.0), p.pair_greatest_slip, t80, pair_held);
    let t81 = -t68;
    let t82 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t81);
    let t83 = R::select_less(pair_slip, R::literal(0.5), pair_adhering, t82);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit, t83);
    let t84 = R::literal(1.0) / holder_mass;
    let t85 = R::literal(1.0) / pair_inertia;
    let t86 = p.pair_yarn_density * p.pair_thread_area;
    let t87 = holder_v * t86;
    let t88 = t87 * pair_omega;
    let t89 = t88 * pair_radius;
    let t90 = holder_x * p.holder_stiffness;
    let t91 = t61 + t64;
    let t92 = -t91;
    let t93 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t92);
    let t94 = t90 + t93;
    let t95 = holder_pressure - t65;
    let t96 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t95);
    let t97 = force + t96;
    let t98 = t97 - t89;
    let t99 = t98 - holder_pressure;
    let t100 = t99 - t94;
    let t101 = pair_carried - pair_resistance;
    let t102 = pair_radius * t101;
    let t103 = t102 * t85;
    let pair_omega_dot = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t103);
    let holder_v_dot = t100 * t84;
    let t104 = R::literal(-1.0) / p.layer_viscosity;
    let t105 = layer_swelling * t104;
    let layer_surface_dot = R::select_less(layer_closed, R::literal(0.5), t105,
        layer_compression_rate);
    let t54_slope = p.acceleration * t53;
    let t57_slope = p.acceleration * t56;
    let inverse_pair_radius = R::literal(1.0) / pair_radius;
    let inverse_t13 = R::literal(1.0) / t13;
    let inverse_pair_elastic = R::literal(1.0) / pair_elastic;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let mut t10_before = t10;
    let mut t48_before = t48;
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
        let pair_growth_k = pair_omega_k * t6;
        let t7_k = pair_omega.mul_add(pair_radius_k, pair_radius.mul_add(pair_omega_k, sums[0]));
        let pair_sliding_k = t7_k - time_k * p.acceleration;
        let drum_angle_k = t11.mul_add(time_k * t8, t3 * t10_before);
        let t13_k = (pair_radius + pair_radius).mul_add(pair_radius_k, sums[1]);
        let t17_k = (t13 + t13).mul_add(t13_k, sums[3]);
        let t28_k = drum_angle_k.mul_add(t29, inverse * sums_3[0]);
        let t29_k = -drum_angle_k.mul_add(t28, inverse * sums_3[1]);
        let t32_k = pair_phi_k.mul_add(t33, inverse * sums_1[3]);
        let t33_k = -pair_phi_k.mul_add(t32, inverse * sums_2[0]);
        let force_k = t33_k.mul_add(p.package_force, t29_k * p.force_amplitude);
        let holder_pressure_k = t13_k.mul_add(t38, pair_radius_k * t36);
        let t42_k = (layer_surface + layer_surface).mul_add(layer_surface_k, sums[2]);
        let t43_k = layer_surface.mul_add(t42_k, t42.mul_add(layer_surface_k, sums_1[0]));
        let t45_k = layer_surface_k.mul_add(p.layer_stiffness, holder_pressure_k);
        let layer_swelling_k = t43_k.mul_add(p.layer_cubic_stiffness, t45_k);
        let t48_k = (drum_angle_k * R::literal(2.0)).mul_add(t49, inverse * sums_4[0]);
        let t49_k = -(drum_angle_k * R::literal(2.0)).mul_add(t48, inverse * sums_4[1]);
        let sin_drum_angle_k = drum_angle_k.mul_add(cos_drum_angle, inverse * sums_2[2]);
        let cos_drum_angle_k = -drum_angle_k.mul_add(sin_drum_angle, inverse * sums_2[3]);
        let shape_k = cos_drum_angle_k.mul_add(p.eccentricity, t49_k * p.ovality);
        let layer_compression_k = shape_k - holder_x_k;
        let t55_k = t54.mul_add(t48_k, t54_slope * t48_before);
        let t58_k = t57.mul_add(sin_drum_angle_k, t57_slope * sin_drum_angle_before);
        let t59_k = t55_k + t58_k;
        let t60_k = t59_k + holder_v_k;
        let layer_compression_rate_k = -t60_k;
        let t61_k = layer_compression_k * p.layer_stiffness;
        let t62_k = (layer_compression + layer_compression).mul_add(layer_compression_k, sums_5[0]);
        let t63_k = layer_compression.mul_add(t62_k, t62.mul_add(layer_compression_k, sums_5[1]));
        let t64_k = t63_k * p.layer_cubic_stiffness;
        let t65_k = t60_k * p.layer_viscosity;
        let t66_k = holder_pressure_k + t61_k;
        let t67_k = t66_k + t64_k;
        let layer_push_k = t67_k - t65_k;
        let t68_k = layer_push_k * p.pair_friction;
        let pair_limit_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t68_k);
        let t70_k = layer_push_k * t69;
        let t71_k = (-pair_radius_k).mul_add(t71, t70_k - sums_5[3]) * inverse_pair_radius;
        let t72_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t71_k);
        let t73_k = pair_omega.mul_add(pair_growth_k, pair_growth.mul_add(pair_omega_k, sums_1[1]));
        let t74_k = -t73_k;
        let t75_k = t74.mul_add(t17_k * t20, pair_inertia.mul_add(t74_k, sums_3[2]));
        let t76_k = (-t13_k).mul_add(t76, t75_k - sums_4[3]) * inverse_t13;
        let pair_held_k = t72_k + t76_k;
        let t77_k = pair_sliding.mul_add(t68_k, t68.mul_add(pair_sliding_k, sums_5[2]));
        let t78_k = (-pair_elastic_k).mul_add(t78, t77_k - sums_6[0]) * inverse_pair_elastic;
        let t79_k = -t78_k;
        let t80_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t79_k);
        let pair_adhering_k = R::select_less(R::literal(0.0), p.pair_greatest_slip, t80_k,
            pair_held_k);
        let t81_k = -t68_k;
        let t82_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t81_k);
        let t83_k = R::select_less(pair_slip, R::literal(0.5), pair_adhering_k, t82_k);
        let pair_carried_k = R::select_less(pair_slip, R::literal(-0.5), pair_limit_k, t83_k);
        let t84_k = -(t13_k * t15).mul_add(t84, sums_3[3]) * inverse_holder_mass;
        let t85_k = -(t17_k * t20).mul_add(t85, sums_4[2]) * inverse_pair_inertia;
        let t87_k = holder_v_k * t86;
        let t88_k = pair_omega.mul_add(t87_k, t87.mul_add(pair_omega_k, sums_1[2]));
        let t89_k = pair_radius.mul_add(t88_k, t88.mul_add(pair_radius_k, sums_2[1]));
        let t91_k = t61_k + t64_k;
        let t92_k = -t91_k;
        let t93_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t92_k);
        let t94_k = holder_x_k.mul_add(p.holder_stiffness, t93_k);
        let t95_k = holder_pressure_k - t65_k;
        let t96_k = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t95_k);
        let t97_k = force_k + t96_k;
        let t98_k = t97_k - t89_k;
        let t99_k = t98_k - holder_pressure_k;
        let t100_k = t99_k - t94_k;
        let t101_k = pair_carried_k - t72_k;
        let t102_k = pair_radius.mul_add(t101_k, t101.mul_add(pair_radius_k, sums_6[2]));
        let t103_k = t85.mul_add(t102_k, t102.mul_add(t85_k, sums_6[3]));
        let pair_omega_dot_k = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t103_k);
        let holder_v_dot_k = t84.mul_add(t100_k, t100.mul_add(t84_k, sums_6[1]));
        let t105_k = layer_swelling_k * t104;
        let layer_surface_dot_k = R::select_less(layer_closed, R::literal(0.5), t105_k,
            layer_compression_rate_k);
        lanes.set(order, [pair_omega_k, pair_radius_k, layer_surface_k, t13_k], [pair_radius_k,
            pair_radius_k, layer_surface_k, t13_k]);
        lanes_1.set(order, [layer_surface_k, pair_omega_k, pair_omega_k, k * pair_phi_k],
            [t42_k, pair_growth_k, t87_k, t33_k]);
        lanes_2.set(order, [k * pair_phi_k, pair_radius_k, k * drum_angle_k, k * drum_angle_k],
            [t32_k, t88_k, cos_drum_angle_k, sin_drum_angle_k]);
        lanes_3.set(order, [k * drum_angle_k, k * drum_angle_k, t17_k * t20, t13_k * t15],
            [t29_k, t28_k, t74_k, t84_k]);
        lanes_4.set(order, [k * drum_angle_k * R::literal(2.0), k * drum_angle_k * R::literal(2.0),
            t17_k * t20, t13_k], [t49_k, t48_k, t85_k, t76_k]);
        lanes_5.set(order, [layer_compression_k, layer_compression_k, pair_sliding_k,
            pair_radius_k], [layer_compression_k, t62_k, t68_k, t71_k]);
        lanes_6.set(order, [pair_elastic_k, t84_k, pair_radius_k, t85_k], [t78_k, t100_k, t101_k,
            t102_k]);
        t10_before = time_k * t8;
        t48_before = t48_k;
        sin_drum_angle_before = sin_drum_angle_k;
        rates = [holder_v_k, pair_omega_k, holder_v_dot_k, pair_omega_dot_k, layer_surface_dot_k,
            R::literal(0.0), pair_growth_k, R::literal(0.0)];
    }
}

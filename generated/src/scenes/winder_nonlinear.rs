// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   043c63311ea19c12d85c1b01e4daa61cbee7d8e2cd5a668cebb2bf009529e4c7  scenes/winder_nonlinear.toml
//   462073c365602dc1c3823d7405648f7fbcb20498ae45cb1799ddf8ddd5b6178b  units/textile/bobbin_holder.toml
//   937845f05690516562be96f1deb330621cd919c2a8d4957f2fdd8425c699dfe2  units/textile/yarn_layer_cubic.toml
//
// Bobbin on a winding drum, stiffening layer
//
// The bobbin of `winder_linear` on a stiffening layer. Second stage of modelling. Without disturbances
// and viscosity it is the Duffing oscillator.
//
// Source:
//   Winder study, second stage of modelling; every mass, stiffness, dimension, speed and disturbance is ours, for the study gives none.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 26, outputs 6.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 21 of 2 by 26.
// Operations: rate 53, mass_matrix 12, forcing 39, rate_jacobian 33, parameter_jacobian 214,
//     time_derivative 60, outputs 57, energy 37, power_balance 67, prepare 69, prepared_rate 34,
//     prepared_rate_jacobian 14, prepared_jacobians 151.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Bobbin on a winding drum, stiffening layer
    ///
    /// The bobbin of \`winder_linear\` on a stiffening layer. Second stage of modelling. Without disturbances
    /// and viscosity it is the Duffing oscillator.
    ///
    /// Source: Winder study, second stage of modelling; every mass, stiffness, dimension, speed and disturbance is ours, for the study gives none.
    WinderNonlinear: "winder_nonlinear", "Bobbin on a winding drum, stiffening layer";
    run from 0.0, until 0.5, points 2001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; series 2;
}

::machinist_contract::parameters! {
    winding_speed: 5.5, "m/s", "winding_speed", "speed of the drum's surface";
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
    holder_package_radius: 0.03, "m", "holder.package_radius", "R, radius of the package; by default that of an empty bobbin";
    holder_bobbin_radius: 0.03, "m", "holder.bobbin_radius", "Rmin, radius of the empty bobbin";
    holder_package_width: 0.15, "m", "holder.package_width", "H, width of the package";
    holder_yarn_density: 350.0, "kg/m^3", "holder.yarn_density", "rho, density of the wound yarn";
    holder_stiffness: 3800.0, "N/m", "holder.stiffness", "c_p, stiffness of the holder, reduced to the bobbin centre";
    holder_preload: 40.0, "N", "holder.preload", "N0, contact force of the empty bobbin at rest";
    holder_spring_share: 1.0, "1", "holder.spring_share", "share of the growth of the package's radius that deflects the spring; 0 where its seat follows";
    holder_gravity: 9.81, "m/s^2", "holder.gravity", "acceleration of free fall; 0 for a bobbin beside its drum";
    layer_stiffness: 42000.0, "N/m", "layer.stiffness", "c, stiffness of the layer";
    layer_cubic_stiffness: 2e9, "N/m^3", "layer.cubic_stiffness", "c3, cubic stiffness of the layer: a fifth of the stiffness at 2 mm";
    layer_viscosity: 95.0, "N s/m", "layer.viscosity", "h, damping of the layer";
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the bobbin centre";
    pressure: "N", "pressure", "force of the layer on the bobbin, relative to rest";
    contact_force: "N", "contact_force", "N, contact force; below zero the layer would pull";
    mass: "kg", "mass", "reduced mass m(R)";
    force: "N", "force", "disturbance force";
    shape: "m", "shape", "drum profile";
}

::machinist_contract::states! {
    HOLDER_X: position, 0.001, "m", "holder.x", "deflection of the bobbin centre";
    HOLDER_V: velocity, 0.1, "m/s", "holder.v", "rate of deflection of the bobbin centre";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 2 by 2 { 0 [1] 1 [0 1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 2 by 26 { 1 [0 1 2 3 4 5 6 7 8 11 12 13 14 15 16 17 18 19 23 24 25]
        }
}

::machinist_contract::constants! {
    drum_speed, package_speed, t2, t4, eccentricity_times_drum_speed, inverse_holder_mass, t5, t6,
    holder_v_dot_by_holder_v, force_amplitude_over_drum_radius, t7, t8,
    eccentricity_over_drum_radius, t10, t11, t12, t13, t14, t15, t16, t17,
    ovality_times_layer_stiffness, t18, layer_viscosity_times_drum_speed, t19, t21, t22, t23, t24,
    t25, t26, t27, t28, winding_speed_times_eccentricity, t29
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 69 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let t1 = R::literal(core::f64::consts::PI) * p.holder_package_width;
    let holder_package_mass = t1 * p.holder_yarn_density * t0;
    let t2 = R::literal(2.0) * drum_speed;
    let holder_link_arm_squared = p.holder_link_arm * p.holder_link_arm;
    let holder_holder_arm_squared = p.holder_holder_arm * p.holder_holder_arm;
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * holder_link_arm_squared / holder_holder_arm_squared;
    let t3 = R::literal(2.0) * p.ovality;
    let t4 = t3 * drum_speed;
    let eccentricity_times_drum_speed = p.eccentricity * drum_speed;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let t5 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t6 = p.holder_stiffness + p.layer_stiffness;
    let holder_v_dot_by_holder_v = -(p.layer_viscosity * inverse_holder_mass);
    let force_amplitude_over_drum_radius = p.force_amplitude / p.drum_radius;
    let t7 = p.package_force / p.holder_package_radius;
    let t8 = t3 / p.drum_radius;
    let eccentricity_over_drum_radius = p.eccentricity / p.drum_radius;
    let t9 = R::literal(4.0) * p.ovality;
    let t10 = t9 * drum_speed / p.drum_radius;
    let t11 = eccentricity_times_drum_speed / p.drum_radius;
    let t12 = t4 / p.drum_radius;
    let t13 = p.force_amplitude * drum_speed / p.drum_radius;
    let drum_speed_squared = drum_speed * drum_speed;
    let t14 = t9 * drum_speed_squared / p.drum_radius;
    let t15 = p.eccentricity * drum_speed_squared / p.drum_radius;
    let t16 = R::literal(2.0) * p.layer_viscosity * drum_speed;
    let t17 = t3 * p.layer_viscosity * drum_speed;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let t18 = R::literal(-3.0) * p.ovality * p.layer_cubic_stiffness;
    let layer_viscosity_times_drum_speed = p.layer_viscosity * drum_speed;
    let t19 = holder_link_arm_squared / holder_holder_arm_squared;
    let t20 = R::literal(2.0) * p.holder_link_mass;
    let t21 = t20 * p.holder_link_arm / holder_holder_arm_squared;
    let t22 = t20 * holder_link_arm_squared / (holder_holder_arm_squared * p.holder_holder_arm);
    let t23 = p.package_force * package_speed / p.holder_package_radius;
    let t24 = R::literal(core::f64::consts::TAU) * p.holder_package_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t25 = R::literal(core::f64::consts::TAU) * p.holder_bobbin_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t26 = R::literal(-3.141_592_653_589_793) * p.holder_yarn_density * t0;
    let t27 = t1 * t0;
    let t28 = R::literal(2.0) * p.winding_speed * p.ovality;
    let winding_speed_times_eccentricity = p.winding_speed * p.eccentricity;
    let t29 = R::literal(-1.0) / p.drum_radius;
    Constants { drum_speed, package_speed, t2, t4, eccentricity_times_drum_speed,
        inverse_holder_mass, t5, t6, holder_v_dot_by_holder_v, force_amplitude_over_drum_radius,
        t7, t8, eccentricity_over_drum_radius, t10, t11, t12, t13, t14, t15, t16, t17,
        ovality_times_layer_stiffness, t18, layer_viscosity_times_drum_speed, t19, t21, t22, t23,
        t24, t25, t26, t27, t28, winding_speed_times_eccentricity, t29 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_deflection, p.initial_velocity]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 34 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [holder_x, holder_v] = *state;
    let t0 = p.ovality_phase.add_product(c.t2, time);
    let drum_speed_times_time = c.drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3), (_, t4)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(c.package_speed, time)]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let holder_v_dot = (force.sub_product(p.layer_viscosity, (c.eccentricity_times_drum_speed
        * sin_drum_speed_times_time).add_product(c.t4, t1) + holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression)
        .sub_product(p.layer_cubic_stiffness, layer_compression * layer_compression
        * layer_compression)) * c.inverse_holder_mass;
    [holder_v, holder_v_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 12 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    [holder_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 39 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3), (_, t4)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let holder_x_forcing = force.sub_product(p.layer_viscosity, (p.eccentricity * drum_speed
        * sin_drum_speed_times_time).add_product(R::literal(2.0) * p.ovality * drum_speed, t1)
        + holder_v) - (p.holder_stiffness * holder_x).sub_product(p.layer_stiffness,
        layer_compression).sub_product(p.layer_cubic_stiffness, layer_compression
        * layer_compression * layer_compression);
    [holder_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 14 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    let [holder_x, ..] = *state;
    let [(_, t0), (_, cos_drum_speed_times_time)]
        = R::sin_cos_each([p.ovality_phase.add_product(c.t2, time), c.drum_speed * time]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    let holder_v_dot_by_holder_x = -(c.t6.add_product(c.t5, layer_compression * layer_compression)
        * c.inverse_holder_mass);
    [R::literal(1.0), holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 151 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 24] {
    let [holder_x, holder_v] = *state;
    let t0 = p.ovality_phase.add_product(c.t2, time);
    let drum_speed_times_time = c.drum_speed * time;
    let t1 = p.force_phase + drum_speed_times_time;
    let t2 = p.package_phase.add_product(c.package_speed, time);
    let [(t3, t4), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t5, t6), (t7, t8)]
        = R::sin_cos_each([t0, drum_speed_times_time, t1, t2]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t4);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t9 = c.t5 * layer_compression_squared;
    let holder_v_dot_by_holder_x = -((c.t6 + t9) * c.inverse_holder_mass);
    let force = (p.force_amplitude * t6).add_product(p.package_force, t8);
    let t10 = layer_compression_squared * layer_compression;
    let holder_v_dot = (force.sub_product(p.layer_viscosity, (c.eccentricity_times_drum_speed
        * sin_drum_speed_times_time).add_product(c.t4, t3) + holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression)
        .sub_product(p.layer_cubic_stiffness, t10)) * c.inverse_holder_mass;
    let t11 = (c.eccentricity_over_drum_radius * time * sin_drum_speed_times_time).add_product(c.t8
        * time, t3);
    let t12 = c.t11 * time;
    let holder_v_dot_by_winding_speed = -(((c.force_amplitude_over_drum_radius * time * t5)
        .add_product(p.layer_viscosity, (c.t10 * time * t4).add_product(c.t8, t3).add_product(t12,
        cos_drum_speed_times_time).add_product(c.eccentricity_over_drum_radius,
        sin_drum_speed_times_time)).add_product(c.t7 * time, t7) + (p.layer_stiffness * t11)
        .add_product(c.t5 * t11, layer_compression_squared)) * c.inverse_holder_mass);
    let t13 = (t12 * sin_drum_speed_times_time).add_product(c.t12 * time, t3);
    let holder_v_dot_by_drum_radius = ((c.t13 * time * t5).add_product(p.layer_viscosity,
        (c.t12 * t3).add_product(c.t14 * time, t4).add_product(c.t15 * time,
        cos_drum_speed_times_time).add_product(c.t11, sin_drum_speed_times_time))
        + (p.layer_stiffness * t13).add_product(c.t5 * t13, layer_compression_squared))
        * c.inverse_holder_mass;
    let holder_v_dot_by_force_amplitude = t6 * c.inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * t5 * c.inverse_holder_mass);
    let holder_v_dot_by_package_force = t8 * c.inverse_holder_mass;
    let holder_v_dot_by_package_phase = -(p.package_force * t7 * c.inverse_holder_mass);
    let holder_v_dot_by_ovality = (p.layer_stiffness * t4).add_product(t9, t4).sub_product(c.t16,
        t3) * c.inverse_holder_mass;
    let holder_v_dot_by_ovality_phase = (-(c.ovality_times_layer_stiffness * t3)).add_product(c.t18
        * layer_compression_squared, t3).sub_product(c.t17, t4) * c.inverse_holder_mass;
    let holder_v_dot_by_eccentricity = (p.layer_stiffness * cos_drum_speed_times_time)
        .add_product(t9, cos_drum_speed_times_time).sub_product(c.layer_viscosity_times_drum_speed,
        sin_drum_speed_times_time) * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t19 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t21 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t22 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_radius = (c.t23 * time * t7).sub_product(c.t24,
        holder_v_dot) * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_radius = c.t25 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_width = c.t26 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_yarn_density = -(c.t27 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_stiffness = -(holder_x * c.inverse_holder_mass);
    let holder_v_dot_by_layer_stiffness = layer_compression * c.inverse_holder_mass;
    let holder_v_dot_by_layer_cubic_stiffness = t10 * c.inverse_holder_mass;
    let holder_v_dot_by_layer_viscosity = c.t29 * (p.drum_radius * holder_v).add_product(c.t28, t3)
        .add_product(c.winding_speed_times_eccentricity, sin_drum_speed_times_time)
        * c.inverse_holder_mass;
    [R::literal(1.0), holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v,
        holder_v_dot_by_winding_speed, holder_v_dot_by_drum_radius,
        holder_v_dot_by_force_amplitude, holder_v_dot_by_force_phase,
        holder_v_dot_by_package_force, holder_v_dot_by_package_phase, holder_v_dot_by_ovality,
        holder_v_dot_by_ovality_phase, holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass, holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm, holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_package_radius, holder_v_dot_by_holder_bobbin_radius,
        holder_v_dot_by_holder_package_width, holder_v_dot_by_holder_yarn_density,
        holder_v_dot_by_holder_stiffness, holder_v_dot_by_layer_stiffness,
        holder_v_dot_by_layer_cubic_stiffness, holder_v_dot_by_layer_viscosity]
}

/// Partial derivative of `y'` with respect to time. 60 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [holder_x, ..] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t3, _), (t4, _)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    let layer_compression = shape - holder_x;
    let t5 = (p.eccentricity * drum_speed * sin_drum_speed_times_time).add_product(R::literal(2.0)
        * p.ovality * drum_speed, t1);
    let drum_speed_squared = drum_speed * drum_speed;
    let holder_v_dot_by_time = ((-(p.force_amplitude * drum_speed * t3))
        .add_product(p.layer_viscosity, (-(p.eccentricity * drum_speed_squared
        * cos_drum_speed_times_time)).add_product(R::literal(-4.0) * p.ovality
        * drum_speed_squared, t2)).sub_product(p.package_force * package_speed, t4)
        - (p.layer_stiffness * t5).add_product(R::literal(3.0) * p.layer_cubic_stiffness * t5,
        layer_compression * layer_compression)) * (R::literal(1.0) / holder_mass);
    [R::literal(0.0), holder_v_dot_by_time]
}

/// Wanted outputs. 57 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3), (_, t4)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let t5 = p.layer_stiffness * layer_compression;
    let t6 = p.layer_cubic_stiffness * (layer_compression * layer_compression * layer_compression);
    let t7 = p.layer_viscosity * ((p.eccentricity * drum_speed * sin_drum_speed_times_time)
        .add_product(R::literal(2.0) * p.ovality * drum_speed, t1) + holder_v);
    Outputs {
        deflection: holder_x,
        pressure: t5 + t6 - t7,
        contact_force: p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
            p.holder_package_radius - p.holder_bobbin_radius).add_product(p.holder_gravity,
            holder_package_mass) + t5 + t6 - t7,
        mass: holder_mass,
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\]. 37 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let [(_, t0), (_, cos_drum_speed_times_time)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed * time]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    Energy {
        kinetic: R::literal(0.5) * holder_mass * (holder_v * holder_v),
        potential: (R::literal(0.5) * p.holder_stiffness * (holder_x * holder_x))
            .add_product(R::literal(0.25) * p.layer_cubic_stiffness, layer_compression_squared
            * layer_compression_squared).add_product(R::literal(0.5) * p.layer_stiffness,
            layer_compression_squared),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 67 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3), (_, t4)]
        = R::sin_cos_each([t0, drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let t5 = (p.eccentricity * drum_speed * sin_drum_speed_times_time).add_product(R::literal(2.0)
        * p.ovality * drum_speed, t1);
    let t6 = t5 + holder_v;
    let t7 = p.layer_stiffness * layer_compression;
    let t8 = layer_compression * layer_compression * layer_compression;
    let t9 = (-t7).add_product(p.holder_stiffness, holder_x).sub_product(p.layer_cubic_stiffness,
        t8);
    let holder_v_dot = (force.sub_product(p.layer_viscosity, t6) - t9) * (R::literal(1.0)
        / holder_mass);
    let t10 = t7 * t5;
    let t11 = p.layer_cubic_stiffness * t5 * t8;
    PowerBalance {
        stored_rate: (-(t10 + t11)).add_product(t9, holder_v).add_product(holder_mass * holder_v,
            holder_v_dot),
        supplied: (-t10).add_product(holder_v, force) - t11,
        dissipated: p.layer_viscosity * holder_v * t6,
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 82 recurrences. 2 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 2>::new(workspace, coefficients.len());
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.holder_bobbin_radius * p.holder_bobbin_radius;
    let t1 = p.holder_package_radius * p.holder_package_radius;
    let t2 = t1 - t0;
    let t3 = R::literal(core::f64::consts::PI) * p.holder_package_width;
    let t4 = t3 * p.holder_yarn_density;
    let holder_package_mass = t4 * t2;
    let t5 = R::literal(2.0) * drum_speed;
    let t6 = time * t5;
    let t7 = p.ovality_phase + t6;
    let t8 = t7.sin();
    let t9 = t7.cos();
    let t10 = t9 * p.ovality;
    let t11 = time * drum_speed;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = t13 * p.eccentricity;
    let shape = t10 + t14;
    let t15 = p.holder_link_arm * p.holder_link_arm;
    let t16 = p.holder_holder_arm * p.holder_holder_arm;
    let t17 = p.holder_link_mass * t15;
    let t18 = t17 / t16;
    let t19 = p.holder_bobbin_mass + holder_package_mass;
    let holder_mass = t19 + t18;
    let t20 = p.force_phase + t11;
    let t21 = t20.sin();
    let t22 = t20.cos();
    let t23 = t22 * p.force_amplitude;
    let t24 = time * package_speed;
    let t25 = p.package_phase + t24;
    let t26 = t25.sin();
    let t27 = t25.cos();
    let t28 = t27 * p.package_force;
    let force = t23 + t28;
    let layer_compression = shape - holder_x;
    let t29 = R::literal(2.0) * p.ovality;
    let t30 = t29 * drum_speed;
    let t31 = t8 * t30;
    let t32 = p.eccentricity * drum_speed;
    let t33 = t12 * t32;
    let t34 = t31 + t33;
    let t35 = t34 + holder_v;
    let t36 = R::literal(1.0) / holder_mass;
    let t37 = layer_compression * p.layer_stiffness;
    let t38 = layer_compression * layer_compression;
    let t39 = t38 * layer_compression;
    let t40 = t39 * p.layer_cubic_stiffness;
    let t41 = holder_x * p.holder_stiffness;
    let t42 = t41 - t37;
    let t43 = t42 - t40;
    let t44 = t35 * p.layer_viscosity;
    let t45 = force - t44;
    let t46 = t45 - t43;
    let holder_v_dot = t46 * t36;
    let mut t8_before = t8;
    let mut t9_before = t9;
    let mut t12_before = t12;
    let mut t13_before = t13;
    let mut t21_before = t21;
    let mut t22_before = t22;
    let mut t26_before = t26;
    let mut t27_before = t27;
    let mut rates = [holder_v, holder_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [holder_x_k, holder_v_k] = *state_k;
        let sums = lanes.sums(order);
        let t8_k = inverse * t5 * t9_before;
        let t9_k = -inverse * t5 * t8_before;
        let t12_k = inverse * drum_speed * t13_before;
        let t13_k = -inverse * drum_speed * t12_before;
        let shape_k = t13_k.mul_add(p.eccentricity, t9_k * p.ovality);
        let t21_k = inverse * drum_speed * t22_before;
        let t22_k = -inverse * drum_speed * t21_before;
        let t26_k = inverse * package_speed * t27_before;
        let t27_k = -inverse * package_speed * t26_before;
        let force_k = t27_k.mul_add(p.package_force, t22_k * p.force_amplitude);
        let layer_compression_k = shape_k - holder_x_k;
        let t34_k = t12_k.mul_add(t32, t8_k * t30);
        let t35_k = t34_k + holder_v_k;
        let t38_k = (layer_compression + layer_compression).mul_add(layer_compression_k, sums[0]);
        let t39_k = layer_compression.mul_add(t38_k, t38.mul_add(layer_compression_k, sums[1]));
        let t42_k = (-layer_compression_k).mul_add(p.layer_stiffness, holder_x_k
            * p.holder_stiffness);
        let t43_k = (-t39_k).mul_add(p.layer_cubic_stiffness, t42_k);
        let t45_k = (-t35_k).mul_add(p.layer_viscosity, force_k);
        let t46_k = t45_k - t43_k;
        let holder_v_dot_k = t46_k * t36;
        lanes.set(order, [layer_compression_k, layer_compression_k], [layer_compression_k, t38_k]);
        t8_before = t8_k;
        t9_before = t9_k;
        t12_before = t12_k;
        t13_before = t13_k;
        t21_before = t21_k;
        t22_before = t22_k;
        t26_before = t26_k;
        t27_before = t27_k;
        rates = [holder_v_k, holder_v_dot_k];
    }
}

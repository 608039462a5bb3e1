// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   e92ebfbc124e5785539c476df08bb6272aede15ba88178715aea9a9234d52d8c  scenes/winder_linear.toml
//   462073c365602dc1c3823d7405648f7fbcb20498ae45cb1799ddf8ddd5b6178b  units/textile/bobbin_holder.toml
//   810052002bc2a51c9d17a23c2e6307af4fcc0515b7557ff0f6eec05a28d2a458  units/textile/yarn_layer.toml
//
// Bobbin on a winding drum, linear layer
//
// The bobbin rests on a drum that excites it once per revolution by its unbalance and twice per
// revolution by its shape. First stage of modelling: layer and holder are linear.
//
// Source:
//   Winder study, first stage of modelling; every mass, stiffness, dimension, speed and disturbance is ours, for the study gives none.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 25, outputs 6.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 20 of 2 by 25.
// Operations: rate 49, mass_matrix 12, forcing 35, rate_jacobian 18, parameter_jacobian 203,
//     time_derivative 61, outputs 52, energy 33, power_balance 59, prepare 80, prepared_rate 30,
//     prepared_jacobians 128.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Bobbin on a winding drum, linear layer
    ///
    /// The bobbin rests on a drum that excites it once per revolution by its unbalance and twice per
    /// revolution by its shape. First stage of modelling: layer and holder are linear.
    ///
    /// Source: Winder study, first stage of modelling; every mass, stiffness, dimension, speed and disturbance is ours, for the study gives none.
    WinderLinear: "winder_linear", "Bobbin on a winding drum, linear layer";
    run from 0.0, until 0.5, points 2001, rtol 1e-8, method "tsit5";
    quadratures 0, discontinuities 0;
    prepared; jacobians_at_once; linear; series 0;
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
    PARAMETER_JACOBIAN_PATTERN: 2 by 25 { 1 [0 1 2 3 4 5 6 7 8 11 12 13 14 15 16 17 18 19 23 24] }
}

::machinist_contract::constants! {
    drum_speed, package_speed, t2, t4, eccentricity_times_drum_speed, inverse_holder_mass,
    holder_v_dot_by_holder_x, holder_v_dot_by_holder_v, t6, t9, t10,
    winding_speed_times_eccentricity, t11, drum_radius_times_force_amplitude, t12, t14, t15, t16,
    t17, t18, t19, t20, t21, t22, t23, drum_speed_over_drum_radius_squared, t24, t25,
    ovality_times_layer_stiffness, layer_viscosity_times_drum_speed, t26, t28, t29, t30, t31, t32,
    t33, t34, t35, t36
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 80 operations.
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
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + p.layer_stiffness)
        * inverse_holder_mass);
    let holder_v_dot_by_holder_v = -(p.layer_viscosity * inverse_holder_mass);
    let t5 = R::literal(4.0) * p.winding_speed * p.ovality;
    let t6 = t5 * p.holder_package_radius * p.layer_viscosity;
    let t7 = R::literal(2.0) * p.drum_radius * p.ovality;
    let t8 = t7 * p.holder_package_radius;
    let t9 = t8 * p.layer_stiffness;
    let t10 = t8 * p.layer_viscosity;
    let winding_speed_times_eccentricity = p.winding_speed * p.eccentricity;
    let t11 = winding_speed_times_eccentricity * p.holder_package_radius * p.layer_viscosity;
    let drum_radius_times_force_amplitude = p.drum_radius * p.force_amplitude;
    let t12 = drum_radius_times_force_amplitude * p.holder_package_radius;
    let drum_radius_times_eccentricity = p.drum_radius * p.eccentricity;
    let t13 = drum_radius_times_eccentricity * p.holder_package_radius;
    let t14 = t13 * p.layer_stiffness;
    let drum_radius_squared = p.drum_radius * p.drum_radius;
    let t15 = p.package_force * drum_radius_squared;
    let t16 = t13 * p.layer_viscosity;
    let t17 = R::literal(-1.0) / (drum_radius_squared * p.holder_package_radius);
    let t18 = t7 * p.layer_stiffness;
    let t19 = t7 * p.layer_viscosity;
    let t20 = t5 * p.layer_viscosity;
    let t21 = winding_speed_times_eccentricity * p.layer_viscosity;
    let t22 = drum_radius_times_eccentricity * p.layer_stiffness;
    let t23 = drum_radius_times_eccentricity * p.layer_viscosity;
    let drum_speed_over_drum_radius_squared = drum_speed / drum_radius_squared;
    let t24 = R::literal(2.0) * p.layer_viscosity * drum_speed;
    let t25 = t3 * p.layer_viscosity * drum_speed;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let layer_viscosity_times_drum_speed = p.layer_viscosity * drum_speed;
    let t26 = holder_link_arm_squared / holder_holder_arm_squared;
    let t27 = R::literal(2.0) * p.holder_link_mass;
    let t28 = t27 * p.holder_link_arm / holder_holder_arm_squared;
    let t29 = t27 * holder_link_arm_squared / (holder_holder_arm_squared * p.holder_holder_arm);
    let t30 = p.package_force * package_speed / p.holder_package_radius;
    let t31 = R::literal(core::f64::consts::TAU) * p.holder_package_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t32 = R::literal(core::f64::consts::TAU) * p.holder_bobbin_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t33 = R::literal(-3.141_592_653_589_793) * p.holder_yarn_density * t0;
    let t34 = t1 * t0;
    let t35 = R::literal(2.0) * p.winding_speed * p.ovality;
    let t36 = R::literal(-1.0) / p.drum_radius;
    Constants { drum_speed, package_speed, t2, t4, eccentricity_times_drum_speed,
        inverse_holder_mass, holder_v_dot_by_holder_x, holder_v_dot_by_holder_v, t6, t9, t10,
        winding_speed_times_eccentricity, t11, drum_radius_times_force_amplitude, t12, t14, t15,
        t16, t17, t18, t19, t20, t21, t22, t23, drum_speed_over_drum_radius_squared, t24, t25,
        ovality_times_layer_stiffness, layer_viscosity_times_drum_speed, t26, t28, t29, t30, t31,
        t32, t33, t34, t35, t36 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 30 operations.
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
        * holder_x).sub_product(p.layer_stiffness, layer_compression)) * c.inverse_holder_mass;
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

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 35 operations.
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
        layer_compression);
    [holder_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    [R::literal(1.0), c.holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 128 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 23] {
    let [holder_x, holder_v] = *state;
    let t0 = p.ovality_phase.add_product(c.t2, time);
    let drum_speed_times_time = c.drum_speed * time;
    let t1 = p.force_phase + drum_speed_times_time;
    let t2 = p.package_phase.add_product(c.package_speed, time);
    let [(t3, t4), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t5, t6), (t7, t8)]
        = R::sin_cos_each([t0, drum_speed_times_time, t1, t2]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t4);
    let force = (p.force_amplitude * t6).add_product(p.package_force, t8);
    let layer_compression = shape - holder_x;
    let holder_v_dot = (force.sub_product(p.layer_viscosity, (c.eccentricity_times_drum_speed
        * sin_drum_speed_times_time).add_product(c.t4, t3) + holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression)) * c.inverse_holder_mass;
    let holder_v_dot_by_winding_speed = c.t17 * (c.t6 * time * t4).add_product(c.t9 * time, t3)
        .add_product(c.t10, t3).add_product(c.t11 * time, cos_drum_speed_times_time)
        .add_product(c.t12 * time, t5).add_product(c.t14 * time, sin_drum_speed_times_time)
        .add_product(c.t15 * time, t7).add_product(c.t16, sin_drum_speed_times_time)
        * c.inverse_holder_mass;
    let holder_v_dot_by_drum_radius = c.drum_speed_over_drum_radius_squared * (c.t18 * time * t3)
        .add_product(c.t19, t3).add_product(c.t20 * time, t4).add_product(c.t21 * time,
        cos_drum_speed_times_time).add_product(c.drum_radius_times_force_amplitude * time, t5)
        .add_product(c.t22 * time, sin_drum_speed_times_time).add_product(c.t23,
        sin_drum_speed_times_time) * c.inverse_holder_mass;
    let holder_v_dot_by_force_amplitude = t6 * c.inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * t5 * c.inverse_holder_mass);
    let holder_v_dot_by_package_force = t8 * c.inverse_holder_mass;
    let holder_v_dot_by_package_phase = -(p.package_force * t7 * c.inverse_holder_mass);
    let holder_v_dot_by_ovality = (p.layer_stiffness * t4).sub_product(c.t24, t3)
        * c.inverse_holder_mass;
    let holder_v_dot_by_ovality_phase = -((c.t25 * t4).add_product(c.ovality_times_layer_stiffness,
        t3) * c.inverse_holder_mass);
    let holder_v_dot_by_eccentricity = (p.layer_stiffness * cos_drum_speed_times_time)
        .sub_product(c.layer_viscosity_times_drum_speed, sin_drum_speed_times_time)
        * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t26 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t28 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t29 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_radius = (c.t30 * time * t7).sub_product(c.t31,
        holder_v_dot) * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_radius = c.t32 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_width = c.t33 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_yarn_density = -(c.t34 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_stiffness = -(holder_x * c.inverse_holder_mass);
    let holder_v_dot_by_layer_stiffness = layer_compression * c.inverse_holder_mass;
    let holder_v_dot_by_layer_viscosity = c.t36 * (p.drum_radius * holder_v).add_product(c.t35, t3)
        .add_product(c.winding_speed_times_eccentricity, sin_drum_speed_times_time)
        * c.inverse_holder_mass;
    [R::literal(1.0), c.holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v,
        holder_v_dot_by_winding_speed, holder_v_dot_by_drum_radius,
        holder_v_dot_by_force_amplitude, holder_v_dot_by_force_phase,
        holder_v_dot_by_package_force, holder_v_dot_by_package_phase, holder_v_dot_by_ovality,
        holder_v_dot_by_ovality_phase, holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass, holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm, holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_package_radius, holder_v_dot_by_holder_bobbin_radius,
        holder_v_dot_by_holder_package_width, holder_v_dot_by_holder_yarn_density,
        holder_v_dot_by_holder_stiffness, holder_v_dot_by_layer_stiffness,
        holder_v_dot_by_layer_viscosity]
}

/// Partial derivative of `y'` with respect to time. 61 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
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
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm * p.holder_holder_arm);
    let t5 = (R::literal(-4.0) * p.winding_speed * p.ovality * p.holder_package_radius
        * p.layer_viscosity * t2).sub_product(R::literal(2.0) * p.drum_radius * p.ovality
        * p.holder_package_radius * p.layer_stiffness, t1).sub_product(p.winding_speed
        * p.eccentricity * p.holder_package_radius * p.layer_viscosity, cos_drum_speed_times_time)
        .sub_product(p.drum_radius * p.force_amplitude * p.holder_package_radius, t3)
        .sub_product(p.drum_radius * p.eccentricity * p.holder_package_radius * p.layer_stiffness,
        sin_drum_speed_times_time).sub_product(p.package_force * (p.drum_radius * p.drum_radius),
        t4);
    let holder_v_dot_by_time = drum_speed / (p.drum_radius * p.holder_package_radius) * t5
        * (R::literal(1.0) / holder_mass);
    [R::literal(0.0), holder_v_dot_by_time]
}

/// Wanted outputs. 52 operations.
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
    let t6 = p.layer_viscosity * ((p.eccentricity * drum_speed * sin_drum_speed_times_time)
        .add_product(R::literal(2.0) * p.ovality * drum_speed, t1) + holder_v);
    Outputs {
        deflection: holder_x,
        pressure: t5 - t6,
        contact_force: p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
            p.holder_package_radius - p.holder_bobbin_radius).add_product(p.holder_gravity,
            holder_package_mass) + t5 - t6,
        mass: holder_mass,
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\]. 33 operations.
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
    Energy {
        kinetic: R::literal(0.5) * holder_mass * (holder_v * holder_v),
        potential: (R::literal(0.5) * p.holder_stiffness * (holder_x * holder_x))
            .add_product(R::literal(0.5) * p.layer_stiffness, layer_compression
            * layer_compression),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 59 operations.
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
    let t8 = (-t7).add_product(p.holder_stiffness, holder_x);
    let holder_v_dot = (force.sub_product(p.layer_viscosity, t6) - t8) * (R::literal(1.0)
        / holder_mass);
    let t9 = t7 * t5;
    PowerBalance {
        stored_rate: (-t9).add_product(t8, holder_v).add_product(holder_mass * holder_v,
            holder_v_dot),
        supplied: (-t9).add_product(holder_v, force),
        dissipated: p.layer_viscosity * holder_v * t6,
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 77 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
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
    let t38 = holder_x * p.holder_stiffness;
    let t39 = t38 - t37;
    let t40 = t35 * p.layer_viscosity;
    let t41 = force - t40;
    let t42 = t41 - t39;
    let holder_v_dot = t42 * t36;
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
        let t39_k = (-layer_compression_k).mul_add(p.layer_stiffness, holder_x_k
            * p.holder_stiffness);
        let t41_k = (-t35_k).mul_add(p.layer_viscosity, force_k);
        let t42_k = t41_k - t39_k;
        let holder_v_dot_k = t42_k * t36;
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

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(1, 0), (1, 0), (1, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. 52 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 12] {
    let [(sin_ovality_phase, cos_ovality_phase), (sin_force_phase, cos_force_phase),
        (sin_package_phase, cos_package_phase)] = R::sin_cos_each([p.ovality_phase, p.force_phase,
        p.package_phase]);
    let winding_speed_over_drum_radius = p.winding_speed / p.drum_radius;
    let t0 = R::literal(2.0) * p.ovality * winding_speed_over_drum_radius;
    let t1 = R::literal(1.0) / (p.holder_bobbin_mass.add_product(R::literal(core::f64::consts::PI)
        * p.holder_package_width * p.holder_yarn_density, (p.holder_package_radius
        * p.holder_package_radius).sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius))
        + p.holder_link_mass * (p.holder_link_arm * p.holder_link_arm) / (p.holder_holder_arm
        * p.holder_holder_arm));
    [R::literal(0.0), winding_speed_over_drum_radius, (p.eccentricity
        * p.layer_stiffness).add_product(cos_force_phase, p.force_amplitude) * t1,
        -((p.eccentricity * winding_speed_over_drum_radius * p.layer_viscosity)
        .add_product(sin_force_phase, p.force_amplitude) * t1), R::literal(0.0),
        p.winding_speed / p.holder_package_radius, cos_package_phase * p.package_force * t1,
        -(sin_package_phase * p.package_force * t1), R::literal(0.0),
        R::literal(2.0) * winding_speed_over_drum_radius, (cos_ovality_phase * p.ovality
        * p.layer_stiffness).sub_product(sin_ovality_phase * t0, p.layer_viscosity) * t1,
        -((cos_ovality_phase * t0 * p.layer_viscosity).add_product(sin_ovality_phase * p.ovality,
        p.layer_stiffness) * t1)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

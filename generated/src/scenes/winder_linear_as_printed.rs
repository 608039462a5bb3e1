// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   1529dc6642667f9413586a3a0b8343f0613bb4a880f16e39f87104614a519bec  scenes/winder_linear_as_printed.toml
//   8ca6e2c66edff51f8384a43a22a8df919edda76a00d925f77133ded495929317  units/textile/bobbin_holder_as_printed.toml
//   a98fb80ae147033f3728d258add893c08815c557d9b5492e4a39a4ca0d59636a  units/textile/yarn_layer_as_printed.toml
//
// Bobbin on a winding drum as printed
//
// The bobbin of `winder_linear` by the printed equation, m q'' + h q' + (c + c_p) q = F(t) + c Y(t),
// with the mass of its reduced weight. For the reproduction ledger.
//
// Source:
//   Winder study, equations (16) and (18), as printed; every mass, stiffness, dimension, speed and disturbance is ours.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, parameters 25, outputs 6.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 20 of 2 by 25.
// Operations: rate 38, mass_matrix 10, forcing 26, rate_jacobian 16, parameter_jacobian 129,
//     time_derivative 41, outputs 41, energy 31, power_balance 56, prepare 47, prepared_rate 24,
//     prepared_jacobians 87.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Bobbin on a winding drum as printed
    ///
    /// The bobbin of \`winder_linear\` by the printed equation, m q'' + h q' + (c + c_p) q = F(t) + c Y(t),
    /// with the mass of its reduced weight. For the reproduction ledger.
    ///
    /// Source: Winder study, equations (16) and (18), as printed; every mass, stiffness, dimension, speed and disturbance is ours.
    WinderLinearAsPrinted: "winder_linear_as_printed", "Bobbin on a winding drum as printed";
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
    drum_speed, package_speed, t3, inverse_holder_mass, holder_v_dot_by_holder_x,
    holder_v_dot_by_holder_v, t5, drum_radius_times_package_force, t6, t7, t8, t9,
    eccentricity_times_layer_stiffness, drum_speed_over_drum_radius, ovality_times_layer_stiffness,
    t10, t11, t12, t13, t14, t15, t16, t17
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 47 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let t1 = R::literal(core::f64::consts::PI) * p.holder_package_width;
    let holder_package_mass = t1 * p.holder_yarn_density * t0;
    let t2 = p.holder_link_mass * p.holder_link_arm;
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + t2 / p.holder_holder_arm;
    let t3 = R::literal(2.0) * drum_speed;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + p.layer_stiffness)
        * inverse_holder_mass);
    let holder_v_dot_by_holder_v = -(p.layer_viscosity * inverse_holder_mass);
    let t4 = R::literal(2.0) * p.ovality;
    let t5 = t4 * p.holder_package_radius * p.layer_stiffness;
    let drum_radius_times_package_force = p.drum_radius * p.package_force;
    let t6 = p.force_amplitude * p.holder_package_radius;
    let t7 = p.eccentricity * p.holder_package_radius * p.layer_stiffness;
    let t8 = R::literal(-1.0) / (p.drum_radius * p.holder_package_radius);
    let t9 = t4 * p.layer_stiffness;
    let eccentricity_times_layer_stiffness = p.eccentricity * p.layer_stiffness;
    let drum_speed_over_drum_radius = drum_speed / p.drum_radius;
    let ovality_times_layer_stiffness = p.ovality * p.layer_stiffness;
    let t10 = p.holder_link_arm / p.holder_holder_arm;
    let t11 = p.holder_link_mass / p.holder_holder_arm;
    let t12 = t2 / (p.holder_holder_arm * p.holder_holder_arm);
    let t13 = p.package_force * package_speed / p.holder_package_radius;
    let t14 = R::literal(core::f64::consts::TAU) * p.holder_package_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t15 = R::literal(core::f64::consts::TAU) * p.holder_bobbin_radius * p.holder_package_width
        * p.holder_yarn_density;
    let t16 = R::literal(-3.141_592_653_589_793) * p.holder_yarn_density * t0;
    let t17 = t1 * t0;
    Constants { drum_speed, package_speed, t3, inverse_holder_mass, holder_v_dot_by_holder_x,
        holder_v_dot_by_holder_v, t5, drum_radius_times_package_force, t6, t7, t8, t9,
        eccentricity_times_layer_stiffness, drum_speed_over_drum_radius,
        ovality_times_layer_stiffness, t10, t11, t12, t13, t14, t15, t16, t17 }
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

/// As `rate`, with the constants of the parameters from `prepare`. 24 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [holder_x, holder_v] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let [(_, t0), (_, cos_drum_speed_times_time), (_, t1), (_, t2)]
        = R::sin_cos_each([p.ovality_phase.add_product(c.t3, time), drum_speed_times_time,
        p.force_phase + drum_speed_times_time, p.package_phase.add_product(c.package_speed, time)]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let force = (p.force_amplitude * t1).add_product(p.package_force, t2);
    let layer_compression = shape - holder_x;
    let holder_v_dot = (force.sub_product(p.layer_viscosity, holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression)) * c.inverse_holder_mass;
    [holder_v, holder_v_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 10 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * p.holder_link_arm / p.holder_holder_arm;
    [holder_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 26 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let drum_speed_times_time = drum_speed * time;
    let [(_, t0), (_, cos_drum_speed_times_time), (_, t1), (_, t2)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let force = (p.force_amplitude * t1).add_product(p.package_force, t2);
    let layer_compression = shape - holder_x;
    let holder_x_forcing = force.sub_product(p.layer_viscosity, holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression);
    [holder_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 3] {
    [R::literal(1.0), c.holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 87 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 23] {
    let [holder_x, holder_v] = *state;
    let t0 = p.ovality_phase.add_product(c.t3, time);
    let drum_speed_times_time = c.drum_speed * time;
    let t1 = p.force_phase + drum_speed_times_time;
    let t2 = p.package_phase.add_product(c.package_speed, time);
    let [(t3, t4), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t5, t6), (t7, t8)]
        = R::sin_cos_each([t0, drum_speed_times_time, t1, t2]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t4);
    let force = (p.force_amplitude * t6).add_product(p.package_force, t8);
    let layer_compression = shape - holder_x;
    let holder_v_dot = (force.sub_product(p.layer_viscosity, holder_v) - (p.holder_stiffness
        * holder_x).sub_product(p.layer_stiffness, layer_compression)) * c.inverse_holder_mass;
    let holder_v_dot_by_winding_speed = c.t8 * time * (c.t5 * t3)
        .add_product(c.drum_radius_times_package_force, t7).add_product(c.t6, t5).add_product(c.t7,
        sin_drum_speed_times_time) * c.inverse_holder_mass;
    let t9 = p.force_amplitude * t5;
    let holder_v_dot_by_drum_radius = c.drum_speed_over_drum_radius * time * t9.add_product(c.t9,
        t3).add_product(c.eccentricity_times_layer_stiffness, sin_drum_speed_times_time)
        * c.inverse_holder_mass;
    let holder_v_dot_by_force_amplitude = t6 * c.inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(t9 * c.inverse_holder_mass);
    let holder_v_dot_by_package_force = t8 * c.inverse_holder_mass;
    let holder_v_dot_by_package_phase = -(p.package_force * t7 * c.inverse_holder_mass);
    let holder_v_dot_by_ovality = p.layer_stiffness * t4 * c.inverse_holder_mass;
    let holder_v_dot_by_ovality_phase = -(c.ovality_times_layer_stiffness * t3
        * c.inverse_holder_mass);
    let holder_v_dot_by_eccentricity = p.layer_stiffness * cos_drum_speed_times_time
        * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(c.t10 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(c.t11 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = c.t12 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_radius = (c.t13 * time * t7).sub_product(c.t14,
        holder_v_dot) * c.inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_radius = c.t15 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_package_width = c.t16 * holder_v_dot * c.inverse_holder_mass;
    let holder_v_dot_by_holder_yarn_density = -(c.t17 * holder_v_dot * c.inverse_holder_mass);
    let holder_v_dot_by_holder_stiffness = -(holder_x * c.inverse_holder_mass);
    let holder_v_dot_by_layer_stiffness = layer_compression * c.inverse_holder_mass;
    let holder_v_dot_by_layer_viscosity = -(holder_v * c.inverse_holder_mass);
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

/// Partial derivative of `y'` with respect to time. 41 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let drum_speed_times_time = drum_speed * time;
    let [(t0, _), (t1, _), (t2, _), (sin_drum_speed_times_time, _)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        p.package_phase.add_product(package_speed, time), p.force_phase + drum_speed_times_time,
        drum_speed_times_time]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * p.holder_link_arm / p.holder_holder_arm;
    let holder_v_dot_by_time = drum_speed / p.holder_package_radius
        * (-(p.drum_radius * p.package_force * t1)).add_product(R::literal(-2.0) * p.ovality
        * p.holder_package_radius * p.layer_stiffness, t0).sub_product(p.force_amplitude
        * p.holder_package_radius, t2).sub_product(p.eccentricity * p.holder_package_radius
        * p.layer_stiffness, sin_drum_speed_times_time) * (R::literal(1.0) / holder_mass);
    [R::literal(0.0), holder_v_dot_by_time]
}

/// Wanted outputs. 41 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let drum_speed_times_time = drum_speed * time;
    let [(_, t0), (_, cos_drum_speed_times_time), (_, t1), (_, t2)]
        = R::sin_cos_each([p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed_times_time, p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time)]);
    let holder_package_mass = R::literal(core::f64::consts::PI) * p.holder_package_width
        * p.holder_yarn_density * (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let force = (p.force_amplitude * t1).add_product(p.package_force, t2);
    let layer_compression = shape - holder_x;
    let layer_viscosity_times_holder_v = p.layer_viscosity * holder_v;
    let t3 = p.layer_stiffness * layer_compression;
    Outputs {
        deflection: holder_x,
        pressure: t3 - layer_viscosity_times_holder_v,
        contact_force: p.holder_preload.add_product(p.holder_stiffness * p.holder_spring_share,
            p.holder_package_radius - p.holder_bobbin_radius).add_product(p.holder_gravity,
            holder_package_mass) + t3 - layer_viscosity_times_holder_v,
        mass: holder_mass,
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\]. 31 operations.
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
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    Energy {
        kinetic: R::literal(0.5) * holder_mass * (holder_v * holder_v),
        potential: (R::literal(0.5) * p.holder_stiffness * (holder_x * holder_x))
            .add_product(R::literal(0.5) * p.layer_stiffness, layer_compression
            * layer_compression),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 56 operations.
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
    let holder_mass = p.holder_bobbin_mass + holder_package_mass + p.holder_link_mass
        * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let t5 = p.layer_stiffness * layer_compression;
    let t6 = (-t5).add_product(p.holder_stiffness, holder_x);
    let holder_v_dot = (force.sub_product(p.layer_viscosity, holder_v) - t6) * (R::literal(1.0)
        / holder_mass);
    let t7 = t5 * (p.eccentricity * drum_speed * sin_drum_speed_times_time)
        .add_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    PowerBalance {
        stored_rate: (-t7).add_product(t6, holder_v).add_product(holder_mass * holder_v,
            holder_v_dot),
        supplied: (-t7).add_product(holder_v, force),
        dissipated: p.layer_viscosity * (holder_v * holder_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 68 recurrences. No sums of products.
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
    let t5 = p.holder_link_mass * p.holder_link_arm;
    let t6 = t5 / p.holder_holder_arm;
    let t7 = p.holder_bobbin_mass + holder_package_mass;
    let holder_mass = t7 + t6;
    let t8 = R::literal(2.0) * drum_speed;
    let t9 = time * t8;
    let t10 = p.ovality_phase + t9;
    let t11 = t10.sin();
    let t12 = t10.cos();
    let t13 = t12 * p.ovality;
    let t14 = time * drum_speed;
    let t15 = t14.sin();
    let t16 = t14.cos();
    let t17 = t16 * p.eccentricity;
    let shape = t13 + t17;
    let t18 = p.force_phase + t14;
    let t19 = t18.sin();
    let t20 = t18.cos();
    let t21 = t20 * p.force_amplitude;
    let t22 = time * package_speed;
    let t23 = p.package_phase + t22;
    let t24 = t23.sin();
    let t25 = t23.cos();
    let t26 = t25 * p.package_force;
    let force = t21 + t26;
    let layer_compression = shape - holder_x;
    let t27 = R::literal(1.0) / holder_mass;
    let t28 = holder_v * p.layer_viscosity;
    let t29 = layer_compression * p.layer_stiffness;
    let t30 = holder_x * p.holder_stiffness;
    let t31 = t30 - t29;
    let t32 = force - t28;
    let t33 = t32 - t31;
    let holder_v_dot = t33 * t27;
    let mut t11_before = t11;
    let mut t12_before = t12;
    let mut t15_before = t15;
    let mut t16_before = t16;
    let mut t19_before = t19;
    let mut t20_before = t20;
    let mut t24_before = t24;
    let mut t25_before = t25;
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
        let t11_k = inverse * t8 * t12_before;
        let t12_k = -inverse * t8 * t11_before;
        let t15_k = inverse * drum_speed * t16_before;
        let t16_k = -inverse * drum_speed * t15_before;
        let shape_k = t16_k.mul_add(p.eccentricity, t12_k * p.ovality);
        let t19_k = inverse * drum_speed * t20_before;
        let t20_k = -inverse * drum_speed * t19_before;
        let t24_k = inverse * package_speed * t25_before;
        let t25_k = -inverse * package_speed * t24_before;
        let force_k = t25_k.mul_add(p.package_force, t20_k * p.force_amplitude);
        let layer_compression_k = shape_k - holder_x_k;
        let t31_k = (-layer_compression_k).mul_add(p.layer_stiffness, holder_x_k
            * p.holder_stiffness);
        let t32_k = (-holder_v_k).mul_add(p.layer_viscosity, force_k);
        let t33_k = t32_k - t31_k;
        let holder_v_dot_k = t33_k * t27;
        t11_before = t11_k;
        t12_before = t12_k;
        t15_before = t15_k;
        t16_before = t16_k;
        t19_before = t19_k;
        t20_before = t20_k;
        t24_before = t24_k;
        t25_before = t25_k;
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
/// in the modes of a state. 39 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 12] {
    let [(sin_ovality_phase, cos_ovality_phase), (sin_force_phase, cos_force_phase),
        (sin_package_phase, cos_package_phase)] = R::sin_cos_each([p.ovality_phase, p.force_phase,
        p.package_phase]);
    let winding_speed_over_drum_radius = p.winding_speed / p.drum_radius;
    let t0 = R::literal(1.0) / (p.holder_bobbin_mass.add_product(R::literal(core::f64::consts::PI)
        * p.holder_package_width * p.holder_yarn_density, (p.holder_package_radius
        * p.holder_package_radius).sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius))
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm);
    [R::literal(0.0), winding_speed_over_drum_radius, (p.eccentricity
        * p.layer_stiffness).add_product(cos_force_phase, p.force_amplitude) * t0,
        -(sin_force_phase * p.force_amplitude * t0), R::literal(0.0),
        p.winding_speed / p.holder_package_radius, cos_package_phase * p.package_force * t0,
        -(sin_package_phase * p.package_force * t0), R::literal(0.0),
        R::literal(2.0) * winding_speed_over_drum_radius,
        cos_ovality_phase * p.ovality * p.layer_stiffness * t0, -(sin_ovality_phase * p.ovality
        * p.layer_stiffness * t0)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

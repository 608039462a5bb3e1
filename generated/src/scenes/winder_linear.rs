// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   f0e4c157d923f03fe1f24e6494b85ae5624f758f3a117cd1a67d3c2da881f90e  scenes/winder_linear.toml
//   07413a1109bdf680c087c4354aa37c0ca961bda7ffa02d4c885b7a671cdda9ec  units/bobbin_holder.toml
//   7f906df57d36c587350f4f96bf186ba57a3eefffbc8a08954a65b16a979eb1d8  units/yarn_layer.toml
//
// Bobbin on a winding drum, linear layer
//
// The bobbin rests on a drum that shakes it once a turn by its unbalance and twice a
// turn by its shape. First stage of modelling: layer and holder are linear.
//
// Source:
//   Winder study, first stage of modelling; mass, viscosity, stiffnesses and disturbances of its bench model M5. Arms, speed and radii are plausible ones.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        0
//   states                    2
//   parameters               22
//   outputs                   5
//   discontinuities           0
//
// State:
//     0  holder.x  [m]    deflection of the bobbin's centre
//     1  holder.v  [m/s]  rate of deflection of the bobbin's centre
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             3 of 2 by 2
//   parameter_jacobian       20 of 2 by 22
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     48
//   mass_matrix              10
//   forcing                  36
//   rate_jacobian            16
//   parameter_jacobian      202
//   time_derivative          60
//   outputs                  43
//   energy                   31
//   power_balance            59
// With constants of the parameters, prepared once a run:
//   prepare                  22
//   prepared_rate            31
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations, taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 2;

/// Parameters.
pub const PARAMETERS: usize = 22;

/// Wanted outputs.
pub const OUTPUTS: usize = 5;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 1), (1, 0), (1, 1)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 22,
    entries: &[
        (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8), (1, 11), (1, 12),
        (1, 13), (1, 14), (1, 15), (1, 16), (1, 17), (1, 18), (1, 19), (1, 20), (1, 21),
    ],
};

/// Bobbin on a winding drum, linear layer
///
/// The bobbin rests on a drum that shakes it once a turn by its unbalance and twice a
/// turn by its shape. First stage of modelling: layer and holder are linear.
///
/// Source: Winder study, first stage of modelling; mass, viscosity, stiffnesses and disturbances of its bench model M5. Arms, speed and radii are plausible ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WinderLinear;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// winding_speed: speed of the drum's surface \[m/s\]. In the spec: 5.5.
    pub winding_speed: R,
    /// drum_radius: R0, radius of the drum \[m\]. In the spec: 0.05.
    pub drum_radius: R,
    /// force_amplitude: F0, force once a turn of the drum, from its unbalance \[N\]. In the spec: 25.0.
    pub force_amplitude: R,
    /// force_phase: phase of that force \[rad\]. In the spec: 0.0.
    pub force_phase: R,
    /// package_force: amplitude of the force once a turn of the package \[N\]. In the spec: 0.0.
    pub package_force: R,
    /// package_phase: phase of that force \[rad\]. In the spec: 0.0.
    pub package_phase: R,
    /// ovality: Y0, amplitude of the drum's shape twice a turn \[m\]. In the spec: 0.0002.
    pub ovality: R,
    /// ovality_phase: phase of that shape \[rad\]. In the spec: 0.0.
    pub ovality_phase: R,
    /// eccentricity: amplitude of the drum's shape once a turn \[m\]. In the spec: 0.0.
    pub eccentricity: R,
    /// initial_deflection: deflection at the start \[m\]. In the spec: 0.0.
    pub initial_deflection: R,
    /// initial_velocity: velocity at the start \[m/s\]. In the spec: 0.0.
    pub initial_velocity: R,
    /// holder.bobbin_mass: m0, mass of bobbin and plate \[kg\]. In the spec: 1.5.
    pub holder_bobbin_mass: R,
    /// holder.link_mass: mn, mass of the links \[kg\]. In the spec: 0.9.
    pub holder_link_mass: R,
    /// holder.link_arm: lbc, arm of the links' mass \[m\]. In the spec: 0.1.
    pub holder_link_arm: R,
    /// holder.holder_arm: lab, arm of the bobbin \[m\]. In the spec: 0.15.
    pub holder_holder_arm: R,
    /// holder.package_radius: R, radius of the package; that of an empty bobbin by default \[m\]. In the spec: 0.03.
    pub holder_package_radius: R,
    /// holder.bobbin_radius: Rmin, radius of the empty bobbin \[m\]. In the spec: 0.03.
    pub holder_bobbin_radius: R,
    /// holder.package_width: H, width of the package \[m\]. In the spec: 0.15.
    pub holder_package_width: R,
    /// holder.yarn_density: rho, density of the wound yarn \[kg/m^3\]. In the spec: 350.0.
    pub holder_yarn_density: R,
    /// holder.stiffness: c_p, spring of the holder, reduced to the bobbin's centre \[N/m\]. In the spec: 3800.0.
    pub holder_stiffness: R,
    /// layer.stiffness: c, stiffness of the layer \[N/m\]. In the spec: 42000.0.
    pub layer_stiffness: R,
    /// layer.viscosity: h, viscosity of the layer \[N s/m\]. In the spec: 95.0.
    pub layer_viscosity: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            winding_speed: values[0],
            drum_radius: values[1],
            force_amplitude: values[2],
            force_phase: values[3],
            package_force: values[4],
            package_phase: values[5],
            ovality: values[6],
            ovality_phase: values[7],
            eccentricity: values[8],
            initial_deflection: values[9],
            initial_velocity: values[10],
            holder_bobbin_mass: values[11],
            holder_link_mass: values[12],
            holder_link_arm: values[13],
            holder_holder_arm: values[14],
            holder_package_radius: values[15],
            holder_bobbin_radius: values[16],
            holder_package_width: values[17],
            holder_yarn_density: values[18],
            holder_stiffness: values[19],
            layer_stiffness: values[20],
            layer_viscosity: values[21],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.winding_speed,
            self.drum_radius,
            self.force_amplitude,
            self.force_phase,
            self.package_force,
            self.package_phase,
            self.ovality,
            self.ovality_phase,
            self.eccentricity,
            self.initial_deflection,
            self.initial_velocity,
            self.holder_bobbin_mass,
            self.holder_link_mass,
            self.holder_link_arm,
            self.holder_holder_arm,
            self.holder_package_radius,
            self.holder_bobbin_radius,
            self.holder_package_width,
            self.holder_yarn_density,
            self.holder_stiffness,
            self.layer_stiffness,
            self.layer_viscosity,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            winding_speed: R::literal(5.5),
            drum_radius: R::literal(0.05),
            force_amplitude: R::literal(25.0),
            force_phase: R::literal(0.0),
            package_force: R::literal(0.0),
            package_phase: R::literal(0.0),
            ovality: R::literal(0.0002),
            ovality_phase: R::literal(0.0),
            eccentricity: R::literal(0.0),
            initial_deflection: R::literal(0.0),
            initial_velocity: R::literal(0.0),
            holder_bobbin_mass: R::literal(1.5),
            holder_link_mass: R::literal(0.9),
            holder_link_arm: R::literal(0.1),
            holder_holder_arm: R::literal(0.15),
            holder_package_radius: R::literal(0.03),
            holder_bobbin_radius: R::literal(0.03),
            holder_package_width: R::literal(0.15),
            holder_yarn_density: R::literal(350.0),
            holder_stiffness: R::literal(3800.0),
            layer_stiffness: R::literal(42000.0),
            layer_viscosity: R::literal(95.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// deflection: deflection of the bobbin's centre \[m\].
    pub deflection: R,
    /// pressure: force of the layer on the bobbin beyond that at rest \[N\].
    pub pressure: R,
    /// mass: reduced mass m(R) \[kg\].
    pub mass: R,
    /// force: force disturbance \[N\].
    pub force: R,
    /// shape: shape of the drum \[m\].
    pub shape: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            deflection: values[0],
            pressure: values[1],
            mass: values[2],
            force: values[3],
            shape: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.deflection, self.pressure, self.mass, self.force, self.shape]
    }
}

/// Where to find what in the state.
pub mod state {
    /// holder.x: deflection of the bobbin's centre \[m\].
    pub const HOLDER_X: usize = 0;
    /// holder.v: rate of deflection of the bobbin's centre \[m/s\].
    pub const HOLDER_V: usize = 1;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 8;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub drum_speed: R,
    pub package_speed: R,
    pub t0: R,
    pub t1: R,
    pub eccentricity_times_drum_speed: R,
    pub inverse_holder_mass: R,
    pub holder_v_dot_by_holder_x: R,
    pub holder_v_dot_by_holder_v: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            drum_speed: values[0],
            package_speed: values[1],
            t0: values[2],
            t1: values[3],
            eccentricity_times_drum_speed: values[4],
            inverse_holder_mass: values[5],
            holder_v_dot_by_holder_x: values[6],
            holder_v_dot_by_holder_v: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.drum_speed,
            self.package_speed,
            self.t0,
            self.t1,
            self.eccentricity_times_drum_speed,
            self.inverse_holder_mass,
            self.holder_v_dot_by_holder_x,
            self.holder_v_dot_by_holder_v,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 22 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let t0 = R::literal(2.0) * drum_speed;
    let t1 = R::literal(2.0) * p.ovality * drum_speed;
    let eccentricity_times_drum_speed = p.eccentricity * drum_speed;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let holder_v_dot_by_holder_x = -((p.holder_stiffness + p.layer_stiffness)
        * inverse_holder_mass);
    let holder_v_dot_by_holder_v = -(p.layer_viscosity * inverse_holder_mass);
    Constants {
        drum_speed,
        package_speed,
        t0,
        t1,
        eccentricity_times_drum_speed,
        inverse_holder_mass,
        holder_v_dot_by_holder_x,
        holder_v_dot_by_holder_v,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.initial_deflection, p.initial_velocity]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 48 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 31 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [holder_x, holder_v] = *state;
    let t0 = p.ovality_phase.add_product(c.t0, time);
    let drum_speed_times_time = c.drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3),
    (_, t4)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(c.package_speed, time),
    ]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(c.eccentricity_times_drum_speed * sin_drum_speed_times_time))
        .sub_product(c.t1, t1);
    let layer_compression_rate = shape_rate - holder_v;
    let holder_v_dot = (force.add_product(p.layer_viscosity, layer_compression_rate)
        - (p.holder_stiffness * holder_x)
            .sub_product(p.layer_stiffness, layer_compression)) * c.inverse_holder_mass;
    [holder_v, holder_v_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 10 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 1] {
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    [holder_mass]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 36 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3),
    (_, t4)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time),
    ]);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let layer_compression_rate = shape_rate - holder_v;
    let holder_x_forcing = force.add_product(p.layer_viscosity, layer_compression_rate)
        - (p.holder_stiffness * holder_x)
            .sub_product(p.layer_stiffness, layer_compression);
    [holder_x_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 16 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 3] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// No operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 3] {
    [R::literal(1.0), c.holder_v_dot_by_holder_x, c.holder_v_dot_by_holder_v]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 202 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 20] {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let t1 = p.force_phase + drum_speed_times_time;
    let t2 = p.package_phase.add_product(package_speed, time);
    let [(t3, t4), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t5, t6),
    (t7, t8)] = R::sin_cos_each([t0, drum_speed_times_time, t1, t2]);
    let t9 = (p.holder_package_radius * p.holder_package_radius)
        .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius);
    let t10 = R::literal(core::f64::consts::PI) * p.holder_package_width;
    let t11 = p.holder_link_mass * p.holder_link_arm;
    let holder_mass = p.holder_bobbin_mass.add_product(t10 * p.holder_yarn_density, t9)
        + t11 / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t4);
    let force = (p.force_amplitude * t6).add_product(p.package_force, t8);
    let layer_compression = shape - holder_x;
    let t12 = R::literal(2.0) * p.ovality;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(t12 * drum_speed, t3);
    let layer_compression_rate = shape_rate - holder_v;
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let holder_v_dot = (force.add_product(p.layer_viscosity, layer_compression_rate)
        - (p.holder_stiffness * holder_x)
            .sub_product(p.layer_stiffness, layer_compression)) * inverse_holder_mass;
    let t13 = R::literal(4.0) * p.winding_speed * p.ovality;
    let t14 = R::literal(2.0) * p.drum_radius * p.ovality;
    let t15 = t14 * p.holder_package_radius;
    let winding_speed_times_eccentricity = p.winding_speed * p.eccentricity;
    let drum_radius_times_force_amplitude = p.drum_radius * p.force_amplitude;
    let drum_radius_times_eccentricity = p.drum_radius * p.eccentricity;
    let t16 = drum_radius_times_eccentricity * p.holder_package_radius;
    let drum_radius_squared = p.drum_radius * p.drum_radius;
    let t17 = (-(t15 * p.layer_stiffness * time * t3))
        .sub_product(t13 * p.holder_package_radius * p.layer_viscosity * time, t4)
        .sub_product(t15 * p.layer_viscosity, t3)
        .sub_product(
            winding_speed_times_eccentricity * p.holder_package_radius
                * p.layer_viscosity * time,
            cos_drum_speed_times_time,
        )
        .sub_product(
            drum_radius_times_force_amplitude * p.holder_package_radius * time,
            t5,
        )
        .sub_product(t16 * p.layer_stiffness * time, sin_drum_speed_times_time)
        .sub_product(p.package_force * drum_radius_squared * time, t7)
        .sub_product(t16 * p.layer_viscosity, sin_drum_speed_times_time);
    let holder_v_dot_by_winding_speed = R::literal(1.0)
        / (drum_radius_squared * p.holder_package_radius) * t17 * inverse_holder_mass;
    let holder_v_dot_by_drum_radius = drum_speed / drum_radius_squared
        * (t14 * p.layer_stiffness * time * t3)
            .add_product(t14 * p.layer_viscosity, t3)
            .add_product(t13 * p.layer_viscosity * time, t4)
            .add_product(
                winding_speed_times_eccentricity * p.layer_viscosity * time,
                cos_drum_speed_times_time,
            )
            .add_product(drum_radius_times_force_amplitude * time, t5)
            .add_product(
                drum_radius_times_eccentricity * p.layer_stiffness * time,
                sin_drum_speed_times_time,
            )
            .add_product(
                drum_radius_times_eccentricity * p.layer_viscosity,
                sin_drum_speed_times_time,
            ) * inverse_holder_mass;
    let holder_v_dot_by_force_amplitude = t6 * inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * t5 * inverse_holder_mass);
    let holder_v_dot_by_package_force = t8 * inverse_holder_mass;
    let holder_v_dot_by_package_phase = -(p.package_force * t7 * inverse_holder_mass);
    let holder_v_dot_by_ovality = (p.layer_stiffness * t4)
        .sub_product(R::literal(2.0) * p.layer_viscosity * drum_speed, t3)
        * inverse_holder_mass;
    let holder_v_dot_by_ovality_phase = (-(p.ovality * p.layer_stiffness * t3))
        .sub_product(t12 * p.layer_viscosity * drum_speed, t4) * inverse_holder_mass;
    let holder_v_dot_by_eccentricity = (p.layer_stiffness * cos_drum_speed_times_time)
        .sub_product(p.layer_viscosity * drum_speed, sin_drum_speed_times_time)
        * inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(p.holder_link_arm / p.holder_holder_arm
        * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(p.holder_link_mass / p.holder_holder_arm
        * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = t11
        / (p.holder_holder_arm * p.holder_holder_arm) * holder_v_dot
        * inverse_holder_mass;
    let holder_v_dot_by_holder_package_radius = (p.package_force * package_speed
        / p.holder_package_radius * time * t7)
        .sub_product(
            R::literal(core::f64::consts::TAU) * p.holder_package_radius
                * p.holder_package_width * p.holder_yarn_density,
            holder_v_dot,
        ) * inverse_holder_mass;
    let holder_v_dot_by_holder_bobbin_radius = R::literal(core::f64::consts::TAU)
        * p.holder_bobbin_radius * p.holder_package_width * p.holder_yarn_density
        * holder_v_dot * inverse_holder_mass;
    let holder_v_dot_by_holder_package_width = -(R::literal(core::f64::consts::PI)
        * p.holder_yarn_density * t9 * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_yarn_density = -(t10 * t9 * holder_v_dot
        * inverse_holder_mass);
    let holder_v_dot_by_holder_stiffness = -(holder_x * inverse_holder_mass);
    let holder_v_dot_by_layer_stiffness = layer_compression * inverse_holder_mass;
    let holder_v_dot_by_layer_viscosity = R::literal(1.0) / p.drum_radius
        * (-(p.drum_radius * holder_v))
            .sub_product(R::literal(2.0) * p.winding_speed * p.ovality, t3)
            .sub_product(winding_speed_times_eccentricity, sin_drum_speed_times_time)
        * inverse_holder_mass;
    [
        holder_v_dot_by_winding_speed,
        holder_v_dot_by_drum_radius,
        holder_v_dot_by_force_amplitude,
        holder_v_dot_by_force_phase,
        holder_v_dot_by_package_force,
        holder_v_dot_by_package_phase,
        holder_v_dot_by_ovality,
        holder_v_dot_by_ovality_phase,
        holder_v_dot_by_eccentricity,
        holder_v_dot_by_holder_bobbin_mass,
        holder_v_dot_by_holder_link_mass,
        holder_v_dot_by_holder_link_arm,
        holder_v_dot_by_holder_holder_arm,
        holder_v_dot_by_holder_package_radius,
        holder_v_dot_by_holder_bobbin_radius,
        holder_v_dot_by_holder_package_width,
        holder_v_dot_by_holder_yarn_density,
        holder_v_dot_by_holder_stiffness,
        holder_v_dot_by_layer_stiffness,
        holder_v_dot_by_layer_viscosity,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 60 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t3, _),
    (t4, _)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time),
    ]);
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let t5 = (-(R::literal(2.0) * p.drum_radius * p.ovality * p.holder_package_radius
        * p.layer_stiffness * t1))
        .sub_product(
            R::literal(4.0) * p.winding_speed * p.ovality * p.holder_package_radius
                * p.layer_viscosity,
            t2,
        )
        .sub_product(
            p.winding_speed * p.eccentricity * p.holder_package_radius
                * p.layer_viscosity,
            cos_drum_speed_times_time,
        )
        .sub_product(p.drum_radius * p.force_amplitude * p.holder_package_radius, t3)
        .sub_product(
            p.drum_radius * p.eccentricity * p.holder_package_radius * p.layer_stiffness,
            sin_drum_speed_times_time,
        )
        .sub_product(p.package_force * (p.drum_radius * p.drum_radius), t4);
    let holder_v_dot_by_time = drum_speed / (p.drum_radius * p.holder_package_radius)
        * t5 * (R::literal(1.0) / holder_mass);
    [R::literal(0.0), holder_v_dot_by_time]
}

/// Wanted outputs.
///
/// 43 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3),
    (_, t4)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time),
    ]);
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let layer_compression_rate = shape_rate - holder_v;
    Outputs {
        deflection: holder_x,
        pressure: (p.layer_stiffness * layer_compression)
            .add_product(p.layer_viscosity, layer_compression_rate),
        mass: holder_mass,
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 31 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let [(_, t0), (_, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed * time,
    ]);
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    Energy {
        kinetic: R::literal(0.5) * holder_mass * (holder_v * holder_v),
        potential: (R::literal(0.5) * p.holder_stiffness * (holder_x * holder_x))
            .add_product(
                R::literal(0.5) * p.layer_stiffness,
                layer_compression * layer_compression,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 59 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let drum_speed_times_time = drum_speed * time;
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (_, t3),
    (_, t4)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
        p.package_phase.add_product(package_speed, time),
    ]);
    let holder_mass = p
        .holder_bobbin_mass
        .add_product(
            R::literal(core::f64::consts::PI) * p.holder_package_width
                * p.holder_yarn_density,
            (p.holder_package_radius * p.holder_package_radius)
                .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
        ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let force = (p.force_amplitude * t3).add_product(p.package_force, t4);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let layer_compression_rate = shape_rate - holder_v;
    let t5 = p.layer_stiffness * layer_compression;
    let t6 = (-t5).add_product(p.holder_stiffness, holder_x);
    let holder_v_dot = (force.add_product(p.layer_viscosity, layer_compression_rate)
        - t6) * (R::literal(1.0) / holder_mass);
    let t7 = t5 * shape_rate;
    PowerBalance {
        stored_rate: t7
            .add_product(t6, holder_v)
            .add_product(holder_mass * holder_v, holder_v_dot),
        supplied: t7.add_product(holder_v, force),
        dissipated: -(p.layer_viscosity * holder_v * layer_compression_rate),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 76 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
    let [holder_x, holder_v] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let package_speed = p.winding_speed / p.holder_package_radius;
    let t0 = p.holder_bobbin_radius * p.holder_bobbin_radius;
    let t1 = p.holder_package_radius * p.holder_package_radius;
    let t2 = t1 - t0;
    let t3 = R::literal(core::f64::consts::PI) * p.holder_package_width;
    let t4 = t3 * p.holder_yarn_density;
    let t5 = t4 * t2;
    let t6 = p.holder_link_mass * p.holder_link_arm;
    let t7 = t6 / p.holder_holder_arm;
    let t8 = p.holder_bobbin_mass + t5;
    let holder_mass = t8 + t7;
    let t9 = R::literal(2.0) * drum_speed;
    let t10 = time * t9;
    let t11 = p.ovality_phase + t10;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = t13 * p.ovality;
    let t15 = time * drum_speed;
    let t16 = t15.sin();
    let t17 = t15.cos();
    let t18 = t17 * p.eccentricity;
    let shape = t14 + t18;
    let t19 = p.force_phase + t15;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = t21 * p.force_amplitude;
    let t23 = time * package_speed;
    let t24 = p.package_phase + t23;
    let t25 = t24.sin();
    let t26 = t24.cos();
    let t27 = t26 * p.package_force;
    let force = t22 + t27;
    let layer_compression = shape - holder_x;
    let t28 = R::literal(2.0) * p.ovality;
    let t29 = t28 * drum_speed;
    let t30 = t12 * t29;
    let t31 = p.eccentricity * drum_speed;
    let t32 = t16 * t31;
    let t33 = -t30;
    let shape_rate = t33 - t32;
    let layer_compression_rate = shape_rate - holder_v;
    let t34 = R::literal(1.0) / holder_mass;
    let t35 = layer_compression * p.layer_stiffness;
    let t36 = holder_x * p.holder_stiffness;
    let t37 = t36 - t35;
    let t38 = layer_compression_rate * p.layer_viscosity;
    let t39 = force + t38;
    let t40 = t39 - t37;
    let holder_v_dot = t40 * t34;
    let mut t12_before = t12;
    let mut t13_before = t13;
    let mut t16_before = t16;
    let mut t17_before = t17;
    let mut t20_before = t20;
    let mut t21_before = t21;
    let mut t25_before = t25;
    let mut t26_before = t26;
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
        let t12_k = inverse * t9 * t13_before;
        let t13_k = -inverse * t9 * t12_before;
        let t16_k = inverse * drum_speed * t17_before;
        let t17_k = -inverse * drum_speed * t16_before;
        let shape_k = t17_k.mul_add(p.eccentricity, t13_k * p.ovality);
        let t20_k = inverse * drum_speed * t21_before;
        let t21_k = -inverse * drum_speed * t20_before;
        let t25_k = inverse * package_speed * t26_before;
        let t26_k = -inverse * package_speed * t25_before;
        let force_k = t26_k.mul_add(p.package_force, t21_k * p.force_amplitude);
        let layer_compression_k = shape_k - holder_x_k;
        let t30_k = t12_k * t29;
        let t33_k = -t30_k;
        let shape_rate_k = (-t16_k).mul_add(t31, t33_k);
        let layer_compression_rate_k = shape_rate_k - holder_v_k;
        let t37_k = (-layer_compression_k)
            .mul_add(p.layer_stiffness, holder_x_k * p.holder_stiffness);
        let t39_k = layer_compression_rate_k.mul_add(p.layer_viscosity, force_k);
        let t40_k = t39_k - t37_k;
        let holder_v_dot_k = t40_k * t34;
        t12_before = t12_k;
        t13_before = t13_k;
        t16_before = t16_k;
        t17_before = t17_k;
        t20_before = t20_k;
        t21_before = t21_k;
        t25_before = t25_k;
        t26_before = t26_k;
        rates = [holder_v_k, holder_v_dot_k];
    }
}

impl<R: Real> TaylorSeries<R> for WinderLinear {
    fn series_workspace(&self, _order: usize) -> usize {
        0
    }
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    ) {
        let (coefficients, rest) = coefficients.as_chunks_mut();
        assert!(rest.is_empty(), "every order has STATES coefficients");
        let p = parameters_of(parameters);
        series(time, state_of(state), &p, coefficients, workspace);
    }
}

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 3] = [(1, 0), (1, 0), (1, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// 50 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, p: &Parameters<R>) -> [R; 12] {
    let [(sin_ovality_phase, cos_ovality_phase), (sin_force_phase, cos_force_phase),
    (sin_package_phase, cos_package_phase)] = R::sin_cos_each([
        p.ovality_phase,
        p.force_phase,
        p.package_phase,
    ]);
    let winding_speed_over_drum_radius = p.winding_speed / p.drum_radius;
    let t0 = R::literal(2.0) * p.ovality * winding_speed_over_drum_radius;
    let t1 = R::literal(1.0)
        / (p
            .holder_bobbin_mass
            .add_product(
                R::literal(core::f64::consts::PI) * p.holder_package_width
                    * p.holder_yarn_density,
                (p.holder_package_radius * p.holder_package_radius)
                    .sub_product(p.holder_bobbin_radius, p.holder_bobbin_radius),
            ) + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm);
    [
        R::literal(0.0),
        winding_speed_over_drum_radius,
        (p.eccentricity * p.layer_stiffness)
            .add_product(cos_force_phase, p.force_amplitude) * t1,
        (-(p.eccentricity * winding_speed_over_drum_radius * p.layer_viscosity))
            .sub_product(sin_force_phase, p.force_amplitude) * t1,
        R::literal(0.0),
        p.winding_speed / p.holder_package_radius,
        cos_package_phase * p.package_force * t1,
        -(sin_package_phase * p.package_force * t1),
        R::literal(0.0),
        R::literal(2.0) * winding_speed_over_drum_radius,
        (cos_ovality_phase * p.ovality * p.layer_stiffness)
            .sub_product(sin_ovality_phase * t0, p.layer_viscosity) * t1,
        (-(sin_ovality_phase * p.ovality * p.layer_stiffness))
            .sub_product(cos_ovality_phase * t0, p.layer_viscosity) * t1,
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for WinderLinear {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        &EXCITATION_TERMS
    }
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&excitation(time, &parameters_of(parameters)));
    }
    fn switches(&self) -> usize {
        SWITCHES
    }
    fn switch_times(&self, parameters: &[R], times: &mut [R]) {
        times.copy_from_slice(&switches(&parameters_of(parameters)));
    }
}

impl Describe for WinderLinear {
    fn name(&self) -> &'static str {
        "winder_linear"
    }
    fn title(&self) -> &'static str {
        "Bobbin on a winding drum, linear layer"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 0,
            quadratures: 0,
            parameters: PARAMETERS,
            outputs: OUTPUTS,
            discontinuities: DISCONTINUITIES,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        STATE_QUANTITIES[index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        STATE_SCALES[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        PARAMETER_QUANTITIES[index]
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETER_DEFAULTS[index]
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        OUTPUT_QUANTITIES[index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        RATE_JACOBIAN_PATTERN
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        PARAMETER_JACOBIAN_PATTERN
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        MASS_MATRIX_PATTERN
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RUN_DEFAULTS
    }
}

impl<R: Real> Simulator<R> for WinderLinear {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate(time, state_of(state), &p, &c);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate_jacobian(time, state_of(state), &p, &c);
    }
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = initial_state(&parameters_of(parameters));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = discontinuities(&parameters_of(parameters));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate(time, state_of(state), &parameters_of(parameters));
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = time_derivative(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = mass_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = forcing(time, state_of(state), &parameters_of(parameters));
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = outputs(time, state_of(state), &parameters_of(parameters))
            .to_array();
    }
    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        energy(time, state_of(state), &parameters_of(parameters))
    }
    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        power_balance(time, state_of(state), &parameters_of(parameters))
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
        Some(self)
    }
}

#[inline]
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
}

#[inline]
fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there is one place for each value")
}

#[inline]
fn state_of<R>(state: &[R]) -> &[R; STATES] {
    state.try_into().expect("the state has STATES entries")
}

#[inline]
fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
    let values: &[R; PARAMETERS] = parameters
        .try_into()
        .expect("there are PARAMETERS parameters");
    Parameters::from_array(*values)
}

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "holder.x",
        unit: "m",
        doc: "deflection of the bobbin's centre",
    },
    Quantity {
        name: "holder.v",
        unit: "m/s",
        doc: "rate of deflection of the bobbin's centre",
    },
];

static STATE_SCALES: [f64; STATES] = [0.001, 0.1];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "winding_speed",
        unit: "m/s",
        doc: "speed of the drum's surface",
    },
    Quantity {
        name: "drum_radius",
        unit: "m",
        doc: "R0, radius of the drum",
    },
    Quantity {
        name: "force_amplitude",
        unit: "N",
        doc: "F0, force once a turn of the drum, from its unbalance",
    },
    Quantity {
        name: "force_phase",
        unit: "rad",
        doc: "phase of that force",
    },
    Quantity {
        name: "package_force",
        unit: "N",
        doc: "amplitude of the force once a turn of the package",
    },
    Quantity {
        name: "package_phase",
        unit: "rad",
        doc: "phase of that force",
    },
    Quantity {
        name: "ovality",
        unit: "m",
        doc: "Y0, amplitude of the drum's shape twice a turn",
    },
    Quantity {
        name: "ovality_phase",
        unit: "rad",
        doc: "phase of that shape",
    },
    Quantity {
        name: "eccentricity",
        unit: "m",
        doc: "amplitude of the drum's shape once a turn",
    },
    Quantity {
        name: "initial_deflection",
        unit: "m",
        doc: "deflection at the start",
    },
    Quantity {
        name: "initial_velocity",
        unit: "m/s",
        doc: "velocity at the start",
    },
    Quantity {
        name: "holder.bobbin_mass",
        unit: "kg",
        doc: "m0, mass of bobbin and plate",
    },
    Quantity {
        name: "holder.link_mass",
        unit: "kg",
        doc: "mn, mass of the links",
    },
    Quantity {
        name: "holder.link_arm",
        unit: "m",
        doc: "lbc, arm of the links' mass",
    },
    Quantity {
        name: "holder.holder_arm",
        unit: "m",
        doc: "lab, arm of the bobbin",
    },
    Quantity {
        name: "holder.package_radius",
        unit: "m",
        doc: "R, radius of the package; that of an empty bobbin by default",
    },
    Quantity {
        name: "holder.bobbin_radius",
        unit: "m",
        doc: "Rmin, radius of the empty bobbin",
    },
    Quantity {
        name: "holder.package_width",
        unit: "m",
        doc: "H, width of the package",
    },
    Quantity {
        name: "holder.yarn_density",
        unit: "kg/m^3",
        doc: "rho, density of the wound yarn",
    },
    Quantity {
        name: "holder.stiffness",
        unit: "N/m",
        doc: "c_p, spring of the holder, reduced to the bobbin's centre",
    },
    Quantity {
        name: "layer.stiffness",
        unit: "N/m",
        doc: "c, stiffness of the layer",
    },
    Quantity {
        name: "layer.viscosity",
        unit: "N s/m",
        doc: "h, viscosity of the layer",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    5.5,
    0.05,
    25.0,
    0.0,
    0.0,
    0.0,
    0.0002,
    0.0,
    0.0,
    0.0,
    0.0,
    1.5,
    0.9,
    0.1,
    0.15,
    0.03,
    0.03,
    0.15,
    350.0,
    3800.0,
    42000.0,
    95.0,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "deflection",
        unit: "m",
        doc: "deflection of the bobbin's centre",
    },
    Quantity {
        name: "pressure",
        unit: "N",
        doc: "force of the layer on the bobbin beyond that at rest",
    },
    Quantity {
        name: "mass",
        unit: "kg",
        doc: "reduced mass m(R)",
    },
    Quantity {
        name: "force",
        unit: "N",
        doc: "force disturbance",
    },
    Quantity {
        name: "shape",
        unit: "m",
        doc: "shape of the drum",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.5,
    points: 2001,
    rtol: 1e-8,
    method: "tsit45",
};

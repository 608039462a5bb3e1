// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   e37df34497b46761b32cf9fd4b2154f2b8af8b4059dbfe9faf6a01ada9944402  scenes/winder_full.toml
//   6a499f56da908c543a803cb62c4955ce07ac86b90e61c7b8d2e18332a529f16e  units/pressed_bobbin.toml
//   101cd072fa52fb3709d9fdd0b1d21ebcc701907b5ea804f1fcaac4d6c575bd3c  units/yarn_layer_one_sided.toml
//   4a9287d8640ce522ef5c8bd7b795a51195467dcdcc985c50f2cb32e6d3c10664  units/winding_pair.toml
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
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        4
//   states                    8
//   parameters               30
//   outputs                   8
//   discontinuities           0
//   events                    9
//
// State:
//     0  holder.x       [m]      deflection of the bobbin's centre
//     1  pair.phi       [rad]    angle of the package
//     2  holder.v       [m/s]    rate of deflection of the bobbin's centre
//     3  pair.omega     [rad/s]  rate of angle of the package
//     4  layer.surface  [m]      s, compression of the layer beyond that at rest, while nothing touches it
//     5  layer.closed   [1]      1 while bobbin and drum touch
//     6  pair.radius    [m]      R, radius of the package
//     7  pair.slip      [1]      -1 while the package lags behind the drum, 0 while it sticks to it, 1 while it runs ahead; -2 while it stands still
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian            14 of 8 by 8
//   parameter_jacobian       51 of 8 by 30
//
// Operations:
//   initial_state             5
//   discontinuities           0
//   rate                    103
//   mass_matrix              17
//   forcing                  82
//   rate_jacobian           188
//   parameter_jacobian      473
//   time_derivative          83
//   outputs                  77
//   energy                   59
//   power_balance           145
//   guards                   64
//   guard_rates             199
//   resets                   67
// With constants of the parameters, prepared once a run:
//   prepare                  27
//   prepared_rate            83
//   prepared_rate_jacobian  161

use ::machinist_contract::{
    Describe, Direction, Event, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 8;

/// Parameters.
pub const PARAMETERS: usize = 30;

/// Wanted outputs.
pub const OUTPUTS: usize = 8;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Events.
pub const EVENTS: usize = 9;

/// States that events set, those of all events.
pub const RESETS: usize = 13;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[
        (0, 2), (1, 3), (2, 0), (2, 1), (2, 2), (2, 3), (2, 6), (3, 0), (3, 2), (3, 3), (3, 6),
        (4, 2), (4, 4), (6, 3),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 30,
    entries: &[
        (2, 0), (2, 1), (2, 2), (2, 3), (2, 4), (2, 5), (2, 6), (2, 7), (2, 8), (2, 11), (2, 12),
        (2, 13), (2, 14), (2, 15), (2, 16), (2, 17), (2, 18), (2, 19), (2, 20), (2, 22), (2, 23),
        (2, 24), (3, 0), (3, 1), (3, 6), (3, 7), (3, 8), (3, 16), (3, 17), (3, 18), (3, 19),
        (3, 20), (3, 22), (3, 23), (3, 24), (3, 25), (3, 26), (3, 27), (3, 28), (3, 29), (4, 0),
        (4, 1), (4, 6), (4, 7), (4, 8), (4, 16), (4, 17), (4, 18), (4, 19), (6, 22), (6, 24),
    ],
};

/// Bobbin on a winding drum, all nonlinearities
///
/// The bobbin of \`winder_nonlinear\` on a layer that only pushes, so that it may leave the drum; the
/// package turned by friction, which is lost with the pressure; and the package grows. Third stage
/// of modelling. As long as there is contact, its deflection is that of \`winder_nonlinear\`.
///
/// Source: Winder study, third stage of modelling; mass, viscosity, stiffnesses and disturbances of its bench model M5. Arms, speed, radii, frictions and pressure are plausible ones.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WinderFull;

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
    /// holder.stiffness: c_p, spring of the holder, reduced to the bobbin's centre \[N/m\]. In the spec: 3800.0.
    pub holder_stiffness: R,
    /// holder.preload: N0, pressure at rest \[N\]. In the spec: 40.0.
    pub holder_preload: R,
    /// layer.stiffness: c, stiffness of the layer \[N/m\]. In the spec: 42000.0.
    pub layer_stiffness: R,
    /// layer.cubic_stiffness: c3, stiffening of the layer: a fifth of the stiffness at 2 mm \[N/m^3\]. In the spec: 2000000000.0.
    pub layer_cubic_stiffness: R,
    /// layer.viscosity: h, viscosity of the layer, above zero \[N s/m\]. In the spec: 95.0.
    pub layer_viscosity: R,
    /// pair.bobbin_radius: Rmin, radius of the empty bobbin \[m\]. In the spec: 0.03.
    pub pair_bobbin_radius: R,
    /// pair.package_radius: radius of the package at the start \[m\]. In the spec: 0.03.
    pub pair_package_radius: R,
    /// pair.package_width: H, width of the package \[m\]. In the spec: 0.15.
    pub pair_package_width: R,
    /// pair.yarn_density: rho, density of the wound yarn \[kg/m^3\]. In the spec: 350.0.
    pub pair_yarn_density: R,
    /// pair.thread_area: volume that a length of thread takes up on the package: that of 20 tex \[m^2\]. In the spec: 5.7e-8.
    pub pair_thread_area: R,
    /// pair.bobbin_inertia: moment of inertia of the empty bobbin \[kg m^2\]. In the spec: 0.0006.
    pub pair_bobbin_inertia: R,
    /// pair.tension: Pn, tension of the thread \[N\]. In the spec: 0.6.
    pub pair_tension: R,
    /// pair.friction: f, between drum and package \[1\]. In the spec: 0.18.
    pub pair_friction: R,
    /// pair.support_arm: fa r, friction of the support times its radius \[m\]. In the spec: 0.0004.
    pub pair_support_arm: R,
    /// pair.rolling_arm: k, arm of rolling friction \[m\]. In the spec: 0.0006.
    pub pair_rolling_arm: R,
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
            holder_stiffness: values[15],
            holder_preload: values[16],
            layer_stiffness: values[17],
            layer_cubic_stiffness: values[18],
            layer_viscosity: values[19],
            pair_bobbin_radius: values[20],
            pair_package_radius: values[21],
            pair_package_width: values[22],
            pair_yarn_density: values[23],
            pair_thread_area: values[24],
            pair_bobbin_inertia: values[25],
            pair_tension: values[26],
            pair_friction: values[27],
            pair_support_arm: values[28],
            pair_rolling_arm: values[29],
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
            self.holder_stiffness,
            self.holder_preload,
            self.layer_stiffness,
            self.layer_cubic_stiffness,
            self.layer_viscosity,
            self.pair_bobbin_radius,
            self.pair_package_radius,
            self.pair_package_width,
            self.pair_yarn_density,
            self.pair_thread_area,
            self.pair_bobbin_inertia,
            self.pair_tension,
            self.pair_friction,
            self.pair_support_arm,
            self.pair_rolling_arm,
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
            holder_stiffness: R::literal(3800.0),
            holder_preload: R::literal(40.0),
            layer_stiffness: R::literal(42000.0),
            layer_cubic_stiffness: R::literal(2e9),
            layer_viscosity: R::literal(95.0),
            pair_bobbin_radius: R::literal(0.03),
            pair_package_radius: R::literal(0.03),
            pair_package_width: R::literal(0.15),
            pair_yarn_density: R::literal(350.0),
            pair_thread_area: R::literal(5.7e-8),
            pair_bobbin_inertia: R::literal(0.0006),
            pair_tension: R::literal(0.6),
            pair_friction: R::literal(0.18),
            pair_support_arm: R::literal(0.0004),
            pair_rolling_arm: R::literal(0.0006),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// deflection: deflection of the bobbin's centre \[m\].
    pub deflection: R,
    /// pressure: N, force of the layer on the bobbin \[N\].
    pub pressure: R,
    /// mass: reduced mass m(R) \[kg\].
    pub mass: R,
    /// radius: R, radius of the package \[m\].
    pub radius: R,
    /// friction: friction of the drum on the package \[N\].
    pub friction: R,
    /// slip: nu, share by which the package lags behind the drum \[1\].
    pub slip: R,
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
            radius: values[3],
            friction: values[4],
            slip: values[5],
            force: values[6],
            shape: values[7],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.deflection,
            self.pressure,
            self.mass,
            self.radius,
            self.friction,
            self.slip,
            self.force,
            self.shape,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// holder.x: deflection of the bobbin's centre \[m\].
    pub const HOLDER_X: usize = 0;
    /// pair.phi: angle of the package \[rad\].
    pub const PAIR_PHI: usize = 1;
    /// holder.v: rate of deflection of the bobbin's centre \[m/s\].
    pub const HOLDER_V: usize = 2;
    /// pair.omega: rate of angle of the package \[rad/s\].
    pub const PAIR_OMEGA: usize = 3;
    /// layer.surface: s, compression of the layer beyond that at rest, while nothing touches it \[m\].
    pub const LAYER_SURFACE: usize = 4;
    /// layer.closed: 1 while bobbin and drum touch \[1\].
    pub const LAYER_CLOSED: usize = 5;
    /// pair.radius: R, radius of the package \[m\].
    pub const PAIR_RADIUS: usize = 6;
    /// pair.slip: \-1 while the package lags behind the drum, 0 while it sticks to it, 1 while it runs ahead; -2 while it stands still \[1\].
    pub const PAIR_SLIP: usize = 7;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 19;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub drum_speed: R,
    pub t1: R,
    pub pair_bobbin_radius_squared: R,
    pub t2: R,
    pub pair_bobbin_radius_squared_squared: R,
    pub t3: R,
    pub t4: R,
    pub t5: R,
    pub t6: R,
    pub eccentricity_times_drum_speed: R,
    pub t7: R,
    pub t8: R,
    pub minus_holder_preload: R,
    pub inverse_layer_viscosity: R,
    pub t9: R,
    pub minus_layer_stiffness: R,
    pub minus_layer_viscosity: R,
    pub t10: R,
    pub t11: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            drum_speed: values[0],
            t1: values[1],
            pair_bobbin_radius_squared: values[2],
            t2: values[3],
            pair_bobbin_radius_squared_squared: values[4],
            t3: values[5],
            t4: values[6],
            t5: values[7],
            t6: values[8],
            eccentricity_times_drum_speed: values[9],
            t7: values[10],
            t8: values[11],
            minus_holder_preload: values[12],
            inverse_layer_viscosity: values[13],
            t9: values[14],
            minus_layer_stiffness: values[15],
            minus_layer_viscosity: values[16],
            t10: values[17],
            t11: values[18],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.drum_speed,
            self.t1,
            self.pair_bobbin_radius_squared,
            self.t2,
            self.pair_bobbin_radius_squared_squared,
            self.t3,
            self.t4,
            self.t5,
            self.t6,
            self.eccentricity_times_drum_speed,
            self.t7,
            self.t8,
            self.minus_holder_preload,
            self.inverse_layer_viscosity,
            self.t9,
            self.minus_layer_stiffness,
            self.minus_layer_viscosity,
            self.t10,
            self.t11,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 27 operations.
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
    let t3 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
        * p.pair_yarn_density;
    let t4 = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm;
    let t5 = R::literal(2.0) * drum_speed;
    let t6 = R::literal(2.0) * p.ovality * drum_speed;
    let eccentricity_times_drum_speed = p.eccentricity * drum_speed;
    let t7 = p.pair_support_arm + p.pair_rolling_arm;
    let t8 = p.pair_yarn_density * p.pair_thread_area;
    let minus_holder_preload = -p.holder_preload;
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let t9 = R::literal(3.0) * p.layer_cubic_stiffness;
    let minus_layer_stiffness = -p.layer_stiffness;
    let minus_layer_viscosity = -p.layer_viscosity;
    let t10 = -p.pair_support_arm - p.pair_rolling_arm;
    let t11 = R::literal(core::f64::consts::TAU) * p.pair_package_width
        * p.pair_yarn_density;
    Constants {
        drum_speed,
        t1,
        pair_bobbin_radius_squared,
        t2,
        pair_bobbin_radius_squared_squared,
        t3,
        t4,
        t5,
        t6,
        eccentricity_times_drum_speed,
        t7,
        t8,
        minus_holder_preload,
        inverse_layer_viscosity,
        t9,
        minus_layer_stiffness,
        minus_layer_viscosity,
        t10,
        t11,
    }
}

/// State at the start of the run, in the units of the states.
///
/// 5 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [
        p.initial_deflection,
        R::literal(0.0),
        p.initial_velocity,
        p.winding_speed / p.pair_package_radius,
        p.eccentricity.add_product(p.ovality, p.ovality_phase.cos())
            - p.initial_deflection,
        R::literal(1.0),
        p.pair_package_radius,
        R::literal(0.0),
    ]
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
/// 103 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 83 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let t0 = p.ovality_phase.add_product(c.t5, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3),
    (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let layer_swelling = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_surface)
        .add_product(
            p.layer_cubic_stiffness,
            layer_surface * layer_surface * layer_surface,
        );
    let pair_growth = c.t1 * pair_omega;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t2 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            c.t3,
            (-c.pair_bobbin_radius_squared_squared)
                .add_product(pair_radius_squared, pair_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let holder_mass = c.t4 + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(c.eccentricity_times_drum_speed * sin_drum_speed_times_time))
        .sub_product(c.t6, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let t4 = p.layer_stiffness * layer_compression;
    let t5 = p.layer_cubic_stiffness
        * (layer_compression * layer_compression * layer_compression);
    let t6 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t4 + t5 + t6;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            c.t7 * layer_push / pair_radius,
        );
    let pair_held = pair_resistance
        - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let pair_omega_dot = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    ) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t6))
        .sub_product(c.t8 * holder_v * pair_omega, pair_radius)
        - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                c.minus_holder_preload - t4 - t5,
            ))) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(c.inverse_layer_viscosity * layer_swelling),
        layer_compression_rate,
    );
    [
        holder_v,
        pair_omega,
        holder_v_dot,
        pair_omega_dot,
        layer_surface_dot,
        R::literal(0.0),
        pair_growth,
        R::literal(0.0),
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 17 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 2] {
    let [_, _, _, _, _, _, pair_radius, ..] = *state;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    [holder_mass, pair_inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 82 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius,
    pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3),
    (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let pair_growth = R::literal(0.5) * p.pair_thread_area
        / (R::literal(core::f64::consts::PI) * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let t4 = p.layer_stiffness * layer_compression;
    let t5 = p.layer_cubic_stiffness
        * (layer_compression * layer_compression * layer_compression);
    let t6 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t4 + t5 + t6;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius,
        );
    let pair_held = pair_resistance
        - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let holder_x_forcing = (force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t6))
        .sub_product(
            p.pair_yarn_density * p.pair_thread_area * holder_v * pair_omega,
            pair_radius,
        )
        - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -p.holder_preload - t4 - t5,
            ));
    let pair_phi_forcing = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    );
    [holder_x_forcing, pair_phi_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 188 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 14] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 161 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 14] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
    let drum_speed_times_time = c.drum_speed * time;
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t0 = p.ovality_phase.add_product(c.t5, time);
    let [(_, t1), (sin_package_phase_plus_pair_phi, cos_package_phase_plus_pair_phi),
    (t2, t3), (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        package_phase_plus_pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let pair_growth = c.t1 * pair_omega;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = c.t2 * (pair_radius_squared - c.pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            c.t3,
            (-c.pair_bobbin_radius_squared_squared)
                .add_product(pair_radius_squared, pair_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let holder_mass = c.t4 + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(c.eccentricity_times_drum_speed * sin_drum_speed_times_time))
        .sub_product(c.t6, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let t4 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t5 = p.layer_cubic_stiffness * (layer_compression_squared * layer_compression);
    let t6 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t4 + t5 + t6;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let t7 = c.t7 * layer_push;
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t7 / pair_radius,
        );
    let pair_held = pair_resistance
        - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t8 = c.t8 * holder_v;
    let t9 = t8 * pair_omega;
    let pair_omega_dot = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    ) * inverse_pair_inertia;
    let holder_v_dot = ((force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t6))
        .sub_product(t9, pair_radius)
        - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                c.minus_holder_preload - t4 - t5,
            ))) * inverse_holder_mass;
    let t10 = c.t9 * layer_compression_squared;
    let t11 = c.minus_layer_stiffness - t10;
    let t12 = c.t7 * t11 / pair_radius;
    let t13 = p.pair_friction * t11;
    let t14 = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        R::literal(1.0),
    );
    let pair_omega_dot_by_holder_x = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t13,
                R::select_less(pair_slip, R::literal(0.5), t12, -t13),
            ) - t12) * t14,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_holder_x = -((p.holder_stiffness
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            p.layer_stiffness + t10,
        )) * inverse_holder_mass);
    let holder_v_dot_by_pair_phi = -(p.package_force * sin_package_phase_plus_pair_phi
        * inverse_holder_mass);
    let pair_friction_times_pair_radius = p.pair_friction * pair_radius;
    let pair_omega_dot_by_holder_v = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        p.layer_viscosity
            * (c.t7
                + R::select_less(
                    pair_slip,
                    R::literal(-0.5),
                    -pair_friction_times_pair_radius,
                    R::select_less(
                        pair_slip,
                        R::literal(0.5),
                        c.t10,
                        pair_friction_times_pair_radius,
                    ),
                )) * t14,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_holder_v = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            c.minus_layer_viscosity,
        )
        .sub_product(c.t8 * pair_omega, pair_radius) * inverse_holder_mass;
    let layer_surface_dot_by_holder_v = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        R::literal(-1.0),
    );
    let pair_omega_dot_by_pair_omega = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        -(R::literal(2.0) * pair_growth * pair_inertia
            * R::select_less(
                pair_slip,
                R::literal(-0.5),
                R::literal(0.0),
                R::literal(1.0),
            )
            * R::select_less(
                pair_slip,
                R::literal(0.5),
                R::literal(1.0),
                R::literal(0.0),
            ) / pair_radius),
    ) * inverse_pair_inertia;
    let holder_v_dot_by_pair_omega = -(t8 * pair_radius * inverse_holder_mass);
    let layer_surface_dot_by_layer_surface = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(c.inverse_layer_viscosity
            * p.layer_stiffness.add_product(c.t9, layer_surface * layer_surface)),
        R::literal(0.0),
    );
    let t15 = t7 / pair_radius_squared;
    let t16 = pair_radius_squared * pair_radius;
    let pair_omega_dot_by_pair_radius = R::select_less(
            pair_slip,
            R::literal(-1.5),
            R::literal(0.0),
            pair_carried
                .add_product(
                    pair_radius,
                    R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15)
                        + R::select_less(
                            pair_slip,
                            R::literal(-0.5),
                            R::literal(0.0),
                            R::select_less(
                                pair_slip,
                                R::literal(0.5),
                                (R::literal(2.0) * pair_omega * pair_growth * pair_inertia
                                    / t16
                                    + R::select_less(
                                        layer_closed,
                                        R::literal(0.5),
                                        R::literal(0.0),
                                        -t15,
                                    ))
                                    .sub_product(c.t8 * pair_radius, pair_omega * pair_omega),
                                R::literal(0.0),
                            ),
                        ),
                ) - pair_resistance,
        )
        .sub_product(c.t11 * t16, pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_radius = (-t9)
        .sub_product(c.t11 * pair_radius, holder_v_dot) * inverse_holder_mass;
    [
        R::literal(1.0),
        R::literal(1.0),
        holder_v_dot_by_holder_x,
        holder_v_dot_by_pair_phi,
        holder_v_dot_by_holder_v,
        holder_v_dot_by_pair_omega,
        holder_v_dot_by_pair_radius,
        pair_omega_dot_by_holder_x,
        pair_omega_dot_by_holder_v,
        pair_omega_dot_by_pair_omega,
        pair_omega_dot_by_pair_radius,
        layer_surface_dot_by_holder_v,
        layer_surface_dot_by_layer_surface,
        c.t1,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 473 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 51] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.force_phase + drum_speed_times_time;
    let package_phase_plus_pair_phi = p.package_phase + pair_phi;
    let t1 = R::literal(2.0) * drum_speed;
    let t2 = p.ovality_phase.add_product(t1, time);
    let [(t3, t4), (sin_package_phase_plus_pair_phi, cos_package_phase_plus_pair_phi),
    (t5, t6), (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        t0,
        package_phase_plus_pair_phi,
        t2,
        drum_speed_times_time,
    ]);
    let t7 = layer_surface * layer_surface * layer_surface;
    let layer_swelling = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_surface)
        .add_product(p.layer_cubic_stiffness, t7);
    let t8 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t8 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let t9 = pair_radius_squared - pair_bobbin_radius_squared;
    let pair_package_mass = t8 * p.pair_yarn_density * t9;
    let pair_bobbin_radius_squared_squared = pair_bobbin_radius_squared
        * pair_bobbin_radius_squared;
    let t10 = (-pair_bobbin_radius_squared_squared)
        .add_product(pair_radius_squared, pair_radius_squared);
    let t11 = R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width;
    let pair_inertia = p.pair_bobbin_inertia.add_product(t11 * p.pair_yarn_density, t10);
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t4);
    let t12 = p.holder_link_mass * p.holder_link_arm;
    let holder_mass = p.holder_bobbin_mass + t12 / p.holder_holder_arm
        + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t6);
    let layer_compression = shape - holder_x;
    let t13 = R::literal(2.0) * p.ovality;
    let t14 = t13 * drum_speed;
    let eccentricity_times_drum_speed = p.eccentricity * drum_speed;
    let shape_rate = (-(eccentricity_times_drum_speed * sin_drum_speed_times_time))
        .sub_product(t14, t5);
    let layer_compression_rate = shape_rate - holder_v;
    let t15 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t16 = layer_compression_squared * layer_compression;
    let t17 = p.layer_cubic_stiffness * t16;
    let t18 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t15 + t17 + t18;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let t19 = p.pair_support_arm + p.pair_rolling_arm;
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t19 * layer_push / pair_radius,
        );
    let pair_omega_times_pair_growth = pair_omega * pair_growth;
    let pair_held = pair_resistance
        - pair_omega_times_pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let inverse_holder_mass = R::literal(1.0) / holder_mass;
    let inverse_pair_inertia = R::literal(1.0) / pair_inertia;
    let t20 = p.pair_yarn_density * p.pair_thread_area;
    let pair_omega_dot = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    ) * inverse_pair_inertia;
    let holder_v_dot = ((force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t18))
        .sub_product(t20 * holder_v * pair_omega, pair_radius)
        - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -p.holder_preload - t15 - t17,
            ))) * inverse_holder_mass;
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let t21 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t22 = t21 * layer_compression_squared;
    let t23 = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        R::literal(1.0),
    );
    let holder_v_dot_by_package_phase = -(p.package_force
        * sin_package_phase_plus_pair_phi * inverse_holder_mass);
    let pair_friction_times_pair_radius = p.pair_friction * pair_radius;
    let t24 = -pair_friction_times_pair_radius;
    let t25 = t19
        + R::select_less(
            pair_slip,
            R::literal(-0.5),
            t24,
            R::select_less(
                pair_slip,
                R::literal(0.5),
                -p.pair_support_arm - p.pair_rolling_arm,
                pair_friction_times_pair_radius,
            ),
        );
    let t26 = R::select_less(
        pair_slip,
        R::literal(-0.5),
        R::literal(0.0),
        R::literal(1.0),
    );
    let t27 = R::select_less(
        pair_slip,
        R::literal(0.5),
        R::literal(1.0),
        R::literal(0.0),
    );
    let pair_omega_squared = pair_omega * pair_omega;
    let t28 = t13 / p.drum_radius;
    let eccentricity_over_drum_radius = p.eccentricity / p.drum_radius;
    let t29 = (-(eccentricity_over_drum_radius * time * sin_drum_speed_times_time))
        .sub_product(t28 * time, t5);
    let t30 = t21 * t29 * layer_compression_squared;
    let t31 = p.layer_stiffness * t29;
    let t32 = R::literal(4.0) * p.ovality;
    let t33 = eccentricity_times_drum_speed / p.drum_radius;
    let t34 = t33 * time;
    let t35 = (-(t28 * t5))
        .sub_product(t32 * drum_speed / p.drum_radius * time, t6)
        .sub_product(t34, cos_drum_speed_times_time)
        .sub_product(eccentricity_over_drum_radius, sin_drum_speed_times_time);
    let t36 = p.layer_viscosity * t35;
    let t37 = t30 + t31 + t36;
    let t38 = t19 * t37 / pair_radius;
    let t39 = p.pair_friction * t37;
    let pair_omega_dot_by_winding_speed = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t39,
                R::select_less(pair_slip, R::literal(0.5), t38, -t39),
            ) - t38) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_winding_speed = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t36 - (-t30 - t31),
        )
        .sub_product(p.force_amplitude / p.drum_radius * time, t3) * inverse_holder_mass;
    let layer_surface_dot_by_winding_speed = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        t35,
    );
    let t40 = t14 / p.drum_radius;
    let t41 = (t34 * sin_drum_speed_times_time).add_product(t40 * time, t5);
    let t42 = t21 * t41 * layer_compression_squared;
    let t43 = p.layer_stiffness * t41;
    let drum_speed_squared = drum_speed * drum_speed;
    let t44 = (t40 * t5)
        .add_product(t32 * drum_speed_squared / p.drum_radius * time, t6)
        .add_product(
            p.eccentricity * drum_speed_squared / p.drum_radius * time,
            cos_drum_speed_times_time,
        )
        .add_product(t33, sin_drum_speed_times_time);
    let t45 = p.layer_viscosity * t44;
    let t46 = t42 + t43 + t45;
    let t47 = t19 * t46 / pair_radius;
    let t48 = p.pair_friction * t46;
    let pair_omega_dot_by_drum_radius = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t48,
                R::select_less(pair_slip, R::literal(0.5), t47, -t48),
            ) - t47) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_drum_radius = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t45 - (-t42 - t43),
        )
        .add_product(p.force_amplitude * drum_speed / p.drum_radius * time, t3)
        * inverse_holder_mass;
    let layer_surface_dot_by_drum_radius = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        t44,
    );
    let holder_v_dot_by_force_amplitude = t4 * inverse_holder_mass;
    let holder_v_dot_by_force_phase = -(p.force_amplitude * t3 * inverse_holder_mass);
    let holder_v_dot_by_package_force = cos_package_phase_plus_pair_phi
        * inverse_holder_mass;
    let t49 = R::literal(2.0) * p.layer_viscosity * drum_speed * t5;
    let t50 = t22 * t6;
    let t51 = p.layer_stiffness * t6;
    let t52 = t50 + t51 - t49;
    let t53 = t19 * t52 / pair_radius;
    let t54 = p.pair_friction * t52;
    let pair_omega_dot_by_ovality = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t54,
                R::select_less(pair_slip, R::literal(0.5), t53, -t54),
            ) - t53) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_ovality = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -t49 - (-t50 - t51),
    ) * inverse_holder_mass;
    let layer_surface_dot_by_ovality = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(t1 * t5),
    );
    let t55 = t13 * p.layer_viscosity * drum_speed * t6;
    let t56 = R::literal(3.0) * p.ovality * p.layer_cubic_stiffness
        * layer_compression_squared * t5;
    let t57 = p.ovality * p.layer_stiffness * t5;
    let t58 = -t56 - t55 - t57;
    let t59 = t19 * t58 / pair_radius;
    let t60 = p.pair_friction * t58;
    let pair_omega_dot_by_ovality_phase = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t60,
                R::select_less(pair_slip, R::literal(0.5), t59, -t60),
            ) - t59) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_ovality_phase = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -t55 - (t56 + t57),
    ) * inverse_holder_mass;
    let layer_surface_dot_by_ovality_phase = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(t14 * t6),
    );
    let t61 = p.layer_viscosity * drum_speed * sin_drum_speed_times_time;
    let t62 = t22 * cos_drum_speed_times_time;
    let t63 = p.layer_stiffness * cos_drum_speed_times_time;
    let t64 = t62 + t63 - t61;
    let t65 = t19 * t64 / pair_radius;
    let t66 = p.pair_friction * t64;
    let pair_omega_dot_by_eccentricity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t66,
                R::select_less(pair_slip, R::literal(0.5), t65, -t66),
            ) - t65) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_eccentricity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -t61 - (-t62 - t63),
    ) * inverse_holder_mass;
    let layer_surface_dot_by_eccentricity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(drum_speed * sin_drum_speed_times_time),
    );
    let holder_v_dot_by_holder_bobbin_mass = -(holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_mass = -(p.holder_link_arm / p.holder_holder_arm
        * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_link_arm = -(p.holder_link_mass / p.holder_holder_arm
        * holder_v_dot * inverse_holder_mass);
    let holder_v_dot_by_holder_holder_arm = t12
        / (p.holder_holder_arm * p.holder_holder_arm) * holder_v_dot
        * inverse_holder_mass;
    let holder_v_dot_by_holder_stiffness = -(holder_x * inverse_holder_mass);
    let pair_omega_dot_by_holder_preload = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        R::select_less(
            pair_slip,
            R::literal(-1.5),
            R::literal(0.0),
            R::select_less(
                pair_slip,
                R::literal(-0.5),
                pair_friction_times_pair_radius,
                R::select_less(pair_slip, R::literal(0.5), t19, t24),
            ) - p.pair_support_arm - p.pair_rolling_arm,
        ),
    ) * inverse_pair_inertia;
    let holder_v_dot_by_holder_preload = (R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        R::literal(1.0),
    ) - R::literal(1.0)) * inverse_holder_mass;
    let layer_surface_dot_by_holder_preload = R::select_less(
        layer_closed,
        R::literal(0.5),
        -inverse_layer_viscosity,
        R::literal(0.0),
    );
    let pair_omega_dot_by_layer_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(layer_compression * t25 * t23),
    ) * inverse_pair_inertia;
    let holder_v_dot_by_layer_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        layer_compression,
    ) * inverse_holder_mass;
    let layer_surface_dot_by_layer_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(inverse_layer_viscosity * layer_surface),
        R::literal(0.0),
    );
    let holder_x_minus_shape = holder_x - shape;
    let pair_omega_dot_by_layer_cubic_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        t25 * (holder_x_minus_shape * holder_x_minus_shape * holder_x_minus_shape) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_layer_cubic_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        t16,
    ) * inverse_holder_mass;
    let layer_surface_dot_by_layer_cubic_stiffness = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(inverse_layer_viscosity * t7),
        R::literal(0.0),
    );
    let t67 = t19 * layer_compression_rate / pair_radius;
    let t68 = p.pair_friction * layer_compression_rate;
    let pair_omega_dot_by_layer_viscosity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t68,
                R::select_less(pair_slip, R::literal(0.5), t67, -t68),
            ) - t67) * t23,
    ) * inverse_pair_inertia;
    let holder_v_dot_by_layer_viscosity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        layer_compression_rate,
    ) * inverse_holder_mass;
    let layer_surface_dot_by_layer_viscosity = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(1.0) / (p.layer_viscosity * p.layer_viscosity) * layer_swelling,
        R::literal(0.0),
    );
    let t69 = pair_bobbin_radius_squared * p.pair_bobbin_radius;
    let pair_omega_dot_by_pair_bobbin_radius = R::select_less(
            pair_slip,
            R::literal(-1.5),
            R::literal(0.0),
            t20 * t69 * pair_omega_squared * t26 * t27 / pair_radius,
        )
        .add_product(
            R::literal(core::f64::consts::TAU) * p.pair_package_width
                * p.pair_yarn_density * t69,
            pair_omega_dot,
        ) * inverse_pair_inertia;
    let holder_v_dot_by_pair_bobbin_radius = R::literal(core::f64::consts::TAU)
        * p.pair_bobbin_radius * p.pair_package_width * p.pair_yarn_density
        * holder_v_dot * inverse_holder_mass;
    let pair_omega_dot_by_pair_package_width = R::select_less(
            pair_slip,
            R::literal(-1.5),
            R::literal(0.0),
            p.pair_bobbin_inertia / p.pair_package_width * pair_omega * pair_growth * t26
                * t27 / pair_radius,
        )
        .sub_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_yarn_density * t10,
            pair_omega_dot,
        ) * inverse_pair_inertia;
    let holder_v_dot_by_pair_package_width = -(R::literal(core::f64::consts::PI)
        * p.pair_yarn_density * t9 * holder_v_dot * inverse_holder_mass);
    let pair_radius_dot_by_pair_package_width = -(R::literal(1.0) / p.pair_package_width
        * pair_growth);
    let t70 = R::literal(0.25) * p.pair_thread_area;
    let pair_omega_dot_by_pair_yarn_density = R::select_less(
            pair_slip,
            R::literal(-1.5),
            R::literal(0.0),
            R::select_less(
                pair_slip,
                R::literal(-0.5),
                R::literal(0.0),
                R::select_less(
                    pair_slip,
                    R::literal(0.5),
                    (t70 * pair_bobbin_radius_squared_squared * pair_omega_squared
                        / pair_radius)
                        .sub_product(
                            t70 * pair_omega_squared,
                            pair_radius_squared * pair_radius,
                        ),
                    R::literal(0.0),
                ),
            ),
        )
        .sub_product(t11 * t10, pair_omega_dot) * inverse_pair_inertia;
    let holder_v_dot_by_pair_yarn_density = (-(p.pair_thread_area * holder_v * pair_omega
        * pair_radius))
        .sub_product(t8 * t9, holder_v_dot) * inverse_holder_mass;
    let t71 = R::literal(0.5) / t8;
    let pair_omega_dot_by_pair_thread_area = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        -(t71 * pair_inertia * pair_omega_squared * t26 * t27 / pair_radius),
    ) * inverse_pair_inertia;
    let holder_v_dot_by_pair_thread_area = -(p.pair_yarn_density * holder_v * pair_omega
        * pair_radius * inverse_holder_mass);
    let pair_radius_dot_by_pair_thread_area = t71 * pair_omega;
    let pair_omega_dot_by_pair_bobbin_inertia = (R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        -(pair_omega_times_pair_growth * t26 * t27 / pair_radius),
    ) - pair_omega_dot) * inverse_pair_inertia;
    let pair_omega_dot_by_pair_tension = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        R::select_less(
            pair_slip,
            R::literal(-0.5),
            R::literal(0.0),
            R::select_less(pair_slip, R::literal(0.5), pair_radius, R::literal(0.0)),
        ) - pair_radius,
    ) * inverse_pair_inertia;
    let pair_omega_dot_by_pair_friction = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius * t23
            * R::select_less(
                pair_slip,
                R::literal(-0.5),
                layer_push,
                R::select_less(pair_slip, R::literal(0.5), R::literal(0.0), -layer_push),
            ),
    ) * inverse_pair_inertia;
    let layer_push_over_pair_radius = layer_push / pair_radius;
    let pair_omega_dot_by_pair_support_arm = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                R::literal(0.0),
                R::select_less(
                    pair_slip,
                    R::literal(0.5),
                    layer_push_over_pair_radius,
                    R::literal(0.0),
                ),
            ) - layer_push_over_pair_radius) * t23,
    ) * inverse_pair_inertia;
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
        holder_v_dot_by_holder_stiffness,
        holder_v_dot_by_holder_preload,
        holder_v_dot_by_layer_stiffness,
        holder_v_dot_by_layer_cubic_stiffness,
        holder_v_dot_by_layer_viscosity,
        holder_v_dot_by_pair_bobbin_radius,
        holder_v_dot_by_pair_package_width,
        holder_v_dot_by_pair_yarn_density,
        holder_v_dot_by_pair_thread_area,
        pair_omega_dot_by_winding_speed,
        pair_omega_dot_by_drum_radius,
        pair_omega_dot_by_ovality,
        pair_omega_dot_by_ovality_phase,
        pair_omega_dot_by_eccentricity,
        pair_omega_dot_by_holder_preload,
        pair_omega_dot_by_layer_stiffness,
        pair_omega_dot_by_layer_cubic_stiffness,
        pair_omega_dot_by_layer_viscosity,
        pair_omega_dot_by_pair_bobbin_radius,
        pair_omega_dot_by_pair_package_width,
        pair_omega_dot_by_pair_yarn_density,
        pair_omega_dot_by_pair_thread_area,
        pair_omega_dot_by_pair_bobbin_inertia,
        pair_omega_dot_by_pair_tension,
        pair_omega_dot_by_pair_friction,
        pair_omega_dot_by_pair_support_arm,
        pair_omega_dot_by_pair_support_arm,
        layer_surface_dot_by_winding_speed,
        layer_surface_dot_by_drum_radius,
        layer_surface_dot_by_ovality,
        layer_surface_dot_by_ovality_phase,
        layer_surface_dot_by_eccentricity,
        layer_surface_dot_by_holder_preload,
        layer_surface_dot_by_layer_stiffness,
        layer_surface_dot_by_layer_cubic_stiffness,
        layer_surface_dot_by_layer_viscosity,
        pair_radius_dot_by_pair_package_width,
        pair_radius_dot_by_pair_thread_area,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// 83 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let [holder_x, _, _, _, _, layer_closed, pair_radius, pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time), (t3, _)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
        p.force_phase + drum_speed_times_time,
    ]);
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    let t4 = p.eccentricity * cos_drum_speed_times_time;
    let shape = t4.add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let t5 = R::literal(4.0) * p.ovality;
    let drum_speed_squared = drum_speed * drum_speed;
    let t6 = R::literal(3.0) * p.layer_cubic_stiffness * shape_rate
        * (layer_compression * layer_compression);
    let layer_stiffness_times_shape_rate = p.layer_stiffness * shape_rate;
    let t7 = p.layer_viscosity
        * (-(p.eccentricity * drum_speed_squared * cos_drum_speed_times_time))
            .sub_product(t5 * drum_speed_squared, t2);
    let t8 = t6 + layer_stiffness_times_shape_rate + t7;
    let t9 = (p.pair_support_arm + p.pair_rolling_arm) * t8 / pair_radius;
    let t10 = p.pair_friction * t8;
    let pair_omega_dot_by_time = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_radius
            * (R::select_less(
                pair_slip,
                R::literal(-0.5),
                t10,
                R::select_less(pair_slip, R::literal(0.5), t9, -t10),
            ) - t9)
            * R::select_less(
                pair_slip,
                R::literal(-1.5),
                R::literal(0.0),
                R::literal(1.0),
            ),
    ) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot_by_time = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t7 - (-t6 - layer_stiffness_times_shape_rate),
        )
        .sub_product(p.force_amplitude * drum_speed, t3)
        * (R::literal(1.0) / holder_mass);
    let layer_surface_dot_by_time = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        drum_speed_squared * (-t4).sub_product(t5, t2),
    );
    [
        R::literal(0.0),
        R::literal(0.0),
        holder_v_dot_by_time,
        pair_omega_dot_by_time,
        layer_surface_dot_by_time,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 77 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, _, layer_closed, pair_radius,
    pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3),
    (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let pair_sliding = (-p.winding_speed).add_product(pair_omega, pair_radius);
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t4 * p.pair_yarn_density
        * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let layer_push = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_compression)
        .add_product(
            p.layer_cubic_stiffness,
            layer_compression * layer_compression * layer_compression,
        )
        .add_product(p.layer_viscosity, layer_compression_rate);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius,
        );
    let pair_held = pair_resistance
        - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    Outputs {
        deflection: holder_x,
        pressure: R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            layer_push,
        ),
        mass: holder_mass,
        radius: pair_radius,
        friction: pair_carried,
        slip: -(R::literal(1.0) / p.winding_speed * pair_sliding),
        force,
        shape,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 59 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..,
    ] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let [(_, t0), (_, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time),
        drum_speed * time,
    ]);
    let layer_surface_squared = layer_surface * layer_surface;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = R::literal(core::f64::consts::PI) * p.pair_package_width
        * p.pair_yarn_density * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t0);
    let layer_compression = shape - holder_x;
    let layer_compression_squared = layer_compression * layer_compression;
    let t1 = R::literal(0.25) * p.layer_cubic_stiffness;
    let t2 = R::literal(0.5) * p.layer_stiffness;
    Energy {
        kinetic: (R::literal(0.5) * pair_inertia * (pair_omega * pair_omega))
            .add_product(R::literal(0.5) * holder_mass, holder_v * holder_v),
        potential: (p.holder_preload * holder_x)
            .add_product(R::literal(0.5) * p.holder_stiffness, holder_x * holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                (t2 * layer_compression_squared)
                    .add_product(
                        t1,
                        layer_compression_squared * layer_compression_squared,
                    )
                    .add_product(p.holder_preload, layer_compression),
            ),
        stored: R::select_less(
            layer_closed,
            R::literal(0.5),
            (t2 * layer_surface_squared)
                .add_product(t1, layer_surface_squared * layer_surface_squared)
                .add_product(p.holder_preload, layer_surface),
            R::literal(0.0),
        ),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 145 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3),
    (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let layer_swelling = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_surface)
        .add_product(
            p.layer_cubic_stiffness,
            layer_surface * layer_surface * layer_surface,
        );
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let t5 = t4 * p.pair_yarn_density;
    let pair_package_mass = t5 * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let t6 = p.layer_stiffness * layer_compression;
    let t7 = layer_compression * layer_compression * layer_compression;
    let t8 = p.layer_cubic_stiffness * t7;
    let t9 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t6 + t8 + t9;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius,
        );
    let pair_held = pair_resistance
        - pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let t10 = p.pair_yarn_density * p.pair_thread_area;
    let t11 = p.holder_preload.add_product(p.holder_stiffness, holder_x)
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            -p.holder_preload - t6 - t8,
        );
    let t12 = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    );
    let pair_omega_dot = t12 * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t9))
        .sub_product(t10 * holder_v * pair_omega, pair_radius) - t11)
        * (R::literal(1.0) / holder_mass);
    let inverse_layer_viscosity = R::literal(1.0) / p.layer_viscosity;
    let layer_surface_dot = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(inverse_layer_viscosity * layer_swelling),
        layer_compression_rate,
    );
    let pair_omega_squared = pair_omega * pair_omega;
    let t13 = pair_radius_squared * pair_radius;
    let t14 = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        (p.holder_preload * shape_rate)
            .add_product(t6, shape_rate)
            .add_product(p.layer_cubic_stiffness * shape_rate, t7),
    );
    let t15 = (t5 * pair_radius * (holder_v * holder_v))
        .add_product(t5 * pair_omega_squared, t13) * pair_growth;
    PowerBalance {
        stored_rate: t14
            .add_product(t11, holder_v)
            .add_product(holder_v * holder_mass, holder_v_dot)
            .add_product(pair_omega * pair_inertia, pair_omega_dot)
            .add_product(
                R::select_less(
                    layer_closed,
                    R::literal(0.5),
                    layer_swelling,
                    R::literal(0.0),
                ),
                layer_surface_dot,
            ) + t15,
        supplied: (holder_v * force)
            .add_product(pair_omega, t12.add_product(t10 * pair_omega_squared, t13))
            + t14 - t15,
        dissipated: R::select_less(
            layer_closed,
            R::literal(0.5),
            inverse_layer_viscosity * (layer_swelling * layer_swelling),
            -(p.layer_viscosity * holder_v * layer_compression_rate),
        ),
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 64 operations.
#[must_use]
pub fn guards<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [holder_x, _, holder_v, pair_omega, layer_surface, layer_closed, pair_radius, ..,
    ] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
    ]);
    let pair_sliding = (-p.winding_speed).add_product(pair_omega, pair_radius);
    let pair_growth = R::literal(0.5) * p.pair_thread_area
        / (R::literal(core::f64::consts::PI) * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let layer_compression_rate = shape_rate - holder_v;
    let layer_push = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_compression)
        .add_product(
            p.layer_cubic_stiffness,
            layer_compression * layer_compression * layer_compression,
        )
        .add_product(p.layer_viscosity, layer_compression_rate);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t3);
    let t4 = pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let layer_touches_guard = layer_compression - layer_surface;
    let pair_breaks_back_guard = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t3 - pair_friction_times_layer_push,
        ) - t4;
    let pair_breaks_forth_guard = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            pair_friction_times_layer_push + t3,
        ) - t4;
    let pair_turns_guard = pair_limit - pair_resistance;
    [
        layer_touches_guard,
        layer_push,
        time,
        pair_breaks_back_guard,
        pair_breaks_forth_guard,
        pair_sliding,
        pair_sliding,
        pair_omega,
        pair_turns_guard,
    ]
}

/// `dg/dt` of the guards along the motion.
///
/// 199 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(_, t1), (_, cos_package_phase_plus_pair_phi), (t2, t3),
    (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        p.force_phase + drum_speed_times_time,
        p.package_phase + pair_phi,
        t0,
        drum_speed_times_time,
    ]);
    let layer_swelling = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_surface)
        .add_product(
            p.layer_cubic_stiffness,
            layer_surface * layer_surface * layer_surface,
        );
    let t4 = R::literal(core::f64::consts::PI) * p.pair_package_width;
    let pair_growth = R::literal(0.5) * p.pair_thread_area / t4 * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_package_mass = t4 * p.pair_yarn_density
        * (pair_radius_squared - pair_bobbin_radius_squared);
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let force = (p.package_force * cos_package_phase_plus_pair_phi)
        .add_product(p.force_amplitude, t1);
    let holder_mass = p.holder_bobbin_mass
        + p.holder_link_mass * p.holder_link_arm / p.holder_holder_arm
        + pair_package_mass;
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t3);
    let layer_compression = shape - holder_x;
    let t5 = R::literal(2.0) * p.ovality;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(t5 * drum_speed, t2);
    let layer_compression_rate = shape_rate - holder_v;
    let t6 = p.layer_stiffness * layer_compression;
    let layer_compression_squared = layer_compression * layer_compression;
    let t7 = p.layer_cubic_stiffness * (layer_compression_squared * layer_compression);
    let t8 = p.layer_viscosity * layer_compression_rate;
    let layer_push = p.holder_preload + t6 + t7 + t8;
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let t9 = p.pair_support_arm + p.pair_rolling_arm;
    let t10 = t9 * layer_push;
    let pair_resistance = p.pair_tension
        + R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t10 / pair_radius,
        );
    let pair_omega_times_pair_growth = pair_omega * pair_growth;
    let pair_held = pair_resistance
        - pair_omega_times_pair_growth * pair_inertia / pair_radius_squared;
    let pair_carried = R::select_less(
        pair_slip,
        R::literal(-0.5),
        pair_limit,
        R::select_less(
            pair_slip,
            R::literal(0.5),
            pair_held,
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -pair_friction_times_layer_push,
            ),
        ),
    );
    let t11 = p.pair_yarn_density * p.pair_thread_area;
    let pair_omega_dot = R::select_less(
        pair_slip,
        R::literal(-1.5),
        R::literal(0.0),
        pair_radius * (pair_carried - pair_resistance),
    ) * (R::literal(1.0) / pair_inertia);
    let holder_v_dot = ((force
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t8))
        .sub_product(t11 * holder_v * pair_omega, pair_radius)
        - (p.holder_preload.add_product(p.holder_stiffness, holder_x)
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -p.holder_preload - t6 - t7,
            ))) * (R::literal(1.0) / holder_mass);
    let layer_surface_dot = R::select_less(
        layer_closed,
        R::literal(0.5),
        -(R::literal(1.0) / p.layer_viscosity * layer_swelling),
        layer_compression_rate,
    );
    let t12 = R::literal(3.0) * p.layer_cubic_stiffness;
    let t13 = (-p.layer_stiffness).sub_product(t12, layer_compression_squared);
    let t14 = t9 * t13 / pair_radius;
    let t15 = p.pair_friction * t13;
    let t16 = t10 / pair_radius_squared;
    let drum_speed_squared = drum_speed * drum_speed;
    let t17 = (p.layer_stiffness * shape_rate)
        .add_product(t12 * shape_rate, layer_compression_squared)
        .add_product(
            p.layer_viscosity,
            (-(p.eccentricity * drum_speed_squared * cos_drum_speed_times_time))
                .sub_product(R::literal(4.0) * p.ovality * drum_speed_squared, t3),
        );
    let t18 = t9 * t17 / pair_radius;
    let t19 = p.pair_friction * t17;
    let layer_touches_guard_rate = (-holder_v)
        .add_product(
            drum_speed,
            (-(p.eccentricity * sin_drum_speed_times_time)).sub_product(t5, t2),
        ) - layer_surface_dot;
    let layer_opens_guard_rate = t17
        .add_product(t13, holder_v)
        .sub_product(p.layer_viscosity, holder_v_dot);
    let t20 = p.layer_viscosity * t9 / pair_radius;
    let layer_viscosity_times_pair_friction = p.layer_viscosity * p.pair_friction;
    let t21 = R::literal(2.0) * pair_growth * pair_inertia / pair_radius_squared
        * pair_omega_dot;
    let t22 = (R::literal(2.0) * pair_omega * pair_growth * pair_inertia
        / (pair_radius_squared * pair_radius)
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), -t16))
        .sub_product(t11 * pair_radius, pair_omega * pair_omega) * pair_growth;
    let pair_breaks_back_guard_rate = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t18 - t19,
        )
        .add_product(
            R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t14 - t15),
            holder_v,
        )
        .add_product(
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                layer_viscosity_times_pair_friction - t20,
            ),
            holder_v_dot,
        ) - t21 + t22;
    let pair_breaks_forth_guard_rate = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t19 + t18,
        )
        .add_product(
            R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15 + t14),
            holder_v,
        )
        .add_product(
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                -layer_viscosity_times_pair_friction - t20,
            ),
            holder_v_dot,
        ) - t21 + t22;
    let pair_ends_back_guard_rate = pair_omega_times_pair_growth
        .add_product(pair_radius, pair_omega_dot);
    let pair_turns_guard_rate = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t19 - t18,
        )
        .add_product(
            R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t15 - t14),
            holder_v,
        )
        .add_product(
            R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                t20 - layer_viscosity_times_pair_friction,
            ),
            holder_v_dot,
        )
        .add_product(
            R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t16),
            pair_growth,
        );
    [
        layer_touches_guard_rate,
        layer_opens_guard_rate,
        R::literal(1.0),
        pair_breaks_back_guard_rate,
        pair_breaks_forth_guard_rate,
        pair_ends_back_guard_rate,
        pair_ends_back_guard_rate,
        pair_omega_dot,
        pair_turns_guard_rate,
    ]
}

/// New values of the states that each event sets, event by event.
///
/// 67 operations.
#[must_use]
pub fn resets<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [holder_x, _, holder_v, pair_omega, _, layer_closed, pair_radius, ..] = *state;
    let drum_speed = p.winding_speed / p.drum_radius;
    let drum_speed_times_time = drum_speed * time;
    let t0 = p.ovality_phase.add_product(R::literal(2.0) * drum_speed, time);
    let [(t1, t2), (sin_drum_speed_times_time, cos_drum_speed_times_time)] = R::sin_cos_each([
        t0,
        drum_speed_times_time,
    ]);
    let pair_growth = R::literal(0.5) * p.pair_thread_area
        / (R::literal(core::f64::consts::PI) * p.pair_package_width) * pair_omega;
    let pair_bobbin_radius_squared = p.pair_bobbin_radius * p.pair_bobbin_radius;
    let pair_radius_squared = pair_radius * pair_radius;
    let pair_inertia = p
        .pair_bobbin_inertia
        .add_product(
            R::literal(core::f64::consts::FRAC_PI_2) * p.pair_package_width
                * p.pair_yarn_density,
            (pair_radius_squared * pair_radius_squared)
                .sub_product(pair_bobbin_radius_squared, pair_bobbin_radius_squared),
        );
    let shape = (p.eccentricity * cos_drum_speed_times_time).add_product(p.ovality, t2);
    let layer_compression = shape - holder_x;
    let shape_rate = (-(p.eccentricity * drum_speed * sin_drum_speed_times_time))
        .sub_product(R::literal(2.0) * p.ovality * drum_speed, t1);
    let layer_compression_rate = shape_rate - holder_v;
    let layer_push = p
        .holder_preload
        .add_product(p.layer_stiffness, layer_compression)
        .add_product(
            p.layer_cubic_stiffness,
            layer_compression * layer_compression * layer_compression,
        )
        .add_product(p.layer_viscosity, layer_compression_rate);
    let pair_friction_times_layer_push = p.pair_friction * layer_push;
    let pair_limit = R::select_less(
        layer_closed,
        R::literal(0.5),
        R::literal(0.0),
        pair_friction_times_layer_push,
    );
    let t3 = (p.pair_support_arm + p.pair_rolling_arm) * layer_push / pair_radius;
    let pair_resistance = p.pair_tension
        + R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t3);
    let t4 = pair_omega * pair_growth * pair_inertia / pair_radius_squared;
    let pair_held = pair_resistance - t4;
    let t5 = R::select_less(
        p.pair_tension
            + R::select_less(
                layer_closed,
                R::literal(0.5),
                R::literal(0.0),
                pair_friction_times_layer_push + t3,
            ) - t4,
        R::literal(0.0),
        R::literal(-1.0),
        R::literal(1.0),
    );
    let t6 = R::select_less(
        pair_limit - pair_held,
        R::literal(0.0),
        R::literal(-1.0),
        R::literal(1.0),
    );
    let pair_slip_after_pair_begins = R::literal(0.5) * (t6 - t5);
    let pair_omega_after_pair_ends_back = p.winding_speed / pair_radius;
    let pair_slip_after_pair_ends_back = R::literal(0.5) * (R::literal(1.0) - t5);
    let pair_slip_after_pair_ends_forth = R::literal(0.5) * (t6 - R::literal(1.0));
    [
        R::literal(1.0),
        R::literal(0.0),
        layer_compression,
        pair_slip_after_pair_begins,
        R::literal(-1.0),
        R::literal(1.0),
        pair_omega_after_pair_ends_back,
        pair_slip_after_pair_ends_back,
        pair_omega_after_pair_ends_back,
        pair_slip_after_pair_ends_forth,
        R::literal(0.0),
        R::literal(-2.0),
        R::literal(-1.0),
    ]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 149 recurrences. 19 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, _) = Lanes::<R, 3>::new(workspace, coefficients.len());
    let [holder_x, pair_phi, holder_v, pair_omega, layer_surface, layer_closed,
    pair_radius, pair_slip] = *state;
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
    let t44 = -t41;
    let shape_rate = t44 - t43;
    let layer_compression_rate = shape_rate - holder_v;
    let t45 = layer_compression * p.layer_stiffness;
    let t46 = layer_compression * layer_compression;
    let t47 = t46 * layer_compression;
    let t48 = t47 * p.layer_cubic_stiffness;
    let t49 = layer_compression_rate * p.layer_viscosity;
    let t50 = p.holder_preload + t45;
    let t51 = t50 + t48;
    let layer_push = t51 + t49;
    let t52 = layer_push * p.pair_friction;
    let pair_limit = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t52);
    let t53 = p.pair_support_arm + p.pair_rolling_arm;
    let t54 = layer_push * t53;
    let t55 = t54 / pair_radius;
    let t56 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t55);
    let pair_resistance = p.pair_tension + t56;
    let t57 = pair_omega * pair_growth;
    let t58 = t57 * pair_inertia;
    let t59 = t58 / t9;
    let pair_held = pair_resistance - t59;
    let t60 = -t52;
    let t61 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t60);
    let t62 = R::select_less(pair_slip, R::literal(0.5), pair_held, t61);
    let pair_carried = R::select_less(pair_slip, R::literal(-0.5), pair_limit, t62);
    let t63 = R::literal(1.0) / holder_mass;
    let t64 = R::literal(1.0) / pair_inertia;
    let t65 = p.pair_yarn_density * p.pair_thread_area;
    let t66 = holder_v * t65;
    let t67 = t66 * pair_omega;
    let t68 = t67 * pair_radius;
    let t69 = holder_x * p.holder_stiffness;
    let t70 = -p.holder_preload;
    let t71 = t70 - t45;
    let t72 = t71 - t48;
    let t73 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t72);
    let t74 = p.holder_preload + t69;
    let t75 = t74 + t73;
    let t76 = R::select_less(layer_closed, R::literal(0.5), R::literal(0.0), t49);
    let t77 = force + t76;
    let t78 = t77 - t68;
    let t79 = t78 - t75;
    let t80 = pair_carried - pair_resistance;
    let t81 = pair_radius * t80;
    let t82 = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t81);
    let pair_omega_dot = t82 * t64;
    let holder_v_dot = t79 * t63;
    let t83 = R::literal(1.0) / p.layer_viscosity;
    let t84 = layer_swelling * t83;
    let t85 = -t84;
    let layer_surface_dot = R::select_less(
        layer_closed,
        R::literal(0.5),
        t85,
        layer_compression_rate,
    );
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
    let mut rates = [
        holder_v,
        pair_omega,
        holder_v_dot,
        pair_omega_dot,
        layer_surface_dot,
        R::literal(0.0),
        pair_growth,
        R::literal(0.0),
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [holder_x_k, pair_phi_k, holder_v_k, pair_omega_k, layer_surface_k, _,
        pair_radius_k, ..] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let t1_k = (layer_surface + layer_surface).mul_add(layer_surface_k, sums[0]);
        let t2_k = layer_surface.mul_add(t1_k, t1.mul_add(layer_surface_k, sums[2]));
        let layer_swelling_k = t2_k
            .mul_add(p.layer_cubic_stiffness, layer_surface_k * p.layer_stiffness);
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
        let t41_k = t33_k * t40;
        let t44_k = -t41_k;
        let shape_rate_k = (-t36_k).mul_add(t42, t44_k);
        let layer_compression_rate_k = shape_rate_k - holder_v_k;
        let t45_k = layer_compression_k * p.layer_stiffness;
        let t46_k = (layer_compression + layer_compression)
            .mul_add(layer_compression_k, sums_2[1]);
        let t47_k = layer_compression
            .mul_add(t46_k, t46.mul_add(layer_compression_k, sums_2[2]));
        let t48_k = t47_k * p.layer_cubic_stiffness;
        let t49_k = layer_compression_rate_k * p.layer_viscosity;
        let t51_k = t45_k + t48_k;
        let layer_push_k = t51_k + t49_k;
        let t52_k = layer_push_k * p.pair_friction;
        let pair_limit_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t52_k,
        );
        let t54_k = layer_push_k * t53;
        let t55_k = (-pair_radius_k).mul_add(t55, t54_k - sums_3[3])
            * inverse_pair_radius;
        let t56_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t55_k,
        );
        let t57_k = pair_omega
            .mul_add(pair_growth_k, pair_growth.mul_add(pair_omega_k, sums_1[0]));
        let t58_k = t57.mul_add(t13_k * t16, pair_inertia.mul_add(t57_k, sums_2[3]));
        let t59_k = (-t9_k).mul_add(t59, t58_k - sums_3[2]) * inverse_t9;
        let pair_held_k = t56_k - t59_k;
        let t60_k = -t52_k;
        let t61_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t60_k,
        );
        let t62_k = R::select_less(pair_slip, R::literal(0.5), pair_held_k, t61_k);
        let pair_carried_k = R::select_less(
            pair_slip,
            R::literal(-0.5),
            pair_limit_k,
            t62_k,
        );
        let t63_k = -t9_k * t11.mul_add(t63, sums_3[0]) * inverse_holder_mass;
        let t64_k = -t13_k * t16.mul_add(t64, sums_3[1]) * inverse_pair_inertia;
        let t66_k = holder_v_k * t65;
        let t67_k = pair_omega.mul_add(t66_k, t66.mul_add(pair_omega_k, sums_1[1]));
        let t68_k = pair_radius.mul_add(t67_k, t67.mul_add(pair_radius_k, sums_2[0]));
        let t71_k = -t45_k;
        let t72_k = t71_k - t48_k;
        let t73_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t72_k,
        );
        let t75_k = holder_x_k * p.holder_stiffness + t73_k;
        let t76_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            R::literal(0.0),
            t49_k,
        );
        let t77_k = force_k + t76_k;
        let t78_k = t77_k - t68_k;
        let t79_k = t78_k - t75_k;
        let t80_k = pair_carried_k - t56_k;
        let t81_k = pair_radius.mul_add(t80_k, t80.mul_add(pair_radius_k, sums_4[1]));
        let t82_k = R::select_less(pair_slip, R::literal(-1.5), R::literal(0.0), t81_k);
        let pair_omega_dot_k = t64.mul_add(t82_k, t82.mul_add(t64_k, sums_4[2]));
        let holder_v_dot_k = t63.mul_add(t79_k, t79.mul_add(t63_k, sums_4[0]));
        let t84_k = layer_swelling_k * t83;
        let t85_k = -t84_k;
        let layer_surface_dot_k = R::select_less(
            layer_closed,
            R::literal(0.5),
            t85_k,
            layer_compression_rate_k,
        );
        lanes
            .set(
                order,
                [layer_surface_k, pair_radius_k, layer_surface_k, t9_k],
                [layer_surface_k, pair_radius_k, t1_k, t9_k],
            );
        lanes_1
            .set(
                order,
                [pair_omega_k, pair_omega_k, k * pair_phi_k, k * pair_phi_k],
                [pair_growth_k, t66_k, t25_k, t24_k],
            );
        lanes_2
            .set(
                order,
                [pair_radius_k, layer_compression_k, layer_compression_k, t13_k * t16],
                [t67_k, layer_compression_k, t46_k, t57_k],
            );
        lanes_3
            .set(
                order,
                [t9_k * t11, t13_k * t16, t9_k, pair_radius_k],
                [t63_k, t64_k, t59_k, t55_k],
            );
        lanes_4.set(order, [t63_k, pair_radius_k, t64_k], [t79_k, t80_k, t82_k]);
        t20_before = t20_k;
        t21_before = t21_k;
        t33_before = t33_k;
        t34_before = t34_k;
        t36_before = t36_k;
        t37_before = t37_k;
        rates = [
            holder_v_k,
            pair_omega_k,
            holder_v_dot_k,
            pair_omega_dot_k,
            layer_surface_dot_k,
            R::literal(0.0),
            pair_growth_k,
            R::literal(0.0),
        ];
    }
}

impl<R: Real> TaylorSeries<R> for WinderFull {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 3>::workspace(order + 1)
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

impl Describe for WinderFull {
    fn name(&self) -> &'static str {
        "winder_full"
    }
    fn title(&self) -> &'static str {
        "Bobbin on a winding drum, all nonlinearities"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
            first_order: 4,
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
    fn events(&self) -> usize {
        EVENTS
    }
    fn event(&self, index: usize) -> Event<'_> {
        EVENT_SHAPES[index]
    }
    fn is_mode(&self, index: usize) -> bool {
        matches!(index, 5 | 7)
    }
}

impl<R: Real> Simulator<R> for WinderFull {
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
    fn guards(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guards(time, state_of(state), &parameters_of(parameters));
    }
    fn guard_rates(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guard_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn resets(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = resets(time, state_of(state), &parameters_of(parameters));
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
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
        name: "pair.phi",
        unit: "rad",
        doc: "angle of the package",
    },
    Quantity {
        name: "holder.v",
        unit: "m/s",
        doc: "rate of deflection of the bobbin's centre",
    },
    Quantity {
        name: "pair.omega",
        unit: "rad/s",
        doc: "rate of angle of the package",
    },
    Quantity {
        name: "layer.surface",
        unit: "m",
        doc: "s, compression of the layer beyond that at rest, while nothing touches it",
    },
    Quantity {
        name: "layer.closed",
        unit: "1",
        doc: "1 while bobbin and drum touch",
    },
    Quantity {
        name: "pair.radius",
        unit: "m",
        doc: "R, radius of the package",
    },
    Quantity {
        name: "pair.slip",
        unit: "1",
        doc: "-1 while the package lags behind the drum, 0 while it sticks to it, 1 while it runs ahead; -2 while it stands still",
    },
];

static STATE_SCALES: [f64; STATES] = [0.001, 1.0, 0.1, 100.0, 0.001, 1.0, 0.03, 1.0];

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
        name: "holder.stiffness",
        unit: "N/m",
        doc: "c_p, spring of the holder, reduced to the bobbin's centre",
    },
    Quantity {
        name: "holder.preload",
        unit: "N",
        doc: "N0, pressure at rest",
    },
    Quantity {
        name: "layer.stiffness",
        unit: "N/m",
        doc: "c, stiffness of the layer",
    },
    Quantity {
        name: "layer.cubic_stiffness",
        unit: "N/m^3",
        doc: "c3, stiffening of the layer: a fifth of the stiffness at 2 mm",
    },
    Quantity {
        name: "layer.viscosity",
        unit: "N s/m",
        doc: "h, viscosity of the layer, above zero",
    },
    Quantity {
        name: "pair.bobbin_radius",
        unit: "m",
        doc: "Rmin, radius of the empty bobbin",
    },
    Quantity {
        name: "pair.package_radius",
        unit: "m",
        doc: "radius of the package at the start",
    },
    Quantity {
        name: "pair.package_width",
        unit: "m",
        doc: "H, width of the package",
    },
    Quantity {
        name: "pair.yarn_density",
        unit: "kg/m^3",
        doc: "rho, density of the wound yarn",
    },
    Quantity {
        name: "pair.thread_area",
        unit: "m^2",
        doc: "volume that a length of thread takes up on the package: that of 20 tex",
    },
    Quantity {
        name: "pair.bobbin_inertia",
        unit: "kg m^2",
        doc: "moment of inertia of the empty bobbin",
    },
    Quantity {
        name: "pair.tension",
        unit: "N",
        doc: "Pn, tension of the thread",
    },
    Quantity {
        name: "pair.friction",
        unit: "1",
        doc: "f, between drum and package",
    },
    Quantity {
        name: "pair.support_arm",
        unit: "m",
        doc: "fa r, friction of the support times its radius",
    },
    Quantity {
        name: "pair.rolling_arm",
        unit: "m",
        doc: "k, arm of rolling friction",
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
    3800.0,
    40.0,
    42000.0,
    2e9,
    95.0,
    0.03,
    0.03,
    0.15,
    350.0,
    5.7e-8,
    0.0006,
    0.6,
    0.18,
    0.0004,
    0.0006,
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
        doc: "N, force of the layer on the bobbin",
    },
    Quantity {
        name: "mass",
        unit: "kg",
        doc: "reduced mass m(R)",
    },
    Quantity {
        name: "radius",
        unit: "m",
        doc: "R, radius of the package",
    },
    Quantity {
        name: "friction",
        unit: "N",
        doc: "friction of the drum on the package",
    },
    Quantity {
        name: "slip",
        unit: "1",
        doc: "nu, share by which the package lags behind the drum",
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
    method: "dop853",
};

/// What happens where guards pass zero.
pub static EVENT_SHAPES: [Event<'static>; EVENTS] = [
    Event {
        name: "layer.touches",
        doc: "the bobbin is back on the layer",
        direction: Direction::Rising,
        when: &[(5, 0.0)],
        sets: &[5],
    },
    Event {
        name: "layer.opens",
        doc: "the layer would pull",
        direction: Direction::Falling,
        when: &[(5, 1.0)],
        sets: &[5, 4],
    },
    Event {
        name: "pair.begins",
        doc: "at the start: whether friction suffices",
        direction: Direction::Rising,
        when: &[(7, 0.0)],
        sets: &[7],
    },
    Event {
        name: "pair.breaks_back",
        doc: "friction suffices no longer: the package lags behind",
        direction: Direction::Rising,
        when: &[(7, 0.0)],
        sets: &[7],
    },
    Event {
        name: "pair.breaks_forth",
        doc: "friction suffices no longer: the package runs ahead",
        direction: Direction::Falling,
        when: &[(7, 0.0)],
        sets: &[7],
    },
    Event {
        name: "pair.ends_back",
        doc: "the package has caught up; it sticks or runs ahead",
        direction: Direction::Rising,
        when: &[(7, -1.0)],
        sets: &[3, 7],
    },
    Event {
        name: "pair.ends_forth",
        doc: "the drum has caught up; the package sticks or lags behind",
        direction: Direction::Falling,
        when: &[(7, 1.0)],
        sets: &[3, 7],
    },
    Event {
        name: "pair.halts",
        doc: "friction cannot turn the package, which stands still",
        direction: Direction::Falling,
        when: &[(7, -1.0)],
        sets: &[3, 7],
    },
    Event {
        name: "pair.turns",
        doc: "friction turns the package again",
        direction: Direction::Rising,
        when: &[(7, -2.0)],
        sets: &[7],
    },
];

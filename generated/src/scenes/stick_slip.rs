// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   7ee56fac13a56f78010ffbda1f3894ebadc8339c745559a1b70e8474d678cffa  scenes/stick_slip.toml
//   5b3244c57f4d1dbb61079010ff55f963cd6a840d5699446256cf1527699ef805  units/friction_slider.toml
//
// Stick-slip oscillation on a belt
//
// The belt takes the mass along until the spring is stronger than static friction; then it
// slides back, and sticks again.
//
// Source:
//   Textbook; without the Stribeck term the cycle is in closed form.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        1
//   states                    3
//   parameters               10
//   outputs                   4
//   discontinuities           0
//   events                    6
//
// State:
//     0  slider.x     [m]    deflection of the spring
//     1  slider.v     [m/s]  rate of deflection of the spring
//     2  slider.slip  [1]    -1 while the mass slides back on the belt, 0 while it sticks, 1 while it slides forth
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             4 of 3 by 3
//   parameter_jacobian        8 of 3 by 10
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     18
//   mass_matrix               0
//   forcing                  16
//   rate_jacobian            26
//   parameter_jacobian       58
//   time_derivative           0
//   outputs                  15
//   energy                    6
//   power_balance            25
//   guards                    9
//   guard_rates              21
//   resets                   12
// With constants of the parameters, prepared once a run:
//   prepare                   4
//   prepared_rate            16
//   prepared_rate_jacobian   22

use ::machinist_contract::{
    Describe, Direction, Event, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 10;

/// Wanted outputs.
pub const OUTPUTS: usize = 4;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Events.
pub const EVENTS: usize = 6;

/// States that events set, those of all events.
pub const RESETS: usize = 8;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 1), (1, 0), (1, 1), (1, 2)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 10,
    entries: &[(1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 6), (1, 7), (1, 8)],
};

/// Stick-slip oscillation on a belt
///
/// The belt takes the mass along until the spring is stronger than static friction; then it
/// slides back, and sticks again.
///
/// Source: Textbook; without the Stribeck term the cycle is in closed form.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StickSlip;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// belt_speed: speed of the belt \[m/s\]. In the spec: 0.1.
    pub belt_speed: R,
    /// slider.mass: the mass \[kg\]. In the spec: 1.0.
    pub slider_mass: R,
    /// slider.stiffness: spring \[N/m\]. In the spec: 400.0.
    pub slider_stiffness: R,
    /// slider.damping: damper beside the spring \[N s/m\]. In the spec: 0.0.
    pub slider_damping: R,
    /// slider.normal_force: force that presses the mass on the belt \[N\]. In the spec: 10.0.
    pub slider_normal_force: R,
    /// slider.static_friction: largest friction while it sticks, over the normal force \[1\]. In the spec: 0.4.
    pub slider_static_friction: R,
    /// slider.kinetic_friction: friction at high sliding speed, likewise \[1\]. In the spec: 0.25.
    pub slider_kinetic_friction: R,
    /// slider.stribeck_friction: by how much it is larger at low sliding speed, likewise \[1\]. In the spec: 0.1.
    pub slider_stribeck_friction: R,
    /// slider.stribeck_speed: sliding speed over which that falls \[m/s\]. In the spec: 0.05.
    pub slider_stribeck_speed: R,
    /// slider.sticking_speed: faster than that it cannot stick \[m/s\]. In the spec: 1e-6.
    pub slider_sticking_speed: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            belt_speed: values[0],
            slider_mass: values[1],
            slider_stiffness: values[2],
            slider_damping: values[3],
            slider_normal_force: values[4],
            slider_static_friction: values[5],
            slider_kinetic_friction: values[6],
            slider_stribeck_friction: values[7],
            slider_stribeck_speed: values[8],
            slider_sticking_speed: values[9],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.belt_speed,
            self.slider_mass,
            self.slider_stiffness,
            self.slider_damping,
            self.slider_normal_force,
            self.slider_static_friction,
            self.slider_kinetic_friction,
            self.slider_stribeck_friction,
            self.slider_stribeck_speed,
            self.slider_sticking_speed,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            belt_speed: R::literal(0.1),
            slider_mass: R::literal(1.0),
            slider_stiffness: R::literal(400.0),
            slider_damping: R::literal(0.0),
            slider_normal_force: R::literal(10.0),
            slider_static_friction: R::literal(0.4),
            slider_kinetic_friction: R::literal(0.25),
            slider_stribeck_friction: R::literal(0.1),
            slider_stribeck_speed: R::literal(0.05),
            slider_sticking_speed: R::literal(1e-6),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// deflection: deflection of the spring \[m\].
    pub deflection: R,
    /// velocity: rate of deflection of the spring \[m/s\].
    pub velocity: R,
    /// friction: friction on the mass \[N\].
    pub friction: R,
    /// slip: \-1 while the mass slides back on the belt, 0 while it sticks, 1 while it slides forth \[1\].
    pub slip: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            deflection: values[0],
            velocity: values[1],
            friction: values[2],
            slip: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.deflection, self.velocity, self.friction, self.slip]
    }
}

/// Where to find what in the state.
pub mod state {
    /// slider.x: deflection of the spring \[m\].
    pub const SLIDER_X: usize = 0;
    /// slider.v: rate of deflection of the spring \[m/s\].
    pub const SLIDER_V: usize = 1;
    /// slider.slip: \-1 while the mass slides back on the belt, 0 while it sticks, 1 while it slides forth \[1\].
    pub const SLIDER_SLIP: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 3;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_slider_stribeck_speed: R,
    pub inverse_slider_mass: R,
    pub t0: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_slider_stribeck_speed: values[0],
            inverse_slider_mass: values[1],
            t0: values[2],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [self.inverse_slider_stribeck_speed, self.inverse_slider_mass, self.t0]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_slider_stribeck_speed = R::literal(1.0) / p.slider_stribeck_speed;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let t0 = p.slider_normal_force * p.slider_stribeck_friction
        / p.slider_stribeck_speed;
    Constants {
        inverse_slider_stribeck_speed,
        inverse_slider_mass,
        t0,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), p.belt_speed, R::literal(0.0)]
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
/// 18 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 16 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(c.inverse_slider_stribeck_speed * slider_slip * slider_sliding)).exp(),
            );
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    let slider_v_dot = (slider_friction - slider_held) * c.inverse_slider_mass;
    [slider_v, slider_v_dot, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 1] {
    [p.slider_mass]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 16 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_slip
                    * slider_sliding))
                    .exp(),
            );
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    let slider_x_forcing = slider_friction - slider_held;
    [slider_x_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 26 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 4] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 22 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 4] {
    let [_, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let t0 = (-(c.inverse_slider_stribeck_speed * slider_slip * slider_sliding)).exp();
    let slider_v_dot_by_slider_x = (R::select_less(
        slider_slip,
        R::literal(-0.5),
        R::literal(0.0),
        R::select_less(slider_slip, R::literal(0.5), p.slider_stiffness, R::literal(0.0)),
    ) - p.slider_stiffness) * c.inverse_slider_mass;
    let t1 = c.t0 * slider_slip * t0;
    let slider_v_dot_by_slider_v = (R::select_less(
        slider_slip,
        R::literal(-0.5),
        -t1,
        R::select_less(slider_slip, R::literal(0.5), p.slider_damping, t1),
    ) - p.slider_damping) * c.inverse_slider_mass;
    let t2 = c.t0 * slider_sliding * t0;
    let slider_v_dot_by_slider_slip = R::select_less(
        slider_slip,
        R::literal(-0.5),
        -t2,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), t2),
    ) * c.inverse_slider_mass;
    [
        R::literal(1.0),
        slider_v_dot_by_slider_x,
        slider_v_dot_by_slider_v,
        slider_v_dot_by_slider_slip,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 58 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 8] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let t0 = (-(R::literal(1.0) / p.slider_stribeck_speed * slider_slip
        * slider_sliding))
        .exp();
    let t1 = p.slider_kinetic_friction.add_product(p.slider_stribeck_friction, t0);
    let slider_dragged = p.slider_normal_force * t1;
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let slider_v_dot = (slider_friction - slider_held) * inverse_slider_mass;
    let t2 = p.slider_normal_force * p.slider_stribeck_friction;
    let t3 = t2 / p.slider_stribeck_speed * slider_slip * t0;
    let slider_v_dot_by_belt_speed = R::select_less(
        slider_slip,
        R::literal(-0.5),
        t3,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t3),
    ) * inverse_slider_mass;
    let slider_v_dot_by_slider_mass = -(slider_v_dot * inverse_slider_mass);
    let slider_v_dot_by_slider_stiffness = (R::select_less(
        slider_slip,
        R::literal(-0.5),
        R::literal(0.0),
        R::select_less(slider_slip, R::literal(0.5), slider_x, R::literal(0.0)),
    ) - slider_x) * inverse_slider_mass;
    let slider_v_dot_by_slider_damping = (R::select_less(
        slider_slip,
        R::literal(-0.5),
        R::literal(0.0),
        R::select_less(slider_slip, R::literal(0.5), slider_v, R::literal(0.0)),
    ) - slider_v) * inverse_slider_mass;
    let slider_v_dot_by_slider_normal_force = R::select_less(
        slider_slip,
        R::literal(-0.5),
        t1,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t1),
    ) * inverse_slider_mass;
    let slider_v_dot_by_slider_kinetic_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        p.slider_normal_force,
        R::select_less(
            slider_slip,
            R::literal(0.5),
            R::literal(0.0),
            -p.slider_normal_force,
        ),
    ) * inverse_slider_mass;
    let t4 = p.slider_normal_force * t0;
    let slider_v_dot_by_slider_stribeck_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        t4,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t4),
    ) * inverse_slider_mass;
    let t5 = t2 / (p.slider_stribeck_speed * p.slider_stribeck_speed) * slider_slip
        * slider_sliding * t0;
    let slider_v_dot_by_slider_stribeck_speed = R::select_less(
        slider_slip,
        R::literal(-0.5),
        t5,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t5),
    ) * inverse_slider_mass;
    [
        slider_v_dot_by_belt_speed,
        slider_v_dot_by_slider_mass,
        slider_v_dot_by_slider_stiffness,
        slider_v_dot_by_slider_damping,
        slider_v_dot_by_slider_normal_force,
        slider_v_dot_by_slider_kinetic_friction,
        slider_v_dot_by_slider_stribeck_friction,
        slider_v_dot_by_slider_stribeck_speed,
    ]
}

/// Partial derivative of `y'` with respect to time.
///
/// No operations.
#[must_use]
pub fn time_derivative<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// 15 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_slip
                    * slider_sliding))
                    .exp(),
            );
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    Outputs {
        deflection: slider_x,
        velocity: slider_v,
        friction: slider_friction,
        slip: slider_slip,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 6 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [slider_x, slider_v, ..] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.slider_mass * (slider_v * slider_v),
        potential: R::literal(0.5) * p.slider_stiffness * (slider_x * slider_x),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 25 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_stiffness_times_slider_x = p.slider_stiffness * slider_x;
    let slider_held = slider_stiffness_times_slider_x
        .add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_slip
                    * slider_sliding))
                    .exp(),
            );
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    let slider_v_dot = (slider_friction - slider_held)
        * (R::literal(1.0) / p.slider_mass);
    PowerBalance {
        stored_rate: (slider_stiffness_times_slider_x * slider_v)
            .add_product(p.slider_mass * slider_v, slider_v_dot),
        supplied: slider_v * slider_friction,
        dissipated: p.slider_damping * (slider_v * slider_v),
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 9 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [slider_x, slider_v, ..] = *state;
    let slider_limit = p.slider_normal_force * p.slider_static_friction;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_breaks_back_guard = slider_held - slider_limit;
    let slider_breaks_forth_guard = slider_limit + slider_held;
    let slider_thrown_back_guard = p.slider_sticking_speed + slider_sliding;
    let slider_thrown_forth_guard = slider_sliding - p.slider_sticking_speed;
    [
        slider_breaks_back_guard,
        slider_breaks_forth_guard,
        slider_thrown_back_guard,
        slider_thrown_forth_guard,
        slider_sliding,
        slider_sliding,
    ]
}

/// `dg/dt` of the guards along the motion.
///
/// 21 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_slip
                    * slider_sliding))
                    .exp(),
            );
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged),
    );
    let slider_v_dot = (slider_friction - slider_held)
        * (R::literal(1.0) / p.slider_mass);
    let slider_breaks_back_guard_rate = (p.slider_stiffness * slider_v)
        .add_product(p.slider_damping, slider_v_dot);
    [
        slider_breaks_back_guard_rate,
        slider_breaks_back_guard_rate,
        slider_v_dot,
        slider_v_dot,
        slider_v_dot,
        slider_v_dot,
    ]
}

/// New values of the states that each event sets, event by event.
///
/// 12 operations.
#[must_use]
pub fn resets<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [slider_x, slider_v, ..] = *state;
    let slider_limit = p.slider_normal_force * p.slider_static_friction;
    let slider_held = (p.slider_stiffness * slider_x)
        .add_product(p.slider_damping, slider_v);
    let slider_slip_after_slider_ends_back = R::literal(0.5)
        * (R::literal(1.0)
            - R::select_less(
                slider_limit + slider_held,
                R::literal(0.0),
                R::literal(-1.0),
                R::literal(1.0),
            ));
    let slider_slip_after_slider_ends_forth = R::literal(0.5)
        * (R::select_less(
            slider_limit - slider_held,
            R::literal(0.0),
            R::literal(-1.0),
            R::literal(1.0),
        ) - R::literal(1.0));
    [
        R::literal(-1.0),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(1.0),
        p.belt_speed,
        slider_slip_after_slider_ends_back,
        p.belt_speed,
        slider_slip_after_slider_ends_forth,
    ]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 33 recurrences. 2 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, _) = Lanes::<R, 2>::new(workspace, coefficients.len());
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let t0 = slider_x * p.slider_stiffness;
    let t1 = slider_v * p.slider_damping;
    let slider_held = t0 + t1;
    let t2 = R::literal(1.0) / p.slider_stribeck_speed;
    let t3 = slider_slip * t2;
    let t4 = t3 * slider_sliding;
    let t5 = -t4;
    let t6 = t5.exp();
    let t7 = t6 * p.slider_stribeck_friction;
    let t8 = p.slider_kinetic_friction + t7;
    let slider_dragged = t8 * p.slider_normal_force;
    let t9 = -slider_dragged;
    let t10 = R::select_less(slider_slip, R::literal(0.5), slider_held, t9);
    let slider_friction = R::select_less(
        slider_slip,
        R::literal(-0.5),
        slider_dragged,
        t10,
    );
    let t11 = R::literal(1.0) / p.slider_mass;
    let t12 = slider_friction - slider_held;
    let slider_v_dot = t12 * t11;
    let mut rates = [slider_v, slider_v_dot, R::literal(0.0)];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [slider_x_k, slider_v_k, slider_slip_k] = *state_k;
        let sums = lanes.sums(order);
        let slider_held_k = slider_v_k
            .mul_add(p.slider_damping, slider_x_k * p.slider_stiffness);
        let t3_k = slider_slip_k * t2;
        let t4_k = t3.mul_add(slider_v_k, slider_sliding.mul_add(t3_k, sums[0]));
        let t5_k = -t4_k;
        let t6_k = t5_k.mul_add(t6, inverse * sums[1]);
        let slider_dragged_k = t6_k * p.slider_stribeck_friction * p.slider_normal_force;
        let t9_k = -slider_dragged_k;
        let t10_k = R::select_less(slider_slip, R::literal(0.5), slider_held_k, t9_k);
        let slider_friction_k = R::select_less(
            slider_slip,
            R::literal(-0.5),
            slider_dragged_k,
            t10_k,
        );
        let t12_k = slider_friction_k - slider_held_k;
        let slider_v_dot_k = t12_k * t11;
        lanes.set(order, [slider_v_k, k * t5_k], [t3_k, t6_k]);
        rates = [slider_v_k, slider_v_dot_k, R::literal(0.0)];
    }
}

impl<R: Real> TaylorSeries<R> for StickSlip {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 2>::workspace(order + 1)
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
    fn bends(&self) -> Bends {
        Bends::Saturates
    }
}

impl Describe for StickSlip {
    fn name(&self) -> &'static str {
        "stick_slip"
    }
    fn title(&self) -> &'static str {
        "Stick-slip oscillation on a belt"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 1,
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
        matches!(index, 2)
    }
}

impl<R: Real> Simulator<R> for StickSlip {
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
        name: "slider.x",
        unit: "m",
        doc: "deflection of the spring",
    },
    Quantity {
        name: "slider.v",
        unit: "m/s",
        doc: "rate of deflection of the spring",
    },
    Quantity {
        name: "slider.slip",
        unit: "1",
        doc: "-1 while the mass slides back on the belt, 0 while it sticks, 1 while it slides forth",
    },
];

static STATE_SCALES: [f64; STATES] = [0.01, 0.1, 1.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "belt_speed",
        unit: "m/s",
        doc: "speed of the belt",
    },
    Quantity {
        name: "slider.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "slider.stiffness",
        unit: "N/m",
        doc: "spring",
    },
    Quantity {
        name: "slider.damping",
        unit: "N s/m",
        doc: "damper beside the spring",
    },
    Quantity {
        name: "slider.normal_force",
        unit: "N",
        doc: "force that presses the mass on the belt",
    },
    Quantity {
        name: "slider.static_friction",
        unit: "1",
        doc: "largest friction while it sticks, over the normal force",
    },
    Quantity {
        name: "slider.kinetic_friction",
        unit: "1",
        doc: "friction at high sliding speed, likewise",
    },
    Quantity {
        name: "slider.stribeck_friction",
        unit: "1",
        doc: "by how much it is larger at low sliding speed, likewise",
    },
    Quantity {
        name: "slider.stribeck_speed",
        unit: "m/s",
        doc: "sliding speed over which that falls",
    },
    Quantity {
        name: "slider.sticking_speed",
        unit: "m/s",
        doc: "faster than that it cannot stick",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.1,
    1.0,
    400.0,
    0.0,
    10.0,
    0.4,
    0.25,
    0.1,
    0.05,
    1e-6,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "deflection",
        unit: "m",
        doc: "deflection of the spring",
    },
    Quantity {
        name: "velocity",
        unit: "m/s",
        doc: "rate of deflection of the spring",
    },
    Quantity {
        name: "friction",
        unit: "N",
        doc: "friction on the mass",
    },
    Quantity {
        name: "slip",
        unit: "1",
        doc: "-1 while the mass slides back on the belt, 0 while it sticks, 1 while it slides forth",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 2001,
    rtol: 1e-8,
    method: "dop853",
};

/// What happens where guards pass zero.
pub static EVENT_SHAPES: [Event<'static>; EVENTS] = [
    Event {
        name: "slider.breaks_back",
        doc: "friction holds no longer: the mass slides back",
        direction: Direction::Rising,
        when: &[(2, 0.0)],
        sets: &[2],
    },
    Event {
        name: "slider.breaks_forth",
        doc: "friction holds no longer: the mass slides forth",
        direction: Direction::Falling,
        when: &[(2, 0.0)],
        sets: &[2],
    },
    Event {
        name: "slider.thrown_back",
        doc: "it slides back, and cannot stick",
        direction: Direction::Falling,
        when: &[(2, 0.0)],
        sets: &[2],
    },
    Event {
        name: "slider.thrown_forth",
        doc: "it slides forth, and cannot stick",
        direction: Direction::Rising,
        when: &[(2, 0.0)],
        sets: &[2],
    },
    Event {
        name: "slider.ends_back",
        doc: "the mass has slid back; it sticks or slides forth",
        direction: Direction::Rising,
        when: &[(2, -1.0)],
        sets: &[1, 2],
    },
    Event {
        name: "slider.ends_forth",
        doc: "the mass has slid forth; it sticks or slides back",
        direction: Direction::Falling,
        when: &[(2, 1.0)],
        sets: &[1, 2],
    },
];

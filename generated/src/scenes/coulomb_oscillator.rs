// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   33ad32c929bed6f6587691d53732075de1dba09d03a141d01d114960e95b60c3  scenes/coulomb_oscillator.toml
//   20a0591abcd3ca69d82a9ebbe1c7481bbac99db97a2ce882f76b3c4ed51aef89  units/friction_slider.toml
//
// Oscillator damped by dry friction
//
// The mass of `stick_slip`, released on a belt at rest. It moves in half cycles about centres offset
// to either side until it sticks.
//
// Source:
//   Textbook; exact half cycle by half cycle.
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 1, states 3, parameters 10, outputs 4, events 6,
//     saturations 1.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 4 of 3 by 3, parameter_jacobian 7 of 3 by 10.
// Operations: rate 16, forcing 14, rate_jacobian 27, parameter_jacobian 50, outputs 13, energy 6,
//     power_balance 23, guards 8, guard_rates 19, resets 12, saturating_arguments 3, prepare 9,
//     prepared_rate 14, prepared_rate_jacobian 22, prepared_jacobians 62.

use ::machinist_contract::{
    Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// Oscillator damped by dry friction
    ///
    /// The mass of \`stick_slip\`, released on a belt at rest. It moves in half cycles about centres offset
    /// to either side until it sticks.
    ///
    /// Source: Textbook; exact half cycle by half cycle.
    CoulombOscillator: "coulomb_oscillator", "Oscillator damped by dry friction";
    run from 0.0, until 2.0, points 2001, rtol 1e-8, method "dop853";
    quadratures 0, discontinuities 0;
    events; prepared; jacobians_at_once; saturations 1; series 2;
}

::machinist_contract::parameters! {
    deflection: 0.097, "m", "deflection", "initial deflection, large enough to slip";
    slider_mass: 1.0, "kg", "slider.mass", "mass";
    slider_stiffness: 400.0, "N/m", "slider.stiffness", "stiffness of the spring";
    slider_damping: 0.0, "N s/m", "slider.damping", "damping";
    slider_normal_force: 10.0, "N", "slider.normal_force", "normal force";
    slider_static_friction: 0.4, "1", "slider.static_friction", "coefficient of static friction";
    slider_kinetic_friction: 0.25, "1", "slider.kinetic_friction", "coefficient of kinetic friction at high sliding speed";
    slider_stribeck_friction: 0.0, "1", "slider.stribeck_friction", "increase of the coefficient at low sliding speed";
    slider_stribeck_speed: 0.05, "m/s", "slider.stribeck_speed", "sliding speed over which the increase decays";
    slider_sticking_speed: 1e-6, "m/s", "slider.sticking_speed", "sliding speed above which the mass cannot stick";
}

::machinist_contract::outputs! {
    deflection: "m", "deflection", "deflection of the spring";
    velocity: "m/s", "velocity", "rate of deflection of the spring";
    friction: "N", "friction", "friction force on the mass";
    slip: "1", "slip", "-1 while the mass slips backward on the belt, 0 while it sticks, 1 while it slips forward" as "slip: \\-1 while the mass slips backward on the belt, 0 while it sticks, 1 while it slips forward \\[1\\].";
}

::machinist_contract::states! {
    SLIDER_X: position, 0.01, "m", "slider.x", "deflection of the spring";
    SLIDER_V: velocity, 0.1, "m/s", "slider.v", "rate of deflection of the spring";
    SLIDER_SLIP: mode, 1.0, "1", "slider.slip", "-1 while the mass slips backward on the belt, 0 while it sticks, 1 while it slips forward" as "slider.slip: \\-1 while the mass slips backward on the belt, 0 while it sticks, 1 while it slips forward \\[1\\].";
}

::machinist_contract::events! {
    "slider.breaks_back": Rising, when [(2, 0.0)], sets [2], "the friction limit is reached: the mass slips backward";
    "slider.breaks_forth": Falling, when [(2, 0.0)], sets [2], "the friction limit is reached: the mass slips forward";
    "slider.thrown_back": Falling, when [(2, 0.0)], sets [2], "the backward speed is too high to stick";
    "slider.thrown_forth": Rising, when [(2, 0.0)], sets [2], "the forward speed is too high to stick";
    "slider.ends_back": Rising moves_guard, when [(2, -1.0)], sets [1, 2], "backward slip ends: the mass sticks or slips forward";
    "slider.ends_forth": Falling moves_guard, when [(2, 1.0)], sets [1, 2], "forward slip ends: the mass sticks or slips backward";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1] 1 [0 1 2] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 10 { 1 [1 2 3 4 6 7 8] }
}

::machinist_contract::constants! {
    t0, inverse_slider_mass, inverse_slider_stribeck_speed, t1, t2, t3, minus_slider_normal_force, t4
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(-1.0) / p.slider_stribeck_speed;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let inverse_slider_stribeck_speed = R::literal(1.0) / p.slider_stribeck_speed;
    let t1 = p.slider_damping * p.slider_stribeck_speed;
    let t2 = p.slider_normal_force * p.slider_stribeck_friction;
    let t3 = t2 / p.slider_stribeck_speed;
    let minus_slider_normal_force = -p.slider_normal_force;
    let t4 = t2 / (p.slider_stribeck_speed * p.slider_stribeck_speed);
    Constants { t0, inverse_slider_mass, inverse_slider_stribeck_speed, t1, t2, t3,
        minus_slider_normal_force, t4 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.deflection, R::literal(0.0), R::literal(-1.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// As `rate`, with the constants of the parameters from `prepare`. 14 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (c.t0 * slider_v * slider_slip).exp());
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    let slider_v_dot = (slider_friction - slider_held) * c.inverse_slider_mass;
    [slider_v, slider_v_dot, R::literal(0.0)]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    [p.slider_mass]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 14 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * slider_v * slider_slip).exp());
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    let slider_x_forcing = slider_friction - slider_held;
    [slider_x_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 22 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 4] {
    let [_, slider_v, slider_slip] = *state;
    let t0 = (-(c.inverse_slider_stribeck_speed * slider_v * slider_slip)).exp();
    let slider_v_dot_by_slider_x = (R::select_less(slider_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(slider_slip, R::literal(0.5), p.slider_stiffness, R::literal(0.0)))
        - p.slider_stiffness) * c.inverse_slider_mass;
    let t1 = c.t2 * slider_slip * t0;
    let slider_v_dot_by_slider_v = c.inverse_slider_stribeck_speed * (R::select_less(slider_slip,
        R::literal(-0.5), -t1, R::select_less(slider_slip, R::literal(0.5), c.t1, t1)) - c.t1)
        * c.inverse_slider_mass;
    let t2 = c.t3 * slider_v * t0;
    let slider_v_dot_by_slider_slip = R::select_less(slider_slip, R::literal(-0.5), -t2,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), t2)) * c.inverse_slider_mass;
    [R::literal(1.0), slider_v_dot_by_slider_x, slider_v_dot_by_slider_v,
        slider_v_dot_by_slider_slip]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 62 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 11] {
    let [slider_x, slider_v, slider_slip] = *state;
    let t0 = (-(c.inverse_slider_stribeck_speed * slider_v * slider_slip)).exp();
    let slider_v_dot_by_slider_x = (R::select_less(slider_slip, R::literal(-0.5), R::literal(0.0),
        R::select_less(slider_slip, R::literal(0.5), p.slider_stiffness, R::literal(0.0)))
        - p.slider_stiffness) * c.inverse_slider_mass;
    let t1 = c.t2 * slider_slip * t0;
    let slider_v_dot_by_slider_v = c.inverse_slider_stribeck_speed * (R::select_less(slider_slip,
        R::literal(-0.5), -t1, R::select_less(slider_slip, R::literal(0.5), c.t1, t1)) - c.t1)
        * c.inverse_slider_mass;
    let t2 = c.t3 * slider_v * t0;
    let slider_v_dot_by_slider_slip = R::select_less(slider_slip, R::literal(-0.5), -t2,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), t2)) * c.inverse_slider_mass;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let t3 = p.slider_kinetic_friction.add_product(p.slider_stribeck_friction, t0);
    let slider_dragged = p.slider_normal_force * t3;
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    let slider_v_dot = (slider_friction - slider_held) * c.inverse_slider_mass;
    let slider_v_dot_by_slider_mass = -(slider_v_dot * c.inverse_slider_mass);
    let slider_v_dot_by_slider_stiffness = (R::select_less(slider_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(slider_slip, R::literal(0.5), slider_x, R::literal(0.0)))
        - slider_x) * c.inverse_slider_mass;
    let slider_v_dot_by_slider_damping = (R::select_less(slider_slip, R::literal(-0.5),
        R::literal(0.0), R::select_less(slider_slip, R::literal(0.5), slider_v, R::literal(0.0)))
        - slider_v) * c.inverse_slider_mass;
    let slider_v_dot_by_slider_normal_force = R::select_less(slider_slip, R::literal(-0.5), t3,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t3)) * c.inverse_slider_mass;
    let slider_v_dot_by_slider_kinetic_friction = R::select_less(slider_slip, R::literal(-0.5),
        p.slider_normal_force, R::select_less(slider_slip, R::literal(0.5), R::literal(0.0),
        c.minus_slider_normal_force)) * c.inverse_slider_mass;
    let t4 = p.slider_normal_force * t0;
    let slider_v_dot_by_slider_stribeck_friction = R::select_less(slider_slip, R::literal(-0.5),
        t4, R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t4))
        * c.inverse_slider_mass;
    let t5 = c.t4 * slider_v * slider_slip * t0;
    let slider_v_dot_by_slider_stribeck_speed = R::select_less(slider_slip, R::literal(-0.5), t5,
        R::select_less(slider_slip, R::literal(0.5), R::literal(0.0), -t5)) * c.inverse_slider_mass;
    [R::literal(1.0), slider_v_dot_by_slider_x, slider_v_dot_by_slider_v,
        slider_v_dot_by_slider_slip, slider_v_dot_by_slider_mass, slider_v_dot_by_slider_stiffness,
        slider_v_dot_by_slider_damping, slider_v_dot_by_slider_normal_force,
        slider_v_dot_by_slider_kinetic_friction, slider_v_dot_by_slider_stribeck_friction,
        slider_v_dot_by_slider_stribeck_speed]
}

/// Partial derivative of `y'` with respect to time. No operations.
#[must_use]
pub fn time_derivative<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. 13 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * slider_v * slider_slip).exp());
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    Outputs {
        deflection: slider_x,
        velocity: slider_v,
        friction: slider_friction,
        slip: slider_slip,
    }
}

/// T, V and the energy of first-order states \[J\]. 6 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [slider_x, slider_v, ..] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.slider_mass * (slider_v * slider_v),
        potential: R::literal(0.5) * p.slider_stiffness * (slider_x * slider_x),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 23 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_stiffness_times_slider_x = p.slider_stiffness * slider_x;
    let slider_held = slider_stiffness_times_slider_x.add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * slider_v * slider_slip).exp());
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    let slider_v_dot = (slider_friction - slider_held) * (R::literal(1.0) / p.slider_mass);
    PowerBalance {
        stored_rate: (slider_stiffness_times_slider_x * slider_v).add_product(p.slider_mass
            * slider_v, slider_v_dot),
        supplied: slider_v * slider_friction,
        dissipated: p.slider_damping * (slider_v * slider_v),
    }
}

/// What passes zero where events happen, one for each event. 8 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [slider_x, slider_v, ..] = *state;
    let slider_limit = p.slider_normal_force * p.slider_static_friction;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_breaks_back_guard = slider_held - slider_limit;
    let slider_breaks_forth_guard = slider_limit + slider_held;
    let slider_thrown_back_guard = p.slider_sticking_speed + slider_v;
    let slider_thrown_forth_guard = slider_v - p.slider_sticking_speed;
    [slider_breaks_back_guard, slider_breaks_forth_guard, slider_thrown_back_guard,
        slider_thrown_forth_guard, slider_v, slider_v]
}

/// `dg/dt` of the guards along the motion. 19 operations.
#[must_use]
pub fn guard_rates<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let [slider_x, slider_v, slider_slip] = *state;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_dragged = p.slider_normal_force * p.slider_kinetic_friction
        .add_product(p.slider_stribeck_friction, (R::literal(-1.0) / p.slider_stribeck_speed
        * slider_v * slider_slip).exp());
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged,
        R::select_less(slider_slip, R::literal(0.5), slider_held, -slider_dragged));
    let slider_v_dot = (slider_friction - slider_held) * (R::literal(1.0) / p.slider_mass);
    let slider_breaks_back_guard_rate = (p.slider_stiffness * slider_v)
        .add_product(p.slider_damping, slider_v_dot);
    [slider_breaks_back_guard_rate, slider_breaks_back_guard_rate, slider_v_dot, slider_v_dot,
        slider_v_dot, slider_v_dot]
}

/// New values of the entries that each event sets, computed from the state before it: those of the
/// first event, in the order of its `sets`, then those of the second, and so on. 12 operations.
#[must_use]
pub fn resets<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; RESETS] {
    let [slider_x, slider_v, ..] = *state;
    let slider_limit = p.slider_normal_force * p.slider_static_friction;
    let slider_held = (p.slider_stiffness * slider_x).add_product(p.slider_damping, slider_v);
    let slider_slip_after_slider_ends_back = R::literal(0.5) * (R::literal(1.0)
        - R::select_less(slider_limit + slider_held, R::literal(0.0), R::literal(-1.0),
        R::literal(1.0)));
    let slider_slip_after_slider_ends_forth = R::literal(0.5) * (R::select_less(slider_limit
        - slider_held, R::literal(0.0), R::literal(-1.0), R::literal(1.0)) - R::literal(1.0));
    [R::literal(-1.0), R::literal(1.0), R::literal(-1.0), R::literal(1.0), R::literal(0.0),
        slider_slip_after_slider_ends_back, R::literal(0.0), slider_slip_after_slider_ends_forth]
}

/// Arguments of functions that are flat far from a place, such as `tanh` far from zero. Steps by
/// series are checked where one passes zero or turns. 3 operations.
#[must_use]
pub fn saturating_arguments<R: Real>(_time: R, state: &[R; STATES],
        p: &Parameters<R>) -> [R; SATURATIONS] {
    let [_, slider_v, slider_slip] = *state;
    let argument_1 = R::literal(1.0) / p.slider_stribeck_speed * slider_v * slider_slip;
    [argument_1]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 31 recurrences. 2 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 2>::new(workspace, coefficients.len());
    let [slider_x, slider_v, slider_slip] = *state;
    let t0 = slider_x * p.slider_stiffness;
    let t1 = slider_v * p.slider_damping;
    let slider_held = t0 + t1;
    let t2 = R::literal(-1.0) / p.slider_stribeck_speed;
    let t3 = slider_v * t2;
    let t4 = t3 * slider_slip;
    let t5 = t4.exp();
    let t6 = t5 * p.slider_stribeck_friction;
    let t7 = p.slider_kinetic_friction + t6;
    let slider_dragged = t7 * p.slider_normal_force;
    let t8 = -slider_dragged;
    let t9 = R::select_less(slider_slip, R::literal(0.5), slider_held, t8);
    let slider_friction = R::select_less(slider_slip, R::literal(-0.5), slider_dragged, t9);
    let t10 = R::literal(1.0) / p.slider_mass;
    let t11 = slider_friction - slider_held;
    let slider_v_dot = t11 * t10;
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
        let slider_held_k = slider_v_k.mul_add(p.slider_damping, slider_x_k * p.slider_stiffness);
        let t3_k = slider_v_k * t2;
        let t4_k = slider_slip.mul_add(t3_k, t3.mul_add(slider_slip_k, sums[0]));
        let t5_k = t4_k.mul_add(t5, inverse * sums[1]);
        let slider_dragged_k = t5_k * p.slider_stribeck_friction * p.slider_normal_force;
        let t8_k = -slider_dragged_k;
        let t9_k = R::select_less(slider_slip, R::literal(0.5), slider_held_k, t8_k);
        let slider_friction_k = R::select_less(slider_slip, R::literal(-0.5), slider_dragged_k,
            t9_k);
        let t11_k = slider_friction_k - slider_held_k;
        let slider_v_dot_k = t11_k * t10;
        lanes.set(order, [slider_slip_k, k * t4_k], [t3_k, t5_k]);
        rates = [slider_v_k, slider_v_dot_k, R::literal(0.0)];
    }
}

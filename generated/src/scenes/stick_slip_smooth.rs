// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   94703e250c053ceb41ccbcc94b23aff9e19d226c6314d4813fa4365e2f34b90a  scenes/stick_slip_smooth.toml
//   d45a9c9f5bba8ff1c3ba8938a6a1e3cfbf1421a3c328f0688da3ea0781bbdd27  units/friction_slider_smooth.toml
//
// Stick-slip oscillation on a belt, smoothed
//
// The smooth twin of `stick_slip`: stiff where the other sticks.
//
// Source:
//   Textbook.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        0
//   states                    2
//   parameters                9
//   outputs                   3
//   discontinuities           0
//
// State:
//     0  slider.x  [m]    deflection of the spring
//     1  slider.v  [m/s]  rate of deflection of the spring
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             3 of 2 by 2
//   parameter_jacobian        9 of 2 by 9
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     20
//   mass_matrix               0
//   forcing                  18
//   rate_jacobian            28
//   parameter_jacobian       61
//   time_derivative           0
//   outputs                  14
//   energy                    6
//   power_balance            28
// With constants of the parameters, prepared once a run:
//   prepare                   7
//   prepared_rate            17
//   prepared_rate_jacobian   21

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 2;

/// Parameters.
pub const PARAMETERS: usize = 9;

/// Wanted outputs.
pub const OUTPUTS: usize = 3;

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
    columns: 9,
    entries: &[(1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (1, 5), (1, 6), (1, 7), (1, 8)],
};

/// Stick-slip oscillation on a belt, smoothed
///
/// The smooth twin of \`stick_slip\`: stiff where the other sticks.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct StickSlipSmooth;

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
    /// slider.kinetic_friction: friction at high sliding speed, likewise \[1\]. In the spec: 0.25.
    pub slider_kinetic_friction: R,
    /// slider.stribeck_friction: by how much it is larger at low sliding speed, likewise \[1\]. In the spec: 0.1.
    pub slider_stribeck_friction: R,
    /// slider.stribeck_speed: sliding speed over which that falls \[m/s\]. In the spec: 0.05.
    pub slider_stribeck_speed: R,
    /// slider.width: sliding speed over which friction changes its direction \[m/s\]. In the spec: 0.001.
    pub slider_width: R,
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
            slider_kinetic_friction: values[5],
            slider_stribeck_friction: values[6],
            slider_stribeck_speed: values[7],
            slider_width: values[8],
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
            self.slider_kinetic_friction,
            self.slider_stribeck_friction,
            self.slider_stribeck_speed,
            self.slider_width,
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
            slider_kinetic_friction: R::literal(0.25),
            slider_stribeck_friction: R::literal(0.1),
            slider_stribeck_speed: R::literal(0.05),
            slider_width: R::literal(0.001),
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
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.deflection, self.velocity, self.friction]
    }
}

/// Where to find what in the state.
pub mod state {
    /// slider.x: deflection of the spring \[m\].
    pub const SLIDER_X: usize = 0;
    /// slider.v: rate of deflection of the spring \[m/s\].
    pub const SLIDER_V: usize = 1;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 5;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_slider_stribeck_speed: R,
    pub inverse_slider_width: R,
    pub inverse_slider_mass: R,
    pub slider_v_dot_by_slider_x: R,
    pub t0: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_slider_stribeck_speed: values[0],
            inverse_slider_width: values[1],
            inverse_slider_mass: values[2],
            slider_v_dot_by_slider_x: values[3],
            t0: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_slider_stribeck_speed,
            self.inverse_slider_width,
            self.inverse_slider_mass,
            self.slider_v_dot_by_slider_x,
            self.t0,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 7 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_slider_stribeck_speed = R::literal(1.0) / p.slider_stribeck_speed;
    let inverse_slider_width = R::literal(1.0) / p.slider_width;
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let slider_v_dot_by_slider_x = -(p.slider_stiffness * inverse_slider_mass);
    let t0 = p.slider_normal_force * p.slider_stribeck_friction
        / p.slider_stribeck_speed;
    Constants {
        inverse_slider_stribeck_speed,
        inverse_slider_width,
        inverse_slider_mass,
        slider_v_dot_by_slider_x,
        t0,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), p.belt_speed]
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
/// 20 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 17 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(c.inverse_slider_stribeck_speed * slider_sliding.abs())).exp(),
            );
    let slider_friction = -(slider_dragged
        * (c.inverse_slider_width * slider_sliding).tanh());
    let slider_v_dot = slider_friction
        .sub_product(p.slider_stiffness, slider_x)
        .sub_product(p.slider_damping, slider_v) * c.inverse_slider_mass;
    [slider_v, slider_v_dot]
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
/// 18 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_sliding.abs()))
                    .exp(),
            );
    let slider_friction = -(slider_dragged
        * (R::literal(1.0) / p.slider_width * slider_sliding).tanh());
    let slider_x_forcing = slider_friction
        .sub_product(p.slider_stiffness, slider_x)
        .sub_product(p.slider_damping, slider_v);
    [slider_x_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 28 operations.
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
/// 21 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 3] {
    let [_, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let t0 = (-(c.inverse_slider_stribeck_speed * slider_sliding.abs())).exp();
    let slider_dragged = p.slider_normal_force
        * p.slider_kinetic_friction.add_product(p.slider_stribeck_friction, t0);
    let t1 = (c.inverse_slider_width * slider_sliding).tanh();
    let slider_v_dot_by_slider_v = (-p.slider_damping)
        .add_product(
            c.t0 * t0 * t1,
            R::select_less(
                slider_sliding,
                R::literal(0.0),
                R::literal(-1.0),
                R::literal(1.0),
            ),
        )
        .sub_product(
            c.inverse_slider_width * slider_dragged,
            R::literal(1.0).sub_product(t1, t1),
        ) * c.inverse_slider_mass;
    [R::literal(1.0), c.slider_v_dot_by_slider_x, slider_v_dot_by_slider_v]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 61 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 9] {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let abs_slider_sliding = slider_sliding.abs();
    let t0 = (-(R::literal(1.0) / p.slider_stribeck_speed * abs_slider_sliding)).exp();
    let t1 = p.slider_kinetic_friction.add_product(p.slider_stribeck_friction, t0);
    let slider_dragged = p.slider_normal_force * t1;
    let inverse_slider_width = R::literal(1.0) / p.slider_width;
    let t2 = (inverse_slider_width * slider_sliding).tanh();
    let slider_friction = -(slider_dragged * t2);
    let inverse_slider_mass = R::literal(1.0) / p.slider_mass;
    let slider_v_dot = slider_friction
        .sub_product(p.slider_stiffness, slider_x)
        .sub_product(p.slider_damping, slider_v) * inverse_slider_mass;
    let t3 = R::literal(1.0).sub_product(t2, t2);
    let t4 = p.slider_normal_force * p.slider_stribeck_friction;
    let slider_v_dot_by_belt_speed = (-(t4 / p.slider_stribeck_speed * t0 * t2
        * R::select_less(
            slider_sliding,
            R::literal(0.0),
            R::literal(-1.0),
            R::literal(1.0),
        )))
        .add_product(inverse_slider_width * slider_dragged, t3) * inverse_slider_mass;
    let slider_v_dot_by_slider_mass = -(slider_v_dot * inverse_slider_mass);
    let slider_v_dot_by_slider_stiffness = -(slider_x * inverse_slider_mass);
    let slider_v_dot_by_slider_damping = -(slider_v * inverse_slider_mass);
    let slider_v_dot_by_slider_normal_force = -(t1 * t2 * inverse_slider_mass);
    let slider_v_dot_by_slider_kinetic_friction = -(p.slider_normal_force * t2
        * inverse_slider_mass);
    let slider_v_dot_by_slider_stribeck_friction = -(p.slider_normal_force * t0 * t2
        * inverse_slider_mass);
    let slider_v_dot_by_slider_stribeck_speed = -(t4
        / (p.slider_stribeck_speed * p.slider_stribeck_speed) * abs_slider_sliding * t0
        * t2 * inverse_slider_mass);
    let slider_v_dot_by_slider_width = R::literal(1.0)
        / (p.slider_width * p.slider_width) * slider_sliding * slider_dragged * t3
        * inverse_slider_mass;
    [
        slider_v_dot_by_belt_speed,
        slider_v_dot_by_slider_mass,
        slider_v_dot_by_slider_stiffness,
        slider_v_dot_by_slider_damping,
        slider_v_dot_by_slider_normal_force,
        slider_v_dot_by_slider_kinetic_friction,
        slider_v_dot_by_slider_stribeck_friction,
        slider_v_dot_by_slider_stribeck_speed,
        slider_v_dot_by_slider_width,
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
    [R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// 14 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_sliding.abs()))
                    .exp(),
            );
    let slider_friction = -(slider_dragged
        * (R::literal(1.0) / p.slider_width * slider_sliding).tanh());
    Outputs {
        deflection: slider_x,
        velocity: slider_v,
        friction: slider_friction,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 6 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [slider_x, slider_v] = *state;
    Energy {
        kinetic: R::literal(0.5) * p.slider_mass * (slider_v * slider_v),
        potential: R::literal(0.5) * p.slider_stiffness * (slider_x * slider_x),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 28 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let slider_dragged = p.slider_normal_force
        * p
            .slider_kinetic_friction
            .add_product(
                p.slider_stribeck_friction,
                (-(R::literal(1.0) / p.slider_stribeck_speed * slider_sliding.abs()))
                    .exp(),
            );
    let t0 = slider_dragged * (R::literal(1.0) / p.slider_width * slider_sliding).tanh();
    let slider_friction = -t0;
    let slider_stiffness_times_slider_x = p.slider_stiffness * slider_x;
    let slider_v_dot = (slider_friction - slider_stiffness_times_slider_x)
        .sub_product(p.slider_damping, slider_v) * (R::literal(1.0) / p.slider_mass);
    PowerBalance {
        stored_rate: (slider_stiffness_times_slider_x * slider_v)
            .add_product(p.slider_mass * slider_v, slider_v_dot),
        supplied: -(slider_v * t0),
        dissipated: p.slider_damping * (slider_v * slider_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 36 recurrences. 4 sums of products an order.
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
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [slider_x, slider_v] = *state;
    let slider_sliding = slider_v - p.belt_speed;
    let t0 = -slider_sliding;
    let t1 = R::select_less(slider_sliding, R::literal(0.0), t0, slider_sliding);
    let t2 = R::literal(1.0) / p.slider_stribeck_speed;
    let t3 = t1 * t2;
    let t4 = -t3;
    let t5 = t4.exp();
    let t6 = t5 * p.slider_stribeck_friction;
    let t7 = p.slider_kinetic_friction + t6;
    let slider_dragged = t7 * p.slider_normal_force;
    let t8 = R::literal(1.0) / p.slider_width;
    let t9 = slider_sliding * t8;
    let t10 = t9.tanh();
    let t11 = t10 * t10;
    let t12 = R::literal(1.0) - t11;
    let t13 = slider_dragged * t10;
    let slider_friction = -t13;
    let t14 = R::literal(1.0) / p.slider_mass;
    let t15 = slider_x * p.slider_stiffness;
    let t16 = slider_v * p.slider_damping;
    let t17 = slider_friction - t15;
    let t18 = t17 - t16;
    let slider_v_dot = t18 * t14;
    let mut rates = [slider_v, slider_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [slider_x_k, slider_v_k] = *state_k;
        let sums = lanes.sums(order);
        let t0_k = -slider_v_k;
        let t1_k = R::select_less(slider_sliding, R::literal(0.0), t0_k, slider_v_k);
        let t3_k = t1_k * t2;
        let t4_k = -t3_k;
        let t5_k = t4_k.mul_add(t5, inverse * sums[2]);
        let slider_dragged_k = t5_k * p.slider_stribeck_friction * p.slider_normal_force;
        let t9_k = slider_v_k * t8;
        let t10_k = t9_k.mul_add(t12, inverse * sums[1]);
        let t11_k = (t10 + t10).mul_add(t10_k, sums[0]);
        let t12_k = -t11_k;
        let t13_k = t10
            .mul_add(slider_dragged_k, slider_dragged.mul_add(t10_k, sums[3]));
        let slider_friction_k = -t13_k;
        let t17_k = (-slider_x_k).mul_add(p.slider_stiffness, slider_friction_k);
        let t18_k = (-slider_v_k).mul_add(p.slider_damping, t17_k);
        let slider_v_dot_k = t18_k * t14;
        lanes
            .set(
                order,
                [t10_k, k * t9_k, k * t4_k, slider_dragged_k],
                [t10_k, t12_k, t5_k, t10_k],
            );
        rates = [slider_v_k, slider_v_dot_k];
    }
}

impl<R: Real> TaylorSeries<R> for StickSlipSmooth {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1)
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
        Bends::Corners
    }
}

impl Describe for StickSlipSmooth {
    fn name(&self) -> &'static str {
        "stick_slip_smooth"
    }
    fn title(&self) -> &'static str {
        "Stick-slip oscillation on a belt, smoothed"
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

impl<R: Real> Simulator<R> for StickSlipSmooth {
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
];

static STATE_SCALES: [f64; STATES] = [0.01, 0.1];

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
        name: "slider.width",
        unit: "m/s",
        doc: "sliding speed over which friction changes its direction",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.1,
    1.0,
    400.0,
    0.0,
    10.0,
    0.25,
    0.1,
    0.05,
    0.001,
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
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 2001,
    rtol: 1e-8,
    method: "radau",
};

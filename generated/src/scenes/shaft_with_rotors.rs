// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   89832a23555fb9a71a8dbd8015d000b2ecf26a7fafa138b70d153513b0db8063  scenes/shaft_with_rotors.toml
//   ea2e394474eda1c8e7c81b630e209d9449e129941c3297c0c0ecffddc2cf8db9  units/shaft.toml
//   192155c0a8dc7b884c45e939d6fe1b122b135258825141b94f360d68f1612fb5  units/rotor.toml
//
// Shaft with a rotor at each end, let go twisted
//
// The shaft of the saw gin, free but for a rotor at each end; it is let go at rest, twisted
// by a cosine that has no slope at the ends. Without inertia of the rotors this is a mode
// of the free shaft, which Kelvin-Voigt damping lets decay.
//
// Source:
//   Saw-gin study (2020), distributed subsystem; closed forms by hand.
//
// Shapes; all quantities are in SI units:
//   coordinates               2
//   first-order states        0
//   states                    4
//   parameters               15
//   outputs                   2
//   discontinuities           0
//
// State:
//     0  shaft.start      [rad]    angle of the section, at port start
//     1  shaft.end        [rad]    angle of the section, at port end
//     2  shaft.start_dot  [rad/s]  rate of angle of the section, at port start
//     3  shaft.end_dot    [rad/s]  rate of angle of the section, at port end
//
// Nonzeros:
//   mass_matrix               2 of 2 by 2
//   rate_jacobian             2 of 4 by 4
//   parameter_jacobian        6 of 4 by 15
//
// Operations:
//   initial_state             1
//   discontinuities           0
//   rate                      6
//   mass_matrix               2
//   forcing                   0
//   rate_jacobian             0
//   parameter_jacobian       10
//   time_derivative           0
//   outputs                   0
//   energy                   13
//   power_balance            18
// With constants of the parameters, prepared once a run:
//   prepare                   4
//   prepared_rate             2
//   prepared_rate_jacobian    0

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations,
    field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 2;

/// Length of the state y.
pub const STATES: usize = 4;

/// Parameters.
pub const PARAMETERS: usize = 15;

/// Wanted outputs.
pub const OUTPUTS: usize = 2;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 2,
    columns: 2,
    entries: &[(0, 0), (1, 1)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 4,
    entries: &[(0, 2), (1, 3)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 4,
    columns: 15,
    entries: &[(2, 6), (2, 7), (2, 8), (3, 5), (3, 11), (3, 12)],
};

/// Shaft with a rotor at each end, let go twisted
///
/// The shaft of the saw gin, free but for a rotor at each end; it is let go at rest, twisted
/// by a cosine that has no slope at the ends. Without inertia of the rotors this is a mode
/// of the free shaft, which Kelvin-Voigt damping lets decay.
///
/// Source: Saw-gin study (2020), distributed subsystem; closed forms by hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ShaftWithRotors;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// twist: half of the twist at the start \[rad\]. In the spec: 0.01.
    pub twist: R,
    /// shaft.length: length \[m\]. In the spec: 2.322.
    pub shaft_length: R,
    /// shaft.density: moment of inertia a length; the default spreads 1.244 kg m^2 over 2.322 m \[kg m\]. In the spec: 0.5357450473729543.
    pub shaft_density: R,
    /// shaft.stiffness: torsional stiffness of the section, shear modulus times polar moment \[N m^2\]. In the spec: 785360.0.
    pub shaft_stiffness: R,
    /// shaft.damping_time: Kelvin-Voigt damping time \[s\]. In the spec: 1e-5.
    pub shaft_damping_time: R,
    /// driven.inertia: moment of inertia \[kg m^2\]. In the spec: 1.244.
    pub driven_inertia: R,
    /// driving.inertia: moment of inertia \[kg m^2\]. In the spec: 4.2.
    pub driving_inertia: R,
    /// shaft.start_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_start_field_inertia: R,
    /// shaft.start_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_start_field_force: R,
    /// shaft.start_phi_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_start_phi_x_before: R,
    /// shaft.start_phi_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_start_phi_x_after: R,
    /// shaft.end_field_inertia: inertia of the field's node; the field sets it \[J s^2/(rad)^2\]. In the spec: 1.0.
    pub shaft_end_field_inertia: R,
    /// shaft.end_field_force: force of the field on its node; the field sets it \[J/(rad)\]. In the spec: 0.0.
    pub shaft_end_field_force: R,
    /// shaft.end_phi_x_before: slope of the field before the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_end_phi_x_before: R,
    /// shaft.end_phi_x_after: slope of the field after the port; the field sets it \[rad/m\]. In the spec: 0.0.
    pub shaft_end_phi_x_after: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            twist: values[0],
            shaft_length: values[1],
            shaft_density: values[2],
            shaft_stiffness: values[3],
            shaft_damping_time: values[4],
            driven_inertia: values[5],
            driving_inertia: values[6],
            shaft_start_field_inertia: values[7],
            shaft_start_field_force: values[8],
            shaft_start_phi_x_before: values[9],
            shaft_start_phi_x_after: values[10],
            shaft_end_field_inertia: values[11],
            shaft_end_field_force: values[12],
            shaft_end_phi_x_before: values[13],
            shaft_end_phi_x_after: values[14],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.twist,
            self.shaft_length,
            self.shaft_density,
            self.shaft_stiffness,
            self.shaft_damping_time,
            self.driven_inertia,
            self.driving_inertia,
            self.shaft_start_field_inertia,
            self.shaft_start_field_force,
            self.shaft_start_phi_x_before,
            self.shaft_start_phi_x_after,
            self.shaft_end_field_inertia,
            self.shaft_end_field_force,
            self.shaft_end_phi_x_before,
            self.shaft_end_phi_x_after,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            twist: R::literal(0.01),
            shaft_length: R::literal(2.322),
            shaft_density: R::literal(0.535_745_047_372_954_3),
            shaft_stiffness: R::literal(785_360.0),
            shaft_damping_time: R::literal(1e-5),
            driven_inertia: R::literal(1.244),
            driving_inertia: R::literal(4.2),
            shaft_start_field_inertia: R::literal(1.0),
            shaft_start_field_force: R::literal(0.0),
            shaft_start_phi_x_before: R::literal(0.0),
            shaft_start_phi_x_after: R::literal(0.0),
            shaft_end_field_inertia: R::literal(1.0),
            shaft_end_field_force: R::literal(0.0),
            shaft_end_phi_x_before: R::literal(0.0),
            shaft_end_phi_x_after: R::literal(0.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// start_angle: angle of the section, at port start \[rad\].
    pub start_angle: R,
    /// end_angle: angle of the section, at port end \[rad\].
    pub end_angle: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            start_angle: values[0],
            end_angle: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.start_angle, self.end_angle]
    }
}

/// Where to find what in the state.
pub mod state {
    /// shaft.start: angle of the section, at port start \[rad\].
    pub const SHAFT_START: usize = 0;
    /// shaft.end: angle of the section, at port end \[rad\].
    pub const SHAFT_END: usize = 1;
    /// shaft.start_dot: rate of angle of the section, at port start \[rad/s\].
    pub const SHAFT_START_DOT: usize = 2;
    /// shaft.end_dot: rate of angle of the section, at port end \[rad/s\].
    pub const SHAFT_END_DOT: usize = 3;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 2;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub t1: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            t1: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [self.t0, self.t1]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 4 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(1.0) / (p.driving_inertia + p.shaft_start_field_inertia);
    let t1 = R::literal(1.0) / (p.driven_inertia + p.shaft_end_field_inertia);
    Constants { t0, t1 }
}

/// State at the start of the run, in the units of the states.
///
/// 1 operation.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [p.twist, -p.twist, R::literal(0.0), R::literal(0.0)]
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
/// 6 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 2 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_dot = p.shaft_end_field_force * c.t1;
    let shaft_start_dot_dot = p.shaft_start_field_force * c.t0;
    [shaft_start_dot, shaft_end_dot, shaft_start_dot_dot, shaft_end_dot_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
    [
        p.driving_inertia + p.shaft_start_field_inertia,
        p.driven_inertia + p.shaft_end_field_inertia,
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// No operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    [p.shaft_start_field_force, p.shaft_end_field_force]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
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
    _c: &Constants<R>,
) -> [R; 2] {
    [R::literal(1.0), R::literal(1.0)]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 10 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 6] {
    let shaft_start_dot_dot_by_shaft_start_field_force = R::literal(1.0)
        / (p.driving_inertia + p.shaft_start_field_inertia);
    let shaft_end_dot_dot_by_shaft_end_field_force = R::literal(1.0)
        / (p.driven_inertia + p.shaft_end_field_inertia);
    let shaft_end_dot_dot = p.shaft_end_field_force
        * shaft_end_dot_dot_by_shaft_end_field_force;
    let shaft_start_dot_dot = p.shaft_start_field_force
        * shaft_start_dot_dot_by_shaft_start_field_force;
    let shaft_end_dot_dot_by_driven_inertia = -(shaft_end_dot_dot
        * shaft_end_dot_dot_by_shaft_end_field_force);
    let shaft_start_dot_dot_by_driving_inertia = -(shaft_start_dot_dot
        * shaft_start_dot_dot_by_shaft_start_field_force);
    [
        shaft_start_dot_dot_by_driving_inertia,
        shaft_start_dot_dot_by_driving_inertia,
        shaft_start_dot_dot_by_shaft_start_field_force,
        shaft_end_dot_dot_by_driven_inertia,
        shaft_end_dot_dot_by_driven_inertia,
        shaft_end_dot_dot_by_shaft_end_field_force,
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
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [shaft_start, shaft_end, ..] = *state;
    Outputs {
        start_angle: shaft_start,
        end_angle: shaft_end,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 13 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_squared = shaft_end_dot * shaft_end_dot;
    let shaft_start_dot_squared = shaft_start_dot * shaft_start_dot;
    Energy {
        kinetic: (R::literal(0.5) * p.driven_inertia * shaft_end_dot_squared)
            .add_product(R::literal(0.5) * p.driving_inertia, shaft_start_dot_squared)
            .add_product(
                R::literal(0.5) * p.shaft_start_field_inertia,
                shaft_start_dot_squared,
            )
            .add_product(
                R::literal(0.5) * p.shaft_end_field_inertia,
                shaft_end_dot_squared,
            ),
        potential: R::literal(0.0),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 18 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, shaft_start_dot, shaft_end_dot] = *state;
    let shaft_end_dot_dot = p.shaft_end_field_force
        * (R::literal(1.0) / (p.driven_inertia + p.shaft_end_field_inertia));
    let shaft_start_dot_dot = p.shaft_start_field_force
        * (R::literal(1.0) / (p.driving_inertia + p.shaft_start_field_inertia));
    PowerBalance {
        stored_rate: ((p.driving_inertia * shaft_start_dot)
            .add_product(shaft_start_dot, p.shaft_start_field_inertia)
            * shaft_start_dot_dot)
            .add_product(
                (p.driven_inertia * shaft_end_dot)
                    .add_product(shaft_end_dot, p.shaft_end_field_inertia),
                shaft_end_dot_dot,
            ),
        supplied: (shaft_start_dot * p.shaft_start_field_force)
            .add_product(shaft_end_dot, p.shaft_end_field_force),
        dissipated: R::literal(0.0),
    }
}

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 2] = [(2, 0), (3, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// 6 operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, p: &Parameters<R>) -> [R; 8] {
    [
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_start_field_force
            * (R::literal(1.0) / (p.driving_inertia + p.shaft_start_field_inertia)),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        p.shaft_end_field_force
            * (R::literal(1.0) / (p.driven_inertia + p.shaft_end_field_inertia)),
        R::literal(0.0),
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for ShaftWithRotors {
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

impl Describe for ShaftWithRotors {
    fn name(&self) -> &'static str {
        "shaft_with_rotors"
    }
    fn title(&self) -> &'static str {
        "Shaft with a rotor at each end, let go twisted"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 2,
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

impl<R: Real> Simulator<R> for ShaftWithRotors {
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
        name: "shaft.start",
        unit: "rad",
        doc: "angle of the section, at port start",
    },
    Quantity {
        name: "shaft.end",
        unit: "rad",
        doc: "angle of the section, at port end",
    },
    Quantity {
        name: "shaft.start_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port start",
    },
    Quantity {
        name: "shaft.end_dot",
        unit: "rad/s",
        doc: "rate of angle of the section, at port end",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 78.5, 78.5];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "twist",
        unit: "rad",
        doc: "half of the twist at the start",
    },
    Quantity {
        name: "shaft.length",
        unit: "m",
        doc: "length",
    },
    Quantity {
        name: "shaft.density",
        unit: "kg m",
        doc: "moment of inertia a length; the default spreads 1.244 kg m^2 over 2.322 m",
    },
    Quantity {
        name: "shaft.stiffness",
        unit: "N m^2",
        doc: "torsional stiffness of the section, shear modulus times polar moment",
    },
    Quantity {
        name: "shaft.damping_time",
        unit: "s",
        doc: "Kelvin-Voigt damping time",
    },
    Quantity {
        name: "driven.inertia",
        unit: "kg m^2",
        doc: "moment of inertia",
    },
    Quantity {
        name: "driving.inertia",
        unit: "kg m^2",
        doc: "moment of inertia",
    },
    Quantity {
        name: "shaft.start_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "shaft.start_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "shaft.start_phi_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.start_phi_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
    Quantity {
        name: "shaft.end_field_inertia",
        unit: "J s^2/(rad)^2",
        doc: "inertia of the field's node; the field sets it",
    },
    Quantity {
        name: "shaft.end_field_force",
        unit: "J/(rad)",
        doc: "force of the field on its node; the field sets it",
    },
    Quantity {
        name: "shaft.end_phi_x_before",
        unit: "rad/m",
        doc: "slope of the field before the port; the field sets it",
    },
    Quantity {
        name: "shaft.end_phi_x_after",
        unit: "rad/m",
        doc: "slope of the field after the port; the field sets it",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.01,
    2.322,
    0.535_745_047_372_954_3,
    785_360.0,
    1e-5,
    1.244,
    4.2,
    1.0,
    0.0,
    0.0,
    0.0,
    1.0,
    0.0,
    0.0,
    0.0,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "start_angle",
        unit: "rad",
        doc: "angle of the section, at port start",
    },
    Quantity {
        name: "end_angle",
        unit: "rad",
        doc: "angle of the section, at port end",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.02,
    points: 401,
    rtol: 1e-8,
    method: "dop853",
};

/// The field shaft.phi: angle of the section \[rad\].
///
/// One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over elements are the contract's.
pub mod shaft_phi {
    #[allow(
        clippy::wildcard_imports,
        unused_imports,
        reason = "what a field needs of it"
    )]
    use super::*;
    /// Parameters that the field depends on.
    pub const PARAMETERS: [u32; 4] = [1, 2, 3, 4];
    /// m, the inertia a length.
    ///
    /// 0 operations.
    #[must_use]
    #[inline(always)]
    pub fn inertia<R: Real>(_x: R, p: &Parameters<R>) -> [R; 1] {
        [p.shaft_density]
    }
    /// dm/dx, then dm/dp of `PARAMETERS`.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn inertia_gradient<R: Real>(_x: R, _p: &Parameters<R>) -> [R; 5] {
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(1.0),
            R::literal(0.0),
            R::literal(0.0),
        ]
    }
    /// Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x.
    ///
    /// 4 operations.
    #[must_use]
    #[inline]
    pub fn force<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [
            R::literal(0.0),
            -(p.shaft_stiffness * phi_x.add_product(p.shaft_damping_time, phi_x_dot)),
        ]
    }
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    ///
    /// 3 operations.
    #[must_use]
    #[inline]
    pub fn force_jacobian<R: Real>(
        _time: R,
        _x: R,
        _point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 8] {
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -p.shaft_stiffness,
            R::literal(0.0),
            -(p.shaft_stiffness * p.shaft_damping_time),
        ]
    }
    /// Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`.
    ///
    /// 5 operations.
    #[must_use]
    #[inline]
    pub fn force_gradient<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 12] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            -phi_x.add_product(p.shaft_damping_time, phi_x_dot),
            R::literal(0.0),
            -(p.shaft_stiffness * phi_x_dot),
        ]
    }
    /// T and V a length \[J/m\].
    ///
    /// 6 operations.
    #[must_use]
    #[inline]
    pub fn energy<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 2] {
        let [_, phi_x, phi_dot, _] = *point;
        [
            R::literal(0.5) * p.shaft_density * (phi_dot * phi_dot),
            R::literal(0.5) * p.shaft_stiffness * (phi_x * phi_x),
        ]
    }
    /// Rate of V, power supplied and power dissipated, a length \[W/m\].
    ///
    /// 5 operations.
    #[must_use]
    #[inline]
    pub fn power<R: Real>(
        _time: R,
        _x: R,
        point: &FieldPoint<R>,
        p: &Parameters<R>,
    ) -> [R; 3] {
        let [_, phi_x, _, phi_x_dot] = *point;
        [
            p.shaft_stiffness * phi_x * phi_x_dot,
            R::literal(0.0),
            p.shaft_stiffness * p.shaft_damping_time * (phi_x_dot * phi_x_dot),
        ]
    }
    /// x of the attachments, then the length \[m\].
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places<R: Real>(p: &Parameters<R>) -> [R; 3] {
        [R::literal(0.0), p.shaft_length, p.shaft_length]
    }
    /// Derivatives of `places` with respect to `PARAMETERS`, row by row.
    ///
    /// 0 operations.
    #[must_use]
    #[inline]
    pub fn places_gradient<R: Real>(_p: &Parameters<R>) -> [R; 12] {
        [
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(1.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(1.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ]
    }
    /// u and u_t at the start.
    ///
    /// 4 operations.
    #[must_use]
    #[inline]
    pub fn initial<R: Real>(x: R, p: &Parameters<R>) -> [R; 2] {
        [
            p.twist * (R::literal(core::f64::consts::PI) / p.shaft_length * x).cos(),
            R::literal(0.0),
        ]
    }
    /// f_0 alone, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        force: &mut [R],
    ) {
        for (((_, _), _), force) in at.iter().zip(u).zip(u_t).zip(force) {
            *force = R::literal(0.0);
        }
    }
    /// df_0/du and df_0/du_t, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_jacobian<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        by_u: &mut [R],
        by_u_t: &mut [R],
    ) {
        for ((((_, _), _), by_u), by_u_t) in at
            .iter()
            .zip(u)
            .zip(u_t)
            .zip(by_u)
            .zip(by_u_t)
        {
            *by_u = R::literal(0.0);
            *by_u_t = R::literal(0.0);
        }
    }
    /// df_0/dt, at many points.
    ///
    /// 0 operations for all points, 0 for each.
    pub fn on_value_by_time<R: Real>(
        _time: R,
        at: &[R],
        u: &[R],
        u_t: &[R],
        _p: &Parameters<R>,
        by_time: &mut [R],
    ) {
        for (((_, _), _), by_time) in at.iter().zip(u).zip(u_t).zip(by_time) {
            *by_time = R::literal(0.0);
        }
    }
    /// f_1 alone, at many points.
    ///
    /// 0 operations for all points, 4 for each.
    pub fn on_slope<R: Real>(u_x: &[R], u_xt: &[R], p: &Parameters<R>, force: &mut [R]) {
        for ((&phi_x, &phi_x_dot), force) in u_x.iter().zip(u_xt).zip(force) {
            *force = -(p.shaft_stiffness
                * phi_x.add_product(p.shaft_damping_time, phi_x_dot));
        }
    }
    /// df_1/du_x and df_1/du_xt, at many points.
    ///
    /// 3 operations for all points, 0 for each.
    pub fn on_slope_jacobian<R: Real>(
        u_x: &[R],
        u_xt: &[R],
        p: &Parameters<R>,
        by_u_x: &mut [R],
        by_u_xt: &mut [R],
    ) {
        let minus_shaft_stiffness = -p.shaft_stiffness;
        let t0 = -(p.shaft_stiffness * p.shaft_damping_time);
        for (((_, _), by_u_x), by_u_xt) in u_x.iter().zip(u_xt).zip(by_u_x).zip(by_u_xt)
        {
            *by_u_x = minus_shaft_stiffness;
            *by_u_xt = t0;
        }
    }
}

impl<R: Real> FieldScene<R> for ShaftWithRotors {
    fn fields(&self) -> usize {
        1
    }
    fn field(&self, index: usize) -> FieldDescription<'_> {
        match index {
            0 => SHAFT_PHI_FIELD,
            _ => no_field(index),
        }
    }
    fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
        let p = parameters_of(parameters);
        let [inertia] = match index {
            0 => shaft_phi::inertia(x, &p),
            _ => no_field(index),
        };
        inertia
    }
    fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::initial(x, &p),
            _ => no_field(index),
        }
    }
    fn field_force(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::force(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_force_jacobian(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 8] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::force_jacobian(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_energy(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 2] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::energy(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_power(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
    ) -> [R; 3] {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::power(time, x, point, &p),
            _ => no_field(index),
        }
    }
    fn field_inertia_gradient(
        &self,
        index: usize,
        x: R,
        parameters: &[R],
        values: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_phi::inertia_gradient(x, &p)),
            _ => no_field(index),
        }
    }
    fn field_force_gradient(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        parameters: &[R],
        values: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_phi::force_gradient(time, x, point, &p)),
            _ => no_field(index),
        }
    }
    fn field_places(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_phi::places(&p)),
            _ => no_field(index),
        }
    }
    fn field_places_gradient(&self, index: usize, parameters: &[R], values: &mut [R]) {
        let p = parameters_of(parameters);
        match index {
            0 => values.copy_from_slice(&shaft_phi::places_gradient(&p)),
            _ => no_field(index),
        }
    }
    fn jacobian_reads_forces(&self) -> bool {
        false
    }
    fn field_is_linear(&self, index: usize) -> bool {
        matches!(index, 0)
    }
    fn field_is_local(&self, index: usize) -> bool {
        matches!(index, 0)
    }
    fn field_inertias(
        &self,
        index: usize,
        x: &[R],
        parameters: &[R],
        inertias: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => {
                for (inertia, x) in inertias.iter_mut().zip(x) {
                    [*inertia] = shaft_phi::inertia(*x, &p);
                }
            }
            _ => no_field(index),
        }
    }
    fn field_forces_on_values(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        forces: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::on_value(time, x, u, u_t, &p, forces),
            _ => no_field(index),
        }
    }
    fn field_forces_on_values_jacobian(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        [by_u,
        by_u_t,
        ]: [&mut [R]; 2],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::on_value_jacobian(time, x, u, u_t, &p, by_u, by_u_t),
            _ => no_field(index),
        }
    }
    fn field_forces_on_values_by_time(
        &self,
        index: usize,
        time: R,
        [x,
        u,
        u_t,
        ]: [&[R]; 3],
        parameters: &[R],
        (_, by_time): (&mut [R], &mut [R]),
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::on_value_by_time(time, x, u, u_t, &p, by_time),
            _ => no_field(index),
        }
    }
    fn field_forces_on_slopes(
        &self,
        index: usize,
        [u_x,
        u_xt,
        ]: [&[R]; 2],
        parameters: &[R],
        forces: &mut [R],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::on_slope(u_x, u_xt, &p, forces),
            _ => no_field(index),
        }
    }
    fn field_forces_on_slopes_jacobian(
        &self,
        index: usize,
        [u_x,
        u_xt,
        ]: [&[R]; 2],
        parameters: &[R],
        [by_u_x,
        by_u_xt,
        ]: [&mut [R]; 2],
    ) {
        let p = parameters_of(parameters);
        match index {
            0 => shaft_phi::on_slope_jacobian(u_x, u_xt, &p, by_u_x, by_u_xt),
            _ => no_field(index),
        }
    }
}

#[cold]
fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}

static SHAFT_PHI_FIELD: FieldDescription<'static> = FieldDescription {
    value: Quantity {
        name: "shaft.phi",
        unit: "rad",
        doc: "angle of the section",
    },
    rate: Quantity {
        name: "shaft.phi_dot",
        unit: "rad/s",
        doc: "rate of angle of the section",
    },
    slope: Quantity {
        name: "shaft.phi_x",
        unit: "rad/m",
        doc: "slope of angle of the section",
    },
    scale: [1.0, 78.5],
    fixed: [false, false],
    length: 2.322,
    attachments: &[
        FieldAttachment {
            coordinate: Some(0),
            place: FieldPlace::Start,
            at: 0.0,
            handed: 7,
        },
        FieldAttachment {
            coordinate: Some(1),
            place: FieldPlace::End,
            at: 2.322,
            handed: 11,
        },
    ],
    parameters: &shaft_phi::PARAMETERS,
    elements: 16,
    order: 4,
};

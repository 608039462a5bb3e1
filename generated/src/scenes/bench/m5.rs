// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   6c26ef0b8a885b808b2dde70587b319f88bbe875be8ab0e2d5c9184134b36285  bench/m5.toml
//
// Benchmark M5: winder
//
// One degree of freedom under a force and a moving support of two frequencies.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        0
//   states                    2
//   parameters                0
//   outputs                   2
//   discontinuities           0
//
// State:
//     0  winder.q  [m]    displacement of the lever
//     1  winder.v  [m/s]  rate of displacement of the lever
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             3 of 2 by 2
//   parameter_jacobian        0 of 2 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     12
//   mass_matrix               0
//   forcing                  11
//   rate_jacobian             0
//   parameter_jacobian        0
//   time_derivative           8
//   outputs                   0
//   energy                   11
//   power_balance            30

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations, taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 2;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 2;

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
    columns: 0,
    entries: &[],
};

/// Benchmark M5: winder
///
/// One degree of freedom under a force and a moving support of two frequencies.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M5;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// Nothing; there are no numbers here.
    pub real: core::marker::PhantomData<R>,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(_values: [R; PARAMETERS]) -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        []
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// q: displacement of the lever \[m\].
    pub q: R,
    /// v: rate of displacement of the lever \[m/s\].
    pub v: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self { q: values[0], v: values[1] }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.q, self.v]
    }
}

/// Where to find what in the state.
pub mod state {
    /// winder.q: displacement of the lever \[m\].
    pub const WINDER_Q: usize = 0;
    /// winder.v: rate of displacement of the lever \[m/s\].
    pub const WINDER_V: usize = 1;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
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
/// 12 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [winder_q, winder_v] = *state;
    let [(t0, _), (t1, _)] = R::sin_cos_each([
        R::literal(220.0) * time,
        R::literal(110.0) * time,
    ]);
    let winder_v_dot = (R::literal(8.4) * t0)
        .add_product(R::literal(25.0), t1)
        .sub_product(R::literal(45800.0), winder_q)
        .sub_product(R::literal(95.0), winder_v) * R::literal(0.476_190_476_190_476_16);
    [winder_v, winder_v_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 1] {
    [R::literal(2.1)]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 11 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [winder_q, winder_v] = *state;
    let [(t0, _), (t1, _)] = R::sin_cos_each([
        R::literal(220.0) * time,
        R::literal(110.0) * time,
    ]);
    let winder_q_forcing = (R::literal(8.4) * t0)
        .add_product(R::literal(25.0), t1)
        .sub_product(R::literal(45800.0), winder_q)
        .sub_product(R::literal(95.0), winder_v);
    [winder_q_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 3] {
    [
        R::literal(1.0),
        R::literal(-21_809.523_809_523_81),
        R::literal(-45.238_095_238_095_234),
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time.
///
/// 8 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    let [(_, t0), (_, t1)] = R::sin_cos_each([
        R::literal(220.0) * time,
        R::literal(110.0) * time,
    ]);
    let winder_v_dot_by_time = (R::literal(1848.0) * t0)
        .add_product(R::literal(2750.0), t1) * R::literal(0.476_190_476_190_476_16);
    [R::literal(0.0), winder_v_dot_by_time]
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
    let [winder_q, winder_v] = *state;
    Outputs {
        q: winder_q,
        v: winder_v,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 11 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [winder_q, winder_v] = *state;
    let winder_surface = R::literal(0.0002) * (R::literal(220.0) * time).sin();
    let winder_q_minus_winder_surface = winder_q - winder_surface;
    Energy {
        kinetic: R::literal(1.05) * (winder_v * winder_v),
        potential: (R::literal(1900.0) * (winder_q * winder_q))
            .add_product(
                R::literal(21000.0),
                winder_q_minus_winder_surface * winder_q_minus_winder_surface,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 30 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [winder_q, winder_v] = *state;
    let t0 = R::literal(220.0) * time;
    let [(t1, t2), (t3, _)] = R::sin_cos_each([t0, R::literal(110.0) * time]);
    let winder_surface = R::literal(0.0002) * t1;
    let winder_v_dot = (R::literal(8.4) * t1)
        .add_product(R::literal(25.0), t3)
        .sub_product(R::literal(45800.0), winder_q)
        .sub_product(R::literal(95.0), winder_v) * R::literal(0.476_190_476_190_476_16);
    let winder_q_minus_winder_surface = winder_q - winder_surface;
    let t4 = R::literal(1848.0) * winder_q_minus_winder_surface * t2;
    PowerBalance {
        stored_rate: (-t4)
            .add_product(
                (R::literal(3800.0) * winder_q)
                    .add_product(R::literal(42000.0), winder_q_minus_winder_surface),
                winder_v,
            )
            .add_product(R::literal(2.1) * winder_v, winder_v_dot),
        supplied: (-t4).add_product(R::literal(25.0) * winder_v, t3),
        dissipated: R::literal(95.0) * (winder_v * winder_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 24 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
    let [winder_q, winder_v] = *state;
    let t0 = time * R::literal(220.0);
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = winder_q * R::literal(45800.0);
    let t4 = winder_v * R::literal(95.0);
    let t5 = t1 * R::literal(8.4);
    let t6 = time * R::literal(110.0);
    let t7 = t6.sin();
    let t8 = t6.cos();
    let t9 = t7 * R::literal(25.0);
    let t10 = t5 + t9;
    let t11 = t10 - t3;
    let t12 = t11 - t4;
    let winder_v_dot = t12 * R::literal(0.476_190_476_190_476_16);
    let mut t1_before = t1;
    let mut t2_before = t2;
    let mut t7_before = t7;
    let mut t8_before = t8;
    let mut rates = [winder_v, winder_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [winder_q_k, winder_v_k] = *state_k;
        let t1_k = inverse * R::literal(220.0) * t2_before;
        let t2_k = -inverse * R::literal(220.0) * t1_before;
        let t7_k = inverse * R::literal(110.0) * t8_before;
        let t8_k = -inverse * R::literal(110.0) * t7_before;
        let t10_k = t7_k.mul_add(R::literal(25.0), t1_k * R::literal(8.4));
        let t11_k = (-winder_q_k).mul_add(R::literal(45800.0), t10_k);
        let t12_k = (-winder_v_k).mul_add(R::literal(95.0), t11_k);
        let winder_v_dot_k = t12_k * R::literal(0.476_190_476_190_476_16);
        t1_before = t1_k;
        t2_before = t2_k;
        t7_before = t7_k;
        t8_before = t8_k;
        rates = [winder_v_k, winder_v_dot_k];
    }
}

impl<R: Real> TaylorSeries<R> for M5 {
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
pub const EXCITATION_TERMS: [(u32, u32); 2] = [(1, 0), (1, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// No operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _p: &Parameters<R>) -> [R; 8] {
    [
        R::literal(0.0),
        R::literal(220.0),
        R::literal(0.0),
        R::literal(4.0),
        R::literal(0.0),
        R::literal(110.0),
        R::literal(0.0),
        R::literal(11.904_761_904_761_903),
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for M5 {
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

impl Describe for M5 {
    fn name(&self) -> &'static str {
        "m5"
    }
    fn title(&self) -> &'static str {
        "Benchmark M5: winder"
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

impl<R: Real> Simulator<R> for M5 {
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
        name: "winder.q",
        unit: "m",
        doc: "displacement of the lever",
    },
    Quantity {
        name: "winder.v",
        unit: "m/s",
        doc: "rate of displacement of the lever",
    },
];

static STATE_SCALES: [f64; STATES] = [0.001, 0.1];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "q",
        unit: "m",
        doc: "displacement of the lever",
    },
    Quantity {
        name: "v",
        unit: "m/s",
        doc: "rate of displacement of the lever",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 2001,
    rtol: 1e-8,
    method: "auto",
};

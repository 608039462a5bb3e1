//! Derivatives to rounding error by the complex step, for checks of emitted Jacobians.
//!
//! For an analytic f of real coefficients, `f(x + i h) = f(x) + i h f'(x) + O(h^2)`,
//! so `Im f(x + i h)/h` is f'(x) without any difference of close numbers, and h
//! may be so small that h^2 is nothing beside 1. (W. Squire and G. Trapp, Using
//! complex variables to estimate derivatives of real functions, SIAM Review 40,
//! 1998.)

use std::ops::{Add, Div, Mul, Neg, Sub};

pub use crate::dense::dense;
use machinist_contract::{Describe, Energy, Real, Shape, Simulator};
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

/// The step h. Its square is nothing beside 1, and derivatives from 1e-200 to
/// 1e200 neither vanish nor overflow when multiplied by it.
pub const STEP: f64 = 1e-100;

/// A real number with a tiny imaginary perturbation.
///
/// Functions are evaluated to first order in the imaginary part,
/// `f(a + i b) = f(a) + i b f'(a)`, which for b of the order of [`STEP`] is exact
/// to rounding, and accurate where the textbook complex formulas of tanh, asin,
/// acos and atan cancel. Comparisons and `abs` go by the real part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplexStep(pub Complex64);

impl ComplexStep {
    /// `value + i STEP`.
    #[must_use]
    pub fn perturbed(value: f64) -> Self {
        Self(Complex64::new(value, STEP))
    }

    /// The derivative of this value in the direction perturbed: `Im/STEP`.
    #[must_use]
    pub fn derivative(self) -> f64 {
        self.0.im / STEP
    }

    /// f(a) + i b f'(a) from f(a) and f'(a).
    fn chain(self, value: f64, slope: f64) -> Self {
        Self(Complex64::new(value, self.0.im * slope))
    }
}

impl Add for ComplexStep {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for ComplexStep {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for ComplexStep {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Div for ComplexStep {
    type Output = Self;

    /// (a + i b)/(c + i d) = a/c + i (b - (a/c) d)/c; the full formula squares c.
    fn div(self, other: Self) -> Self {
        let quotient = self.0.re / other.0.re;
        Self(Complex64::new(quotient, (self.0.im - quotient * other.0.im) / other.0.re))
    }
}

impl Neg for ComplexStep {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for ComplexStep {
    fn literal(value: f64) -> Self {
        Self(Complex64::new(value, 0.0))
    }

    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.0.re < rhs.0.re { then } else { otherwise }
    }

    fn powi(self, exponent: i32) -> Self {
        let x = self.0.re;
        let slope = if exponent == 0 { 0.0 } else { f64::from(exponent) * x.powi(exponent - 1) };
        self.chain(x.powi(exponent), slope)
    }

    fn powf(self, exponent: Self) -> Self {
        let (x, p) = (self.0.re, exponent.0.re);
        let value = x.powf(p);
        let by_base = if self.0.im == 0.0 { 0.0 } else { self.0.im * p * x.powf(p - 1.0) };
        let by_exponent = if exponent.0.im == 0.0 { 0.0 } else { exponent.0.im * value * x.ln() };
        Self(Complex64::new(value, by_base + by_exponent))
    }

    fn sqrt(self) -> Self {
        let root = self.0.re.sqrt();
        self.chain(root, 0.5 / root)
    }

    fn abs(self) -> Self {
        if self.0.re < 0.0 { -self } else { self }
    }

    fn floor(self) -> Self {
        Self::literal(self.0.re.floor())
    }

    fn exp(self) -> Self {
        let value = self.0.re.exp();
        self.chain(value, value)
    }

    fn ln(self) -> Self {
        self.chain(self.0.re.ln(), self.0.re.recip())
    }

    fn sin(self) -> Self {
        let (sin, cos) = self.0.re.sin_cos();
        self.chain(sin, cos)
    }

    fn cos(self) -> Self {
        let (sin, cos) = self.0.re.sin_cos();
        self.chain(cos, -sin)
    }

    fn tan(self) -> Self {
        let tan = self.0.re.tan();
        self.chain(tan, 1.0 + tan * tan)
    }

    fn asin(self) -> Self {
        let x = self.0.re;
        self.chain(x.asin(), ((1.0 - x) * (1.0 + x)).sqrt().recip())
    }

    fn acos(self) -> Self {
        let x = self.0.re;
        self.chain(x.acos(), -((1.0 - x) * (1.0 + x)).sqrt().recip())
    }

    fn atan(self) -> Self {
        let x = self.0.re;
        self.chain(x.atan(), (1.0 + x * x).recip())
    }

    fn sinh(self) -> Self {
        self.chain(self.0.re.sinh(), self.0.re.cosh())
    }

    fn cosh(self) -> Self {
        self.chain(self.0.re.cosh(), self.0.re.sinh())
    }

    /// Uses the slope 1/cosh^2, because 1 - tanh^2 would cancel.
    fn tanh(self) -> Self {
        let cosh = self.0.re.cosh();
        self.chain(self.0.re.tanh(), (cosh * cosh).recip())
    }
}

/// Functions of a simulator that the complex step differentiates. Every simulator has them. Making
/// `&dyn Values` of a simulator compiles only these on complex numbers.
pub trait Values: Describe {
    /// See [`Simulator::initial_state`].
    fn initial_state(&self, parameters: &[ComplexStep], state: &mut [ComplexStep]);
    /// See [`Simulator::rate`].
    fn rate(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
        rate: &mut [ComplexStep],
    );
    /// See [`Simulator::outputs`].
    fn outputs(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
        outputs: &mut [ComplexStep],
    );
    /// See [`Simulator::energy`].
    fn energy(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
    ) -> Energy<ComplexStep>;
}

impl<S: Simulator<ComplexStep> + ?Sized> Values for S {
    fn initial_state(&self, parameters: &[ComplexStep], state: &mut [ComplexStep]) {
        Simulator::initial_state(self, parameters, state);
    }
    fn rate(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
        rate: &mut [ComplexStep],
    ) {
        Simulator::rate(self, time, state, parameters, rate);
    }
    fn outputs(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
        outputs: &mut [ComplexStep],
    ) {
        Simulator::outputs(self, time, state, parameters, outputs);
    }
    fn energy(
        &self,
        time: ComplexStep,
        state: &[ComplexStep],
        parameters: &[ComplexStep],
    ) -> Energy<ComplexStep> {
        Simulator::energy(self, time, state, parameters)
    }
}

/// Returns dy'/dy, `states` by `states`, at real `time`, `state` and `parameters`.
///
/// # Panics
/// If the length of `state` or `parameters` is not that of the simulator.
#[must_use]
pub fn rate_jacobian(
    simulator: &(impl Values + ?Sized),
    time: f64,
    state: &[f64],
    parameters: &[f64],
) -> DMatrix<f64> {
    let shape = checked_shape(simulator, state, parameters);
    by_columns(shape.states(), state, |state, rate| {
        simulator.rate(Real::literal(time), state, &lift(parameters), rate);
    })
}

/// Returns dy'/dp, `states` by `parameters`, at real `time`, `state` and `parameters`.
///
/// # Panics
/// If the length of `state` or `parameters` is not that of the simulator.
#[must_use]
pub fn parameter_jacobian(
    simulator: &(impl Values + ?Sized),
    time: f64,
    state: &[f64],
    parameters: &[f64],
) -> DMatrix<f64> {
    let shape = checked_shape(simulator, state, parameters);
    by_columns(shape.states(), parameters, |parameters, rate| {
        simulator.rate(Real::literal(time), &lift(state), parameters, rate);
    })
}

/// Returns the partial derivative of y' by time, of length `states`.
///
/// # Panics
/// If the length of `state` or `parameters` is not that of the simulator.
#[must_use]
pub fn time_derivative(
    simulator: &(impl Values + ?Sized),
    time: f64,
    state: &[f64],
    parameters: &[f64],
) -> DVector<f64> {
    let shape = checked_shape(simulator, state, parameters);
    let jacobian = by_columns(shape.states(), &[time], |time, rate| {
        simulator.rate(time[0], &lift(state), &lift(parameters), rate);
    });
    jacobian.column(0).into_owned()
}

/// Returns d function/d at, with one column for each element of `at`.
fn by_columns(
    rows: usize,
    at: &[f64],
    function: impl Fn(&[ComplexStep], &mut [ComplexStep]),
) -> DMatrix<f64> {
    let mut point = lift(at);
    let mut value = vec![ComplexStep::literal(0.0); rows];
    let mut matrix = DMatrix::zeros(rows, at.len());
    for column in 0..at.len() {
        point[column] = ComplexStep::perturbed(at[column]);
        function(&point, &mut value);
        point[column] = ComplexStep::literal(at[column]);
        for (row, value) in value.iter().enumerate() {
            matrix[(row, column)] = value.derivative();
        }
    }
    matrix
}

fn checked_shape(simulator: &(impl Describe + ?Sized), state: &[f64], parameters: &[f64]) -> Shape {
    let shape = simulator.shape();
    assert_eq!(state.len(), shape.states(), "length of the state");
    assert_eq!(parameters.len(), shape.parameters, "number of parameters");
    shape
}

fn lift(values: &[f64]) -> Vec<ComplexStep> {
    values.iter().copied().map(Real::literal).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares derivatives of every function with closed forms in f64.
    #[test]
    fn every_function_has_its_derivative_to_rounding() {
        type Case = (&'static str, fn(ComplexStep) -> ComplexStep, fn(f64) -> f64);
        let cases: &[Case] = &[
            ("powi", |x| x.powi(-3), |x| -3.0 * x.powi(-4)),
            ("powi 0", |x| x.powi(0), |_| 0.0),
            ("powf", |x| x.powf(Real::literal(2.5)), |x| 2.5 * x.powf(1.5)),
            ("exponent", |x| ComplexStep::literal(3.0).powf(x), |x| 3f64.powf(x) * 3f64.ln()),
            ("sqrt", Real::sqrt, |x| 0.5 / x.sqrt()),
            ("exp", Real::exp, f64::exp),
            ("ln", Real::ln, f64::recip),
            ("sin", Real::sin, f64::cos),
            ("cos", Real::cos, |x| -x.sin()),
            ("tan", Real::tan, |x| x.cos().powi(-2)),
            ("asin", Real::asin, |x| 1.0 / (1.0 - x * x).sqrt()),
            ("acos", Real::acos, |x| -1.0 / (1.0 - x * x).sqrt()),
            ("atan", Real::atan, |x| 1.0 / (1.0 + x * x)),
            ("sinh", Real::sinh, f64::cosh),
            ("cosh", Real::cosh, f64::sinh),
            ("tanh", Real::tanh, |x| x.cosh().powi(-2)),
            (
                "quotient",
                |x| x / (x * x + Real::literal(1.0)),
                |x| (1.0 - x * x) / (1.0 + x * x).powi(2),
            ),
        ];
        for (name, function, derivative) in cases {
            for x in [0.037, 0.3, 0.9] {
                let found = function(ComplexStep::perturbed(x)).derivative();
                let wanted = derivative(x);
                let error = (found - wanted).abs();
                assert!(error <= 1e-14 * wanted.abs(), "{name} at {x}: {found} for {wanted}");
            }
        }
    }

    #[test]
    fn tanh_keeps_its_slope_where_it_saturates() {
        let slope = ComplexStep::perturbed(20.0).tanh().derivative();
        assert!((slope / (4.0 * (-40.0f64).exp()) - 1.0).abs() < 1e-13);
    }

    #[test]
    fn abs_and_selection_go_by_the_real_part() {
        let below = ComplexStep::perturbed(-2.0);
        assert_eq!(below.abs().0, -below.0);
        let chosen = ComplexStep::select_less(
            below,
            ComplexStep::literal(0.0),
            ComplexStep::literal(1.0),
            ComplexStep::literal(2.0),
        );
        assert_eq!(chosen, ComplexStep::literal(1.0));
    }
}

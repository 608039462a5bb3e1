//! Dual numbers: values that carry derivatives in several directions.
//!
//! ```text
//! f(a + e b) = f(a) + e f'(a) b,   e^2 = 0
//! ```
//!
//! Computations on dual numbers give derivatives exact to rounding, by the chain rule, without
//! differences of close numbers. Values are bitwise equal to those of `f64`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::{CubicTable, Real, Simulator};

/// A number and its derivatives in several directions. Comparisons and `abs` use the value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative in each direction.
    pub slopes: [f64; Dual::DIRECTIONS],
}

impl Dual {
    /// Number of directions.
    pub const DIRECTIONS: usize = 4;

    /// Returns a number whose derivatives are zero.
    #[must_use]
    pub const fn constant(value: f64) -> Self {
        Self { value, slopes: [0.0; Self::DIRECTIONS] }
    }

    /// Returns f(a) + e f'(a) b from f(a) and f'(a). If b is zero the derivative is zero, even if
    /// the function is vertical there.
    #[inline(always)]
    fn chain(self, value: f64, slope: f64) -> Self {
        let by = |b: f64| if b == 0.0 { 0.0 } else { slope * b };
        // Written out, as below: closures over arrays take most of the compile time of a scene on
        // dual numbers.
        let [a, b, c, d] = self.slopes;
        Self { value, slopes: [by(a), by(b), by(c), by(d)] }
    }

    #[inline(always)]
    fn both(self, other: Self, value: f64, slope: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.slopes, other.slopes);
        Self { value, slopes: [slope(a, e), slope(b, f), slope(c, g), slope(d, h)] }
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.both(other, self.value + other.value, |a, b| a + b)
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.both(other, self.value - other.value, |a, b| a - b)
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the product rule")]
impl Mul for Dual {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let slope = |a: f64, b: f64| a * other.value + self.value * b;
        self.both(other, self.value * other.value, slope)
    }
}

#[allow(clippy::suspicious_arithmetic_impl, reason = "the quotient rule")]
impl Div for Dual {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        self.both(other, quotient, |a, b| (a - quotient * b) / other.value)
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        let [a, b, c, d] = self.slopes;
        Self { value: -self.value, slopes: [-a, -b, -c, -d] }
    }
}

impl Real for Dual {
    fn literal(value: f64) -> Self {
        Self::constant(value)
    }

    fn select_less(lhs: Self, rhs: Self, then: Self, otherwise: Self) -> Self {
        if lhs.value < rhs.value { then } else { otherwise }
    }

    #[inline(always)]
    fn mul_add(self, factor: Self, summand: Self) -> Self {
        let value = Real::mul_add(self.value, factor.value, summand.value);
        Self { value, slopes: (self * factor + summand).slopes }
    }

    fn powi(self, exponent: i32) -> Self {
        let slope = match exponent {
            0 => 0.0,
            _ => f64::from(exponent) * Real::powi(self.value, exponent - 1),
        };
        self.chain(Real::powi(self.value, exponent), slope)
    }

    fn powf(self, exponent: Self) -> Self {
        let (x, p) = (self.value, exponent.value);
        let value = Real::powf(x, p);
        let by_base = self.chain(value, p * Real::powf(x, p - 1.0));
        let by_exponent = exponent.chain(value, value * Real::ln(x));
        by_base.both(by_exponent, value, |a, b| a + b)
    }

    fn sqrt(self) -> Self {
        let root = Real::sqrt(self.value);
        self.chain(root, 0.5 / root)
    }

    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { Self { value: Real::abs(self.value), ..self } }
    }

    fn floor(self) -> Self {
        Self::literal(Real::floor(self.value))
    }

    fn exp(self) -> Self {
        let value = Real::exp(self.value);
        self.chain(value, value)
    }

    fn ln(self) -> Self {
        self.chain(Real::ln(self.value), 1.0 / self.value)
    }

    fn sin(self) -> Self {
        self.sin_cos().0
    }

    fn cos(self) -> Self {
        self.sin_cos().1
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.value);
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    fn tan(self) -> Self {
        let tan = Real::tan(self.value);
        self.chain(tan, 1.0 + tan * tan)
    }

    fn asin(self) -> Self {
        let x = self.value;
        self.chain(Real::asin(x), 1.0 / Real::sqrt((1.0 - x) * (1.0 + x)))
    }

    fn acos(self) -> Self {
        let x = self.value;
        self.chain(Real::acos(x), -1.0 / Real::sqrt((1.0 - x) * (1.0 + x)))
    }

    fn atan(self) -> Self {
        let x = self.value;
        self.chain(Real::atan(x), 1.0 / (1.0 + x * x))
    }

    fn sinh(self) -> Self {
        self.chain(Real::sinh(self.value), Real::cosh(self.value))
    }

    fn cosh(self) -> Self {
        self.chain(Real::cosh(self.value), Real::sinh(self.value))
    }

    /// Uses the derivative 1/cosh^2, because 1 - tanh^2 would cancel.
    fn tanh(self) -> Self {
        let cosh = Real::cosh(self.value);
        self.chain(Real::tanh(self.value), 1.0 / (cosh * cosh))
    }

    fn interpolate(table: &CubicTable<'_>, order: u32, argument: Self) -> Self {
        let at = |order: u32| table.search(order, argument.value);
        argument.chain(at(order), at(order + 1))
    }
}

/// A function of a simulator that may be differentiated on dual numbers. Derivatives of the
/// Jacobian are second derivatives of the rate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the function of the table of this name")]
pub enum DualFunction {
    InitialState,
    Discontinuities,
    RateJacobian,
    TimeDerivative,
    Outputs,
    Guards,
    Resets,
    KinkGuards,
    ConstraintValues,
    ConstraintRates,
    ConstraintMatrix,
    MassMatrix,
}

/// Functions of a simulator on dual numbers, for sensitivities along a run. Every simulator on
/// any [`Real`] has them; [`Simulator::derivatives`] returns them.
pub trait Derivatives {
    /// Evaluates the function of the simulator on dual numbers. Functions of parameters alone
    /// read neither time nor state.
    ///
    /// # Panics
    /// If a slice has another length than the simulator's function takes.
    fn on_duals(
        &self,
        function: DualFunction,
        time: Dual,
        state: &[Dual],
        parameters: &[Dual],
        values: &mut [Dual],
    );
}

impl<S: Simulator<Dual>> Derivatives for S {
    fn on_duals(
        &self,
        function: DualFunction,
        time: Dual,
        state: &[Dual],
        parameters: &[Dual],
        values: &mut [Dual],
    ) {
        let of_motion = match function {
            DualFunction::InitialState => return self.initial_state(parameters, values),
            DualFunction::Discontinuities => return self.discontinuities(parameters, values),
            DualFunction::RateJacobian => S::rate_jacobian,
            DualFunction::TimeDerivative => S::time_derivative,
            DualFunction::Outputs => S::outputs,
            DualFunction::Guards => S::guards,
            DualFunction::Resets => S::resets,
            DualFunction::KinkGuards => S::kink_guards,
            DualFunction::ConstraintValues => S::constraint_values,
            DualFunction::ConstraintRates => S::constraint_rates,
            DualFunction::ConstraintMatrix => S::constraint_matrix,
            DualFunction::MassMatrix => S::mass_matrix,
        };
        of_motion(self, time, state, parameters, values);
    }
}

#[cfg(test)]
mod tests {
    use super::Dual;
    use crate::{CubicTable, Real};

    fn along(value: f64) -> Dual {
        Dual { value, slopes: [1.0, -2.0, 0.0, 0.5] }
    }

    /// Compares derivatives with central differences, and values with those of `f64`.
    #[test]
    #[allow(clippy::float_cmp, reason = "values are the same to the last bit")]
    fn every_function_has_its_slope() {
        type Pair = (&'static str, fn(Dual) -> Dual, fn(f64) -> f64);
        let cases: &[Pair] = &[
            ("powi", |x| x.powi(-3), |x| Real::powi(x, -3)),
            ("powi 0", |x| x.powi(0), |_| 1.0),
            ("base", |x| x.powf(Dual::literal(2.5)), |x| Real::powf(x, 2.5)),
            ("exponent", |x| Dual::literal(3.0).powf(x), |x| Real::powf(3.0, x)),
            ("both", |x| x.powf(x), |x| Real::powf(x, x)),
            ("sqrt", Real::sqrt, Real::sqrt),
            ("abs", |x| (-x).abs(), |x| x),
            ("exp", Real::exp, Real::exp),
            ("ln", Real::ln, Real::ln),
            ("sin", Real::sin, Real::sin),
            ("cos", Real::cos, Real::cos),
            ("tan", Real::tan, Real::tan),
            ("asin", Real::asin, Real::asin),
            ("acos", Real::acos, Real::acos),
            ("atan", Real::atan, Real::atan),
            ("sinh", Real::sinh, Real::sinh),
            ("cosh", Real::cosh, Real::cosh),
            ("tanh", Real::tanh, Real::tanh),
            ("quotient", |x| x / (x * x + Dual::literal(1.0)), |x| x / (x * x + 1.0)),
            ("fused", |x| Real::mul_add(x, x, -x), |x| Real::mul_add(x, x, -x)),
        ];
        for (name, dual, real) in cases {
            for x in [0.04, 0.3, 0.9] {
                let found = dual(along(x));
                assert_eq!(found.value, real(x), "{name} at {x}");
                // Central difference of fourth order.
                let h = 1e-3 * x;
                let near = |k: f64| real(x + k * h) - real(x - k * h);
                let slope = (8.0 * near(1.0) - near(2.0)) / (12.0 * h);
                for (found, along) in found.slopes.iter().zip(along(x).slopes) {
                    let error = (found - along * slope).abs();
                    assert!(error <= 1e-8 * (1.0 + slope.abs()), "{name} at {x}: {found}, {slope}");
                }
            }
        }
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "polynomials of small numbers are exact")]
    fn a_table_has_the_slope_of_its_piece() {
        let table = CubicTable {
            knots: &[0.0, 1.0, 3.0],
            coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
        };
        let found = table.evaluate(0, along(2.0));
        assert_eq!(found.value, table.evaluate(0, 2.0));
        assert_eq!(found.slopes[1], -2.0 * table.evaluate(1, 2.0));
        assert_eq!(table.evaluate(0, along(9.0)).slopes, [0.0; 4]);
    }

    #[test]
    #[allow(clippy::float_cmp, reason = "zero is zero")]
    fn what_does_not_move_has_no_slope_where_a_root_is_vertical() {
        let root = Dual { value: 0.0, slopes: [0.0, 1.0, 0.0, 0.0] }.sqrt();
        assert_eq!(root.slopes, [0.0, f64::INFINITY, 0.0, 0.0]);
    }
}

//! Numbers with their derivatives along two directions.
//!
//! ```text
//! x + x_a a + x_b b + x_ab a b        a^2 = b^2 = 0
//! f(x) = f + f' x_a a + f' x_b b + (f' x_ab + f'' x_a x_b) a b
//! ```
//!
//! Hyper-dual numbers: J. A. Fike, J. J. Alonso, "The development of hyper-dual numbers for exact
//! second-derivative calculations", AIAA 2011-886. There is no step size, so the only error is
//! rounding.
//!
//! A part is absent, not zero, if the number does not change along its direction: sqrt at 0 has a
//! value as long as its argument does not change.

use machinist_contract::Real;
use machinist_model::Function;

/// x + x_a a + x_b b + x_ab a b.
#[derive(Debug, Clone, Copy)]
pub struct Hyper<R> {
    /// x.
    pub value: R,
    /// x_a.
    pub a: Option<R>,
    /// x_b.
    pub b: Option<R>,
    /// x_ab.
    pub ab: Option<R>,
}

fn both<R: Real>(x: Option<R>, y: Option<R>) -> Option<R> {
    match (x, y) {
        (Some(x), Some(y)) => Some(x + y),
        (one, other) => one.or(other),
    }
}

fn times<R: Real>(x: Option<R>, y: Option<R>) -> Option<R> {
    Some(x? * y?)
}

impl<R: Real> Hyper<R> {
    /// Returns a number that changes along neither direction.
    pub fn constant(value: R) -> Self {
        Self { value, a: None, b: None, ab: None }
    }

    /// Returns a literal.
    pub fn literal(value: f64) -> Self {
        Self::constant(R::literal(value))
    }

    /// Returns x + y.
    pub fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            a: both(self.a, other.a),
            b: both(self.b, other.b),
            ab: both(self.ab, other.ab),
        }
    }

    /// Returns x y.
    pub fn by(self, other: Self) -> Self {
        let (x, y) = (Some(self.value), Some(other.value));
        let crossed = both(times(self.a, other.b), times(self.b, other.a));
        Self {
            value: self.value * other.value,
            a: both(times(self.a, y), times(x, other.a)),
            b: both(times(self.b, y), times(x, other.b)),
            ab: both(both(times(self.ab, y), times(x, other.ab)), crossed),
        }
    }

    /// Returns f(x), with f' and f'' where they are needed.
    pub fn through(self, f: R, slope: impl FnOnce() -> R, bend: impl FnOnce() -> R) -> Self {
        let moves = self.a.is_some() || self.b.is_some() || self.ab.is_some();
        let slope = moves.then(slope);
        let bent = times(self.a, self.b).map(|product| product * bend());
        Self {
            value: f,
            a: times(self.a, slope),
            b: times(self.b, slope),
            ab: both(times(self.ab, slope), bent),
        }
    }

    /// Returns 1/x.
    pub fn reciprocal(self) -> Self {
        let one = R::literal(1.0);
        let f = one / self.value;
        self.through(f, || -(f * f), || (f * f * f) * R::literal(2.0))
    }

    /// Returns x^k, by multiplication.
    pub fn power(self, exponent: i32) -> Self {
        let mut product = Self::literal(1.0);
        let mut square = self;
        let mut left = exponent.unsigned_abs();
        while left > 0 {
            if left % 2 == 1 {
                product = product.by(square);
            }
            left /= 2;
            if left > 0 {
                square = square.by(square);
            }
        }
        if exponent < 0 { product.reciprocal() } else { product }
    }

    /// Returns x^c for x above zero.
    pub fn real_power(self, exponent: R) -> Self {
        let (x, one) = (self.value, R::literal(1.0));
        let lower = |by: R, factor: R| factor * x.powf(exponent - by);
        let slope = || lower(one, exponent);
        let bend = || lower(one + one, exponent * (exponent - one));
        self.through(x.powf(exponent), slope, bend)
    }

    /// Returns x where lhs < rhs, else y; the other one does not matter.
    pub fn select_less([lhs, rhs]: [R; 2], then: Self, otherwise: Self) -> Self {
        let pick = |then: R, otherwise: R| R::select_less(lhs, rhs, then, otherwise);
        let zero = R::literal(0.0);
        let part = |then: Option<R>, otherwise: Option<R>| {
            let moves = then.is_some() || otherwise.is_some();
            moves.then(|| pick(then.unwrap_or(zero), otherwise.unwrap_or(zero)))
        };
        Self {
            value: pick(then.value, otherwise.value),
            a: part(then.a, otherwise.a),
            b: part(then.b, otherwise.b),
            ab: part(then.ab, otherwise.ab),
        }
    }

    /// Applies a function by its textbook derivatives.
    pub fn call(self, function: Function) -> Self {
        let (x, one, two) = (self.value, R::literal(1.0), R::literal(2.0));
        let zero = || R::literal(0.0);
        match function {
            Function::Sqrt => {
                let root = x.sqrt();
                let slope = one / (two * root);
                self.through(root, || slope, || -(slope / (two * x)))
            }
            Function::Abs => {
                let sign = || R::select_less(x, R::literal(0.0), -one, one);
                self.through(x.abs(), sign, zero)
            }
            Function::Floor => self.through(x.floor(), zero, zero),
            Function::Exp => {
                let f = x.exp();
                self.through(f, || f, || f)
            }
            Function::Ln => self.through(x.ln(), || one / x, || -(one / (x * x))),
            Function::Sin => self.through(x.sin(), || x.cos(), || -x.sin()),
            Function::Cos => self.through(x.cos(), || -x.sin(), || -x.cos()),
            Function::Tan => {
                let f = x.tan();
                let slope = one + f * f;
                self.through(f, || slope, || two * f * slope)
            }
            Function::Asin => {
                let rest = one - x * x;
                let slope = one / rest.sqrt();
                self.through(x.asin(), || slope, || x * slope / rest)
            }
            Function::Acos => {
                let rest = one - x * x;
                let slope = -(one / rest.sqrt());
                self.through(x.acos(), || slope, || x * slope / rest)
            }
            Function::Atan => {
                let slope = one / (one + x * x);
                self.through(x.atan(), || slope, || -(two * x * slope * slope))
            }
            Function::Sinh => self.through(x.sinh(), || x.cosh(), || x.sinh()),
            Function::Cosh => self.through(x.cosh(), || x.sinh(), || x.cosh()),
            Function::Tanh => {
                let f = x.tanh();
                let slope = one - f * f;
                self.through(f, || slope, || -(two * f * slope))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the value, both first derivatives and the mixed one of f along a and b, at x = a +
    /// 2 b.
    fn at(x: f64, f: impl Fn(Hyper<f64>) -> Hyper<f64>) -> [f64; 4] {
        let found = f(Hyper { value: x, a: Some(1.0), b: Some(2.0), ab: None });
        [found.value, found.a.unwrap_or(0.0), found.b.unwrap_or(0.0), found.ab.unwrap_or(0.0)]
    }

    #[track_caller]
    fn agree(found: [f64; 4], [f, slope, bend]: [f64; 3]) {
        for (found, expected) in found.into_iter().zip([f, slope, 2.0 * slope, 2.0 * bend]) {
            let error = (found - expected).abs();
            assert!(error <= 1e-14 * (1.0 + expected.abs()), "{found} is not {expected}");
        }
    }

    #[test]
    fn closed_forms_by_hand() {
        let x: f64 = 0.7;
        agree(at(x, |x| x.power(3)), [x.powi(3), 3.0 * x * x, 6.0 * x]);
        agree(at(-x, |x| x.power(-2)), [x.powi(-2), 2.0 * x.powi(-3), 6.0 * x.powi(-4)]);
        agree(at(x, |x| x.power(0)), [1.0, 0.0, 0.0]);
        let third = 1.0 / 3.0;
        let lower = |by: f64| x.powf(third - by);
        let expected = [lower(0.0), third * lower(1.0), third * (third - 1.0) * lower(2.0)];
        agree(at(x, |x| x.real_power(third)), expected);
        // (x e^x)'' = (2 + x) e^x.
        let product = |x: Hyper<f64>| x.by(x.call(Function::Exp));
        agree(at(x, product), [x * x.exp(), (1.0 + x) * x.exp(), (2.0 + x) * x.exp()]);
        // sin x/x.
        let (sine, cosine) = x.sin_cos();
        let bend = -sine / x - 2.0 * cosine / (x * x) + 2.0 * sine / x.powi(3);
        let expected = [sine / x, cosine / x - sine / (x * x), bend];
        agree(at(x, |x| x.call(Function::Sin).by(x.reciprocal())), expected);
    }

    /// Compares f' and f'' of every function with extrapolated differences of f: f' to ten
    /// digits, f'' to six.
    #[test]
    fn functions_by_differences() {
        for (function, name) in Function::ALL {
            for x in [0.23, 0.61, 0.87] {
                let f = |x: f64| machinist_model::evaluate::call(function, x);
                let slope = |h: f64| (f(x + h) - f(x - h)) / (2.0 * h);
                let bend = |h: f64| (f(x + h) - 2.0 * f(x) + f(x - h)) / (h * h);
                let extrapolated = |d: &dyn Fn(f64) -> f64, h| (4.0 * d(h) - d(2.0 * h)) / 3.0;
                let [value, found, _, twice] = at(x, |x| x.call(function));
                assert!((value - f(x)).abs() < 1e-15, "{name}");
                let slope = extrapolated(&slope, 1e-3);
                assert!((found - slope).abs() < 2e-9 * (1.0 + slope.abs()), "{name}' at {x}");
                let bend = extrapolated(&bend, 2e-3);
                assert!((twice / 2.0 - bend).abs() < 1e-6 * (1.0 + bend.abs()), "{name}'' at {x}");
            }
        }
    }

    #[test]
    fn what_does_not_move_has_no_slope() {
        let root = Hyper::<f64>::literal(0.0).call(Function::Sqrt);
        assert!(root.a.is_none() && root.value == 0.0);
    }
}

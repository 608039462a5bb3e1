//! Equality of expressions, tested by their values at random points of a finite field.
//!
//! A nonzero polynomial is zero at a random point with a probability of its degree over the number
//! of points (Schwartz, Zippel), which is negligible with 2^60 points. Values are exact, so there
//! is no rounding error. The cost is linear in the size of the expression, while that of expansion
//! has no bound.
//!
//! The field has P = 4 Q + 1 elements, P and Q both prime. Exponents are residues modulo Q, so that
//! e^x = g^x keeps e^(x + y) = e^x e^y, and -1 has a square root, so that cosine and sine keep
//! Pythagoras and the addition theorems. Other functions are only known to be equal if their
//! arguments are.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};
use rustc_hash::FxHashMap;

use super::{Expr, Function, Shared, Symbol};

/// A prime of 62 bits, 4 Q + 1.
pub(super) const P: u64 = 4_611_686_018_427_386_309;
/// A prime of 60 bits.
const Q: u64 = 1_152_921_504_606_846_577;
/// Elements of order Q, for e^x and for e^(i x).
const GROWTH: u64 = 16;
const TURN: u64 = 81;
/// A square root of -1 modulo P.
const I: u64 = 2_800_538_231_775_425_404;
/// Number of points at which an identity must hold.
pub(super) const POINTS: u64 = 2;

/// Result of evaluation at the points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Identity {
    /// Zero, for all values of its symbols.
    Zero,
    /// Not zero.
    NotZero,
    /// A part divides by zero or is the logarithm of zero, for all values of the symbols.
    Undefined,
}

/// Determines whether an expression is zero for all values of its symbols.
#[must_use]
pub fn identity(expr: &Expr) -> Identity {
    let mut all_zero = true;
    for point in 0..POINTS {
        match (Point { point }).value(expr) {
            None => return Identity::Undefined,
            Some(value) => all_zero &= value.is_zero(),
        }
    }
    if all_zero { Identity::Zero } else { Identity::NotZero }
}

/// Returns whether an expression is zero for all values of its symbols.
#[must_use]
pub fn is_zero(expr: &Expr) -> bool {
    identity(expr) == Identity::Zero
}

/// Returns whether two expressions are equal and defined for all values of their symbols.
#[must_use]
pub fn are_equal(a: &Expr, b: &Expr) -> bool {
    (0..POINTS).all(|point| {
        let point = Point { point };
        point.value(a).zip(point.value(b)).is_some_and(|(a, b)| a == b)
    })
}

/// A number modulo P, used as a value, and modulo Q, used as an exponent.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Value {
    pub(super) p: u64,
    q: u64,
}

impl Value {
    pub(super) const ZERO: Value = Value { p: 0, q: 0 };
    pub(super) const ONE: Value = Value { p: 1, q: 1 };

    pub(super) fn is_zero(self) -> bool {
        self.p == 0
    }

    pub(super) fn of(number: &BigRational) -> Option<Value> {
        let over = |modulus| {
            let below = inverse(residue(number.denom(), modulus), modulus)?;
            Some(times(residue(number.numer(), modulus), below, modulus))
        };
        Some(Value { p: over(P)?, q: over(Q)? })
    }

    pub(super) fn plus(self, other: Value) -> Value {
        Value { p: (self.p + other.p) % P, q: (self.q + other.q) % Q }
    }

    pub(super) fn minus(self) -> Value {
        Value { p: (P - self.p) % P, q: (Q - self.q) % Q }
    }

    pub(super) fn times(self, other: Value) -> Value {
        Value { p: times(self.p, other.p, P), q: times(self.q, other.q, Q) }
    }

    /// Returns the inverse, `None` for zero.
    pub(super) fn inverse(self) -> Option<Value> {
        let p = inverse(self.p, P)?;
        // A residue may vanish by chance if the number is not used as an exponent.
        Some(Value { p, q: inverse(self.q, Q).unwrap_or(0) })
    }

    /// Returns the sign of the fraction with this value; `None` for zero.
    pub(super) fn is_negative(self) -> Option<bool> {
        let (above, below) = fraction(self.p)?;
        (above != 0).then_some(below < 0)
    }

    pub(super) fn power(self, exponent: &BigInt) -> Option<Value> {
        let base = if exponent.is_negative() { self.inverse()? } else { self };
        let size = exponent.abs();
        let raised = |base, modulus: u64| raised(base, residue(&size, modulus - 1), modulus);
        // The exponent is reduced, and 0^(P - 1) is not 0^0.
        if self.is_zero() && !size.is_zero() {
            return Some(Value::ZERO);
        }
        Some(Value { p: raised(base.p, P), q: raised(base.q, Q) })
    }
}

fn residue(number: &BigInt, modulus: u64) -> u64 {
    if let Some(small) = number.to_i64() {
        return small.rem_euclid(modulus as i64) as u64;
    }
    let modulus = BigInt::from(modulus);
    let rest = ((number % &modulus) + &modulus) % &modulus;
    rest.to_u64().unwrap_or(0)
}

/// Returns a b modulo P or Q, for a and b below the modulus.
///
/// Both moduli are 2^k - c with a small c, so that 2^k is equivalent to c: two products reduce the
/// bits above k to a number below 2^(k + 1), without a 128-bit division.
pub(super) fn times(a: u64, b: u64, modulus: u64) -> u64 {
    let bits = u64::BITS - modulus.leading_zeros();
    let c = u128::from((1 << bits) - modulus);
    let folded = |number: u128| (number >> bits) * c + (number & ((1 << bits) - 1));
    let rest = folded(folded(u128::from(a) * u128::from(b))) as u64;
    if rest < modulus { rest } else { rest - modulus }
}

fn raised(mut base: u64, mut exponent: u64, modulus: u64) -> u64 {
    let mut result = 1;
    while exponent > 0 {
        if exponent & 1 == 1 {
            result = times(result, base, modulus);
        }
        base = times(base, base, modulus);
        exponent >>= 1;
    }
    result
}

/// Returns 1/a modulo a prime by Euclid's algorithm, which is short for the small denominators of
/// expressions; `None` for zero.
pub(super) fn inverse(number: u64, modulus: u64) -> Option<u64> {
    let modulus = modulus.cast_signed();
    let (mut before, mut rest) = (modulus, number.cast_signed());
    let (mut factor_before, mut factor) = (0_i64, 1_i64);
    while rest != 0 {
        let quotient = before / rest;
        (before, rest) = (rest, before - quotient * rest);
        (factor_before, factor) = (factor, factor_before - quotient * factor);
    }
    (number != 0).then(|| factor_before.rem_euclid(modulus).cast_unsigned())
}

/// Returns the fraction a/b with a value modulo P, if there is one with small a and b. It is then
/// unique (Wang's rational reconstruction).
pub(super) fn fraction(value: u64) -> Option<(i64, i64)> {
    const SMALL: i64 = 1 << 29;
    let (mut before, mut rest) = (P.cast_signed(), value.cast_signed());
    let (mut below_before, mut below) = (0_i64, 1_i64);
    while rest >= SMALL {
        let quotient = before / rest;
        (before, rest) = (rest, before - quotient * rest);
        (below_before, below) = (below, below_before - quotient * below);
    }
    (below.abs() < SMALL).then_some((rest, below))
}

/// Mixes bits so that each depends on all input bits (splitmix64).
fn mixed(bits: u64, more: u64) -> u64 {
    let mut z = bits.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ more.wrapping_add(0xD1B5_4A32_D192_ED03);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Values at a point that occur in an expression again and again.
#[derive(Default)]
struct Known {
    /// Of shared parts, by their digests.
    parts: FxHashMap<u128, Option<Value>>,
    /// Of functions, by their arguments.
    calls: FxHashMap<(Function, Vec<Value>), Option<Value>>,
}

/// A random value for every symbol.
pub(super) struct Point {
    pub(super) point: u64,
}

impl Point {
    pub(super) fn random(&self, words: &[u64]) -> Value {
        let bits = words.iter().fold(mixed(self.point, words.len() as u64), |b, w| mixed(b, *w));
        Value { p: bits % P, q: mixed(bits, 1) % Q }
    }

    pub(super) fn symbol(&self, symbol: Symbol) -> Value {
        let (kind, id) = match symbol {
            Symbol::Pi => (0, 0),
            Symbol::Time => (1, 0),
            Symbol::Coordinate(id) => (2, id.0),
            Symbol::Velocity(id) => (3, id.0),
            Symbol::Acceleration(id) => (4, id.0),
            Symbol::Multiplier(id) => (5, id.0),
            Symbol::FirstOrder(id) => (6, id.0),
            Symbol::Parameter(id) => (7, id.0),
            Symbol::Handed(id) => (8, id.0),
            Symbol::Helper(id) => (9, id.0),
            Symbol::Unloaded(id) => (10, id.0),
        };
        self.random(&[kind, u64::from(id)])
    }

    /// Returns the value of an expression; `None` if it divides by zero.
    pub(super) fn value(&self, expr: &Expr) -> Option<Value> {
        let mut known = Known::default();
        for part in Shared::within(expr, |_| false) {
            let value = self.value_by(part.definition(), &mut known);
            known.parts.insert(part.digest(), value);
        }
        self.value_by(expr, &mut known)
    }

    /// Returns the same; `known` holds values at this point.
    fn value_by(&self, expr: &Expr, known: &mut Known) -> Option<Value> {
        match expr {
            Expr::Number(number) => Value::of(number),
            Expr::Symbol(symbol) => Some(self.symbol(*symbol)),
            Expr::Sum(terms) => terms
                .iter()
                .try_fold(Value::ZERO, |sum, term| Some(sum.plus(self.value_by(term, known)?))),
            Expr::Product(factors) => factors.iter().try_fold(Value::ONE, |product, factor| {
                Some(product.times(self.value_by(factor, known)?))
            }),
            Expr::Power(base, exponent) => {
                let base = self.value_by(base, known)?;
                if let Expr::Number(number) = &**exponent {
                    return self.power(base, number);
                }
                let exponent = self.value_by(exponent, known)?;
                Some(self.opaque(100, &[base, exponent]))
            }
            Expr::Call(function, arguments) => {
                let arguments: Option<Vec<Value>> =
                    arguments.iter().map(|argument| self.value_by(argument, known)).collect();
                let call = (*function, arguments?);
                if let Some(value) = known.calls.get(&call) {
                    return *value;
                }
                let value = self.call(*function, &call.1);
                known.calls.insert(call, value);
                value
            }
            Expr::Shared(shared) => known.parts.get(&shared.digest()).copied().flatten(),
        }
    }

    pub(super) fn power(&self, base: Value, exponent: &BigRational) -> Option<Value> {
        let root = match exponent.denom().to_u64() {
            Some(1) => base,
            Some(denominator) if !base.is_zero() => self.root(base, denominator),
            _ => base,
        };
        root.power(exponent.numer())
    }

    fn root(&self, of: Value, degree: u64) -> Value {
        if of == Value::ONE { of } else { self.opaque(200 + degree, &[of]) }
    }

    pub(super) fn call(&self, function: Function, arguments: &[Value]) -> Option<Value> {
        let x = *arguments.first()?;
        let half = |value: Value| Some(value.times(Value { p: 2, q: 2 }.inverse()?));
        let exp = |x: Value| Value { p: raised(GROWTH, x.q, P), ..self.opaque(1, &[x]) };
        // (sum, difference) of e^x and e^-x, or of e^ix and e^-ix over i
        let hyperbolic = |x: Value| exp(x).plus(exp(x.minus()).minus());
        let turn = |x: Value| raised(TURN, x.q, P);
        let cos = |x: Value| Value {
            p: times((turn(x) + turn(x.minus())) % P, (P - 1) / 2 + 1, P),
            ..self.even(2, x)
        };
        let sin = |x: Value| {
            let twice_i = times(2, I, P);
            let difference = (turn(x) + P - turn(x.minus())) % P;
            let q = self.odd(3, x).q;
            Some(Value { p: times(difference, inverse(twice_i, P)?, P), q })
        };
        Some(match function {
            Function::Exp => exp(x),
            Function::Sinh => half(hyperbolic(x))?,
            Function::Cosh => half(exp(x).plus(exp(x.minus())))?,
            Function::Tanh => {
                let sum = exp(x).plus(exp(x.minus()));
                hyperbolic(x).times(sum.inverse()?)
            }
            Function::Sin => sin(x)?,
            Function::Cos => cos(x),
            Function::Tan => sin(x)?.times(cos(x).inverse()?),
            Function::Ln if x.is_zero() => return None,
            Function::Ln if x == Value::ONE => Value::ZERO,
            Function::Sqrt | Function::Floor if x.is_zero() => Value::ZERO,
            Function::Sqrt => self.root(x, 2),
            Function::Abs => self.even(4, x),
            Function::Asin | Function::Atan => {
                self.odd(5 + u64::from(function == Function::Asin), x)
            }
            Function::Ln => self.opaque(7, arguments),
            Function::Acos => self.opaque(8, arguments),
            Function::Floor => self.opaque(10, arguments),
            Function::SelectLess => match arguments {
                // otherwise + (then - otherwise) chi: an expression that is zero for any chi is
                // zero for 0 and 1.
                [a, b, then, otherwise] => {
                    let chi = self.opaque(9, &[a.plus(b.minus())]);
                    otherwise.plus(then.plus(otherwise.minus()).times(chi))
                }
                _ => return None,
            },
            Function::Table { table, order } => {
                let own = self.random(&[300, u64::from(table.0), u64::from(order)]);
                self.opaque(10, &[own, x])
            }
        })
    }

    /// Returns the value of a function without known identities.
    pub(super) fn opaque(&self, function: u64, arguments: &[Value]) -> Value {
        let words = arguments.iter().flat_map(|value| [value.p, value.q]);
        let words: Vec<u64> = std::iter::once(1000 + function).chain(words).collect();
        self.random(&words)
    }

    /// Returns the value of an even function: f(-x) = f(x), with f(0) = 0.
    fn even(&self, function: u64, x: Value) -> Value {
        if x.is_zero() { Value::ZERO } else { self.opaque(function, &[x.min(x.minus())]) }
    }

    /// Returns the value of an odd function: f(-x) = -f(x).
    fn odd(&self, function: u64, x: Value) -> Value {
        let size = self.even(function, x);
        if x <= x.minus() { size } else { size.minus() }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::expr::{CoordinateId, ParameterId};

    fn x() -> Expr {
        Expr::Symbol(Symbol::Coordinate(CoordinateId(0)))
    }
    fn p() -> Expr {
        Expr::Symbol(Symbol::Parameter(ParameterId(0)))
    }
    fn sum<const N: usize>(terms: [Expr; N]) -> Expr {
        Expr::Sum(terms.into())
    }
    fn times(n: i64, expr: Expr) -> Expr {
        Expr::Product(vec![Expr::integer(n), expr])
    }
    fn power(base: Expr, exponent: i64) -> Expr {
        Expr::Power(Box::new(base), Box::new(Expr::integer(exponent)))
    }
    fn call(function: Function, of: Expr) -> Expr {
        Expr::Call(function, vec![of])
    }

    fn select(arguments: [Expr; 4]) -> Expr {
        Expr::Call(Function::SelectLess, arguments.into())
    }

    proptest! {
        #[test]
        fn products_are_those_of_long_division(a in any::<u64>(), b in any::<u64>()) {
            for modulus in [P, Q] {
                for (a, b) in [(a, b), (a, modulus - 1), (modulus - 1 - a % 9, modulus - 1 - b % 9)] {
                    let (a, b) = (a % modulus, b % modulus);
                    let wanted = u128::from(a) * u128::from(b) % u128::from(modulus);
                    prop_assert_eq!(u128::from(super::times(a, b, modulus)), wanted);
                }
            }
        }
    }

    #[test]
    fn what_is_zero_is_found_to_be() {
        let minus = |a: Expr, b: Expr| sum([a, times(-1, b)]);
        let both = || sum([x(), p()]);
        let square = sum([power(x(), 2), times(2, Expr::Product(vec![x(), p()])), power(p(), 2)]);
        let [sin, cos] = [Function::Sin, Function::Cos];
        let product = |a: Expr, b: Expr| Expr::Product(vec![a, b]);
        for zero in [
            minus(p(), p()),
            minus(power(both(), 2), square),
            minus(product(x(), power(x(), -1)), Expr::integer(1)),
            minus(sum([power(call(sin, x()), 2), power(call(cos, x()), 2)]), Expr::integer(1)),
            minus(
                call(sin, both()),
                sum([
                    product(call(sin, x()), call(cos, p())),
                    product(call(cos, x()), call(sin, p())),
                ]),
            ),
            sum([call(sin, x()), call(sin, times(-1, x()))]),
            sum([call(Function::Atan, x()), call(Function::Atan, times(-1, x()))]),
            minus(
                product(call(Function::Exp, x()), call(Function::Exp, p())),
                call(Function::Exp, both()),
            ),
            call(sin, minus(x(), x())),
            call(Function::Ln, Expr::integer(1)),
            minus(
                product(p(), select([x(), p(), power(x(), 2), x()])),
                select([x(), p(), product(p(), power(x(), 2)), product(x(), p())]),
            ),
            minus(
                power(call(Function::Cosh, x()), 2),
                sum([power(call(Function::Sinh, x()), 2), Expr::integer(1)]),
            ),
        ] {
            assert_eq!(identity(&zero), Identity::Zero, "{zero:?}");
        }
    }

    #[test]
    fn what_is_not_zero_is_not_found_to_be() {
        for other in [
            x(),
            sum([x(), p()]),
            call(Function::Cos, sum([x(), times(-1, x())])),
            select([x(), p(), Expr::integer(0), x()]),
            sum([select([x(), p(), p(), x()]), times(-1, select([p(), x(), p(), x()]))]),
            sum([power(x(), 64), times(-1, power(x(), 63))]),
            sum([call(Function::Sqrt, power(x(), 2)), times(-1, x())]),
            sum([call(Function::Exp, x()), times(-1, call(Function::Exp, p()))]),
        ] {
            assert_eq!(identity(&other), Identity::NotZero, "{other:?}");
        }
    }

    #[test]
    fn what_divides_by_zero_has_no_value() {
        let zero = || sum([p(), times(-1, p())]);
        for undefined in [
            power(zero(), -1),
            call(Function::Ln, zero()),
            Expr::Product(vec![zero(), power(zero(), -2)]),
        ] {
            assert_eq!(identity(&undefined), Identity::Undefined, "{undefined:?}");
        }
        assert!(!are_equal(&power(zero(), -1), &power(zero(), -1)));
        assert!(are_equal(&x(), &x()));
    }
}

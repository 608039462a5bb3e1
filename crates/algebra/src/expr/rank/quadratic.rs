//! Values at a point of expressions that are quadratic in the velocities, with all their coefficients
//! at once.

use std::collections::BTreeMap;

use num_traits::{One as _, ToPrimitive as _};
use rustc_hash::FxHashMap;

use super::super::identity::{P, Point, Value, times};
use super::super::{Expr, Shared, Symbol};

/// Value of an expression: c + sum of b_i v_i + sum of a_ij v_i v_j over i <= j.
#[derive(Clone)]
pub(super) enum Form {
    /// Without velocities.
    Constant(Value),
    Moving(Quadratic),
}

/// Coefficients modulo P.
#[derive(Clone, Default)]
pub(super) struct Quadratic {
    constant: u64,
    linear: BTreeMap<u32, u64>,
    pub(super) square: BTreeMap<(u32, u32), u64>,
}

/// Evaluation at a point.
pub(super) struct Forms<'p> {
    point: &'p Point,
    /// Shared parts by their digests.
    known: FxHashMap<u128, Option<Form>>,
}

impl<'p> Forms<'p> {
    /// Evaluates the parts that an expression shares.
    pub(super) fn new(point: &'p Point, expr: &Expr) -> Self {
        let mut forms = Self { point, known: FxHashMap::default() };
        for part in Shared::within(expr, |_| false) {
            let form = forms.of(part.definition());
            forms.known.insert(part.digest(), form);
        }
        forms
    }

    /// Returns the value of an expression; `None` if it has none, or if it is not built from sums,
    /// products and squares of forms.
    pub(super) fn of(&self, expr: &Expr) -> Option<Form> {
        Some(match expr {
            Expr::Number(number) => Form::Constant(Value::of(number)?),
            Expr::Symbol(Symbol::Velocity(id)) => {
                let linear = BTreeMap::from([(id.0, 1)]);
                Form::Moving(Quadratic { linear, ..Quadratic::default() })
            }
            Expr::Symbol(symbol) => Form::Constant(self.point.symbol(*symbol)),
            Expr::Sum(terms) => {
                let mut sum = Form::Constant(Value::ZERO);
                for term in terms {
                    sum = sum.plus(self.of(term)?);
                }
                sum
            }
            Expr::Product(factors) => {
                let mut product = Form::Constant(Value::ONE);
                for factor in factors {
                    product = product.times(&self.of(factor)?)?;
                }
                product
            }
            Expr::Power(base, exponent) => match (self.of(base)?, &**exponent) {
                (Form::Constant(base), Expr::Number(number)) => {
                    Form::Constant(self.point.power(base, number)?)
                }
                (Form::Constant(base), exponent) => {
                    let Form::Constant(exponent) = self.of(exponent)? else { return None };
                    Form::Constant(self.point.opaque(100, &[base, exponent]))
                }
                (base, Expr::Number(number)) if number.denom().is_one() => {
                    match number.numer().to_u32()? {
                        0 => Form::Constant(Value::ONE),
                        1 => base,
                        2 => base.times(&base)?,
                        _ => return None,
                    }
                }
                _ => return None,
            },
            Expr::Call(function, arguments) => {
                let value = |argument| match self.of(argument)? {
                    Form::Constant(value) => Some(value),
                    Form::Moving(_) => None,
                };
                let arguments: Option<Vec<Value>> = arguments.iter().map(value).collect();
                Form::Constant(self.point.call(*function, &arguments?)?)
            }
            Expr::Shared(shared) => return self.known.get(&shared.digest()).cloned().flatten(),
        })
    }
}

impl Form {
    fn plus(self, other: Self) -> Self {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => Self::Constant(a.plus(b)),
            (Self::Constant(a), Self::Moving(mut form))
            | (Self::Moving(mut form), Self::Constant(a)) => {
                form.constant = (form.constant + a.p) % P;
                Self::Moving(form)
            }
            (Self::Moving(mut form), Self::Moving(other)) => {
                form.constant = (form.constant + other.constant) % P;
                other.linear.into_iter().for_each(|(id, value)| add(&mut form.linear, id, value));
                other.square.into_iter().for_each(|(ids, value)| add(&mut form.square, ids, value));
                Self::Moving(form)
            }
        }
    }

    /// Returns the product; `None` if it is not quadratic.
    fn times(&self, other: &Self) -> Option<Self> {
        let (a, b) = match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => return Some(Self::Constant(a.times(*b))),
            (Self::Constant(a), Self::Moving(form)) | (Self::Moving(form), Self::Constant(a)) => {
                return Some(Self::Moving(form.scaled(a.p)));
            }
            (Self::Moving(a), Self::Moving(b)) => (a, b),
        };
        let is_linear = |form: &Quadratic| form.square.values().all(|value| *value == 0);
        let is_constant =
            |form: &Quadratic| is_linear(form) && form.linear.values().all(|value| *value == 0);
        if !(is_linear(a) && is_linear(b) || is_constant(a) || is_constant(b)) {
            return None;
        }
        let Self::Moving(mut product) =
            Self::Moving(a.scaled(b.constant)).plus(Self::Moving(b.scaled(a.constant)))
        else {
            return None;
        };
        product.constant = times(a.constant, b.constant, P);
        for (i, of_a) in &a.linear {
            for (j, of_b) in &b.linear {
                add(&mut product.square, (*i.min(j), *i.max(j)), times(*of_a, *of_b, P));
            }
        }
        Some(Self::Moving(product))
    }
}

impl Quadratic {
    fn scaled(&self, factor: u64) -> Self {
        let scaled = |value: &u64| times(*value, factor, P);
        Self {
            constant: scaled(&self.constant),
            linear: self.linear.iter().map(|(id, value)| (*id, scaled(value))).collect(),
            square: self.square.iter().map(|(ids, value)| (*ids, scaled(value))).collect(),
        }
    }
}

fn add<K: Ord>(to: &mut BTreeMap<K, u64>, key: K, value: u64) {
    let entry = to.entry(key).or_default();
    *entry = (*entry + value) % P;
}

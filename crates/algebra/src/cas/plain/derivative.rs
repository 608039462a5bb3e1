//! Partial derivatives of normal forms.

use num_rational::BigRational;

use super::normal::{call, power, product, sum};
use crate::expr::{Expr, Function, Symbol};

/// Returns the partial derivative by one symbol.
pub(in crate::cas) fn derivative(expr: &Expr, by: Symbol) -> Expr {
    match expr {
        Expr::Number(_) => Expr::integer(0),
        Expr::Symbol(symbol) => Expr::integer(i64::from(*symbol == by)),
        Expr::Sum(terms) => sum(terms.iter().map(|term| derivative(term, by))),
        Expr::Product(factors) => {
            let terms = (0..factors.len()).filter_map(|index| {
                let slope = derivative(&factors[index], by);
                (!slope.is_zero()).then(|| {
                    let others = factors.iter().enumerate().filter(|(other, _)| *other != index);
                    product(others.map(|(_, factor)| factor.clone()).chain([slope]))
                })
            });
            sum(terms)
        }
        Expr::Power(base, exponent) => of_power(base, exponent, by),
        Expr::Call(function, arguments) => of_call(*function, arguments, by),
        Expr::Shared(shared) => shared.slope(by, |definition| derivative(definition, by)),
    }
}

/// d(b^e) = e b^(e - 1) db + b^e ln(b) de
fn of_power(base: &Expr, exponent: &Expr, by: Symbol) -> Expr {
    let mut terms = Vec::new();
    let of_base = derivative(base, by);
    if !of_base.is_zero() {
        let less = sum([exponent.clone(), Expr::integer(-1)]);
        terms.push(product([exponent.clone(), power(base.clone(), less), of_base]));
    }
    let of_exponent = derivative(exponent, by);
    if !of_exponent.is_zero() {
        let logarithm = call(Function::Ln, vec![base.clone()]);
        terms.push(product([power(base.clone(), exponent.clone()), logarithm, of_exponent]));
    }
    sum(terms)
}

fn of_call(function: Function, arguments: &[Expr], by: Symbol) -> Expr {
    let slope = derivative(&arguments[0], by);
    if function == Function::SelectLess {
        // Only the branches: the solver stops at the discontinuity.
        let mut sides = arguments[..2].to_vec();
        sides.extend(arguments[2..].iter().map(|branch| derivative(branch, by)));
        return call(function, sides);
    }
    if slope.is_zero() {
        return slope;
    }
    product([outer(function, &arguments[0]), slope])
}

/// f'(x)
fn outer(function: Function, x: &Expr) -> Expr {
    let of = |function| call(function, vec![x.clone()]);
    let squared = |expr| power(expr, Expr::integer(2));
    let minus = |expr| product([Expr::integer(-1), expr]);
    let inverse = |expr| power(expr, Expr::integer(-1));
    let one = || Expr::integer(1);
    let one_minus_square = || sum([one(), minus(squared(x.clone()))]);
    match function {
        Function::Sqrt => {
            let half = Expr::Number(BigRational::new(1.into(), 2.into()));
            product([half, inverse(of(Function::Sqrt))])
        }
        Function::Abs => {
            let sides = vec![x.clone(), Expr::integer(0), Expr::integer(-1), one()];
            call(Function::SelectLess, sides)
        }
        Function::Floor => Expr::integer(0),
        Function::Exp => of(Function::Exp),
        Function::Ln => inverse(x.clone()),
        Function::Sin => of(Function::Cos),
        Function::Cos => minus(of(Function::Sin)),
        Function::Tan => sum([one(), squared(of(Function::Tan))]),
        Function::Asin => inverse(call(Function::Sqrt, vec![one_minus_square()])),
        Function::Acos => minus(inverse(call(Function::Sqrt, vec![one_minus_square()]))),
        Function::Atan => inverse(sum([one(), squared(x.clone())])),
        Function::Sinh => of(Function::Cosh),
        Function::Cosh => of(Function::Sinh),
        Function::Tanh => sum([one(), minus(squared(of(Function::Tanh)))]),
        Function::Table { table, order } => of(Function::Table { table, order: order + 1 }),
        Function::SelectLess => unreachable!("differentiated branch by branch"),
    }
}

//! Conversion of `Expr` to `Atom` and back.

use num_rational::BigRational;
use num_traits::{Signed as _, ToPrimitive, Zero};
use symbolica::atom::{Atom, AtomCore, AtomView, Symbol as CasSymbol};
use symbolica::coefficient::CoefficientView;

use super::functions::{Called, Vocabulary};
use crate::expr::{Expr, Function};
use machinist_model::TableId;

/// Converts an expression to one of Symbolica.
pub(super) fn to_atom(vocabulary: &mut Vocabulary, expr: &Expr) -> Atom {
    match expr {
        Expr::Number(value) => number(value),
        Expr::Symbol(symbol) => vocabulary.variable(*symbol).to_atom(),
        // Symbolica has no shared parts. Scenes with bodies are derived by our own algebra.
        Expr::Shared(shared) => to_atom(vocabulary, shared.definition()),
        Expr::Sum(terms) => {
            let terms: Vec<Atom> = terms.iter().map(|term| to_atom(vocabulary, term)).collect();
            sum(terms)
        }
        Expr::Product(factors) => {
            let factors: Vec<Atom> = factors.iter().map(|f| to_atom(vocabulary, f)).collect();
            factors.iter().fold(Atom::num(1), |product, factor| product * factor)
        }
        Expr::Power(base, exponent) => power(vocabulary, base, exponent),
        Expr::Call(function, arguments) => {
            let arguments: Vec<Atom> = arguments.iter().map(|a| to_atom(vocabulary, a)).collect();
            if *function == Function::Ln && arguments[0].is_zero() {
                return undefined(vocabulary);
            }
            vocabulary.call(*function, &arguments)
        }
    }
}

/// Returns the sum of many terms, added in pairs, because each addition copies its operands.
pub(super) fn sum(mut terms: Vec<Atom>) -> Atom {
    while terms.len() > 1 {
        let pairs = terms.chunks(2);
        terms = pairs
            .map(|pair| match pair {
                [a, b] => a + b,
                pair => pair[0].clone(),
            })
            .collect();
    }
    terms.pop().unwrap_or_default()
}

/// Returns a placeholder for a quotient or logarithm of zero, which Symbolica must not see.
fn undefined(vocabulary: &mut Vocabulary) -> Atom {
    vocabulary.undefined = true;
    Atom::new()
}

fn number(value: &BigRational) -> Atom {
    match (value.numer().to_i64(), value.denom().to_i64()) {
        (Some(numerator), Some(denominator)) => Atom::num((numerator, denominator)),
        _ => big_number(value),
    }
}

/// Converts a number beyond 64 bits by its decimal digits, the only exact form that both sides
/// share.
fn big_number(value: &BigRational) -> Atom {
    let signed = |text: &str| match text.strip_prefix('-') {
        Some(rest) => -digits(rest.as_bytes()),
        None => digits(text.as_bytes()),
    };
    signed(&value.numer().to_string()) / signed(&value.denom().to_string())
}

/// Converts digits by halves, so that most of the work is on short numbers: digit by digit, a
/// number of ten thousand digits takes minutes.
fn digits(text: &[u8]) -> Atom {
    let nines = 18;
    if text.len() <= nines {
        return Atom::num(text.iter().fold(0_i64, |n, d| n * 10 + i64::from(d - b'0')));
    }
    let (high, low) = text.split_at(text.len() / 2);
    digits(high) * Atom::num(10).pow(low.len() as i64) + digits(low)
}

/// Converts a power. Half-integer powers become powers of `sqrt`, which Symbolica does not rewrite;
/// it would simplify (x^2)^(1/2) to x.
fn power(vocabulary: &mut Vocabulary, base: &Expr, exponent: &Expr) -> Atom {
    let base = to_atom(vocabulary, base);
    if base.is_zero() && !matches!(exponent, Expr::Number(value) if value.is_positive()) {
        return undefined(vocabulary);
    }
    if let Expr::Number(value) = exponent
        && *value.denom() == 2.into()
        && let Some(numerator) = value.numer().to_i64()
    {
        return vocabulary.call(Function::Sqrt, &[base]).pow(Atom::num(numerator));
    }
    let exponent = to_atom(vocabulary, exponent);
    base.pow(exponent)
}

/// Converts an expression of Symbolica to ours, in our own order.
pub(super) fn to_expr(vocabulary: &Vocabulary, view: AtomView<'_>) -> Expr {
    match view {
        AtomView::Num(value) => Expr::Number(rational(value.get_coeff_view(), view)),
        AtomView::Var(variable) if variable.get_symbol() == CasSymbol::E => {
            Expr::Call(Function::Exp, vec![Expr::Number(BigRational::from_integer(1.into()))])
        }
        AtomView::Var(variable) => match vocabulary.symbol(variable.get_symbol()) {
            Some(symbol) => Expr::Symbol(symbol),
            None => unreachable!("every variable is ours: {}", variable.get_symbol()),
        },
        AtomView::Add(sum) => sum_of(sum.iter().map(|term| to_expr(vocabulary, term)).collect()),
        AtomView::Mul(product) => {
            product_of(product.iter().map(|factor| to_expr(vocabulary, factor)).collect())
        }
        AtomView::Pow(power) => {
            let (base, exponent) = power.get_base_exp();
            if matches!(base, AtomView::Var(e) if e.get_symbol() == CasSymbol::E) {
                return Expr::Call(Function::Exp, vec![to_expr(vocabulary, exponent)]);
            }
            let base = to_expr(vocabulary, base);
            Expr::Power(Box::new(base), Box::new(to_expr(vocabulary, exponent)))
        }
        AtomView::Fun(function) => {
            let arguments = || function.iter().map(|a| to_expr(vocabulary, a));
            match vocabulary.function(function.get_symbol()) {
                Some(Called::Plain(name)) => Expr::Call(name, arguments().collect()),
                Some(Called::SelectLess) => Expr::Call(Function::SelectLess, arguments().collect()),
                Some(Called::Table) => {
                    let all: Vec<Expr> = arguments().collect();
                    table(all)
                }
                None => unreachable!("every function is ours: {}", function.get_symbol()),
            }
        }
    }
}

fn table(arguments: Vec<Expr>) -> Expr {
    let index = |expr: &Expr| match expr {
        Expr::Number(value) => value.numer().to_u32().unwrap_or(0),
        _ => 0,
    };
    let (id, order) = (index(&arguments[0]), index(&arguments[1]));
    let function = Function::Table { table: TableId(id), order };
    Expr::Call(function, arguments.into_iter().skip(2).collect())
}

fn rational(value: CoefficientView<'_>, view: AtomView<'_>) -> BigRational {
    if let CoefficientView::Natural(numerator, denominator, 0, _) = value {
        return BigRational::new(numerator.into(), denominator.into());
    }
    match view.to_plain_string().parse::<BigRational>() {
        Ok(value) => value,
        Err(_) => unreachable!("expressions hold real rational numbers only: {view}"),
    }
}

/// Returns a sum in our order, with the branches of `select_less` joined again:
/// `select_less(a, b, 1, 0) x + select_less(a, b, 0, 1) y` is `select_less(a, b, x, y)`, which
/// never multiplies the branch that is not selected.
fn sum_of(terms: Vec<Expr>) -> Expr {
    let mut plain = Vec::new();
    let mut selected: Vec<([Expr; 2], Vec<Expr>, Vec<Expr>)> = Vec::new();
    for term in terms {
        match branch_of(term) {
            Ok(Branch { sides, then, value }) => {
                let known = selected.iter().position(|(known, _, _)| *known == sides);
                let at = known.unwrap_or_else(|| {
                    selected.push((sides, vec![], vec![]));
                    selected.len() - 1
                });
                if then { &mut selected[at].1 } else { &mut selected[at].2 }.push(value);
            }
            Err(term) => plain.push(term),
        }
    }
    for ([lhs, rhs], then, otherwise) in selected {
        let sides = vec![lhs, rhs, sum_of(then), sum_of(otherwise)];
        plain.push(Expr::Call(Function::SelectLess, sides));
    }
    plain.sort();
    match plain.len() {
        0 => Expr::Number(BigRational::zero()),
        1 => plain.swap_remove(0),
        _ => Expr::Sum(plain),
    }
}

/// Returns a product in our order; a one-sided `select_less` absorbs the other factors.
fn product_of(mut factors: Vec<Expr>) -> Expr {
    factors.sort();
    let product = Expr::Product(factors);
    match branch_of(product) {
        Ok(Branch { sides: [lhs, rhs], then, value }) => {
            let zero = Expr::Number(BigRational::zero());
            let (x, y) = if then { (value, zero) } else { (zero, value) };
            Expr::Call(Function::SelectLess, vec![lhs, rhs, x, y])
        }
        Err(product) => product,
    }
}

/// `value` if the comparison of `sides` is equal to `then`, else 0.
struct Branch {
    sides: [Expr; 2],
    then: bool,
    value: Expr,
}

/// Reads a term as a one-sided selection, or returns it unchanged as the error.
fn branch_of(term: Expr) -> Result<Branch, Expr> {
    let is = |expr: &Expr, n: i64| matches!(expr, Expr::Number(v) if *v == BigRational::from_integer(n.into()));
    let one_sided = |expr: &Expr| match expr {
        Expr::Call(Function::SelectLess, a) => is(&a[2], 0) != is(&a[3], 0),
        _ => false,
    };
    match term {
        Expr::Call(Function::SelectLess, mut a) if is(&a[2], 0) != is(&a[3], 0) => {
            let then = is(&a[3], 0);
            let value = a.swap_remove(if then { 2 } else { 3 });
            a.truncate(2);
            match <[Expr; 2]>::try_from(a) {
                Ok(sides) => Ok(Branch { sides, then, value }),
                Err(_) => unreachable!("a selection has two sides"),
            }
        }
        Expr::Product(mut factors) => match factors.iter().position(one_sided) {
            None => Err(Expr::Product(factors)),
            Some(at) => {
                let selection = factors.remove(at);
                let mut branch = branch_of(selection)?;
                if !is(&branch.value, 1) {
                    factors.push(branch.value);
                }
                factors.sort();
                branch.value =
                    if factors.len() == 1 { factors.remove(0) } else { Expr::Product(factors) };
                Ok(branch)
            }
        },
        term => Err(term),
    }
}

//! Replacement of parameters that the scene fixes by exact numbers, which are folded.

use std::collections::BTreeSet;

use machinist_algebra::expr::identity::{Identity, identity};
use machinist_algebra::expr::{Expr, Function, ParameterId, Symbol};
use machinist_algebra::unless_faulty;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Pow, Signed};

use super::Step;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::LagrangianSystem;

/// Returns the equations with numbers in place of fixed parameters.
pub(super) fn fix(equations: EquationsOfMotion) -> Step {
    let parameters = (0..).map(ParameterId).zip(&equations.system.parameters);
    let fixed = parameters.filter(|(_, p)| !p.tunable && p.value.is_finite());
    let mut fixed: BTreeSet<ParameterId> = fixed.map(|(id, _)| id).collect();
    loop {
        if fixed.is_empty() {
            return Step::Equations(equations);
        }
        let singular = singular(&equations.system, &fixed);
        if singular.is_empty() {
            break;
        }
        // As a number the parameter would divide by zero. A run may change it, or never reach
        // that term.
        fixed.retain(|id| !singular.contains(id));
    }
    let reduction = equations.reduction;
    let mut system = equations.system;
    let values: Vec<f64> = system.parameters.iter().map(|parameter| parameter.value).collect();
    for expr in system.exprs_mut() {
        *expr = expr.replace(&|symbol| number(symbol, &fixed, &values));
    }
    for (id, parameter) in (0..).map(ParameterId).zip(&mut system.parameters) {
        parameter.tunable = !fixed.contains(&id);
    }
    Step::System(system, reduction)
}

fn number(symbol: Symbol, fixed: &BTreeSet<ParameterId>, values: &[f64]) -> Option<Expr> {
    match symbol {
        Symbol::Parameter(id) if fixed.contains(&id) => {
            let value = exact(values[id.0 as usize]);
            Some(Expr::Number(unless_faulty!("numbers in place of parameters", value, -value)))
        }
        _ => None,
    }
}

/// Returns the fixed parameters that make a denominator or the argument of a logarithm zero.
fn singular(system: &LagrangianSystem, fixed: &BTreeSet<ParameterId>) -> BTreeSet<ParameterId> {
    let values: Vec<f64> = system.parameters.iter().map(|parameter| parameter.value).collect();
    let mut system = system.clone();
    let mut dangerous: Vec<Expr> = Vec::new();
    Expr::visit_all(system.exprs_mut().into_iter().map(|expr| &*expr), &mut |part| match part {
        Expr::Power(base, exponent) => {
            let positive = matches!(&**exponent, Expr::Number(n) if n.is_positive());
            if !positive {
                dangerous.push((**base).clone());
            }
        }
        Expr::Call(Function::Ln, arguments) => dangerous.extend(arguments.iter().cloned()),
        _ => {}
    });
    // Inner parts first, so that no composed one divides by zero.
    dangerous.sort_by_key(depth);
    for expr in dangerous {
        let with_numbers = expr.replace(&|symbol| number(symbol, fixed, &values));
        if identity(&with_numbers) != Identity::NotZero {
            let symbols = expr.symbols().into_iter();
            let parameters = symbols.filter_map(|symbol| match symbol {
                Symbol::Parameter(id) => Some(id),
                _ => None,
            });
            return parameters.filter(|id| fixed.contains(id)).collect();
        }
    }
    BTreeSet::new()
}

fn depth(expr: &Expr) -> usize {
    let parts = match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => 0,
        Expr::Sum(parts) | Expr::Product(parts) | Expr::Call(_, parts) => {
            parts.iter().map(depth).max().unwrap_or(0)
        }
        Expr::Power(base, exponent) => depth(base).max(depth(exponent)),
    };
    parts + 1
}

/// Returns exactly the shortest decimal that reads back as `value`, as in the spec.
fn exact(value: f64) -> BigRational {
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: BigInt = format!("{whole}{decimals}").parse().unwrap_or_default();
    let exponent = exponent.parse().unwrap_or(0) - decimals.len() as i32;
    let power = Pow::pow(BigInt::from(10), exponent.unsigned_abs());
    if exponent < 0 {
        BigRational::new(digits, power)
    } else {
        BigRational::from_integer(digits * power)
    }
}

#[cfg(test)]
mod tests {
    use super::exact;
    use num_traits::ToPrimitive as _;

    #[test]
    fn a_number_is_the_decimal_of_the_spec() {
        assert_eq!(exact(0.956).to_string(), "239/250");
        assert_eq!(exact(-23065.2).to_string(), "-115326/5");
        assert_eq!(exact(8e10).to_string(), "80000000000");
        assert_eq!(exact(0.0).to_string(), "0");
        for value in [9.817e-6, 1e300, 5e-324, 0.1 + 0.2] {
            assert_eq!(exact(value).to_f64(), Some(value), "{value}");
        }
    }
}

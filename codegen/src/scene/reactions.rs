//! Forces that depend on constraint forces.
//!
//! ```text
//! Q = Q_0 + sum of c_k lambda_k
//! ```
//!
//! c_k may differ by the sign of lambda_k, as for the friction mu |N| of a guide, and depends on no
//! other constraint force. The equations of motion are then linear in q'' and lambda for given
//! signs. A sign is written by [`Symbol::Unloaded`].

use std::collections::{BTreeMap, BTreeSet};

use machinist_algebra::cas::arithmetic::{call, negative, normal_form, product, sum};
use machinist_algebra::expr::{ConstraintId, Expr, Function, Symbol};

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};

/// Q_0 and c_k.
struct Parts {
    rest: Expr,
    by: BTreeMap<ConstraintId, Expr>,
}

/// Returns a force as a sum of products with constraint forces.
///
/// # Errors
/// If it depends on them in another way.
pub(super) fn in_proportion(force: Expr, span: Span) -> Result<Expr, Box<Mistake>> {
    if !reads_reactions(&force) {
        return Ok(force);
    }
    let Some(Parts { rest, by }) = parts(&force) else {
        let message =
            "a force that depends on the force of a constraint must be in proportion to it";
        let help = "write it as a factor times the constraint force, or times its `abs`, its `max` \
                    with 0 or its `min` with 0";
        return Err(Box::new(
            Mistake::new(Code::InvalidForce, span, message, "not in proportion").help(help),
        ));
    };
    let terms = by.into_iter().map(|(id, factor)| product([factor, multiplier(id)]));
    Ok(sum(terms.chain([rest])))
}

/// Returns the constraints by whose signs a force differs.
pub(super) fn signed(force: &Expr) -> BTreeSet<ConstraintId> {
    let of = |symbol| match symbol {
        Symbol::Unloaded(id) => Some(id),
        _ => None,
    };
    force.symbols().into_iter().filter_map(of).collect()
}

fn reads_reactions(expr: &Expr) -> bool {
    expr.mentions(|symbol| matches!(symbol, Symbol::Multiplier(_)))
}

fn multiplier(id: ConstraintId) -> Expr {
    Expr::Symbol(Symbol::Multiplier(id))
}

/// Returns the parts of an expression; `None` if it is not linear for given signs.
fn parts(expr: &Expr) -> Option<Parts> {
    if !reads_reactions(expr) {
        return Some(Parts { rest: expr.clone(), by: BTreeMap::new() });
    }
    match expr {
        Expr::Symbol(Symbol::Multiplier(id)) => {
            Some(Parts { rest: Expr::integer(0), by: BTreeMap::from([(*id, Expr::integer(1))]) })
        }
        Expr::Sum(terms) => {
            let terms: Vec<Parts> = terms.iter().map(parts).collect::<Option<_>>()?;
            let mut by: BTreeMap<ConstraintId, Vec<Expr>> = BTreeMap::new();
            let mut rests = Vec::new();
            for Parts { rest, by: of_term } in terms {
                rests.push(rest);
                for (id, factor) in of_term {
                    by.entry(id).or_default().push(factor);
                }
            }
            let by = by.into_iter().map(|(id, factors)| (id, sum(factors))).collect();
            Some(Parts { rest: sum(rests), by })
        }
        Expr::Product(factors) => {
            let (reading, others): (Vec<&Expr>, Vec<&Expr>) =
                factors.iter().partition(|factor| reads_reactions(factor));
            let [reading] = reading[..] else { return None };
            let other = product(others.into_iter().cloned());
            Some(parts(reading)?.map(|part| product([other.clone(), part])))
        }
        Expr::Call(Function::Abs, arguments) => {
            let (id, factor) = alone(&arguments[0])?;
            let sign = by_sign(&unloaded(id), -1, 1);
            let size = call(Function::Abs, &factor);
            Some(Parts {
                rest: Expr::integer(0),
                by: BTreeMap::from([(id, product([sign, size]))]),
            })
        }
        Expr::Call(Function::SelectLess, arguments) => selected(arguments),
        Expr::Shared(shared) => parts(shared.definition()),
        _ => None,
    }
}

/// Returns the parts of `select_less(a, b, x, y)`.
fn selected(arguments: &[Expr]) -> Option<Parts> {
    let [a, b, x, y] = arguments else { return None };
    let [x, y] = [parts(x)?, parts(y)?];
    let [a, b] = if reads_reactions(a) || reads_reactions(b) {
        // Both are zero where the constraint force is: the force does not jump.
        let (id, factor) = alone(&sum([a.clone(), negative(b)]))?;
        let own = |parts: &Parts| is_zero(&parts.rest) && parts.by.keys().all(|other| *other == id);
        if !own(&x) || !own(&y) {
            return None;
        }
        [product([factor, unloaded(id)]), Expr::integer(0)]
    } else {
        [a.clone(), b.clone()]
    };
    let select =
        |x: Expr, y: Expr| Expr::Call(Function::SelectLess, vec![a.clone(), b.clone(), x, y]);
    let ids: BTreeSet<ConstraintId> = x.by.keys().chain(y.by.keys()).copied().collect();
    let factor = |parts: &Parts, id| parts.by.get(&id).cloned().unwrap_or_else(|| Expr::integer(0));
    Some(Parts {
        rest: if is_zero(&x.rest) && is_zero(&y.rest) {
            Expr::integer(0)
        } else {
            select(x.rest.clone(), y.rest.clone())
        },
        by: ids.into_iter().map(|id| (id, select(factor(&x, id), factor(&y, id)))).collect(),
    })
}

/// Returns the constraint and the factor of an expression c lambda.
fn alone(expr: &Expr) -> Option<(ConstraintId, Expr)> {
    let Parts { rest, mut by } = parts(expr)?;
    let found = by.pop_first()?;
    (by.is_empty() && is_zero(&rest)).then_some(found)
}

fn unloaded(id: ConstraintId) -> Expr {
    Expr::Symbol(Symbol::Unloaded(id))
}

fn by_sign(of: &Expr, negative: i64, positive: i64) -> Expr {
    let [negative, positive] = [negative, positive].map(Expr::integer);
    Expr::Call(Function::SelectLess, vec![of.clone(), Expr::integer(0), negative, positive])
}

fn is_zero(expr: &Expr) -> bool {
    normal_form(expr).is_zero()
}

impl Parts {
    fn map(self, part: impl Fn(Expr) -> Expr) -> Self {
        Parts {
            rest: part(self.rest),
            by: self.by.into_iter().map(|(id, factor)| (id, part(factor))).collect(),
        }
    }
}

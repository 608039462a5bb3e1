//! Directions along which the equations of motion do not change: proposed by
//! elimination at sampled states, accepted by proof.

use num_rational::BigRational;

use crate::cas::{Cas, Form};
use crate::expr::operations;
use crate::expr::{CoordinateId, Expr, Function, ParameterId, Symbol};
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::evaluate;

/// Coordinates beyond which directions of several are not looked for: the cost of
/// elimination grows with the third power, that of its expressions faster.
const MOST_COORDINATES: usize = 32;
/// States and branches at which derivatives are sampled; more would only save
/// proofs that fail.
const SAMPLES: i64 = 4;

/// Constants s_k/s_r along which nothing changes.
#[derive(Debug, Clone)]
pub(super) struct Direction {
    /// The coordinate r that others become relative to.
    pub(super) pivot: CoordinateId,
    /// s_k/s_r of the others, of parameters only, where not zero.
    pub(super) others: Vec<(CoordinateId, Expr)>,
}

impl Direction {
    /// An invariant expression by relative positions.
    pub(super) fn relative(&self, expr: &Expr) -> Expr {
        let pivot = Symbol::Coordinate(self.pivot);
        expr.replace(&|symbol| (symbol == pivot).then(|| Expr::integer(0)))
    }

    /// Any expression by relative positions and the pivot.
    pub(super) fn absolute(&self, expr: &Expr) -> Expr {
        self.shifted(expr, Symbol::Coordinate(self.pivot), false)
    }

    /// q + a s/s_r in place of q; the pivot itself only if asked for.
    fn shifted(&self, expr: &Expr, by: Symbol, with_pivot: bool) -> Expr {
        let one = [(self.pivot, Expr::integer(1))];
        let pivot = one.iter().filter(|_| with_pivot);
        let factors: Vec<&(CoordinateId, Expr)> = self.others.iter().chain(pivot).collect();
        expr.replace(&|symbol| {
            let factor = factors.iter().find(|(id, _)| Symbol::Coordinate(*id) == symbol);
            factor.map(|(_, factor)| {
                let shift = Expr::Product(vec![factor.clone(), Expr::Symbol(by)]);
                Expr::Sum(vec![Expr::Symbol(symbol), shift])
            })
        })
    }

    fn moves(&self, symbol: Symbol) -> bool {
        let mut moved = self.others.iter().map(|(id, _)| *id).chain([self.pivot]);
        moved.any(|id| Symbol::Coordinate(id) == symbol)
    }
}

/// A direction among `live` coordinates along which M, f and h do not change.
pub(super) fn find(
    cas: &mut Cas,
    equations: &EquationsOfMotion,
    live: &[CoordinateId],
) -> Option<Direction> {
    let mentioned = |id: &CoordinateId| {
        let mut dynamics = equations.dynamics();
        dynamics.any(|expr| expr.mentions(|symbol| symbol == Symbol::Coordinate(*id)))
    };
    let (mentioned, free): (Vec<CoordinateId>, Vec<CoordinateId>) =
        live.iter().partition(|id| mentioned(id));
    if let Some(pivot) = free.first() {
        return Some(Direction { pivot: *pivot, others: Vec::new() });
    }
    if mentioned.len() < 2 || mentioned.len() > MOST_COORDINATES {
        return None;
    }
    if has_full_rank(cas, equations, &mentioned) {
        return None;
    }
    let candidates = null_space(cas, equations, &mentioned);
    let directions = candidates.into_iter().map(|s| cheapest(cas, &mentioned, &s));
    let directions: Vec<Direction> = directions.collect();
    directions.into_iter().find(|direction| {
        let mut dynamics = equations.dynamics();
        dynamics.all(|expr| is_invariant(cas, expr, direction))
    })
}

/// Proof that an expression does not change along a direction: with q + a s for q
/// it has the same normal form.
pub(super) fn is_invariant(cas: &mut Cas, expr: &Expr, direction: &Direction) -> bool {
    if !expr.mentions(|symbol| direction.moves(symbol)) {
        return true;
    }
    // A parameter that no scene has.
    let a = Symbol::Parameter(ParameterId(u32::MAX));
    let shifted = direction.shifted(expr, a, true);
    normal_form(cas, &shifted) == normal_form(cas, expr)
}

/// Multiplied out, also within functions and denominators.
fn normal_form(cas: &mut Cas, expr: &Expr) -> Expr {
    let within = normal_within(cas, expr);
    let form = cas.form(&within);
    let expanded = cas.expand(&form);
    cas.expr(&expanded)
}

fn normal_within(cas: &mut Cas, expr: &Expr) -> Expr {
    let mut all = |parts: &[Expr], each: fn(&mut Cas, &Expr) -> Expr| {
        parts.iter().map(|part| each(cas, part)).collect::<Vec<_>>()
    };
    match expr {
        Expr::Number(_) | Expr::Symbol(_) => expr.clone(),
        Expr::Sum(terms) => Expr::Sum(all(terms, normal_within)),
        Expr::Product(factors) => Expr::Product(all(factors, normal_within)),
        Expr::Power(base, exponent) => {
            Expr::Power(Box::new(normal_form(cas, base)), Box::new(normal_form(cas, exponent)))
        }
        Expr::Call(function, arguments) => Expr::Call(*function, all(arguments, normal_form)),
    }
}

/// Whether gradients of M, f and h at sampled states and parameters, as mere numbers,
/// leave no direction that is normal to all: most machines have none, and numbers say so
/// at once.
fn has_full_rank(
    cas: &mut Cas,
    equations: &EquationsOfMotion,
    coordinates: &[CoordinateId],
) -> bool {
    /// A row is rounding below this length, samples being about 1; likewise what rows
    /// before it leave of one of length 1.
    const INDEPENDENT: f64 = 1e-6;
    let parameter = |id: ParameterId| 0.7 + 0.31 * (f64::from(id.0) * 1.7).sin();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for function in changing(equations, coordinates) {
        for sample in 0..SAMPLES {
            let form = cas.form(&on_branches(&function, sample, &mut 0));
            let slope = |id: &CoordinateId| {
                let slope = cas.derivative(&form, Symbol::Coordinate(*id));
                evaluate(&sampled(&cas.expr(&slope), sample), &parameter)
            };
            let mut row: Vec<f64> = coordinates.iter().map(slope).collect();
            if scale(&mut row) < INDEPENDENT {
                continue;
            }
            // Twice, for the first time leaves rounding of what it takes away.
            for known in basis.iter().chain(&basis) {
                let along: f64 = row.iter().zip(known).map(|(a, b)| a * b).sum();
                for (entry, known) in row.iter_mut().zip(known) {
                    *entry -= along * known;
                }
            }
            if scale(&mut row) > INDEPENDENT {
                basis.push(row);
            }
            if basis.len() == coordinates.len() {
                return true;
            }
        }
    }
    false
}

/// Makes a row of length 1, unless it is zero or no number; its length before.
fn scale(row: &mut [f64]) -> f64 {
    let length = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() {
        for entry in row.iter_mut() {
            *entry /= length;
        }
    }
    length
}

/// Directions that gradients of M, f and h with respect to `coordinates` are
/// normal to, at sampled states; each scaled so that one of its entries is 1.
fn null_space(
    cas: &mut Cas,
    equations: &EquationsOfMotion,
    coordinates: &[CoordinateId],
) -> Vec<Vec<Form>> {
    let mut echelon = Echelon::default();
    for function in changing(equations, coordinates) {
        for sample in 0..SAMPLES {
            let form = cas.form(&on_branches(&function, sample, &mut 0));
            let slope = |cas: &mut Cas, id: &CoordinateId| {
                let slope = cas.derivative(&form, Symbol::Coordinate(*id));
                let slope = cas.expr(&slope);
                cas.form(&sampled(&slope, sample))
            };
            let row = coordinates.iter().map(|id| slope(cas, id)).collect();
            echelon.add(cas, row);
            if echelon.rows.len() == coordinates.len() {
                return Vec::new();
            }
        }
    }
    echelon.null_space(cas, coordinates.len())
}

/// M, f, h and the comparisons within them, which derivatives do not see, as far
/// as they mention `coordinates`.
fn changing(equations: &EquationsOfMotion, coordinates: &[CoordinateId]) -> Vec<Expr> {
    let mut functions: Vec<Expr> = Vec::new();
    for expr in equations.dynamics() {
        functions.push(expr.clone());
        expr.visit(&mut |part| {
            if let Expr::Call(Function::SelectLess, sides) = part {
                let minus = Expr::Product(vec![Expr::integer(-1), sides[1].clone()]);
                functions.push(Expr::Sum(vec![sides[0].clone(), minus]));
            }
        });
    }
    let is_position = |symbol| coordinates.iter().any(|id| Symbol::Coordinate(*id) == symbol);
    functions.retain(|function| function.mentions(is_position));
    functions
}

/// The expression where comparisons within it hold or do not, in ways that differ
/// from sample to sample.
fn on_branches(expr: &Expr, sample: i64, seen: &mut i64) -> Expr {
    let mut all = |parts: &[Expr]| {
        parts.iter().map(|part| on_branches(part, sample, seen)).collect::<Vec<_>>()
    };
    match expr {
        Expr::Number(_) | Expr::Symbol(_) => expr.clone(),
        Expr::Sum(terms) => Expr::Sum(all(terms)),
        Expr::Product(factors) => Expr::Product(all(factors)),
        Expr::Power(base, exponent) => {
            let base = Box::new(on_branches(base, sample, seen));
            Expr::Power(base, Box::new(on_branches(exponent, sample, seen)))
        }
        Expr::Call(Function::SelectLess, sides) => {
            let holds = (sample >> (*seen % 2)) % 2 == 0;
            *seen += 1;
            on_branches(&sides[if holds { 2 } else { 3 }], sample, seen)
        }
        Expr::Call(function, arguments) => Expr::Call(*function, all(arguments)),
    }
}

/// The expression with numbers for everything but parameters.
fn sampled(expr: &Expr, sample: i64) -> Expr {
    let value = |kind: i64, id: u32| {
        let numerator = 37 * kind + 11 * i64::from(id) + 101 * sample + 13;
        let denominator = 29 + 2 * i64::from(id) + kind;
        Expr::Number(BigRational::new(numerator.into(), denominator.into()))
    };
    expr.replace(&|symbol| match symbol {
        Symbol::Time => Some(value(1, 0)),
        Symbol::Coordinate(id) => Some(value(2, id.0)),
        Symbol::Velocity(id) => Some(value(3, id.0)),
        Symbol::Acceleration(id) => Some(value(4, id.0)),
        Symbol::FirstOrder(id) => Some(value(5, id.0)),
        Symbol::Multiplier(id) => Some(value(6, id.0)),
        Symbol::Pi | Symbol::Parameter(_) | Symbol::Handed(_) | Symbol::Helper(_) => None,
    })
}

/// Rows in reduced echelon form, each with the place of its leading 1.
#[derive(Default)]
struct Echelon {
    rows: Vec<(usize, Vec<Form>)>,
}

impl Echelon {
    fn add(&mut self, cas: &mut Cas, mut row: Vec<Form>) {
        for (lead, known) in &self.rows {
            subtract(cas, &mut row, *lead, known);
        }
        let Some(lead) = row.iter().position(|entry| !is_zero(cas, entry)) else { return };
        let first = row[lead].clone();
        for entry in &mut row {
            *entry = cas.rational(&(&*entry / &first));
        }
        for (_, known) in &mut self.rows {
            subtract(cas, known, lead, &row);
        }
        self.rows.push((lead, row));
    }

    fn null_space(&self, cas: &mut Cas, columns: usize) -> Vec<Vec<Form>> {
        let is_free = |column: &usize| self.rows.iter().all(|(lead, _)| lead != column);
        let one = cas.form(&Expr::integer(1));
        let vector = |free: usize| {
            let mut vector = vec![cas.zero(); columns];
            vector[free] = one.clone();
            for (lead, row) in &self.rows {
                vector[*lead] = -&row[free];
            }
            vector
        };
        (0..columns).filter(is_free).map(vector).collect()
    }
}

/// row -= row\[lead\] known
fn subtract(cas: &mut Cas, row: &mut [Form], lead: usize, known: &[Form]) {
    let factor = row[lead].clone();
    if is_zero(cas, &factor) {
        return;
    }
    for (entry, known) in row.iter_mut().zip(known) {
        *entry = cas.rational(&(&*entry - &(&factor * known)));
    }
}

fn is_zero(cas: &mut Cas, form: &Form) -> bool {
    form.is_zero() || cas.expand(form).is_zero()
}

/// The direction of a vector with the pivot that makes its factors cheapest.
fn cheapest(cas: &mut Cas, coordinates: &[CoordinateId], s: &[Form]) -> Direction {
    let support: Vec<usize> = (0..s.len()).filter(|k| !is_zero(cas, &s[*k])).collect();
    let mut best: Option<(usize, Direction)> = None;
    // Of equals the last: a twist is the driving angle less the driven one.
    for pivot in support.iter().rev() {
        let others = support.iter().filter(|k| *k != pivot);
        let others: Vec<(CoordinateId, Expr)> = others
            .map(|k| {
                let ratio = cas.rational(&(&s[*k] / &s[*pivot]));
                (coordinates[*k], cas.expr(&ratio))
            })
            .collect();
        let cost = others.iter().map(|(_, factor)| operations(factor)).sum();
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, Direction { pivot: coordinates[*pivot], others }));
        }
    }
    match best {
        Some((_, direction)) => direction,
        None => unreachable!("a vector of a null space has an entry that is 1"),
    }
}

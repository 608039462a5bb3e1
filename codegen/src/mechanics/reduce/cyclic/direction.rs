//! Directions along which the equations of motion do not change, proposed by elimination at
//! sampled states and accepted by proof.

use std::collections::BTreeSet;

use machinist_algebra::cas::{Cas, Form};
use machinist_algebra::expr::{
    CoordinateId, Expr, Function, ParameterId, Symbol, identity, operations,
};
use machinist_algebra::unless_faulty;
use machinist_model::Function as Unary;
use machinist_model::evaluate::call;
use num_rational::BigRational;
use num_traits::{Signed as _, ToPrimitive as _};

use crate::mechanics::lagrange::EquationsOfMotion;

/// Maximum number of coordinates for which directions of several are sought; the cost of
/// elimination grows with the third power.
const MOST_COORDINATES: usize = 32;
/// Number of states and branches at which derivatives are sampled. More would only avoid failing
/// proofs.
const SAMPLES: i64 = 4;
/// Maximum denominator of a ratio that a user would write.
const MOST_PARTS: i64 = 1000;

/// Constants s_k/s_r of a direction along which nothing changes.
#[derive(Debug, Clone)]
pub(super) struct Direction {
    /// The reference coordinate r.
    pub(super) pivot: CoordinateId,
    /// s_k/s_r of the others, as expressions of parameters, if nonzero.
    pub(super) others: Vec<(CoordinateId, Expr)>,
}

impl Direction {
    /// Expresses an invariant expression by relative positions.
    pub(super) fn relative(&self, expr: &Expr) -> Expr {
        let pivot = Symbol::Coordinate(self.pivot);
        expr.replace(&|symbol| (symbol == pivot).then(|| Expr::integer(0)))
    }

    /// Expresses any expression by relative positions and the pivot.
    pub(super) fn absolute(&self, expr: &Expr) -> Expr {
        let by = Symbol::Coordinate(self.pivot);
        unless_faulty!(
            "an output of an absolute position",
            self.shifted(expr, by, false),
            self.relative(expr)
        )
    }

    /// Replaces q by q + a s/s_r; the pivot itself only if `with_pivot`.
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

    /// Reports whether an expression contains a coordinate of the direction.
    pub(super) fn is_in(&self, expr: &Expr) -> bool {
        expr.mentions(|symbol| self.moves(symbol))
    }

    fn moves(&self, symbol: Symbol) -> bool {
        let mut moved = self.others.iter().map(|(id, _)| *id).chain([self.pivot]);
        moved.any(|id| Symbol::Coordinate(id) == symbol)
    }
}

/// Returns the coordinates among `live` that no equation contains.
pub(super) fn free(equations: &EquationsOfMotion, live: &[CoordinateId]) -> Vec<CoordinateId> {
    let mentioned = mentioned(equations);
    live.iter().copied().filter(|id| !mentioned.contains(id)).collect()
}

fn mentioned(equations: &EquationsOfMotion) -> BTreeSet<CoordinateId> {
    let mut mentioned = BTreeSet::new();
    Expr::visit_all(equations.dynamics(), &mut |part| {
        if let Expr::Symbol(Symbol::Coordinate(id)) = part {
            mentioned.insert(*id);
        }
    });
    mentioned
}

/// Finds a direction among `live` coordinates, all of which occur in equations, along which M, f
/// and h do not change.
///
/// Numerical derivatives determine which equations are independent, and whether any direction
/// exists at all; most machines have none. Constant ratios are read off. Only those that depend
/// on parameters are eliminated exactly, from independent equations.
pub(super) fn find(
    cas: &mut Cas,
    equations: &EquationsOfMotion,
    live: &[CoordinateId],
) -> Option<Direction> {
    if live.len() < 2 || live.len() > MOST_COORDINATES {
        return None;
    }
    let functions = changing(equations, live);
    let numbers = Numbers::at(&functions, live, 0)?;
    let directions = match numbers.exact(&Numbers::at(&functions, live, 1)?) {
        Some(directions) => directions,
        None => null_space(cas, &functions, &numbers.rows, live)?,
    };
    let mut directions = directions.into_iter().filter_map(|s| cheapest(cas, live, &s));
    directions.find(|direction| {
        let mut dynamics = equations.dynamics();
        dynamics.all(|expr| is_invariant(expr, direction))
    })
}

/// Proves that an expression does not change along a direction: it is the same with q + a s
/// instead of q.
pub(super) fn is_invariant(expr: &Expr, direction: &Direction) -> bool {
    if !direction.is_in(expr) {
        return true;
    }
    // A parameter that no scene has.
    let a = Symbol::Parameter(ParameterId(u32::MAX));
    identity::are_equal(&direction.shifted(expr, a, true), expr)
}

/// Independent rows and null space of the numerical derivatives of M, f and h by the coordinates.
struct Numbers {
    /// Function and sample of each independent row.
    rows: Vec<(usize, i64)>,
    /// Directions normal to all derivatives, each with an entry that is 1.
    null_space: Vec<Vec<f64>>,
}

impl Numbers {
    /// Returns the numbers at sampled parameters; `None` if there is no direction.
    fn at(functions: &[Expr], coordinates: &[CoordinateId], parameters: u32) -> Option<Self> {
        /// Length below which a row counts as rounding, for samples of about 1; likewise the rest
        /// of a unit row after orthogonalization.
        const INDEPENDENT: f64 = 1e-6;
        let parameter =
            |id: u32| 0.7 + 0.31 * (f64::from(id) * 1.7 + 2.3 * f64::from(parameters)).sin();
        let (mut rows, mut basis) = (Vec::new(), Vec::<Vec<f64>>::new());
        for (index, function) in functions.iter().enumerate() {
            for sample in 0..SAMPLES {
                let mut row = slopes(function, coordinates, sample, &parameter);
                let length = scale(&mut row);
                if length < INDEPENDENT || !length.is_finite() {
                    continue;
                }
                // Twice, because the first pass leaves rounding errors.
                for known in basis.iter().chain(&basis) {
                    let along: f64 = row.iter().zip(known).map(|(a, b)| a * b).sum();
                    for (entry, known) in row.iter_mut().zip(known) {
                        *entry -= along * known;
                    }
                }
                if scale(&mut row) > INDEPENDENT {
                    rows.push((index, sample));
                    basis.push(row);
                }
                if basis.len() == coordinates.len() {
                    return None;
                }
            }
        }
        Some(Numbers { rows, null_space: null_space_of(basis, coordinates.len()) })
    }

    /// Returns the directions if all their entries are numbers that do not depend on parameters.
    fn exact(&self, other: &Numbers) -> Option<Vec<Vec<Expr>>> {
        if self.null_space.len() != other.null_space.len() {
            return None;
        }
        let pairs = self.null_space.iter().zip(&other.null_space);
        let vectors = pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| fraction(*a, *b)).collect());
        vectors.collect()
    }
}

/// Returns the fraction that both are close to.
fn fraction(a: f64, b: f64) -> Option<Expr> {
    const ROUNDING: f64 = 1e-9;
    let near = |parts: &i64| {
        let whole = (a * *parts as f64).round();
        let value = whole / *parts as f64;
        let room = ROUNDING * a.abs().max(1.0);
        ((a - value).abs() < room && (b - value).abs() < room).then_some((whole, *parts))
    };
    let (whole, parts) = (1..=MOST_PARTS).find_map(|parts| near(&parts))?;
    Some(Expr::Number(BigRational::new((whole as i64).into(), parts.into())))
}

/// Returns the directions normal to all rows, by Gauss-Jordan elimination.
fn null_space_of(mut rows: Vec<Vec<f64>>, columns: usize) -> Vec<Vec<f64>> {
    const ROUNDING: f64 = 1e-7;
    let mut leads = Vec::new();
    for column in 0..columns {
        let done = leads.len();
        let size = |row: &Vec<f64>| row[column].abs();
        let best = (done..rows.len()).max_by(|a, b| size(&rows[*a]).total_cmp(&size(&rows[*b])));
        let Some(best) = best.filter(|best| size(&rows[*best]) > ROUNDING) else { continue };
        rows.swap(done, best);
        let lead = rows[done][column];
        rows[done].iter_mut().for_each(|entry| *entry /= lead);
        let row = rows[done].clone();
        for other in rows.iter_mut().enumerate().filter(|(index, _)| *index != done) {
            let factor = other.1[column];
            other.1.iter_mut().zip(&row).for_each(|(entry, known)| *entry -= factor * known);
        }
        leads.push(column);
    }
    let vector = |free: usize| {
        let mut vector = vec![0.0; columns];
        vector[free] = 1.0;
        for (lead, row) in leads.iter().zip(&rows) {
            vector[*lead] = -row[free];
        }
        vector
    };
    (0..columns).filter(|column| !leads.contains(column)).map(vector).collect()
}

/// Scales a row to length 1, unless it is zero or not finite, and returns its former length.
fn scale(row: &mut [f64]) -> f64 {
    let length = row.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() {
        for entry in row.iter_mut() {
            *entry /= length;
        }
    }
    length
}

/// Returns the directions normal to the derivatives in independent rows, as expressions of
/// parameters; `None` if the algebra exceeds its cost limit.
fn null_space(
    cas: &mut Cas,
    functions: &[Expr],
    rows: &[(usize, i64)],
    coordinates: &[CoordinateId],
) -> Option<Vec<Vec<Expr>>> {
    let mut echelon = Echelon::default();
    for (function, sample) in rows {
        let form = cas.form(&on_branches(&functions[*function], *sample, &mut 0));
        let slope = |id: &CoordinateId| {
            let slope = cas.derivative(&form, Symbol::Coordinate(*id));
            let slope = sampled(&cas.expr(&slope), *sample);
            cas.form(&slope)
        };
        let row = coordinates.iter().map(slope).collect();
        echelon.add(cas, row)?;
    }
    Some(echelon.null_space(cas, coordinates.len()))
}

/// Returns M, f, h and the comparisons within them, which derivatives ignore, as far as they
/// contain `coordinates`.
fn changing(equations: &EquationsOfMotion, coordinates: &[CoordinateId]) -> Vec<Expr> {
    let mut functions: Vec<Expr> = equations.dynamics().cloned().collect();
    Expr::visit_all(equations.dynamics(), &mut |part| {
        if let Expr::Call(Function::SelectLess, sides) = part {
            let minus = Expr::Product(vec![Expr::integer(-1), sides[1].clone()]);
            functions.push(Expr::Sum(vec![sides[0].clone(), minus]));
        }
    });
    let is_position = |symbol| coordinates.iter().any(|id| Symbol::Coordinate(*id) == symbol);
    functions.retain(|function| function.mentions(is_position));
    functions
}

/// Returns the expression on branches of its comparisons that differ from sample to sample.
fn on_branches(expr: &Expr, sample: i64, seen: &mut i64) -> Expr {
    let mut all = |parts: &[Expr]| {
        parts.iter().map(|part| on_branches(part, sample, seen)).collect::<Vec<_>>()
    };
    match expr {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_) => expr.clone(),
        Expr::Sum(terms) => Expr::Sum(all(terms)),
        Expr::Product(factors) => Expr::Product(all(factors)),
        Expr::Power(base, exponent) => {
            let base = Box::new(on_branches(base, sample, seen));
            Expr::Power(base, Box::new(on_branches(exponent, sample, seen)))
        }
        Expr::Call(Function::SelectLess, sides) => {
            on_branches(&sides[branch(sample, seen)], sample, seen)
        }
        Expr::Call(function, arguments) => Expr::Call(*function, all(arguments)),
    }
}

/// Returns the index of the argument that replaces the next comparison.
fn branch(sample: i64, seen: &mut i64) -> usize {
    let holds = (sample >> (*seen % 2)) % 2 == 0;
    *seen += 1;
    if holds { 2 } else { 3 }
}

/// Returns the value of a symbol in a sample, as numerator and denominator; parameters have none.
fn sample_of(symbol: Symbol, sample: i64) -> Option<(i64, i64)> {
    let value = |kind: i64, id: u32| {
        let numerator = 37 * kind + 11 * i64::from(id) + 101 * sample + 13;
        let denominator = 29 + 2 * i64::from(id) + kind;
        Some((numerator, denominator))
    };
    match symbol {
        Symbol::Time => value(1, 0),
        Symbol::Coordinate(id) => value(2, id.0),
        Symbol::Velocity(id) => value(3, id.0),
        Symbol::Acceleration(id) => value(4, id.0),
        Symbol::FirstOrder(id) => value(5, id.0),
        Symbol::Multiplier(id) => value(6, id.0),
        Symbol::Unloaded(id) => value(7, id.0),
        Symbol::Pi | Symbol::Parameter(_) | Symbol::Handed(_) | Symbol::Helper(_) => None,
    }
}

/// Replaces all symbols except parameters by numbers.
fn sampled(expr: &Expr, sample: i64) -> Expr {
    expr.replace(&|symbol| {
        let (numerator, denominator) = sample_of(symbol, sample)?;
        Some(Expr::Number(BigRational::new(numerator.into(), denominator.into())))
    })
}

/// Returns the derivatives of an expression by the coordinates, on the branches of a sample.
fn slopes(
    expr: &Expr,
    coordinates: &[CoordinateId],
    sample: i64,
    parameter: &impl Fn(u32) -> f64,
) -> Vec<f64> {
    let at = |symbol: Symbol| {
        let value = match (sample_of(symbol, sample), symbol) {
            (Some((numerator, denominator)), _) => numerator as f64 / denominator as f64,
            (None, Symbol::Pi) => std::f64::consts::PI,
            (None, Symbol::Parameter(id)) => parameter(id.0),
            (None, Symbol::Handed(id)) => parameter(id.0 + 1000),
            (None, _) => f64::NAN,
        };
        let place = coordinates.iter().position(|id| Symbol::Coordinate(*id) == symbol);
        Dual::of(value, place)
    };
    let mut slopes = dual(expr, sample, &mut 0, &at).slopes;
    slopes.resize(coordinates.len(), 0.0);
    slopes
}

/// A value with its derivatives; those beyond the last are zero.
struct Dual {
    value: f64,
    slopes: Vec<f64>,
}

impl Dual {
    fn of(value: f64, place: Option<usize>) -> Self {
        let mut slopes = vec![0.0; place.map_or(0, |place| place + 1)];
        if let Some(last) = slopes.last_mut() {
            *last = 1.0;
        }
        Dual { value, slopes }
    }

    fn add(&mut self, slopes: &[f64], factor: f64) {
        if self.slopes.len() < slopes.len() {
            self.slopes.resize(slopes.len(), 0.0);
        }
        self.slopes.iter_mut().zip(slopes).for_each(|(own, slope)| *own += factor * slope);
    }
}

fn dual(expr: &Expr, sample: i64, seen: &mut i64, at: &impl Fn(Symbol) -> Dual) -> Dual {
    match expr {
        Expr::Number(number) => Dual::of(number.to_f64().unwrap_or(f64::NAN), None),
        Expr::Symbol(symbol) => at(*symbol),
        Expr::Shared(shared) => dual(shared.definition(), sample, seen, at),
        Expr::Sum(terms) => {
            let mut sum = Dual::of(0.0, None);
            for term in terms {
                let term = dual(term, sample, seen, at);
                sum.value += term.value;
                sum.add(&term.slopes, 1.0);
            }
            sum
        }
        Expr::Product(factors) => {
            let mut product = Dual::of(1.0, None);
            for factor in factors {
                let factor = dual(factor, sample, seen, at);
                product.slopes.iter_mut().for_each(|slope| *slope *= factor.value);
                let before = product.value;
                product.add(&factor.slopes, before);
                product.value *= factor.value;
            }
            product
        }
        Expr::Power(base, exponent) => {
            let base = dual(base, sample, seen, at);
            let exponent = dual(exponent, sample, seen, at);
            let mut power = Dual::of(base.value.powf(exponent.value), None);
            power.add(&base.slopes, exponent.value * base.value.powf(exponent.value - 1.0));
            if !exponent.slopes.is_empty() {
                let value = power.value;
                power.add(&exponent.slopes, value * base.value.ln());
            }
            power
        }
        Expr::Call(Function::SelectLess, sides) => {
            dual(&sides[branch(sample, seen)], sample, seen, at)
        }
        Expr::Call(function, arguments) => {
            let argument = dual(&arguments[0], sample, seen, at);
            let (value, slope) = match function.unary() {
                Some(function) => value_and_slope(function, argument.value),
                // A table only has to be some smooth function.
                None => (argument.value.sin(), argument.value.cos()),
            };
            let mut result = Dual::of(value, None);
            result.add(&argument.slopes, slope);
            result
        }
    }
}

fn value_and_slope(function: Unary, x: f64) -> (f64, f64) {
    let slope = match function {
        Unary::Sqrt => 0.5 / x.sqrt(),
        Unary::Abs => x.signum(),
        Unary::Floor => 0.0,
        Unary::Exp => x.exp(),
        Unary::Ln => 1.0 / x,
        Unary::Sin => x.cos(),
        Unary::Cos => -x.sin(),
        Unary::Tan => 1.0 + x.tan().powi(2),
        Unary::Asin => 1.0 / (1.0 - x * x).sqrt(),
        Unary::Acos => -1.0 / (1.0 - x * x).sqrt(),
        Unary::Atan => 1.0 / (1.0 + x * x),
        Unary::Sinh => x.cosh(),
        Unary::Cosh => x.sinh(),
        Unary::Tanh => 1.0 - x.tanh().powi(2),
    };
    (call(function, x), slope)
}

/// Rows in reduced echelon form, each with the index of its leading 1.
#[derive(Default)]
struct Echelon {
    rows: Vec<(usize, Vec<Form>)>,
}

impl Echelon {
    /// Adds a row; `None` if the algebra exceeds its cost limit.
    fn add(&mut self, cas: &mut Cas, mut row: Vec<Form>) -> Option<()> {
        for (lead, known) in &self.rows {
            subtract(cas, &mut row, *lead, known)?;
        }
        let Some(lead) = row.iter().position(|entry| !cas.is_zero(entry)) else { return Some(()) };
        let first = row[lead].clone();
        for entry in row.iter_mut().filter(|entry| !entry.is_zero()) {
            *entry = cas.rational(&(&*entry / &first))?;
        }
        for (_, known) in &mut self.rows {
            subtract(cas, known, lead, &row)?;
        }
        self.rows.push((lead, row));
        Some(())
    }

    fn null_space(&self, cas: &Cas, columns: usize) -> Vec<Vec<Expr>> {
        let is_free = |column: &usize| self.rows.iter().all(|(lead, _)| lead != column);
        let vector = |free: usize| {
            let mut vector = vec![Expr::integer(0); columns];
            vector[free] = Expr::integer(1);
            for (lead, row) in &self.rows {
                vector[*lead] = cas.expr(&-&row[free]);
            }
            vector
        };
        (0..columns).filter(is_free).map(vector).collect()
    }
}

/// row -= row\[lead\] known
fn subtract(cas: &mut Cas, row: &mut [Form], lead: usize, known: &[Form]) -> Option<()> {
    let factor = row[lead].clone();
    if cas.is_zero(&factor) {
        return Some(());
    }
    for (entry, known) in row.iter_mut().zip(known).filter(|(_, known)| !known.is_zero()) {
        *entry = cas.rational(&(&*entry - &(&factor * known)))?;
    }
    Some(())
}

/// Reports whether a ratio divides by a function of parameters, such as the sine of an angle,
/// which may be zero at valid values.
fn may_be_infinite(ratio: &Expr) -> bool {
    let is_parameter = |symbol| matches!(symbol, Symbol::Parameter(_));
    let mut found = false;
    ratio.visit(&mut |part| match part {
        Expr::Power(base, exponent) if !matches!(&**exponent, Expr::Number(n) if n.is_positive()) =>
        {
            base.visit(&mut |part| {
                found |= matches!(part, Expr::Call(..)) && part.mentions(is_parameter);
            });
        }
        Expr::Call(Function::Tan, _) => found |= part.mentions(is_parameter),
        _ => {}
    });
    found
}

/// Returns the direction of a vector with the pivot that makes its factors cheapest; `None` if a
/// factor may be infinite.
fn cheapest(cas: &mut Cas, coordinates: &[CoordinateId], s: &[Expr]) -> Option<Direction> {
    let support: Vec<usize> = (0..s.len()).filter(|k| !identity::is_zero(&s[*k])).collect();
    let mut best: Option<(usize, Direction)> = None;
    // The last of equals is taken: a twist is the driving angle minus the driven one.
    for pivot in support.iter().rev() {
        let others = support.iter().filter(|k| *k != pivot);
        let others: Option<Vec<(CoordinateId, Expr)>> = others
            .map(|k| {
                let [own, of_pivot] = [&s[*k], &s[*pivot]].map(|s| cas.form(s));
                let ratio = cas.rational(&(&own / &of_pivot))?;
                Some((coordinates[*k], cas.expr(&ratio)))
            })
            .collect();
        let others = others?;
        if others.iter().any(|(_, factor)| may_be_infinite(factor)) {
            continue;
        }
        let cost = others.iter().map(|(_, factor)| operations(factor)).sum();
        if best.as_ref().is_none_or(|(least, _)| cost < *least) {
            best = Some((cost, Direction { pivot: coordinates[*pivot], others }));
        }
    }
    best.map(|(_, direction)| direction)
}

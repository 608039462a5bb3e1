//! Conversion of a scene with fields to one without: the nodes of a few elements become
//! coordinates, and the densities sums over them.
//!
//! ```text
//! integral of d(u, u_x, u_t, u_xt, x, t) dx = sum of w_i h d at x_i, element by element
//! u_x(x_i) = sum of l_j'(x_i) u_j / h
//! ```
//!
//! with Gauss-Lobatto points x_i and weights w_i, and the polynomials l_j through them, as the
//! spec language defines it. The sums then contain what fields pass to the machine.

use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Symbol};
use num_rational::BigRational;

use crate::scene::system::{Attachment, Coordinate, Field, GeneralizedForce, LagrangianSystem};
use machinist_model::{Name, Place, Quantity};

/// Returns a system whose fields are coordinates, and the number of elements of each field: one
/// between neighbouring ports, or two for a field without inner ports. `None` if no single number
/// of elements fits all fields.
#[must_use]
pub fn written_out(system: &LagrangianSystem) -> Option<(LagrangianSystem, usize)> {
    let stretches: Vec<usize> = system.fields.iter().map(|field| bounds(field).len() - 1).collect();
    let elements = stretches.iter().copied().max()?.max(2);
    if stretches.iter().any(|stretches| *stretches != 1 && *stretches != elements) {
        return None;
    }
    let mut out = LagrangianSystem { fields: Vec::new(), handed: Vec::new(), ..system.clone() };
    // The numbers that fields pass are written out below. Outputs that use them have no value.
    let without = |expr: &Expr| {
        expr.replace(&|symbol| matches!(symbol, Symbol::Handed(_)).then(|| Expr::integer(0)))
    };
    out.kinetic = without(&system.kinetic);
    for (force, own) in out.generalized_force.iter_mut().zip(&system.generalized_force) {
        force.total = without(&own.total);
    }
    let mut sums: [Vec<Expr>; 3] = Default::default();
    for field in &system.fields {
        write_out(&mut out, &mut sums, field, elements);
    }
    let [kinetic, potential, dissipation] = sums;
    for (energy, sum) in [
        (&mut out.kinetic, kinetic),
        (&mut out.potential, potential),
        (&mut out.dissipation, dissipation),
    ] {
        *energy = Expr::Sum(std::iter::once(energy.clone()).chain(sum).collect());
    }
    Some((out, elements))
}

/// Returns the ends of the segments between ports.
fn bounds(field: &Field) -> Vec<Expr> {
    let inside = field.attachments.iter().filter(|at| at.place == Place::Inside);
    let inside = inside.map(|at| at.at.clone());
    std::iter::once(Expr::integer(0)).chain(inside).chain([field.length.clone()]).collect()
}

fn write_out(
    out: &mut LagrangianSystem,
    sums: &mut [Vec<Expr>; 3],
    field: &Field,
    elements: usize,
) {
    let bounds = bounds(field);
    let count = elements / (bounds.len() - 1);
    let rule = Rule::new(field.order);
    let nodes = elements * field.order + 1;
    let owners = owners(out, field, nodes, count * field.order);
    for element in 0..elements {
        let [start, end] = [0, 1].map(|side| bounds[element / count + side].clone());
        let whole = plus(vec![end, times(vec![Expr::integer(-1), start.clone()])]);
        let length = times(vec![whole.clone(), over(count)]);
        let first = element * field.order;
        let own = &owners[first..=first + field.order];
        for (i, point) in rule.points.iter().enumerate() {
            let along = (element % count) as f64 + point;
            let place = plus(vec![start.clone(), times(vec![length.clone(), number(along)])]);
            let here = |expr: &Expr| at_node(expr, own, i, &rule, &length, &place);
            let share = |density: &Expr| {
                times(vec![number(rule.weights[i]), length.clone(), here(density)])
            };
            for (sum, density) in
                sums.iter_mut().zip([&field.kinetic, &field.potential, &field.dissipation])
            {
                sum.push(share(density));
            }
            let Some(CoordinateId(id)) = own[i] else { continue };
            let force = &mut out.generalized_force[id as usize].total;
            *force = plus(vec![force.clone(), share(&field.force)]);
            let initial = field.initial.each_ref().map(here);
            start_at(&mut out.coordinates[id as usize], initial, field, first + i);
        }
    }
}

/// Sets the initial values of a node: those of the field, except at ports, which start with their
/// machine.
fn start_at(coordinate: &mut Coordinate, initial: [Expr; 2], field: &Field, node: usize) {
    if coordinate.position.name.path == named(&field.quantities[0], node).name.path {
        coordinate.initial = initial;
    }
}

/// Returns the coordinate of each node, new ones for nodes of the field alone; `None` where the
/// field is fixed.
fn owners(
    out: &mut LagrangianSystem,
    field: &Field,
    nodes: usize,
    stretch: usize,
) -> Vec<Option<CoordinateId>> {
    let mut bound = 0;
    let mut places: Vec<(usize, &Attachment)> = Vec::new();
    for at in &field.attachments {
        let node = match at.place {
            Place::Start => 0,
            Place::End => nodes - 1,
            Place::Inside => {
                bound += 1;
                bound * stretch
            }
        };
        places.push((node, at));
    }
    let owner = |node: usize| {
        let port = places.iter().find(|(place, at)| *place == node && at.coordinate.is_some());
        let is_fixed = (node == 0 && field.fixed[0]) || (node == nodes - 1 && field.fixed[1]);
        match port {
            Some((_, at)) => at.coordinate,
            None if is_fixed => None,
            None => {
                let id = CoordinateId(out.coordinates.len() as u32);
                out.coordinates.push(Coordinate {
                    position: named(&field.quantities[0], node),
                    velocity: named(&field.quantities[2], node),
                    identified: Vec::new(),
                    initial: [Expr::integer(0), Expr::integer(0)],
                    is_given: [true; 2],
                    scale: field.scale,
                });
                let nothing = || Expr::integer(0);
                out.generalized_force
                    .push(GeneralizedForce { total: nothing(), conversion: nothing() });
                Some(id)
            }
        }
    };
    (0..nodes).map(owner).collect()
}

/// Returns the name that simulators of fields give to a node.
fn named(quantity: &Quantity, node: usize) -> Quantity {
    let path = format!("{}[{node}]", quantity.name.path);
    Quantity { name: Name { path, ..quantity.name.clone() }, ..quantity.clone() }
}

/// Returns a density at a point of an element.
fn at_node(
    density: &Expr,
    own: &[Option<CoordinateId>],
    i: usize,
    rule: &Rule,
    length: &Expr,
    place: &Expr,
) -> Expr {
    let one = |symbol: fn(CoordinateId) -> Symbol, node: usize| {
        own[node].map_or(Expr::integer(0), |id| Expr::Symbol(symbol(id)))
    };
    let slope = |symbol: fn(CoordinateId) -> Symbol| {
        let shares = (0..own.len()).map(|j| times(vec![number(rule.slopes[i][j]), one(symbol, j)]));
        let reciprocal = Expr::Power(Box::new(length.clone()), Box::new(Expr::integer(-1)));
        times(vec![reciprocal, plus(shares.collect())])
    };
    density.replace(&|symbol| match symbol {
        Symbol::Coordinate(CoordinateId(0)) => Some(one(Symbol::Coordinate, i)),
        Symbol::Coordinate(_) => Some(slope(Symbol::Coordinate)),
        Symbol::Velocity(CoordinateId(0)) => Some(one(Symbol::Velocity, i)),
        Symbol::Velocity(_) => Some(slope(Symbol::Velocity)),
        Symbol::FirstOrder(FirstOrderId(0)) => Some(place.clone()),
        _ => None,
    })
}

fn plus(terms: Vec<Expr>) -> Expr {
    Expr::Sum(terms)
}

fn times(factors: Vec<Expr>) -> Expr {
    Expr::Product(factors)
}

fn over(count: usize) -> Expr {
    Expr::Number(BigRational::new(1.into(), count.into()))
}

fn number(value: f64) -> Expr {
    Expr::Number(BigRational::from_float(value).unwrap_or_default())
}

/// Gauss-Lobatto points and weights on the unit interval, and derivatives l_j'(x_i).
struct Rule {
    points: Vec<f64>,
    weights: Vec<f64>,
    slopes: Vec<Vec<f64>>,
}

impl Rule {
    /// Returns the rule of p + 1 points: the ends and the zeros of P_p', found by changes of its
    /// sign. The weights are 1/(p (p + 1) P_p(x)^2).
    fn new(order: usize) -> Self {
        /// Number of intervals searched for changes of the sign of P_p'. Zeros of order 16 are at
        /// least 1/50 apart.
        const STEPS: usize = 2000;
        let slope = |x: f64| legendre(order, x)[1];
        let step = |k: usize| 2.0 * k as f64 / STEPS as f64 - 1.0 + 1e-7;
        let mut x = vec![-1.0];
        for k in 0..STEPS {
            let (mut low, mut high) = (step(k), step(k + 1).min(1.0));
            if slope(low) * slope(high) > 0.0 {
                continue;
            }
            for _ in 0..80 {
                let middle = f64::midpoint(low, high);
                let is_before = slope(low) * slope(middle) > 0.0;
                *(if is_before { &mut low } else { &mut high }) = middle;
            }
            x.push(f64::midpoint(low, high));
        }
        x.push(1.0);
        let p = order as f64;
        let weights = x.iter().map(|x| 1.0 / (p * (p + 1.0) * legendre(order, *x)[0].powi(2)));
        let slopes = (0..x.len()).map(|i| (0..x.len()).map(|j| 2.0 * basis(&x, j, i)).collect());
        Self {
            weights: weights.collect(),
            slopes: slopes.collect(),
            points: x.iter().map(|x| f64::midpoint(*x, 1.0)).collect(),
        }
    }
}

/// Returns l_j'(x_i), by the product rule.
fn basis(x: &[f64], j: usize, i: usize) -> f64 {
    let others = || (0..x.len()).filter(|m| *m != j);
    let without = |m: usize| {
        let factors = others().filter(move |k| *k != m);
        factors.map(|k| (x[i] - x[k]) / (x[j] - x[k])).product::<f64>()
    };
    others().map(|m| without(m) / (x[j] - x[m])).sum()
}

/// Returns P_p and P_p'.
fn legendre(order: usize, x: f64) -> [f64; 2] {
    let (mut before, mut here) = ([1.0, 0.0], [x, 1.0]);
    if order == 0 {
        return before;
    }
    for n in 1..order {
        let n = n as f64;
        let next = |k: usize, product: f64| ((2.0 * n + 1.0) * product - n * before[k]) / (n + 1.0);
        let value = [next(0, x * here[0]), next(1, here[0] + x * here[1])];
        (before, here) = (here, value);
    }
    here
}

#[cfg(test)]
mod tests {
    use super::Rule;

    #[test]
    fn the_rule_integrates_and_differentiates_polynomials() {
        for order in 1..=16 {
            let rule = Rule::new(order);
            assert_eq!(rule.points.len(), order + 1);
            let (p, q) = (order as i32, 2 * order as i32 - 1);
            let integral: f64 =
                rule.points.iter().zip(&rule.weights).map(|(x, w)| w * x.powi(q)).sum();
            assert!((integral * f64::from(q + 1) - 1.0).abs() < 1e-12, "{order}");
            for (i, x) in rule.points.iter().enumerate() {
                let values = rule.points.iter().map(|x| x.powi(p));
                let slope: f64 = values.zip(&rule.slopes[i]).map(|(y, l)| y * l).sum();
                let expected = f64::from(p) * x.powi(p - 1);
                assert!((slope - expected).abs() < 1e-10 * f64::from(p), "{order}: {slope}");
            }
        }
    }
}

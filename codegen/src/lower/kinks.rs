//! Where a rate is not smooth, or changes within a time that no step may pass over: found
//! on the graph.
//!
//! - *Kinks* pass zero along a motion: arguments of `abs` and `sign`, differences of what
//!   `min` and `max` compare, distances from the ends of tables, +-sin(pi (x - floor(x))) of
//!   `floor(x)`. They come with their rates along the motion, differentiated on the graph.
//! - *Times* follow from parameters: where such an argument is linear in time alone, it
//!   passes zero at a time known beforehand. So do centres of bells, of tanh and of other
//!   functions of a polynomial of time, and the knots at which a table over time bends.
//! - What comes and goes in each turn of something (`recurring`) turns where its argument does: the
//!   rate of that is a guard too.
//! - What is there near a place only (`bells`) is come near to, and left behind: so is that.
//!
//! Excluded: what parameters or modes alone decide, and what fields hand over.

mod bells;
mod extent;
mod recurring;

use std::collections::HashMap;

use machinist_algebra::expr::Graph;
use machinist_model::{Function, NodeId, Op, Table};

use super::along::{along, reached};
use recurring::recurring;

/// What of a rate is not smooth.
#[derive(Debug, Default)]
pub struct Kinks {
    /// What passes zero along a motion.
    pub guards: Vec<NodeId>,
    /// Rates of these.
    pub rates: Vec<NodeId>,
    /// Times, of parameters alone.
    pub times: Vec<NodeId>,
}

/// What takes less than a run over this is not left to steps to find.
const SHARES: f64 = 300.0;

/// What is known of the machine besides its rate.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    /// Of the state, which entries change at events only.
    pub is_mode: &'a [bool],
    /// Its tables.
    pub tables: &'a [Table],
    /// Start and end of runs, as its spec has them \[s\].
    pub run: (f64, f64),
    /// Values of parameters, as its spec has them.
    pub parameters: &'a [f64],
    /// Of the state, which entries are positions.
    pub is_place: &'a [bool],
    /// The state at the start, as its spec has it.
    pub start: &'a [f64],
}

/// By what a node changes along a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum By {
    Nothing,
    Time,
    State,
}

/// The kinks of a rate, one node for each entry of the state, and of what constraints hold: there
/// the rate may be smooth, and speeds jump.
pub fn kinks(graph: &mut Graph, rate: &[NodeId], holds: &[NodeId], given: &Given<'_>) -> Kinks {
    let nodes: Vec<NodeId> = reached(graph, &[rate, holds].concat()).into_iter().collect();
    let mut search =
        Search { is_mode: given.is_mode, by: HashMap::new(), polynomials: HashMap::new() };
    let mut found = Kinks::default();
    let span = given.run.1 - given.run.0;
    for &id in &nodes {
        search.look(graph, id);
        for guard in switched(graph, id, given.tables) {
            found.add(graph, &mut search, guard);
        }
        for time in search.features(graph, id, (given.tables, span)) {
            found.add_time(time);
        }
        if let Some(argument) = recurring(&search, graph, id, given) {
            let turns = along(graph, rate, &[argument])[0];
            found.add(graph, &mut search, turns);
        }
    }
    for guard in bells::near(&search, graph, &nodes, given) {
        found.add(graph, &mut search, guard);
    }
    found.rates = along(graph, rate, &found.guards);
    found
}

/// What is compared with zero at a node.
fn switched(graph: &mut Graph, id: NodeId, tables: &[Table]) -> Vec<NodeId> {
    match graph.op(id) {
        Op::SelectLess { lhs, rhs, .. } => vec![graph.sub(lhs, rhs)],
        Op::Call(Function::Abs, argument) => vec![argument],
        Op::Call(Function::Floor, argument) => {
            // Passes zero at every whole number, in turns upwards and downwards; to the last bit
            // where `floor` jumps.
            let [one, two, half] = [1.0, 2.0, 0.5].map(|value| graph.literal(value));
            let half = graph.mul(half, id);
            let half = graph.call(Function::Floor, half);
            let even = graph.mul(two, half);
            let odd = graph.sub(id, even);
            let twice = graph.mul(two, odd);
            let way = graph.sub(one, twice);
            let beyond = graph.sub(argument, id);
            let half_turn = graph.literal(std::f64::consts::PI);
            let angle = graph.mul(half_turn, beyond);
            let height = graph.call(Function::Sin, angle);
            vec![graph.mul(way, height)]
        }
        Op::Table { table, argument, .. } => {
            let table = &tables[table.0 as usize];
            let ends = [table.knots.first(), table.knots.last()].into_iter().flatten();
            let corners = corners(table);
            let ends = ends.chain(&corners);
            let from = |end: &f64| {
                let end = graph.literal(*end);
                graph.sub(argument, end)
            };
            ends.map(from).collect()
        }
        _ => vec![],
    }
}

/// Corners beyond which a table is fine enough for steps to follow it.
const MOST_CORNERS: usize = 100;

/// Inner knots at which the slope of a table jumps.
fn corners(table: &Table) -> Vec<f64> {
    let slopes = table.coefficients.windows(2).zip(table.knots.windows(2)).map(|(pair, knots)| {
        let [_, c1, c2, c3] = pair[0];
        let u = knots[1] - knots[0];
        let terms = [c1, 2.0 * c2 * u, 3.0 * c3 * u * u];
        let size = terms.iter().fold(pair[1][1].abs(), |size, term| size.max(term.abs()));
        let jump = terms.iter().sum::<f64>() - pair[1][1];
        // What a spline leaves is rounding.
        (knots[1], jump.abs() > 1e-6 * size)
    });
    let corners: Vec<f64> = slopes.filter(|(_, jumps)| *jumps).map(|(knot, _)| knot).collect();
    if corners.len() > MOST_CORNERS { Vec::new() } else { corners }
}

impl Kinks {
    /// Takes a guard, as a time if that is when it passes zero.
    fn add(&mut self, graph: &mut Graph, search: &mut Search<'_>, guard: NodeId) {
        for id in reached(graph, &[guard]) {
            search.look(graph, id);
        }
        match search.by[&guard] {
            By::Nothing => return,
            By::Time => {
                if let Some(polynomial) = search.polynomials[&guard]
                    && graph.is_zero(polynomial[2])
                {
                    if let Some(time) = turn(graph, polynomial) {
                        self.add_time(time);
                    }
                    return;
                }
            }
            By::State => {}
        }
        let opposite = graph.neg(guard);
        if !self.guards.contains(&guard) && !self.guards.contains(&opposite) {
            self.guards.push(guard);
        }
    }

    fn add_time(&mut self, time: NodeId) {
        if !self.times.contains(&time) {
            self.times.push(time);
        }
    }
}

/// What is known of the nodes that were looked at, each after its operands.
struct Search<'a> {
    is_mode: &'a [bool],
    by: HashMap<NodeId, By>,
    /// c_0 + c_1 t + c_2 t^2 of nodes that are such, with coefficients of parameters.
    polynomials: HashMap<NodeId, Option<[NodeId; 3]>>,
}

impl Search<'_> {
    fn look(&mut self, graph: &mut Graph, id: NodeId) {
        if self.by.contains_key(&id) {
            return;
        }
        let op = graph.op(id);
        let by = match op {
            Op::Time => By::Time,
            Op::State(entry) if !self.is_mode[entry as usize] => By::State,
            Op::Handed(_) | Op::Motion(_) => By::State,
            _ => op.operands().iter().map(|id| self.by[id]).max().unwrap_or(By::Nothing),
        };
        self.by.insert(id, by);
        let polynomial = if by == By::State { None } else { self.polynomial(graph, id) };
        self.polynomials.insert(id, polynomial);
    }

    fn polynomial(&self, graph: &mut Graph, id: NodeId) -> Option<[NodeId; 3]> {
        let zero = graph.literal(0.0);
        let of = |id: NodeId| self.polynomials[&id];
        if self.by[&id] == By::Nothing {
            // A mode changes at events, and so do times that depend on it.
            return graph.is_constant(id).then_some([id, zero, zero]);
        }
        match graph.op(id) {
            Op::Time => Some([zero, graph.literal(1.0), zero]),
            Op::Neg(a) => Some(of(a)?.map(|c| graph.neg(c))),
            Op::Add(a, b) => Some(each(of(a)?, of(b)?, |a, b| graph.add(a, b))),
            Op::Sub(a, b) => Some(each(of(a)?, of(b)?, |a, b| graph.sub(a, b))),
            Op::Mul(a, b) => product(graph, of(a)?, of(b)?),
            Op::Div(a, b) if self.by[&b] == By::Nothing => {
                let divisor = of(b)?[0];
                Some(of(a)?.map(|c| graph.div(c, divisor)))
            }
            Op::Powi(a, 2) => product(graph, of(a)?, of(a)?),
            _ => None,
        }
    }

    /// Times at which a function of time alone does what it does.
    fn features(
        &self,
        graph: &mut Graph,
        id: NodeId,
        (tables, span): (&[Table], f64),
    ) -> Vec<NodeId> {
        if self.by[&id] != By::Time {
            return vec![];
        }
        let arguments = match graph.op(id) {
            Op::Call(Function::Sin | Function::Cos | Function::Abs | Function::Floor, _) => {
                vec![]
            }
            Op::Call(_, a) | Op::Powi(a, _) | Op::Powf(a, _) => vec![a],
            Op::Div(_, b) => vec![b],
            Op::Mul(a, b) if a == b => vec![a],
            Op::Table { table, argument, .. } => {
                let knots = bends(&tables[table.0 as usize]);
                let from = knots.into_iter().filter_map(|(knot, distance)| {
                    let polynomial = self.polynomials[&argument]?.map(|c| {
                        let distance = graph.literal(distance);
                        graph.div(c, distance)
                    });
                    let [value, slope, curve] = polynomial;
                    if !graph.is_zero(curve) {
                        return None;
                    }
                    let knot = graph.literal(knot / distance);
                    let value = graph.sub(value, knot);
                    narrow(graph, [value, slope, curve], span)
                });
                return from.collect();
            }
            _ => vec![],
        };
        let arguments = arguments.into_iter().filter(|a| self.by[a] == By::Time);
        arguments.filter_map(|argument| narrow(graph, self.polynomials[&argument]?, span)).collect()
    }
}

/// Where a polynomial passes zero, if it is linear, or turns.
fn turn(graph: &mut Graph, [value, slope, curve]: [NodeId; 3]) -> Option<NodeId> {
    let (above, below) = if graph.is_zero(curve) {
        (value, slope)
    } else {
        let two = graph.literal(2.0);
        (slope, graph.mul(two, curve))
    };
    if graph.is_zero(below) {
        return None;
    }
    let quotient = graph.div(above, below);
    let time = graph.neg(quotient);
    if graph.literal_value(below).is_some() {
        return Some(time);
    }
    // A slope that parameters make zero passes no zero: then there is no such time,
    // which the start of all runs stands for.
    let zero = graph.literal(0.0);
    let size = graph.call(Function::Abs, below);
    Some(graph.select_less(zero, size, time, zero))
}

/// Where a function of this argument does what it does, if that takes but a small share of
/// a run: steps see what is wider.
fn narrow(graph: &mut Graph, polynomial: [NodeId; 3], span: f64) -> Option<NodeId> {
    let [_, slope, curve] = polynomial;
    let time = turn(graph, polynomial)?;
    let sharpness = if graph.is_zero(curve) {
        graph.call(Function::Abs, slope)
    } else {
        let size = graph.call(Function::Abs, curve);
        graph.call(Function::Sqrt, size)
    };
    let least = SHARES / span;
    if let Some(sharpness) = graph.literal_value(sharpness) {
        return (sharpness > least).then_some(time);
    }
    let (least, start) = (graph.literal(least), graph.literal(0.0));
    Some(graph.select_less(least, sharpness, time, start))
}

fn each(
    a: [NodeId; 3],
    b: [NodeId; 3],
    mut of: impl FnMut(NodeId, NodeId) -> NodeId,
) -> [NodeId; 3] {
    std::array::from_fn(|power| of(a[power], b[power]))
}

/// The product of two polynomials, unless it is of higher degree than two.
fn product(graph: &mut Graph, a: [NodeId; 3], b: [NodeId; 3]) -> Option<[NodeId; 3]> {
    let degree = |of: &[NodeId; 3]| of.iter().rposition(|c| !graph.is_zero(*c)).unwrap_or(0);
    if degree(&a) + degree(&b) > 2 {
        return None;
    }
    let mut coefficients = [graph.literal(0.0); 3];
    for (i, left) in a.iter().enumerate() {
        for (j, right) in b.iter().enumerate().take(3 - i) {
            let part = graph.mul(*left, *right);
            coefficients[i + j] = graph.add(coefficients[i + j], part);
        }
    }
    Some(coefficients)
}

/// Inner knots between which a table is curved, and how near the next knot is: the most curved
/// ones, if they are many.
fn bends(table: &Table) -> Vec<(f64, f64)> {
    /// A table with more of them moves nearly all the time, and is seen by that.
    const MOST: usize = 64;
    /// Of what the table does altogether.
    const NOTICED: f64 = 1e-10;
    let lengths: Vec<f64> = table.knots.windows(2).map(|ends| ends[1] - ends[0]).collect();
    let ways = table.coefficients.iter().zip(&lengths).map(|(c, length)| {
        let [c1, c2, c3] = [c[1] * length, c[2] * length.powi(2), c[3] * length.powi(3)];
        (c1.abs() + c2.abs() + c3.abs(), c2.abs() + c3.abs())
    });
    let (ways, curved): (Vec<f64>, Vec<f64>) = ways.unzip();
    let all = ways.iter().fold(0.0, |most: f64, way| most.max(*way));
    let at = |k: usize| (k, curved[k - 1].max(curved[k]));
    let mut inside: Vec<(usize, f64)> = (1..lengths.len()).map(at).collect();
    inside.retain(|(_, curved)| *curved > NOTICED * all);
    inside.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(&b.0)));
    inside.truncate(MOST);
    inside.sort_unstable_by_key(|(k, _)| *k);
    inside.iter().map(|(k, _)| (table.knots[*k], lengths[*k - 1].min(lengths[*k]))).collect()
}

#[cfg(test)]
mod tests;

//! Points at which a rate is not smooth, or changes within a time that no step may pass over: found
//! on the graph.
//!
//! - *Relations*, which steps hold: `abs`, `sign`, `min`, `max`, comparisons and `floor`. Their
//!   guards are the arguments or the differences of what is compared. They come first, each after
//!   those that it reads, with their readers (`relations`).
//! - *Borders* have guards and no slots: ends of tables, and branches that keep a root, a logarithm
//!   or a power within its domain.
//! - Guards come with their rates along the motion, differentiated on the graph.
//! - *Times* follow from parameters: an argument that is linear in time alone crosses zero at a
//!   time known beforehand. Other known times are the centres of bells, of tanh and of other
//!   functions of a polynomial of time, and the knots at which a table over time bends.
//! - Features that recur in each period (`recurring`) turn where their argument does: the rate of
//!   the argument is a guard, too.
//! - Features near a place (`bells`) have guards that cross zero where the motion comes near and
//!   where it leaves.
//!
//! Excluded are expressions of parameters or modes alone, and values that fields provide.

mod bells;
mod extent;
mod recurring;
mod relations;

use std::collections::HashMap;

use machinist_algebra::expr::Graph;
use machinist_algebra::expr::held::{Compared, Multiple, Slot};
use machinist_contract::{Reader, RelationKind};
use machinist_model::{Function, NodeId, Op, Relation, Table};

use super::along::{along, reached};
use recurring::recurring;
use relations::{clamps, read, readers};

/// Points at which a rate is not smooth.
#[derive(Debug, Default)]
pub struct Kinks {
    /// Guards along a motion, those of relations first.
    pub guards: Vec<NodeId>,
    /// Rates of the guards.
    pub rates: Vec<NodeId>,
    /// Times, which depend on parameters alone.
    pub times: Vec<NodeId>,
    /// Relations that steps hold.
    pub relations: Vec<Relation>,
    /// Relation of each comparison.
    pub slots: Vec<(Compared, Slot)>,
    /// Arguments of functions of the rate that are flat far from a place, each once.
    pub saturating: Vec<NodeId>,
    /// Guards of branches that keep a value within its domain.
    clamps: Vec<NodeId>,
}

/// Nodes that are searched for relations.
#[derive(Debug, Clone, Copy)]
pub struct Places<'a> {
    /// The rate, one for each entry of the state.
    pub rate: &'a [NodeId],
    /// Values and rates of constraints, and entries of M: velocities jump where these jump.
    pub holds: &'a [NodeId],
    /// Guards of events.
    pub guards: &'a [NodeId],
}

/// Part of a run below which a feature is not left to the steps.
const SHARES: f64 = 100.0;

/// Data of the machine besides its rate.
#[derive(Debug, Clone, Copy)]
pub struct Given<'a> {
    /// True for entries of the state that change only at events.
    pub is_mode: &'a [bool],
    /// Tables.
    pub tables: &'a [Table],
    /// Start and end of runs, as the spec has them \[s\].
    pub run: (f64, f64),
    /// Values of parameters, as the spec has them.
    pub parameters: &'a [f64],
    /// True for entries of the state that are positions.
    pub is_place: &'a [bool],
    /// State at the start, as the spec has it.
    pub start: &'a [f64],
}

/// Cause of changes of a node along a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum By {
    Nothing,
    Time,
    State,
}

/// Finds the kinks of a rate, of constraints and of M, where the rate may be smooth and velocities
/// jump, and of guards of events.
pub fn kinks(graph: &mut Graph, places: &Places<'_>, given: &Given<'_>) -> Kinks {
    let rate = places.rate;
    let all = [rate, places.holds, places.guards].concat();
    let nodes: Vec<NodeId> = reached(graph, &all).into_iter().collect();
    let mut search =
        Search { is_mode: given.is_mode, by: HashMap::new(), polynomials: HashMap::new() };
    let mut found = Kinks::default();
    let span = given.run.1 - given.run.0;
    let clamps = clamps(graph, &nodes);
    for &id in &nodes {
        search.look(graph, id);
        if let Some(compared) = Compared::at(graph, id) {
            let is_clamp = clamps.contains(&compared);
            found.add_relation(graph, &mut search, compared, is_clamp);
        }
    }
    found.merge_multiples(graph);
    let mut zoned = Vec::new();
    for (guard, argument) in bells::near(&search, graph, &nodes, given) {
        found.add_zone(graph, &mut search, guard);
        zoned.extend(argument.map(|argument| without_sign(graph, argument)));
    }
    for guard in std::mem::take(&mut found.clamps) {
        found.add(graph, &mut search, guard);
    }
    for &id in &nodes {
        for guard in ends_of_table(graph, id, given.tables) {
            found.add(graph, &mut search, guard);
        }
        for time in search.features(graph, id, (given.tables, span)) {
            found.add_time(time);
        }
        for argument in recurring(&search, graph, id, given) {
            let turns = along(graph, rate, &[argument])[0];
            found.add(graph, &mut search, turns);
        }
    }
    found.rates = along(graph, rate, &found.guards);
    let saturating = reached(graph, rate).into_iter().filter_map(|id| search.saturating(graph, id));
    // Steps end at borders of zones, and are short inside.
    found.saturating = saturating.filter(|argument| !zoned.contains(argument)).collect();
    found.saturating.sort_unstable();
    found.saturating.dedup();
    readers(graph, places, &mut found);
    found
}

impl Kinks {
    /// Lets relations that power reads end steps too. Where motion is prescribed, a force may act on
    /// power alone.
    pub fn read_by_power(&mut self, graph: &mut Graph, power: &[NodeId]) {
        read(graph, vec![(Reader::Rate, power.to_vec())], self);
    }
}

/// Returns whether an operation reads a value that a field provides.
fn is_handed_over(op: Op) -> bool {
    matches!(op, Op::Handed(_))
}

/// Returns the distances from the ends and corners of a table.
fn ends_of_table(graph: &mut Graph, id: NodeId, tables: &[Table]) -> Vec<NodeId> {
    match graph.op(id) {
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

/// Number of corners above which a table is fine enough for steps to follow it.
const MOST_CORNERS: usize = 100;

/// Returns the inner knots at which the slope of a table jumps.
fn corners(table: &Table) -> Vec<f64> {
    let slopes = table.coefficients.windows(2).zip(table.knots.windows(2)).map(|(pair, knots)| {
        let [_, c1, c2, c3] = pair[0];
        let u = knots[1] - knots[0];
        let terms = [c1, 2.0 * c2 * u, 3.0 * c3 * u * u];
        let size = terms.iter().fold(pair[1][1].abs(), |size, term| size.max(term.abs()));
        let jump = terms.iter().sum::<f64>() - pair[1][1];
        // A spline leaves only rounding.
        (knots[1], jump.abs() > 1e-6 * size)
    });
    let corners: Vec<f64> = slopes.filter(|(_, jumps)| *jumps).map(|(knot, _)| knot).collect();
    if corners.len() > MOST_CORNERS { Vec::new() } else { corners }
}

impl Kinks {
    /// Adds a border.
    fn add(&mut self, graph: &mut Graph, search: &mut Search<'_>, guard: NodeId) {
        if self.passes(graph, search, guard) && self.known(graph, guard).is_none() {
            self.guards.push(guard);
        }
    }

    /// Adds a zone.
    fn add_zone(&mut self, graph: &mut Graph, search: &mut Search<'_>, guard: NodeId) {
        if self.passes(graph, search, guard) && self.known(graph, guard).is_none() {
            self.guards.push(guard);
            let readers = vec![Reader::Rate];
            self.relations.push(Relation { kind: RelationKind::Zone, readers });
        }
    }

    /// Returns whether a guard crosses zero along a motion, at a time not known beforehand. Known
    /// times are added.
    fn passes(&mut self, graph: &mut Graph, search: &mut Search<'_>, guard: NodeId) -> bool {
        for id in reached(graph, &[guard]) {
            search.look(graph, id);
            // The rate of a value that a field provides is not on the graph.
            if is_handed_over(graph.op(id)) {
                return false;
            }
        }
        match search.by[&guard] {
            By::Nothing => return false,
            By::Time => {
                if let Some(polynomial) = search.polynomials[&guard]
                    && graph.is_zero(polynomial[2])
                {
                    if let Some(time) = turn(graph, polynomial) {
                        self.add_time(time);
                    }
                    return false;
                }
            }
            By::State => {}
        }
        true
    }

    /// Returns the position of a known guard, and whether it has the other sign.
    fn known(&self, graph: &mut Graph, guard: NodeId) -> Option<(usize, bool)> {
        let opposite = graph.neg(guard);
        let place = |guard: NodeId| self.guards.iter().position(|known| *known == guard);
        place(guard).map(|place| (place, false)).or_else(|| place(opposite).map(|at| (at, true)))
    }

    /// Adds a relation, with a slot, or a border if it is a clamp.
    fn add_relation(
        &mut self,
        graph: &mut Graph,
        search: &mut Search<'_>,
        compared: Compared,
        is_clamp: bool,
    ) {
        let guard = compared.guard(graph);
        let is_whole = matches!(compared, Compared::Whole(_));
        if let Compared::Whole(argument) = compared {
            search.look(graph, argument);
            // An argument of time alone changes at many times, which steps find.
            let is_handed =
                reached(graph, &[argument]).iter().any(|id| is_handed_over(graph.op(*id)));
            if search.by[&argument] == By::Nothing || is_handed {
                return;
            }
        } else if !self.passes(graph, search, guard) {
            return;
        }
        if is_clamp {
            self.clamps.push(guard);
            return;
        }
        let kind = if is_whole { RelationKind::Whole } else { RelationKind::Branch };
        let known =
            self.known(graph, guard).filter(|(place, _)| self.relations[*place].kind == kind);
        let (index, is_opposite) = known.unwrap_or_else(|| {
            self.guards.push(guard);
            self.relations.push(Relation { kind, readers: Vec::new() });
            (self.relations.len() - 1, false)
        });
        let slot = Slot { index: index as u32, is_opposite };
        if !self.slots.iter().any(|(known, _)| *known == compared) {
            self.slots.push((compared, slot));
        }
    }

    /// Makes one relation of those whose guards are multiples of each other, in whatever form: they
    /// change together, and a motion slides along all of them or none.
    fn merge_multiples(&mut self, graph: &Graph) {
        let is_branch = |index: &usize| self.relations[*index].kind == RelationKind::Branch;
        let branches: Vec<usize> = (0..self.relations.len()).filter(is_branch).collect();
        let guards: Vec<NodeId> = branches.iter().map(|index| self.guards[*index]).collect();
        if guards.len() < 2 {
            return;
        }
        let mut multiples: HashMap<usize, Multiple> = HashMap::new();
        for (index, multiple) in branches.iter().zip(graph.multiples(&guards)) {
            let of = branches[multiple.of];
            multiples.insert(*index, Multiple { of, ..multiple });
        }
        let mut moved: Vec<Slot> = Vec::new();
        let mut kept = 0;
        for index in 0..self.relations.len() {
            let multiple = multiples.get(&index).filter(|multiple| multiple.of != index);
            let slot = if let Some(multiple) = multiple {
                let of = moved[multiple.of];
                Slot { is_opposite: of.is_opposite != multiple.is_opposite, ..of }
            } else {
                self.guards.swap(kept, index);
                self.relations.swap(kept, index);
                kept += 1;
                Slot { index: kept as u32 - 1, is_opposite: false }
            };
            moved.push(slot);
        }
        self.guards.truncate(kept);
        self.relations.truncate(kept);
        for (_, slot) in &mut self.slots {
            let to = moved[slot.index as usize];
            *slot = Slot { index: to.index, is_opposite: slot.is_opposite != to.is_opposite };
        }
    }

    fn add_time(&mut self, time: NodeId) {
        if !self.times.contains(&time) {
            self.times.push(time);
        }
    }
}

/// Data of the nodes that were visited, each after its operands.
struct Search<'a> {
    is_mode: &'a [bool],
    by: HashMap<NodeId, By>,
    /// c_0 + c_1 t + c_2 t^2 for nodes that have this form, with coefficients of parameters.
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

    /// Returns the argument of a function that is flat far from a place, unless it is linear in time;
    /// of opposite arguments the same one.
    fn saturating(&self, graph: &Graph, id: NodeId) -> Option<NodeId> {
        use Function::{Atan, Cosh, Exp, Sinh, Tanh};
        let Op::Call(Exp | Tanh | Sinh | Cosh | Atan, argument) = graph.op(id) else {
            return None;
        };
        let argument = without_sign(graph, argument);
        let is_line = self.polynomials[&argument].is_some_and(|of| graph.is_zero(of[2]));
        (self.by[&argument] != By::Nothing && !is_line).then_some(argument)
    }

    /// Returns the times at which a function of time alone has its features.
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

/// Returns the node of which another one is the opposite, or that one.
fn without_sign(graph: &Graph, mut id: NodeId) -> NodeId {
    while let Op::Neg(opposite) = graph.op(id) {
        id = opposite;
    }
    id
}

/// Returns the time at which a linear polynomial crosses zero, or another one turns.
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
    // A slope that parameters make zero has no zero crossing. There is then no such time, for which
    // the start of all runs stands.
    let zero = graph.literal(0.0);
    let size = graph.call(Function::Abs, below);
    Some(graph.select_less(zero, size, time, zero))
}

/// Returns the time at which a function of this argument has its feature, if that takes a small
/// share of a run: steps see wider ones.
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

/// Returns the product of two polynomials, unless its degree exceeds two.
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

/// Returns the inner knots between which a table is curved, with the distance of the nearest knot:
/// the most curved ones, if there are many.
fn bends(table: &Table) -> Vec<(f64, f64)> {
    /// A table with more such knots changes nearly all the time, which makes it visible.
    const MOST: usize = 64;
    /// Share of the total change of the table.
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

//! The functions of a scene, assembled on one graph.

mod watched;

use std::collections::BTreeMap;
use std::ops::Range;

use machinist_algebra::expr::abbreviate::Abbreviations;
use machinist_algebra::expr::{Expr, Graph};
use machinist_model::evaluate::{Evaluator, Inputs};
use machinist_model::{
    Drawing, Element, MatrixTape, Model, NodeId, SparsityPattern, Tape, operations, reachable,
};

use crate::lower::angles::expand;
use crate::lower::describe::{constraints, describe, events};
use crate::lower::excitation::excitation;
use crate::lower::implicit::{Columns, Implicit, implicit};
use crate::lower::kinks::{Given, Kinks, Places, kinks};
use crate::lower::nonzeros::Nonzeros;
use crate::lower::reactions::{Reactions, Unknowns, without_reactions};
use crate::lower::share::{Parts, share};
use crate::lower::substitute::{Step, Substitution};
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::linearize::{Linearization, Partials};
use crate::mechanics::state::Motion;
use crate::scene::system::Drawn;

/// Lowers a scene to one tape for each function of a simulator. If the machine is large, a
/// further tape computes what several of them need.
#[must_use]
pub fn lower(linearization: &Linearization) -> Model {
    let mut build = Build::new(linearization);
    let system = &linearization.equations.system;
    let jacobians = build.jacobians();
    let time_derivative = build.time_derivative();
    let initial = build.initial_state();
    let [constraint_values, constraint_rates] = build.constraints();
    let [guards, guard_rates, resets] = build.events();
    let holds = [&constraint_values[..], &constraint_rates, &build.mass_entries()].concat();
    let mut found = build.kinks(&holds, &guards, &initial);
    let first_slot = (system.parameters.len() + system.handed.len()) as u32;
    let mut discontinuities: Vec<NodeId> =
        system.discontinuities.iter().map(|time| build.lower(time)).collect();
    for time in std::mem::take(&mut found.times) {
        if !discontinuities.contains(&time) {
            discontinuities.push(time);
        }
    }
    let outputs = linearization.equations.outputs.iter().map(|o| build.lower(o)).collect();
    let energy = linearization.equations.energy.each_ref().map(|e| build.lower(e));
    let power_balance = build.power_balance().to_vec();
    found.read_by_power(&mut build.graph, &power_balance);
    let Kinks { guards: kinks, rates: kink_rates, relations, slots, saturating, .. } = found;
    build.graph.hold(slots, first_slot);
    let motion = OfMotion { time_derivative, outputs, power_balance, guard_rates, kink_rates };
    let graph = &build.graph;
    let rate = graph.tape(&build.rate);
    // It includes the effects of fields, by parameters.
    let rows = [&build.rate[..], &guards, &kinks].concat();
    let model = Model {
        excitation: excitation(&graph.tape(&rows), &build.modes()),
        initial_state: graph.tape(&initial),
        discontinuities: graph.tape(&discontinuities),
        required: required(&linearization.equations),
        drawing: drawing(&linearization.equations),
        rate: expand(&rate),
        mass_matrix: build.mass_matrix_tape(),
        forcing: graph.tape(&build.forcing),
        energy: graph.tape(&energy),
        guards: graph.tape(&guards),
        resets: graph.tape(&resets),
        events: events(&linearization.equations),
        kink_guards: graph.tape(&kinks),
        saturating_arguments: graph.tape(&saturating),
        constraint_values: graph.tape(&constraint_values),
        constraint_rates: graph.tape(&constraint_rates),
        constraint_matrix: build.constraint_matrix_tape(),
        constraints: constraints(&linearization.equations),
        relations,
        ..describe(&linearization.equations)
    };
    build.of_motion(model, jacobians, &motion)
}

/// Returns requirements on values of parameters, on a separate graph: they share nothing with the
/// other functions.
fn required(equations: &EquationsOfMotion) -> Tape {
    let mut graph = Graph::for_scene(equations.layout.symbols());
    let required = equations.system.requirements.iter();
    let values: Vec<NodeId> = required.map(|required| graph.lower(&required.expr)).collect();
    graph.tape(&values)
}

/// Returns the drawing, on a separate graph: no function that simulates reads it.
fn drawing(equations: &EquationsOfMotion) -> Option<Drawing> {
    let drawn = &equations.system.drawing;
    let mut graph = Graph::for_scene(equations.layout.symbols());
    let element = |drawn: &Drawn| Element {
        kind: drawn.kind,
        name: drawn.name.clone(),
        is_of_inertia: drawn.is_of_inertia,
    };
    let elements = drawn.iter().map(element).collect();
    let places: Vec<NodeId> =
        drawn.iter().flat_map(|drawn| &drawn.numbers).map(|number| graph.lower(number)).collect();
    (!drawn.is_empty()).then(|| Drawing { elements, places: graph.tape(&places) })
}

/// Number of products of a solution for all columns of the Jacobian beyond which functions share
/// the motion. Below, the call costs about as much as it saves.
const LARGE: usize = 1500;

/// dy'/dy and dy'/dp.
enum Jacobians {
    /// Each column is solved on the graph; entries by rows.
    Unrolled([Vec<BTreeMap<usize, NodeId>>; 2]),
    /// Columns to be solved in a loop.
    Implicit([Columns; 2]),
}

/// Results of functions that need accelerations, which the Jacobians are not among.
struct OfMotion {
    time_derivative: Vec<NodeId>,
    outputs: Vec<NodeId>,
    power_balance: Vec<NodeId>,
    guard_rates: Vec<NodeId>,
    kink_rates: Vec<NodeId>,
}

impl OfMotion {
    fn each(&self) -> [&Vec<NodeId>; 5] {
        let [time, outputs, power] = [&self.time_derivative, &self.outputs, &self.power_balance];
        [time, outputs, power, &self.guard_rates, &self.kink_rates]
    }
}

/// The motion, and its factors on the graph.
struct Shared {
    motion: machinist_model::Motion,
    factors: Vec<NodeId>,
}

struct Build<'a> {
    linearization: &'a Linearization,
    abbreviations: Abbreviations,
    graph: Graph,
    /// M, bordered by G below and G^T beside it.
    matrix: Nonzeros,
    substitution: Substitution,
    /// Constraint forces that forces depend on.
    reactions: Reactions,
    forcing: Vec<NodeId>,
    /// q'', then -lambda.
    solution: Vec<NodeId>,
    /// y', one entry for each of the state.
    rate: Vec<NodeId>,
}

impl<'a> Build<'a> {
    fn new(linearization: &'a Linearization) -> Self {
        let equations = &linearization.equations;
        let system = &equations.system;
        let mut graph = Graph::for_scene(equations.layout.symbols());
        let abbreviations = Abbreviations::new(&equations.helpers);
        for (id, definition) in abbreviations.entries() {
            let node = graph.lower(definition);
            graph.name(node, &system.helpers[id.0 as usize].quantity.name.ident);
            graph.set_helper(*id, node);
        }
        let short = |expr: &Expr| abbreviations.apply(expr);
        let (rows, right_side) = equations.bordered();
        let mut matrix = Nonzeros::new(rows.len());
        for (row, entries) in rows.rows().enumerate() {
            for (column, entry) in entries {
                let node = graph.lower(&short(entry));
                matrix.set(&graph, (row, *column), node);
            }
        }
        let coordinates = equations.forcing.len();
        let is_singular = equations.is_singular();
        let substitution = Substitution::new(&mut graph, matrix.clone(), coordinates, is_singular);
        let lower = |graph: &mut Graph, expr: &Expr| graph.lower(&short(expr));
        let side = right_side.iter().map(|side| lower(&mut graph, &without_reactions(side)));
        let mut forcing: Vec<NodeId> = side.collect();
        let unknowns = Unknowns { reactions: &linearization.reactions, coordinates };
        let reactions = unknowns.reactions(&mut graph, &substitution, &forcing, lower);
        let mut solution = reactions.solve(&mut graph, &substitution, forcing.clone());
        if let Some(accelerations) = &equations.accelerations {
            let nodes = accelerations.iter().map(|entry| graph.lower(&short(entry)));
            let nodes: Vec<NodeId> = nodes.collect();
            let [factored, recursive] =
                [&solution, &nodes].map(|nodes| operations(&graph.tape(nodes)));
            if recursive < factored {
                solution = nodes;
            }
        }
        forcing.truncate(equations.forcing.len());
        let (accelerations, negative) = solution.split_at(forcing.len());
        for (coordinate, node) in system.coordinates.iter().zip(accelerations) {
            graph.name(*node, &format!("{}_dot", coordinate.velocity.name.ident));
        }
        let multipliers = super::shared_forces::shared(&mut graph, equations, negative, lower);
        for (constraint, node) in system.constraints.iter().zip(&multipliers) {
            graph.name(*node, &constraint.name.ident);
        }
        graph.set_accelerations(accelerations.to_vec(), multipliers);
        if !reactions.is_empty() {
            forcing = equations.forcing.iter().map(|side| lower(&mut graph, side)).collect();
        }
        let rates: Vec<NodeId> = equations.rates.iter().map(|h| graph.lower(&short(h))).collect();
        for (state, node) in system.first_order.iter().zip(&rates) {
            graph.name(*node, &format!("{}_dot", state.quantity.name.ident));
        }
        let rate = equations.layout.states.iter().map(|state| match &state.motion {
            Motion::Position { rate, .. } => graph.lower(&short(rate)),
            Motion::Velocity(id) => solution[id.0 as usize],
            Motion::FirstOrder(id) => rates[id.0 as usize],
        });
        let rate = rate.collect();
        Build {
            linearization,
            abbreviations,
            graph,
            matrix,
            substitution,
            reactions,
            forcing,
            solution,
            rate,
        }
    }

    fn lower(&mut self, expr: &Expr) -> NodeId {
        let short = self.abbreviations.apply(expr);
        self.graph.lower(&short)
    }

    fn coordinates(&self) -> usize {
        self.forcing.len()
    }

    /// Returns dy'/dy and dy'/dp.
    fn jacobians(&mut self) -> Jacobians {
        let partials = [&self.linearization.state, &self.linearization.parameters];
        let is_in_columns =
            self.reactions.is_empty() && self.linearization.rates_by_forces.is_empty();
        if is_in_columns && self.is_large() {
            Jacobians::Implicit(partials.map(|partials| self.columns(partials)))
        } else {
            let entries = self.velocity_entries();
            Jacobians::Unrolled(partials.map(|partials| {
                partials.iter().map(|partials| self.column(partials, &entries)).collect()
            }))
        }
    }

    /// Returns columns of a Jacobian of the rate, dy'/ds, to be solved.
    fn columns(&mut self, partials: &[Partials]) -> Columns {
        let mut columns = Columns { count: partials.len(), ..Columns::default() };
        for (column, partials) in partials.iter().enumerate() {
            let side = self.side(partials).into_iter();
            let is_read = |row: usize| self.substitution.is_read(row);
            let side = side.filter(|(row, node)| is_read(*row) && !self.graph.is_zero(*node));
            columns.sides.extend(side.map(|(row, node)| ((row, column), node)));
            for (entry, expr) in &partials.rates {
                let node = self.lower(expr);
                if !self.graph.is_zero(node) {
                    columns.given.insert((*entry, column), node);
                }
            }
        }
        columns
    }

    /// Returns the right side of the equations of dq''/ds.
    fn side(&mut self, partials: &Partials) -> BTreeMap<usize, NodeId> {
        let mut side = BTreeMap::new();
        for (row, expr) in &partials.forcing {
            side.insert(*row, self.lower(expr));
        }
        for (i, j, expr) in &partials.mass_matrix {
            let entry = self.lower(expr);
            self.subtract_product(&mut side, *i, entry, *j);
            if i != j {
                self.subtract_product(&mut side, *j, entry, *i);
            }
        }
        side
    }

    /// right_side\[row\] -= entry solution\[column\]
    fn subtract_product(
        &mut self,
        right_side: &mut BTreeMap<usize, NodeId>,
        row: usize,
        entry: NodeId,
        column: usize,
    ) {
        let part = self.graph.mul(entry, self.solution[column]);
        let before = right_side.get(&row).copied();
        let before = before.unwrap_or_else(|| self.graph.literal(0.0));
        right_side.insert(row, self.graph.sub(before, part));
    }

    /// Iterates over the entries of the state that are velocities, with their coordinates.
    fn velocities(&self) -> impl Iterator<Item = (usize, usize)> + use<'a> {
        let states = self.linearization.equations.layout.states.iter().enumerate();
        states.filter_map(|(entry, state)| match state.motion {
            Motion::Velocity(id) => Some((entry, id.0 as usize)),
            _ => None,
        })
    }

    /// Returns, for each coordinate, the entry of the state that is its velocity, if there is one.
    fn velocity_entries(&self) -> BTreeMap<usize, usize> {
        self.velocities().map(|(entry, coordinate)| (coordinate, entry)).collect()
    }

    /// Returns one column of a Jacobian of the rate: dy'/ds by entries, solved on the graph.
    fn column(
        &mut self,
        partials: &Partials,
        entries: &BTreeMap<usize, usize>,
    ) -> BTreeMap<usize, NodeId> {
        let side = self.side(partials);
        let by_forces = &self.linearization.rates_by_forces;
        let accelerations =
            self.reactions.solved(&mut self.graph, &self.substitution, side, !by_forces.is_empty());
        let mut column: BTreeMap<usize, NodeId> = accelerations
            .iter()
            .filter_map(|(coordinate, node)| Some((*entries.get(coordinate)?, *node)))
            .collect();
        for (entry, expr) in &partials.rates {
            column.insert(*entry, self.lower(expr));
        }
        for (row, slopes) in (self.coordinates()..).zip(by_forces) {
            let Some(negative) = accelerations.get(&row).copied() else { continue };
            for (entry, slope) in slopes {
                let slope = self.lower(slope);
                let part = self.graph.mul(slope, negative);
                let before = column.get(entry).copied();
                let before = before.unwrap_or_else(|| self.graph.literal(0.0));
                column.insert(*entry, self.graph.sub(before, part));
            }
        }
        column
    }

    /// Returns the partial derivative of the rate by time.
    fn time_derivative(&mut self) -> Vec<NodeId> {
        let entries = self.velocity_entries();
        let column = self.column(&self.linearization.time, &entries);
        let zero = self.graph.literal(0.0);
        (0..self.rate.len()).map(|entry| column.get(&entry).copied().unwrap_or(zero)).collect()
    }

    /// Returns a Jacobian each column of which is solved on the graph.
    fn unrolled(&mut self, columns: &Columns, velocities: &[(usize, usize)]) -> Implicit {
        let mut nonzeros = columns.given.clone();
        let mut sides = vec![BTreeMap::new(); columns.count];
        for ((row, column), node) in &columns.sides {
            sides[*column].insert(*row, *node);
        }
        for (column, side) in sides.into_iter().enumerate() {
            let solved = self.substitution.accelerations(&mut self.graph, side);
            for (entry, coordinate) in velocities {
                if let Some(node) = solved.get(coordinate) {
                    nonzeros.insert((*entry, column), *node);
                }
            }
        }
        let vanishes = self.graph.vanishing();
        nonzeros.retain(|_, node| !vanishes[node.0 as usize]);
        Implicit::unrolled(&nonzeros, self.rate.len(), columns.count)
    }

    /// Returns Jacobians given by columns, stored by rows, without vanishing nodes. They are one
    /// tape before they are separated, so that common parts have the same form in each.
    fn unrolled_matrices(&self, matrices: &[Vec<BTreeMap<usize, NodeId>>; 2]) -> [MatrixTape; 2] {
        let vanishes = self.graph.vanishing();
        let nonzeros = matrices.each_ref().map(|columns| {
            let entries = columns.iter().enumerate().flat_map(|(column, nodes)| {
                nodes.iter().map(move |(row, node)| (*row, column, *node))
            });
            let mut entries: Vec<_> =
                entries.filter(|(.., node)| !vanishes[node.0 as usize]).collect();
            entries.sort_unstable_by_key(|(row, column, _)| (*row, *column));
            entries
        });
        let all: Vec<NodeId> = nonzeros.iter().flatten().map(|(.., node)| *node).collect();
        let tape = expand(&self.graph.tape(&all));
        let mut results = &tape.results[..];
        let counts = matrices.each_ref().map(Vec::len);
        std::array::from_fn(|matrix| {
            let entries = &nonzeros[matrix];
            let (own, others) = results.split_at(entries.len());
            results = others;
            let entries = entries.iter().map(|(r, c, _)| (*r as u32, *c as u32)).collect();
            let (rows, columns) = (self.rate.len(), counts[matrix]);
            MatrixTape {
                pattern: SparsityPattern { rows, columns, entries },
                tape: reachable(&tape.nodes, own),
                solve: None,
            }
        })
    }

    /// Reports whether solving derivatives by factors is worthwhile: if factors change with the
    /// state, and unrolled solutions would be long.
    fn is_large(&self) -> bool {
        let steps = &self.substitution.steps;
        let factors = steps.iter().flat_map(Step::factors);
        let moves = factors.into_iter().any(|factor| !self.graph.is_constant(factor));
        let products: usize = steps.iter().map(|step| step.terms.len()).sum();
        moves && products * self.rate.len() >= LARGE
    }

    /// Adds the functions that need accelerations or factors.
    fn of_motion(mut self, model: Model, jacobians: Jacobians, motion: &OfMotion) -> Model {
        let columns = match jacobians {
            Jacobians::Implicit(columns) => columns,
            Jacobians::Unrolled(columns) => {
                let [rate_jacobian, parameter_jacobian] = self.unrolled_matrices(&columns);
                let [time_derivative, outputs, power_balance, guard_rates, kink_rates] =
                    motion.each().map(|results| self.graph.tape(results));
                return Model {
                    rate_jacobian,
                    parameter_jacobian,
                    time_derivative,
                    outputs,
                    power_balance,
                    guard_rates,
                    kink_rates,
                    ..model
                };
            }
        };
        let velocities: Vec<(usize, usize)> = self.velocities().collect();
        let implicit = columns.map(|columns| {
            let steps = &self.substitution.steps;
            let implicit = implicit(&columns, steps, &velocities, self.rate.len());
            if implicit.is_worth_a_loop() { implicit } else { self.unrolled(&columns, &velocities) }
        });
        let (shared, tapes) = self.shared(&implicit, motion);
        let [first, second, time_derivative, outputs, power_balance, guard_rates, kink_rates] =
            tapes;
        let [rate_jacobian, parameter_jacobian] = implicit;
        let with = |matrix: Implicit, tape| MatrixTape {
            solve: matrix.is_solved().then(|| matrix.solve(&shared.factors)),
            pattern: matrix.pattern,
            tape,
        };
        Model {
            rate_jacobian: with(rate_jacobian, first),
            parameter_jacobian: with(parameter_jacobian, second),
            time_derivative,
            outputs,
            power_balance,
            guard_rates,
            kink_rates,
            motion: Some(shared.motion),
            ..model
        }
    }

    /// Returns the motion, and the tapes that read it.
    fn shared(&self, matrices: &[Implicit; 2], motion: &OfMotion) -> (Shared, [Tape; 7]) {
        let mut factors: Vec<NodeId> = Vec::new();
        for factor in matrices.iter().flat_map(|matrix| &matrix.steps).flat_map(Step::factors) {
            if !factors.contains(&factor) {
                factors.push(factor);
            }
        }
        let scales = self.substitution.steps.iter().filter_map(|step| step.scale);
        let accelerations = self.velocities().map(|(_, id)| self.solution[id]);
        let costly = accelerations.chain(scales).filter(|id| !self.graph.is_constant(*id));
        let costly: Vec<NodeId> = costly.collect();
        let [first, second] = matrices.each_ref().map(|matrix| &matrix.inputs);
        let [time, outputs, power, guards, kinks] = motion.each();
        let functions = [first, second, time, outputs, power, guards, kinks];
        let lists = [&factors, &costly].into_iter().chain(functions);
        let all: Vec<NodeId> = lists.clone().flatten().copied().collect();
        let tape = expand(&self.graph.tape(&all));
        let mut results = tape.results.iter().copied();
        let mut lists = lists.map(|list| results.by_ref().take(list.len()).collect::<Vec<_>>());
        let [on_tape, costly] = [lists.next(), lists.next()].map(Option::unwrap_or_default);
        let parts = Parts { factors: on_tape, costly, functions: lists.collect() };
        let (motion, tapes) = share(&tape, &parts);
        let tapes = <[Tape; 7]>::try_from(tapes).expect("one tape for each function");
        (Shared { motion, factors }, tapes)
    }

    /// Returns the nonzero entries of M.
    fn mass_entries(&self) -> Vec<NodeId> {
        let n = self.coordinates();
        (0..n).flat_map(|row| self.matrix.row(row).range(..n).map(|(_, node)| *node)).collect()
    }

    fn mass_matrix_tape(&self) -> MatrixTape {
        let n = self.coordinates();
        self.part_tape(0..n)
    }

    fn constraint_matrix_tape(&self) -> MatrixTape {
        self.part_tape(self.coordinates()..self.solution.len())
    }

    /// Returns rows of the matrix, without the border.
    fn part_tape(&self, rows: Range<usize>) -> MatrixTape {
        let n = self.coordinates();
        let entries: Vec<_> = (0..)
            .zip(rows.clone())
            .flat_map(|(place, row)| {
                self.matrix.row(row).range(..n).map(move |(column, node)| (place, *column, *node))
            })
            .collect();
        self.matrix_tape((rows.len(), n), &entries)
    }

    /// Returns a matrix by its nonzeros, row by row.
    fn matrix_tape(
        &self,
        (rows, columns): (usize, usize),
        nonzeros: &[(usize, usize, NodeId)],
    ) -> MatrixTape {
        let results: Vec<NodeId> = nonzeros.iter().map(|(.., node)| *node).collect();
        let entries = nonzeros.iter().map(|(r, c, _)| (*r as u32, *c as u32)).collect();
        MatrixTape {
            pattern: SparsityPattern { rows, columns, entries },
            tape: self.graph.tape(&results),
            solve: None,
        }
    }

    /// Returns the initial y.
    fn initial_state(&mut self) -> Vec<NodeId> {
        let states = &self.linearization.equations.layout.states;
        states.iter().map(|state| self.lower(&state.initial)).collect()
    }

    /// Returns dE/dt by the chain rule, power supplied, power dissipated.
    fn power_balance(&mut self) -> [NodeId; 3] {
        let linearization = self.linearization;
        let stored = self.total_derivative(|partials| &partials.energy);
        let by_time = self.total_derivative(|partials| &partials.time_momentum);
        let supplied = self.lower(&linearization.equations.supplied);
        let supplied = self.graph.add(supplied, by_time);
        let dissipated = self.lower(&linearization.equations.dissipated);
        [stored, supplied, dissipated]
    }

    /// Returns the surfaces at which the rate, the guards, or whether a constraint holds, are not
    /// smooth or change within a very short time. Those of fields themselves are not included: they
    /// are not on the graph.
    fn kinks(&mut self, holds: &[NodeId], guards: &[NodeId], initial: &[NodeId]) -> Kinks {
        let equations = &self.linearization.equations;
        let is_mode = self.modes();
        let is_place = |state: &crate::mechanics::state::State| {
            matches!(state.motion, Motion::Position { .. })
        };
        let is_place: Vec<bool> = equations.layout.states.iter().map(is_place).collect();
        let run = &equations.system.run;
        let parameters: Vec<f64> = equations.system.parameters.iter().map(|p| p.value).collect();
        let mut start = vec![0.0; initial.len()];
        let inputs = Inputs { time: run.from, parameters: &parameters, ..Inputs::default() };
        Evaluator::new(&self.graph.tape(initial)).evaluate(&inputs, &mut start);
        let given = Given {
            is_mode: &is_mode,
            is_place: &is_place,
            start: &start,
            tables: &equations.system.tables,
            run: (run.from, run.until),
            parameters: &parameters,
        };
        let places = Places { rate: &self.rate, holds, guards };
        kinks(&mut self.graph, &places, &given)
    }

    /// Returns, for each entry of the state, whether only events change it.
    fn modes(&self) -> Vec<bool> {
        let equations = &self.linearization.equations;
        let is_mode = |state: &crate::mechanics::state::State| match state.motion {
            Motion::FirstOrder(id) => equations.system.first_order[id.0 as usize].is_mode,
            _ => false,
        };
        equations.layout.states.iter().map(is_mode).collect()
    }

    /// Returns dX/dt = dX/dy y' + partial dX/dt.
    fn total_derivative(&mut self, of: impl Fn(&Partials) -> &Expr) -> NodeId {
        let mut total = self.lower(of(&self.linearization.time));
        for (index, partials) in self.linearization.state.iter().enumerate() {
            let slope = self.lower(of(partials));
            let part = self.graph.mul(slope, self.rate[index]);
            total = self.graph.add(total, part);
        }
        total
    }
}

//! The functions of a scene, put together on one graph.

use super::graph::Graph;
use crate::abbreviate::Abbreviations;
use crate::expr::Expr;
use crate::factor::{Factorization, factor};
use crate::linearize::{Linearization, Partials};
use crate::program::{MatrixTape, Program, SparsityPattern};
use crate::state::Motion;
use crate::tape::NodeId;

/// One tape for each function of a simulator.
#[must_use]
pub fn lower(linearization: &Linearization) -> Program {
    let mut build = Build::new(linearization);
    let system = &linearization.equations.system;
    let rate_jacobian = build.jacobian(&linearization.state);
    let parameter_jacobian = build.jacobian(&linearization.parameters);
    let time_column = build.column(&linearization.time);
    let initial = build.initial_state();
    let discontinuities: Vec<NodeId> =
        system.discontinuities.iter().map(|time| build.lower(time)).collect();
    let outputs: Vec<NodeId> =
        linearization.equations.outputs.iter().map(|output| build.lower(output)).collect();
    let energy = linearization.equations.energy.each_ref().map(|e| build.lower(e));
    let balance = build.power_balance();
    let graph = &build.graph;
    Program {
        initial_state: graph.tape(&initial),
        discontinuities: graph.tape(&discontinuities),
        rate: graph.tape(&build.rate),
        rate_jacobian,
        parameter_jacobian,
        time_derivative: graph.tape(&time_column),
        mass_matrix: build.mass_matrix_tape(),
        forcing: graph.tape(&build.forcing),
        outputs: graph.tape(&outputs),
        energy: graph.tape(&energy),
        power_balance: graph.tape(&balance),
        system: system.clone(),
        layout: linearization.equations.layout.clone(),
        fields: Vec::new(),
        reduction: linearization.equations.reduction.clone(),
    }
}

struct Build<'a> {
    linearization: &'a Linearization,
    abbreviations: Abbreviations,
    graph: Graph,
    mass_matrix: Vec<Vec<NodeId>>,
    factorization: Factorization,
    forcing: Vec<NodeId>,
    /// q''
    accelerations: Vec<NodeId>,
    /// y', an entry for each of the state.
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
        let rows = equations.mass_matrix.iter();
        let mass_matrix: Vec<Vec<NodeId>> =
            rows.map(|row| row.iter().map(|e| graph.lower(&short(e))).collect()).collect();
        let factorization = factor(&mut graph, &mass_matrix);
        let forcing: Vec<NodeId> =
            equations.forcing.iter().map(|f| graph.lower(&short(f))).collect();
        let accelerations = factorization.solve(&mut graph, &forcing);
        for (coordinate, node) in system.coordinates.iter().zip(&accelerations) {
            graph.name(*node, &format!("{}_dot", coordinate.velocity.name.ident));
        }
        graph.set_accelerations(accelerations.clone());
        let rates: Vec<NodeId> = equations.rates.iter().map(|h| graph.lower(&short(h))).collect();
        for (state, node) in system.first_order.iter().zip(&rates) {
            graph.name(*node, &format!("{}_dot", state.quantity.name.ident));
        }
        let rate = equations.layout.states.iter().map(|state| match &state.motion {
            Motion::Position { rate, .. } => graph.lower(&short(rate)),
            Motion::Velocity(id) => accelerations[id.0 as usize],
            Motion::FirstOrder(id) => rates[id.0 as usize],
        });
        let rate = rate.collect();
        Build {
            linearization,
            abbreviations,
            graph,
            mass_matrix,
            factorization,
            forcing,
            accelerations,
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

    /// One column of a Jacobian of the rate: dy'/ds.
    fn column(&mut self, partials: &Partials) -> Vec<NodeId> {
        let n = self.coordinates();
        let zero = self.graph.literal(0.0);
        let mut right_side = vec![zero; n];
        for (row, expr) in &partials.forcing {
            right_side[*row] = self.lower(expr);
        }
        for (i, j, expr) in &partials.mass_matrix {
            let entry = self.lower(expr);
            self.subtract_product(&mut right_side, *i, entry, *j);
            if i != j {
                self.subtract_product(&mut right_side, *j, entry, *i);
            }
        }
        let accelerations = self.factorization.solve(&mut self.graph, &right_side);
        let mut column = vec![zero; self.rate.len()];
        for (entry, state) in self.linearization.equations.layout.states.iter().enumerate() {
            if let Motion::Velocity(id) = state.motion {
                column[entry] = accelerations[id.0 as usize];
            }
        }
        for (entry, expr) in &partials.rates {
            column[*entry] = self.lower(expr);
        }
        column
    }

    /// right_side\[row\] -= entry q''\[column\]
    fn subtract_product(
        &mut self,
        right_side: &mut [NodeId],
        row: usize,
        entry: NodeId,
        column: usize,
    ) {
        let part = self.graph.mul(entry, self.accelerations[column]);
        right_side[row] = self.graph.sub(right_side[row], part);
    }

    /// A Jacobian by columns, stored by rows.
    fn jacobian(&mut self, columns: &[Partials]) -> MatrixTape {
        let columns: Vec<Vec<NodeId>> = columns.iter().map(|p| self.column(p)).collect();
        self.matrix_tape(self.rate.len(), columns.len(), |row, column| columns[column][row])
    }

    fn mass_matrix_tape(&self) -> MatrixTape {
        let n = self.coordinates();
        self.matrix_tape(n, n, |row, column| self.mass_matrix[row][column])
    }

    fn matrix_tape(
        &self,
        rows: usize,
        columns: usize,
        entry: impl Fn(usize, usize) -> NodeId,
    ) -> MatrixTape {
        let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let nonzeros: Vec<(usize, usize)> =
            places.filter(|(row, column)| !self.graph.is_zero(entry(*row, *column))).collect();
        let results: Vec<NodeId> = nonzeros.iter().map(|(r, c)| entry(*r, *c)).collect();
        let entries = nonzeros.iter().map(|(r, c)| (*r as u32, *c as u32)).collect();
        MatrixTape {
            pattern: SparsityPattern { rows, columns, entries },
            tape: self.graph.tape(&results),
        }
    }

    /// y at the start.
    fn initial_state(&mut self) -> Vec<NodeId> {
        let states = &self.linearization.equations.layout.states;
        states.iter().map(|state| self.lower(&state.initial)).collect()
    }

    /// dE/dt by the chain rule, power supplied, power dissipated.
    fn power_balance(&mut self) -> [NodeId; 3] {
        let linearization = self.linearization;
        let stored = self.total_derivative(|partials| &partials.energy);
        let by_time = self.total_derivative(|partials| &partials.time_momentum);
        let supplied = self.lower(&linearization.equations.supplied);
        let supplied = self.graph.add(supplied, by_time);
        let dissipated = self.lower(&linearization.equations.dissipated);
        [stored, supplied, dissipated]
    }

    /// dX/dt = dX/dy y' + partial dX/dt.
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

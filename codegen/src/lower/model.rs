//! The functions of a scene, put together on one graph.

use machinist_model::{
    Constraint, Coordinate, Event, MatrixTape, Model, NodeId, Parameter, SourceFile,
    SparsityPattern, State, StateKind,
};

use crate::expr::abbreviate::Abbreviations;
use crate::expr::{Expr, Graph, Symbol};
use crate::lower::angles::expand;
use crate::lower::excitation::excitation;
use crate::lower::factor::{Factorization, factor};
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::linearize::{Linearization, Partials};
use crate::mechanics::state::Motion;
use crate::scene::system::LagrangianSystem;

/// One tape for each function of a simulator.
#[must_use]
pub fn lower(linearization: &Linearization) -> Model {
    let mut build = Build::new(linearization);
    let system = &linearization.equations.system;
    let mut rate_jacobian = build.jacobian(&linearization.state);
    rate_jacobian.tape = expand(&rate_jacobian.tape);
    let parameter_jacobian = build.jacobian(&linearization.parameters);
    let time_column = build.column(&linearization.time);
    let initial = build.initial_state();
    let discontinuities: Vec<NodeId> =
        system.discontinuities.iter().map(|time| build.lower(time)).collect();
    let outputs: Vec<NodeId> =
        linearization.equations.outputs.iter().map(|output| build.lower(output)).collect();
    let energy = linearization.equations.energy.each_ref().map(|e| build.lower(e));
    let balance = build.power_balance();
    let [guards, guard_rates, resets] = build.events();
    let [constraint_values, constraint_rates] = build.constraints();
    let graph = &build.graph;
    let rate = graph.tape(&build.rate);
    // What events and constraints do is not in the rate. What fields do is, by parameters.
    let is_whole = system.events.is_empty() && system.constraints.is_empty();
    let about = describe(&linearization.equations);
    Model {
        excitation: is_whole.then(|| excitation(&rate)).flatten(),
        initial_state: graph.tape(&initial),
        discontinuities: graph.tape(&discontinuities),
        rate: expand(&rate),
        rate_jacobian,
        parameter_jacobian,
        time_derivative: graph.tape(&time_column),
        mass_matrix: build.mass_matrix_tape(),
        forcing: graph.tape(&build.forcing),
        outputs: graph.tape(&outputs),
        energy: graph.tape(&energy),
        power_balance: graph.tape(&balance),
        guards: graph.tape(&guards),
        guard_rates: graph.tape(&guard_rates),
        resets: graph.tape(&resets),
        events: events(&linearization.equations),
        constraint_values: graph.tape(&constraint_values),
        constraint_rates: graph.tape(&constraint_rates),
        constraint_matrix: build.constraint_matrix_tape(),
        constraints: constraints(system),
        ..about
    }
}

/// What a model says of itself, without its tapes.
fn describe(equations: &EquationsOfMotion) -> Model {
    let system = &equations.system;
    let coordinate = |c: &crate::scene::system::Coordinate| Coordinate {
        position: c.position.clone(),
        velocity: c.velocity.clone(),
    };
    let file = |file: &crate::spec::SourceFile| SourceFile {
        label: file.label.clone(),
        sha256: file.sha256.clone(),
    };
    let parameter = |p: &crate::scene::system::Parameter| Parameter {
        quantity: p.quantity.clone(),
        value: p.value,
    };
    Model {
        name: system.name.clone(),
        title: system.title.clone(),
        doc: system.doc.clone(),
        source: system.source.clone(),
        files: system.files.iter().map(file).collect(),
        coordinates: system.coordinates.iter().map(coordinate).collect(),
        states: states(equations),
        quadratures: equations.layout.quadratures,
        parameters: system.parameters.iter().map(parameter).collect(),
        handed: system.handed.iter().map(parameter).collect(),
        wanted: system.outputs.iter().map(|output| output.quantity.clone()).collect(),
        tables: system.tables.clone(),
        run: system.run.clone(),
        freeze: system.freeze.clone(),
        reduction: equations.reduction.clone(),
        ..Model::default()
    }
}

fn states(equations: &EquationsOfMotion) -> Vec<State> {
    let system = &equations.system;
    let states = equations.layout.states.iter().map(|state| {
        let (kind, is_given) = match state.motion {
            Motion::Position { coordinate, .. } => {
                let is_given = system.coordinates[coordinate.0 as usize].is_given[0];
                (StateKind::Position(coordinate.0), is_given)
            }
            Motion::Velocity(id) => {
                (StateKind::Velocity(id.0), system.coordinates[id.0 as usize].is_given[1])
            }
            Motion::FirstOrder(id) if system.first_order[id.0 as usize].is_mode => {
                (StateKind::Mode, true)
            }
            Motion::FirstOrder(_) => (StateKind::FirstOrder, true),
        };
        State { quantity: state.quantity.clone(), kind, scale: state.scale, is_given }
    });
    states.collect()
}

/// Events with entries of the state in place of what expressions call them.
fn events(equations: &EquationsOfMotion) -> Vec<Event> {
    let entry = |symbol: Symbol| {
        let place = equations.layout.symbols().position(|known| known == symbol);
        place.expect("what events watch and set is in the state") as u32
    };
    let shapes = equations.events.iter().map(|event| Event {
        name: event.name.clone(),
        doc: event.doc.clone(),
        direction: event.direction,
        when: event
            .when
            .iter()
            .map(|(id, value)| (entry(Symbol::FirstOrder(*id)), f64::from(*value)))
            .collect(),
        sets: event.set.iter().map(|(symbol, _)| entry(*symbol)).collect(),
    });
    shapes.collect()
}

fn constraints(system: &LagrangianSystem) -> Vec<Constraint> {
    let shapes = system.constraints.iter().map(|constraint| Constraint {
        name: constraint.name.clone(),
        doc: constraint.doc.clone(),
        unit: constraint.unit.clone(),
        is_of_positions: constraint.is_of_positions,
    });
    shapes.collect()
}

struct Build<'a> {
    linearization: &'a Linearization,
    abbreviations: Abbreviations,
    graph: Graph,
    /// M, bordered by G below and G^T beside it.
    matrix: Vec<Vec<NodeId>>,
    factorization: Factorization,
    forcing: Vec<NodeId>,
    /// q'', then -lambda.
    solution: Vec<NodeId>,
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
        let (rows, right_side) = equations.bordered();
        let matrix: Vec<Vec<NodeId>> =
            rows.iter().map(|row| row.iter().map(|e| graph.lower(&short(e))).collect()).collect();
        let factorization = factor(&mut graph, &matrix);
        let mut forcing: Vec<NodeId> = right_side.iter().map(|f| graph.lower(&short(f))).collect();
        let solution = factorization.solve(&mut graph, &forcing);
        forcing.truncate(equations.forcing.len());
        let (accelerations, negative) = solution.split_at(forcing.len());
        for (coordinate, node) in system.coordinates.iter().zip(accelerations) {
            graph.name(*node, &format!("{}_dot", coordinate.velocity.name.ident));
        }
        let multipliers = negative.iter().map(|node| graph.neg(*node)).collect::<Vec<_>>();
        for (constraint, node) in system.constraints.iter().zip(&multipliers) {
            graph.name(*node, &constraint.name.ident);
        }
        graph.set_accelerations(accelerations.to_vec(), multipliers);
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
            factorization,
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

    /// One column of a Jacobian of the rate: dy'/ds.
    fn column(&mut self, partials: &Partials) -> Vec<NodeId> {
        let zero = self.graph.literal(0.0);
        let mut right_side = vec![zero; self.solution.len()];
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

    /// right_side\[row\] -= entry solution\[column\]
    fn subtract_product(
        &mut self,
        right_side: &mut [NodeId],
        row: usize,
        entry: NodeId,
        column: usize,
    ) {
        let part = self.graph.mul(entry, self.solution[column]);
        right_side[row] = self.graph.sub(right_side[row], part);
    }

    /// A Jacobian by columns, stored by rows.
    fn jacobian(&mut self, columns: &[Partials]) -> MatrixTape {
        let columns: Vec<Vec<NodeId>> = columns.iter().map(|p| self.column(p)).collect();
        self.matrix_tape(self.rate.len(), columns.len(), |row, column| columns[column][row])
    }

    fn mass_matrix_tape(&self) -> MatrixTape {
        let n = self.coordinates();
        self.matrix_tape(n, n, |row, column| self.matrix[row][column])
    }

    fn constraint_matrix_tape(&self) -> MatrixTape {
        let n = self.coordinates();
        let count = self.solution.len() - n;
        self.matrix_tape(count, n, |row, column| self.matrix[n + row][column])
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

    /// Guards, their rates along the motion, and new values.
    fn events(&mut self) -> [Vec<NodeId>; 3] {
        let linearization = self.linearization;
        let events = &linearization.equations.events;
        let guards = events.iter().map(|event| self.lower(&event.guard)).collect();
        let indices = 0..events.len();
        let rates = indices.map(|index| self.total_derivative(|p| &p.guards[index])).collect();
        let values = events.iter().flat_map(|event| &event.set);
        let resets = values.map(|(_, value)| self.lower(value)).collect();
        [guards, rates, resets]
    }

    /// g and g'.
    fn constraints(&mut self) -> [Vec<NodeId>; 2] {
        let constraints = &self.linearization.equations.constraints;
        [&constraints.values, &constraints.rates]
            .map(|exprs| exprs.iter().map(|expr| self.lower(expr)).collect())
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

//! Values of expressions over the run of a variant.

use crate::improve::{Expression, value_of_run};
use crate::method::Work;
use crate::simulate::Simulation;
use crate::sweep::VariantRun;
use crate::trajectory::{Column, ColumnKind, Switch, Trajectory};

/// Returns the value of an expression over the run of a variant. `simulation` has the parameters of
/// the variant.
///
/// NaN if the expression contains a name that the machine does not have; see
/// [`check`](crate::improve::check).
#[must_use]
pub fn value_over(expression: &Expression, simulation: &Simulation<'_>, run: &VariantRun) -> f64 {
    let simulator = simulation.simulator();
    let shape = simulator.shape();
    let mut columns: Vec<Column> = Vec::new();
    expression.for_each_name(&mut |name, _, is_within| {
        if !is_within || columns.iter().any(|known| known.name == name) {
            return;
        }
        // If a state and an output share a name, the state is taken, as in a run.
        let state = (0..shape.states()).find(|index| simulator.state(*index).name == name);
        let output = || (0..shape.outputs).find(|index| simulator.output(*index).name == name);
        let values = match (state, state.is_none().then(output).flatten()) {
            (Some(index), _) => run.states.iter().map(|row| row[index]).collect(),
            (None, Some(index)) => run.outputs.iter().map(|row| row[index]).collect(),
            (None, None) => return,
        };
        let (name, unit, doc) = (name.to_owned(), String::new(), String::new());
        columns.push(Column { name, unit, kind: ColumnKind::Output, doc, values });
    });
    let switches = run.events.iter().map(|time| Switch { time: *time, event: String::new() });
    let run = Trajectory {
        scene: String::new(),
        title: String::new(),
        method: crate::Method::Auto,
        rtol: simulation.relative_tolerance(),
        work: Work::default(),
        notes: Vec::new(),
        stopped: None,
        switches: switches.collect(),
        drift: None,
        times: run.times.clone(),
        columns,
        energy_balance: None,
        error: None,
    };
    value_of_run(expression, simulation, &run)
}

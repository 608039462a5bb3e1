//! Description of a model, without its tapes.

use machinist_algebra::expr::Symbol;
use machinist_model::{
    Constraint, Coordinate, Event, Model, Parameter, Reduction, SourceFile, State, StateKind, What,
    Why,
};

use crate::lower::checks::checks;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::state::Motion;

/// Returns the description of a model, without its tapes.
pub fn describe(equations: &EquationsOfMotion) -> Model {
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
    let parameters: Vec<Parameter> = system.parameters.iter().map(parameter).collect();
    Model {
        name: system.name.clone(),
        title: system.title.clone(),
        doc: system.doc.clone(),
        source: system.source.clone(),
        files: system.files.iter().map(file).collect(),
        coordinates: system.coordinates.iter().map(coordinate).collect(),
        states: states(equations),
        quadratures: equations.layout.quadratures,
        checks: checks(system, &parameters),
        parameters,
        handed: system.handed.iter().map(parameter).collect(),
        wanted: system.outputs.iter().map(|output| output.quantity.clone()).collect(),
        at_once: at_once(equations),
        tables: system.tables.clone(),
        run: system.run.clone(),
        freeze: system.freeze.clone(),
        reduction: reduction(equations),
        starts_in_equilibrium: system.starts_in_equilibrium,
        requirements: system.requirements.iter().map(|one| one.requirement.clone()).collect(),
        ..Model::default()
    }
}

/// Returns the parts left out, including redundant constraints.
fn reduction(equations: &EquationsOfMotion) -> Reduction {
    let mut reduction = equations.reduction.clone();
    for constraint in equations.system.constraints.iter().filter(|one| one.is_dropped) {
        let instead = if constraint.expr.is_zero() {
            "it is zero in any position"
        } else if equations.system.shares_redundant {
            "it shares its force with the constraints it follows from"
        } else {
            "the constraints it follows from carry its force"
        };
        reduction.add(What::Constraint, &constraint.name.path, Why::Redundant, instead);
    }
    reduction
}

/// Returns the outputs that contain accelerations or constraint forces.
fn at_once(equations: &EquationsOfMotion) -> Vec<u32> {
    let answers = |symbol| matches!(symbol, Symbol::Acceleration(_) | Symbol::Multiplier(_));
    let outputs = (0..).zip(&equations.outputs);
    let at_once = outputs.filter(|(_, output)| output.mentions(answers));
    at_once.map(|(index, _)| index).collect()
}

fn states(equations: &EquationsOfMotion) -> Vec<State> {
    let system = &equations.system;
    let states = equations.layout.states.iter().map(|state| {
        let (kind, is_given) = match state.motion {
            Motion::Position { coordinate, .. }
                if coordinate.0 as usize >= system.coordinates.len() =>
            {
                let number = coordinate.0 as usize - system.coordinates.len();
                let own = system.orientations.iter().nth(number);
                let first = own.map_or(0, |orientation| orientation.vector[0].0);
                (StateKind::Position(first), system.scalars[number].is_given)
            }
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

/// Returns the entry of the state that a symbol has.
fn entry(equations: &EquationsOfMotion, symbol: Symbol) -> u32 {
    let place = equations.layout.symbols().position(|known| known == symbol);
    place.expect("what events watch and set is in the state") as u32
}

/// Returns the events, with entries of the state in place of symbols.
pub fn events(equations: &EquationsOfMotion) -> Vec<Event> {
    let entry = |symbol: Symbol| entry(equations, symbol);
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

/// Returns the descriptions of the constraints.
pub fn constraints(equations: &EquationsOfMotion) -> Vec<Constraint> {
    let shapes = equations.system.constraints.iter().map(|constraint| Constraint {
        name: constraint.name.clone(),
        doc: constraint.doc.clone(),
        unit: constraint.unit.clone(),
        is_of_positions: constraint.is_of_positions,
        in_modes: !constraint.holds_always(),
        friction: constraint.friction_mode().map(|mode| entry(equations, Symbol::FirstOrder(mode))),
        jumps: constraint.friction.unwrap_or_default().jumps,
    });
    shapes.collect()
}

//! Description of a scene from its spec, without derivation.

use machinist_codegen::scene::system::{self, LagrangianSystem};
use machinist_codegen::spec::{
    ConstraintSpec, EventSpec, InstanceSpec, SceneSpec, Sources, UnitSpec, one_line,
};

use super::description::{
    Check, Constraint, Description, Event, Field, Input, Instance, Joint, Kind, Parameter, Port,
    Quantity, State, described_values,
};

impl Description {
    /// Describes a spec and the system composed from it.
    pub fn of_spec(spec: &SceneSpec, system: &LagrangianSystem) -> Self {
        let parameters = system.parameters.iter().map(|parameter| Parameter {
            quantity: Quantity::of(&parameter.quantity),
            value: parameter.value,
            tunable: parameter.tunable,
        });
        let fields = system.fields.iter().map(|field| Field {
            quantity: Quantity::of(&field.quantities[0]),
            length: field.length_value,
            elements: field.elements,
            order: field.order,
        });
        let joints = spec.joints.iter().map(|joint| Joint {
            connect: joint.connect.each_ref().map(|port| port.value.clone()),
            ratio: joint.ratio.as_ref().map_or("1".to_owned(), |ratio| spec.sources.formula(ratio)),
        });
        Self {
            scene: system.name.clone(),
            title: system.title.clone(),
            doc: system.doc.clone(),
            source: system.source.clone(),
            instances: spec.instances.iter().map(|one| instance(spec, one)).collect(),
            joints: joints.collect(),
            parameters: parameters.collect(),
            fields: fields.collect(),
            states: states(system),
            outputs: system.outputs.iter().map(|output| Quantity::of(&output.quantity)).collect(),
            events: of_all(spec, |unit| &unit.events, &spec.events, event),
            constraints: constraints(spec, system),
            loops: system.notes.clone(),
            checks: system.checks.iter().map(check).collect(),
            rigid: system.freeze.rigid.clone(),
            run: system.run.clone(),
        }
    }
}

fn instance(spec: &SceneSpec, instance: &InstanceSpec) -> Instance {
    let unit = &spec.units[instance.unit];
    let ports = unit.ports.iter().map(|port| {
        let coordinate = &port.coordinate.value;
        Port {
            name: port.name.value.clone(),
            kind: port.kind.value.name(),
            moves: match &port.ratio {
                None => coordinate.clone(),
                Some(ratio) => format!("({})*{coordinate}", spec.sources.formula(ratio)),
            },
        }
    });
    let inputs = instance.inputs.iter().map(|(name, formula)| {
        let declared = unit.inputs.iter().find(|input| input.name.value == name.value);
        Input {
            name: name.value.clone(),
            unit: declared.map_or_else(String::new, |input| input.unit.text.clone()),
            expression: spec.sources.formula(formula),
        }
    });
    Instance {
        name: instance.name.value.clone(),
        unit: unit.name.clone(),
        title: unit.title.clone(),
        ports: ports.collect(),
        inputs: inputs.collect(),
    }
}

/// Returns positions, then velocities, then first-order states.
fn states(system: &LagrangianSystem) -> Vec<State> {
    let (any_moves, can_move) = (system.starts_in_equilibrium, !system.constraints.is_empty());
    let state = |which: usize, kind| {
        move |coordinate: &system::Coordinate| State {
            quantity: Quantity::of([&coordinate.position, &coordinate.velocity][which]),
            kind,
            initial: system.value(&coordinate.initial[which]),
            is_guess: any_moves || can_move && !coordinate.is_given[which],
            joined: match kind {
                Kind::Coordinate => coordinate.identified.iter().map(|(n, _)| n.clone()).collect(),
                _ => Vec::new(),
            },
        }
    };
    let first_order = system.first_order.iter().map(|state| State {
        quantity: Quantity::of(&state.quantity),
        kind: if state.is_mode { Kind::Mode } else { Kind::FirstOrder },
        initial: system.value(&state.initial),
        is_guess: any_moves && !state.is_mode,
        joined: Vec::new(),
    });
    let positions = system.coordinates.iter().map(state(0, Kind::Coordinate));
    let velocities = system.coordinates.iter().map(state(1, Kind::Velocity));
    positions.chain(velocities).chain(first_order).collect()
}

/// Describes the elements of all instances, then those of the scene.
fn of_all<S, T>(
    spec: &SceneSpec,
    of_unit: impl Fn(&UnitSpec) -> &[S],
    of_scene: &[S],
    describe: impl Fn(&Sources, &str, &S) -> T,
) -> Vec<T> {
    let mut all = Vec::new();
    for instance in &spec.instances {
        let prefix = format!("{}.", instance.name.value);
        let found = of_unit(&spec.units[instance.unit]).iter();
        all.extend(found.map(|one| describe(&spec.sources, &prefix, one)));
    }
    all.extend(of_scene.iter().map(|one| describe(&spec.sources, "", one)));
    all
}

fn event(sources: &Sources, prefix: &str, event: &EventSpec) -> Event {
    let set = event.set.iter().map(|(name, formula)| {
        let value = sources.formula(formula);
        (format!("{prefix}{}", name.value), Some(value))
    });
    let when = event.when.iter().map(|(mode, value)| (format!("{prefix}{}", mode.value), *value));
    Event {
        name: format!("{prefix}{}", event.name.value),
        doc: one_line(&event.doc),
        guard: Some(sources.expression(event.guard.span)),
        direction: event.direction.name(),
        when: when.collect(),
        set: set.collect(),
    }
}

/// Returns the constraints of the text, and those that close loops.
fn constraints(spec: &SceneSpec, system: &LagrangianSystem) -> Vec<Constraint> {
    let mut all = of_all(spec, |unit| &unit.constraints, &spec.constraints, constraint);
    let closing = system.constraints.iter().skip(all.len());
    all.extend(closing.map(|constraint| Constraint {
        name: constraint.name.path.clone(),
        doc: constraint.doc.clone(),
        expression: None,
        when: Vec::new(),
    }));
    all
}

fn constraint(sources: &Sources, prefix: &str, constraint: &ConstraintSpec) -> Constraint {
    let when = constraint.when.iter();
    let when = when.map(|(mode, value)| (format!("{prefix}{}", mode.value), *value));
    Constraint {
        name: format!("{prefix}{}", constraint.name.value),
        doc: one_line(&constraint.doc),
        expression: Some(sources.expression(constraint.expression.span)),
        when: when.collect(),
    }
}

fn check(check: &system::Check) -> Check {
    Check {
        name: check.name.clone(),
        of: check.of.clone(),
        reference: match &check.reference {
            system::Reference::Closed { text, .. } => one_line(text),
            system::Reference::Values(rows) => described_values(rows),
        },
        tolerance: check.tolerance,
        absolute: check.absolute,
        source: check.source.clone(),
    }
}

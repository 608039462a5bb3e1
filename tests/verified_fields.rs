//! The row of sensitivities in the checks of any machine, for scenes with fields.

use machinist::Simulation;
use machinist::field::{Discretisation, FieldSimulator};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::{Model, ModelSimulator, Node, NodeId, Op, Tape};
use machinist_studies::verify::Verdict;
use machinist_studies::verify::automatic::{Subject, verify_machine};

use crate::own_scene::model_of_specs;

/// Returns the row of sensitivities for a shaft between rotors, whose model may be wrong.
fn row(model: Model) -> Verdict {
    let scene = ModelSimulator::new(model);
    let divided = |elements: usize| {
        let wanted = Discretisation { elements: Some(elements), order: Some(2) };
        let cut = FieldSimulator::new(scene.with_fields(), wanted).expect("elements");
        cut.with_derivatives(scene.with_fields_on_duals())
    };
    let (many, few) = (divided(8), divided(4));
    let simulation = |cut| Simulation::new(cut).until(0.01).points(101);
    let subject = Subject {
        simulation: simulation(many.single()),
        in_few_elements: Some(Ok(simulation(few.single()))),
        twin: Err("not asked for"),
        independent: Err("not asked for".to_owned()),
        own: Vec::new(),
        only: Some("sensitivities".to_owned()),
    };
    let mut rows = verify_machine(&subject);
    assert_eq!(rows.len(), 1, "one row is asked for");
    rows.remove(0)
}

/// Multiplies every result of a tape.
fn scale(tape: &mut Tape, factor: f64) {
    let mut push = |op: Op| {
        tape.nodes.push(Node { op, name: None });
        NodeId(tape.nodes.len() as u32 - 1)
    };
    let factor = push(Op::Literal(factor));
    let results = tape.results.clone();
    tape.results = results.into_iter().map(|result| push(Op::Mul(factor, result))).collect();
}

#[test]
fn derivatives_of_fields_agree_with_differences_of_runs() {
    let row = row(model_of_specs("shaft_with_rotors", Keep::Needed));
    assert!(row.skipped.is_none() && row.unchecked.is_none(), "{row:?}");
    assert!(row.pass && row.error < 1e-6, "{row:?}");
}

/// Selects a tape of a model.
type Choice = fn(&mut Model) -> &mut Tape;

/// Each tape of derivatives in turn is 5 % too large.
#[test]
fn a_wrong_derivative_of_a_field_is_found() {
    let wrong: [(&str, Choice); 4] = [
        ("forces by parameters", |model| &mut model.fields[0].force_gradient),
        ("inertia by parameters", |model| &mut model.fields[0].inertia_gradient),
        ("places by parameters", |model| &mut model.fields[0].places_gradient),
        ("forces by motion", |model| &mut model.fields[0].force_jacobian),
    ];
    for (name, tape) in wrong {
        let mut model = model_of_specs("shaft_with_rotors", Keep::Needed);
        scale(tape(&mut model), 1.05);
        let row = row(model);
        assert!(!row.pass && row.error > 1e-2, "{name}: {row:?}");
    }
}

//! Directional and adjoint derivatives compared with differences, and dependencies with both.

use machinist_fmu::abi::{
    Status, fmi3EnterInitializationMode, fmi3GetAdjointDerivative, fmi3GetDirectionalDerivative,
    fmi3Reset, fmi3SetContinuousStates, fmi3SetTime,
};

use super::host::{Archive, Stepper, Unit, number, ok};

fn directional(unit: &Unit, unknowns: &[u32], known: u32) -> Vec<f64> {
    let (mut values, seed) = (vec![f64::NAN; unknowns.len()], 1.0);
    let (count, into) = (unknowns.len(), values.as_mut_ptr());
    let (of, by) = (unknowns.as_ptr(), &raw const known);
    ok!(
        unit,
        fmi3GetDirectionalDerivative(
            unit.handle,
            of,
            count,
            by,
            1,
            &raw const seed,
            1,
            into,
            count
        )
    );
    values
}

fn adjoint(unit: &Unit, unknown: u32, knowns: &[u32]) -> Vec<f64> {
    let (mut values, seed) = (vec![f64::NAN; knowns.len()], 1.0);
    let (count, into) = (knowns.len(), values.as_mut_ptr());
    let (of, by) = (&raw const unknown, knowns.as_ptr());
    ok!(
        unit,
        fmi3GetAdjointDerivative(unit.handle, of, 1, by, count, &raw const seed, 1, into, count)
    );
    values
}

/// Returns the references of an element of the structure, with the dependencies of each.
fn unknowns(archive: &Archive, element: &str) -> Vec<(u32, Option<Vec<u32>>)> {
    let of = |list: &String| list.split_whitespace().map(|at| at.parse().expect("one")).collect();
    let elements = archive.elements(element).into_iter();
    elements.map(|e| (number(&e, "valueReference"), e.get("dependencies").map(of))).collect()
}

/// Returns references and typical sizes of continuous states, in their order.
fn states(archive: &Archive) -> Vec<(u32, f64)> {
    let variables = archive.variables();
    let mut derivatives = unknowns(archive, "ContinuousStateDerivative").into_iter();
    let state_of = |at: u32| {
        let derivative = variables.values().find(|v| number(v, "valueReference") == at);
        number(derivative.expect("a variable"), "derivative")
    };
    derivatives
        .by_ref()
        .map(|(at, _)| {
            let state = state_of(at);
            let variable = variables.values().find(|v| number(v, "valueReference") == state);
            (state, variable.expect("a state")["nominal"].parse().expect("a size"))
        })
        .collect()
}

/// Quantity that a host may change along a run: a state, an input, time.
#[derive(Debug, Clone, Copy)]
enum Known {
    State(usize),
    Input,
    Time,
}

#[test]
fn derivatives_along_a_run_are_those_of_differences_and_are_where_the_structure_has_them() {
    let scenes: [(&str, &[&str], f64, f64); 7] = [
        ("saw_gin", &["--inputs", "load.mean"], 1.21, 1e-4),
        ("stick_slip", &["--inputs", "slider.stiffness"], 0.6, 1e-3),
        ("four_bar", &[], 0.2, 1e-3),
        ("winder_holder_drop", &[], 0.05, 1e-3),
        ("shaft_with_rotors", &["--elements", "3"], 1e-3, 1e-5),
        ("reed_beat_up", &["--elements", "8"], 1e-3, 1e-5),
        ("loom_drive", &["--elements", "4"], 1e-3, 1e-5),
    ];
    for (scene, options, until, step) in scenes {
        let archive = Archive::of(scene, options);
        let unit = archive.exchange();
        unit.begin(10.0);
        let mut stepper = Stepper::new(&unit);
        stepper.go(until, step);
        compare(&archive, &unit, &stepper, scene);
    }
}

fn compare(archive: &Archive, unit: &Unit, stepper: &Stepper<'_>, scene: &str) {
    let structure = ["Output", "ContinuousStateDerivative", "EventIndicator"]
        .map(|element| unknowns(archive, element))
        .concat();
    let references: Vec<u32> = structure.iter().map(|(at, _)| *at).collect();
    let states = states(archive);
    let variables = archive.variables();
    let input = variables.values().find(|variable| variable["causality"] == "input");
    let input = input.map(|variable| number(variable, "valueReference"));
    let mut knowns: Vec<(u32, f64, Known)> = states
        .iter()
        .enumerate()
        .map(|(index, (at, size))| (*at, *size, Known::State(index)))
        .collect();
    knowns.push((0, 1e-2, Known::Time));
    knowns.extend(input.map(|at| (at, unit.get(&[at])[0].abs().max(1.0), Known::Input)));
    let state = stepper.state();
    let all: Vec<u32> = knowns.iter().map(|(at, ..)| *at).collect();
    let rows: Vec<Vec<f64>> = references.iter().map(|at| adjoint(unit, *at, &all)).collect();
    for (column, (known, size, how)) in knowns.iter().enumerate() {
        let exact = directional(unit, &references, *known);
        let h = 1e-5
            * size.max(match how {
                Known::State(index) => state[*index].abs(),
                _ => 0.0,
            });
        let [ahead, behind] = [h, -h].map(|by| {
            let values = moved(unit, stepper, &state, (*known, *how), by, &references);
            moved(unit, stepper, &state, (*known, *how), 0.0, &references);
            values
        });
        for (row, (unknown, dependencies)) in structure.iter().enumerate() {
            let slope = (ahead[row] - behind[row]) / (2.0 * h);
            let rounding = 1e-15 * ahead[row].abs().max(behind[row].abs()) / h;
            let near = 2e-5 * exact[row].abs().max(slope.abs()) + 1e3 * rounding + 1e-9;
            let place = format!("{scene}: d{unknown}/d{known}");
            assert!((exact[row] - slope).abs() <= near, "{place}: {} against {slope}", exact[row]);
            assert!((rows[row][column] - exact[row]).abs() <= 1e-12 * exact[row].abs() + 1e-300);
            // If none are listed, it may depend on all.
            let is_listed = dependencies.as_ref().is_none_or(|all| all.contains(known));
            assert!(exact[row] == 0.0 || is_listed, "{place} is not in the structure");
        }
    }
}

/// Returns the values after a change of one quantity.
fn moved(
    unit: &Unit,
    stepper: &Stepper<'_>,
    state: &[f64],
    (known, how): (u32, Known),
    by: f64,
    references: &[u32],
) -> Vec<f64> {
    let (mut time, mut state) = (stepper.time, state.to_vec());
    match how {
        Known::State(index) => state[index] += by,
        Known::Time => time += by,
        Known::Input if by != 0.0 => {
            let before = unit.get(&[known])[0];
            unit.set(known, before + by);
            let values = unit.get(references);
            unit.set(known, before);
            return values;
        }
        Known::Input => {}
    }
    ok!(unit, fmi3SetTime(unit.handle, time));
    ok!(unit, fmi3SetContinuousStates(unit.handle, state.as_ptr(), state.len()));
    unit.get(references)
}

#[test]
fn derivatives_at_the_start_are_by_parameters_and_what_is_calculated_from_them() {
    let scenes: [(&str, &[&str]); 2] =
        [("two_mass", &[]), ("shaft_with_rotors", &["--elements", "3"])];
    for (scene, options) in scenes {
        compare_at_the_start(&Archive::of(scene, options));
    }
}

fn compare_at_the_start(archive: &Archive) {
    let unit = archive.exchange();
    let structure = unknowns(archive, "InitialUnknown");
    let references: Vec<u32> = structure.iter().map(|(at, _)| *at).collect();
    let initialize = |set: Option<(u32, f64)>| {
        ok!(unit, fmi3Reset(unit.handle));
        if let Some((at, value)) = set {
            unit.set(at, value);
        }
        ok!(unit, fmi3EnterInitializationMode(unit.handle, 0, 0.0, 0.0, 0, 0.0));
        unit.get(&references)
    };
    let parameters = archive.variables().into_values();
    let parameters: Vec<(u32, f64)> = parameters
        .filter(|variable| variable["causality"] == "parameter")
        .map(|v| (number(&v, "valueReference"), v["start"].parse().expect("a value")))
        .collect();
    let mut found = 0;
    for (known, start) in parameters {
        let h = 1e-6 * f64::max(1.0, start);
        let [ahead, behind] = [h, -h].map(|by| initialize(Some((known, start + by))));
        initialize(None);
        let exact = directional(&unit, &references, known);
        // Forces at nodes of a field are differences of larger ones.
        let largest = ahead.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let rounding = 1e-14 * largest / h;
        for (row, (unknown, dependencies)) in structure.iter().enumerate() {
            let slope = (ahead[row] - behind[row]) / (2.0 * h);
            let near = 1e-6 * exact[row].abs().max(slope.abs())
                + 1e-8 * ahead[row].abs().max(behind[row].abs()).max(1e-3)
                + rounding;
            let place = format!("d{unknown}/d{known}");
            assert!((exact[row] - slope).abs() <= near, "{place}: {} against {slope}", exact[row]);
            let is_listed = dependencies.as_ref().is_none_or(|all| all.contains(&known));
            assert!(exact[row] == 0.0 || is_listed, "{place}");
            found += usize::from(exact[row] != 0.0);
        }
    }
    assert!(found > 10, "{found}");
}

#[test]
fn what_is_neither_unknown_nor_known_has_no_derivatives() {
    let archive = Archive::of("saw_gin", &[]);
    let unit = archive.exchange();
    unit.begin(1.0);
    let (inertia, output) = (archive.reference("motor.inertia"), archive.reference("twist"));
    let mut value = f64::NAN;
    let seed = 1.0;
    for (unknown, known) in [(output, inertia), (inertia, 1), (output, output), (output, 4711)] {
        let (of, by, seed) = (&raw const unknown, &raw const known, &raw const seed);
        let status = unsafe {
            fmi3GetDirectionalDerivative(unit.handle, of, 1, by, 1, seed, 1, &raw mut value, 1)
        };
        assert_eq!(status, Status::Error, "d{unknown}/d{known}");
        assert_eq!(unit.log().len(), 1);
    }
}

//! Models along a run against differences of runs, and their pieces.

use machinist::Simulation;
use machinist::linear_analysis::{Piece, Place, models_along, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use nalgebra::DMatrix;

use crate::own_scene::of_specs;

/// Returns times with a step, both ends included.
fn times(from: f64, step: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|index| from + step * index as f64).collect()
}

/// Integrates Phi' = A(t) Phi by the classical Runge-Kutta method with every second model as the
/// middle of a step.
fn transition(piece: &Piece, step: f64) -> DMatrix<f64> {
    let n = piece.models[0].states.len();
    let a = |index: usize| DMatrix::from_fn(n, n, |row, column| piece.models[index].a[row][column]);
    let h = 2.0 * step;
    let mut phi = DMatrix::identity(n, n);
    for first in (0..piece.models.len() - 2).step_by(2) {
        let [start, middle, end] = [a(first), a(first + 1), a(first + 2)];
        let k1 = &start * &phi;
        let k2 = &middle * (&phi + &k1 * (0.5 * h));
        let k3 = &middle * (&phi + &k2 * (0.5 * h));
        let k4 = &end * (&phi + &k3 * h);
        phi += (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (h / 6.0);
    }
    phi
}

/// Compares the transition of A(t) with central differences of runs.
fn compare(scene: &str, (from, step, count): (f64, f64, usize), inputs: &[&str], allowed: f64) {
    let simulator = of_specs(scene, Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let run = Simulation::new(simulator).rtol(1e-11);
    let times = times(from, step, count);
    let outputs = [simulator.output(0).name];
    let pieces = models_along(&run, &times, inputs, &outputs).expect("models");
    assert_eq!(pieces.len(), 1, "{scene}: one piece");
    let phi = transition(&pieces[0], step);
    let point = operating_point(&run, Place::Time(from)).expect("a point");
    let at = |name: &str| {
        (0..simulator.shape().states())
            .find(|entry| simulator.state(*entry).name == name)
            .expect("a state")
    };
    let entries: Vec<usize> =
        pieces[0].models[0].states.iter().map(|signal| at(&signal.name)).collect();
    let end = |entry: usize, by: f64| {
        let mut state = point.state.clone();
        state[entry] += by;
        let run = run.clone().from(from).initial_state(&state).until(times[count]);
        operating_point(&run, Place::Time(times[count])).expect("an end").state
    };
    for (column, &entry) in entries.iter().enumerate() {
        let by = 1e-5 * simulator.state_scale(entry);
        let [above, below] = [end(entry, by), end(entry, -by)];
        for (row, &seen) in entries.iter().enumerate() {
            let wanted = (above[seen] - below[seen]) / (2.0 * by);
            let scale = simulator.state_scale(seen) / simulator.state_scale(entry);
            let error = (phi[(row, column)] - wanted).abs() / scale;
            let names = [seen, entry].map(|entry| simulator.state(entry).name);
            assert!(error < allowed, "{scene}: {names:?}: {error:e}");
        }
    }
}

#[test]
fn models_along_a_run_have_the_transition_of_the_motion() {
    compare("saw_gin", (1.0, 1e-4, 200), &["load.mean"], 1e-5);
    compare("two_mass", (0.2, 1e-4, 200), &[], 1e-5);
}

#[test]
fn the_order_changes_where_a_brake_closes() {
    let simulator = of_specs("drives/winch", Keep::Needed);
    let simulator: &dyn Simulator<f64> = simulator.single();
    let run = Simulation::new(simulator);
    let pieces = models_along(&run, &times(2.9, 1e-2, 60), &["load.mass"], &["height", "speed"]);
    let pieces = pieces.expect("models");
    assert!(pieces.len() > 1, "modes change");
    for piece in &pieces {
        let slip = piece.modes.iter().find(|(name, _)| name == "brake.slip").expect("a mode").1;
        for model in &piece.models {
            let holds = model.eliminated.iter().any(|name| name == "wheel.omega");
            assert_eq!(holds, slip.abs() < 0.5, "{} s: slip {slip}", model.time);
            assert_eq!(model.states.len(), piece.models[0].states.len());
            assert_eq!([model.a.len(), model.c.len()], [model.states.len(), 2]);
        }
    }
    let order = |piece: &Piece| piece.models[0].states.len();
    let is_held =
        |piece: &&Piece| piece.models[0].eliminated.iter().any(|name| name == "wheel.omega");
    let held = pieces.iter().find(is_held).expect("a piece with a closed brake");
    assert!(order(held) < order(&pieces[0]), "{} and {}", order(&pieces[0]), order(held));
    // The load hangs on the rope, and the brake holds the drum.
    compare("drives/winch", (4.3, 1e-4, 100), &[], 1e-4);
}

//! The standard parts: every example runs, balances its power and has the Jacobian of its
//! rate; one closed form or independent reference for each law, swept far beyond one setting.

mod controllers;
mod drives;
mod friction;
mod hydraulics;
mod laws;
mod losses;
mod planar;
mod shapes;

use std::path::{Path, PathBuf};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::spec::library::{LIBRARY, LibraryUnit};
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::own_scene::of_specs;

/// Those that keep to constraints.
const METHODS: [Method; 5] =
    [Method::Dop853, Method::Tsit5, Method::Radau, Method::Rodas5p, Method::Auto];

/// Folders of standard parts.
const FOLDERS: [&str; 7] =
    ["control", "electrical", "hydraulic", "planar", "rotational", "sources", "translational"];

fn parts() -> impl Iterator<Item = &'static LibraryUnit> {
    LIBRARY.iter().filter(|unit| unit.example.is_some())
}

fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs")
}

/// The example of a part.
fn example(name: &str, keep: Keep) -> ModelSimulator {
    of_specs(&format!("parts/{name}"), keep)
}

/// A run at other values of parameters and other starts, with 1e-10 unless it says so.
fn run(scene: &ModelSimulator, set: &[(&str, f64)], start: &[(&str, f64)]) -> Trajectory {
    let mut simulation = Simulation::new(scene).rtol(1e-10);
    for (name, value) in set {
        simulation = simulation.parameter(name, *value).expect("a parameter");
    }
    if !start.is_empty() {
        let mut state = vec![0.0; scene.shape().states()];
        machinist_contract::Simulator::initial_state(
            scene,
            simulation.parameter_values(),
            &mut state,
        );
        for (name, value) in start {
            let found = (0..state.len()).find(|index| scene.state(*index).name == *name);
            state[found.unwrap_or_else(|| panic!("no state {name}"))] = *value;
        }
        simulation = simulation.initial_state(&state);
    }
    simulation.run().unwrap_or_else(|error| panic!("{set:?} {start:?}: {error}"))
}

fn column<'a>(run: &'a Trajectory, name: &str) -> &'a [f64] {
    run.column(name).unwrap_or_else(|| panic!("no column {name}"))
}

/// Largest difference from a closed form over its largest value.
fn off(run: &Trajectory, name: &str, exact: impl Fn(f64) -> f64) -> f64 {
    let expected: Vec<f64> = run.times.iter().map(|time| exact(*time)).collect();
    let size = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let differences = column(run, name).iter().zip(&expected).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |most: f64, off| if off.is_nan() { off } else { most.max(off) }) / size
}

/// The time of an event that happens once.
fn time_of(run: &Trajectory, event: &str) -> f64 {
    let times: Vec<f64> =
        run.switches.iter().filter(|switch| switch.event == event).map(|s| s.time).collect();
    assert_eq!(times.len(), 1, "{event}: {times:?}");
    times[0]
}

/// Small steps of Heun's method.
fn by_small_steps<const N: usize>(
    mut state: [f64; N],
    until: f64,
    steps: usize,
    rate: impl Fn(f64, &[f64; N]) -> [f64; N],
) -> [f64; N] {
    let step = until / steps as f64;
    for number in 0..steps {
        let time = step * number as f64;
        let first = rate(time, &state);
        let mut trial = state;
        (0..N).for_each(|index| trial[index] += step * first[index]);
        let second = rate(time + step, &trial);
        (0..N).for_each(|index| state[index] += 0.5 * step * (first[index] + second[index]));
    }
    state
}

/// Force of a contact pressed by `depth`, which `rate` lets grow: k depth, and a damper that
/// never exceeds it.
fn contact(stiffness: f64, damping: f64, depth: f64, rate: f64) -> f64 {
    let elastic = stiffness * depth.max(0.0);
    elastic + (damping * rate).clamp(-elastic, elastic)
}

#[test]
fn every_unit_of_a_folder_is_in_the_library_with_an_example() {
    for folder in FOLDERS {
        let mut files = std::fs::read_dir(specs().join("units").join(folder)).expect("a folder");
        while let Some(Ok(file)) = files.next() {
            let stem = file.path().file_stem().expect("a name").to_string_lossy().into_owned();
            let name = format!("{folder}/{stem}");
            let part = parts().find(|part| part.name == name);
            let part = part.unwrap_or_else(|| panic!("{name} is not in the library"));
            let uses = format!("unit = \"{name}\"");
            assert!(part.example.is_some_and(|text| text.contains(&uses)), "{name}: example");
        }
    }
    assert!(parts().count() >= 40);
}

#[test]
fn every_example_runs_and_balances_its_power() {
    let mut wrong = Vec::new();
    for part in parts() {
        let scene = example(part.name, Keep::All);
        let simulation = Simulation::new(&scene).rtol(1e-10).with_energy_balance(true);
        let run = match simulation.run() {
            Ok(run) => run,
            Err(error) => {
                wrong.push(format!("{}: {error}", part.name));
                continue;
            }
        };
        let balance = run.energy_balance.as_ref().expect("asked for");
        let residual = balance.max_residual_relative();
        if residual.is_nan() || residual > 1e-8 {
            wrong.push(format!("{}: balance off by {residual:e}", part.name));
        }
        if !run
            .of_kind(machinist::trajectory::ColumnKind::Output)
            .any(|c| c.values.iter().any(|v| *v != 0.0))
        {
            wrong.push(format!("{}: nothing moves", part.name));
        }
        match jacobian_error(&scene, &run) {
            Some(worst) if worst <= 1e-6 => {}
            other => wrong.push(format!("{}: Jacobian off by {other:?}", part.name)),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The Jacobian against differences of the rate of fourth order, at states along the run,
/// relative to the largest entry of its row.
fn jacobian_error(scene: &ModelSimulator, run: &Trajectory) -> Option<f64> {
    use machinist_contract::Simulator;
    let count = scene.shape().states();
    let simulation = Simulation::new(scene);
    let parameters = simulation.parameter_values().to_vec();
    let pattern = scene.rate_jacobian_pattern();
    let mut worst: Option<f64> = None;
    for row in (1..run.times.len()).step_by(run.times.len() / 8) {
        let time = run.times[row];
        let state: Vec<f64> =
            (0..count).map(|index| column(run, scene.state(index).name)[row]).collect();
        let mut values = vec![0.0; pattern.entries.len()];
        scene.rate_jacobian(time, &state, &parameters, &mut values);
        let ours = machinist::complex_step::dense(pattern, &values);
        let rate = |shift: f64, column: usize| {
            let mut state = state.clone();
            state[column] += shift;
            let mut rate = vec![0.0; count];
            scene.rate(time, &state, &parameters, &mut rate);
            nalgebra::DVector::from_vec(rate)
        };
        let mut exact = nalgebra::DMatrix::zeros(count, count);
        let mut is_smooth = true;
        for index in 0..count {
            if scene.is_mode(index) {
                continue;
            }
            // Of pressures such a small step would be rounding.
            let scale = scene.state_scale(index);
            let h = if scale > 1e3 { 1e-5 * scale } else { 1e-3 * scale.min(1e-2) };
            let near = (rate(h, index) - rate(-h, index)) / (2.0 * h);
            let far = (rate(2.0 * h, index) - rate(-2.0 * h, index)) / (4.0 * h);
            is_smooth &= (&near - &far).amax() <= 1e-4 * near.amax();
            exact.set_column(index, &((near * 4.0 - far) / 3.0));
        }
        // A contact begins or ends within the differences.
        if !is_smooth {
            continue;
        }
        let scale = |index: usize| scene.state_scale(index);
        let weighed = exact.map_with_location(|i, j, entry| entry * scale(j) / scale(i));
        for i in 0..count {
            // What a constraint holds has a rate of rounding alone.
            if weighed.row(i).amax() <= 1e-10 * weighed.amax() {
                continue;
            }
            for j in 0..count {
                let largest = exact.row(i).amax().max(1e-12);
                let off = (ours[(i, j)] - exact[(i, j)]).abs() / largest;
                worst = Some(worst.unwrap_or(0.0).max(off));
            }
        }
    }
    worst
}

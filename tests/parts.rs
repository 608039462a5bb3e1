//! The standard parts: every example runs, balances its power and has the Jacobian of its
//! rate; one closed form or independent reference for each law, swept far beyond one setting.

mod assemblies;
mod clutches;
mod controllers;
mod driven_friction;
mod drives;
mod engines;
mod friction;
mod heat;
mod hoisting;
mod hydraulics;
mod laws;
mod losses;
mod planar;
mod shaken_friction;
mod shapes;
mod shared_friction;
mod spatial;
mod terminals;
mod wheels;
mod winches;

use std::path::{Path, PathBuf};

use machinist::trajectory::ColumnKind;
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::spec::library::{LIBRARY, LibraryUnit};
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::of_specs;

/// Methods that support constraints.
const METHODS: [Method; 5] =
    [Method::Dop853, Method::Tsit5, Method::Radau, Method::Rodas5p, Method::Auto];

/// Folders of standard parts.
const FOLDERS: [&str; 9] = [
    "control",
    "electrical",
    "hydraulic",
    "planar",
    "rotational",
    "sources",
    "spatial",
    "thermal",
    "translational",
];

fn parts() -> impl Iterator<Item = &'static LibraryUnit> {
    LIBRARY.iter().filter(|unit| unit.example.is_some())
}

fn specs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs")
}

/// Returns the example of a part.
fn example(name: &str, keep: Keep) -> ModelSimulator {
    of_specs(&format!("parts/{name}"), keep)
}

/// Runs with other values of parameters and other starts, at a tolerance of 1e-10 unless changed.
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

/// Returns the largest difference from a closed form over its largest value.
fn off(run: &Trajectory, name: &str, exact: impl Fn(f64) -> f64) -> f64 {
    let expected: Vec<f64> = run.times.iter().map(|time| exact(*time)).collect();
    let size = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    let differences = column(run, name).iter().zip(&expected).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, |most: f64, off| if off.is_nan() { off } else { most.max(off) }) / size
}

/// Returns the time of an event that happens once.
fn time_of(run: &Trajectory, event: &str) -> f64 {
    let times: Vec<f64> =
        run.switches.iter().filter(|switch| switch.event == event).map(|s| s.time).collect();
    assert_eq!(times.len(), 1, "{event}: {times:?}");
    times[0]
}

/// Integrates by small steps of Heun's method.
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

/// Returns the force of a contact with a depth and its rate: k depth, and a damper whose force
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

/// The power balance, Jacobians and more of every example are checked by `verify`, in the tests of
/// the program.
#[test]
fn every_example_moves() {
    let is_still = |part: &LibraryUnit| {
        let scene = example(part.name, Keep::Needed);
        let run = Simulation::new(&scene).run().unwrap_or_else(|e| panic!("{}: {e}", part.name));
        let moves = run.of_kind(ColumnKind::Output).any(|c| c.values.iter().any(|v| *v != 0.0));
        !moves
    };
    let still: Vec<&str> = parts().filter(|part| is_still(part)).map(|part| part.name).collect();
    assert!(still.is_empty(), "{still:?}");
}

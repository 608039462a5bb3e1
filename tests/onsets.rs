//! Instabilities that set in during a run: implicit methods, for which fast growth looks like
//! decay, stop where it begins.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// A block on a belt, with the friction of bristles (C. Canudas de Wit, H. Olsson,
/// K. J. Astrom, P. Lischinsky: A new model for control of systems with friction, IEEE Trans.
/// Automatic Control 40, 1995): it sticks until the spring pulls it off, at a fold behind
/// which the bristles' own motion grows at 1e3 a second.
const LUGRE: &str = include_str!("../benches/tolerances/lugre.toml");

fn simulation<'a>(
    block: &'a ModelSimulator,
    method: Method,
    set: &[(&str, f64)],
) -> Simulation<'a> {
    let mut run = Simulation::new(block).method(method);
    for (name, value) in set {
        run = run.parameter(&format!("block.{name}"), *value).expect("a parameter");
    }
    run
}

fn run(block: &ModelSimulator, method: Method, rtol: f64, set: &[(&str, f64)]) -> Trajectory {
    let run = simulation(block, method, set).rtol(rtol).run();
    run.unwrap_or_else(|error| panic!("{method} at {rtol:e}, {set:?}: {error}"))
}

/// Returns the largest absolute value of x \[m\].
fn largest(run: &Trajectory) -> f64 {
    run.column("block.x").expect("a state").iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// Returns the largest difference of x \[m\].
fn difference(a: &Trajectory, b: &Trajectory) -> f64 {
    let [a, b] = [a, b].map(|run| run.column("block.x").expect("a state"));
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// An error before the breakaway grows a thousandfold, which no step shows, but a second run does.
#[test]
fn what_sticks_on_a_belt_lets_go_in_time() {
    let block = of_text(LUGRE, Keep::All);
    let settings: [&[(&str, f64)]; 5] = [
        &[],
        &[("belt", 0.05)],
        &[("spring", 5.0), ("viscous", 0.1)],
        &[("bristles", 1e4), ("bristle_damping", 100.0)],
        &[("stribeck", 0.01), ("breakaway", 2.0)],
    ];
    for set in settings {
        let exact = run(&block, Method::Radau, 1e-12, set);
        let doubt = difference(&exact, &run(&block, Method::Dop853, 1e-11, set));
        assert!(doubt < 1e-8, "{set:?}: two converged runs differ by {doubt:e}");
        for method in [Method::Radau, Method::Rodas5p, Method::Auto] {
            for accuracy in [1e-4, 1e-6, 1e-8] {
                let found = simulation(&block, method, set).run_to_accuracy(accuracy);
                let found = found.expect("it runs");
                // The error may stop falling with the tolerance; the run then says so.
                let is_told = found.shortfall.is_some();
                assert!(!is_told || method != Method::Radau, "{method} to {accuracy:e}, {set:?}");
                if is_told {
                    continue;
                }
                let error = difference(&found.trajectory, &exact);
                let allowed = 3.0 * accuracy * largest(&exact) + doubt;
                assert!(error < allowed, "{method} to {accuracy:e}, {set:?}: {error:.1e} m");
            }
        }
    }
}

/// Bristles without a scale get one from their effect on the block.
#[test]
fn a_state_that_acts_strongly_gets_a_scale_by_what_it_does() {
    let block = of_text(LUGRE, Keep::All);
    let error = |rtol: f64| {
        let fine = run(&block, Method::Dop853, 1e-12, &[("belt", 0.2)]);
        difference(&run(&block, Method::Dop853, rtol, &[("belt", 0.2)]), &fine)
    };
    assert!(error(1e-5) < 1e-2 && error(1e-7) < 1e-4, "{:e}, {:e}", error(1e-5), error(1e-7));
}

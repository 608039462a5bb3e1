//! References of the cases.

use machinist_contract::Energy;

use super::{Case, states};
use machinist::error::SimulateError;
use machinist::method::Method;
use machinist::trajectory::Trajectory;

/// Kind of reference of a case.
pub(super) enum Truth {
    /// A closed form of all states at a time.
    Closed(&'static str, Box<dyn Fn(f64) -> Vec<f64>>),
    /// Agreement of two unrelated methods at tight tolerances; each state is judged relative to its
    /// largest value at the times of the case.
    Converged,
    /// Conservation of energy only.
    Energy,
}

/// Computed reference of a case.
pub(super) struct Known {
    /// Description.
    pub(super) name: String,
    /// Difference between two ways to the reference, in the measure of errors; 0 if it is exact.
    pub(super) agreement: f64,
    /// Size of every state.
    pub(super) sizes: Vec<f64>,
    /// States at the times of the case; `None` if it is judged by energy.
    states: Option<Vec<Vec<f64>>>,
}

impl Truth {
    /// # Errors
    /// [`SimulateError`] of the reference runs.
    pub(super) fn find(&self, case: &Case) -> Result<Known, SimulateError> {
        match self {
            Self::Closed(name, at) => {
                let states = case.times.iter().map(|time| at(*time)).collect();
                Ok(Known::new((*name).to_owned(), states))
            }
            Self::Converged => converged(case),
            Self::Energy => {
                let simulator = case.simulator;
                let sizes = (0..simulator.shape().states()).map(|i| simulator.state_scale(i));
                let name = "energy that stays, over the largest energy of motion".to_owned();
                Ok(Known { name, agreement: 0.0, sizes: sizes.collect(), states: None })
            }
        }
    }
}

impl Known {
    fn new(name: String, states: Vec<Vec<f64>>) -> Self {
        let width = states.first().map_or(0, Vec::len);
        let size = |state: usize| {
            let largest = states.iter().fold(0.0f64, |size, row| size.max(row[state].abs()));
            if largest > 0.0 { largest } else { 1.0 }
        };
        let sizes = (0..width).map(size).collect();
        Self { name, agreement: 0.0, sizes, states: Some(states) }
    }

    /// Returns the largest error of a run; NaN if it has none.
    pub(super) fn error(&self, case: &Case, run: &Trajectory) -> f64 {
        let found = states(run);
        match &self.states {
            Some(states) => distance(&found, states, &self.sizes),
            None => drift(case, run, &found),
        }
    }
}

/// Returns max over times and states of |a - b|/size; NaN if anything is NaN.
fn distance(a: &[Vec<f64>], b: &[Vec<f64>], sizes: &[f64]) -> f64 {
    let mut largest = 0.0;
    for (a, b) in a.iter().zip(b) {
        for ((a, b), size) in a.iter().zip(b).zip(sizes) {
            largest = worse(largest, (a - b).abs() / size);
        }
    }
    largest
}

/// Returns max over times of |E - E(first)| over the largest kinetic energy.
fn drift(case: &Case, run: &Trajectory, found: &[Vec<f64>]) -> f64 {
    let simulator = case.simulator;
    let names = (0..simulator.shape().parameters).map(|index| {
        let name = simulator.parameter(index).name;
        let set = case.settings.iter().find(|(known, _)| *known == name);
        set.map_or_else(|| simulator.parameter_default(index), |(_, value)| *value)
    });
    let parameters: Vec<f64> = names.collect();
    let energy = |(time, state): (&f64, &Vec<f64>)| simulator.energy(*time, state, &parameters);
    let energies: Vec<Energy<f64>> = run.times.iter().zip(found).map(energy).collect();
    let first = energies.first().map_or(f64::NAN, Energy::total);
    let moving = energies.iter().fold(0.0, |size, energy| worse(size, energy.kinetic));
    energies.iter().fold(0.0, |size, energy| worse(size, (energy.total() - first).abs())) / moving
}

/// Returns the larger value; NaN if either is NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Unrelated methods for references, the best first, with tight tolerances and maximum numbers of
/// steps; explicit ones are used only where steps are few.
const CANDIDATES: [(Method, f64, usize); 5] = [
    (Method::Radau, 1e-11, 20_000),
    (Method::Dop853, 1e-12, 5_000),
    (Method::Rodas5p, 1e-10, 20_000),
    (Method::Bdf, 1e-8, 100_000),
    (Method::Radau, 1e-9, 100_000),
];

/// Returns the first run that succeeds, with its difference from a run by another method.
fn converged(case: &Case) -> Result<Known, SimulateError> {
    let simulator = case.simulator;
    let scales: Vec<f64> =
        (0..simulator.shape().states()).map(|index| simulator.state_scale(index)).collect();
    let sizes = match run(case, (Method::Rodas5p, 1e-6, 20_000), &scales) {
        Ok(run) => Known::new(String::new(), states(&run)).sizes,
        Err(_) => scales,
    };
    let mut runs = CANDIDATES.iter().filter_map(|candidate| run(case, *candidate, &sizes).ok());
    let missing = || SimulateError::NoReference { scene: simulator.name().to_owned() };
    let first = runs.next().ok_or_else(missing)?;
    let second = runs.find(|second| second.method != first.method).ok_or_else(missing)?;
    let known = Known::new(String::new(), states(&first));
    let agreement = distance(&states(&second), &states(&first), &known.sizes);
    let name = format!(
        "{} at {:e}, from which {} at {:e} differs by {agreement:.1e}",
        first.method, first.rtol, second.method, second.rtol
    );
    Ok(Known { name, agreement, ..known })
}

fn run(
    case: &Case,
    (method, rtol, max_steps): (Method, f64, usize),
    sizes: &[f64],
) -> Result<Trajectory, SimulateError> {
    let atol: Vec<f64> = sizes.iter().map(|size| rtol * size).collect();
    case.simulation()?.method(method).rtol(rtol).atol(&atol).max_steps(max_steps).run()
}

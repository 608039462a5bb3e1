//! Error against work and time: what each method pays for accuracy.

use std::time::Instant;

use machinist::closed_form::two_mass::{Motion, SAW_GIN, Torques};
use machinist::method::Work;
use machinist::trajectory::Trajectory;
use machinist::{Method, SimulateError, Simulation};
use machinist_scenes::{Simulator, scenes};

use super::number::number;

/// Error against time of one scene.
pub struct WorkPrecision {
    /// The scene.
    pub scene: &'static str,
    /// What errors are measured against.
    pub reference: String,
    /// One for each method.
    pub curves: Vec<Curve>,
}

/// One method at falling tolerances.
pub struct Curve {
    /// The method.
    pub method: Method,
    /// From loose to tight.
    pub points: Vec<Point>,
}

/// One tolerance.
pub struct Point {
    /// Relative tolerance.
    pub rtol: f64,
    /// max over states of max over time |y - reference|/max over time |reference|.
    pub error: f64,
    /// Median time of a run \[ms\].
    pub milliseconds: f64,
    /// What the run cost.
    pub work: Work,
}

/// Output times of a measured run.
const POINTS: usize = 101;
/// Runs of which the median counts.
pub const RUNS: usize = 25;
/// A curve ends once a run takes longer than this \[ms\].
const LONGEST: f64 = 300.0;
const TOLERANCES: [f64; 9] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];
/// Tolerances of the reference run and of the run it is compared with.
const FINEST: f64 = 1e-12;
const FINER: f64 = 1e-11;

/// A state's name and its values at the output times.
type Reference = Vec<(String, Vec<f64>)>;

/// Measures all methods on both scenes.
pub fn measure() -> Result<Vec<WorkPrecision>, SimulateError> {
    let mut measured = Vec::new();
    if let Some(simulator) = scenes::find::<f64>("two_mass") {
        let times = run(simulator, Method::Tsit45, FINER)?.times;
        let reference = "the closed form of the damped oscillator".to_owned();
        measured.push(curves("two_mass", simulator, reference, &closed_form(&times)));
    }
    if let Some(simulator) = scenes::find::<f64>("saw_gin") {
        let finest = states(&run(simulator, Method::Tsit45, FINEST)?);
        let change = error(&run(simulator, Method::Tsit45, FINER)?, &finest);
        let reference = format!(
            "a run of tsit45 at rtol {FINEST:.0e}, from which the one at rtol {FINER:.0e} \
             differs by {}",
            number(change, 2)
        );
        measured.push(curves("saw_gin", simulator, reference, &finest));
    }
    Ok(measured)
}

fn curves(
    scene: &'static str,
    simulator: &'static dyn Simulator<f64>,
    reference_name: String,
    reference: &Reference,
) -> WorkPrecision {
    let curve = |method: &Method| {
        let mut points = Vec::new();
        for rtol in TOLERANCES {
            // A method that cannot go on at a loose tolerance may at a tight one.
            let Ok(point) = point(simulator, *method, rtol, reference) else { continue };
            let is_slow = point.milliseconds > LONGEST;
            points.push(point);
            if is_slow {
                break;
            }
        }
        Curve { method: *method, points }
    };
    let curves = Method::ALL.iter().map(curve).collect();
    WorkPrecision { scene, reference: reference_name, curves }
}

fn point(
    simulator: &'static dyn Simulator<f64>,
    method: Method,
    rtol: f64,
    reference: &Reference,
) -> Result<Point, SimulateError> {
    let mut times = Vec::new();
    // Not timed: it finds memory and caches cold.
    let mut trajectory = Some(run(simulator, method, rtol)?);
    for _ in 0..RUNS {
        let start = Instant::now();
        trajectory = Some(run(simulator, method, rtol)?);
        times.push(start.elapsed().as_secs_f64() * 1e3);
        if times.iter().sum::<f64>() > LONGEST {
            break;
        }
    }
    times.sort_by(f64::total_cmp);
    let error = trajectory.as_ref().map_or(f64::NAN, |trajectory| error(trajectory, reference));
    let work = trajectory.map(|trajectory| trajectory.work).unwrap_or_default();
    Ok(Point { rtol, error, milliseconds: times[times.len() / 2], work })
}

fn run(
    simulator: &'static dyn Simulator<f64>,
    method: Method,
    rtol: f64,
) -> Result<Trajectory, SimulateError> {
    Simulation::new(simulator).points(POINTS).method(method).rtol(rtol).run()
}

/// Angles and speeds of two rotors under the scene's own torques, from rest.
fn closed_form(times: &[f64]) -> Reference {
    type Quantity = (&'static str, fn(&Motion) -> f64);
    const TORQUES: Torques = Torques {
        driving: 974.4,
        load: 843.72,
        load_amplitude: 0.0,
        load_frequency: 241.8051,
        load_phase: 0.0,
    };
    let quantities: [Quantity; 3] = [
        ("coupling.twist", |motion| motion.twist().angle),
        ("driver.omega", |motion| motion.driver_speed),
        ("cylinder.omega", |motion| motion.driven_speed),
    ];
    let motions: Vec<Motion> =
        times.iter().map(|time| SAW_GIN.motion(*time, Motion::default(), TORQUES)).collect();
    quantities
        .iter()
        .map(|(name, quantity)| ((*name).to_owned(), motions.iter().map(quantity).collect()))
        .collect()
}

fn states(trajectory: &Trajectory) -> Reference {
    use machinist::trajectory::ColumnKind::State;
    let columns = trajectory.of_kind(State);
    columns.map(|column| (column.name.clone(), column.values.clone())).collect()
}

fn error(trajectory: &Trajectory, reference: &Reference) -> f64 {
    let of_state = |(name, exact): &(String, Vec<f64>)| {
        let Some(ours) = trajectory.column(name) else { return f64::NAN };
        let distance = ours.iter().zip(exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        let size = exact.iter().map(|value| value.abs()).fold(0.0, f64::max);
        if size > 0.0 { distance / size } else { distance }
    };
    reference.iter().map(of_state).fold(0.0, |worst, next| if next > worst { next } else { worst })
}

//! Twin experiments: the share of 95 % confidence intervals of fits that contain the truth, for
//! data from runs of the same machine with noise: `cargo bench -p machinist --bench twins`.
//!
//! Each draw is fitted from three starts, none of them near the truth, with scales estimated from
//! the residuals. Noise is 1 % of the standard deviation of each output. `-- WORDS` selects
//! machines by name; a number sets the number of draws, 100 by default.

use std::error::Error;
use std::time::Instant;

use machinist::field::{Discretisation, FieldSimulator};
use machinist::fit::{Bounds, Experiment, Fit, Measured, Plan, Unknown};
use machinist::{Method, Simulation};
use machinist_contract::Simulator;
use machinist_scenes::scenes;

/// A machine with parameters to fit.
struct Twin {
    scene: &'static str,
    /// Number of elements of its field, if it has one.
    elements: Option<usize>,
    method: Method,
    rtol: f64,
    until: f64,
    samples: u32,
    outputs: &'static [&'static str],
    /// Unknowns, with the first start and both bounds relative to the truth.
    unknowns: &'static [(&'static str, [f64; 3])],
}

const TWINS: &[Twin] = &[
    Twin {
        scene: "saw_gin",
        elements: None,
        method: Method::Dop853,
        rtol: 1e-8,
        until: 2.0,
        samples: 400,
        outputs: &["twist", "motor_speed", "stator_current"],
        unknowns: &[
            ("coupling.stiffness", [3.0, 0.2, 5.0]),
            ("coupling.damping", [0.3, 0.1, 10.0]),
            ("motor.inertia", [2.0, 0.25, 4.0]),
            ("cylinder.inertia", [0.5, 0.25, 4.0]),
            ("motor.alpha_r", [1.6, 0.4, 2.5]),
            ("load.mean", [0.6, 0.3, 1.3]),
        ],
    },
    Twin {
        scene: "winder_full",
        elements: None,
        method: Method::Dop853,
        rtol: 1e-8,
        until: 0.2,
        samples: 400,
        outputs: &["deflection", "pressure", "slip"],
        unknowns: &[
            ("layer.stiffness", [1.5, 0.5, 2.0]),
            ("layer.viscosity", [0.5, 0.2, 5.0]),
            ("layer.cubic_stiffness", [0.5, 0.2, 5.0]),
            ("force_amplitude", [0.7, 0.5, 2.0]),
            ("ovality", [0.7, 0.5, 2.0]),
            ("pair.friction", [0.8, 0.7, 1.5]),
        ],
    },
    Twin {
        scene: "saw_gin_shaft",
        elements: Some(2),
        method: Method::Radau,
        rtol: 1e-6,
        until: 0.4,
        samples: 200,
        outputs: &["twist", "motor_speed", "end_speed", "coupling_torque"],
        unknowns: &[
            ("coupling.stiffness", [3.0, 0.2, 5.0]),
            ("coupling.damping", [0.3, 0.1, 10.0]),
            ("saws.inertia", [0.5, 0.25, 4.0]),
            ("saws.shear_modulus", [2.0, 0.25, 4.0]),
            ("motor.inertia", [2.0, 0.25, 4.0]),
            ("motor.alpha_r", [1.6, 0.4, 2.5]),
        ],
    },
];

/// An output with its values.
type Column = (String, Vec<f64>);

/// Standard deviation of the noise, relative to that of each output.
const NOISE: f64 = 0.01;
const STARTS: usize = 3;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let draws = words.iter().find_map(|word| word.parse().ok()).unwrap_or(100);
    let names: Vec<&String> = words.iter().filter(|word| word.parse::<usize>().is_err()).collect();
    for twin in TWINS {
        if names.is_empty() || names.iter().any(|name| twin.scene == name.as_str()) {
            let mut done = Err("it is not built in".into());
            lend(twin, &mut |scene| done = study(twin, scene, draws));
            done?;
        }
    }
    Ok(())
}

/// Lends a simulator of a machine to the calling thread.
fn lend(twin: &Twin, work: &mut dyn FnMut(&dyn Simulator<f64>)) {
    let fields = scenes::find_field_f64(twin.scene).zip(scenes::find_field_duals(twin.scene));
    if let Some((scene, duals)) = fields {
        let wanted = Discretisation { elements: twin.elements, order: None };
        if let Ok(cut) = FieldSimulator::new(scene, wanted) {
            work(cut.with_derivatives(duals).single());
        }
    } else if let Some(scene) = scenes::find_f64(twin.scene) {
        work(scene);
    }
}

/// Results of the draws.
#[derive(Default)]
struct Came {
    /// Per unknown: number of intervals that contain the truth, and number of intervals.
    held: Vec<(usize, usize)>,
    /// Per unknown: sum of the relative standard errors.
    errors: Vec<f64>,
    seconds: Vec<f64>,
    evaluations: usize,
    /// Number of fits that ended away from the truth, or failed.
    astray: usize,
}

fn study(twin: &Twin, scene: &dyn Simulator<f64>, draws: usize) -> Result<(), Box<dyn Error>> {
    let simulation = Simulation::new(scene).method(twin.method).rtol(twin.rtol);
    let lender = |work: &mut dyn FnMut(&dyn Simulator<f64>)| lend(twin, work);
    let truths: Vec<f64> = twin
        .unknowns
        .iter()
        .map(|(name, _)| {
            let place = (0..scene.shape().parameters).find(|k| scene.parameter(*k).name == *name);
            place.map(|place| scene.parameter_default(place)).ok_or(*name)
        })
        .collect::<Result<_, _>>()?;
    let unknown = |((name, shares), truth): (&(&str, [f64; 3]), &f64)| {
        let [start, low, high] = shares.map(|share| share * truth);
        Unknown { name: (*name).to_owned(), start, bounds: Bounds { low, high } }
    };
    let unknowns: Vec<Unknown> = twin.unknowns.iter().zip(&truths).map(unknown).collect();
    let step = twin.until / f64::from(twin.samples);
    let times: Vec<f64> = (1..=twin.samples).map(|k| step * f64::from(k)).collect();
    let exact = exact(twin, &simulation, &times)?;
    let mut came = Came {
        held: vec![(0, 0); truths.len()],
        errors: vec![0.0; truths.len()],
        ..Came::default()
    };
    let mut random = fastrand::Rng::with_seed(16);
    for _ in 0..draws {
        let experiments = [noisy(&times, &exact, &mut random)];
        let fit = Fit::new(&simulation, &unknowns, &experiments).on_threads(&lender);
        draw(&fit, &truths, &mut came);
    }
    tell(twin, draws, came);
    Ok(())
}

/// Returns the columns of the outputs, without noise.
fn exact(
    twin: &Twin,
    simulation: &Simulation<'_>,
    times: &[f64],
) -> Result<Vec<Column>, Box<dyn Error>> {
    let run = simulation.clone().until(twin.until).times(times).run()?;
    let column = |name: &&str| {
        let values = run.column(name).ok_or_else(|| format!("no output {name}"))?;
        Ok(((*name).to_owned(), values.to_vec()))
    };
    twin.outputs.iter().map(column).collect()
}

fn noisy(times: &[f64], exact: &[Column], random: &mut fastrand::Rng) -> Experiment {
    let mut column = |(name, values): &Column| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let square = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        let sigma = NOISE * (square / values.len() as f64).sqrt();
        let values = values.iter().map(|value| value + sigma * normal(random)).collect();
        (name.clone(), values)
    };
    let columns = exact.iter().map(&mut column).collect();
    Experiment::new("twin", Measured { times: times.to_vec(), columns })
}

/// Does one fit.
fn draw(fit: &Fit<'_>, truths: &[f64], came: &mut Came) {
    /// Distance from the truth, in standard errors, beyond which a fit is another minimum.
    const FAR: f64 = 6.0;
    let plan = Plan { is_robust: false, starts: STARTS, steps: 200, interrupt: None };
    let begin = Instant::now();
    let fitted = fit.solve(&plan, &mut |_, _| {});
    came.seconds.push(begin.elapsed().as_secs_f64());
    let Ok(fitted) = fitted else {
        came.astray += 1;
        return;
    };
    came.evaluations += fitted.runs;
    let mut is_astray = false;
    let found = fit.findings(&fitted).parameters;
    for (k, (found, truth)) in found.iter().zip(truths).enumerate() {
        let Some([low, high]) = found.confidence_95 else {
            is_astray = true;
            continue;
        };
        let error = found.standard_error.unwrap_or(f64::NAN);
        is_astray |= (found.value - truth).abs() > FAR * error;
        came.held[k].0 += usize::from(low <= *truth && *truth <= high);
        came.held[k].1 += 1;
        came.errors[k] += error / truth;
    }
    came.astray += usize::from(is_astray);
}

fn tell(twin: &Twin, draws: usize, mut came: Came) {
    came.seconds.sort_by(f64::total_cmp);
    println!(
        "{}: {draws} draws, {} samples of {}, {STARTS} starts; a fit takes {:.2} s (largest \
         {:.2} s) and {} evaluations; {} ended elsewhere",
        twin.scene,
        twin.samples,
        twin.outputs.join(", "),
        came.seconds[came.seconds.len() / 2],
        came.seconds[came.seconds.len() - 1],
        came.evaluations / draws,
        came.astray,
    );
    for (k, (name, _)) in twin.unknowns.iter().enumerate() {
        let (held, all) = came.held[k];
        let error = 100.0 * came.errors[k] / all.max(1) as f64;
        println!("  {name:24} {held:4} of {all} intervals hold the truth, error {error:.3} %");
    }
}

/// Returns a normally distributed number of mean 0 and variance 1.
fn normal(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}

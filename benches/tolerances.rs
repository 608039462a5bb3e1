//! Errors relative to the tolerance, for problems on which methods have been wrong without a
//! message: friction by bristles, a spring with backlash, a pendulum on a rod over 1000 s, with
//! many tolerances, parameters and methods:
//! `cargo bench -p machinist-tests --features measure --bench tolerances`.
//!
//! An error is the largest difference of a state, divided by the largest value of the state, or by
//! its scale if that is larger. Words select problems and methods by name; `sets=N` and
//! `tolerances=N` replace the defaults of 20 and 200.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

/// Converts drawn values to names and values of the reference machine.
type Translation = fn(&[f64]) -> Vec<(&'static str, f64)>;

/// A machine with the columns to compare and the ranges of its parameters.
struct Problem {
    name: &'static str,
    /// Columns of the run and of the reference, with scales.
    columns: &'static [(&'static str, &'static str, f64)],
    /// Name of another machine as its reference, and the conversion of drawn values to that
    /// machine.
    reference: Option<(&'static str, Translation)>,
    /// Initial values and parameters, each drawn between two values, uniformly in its logarithm.
    drawn: &'static [(&'static str, [f64; 2])],
    loosest: f64,
}

const METHODS: [Method; 6] =
    [Method::Auto, Method::Radau, Method::Rodas5p, Method::Taylor, Method::Dop853, Method::Tsit5];

const PROBLEMS: [Problem; 3] = [
    Problem {
        name: "lugre",
        columns: &[("block.x", "block.x", 1.0), ("block.v", "block.v", 1.0)],
        reference: None,
        drawn: &[
            ("block.mass", [0.5, 2.0]),
            ("block.spring", [1.0, 5.0]),
            ("block.belt", [0.05, 0.3]),
            ("block.bristles", [1e4, 1e5]),
            ("block.bristle_damping", [100.0, 400.0]),
            ("block.viscous", [0.1, 0.8]),
            ("block.sliding", [0.7, 1.0]),
            ("block.breakaway", [1.2, 2.0]),
            ("block.stribeck", [1e-3, 1e-2]),
        ],
        loosest: 1e-4,
    },
    Problem {
        name: "play",
        columns: &[("block.x", "block.x", 1.0), ("block.v", "block.v", 1.0)],
        reference: None,
        drawn: &[
            ("block.v", [0.3, 3.0]),
            ("block.mass", [0.5, 2.0]),
            ("block.gap", [0.03, 0.3]),
            ("block.stiffness", [10.0, 1e3]),
            ("block.damping", [0.1, 1.0]),
            ("block.force", [0.1, 1.0]),
            ("block.frequency", [0.5, 5.0]),
        ],
        loosest: 1e-3,
    },
    Problem {
        name: "pendulum",
        columns: &[("bob.x", "x", 1.0), ("bob.y", "y", 1.0)],
        reference: Some(("pendulum_by_angle", by_angle)),
        drawn: &[
            ("bob.x", [0.05, 0.45]),
            ("bob.mass", [0.1, 10.0]),
            ("bob.length", [0.5, 2.0]),
            ("bob.gravity", [1.0, 20.0]),
        ],
        loosest: 1e-4,
    },
];
const TIGHTEST: f64 = 1e-10;
const SEED: u64 = 1995;

/// Returns the values of the pendulum by its angle, from those of the pendulum on a rod.
fn by_angle(drawn: &[f64]) -> Vec<(&'static str, f64)> {
    let [x, mass, length, gravity] = *drawn else { unreachable!("four are drawn") };
    vec![
        ("bob.angle", (x / length).asin()),
        ("bob.mass", mass),
        ("bob.length", length),
        ("bob.gravity", gravity),
    ]
}

fn main() -> Result<(), Box<dyn Error>> {
    let (mut sets, mut tolerances, mut words) = (20, 200, Vec::new());
    for word in std::env::args().skip(1).filter(|word| !word.starts_with("--")) {
        match word.split_once('=') {
            Some(("sets", number)) => sets = number.parse()?,
            Some(("tolerances", number)) => tolerances = number.parse()?,
            Some((name, _)) => {
                return Err(format!("`{name}` is neither sets nor tolerances").into());
            }
            None => words.push(word),
        }
    }
    let asked = |name: &str, all: &mut dyn Iterator<Item = &str>| {
        let mut all = all.filter(|other| words.iter().any(|word| word == other)).peekable();
        all.peek().is_none() || all.any(|other| other == name)
    };
    let all = || METHODS.iter().map(|method| method.name());
    let methods: Vec<_> =
        METHODS.into_iter().filter(|method| asked(method.name(), &mut all())).collect();
    for problem in &PROBLEMS {
        if !asked(problem.name, &mut PROBLEMS.iter().map(|problem| problem.name)) {
            continue;
        }
        study(problem, &methods, sets, tolerances)?;
    }
    Ok(())
}

/// Returns the model of a spec in the folder of this benchmark.
fn model(name: &str) -> Result<ModelSimulator, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/tolerances");
    let model = pipeline::generate(&folder.join(name).with_extension("toml"), Keep::All);
    Ok(ModelSimulator::new(model.map_err(|errors| errors.render())?))
}

type Failed = Box<dyn Error + Send + Sync>;

fn run(
    machine: &ModelSimulator,
    (method, rtol): (Method, f64),
    given: &[(&str, f64)],
) -> Result<Trajectory, Failed> {
    let mut run = Simulation::new(machine).method(method).rtol(rtol);
    for (name, value) in given {
        run = match run.clone().initial_value(name, *value) {
            Ok(run) => run,
            Err(_) => run.parameter(name, *value)?,
        };
    }
    Ok(run.run()?)
}

/// Returns the largest difference of columns, relative to their largest value, or to their scale if
/// that is larger.
fn difference(problem: &Problem, found: &[Vec<f64>], exact: &[Vec<f64>]) -> f64 {
    let columns = problem.columns.iter().zip(found).zip(exact);
    columns.fold(0.0, |most: f64, (((.., scale), found), exact)| {
        let size = exact.iter().fold(*scale, |most, x| most.max(x.abs()));
        let pairs = found.iter().zip(exact);
        most.max(pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / size)
    })
}

/// Result of one run: set, tolerance, and its error relative to the tolerance or the reason for its
/// failure.
type Outcome = (usize, f64, Result<f64, String>);

/// A problem's machine with the drawn values.
struct Study<'a> {
    problem: &'a Problem,
    machine: ModelSimulator,
    reference: Option<(ModelSimulator, Translation)>,
    drawn: Vec<Vec<f64>>,
}

impl<'a> Study<'a> {
    fn new(problem: &'a Problem, sets: usize) -> Result<Self, Box<dyn Error>> {
        let mut random = fastrand::Rng::with_seed(SEED);
        let mut draw = |_| {
            let draw = |(_, [low, high]): &(_, [f64; 2])| low * (high / low).powf(random.f64());
            problem.drawn.iter().map(draw).collect()
        };
        let reference = problem.reference.map(|(name, of)| model(name).map(|model| (model, of)));
        Ok(Self {
            problem,
            machine: model(problem.name)?,
            reference: reference.transpose()?,
            drawn: (0..sets).map(&mut draw).collect(),
        })
    }

    fn given(&self, set: usize) -> Vec<(&'static str, f64)> {
        let names = self.problem.drawn.iter().map(|(name, _)| *name);
        names.zip(self.drawn[set].iter().copied()).collect()
    }

    /// Returns the columns of a converged run and their difference from those of another such run,
    /// relative to their largest values.
    fn exact(&self, set: usize) -> Result<(Vec<Vec<f64>>, f64), Failed> {
        let columns = |run: &Trajectory| -> Vec<Vec<f64>> {
            let names = self.problem.columns.iter();
            let names =
                names.map(|(own, other, _)| if self.reference.is_some() { other } else { own });
            names.map(|name| run.column(name).expect("a column").to_vec()).collect()
        };
        let [fine, other] = match &self.reference {
            Some((machine, of)) => {
                let given = of(&self.drawn[set]);
                [1e-14, 1e-12].map(|rtol| run(machine, (Method::Taylor, rtol), &given))
            }
            None => [Method::Radau, Method::Dop853]
                .map(|method| run(&self.machine, (method, 1e-12), &self.given(set))),
        };
        let (fine, other) = (columns(&fine?), columns(&other?));
        let doubt = difference(self.problem, &other, &fine);
        Ok((fine, doubt))
    }

    /// Runs a method at all tolerances.
    fn runs(
        &self,
        (set, method): (usize, Method),
        exact: &[Vec<f64>],
        tolerances: usize,
    ) -> Vec<Outcome> {
        let (loosest, given) = (self.problem.loosest, self.given(set));
        let at = |step| {
            let share = step as f64 / (tolerances.max(2) - 1) as f64;
            let rtol = loosest * (TIGHTEST / loosest).powf(share);
            let error = run(&self.machine, (method, rtol), &given).map(|run| {
                let own = self.problem.columns.iter();
                let own: Vec<_> =
                    own.map(|(name, ..)| run.column(name).expect("a state").to_vec()).collect();
                difference(self.problem, &own, exact) / rtol
            });
            (set, rtol, error.map_err(|error| error.to_string()))
        };
        (0..tolerances).map(at).collect()
    }
}

fn study(
    problem: &Problem,
    methods: &[Method],
    sets: usize,
    tolerances: usize,
) -> Result<(), Box<dyn Error>> {
    let study = Study::new(problem, sets)?;
    let exact: Vec<_> = in_parallel(sets, |set| study.exact(set));
    let exact =
        exact.into_iter().collect::<Result<Vec<_>, _>>().map_err(|error| error.to_string())?;
    let doubt = exact.iter().fold(0.0f64, |most, (_, doubt)| most.max(*doubt));
    println!(
        "{}: {sets} sets of parameters, {tolerances} tolerances; references differ by {doubt:.1e}",
        problem.name
    );
    println!("| method | median | worst | at | beyond 100 | refused |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for &method in methods {
        let of_sets = in_parallel(sets, |set| study.runs((set, method), &exact[set].0, tolerances));
        print(method, &of_sets.concat());
    }
    println!();
    Ok(())
}

/// Prints a row of the table.
fn print(method: Method, outcomes: &[Outcome]) {
    let errors = outcomes
        .iter()
        .filter_map(|(set, rtol, error)| error.as_ref().ok().map(|error| (*error, *set, *rtol)));
    let mut errors: Vec<_> = errors.collect();
    errors.sort_by(|a, b| a.0.total_cmp(&b.0));
    let refused: Vec<_> = outcomes.iter().filter_map(|(.., error)| error.as_ref().err()).collect();
    let why = refused.first().map_or("", |why| why.as_str());
    let Some((worst, set, rtol)) = errors.last() else {
        println!("| {method} | | | | | {}: {why} |", refused.len());
        return;
    };
    let far = errors.iter().filter(|(error, ..)| *error > 100.0).count();
    let (median, all) = (errors[errors.len() / 2].0, errors.len());
    println!(
        "| {method} | {median:.2} | {worst:.1} | set {set}, {rtol:.2e} | {far} of {all} | {} {why} |",
        refused.len()
    );
}

/// Computes a function for each index, on all cores.
fn in_parallel<T: Send>(count: usize, of: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let (next, found) = (AtomicUsize::new(0), Mutex::new(BTreeMap::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count {
                        break;
                    }
                    let value = of(index);
                    found.lock().expect("no panic").insert(index, value);
                }
            });
        }
    });
    found.into_inner().expect("no panic").into_values().collect()
}

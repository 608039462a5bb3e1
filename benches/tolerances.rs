//! Errors over tolerances where methods have been wrong without a word: friction by bristles,
//! a spring with play, a pendulum on a rod over 1000 s; many tolerances, parameters and methods:
//! `cargo bench -p machinist-tests --features measure --bench tolerances`.
//!
//! An error is the largest difference of a state, over what it is at most, or its scale if that
//! is more. Words keep problems and methods of these names; `sets=N` and `tolerances=N` ask for
//! other than 20 and 200.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

/// A machine, what of it is compared, and how its parameters are drawn.
struct Problem {
    name: &'static str,
    /// Columns of the run and of the reference, with scales.
    columns: &'static [(&'static str, &'static str, f64)],
    /// Its reference, if another machine is.
    reference: Option<(&'static str, fn(&[f64]) -> Vec<(&'static str, f64)>)>,
    /// Initial values and parameters, each drawn between two values, evenly in its logarithm.
    drawn: &'static [(&'static str, [f64; 2])],
    loosest: f64,
    methods: &'static [Method],
}

const EXPLICIT_AND_IMPLICIT: &[Method] =
    &[Method::Auto, Method::Radau, Method::Rodas5p, Method::Taylor, Method::Dop853, Method::Tsit5];

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
        methods: EXPLICIT_AND_IMPLICIT,
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
        methods: EXPLICIT_AND_IMPLICIT,
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
        methods: EXPLICIT_AND_IMPLICIT,
    },
];
const TIGHTEST: f64 = 1e-10;
const SEED: u64 = 1995;

/// What the pendulum by its angle is given, for what the one on a rod is.
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
    for problem in &PROBLEMS {
        if !asked(problem.name, &mut PROBLEMS.iter().map(|problem| problem.name)) {
            continue;
        }
        let methods = problem.methods.iter().copied();
        let all = || problem.methods.iter().map(|method| method.name());
        let methods: Vec<_> = methods.filter(|method| asked(method.name(), &mut all())).collect();
        study(problem, &methods, sets, tolerances)?;
    }
    Ok(())
}

/// The model of a file beside this one.
fn model(name: &str) -> Result<ModelSimulator, Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/tolerances");
    let model = pipeline::generate(&folder.join(name).with_extension("toml"), Keep::All);
    Ok(ModelSimulator::new(model.map_err(|errors| errors.render())?))
}

fn run(
    machine: &ModelSimulator,
    (method, rtol): (Method, f64),
    given: &[(&str, f64)],
) -> Result<Trajectory, Box<dyn Error + Send + Sync>> {
    let mut run = Simulation::new(machine).method(method).rtol(rtol);
    for (name, value) in given {
        run = match run.clone().initial_value(name, *value) {
            Ok(run) => run,
            Err(_) => run.parameter(name, *value)?,
        };
    }
    Ok(run.run()?)
}

fn difference(problem: &Problem, run: &Trajectory, exact: &[Vec<f64>]) -> f64 {
    let columns = problem.columns.iter().zip(exact);
    columns.fold(0.0, |most: f64, ((name, _, scale), exact)| {
        let size = exact.iter().fold(*scale, |most, x| most.max(x.abs()));
        let found = run.column(name).expect("a state");
        let pairs = found.iter().zip(exact);
        most.max(pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / size)
    })
}

/// One run: set, method, tolerance, and its error over the tolerance or why there is none.
type Outcome = (usize, Method, f64, Result<f64, String>);

fn study(
    problem: &Problem,
    methods: &[Method],
    sets: usize,
    tolerances: usize,
) -> Result<(), Box<dyn Error>> {
    let mut random = fastrand::Rng::with_seed(SEED);
    let drawn: Vec<Vec<f64>> = (0..sets)
        .map(|_| {
            let draw = |(_, [low, high]): &(_, [f64; 2])| low * (high / low).powf(random.f64());
            problem.drawn.iter().map(draw).collect()
        })
        .collect();
    let machine = model(problem.name)?;
    let other = problem.reference.map(|(name, given)| model(name).map(|model| (model, given)));
    let other = other.transpose()?;
    let names = || problem.drawn.iter().map(|(name, _)| *name);
    let jobs: Vec<_> = (0..sets).flat_map(|set| methods.iter().map(move |m| (set, *m))).collect();
    let outcomes = Mutex::new(Vec::<Outcome>::new());
    let references = Mutex::new(BTreeMap::new());
    let next = AtomicUsize::new(0);
    let reference = |set: usize| -> Vec<Vec<f64>> {
        let given: Vec<_> = names().zip(drawn[set].iter().copied()).collect();
        let columns = |run: &Trajectory, of_other: bool| -> Vec<Vec<f64>> {
            let names = problem.columns.iter().map(|(a, b, _)| if of_other { b } else { a });
            names.map(|name| run.column(name).expect("a column").to_vec()).collect()
        };
        let [fine, check] = match &other {
            Some((other, of)) => [1e-14, 1e-12].map(|rtol| {
                let run = run(other, (Method::Taylor, rtol), &of(&drawn[set])).expect("it runs");
                (columns(&run, true), run)
            }),
            None => [(Method::Radau, 1e-12), (Method::Dop853, 1e-12)].map(|how| {
                let run = run(&machine, how, &given).expect("it runs");
                (columns(&run, false), run)
            }),
        };
        let doubt = if other.is_some() {
            let pairs = fine.0.iter().flatten().zip(check.0.iter().flatten());
            pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
        } else {
            difference(problem, &check.1, &fine.0)
        };
        println!("{}, set {set}: references differ by {doubt:.1e}; {given:.4?}", problem.name);
        fine.0
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(&(set, method)) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let known = references.lock().expect("no panic").get(&set).cloned();
                    let exact = known.unwrap_or_else(|| {
                        let exact = reference(set);
                        references.lock().expect("no panic").insert(set, exact.clone());
                        exact
                    });
                    let given: Vec<_> = names().zip(drawn[set].iter().copied()).collect();
                    for step in 0..tolerances {
                        let share = step as f64 / (tolerances.max(2) - 1) as f64;
                        let rtol = problem.loosest * (TIGHTEST / problem.loosest).powf(share);
                        let found = run(&machine, (method, rtol), &given);
                        let error = found.map(|run| difference(problem, &run, &exact) / rtol);
                        let outcome = (set, method, rtol, error.map_err(|error| error.to_string()));
                        outcomes.lock().expect("no panic").push(outcome);
                    }
                }
            });
        }
    });
    let outcomes = outcomes.into_inner()?;
    println!(
        "\n{}: error over tolerance, {sets} sets of parameters, {tolerances} tolerances",
        problem.name
    );
    println!("| method | median | worst | at | beyond 100 | refused |");
    for method in methods {
        let own = outcomes.iter().filter(|(_, of, _, _)| of == method);
        let mut errors: Vec<_> = own
            .clone()
            .filter_map(|(set, _, rtol, error)| {
                error.as_ref().ok().map(|error| (*error, *set, *rtol))
            })
            .collect();
        errors.sort_by(|a, b| a.0.total_cmp(&b.0));
        let refused: Vec<_> = own.filter_map(|(.., error)| error.as_ref().err()).collect();
        let far = errors.iter().filter(|(error, ..)| *error > 100.0).count();
        if let Some((worst, set, rtol)) = errors.last() {
            let median = errors[errors.len() / 2].0;
            println!(
                "| {method} | {median:.2} | {worst:.1} | set {set}, {rtol:.2e} | {far} of {} | {} {} |",
                errors.len(),
                refused.len(),
                refused.first().map_or("", |why| why.as_str())
            );
        }
        if std::env::var_os("MACHINIST_SHOW").is_some() {
            for (error, set, rtol) in errors.iter().rev().take(40) {
                println!("    {error:.1} set {set} {rtol:.3e}");
            }
        }
    }
    println!();
    Ok(())
}

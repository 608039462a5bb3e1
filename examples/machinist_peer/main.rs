//! A program that measures the emitted benchmark scenes, as JSON lines on standard
//! output, so that they can stand beside other tools in one table:
//!
//! ```text
//! machinist_peer rhs    --model M2
//! machinist_peer sim    --model M2 --rtols 1e-3,1e-6 --budget 1.0
//! machinist_peer sweep  --model M2 --count 1000 --rtol 1e-6 --methods taylor
//! machinist_peer derive --model M6:10
//! ```
//!
//! Build it for the machine it runs on, as one would build what is measured:
//!
//! ```text
//! RUSTFLAGS="-C target-cpu=native" cargo build --release -p machinist-tests \
//!     --features measure --example machinist_peer
//! ```
//!
//! Times are medians of several runs. A simulation includes setting up and freeing
//! the method; states are handed over as the benchmark models define them.

mod chain;
mod model;
mod rhs;

use std::error::Error;
use std::process::ExitCode;
use std::time::Instant;

use machinist::method::{Auto, Problem, StepTolerance, Stopped, System, Work};
use machinist::{Method, Sweep};
use machinist_bench_scenes as bench;
use machinist_contract::Describe;
use serde_json::{Value, json};

use model::Model;

/// Largest number of steps of a run.
const MAX_STEPS: usize = 10_000_000;
/// Runs of which the median counts, and how long they may take in all \[s\].
const MOST_RUNS: usize = 31;
const ENOUGH: f64 = 0.15;
/// At least so many runs, unless they take longer than this in all \[s\].
const FEWEST_RUNS: usize = 3;
const TOO_LONG: f64 = 1.0;

fn main() -> ExitCode {
    match answer() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("machinist_peer: {error}");
            ExitCode::from(2)
        }
    }
}

fn answer() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::read()?;
    if arguments.call == "derive" {
        return derive(&arguments.model);
    }
    let Some(model) = Model::find(&arguments.model) else {
        print(&arguments.model, &json!({"skip": "no such scene in specs/scenes/bench"}));
        return Ok(());
    };
    match arguments.call.as_str() {
        "rhs" => rhs::measure(&model),
        "sim" => simulate(&model, &arguments)?,
        "sweep" if model.key == "M2" => sweep(&model.key, &arguments)?,
        "sweep" => print(&model.key, &json!({"skip": "only M2 has a parameter to vary"})),
        call => print(&model.key, &json!({"skip": format!("no call `{call}`")})),
    }
    Ok(())
}

/// Arguments of the command line.
struct Arguments {
    call: String,
    model: String,
    rtols: Vec<f64>,
    rtol: f64,
    budget: f64,
    count: usize,
    methods: Vec<Method>,
}

impl Arguments {
    fn read() -> Result<Self, Box<dyn Error>> {
        let given: Vec<String> = std::env::args().skip(1).collect();
        let option = |name: &str, default: &str| {
            let place = given.iter().position(|argument| argument == name);
            let value = place.and_then(|place| given.get(place + 1));
            value.map_or_else(|| default.to_owned(), Clone::clone)
        };
        let rtols = option("--rtols", "1e-3,1e-4,1e-6,1e-8,1e-10,1e-12");
        let methods = match option("--methods", "all").as_str() {
            "all" => Method::ALL.to_vec(),
            names => names.split(',').map(str::parse).collect::<Result<_, _>>()?,
        };
        Ok(Self {
            call: given.first().cloned().unwrap_or_default(),
            model: option("--model", "M1"),
            rtols: rtols.split(',').map(str::parse).collect::<Result<_, _>>()?,
            rtol: option("--rtol", "1e-6").parse()?,
            budget: option("--budget", "5").parse()?,
            count: option("--count", "1000").parse()?,
            methods,
        })
    }
}

/// The state of a model at the end of its run, in the model's order.
fn run(
    model: &Model,
    method: Method,
    rtol: f64,
    parameters: &[f64],
) -> Result<(Vec<f64>, Work), Stopped> {
    let simulator = model.simulator;
    let shape = simulator.shape();
    let mut initial = vec![0.0; shape.states()];
    simulator.initial_state(parameters, &mut initial);
    let mut jumps = vec![0.0; shape.discontinuities];
    simulator.discontinuities(parameters, &mut jumps);
    let span = simulator.run_defaults();
    let system = System::new(simulator, parameters, false);
    let atol = model.scales().iter().map(|scale| rtol * scale).collect();
    let auto = Auto::default();
    let problem = Problem {
        system: &system,
        from: span.from,
        until: span.until,
        times: &[span.until],
        initial,
        jumps,
        tolerance: StepTolerance::new((method, auto), (simulator, parameters), (rtol, atol)),
        auto,
        max_steps: MAX_STEPS,
    };
    let state = problem.integrate(method)?.rows;
    Ok((model.states(span.until, &state, parameters), system.work()))
}

/// One line for each method and tolerance, from loose to tight, until the budget
/// of the method is spent.
fn simulate(model: &Model, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    check_tolerances(&arguments.rtols)?;
    let parameters = model.parameters();
    for method in arguments.methods.iter().filter(|method| method.suits(model.simulator)) {
        let mut spent = 0.0;
        for rtol in &arguments.rtols {
            let (mut times, mut total) = (Vec::new(), 0.0);
            let outcome = loop {
                let start = Instant::now();
                let outcome = run(model, *method, *rtol, &parameters);
                times.push(start.elapsed().as_secs_f64());
                total += times[times.len() - 1];
                let enough = total > ENOUGH && times.len() >= FEWEST_RUNS;
                if outcome.is_err() || enough || times.len() >= MOST_RUNS || total > TOO_LONG {
                    break outcome;
                }
            };
            let runs = times.len();
            let seconds = median(times);
            let line = match outcome {
                Ok((state, work)) => json!({
                    "solver": method.name(), "rtol": rtol, "seconds": seconds, "reps": runs,
                    "steps": work.steps, "rates": work.rate_evaluations, "final_state": state,
                }),
                Err(stopped) => json!({
                    "solver": method.name(), "rtol": rtol,
                    "error": format!("at t = {}: {}", stopped.time, stopped.cause),
                }),
            };
            print(&model.key, &line);
            spent += seconds;
            if seconds > arguments.budget / 3.0 || spent > arguments.budget {
                break;
            }
        }
    }
    Ok(())
}

/// Many runs with couplings from soft to stiff, on one thread and on two.
fn sweep(key: &str, arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    check_tolerances(&[arguments.rtol])?;
    let (count, rtol) = (arguments.count, arguments.rtol);
    if count < 2 {
        return Err(format!("a sweep has at least 2 variants, not {count}").into());
    }
    let stiffness = |index: usize| 10_f64.powf(4.0 + 2.0 * index as f64 / (count - 1) as f64);
    let variants: Vec<f64> = (0..count).map(stiffness).collect();
    let stiffness = &bench::m2::M2.parameter(0).name.to_owned();
    for &method in arguments.methods.iter().filter(|method| method.suits(&bench::m2::M2)) {
        for threads in [1, 2] {
            let sweep = Sweep::new(&bench::m2::M2)
                .each(move |run| run.points(2).rtol(rtol).method(method))
                .vary(stiffness, &variants)?
                .threads(threads);
            let start = Instant::now();
            let runs: Result<Vec<_>, _> = sweep.run().into_iter().collect();
            let seconds = start.elapsed().as_secs_f64();
            let line = match runs {
                Ok(runs) => {
                    let states: Vec<_> = runs.iter().map(|run| &run.outputs[1]).collect();
                    json!({
                        "solver": method.name(), "rtol": rtol, "sims": count, "threads": threads,
                        "seconds": seconds, "final_states": states,
                    })
                }
                Err(error) => {
                    json!({"solver": method.name(), "rtol": rtol, "error": error.to_string()})
                }
            };
            print(key, &line);
        }
    }
    Ok(())
}

/// Seconds from the spec's text to equations and tapes, and from these to Rust.
fn derive(key: &str) -> Result<(), Box<dyn Error>> {
    use machinist_codegen::emit::EmitOptions;
    use machinist_codegen::emit::rust::emit;
    use machinist_codegen::mechanics::reduce::Keep;
    use machinist_codegen::pipeline;
    use machinist_model::operations;

    let folder = std::env::temp_dir().join(format!("machinist_peer_{}", std::process::id()));
    let Some(spec) = spec(key, &folder)? else {
        print(key, &json!({"skip": "no such scene in specs/scenes/bench"}));
        return Ok(());
    };
    let start = Instant::now();
    let program = pipeline::generate(&spec, Keep::Needed)?;
    let derived = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let text = emit(&program, &EmitOptions::for_scenes())?;
    let emitted = start.elapsed().as_secs_f64();
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    let line = json!({
        "variant": "all functions", "derive_s": derived, "codegen_s": emitted, "compile_s": 0.0,
        "ops_rhs": operations(&program.rate),
        "ops_jac": operations(&program.rate_jacobian.tape),
        "how": format!("{} lines of Rust, not compiled here", text.lines().count()),
    });
    print(key, &line);
    Ok(())
}

/// The spec of a model: a scene's file, or that of a chain, written into `folder`.
fn spec(key: &str, folder: &std::path::Path) -> std::io::Result<Option<std::path::PathBuf>> {
    if let Some(model) = Model::find(key) {
        let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/scenes/bench");
        return Ok(Some(std::path::Path::new(scenes).join(format!("{}.toml", model.scene))));
    }
    let links = key.strip_prefix("M6:").and_then(|links| links.parse().ok());
    let Some(links @ 2..=100) = links else { return Ok(None) };
    std::fs::create_dir_all(folder)?;
    let file = folder.join(format!("m6_{links}.toml"));
    std::fs::write(&file, chain::spec(links))?;
    Ok(Some(file))
}

fn check_tolerances(rtols: &[f64]) -> Result<(), Box<dyn Error>> {
    match rtols.iter().find(|rtol| !(**rtol > 0.0 && **rtol <= 1.0)) {
        None => Ok(()),
        Some(rtol) => Err(format!("{rtol} is no relative tolerance").into()),
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Prints a line at once: whoever cuts this program off keeps what it has printed.
fn print(model: &str, line: &Value) {
    let mut line = line.clone();
    line["model"] = Value::from(model);
    println!("{line}");
}

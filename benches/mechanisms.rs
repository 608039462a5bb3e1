//! Growth of cost with the number of bodies of a mechanism, with fitted exponents. It is a chain of
//! rods in a plane, described by centre of mass and angle, each pinned to the one before by two
//! constraints. Measured are its derivation, machine code of its rate, a rate, a run of a dozen
//! steps with its start, a step of dop853 with projection onto the constraints, and memory.
//!
//! `cargo bench -p machinist-tests --features measure --bench mechanisms`

mod growth;

use std::error::Error;
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Instant;

use growth::{Row, bytes, fastest, fastest_step, print};
use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::Simulator;
use machinist_model::compiled::CompiledTape;
use machinist_model::{ModelSimulator, Table};

const NUMBERS: [usize; 4] = [10, 30, 100, 300];
const WHAT: [&str; 7] = [
    "derive [ms]",
    "machine code [ms]",
    "rate [us]",
    "run of 12 steps [ms]",
    "step [us]",
    "held [kB]",
    "in a run [kB]",
];

fn main() -> Result<(), Box<dyn Error>> {
    // Work done once a process must not count for the first row.
    costs(3)?;
    let rows = NUMBERS.map(|size| costs(size).map(|costs| Row { size, costs }));
    let rows: Vec<_> = rows.into_iter().collect::<Result<_, _>>()?;
    print("chain of pinned rods", "bodies", &WHAT, &rows);
    Ok(())
}

fn costs(bodies: usize) -> Result<[f64; 7], Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("chain.toml");
    std::fs::write(&path, spec(bodies)?)?;
    let (before, begin) = (bytes::held(), Instant::now());
    let model = pipeline::generate(&path, Keep::Needed).map_err(|errors| errors.render())?;
    let derived = begin.elapsed().as_secs_f64();
    let held = bytes::held() - before;
    let tables: Arc<[Table]> = model.tables.clone().into();
    let begin = Instant::now();
    CompiledTape::new(&model.rate, &tables).ok_or("this target has no machine code")?;
    let code = begin.elapsed().as_secs_f64();
    let simulator = ModelSimulator::compiled_at_once(model);
    let simulator: &dyn Simulator<f64> = &simulator;
    let shape = simulator.shape();
    let p: Vec<f64> = (0..shape.parameters).map(|i| simulator.parameter_default(i)).collect();
    let mut constants = vec![0.0; simulator.constants()];
    simulator.prepare(&p, &mut constants);
    let (mut state, mut rate) = (vec![0.0; shape.states()], vec![0.0; shape.states()]);
    simulator.initial_state(&p, &mut state);
    let mut call = || {
        simulator.prepared_rate(0.0, &state, &p, &constants, &mut rate);
        1.0
    };
    let of_rate = fastest(&mut call);
    let run = Simulation::new(simulator).method(Method::Dop853).rtol(1e-6);
    let mut least = [f64::INFINITY; 2];
    for _ in 0..3 {
        let begin = Instant::now();
        let of_step = fastest_step(&run);
        least[0] = least[0].min(begin.elapsed().as_secs_f64());
        least[1] = least[1].min(of_step);
    }
    bytes::forget_most();
    let before = bytes::held();
    fastest_step(&run);
    let beside = bytes::most() - before;
    let [of_run, of_step] = least;
    let [ms, us, kilobytes] = [1e3, 1e6, 1e-3];
    Ok([
        derived * ms,
        code * ms,
        of_rate * us,
        of_run * ms,
        of_step * us,
        held as f64 * kilobytes,
        beside as f64 * kilobytes,
    ])
}

/// Returns a spec with rods of 0.4 m that hang at an angle.
fn spec(bodies: usize) -> Result<String, std::fmt::Error> {
    let mut text = format!(
        r#"[scene]
name = "chain"
[units.body]
unit = "planar/body"
count = {bodies}
[parameters]
half = {{ value = 0.2, unit = "m", doc = "half the length of a rod" }}
[outputs]
end = "body[{bodies}].x"
[run]
until = 1.0
points = 2
"#
    );
    for body in 1..=bodies {
        for (axis, part) in [("x", "cos"), ("y", "sin")] {
            writeln!(text, "[constraints.pin_{axis}_{body}]\ndoc = \"pin\"")?;
            let end = |body: usize, sign| {
                format!("body_{body}.{axis} {sign} half*{part}(body_{body}.phi)")
            };
            match body {
                1 => writeln!(text, "expression = \"{}\"", end(1, '-'))?,
                _ => writeln!(
                    text,
                    "expression = \"{} - ({})\"",
                    end(body, '-'),
                    end(body - 1, '+')
                )?,
            }
        }
    }
    writeln!(text, "[initial]")?;
    for body in 1..=bodies {
        writeln!(text, "\"body_{body}.phi\" = {}", -0.3 - 0.01 * (body % 7) as f64)?;
    }
    Ok(text)
}

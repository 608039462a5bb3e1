//! Time to derive and to emit chains and robots, operations of their functions, and lines.

use std::error::Error;
use std::fmt::Write as _;
use std::time::Instant;

use machinist_algebra::cas::Algebra;
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::rust::emit;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::{Model, operations};

use crate::robots::{robots, scene_of};
use crate::table::{self, Row};

const SIZES: [usize; 7] = [1, 2, 4, 8, 16, 32, 64];
const ALGEBRAS: [Algebra; 2] = [Algebra::Plain, Algebra::Symbolica];
const WHAT: [&str; 6] = [
    "derive [s]",
    "derive, Symbolica [s]",
    "operations of the rate",
    "of the Jacobian",
    "emit [s]",
    "lines",
];

/// Prints the tables.
pub fn print() -> Result<(), Box<dyn Error>> {
    // Work done once a process must not count for the first row.
    costs(&chain(2))?;
    let rows = SIZES.map(|size| costs(&chain(size)).map(|costs| Row { size, costs }));
    let rows: Vec<_> = rows.into_iter().collect::<Result<_, _>>()?;
    table::print("chain in space", "joints", &WHAT, &rows);
    println!("\n| robot | {} |\n| {}--- |", WHAT.join(" | "), "--- | ".repeat(WHAT.len()));
    for (name, robot) in robots()["robots"].as_object().ok_or("no robots")? {
        let [derive, by_symbolica, rate, jacobian, emit, lines] = costs(&scene_of(robot))?;
        println!(
            "| {name} | {derive:.3} | {by_symbolica:.3} | {rate} | {jacobian} | {emit:.3} | {lines} |"
        );
    }
    Ok(())
}

/// Derives a scene.
pub fn derived(text: &str, algebra: Algebra) -> Result<Model, Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text)?;
    let system = pipeline::check(&path).map_err(|errors| errors.render())?;
    Ok(pipeline::compile_by(algebra, system, Keep::Needed).map_err(|errors| errors.render())?)
}

fn costs(text: &str) -> Result<[f64; 6], Box<dyn Error>> {
    let mut times = [0.0; 2];
    let mut last = None;
    for (time, algebra) in times.iter_mut().zip(ALGEBRAS) {
        let begin = Instant::now();
        last = Some(derived(text, algebra)?);
        *time = begin.elapsed().as_secs_f64();
    }
    let model = last.ok_or("no algebra")?;
    let begin = Instant::now();
    let emitted = emit(&model, &EmitOptions::for_build_script())?;
    let time = begin.elapsed().as_secs_f64();
    let [rate, jacobian] = [&model.rate, &model.rate_jacobian.tape].map(operations);
    let in_motion = model.motion.as_ref().map_or(0, |motion| operations(&motion.tape));
    let lines = emitted.lines().count();
    Ok([times[0], times[1], rate as f64, (jacobian + in_motion) as f64, time, lines as f64])
}

/// Returns a chain of equal links, each on a joint whose axis is oblique to the link.
fn chain(joints: usize) -> String {
    let mut text = String::from(
        "[scene]\nname = \"chain\"\n[units]\nc = { unit = \"chain\" }\n[run]\nuntil = 1\n\
         [define.chain]\ngravity = [0, 0, -9.81]\n",
    );
    for n in 1..=joints {
        let parent = if n == 1 { "world".to_owned() } else { format!("f{}", n - 1) };
        let axis = [[1, 2, -2], [2, -1, 2], [-2, 2, 1]][n % 3];
        write!(
            text,
            "[define.chain.coordinates.q{n}]\nunit = \"rad\"\n\
             [define.chain.frames.f{n}]\nparent = \"{parent}\"\ndisplacement = [0.3, 0.1, -0.2]\n\
             revolute = {{ axis = {axis:?}, angle = \"q{n}\" }}\n\
             [define.chain.bodies.b{n}]\nframe = \"f{n}\"\nmass = 1.2\ncentre = [0.1, 0.05, -0.1]\n\
             inertia = {{ xx = 0.02, yy = 0.03, zz = 0.04, xy = 0.001, xz = 0.002, yz = 0.003 }}\n"
        )
        .expect("text");
    }
    text
}

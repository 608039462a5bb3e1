//! Cost of derivation for machines of any size and for scene files: seconds of each stage, peak
//! memory and number of operations.
//!
//! ```text
//! cargo run --release -p machinist-codegen --example derivation_times -- bodies 3 5 7 10
//! cargo run --release -p machinist-codegen --example derivation_times -- rotors 100 300 1000
//! cargo run --release -p machinist-codegen --example derivation_times -- specs/scenes/*.toml
//! cargo run --release -p machinist-codegen --features symbolica --example derivation_times -- \
//!     --symbolica bodies 10
//! ```
//!
//! With `--symbolica` by Symbolica, otherwise by Machinist's own algebra.
//!
//! Peak memory is that of the process so far. To measure it for a single machine, name only that
//! one.

use std::path::{Path, PathBuf};
use std::time::Instant;

use machinist_algebra::cas::{Algebra, session};
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::rust::emit;
use machinist_codegen::mechanics::lagrange;
use machinist_codegen::mechanics::linearize::linearize;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::{lower, pipeline};

#[path = "../tests/support/machines.rs"]
mod machines;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let algebra = if arguments.first().is_some_and(|first| first == "--symbolica") {
        arguments.remove(0);
        Algebra::most_simplifying(1)
    } else {
        Algebra::default()
    };
    let kind = arguments.first().map_or("", String::as_str);
    let make: Option<fn(usize) -> String> = match kind {
        "bodies" => Some(machines::bodies),
        "rotors" => Some(machines::rotors),
        "uncoupled" => Some(machines::uncoupled),
        "pendulum" => Some(machines::pendulum),
        _ => None,
    };
    println!(
        "{:<24}{:>8}{:>8}{:>8}{:>8}{:>8}{:>9}{:>9}{:>7}",
        "machine", "check", "derive", "all", "lower", "emit", "rate", "jacobian", "MiB"
    );
    let Some(make) = make else {
        for scene in &arguments {
            let name = Path::new(scene).file_stem().unwrap_or_default();
            measure(&name.to_string_lossy(), Path::new(scene), algebra)?;
        }
        return Ok(());
    };
    for count in &arguments[1..] {
        let scene = made(&make(count.parse()?))?;
        measure(&format!("{kind} {count}"), &scene, algebra)?;
    }
    Ok(())
}

/// Writes a spec to a file.
fn made(text: &str) -> std::io::Result<PathBuf> {
    let folder = std::env::temp_dir().join(format!("machinist-times-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    let path = folder.join("made.toml");
    std::fs::write(&path, text)?;
    Ok(path)
}

/// Measures one row: seconds to check, to derive the equations, to derive the reduced model with
/// its derivatives (`all`), to lower it (part of `all`), and to emit it.
fn measure(name: &str, scene: &Path, algebra: Algebra) -> Result<(), Box<dyn std::error::Error>> {
    let start = Instant::now();
    let system = match pipeline::check(scene) {
        Ok(system) => system,
        Err(errors) => {
            println!(
                "{name:<24}refused after {:.2} s: {}",
                start.elapsed().as_secs_f64(),
                errors.errors()[0].message
            );
            return Ok(());
        }
    };
    let check = start.elapsed().as_secs_f64();
    let again = system.clone();
    let (derive, linear) = session(name, algebra, move |cas| {
        let start = Instant::now();
        let equations = lagrange::derive(cas, &again);
        let derive = start.elapsed().as_secs_f64();
        (derive, linearize(cas, &equations))
    })?;
    let start = Instant::now();
    drop(lower::lower(&linear));
    let lower = start.elapsed().as_secs_f64();
    drop(linear);
    let start = Instant::now();
    let model = pipeline::compile_by(algebra, system, Keep::Needed)?;
    let all = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let text = emit(&model, &EmitOptions::for_build_script());
    let emit = start.elapsed().as_secs_f64();
    let operations = |tape: &machinist_model::Tape| {
        tape.nodes.iter().filter(|node| node.op.is_arithmetic()).count()
    };
    println!(
        "{name:<24}{check:>8.2}{derive:>8.2}{all:>8.2}{lower:>8.2}{emit:>8.2}{:>9}{:>9}{:>7}{}",
        operations(&model.rate),
        operations(&model.rate_jacobian.tape),
        peak().map_or("?".to_owned(), |mib| mib.to_string()),
        text.err().map_or(String::new(), |error| format!(" {error}"))
    );
    Ok(())
}

/// Returns the peak memory of this process in MiB, if the system reports it.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix("kB")?.trim().parse::<u64>().ok().map(|kib| kib / 1024)
}

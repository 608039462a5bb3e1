//! Cost of the error estimate: wall time of `machinist run` over that of `machinist run --no-error`,
//! for all scenes of `specs/scenes`.
//!
//! ```sh
//! cargo build --release
//! cargo bench -p machinist-tests --features measure --bench estimates
//! taskset -c 0 cargo bench -p machinist-tests --features measure --bench estimates
//! ```
//!
//! Arguments are relative tolerances, 1e-6 unless given, or parts of names of scenes. Each time is the
//! least of several runs, in turn with and without the estimate. Scenes whose run takes less than
//! [`SHORT`] are counted by themselves: there the start of the program is what is measured.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[path = "../tests/common/specs.rs"]
mod specs;

use specs::specs_in;

/// Time of a run below which the start of the program takes most of it.
const SHORT: Duration = Duration::from_millis(30);
/// Number of runs of which the fastest counts, and time after which there are no more.
const RUNS: usize = 7;
const ENOUGH: Duration = Duration::from_secs(3);

/// Times of a scene with and without the estimate.
struct Scene {
    name: String,
    with: Duration,
    without: Duration,
}

impl Scene {
    fn ratio(&self) -> f64 {
        self.with.as_secs_f64() / self.without.as_secs_f64()
    }
}

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let program = root.join("target/release/machinist");
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let is_tolerance = |word: &&String| word.parse::<f64>().is_ok();
    let rtol = words.iter().find(is_tolerance).map_or("1e-6", String::as_str);
    let names: Vec<&String> = words.iter().filter(|word| !is_tolerance(word)).collect();
    let folder = root.join("specs/scenes");
    let files = specs_in(&folder).into_iter().filter_map(|file| {
        let name = file.strip_prefix(&folder).ok()?.with_extension("").display().to_string();
        let is_wanted = names.is_empty() || names.iter().any(|word| name.contains(*word));
        is_wanted.then_some((name, file))
    });
    let scenes: Vec<Scene> =
        files.filter_map(|(name, file)| measured(&program, name, &file, rtol)).collect();
    println!("wall time with over without the estimate, rtol {rtol}\n");
    println!("| scenes | number | sum | median | 95 % | worst |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let (short, long): (Vec<&Scene>, Vec<&Scene>) =
        scenes.iter().partition(|scene| scene.without < SHORT);
    show("shorter than 30 ms", short);
    show("longer", long);
    show("all", scenes.iter().collect());
}

fn show(what: &str, mut scenes: Vec<&Scene>) {
    scenes.sort_by(|a, b| a.ratio().total_cmp(&b.ratio()));
    let Some(worst) = scenes.last() else { return };
    let at = |share: f64| scenes[(share * (scenes.len() - 1) as f64).round() as usize].ratio();
    let sum = |of: fn(&Scene) -> Duration| scenes.iter().map(|scene| of(scene)).sum::<Duration>();
    println!(
        "| {what} | {} | {:.2} | {:.2} | {:.2} | {:.2}, `{}` of {:.0?} |",
        scenes.len(),
        sum(|scene| scene.with).as_secs_f64() / sum(|scene| scene.without).as_secs_f64(),
        at(0.5),
        at(0.95),
        worst.ratio(),
        worst.name,
        worst.without
    );
}

/// Measures a scene; `None` if it does not run to its end.
fn measured(program: &Path, name: String, file: &Path, rtol: &str) -> Option<Scene> {
    let file = file.to_str()?;
    let run = |more: &[&str]| {
        let began = Instant::now();
        let mut command = Command::new(program);
        command.args(["run", file, "--algebra", "plain", "--rtol", rtol]).args(more);
        let status = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
        status.expect("a program, built before").success().then(|| began.elapsed())
    };
    // Derives the machine.
    run(&["--no-error"])?;
    let began = Instant::now();
    let (mut with, mut without) = (Duration::MAX, Duration::MAX);
    for index in 0..RUNS {
        if index > 0 && began.elapsed() > ENOUGH {
            break;
        }
        without = without.min(run(&["--no-error"])?);
        with = with.min(run(&[])?);
    }
    Some(Scene { name, with, without })
}

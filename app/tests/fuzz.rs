//! Random command lines, scenes and model files. The program must answer in time with one of its
//! exit codes, never with a panic or a signal.

#[path = "../../tests/common/damaged_model.rs"]
mod damaged_model;
#[path = "../../tests/common/mutation.rs"]
mod mutation;

use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use fastrand::Rng;
use machinist::Simulation;
use machinist_model::ModelSimulator;
use machinist_model::file::read;
use machinist_scenes::scenes;

use crate::cli::{answer, machinist, text};
use crate::process;
use damaged_model::{damaged, refused_or_run};
use mutation::{EXTREMES, Fuzz, Rule, damage, other_numbers, pick, texts};

/// Time after which commands that simulate are interrupted, because the run asked for may be very
/// long.
const RUN: Duration = Duration::from_secs(4);
/// Time limit of a command line or of a run of a damaged model, in parallel with other tests.
const PATIENCE: Duration = Duration::from_secs(10);
/// Separator of the arguments of a command line in files of inputs.
const BETWEEN: char = '\n';

/// Built-in scenes that simulate 0.01 s quickly.
const SCENES: &[&str] = &[
    "two_mass",
    "saw_gin",
    "bouncing_mass",
    "four_bar",
    "shaft_step_torque",
    "stick_slip",
    "coulomb_oscillator",
    "pendulum_chain",
    "reed_beat_up",
    "motor_run_up",
    "winder_linear",
    "contact_oscillator_smooth",
    "shaft_with_rotors",
    "slider_crank",
    "contact_oscillator",
];
/// Scenes with few states, whose modes are found quickly even by an unoptimized program.
const SMALL: &[&str] = &[
    "two_mass",
    "saw_gin",
    "bouncing_mass",
    "four_bar",
    "stick_slip",
    "coulomb_oscillator",
    "pendulum_chain",
    "motor_run_up",
    "winder_linear",
    "contact_oscillator_smooth",
];
/// Commands that simulate or search for an operating point.
const RUNS: &[&str] =
    &["run", "sweep", "modes", "response", "campbell", "sensitivity", "gradient", "spectrum"];
/// Arguments that are not built-in scenes.
const OTHERS: &[&str] = &[
    "",
    "nothing",
    "../..",
    "-",
    "/dev/null",
    "Cargo.toml",
    "specs",
    "specs/units/rotor.toml",
    "specs/scenes/two_mass.toml",
    "\u{3c6}",
];
const METHODS: &[&str] = &[
    "bdf", "tr_bdf2", "esdirk34", "tsit45", "tsit5", "dop853", "rodas5p", "radau", "auto",
    "taylor", "exact", "bfd", "",
];
/// Returns the names of a scene's parameters and outputs, and some unknown names.
fn names(scene: &str) -> Vec<String> {
    let mut names = ["", "nothing", "t", "energy.total"].map(str::to_owned).to_vec();
    if let Some(scene) = scenes::find_f64(scene) {
        let shape = scene.shape();
        names.extend((0..shape.parameters).map(|index| scene.parameter(index).name.to_owned()));
        names.extend((0..shape.outputs).map(|index| scene.output(index).name.to_owned()));
    }
    names
}

/// Commands that answer soon, whether they take a scene, and their options.
const COMMANDS: &[(&str, bool, &[&str])] = &[
    ("run", true, &["set", "set", "rtol", "method", "points", "elements", "order", "modes"]),
    ("run", true, &["set", "rtol", "atol", "method", "from", "columns", "out", "points"]),
    ("run", true, &["initial", "code", "start", "max-steps", "time-limit", "fixed"]),
    ("run", true, &["set", "set", "method"]),
    (
        "sweep",
        true,
        &[
            "set", "initial", "from", "atol", "rtol", "method", "points", "threads", "outputs",
            "extremes",
        ],
    ),
    ("modes", true, &["set", "at", "json", "until", "max-steps"]),
    ("response", true, &["set", "at", "range", "points"]),
    ("campbell", true, &["set", "at", "json", "orders"]),
    ("sensitivity", true, &["set", "rtol", "method", "points", "outputs", "parameters", "json"]),
    ("gradient", true, &["set", "rtol", "method", "points", "json", "top"]),
    ("spectrum", true, &["set", "rtol", "method", "samples", "peaks", "outputs", "window"]),
    ("show", true, &["json"]),
    ("check", true, &[]),
    ("list", false, &[]),
    ("parts", false, &[]),
    ("parts show gear", false, &[]),
    ("completions bash", false, &[]),
    ("cache", false, &[]),
    ("explode", true, &["set"]),
];
const COUNTS: &[&str] =
    &["0", "1", "2", "3", "11", "64", "-1", "4294967296", "18446744073709551616", "nan", "1e3"];
/// Times so close that runs end soon.
const TIMES: &[&str] = &[
    "0.01", "0", "-0.0", "0.009", "0.02", "-0.001", "nan", "inf", "1e-320", "10ms", "5 um",
    "1e300 d",
];
const PLACES: &[&str] = &["equilibrium", "initial", "t=0.01", "t=nan", "t=-1", "t=", "nowhere"];

/// Returns an option with its value, mostly one that the command takes.
fn option(rng: &mut Rng, taken: &[&str], names: &[String]) -> Vec<String> {
    let one = |rng: &mut Rng, of: &[&str]| pick(rng, of).copied().unwrap_or_default().to_owned();
    let name = |rng: &mut Rng| pick(rng, names).cloned().unwrap_or_default();
    let strange = ["--help", "--version", "--nothing", "--", "--json", "--set"];
    if taken.is_empty() || rng.u32(0..12) == 0 {
        return vec![one(rng, &strange)];
    }
    let flag = one(rng, taken);
    let value = match flag.as_str() {
        "json" | "extremes" => None,
        "set" | "initial" => Some(format!("{}={}", name(rng), one(rng, EXTREMES))),
        "method" => Some(one(rng, METHODS)),
        "from" | "until" | "time-limit" | "fixed" => Some(one(rng, TIMES)),
        "code" => Some(one(rng, &["compiled", "interpreted", "fast"])),
        "start" => Some(one(rng, &["given", "equilibrium", "here"])),
        "at" => Some(one(rng, PLACES)),
        "columns" | "outputs" | "parameters" => Some(format!("{},{}", name(rng), name(rng))),
        "orders" => Some(format!("{},{}", one(rng, EXTREMES), one(rng, EXTREMES))),
        "window" => Some(one(rng, &["rectangle", "hann", "flat_top", "round"])),
        "out" => Some(one(rng, &["-", "-", "", "/nowhere/a.csv", "a.xls"])),
        "range" => Some(format!("{}:{}", one(rng, EXTREMES), one(rng, EXTREMES))),
        "points" | "max-steps" | "elements" | "order" | "modes" | "threads" | "samples"
        | "peaks" | "top" => Some(one(rng, COUNTS)),
        _ => Some(one(rng, EXTREMES)),
    };
    let flag = format!("--{flag}");
    // Half of them as one word, which allows values that begin with a sign.
    match value {
        Some(value) if rng.bool() => vec![format!("{flag}={value}")],
        value => std::iter::once(flag).chain(value).collect(),
    }
}

/// Returns a command line that is answered soon.
fn command_line(rng: &mut Rng) -> Vec<String> {
    let (command, takes_scene, options) = COMMANDS[rng.usize(0..COMMANDS.len())];
    let known = match command {
        _ if rng.u32(0..10) == 0 => OTHERS,
        "modes" | "response" | "campbell" => SMALL,
        _ => SCENES,
    };
    let scene = pick(rng, known).copied().unwrap_or_default();
    let names = names(scene);
    let name = |rng: &mut Rng| pick(rng, &names).cloned().unwrap_or_default();
    let mut line: Vec<String> = command.split(' ').map(str::to_owned).collect();
    line.extend(takes_scene.then(|| scene.to_owned()));
    match command {
        "run" | "sensitivity" | "spectrum" => line.push("--until=0.01".to_owned()),
        "sweep" | "campbell" => {
            let [low, high] = [(); 2].map(|()| EXTREMES[rng.usize(0..EXTREMES.len())]);
            let range = format!("--parameter={}={low}..{high}", name(rng));
            line.extend([range, "--count=2".to_owned()]);
            line.extend((command == "sweep").then(|| "--until=0.01".to_owned()));
        }
        "gradient" => {
            let of = ["max", "min", "mean", "end", "rms", "most"][rng.usize(0..6)];
            let (a, b) = (name(rng), name(rng));
            let of =
                [format!("{of}({a})"), format!("{of}(abs({a} - {b}))"), format!("{a}*{of}({b})")];
            line.extend([format!("--of={}", of[rng.usize(0..3)]), "--until=0.01".to_owned()]);
        }
        "response" => {
            line.extend(["--input".to_owned(), name(rng), "--output".to_owned(), name(rng)]);
        }
        _ => {}
    }
    for _ in 0..[0, 1, 1, 1, 2, 4][rng.usize(0..6)] {
        line.extend(option(rng, options, &names));
    }
    if rng.u32(0..30) == 0 {
        let [a, b] = [(); 2].map(|()| rng.usize(0..line.len()));
        line.swap(a, b);
    }
    line
}

/// Checks the answer to a command line, whose arguments are separated by [`BETWEEN`].
fn answers(input: &[u8]) -> Result<bool, String> {
    let line = String::from_utf8_lossy(input).into_owned();
    let arguments: Vec<&str> = line.split(BETWEEN).collect();
    let mut command = machinist(&arguments);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the program starts");
    let (start, error) = (Instant::now(), child.stderr.take().expect("standard error"));
    let said = std::thread::spawn(move || std::io::read_to_string(error).unwrap_or_default());
    let out = child.stdout.take().expect("standard output");
    let answer = std::thread::spawn(move || std::io::read_to_string(out).unwrap_or_default());
    let is_run = RUNS.contains(&arguments[0]);
    let mut is_interrupted = false;
    let status = loop {
        if is_run && !is_interrupted && start.elapsed() > RUN {
            is_interrupted = interrupt(child.id());
        }
        match child.try_wait().expect("a child") {
            Some(status) => break status,
            None if start.elapsed() > PATIENCE => {
                child.kill().expect("it ends");
                child.wait().expect("it has ended");
                // Other tests may hold the lock of Symbolica.
                let waits = said.join().is_ok_and(|said| said.contains("waiting for process"));
                return if waits { Ok(false) } else { Err(format!("hangs: {arguments:?}")) };
            }
            None => std::thread::sleep(Duration::from_millis(2)),
        }
    };
    let said = said.join().expect("standard error is read");
    let answer = answer.join().expect("standard output is read");
    let is_number = |word: &str| !["NaN", "inf", "-inf"].contains(&word);
    let is_told = |answer: &str| answer.contains("not a finite number at");
    match status.code() {
        Some(0) if is_run && !answer.split_whitespace().all(is_number) && !is_told(&answer) => {
            Err(format!("no number in the answer: {arguments:?}"))
        }
        Some(0) => Ok(true),
        Some(1 | 2) if !said.trim().is_empty() => Ok(false),
        // A command without a handler for interrupts is ended by one.
        None if is_interrupted && arguments[0] != "run" => Ok(false),
        code => Err(format!("exit {code:?}, {said:.400}: {arguments:?}")),
    }
}

/// Sends a process an interrupt like Ctrl-C, where the system supports it.
fn interrupt(process: u32) -> bool {
    let mut kill = Command::new("kill");
    kill.args(["-INT", &process.to_string()]).status().is_ok_and(|status| status.success())
}

#[test]
fn random_command_lines_are_answered() {
    let make = |rng: &mut Rng| command_line(rng).join(&BETWEEN.to_string()).into_bytes();
    let rule: Rule = Arc::new(answers);
    Fuzz { name: "lines", few: 60, patience: PATIENCE }.run(make, &rule);
}

/// Commands for a scene file, which `FILE` stands for.
const OF_FILES: &[&str] = &[
    "run FILE --until=0.01 --points=3",
    "run FILE --until=0.01 --points=3 --method=radau",
    "run FILE --until=0.01 --points=3 --method=taylor",
    "run FILE --points=11",
    "modes FILE",
    "modes FILE --at=initial",
    "explain FILE --without-times",
    "derive FILE",
    "sensitivity FILE --until=0.01 --points=3",
    "sweep FILE --until=0.01 --points=3 --count=2 --parameter=a.b=0..1",
];

/// Checks the answer to a command in the first line with the scene in the following lines.
fn answers_of_file(input: &[u8]) -> Result<bool, String> {
    let Some(end) = input.iter().position(|byte| *byte == b'\n') else { return Ok(false) };
    let command = String::from_utf8_lossy(&input[..end]);
    if !OF_FILES.contains(&&*command) {
        return Ok(false);
    }
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("made.toml");
    std::fs::write(&file, &input[end + 1..]).expect("a file");
    let named = |word| if word == "FILE" { text(&file) } else { word };
    let own = ["--no-cache", "--algebra=plain"];
    let words: Vec<&str> = command.split(' ').map(named).chain(own).collect();
    answers(words.join(&BETWEEN.to_string()).as_bytes())
}

#[test]
fn damaged_scenes_are_refused_or_answered() {
    let scenes = texts(process::REPOSITORY, &["specs/scenes", "codegen/tests/pass"], "toml");
    let make = move |rng: &mut Rng| {
        let [scene, other] = [(); 2].map(|()| scenes[rng.usize(0..scenes.len())].as_bytes());
        let command = OF_FILES[rng.usize(0..OF_FILES.len())];
        let few = rng.u32(0..3) > 0;
        let made = if few { other_numbers(rng, scene) } else { damage(rng, scene, other) };
        [command.as_bytes(), b"\n", &made].concat()
    };
    let rule: Rule = Arc::new(answers_of_file);
    Fuzz { name: "files", few: 40, patience: PATIENCE }.run(make, &rule);
}

/// Simulates some steps of a model file if its bytes are valid.
fn simulated(bytes: &[u8]) -> Result<bool, String> {
    refused_or_run(bytes)?;
    let Ok(stamped) = read(bytes) else { return Ok(false) };
    if !stamped.model.fields.is_empty() {
        return Ok(true);
    }
    let simulator = ModelSimulator::interpreted(stamped.model);
    let ends = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&ends);
    std::thread::spawn(move || {
        std::thread::sleep(Duration::from_millis(300));
        flag.store(true, Ordering::Relaxed);
    });
    let run = Simulation::new(&simulator).from(0.0).until(0.01).points(3).rtol(1e-4);
    match run.until_flagged(&ends).run() {
        Err(error) if error.to_string().trim().is_empty() => Err("stops without words".to_owned()),
        _ => Ok(true),
    }
}

#[test]
fn damaged_models_of_scenes_are_refused_or_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let model = |scene: &str| {
        let file: PathBuf = folder.path().join("scene.model");
        answer(&["compile", scene, "--out", text(&file)]);
        std::fs::read(&file).expect("a model")
    };
    let scenes = ["two_mass", "bouncing_mass", "shaft_with_rotors", "four_bar", "stick_slip"];
    let models = scenes.map(model);
    let make = move |rng: &mut Rng| {
        let [one, other] = [(); 2].map(|()| &models[rng.usize(0..models.len())]);
        damaged(rng, one, other)
    };
    let rule: Rule = Arc::new(simulated);
    Fuzz { name: "scenes", few: 100, patience: PATIENCE }.run(make, &rule);
}

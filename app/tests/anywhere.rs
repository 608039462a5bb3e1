//! The program in an empty folder, with only its built-in data.

use std::fs;
use std::path::Path;
use std::process::Command;
#[cfg(target_os = "linux")]
use std::{
    process::{Output, Stdio},
    thread::sleep,
    time::{Duration, Instant},
};

use crate::process;
#[cfg(target_os = "linux")]
use crate::process::said;

/// Prepares a call of the program in a folder that is also its home.
fn machinist(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = process::machinist(folder, arguments);
    command.env("HOME", folder);
    command
}

/// Returns standard output of a run that must succeed.
fn answer(folder: &Path, arguments: &[&str]) -> String {
    process::answer(machinist(folder, arguments))
}

/// Asserts bad input: exit code 2, nothing on standard output, and these words on standard error.
fn assert_refused(folder: &Path, arguments: &[&str], words: &[&str]) {
    process::assert_refused(machinist(folder, arguments), words);
}

#[test]
fn scenes_that_are_built_in_need_no_files() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    assert!(answer(folder, &["check", "saw_gin", "m5"]).contains("saw_gin: ok, "));
    assert!(answer(folder, &["derive", "two_mass"]).contains("driver.phi_ddot"));
    answer(folder, &["run", "two_mass", "--keep-all", "--until", "0.01"]);
    assert!(answer(folder, &["explain", "two_mass", "--without-times"]).contains("cyclic"));
    answer(folder, &["verify", "two_mass", "--only", "energy"]);

    let repository = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let [by_name, by_file] = ["name.model", "file.model"].map(|name| folder.join(name));
    let compile = |place: &str, scene: &str, out: &Path| {
        let out = out.to_str().expect("a plain path");
        answer(Path::new(place), &["compile", scene, "--out", out]);
    };
    compile(folder.to_str().expect("a plain path"), "two_mass", &by_name);
    compile(repository, "specs/scenes/two_mass.toml", &by_file);
    assert!(fs::read(by_name).expect("a model") == fs::read(by_file).expect("a model"));
}

#[test]
fn a_name_without_the_ending_of_its_file_is_refused_with_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("hoist.toml"), "").expect("written");
    assert_refused(folder.path(), &["run", "hoist"], &["no scene `hoist`", "`hoist.toml`"]);
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Returns all files below a folder, by their relative paths, sorted.
fn files_in(folder: &Path) -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else {
                let within = path.strip_prefix(folder).expect("within the folder");
                files.push(within.to_string_lossy().into_owned());
            }
        }
    }
    files.sort();
    files
}

#[test]
fn a_new_crate_is_the_example_under_another_name() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = answer(folder.path(), &["new", "own-machine"]);
    assert!(said.contains("cargo run") && said.contains("machinist run specs/own_machine.toml"));
    let made = folder.path().join("own-machine");
    let expected = [
        ".gitignore",
        "Cargo.lock",
        "Cargo.toml",
        "build.rs",
        "specs/own_machine.toml",
        "src/main.rs",
    ];
    assert_eq!(files_in(folder.path()), expected.map(|file| format!("own-machine/{file}")));
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the repository");
    let example = root.join("examples/own_machine");
    for file in expected.iter().filter(|file| **file != "Cargo.toml") {
        assert!(text(&made.join(file)) == text(&example.join(file)), "{file}");
    }
    // The crates are taken from this repository.
    let manifest = text(&made.join("Cargo.toml"));
    for folder in [root.to_owned(), root.join("crates/contract"), root.join("codegen")] {
        assert!(manifest.contains(&format!("path = {folder:?}")), "{manifest}");
    }

    // Existing files stay as they are.
    assert_refused(folder.path(), &["new", "own-machine"], &["own-machine exists already"]);
    assert_eq!(files_in(folder.path()).len(), expected.len());
}

#[test]
fn a_machine_of_standard_parts_is_where_a_new_spec_starts_from() {
    let folder = tempfile::tempdir().expect("a folder");
    for machine in ["winch", "press", "robot", "pendulum", "motor"] {
        let name = format!("my-{machine}");
        let said = answer(folder.path(), &["new", &name, "--from", machine]);
        assert!(said.contains(&format!("wrote {name}.toml")), "{said}");
        let shown = answer(folder.path(), &["show", &format!("{name}.toml")]);
        assert!(shown.starts_with(&format!("my_{machine}: ")), "{shown}");
    }
    let run = answer(folder.path(), &["run", "my-robot.toml", "--until", "0.2"]);
    assert!(run.contains("elbow"), "{run}");
    assert_eq!(files_in(folder.path()).len(), 5);
    let list = answer(folder.path(), &["list"]);
    assert!(list.contains("wind_turbine") && list.contains("machinist parts"), "{list}");
    let by_name = answer(folder.path(), &["run", "wind_turbine", "--until", "1"]);
    assert!(by_name.contains("shaft_torque"), "{by_name}");
    let words = ["there is no machine `wich`", "did you mean `winch`?", "washing_machine"];
    assert_refused(folder.path(), &["new", "x", "--from", "wich"], &words);
    assert_refused(folder.path(), &["new", "my-motor", "--from", "motor"], &["exists already"]);
}

#[test]
fn parts_are_found_by_words_people_use() {
    let folder = tempfile::tempdir().expect("a folder");
    let found = [
        ("hoist", "rotational/rope_drum"),
        ("conveyor", "rotational/conveyor"),
        ("hinge", "planar/revolute"),
        ("dry friction", "rotational/bearing_friction"),
        ("battery", "electrical/battery"),
        ("Worm gear", "rotational/lossy_gear"),
        ("freewheel", "rotational/one_way_clutch"),
        ("shock absorber", "translational/spring_damper"),
        ("rope_drum", "rotational/rope_drum"),
    ];
    for (words, part) in found {
        let list = answer(folder.path(), &["parts", words]);
        assert!(list.lines().any(|line| line.starts_with(part)), "{words}: {list}");
    }
    let shown = answer(folder.path(), &["parts", "show", "rope_drum"]);
    assert!(shown.contains("Also found by: hoist, winch"), "{shown}");
}

#[test]
fn a_new_spec_runs_and_passes_its_check_at_once() {
    let folder = tempfile::tempdir().expect("a folder");
    answer(folder.path(), &["new", "my-hoist", "--spec-only"]);
    assert_eq!(files_in(folder.path()), ["my-hoist.toml"]);
    let shown = answer(folder.path(), &["show", "my-hoist.toml"]);
    assert!(shown.starts_with("my_hoist: Hoist"), "{shown}");
    let run = answer(folder.path(), &["run", "my-hoist.toml"]);
    assert!(run.contains("drum_speed"), "{run}");
    let verified = answer(folder.path(), &["verify", "my-hoist.toml", "--only", "momentum"]);
    assert!(verified.contains("pass") && verified.contains("1 checks, 0 failed"), "{verified}");
    assert_refused(folder.path(), &["new", "my-hoist", "--spec-only"], &["exists already"]);
}

#[test]
fn a_name_that_no_crate_can_have_is_refused_and_writes_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, words) in [
        ("../hoist", ["`../hoist`", "such as `hoist`"]),
        ("Hoist", ["lower-case letters", "such as `hoist`"]),
        ("std", ["`std`", "add a word"]),
        ("match", ["`match`", "keyword of Rust"]),
        ("shape", ["`shape`", "emitted code uses it"]),
    ] {
        for more in [&[][..], &["--spec-only"]] {
            assert_refused(folder.path(), &[&["new", name], more].concat(), &words);
        }
    }
    assert_eq!(files_in(folder.path()), [""; 0]);
}

/// Scene with all kinds of elements that are shown.
const SCENE: &str = r#"
[scene]
name = "hammer"
title = "Hammer on an anvil"
source = "By hand."

[units.drive]
unit = "sources/force"
inputs = { force = "push*sin(2 [rad/s]*t)" }

[units.hammer]
unit = "translational/mass"
parameters = { mass = 3 }

[units.anvil]
unit = "stopper"

[[joints]]
connect = ["drive.a", "hammer.a"]

[[joints]]
connect = ["anvil.end", "hammer.b"]
ratio = 2

[parameters]
push = { value = 5.0, unit = "N", doc = "amplitude of the force" }
lift = { value = 0.25, unit = "m", doc = "place at the start" }

[initial]
"hammer.x" = "2*lift"

[outputs]
place = "hammer.x"

[tunable]
parameters = ["push"]

[checks.start]
of = "place"
values = [[0, 0.5]]
tolerance = 1e-9
source = "By hand."

[run]
until = 0.1
points = 11
rtol = 1e-8
method = "dop853"

[define.stopper.coordinates.x]
unit = "m"

[define.stopper.ports.end]
kind = "translational"
coordinate = "x"

[define.stopper.modes.touched]
doc = "1 once it was touched"

[define.stopper.events.touches]
guard = "x - 1e-3 [m]"
direction = "falling"
when = { touched = 0 }
set = { touched = 1, x_dot = "-x_dot/2" }
doc = "the hammer hits"
"#;

#[test]
fn what_a_scene_is_made_of_is_shown_without_deriving_it() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("hammer.toml"), SCENE).expect("written");
    let mut show = process::machinist(folder.path(), &["show", "hammer.toml"]);
    show.env("COLUMNS", "200");
    let shown = process::answer(show);
    let lines: Vec<String> =
        shown.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    for line in [
        "hammer: Hammer on an anvil",
        "hammer translational/mass Mass",
        "anvil.end translational moves by x",
        "drive.force N = push*sin(2 [rad/s]*t)",
        "anvil.end = (2)*hammer.b",
        "push 5 N amplitude of the force",
        "hammer.mass 3 kg mass (not tunable)",
        "anvil.touched 0 1 1 once it was touched",
        "place m position",
        "start place = 0.5 at 0 s within 1e-9",
        "0 s to 0.1 s, 11 points, rtol 1e-8, method dop853",
    ] {
        assert!(lines.iter().any(|found| found == line), "`{line}` is not in\n{shown}");
    }
    let event = "x - 1e-3 [m] falls through 0, while anvil.touched is 0 \
                 anvil.touched := 1, anvil.x_dot := -x_dot/2 the hammer hits";
    assert!(lines.contains(&format!("anvil.touches {event}")), "{shown}");
    let state = lines
        .iter()
        .find(|line| line.starts_with("anvil.x ") || line.starts_with("hammer.x "))
        .expect("a joined state");
    assert!(state.contains(" 0.5 m ") || state.contains(" 1 m "), "{state}");
}

#[test]
fn what_is_shown_is_there_as_json_of_scenes_and_of_models() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("hammer.toml"), SCENE).expect("written");
    let json = |scene: &str| -> serde_json::Value {
        serde_json::from_str(&answer(folder.path(), &["show", scene, "--json"])).expect("JSON")
    };
    let spec = json("hammer.toml");
    assert_eq!(spec["instances"][2]["ports"][0]["name"], "end");
    assert_eq!(spec["joints"][1]["ratio"], "2");
    assert_eq!(spec["parameters"][0]["value"], 5.0);
    assert_eq!(spec["parameters"][1]["tunable"], false);
    assert_eq!(spec["events"][0]["when"][0][1], 0);
    assert_eq!(spec["run"]["method"], "dop853");

    answer(folder.path(), &["compile", "hammer.toml", "--out", "hammer.model"]);
    let model = json("hammer.model");
    for same in ["scene", "title", "outputs", "checks", "run"] {
        assert_eq!(model[same], spec[same], "{same}");
    }
    assert_eq!(model["parameters"][0], spec["parameters"][0]);
    let initial = |shown: &serde_json::Value| {
        let states = shown["states"].as_array().expect("states");
        let place = states.iter().find(|state| state["kind"] == "coordinate");
        place.expect("a place")["initial"].clone()
    };
    assert_eq!(initial(&model), initial(&spec));
    assert_eq!(json("saw_gin")["states"].as_array().map(Vec::len), Some(8));
}

#[test]
fn a_scene_with_a_mistake_is_not_shown_but_pointed_at() {
    let folder = tempfile::tempdir().expect("a folder");
    let wrong = SCENE.replace("\"hammer.b\"", "\"hammer.c\"");
    fs::write(folder.path().join("hammer.toml"), wrong).expect("written");
    assert_refused(folder.path(), &["show", "hammer.toml"], &["hammer.toml:22", "hammer.c"]);
    assert_refused(folder.path(), &["show", "saw_gni"], &["did you mean `saw_gin`?"]);
}

#[test]
fn shells_are_told_all_commands_but_the_hidden_one() {
    let folder = tempfile::tempdir().expect("a folder");
    for shell in ["bash", "zsh", "fish"] {
        let text = answer(folder.path(), &["completions", shell]);
        for word in ["spec-only", "verify", "no-cache"] {
            assert!(text.contains(word), "{shell}: {word}");
        }
        assert!(!text.contains("derive-for-parent"), "{shell}");
    }
    assert_refused(folder.path(), &["completions", "csh"], &["bash, zsh, fish"]);
}

#[test]
fn a_run_says_which_method_auto_chose_and_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = answer(folder.path(), &["run", "winder_full", "--method", "auto", "--until", "0.01"]);
    assert!(run.contains("\nstarts with "), "{run}");
    let run = answer(folder.path(), &["run", "two_mass", "--method", "auto"]);
    assert!(run.contains("\nlinear with constant coefficients: solved by "), "{run}");
}

/// Returns whether a process has a handler for SIGINT yet.
#[cfg(target_os = "linux")]
fn catches_interrupts(process: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).expect("it runs");
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let caught = caught.map(|mask| u64::from_str_radix(mask.trim(), 16).expect("a mask"));
    caught.is_some_and(|mask| mask & (1 << (2 - 1)) != 0)
}

/// Returns the output of a run that is interrupted once it handles interrupts.
#[cfg(target_os = "linux")]
fn interrupted(folder: &Path, run: &[&str]) -> Output {
    let mut command = machinist(folder, run);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let waiting = Instant::now();
    while !catches_interrupts(child.id()) {
        assert!(waiting.elapsed() < Duration::from_secs(60), "it never listens");
        sleep(Duration::from_millis(5));
    }
    // Until the run checks the flag.
    sleep(Duration::from_millis(50));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("a signal").success());
    child.wait_with_output().expect("an end")
}

/// The damping forces steps so short that the run never reaches its second point.
#[test]
#[cfg(target_os = "linux")]
fn a_run_that_is_interrupted_at_its_first_point_says_when_that_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let damping = "oscillator.damping=18446744073709551616";
    let run = ["run", "contact_oscillator_smooth", "--until", "0.01", "--set", damping];
    let output = interrupted(folder.path(), &[&run[..], &["--method", "dop853"]].concat());
    let summary = String::from_utf8_lossy(&output.stdout);
    assert!(summary.contains("0 s to 0 s, 1 points"), "{summary}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_run_that_is_interrupted_keeps_what_it_has() {
    let folder = tempfile::tempdir().expect("a folder");
    // The whole run would take minutes.
    let run = ["run", "two_mass", "--method", "tsit5", "--until", "1e7", "--points", "1000001"];
    let output = interrupted(folder.path(), &[&run[..], &["--out", "part.json"]].concat());
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    assert!(said(&output).contains("the run was interrupted"), "{}", said(&output));
    assert!(said(&output).contains("are in part.json"), "{}", said(&output));
    let summary = String::from_utf8_lossy(&output.stdout);
    assert!(summary.contains("\nstopped early, at "), "{summary}");
    let part: serde_json::Value =
        serde_json::from_str(&text(&folder.path().join("part.json"))).expect("JSON");
    assert_eq!(part["stopped"]["cause"], "the run was interrupted");
    assert!(part["times"].as_array().is_some_and(|times| times.len() < 1_000_001));
}

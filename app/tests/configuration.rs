//! Settings from `machinist.toml` and the environment.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::process::{answer, assert_refused, machinist, output, said};

/// Project in a folder, with a folder for the user's configuration.
struct Project {
    folder: tempfile::TempDir,
}

impl Project {
    fn new(project: &str, user: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let of_user = folder.path().join("config/machinist");
        fs::create_dir_all(&of_user).expect("a folder");
        fs::create_dir_all(folder.path().join("project/deep")).expect("a folder");
        let write = |folder: &Path, text: &str| {
            if !text.is_empty() {
                fs::write(folder.join("machinist.toml"), text).expect("written");
            }
        };
        write(&of_user, user);
        write(&folder.path().join("project"), project);
        Self { folder }
    }

    /// Prepares a call in a folder below that of the project.
    fn call(&self, words: &[&str]) -> Command {
        let mut command = machinist(self.folder.path().join("project/deep"), words);
        command.env("XDG_CONFIG_HOME", self.folder.path().join("config"));
        command
    }

    fn run(&self, more: &[&str]) -> Command {
        self.call(&[&["run", "two_mass", "--no-error", "--until", "1ms"], more].concat())
    }
}

#[test]
fn the_command_line_wins_over_the_environment_the_project_and_the_user() {
    let project =
        Project::new("rtol = 1e-5\nmethod = \"dop853\"", "rtol = 1e-4\nmethod = \"radau\"");
    let says = |command: Command, words: &str| {
        let text = answer(command);
        assert!(text.contains(words), "{words}: {text}");
    };
    says(project.run(&[]), "dop853, rtol 1e-5");
    let mut command = project.run(&[]);
    command.env("MACHINIST_RTOL", "1e-6");
    says(command, "dop853, rtol 1e-6");
    let mut command = project.run(&["--rtol", "1e-7", "--method", "tsit5"]);
    command.env("MACHINIST_RTOL", "1e-6");
    says(command, "tsit5, rtol 1e-7");
    let of_user = Project::new("", "rtol = 1e-4\nmethod = \"radau\"");
    says(of_user.run(&[]), "radau, rtol 1e-4");
    let of_both = Project::new("rtol = 1e-5", "method = \"radau\"");
    says(of_both.run(&[]), "radau, rtol 1e-5");
    // Other commands heed the same settings.
    let sweep = ["sweep", "two_mass", "--over", "load_torque=0..1", "--count", "2"];
    let loose = Project::new("rtol = 1e-3", "");
    let asked = Project::new("", "");
    let by_option = answer(asked.call(&[&sweep[..], &["--rtol", "1e-3"]].concat()));
    assert_eq!(answer(loose.call(&sweep)), by_option);
    assert_ne!(answer(asked.call(&sweep)), by_option);
}

#[test]
fn settings_from_files_are_named_when_they_are_used() {
    let project = Project::new("rtol = 1e-5\nthreads = 1", "");
    let told = said(&output(project.run(&[])));
    assert!(told.contains("machinist: rtol 1e-5, from"), "{told}");
    assert!(told.contains("machinist.toml") && !told.contains("threads"), "{told}");
    assert_eq!(told.matches("rtol").count(), 1, "{told}");
    assert_eq!(said(&output(project.run(&["--rtol", "1e-6"]))), "");
    assert_eq!(said(&output(project.call(&["list"]))), "");
}

#[test]
fn mistakes_of_a_configuration_are_refused_with_line_and_hint() {
    let wrong = |text: &str, words: &[&str]| {
        let project = Project::new(text, "");
        assert_refused(project.run(&[]), words);
    };
    wrong("rtol = 1e-5\nmetod = \"radau\"", &["no key `metod`", "machinist.toml:2:1", "`method`"]);
    wrong("rtol = -1", &["`rtol`", "machinist.toml:1:8", "0 to 1"]);
    wrong("rtol = ", &["machinist.toml:1"]);
    wrong("method = \"raddau\"", &["`method`", "radau"]);
    wrong("algebra = \"maxima\"", &["`algebra`", "plain"]);
    let of_user = Project::new("", "colour = 1");
    assert_refused(of_user.run(&[]), &["no key `colour`", "`colours`"]);
    let project = Project::new("", "");
    let mut command = project.run(&[]);
    command.env("MACHINIST_THREADS", "none");
    assert_refused(command, &["MACHINIST_THREADS is `none`", "at least 1"]);
}

#[test]
fn a_spec_of_this_name_is_not_taken_for_a_configuration() {
    let project = Project::new("[scene]\nname = \"machinist\"\n[run]\nrtol = 1e-5", "");
    let output = output(project.run(&["--rtol", "1e-6"]));
    assert!(output.status.success());
    assert!(said(&output).contains("is a spec, so it is not read as configuration"));
}

#[test]
fn messages_are_coloured_as_asked() {
    let coloured = |project: &Project, more: &[&str], plain: bool| {
        let mut command = project.call(&[&["run", "no_such_scene"], more].concat());
        if !plain {
            command.env_remove("NO_COLOR");
        }
        let output = output(command);
        assert_eq!(output.status.code(), Some(2));
        output.stderr.contains(&0x1b)
    };
    let always = Project::new("colours = \"always\"", "");
    assert!(coloured(&always, &[], false));
    assert!(!coloured(&always, &[], true), "NO_COLOR wins over the file");
    assert!(coloured(&always, &["--colours", "always"], true));
    assert!(!coloured(&always, &["--colours=never"], false));
    assert!(!coloured(&Project::new("", ""), &[], false), "no terminal");
}

/// A mass that is thrown up and counts its fall.
const THROWN: &str = r#"
[scene]
name = "thrown"
[units.m]
unit = "mass"
[run]
until = 3
[outputs]
x = "m.x"
[define.mass.coordinates.x]
unit = "m"
velocity = "v"
[define.mass.energy]
kinetic = "1 [kg]*v^2/2"
potential = "9.81 [N]*x"
[define.mass.modes.phase]
initial = 0
[define.mass.events.fall]
guard = "v"
direction = "falling"
set = { phase = 1 }
doc = "it begins to fall"
[initial]
"m.v" = 10
"#;

#[test]
fn a_log_lists_derivations_runs_and_their_events_with_times_if_asked() {
    let logged = |level: &str| {
        let project = Project::new("", "");
        let file = project.folder.path().join("project/deep/thrown.toml");
        fs::write(file, THROWN).expect("written");
        let mut command = project.call(&["run", "thrown.toml", "--no-cache", "--algebra", "plain"]);
        command.env("MACHINIST_LOG", level);
        let output = output(command);
        assert!(output.status.success(), "{}", said(&output));
        said(&output)
    };
    assert_eq!(logged("off"), "");
    let [info, debug] = ["info", "debug"].map(logged);
    for (words, is_detail) in [
        ("derive{scene=\"thrown\"", false),
        ("run{scene=\"thrown\"", false),
        ("time.busy", false),
        ("segment{from=0", true),
        ("event=\"m.fall\"", true),
    ] {
        assert!(debug.contains(words), "{words}: {debug}");
        assert_ne!(info.contains(words), is_detail, "{words}: {info}");
    }
    let project = Project::new("", "");
    let mut command = project.run(&[]);
    command.env("MACHINIST_LOG", "loud");
    assert_refused(command, &["MACHINIST_LOG is `loud`", "debug"]);
}

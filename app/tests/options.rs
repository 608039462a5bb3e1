//! Options are the same for all commands that share them, and none is accepted and ignored.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::sync::Mutex;
use std::thread;

use clap::{Arg, Command};

use crate::process::{answer, assert_refused, machinist, output, said};

/// Headings of the options that commands share.
const SHARED: [&str; 3] = ["Machine", "Run", "Derivation"];

/// Returns all commands that a user sees, by the words that call them.
fn commands() -> BTreeMap<String, Command> {
    fn add(command: &Command, name: &str, all: &mut BTreeMap<String, Command>) {
        for inner in command.get_subcommands().filter(|inner| !inner.is_hide_set()) {
            let name = format!("{name} {}", inner.get_name()).trim().to_owned();
            all.insert(name.clone(), inner.clone());
            add(inner, &name, all);
        }
    }
    let mut all = BTreeMap::new();
    add(&machinist_app::command(), "", &mut all);
    all
}

/// Returns whether a command has the options of a struct.
fn has(command: &Command, group: &str) -> bool {
    command.get_groups().any(|found| found.get_id() == group)
}

/// Returns the shared options of a command by name, each with all that a user sees of it.
fn shared(command: &Command) -> BTreeMap<String, String> {
    let shared =
        command.get_arguments().filter(|arg| arg.get_help_heading().is_some_and(is_shared));
    let described = shared.filter_map(|option| {
        let help = option.get_help().map(ToString::to_string);
        let values = option.get_value_names().map(<[_]>::to_vec);
        let described = format!("{values:?} {help:?} {:?}", option.get_help_heading());
        Some((option.get_long()?.to_owned(), described))
    });
    described.collect()
}

fn is_shared(heading: &str) -> bool {
    SHARED.contains(&heading)
}

#[test]
fn a_shared_option_is_the_same_in_all_commands() {
    let commands = commands();
    let mut known: BTreeMap<String, (String, String)> = BTreeMap::new();
    for (name, command) in &commands {
        for (option, described) in shared(command) {
            let (first, other) =
                known.entry(option.clone()).or_insert((name.clone(), described.clone()));
            assert_eq!(*other, described, "--{option} of {first} and {name}");
        }
    }
    assert!(known.len() > 10, "{} shared options", known.len());
    for (name, command) in &commands {
        let has_scene = command.get_arguments().any(|arg| arg.get_id() == "scene");
        let of_command = shared(command);
        for own in command.get_arguments().filter_map(Arg::get_long).filter(|_| has_scene) {
            let is_own = !of_command.contains_key(own);
            assert!(
                !(is_own && known.contains_key(own)),
                "--{own} of {name} is not the shared one"
            );
        }
    }
}

#[test]
fn every_file_or_folder_of_results_may_be_given_by_o() {
    for (name, command) in commands() {
        if let Some(out) = command.get_arguments().find(|arg| arg.get_long() == Some("out")) {
            assert_eq!(out.get_short(), Some('o'), "{name}");
        }
    }
}

#[test]
fn every_command_that_runs_a_scene_takes_the_same_options() {
    let commands = commands();
    let running: Vec<_> = commands.iter().filter(|(_, one)| has(one, "MachineArgs")).collect();
    let (of_runs, of_others): (Vec<_>, Vec<_>) =
        running.into_iter().partition(|(_, command)| has(command, "RunArgs"));
    let options = |command| shared(command).into_keys().collect::<BTreeSet<String>>();
    let (first, model) = of_runs[0];
    for (name, command) in &of_runs {
        assert_eq!(options(command), options(model), "{name} and {first}");
    }
    assert!(of_runs.len() > 10 && options(model).len() > 10, "{} commands", of_runs.len());
    for (name, command) in of_others {
        // A comparison of methods at several tolerances has lists of both.
        let has_own = |id| command.get_arguments().any(|arg| arg.get_id() == id);
        assert!(has_own("methods") && has_own("rtols"), "{name}");
        assert!(has(command, "SpanArgs") && has(command, "TimeArgs"), "{name}");
    }
}

/// Calls of the commands that run a scene.
const CALLS: [(&str, &str); 17] = [
    ("run", "two_mass"),
    ("plot", "two_mass --out=two_mass.svg"),
    ("sensitivity", "two_mass --parameters=load_torque"),
    ("gradient", "two_mass --of=max(twist)"),
    ("fit", "two_mass --data=data.csv --parameters=load_torque"),
    ("improve", "two_mass --minimise=max(twist) --parameters=load_torque=0..1"),
    ("spectrum", "two_mass"),
    ("fatigue", "two_mass"),
    ("sweep", "two_mass --parameter=load_torque=0..1 --count=2"),
    ("scatter", "two_mass --vary=load_torque=uniform(900,1000) --samples=16"),
    ("modes", "two_mass"),
    ("campbell", "two_mass --parameter=load_torque=0..1 --count=2"),
    ("response", "two_mass --input=load_torque --output=twist"),
    ("linearize", "two_mass --inputs=load_torque --outputs=twist"),
    ("cycle", "stick_slip"),
    ("verify", "two_mass"),
    ("bench", "two_mass --methods=tsit5 --rtols=1e-3 --runs=1"),
];

/// Options that stop or refuse any run that heeds them, and a word of the reason.
const STOPS: [(&str, &str); 9] = [
    ("--max-steps=1", "step"),
    ("--time-limit=1us", "stopped"),
    ("--until=-1", "-1"),
    ("--from=1e9", "1000000000"),
    ("--rtol=-1", "-1"),
    ("--atol=-1", "-1"),
    ("--method=tsit6", "tsit5"),
    ("--initial=twists=1", "twists"),
    ("--elements=3", "has no fields"),
];

#[test]
fn no_option_of_runs_is_accepted_and_ignored() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("data.csv"), "t,twist\n0,0\n0.1,0.001\n0.2,0.001\n")
        .expect("data");
    let commands = commands();
    let running: BTreeSet<&str> = commands
        .iter()
        .filter(|(_, command)| has(command, "MachineArgs"))
        .map(|(name, _)| name.as_str())
        .collect();
    assert_eq!(running, CALLS.iter().map(|(name, _)| *name).collect());
    let calls = CALLS.iter().flat_map(|call| STOPS.iter().map(move |stop| (call, stop)));
    let calls = calls.filter(|((name, _), (option, _))| {
        let id = option[2..].split('=').next().unwrap_or_default().replace('-', "_");
        commands[*name].get_arguments().any(|arg| arg.get_id() == id.as_str())
    });
    let (left, mistakes) = (Mutex::new(calls.collect::<Vec<_>>()), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                loop {
                    let Some(call) = left.lock().expect("calls").pop() else { return };
                    let (&(name, more), &(option, word)) = call;
                    mistakes
                        .lock()
                        .expect("mistakes")
                        .extend(heeded(&folder, name, more, option, word));
                }
            });
        }
    });
    let mistakes = mistakes.into_inner().expect("mistakes");
    assert!(mistakes.is_empty(), "\n{}", mistakes.join("\n"));
}

/// Returns a mistake unless a command heeds an option.
fn heeded(
    folder: impl AsRef<Path>,
    name: &str,
    more: &str,
    option: &str,
    word: &str,
) -> Option<String> {
    let words: Vec<&str> = std::iter::once(name).chain(more.split(' ')).chain([option]).collect();
    let output = output(machinist(folder, &words));
    let all = said(&output) + &*String::from_utf8_lossy(&output.stdout);
    let is_heeded = !output.status.success() && all.contains(word);
    (!is_heeded).then(|| format!("{words:?}: {:?}, {all:.300}", output.status.code()))
}

#[test]
fn numbers_of_options_may_have_units() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |more: &[&str]| {
        let words = [&["run", "two_mass", "--out", "-", "--points", "3"], more].concat();
        answer(machinist(&folder, &words))
    };
    let plain = run(&["--until", "0.1", "--set", "load_torque=2000", "--fixed", "1e-4"]);
    for units in
        [["100ms", "load_torque=2 kN m", "100us"], ["100 ms", "load_torque=2000 [N m]", "0.1 [ms]"]]
    {
        let [until, set, fixed] = units;
        assert_eq!(run(&["--until", until, "--set", set, "--fixed", fixed]), plain, "{units:?}");
    }
    let atol = |text: &str| run(&["--until", "0.1", "--no-error", "--atol", text]);
    assert_eq!(atol("coupling.twist=1e-9"), atol("coupling.twist=1e-9 rad"));
    assert_ne!(atol("1e-3"), atol("1e-12"));
    let counted = |curve: [&str; 2]| {
        answer(machinist(&folder, &[&["fatigue", "two_mass", "--json"], &curve[..]].concat()))
    };
    let plain = counted(["--endurance=coupling_torque=400", "--mean=none"]);
    assert_eq!(counted(["--endurance=coupling_torque=0.4 kN m", "--mean=none"]), plain);
    let scattered = |law: &str| {
        let vary = format!("--vary=load_torque={law}");
        answer(machinist(&folder, &["scatter", "two_mass", "--samples=16", "--json", &vary]))
    };
    let plain = scattered("normal(2000, 100)");
    assert_eq!(scattered("normal(2 kN m, 0.1[kN m])"), plain);
    assert_eq!(scattered("normal(2kN m, 5 %)"), plain);
    assert_eq!(scattered("2 kN m +- 300N m"), scattered("2000 +- 300"));
}

#[test]
fn units_of_another_dimension_are_refused_with_a_hint() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |words: &[&str], said: &[&str]| assert_refused(machinist(&folder, words), said);
    refused(&["run", "two_mass", "--until", "5 m"], &["is in m, but must be in s", "500ms"]);
    refused(&["run", "two_mass", "--until", "5 parsec"], &["parsec"]);
    for (typed, meant) in [
        ("2sec", "`s`"),
        ("2 minutes", "`min`"),
        ("5 msec", "`ms`"),
        ("5 µs", "`us`"),
        ("2S", "`s`"),
        ("1 MS", "`ms` or `mS`"),
    ] {
        let words = format!("did you mean {meant}?");
        refused(&["run", "two_mass", "--until", typed], &[&words]);
    }
    for (typed, meant) in [("2 Nm", "`N m`"), ("2 NM", "`N m`"), ("2 N·m", "`N m`")] {
        let words = format!("did you mean {meant}?");
        refused(&["run", "two_mass", "--set", &format!("load_torque={typed}")], &[&words]);
    }
    refused(&["run", "two_mass", "--until", ""], &["not a number"]);
    refused(&["run", "two_mass", "--until", "nan"], &["not a finite number"]);
    refused(&["run", "two_mass", "--rtol", "1e-6 s"], &["has no unit"]);
    refused(&["run", "two_mass", "--fixed", "0us"], &["--fixed 0", "above zero"]);
    refused(&["run", "two_mass", "--set", "load_torque=2 kN"], &["is in N m, and not in kN"]);
    let fatigue = ["fatigue", "two_mass", "--outputs=coupling_torque"];
    for curve in ["--endurance=coupling_torque=1 kN", "--endurance=1kN", "--mean=goodman:5 kN"] {
        refused(&[&fatigue[..], &[curve]].concat(), &["coupling_torque is in N m, and not in kN"]);
    }
    refused(&[&fatigue[..], &["--mean=walker:0.5 m"]].concat(), &["has no unit"]);
    refused(&["modes", "two_mass", "--at", "t=5mm"], &["must be in s"]);
    refused(&["verify", "two_mass", "--time-limit", "0s"], &["above 0 s"]);
    refused(&["verify", "--until", "5"], &["SCENE"]);
    fs::write(folder.path().join("data.csv"), "t,twist\n0,0\n0.1,0.001\n").expect("data");
    let fit = ["fit", "two_mass", "--data=data.csv", "--parameters=load_torque"];
    let sigma = |value| [&fit[..], &["--sigma", value]].concat();
    refused(&sigma("twist=1 mm"), &["sigma of twist is in rad, and not in mm"]);
    refused(&sigma("twist=1 parsec"), &["parsec", "0.02 + 1 %"]);
    refused(&["studies", "walk", "--speed", "2 m"], &["must be in m/s"]);
    refused(&["modes", "two_mass", "--at", "initial", "--rtol", "1e-3"], &["--rtol has no effect"]);
    refused(&["--algebra", "plain", "list"], &["`list` derives nothing"]);
}

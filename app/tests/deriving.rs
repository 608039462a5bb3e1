//! The cache of derivations, whatever happens to it, and the lock of Symbolica, which no simulation
//! holds.

use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use crate::process;
use crate::symbolica::{Lock, assert_ends};

/// Pendulum of a given length, so that each test has a text of its own.
fn spec(length: f64) -> String {
    format!(
        r#"
[scene]
name = "pendulum"

[units.bob]
unit = "bob"

[outputs]
angle = "bob.phi"

[run]
until = 0.5
points = 11
rtol = 1e-9
method = "dop853"

[initial]
"bob.phi" = 1.0

[define.bob.unit]
name = "bob"

[define.bob.coordinates.phi]
unit = "rad"
velocity = "omega"

[define.bob.parameters]
mass = {{ value = 1.0, unit = "kg" }}
length = {{ value = {length}, unit = "m" }}
gravity = {{ value = 9.81, unit = "m/s^2" }}

[define.bob.energy]
kinetic = "mass*(length*omega)^2/2"
potential = "-mass*gravity*length*cos(phi)"
"#
    )
}

/// Prepares a call of the program in a folder with its own cache.
fn machinist(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = process::machinist(folder, arguments);
    command.env("MACHINIST_CACHE", folder.join("cache"));
    command
}

fn answer(folder: &Path, arguments: &[&str]) -> String {
    let output = machinist(folder, arguments).output().expect("the program starts");
    succeeded(&output)
}

fn succeeded(output: &Output) -> String {
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).expect("text")
}

fn folder_with(length: f64) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("own.toml"), spec(length)).expect("a spec");
    folder
}

const RUN: [&str; 4] = ["run", "own.toml", "--out", "-"];
/// The same run, derived by Symbolica.
const OTHER: [&str; 5] = ["run", "own.toml", "--out", "-", "--algebra=symbolica"];

#[test]
fn our_own_algebra_derives_the_same_machine_and_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("bob.toml"), spec(1.7)).expect("written");
    let program = |arguments: &[&str]| {
        process::machinist(folder.path(), &[&["--no-cache"], arguments].concat())
    };
    let derived = process::output(program(&["derive", "bob.toml", "--algebra", "plain"]));
    assert!(String::from_utf8_lossy(&derived.stdout).contains("simplifies less"));
    assert!(!process::said(&derived).contains("Symbolica"), "{}", process::said(&derived));
    let angles = |algebra: &str| -> Vec<f64> {
        let arguments = ["run", "bob.toml", "--out", "-", "--algebra", algebra];
        let table = process::answer(program(&arguments));
        let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let head = lines.next().expect("a head");
        let column = head.iter().position(|name| name.starts_with("angle")).expect("the angle");
        lines.map(|line| line[column].parse().expect("a number")).collect()
    };
    let (plain, other) = (angles("plain"), angles("symbolica"));
    assert_eq!(plain.len(), 11);
    assert!(plain.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-9), "{plain:?} {other:?}");
    process::assert_refused(
        program(&["derive", "bob.toml", "--algebra", "maxima"]),
        &["symbolica and plain"],
    );
}

#[test]
fn the_environment_names_an_algebra_and_an_option_overrides_it() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("bob.toml"), spec(1.7)).expect("written");
    let by = |algebra: &str, more: &[&str]| {
        let mut command = process::machinist(
            folder.path(),
            &[&["--no-cache", "derive", "bob.toml", "--json"], more].concat(),
        );
        command.env("MACHINIST_ALGEBRA", algebra);
        command
    };
    for (algebra, more, expected) in [
        ("plain", &[][..], "plain"),
        ("symbolica", &["--algebra", "plain"][..], "plain"),
        ("", &["--algebra", "plain"][..], "plain"),
        ("", &[][..], "symbolica"),
    ] {
        let answer = process::answer(by(algebra, more));
        assert!(answer.contains(&format!("\"algebra\": \"{expected}\"")), "{algebra}: {answer}");
    }
    process::assert_refused(by("maxima", &[]), &["MACHINIST_ALGEBRA", "`maxima`", "plain"]);
}

#[test]
fn a_users_own_file_is_derived_without_notice_while_another_process_uses_symbolica() {
    let folder = folder_with(1.3);
    let lock = Lock::held();
    for arguments in [
        &RUN[..],
        &["modes", "own.toml"],
        &["verify", "own.toml", "--time-limit", "20"],
        &["compile", "own.toml", "--out", "own.model"],
        &["fmu", "own.toml", "--out", "own.fmu"],
        &["explain", "own.toml", "--without-times"],
        &["sweep", "own.toml", "--parameter", "bob.length=1..2", "--count", "2"],
        &["report", "own.toml", "--no-times"],
    ] {
        let command = machinist(folder.path(), &[&["--no-cache"], arguments].concat());
        let output = assert_ends(command);
        succeeded(&output);
        let said = process::said(&output);
        assert!(!said.contains("Symbolica") && !said.contains("waiting"), "{arguments:?}: {said}");
        assert!(arguments != RUN || said.is_empty(), "{said}");
    }
    drop(lock);
}

#[test]
fn who_asks_for_symbolica_while_it_is_in_use_is_told_at_once_and_offered_the_other() {
    let folder = folder_with(1.4);
    for (arguments, variable) in [
        (&["derive", "own.toml", "--no-cache"][..], ""),
        (&["run", "own.toml", "--no-cache", "--algebra", "symbolica"], ""),
        (&["run", "own.toml", "--no-cache"], "symbolica"),
    ] {
        let lock = Lock::held();
        let mut command = machinist(folder.path(), arguments);
        command.env("MACHINIST_ALGEBRA", variable).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut waits = command.spawn().expect("the program starts");
        let mut errors = BufReader::new(waits.stderr.take().expect("it is piped"));
        let (said, first) = std::sync::mpsc::channel();
        let rest = std::thread::spawn(move || {
            let mut line = String::new();
            errors.read_line(&mut line).expect("a line");
            said.send(line).expect("somebody listens");
            let _ = std::io::copy(&mut errors, &mut std::io::sink());
        });
        let line = first.recv_timeout(Duration::from_secs(60)).expect("it says something");
        for words in ["machinist: waiting for", "--algebra plain"] {
            assert!(line.contains(words), "{arguments:?}: {line}");
        }
        assert!(waits.try_wait().expect("it is there").is_none(), "it waits");
        drop(lock);
        assert!(waits.wait().expect("it ends").success(), "{arguments:?}");
        rest.join().expect("its words are read");
    }
}

#[test]
fn a_second_run_derives_nothing_and_gives_the_same() {
    let folder = folder_with(0.7);
    let first = machinist(folder.path(), &OTHER).output().expect("the program starts");
    assert!(String::from_utf8_lossy(&first.stderr).contains("deriving with Symbolica"));
    let second = machinist(folder.path(), &OTHER).output().expect("the program starts");
    assert!(second.stderr.is_empty(), "{}", String::from_utf8_lossy(&second.stderr));
    assert_eq!(succeeded(&first), succeeded(&second));
    assert!(answer(folder.path(), &["cache"]).contains(" 1 entries"));
    // Each algebra has its own entry, whether it is named or the default.
    let by_default = answer(folder.path(), &RUN);
    assert!(answer(folder.path(), &["cache"]).contains(" 2 entries"));
    let named = answer(folder.path(), &[&RUN[..], &["--algebra", "plain"]].concat());
    assert_eq!(named, by_default);
    assert!(answer(folder.path(), &["cache"]).contains(" 2 entries"));
    // A changed text has its own entry.
    fs::write(folder.path().join("own.toml"), spec(0.8)).expect("a spec");
    assert_ne!(answer(folder.path(), &RUN), by_default);
    assert!(answer(folder.path(), &["cache"]).contains(" 3 entries"));
    assert!(answer(folder.path(), &["cache", "--clear"]).contains("deleted 3 entries"));
    assert!(answer(folder.path(), &["cache"]).contains(" 0 entries"));
}

#[test]
fn a_model_file_gives_what_its_spec_gives_and_needs_it_no_more() {
    let folder = folder_with(0.7);
    let by_spec = answer(folder.path(), &RUN);
    answer(folder.path(), &["compile", "own.toml", "--out", "own.model"]);
    fs::remove_file(folder.path().join("own.toml")).expect("it is there");
    fs::remove_dir_all(folder.path().join("cache")).expect("it is there");
    let output = machinist(folder.path(), &["run", "own.model", "--out", "-"]).output();
    let output = output.expect("the program starts");
    assert_eq!(succeeded(&output), by_spec);
    assert!(output.stderr.is_empty(), "nothing is derived");
    for command in ["modes", "check", "explain"] {
        let arguments = [command, "own.model"];
        let wanted = if command == "explain" { "nothing" } else { "" };
        let output = machinist(folder.path(), &arguments).output().expect("the program starts");
        let said = succeeded(&output).to_lowercase();
        assert!(said.contains(wanted), "{command}: {said}");
    }
}

/// Returns the scene files of the repository.
fn scene_files() -> Vec<PathBuf> {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let folders = [scenes.clone(), scenes.join("bench"), scenes.join("msl")];
    let files = folders.iter().flat_map(|folder| fs::read_dir(folder).expect("scenes"));
    let files = files.map(|file| file.expect("a file").path());
    files.filter(|file| file.extension().is_some_and(|ending| ending == "toml")).collect()
}

/// `MACHINIST_RUNNER=target/debug/machinist` of a build with `--no-default-features` shows that the
/// generator is not even in the program.
#[test]
fn every_scene_gives_the_same_bits_from_its_model_alone() {
    let own = env!("CARGO_BIN_EXE_machinist").to_owned();
    let runner = std::env::var("MACHINIST_RUNNER").unwrap_or(own);
    let runner = fs::canonicalize(runner).expect("a program");
    let files = scene_files();
    assert!(files.len() > 40, "{} scenes", files.len());
    let next = AtomicUsize::new(0);
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
                    assert_same_from_its_model(file, &runner);
                }
            });
        }
    });
}

fn assert_same_from_its_model(file: &Path, runner: &Path) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = file.to_str().expect("a plain path");
    let run = ["--until", "0.002", "--points", "3", "--out", "-"];
    // Uses the cache of all tests, because others derive these scenes too.
    let answer = |arguments: &[&str]| {
        let program = process::machinist(folder.path(), arguments).output();
        succeeded(&program.expect("the program starts"))
    };
    let by_spec = answer(&[&["run", file], &run[..]].concat());
    answer(&["compile", file, "--out", "one.model"]);
    let by_model = Command::new(runner)
        .args([&["run", "one.model"], &run[..]].concat())
        .current_dir(folder.path())
        .env("MACHINIST_CACHE", folder.path().join("another"))
        .output()
        .expect("the program starts");
    assert_eq!(succeeded(&by_model), by_spec, "{file}");
    assert!(!String::from_utf8_lossy(&by_model.stderr).contains("deriving"), "{file}");
}

#[test]
fn a_cache_that_is_taken_away_all_the_time_changes_nothing() {
    let folder = folder_with(0.7);
    let right = answer(folder.path(), &RUN);
    let is_over = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while !is_over.load(Ordering::Relaxed) {
                // It may be gone already, or get a new entry while it is deleted.
                let _ = fs::remove_dir_all(folder.path().join("cache"));
            }
        });
        let again = || machinist(folder.path(), &RUN).output().expect("the program starts");
        let outputs: Vec<Output> = (0..6).map(|_| again()).collect();
        is_over.store(true, Ordering::Relaxed);
        for output in outputs {
            assert_eq!(succeeded(&output), right);
        }
    });
}

/// Simulates a full disk: no file may grow beyond some bytes.
#[cfg(unix)]
#[test]
fn what_finds_no_room_is_refused_or_done_without_and_leaves_nothing_half_written() {
    let folder = folder_with(0.7);
    let right = answer(folder.path(), &["--no-cache", "run", "own.toml", "--out", "-"]);
    let limited = |arguments: &str| {
        let program = env!("CARGO_BIN_EXE_machinist");
        let script = format!("trap '' XFSZ; ulimit -f 1; exec '{program}' {arguments}");
        let mut command = Command::new("sh");
        command.args(["-c", &script]).current_dir(folder.path()).env("NO_COLOR", "1");
        command.env("MACHINIST_CACHE", folder.path().join("cache"));
        command.output().expect("a shell")
    };
    let entries = || fs::read_dir(folder.path().join("cache")).map_or(0, Iterator::count);
    let output = limited("run own.toml --out -");
    assert_eq!(succeeded(&output), right);
    assert!(String::from_utf8_lossy(&output.stderr).contains("not cached"));
    assert_eq!(entries(), 0);
    for arguments in
        ["compile own.toml --out own.model", "run own.toml --points 2000 --out own.csv"]
    {
        let output = limited(arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{arguments}: {said}");
        assert!(said.contains("own."), "{said}");
    }
    let names: Vec<_> = fs::read_dir(folder.path()).expect("a folder").collect();
    let names = names.into_iter().map(|entry| entry.expect("an entry").file_name());
    let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, ["cache", "own.toml"], "{names:?}");
}

#[test]
fn damaged_entries_are_derived_again() {
    let folder = folder_with(0.7);
    let right = answer(folder.path(), &RUN);
    let entries = || {
        let files = fs::read_dir(folder.path().join("cache")).expect("a cache");
        files.map(|file| file.expect("an entry").path()).collect::<Vec<_>>()
    };
    let [entry] = entries().try_into().expect("one entry");
    let whole = fs::read(&entry).expect("an entry");
    for damaged in [&whole[..whole.len() / 2], &[], b"nothing of the kind"] {
        fs::write(&entry, damaged).expect("an entry");
        assert_eq!(answer(folder.path(), &RUN), right);
        assert_eq!(fs::read(&entry).expect("an entry"), whole, "it is whole again");
    }
}

#[test]
fn a_cache_that_cannot_be_is_done_without() {
    let folder = folder_with(0.7);
    let right = answer(folder.path(), &["--no-cache", "run", "own.toml", "--out", "-"]);
    assert!(!folder.path().join("cache").exists());
    // A file stands where the folder should be.
    fs::write(folder.path().join("cache"), "in the way").expect("a file");
    let output = machinist(folder.path(), &RUN).output().expect("the program starts");
    assert!(String::from_utf8_lossy(&output.stderr).contains("not cached"));
    assert_eq!(succeeded(&output), right);
}

#[test]
fn processes_at_once_get_the_same_and_fill_one_entry() {
    for run in [&RUN[..], &OTHER] {
        at_once(run);
    }
}

/// Starts four processes at once, which must agree. With Symbolica, each takes the lock from one
/// that is ending.
fn at_once(run: &[&str]) {
    let folder = folder_with(0.7);
    let start = || {
        let mut command = machinist(folder.path(), run);
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts")
    };
    let children: Vec<Child> = (0..4).map(|_| start()).collect();
    let outputs = children.into_iter().map(|child| child.wait_with_output().expect("it ends"));
    let answers: Vec<String> = outputs.map(|output| succeeded(&output)).collect();
    assert!(answers.iter().all(|answer| *answer == answers[0]));
    assert!(answer(folder.path(), &["cache"]).contains(" 1 entries"));
}

#[test]
fn nobody_waits_for_a_simulation_of_somebody_else() {
    let long = folder_with(0.7);
    let arguments = ["run", "own.toml", "--until", "1e9", "--rtol", "1e-12", "--points", "2"];
    let mut simulates = machinist(long.path(), &arguments);
    simulates.env("MACHINIST_ALGEBRA", "symbolica");
    let simulates = simulates.stdout(Stdio::null()).stderr(Stdio::null()).spawn();
    let mut simulates = simulates.expect("the program starts");
    // Once its entry exists, it has finished deriving.
    let begin = Instant::now();
    while fs::read_dir(long.path().join("cache")).map_or(0, Iterator::count) == 0 {
        assert!(begin.elapsed() < Duration::from_secs(60), "it derives");
        std::thread::sleep(Duration::from_millis(10));
    }
    let other = folder_with(0.9);
    let output = machinist(other.path(), &OTHER).output().expect("the program starts");
    let is_running = simulates.try_wait().expect("it is there").is_none();
    simulates.kill().expect("it is there");
    simulates.wait().expect("it ends");
    assert!(is_running, "it simulated all the time");
    succeeded(&output);
}

/// Potential of many factors, whose derivatives take minutes.
fn heavy() -> String {
    use std::fmt::Write as _;
    let coordinates = (0..8).fold(String::new(), |mut text, k| {
        let _ = writeln!(text, "[define.bob.coordinates.q{k}]\nunit = \"1\"");
        text
    });
    let squares: Vec<String> = (0..8).map(|k| format!("q{k}_dot^2")).collect();
    let factor = |row: usize| {
        let sum: Vec<String> = (0..8).map(|k| format!("{row}*q{k}")).collect();
        format!("({} + q{}^2 + 1)", sum.join(" + "), row % 8)
    };
    let factors: Vec<String> = (1..21).map(factor).collect();
    let (squares, factors) = (squares.join(" + "), factors.join("*"));
    format!(
        "[scene]\nname = \"heavy\"\n[units.bob]\nunit = \"bob\"\n[run]\nuntil = 0.001\n\
         {coordinates}[define.bob.parameters]\nm = {{ value = 1, unit = \"kg m^2\" }}\n\
         [define.bob.energy]\nkinetic = \"m*({squares})/2\"\n\
         potential = \"1e-20 [J]*{factors}\"\n"
    )
}

/// The child inherits its parent's standard error, which closes only after both have ended.
#[test]
fn a_parent_that_is_killed_takes_the_process_that_derives_with_it() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("heavy.toml"), heavy()).expect("a spec");
    let mut parent = machinist(folder.path(), &["derive", "heavy.toml", "--algebra", "symbolica"]);
    let parent = parent.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let mut parent = parent.expect("the program starts");
    #[cfg(target_os = "linux")]
    {
        let children = format!("/proc/{0}/task/{0}/children", parent.id());
        let begin = Instant::now();
        while fs::read_to_string(&children).is_ok_and(|children| children.is_empty()) {
            assert!(begin.elapsed() < Duration::from_secs(60), "it has a child");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
    std::thread::sleep(Duration::from_secs(1));
    let mut errors = parent.stderr.take().expect("it is piped");
    assert!(parent.try_wait().expect("it is there").is_none(), "it still derives");
    parent.kill().expect("it is there");
    parent.wait().expect("it ends");
    let (ended, end) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let mut said = String::new();
        let _ = std::io::Read::read_to_string(&mut errors, &mut said);
        ended.send(said)
    });
    let said = end.recv_timeout(Duration::from_secs(20));
    let said = said.expect("the child has ended");
    let is_known = |line: &str| line.starts_with("machinist: ");
    assert!(said.lines().all(is_known), "it said no more than whom it waits for: {said}");
}

#[test]
fn a_model_of_another_kind_or_version_is_refused_by_name() {
    let folder = folder_with(0.7);
    let file = folder.path().join("own.model");
    answer(folder.path(), &["compile", "own.toml", "--out", "own.model"]);
    let whole = fs::read(&file).expect("a model");
    let mut older = whole.clone();
    older[16] = 77;
    let mut altered = whole.clone();
    *altered.last_mut().expect("it is not empty") ^= 1;
    for (bytes, words) in [
        (older.as_slice(), "has version 77"),
        (altered.as_slice(), "has been altered"),
        (&whole[..100], "cut off"),
    ] {
        fs::write(&file, bytes).expect("a file");
        let output = machinist(folder.path(), &["run", "own.model"]).output();
        let output = output.expect("the program starts");
        let said = String::from_utf8_lossy(&output.stderr).replace('│', " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(words) && output.stdout.is_empty(), "{said}");
    }
}

//! Page that follows the files of a machine: its events and content, refused requests, and its end.

use std::fs;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::process::{assert_refused, machinist};

/// Time limit on a computer with much other work.
const PATIENCE: Duration = Duration::from_secs(120);

/// Mass on a spring.
const SPEC: &str = r#"[scene]
name = "bouncer"
title = "Mass on a spring"
[define.body.coordinates]
x = { unit = "m", velocity = "v" }
[define.body.parameters]
mass = { value = 2.0, unit = "kg" }
stiffness = { value = 300.0, unit = "N/m" }
push = { value = 3.0, unit = "N" }
[define.body.energy]
kinetic = "mass*v^2/2"
potential = "stiffness*x^2/2"
[[define.body.forces]]
coordinate = "x"
expression = "push*sin(4 [rad/s]*t)"
[units.body]
unit = "body"
[outputs]
x = "body.x"
[run]
until = 2.0
points = 21
method = "dop853"
"#;

/// Running program, and events of its page.
struct Watching {
    child: Child,
    address: String,
    events: Receiver<Value>,
}

impl Watching {
    fn start(folder: &Path, arguments: &[&str]) -> Self {
        let arguments = [&["watch"], arguments].concat();
        let mut command = machinist(folder, &arguments);
        let mut child = command
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let out = child.stdout.take().expect("standard output");
        BufReader::new(out).read_line(&mut line).expect("a line");
        let address = line.split("http://").nth(1).and_then(|rest| rest.split('/').next());
        let address = address.unwrap_or_else(|| panic!("no address: {line}")).to_owned();
        let events = events(&address);
        Self { child, address, events }
    }

    /// Waits for the next event with a state.
    fn next(&self, state: &str) -> Value {
        next(&self.events, state)
    }

    fn content(&self) -> Value {
        let (status, body) = get(&self.address, "/content", &self.address);
        assert_eq!(status, 200);
        serde_json::from_str(&body).expect("JSON")
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn next(events: &Receiver<Value>, state: &str) -> Value {
    loop {
        let event = events.recv_timeout(PATIENCE).expect("an event");
        if event["state"] == state {
            return event;
        }
    }
}

/// Requests a path of a server under a name of its host.
fn asked(address: &str, request: &str, host: &str) -> TcpStream {
    let mut stream = TcpStream::connect(address).expect("a server");
    // In HTTP 1.0 the body comes in one piece.
    write!(stream, "{request} HTTP/1.0\r\nHost: {host}\r\n\r\n").expect("sent");
    stream
}

fn answer(mut stream: TcpStream) -> (u16, String) {
    let mut text = String::new();
    stream.read_to_string(&mut text).expect("text");
    let (head, body) = text.split_once("\r\n\r\n").expect("a head");
    let status = head.split(' ').nth(1).and_then(|code| code.parse().ok());
    (status.expect("a status"), body.to_owned())
}

fn get(address: &str, path: &str, host: &str) -> (u16, String) {
    answer(asked(address, &format!("GET {path}"), host))
}

/// Returns the events of a page as a browser gets them.
fn events(address: &str) -> Receiver<Value> {
    let stream = asked(address, "GET /events", address);
    let (sender, receiver) = channel();
    thread::spawn(move || {
        for line in BufReader::new(stream).lines().map_while(Result::ok) {
            if let Some(data) = line.strip_prefix("data: ") {
                let _ = sender.send(serde_json::from_str(data).expect("JSON"));
            }
        }
    });
    receiver
}

/// Saves like many editors: writes another file and renames it.
fn save(file: &Path, text: &str) {
    let other = file.with_extension("saved");
    fs::write(&other, text).expect("written");
    fs::rename(other, file).expect("renamed");
}

fn piece<'v>(content: &'v Value, id: &str) -> &'v str {
    let pieces = content["pieces"].as_array().expect("pieces");
    let found = pieces.iter().find(|piece| piece["id"] == id);
    found.and_then(|piece| piece["html"].as_str()).unwrap_or_else(|| panic!("no piece {id}"))
}

#[test]
fn a_save_updates_the_page_and_a_mistake_stands_beside_the_last_good_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bouncer.toml");
    fs::write(&file, SPEC).expect("written");
    let watching = Watching::start(folder.path(), &["bouncer.toml"]);
    watching.next("ready");
    let (status, page) = get(&watching.address, "/", &watching.address);
    assert_eq!(status, 200);
    for part in
        ["<title>Mass on a spring", "class=\"chart\"", "<math", "id=\"live\"", "connect-src"]
    {
        assert!(page.contains(part), "the page lacks {part}");
    }
    let first = watching.content();
    // Another value gives another run.
    save(&file, &SPEC.replace("300.0", "900.0"));
    watching.next("working");
    watching.next("ready");
    let second = watching.content();
    assert_ne!(piece(&first, "run"), piece(&second, "run"));
    assert!(piece(&second, "parameters").contains(">900<"));
    assert!(second["known"].as_str().is_some_and(|known| known.contains("\"value\":900.0")));
    // An error is shown with its place, and the last run stays.
    let wrong = SPEC.replace("stiffness*x^2/2", "stifness*x^2/2");
    let line = wrong.lines().position(|line| line.contains("stifness")).expect("a line") + 1;
    fs::write(&file, &wrong).expect("written");
    let event = watching.next("failed");
    assert_eq!(event["troubles"][0]["line"], line, "{event}");
    assert_eq!(event["troubles"][0]["column"], 14, "{event}");
    assert!(event["troubles"][0]["file"].as_str().is_some_and(|f| f.ends_with("bouncer.toml")));
    let beside = watching.content();
    let told = beside["troubles"].as_str().expect("HTML");
    for words in [&format!("bouncer.toml:{line}:14"), "stifness*x^2/2", "did you mean"] {
        assert!(told.contains(words), "{words} is not said: {told}");
    }
    assert_eq!(piece(&beside, "run"), piece(&second, "run"));
    // The same holds for invalid TOML, and for a run that stops.
    save(&file, &SPEC.replace("[scene]", "[scene"));
    assert_eq!(watching.next("failed")["troubles"][0]["line"], 1);
    save(&file, &SPEC.replace("push*sin(4 [rad/s]*t)", "push/(1 - t/(1 [s]))"));
    let event = watching.next("failed");
    assert!(
        event["troubles"][0]["message"].as_str().is_some_and(|m| m.contains("stopped")),
        "{event}"
    );
    assert_eq!(piece(&watching.content(), "run"), piece(&second, "run"));
    save(&file, SPEC);
    let event = watching.next("ready");
    assert_eq!(event["troubles"].as_array().map(Vec::len), Some(0));
    assert_eq!(piece(&watching.content(), "parameters"), piece(&first, "parameters"));
    // Parts that take longer follow after the run.
    while watching.content()["is_complete"] != true {
        watching.next("ready");
    }
    assert!(piece(&watching.content(), "checks").contains("energy"));
}

#[test]
fn a_spec_that_is_wrong_from_the_start_is_shown_once_it_is_mended() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bouncer.toml");
    let used = SPEC.replace("[units.body]\nunit = \"body\"", "[units.body]\nunit = \"block\"");
    fs::write(&file, used).expect("written");
    let watching = Watching::start(folder.path(), &["bouncer.toml"]);
    let event = watching.next("failed");
    assert!(
        event["troubles"][0]["message"].as_str().is_some_and(|m| m.contains("block")),
        "{event}"
    );
    let (_, page) = get(&watching.address, "/", &watching.address);
    assert!(page.contains("<title>bouncer.toml: Machinist</title>") && page.contains("block"));
    // The unit that the scene names is created, first with an error, then without.
    let unit = "[unit]\nname = \"block\"\n[coordinates]\nx = { unit = \"m\", velocity = \"v\" }\n\
                [parameters]\nmass = { value = 2.0, unit = \"kg\" }\n[energy]\nkinetic = \"mass*v^2/2\"\n";
    fs::write(folder.path().join("block.toml"), unit.replace("v^2/2", "v^2/")).expect("written");
    let event = loop {
        // An error about a half-written file may come first.
        let event = watching.next("failed");
        if event["troubles"][0]["file"].as_str().is_some_and(|file| file.ends_with("block.toml")) {
            break event;
        }
    };
    assert_eq!(event["troubles"][0]["line"], 8, "{event}");
    fs::write(folder.path().join("block.toml"), unit).expect("written");
    watching.next("ready");
    assert!(piece(&watching.content(), "parameters").contains("body.mass"));
    // The unit is watched like the scene.
    save(&folder.path().join("block.toml"), &unit.replace("2.0", "5.5"));
    watching.next("working");
    watching.next("ready");
    assert!(piece(&watching.content(), "parameters").contains("5.5"));
}

#[test]
fn two_browsers_are_told_of_tables_and_others_than_this_machine_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("data")).expect("a folder");
    let table = folder.path().join("data/push.csv");
    fs::write(&table, "time [s],force [N]\n0,0\n1,2\n2,0\n").expect("written");
    let pushed = r#"expression = 'push + table("data/push.csv", "force", t, "linear")'"#;
    let spec = SPEC.replace("expression = \"push*sin(4 [rad/s]*t)\"", pushed);
    fs::write(folder.path().join("bouncer.toml"), spec).expect("written");
    let watching = Watching::start(folder.path(), &["bouncer.toml"]);
    let address = &watching.address;
    let others = events(address);
    watching.next("ready");
    let first = piece(&watching.content(), "run").to_owned();
    next(&others, "ready");
    save(&table, "time [s],force [N]\n0,0\n1,7\n2,0\n");
    watching.next("working");
    next(&others, "working");
    watching.next("ready");
    next(&others, "ready");
    assert_ne!(piece(&watching.content(), "run"), first);
    // Another host name comes from a domain that was made to point here.
    for host in ["example.org", "127.0.0.1", "localhost:1", "127.0.0.1.example.org", ""] {
        for path in ["/", "/content", "/events"] {
            assert_eq!(get(address, path, host).0, 403, "{host} {path}");
        }
    }
    let port = address.rsplit(':').next().expect("a port");
    assert_eq!(get(address, "/content", &format!("localhost:{port}")).0, 200);
    for path in ["/bouncer.toml", "/../bouncer.toml", "/data/push.csv", "//", "/content?x=1"] {
        assert_eq!(get(address, path, address).0, 404, "{path}");
    }
    for method in ["POST", "PUT", "HEAD", "OPTIONS"] {
        assert_eq!(answer(asked(address, &format!("{method} /"), address)).0, 405, "{method}");
    }
}

/// Returns a scene whose run takes longer than any test.
fn endless() -> String {
    SPEC.replace("until = 2.0", "until = 1e9").replace("dop853", "tsit5")
}

#[test]
fn a_run_under_way_is_given_up_when_its_file_is_saved_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bouncer.toml");
    fs::write(&file, endless()).expect("written");
    let watching = Watching::start(folder.path(), &["bouncer.toml", "--time-limit", "3600"]);
    watching.next("working");
    thread::sleep(Duration::from_millis(500));
    save(&file, SPEC);
    watching.next("ready");
}

/// Returns the running child processes of a process.
#[cfg(target_os = "linux")]
fn children(process: &Child) -> Vec<String> {
    let id = process.id();
    let tasks = fs::read_dir(format!("/proc/{id}/task")).expect("it runs");
    let of_task = |task: std::io::Result<fs::DirEntry>| {
        let children = task.expect("a task").path().join("children");
        fs::read_to_string(children).unwrap_or_default()
    };
    let all: String = tasks.map(of_task).collect();
    all.split_whitespace().map(str::to_owned).collect()
}

#[test]
#[cfg(target_os = "linux")]
fn an_interrupt_ends_it_at_once_with_the_process_that_runs_the_machine() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("bouncer.toml"), endless()).expect("written");
    let mut watching = Watching::start(folder.path(), &["bouncer.toml", "--time-limit", "3600"]);
    watching.next("working");
    let begun = Instant::now();
    let children = loop {
        let children = children(&watching.child);
        if !children.is_empty() || begun.elapsed() > PATIENCE {
            break children;
        }
        thread::sleep(Duration::from_millis(5));
    };
    assert_eq!(children.len(), 1);
    let sent = std::process::Command::new("kill")
        .args(["-INT", &watching.child.id().to_string()])
        .status();
    assert!(sent.expect("a signal").success());
    assert_eq!(watching.child.wait().expect("an end").code(), Some(130));
    // The child notices the end of its parent by its standard input.
    let begun = Instant::now();
    let stat = format!("/proc/{}/stat", children[0]);
    let is_alive = || fs::read_to_string(&stat).is_ok_and(|stat| !stat.contains(") Z "));
    while is_alive() {
        assert!(begun.elapsed() < PATIENCE, "it goes on");
        thread::sleep(Duration::from_millis(5));
    }
}

/// Returns the memory of a process \[kB\].
#[cfg(target_os = "linux")]
fn resident(process: &Child) -> u64 {
    let status = fs::read_to_string(format!("/proc/{}/status", process.id())).expect("it runs");
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:")).expect("a size");
    line.trim().trim_end_matches(" kB").parse().expect("a number")
}

#[test]
#[cfg(target_os = "linux")]
fn saves_leave_nothing_behind_in_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("bouncer.toml");
    fs::write(&file, SPEC).expect("written");
    let watching = Watching::start(folder.path(), &["bouncer.toml"]);
    watching.next("ready");
    let cycle = |k: usize| {
        save(&file, &SPEC.replace("300.0", &format!("30{k}.5")));
        watching.next("working");
        watching.next("ready");
        watching.content();
        save(&file, &SPEC.replace("kinetic", &format!("kinetics{k}")));
        watching.next("failed");
        watching.content();
    };
    (0..5).for_each(cycle);
    let before = resident(&watching.child);
    (5..15).for_each(cycle);
    let after = resident(&watching.child);
    assert!(after < before + 4096, "{before} kB before and {after} kB after");
}

#[test]
fn what_cannot_be_watched_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let refused = |arguments: &[&str], words: &[&str]| {
        assert_refused(machinist(folder.path(), arguments), words);
    };
    refused(&["watch", "nothing.toml"], &["there is no such file", "machinist new"]);
    refused(&["watch", "saw_gin"], &["built-in", "give a scene file"]);
    refused(&["watch", "x.toml", "--port", "0"], &["--port"]);
    let taken = std::net::TcpListener::bind(("127.0.0.1", 0)).expect("a port");
    let port = taken.local_addr().expect("an address").port().to_string();
    fs::write(folder.path().join("bouncer.toml"), SPEC).expect("written");
    let output = machinist(folder.path(), &["watch", "bouncer.toml", "--port", &port]).output();
    let output = output.expect("an end");
    assert_eq!(output.status.code(), Some(1));
    assert!(crate::process::said(&output).contains("without `--port`"));
}

//! Live pages in a browser, if there is one: a slider has the same effect as `run --set`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cli::{answer, text};

/// Names under which a headless browser may be found.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// Sets a number as if typed, waits for the run, and returns the final values in the table.
/// `PARAMETER` and `VALUE` are replaced.
const TYPED: &str = r#"<script>
addEventListener("load", async () => {
  const pause = () => new Promise((resolve) => setTimeout(resolve, 20));
  while (document.getElementById("live").hidden) await pause();
  const sliders = [...document.querySelectorAll(".slider")];
  const named = sliders.find((slider) => slider.querySelector("label code").textContent === "PARAMETER");
  const number = named.querySelector("input[type=number]");
  number.value = "VALUE";
  number.dispatchEvent(new Event("input"));
  const state = document.getElementById("live-state");
  while (!state.textContent) await pause();
  const rows = [...document.querySelectorAll("tr[data-output]")];
  const found = rows.map((row) => `${row.dataset.output}=${row.querySelectorAll(".number")[1].title}`);
  document.body.dataset.found = `${found.join(" ")} ${state.className}`;
});
</script></body>"#;

/// Machine, page, parameter and another value for it: events with `dop853`, constraints, and a
/// machine that becomes stiff.
const MOVES: [(&str, &str, &str, &str); 5] = [
    ("specs/scenes/drives/winch.toml", "winch", "gear.ratio", "31.7"),
    ("specs/scenes/slider_crank.toml", "slider_crank", "crank.length", "0.07"),
    (
        "specs/scenes/parts/electrical/amplifier.toml",
        "electrical_amplifier",
        "motor.resistance",
        "0.7",
    ),
    ("STEADY", "steady", "body.stiffness", "80"),
    ("STEADY", "steady", "body.drag", "0.7"),
];

/// Mass on a stiffening spring, and a rotor at constant speed, both in equilibrium until changed.
const STEADY: &str = r#"
[scene]
name = "steady"
[define.body.coordinates]
x = { unit = "m", velocity = "v" }
turn = { unit = "rad", velocity = "omega" }
[define.body.parameters]
mass = { value = 2.0, unit = "kg" }
gravity = { value = 9.81, unit = "m/s^2" }
stiffness = { value = 300.0, unit = "N/m" }
cubic = { value = 4e4, unit = "N/m^3" }
damping = { value = 0.5, unit = "N s/m" }
inertia = { value = 0.3, unit = "kg m^2" }
torque = { value = 4.0, unit = "N m" }
drag = { value = 0.2, unit = "N m s/rad" }
push = { value = 3.0, unit = "N" }
pace = { value = 4.0, unit = "rad/s" }
[define.body.energy]
kinetic = "mass*v^2/2 + inertia*omega^2/2"
potential = "stiffness*x^2/2 + cubic*x^4/4 + mass*gravity*x"
dissipation = "damping*v^2/2 + drag*omega^2/2"
[[define.body.forces]]
coordinate = "turn"
expression = "torque*cos(pace*t)"
[[define.body.forces]]
coordinate = "x"
expression = "push*sin(pace*t)"
[units.body]
unit = "body"
[initial]
from = "equilibrium"
"body.turn" = 0.4
[outputs]
x = "body.x"
turn = "body.turn"
speed = "body.omega"
[run]
until = 2.0
points = 201
rtol = 1e-10
method = "dop853"
"#;

#[test]
fn a_run_in_the_page_ends_where_a_run_outside_of_it_does() {
    let Some(browser) = browser() else {
        eprintln!("no browser among {BROWSERS:?}: live pages are not looked at");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let steady = folder.path().join("steady.toml");
    fs::write(&steady, STEADY).expect("written");
    for (scene, name, parameter, value) in MOVES {
        let scene = if scene == "STEADY" { text(&steady) } else { scene };
        answer(&["report", scene, "--no-times", "--out", text(folder.path())]);
        let page = folder.path().join(format!("machines/{name}.html"));
        let typed = TYPED.replace("PARAMETER", parameter).replace("VALUE", value);
        let html = fs::read_to_string(&page).expect("a page").replace("</body>", &typed);
        fs::write(&page, html).expect("written");
        let found = found(&browser, &page, folder.path(), &[]);
        assert!(found.ends_with(" muted"), "{scene} says that something is wrong: {found}");
        let file = folder.path().join("run.csv");
        let set = format!("{parameter}={value}");
        answer(&["run", scene, "--set", &set, "--out", text(&file)]);
        let ends = ends(&file);
        let pairs: Vec<_> = found.split(' ').filter_map(|pair| pair.split_once('=')).collect();
        assert!(!pairs.is_empty(), "{scene} shows nothing");
        for (output, of_page) in pairs {
            let of_page: f64 = of_page.parse().expect("a number");
            let (_, expected, largest) =
                ends.iter().find(|(name, ..)| name == output).expect("a column");
            let error = (of_page - expected).abs() / largest;
            assert!(error < 1e-6, "{scene}: {output} ends at {of_page}, not at {expected}");
        }
    }
}

pub fn browser() -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    let folders: Vec<PathBuf> = std::env::split_paths(&folders).collect();
    let places = BROWSERS.iter().flat_map(|name| folders.iter().map(move |at| at.join(name)));
    places.into_iter().find(|place| place.is_file())
}

/// Returns the text that the script has left in the page.
pub fn found(browser: &Path, page: &Path, folder: &Path, options: &[&str]) -> String {
    let mut command = Command::new(browser);
    command
        .args(["--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic"])
        .args(["--no-first-run", "--disable-background-networking", "--virtual-time-budget=20000"])
        .arg(format!("--user-data-dir={}", folder.join("browser").display()))
        .args(options)
        .arg("--dump-dom")
        .arg(format!("file://{}", page.display()));
    let output = command.output().expect("the browser starts");
    let dom = String::from_utf8_lossy(&output.stdout);
    let found = dom.split("data-found=\"").nth(1).and_then(|rest| rest.split('"').next());
    found.unwrap_or_else(|| panic!("no run in {}: {dom:.2000}", page.display())).to_owned()
}

/// Returns the outputs of a run with their last and their largest values.
fn ends(file: &Path) -> Vec<(String, f64, f64)> {
    let mut reader = csv::Reader::from_path(file).expect("a file");
    let names: Vec<String> = reader.headers().expect("names").iter().map(str::to_owned).collect();
    let rows: Vec<Vec<f64>> = reader
        .records()
        .map(|row| row.expect("a row").iter().map(|v| v.parse().expect("a number")).collect())
        .collect();
    let column = |index: usize| rows.iter().map(move |row| row[index]);
    (1..names.len())
        .map(|index| {
            let largest = column(index).fold(0.0, |most: f64, value| most.max(value.abs()));
            let name = names[index].split([' ', '[']).next().unwrap_or_default().to_owned();
            (name, column(index).next_back().expect("an end"), largest.max(f64::MIN_POSITIVE))
        })
        .collect()
}

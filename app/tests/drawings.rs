//! Drawings in space in Node and in a browser, if there are any: elements lie where the engine places
//! them, and keys, sliders and the time of the run change the picture without an error.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use machinist::Simulation;
use machinist_app::HeadlessDrawing;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::ModelSimulator;

use crate::cli::{answer, text};
use crate::live::{browser, found};
use crate::process::REPOSITORY;

/// Prints the numbers of all elements, at the times of the stored run, one line for each.
const PLACES: &str = r#"
Places.of(JSON.parse(require("fs").readFileSync(process.argv[2], "utf8"))).then((places) => {
  places.begin(places.stored);
  for (const time of places.stored.times) {
    const placed = places.at(places.stored, time);
    console.log(JSON.stringify(placed.flatMap(({ of }) => of.flat())));
  }
});
"#;

/// Collects errors, then changes time, view and a parameter; leaves what each did to the picture.
const SHAKEN: &str = r##"<script>
const wrong = [];
addEventListener("error", (event) => wrong.push(event.message));
addEventListener("unhandledrejection", (event) => wrong.push(String(event.reason)));
addEventListener("load", async () => {
  const pause = (time = 20) => new Promise((resolve) => setTimeout(resolve, time));
  while (document.querySelector(".space").hidden) await pause();
  const canvas = document.querySelector(".space canvas");
  await pause(100);
  const [told, seen] = [[], new Set()];
  const look = (what) => {
    const picture = canvas.toDataURL();
    told.push(`${what}:${seen.has(picture) ? "same" : "new"}`);
    seen.add(picture);
  };
  look("start");
  const time = document.querySelector("#live-motion .player input");
  time.value = 400;
  time.dispatchEvent(new Event("input"));
  await pause();
  look("time");
  for (const key of ["ArrowLeft", "ArrowUp", "+", "0"]) {
    canvas.dispatchEvent(new KeyboardEvent("keydown", { key, cancelable: true }));
    look(key);
  }
  for (const button of document.querySelectorAll(".space button")) {
    button.click();
    look(button.textContent);
  }
  const sliders = [...document.querySelectorAll(".slider")];
  const named = sliders.find((slider) => slider.querySelector("label code").textContent === "PARAMETER");
  if (named) {
    const number = named.querySelector("input[type=number]");
    number.value = "VALUE";
    number.dispatchEvent(new Event("input"));
    const state = document.getElementById("live-state");
    while (!state.textContent) await pause();
    await pause(100);
    look("slider");
  }
  const fits = document.querySelector("#live-motion").getBoundingClientRect().right <= innerWidth;
  document.body.dataset.found = `${told.join(" ")} ${fits ? "fits" : "wide"} ${wrong.join(";") || "fine"}`;
});
</script></body>"##;

/// Scene, page, and a parameter with another value; none where the machine does not run in the page.
const MACHINES: [(&str, &str, &str, &str); 3] = [
    ("msl/spatial_double_pendulum", "msl_spatial_double_pendulum", "bar1.length", "0.8"),
    ("parts/spatial/rod", "spatial_rod", "crank.length", "0.25"),
    ("rolling/rattleback", "rattleback", "", ""),
];

fn scene(name: &str) -> PathBuf {
    Path::new(REPOSITORY).join(format!("specs/scenes/{name}.toml"))
}

#[test]
fn elements_lie_in_the_page_where_the_engine_places_them() {
    let folders = std::env::var_os("PATH").expect("a path");
    let places = std::env::split_paths(&folders).map(|at| at.join("node"));
    let Some(node) = { places }.find(|place| place.is_file()) else {
        eprintln!("skipped: there is no node to run the scripts of live pages");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    for name in [
        "msl/spatial_gyroscope",
        "msl/spatial_four_bar",
        "iftomm/flyball_governor",
        "rolling/bicycle",
        "rolling/rattleback",
        "parts/spatial/bevel_gear",
        "parts/spatial/motion",
    ] {
        let model = pipeline::generate(&scene(name), Keep::Needed);
        let mut model = model.unwrap_or_else(|errors| panic!("{}", errors.render()));
        model.run.points = 21;
        let scene = ModelSimulator::new(model.clone());
        let run =
            Simulation::new(scene.single()).run().unwrap_or_else(|why| panic!("{name}: {why}"));
        let drawing = HeadlessDrawing::of(&model, &run).expect("a drawing");
        let [script, data] = ["places.js", "data.json"].map(|file| folder.path().join(file));
        fs::write(&script, format!("\"use strict\";\n{}{PLACES}", drawing.scripts))
            .expect("written");
        fs::write(&data, drawing.known).expect("written");
        let output = Command::new(&node).args([&script, &data]).output().expect("node runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {said}");
        let of_page: Vec<Vec<f64>> = String::from_utf8_lossy(&output.stdout)
            .lines()
            .map(|line| serde_json::from_str(line).expect("numbers"))
            .collect();
        assert_eq!(of_page.len(), run.times.len(), "{name}");
        let parameters: Vec<f64> = model.parameters.iter().map(|known| known.value).collect();
        for (at, placed) in of_page.iter().enumerate() {
            // As the page stores them.
            let single = |value: f64| f64::from(value as f32);
            let states = run.columns[..model.states.len()].iter();
            let state: Vec<f64> = states.map(|column| single(column.values[at])).collect();
            let drawing = model.drawing.as_ref().expect("a drawing");
            let expected = drawing.placed(single(run.times[at]), &state, &parameters, &model);
            assert_eq!(placed.len(), expected.len(), "{name}");
            for (placed, expected) in placed.iter().zip(expected) {
                let off = (placed - expected).abs();
                assert!(off <= 1e-12 * (1.0 + expected.abs()), "{name}: {placed} not {expected}");
            }
        }
    }
}

#[test]
fn a_drawing_in_space_moves_turns_and_follows_sliders_without_an_error() {
    let Some(browser) = browser() else {
        eprintln!("skipped: there is no browser to look at drawings");
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    for (name, file, parameter, value) in MACHINES {
        answer(&["report", text(&scene(name)), "--no-times", "--out", text(folder.path())]);
        let page = folder.path().join(format!("machines/{file}.html"));
        let html = fs::read_to_string(&page).expect("a page");
        assert!(html.len() < 1_500_000, "{name} takes {} bytes", html.len());
        assert!(!html.contains("src=\"http") && !html.contains("href=\"http://"), "{name}");
        let shaken = SHAKEN.replace("PARAMETER", parameter).replace("VALUE", value);
        let (front, _) = html.rsplit_once("</body>").expect("the end of the page");
        fs::write(&page, format!("{front}{shaken}</html>")).expect("written");
        for width in ["500,900", "1280,900"] {
            let size = format!("--window-size={width}");
            let found = found(&browser, &page, folder.path(), &[&size]);
            let slider = if parameter.is_empty() { "" } else { " slider:new" };
            let expected = format!(
                "start:new time:new ArrowLeft:new ArrowUp:new +:new 0:same Names:new \
                 Parallel projection:new Reset view:same{slider} fits fine"
            );
            assert_eq!(found, expected, "{name} at {width}");
        }
    }
}

#[test]
fn machines_in_a_plane_have_no_drawing_in_space() {
    let folder = tempfile::tempdir().expect("a folder");
    answer(&["report", text(&scene("slider_crank")), "--no-times", "--out", text(folder.path())]);
    let html =
        fs::read_to_string(folder.path().join("machines/slider_crank.html")).expect("a page");
    assert!(!html.contains("<figure class=\"space\"") && html.contains("<figure class=\"plane\""));
}

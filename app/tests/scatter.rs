//! `machinist scatter` as seen by users: closed forms, tables, refusals, interrupts.

use std::fs;
use std::path::Path;
use std::process::Output;

use serde_json::Value;

use crate::process;

/// A mass that runs into a spring: peak force v sqrt(k m), peak travel v sqrt(m/k).
const BUFFER: &str = r#"
[scene]
name = "buffer"

[units.mass]
unit = "translational/mass"
parameters = { mass = "2000 +- 100 [kg]" }

[units.spring]
unit = "translational/spring_damper"
parameters = { stiffness = 5e5, damping = 0 }

[units.wall]
unit = "translational/fixed"

[[joints]]
connect = ["mass.b", "spring.a"]

[[joints]]
connect = ["spring.b", "wall.a"]

[parameters.speed]
value = 3.6
unit = "km/h"
distribution = "lognormal"
relative_deviation = "5 %"

[scatter]
spring.stiffness = "lognormal(10 %)"
"mass.mass" = "lognormal(2000, 300)"

[initial]
"mass.v" = "speed"

[outputs]
force = "spring.force"
x = "mass.x"

[run]
until = 0.15
points = 151
rtol = 1e-9
"#;

fn scatter(folder: &Path, arguments: &[&str]) -> Output {
    let arguments = [&["scatter"], arguments].concat();
    process::output(process::machinist(folder, &arguments))
}

fn folder_with(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("buffer.toml"), text).expect("written");
    folder
}

fn answer(folder: &Path, arguments: &[&str]) -> Value {
    let output = scatter(folder, &[arguments, &["--json"]].concat());
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn refusal(folder: &Path, arguments: &[&str]) -> String {
    let output = scatter(folder, arguments);
    let said = process::said(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty(), "{arguments:?}");
    said
}

#[test]
fn the_peak_force_at_a_buffer_has_the_distribution_of_its_closed_form() {
    let folder = folder_with(BUFFER);
    let arguments =
        ["buffer.toml", "--of", "max(abs(force))", "--limit", "max(abs(force)) < 38000 [N]"];
    let more = ["--indices", "--linear", "--morris", "20", "--samples", "1024"];
    let found = answer(folder.path(), &[&arguments[..], &more[..]].concat());
    // ln F = ln v + (ln k + ln m)/2 is normal.
    let log_variance = |relative: f64| (relative * relative).ln_1p();
    let parts = [log_variance(0.15) / 4.0, log_variance(0.1) / 4.0, log_variance(0.05)];
    let medians = [2000.0, 5e5, 1.0];
    let median = |k: usize| medians[k] * (-0.5 * log_variance([0.15, 0.1, 0.05][k])).exp();
    let variance: f64 = parts.iter().sum();
    let median = median(2) * (median(1) * median(0)).sqrt();
    let mean = median * (variance / 2.0).exp();
    let deviation = mean * variance.exp_m1().sqrt();
    let result = &found["results"][0];
    let close = |value: &Value, exact: f64, off: f64| {
        let value = value.as_f64().expect("a number");
        assert!((value / exact - 1.0).abs() < off, "{value}, {exact}");
    };
    close(&result["mean"]["value"], mean, 2e-3);
    close(&result["deviation"]["value"], deviation, 3e-2);
    close(&result["quantiles"][1]["value"], median, 3e-3);
    let z = 1.644_853_626_951_472_7;
    close(&result["quantiles"][2]["value"], median * (z * variance.sqrt()).exp(), 2e-2);
    let score = ((38e3_f64 / median).ln()) / variance.sqrt();
    let probability = machinist::scatter::normal_cdf(-score);
    let limit = &found["limits"][0]["probability"];
    assert!(limit["low"].as_f64() <= Some(probability), "{limit}, {probability}");
    assert!(limit["high"].as_f64() >= Some(probability), "{limit}, {probability}");
    // S_T of a product of independent factors, with e^parts - 1 as the variance of a factor.
    let names: Vec<_> = found["parameters"].as_array().expect("a list").iter().collect();
    for (k, name) in ["mass.mass", "spring.stiffness", "speed"].iter().enumerate() {
        let place = names.iter().position(|of| of["name"] == **name).expect("a parameter");
        let first = parts[k].exp_m1() / variance.exp_m1();
        let index = &result["indices"][place];
        assert_eq!(index["parameter"], **name);
        let total = 1.0 - (variance - parts[k]).exp_m1() / variance.exp_m1();
        for (index, exact) in [(&index["first"], first), (&index["total"], total)] {
            let off = index["value"].as_f64().expect("a number") - exact;
            assert!(off.abs() < 0.03, "{name}: {off}");
        }
        let linear = &found["linear"][0]["shares"][place];
        let exact = [0.15 * 0.15 / 4.0, 0.01 / 4.0, 0.0025];
        let share = exact[k] / exact.iter().sum::<f64>();
        close(&linear["share"], share, 1e-5);
    }
    close(&found["linear"][0]["deviation"], 31_622.776_6 * 0.010_625_f64.sqrt(), 1e-5);
    assert_eq!(found["screening"][0]["effects"].as_array().map(Vec::len), Some(3));
}

#[test]
fn the_command_line_replaces_the_distributions_of_a_scene_and_its_seed_repeats_them() {
    let folder = folder_with(BUFFER);
    let vary = ["buffer.toml", "--samples", "64", "--of", "mass.mass", "--vary"];
    let of = |text: &str, sampler: &str| {
        answer(folder.path(), &[&vary[..], &[text, "--sampler", sampler]].concat())
    };
    let found = of("mass.mass=uniform(1 [t], 3 [t])", "latin");
    let mean = found["results"][0]["mean"]["value"].as_f64().expect("a number");
    // 64 values in two intervals of 1000 kg have a deviation of their mean of 1000/sqrt(12)/8 kg.
    assert!((mean - 2000.0).abs() < 4.0 * 36.1, "{mean}");
    for sampler in ["sobol", "random", "latin"] {
        let text = "mass.mass=+- 10 %";
        assert_eq!(of(text, sampler), of(text, sampler), "{sampler}");
        let found = of(text, sampler);
        let least = found["results"][0]["least"].as_f64().expect("a number");
        let greatest = found["results"][0]["greatest"].as_f64().expect("a number");
        assert!(least >= 1800.0 && greatest <= 2200.0 && greatest > 2100.0, "{sampler}");
    }
}

#[test]
fn tables_hold_every_run_and_plots_hold_bands() {
    let folder = folder_with(BUFFER);
    for file in ["runs.csv", "runs.parquet"] {
        let arguments = ["buffer.toml", "--samples", "32", "--out", file, "--plot", "bands.svg"];
        let output = scatter(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    }
    let table = fs::read_to_string(folder.path().join("runs.csv")).expect("a table");
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 33);
    assert!(lines[0].starts_with("run,") && lines[0].contains("spring.stiffness"), "{}", lines[0]);
    assert!(fs::metadata(folder.path().join("runs.parquet")).expect("a file").len() > 1000);
    let plot = fs::read_to_string(folder.path().join("bands.svg")).expect("a plot");
    assert!(plot.contains("force, 95 %"), "the legend names the band");
}

#[test]
fn runs_that_stop_are_counted_and_named() {
    let folder = folder_with(BUFFER);
    let arguments = ["buffer.toml", "--samples", "64", "--vary", "mass.mass=uniform(-100, 2000)"];
    let output = scatter(folder.path(), &[&arguments[..], &["--of", "sqrt(mass.mass)"]].concat());
    let said = String::from_utf8_lossy(&output.stderr);
    let told = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("have no result"), "{said}");
    assert!(told.contains("runs have no result:") && told.contains("run "), "{told}");
}

#[test]
fn what_makes_no_sense_is_refused_before_any_run() {
    let folder = folder_with(BUFFER);
    let plain = folder.path();
    for (arguments, words) in [
        (vec!["--vary", "mass.mas=+-5%"], "mass.mass"),
        (vec!["--vary", "mass.mass=normal(1 [m])"], "this is in m"),
        (vec!["--vary", "mass.mass=normal(10, -1)"], "must not be negative"),
        (vec!["--vary", "mass.mass=gauss(1)"], "no distribution `gauss`"),
        (vec!["--vary", "mass.mass=uniform(1)"], "uniform(LOW, HIGH)"),
        (vec!["--vary", "mass.mass=normal(1e300, inf)"], "not a number"),
        (vec!["--vary", "mass.mass="], "not a distribution"),
        (vec!["--set", "mass.mass=3"], "has a distribution"),
        (vec!["--samples", "1"], "--samples 1"),
        (vec!["--samples", "99999999999"], "--samples"),
        (vec!["--sampler", "sobl"], "sobol"),
        (vec!["--confidence", "nan"], "--confidence"),
        (vec!["--quantiles", "0.5,1"], "--quantiles"),
        (vec!["--of", "force"], "changes over time"),
        (vec!["--limit", "max(force) < 3 [m]"], "[m]"),
        (vec!["--morris", "1"], "--morris"),
        (vec!["--until", "nan"], "until"),
        (vec!["--out", "x.txt"], "x.txt"),
    ] {
        let said = refusal(plain, &[&["buffer.toml"], &arguments[..]].concat());
        assert!(said.contains(words), "{arguments:?}: {said}");
    }
    let said = refusal(Path::new(process::REPOSITORY), &["two_mass"]);
    assert!(said.contains("no parameter of scene `two_mass` has a distribution"), "{said}");
}

#[test]
fn mistakes_in_the_distributions_of_a_scene_have_their_place_and_a_hint() {
    let cases = [
        ("distribution = \"lognormal\"", "distribution = \"lognormla\"", "lognormal"),
        ("relative_deviation = \"5 %\"", "", "lacks `deviation`"),
        ("relative_deviation = \"5 %\"", "low = 3", "does not belong"),
        ("relative_deviation = \"5 %\"", "deviation = \"1 [kg]\"", "this is in kg"),
        ("relative_deviation = \"5 %\"", "relative_deviation = \"1 [m]\"", "has no unit"),
        ("lognormal(10 %)", "lognormal(10 %, 3", "not a distribution"),
        ("lognormal(10 %)", "uniform(1, 2)", "is not between"),
        ("spring.stiffness =", "spring.stiff =", "spring.stiffness"),
        ("2000 +- 100 [kg]", "2000 +- x [kg]", "x"),
        (
            "[initial]",
            "[[correlations]]\nparameters = [\"speed\"]\ncoefficient = 0.5\n[initial]",
            "at least 2",
        ),
        (
            "[initial]",
            "[[correlations]]\nparameters = [\"speed\", \"mass.mas\"]\n\
            coefficient = 0.5\n[initial]",
            "has no distribution",
        ),
        (
            "[initial]",
            "[[correlations]]\nparameters = [\"speed\", \"mass.mass\"]\n\
            coefficient = 1.0\n[initial]",
            "not positive definite",
        ),
        (
            "[initial]",
            "[[correlations]]\nparameters = [\"speed\", \"mass.mass\"]\n\
            matrix = [[1, 0.5]]\n[initial]",
            "2 rows of 2",
        ),
    ];
    for (from, to, words) in cases {
        let text = BUFFER.replace(from, to);
        assert_ne!(text, BUFFER, "{from}");
        let folder = folder_with(&text);
        let said = refusal(folder.path(), &["buffer.toml"]);
        assert!(said.contains(words), "{to}: {said}");
        assert!(said.contains("buffer.toml:"), "{to}: {said}");
    }
}

#[test]
fn correlated_parameters_scatter_together_and_have_no_indices() {
    let block = "[[correlations]]\nparameters = [\"spring.stiffness\", \"mass.mass\"]\n\
                 coefficient = -0.9\n[initial]";
    let folder = folder_with(&BUFFER.replace("[initial]", block));
    let of = ["buffer.toml", "--of", "sqrt(spring.stiffness*mass.mass)/1 [N s/m]", "--linear"];
    let found = answer(folder.path(), &of);
    let linear = found["linear"][0]["deviation"].as_f64().expect("a number");
    // Relative variance (0.1^2 + 0.15^2 - 2 0.9 0.1 0.15)/4 to first order.
    let exact = 31_622.776_6 * (0.0325_f64 - 0.027).sqrt() / 2.0;
    assert!((linear / exact - 1.0).abs() < 1e-6, "{linear}, {exact}");
    let sampled = found["results"][0]["deviation"]["value"].as_f64().expect("a number");
    assert!((sampled / exact - 1.0).abs() < 0.05, "{sampled}, {exact}");
    let said = refusal(folder.path(), &["buffer.toml", "--indices"]);
    assert!(said.contains("correlated"), "{said}");
}

#[test]
fn a_scatter_resumes_from_its_table_also_with_more_samples() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("buffer.toml"), BUFFER).expect("the scene is written");
    let ask = ["buffer.toml", "--of", "max(force)", "--limit", "max(force) < 35 [kN]", "--json"];
    let with = |more: &[&str]| scatter(folder, &[&ask[..], more].concat());
    let of_file = |out: &str| fs::read(folder.join(out)).expect("a table");
    for more in [&[][..], &["--indices"]] {
        let (part, whole) = ("part.parquet", "whole.parquet");
        let run = |samples: &str, out: &str, resume: &[&str]| {
            with(&[&["--samples", samples, "--out", out], more, resume].concat())
        };
        assert!(run("64", part, &[]).status.success());
        let resumed = run("256", part, &["--resume"]);
        assert!(resumed.status.success(), "{}", String::from_utf8_lossy(&resumed.stderr));
        let fresh = run("256", whole, &[]);
        assert_eq!(resumed.stdout, fresh.stdout);
        assert_eq!(of_file(part), of_file(whole));
        // A file with all runs is taken as it is.
        let again = run("256", part, &["--resume"]);
        assert_eq!(again.stdout, fresh.stdout);
        let other = run("256", part, &["--resume", "--seed", "2"]);
        let said = String::from_utf8_lossy(&other.stderr);
        assert!(!other.status.success() && said.contains("other settings: seed"), "{said}");
        let other = run("256", part, &["--resume", "--vary", "speed=uniform(1, 2)"]);
        let said = String::from_utf8_lossy(&other.stderr);
        assert!(!other.status.success() && said.contains("other settings: parameters"), "{said}");
    }
    fs::write(folder.join("damaged.parquet"), "PAR1").expect("a file");
    let damaged = with(&["--out", "damaged.parquet", "--resume"]);
    assert!(String::from_utf8_lossy(&damaged.stderr).contains("--resume: damaged.parquet"));
    let csv = with(&["--out", "runs.csv", "--resume"]);
    assert!(String::from_utf8_lossy(&csv.stderr).contains("no .parquet file"));
}

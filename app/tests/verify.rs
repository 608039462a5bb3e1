//! `machinist verify FILE`: correct machines pass, and wrong ones fail in the row made for the
//! error.

mod left_out;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use crate::process::{self, said};

/// Mass on a spring and a damper, released at 0.1 m, by its energies.
const OSCILLATOR: &str = r#"
[scene]
name = "oscillator"
source = "Textbook."

[units.m]
unit = "mass_on_spring"

[initial]
"m.x" = 0.1

[outputs]
x = "m.x"

[checks.free_motion]
of = "x"
expression = "0.1 [m]*exp(-m.damping*t/(2*m.mass))*(cos(w*t) + m.damping/(2*m.mass*w)*sin(w*t))"
tolerance = 1e-6
source = "Textbook: an oscillator with weak damping, let go at rest."

[checks.speed]
of = "m.x_dot"
values = [[0, 0], [1.05, 0.3771280]]
tolerance = 1e-3
source = "The same, by hand."

[helpers.w]
expression = "sqrt(m.stiffness/m.mass - (m.damping/(2*m.mass))^2)"
unit = "rad/s"

[run]
until = 4.0
points = 101
rtol = 1e-9
method = "dop853"

[define.mass_on_spring.coordinates.x]
unit = "m"

[define.mass_on_spring.parameters]
mass = { value = 2.0, unit = "kg" }
stiffness = { value = 50.0, unit = "N/m" }
damping = { value = 0.5, unit = "N s/m" }

[define.mass_on_spring.energy]
kinetic = "mass*x_dot^2/2"
potential = "stiffness*x^2/2"
dissipation = "damping*x_dot^2/2"
"#;

/// Coil whose flux pulls a plunger. `conversion` transfers its energy.
const MAGNET: &str = r#"
[scene]
name = "magnet"
source = "Textbook."

[units.m]
unit = "magnet"

[initial]
"m.x" = 0.01

[outputs]
x = "m.x"

[run]
until = 0.05
points = 51
rtol = 1e-8
method = "dop853"

[define.magnet.coordinates.x]
unit = "m"
scale = 0.01

[define.magnet.parameters]
mass = { value = 0.1, unit = "kg" }
stiffness = { value = 2000.0, unit = "N/m" }
gain = { value = 20.0, unit = "1/H/m" }
resistance = { value = 2.0, unit = "ohm" }
supply = { value = 5.0, unit = "V" }

[define.magnet.helpers.current]
expression = "gain*(0.02 [m] + x)*flux"
unit = "A"

[define.magnet.states.flux]
unit = "V s"
rate = "supply - resistance*current"

[define.magnet.energy]
kinetic = "mass*x_dot^2/2"
potential = "stiffness*x^2/2"
stored = "gain*(0.02 [m] + x)*flux^2/2"

[define.magnet.power]
supplied = "supply*current"
dissipated = "resistance*current^2"

[[define.magnet.forces]]
coordinate = "x"
expression = "-gain*flux^2/2"
conversion = true
"#;

const INDEPENDENT: &str = "independent derivation";

fn machinist(arguments: &[&str]) -> Output {
    process::output(process::machinist(process::REPOSITORY, arguments))
}

/// Rows of a machine: name and whether it passes; `None` for a row that is left out or not checked.
type Rows = Vec<(String, Option<bool>)>;

fn rows(path: &Path, more: &[&str]) -> (Option<i32>, Rows) {
    let path = path.to_str().expect("a path in UTF-8");
    let output = machinist(&[&["verify", path, "--json"], more].concat());
    let text = String::from_utf8_lossy(&output.stdout);
    let rows: serde_json::Value =
        serde_json::from_str(&text).unwrap_or_else(|_| panic!("{path}: {}", said(&output)));
    let rows = rows.as_array().expect("rows").iter().map(|row| {
        let is_left_out = row.get("skipped").or(row.get("unchecked")).is_some();
        let name = row["check"].as_str().expect("a name").to_owned();
        (name, (!is_left_out).then(|| row["pass"].as_bool().expect("pass or not")))
    });
    (output.status.code(), rows.collect())
}

fn failed(rows: &Rows) -> Vec<&str> {
    rows.iter().filter(|(_, pass)| *pass == Some(false)).map(|(name, _)| name.as_str()).collect()
}

/// Writes a scene file that lasts as long as its folder.
fn written(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("own.toml");
    fs::write(&path, text).expect("written");
    (folder, path)
}

/// Returns the failed rows of a machine after a change of its text.
fn failed_after(text: &str, from: &str, to: &str) -> Vec<String> {
    assert!(text.contains(from), "{from}");
    let (_folder, path) = written(&text.replace(from, to));
    let (code, rows) = rows(&path, &[]);
    let failed: Vec<String> = failed(&rows).into_iter().map(str::to_owned).collect();
    assert_eq!(code, Some(i32::from(!failed.is_empty())));
    failed
}

#[test]
fn right_machines_pass_with_their_own_checks() {
    for (text, own) in [(OSCILLATOR, 2), (MAGNET, 0)] {
        let (_folder, path) = written(text);
        let (code, rows) = rows(&path, &[]);
        assert_eq!((code, failed(&rows)), (Some(0), vec![]));
        let asked = rows.iter().filter(|(_, pass)| pass.is_some()).count();
        assert!(asked >= 10 + own, "{rows:?}");
        assert!(own == 0 || rows.iter().any(|(name, _)| name == "free_motion of x"), "{rows:?}");
        assert!(rows.contains(&(INDEPENDENT.to_owned(), Some(true))), "{rows:?}");
    }
}

#[test]
fn dissipation_of_the_wrong_sign_fails_by_the_power_lost() {
    let sign = ("dissipation = \"damping", "dissipation = \"-damping");
    let failed = failed_after(OSCILLATOR, sign.0, sign.1);
    assert!(failed.contains(&"power lost is never negative".to_owned()), "{failed:?}");
    assert!(!failed.contains(&"no force feeds every motion".to_owned()), "{failed:?}");
}

#[test]
fn a_drag_of_the_wrong_sign_fails_by_the_forces() {
    let dissipation = "dissipation = \"damping*x_dot^2/2\"";
    let drag = |sign: &str| {
        format!(
            "[[define.mass_on_spring.forces]]\ncoordinate = \"x\"\nexpression = \"{sign}damping*x_dot\""
        )
    };
    assert!(failed_after(OSCILLATOR, dissipation, &drag("-")).is_empty());
    let failed = failed_after(OSCILLATOR, dissipation, &drag(""));
    assert!(failed.contains(&"no force feeds every motion".to_owned()), "{failed:?}");
}

#[test]
fn a_converting_force_of_the_wrong_sign_fails_by_the_power_balance() {
    let failed = failed_after(MAGNET, "\"-gain*flux^2/2\"", "\"gain*flux^2/2\"");
    let balance = "power balance along the run and around it".to_owned();
    assert!(failed.contains(&balance), "{failed:?}");
}

#[test]
fn a_closed_form_with_a_wrong_factor_fails_alone() {
    let failed = failed_after(OSCILLATOR, "expression = \"0.1 [m]", "expression = \"0.1001 [m]");
    assert_eq!(failed, ["free_motion of x"]);
}

#[test]
fn a_closed_form_follows_the_parameters_that_are_set() {
    let (_folder, path) = written(OSCILLATOR);
    let set = ["--set", "m.damping=0.7", "--until", "0.9", "--rtol", "1e-10"];
    let (code, rows) = rows(&path, &set);
    assert_eq!((code, failed(&rows)), (Some(0), vec![]), "the value at 1.05 s is left out");
}

#[test]
fn a_check_in_the_wrong_unit_is_refused_where_it_stands() {
    let (_folder, path) = written(&OSCILLATOR.replace("\"0.1 [m]*exp", "\"0.1 [s]*exp"));
    let output = machinist(&["verify", path.to_str().expect("a path")]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty());
    let said = said(&output);
    assert!(said.contains("the reference of `x` is in m") && said.contains("own.toml:"), "{said}");
}

/// Verifies a run of very many oscillations, with a time limit for each run.
fn within(seconds: &str, method: &str) -> (Option<i32>, Vec<serde_json::Value>) {
    let text = OSCILLATOR.replace("until = 4.0", "until = 2e6").replace("\"dop853\"", method);
    let (_folder, path) = written(&text.replace("0.5, unit = \"N s/m\"", "1e-9, unit = \"N s/m\""));
    let path = path.to_str().expect("a path");
    let limit = ["--algebra", "plain", "--time-limit", seconds];
    let output = machinist(&[&["verify", path, "--json"], &limit[..]].concat());
    let rows =
        serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", said(&output)));
    (output.status.code(), rows)
}

#[test]
fn a_run_that_takes_too_long_fails_and_says_how_far_it_came() {
    let (code, rows) = within("0.2", "\"tsit5\"");
    let said = rows[0]["failure"].as_str().expect("a failure");
    assert_eq!((code, rows.len()), (Some(1), 1), "{said}");
    for part in ["`tsit5` stopped after 0.2 s at t = ", " s, of ", " steps: "] {
        assert!(said.contains(part), "{said}");
    }
}

/// The closed form takes no time, but the reference that it is compared with does.
#[test]
fn a_reference_that_takes_too_long_fails_its_rows() {
    let (code, rows) = within("0.02", "\"auto\"");
    let row = |name: &str| rows.iter().find(|row| row["check"] == name).expect("a row");
    assert_eq!((code, row("the run")["pass"].as_bool()), (Some(1), Some(true)));
    let row = row("two converged runs agree");
    assert_eq!((row["pass"].as_bool(), row.get("skipped")), (Some(false), None));
    let said = row["failure"].as_str().expect("a failure");
    assert!(said.contains("stopped after 0.02 s at t = "), "{said}");
}

#[test]
fn a_limit_of_no_time_is_refused() {
    for seconds in ["0", "-1", "nan", "soon"] {
        let output = machinist(&["verify", "own.toml", &format!("--time-limit={seconds}")]);
        assert_eq!(output.status.code(), Some(2), "{seconds}: {}", said(&output));
    }
}

#[test]
fn a_model_file_gives_the_rows_of_its_spec() {
    let (folder, path) = written(OSCILLATOR);
    let model = folder.path().join("own.model");
    let [spec, out] = [&path, &model].map(|path| path.to_str().expect("a path"));
    assert_eq!(machinist(&["compile", spec, "--out", out]).status.code(), Some(0));
    let [of_spec, of_model] = [spec, out].map(|path| {
        let text = machinist(&["verify", path, "--json"]).stdout;
        let rows: Vec<serde_json::Value> = serde_json::from_slice(&text).expect("rows");
        let (independent, others): (Vec<_>, Vec<_>) =
            rows.into_iter().partition(|row| row["check"] == INDEPENDENT);
        (others, independent[0].get("skipped").is_some())
    });
    assert!(!of_spec.0.is_empty());
    assert_eq!(of_spec.0, of_model.0);
    assert_eq!([of_spec.1, of_model.1], [false, true], "a model has no spec");
}

#[test]
fn a_scene_with_fields_is_derived_independently_in_few_elements() {
    let scene =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes/shaft_with_rotors.toml");
    let (_, rows) = rows(&scene, &["--only", INDEPENDENT]);
    assert_eq!(rows, [(INDEPENDENT.to_owned(), Some(true))]);
}

#[test]
fn sensitivities_of_a_scene_with_fields_are_checked_in_few_elements() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let name = "sensitivities to the parameters that matter most";
    for scene in ["shaft_with_rotors.toml", "reed_beat_up.toml"] {
        let (code, rows) = rows(&scenes.join(scene), &["--only", "sensitivities"]);
        assert_eq!(rows, [(name.to_owned(), Some(true))], "{scene}");
        assert_eq!(code, Some(0));
    }
}

#[test]
fn a_run_given_at_a_node_leaves_out_the_row_in_few_elements() {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/../specs/scenes/shaft_with_rotors.toml");
    let initial = ["--only", "sensitivities", "--initial", "shaft.phi[40]=0.001rad"];
    let (code, rows) = rows(Path::new(scene), &initial);
    assert_eq!((rows[0].1, rows.len(), code), (None, 1, Some(0)));
}

#[test]
fn checks_of_outputs_change_no_equation() {
    let at = |word: &str| OSCILLATOR.find(word).expect("a table");
    let (closed, speed, after) = (at("[checks.free"), at("[checks.speed"), at("[helpers.w]"));
    let texts = [speed, closed].map(|end| [&OSCILLATOR[..end], &OSCILLATOR[after..]].concat());
    let equations = texts.map(|text| {
        let (_folder, path) = written(&text);
        String::from_utf8(machinist(&["derive", path.to_str().expect("a path")]).stdout)
    });
    assert!(equations[0].as_ref().is_ok_and(|text| text.contains("m.x_ddot")));
    assert_eq!(equations[0], equations[1]);
}

#[test]
fn examples_of_rotational_parts_pass_their_automatic_checks() {
    let folders = ["parts/control", "parts/hydraulic", "parts/rotational", "parts/thermal"];
    pass_their_checks(&folders, "plain");
}

#[test]
fn examples_of_other_parts_pass_their_automatic_checks() {
    let folders = ["parts/electrical", "parts/planar", "parts/sources", "parts/translational"];
    pass_their_checks(&folders, "plain");
}

#[test]
fn examples_of_spatial_parts_pass_their_automatic_checks() {
    pass_their_checks(&["parts/spatial"], "plain");
}

#[test]
fn machines_of_parts_pass_their_automatic_checks() {
    pass_their_checks(&["drives", "gallery", "linkages", "msl"], "symbolica");
}

/// Checks every scene in folders of `specs/scenes`, derived by an algebra.
fn pass_their_checks(folders: &[&str], algebra: &str) {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let mut wrong = Vec::new();
    for folder in folders {
        let mut files: Vec<PathBuf> = fs::read_dir(scenes.join(folder))
            .expect("a folder")
            .map(|entry| entry.expect("an entry").path())
            .filter(|path| path.is_file())
            .collect();
        files.sort();
        for file in &files {
            let (code, rows) = rows(file, &["--algebra", algebra]);
            if code != Some(0) {
                wrong.push(format!("{}: {:?}", file.display(), failed(&rows)));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

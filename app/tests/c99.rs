//! Scenes as C99 on the command line, and steps of a fixed length.

use std::fs;
use std::path::Path;

use crate::process::{answer, assert_refused, machinist, output, said};

fn names_in(folder: &Path) -> Vec<String> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let name = |entry: std::io::Result<fs::DirEntry>| {
        entry.expect("an entry").file_name().into_string().expect("a name")
    };
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

#[test]
fn one_scene_is_written_with_its_inputs_and_checked_later() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = |arguments: &[&str]| machinist(folder.path(), arguments);
    let generate = ["gen", "--target", "c99", "saw_gin", "-o", "drive", "--inputs", "load.mean"];
    answer(here(&generate));
    let drive = folder.path().join("drive");
    let files = ["CMakeLists.txt", "saw_gin.c", "saw_gin.h", "saw_gin_example.c"];
    assert_eq!(names_in(&drive), files);
    let header = fs::read_to_string(drive.join("saw_gin.h")).expect("a header");
    for part in [
        "machinist gen --target c99 saw_gin -o . --inputs load.mean",
        "} saw_gin_inputs_t;",
        "void saw_gin_set_inputs(saw_gin_machine_t *machine, const saw_gin_inputs_t *inputs);",
        "double load_mean; /* load.mean: ",
        "int saw_gin_step(saw_gin_machine_t *machine, double step);",
    ] {
        assert!(header.contains(part), "{part} is not in\n{header}");
    }
    let check = [&generate[..], &["--check"]].concat();
    let checked = answer(here(&check));
    assert_eq!(checked.lines().filter(|line| line.starts_with("fresh")).count(), 4, "{checked}");
    assert!(checked.contains("a step takes "), "{checked}");
    fs::write(drive.join("saw_gin.h"), format!("{header}\n")).expect("written");
    let output = output(here(&check));
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("out of date: saw_gin.h"), "{}", said(&output));
}

#[test]
fn float_and_other_methods_are_emitted_on_request() {
    let folder = tempfile::tempdir().expect("a folder");
    let generate = ["gen", "--target", "c99", "two_mass", "-o", "drive"];
    let generate = [&generate[..], &["--real", "f32", "--step", "ros2"]].concat();
    answer(machinist(folder.path(), &generate));
    let read = |name: &str| fs::read_to_string(folder.path().join("drive").join(name));
    let [header, source] = ["two_mass.h", "two_mass.c"].map(|name| read(name).expect("a file"));
    assert!(header.contains("int two_mass_step(two_mass_machine_t *machine, float step);"));
    assert!(source.contains("static void factor_step(float scale"), "{source}");
    assert!(!header.contains("double") && !source.contains("double"));
}

#[test]
fn fields_are_divided_as_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let generate = ["gen", "--target", "c99", "shaft_step_torque", "-o", "shaft"];
    let generate = [&generate[..], &["--elements", "3", "--order", "2"]].concat();
    answer(machinist(folder.path(), &generate));
    let path = folder.path().join("shaft/shaft_step_torque.h");
    let header = fs::read_to_string(path).expect("a header");
    assert!(header.contains("shaft_step_torque -o . --elements 3 --order 2"), "{header}");
    // The first of seven nodes is held, and the last is a coordinate of the machine.
    for node in 0..7 {
        let is_there = header.contains(&format!("shaft.phi[{node}]"));
        assert_eq!(is_there, (1..6).contains(&node), "node {node}:\n{header}");
    }
}

#[test]
fn what_c99_cannot_be_made_of_is_refused_and_nothing_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = |arguments: &[&str]| machinist(folder.path(), arguments);
    let c99 = |more: &[&str]| here(&[&["gen", "--target", "c99"], more].concat());
    let none = ["shaft_step_torque", "-o", "out", "--elements", "0"];
    assert_refused(c99(&none), &["field `shaft.phi`", "--elements"]);
    assert_refused(c99(&["saw_gin", "-o", "out", "--order", "2"]), &["has no fields"]);
    let unknown = ["saw_gin", "-o", "out", "--inputs", "load.meen"];
    assert_refused(c99(&unknown), &["no parameter `load.meen`", "did you mean `load.mean`?"]);
    let inertia = ["two_mass", "-o", "out", "--inputs", "driver.inertia"];
    assert_refused(c99(&inertia), &["cannot be an input", "kinetic energy"]);
    assert_refused(c99(&["saw_gin"]), &["needs a folder", "-o saw_gin"]);
    assert_refused(c99(&["-o", "out"]), &["one scene at a time"]);
    assert_refused(c99(&["saw_gin", "-o", "out", "--step", "euler"]), &["rk4, heun, ros2"]);
    assert_refused(here(&["gen", "saw_gin"]), &["not `saw_gin`"]);
    assert_refused(here(&["gen", "--real", "f32"]), &["--real requires --target c99"]);
    assert_eq!(names_in(folder.path()), [""; 0]);

    let own = folder.path().join("saw_gin.c");
    fs::write(&own, "int mine;\n").expect("written");
    let output = output(c99(&["saw_gin", "-o", "."]));
    assert_eq!(output.status.code(), Some(1));
    assert!(said(&output).contains("was not emitted by Machinist"), "{}", said(&output));
    assert_eq!(names_in(folder.path()), ["saw_gin.c"]);
}

#[test]
fn steps_of_a_fixed_length_are_compared_with_the_adaptive_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = |arguments: &[&str]| machinist(folder.path(), arguments);
    let fixed = |step: &str, more: &[&str]| {
        let run = ["run", "stick_slip", "--rtol", "1e-11", "--fixed", step, "--out", "run.csv"];
        answer(here(&[&run[..], more].concat()));
        let table = fs::read_to_string(folder.path().join("run.csv")).expect("a table");
        let mut rows = table.lines();
        let header = rows.next().expect("a header");
        let errors: Vec<usize> = header
            .split(',')
            .enumerate()
            .filter_map(|(at, name)| name.contains("error(").then_some(at))
            .collect();
        assert!(!errors.is_empty(), "{header}");
        let error = |row: &str| {
            let cells: Vec<f64> = row.split(',').map(|x| x.parse().expect("a number")).collect();
            errors.iter().map(|at| cells[*at].abs()).fold(0.0_f64, f64::max)
        };
        error(rows.last().expect("a row"))
    };
    // The steps are far above rounding. Events do not reduce the order.
    let [coarse, fine] = ["2e-3", "1e-3"].map(|step| fixed(step, &[]));
    assert!(coarse < 1e-4 && fine < 0.3 * coarse, "{coarse:e} {fine:e}");
    let heun = fixed("1e-3", &["--step-method", "heun"]);
    assert!(heun > fine, "{heun:e} {fine:e}");

    let several = ["run", "two_mass", "--fixed", "2ms,1ms", "--plot", "errors.svg"];
    let table = answer(here(&several));
    let rows: Vec<Vec<&str>> = table.lines().map(|row| row.split_whitespace().collect()).collect();
    let row = |size: &str| rows.iter().find(|row| row.first() == Some(&size)).expect("a size");
    assert_eq!(row("0.002")[1], "250", "{table}");
    let order: f64 = row("0.001").last().and_then(|order| order.parse().ok()).expect("an order");
    assert!((order - 4.0).abs() < 0.2, "{table}");
    assert!(fs::read_to_string(folder.path().join("errors.svg")).is_ok());
    let with_table = here(&[&several[..], &["--out", "errors.csv"]].concat());
    assert_refused(with_table, &["one size of `--fixed`"]);

    assert_refused(here(&["run", "stick_slip", "--fixed", "0"]), &["finite and above zero"]);
    assert_refused(here(&["run", "stick_slip", "--fixed", "1e-30"]), &["would take"]);
    let unstable = output(here(&["run", "saw_gin", "--fixed", "0.1"]));
    assert_eq!(unstable.status.code(), Some(1), "{}", said(&unstable));
    assert!(said(&unstable).contains("the state is not finite"), "{}", said(&unstable));
}

//! Tables as Parquet files.

use std::fs::File;
use std::path::Path;

use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use serde_json::Value;

use crate::process::{REPOSITORY, answer, machinist};

const SWEEP: [&str; 11] = [
    "sweep",
    "two_mass",
    "--parameter",
    "coupling.stiffness=1e3..1e5:log",
    "--count",
    "5",
    "--until",
    "0.1",
    "--outputs",
    "coupling_torque,twist",
    "--out",
];

fn path<'a>(folder: &'a tempfile::TempDir, name: &str) -> (std::path::PathBuf, &'a Path) {
    (folder.path().join(name), folder.path())
}

/// Returns the names of columns, rows as text (`None` for a missing cell), and a value of the
/// metadata.
fn read(file: &Path, key: &str) -> (Vec<String>, Vec<Vec<Option<String>>>, Value) {
    let file = SerializedFileReader::new(File::open(file).expect("a file")).expect("a table");
    let metadata = file.metadata().file_metadata();
    let columns = metadata.schema().get_fields().iter();
    let names = columns.map(|column| column.name().to_owned()).collect();
    let told = metadata.key_value_metadata().expect("metadata").iter();
    let told = told.filter(|told| told.key == key).find_map(|told| told.value.clone());
    let told = serde_json::from_str(&told.expect("what it is of")).expect("JSON");
    let cell = |field: &Field| match field {
        Field::Null => None,
        Field::Double(value) => Some(value.to_string()),
        Field::Long(value) => Some(value.to_string()),
        Field::Str(text) => Some(text.clone()),
        other => panic!("{other:?}"),
    };
    let rows = file.get_row_iter(None).expect("rows").map(|row| {
        let row = row.expect("a row");
        row.get_column_iter().map(|(_, field)| cell(field)).collect()
    });
    (names, rows.collect(), told)
}

#[test]
fn a_sweep_is_what_its_csv_is_with_what_it_is_of() {
    let folder = tempfile::tempdir().expect("a folder");
    let [table, csv] = ["table.parquet", "table.csv"].map(|name| path(&folder, name).0);
    for out in [&table, &csv] {
        let command = [&SWEEP[..], &[out.to_str().expect("a plain path")]].concat();
        answer(machinist(REPOSITORY, &command));
    }
    let (names, rows, told) = read(&table, "machinist.sweep");
    let expected = ["variant", "coupling.stiffness", "coupling_torque", "twist", "steps", "error"];
    assert_eq!(names, expected);
    let csv = std::fs::read_to_string(csv).expect("a table");
    assert_eq!(rows.len(), 5);
    for (number, (row, line)) in rows.iter().zip(csv.lines().skip(1)).enumerate() {
        assert_eq!(row[0], Some(number.to_string()));
        assert_eq!(row[5], None);
        for (cell, text) in row[1..5].iter().zip(line.split(',')) {
            let cell: f64 = cell.as_ref().expect("a number").parse().expect("a number");
            let text: f64 = text.parse().expect("a number");
            assert_eq!(cell.to_bits(), text.to_bits(), "{line}");
        }
    }
    let of = &told["sweep"];
    assert_eq!(of["model"], "two_mass");
    assert_eq!(of["fingerprint"].as_str().map(str::len), Some(64));
    assert_eq!(of["settings"]["until"], 0.1);
    assert_eq!(of["outputs"][1], "twist");
    assert_eq!(of["design"]["names"][0], "coupling.stiffness");
    let (_, _, units) = read(&table, "machinist.units");
    assert_eq!(units["coupling.stiffness"], "N m/rad");
}

#[test]
fn a_variant_that_stops_has_no_results_and_its_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = path(&folder, "table.parquet").0;
    let out = table.to_str().expect("a plain path");
    let ranges = ["--parameter", "driver.inertia=-1..1", "--count", "3", "--method", "tsit5"];
    let command =
        [&["sweep", "two_mass", "--until", "0.01"], &ranges[..], &["--out", out]].concat();
    let output = crate::process::output(machinist(REPOSITORY, &command));
    assert_eq!(output.status.code(), Some(1));
    let (names, rows, _) = read(&table, "machinist.sweep");
    let error = names.len() - 1;
    let stopped: Vec<&Vec<Option<String>>> =
        rows.iter().filter(|row| row[error].is_some()).collect();
    assert!(!stopped.is_empty() && stopped.len() < 3, "{rows:?}");
    for row in stopped {
        assert!(row[2..error - 1].iter().all(Option::is_none), "{row:?}");
        assert_eq!(row[error - 1].as_deref(), Some("0"));
    }
}

#[test]
fn runs_spectra_responses_and_diagrams_are_tables_too() {
    let folder = tempfile::tempdir().expect("a folder");
    let response =
        ["--input", "load_torque", "--output", "twist", "--points", "5", "--at", "initial"];
    let speeds = ["--parameter", "coupling.stiffness=1e4..2e4", "--count", "3", "--at", "initial"];
    let commands: [(&str, &[&str], usize, &str); 4] = [
        ("run", &["--points", "7"], 7, "time"),
        ("spectrum", &["--samples", "16"], 9, "frequency"),
        ("response", &response, 5, "frequency"),
        ("campbell", &speeds, 3, "coupling.stiffness"),
    ];
    for (command, more, count, first) in commands {
        let table = folder.path().join(command).with_extension("parquet");
        let out = ["--out", table.to_str().expect("a plain path")];
        answer(machinist(REPOSITORY, &[&[command, "two_mass"], more, &out].concat()));
        let (names, rows, told) = read(&table, &format!("machinist.{command}"));
        assert_eq!(names[0], first, "{command}");
        assert_eq!(rows.len(), count, "{command}");
        assert!(names.len() > 1 && rows.iter().flatten().any(Option::is_some), "{command}");
        assert_eq!(told[command]["model"], "two_mass");
    }
}

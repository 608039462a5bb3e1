//! Files and plots of a trajectory.

#[path = "../../tests/common/mod.rs"]
mod common;

use common::Oscillator;
use machinist::{Simulation, Trajectory};

fn run() -> Trajectory {
    Simulation::new(&Oscillator).with_energy_balance(true).run().unwrap()
}

#[test]
fn a_table_reads_back_the_same_to_the_last_bit() {
    let mut run = run();
    run.columns[0].values[..4].copy_from_slice(&[1e-300, -0.0, f64::MAX, 0.1 + 0.2]);
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).unwrap();
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    let headers: Vec<_> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(headers[..3], ["time [s]", "rotor.angle [rad]", "rotor.omega [rad/s]"]);
    let rows: Vec<Vec<f64>> = reader.deserialize().map(Result::unwrap).collect();
    assert_eq!(rows.len(), run.times.len());
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(row[0].to_bits(), run.times[index].to_bits());
        for (column, value) in run.columns.iter().zip(&row[1..]) {
            assert_eq!(value.to_bits(), column.values[index].to_bits(), "{}", column.name);
        }
    }
    let text = String::from_utf8(bytes).unwrap();
    assert!(text.contains("1e-300"), "numbers are written short");
}

#[test]
fn json_holds_what_the_trajectory_holds() {
    let run = run();
    let mut bytes = Vec::new();
    run.write_json(&mut bytes).unwrap();
    let json: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(json["scene"], "oscillator");
    assert_eq!(json["method"], "bdf");
    assert_eq!(json["work"]["steps"], run.work.steps);
    assert_eq!(json["columns"][1]["name"], "rotor.omega");
    assert_eq!(json["columns"][1]["kind"], "state");
    assert_eq!(json["columns"][1]["values"][300], run.last("rotor.omega").unwrap());
    assert_eq!(json["times"].as_array().unwrap().len(), 301);
    assert!(json["energy_balance"]["residual"][300].is_number());
}

mod plots {
    use machinist_app::plot::{PlotError, plot};

    use super::run;

    #[test]
    fn an_svg_has_one_panel_a_unit_and_names_every_column() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.svg");
        let names = ["rotor.angle", "spring_torque", "drive_torque"];
        plot(&run(), &names, &path).unwrap();
        let svg = std::fs::read_to_string(&path).unwrap();
        for text in names.iter().chain(&["[rad]", "[N m]", "time [s]", "A rotor on a spring"]) {
            assert!(svg.contains(text), "{text}");
        }
        assert_eq!(svg.matches("[N m]").count(), 1);
        assert!(svg.contains("sans-serif"));
    }

    #[test]
    fn a_png_is_drawn_in_colour_and_twice_alike() {
        let folder = tempfile::tempdir().unwrap();
        let draw = |name: &str| {
            let path = folder.path().join(name);
            plot(&run(), &[], &path).unwrap();
            std::fs::read(path).unwrap()
        };
        let bytes = draw("a.png");
        assert_eq!(bytes, draw("b.PNG"));
        let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let size = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(size.width, 2000);
        let blue = pixels.chunks_exact(3).filter(|p| p[2] > 150 && p[0] < 80).count();
        let dark = pixels.chunks_exact(3).filter(|p| p.iter().all(|c| *c < 120)).count();
        assert!(blue > 2000 && dark > 500, "{blue} pixels of line, {dark} of text");
    }

    #[test]
    fn what_cannot_be_plotted_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let refuse = |names: &[&str], file: &str| {
            plot(&run(), names, &folder.path().join(file)).expect_err("must be refused")
        };
        assert!(matches!(refuse(&[], "run.pdf"), PlotError::UnknownFileType(_)));
        assert!(matches!(refuse(&[], "run"), PlotError::UnknownFileType(_)));
        let message = refuse(&["rotor.omgea"], "run.svg").to_string();
        assert!(message.ends_with("`rotor.omgea` (did you mean `rotor.omega`?)"), "{message}");
        assert!(matches!(refuse(&[], "nowhere/run.svg"), PlotError::Writing { .. }));
    }
}

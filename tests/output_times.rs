//! Output times that are not equally spaced.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_text, refusal};

/// Returns a mass on a spring, from rest at 1 m: x = cos(omega t).
fn swing(run: &str) -> String {
    swing_as_is(&format!("{run}\nrtol = 1e-10\nmethod = \"dop853\""))
}

fn swing_as_is(run: &str) -> String {
    format!(
        "[scene]\nname = \"swing\"\n[units]\n\
         mass = {{ unit = \"translational/mass\", parameters = {{ mass = 2 }} }}\n\
         spring = {{ unit = \"translational/spring\", parameters = {{ stiffness = 50 }} }}\n\
         wall = {{ unit = \"translational/fixed\" }}\n\
         [[joints]]\nconnect = [\"mass.a\", \"spring.b\"]\n\
         [[joints]]\nconnect = [\"wall.a\", \"spring.a\"]\n\
         [parameters]\nomega = {{ value = 5, unit = \"1/s\" }}\n\
         [initial]\n\"mass.x\" = 1\n[outputs]\nx = \"mass.x\"\n\
         [run]\n{run}\n"
    )
}

fn scene(run: &str) -> ModelSimulator {
    of_text(&swing(run), Keep::Needed)
}

fn assert_exact(run: &Trajectory) {
    for (t, x) in run.times.iter().zip(run.column("x").expect("x")) {
        assert!((x - (5.0 * t).cos()).abs() < 1e-8, "{t}: {x}");
    }
}

#[test]
fn a_run_tells_what_there_is_at_the_times_of_a_list() {
    let scene = scene("times = [0, 0.1, \"2*pi/omega\", \"2000 [ms]\"]");
    let run = Simulation::new(&scene).run().expect("it runs");
    assert_eq!(run.times, [0.0, 0.1, std::f64::consts::TAU / 5.0, 2.0]);
    assert_exact(&run);
    // Public defaults of the run.
    assert_eq!(scene.run_defaults().until.to_bits(), 2.0_f64.to_bits());
    assert_eq!(scene.run_defaults().times.len(), scene.run_defaults().points);
}

#[test]
fn a_run_that_only_says_how_long_is_shown_at_201_times_by_auto_to_a_millionth() {
    let scene = of_text(&swing_as_is("until = 2"), Keep::Needed);
    let run = Simulation::new(&scene).run().expect("it runs");
    assert_eq!((run.times.len(), run.times[1]), (201, 0.01));
    assert_eq!((run.method, run.rtol), (Method::Auto, 1e-6));
    for (t, x) in run.times.iter().zip(run.column("x").expect("x")) {
        assert!((x - (5.0 * t).cos()).abs() < 1e-5, "{t}: {x}");
    }
}

#[test]
fn other_ends_keep_the_times_within_them() {
    let scene = scene("times = [0.05, 0.1, 0.7, 2]");
    let times = |run: Simulation<'_>| run.run().expect("it runs").times;
    let run = || Simulation::new(&scene);
    assert_eq!(times(run()), [0.05, 0.1, 0.7, 2.0]);
    assert_eq!(times(run().until(0.5)), [0.05, 0.1, 0.5]);
    assert_eq!(times(run().until(3.0)), [0.05, 0.1, 0.7, 2.0, 3.0]);
    assert_eq!(times(run().until(0.01)), [0.0, 0.01]);
    assert_eq!(times(run().from(0.06)), [0.06, 0.1, 0.7, 2.0]);
    assert_eq!(times(run().points(3)), [0.0, 1.0, 2.0]);
    assert_eq!(times(run().times(&[0.0, 0.3])), [0.0, 0.3]);
    assert_eq!(times(run().also_at(&[0.2])), [0.05, 0.1, 0.2, 0.7, 2.0]);
}

#[test]
fn times_at_equal_ratios_are_dense_at_the_start() {
    let scene = scene("from = 0.5\nuntil = 10.5\npoints = 12\nspacing = \"log\"\nfirst = 1e-3");
    let start = Simulation::new(&scene).initial_value("mass.x", (2.5_f64).cos());
    let start = start.and_then(|run| run.initial_value("mass.v", -5.0 * (2.5_f64).sin()));
    let run = start.expect("states").run().expect("it runs");
    assert_eq!((run.times.len(), run.times[0], run.times[11]), (12, 0.5, 10.5));
    for (index, time) in run.times.iter().enumerate().skip(1) {
        let expected = 0.5 + 1e-3 * 1e4_f64.powf((index as f64 - 1.0) / 10.0);
        assert!((time - expected).abs() < 1e-12, "{index}: {time}, not {expected}");
    }
    assert_exact(&run);
    let even = self::scene("until = 1\npoints = 3\nspacing = \"even\"");
    assert_eq!(Simulation::new(&even).run().expect("it runs").times, [0.0, 0.5, 1.0]);
}

#[test]
fn times_that_make_no_sense_are_refused() {
    for (run, message) in [
        ("times = [0, 0.2, 0.1]", "the times of a run must increase"),
        ("times = [0, 0]", "the times of a run must increase"),
        ("times = [-1, 1]", "the times of a run must increase"),
        ("times = [0]", "`times` must have 2 to 10 000 000"),
        ("times = 3", "`times` must be a list of times"),
        ("times = [0, \"1 [m]\"]", "a time of the run"),
        ("times = [0, 1]\nuntil = 2", "`times` or `until`, not both"),
        ("times = [0, 1]\npoints = 2", "`times` or `points`, not both"),
        ("until = 1\npoints = 9\nspacing = \"log\"", "needs `first`"),
        ("until = 1\npoints = 9\nfirst = 0.1", "`first` is used only with logarithmic spacing"),
        ("until = 1\npoints = 9\nspacing = \"log\"\nfirst = 2", "before the end"),
        ("until = 1\npoints = 2\nspacing = \"log\"\nfirst = 0.1", "from 3 to 10 000 000"),
        ("until = 1\npoints = 9\nspacing = \"lag\"", "known are even, log"),
        ("points = 9", "[run] lacks `until`"),
    ] {
        let said = refusal(&swing(run));
        assert!(said.contains(message), "{run}: {said}");
    }
}

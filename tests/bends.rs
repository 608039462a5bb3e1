//! Machines that bend where their series do not tell: friction that turns over within a
//! width, however narrow. None of it is passed over by long steps.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a block of 1 kg in a potential, with a force along its way that may depend on `width`.
fn block(potential: &str, force: &str, until: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "block"
        [units.block]
        unit = "block"
        [run]
        until = {until:?}
        points = 41
        rtol = 1e-8
        method = "auto"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        width = {{ value = 1e-2, unit = "m/s" }}
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "{potential}"
        [[define.block.forces]]
        coordinate = "x"
        expression = "{force}"
        "#
    );
    of_text(&text, Keep::Needed)
}

/// Returns x'' + x = cos(1.3 t) - 0.2 `law`, where the law changes its sign at v = 0 within
/// `width`.
fn rubbing(law: &str) -> ModelSimulator {
    let force = format!("1 [N]*cos(1.3 [rad/s]*t) - 0.2 [N]*({law})");
    block("1 [N/m]*x^2/2", &force, 20.0)
}

fn run(block: &ModelSimulator, width: f64, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(block).initial_state(&[0.0, 1.0]).method(method).rtol(rtol);
    run.parameter("block.width", width).expect("a parameter").run().expect("it runs")
}

#[test]
fn friction_that_turns_over_is_never_passed_over() {
    for (law, saturations, has_corners, first) in [
        ("tanh(v/width)", 1, false, "starts with taylor"),
        ("atan(v/width)", 1, false, "starts with taylor"),
        ("v/sqrt(v^2 + width^2)", 0, false, "starts with taylor"),
        ("max(-1, min(1, v/width))", 0, true, "starts with dop853"),
    ] {
        let block = rubbing(law);
        let series = Simulator::<f64>::taylor(&block).expect("it has series");
        assert_eq!(
            (block.saturations(), series.has_corners()),
            (saturations, has_corners),
            "{law}"
        );
        for width in [1e-1, 1e-2, 1e-4] {
            let exact = run(&block, width, Method::Radau, 1e-12);
            for rtol in [1e-4, 1e-6, 1e-9] {
                let found = run(&block, width, Method::Auto, rtol);
                assert!(found.notes[0].starts_with(first), "{law}: {:?}", found.notes);
                let differences = ["block.x", "block.v"].map(|name| {
                    let values = [&found, &exact].map(|run| run.column(name).expect("a state"));
                    let pairs = values[0].iter().zip(values[1]);
                    pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()))
                });
                let error = differences[0].max(differences[1]);
                println!("{law}, width {width:e}, {rtol:e}: {error:e}, {:?}", found.work);
                assert!(error < 300.0 * rtol, "{law}, width {width:e}, {rtol:e}: {error:e}");
            }
        }
    }
}

/// Returns x'' = 1/2 cos(t) (1 N) and a law that is 1 far from v = 0 on one side, less 1: the speed
/// is v_0 + 1/2 sin(t) until it comes near zero, at t = 3 pi/2.
fn touching(law: &str) -> ModelSimulator {
    block("0 [J]", &format!("0.5 [N]*cos(1 [rad/s]*t) - 0.2 [N]*(({law}) - 1)"), 10.0)
}

#[test]
fn a_speed_that_comes_near_zero_within_a_step_and_turns_back_is_seen() {
    const METHODS: [Method; 6] = [
        Method::Taylor,
        Method::Dop853,
        Method::Tsit5,
        Method::Radau,
        Method::Rodas5p,
        Method::Auto,
    ];
    const RTOLS: [f64; 3] = [1e-4, 1e-6, 1e-9];
    for law in ["tanh(v/width)", "1 - exp(-v/width)", "2/pi*atan((v/width)^3)"] {
        let block = touching(law);
        assert_eq!(block.saturations(), 1, "{law}");
        for width in [1e-1, 1e-2, 1e-3, 1e-5] {
            for nearest in [0.1, 1.0, 3.0, 6.0] {
                let start = [0.0, 0.5 + nearest * width];
                let run = |method, rtol| {
                    let run = Simulation::new(&block).initial_state(&start).method(method);
                    let run = run.rtol(rtol).parameter("block.width", width);
                    let run = run.expect("a parameter").run().expect("it runs");
                    *run.column("block.v").and_then(<[f64]>::last).expect("a state")
                };
                let exact = run(Method::Radau, 1e-13);
                let all = METHODS.into_iter().flat_map(|method| RTOLS.map(|rtol| (method, rtol)));
                for (method, rtol) in all {
                    let error = (run(method, rtol) - exact).abs();
                    let what = format!("{law}, {width:e}, {nearest}, {method:?}, {rtol:e}");
                    println!("{what}: {error:e}, {exact}");
                    assert!(error < 100.0 * rtol, "{what}: {error:e}");
                }
            }
        }
    }
}

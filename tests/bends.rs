//! Machines that bend where their series do not tell: friction that turns over within a
//! width, however narrow. None of it is passed over by long steps.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_contract::taylor::{Bends, TaylorSeries};
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns x'' + x = cos(1.3 t) - 0.2 `law`, where the law changes its sign at v = 0 within
/// `width`.
fn rubbing(law: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "rubbing"
        [units.block]
        unit = "block"
        [run]
        until = 20.0
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
        potential = "1 [N/m]*x^2/2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "1 [N]*cos(1.3 [rad/s]*t) - 0.2 [N]*({law})"
        "#
    );
    of_text(&text, Keep::Needed)
}

fn run(block: &ModelSimulator, width: f64, method: Method, rtol: f64) -> Trajectory {
    let run = Simulation::new(block).initial_state(&[0.0, 1.0]).method(method).rtol(rtol);
    run.parameter("block.width", width).expect("a parameter").run().expect("it runs")
}

#[test]
fn friction_that_turns_over_is_never_passed_over() {
    for (law, bends, first) in [
        ("tanh(v/width)", Bends::Saturates, "starts with taylor"),
        ("atan(v/width)", Bends::Saturates, "starts with taylor"),
        ("v/sqrt(v^2 + width^2)", Bends::Nowhere, "starts with taylor"),
        ("max(-1, min(1, v/width))", Bends::Corners, "starts with dop853"),
    ] {
        let block = rubbing(law);
        assert_eq!(Simulator::<f64>::taylor(&block).map(TaylorSeries::bends), Some(bends), "{law}");
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

//! Runs of conservative machines with constraints that keep the energy of their start.

use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const METHODS: [Method; 5] =
    [Method::Auto, Method::Dop853, Method::Tsit5, Method::Rodas5p, Method::Radau];

/// Returns a bob on a rod of 1 m, in the plane.
fn bob(dissipation: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "bob"
        [units.p]
        unit = "p"
        [initial]
        "p.x" = 0.8
        [guess]
        "p.y" = -0.6
        [run]
        until = 1000
        points = 501
        rtol = 1e-7
        method = "dop853"
        [define.p.coordinates]
        x = {{ unit = "m" }}
        y = {{ unit = "m" }}
        [define.p.energy]
        kinetic = "0.5*1 [kg]*(x_dot^2 + y_dot^2)"
        potential = "1 [kg]*9.81 [m/s^2]*y"
        {dissipation}
        [define.p.constraints.rod]
        expression = "x^2 + y^2 - 1 [m^2]"
        "#
    );
    of_text(&text, Keep::All)
}

/// Returns the angle of the bob in closed form, from its amplitude by the arithmetic-geometric mean:
/// sin(angle/2) = k sn(K - w t, k) with w = sqrt(g/l), k = sin(amplitude/2).
fn angle_of_bob(time: f64) -> f64 {
    let amplitude = 0.8f64.atan2(0.6);
    let (k, pace) = ((amplitude / 2.0).sin(), 9.81f64.sqrt());
    let (mut a, mut b, mut c) = (vec![1.0], (1.0 - k * k).sqrt(), vec![k]);
    while c[c.len() - 1].abs() > 1e-17 {
        let last = a[a.len() - 1];
        a.push(f64::midpoint(last, b));
        c.push((last - b) / 2.0);
        b = (last * b).sqrt();
    }
    let levels = a.len() - 1;
    let quarter = std::f64::consts::FRAC_PI_2 / a[levels];
    let mut phase = 2f64.powi(levels as i32) * a[levels] * (quarter - pace * time);
    for level in (1..=levels).rev() {
        phase = f64::midpoint(phase, (c[level] / a[level] * phase.sin()).asin());
    }
    2.0 * (k * phase.sin()).asin()
}

/// Returns the largest change of the total energy \[J\].
fn change_of_energy(run: &Trajectory) -> f64 {
    let total = run.column("energy.total").expect("an energy");
    total.iter().map(|energy| (energy - total[0]).abs()).fold(0.0, f64::max)
}

#[test]
fn a_pendulum_keeps_energy_and_phase_over_a_thousand_seconds() {
    let bob = bob("");
    let off = |run: &Trajectory| {
        let (x, y) = (run.column("p.x").expect("x"), run.column("p.y").expect("y"));
        let places = run.times.iter().zip(x.iter().zip(y));
        let off = places.map(|(time, (x, y))| (x.atan2(-y) - angle_of_bob(*time)).abs());
        off.fold(0.0, f64::max)
    };
    for method in METHODS {
        let free = Simulation::new(&bob).method(method);
        let kept = free.clone().with_constant_energy(true).run().expect("it swings");
        let free = free.run().expect("it swings");
        assert!(change_of_energy(&kept) < 1e-14, "{method}: {:e}", change_of_energy(&kept));
        assert!(off(&kept) < 0.2 * off(&free), "{method}: {:e} {:e}", off(&kept), off(&free));
    }
}

#[test]
fn a_linkage_in_space_keeps_energy_and_phase() {
    let linkage = crate::loops::by_hand();
    let simulation = Simulation::new(&linkage).until(1000.0).points(501);
    let exact = simulation.clone().method(Method::Dop853).rtol(1e-12).run().expect("it turns");
    let off = |run: &Trajectory| {
        let [found, wanted] = [run, &exact].map(|run| run.column("crank").expect("an angle"));
        found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    for method in METHODS {
        let free = simulation.clone().method(method).rtol(1e-6);
        let kept = free.clone().with_constant_energy(true).run().expect("it turns");
        let free = free.run().expect("it turns");
        assert!(change_of_energy(&kept) < 1e-12, "{method}: {:e}", change_of_energy(&kept));
        assert!(off(&kept) < 0.2 * off(&free), "{method}: {:e} {:e}", off(&kept), off(&free));
    }
}

#[test]
fn what_does_not_conserve_energy_is_refused() {
    let refusal = |machine: &ModelSimulator| {
        let run = Simulation::new(machine).with_constant_energy(true).run();
        match run.expect_err("a refusal") {
            SimulateError::NoConstantEnergy { why, .. } => why,
            other => panic!("{other}"),
        }
    };
    let lossy = bob("dissipation = \"0.5*1 [N s/m]*x_dot^2\"");
    assert!(refusal(&lossy).contains("dissipated"));
    let free = of_text(
        r#"
        [scene]
        name = "free"
        [units.p]
        unit = "p"
        [run]
        until = 1
        [define.p.coordinates]
        x = { unit = "m" }
        [define.p.energy]
        kinetic = "0.5*1 [kg]*x_dot^2"
        "#,
        Keep::All,
    );
    assert!(refusal(&free).contains("no constraints"));
    let bob = bob("");
    let run = Simulation::new(&bob).with_constant_energy(true).sensitivities(&["p.x"]);
    assert!(run.expect("a state").run().is_err());
}

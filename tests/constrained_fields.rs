//! Constraints beside fields: a gear against a closed form, and a slider-crank against chains of
//! rotors from which the constraint is eliminated by hand.

use std::fmt::Write;

use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{Linearization, Place, operating_point};
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_specs, of_text};

const METHODS: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

fn divided(scene: &ModelSimulator, elements: usize, order: usize) -> FieldSimulator<'_, f64> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    FieldSimulator::new(scene.with_fields(), wanted).expect("it is divided into elements")
}

fn run(simulator: &dyn Simulator<f64>, method: Method) -> Trajectory {
    let run = Simulation::new(simulator).method(method).rtol(1e-9).run();
    run.unwrap_or_else(|stopped| panic!("{}, {method}: {stopped}", simulator.name()))
}

const LENGTH: f64 = 1.5;
const DENSITY: f64 = 0.02;
const STIFFNESS: f64 = 150.0;

/// A shaft, free at its start, whose end drives a wheel through a gear of ratio i.
const GEAR: &str = r#"
[scene]
name = "gear"
[units.shaft]
unit = "shaft"
parameters = { length = 1.5, density = 0.02, stiffness = 150, damping_time = 0 }
inputs = { load = 0 }
fields = { phi = { elements = 8, order = 6 } }
[units.wheel]
unit = "rotor"
parameters = { inertia = 0.004 }
[constraints.gear]
expression = "3*shaft.end - wheel.phi"
[initial]
"shaft.phi" = "0.01 [rad]*x/shaft.length"
[outputs]
end = "shaft.end"
wheel = "wheel.phi"
torque = "gear"
[run]
until = 0.3
points = 61
"#;

/// The k of the lowest eigenmodes cos(k x), by bisection: a wheel of inertia J behind a gear of
/// ratio i takes part with i^2 J, and tan(k L) = -i^2 J k/density at the end.
fn wave_numbers(count: usize) -> Vec<f64> {
    let inertia = 9.0 * 0.004;
    let at = |k: f64| (k * LENGTH).sin() + inertia * k / DENSITY * (k * LENGTH).cos();
    let root = |mode: usize| {
        // Between a zero of the cosine and the next zero of the sine.
        let (mut from, mut to) = (mode as f64 - 0.5, mode as f64);
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            let at = |share: f64| at(share * std::f64::consts::PI / LENGTH);
            if (at(from) < 0.0) == (at(middle) < 0.0) { from = middle } else { to = middle }
        }
        from * std::f64::consts::PI / LENGTH
    };
    (1..=count).map(root).collect()
}

#[test]
fn a_shaft_turns_a_geared_wheel_with_the_eigenfrequencies_of_the_closed_form() {
    let scene = of_text(GEAR, Keep::Needed);
    let cut = divided(&scene, 8, 6);
    let run = Simulation::new(cut.single());
    let point = operating_point(&run, Place::Initial).expect("a point");
    let linear = Linearization::at(cut.single(), point).expect("it is linearized");
    let modes = linear.modes().expect("eigenmodes");
    let mut found: Vec<f64> =
        modes.iter().map(|mode| mode.imaginary).filter(|w| *w > 1.0).collect();
    found.sort_by(f64::total_cmp);
    for (found, k) in found.iter().zip(wave_numbers(4)) {
        let exact = k * (STIFFNESS / DENSITY).sqrt();
        assert!((found - exact).abs() < 1e-7 * exact, "{found} and not {exact}");
    }
    assert!(found.len() >= 4, "{found:?}");
}

/// A released twist moves wheel and shaft in the eigenmode, and the gear's torque is what turns the
/// wheel: J psi'' = -lambda.
#[test]
fn the_eigenmode_of_a_geared_shaft_stays_alone_by_every_method() {
    let k = wave_numbers(1)[0];
    let w = k * (STIFFNESS / DENSITY).sqrt();
    let text = GEAR.replace("x/shaft.length\"", &format!("cos({k:.17} [1/m]*x)\""));
    let text = text.replace("0.3\n", &format!("{}\n", 20.0 / w));
    let text = format!("{text}[guess]\n\"wheel.phi\" = {}\n", 0.03 * (k * LENGTH).cos());
    let scene = of_text(&text, Keep::Needed);
    let cut = divided(&scene, 8, 6);
    let end = 0.01 * (k * LENGTH).cos();
    for method in METHODS {
        let run = run(cut.single(), method);
        let column = |name: &str| run.column(name).expect("a column");
        let (ends, wheels, torques) = (column("end"), column("wheel"), column("torque"));
        for (row, time) in run.times.iter().enumerate() {
            let exact = end * (w * time).cos();
            let off = (ends[row] - exact).abs().max((wheels[row] - 3.0 * exact).abs());
            assert!(off < 1e-6 * end.abs(), "{method} at {time} s: {off:e}");
            let torque = 0.004 * w * w * 3.0 * exact;
            let size = 0.004 * w * w * 3.0 * end.abs();
            assert!((torques[row] - torque).abs() < 1e-5 * size, "{method} at {time} s");
        }
        let drift = run.drift.expect("it has a constraint");
        assert!(drift.after < 1e-12, "{method}: {drift:?}");
    }
}

/// The scene `drives/shaft_crank` as a chain of rotors, x = r cos(phi) + sqrt(l^2 - r^2 sin^2(phi))
/// of the slider inserted into its energies.
fn chain(elements: usize) -> ModelSimulator {
    let mut text = String::from(
        "[scene]\nname = \"chain\"\n[units.u]\nunit = \"u\"\n[run]\nuntil = 1.0\npoints = 201\n",
    );
    let (mut kinetic, mut potential, mut dissipation) =
        ("0.05 [kg m^2]*w0^2/2".to_owned(), "0 [J]".to_owned(), "0 [W]".to_owned());
    let inertia = DENSITY * LENGTH / elements as f64;
    let spring = STIFFNESS * elements as f64 / LENGTH;
    for index in 0..=elements {
        write!(text, "[define.u.coordinates.a{index}]\nunit = \"rad\"\nvelocity = \"w{index}\"\n")
            .expect("written");
        let share = if index % elements == 0 { 0.5 } else { 1.0 };
        write!(kinetic, " + {} [kg m^2]*w{index}^2/2", share * inertia).expect("written");
    }
    for index in 0..elements {
        let next = index + 1;
        write!(potential, " + {spring} [N m]*(a{next} - a{index})^2/2").expect("written");
        let damping = spring * 1e-3;
        write!(dissipation, " + {damping} [N m s]*(w{next} - w{index})^2/2").expect("written");
    }
    let end = elements;
    write!(
        text,
        r#"
[define.u.helpers.root]
expression = "sqrt(0.0625 [m^2] - 0.0064 [m^2]*sin(a{end})^2)"
unit = "m"
[define.u.helpers.speed]
expression = "-(0.08 [m]*sin(a{end}) + 0.0064 [m^2]*sin(a{end})*cos(a{end})/root)*w{end}"
unit = "m/s"
[define.u.energy]
kinetic = "{kinetic} + 5 [kg]*speed^2/2"
potential = "{potential}"
dissipation = "{dissipation} + 30 [N s/m]*speed^2/2"
[[define.u.forces]]
coordinate = "a0"
expression = "12 [N m] - 0.4 [N m s]*w0"
[outputs]
motor = "u.w0"
crank = "u.a{end}"
crank_speed = "u.w{end}"
slider = {{ expression = "0.08 [m]*cos(u.a{end}) + u.root", unit = "m" }}
"#
    )
    .expect("written");
    of_text(&text, Keep::All)
}

const COLUMNS: [&str; 4] = ["motor", "crank", "crank_speed", "slider"];

/// Returns the largest difference of every column, relative to the largest value of the second run.
fn off(found: &Trajectory, exact: &Trajectory) -> Vec<f64> {
    let off = |name: &&str| {
        let [found, exact] = [found, exact].map(|run| run.column(name).expect("a column"));
        let size = exact.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let off = |(found, exact): (&f64, &f64)| (found - exact).abs() / size;
        found.iter().zip(exact).map(off).fold(0.0, f64::max)
    };
    COLUMNS.iter().map(off).collect()
}

#[test]
fn a_constrained_crank_on_a_shaft_moves_as_on_a_chain_by_every_method() {
    let chain = chain(6);
    let exact = run(chain.single(), Method::Dop853);
    let scene = of_specs("drives/shaft_crank", Keep::Needed);
    let cut = divided(&scene, 6, 1);
    for method in METHODS {
        let run = run(cut.single(), method);
        let off = off(&run, &exact);
        assert!(off.iter().all(|off| *off < 3e-6), "{method}: {off:?}");
        let drift = run.drift.expect("it has a constraint");
        assert!(drift.after < 1e-12, "{method}: {drift:?}");
        let (rejected, steps) = (run.work.rejected, run.work.steps);
        assert!(4 * rejected < steps, "{method}: {rejected} rejected beside {steps}");
    }
}

#[test]
fn chains_with_a_crank_converge_to_a_shaft_with_a_constraint_at_second_order() {
    let scene = of_specs("drives/shaft_crank", Keep::Needed);
    let exact = run(divided(&scene, 6, 4).single(), Method::Dop853);
    let errors: Vec<Vec<f64>> = [6, 12, 24]
        .map(|elements| off(&run(chain(elements).single(), Method::Dop853), &exact))
        .to_vec();
    for (column, name) in COLUMNS.iter().enumerate() {
        let error = |level: usize| errors[level][column];
        for level in [1, 2] {
            let order = (error(level - 1) / error(level)).log2();
            assert!((order - 2.0).abs() < 0.2, "{name}: order {order}, {errors:?}");
        }
        assert!(error(2) < 2e-3, "{name}: {errors:?}");
    }
}

//! First-order states and modes of the scene itself, against closed forms.

use machinist::{Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Simulator};
use machinist_model::ModelSimulator;

use crate::own_scene::{of_text, refusal};

fn run(scene: &ModelSimulator) -> Trajectory {
    Simulation::new(scene).run().expect("it runs")
}

fn off(run: &Trajectory, name: &str, exact: impl Fn(f64) -> f64) -> f64 {
    let values = run.column(name).unwrap_or_else(|| panic!("no column {name}"));
    let errors = run.times.iter().zip(values).map(|(t, value)| (value - exact(*t)).abs());
    errors.fold(0.0, |most: f64, error| if error.is_nan() { error } else { most.max(error) })
}

const RUN: &str = "[run]\nuntil = 2.0\npoints = 101\nrtol = 1e-10\nmethod = \"auto\"\n";

/// A mass that a controller of the scene brings to a speed, while the scene adds up its losses.
const DRIVE: &str = r#"
[scene]
name = "drive"

[units.cart]
unit = "translational/mass"
parameters = { mass = 2 }

[units.guide]
unit = "translational/damper"
parameters = { damping = 3 }

[units.wall]
unit = "translational/fixed"

[[joints]]
connect = ["cart.a", "guide.a"]
[[joints]]
connect = ["guide.b", "wall.a"]

[parameters]
wanted = { value = 5, unit = "m/s" }
gain = { value = 40, unit = "N/m" }

[states.integral]
unit = "m"
rate = "wanted - cart.v"
doc = "integral of the error"

[states.lost]
unit = "J"
rate = "3 [N s/m]*cart.v^2"
initial = "1 [J]"
scale = 10

[[forces]]
port = "cart.a"
expression = "gain*integral"

[initial]
integral = 0.1

[outputs]
speed = "cart.v"
losses = "lost"
integral_of_error = "integral"

[checks.ends]
of = "lost"
values = [[0, 1]]
tolerance = 1e-9
source = "where it starts"
"#;

#[test]
fn a_controller_and_a_sum_of_losses_need_no_unit() {
    let scene = of_text(&format!("{DRIVE}{RUN}"), Keep::Needed);
    let names: Vec<&str> = (0..scene.shape().states()).map(|k| scene.state(k).name).collect();
    assert!(names.contains(&"integral") && names.contains(&"lost"), "{names:?}");
    let run = run(&scene);
    // e = wanted - v: 2 e' + 3 e + 40 z = 15, z' = e, from v = 0 and z = 0.1.
    let (half, rest) = (0.75, 0.375);
    let frequency = f64::sqrt(20.0 - half * half);
    let z = |t: f64| {
        let (start, rate) = (0.1 - rest, 5.0);
        let swing = start * (frequency * t).cos()
            + (rate + half * start) / frequency * (frequency * t).sin();
        rest + (-half * t).exp() * swing
    };
    assert!(off(&run, "integral_of_error", z) < 1e-8);
    // The lost energy is the supplied work minus the kinetic energy.
    let rows = run.times.len();
    let column = |name: &str| run.column(name).expect("a column");
    let mut supplied = 0.0;
    let step = run.times[1] - run.times[0];
    let power = |row: usize| 40.0 * column("integral_of_error")[row] * column("speed")[row];
    for row in (0..rows - 2).step_by(2) {
        supplied += step / 3.0 * (power(row) + 4.0 * power(row + 1) + power(row + 2));
    }
    let kept = column("speed")[rows - 1].powi(2);
    assert!((column("losses")[rows - 1] - 1.0 - (supplied - kept)).abs() < 1e-4 * supplied);
}

/// The same with states in a separate unit.
#[test]
fn states_of_a_scene_are_those_of_a_unit_bit_for_bit() {
    let own = of_text(&format!("{DRIVE}{RUN}"), Keep::Needed);
    let text = DRIVE
        .replace("[states.integral]", "[define.control.states.integral]")
        .replace("rate = \"wanted - cart.v\"", "rate = \"error\"")
        .replace("[states.lost]", "[define.control.states.lost]")
        .replace("rate = \"3 [N s/m]*cart.v^2\"", "rate = \"loss\"")
        .replace("gain*integral", "gain*control.integral")
        .replace("[initial]\nintegral", "[initial]\n\"control.integral\"")
        .replace("losses = \"lost\"", "losses = \"control.lost\"")
        .replace("error = \"integral\"", "error = \"control.integral\"")
        .replace("of = \"lost\"", "of = \"control.lost\"");
    let inputs = "inputs = { error = \"wanted - cart.v\", loss = \"3 [N s/m]*cart.v^2\" }";
    let unit = format!(
        "[units.control]\nunit = \"control\"\n{inputs}\n\
         [define.control.inputs]\nerror = {{ unit = \"m/s\" }}\nloss = {{ unit = \"W\" }}\n"
    );
    let by_unit = of_text(&format!("{text}{RUN}{unit}"), Keep::Needed);
    let (ours, theirs) = (run(&own), run(&by_unit));
    for name in ["speed", "losses", "integral_of_error"] {
        assert_eq!(ours.column(name), theirs.column(name), "{name}");
    }
}

/// T' = -T/tau, and 4 K/s more while the heater is on: on below 10 K, off above 12 K.
#[test]
fn a_scene_switches_modes_of_its_own() {
    let text = format!(
        "[scene]\nname = \"thermostat\"\n\
         [units.dummy]\nunit = \"translational/mass\"\n\
         [states.warmth]\nunit = \"K\"\ninitial = 11\n\
         rate = \"-warmth/10 [s] + piecewise(heats < 1, 0, 4)*1 [K/s]\"\n\
         [modes.heats]\ninitial = 0\n\
         [events.on]\nguard = \"warmth - 10 [K]\"\ndirection = \"falling\"\nwhen = {{ heats = 0 }}\n\
         set = {{ heats = 1 }}\n\
         [events.off]\nguard = \"warmth - 12 [K]\"\ndirection = \"rising\"\nwhen = {{ heats = 1 }}\n\
         set = {{ heats = 0 }}\n\
         [outputs]\ntemperature = \"warmth\"\n{RUN}"
    );
    let run = run(&of_text(&text.replace("until = 2.0", "until = 20.0"), Keep::Needed));
    let (heating, cooling) = (10.0 * f64::ln(30.0 / 28.0), 10.0 * f64::ln(1.2));
    let mut time = 10.0 * f64::ln(1.1);
    assert!(run.switches.len() > 10, "{}", run.switches.len());
    for (number, switch) in run.switches.iter().enumerate() {
        let expected = ["on", "off"][number % 2];
        assert_eq!(switch.event, expected);
        assert!((switch.time - time).abs() < 1e-8, "{expected} at {}, not {time}", switch.time);
        time += if number % 2 == 0 { heating } else { cooling };
    }
}

/// A capacitor that is charged through a resistor, written down in the scene alone.
#[test]
fn power_of_the_states_of_a_scene_balances() {
    let text = format!(
        "[scene]\nname = \"charged\"\n[units.dummy]\nunit = \"translational/mass\"\n\
         [parameters]\nsource = {{ value = 10, unit = \"V\" }}\n\
         ohms = {{ value = 4, unit = \"ohm\" }}\nfarads = {{ value = 0.1, unit = \"F\" }}\n\
         [helpers.current]\nexpression = \"(source - charge/farads)/ohms\"\nunit = \"A\"\n\
         [states.charge]\nunit = \"C\"\nrate = \"current\"\n\
         [energy]\nstored = \"charge^2/(2*farads)\"\n\
         [power]\nsupplied = \"source*current\"\ndissipated = \"ohms*current^2\"\n\
         [outputs]\nq = \"charge\"\n{RUN}"
    );
    let scene = of_text(&text, Keep::Needed);
    let run = run(&scene);
    assert!(off(&run, "q", |t| 1.0 - (-t / 0.4).exp()) < 1e-9);
    let simulation = Simulation::new(&scene);
    let parameters = simulation.parameter_values();
    let at = (0..scene.shape().states()).position(|k| scene.state(k).name == "charge");
    for charge in [0.0, 0.3, 1.0, 2.0] {
        let mut state = vec![0.0; scene.shape().states()];
        state[at.expect("the charge")] = charge;
        let balance = scene.power_balance(0.0, &state, parameters);
        assert!(balance.residual().abs() < 1e-12, "{charge}: {}", balance.residual());
    }
}

#[test]
fn states_that_a_scene_cannot_have_are_refused() {
    let with = |more: &str| refusal(&format!("{DRIVE}{RUN}{more}"));
    let twice = DRIVE.replace("losses = \"lost\"", "lost = \"lost\"");
    assert!(refusal(&format!("{twice}{RUN}")).contains("`lost` is both a state and an output"));
    let said = with("[states.gain]\nunit = \"m\"\nrate = \"cart.v\"\n");
    assert!(said.contains("the name `gain` is given twice"), "{said}");
    let said = with("[states.way]\nunit = \"m\"\nrate = \"cart.x\"\n");
    assert!(said.contains("the rate of `way`"), "{said}");
    let said = with("[states.way]\nunit = \"m\"\nrate = \"cart.acceleration\"\n");
    assert!(said.contains("depends on an acceleration"), "{said}");
}

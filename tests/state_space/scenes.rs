//! Models of scenes against the frequency response of an orthonormal null space, against runs of
//! the nonlinear machine, and against closed forms.

use machinist::Simulation;
use machinist::linear_analysis::{
    Hold, LinearError, Linearization, Place, Point, RegulatorError, StateSpace, Weight,
    operating_point,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use crate::own_scene::{model_of_specs, of_specs, of_text, scenes_to_try, system_of};

/// Scenes that the sweep tries by default: constraints, brakes, motors, controllers, springs.
const SOME: [&str; 12] = [
    "pendulum_constrained",
    "four_bar",
    "slider_crank",
    "two_mass",
    "motor_run_up",
    "saw_gin",
    "stick_slip",
    "drives/winch",
    "parts/rotational/brake",
    "parts/rotational/differential",
    "parts/planar/link",
    "parts/control/pid_controller",
];

fn matrix(rows: &[Vec<f64>], columns: usize) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns, |row, column| rows[row][column])
}

/// Returns C (s - A)^-1 B + D of one input and output.
fn transfer(model: &StateSpace, from: usize, to: usize, frequency: f64) -> Option<Complex64> {
    let n = model.states.len();
    if n == 0 {
        return Some(Complex64::from(model.d[to][from]));
    }
    let mut whole = matrix(&model.a, n).map(|value| Complex64::from(-value));
    (0..n).for_each(|index| whole[(index, index)] += Complex64::new(0.0, frequency));
    let b = DVector::from_fn(n, |row, _| Complex64::from(model.b[row][from]));
    let x = whole.lu().solve(&b)?;
    let sum = model.c[to].iter().zip(x.iter()).map(|(c, x)| x * *c).sum::<Complex64>();
    Some(sum + model.d[to][from])
}

/// Returns names of parameters that no constraint depends on, and of all outputs.
fn signals(linearization: &Linearization<'_>) -> (Vec<String>, Vec<String>) {
    let simulator = linearization.simulator();
    let shape = simulator.shape();
    let outputs: Vec<String> =
        (0..shape.outputs).map(|index| simulator.output(index).name.to_owned()).collect();
    let parameters = (0..shape.parameters).map(|index| simulator.parameter(index).name.to_owned());
    let fits =
        |name: &String| linearization.state_space(std::slice::from_ref(name), &outputs).is_ok();
    (parameters.filter(fits).collect(), outputs)
}

/// The response uses orthonormal coordinates of the null spaces, of all positions and velocities;
/// the model those of independent coordinates. In equilibrium both have the same responses.
#[test]
fn models_of_independent_coordinates_have_the_responses_of_orthonormal_ones() {
    let (mut compared, mut mistakes) = (0, Vec::new());
    for name in scenes_to_try("MACHINIST_STATE_SPACE", &SOME) {
        if !model_of_specs(&name, Keep::Needed).fields.is_empty() {
            continue;
        }
        let simulator = of_specs(&name, Keep::Needed);
        let run = Simulation::new(simulator.single());
        let Ok(point) = operating_point(&run, Place::Equilibrium) else { continue };
        let Ok(linearization) = Linearization::at(simulator.single(), point) else { continue };
        let (inputs, outputs) = signals(&linearization);
        if !inputs.is_empty() && !outputs.is_empty() {
            let model = linearization.state_space(&inputs, &outputs).expect("each fits alone");
            compared += compare(&name, &linearization, &model, &mut mistakes);
        }
    }
    assert!(mistakes.is_empty(), "{mistakes:#?}");
    println!("{compared} responses");
    assert!(compared > 200, "{compared} responses");
}

/// Every entry of A, B, C and D, at the start and on the way, where machines with constraints turn
/// and accelerate: the dependent coordinates follow from the constraints by Newton's method.
#[test]
fn models_are_the_differences_of_rates_and_outputs_on_the_constraints() {
    let (mut columns, mut mistakes) = (0, Vec::new());
    for name in scenes_to_try("MACHINIST_STATE_SPACE", &SOME) {
        if !model_of_specs(&name, Keep::Needed).fields.is_empty() {
            continue;
        }
        let simulator = of_specs(&name, Keep::Needed);
        let simulator = simulator.single();
        let defaults = simulator.run_defaults();
        let middle = defaults.from + 0.37 * (defaults.until - defaults.from);
        for place in [Place::Initial, Place::Time(middle)] {
            let Ok(point) = operating_point(&Simulation::new(simulator), place) else { continue };
            let Ok(linearization) = Linearization::at(simulator, point) else { continue };
            let (mut inputs, outputs) = signals(&linearization);
            inputs.truncate(4);
            let model = linearization.state_space(&inputs, &outputs).expect("each fits alone");
            let manifold = Manifold::new(simulator, linearization.point(), &model);
            columns += manifold.compare(&name, &model, &mut mistakes);
        }
    }
    assert!(mistakes.is_empty(), "{mistakes:#?}");
    println!("{columns} columns");
    assert!(columns > 100, "{columns} columns");
}

/// States that fulfil the constraints, by independent entries of the state.
struct Manifold<'a> {
    simulator: &'a dyn Simulator<f64>,
    point: &'a Point,
    /// Entries of the state in the model, and the others but modes.
    kept: Vec<usize>,
    dependent: Vec<usize>,
}

impl<'a> Manifold<'a> {
    fn new(simulator: &'a dyn Simulator<f64>, point: &'a Point, model: &StateSpace) -> Self {
        let index = |name: &str| {
            (0..point.state.len()).find(|at| simulator.state(*at).name == name).expect("a state")
        };
        let kept: Vec<usize> = model.states.iter().map(|state| index(&state.name)).collect();
        let dependent = model.eliminated.iter().map(|name| index(name)).collect();
        Self { simulator, point, kept, dependent }
    }

    /// Returns the state with some independent entries changed, dependent ones by Gauss-Newton
    /// steps in positions, then in velocities.
    fn state(&self, change: Option<(usize, f64)>) -> Vec<f64> {
        let mut state = self.point.state.clone();
        if let Some((entry, by)) = change {
            state[self.kept[entry]] += by;
        }
        let (count, n) = (self.simulator.constraints(), self.simulator.shape().coordinates);
        let Point { time, parameters, .. } = self.point;
        for level in 0..2 {
            let within = |entry: &&usize| (**entry >= n) == (level == 1);
            let moved: Vec<usize> = self.dependent.iter().filter(within).copied().collect();
            for _ in 0..if moved.is_empty() { 0 } else { 8 } {
                let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
                self.simulator.constraint_values(*time, &state, parameters, &mut values);
                self.simulator.constraint_rates(*time, &state, parameters, &mut rates);
                let pattern = self.simulator.constraint_matrix_pattern();
                let mut entries = vec![0.0; pattern.entries.len()];
                self.simulator.constraint_matrix(*time, &state, parameters, &mut entries);
                let mut matrix = DMatrix::zeros(count, moved.len());
                let mut holds = vec![false; count];
                for ((row, column), value) in pattern.entries.iter().zip(&entries) {
                    holds[*row as usize] |= *value != 0.0;
                    let place = moved.iter().position(|at| *at == *column as usize + level * n);
                    if let Some(place) = place {
                        matrix[(*row as usize, place)] = *value;
                    }
                }
                // Sticking friction and closed clutches hold positions as they are.
                let moved_by = |row: usize| -> f64 {
                    let entries = pattern.entries.iter().zip(&entries);
                    let of_row = entries.filter(|((of, _), _)| *of as usize == row);
                    let change = |at: usize| state[at] - self.point.state[at];
                    of_row.map(|((_, at), value)| value * change(*at as usize)).sum()
                };
                let mut residual = DVector::zeros(count);
                for row in 0..count {
                    let constraint = self.simulator.constraint(row);
                    residual[row] = match level {
                        _ if !holds[row] => 0.0,
                        1 => rates[row],
                        _ if constraint.is_of_positions => values[row],
                        _ if constraint.in_modes => moved_by(row),
                        _ => {
                            matrix.row_mut(row).fill(0.0);
                            0.0
                        }
                    };
                }
                let step = matrix.svd(true, true).solve(&residual, 1e-12).expect("vectors");
                moved.iter().zip(step.iter()).for_each(|(at, step)| state[*at] -= step);
            }
        }
        state
    }

    /// Returns rates of the kept entries and all outputs, and signs of the switching surfaces.
    fn values(&self, state: &[f64], parameters: &[f64]) -> (Vec<f64>, Vec<bool>) {
        let time = self.point.time;
        let mut rate = vec![0.0; state.len()];
        self.simulator.rate(time, state, parameters, &mut rate);
        let mut outputs = vec![0.0; self.simulator.shape().outputs];
        self.simulator.outputs(time, state, parameters, &mut outputs);
        let mut guards = vec![0.0; self.simulator.kinks()];
        self.simulator.kink_guards(time, state, parameters, &mut guards);
        let signs = guards.iter().map(|guard| *guard > 0.0).collect();
        (self.kept.iter().map(|at| rate[*at]).chain(outputs).collect(), signs)
    }

    /// Compares the columns of a model; returns their number.
    fn compare(&self, scene: &str, model: &StateSpace, mistakes: &mut Vec<String>) -> usize {
        let n = self.kept.len();
        let parameters = &self.point.parameters;
        let (of_states, of_inputs) = sizes(self.simulator, model);
        let all_sizes = [of_states, of_inputs].concat();
        let entry = |row: usize, column: usize| match (row < n, column < n) {
            (true, true) => model.a[row][column],
            (true, false) => model.b[row][column - n],
            (false, true) => model.c[row - n][column],
            (false, false) => model.d[row - n][column - n],
        };
        let mut compared = 0;
        for column in 0..n + model.inputs.len() {
            let name = match column.checked_sub(n) {
                None => model.states[column].name.clone(),
                Some(input) => model.inputs[input].name.clone(),
            };
            let size = all_sizes[column];
            let at = |step: f64| {
                if column < n {
                    return self.values(&self.state(Some((column, step))), parameters);
                }
                let count = parameters.len();
                let index = (0..count).find(|at| self.simulator.parameter(*at).name == name);
                let mut changed = parameters.clone();
                changed[index.expect("a parameter")] += step;
                self.values(&self.point.state, &changed)
            };
            let differences: Vec<_> =
                [1e-3, 1e-4, 1e-5].into_iter().filter_map(|h| slopes(h * size, at)).collect();
            let rows = differences.first().map_or(0, Vec::len);
            for row in 0..rows {
                let found = entry(row, column);
                let effects = (0..all_sizes.len()).map(|at| (entry(row, at) * all_sizes[at]).abs());
                let most = effects.fold(0.0, f64::max) / size;
                // Effects below 1e-10 units of a typical change are not compared.
                let is_near = |(slope, rounding): &(f64, f64)| {
                    let least = rounding + 1e-10 * most + 1e-10 / size;
                    (found - slope).abs() <= 1e-6 * slope.abs() + least
                };
                if !differences.iter().any(|slopes| is_near(&slopes[row])) {
                    let slopes: Vec<f64> = differences.iter().map(|slopes| slopes[row].0).collect();
                    let time = self.point.time;
                    mistakes.push(format!(
                        "{scene} at {time} s, row {row} by {name}: {found:e}, not {slopes:?}"
                    ));
                }
            }
            compared += usize::from(rows > 0);
        }
        compared
    }
}

/// Returns differences of sixth order with their rounding errors; `None` across a switching
/// surface.
fn slopes(h: f64, at: impl Fn(f64) -> (Vec<f64>, Vec<bool>)) -> Option<Vec<(f64, f64)>> {
    let samples = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|k| at(k * h));
    if samples.iter().any(|(_, signs)| *signs != samples[0].1) {
        return None;
    }
    let slope = |row: usize| {
        let [a, b, c, d, e, f] = samples.each_ref().map(|(values, _)| values[row]);
        let largest = [a, b, c, d, e, f].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        (((f - a) - 9.0 * (e - b) + 45.0 * (d - c)) / (60.0 * h), 1e-14 * largest / h)
    };
    Some((0..samples[0].0.len()).map(slope).collect())
}

/// Compares responses at three frequencies and returns their number.
fn compare(
    scene: &str,
    linearization: &Linearization<'_>,
    model: &StateSpace,
    mistakes: &mut Vec<String>,
) -> usize {
    const FREQUENCIES: [f64; 3] = [0.7, 11.0, 230.0];
    let (scales, sizes) = sizes(linearization.simulator(), model);
    let mut compared = 0;
    for (from, input) in model.inputs.iter().enumerate().take(6) {
        for (to, output) in model.outputs.iter().enumerate().take(6) {
            let Ok(response) = linearization.response(&input.name, &output.name, &FREQUENCIES)
            else {
                continue;
            };
            // What a millionth of a millionth of a typical change of all states shows is rounding.
            let moved = model.c[to].iter().zip(&scales).map(|(c, scale)| (c * scale).abs());
            let least = moved.sum::<f64>().max(1e-3) / sizes[from] * 1e-12;
            for (at, frequency) in FREQUENCIES.iter().enumerate() {
                let wanted = Complex64::from_polar(response.amplitudes[at], response.phases[at]);
                let Some(found) = transfer(model, from, to, *frequency) else { continue };
                // Sums of large terms that cancel are as accurate as the terms.
                let size = wanted.norm().max(1e-9 * terms(model, from, to));
                if (found - wanted).norm() > 1e-7 * size + least {
                    let names = format!("{} to {}", input.name, output.name);
                    mistakes
                        .push(format!("{scene}: {names} at {frequency}: {found}, not {wanted}"));
                }
                compared += 1;
            }
        }
    }
    compared
}

/// Returns typical sizes of states and inputs.
fn sizes(simulator: &dyn Simulator<f64>, model: &StateSpace) -> (Vec<f64>, Vec<f64>) {
    let scale = |name: &str| {
        let states = 0..simulator.shape().states();
        let mut found = states.filter(|at| simulator.state(*at).name == name);
        simulator.state_scale(found.next().expect("a state"))
    };
    let states = model.states.iter().map(|state| scale(&state.name)).collect();
    let of_input = |value: f64| if value == 0.0 { 1.0 } else { value.abs() };
    (states, model.inputs.iter().map(|input| of_input(input.value)).collect())
}

/// Returns the size of the terms of a response.
fn terms(model: &StateSpace, from: usize, to: usize) -> f64 {
    let pairs = model.c[to].iter().zip(&model.b);
    pairs.map(|(c, b)| (c * b[from]).abs()).sum::<f64>() + model.d[to][from].abs()
}

/// A ball of 0.3 kg that hangs by a rod of 0.7 m from a trolley of 2 kg, which a force moves.
const CRANE: &str = r#"
[scene]
name = "crane"
title = "A ball that hangs from a trolley"

[units]
trolley = { unit = "translational/mass", parameters = { mass = 2 } }
ball = { unit = "planar/particle", parameters = { mass = 0.3 } }
drive = { unit = "sources/force", inputs = { force = "pull" } }

[[joints]]
connect = ["drive.a", "trolley.a"]

[parameters]
pull = { value = 0, unit = "N", doc = "force on the trolley" }
length = { value = 0.7, unit = "m", doc = "length of the rod" }

[constraints.rod]
expression = "((ball.x - trolley.x)^2 + ball.y^2 - length^2)/(2*length)"
doc = "length of the rod"

[guess]
"ball.y" = -0.7

[outputs]
way = "trolley.x"
lead = { expression = "ball.x - trolley.x", unit = "m", doc = "way of the ball before the trolley" }
acceleration = { expression = "trolley.acceleration", unit = "m/s^2", doc = "acceleration of the trolley" }
tension = { expression = "rod", unit = "N", doc = "force of the rod" }

[run]
until = 1.0
points = 101
rtol = 1e-11
method = "dop853"
"#;

const MASS: f64 = 2.0;
const BALL: f64 = 0.3;
const LENGTH: f64 = 0.7;
const GRAVITY: f64 = 9.81;

fn at_start(simulator: &dyn Simulator<f64>) -> Linearization<'_> {
    let point = operating_point(&Simulation::new(simulator), Place::Initial).expect("a start");
    Linearization::at(simulator, point).expect("it is regular")
}

fn close(found: f64, wanted: f64) {
    assert!((found - wanted).abs() <= 1e-12 * wanted.abs().max(1e-3), "{found}, not {wanted}");
}

#[test]
fn a_crane_by_a_constraint_has_the_model_of_two_coordinates() {
    let crane = of_text(CRANE, Keep::Needed);
    let linearization = at_start(&crane);
    let outputs = ["way", "lead", "acceleration", "tension"];
    let model = linearization.state_space(&["pull"], &outputs).expect("a model");
    let names: Vec<&str> = model.states.iter().map(|state| state.name.as_str()).collect();
    assert_eq!(names, ["trolley.x", "ball.x", "trolley.v", "ball.v_x"]);
    assert_eq!(model.eliminated, ["ball.y", "ball.v_y"]);
    let (swing, pulled) = (GRAVITY / LENGTH, BALL * GRAVITY / LENGTH / MASS);
    let a = [
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [-pulled, pulled, 0.0, 0.0],
        [swing, -swing, 0.0, 0.0],
    ];
    let c = [[1.0, 0.0, 0.0, 0.0], [-1.0, 1.0, 0.0, 0.0], a[2], [0.0; 4]];
    for (row, (found, seen)) in model.a.iter().zip(&model.c).enumerate() {
        for column in 0..4 {
            close(found[column], a[row][column]);
            close(seen[column], c[row][column]);
        }
    }
    let b: Vec<f64> = model.b.iter().map(|row| row[0]).collect();
    let d: Vec<f64> = model.d.iter().map(|row| row[0]).collect();
    for found in [b, d] {
        for (found, wanted) in found.into_iter().zip([0.0, 0.0, 1.0 / MASS, 0.0]) {
            close(found, wanted);
        }
    }
    close(model.outputs[3].value.abs(), BALL * GRAVITY);

    // From the force to the trolley: zeros where the ball swings alone. The tension shows nothing.
    let way = linearization.state_space(&["pull"], &["way"]).expect("a model");
    let zeros = way.zeros().expect("zeros");
    assert_eq!(zeros.len(), 2);
    for zero in &zeros {
        close(zero.im.abs(), swing.sqrt());
    }
    let poles = way.poles().expect("poles");
    assert_eq!(poles[..2], [Complex64::ZERO; 2]);
    close(poles[2].im.abs(), (swing * (1.0 + BALL / MASS)).sqrt());
    assert!(way.uncontrollable().expect("modes").is_empty());
    assert!(way.unobservable().expect("modes").is_empty());
    let tension = linearization.state_space(&["pull"], &["tension"]).expect("a model");
    assert_eq!(tension.unobservable().expect("modes").len(), 3);
}

#[test]
fn a_sampled_model_follows_the_run_of_the_machine() {
    let crane = of_text(CRANE, Keep::Needed);
    let model = at_start(&crane).state_space(&["pull"], &["way", "lead", "acceleration"]);
    let sampled = model.expect("a model").sampled(0.01, Hold::Zoh).expect("samples");
    let pull = 1e-3;
    let run = Simulation::new(&crane).parameter("pull", pull).expect("a parameter").run();
    let run = run.expect("a run");
    let n = sampled.states.len();
    let (a, b) = (matrix(&sampled.a, n), matrix(&sampled.b, 1));
    let (c, d) = (matrix(&sampled.c, n), matrix(&sampled.d, 1));
    let mut x = DVector::zeros(n);
    for row in 0..=100 {
        let y = &c * &x + d.column(0) * pull;
        for (column, name) in ["way", "lead", "acceleration"].iter().enumerate() {
            let values = run.column(name).expect("an output");
            // The machine deviates from its model with the square of the force.
            let off = (values[row] - y[column]).abs();
            assert!(off <= 1e-9, "{name} in row {row}: {} and {}", values[row], y[column]);
        }
        x = &a * x + b.column(0) * pull;
    }
}

#[test]
fn a_test_force_shows_the_feedthrough_to_accelerations() {
    let crane = of_text(CRANE, Keep::Needed);
    let refused = at_start(&crane).state_space(&["ball.x"], &["acceleration"]);
    assert!(matches!(refused, Err(LinearError::DirectFeedthrough { .. })), "{refused:?}");

    // The rod stands at an angle of arcsin 3/5 from the vertical, so its force turns with it.
    let tilted = CRANE.to_owned() + "\n[initial]\n\"ball.x\" = 0.42\n\"trolley.x\" = 0\n";
    let mut system = system_of(&tilted);
    assert!(system.add_test_force("ball.x") && !system.add_test_force("ball.z"));
    let model = machinist_codegen::pipeline::compile(system, Keep::Needed).expect("a model");
    let crane = machinist_model::ModelSimulator::new(model);
    let found = at_start(&crane).state_space(&["ball.x"], &["acceleration", "tension"]);
    let found = found.expect("a model");
    assert_eq!(found.inputs[0].name, "force on ball.x");
    assert_eq!(found.inputs[0].unit, "N");
    // Along the rod, unit e = (s, -c), G = (-s, s, -c): the multiplier l of G a = 0 with
    // M a = F + G^T l is l = -s/m/(s^2/M + 1/m).
    let sine = 0.6;
    let multiplier = -(sine / BALL) / (sine * sine / MASS + 1.0 / BALL);
    close(found.d[0][0], -sine * multiplier / MASS);
    close(found.d[1][0], multiplier);
}

#[test]
fn what_no_input_moves_and_no_output_shows_is_named() {
    let scene = of_text(&twins(), Keep::Needed);
    let model = at_start(&scene).state_space(&["pull"], &["hub.x", "alone.x"]).expect("a model");
    let hidden = model.uncontrollable().expect("modes");
    // The twins against each other, and the mass by itself, whose motions are aperiodic.
    assert_eq!(hidden.len(), 3, "{hidden:?}");
    let twins: Vec<_> = hidden.iter().filter(|hidden| hidden.pole[1] > 0.0).collect();
    let [twins] = twins[..] else { panic!("{hidden:?}") };
    close(twins.pole[0], -1.0 / 3.0);
    let share = |name: &str| {
        let at = model.states.iter().position(|state| state.name == name).expect("a state");
        twins.shares[at]
    };
    assert!((share("left.x") - share("right.x")).abs() < 1e-9);
    assert!(share("hub.x") < 1e-15 && share("alone.x") < 1e-15);
    assert!(model.named(twins).contains("left."), "{}", model.named(twins));
    let unseen = model.unobservable().expect("modes");
    assert_eq!(unseen.len(), 1);
    close(unseen[0].pole[0], -1.0 / 3.0);
    // It decays by itself, so a regulator exists; the mass alone cannot be given a cost it lowers.
    let weight = |name: &str| Weight { name: name.to_owned(), deviation: 1.0 };
    let regulator = model.lqr(&[weight("pull"), weight("hub.x")]).expect("a regulator");
    assert!(regulator.poles.iter().all(|pole| pole[0] < 0.0));
}

/// Returns the scene of two equal masses on equal springs beside a driven one, and one by itself.
fn twins() -> String {
    let joints = [
        ("drive.a", "hub.a"),
        ("hub.a", "to_left.a"),
        ("to_left.b", "left.a"),
        ("hub.a", "to_right.a"),
        ("to_right.b", "right.a"),
        ("hub.a", "to_hub.a"),
        ("to_hub.b", "ground.a"),
        ("alone.a", "aside.a"),
        ("aside.b", "place.a"),
    ];
    let joints = joints.map(|(a, b)| format!("\n[[joints]]\nconnect = [\"{a}\", \"{b}\"]\n"));
    format!("{TWINS}{}", joints.concat())
}

const TWINS: &str = r#"
[scene]
name = "twins"
title = "Twins"

[units]
hub = { unit = "translational/mass", parameters = { mass = 3 } }
left = { unit = "translational/mass", parameters = { mass = 1.5 } }
right = { unit = "translational/mass", parameters = { mass = 1.5 } }
alone = { unit = "translational/mass", parameters = { mass = 1 } }
to_left = { unit = "translational/spring_damper", parameters = { stiffness = 80, damping = 1 } }
to_right = { unit = "translational/spring_damper", parameters = { stiffness = 80, damping = 1 } }
to_hub = { unit = "translational/spring_damper", parameters = { stiffness = 50, damping = 2 } }
aside = { unit = "translational/spring_damper", parameters = { stiffness = 2, damping = 3 } }
drive = { unit = "sources/force", inputs = { force = "pull" } }
ground = { unit = "translational/fixed" }
place = { unit = "translational/fixed" }

[parameters]
pull = { value = 0, unit = "N", doc = "force on the hub" }

[outputs]
way = "hub.x"
beside = "alone.x"
difference = { expression = "left.x - right.x", unit = "m", doc = "distance" }

[run]
until = 1.0
"#;

#[test]
fn a_closed_brake_leaves_no_state_but_its_feedthrough() {
    let brake = of_specs("parts/rotational/brake", Keep::Needed);
    let run = Simulation::new(brake.single());
    let point = operating_point(&run, Place::Equilibrium).expect("it stands");
    let linearization = Linearization::at(brake.single(), point).expect("it is regular");
    let (inputs, outputs) = signals(&linearization);
    let model = linearization.state_space(&inputs, &outputs).expect("a model");
    assert!(model.states.is_empty() && !model.eliminated.is_empty());
    assert!(model.poles().expect("none").is_empty() && model.zeros().expect("none").is_empty());
    assert!(model.uncontrollable().expect("none").is_empty());
    for hold in [Hold::Zoh, Hold::Tustin] {
        assert_eq!(model.sampled(0.1, hold).expect("samples").d, model.d);
    }
    let response = linearization.response(&inputs[0], &outputs[0], &[1.0]).expect("it answers");
    close(response.amplitudes[0], model.d[0][0].abs());
}

#[test]
fn designs_that_do_not_exist_are_refused_with_the_motion() {
    let crane = of_text(CRANE, Keep::Needed);
    let model = at_start(&crane).state_space(&["pull"], &["way", "tension"]).expect("a model");
    let weight = |name: &str, deviation| Weight { name: name.to_owned(), deviation };
    let refused = |weights: &[Weight]| model.lqr(weights).expect_err("no regulator");
    let unweighted = refused(&[weight("pull", 1.0), weight("tension", 1.0)]);
    assert!(
        matches!(&unweighted, RegulatorError::Unweighted { motion } if motion.contains("trolley"))
    );
    assert_eq!(refused(&[weight("way", 1.0)]), RegulatorError::NoInput);
    assert_eq!(refused(&[weight("pull", 1.0)]), RegulatorError::NoOutput);
    let negative = refused(&[weight("pull", -1.0), weight("way", 1.0)]);
    assert!(matches!(negative, RegulatorError::BadDeviation { .. }));
    let unknown = refused(&[weight("pul", 1.0), weight("way", 1.0)]);
    assert!(unknown.to_string().contains("`pull`"), "{unknown}");
    let twice = at_start(&crane).state_space(&["pull", "pull"], &["way"]).expect_err("twice");
    assert!(matches!(twice, LinearError::DuplicateName { .. }));
    let bad = model.sampled(0.0, Hold::Zoh).expect_err("no period");
    assert!(matches!(bad, LinearError::BadPeriod { .. }));
    let again = model.sampled(0.1, Hold::Zoh).expect("samples").sampled(0.1, Hold::Zoh);
    assert_eq!(again.expect_err("sampled"), LinearError::Sampled);
    let unmoved = at_start(&crane).state_space(&["length"], &["way"]);
    assert!(matches!(unmoved, Err(LinearError::MovesConstraint { .. })));
}

//! The emitted benchmark scenes against their definitions, written down by hand.

#[path = "../examples/machinist_peer/model.rs"]
mod model;

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use machinist::complex_step::ComplexStep;
use machinist::{Method, Simulation};
use machinist_bench_scenes as bench;
use machinist_contract::Real as _;
use model::Model;
use nalgebra::{DMatrix, DVector};

/// States at which rates are compared.
const POINTS: usize = 40;
/// Relative to the largest acceleration, or rate of flux, at the state.
const TOLERANCE: f64 = 1e-12;

const W0: f64 = 100.0 * PI;
const K_R: f64 = 0.952;
const K_S: f64 = 0.956;
const SIGMA: f64 = 1.0 - K_R * K_S;

/// Rate in the model's order, as a function of time and state in that order.
type Rate = Box<dyn Fn(f64, &[f64]) -> Vec<f64>>;

fn model(key: &str) -> Model {
    Model::find(key).expect("an emitted scene")
}

/// Returns the rates of the model's states: derivatives of the outputs along the rate.
fn rates(model: &Model, time: f64, state: &[f64]) -> Vec<f64> {
    let parameters = model.parameters();
    let mut rate = vec![f64::NAN; state.len()];
    model.simulator.rate(time, state, &parameters, &mut rate);
    if model.is_field() {
        return model.states(time, &rate, &parameters);
    }
    let simulator = bench::find::<ComplexStep>(&model.scene).expect("an emitted scene");
    let parameters: Vec<ComplexStep> = parameters.into_iter().map(ComplexStep::literal).collect();
    // Outputs are linear in the states, so contributions of single states add up.
    let mut rates = vec![0.0; simulator.shape().outputs];
    for (index, rate) in rate.iter().enumerate() {
        let seeded = |(place, value): (usize, &f64)| {
            if place == index {
                ComplexStep::perturbed(*value)
            } else {
                ComplexStep::literal(*value)
            }
        };
        let seeded: Vec<ComplexStep> = state.iter().enumerate().map(seeded).collect();
        let mut outputs = vec![ComplexStep::literal(f64::NAN); rates.len()];
        simulator.outputs(ComplexStep::literal(time), &seeded, &parameters, &mut outputs);
        for (sum, output) in rates.iter_mut().zip(&outputs) {
            *sum += output.derivative() * rate;
        }
    }
    rates
}

/// Compares rates at many states within the run.
fn assert_rates(key: &str, by_hand: &Rate) {
    assert_rates_of(&model(key), by_hand);
}

fn assert_rates_of(model: &Model, by_hand: &Rate) {
    let key = &model.key;
    let until = model.simulator.run_defaults().until;
    let scales = model.scales();
    for point in 0..POINTS {
        let angle = |index: usize| 1.0 + 0.7 * index as f64 + 1.3 * point as f64;
        let state: Vec<f64> =
            scales.iter().enumerate().map(|(i, scale)| scale * angle(i).sin()).collect();
        let time = until * point as f64 / POINTS as f64;
        let ours = rates(model, time, &state);
        let exact = by_hand(time, &model.states(time, &state, &model.parameters()));
        assert_eq!(ours.len(), exact.len(), "{}", model.key);
        let largest = exact.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
        for (index, (ours, exact)) in ours.iter().zip(&exact).enumerate() {
            let error = (ours - exact).abs() / largest;
            assert!(error <= TOLERANCE, "{key}, state {index} at {time} s: {ours} is not {exact}");
        }
    }
}

fn assert_starts_from(key: &str, expected: &[f64]) {
    let model = model(key);
    let mut state = vec![f64::NAN; model.scales().len()];
    model.simulator.initial_state(&model.parameters(), &mut state);
    let states = model.states(0.0, &state, &model.parameters());
    assert_eq!(states.len(), expected.len(), "{key}");
    for (ours, exact) in states.iter().zip(expected) {
        assert!((ours - exact).abs() <= 1e-14 * exact.abs(), "{key}: {ours} is not {exact}");
    }
}

fn assert_runs_until(key: &str, until: f64) {
    let span = model(key).simulator.run_defaults();
    assert_eq!((span.from.to_bits(), span.until.to_bits()), (0, until.to_bits()), "{key}");
}

/// Returns the rates of the fluxes, and the torque.
fn motor(y: &[f64], w: f64) -> (Vec<f64>, f64) {
    let (a, r, slip) = (W0 * 0.115, W0 * 0.0858, W0 - 4.0 * w);
    let fluxes = vec![
        220.0 * SQRT_2 - a * y[0] + a * K_R * y[2] + W0 * y[1],
        -a * y[1] + a * K_R * y[3] - W0 * y[0],
        -r * y[2] + r * K_S * y[0] + slip * y[3],
        -r * y[3] + r * K_S * y[1] - slip * y[2],
    ];
    let torque = 12.0 * K_R * W0 / (2.0 * SIGMA * 4.14) * (y[2] * y[1] - y[0] * y[3]);
    (fluxes, torque)
}

/// Returns the load, divided by the sign of the speed.
fn load(t: f64, middle: f64) -> f64 {
    let speed = PI * 735.0 / 30.0;
    (843.72 + 78.78 * (PI * speed * t).sin()) / (1.0 + (-(t - middle) / 0.02).exp())
}

fn coupling(y: &[f64]) -> f64 {
    23_065.2 * (y[4] - y[6]) + 128.5346 * (y[5] - y[7])
}

fn m3(pieces: usize) -> Rate {
    let n = pieces as f64;
    let stiffness = 8e10 * 9.817e-6 / (2.322 / n);
    Box::new(move |t, y| {
        let (mut rate, torque) = motor(y, y[5]);
        let mut carried = coupling(y);
        rate.extend([y[5], (torque - carried) / 4.20]);
        for piece in 1..=pieces {
            let [phi, w] = [y[4 + 2 * piece], y[5 + 2 * piece]];
            let onward = if piece < pieces {
                let [next_phi, next_w] = [y[6 + 2 * piece], y[7 + 2 * piece]];
                stiffness * (phi - next_phi) + 2e-5 * stiffness * (w - next_w)
            } else {
                0.0
            };
            let resisting = load(t, 0.15) / n * (w / 0.5).tanh();
            rate.extend([w, (carried - onward - resisting) / (1.244 / n)]);
            carried = onward;
        }
        rate
    })
}

fn m4(pieces: usize) -> Rate {
    let length = 1.75 / pieces as f64;
    let polar = PI * 0.025_f64.powi(4) / 2.0;
    let stiffness = 2e11 / 2.6 * polar / length;
    let inertia = 7659.0 * polar * length;
    Box::new(move |t, y| {
        let angle = |node: usize| y[2 * node];
        let mut rate = Vec::new();
        for node in 0..=pieces {
            let at_end = node == 0 || node == pieces;
            let at_reed = node == 4 * pieces / 7;
            let mut torque = 0.0;
            if node > 0 {
                torque += stiffness * (angle(node - 1) - angle(node));
            } else {
                torque += 45_200.0 * (0.12 * (8.0 * PI * t).sin() - angle(0));
            }
            if node < pieces {
                torque -= stiffness * (angle(node) - angle(node + 1));
            }
            if at_reed {
                torque -= 15_600.0 * angle(node);
            }
            let lumped = if at_end { inertia / 2.0 } else { inertia };
            let reed = if at_reed { 3.56 * 0.12 * 0.12 } else { 0.0 };
            rate.extend([y[2 * node + 1], torque / (lumped + reed)]);
        }
        rate
    })
}

fn m6(links: usize) -> Rate {
    Box::new(move |_, y| {
        let (angle, speed) = y.split_at(links);
        let below = |i: usize, j: usize| (links - i.max(j)) as f64;
        let mass = DMatrix::from_fn(links, links, |i, j| below(i, j) * (angle[i] - angle[j]).cos());
        let force = DVector::from_fn(links, |i, _| {
            let term = |j: usize| below(i, j) * (angle[i] - angle[j]).sin() * speed[j] * speed[j];
            -(0..links).map(term).sum::<f64>() - below(i, i) * 9.81 * angle[i].sin()
        });
        let acceleration = mass.lu().solve(&force).expect("inertia");
        [speed, acceleration.as_slice()].concat()
    })
}

#[test]
fn m1_is_the_motor_alone() {
    assert_rates(
        "M1",
        &(Box::new(|_, y: &[f64]| {
            let (mut rate, torque) = motor(y, y[4]);
            rate.push(torque / 4.20);
            rate
        }) as Rate),
    );
    assert_starts_from("M1", &[0.0; 5]);
    assert_runs_until("M1", 1.0);
}

#[test]
fn m2_is_the_saw_gin() {
    assert_rates(
        "M2",
        &(Box::new(|t: f64, y: &[f64]| {
            let (mut rate, torque) = motor(y, y[5]);
            let carried = coupling(y);
            let resisting = load(t, 1.2) * (y[7] / 0.5).tanh();
            rate.extend([y[5], (torque - carried) / 4.20, y[7], (carried - resisting) / 1.244]);
            rate
        }) as Rate),
    );
    assert_starts_from("M2", &[0.0; 8]);
    assert_runs_until("M2", 2.0);
    let m2 = model("M2");
    assert_eq!(m2.simulator.shape().parameters, 1, "all but the coupling's stiffness is folded");
    assert_eq!(m2.simulator.parameter(0).name, "coupling.stiffness");
}

#[test]
fn m3_is_the_motor_on_a_shaft_that_runs_synchronously() {
    assert_rates("M3:10", &m3(10));
    let loss = 0.115 * SIGMA;
    let flux = 220.0 * SQRT_2 / W0 / (1.0 + loss * loss);
    let mut start = vec![loss * flux, -flux, K_S * loss * flux, -K_S * flux];
    start.extend([0.0, W0 / 4.0].repeat(11));
    assert_starts_from("M3:10", &start);
    assert_runs_until("M3:10", 0.5);
}

#[test]
fn m4_is_the_reed_on_a_shaft() {
    assert_rates("M4:7", &m4(7));
    assert_starts_from("M4:7", &[0.0; 16]);
    assert_runs_until("M4:7", 0.5);
}

#[test]
fn models_of_any_size_are_fields_of_elements_of_order_one() {
    for pieces in [2, 10, 100] {
        let key = format!("M3:{pieces}");
        assert_rates_of(&Model::of_field(&key).expect("a field"), &m3(pieces));
    }
    for pieces in [7, 70] {
        let key = format!("M4:{pieces}");
        assert_rates_of(&Model::of_field(&key).expect("a field"), &m4(pieces));
    }
    let (field, written_out) = (Model::of_field("M3:10").expect("a field"), model("M3:10"));
    let start = |model: &Model| {
        let mut state = vec![f64::NAN; model.scales().len()];
        model.simulator.initial_state(&model.parameters(), &mut state);
        model.states(0.0, &state, &model.parameters())
    };
    for (ours, exact) in start(&field).iter().zip(start(&written_out)) {
        assert!((ours - exact).abs() <= 1e-14 * exact.abs(), "{ours} is not {exact}");
    }
    assert_runs_until("M3:100", 0.5);
    assert_runs_until("M4:70", 0.5);
}

#[test]
fn a_field_and_the_same_chain_written_out_have_one_exact_solution() {
    let ends = [Model::of_field("M4:7").expect("a field"), model("M4:7")].map(|model| {
        let run = Simulation::new(model.simulator).method(Method::Exact).points(2);
        let end = run.run().expect("a linear machine");
        let count = model.simulator.shape().states();
        let state: Vec<f64> = end.columns[..count].iter().map(|column| column.values[1]).collect();
        model.states(0.5, &state, &model.parameters())
    });
    for (index, (field, written_out)) in ends[0].iter().zip(&ends[1]).enumerate() {
        let size = [0.12, 3.0][index % 2];
        let error = (field - written_out).abs() / size;
        assert!(error < 1e-11, "state {index}: {field} is not {written_out}");
    }
}

#[test]
fn m5_is_the_winder() {
    assert_rates(
        "M5",
        &(Box::new(|t: f64, y: &[f64]| {
            let force = 25.0 * (110.0 * t).sin() + 42_000.0 * 2e-4 * (220.0 * t).sin();
            vec![y[1], (force - 95.0 * y[1] - (42_000.0 + 3800.0) * y[0]) / 2.1]
        }) as Rate),
    );
    assert_starts_from("M5", &[0.0; 2]);
    assert_runs_until("M5", 5.0);
}

#[test]
fn m6_is_the_pendulum_of_many_links() {
    for links in [2, 5, 10] {
        let key = format!("M6:{links}");
        assert_rates(&key, &m6(links));
        let start = [vec![FRAC_PI_2; links], vec![0.0; links]].concat();
        assert_starts_from(&key, &start);
        assert_runs_until(&key, 5.0);
    }
}

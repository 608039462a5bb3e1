//! Times of one rate and of one whole Jacobian, taken as those of generated C are: a
//! function that cannot be seen into is called through a pointer, from one of 16 states to
//! the next, and writes where its caller wants the numbers. What parameters decide is
//! computed once before, as methods do.

use std::hint::black_box;
use std::time::Instant;

use machinist::lanes::F64x8;
use machinist_bench_scenes as bench;
use machinist_contract::Real;
use serde_json::json;

use crate::median;
use crate::model::Model;
use crate::print;

/// States that a measurement cycles through.
const STATES: usize = 16;
/// Seconds of a sample at least, and of how many the median counts.
const SAMPLE: f64 = 0.01;
const SAMPLES: usize = 9;

/// A function of time, state and precomputed values, which writes its results.
type Function<R, const N: usize, P, const M: usize> = fn(R, &[R; N], &P, &mut [R; M]);

/// Time and state.
type Point<R, const N: usize> = (R, [R; N]);

/// Takes kind, variant, nanoseconds.
type Report<'a> = &'a dyn Fn(&str, &str, f64);

/// Prints the times of a model.
pub fn measure(model: &Model) {
    let report = |kind: &str, variant: &str, time: f64| {
        print(&model.key, &json!({"kind": kind, "variant": variant, "ns": time}));
    };
    of_scene(model, &report);
    as_object(model, &report);
}

/// Calls the emitted functions of a scene, if it is listed here and written out.
fn of_scene(model: &Model, report: Report<'_>) {
    /// One state at a time, and eight.
    macro_rules! functions {
        ($scene:ident, $before:expr, $rate:expr, $jacobian:expr) => {{
            const NONZEROS: usize = bench::$scene::RATE_JACOBIAN_PATTERN.entries.len();
            let points = points::<{ bench::$scene::STATES }>(&model.scales());
            both::<f64, _, _, NONZEROS>(report, &points, &$before, $rate, $jacobian);
            let points = in_lanes(&points);
            both::<F64x8, _, _, NONZEROS>(report, &points, &$before, $rate, $jacobian);
        }};
    }
    macro_rules! plain {
        ($scene:ident) => {
            functions!(
                $scene,
                bench::$scene::Parameters::default(),
                |t, y, p, out| *out = bench::$scene::rate(t, y, p),
                |t, y, p, out| *out = bench::$scene::rate_jacobian(t, y, p)
            )
        };
    }
    macro_rules! prepared {
        ($scene:ident) => {
            functions!(
                $scene,
                {
                    let p = bench::$scene::Parameters::default();
                    (p, bench::$scene::prepare(&p))
                },
                |t, y, (p, c), out| *out = bench::$scene::prepared_rate(t, y, p, c),
                |t, y, (p, c), out| *out = bench::$scene::prepared_rate_jacobian(t, y, p, c)
            )
        };
    }
    match model.scene.as_str() {
        _ if model.is_field() => {}
        "m1" => plain!(m1),
        "m2" => prepared!(m2),
        "m3_10" => plain!(m3_10),
        "m4_7" => plain!(m4_7),
        "m5" => plain!(m5),
        "m6_2" => plain!(m6_2),
        "m6_5" => plain!(m6_5),
        "m6_10" => plain!(m6_10),
        _ => {}
    }
}

/// Times of rate and Jacobian, for one of the states of a call.
fn both<R: Real, const N: usize, P, const NONZEROS: usize>(
    report: Report<'_>,
    points: &[Point<R, N>; STATES],
    before: &P,
    rate: Function<R, N, P, N>,
    jacobian: Function<R, N, P, NONZEROS>,
) {
    let lanes = size_of::<R>() / size_of::<f64>();
    let variant = match lanes {
        1 => "emitted Rust".to_owned(),
        _ => format!("emitted Rust, SIMD over {lanes} states"),
    };
    report("rhs", &variant, cycling(rate, points, before) / lanes as f64);
    report("jac", &variant, cycling(jacobian, points, before) / lanes as f64);
}

/// Calls a simulator as methods do, which know nothing of its shapes.
fn as_object(model: &Model, report: Report<'_>) {
    let (simulator, parameters) = (model.simulator, model.parameters());
    let count = simulator.shape().states();
    let scales = model.scales();
    let states: Vec<Vec<f64>> = (0..STATES).map(|number| state(&scales, number)).collect();
    let mut constants = vec![0.0; simulator.constants()];
    simulator.prepare(&parameters, &mut constants);
    let (p, c) = (&parameters, &constants);
    let simulator = black_box(simulator);
    let variant = "emitted Rust, as methods call it";
    let rate = |t: f64, y: &[f64], out: &mut [f64]| simulator.prepared_rate(t, y, p, c, out);
    report("rhs", variant, cycling_slices(&states, count, rate));
    let nonzeros = simulator.rate_jacobian_pattern().entries.len();
    let jacobian =
        |t: f64, y: &[f64], out: &mut [f64]| simulator.prepared_rate_jacobian(t, y, p, c, out);
    report("jac", variant, cycling_slices(&states, nonzeros, jacobian));
}

/// Nanoseconds of a call that writes so many numbers.
fn cycling_slices(states: &[Vec<f64>], size: usize, call: impl Fn(f64, &[f64], &mut [f64])) -> f64 {
    let mut values = vec![0.0; size];
    nanoseconds(|number| {
        let number = number % STATES;
        call(time(number), &states[number], &mut values);
    })
}

/// A state of typical size.
fn state(scales: &[f64], number: usize) -> Vec<f64> {
    let angle = |index: usize| 1.0 + 0.7 * index as f64 + 0.3 * number as f64;
    let value = |(index, scale): (usize, &f64)| 0.3 * scale * angle(index).sin();
    scales.iter().enumerate().map(value).collect()
}

fn time(number: usize) -> f64 {
    0.01 * number as f64
}

fn points<const N: usize>(scales: &[f64]) -> [Point<f64, N>; STATES] {
    std::array::from_fn(|number| {
        let state = state(scales, number);
        (time(number), std::array::from_fn(|index| state[index]))
    })
}

/// Each point with the seven after it.
fn in_lanes<const N: usize>(points: &[Point<f64, N>; STATES]) -> [Point<F64x8, N>; STATES] {
    std::array::from_fn(|number| {
        let together = |value: &dyn Fn(&Point<f64, N>) -> f64| {
            F64x8::from(std::array::from_fn(|lane| value(&points[(number + lane) % STATES])))
        };
        let state = std::array::from_fn(|index| together(&|(_, state)| state[index]));
        (together(&|(time, _)| *time), state)
    })
}

/// Nanoseconds of a call.
fn cycling<R: Real, const N: usize, P, const M: usize>(
    function: Function<R, N, P, M>,
    points: &[Point<R, N>; STATES],
    before: &P,
) -> f64 {
    // Whoever compiles this knows neither what is called nor what becomes of its results.
    let function = black_box(function);
    let mut values = [R::literal(0.0); M];
    let time = nanoseconds(|number| {
        let (time, state) = &points[number % STATES];
        function(*time, state, before, &mut values);
    });
    black_box(&mut values);
    time
}

/// Median time of a call \[ns\]; it is told how many went before it.
fn nanoseconds(mut call: impl FnMut(usize)) -> f64 {
    let mut sample = |calls: usize| {
        let start = Instant::now();
        (0..calls).for_each(&mut call);
        start.elapsed().as_secs_f64()
    };
    let mut calls = STATES;
    while sample(calls) < SAMPLE {
        calls *= 2;
    }
    let times = (0..SAMPLES).map(|_| sample(calls) / calls as f64 * 1e9);
    median(times.collect())
}

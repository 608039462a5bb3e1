//! Forces near a place, far narrower than the path of a body: no method steps over them.

use std::f64::consts::PI;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a body of 1 kg whose position determines a force on another one, with its initial
/// position and speed.
fn pair(potential: &str, push: &str, (x, v): (f64, f64), until: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "pair"
        [units.pair]
        unit = "pair"
        [initial]
        "pair.x" = {x}
        "pair.v" = {v}
        [run]
        until = {until}
        points = 2
        [define.pair.coordinates]
        x = {{ unit = "m", velocity = "v" }}
        y = {{ unit = "m", velocity = "u" }}
        [define.pair.parameters]
        place = {{ value = 43.21, unit = "m" }}
        width = {{ value = 1e-2, unit = "m" }}
        impulse = {{ value = 1.0, unit = "N m" }}
        height = {{ value = 0.3, unit = "J" }}
        [define.pair.energy]
        kinetic = "1 [kg]*(v^2 + u^2)/2"
        potential = "{potential}"
        [[define.pair.forces]]
        coordinate = "y"
        expression = "impulse/width*({push})"
        "#
    );
    of_text(&text, Keep::Needed)
}

fn run(pair: &ModelSimulator, method: Method, rtol: f64, width: f64) -> Trajectory {
    let run = Simulation::new(pair).method(method).rtol(rtol).max_steps(100_000);
    let run = run.parameter("pair.width", width).expect("a parameter");
    run.run().unwrap_or_else(|error| panic!("{method} at {rtol:e}, {width:e}: {error}"))
}

/// Returns whether the function has no series far away, so that runs take too many steps and report
/// that.
fn overflows(method: Method, bell: &str) -> bool {
    method == Method::Taylor && ["cosh", "/(1 + exp"].iter().any(|part| bell.contains(part))
}

/// Integral of a bell between two places, in widths from the middle.
type Area = fn(f64, f64) -> f64;

#[test]
fn what_is_there_only_near_a_place_is_seen_by_what_goes_past() {
    let bells: [(&str, Area); 10] = [
        ("exp(-((x - place)/width)^2)", |_, _| PI.sqrt()),
        ("exp(-abs(x - place)/width)", |low, high| 2.0 - low.exp() - (-high).exp()),
        ("exp(1 - sqrt(1 + ((x - place)/width)^2))", |_, _| 3.272_306_972_526_5),
        ("1/(1 + ((x - place)/width)^2)", |low, high| high.atan() - low.atan()),
        ("1/(1 + ((x - place)/width)^2)^1.5", |low, high| {
            let of = |s: f64| s / (1.0 + s * s).sqrt();
            of(high) - of(low)
        }),
        ("(1 + ((x - place)/width)^2)^-2", |low, high| {
            let of = |s: f64| 0.5 * (s / (1.0 + s * s) + s.atan());
            of(high) - of(low)
        }),
        ("1/cosh((x - place)/width)", |_, _| PI),
        ("1 - tanh((x - place)/width)^2", |_, _| 2.0),
        ("(tanh((x - place)/width) - tanh((x - place)/width - 5))/2", |_, _| 5.0),
        ("1/(1 + exp((place - x)/width)) - 1/(1 + exp((place - x)/width + 5))", |_, _| 5.0),
    ];
    for (bell, area) in bells {
        let pair = pair("0 [J]", bell, (0.0, 1.0), 100.0);
        for width in [0.8, 1e-2, 1e-4] {
            let expected = area(-43.21 / width, 56.79 / width);
            for (method, rtol) in
                OWN.into_iter().flat_map(|method| [(method, 1e-4), (method, 1e-7)])
            {
                if overflows(method, bell) && width < 0.1 {
                    continue;
                }
                let found = run(&pair, method, rtol, width).last("pair.u").expect("a state");
                let error = (found / expected - 1.0).abs();
                let what = format!("{method} at {rtol:e}, {width:e}: {bell}");
                assert!(error < 30.0 * rtol, "{what}: {found} for {expected}");
            }
        }
    }
}

#[test]
fn what_a_spring_carries_past_a_bell_feels_it_each_time() {
    let bells = ["exp(-((x - place)/width)^2)", "1/cosh((x - place)/width)^2"];
    for (bell, area) in bells.into_iter().zip([PI.sqrt(), 2.0]) {
        // 20 s of one turn a second, 10 m to both sides.
        let bell = bell.replace("place", "3.3 [m]");
        let pair = pair("2*pi^2*1 [N/m]*x^2", &bell, (10.0, 0.0), 20.0);
        let speed = 2.0 * PI * (100.0f64 - 3.3 * 3.3).sqrt();
        for (method, width) in OWN.into_iter().flat_map(|method| [(method, 0.05), (method, 1e-3)]) {
            if overflows(method, &bell) {
                continue;
            }
            let found = run(&pair, method, 1e-6, width).last("pair.u").expect("a state");
            let expected = 40.0 * area / speed;
            let error = (found / expected - 1.0).abs();
            assert!(error < 1e-4 + 0.01 * width * width, "{method}, {width:e}: {bell}: {error:e}");
        }
    }
}

#[test]
fn a_hill_holds_a_body_up_or_throws_it_back() {
    let pair = pair("height*exp(-((x - place)/width)^2)", "0", (0.0, 1.0), 100.0);
    // Delay by the bell, by Simpson's rule.
    let delay = |height: f64| {
        let of = |s: f64| 1.0 / (1.0 - 2.0 * height * (-s * s).exp()).sqrt() - 1.0;
        let step = 1e-3;
        let sum: f64 = (-4000..4000)
            .map(|k| {
                let s = 2.0 * f64::from(k) * step;
                of(s) + 4.0 * of(s + step) + of(s + 2.0 * step)
            })
            .sum();
        sum * step / 3.0
    };
    for width in [0.5, 1e-2, 1e-4] {
        for method in OWN {
            let over = run(&pair, method, 1e-7, width);
            let [x, v] = ["pair.x", "pair.v"].map(|name| over.last(name).expect("a state"));
            let late = 100.0 - x;
            let error = (late - width * delay(0.3)).abs();
            assert!((v - 1.0).abs() < 3e-6 && error < 1e-3, "{method}, {width:e}: {late}, {v}");
            let higher = Simulation::new(&pair).method(method).rtol(1e-7);
            let higher = higher.parameter("pair.height", 0.6).expect("a parameter");
            let back = higher.parameter("pair.width", width).and_then(|run| run.run());
            let v = back.expect("a run").last("pair.v").expect("a state");
            assert!((v + 1.0).abs() < 3e-6, "{method}, {width:e}: {v}");
        }
    }
}

/// The force is a bell, for any potential.
#[test]
fn a_step_of_a_potential_slows_a_body_or_throws_it_back() {
    for step in ["1/(1 + exp((place - x)/width))", "(1 + tanh((x - place)/width))/2"] {
        let pair = pair(&format!("height*{step}"), "0", (0.0, 1.0), 100.0);
        for (width, height) in [(0.5, 0.3), (1e-2, 0.3), (1e-2, 0.6), (1e-4, 0.3), (1e-4, 0.6)] {
            for method in OWN.into_iter().filter(|method| !overflows(*method, step)) {
                let run = Simulation::new(&pair).method(method).rtol(1e-7);
                let run = run.parameter("pair.width", width).expect("a parameter");
                let run = run.parameter("pair.height", height).and_then(|run| run.run());
                let run = run.unwrap_or_else(|error| panic!("{method}, {width:e}: {error}"));
                let v = run.last("pair.v").expect("a state");
                let expected = if height < 0.5 { (1.0 - 2.0 * height).sqrt() } else { -1.0 };
                assert!((v - expected).abs() < 1e-5, "{method}, {width:e}, {height}: {v}");
            }
        }
    }
}

/// Returns one to three hills, valleys and steps of random places and widths, in a valley of two
/// coordinates, with start and speeds.
fn random_landscape(random: &mut fastrand::Rng) -> String {
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    let start = [between(-4.0, 4.0), between(-3.0, 3.0), between(-3.0, 3.0)];
    let terms = 1 + (3.0 * between(0.0, 1.0)) as usize;
    let mut term = || {
        let mut distance = || {
            let along = ["x", "y", "(x + 0.5*y)"][(3.0 * between(0.0, 1.0)) as usize];
            let width = [1.0, 0.1, 0.02, 0.004][(4.0 * between(0.0, 1.0)) as usize];
            format!("(({along} - {} [m])/({width} [m]))", between(-3.0, 3.0))
        };
        let (s, t) = (distance(), distance());
        let forms = [
            format!("exp(-{s}^2)"),
            format!("exp(-{s}^2 - {t}^2)"),
            format!("{s}*exp(-{s}^2/2)"),
            format!("exp(1 - sqrt(1 + {s}^2))"),
            format!("1/(1 + {s}^2)^2"),
            format!("1/(1 + {s}^2 + {t}^2)^1.5"),
            format!("exp(-2*{s}^2)/(1 + {t}^2)"),
            format!("tanh({s})"),
            format!("(tanh({s}) - tanh({s} - 4))"),
            format!("1/(1 + {s}^2)"),
            format!("1/cosh({s})"),
            format!("1/(1 + exp({s}))"),
        ];
        let form = &forms[(forms.len() as f64 * between(0.0, 1.0)) as usize];
        format!("{} [J]*{form}", between(-2.0, 2.0))
    };
    let terms: Vec<String> = (0..terms).map(|_| term()).collect();
    format!(
        r#"
        [scene]
        name = "landscape"
        [units.body]
        unit = "body"
        [initial]
        "body.x" = {}
        "body.v" = {}
        "body.u" = {}
        [run]
        until = 10
        points = 11
        [define.body.coordinates]
        x = {{ unit = "m", velocity = "v" }}
        y = {{ unit = "m", velocity = "u" }}
        [define.body.energy]
        kinetic = "1 [kg]*(v^2 + u^2)/2"
        potential = "0.5 [N/m]*(x^2 + 2*y^2) + {}"
        dissipation = "0.05 [N s/m]*(v^2 + u^2)/2"
        "#,
        start[0],
        start[1],
        start[2],
        terms.join(" + ")
    )
}

#[test]
fn bodies_move_through_random_landscapes_alike_by_all_methods() {
    let mut random = fastrand::Rng::with_seed(1);
    let count = std::env::var("MACHINIST_FUZZ").ok().and_then(|count| count.parse().ok());
    let mut compared = 0;
    for _ in 0..count.unwrap_or(40) {
        let text = random_landscape(&mut random);
        let body = of_text(&text, Keep::Needed);
        let at = |method: Method, rtol: f64| {
            let run = Simulation::new(&body).method(method).rtol(rtol).max_steps(100_000).run();
            run.map(|run| ["body.x", "body.y"].map(|name| run.last(name).expect("a state")))
        };
        let off = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
        let exact = at(Method::Dop853, 1e-12).expect("a run");
        // The tolerance does not determine whether a body just gets over a hill.
        if off(at(Method::Dop853, 1e-8).expect("a run"), exact) > 1e-6 {
            continue;
        }
        compared += 1;
        for method in OWN.into_iter().filter(|method| !overflows(*method, &text)) {
            let found =
                at(method, 1e-7).unwrap_or_else(|error| panic!("{method}: {error}\n{text}"));
            assert!(off(found, exact) < 1e-3, "{method}: {found:?} for {exact:?}\n{text}");
        }
    }
    println!("{compared} landscapes");
    assert!(compared > 20, "{compared}");
}

#[test]
fn sensitivities_see_bells() {
    let pair = pair("0 [J]", "exp(-((x - place)/width)^2)*width/(1 [m])", (0.0, 1.0), 100.0);
    for method in [Method::Dop853, Method::Tsit5, Method::Radau, Method::Auto] {
        let run = Simulation::new(&pair).method(method).rtol(1e-8);
        let run = run.sensitivities(&["pair.width", "pair.place"]).expect("parameters");
        let run = run.run().unwrap_or_else(|error| panic!("{method}: {error}"));
        for (by, expected) in [("pair.width", PI.sqrt()), ("pair.place", 0.0)] {
            let found = run.sensitivity("pair.u", by).expect("a column");
            let found = *found.last().expect("rows");
            assert!((found - expected).abs() < 1e-4, "{method}, by {by}: {found}");
        }
    }
}

//! Optimization of designs: optima against closed forms, derivatives against differences.

use machinist::fit::{Bounds, Unknown};
use machinist::improve::{End, Expression, Found, Improvement, Inequality, Values, check};
use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes::saw_gin::SawGin;

use crate::own_scene::of_text;
use crate::sensitivities::bouncing_ball;

fn unknown(name: &str, start: f64, (low, high): (f64, f64)) -> Unknown {
    Unknown { name: name.to_owned(), start, bounds: Bounds { low, high } }
}

/// Searches from the starts of the unknowns; returns values, expressions, costs and end.
fn improved(
    simulation: &Simulation<'_>,
    unknowns: &[Unknown],
    objective: &str,
    inequalities: &[&str],
) -> (Vec<f64>, Values, Vec<f64>, Found) {
    let objective = Expression::parse(objective).expect("an expression");
    let inequalities: Vec<Inequality> =
        inequalities.iter().map(|text| Inequality::parse(text).expect("an inequality")).collect();
    let improvement =
        Improvement { simulation, unknowns, objective: &objective, inequalities: &inequalities };
    let start = improvement.start();
    let told = improvement.numbers_at(&improvement.values(&start)).expect("it runs");
    let sizes = improvement.sizes(&told);
    let found = improvement.search(&start, &sizes, 100, None, |_| {}).expect("it starts");
    let values = improvement.values(&found.at);
    let told = improvement.numbers_at(&values).expect("it runs");
    let costs = improvement.costs(&found, &sizes);
    (values, told, costs, found)
}

/// Returns the largest error of the derivatives of expressions, relative to their size, against
/// differences of fourth order.
fn off_differences(
    simulation: &Simulation<'_>,
    unknowns: &[Unknown],
    texts: &[&str],
    step: f64,
) -> f64 {
    let mut worst = 0.0_f64;
    for text in texts {
        let objective = Expression::parse(text).expect("an expression");
        check(&objective, simulation.simulator()).expect("known names");
        let improvement =
            Improvement { simulation, unknowns, objective: &objective, inequalities: &[] };
        let start = improvement.start();
        let told = |inner: &[f64]| {
            improvement.numbers_at(&improvement.values(inner)).expect("it runs").objective
        };
        let size = told(&start).abs();
        let sizes = improvement.sizes(&Values { objective: 1.0, sides: vec![], notes: vec![] });
        let found = improvement.evaluate(&start, &sizes).expect("it runs");
        let branch = &found.objective[0];
        assert!((branch.value - told(&start)).abs() <= 1e-9 * size.max(1e-6), "{text}");
        let scale = branch.slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
        for k in 0..unknowns.len() {
            let at = |times: f64| {
                let mut inner = start.clone();
                inner[k] += times * step;
                told(&inner)
            };
            let slope = (8.0 * (at(1.0) - at(-1.0)) - at(2.0) + at(-2.0)) / (12.0 * step);
            let off = (branch.slopes[k] - slope).abs() / scale.max(1e-9 * size);
            assert!(off < 1e-3, "{text} by {k}: {} for {slope}", branch.slopes[k]);
            worst = worst.max(off);
        }
    }
    worst
}

#[test]
fn derivatives_of_expressions_agree_with_differences() {
    let run = Simulation::new(&SawGin).rtol(1e-11).method(Method::Dop853).until(0.4).points(801);
    let positive = (1e-9, f64::INFINITY);
    let unknowns = [
        unknown("coupling.stiffness", 23_065.2, positive),
        unknown("coupling.damping", 128.5346, positive),
        unknown("motor.inertia", 4.2, (f64::NEG_INFINITY, f64::INFINITY)),
    ];
    let texts = [
        "max(abs(coupling_torque))",
        "min(coupling_torque) + 0*motor.inertia",
        "mean(coupling_torque^2)/1e3",
        "integral(t*twist)*coupling.stiffness",
        "rms(cylinder_acceleration)",
        "final(motor_speed) - initial(motor_speed)",
        "peak_time(motor_torque)",
        "sqrt(max(twist^2))*exp(-coupling.damping/1e3) + ln(motor.inertia)",
        "max(coupling_torque/motor.inertia)^1.5 - tanh(max(twist))",
    ];
    let off = off_differences(&run, &unknowns, &texts, 2e-4);
    assert!(off < 2e-6, "{off}");
}

#[test]
fn through_events_they_do_as_well() {
    let scene = bouncing_ball();
    let run = Simulation::new(&scene).until(1.1).points(2001).rtol(1e-11);
    let free = (f64::NEG_INFINITY, f64::INFINITY);
    let unknowns = [unknown("ball.restitution", 0.8, free), unknown("height", 1.0, free)];
    // The height after the first bounce is e^2 h, its time sqrt(2 h/g) (1 + e).
    let off = off_differences(&run, &unknowns, &["final(x)", "final(v)"], 1e-4);
    assert!(off < 1e-7, "{off}");
    // Sums over samples change when a bounce passes one.
    let off = off_differences(&run, &unknowns, &["mean(x)"], 1e-2);
    assert!(off < 1e-3, "{off}");
}

/// Returns a mass that arrives with a speed and is stopped by a spring.
fn buffer() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "buffer"
        [units.wagon]
        unit = "wagon"
        [initial]
        "wagon.v" = "wagon.speed"
        [run]
        until = 0.6
        points = 601
        rtol = 1e-10
        method = "dop853"
        [outputs]
        way = "wagon.x"
        force = { expression = "wagon.stiffness*wagon.x", unit = "N" }
        [define.wagon.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.wagon.parameters]
        mass = { value = 500.0, unit = "kg" }
        speed = { value = 2.0, unit = "m/s" }
        stiffness = { value = 9e4, unit = "N/m" }
        damping = { value = 0.0, unit = "N s/m" }
        [define.wagon.energy]
        kinetic = "mass*v^2/2"
        potential = "stiffness*x^2/2"
        dissipation = "damping*v^2/2"
        "#,
        Keep::Needed,
    )
}

#[test]
fn the_softest_spring_that_stops_a_mass_in_time_is_that_of_the_closed_form() {
    // v sqrt(m/k) <= L: k = m v^2/L^2, and dk/dL = -2 m v^2/L^3, from starts on both sides.
    let scene = buffer();
    let run = Simulation::new(&scene);
    for (limit, start) in [(0.2, 9e4), (0.1, 3e4), (0.3, 4e4), (0.15, 3e5)] {
        let unknowns = [unknown("wagon.stiffness", start, (1e4, 1e6))];
        let limit_text = format!("max(way) <= {limit}");
        let (values, told, costs, found) =
            improved(&run, &unknowns, "wagon.stiffness", &[&limit_text]);
        let wanted = 500.0 * 4.0 / (limit * limit);
        assert_eq!(found.end, End::Converged, "{found:?}");
        assert!((values[0] / wanted - 1.0).abs() < 1e-6, "{values:?} for {wanted}");
        assert!((told.sides[0].0 - limit).abs() < 1e-7);
        let cost = 2.0 * wanted / limit;
        assert!((costs[0] / cost - 1.0).abs() < 1e-3, "{costs:?} for {cost}");
    }
    // The same with an upper limit of the force: max(k x) = v sqrt(k m) <= F, for the shortest
    // travel.
    let unknowns = [unknown("wagon.stiffness", 3e4, (1e4, 1e6))];
    let (values, ..) = improved(&run, &unknowns, "max(way)", &["max(force) <= 12e3"]);
    assert!((values[0] / (12e3_f64.powi(2) / (500.0 * 4.0)) - 1.0).abs() < 1e-6, "{values:?}");
}

/// A mass on a spring whose end rises by an inclined sine in T goes on with the amplitude
/// h |sin(pi r)|/(pi r |1 - r^2|), where r is T over the period: with none if r = 2, 3, ...
#[test]
fn a_rise_that_leaves_no_vibration_takes_a_whole_number_of_periods() {
    let scene = of_text(
        r#"
        [scene]
        name = "lifted"
        [units.load]
        unit = "load"
        [run]
        until = 1.0
        points = 1001
        rtol = 1e-11
        method = "dop853"
        [outputs]
        energy = { expression = "load.left", unit = "J" }
        [define.load.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.load.parameters]
        rise = { value = 0.23, unit = "s" }
        period = { value = 0.1, unit = "s" }
        lift = { value = 0.02, unit = "m" }
        [define.load.helpers.end]
        expression = "lift*motion_law('inclined sine', t/rise)"
        unit = "m"
        [define.load.helpers.left]
        expression = "2 [kg]*v^2/2 + 2 [kg]*(2*pi/period)^2*(x - end)^2/2"
        unit = "J"
        [define.load.energy]
        kinetic = "2 [kg]*v^2/2"
        potential = "2 [kg]*(2*pi/period)^2*(x - end)^2/2"
        "#,
        Keep::Needed,
    );
    let run = Simulation::new(&scene);
    for ratio in [0.4, 0.9, 1.3, 2.3, 2.5, 3.7, 8.2] {
        let moved = run.clone().parameter("load.rise", 0.1 * ratio).expect("a parameter");
        let last = moved.run().expect("it runs").last("energy").expect("an output");
        let amplitude = 0.02 * (std::f64::consts::PI * ratio).sin().abs()
            / (std::f64::consts::PI * ratio * (1.0 - ratio * ratio).abs());
        let found = last.sqrt() / (std::f64::consts::TAU / 0.1);
        assert!((found - amplitude).abs() < 1e-10, "{ratio}: {found} for {amplitude}");
    }
    for start in [0.18, 0.23, 0.28, 0.37] {
        let unknowns = [unknown("load.rise", start, (0.15, 0.6))];
        let (values, ..) = improved(&run, &unknowns, "sqrt(final(energy) + 1e-12)", &[]);
        let periods = values[0] / 0.1;
        let whole = periods.round();
        assert!((periods - whole).abs() < 1e-4 && whole >= 2.0, "{start}: {periods} periods");
    }
}

#[test]
fn what_cannot_be_met_ends_where_it_is_missed_by_the_least() {
    let scene = buffer();
    let run = Simulation::new(&scene);
    let unknowns = [unknown("wagon.stiffness", 3e4, (1e4, 1e6))];
    // k >= 200 000 N/m for one, k <= 72 000 N/m for the other.
    let limits = ["max(way) <= 0.1", "max(force) <= 12e3"];
    let (_, told, _, found) = improved(&run, &unknowns, "wagon.stiffness", &limits);
    assert_eq!(found.end, End::Infeasible, "{found:?}");
    assert!(!found.is_feasible());
    assert!(told.sides.iter().any(|(left, right)| left > right));
}

/// Returns a mass on a spring with a smaller one attached by a spring and a damper, after an
/// impact.
fn absorber() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "absorber"
        [units.both]
        unit = "both"
        [initial]
        "both.v" = "1 [m/s]"
        [run]
        until = 20.0
        points = 2001
        rtol = 1e-8
        method = "dop853"
        [outputs]
        x = "both.x"
        [define.both.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.both.coordinates.y]
        unit = "m"
        velocity = "w"
        [define.both.parameters]
        mass = { value = 1.0, unit = "kg" }
        small = { value = 0.1, unit = "kg" }
        stiffness = { value = 100.0, unit = "N/m" }
        soft = { value = 10.0, unit = "N/m" }
        damping = { value = 0.2, unit = "N s/m" }
        [define.both.energy]
        kinetic = "mass*v^2/2 + small*w^2/2"
        potential = "stiffness*x^2/2 + soft*(y - x)^2/2"
        dissipation = "damping*(w - v)^2/2"
        "#,
        Keep::Needed,
    )
}

#[test]
fn a_vibration_absorber_is_tuned_as_warburton_has_it() {
    // After a blow the integral of x^2 is least where (G. B. Warburton, Optimum absorber
    // parameters for various combinations of response and excitation parameters, Earthquake
    // Eng. Struct. Dyn. 10, 1982) the frequencies' ratio is sqrt(1 + m/2)/(1 + m) and the
    // damping ratio sqrt(m (1 + 3 m/4)/(4 (1 + m) (1 + m/2))).
    let scene = absorber();
    for share in [0.1_f64, 0.3] {
        let run = Simulation::new(&scene).parameter("both.small", share).expect("known");
        let unknowns = [
            unknown("both.soft", 60.0 * share, (1.0 * share, 300.0 * share)),
            unknown("both.damping", 1.0 * share, (1e-2 * share, 100.0 * share)),
        ];
        let (values, _, _, found) = improved(&run, &unknowns, "integral(x^2)", &[]);
        let ratio = (1.0 + share / 2.0).sqrt() / (1.0 + share);
        let damping = share * (1.0 + 0.75 * share) / (4.0 * (1.0 + share) * (1.0 + share / 2.0));
        let frequency = 10.0 * ratio;
        let soft = share * frequency * frequency;
        let damping = 2.0 * damping.sqrt() * share * frequency;
        assert!((values[0] / soft - 1.0).abs() < 1e-4, "{values:?} for {soft}: {found:?}");
        assert!((values[1] / damping - 1.0).abs() < 1e-4, "{values:?} for {damping}");
    }
}

#[test]
fn two_peaks_that_compete_are_lowered_together() {
    // After an impact, a stiff spring causes a high force, a soft one a long travel. The maximum of
    // both, each over its size, is least where both are equal: 4000 x = k x.
    let scene = buffer();
    let run = Simulation::new(&scene);
    let unknowns = [unknown("wagon.stiffness", 9e4, (5e3, 1e6))];
    let limits = ["max(way)/0.2 <= 1.2", "max(force)/15e3 <= 1.2"];
    let (values, told, ..) = improved(&run, &unknowns, "max(force)/15e3 + max(way)/0.2", &limits);
    // v sqrt(k m)/15e3 + v sqrt(m/k)/0.2 is least at k = 75e3.
    assert!((values[0] / 75e3 - 1.0).abs() < 1e-4, "{values:?}");
    assert!(told.sides.iter().all(|(left, right)| left <= right));
}

#[test]
fn names_and_courses_that_make_no_sense_are_told() {
    let of = |text: &str| {
        let expression = Expression::parse(text).expect("an expression");
        check(&expression, &SawGin as &dyn Simulator<f64>).expect_err("refused")
    };
    assert!(of("max(coupling_torqe)").message.contains("did you mean `coupling_torque`"));
    let error = of("2*twist");
    assert!(error.message.contains("changes over time") && error.help.contains("max(twist)"));
    assert_eq!(error.range, 2..7);
    assert!(of("max(mean(twist))").message.contains("one number already"));
}

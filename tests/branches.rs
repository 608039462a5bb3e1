//! Branches held within a step: events and relations at their own zero crossings, by all methods,
//! against closed forms; sliding motions; slots after the parameters.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe as _, RelationKind, Simulator};
use machinist_model::ModelSimulator;

use crate::own_scene::{folder_of_specs, model_of_specs, of_files, of_text, specs_in};

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a mass of 1 kg on a line, with further definitions of its unit.
fn mass(initial: &str, definition: &str) -> ModelSimulator {
    of_text(&text_of_mass(initial, definition), Keep::All)
}

fn text_of_mass(initial: &str, definition: &str) -> String {
    format!(
        r#"
        [scene]
        name = "held"
        [units.u]
        unit = "u"
        [initial]
        {initial}
        [run]
        until = 3.0
        points = 31
        rtol = 1e-8
        method = "auto"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.energy]
        kinetic = "1 [kg]*v^2/2"
        {definition}
        "#
    )
}

fn force(expression: &str) -> String {
    format!("[[define.u.forces]]\ncoordinate = \"x\"\nexpression = '''{expression}'''\n")
}

fn run(machine: &ModelSimulator, method: Method, rtol: f64, set: &[(&str, f64)]) -> Trajectory {
    let mut run = Simulation::new(machine).method(method).rtol(rtol);
    for (name, value) in set {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.run().unwrap_or_else(|error| panic!("{method} at {rtol:e}, {set:?}: {error}"))
}

fn last(run: &Trajectory, name: &str) -> f64 {
    *run.column(name).expect("a column").last().expect("a row")
}

fn assert_near(found: f64, expected: f64, allowed: f64, what: &str) {
    assert!((found - expected).abs() <= allowed, "{what}: {found} and not {expected}");
}

#[test]
fn two_events_on_one_guard_each_happen_at_their_own_crossing() {
    let thrown = mass(
        "\"u.v\" = 50.0",
        &format!(
            "{}{}",
            force("-9.81 [N]"),
            r#"
            [define.u.parameters]
            at = { value = 50.0, unit = "m" }
            [define.u.states]
            up = { unit = "1", rate = "0 [1/s]" }
            down = { unit = "1", rate = "0 [1/s]" }
            [define.u.events]
            rises = { guard = "x - at", direction = "rising", set = { up = "up + 1" } }
            falls = { guard = "x - at", direction = "falling", set = { down = "down + 1" } }
            "#
        ),
    );
    let highest = 50.0_f64.powi(2) / (2.0 * 9.81);
    for method in OWN {
        for height in 1..=26 {
            let at = 5.0 * f64::from(height) + 0.37;
            let run = Simulation::new(&thrown).method(method).until(11.0).rtol(1e-8);
            let run = run.parameter("u.at", at).expect("a parameter").run().expect("it runs");
            let passes = if at < highest { 1.0 } else { 0.0 };
            let counts = [last(&run, "u.up"), last(&run, "u.down")];
            let is_right = counts.iter().all(|count| (count - passes).abs() < 0.5);
            assert!(is_right, "{method} at {at} m: {counts:?}");
            let times: Vec<f64> = run.switches.iter().map(|switch| switch.time).collect();
            if at < highest {
                let root = (50.0_f64.powi(2) - 2.0 * 9.81 * at).sqrt();
                for (time, way) in times.iter().zip([-1.0, 1.0]) {
                    assert_near(*time, (50.0 + way * root) / 9.81, 1e-9, "time");
                }
            }
        }
    }
}

#[test]
fn ramps_and_trapezoids_of_time_end_and_give_their_impulse() {
    let ramp = "min(max((t - start)/rise, 0), 1)";
    let machine = mass(
        "\"u.v\" = 0.0",
        &format!(
            "{}{}",
            r#"
            [define.u.parameters]
            start = { value = 0.7, unit = "s" }
            rise = { value = 0.3, unit = "s" }
            "#,
            force(&format!("1 [N]*{ramp}"))
        ),
    );
    for method in OWN {
        for start in [0.0, 0.1, 0.7, 1.234_567] {
            for rise in [1e-6, 1e-3, 0.3, 1.5] {
                let set = [("u.start", start), ("u.rise", rise)];
                let run = run(&machine, method, 1e-8, &set);
                let expected = 3.0 - start - rise / 2.0;
                assert_near(last(&run, "u.v"), expected, 1e-7, &format!("{method} {set:?}"));
                assert!(run.work.steps < 500, "{method} {set:?}: {} steps", run.work.steps);
            }
        }
    }
}

#[test]
fn encoders_count_every_line_by_every_method() {
    let guards = ["mod(lines*x, 1) - 0.3", "sin(6.283185307179586*lines*x + phase)"];
    for guard in guards {
        let machine = mass(
            "\"u.v\" = 1.0\n\"u.x\" = 1e-5",
            &format!(
                r#"
                [define.u.parameters]
                lines = {{ value = 100, unit = "1/m" }}
                phase = {{ value = 0.1, unit = "1" }}
                [define.u.modes.n]
                [define.u.events.tick]
                guard = "{guard}"
                direction = "rising"
                set = {{ n = "n + 1" }}
                "#
            ),
        );
        for method in OWN {
            for lines in [10.0, 137.0, 1000.0, 5000.0] {
                let run = run(&machine, method, 1e-6, &[("u.lines", lines)]);
                let (first, end) = (1e-5 * lines, (1e-5 + 3.0) * lines);
                let turns = if guard.starts_with("mod") {
                    (end - 0.3).floor() - (first - 0.3).floor()
                } else {
                    let phase = 0.1 / std::f64::consts::TAU;
                    (end + phase).floor() - (first + phase).floor()
                };
                let count = last(&run, "u.n");
                let is_right = (count - turns).abs() < 0.5;
                assert!(is_right, "{method}, {lines} lines, {guard}: {count} for {turns}");
            }
        }
    }
}

#[test]
fn encoders_on_a_swinging_mass_miss_no_line_however_long_steps_are() {
    let swing = mass(
        "\"u.x\" = 1.0",
        &format!(
            "{}{}",
            force("-1 [N/m]*x"),
            r#"
            [define.u.parameters]
            pitch = { value = 0.01, unit = "m" }
            [define.u.states]
            count = { unit = "1", rate = "0 [1/s]" }
            [define.u.events]
            line = { guard = "sin(x/pitch) - 0.5", direction = "rising", set = { count = "count + 1" } }
            "#
        ),
    );
    let until = 20.0;
    for pitch in [0.3, 0.04, 0.013, 0.0052, 0.002] {
        // x = cos t, sampled a thousand times a line.
        let samples = (1e3 * until / pitch) as usize;
        let guard = |k: usize| ((until * k as f64 / samples as f64).cos() / pitch).sin() - 0.5;
        let lines = (0..samples).filter(|k| guard(*k) < 0.0 && guard(k + 1) >= 0.0).count();
        for method in OWN {
            for rtol in [1e-6, 1e-9] {
                let run = Simulation::new(&swing).method(method).rtol(rtol).until(until);
                let run =
                    run.parameter("u.pitch", pitch).expect("a parameter").max_steps(1_000_000);
                let run = run.run().expect("a run");
                let what = format!("{method} at {rtol:e}, {pitch} m");
                assert_near(last(&run, "u.count"), lines as f64, 0.5, &what);
            }
        }
    }
}

/// A mass on a hardening spring with a force over time, and a tick at each line of its path.
fn swing_with_ticks(tick: &str) -> ModelSimulator {
    mass(
        "\"u.x\" = -0.23\n\"u.v\" = -1.49",
        &format!("{}{tick}", force("-17 [N/m]*x - 170 [N/m^3]*x^3 - 1 [N]*cos(8 [1/s]*t)")),
    )
}

#[test]
fn ticks_that_the_motion_reads_happen_once_however_long_steps_are() {
    let until = 8.0;
    // The path without ticks, which do not change it.
    let path = swing_with_ticks("");
    let path = Simulation::new(&path).rtol(1e-12).until(until).points(400_001);
    let path = path.run().expect("a run");
    let path = path.column("u.x").expect("a column");
    let swing = swing_with_ticks(
        r#"
        [define.u.parameters]
        pitch = { value = 0.01, unit = "m" }
        [define.u.states]
        side = { unit = "1", rate = "piecewise(mod(n, 8) < 4, 1 [1/s], -1 [1/s])" }
        [define.u.modes.n]
        [define.u.events.tick]
        guard = "sin(x/pitch) - 0.5"
        direction = "rising"
        set = { n = "n + 1" }
        "#,
    );
    for pitch in [0.003, 0.005, 0.0069, 0.01, 0.014] {
        let guard = |x: f64| (x / pitch).sin() - 0.5;
        let is_line = |pair: &&[f64]| guard(pair[0]) < 0.0 && guard(pair[1]) >= 0.0;
        let lines = path.windows(2).filter(is_line).count();
        for method in OWN {
            for rtol in [1e-6, 3e-7, 1e-7, 1e-9] {
                let run = Simulation::new(&swing).method(method).rtol(rtol).until(until);
                let run = run.parameter("u.pitch", pitch).expect("a parameter");
                let run = run.max_steps(1_000_000).run().expect("a run");
                let what = format!("{method} at {rtol:e}, {pitch} m");
                assert_near(last(&run, "u.n"), lines as f64, 0.5, &what);
            }
        }
    }
}

#[test]
fn a_table_over_each_turn_is_followed_across_its_ends() {
    // The last knot is just before a whole turn, so several knots are passed at once.
    let rates = [-0.023, -0.338, -0.547, -0.404, -0.023];
    let quarter = |quarters: usize| quarters as f64 * std::f64::consts::FRAC_PI_2;
    let knots: Vec<(f64, f64)> =
        (0..=4).map(|knot| ((quarter(knot) * 1e7).floor() / 1e7, rates[knot])).collect();
    let law = |angle: f64| {
        let angle = angle.rem_euclid(std::f64::consts::TAU);
        let next = (1..4).find(|next| angle < knots[*next].0).unwrap_or(4);
        let ((low, below), (high, above)) = (knots[next - 1], knots[next]);
        below + (above - below) * (angle - low) / (high - low)
    };
    let rows: Vec<String> = knots.iter().map(|(angle, rate)| format!("{angle},{rate}\n")).collect();
    let table = format!("angle [1],rate [1]\n{}", rows.concat());
    let swing = text_of_mass(
        "\"u.x\" = 0.3571\n\"u.v\" = 0.1992",
        &format!(
            "{}{}",
            force("-9 [N/m]*x"),
            r#"
            [define.u.parameters]
            turn = { value = 0.1, unit = "m" }
            pitch = { value = 0.05, unit = "m" }
            [define.u.states.sum]
            unit = "1"
            rate = '1 [1/s]*table("cam.csv", "rate", mod(x/turn, 2*pi), "linear")'
            [define.u.states.side]
            unit = "1"
            rate = "piecewise(mod(n, 14) < 7, 1 [1/s], -1 [1/s])"
            [define.u.modes.n]
            [define.u.events.tick]
            guard = "sin(x/pitch) - 0.5"
            direction = "rising"
            set = { n = "n + 1" }
            "#
        ),
    );
    let swing = of_files(&[("swing.toml", &swing), ("cam.csv", &table)], Keep::All);
    let x = |time: f64| 0.3571 * (3.0 * time).cos() + 0.1992 / 3.0 * (3.0 * time).sin();
    for turn in [0.05, 0.0768, 0.1, 0.171_841, 0.31] {
        let samples = 300_000;
        let step = 3.0 / f64::from(samples);
        let sum: f64 =
            (0..samples).map(|k| law(x((f64::from(k) + 0.5) * step) / turn) * step).sum();
        for pitch in [0.05, 0.0373] {
            let guard = |k: i32| (x(f64::from(k) * step) / pitch).sin() - 0.5;
            let ticks = (0..samples).filter(|k| guard(*k) < 0.0 && guard(k + 1) >= 0.0).count();
            for method in OWN {
                for rtol in [1e-7, 1e-10] {
                    let run = run(&swing, method, rtol, &[("u.turn", turn), ("u.pitch", pitch)]);
                    let what = format!("{method} at {rtol:e}, {turn} m, {pitch} m");
                    assert_near(last(&run, "u.sum"), sum, 50.0 * rtol + 1e-7, &what);
                    assert_near(last(&run, "u.n"), ticks as f64, 0.5, &what);
                }
            }
        }
    }
}

#[test]
fn a_guard_that_is_zero_on_a_branch_happens_where_it_leaves_zero() {
    let machine = mass(
        "\"u.v\" = 1.0",
        &format!(
            "{}{}",
            force("-1 [N]*s"),
            r#"
            [define.u.parameters]
            at = { value = 0.53, unit = "m" }
            [define.u.modes.s]
            [define.u.events.e]
            guard = "max(x - at, 0)"
            direction = "rising"
            when = { s = 0 }
            set = { s = 1 }
            "#
        ),
    );
    for method in OWN {
        for at in [0.01, 0.53, 1.7, 2.999] {
            let run = run(&machine, method, 1e-8, &[("u.at", at)]);
            assert_near(last(&run, "u.v"), 1.0 - (3.0 - at), 1e-8, &format!("{method} {at}"));
        }
    }
}

#[test]
fn twins_of_a_comparison_agree() {
    let forms = [
        "-9 [N/m]*abs(x - 0.2 [m])",
        "-9 [N/m]*max(x - 0.2 [m], 0.2 [m] - x)",
        "-9 [N/m]*piecewise(x < 0.2 [m], 0.2 [m] - x, x - 0.2 [m])",
        "9 [N/m]*min(x - 0.2 [m], 0.2 [m] - x)",
        "-9 [N/m]*(x - 0.2 [m])*sign(x - 0.2 [m])",
    ];
    for method in OWN {
        let runs = forms.map(|form| {
            let machine = mass("\"u.v\" = 1.0", &force(&format!("{form} + 3 [N]*sin(5 [1/s]*t)")));
            run(&machine, method, 1e-9, &[])
        });
        let first = last(&runs[0], "u.x");
        for (run, form) in runs.iter().zip(forms) {
            assert_near(last(run, "u.x"), first, 1e-6 * first.abs().max(1.0), form);
        }
    }
}

#[test]
fn dry_friction_by_sign_sticks_and_lets_go() {
    // Pulled by 2 t N against 1.5 N: breakaway is at 0.75 s, and then x'' = 2 t - 1.5.
    let machine = mass(
        "\"u.v\" = 0.0",
        &format!(
            "{}{}",
            r#"
            [define.u.parameters]
            most = { value = 1.5, unit = "N" }
            "#,
            force("2 [N/s]*t - most*sign(v)")
        ),
    );
    for method in OWN {
        for most in [0.3, 1.5, 4.0] {
            let run = run(&machine, method, 1e-8, &[("u.most", most)]);
            let slides = 3.0 - most / 2.0;
            assert_near(last(&run, "u.v"), slides * slides, 1e-6, &format!("{method} {most}"));
        }
    }
}

#[test]
fn what_rests_on_a_kink_stays_there() {
    let machine =
        mass("\"u.x\" = 0.0", &format!("{}{}", force("-3 [N]*sign(x)"), force("-0.4 [N s/m]*v")));
    for method in OWN {
        let run = run(&machine, method, 1e-6, &[]);
        assert_near(last(&run, "u.x"), 0.0, 1e-6, &format!("{method}"));
        assert!(run.work.steps < 2000, "{method}: {} steps", run.work.steps);
    }
}

#[test]
fn slots_hold_branches_and_leave_them_live() {
    let machine = mass(
        "\"u.v\" = 1.0",
        &force(
            "-abs(x)*1 [N/m] + 2 [N]*(3 [1/m]*x - mod(3 [1/m]*x, 1)) + min(v*1 [kg/s], 0.3 [N])",
        ),
    );
    let simulator: &dyn Simulator<f64> = machine.single();
    assert_eq!(machine.relations(), 3);
    let own: Vec<f64> =
        (0..machine.shape().parameters).map(|index| machine.parameter_default(index)).collect();
    let rate = |simulator: &dyn Simulator<f64>, slots: &[f64], state: [f64; 2]| {
        let mut rate = [0.0; 2];
        simulator.rate(0.0, &state, &[&own[..], slots].concat(), &mut rate);
        rate[1].to_bits()
    };
    let live: Vec<f64> =
        (0..machine.relations()).map(|index| machine.relation(index).kind.live()).collect();
    let interpreted = ModelSimulator::interpreted(machine.model().clone());
    let compiled = ModelSimulator::compiled_at_once(machine.model().clone());
    let all = [simulator, interpreted.single(), compiled.single()];
    for state in [[0.4, 0.2], [-1.3, 0.9], [2.2, -0.5]] {
        let of_live = rate(simulator, &[], state);
        for simulator in all {
            assert_eq!(rate(simulator, &[], state), of_live);
            assert_eq!(rate(simulator, &live, state), of_live);
            // Held at their own state, and then at another one.
            let guards = {
                let mut guards = vec![0.0; machine.kinks()];
                simulator.kink_guards(0.0, &state, &own, &mut guards);
                guards
            };
            let held: Vec<f64> = (0..machine.relations())
                .map(|index| match machine.relation(index).kind {
                    RelationKind::Zone => 0.0,
                    RelationKind::Branch => guards[index].signum() * f64::INFINITY,
                    RelationKind::Whole => guards[index].floor(),
                })
                .collect();
            assert_eq!(rate(simulator, &held, state), of_live);
            let beyond = [held[0] - 1.0, held[1] - 1.0, held[2] - 1.0];
            let beyond = beyond.map(|slot| if slot.is_finite() { slot } else { -slot });
            assert_eq!(rate(simulator, &beyond, state), rate(all[0], &beyond, state));
            assert_ne!(rate(simulator, &beyond, state), of_live);
        }
    }
}

#[test]
fn a_relation_on_a_branch_that_is_not_taken_ends_no_step() {
    let machine = mass(
        "\"u.v\" = 1.0",
        &force("piecewise(x < -100 [m], -7 [N]*sign(sin(900 [1/m]*x)), 0 [N])"),
    );
    for method in [Method::Dop853, Method::Taylor, Method::Auto] {
        let run = run(&machine, method, 1e-8, &[]);
        assert!(run.work.steps < 40, "{method}: {} steps", run.work.steps);
    }
}

/// Returns the slots of relations at a state.
fn slots_at(simulator: &dyn Simulator<f64>, time: f64, state: &[f64], own: &[f64]) -> Vec<f64> {
    let mut guards = vec![0.0; simulator.kinks()];
    simulator.kink_guards(time, state, own, &mut guards);
    let slot = |index: usize| match simulator.relation(index).kind {
        RelationKind::Zone => 0.0,
        RelationKind::Branch if guards[index] < 0.0 => f64::NEG_INFINITY,
        RelationKind::Branch => f64::INFINITY,
        RelationKind::Whole => guards[index].floor(),
    };
    (0..simulator.relations()).map(slot).collect()
}

/// Number of entries of dy'/dy that were compared, and the worst of them.
struct Compared {
    entries: usize,
    settled: usize,
    worst: (f64, String),
}

fn compare_jacobian(simulator: &dyn Simulator<f64>, found: &mut Compared) {
    let states = simulator.shape().states();
    let own: Vec<f64> =
        (0..simulator.shape().parameters).map(|at| simulator.parameter_default(at)).collect();
    let mut start = vec![0.0; states];
    simulator.initial_state(&own, &mut start);
    let entries = simulator.rate_jacobian_pattern().entries;
    let state_at = |place: usize| -> Vec<f64> {
        let shift = |at: usize| simulator.state_scale(at) * ((place * 31 + at * 17) as f64).sin();
        (0..states)
            .map(|at| if simulator.is_mode(at) { start[at] } else { start[at] + shift(at) })
            .collect()
    };
    for place in 0..12 {
        // Held as at another state, as if a step went beyond a guard.
        let time = 0.1 + 0.37 * place as f64;
        let state = state_at(place);
        let held = [&own[..], &slots_at(simulator, time, &state_at(place + 50), &own)].concat();
        let mut jacobian = vec![0.0; entries.len()];
        simulator.rate_jacobian(time, &state, &held, &mut jacobian);
        let rate = |column: usize, by: f64| {
            let (mut state, mut rate) = (state.clone(), vec![0.0; states]);
            state[column] += by;
            simulator.rate(time, &state, &held, &mut rate);
            rate
        };
        for column in (0..states).filter(|at| !simulator.is_mode(*at)) {
            let h = 1e-5 * simulator.state_scale(column);
            let slopes = [1.0, 2.0].map(|times| {
                let pair = rate(column, times * h).into_iter().zip(rate(column, -times * h));
                pair.map(|(a, b)| (a - b) / (2.0 * times * h)).collect::<Vec<_>>()
            });
            for (index, (row, _)) in
                entries.iter().enumerate().filter(|(_, (_, at))| *at as usize == column)
            {
                let [one, two] = [slopes[0][*row as usize], slopes[1][*row as usize]];
                // Rounding, and terms that differences with this step do not resolve.
                let size = jacobian.iter().fold(one.abs(), |most, value| most.max(value.abs()));
                found.entries += 1;
                if !one.is_finite() || (one - two).abs() > 1e-6 * size {
                    continue;
                }
                found.settled += 1;
                let off = (jacobian[index] - one).abs() / size.max(f64::MIN_POSITIVE);
                if off > found.worst.0 || off.is_nan() {
                    let what =
                        format!("{} of {}", simulator.name(), simulator.state(*row as usize).name);
                    found.worst = (off, format!("{what} by {}", simulator.state(column).name));
                }
            }
        }
    }
}

/// A branch held in the rate but not in a derivative makes sensitivities wrong, and steps of
/// implicit methods short.
#[test]
fn jacobians_are_those_of_the_rate_with_branches_held() {
    let mut found = Compared { entries: 0, settled: 0, worst: (0.0, String::new()) };
    let root = folder_of_specs();
    let mut machines = 0;
    for path in specs_in(&root) {
        let name = path.strip_prefix(&root).expect("below it").with_extension("");
        let model = model_of_specs(name.to_str().expect("a plain path"), Keep::Needed);
        if !model.relations.is_empty() {
            machines += 1;
            compare_jacobian(ModelSimulator::interpreted(model).single(), &mut found);
        }
    }
    let Compared { entries, settled, worst: (off, what) } = found;
    println!(
        "{settled} of {entries} entries of {machines} machines, {off:.1e} off at most: {what}"
    );
    assert!(off < 1e-4, "{what}: {off:.1e}");
    assert!(machines > 20 && settled > entries * 9 / 10);
}

/// Laws of a place whose relations read other relations, which jump.
const NESTED: [&str; 5] = [
    "mod(mod(p, 0.6), 0.28)",
    "mod(mod(p, 0.6), 1.5)",
    "floor(floor(3*p)*0.7)",
    "piecewise(p < floor(p)*0.3, 0, 1)",
    "mod(abs(mod(p, 0.7) - 0.2), 0.15)",
];

fn nested(law: usize, p: f64) -> f64 {
    let floor_mod = |x: f64, y: f64| x - y * (x / y).floor();
    match law {
        0 => floor_mod(floor_mod(p, 0.6), 0.28),
        1 => floor_mod(floor_mod(p, 0.6), 1.5),
        2 => ((3.0 * p).floor() * 0.7).floor(),
        3 => f64::from(u8::from(p >= p.floor() * 0.3)),
        _ => floor_mod((floor_mod(p, 0.7) - 0.2).abs(), 0.15),
    }
}

#[test]
fn relations_jump_to_the_side_to_which_relations_they_read_take_them() {
    const PARTS: i32 = 200_000;
    let law = |law: &str| law.replace("p,", "x/m,").replace("p ", "x/m ").replace("p)", "x/m)");
    let sum = |(number, text): (usize, &&str)| {
        format!("z{number} = {{ unit = \"s\", rate = \"{}\" }}", law(text))
    };
    let sums: Vec<String> = NESTED.iter().enumerate().map(sum).collect();
    let sums = sums.join("\n");
    let parameters = "[define.u.parameters]\nm = { value = 1, unit = \"m\" }\n";
    let definition = format!("{parameters}[define.u.states]\n{sums}");
    let machine = mass("\"u.x\" = 0.1", &definition);
    for speed in [1.0, -1.0, 0.77, -1.3] {
        let step = 3.0 / f64::from(PARTS);
        let place = |k: i32| 0.1 + speed * (f64::from(k) + 0.5) * step;
        let sum = |law: usize| (0..PARTS).map(|k| nested(law, place(k)) * step).sum::<f64>();
        let sums: Vec<f64> = (0..NESTED.len()).map(sum).collect();
        for method in OWN {
            let run = Simulation::new(&machine).method(method).rtol(1e-8);
            let run = run.initial_value("u.v", speed).expect("a state").run().expect("a run");
            for (number, sum) in sums.iter().enumerate() {
                let what = format!("{method}, {speed} m/s, {}", NESTED[number]);
                assert_near(last(&run, &format!("u.z{number}")), *sum, 3e-4, &what);
            }
        }
    }
}

/// Methods without zero crossings evaluate branches live.
#[test]
fn a_mass_with_play_bounces_to_and_fro_by_methods_that_locate_no_surfaces() {
    let play = "-200 [N/m]*(max(x - 0.1 [m], 0) + min(x + 0.1 [m], 0))";
    let machine = mass("\"u.v\" = 1.0", &force(play));
    // A flight through the play takes 0.2 s, and a contact half a period of the spring.
    let rate = 200.0_f64.sqrt();
    let contact = std::f64::consts::PI / rate;
    let into_flight = (3.0_f64 - 0.1 - contact).rem_euclid(2.0 * (contact + 0.2));
    assert!((0.2 + contact..0.4 + contact).contains(&into_flight) || into_flight < 0.2);
    let x = if into_flight < 0.2 { 0.1 - into_flight } else { into_flight - contact - 0.3 };
    for method in [Method::Bdf, Method::TrBdf2, Method::Esdirk34, Method::Tsit45, Method::Radau] {
        let run = run(&machine, method, 1e-7, &[]);
        assert_near(last(&run, "u.x"), x, 2e-4, method.name());
    }
}

/// The remainder jumps where the arguments of both functions are zero.
#[test]
fn zones_that_are_nearest_where_an_integer_changes_end_and_carry_sensitivities() {
    let machine = mass(
        "\"u.x\" = -0.1\n\"u.v\" = 1.0",
        r#"
        [define.u.parameters]
        k = { value = 1.8, unit = "1/m" }
        [define.u.states.z]
        unit = "s"
        rate = "tanh(mod(piecewise(-5 [m] < x, k*x, tanh(2.4 [1/m]*x)), 1.5))"
        "#,
    );
    // Integrals of tanh(k x - 1.5 j).
    let of_tanh = |k: f64, from: f64, to: f64| (to.cosh().ln() - from.cosh().ln()) / k;
    let sum = |k: f64| {
        of_tanh(k, 1.5 - 0.1 * k, 1.5) + 3.0 * of_tanh(k, 0.0, 1.5) + of_tanh(k, 0.0, 2.9 * k - 4.5)
    };
    let slope = (sum(1.8 + 1e-5) - sum(1.8 - 1e-5)) / 2e-5;
    for method in [Method::Tsit5, Method::Dop853, Method::Radau, Method::Auto] {
        let run = Simulation::new(&machine).method(method).rtol(1e-8).max_steps(10_000);
        let run = run.sensitivities(&["u.k"]).expect("a parameter").run();
        let run = run.unwrap_or_else(|error| panic!("{method}: {error}"));
        assert_near(last(&run, "u.z"), sum(1.8), 1e-6, method.name());
        let found = *run.sensitivity("u.z", "u.k").expect("a column").last().expect("a row");
        assert_near(found, slope, 1e-4, method.name());
    }
}

/// A step begins at a tick and would go on behind the wall, where the guard of the tick is on its
/// other side again. The oscillation of `p` limits steps to such lengths.
#[test]
fn a_wall_just_behind_a_tick_is_no_tick() {
    let machine = mass(
        "\"u.v\" = 1.0\n\"u.p\" = 1.0",
        r#"
        [define.u.parameters]
        pitch = { value = 0.05, unit = "m" }
        wall = { value = 1.0, unit = "m" }
        [define.u.states]
        side = { unit = "1", rate = "piecewise(mod(n, 8) < 4, 1 [1/s], -1 [1/s])" }
        p = { unit = "1", rate = "4 [1/s]*q" }
        q = { unit = "1", rate = "-4 [1/s]*p" }
        [define.u.modes.n]
        [define.u.events.tick]
        guard = "sin(x/pitch) - 0.5"
        direction = "rising"
        set = { n = "n + 1" }
        [define.u.events.hit]
        guard = "x - wall"
        direction = "rising"
        set = { v = "-v" }
        "#,
    );
    let (pitch, turn) = (0.05, std::f64::consts::TAU);
    for part in 0..24 {
        let wall = pitch * turn * (3.0 + (f64::from(part) + 0.5) / 24.0);
        // The guard rises at a twelfth of a turn on the way there, and at five twelfths on the way
        // back, to 2 wall - 3 m.
        let upwards = (wall / (pitch * turn) - 1.0 / 12.0).ceil();
        let line = |place: f64| (place / (pitch * turn) - 5.0 / 12.0).ceil();
        let ticks = upwards + line(wall) - line(2.0 * wall - 3.0);
        for method in OWN {
            for rtol in [1e-4, 1e-6, 1e-8] {
                let run = run(&machine, method, rtol, &[("u.wall", wall)]);
                let what = format!("{method} at {rtol:e}, {wall} m");
                assert_near(last(&run, "u.n"), ticks, 0.5, &what);
            }
        }
    }
}

//! Machines that are linear between switches, solved in closed form: compared with power series in
//! numbers of 31 digits for equations written by hand, with closed forms and with other methods.

use machinist::error::StopCause;
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe, Real};
use machinist_model::ModelSimulator;
use machinist_studies::double_double::DoubleDouble;

use crate::own_scene::of_text;

type Row = Vec<(usize, f64)>;

/// A machine by hand: z' = M z in each mode, with guards that are positive within it.
struct Machine {
    matrices: Vec<Vec<Row>>,
    guards: Vec<Vec<Row>>,
    /// Returns the mode after a guard has crossed zero.
    next: fn(usize, &mut [DoubleDouble]) -> usize,
    /// Step of the series \[s\], short enough for guards to be monotone over an eighth of it.
    step: f64,
}

const ORDER: usize = 34;

fn number(value: f64) -> DoubleDouble {
    DoubleDouble::literal(value)
}

fn product(row: &Row, z: &[DoubleDouble]) -> DoubleDouble {
    row.iter().fold(number(0.0), |sum, (entry, slope)| sum + number(*slope) * z[*entry])
}

fn sum(terms: &[DoubleDouble], at: DoubleDouble) -> DoubleDouble {
    terms.iter().rev().fold(number(0.0), |sum, term| sum * at + *term)
}

impl Machine {
    /// Returns z at some times, from a state and mode at time zero.
    fn solve(&self, start: &[f64], mut mode: usize, times: &[f64]) -> Vec<Vec<f64>> {
        let mut z: Vec<DoubleDouble> = start.iter().copied().map(number).collect();
        let mut time = number(0.0);
        let mut rows = Vec::new();
        for at in times {
            loop {
                let left = number(*at) - time;
                if left.to_f64() <= 0.0 {
                    break;
                }
                let span = if left.to_f64() < self.step { left } else { number(self.step) };
                let series = self.series(mode, &z);
                let (taken, has_switched) = self.until_switch(mode, &series, span);
                z = series.iter().map(|terms| sum(terms, taken)).collect();
                time = time + taken;
                if has_switched {
                    mode = (self.next)(mode, &mut z);
                }
            }
            rows.push(z.iter().map(|value| value.to_f64()).collect());
        }
        rows
    }

    /// Returns the power series of each entry of z.
    fn series(&self, mode: usize, z: &[DoubleDouble]) -> Vec<Vec<DoubleDouble>> {
        let mut terms = vec![z.to_vec()];
        for order in 1..=ORDER {
            let last = &terms[order - 1];
            let factor = number(1.0) / number(order as f64);
            terms.push(self.matrices[mode].iter().map(|row| product(row, last) * factor).collect());
        }
        (0..z.len()).map(|entry| terms.iter().map(|terms| terms[entry]).collect()).collect()
    }

    /// Returns the first time at which a guard falls to zero within a span, or the span.
    fn until_switch(
        &self,
        mode: usize,
        series: &[Vec<DoubleDouble>],
        span: DoubleDouble,
    ) -> (DoubleDouble, bool) {
        const PARTS: usize = 8;
        let mut first = (span, false);
        for guard in &self.guards[mode] {
            let terms: Vec<DoubleDouble> = (0..=ORDER)
                .map(|k| {
                    guard.iter().fold(number(0.0), |sum, (entry, slope)| {
                        sum + number(*slope) * series[*entry][k]
                    })
                })
                .collect();
            let part = |part: usize| span * number(part as f64 / PARTS as f64);
            // A guard may be zero at the start of a mode.
            let mut was_positive = false;
            for k in 0..=PARTS {
                let value = sum(&terms, part(k)).to_f64();
                if was_positive && value <= 0.0 {
                    let root = root(&terms, part(k - 1), part(k));
                    if root.to_f64() < first.0.to_f64() || !first.1 {
                        first = (root, true);
                    }
                    break;
                }
                was_positive |= value > 0.0;
            }
        }
        first
    }
}

/// Returns the zero of a polynomial between two places, by bisection and Newton's method.
fn root(terms: &[DoubleDouble], mut low: DoubleDouble, mut high: DoubleDouble) -> DoubleDouble {
    for _ in 0..40 {
        let middle = (low + high) * number(0.5);
        if sum(terms, middle).to_f64() > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let slopes: Vec<DoubleDouble> =
        terms.iter().enumerate().skip(1).map(|(k, term)| *term * number(k as f64)).collect();
    let mut root = high;
    for _ in 0..3 {
        root = root - sum(terms, root) / sum(&slopes, root);
    }
    root
}

/// Returns a spec of one unit.
fn spec(coordinates: &str, parameters: &str, energy: &str, rest: &str, run: &str) -> String {
    format!(
        r#"
[scene]
name = "switched"
[units.u]
unit = "u"
{coordinates}
[define.u.parameters]
{parameters}
{energy}
{rest}
{run}
rtol = 1e-9
method = "auto"
"#
    )
}

fn machine(text: &str) -> ModelSimulator {
    of_text(text, Keep::All)
}

fn run(simulator: &ModelSimulator, method: Method) -> Trajectory {
    let run = Simulation::new(simulator).method(method).run();
    run.unwrap_or_else(|error| panic!("{method}: {error}"))
}

/// Asserts that a run in closed form agrees with a reference in states of these names.
fn assert_right(
    simulator: &ModelSimulator,
    names: &[&str],
    (reference, start, mode): (&Machine, &[f64], usize),
) {
    let exact = run(simulator, Method::Exact);
    let rows = reference.solve(start, mode, &exact.times);
    for (index, name) in names.iter().enumerate() {
        let values = exact.column(name).expect("a state");
        let size = rows.iter().map(|row| row[index].abs()).fold(0.0, f64::max);
        let errors = values.iter().zip(&rows).map(|(value, row)| (value - row[index]).abs());
        let error = errors.fold(0.0, f64::max) / size;
        println!("{name}: {error:.1e}, {:?}", exact.work);
        assert!(error < 1e-10, "{name}: {error:e}");
    }
    let is_closed = |note: &String| note.contains("in closed form from one to the next");
    assert!(exact.notes.iter().any(is_closed), "{:?}", exact.notes);
    assert!(exact.work.newton_iterations == 0 && exact.work.rejected == 0, "{:?}", exact.work);
}

/// Returns the rows of a driven mass: z = [x, v, 1, cos w t, sin w t].
fn driven_mass(w: f64, force: Row) -> Vec<Row> {
    vec![vec![(1, 1.0)], force, vec![], vec![(4, -w)], vec![(3, w)]]
}

const MASS: &str = "[define.u.coordinates.x]\nunit = \"m\"\nvelocity = \"v\"";

#[test]
fn a_mass_in_a_play_is_right_over_a_thousand_seconds() {
    let (k, g, c, a, w) = (40.0, 0.05, 0.4, 3.0, 2.3);
    let text = spec(
        MASS,
        "m = { value = 1, unit = \"kg\" }\nk = { value = 40, unit = \"N/m\" }\ng = { value = 0.05, \
         unit = \"m\" }\nc = { value = 0.4, unit = \"N s/m\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2\"\ndissipation = \"c*v^2/2\"",
        "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"-k*(max(x - g, 0) + min(x + g, \
         0)) + 3 [N]*cos(2.3 [rad/s]*t)\"",
        "[initial]\n\"u.x\" = 0.1\n\"u.v\" = 0.2\n[run]\nuntil = 1000\npoints = 501",
    );
    let held = |side: f64| driven_mass(w, vec![(0, -k), (1, -c), (2, side * k * g), (3, a)]);
    let reference = Machine {
        matrices: vec![driven_mass(w, vec![(1, -c), (3, a)]), held(1.0), held(-1.0)],
        guards: vec![
            vec![vec![(2, g), (0, -1.0)], vec![(2, g), (0, 1.0)]],
            vec![vec![(0, 1.0), (2, -g)]],
            vec![vec![(0, -1.0), (2, -g)]],
        ],
        next: |mode, z| match mode {
            0 if z[0].to_f64() > 0.0 => 1,
            0 => 2,
            _ => 0,
        },
        step: 0.05,
    };
    assert_right(&machine(&text), &["u.x", "u.v"], (&reference, &[0.1, 0.2, 1.0, 1.0, 0.0], 1));
}

#[test]
fn a_mass_on_a_damped_stop_is_right_over_a_thousand_seconds() {
    let (k, ks, cs, g, c, a, w) = (30.0, 200.0, 0.5, 0.05, 0.4, 3.0, 4.3);
    let text = spec(
        MASS,
        "m = { value = 1, unit = \"kg\" }\nk = { value = 30, unit = \"N/m\" }\nks = { value = \
         200, unit = \"N/m\" }\ncs = { value = 0.5, unit = \"N s/m\" }\ng = { value = 0.05, unit = \
         \"m\" }\nc = { value = 0.4, unit = \"N s/m\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2\"\npotential = \"k*x^2/2\"\ndissipation = \
         \"c*v^2/2\"",
        "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"piecewise(x < g, 0, -ks*(x - g) \
         - cs*v) + 3 [N]*cos(4.3 [rad/s]*t)\"",
        "[initial]\n\"u.v\" = 0.2\n[run]\nuntil = 1000\npoints = 501",
    );
    let free = driven_mass(w, vec![(0, -k), (1, -c), (3, a)]);
    let held = driven_mass(w, vec![(0, -k - ks), (1, -c - cs), (2, ks * g), (3, a)]);
    let reference = Machine {
        matrices: vec![free, held],
        guards: vec![vec![vec![(2, g), (0, -1.0)]], vec![vec![(0, 1.0), (2, -g)]]],
        next: |mode, _| 1 - mode,
        step: 0.02,
    };
    assert_right(&machine(&text), &["u.x", "u.v"], (&reference, &[0.0, 0.2, 1.0, 1.0, 0.0], 0));
}

fn coulomb(friction: &str) -> String {
    spec(
        MASS,
        "m = { value = 1, unit = \"kg\" }\nk = { value = 25, unit = \"N/m\" }\nF = { value = 1, \
         unit = \"N\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2\"\npotential = \"k*x^2/2\"",
        &format!(
            "{friction}\n[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"1.9 [N]*cos(1.7 \
             [rad/s]*t)\""
        ),
        "[initial]\n\"u.x\" = 0.3\n[run]\nuntil = 1000\npoints = 501",
    )
}

/// While it sticks, friction is what keeps the velocity zero: as a motion along the surface of a
/// sign, and as a constraint of a declared friction.
#[test]
fn an_oscillator_with_dry_friction_is_right_over_a_thousand_seconds() {
    let (k, f, a, w) = (25.0, 1.0, 1.9, 1.7);
    let slips = |side: f64| driven_mass(w, vec![(0, -k), (2, -side * f), (3, a)]);
    let sticks = vec![vec![], vec![], vec![], vec![(4, -w)], vec![(3, w)]];
    let reference = Machine {
        matrices: vec![sticks, slips(1.0), slips(-1.0)],
        guards: vec![
            vec![vec![(2, f), (3, -a), (0, k)], vec![(2, f), (3, a), (0, -k)]],
            vec![vec![(1, 1.0)]],
            vec![vec![(1, -1.0)]],
        ],
        next: |mode, z| {
            let force = (number(1.9) * z[3] - number(25.0) * z[0]).to_f64();
            z[1] = number(0.0);
            match mode {
                0 if force > 0.0 => 1,
                0 => 2,
                _ if force.abs() <= 1.0 => 0,
                _ if force > 0.0 => 1,
                _ => 2,
            }
        },
        step: 0.05,
    };
    let sign = "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"-F*sign(v)\"";
    let declared = "[define.u.friction.rub]\nunit = \"N\"\nspeed = \"v\"\nsliding = \"F\"";
    for friction in [sign, declared] {
        let simulator = machine(&coulomb(friction));
        assert_right(&simulator, &["u.x", "u.v"], (&reference, &[0.3, 0.0, 1.0, 1.0, 0.0], 2));
    }
}

#[test]
fn a_converter_is_right_over_ten_thousand_periods() {
    let (l, c, r, load, v, period, duty) = (1e-4, 1e-5, 0.1, 5.0, 12.0, 1e-5, 0.42);
    let text = spec(
        "[define.u.states.i]\nunit = \"A\"\nrate = \"(piecewise(mod(t/T, 1) < D, V, 0) - e - \
         R*i)/L\"\n[define.u.states.e]\nunit = \"V\"\nrate = \"(i - e/Rl)/C\"",
        "L = { value = 1e-4, unit = \"H\" }\nC = { value = 1e-5, unit = \"F\" }\nR = { value = \
         0.1, unit = \"ohm\" }\nRl = { value = 5, unit = \"ohm\" }\nV = { value = 12, unit = \
         \"V\" }\nT = { value = 1e-5, unit = \"s\" }\nD = { value = 0.42, unit = \"1\" }",
        "",
        "",
        "[run]\nuntil = 0.1\npoints = 101",
    );
    // z = [i, e, 1, time within the period].
    let held = |on: f64| {
        let current = vec![(0, -r / l), (1, -1.0 / l), (2, on * v / l)];
        vec![current, vec![(0, 1.0 / c), (1, -1.0 / (load * c))], vec![], vec![(2, 1.0)]]
    };
    let until = |end: f64| vec![vec![(2, end), (3, -1.0)]];
    let reference = Machine {
        matrices: vec![held(1.0), held(0.0)],
        guards: vec![until(duty * period), until(period)],
        next: |mode, z| {
            if mode == 1 {
                z[3] = z[3] - number(1e-5);
            }
            1 - mode
        },
        step: 4e-6,
    };
    assert_right(&machine(&text), &["u.i", "u.e"], (&reference, &[0.0, 0.0, 1.0, 0.0], 0));
}

#[test]
fn two_masses_with_a_play_between_them_are_right_over_a_thousand_seconds() {
    let (m, k, g, c, a, w, k0) = (2.0, 300.0, 0.02, 0.8, 4.0, 2.0, 5.0);
    let text = spec(
        "[define.u.coordinates.x]\nunit = \"m\"\nvelocity = \"v\"\n[define.u.coordinates.y]\nunit \
         = \"m\"\nvelocity = \"u\"",
        "k = { value = 300, unit = \"N/m\" }\ng = { value = 0.02, unit = \"m\" }\nc = { value = \
         0.8, unit = \"N s/m\" }\nm = { value = 1, unit = \"kg\" }\nk0 = { value = 5, unit = \
         \"N/m\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2 + m*u^2\"\npotential = \"k0*x^2/2\"\ndissipation \
         = \"c*(v^2 + u^2)/2\"\n[define.u.helpers.gear]\nunit = \"N\"\nexpression = \"k*(max(x - \
         y - g, 0) + min(x - y + g, 0))\"",
        "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"4 [N]*cos(2 [rad/s]*t) - \
         gear\"\n[[define.u.forces]]\ncoordinate = \"y\"\nexpression = \"gear\"",
        "[initial]\n\"u.v\" = 0.1\n[run]\nuntil = 1000\npoints = 501",
    );
    // z = [x, y, v, u, 1, cos w t, sin w t].
    let held = |stiffness: f64, offset: f64| {
        let gear =
            |share: f64| vec![(0, share * stiffness), (1, -share * stiffness), (4, share * offset)];
        let mut first = vec![(0, -k0), (2, -c), (5, a)];
        first.extend(gear(-1.0));
        let mut second = vec![(3, -c / m)];
        second.extend(gear(1.0 / m));
        vec![vec![(2, 1.0)], vec![(3, 1.0)], first, second, vec![], vec![(6, -w)], vec![(5, w)]]
    };
    let gap = |side: f64| vec![(4, g), (0, -side), (1, side)];
    let beyond = |side: f64| vec![vec![(4, -g), (0, side), (1, -side)]];
    let reference = Machine {
        matrices: vec![held(0.0, 0.0), held(k, -k * g), held(k, k * g)],
        guards: vec![vec![gap(1.0), gap(-1.0)], beyond(1.0), beyond(-1.0)],
        next: |mode, z| match mode {
            0 if (z[0] - z[1]).to_f64() > 0.0 => 1,
            0 => 2,
            _ => 0,
        },
        step: 0.02,
    };
    let start = [0.0, 0.0, 0.1, 0.0, 1.0, 1.0, 0.0];
    assert_right(&machine(&text), &["u.x", "u.y", "u.v", "u.u"], (&reference, &start, 0));
}

/// The energy account, outputs and events of a ball under gravity: (1 + e)/(1 - e) sqrt(2 h/g) until
/// it rests, with an energy lost of 1 - e^2 at each impact.
#[test]
fn impacts_of_a_ball_follow_their_closed_form() {
    let text = spec(
        MASS,
        "m = { value = 2, unit = \"kg\" }\ne = { value = 0.8, unit = \"1\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2\"\npotential = \"m*9.81 [m/s^2]*x\"",
        "[define.u.events.impact]\nguard = \"x\"\ndirection = \"falling\"\nset = { v = \"-e*v\" }",
        "[initial]\n\"u.x\" = 1\n[run]\nuntil = 3\npoints = 301",
    );
    let simulator = machine(&text);
    let run = Simulation::new(&simulator).method(Method::Exact).with_energy_balance(true).run();
    let run = run.expect("a run");
    let fall = (2.0 / 9.81_f64).sqrt();
    let time = |impact: i32| fall * (1.0 + 2.0 * (1..impact).map(|k| 0.8_f64.powi(k)).sum::<f64>());
    assert!(run.switches.len() > 5);
    for (impact, switch) in (1..).zip(&run.switches) {
        assert!((switch.time - time(impact)).abs() < 1e-14 * 8.0, "{impact}: {}", switch.time);
    }
    // A flight is one step, however long.
    assert!(run.work.steps < 8 * run.switches.len() as u64, "{:?}", run.work);
    let balance = run.energy_balance.as_ref().expect("an account");
    let largest = balance.residual.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(largest < 1e-12 * 19.62, "{largest:e}");
}

/// Sensitivities jump at switches as those of other methods do.
#[test]
fn sensitivities_agree_with_those_of_steps() {
    let sign = "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"-F*sign(v)\"";
    let declared = "[define.u.friction.rub]\nunit = \"N\"\nspeed = \"v\"\nsliding = \"F\"";
    for friction in [sign, declared] {
        let simulator = machine(&coulomb(friction));
        let by = |method: Method| {
            let run = Simulation::new(&simulator).method(method).rtol(1e-11).until(20.0);
            let run =
                run.points(41).sensitivities(&["u.k", "u.F", "u.x"]).and_then(|run| run.run());
            run.unwrap_or_else(|error| panic!("{method}: {error}"))
        };
        let (exact, stepped) = (by(Method::Exact), by(Method::Dop853));
        assert_eq!(exact.columns.len(), stepped.columns.len());
        for (ours, theirs) in exact.columns.iter().zip(&stepped.columns) {
            let size = theirs.values.iter().fold(1e-3, |size: f64, value| size.max(value.abs()));
            for (time, (ours_at, theirs_at)) in
                exact.times.iter().zip(ours.values.iter().zip(&theirs.values))
            {
                let error = (ours_at - theirs_at).abs() / size;
                assert!(error < 1e-8, "{} at {time}: {ours_at} {theirs_at}", ours.name);
            }
        }
    }
}

/// A linear machine without switches carries sensitivities, too: those of a damped oscillator are
/// differences of its closed form.
#[test]
fn sensitivities_of_a_linear_machine_are_those_of_its_closed_form() {
    let text = spec(
        MASS,
        "m = { value = 1, unit = \"kg\" }\nk = { value = 9, unit = \"N/m\" }\nc = { value = 0.4, \
         unit = \"N s/m\" }",
        "[define.u.energy]\nkinetic = \"m*v^2/2\"\npotential = \"k*x^2/2\"\ndissipation = \
         \"c*v^2/2\"",
        "",
        "[initial]\n\"u.x\" = 0.3\n[run]\nuntil = 50\npoints = 101",
    );
    let simulator = machine(&text);
    let run = Simulation::new(&simulator).method(Method::Exact).sensitivities(&["u.k"]);
    let run = run.and_then(|run| run.run()).expect("a run");
    let place = |k: f64, t: f64| {
        let w = (k - 0.04_f64).sqrt();
        0.3 * (-0.2 * t).exp() * ((w * t).cos() + 0.2 / w * (w * t).sin())
    };
    let column = run.columns.iter().find(|column| column.name.starts_with("d(u.x)")).expect("d x");
    for (time, value) in run.times.iter().zip(&column.values) {
        let difference = (place(9.0 + 1e-4, *time) - place(9.0 - 1e-4, *time)) / 2e-4;
        assert!((value - difference).abs() < 1e-9, "{time}: {value} {difference}");
    }
}

/// Random machines with relations of all kinds agree with steps at a tight tolerance.
#[test]
fn random_machines_agree_with_steps() {
    let forces = [
        "-60 [N/m]*(max(x - 0.05 [m], 0) + min(x + 0.05 [m], 0))",
        "-0.7 [N]*sign(v)",
        "-40 [N/m]*abs(x)",
        "-8 [N/m]*(x - 0.03 [m]*mod(x/(0.03 [m]), 1))",
        "piecewise(mod(t/(0.3 [s]), 1) < 0.4, 2 [N], -1 [N])",
        "piecewise(v < 0.1 [m/s], -9 [N s/m]*v, 1.5 [N]*step(t, 1.2 [s]))",
        "max(-2 [N], min(2 [N], -90 [N/m]*x - 4 [N s/m]*v))",
        "piecewise(x < 0.02 [m], 0 [N], 0.13 [N/s]*t)",
    ];
    let mut random = fastrand::Rng::with_seed(4711);
    for case in 0..24 {
        let mut number = |low: f64, high: f64| low + (high - low) * random.f64();
        let (k, c, a, w) =
            (number(2.0, 60.0), number(0.05, 0.8), number(0.5, 3.0), number(0.7, 7.0));
        let (x, v) = (number(-0.3, 0.3), number(-1.0, 1.0));
        let chosen: Vec<&str> =
            (0..random.usize(1..=3)).map(|_| forces[random.usize(0..8)]).collect();
        let forces: Vec<String> = chosen
            .iter()
            .map(|force| {
                format!("[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"{force}\"")
            })
            .collect();
        let text = spec(
            MASS,
            &format!(
                "m = {{ value = 1, unit = \"kg\" }}\nk = {{ value = {k:?}, unit = \"N/m\" }}\nc = \
                 {{ value = {c:?}, unit = \"N s/m\" }}"
            ),
            "[define.u.energy]\nkinetic = \"m*v^2/2\"\npotential = \"k*x^2/2\"\ndissipation = \
             \"c*v^2/2\"",
            &format!(
                "{}\n[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"{a:?} [N]*cos({w:?} \
                 [rad/s]*t)\"",
                forces.join("\n")
            ),
            &format!("[initial]\n\"u.x\" = {x:?}\n\"u.v\" = {v:?}\n[run]\nuntil = 4\npoints = 41"),
        );
        let simulator = machine(&text);
        assert!(Method::Exact.suits(&simulator), "{chosen:?}");
        let exact = run(&simulator, Method::Exact);
        let stepped = Simulation::new(&simulator).method(Method::Dop853).rtol(1e-12).run();
        let stepped = stepped.unwrap_or_else(|error| panic!("{case} {chosen:?}: {error}"));
        for (ours, theirs) in exact.columns.iter().zip(&stepped.columns) {
            let size = theirs.values.iter().fold(1.0, |size: f64, value| size.max(value.abs()));
            let pairs = ours.values.iter().zip(&theirs.values);
            let error = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size;
            assert!(error < 2e-8, "{case} {chosen:?} {}: {error:e}", ours.name);
        }
    }
}

/// A product of states is refused, with or without relations.
#[test]
fn machines_that_are_not_linear_between_switches_are_refused() {
    for force in
        ["-F*sign(v)*x/(1 [m])", "-F*sign(x^2 - 0.01 [m^2])", "-F*abs(x)*abs(v)/(1 [m^2/s])"]
    {
        let force = format!("[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"{force}\"");
        let simulator = machine(&coulomb(&force));
        let is_linear = Method::Exact.suits(&simulator);
        match Simulation::new(&simulator).method(Method::Exact).until(1.0).run() {
            Err(SimulateError::Stopped { cause: StopCause::NotLinear, .. }) => {
                assert!(!is_linear && simulator.relations() > 0, "{force}");
            }
            // A force that is linear on each side of a sign is none.
            other => assert!(is_linear && other.is_ok(), "{force}: {other:?}"),
        }
    }
}

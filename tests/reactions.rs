//! Forces in proportion to constraint forces: rough rings, ladders, rods and gears compared with
//! closed forms and with equations solved for all combinations of signs.

use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use nalgebra::{Matrix5, Vector5};

use crate::common::column;
use crate::own_scene::{model_of_specs, of_text, refusal, system_of};

const METHODS: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

const GRAVITY: f64 = 9.81;

const RING: &str = r#"
    [scene]
    name = "ring"
    [units.bead]
    unit = "bead"
    [initial]
    "bead.x" = "bead.radius*sin(start)"
    "bead.y" = "-bead.radius*cos(start)"
    [parameters]
    start = { value = 1.0, unit = "rad" }
    [outputs]
    normal = "bead.ring"
    rub = "bead.rub"
    [run]
    until = 3.0
    points = 301
    rtol = 1e-9
    method = "auto"
    [define.bead.coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    [define.bead.parameters]
    mass = { value = 2.0, unit = "kg" }
    radius = { value = 0.7, unit = "m" }
    mu = { value = 0.2, unit = "1" }
    [define.bead.energy]
    kinetic = "mass*(x_dot^2 + y_dot^2)/2"
    potential = "mass*9.81 [m/s^2]*y"
    [define.bead.constraints.ring]
    expression = "sqrt(x^2 + y^2) - radius"
    [define.bead.friction.rub]
    speed = "(x*y_dot - y*x_dot)/radius"
    sliding = "mu*abs(ring)"
    unit = "N"
"#;

fn with(
    machine: &ModelSimulator,
    values: &[(&str, f64)],
    method: Method,
) -> Result<Trajectory, SimulateError> {
    let mut run = Simulation::new(machine).method(method);
    for (name, value) in values {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.run()
}

/// On the way down from rest at the angle a from the bottom, w = phi'^2 fulfils
/// dw/dphi = 2 mu (w + k cos phi) - 2 k sin phi, k = g/radius.
#[test]
fn a_bead_on_a_rough_ring_swings_by_its_closed_form_and_stops() {
    let ring = of_text(RING, Keep::All);
    let mut compared = 0;
    for (place, mu) in [0.02, 0.2, 0.5, 0.9].into_iter().enumerate() {
        for (number, start) in [-1.5, -1.2, 1.0, 1.4].into_iter().enumerate() {
            if f64::tan(f64::abs(start)) < 1.05 * mu {
                continue;
            }
            let method = METHODS[(place + number) % METHODS.len()];
            let run = with(&ring, &[("bead.mu", mu), ("start", start)], method).expect("it runs");
            let k = GRAVITY / 0.7;
            let share = k / (1.0 + 4.0 * mu * mu);
            let part = |phi: f64| {
                2.0 * (1.0 - 2.0 * mu * mu) * share * phi.cos() + 6.0 * mu * share * phi.sin()
            };
            let a = f64::abs(start);
            let exact = |phi: f64| part(phi) - part(a) * f64::exp(2.0 * mu * (phi - a));
            let (x, y) = (column(&run, "bead.x"), column(&run, "bead.y"));
            let (vx, vy) = (column(&run, "bead.x_dot"), column(&run, "bead.y_dot"));
            let (slip, normal) = (column(&run, "bead.rub_slip"), column(&run, "normal"));
            let way = -start.signum();
            let rows = (0..x.len()).skip_while(|row| slip[*row] == 0.0);
            for row in rows.take_while(|row| slip[*row] * way > 0.0) {
                let phi = -way * f64::atan2(x[row], -y[row]);
                let w = (vx[row] * vx[row] + vy[row] * vy[row]) / (0.7 * 0.7);
                let case = format!("{mu} from {start} by {method}, row {row}");
                assert!((w - exact(phi)).abs() < 1e-7 * k, "{case}: {w} for {}", exact(phi));
                // The ring pulls inwards, against growing radius.
                let force = -2.0 * 0.7 * (w + k * phi.cos());
                assert!((normal[row] - force).abs() < 1e-6 * 2.0 * GRAVITY, "{case}: {force}");
                compared += 1;
            }
            // It ends where it can rest.
            if slip.last() == Some(&0.0) {
                let last = x.len() - 1;
                let steep = f64::abs(x[last] / y[last]);
                assert!(steep < mu * (1.0 + 1e-9), "{mu} from {start}: rests at {steep}");
            }
        }
    }
    assert!(compared > 400, "{compared}");
}

#[test]
fn all_methods_agree_on_friction_by_a_constraint_force_and_lose_what_it_takes() {
    let ring = of_text(RING, Keep::All);
    let ends = METHODS.map(|method| {
        let run = Simulation::new(&ring).method(method).with_energy_balance(true);
        let run = run.run().expect("it runs");
        let energy = run.energy_balance.as_ref().expect("an account");
        assert!(
            energy.max_residual_relative() < 1e-7,
            "{method}: {}",
            energy.max_residual_relative()
        );
        [run.last("bead.x"), run.last("bead.y")].map(|end| end.expect("a state"))
    });
    for (end, method) in ends.iter().zip(METHODS) {
        for (a, b) in end.iter().zip(&ends[0]) {
            assert!((a - b).abs() < 1e-7, "{method}: {a} for {b}");
        }
    }
}

/// The heat of the friction is what the motion loses, T + V at the start less that at any time.
#[test]
fn a_state_takes_up_the_heat_of_friction_by_a_constraint_force() {
    let heated = RING.to_owned()
        + "    [define.bead.states.heat]\n    unit = \"J\"\n    rate = \"-rub_slide*(x*y_dot - y*x_dot)/radius\"\n";
    let machine = of_text(&heated, Keep::All);
    for method in METHODS {
        let run = with(&machine, &[], method).expect("it runs");
        let energy = column(&run, "energy.total");
        for (row, heat) in column(&run, "bead.heat").iter().enumerate() {
            let lost = energy[0] - energy[row];
            assert!((heat - lost).abs() < 1e-7 * GRAVITY, "{method}: {heat} for {lost}");
        }
    }
}

const LADDER: &str = r#"
    [scene]
    name = "ladder"
    [units.ladder]
    unit = "ladder"
    [initial]
    "ladder.angle" = 1.0
    [guess]
    "ladder.x" = 1.08
    "ladder.y" = 1.68
    [outputs]
    floor = "ladder.floor"
    wall = "ladder.wall"
    [run]
    until = 0.1
    points = 11
    rtol = 1e-9
    method = "auto"
    [define.ladder.coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    angle = { unit = "rad" }
    [define.ladder.parameters]
    mass = { value = 10.0, unit = "kg" }
    half = { value = 2.0, unit = "m" }
    inertia = { value = 13.0, unit = "kg m^2" }
    mu_floor = { value = 0.15, unit = "1" }
    mu_wall = { value = 0.25, unit = "1" }
    push = { value = 0.0, unit = "N" }
    [define.ladder.energy]
    kinetic = "mass*(x_dot^2 + y_dot^2)/2 + inertia*angle_dot^2/2"
    potential = "mass*9.81 [m/s^2]*y"
    [[define.ladder.forces]]
    coordinate = "x"
    expression = "push"
    [define.ladder.constraints.floor]
    expression = "y - half*sin(angle)"
    [define.ladder.constraints.wall]
    expression = "x - half*cos(angle)"
    [define.ladder.friction.on_floor]
    speed = "x_dot - half*sin(angle)*angle_dot"
    sliding = "mu_floor*abs(floor)"
    unit = "N"
    [define.ladder.friction.on_wall]
    speed = "y_dot + half*cos(angle)*angle_dot"
    sliding = "mu_wall*abs(wall)"
    unit = "N"
"#;

/// A ladder at an angle, with friction coefficients along directions of sliding.
struct Ladder {
    angle: f64,
    rate: f64,
    push: f64,
    friction: [f64; 2],
    ways: [f64; 2],
}

impl Ladder {
    /// Returns x'', y'', angle'' and the forces of floor and wall for signs of these, by equations
    /// written by hand.
    fn solved(&self, signs: [f64; 2]) -> Vector5<f64> {
        let (mass, half, inertia) = (10.0, 2.0, 13.0);
        let (sine, cosine) = self.angle.sin_cos();
        let [on_floor, on_wall] = [0, 1].map(|k| -self.ways[k] * self.friction[k] * signs[k]);
        #[rustfmt::skip]
        let matrix = Matrix5::new(
            mass, 0.0, 0.0, -on_floor, -1.0,
            0.0, mass, 0.0, -1.0, -on_wall,
            0.0, 0.0, inertia,
            half * cosine + half * sine * on_floor, -half * sine - half * cosine * on_wall,
            0.0, 1.0, -half * cosine, 0.0, 0.0,
            1.0, 0.0, half * sine, 0.0, 0.0,
        );
        let bend = half * self.rate * self.rate;
        let side = Vector5::new(self.push, -mass * GRAVITY, 0.0, -bend * sine, -bend * cosine);
        matrix.lu().solve(&side).expect("regular")
    }

    /// Returns the only solution whose forces have the signs that it was computed with.
    fn only(&self) -> Option<Vector5<f64>> {
        let combinations = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
        let fits = |signs: &[f64; 2]| {
            let found = self.solved(*signs);
            (found[3] * signs[0] >= 0.0 && found[4] * signs[1] >= 0.0).then_some(found)
        };
        let found: Vec<_> = combinations.iter().filter_map(fits).collect();
        (found.len() == 1).then(|| found[0])
    }
}

#[test]
fn forces_of_two_rough_contacts_have_the_signs_that_fulfil_the_equations() {
    let model = of_text(LADDER, Keep::All);
    let parameters = |ladder: &Ladder| {
        let names = model.model().parameters.iter().map(|parameter| {
            match parameter.quantity.name.path.as_str() {
                "ladder.mu_floor" => ladder.friction[0],
                "ladder.mu_wall" => ladder.friction[1],
                "ladder.push" => ladder.push,
                _ => parameter.value,
            }
        });
        names.collect::<Vec<f64>>()
    };
    let mut found = [[0; 2]; 2];
    for number in 0..4000 {
        let random =
            |index: u32| (f64::from(number) * 0.754_877 + f64::from(index) * 0.569_84).fract();
        let ladder = Ladder {
            angle: 0.2 + 1.2 * random(1),
            rate: 8.0 * (random(2) - 0.5),
            push: 400.0 * (random(3) * 7.0).sin(),
            friction: [4, 5].map(|index| 0.4 * (random(index) * 31.0).fract()),
            ways: [6, 7].map(|index| if (random(index) * 53.0).fract() < 0.5 { -1.0 } else { 1.0 }),
        };
        let Some(exact) = ladder.only() else { continue };
        let [on_floor, on_wall] = ladder.ways;
        let state = [0.0, 0.0, ladder.angle, 0.0, 0.0, ladder.rate, on_floor, on_wall];
        let parameters = parameters(&ladder);
        let mut rate = [0.0; 8];
        model.rate(0.0, &state, &parameters, &mut rate);
        let size = exact.amax().max(1.0);
        for (found, exact) in rate[3..6].iter().zip(&exact) {
            assert!((found - exact).abs() < 1e-10 * size, "{number}: {found} for {exact}");
        }
        found[usize::from(exact[3] < 0.0)][usize::from(exact[4] < 0.0)] += 1;
    }
    assert!(found.iter().flatten().all(|count| *count > 100), "{found:?}");
}

const ROD: &str = r#"
    [scene]
    name = "rod"
    [units.rod]
    unit = "rod"
    [initial]
    "rod.x" = 0
    "rod.angle" = "start"
    "rod.x_dot" = -3
    [guess]
    "rod.y" = 0.5
    [parameters]
    start = { value = 1.0, unit = "rad" }
    [outputs]
    ground = "rod.ground"
    [run]
    until = 0.01
    points = 3
    rtol = 1e-9
    method = "auto"
    [define.rod.coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    angle = { unit = "rad" }
    [define.rod.parameters]
    mass = { value = 1.0, unit = "kg" }
    half = { value = 1.0, unit = "m" }
    mu = { value = 0.3, unit = "1" }
    [define.rod.energy]
    kinetic = "mass*(x_dot^2 + y_dot^2)/2 + mass*half^2/3*angle_dot^2/2"
    potential = "mass*9.81 [m/s^2]*y"
    [define.rod.constraints.ground]
    expression = "y - half*sin(angle)"
    [define.rod.friction.tip]
    speed = "x_dot + half*sin(angle)*angle_dot"
    sliding = "mu*abs(ground)"
    unit = "N"
"#;

/// P. Painleve, Comptes Rendus 121 (1895): a rod that is pushed over a rough table has no motion for
/// mu > (1 + 3 cos^2)/(3 sin cos). Just below, the table pushes without bound.
#[test]
fn a_rod_pushed_over_a_rough_table_jams_from_the_friction_of_painleve_on() {
    let rod = of_text(ROD, Keep::All);
    for start in [0.3, 0.6, 1.0, 1.2] {
        let (sine, cosine) = f64::sin_cos(start);
        let limit = (1.0 + 3.0 * cosine * cosine) / (3.0 * sine * cosine);
        let at =
            |share: f64| with(&rod, &[("rod.mu", share * limit), ("start", start)], Method::Auto);
        let run = at(0.99).expect("below the limit it moves");
        // N = m g/(1 + 3 c^2 - 3 mu s c) at rest of the angle.
        let force = GRAVITY / ((1.0 + 3.0 * cosine * cosine) * 0.01);
        let first = column(&run, "ground")[0];
        assert!((first - force).abs() < 1e-9 * force, "{start}: {first} for {force}");
        let refused = at(1.01).expect_err("beyond the limit it jams").to_string();
        assert!(refused.contains("jams"), "{refused}");
    }
}

#[test]
fn a_rigid_lossy_gear_switches_when_the_reference_does() {
    let model = model_of_specs("msl/lossy_gear", Keep::All);
    let simulator = ModelSimulator::new(model);
    for method in METHODS {
        let run = Simulation::new(&simulator).method(method).rtol(1e-9).run().expect("it runs");
        let after = run.switches.iter().filter(|event| event.time > 0.0).map(|event| event.time);
        let times: Vec<f64> = after.collect();
        // By an independent solution, to all digits that are given.
        let exact = [0.080_477, 0.199_520, 0.371_343, 0.464_539];
        assert_eq!(times.len(), exact.len(), "{method}: {times:?}");
        for (time, exact) in times.iter().zip(exact) {
            assert!((time - exact).abs() < 0.6e-6, "{method}: {time} for {exact}");
        }
    }
}

#[test]
fn a_force_in_another_way_than_in_proportion_is_refused_at_its_place() {
    let refused = |sliding: &str| refusal(&RING.replace("mu*abs(ring)", sliding));
    for sliding in [
        "sqrt(ring^2 + 1 [N^2])",
        "ring*ring/1 [N]",
        "mu*abs(ring - 3 [N])",
        "1 [N]*exp(ring/1 [N])",
        "min(mu*abs(ring), 3 [N])",
        "1 [N]*sign(ring)",
        "mass*1 [N/kg] + mu*max(ring, 1 [N])",
    ] {
        let said = refused(sliding);
        assert!(said.contains("must be in proportion to it"), "{sliding}: {said}");
        assert!(said.contains("times its `abs`"), "{sliding}: {said}");
    }
    let of_energy = RING.replace("mass*9.81 [m/s^2]*y", "mass*9.81 [m/s^2]*y + ring*1 [m]");
    assert!(refusal(&of_energy).contains("depends on the force of a constraint"));
}

#[test]
fn a_note_names_impulses_that_act_without_the_friction_of_their_constraint() {
    let with = |events: &str| system_of(&format!("{RING}{events}")).notes;
    assert_eq!(with(""), Vec::<String>::new());
    let kick = r#"
        [define.bead.events.kick]
        guard = "x"
        set = { x_dot = "x_dot + 1 [m/s]" }
    "#;
    let note = "an impulse of constraint `bead.ring`, as at `bead.kick`, acts without the friction by \
                its force";
    assert_eq!(with(kick), [note]);
    let counted = r#"
        [define.bead.modes.passes]
        [define.bead.events.pass]
        guard = "x"
        set = { passes = "passes + 1" }
    "#;
    assert_eq!(with(counted), Vec::<String>::new());
}

#[test]
fn the_force_of_a_dropped_constraint_is_not_read_silently() {
    let again = "    [define.bead.constraints.again]\n    \
                 expression = \"2*(sqrt(x^2 + y^2) - radius)\"\n";
    let by_force = RING.replace("mu*abs(ring)", "mu*abs(again)") + again;
    let by_rate = format!("{RING}{again}{}", wear("abs(again)"));
    for (text, what) in [(by_force, "a force"), (by_rate, "a rate")] {
        let mut system = system_of(&text);
        system.drop_constraint("bead.again", &[]);
        let refused = pipeline::compile(system, Keep::All).expect_err("it is refused").render();
        let refused = refused.split_whitespace().collect::<Vec<_>>().join(" ");
        let said =
            format!("{what} depends on the force of constraint `bead.again`, which is dropped");
        assert!(refused.replace("│ ", "").contains(&said), "{refused}");
    }
}

/// Returns a state of a bead whose rate is that of wear by a force.
fn wear(force: &str) -> String {
    format!(
        "    [define.bead.states.wear]\n    unit = \"m\"\n    rate = \"1e-6 [m/(N*s)]*{force}\"\n"
    )
}

/// Rates read sizes of constraint forces also where no force acts in proportion to them.
#[test]
fn a_state_wears_by_the_size_of_a_force_without_friction() {
    let start = RING.find("    [define.bead.friction.rub]").expect("friction");
    let smooth = RING[..start].replace("    rub = \"bead.rub\"\n", "");
    let smooth = format!("{smooth}{}", wear("abs(ring)"));
    let machine = of_text(&smooth, Keep::All);
    for method in METHODS {
        let run = with(&machine, &[], method).expect("it runs");
        let normal = column(&run, "normal");
        let worn = column(&run, "bead.wear");
        let pairs = run.times.windows(2).zip(normal.windows(2));
        let sum: f64 =
            pairs.map(|(time, n)| 0.5e-6 * (time[1] - time[0]) * (n[0].abs() + n[1].abs())).sum();
        let last = worn[worn.len() - 1];
        assert!((last - sum).abs() < 1e-4 * sum, "{method}: {last} for {sum}");
    }
}

#[test]
fn a_force_may_be_any_sum_of_products_with_constraint_forces() {
    // The same friction in other words.
    let words = [
        "mu*max(ring, -ring)",
        "mu*(max(ring, 0) - min(ring, 0))",
        "abs(mu*ring)",
        "piecewise(ring < 0, -mu*ring, mu*ring)",
        "mu*abs(ring) + 0.5*(ring - ring)",
        "press",
    ];
    let expected = with(&of_text(RING, Keep::All), &[], Method::Dop853).expect("it runs");
    for sliding in words {
        let text = RING.replace("mu*abs(ring)", sliding)
            + "\n    [define.bead.helpers.press]\n    expression = \"mu*abs(ring)\"\n    unit = \"N\"\n";
        let run = with(&of_text(&text, Keep::All), &[], Method::Dop853).expect("it runs");
        for name in ["bead.x", "bead.y_dot", "normal"] {
            for (a, b) in column(&run, name).iter().zip(column(&expected, name)) {
                assert!((a - b).abs() < 1e-9, "{sliding}: {name} {a} for {b}");
            }
        }
    }
}

/// A block on an incline of the angle a reaches the speed g t (sin a - mu cos a), and rests if tan a
/// is below the breakaway friction.
#[test]
fn a_point_in_a_rough_slot_slides_as_a_block_on_an_incline() {
    let slot = of_text(
        r#"
        [scene]
        name = "incline"
        [units.ground]
        unit = "planar/fixed"
        [units.slot]
        unit = "planar/rough_slot"
        [units.block]
        unit = "planar/particle"
        parameters = { mass = 3 }
        [units.earth]
        unit = "rotational/fixed"
        [[joints]]
        connect = ["ground.x", "slot.x_a"]
        [[joints]]
        connect = ["ground.y", "slot.y_a"]
        [[joints]]
        connect = ["earth.a", "slot.phi"]
        [[joints]]
        connect = ["block.a", "slot.pin"]
        [run]
        until = 1.0
        points = 11
        rtol = 1e-9
        method = "auto"
        [outputs]
        force = "slot.force"
        friction = "slot.dry"
        travel = "slot.travel"
        "#,
        Keep::All,
    );
    for (number, angle) in [-1.2, -0.5, -0.1, 0.05, 0.3, 0.9, 1.4].into_iter().enumerate() {
        for (friction, peak) in [(0.0, 1.0), (0.2, 1.0), (0.2, 2.0), (0.6, 1.5)] {
            let method = METHODS[number % METHODS.len()];
            let run = with(
                &slot,
                &[("slot.angle", angle), ("slot.friction", friction), ("slot.peak", peak)],
                method,
            )
            .expect("it runs");
            let (sine, cosine) = f64::sin_cos(angle);
            let rests = sine.abs() <= friction * peak * cosine;
            let pull = if rests { 0.0 } else { sine.abs() - friction * cosine };
            let exact = -sine.signum() * 0.5 * GRAVITY * pull;
            let travel = run.last("travel").expect("an output");
            let case = format!("{angle} {friction} {peak} by {method}");
            assert!((travel - exact).abs() < 1e-8, "{case}: {travel} for {exact}");
            let force = run.last("force").expect("an output");
            assert!((force - 3.0 * GRAVITY * cosine).abs() < 1e-7, "{case}: {force}");
            let held = if rests { sine } else { sine.signum() * friction * cosine };
            let rub = run.last("friction").expect("an output");
            assert!((rub - 3.0 * GRAVITY * held).abs() < 1e-7, "{case}: {rub}");
        }
    }
}

/// Where a drive prescribes all motion, friction changes powers alone, and its direction must still
/// follow the force in the slot, which reverses together with the travel.
#[test]
fn friction_in_a_driven_slot_loses_power_at_every_time() {
    let simulator = ModelSimulator::new(model_of_specs("parts/planar/rough_slot", Keep::All));
    for method in METHODS {
        for rtol in [1e-6, 1e-8, 1e-9, 1e-10, 1e-11] {
            let run = Simulation::new(&simulator).method(method).rtol(rtol);
            let run = run.parameter("foot.place_x", 0.0).expect("a parameter");
            let run = run.with_energy_balance(true).run().expect("it runs");
            let dissipated = &run.energy_balance.as_ref().expect("an account").dissipated;
            let least = dissipated.windows(2).map(|pair| pair[1] - pair[0]).fold(1.0, f64::min);
            assert!(least > -1e-6, "{method}, {rtol}: {least}");
            let loss = column(&run, "loss");
            assert!(loss.iter().all(|loss| *loss >= 0.0), "{method}, {rtol}");
            // The trapezoidal rule errs by less than a thousandth.
            let steps = run.times.windows(2).zip(loss.windows(2));
            let sum: f64 =
                steps.map(|(time, loss)| 0.5 * (time[1] - time[0]) * (loss[0] + loss[1])).sum();
            let last = dissipated.last().expect("a row");
            assert!((sum - last).abs() < 1e-3 * last, "{method}, {rtol}: {sum} for {last}");
        }
    }
}

//! Dry friction on belts whose speeds jump, in time or at places: a block that sticks slides until
//! it has the speed of the belt. Compared with the closed form.

use machinist::hosted::{Beginning, Hosted, Reached};
use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::fixed_step::{FixedSteps, StepMethod};
use machinist_contract::{Jumps, Simulator};
use machinist_model::ModelSimulator;

use crate::fixed_steps::steps_in_rust;
use crate::own_scene::of_text;

const METHODS: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto, Method::Exact];

const UNTIL: f64 = 4.0;

/// A block of some kinetic energy on a belt of some speed.
fn block(kinetic: &str, speed: &str, points: usize) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "belt"
        [units.block]
        unit = "block"
        [initial]
        "block.v" = "block.first"
        [run]
        until = {UNTIL}
        points = {points}
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        mass = {{ value = 2.0, unit = "kg" }}
        other = {{ value = 3.0, unit = "kg" }}
        coulomb = {{ value = 3.0, unit = "N" }}
        first = {{ value = 1.0, unit = "m/s" }}
        second = {{ value = 2.0, unit = "m/s" }}
        third = {{ value = -0.5, unit = "m/s" }}
        begins = {{ value = 0.5, unit = "s" }}
        ends = {{ value = 0.77, unit = "s" }}
        near = {{ value = 0.5, unit = "m" }}
        far = {{ value = 3.0, unit = "m" }}
        [define.block.energy]
        kinetic = "{kinetic}"
        [define.block.friction.guide]
        speed = "v - ({speed})"
        sliding = "coulomb"
        unit = "N"
        "#
    );
    of_text(&text, Keep::Needed)
}

/// A block on a belt of some speed.
pub fn scene(speed: &str) -> ModelSimulator {
    block("mass*v^2/2", speed, 81)
}

pub const IN_TIME: &str =
    "first + (second - first)*step(t, begins) + (third - second)*step(t, ends)";
pub const AT_PLACES: &str = "piecewise(x < near, first, x < far, second, third)";

/// Speeds of the belt, deceleration by friction, and times or places of the jumps.
#[derive(Clone, Copy)]
struct Belt {
    speeds: [f64; 3],
    slows: f64,
    jumps: [f64; 2],
}

impl Belt {
    /// Returns position and speed of the block a time after it had others, on a belt of one speed.
    fn carry(&self, [x, v]: [f64; 2], belt: f64, time: f64) -> [f64; 2] {
        let slides = ((belt - v).abs() / self.slows).min(time);
        let a = self.slows * (belt - v).signum();
        let reached = if slides < time { belt } else { v + a * slides };
        [x + v * slides + a * slides * slides / 2.0 + belt * (time - slides), reached]
    }

    /// Returns position and speed at a time, with jumps in time.
    fn in_time(&self, time: f64) -> [f64; 2] {
        let (mut state, mut from) = ([0.0, self.speeds[0]], 0.0);
        for (until, belt) in [self.jumps[0], self.jumps[1], time].into_iter().zip(self.speeds) {
            state = self.carry(state, belt, until.min(time) - from);
            from = until.min(time);
        }
        state
    }

    /// Returns position and speed at a time, with jumps at places, which forward motion passes once.
    fn at_places(&self, time: f64) -> [f64; 2] {
        let (mut state, mut from) = ([0.0, self.speeds[0]], 0.0);
        for (place, belt) in
            [self.jumps[0], self.jumps[1], f64::INFINITY].into_iter().zip(self.speeds)
        {
            // Bisection of the time at which it gets there.
            let [mut low, mut high] = [0.0, time - from];
            if self.carry(state, belt, high)[0] <= place {
                return self.carry(state, belt, high);
            }
            for _ in 0..60 {
                let middle = f64::midpoint(low, high);
                let is_there = self.carry(state, belt, middle)[0] >= place;
                *(if is_there { &mut high } else { &mut low }) = middle;
            }
            state = self.carry(state, belt, high);
            from += high;
        }
        state
    }

    fn values(&self, mass: f64, jumps: [&'static str; 2]) -> Vec<(&'static str, f64)> {
        let [first, second, third] = self.speeds;
        vec![
            ("block.mass", mass),
            ("block.coulomb", self.slows * mass),
            ("block.first", first),
            ("block.second", second),
            ("block.third", third),
            (jumps[0], self.jumps[0]),
            (jumps[1], self.jumps[1]),
        ]
    }
}

fn run(machine: &ModelSimulator, method: Method, rtol: f64, values: &[(&str, f64)]) -> Trajectory {
    let mut run = Simulation::new(machine).method(method).rtol(rtol).with_energy_balance(true);
    for (name, value) in values {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.run().unwrap_or_else(|error| panic!("{method}, {rtol:e}, {values:?}: {error}"))
}

/// Runs a machine by all methods, compares with a closed form, and checks the account of energy.
fn require_exact(
    machine: &ModelSimulator,
    values: &[(&str, f64)],
    exact: impl Fn(f64) -> [f64; 2],
) {
    for method in METHODS {
        for rtol in [1e-4, 1e-6, 1e-9] {
            let run = run(machine, method, rtol, values);
            let [x, v] = ["block.x", "block.v"].map(|name| run.column(name).expect("a column"));
            let size = x.iter().chain(v).fold(1e-3, |most: f64, value| most.max(value.abs()));
            for ((time, x), v) in run.times.iter().zip(x).zip(v) {
                let exact = exact(*time);
                let off = ((x - exact[0]).abs() + (v - exact[1]).abs()) / size;
                let what = format!("{method}, {rtol:e}, {values:?} at {time}");
                assert!(off < 100.0 * rtol, "{what}: {x}, {v}, not {exact:?}");
            }
            let balance = run.energy_balance.as_ref().expect("asked for");
            let off = balance.max_residual_relative();
            assert!(off < 100.0 * rtol, "{method}, {rtol:e}, {values:?}: {off:e}");
        }
    }
}

const CASES: [(Belt, f64); 5] = [
    (Belt { speeds: [1.0, 2.0, -0.5], slows: 1.5, jumps: [0.5, 0.77] }, 2.0),
    // It catches up between the jumps.
    (Belt { speeds: [1.0, 2.0, -0.5], slows: 9.0, jumps: [0.5, 0.77] }, 0.1),
    // It never does.
    (Belt { speeds: [0.0, 300.0, 0.0], slows: 0.01, jumps: [0.5, 0.77] }, 50.0),
    // No jump at all, and one by a little.
    (Belt { speeds: [1.0, 1.0, 1.0 + 1e-4], slows: 1.0, jumps: [0.25, 1.0] }, 1.0),
    (Belt { speeds: [-1.0, 1.0, -1.0], slows: 2.0, jumps: [1.0, 1.5] }, 3.0),
];

#[test]
fn a_block_slides_after_its_belt_jumps_in_time() {
    let machine = scene(IN_TIME);
    for (belt, mass) in CASES {
        let values = belt.values(mass, ["block.begins", "block.ends"]);
        require_exact(&machine, &values, |time| belt.in_time(time));
    }
}

#[test]
fn a_block_slides_after_it_gets_onto_another_belt() {
    let machine = scene(AT_PLACES);
    for (speeds, slows, jumps, mass) in [
        ([1.0, 2.0, 0.5], 1.5, [0.5, 3.0], 2.0),
        ([1.0, 2.0, 0.5], 20.0, [0.5, 3.0], 0.1),
        ([1.0, 0.2, 3.0], 0.4, [0.5, 1.5], 5.0),
        ([1.0, 1.0, 1.0 + 1e-3], 0.4, [0.5, 1.5], 5.0),
        ([30.0, 10.0, 50.0], 9.81, [20.0, 60.0], 5.0),
    ] {
        let belt = Belt { speeds, slows, jumps };
        let values = belt.values(mass, ["block.near", "block.far"]);
        require_exact(&machine, &values, |time| belt.at_places(time));
    }
}

#[test]
fn sensitivities_go_through_jumps_of_belts() {
    let belt = CASES[0].0;
    let base = [belt.speeds[1], belt.jumps[0], belt.slows * 2.0];
    let moved = |values: [f64; 3]| Belt {
        speeds: [1.0, values[0], 0.5],
        jumps: [values[1], 3.0],
        slows: values[2] / 2.0,
    };
    // Before the second jump, and after it.
    for (speed, jumps, until) in [
        (IN_TIME, ["block.begins", "block.ends"], 0.9),
        (IN_TIME, ["block.begins", "block.ends"], 3.2),
        (AT_PLACES, ["block.near", "block.far"], 0.9),
        (AT_PLACES, ["block.near", "block.far"], 2.6),
    ] {
        let machine = scene(speed);
        let exact = |values: [f64; 3]| {
            let belt = moved(values);
            if speed == IN_TIME { belt.in_time(until) } else { belt.at_places(until) }
        };
        let by = ["block.second", jumps[0], "block.coulomb"];
        for method in [Method::Tsit5, Method::Dop853, Method::Radau, Method::Auto] {
            let mut run =
                Simulation::new(&machine).method(method).rtol(1e-9).until(until).points(2);
            for (name, value) in moved(base).values(2.0, jumps) {
                run = run.parameter(name, value).expect("a parameter");
            }
            let run = run.sensitivities(&by).expect("known").run();
            let run = run.unwrap_or_else(|error| panic!("{method}, {speed}: {error}"));
            for (number, by) in by.into_iter().enumerate() {
                let [ahead, behind] = [1e-5, -1e-5].map(|step| {
                    let mut values = base;
                    values[number] += step;
                    exact(values)
                });
                for (entry, of) in ["block.x", "block.v"].into_iter().enumerate() {
                    let found = *run.sensitivity(of, by).expect("a column").last().expect("rows");
                    let slope = (ahead[entry] - behind[entry]) / 2e-5;
                    let what = format!("{method}, {speed} until {until}: {of} by {by}");
                    assert!((found - slope).abs() < 1e-6, "{what}: {found}, not {slope}");
                }
            }
        }
    }
}

/// A block that sticks to its belt and becomes heavier or lighter at a place, which keeps its
/// energy, or at a time, which keeps its momentum. No row is at the jump, on one side of which it
/// would have to be.
#[test]
fn a_block_slides_after_its_mass_jumps() {
    for (condition, power) in [("t < begins", 1.0), ("x < near", 0.5)] {
        let kinetic = format!("piecewise({condition}, mass, other)*v^2/2");
        let machine = block(&kinetic, "first", 80);
        for (other, coulomb, belt) in [(3.0, 3.0, 1.0), (0.5, 0.1, 1.0), (40.0, 7.0, 2.0)] {
            let values = [
                ("block.other", other),
                ("block.coulomb", coulomb),
                ("block.first", belt),
                if power < 1.0 { ("block.near", belt * 0.5) } else { ("block.begins", 0.5) },
            ];
            let after = Belt { speeds: [belt; 3], slows: coulomb / other, jumps: [0.5, 9.0] };
            let slows = belt * f64::powf(2.0 / other, power);
            require_exact(&machine, &values, |time| {
                if time <= 0.5 {
                    return [belt * time, belt];
                }
                after.carry([belt * 0.5, slows], belt, time - 0.5)
            });
        }
    }
}

/// Fixed steps, as in emitted C, with jumps within steps and at their ends.
#[test]
fn fixed_steps_slide_after_belts_jump_in_time() {
    let machine = scene(IN_TIME);
    let belt = Belt { speeds: [1.0, 2.0, -0.5], slows: 1.5, jumps: [0.5, 0.77] };
    for method in StepMethod::ALL {
        for steps in [100, 313, 800] {
            let step = UNTIL / f64::from(steps);
            let start = [0.0, 1.0, 2.0];
            let (rows, _) = steps_in_rust(machine.model(), method, (&start, step, steps as usize));
            let last = rows.last().expect("a row");
            let exact = belt.in_time(UNTIL);
            let off = (last[0] - exact[0]).abs() + (last[1] - exact[1]).abs();
            assert!(off < 1e-9, "{method:?}, {steps}: {last:?}, not {exact:?}");
        }
    }
}

/// Fixed steps would find a place only after the speed has jumped there.
#[test]
fn fixed_steps_say_where_they_are_unsuitable() {
    for (speed, jumps) in [
        ("first", Jumps::Nowhere),
        ("first*cos(t*1[1/s])", Jumps::Nowhere),
        ("first*min(max(x/far, 0), 1)", Jumps::Nowhere),
        (IN_TIME, Jumps::InTime),
        (AT_PLACES, Jumps::AtPlaces),
    ] {
        let machine = scene(speed);
        let simulator: &dyn Simulator<f64> = &machine;
        let constraint = simulator.constraint(0);
        assert_eq!((constraint.friction, constraint.jumps), (Some(2), jumps), "{speed}");
        let unsuitable = FixedSteps::unsuitable(simulator).is_some();
        assert_eq!(unsuitable, jumps == Jumps::AtPlaces, "{speed}");
    }
}

/// Begins a run of a host.
fn beginning(
    hosted: &Hosted<'_>,
    state: Vec<f64>,
    is_given: &dyn Fn(usize) -> bool,
) -> machinist::hosted::Standing {
    let beginning = Beginning {
        from: 0.0,
        until: UNTIL,
        rtol: 1e-8,
        is_stepped: false,
        state,
        is_given,
        in_equilibrium: false,
    };
    hosted.begin(beginning).expect("it begins")
}

/// A host that carries a run in pieces, which end at jumps or beside them, or that makes them by a
/// parameter.
#[test]
fn pieces_of_a_run_go_through_jumps_of_belts() {
    let belt = Belt { speeds: [1.0, 2.0, -0.5], slows: 1.5, jumps: [0.5, 0.77] };
    let by_parameter: [&[f64]; 2] = [&belt.jumps, &[0.3, 0.5, 0.77, 1.0]];
    let by_time: [&[f64]; 3] = [&[], &belt.jumps, &[0.3, 0.6, 0.77, 1.0]];
    let all = by_time.map(|ends| (IN_TIME, ends)).into_iter();
    for (speed, ends) in all.chain(by_parameter.map(|ends| ("first", ends))) {
        let machine = scene(speed);
        let simulator: &dyn Simulator<f64> = &machine;
        let count = simulator.shape().parameters;
        let mut parameters: Vec<f64> =
            (0..count).map(|index| simulator.parameter_default(index)).collect();
        let first = (0..count).find(|it| simulator.parameter(*it).name == "block.first");
        let first = first.expect("a parameter");
        let mut state = vec![0.0; 3];
        simulator.initial_state(&parameters, &mut state);
        let is_given = |index: usize| simulator.is_given(index);
        let mut standing = beginning(&Hosted::new(simulator, &parameters), state, &is_given);
        for until in ends.iter().copied().chain([UNTIL]) {
            let hosted = Hosted::new(simulator, &parameters);
            let reached = hosted.carry(&mut standing, until, (Method::Auto, false), &|_, _| false);
            assert_eq!(reached.expect("it goes on").reached, Reached::End);
            if speed == "first" {
                let passed = belt.jumps.iter().filter(|jump| **jump <= until).count();
                parameters[first] = belt.speeds[passed];
            }
            Hosted::new(simulator, &parameters).happen(&mut standing).expect("it goes on");
        }
        let exact = belt.in_time(UNTIL);
        let off = (standing.state[0] - exact[0]).abs() + (standing.state[1] - exact[1]).abs();
        assert!(off < 1e-6, "{speed}, {ends:?}: {:?}, not {exact:?}", standing.state);
    }
}

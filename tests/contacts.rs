//! Contacts that only push: nothing falls through them, and nothing sticks to them.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// Returns a block under a constant load that meets a unit of the library.
fn scene(contact: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "block"
        [units.block]
        unit = "block"
        {contact}
        [run]
        until = 2.0
        points = 11
        rtol = 1e-8
        method = "dop853"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        scale = 0.01
        velocity_scale = 0.1
        [define.block.ports.face]
        kind = "translational"
        coordinate = "x"
        [define.block.parameters]
        mass = {{ value = 1.0, unit = "kg" }}
        load = {{ value = 10.0, unit = "N" }}
        [define.block.energy]
        kinetic = "mass*v^2/2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "load"
        "#
    );
    of_text(&text, Keep::Needed)
}

const STOP: &str = r#"
    [units.stop]
    unit = "stop"
    [[joints]]
    connect = ["block.face", "stop.face"]
    [outputs]
    x = "block.x"
    v = "block.v"
    force = "stop.force"
    closed = "stop.closed"
"#;

const ONE_SIDED: &str = r#"
    [units.stop]
    unit = "one_sided_contact"
    inputs = { gap = "distance - block.x", rate = "-block.v" }
    [parameters]
    distance = { value = 0.005, unit = "m", doc = "place of the contact" }
    [outputs]
    x = "block.x"
    v = "block.v"
    force = "stop.force"
    closed = "stop.closed"
"#;

const LAYER: &str = r#"
    [units.stop]
    unit = "textile/yarn_layer_one_sided"
    inputs = { shape = "-distance", shape_rate = "0", preload = "0" }
    parameters = { cubic_stiffness = 0 }
    [[joints]]
    connect = ["block.face", "stop.centre"]
    [parameters]
    distance = { value = 0.0, unit = "m", doc = "place of the contact" }
    [outputs]
    x = { expression = "-block.x", unit = "m", doc = "place" }
    v = { expression = "-block.v", unit = "m/s", doc = "its rate" }
    force = "stop.pressure"
    closed = "stop.closed"
"#;

/// Reproducible random numbers.
struct Dice(u64);

impl Dice {
    /// Returns a number between 0 and 1.
    fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.roll()
    }

    /// Returns a number uniform in its order of magnitude.
    fn order(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

/// A block, a load and a contact at `distance`.
#[derive(Debug, Clone, Copy)]
struct Case {
    mass: f64,
    load: f64,
    stiffness: f64,
    damping: f64,
    distance: f64,
    x: f64,
    v: f64,
}

impl Case {
    fn new(dice: &mut Dice) -> Self {
        let (mass, stiffness) = (dice.order(0.1, 100.0), dice.order(1e2, 1e6));
        let critical = 2.0 * (mass * stiffness).sqrt();
        // Compression scales with a speed over a frequency.
        let speed = dice.order(1e-3, 10.0);
        let length = speed * (mass / stiffness).sqrt();
        let sign = |dice: &mut Dice| if dice.roll() < 0.75 { 1.0 } else { -1.0 };
        let damping = critical * if dice.roll() < 0.1 { 0.0 } else { dice.order(1e-3, 3.0) };
        let v = speed * sign(dice);
        let x = if dice.roll() < 0.8 { 0.0 } else { length * dice.between(-1.0, 1.0) };
        let distance = length * dice.order(1e-2, 10.0);
        let load = mass * speed * (stiffness / mass).sqrt() * dice.order(1e-3, 1.0);
        Self { mass, load: load * sign(dice), stiffness, damping, distance, x, v }
    }

    /// Returns several periods of the contact and of the fall onto it.
    fn span(&self) -> f64 {
        let period = std::f64::consts::TAU * (self.mass / self.stiffness).sqrt();
        let fall = (self.distance - self.x).abs() / self.v.abs();
        let pull = 2.0 * self.mass * self.v.abs() / self.load.abs();
        (20.0 * period).max(2.0 * fall).min(20.0 * period + fall + pull)
    }

    /// Returns static compression and depth of impact, without damping.
    fn deepest(&self, fastest: f64) -> f64 {
        let still = self.load.max(0.0) / self.stiffness;
        let impact = (still * still + self.mass * fastest * fastest / self.stiffness).sqrt();
        self.distance + still + impact
    }

    /// Returns the largest possible speed of impact.
    fn fastest(&self) -> f64 {
        let fall = (self.distance - self.x).max(0.0) * self.load.abs();
        let start = (self.x - self.distance).max(0.0);
        let energy =
            self.v * self.v / 2.0 + (fall + self.stiffness * start * start / 2.0) / self.mass;
        (2.0 * energy).sqrt()
    }

    fn simulation<'a>(&self, scene: &'a ModelSimulator, place: &str) -> Simulation<'a> {
        let with = |simulation: Simulation<'a>, name: &str, value| {
            simulation.parameter(name, value).expect("a parameter")
        };
        let mut simulation = Simulation::new(scene).until(self.span()).points(101);
        for (name, value) in [
            ("block.mass", self.mass),
            ("block.load", self.load),
            ("stop.stiffness", self.stiffness),
            (place, self.distance),
        ] {
            simulation = with(simulation, name, value);
        }
        simulation
    }

    /// Integrates the law F = max(0, k c + d v) for c > 0 by small steps of Heun's method.
    fn by_small_steps(&self, steps: usize) -> [f64; 2] {
        let rate = |[x, v]: [f64; 2]| {
            let compression = x - self.distance;
            let push = self.stiffness * compression + self.damping * v;
            let force = if compression > 0.0 { push.max(0.0) } else { 0.0 };
            [v, (self.load - force) / self.mass]
        };
        let step = self.span() / steps as f64;
        let mut state = [self.x, self.v];
        for _ in 0..steps {
            let first = rate(state);
            let second = rate([state[0] + step * first[0], state[1] + step * first[1]]);
            for index in 0..2 {
                state[index] += 0.5 * step * (first[index] + second[index]);
            }
        }
        state
    }
}

fn runs() -> usize {
    std::env::var("MACHINIST_CONTACT_RUNS").ok().and_then(|runs| runs.parse().ok()).unwrap_or(500)
}

/// Runs cases, and returns their errors.
fn sweep(contact: &str, place: &str, damper: &str, with_reference: bool) {
    let block = scene(contact);
    let mut dice = Dice(1);
    let mut wrong = Vec::new();
    let runs = runs();
    for number in 0..runs {
        let mut case = Case::new(&mut dice);
        if contact == LAYER {
            // An expansion against very low viscosity is stiff.
            let critical = 2.0 * (case.mass * case.stiffness).sqrt();
            case.damping = case.damping.max(0.03 * critical);
        }
        let damping = case.damping;
        let simulation = case.simulation(&block, place).parameter(damper, damping);
        let simulation = simulation.expect("a parameter");
        // The layer meets the block from the other side. All contacts start open, some
        // of them pressed.
        let side = if contact == LAYER { -1.0 } else { 1.0 };
        let simulation = simulation.parameter("block.load", side * case.load).expect("one");
        let mut start = vec![0.0; block.shape().states()];
        start[..2].copy_from_slice(&[side * case.x, side * case.v]);
        if let Some(surface) = (2..start.len()).find(|&i| block.state(i).name == "stop.surface") {
            start[surface] = (case.x - case.distance).max(0.0);
        }
        let method = [Method::Dop853, Method::Tsit5, Method::Auto, Method::Radau][number % 4];
        let simulation = simulation.initial_state(&start).method(method);
        let run = match simulation.max_steps(100_000).run() {
            Ok(run) => run,
            Err(error) => {
                wrong.push(format!("{case:?} {method}: {error}"));
                continue;
            }
        };
        let column = |name: &str| run.column(name).expect("an output");
        let deepest = case.deepest(case.fastest());
        let slack = 1e-5 * deepest.abs();
        let greatest = column("x").iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let size = case.stiffness * (deepest - case.distance) + damping * case.fastest();
        let least = column("force").iter().copied().fold(f64::INFINITY, f64::min);
        if greatest > deepest + slack {
            wrong.push(format!("{case:?} {method}: through it, at {greatest} beyond {deepest}"));
        } else if least < -1e-5 * size {
            wrong.push(format!("{case:?} {method}: it pulls by {least}"));
        }
        if with_reference && number % 25 == 0 {
            let expected = case.by_small_steps(400_000);
            let [x, v] = ["x", "v"].map(|name| run.last(name).expect("an output"));
            let fastest = case.fastest() + case.load.abs() / case.mass * case.span();
            let length = deepest.abs() + case.fastest() * case.span();
            let off = ((x - expected[0]) / length).abs().max(((v - expected[1]) / fastest).abs());
            if off > 1e-3 {
                wrong.push(format!("{case:?} {method}: {x}, {v} for {expected:?}"));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {runs}:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(5)].join("\n")
    );
}

#[test]
fn nothing_falls_through_a_stop_and_nothing_sticks_to_it() {
    sweep(STOP, "stop.distance", "stop.damping", true);
}

#[test]
fn nothing_falls_through_a_one_sided_contact_and_nothing_sticks_to_it() {
    sweep(ONE_SIDED, "distance", "stop.damping", true);
}

#[test]
fn nothing_falls_through_a_layer_that_only_pushes_and_nothing_sticks_to_it() {
    sweep(LAYER, "distance", "stop.viscosity", false);
}

#[test]
fn a_weight_comes_to_rest_on_a_damped_stop() {
    let block = scene(STOP);
    for number in 0..=26 {
        let distance = 0.025 + 0.0005 * f64::from(number);
        for method in [Method::Dop853, Method::Radau, Method::Auto] {
            let run = Simulation::new(&block)
                .parameter("stop.damping", 100.0)
                .and_then(|run| run.parameter("stop.distance", distance))
                .expect("parameters")
                .method(method)
                .run()
                .expect("it runs");
            let x = run.last("x").expect("an output");
            assert!((x - distance - 1e-3).abs() < 1e-6, "{method}, {distance}: {x}");
        }
    }
}

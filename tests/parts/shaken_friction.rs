//! Friction on shaken parts: a part on a vibrating feeder sticks and slides in every period, and
//! some slides end before they are noticed between the points of a step.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{METHODS, column};
use crate::own_scene::of_text;

const GRAVITY: f64 = 9.81;
const UNTIL: f64 = 2.0;

/// A trough at incline i moves by A sin(w t) along itself and by B sin(w t + p) across; a part on
/// it does not hop.
#[derive(Debug, Clone, Copy)]
struct Feeder {
    friction: f64,
    pace: f64,
    along: f64,
    across: f64,
    incline: f64,
    phase: f64,
}

impl Feeder {
    fn random(random: &mut fastrand::Rng) -> Self {
        let mut between = |least: f64, most: f64| least + (most - least) * random.f64();
        let pace = 10f64.powf(between(1.5, 2.8));
        Self {
            friction: between(0.1, 0.8),
            pace,
            along: GRAVITY * 10f64.powf(between(-1.0, 0.5)) / (pace * pace),
            across: GRAVITY * between(0.0, 0.93) / (pace * pace),
            incline: between(-0.1, 0.15),
            phase: between(-3.0, 3.0),
        }
    }

    fn scene() -> ModelSimulator {
        let text = r#"
            [scene]
            name = "feeder"
            [units]
            part = { unit = "part" }
            [outputs]
            place = "part.x"
            [run]
            until = 2.0
            points = 201
            [define.part.coordinates]
            x = { unit = "m" }
            [define.part.modes.slip]
            initial = 2
            [define.part.parameters]
            friction = { value = 0.35, unit = "1" }
            pace = { value = 300, unit = "rad/s" }
            along = { value = 1.5e-4, unit = "m" }
            across = { value = 0.9e-4, unit = "m" }
            incline = { value = 0.05, unit = "rad" }
            phase = { value = 0.4, unit = "rad" }
            m = { value = 0.3, unit = "kg" }
            g = { value = 9.81, unit = "m/s^2" }
            near = { value = 1e-9, unit = "m/s" }
            [define.part.helpers]
            slides = { expression = "x_dot - along*pace*cos(pace*t)", unit = "m/s" }
            pressed = { expression = "m*(g*cos(incline) - across*pace^2*sin(pace*t + phase))", unit = "N" }
            most = { expression = "friction*pressed", unit = "N" }
            slide = { expression = "piecewise(slip < 0, most, slip < 1, 0, slip < 2, -most, 0)", unit = "N" }
            [define.part.energy]
            kinetic = "m*x_dot^2/2"
            potential = "m*g*sin(incline)*x"
            [define.part.constraints]
            grip = { expression = "slides", when = { slip = 0 } }
            [[define.part.forces]]
            coordinate = "x"
            expression = "slide"
            [define.part.events]
            begins = { guard = "abs(slides) + 1 [m/s]", direction = "rising", when = { slip = 2 }, set = { slip = "(sign(slides - near) + sign(slides + near))/2" } }
            ends_back = { guard = "slides", direction = "rising", when = { slip = -1 }, set = { slip = 0 } }
            ends_forth = { guard = "slides", direction = "falling", when = { slip = 1 }, set = { slip = 0 } }
            breaks_back = { guard = "grip - most", direction = "rising", when = { slip = 0 }, set = { slip = -1 } }
            breaks_forth = { guard = "grip + most", direction = "falling", when = { slip = 0 }, set = { slip = 1 } }
        "#;
        of_text(text, Keep::Needed)
    }

    /// Returns the normal force of the trough over the mass, with its first and second integrals.
    fn pressed(&self, time: f64) -> [f64; 3] {
        let (steady, angle) = (GRAVITY * self.incline.cos(), self.pace * time + self.phase);
        [
            steady - self.across * self.pace * self.pace * angle.sin(),
            steady * time + self.across * self.pace * angle.cos(),
            0.5 * steady * time * time + self.across * angle.sin(),
        ]
    }

    /// Returns the friction force over the mass that the part needs to move with the trough.
    fn needed(&self, time: f64) -> f64 {
        GRAVITY * self.incline.sin() - self.along * self.pace * self.pace * (self.pace * time).sin()
    }

    fn trough(&self, time: f64) -> [f64; 2] {
        let angle = self.pace * time;
        [self.along * angle.sin(), self.along * self.pace * angle.cos()]
    }

    /// Returns position and speed after `from`, where these are known, of a part that slides in the
    /// direction `way`, or sticks if that is 0.
    fn goes(&self, way: f64, (from, [place, speed]): (f64, [f64; 2]), time: f64) -> [f64; 2] {
        if way == 0.0 {
            return [place + self.trough(time)[0] - self.trough(from)[0], self.trough(time)[1]];
        }
        let pull = GRAVITY * self.incline.sin();
        let ([_, first, second], [_, first_from, second_from]) =
            (self.pressed(time), self.pressed(from));
        let span = time - from;
        [
            place + speed * span
                - way * self.friction * (second - second_from - first_from * span)
                - 0.5 * pull * span * span,
            speed - way * self.friction * (first - first_from) - pull * span,
        ]
    }

    /// Returns positions at times, by closed forms between the ends of slides, which are found on a
    /// fine grid and bisected.
    fn places(&self, times: &[f64]) -> Vec<f64> {
        let grid = std::f64::consts::TAU / self.pace / 4000.0;
        let (mut way, mut known) = (-1.0, (0.0, [0.0; 2]));
        let mut places = times.iter().copied().peekable();
        let mut found = Vec::new();
        while found.len() < times.len() {
            let ends = |time: f64| {
                if way == 0.0 {
                    self.needed(time).abs() > self.friction * self.pressed(time)[0]
                } else {
                    way * (self.goes(way, known, time)[1] - self.trough(time)[1]) < 0.0
                }
            };
            let mut before = known.0 + if way == 0.0 { 0.0 } else { 1e-3 * grid };
            let mut after = known.0 + grid;
            if ends(before) {
                after = before;
            }
            while !ends(after) && after <= UNTIL {
                (before, after) = (after, after + grid);
            }
            while after - before > 1e-16 + f64::EPSILON * after {
                let middle = 0.5 * (before + after);
                if ends(middle) { after = middle } else { before = middle }
            }
            while let Some(time) = places.next_if(|time| *time <= after) {
                found.push(self.goes(way, known, time)[0]);
            }
            known = (after, self.goes(way, known, after));
            let needed = self.needed(after);
            let sticks = way != 0.0 && needed.abs() <= self.friction * self.pressed(after)[0];
            way = if sticks { 0.0 } else { -needed.signum() };
        }
        found
    }

    fn check(&self, scene: &ModelSimulator, method: Method) {
        let set = [
            ("part.friction", self.friction),
            ("part.pace", self.pace),
            ("part.along", self.along),
            ("part.across", self.across),
            ("part.incline", self.incline),
            ("part.phase", self.phase),
        ];
        let mut run = Simulation::new(scene);
        for (name, value) in set {
            run = run.parameter(name, value).expect("a parameter");
        }
        let run = run.method(method).rtol(1e-8).max_steps(200_000).run();
        let run = run.unwrap_or_else(|error| panic!("{self:?}, {method}: {error}"));
        let exact = self.places(&run.times);
        for ((found, exact), time) in column(&run, "place").iter().zip(&exact).zip(&run.times) {
            let off = (found - exact).abs();
            assert!(off < 3e-6, "{self:?}, {method}: {found} for {exact} at {time}");
        }
    }
}

/// Slides of all lengths.
#[test]
fn a_part_on_a_vibrating_feeder_sticks_and_slides_in_every_turn() {
    let scene = Feeder::scene();
    let mut random = fastrand::Rng::with_seed(3);
    for round in 0..60 {
        Feeder::random(&mut random).check(&scene, METHODS[round % METHODS.len()]);
    }
}

/// The part breaks away as the required friction exceeds the available one, and sticks again before
/// a motion is noticed.
#[test]
fn slides_that_last_a_moment_end() {
    let scene = Feeder::scene();
    let [first, second, third] = [
        (0.6956, 52.443, 2.9015e-3, 3.2196e-3),
        (0.61055, 389.84, 3.8764e-5, 8.9204e-6),
        (0.248, 228.1, 2.0286e-5, 3.3178e-5),
    ];
    let leans = [(first, 0.14109, 0.74216), (second, -0.043_115, -2.0114), (third, 0.1052, 2.761)];
    for ((friction, pace, along, across), incline, phase) in leans {
        let feeder = Feeder { friction, pace, along, across, incline, phase };
        for method in METHODS {
            feeder.check(&scene, method);
        }
    }
}

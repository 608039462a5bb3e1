//! Crank drives: conserved energy in closed form, an assembly of planar links, hand-written
//! equations with gas.

use std::f64::consts::{PI, TAU};

use machinist::Simulation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use super::{column, example};
use crate::own_scene::of_text;

/// Crank drive with the data of the part.
#[derive(Clone, Copy)]
struct Drive {
    radius: f64,
    rod: f64,
    offset: f64,
    flywheel: f64,
}

impl Drive {
    const PISTON: f64 = 0.6;
    const ROD_MASS: f64 = 0.5;
    const ROD_INERTIA: f64 = 2e-3;
    const CENTRE: f64 = 0.3;

    /// Returns ds/dphi of the piston's way s.
    fn slope(&self, phi: f64) -> f64 {
        let (sin, cos) = (phi - self.offset).sin_cos();
        let root = (self.rod.powi(2) - (self.radius * sin).powi(2)).sqrt();
        self.radius * sin * (1.0 + self.radius * cos / root)
    }

    /// Returns the inertia about the shaft: 2 T/phi'^2, with the rod's ends by the composition of
    /// velocities.
    fn inertia(&self, phi: f64) -> f64 {
        let angle = phi - self.offset;
        let lean = (self.radius * angle.sin() / self.rod).asin();
        let turn = self.radius * angle.cos() / (self.rod * lean.cos());
        // The piston moves along the axis; the crank pin across its radius; the rod in between.
        let pin = (-self.radius * angle.sin(), self.radius * angle.cos());
        let end = (-self.slope(phi), 0.0);
        let centre =
            (pin.0 + Self::CENTRE * (end.0 - pin.0), pin.1 + Self::CENTRE * (end.1 - pin.1));
        self.flywheel
            + Self::PISTON * end.0.powi(2)
            + Self::ROD_MASS * (centre.0.powi(2) + centre.1.powi(2))
            + Self::ROD_INERTIA * turn.powi(2)
    }

    fn text(&self, pressure: &str, strokes: f64, more: &str) -> String {
        let Self { radius, rod, offset, flywheel } = self;
        format!(
            r#"
            [scene]
            name = "engine"
            [units.cylinder]
            unit = "rotational/crank_drive"
            parameters = {{ crank_radius = {radius:?}, rod_length = {rod:?}, offset = {offset:?}, strokes = {strokes:?} }}
            inputs = {{ pressure = "{pressure}" }}
            [units.wheel]
            unit = "rotational/inertia"
            parameters = {{ inertia = {flywheel:?} }}
            [[joints]]
            connect = ["cylinder.a", "wheel.a"]
            [initial]
            "wheel.omega" = 100
            {more}
            [outputs]
            speed = "wheel.omega"
            angle = "wheel.phi"
            way = "cylinder.travel"
            crank = "cylinder.crank"
            power = "cylinder.power"
            [run]
            until = 0.3
            points = 301
            rtol = 1e-11
            method = "dop853"
            "#
        )
    }

    fn scene(&self, pressure: &str, strokes: f64) -> ModelSimulator {
        of_text(&self.text(pressure, strokes, ""), Keep::All)
    }
}

const DRIVES: [Drive; 4] = [
    Drive { radius: 0.045, rod: 0.15, offset: 0.0, flywheel: 0.02 },
    Drive { radius: 0.045, rod: 0.15, offset: 1.3, flywheel: 1e-4 },
    Drive { radius: 0.1, rod: 0.101, offset: -2.0, flywheel: 0.1 },
    Drive { radius: 0.01, rod: 3.0, offset: 7.0, flywheel: 1e-3 },
];

/// Without gas the kinetic energy stays: omega = sqrt(2 T/J(phi)).
#[test]
fn a_crank_drive_without_gas_keeps_its_kinetic_energy() {
    for drive in DRIVES {
        let run = Simulation::new(&drive.scene("0 [Pa]", 4.0)).run().expect("it runs");
        let [speeds, angles] = ["speed", "angle"].map(|name| column(&run, name));
        let double = 1e4 * drive.inertia(0.0);
        let mut uneven: f64 = 0.0;
        for (speed, angle) in speeds.iter().zip(angles) {
            let exact = (double / drive.inertia(*angle)).sqrt();
            assert!((speed - exact).abs() < 1e-8 * exact, "{speed}, not {exact} at {angle}");
            uneven = uneven.max((exact / 100.0 - 1.0).abs());
        }
        assert!(uneven > 1e-3, "{uneven}");
    }
}

/// J(phi) phi'' + J'(phi) phi'^2/2 = p A s'(phi), by 100 000 Runge-Kutta steps; the pressure of
/// harmonics of the cycle, for two and four strokes.
#[test]
fn gas_of_two_and_four_strokes_drives_the_crank_as_hand_written_equations_do() {
    for (number, drive) in DRIVES.into_iter().enumerate() {
        let strokes = [4.0, 2.0, 4.0, 2.0][number];
        let pressure = "3e5 [Pa] + 2e5 [Pa]*cos(2*cylinder.crank/cylinder.strokes) + 1e5 [Pa]*sin(4*cylinder.crank/cylinder.strokes)";
        let run = Simulation::new(&drive.scene(pressure, strokes)).run().expect("it runs");
        let area = PI * 0.085_f64.powi(2) / 4.0;
        let rate = |[phi, omega]: [f64; 2]| {
            let h = 1e-5;
            let slope = (drive.inertia(phi - 2.0 * h) - drive.inertia(phi + 2.0 * h)
                + 8.0 * (drive.inertia(phi + h) - drive.inertia(phi - h)))
                / (12.0 * h);
            let crank = (phi - drive.offset).rem_euclid(strokes * PI);
            let cycle = 2.0 * crank / strokes;
            let gas = 3e5 + 2e5 * cycle.cos() + 1e5 * (2.0 * cycle).sin();
            let torque = gas * area * drive.slope(phi);
            [omega, (torque - 0.5 * slope * omega * omega) / drive.inertia(phi)]
        };
        let steps = 100_000;
        let (step, mut state) = (0.3 / f64::from(steps), [0.0, 100.0]);
        let plus = |a: [f64; 2], h: f64, b: [f64; 2]| [a[0] + h * b[0], a[1] + h * b[1]];
        for _ in 0..steps {
            let k1 = rate(state);
            let k2 = rate(plus(state, step / 2.0, k1));
            let k3 = rate(plus(state, step / 2.0, k2));
            let k4 = rate(plus(state, step, k3));
            let sum = [0, 1].map(|i| k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]);
            state = plus(state, step / 6.0, sum);
        }
        let found = ["angle", "speed"].map(|name| run.last(name).expect("an output"));
        for (found, exact) in found.into_iter().zip(state) {
            assert!((found - exact).abs() < 1e-7 * exact.abs(), "{number}: {found}, not {exact}");
        }
        let within = |crank: &f64| (0.0..strokes * PI).contains(crank);
        assert!(column(&run, "crank").iter().all(within));
        assert!(state[0].abs() > 1.0, "{number}: {state:?}");
    }
}

/// The assembly of planar links has the same motion: it has eight coordinates and seven
/// constraints.
#[test]
fn a_crank_drive_moves_as_the_slider_crank_of_planar_links() {
    let links = of_text(
        r#"
        [scene]
        name = "links"
        [units.drive]
        unit = "planar/slider_crank"
        parameters = { crank_length = 0.045, crank_mass = 1e-6, crank_inertia = 1e-9, rod_length = 0.15, rod_mass = 0.5, rod_inertia = 2e-3, rod_centre = 0.3, slider_mass = 0.6, gravity = 0 }
        [units.wheel]
        unit = "rotational/inertia"
        parameters = { inertia = 0.02 }
        [units.gas]
        unit = "sources/force"
        inputs = { force = "-2000 [N] - 1000 [N]*cos(wheel.phi)" }
        [[joints]]
        connect = ["drive.shaft", "wheel.a"]
        [[joints]]
        connect = ["gas.a", "drive.slider"]
        [initial]
        "wheel.omega" = 100
        [guess]
        "drive.rod.omega" = -30
        [outputs]
        speed = "wheel.omega"
        stroke = "drive.stroke"
        [run]
        until = 0.2
        points = 201
        rtol = 1e-11
        method = "dop853"
        "#,
        Keep::Needed,
    );
    let area = PI * 0.085_f64.powi(2) / 4.0;
    let pressure = format!("(2000 [N] + 1000 [N]*cos(cylinder.crank))/{area:?} [m^2]");
    let other = DRIVES[0].text(&pressure, 2.0, "").replace("until = 0.3", "until = 0.2");
    let other = of_text(&other.replace("points = 301", "points = 201"), Keep::Needed);
    let [links, other] =
        [&links, &other].map(|scene| Simulation::new(scene).run().expect("it runs"));
    let [a, b] = [&links, &other].map(|run| column(run, "speed"));
    let (stroke, way) = (column(&links, "stroke"), column(&other, "way"));
    for row in 0..a.len() {
        // The crank of the assembly has 1e-6 kg.
        assert!((a[row] - b[row]).abs() < 1e-5 * b[row], "{row}: {}, {}", a[row], b[row]);
        assert!((0.195 - stroke[row] - way[row]).abs() < 1e-6, "{row}");
    }
}

/// The work of the gas in a cycle of the example is what the load takes.
#[test]
fn the_gas_of_the_example_does_the_work_of_its_table() {
    let scene = example("rotational/crank_drive", Keep::All);
    let run = Simulation::new(&scene).rtol(1e-9).until(60.0).points(2).run().expect("it runs");
    let settled = run.last("speed").expect("a speed");
    // Mean effective pressure times displacement: area of the table's loop by trapezoids.
    let table = include_str!("../../specs/scenes/parts/rotational/tables/four_stroke.csv");
    let rows: Vec<[f64; 2]> = table
        .lines()
        .skip(1)
        .map(|line| {
            let (crank, gauge) = line.split_once(',').expect("two columns");
            [crank, gauge].map(|text| text.parse().expect("a number"))
        })
        .collect();
    let area = PI * 0.085_f64.powi(2) / 4.0;
    let way = |degrees: f64| {
        let angle = degrees.to_radians();
        let lean = (0.3 * angle.sin()).asin();
        0.045 * (1.0 - angle.cos()) + 0.15 * (1.0 - lean.cos())
    };
    let work: f64 = rows
        .windows(2)
        .map(|pair| 0.5e5 * area * (pair[0][1] + pair[1][1]) * (way(pair[1][0]) - way(pair[0][0])))
        .sum();
    // The load takes d omega per radian, 4 pi a cycle.
    let steady = work / (0.25 * 4.0 * PI) * 60.0 / TAU;
    assert!((settled - steady).abs() < 0.15 * steady, "{settled} rpm, {steady} by the table");
}

//! Tops and a rolling disc, described by quaternions: closed forms of their steady motions.

use super::*;

const TOP: &str = r#"
[scene]
name = "top"
[units]
gyro = { unit = "top" }
[run]
until = 20
points = 41
rtol = 1e-11
[define.top]
gravity = [0, 0, -9.81]
[define.top.orientations]
turn = { rotation = { sequence = "zxz", angles = [0, INCLINED, 0] } }
[define.top.frames]
top = { spherical = "turn" }
[define.top.bodies]
top = { frame = "top", mass = 1.5, centre = [0, 0, 0.3], inertia = { xx = 0.05, yy = 0.05, zz = 0.02 } }
"#;

const SPIN_INERTIA: f64 = 0.02;
const ABOUT_SUPPORT: f64 = 0.05 + 1.5 * 0.3 * 0.3;
const WEIGHT_ARM: f64 = 1.5 * 9.81 * 0.3;

/// C (psi' + phi' cos) phi' - A phi'^2 cos = m g l keeps the inclination of a heavy top.
#[test]
fn a_heavy_top_precesses_by_quaternions() {
    for (inclination, precession) in [(0.6_f64, 2.0), (1.7, -1.5), (2.9, 4.0)] {
        let total = (WEIGHT_ARM / precession + ABOUT_SUPPORT * precession * inclination.cos())
            / SPIN_INERTIA;
        // Along the turned axes at psi = 0: precession has sin along y and cos along z.
        let across = precession * inclination.sin();
        let text = TOP.replace("INCLINED", &format!("{inclination}"))
            + &*format!(
                "[initial]\n\"gyro.turn_omega_y\" = {across:?}\n\"gyro.turn_omega_z\" = {total:?}\n"
            );
        let found = run(&text);
        for (row, time) in found.times.iter().enumerate() {
            let axis = turned(&found, "gyro.turn", row) * Vector3::z();
            let angle = precession * time;
            let wanted = Vector3::new(
                inclination.sin() * angle.sin(),
                -inclination.sin() * angle.cos(),
                inclination.cos(),
            );
            let error = (axis - wanted).norm();
            assert!(error < 1e-7, "the axis is off by {error:e} at {time} s");
        }
    }
}

/// A sleeping top is stable above the spin 2 sqrt(A m g l)/C, and its axis then nods and precesses at
/// C s/(2 A) +- sqrt((C s/(2 A))^2 - m g l/A).
#[test]
fn a_sleeping_top_falls_below_its_limit() {
    let limit = 2.0 * (ABOUT_SUPPORT * WEIGHT_ARM).sqrt() / SPIN_INERTIA;
    let text = TOP.replace("INCLINED", "0");
    for share in [0.5, 0.9, 0.99, 1.01, 1.1, 2.0] {
        let spin = share * limit;
        let text = format!("{text}[initial]\n\"gyro.turn_omega_z\" = {spin:?}\n");
        let scene = of_text(&text, Keep::All);
        let simulation = Simulation::new(&scene);
        let point = operating_point(&simulation, Place::Initial).expect("a point");
        let modes = Linearization::at(&scene, point).expect("regular").modes().expect("values");
        let growth = modes.iter().map(|mode| mode.real).fold(0.0, f64::max);
        let half = SPIN_INERTIA * spin / (2.0 * ABOUT_SUPPORT);
        let square = half * half - WEIGHT_ARM / ABOUT_SUPPORT;
        let wanted = if square < 0.0 { (-square).sqrt() } else { 0.0 };
        assert!((growth - wanted).abs() < 1e-6, "{growth} instead of {wanted} at {share}");
        // Seen from axes that turn with the top.
        for way in [-1.0, 1.0].into_iter().filter(|_| square > 0.0) {
            let wanted = (half + way * square.sqrt() - spin).abs();
            let nearest = |least: f64, mode: &Mode| least.min((mode.imaginary - wanted).abs());
            let error = modes.iter().fold(f64::INFINITY, nearest);
            assert!(error < 1e-6 * wanted, "no frequency {wanted} at {share}");
        }
    }
}

/// A disc of radius r that rolls without slipping on a circle. Its steady motion, with the angle
/// theta of its axis to the vertical, precession p and the rate s about its axis, fulfils
/// (C + m r^2) s p sin = A p^2 sin cos - m g r cos.
#[test]
fn a_disc_rolls_on_a_circle() {
    let (mass, radius, across, along) = (1.2_f64, 0.4, 0.05, 0.1);
    let text = format!(
        r#"
[scene]
name = "disc"
[units]
d = {{ unit = "disc" }}
[run]
until = 8
points = 81
rtol = 1e-11
[initial]
START
[define.disc]
gravity = [0, 0, -9.81]
[define.disc.coordinates]
x = {{ unit = "m" }}
y = {{ unit = "m" }}
z = {{ unit = "m" }}
[define.disc.orientations]
turn = {{ rotation = {{ axis = [1, 0, 0], angle = INCLINED }} }}
[define.disc.frames]
disc = {{ displacement = ["x", "y", "z"], spherical = "turn" }}
[define.disc.bodies]
disc = {{ frame = "disc", mass = {mass}, inertia = {{ xx = {across}, yy = {across}, zz = {along} }} }}
# The lowest point is at -r (z - a (a.z))/|z - a (a.z)| with a the axis of the disc.
[define.disc.helpers]
level = {{ expression = "sqrt(disc_r_xz^2 + disc_r_yz^2)", unit = "1" }}
down_x = {{ expression = "{radius} [m]*disc_r_zz*disc_r_xz/level", unit = "m" }}
down_y = {{ expression = "{radius} [m]*disc_r_zz*disc_r_yz/level", unit = "m" }}
down_z = {{ expression = "-{radius} [m]*level", unit = "m" }}
[define.disc.constraints]
touches = {{ expression = "z + down_z" }}
rolls_x = {{ expression = "x_dot + disc_omega_y*down_z - disc_omega_z*down_y" }}
rolls_y = {{ expression = "y_dot + disc_omega_z*down_x - disc_omega_x*down_z" }}
"#
    );
    for (inclination, precession) in [(1.2_f64, 1.5), (0.7, 3.0)] {
        let (sin, cos) = inclination.sin_cos();
        // The axis of the disc is inclined to the vertical by theta: a = (0, -sin, cos).
        let weight = mass * 9.81 * radius * cos;
        let whole = (across * precession * precession * sin * cos - weight)
            / ((along + mass * radius * radius) * precession * sin);
        let text = text.replace("INCLINED", &format!("{inclination}")).replace(
            "START",
            &format!(
                "\"d.z\" = {:?}\n\"d.turn_omega_x\" = 0\n\"d.turn_omega_y\" = {:?}\n\
                     \"d.turn_omega_z\" = {:?}",
                radius * sin,
                precession * sin,
                whole
            ),
        );
        let found = run(&text);
        let energy = column(&found, "energy.total");
        for (row, time) in found.times.iter().enumerate() {
            let axis = turned(&found, "d.turn", row) * Vector3::z();
            let spread = (energy[row] - energy[0]).abs() / energy[0].abs();
            assert!(spread < 1e-8, "the energy is off by {spread:e}");
            let error = (axis.z - cos).abs();
            assert!(error < 1e-7, "the inclination is off by {error:e} at {time} s");
        }
    }
}

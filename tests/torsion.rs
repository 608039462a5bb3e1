//! Torsional drives of standard parts: natural frequencies of geared, branched and ship drives
//! against Holzer's elimination and published digits, and of a drill string.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::fmt::Write as _;

use machinist::Simulation;
use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{Linearization, ModeKind, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;

use crate::own_scene::of_text;

/// Disc of a drive that branches like a tree.
struct Disc {
    /// Disc towards the first one, and the torsional stiffness of the shaft to it \[N m/rad\].
    parent: Option<(usize, f64)>,
    /// Moment of inertia \[kg m^2\].
    inertia: f64,
    /// Turns of the shaft to the parent per turn of this disc.
    ratio: f64,
}

const fn disc(parent: usize, stiffness: f64, inertia: f64, ratio: f64) -> Disc {
    Disc { parent: Some((parent, stiffness)), inertia, ratio }
}

const fn first(inertia: f64) -> Disc {
    Disc { parent: None, inertia, ratio: 1.0 }
}

/// Returns the number of natural frequencies below `omega`: the number of negative pivots when discs
/// are eliminated from the ends of the branches, each with the dynamic stiffness of what follows it
/// (Holzer with Sturm's count).
fn below(drive: &[Disc], omega: f64) -> usize {
    let mut own: Vec<f64> = drive.iter().map(|disc| -omega * omega * disc.inertia).collect();
    let mut count = 0;
    for (index, disc) in drive.iter().enumerate().rev() {
        let Some((parent, stiffness)) = disc.parent else {
            count += usize::from(own[index] < 0.0);
            continue;
        };
        // The shaft twists by phi_parent - ratio*phi.
        let pivot = own[index] + stiffness * disc.ratio * disc.ratio;
        count += usize::from(pivot < 0.0);
        own[parent] += stiffness - (stiffness * disc.ratio).powi(2) / pivot;
    }
    count
}

/// Returns all natural frequencies above zero by bisection of the count.
fn holzer(drive: &[Disc]) -> Vec<f64> {
    let mut highest = 1.0;
    while below(drive, highest) < drive.len() {
        highest *= 2.0;
    }
    // One frequency is zero: the drive turns freely.
    let frequency = |number: usize| {
        let (mut low, mut high) = (0.0, highest);
        while high - low > 4.0 * f64::EPSILON * high {
            let middle = 0.5 * (low + high);
            if below(drive, middle) > number { high = middle } else { low = middle }
        }
        0.5 * (low + high)
    };
    (1..drive.len()).map(frequency).collect()
}

/// Returns the drive as a scene of inertias, springs and gears.
fn scene(drive: &[Disc]) -> String {
    let mut text = "[scene]\nname = \"torsion\"\n".to_owned();
    for (index, Disc { parent, inertia, ratio }) in drive.iter().enumerate() {
        let _ = write!(
            text,
            "[units.d{index}]\nunit = \"rotational/inertia\"\nparameters = {{ inertia = {inertia:?} }}\n"
        );
        let Some((parent, stiffness)) = parent else { continue };
        let _ = write!(
            text,
            "[units.s{index}]\nunit = \"rotational/spring\"\nparameters = {{ stiffness = {stiffness:?} }}\n\
             [[joints]]\nconnect = [\"d{parent}.b\", \"s{index}.a\"]\n"
        );
        if (ratio - 1.0).abs() > 0.0 {
            let _ = write!(
                text,
                "[units.g{index}]\nunit = \"rotational/gear\"\nparameters = {{ ratio = {ratio:?} }}\n\
                 [[joints]]\nconnect = [\"s{index}.b\", \"g{index}.a\"]\n\
                 [[joints]]\nconnect = [\"g{index}.b\", \"d{index}.a\"]\n"
            );
        } else {
            let _ = write!(text, "[[joints]]\nconnect = [\"s{index}.b\", \"d{index}.a\"]\n");
        }
    }
    text + "[outputs]\nspeed = \"d0.omega\"\n[run]\nuntil = 0.1\npoints = 2\nrtol = 1e-9\nmethod = \"auto\"\n"
}

/// Returns the natural frequencies at the initial state \[rad/s\], ascending.
fn natural_frequencies(simulator: &dyn Simulator<f64>) -> Vec<f64> {
    let point = operating_point(&Simulation::new(simulator), Place::Initial).expect("a state");
    let modes = Linearization::at(simulator, point).expect("finite").modes().expect("modes");
    let mut found: Vec<f64> = modes
        .iter()
        .filter(|mode| mode.kind == ModeKind::Oscillation)
        .map(machinist::linear_analysis::Mode::natural_frequency)
        .collect();
    found.sort_by(f64::total_cmp);
    found
}

fn assert_frequencies(name: &str, drive: &[Disc]) -> Vec<f64> {
    let found = natural_frequencies(&of_text(&scene(drive), Keep::All));
    let wanted = holzer(drive);
    assert_eq!(found.len(), wanted.len(), "{name}: {found:?}, {wanted:?}");
    for (found, wanted) in found.iter().zip(&wanted) {
        assert!((found / wanted - 1.0).abs() < 1e-9, "{name}: {found}, not {wanted}");
    }
    found
}

/// Natural frequencies agree with those printed in Hz, to the last digit.
fn assert_published(name: &str, drive: &[Disc], printed: &[&str]) {
    let found = assert_frequencies(name, drive);
    assert_eq!(found.len(), printed.len(), "{name}");
    for (found, printed) in found.iter().zip(printed) {
        let digits = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
        assert_eq!(&format!("{:.digits$}", found / TAU), printed, "{name}");
    }
}

/// Drives of M. Friswell, J. Penny, S. Garvey and A. Lees, Dynamics of Rotating Machines,
/// Cambridge 2010, chapter 9; numbers as in the tests of openTorsion.
#[test]
fn published_drives_have_their_printed_frequencies() {
    let two = [first(211.4), disc(0, 9.775e6, 8.3, 1.0)];
    assert_published("two discs", &two, &["176.1"]);
    // A motor drives two rotors, one of them by gears of equal size.
    let inertia = 700e-6;
    let geared = [
        first(400e-6),
        disc(0, 1e4, 2.0 * 25e-6, 1.0),
        disc(1, 5e3, inertia, 1.0),
        disc(1, 5e3, inertia, -1.0),
    ];
    assert_published("geared", &geared, &["425.4", "634.1", "3247.2"]);
    // Three cylinders, a flywheel and a generator.
    let cylinder = 3.5e-3;
    let engine = [
        first(cylinder),
        disc(0, 12e3, cylinder, 1.0),
        disc(1, 12e3, cylinder, 1.0),
        disc(2, 14e3, 0.15, 1.0),
        disc(3, 10e3, 0.05, 1.0),
    ];
    assert_published("engine", &engine, &["81.21", "141.21", "378.95", "536.36"]);
    // A propeller and two turbines behind gears of 0.5 m and 0.8 m, of 200 and 800 kg m^2.
    let shaft = |diameter: f64, length: f64| 68e9 * PI * diameter.powi(4) / 32.0 / length;
    let share = 0.5_f64 / 0.8;
    let gears = 2.0 * 200.0 + 2.0 * 800.0 * share * share;
    let (slow, turbine) = (shaft(0.2, 2.5), shaft(0.25, 3.5) * share * share);
    let branched = [
        first(3200.0),
        disc(0, slow, gears, 1.0),
        disc(1, turbine, 450.0, 1.0 / share),
        disc(1, turbine, 450.0, -1.0 / share),
    ];
    assert_published("branched", &branched, &["10.304", "20.479", "24.423"]);
}

/// Drill pipe of 5000 ft, held at the top, with a collar of 120 ft at its end: W. Thomson, Theory
/// of Vibration with Applications, example 9.3-3, prints 2.41 and 7.93 rad/s. The frequency equation
/// is b tan b = J_pipe/J_collar with w = b sqrt(G/rho)/l.
#[test]
fn a_drill_string_has_the_frequencies_of_its_equation_and_the_printed_ones() {
    const FOOT: f64 = 0.3048;
    const POUND: f64 = 4.448_221_615_260_5;
    let (length, polar, shear) = (5000.0, 0.000_94, 12e6 * 144.0);
    let (density, collar) = (490.0 / 32.2, 29.3);
    let (of_length, of_pipe) = (length * FOOT, density * polar * POUND);
    let (rigidity, inertia) = (shear * polar * POUND * FOOT * FOOT, collar * POUND * FOOT);
    let text = format!(
        r#"
        [scene]
        name = "drill_string"
        [units.pipe]
        unit = "shaft"
        parameters = {{ length = {of_length:?}, density = {of_pipe:?}, stiffness = {rigidity:?} }}
        inputs = {{ load = 0 }}
        fields = {{ phi = {{ elements = 8, order = 6, start = "fixed" }} }}
        [units.collar]
        unit = "rotational/inertia"
        parameters = {{ inertia = {inertia:?} }}
        [[joints]]
        connect = ["pipe.end", "collar.a"]
        [outputs]
        twist = "collar.phi"
        [run]
        until = 1.0
        points = 2
        rtol = 1e-9
        method = "auto"
        "#
    );
    let scene = of_text(&text, Keep::All);
    let divided = FieldSimulator::new(scene.with_fields(), Discretisation::default());
    let divided = divided.expect("it is divided");
    let found = natural_frequencies(divided.single());
    let ratio = density * polar * length / collar;
    let root = |number: usize| {
        let start = PI * number as f64;
        let (mut low, mut high) = (start, start + FRAC_PI_2);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            let value = middle * middle.sin() - ratio * middle.cos();
            if value * start.cos() > 0.0 { high = middle } else { low = middle }
        }
        low
    };
    for (number, found) in found.iter().take(6).enumerate() {
        let wanted = root(number) * (shear / density).sqrt() / length;
        assert!((found / wanted - 1.0).abs() < 1e-9, "{number}: {found}, not {wanted}");
    }
    for (found, printed) in found.iter().zip(["2.41", "7.93"]) {
        // The book divides rounded numbers.
        let off = found - printed.parse::<f64>().expect("a number");
        assert!(off.abs() < 0.01, "{found}, printed {printed}");
    }
}

#[test]
fn geared_branched_and_ship_drives_have_the_frequencies_of_holzer() {
    // A motor, a reducer 5:1, a machine.
    assert_frequencies("geared", &[first(0.8), disc(0, 2.5e4, 0.05, 1.0), disc(1, 6e6, 12.0, 5.0)]);
    // An engine drives a propeller and, faster, a generator and a pump.
    let branched = [
        first(40.0),
        disc(0, 8e5, 15.0, 1.0),
        disc(1, 4e6, 90.0, 3.2),
        disc(2, 5e5, 350.0, 1.0),
        disc(1, 2e5, 2.5, 0.4),
        disc(4, 9e4, 6.0, 1.0),
        disc(1, 1.5e5, 1.1, -0.7),
    ];
    assert_frequencies("branched", &branched);
    // Two engines on one propeller: the branches of equal engines swing against each other.
    let twin = [
        first(900.0),
        disc(0, 3e6, 260.0, 1.0),
        disc(1, 4e7, 70.0, 0.3),
        disc(1, 4e7, 70.0, 0.3),
        disc(2, 2e6, 120.0, 1.0),
        disc(3, 2e6, 120.0, 1.0),
    ];
    assert_frequencies("twin", &twin);
    // A slow two-stroke diesel: vibration damper's ring, six cylinders, flywheel, shaft, propeller.
    let mut ship = vec![first(2_000.0), disc(0, 6e7, 3_500.0, 1.0)];
    for cylinder in 2..7 {
        ship.push(disc(cylinder - 1, 9e8, 13_000.0 + 150.0 * cylinder as f64, 1.0));
    }
    ship.extend([
        disc(6, 1.2e9, 8_000.0, 1.0),
        disc(7, 7e7, 1_500.0, 1.0),
        disc(8, 9e7, 55_000.0, 1.0),
    ]);
    assert_frequencies("ship", &ship);
}

/// Parameters of all drives far beyond one example.
#[test]
fn random_trees_of_discs_have_the_frequencies_of_holzer() {
    let mut seed = 52_u64;
    let mut draw = |from: f64, to: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from * (to / from).powf((seed >> 11) as f64 / (1_u64 << 53) as f64)
    };
    for number in 0..6 {
        let discs = 3 + 2 * number;
        let mut drive = vec![first(draw(0.1, 10.0))];
        for index in 1..discs {
            let parent = (draw(1.0, index as f64 + 0.999) as usize).clamp(1, index) - 1;
            let ratio = if draw(1.0, 4.0) > 2.0 { draw(0.2, 5.0) } else { 1.0 };
            drive.push(disc(parent, draw(1e3, 1e6), draw(0.01, 10.0), ratio));
        }
        assert_frequencies(&format!("tree {number}"), &drive);
    }
}

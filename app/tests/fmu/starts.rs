//! Starts in equilibrium: the same as in runs of Machinist, with values set by the host.

use machinist_fmu::abi::*;

use super::host::{Archive, Drive, Stepper, Unit};

/// Quarter of a car on its tyre, and a sled that rests anywhere.
const CAR: &str = r#"
    [scene]
    name = "quarter_car"
    [units]
    car = { unit = "car" }
    sled = { unit = "translational/mass" }
    [initial]
    from = "equilibrium"
    "sled.x" = 0.2
    [outputs]
    body = "car.body"
    [run]
    until = 2.0
    [define.car.coordinates]
    body = { unit = "m" }
    wheel = { unit = "m" }
    [define.car.parameters]
    body_mass = { value = 300, unit = "kg" }
    wheel_mass = { value = 40, unit = "kg" }
    spring = { value = 2e4, unit = "N/m" }
    damping = { value = 1500, unit = "N s/m" }
    tyre = { value = 2e5, unit = "N/m" }
    [define.car.energy]
    kinetic = "body_mass*body_dot^2/2 + wheel_mass*wheel_dot^2/2"
    potential = "spring*(body - wheel)^2/2 + 9.81 [m/s^2]*(body_mass*body + wheel_mass*wheel) + tyre*max(-wheel, 0)^2/2"
    dissipation = "damping*(body_dot - wheel_dot)^2/2"
"#;

/// Rest positions of body and wheel, by their weights over the springs below them \[m\].
fn at_rest(body_mass: f64) -> [f64; 2] {
    let wheel = -9.81 * (body_mass + 40.0) / 2e5;
    [wheel - 9.81 * body_mass / 2e4, wheel]
}

fn near(found: &[f64], exact: &[f64]) {
    let is_near = found.iter().zip(exact).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(found.len() == exact.len() && is_near, "{found:?} for {exact:?}");
}

fn archive() -> Archive {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("car.toml");
    std::fs::write(&file, CAR).expect("written");
    Archive::of(file.to_str().expect("a plain path"), &["--keep-all"])
}

#[test]
fn the_description_starts_in_the_equilibrium_of_a_run() {
    let variables = archive().variables();
    let start = |name: &str| variables[name]["start"].parse::<f64>().expect("a number");
    near(&[start("car.body"), start("car.wheel"), start("sled.x")], &{
        let [body, wheel] = at_rest(300.0);
        [body, wheel, 0.2]
    });
    for name in ["car.body", "car.wheel", "sled.x"] {
        assert_eq!(variables[name]["initial"], "approx", "{name}");
    }
}

#[test]
fn a_unit_rests_in_the_equilibrium_of_its_parameters() {
    let archive = archive();
    let of = ["car.body", "car.wheel", "sled.x"].map(|name| archive.reference(name));
    let mass = archive.reference("car.body_mass");
    for drive in [Drive::Exchange, Drive::Simulation] {
        let unit = Unit::new(&archive, drive).expect("an instance");
        unit.begin(2.0);
        let [body, wheel] = at_rest(300.0);
        near(&unit.get(&of), &[body, wheel, 0.2]);
        // With another parameter, and another value of the state that the equilibrium leaves open.
        unsafe { fmi3Reset(unit.handle) };
        unit.set(mass, 420.0);
        unit.set(of[2], 0.7);
        unit.begin(2.0);
        let [body, wheel] = at_rest(420.0);
        near(&unit.get(&of), &[body, wheel, 0.7]);
        if drive == Drive::Exchange {
            let mut stepper = Stepper::new(&unit);
            stepper.go(0.1, 1e-3);
        } else {
            unit.step(0.0, 0.5);
        }
        near(&unit.get(&of), &[body, wheel, 0.7]);
    }
}

#[test]
fn a_unit_without_an_equilibrium_is_refused_and_goes_on_with_other_parameters() {
    let archive = archive();
    let (tyre, body) = (archive.reference("car.tyre"), archive.reference("car.body"));
    let unit = archive.simulation();
    unit.set(tyre, 0.0);
    unsafe {
        assert_eq!(fmi3EnterInitializationMode(unit.handle, 0, 0.0, 0.0, 0, 0.0), Status::Ok);
        assert_eq!(fmi3ExitInitializationMode(unit.handle), Status::Error);
    }
    assert!(unit.log().concat().contains("no start in equilibrium"));
    unit.set(tyre, 2e5);
    unsafe { assert_eq!(fmi3ExitInitializationMode(unit.handle), Status::Ok) };
    near(&unit.get(&[body]), &at_rest(300.0)[..1]);
}

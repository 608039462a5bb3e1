//! States that are kept, serialized, deserialized and restored.

use std::ptr;

use machinist_fmu::abi::{
    StateHandle, Status, fmi3DeserializeFMUState, fmi3FreeFMUState, fmi3GetFMUState,
    fmi3SetFMUState,
};

use super::host::{Archive, Stepper, Unit, ok};

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

/// Returns all values that a host can read.
fn all(archive: &Archive, unit: &Unit) -> Vec<u64> {
    let variables = archive.elements("Float64");
    let references: Vec<u32> = (0..).take(variables.len()).collect();
    // Modes are integers and are listed among these.
    let modes = archive.elements("Int32");
    let modes: Vec<u32> = modes.iter().map(|m| super::host::number(m, "valueReference")).collect();
    let references: Vec<u32> = (0..)
        .take(references.len() + modes.len())
        .filter(|reference| !modes.contains(reference))
        .collect();
    bits(&unit.get(&references))
}

#[test]
fn a_state_that_is_written_is_continued_by_another_instance_bit_for_bit() {
    for scene in ["saw_gin", "stick_slip", "bouncing_mass", "winder_holder_drop"] {
        let archive = Archive::of(scene, &[]);
        let unit = archive.simulation();
        unit.begin(1.0);
        let at = |index: u32| f64::from(index) * 0.01;
        for index in 0..13 {
            unit.step(at(index), 0.01);
        }
        let written = unit.written();
        let other = archive.simulation();
        other.read(&written);
        for index in 13..30 {
            unit.step(at(index), 0.01);
            other.step(at(index), 0.01);
            assert_eq!(all(&archive, &unit), all(&archive, &other), "{scene} at {index}");
        }
        // Back in the first instance.
        let later = all(&archive, &unit);
        unit.read(&written);
        for index in 13..30 {
            unit.step(at(index), 0.01);
        }
        assert_eq!(all(&archive, &unit), later, "{scene}");
    }
}

#[test]
fn a_state_of_model_exchange_is_continued_bit_for_bit() {
    for scene in ["saw_gin", "stick_slip", "bouncing_mass"] {
        let archive = Archive::of(scene, &[]);
        let unit = archive.exchange();
        unit.begin(1.0);
        let mut stepper = Stepper::new(&unit);
        stepper.go(0.15, 1e-3);
        let written = unit.written();
        let (time, events) = (stepper.time, stepper.events);
        stepper.go(0.4, 1e-3);
        let later = all(&archive, &unit);
        unit.read(&written);
        stepper.time = time;
        stepper.events = events;
        stepper.go(0.4, 1e-3);
        assert_eq!(all(&archive, &unit), later, "{scene}");
    }
}

/// A mass on a spring that is shaken, held at times by `friction` with a limit of 1 N.
fn held_at_times(name: &str, friction: &str) -> String {
    format!(
        r#"
        [scene]
        name = "{name}"
        [units.u]
        unit = "u"
        [initial]
        "u.x" = 0.3
        [run]
        until = 6
        rtol = 1e-4
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.parameters]
        limit = {{ value = 1, unit = "N" }}
        [define.u.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "25 [N/m]*x^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = "1.4 [N]*cos(1.7 [rad/s]*t)"
        {friction}
        [outputs]
        place = "u.x"
        speed = "u.v"
        "#
    )
}

/// Friction that sticks by a constraint, that slides along v = 0, along the speed of a belt, and
/// along x = y, where only the second derivative of the guard jumps.
#[test]
fn states_in_the_middle_of_sticking_and_sliding_are_continued_bit_for_bit() {
    let force = |expression: &str| {
        format!("[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"{expression}\"")
    };
    let guide = "[define.u.friction.guide]\nspeed = \"v\"\nsliding = \"limit\"\nunit = \"N\"";
    let belt = "0.05 [m/s]*sin(2 [rad/s]*t)";
    let specs = [
        held_at_times("sticks", guide),
        held_at_times("slides", &force("-limit*sign(v)")),
        held_at_times("on_a_belt", &force(&format!("-limit*sign(v - {belt})"))),
        held_at_times("at_a_place", &force("-limit*sign(x) - 30 [N s/m]*v")),
    ];
    let folder = tempfile::tempdir().expect("a folder");
    for (number, spec) in specs.iter().enumerate() {
        let file = folder.path().join("scene.toml");
        std::fs::write(&file, spec).expect("written");
        let archive = Archive::of(file.to_str().expect("a plain path"), &[]);
        let [place, speed] = ["place", "speed"].map(|name| archive.reference(name));
        // The distance from rest on the surface.
        let off = |unit: &Unit, time: f64| {
            let [x, v] = unit.get(&[place, speed])[..] else { panic!("two values") };
            match number {
                2 => v - 0.05 * (2.0 * time).sin(),
                3 => x.abs() + v.abs(),
                _ => v,
            }
        };
        let mut held = [0; 2];
        for cut in [0.7, 1.3, 2.1, 3.0, 3.6, 5.0] {
            let size = 0.1;
            let steps = |from: f64, until: f64| {
                let count = ((until - from) / size).round() as u32;
                (0..count).map(move |index| from + f64::from(index) * size)
            };
            let unit = archive.simulation();
            unit.begin(6.0);
            steps(0.0, cut).for_each(|time| {
                unit.step(time, size);
            });
            held[0] += u32::from(off(&unit, cut).abs() < 1e-9);
            let written = unit.written();
            let other = archive.simulation();
            other.read(&written);
            for time in steps(cut, 6.0) {
                unit.step(time, size);
                other.step(time, size);
                let same = all(&archive, &unit) == all(&archive, &other);
                assert!(same, "spec {number}, cut at {cut}: differs after {time}");
            }
            let unit = archive.exchange();
            unit.begin(6.0);
            let mut stepper = Stepper::new(&unit);
            stepper.go(cut, 1e-2);
            held[1] += u32::from(off(&unit, cut).abs() < 1e-6);
            let (written, time) = (unit.written(), stepper.time);
            stepper.go(6.0, 1e-2);
            let later = all(&archive, &unit);
            unit.read(&written);
            stepper.time = time;
            stepper.go(6.0, 1e-2);
            assert_eq!(all(&archive, &unit), later, "spec {number}, cut at {cut}, exchange");
        }
        // Pieces of a run hold the mass at the place once excursions are within the tolerances.
        let is_at_times = |held: &u32| (1..6).contains(held);
        assert!(number == 3 || held.iter().all(is_at_times), "spec {number}: {held:?} of 6 held");
    }
}

#[test]
fn handles_of_states_are_looked_up() {
    let archive = Archive::of("bouncing_mass", &[]);
    let unit = archive.simulation();
    unit.begin(1.0);
    let mut state: StateHandle = ptr::null_mut();
    ok!(unit, fmi3GetFMUState(unit.handle, &raw mut state));
    let kept = state;
    // The same handle is reused.
    unit.step(0.0, 0.1);
    ok!(unit, fmi3GetFMUState(unit.handle, &raw mut state));
    assert_eq!(state, kept);
    let other = archive.simulation();
    let foreign = [ptr::null_mut(), kept, ptr::without_provenance_mut(0xdead_beef)];
    for handle in foreign {
        assert_eq!(unsafe { fmi3SetFMUState(other.handle, handle) }, Status::Error);
    }
    ok!(unit, fmi3FreeFMUState(unit.handle, &raw mut state));
    assert_eq!(unsafe { fmi3SetFMUState(unit.handle, kept) }, Status::Error);
    let mut twice = kept;
    assert_eq!(unsafe { fmi3FreeFMUState(unit.handle, &raw mut twice) }, Status::Error);
}

#[test]
fn bytes_that_are_no_state_of_the_archive_are_refused() {
    let archive = Archive::of("stick_slip", &[]);
    let unit = archive.simulation();
    unit.begin(1.0);
    unit.step(0.0, 0.3);
    let written = unit.written();
    let read = |unit: &Unit, bytes: &[u8]| {
        let mut state: StateHandle = ptr::null_mut();
        let at = (bytes.as_ptr(), bytes.len());
        let status = unsafe { fmi3DeserializeFMUState(unit.handle, at.0, at.1, &raw mut state) };
        if status == Status::Ok {
            // A deserialized state must run, or give an error.
            unsafe { fmi3SetFMUState(unit.handle, state) };
            let (mut event, mut end, mut early, mut time) = (0, 0, 0, 0.0);
            unsafe {
                machinist_fmu::abi::fmi3DoStep(
                    unit.handle,
                    0.3,
                    0.01,
                    1,
                    &raw mut event,
                    &raw mut end,
                    &raw mut early,
                    &raw mut time,
                );
            }
        }
        status
    };
    // From the other interface, from another archive, too short, too long.
    assert_eq!(read(&archive.exchange(), &written), Status::Error);
    assert_eq!(read(&Archive::of("bouncing_mass", &[]).simulation(), &written), Status::Error);
    assert_eq!(read(&unit, &written[..written.len() - 1]), Status::Error);
    assert_eq!(read(&unit, &[&written[..], &[0]].concat()), Status::Error);
    assert_eq!(read(&unit, &[]), Status::Error);
    let mut rng = fastrand::Rng::with_seed(7);
    let mut refused = 0;
    for _ in 0..300 {
        let mut damaged = written.clone();
        for _ in 0..rng.usize(1..4) {
            let at = rng.usize(..damaged.len());
            damaged[at] = rng.u8(..);
        }
        refused += usize::from(read(&unit, &damaged) == Status::Error);
    }
    assert!(refused > 50, "{refused}");
}

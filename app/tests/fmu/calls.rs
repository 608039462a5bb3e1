//! Invalid calls: each returns a status and a message, and none crashes.

use std::ffi::c_void;
use std::fs;
use std::ptr;

use fastrand::Rng;
use machinist_fmu::abi::*;

use super::host::{Archive, Drive, Unit, ok};

#[test]
fn values_that_make_no_sense_are_refused_and_nothing_is_set() {
    let archive = Archive::of("saw_gin", &[]);
    let unit = archive.simulation();
    let inertia = archive.reference("motor.inertia");
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(unit.try_set(inertia, value), Status::Error);
        let log = unit.log().concat();
        assert!(log.contains("motor.inertia") && log.contains("unit: "), "{log}");
    }
    // An unknown reference beside a known one: neither is set.
    let (references, values) = ([inertia, 4711], [9.0, 1.0]);
    let at = (references.as_ptr(), values.as_ptr());
    let status = unsafe { fmi3SetFloat64(unit.handle, at.0, 2, at.1, 2) };
    assert_eq!(status, Status::Error);
    assert!(unit.log().concat().contains("4711"));
    assert_eq!(unit.try_set(archive.reference("twist"), 1.0), Status::Error);
    assert_eq!(unit.try_set(0, 1.0), Status::Error);
    assert_eq!(unsafe { fmi3SetFloat64(unit.handle, ptr::null(), 1, at.1, 1) }, Status::Error);
    assert_eq!(unsafe { fmi3SetInt32(unit.handle, at.0, 1, ptr::null(), 1) }, Status::Error);
    unit.begin(1.0);
    assert_eq!(unit.get(&[inertia]), [4.2]);
    // A machine that cannot start is refused at the start, and can be corrected.
    ok!(unit, fmi3Reset(unit.handle));
    unit.set(inertia, 0.0);
    ok!(unit, fmi3EnterInitializationMode(unit.handle, 0, 0.0, 0.0, 0, 0.0));
    let status = unsafe { fmi3ExitInitializationMode(unit.handle) };
    if status == Status::Ok {
        let (mut event, mut end, mut early, mut time) = (0, 0, 0, 0.0);
        let at = (&raw mut event, &raw mut end, &raw mut early, &raw mut time);
        let status = unsafe { fmi3DoStep(unit.handle, 0.0, 0.1, 1, at.0, at.1, at.2, at.3) };
        assert_eq!(status, Status::Error);
    }
    assert!(unit.log().concat().contains("finite"));
    ok!(unit, fmi3Reset(unit.handle));
    unit.begin(1.0);
    unit.step(0.0, 0.1);
}

#[test]
fn calls_out_of_order_are_refused_by_their_names() {
    let archive = Archive::of("stick_slip", &[]);
    let unit = archive.exchange();
    let handle = unit.handle;
    let refused = |unit: &Unit, status: Status, name: &str| {
        assert_eq!(status, Status::Error, "{name}");
        let log = unit.log().concat();
        assert!(log.contains(name), "{name}: {log}");
    };
    unsafe {
        refused(&unit, fmi3ExitInitializationMode(handle), "fmi3ExitInitializationMode");
        refused(&unit, fmi3EnterContinuousTimeMode(handle), "fmi3EnterContinuousTimeMode");
        refused(&unit, fmi3SetTime(handle, 1.0), "fmi3SetTime");
        refused(&unit, fmi3Terminate(handle), "fmi3Terminate");
        let enter = |tolerance, from, until| {
            fmi3EnterInitializationMode(handle, 1, tolerance, from, 1, until)
        };
        for (tolerance, from, until) in
            [(0.0, 0.0, 1.0), (f64::NAN, 0.0, 1.0), (1e-6, 0.0, 0.0), (1e-6, f64::NAN, 1.0)]
        {
            let status = enter(tolerance, from, until);
            refused(&unit, status, "fmi3EnterInitializationMode");
        }
    }
    unit.begin(1.0);
    unsafe {
        refused(&unit, fmi3EnterStepMode(handle), "fmi3EnterStepMode");
        let nothing = (ptr::null_mut(), ptr::null_mut());
        let status = fmi3DoStep(handle, 0.0, 0.1, 1, nothing.0, nothing.0, nothing.0, nothing.1);
        refused(&unit, status, "fmi3DoStep");
        refused(&unit, fmi3EnterConfigurationMode(handle), "fmi3EnterConfigurationMode");
        refused(&unit, fmi3EvaluateDiscreteStates(handle), "fmi3EvaluateDiscreteStates");
    }
    let simulation = archive.simulation();
    simulation.begin(1.0);
    unsafe {
        let handle = simulation.handle;
        refused(&simulation, fmi3EnterEventMode(handle), "fmi3EnterEventMode");
        refused(&simulation, fmi3SetTime(handle, 1.0), "fmi3SetTime");
        for (from, size) in [(0.5, 0.1), (0.0, 0.0), (0.0, -1.0), (0.0, f64::NAN)] {
            let nothing = (ptr::null_mut(), ptr::null_mut());
            let status =
                fmi3DoStep(handle, from, size, 1, nothing.0, nothing.0, nothing.0, nothing.1);
            refused(&simulation, status, "fmi3DoStep");
        }
    }
    // The instance still works after all that.
    simulation.step(0.0, 0.1);
}

#[test]
fn states_that_are_no_numbers_ask_for_a_shorter_step() {
    let archive = Archive::of("saw_gin", &[]);
    let unit = archive.exchange();
    unit.begin(1.0);
    unit.update();
    ok!(unit, fmi3EnterContinuousTimeMode(unit.handle));
    let states = [0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0, 0.0];
    let status = unsafe { fmi3SetContinuousStates(unit.handle, states.as_ptr(), 7) };
    assert_eq!(status, Status::Discard);
    let far = [1e300; 7];
    ok!(unit, fmi3SetContinuousStates(unit.handle, far.as_ptr(), 7));
    let mut rates = [0.0; 7];
    let status = unsafe { fmi3GetContinuousStateDerivatives(unit.handle, rates.as_mut_ptr(), 7) };
    assert_eq!(status, Status::Discard);
    assert!(unit.log().concat().contains("rate"));
    assert_eq!(unsafe { fmi3SetContinuousStates(unit.handle, far.as_ptr(), 6) }, Status::Error);
}

#[test]
fn archives_whose_parts_do_not_belong_together_make_no_instance() {
    let archive = Archive::of("bouncing_mass", &[]);
    let (token, resources) = (archive.token(), archive.resources());
    let refused = |token: &str, resources: &str, word: &str| {
        for drive in [Drive::Exchange, Drive::Simulation] {
            let log = Unit::instantiated(token, resources, drive).err().expect("no instance");
            assert!(log.contains(word), "{word}: {log}");
        }
    };
    refused("{another}", &resources, "token");
    refused(&token, "/nowhere/at/all/", "machine.model");
    let [model, export] =
        ["machine.model", "machine.export"].map(|name| format!("{resources}{name}"));
    for path in [&model, &export] {
        let bytes = fs::read(path).expect("a resource");
        let damaged = |write: &dyn Fn(&mut Vec<u8>)| {
            let mut bytes = bytes.clone();
            write(&mut bytes);
            fs::write(path, bytes).expect("written");
        };
        damaged(&|bytes| bytes.truncate(bytes.len() / 2));
        refused(&token, &resources, "cut off");
        damaged(&|bytes| *bytes.last_mut().expect("bytes") ^= 1);
        refused(&token, &resources, "altered");
        damaged(&Vec::clear);
        refused(&token, &resources, "machine.");
        fs::write(path, bytes).expect("written");
    }
    assert!(Unit::instantiated(&token, &resources, Drive::Exchange).is_ok());
    let none = unsafe {
        fmi3InstantiateModelExchange(
            ptr::null(),
            ptr::null(),
            ptr::null(),
            0,
            0,
            ptr::null_mut(),
            None,
        )
    };
    assert!(none.is_null());
}

#[test]
fn handles_of_nothing_are_errors() {
    let archive = Archive::of("bouncing_mass", &[]);
    let freed = {
        let unit = archive.exchange();
        unit.handle
    };
    let handles: [Handle; 3] =
        [ptr::null_mut(), freed, ptr::without_provenance_mut::<c_void>(0xdead_beef)];
    for handle in handles {
        unsafe {
            assert_eq!(fmi3Terminate(handle), Status::Error);
            assert_eq!(fmi3SetTime(handle, 0.0), Status::Error);
            fmi3FreeInstance(handle);
        }
    }
}

/// Numbers that a host may hand over.
const NUMBERS: [f64; 12] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.01,
    1e-12,
    1e300,
    -1e300,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MIN_POSITIVE,
];

/// Host that makes any call at any time.
struct Chaos {
    rng: Rng,
    handles: Vec<Handle>,
    states: Vec<StateHandle>,
    bytes: Vec<u8>,
    calls: usize,
}

impl Chaos {
    fn number(&mut self) -> f64 {
        if self.rng.bool() { self.rng.f64() } else { NUMBERS[self.rng.usize(..NUMBERS.len())] }
    }

    fn reference(&mut self) -> u32 {
        if self.rng.u32(..20) == 0 { self.rng.u32(..) } else { self.rng.u32(..70) }
    }

    fn flag(&mut self) -> u8 {
        if self.rng.u32(..10) == 0 { self.rng.u8(..) } else { self.rng.u8(..2) }
    }

    fn handle(&mut self) -> Handle {
        if self.rng.u32(..40) == 0 {
            // Odd, hence of nothing: an instance of another test would log to that test's host.
            return ptr::without_provenance_mut(self.rng.usize(..256) | 1);
        }
        self.handles[self.rng.usize(..self.handles.len())]
    }

    fn state(&mut self) -> StateHandle {
        match self.states.len() {
            0 => ptr::without_provenance_mut(self.rng.usize(..4)),
            count => self.states[self.rng.usize(..count)],
        }
    }

    /// Makes one call and returns its status.
    #[allow(clippy::too_many_lines, reason = "a list of calls")]
    fn call(&mut self) -> Status {
        self.calls += 1;
        let handle = self.handle();
        let mut values = [0.0; 70];
        for value in &mut values {
            *value = self.number();
        }
        let mut references = [0; 5];
        for reference in &mut references {
            *reference = self.reference();
        }
        let (mut a, mut b, mut c, mut d, mut e) = (0u8, 0u8, 0u8, 0u8, 0u8);
        let mut time = 0.0;
        let mut size = 0usize;
        let count = self.rng.usize(..6);
        let (r, v) = (references.as_ptr(), values.as_mut_ptr());
        let [x, y, z] = [self.number(), self.number(), self.number()];
        let [p, q] = [self.flag(), self.flag()];
        let many = self.rng.usize(..70);
        unsafe {
            match self.rng.u32(..34) {
                0 | 1 => fmi3EnterInitializationMode(handle, p, x.abs() * 1e-3, 0.0, q, 10.0 * y),
                2 => fmi3EnterInitializationMode(handle, p, x, y, q, z),
                3 | 4 => fmi3ExitInitializationMode(handle),
                5 => fmi3EnterEventMode(handle),
                6..8 => {
                    let at = (&raw mut a, &raw mut b, &raw mut c, &raw mut d, &raw mut e);
                    let next = &raw mut time;
                    fmi3UpdateDiscreteStates(handle, at.0, at.1, at.2, at.3, at.4, next)
                }
                8 | 9 => fmi3EnterContinuousTimeMode(handle),
                10 => fmi3EnterStepMode(handle),
                11 => fmi3CompletedIntegratorStep(handle, p, &raw mut a, &raw mut b),
                12 => fmi3SetTime(handle, x),
                13 => fmi3SetContinuousStates(handle, v, many),
                14 => fmi3GetContinuousStates(handle, v, many),
                15 => fmi3GetContinuousStateDerivatives(handle, v, many),
                16 => fmi3GetEventIndicators(handle, v, many),
                17 => fmi3GetNominalsOfContinuousStates(handle, v, many),
                18 => fmi3GetFloat64(handle, r, count, v, count),
                19 => fmi3SetFloat64(handle, r, count, v, count),
                20 => {
                    let mut numbers = [self.rng.i32(..); 5];
                    fmi3SetInt32(handle, r, 1, numbers.as_ptr(), 1);
                    fmi3GetInt32(handle, r, count, numbers.as_mut_ptr(), count)
                }
                21 => {
                    let seed = [x; 5];
                    let (of, by) = (r, references[2..].as_ptr());
                    fmi3GetDirectionalDerivative(handle, of, 2, by, 3, seed.as_ptr(), 3, v, 2)
                }
                22 => {
                    let seed = [x; 5];
                    let (of, by) = (r, references[2..].as_ptr());
                    fmi3GetAdjointDerivative(handle, of, 2, by, 3, seed.as_ptr(), 2, v, 3)
                }
                23..26 => {
                    fmi3GetFloat64(handle, [0].as_ptr(), 1, v, 1);
                    let from = if self.rng.u32(..8) == 0 { x } else { values[0] };
                    let size = if self.rng.u32(..8) == 0 { y.min(1.0) } else { 0.01 };
                    let at = (&raw mut a, &raw mut b, &raw mut c, &raw mut time);
                    fmi3DoStep(handle, from, size, p, at.0, at.1, at.2, at.3)
                }
                26 => {
                    let orders = [1, 1, 1, 1, i32::from(p)];
                    fmi3GetOutputDerivatives(handle, r, count.min(5), orders.as_ptr(), v, count)
                }
                27 => {
                    let mut state = if p == 0 { ptr::null_mut() } else { self.state() };
                    let status = fmi3GetFMUState(handle, &raw mut state);
                    self.states.push(state);
                    status
                }
                28 => fmi3SetFMUState(handle, self.state()),
                29 => {
                    let mut state = self.state();
                    fmi3FreeFMUState(handle, &raw mut state)
                }
                30 => {
                    let state = self.state();
                    let status = fmi3SerializedFMUStateSize(handle, state, &raw mut size);
                    self.bytes.resize(size, 0);
                    fmi3SerializeFMUState(handle, state, self.bytes.as_mut_ptr(), size);
                    status
                }
                31 => {
                    let mut state = ptr::null_mut();
                    if !self.bytes.is_empty() && q == 0 {
                        let at = self.rng.usize(..self.bytes.len());
                        self.bytes[at] = self.rng.u8(..);
                    }
                    let at = (self.bytes.as_ptr(), self.bytes.len());
                    let status = fmi3DeserializeFMUState(handle, at.0, at.1, &raw mut state);
                    self.states.push(state);
                    status
                }
                32 => fmi3Reset(handle),
                _ if self.rng.u32(..10) == 0 => fmi3Terminate(handle),
                _ => fmi3SetDebugLogging(handle, p, 0, ptr::null()),
            }
        }
    }
}

/// Sequences after which an instance is created anew. It is reset before each sequence, because
/// creating one compiles its model, which takes as long as thousands of calls.
const AGAIN: usize = 3000;

/// Random sequences of calls, as many as `MACHINIST_FUZZ` says.
#[test]
fn any_sequence_of_calls_is_answered() {
    let count = |name: &str, otherwise: usize| {
        std::env::var(name).map_or(otherwise, |text| text.parse().expect("a number"))
    };
    let (sequences, seed) = (count("MACHINIST_FUZZ", 180), count("MACHINIST_FUZZ_SEED", 1));
    let archives = ["stick_slip", "saw_gin", "winder_holder_drop"].map(|s| Archive::of(s, &[]));
    let (mut answered, mut done) = (0, 0);
    let mut units_of: [Vec<Unit>; 3] = Default::default();
    for sequence in 0..sequences {
        if sequence % AGAIN == 0 {
            let drives = [Drive::Exchange, Drive::Simulation, Drive::Events];
            units_of = std::array::from_fn(|index| {
                let unit = |drive: &Drive| Unit::new(&archives[index], *drive);
                drives.iter().map(|drive| unit(drive).expect("an instance")).collect()
            });
        }
        let units = &units_of[sequence % archives.len()];
        for unit in units {
            ok!(unit, fmi3Reset(unit.handle));
        }
        let mut chaos = Chaos {
            rng: Rng::with_seed((seed * 1_000_003 + sequence) as u64),
            handles: units.iter().map(|unit| unit.handle).collect(),
            states: Vec::new(),
            bytes: Vec::new(),
            calls: 0,
        };
        for _ in 0..60 {
            done += usize::from(chaos.call() == Status::Ok);
        }
        answered += chaos.calls;
        for unit in units {
            let log = unit.log().concat();
            assert!(!log.contains("failed within"), "sequence {sequence}: {log}");
        }
    }
    // A part of the calls must succeed.
    assert!(done > answered / 20, "{done} of {answered}");
    println!("{answered} calls, {done} of them done");
}

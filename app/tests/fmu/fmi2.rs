//! Functions of FMI 2.0: the same instances as by FMI 3.0.

use std::ffi::{CString, c_void};
use std::fs;
use std::ptr;

use machinist_fmu::abi::*;

use super::host::{Archive, Unit, number, ok};

/// Instance by FMI 2.0.
struct Unit2 {
    handle: Handle,
}

/// Archive by FMI 2.0, with the location of its resources.
struct Archive2 {
    archive: Archive,
    location: String,
}

impl Archive2 {
    fn of(scene: &str, options: &[&str]) -> Self {
        let archive = Archive::of(scene, &[options, &["--fmi", "2"]].concat());
        let location = format!("file://{}", archive.folder.path().join("resources").display());
        Self { archive, location }
    }

    fn token(&self) -> String {
        super::host::attributes(self.archive.root())["guid"].clone()
    }

    /// Returns names, value references and attributes of the variables, by their index.
    fn variables(&self) -> Vec<(String, u32)> {
        let variables = self.archive.elements("ScalarVariable").into_iter();
        variables.map(|v| (v["name"].clone(), number(&v, "valueReference"))).collect()
    }

    fn reference(&self, name: &str) -> u32 {
        let variables = self.variables();
        let found = variables.iter().find(|(known, _)| known == name);
        found.unwrap_or_else(|| panic!("no variable {name}")).1
    }

    fn unit(&self, kind: i32) -> Unit2 {
        Unit2::instantiated(&self.token(), &self.location, kind).expect("an instance")
    }

    /// Returns an instance of the same machine by FMI 3.0.
    fn unit_by_3(&self, drive: super::host::Drive) -> Unit {
        Unit::instantiated(&self.token(), &self.archive.resources(), drive).expect("an instance")
    }
}

impl Unit2 {
    fn instantiated(token: &str, location: &str, kind: i32) -> Option<Self> {
        let functions = CallbackFunctions {
            logger: None,
            allocate_memory: None,
            free_memory: None,
            step_finished: None,
            environment: ptr::null_mut::<c_void>(),
        };
        let [token, location] = [token, location].map(|text| CString::new(text).expect("text"));
        let (token, location) = (token.as_ptr(), location.as_ptr());
        let name = c"unit".as_ptr();
        let handle =
            unsafe { fmi2Instantiate(name, kind, token, location, &raw const functions, 0, 1) };
        (!handle.is_null()).then_some(Self { handle })
    }

    fn begin(&self, until: f64) {
        let status = unsafe {
            [
                fmi2SetupExperiment(self.handle, 1, 1e-9, 0.0, 1, until),
                fmi2EnterInitializationMode(self.handle),
                fmi2ExitInitializationMode(self.handle),
            ]
        };
        assert_eq!(status, [Status::Ok; 3]);
    }

    fn get(&self, references: &[u32]) -> Vec<f64> {
        let mut values = vec![f64::NAN; references.len()];
        let (at, count) = (references.as_ptr(), references.len());
        let status = unsafe { fmi2GetReal(self.handle, at, count, values.as_mut_ptr()) };
        assert_eq!(status, Status::Ok);
        values
    }
}

impl Drop for Unit2 {
    fn drop(&mut self) {
        unsafe { fmi2FreeInstance(self.handle) };
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

#[test]
fn co_simulation_by_fmi2_has_the_bits_of_that_by_fmi3() {
    for scene in ["stick_slip", "winder_holder_drop"] {
        let archive = Archive2::of(scene, &[]);
        let unit = archive.unit(CO_SIMULATION);
        unit.begin(1.0);
        let other = archive.unit_by_3(super::host::Drive::Simulation);
        other.begin(1.0);
        let variables = archive.archive.elements("ScalarVariable").into_iter();
        let outputs = variables.filter(|v| v["causality"] == "output");
        let modes = |reference: &u32| archive.is_mode(*reference);
        let outputs = outputs.map(|v| number(&v, "valueReference"));
        let outputs: Vec<u32> = outputs.filter(|reference| !modes(reference)).collect();
        assert!(!outputs.is_empty());
        for index in 0..20 {
            let from = f64::from(index) * 0.05;
            assert_eq!(unsafe { fmi2DoStep(unit.handle, from, 0.05, 1) }, Status::Ok);
            other.step(from, 0.05);
            assert_eq!(bits(&unit.get(&outputs)), bits(&other.get(&outputs)), "{scene} at {from}");
        }
        let mut time = f64::NAN;
        let status = unsafe { fmi2GetRealStatus(unit.handle, LAST_SUCCESSFUL_TIME, &raw mut time) };
        assert_eq!((status, time.to_bits()), (Status::Ok, 1.0_f64.to_bits()));
        assert_eq!(unsafe { fmi2CancelStep(unit.handle) }, Status::Error);
    }
}

impl Archive2 {
    /// Returns whether a variable is an integer: its element follows that of the variable.
    fn is_mode(&self, reference: u32) -> bool {
        let mut lines = self.archive.description.lines().map(str::trim);
        let begin = format!("valueReference=\"{reference}\" ");
        lines.find(|line| line.starts_with("<ScalarVariable") && line.contains(&begin));
        lines.next().expect("a type").starts_with("<Integer")
    }
}

#[test]
fn model_exchange_by_fmi2_has_events_indicators_and_derivatives() {
    let archive = Archive2::of("stick_slip", &[]);
    let root = super::host::attributes(archive.archive.root());
    let indicators: usize = root["numberOfEventIndicators"].parse().expect("a number");
    let unit = archive.unit(MODEL_EXCHANGE);
    unit.begin(1.0);
    let other = archive.unit_by_3(super::host::Drive::Exchange);
    other.begin(1.0);
    let mut info = EventInfo { next_event_time: f64::NAN, ..EventInfo::default() };
    assert_eq!(unsafe { fmi2NewDiscreteStates(unit.handle, &raw mut info) }, Status::Ok);
    assert_eq!(info, EventInfo::default());
    other.update();
    assert_eq!(unsafe { fmi2SetTime(unit.handle, 0.0) }, Status::Ok);
    assert_eq!(unsafe { fmi2SetTime(unit.handle, 0.1) }, Status::Error);
    assert_eq!(unsafe { fmi2EnterContinuousTimeMode(unit.handle) }, Status::Ok);
    ok!(other, fmi3EnterContinuousTimeMode(other.handle));
    // The spring is stretched further than friction holds.
    let state = [0.3, 0.0];
    assert_eq!(unsafe { fmi2SetContinuousStates(unit.handle, state.as_ptr(), 2) }, Status::Ok);
    ok!(other, fmi3SetContinuousStates(other.handle, state.as_ptr(), 2));
    let mut found = [vec![f64::NAN; indicators], vec![f64::NAN; indicators]];
    let [first, second] = &mut found;
    assert_eq!(
        unsafe { fmi2GetEventIndicators(unit.handle, first.as_mut_ptr(), indicators) },
        Status::Ok
    );
    ok!(other, fmi3GetEventIndicators(other.handle, second.as_mut_ptr(), indicators));
    assert_eq!(bits(&found[0]), bits(&found[1]));
    let (mut asks, mut ends) = (0, 9);
    let status =
        unsafe { fmi2CompletedIntegratorStep(unit.handle, 1, &raw mut asks, &raw mut ends) };
    assert_eq!((status, asks, ends), (Status::Ok, 1, 0));
    assert_eq!(unsafe { fmi2EnterEventMode(unit.handle) }, Status::Ok);
    let slip = archive.reference("slider.slip");
    let mode = || {
        let mut mode = i32::MIN;
        let status = unsafe { fmi2GetInteger(unit.handle, &raw const slip, 1, &raw mut mode) };
        assert_eq!(status, Status::Ok);
        mode
    };
    let before = mode();
    assert_eq!(unsafe { fmi2NewDiscreteStates(unit.handle, &raw mut info) }, Status::Ok);
    assert_eq!((before, mode()), (0, -1));
}

#[test]
fn directional_derivatives_by_fmi2_agree_with_differences() {
    let archive = Archive2::of("two_mass", &["--inputs", "drive_torque"]);
    let unit = archive.unit(MODEL_EXCHANGE);
    unit.begin(1.0);
    let [known, unknown] =
        ["drive_torque", "der(driver.omega)"].map(|name| archive.reference(name));
    let (seed, mut exact) = (1.0, f64::NAN);
    let status = unsafe {
        let (unknown, known) = (&raw const unknown, &raw const known);
        fmi2GetDirectionalDerivative(
            unit.handle,
            unknown,
            1,
            known,
            1,
            &raw const seed,
            &raw mut exact,
        )
    };
    assert_eq!(status, Status::Ok);
    let at = |value: f64| {
        let status = unsafe { fmi2SetReal(unit.handle, &raw const known, 1, &raw const value) };
        assert_eq!(status, Status::Ok);
        unit.get(&[unknown])[0]
    };
    // The rate is linear in the torque.
    let difference = (at(1100.0) - at(900.0)) / 200.0;
    assert!(
        exact != 0.0 && (exact - difference).abs() < 1e-9 * exact.abs(),
        "{exact} {difference}"
    );
}

#[test]
fn states_by_fmi2_are_written_and_restored() {
    let archive = Archive2::of("bouncing_mass", &[]);
    let unit = archive.unit(CO_SIMULATION);
    unit.begin(1.0);
    let height = archive.reference("height");
    let step = |from: f64| assert_eq!(unsafe { fmi2DoStep(unit.handle, from, 0.1, 0) }, Status::Ok);
    step(0.0);
    let (mut state, mut size) = (ptr::null_mut(), 0);
    let mut bytes = Vec::new();
    unsafe {
        assert_eq!(fmi2GetFMUstate(unit.handle, &raw mut state), Status::Ok);
        assert_eq!(fmi2SerializedFMUstateSize(unit.handle, state, &raw mut size), Status::Ok);
        bytes.resize(size, 0_i8 as std::ffi::c_char);
        let at = bytes.as_mut_ptr();
        assert_eq!(fmi2SerializeFMUstate(unit.handle, state, at, size), Status::Ok);
        assert_eq!(fmi2FreeFMUstate(unit.handle, &raw mut state), Status::Ok);
    }
    step(0.1);
    let later = unit.get(&[height]);
    unsafe {
        let at = bytes.as_ptr();
        assert_eq!(fmi2DeSerializeFMUstate(unit.handle, at, size, &raw mut state), Status::Ok);
        assert_eq!(fmi2SetFMUstate(unit.handle, state), Status::Ok);
        assert_eq!(fmi2FreeFMUstate(unit.handle, &raw mut state), Status::Ok);
    }
    step(0.1);
    assert_eq!(bits(&unit.get(&[height])), bits(&later));
}

#[test]
fn the_resource_location_is_a_uri() {
    let archive = Archive2::of("bouncing_mass", &[]);
    let folder = archive.archive.folder.path().join("a folder, 100 %");
    fs::rename(archive.archive.folder.path().join("resources"), &folder).expect("renamed");
    let token = archive.token();
    let base = archive.archive.folder.path().display().to_string();
    let path = format!("{base}/a%20folder,%20100%20%25");
    for location in
        [format!("file://{path}"), format!("file:{path}"), format!("FILE://localhost{path}/")]
    {
        assert!(Unit2::instantiated(&token, &location, CO_SIMULATION).is_some(), "{location}");
    }
    let wrong = [path.clone(), format!("http://{path}"), format!("file://{path}%2"), String::new()];
    for location in wrong.into_iter().chain([format!("file://{path}%ff"), "file:é".to_owned()]) {
        assert!(Unit2::instantiated(&token, &location, CO_SIMULATION).is_none(), "{location}");
    }
    assert!(Unit2::instantiated(&token, &format!("file://{path}"), 7).is_none());
    assert!(Unit2::instantiated("{other}", &format!("file://{path}"), 0).is_none());
}

#[test]
fn null_pointers_and_freed_instances_are_refused_by_fmi2() {
    let archive = Archive2::of("bouncing_mass", &[]);
    let unit = archive.unit(CO_SIMULATION);
    unit.begin(1.0);
    let (reference, null) = (archive.reference("height"), ptr::null_mut::<f64>());
    let mut value = 0.0;
    unsafe {
        let (handle, at) = (unit.handle, &raw const reference);
        assert_eq!(fmi2GetReal(handle, at, 1, null), Status::Error);
        assert_eq!(fmi2GetReal(handle, ptr::null(), 1, &raw mut value), Status::Error);
        assert_eq!(fmi2GetReal(handle, ptr::null(), 0, null), Status::Ok);
        assert_eq!(fmi2GetBoolean(handle, at, 1, ptr::null_mut()), Status::Error);
        assert_eq!(fmi2GetFMUstate(handle, ptr::null_mut()), Status::Error);
        assert_eq!(fmi2DoStep(handle, 0.0, f64::NAN, 1), Status::Error);
        assert_eq!(fmi2DoStep(handle, 0.5, 0.1, 1), Status::Error);
        assert_eq!(fmi2DoStep(ptr::null_mut(), 0.0, 0.1, 1), Status::Error);
        assert!(
            fmi2Instantiate(ptr::null(), 0, ptr::null(), ptr::null(), ptr::null(), 0, 0).is_null()
        );
        let token = CString::new(archive.token()).expect("text");
        let functions = ptr::null();
        assert!(
            fmi2Instantiate(ptr::null(), 0, token.as_ptr(), ptr::null(), functions, 0, 0).is_null()
        );
    }
    let handle = unit.handle;
    drop(unit);
    assert_eq!(unsafe { fmi2DoStep(handle, 0.0, 0.1, 1) }, Status::Error);
}

#[test]
fn descriptions_by_fmi2_refer_to_variables_by_their_index() {
    let archive = Archive2::of("winder_holder_drop", &[]);
    let variables = archive.variables();
    assert!(!variables.iter().any(|(name, _)| name.contains(".guard")));
    assert!(archive.archive.root().contains("fmiVersion=\"2.0\""));
    let lines: Vec<&str> = archive.archive.description.lines().map(str::trim).collect();
    let mut derivatives = 0;
    for (index, (name, _)) in variables.iter().enumerate() {
        let Some(state) = name.strip_prefix("der(").and_then(|name| name.strip_suffix(')')) else {
            continue;
        };
        let begin = format!("<ScalarVariable name=\"{name}\"");
        let at = lines.iter().position(|line| line.starts_with(&begin)).expect("a variable");
        let real = super::host::attributes(lines[at + 1]);
        let of = number(&real, "derivative") as usize;
        assert_eq!(variables[of - 1].0, state, "variable {}", index + 1);
        derivatives += 1;
    }
    assert!(derivatives > 0);
    let list = |name: &str| {
        let begin = lines.iter().position(|line| *line == format!("<{name}>")).expect("a list");
        let unknowns = lines[begin + 1..].iter().take_while(|line| line.starts_with("<Unknown"));
        unknowns.map(|line| number(&super::host::attributes(line), "index")).collect::<Vec<_>>()
    };
    assert_eq!(list("Derivatives").len(), derivatives);
    for name in ["Outputs", "Derivatives", "InitialUnknowns"] {
        assert!(list(name).is_sorted(), "{name}");
    }
}

//! Archives: their files, their descriptions, and refusals.

use std::ffi::{CString, c_char, c_int, c_void};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use super::host::{Archive, attributes, hollow_library, number, unpacked};
use crate::process::{REPOSITORY, answer, assert_refused, machinist};

/// Returns the library that was built with the tests.
pub fn library() -> PathBuf {
    let folder = Path::new(env!("CARGO_BIN_EXE_machinist")).parent().expect("a folder");
    let name =
        format!("{}machinist_fmu{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let places = [folder.join(&name), folder.join("deps").join(&name)];
    let changed = |path: &PathBuf| fs::metadata(path).and_then(|file| file.modified()).ok();
    let found = places.into_iter().filter(|place| place.is_file()).max_by_key(changed);
    found.expect("a library")
}

#[test]
fn an_archive_holds_a_description_a_library_and_a_model_and_is_always_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let library = hollow_library(folder.path());
    let made = |name: &str| {
        let out = folder.path().join(name);
        let [library, path] = [&library, &out].map(|path| path.to_str().expect("a plain path"));
        answer(machinist(REPOSITORY, &["fmu", "saw_gin", "-o", path, "--library", library]));
        fs::read(out).expect("an archive")
    };
    let archive = made("one.fmu");
    assert!(archive == made("two.fmu"));
    let files = unpacked(&archive);
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names[0], "modelDescription.xml");
    assert!(names[1].starts_with("binaries/") && names[1].contains("/saw_gin."), "{names:?}");
    let others = [
        "resources/machine.model",
        "resources/machine.export",
        "terminalsAndIcons/terminalsAndIcons.xml",
    ];
    assert_eq!(names[2..], others);
    let model = folder.path().join("saw_gin.model");
    let out = model.to_str().expect("a plain path");
    answer(machinist(REPOSITORY, &["compile", "saw_gin", "--out", out]));
    assert!(files[2].1 == fs::read(&model).expect("a model"), "it is the model of `compile`");
    // The model file gives the same archive.
    let from_model = folder.path().join("three.fmu");
    let [library, path] = [&library, &from_model].map(|path| path.to_str().expect("a plain path"));
    answer(machinist(REPOSITORY, &["fmu", out, "-o", path, "--library", library]));
    assert!(archive == fs::read(&from_model).expect("an archive"));
}

/// Returns the lines of a scene's file of terminals.
fn terminals(scene: &str, more: &[&str]) -> Vec<String> {
    let folder = tempfile::tempdir().expect("a folder");
    let library = hollow_library(folder.path());
    let out = folder.path().join("made.fmu");
    let [library, path] = [&library, &out].map(|path| path.to_str().expect("a plain path"));
    let command = [&["fmu", scene, "-o", path, "--library", library], more].concat();
    answer(machinist(REPOSITORY, &command));
    let files = unpacked(&fs::read(&out).expect("an archive"));
    let name = "terminalsAndIcons/terminalsAndIcons.xml";
    let Some((_, bytes)) = files.iter().find(|(found, _)| found == name) else { return vec![] };
    let text = String::from_utf8(bytes.clone()).expect("text");
    text.lines().map(|line| line.trim().to_owned()).collect()
}

#[test]
fn ports_are_terminals_of_their_outputs_and_of_inputs_that_are_forces_on_them() {
    let member = |variable: &str, member: &str, kind: &str| {
        format!(
            "<TerminalMemberVariable variableName=\"{variable}\" memberName=\"{member}\" \
             variableKind=\"{kind}\"/>"
        )
    };
    let inputs = ["--inputs", "drive_torque,load_torque,load_amplitude"];
    let lines = terminals("two_mass", &inputs);
    let begins = |line: &String| line.starts_with("<Terminal name=");
    let starts: Vec<usize> = (0..lines.len()).filter(|at| begins(&lines[*at])).collect();
    let [driver, cylinder] = starts[..] else { panic!("two terminals: {lines:?}") };
    assert!(lines[driver].contains("name=\"driver\" matchingRule=\"bus\""), "{}", lines[driver]);
    assert!(lines[driver].contains("terminalKind=\"_machinist_rotational\""));
    let of_driver =
        [member("driver_speed", "w", "signal"), member("drive_torque", "tau", "inflow")];
    assert_eq!(lines[driver + 1..driver + 3], of_driver);
    // The load acts against the motion. The effect of its amplitude changes with time.
    let of_cylinder =
        [member("cylinder_speed", "w", "signal"), member("load_torque", "tau", "outflow")];
    assert_eq!(lines[cylinder + 1..cylinder + 3], of_cylinder);
    assert_eq!(lines[cylinder + 3], "</Terminal>");
    let without = terminals("two_mass", &[]);
    assert!(!without.iter().any(|line| line.contains("tau")), "{without:?}");
    // A sliding part, and a machine without a port as output.
    let sliding = terminals("bouncing_mass", &[]);
    assert!(sliding.iter().any(|line| line.contains("_machinist_translational")), "{sliding:?}");
}

#[test]
fn the_description_has_units_types_starts_and_causality() {
    let archive = Archive::of("saw_gin", &["--inputs", "load.mean"]);
    let root = attributes(archive.root());
    assert_eq!(root["fmiVersion"], "3.0");
    assert_eq!(root["modelName"], "saw_gin");
    for interface in ["ModelExchange", "CoSimulation"] {
        let elements = archive.elements(interface);
        let [element] = &elements[..] else { panic!("one {interface}") };
        assert_eq!(element["modelIdentifier"], "saw_gin");
        for can in
            ["canGetAndSetFMUState", "canSerializeFMUState", "providesDirectionalDerivatives"]
        {
            assert_eq!(element[can], "true", "{can}");
        }
    }
    let variables = archive.variables();
    let of = |name: &str, attribute: &str| variables[name].get(attribute).map(String::as_str);
    assert_eq!(of("time", "causality"), Some("independent"));
    assert_eq!(of("motor.inertia", "causality"), Some("parameter"));
    assert_eq!(of("motor.inertia", "variability"), Some("tunable"));
    assert_eq!(of("motor.inertia", "start"), Some("4.2"));
    assert_eq!(of("load.mean", "causality"), Some("input"));
    assert_eq!(of("twist", "causality"), Some("output"));
    assert_eq!(of("twist", "declaredType"), Some("Types.Angle"));
    assert_eq!(of("motor.omega", "nominal"), Some("78.5"));
    let omega = of("motor.omega", "valueReference");
    assert_eq!(of("der(motor.omega)", "derivative"), omega);
    assert_eq!(of("der(motor.omega)", "unit"), Some("rad/s^2"));
    // Units by their exponents: N m/rad is kg m^2 s^-2 rad^-1.
    let lines: Vec<&str> = archive.description.lines().map(str::trim).collect();
    let unit = lines.iter().position(|line| *line == "<Unit name=\"N m/rad\">").expect("a unit");
    assert_eq!(lines[unit + 1], "<BaseUnit kg=\"1\" m=\"2\" s=\"-2\" rad=\"-1\"/>");
    let units = archive.elements("Unit");
    for variable in variables.values() {
        if let Some(unit) = variable.get("unit") {
            assert!(units.iter().any(|defined| defined["name"] == *unit), "{unit}");
        }
    }
    let references: Vec<u32> = variables.values().map(|v| number(v, "valueReference")).collect();
    let mut sorted = references.clone();
    sorted.sort_unstable();
    assert!(sorted.iter().zip(0..).all(|(found, expected)| *found == expected));
    // Every start tag has an end tag.
    let begun = lines.iter().filter(|l| l.starts_with('<') && !l.starts_with("</")).count();
    let alone = lines.iter().filter(|line| line.ends_with("/>")).count();
    let ended = lines.iter().filter(|line| line.starts_with("</")).count();
    assert_eq!(begun - 1, alone + ended);
}

#[test]
fn modes_events_constraints_and_fixed_parameters_are_described() {
    let archive = Archive::of("stick_slip", &[]);
    let variables = archive.variables();
    let modes = archive.elements("Int32");
    assert!(!modes.is_empty());
    assert!(modes.iter().all(|m| m["variability"] == "discrete" && m.contains_key("start")));
    assert!(!archive.elements("EventIndicator").is_empty());
    assert!(variables.keys().any(|name| name.contains(".guard")));
    let archive = Archive::of("winder_holder_drop", &[]);
    let variables = archive.variables();
    let fixed: Vec<&String> = variables
        .iter()
        .filter(|(_, variable)| variable["variability"] == "fixed")
        .map(|(name, _)| name)
        .collect();
    // Lengths of links occur in constraints.
    assert!(!fixed.is_empty());
    assert!(
        variables.values().any(|variable| variable.get("initial").is_some_and(|i| i == "approx"))
    );
    assert_eq!(archive.elements("ModelExchange")[0]["needsCompletedIntegratorStep"], "true");
}

#[test]
fn a_name_that_xml_has_signs_for_is_written_so_that_it_is_read_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let spec = r#"
[scene]
name = "signs"
title = "a < b & \"c\" > d"
[units]
mass = { unit = "translational/mass" }
[run]
until = 1.0
points = 11
rtol = 1e-8
method = "auto"
"#;
    let path = folder.path().join("signs.toml");
    fs::write(&path, spec).expect("written");
    let archive = Archive::of(path.to_str().expect("a plain path"), &[]);
    assert!(archive.root().contains("a &lt; b &amp; &quot;c&quot; &gt; d"));
    // Without outputs, all states are outputs themselves.
    assert_eq!(archive.variables()["mass.v"]["causality"], "output");
    let unit = archive.simulation();
    unit.begin(1.0);
    unit.step(0.0, 0.5);
}

#[test]
fn what_cannot_be_exported_is_refused_with_a_reason() {
    let folder = tempfile::tempdir().expect("a folder");
    let library = hollow_library(folder.path());
    let library = library.to_str().expect("a plain path");
    let refused = |arguments: &[&str], words: &[&str]| {
        let mut all = vec!["fmu"];
        all.extend(arguments);
        assert_refused(machinist(folder.path(), &all), words);
        assert!(!folder.path().join("x.fmu").exists());
    };
    let with = |options: &[&str], words: &[&str]| {
        let mut all = vec!["saw_gin", "-o", "x.fmu", "--library", library];
        all.extend(options);
        refused(&all, words);
    };
    with(&["--inputs", "load.maen"], &["load.maen", "did you mean `load.mean`"]);
    with(&["--inputs", "motor.inertia"], &["motor.inertia", "kinetic energy"]);
    with(&["--inputs", "load.mean,load.mean"], &["given twice"]);
    refused(&["saw_gin", "-o", "x.zip", "--library", library], &[".fmu"]);
    with(&["--elements", "4"], &["has no fields", "leave `--elements`"]);
    let with_fields = |options: &[&str], words: &[&str]| {
        let mut all = vec!["shaft_with_rotors", "-o", "x.fmu", "--library", library];
        all.extend(options);
        refused(&all, words);
    };
    with_fields(&["--elements", "0"], &["at least"]);
    with_fields(&["--inputs", "shaft.stiffness"], &["shaft.stiffness", "a field depends on it"]);
    fs::write(folder.path().join("text.so"), "no library").expect("written");
    refused(
        &["saw_gin", "-o", "x.fmu", "--library", "text.so"],
        &["not a shared library", "cargo build"],
    );
    let missing =
        machinist(folder.path(), &["fmu", "saw_gin", "-o", "x.fmu", "--library", "no.so"]);
    assert_eq!(crate::process::output(missing).status.code(), Some(1));
    refused(&["no_such_scene", "-o", "x.fmu", "--library", library], &["no_such_scene"]);
}

#[cfg(target_os = "linux")]
unsafe extern "C" {
    fn dlopen(file: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// The library exports every function of the standard by name.
#[cfg(target_os = "linux")]
#[test]
fn the_library_offers_every_function_of_the_standard() {
    const FUNCTIONS: &str = "GetVersion SetDebugLogging InstantiateModelExchange \
        InstantiateCoSimulation InstantiateScheduledExecution FreeInstance \
        EnterInitializationMode ExitInitializationMode EnterEventMode Terminate Reset GetFloat32 \
        GetFloat64 GetInt8 GetUInt8 GetInt16 GetUInt16 GetInt32 GetUInt32 GetInt64 GetUInt64 \
        GetBoolean GetString GetBinary GetClock SetFloat32 SetFloat64 SetInt8 SetUInt8 SetInt16 \
        SetUInt16 SetInt32 SetUInt32 SetInt64 SetUInt64 SetBoolean SetString SetBinary SetClock \
        GetNumberOfVariableDependencies GetVariableDependencies GetFMUState SetFMUState \
        FreeFMUState SerializedFMUStateSize SerializeFMUState DeserializeFMUState \
        GetDirectionalDerivative GetAdjointDerivative EnterConfigurationMode \
        ExitConfigurationMode GetIntervalDecimal GetIntervalFraction GetShiftDecimal \
        GetShiftFraction SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction \
        EvaluateDiscreteStates UpdateDiscreteStates EnterContinuousTimeMode \
        CompletedIntegratorStep SetTime SetContinuousStates GetContinuousStateDerivatives \
        GetEventIndicators GetContinuousStates GetNominalsOfContinuousStates \
        GetNumberOfEventIndicators GetNumberOfContinuousStates EnterStepMode \
        GetOutputDerivatives DoStep ActivateModelPartition";
    const FUNCTIONS2: &str = "GetTypesPlatform GetVersion SetDebugLogging Instantiate FreeInstance \
        SetupExperiment EnterInitializationMode ExitInitializationMode Terminate Reset GetReal \
        GetInteger GetBoolean GetString SetReal SetInteger SetBoolean SetString GetFMUstate \
        SetFMUstate FreeFMUstate SerializedFMUstateSize SerializeFMUstate DeSerializeFMUstate \
        GetDirectionalDerivative EnterEventMode NewDiscreteStates EnterContinuousTimeMode \
        CompletedIntegratorStep SetTime SetContinuousStates GetDerivatives GetEventIndicators \
        GetContinuousStates GetNominalsOfContinuousStates SetRealInputDerivatives \
        GetRealOutputDerivatives DoStep CancelStep GetStatus GetRealStatus GetIntegerStatus \
        GetBooleanStatus GetStringStatus";
    const NOW: c_int = 2;
    let path = CString::new(library().to_str().expect("a plain path")).expect("a path");
    let library = unsafe { dlopen(path.as_ptr(), NOW) };
    assert!(!library.is_null());
    for (version, functions) in [("fmi3", FUNCTIONS), ("fmi2", FUNCTIONS2)] {
        for name in functions.split_whitespace() {
            let symbol = CString::new(format!("{version}{name}")).expect("a name");
            assert!(!unsafe { dlsym(library, symbol.as_ptr()) }.is_null(), "{version}{name}");
        }
    }
    let version = CString::new("fmi3GetVersion").expect("a name");
    let version = unsafe { dlsym(library, version.as_ptr()) };
    let version: unsafe extern "C" fn() -> *const c_char = unsafe { std::mem::transmute(version) };
    let version = unsafe { std::ffi::CStr::from_ptr(version()) };
    assert_eq!(version.to_str(), Ok("3.0"));
}

#[test]
fn the_program_finds_the_library_that_is_built_with_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let started = Instant::now();
    answer(machinist(folder.path(), &["fmu", "bouncing_mass", "-o", "x.fmu"]));
    println!("made in {:?}", started.elapsed());
    let files = unpacked(&fs::read(folder.path().join("x.fmu")).expect("an archive"));
    assert!(files[1].1 == fs::read(library()).expect("a library"));
}

//! Host that makes and unpacks archives with the program, and calls instances through the C
//! interface.

use std::collections::BTreeMap;
use std::ffi::{CStr, CString, c_char, c_void};
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::ptr;
use std::sync::{Mutex, OnceLock};

use flate2::read::DeflateDecoder;
use machinist_fmu::abi::*;

use crate::process::{REPOSITORY, answer, machinist};

/// Unpacked archive.
pub struct Archive {
    pub folder: tempfile::TempDir,
    pub description: String,
}

/// Creates a library for archives whose library is not called: the first bytes of a program, which
/// are those of a library.
pub fn hollow_library(folder: &Path) -> PathBuf {
    let program = std::env::current_exe().expect("this program");
    let bytes = fs::read(program).expect("its bytes");
    let path = folder.join("hollow.so");
    fs::write(&path, &bytes[..64]).expect("written");
    path
}

impl Archive {
    /// Makes an archive of a built-in scene or a file with options. Its library is called within
    /// this process.
    pub fn of(scene: &str, options: &[&str]) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let library = hollow_library(folder.path());
        let file = folder.path().join("unit.fmu");
        let [library, out] = [&library, &file].map(|path| path.to_str().expect("a plain path"));
        let mut arguments = vec!["fmu", scene, "--out", out, "--library", library];
        arguments.extend(options);
        answer(machinist(REPOSITORY, &arguments));
        for (name, bytes) in unpacked(&fs::read(&file).expect("an archive")) {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().expect("a folder")).expect("made");
            fs::write(path, bytes).expect("written");
        }
        let description = folder.path().join("modelDescription.xml");
        let description = fs::read_to_string(description).expect("a description");
        Self { folder, description }
    }

    /// Returns the attributes of all elements with a name.
    pub fn elements(&self, name: &str) -> Vec<BTreeMap<String, String>> {
        let begin = format!("<{name} ");
        let lines = self.description.lines().map(str::trim).filter(|line| line.starts_with(&begin));
        lines.map(|line| attributes(&line[begin.len()..])).collect()
    }

    /// Returns the variables by name.
    pub fn variables(&self) -> BTreeMap<String, BTreeMap<String, String>> {
        let all = ["Float64", "Int32"].into_iter().flat_map(|name| self.elements(name));
        all.map(|variable| (variable["name"].clone(), variable)).collect()
    }

    /// Returns the value reference of a variable.
    pub fn reference(&self, name: &str) -> u32 {
        number(&self.variables()[name], "valueReference")
    }

    /// Returns names and value references of all outputs.
    pub fn outputs(&self) -> Vec<(String, u32)> {
        let variables = self.variables().into_iter();
        let outputs = variables.filter(|(_, variable)| variable["causality"] == "output");
        outputs.map(|(name, variable)| (name, number(&variable, "valueReference"))).collect()
    }

    pub fn token(&self) -> String {
        attributes(self.root())["instantiationToken"].clone()
    }

    pub fn root(&self) -> &str {
        let line = self.description.lines().find(|line| line.starts_with("<fmiModelDescription"));
        line.expect("a root")
    }

    pub fn resources(&self) -> String {
        format!("{}/", self.folder.path().join("resources").display())
    }

    pub fn exchange(&self) -> Unit {
        Unit::new(self, Drive::Exchange).expect("an instance")
    }

    pub fn simulation(&self) -> Unit {
        Unit::new(self, Drive::Simulation).expect("an instance")
    }
}

pub fn number(attributes: &BTreeMap<String, String>, name: &str) -> u32 {
    attributes[name].parse().expect("a number")
}

/// Parses the attributes of the rest of an element.
pub fn attributes(mut text: &str) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    while let Some((name, rest)) = text.split_once("=\"") {
        let (value, rest) = rest.split_once('"').expect("the end of a value");
        let name = name.rsplit(' ').next().expect("a name").to_owned();
        all.insert(name, value.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"));
        text = rest;
    }
    all
}

/// Unpacks the files of an archive by its central directory.
pub fn unpacked(archive: &[u8]) -> Vec<(String, Vec<u8>)> {
    let word = |at: usize| {
        u32::from_le_bytes(archive[at..at + 4].try_into().expect("four bytes")) as usize
    };
    let half = |at: usize| usize::from(u16::from_le_bytes([archive[at], archive[at + 1]]));
    let end = archive.len() - 22;
    assert_eq!(word(end), 0x0605_4b50, "the end of a directory");
    let mut at = word(end + 16);
    let mut files = Vec::new();
    for _ in 0..half(end + 10) {
        assert_eq!(word(at), 0x0201_4b50, "an entry of the directory");
        let (deflated, size, length) = (word(at + 20), word(at + 24), half(at + 28));
        let name = String::from_utf8(archive[at + 46..at + 46 + length].to_vec()).expect("a name");
        let local = word(at + 42);
        assert_eq!(&archive[local + 30..local + 30 + length], name.as_bytes());
        let from = local + 30 + half(local + 26) + half(local + 28);
        let mut bytes = Vec::new();
        let mut decoder = DeflateDecoder::new(&archive[from..from + deflated]);
        decoder.read_to_end(&mut bytes).expect("what was deflated");
        assert_eq!(bytes.len(), size, "{name}");
        files.push((name, bytes));
        at += 46 + length + half(at + 30) + half(at + 32);
    }
    files
}

/// Interface and options of an instance.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Drive {
    Exchange,
    Simulation,
    /// Co-Simulation with event mode and steps that may end early.
    Events,
}

/// Callback within a step, called with the time. It returns the time to return at, if any.
pub type Looks = Box<dyn FnMut(Handle, f64) -> Option<f64> + Send>;

/// Data of the callbacks.
#[derive(Default)]
struct Environment {
    log: Mutex<Vec<(Status, String)>>,
    looks: Mutex<Option<Looks>>,
    handle: OnceLock<usize>,
}

/// Instance of an FMU.
pub struct Unit {
    pub handle: Handle,
    environment: Box<Environment>,
}

// Handles are numbers.
unsafe impl Send for Unit {}

unsafe extern "C" fn log(
    environment: *mut c_void,
    status: Status,
    _category: *const c_char,
    message: *const c_char,
) {
    let environment = unsafe { &*environment.cast::<Environment>() };
    let message = unsafe { CStr::from_ptr(message) }.to_string_lossy().into_owned();
    environment.log.lock().expect("a log").push((status, message));
}

unsafe extern "C" fn update(
    environment: *mut c_void,
    time: f64,
    _: u8,
    _: u8,
    _: u8,
    may_return: u8,
    wants: *mut u8,
    end: *mut f64,
) {
    let environment = unsafe { &*environment.cast::<Environment>() };
    let handle = *environment.handle.get().expect("an instance");
    let looks = environment.looks.lock().expect("looks").take();
    if let Some(mut looks) = looks {
        let answer = looks(ptr::without_provenance_mut(handle), time);
        if let Some(at) = answer
            && may_return != 0
        {
            unsafe {
                *wants = 1;
                *end = at;
            }
        }
        *environment.looks.lock().expect("looks") = Some(looks);
    }
}

/// Asserts that a call succeeds.
macro_rules! ok {
    ($unit:expr, $call:expr) => {{
        let status = unsafe { $call };
        assert_eq!(status, Status::Ok, "{}: {:?}", stringify!($call), $unit.log());
    }};
}
pub(crate) use ok;

impl Unit {
    pub fn new(archive: &Archive, drive: Drive) -> Option<Self> {
        Self::instantiated(&archive.token(), &archive.resources(), drive).ok()
    }

    /// Instantiates an archive, or returns the log if that fails.
    pub fn instantiated(token: &str, resources: &str, drive: Drive) -> Result<Self, String> {
        let environment = Box::<Environment>::default();
        let pointer = ptr::from_ref(&*environment).cast_mut().cast::<c_void>();
        let [token, resources] = [token, resources].map(|text| CString::new(text).expect("text"));
        let (token, resources) = (token.as_ptr(), resources.as_ptr());
        let name = c"unit".as_ptr();
        let events = u8::from(drive == Drive::Events);
        let handle = unsafe {
            match drive {
                Drive::Exchange => {
                    fmi3InstantiateModelExchange(name, token, resources, 0, 1, pointer, Some(log))
                }
                Drive::Simulation | Drive::Events => fmi3InstantiateCoSimulation(
                    name,
                    token,
                    resources,
                    0,
                    1,
                    events,
                    events,
                    ptr::null(),
                    0,
                    pointer,
                    Some(log),
                    Some(update),
                ),
            }
        };
        let unit = Self { handle, environment };
        if handle.is_null() {
            return Err(unit.log().concat());
        }
        unit.environment.handle.set(handle.addr()).expect("set once");
        Ok(unit)
    }

    /// Returns the messages so far and clears the log.
    pub fn log(&self) -> Vec<String> {
        let mut log = self.environment.log.lock().expect("a log");
        log.drain(..).map(|(_, message)| message).collect()
    }

    pub fn looks_by(&self, looks: Looks) {
        *self.environment.looks.lock().expect("looks") = Some(looks);
    }

    /// Goes through initialization mode, from 0 s, with a tolerance of 1e-9.
    pub fn begin(&self, until: f64) {
        ok!(self, fmi3EnterInitializationMode(self.handle, 1, 1e-9, 0.0, 1, until));
        ok!(self, fmi3ExitInitializationMode(self.handle));
    }

    pub fn get(&self, references: &[u32]) -> Vec<f64> {
        let mut values = vec![f64::NAN; references.len()];
        let count = values.len();
        ok!(
            self,
            fmi3GetFloat64(self.handle, references.as_ptr(), count, values.as_mut_ptr(), count)
        );
        values
    }

    pub fn set(&self, reference: u32, value: f64) {
        assert_eq!(self.try_set(reference, value), Status::Ok, "{:?}", self.log());
    }

    pub fn try_set(&self, reference: u32, value: f64) -> Status {
        unsafe { fmi3SetFloat64(self.handle, &raw const reference, 1, &raw const value, 1) }
    }

    /// Takes a step. Returns whether an event needs handling, and the time reached.
    pub fn step(&self, from: f64, size: f64) -> (bool, f64) {
        let (mut event, mut early, mut time) = (0, 0, f64::NAN);
        let ignored = ptr::null_mut();
        let at = (&raw mut event, &raw mut early, &raw mut time);
        ok!(self, fmi3DoStep(self.handle, from, size, 1, at.0, ignored, at.1, at.2));
        assert_eq!(early != 0, time < from + size);
        (event != 0, time)
    }

    /// Updates discrete states. Returns whether continuous states have changed, and the time of the
    /// next event.
    pub fn update(&self) -> (bool, Option<f64>) {
        let (mut again, mut moved, mut is_next, mut next) = (9, 9, 9, f64::NAN);
        let ignored = ptr::null_mut();
        let at = (&raw mut again, &raw mut moved, &raw mut is_next, &raw mut next);
        ok!(self, fmi3UpdateDiscreteStates(self.handle, at.0, ignored, ignored, at.1, at.2, at.3));
        assert_eq!(again, 0);
        (moved != 0, (is_next != 0).then_some(next))
    }

    /// Serializes the present state.
    pub fn written(&self) -> Vec<u8> {
        let mut state: StateHandle = ptr::null_mut();
        let mut size = 0;
        ok!(self, fmi3GetFMUState(self.handle, &raw mut state));
        ok!(self, fmi3SerializedFMUStateSize(self.handle, state, &raw mut size));
        let mut bytes = vec![0; size];
        ok!(self, fmi3SerializeFMUState(self.handle, state, bytes.as_mut_ptr(), size));
        ok!(self, fmi3FreeFMUState(self.handle, &raw mut state));
        assert!(state.is_null());
        bytes
    }

    /// Deserializes and restores a state.
    pub fn read(&self, bytes: &[u8]) {
        let mut state: StateHandle = ptr::null_mut();
        let (at, size) = (bytes.as_ptr(), bytes.len());
        ok!(self, fmi3DeserializeFMUState(self.handle, at, size, &raw mut state));
        ok!(self, fmi3SetFMUState(self.handle, state));
        ok!(self, fmi3FreeFMUState(self.handle, &raw mut state));
    }
}

impl Drop for Unit {
    fn drop(&mut self) {
        unsafe { fmi3FreeInstance(self.handle) };
    }
}

/// Reference of an input, and its value over time.
pub type Input = (u32, fn(f64) -> f64);

/// Host with a method of its own: the Runge-Kutta method of order 4, with steps halved at sign
/// changes of an indicator.
pub struct Stepper<'a> {
    pub unit: &'a Unit,
    pub time: f64,
    next: Option<f64>,
    states: usize,
    indicators: usize,
    /// Number of times in event mode.
    pub events: usize,
    /// Input and its value over time.
    pub input: Option<Input>,
    /// Rate of an artificial error of the states, alternating in sign.
    pub drift: f64,
}

impl<'a> Stepper<'a> {
    /// Takes an instance after initialization.
    pub fn new(unit: &'a Unit) -> Self {
        let (mut states, mut indicators) = (0, 0);
        ok!(unit, fmi3GetNumberOfContinuousStates(unit.handle, &raw mut states));
        ok!(unit, fmi3GetNumberOfEventIndicators(unit.handle, &raw mut indicators));
        let (time, next, events, input, drift) = (0.0, None, 0, None, 0.0);
        let mut stepper = Self { unit, time, next, states, indicators, events, input, drift };
        stepper.finish_event();
        stepper
    }

    fn finish_event(&mut self) {
        self.next = self.unit.update().1;
        ok!(self.unit, fmi3EnterContinuousTimeMode(self.unit.handle));
    }

    fn handle_event(&mut self) {
        self.events += 1;
        ok!(self.unit, fmi3EnterEventMode(self.unit.handle));
        self.finish_event();
    }

    pub fn state(&self) -> Vec<f64> {
        let mut state = vec![f64::NAN; self.states];
        let at = state.as_mut_ptr();
        ok!(self.unit, fmi3GetContinuousStates(self.unit.handle, at, self.states));
        state
    }

    fn put(&self, time: f64, state: &[f64]) {
        ok!(self.unit, fmi3SetTime(self.unit.handle, time));
        if let Some((input, value)) = self.input {
            self.unit.set(input, value(time));
        }
        ok!(self.unit, fmi3SetContinuousStates(self.unit.handle, state.as_ptr(), self.states));
    }

    fn rate(&self, time: f64, state: &[f64]) -> Vec<f64> {
        self.put(time, state);
        let mut rate = vec![f64::NAN; self.states];
        let at = rate.as_mut_ptr();
        ok!(self.unit, fmi3GetContinuousStateDerivatives(self.unit.handle, at, self.states));
        rate
    }

    fn guards(&self) -> Vec<f64> {
        let mut guards = vec![f64::NAN; self.indicators];
        let at = guards.as_mut_ptr();
        ok!(self.unit, fmi3GetEventIndicators(self.unit.handle, at, self.indicators));
        guards
    }

    /// Returns the state after a trial step.
    fn tried(&self, state: &[f64], step: f64) -> Vec<f64> {
        let (time, half) = (self.time, 0.5 * step);
        let moved = |rate: &[f64], by: f64| -> Vec<f64> {
            state.iter().zip(rate).map(|(value, rate)| value + by * rate).collect()
        };
        let a = self.rate(time, state);
        let b = self.rate(time + half, &moved(&a, half));
        let c = self.rate(time + half, &moved(&b, half));
        let d = self.rate(time + step, &moved(&c, step));
        let drift = step * self.drift * (1e3 * time).sin();
        (0..self.states)
            .map(|i| state[i] + step / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]) + drift)
            .collect()
    }

    /// Advances to a time by steps of at most `longest`.
    pub fn go(&mut self, until: f64, longest: f64) {
        while self.time < until {
            let end = self.next.map_or(until, |next| next.min(until));
            let step = if self.time + 1.5 * longest < end { longest } else { end - self.time };
            let start = self.state();
            let before = self.guards();
            let mut step = step;
            let mut state = self.tried(&start, step);
            self.put(self.time + step, &state);
            let has_passed = |guards: &[f64]| {
                guards.iter().zip(&before).any(|(a, b)| a * b < 0.0 || *a == 0.0 && *b != 0.0)
            };
            let passes = has_passed(&self.guards());
            if passes {
                let (mut low, mut high) = (0.0, step);
                while high - low > 1e-14 * (self.time + high) {
                    let middle = 0.5 * (low + high);
                    state = self.tried(&start, middle);
                    self.put(self.time + middle, &state);
                    if has_passed(&self.guards()) { high = middle } else { low = middle }
                }
                step = high;
                state = self.tried(&start, step);
                self.put(self.time + step, &state);
            }
            self.time =
                if step.to_bits() == (end - self.time).to_bits() { end } else { self.time + step };
            self.put(self.time, &state);
            let mut asks = 9;
            let ignored = ptr::null_mut();
            ok!(
                self.unit,
                fmi3CompletedIntegratorStep(self.unit.handle, 1, &raw mut asks, ignored)
            );
            let jumps = self.next.is_some_and(|next| self.time >= next);
            if passes || asks != 0 || jumps {
                self.handle_event();
            }
        }
    }
}

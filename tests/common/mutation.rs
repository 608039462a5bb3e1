//! Inputs made by damaging valid ones, rules for their treatment, and the smallest input that
//! breaks a rule.
//!
//! Shared by the tests of crates that must not depend on one another: each includes this file as a
//! module. Nothing here depends on specs, models or the command line.
#![allow(dead_code, reason = "every test takes what it needs")]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use fastrand::Rng;

/// Environment variable with the number of inputs, in place of the small one of ordinary tests.
const ROUNDS: &str = "MACHINIST_FUZZ";
/// Environment variable with the first seed, in place of the usual one.
const SEED: &str = "MACHINIST_FUZZ_SEED";
/// Number of different faults after which a loop stops.
const FAULTS: usize = 12;
/// Time limit for shrinking an input.
const SHRINKING: Duration = Duration::from_secs(20);
/// Maximum growth, in bytes, of this process's peak memory due to one input.
const ROOM: u64 = 1 << 30;

/// A rule for an input: returns whether it is accepted or refused, or what is wrong.
pub type Rule = Arc<dyn Fn(&[u8]) -> Result<bool, String> + Send + Sync>;

/// A loop over inputs.
pub struct Fuzz {
    /// Name of the tested subject, with which the names of files of failing inputs begin.
    pub name: &'static str,
    /// Number of inputs of an ordinary test.
    pub few: usize,
    /// Time limit for an input; it is checked a second time, since the machine may be busy.
    pub patience: Duration,
}

impl Fuzz {
    /// Tests inputs by a rule. An input that breaks it is shrunk and written to a file.
    ///
    /// # Panics
    /// With all faults found, and how to reproduce them.
    pub fn run(&self, make: impl Fn(&mut Rng) -> Vec<u8>, rule: &Rule) {
        let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
        let rounds = number(ROUNDS).unwrap_or(self.few as u64);
        let seed = number(SEED).unwrap_or(0);
        let (start, mut tried, mut taken) = (Instant::now(), 0, 0);
        let mut faults: Vec<(String, String)> = Vec::new();
        for round in seed..seed.saturating_add(rounds) {
            let input = make(&mut Rng::with_seed(round));
            self.keep("last", &input);
            tried += 1;
            let fault = match self.attempt(&input, rule) {
                Ok(is_taken) => {
                    taken += u64::from(is_taken);
                    continue;
                }
                Err(fault) => fault,
            };
            let kind = kind_of(&fault);
            if faults.iter().any(|(known, _)| *known == kind) {
                continue;
            }
            let smallest = self.shrink(input, &kind, rule);
            let file = self.keep(&round.to_string(), &smallest);
            println!("{}: seed {round}: {fault}\n  in {}", self.name, file.display());
            faults.push((kind, format!("{SEED}={round}: {fault}, by {}", file.display())));
            if faults.len() == FAULTS {
                break;
            }
        }
        let seconds = start.elapsed().as_secs_f64();
        println!(
            "{}: {tried} inputs from seed {seed}, {taken} taken, in {seconds:.1} s",
            self.name
        );
        let told: Vec<String> = faults.into_iter().map(|(_, told)| told).collect();
        assert!(taken > 0 || tried < 50, "{}: nothing is taken", self.name);
        assert!(told.is_empty(), "{}:\n{}", self.name, told.join("\n"));
    }

    /// Writes an input to a file that outlives this process: if the process ends, for example by a
    /// stack overflow, `last` is the input.
    fn keep(&self, label: &str, input: &[u8]) -> PathBuf {
        let folder = std::env::temp_dir().join("machinist-fuzz");
        let file = folder.join(format!("{}-{label}.txt", self.name));
        std::fs::create_dir_all(&folder).and_then(|()| std::fs::write(&file, input)).expect("file");
        file
    }

    fn attempt(&self, input: &[u8], rule: &Rule) -> Result<bool, String> {
        match self.attempt_once(input, rule) {
            Err(fault) if fault.starts_with("slow") => self.attempt_once(input, rule),
            answer => answer,
        }
    }

    /// Runs on a separate thread, so that a hanging test can be left behind.
    fn attempt_once(&self, input: &[u8], rule: &Rule) -> Result<bool, String> {
        let (sender, receiver) = channel();
        let (input, rule) = (input.to_vec(), Arc::clone(rule));
        let (start, memory) = (Instant::now(), peak());
        std::thread::spawn(move || {
            let answer = catch_unwind(AssertUnwindSafe(|| rule(&input)));
            // After a timeout, no receiver is left.
            let _ = sender.send(answer.unwrap_or_else(|panic| Err(words(&*panic))));
        });
        let answer = match receiver.recv_timeout(self.patience * 10) {
            Ok(answer) => answer,
            Err(RecvTimeoutError::Timeout) => return Err("hangs".to_owned()),
            Err(RecvTimeoutError::Disconnected) => return Err("no answer".to_owned()),
        };
        let is_taken = answer?;
        if start.elapsed() > self.patience {
            return Err(format!("slow: {:.1?}", start.elapsed()));
        }
        if peak().saturating_sub(memory) > ROOM {
            return Err("takes too much memory".to_owned());
        }
        Ok(is_taken)
    }

    /// Removes lines, then pieces of lines, as long as the fault stays the same.
    fn shrink(&self, input: Vec<u8>, kind: &str, rule: &Rule) -> Vec<u8> {
        let fails =
            |input: &[u8]| self.attempt(input, rule).is_err_and(|fault| kind_of(&fault) == kind);
        let start = Instant::now();
        let mut input = input;
        for cut in [lines as fn(&[u8]) -> Vec<Vec<u8>>, tokens] {
            let mut parts = cut(&input);
            let mut size = parts.len().div_ceil(2).max(1);
            loop {
                let mut at = 0;
                while at < parts.len() && start.elapsed() < SHRINKING {
                    let mut fewer = parts.clone();
                    fewer.drain(at..(at + size).min(parts.len()));
                    if fails(&fewer.concat()) { parts = fewer } else { at += size }
                }
                if size == 1 {
                    break;
                }
                size = size.div_ceil(2);
            }
            input = parts.concat();
        }
        input
    }
}

/// Returns a fault without its numbers, so that equal ones are reported once.
fn kind_of(fault: &str) -> String {
    fault.chars().filter(|c| !c.is_ascii_digit()).take(80).collect()
}

fn words(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    let text = text.or_else(|| panic.downcast_ref::<&str>().copied());
    format!("panics: {}", text.unwrap_or("without words"))
}

/// Returns the peak memory of this process, where the system reports it.
fn peak() -> u64 {
    static LOCK: Mutex<()> = Mutex::new(());
    let _alone = LOCK.lock();
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok());
    kilobytes.unwrap_or(0) << 10
}

fn lines(input: &[u8]) -> Vec<Vec<u8>> {
    input.split_inclusive(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect()
}

/// Returns words and numbers as wholes, everything else byte by byte.
pub fn tokens(input: &[u8]) -> Vec<Vec<u8>> {
    let is_word = |byte: &u8| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'.');
    input.chunk_by(|a, b| is_word(a) && is_word(b)).map(<[u8]>::to_vec).collect()
}

/// Numbers at and beyond the limits of their types.
pub const EXTREMES: &[&str] = &[
    "0",
    "-0.0",
    "-1",
    "1",
    "1e308",
    "-1e308",
    "1e-308",
    "1e-320",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "1e-999",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551616",
    "4294967296",
    "2147483648",
    "0.1",
    "1e16",
    "1e-16",
    "3",
    "64",
    "1e9",
    "99999999999999999999999999",
];

const UNITS: &[&str] = &[
    "1",
    "rad",
    "m",
    "kg m^2",
    "N m/rad",
    "N m s/rad",
    "rad/s",
    "J",
    "W",
    "V s",
    "A",
    "s",
    "1/s",
    "m^20",
    "m^21",
    "m^-20",
    "m^(1/2)",
    "kN",
    "((((m))))",
    "m/",
    "/",
    "m^2147483648",
    "kg^20*m^20",
    "",
    "µm",
    "m^1/0",
    "N m/(rad s)",
    "Hz",
];

const SNIPPETS: &[&str] = &[
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "[[",
    "]]",
    "=",
    "\"",
    "'",
    "\"\"\"",
    "\n",
    "#",
    ",",
    ".",
    "..",
    "^",
    "/0",
    "*t",
    "-",
    "^-1",
    "^0",
    "^(1/2)",
    "^t",
    "^64",
    "e999",
    " [s]",
    "\0",
    "\u{3c6}",
    "\u{feff}",
    "\u{202e}",
    "\\u0041",
    "\r",
    "\t",
    "step(t, 0 [s])",
    "step(0 [s], t)",
    "min(",
    "piecewise(t < 1 [s], 1, 2)",
    "sqrt(-1)",
    "ln(0)",
    "1/(t - t)",
    "0^0",
    "0/0",
    "(0/1 [s])",
    "angle",
    "angle_dot",
    "angle_ddot",
    "t",
    "pi",
    "true",
    "false",
    "1979-05-27",
    "when = { a = 0 }",
    "elements = 1000000",
    "order = 16",
    "order = 17",
    "fixed = true",
    "ratio = 0",
    "ratio = -1",
    "direction = \"both\"",
    "[[forces]]\n",
    "[initial]\n",
    "[tunable]\nparameters = []\n",
    "[freeze]\nrigid = [\"coupling\"]\n",
    "[run]\nuntil = 1\n",
    "[checks.c]\nof = \"a\"\n",
    "table(\"wind.csv\", \"force\", t)",
    "abs(t)",
    "atan2(0, 0)",
    "sign(0)",
];

/// Returns every text file of some folders below a root and their subfolders, in the order of
/// paths.
pub fn texts(root: &str, folders: &[&str], ending: &str) -> Vec<String> {
    let mut open: Vec<PathBuf> =
        folders.iter().map(|folder| Path::new(root).join(folder)).collect();
    let mut files = Vec::new();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|found| found == ending) {
                files.push(path);
            }
        }
    }
    files.sort();
    files.iter().filter_map(|file| std::fs::read_to_string(file).ok()).collect()
}

/// Damages a text; `other` is a text to take pieces from.
pub fn damage(rng: &mut Rng, text: &[u8], other: &[u8]) -> Vec<u8> {
    let mut text = text.to_vec();
    for _ in 0..=[0, 0, 0, 1, 1, 2, 4, 9][rng.usize(0..8)] {
        text = damage_once(rng, &text, other);
    }
    text
}

/// Replaces numbers in some places of a text by extreme ones or ones of any size.
pub fn other_numbers(rng: &mut Rng, text: &[u8]) -> Vec<u8> {
    let mut text = text.to_vec();
    for _ in 0..=rng.u32(0..3) {
        let number = format!("{:e}", any_number(rng));
        let number = if rng.bool() { pick(rng, EXTREMES).copied() } else { Some(&*number) };
        text = replace_token(rng, &text, is_number, number.as_slice());
    }
    text
}

fn damage_once(rng: &mut Rng, text: &[u8], other: &[u8]) -> Vec<u8> {
    match rng.u32(0..24) {
        0..5 => replace_token(rng, text, is_number, EXTREMES),
        5 => replace_quoted(rng, text, UNITS),
        6 | 7 => {
            let words: Vec<Vec<u8>> = tokens(text).into_iter().filter(|t| is_name(t)).collect();
            let Some(word) = pick(rng, &words) else { return text.to_vec() };
            replace_token(rng, text, is_name, &[&String::from_utf8_lossy(word)])
        }
        8 => swap_tokens(rng, text),
        9..12 => of_lines(rng, text, other),
        12..15 => {
            let expression = expression(rng, &names(text), 4);
            replace_quoted(rng, text, &[&expression])
        }
        15 | 16 => {
            let snippet = pick(rng, SNIPPETS).copied().unwrap_or_default();
            insert(rng, text, snippet.as_bytes())
        }
        17 => replace_token(rng, text, |_| true, SNIPPETS),
        18 => nest(rng, text),
        19 => damage_bytes(rng, text, other),
        20 => splice(rng, text, other),
        21 => {
            let parts = tokens(other);
            let Some(part) = pick(rng, &parts) else { return text.to_vec() };
            replace_token(rng, text, |_| true, &[&String::from_utf8_lossy(part)])
        }
        _ => {
            let number = format!("{:e}", any_number(rng));
            replace_token(rng, text, is_number, &[&number])
        }
    }
}

/// Damages bytes that are not text.
pub fn damage_bytes(rng: &mut Rng, bytes: &[u8], other: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    if bytes.is_empty() {
        return vec![rng.u8(..)];
    }
    let at = rng.usize(0..bytes.len());
    let end = (at + 1 + rng.usize(0..12)).min(bytes.len());
    match rng.u32(0..10) {
        0..3 => bytes[at] ^= 1 << rng.u32(0..8),
        3 => bytes[at] = [0, 1, 0x7f, 0x80, 0xff][rng.usize(0..5)],
        4 => bytes[at] = bytes[at].wrapping_add([1, 255][rng.usize(0..2)]),
        5 => drop(bytes.drain(at..end)),
        6 => {
            let piece = bytes[at..end].to_vec();
            bytes.splice(end..end, piece);
        }
        7 => bytes = splice(rng, &bytes, other),
        // Whole numbers of many bytes, as files of models write them.
        8 => drop(bytes.splice(at..=at, [0xff, 0xff, 0xff, 0xff, 0x0f])),
        _ => bytes[at..end].fill_with(|| rng.u8(..)),
    }
    bytes
}

/// Returns the beginning of one input and the end of another, either possibly empty.
pub fn splice(rng: &mut Rng, one: &[u8], other: &[u8]) -> Vec<u8> {
    let [from, to] = [one.len(), other.len()].map(|length| rng.usize(0..=length));
    [&one[..from], &other[to..]].concat()
}

/// Returns a number of any size.
pub fn any_number(rng: &mut Rng) -> f64 {
    match rng.u32(0..4) {
        0 => f64::from_bits(rng.u64(..)),
        1 => f64::from(rng.i32(-3..4)),
        2 => rng.f64(),
        _ => 10f64.powi(rng.i32(-30..30)),
    }
}

/// Returns a random expression of the spec language over some names.
pub fn expression(rng: &mut Rng, names: &[String], depth: usize) -> String {
    if depth == 0 || rng.u32(0..6) == 0 {
        return match rng.u32(0..5) {
            0 => EXTREMES[rng.usize(0..EXTREMES.len())].to_owned(),
            1 => format!("{} [{}]", rng.u32(0..4), UNITS[rng.usize(0..UNITS.len())]),
            2 => "t".to_owned(),
            _ => pick(rng, names).cloned().unwrap_or_else(|| "1".to_owned()),
        };
    }
    let mut part = || expression(rng, names, depth - 1);
    let [a, b, c, d] = [part(), part(), part(), part()];
    let functions = [
        "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "ln", "sqrt",
        "abs", "sign", "foo",
    ];
    let function = functions[rng.usize(0..functions.len())];
    match rng.u32(0..14) {
        0 | 1 => format!("{a} + {b}"),
        2 | 3 => format!("({a})*({b})"),
        4 => format!("({a} - {b})"),
        5 => format!("({a})/({b})"),
        6 => format!("({a})^{}", ["2", "3", "(1/2)", "-1", "0", "64", "1000"][rng.usize(0..7)]),
        7 => format!("({a})^({b})"),
        8 => format!("-{a}"),
        9 => format!("piecewise({a} < {b}, {c}, {d})"),
        10 => format!("step({a}, {b})"),
        11 => format!("{}({a}, {b})", ["min", "max", "atan2"][rng.usize(0..3)]),
        _ => format!("{function}({a})"),
    }
}

/// Returns a random element.
pub fn pick<'a, T>(rng: &mut Rng, from: &'a [T]) -> Option<&'a T> {
    (!from.is_empty()).then(|| &from[rng.usize(0..from.len())])
}

fn is_number(token: &[u8]) -> bool {
    token.iter().any(u8::is_ascii_digit) && !token[0].is_ascii_alphabetic()
}

fn is_name(token: &[u8]) -> bool {
    token[0].is_ascii_alphabetic()
}

fn names(text: &[u8]) -> Vec<String> {
    let names = tokens(text).into_iter().filter(|token| is_name(token));
    names.map(|name| String::from_utf8_lossy(&name).into_owned()).collect()
}

fn replace_token(
    rng: &mut Rng,
    text: &[u8],
    which: impl Fn(&[u8]) -> bool,
    by: &[&str],
) -> Vec<u8> {
    let mut parts = tokens(text);
    let places: Vec<usize> = (0..parts.len()).filter(|&at| which(&parts[at])).collect();
    if let (Some(&at), Some(word)) = (pick(rng, &places), pick(rng, by)) {
        parts[at] = word.as_bytes().to_vec();
    }
    parts.concat()
}

/// Replaces the text between the quotes of a line.
fn replace_quoted(rng: &mut Rng, text: &[u8], by: &[&str]) -> Vec<u8> {
    let mut parts = lines(text);
    let quotes = |line: &[u8]| line.split(|byte| *byte == b'"').count() > 2;
    let places: Vec<usize> = (0..parts.len()).filter(|&at| quotes(&parts[at])).collect();
    if let (Some(&at), Some(word)) = (pick(rng, &places), pick(rng, by)) {
        let line = &mut parts[at];
        let first = line.iter().position(|byte| *byte == b'"').unwrap_or(0) + 1;
        let last = line.iter().rposition(|byte| *byte == b'"').unwrap_or(first);
        line.splice(first..last.max(first), word.bytes());
    }
    parts.concat()
}

fn swap_tokens(rng: &mut Rng, text: &[u8]) -> Vec<u8> {
    let mut parts = tokens(text);
    if parts.len() > 1 {
        let [a, b] = [(); 2].map(|()| rng.usize(0..parts.len()));
        parts.swap(a, b);
    }
    parts.concat()
}

/// Drops, duplicates, moves or inserts a line or several lines.
fn of_lines(rng: &mut Rng, text: &[u8], other: &[u8]) -> Vec<u8> {
    let (mut parts, others) = (lines(text), lines(other));
    if parts.is_empty() || others.is_empty() {
        return other.to_vec();
    }
    let at = rng.usize(0..parts.len());
    let end = (at + 1 + rng.usize(0..6)).min(parts.len());
    let to = rng.usize(0..=parts.len());
    match rng.u32(0..6) {
        0 => drop(parts.remove(at)),
        1 => drop(parts.drain(at..end)),
        2 => parts.insert(to, parts[at].clone()),
        3 => {
            let some = parts[at..end].to_vec();
            parts.splice(to..to, some);
        }
        4 => parts.insert(to, others[rng.usize(0..others.len())].clone()),
        _ => {
            let from = rng.usize(0..others.len());
            let until = (from + 1 + rng.usize(0..12)).min(others.len());
            parts.splice(to..to, others[from..until].iter().cloned());
        }
    }
    parts.concat()
}

fn insert(rng: &mut Rng, text: &[u8], piece: &[u8]) -> Vec<u8> {
    let mut parts = tokens(text);
    parts.insert(rng.usize(0..=parts.len()), piece.to_vec());
    parts.concat()
}

/// Repeats something very often in one place.
fn nest(rng: &mut Rng, text: &[u8]) -> Vec<u8> {
    let pieces = ["(", "-", "sin(", "[", "{a=", "a.", "^2", "+1", "*2", "1e", "9", "\n", "x", "\""];
    let piece = pieces[rng.usize(0..pieces.len())];
    let count = [30, 199, 2000, 30_000][rng.usize(0..4)];
    insert(rng, text, piece.repeat(count).as_bytes())
}

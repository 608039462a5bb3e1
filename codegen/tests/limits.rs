//! Specs generated at test time: too long, too deep, damaged at random.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::diagnostic::Diagnostics;
use machinist_codegen::spec::load_scene;

/// Time within which a mistake is found, also on a busy machine. An endless search fails.
const PATIENCE: Duration = Duration::from_secs(30);

const GOOD: &str = include_str!("pass/two_rotors.toml");

fn read(path: &Path) -> Result<LagrangianSystem, Diagnostics> {
    compose(&load_scene(path)?)
}

/// A temporary folder `scenes` that contains the file `made.toml`.
struct Made {
    folder: tempfile::TempDir,
}

impl Made {
    fn new(bytes: &[u8]) -> Made {
        let folder = tempfile::tempdir().expect("temporary folder");
        std::fs::create_dir(folder.path().join("scenes")).expect("folder of scenes");
        let made = Made { folder };
        made.write("scenes/made.toml", bytes);
        made
    }

    fn write(&self, path: &str, bytes: &[u8]) {
        std::fs::write(self.folder.path().join(path), bytes).expect("write");
    }

    fn scene(&self) -> PathBuf {
        self.folder.path().join("scenes/made.toml")
    }

    /// Returns the first error, and the whole report.
    fn refusal(&self) -> (String, String) {
        let start = Instant::now();
        let errors = read(&self.scene()).expect_err("is refused");
        assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
        let report = errors.render();
        let whole = self.folder.path().to_string_lossy().into_owned();
        assert!(!report.contains(&whole), "an absolute path in {report}");
        assert!(report.len() < 20_000, "a report of {} bytes", report.len());
        (errors.errors()[0].message.clone(), report)
    }
}

fn refusal(text: &str) -> String {
    Made::new(text.as_bytes()).refusal().0
}

/// Returns the good scene with its drive torque replaced.
fn with_expression(expression: &str) -> String {
    assert!(GOOD.contains("mean_torque*step(t, 0.1 [s])"));
    GOOD.replace("mean_torque*step(t, 0.1 [s])", expression)
}

#[test]
fn an_expression_nested_ten_thousand_deep_is_refused() {
    for (open, close) in
        [("(", ")"), ("-", ""), ("sin(", ")"), ("2^", ""), ("min(1, ", ")"), ("+", "")]
    {
        let text =
            format!("{}1{}", open.repeat(10_000 / open.len()), close.repeat(10_000 / open.len()));
        let message = refusal(&with_expression(&text));
        assert!(message.contains("nests deeper than 200"), "{open}: {message}");
    }
}

#[test]
fn an_expression_nested_two_hundred_deep_is_read() {
    let text = format!("mean_torque*{}1{}", "sin(1 + 2*".repeat(199), ")".repeat(199));
    let made = Made::new(with_expression(&text).as_bytes());
    read(&made.scene()).unwrap_or_else(|errors| panic!("{}", errors.render()));
}

#[test]
fn toml_nested_ten_thousand_deep_is_refused() {
    let deep = 10_000;
    let texts = [
        format!("x = {}{}", "[".repeat(deep), "]".repeat(deep)),
        format!("x = {}1{}", "{a = ".repeat(deep), "}".repeat(deep)),
        format!("[{}a]\nx = 1", "a.".repeat(deep)),
        format!("[[{}a]]\nx = 1", "a.".repeat(deep)),
        format!("{}a = 1", "a.".repeat(deep)),
        format!("x = {{ {}a = 1 }}", "a.".repeat(deep)),
        "[".repeat(deep),
    ];
    for text in texts {
        let message = refusal(&text);
        assert!(message.contains("nest too deep") || message.contains("TOML"), "{message}");
    }
}

#[test]
fn a_long_flat_expression_is_read_without_recursion() {
    let text = format!("mean_torque{}", " + mean_torque".repeat(4000));
    let made = Made::new(with_expression(&text).as_bytes());
    assert!(read(&made.scene()).is_ok());
}

#[test]
fn an_expression_of_more_than_64_kib_is_refused() {
    let message = refusal(&with_expression(&"1 + ".repeat(20_000)));
    assert_eq!(message, "an expression is at most 64 KiB long");
}

#[test]
fn a_file_of_ten_megabytes_is_refused_unread() {
    let made = Made::new(&vec![b'#'; 10 << 20]);
    let (message, report) = made.refusal();
    assert_eq!(message, "a file is at most 1 MiB long");
    assert!(report.contains("scenes/made.toml"), "{report}");
}

#[test]
fn files_that_are_none_are_refused() {
    assert_eq!(refusal(""), "the file is empty");
    assert_eq!(refusal(" \n\n"), "the file is empty");
    assert!(Made::new(b"[scene]\nname = \"\xff\"").refusal().0.contains("not UTF-8"));
    let made = Made::new(b"");
    let missing = load_scene(&made.folder.path().join("none.toml")).expect_err("missing");
    assert_eq!(missing.errors()[0].message, "there is no such file");
    let folder = load_scene(made.folder.path()).expect_err("a folder");
    assert_eq!(folder.errors()[0].message, "this is a folder, not a file");
    assert!(load_scene(Path::new("")).is_err());
    assert!(load_scene(Path::new("/")).is_err());
}

#[test]
fn long_chains_of_helpers_are_refused_without_exhausting_the_stack() {
    let mut text = GOOD.to_owned();
    let _ = write!(text, "\n[helpers.h0]\nexpression = \"h1 + 1\"\nunit = \"1\"\n");
    for i in 1..2000 {
        let _ =
            write!(text, "[helpers.h{i}]\nexpression = \"sin(h{} + 1)\"\nunit = \"1\"\n", i + 1);
    }
    text.push_str("[helpers.h2000]\nexpression = \"1\"\nunit = \"1\"\n");
    assert!(refusal(&text).contains("nest deeper"));
}

#[test]
fn many_instances_of_a_large_helper_are_refused_before_they_fill_the_memory() {
    let mut text = GOOD.to_owned();
    let many = format!("t/1 [s]{}", " + t/1 [s]".repeat(6000));
    let _ = write!(text, "\n[helpers.big]\nexpression = \"{many}\"\nunit = \"1\"\n");
    for i in 0..2000 {
        let _ = write!(text, "[helpers.h{i}]\nexpression = \"big + 1\"\nunit = \"1\"\n");
    }
    assert!(refusal(&text).contains("the scene has more than"));
}

#[test]
fn numbers_without_end_are_refused() {
    let digits = "9".repeat(60_000);
    for text in [digits.clone(), format!("(1 + 1e-300){}", "^64".repeat(5)), format!("1e{digits}")]
    {
        refusal(&with_expression(&text));
    }
    let text = "((((1 + 1e-300)^64)^64)^64)^64";
    assert!(refusal(&with_expression(text)).contains("nested powers"));
}

#[test]
fn units_are_looked_for_beside_the_scene_and_then_among_units() {
    let define = GOOD.find("[define.coupling").expect("coupling");
    let unit = GOOD[define..].replace("define.coupling.", "");
    let unit = format!("[unit]\nname = \"elastic\"\n{unit}");
    let scene = GOOD[..define].replace("unit = \"coupling\"", "unit = \"elastic\"");
    let made = Made::new(scene.as_bytes());
    assert!(made.refusal().0.contains("no unit `elastic`"));
    std::fs::create_dir(made.folder.path().join("units")).expect("folder of units");
    made.write("units/elastic.toml", unit.as_bytes());
    let system = read(&made.scene()).expect("found among the units");
    let labels: Vec<_> = system.files.iter().map(|file| file.label.as_str()).collect();
    assert_eq!(labels, ["scenes/made.toml", "units/elastic.toml"]);
    made.write("scenes/elastic.toml", unit.as_bytes());
    let system = read(&made.scene()).expect("found beside the scene");
    assert_eq!(system.files[1].label, "scenes/elastic.toml");
    made.write("scenes/elastic.toml", unit.replace("\"input\"", "\"inptu\"").as_bytes());
    let (message, report) = made.refusal();
    assert_eq!(message, "unknown coordinate `inptu`");
    assert!(report.contains("scenes/elastic.toml:"), "{report}");
    made.write("scenes/elastic.toml", b"");
    assert_eq!(made.refusal().0, "scenes/elastic.toml: the file is empty");
}

#[test]
fn units_that_come_with_machinist_need_no_file() {
    let define = GOOD.find("[define.coupling").expect("coupling");
    let made = Made::new(&GOOD.as_bytes()[..define]);
    let system = read(&made.scene()).expect("the coupling that comes with Machinist");
    assert_eq!(system.files[1].label, "units/coupling.toml");
    assert_eq!(system.files[1].path, Path::new(""));
}

#[test]
fn a_scene_of_too_many_things_is_refused_before_they_are_made() {
    let mut text = GOOD.to_owned();
    for i in 0..600 {
        let _ = write!(text, "[define.many.parameters.p{i}]\nvalue = 1\nunit = \"1\"\n");
    }
    for i in 0..2000 {
        let _ = write!(text, "[units.many{i}]\nunit = \"many\"\n");
    }
    assert_eq!(refusal(&text), "a scene has at most 100000 named things");
}

#[test]
fn the_hash_of_a_file_is_its_sha256() {
    let made = Made::new(GOOD.as_bytes());
    let system = read(&made.scene()).expect("good");
    let again = read(&made.scene()).expect("good");
    assert_eq!(system, again, "reading twice gives the same");
    assert_eq!(system.files[0].sha256.len(), 64);
    let other = Made::new(format!("{GOOD}#").as_bytes());
    assert_ne!(read(&other.scene()).expect("good").files[0].sha256, system.files[0].sha256);
}

#[cfg(unix)]
#[test]
fn a_table_behind_a_symbolic_link_that_leads_out_is_refused() {
    let text = with_expression("table('inside.csv', 'load', t)").replace('\'', "\\\"");
    let made = Made::new(text.as_bytes());
    let csv = "time [s],load [N m]\n0,1\n1,2\n";
    made.write("outside.csv", csv.as_bytes());
    let inside = made.folder.path().join("scenes/inside.csv");
    std::os::unix::fs::symlink(made.folder.path().join("outside.csv"), &inside).expect("link");
    assert!(made.refusal().0.contains("leads out of the spec's folder"));
    std::fs::remove_file(&inside).expect("remove the link");
    made.write("scenes/inside.csv", csv.as_bytes());
    let system = read(&made.scene()).expect("a table beside the scene");
    assert_eq!(system.files[1].label, "scenes/inside.csv");
}

#[test]
fn tables_too_short_or_too_long_are_refused() {
    let made = Made::new(with_expression("table('a.csv', 'load', t)").as_bytes());
    let header = "time [s],load [N m]\n";
    let row = |i: usize| format!("{i},1\n");
    for (rows, message) in [
        (header.to_owned(), "at least 2 rows"),
        (format!("{header}{}", row(0)), "at least 2 rows"),
        (format!("{header}{}", (0..100_001).map(row).collect::<String>()), "at most 100000 rows"),
        (header.replace(",load [N m]", ""), "two columns"),
        (format!("{header}0,\n1,2\n"), "finite number"),
        (format!("{header}0,1e999\n1,2\n"), "finite number"),
        (format!("{header}0,0\n1e-300,1e300\n"), "cannot be interpolated"),
        (String::new(), "the file is empty"),
    ] {
        made.write("scenes/a.csv", rows.as_bytes());
        let (told, _) = made.refusal();
        assert!(told.contains(message), "{told}");
    }
    made.write(
        "scenes/a.csv",
        format!("{header}{}", (0..9).map(row).collect::<String>()).as_bytes(),
    );
    assert!(read(&made.scene()).is_ok());
}

/// The xorshift64* generator, so that damage is the same on every machine.
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 33) as usize % limit
    }
}

/// Makes one random change: a byte flipped, a piece deleted, doubled, or moved in from elsewhere,
/// or a word of the language inserted.
fn damage(text: &mut Vec<u8>, dice: &mut Dice) {
    const WORDS: &[&str] = &[
        "(",
        ")",
        "^",
        "/0",
        "*t",
        "e999",
        "\"",
        "[",
        "]",
        "{",
        "}",
        "=",
        "\n",
        ".",
        "-",
        "nan",
        "table('a','b',t)",
        "piecewise(t < 1 [s], 1, 2)",
        "step(t, 0)",
        "\u{3c6}",
        "\0",
        "'''",
        "angle_ddot",
        "0",
        "1e308*10",
        "\\u0041",
        "min(",
        ",",
        "<",
        "sqrt(-1)",
        "[[forces]]\n",
    ];
    let at = dice.below(text.len().max(1)).min(text.len());
    let end = (at + 1 + dice.below(40)).min(text.len());
    match dice.below(5) {
        0 if at < text.len() => text[at] ^= 1 << dice.below(8),
        1 => drop(text.drain(at..end)),
        2 => {
            let piece = text[at..end].to_vec();
            text.splice(end..end, piece);
        }
        3 => {
            let piece = text[at..end].to_vec();
            let to = dice.below(text.len().max(1)).min(text.len());
            text.splice(to..to, piece);
        }
        _ => {
            let word = WORDS[dice.below(WORDS.len())].bytes();
            text.splice(at..at, word);
        }
    }
}

#[test]
fn damaged_specs_are_read_or_refused_but_never_panic() {
    let mut dice = Dice(0x9E37_79B9_7F4A_7C15);
    let (mut good, mut bad) = (0, 0);
    let sources = [GOOD, include_str!("pass/loaded_crane.toml"), include_str!("pass/winding.toml")];
    let made = Made::new(GOOD.as_bytes());
    made.write("scenes/wind.csv", include_bytes!("pass/wind.csv"));
    for round in 0..900 {
        let mut text = sources[round % sources.len()].as_bytes().to_vec();
        for _ in 0..=dice.below(3) {
            damage(&mut text, &mut dice);
        }
        made.write("scenes/made.toml", &text);
        match read(&made.scene()) {
            Ok(_) => good += 1,
            Err(errors) => {
                assert!(!errors.errors().is_empty());
                assert!(!errors.render().is_empty());
                bad += 1;
            }
        }
    }
    assert!(good >= 10 && bad >= 600, "{good} read, {bad} refused");
}

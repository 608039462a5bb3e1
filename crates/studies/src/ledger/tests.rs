use std::path::Path;
use std::sync::OnceLock;

use super::*;
use crate::verify::check_names;

/// Rows of the ledger, whose runs take minutes without optimization and are made once.
fn rows() -> &'static [LedgerRow] {
    static ROWS: OnceLock<Vec<LedgerRow>> = OnceLock::new();
    ROWS.get_or_init(|| ledger().expect("the consistent runs succeed"))
}

fn find<'a>(rows: &'a [LedgerRow], figure: &str) -> &'a LedgerRow {
    rows.iter().find(|row| row.figure == figure).expect("the ledger has this figure")
}

#[test]
fn the_ledger_reproduces_what_can_be_reproduced() {
    let rows = rows();
    let close = |value: Option<f64>, expected: f64, tolerance: f64| {
        let value = value.expect("the figure exists");
        assert!((value - expected).abs() <= tolerance, "{value} against {expected}");
    };
    close(find(rows, "torque at slip 0.02").consistent, 954.6866, 5e-5);
    close(find(rows, "leakage factor 1 - Ks Kr").consistent, 0.089_888, 1e-12);
    close(find(rows, "natural frequency on the coupling").consistent, 155.03, 5e-3);
    close(find(rows, "speed 5 s after an empty start").consistent, 78.5398, 1e-3);
    close(find(rows, "printed law of acceleration at 1.844 s").as_printed, 8743.54, 5e-3);
    close(find(rows, "mean load, from its density along the shaft").as_printed, 5845.0, 2.0);
    let torque = find(rows, "largest motor torque in an empty run-up");
    assert!(torque.consistent.expect("it runs") < 2100.0);
    assert!(torque.verdict.contains("with speed instead of angle: 322"), "{}", torque.verdict);
}

#[test]
fn the_literal_reading_never_runs_up() {
    let rows = rows();
    let duration = find(rows, "time until speed stays within 1 % of synchronous");
    assert_eq!(duration.as_printed, None);
    assert!(duration.consistent.expect("it runs up") < 1.0);
}

#[test]
fn the_mobility_table_is_reproduced_and_the_printed_amplitude_is_too_small() {
    let rows = rows();
    let mobility: Vec<&LedgerRow> =
        rows.iter().filter(|row| row.figure.starts_with("mobility of the bobbin")).collect();
    assert_eq!(mobility.len(), 5);
    assert!(mobility.iter().all(|row| row.verdict.starts_with("reproduced")));
    let force = find(rows, "amplitude of the bench winder's bobbin under force");
    // 25/sqrt(22810^2 + 10450^2) m against 25/sqrt(22810^2 + 19855^2) m.
    let amplitude = |damping: f64| 25.0 / 22_810.0_f64.hypot(damping);
    assert!((force.consistent.expect("a closed form") - amplitude(10_450.0)).abs() < 1e-15);
    assert!((force.as_printed.expect("a closed form") - amplitude(19_855.0)).abs() < 1e-15);
}

#[test]
fn every_row_is_whole_and_is_held_by_what_there_is() {
    let rows = rows();
    let checks = check_names();
    let tests = names_of_tests();
    let text = render_ledger(rows);
    for row in rows {
        let about = format!("{} {}", row.at, row.figure);
        let words = [row.at, row.figure, row.verdict.as_str(), row.place];
        assert!(words.iter().all(|words| !words.trim().is_empty()), "{about}");
        let numbers = [row.printed, row.as_printed, row.consistent];
        assert_eq!(numbers.iter().all(Option::is_none), row.unit.is_empty(), "{about}");
        assert!(numbers.iter().flatten().all(|number| number.is_finite()), "{about}");
        let is_held = match row.held {
            Held::Verify(check) => checks.iter().any(|name| name == check),
            Held::Test(name) => tests.iter().any(|known| known == name),
        };
        assert!(is_held, "{about} is held by {}, which there is not", row.held.describe());
        let says = |line: &&str| {
            [row.at, row.figure, row.verdict.as_str()]
                .iter()
                .all(|words| line.split('|').any(|cell| cell.trim() == *words))
        };
        assert_eq!(text.lines().filter(says).count(), 1, "{about}");
    }
}

/// Returns the names of test functions in the repository.
fn names_of_tests() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut names = Vec::new();
    let mut folders = vec![root.join("crates/studies/src"), root.join("tests")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(path).expect("a file");
                let tests = text.split("#[test]").skip(1);
                let name =
                    |test: &str| Some(test.split_once("fn ")?.1.split_once('(')?.0.to_owned());
                names.extend(tests.filter_map(name));
            }
        }
    }
    names
}

#[test]
fn every_numbered_equation_and_figure_of_the_studies_has_a_row() {
    let rows = rows();
    for (study, equations, figures) in
        [(Study::SawGin, 15, 6), (Study::Winder, 26, 8), (Study::Reed, 17, 3)]
    {
        let of = |wanted: &str, number: u32| {
            rows.iter()
                .filter(|row| row.study == study)
                .any(|row| stands_at(row.at, wanted, number))
        };
        for number in 1..=equations {
            assert!(of("(", number), "{study:?} ({number})");
        }
        for number in 1..=figures {
            assert!(of("figure", number), "{study:?} figure {number}");
        }
    }
}

/// Returns whether a place such as `figures 5, 6` or `(11), (12)` names this one.
fn stands_at(at: &str, wanted: &str, number: u32) -> bool {
    if wanted == "(" {
        return at.contains(&format!("({number})"));
    }
    let figures = at.split_once("figure").map_or("", |(_, rest)| rest.trim_start_matches('s'));
    let mut numbers = figures.split(',').map_while(|word| word.trim().parse::<u32>().ok());
    numbers.any(|found| found == number)
}

#[test]
fn the_book_shows_the_ledger() {
    const MARKS: [&str; 2] = ["<!-- rows of the ledger -->", "<!-- end of them -->"];
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/src/studies.md");
    let text = std::fs::read_to_string(&page).expect("the chapter");
    let (before, rest) = text.split_once(MARKS[0]).expect("the mark before the rows");
    let (shown, after) = rest.split_once(MARKS[1]).expect("the mark after them");
    let now = format!("\n\n{}\n", page_table(rows()));
    if std::env::var("MACHINIST_BOOK").is_ok_and(|word| word == "write") {
        let whole = [before, MARKS[0], &now, MARKS[1], after].concat();
        std::fs::write(&page, whole).expect("written");
        return;
    }
    let differing = shown.lines().zip(now.lines()).find(|(shown, now)| !alike(shown, now));
    let is_whole = shown.lines().count() == now.lines().count();
    assert!(
        differing.is_none() && is_whole,
        "{differing:#?}\nMACHINIST_BOOK=write before `cargo test -p machinist-studies --lib ledger` \
         writes the rows of docs/book/src/studies.md again"
    );
}

/// Returns whether two lines differ at most in the last digits of numbers, whose rounding depends
/// on the processor.
fn alike(shown: &str, now: &str) -> bool {
    let words = |line: &str| {
        line.split(|c: char| c.is_whitespace() || c == ',' || c == ';' || c == '(' || c == ')')
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let is_alike = |(a, b): (&String, &String)| match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(x), Ok(y)) => a == b || (x - y).abs() <= 2e-4 * x.abs().max(y.abs()),
        _ => a == b,
    };
    let (shown, now) = (words(shown), words(now));
    shown.len() == now.len() && shown.iter().zip(&now).all(is_alike)
}

#[test]
fn numbers_are_compared_in_words() {
    assert_eq!(compare(100.0, 101.0), "within 1 %");
    assert_eq!(compare(40_000.0, 2000.0), "20 times smaller");
    assert_eq!(compare(1.0, 1.62), "1.6 times larger");
    assert_eq!(compare(1.0, -1.0), "of the other sign");
    assert_eq!(compare(78.54, 78.54), "within 0 %");
}

#[test]
fn digits_are_significant_ones() {
    assert_eq!(digits(0.089_888), "0.089888");
    assert_eq!(digits(8_743.542_81), "8743.543");
    assert_eq!(digits(40_000.0), "40000");
    assert_eq!(digits(-0.5), "-0.5");
    assert_eq!(digits(0.0), "0");
}

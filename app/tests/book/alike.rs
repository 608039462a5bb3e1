//! Comparison of printed lines with those in the book.
//!
//! Processors round the last bits of elementary functions differently, so numbers need not agree in
//! their last digits. They must be equal to 1e-5, or both within rounding; error estimates, which
//! have two digits, must agree in their order of magnitude.

/// Returns whether a line is as shown, where `...` stands for anything.
pub fn line_matches(shown: &str, printed: &str) -> bool {
    glob(shown, printed) || words_match(&words(shown), &words(printed))
}

/// Splits a line into words, because a number may be longer or shorter than the one shown.
fn words(line: &str) -> Vec<&str> {
    let parts = line.split(|c: char| c.is_whitespace() || c == ',');
    parts.flat_map(|part| part.split_inclusive('|')).filter(|word| !word.is_empty()).collect()
}

fn words_match(shown: &[&str], printed: &[&str]) -> bool {
    match (shown, printed) {
        ([], []) => true,
        (["...", rest @ ..], _) => (0..=printed.len()).any(|at| words_match(rest, &printed[at..])),
        ([a, rest @ ..], [b, others @ ..]) => word_matches(a, b) && words_match(rest, others),
        _ => false,
    }
}

fn word_matches(shown: &str, printed: &str) -> bool {
    let is_rule = |word: &str| word.trim_end_matches('|').bytes().all(|byte| byte == b'-');
    glob(shown, printed) || numbers_match(shown, printed) || is_rule(shown) && is_rule(printed)
}

fn numbers_match(shown: &str, printed: &str) -> bool {
    const SAME: f64 = 1e-5;
    const ROUNDING: f64 = 1e-9;
    let (Ok(a), Ok(b)) = (shown.parse::<f64>(), printed.parse::<f64>()) else { return false };
    let size = a.abs().max(b.abs());
    let is_figure_of_error = |word: &str| {
        word.split_once('e').is_some_and(|(digits, _)| digits.trim_start_matches('-').len() <= 3)
    };
    (a - b).abs() <= SAME * size
        || size <= ROUNDING
        || is_figure_of_error(shown) && is_figure_of_error(printed) && a.min(b) >= 0.1 * size
}

fn glob(shown: &str, printed: &str) -> bool {
    match shown.split_once("...") {
        None => shown == printed,
        Some((start, rest)) => printed.strip_prefix(start).is_some_and(|printed| {
            let ends = (0..=printed.len()).filter(|at| printed.is_char_boundary(*at));
            ends.into_iter().any(|at| glob(rest, &printed[at..]))
        }),
    }
}

#[test]
fn what_only_rounding_tells_apart_is_alike_and_nothing_else() {
    for (shown, printed) in [
        ("took ... s", "took 3 s"),
        ("| pass | a | 2.2e-15 | ...", "| pass | a | 0.0e0   | reason"),
        ("|------|--...", "|---------|-----|"),
        ("5000,98.09999999999995,2", "5000,98.1,2"),
        ("| pass | 5.4e-5 |", "| pass | 6.1e-5 |"),
        ("height  m  -0.00109  1.76611", "height  m  -0.00109   1.766112"),
    ] {
        assert!(line_matches(shown, printed), "{shown} / {printed}");
    }
    for (shown, printed) in [
        ("shaft.stiffness  18000", "shaft.stiffness  18001"),
        ("| pass | 5.4e-5 |", "| FAIL | 5.4e-5 |"),
        ("| pass | 5.4e-5 |", "| pass | 5.4e-3 |"),
        ("14 checks, 0 failed", "14 checks, 1 failed"),
        ("wrote a.csv", "wrote b.csv"),
        ("1 2", "1 2 3"),
    ] {
        assert!(!line_matches(shown, printed), "{shown} / {printed}");
    }
}

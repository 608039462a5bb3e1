//! Results of trials of methods in words, for the command and the report.

use machinist_studies::stability::{ALLOWED, LARGEST, LongRun, MAX_STEPS, Outcome, Study};

use crate::number::number;

/// Returns scene, method, end, steps, and the violation of the constraints before and after
/// projection.
pub fn drift_cells(run: &LongRun) -> [String; 6] {
    [
        run.scene.to_owned(),
        run.method.name().to_owned(),
        format!("{:.0} s", run.until),
        run.steps.to_string(),
        format!("{:.1e}", run.before),
        format!("{:.1e}", run.after),
    ]
}

/// Caption of the long runs.
pub const DRIFT: &str = "Maximum constraint drift over very many steps, relative to the size of \
    the coordinates: at the ends of steps, and after projection.";

/// Caption of the orders of convergence.
pub const ORDERS: &str = "Observed orders of convergence on the problem of Prothero and Robinson, \
    y' = lambda (y - cos t) - sin t, from fixed steps and steps of half the size; a dash where \
    errors are only rounding.";

/// Formats an order.
pub fn order(found: Option<f64>) -> String {
    found.map_or_else(|| "-".to_owned(), |order| format!("{order:.1}"))
}

/// Formats an outcome in a few letters.
pub fn cell(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Right { error, .. } => number(*error, 2),
        Outcome::Refused { word, .. } => (*word).to_owned(),
        Outcome::Wrong { error, .. } => format!("WRONG {error:.0e}"),
    }
}

/// Explains the numbers, and which of them count as wrong.
pub fn rule(study: &Study) -> String {
    format!(
        "Numbers are errors over the relative tolerance, which is {:.0e}: the largest over all \
         states and times judged, relative to the largest value of the state at these times. A \
         completed run is WRONG if its number exceeds {ALLOWED} and one per step, or if its \
         error exceeds {} %.",
        study.rtol,
        100.0 * LARGEST
    )
}

/// Explains the words that occur.
pub fn refusals(study: &Study) -> String {
    const WORDS: [(&str, &str); 10] = [
        ("steps", "more steps than are allowed"),
        ("small", "steps too small for time to advance"),
        ("newton", "Newton's iteration does not converge"),
        ("nan", "a value that is not a number"),
        ("rounding", "rounding would exceed the tolerance"),
        ("unfit", "a machine that the method does not support"),
        ("zeno", "endless events (Zeno)"),
        ("drift", "constraint drift"),
        ("large", "more memory than is allowed"),
        ("solver", "another error of the solver"),
    ];
    let cells = || study.rows.iter().flat_map(|row| &row.cells);
    let occurs = |word: &str| {
        cells().any(
            |cell| matches!(&cell.outcome, Outcome::Refused { word: found, .. } if *found == word),
        )
    };
    let words = WORDS.iter().filter(|(word, _)| occurs(word));
    let words: Vec<String> = words.map(|(word, meaning)| format!("{word}: {meaning}")).collect();
    if words.is_empty() {
        return "No run was refused.".to_owned();
    }
    format!("Refused for {}. At most {MAX_STEPS} steps are allowed.", words.join("; "))
}

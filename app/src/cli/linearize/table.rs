//! Answer of `machinist linearize` for people.

use std::f64::consts::TAU;

use machinist::linear_analysis::{Estimator, Hidden, Hold, Regulator, Rows, Signal};

use super::Designs;
use super::answer::Answer;
use crate::cli::output::columns;
use crate::number::number;

/// Digits shown.
const DIGITS: usize = 6;
/// Maximum number of columns of a matrix that is shown.
const WIDEST: usize = 12;

/// Formats the answer.
pub fn describe(answer: &Answer<'_>, designs: &Designs) -> String {
    let model = answer.model;
    let mut text = format!("{}: {}\n{}", answer.scene(), answer.title, answer.place);
    if let Some(sampling) = model.sampling {
        let hold = match sampling.hold {
            Hold::Zoh => "inputs constant between samples",
            Hold::Tustin => "Tustin's approximation",
        };
        let period = number(sampling.period, DIGITS);
        text.extend(["\nsampled at ", &period, " s, ", hold]);
    }
    text.push_str("\n\n");
    text.push_str(&signals(answer));
    if !model.eliminated.is_empty() {
        let names = model.eliminated.join(", ");
        text.extend(["\ndetermined by constraints and left out: ", &names, "\n"]);
    }
    if model.states.len() + model.inputs.len() > WIDEST {
        text.push_str("\nA, B, C and D are too wide to be shown; see --json and --out\n");
    } else {
        let (x, u) = (&model.states, &model.inputs);
        text.push_str(&matrix("A", x, x, &model.a));
        text.push_str(&matrix("B", x, u, &model.b));
        text.push_str(&matrix("C", &model.outputs, x, &model.c));
        text.push_str(&matrix("D", &model.outputs, u, &model.d));
    }
    text.push_str(&roots("pole", &answer.poles, model.sampling.map(|sampling| sampling.period)));
    text.push_str(&roots("zero", &answer.zeros, model.sampling.map(|sampling| sampling.period)));
    text.push_str(&hidden(answer));
    designs.regulator.iter().for_each(|regulator| text.push_str(&regulator_told(regulator)));
    designs
        .estimator
        .iter()
        .for_each(|estimator| text.push_str(&estimator_told(answer, estimator)));
    text
}

/// Formats states, inputs and outputs with their values at the operating point.
fn signals(answer: &Answer<'_>) -> String {
    let model = answer.model;
    let heading = ["", "name", "at the point", "unit"].map(str::to_owned);
    let kinds = [("state", &model.states), ("input", &model.inputs), ("output", &model.outputs)];
    let rows = kinds.into_iter().flat_map(|(kind, signals)| {
        signals.iter().map(move |signal| {
            let value = number(signal.value, DIGITS);
            [kind.to_owned(), signal.name.clone(), value, signal.unit.clone()]
        })
    });
    let rows: Vec<[String; 4]> = std::iter::once(heading).chain(rows).collect();
    columns(&rows, 2)
}

fn matrix(name: &str, rows: &[Signal], across: &[Signal], entries: &Rows) -> String {
    let named = |signals: &[Signal]| signals.iter().map(|signal| signal.name.clone()).collect();
    named_matrix(name, named(rows), named(across), entries)
}

fn named_matrix(
    name: &str,
    rows: Vec<String>,
    across: Vec<String>,
    entries: &[Vec<f64>],
) -> String {
    if rows.is_empty() || across.is_empty() {
        return String::new();
    }
    let heading: Vec<String> = std::iter::once(name.to_owned()).chain(across).collect();
    let shown = rows.into_iter().zip(entries).map(|(name, row)| {
        std::iter::once(name).chain(row.iter().map(|entry| number(*entry, DIGITS))).collect()
    });
    let lines: Vec<Vec<String>> = std::iter::once(heading).chain(shown).collect();
    format!("\n{}", columns(&lines, 1))
}

/// Formats poles or zeros, a conjugate pair once.
fn roots(what: &str, values: &[[f64; 2]], period: Option<f64>) -> String {
    if values.is_empty() {
        return if what == "zero" { "\nno zeros\n".to_owned() } else { String::new() };
    }
    let plane = if period.is_some() { "z" } else { "1/s" };
    let heading = [
        format!("{what} [{plane}]"),
        "natural [rad/s]".to_owned(),
        "[Hz]".to_owned(),
        "damping ratio".to_owned(),
    ];
    let upper = values.iter().filter(|[_, imaginary]| *imaginary >= 0.0);
    let row = |root: &[f64; 2]| {
        let [real, imaginary] = &rounded(*root);
        let root = if *imaginary == 0.0 {
            number(*real, DIGITS)
        } else {
            format!("{} ± {}i", number(*real, DIGITS), number(*imaginary, DIGITS))
        };
        // s = ln z / h
        let [real, imaginary] = match period {
            None => [*real, *imaginary],
            Some(h) => rounded([real.hypot(*imaginary).ln() / h, imaginary.atan2(*real) / h]),
        };
        let natural = real.hypot(imaginary);
        let ratio =
            if imaginary == 0.0 { String::new() } else { number(0.0 - real / natural, DIGITS) };
        [root, number(natural, DIGITS), number(natural / TAU, DIGITS), ratio]
    };
    let rows: Vec<[String; 4]> = std::iter::once(heading).chain(upper.map(row)).collect();
    format!("\n{}", columns(&rows, 0))
}

/// Returns a root without a real or imaginary part that is only rounding.
fn rounded([real, imaginary]: [f64; 2]) -> [f64; 2] {
    const ROUNDING: f64 = 1e-13;
    let least = ROUNDING * real.hypot(imaginary);
    [real, imaginary].map(|part| if part.abs() <= least { 0.0 } else { part })
}

/// Formats controllability and observability.
fn hidden(answer: &Answer<'_>) -> String {
    let listed = |modes: &[Hidden]| {
        let one = |hidden: &Hidden| {
            let pole = rounded(hidden.pole);
            let [real, imaginary] = pole.map(|part| number(part, DIGITS));
            let pole = if pole[1] == 0.0 { real } else { format!("{real} ± {imaginary}i") };
            format!("  pole {pole}: {}\n", answer.model.named(hidden))
        };
        modes.iter().map(one).collect::<String>()
    };
    let mut text = "\n".to_owned();
    if answer.uncontrollable.is_empty() {
        text.push_str("controllable: the inputs move every eigenmode\n");
    } else {
        text.push_str("not controllable: the inputs do not move\n");
        text.push_str(&listed(&answer.uncontrollable));
    }
    if answer.unobservable.is_empty() {
        text.push_str("observable: the outputs show every eigenmode\n");
    } else {
        text.push_str("not observable: the outputs do not show\n");
        text.push_str(&listed(&answer.unobservable));
    }
    text
}

fn regulator_told(regulator: &Regulator) -> String {
    let Regulator { inputs, states, gain, poles, .. } = regulator;
    let law = "\nLinear-quadratic regulator u = u0 - K (x - x0)\n";
    let gain = named_matrix("K", inputs.clone(), states.clone(), gain);
    format!("{law}{gain}\nclosed loop, poles of A - B K: {}\n", listed(poles))
}

fn estimator_told(answer: &Answer<'_>, estimator: &Estimator) -> String {
    let Estimator { outputs, states, gain, innovation_gain, covariance, poles, .. } = estimator;
    let law = if answer.model.sampling.is_some() {
        "\nKalman filter x[k+1] = A x[k] + B u[k] + L (y[k] - C x[k] - D u[k]), x[k|k] = x[k] + M (...)\n"
    } else {
        "\nKalman filter x' = A x + B u + L (y - C x - D u)\n"
    };
    let mut text = law.to_owned();
    text.push_str(&named_matrix("L", states.clone(), outputs.clone(), gain));
    if let Some(gain) = innovation_gain {
        text.push_str(&named_matrix("M", states.clone(), outputs.clone(), gain));
    }
    let deviations = covariance.iter().enumerate().map(|(index, row)| row[index].max(0.0).sqrt());
    let deviations: Vec<Vec<f64>> = deviations.map(|deviation| vec![deviation]).collect();
    let heading = vec!["standard deviation".to_owned()];
    text.push_str(&named_matrix("estimate", states.clone(), heading, &deviations));
    text.extend(["\nestimator, poles of A - L C: ", &listed(poles), "\n"]);
    text
}

/// Lists poles on one line, a conjugate pair once.
fn listed(poles: &[[f64; 2]]) -> String {
    let upper = poles.iter().filter(|[_, imaginary]| *imaginary >= 0.0);
    let shown = upper.map(|root| {
        let [real, imaginary] = &rounded(*root);
        let real = number(*real, DIGITS);
        if *imaginary == 0.0 { real } else { format!("{real} ± {}i", number(*imaginary, DIGITS)) }
    });
    shown.collect::<Vec<_>>().join(", ")
}

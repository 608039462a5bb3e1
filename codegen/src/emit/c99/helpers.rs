//! Functions that emitted bodies call. Unused ones are not emitted, because compilers warn of
//! them.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use machinist_model::hoist::Hoisted;
use machinist_model::{Function, Model, Op, Tape, needed_nodes};

use super::body::{steps_of, wide_batches};
use super::estimator::Tangents;
use super::expression::{function_name, power_name};
use super::{Real, Scene};
use crate::emit::EmitError;

const ANGLE: &str = include_str!("snippets/angle.c");
const SINE: &str = include_str!("snippets/sine.c");
const SINES: &str = include_str!("snippets/sines.c");
const ONE_SINE: &str = include_str!("snippets/one_sine.c");
const SINE_ALONE: &str = include_str!("snippets/sine_alone.c");
const COSINE_ALONE: &str = include_str!("snippets/cosine_alone.c");
const REDUCED: &str = include_str!("snippets/reduced.c");
const EXPONENTIAL: &str = include_str!("snippets/exponential.c");
const TANGENT: &str = include_str!("snippets/tangent.c");
const TABLE: &str = include_str!("snippets/table.c");

/// Helpers that the tapes of a scene call.
#[derive(Debug, Default)]
struct Needs {
    functions: BTreeSet<Function>,
    powers: BTreeSet<i32>,
    /// True if sine and cosine of the same argument are computed somewhere.
    pairs: bool,
    /// True if sines and cosines of four arguments are computed by one call.
    several: bool,
    /// True for sine and cosine, respectively, if computed alone.
    alone: [bool; 2],
    tables: bool,
}

/// Returns the tapes that are emitted.
pub(super) fn tapes<'a>(
    model: &'a Model,
    hoisted: &'a Hoisted,
    tangents: Option<&'a Tangents>,
) -> Vec<&'a Tape> {
    let own = model.functions().map(|row| hoisted.tape(model, row.id));
    let own = own.chain([&hoisted.constants, &hoisted.motion]);
    own.chain(tangents.into_iter().flat_map(Tangents::tapes)).collect()
}

impl Needs {
    fn of(tapes: &[&Tape], real: Real) -> Self {
        let mut needs = Self::default();
        for tape in tapes {
            needs.add(tape, real);
        }
        needs
    }

    fn add(&mut self, tape: &Tape, real: Real) {
        let mut needed = needed_nodes(tape);
        for batch in wide_batches(&steps_of(tape, real)) {
            self.several = true;
            batch.results().for_each(|id| needed[id.0 as usize] = false);
        }
        let mut angles = [BTreeSet::new(), BTreeSet::new()];
        for (node, _) in tape.nodes.iter().zip(needed).filter(|(_, needed)| *needed) {
            match node.op {
                Op::Call(function, argument) => {
                    self.functions.insert(function);
                    match function {
                        Function::Sin => angles[0].insert(argument),
                        Function::Cos => angles[1].insert(argument),
                        _ => false,
                    };
                }
                Op::Powi(_, exponent) => {
                    self.powers.insert(exponent);
                }
                Op::Table { .. } => self.tables = true,
                _ => {}
            }
        }
        self.pairs |= !angles[0].is_disjoint(&angles[1]);
        self.alone[0] |= !angles[0].is_subset(&angles[1]);
        self.alone[1] |= !angles[1].is_subset(&angles[0]);
    }
}

/// Returns the names of the helpers of a scene, which variables must not take.
pub(super) fn names(tapes: &[&Tape], real: Real) -> Vec<String> {
    let needs = Needs::of(tapes, real);
    let functions = needs.functions.iter().map(|function| function_name(*function, real));
    let powers = needs.powers.iter().map(|exponent| power_name(*exponent));
    let always = [
        "reduced_angle",
        "sine_of_rest",
        "cosine_of_rest",
        "signed_by_turns",
        "sine_after_turns",
        "near_sine_and_cosine",
        "sine_and_cosine",
        "sines_and_cosines_of_four",
        "interpolate",
        "motion",
        "solve",
        "substitute",
    ];
    let always = always.into_iter().map(str::to_owned);
    functions.chain(powers).chain(always).collect()
}

/// Returns the helpers of a scene.
pub(super) fn helpers(scene: &Scene<'_>) -> Result<String, EmitError> {
    let tapes = tapes(scene.model, &scene.hoisted, scene.tangents.as_ref());
    let needs = Needs::of(&tapes, scene.options.real);
    let needs_function = |function| needs.functions.contains(&function);
    let mut parts = Vec::new();
    if scene.options.real == Real::Double {
        let [sine, cosine] = needs.alone;
        if needs.pairs || needs.several || sine || cosine {
            parts.push(ANGLE.to_owned());
        }
        if needs.pairs || needs.several {
            parts.push(SINE.to_owned());
        }
        if needs.several {
            parts.push(SINES.to_owned());
        }
        if sine || cosine {
            parts.push(ONE_SINE.to_owned());
        }
        if sine {
            parts.push(SINE_ALONE.to_owned());
        }
        if cosine {
            parts.push(COSINE_ALONE.to_owned());
        }
        let [exponential, tangent] = [Function::Exp, Function::Tanh].map(needs_function);
        if exponential || tangent {
            parts.push(REDUCED.to_owned());
        }
        if exponential {
            parts.push(EXPONENTIAL.to_owned());
        }
        if tangent {
            parts.push(TANGENT.to_owned());
        }
    }
    parts.extend(needs.powers.iter().map(|exponent| power(*exponent, scene.options.real)));
    if needs.tables {
        parts.push(scene.filled(TABLE));
        parts.push(tables(scene)?);
    }
    Ok(parts.join("\n"))
}

/// Returns a power by repeated squaring, as the contract computes it.
fn power(exponent: i32, real: Real) -> String {
    let (name, real_name) = (power_name(exponent), real.name());
    let one = if real == Real::Double { "1.0" } else { "1.0f" };
    let mut lines = Vec::new();
    let (mut power, mut square, mut left) =
        (None::<String>, "x".to_owned(), exponent.unsigned_abs());
    let mut size = 1_u64;
    while left > 0 {
        if left & 1 == 1 {
            power = Some(match power {
                None => square.clone(),
                Some(power) => format!("({power} * {square})"),
            });
        }
        left >>= 1;
        if left > 0 {
            size *= 2;
            lines.push(format!("    const {real_name} x{size} = {square} * {square};\n"));
            square = format!("x{size}");
        }
    }
    let power = power.unwrap_or_else(|| one.to_owned());
    let power = power.strip_prefix('(').and_then(|p| p.strip_suffix(')')).unwrap_or(&power);
    let value = match (exponent < 0, power.contains('*')) {
        (false, _) => power.to_owned(),
        (true, false) => format!("{one} / {power}"),
        (true, true) => format!("{one} / ({power})"),
    };
    if exponent == 0 {
        lines.push("    (void)x;\n".to_owned());
    }
    let lines = lines.concat();
    format!("static {real_name} {name}({real_name} x)\n{{\n{lines}    return {value};\n}}\n")
}

/// Returns the tables of a scene.
fn tables(scene: &Scene<'_>) -> Result<String, EmitError> {
    let mut text = String::new();
    for (table, name) in scene.model.tables.iter().zip(&scene.tables) {
        let number = |value: f64| {
            let place = || format!("table `{}`", table.name.path);
            let literal = scene.options.real.literal(value);
            literal.ok_or_else(|| EmitError::NotFinite { place: place(), value })
        };
        let knots = table.knots.iter().map(|&knot| number(knot)).collect::<Result<Vec<_>, _>>()?;
        let rows = table.coefficients.iter().map(|row| {
            let row = row.iter().map(|&value| number(value)).collect::<Result<Vec<_>, _>>()?;
            Ok(format!("{{ {} }}", row.join(", ")))
        });
        let rows = rows.collect::<Result<Vec<_>, EmitError>>()?;
        let intervals = table.coefficients.len();
        let [.., before, last] = table.knots.as_slice() else {
            let message = format!("the table `{}` has no interval", table.name.path);
            return Err(EmitError::Unsupported { message });
        };
        let width = number(last - before)?;
        let real = scene.real();
        text.push_str(&super::layout::comment([format!(
            "Natural cubic spline {}.",
            table.name.path
        )]));
        let list = |name: &str, size: String, items: &[String]| {
            let items = super::layout::statement(&format!("{},", items.join(", ")), 4);
            format!("static const {real} {name}{size} = {{\n{items}}};\n")
        };
        text.push_str(&list(&format!("{name}_knots"), format!("[{}]", knots.len()), &knots));
        text.push_str(&list(&format!("{name}_coefficients"), format!("[{intervals}][4]"), &rows));
        let _ = writeln!(
            text,
            "static const struct cubic_table {name} = {{\n    {intervals}u, {name}_knots, \
             {name}_coefficients, {width}\n}};\n"
        );
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    Ok(text)
}

/// Replaces `R(0.5)` in a snippet by a literal of the number type.
pub(super) fn with_literals(text: &str, real: Real) -> String {
    let suffix = if real == Real::Double { "" } else { "f" };
    let mut filled = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("R(") {
        let is_word = rest[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || c == '_');
        let end = rest[at..].find(')').map(|end| at + end);
        match end {
            Some(end) if !is_word => {
                filled.push_str(&rest[..at]);
                filled.push_str(&rest[at + 2..end]);
                filled.push_str(suffix);
                rest = &rest[end + 1..];
            }
            _ => {
                filled.push_str(&rest[..at + 2]);
                rest = &rest[at + 2..];
            }
        }
    }
    filled.push_str(rest);
    filled
}

#[cfg(test)]
mod tests {
    use super::{Real, power, with_literals};

    #[test]
    fn powers_are_those_of_repeated_squaring() {
        assert!(power(2, Real::Double).contains("const double x2 = x * x;\n    return x2;"));
        assert!(power(3, Real::Double).contains("return x * x2;"));
        assert!(power(7, Real::Float).contains("return (x * x2) * x4;"));
        assert!(power(-3, Real::Float).contains("return 1.0f / (x * x2);"));
        assert!(power(-1, Real::Double).contains("return 1.0 / x;"));
    }

    #[test]
    fn literals_take_the_type_of_numbers() {
        assert_eq!(with_literals("R(0.5) * FOR(a) + R(2.0)", Real::Float), "0.5f * FOR(a) + 2.0f");
    }
}

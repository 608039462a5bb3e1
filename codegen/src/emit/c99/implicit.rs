//! The linearly implicit step, with its elimination written line by line.

use std::fmt::Write as _;

use machinist_contract::fixed_step::ROSENBROCK_GAMMA;
use machinist_model::Elimination;

use super::Scene;
use super::expression::literal;
use super::functions::nonzeros;
use super::layout::statement;
use crate::emit::EmitError;

const ROSENBROCK: &str = include_str!("snippets/rosenbrock.c");

/// Returns the elimination for a scene's `I - g h J`.
pub(super) fn elimination(scene: &Scene<'_>) -> Elimination {
    let model = scene.model;
    Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries)
}

/// Returns `advance` and the functions it calls.
pub(super) fn advance(scene: &Scene<'_>) -> Result<String, EmitError> {
    let list = elimination(scene);
    let gamma = literal(ROSENBROCK_GAMMA, scene.options.real, "advance")?.text;
    let has_jacobian = !scene.model.rate_jacobian.pattern.entries.is_empty();
    let jacobian = if has_jacobian {
        "    scene_real_t jacobian[NONZEROS];\n    scene_rate_jacobian(time, state, p, c, \
         jacobian);\n    factor_step(scale, jacobian, factors);\n"
    } else {
        "    factor_step(factors);\n"
    };
    let text = ROSENBROCK
        .replace("JACOBIAN\n", jacobian)
        .replace("GAMMA", &gamma)
        .replace("PLACES", &format!("{}", list.borrowed().places))
        .replace("NONZEROS", &nonzeros(scene, "rate_jacobian"));
    let parts = [factor(scene, &list), substitute(scene, &list), second(scene)];
    Ok(format!("{}\n{}", parts.join("\n"), scene.filled(&text)))
}

/// Returns the function that factors `I - scale J`, with quotients below the diagonal and
/// inverses on it.
fn factor(scene: &Scene<'_>, list: &Elimination) -> String {
    let of = list.borrowed();
    let real = scene.real();
    let [zero, one] = [0.0, 1.0].map(|x| scene.options.real.literal(x).unwrap_or_default());
    let has_jacobian = !of.entries.is_empty();
    let read = if has_jacobian {
        format!("{real} scale, const {real} jacobian[{}], ", nonzeros(scene, "rate_jacobian"))
    } else {
        String::new()
    };
    let head = format!("static void factor_step({read}{real} factors[{}])", of.places);
    let mut text =
        String::from("/* Factors of I - scale J; what is zero in both is left out. */\n");
    text.push_str(&statement(&head, 0));
    text.push_str("{\n");
    let is_pivot = |place: usize| of.pivots.iter().any(|pivot| pivot.place as usize == place);
    for place in 0..of.places {
        let start = if is_pivot(place) { &one } else { &zero };
        let _ = writeln!(text, "    factors[{place}] = {start};");
    }
    for (entry, place) in of.entries.iter().enumerate() {
        let _ =
            writeln!(text, "    factors[{place}] = factors[{place}] - scale * jacobian[{entry}];");
    }
    let (mut row, mut product) = (0, 0);
    for pivot in of.pivots {
        let at = pivot.place;
        let _ = writeln!(text, "    factors[{at}] = {one} / factors[{at}];");
        for place in &of.rows[row..pivot.rows_end as usize] {
            let _ = writeln!(text, "    factors[{place}] = factors[{place}] * factors[{at}];");
        }
        for (place, a, b) in &of.products[product..pivot.products_end as usize] {
            let _ = writeln!(
                text,
                "    factors[{place}] = factors[{place}] - factors[{a}] * factors[{b}];"
            );
        }
        (row, product) = (pivot.rows_end as usize, pivot.products_end as usize);
    }
    text.push_str("}\n");
    text
}

/// Returns the function that solves for a right side, member by member.
fn substitute(scene: &Scene<'_>, list: &Elimination) -> String {
    let of = list.borrowed();
    let head = format!(
        "static void substitute_step(const {} factors[{}], {} *x)",
        scene.real(),
        of.places,
        scene.public("state_t")
    );
    let comment = "/* Solves by the factors, in place. */\n";
    let lines = lines_of(list, |unknown| format!("x->{}", scene.state_members[unknown as usize]));
    format!("{comment}{}{lines}", statement(&head, 0))
}

/// Returns the function that solves for a right side, entry by entry.
pub(super) fn substitute_column(scene: &Scene<'_>) -> String {
    let list = elimination(scene);
    let head = format!(
        "static void substitute_column(const {real} factors[{}], {real} x[{}])",
        list.borrowed().places,
        scene.macro_name("STATES"),
        real = scene.real()
    );
    let comment = "/* Solves for a column by the factors, in place. */\n";
    format!("{comment}{}{}", statement(&head, 0), lines_of(&list, |entry| format!("x[{entry}]")))
}

/// Returns the body of a function that solves, given the names of unknowns.
fn lines_of(list: &Elimination, name: impl Fn(u32) -> String) -> String {
    let of = list.borrowed();
    let mut text = String::from("{\n");
    let mut line = |row: u32, terms: &[(u32, u32)], scale: Option<u32>| {
        let terms = terms.iter().map(|(place, of)| format!(" - factors[{place}] * {}", name(*of)));
        let terms = terms.collect::<String>();
        let sum = format!("{}{terms}", name(row));
        let value = match scale {
            None => sum,
            Some(place) if !terms.is_empty() => format!("({sum}) * factors[{place}]"),
            Some(place) => format!("{sum} * factors[{place}]"),
        };
        text.push_str(&statement(&format!("{} = {value};", name(row)), 4));
    };
    let mut first = 0;
    for unknown in of.unknowns {
        let end = unknown.terms_end[0] as usize;
        if end > first {
            line(unknown.row, &of.lower[first..end], None);
        }
        first = end;
    }
    first = 0;
    for unknown in of.unknowns.iter().rev() {
        let end = unknown.terms_end[1] as usize;
        line(unknown.row, &of.upper[first..end], Some(unknown.diagonal));
        first = end;
    }
    text.push_str("}\n");
    text
}

/// Returns `-2 k1 - g h f_t`, member by member.
fn second(scene: &Scene<'_>) -> String {
    let (real, state) = (scene.real(), scene.public("state_t"));
    let two = scene.options.real.literal(2.0).unwrap_or_default();
    let mut text = String::new();
    let head = format!(
        "static void second_right_side({state} *slope, {real} scale, const {state} *by_time)"
    );
    text.push_str(&statement(&head, 0));
    text.push_str("{\n");
    for member in &scene.state_members {
        let line =
            format!("slope->{member} = -({two} * slope->{member}) - scale * by_time->{member};");
        text.push_str(&statement(&line, 4));
    }
    text.push_str("}\n");
    text
}

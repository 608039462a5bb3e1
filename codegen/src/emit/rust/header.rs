//! The comment at the top of an emitted file, with its origin and contents.

use super::functions::JACOBIANS;
use super::layout::broken;
use crate::emit::EmitOptions;
use crate::emit::c99::{EstimatorOptions, FilterCost, rust_filter_cost};
use crate::emit::text::comment_lines;
use machinist_contract::fixed_step::StepMethod;
use machinist_model::hoist::Hoisted;
use machinist_model::{Model, SparsityPattern, operations};

/// The first words of every emitted file, by which it is recognized.
pub(crate) const MARK: &str = "// Emitted by Machinist";

/// Returns the header of a scene's module.
pub(super) fn header(model: &Model, options: &EmitOptions) -> String {
    let mut lines = provenance(options);
    lines.push(String::new());
    lines.push("Sources, with SHA-256:".to_owned());
    lines.extend(model.files.iter().map(|file| format!("  {}  {}", file.sha256, file.label)));
    lines.push(String::new());
    lines.push(model.title.clone());
    lines.extend(section(&model.doc));
    if !model.source.trim().is_empty() {
        lines.push(String::new());
        lines.push("Source:".to_owned());
        lines.extend(comment_lines(&model.source).into_iter().map(|line| format!("  {line}")));
    }
    lines.push(String::new());
    lines.push("All quantities are in SI units.".to_owned());
    let lists =
        [("Shapes", shapes(model)), ("Nonzeros", sparsity(model)), ("Operations", costs(model))];
    for (title, items) in lists {
        let text = format!("{title}: {}.", items.join(", "));
        lines.extend(broken(&text, 0).into_iter().map(|line| line.trim_end().to_owned()));
    }
    as_comment(&lines)
}

/// Returns the header of the module that lists the scenes.
pub(super) fn index_header(options: &EmitOptions) -> String {
    as_comment(&provenance(options))
}

/// Returns the header of the module of a filter.
pub(super) fn estimator_header(
    model: &Model,
    (filter, method, bytes): (&EstimatorOptions, StepMethod, usize),
    options: &EmitOptions,
) -> String {
    let mut lines = provenance(options);
    lines.push(String::new());
    lines.push(format!("Extended Kalman filter: {}", model.title));
    let FilterCost { predict, correct } = rust_filter_cost(model, method, filter);
    lines.push(String::new());
    lines.push(format!("A prediction by {}:", method.meaning()));
    lines.push(format!("  {predict}."));
    lines.push(format!("A correction: at most {correct} operations."));
    lines.push(format!("An estimate with its workspace: {bytes} bytes."));
    format!("{}\n", as_comment(&lines))
}

fn provenance(options: &EmitOptions) -> Vec<String> {
    let version = env!("CARGO_PKG_VERSION");
    vec![
        format!("{} {version}; do not edit. To make it again:", &MARK[3..]),
        String::new(),
        format!("    {}", options.command),
    ]
}

fn section(text: &str) -> Vec<String> {
    let lines = comment_lines(text);
    if lines.is_empty() { lines } else { [vec![String::new()], lines].concat() }
}

fn shapes(model: &Model) -> Vec<String> {
    let counts = [
        ("coordinates", model.coordinates.len()),
        ("first-order states", model.first_order()),
        ("states", model.states.len()),
        ("parameters", model.all_parameters().count()),
        ("outputs", model.wanted.len()),
        ("discontinuities", model.discontinuities.results.len()),
        ("events", model.events.len()),
        ("constraints", model.constraints.len()),
        ("kinks", model.kink_guards.results.len()),
        ("relations", model.relations.len()),
        ("saturations", model.saturating_arguments.results.len()),
    ];
    let counts = counts.into_iter().filter(|(_, count)| *count > 0);
    counts.map(|(name, count)| format!("{name} {count}")).collect()
}

fn sparsity(model: &Model) -> Vec<String> {
    let rows = model.functions().filter_map(|row| Some((row.name, row.pattern?(model))));
    let rows = rows.map(|(name, pattern)| {
        let SparsityPattern { rows, columns, entries } = pattern;
        format!("{name} {} of {rows} by {columns}", entries.len())
    });
    rows.collect()
}

/// Returns the operations of each function, without constants and with them.
fn costs(model: &Model) -> Vec<String> {
    let rows = model.functions().map(|row| (row.name, operations((row.tape)(model))));
    let Hoisted { constants, rate, rate_jacobian, parameter_jacobian, jacobians, motion } =
        Hoisted::new(model);
    let by_parameters = if model.gives_jacobians_at_once() {
        (JACOBIANS, &jacobians)
    } else {
        ("prepared_parameter_jacobian", &parameter_jacobian)
    };
    let prepared = [
        ("prepare", &constants),
        ("prepared_rate", &rate),
        ("prepared_rate_jacobian", &rate_jacobian),
        by_parameters,
        ("motion", &motion),
    ];
    let has_constants = !constants.results.is_empty();
    let prepared = prepared.into_iter().filter(|_| has_constants);
    let prepared = prepared.map(|(name, tape)| (name, operations(tape)));
    let motion = model.motion.iter().map(|motion| ("motion", operations(&motion.tape)));
    let motion = motion.filter(|_| !has_constants);
    let rows = rows.chain(prepared).chain(motion).filter(|(_, count)| *count > 0);
    rows.map(|(name, count)| format!("{name} {count}")).collect()
}

/// Returns lines as `//` comments, each sanitized again because they contain names and units too.
fn as_comment(lines: &[String]) -> String {
    let mut text = String::new();
    for line in lines {
        let indent = line.len() - line.trim_start().len();
        let safe = comment_lines(line).join(" ");
        let line = format!("// {:indent$}{safe}", "");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

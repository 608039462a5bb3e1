//! The comment at the top of an emitted file: where it comes from and what is
//! in it.

use crate::emit::EmitOptions;
use crate::emit::text::comment_lines;
use machinist_model::hoist::Hoisted;
use machinist_model::{Model, SparsityPattern, operations};

/// The first words of every emitted file, by which it is recognised.
pub(crate) const MARK: &str = "// Emitted by Machinist";

/// Header of a scene's module.
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
    lines.extend(shapes(model));
    lines.push(String::new());
    lines.extend(states(model));
    lines.push(String::new());
    lines.extend(sparsity(model));
    lines.push(String::new());
    lines.push("Operations:".to_owned());
    lines.extend(
        model
            .functions()
            .map(|row| format!("  {:<20} {:>6}", row.name, operations((row.tape)(model)))),
    );
    if let Some(motion) = &model.motion {
        lines.push("Before those that read it:".to_owned());
        lines.push(format!("  {:<20} {:>6}", "motion", operations(&motion.tape)));
    }
    let Hoisted { constants, rate, rate_jacobian, motion } = Hoisted::new(model);
    if !constants.results.is_empty() {
        lines.push("With constants of the parameters, prepared once a run:".to_owned());
        let row = |name, tape| format!("  {name:<22} {:>4}", operations(tape));
        lines.push(row("prepare", &constants));
        lines.push(row("prepared_rate", &rate));
        lines.push(row("prepared_rate_jacobian", &rate_jacobian));
        if model.motion.is_some() {
            lines.push(row("motion", &motion));
        }
    }
    as_comment(&lines)
}

/// Header of the module that lists the scenes.
pub(super) fn index_header(options: &EmitOptions) -> String {
    as_comment(&provenance(options))
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
    let row = |name, count: usize| format!("  {name:<20} {count:>6}");
    let mut rows = vec![
        "Shapes; all quantities are in SI units:".to_owned(),
        row("coordinates", model.coordinates.len()),
        row("first-order states", model.first_order()),
        row("states", model.states.len()),
        row("parameters", model.all_parameters().count()),
        row("outputs", model.wanted.len()),
        row("discontinuities", model.discontinuities.results.len()),
    ];
    if !model.events.is_empty() {
        rows.push(row("events", model.events.len()));
    }
    if !model.constraints.is_empty() {
        rows.push(row("constraints", model.constraints.len()));
    }
    rows
}

/// The state as a table: index, name, unit, meaning.
fn states(model: &Model) -> Vec<String> {
    let width = |text: fn(&machinist_model::Quantity) -> &str| {
        model
            .states
            .iter()
            .map(|state| &state.quantity)
            .map(|quantity| text(quantity).chars().count())
            .max()
            .unwrap_or(0)
    };
    let name_width = width(|quantity| &quantity.name.path);
    let unit_width = width(|quantity| &quantity.unit) + 2;
    let rows =
        model.states.iter().map(|state| &state.quantity).enumerate().map(|(index, quantity)| {
            let unit = format!("[{}]", quantity.unit);
            let doc = comment_lines(&quantity.doc).join(" ");
            let row = format!(
                "  {index:>3}  {:<name_width$}  {unit:<unit_width$}  {doc}",
                quantity.name.path,
            );
            row.trim_end().to_owned()
        });
    std::iter::once("State:".to_owned()).chain(rows).collect()
}

fn sparsity(model: &Model) -> Vec<String> {
    let row = |name, pattern: &SparsityPattern| {
        let (rows, columns) = (pattern.rows, pattern.columns);
        format!("  {name:<20} {:>6} of {rows} by {columns}", pattern.entries.len())
    };
    vec![
        "Nonzeros:".to_owned(),
        row("mass_matrix", &model.mass_matrix.pattern),
        row("rate_jacobian", &model.rate_jacobian.pattern),
        row("parameter_jacobian", &model.parameter_jacobian.pattern),
    ]
}

/// Lines as `//` comments, each made harmless once more, for they hold names and
/// units too.
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

//! The header with description, structs and functions of the machine, and the frame of the
//! source.

use std::fmt::Write as _;

use machinist_model::functions::Gives;
use machinist_model::{Model, Quantity, SparsityPattern};

use super::functions::{Emitted, nonzeros};
use super::layout::{comment, remark, statement};
use super::{MARK, Real, Scene, estimator, events, helpers, solve, step};
use crate::emit::EmitError;

/// Returns the header of a scene.
pub(super) fn header(scene: &Scene<'_>, functions: &[Emitted]) -> String {
    let guard = scene.macro_name("H");
    let declared = functions.iter().filter(|function| !function.is_local);
    let declared: Vec<String> = declared.map(Emitted::declaration).collect();
    let parts = [
        comment(provenance(scene)),
        format!("#ifndef {guard}\n#define {guard}\n\n#include <stdint.h>\n"),
        "#ifdef __cplusplus\nextern \"C\" {\n#endif\n".to_owned(),
        sizes(scene),
        structs(scene),
        patterns(scene, true),
        declared.join("\n"),
        events::declarations(scene),
        step::declarations(scene),
        estimator::declarations(scene),
        "#ifdef __cplusplus\n}\n#endif\n".to_owned(),
        format!("#endif /* {guard} */\n"),
    ];
    joined(&parts)
}

/// Returns the source of a scene.
pub(super) fn source(scene: &Scene<'_>, functions: &[Emitted]) -> Result<String, EmitError> {
    let name = &scene.model.name;
    let definitions: Vec<String> = functions.iter().map(Emitted::definition).collect();
    let parts = [
        comment([format!("{}; see {name}.h.", first_line())]),
        format!(
            "#include \"{name}.h\"\n\n#include <float.h>\n#include <math.h>\n#include <stddef.h>\n\
             #include <string.h>\n"
        ),
        "/* A product and a sum that are fused are rounded once, and so differ in the last digit. \
         */\n#ifdef __clang__\n#pragma STDC FP_CONTRACT OFF\n#endif\n"
            .to_owned(),
        helpers::helpers(scene)?,
        solve::items(scene),
        patterns(scene, false),
        definitions.join("\n"),
        events::definitions(scene)?,
        step::definitions(scene)?,
    ];
    Ok(joined(&parts))
}

/// Joins nonempty parts, with an empty line between them.
fn joined(parts: &[String]) -> String {
    let parts: Vec<&str> =
        parts.iter().map(|part| part.trim_end()).filter(|part| !part.is_empty()).collect();
    format!("{}\n", parts.join("\n\n"))
}

pub(super) fn first_line() -> String {
    format!("{MARK} {}; do not edit", env!("CARGO_PKG_VERSION"))
}

/// Returns origin and content of the file.
fn provenance(scene: &Scene<'_>) -> Vec<String> {
    let model = scene.model;
    let mut lines = vec![format!("{}. To make it again:", first_line()), String::new()];
    lines.push(format!("    {}", scene.options.command));
    lines.extend([String::new(), "Sources, with SHA-256:".to_owned()]);
    lines.extend(model.files.iter().map(|file| format!("  {}  {}", file.sha256, file.label)));
    lines.extend([String::new(), model.title.clone(), String::new()]);
    lines.extend(model.doc.lines().map(str::to_owned));
    if !model.source.trim().is_empty() {
        lines.extend([String::new(), format!("Source: {}", model.source.trim())]);
    }
    lines.push(String::new());
    lines.push("All quantities are in SI units.".to_owned());
    lines.push(match scene.options.real {
        Real::Double => "The functions give the bits of the Rust that Machinist emits, but for \
                         ln, pow, tan, inverse and hyperbolic functions (the C library's) and \
                         where the compiler fuses products and sums: -ffp-contract=off."
            .to_owned(),
        Real::Float => "Numbers are float: relative errors of 6e-8 an operation.".to_owned(),
    });
    lines
}

/// Returns macros for the numbers of states, parameters, outputs and so on.
fn sizes(scene: &Scene<'_>) -> String {
    let model = scene.model;
    let resets: usize = model.events.iter().map(|event| event.sets.len()).sum();
    let counts = [
        ("STATES", model.states.len()),
        ("COORDINATES", model.coordinates.len()),
        ("PARAMETERS", model.parameters.len()),
        ("OUTPUTS", model.wanted.len()),
        ("DISCONTINUITIES", model.discontinuities.results.len()),
        ("EVENTS", model.events.len()),
        ("RESETS", resets),
        ("CONSTRAINTS", model.constraints.len()),
        ("KINKS", model.kink_guards.results.len()),
    ];
    let counts = counts.into_iter().map(|(name, count)| (scene.macro_name(name), count));
    let matrices = model.functions().filter_map(|row| {
        let pattern = row.pattern?(model);
        Some((nonzeros(scene, row.name), pattern.entries.len()))
    });
    let mut text = String::from("/* Numbers of everything. */\n");
    for (name, count) in counts.chain(matrices).filter(|(_, count)| *count > 0) {
        let _ = writeln!(text, "#define {name} {count}u");
    }
    text
}

/// Returns a struct of quantities.
fn structure(scene: &Scene<'_>, name: &str, doc: &str, members: &[(String, String)]) -> String {
    let real = scene.real();
    let mut text = comment([doc]);
    text.push_str("typedef struct {\n");
    for (member, meaning) in members {
        let _ = writeln!(text, "    {real} {member}; {}", remark(meaning));
    }
    if members.is_empty() {
        text.push_str("    char none; /* there are no numbers here */\n");
    }
    let _ = writeln!(text, "}} {};", scene.public(name));
    text
}

/// Returns name, meaning and unit of a quantity.
pub(super) fn meaning(quantity: &Quantity) -> String {
    let Quantity { name, unit, doc } = quantity;
    let doc = doc.trim().trim_end_matches('.');
    if doc.is_empty() {
        format!("{} [{unit}]", name.path)
    } else {
        format!("{}: {doc} [{unit}]", name.path)
    }
}

fn structs(scene: &Scene<'_>) -> String {
    let model = scene.model;
    let states = scene.state_members.iter().zip(&model.states).enumerate();
    let states: Vec<(String, String)> = states
        .map(|(entry, (name, state))| {
            let mode = if scene.is_mode(entry) { ", a mode: only events change it" } else { "" };
            (name.clone(), format!("{}{mode}", meaning(&state.quantity)))
        })
        .collect();
    let parameters = scene.parameter_members.iter().zip(&model.parameters);
    let parameters: Vec<(String, String)> =
        parameters.map(|(name, p)| (name.clone(), meaning(&p.quantity))).collect();
    let outputs = scene.output_members.iter().zip(&model.wanted);
    let outputs: Vec<(String, String)> =
        outputs.map(|(name, output)| (name.clone(), meaning(output))).collect();
    let constants: Vec<(String, String)> = scene
        .constants
        .iter()
        .map(|name| (name.clone(), format!("see {}", scene.public("prepare"))))
        .collect();
    let fields = |fields: &[(&str, &str)]| -> Vec<(String, String)> {
        fields.iter().map(|&(name, doc)| (name.to_owned(), doc.to_owned())).collect()
    };
    let energy = fields(&[
        ("kinetic", "T [J]"),
        ("potential", "V [J]"),
        ("stored", "energy of first-order states [J]"),
    ]);
    let power = fields(&[
        ("stored_rate", "dE/dt [W]"),
        ("supplied", "power supplied [W]"),
        ("dissipated", "power dissipated [W]"),
    ]);
    let state_doc = "The state. As a rate, each member is the rate of the state of its name.";
    let constants_doc = "What parameters alone decide.";
    let outputs_doc = "Wanted outputs.";
    [
        structure(scene, "state_t", state_doc, &states),
        structure(scene, "parameters_t", "Parameters.", &parameters),
        structure(scene, "constants_t", constants_doc, &constants),
        structure(scene, "outputs_t", outputs_doc, &outputs),
        structure(scene, "energy_t", "Energy stored in the machine.", &energy),
        structure(scene, "power_balance_t", "Power: dE/dt = supplied - dissipated.", &power),
    ]
    .join("\n")
}

/// Returns rows and columns of the nonzeros of every matrix, as declarations or definitions.
fn patterns(scene: &Scene<'_>, is_declared: bool) -> String {
    let model = scene.model;
    let mut text = String::new();
    for row in model.functions() {
        let (Gives::Matrix(_), Some(pattern)) = (row.gives, row.pattern) else { continue };
        let pattern = pattern(model);
        if pattern.entries.is_empty() {
            continue;
        }
        let [rows, columns] = [("rows", 0), ("columns", 1)].map(|(what, which)| {
            let name = scene.public(&format!("{}_{what}", row.name));
            list(scene, &name, &nonzeros(scene, row.name), pattern, which, is_declared)
        });
        if is_declared {
            let SparsityPattern { rows, columns, .. } = pattern;
            let meaning = format!("Nonzeros of {}, {rows} by {columns}, row by row.", row.meaning);
            text.push_str(&comment([meaning]));
        }
        text.push_str(&rows);
        text.push_str(&columns);
    }
    text
}

fn list(
    scene: &Scene<'_>,
    name: &str,
    size: &str,
    pattern: &SparsityPattern,
    which: usize,
    is_declared: bool,
) -> String {
    let kind = scene.index_type();
    if is_declared {
        return format!("extern const {kind} {name}[{size}];\n");
    }
    let entries = pattern.entries.iter().map(|&(row, column)| [row, column][which].to_string());
    let entries = statement(&entries.collect::<Vec<_>>().join(", "), 4);
    format!("const {kind} {name}[{size}] = {{\n{entries}}};\n")
}

/// Reports whether a run of a model starts on constraints or in equilibrium, so that its initial
/// values are not sufficient.
#[must_use]
pub fn needs_start(model: &Model) -> bool {
    model.starts_in_equilibrium || !model.constraints.is_empty()
}

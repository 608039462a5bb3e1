//! Data of events besides guards and resets: modes in which they are active, and states they set.

use std::fmt::Write as _;

use machinist_contract::{Constraint, Jumps};
use machinist_model::{Direction, Model};

use super::Scene;
use super::expression::literal;
use super::functions::broken_head;
use super::layout::{comment, remark, statement};
use crate::emit::EmitError;

/// Returns the constants and declarations of the events; empty for a scene without events.
pub(super) fn declarations(scene: &Scene<'_>) -> String {
    let model = scene.model;
    if model.events.is_empty() {
        return String::new();
    }
    let mut text = comment(["Events."]);
    text.push_str("enum {\n");
    let last = model.events.len() - 1;
    for (index, event) in model.events.iter().enumerate() {
        let name = scene.macro_name(&format!("EVENT_{}", event.name.ident.to_ascii_uppercase()));
        let comma = if index < last { "," } else { "" };
        let doc = event.doc.trim();
        let meaning = if doc.is_empty() { String::new() } else { format!(": {doc}") };
        let direction = match event.direction {
            Direction::Rising => "where its guard rises",
            Direction::Falling => "where its guard falls",
            Direction::Both => "where its guard passes zero either way",
        };
        let remark = remark(&format!("{}, {direction}{meaning}", event.name.path));
        let _ = writeln!(text, "    {name} = {index}{comma} {remark}");
    }
    text.push_str("};\n\n");
    text.push_str(&comment(["Whether an event is watched for in the modes of a state."]));
    let _ = writeln!(text, "{};\n", watched_head(scene));
    text.push_str(&comment([
        "Gives the new values of an event to a state, computed from the state before it.",
    ]));
    let _ = writeln!(text, "{};", apply_head(scene));
    if has_jumping_friction(model) {
        text.push('\n');
        text.push_str(&comment([
            "Lets dry friction begin anew where its speed may jump in time: its force is finite.",
        ]));
        let _ = writeln!(text, "{};", reopen_head(scene));
    }
    text
}

fn watched_head(scene: &Scene<'_>) -> String {
    let (name, state) = (scene.public("is_watched"), scene.public("state_t"));
    format!("int {name}(unsigned int event, const {state} *state)")
}

fn apply_head(scene: &Scene<'_>) -> String {
    broken_head(&format!(
        "void {}(unsigned int event, {} time, {} *state, const {} *p, const {} *c)",
        scene.public("apply"),
        scene.real(),
        scene.public("state_t"),
        scene.public("parameters_t"),
        scene.public("constants_t")
    ))
}

/// Returns the definitions of the functions declared above.
pub(super) fn definitions(scene: &Scene<'_>) -> Result<String, EmitError> {
    if scene.model.events.is_empty() {
        return Ok(String::new());
    }
    let reopen = if has_jumping_friction(scene.model) { reopen(scene) } else { String::new() };
    Ok(format!("{}\n{}{reopen}", watched(scene)?, apply(scene)))
}

fn watched(scene: &Scene<'_>) -> Result<String, EmitError> {
    let model = scene.model;
    let is_read = model.events.iter().any(|event| !event.when.is_empty());
    let mut text = format!("{}\n{{\n", watched_head(scene));
    if !is_read {
        text.push_str("    (void)state;\n");
    }
    text.push_str("    switch (event) {\n");
    for (index, event) in model.events.iter().enumerate() {
        let when = event.when.iter().map(|&(entry, value)| {
            let value = literal(value, scene.options.real, "is_watched")?.text;
            Ok(format!("(state->{} == {value})", scene.state_members[entry as usize]))
        });
        let when = when.collect::<Result<Vec<_>, EmitError>>()?;
        let when = if when.is_empty() { "1".to_owned() } else { when.join(" && ") };
        let _ = writeln!(text, "    case {index}u:");
        text.push_str(&statement(&format!("return {when};"), 8));
    }
    text.push_str("    default:\n        return 0;\n    }\n}\n");
    Ok(text)
}

/// Returns whether there is dry friction whose speed jumps in time.
pub(super) fn has_jumping_friction(model: &Model) -> bool {
    !model.discontinuities.results.is_empty() && jumping_frictions(model).next().is_some()
}

/// Returns the modes of dry friction whose speed may jump in time.
pub(super) fn jumping_frictions(model: &Model) -> impl Iterator<Item = u32> {
    let jumping = model.constraints.iter().filter(|it| it.jumps == Jumps::InTime);
    jumping.filter_map(|constraint| constraint.friction)
}

fn reopen_head(scene: &Scene<'_>) -> String {
    format!("void {}({} *state)", scene.public("reopen_frictions"), scene.public("state_t"))
}

fn reopen(scene: &Scene<'_>) -> String {
    let mut text = format!("\n{}\n{{\n", reopen_head(scene));
    let open = scene.options.real.literal(Constraint::OPEN).expect("a small integer");
    for mode in jumping_frictions(scene.model) {
        let _ = writeln!(text, "    state->{} = {open};", scene.state_members[mode as usize]);
    }
    text.push_str("}\n");
    text
}

fn apply(scene: &Scene<'_>) -> String {
    let model = scene.model;
    let resets: usize = model.events.iter().map(|event| event.sets.len()).sum();
    let mut text = format!("{}\n{{\n", apply_head(scene));
    if resets == 0 {
        text.push_str("    (void)event;\n    (void)time;\n    (void)state;\n");
        text.push_str("    (void)p;\n    (void)c;\n}\n");
        return text;
    }
    let (real, count) = (scene.real(), scene.macro_name("RESETS"));
    let _ = writeln!(text, "    {real} values[{count}];\n");
    let _ = writeln!(text, "    {}(time, state, p, c, values);", scene.public("resets"));
    text.push_str("    switch (event) {\n");
    let mut place = 0;
    for (index, event) in model.events.iter().enumerate() {
        if event.sets.is_empty() {
            continue;
        }
        let _ = writeln!(text, "    case {index}u:");
        for &entry in &event.sets {
            let member = &scene.state_members[entry as usize];
            let _ = writeln!(text, "        state->{member} = values[{place}];");
            place += 1;
        }
        text.push_str("        break;\n");
    }
    text.push_str("    default:\n        break;\n    }\n}\n");
    text
}

//! Description of a machine in its module: rows of the contract's macros, one per line. The
//! types, the statics and the implementations of the contract follow from them.

use std::fmt::Write as _;

use proc_macro2::{Ident, Literal};

use super::Scene;
use super::layout::broken;
use super::names::{Namer, constant_name};
use super::series::Series;
use crate::emit::EmitError;
use crate::emit::literal::literal_text;
use crate::emit::text::{markdown, markdown_line};
use machinist_contract::Jumps;
use machinist_model::{Direction, Quantity, SparsityPattern, StateKind};

/// Returns everything except the functions.
pub(super) fn description(scene: &Scene<'_>, series: Option<&Series>) -> Result<String, EmitError> {
    let parts = [
        call("simulator", &simulator(scene, series)?),
        call("parameters", &parameters(scene)?),
        call("outputs", &outputs(scene)),
        call("states", &states(scene)?),
        coordinates(scene),
        events(scene)?,
        constraints(scene),
        relations(scene),
        call("patterns", &patterns(scene)),
        constants(scene),
    ];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    Ok(parts.join("\n"))
}

/// Returns a call of a macro of the contract.
pub(super) fn call(name: &str, rows: &[String]) -> String {
    if rows.is_empty() {
        return format!("::machinist_contract::{name}! {{}}\n");
    }
    let mut text = format!("::machinist_contract::{name}! {{\n");
    for row in rows {
        let _ = writeln!(text, "    {row}");
    }
    text.push_str("}\n");
    text
}

fn simulator(scene: &Scene<'_>, series: Option<&Series>) -> Result<Vec<String>, EmitError> {
    let model = scene.model;
    let mut rows: Vec<String> = docs(scene).iter().map(|line| comment(line)).collect();
    rows.push(format!("{}: {}, {};", scene.machine, string(&model.name), string(&model.title)));
    let run = &model.run;
    let [from, until, rtol] = [run.from, run.until, run.rtol].map(|value| number("run", value));
    let times = run.times.iter().map(|time| number("run", *time)).collect::<Result<Vec<_>, _>>()?;
    let times =
        if times.is_empty() { String::new() } else { format!(", times [{}]", times.join(", ")) };
    rows.push(format!(
        "run from {}, until {}, points {}, rtol {}, method {}{times};",
        from?,
        until?,
        run.points,
        rtol?,
        string(&run.method),
    ));
    let jumps = model.discontinuities.results.len();
    rows.push(format!("quadratures {}, discontinuities {jumps};", model.quadratures));
    let has_borders = model.kink_guards.results.len() > model.relations.len();
    let at_once = scene.gives_jacobians_at_once();
    let parts = [
        ("coordinates;", !model.is_whole()),
        ("events;", !model.events.is_empty()),
        ("constraints;", !model.constraints.is_empty()),
        ("equilibrium;", model.starts_in_equilibrium),
        ("inertia_corners;", has_borders && model.inertia_has_corners()),
        ("prepared;", !scene.prepare.is_empty()),
        ("jacobians_at_once;", at_once),
        ("jacobians_apart;", !scene.prepare.is_empty() && !at_once),
        ("linear;", model.excitation.is_some()),
    ];
    let parts =
        parts.into_iter().filter(|(_, is_there)| *is_there).map(|(part, _)| part.to_owned());
    let counted = [
        ("kinks", model.kink_guards.results.len()),
        ("saturations", model.saturating_arguments.results.len()),
    ];
    let counted = counted.into_iter().filter(|(_, count)| *count > 0);
    let counted = counted.map(|(part, count)| format!("{part} {count};"));
    let relations = (!model.relations.is_empty()).then(|| "relations;".to_owned());
    let parts: Vec<String> =
        parts.chain(counted).chain(relations).chain(series.map(Series::part)).collect();
    if !parts.is_empty() {
        rows.push(parts.join(" "));
    }
    Ok(rows)
}

/// Returns title, meaning and source of the machine, in Markdown.
fn docs(scene: &Scene<'_>) -> Vec<String> {
    let model = scene.model;
    let mut lines = vec![markdown_line(&model.title), String::new()];
    lines.extend(markdown(&model.doc));
    if !model.source.trim().is_empty() {
        lines.push(String::new());
        lines.push(format!("Source: {}", markdown_line(&model.source)));
    }
    if lines[0].is_empty() {
        lines[0] = format!("The machine `{}`.", model.name);
    }
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    lines
}

/// Returns a line of documentation.
fn comment(line: &str) -> String {
    format!("/// {line}").trim_end().to_owned()
}

fn parameters(scene: &Scene<'_>) -> Result<Vec<String>, EmitError> {
    let rows = scene.model.all_parameters().zip(&scene.parameters).map(|(parameter, name)| {
        let quantity = &parameter.quantity;
        let place = format!("parameter `{}`", quantity.name.path);
        Ok(format!("{name}: {}, {}", number(&place, parameter.value)?, columns(quantity)))
    });
    let slots = &scene.parameters[scene.model.slots().start..];
    let slots = scene.model.relations.iter().zip(slots);
    rows.chain(slots.map(|(relation, name)| Ok(format!("@ {name}: {:?};", relation.kind))))
        .collect()
}

/// Returns the relations; empty for a scene without relations.
fn relations(scene: &Scene<'_>) -> String {
    let relations = &scene.model.relations;
    if relations.is_empty() {
        return String::new();
    }
    let rows = relations.iter().map(|relation| {
        let readers = relation.readers.iter().map(|reader| format!("{reader:?}"));
        format!("{:?} [{}];", relation.kind, readers.collect::<Vec<_>>().join(", "))
    });
    call("relations", &rows.collect::<Vec<_>>())
}

fn outputs(scene: &Scene<'_>) -> Vec<String> {
    let rows = (0..).zip(scene.model.wanted.iter().zip(&scene.outputs));
    let row = |(index, (output, name)): (u32, (&Quantity, &Ident))| {
        let at_once = if scene.model.at_once.contains(&index) { "at_once " } else { "" };
        format!("{name}: {at_once}{}", columns(output))
    };
    rows.map(row).collect()
}

fn states(scene: &Scene<'_>) -> Result<Vec<String>, EmitError> {
    // Otherwise nothing changes initial values that the spec does not give.
    let has_guesses = !scene.model.constraints.is_empty() || scene.model.starts_in_equilibrium;
    let mut namer = Namer::empty();
    let rows = scene.model.states.iter().map(|state| {
        let kind = match state.kind {
            StateKind::Position(_) => "position",
            StateKind::Velocity(_) => "velocity",
            StateKind::FirstOrder => "first_order",
            StateKind::Mode => "mode",
        };
        let guess = if has_guesses && !state.is_given { " guess" } else { "" };
        let scale = number("scale of a state", state.scale)?;
        let name = namer.claim(&constant_name(&state.quantity.name.ident));
        Ok(format!("{name}: {kind}{guess}, {scale}, {}", columns(&state.quantity)))
    });
    rows.collect()
}

/// Returns the coordinates; empty if the state of the scene begins with all of them.
fn coordinates(scene: &Scene<'_>) -> String {
    if scene.model.is_whole() {
        return String::new();
    }
    let rows = scene.model.coordinates.iter().map(|coordinate| {
        let Quantity { name, unit, doc } = &coordinate.position;
        format!("{}, {}, {};", string(&name.path), string(unit), string(doc))
    });
    call("coordinates", &rows.collect::<Vec<_>>())
}

/// Returns the events; empty for a scene without events.
fn events(scene: &Scene<'_>) -> Result<String, EmitError> {
    let events = &scene.model.events;
    if events.is_empty() {
        return Ok(String::new());
    }
    let flags = scene.model.counters().into_iter().zip(scene.model.events_that_move_their_guard());
    let rows = events.iter().zip(flags).map(|(event, flags)| {
        let direction = match event.direction {
            Direction::Rising => "Rising",
            Direction::Falling => "Falling",
            Direction::Both => "Both",
        };
        let when = event
            .when
            .iter()
            .map(|(mode, value)| Ok(format!("({mode}, {})", number("mode of an event", *value)?)));
        let when = when.collect::<Result<Vec<_>, EmitError>>()?.join(", ");
        let sets = event.sets.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
        let (name, doc) = (string(&event.name.path), string(&event.doc));
        let flag = match flags {
            (true, _) => " counts",
            (_, true) => " moves_guard",
            _ => "",
        };
        Ok(format!("{name}: {direction}{flag}, when [{when}], sets [{sets}], {doc};"))
    });
    Ok(call("events", &rows.collect::<Result<Vec<_>, EmitError>>()?))
}

/// Returns the constraints; empty for a scene without constraints.
fn constraints(scene: &Scene<'_>) -> String {
    let constraints = &scene.model.constraints;
    if constraints.is_empty() {
        return String::new();
    }
    let rows = constraints.iter().map(|constraint| {
        let kind = match (constraint.is_of_positions, constraint.in_modes, constraint.friction) {
            (_, _, Some(mode)) => {
                let suffix = match constraint.jumps {
                    Jumps::Nowhere => "",
                    Jumps::InTime => "_in_time",
                    Jumps::AtPlaces => "_at_places",
                };
                format!("of_friction{suffix}({mode})")
            }
            (true, false, _) => "of_positions".to_owned(),
            (false, false, _) => "of_velocities".to_owned(),
            (true, true, _) => "of_positions_in_modes".to_owned(),
            (false, true, _) => "of_velocities_in_modes".to_owned(),
        };
        let [name, unit, doc] =
            [&constraint.name.path, &constraint.unit, &constraint.doc].map(|text| string(text));
        format!("{name}: {kind}, {unit}, {doc};")
    });
    call("constraints", &rows.collect::<Vec<_>>())
}

fn patterns(scene: &Scene<'_>) -> Vec<String> {
    let model = scene.model;
    let mut rows = Vec::new();
    for row in model.functions() {
        if let (machinist_model::functions::Gives::Matrix(name), Some(pattern)) =
            (row.gives, row.pattern)
        {
            rows.push(comment(&format!("Nonzeros of {}.", row.meaning)));
            rows.extend(pattern_rows(name, pattern(model)));
        }
    }
    rows
}

/// Returns `NAME: rows by columns { row [column column] .. }`, as many rows on a line as fit.
fn pattern_rows(name: &str, pattern: &SparsityPattern) -> Vec<String> {
    let mut rows: Vec<(u32, Vec<String>)> = Vec::new();
    for &(row, column) in &pattern.entries {
        match rows.last_mut() {
            Some((last, columns)) if *last == row => columns.push(column.to_string()),
            _ => rows.push((row, vec![column.to_string()])),
        }
    }
    let rows = rows.iter().map(|(row, columns)| format!("{row} [{}]", columns.join(" ")));
    let rows = rows.collect::<Vec<_>>().join(" ");
    let text = format!("{name}: {} by {} {{ {rows} }}", pattern.rows, pattern.columns);
    broken(&text, 4)
        .into_iter()
        .enumerate()
        .map(|(index, line)| {
            // The call adds the margin of the first line.
            if index == 0 { line.trim_start().to_owned() } else { line[4..].to_owned() }
        })
        .collect()
}

/// Returns the constants; empty if nothing is computed once a run.
fn constants(scene: &Scene<'_>) -> String {
    let constants = &scene.prepare.constants;
    if constants.is_empty() {
        return String::new();
    }
    let names: Vec<String> = constants.iter().map(Ident::to_string).collect();
    let lines = broken(&names.join(", "), 0);
    call("constants", &lines.iter().map(|line| line.trim().to_owned()).collect::<Vec<_>>())
}

/// Returns unit, name and meaning, and documentation text if these are not valid in Markdown.
fn columns(quantity: &Quantity) -> String {
    let Quantity { name, unit, doc } = quantity;
    let path = &name.path;
    let is_fit = [path, unit, doc].into_iter().all(|text| markdown_line(text) == *text);
    let markdown =
        if is_fit { String::new() } else { format!(" as {}", string(&meaning(quantity))) };
    format!("{}, {}, {}{markdown};", string(unit), string(path), string(doc))
}

/// Returns meaning and unit of a quantity, one line of Markdown.
pub(super) fn meaning(quantity: &Quantity) -> String {
    let doc = markdown_line(&quantity.doc);
    let path = markdown_line(&quantity.name.path);
    let what = if doc.is_empty() { path } else { format!("{path}: {doc}") };
    format!("{what} \\[{}\\].", markdown_line(&quantity.unit))
}

/// Returns the literal of a text.
pub(super) fn string(text: &str) -> String {
    Literal::string(text).to_string()
}

/// Returns the literal of a number.
pub(super) fn number(place: &str, value: f64) -> Result<String, EmitError> {
    literal_text(value).map_err(|_| EmitError::NotFinite { place: place.to_owned(), value })
}

//! `machinist show`: the contents of a scene, before anything is derived or run.

mod description;
#[cfg(feature = "derive")]
mod of_spec;

use std::fmt::Write as _;

use clap::Args;

use super::output::print;
use super::scene::SceneSource;
use super::table::{SECTION, columns_of_section as columns, paragraph};
use crate::failure::Failure;
use crate::number::{exact, number};
use crate::spec_source::SpecSource;
use description::{Check, Constraint, Description, Event, Instance, Kind, Parameter, State};

/// Digits of computed values; more would show rounding.
const DIGITS: usize = 12;

#[derive(Debug, Args)]
pub struct Show {
    /// Name or file of the scene, or a model file
    scene: String,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
}

impl Show {
    pub fn execute(&self) -> Result<(), Failure> {
        let description = match SceneSource::of(&self.scene)? {
            SceneSource::Spec(source) => of_spec(&source)?,
            SceneSource::Model(stamped) => Description::of_model(&stamped.model),
        };
        if self.json {
            let text = serde_json::to_string_pretty(&description)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        print(&as_text(&description))
    }
}

#[cfg(feature = "derive")]
fn of_spec(source: &SpecSource) -> Result<Description, Failure> {
    let spec = source.read()?;
    let system = machinist_codegen::scene::compose(&spec)?;
    Ok(Description::of_spec(&spec, &system))
}

#[cfg(not(feature = "derive"))]
fn of_spec(source: &SpecSource) -> Result<Description, Failure> {
    Err(super::scene::cannot_derive(source))
}

fn as_text(scene: &Description) -> String {
    let mut text = paragraph(&format!("{}: {}", scene.scene, scene.title));
    if !scene.doc.trim().is_empty() {
        text.push('\n');
        text.extend(scene.doc.trim().lines().map(paragraph));
    }
    if !scene.source.trim().is_empty() {
        text.push_str(&paragraph(&format!("Source: {}", scene.source.trim())));
    }
    let mut section = |heading: &str, rows: String| {
        if !rows.is_empty() {
            let _ = writeln!(text, "\n{heading}");
            for line in rows.lines() {
                let _ = writeln!(text, "{SECTION}{line}");
            }
        }
    };
    section("Units", columns(&scene.instances.iter().map(unit).collect::<Vec<_>>(), 3));
    section("Ports", columns(&ports(&scene.instances), 4));
    section("Inputs", columns(&inputs(&scene.instances), 3));
    section("Joints", joints(scene));
    section("Parameters", columns(&scene.parameters.iter().map(parameter).collect::<Vec<_>>(), 4));
    section("Fields", columns(&fields(scene), 4));
    let is_mode = |state: &&State| state.kind == Kind::Mode;
    let [states, modes]: [Vec<_>; 2] = [
        scene.states.iter().filter(|state| !is_mode(state)).map(state).collect(),
        scene.states.iter().filter(is_mode).map(state).collect(),
    ];
    section("States, with their values at the start", columns(&states, 4));
    section("Modes, with their values at the start", columns(&modes, 4));
    let outputs = scene.outputs.iter();
    let outputs = outputs.map(|one| [one.name.clone(), one.unit.clone(), one.doc.clone()]);
    section("Outputs", columns(&outputs.collect::<Vec<_>>(), 3));
    section("Events", columns(&scene.events.iter().map(event).collect::<Vec<_>>(), 4));
    section(
        "Constraints",
        columns(&scene.constraints.iter().map(constraint).collect::<Vec<_>>(), 3),
    );
    section("Loops", scene.loops.join("\n"));
    section("Checks", columns(&scene.checks.iter().map(check).collect::<Vec<_>>(), 3));
    section("Taken for rigid", scene.rigid.join(", "));
    let run = &scene.run;
    let line = format!(
        "{} s to {} s, {} points{}, rtol {:e}, method {}",
        run.from,
        run.until,
        run.points,
        if run.times.is_empty() { "" } else { " not equally spaced" },
        run.rtol,
        run.method
    );
    section("Run", line);
    text
}

fn unit(instance: &Instance) -> [String; 3] {
    [instance.name.clone(), instance.unit.clone(), instance.title.clone()]
}

fn ports(instances: &[Instance]) -> Vec<[String; 3]> {
    let ports = instances.iter().flat_map(|instance| {
        let row = |port: &description::Port| {
            let name = format!("{}.{}", instance.name, port.name);
            [name, port.kind.to_owned(), format!("moves by {}", port.moves)]
        };
        instance.ports.iter().map(row).collect::<Vec<_>>()
    });
    ports.collect()
}

fn inputs(instances: &[Instance]) -> Vec<[String; 3]> {
    let inputs = instances.iter().flat_map(|instance| {
        let row = |input: &description::Input| {
            let name = format!("{}.{}", instance.name, input.name);
            [name, input.unit.clone(), format!("= {}", input.expression)]
        };
        instance.inputs.iter().map(row).collect::<Vec<_>>()
    });
    inputs.collect()
}

fn joints(scene: &Description) -> String {
    let line = |joint: &description::Joint| {
        let [first, second] = &joint.connect;
        match joint.ratio.as_str() {
            "1" => format!("{first} = {second}\n"),
            ratio => format!("{first} = ({ratio})*{second}\n"),
        }
    };
    scene.joints.iter().map(line).collect()
}

fn parameter(parameter: &Parameter) -> [String; 4] {
    let quantity = &parameter.quantity;
    let doc = if parameter.tunable { "" } else { " (not tunable)" };
    let doc = format!("{}{doc}", quantity.doc);
    [quantity.name.clone(), exact(parameter.value), quantity.unit.clone(), doc]
}

fn fields(scene: &Description) -> Vec<[String; 4]> {
    let row = |field: &description::Field| {
        let quantity = &field.quantity;
        let cut = format!(
            "over {} m, {} elements of order {}",
            exact(field.length),
            field.elements,
            field.order
        );
        [quantity.name.clone(), quantity.unit.clone(), cut, quantity.doc.clone()]
    };
    scene.fields.iter().map(row).collect()
}

fn state(state: &State) -> [String; 4] {
    let quantity = &state.quantity;
    let initial =
        if state.initial.is_nan() { "?".to_owned() } else { number(state.initial, DIGITS) };
    let initial = if state.is_guess { format!("{initial} (guess)") } else { initial };
    let mut doc = quantity.doc.clone();
    if !state.joined.is_empty() {
        let joined = state.joined.join(", ");
        let joined = format!("with {joined}");
        doc = if doc.is_empty() { joined } else { format!("{doc}; {joined}") };
    }
    [quantity.name.clone(), initial, quantity.unit.clone(), doc]
}

fn event(event: &Event) -> [String; 4] {
    let guard = event.guard.as_deref().unwrap_or("its guard");
    let passes = match event.direction {
        "rising" => "rises through 0",
        "falling" => "falls through 0",
        _ => "passes 0",
    };
    let set = event.set.iter().map(|(name, value)| match value {
        Some(value) => format!("{name} := {value}"),
        None => format!("sets {name}"),
    });
    let set = set.collect::<Vec<_>>().join(", ");
    [event.name.clone(), format!("{guard} {passes}{}", during(&event.when)), set, event.doc.clone()]
}

/// Formats the modes in which something applies.
fn during(when: &[(String, i32)]) -> String {
    let modes: Vec<String> =
        when.iter().map(|(mode, value)| format!("{mode} is {value}")).collect();
    if modes.is_empty() { String::new() } else { format!(", while {}", modes.join(" and ")) }
}

fn constraint(constraint: &Constraint) -> [String; 3] {
    let expression = constraint.expression.as_deref();
    let equation = expression.map_or_else(String::new, |left| format!("{left} = 0"));
    [
        constraint.name.clone(),
        format!("{equation}{}", during(&constraint.when)),
        constraint.doc.clone(),
    ]
}

fn check(check: &Check) -> [String; 3] {
    let absolute = check.absolute.map_or_else(String::new, |size| format!(" or {size:e}"));
    let within = format!("within {:e}{absolute}", check.tolerance);
    [check.name.clone(), format!("{} = {}", check.of, check.reference), within]
}

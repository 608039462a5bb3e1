//! `machinist explain`: the reduction of a scene, with reasons and savings.

use clap::Args;
use machinist_codegen::lower::structure::Frequency;
use machinist_codegen::pipeline::Stages;
use serde_json::{Value, json};

use super::arguments::SourceArgs;
use super::output::{columns, print};
use super::scene::{SceneSource, already_reduced};
use super::table::{SECTION, indented, paragraph, width};
use crate::deriving::{self, Purpose};
use crate::explain::{Divided, DividedField, DividedRun, Explanation, Times};
use crate::failure::Failure;
use crate::freeze::{Candidate, admit};
use crate::number::number;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Explain {
    /// Do not run the scene to compare times, nor compile it to compare sizes
    #[arg(long)]
    without_times: bool,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SourceArgs,
}

impl Explain {
    pub fn execute(&self) -> Result<(), Failure> {
        let SourceArgs { scene, keep, .. } = &self.scene;
        let (is_whole, keep) = (keep.keep_all, self.scene.keep());
        let (source, stages) = match self.scene.given()? {
            SceneSource::Spec(source) => {
                let stages = deriving::derivation(&source, keep, Purpose::Running)?.stages;
                if !is_whole {
                    admit(&source, stages.needed())?;
                }
                (Some(source), stages)
            }
            SceneSource::Model(_) if is_whole => return Err(already_reduced(scene)),
            SceneSource::Model(stamped) => {
                (None, Stages { whole: stamped.model, steps: Vec::new() })
            }
        };
        let explanation =
            during("running", || Explanation::new(source.as_ref(), stages, !self.without_times))?;
        if self.json {
            print(&format!("{:#}\n", as_json(&explanation)))
        } else {
            print(&as_text(&explanation))
        }
    }
}

fn as_text(explanation: &Explanation) -> String {
    let mut text = format!("{}: {}\n\n", explanation.scene, explanation.title);
    text.push_str(&left_out(explanation));
    text.push_str(&sizes(explanation));
    text.extend(["\n", &paragraph(&format!("States: {}", explanation.states.join(", ")))]);
    text.push_str("\nStructure\n");
    for line in structure(explanation) {
        text.push_str(&indented(&line, SECTION, width()));
    }
    text.push_str(&candidates(&explanation.candidates));
    match &explanation.times {
        Some(Ok(times)) => text.extend(["\n", &run_times(times), "\n"]),
        Some(Err(error)) => text.extend(["\nNo run times: ", &error.to_string(), "\n"]),
        None => {}
    }
    if let Some(error) = &explanation.no_object {
        text.extend(["\nNo sizes of object files: ", &error.to_string(), "\n"]);
    }
    text
}

fn left_out(explanation: &Explanation) -> String {
    if explanation.reduction.left_out.is_empty() {
        return "Nothing is left out.\n\n".to_owned();
    }
    let header = ["left out", "what", "why", "instead"].map(str::to_owned);
    let rows = explanation.reduction.left_out.iter().map(|thing| {
        let (what, why) = (thing.what.name().to_owned(), thing.why.name().to_owned());
        [thing.name.clone(), what, why, thing.instead.clone()]
    });
    let rows: Vec<_> = std::iter::once(header).chain(rows).collect();
    format!("{}\n", columns(&rows, 4))
}

/// Formats a column for the whole scene, one for the reduced scene, and one for the change by each
/// step.
fn sizes(explanation: &Explanation) -> String {
    let (Some(first), Some(last)) = (explanation.stages.first(), explanation.stages.last()) else {
        return String::new();
    };
    let header = ["", "whole", "kept", "saved", "of it by"].map(str::to_owned);
    let figures = first.size.figures().into_iter().zip(last.size.figures());
    let rows = figures.enumerate().map(|(index, ((name, whole), (_, kept)))| {
        let steps = explanation.stages.windows(2).filter_map(|pair| {
            let saved =
                difference(pair[0].size.figures()[index].1, pair[1].size.figures()[index].1);
            (saved != 0).then(|| format!("{} {saved}", pair[1].done))
        });
        let steps = steps.collect::<Vec<_>>().join(", ");
        let saved = difference(whole, kept).to_string();
        [name.to_owned(), whole.to_string(), kept.to_string(), saved, steps]
    });
    let rows: Vec<_> = std::iter::once(header).chain(rows).collect();
    columns(&rows, 1)
}

fn difference(before: usize, after: usize) -> i64 {
    before as i64 - after as i64
}

/// Formats candidates for freezing, one line for each instance with its price.
fn candidates(candidates: &[Candidate]) -> String {
    if candidates.is_empty() {
        return String::new();
    }
    let lines = candidates.iter().map(|one| indented(&price(one), SECTION, width()));
    format!("\nCandidates for [freeze]\n{}", lines.collect::<String>())
}

/// Returns a sentence on the price of a candidate.
pub fn price(candidate: &Candidate) -> String {
    match &candidate.price {
        Err(error) => format!("{}: its run stopped: {error}", candidate.instance),
        Ok(price) => {
            let errors = price.errors.iter();
            let errors: Vec<String> =
                errors.map(|(output, error)| format!("{output} {}", number(*error, 2))).collect();
            format!(
                "{}: {} states, {} of the time; errors relative to the largest value: {}",
                candidate.instance,
                price.states,
                number(price.time_ratio, 2),
                errors.join(", ")
            )
        }
    }
}

/// Returns sentences on a machine with fields.
fn with_fields(divided: &Result<Divided, String>) -> Vec<String> {
    let mut lines = vec![
        "the scene has fields, so nothing is left out; the numbers above are those of the machine \
         at its ports, without the elements"
            .to_owned(),
    ];
    let divided = match divided {
        Ok(divided) => divided,
        Err(error) => {
            lines.push(format!("its fields are not divided: {error}"));
            return lines;
        }
    };
    lines.extend(divided.fields.iter().map(|field| {
        let DividedField { name, elements, order, nodes } = field;
        format!("field {name}: {elements} elements of order {order}, {nodes} nodes")
    }));
    lines.push(format!(
        "with these elements {} states and {} Jacobian nonzeros",
        divided.states, divided.jacobian_nonzeros
    ));
    lines.push(match (divided.is_linear, divided.switches) {
        (true, _) => "the equations are linear with constant coefficients: a run needs no steps, \
                      and `run --modes` can leave out fast eigenmodes"
            .to_owned(),
        (false, 0) => "the equations are not linear with constant coefficients".to_owned(),
        (false, switches) => format!(
            "the equations are not linear with constant coefficients; relations and events, which \
             runs locate: {switches}"
        ),
    });
    if let Some(DividedRun { milliseconds, steps, stopped }) = &divided.run {
        lines.push(match stopped {
            None => format!(
                "run of the scene with these elements: {} ms ({steps} steps)",
                number(*milliseconds, 3)
            ),
            Some(why) => format!("its run stops: {why}"),
        });
    }
    lines
}

/// Returns sentences on the structure of the equations.
pub fn structure(explanation: &Explanation) -> Vec<String> {
    if let Some(divided) = &explanation.divided {
        return with_fields(divided);
    }
    let (structure, states) = (&explanation.structure, &explanation.states);
    let named = |entries: &[u32]| {
        let names = entries.iter().filter_map(|entry| states.get(*entry as usize));
        names.map(String::as_str).collect::<Vec<_>>().join(", ")
    };
    let mass = match (structure.constant_mass, structure.diagonal_mass) {
        (true, true) => "constant and diagonal",
        (true, false) => "constant",
        (false, true) => "diagonal",
        (false, false) => "neither constant nor diagonal",
    };
    let (constant, all) = structure.constant_jacobian;
    let time = if structure.autonomous { "does not depend" } else { "depends" };
    let mass = match structure.coordinates {
        0 => "there are no coordinates, hence no mass matrix".to_owned(),
        _ => format!("the mass matrix is {mass}"),
    };
    let mut lines = vec![
        mass,
        format!("{constant} of {all} Jacobian entries depend on parameters only"),
        format!("the rate {time} on time explicitly"),
    ];
    match &structure.subsystems[..] {
        [] | [_] => lines.push("the state has no independent parts".to_owned()),
        parts => {
            let parts: Vec<String> = parts.iter().map(|part| named(part)).collect();
            lines.push(format!("independent parts: {}", parts.join("; ")));
        }
    }
    if structure.is_linear() {
        lines.push("the equations are linear with constant coefficients".to_owned());
    } else if !structure.linear_rows.is_empty() {
        let rows = named(&structure.linear_rows);
        lines.push(format!("these rates are linear with constant coefficients: {rows}"));
        if !structure.linear_part.is_empty() {
            let part = named(&structure.linear_part);
            lines.push(format!("linear time-invariant subsystem: {part}"));
        }
    }
    for (name, frequency) in [("rate", structure.rate), ("Jacobian", structure.jacobian)] {
        let Frequency { once, by_time, by_state } = frequency;
        lines.push(format!(
            "operations of the {name}: {once} once per run, {by_time} dependent on time and \
             parameters only, {by_state} dependent on the state"
        ));
    }
    lines
}

/// Returns a sentence on run times.
pub fn run_times(times: &Times) -> String {
    format!(
        "Run of the scene, evaluated from its tapes: {} ms whole ({} steps), {} ms reduced ({} \
         steps), ratio {}; outputs differ by {} of their largest value at rtol 1e-12",
        number(times.whole, 3),
        times.whole_steps,
        number(times.needed, 3),
        times.needed_steps,
        number(times.ratio(), 3),
        number(times.difference, 2),
    )
}

fn as_json(explanation: &Explanation) -> Value {
    let left_out = explanation.reduction.left_out.iter().map(|thing| {
        json!({
            "name": thing.name,
            "what": thing.what.name(),
            "why": thing.why.name(),
            "instead": thing.instead,
        })
    });
    let stages = explanation.stages.iter();
    let stages = stages.map(|stage| json!({ "done": stage.done, "size": stage.size }));
    let structure = &explanation.structure;
    let frequency =
        |f: Frequency| json!({ "once": f.once, "by_time": f.by_time, "by_state": f.by_state });
    let times = explanation.times.as_ref().map(|times| match times {
        Ok(times) => json!({ "milliseconds": times, "ratio": times.ratio() }),
        Err(error) => json!({ "failure": error.to_string() }),
    });
    let divided = explanation.divided.as_ref().map(|divided| match divided {
        Ok(divided) => json!(divided),
        Err(error) => json!({ "failure": error }),
    });
    json!({
        "scene": explanation.scene,
        "title": explanation.title,
        "left_out": left_out.collect::<Value>(),
        "stages": stages.collect::<Value>(),
        "states": explanation.states,
        "structure": {
            "coordinates": structure.coordinates,
            "constant_mass": structure.constant_mass,
            "diagonal_mass": structure.diagonal_mass,
            "constant_jacobian_entries": structure.constant_jacobian.0,
            "jacobian_entries": structure.constant_jacobian.1,
            "linear": structure.is_linear(),
            "linear_rows": structure.linear_rows,
            "linear_part": structure.linear_part,
            "autonomous": structure.autonomous,
            "subsystems": structure.subsystems,
            "rate_operations": frequency(structure.rate),
            "jacobian_operations": frequency(structure.jacobian),
        },
        "divided": divided,
        "no_object_files": explanation.no_object.as_ref().map(ToString::to_string),
        "freeze_candidates": explanation.candidates,
        "run": times,
    })
}

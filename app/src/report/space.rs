//! Drawing of a machine in space: its elements, the functions that place them, and the stored run.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use machinist::trajectory::Trajectory;
use machinist_model::functions::FunctionId;
use machinist_model::wasm::{Layout, module};
use machinist_model::{Element, Model, Op, Tape};
use maud::{Markup, html};
use serde::Serialize;

/// Maximum number of stored samples; more would not be visible.
const MOST_SAMPLES: usize = 601;
/// Maximum number of stored numbers, of four bytes each.
const MOST_NUMBERS: usize = 40_000;

/// Data of the drawing for scripts.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Space {
    elements: Vec<Element>,
    /// Module that places the elements, in base 64.
    module: String,
    layout: Layout,
    /// Number of states.
    states: usize,
    parameters: Vec<f64>,
    /// Entries of the state that places depend on.
    entries: Vec<u32>,
    /// Entries of the state that are stored.
    tracked: Vec<u32>,
    run: Stored,
}

/// Samples of the stored run, as single precision in base 64.
#[derive(Debug, Clone, Serialize)]
struct Stored {
    times: String,
    /// Entry after entry, all times of each.
    values: String,
}

impl Space {
    /// Returns the drawing of a machine with its stored run, and `also` among the stored entries.
    /// `None` if the machine has no frames, or if its frames depend on nodes of fields.
    pub(super) fn of(model: &Model, run: &Trajectory, also: &[u32]) -> Option<Self> {
        let drawing = model.drawing.as_ref()?;
        let module = module(&model.of_drawing()?, &[FunctionId::Outputs]).ok()?;
        let entries = entries(&drawing.places);
        let is_moved = |entry: &u32| *entry as usize >= model.coordinates.len();
        if !model.fields.is_empty() && entries.iter().any(is_moved) {
            return None;
        }
        let mut tracked = [&entries[..], also].concat();
        tracked.sort_unstable();
        tracked.dedup();
        Some(Self {
            elements: drawing.elements.clone(),
            module: BASE64_STANDARD.encode(&module.bytes),
            layout: module.layout,
            states: model.states.len(),
            parameters: model.parameters.iter().map(|parameter| parameter.value).collect(),
            run: Stored::of(run, &tracked),
            entries,
            tracked,
        })
    }

    /// Renders the drawing with its controls, which the script shows.
    pub(super) fn figure() -> Markup {
        let label = "drawing of the machine in space: arrow keys turn it, plus and minus zoom, 0 \
                     resets the view";
        html! {
            figure.space hidden {
                canvas tabindex="0" role="application" aria-roledescription="drawing"
                    aria-label=(label) {}
                figcaption.tools {
                    button type="button" aria-pressed="false" { "Names" }
                    button type="button" aria-pressed="false" { "Parallel projection" }
                    button type="button" { "Reset view" }
                    span.muted { "Drag to turn, wheel or two fingers to zoom" }
                }
            }
        }
    }
}

/// Returns the entries of the state that a tape reads, in order.
fn entries(tape: &Tape) -> Vec<u32> {
    let mut entries: Vec<u32> = tape
        .nodes
        .iter()
        .filter_map(|node| match node.op {
            Op::State(entry) => Some(entry),
            _ => None,
        })
        .collect();
    entries.sort_unstable();
    entries.dedup();
    entries
}

impl Stored {
    fn of(run: &Trajectory, tracked: &[u32]) -> Self {
        let most = (MOST_NUMBERS / (tracked.len() + 1)).clamp(2, MOST_SAMPLES);
        let count = run.times.len();
        let samples: Vec<usize> = if count <= most {
            (0..count).collect()
        } else {
            (0..most).map(|k| k * (count - 1) / (most - 1)).collect()
        };
        let encoded = |columns: &[&[f64]]| {
            let numbers = columns.iter().flat_map(|column| samples.iter().map(|at| column[*at]));
            let bytes: Vec<u8> = numbers.flat_map(|value| (value as f32).to_le_bytes()).collect();
            BASE64_STANDARD.encode(bytes)
        };
        let columns: Vec<&[f64]> =
            tracked.iter().map(|entry| &run.columns[*entry as usize].values[..]).collect();
        Self { times: encoded(&[&run.times]), values: encoded(&columns) }
    }
}

//! `machinist derive`: the equations of motion of a scene, as text, LaTeX or JSON.

use clap::Args;
use machinist_codegen::emit::document::{Document, Equation, Notation};
use serde_json::{Value, json};

use super::output::{columns, print};
use super::scene::spec_path;
use super::specs::{Cost, Derived, costs};
use crate::failure::Failure;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Derive {
    /// Name or file of the scene
    scene: String,
    /// As LaTeX
    #[arg(long, conflicts_with = "json")]
    latex: bool,
    /// As JSON, with both text and LaTeX
    #[arg(long)]
    json: bool,
}

impl Derive {
    pub fn execute(&self) -> Result<(), Failure> {
        let path = spec_path(&self.scene)?;
        let derived = during("deriving", || Derived::new(&path))?;
        let document = |notation| Document::new(&derived.equations, notation);
        if self.latex {
            print(&document(Notation::Latex).to_latex())
        } else if self.json {
            let value = as_json(&derived, &document(Notation::Text), &document(Notation::Latex));
            print(&format!("{value:#}\n"))
        } else {
            print(&as_text(&derived, &document(Notation::Text)))
        }
    }
}

fn as_text(derived: &Derived, document: &Document) -> String {
    let system = &derived.equations.system;
    let header = ["function", "results", "of", "operations"].map(str::to_owned);
    let row = |cost: &Cost| {
        let full = cost.full.map(|full| full.to_string()).unwrap_or_default();
        let [results, operations] = [cost.results, cost.operations].map(|n| n.to_string());
        [cost.function.to_owned(), results, full, operations]
    };
    let rows: Vec<_> =
        std::iter::once(header).chain(costs(&derived.model).iter().map(row)).collect();
    format!(
        "{}: {}\n\n{}Cost of the emitted functions\n{}",
        system.name,
        system.title,
        document.to_text(),
        columns(&rows, 1)
    )
}

fn as_json(derived: &Derived, text: &Document, latex: &Document) -> Value {
    let section = |text: &[Equation], latex: &[Equation]| -> Value {
        let equations = text.iter().zip(latex).map(|(text, latex)| {
            json!({
                "subject": text.subject,
                "left": text.left,
                "right": text.right,
                "left_latex": latex.left,
                "right_latex": latex.right,
                "unit": text.unit,
                "doc": text.doc,
            })
        });
        equations.collect()
    };
    let costs = costs(&derived.model).into_iter().map(|cost| {
        json!({
            "function": cost.function,
            "results": cost.results,
            "full": cost.full,
            "operations": cost.operations,
        })
    });
    let system = &derived.equations.system;
    json!({
        "scene": system.name,
        "title": system.title,
        "energies": section(&text.energies, &latex.energies),
        "motion": section(&text.motion, &latex.motion),
        "first_order": section(&text.first_order, &latex.first_order),
        "helpers": section(&text.helpers, &latex.helpers),
        "outputs": section(&text.outputs, &latex.outputs),
        "costs": costs.collect::<Value>(),
    })
}

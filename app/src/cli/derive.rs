//! `machinist derive`: the equations of motion of a scene, as text, LaTeX or JSON.

use clap::Args;
use machinist_algebra::cas::Algebra;
use machinist_codegen::emit::document::Equation;
use machinist_codegen::pipeline::Derivation;
use machinist_model::Model;
use serde_json::{Value, json};

use super::arguments::SourceArgs;
use super::output::{columns, print};
use super::scene::SceneSource;
use super::specs::{Cost, costs};
use super::table::{hanging, width_of_terminal};
use crate::deriving::{self, Purpose};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub struct Derive {
    /// Print LaTeX
    #[arg(long, help_heading = "Output", conflicts_with = "json")]
    latex: bool,
    /// Print JSON, with both text and LaTeX
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SourceArgs,
}

impl Derive {
    pub fn execute(&self) -> Result<(), Failure> {
        let keep = self.scene.keep();
        let derivation = match self.scene.given()? {
            SceneSource::Spec(source) => deriving::derivation(&source, keep, Purpose::Reading)?,
            SceneSource::Model(stamped) => return Err(no_equations(&stamped.model)),
        };
        if self.latex {
            print(&derivation.latex.to_latex())
        } else if self.json {
            print(&format!("{:#}\n", as_json(&derivation)))
        } else {
            // A file keeps each equation on a line.
            let text = as_text(&derivation);
            print(&width_of_terminal().map_or(text.clone(), |width| hanging(&text, width)))
        }
    }
}

/// Creates the error for a model file, which holds no equations.
fn no_equations(model: &Model) -> Failure {
    let spec = model.files.first().map_or("its spec", |file| file.label.as_str());
    let message = format!("the model of `{}` contains no symbolic equations", model.name);
    Failure::input(message, format!("derive {spec}, from which it was compiled"))
}

fn as_text(derivation: &Derivation) -> String {
    let model = derivation.stages.needed();
    let header = ["function", "results", "of", "operations"].map(str::to_owned);
    let row = |cost: &Cost| {
        let full = cost.full.map(|full| full.to_string()).unwrap_or_default();
        let [results, operations] = [cost.results, cost.operations].map(|n| n.to_string());
        [cost.function.to_owned(), results, full, operations]
    };
    let rows: Vec<_> = std::iter::once(header).chain(costs(model).iter().map(row)).collect();
    let by = if derivation.algebra == Algebra::Plain {
        "Derived by Machinist's own algebra, which simplifies less than Symbolica.\n\n"
    } else {
        ""
    };
    format!(
        "{}: {}\n\n{by}{}Cost of the emitted functions\n{}",
        model.name,
        model.title,
        derivation.text.to_text(),
        columns(&rows, 1)
    )
}

fn as_json(derivation: &Derivation) -> Value {
    let (text, latex) = (&derivation.text, &derivation.latex);
    let model = derivation.stages.needed();
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
    let costs = costs(model).into_iter().map(|cost| {
        json!({
            "function": cost.function,
            "results": cost.results,
            "full": cost.full,
            "operations": cost.operations,
        })
    });
    json!({
        "scene": model.name,
        "algebra": derivation.algebra.name(),
        "title": model.title,
        "energies": section(&text.energies, &latex.energies),
        "motion": section(&text.motion, &latex.motion),
        "first_order": section(&text.first_order, &latex.first_order),
        "helpers": section(&text.helpers, &latex.helpers),
        "outputs": section(&text.outputs, &latex.outputs),
        "costs": costs.collect::<Value>(),
    })
}

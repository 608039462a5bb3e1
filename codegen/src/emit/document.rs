//! Equations of motion as text and as LaTeX, with the names of the spec.

mod printer;

use std::collections::BTreeMap;

use crate::mechanics::constraint::Constraints;
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::scene::system::LagrangianSystem;
use machinist_algebra::expr::{
    ConstraintId, CoordinateId, Expr, FirstOrderId, HandedId, HelperId, ParameterId, Symbol,
};
use machinist_model::Quantity;
use printer::Printer;
use serde::{Deserialize, Serialize};

/// Notation of mathematics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// `motor.inertia*motor.epsilon = ...`
    Text,
    /// `J_{\mathrm{motor}} \ddot{\varphi}_{\mathrm{motor}} = ...`
    Latex,
}

/// One equation, with its subject and meaning.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Equation {
    /// Name in the spec of the quantity that it governs or defines.
    pub subject: String,
    /// Left side.
    pub left: String,
    /// Right side.
    pub right: String,
    /// SI unit of both sides; empty if the sides have a unit of their own.
    pub unit: String,
    /// One sentence of meaning.
    pub doc: String,
}

/// A machine in equations.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Document {
    /// T, V, D and the energy of first-order states, without those that are zero.
    pub energies: Vec<Equation>,
    /// M q'' = f, a row for each coordinate.
    pub motion: Vec<Equation>,
    /// z' = h.
    pub first_order: Vec<Equation>,
    /// Constraints; each is 0.
    pub constraints: Vec<Equation>,
    /// Guards of events. Their meaning is the direction of the zero crossing and the resets.
    pub events: Vec<Equation>,
    /// Helpers that the equations above use.
    pub helpers: Vec<Equation>,
    /// Outputs.
    pub outputs: Vec<Equation>,
}

impl Document {
    /// Writes the equations of motion in the given notation.
    #[must_use]
    pub fn new(equations: &EquationsOfMotion, notation: Notation) -> Self {
        let printer = Printer::new(equations, notation);
        let system = &equations.system;
        let mut document = Document {
            energies: energies(&printer, equations),
            motion: motion(&printer, equations),
            first_order: first_order(&printer, equations),
            constraints: constraints(&printer, equations),
            events: events(&printer, equations),
            ..Document::default()
        };
        for (output, expr) in system.outputs.iter().zip(&equations.outputs) {
            document.outputs.push(definition(&printer, &output.quantity, &printer.print(expr)));
        }
        shared_parts(&printer, &mut document);
        // Helpers may use other helpers: print until no new one appears.
        let mut shown = BTreeMap::new();
        loop {
            let used = printer.used();
            let new: Vec<usize> = used.into_iter().filter(|i| !shown.contains_key(i)).collect();
            if new.is_empty() {
                break;
            }
            shown.extend(new.into_iter().map(|index| (index, printer.print_helper(index))));
        }
        for (index, text) in shown {
            let quantity = &system.helpers[index].quantity;
            document.helpers.push(definition(&printer, quantity, &text));
        }
        document
    }

    /// Returns all sections with headings, for a terminal.
    #[must_use]
    pub fn to_text(&self) -> String {
        let sections = [
            ("Energies", &self.energies),
            ("Equations of motion", &self.motion),
            ("First-order states", &self.first_order),
            ("Constraints", &self.constraints),
            ("Events", &self.events),
            ("with", &self.helpers),
            ("Outputs", &self.outputs),
        ];
        let mut text = String::new();
        for (heading, equations) in sections.into_iter().filter(|(_, e)| !e.is_empty()) {
            text.push_str(heading);
            text.push('\n');
            for equation in equations {
                let unit = match equation.unit.as_str() {
                    "" => String::new(),
                    unit => format!("   [{unit}]"),
                };
                let Equation { left, right, .. } = equation;
                text.extend(["  ", left, " = ", right, &unit, "\n"]);
                if heading == "Events" {
                    text.extend(["    ", &equation.doc, "\n"]);
                }
            }
            text.push('\n');
        }
        text
    }

    /// Returns all sections as LaTeX `align*` environments.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let sections = [
            &self.energies,
            &self.motion,
            &self.first_order,
            &self.constraints,
            &self.events,
            &self.helpers,
            &self.outputs,
        ];
        let mut text = String::new();
        for equations in sections.into_iter().filter(|equations| !equations.is_empty()) {
            let lines: Vec<String> =
                equations.iter().map(|e| format!("  {} &= {}", e.left, e.right)).collect();
            text.push_str("\\begin{align*}\n");
            text.push_str(&lines.join(" \\\\\n"));
            text.push_str("\n\\end{align*}\n");
        }
        text
    }
}

/// Maximum number of shared parts whose definitions are printed.
const MOST_SHARED: usize = 200;

/// Adds the definitions of shared parts, up to a number that can be read.
fn shared_parts(printer: &Printer, document: &mut Document) {
    let mut shown = 0;
    while let Some(shared) = printer.shared_parts().get(shown).cloned()
        && shown < MOST_SHARED
    {
        let (left, right) = printer.print_shared(&shared);
        let subject = left.clone();
        document.helpers.push(Equation { subject, left, right, ..Equation::default() });
        shown += 1;
    }
    if printer.shared_parts().len() > shown {
        let subject = "...".to_owned();
        let right = "...".to_owned();
        let doc = format!("more than {MOST_SHARED} shared parts");
        document.helpers.push(Equation {
            left: subject.clone(),
            subject,
            right,
            doc,
            ..Equation::default()
        });
    }
}

fn definition(printer: &Printer, quantity: &Quantity, right: &str) -> Equation {
    Equation {
        subject: quantity.name.path.clone(),
        left: printer.quantity(quantity),
        right: right.to_owned(),
        unit: quantity.unit.clone(),
        doc: quantity.doc.clone(),
    }
}

fn energies(printer: &Printer, equations: &EquationsOfMotion) -> Vec<Equation> {
    let [kinetic, potential, stored] = &equations.energy;
    [
        ("T", kinetic, "J", "kinetic energy"),
        ("V", potential, "J", "potential energy"),
        ("D", &equations.dissipation, "W", "Rayleigh dissipation"),
        ("W", stored, "J", "energy of the first-order states"),
    ]
    .into_iter()
    .filter(|(_, expr, _, _)| !is_zero(expr))
    .map(|(name, expr, unit, doc)| Equation {
        subject: name.to_owned(),
        left: name.to_owned(),
        right: printer.print(expr),
        unit: unit.to_owned(),
        doc: doc.to_owned(),
    })
    .collect()
}

/// Returns a row for each coordinate: sum over columns of M_ij q''_j = f_i.
fn motion(printer: &Printer, equations: &EquationsOfMotion) -> Vec<Equation> {
    let rows = equations.system.coordinates.iter().enumerate();
    rows.map(|(row, coordinate)| {
        let columns = equations.mass_matrix.row(row).iter();
        let terms: Vec<Expr> = columns
            .filter(|(_, entry)| !is_zero(entry))
            .map(|(column, entry)| {
                let acceleration = Symbol::Acceleration(CoordinateId(*column as u32));
                Expr::Product(vec![entry.clone(), Expr::Symbol(acceleration)])
            })
            .collect();
        let left = match <[Expr; 1]>::try_from(terms) {
            Ok([only]) => only,
            Err(terms) => Expr::Sum(terms),
        };
        Equation {
            subject: coordinate.position.name.path.clone(),
            left: printer.print(&left),
            right: printer.print(&with_constraint_forces(equations, row)),
            unit: String::new(),
            doc: coordinate.position.doc.clone(),
        }
    })
    .collect()
}

fn first_order(printer: &Printer, equations: &EquationsOfMotion) -> Vec<Equation> {
    let system = &equations.system;
    let parts = system.orientations.iter().zip(&system.scalars).flat_map(|(one, scalar)| {
        let vector = one.vector.map(|id| (id, &system.coordinates[id.0 as usize].position));
        std::iter::once((one.scalar, &scalar.quantity)).chain(vector)
    });
    let parts = parts.map(|(id, quantity)| Equation {
        subject: quantity.name.path.clone(),
        left: printer.rate_of(Symbol::Coordinate(id)),
        right: printer.print(&system.orientations.rate(id)),
        unit: String::new(),
        doc: quantity.doc.clone(),
    });
    let states = system.first_order.iter().enumerate();
    let states = states.map(|(index, state)| Equation {
        subject: state.quantity.name.path.clone(),
        left: printer.rate_of(Symbol::FirstOrder(FirstOrderId(index as u32))),
        right: printer.print(&equations.rates[index]),
        unit: String::new(),
        doc: state.quantity.doc.clone(),
    });
    parts.chain(states).collect()
}

/// Returns f and G^T lambda of one coordinate. A multiplier has its constraint's name.
fn with_constraint_forces(equations: &EquationsOfMotion, row: usize) -> Expr {
    let forcing = equations.forcing[row].clone();
    let forces = equations.constraints.matrix.iter().enumerate();
    let forces = forces.filter(|(_, line)| !is_zero(&line[row])).map(|(index, line)| {
        let multiplier = Expr::Symbol(Symbol::Multiplier(ConstraintId(index as u32)));
        let entry = equations.constraints.held(index, &line[row]);
        Expr::Product(vec![entry, multiplier])
    });
    let own = (!is_zero(&forcing)).then_some(forcing);
    let mut terms: Vec<Expr> = own.into_iter().chain(forces).collect();
    match terms.len() {
        0 => Expr::integer(0),
        1 => terms.swap_remove(0),
        _ => Expr::Sum(terms),
    }
}

/// Returns an equation for each constraint, which is zero.
fn constraints(printer: &Printer, equations: &EquationsOfMotion) -> Vec<Equation> {
    let Constraints { values, rates, .. } = &equations.constraints;
    let constraints = equations.system.constraints.iter().zip(values).zip(rates);
    let constraints = constraints.map(|((constraint, value), rate)| Equation {
        subject: constraint.name.path.clone(),
        left: printer.print(if constraint.is_of_positions { value } else { rate }),
        right: "0".to_owned(),
        unit: constraint.unit.clone(),
        doc: constraint.doc.clone(),
    });
    constraints.collect()
}

/// Returns an equation for each guard, which is zero where its event happens.
fn events(printer: &Printer, equations: &EquationsOfMotion) -> Vec<Equation> {
    let system = &equations.system;
    let name = |symbol| symbol_name(system, symbol, Notation::Text);
    let events = equations.events.iter().map(|event| {
        let mut doc = format!("{}, {}", event.name.path, event.direction.name());
        for (id, value) in &event.when {
            let mode = name(Symbol::FirstOrder(*id));
            doc.extend([", while ", &mode, " is ", &value.to_string()]);
        }
        let text = Printer::new(equations, Notation::Text);
        for (symbol, value) in &event.set {
            doc.extend(["; ", &name(*symbol), " := ", &text.print(value)]);
        }
        Equation {
            subject: event.name.path.clone(),
            left: printer.print(&event.guard),
            right: "0".to_owned(),
            unit: String::new(),
            doc,
        }
    });
    events.collect()
}

fn is_zero(expr: &Expr) -> bool {
    matches!(expr, Expr::Number(value) if *value.numer() == 0.into())
}

/// Returns the name of a symbol in a notation.
fn symbol_name(system: &LagrangianSystem, symbol: Symbol, notation: Notation) -> String {
    let coordinate = |id: CoordinateId| &system.coordinates[id.0 as usize];
    let name = |quantity: &Quantity| match notation {
        Notation::Text => quantity.name.path.clone(),
        Notation::Latex => quantity.name.latex.clone(),
    };
    match (symbol, notation) {
        (Symbol::Pi, Notation::Text) => "pi".to_owned(),
        (Symbol::Pi, Notation::Latex) => "\\pi".to_owned(),
        (Symbol::Time, _) => "t".to_owned(),
        (Symbol::Coordinate(id), _) => {
            let scalar = (id.0 as usize).checked_sub(system.coordinates.len());
            let scalar = scalar.map(|number| &system.scalars[number].quantity);
            name(scalar.unwrap_or_else(|| &coordinate(id).position))
        }
        (Symbol::Velocity(id), Notation::Latex) if system.orientations.contain(id) => {
            name(&coordinate(id).velocity)
        }
        (Symbol::Acceleration(id), notation) if system.orientations.contain(id) => {
            let rate = name(&coordinate(id).velocity);
            if notation == Notation::Text { format!("{rate}'") } else { dotted(&rate, "dot") }
        }
        (Symbol::Velocity(id), Notation::Text) => name(&coordinate(id).velocity),
        (Symbol::Velocity(id), Notation::Latex) => dotted(&name(&coordinate(id).position), "dot"),
        (Symbol::Acceleration(id), Notation::Text) => {
            format!("{}_ddot", name(&coordinate(id).position))
        }
        (Symbol::Acceleration(id), Notation::Latex) => {
            dotted(&name(&coordinate(id).position), "ddot")
        }
        (Symbol::FirstOrder(FirstOrderId(index)), _) => {
            name(&system.first_order[index as usize].quantity)
        }
        // Only its sign is read, which is that of the multiplier.
        (Symbol::Multiplier(id) | Symbol::Unloaded(id), notation) => {
            let ConstraintId(index) = id;
            let name = &system.constraints[index as usize].name;
            match notation {
                Notation::Text => name.path.clone(),
                Notation::Latex => name.latex.clone(),
            }
        }
        (Symbol::Helper(HelperId(index)), _) => name(&system.helpers[index as usize].quantity),
        (Symbol::Handed(HandedId(index)), _) => name(&system.handed[index as usize].quantity),
        (Symbol::Parameter(ParameterId(index)), _) => {
            name(&system.parameters[index as usize].quantity)
        }
    }
}

/// Changes `\varphi_{x}` to `\dot{\varphi}_{x}`.
fn dotted(latex: &str, accent: &str) -> String {
    match latex.split_once('_') {
        Some((base, subscript)) => format!("\\{accent}{{{base}}}_{subscript}"),
        None => format!("\\{accent}{{{latex}}}"),
    }
}

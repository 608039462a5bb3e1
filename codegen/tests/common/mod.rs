//! Readable text of a composed system.

use std::fmt::Write as _;

use machinist_algebra::expr::{Expr, Function, Symbol};
use machinist_codegen::scene::system::{Check, LagrangianSystem, Reference};
use machinist_model::Quantity;

/// Describes everything of a system except its files' paths, one item per line.
pub fn describe(system: &LagrangianSystem) -> String {
    let mut out = String::new();
    let show = |expr: &Expr| show(expr, system);
    let mut line = |text: String| writeln!(out, "{text}").expect("write to a string");
    line(format!("{} | {}", system.name, system.title));
    line(format!("doc: {}\nsource: {}", system.doc, system.source));
    for file in &system.files {
        line(format!("file {}", file.label));
    }
    for c in &system.coordinates {
        line(format!("coordinate {}", quantity(&c.position)));
        line(format!("  velocity {}", quantity(&c.velocity)));
        line(format!(
            "  initial {}, {}; scale {:?}",
            show(&c.initial[0]),
            show(&c.initial[1]),
            c.scale
        ));
        for (name, factor) in &c.identified {
            line(format!("  {name} follows by {}", show(factor)));
        }
    }
    for z in &system.first_order {
        line(format!("state {}", quantity(&z.quantity)));
        line(format!("  rate {}", show(&z.rate)));
        line(format!("  initial {}; scale {}", show(&z.initial), z.scale));
    }
    for p in &system.parameters {
        line(format!("parameter {} = {}", quantity(&p.quantity), p.value));
    }
    line(format!("T = {}", show(&system.kinetic)));
    line(format!("V = {}", show(&system.potential)));
    line(format!("D = {}", show(&system.dissipation)));
    for q in &system.generalized_force {
        line(format!("Q = {}; converting {}", show(&q.total), show(&q.conversion)));
    }
    line(format!("stored = {}", show(&system.stored_energy)));
    line(format!("supplied = {}", show(&system.supplied_power)));
    line(format!("dissipated = {}", show(&system.dissipated_power)));
    for (kind, definitions) in [("helper", &system.helpers), ("output", &system.outputs)] {
        for definition in definitions {
            line(format!("{kind} {} = {}", quantity(&definition.quantity), show(&definition.expr)));
        }
    }
    for table in &system.tables {
        line(format!("table {} {} {:?}", table.name.ident, table.name.path, table.knots));
        table.coefficients.iter().for_each(|row| line(format!("  {row:.6?}")));
    }
    for time in &system.discontinuities {
        line(format!("jump at {}", show(time)));
    }
    for constraint in &system.constraints {
        let holds = if constraint.when.is_empty() {
            String::new()
        } else {
            format!(" while {}", show(&constraint.holds()))
        };
        let (path, unit, doc) = (&constraint.name.path, &constraint.unit, &constraint.doc);
        line(format!("constraint {path} [{unit}] {doc}: {} = 0{holds}", show(&constraint.expr)));
    }
    for check in &system.checks {
        let Check { name, of, unit, source, tolerance, absolute, reference } = check;
        line(format!("check {name} of {of} [{unit}] to {tolerance:e}, {absolute:?}: {source}"));
        match reference {
            Reference::Values(rows) => line(format!("  values {rows:?}")),
            Reference::Closed { text, expr, parameters, tables } => {
                let known: Vec<String> = parameters
                    .iter()
                    .map(|p| format!("{} = {}", p.quantity.name.path, p.value))
                    .collect();
                line(format!("  {text}: {}; {known:?}; {} tables", symbols(expr), tables.len()));
            }
        }
    }
    let run = &system.run;
    line(format!("run {}..{} {} {:e} {}", run.from, run.until, run.points, run.rtol, run.method));
    out
}

fn quantity(quantity: &Quantity) -> String {
    let name = &quantity.name;
    format!("{} {} {} [{}] {}", name.path, name.ident, name.latex, quantity.unit, quantity.doc)
}

/// Returns the infix text of an expression, with the names of the spec.
pub fn show(expr: &Expr, system: &LagrangianSystem) -> String {
    let each = |parts: &[Expr]| parts.iter().map(|part| show(part, system)).collect::<Vec<_>>();
    match expr {
        Expr::Number(number) => number.to_string(),
        Expr::Symbol(symbol) => self::symbol(*symbol, system),
        Expr::Sum(terms) => format!("({})", each(terms).join(" + ")),
        Expr::Product(factors) => each(factors).join("*"),
        Expr::Power(base, exponent) => {
            format!("{}^({})", grouped(base, system), show(exponent, system))
        }
        Expr::Call(Function::Table { table, .. }, arguments) => {
            format!(
                "{}({})",
                system.tables[table.0 as usize].name.ident,
                each(arguments).join(", ")
            )
        }
        Expr::Call(function, arguments) => format!("{function:?}({})", each(arguments).join(", ")),
        Expr::Shared(shared) => show(shared.definition(), system),
    }
}

fn grouped(expr: &Expr, system: &LagrangianSystem) -> String {
    let text = show(expr, system);
    if matches!(expr, Expr::Product(_) | Expr::Power(..)) { format!("({text})") } else { text }
}

fn symbol(symbol: Symbol, system: &LagrangianSystem) -> String {
    let coordinate = |id: machinist_algebra::expr::CoordinateId| &system.coordinates[id.0 as usize];
    match symbol {
        Symbol::Time => "t".to_owned(),
        Symbol::Pi => "pi".to_owned(),
        Symbol::Helper(id) => format!("helper {}", id.0),
        // Parts w of quaternions follow the coordinates.
        Symbol::Coordinate(id) => match (id.0 as usize).checked_sub(system.coordinates.len()) {
            Some(scalar) => system.scalars[scalar].quantity.name.path.clone(),
            None => coordinate(id).position.name.path.clone(),
        },
        Symbol::Velocity(id) => coordinate(id).velocity.name.path.clone(),
        Symbol::Acceleration(id) => format!("{}''", coordinate(id).position.name.path),
        Symbol::FirstOrder(id) => system.first_order[id.0 as usize].quantity.name.path.clone(),
        Symbol::Multiplier(id) | Symbol::Unloaded(id) => {
            system.constraints[id.0 as usize].name.path.clone()
        }
        Symbol::Parameter(id) => system.parameter(id).quantity.name.path.clone(),
        Symbol::Handed(id) => system.handed[id.0 as usize].quantity.name.path.clone(),
    }
}

fn symbols(expr: &Expr) -> String {
    format!("{:?}", expr.symbols())
}

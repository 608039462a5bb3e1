//! Checks of runs, as separate tapes and numbers.

use std::collections::BTreeMap;

use machinist_algebra::expr::{Expr, Graph, ParameterId, Symbol};
use machinist_model::{Check, ClosedForm, Op, Parameter, Reference, Table, TableId, Tape};
use num_rational::BigRational;

use crate::scene::system::{self, LagrangianSystem};

/// Returns the checks of a system whose model has these parameters. Other parameters in a check
/// were left out or made numbers, and are numbers in the check too.
pub fn checks(system: &LagrangianSystem, kept: &[Parameter]) -> Vec<Check> {
    let checks = system.checks.iter().map(|check| Check {
        name: check.name.clone(),
        of: check.of.clone(),
        unit: check.unit.clone(),
        source: check.source.clone(),
        tolerance: check.tolerance,
        absolute: check.absolute,
        reference: match &check.reference {
            system::Reference::Values(rows) => Reference::Values(rows.clone()),
            system::Reference::Closed { text, expr, parameters, tables } => {
                Reference::Closed(closed(text, &of_kept(expr, parameters, kept), tables))
            }
        },
    });
    checks.collect()
}

/// Renumbers the parameters that are kept, and replaces the others by their values.
fn of_kept(expr: &Expr, parameters: &[system::Parameter], kept: &[Parameter]) -> Expr {
    expr.replace(&|symbol| {
        let Symbol::Parameter(ParameterId(place)) = symbol else { return None };
        let own = &parameters[place as usize];
        let path = &own.quantity.name.path;
        let entry = kept.iter().zip(0..).find(|(other, _)| other.quantity.name.path == *path);
        match entry {
            Some((_, entry)) => Some(Expr::Symbol(Symbol::Parameter(ParameterId(entry)))),
            None => BigRational::from_float(own.value).map(Expr::Number),
        }
    })
}

fn closed(text: &str, expr: &Expr, tables: &[Table]) -> ClosedForm {
    let mut graph = Graph::new();
    let result = graph.lower(expr);
    let mut tape = graph.tape(&[result]);
    let tables = used(&mut tape, tables);
    ClosedForm { text: text.to_owned(), tape, tables }
}

/// Returns the tables that a tape reads, and renumbers the tape accordingly.
fn used(tape: &mut Tape, tables: &[Table]) -> Vec<Table> {
    let mut places: BTreeMap<TableId, TableId> = BTreeMap::new();
    let mut used = Vec::new();
    for node in &mut tape.nodes {
        if let Op::Table { table, .. } = &mut node.op {
            *table = *places.entry(*table).or_insert_with(|| {
                used.push(tables[table.0 as usize].clone());
                TableId(used.len() as u32 - 1)
            });
        }
    }
    used
}

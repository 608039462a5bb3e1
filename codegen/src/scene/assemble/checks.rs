//! Checks of runs: names and dimensions are checked, and parameters and tables are copied, so
//! that no equation depends on them.

use std::collections::BTreeSet;

use crate::scene::assemble::{Assembler, quantity};
use crate::scene::layout::{Local, Scope};
use crate::scene::names::Flat;
use crate::scene::resolve::Wanted;
use crate::scene::system::{Check, Coordinate, Definition, FirstOrderState, Parameter, Reference};
use crate::scene::typed::{Uses, in_units_of};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::expression::{Ast, Node};
use crate::spec::measure::Factor;
use crate::spec::{CheckSpec, Column, OutputSpec, ReferenceSpec, did_you_mean, quoted};
use machinist_algebra::expr::{Expr, Function, ParameterId, Symbol};

/// A quantity that is checked.
struct Checked {
    dimension: Dimension,
    unit: String,
    /// Conversion factor of its unit to the coherent unit.
    factor: Factor,
}

impl Assembler<'_> {
    /// Returns all checks. A checked quantity that is not yet an output becomes one, if the scene
    /// has outputs; without outputs it keeps all of its states.
    pub(super) fn checks(
        &mut self,
        outputs: &mut Vec<Definition>,
        coordinates: &[Coordinate],
        first_order: &[FirstOrderState],
    ) -> Vec<Check> {
        let states = state_names(coordinates, first_order);
        let (tables, jumps) = (self.resolver.tables.len(), self.resolver.discontinuities.len());
        let spec = self.spec;
        let mut checks = Vec::new();
        for check in &spec.checks {
            let checked = match self.checked(&check.of, outputs, &states) {
                Ok(checked) => checked,
                Err(mistake) => {
                    self.mistakes.push(*mistake);
                    continue;
                }
            };
            match self.reference(check, &checked) {
                Ok(reference) => checks.push(Check {
                    name: check.name.value.clone(),
                    of: check.of.value.clone(),
                    unit: checked.unit,
                    source: check.source.clone(),
                    tolerance: check.tolerance,
                    absolute: check.absolute,
                    reference,
                }),
                Err(mistake) => self.mistakes.push(*mistake),
            }
        }
        // Tables and discontinuities that only checks use are not the machine's.
        self.resolver.tables.truncate(tables);
        self.resolver.table_columns.truncate(tables);
        self.resolver.discontinuities.truncate(jumps);
        checks
    }

    /// Finds the target of a check: an output, or a state by `instance.name`.
    fn checked(
        &mut self,
        of: &Spanned<String>,
        outputs: &mut Vec<Definition>,
        states: &[String],
    ) -> Result<Checked, Box<Mistake>> {
        let place = self.spec.outputs.iter().position(|output| output.name().value == of.value);
        if let Some(place) = place {
            let dimension = self.dimension_of_output(place)?;
            let factor = match &self.spec.outputs[place] {
                OutputSpec::Definition(definition) => definition.unit.factor.clone(),
                OutputSpec::Alias { .. } => Factor::one(),
            };
            let unit = outputs[place].quantity.unit.clone();
            return Ok(Checked { dimension, unit, factor });
        }
        let Some(ast) = self.state_named(of) else {
            let names = self.spec.outputs.iter().map(|output| output.name().value.as_str());
            let known = names.chain(states.iter().map(String::as_str));
            let message = format!("there is no output or state {}", quoted(&of.value));
            let help = did_you_mean(&of.value, known);
            return Err(Box::new(
                Mistake::new(Code::UnknownName, of.span, message, "unknown").help(help),
            ));
        };
        let typed = self.resolver.expect_any(&ast, Scope::Scene)?;
        let (unit, doc) = self.alias(&ast)?;
        if self.spec.outputs.is_empty() && !states.contains(&of.value) {
            let message = format!("{} is not a state of the scene", quoted(&of.value));
            let help = format!(
                "it is joined to another coordinate, or held: {}",
                did_you_mean(&of.value, states.iter().map(String::as_str))
            );
            return Err(Box::new(
                Mistake::new(Code::UnknownName, of.span, message, "no state").help(help),
            ));
        }
        let asked_for = outputs.iter().any(|output| output.quantity.name.path == of.value);
        if !self.spec.outputs.is_empty() && !asked_for {
            let (instance, own) = match of.value.rsplit_once('.') {
                Some((instance, own)) => (Some(instance), own),
                None => (None, of.value.as_str()),
            };
            let quantity = quantity(instance, own, &unit, &doc);
            let mut names = Flat::default();
            for output in &*outputs {
                names.take(&output.quantity.name, of.span)?;
            }
            names.take(&quantity.name, of.span)?;
            outputs.push(Definition { quantity, expr: typed.expr });
        }
        let dimension = typed.dimension.unwrap_or(Dimension::ONE);
        Ok(Checked { dimension, unit, factor: Factor::one() })
    }

    fn dimension_of_output(&mut self, place: usize) -> Result<Dimension, Box<Mistake>> {
        match &self.spec.outputs[place] {
            OutputSpec::Definition(definition) => Ok(definition.unit.unit.dimension),
            OutputSpec::Alias { of, .. } => {
                let typed = self.resolver.expect_any(of, Scope::Scene)?;
                Ok(typed.dimension.unwrap_or(Dimension::ONE))
            }
        }
    }

    /// Returns the expression of a coordinate, velocity or state by `instance.name`.
    fn state_named(&self, of: &Spanned<String>) -> Option<Ast> {
        if self.own_state(&of.value).is_some() {
            return Some(Ast { span: of.span, node: Node::Name(None, of.value.clone()) });
        }
        let (instance, own) = of.value.rsplit_once('.')?;
        let instances = &self.spec.instances;
        let unit = instances.iter().find(|known| known.name.value == instance)?.unit;
        match self.layout.units[unit].get(own)? {
            Local::Coordinate(_) | Local::Velocity(_) | Local::State(_) => {
                let node = Node::Name(Some(instance.to_owned()), own.to_owned());
                Some(Ast { span: of.span, node })
            }
            _ => None,
        }
    }

    fn reference(&mut self, check: &CheckSpec, of: &Checked) -> Result<Reference, Box<Mistake>> {
        match &check.reference {
            ReferenceSpec::Closed(ast, text) => {
                let what = format!("the reference of {}", quoted(&check.of.value));
                let of_time = Uses { time: true, ..Uses::PARAMETERS };
                let wanted = Wanted::new(of.dimension, what).of(of_time);
                let typed = self.resolver.expect(ast, Scope::Scene, &wanted)?;
                Ok(self.closed(text.clone(), &in_units_of(typed.expr, &of.factor)))
            }
            ReferenceSpec::Values(rows) => {
                let (from, until) = (self.run.from, self.run.until);
                let outside = rows.iter().find(|(t, _)| !(from..=until).contains(&t.value));
                if let Some((time, _)) = outside {
                    let message = format!("this time is outside the run, {from} s to {until} s");
                    return Err(Box::new(Mistake::new(
                        Code::OutOfRange,
                        time.span,
                        message,
                        "not within the run",
                    )));
                }
                let rows = rows.iter().map(|(time, value)| [time.value, *value]);
                Ok(Reference::Values(rows.collect()))
            }
            ReferenceSpec::Column { csv, column } => {
                let mut rows = self.column(csv, column, (&check.of.value, of.dimension))?;
                let factor = of.factor.to_f64();
                for [_, value] in &mut rows {
                    *value /= factor;
                }
                Ok(Reference::Values(rows))
            }
        }
    }

    /// Returns the expression with its parameters and tables, which it refers to by index.
    fn closed(&mut self, text: String, expr: &Expr) -> Reference {
        let ids: BTreeSet<ParameterId> = expr
            .symbols()
            .into_iter()
            .filter_map(|symbol| match symbol {
                Symbol::Parameter(id) => Some(id),
                _ => None,
            })
            .collect();
        let all = self.parameters();
        let parameters: Vec<Parameter> = ids.iter().map(|id| all[id.0 as usize].clone()).collect();
        let place = |id: ParameterId| ids.iter().zip(0..).find(|(known, _)| **known == id);
        let expr = expr.replace(&|symbol| match symbol {
            Symbol::Parameter(id) => {
                place(id).map(|(_, place)| Expr::Symbol(Symbol::Parameter(ParameterId(place))))
            }
            _ => None,
        });
        let mut tables = 0;
        Expr::visit_all([&expr], &mut |part| {
            if let Expr::Call(Function::Table { table, .. }, _) = part {
                tables = tables.max(table.0 as usize + 1);
            }
        });
        let tables = self.resolver.tables[..tables].to_vec();
        Reference::Closed { text, expr, parameters, tables }
    }

    /// Returns the rows of a column as a function of time.
    fn column(
        &self,
        csv: &Spanned<String>,
        column: &Spanned<String>,
        (of, dimension): (&str, Dimension),
    ) -> Result<Vec<[f64; 2]>, Box<Mistake>> {
        let refuse = |span: Span, message: String, label: &str, help: String| {
            Err(Box::new(Mistake::new(Code::InvalidTable, span, message, label).help(help)))
        };
        let mut read = self.spec.tables.iter();
        let table = read.find(|table| table.spec == csv.span.file && table.path == csv.value);
        let [time, others @ ..] = table.map_or(&[][..], |table| &table.columns) else {
            return refuse(csv.span, "this table was not read".to_owned(), "here", String::new());
        };
        let Some(found) = others.iter().find(|other| other.name == column.value) else {
            let message = format!("the table has no column {}", quoted(&column.value));
            let help = did_you_mean(&column.value, others.iter().map(|c| c.name.as_str()));
            return refuse(column.span, message, "unknown", help);
        };
        let in_dimension = |column: &Column| column.unit.dimension;
        if in_dimension(time) != Dimension::TIME {
            let (name, is) = (quoted(&time.name), in_dimension(time));
            let message = format!("the first column must be time, but {name} is in {is}");
            return refuse(csv.span, message, "not over time", String::new());
        }
        if in_dimension(found) != dimension {
            let (name, is) = (quoted(&found.name), in_dimension(found));
            let message = format!("{} is in {dimension}, but {name} is in {is}", quoted(of));
            return refuse(column.span, message, "of another dimension", String::new());
        }
        let rows: Vec<[f64; 2]> =
            time.values.iter().zip(&found.values).map(|(t, v)| [*t, *v]).collect();
        let (from, until) = (self.run.from, self.run.until);
        if rows.iter().any(|[t, _]| (from..=until).contains(t)) {
            return Ok(rows);
        }
        let message = format!("no row of the table is within the run, {from} s to {until} s");
        refuse(csv.span, message, "not within the run", String::new())
    }
}

/// Returns the names of the scene's states.
fn state_names(coordinates: &[Coordinate], first_order: &[FirstOrderState]) -> Vec<String> {
    let positions = coordinates.iter().map(|coordinate| &coordinate.position);
    let velocities = coordinates.iter().map(|coordinate| &coordinate.velocity);
    let others = first_order.iter().map(|state| &state.quantity);
    positions.chain(velocities).chain(others).map(|state| state.name.path.clone()).collect()
}

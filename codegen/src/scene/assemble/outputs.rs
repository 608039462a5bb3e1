//! Helpers and outputs.

use crate::scene::assemble::{Assembler, quantity};
use crate::scene::layout::{Local, Scope, find_instance};
use crate::scene::resolve::Wanted;
use crate::scene::system::Definition;
use crate::scene::typed::{Uses, in_units_of};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::expression::{Ast, Node};
use crate::spec::measure::in_coherent_units;
use crate::spec::{Declared, DefinitionSpec, OutputSpec, quoted};
use machinist_model::Quantity;

impl Assembler<'_> {
    /// Returns all helpers, those of instances first. Outputs of units are checked too, whether
    /// the scene uses them or not.
    pub(super) fn helpers(&mut self) -> Vec<Definition> {
        let mut helpers = Vec::new();
        for (index, instance, unit) in self.instances() {
            let scope = Scope::Instance(index);
            for helper in &unit.helpers {
                helpers.push(self.helper(helper, scope, Some(&instance.name.value)));
            }
            for output in &unit.outputs {
                let resolved = self.resolver.value(&output.name.value, output.name.span, scope);
                self.note(resolved);
            }
        }
        for helper in &self.spec.helpers {
            helpers.push(self.helper(helper, Scope::Scene, None));
        }
        helpers
    }

    fn helper(
        &mut self,
        spec: &DefinitionSpec,
        scope: Scope,
        instance: Option<&str>,
    ) -> Definition {
        let resolved = self.resolver.value(&spec.name.value, spec.name.span, scope);
        let quantity = quantity(instance, &spec.name.value, &spec.unit.text, &spec.doc);
        Definition { quantity, expr: self.note(resolved) }
    }

    pub(super) fn outputs(&mut self) -> Vec<Definition> {
        let outputs = self.spec.outputs.iter();
        outputs
            .map(|output| match output {
                OutputSpec::Definition(definition) => self.output(definition),
                OutputSpec::Alias { of, .. } => {
                    let wanted = self.alias(of).and_then(|(unit, doc)| {
                        let typed = self.resolver.expect_any(of, Scope::Scene)?;
                        let unit = match typed.dimension {
                            Some(dimension) if unit.is_empty() => dimension.as_unit(),
                            _ => unit,
                        };
                        Ok((unit, doc, typed))
                    });
                    let name = &output.name().value;
                    match wanted {
                        Ok((unit, doc, typed)) => Definition {
                            quantity: quantity(None, name, &unit, &doc),
                            expr: typed.expr,
                        },
                        Err(mistake) => {
                            let expr = self.note(Err(mistake));
                            Definition { quantity: quantity(None, name, "1", ""), expr }
                        }
                    }
                }
            })
            .collect()
    }

    fn output(&mut self, definition: &DefinitionSpec) -> Definition {
        let name = &definition.name.value;
        let what = format!("output {}", quoted(name));
        let wanted = Wanted::new(definition.unit.unit.dimension, what).of(Uses::ANYTHING);
        let resolved = self.resolver.expect(&definition.expression, Scope::Scene, &wanted);
        let quantity: Quantity = quantity(None, name, &definition.unit.text, &definition.doc);
        let expr = in_units_of(self.note(resolved), &definition.unit.factor);
        Definition { quantity, expr }
    }

    /// Returns unit and meaning of the quantity that an output renames.
    pub(super) fn alias(&self, of: &Ast) -> Result<(String, String), Box<Mistake>> {
        let plain = |unit: &Declared, doc: &str| Ok((unit.text.clone(), doc.to_owned()));
        match &of.node {
            Node::Name(None, name) => match self.layout.scene.get(name) {
                Some(Local::Helper(index)) => {
                    let helper = &self.spec.helpers[index];
                    plain(&helper.unit, &helper.doc)
                }
                Some(Local::Parameter(index)) => {
                    let parameter = &self.spec.parameters[index];
                    Ok((in_coherent_units(&parameter.unit.text), parameter.doc.clone()))
                }
                Some(Local::State(index)) => {
                    let state = &self.spec.states[index];
                    plain(&state.unit, &state.doc)
                }
                Some(Local::Constraint(index)) => {
                    Ok((String::new(), force_of(&self.spec.constraints[index].doc)))
                }
                Some(Local::Friction(index)) => {
                    let friction = &self.spec.frictions[index].force;
                    plain(&friction.unit, &friction.doc)
                }
                _ => self.unknown_alias(name, of.span),
            },
            Node::Name(Some(instance), name) => {
                let instance = find_instance(self.spec, instance, of.span)?;
                let unit_index = self.spec.instances[instance].unit;
                let unit = &self.spec.units[unit_index];
                let rate = |index: usize, rates: usize| {
                    let coordinate = &unit.coordinates[index];
                    let doc = &coordinate.doc;
                    let doc = if doc.is_empty() {
                        String::new()
                    } else {
                        format!("{}{doc}", "rate of ".repeat(rates))
                    };
                    let unit = coordinate.unit_of_rate(rates as i32);
                    Ok((unit.map_or_else(String::new, |(text, _)| text), doc))
                };
                match self.layout.units[unit_index].get(name) {
                    Some(Local::Coordinate(i)) => {
                        plain(&unit.coordinates[i].unit, &unit.coordinates[i].doc)
                    }
                    Some(Local::Velocity(i)) => rate(i, 1),
                    Some(Local::Acceleration(i)) => rate(i, 2),
                    Some(Local::Parameter(i)) => {
                        let parameter = &unit.parameters[i];
                        Ok((in_coherent_units(&parameter.unit.text), parameter.doc.clone()))
                    }
                    Some(Local::Input(i)) => plain(&unit.inputs[i].unit, &unit.inputs[i].doc),
                    Some(Local::State(i)) => plain(&unit.states[i].unit, &unit.states[i].doc),
                    Some(Local::Helper(i)) => plain(&unit.helpers[i].unit, &unit.helpers[i].doc),
                    Some(Local::Output(i)) => plain(&unit.outputs[i].unit, &unit.outputs[i].doc),
                    Some(Local::Constraint(i)) => {
                        Ok((String::new(), force_of(&unit.constraints[i].doc)))
                    }
                    Some(Local::Friction(i)) => {
                        plain(&unit.frictions[i].force.unit, &unit.frictions[i].force.doc)
                    }
                    Some(Local::Slope(port, _)) => {
                        let at = self.layout.attachment_of(instance, port);
                        let field = at.map(|at| &unit.fields[self.layout.attachments[at].field]);
                        let unit = field.map_or("1", |field| field.unit.text.trim());
                        Ok((format!("{unit}/m"), "slope of the field".to_owned()))
                    }
                    Some(Local::Frame(index, part)) => {
                        let (unit, doc) = part.description(&unit.frames[index].name.value);
                        Ok((unit.to_owned(), doc))
                    }
                    Some(Local::Scalar(index)) => {
                        let orientation = &unit.orientations[index];
                        let doc = format!("part w of {}", orientation.name.value);
                        Ok(("1".to_owned(), doc))
                    }
                    None | Some(Local::Place | Local::Field(..)) => {
                        Ok((String::new(), String::new()))
                    }
                }
            }
            _ => {
                let message = "an output in quotes must be a name, not an expression";
                let help = "write { expression = \"...\", unit = \"...\" }";
                Err(Box::new(
                    Mistake::new(Code::WrongType, of.span, message, "not a name").help(help),
                ))
            }
        }
    }

    fn unknown_alias<T>(&self, name: &str, span: Span) -> Result<T, Box<Mistake>> {
        let known = self
            .layout
            .scene
            .iter()
            .chain(self.spec.instances.iter().map(|instance| instance.name.value.as_str()));
        let message = format!("unknown name {}", quoted(name));
        let help = crate::spec::did_you_mean(name, known);
        Err(Box::new(Mistake::new(Code::UnknownName, span, message, "unknown").help(help)))
    }
}

/// Returns the meaning of a constraint's multiplier.
fn force_of(doc: &str) -> String {
    if doc.is_empty() { String::new() } else { format!("force of the constraint: {doc}") }
}

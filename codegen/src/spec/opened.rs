//! Inputs of units that become parameters, so that a host sets them or a response excites them.

use num_traits::ToPrimitive as _;

use crate::spec::diagnostic::Spanned;
use crate::spec::expression::{Ast, Node};
use crate::spec::{Formula, ParameterSpec, SceneSpec, Value};

impl SceneSpec {
    /// Turns an input `instance.input` into a parameter and returns the parameter's name. An input
    /// bound to a number becomes a parameter of its own name and of this value. Any other keeps
    /// its expression, to which the scene's parameter `added_to_INSTANCE_INPUT` with value 0 is
    /// added.
    ///
    /// Returns `None` if there is no such input, or if an assembly binds it to an expression.
    pub fn open_input(&mut self, path: &str) -> Option<String> {
        let (instance, input) = path.rsplit_once('.')?;
        let place = self.instances.iter().position(|one| one.name.value == instance)?;
        let unit = self.instances[place].unit;
        let declared = self.units[unit].inputs.iter().position(|one| one.name.value == input)?;
        let bound =
            self.instances[place].inputs.iter().position(|(name, _)| name.value == input)?;
        let spec = self.units[unit].inputs[declared].clone();
        let value = match &self.instances[place].inputs[bound].1 {
            Formula::Number(number) => Value::Number(number.value.0.to_f64()?),
            Formula::Expression(ast) if is_quantity(ast) => Value::Expression(ast.clone()),
            Formula::Expression(ast) => {
                let ast = ast.clone();
                if self.instances[place].parent.is_some() {
                    return None;
                }
                let name = self.free_name(&format!("added_to_{}", path.replace('.', "_")));
                let span = ast.span;
                let added = Ast { span, node: Node::Name(None, name.clone()) };
                let node = Node::Sum(vec![(false, ast), (false, added)]);
                self.instances[place].inputs[bound].1 = Formula::Expression(Ast { span, node });
                self.parameters.push(ParameterSpec {
                    name: Spanned { value: name.clone(), span },
                    value: Value::Number(0.0),
                    unit: spec.unit,
                    doc: format!("added to the input {path}"),
                    spread: None,
                });
                return Some(name);
            }
        };
        let mut own = self.units[unit].clone();
        own.inputs.remove(declared);
        own.parameters.push(ParameterSpec {
            name: spec.name,
            value,
            unit: spec.unit,
            doc: spec.doc,
            spread: None,
        });
        self.instances[place].inputs.remove(bound);
        self.instances[place].unit = self.units.len();
        self.units.push(own);
        Some(path.to_owned())
    }

    fn free_name(&self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let is_taken = |name: &str| {
            self.parameters.iter().any(|one| one.name.value == name)
                || self.helpers.iter().any(|one| one.name.value == name)
                || self.instances.iter().any(|one| one.name.value == name)
        };
        while is_taken(&name) {
            name.push('_');
        }
        name
    }
}

/// Returns whether an expression is a number with a unit.
fn is_quantity(ast: &Ast) -> bool {
    match &ast.node {
        Node::Number(_, unit) => unit.is_some(),
        Node::Negative(of) => is_quantity(of),
        _ => false,
    }
}

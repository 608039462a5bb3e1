//! Parameters: numbers that runs may change, or expressions of parameters.
//!
//! A number in other units (`"18 [kN m/rad]"`, `"1500 [rpm]"`) is a number. A parameter given by an expression
//! (`inertia = "mass*radius^2/2"`, or that of an instance by the scene) is substituted wherever
//! it is used, like a helper, and is not a parameter of the model.

use std::f64::consts::PI;

use crate::scene::evaluate::evaluate;
use crate::scene::layout::{Layout, Local, Scope, find_inside};
use crate::scene::resolve::{Resolver, Wanted};
use crate::scene::system::Required;
use crate::scene::typed::{Typed, Uses};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Unit;
use crate::spec::expression::{Ast, Node};
use crate::spec::{ParameterSpec, SceneSpec, Value, did_you_mean, quoted};
use machinist_algebra::expr::{Expr, ParameterId};
use machinist_model::Bound;

/// The value of a parameter.
pub enum Given<'a> {
    /// A number in SI units.
    Number(f64),
    /// An expression, and its scope.
    Expression(&'a Ast, Scope),
}

/// Returns the parameter of a scope with this index.
pub fn declared(spec: &SceneSpec, scope: Scope, index: usize) -> &ParameterSpec {
    match scope.base() {
        Scope::Instance(instance) => &spec.units[spec.instances[instance].unit].parameters[index],
        _ => &spec.parameters[index],
    }
}

/// Returns its value: from the instance, else from its unit.
pub fn given(spec: &SceneSpec, scope: Scope, index: usize) -> Given<'_> {
    let parameter = declared(spec, scope, index);
    let other = match scope.base() {
        Scope::Instance(instance) => other(spec, instance, &parameter.name.value),
        _ => None,
    };
    let (ast, whose) = match (other, &parameter.value) {
        (Some((Value::Number(number), _)), _) => return Given::Number(*number),
        (Some((Value::Expression(ast), whose)), _) => (ast, whose),
        (None, Value::Number(number)) => {
            return Given::Number(number * parameter.unit.factor.to_f64());
        }
        (None, Value::Expression(ast)) => (ast, scope.base()),
    };
    match quantity(ast) {
        // A different dimension is rejected as in any expression.
        Some((number, unit)) if unit.dimension == parameter.unit.unit.dimension => {
            Given::Number(number)
        }
        _ => Given::Expression(ast, whose),
    }
}

/// Returns a number with a unit and a sign, in SI units.
fn quantity(ast: &Ast) -> Option<(f64, Unit)> {
    match &ast.node {
        Node::Number(number, Some(unit)) => {
            let value = evaluate(&Expr::Number(number.0.clone()), &|_| f64::NAN);
            value.is_finite().then_some((value, *unit))
        }
        Node::Negative(of) => quantity(of).map(|(number, unit)| (-number, unit)),
        // A number in rpm or degrees: the parser multiplies it by pi, which has the same span.
        Node::Product(factors) => {
            let [(_, number), pis @ ..] = &factors[..] else { return None };
            let is_pi = |of: &Ast| of.span == ast.span && of.node == Node::Name(None, "pi".into());
            let (number, unit) = quantity(number).filter(|_| number.span == ast.span)?;
            let product = pis.iter().try_fold(number, |product, (divides, of)| {
                is_pi(of).then(|| if *divides { product / PI } else { product * PI })
            });
            Some((product?, unit))
        }
        _ => None,
    }
}

/// Returns the value that replaces the unit's for an instance's parameter, and its scope. The
/// scene takes precedence over assemblies.
fn other<'a>(spec: &'a SceneSpec, instance: usize, name: &str) -> Option<(&'a Value, Scope)> {
    let one = &spec.instances[instance];
    let from_outside = one.parent.and_then(|parent| {
        let part = &one.name.value[spec.instances[parent].name.value.len() + 1..];
        other(spec, parent, &format!("{part}.{name}"))
    });
    from_outside.or_else(|| {
        let (_, value) = one.parameters.iter().find(|(known, _)| known.value == name)?;
        Some((value, Scope::within(one.parent)))
    })
}

/// Returns the instance and name of a parameter that an instance sets, its own or that of an
/// inner instance.
fn given_by<'p>(
    spec: &SceneSpec,
    instance: usize,
    path: &'p Spanned<String>,
) -> Result<(usize, &'p str), Box<Mistake>> {
    match path.value.rsplit_once('.') {
        None => Ok((instance, &path.value)),
        Some((part, name)) => Ok((find_inside(spec, instance, part, path.span)?, name)),
    }
}

/// Iterates over the parameters of the scene, then over those of its instances.
pub(super) fn all(spec: &SceneSpec) -> impl Iterator<Item = (Scope, usize)> {
    let own = (0..spec.parameters.len()).map(|index| (Scope::Scene, index));
    let of_instances = spec.instances.iter().enumerate().flat_map(|(instance, one)| {
        let count = spec.units[one.unit].parameters.len();
        (0..count).map(move |index| (Scope::Instance(instance), index))
    });
    own.chain(of_instances)
}

/// Iterates over the parameters that are numbers, with their values, in the order of their ids.
pub fn numbers(spec: &SceneSpec) -> impl Iterator<Item = (Scope, usize, f64)> {
    all(spec).filter_map(|(scope, index)| match given(spec, scope, index) {
        Given::Number(number) => Some((scope, index, number)),
        Given::Expression(..) => None,
    })
}

/// Returns the values of the parameters that are numbers, and checks that the scene names only
/// parameters of its units.
pub fn values(spec: &SceneSpec, layout: &Layout, mistakes: &mut Vec<Mistake>) -> Vec<f64> {
    for (index, instance) in spec.instances.iter().enumerate() {
        for (path, _) in &instance.parameters {
            let (owner, name) = match given_by(spec, index, path) {
                Ok(found) => found,
                Err(mistake) => {
                    mistakes.push(*mistake);
                    continue;
                }
            };
            let owner = spec.instances[owner].unit;
            if let Some(Local::Parameter(_)) = layout.units[owner].get(name) {
                continue;
            }
            let unit = &spec.units[owner];
            let (unit_name, wanted) = (quoted(&unit.name), quoted(name));
            let message = format!("unit {unit_name} has no parameter {wanted}");
            let known = unit.parameters.iter().map(|parameter| parameter.name.value.as_str());
            let help = did_you_mean(name, known);
            mistakes.push(
                Mistake::new(Code::UnknownParameter, path.span, message, "unknown").help(help),
            );
        }
    }
    numbers(spec).map(|(.., value)| value).collect()
}

/// Resolves every parameter that is an expression. Each depends on parameters only, has its
/// declared dimension, and is finite at the values of the spec.
pub fn check(
    resolver: &mut Resolver<'_>,
    values: &[f64],
    mistakes: &mut Vec<Mistake>,
) -> Vec<Required> {
    let spec = resolver.spec;
    let mut required = Vec::new();
    for (scope, index) in all(spec) {
        let Given::Expression(ast, _) = given(spec, scope, index) else { continue };
        let name = &declared(spec, scope, index).name;
        let finite = resolver.value(&name.value, ast.span, scope).and_then(|typed| {
            let value = evaluate(&typed.expr, &|id: ParameterId| values[id.0 as usize]);
            if value.is_finite() {
                let rule = format!(
                    "parameter {} is a finite number",
                    quoted(&path(spec, scope, &name.value))
                );
                required.push(Required::new(&typed.expr, Bound::Finite, rule));
                return Ok(());
            }
            let message = format!("parameter {} is {value} here", quoted(&name.value));
            Err(Box::new(Mistake::new(Code::OutOfRange, ast.span, message, "not a finite number")))
        });
        mistakes.extend(finite.err().map(|mistake| *mistake));
    }
    required
}

/// Returns the name of a parameter with that of its instance.
pub(super) fn path(spec: &SceneSpec, scope: Scope, name: &str) -> String {
    match scope {
        Scope::Instance(instance) => format!("{}.{name}", spec.instances[instance].name.value),
        _ => name.to_owned(),
    }
}

impl Resolver<'_> {
    /// Resolves a parameter that is an expression, of its declared dimension.
    pub(super) fn given(
        &mut self,
        scope: Scope,
        index: usize,
        span: Span,
    ) -> Result<Typed, Box<Mistake>> {
        let parameter = declared(self.spec, scope, index);
        let Given::Expression(ast, whose) = given(self.spec, scope, index) else {
            return Err(Box::new(Mistake::new(
                Code::NotConstant,
                span,
                "this parameter must be a number",
                "a number",
            )));
        };
        let what = format!("parameter {}", quoted(&parameter.name.value));
        let wanted = Wanted::new(parameter.unit.unit.dimension, what).of(Uses::PARAMETERS);
        self.nested(ast, whose, &wanted)
    }
}

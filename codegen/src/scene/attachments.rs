//! Places of ports on fields, and boundary conditions of fields.

use crate::scene::evaluate::evaluate;
use crate::scene::layout::{Attachment, Layout, Local, Scope};
use crate::scene::resolve::{Resolver, Wanted};
use crate::scene::system::Required;
use crate::scene::typed::{Uses, integer, product, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::{Boundary, FieldSpec, Formula, InstanceSpec, SceneSpec, did_you_mean, quoted};
use machinist_algebra::expr::{Expr, ParameterId};
use machinist_model::{Bound, Place};

/// Finds the place of every port on a field, and checks the scene's settings for fields.
pub fn locate(
    spec: &SceneSpec,
    layout: &mut Layout,
    parameter: &impl Fn(ParameterId) -> f64,
    mistakes: &mut Vec<Mistake>,
) {
    choices(spec, mistakes);
    let mut found = Vec::new();
    let mut required = Vec::new();
    let mut resolver = Resolver::new(spec, layout);
    for (index, instance) in spec.instances.iter().enumerate() {
        let unit = &spec.units[instance.unit];
        for (number, field) in unit.fields.iter().enumerate() {
            let length = match length(&mut resolver, index, field, parameter) {
                Ok(length) => length,
                Err(mistake) => {
                    mistakes.push(*mistake);
                    continue;
                }
            };
            let (length_expr, length) = length;
            let name = |name: &str| quoted(&format!("{}.{name}", instance.name.value));
            let rule = format!("the length of field {} is above 0 m", name(&field.name.value));
            required.push(Required::new(&length_expr, Bound::Positive, rule));
            let fixed = ends(instance, field).map(|end| end == Boundary::Fixed);
            for (port_index, port) in unit.ports.iter().enumerate() {
                let Some(attachment) = &port.attachment else { continue };
                if attachment.field.value != field.name.value {
                    continue;
                }
                let resolved = place(&mut resolver, index, &attachment.at, length, parameter);
                let (expr, x) = match resolved {
                    Ok(place) => place,
                    Err(mistake) => {
                        mistakes.push(*mistake);
                        continue;
                    }
                };
                let after =
                    sum(vec![length_expr.clone(), product(vec![integer(-1), expr.clone()])]);
                let port_name = name(&port.name.value);
                for (value, rule) in [
                    (&expr, format!("the place of port {port_name} is at 0 m or beyond")),
                    (
                        &after,
                        format!("the length of the field beyond port {port_name} is 0 m or more"),
                    ),
                ] {
                    required.push(Required::new(value, Bound::NotNegative, rule));
                }
                let place = match x {
                    x if x <= 0.0 => Place::Start,
                    x if x >= length => Place::End,
                    _ => Place::Inside,
                };
                let fixed = match place {
                    Place::Start => fixed[0],
                    Place::End => fixed[1],
                    Place::Inside => false,
                };
                let at = Attachment {
                    instance: index,
                    field: number,
                    port: port_index,
                    expr,
                    x,
                    place,
                    fixed,
                };
                found.push((at, attachment.at.span()));
            }
        }
    }
    drop(resolver);
    layout.required.extend(required);
    found.sort_by(|(a, _), (b, _)| {
        (a.instance, a.field).cmp(&(b.instance, b.field)).then(a.x.total_cmp(&b.x))
    });
    for pair in found.windows(2) {
        let [(a, _), (b, span)] = pair else { continue };
        if (a.instance, a.field) == (b.instance, b.field) && a.x.to_bits() == b.x.to_bits() {
            let unit = &spec.units[spec.instances[a.instance].unit];
            let name = quoted(&unit.ports[a.port].name.value);
            let message = format!("port {name} is at the same point of the field");
            let help = "join all parts at one point of a field to one port";
            mistakes
                .push(Mistake::new(Code::InvalidJoint, *span, message, "same point").help(help));
        }
    }
    layout.attach(spec, found.into_iter().map(|(attachment, _)| attachment).collect());
}

/// Returns the boundary conditions of a field: the scene's, else the unit's.
pub fn ends(instance: &InstanceSpec, field: &FieldSpec) -> [Boundary; 2] {
    let choice = instance.fields.iter().find(|choice| choice.field.value == field.name.value);
    let chosen = choice.map_or([None, None], |choice| choice.ends);
    [0, 1].map(|end| chosen[end].unwrap_or(field.ends[end]))
}

/// Checks that every field of every instance is divided into elements, and nothing else is, and
/// that ports name existing fields.
fn choices(spec: &SceneSpec, mistakes: &mut Vec<Mistake>) {
    for unit in &spec.units {
        let names = || unit.fields.iter().map(|field| field.name.value.as_str());
        for port in &unit.ports {
            let Some(at) = &port.attachment else { continue };
            if !names().any(|name| name == at.field.value) {
                let message = format!("unknown field {}", quoted(&at.field.value));
                let help = did_you_mean(&at.field.value, names());
                mistakes.push(
                    Mistake::new(Code::UnknownName, at.field.span, message, "unknown").help(help),
                );
            }
        }
    }
    for instance in &spec.instances {
        let unit = &spec.units[instance.unit];
        let names = || unit.fields.iter().map(|field| field.name.value.as_str());
        for choice in &instance.fields {
            if !names().any(|name| name == choice.field.value) {
                let (unit, field) = (quoted(&unit.name), quoted(&choice.field.value));
                let message = format!("unit {unit} has no field {field}");
                let help = did_you_mean(&choice.field.value, names());
                mistakes.push(
                    Mistake::new(Code::UnknownName, choice.field.span, message, "unknown")
                        .help(help),
                );
            }
        }
        for name in names() {
            if !instance.fields.iter().any(|choice| choice.field.value == name) {
                let field = quoted(&format!("{}.{name}", instance.name.value));
                let message = format!("the scene does not define the elements of {field}");
                let help = format!("write fields = {{ {name} = {{ elements = 32, order = 4 }} }}");
                let mistake =
                    Mistake::new(Code::InvalidField, instance.name.span, message, "lacks `fields`");
                mistakes.push(mistake.help(help));
            }
        }
    }
}

/// Returns the length of a field, and its value in the spec.
fn length(
    resolver: &mut Resolver<'_>,
    index: usize,
    field: &FieldSpec,
    parameter: &impl Fn(ParameterId) -> f64,
) -> Result<(Expr, f64), Box<Mistake>> {
    let (layout, spec) = (resolver.layout, resolver.spec);
    let instance = &spec.instances[index];
    let unit = &spec.units[instance.unit];
    let Some(Local::Parameter(number)) = layout.units[instance.unit].get(&field.over.value) else {
        let message = format!(
            "the length of a field must be a parameter of its unit, but {} is not",
            quoted(&field.over.value)
        );
        let known = unit.parameters.iter().map(|parameter| parameter.name.value.as_str());
        let help = did_you_mean(&field.over.value, known);
        return Err(Box::new(
            Mistake::new(Code::InvalidField, field.over.span, message, "no parameter").help(help),
        ));
    };
    let declared = &unit.parameters[number];
    if declared.unit.unit.dimension != Dimension::LENGTH {
        let message = "the length of a field must be in m";
        let label = format!("this parameter is in {}", declared.unit.unit.dimension);
        return Err(Box::new(Mistake::new(
            Code::DimensionMismatch,
            field.over.span,
            message,
            label,
        )));
    }
    let (over, scope) = (&field.over, Scope::Instance(index));
    let length = resolver.value(&over.value, over.span, scope)?.expr;
    let value = evaluate(&length, parameter);
    if value > 0.0 && value.is_finite() {
        return Ok((length, value));
    }
    let own = instance.parameters.iter().find(|(name, _)| name.value == field.over.value);
    let span = own.map_or(declared.name.span, |(name, _)| name.span);
    let message =
        format!("a field must be longer than 0, but {} is {value} m", quoted(&field.over.value));
    Err(Box::new(Mistake::new(Code::OutOfRange, span, message, "not a length")))
}

/// Returns the place of a port and its value, which lies on the field.
fn place(
    resolver: &mut Resolver<'_>,
    instance: usize,
    at: &Formula,
    length: f64,
    parameter: &impl Fn(ParameterId) -> f64,
) -> Result<(Expr, f64), Box<Mistake>> {
    let wanted = Wanted::new(Dimension::LENGTH, "the position of a port").of(Uses::PARAMETERS);
    let typed = resolver.formula(at, Scope::Instance(instance), &wanted)?;
    let x = evaluate(&typed.expr, parameter);
    if (0.0..=length).contains(&x) {
        return Ok((typed.expr, x));
    }
    let message = format!("a port is on its field, from 0 to {length} m, but this one is at {x} m");
    Err(Box::new(Mistake::new(Code::OutOfRange, at.span(), message, "outside of the field")))
}

//! Ports that move by a multiple of their coordinate: gears, racks, levers.

use crate::scene::evaluate::evaluate;
use crate::scene::layout::{Layout, Scope, coordinate_spec};
use crate::scene::resolve::{Resolver, Wanted, beyond_reason};
use crate::scene::typed::{Uses, integer};
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::{Formula, PortKind, PortSpec, SceneSpec};
use machinist_algebra::expr::{Expr, ParameterId};

/// Returns the dimension of a port's displacement: that of its kind, or of its coordinate if it
/// has no ratio.
pub fn dimension_of(spec: &SceneSpec, layout: &Layout, port: &PortSpec, slot: usize) -> Dimension {
    let own = coordinate_spec(spec, layout, slot).unit.unit.dimension;
    match port.kind.value {
        _ if port.ratio.is_none() => own,
        PortKind::Rotational => Dimension::ONE,
        PortKind::Translational => Dimension::LENGTH,
        PortKind::Electrical | PortKind::Frame => own,
    }
}

/// Returns the displacement of a port per displacement of its coordinate; `None` for 1.
///
/// # Errors
/// If it has the wrong dimension, or depends on anything but parameters.
pub fn ratio_of(
    resolver: &mut Resolver<'_>,
    port: &PortSpec,
    slot: usize,
) -> Result<Option<Expr>, Box<Mistake>> {
    let Some(formula) = &port.ratio else { return Ok(None) };
    let (spec, layout) = (resolver.spec, resolver.layout);
    let own = coordinate_spec(spec, layout, slot).unit.unit.dimension;
    let dimension = dimension_of(spec, layout, port, slot).over(own);
    let dimension = dimension.ok_or_else(|| beyond_reason(formula.span()))?;
    let wanted = Wanted::new(dimension, "the ratio of a port").of(Uses::PARAMETERS);
    let (instance, _) = layout.coordinate(slot);
    let ratio = resolver.formula(formula, Scope::Instance(instance), &wanted)?.expr;
    Ok((ratio != integer(1)).then_some(ratio))
}

/// Rejects ratios that are 0 or not finite at the values of the spec.
///
/// # Errors
/// A mistake with the value.
pub fn require_ratio(
    ratio: Option<&Expr>,
    formula: Option<&Formula>,
    parameter: &impl Fn(ParameterId) -> f64,
) -> Result<(), Box<Mistake>> {
    let (Some(ratio), Some(formula)) = (ratio, formula) else { return Ok(()) };
    let value = evaluate(ratio, parameter);
    if value != 0.0 && value.is_finite() {
        return Ok(());
    }
    let message = format!("a ratio must be a number other than 0, but this one is {value}");
    Err(Box::new(Mistake::new(Code::InvalidJoint, formula.span(), message, "not a ratio")))
}

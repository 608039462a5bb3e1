//! Instances, ports and coordinates by their names.

use super::{Layout, Local, Names};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::{Dimension, Unit};
use crate::spec::{
    CoordinateSpec, Declared, PortKind, PortSpec, SceneSpec, UnitSpec, did_you_mean, port_names,
    quoted,
};

/// Returns the coordinate of an instance, by slot.
pub fn coordinate_spec<'a>(
    spec: &'a SceneSpec,
    layout: &Layout,
    slot: usize,
) -> &'a CoordinateSpec {
    let (instance, index) = layout.coordinate(slot);
    &spec.units[spec.instances[instance].unit].coordinates[index]
}

/// Finds the instance of a name.
pub fn find_instance(spec: &SceneSpec, name: &str, span: Span) -> Result<usize, Box<Mistake>> {
    let found = spec.instances.iter().position(|instance| instance.name.value == name);
    found.ok_or_else(|| {
        let message = format!("unknown instance {}", quoted(name));
        let names = spec.instances.iter().map(|instance| instance.name.value.as_str());
        Box::new(
            Mistake::new(Code::UnknownInstance, span, message, "unknown")
                .help(did_you_mean(name, names)),
        )
    })
}

/// Finds the instance of a path within a unit.
pub fn find_inside(
    spec: &SceneSpec,
    assembly: usize,
    path: &str,
    span: Span,
) -> Result<usize, Box<Mistake>> {
    let unit = &spec.units[spec.instances[assembly].unit];
    if !unit.is_assembly() {
        let message = "names with a dot are allowed in scenes and assemblies only";
        let help = "a unit sees only its own names: use an input, bound by the scene";
        return Err(Box::new(
            Mistake::new(Code::OutOfScope, span, message, "not in a unit").help(help),
        ));
    }
    let whole = format!("{}.{path}", spec.instances[assembly].name.value);
    let found = spec.instances.iter().position(|instance| instance.name.value == whole);
    found.ok_or_else(|| {
        let message = format!("there is no {} inside {}", quoted(path), quoted(&unit.name));
        let names = unit.inside.instances.iter().map(|text| text.name.value.as_str());
        Box::new(
            Mistake::new(Code::UnknownInstance, span, message, "unknown")
                .help(did_you_mean(path, names)),
        )
    })
}

/// Finds the instance and the port of a path `instance.port`.
fn find<'a>(
    spec: &'a SceneSpec,
    path: &Spanned<String>,
) -> Result<(usize, &'a PortSpec), Box<Mistake>> {
    let Some((instance, port)) = path.value.rsplit_once('.') else {
        let message = format!("{} is not a port", quoted(&path.value));
        let mistake = Mistake::new(Code::WrongKindOfName, path.span, message, "not instance.port");
        return Err(Box::new(mistake.help("write a port as instance.port")));
    };
    let instance = find_instance(spec, instance, path.span)?;
    let unit = &spec.units[spec.instances[instance].unit];
    let found = unit.ports.iter().find(|candidate| candidate.name.value == port);
    found.map(|found| (instance, found)).ok_or_else(|| {
        let message = format!("unit {} has no port {}", quoted(&unit.name), quoted(port));
        let help = did_you_mean(port, port_names(unit));
        Box::new(Mistake::new(Code::UnknownPort, path.span, message, "unknown").help(help))
    })
}

/// Returns the instance and the index of the frame of a port; `None` if it is of another kind.
///
/// # Errors
/// If there is no such port.
pub fn frame_of_port(
    spec: &SceneSpec,
    path: &Spanned<String>,
) -> Result<Option<(usize, usize)>, Box<Mistake>> {
    let (instance, port) = find(spec, path)?;
    if port.kind.value != PortKind::Frame {
        return Ok(None);
    }
    let unit = &spec.units[spec.instances[instance].unit];
    let index = unit.frames.iter().position(|frame| frame.name.value == port.name.value);
    Ok(index.map(|index| (instance, index)))
}

/// Finds the port of a path `instance.port`, and its coordinate's slot.
pub fn find_port<'a>(
    spec: &'a SceneSpec,
    layout: &Layout,
    path: &Spanned<String>,
) -> Result<(&'a PortSpec, usize), Box<Mistake>> {
    let (instance, found) = find(spec, path)?;
    let unit_index = spec.instances[instance].unit;
    let unit = &spec.units[unit_index];
    if found.kind.value == PortKind::Frame {
        let message = format!("{} is a frame, which has no coordinate", quoted(&path.value));
        let mistake = Mistake::new(Code::WrongKindOfName, path.span, message, "a frame");
        return Err(Box::new(mistake.help("join it to another frame")));
    }
    match layout.units[unit_index].get(&found.coordinate.value) {
        Some(Local::Coordinate(index)) => {
            let slot = layout.slot(instance, index);
            if layout.is_fixed_end(slot) {
                let message = format!("{} is at a fixed end", quoted(&path.value));
                let help = "an end has one boundary condition: remove this one, or leave the end \
                            free";
                let mistake = Mistake::new(Code::InvalidJoint, path.span, message, "fixed already");
                return Err(Box::new(mistake.help(help)));
            }
            Ok((found, slot))
        }
        _ => Err(Box::new(unknown_coordinate(&found.coordinate, unit))),
    }
}

/// Returns the mistake of a coordinate that a unit does not have.
pub fn unknown_coordinate(name: &Spanned<String>, unit: &UnitSpec) -> Mistake {
    let message = format!("unknown coordinate {}", quoted(&name.value));
    let names = unit.coordinates.iter().map(|c| c.name.value.as_str());
    Mistake::new(Code::UnknownName, name.span, message, "unknown")
        .help(did_you_mean(&name.value, names))
}

/// Checks that a port's coordinate exists and has the dimension of its kind.
pub(super) fn check_port(
    port: &PortSpec,
    unit: &UnitSpec,
    names: &Names,
    mistakes: &mut Vec<Mistake>,
) {
    if port.kind.value == PortKind::Frame {
        return;
    }
    let Some(Local::Coordinate(index)) = names.get(&port.coordinate.value) else {
        mistakes.push(unknown_coordinate(&port.coordinate, unit));
        return;
    };
    if unit.coordinates[index].orientation.is_some() {
        let message = "a part of an orientation cannot be the coordinate of a port";
        let mistake = Mistake::new(
            Code::WrongKindOfName,
            port.coordinate.span,
            message,
            "part of a quaternion",
        );
        mistakes.push(mistake.help("a joint that turns about one axis has an angle"));
        return;
    }
    let Declared { unit: Unit { dimension, .. }, .. } = unit.coordinates[index].unit;
    let (fits, wanted) = match port.kind.value {
        PortKind::Rotational => (dimension == Dimension::ONE, "an angle in rad"),
        PortKind::Translational => (dimension == Dimension::LENGTH, "a length in m"),
        PortKind::Electrical => {
            let fits = [Dimension::CHARGE, Dimension::FLUX].contains(&dimension);
            (fits, "a charge in C or a flux linkage in Wb")
        }
        PortKind::Frame => return,
    };
    if !fits && port.ratio.is_none() {
        let kind = port.kind.value.name();
        let message = format!("the coordinate of a port of kind {kind} must be {wanted}");
        let label = format!("its coordinate is in {dimension}");
        mistakes.push(Mistake::new(Code::DimensionMismatch, port.kind.span, message, label));
    }
}

//! Joints: identification of coordinates of instances with coordinates of the scene.

use std::collections::{BTreeSet, VecDeque};

use crate::scene::layout::{Layout, Link, Scope, find_port, frame_of_port};
use crate::scene::loops;
use crate::scene::ports::{dimension_of, ratio_of, require_ratio};
use crate::scene::resolve::{Resolver, Wanted};
use crate::scene::system::Required;
use crate::scene::typed::{Uses, integer, product, reciprocal};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::dimension::Dimension;
use crate::spec::{Formula, JointSpec, SceneSpec, quoted};
use machinist_algebra::expr::{CoordinateId, Expr, ParameterId};
use machinist_model::Bound;

/// q of slot `first` = ratio * q of slot `second`; `None` for 1.
struct Edge {
    slots: [usize; 2],
    ratio: Option<Expr>,
    /// Requirements on its ratios.
    required: Vec<Required>,
}

/// Identifies joined coordinates. One coordinate represents each joined set: a place on a field,
/// else that of the earliest instance with a kinetic energy of its own (a rotor's angle rather
/// than that of the coupling's end on it), else the earliest. Joints may close no loop, so the
/// others follow it by the product of ratios along a unique path.
/// Cuts loops of frames, but leaves out no coordinate in `kept`.
pub fn identify(
    spec: &SceneSpec,
    layout: &mut Layout,
    parameter: &impl Fn(ParameterId) -> f64,
    kept: &BTreeSet<usize>,
    mistakes: &mut Vec<Mistake>,
) {
    let (mut edges, mut joined) = (Vec::new(), Vec::new());
    let mut roots: Vec<usize> = (0..layout.links.len()).collect();
    let mut resolver = Resolver::new(spec, layout);
    for (index, joint) in spec.joints.iter().enumerate() {
        match frames(spec, joint) {
            Ok(None) => {}
            Ok(Some(ends)) => {
                joined.push((ends, joint.connect[1].span));
                continue;
            }
            Err(mistake) => {
                mistakes.push(*mistake);
                continue;
            }
        }
        let edge = edge(&mut resolver, joint, parameter).and_then(|edge| {
            unite(&mut roots, &edge, joint, &spec.joints[..index])?;
            Ok(edge)
        });
        match edge {
            Ok(edge) => edges.push(edge),
            Err(mistake) => mistakes.push(*mistake),
        }
    }
    drop(resolver);
    layout.joined_frames = joined;
    layout.required.extend(edges.iter().flat_map(|edge| edge.required.iter().cloned()));
    hold(spec, layout, &mut roots, mistakes);
    let is_joined = |slot: usize| edges.iter().any(|edge| edge.slots.contains(&slot));
    let is_kept = |slot: usize| kept.contains(&slot) || is_joined(slot) || layout.is_fixed(slot);
    match loops::cuts(&mut Resolver::new(spec, layout), parameter, &is_kept) {
        Ok(cuts) => layout.cuts = cuts,
        Err(mistake) => mistakes.push(*mistake),
    }
    let starts = starts(spec, layout, &mut roots);
    follow(layout, &edges, &starts);
    refuse_idle(spec, layout, mistakes);
}

/// Returns the frames that a joint makes one, each as instance and index; `None` for a joint of other
/// ports.
fn frames(
    spec: &SceneSpec,
    joint: &JointSpec,
) -> Result<Option<[(usize, usize); 2]>, Box<Mistake>> {
    let [first, second] = &joint.connect;
    let ends = [frame_of_port(spec, first)?, frame_of_port(spec, second)?];
    match ends {
        [None, None] => Ok(None),
        [Some(one), Some(other)] => {
            if let Some(ratio) = &joint.ratio {
                let message = "a joint of frames cannot have a ratio";
                return Err(Box::new(Mistake::new(
                    Code::InvalidJoint,
                    ratio.span(),
                    message,
                    "no multiple",
                )));
            }
            Ok(Some([one, other]))
        }
        [one, _] => {
            let (frame, other) = if one.is_some() { (first, second) } else { (second, first) };
            let [frame, other_name] = [frame, other].map(|path| quoted(&path.value));
            let message = format!(
                "a joint must connect ports of the same kind: {frame} is a frame, {other_name} is not"
            );
            Err(Box::new(Mistake::new(Code::InvalidJoint, other.span, message, "not a frame")))
        }
    }
}

/// Rejects parts that do nothing because joints make all of their coordinates one, such as a
/// spring whose ends are joined to each other.
fn refuse_idle(spec: &SceneSpec, layout: &Layout, mistakes: &mut Vec<Mistake>) {
    for (index, instance) in spec.instances.iter().enumerate() {
        let unit = &spec.units[instance.unit];
        let energy = &unit.energy;
        let lies_between = energy.potential.is_some() || energy.dissipation.is_some();
        let slots = (0..unit.coordinates.len()).map(|at| layout.slot(index, at));
        let slots: Vec<usize> = slots.collect();
        let is_of_more = energy.kinetic.is_some()
            || !unit.bodies.is_empty()
            || !unit.constraints.is_empty()
            || slots.iter().any(|slot| layout.attachment(*slot).is_some());
        let [first, others @ ..] = &slots[..] else { continue };
        let is_held = layout.is_absent(*first);
        let moves_as_first = |slot: &usize| {
            let (one, other) = (&layout.links[*first], &layout.links[*slot]);
            !is_held && !layout.is_absent(*slot) && one.id == other.id && one.factor == other.factor
        };
        if !lies_between || is_of_more || others.is_empty() || !others.iter().all(moves_as_first) {
            continue;
        }
        let names: Vec<String> = unit.coordinates.iter().map(|c| quoted(&c.name.value)).collect();
        let message = format!(
            "joints make {} of {} equal: the unit has no effect",
            names.join(" and "),
            quoted(&instance.name.value)
        );
        let mistake = Mistake::new(Code::NoEffect, instance.name.span, message, "joined to itself");
        mistakes.push(mistake.help("join its ends to different parts, or leave it out"));
    }
}

/// Returns the starting slot of each joined set, in the order of the sets' earliest slots.
fn starts(spec: &SceneSpec, layout: &Layout, roots: &mut [usize]) -> Vec<usize> {
    let has_inertia = |slot: usize| {
        let (instance, _) = layout.coordinate(slot);
        let unit = &spec.units[spec.instances[instance].unit];
        unit.energy.kinetic.is_some() || !unit.bodies.is_empty()
    };
    let mut starts: Vec<Option<usize>> = vec![None; layout.links.len()];
    let rank = |slot: usize| {
        (layout.attachment(slot).is_some(), layout.attachment(slot).is_none() && has_inertia(slot))
    };
    for slot in (0..layout.links.len()).filter(|slot| !layout.is_absent(*slot)) {
        let start = &mut starts[root(roots, slot)];
        if start.is_none_or(|start| rank(start) < rank(slot)) {
            *start = Some(slot);
        }
    }
    starts.into_iter().flatten().collect()
}

fn edge(
    resolver: &mut Resolver<'_>,
    joint: &JointSpec,
    parameter: &impl Fn(ParameterId) -> f64,
) -> Result<Edge, Box<Mistake>> {
    let (spec, layout) = (resolver.spec, resolver.layout);
    let [first, second] = &joint.connect;
    let (port, slot) = find_port(spec, layout, first)?;
    let (other, other_slot) = find_port(spec, layout, second)?;
    let (kind, other_kind) = (port.kind.value, other.kind.value);
    if kind != other_kind {
        let message = format!(
            "a joint must connect ports of the same kind: {} is {}, {} is {}",
            quoted(&first.value),
            kind.name(),
            quoted(&second.value),
            other_kind.name()
        );
        return Err(Box::new(Mistake::new(
            Code::InvalidJoint,
            second.span,
            message,
            other_kind.name(),
        )));
    }
    let dimension = dimension_of(spec, layout, port, slot);
    let other_dimension = dimension_of(spec, layout, other, other_slot);
    if dimension != other_dimension {
        let (first, other) = (quoted(&first.value), quoted(&second.value));
        let message = format!("{first} is in {dimension}, {other} in {other_dimension}");
        let label = format!("in {other_dimension}");
        return Err(Box::new(Mistake::new(Code::InvalidJoint, second.span, message, label)));
    }
    let of_joint = match &joint.ratio {
        Some(formula) => {
            let wanted = Wanted::new(Dimension::ONE, "a ratio").of(Uses::PARAMETERS);
            Some(resolver.formula(formula, Scope::within(joint.within), &wanted)?.expr)
        }
        None => None,
    };
    let mut required = Vec::new();
    let mut require = |ratio: Option<&Expr>, formula: Option<&Formula>, of: String| {
        require_ratio(ratio, formula, parameter)?;
        let rule = format!("the ratio of {of} is a number other than 0");
        required.extend(ratio.map(|ratio| Required::new(ratio, Bound::NotZero, rule)));
        Ok::<_, Box<Mistake>>(())
    };
    let joint_of = format!("the joint of {} and {}", quoted(&first.value), quoted(&second.value));
    require(of_joint.as_ref(), joint.ratio.as_ref(), joint_of)?;
    let ends = [(port, slot, first), (other, other_slot, second)];
    let [own, others] = ends.map(|(port, slot, name)| {
        let ratio = ratio_of(resolver, port, slot)?;
        require(ratio.as_ref(), port.ratio.as_ref(), format!("port {}", quoted(&name.value)))?;
        Ok::<_, Box<Mistake>>(ratio)
    });
    // p q = ratio p' q', where p and p' are the ratios of the two ports.
    let factors: Vec<Expr> =
        of_joint.into_iter().chain(others?).chain(own?.map(reciprocal)).collect();
    let ratio = product(factors);
    let ratio = (ratio != integer(1)).then_some(ratio);
    Ok(Edge { slots: [slot, other_slot], ratio, required })
}

/// Fixes the coordinates that are joined to a fixed one.
fn hold(spec: &SceneSpec, layout: &mut Layout, roots: &mut [usize], mistakes: &mut Vec<Mistake>) {
    let slots = 0..layout.links.len();
    let fixed: Vec<usize> = slots.clone().filter(|slot| layout.is_held(*slot)).collect();
    for slot in fixed.into_iter().map(|slot| root(roots, slot)).collect::<Vec<_>>() {
        for other in slots.clone().filter(|other| root(roots, *other) == slot) {
            layout.hold(other);
            if layout.attachment(other).is_some() {
                let (instance, _) = layout.coordinate(other);
                let name = &spec.instances[instance].name;
                let message =
                    format!("a field of {} is joined to a fixed part", quoted(&name.value));
                let help = "fix the end of the field instead: start = \"fixed\"";
                mistakes.push(
                    Mistake::new(Code::InvalidJoint, name.span, message, "fixed by a joint")
                        .help(help),
                );
            }
        }
    }
    if !layout.links.is_empty()
        && slots.clone().all(|slot| layout.is_fixed(slot))
        && let Some(instance) = spec.instances.first()
    {
        let mistake = Mistake::new(
            Code::NothingMoves,
            instance.name.span,
            "every coordinate is fixed",
            "nothing moves",
        );
        mistakes.push(mistake.help("join one of them to something that is not fixed"));
    }
}

/// Joins two sets, by union-find with path halving.
fn unite(
    roots: &mut [usize],
    edge: &Edge,
    joint: &JointSpec,
    before: &[JointSpec],
) -> Result<(), Box<Mistake>> {
    if join(roots, edge.slots) {
        return Ok(());
    }
    let pair = |joint: &JointSpec| {
        let mut pair = joint.connect.clone().map(|Spanned { value, .. }| value);
        pair.sort();
        pair
    };
    let [first, second] = &joint.connect;
    let span = first.span.to(second.span);
    let (first, second) = (quoted(&first.value), quoted(&second.value));
    let mistake = if before.iter().any(|other| pair(other) == pair(joint)) {
        Mistake::new(
            Code::JointLoop,
            span,
            format!("{first} and {second} are joined twice"),
            "joined before",
        )
    } else {
        let message = format!("the joint of {first} and {second} closes a loop");
        Mistake::new(Code::JointLoop, span, message, "already joined by other joints")
            .help("the ratios around a loop would have to agree; leave this joint out")
    };
    Err(Box::new(mistake))
}

/// Joins the sets of two slots; returns false if they are one set.
pub(super) fn join(roots: &mut [usize], slots: [usize; 2]) -> bool {
    let [a, b] = slots.map(|slot| root(roots, slot));
    roots[a.max(b)] = a.min(b);
    a != b
}

/// Returns the representative of a joined set.
pub(super) fn root(roots: &mut [usize], mut slot: usize) -> usize {
    while roots[slot] != slot {
        roots[slot] = roots[roots[slot]];
        slot = roots[slot];
    }
    slot
}

/// Follows each joined set from its representative coordinate.
fn follow(layout: &mut Layout, edges: &[Edge], starts: &[usize]) {
    let count = layout.links.len();
    let mut near: Vec<Vec<usize>> = vec![Vec::new(); count];
    for (index, edge) in edges.iter().enumerate() {
        edge.slots.iter().for_each(|slot| near[*slot].push(index));
    }
    let mut links: Vec<Option<Link>> = vec![None; count];
    layout.representatives.clear();
    for &slot in starts {
        let id = CoordinateId(layout.representatives.len() as u32);
        layout.representatives.push(slot);
        links[slot] = Some(Link { id, factor: None });
        let mut queue = VecDeque::from([(slot, None::<Expr>)]);
        while let Some((here, factor)) = queue.pop_front() {
            for edge in near[here].iter().map(|index| &edges[*index]) {
                let forward = edge.slots[0] == here;
                let next = edge.slots[usize::from(forward)];
                if links[next].is_some() {
                    continue;
                }
                let ratio = edge.ratio.clone();
                let step = if forward { ratio.map(reciprocal) } else { ratio };
                let factor = match (factor.clone(), step) {
                    (Some(a), Some(b)) => Some(product(vec![a, b])).filter(|f| *f != integer(1)),
                    (a, b) => a.or(b),
                };
                links[next] = Some(Link { id, factor: factor.clone() });
                queue.push_back((next, factor));
            }
        }
    }
    // A fixed coordinate, or one that is left out, follows any other with factor 0.
    let fixed = || Link { id: CoordinateId(0), factor: Some(integer(0)) };
    layout.links = links.into_iter().map(|link| link.unwrap_or_else(fixed)).collect();
}

//! Trees of frames of instances that joints connect.
//!
//! The frames of all instances are nodes of a graph. A frame and its parent are an edge with the
//! steps that lead from one to the other, a joint of two ports an edge without any. The tree starts
//! at the world and follows edges either way: backwards, the steps are undone in reverse order. So
//! joint coordinates alone describe the machine, whichever way its parts are joined. Edges that close
//! loops are cut ([`loops`](super::loops)).

use std::collections::HashMap;

use machinist_algebra::cas::arithmetic::negative;
use machinist_algebra::expr::Expr;

use crate::scene::bodies::{Spatial, Step};
use crate::scene::drawing::{Attached, Taken};
use crate::scene::layout::{Layout, Scope};
use crate::scene::resolve::Resolver;
use crate::spatial::mechanism::{Frame, Kind, Mechanism};
use crate::spatial::vector::{minus, multiplied, plus, rotation, times, transposed};
use crate::spec::body::{FrameSpec, WORLD};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::{SceneSpec, UnitSpec, did_you_mean, quoted};

/// A frame by instance and index; `None` for the world.
pub type Node = Option<(usize, usize)>;

/// A connection of two nodes.
#[derive(Debug, Clone)]
pub struct Edge {
    pub id: EdgeId,
    pub ends: [Node; 2],
    pub span: Span,
}

/// Kind and index of a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EdgeId {
    /// The frame, by instance and index, whose steps lead from the first node to the second.
    Frame(usize, usize),
    /// A joint of two ports, by its index among those of frames.
    Joint(usize),
}

impl Resolver<'_> {
    /// Returns the instances whose frames are connected with those of one, itself included.
    pub(super) fn connected(&self, instance: usize) -> Vec<usize> {
        let (mut found, mut next) = (vec![instance], 0);
        while let Some(here) = found.get(next).copied() {
            for ([(one, _), (other, _)], _) in &self.layout.joined_frames {
                for (from, to) in [(*one, *other), (*other, *one)] {
                    if from == here && !found.contains(&to) {
                        found.push(to);
                    }
                }
            }
            next += 1;
        }
        found.sort_unstable();
        found
    }

    /// Builds the tree of connected instances.
    pub(super) fn build(&mut self, instances: &[usize]) -> Result<Spatial, Box<Mistake>> {
        let gravity = self.gravity(instances)?;
        let mut tree = Mechanism::new(gravity);
        let mut edges = edges(self.spec, self.layout, instances)?;
        edges.retain(|edge| !self.layout.cuts.iter().any(|cut| cut.edge == edge.id));
        let mut frames: HashMap<Node, Frame> = HashMap::from([(None, Mechanism::world())]);
        let (mut taken, mut bodies) = (Vec::new(), Vec::new());
        let mut near: HashMap<Node, Vec<usize>> = HashMap::new();
        for (index, edge) in edges.iter().enumerate() {
            edge.ends.iter().for_each(|end| near.entry(*end).or_default().push(index));
        }
        // Depth first, in the order of the spec, so that the joints of a chain follow each other.
        let mut stack: Vec<(Node, usize)> =
            near.get(&None).into_iter().flatten().rev().map(|edge| (None, *edge)).collect();
        while let Some((from, index)) = stack.pop() {
            let edge = &edges[index];
            let forward = edge.ends[0] == from;
            let to = edge.ends[usize::from(forward)];
            if frames.contains_key(&to) {
                continue;
            }
            let at = frames[&from].clone();
            let there = match edge.id {
                EdgeId::Joint(_) => at,
                EdgeId::Frame(instance, frame) => {
                    let along = self.along(&mut tree, at.clone(), (instance, frame), forward)?;
                    let there = along.last().map_or(at, |taken| taken.between[1].clone());
                    taken.extend(along);
                    there
                }
            };
            frames.insert(to, there);
            let onward = near.get(&to).into_iter().flatten().rev();
            stack.extend(onward.filter(|next| **next != index).map(|edge| (to, *edge)));
        }
        let spec = self.spec;
        for instance in instances {
            let unit = &spec.units[spec.instances[*instance].unit];
            for (index, frame) in unit.frames.iter().enumerate() {
                if !frames.contains_key(&Some((*instance, index))) {
                    return Err(Box::new(self.adrift(*instance, frame)));
                }
            }
            for spec in &unit.bodies {
                let frame = find(unit, &spec.frame)?.map(|index| (*instance, index));
                let body = self.body(spec, Scope::Instance(*instance))?;
                tree.attach(&frames[&frame], &body);
                let name = spec.name.value.clone();
                bodies.push(Attached { instance: *instance, name, frame, body });
            }
        }
        Ok(Spatial::new(tree, frames, taken, bodies))
    }

    /// Returns the mistake of a frame that nothing connects to the world.
    fn adrift(&self, instance: usize, frame: &FrameSpec) -> Mistake {
        let name = &self.spec.instances[instance].name;
        let path = quoted(&format!("{}.{}", name.value, frame.name.value));
        let message = format!("nothing connects frame {path} with the world");
        let help = "join it to a part that leads to the world, such as `spatial/world`, by joints; \
                    a body that moves freely by `spatial/free`";
        Mistake::new(Code::UnconnectedFrame, name.span, message, "adrift").help(help)
    }

    /// Returns the steps along an edge, with the frames between them.
    fn along(
        &mut self,
        tree: &mut Mechanism,
        mut at: Frame,
        (instance, index): (usize, usize),
        forward: bool,
    ) -> Result<Vec<Taken>, Box<Mistake>> {
        let spec = self.spec;
        let frame = &spec.units[spec.instances[instance].unit].frames[index];
        let prefix = spec.instances[instance].name.value.replace('.', "_");
        let name = format!("{prefix}_{}", frame.name.value);
        let mut steps = self.steps(frame, Scope::Instance(instance))?;
        if !forward {
            steps.reverse();
        }
        let mut along = Vec::new();
        for step in steps {
            let before = at.clone();
            let walk = if forward { taken } else { undone };
            at = walk(tree, at, &step, &name);
            along.push(Taken { frame: (instance, index), step, between: [before, at.clone()] });
        }
        Ok(along)
    }
}

/// Returns all connections of frames of instances.
pub(super) fn edges(
    spec: &SceneSpec,
    layout: &Layout,
    instances: &[usize],
) -> Result<Vec<Edge>, Box<Mistake>> {
    let mut edges = Vec::new();
    for &instance in instances {
        let unit = &spec.units[spec.instances[instance].unit];
        refuse_loops(unit)?;
        for (index, frame) in unit.frames.iter().enumerate().filter(|(_, f)| !f.is_joined) {
            let parent = parent_of(unit, frame)?.map(|parent| (instance, parent));
            let (ends, span) = ([parent, Some((instance, index))], frame.name.span);
            edges.push(Edge { id: EdgeId::Frame(instance, index), ends, span });
        }
    }
    for (index, ([one, other], span)) in layout.joined_frames.iter().enumerate() {
        if instances.contains(&one.0) {
            let ends = [Some(*one), Some(*other)];
            edges.push(Edge { id: EdgeId::Joint(index), ends, span: *span });
        }
    }
    Ok(edges)
}

/// Returns a frame after steps that do not move, or before them.
pub(super) fn fixed(mut at: Frame, steps: &[Step], forward: bool) -> Frame {
    for index in 0..steps.len() {
        let step = &steps[if forward { index } else { steps.len() - 1 - index }];
        match (step, forward) {
            (Step::Move(way), true) => at.offset = plus(&at.offset, &times(&at.to_joint, way)),
            (Step::Move(way), false) => {
                at.offset = plus(&at.offset, &times(&at.to_joint, &minus(way)));
            }
            (Step::Turn(matrix), true) => at.to_joint = multiplied(&at.to_joint, matrix),
            (Step::Turn(matrix), false) => {
                at.to_joint = multiplied(&at.to_joint, &transposed(matrix));
            }
            (Step::Slide(..) | Step::Revolve(..) | Step::Orient(_), _) => {}
        }
    }
    at
}

/// Returns a frame after a step.
fn taken(tree: &mut Mechanism, at: Frame, step: &Step, name: &str) -> Frame {
    match step {
        Step::Move(_) | Step::Turn(_) => fixed(at, std::slice::from_ref(step), true),
        Step::Slide(axis, by) => tree.add(name, Kind::Slides, &at, axis, by),
        Step::Revolve(axis, by) => tree.add(name, Kind::Turns, &at, axis, by),
        Step::Orient(by) => tree.add_spherical(name, &at, by, true),
    }
}

/// Returns a frame before a step.
fn undone(tree: &mut Mechanism, at: Frame, step: &Step, name: &str) -> Frame {
    let step = match step {
        Step::Move(_) | Step::Turn(_) => return fixed(at, std::slice::from_ref(step), false),
        Step::Slide(axis, by) => Step::Slide(axis.clone(), negative(by)),
        Step::Revolve(axis, by) => Step::Revolve(axis.clone(), negative(by)),
        Step::Orient(by) => return tree.add_spherical(name, &at, by, false),
    };
    taken(tree, at, &step, name)
}

/// Joins the trees of two nodes; returns whether they were apart.
pub(super) fn join(roots: &mut HashMap<Node, Node>, ends: [Node; 2]) -> bool {
    let [one, other] = ends.map(|end| root(roots, end));
    if one != other {
        roots.insert(one, other);
    }
    one != other
}

fn root(roots: &HashMap<Node, Node>, mut node: Node) -> Node {
    while let Some(next) = roots.get(&node) {
        node = *next;
    }
    node
}

/// Returns the step of a rotation about an axis by an angle that may move.
pub(super) fn turn(axis: [Expr; 3], angle: Expr, moves: bool) -> Step {
    if moves { Step::Revolve(axis, angle) } else { Step::Turn(Box::new(rotation(&axis, &angle))) }
}

/// Returns the index of the frame of a name; `None` for the world.
pub(super) fn find(unit: &UnitSpec, name: &Spanned<String>) -> Result<Option<usize>, Box<Mistake>> {
    if name.value == WORLD {
        return Ok(None);
    }
    let found = unit.frames.iter().position(|frame| frame.name.value == name.value);
    found.map(Some).ok_or_else(|| {
        let message = format!("there is no frame {}", quoted(&name.value));
        let names = unit.frames.iter().map(|frame| frame.name.value.as_str()).chain([WORLD]);
        Box::new(
            Mistake::new(Code::UnknownName, name.span, message, "unknown")
                .help(did_you_mean(&name.value, names)),
        )
    })
}

fn parent_of(unit: &UnitSpec, frame: &FrameSpec) -> Result<Option<usize>, Box<Mistake>> {
    frame.parent.as_ref().map_or(Ok(None), |parent| find(unit, parent))
}

/// Refuses frames of a unit that are their own parents.
fn refuse_loops(unit: &UnitSpec) -> Result<(), Box<Mistake>> {
    let count = unit.frames.len();
    let mut is_checked = vec![false; count];
    for start in 0..count {
        let (mut path, mut next) = (Vec::new(), Some(start));
        while let Some(index) = next.filter(|index| !is_checked[*index]) {
            if path.contains(&index) {
                let frame = &unit.frames[index];
                let name = quoted(&frame.name.value);
                let message = format!("frame {name} is its own parent, through other frames");
                let help = "frames form a tree; close a loop by constraints between positions of \
                            two frames";
                let mistake =
                    Mistake::new(Code::CyclicDefinition, frame.name.span, message, "in a loop");
                return Err(Box::new(mistake.help(help)));
            }
            path.push(index);
            next = parent_of(unit, &unit.frames[index])?;
        }
        for index in path {
            is_checked[index] = true;
        }
    }
    Ok(())
}

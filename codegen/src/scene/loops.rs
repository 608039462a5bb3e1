//! Loops of frames: the connections that are cut to leave a tree.
//!
//! A loop is cut at the joint with the most freedoms whose coordinates nothing else mentions; of
//! several, at the one furthest from the world. Its coordinates are left out, and constraints close
//! the loop again. If every joint of a loop is mentioned, the loop is cut where two ports are joined
//! rigidly, by six constraints.

use std::collections::{BTreeSet, HashMap, VecDeque};

use machinist_algebra::expr::{Expr, ParameterId, Symbol};

use crate::scene::bodies::Step;
use crate::scene::evaluate;
use crate::scene::frames::{Edge, EdgeId, Node, edges, join};
use crate::scene::layout::{Layout, Scope, coordinate_spec};
use crate::scene::resolve::Resolver;
use crate::spatial::orientation::Orientation;
use crate::spatial::vector::{Vector, cross};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::{SceneSpec, quoted};

/// Sine of the angle below which two axes count as parallel.
const PARALLEL: f64 = 1e-6;

/// A connection that is cut, and closed by constraints.
#[derive(Debug, Clone)]
pub struct Cut {
    /// The connection.
    pub edge: EdgeId,
    /// Its frames.
    pub ends: [Node; 2],
    /// Source span.
    pub span: Span,
    /// Steps from the first frame to the joint, and from the joint to the second frame.
    pub steps: [Vec<Step>; 2],
    /// Motions that it leaves.
    pub joint: Closing,
    /// Slots of the coordinates that are left out.
    pub slots: Vec<usize>,
    /// Number of the orientation that is left out.
    pub orientation: Option<usize>,
    /// Instances of the other joints of the loop, from one end to the other.
    pub around: Vec<usize>,
}

/// Relative motion that the constraints of a cut connection leave.
#[derive(Debug, Clone, PartialEq)]
pub enum Closing {
    /// None: the ends are fixed to each other.
    Rigid,
    /// Rotation about an axis.
    Revolute(Vector),
    /// Translation along an axis.
    Prismatic(Vector),
    /// Both, about and along the same axis.
    Cylindrical(Vector),
    /// Rotation about an axis of the first end, then about an axis of the second.
    Universal([Vector; 2]),
    /// Translation normal to an axis, and rotation about it.
    Planar(Vector),
    /// Any rotation.
    Spherical,
    /// Any motion.
    Free,
}

impl Closing {
    /// Returns the number of freedoms.
    fn freedoms(&self) -> usize {
        6 - self.rows().len()
    }
}

/// A joint that can be cut.
struct Candidate {
    joint: Closing,
    steps: [Vec<Step>; 2],
    slots: Vec<usize>,
    /// Id of the part w of an orientation.
    scalar: Option<usize>,
}

/// A joint's motion along or about an axis, or in any way.
enum Freedom {
    Slides(Vector),
    Turns(Vector),
    Orients,
}

/// Returns the cuts that leave a tree. `is_kept` names the slots of coordinates that something else
/// mentions.
///
/// # Errors
/// If a loop has no joint at all.
pub fn cuts(
    resolver: &mut Resolver<'_>,
    parameter: &impl Fn(ParameterId) -> f64,
    is_kept: &impl Fn(usize) -> bool,
) -> Result<Vec<Cut>, Box<Mistake>> {
    let all: Vec<usize> = (0..resolver.spec.instances.len()).collect();
    let edges = edges(resolver.spec, resolver.layout, &all)?;
    if !has_loop(&edges) {
        return Ok(Vec::new());
    }
    let mut kinds = Vec::new();
    for edge in &edges {
        kinds.push(match edge.id {
            EdgeId::Joint(_) => (false, None),
            EdgeId::Frame(instance, frame) => {
                let spec = &resolver.spec.units[resolver.spec.instances[instance].unit];
                let steps = resolver.steps(&spec.frames[frame], Scope::Instance(instance))?;
                let moves = steps.iter().any(|step| !step.is_fixed());
                let found = candidate(steps, parameter).filter(|found| {
                    found.slots.iter().all(|slot| {
                        resolver.layout.coordinate(*slot).0 == instance && !is_kept(*slot)
                    })
                });
                (moves, found)
            }
        });
    }
    if let Err(mistake) = refuse_rigid(&edges, &kinds) {
        // Two worlds in one machine are such a loop; their gravity says more.
        for instance in all {
            let connected = resolver.connected(instance);
            resolver.gravity(&connected)?;
        }
        return Err(mistake);
    }
    let far = distances(&edges, &kinds);
    let mut order: Vec<usize> = (0..edges.len()).collect();
    order.sort_by_key(|index| {
        let rank = match (&edges[*index].id, &kinds[*index].1) {
            (EdgeId::Frame(..), None) => 0,
            (EdgeId::Joint(_), _) => 1,
            (_, Some(found)) => 2 + found.joint.freedoms(),
        };
        let near = edges[*index].ends.iter().filter_map(|end| far.get(end)).min();
        (rank, near.copied().unwrap_or(usize::MAX), *index)
    });
    let mut roots: HashMap<Node, Node> = HashMap::new();
    let (mut tree, mut loose) = (Vec::new(), Vec::new());
    for index in order {
        if join(&mut roots, edges[index].ends) { &mut tree } else { &mut loose }.push(index);
    }
    loose.sort_unstable();
    let slots_in_all = resolver.layout.links.len();
    let mut cut = |index: usize| {
        let Edge { id, ends, span } = edges[index].clone();
        let around = around(&edges, &kinds, &tree, ends);
        let found = kinds[index].1.take();
        let Candidate { joint, steps, slots, scalar } = found.unwrap_or(Candidate {
            joint: Closing::Rigid,
            steps: Default::default(),
            slots: Vec::new(),
            scalar: None,
        });
        // Ids of the parts w follow those of coordinates.
        let orientation = scalar.map(|id| id - slots_in_all);
        Cut { edge: id, ends, span, steps, joint, slots, orientation, around }
    };
    Ok(loose.into_iter().map(&mut cut).collect())
}

fn has_loop(edges: &[Edge]) -> bool {
    let mut roots: HashMap<Node, Node> = HashMap::new();
    !edges.iter().all(|edge| join(&mut roots, edge.ends))
}

/// Refuses loops without joints, whose parts either fit or do not.
fn refuse_rigid(edges: &[Edge], kinds: &[(bool, Option<Candidate>)]) -> Result<(), Box<Mistake>> {
    let mut roots: HashMap<Node, Node> = HashMap::new();
    for (edge, _) in edges.iter().zip(kinds).filter(|(_, (moves, _))| !moves) {
        if !join(&mut roots, edge.ends) {
            let message = "this closes a loop of frames without a joint";
            let mistake = Mistake::new(Code::JointLoop, edge.span, message, "a rigid loop");
            return Err(Box::new(mistake.help("leave it out, or put a joint into the loop")));
        }
    }
    Ok(())
}

/// Returns the number of joints between the world and each frame.
fn distances(edges: &[Edge], kinds: &[(bool, Option<Candidate>)]) -> HashMap<Node, usize> {
    let near = neighbours(edges, 0..edges.len());
    let mut far: HashMap<Node, usize> = HashMap::from([(None, 0)]);
    let mut queue: VecDeque<Node> = VecDeque::from([None]);
    while let Some(from) = queue.pop_front() {
        let here = far[&from];
        for (to, index) in near.get(&from).into_iter().flatten() {
            let there = here + usize::from(kinds[*index].0);
            if far.get(to).is_none_or(|known| there < *known) {
                far.insert(*to, there);
                if there == here { queue.push_front(*to) } else { queue.push_back(*to) }
            }
        }
    }
    far
}

fn neighbours(
    edges: &[Edge],
    which: impl IntoIterator<Item = usize>,
) -> HashMap<Node, Vec<(Node, usize)>> {
    let mut near: HashMap<Node, Vec<(Node, usize)>> = HashMap::new();
    for index in which {
        let [one, other] = edges[index].ends;
        near.entry(one).or_default().push((other, index));
        near.entry(other).or_default().push((one, index));
    }
    near
}

/// Returns the instances of the joints on the way of a tree between two frames.
fn around(
    edges: &[Edge],
    kinds: &[(bool, Option<Candidate>)],
    tree: &[usize],
    [from, to]: [Node; 2],
) -> Vec<usize> {
    let near = neighbours(edges, tree.iter().copied());
    let mut before: HashMap<Node, Option<(Node, usize)>> = HashMap::from([(to, None)]);
    let mut queue: VecDeque<Node> = VecDeque::from([to]);
    while let Some(here) = queue.pop_front() {
        for (next, index) in near.get(&here).into_iter().flatten() {
            if !before.contains_key(next) {
                before.insert(*next, Some((here, *index)));
                queue.push_back(*next);
            }
        }
    }
    let (mut around, mut here) = (Vec::new(), from);
    while let Some(Some((next, index))) = before.get(&here) {
        if let (true, EdgeId::Frame(instance, _)) = (kinds[*index].0, &edges[*index].id) {
            around.push(*instance);
        }
        here = *next;
    }
    around.dedup();
    around
}

/// Returns the joint of a frame that constraints can replace.
fn candidate(steps: Vec<Step>, parameter: &impl Fn(ParameterId) -> f64) -> Option<Candidate> {
    let last = steps.iter().rposition(|step| !step.is_fixed())?;
    let (mut before, mut after) = (Vec::new(), Vec::new());
    let (mut freedoms, mut slots, mut w) = (Vec::new(), Vec::new(), None);
    for (index, step) in steps.into_iter().enumerate() {
        match step {
            step if step.is_fixed() && index > last => after.push(step),
            Step::Turn(_) if !freedoms.is_empty() => return None,
            Step::Turn(_) => before.push(step),
            // A way along fixed axes commutes with other ways.
            Step::Move(_) => {
                if !freedoms.iter().all(|freedom| matches!(freedom, Freedom::Slides(_))) {
                    return None;
                }
                before.push(step);
            }
            Step::Slide(axis, by) => {
                slots.push(slot(&by)?);
                freedoms.push(Freedom::Slides(axis));
            }
            Step::Revolve(axis, by) => {
                slots.push(slot(&by)?);
                freedoms.push(Freedom::Turns(axis));
            }
            Step::Orient(Orientation { vector, scalar }) => {
                w = Some(scalar.0 as usize);
                slots.extend(vector.map(|id| id.0 as usize));
                freedoms.push(Freedom::Orients);
            }
        }
    }
    if slots.iter().collect::<BTreeSet<_>>().len() < slots.len() {
        return None;
    }
    let joint = closing(freedoms, parameter)?;
    Some(Candidate { joint, steps: [before, after], slots, scalar: w })
}

/// Returns the slot of a coordinate; `None` for any other expression. Before coordinates are
/// identified, their ids are slots.
fn slot(by: &Expr) -> Option<usize> {
    match by {
        Expr::Symbol(Symbol::Coordinate(id)) => Some(id.0 as usize),
        _ => None,
    }
}

fn closing(freedoms: Vec<Freedom>, parameter: &impl Fn(ParameterId) -> f64) -> Option<Closing> {
    use Freedom::{Orients, Slides, Turns};
    let value = |vector: &Vector| vector.each_ref().map(|entry| evaluate(entry, parameter));
    let across = |a: &Vector, b: &Vector| {
        let size = value(&cross(a, b)).iter().map(|entry| entry * entry).sum::<f64>().sqrt();
        size > PARALLEL
    };
    let normal = |a: &Vector, b: &Vector| {
        let dot: f64 = value(a).iter().zip(value(b)).map(|(a, b)| a * b).sum();
        dot.abs() < PARALLEL
    };
    let mut all = freedoms.into_iter();
    let given = [(); 5].map(|()| all.next());
    match given {
        [Some(Orients), None, ..] => Some(Closing::Spherical),
        [Some(Turns(axis)), None, ..] => Some(Closing::Revolute(axis)),
        [Some(Slides(axis)), None, ..] => Some(Closing::Prismatic(axis)),
        [Some(Turns(one)), Some(Slides(other)), None, ..]
        | [Some(Slides(one)), Some(Turns(other)), None, ..]
            if one == other =>
        {
            Some(Closing::Cylindrical(one))
        }
        [Some(Turns(one)), Some(Turns(other)), None, ..] if across(&one, &other) => {
            Some(Closing::Universal([one, other]))
        }
        [Some(Slides(a)), Some(Slides(b)), Some(Turns(axis)), None, ..]
            if across(&a, &b) && normal(&a, &axis) && normal(&b, &axis) =>
        {
            Some(Closing::Planar(axis))
        }
        [Some(Slides(a)), Some(Slides(b)), Some(Slides(c)), Some(Orients), None]
            if across(&a, &b) && across(&b, &c) && normal(&a, &c) && normal(&b, &c) =>
        {
            Some(Closing::Free)
        }
        _ => None,
    }
}

/// Returns a vector across a unit axis, at least 0.8 long at the values of the spec. Its product
/// with the axis is another.
pub fn across(axis: &Vector, parameter: &impl Fn(ParameterId) -> f64) -> Vector {
    let value = axis.each_ref().map(|entry| evaluate(entry, parameter).abs());
    let least = (0..3).min_by(|a, b| value[*a].total_cmp(&value[*b])).unwrap_or_default();
    let unit: Vector = std::array::from_fn(|i| Expr::integer(i64::from(i == least)));
    cross(axis, &unit)
}

impl Cut {
    /// Returns the instance of its constraints, and the prefix of their names.
    pub fn name<'a>(&self, spec: &'a SceneSpec) -> (usize, &'a str) {
        let (instance, frame) = match (self.edge, self.ends) {
            (EdgeId::Frame(instance, frame), _) => (instance, frame),
            (EdgeId::Joint(_), [_, Some(end)] | [Some(end), None]) => end,
            (EdgeId::Joint(_), [None, None]) => (0, 0),
        };
        let unit = &spec.units[spec.instances[instance].unit];
        (instance, &unit.frames[frame].name.value)
    }

    /// Returns a sentence on the loop, on the cut and on what it leaves out.
    pub fn note(&self, spec: &SceneSpec, layout: &Layout) -> String {
        let (instance, frame) = self.name(spec);
        let own = &spec.instances[instance].name.value;
        let others = self.around.iter().map(|at| quoted(&spec.instances[*at].name.value));
        let others = listed(&others.collect::<Vec<_>>());
        let closed = format!("closed by {} constraints", self.joint.rows().len());
        if self.slots.is_empty() {
            let place = quoted(&format!("{own}.{frame}"));
            return format!("the loop of {others} is cut at {place} and {closed}");
        }
        let names = self.slots.iter().map(|slot| {
            let name = &coordinate_spec(spec, layout, *slot).name.value;
            quoted(&format!("{own}.{name}"))
        });
        let names = names.collect::<Vec<_>>();
        let are = if names.len() == 1 { "is" } else { "are" };
        format!(
            "the loop of {others} is cut at joint {} and {closed}; {} {are} left out, because the \
             scene does not mention {}",
            quoted(own),
            listed(&names),
            if names.len() == 1 { "it" } else { "them" },
        )
    }
}

/// Joins words: a, b and c.
fn listed(words: &[String]) -> String {
    match words {
        [all @ .., last] if !all.is_empty() => format!("{} and {last}", all.join(", ")),
        _ => words.concat(),
    }
}

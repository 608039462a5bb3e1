//! Elements of a field: segments between its ports, and owners of nodes.

use std::cmp::Ordering;
use std::ops::Range;

use machinist_contract::Real;
use machinist_contract::field::{
    Elements, FieldDescription, FieldPlace, FieldScene, MAX_ORDER, Segment,
};

use super::{Discretisation, FieldError, Lobatto, MAX_ELEMENTS};

/// Owner of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// No owner: the node is held at zero.
    Fixed,
    /// The machine.
    Port {
        /// Index of the coordinate of the machine.
        coordinate: u32,
        /// Index of the first parameter that the field provides.
        handed: u32,
    },
    /// The field; the number counts own nodes of all fields.
    Field(u32),
}

/// A field divided into elements.
#[derive(Debug, Clone)]
pub(super) struct Mesh {
    pub rule: Lobatto,
    pub order: usize,
    pub segments: Vec<Segment>,
    /// Owners of all nodes, in the order of x.
    pub owners: Vec<Owner>,
    /// Index of each attachment, its bound and its node.
    pub attached: Vec<[usize; 3]>,
    /// First node and first segment among those of all fields.
    pub first_node: usize,
    pub first_segment: usize,
    pub own_nodes: usize,
    /// Runs of own nodes.
    pub runs: Vec<Run>,
    /// Indices of nodes that are ports.
    pub ports: Vec<usize>,
}

/// Neighbouring own nodes of a field, which are also neighbours in the state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Run {
    /// Indices of nodes of the field.
    pub nodes: Range<usize>,
    /// Index of the first one among own nodes of all fields.
    pub own: usize,
}

impl Mesh {
    /// Returns the elements in the form of the contract.
    pub fn elements<'a, R: Real>(&'a self, field: usize, bounds: &'a [R]) -> Elements<'a, R> {
        Elements { field, rule: self.rule.rule(), segments: &self.segments, bounds }
    }

    /// Returns the indices of its bounds among those of all fields; the field is the `index`-th
    /// one.
    pub fn bounds(&self, index: usize) -> Range<usize> {
        // Every previous field has one more bound than segments.
        let first = self.first_segment + index;
        first..first + self.segments.len() + 1
    }

    /// Returns the indices of its nodes among those of all fields.
    pub fn nodes(&self) -> Range<usize> {
        self.first_node..self.first_node + self.owners.len()
    }

    /// Returns the inverse of the element length in a segment between these bounds.
    pub fn inverse_of_length<R: Real>(&self, segment: usize, bounds: &[R]) -> R {
        let elements = f64::from(self.segments[segment].elements);
        R::literal(elements) / (bounds[segment + 1] - bounds[segment])
    }

    /// Returns the segment of the element that begins at a node.
    pub fn segment_of(&self, node: usize) -> usize {
        self.segments.partition_point(|segment| segment.first_node as usize <= node) - 1
    }

    /// Returns the nodes of each element.
    pub fn elements_of_nodes(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let elements = (self.owners.len() - 1) / self.order;
        (0..elements).map(|element| {
            let first = element * self.order;
            first..first + self.order + 1
        })
    }
}

/// Divides all fields of a scene.
pub(super) fn meshes<R: Real>(
    scene: &dyn FieldScene<R>,
    wanted: Discretisation,
) -> Result<Vec<Mesh>, FieldError> {
    let (mut nodes, mut own, mut segments) = (0, 0, 0);
    let mut meshes = Vec::new();
    for index in 0..scene.fields() {
        let mesh = mesh(scene, index, wanted, [nodes, own, segments])?;
        nodes += mesh.owners.len();
        segments += mesh.segments.len();
        own += mesh.own_nodes;
        meshes.push(mesh);
    }
    Ok(meshes)
}

fn mesh<R: Real>(
    scene: &dyn FieldScene<R>,
    index: usize,
    wanted: Discretisation,
    [first_node, first_own, first_segment]: [usize; 3],
) -> Result<Mesh, FieldError> {
    let description = scene.field(index);
    let order = wanted.order.unwrap_or(description.order);
    if !(1..=MAX_ORDER).contains(&order) {
        return Err(FieldError::Order(order));
    }
    let inside = |place: FieldPlace| place == FieldPlace::Inside;
    let stretches = 1 + description.attachments.iter().filter(|at| inside(at.place)).count();
    let elements = wanted.elements.unwrap_or(description.elements);
    if !(stretches..=MAX_ELEMENTS).contains(&elements) {
        let field = description.value.name.to_owned();
        let (least, most) = (stretches, MAX_ELEMENTS);
        return Err(FieldError::ElementCount { field, least, most, found: elements });
    }
    let counts = share(elements, &lengths(&description));
    let mut segments = Vec::new();
    let mut node = 0;
    for (number, count) in counts.iter().enumerate() {
        let bounds = [number as u32, number as u32 + 1];
        segments.push(Segment { bounds, elements: *count as u32, first_node: node as u32 });
        node += count * order;
    }
    let nodes = node + 1;
    let mut owners: Vec<Option<Owner>> = vec![None; nodes];
    if description.fixed[0] {
        owners[0] = Some(Owner::Fixed);
    }
    if description.fixed[1] {
        owners[nodes - 1] = Some(Owner::Fixed);
    }
    let mut attached = Vec::new();
    let mut bound = 0;
    for (number, at) in description.attachments.iter().enumerate() {
        bound = match at.place {
            FieldPlace::Start => 0,
            FieldPlace::Inside => bound + 1,
            FieldPlace::End => segments.len(),
        };
        let node = segments.get(bound).map_or(nodes - 1, |segment| segment.first_node as usize);
        if let Some(coordinate) = at.coordinate {
            owners[node] = Some(Owner::Port { coordinate, handed: at.handed });
        }
        attached.push([number, bound, node]);
    }
    let mut own = first_own as u32;
    let owners: Vec<Owner> = owners
        .into_iter()
        .map(|owner| {
            owner.unwrap_or_else(|| {
                own += 1;
                Owner::Field(own - 1)
            })
        })
        .collect();
    let own_nodes = own as usize - first_own;
    let rule = Lobatto::new(order);
    let runs = runs(&owners);
    let is_port = |node: &usize| matches!(owners[*node], Owner::Port { .. });
    let ports = (0..nodes).filter(is_port).collect();
    Ok(Mesh {
        rule,
        order,
        segments,
        owners,
        attached,
        first_node,
        first_segment,
        own_nodes,
        runs,
        ports,
    })
}

fn runs(owners: &[Owner]) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for (node, owner) in owners.iter().enumerate() {
        let Owner::Field(own) = *owner else { continue };
        match runs.last_mut().filter(|run| run.nodes.end == node) {
            Some(run) => run.nodes.end = node + 1,
            None => runs.push(Run { nodes: node..node + 1, own: own as usize }),
        }
    }
    runs
}

/// Returns the lengths of the segments between ports at the spec's parameters \[m\].
fn lengths(description: &FieldDescription<'_>) -> Vec<f64> {
    let inside = description.attachments.iter().filter(|at| at.place == FieldPlace::Inside);
    let ends = inside.map(|at| at.at).chain([description.length]);
    let mut start = 0.0;
    let lengths = ends.map(|end| {
        let length = end - start;
        start = end;
        length
    });
    lengths.collect()
}

/// Distributes elements over segments: at least one each, the others in proportion to length.
fn share(elements: usize, lengths: &[f64]) -> Vec<usize> {
    let mut counts = vec![1; lengths.len()];
    let total: f64 = lengths.iter().sum();
    if !(total > 0.0 && total.is_finite()) {
        counts[0] += elements - counts.len();
        return counts;
    }
    for (count, length) in counts.iter_mut().zip(lengths) {
        let ideal = (elements as f64 * length / total).floor() as usize;
        *count = ideal.max(1);
    }
    loop {
        let given: usize = counts.iter().sum();
        let longest = |index: &usize| lengths[*index] / counts[*index] as f64;
        let order = |a: &usize, b: &usize| longest(a).total_cmp(&longest(b));
        match given.cmp(&elements) {
            Ordering::Less => {
                let Some(index) = (0..counts.len()).rev().max_by(order) else { return counts };
                counts[index] += 1;
            }
            Ordering::Greater => {
                let many = (0..counts.len()).filter(|index| counts[*index] > 1);
                let Some(index) = many.min_by(order) else { return counts };
                counts[index] -= 1;
            }
            Ordering::Equal => return counts,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::share;

    #[test]
    fn stretches_get_elements_by_their_lengths_and_one_at_least() {
        assert_eq!(share(10, &[1.0, 1.0]), [5, 5]);
        assert_eq!(share(7, &[1.0, 0.75]), [4, 3]);
        assert_eq!(share(4, &[1.0, 1e-6, 1.0]), [2, 1, 1]);
        assert_eq!(share(100, &[1e-9, 1.0]), [1, 99]);
    }
}

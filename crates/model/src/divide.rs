//! Models whose fields are divided into elements: every node is a coordinate, so that they run, and
//! are emitted, like models without fields.
//!
//! ```text
//! y = [q, u, q', u', z]     M_i u_i'' = F_i
//! ```
//!
//! The equations are those of [`machinist_contract::field`], with the sums over elements and points
//! written out on tapes.

mod builder;
mod derivatives;
mod integrals;

use machinist_contract::field::{HANDED, Rule};

use crate::{
    Coordinate, FieldModel, Function, MatrixTape, Model, NodeId, Op, Place, Quantity, State,
    StateKind, Tape,
};

use builder::Builder;

/// Division of a field into elements: the rule of each element, and x at all nodes for the
/// parameters of the spec \[m\].
pub type Division<'a> = machinist_contract::field::Division<'a, Vec<f64>>;

impl Model {
    /// Returns the machine with its fields divided into elements, one division for each field.
    /// Functions that steps of a run need are on its tapes; Jacobians, energies and powers are not.
    ///
    /// `None` if the machine lacks coordinates beside its fields.
    #[must_use]
    pub fn divided(&self, divisions: &[Division<'_>]) -> Option<Self> {
        Some(Whole::of(self, divisions)?.model())
    }

    /// Returns the machine as [`Model::divided`] does, with all functions: Jacobians by automatic
    /// differentiation of the tapes, and energies and powers by the sums of
    /// [`Elements::energy_and_power`](machinist_contract::field::Elements::energy_and_power).
    #[must_use]
    pub fn divided_completely(&self, divisions: &[Division<'_>]) -> Option<Self> {
        let whole = Whole::of(self, divisions)?;
        let mut model = whole.model();
        model.forcing = whole.forcing();
        model.energy = whole.energy();
        model.power_balance = whole.power_balance();
        model.derive_rates();
        Some(model)
    }
}

/// Owner of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Owner {
    Fixed,
    /// Coordinate of the machine.
    Port(usize),
    /// Coordinate of the node.
    Field(usize),
}

/// Elements between two neighbouring bounds of a field.
struct Segment {
    elements: usize,
    first_node: usize,
}

/// Division of a field.
struct Mesh<'a> {
    rule: Rule<'a>,
    order: usize,
    segments: Vec<Segment>,
    owners: Vec<Owner>,
    /// Bound and node of each attachment.
    attached: Vec<[usize; 2]>,
}

impl<'a> Mesh<'a> {
    /// Returns the division with nodes at these places, with coordinates from `own` on.
    fn new(field: &FieldModel, (rule, places): (Rule<'a>, &[f64]), mut own: usize) -> Self {
        let order = rule.len() - 1;
        let last = places.len() - 1;
        let nearest = |x: f64| {
            let off = |node: &usize| (places[*node] - x).abs();
            (0..=last).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
        };
        let mut bounds = vec![0];
        let mut attached = Vec::new();
        for at in &field.attachments {
            let node = match at.place {
                Place::Start => 0,
                Place::Inside => nearest(at.x),
                Place::End => last,
            };
            if at.place == Place::Inside {
                bounds.push(node);
            }
            attached.push(node);
        }
        bounds.push(last);
        let segments = bounds
            .windows(2)
            .map(|ends| Segment { elements: (ends[1] - ends[0]) / order, first_node: ends[0] });
        let bound = |node: &usize| bounds.iter().position(|bound| bound == node).unwrap_or(0);
        let mut owners: Vec<Option<Owner>> = vec![None; places.len()];
        for (node, _) in [0, last].into_iter().zip(field.fixed).filter(|(_, is_fixed)| *is_fixed) {
            owners[node] = Some(Owner::Fixed);
        }
        for (at, node) in field.attachments.iter().zip(&attached) {
            if let Some(coordinate) = at.coordinate {
                owners[*node] = Some(Owner::Port(coordinate as usize));
            }
        }
        let owners = owners.into_iter().map(|owner| {
            owner.unwrap_or_else(|| {
                own += 1;
                Owner::Field(own - 1)
            })
        });
        Self {
            rule,
            order,
            segments: segments.collect(),
            owners: owners.collect(),
            attached: attached.iter().map(|node| [bound(node), *node]).collect(),
        }
    }
}

/// An element on a tape.
#[derive(Clone, Copy)]
struct Element {
    first_node: usize,
    start: NodeId,
    length: NodeId,
}

/// Values at the nodes of a field on a tape.
struct Loaded {
    inertia: Vec<NodeId>,
    force: Vec<NodeId>,
    elements: Vec<Vec<Element>>,
}

/// A model with its division.
struct Whole<'a> {
    model: &'a Model,
    meshes: Vec<Mesh<'a>>,
    /// Numbers of coordinates of the machine, and of all.
    machine: usize,
    all: usize,
}

impl<'a> Whole<'a> {
    /// Returns `None` for a model that lacks coordinates.
    fn of(model: &'a Model, divisions: &[Division<'a>]) -> Option<Self> {
        if !model.is_whole() || divisions.len() != model.fields.len() {
            return None;
        }
        let mut own = model.coordinates.len();
        let mut meshes = Vec::new();
        for (field, Division { rule, places }) in model.fields.iter().zip(divisions) {
            let mesh = Mesh::new(field, (*rule, places), own);
            own += mesh.owners.iter().filter(|owner| matches!(owner, Owner::Field(_))).count();
            meshes.push(mesh);
        }
        Some(Self { model, meshes, machine: model.coordinates.len(), all: own })
    }

    fn entry(&self, index: u32) -> u32 {
        let (n, all) = (self.machine as u32, self.all as u32);
        match index {
            _ if index < n => index,
            _ if index < 2 * n => index - n + all,
            _ => index - 2 * n + 2 * all,
        }
    }

    fn model(&self) -> Model {
        let model = self.model;
        let mut whole = model.clone();
        (whole.coordinates, whole.states) = (self.coordinates(), self.states());
        for event in &mut whole.events {
            event.when.iter_mut().for_each(|(entry, _)| *entry = self.entry(*entry));
            event.sets.iter_mut().for_each(|entry| *entry = self.entry(*entry));
        }
        whole.fields.clear();
        whole.handed.clear();
        (whole.motion, whole.excitation) = (None, None);
        whole.quadratures = 0;
        let (states, parameters) = (MatrixTape::default(), MatrixTape::default());
        (whole.rate_jacobian, whole.parameter_jacobian) = (states, parameters);
        for tape in [&mut whole.energy, &mut whole.power_balance, &mut whole.forcing] {
            *tape = Tape::default();
        }
        whole.time_derivative = Tape::default();
        whole.initial_state = self.states_of(&model.initial_state, true);
        whole.rate = self.states_of(&model.rate, false);
        whole.outputs = self.of_machine(&model.outputs, true);
        let tapes = [
            (&mut whole.discontinuities, &model.discontinuities),
            (&mut whole.guards, &model.guards),
            (&mut whole.guard_rates, &model.guard_rates),
            (&mut whole.resets, &model.resets),
            (&mut whole.kink_guards, &model.kink_guards),
            (&mut whole.kink_rates, &model.kink_rates),
            (&mut whole.saturating_arguments, &model.saturating_arguments),
            (&mut whole.constraint_values, &model.constraint_values),
            (&mut whole.constraint_rates, &model.constraint_rates),
            (&mut whole.constraint_matrix.tape, &model.constraint_matrix.tape),
        ];
        for (into, tape) in tapes {
            *into = self.of_machine(tape, false);
        }
        whole.constraint_matrix.pattern.columns = self.all;
        whole.mass_matrix = self.mass_matrix();
        if let Some(drawing) = &mut whole.drawing {
            drawing.places = self.of_machine(&drawing.places, false);
        }
        whole
    }

    /// Iterates over the nodes that are coordinates: field, node and coordinate.
    fn own(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        self.meshes.iter().enumerate().flat_map(|(index, mesh)| {
            mesh.owners.iter().enumerate().filter_map(move |(node, owner)| match owner {
                Owner::Field(coordinate) => Some((index, node, *coordinate)),
                _ => None,
            })
        })
    }

    fn quantity(&self, field: usize, node: usize, order: usize) -> Quantity {
        let mut quantity = self.model.fields[field].quantities[2 * order].clone();
        quantity.name.path = format!("{}[{node}]", quantity.name.path);
        quantity.name.ident = format!("{}_{node}", quantity.name.ident);
        quantity
    }

    fn coordinates(&self) -> Vec<Coordinate> {
        let own = self.own().map(|(field, node, _)| {
            let [position, velocity] = [0, 1].map(|order| self.quantity(field, node, order));
            Coordinate { position, velocity }
        });
        self.model.coordinates.iter().cloned().chain(own).collect()
    }

    fn states(&self) -> Vec<State> {
        let (states, n) = (&self.model.states, self.machine);
        let own = |order: usize| {
            self.own().map(move |(field, node, coordinate)| State {
                quantity: self.quantity(field, node, order),
                kind: if order == 0 {
                    StateKind::Position(coordinate as u32)
                } else {
                    StateKind::Velocity(coordinate as u32)
                },
                scale: self.model.fields[field].scale[order],
                is_given: true,
            })
        };
        let mut all = states[..n].to_vec();
        all.extend(own(0));
        all.extend_from_slice(&states[n..2 * n]);
        all.extend(own(1));
        all.extend_from_slice(&states[2 * n..]);
        all
    }

    /// Returns a tape of the machine, for all states.
    fn of_machine(&self, tape: &Tape, with_slopes: bool) -> Tape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, with_slopes);
        let results = self.inline(&mut builder, tape, &handed);
        builder.tape(&results)
    }

    /// Returns a tape with a result for every state, from that of the machine.
    fn states_of(&self, tape: &Tape, is_initial: bool) -> Tape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, false);
        let of_machine = self.inline(&mut builder, tape, &handed);
        let zero = builder.literal(0.0);
        let mut results = vec![zero; 2 * self.all + of_machine.len() - 2 * self.machine];
        for (index, result) in of_machine.iter().enumerate() {
            results[self.entry(index as u32) as usize] = *result;
        }
        for (field, node, coordinate) in self.own() {
            let loaded = &fields[field];
            let [position, velocity] = if is_initial {
                let x = self.place_of(&mut builder, field, loaded, node);
                let tape = &self.model.fields[field].initial;
                let values = builder.at_point(tape, [zero, zero, zero, zero, x]);
                [values[0], values[1]]
            } else {
                let velocity = builder.put(Op::State((coordinate + self.all) as u32));
                let inverse = builder.inverse(loaded.inertia[node]);
                [velocity, builder.multiply(loaded.force[node], inverse)]
            };
            (results[coordinate], results[coordinate + self.all]) = (position, velocity);
        }
        builder.tape(&results)
    }

    fn mass_matrix(&self) -> MatrixTape {
        let mut builder = Builder::default();
        let fields = self.load(&mut builder);
        let handed = self.hand_over(&mut builder, &fields, false);
        let of_machine = &self.model.mass_matrix;
        let mut results = self.inline(&mut builder, &of_machine.tape, &handed);
        let mut pattern = of_machine.pattern.clone();
        (pattern.rows, pattern.columns) = (self.all, self.all);
        for (field, node, coordinate) in self.own() {
            pattern.entries.push((coordinate as u32, coordinate as u32));
            results.push(fields[field].inertia[node]);
        }
        MatrixTape { pattern, tape: builder.tape(&results), solve: None }
    }

    /// Copies a tape of the machine, with values that fields hand over.
    fn inline(&self, builder: &mut Builder, tape: &Tape, handed: &[NodeId]) -> Vec<NodeId> {
        let slots = self.model.handed.len() as u32;
        let read = |builder: &mut Builder, op: Op, motion: &[NodeId]| match op {
            Op::State(index) => builder.put(Op::State(self.entry(index))),
            Op::Handed(index) => handed[index as usize],
            Op::Held(place) => builder.put(Op::Held(place - slots)),
            Op::Motion(index) => motion[index as usize],
            other => builder.put(other),
        };
        let motion = self.model.motion.as_ref().map(|motion| &motion.tape);
        let motion = motion.map(|tape| builder.copy(tape, |builder, op| read(builder, op, &[])));
        let motion = motion.unwrap_or_default();
        builder.copy(tape, |builder, op| read(builder, op, &motion))
    }

    /// Computes M and F at the nodes of all fields.
    fn load(&self, builder: &mut Builder) -> Vec<Loaded> {
        let zero = builder.literal(0.0);
        let all = self.meshes.iter().zip(&self.model.fields).map(|(mesh, field)| {
            let elements = elements(builder, field, mesh);
            let zeros = || vec![zero; mesh.owners.len()];
            let mut loaded = Loaded { inertia: zeros(), force: zeros(), elements };
            let rule = mesh.rule;
            for element in loaded.elements.iter().flatten() {
                for (point, weight) in rule.weights.iter().enumerate() {
                    let node = element.first_node + point;
                    let state = self.point(builder, mesh, element, point);
                    let share = builder.scale(element.length, *weight);
                    let density = builder.at_point(&field.inertia, state)[0];
                    let inertia = builder.multiply(share, density);
                    loaded.inertia[node] = builder.add(loaded.inertia[node], inertia);
                    let forces = builder.at_point(&field.force, state);
                    let force = builder.multiply(share, forces[0]);
                    loaded.force[node] = builder.add(loaded.force[node], force);
                    for to in 0..rule.len() {
                        let part = builder.scale(forces[1], weight * slope(&rule, point, to));
                        let there = &mut loaded.force[element.first_node + to];
                        *there = builder.add(*there, part);
                    }
                }
            }
            loaded
        });
        all.collect()
    }

    /// Returns u, u_x, u_t, u_xt and x at a point of an element.
    fn point(
        &self,
        builder: &mut Builder,
        mesh: &Mesh<'_>,
        element: &Element,
        point: usize,
    ) -> [NodeId; 5] {
        let rule = mesh.rule;
        let zero = builder.literal(0.0);
        let value = |builder: &mut Builder, node: usize, rate: bool| match mesh.owners[node] {
            Owner::Fixed => zero,
            Owner::Port(coordinate) | Owner::Field(coordinate) => {
                builder.put(Op::State((coordinate + if rate { self.all } else { 0 }) as u32))
            }
        };
        let here = element.first_node + point;
        let mut state = [value(builder, here, false), zero, value(builder, here, true), zero, zero];
        for (place, rate) in [(1, false), (3, true)] {
            for node in 0..rule.len() {
                let there = value(builder, element.first_node + node, rate);
                let part = builder.scale(there, slope(&rule, point, node));
                state[place] = builder.add(state[place], part);
            }
            let inverse = builder.inverse(element.length);
            state[place] = builder.multiply(state[place], inverse);
        }
        let along = builder.scale(element.length, rule.points[point]);
        state[4] = builder.add(element.start, along);
        state
    }

    fn place_of(
        &self,
        builder: &mut Builder,
        field: usize,
        loaded: &Loaded,
        node: usize,
    ) -> NodeId {
        let mesh = &self.meshes[field];
        let mut elements = loaded.elements.iter().flatten();
        let is_there = |element: &&Element| node <= element.first_node + mesh.order;
        let element = elements.find(is_there).expect("every node is in an element");
        self.point(builder, mesh, element, node - element.first_node)[4]
    }

    /// Returns the values that fields hand over: inertia and force at every port, and the slopes on
    /// both of its sides if they are wanted.
    fn hand_over(&self, builder: &mut Builder, fields: &[Loaded], slopes: bool) -> Vec<NodeId> {
        let zero = builder.literal(0.0);
        let mut handed = vec![zero; self.model.handed.len()];
        let all = || self.model.fields.iter().zip(&self.meshes).zip(fields);
        for ((field, mesh), loaded) in all() {
            for (at, [_, node]) in field.attachments.iter().zip(&mesh.attached) {
                let first = at.handed as usize;
                (handed[first], handed[first + 1]) = (loaded.inertia[*node], loaded.force[*node]);
            }
        }
        if !slopes {
            return handed;
        }
        let rate = self.inline(builder, &self.model.rate, &handed);
        for ((field, mesh), loaded) in all() {
            for (at, [bound, _]) in field.attachments.iter().zip(&mesh.attached) {
                let acceleration = at
                    .coordinate
                    .map_or(zero, |coordinate| rate[self.machine + coordinate as usize]);
                let segments = &loaded.elements;
                let before = bound.checked_sub(1).and_then(|segment| segments[segment].last());
                let after = segments.get(*bound).and_then(|segment| segment.first());
                for (element, side) in [(before, HANDED - 2), (after, HANDED - 1)] {
                    let Some(element) = element else { continue };
                    let is_last = side == HANDED - 2;
                    handed[at.handed as usize + side] = self.slope_of_section(
                        builder,
                        (field, mesh),
                        (element, is_last),
                        acceleration,
                    );
                }
            }
        }
        handed
    }

    /// Returns u_x at the first or last node of an element, from the section force there; see
    /// [`machinist_contract::field::Elements::slope_of_section`].
    fn slope_of_section(
        &self,
        builder: &mut Builder,
        (field, mesh): (&FieldModel, &Mesh<'_>),
        (element, is_last): (&Element, bool),
        acceleration: NodeId,
    ) -> NodeId {
        let rule = mesh.rule;
        let here = if is_last { rule.len() - 1 } else { 0 };
        let state = self.point(builder, mesh, element, here);
        let share = builder.scale(element.length, rule.weights[here]);
        let density = builder.at_point(&field.inertia, state)[0];
        let forces = builder.at_point(&field.force, state);
        let mut force = builder.multiply(share, forces[0]);
        for point in 0..rule.len() {
            let there = self.point(builder, mesh, element, point);
            let on_slope = builder.at_point(&field.force, there)[1];
            let part = builder.scale(on_slope, rule.weights[point] * slope(&rule, point, here));
            force = builder.add(force, part);
        }
        let inertia = builder.multiply(share, density);
        let inertial = builder.multiply(inertia, acceleration);
        let inertial = builder.scale(inertial, -1.0);
        let rest = builder.add(force, inertial);
        let in_section = if is_last { rest } else { builder.scale(rest, -1.0) };
        let own = builder.scale(forces[1], -1.0);
        let missing = builder.add(in_section, own);
        let by_slope = builder.at_point(&field.force_jacobian, state)[5];
        let change = builder.divide(missing, by_slope);
        let zero = builder.literal(0.0);
        let size = builder.put(Op::Call(Function::Abs, by_slope));
        let change =
            builder.put(Op::SelectLess { lhs: zero, rhs: size, then: change, otherwise: zero });
        builder.add(state[1], change)
    }
}

fn slope(rule: &Rule<'_>, point: usize, node: usize) -> f64 {
    rule.slopes[point * rule.len() + node]
}

/// Returns the elements of each segment.
fn elements(builder: &mut Builder, field: &FieldModel, mesh: &Mesh<'_>) -> Vec<Vec<Element>> {
    let zero = builder.literal(0.0);
    let places = builder.at_point(&field.places, [zero; 5]);
    let inside = field.attachments.iter().zip(&places).filter(|(at, _)| at.place == Place::Inside);
    let length = places[field.attachments.len()];
    let bounds: Vec<NodeId> =
        [zero].into_iter().chain(inside.map(|(_, place)| *place)).chain([length]).collect();
    let segments = mesh.segments.iter().zip(bounds.windows(2)).map(|(segment, ends)| {
        let back = builder.scale(ends[0], -1.0);
        let whole = builder.add(ends[1], back);
        let count = builder.literal(segment.elements as f64);
        let length = builder.divide(whole, count);
        let element = |number: usize| {
            let along = builder.scale(length, number as f64);
            let start = builder.add(ends[0], along);
            Element { first_node: segment.first_node + number * mesh.order, start, length }
        };
        (0..segment.elements).map(element).collect()
    });
    segments.collect()
}

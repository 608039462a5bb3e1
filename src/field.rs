//! Scenes with fields, divided into elements: a [`FieldSimulator`] runs like any other simulator.
//!
//! ```text
//! y = [q, u, q', u', z]     q, z of the machine; u at the nodes that are the field's own
//! M(q, t) q'' = f(q, q', z, t) with inertia and force of the fields at their ports
//! M_i u_i''   = F_i(u, u', t)
//! ```
//!
//! The number of elements and their order are chosen when the simulator is made. The cost per node
//! does not depend on the number of nodes: rate, Jacobian and implicit steps have linear cost.

mod chain;
mod constants;
mod direct;
mod excitation;
mod layout;
mod lobatto;
mod local;
mod mesh;
#[cfg(feature = "linear")]
mod modal;
mod rates;
mod section;
mod simulator;

use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use machinist_contract::field::{Division, FieldScene, HANDED, MAX_ORDER};
use machinist_contract::{Dual, Real, Shape};

use chain::Chain;
use constants::Counts;
use direct::Line;
pub use lobatto::Lobatto;
use mesh::{Mesh, Owner};
#[cfg(feature = "linear")]
pub use modal::{ModalError, ModalSimulator};
use section::Section;

/// Maximum number of elements of all fields of a scene together.
pub const MAX_ELEMENTS: usize = 1_000_000;

/// Marks an entry that is not in a pattern.
const NOWHERE: u32 = u32::MAX;

/// Division of fields into elements; `None` stands for the setting of the scene's spec.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Discretisation {
    /// Number of elements of each field.
    pub elements: Option<usize>,
    /// Order of the elements.
    pub order: Option<usize>,
}

/// Reason why a field cannot be divided into elements.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "field::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum FieldError {
    /// The number of elements is out of range.
    #[error(
        "field `{field}` is cut into at least {least} and at most {most} elements, not {found}"
    )]
    ElementCount {
        /// Name of the field.
        field: String,
        /// Minimum number, one per segment between ports.
        least: usize,
        /// Maximum number, [`MAX_ELEMENTS`].
        most: usize,
        /// Requested number.
        found: usize,
    },
    /// The order is 0 or too high.
    #[error("elements have an order from 1 to {MAX_ORDER}, not {0}")]
    Order(usize),
}

impl FieldError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// A scene with fields that are divided into elements. Calls do not allocate, because memory for
/// values at nodes is kept between them; only one thread can use it at a time.
pub struct FieldSimulator<'a, R> {
    scene: Scene<'a, R>,
    discretisation: Discretisation,
    machine: Shape,
    /// Number of parameters without those that fields provide.
    parameters: usize,
    meshes: Vec<Mesh>,
    /// Number of nodes that belong to the fields themselves, over all fields.
    own_nodes: usize,
    /// Names of u and u' at every own node.
    names: [Vec<String>; 2],
    /// Field of each own node.
    field_of: Vec<u32>,
    border: Vec<u32>,
    /// Events of the machine: entries of the whole state that set the modes in which each event is
    /// active, and entries that it sets.
    events: Vec<EventPlaces>,
    rate_jacobian: Vec<(u32, u32)>,
    /// Indices of the machine's entries in the Jacobian.
    machine_entries: Vec<u32>,
    /// One for each field.
    laws: Vec<Law>,
    counts: Counts,
    /// Data for the computation of rates without [`Work`], where possible.
    lines: Option<Vec<Line>>,
    /// For each port, its node among those of all fields and the index of the first parameter that
    /// the field provides for it; and the rows that the force on it affects.
    ports: Vec<(usize, usize)>,
    port_rows: Vec<Vec<PortRow>>,
    /// True if a force on a coordinate of the machine accelerates no other one: its mass matrix is
    /// diagonal, and there are no constraints.
    accelerations_are_separate: bool,
    derivatives_read_forces: bool,
    excitation_terms: Option<Vec<(u32, u32)>>,
    parameter_jacobian: Vec<(u32, u32)>,
    mass_matrix: Vec<(u32, u32)>,
    machine_parameter_jacobian: Vec<(u32, u32)>,
    work: Mutex<Work<R>>,
    on_duals: Option<OnDuals<'a>>,
}

/// Entries of the whole state at which an event of the machine is active, and those that it sets.
struct EventPlaces {
    when: Vec<(u32, f64)>,
    sets: Vec<u32>,
}

/// The scene on dual numbers, divided into elements when derivatives are first requested.
struct OnDuals<'a> {
    scene: Scene<'a, Dual>,
    discretisation: Discretisation,
    cut: OnceLock<Option<Box<FieldSimulator<'a, Dual>>>>,
}

impl<'a> OnDuals<'a> {
    fn get(&self) -> Option<&FieldSimulator<'a, Dual>> {
        let cut = || FieldSimulator::cut(self.scene.clone(), self.discretisation).ok();
        self.cut.get_or_init(|| cut().map(Box::new)).as_deref()
    }
}

/// The scene whose fields are divided.
enum Scene<'a, R> {
    Borrowed(&'a dyn FieldScene<R>),
    Shared(Arc<dyn FieldScene<R> + Send>),
}

impl<R> Clone for Scene<'_, R> {
    fn clone(&self) -> Self {
        match self {
            Self::Borrowed(scene) => Self::Borrowed(*scene),
            Self::Shared(scene) => Self::Shared(scene.clone()),
        }
    }
}

impl<R: Real> Scene<'_, R> {
    fn get(&self) -> &dyn FieldScene<R> {
        match self {
            Self::Borrowed(scene) => *scene,
            Self::Shared(scene) => scene.as_ref(),
        }
    }
}

/// Way in which the elements of a field are evaluated.
enum Law {
    /// Constants between nodes, computed once per run.
    Section(Section),
    /// Evaluation once per element.
    Chain(Chain),
    /// Point by point, with the places of the entries of every element, by u and by u'.
    Any { places: Vec<[u32; 2]> },
}

/// A row of the Jacobian that the force on a port affects.
struct PortRow {
    row: u32,
    /// Coordinate of the machine to whose acceleration it belongs.
    coordinate: u32,
    /// Index of the entry in the machine's derivatives by parameters.
    by_force: u32,
    /// Places of the derivatives by u, then by u', at the nodes before the port, at it and after
    /// it.
    places: [u32; 6],
}

/// Memory that is kept between calls.
struct Work<R> {
    /// Parameters of the machine, including those that fields provide.
    p: Vec<R>,
    /// State of the machine.
    state: Vec<R>,
    /// Rate of the machine, or another result.
    result: Vec<R>,
    parameter_jacobian: Vec<R>,
    /// Bounds of the segments of all fields.
    bounds: Vec<R>,
    /// Constants of the parameters, for calls without them.
    constants: Vec<R>,
    places: Vec<R>,
    /// u, u', M and F at each node of every field.
    u: Vec<R>,
    v: Vec<R>,
    inertia: Vec<R>,
    force: Vec<R>,
    /// u_x and u_xt, f_1 and its derivatives for each element of a chain; derivatives of f_0 for
    /// each node.
    u_x: Vec<R>,
    v_x: Vec<R>,
    on_slopes: Vec<R>,
    by_slope: [Vec<R>; 2],
    by_value: [Vec<R>; 2],
    /// dF for each port of a chain, ordered as [`PortRow::places`].
    of_ports: Vec<[R; 6]>,
    /// Mass matrix of the machine, and the effect of a force on each port on each of its rows.
    mass: Vec<R>,
    port_weights: Vec<Vec<R>>,
    /// Derivatives of M and F.
    inertia_change: Vec<R>,
    force_change: Vec<R>,
    gradient: Vec<R>,
    slopes: Vec<R>,
    bound_changes: Vec<R>,
    /// dF at ports: node, column, value.
    at_ports: Vec<(usize, u32, R)>,
}

impl<'a, R: Real> FieldSimulator<'a, R> {
    /// Divides the fields of a scene into elements. Segments between ports get elements in
    /// proportion to their lengths at the spec's parameters.
    ///
    /// # Errors
    /// [`FieldError`] if a number is out of range.
    pub fn new(
        scene: &'a dyn FieldScene<R>,
        discretisation: Discretisation,
    ) -> Result<Self, FieldError> {
        Self::cut(Scene::Borrowed(scene), discretisation)
    }

    /// Divides the fields of a scene and keeps the scene.
    ///
    /// # Errors
    /// As for [`FieldSimulator::new`].
    pub fn of_shared(
        scene: Arc<dyn FieldScene<R> + Send>,
        discretisation: Discretisation,
    ) -> Result<Self, FieldError> {
        Self::cut(Scene::Shared(scene), discretisation)
    }

    /// Adds the scene on dual numbers. It is divided likewise when derivatives of outputs or of the
    /// start are first requested.
    #[must_use]
    pub fn with_derivatives(self, scene: &'a dyn FieldScene<Dual>) -> Self {
        self.on_duals(Scene::Borrowed(scene))
    }

    /// Adds the scene on dual numbers likewise, and keeps it.
    #[must_use]
    pub fn with_shared_derivatives(self, scene: Arc<dyn FieldScene<Dual> + Send>) -> Self {
        self.on_duals(Scene::Shared(scene))
    }

    fn on_duals(self, scene: Scene<'a, Dual>) -> Self {
        let (discretisation, cut) = (self.discretisation, OnceLock::new());
        Self { on_duals: Some(OnDuals { scene, discretisation, cut }), ..self }
    }

    /// Returns the scene.
    fn scene(&self) -> &dyn FieldScene<R> {
        self.scene.get()
    }

    /// Locks the memory for one thread. After a panic its contents do not matter, since every call
    /// writes them anew.
    fn work(&self) -> MutexGuard<'_, Work<R>> {
        self.work.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn cut(of: Scene<'a, R>, discretisation: Discretisation) -> Result<Self, FieldError> {
        let scene = of.get();
        let machine = scene.shape();
        let attachments: usize =
            (0..scene.fields()).map(|index| scene.field(index).attachments.len()).sum();
        let meshes = mesh::meshes(scene, discretisation)?;
        let own_nodes: usize = meshes.iter().map(|mesh| mesh.own_nodes).sum();
        let parameters = machine.parameters - HANDED * attachments;
        let mut simulator = Self {
            machine,
            parameters,
            own_nodes,
            names: [Vec::new(), Vec::new()],
            field_of: Vec::new(),
            border: Vec::new(),
            events: Vec::new(),
            rate_jacobian: Vec::new(),
            machine_entries: Vec::new(),
            laws: Vec::new(),
            counts: Counts::default(),
            lines: None,
            ports: Vec::new(),
            port_rows: Vec::new(),
            accelerations_are_separate: scene.constraints() == 0
                && scene.mass_matrix_pattern().entries.iter().all(|(i, j)| i == j),
            derivatives_read_forces: scene.jacobian_reads_forces(),
            excitation_terms: None,
            parameter_jacobian: Vec::new(),
            mass_matrix: Vec::new(),
            machine_parameter_jacobian: scene.parameter_jacobian_pattern().entries.to_vec(),
            work: Mutex::new(Work::new(scene, &meshes)),
            meshes,
            scene: of,
            discretisation,
            on_duals: None,
        };
        simulator.name_nodes();
        simulator.border = (0..machine.states()).map(|index| simulator.entry(index)).collect();
        let place = |entry: &u32| simulator.border[*entry as usize];
        let events = (0..simulator.scene().events()).map(|index| simulator.scene().event(index));
        simulator.events = events
            .map(|event| EventPlaces {
                when: event.when.iter().map(|(entry, mode)| (place(entry), *mode)).collect(),
                sets: event.sets.iter().map(place).collect(),
            })
            .collect();
        simulator.lay_out_rate_jacobian();
        simulator.lay_out_ports();
        simulator.lay_out_others();
        simulator.excitation_terms = excitation::terms(simulator.scene(), &simulator.border);
        simulator.counts = simulator.count_constants();
        simulator.lines = direct::lines(&simulator);
        let constants = simulator.counts.without_jacobian();
        let weights = simulator.port_rows.iter().map(|rows| vec![R::literal(0.0); rows.len()]);
        let weights = weights.collect();
        let work = simulator.work.get_mut().unwrap_or_else(PoisonError::into_inner);
        work.constants = vec![R::literal(0.0); constants];
        work.port_weights = weights;
        Ok(simulator)
    }

    /// Returns the number of coordinates.
    fn coordinates(&self) -> usize {
        self.machine.coordinates + self.own_nodes
    }

    /// Returns the index of an entry of the machine's state in the whole state.
    fn entry(&self, index: usize) -> u32 {
        let (n, all) = (self.machine.coordinates, self.coordinates());
        let moved = match index {
            _ if index < n => index,
            _ if index < 2 * n => index - n + all,
            _ => index - 2 * n + 2 * all,
        };
        moved as u32
    }

    /// Returns the indices of u and u' of a node in the state; `None` if it is held.
    fn columns(&self, owner: Owner) -> Option<[u32; 2]> {
        let coordinate = match owner {
            Owner::Fixed => return None,
            Owner::Port { coordinate, .. } => coordinate,
            Owner::Field(own) => self.machine.coordinates as u32 + own,
        };
        Some([coordinate, coordinate + self.coordinates() as u32])
    }

    /// Returns x at the nodes of a field \[m\] for given parameters.
    #[must_use]
    pub fn places(&self, field: usize, parameters: &[R]) -> Vec<R> {
        let mut work = self.work();
        self.place(parameters, &mut work);
        let mesh = &self.meshes[field];
        let mut x = vec![R::literal(0.0); mesh.owners.len()];
        mesh.elements(field, &work.bounds[mesh.bounds(field)]).places(&mut x);
        x
    }

    /// Returns for each field the rule of its elements, and x at its nodes \[m\] for given
    /// parameters.
    #[must_use]
    pub fn divisions(&self, parameters: &[R]) -> Vec<Division<'_, Vec<R>>> {
        let meshes = self.meshes.iter().enumerate();
        let divisions = meshes.map(|(field, mesh)| Division {
            rule: mesh.rule.rule(),
            places: self.places(field, parameters),
        });
        divisions.collect()
    }

    /// Returns u at the nodes of a field in a given state.
    #[must_use]
    pub fn values(&self, field: usize, state: &[R]) -> Vec<R> {
        let value = |owner: &Owner| match self.columns(*owner) {
            Some([position, _]) => state[position as usize],
            None => R::literal(0.0),
        };
        self.meshes[field].owners.iter().map(value).collect()
    }

    /// Returns the number of nodes of all fields.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.owners.len()).sum()
    }

    /// Returns the fields that have a section.
    fn sections(&self) -> impl Iterator<Item = (usize, &Section)> {
        self.laws.iter().enumerate().filter_map(|(index, law)| match law {
            Law::Section(section) => Some((index, section)),
            _ => None,
        })
    }
}

/// Returns the index of an entry of a pattern.
fn find(entries: &[(u32, u32)], row: u32, column: u32) -> usize {
    entries.binary_search(&(row, column)).expect("the pattern was made of these entries")
}

impl<R: Real> Work<R> {
    fn new(scene: &dyn FieldScene<R>, meshes: &[Mesh]) -> Self {
        let zeros = |count: usize| vec![R::literal(0.0); count];
        let shape = scene.shape();
        let nodes: usize = meshes.iter().map(|mesh| mesh.owners.len()).sum();
        let most_nodes = meshes.iter().map(|mesh| mesh.owners.len()).max().unwrap_or_default();
        let most = |count: &dyn Fn(usize) -> usize| {
            (0..scene.fields()).map(count).max().unwrap_or_default()
        };
        let parameters = most(&|index| scene.field(index).parameters.len());
        let places = most(&|index| scene.field(index).attachments.len()) + 1;
        Self {
            p: (0..shape.parameters)
                .map(|i| R::literal(scene.parameter_default(i)))
                .chain(zeros(scene.relations()))
                .collect(),
            state: zeros(shape.states()),
            result: zeros(shape.states().max(scene.rate_jacobian_pattern().entries.len())),
            parameter_jacobian: zeros(scene.parameter_jacobian_pattern().entries.len()),
            bounds: zeros(meshes.iter().map(|mesh| mesh.segments.len() + 1).sum()),
            constants: Vec::new(),
            places: zeros(places),
            u: zeros(nodes),
            v: zeros(nodes),
            inertia: zeros(nodes),
            force: zeros(nodes),
            u_x: zeros(most_nodes),
            v_x: zeros(most_nodes),
            on_slopes: zeros(most_nodes),
            by_slope: [zeros(most_nodes), zeros(most_nodes)],
            by_value: [zeros(most_nodes), zeros(most_nodes)],
            of_ports: Vec::new(),
            mass: zeros(scene.mass_matrix_pattern().entries.len()),
            port_weights: Vec::new(),
            inertia_change: zeros(nodes),
            force_change: zeros(nodes),
            gradient: zeros(2 * (2 + parameters)),
            slopes: zeros(places * parameters),
            bound_changes: zeros(places + 1),
            at_ports: Vec::new(),
        }
    }
}

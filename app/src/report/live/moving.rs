//! Elements of a machine that can be shown moving: parts that turn or slide as one, and points of
//! bodies in a plane.

use machinist_codegen::spec::{InstanceSpec, PortSpec, SceneSpec, Symbol};
use machinist_model::{Model, StateKind};
use serde::Serialize;

use crate::report::schematic::drawn;

/// Moving elements with their entries of the state.
#[derive(Debug, Clone, Default, Serialize)]
pub(in crate::report) struct Moving {
    parts: Vec<MovingPart>,
    bodies: Vec<Body>,
}

/// Part of the drawing that turns or slides as one.
#[derive(Debug, Clone, Serialize)]
struct MovingPart {
    /// Index among the parts.
    part: usize,
    slides: bool,
    by: Track,
}

/// Entries of the state that determine a position; at least one is present.
#[derive(Debug, Clone, Copy, Serialize)]
struct Track {
    position: Option<u32>,
    velocity: Option<u32>,
}

/// Part with points in a plane.
#[derive(Debug, Clone, Serialize)]
struct Body {
    name: String,
    /// Entries of the state for x and y of each point; `None` if the coordinate is held at zero.
    points: Vec<[Option<u32>; 2]>,
    /// Entry of the angle.
    angle: Option<u32>,
}

/// Representation of a part's coordinate in the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum At {
    Coordinate(u32),
    Held,
}

impl Moving {
    /// Collects the moving elements of a scene and its model.
    pub(in crate::report) fn of(scene: &SceneSpec, model: &Model) -> Self {
        let joined = Joined::of(scene);
        let parts = drawn(scene).enumerate();
        let parts = parts.filter_map(|(part, instance)| {
            let unit = &scene.units[instance.unit];
            let (slides, id) = joined.moves_as_one(scene, model, instance)?;
            is_solid(unit.symbol).then_some(())?;
            Some(MovingPart { part, slides, by: Track::of(model, id)? })
        });
        let bodies = scene.instances.iter().filter_map(|it| joined.body(scene, model, it));
        Self { parts: parts.collect(), bodies: bodies.collect() }
    }

    /// Returns the elements of a machine with more coordinates behind its own.
    pub(super) fn moved(&self, own: usize, all: usize) -> Self {
        let by =
            |entry: u32| if (entry as usize) < own { entry } else { entry + (all - own) as u32 };
        let mut moved = self.clone();
        for MovingPart { by: track, .. } in &mut moved.parts {
            *track = Track { position: track.position.map(by), velocity: track.velocity.map(by) };
        }
        moved
    }

    /// Returns the entries of the state that show it, in order.
    pub(in crate::report) fn entries(&self) -> Vec<u32> {
        let of_parts = self.parts.iter().filter_map(|part| part.by.position.or(part.by.velocity));
        let of_bodies = self
            .bodies
            .iter()
            .flat_map(|body| body.points.iter().flatten().copied().chain([body.angle]).flatten());
        of_parts.chain(of_bodies).collect()
    }

    pub(in crate::report) fn is_empty(&self) -> bool {
        self.parts.is_empty() && self.bodies.is_empty()
    }
}

/// Returns whether a symbol stands for one solid thing, which moves as one.
fn is_solid(symbol: Option<Symbol>) -> bool {
    matches!(
        symbol,
        Some(
            Symbol::Inertia
                | Symbol::Motor
                | Symbol::Gear
                | Symbol::Wheel
                | Symbol::Fan
                | Symbol::Cam
                | Symbol::Mass
                | Symbol::Friction
        )
    )
}

impl Track {
    fn of(model: &Model, id: u32) -> Option<Self> {
        let entry = |kind: StateKind| model.states.iter().position(|state| state.kind == kind);
        let track = Self {
            position: position(model, id),
            velocity: entry(StateKind::Velocity(id)).map(|entry| entry as u32),
        };
        (track.position.is_some() || track.velocity.is_some()).then_some(track)
    }
}

/// Returns the entry of a coordinate, if the state holds the coordinate itself and not its
/// difference from another.
fn position(model: &Model, id: u32) -> Option<u32> {
    let own = &model.coordinates[id as usize].position;
    let is_it = |state: &machinist_model::State| {
        state.kind == StateKind::Position(id) && state.quantity == *own
    };
    model.states.iter().position(is_it).map(|entry| entry as u32)
}

/// Groups of coordinates, `part.coordinate`, that joints make equal.
struct Joined(Vec<Vec<String>>);

impl Joined {
    fn of(scene: &SceneSpec) -> Self {
        let mut groups: Vec<Vec<String>> = Vec::new();
        for joint in &scene.joints {
            let ends = [0, 1].map(|end| end_of(scene, &joint.connect[end].value));
            let [Some(one), Some(other)] = ends else { continue };
            let mut together = vec![one, other];
            groups.retain_mut(|group| {
                let meets = group.iter().any(|path| together[..2].contains(path));
                if meets {
                    together.append(group);
                }
                !meets
            });
            groups.push(together);
        }
        Self(groups)
    }

    fn resolve(&self, scene: &SceneSpec, model: &Model, path: &str) -> Option<At> {
        let alone = vec![path.to_owned()];
        let group = self.0.iter().find(|group| group.iter().any(|known| known == path));
        let group = group.unwrap_or(&alone);
        let is_in = |path: &String| group.contains(path);
        let found = model.coordinates.iter().position(|c| is_in(&c.position.name.path));
        let found = found.map(|id| At::Coordinate(id as u32));
        found.or_else(|| group.iter().any(|path| is_held(scene, path)).then_some(At::Held))
    }

    /// Returns whether a part's only coordinate is a displacement rather than an angle, and its
    /// index. `None` if the part has several.
    fn moves_as_one(
        &self,
        scene: &SceneSpec,
        model: &Model,
        instance: &InstanceSpec,
    ) -> Option<(bool, u32)> {
        let unit = &scene.units[instance.unit];
        let mut moves: Vec<(bool, Option<At>)> = unit
            .coordinates
            .iter()
            .map(|coordinate| {
                let path = format!("{}.{}", instance.name.value, coordinate.name.value);
                (coordinate.unit.text == "m", self.resolve(scene, model, &path))
            })
            .collect();
        moves.dedup();
        match moves[..] {
            [(slides, Some(At::Coordinate(id)))] => Some((slides, id)),
            _ => None,
        }
    }

    /// Returns the points of a part that has some: coordinates `x` and `y`, or `x_a` and `y_a`.
    fn body(&self, scene: &SceneSpec, model: &Model, instance: &InstanceSpec) -> Option<Body> {
        let unit = &scene.units[instance.unit];
        let name = &instance.name.value;
        let entry = |coordinate: &str| -> Option<Option<u32>> {
            unit.coordinates.iter().find(|known| known.name.value == coordinate)?;
            match self.resolve(scene, model, &format!("{name}.{coordinate}"))? {
                At::Held => Some(None),
                At::Coordinate(id) => position(model, id).map(Some),
            }
        };
        let suffixes =
            unit.coordinates.iter().filter_map(|known| known.name.value.strip_prefix('x'));
        let points = suffixes.filter_map(|suffix| {
            Some([entry(&format!("x{suffix}"))?, entry(&format!("y{suffix}"))?])
        });
        let points: Vec<_> = points.collect();
        let moves = points.iter().flatten().any(Option::is_some);
        let angle = entry("phi").flatten();
        moves.then(|| Body { name: name.clone(), points, angle })
    }
}

/// Returns the coordinate that moves by the same amount as a port.
fn end_of(scene: &SceneSpec, text: &str) -> Option<String> {
    let (name, port) = text.rsplit_once('.')?;
    let instance = scene.instances.iter().find(|known| known.name.value == name)?;
    let ports = &scene.units[instance.unit].ports;
    let port: &PortSpec = ports.iter().find(|known| known.name.value == port)?;
    let is_same = port.ratio.is_none() && port.attachment.is_none();
    is_same.then(|| format!("{name}.{}", port.coordinate.value))
}

fn is_held(scene: &SceneSpec, path: &str) -> bool {
    let Some((name, coordinate)) = path.rsplit_once('.') else { return false };
    let instance = scene.instances.iter().find(|known| known.name.value == name);
    let coordinates = instance.map(|known| &scene.units[known.unit].coordinates);
    let found = coordinates.and_then(|all| all.iter().find(|c| c.name.value == coordinate));
    found.is_some_and(|coordinate| coordinate.is_fixed)
}

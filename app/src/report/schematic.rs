//! Drawing of a machine: its parts and their connections.

mod arrange;
mod draw;
mod symbol;

use machinist_codegen::spec::expression::{Ast, Node};
use machinist_codegen::spec::{Acts, Formula, InstanceSpec, PortKind, SceneSpec, Symbol};
use maud::{Markup, html};

use super::page::prose;
pub use draw::{drawing, legend};

/// Elements of a scene's drawing.
pub struct Schematic {
    parts: Vec<Part>,
    nets: Vec<Net>,
    links: Vec<Link>,
}

/// Instance of a unit, or a force of the scene.
struct Part {
    name: String,
    /// Name of the unit; empty for a force.
    unit: String,
    /// Title and description.
    title: String,
    doc: String,
    symbol: Option<Symbol>,
}

/// Ports that move together.
struct Net {
    kind: PortKind,
    /// Parts, each with the name of its port.
    ports: Vec<(usize, String)>,
}

/// Connection between two parts without a joint.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Link {
    from: usize,
    to: usize,
    what: Tie,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Tie {
    /// An input is an expression of another part's motion.
    Signal,
    /// A constraint of the scene depends on both parts.
    Constraint,
}

/// Returns the instances to draw: all except assemblies that are nothing beside their contents.
pub fn drawn(scene: &SceneSpec) -> impl Iterator<Item = &InstanceSpec> {
    scene.instances.iter().filter(|instance| {
        let unit = &scene.units[instance.unit];
        !unit.is_assembly() || !unit.coordinates.is_empty()
    })
}

impl Schematic {
    /// Collects the parts of a scene.
    pub fn of(scene: &SceneSpec) -> Self {
        let part = |instance: &InstanceSpec| {
            let unit = &scene.units[instance.unit];
            Part {
                name: instance.name.value.clone(),
                unit: unit.name.clone(),
                title: unit.title.clone(),
                doc: unit.doc.clone(),
                symbol: unit.symbol,
            }
        };
        let mut schematic =
            Self { parts: drawn(scene).map(part).collect(), nets: Vec::new(), links: Vec::new() };
        for joint in &scene.joints {
            schematic.join(scene, &joint.connect[0].value, &joint.connect[1].value);
        }
        for force in &scene.forces {
            if let Acts::On(port) = &force.acts {
                schematic.force(scene, &port.value, &force.doc);
            }
        }
        schematic.links(scene);
        schematic
    }

    /// Number of parts.
    pub fn parts(&self) -> usize {
        self.parts.len()
    }

    /// Renders a list of the parts with their descriptions.
    pub fn list(&self) -> Markup {
        html! {
            div.scroll {
                table {
                    thead { tr { th { "Part" } th { "Unit" } th { "What it is" } } }
                    tbody { @for part in &self.parts { tr {
                        td { code { (part.name) } }
                        td { @if !part.unit.is_empty() { code { (part.unit) } } }
                        td {
                            (part.title)
                            @if !part.doc.is_empty() { div.muted { (prose(&part.doc)) } }
                        }
                    } } }
                }
            }
        }
    }

    fn index(&self, name: &str) -> Option<usize> {
        self.parts.iter().position(|part| part.name == name)
    }

    /// Returns a port by `instance.port`, with its kind.
    fn port(&self, scene: &SceneSpec, text: &str) -> Option<(usize, String, PortKind)> {
        let (instance, port) = text.rsplit_once('.')?;
        let part = self.index(instance)?;
        let unit = &scene.units[drawn(scene).nth(part)?.unit];
        let kind = unit.ports.iter().find(|known| known.name.value == port)?.kind.value;
        Some((part, port.to_owned(), kind))
    }

    /// Returns the net of a port, after adding a new one if the port is in none.
    fn net(&mut self, (part, port, kind): (usize, String, PortKind)) -> usize {
        let port = (part, port);
        self.nets.iter().position(|net| net.ports.contains(&port)).unwrap_or_else(|| {
            self.nets.push(Net { kind, ports: vec![port] });
            self.nets.len() - 1
        })
    }

    fn join(&mut self, scene: &SceneSpec, one: &str, other: &str) {
        let (Some(one), Some(other)) = (self.port(scene, one), self.port(scene, other)) else {
            return;
        };
        let (one, other) = (self.net(one), self.net(other));
        if one != other {
            let ports = self.nets.remove(one.max(other)).ports;
            self.nets[one.min(other)].ports.extend(ports);
        }
    }

    fn force(&mut self, scene: &SceneSpec, port: &str, doc: &str) {
        let Some(port) = self.port(scene, port) else { return };
        let kind = port.2;
        let net = self.net(port);
        let name = if kind == PortKind::Rotational { "torque" } else { "force" };
        self.nets[net].ports.push((self.parts.len(), String::new()));
        self.parts.push(Part {
            name: name.to_owned(),
            unit: String::new(),
            title: "Force of the scene".to_owned(),
            doc: doc.to_owned(),
            symbol: Some(Symbol::Force),
        });
    }

    fn links(&mut self, scene: &SceneSpec) {
        for (to, instance) in drawn(scene).enumerate() {
            for (_, formula) in &instance.inputs {
                let Formula::Expression(ast) = formula else { continue };
                for from in self.mentioned(scene, instance.parent, ast) {
                    self.link(Link { from, to, what: Tie::Signal });
                }
            }
        }
        for constraint in &scene.constraints {
            let parts = self.mentioned(scene, None, &constraint.expression);
            for pair in parts.windows(2) {
                self.link(Link { from: pair[0], to: pair[1], what: Tie::Constraint });
            }
        }
    }

    fn link(&mut self, link: Link) {
        if link.from != link.to && !self.links.contains(&link) {
            self.links.push(link);
        }
    }

    /// Returns the parts that an expression of the scene or of an assembly mentions, directly or
    /// through helpers.
    fn mentioned(&self, scene: &SceneSpec, within: Option<usize>, ast: &Ast) -> Vec<usize> {
        let (mut parts, mut seen) = (Vec::new(), Vec::new());
        let assembly = within.map(|at| &scene.instances[at]);
        let prefix = assembly.map_or(String::new(), |it| format!("{}.", it.name.value));
        let helpers = assembly.map_or(&scene.helpers, |it| &scene.units[it.unit].helpers);
        let mut left = vec![ast];
        while let Some(ast) = left.pop() {
            ast.visit(&mut |part| match &part.node {
                Node::Name(Some(instance), _) => {
                    let part = self.index(&format!("{prefix}{instance}"));
                    parts.extend(part.filter(|part| !parts.contains(part)));
                }
                Node::Name(None, name) if !seen.contains(&name) => {
                    seen.push(name);
                    let helper = helpers.iter().find(|known| known.name.value == *name);
                    left.extend(helper.map(|helper| &helper.expression));
                }
                _ => {}
            });
        }
        parts
    }
}

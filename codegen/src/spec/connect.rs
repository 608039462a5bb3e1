//! Expansion of connectors and of ports of assemblies into joints of single ports.
//!
//! Excluded: paths that name no port. They stay as written, and the scene reports them.

use std::collections::HashMap;

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::names::{did_you_mean, quoted};
use crate::spec::{Acts, InstanceSpec, JointSpec, PortForceSpec, UnitSpec};

/// Returns the joints, each of two ports of parts, and expands forces of the scene on such ports.
pub fn ports_of(
    units: &[UnitSpec],
    instances: &[InstanceSpec],
    joints: Vec<JointSpec>,
    forces: &mut [PortForceSpec],
    mistakes: &mut Vec<Mistake>,
) -> Vec<JointSpec> {
    let named = instances.iter().enumerate();
    let by_name = named.map(|(at, instance)| (instance.name.value.as_str(), at)).collect();
    let scene = Ports { units, instances, by_name };
    for unit in units {
        check_names(unit, mistakes);
    }
    scene.check_exposed(mistakes);
    let mut all = Vec::with_capacity(joints.len());
    for joint in joints {
        match scene.pairs(&joint) {
            Ok(pairs) => all.extend(pairs),
            Err(mistake) => mistakes.push(*mistake),
        }
    }
    for force in forces {
        let Acts::On(port) = &mut force.acts else { continue };
        match scene.ports(&port.value).as_deref() {
            Some([one]) => port.value.clone_from(one),
            Some(ports) => mistakes.push(of_several(port, ports)),
            None => {}
        }
    }
    all
}

/// Checks that connectors contain only ports of the unit, and that their names are distinct.
fn check_names(unit: &UnitSpec, mistakes: &mut Vec<Mistake>) {
    let ports = || {
        let own = unit.ports.iter().map(|port| port.name.value.as_str());
        own.chain(unit.exposed.iter().map(|port| port.name.value.as_str()))
    };
    for connector in &unit.connectors {
        let name = &connector.name;
        if ports().any(|port| port == name.value) {
            let message = format!("{} is both a port and a connector", quoted(&name.value));
            mistakes.push(Mistake::new(Code::DuplicateName, name.span, message, "given again"));
        }
        for (index, port) in connector.ports.iter().enumerate() {
            if !ports().any(|known| known == port.value) {
                let of = quoted(&unit.name);
                let message = format!("unit {of} has no port {}", quoted(&port.value));
                let help = did_you_mean(&port.value, ports());
                mistakes.push(
                    Mistake::new(Code::UnknownPort, port.span, message, "unknown").help(help),
                );
            }
            if connector.ports[..index].iter().any(|before| before.value == port.value) {
                let of = quoted(&name.value);
                let message = format!("connector {of} has {} twice", quoted(&port.value));
                mistakes.push(Mistake::new(Code::DuplicateName, port.span, message, "again"));
            }
        }
    }
}

/// Returns the mistake of a force on a connector.
fn of_several(port: &Spanned<String>, ports: &[String]) -> Mistake {
    let message = format!("a force acts on one port, but {} is a connector", quoted(&port.value));
    let help = format!("its ports are {}", ports.join(", "));
    Mistake::new(Code::WrongKindOfName, port.span, message, "several ports").help(help)
}

struct Ports<'a> {
    units: &'a [UnitSpec],
    instances: &'a [InstanceSpec],
    by_name: HashMap<&'a str, usize>,
}

impl Ports<'_> {
    /// Returns the ports of parts that a path stands for; `None` if it names no port.
    fn ports(&self, path: &str) -> Option<Vec<String>> {
        let (instance, name) = path.rsplit_once('.')?;
        let unit = &self.units[self.instances[*self.by_name.get(instance)?].unit];
        if let Some(connector) = unit.connectors.iter().find(|known| known.name.value == name) {
            let ports = connector.ports.iter().map(|port| self.port(unit, instance, &port.value));
            return Some(ports.collect::<Option<Vec<_>>>()?.concat());
        }
        self.port(unit, instance, name)
    }

    /// Returns the same for a path that is not a connector of the unit itself.
    fn port(&self, unit: &UnitSpec, instance: &str, name: &str) -> Option<Vec<String>> {
        // A path in an assembly names something further inside, so the recursion ends.
        if let Some(exposed) = unit.exposed.iter().find(|known| known.name.value == name) {
            return self.ports(&format!("{instance}.{}", exposed.of.value));
        }
        let is_own = unit.ports.iter().any(|port| port.name.value == name);
        is_own.then(|| vec![format!("{instance}.{name}")])
    }

    /// Checks that ports of assemblies are ports of inner instances.
    fn check_exposed(&self, mistakes: &mut Vec<Mistake>) {
        for instance in self.instances {
            for exposed in &self.units[instance.unit].exposed {
                let of = &exposed.of;
                if self.ports(&format!("{}.{}", instance.name.value, of.value)).is_some() {
                    continue;
                }
                let message = format!("{} is not a port of a part inside", quoted(&of.value));
                let part = of.value.rsplit_once('.').map_or("", |(part, _)| part);
                let whole = format!("{}.{part}", instance.name.value);
                let help = if let Some(at) = self.by_name.get(whole.as_str()) {
                    let unit = &self.units[self.instances[*at].unit];
                    did_you_mean(&of.value[part.len() + 1..], names_of(unit))
                } else {
                    let inside = &self.units[instance.unit].inside.instances;
                    did_you_mean(part, inside.iter().map(|text| text.name.value.as_str()))
                };
                mistakes
                    .push(Mistake::new(Code::UnknownPort, of.span, message, "unknown").help(help));
            }
        }
    }

    /// Returns the mistake of a path whose unit has no such port and no such connector.
    fn no_port(&self, path: &Spanned<String>) -> Option<Mistake> {
        let (instance, name) = path.value.rsplit_once('.')?;
        let unit = &self.units[self.instances[*self.by_name.get(instance)?].unit];
        if names_of(unit).any(|known| known == name) {
            return None;
        }
        let message = format!("unit {} has no port {}", quoted(&unit.name), quoted(name));
        let help = did_you_mean(name, names_of(unit));
        Some(Mistake::new(Code::UnknownPort, path.span, message, "unknown").help(help))
    }

    /// Splits a joint of connectors into joints of their ports, one by one.
    fn pairs(&self, joint: &JointSpec) -> Result<Vec<JointSpec>, Box<Mistake>> {
        let [first, second] = &joint.connect;
        let (ports, others) = match [first, second].map(|path| self.ports(&path.value)) {
            [Some(ports), Some(others)] => (ports, others),
            // Unchanged, the joint would cause a message about a connector that is not a port.
            [Some(several), None] | [None, Some(several)] if several.len() > 1 => {
                let unknown = [first, second].into_iter().find_map(|path| self.no_port(path));
                return unknown.map_or_else(|| Ok(vec![joint.clone()]), |no| Err(Box::new(no)));
            }
            _ => return Ok(vec![joint.clone()]),
        };
        if ports.len() != others.len() {
            return Err(Box::new(of_unlike_counts([first, second], [&ports, &others])));
        }
        if let Some(ratio) = &joint.ratio
            && ports.len() > 1
        {
            let message = "a joint of connectors cannot have a ratio";
            let mistake =
                Mistake::new(Code::InvalidJoint, ratio.span(), message, "for which ports?");
            return Err(Box::new(mistake.help("join their ports one by one")));
        }
        let pairs = ports.into_iter().zip(others).map(|(port, other)| JointSpec {
            connect: [
                Spanned { value: port, span: first.span },
                Spanned { value: other, span: second.span },
            ],
            ratio: joint.ratio.clone(),
            within: joint.within,
        });
        Ok(pairs.collect())
    }
}

/// Iterates over the names of ports and connectors of a unit.
pub fn names_of(unit: &UnitSpec) -> impl Iterator<Item = &str> {
    let ports = unit.ports.iter().map(|port| port.name.value.as_str());
    let exposed = unit.exposed.iter().map(|port| port.name.value.as_str());
    let connectors = unit.connectors.iter().map(|connector| connector.name.value.as_str());
    ports.chain(exposed).chain(connectors)
}

fn of_unlike_counts(paths: [&Spanned<String>; 2], ports: [&[String]; 2]) -> Mistake {
    let count = |ports: &[String]| match ports.len() {
        1 => "1 port".to_owned(),
        count => format!("{count} ports"),
    };
    let [first, second] = paths;
    let message = format!(
        "joined connectors need the same number of ports: {} has {}, {} has {}",
        quoted(&first.value),
        count(ports[0]),
        quoted(&second.value),
        count(ports[1])
    );
    let help = format!("{}; {}", ports[0].join(", "), ports[1].join(", "));
    Mistake::new(Code::InvalidJoint, second.span, message, count(ports[1])).help(help)
}

//! `terminalsAndIcons/terminalsAndIcons.xml`: groups of variables of a shaft or sliding part, which
//! hosts connect together.
//!
//! Ports that joints connect move together and form one terminal. The standard allows only outputs
//! and inputs as members. Angle and speed are members if the scene has them as outputs, and the
//! torque if it is an input. Members are named as in Modelica's flanges.

use machinist::simulate::parameter_defaults;
use machinist_contract::Simulator;
use machinist_fmu::resource::Machine;
use machinist_fmu::variables::{Causality, Kind, Variable};
use machinist_model::{Coordinate, NodeId, Op};

use super::xml::Element;

/// Kind of ports.
struct Domain {
    /// Unit of the coordinate.
    unit: &'static str,
    kind: &'static str,
    /// Names of position and velocity.
    across: [&'static str; 2],
    /// Torque or force, and its unit.
    through: [&'static str; 2],
}

const DOMAINS: [Domain; 2] = [
    Domain { unit: "rad", kind: "rotational", across: ["phi", "w"], through: ["tau", "N m"] },
    Domain { unit: "m", kind: "translational", across: ["s", "v"], through: ["f", "N"] },
];

/// Returns the text of the file; `None` if no terminal has a member.
pub fn text(machine: &Machine) -> Option<String> {
    let coordinates = &machine.model().coordinates;
    let found: Vec<(&Coordinate, &Domain, Vec<Element>)> = coordinates
        .iter()
        .filter_map(|coordinate| {
            let unit = &coordinate.position.unit;
            let domain = DOMAINS.iter().find(|domain| domain.unit == unit)?;
            let members = members(machine, coordinate, domain);
            (!members.is_empty()).then_some((coordinate, domain, members))
        })
        .collect();
    if found.is_empty() {
        return None;
    }
    let units: Vec<&str> = found.iter().map(|(coordinate, ..)| unit_of(coordinate)).collect();
    let terminals = found.iter().map(|(coordinate, domain, members)| {
        let unit = unit_of(coordinate);
        let is_alone = units.iter().filter(|other| **other == unit).count() == 1;
        let name = if is_alone { unit } else { &coordinate.position.name.path };
        let doc = &coordinate.position.doc;
        Element::new("Terminal")
            .with("name", name)
            // The set of members varies.
            .with("matchingRule", "bus")
            .with("terminalKind", format!("_machinist_{}", domain.kind))
            .with_some("description", Some(doc).filter(|doc| !doc.is_empty()))
            .holding(members.iter().cloned())
    });
    let terminals = Element::new("Terminals").holding(terminals);
    let root = Element::new("fmiTerminalsAndIcons").with("fmiVersion", "3.0");
    Some(root.holding([terminals]).document())
}

/// Returns the unit of a coordinate: `cylinder` of `cylinder.phi`.
fn unit_of(coordinate: &Coordinate) -> &str {
    let path = coordinate.position.name.path.as_str();
    path.rsplit_once('.').map_or(path, |(unit, _)| unit)
}

fn members(machine: &Machine, coordinate: &Coordinate, domain: &Domain) -> Vec<Element> {
    let across = domain.across.into_iter().zip([&coordinate.position, &coordinate.velocity]);
    let signals = across.filter_map(|(member, quantity)| {
        Some(element(output(machine, &quantity.name.path)?, member, "signal"))
    });
    let velocity = &coordinate.velocity.name.path;
    let [member, unit] = domain.through;
    let inputs = machine
        .variables
        .all()
        .iter()
        .filter(|variable| variable.causality == Causality::Input && variable.unit == unit);
    let mut forces = inputs.filter_map(|input| {
        let Kind::Parameter(index) = input.kind else { return None };
        let kind = match sign_of_force(machine.simulator(), index, velocity)? {
            Sign::Along => "inflow",
            Sign::Against => "outflow",
        };
        Some(element(input, member, kind))
    });
    // Names of members are unique. If several forces act on a port, none is the total, and none is
    // a member.
    let force = forces.next();
    let is_only = forces.next().is_none();
    signals.chain(force.filter(|_| is_only)).collect()
}

fn element(variable: &Variable, member: &'static str, kind: &'static str) -> Element {
    Element::new("TerminalMemberVariable")
        .with("variableName", &variable.name)
        .with("memberName", member)
        .with("variableKind", kind)
}

/// Returns the output that shows a state, if there is one.
fn output<'a>(machine: &'a Machine, state: &str) -> Option<&'a Variable> {
    let (model, simulator) = (machine.model(), machine.simulator());
    let is_it = |kind: Kind| match kind {
        Kind::State(entry) => simulator.state(entry).name == state,
        Kind::Output(index) => {
            let node = model.outputs.results.get(index).map(|NodeId(node)| *node as usize);
            match node.map(|node| model.outputs.nodes[node].op) {
                Some(Op::State(entry)) => model.states[entry as usize].quantity.name.path == state,
                _ => false,
            }
        }
        _ => false,
    };
    let mut all = machine.variables.all().iter();
    all.find(|variable| variable.causality == Causality::Output && is_it(variable.kind))
}

enum Sign {
    Along,
    Against,
}

/// Returns the sign of a parameter that is the torque or force on a part with the given velocity:
/// the supplied power is velocity times parameter in every state. `None` for other parameters.
fn sign_of_force(simulator: &dyn Simulator<f64>, parameter: usize, velocity: &str) -> Option<Sign> {
    /// Relative rounding of powers.
    const ROUNDING: f64 = 1e-9;
    let shape = simulator.shape();
    let entry = (0..shape.states()).find(|entry| simulator.state(*entry).name == velocity)?;
    let base = parameter_defaults(simulator);
    let supplied = |time: f64, state: &[f64], value: f64| {
        let mut parameters = base.clone();
        parameters[parameter] = value;
        simulator.power_balance(time, state, &parameters).supplied
    };
    let mut is = [true, true];
    for place in 1..=4 {
        // Arbitrary but reproducible states.
        let around = |entry: usize| ((place * 7 + entry * 3) as f64 * 0.618).sin();
        let state: Vec<f64> =
            (0..shape.states()).map(|entry| around(entry) * simulator.state_scale(entry)).collect();
        let time = simulator.run_defaults().from + f64::from(place as u8);
        let powers = [supplied(time, &state, 1.0), supplied(time, &state, -1.0)];
        let by_force = 0.5 * (powers[0] - powers[1]);
        let allowed = ROUNDING * (powers[0].abs() + powers[1].abs() + state[entry].abs());
        for (is, sign) in is.iter_mut().zip([1.0, -1.0]) {
            *is &= (by_force - sign * state[entry]).abs() <= allowed;
        }
    }
    match is {
        [true, _] => Some(Sign::Along),
        [_, true] => Some(Sign::Against),
        _ => None,
    }
}

//! Reference cards of the units that come with Machinist, as plain text.

use crate::spec::diagnostic::{Diagnostics, FileId, Span};
use crate::spec::fields::Findings;
use crate::spec::library::LibraryUnit;
use crate::spec::source::{Sources, one_line, written, written_formula};
use crate::spec::{
    Acts, ConnectorSpec, DefinitionSpec, EventSpec, ExposedSpec, Formula, InstanceText, JointSpec,
    PortKind, UnitSpec, Value, toml, unit,
};
use machinist_model::Direction;

/// Name, ports, numbers and equations of a unit, as written in its spec.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Card {
    /// Name of the unit in scenes.
    pub name: String,
    /// Title of one line.
    pub title: String,
    /// Description.
    pub doc: String,
    /// Source of its equations.
    pub source: String,
    /// Other words for the part.
    pub synonyms: Vec<String>,
    /// Ports: name, kind and displacement.
    pub ports: Vec<[String; 3]>,
    /// Connectors: name, and the ports they group.
    pub connectors: Vec<[String; 2]>,
    /// Parts of an assembly: name, unit, and values other than the unit's.
    pub parts: Vec<[String; 3]>,
    /// Joints between the parts of an assembly.
    pub joints: Vec<[String; 2]>,
    /// Parameters: name, value, unit and meaning.
    pub parameters: Vec<[String; 4]>,
    /// Inputs: name, unit and meaning.
    pub inputs: Vec<[String; 3]>,
    /// Modes: name and meaning.
    pub modes: Vec<[String; 2]>,
    /// Equations: left side, right side, unit and meaning.
    pub equations: Vec<[String; 4]>,
    /// Events: guard, resets and meaning; those of dry friction by their names.
    pub events: Vec<[String; 3]>,
    /// Outputs and helpers: name, unit and meaning.
    pub outputs: Vec<[String; 3]>,
    /// Short example scene that uses the unit.
    pub example: Option<&'static str>,
}

impl Card {
    /// Reads the spec of a unit of the library.
    ///
    /// # Errors
    /// The mistakes in the spec; units of the library have none.
    pub fn of(library: &LibraryUnit) -> Result<Self, Diagnostics> {
        let mut sources = Sources::beside(std::path::Path::new("unit.toml"));
        let file: FileId = sources.embed(&format!("units/{}.toml", library.name), library.text);
        let tree = toml::parse(library.text, file).map_err(|m| sources.diagnostics(&[m]))?;
        let mut found = Findings::default();
        let spec = unit::read(&tree, library.name, file, true, &mut found);
        if !found.mistakes.is_empty() {
            return Err(sources.diagnostics(&found.mistakes));
        }
        Ok(Reader(library.text).card(library, &spec))
    }
}

/// The text that spans refer to.
struct Reader(&'static str);

impl Reader {
    fn written(&self, span: Span) -> String {
        written(self.0, span)
    }

    fn formula(&self, formula: &Formula) -> String {
        written_formula(self.0, formula)
    }

    fn card(&self, library: &LibraryUnit, spec: &UnitSpec) -> Card {
        let port = |port: &crate::spec::PortSpec| {
            let coordinate = &port.coordinate.value;
            let moves = match &port.ratio {
                None if port.kind.value == PortKind::Frame => "a frame".to_owned(),
                None => coordinate.clone(),
                Some(ratio) => format!("({})*{coordinate}", self.formula(ratio)),
            };
            [port.name.value.clone(), port.kind.value.name().to_owned(), moves]
        };
        let parameter = |parameter: &crate::spec::ParameterSpec| {
            let value = match &parameter.value {
                Value::Number(value) => number(*value),
                Value::Expression(ast) => self.written(ast.span),
            };
            [
                parameter.name.value.clone(),
                value,
                parameter.unit.text.clone(),
                one_line(&parameter.doc),
            ]
        };
        let input = |input: &crate::spec::InputSpec| {
            [input.name.value.clone(), input.unit.text.clone(), one_line(&input.doc)]
        };
        let modes = spec.states.iter().filter(|state| state.is_mode);
        let forces = spec.frictions.iter().map(|friction| &friction.force);
        let outputs = spec.helpers.iter().chain(forces).chain(&spec.outputs);
        Card {
            name: library.name.to_owned(),
            title: spec.title.clone(),
            doc: one_line(&spec.doc),
            source: one_line(&spec.source),
            synonyms: spec.synonyms.clone(),
            ports: spec.ports.iter().map(port).chain(spec.exposed.iter().map(exposed)).collect(),
            connectors: spec.connectors.iter().map(connector).collect(),
            parts: spec.inside.instances.iter().map(|part| self.part(part)).collect(),
            joints: spec.inside.joints.iter().map(|joint| self.joint(joint)).collect(),
            parameters: spec.parameters.iter().map(parameter).collect(),
            inputs: spec.inputs.iter().map(input).collect(),
            modes: modes.map(|mode| [mode.name.value.clone(), one_line(&mode.doc)]).collect(),
            equations: self.equations(spec),
            events: self.events(spec),
            outputs: outputs
                .map(|one| [one.name.value.clone(), one.unit.text.clone(), one_line(&one.doc)])
                .collect(),
            example: library.example,
        }
    }

    fn part(&self, part: &InstanceText) -> [String; 3] {
        let values = part.parameters.iter().map(|(name, value)| {
            let value = match value {
                Value::Number(value) => number(*value),
                Value::Expression(ast) => self.written(ast.span),
            };
            format!("{} = {value}", name.value)
        });
        let inputs = part.inputs.iter();
        let inputs = inputs.map(|(name, of)| format!("{} = {}", name.value, self.formula(of)));
        let given: Vec<String> = values.chain(inputs).collect();
        [part.name.value.clone(), part.unit.value.clone(), given.join(", ")]
    }

    fn joint(&self, joint: &JointSpec) -> [String; 2] {
        let [first, second] = joint.connect.each_ref().map(|port| port.value.clone());
        match &joint.ratio {
            None => [first, second],
            Some(ratio) => [first, format!("({})*{second}", self.formula(ratio))],
        }
    }

    fn equations(&self, spec: &UnitSpec) -> Vec<[String; 4]> {
        let mut equations: Vec<[String; 4]> = Vec::new();
        let mut add = |left: String, right: String, unit: &str, doc: &str| {
            equations.push([left, right, unit.to_owned(), one_line(doc)]);
        };
        let (energy, power) = (&spec.energy, &spec.power);
        let sums = [
            ("T", &energy.kinetic, "J", "kinetic energy"),
            ("V", &energy.potential, "J", "potential energy"),
            ("D", &energy.dissipation, "W", "dissipation: -dD/dq' is a force"),
            ("W", &energy.stored, "J", "energy of the first-order states"),
            ("P_in", &power.supplied, "W", "power supplied to first-order states"),
            ("P_out", &power.dissipated, "W", "power lost, of forces that are marked and states"),
        ];
        for (left, ast, unit, doc) in sums {
            if let Some(ast) = ast {
                add(left.to_owned(), self.written(ast.span), unit, doc);
            }
        }
        for coordinate in spec.coordinates.iter().filter(|coordinate| coordinate.is_fixed) {
            add(coordinate.name.value.clone(), "0".to_owned(), &coordinate.unit.text, "fixed");
        }
        for force in &spec.forces {
            let left = match &force.acts {
                Acts::On(coordinate) => format!("Q({})", coordinate.value),
                Acts::Along(ast) => format!("force along {}", self.written(ast.span)),
            };
            add(left, self.written(force.expression.span), "", &force.doc);
        }
        for state in spec.states.iter().filter(|state| !state.is_mode) {
            let left = format!("{}'", state.name.value);
            add(left, self.written(state.rate.span), &format!("{}/s", state.unit.text), &state.doc);
        }
        for friction in &spec.frictions {
            let limits = friction.limits.iter();
            let limits =
                limits.map(|(case, limit)| format!("{case}: {}", self.written(limit.span)));
            let limits: Vec<String> = limits.collect();
            let (speed, force) = (self.written(friction.speed.span), &friction.force);
            let right = format!("dry friction at the speed {speed}; {}", limits.join("; "));
            add(force.name.value.clone(), right, &force.unit.text, &force.doc);
        }
        for constraint in spec.constraints.iter().filter(|one| one.friction.is_none()) {
            let mut doc = format!("{}: {}", constraint.name.value, constraint.doc);
            for (mode, value) in &constraint.when {
                doc = format!("{doc}, while {} is {value}", mode.value);
            }
            add("0".to_owned(), self.written(constraint.expression.span), "", &doc);
        }
        let is_own = |helper: &&DefinitionSpec| !is_of_friction(spec, &helper.name.value);
        for helper in spec.helpers.iter().filter(is_own).chain(&spec.outputs) {
            let right = self.written(helper.expression.span);
            add(helper.name.value.clone(), right, &helper.unit.text, &helper.doc);
        }
        equations
    }

    fn events(&self, spec: &UnitSpec) -> Vec<[String; 3]> {
        let is_own = |event: &&EventSpec| !is_of_friction(spec, &event.name.value);
        let events = spec.events.iter().filter(is_own).map(|event| {
            let guard = self.written(event.guard.span);
            let passes = match event.direction {
                Direction::Rising => format!("{guard} rises through 0"),
                Direction::Falling => format!("{guard} falls through 0"),
                Direction::Both => format!("{guard} passes 0"),
            };
            let modes = event.when.iter().map(|(mode, value)| format!("{} is {value}", mode.value));
            let modes: Vec<String> = modes.collect();
            let modes = if modes.is_empty() {
                String::new()
            } else {
                format!(", while {}", modes.join(" and "))
            };
            let set = event.set.iter();
            let set = set.map(|(name, value)| format!("{} := {}", name.value, self.formula(value)));
            let set: Vec<String> = set.collect();
            [format!("{passes}{modes}"), set.join(", "), one_line(&event.doc)]
        });
        let of_friction = spec.frictions.iter().map(|friction| {
            let is_event = |name: &&String| spec.events.iter().any(|one| one.name.value == **name);
            let names: Vec<&str> =
                friction.parts.iter().filter(is_event).map(String::as_str).collect();
            let name = &friction.force.name.value;
            [names.join(", "), format!("events of {name}"), String::new()]
        });
        events.chain(of_friction).collect()
    }
}

/// Returns whether a helper or an event follows from a friction.
fn is_of_friction(spec: &UnitSpec, name: &str) -> bool {
    spec.frictions.iter().any(|friction| friction.parts.iter().any(|part| part == name))
}

/// Describes a port of an assembly.
fn exposed(port: &ExposedSpec) -> [String; 3] {
    [port.name.value.clone(), "of a part".to_owned(), port.of.value.clone()]
}

fn connector(connector: &ConnectorSpec) -> [String; 2] {
    let ports: Vec<&str> = connector.ports.iter().map(|port| port.value.as_str()).collect();
    [connector.name.value.clone(), ports.join(", ")]
}

/// Formats a number for reading.
fn number(value: f64) -> String {
    let size = value.abs();
    if value != 0.0 && !(1e-3..1e5).contains(&size) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}

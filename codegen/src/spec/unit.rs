//! Reading of a unit's table into a [`UnitSpec`].

use crate::spec::array;
use crate::spec::body;
use crate::spec::code::Code;
use crate::spec::constraint::constraint;
use crate::spec::diagnostic::{FileId, Mistake, Spanned};
use crate::spec::distributed::{self, AttachmentSpec};
use crate::spec::event;
use crate::spec::fields::{Fields, Findings};
use crate::spec::friction;
use crate::spec::inside::{self, Inside};
use crate::spec::measure::{Measure, UnitError};
use crate::spec::names::{self, did_you_mean, quoted};
use crate::spec::scatter;
use crate::spec::shape;
use crate::spec::toml::{Entry, Tree};
use crate::spec::{
    Acts, ConnectorSpec, CoordinateSpec, DefinitionSpec, EnergySpec, ExposedSpec, ForceSpec,
    InputSpec, ParameterSpec, PortKind, PortSpec, PowerSpec, StateSpec, Symbol, UnitSpec,
};

/// Reads a unit found by `name`. If `whole`, it is a file of its own, which must say so in
/// `[unit]`.
pub fn read(
    tree: &Spanned<Tree>,
    name: &str,
    file: FileId,
    whole: bool,
    found: &mut Findings,
) -> UnitSpec {
    let mut fields = Fields::open(tree, format!("unit {}", quoted(name)), found);
    let header = if whole { fields.require("unit") } else { fields.take("unit") };
    let Header { texts: [title, doc, source], synonyms, symbol } =
        header.map(|tree| self::header(tree, fields.found())).unwrap_or_default();
    let mut coordinates = each(&mut fields, "coordinates", coordinate);
    let distributed = each(&mut fields, "fields", distributed::field);
    let mut frames = each(&mut fields, "frames", body::frame);
    let orientations = each(&mut fields, "orientations", body::orientation);
    let bodies = each(&mut fields, "bodies", body::body);
    let shapes = each(&mut fields, "shapes", shape::shape);
    let gravity = body::vector("gravity", &mut fields);
    let (ports, exposed) = ports(&mut fields);
    for port in ports.iter().filter(|port| port.kind.value == PortKind::Frame) {
        if !frames.iter().any(|frame| frame.name.value == port.name.value) {
            frames.push(body::FrameSpec::joined(&port.name));
        }
    }
    let connectors = connectors(&mut fields);
    for (number, orientation) in orientations.iter().enumerate() {
        coordinates.extend(orientation.coordinates(number));
    }
    coordinates.extend(ports.iter().filter_map(|port| distributed::coordinate(port, &distributed)));
    let parameters = each(&mut fields, "parameters", parameter);
    let inputs = each(&mut fields, "inputs", input);
    let mut helpers = each(&mut fields, "helpers", definition);
    let mut states = states(&mut fields);
    let mut events = each(&mut fields, "events", event::event);
    let mut constraints = each(&mut fields, "constraints", constraint);
    let lists = friction::Lists {
        states: &mut states,
        helpers: &mut helpers,
        constraints: &mut constraints,
        events: &mut events,
    };
    let frictions = friction::all(&mut fields, lists);
    let energy = fields.take("energy").map(|tree| energy(tree, fields.found()));
    let power = fields.take("power").map(|tree| power(tree, fields.found()));
    let forces = fields.list("forces");
    let forces = forces.iter().filter_map(|tree| force(tree, fields.found())).collect();
    let loads = each(&mut fields, "loads", body::load);
    let outputs = each(&mut fields, "outputs", definition);
    let (instances, joints) = inside::parts(&mut fields);
    let [initial, guess] = ["initial", "guess"].map(|key| {
        let entries = fields.entries(key);
        inside::values_by_name(entries, &mut fields)
    });
    fields.close();
    let mut inside = Inside { instances, joints, initial, guess };
    let names = parameters.iter().map(|parameter| &parameter.name);
    let names = names.chain(helpers.iter().map(|helper: &DefinitionSpec| &helper.name));
    array::unroll(&mut inside, &mut Vec::new(), names, found);
    UnitSpec {
        name: name.to_owned(),
        file,
        title,
        doc,
        source,
        synonyms,
        symbol,
        coordinates,
        fields: distributed,
        frames,
        orientations,
        bodies,
        shapes,
        gravity,
        ports,
        exposed,
        connectors,
        parameters,
        inputs,
        helpers,
        states,
        events,
        constraints,
        frictions,
        energy: energy.unwrap_or_default(),
        power: power.unwrap_or_default(),
        forces,
        loads,
        outputs,
        inside,
    }
}

/// Reads every entry of a table of tables.
pub fn each<T>(
    fields: &mut Fields<'_>,
    key: &'static str,
    read: fn(&Entry, &mut Findings) -> Option<T>,
) -> Vec<T> {
    let entries = fields.named(key);
    entries.iter().filter_map(|entry| read(entry, fields.found())).collect()
}

/// The table `[unit]`.
#[derive(Default)]
struct Header {
    /// Title, description and source.
    texts: [String; 3],
    synonyms: Vec<String>,
    symbol: Option<Symbol>,
}

fn header(tree: &Spanned<Tree>, found: &mut Findings) -> Header {
    let mut fields = Fields::open(tree, "[unit]".to_owned(), found);
    fields.name("name");
    let texts = ["title", "doc", "source"].map(|key| fields.text(key));
    let synonyms = fields.texts("synonyms");
    let symbol = fields.take("symbol").and_then(|tree| fields.as_text(tree, "symbol"));
    fields.close();
    Header { texts, synonyms, symbol: symbol.and_then(|name| self::symbol(&name, found)) }
}

fn symbol(name: &Spanned<String>, found: &mut Findings) -> Option<Symbol> {
    match Symbol::of(&name.value) {
        Ok(symbol) => Some(symbol),
        Err(help) => {
            let message = format!("there is no symbol {}", quoted(&name.value));
            found
                .mistakes
                .push(Mistake::new(Code::UnknownName, name.span, message, "unknown").help(help));
            None
        }
    }
}

fn open<'a>(entry: &'a Entry, kind: &str, found: &'a mut Findings) -> Fields<'a> {
    Fields::open(&entry.value, format!("{kind} {}", quoted(&entry.key.value)), found)
}

fn coordinate(entry: &Entry, found: &mut Findings) -> Option<CoordinateSpec> {
    let mut fields = open(entry, "coordinate", found);
    let unit = fields.unit();
    let doc = fields.text("doc");
    let default = |suffix: &str| Spanned {
        value: format!("{}_{suffix}", entry.key.value),
        span: entry.key.span,
    };
    let velocity = fields.name("velocity").unwrap_or_else(|| default("dot"));
    let acceleration = fields.name("acceleration").unwrap_or_else(|| default("ddot"));
    let scale = [fields.scale("scale"), fields.scale("velocity_scale")];
    let is_fixed = fields.flag("fixed");
    fields.close();
    for rate in [&velocity, &acceleration] {
        if let Err(mistake) = names::check(rate) {
            found.mistakes.push(mistake);
        }
    }
    Some(CoordinateSpec {
        name: entry.key.clone(),
        velocity,
        acceleration,
        unit: unit?,
        orientation: None,
        doc,
        scale,
        is_fixed,
    })
}

/// Reads the unit's own ports, and exposed ports of inner instances: `flange = "gear.a"`.
fn ports(fields: &mut Fields<'_>) -> (Vec<PortSpec>, Vec<ExposedSpec>) {
    let (mut ports, mut exposed) = (Vec::new(), Vec::new());
    for entry in fields.named("ports") {
        let Tree::Text { .. } = entry.value.value else {
            ports.extend(port(entry, fields.found()));
            continue;
        };
        let Some(mut of) = fields.as_text(&entry.value, &entry.key.value) else { continue };
        of.value = array::numbered(&of.value);
        if of.value.contains('.') {
            exposed.push(ExposedSpec { name: entry.key.clone(), of });
            continue;
        }
        let message = format!("{} is not a port of a part inside", quoted(&of.value));
        let help = "write \"part.port\"; a port of the unit's own is a table, { kind = \"...\", \
                    coordinate = \"...\" }";
        fields
            .found()
            .mistakes
            .push(Mistake::new(Code::UnknownPort, of.span, message, "not part.port").help(help));
    }
    (ports, exposed)
}

/// Reads `[connectors]`: lists of ports by name.
fn connectors(fields: &mut Fields<'_>) -> Vec<ConnectorSpec> {
    let mut connectors = Vec::new();
    for entry in fields.named("connectors") {
        let Tree::List(items) = &entry.value.value else {
            fields.wrong::<()>(&entry.value, &entry.key.value, "a list of ports");
            continue;
        };
        let ports: Vec<_> =
            items.iter().filter_map(|item| fields.as_text(item, &entry.key.value)).collect();
        if ports.is_empty() {
            let message = format!("connector {} has no ports", quoted(&entry.key.value));
            let mistake = Mistake::new(Code::WrongType, entry.value.span, message, "nothing here");
            fields.found().mistakes.push(mistake);
            continue;
        }
        connectors.push(ConnectorSpec { name: entry.key.clone(), ports });
    }
    connectors
}

fn port(entry: &Entry, found: &mut Findings) -> Option<PortSpec> {
    let mut fields = open(entry, "port", found);
    let kind = fields.required_text("kind");
    let field = fields.take("field").and_then(|tree| fields.as_text(tree, "field"));
    let is_frame = kind.as_ref().is_some_and(|kind| kind.value == PortKind::Frame.name());
    let (coordinate, ratio, attachment) = match field {
        None if is_frame => (Some(entry.key.clone()), None, None),
        None => (fields.required_text("coordinate"), fields.formula("ratio"), None),
        Some(field) => {
            fields.require("at");
            let attachment = fields.formula("at").map(|at| AttachmentSpec { field, at });
            (attachment.is_some().then(|| entry.key.clone()), None, attachment)
        }
    };
    fields.close();
    let kind = kind?;
    let Some((_, value)) = PortKind::ALL.into_iter().find(|(name, _)| *name == kind.value) else {
        let message = format!("unknown kind of port {}", quoted(&kind.value));
        let help = did_you_mean(&kind.value, PortKind::ALL.into_iter().map(|(name, _)| name));
        found
            .mistakes
            .push(Mistake::new(Code::UnknownChoice, kind.span, message, "unknown").help(help));
        return None;
    };
    let kind = Spanned { value, span: kind.span };
    Some(PortSpec { name: entry.key.clone(), kind, coordinate: coordinate?, ratio, attachment })
}

/// Reads a parameter of a unit.
fn parameter(entry: &Entry, found: &mut Findings) -> Option<ParameterSpec> {
    parameter_in(entry, found, Measure::parse_coherent)
}

/// Reads a parameter of a scene, whose unit need not be coherent.
pub fn parameter_of_scene(entry: &Entry, found: &mut Findings) -> Option<ParameterSpec> {
    parameter_in(entry, found, Measure::parse)
}

fn parameter_in(
    entry: &Entry,
    found: &mut Findings,
    read: fn(&str) -> Result<Measure, UnitError>,
) -> Option<ParameterSpec> {
    let mut fields = open(entry, "parameter", found);
    let tree = fields.require("value");
    let read_value = tree.and_then(|tree| scatter::value(&mut fields, tree, "value"));
    let unit = fields.unit_by(read);
    let doc = fields.text("doc");
    let (value, tolerance) = read_value.map(|read| (read.value, read.tolerance)).unzip();
    let spread = scatter::spread(&mut fields, tolerance.flatten());
    fields.close();
    Some(ParameterSpec { name: entry.key.clone(), value: value?, unit: unit?, doc, spread })
}

fn input(entry: &Entry, found: &mut Findings) -> Option<InputSpec> {
    let mut fields = open(entry, "input", found);
    let unit = fields.unit();
    let doc = fields.text("doc");
    fields.close();
    Some(InputSpec { name: entry.key.clone(), unit: unit?, doc })
}

/// Reads a helper or an output of a unit.
pub fn definition(entry: &Entry, found: &mut Findings) -> Option<DefinitionSpec> {
    definition_in(entry, found, Measure::parse_coherent)
}

/// Reads an output of a scene, whose unit need not be coherent.
pub fn output_of_scene(entry: &Entry, found: &mut Findings) -> Option<DefinitionSpec> {
    definition_in(entry, found, Measure::parse)
}

fn definition_in(
    entry: &Entry,
    found: &mut Findings,
    read: fn(&str) -> Result<Measure, UnitError>,
) -> Option<DefinitionSpec> {
    let mut fields = open(entry, "definition", found);
    let expression = fields.required_expression("expression");
    let unit = fields.unit_by(read);
    let doc = fields.text("doc");
    fields.close();
    Some(DefinitionSpec { name: entry.key.clone(), expression: expression?, unit: unit?, doc })
}

/// Reads `[states]` and `[modes]` of a unit or a scene.
pub fn states(fields: &mut Fields<'_>) -> Vec<StateSpec> {
    let mut states = each(fields, "states", state);
    states.extend(each(fields, "modes", event::mode));
    states
}

fn state(entry: &Entry, found: &mut Findings) -> Option<StateSpec> {
    let mut fields = open(entry, "state", found);
    let unit = fields.unit();
    let doc = fields.text("doc");
    let rate = fields.required_expression("rate");
    let initial = fields.formula("initial");
    let scale = fields.scale("scale");
    fields.close();
    Some(StateSpec {
        name: entry.key.clone(),
        unit: unit?,
        doc,
        rate: rate?,
        is_mode: false,
        initial,
        scale,
    })
}

/// Reads `[energy]` of a unit or a scene.
pub fn energy(tree: &Spanned<Tree>, found: &mut Findings) -> EnergySpec {
    let mut fields = Fields::open(tree, "[energy]".to_owned(), found);
    let energy = EnergySpec {
        kinetic: fields.expression("kinetic"),
        potential: fields.expression("potential"),
        dissipation: fields.expression("dissipation"),
        stored: fields.expression("stored"),
    };
    fields.close();
    energy
}

/// Reads `[power]` of a unit or a scene.
pub fn power(tree: &Spanned<Tree>, found: &mut Findings) -> PowerSpec {
    let mut fields = Fields::open(tree, "[power]".to_owned(), found);
    let power = PowerSpec {
        supplied: fields.expression("supplied"),
        dissipated: fields.expression("dissipated"),
    };
    fields.close();
    power
}

fn force(tree: &Spanned<Tree>, found: &mut Findings) -> Option<ForceSpec> {
    let mut fields = Fields::open(tree, "[[forces]]".to_owned(), found);
    let acts = acts("coordinate", &mut fields);
    let expression = fields.required_expression("expression");
    let conversion = fields.flag("conversion");
    let doc = fields.text("doc");
    fields.close();
    Some(ForceSpec { acts: acts?, expression: expression?, conversion, doc })
}

/// Reads the target of a force, under `key` or `along`.
pub fn acts(key: &'static str, fields: &mut Fields<'_>) -> Option<Acts> {
    let Some(along) = fields.take("along") else {
        return fields.required_text(key).map(Acts::On);
    };
    if fields.take(key).is_some() {
        let message = format!("a force has `{key}` or `along`, not both");
        fields.found().mistakes.push(Mistake::new(
            Code::ConflictingKeys,
            along.span,
            message,
            "besides",
        ));
    }
    fields.as_expression(along, "along").map(Acts::Along)
}

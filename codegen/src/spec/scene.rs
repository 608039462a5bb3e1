//! A scene's table to plain data, before its units are looked for.

use crate::spec::array;
use crate::spec::check::check;
use crate::spec::constraint::constraint;
use crate::spec::diagnostic::{FileId, Mistake, Span, Spanned};
use crate::spec::distributed;
use crate::spec::event;
use crate::spec::expression::Ast;
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::{self, did_you_mean, quoted};
use crate::spec::toml::{Entry, Tree};
use crate::spec::unit::{self, each};
use crate::spec::{
    CheckSpec, ConstraintSpec, DefinitionSpec, DiscretisationSpec, EnergySpec, EventSpec, Formula,
    JointSpec, OutputSpec, ParameterSpec, PortForceSpec, RunSpec, UnitSpec, Value,
};

/// Methods a spec may name.
pub const METHODS: &[&str] = &[
    "bdf", "tr_bdf2", "esdirk34", "tsit45", "tsit5", "dop853", "rodas5p", "radau", "auto",
    "taylor", "exact",
];

/// Output times a run may have.
const MAX_POINTS: f64 = 1e7;
/// Relative tolerances a run may ask for.
const RTOL: std::ops::RangeInclusive<f64> = 1e-14..=0.1;

/// A scene whose units are only named.
#[derive(Debug)]
pub struct SceneText {
    pub header: Option<Header>,
    pub define: Vec<UnitSpec>,
    pub instances: Vec<InstanceText>,
    pub joints: Vec<JointSpec>,
    pub parameters: Vec<ParameterSpec>,
    pub helpers: Vec<DefinitionSpec>,
    pub energy: EnergySpec,
    pub forces: Vec<PortForceSpec>,
    pub events: Vec<EventSpec>,
    pub constraints: Vec<ConstraintSpec>,
    pub initial: Vec<(Spanned<String>, Formula)>,
    pub starts_in_equilibrium: bool,
    pub guess: Vec<(Spanned<String>, Formula)>,
    pub outputs: Vec<OutputSpec>,
    pub checks: Vec<CheckSpec>,
    pub tunable: Option<Vec<Spanned<String>>>,
    pub rigid: Vec<Spanned<String>>,
    pub freeze_tolerance: f64,
    pub run: Option<RunSpec>,
}

/// What `[scene]` says.
#[derive(Debug)]
pub struct Header {
    pub name: Spanned<String>,
    pub title: String,
    pub doc: String,
    pub source: String,
}

/// An instance whose unit is only named.
#[derive(Debug)]
pub struct InstanceText {
    pub name: Spanned<String>,
    pub unit: Spanned<String>,
    /// Of a row of instances, how many.
    pub count: Option<Spanned<i64>>,
    pub parameters: Vec<(Spanned<String>, Value)>,
    pub inputs: Vec<(Spanned<String>, Formula)>,
    pub fields: Vec<DiscretisationSpec>,
}

/// Reads a scene.
pub fn read(tree: &Spanned<Tree>, file: FileId, found: &mut Findings) -> SceneText {
    let mut fields = Fields::open(tree, "the scene".to_owned(), found);
    let header = fields.require("scene").and_then(|tree| header(tree, fields.found()));
    let defined = fields.named("define");
    let define = defined
        .iter()
        .map(|entry| unit::read(&entry.value, &entry.key.value, file, false, fields.found()));
    let define = define.collect();
    fields.require("units");
    let instances = each(&mut fields, "units", instance);
    let joints = fields.list("joints");
    let joints = joints.iter().filter_map(|tree| joint(tree, fields.found())).collect();
    let parameters = each(&mut fields, "parameters", unit::parameter_of_scene);
    let helpers = each(&mut fields, "helpers", unit::definition);
    let energy = fields.take("energy").map(|tree| unit::energy(tree, fields.found()));
    let forces = fields.list("forces");
    let forces = forces.iter().filter_map(|tree| force(tree, fields.found())).collect();
    let events = each(&mut fields, "events", event::event);
    let constraints = each(&mut fields, "constraints", constraint);
    let initial = fields.entries("initial");
    let starts_in_equilibrium = starts_in_equilibrium(initial, &mut fields);
    let initial = values_by_name(initial.iter().filter(|entry| !is_from(entry)), &mut fields);
    let guess = fields.entries("guess");
    let guess = values_by_name(guess, &mut fields);
    let outputs = each(&mut fields, "outputs", output);
    let checks = each(&mut fields, "checks", check);
    let tunable = fields.take("tunable").map(|tree| tunable(tree, fields.found()));
    let freeze = fields.take("freeze").map(|tree| freeze(tree, fields.found()));
    let (rigid, freeze_tolerance) = freeze.unwrap_or_default();
    let run = fields.require("run").and_then(|tree| run(tree, fields.found()));
    fields.close();
    let mut scene = SceneText {
        header,
        define,
        instances,
        joints,
        parameters,
        helpers,
        energy: energy.unwrap_or_default(),
        forces,
        events,
        constraints,
        initial,
        starts_in_equilibrium,
        guess,
        outputs,
        checks,
        tunable,
        rigid,
        freeze_tolerance,
        run,
    };
    array::unroll(&mut scene, found);
    scene
}

fn header(tree: &Spanned<Tree>, found: &mut Findings) -> Option<Header> {
    let mut fields = Fields::open(tree, "[scene]".to_owned(), found);
    let present = fields.require("name").is_some();
    let name = fields.name("name");
    if let Some(Err(mistake)) = name.as_ref().map(names::check_scene) {
        fields.found().mistakes.push(mistake);
    }
    let [title, doc, source] = ["title", "doc", "source"].map(|key| fields.text(key));
    fields.close();
    let name = name.filter(|_| present)?;
    let title = if title.is_empty() { name.value.replace('_', " ") } else { title };
    Some(Header { name, title, doc, source })
}

fn instance(entry: &Entry, found: &mut Findings) -> Option<InstanceText> {
    let what = format!("instance {}", quoted(&entry.key.value));
    let mut fields = Fields::open(&entry.value, what, found);
    let unit = fields.required_text("unit");
    let count = fields.number("count").and_then(|count| {
        if count.value.fract() == 0.0 && (1.0..=array::MOST).contains(&count.value) {
            return Some(Spanned { value: count.value as i64, span: count.span });
        }
        let message = format!("`count` is a whole number from 1 to {}", array::MOST);
        fields.found().mistakes.push(Mistake::new(count.span, message, "out of range"));
        None
    });
    let unit = unit.filter(|unit| match check_unit_path(unit) {
        Ok(()) => true,
        Err(mistake) => {
            fields.found().mistakes.push(mistake);
            false
        }
    });
    let overrides = fields.entries("parameters");
    let parameters = overrides.iter().filter_map(|entry| {
        let value = fields.as_value(&entry.value, &entry.key.value)?;
        Some((entry.key.clone(), value))
    });
    let parameters = parameters.collect();
    let bindings = fields.entries("inputs");
    let inputs = bindings.iter().filter_map(|entry| {
        let formula = fields.as_formula(&entry.value, &entry.key.value)?;
        Some((entry.key.clone(), formula))
    });
    let inputs = inputs.collect();
    let choices = each(&mut fields, "fields", distributed::discretisation);
    fields.close();
    let name = entry.key.clone();
    Some(InstanceText { name, unit: unit?, count, parameters, inputs, fields: choices })
}

/// `inertia`, or `rotational/inertia` of a folder: names with slashes between them.
fn check_unit_path(unit: &Spanned<String>) -> Result<(), Mistake> {
    let names = unit.value.split('/');
    names
        .map(|part| Spanned { value: part.to_owned(), span: unit.span })
        .try_for_each(|part| names::check(&part))
}

fn joint(tree: &Spanned<Tree>, found: &mut Findings) -> Option<JointSpec> {
    let mut fields = Fields::open(tree, "[[joints]]".to_owned(), found);
    let connect = fields.require("connect").and_then(|list| ports(list, &mut fields));
    let ratio = fields.formula("ratio");
    fields.close();
    Some(JointSpec { connect: connect?, ratio })
}

fn ports(tree: &Spanned<Tree>, fields: &mut Fields<'_>) -> Option<[Spanned<String>; 2]> {
    let Tree::List(items) = &tree.value else {
        return fields.wrong(tree, "connect", "a list of two ports");
    };
    let [first, second] = items.as_slice() else {
        let mistake = Mistake::new(tree.span, "a joint connects two ports", "not two");
        fields.found().mistakes.push(mistake.help("write connect = [\"a.port\", \"b.port\"]"));
        return None;
    };
    Some([fields.as_text(first, "connect")?, fields.as_text(second, "connect")?])
}

fn force(tree: &Spanned<Tree>, found: &mut Findings) -> Option<PortForceSpec> {
    let mut fields = Fields::open(tree, "[[forces]]".to_owned(), found);
    let port = fields.required_text("port");
    let expression = fields.required_expression("expression");
    let doc = fields.text("doc");
    fields.close();
    Some(PortForceSpec { port: port?, expression: expression?, doc })
}

/// The key of `[initial]` that is no name of a quantity.
pub const FROM: &str = "from";
/// What it may say.
pub const EQUILIBRIUM: &str = "equilibrium";

/// Whether `[initial]` says `from = "equilibrium"`.
fn starts_in_equilibrium(initial: &[Entry], fields: &mut Fields<'_>) -> bool {
    let Some(Entry { value, .. }) = initial.iter().find(|entry| is_from(entry)) else {
        return false;
    };
    let found = fields.as_text(value, FROM);
    if let Some(text) = &found
        && text.value != EQUILIBRIUM
    {
        let message = format!("a start is `{FROM} = \"{EQUILIBRIUM}\"`, or values alone");
        let mistake = Mistake::new(text.span, message, "no such start");
        let help = did_you_mean(&text.value, std::iter::once(EQUILIBRIUM));
        fields.found().mistakes.push(mistake.help(help));
    }
    found.is_some()
}

/// Not the values of an instance of that name, `from.angle = 0`.
fn is_from(entry: &Entry) -> bool {
    entry.key.value == FROM && !matches!(entry.value.value, Tree::Table(_))
}

/// Both `"motor.angle" = 0` and `motor.angle = 0`, which TOML takes for a table.
pub fn values_by_name<'a>(
    entries: impl IntoIterator<Item = &'a Entry>,
    fields: &mut Fields<'_>,
) -> Vec<(Spanned<String>, Formula)> {
    let mut values = Vec::new();
    for Entry { key, value } in entries {
        let Tree::Table(inner) = &value.value else {
            values.extend(fields.as_formula(value, &key.value).map(|value| (key.clone(), value)));
            continue;
        };
        for entry in inner {
            let path = format!("{}.{}", key.value, entry.key.value);
            let name = Spanned { value: path, span: entry.key.span };
            let formula = fields.as_formula(&entry.value, &entry.key.value);
            values.extend(formula.map(|value| (name, value)));
        }
    }
    values
}

fn output(entry: &Entry, found: &mut Findings) -> Option<OutputSpec> {
    if entry.key.value == "time" {
        let message = "an output cannot be called `time`: that is the first column of results";
        let mistake = Mistake::new(entry.key.span, message, "taken");
        found.mistakes.push(mistake.help("choose another name"));
    }
    if let Tree::Table(_) = entry.value.value {
        return unit::output_of_scene(entry, found).map(OutputSpec::Definition);
    }
    let mut fields = Fields::alone(entry.value.span, found);
    let of: Option<Ast> = fields.as_expression(&entry.value, &entry.key.value);
    Some(OutputSpec::Alias { name: entry.key.clone(), of: of? })
}

fn tunable(tree: &Spanned<Tree>, found: &mut Findings) -> Vec<Spanned<String>> {
    let mut fields = Fields::open(tree, "[tunable]".to_owned(), found);
    let names = required_names("parameters", &mut fields);
    fields.close();
    names
}

/// Instances to be taken for rigid, and the error allowed for it.
fn freeze(tree: &Spanned<Tree>, found: &mut Findings) -> (Vec<Spanned<String>>, f64) {
    let mut fields = Fields::open(tree, "[freeze]".to_owned(), found);
    let rigid = required_names("rigid", &mut fields);
    let tolerance = fields.required_number("tolerance");
    fields.close();
    if let Some(tolerance) = &tolerance
        && !(tolerance.value > 0.0 && tolerance.value <= 1.0)
    {
        let message = "`tolerance` is an error relative to an output, above 0 and at most 1";
        found.mistakes.push(Mistake::new(tolerance.span, message, "out of range"));
    }
    (rigid, tolerance.map_or(0.0, |tolerance| tolerance.value))
}

fn required_names(key: &'static str, fields: &mut Fields<'_>) -> Vec<Spanned<String>> {
    match fields.require(key) {
        None => Vec::new(),
        Some(Spanned { value: Tree::List(items), .. }) => {
            items.iter().filter_map(|item| fields.as_text(item, key)).collect()
        }
        Some(tree) => fields.wrong(tree, key, "a list of names").unwrap_or_default(),
    }
}

fn run(tree: &Spanned<Tree>, found: &mut Findings) -> Option<RunSpec> {
    let mut fields = Fields::open(tree, "[run]".to_owned(), found);
    let from = fields.formula("from");
    fields.require("until");
    let until = fields.formula("until");
    let points = fields.required_number("points");
    let rtol = fields.required_number("rtol");
    let method = fields.required_text("method");
    fields.close();
    let mut refuse = |good: bool, span: Span, message: &str, label: &str, help: String| {
        if !good {
            found.mistakes.push(Mistake::new(span, message, label).help(help));
        }
    };
    // Each by itself, whether the others are there or not.
    if let Some(points) = &points {
        let whole = points.value.fract() == 0.0 && (2.0..=MAX_POINTS).contains(&points.value);
        let message = "`points` is an integer from 2 to 10 000 000";
        refuse(whole, points.span, message, "out of range", String::new());
    }
    if let Some(rtol) = &rtol {
        let message = "`rtol` lies between 1e-14 and 0.1";
        refuse(RTOL.contains(&rtol.value), rtol.span, message, "out of range", String::new());
    }
    if let Some(method) = &method {
        let known = METHODS.contains(&method.value.as_str());
        let help = did_you_mean(&method.value, METHODS.iter().copied());
        refuse(known, method.span, "unknown method", "unknown", help);
    }
    let (until, points, rtol, method) = (until?, points?, rtol?, method?);
    let (points, rtol) = (points.value as usize, rtol.value);
    Some(RunSpec { from, until, points, rtol, method: method.value })
}

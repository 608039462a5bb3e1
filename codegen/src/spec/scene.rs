//! Reading of a scene's table into plain data, before its units are searched.

use crate::spec::array;
use crate::spec::check::check;
use crate::spec::code::Code;
use crate::spec::constraint::constraint;
use crate::spec::diagnostic::{FileId, Mistake, Span, Spanned};
use crate::spec::event;
use crate::spec::expression::Ast;
use crate::spec::fields::{Fields, Findings};
use crate::spec::friction;
use crate::spec::inside::{self, Inside, values_by_name};
use crate::spec::names::{self, did_you_mean};
use crate::spec::scatter::{self, CorrelationSpec};
use crate::spec::spread::Spread;
use crate::spec::toml::{Entry, Tree};
use crate::spec::unit::{self, each};
use crate::spec::{
    CheckSpec, ConstraintSpec, DefinitionSpec, EnergySpec, EventSpec, Formula, FrictionSpec,
    OutputSpec, ParameterSpec, PortForceSpec, PowerSpec, RunSpec, SamplingSpec, StateSpec,
    UnitSpec,
};

/// Methods that a spec may name.
pub const METHODS: &[&str] = &[
    "bdf", "tr_bdf2", "esdirk34", "tsit45", "tsit5", "dop853", "rodas5p", "radau", "auto",
    "taylor", "exact",
];

/// Maximum number of output times of a run.
const MAX_POINTS: f64 = 1e7;
/// Relative tolerances that a run may request.
const RTOL: std::ops::RangeInclusive<f64> = 1e-14..=0.1;

/// Default number of output times.
const DEFAULT_POINTS: usize = 201;
/// Default relative tolerance.
const DEFAULT_RTOL: f64 = 1e-6;
/// Default method.
const DEFAULT_METHOD: &str = "auto";

/// A scene whose units are only named.
#[derive(Debug)]
pub struct SceneText {
    pub header: Option<Header>,
    pub define: Vec<UnitSpec>,
    pub inside: Inside,
    pub parameters: Vec<ParameterSpec>,
    pub scatter: Vec<(Spanned<String>, Spanned<Spread>)>,
    pub correlations: Vec<CorrelationSpec>,
    pub helpers: Vec<DefinitionSpec>,
    pub states: Vec<StateSpec>,
    pub energy: EnergySpec,
    pub power: PowerSpec,
    pub forces: Vec<PortForceSpec>,
    pub events: Vec<EventSpec>,
    pub constraints: Vec<ConstraintSpec>,
    pub frictions: Vec<FrictionSpec>,
    pub starts_in_equilibrium: bool,
    pub outputs: Vec<OutputSpec>,
    pub checks: Vec<CheckSpec>,
    pub tunable: Option<Vec<Spanned<String>>>,
    pub rigid: Vec<Spanned<String>>,
    pub freeze_tolerance: f64,
    pub run: Option<RunSpec>,
}

/// Contents of `[scene]`.
#[derive(Debug)]
pub struct Header {
    pub name: Spanned<String>,
    pub title: String,
    pub doc: String,
    pub source: String,
    pub shares_redundant: bool,
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
    let (instances, joints) = inside::parts(&mut fields);
    let parameters = each(&mut fields, "parameters", unit::parameter_of_scene);
    let scatter = scatter::overlay(&mut fields);
    let correlations = scatter::correlations(&mut fields);
    let mut helpers = each(&mut fields, "helpers", unit::definition);
    let mut states = unit::states(&mut fields);
    let energy = fields.take("energy").map(|tree| unit::energy(tree, fields.found()));
    let power = fields.take("power").map(|tree| unit::power(tree, fields.found()));
    let forces = fields.list("forces");
    let forces = forces.iter().filter_map(|tree| force(tree, fields.found())).collect();
    let mut events = each(&mut fields, "events", event::event);
    let mut constraints = each(&mut fields, "constraints", constraint);
    let lists = friction::Lists {
        states: &mut states,
        helpers: &mut helpers,
        constraints: &mut constraints,
        events: &mut events,
    };
    let frictions = friction::all(&mut fields, lists);
    let initial = fields.entries("initial");
    let starts_in_equilibrium = starts_in_equilibrium(initial, &mut fields);
    let initial = values_by_name(initial.iter().filter(|entry| !is_from(entry)), &mut fields);
    let guess = values_by_name(fields.entries("guess"), &mut fields);
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
        inside: Inside { instances, joints, initial, guess },
        parameters,
        scatter,
        correlations,
        helpers,
        states,
        energy: energy.unwrap_or_default(),
        power: power.unwrap_or_default(),
        forces,
        events,
        constraints,
        frictions,
        starts_in_equilibrium,
        outputs,
        checks,
        tunable,
        rigid,
        freeze_tolerance,
        run,
    };
    let names = scene.parameters.iter().map(|parameter| &parameter.name);
    let names = names.chain(scene.helpers.iter().map(|helper| &helper.name));
    let names = names.chain(scene.states.iter().map(|state| &state.name));
    array::unroll(&mut scene.inside, &mut scene.forces, names, found);
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
    let shares_redundant = fields.flag("share_redundant");
    fields.close();
    let name = name.filter(|_| present)?;
    let title = if title.is_empty() { name.value.replace('_', " ") } else { title };
    Some(Header { name, title, doc, source, shares_redundant })
}

fn force(tree: &Spanned<Tree>, found: &mut Findings) -> Option<PortForceSpec> {
    let mut fields = Fields::open(tree, "[[forces]]".to_owned(), found);
    let acts = unit::acts("port", &mut fields);
    let expression = fields.required_expression("expression");
    let doc = fields.text("doc");
    fields.close();
    Some(PortForceSpec { acts: acts?, expression: expression?, doc })
}

/// The only key of `[initial]` that is not the name of a quantity.
pub const FROM: &str = "from";
/// The only value of that key.
pub const EQUILIBRIUM: &str = "equilibrium";

/// Reports whether `[initial]` contains `from = "equilibrium"`.
fn starts_in_equilibrium(initial: &[Entry], fields: &mut Fields<'_>) -> bool {
    let Some(Entry { value, .. }) = initial.iter().find(|entry| is_from(entry)) else {
        return false;
    };
    let found = fields.as_text(value, FROM);
    if let Some(text) = &found
        && text.value != EQUILIBRIUM
    {
        let message = format!("a start is `{FROM} = \"{EQUILIBRIUM}\"`, or values alone");
        let mistake = Mistake::new(Code::UnknownChoice, text.span, message, "no such start");
        let help = did_you_mean(&text.value, std::iter::once(EQUILIBRIUM));
        fields.found().mistakes.push(mistake.help(help));
    }
    found.is_some()
}

/// Distinguishes the key from values of an instance of the same name, `from.angle = 0`.
fn is_from(entry: &Entry) -> bool {
    entry.key.value == FROM && !matches!(entry.value.value, Tree::Table(_))
}

fn output(entry: &Entry, found: &mut Findings) -> Option<OutputSpec> {
    if entry.key.value == "time" {
        let message = "an output cannot be called `time`: that is the first column of results";
        let mistake = Mistake::new(Code::InvalidName, entry.key.span, message, "taken");
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

/// Reads the instances that are approximated as rigid, and the error this may cause.
fn freeze(tree: &Spanned<Tree>, found: &mut Findings) -> (Vec<Spanned<String>>, f64) {
    let mut fields = Fields::open(tree, "[freeze]".to_owned(), found);
    let rigid = required_names("rigid", &mut fields);
    let tolerance = fields.required_number("tolerance");
    fields.close();
    if let Some(tolerance) = &tolerance
        && !(tolerance.value > 0.0 && tolerance.value <= 1.0)
    {
        let message = "`tolerance` is a relative error and must be above 0 and at most 1";
        found.mistakes.push(Mistake::new(
            Code::OutOfRange,
            tolerance.span,
            message,
            "out of range",
        ));
    }
    (rigid, tolerance.map_or(0.0, |tolerance| tolerance.value))
}

fn required_names(key: &'static str, fields: &mut Fields<'_>) -> Vec<Spanned<String>> {
    match fields.require(key) {
        None => Vec::new(),
        Some(Spanned { value: Tree::List(items), .. }) => {
            let names = items.iter().filter_map(|item| fields.as_text(item, key));
            let numbered = |name: Spanned<String>| Spanned {
                value: array::numbered(&name.value),
                span: name.span,
            };
            names.map(numbered).collect()
        }
        Some(tree) => fields.wrong(tree, key, "a list of names").unwrap_or_default(),
    }
}

fn run(tree: &Spanned<Tree>, found: &mut Findings) -> Option<RunSpec> {
    let mut fields = Fields::open(tree, "[run]".to_owned(), found);
    let from = fields.formula("from");
    let (until, sampling) = sampling(&mut fields);
    let rtol = fields.number("rtol");
    let method = fields.take("method").and_then(|tree| fields.as_text(tree, "method"));
    fields.close();
    let mut refuse = |good: bool, span: Span, message: &str, label: &str, help: String| {
        if !good {
            found.mistakes.push(Mistake::new(Code::InvalidRun, span, message, label).help(help));
        }
    };
    // Each is checked by itself, whether the others are present or not.
    if let Some(rtol) = &rtol {
        let message = "`rtol` must be between 1e-14 and 0.1";
        refuse(RTOL.contains(&rtol.value), rtol.span, message, "out of range", String::new());
    }
    if let Some(method) = &method {
        let known = METHODS.contains(&method.value.as_str());
        let help = did_you_mean(&method.value, METHODS.iter().copied());
        refuse(known, method.span, "unknown method", "unknown", help);
    }
    let rtol = rtol.map_or(DEFAULT_RTOL, |rtol| rtol.value);
    let method = method.map_or_else(|| DEFAULT_METHOD.to_owned(), |method| method.value);
    Some(RunSpec { from, until, sampling: sampling?, rtol, method })
}

/// Spacings of output times, by name.
pub const SPACINGS: &[&str] = &["even", "log"];

/// Reads `times`; or `until` and `points`, with `spacing` and `first`.
fn sampling(fields: &mut Fields<'_>) -> (Option<Formula>, Option<SamplingSpec>) {
    if let Some(tree) = fields.take("times") {
        for key in ["until", "points", "spacing", "first"] {
            if let Some(other) = fields.take(key) {
                let message = format!("a run has `times` or `{key}`, not both");
                let mistake =
                    Mistake::new(Code::ConflictingKeys, other.span, message, "besides `times`");
                fields.found().mistakes.push(mistake.help("a run ends at the last of its times"));
            }
        }
        let Tree::List(items) = &tree.value else {
            return (None, fields.wrong(tree, "times", "a list of times"));
        };
        if !(2..=MAX_POINTS as usize).contains(&items.len()) {
            let message = "`times` must have 2 to 10 000 000 entries";
            fields.found().mistakes.push(Mistake::new(
                Code::OutOfRange,
                tree.span,
                message,
                "out of range",
            ));
        }
        let times = items.iter().filter_map(|item| fields.as_formula(item, "times")).collect();
        return (None, Some(SamplingSpec::Listed(times)));
    }
    fields.require("until");
    let until = fields.formula("until");
    let points = fields.number("points");
    let spacing = fields.take("spacing").and_then(|tree| fields.as_text(tree, "spacing"));
    let is_log = spacing.as_ref().is_some_and(|spacing| spacing.value == "log");
    if let Some(spacing) = &spacing
        && !SPACINGS.contains(&spacing.value.as_str())
    {
        let help = did_you_mean(&spacing.value, SPACINGS.iter().copied());
        let mistake = Mistake::new(Code::UnknownChoice, spacing.span, "unknown spacing", "unknown")
            .help(help);
        fields.found().mistakes.push(mistake);
    }
    let first = fields.formula("first");
    match (&first, &spacing) {
        (None, Some(spacing)) if is_log => {
            let message = "logarithmic spacing needs `first`, the first time after the start";
            let mistake =
                Mistake::new(Code::MissingKey, spacing.span, message, "`first` is missing");
            fields.found().mistakes.push(mistake.help("write first = 1e-3, in s"));
        }
        (Some(first), _) if !is_log => {
            let message = "`first` is used only with logarithmic spacing";
            let mistake = Mistake::new(Code::NoEffect, first.span(), message, "unused");
            fields.found().mistakes.push(mistake.help("write spacing = \"log\" too"));
        }
        _ => {}
    }
    let least = if is_log { 3.0 } else { 2.0 };
    if let Some(points) = &points
        && !(points.value.fract() == 0.0 && (least..=MAX_POINTS).contains(&points.value))
    {
        let message = format!("`points` must be an integer from {least} to 10 000 000");
        fields.found().mistakes.push(Mistake::new(
            Code::OutOfRange,
            points.span,
            message,
            "out of range",
        ));
    }
    let points = points.map_or(DEFAULT_POINTS, |points| points.value as usize);
    let sampling = match first {
        Some(first) => SamplingSpec::Ratios(points, first),
        None => SamplingSpec::Even(points),
    };
    (until, Some(sampling))
}

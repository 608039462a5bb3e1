//! The functions of the table, one for each tape, and those that precede them.

use machinist_model::functions::{FunctionId, FunctionRow, Gives, Reads};
use machinist_model::{SparsityPattern, operations};

use super::Scene;
use super::body::{self, Body, body};
use super::layout::{comment, remark, statement, statements};
use super::solve;
use crate::emit::EmitError;

/// A function: meaning, head without a semicolon, and body.
pub(super) struct Emitted {
    pub(super) doc: String,
    pub(super) head: String,
    pub(super) body: String,
    /// True if it is local to the source file.
    pub(super) is_local: bool,
}

impl Emitted {
    /// Returns its declaration, with its meaning.
    pub(super) fn declaration(&self) -> String {
        format!("{}{};\n", comment([&self.doc]), self.head)
    }

    /// Returns its definition, with its meaning if no declaration has it.
    pub(super) fn definition(&self) -> String {
        let doc = if self.is_local { comment([&self.doc]) } else { String::new() };
        format!("{doc}{}\n{{\n{}}}\n", self.head, self.body)
    }
}

/// Returns the first arguments of every function of time and state.
pub(super) fn arguments(scene: &Scene<'_>) -> String {
    format!(
        "{} time, const {} *state, const {} *p, const {} *c",
        scene.real(),
        scene.public("state_t"),
        scene.public("parameters_t"),
        scene.public("constants_t")
    )
}

/// Returns all functions, in an order in which they can be defined.
pub(super) fn functions(scene: &Scene<'_>) -> Result<Vec<Emitted>, EmitError> {
    let mut functions = vec![defaults(scene)?, prepare(scene)];
    functions.extend(scene.motion.as_ref().map(|motion| solve::function(scene, motion)));
    for row in scene.model.functions() {
        if (row.results)(scene.model) > 0 {
            functions.push(function(scene, row)?);
        }
    }
    Ok(functions)
}

/// Returns the function that sets the parameters of the spec.
fn defaults(scene: &Scene<'_>) -> Result<Emitted, EmitError> {
    let mut body = String::new();
    for (parameter, member) in scene.model.parameters.iter().zip(&scene.parameter_members) {
        let value = scene.options.real.literal(parameter.value);
        let value = value.ok_or_else(|| EmitError::NotFinite {
            place: format!("parameter `{}`", parameter.quantity.name.path),
            value: parameter.value,
        })?;
        body.push_str(&statement(&format!("p->{member} = {value};"), 4));
    }
    if body.is_empty() {
        body.push_str("    p->none = 0;\n");
    }
    let (name, parameters) = (scene.public("default_parameters"), scene.public("parameters_t"));
    Ok(Emitted {
        doc: "Sets all parameters to the values of the spec.".to_owned(),
        head: format!("void {name}({parameters} *p)"),
        body,
        is_local: false,
    })
}

/// Returns the function that computes the constants.
fn prepare(scene: &Scene<'_>) -> Emitted {
    let mut body = statements(&scene.prepare);
    for name in &scene.constants {
        body.push_str(&statement(&format!("c->{name} = {name};"), 4));
    }
    if scene.constants.is_empty() {
        body.push_str("    (void)p;\n    c->none = 0;\n");
    }
    let (name, count) = (scene.public("prepare"), scene.hoisted.operations());
    let [parameters, constants] = ["parameters_t", "constants_t"].map(|name| scene.public(name));
    Emitted {
        doc: format!(
            "Computes what parameters alone decide: call it whenever parameters have changed. {}",
            counted(count)
        ),
        head: format!("void {name}(const {parameters} *p, {constants} *c)"),
        body,
        is_local: false,
    }
}

/// Returns the function of a row.
fn function(scene: &Scene<'_>, row: &FunctionRow) -> Result<Emitted, EmitError> {
    let tape = scene.hoisted.tape(scene.model, row.id);
    let solved = scene.model.solve(row.id);
    let body = body(tape, &scene.scope(row.name), false)?;
    let reads_motion = body.reads.motion || solved.is_some();
    let mut text = opening(scene, row, &body.reads, reads_motion);
    if let (Some(of), Some(matrix)) = (solved, row.matrix) {
        let pattern = &matrix(scene.model).pattern;
        text.push_str(&statements(&body.statements));
        text.push_str(&solve::call(scene, row.name, of, pattern, &body.results));
    } else {
        text.push_str(&computation(&places(scene, row), &body, row.matrix.is_some()));
    }
    let (name, out) = (scene.public(row.name), out(scene, row));
    let head = match row.reads {
        Reads::Motion => format!("void {name}({}, {out})", arguments(scene)),
        Reads::Parameters => {
            format!("void {name}(const {} *p, {out})", scene.public("parameters_t"))
        }
    };
    let doc = format!("{} {}", plain(row.doc), counted(operations(tape)));
    Ok(Emitted { doc, head: broken_head(&head), body: text, is_local: false })
}

/// Returns the statements of a body and of its results, those of a matrix as soon as they are
/// computed: compilers keep fewer values, and compute them side by side.
fn computation(places: &[(String, String)], body: &Body, is_matrix: bool) -> String {
    let write = |((place, remark), result): (&(String, String), &String)| {
        let line = statement(&format!("{place} = {result};"), 4);
        let is_short = line.lines().count() == 1 && line.len() + remark.len() < 100;
        if is_short && !remark.is_empty() {
            format!("{} {remark}\n", line.trim_end())
        } else {
            line
        }
    };
    let mut early = vec![String::new(); body.statements.len()];
    let mut rest = String::new();
    for (result, &after) in places.iter().zip(&body.results).zip(&body.after) {
        let stored = if is_matrix && after > 0 { &mut early[after - 1] } else { &mut rest };
        stored.push_str(&write(result));
    }
    let mut text = String::new();
    for (line, stored) in body.statements.iter().zip(&early) {
        text.push_str(&statement(line, 4));
        text.push_str(stored);
    }
    text.push_str(&rest);
    text
}

/// Returns variables for the entries of the state that are read, and marks unread arguments.
fn opening(
    scene: &Scene<'_>,
    row: &FunctionRow,
    reads: &body::Reads,
    reads_motion: bool,
) -> String {
    let mut text = state_variables(scene, reads);
    let of_motion = row.reads == Reads::Motion;
    if reads_motion {
        text.push_str("    struct motion m;\n");
    }
    if !reads_motion {
        text.push_str(&unread([
            ("time", of_motion && !reads.time),
            ("state", of_motion && reads.state.is_empty()),
            ("p", !reads.parameters),
            ("c", of_motion && !reads.constants),
        ]));
    }
    if reads_motion {
        text.push_str("    motion(time, state, p, c, &m);\n");
    }
    text
}

/// Returns variables for the entries of the state that a body reads.
pub(super) fn state_variables(scene: &Scene<'_>, reads: &body::Reads) -> String {
    let variable = |&entry: &usize| {
        let (name, member) = (&scene.states[entry], &scene.state_members[entry]);
        statement(&format!("const {} {name} = state->{member};", scene.real()), 4)
    };
    reads.state.iter().map(variable).collect()
}

/// Mentions arguments that a body does not read, to avoid compiler warnings.
pub(super) fn unread(arguments: [(&str, bool); 4]) -> String {
    let unread = arguments.into_iter().filter(|(_, is_unread)| *is_unread);
    unread.map(|(name, _)| statement(&format!("(void){name};"), 4)).collect()
}

/// Returns the last argument of a function, which takes its result.
fn out(scene: &Scene<'_>, row: &FunctionRow) -> String {
    let real = scene.real();
    match row.gives {
        Gives::Numbers("STATES") => format!("{} *values", scene.public("state_t")),
        Gives::Numbers(length) => format!("{real} values[{}]", scene.macro_name(length)),
        Gives::Matrix(_) => format!("{real} values[{}]", nonzeros(scene, row.name)),
        Gives::Record(..) => format!("{} *values", scene.public("outputs_t")),
        Gives::Structure(..) => {
            format!("{} *values", scene.public(&format!("{}_t", row.name)))
        }
    }
}

/// Returns the macro for the number of nonzeros of a matrix.
pub(super) fn nonzeros(scene: &Scene<'_>, name: &str) -> String {
    scene.macro_name(&format!("{}_NONZEROS", name.to_ascii_uppercase()))
}

/// Returns the place of each result, and a remark on it.
fn places(scene: &Scene<'_>, row: &FunctionRow) -> Vec<(String, String)> {
    let members = |names: &[String]| {
        names.iter().map(|name| (format!("values->{name}"), String::new())).collect()
    };
    let entries = |names: Vec<String>| {
        let names = names.into_iter().enumerate();
        names
            .map(|(index, name)| {
                let remark = if name.is_empty() { String::new() } else { remark(&name) };
                (format!("values[{index}]"), remark)
            })
            .collect()
    };
    let count = (row.results)(scene.model);
    match row.gives {
        Gives::Numbers("STATES") => members(&scene.state_members),
        Gives::Record(..) => members(&scene.output_members),
        Gives::Structure(_, fields) => {
            members(&fields.iter().map(|&field| field.to_owned()).collect::<Vec<_>>())
        }
        Gives::Matrix(_) => match row.pattern {
            Some(pattern) => entries(matrix_remarks(scene, row.id, pattern(scene.model))),
            None => entries(vec![String::new(); count]),
        },
        Gives::Numbers(_) => entries(remarks(scene, row.id, count)),
    }
}

/// Returns the names of the entries of an array.
fn remarks(scene: &Scene<'_>, id: FunctionId, count: usize) -> Vec<String> {
    let model = scene.model;
    match id {
        FunctionId::Forcing => {
            model.coordinates.iter().map(|c| c.position.name.path.clone()).collect()
        }
        FunctionId::Guards | FunctionId::GuardRates => {
            model.events.iter().map(|event| event.name.path.clone()).collect()
        }
        FunctionId::Resets => {
            let sets = model.events.iter().flat_map(|event| {
                let states = event.sets.iter();
                states.map(|&entry| {
                    let state = &model.states[entry as usize].quantity.name.path;
                    format!("{state} after {}", event.name.path)
                })
            });
            sets.collect()
        }
        FunctionId::ConstraintValues | FunctionId::ConstraintRates => {
            model.constraints.iter().map(|constraint| constraint.name.path.clone()).collect()
        }
        _ => vec![String::new(); count],
    }
}

/// Returns the names of the nonzeros of a matrix.
fn matrix_remarks(scene: &Scene<'_>, id: FunctionId, pattern: &SparsityPattern) -> Vec<String> {
    let model = scene.model;
    let path = |quantity: &machinist_model::Quantity| quantity.name.path.clone();
    let states: Vec<String> = model.states.iter().map(|state| path(&state.quantity)).collect();
    let coordinates: Vec<String> = model.coordinates.iter().map(|c| path(&c.position)).collect();
    let parameters = || model.parameters.iter().map(|p| path(&p.quantity)).collect();
    let constraints = || model.constraints.iter().map(|c| c.name.path.clone()).collect();
    let (rows, columns) = match id {
        FunctionId::RateJacobian => (states.clone(), states),
        FunctionId::ParameterJacobian => (states, parameters()),
        FunctionId::ConstraintMatrix => (constraints(), coordinates),
        _ => (coordinates.clone(), coordinates),
    };
    let name = |names: &[String], at: u32| names.get(at as usize).cloned().unwrap_or_default();
    let entries = pattern.entries.iter();
    entries
        .map(|&(row, column)| format!("{}, {}", name(&rows, row), name(&columns, column)))
        .collect()
}

/// Breaks the head of a function into lines that fit.
pub(super) fn broken_head(head: &str) -> String {
    statement(head, 0).trim_end().to_owned()
}

/// Returns documentation of the contract as plain text.
fn plain(doc: &str) -> String {
    doc.replace('`', "").replace("\\[", "[").replace("\\]", "]")
}

/// Returns the number of operations of a function, as a sentence.
pub(super) fn counted(operations: usize) -> String {
    match operations {
        0 => "No operations.".to_owned(),
        1 => "1 operation.".to_owned(),
        many => format!("{many} operations."),
    }
}

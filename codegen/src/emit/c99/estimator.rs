//! An extended Kalman filter on the emitted steps: the operations of
//! [`ExtendedKalmanFilter`](machinist_contract::fixed_step::ExtendedKalmanFilter), in its order.

mod stages;

use std::fmt::Write as _;

use machinist_contract::fixed_step::StepMethod;
use machinist_model::{Directions, Model, Tape};

use super::body::{Scope, body};
use super::expression::{Written, literal};
use super::functions::broken_head;
use super::layout::{comment, remark, statement, statements};
use super::step::{machine_bytes, shift_columns, with_library_names};
use super::{Real, Scene, cost, description, implicit};
use crate::emit::EmitError;

const CARRIED: &str = include_str!("snippets/carried.c");
const EXPLICIT: &str = include_str!("snippets/carried_explicit.c");
const IMPLICIT: &str = include_str!("snippets/carried_implicit.c");
const EVENTS: &str = include_str!("snippets/carried_events.c");
const PROJECTED: &str = include_str!("snippets/carried_projected.c");
const ESTIMATOR: &str = include_str!("snippets/estimator.c");

/// Design of a filter, by indices; see
/// [`ExtendedKalmanFilter`](machinist_contract::fixed_step::ExtendedKalmanFilter).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EstimatorOptions {
    /// Measured outputs, with the standard deviations of their noise.
    pub measured: Vec<(usize, f64)>,
    /// Estimated parameters.
    pub estimated: Vec<usize>,
    /// Entries that diffuse, with intensities.
    pub diffusing: Vec<(usize, f64)>,
    /// Disturbed parameters, with intensities.
    pub disturbed: Vec<(usize, f64)>,
    /// Standard deviation of each entry at the start.
    pub start: Vec<f64>,
}

/// A function whose derivatives along a direction a filter needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CarriedFunction {
    Measured,
    Guards,
    Resets,
    ConstraintValues,
    ConstraintRates,
    RateJacobian,
    TimeDerivative,
}

impl CarriedFunction {
    fn name(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Guards => "guards",
            Self::Resets => "resets",
            Self::ConstraintValues => "constraint_values",
            Self::ConstraintRates => "constraint_rates",
            Self::RateJacobian => "rate_jacobian",
            Self::TimeDerivative => "time_derivative",
        }
    }
}

/// Derivatives along a direction that the filter needs.
pub(super) struct Tangents {
    functions: Vec<(CarriedFunction, Tape)>,
}

impl Tangents {
    pub(super) fn of(model: &Model, method: StepMethod, options: &EstimatorOptions) -> Self {
        let along = options.estimated.iter().copied();
        let along = along.chain(options.disturbed.iter().map(|(parameter, _)| *parameter));
        let directions = Directions { along: along.map(|parameter| parameter as u32).collect() };
        let measured: Vec<usize> = options.measured.iter().map(|(output, _)| *output).collect();
        let all = |tape: &Tape| (0..tape.results.len()).collect::<Vec<_>>();
        let of = |name, tape: &Tape| (name, model.tangent(tape, &all(tape), &directions));
        let mut functions = vec![(
            CarriedFunction::Measured,
            model.tangent(&model.outputs, &measured, &directions),
        )];
        if !model.events.is_empty() {
            functions.push(of(CarriedFunction::Guards, &model.guards));
            functions.push(of(CarriedFunction::Resets, &model.resets));
        }
        if !model.constraints.is_empty() {
            functions.push(of(CarriedFunction::ConstraintValues, &model.constraint_values));
            functions.push(of(CarriedFunction::ConstraintRates, &model.constraint_rates));
        }
        if method == StepMethod::Rosenbrock2 {
            let jacobian = model.tangent_of_matrix(&model.rate_jacobian, &directions);
            functions.push((CarriedFunction::RateJacobian, jacobian));
            functions.push(of(CarriedFunction::TimeDerivative, &model.time_derivative));
        }
        Self { functions }
    }

    pub(super) fn tapes(&self) -> impl Iterator<Item = &Tape> {
        self.functions.iter().map(|(_, tape)| tape)
    }

    /// Returns the tape of a function's derivative, if the filter needs it.
    pub(super) fn tape(&self, wanted: CarriedFunction) -> Option<&Tape> {
        let found = self.functions.iter().find(|(derivative, _)| *derivative == wanted);
        found.map(|(_, tape)| tape)
    }
}

/// Returns an error for a machine without a filter.
pub(super) fn check(model: &Model) -> Result<(), EmitError> {
    if model.rate_jacobian.pattern.entries.is_empty() {
        let message = "the rate of this scene does not depend on its state: nothing is estimated";
        return Err(EmitError::Unsupported { message: message.to_owned() });
    }
    Ok(())
}

/// Sizes of a filter.
struct Sizes {
    entries: usize,
    columns: usize,
    directions: usize,
}

impl Sizes {
    fn of(scene: &Scene<'_>, options: &EstimatorOptions) -> Self {
        let entries = scene.model.states.len() + options.estimated.len();
        Self {
            entries,
            columns: entries + options.diffusing.len() + options.disturbed.len(),
            directions: options.estimated.len() + options.disturbed.len(),
        }
    }
}

/// Returns the structs and functions of the filter, if there is one.
pub(super) fn declarations(scene: &Scene<'_>) -> String {
    let Some(options) = &scene.options.estimator else { return String::new() };
    let Sizes { entries, columns, .. } = Sizes::of(scene, options);
    let real = scene.real();
    let mut text = comment([
        "An extended Kalman filter: estimated entries (states, then estimated parameters), columns \
         that a step carries, and measured outputs.",
    ]);
    let counts = [("ENTRIES", entries), ("COLUMNS", columns), ("MEASURED", options.measured.len())];
    for (name, count) in counts {
        let _ = writeln!(text, "#define {} {count}u", scene.macro_name(name));
    }
    text.push('\n');
    text.push_str(&comment(["Measured outputs. Those that are NAN are left out."]));
    text.push_str("typedef struct {\n");
    for &(output, deviation) in &options.measured {
        let quantity = &scene.model.wanted[output];
        let meaning = format!("{}, deviation {deviation}", description::meaning(quantity));
        let _ = writeln!(text, "    {real} {}; {}", scene.output_members[output], remark(&meaning));
    }
    let [measured, estimator, machine] =
        ["measured_t", "estimator_t", "machine_t"].map(|name| scene.public(name));
    let _ = writeln!(text, "}} {measured};\n");
    let bytes = machine_bytes(scene) + columns * entries * scene.options.real.bytes();
    let doc = format!(
        "Estimate: a machine, and a square root of the covariance by columns, of {bytes} bytes."
    );
    text.push_str(&comment([doc]));
    let _ = writeln!(
        text,
        "typedef struct {{\n    {machine} machine; /* estimated parameters are in machine.p */\n    \
         {real} root[{}][{}];\n}} {estimator};\n",
        scene.macro_name("COLUMNS"),
        scene.macro_name("ENTRIES")
    );
    let cost = cost::filter_cost(scene.model, (scene.options.method, scene.options.real), options);
    let predict = format!(
        "Advances the estimate by a step [s]. Gives what a step gives. It takes {}.{}",
        cost.predict,
        scene.stack_of("estimator_predict")
    );
    let correct = format!(
        "Corrects the estimate by measured outputs. Gives the normalized innovation squared, whose \
         expected value is the number of measured outputs. It takes at most {} operations.{}",
        cost.correct,
        scene.stack_of("estimator_correct")
    );
    let functions = [
        (
            "Sets the estimate to the start of the spec's run, with the deviations of the design.",
            format!("void {}({estimator} *estimator)", scene.public("estimator_begin")),
        ),
        (
            &predict,
            format!(
                "int {}({estimator} *estimator, {real} step)",
                scene.public("estimator_predict")
            ),
        ),
        (
            &correct,
            format!(
                "{real} {}({estimator} *estimator, const {measured} *measured)",
                scene.public("estimator_correct")
            ),
        ),
        (
            "Gives the covariance of two entries: members of the state, then estimated parameters.",
            format!(
                "{real} {}(const {estimator} *estimator, unsigned int row, unsigned int column)",
                scene.public("estimator_covariance")
            ),
        ),
    ];
    for (index, (doc, head)) in functions.iter().enumerate() {
        let space = if index == 0 { "" } else { "\n" };
        let _ = writeln!(text, "{space}{}{};", comment([*doc]), broken_head(head));
    }
    text
}

/// Returns the functions that carry columns along a step. They precede the step.
pub(super) fn carried(scene: &Scene<'_>) -> Result<String, EmitError> {
    let (Some(options), Some(tangents)) = (&scene.options.estimator, &scene.tangents) else {
        return Ok(String::new());
    };
    let mut parts = Vec::new();
    for (derivative, tape) in &tangents.functions {
        parts.push(tangent(scene, derivative.name(), tape, options)?);
    }
    let model = scene.model;
    let is_constrained = !model.constraints.is_empty();
    let is_implicit = scene.options.method == StepMethod::Rosenbrock2;
    if is_constrained {
        parts.push(shift_columns(scene));
    }
    if is_implicit || !model.events.is_empty() {
        parts.push(numbers_of(scene));
    }
    if is_implicit {
        parts.push(implicit::substitute_column(scene));
    }
    let text = format!("{CARRIED}{}", if is_implicit { IMPLICIT } else { EXPLICIT });
    let text = text
        .replace("PROJECTED\n", if is_constrained { PROJECTED } else { "" })
        .replace(
            "AT_END\n",
            if is_constrained {
                "    follow_projected(of, time + h, end, &machine->p, &machine->c);\n"
            } else {
                "    (void)end;\n"
            },
        )
        .replace("DIRECTIONS_OF\n", &directions_of(scene, options)?);
    parts.push(filled(scene, options, &stages::filled_in(scene, options, &text)?));
    if !model.events.is_empty() {
        let cases = reset_cases(scene);
        parts.push(filled(scene, options, &EVENTS.replace("RESET_CASES\n", &cases)));
    }
    Ok(parts.join("\n"))
}

/// Fills names and sizes into a snippet.
fn filled(scene: &Scene<'_>, options: &EstimatorOptions, text: &str) -> String {
    let directions = Sizes::of(scene, options).directions.max(1);
    let text = text.replace("SCENE_DIRECTIONS", &format!("{directions}"));
    let text = match scene.options.real {
        Real::Double => text,
        Real::Float => text.replace("sqrt(", "sqrtf("),
    };
    scene.filled(&with_library_names(&text, scene.options.real))
}

fn directions_of(scene: &Scene<'_>, options: &EstimatorOptions) -> Result<String, EmitError> {
    let sizes = Sizes::of(scene, options);
    let mut text = String::new();
    let states = scene.model.states.len();
    for slot in 0..options.estimated.len() {
        let _ = writeln!(text, "    dp[{slot}] = of->columns[column][{}];", states + slot);
    }
    let first = sizes.entries + options.diffusing.len();
    for (index, (_, intensity)) in options.disturbed.iter().enumerate() {
        let intensity = literal(*intensity, scene.options.real, "estimator")?.text;
        let _ = writeln!(
            text,
            "    dp[{}] = (column == {}u) ? ({intensity} * of->per_intensity) : R(0.0);",
            options.estimated.len() + index,
            first + index
        );
    }
    if text.is_empty() {
        text.push_str("    (void)of;\n    (void)column;\n    dp[0] = R(0.0);\n");
    }
    Ok(text)
}

/// Returns the function that copies a state into numbers.
fn numbers_of(scene: &Scene<'_>) -> String {
    let mut text = format!(
        "static void numbers_of(const {} *state, {} values[{}])\n{{\n",
        scene.public("state_t"),
        scene.real(),
        scene.macro_name("STATES")
    );
    for (entry, member) in scene.state_members.iter().enumerate() {
        let _ = writeln!(text, "    values[{entry}] = state->{member};");
    }
    text.push_str("}\n");
    text
}

fn reset_cases(scene: &Scene<'_>) -> String {
    let mut text = String::new();
    let mut first = 0;
    for (index, event) in scene.model.events.iter().enumerate() {
        let _ = writeln!(text, "        case {index}u:");
        for (place, entry) in event.sets.iter().enumerate() {
            let _ = writeln!(text, "            x[{entry}] = values[{}];", first + place);
        }
        text.push_str("            break;\n");
        first += event.sets.len();
    }
    text
}

/// Returns a function that gives derivatives along a direction.
fn tangent(
    scene: &Scene<'_>,
    name: &str,
    tape: &Tape,
    options: &EstimatorOptions,
) -> Result<String, EmitError> {
    let mut namer = scene.namer.clone();
    let [x, p, t] = ["dx", "dp", "dt"].map(|name| namer.claim(name));
    let states = scene.model.states.len();
    let directions = scene.states.iter().map(|name| namer.claim(&format!("d_{name}")));
    let directions: Vec<String> = directions.collect();
    let variables = [&scene.states[..], &directions].concat();
    let slots = options.estimated.len() + options.disturbed.len();
    let along = (0..slots).map(|slot| Written::call(format!("{p}[{slot}]")));
    let parameters: Vec<Written> =
        scene.parameters.iter().cloned().chain(along).chain([Written::call(&*t)]).collect();
    let scope =
        Scope { states: &variables, parameters: &parameters, namer: &namer, ..scene.scope(name) };
    let found = body(tape, &scope, false)?;
    let (real, state) = (scene.real(), scene.public("state_t"));
    let head = format!(
        "static void {name}_along({real} time, const {state} *state, const {} *p, const {real} \
         {x}[{}], const {real} {p}[{}], {real} {t}, {real} values[{}])",
        scene.public("parameters_t"),
        scene.macro_name("STATES"),
        slots.max(1),
        tape.results.len()
    );
    let mut text = comment([format!("Derivatives of the {name} along a direction.")]);
    text.push_str(&broken_head(&head));
    text.push_str("\n{\n");
    for &entry in &found.reads.state {
        let value = match entry.checked_sub(states) {
            None => format!("state->{}", scene.state_members[entry]),
            Some(along) => format!("{x}[{along}]"),
        };
        text.push_str(&statement(&format!("const {real} {} = {value};", variables[entry]), 4));
    }
    text.push_str(&statements(&found.statements));
    for name in ["time", "state", "p", &x, &p, &t] {
        let _ = writeln!(text, "    (void){name};");
    }
    for (index, result) in found.results.iter().enumerate() {
        text.push_str(&statement(&format!("values[{index}] = {result};"), 4));
    }
    text.push_str("}\n");
    Ok(text)
}

/// Returns the functions of the filter, which follow those of the step.
pub(super) fn definitions(scene: &Scene<'_>) -> Result<String, EmitError> {
    let Some(options) = &scene.options.estimator else { return Ok(String::new()) };
    let real = scene.options.real;
    let number = |value: f64| Ok(literal(value, real, "estimator")?.text);
    let numbers = |values: &mut dyn Iterator<Item = f64>| -> Result<String, EmitError> {
        let values = values.map(number).collect::<Result<Vec<_>, EmitError>>()?;
        Ok(statement(&values.join(", "), 8))
    };
    let entries = Sizes::of(scene, options).entries;
    let mut diffuse = String::new();
    for (index, (entry, intensity)) in options.diffusing.iter().enumerate() {
        let column = entries + index;
        let _ = writeln!(
            diffuse,
            "    estimator->root[{column}][{entry}] = {} * root_of_step;",
            number(*intensity)?
        );
    }
    let mut innovations = String::new();
    for (row, (output, _)) in options.measured.iter().enumerate() {
        let member = &scene.output_members[*output];
        let line = format!("innovations[{row}] = measured->{member} - predicted.{member};");
        innovations.push_str(&statement(&line, 4));
    }
    let text = ESTIMATOR
        .replace("DEVIATIONS", &numbers(&mut options.start.iter().copied())?)
        .replace("NOISE", &numbers(&mut options.measured.iter().map(|(_, deviation)| *deviation))?)
        .replace("DIFFUSE\n", &diffuse)
        .replace("INNOVATIONS\n", &innovations)
        .replace("CHANGE\n", &change(scene, options))
        .replace("RESTORE\n", &restore(scene));
    Ok(filled(scene, options, &text))
}

/// Returns the lines that add a change to the estimate.
fn change(scene: &Scene<'_>, options: &EstimatorOptions) -> String {
    let mut text = String::new();
    for (entry, member) in scene.state_members.iter().enumerate() {
        if !scene.is_mode(entry) {
            let line =
                format!("machine->state.{member} = machine->state.{member} + change[{entry}];");
            text.push_str(&statement(&line, 4));
        }
    }
    for (slot, parameter) in options.estimated.iter().enumerate() {
        let member = &scene.parameter_members[*parameter];
        let entry = scene.state_members.len() + slot;
        let line = format!("machine->p.{member} = machine->p.{member} + change[{entry}];");
        text.push_str(&statement(&line, 4));
    }
    if !options.estimated.is_empty() {
        text.push_str("    scene_prepare(&machine->p, &machine->c);\n");
    }
    text
}

/// Returns the lines that put a state back onto constraints and settle its modes.
fn restore(scene: &Scene<'_>) -> String {
    let mut text = String::new();
    if !scene.model.constraints.is_empty() {
        text.push_str(
            "    project(machine->time, &machine->state, &machine->p, &machine->c);\n    \
             follow_projected(follow, machine->time, &machine->state, &machine->p, &machine->c);\n",
        );
    }
    if !scene.model.events.is_empty() {
        text.push_str("    settle_followed(machine, follow);\n");
    }
    text
}

/// Fills the hooks of a step into its code, or leaves them out.
pub(super) fn hooked(scene: &Scene<'_>, text: &str) -> String {
    let has_estimator = scene.options.estimator.is_some();
    let lines = text.lines().filter_map(|line| match line.strip_prefix('@') {
        Some(hook) => has_estimator.then_some(hook),
        None => Some(line),
    });
    let mut text = lines.fold(String::new(), |text, line| text + line + "\n");
    let is_constrained = !scene.model.constraints.is_empty();
    for indent in [4, 8] {
        let held = if has_estimator && is_constrained {
            let [outer, inner] = [indent, indent + 4].map(|count| " ".repeat(count));
            format!(
                "{outer}if (follow != NULL) {{\n{inner}follow_projected(follow, machine->time, \
                 &machine->state, &machine->p,\n{inner}                 &machine->c);\n{outer}}}\n"
            )
        } else {
            String::new()
        };
        text = text.replace(&format!("HELD_COLUMNS_{indent}\n"), &held);
    }
    let mut text = marked(scene, &text);
    let public = "int scene_step(scene_machine_t *machine, scene_real_t step)";
    let settle = "void scene_settle(scene_machine_t *machine)";
    if !has_estimator {
        return text.replace("STEP_HEAD", public).replace("SETTLE_HEAD", settle);
    }
    let has_settle = text.contains("SETTLE_HEAD");
    text = text
        .replace(
            "STEP_HEAD",
            "static int step_followed(scene_machine_t *machine, scene_real_t step,\n                         \
             struct carried *follow)",
        )
        .replace(
            "SETTLE_HEAD",
            "static void settle_followed(scene_machine_t *machine, struct carried *follow)",
        );
    let _ = write!(text, "\n{public}\n{{\n    return step_followed(machine, step, NULL);\n}}\n");
    if has_settle {
        let _ = write!(text, "\n{settle}\n{{\n    settle_followed(machine, NULL);\n}}\n");
    }
    text
}

/// Fills in the arguments that hooks add to functions of events, or leaves them out.
pub(super) fn marked(scene: &Scene<'_>, text: &str) -> String {
    let words = [
        ("#DECLARED", ", struct carried *follow"),
        ("#FIRST_DECLARED", ",\n                  size_t first, struct carried *follow"),
        ("#PASSED", ", follow"),
        ("#WHICH", ", which, follow"),
        ("#KNOWN", ", SCENE_EVENTS, follow"),
        ("#NOBODY", ", SCENE_EVENTS, NULL"),
    ];
    let has_estimator = scene.options.estimator.is_some();
    words.into_iter().fold(text.to_owned(), |text, (mark, word)| {
        text.replace(mark, if has_estimator { word } else { "" })
    })
}

//! Fixed steps: the struct of a run, its start, and one step.

use std::fmt::Write as _;

use machinist_contract::fixed_step::StepMethod;
use machinist_model::{Direction, State, StateKind};

use super::description::needs_start;
use super::events::has_jumping_friction;
use super::functions::broken_head;
use super::layout::{comment, statement};
use super::{Real, Scene, cost, estimator, implicit};
use crate::emit::EmitError;

const RUNGE_KUTTA: &str = include_str!("snippets/runge_kutta.c");
const HEUN: &str = include_str!("snippets/heun.c");
const PROJECT: &str = include_str!("snippets/project.c");
const TIME: &str = include_str!("snippets/time.c");
const STEP: &str = include_str!("snippets/step.c");
const JUMPS: &str = include_str!("snippets/jumps.c");
const NEXT_JUMP: &str = include_str!("snippets/next_jump.c");
const EVENTS: &str = include_str!("snippets/events.c");
const EVENTS_HOSTED: &str = include_str!("snippets/events_hosted.c");
const EVENTS_NEXT_JUMP: &str = include_str!("snippets/events_next_jump.c");
const EVENTS_AT_JUMP: &str = include_str!("snippets/events_at_jump.c");

/// Returns the struct of a run and its functions.
pub(super) fn declarations(scene: &Scene<'_>) -> String {
    let has_events = !scene.model.events.is_empty();
    let mut text = String::new();
    if has_parts(scene) {
        let most = scene.macro_name("PARTS_A_STEP");
        text.push_str(&comment([
            "Largest number of parts of a step: events and times at which the rate jumps end one. \
             What passes zero after that happens in the next step. Each event once and one jump, \
             unless set otherwise.",
        ]));
        let parts = cost::parts(scene.model);
        let _ = writeln!(text, "#ifndef {most}\n#define {most} {parts}u\n#endif\n");
    }
    text.push_str(&machine(scene));
    let [machine, begin, step] = ["machine_t", "begin", "step"].map(|name| scene.public(name));
    let prepare = scene.public("prepare");
    let begins = if scene.options.start.is_some() {
        "Sets parameters and time to those of the spec, and the state to the one in which its run \
         starts with these parameters."
    } else {
        "Sets parameters, time and state to those of the spec."
    };
    let _ = write!(text, "\n{}void {begin}({machine} *machine);\n", comment([begins]));
    if has_events {
        let settle = scene.public("settle");
        let doc = "Sets right modes that contradict their guards. Call it whenever the state has \
                   been changed by hand.";
        let _ = write!(text, "\n{}void {settle}({machine} *machine);\n", comment([doc]));
        text.push_str(&hosted(scene));
    }
    if !scene.model.constraints.is_empty() {
        let project = scene.public("project");
        let doc = "Puts the state back onto the constraints, first in position, then in velocity, \
                   by one step of Newton's method each. Steps do so themselves.";
        let _ = write!(text, "\n{}void {project}({machine} *machine);\n", comment([doc]));
        let project = scene.public("project_start");
        let doc =
            "Puts a start near the constraints onto them, without moving what the spec gives.";
        let _ = write!(text, "\n{}void {project}({machine} *machine);\n", comment([doc]));
    }
    if !scene.inputs.is_empty() {
        let _ = write!(
            text,
            "\n{}{};\n",
            comment(["Sets the inputs, which hold until they are set again."]),
            set_head(scene)
        );
    }
    let events = match (has_events, has_parts(scene)) {
        (true, _) => " Gives the number of events, or -1 if the step had more parts than may be.",
        (false, true) => " Gives 0, or -1 if the step had more parts than may be.",
        (false, false) => " Gives 0.",
    };
    let cost = cost::step_cost(scene.model, scene.options.method, scene.options.real);
    let doc = format!(
        "Advances the machine by a step [s], by {}.{events} Parameters and inputs may be changed \
         between steps; call {prepare} after that of parameters. It takes {cost}.{}",
        scene.options.method.meaning(),
        scene.stack_of("step"),
    );
    let _ = write!(
        text,
        "\n{}int {step}({machine} *machine, {} step);\n",
        comment([doc]),
        scene.real()
    );
    text
}

/// Returns the declarations of the functions for hosts that integrate by a method of their own.
fn hosted(scene: &Scene<'_>) -> String {
    let (real, machine) = (scene.real(), scene.public("machine_t"));
    let guards = format!("const {real} guards[{}]", scene.macro_name("EVENTS"));
    let [is_due, happen, follow] = ["is_due", "happen", "follow"].map(|name| scene.public(name));
    let heads = [
        (
            "For hosts that integrate by a method of their own. Whether guards, which have these \
             values now, have passed zero where an event happens.",
            format!("int {is_due}(const {machine} *machine, {guards})"),
        ),
        (
            "Makes the events of such guards happen at the present time and state. A guard that \
             comes back within h [s] is at zero. Gives their number.",
            format!("int {happen}({machine} *machine, {guards}, {real} h)"),
        ),
        (
            "Keeps on which side of zero guards are, after a step without events.",
            format!("void {follow}({machine} *machine, {guards})"),
        ),
    ];
    let declared = heads.iter().map(|(doc, head)| {
        let head = broken_head(head);
        format!("\n{}{head};\n", comment([doc]))
    });
    declared.collect()
}

/// Reports whether a step may have several parts.
fn has_parts(scene: &Scene<'_>) -> bool {
    !scene.model.events.is_empty() || has_jumps(scene)
}

fn has_jumps(scene: &Scene<'_>) -> bool {
    !scene.model.discontinuities.results.is_empty()
}

fn machine(scene: &Scene<'_>) -> String {
    let real = scene.real();
    let [state, parameters, constants] =
        ["state_t", "parameters_t", "constants_t"].map(|name| scene.public(name));
    let mut text = inputs(scene);
    let doc = format!(
        "A machine that runs, of {} bytes. There may be any number of them.",
        machine_bytes(scene)
    );
    text.push_str(&comment([doc]));
    let _ = write!(
        text,
        "typedef struct {{\n    {real} time; /* [s] */\n    {real} time_rest; /* what the sum of \
         steps leaves out of the time */\n    {state} state;\n    {parameters} p;\n    {constants} \
         c;\n"
    );
    if !scene.model.events.is_empty() {
        let count = scene.macro_name("EVENTS");
        let _ = writeln!(
            text,
            "    signed char side[{count}]; /* on which side of zero guards are; 0: not watched */"
        );
    }
    let _ = writeln!(text, "}} {};", scene.public("machine_t"));
    text
}

/// Returns the size of the struct of a machine, where numbers are aligned to their size.
pub(super) fn machine_bytes(scene: &Scene<'_>) -> usize {
    let number = scene.options.real.bytes();
    let counts = [scene.model.states.len(), scene.parameter_members.len(), scene.constants.len()];
    let mut bytes = 2 * number;
    for count in counts {
        // An empty struct has one byte.
        bytes = match count {
            0 => bytes + 1,
            _ => bytes.next_multiple_of(number) + count * number,
        };
    }
    (bytes + scene.model.events.len()).next_multiple_of(number)
}

/// Returns the struct of the inputs, if there are any.
fn inputs(scene: &Scene<'_>) -> String {
    if scene.inputs.is_empty() {
        return String::new();
    }
    let mut text = comment(["Inputs: parameters that change along a run."]);
    text.push_str("typedef struct {\n");
    for &input in &scene.inputs {
        let meaning = super::description::meaning(&scene.model.parameters[input].quantity);
        let member = &scene.parameter_members[input];
        let remark = super::layout::remark(&meaning);
        let _ = writeln!(text, "    {} {member}; {remark}", scene.real());
    }
    let _ = writeln!(text, "}} {};\n", scene.public("inputs_t"));
    text
}

fn set_head(scene: &Scene<'_>) -> String {
    let [set, machine, inputs] =
        ["set_inputs", "machine_t", "inputs_t"].map(|name| scene.public(name));
    format!("void {set}({machine} *machine, const {inputs} *inputs)")
}

/// Returns the definitions of the functions declared above.
pub(super) fn definitions(scene: &Scene<'_>) -> Result<String, EmitError> {
    let is_constrained = !scene.model.constraints.is_empty();
    let mut parts = vec![ahead(scene)];
    parts.push(match scene.options.method {
        StepMethod::RungeKutta4 => scene.filled(RUNGE_KUTTA),
        StepMethod::Heun => scene.filled(HEUN),
        StepMethod::Rosenbrock2 => implicit::advance(scene)?,
    });
    if is_constrained {
        parts.push(shifts(scene));
        let given = |is_position| statement(&given(scene, is_position), 4);
        let text = PROJECT
            .replace("GIVEN_POSITIONS", &given(true))
            .replace("GIVEN_VELOCITIES", &given(false));
        parts.push(scene.filled(&with_library_names(&text, scene.options.real)));
    }
    parts.push(scene.filled(TIME));
    if scene.options.estimator.is_some() {
        parts.push(estimator::carried(scene)?);
    }
    if !scene.inputs.is_empty() {
        parts.push(set_inputs(scene));
    }
    let real = scene.options.real;
    if has_jumps(scene) {
        parts.push(scene.filled(&with_library_names(NEXT_JUMP, real)));
    }
    parts.push(match (scene.model.events.is_empty(), has_jumps(scene)) {
        (true, false) => {
            let put_back = project(scene, 4, "machine->time + step", "&end");
            scene.filled(&estimator::hooked(scene, &STEP.replace("PROJECT\n", &put_back)))
        }
        (true, true) => {
            let put_back = project(scene, 12, "machine->time + length", "&end");
            scene.filled(&estimator::hooked(scene, &JUMPS.replace("PROJECT\n", &put_back)))
        }
        (false, _) => {
            let hosted = estimator::marked(scene, EVENTS_HOSTED);
            let hosted = scene.filled(&with_library_names(&hosted, scene.options.real));
            format!("{}\n{hosted}", events(scene))
        }
    });
    parts.push(begin(scene)?);
    if scene.options.estimator.is_some() {
        parts.push(estimator::definitions(scene)?);
    }
    Ok(parts.join("\n"))
}

/// Returns the line that projects a state onto the constraints; empty without constraints.
fn project(scene: &Scene<'_>, indent: usize, time: &str, state: &str) -> String {
    if scene.model.constraints.is_empty() {
        return String::new();
    }
    format!("{:indent$}project({time}, {state}, &machine->p, &machine->c);\n", "")
}

/// Returns `out = state + h slope`, member by member.
fn ahead(scene: &Scene<'_>) -> String {
    let (real, state) = (scene.real(), scene.public("state_t"));
    let mut text = comment(["out = state + h slope."]);
    let head = format!(
        "static void ahead({state} *out, const {state} *state, {real} h, const {state} *slope)"
    );
    text.push_str(&statement(&head, 0));
    text.push_str("{\n");
    for member in &scene.state_members {
        text.push_str(&statement(
            &format!("out->{member} = state->{member} + h * slope->{member};"),
            4,
        ));
    }
    text.push_str("}\n");
    text
}

/// Returns for each coordinate whether the spec gives its initial position or velocity.
fn given(scene: &Scene<'_>, of_position: bool) -> String {
    let coordinates = 0..scene.model.coordinates.len();
    let is_given = |coordinate: usize| {
        scene.model.states.iter().any(|state| {
            let is_it = match state.kind {
                StateKind::Position(of) => of_position && of as usize == coordinate,
                StateKind::Velocity(of) => !of_position && of as usize == coordinate,
                _ => false,
            };
            is_it && state.is_given
        })
    };
    let flags = coordinates.map(|coordinate| if is_given(coordinate) { "1" } else { "0" });
    flags.collect::<Vec<_>>().join(", ")
}

/// Returns the shifts of positions and of velocities of a state.
fn shifts(scene: &Scene<'_>) -> String {
    let total = scene.model.coordinates.len() + scene.model.constraints.len();
    let head = |what: &str| {
        let (state, real) = (scene.public("state_t"), scene.real());
        statement(
            &format!("static void shift_{what}({state} *state, const {real} shift[{total}])"),
            0,
        )
    };
    let name = |entry: usize| format!("state->{}", scene.state_members[entry]);
    let [positions, velocities] = [true, false].map(|of| shift_lines(scene, of, &name));
    format!(
        "{}{{\n{positions}}}\n\n{}{{\n{velocities}}}\n\n",
        head("positions"),
        head("velocities")
    )
}

/// Returns the shifts of positions and of velocities of a column of the covariance's root.
pub(super) fn shift_columns(scene: &Scene<'_>) -> String {
    let (state, real) = (scene.public("state_t"), scene.real());
    let total = scene.model.coordinates.len() + scene.model.constraints.len();
    let states = scene.macro_name("STATES");
    let name = |entry: usize| format!("column[{entry}]");
    let [positions, velocities] = [true, false].map(|of| shift_lines(scene, of, &name));
    let unused = if quaternions(scene).is_empty() { "    (void)state;\n" } else { "" };
    let heads = [
        format!(
            "static void shift_column_positions(const {state} *state, const {real} shift[{total}], \
             {real} column[{states}])"
        ),
        format!(
            "static void shift_column_velocities(const {real} shift[{total}], {real} \
             column[{states}])"
        ),
    ];
    let [of_positions, of_velocities] = heads.map(|head| statement(&head, 0));
    format!(
        "/* Shifts the positions, and the velocities, of a column. */\n\
         {of_positions}{{\n{unused}{positions}}}\n\n{of_velocities}{{\n{velocities}}}\n"
    )
}

/// Returns the lines that shift positions or velocities of something by its names. The state of a
/// scene with constraints contains all of them. A quaternion q turns by small rotations,
/// q' = q shift/2.
fn shift_lines(scene: &Scene<'_>, is_position: bool, name: &dyn Fn(usize) -> String) -> String {
    let real = scene.real();
    let mut text = String::new();
    let quaternions = if is_position { quaternions(scene) } else { Vec::new() };
    for (entry, state) in scene.model.states.iter().enumerate() {
        if quaternions.iter().flatten().any(|part| *part == entry) {
            continue;
        }
        let coordinate = match state.kind {
            StateKind::Position(coordinate) if is_position => coordinate,
            StateKind::Velocity(coordinate) if !is_position => coordinate,
            _ => continue,
        };
        let name = name(entry);
        let _ = writeln!(text, "    {name} = {name} - shift[{coordinate}];");
    }
    for parts in quaternions {
        let StateKind::Position(first) = scene.model.states[parts[1]].kind else { continue };
        let [w, x, y, z] = parts.map(|entry| &scene.state_members[entry]);
        let [to_w, to_x, to_y, to_z] = parts.map(name);
        let [a, b, c] = [0, 1, 2].map(|axis| format!("shift[{}]", first + axis));
        let half = scene.options.real.literal(0.5).unwrap_or_default();
        let _ = write!(
            text,
            "    {{\n        const {real} w = state->{w}, x = state->{x}, y = state->{y}, z = \
             state->{z};\n        {to_w} = {to_w} + {half}*(x*{a} + y*{b} + z*{c});\n        \
             {to_x} = {to_x} - {half}*(w*{a} + y*{c} - z*{b});\n        {to_y} = {to_y} - \
             {half}*(w*{b} + z*{a} - x*{c});\n        {to_z} = {to_z} - {half}*(w*{c} + x*{b} - \
             y*{a});\n    }}\n"
        );
    }
    text
}

/// Returns the entries of the state that are w, x, y and z of each quaternion: positions beyond the
/// coordinates name the first of the coordinates that they turn with.
fn quaternions(scene: &Scene<'_>) -> Vec<[usize; 4]> {
    let (states, coordinates) = (&scene.model.states, scene.model.coordinates.len());
    let place = |wanted: u32| {
        let is_it = |state: &State| state.kind == StateKind::Position(wanted);
        states.iter().position(is_it).unwrap_or_default()
    };
    let scalars = states.iter().enumerate().skip(coordinates);
    let found = scalars.filter_map(|(entry, state)| match state.kind {
        StateKind::Position(first) => {
            Some([entry, place(first), place(first + 1), place(first + 2)])
        }
        _ => None,
    });
    found.collect()
}

fn set_inputs(scene: &Scene<'_>) -> String {
    let mut text = format!("{}\n{{\n", set_head(scene));
    for &input in &scene.inputs {
        let member = &scene.parameter_members[input];
        let _ = writeln!(text, "    machine->p.{member} = inputs->{member};");
    }
    let _ = writeln!(text, "    {}(&machine->p, &machine->c);\n}}", scene.public("prepare"));
    text
}

/// Returns the code of a step with events.
fn events(scene: &Scene<'_>) -> String {
    let directions = scene.model.events.iter().map(|event| match event.direction {
        Direction::Rising => "1",
        Direction::Falling => "-1",
        Direction::Both => "0",
    });
    let directions = directions.collect::<Vec<_>>().join(", ");
    let held = |indent| project(scene, indent, "machine->time", "&machine->state");
    let text = EVENTS
        .replace("HOLD\nHELD_COLUMNS_8", &format!("{}HELD_COLUMNS_8", held(8)))
        .replace("HOLD\n", &held(4))
        .replace("PROJECT_END\n", &project(scene, 8, "machine->time + length", "&end"))
        .replace("PROJECT_FIRST\n", &project(scene, 12, "machine->time + first * length", "&end"));
    let (next, at, declared) = if has_jumps(scene) {
        let declared = "        scene_real_t after;\n        int found, jumps;\n";
        (EVENTS_NEXT_JUMP, EVENTS_AT_JUMP, declared)
    } else {
        ("", "", "        int found;\n")
    };
    let reopening = if has_jumping_friction(scene.model) {
        "                scene_reopen_frictions(&machine->state);\n"
    } else {
        ""
    };
    let at = at.replace("REOPEN\n", reopening);
    let text = text
        .replace("        int found;\nNEXT_JUMP\n", &format!("{declared}{next}"))
        .replace("AT_JUMP\n", &at);
    let text = estimator::hooked(scene, &text);
    let text = scene.filled(&with_library_names(&text, scene.options.real));
    let list = statement(&directions, 4);
    let ends = scene.model.events.iter().map(|event| {
        let ends = event.when.iter().any(|(entry, _)| event.sets.contains(entry));
        if ends { "1" } else { "0" }
    });
    let ends = statement(&ends.collect::<Vec<_>>().join(", "), 4);
    let count = scene.macro_name("EVENTS");
    let doc = format!(
        "{}static const signed char directions[{count}] = {{\n{list}}};\n\n\
         {}static const signed char ends_its_mode[{count}] = {{\n{ends}}};\n",
        comment(["Which way guards pass zero where events happen: 1 rising, -1 falling, 0 both."]),
        comment(["Whether an event sets a mode that it is watched for in."]),
    );
    format!("{doc}\n{text}")
}

/// Replaces names of the C library in a snippet by those for the number type.
pub(super) fn with_library_names(text: &str, real: Real) -> String {
    let [absolute, epsilon, digits] = match real {
        Real::Double => ["fabs(", "DBL_EPSILON", "(unsigned int)DBL_MANT_DIG"],
        Real::Float => ["fabsf(", "FLT_EPSILON", "(unsigned int)FLT_MANT_DIG"],
    };
    let text = text.replace("fabs(", absolute);
    text.replace("SCENE_EPSILON", epsilon).replace("SCENE_DIGITS", digits)
}

/// Returns the function that begins a run.
fn begin(scene: &Scene<'_>) -> Result<String, EmitError> {
    let (model, real) = (scene.model, scene.options.real);
    let number = |place: &str, value: f64| {
        let literal = real.literal(value);
        literal.ok_or_else(|| EmitError::NotFinite { place: place.to_owned(), value })
    };
    let [begin, machine, defaults, prepare] =
        ["begin", "machine_t", "default_parameters", "prepare"].map(|name| scene.public(name));
    let mut text = format!(
        "void {begin}({machine} *machine)\n{{\n    {defaults}(&machine->p);\n    \
         {prepare}(&machine->p, &machine->c);\n    machine->time = {};\n    machine->time_rest = {};\n",
        number("run", model.run.from)?,
        number("run", 0.0)?
    );
    match &scene.options.start {
        None if needs_start(model) => {
            let message = "a run starts on constraints or in equilibrium, and no start is given";
            return Err(EmitError::Unsupported { message: message.to_owned() });
        }
        None => {
            let initial = scene.public("initial_state");
            let _ = writeln!(text, "    {initial}(&machine->p, &machine->state);");
        }
        Some(start) if start.len() != model.states.len() => {
            let [given, states] = [start.len(), model.states.len()];
            let message = format!("the start has {given} entries, and the state {states}");
            return Err(EmitError::Unsupported { message });
        }
        Some(start) => {
            for (member, value) in scene.state_members.iter().zip(start) {
                let value = number("state at the start", *value)?;
                let _ = writeln!(text, "    machine->state.{member} = {value};");
            }
        }
    }
    if !model.events.is_empty() {
        let _ = writeln!(text, "    {}(machine);", scene.public("settle"));
    }
    text.push_str("}\n");
    Ok(text)
}

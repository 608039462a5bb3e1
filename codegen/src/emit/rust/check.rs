//! Rules of tapes and programs that emission relies on.

use crate::emit::{EmitError, functions};
use crate::program::Program;
use crate::tape::{NodeId, Op, Tape};

/// Checks every function of a program, so that what follows may index freely.
///
/// # Errors
/// [`EmitError::Malformed`] names the function and the rule.
pub(super) fn check(program: &Program) -> Result<(), EmitError> {
    let states = program.layout.len();
    let mut expected = vec![
        states,
        program.system.discontinuities.len(),
        states,
        program.mass_matrix.pattern.entries.len(),
        program.system.coordinates.len(),
        program.rate_jacobian.pattern.entries.len(),
        program.parameter_jacobian.pattern.entries.len(),
        states,
        program.system.outputs.len(),
        3,
        3,
    ];
    if !program.events.is_empty() {
        let resets = program.events.iter().map(|event| event.sets.len()).sum();
        expected.extend([program.events.len(), program.events.len(), resets]);
    }
    let constraints = program.constraints.len();
    let entries = program.constraint_matrix.pattern.entries.len();
    expected.extend([constraints, constraints, entries]);
    for ((function, tape), expected) in functions(program).into_iter().zip(expected) {
        let malformed = |reason| EmitError::Malformed { function, reason };
        check_tape(tape, program, states).map_err(malformed)?;
        if tape.results.len() != expected {
            let found = tape.results.len();
            return Err(malformed(format!("{expected} results expected, {found} found")));
        }
    }
    if let Some(excitation) = &program.excitation {
        for (function, tape) in excitation.functions() {
            check_tape(tape, program, 0)
                .map_err(|reason| EmitError::Malformed { function, reason })?;
        }
    }
    let entries = program.events.iter().flat_map(|event| {
        event.sets.iter().copied().chain(event.when.iter().map(|(entry, _)| *entry))
    });
    let mut beyond = entries.filter(|entry| *entry as usize >= states);
    if let Some(entry) = beyond.next() {
        let reason = format!("an event mentions state {entry} of {states}");
        return Err(EmitError::Malformed { function: "guards", reason });
    }
    for (function, tape) in &functions(program)[..2] {
        if tape.nodes.iter().any(|node| matches!(node.op, Op::Time | Op::State(_))) {
            let reason = "only parameters may be read here".to_owned();
            return Err(EmitError::Malformed { function, reason });
        }
    }
    Ok(())
}

/// Checks a tape that reads a state of so many entries.
pub(super) fn check_tape(tape: &Tape, program: &Program, states: usize) -> Result<(), String> {
    let system = &program.system;
    for (index, node) in tape.nodes.iter().enumerate() {
        if let Some(NodeId(late)) = node.op.operands().iter().find(|id| id.0 as usize >= index) {
            return Err(format!("node {index} reads node {late}, which does not come before it"));
        }
        let (entry, count, kind) = match node.op {
            Op::State(entry) => (entry, states, "state"),
            Op::Parameter(entry) => (entry, system.parameters.len(), "parameter"),
            Op::Table { table, .. } => (table.0, system.tables.len(), "table"),
            _ => continue,
        };
        if entry as usize >= count {
            return Err(format!("node {index} reads {kind} {entry} of {count}"));
        }
    }
    match tape.results.iter().find(|id| id.0 as usize >= tape.nodes.len()) {
        Some(NodeId(result)) => Err(format!("result {result} is no node of the tape")),
        None => Ok(()),
    }
}

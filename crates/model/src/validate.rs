//! Rules of models, on which running and emission rely.

use thiserror::Error;

use crate::functions::{FunctionId, Reads};
use crate::{
    Check, Excitation, FieldModel, MatrixTape, Model, NodeId, Op, Reference, SparsityPattern,
    StateKind, Table, Tape,
};

/// A rule that a model breaks.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{part}: {reason}")]
pub struct Malformed {
    /// Function or part that breaks the rule.
    pub part: String,
    /// Reason.
    pub reason: String,
}

impl Malformed {
    /// Returns the code of this kind of error, that of [`FileError::Malformed`].
    ///
    /// [`FileError::Malformed`]: crate::file::FileError::Malformed
    #[must_use]
    pub fn code(&self) -> &'static str {
        "model::malformed"
    }
}

/// Inputs that a tape may read.
struct Room {
    time: bool,
    states: usize,
    parameters: usize,
    handed: usize,
    /// Indices of the slots among the parameters.
    slots: std::ops::Range<usize>,
    constants: usize,
    motion: usize,
    tables: usize,
}

impl Model {
    /// Checks that every tape reads only existing inputs, in order, and gives the right number of
    /// results; that patterns are sorted; and that all other indices and names refer to existing
    /// items.
    ///
    /// # Errors
    /// The first broken rule.
    pub fn validate(&self) -> Result<(), Malformed> {
        for row in self.functions() {
            let of_motion = row.reads == Reads::Motion;
            let room = Room {
                time: of_motion,
                states: if of_motion { self.states.len() } else { 0 },
                ..self.room()
            };
            let room = Room { motion: self.motion_results(row.id), ..room };
            let tape = (row.tape)(self);
            let matrix = row.matrix.map(|matrix| matrix(self));
            let results = matrix.map_or_else(|| (row.results)(self), MatrixTape::inputs);
            check(row.name, tape, &room, results)?;
            if let Some(matrix) = matrix {
                self.check_pattern(row.name, &matrix.pattern)?;
                self.check_solve(row.name, matrix)?;
            }
        }
        self.check_motion()?;
        self.check_shapes()?;
        self.check_state()?;
        self.check_numbers()?;
        if let Some(excitation) = &self.excitation {
            let states = self.states.len();
            let room = Room { time: true, states, ..self.room() };
            let values = 4 * excitation.terms.len() + excitation.slopes.len();
            check("excitation", &excitation.values, &room, values)?;
            let switches = excitation.switches.results.len();
            check("switches", &excitation.switches, &self.room(), switches)?;
            let rows = states + self.events.len() + self.kink_guards.results.len();
            let mut entries = excitation.terms.iter();
            if let Some((row, _)) = entries.find(|(row, _)| *row as usize >= rows) {
                return broken("excitation", format!("acts on row {row}"));
            }
            let mut slopes = excitation.slopes.iter();
            if let Some((row, entry)) =
                slopes.find(|(row, entry)| *row as usize >= rows || *entry as usize >= states)
            {
                return broken("excitation", format!("has a slope of row {row} by state {entry}"));
            }
            let mut powers = excitation.terms.iter().map(|(_, power)| *power);
            if let Some(power) = powers.find(|power| *power > Excitation::HIGHEST_POWER) {
                return broken("excitation", format!("has time to the power {power}"));
            }
        }
        check("required", &self.required, &self.room(), self.requirements.len())?;
        if let Some(drawing) = &self.drawing {
            let room = Room { time: true, states: self.states.len(), ..self.room() };
            check("drawing", &drawing.places, &room, drawing.numbers())?;
        }
        self.check_events()?;
        for field in &self.fields {
            self.check_field(field)?;
        }
        self.checks.iter().try_for_each(|check| self.check_reference(check))?;
        Ok(())
    }

    /// Returns the inputs of a tape of parameters only.
    fn room(&self) -> Room {
        Room {
            time: false,
            states: 0,
            parameters: self.parameters.len(),
            handed: self.handed.len(),
            slots: self.slots(),
            constants: 0,
            motion: 0,
            tables: self.tables.len(),
        }
    }

    /// Returns the number of results of the motion's tape that a function may read. Functions from
    /// which series are made, and those of parameters only, are complete by themselves.
    fn motion_results(&self, id: FunctionId) -> usize {
        let stands = id.row().reads == Reads::Parameters
            || matches!(id, FunctionId::Rate | FunctionId::MassMatrix | FunctionId::Forcing);
        self.motion.as_ref().filter(|_| !stands).map_or(0, |motion| motion.tape.results.len())
    }

    fn check_motion(&self) -> Result<(), Malformed> {
        let Some(motion) = &self.motion else { return Ok(()) };
        let results = motion.tape.results.len();
        let room = Room { time: true, states: self.states.len(), ..self.room() };
        check("motion", &motion.tape, &room, results)?;
        match motion.factors.iter().find(|factor| **factor as usize >= results) {
            Some(factor) => broken("motion", format!("factor {factor} of {results} results")),
            None => Ok(()),
        }
    }

    /// Checks that steps and places of a solve are within their bounds, that columns are sorted,
    /// and that every entry of the pattern is given or solved for exactly once.
    fn check_solve(&self, part: &str, matrix: &MatrixTape) -> Result<(), Malformed> {
        let Some(solve) = &matrix.solve else { return Ok(()) };
        let factors = self.motion.as_ref().map_or(0, |motion| motion.factors.len());
        let is_row = |row: u32| row < solve.rows;
        let is_factor = |factor: u32| (factor as usize) < factors;
        let is_step = |step: &crate::SolveStep| {
            is_row(step.row)
                && step.scale.is_none_or(is_factor)
                && step.terms.iter().all(|&(factor, from)| is_factor(factor) && is_row(from))
        };
        let steps = solve.steps.iter().all(is_step);
        let is_place = |row: u32, column: u32| is_row(row) && column < solve.columns;
        let places = solve.right_sides.iter().all(|&(row, column)| is_place(row, column))
            && solve.solved.iter().all(|&(_, row, column)| is_place(row, column));
        let sorted = solve.right_sides.is_sorted_by_key(|(_, column)| *column)
            && solve.solved.is_sorted_by_key(|(_, _, column)| *column);
        // Bounds are checked first, so that a hostile model cannot request more memory than it has
        // bytes.
        let mut entries: Vec<u32> = solve.solved.iter().map(|(entry, _, _)| *entry).collect();
        entries.extend(&solve.given);
        entries.sort_unstable();
        let complete =
            entries.iter().map(|&entry| entry as usize).eq(0..matrix.pattern.entries.len());
        let small = solve.rows as usize <= 2 * self.coordinates.len() + self.constraints.len()
            && solve.columns as usize <= matrix.pattern.columns;
        if steps && places && sorted && complete && small {
            Ok(())
        } else {
            broken(part, "the entries to solve for are out of order or out of bounds")
        }
    }

    fn check_pattern(&self, part: &str, pattern: &SparsityPattern) -> Result<(), Malformed> {
        let states = self.states.len();
        let shape = match part {
            "rate_jacobian" => (states, states),
            "parameter_jacobian" => (states, self.parameters.len() + self.handed.len()),
            "constraint_matrix" => (self.constraints.len(), self.coordinates.len()),
            _ => (self.coordinates.len(), self.coordinates.len()),
        };
        if (pattern.rows, pattern.columns) != shape {
            return broken(part, format!("{} by {} entries", pattern.rows, pattern.columns));
        }
        let is_sorted = pattern.entries.is_sorted_by(|a, b| a < b);
        let is_within = |(row, column): &(u32, u32)| {
            (*row as usize) < pattern.rows && (*column as usize) < pattern.columns
        };
        if is_sorted && pattern.entries.iter().all(is_within) {
            Ok(())
        } else {
            broken(part, "its pattern is out of order or out of bounds")
        }
    }

    /// Checks the number of quadratures, and that a model without constraints has no constraint
    /// matrix.
    fn check_shapes(&self) -> Result<(), Malformed> {
        if self.quadratures > self.states.len() {
            return broken(
                "quadratures",
                format!("{} of {} states", self.quadratures, self.states.len()),
            );
        }
        let [n, m] = [self.constraints.len(), self.coordinates.len()];
        let pattern = &self.constraint_matrix.pattern;
        if n == 0 && (pattern.rows != 0 || !pattern.entries.is_empty() || pattern.columns != m) {
            return broken("constraint_matrix", "there are no constraints");
        }
        Ok(())
    }

    fn check_state(&self) -> Result<(), Malformed> {
        for state in &self.states {
            if let StateKind::Position(id) | StateKind::Velocity(id) = state.kind
                && id as usize >= self.coordinates.len()
            {
                return broken(&state.quantity.name.path, format!("there is no coordinate {id}"));
            }
        }
        let velocities = self.states.iter().filter(|s| matches!(s.kind, StateKind::Velocity(_)));
        if velocities.count() == self.coordinates.len() {
            Ok(())
        } else {
            broken("states", "not every coordinate has one velocity")
        }
    }

    fn check_numbers(&self) -> Result<(), Malformed> {
        let scales = self.states.iter().map(|state| ("scale of a state", state.scale));
        let values = self.all_parameters().map(|parameter| ("parameter", parameter.value));
        let run = [("run", self.run.from), ("run", self.run.until), ("run", self.run.rtol)];
        let mut numbers = scales.chain(values).chain(run);
        if let Some((part, value)) = numbers.find(|(_, value)| !value.is_finite()) {
            return broken(part, format!("{value} is not a finite number"));
        }
        self.tables.iter().try_for_each(check_table)
    }

    fn check_reference(&self, of: &Check) -> Result<(), Malformed> {
        let limits = [Some(of.tolerance), of.absolute];
        if limits.into_iter().flatten().any(|limit| !(limit.is_finite() && limit > 0.0)) {
            return broken(&of.name, "its tolerance is not above zero");
        }
        match &of.reference {
            Reference::Closed(closed) => {
                let tables = closed.tables.len();
                let room = Room { time: true, handed: 0, tables, ..self.room() };
                check(&of.name, &closed.tape, &room, 1)?;
                closed.tables.iter().try_for_each(check_table)
            }
            Reference::Values(rows) => {
                let finite = rows.as_flattened().iter().all(|value| value.is_finite());
                let increasing = rows.is_sorted_by(|[a, _], [b, _]| a < b);
                if finite && increasing && !rows.is_empty() {
                    return Ok(());
                }
                broken(&of.name, "its values are not finite numbers over increasing times")
            }
        }
    }

    fn check_events(&self) -> Result<(), Malformed> {
        for event in &self.events {
            let watched = event.when.iter().map(|(entry, _)| *entry);
            let mut entries = event.sets.iter().copied().chain(watched);
            if let Some(entry) = entries.find(|entry| *entry as usize >= self.states.len()) {
                return broken(&event.name.path, format!("mentions state {entry}"));
            }
        }
        for constraint in &self.constraints {
            if let Some(mode) = constraint.friction.filter(|it| *it as usize >= self.states.len()) {
                return broken(&constraint.name.path, format!("mentions state {mode}"));
            }
        }
        Ok(())
    }

    fn check_field(&self, field: &FieldModel) -> Result<(), Malformed> {
        let path = field.quantities[0].name.path.as_str();
        let parameters = field.parameters.len();
        let room = Room { time: true, states: FieldModel::STATES, ..self.room() };
        let tapes = field.functions().into_iter().map(|(name, tape)| {
            (
                name,
                tape,
                match name {
                    "inertia_gradient" => 1 + parameters,
                    "force" | "energy" | "initial" | "on_value_jacobian" | "on_slope_jacobian" => 2,
                    "power" => 3,
                    "force_jacobian" => 8,
                    "force_gradient" => 2 * (2 + parameters),
                    "places" => field.attachments.len() + 1,
                    "places_gradient" => (field.attachments.len() + 1) * parameters,
                    // inertia, on_value, on_value_by_time, on_slope
                    _ => 1,
                },
            )
        });
        for (name, tape, results) in tapes {
            check(&format!("{path}: {name}"), tape, &room, results)?;
        }
        let places = field.attachments.iter().map(|at| at.x);
        let sizes = field.scale.into_iter().chain([field.length]);
        if let Some(value) = places.chain(sizes).find(|value| !value.is_finite()) {
            return broken(path, format!("{value} is not a finite number"));
        }
        if field.parameters.iter().any(|id| *id as usize >= self.parameters.len()) {
            return broken(path, "depends on a parameter that does not exist");
        }
        let handed = machinist_contract::field::HANDED as u32;
        let is_out = |at: &&crate::Attachment| {
            at.handed.checked_add(handed).is_none_or(|end| end as usize > self.handed.len())
                || at.coordinate.is_some_and(|id| id as usize >= self.coordinates.len())
        };
        match field.attachments.iter().find(is_out) {
            Some(at) => broken(&at.name.path, "refers to values or a coordinate out of bounds"),
            None => Ok(()),
        }
    }
}

fn broken<T>(part: &str, reason: impl Into<String>) -> Result<T, Malformed> {
    Err(Malformed { part: part.to_owned(), reason: reason.into() })
}

fn check_table(table: &Table) -> Result<(), Malformed> {
    let mut numbers = table.knots.iter().chain(table.coefficients.as_flattened());
    if let Some(value) = numbers.find(|value| !value.is_finite()) {
        return broken("table", format!("{value} is not a finite number"));
    }
    let is_increasing = table.knots.is_sorted_by(|a, b| a < b);
    if table.knots.len() < 2 || table.coefficients.len() + 1 != table.knots.len() || !is_increasing
    {
        return broken(&table.name.path, "its knots do not fit its cubics");
    }
    Ok(())
}

/// Checks one tape.
fn check(part: &str, tape: &Tape, room: &Room, results: usize) -> Result<(), Malformed> {
    for (index, node) in tape.nodes.iter().enumerate() {
        if let Some(NodeId(late)) = node.op.operands().iter().find(|id| id.0 as usize >= index) {
            let reason = format!("node {index} reads node {late}, which does not come before it");
            return broken(part, reason);
        }
        if let Op::Held(place) = node.op
            && !room.slots.contains(&(place as usize))
        {
            return broken(part, format!("node {index} reads a slot at place {place}"));
        }
        let (entry, count, kind) = match node.op {
            Op::Literal(value) if !value.is_finite() => {
                return broken(part, format!("{value} is not a finite number"));
            }
            Op::Time if !room.time => {
                return broken(part, "only parameters may be read here");
            }
            Op::State(_) if room.states == 0 => {
                return broken(part, "only parameters may be read here");
            }
            Op::State(entry) => (entry, room.states, "state"),
            Op::Parameter(entry) => (entry, room.parameters, "parameter"),
            Op::Handed(entry) => (entry, room.handed, "handed number"),
            Op::Constant(entry) => (entry, room.constants, "constant"),
            Op::Motion(entry) => (entry, room.motion, "result of the motion"),
            Op::Table { table, .. } => (table.0, room.tables, "table"),
            _ => continue,
        };
        if entry as usize >= count {
            return broken(part, format!("node {index} reads {kind} {entry} of {count}"));
        }
    }
    if tape.results.len() != results {
        return broken(part, format!("{results} results expected, {} found", tape.results.len()));
    }
    match tape.results.iter().find(|id| id.0 as usize >= tape.nodes.len()) {
        Some(NodeId(result)) => broken(part, format!("result {result} is no node of the tape")),
        None => Ok(()),
    }
}

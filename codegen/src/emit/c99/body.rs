//! One tape as the body of a C function.
//!
//! Statements are in the tape's order, and expressions keep the tape's association. So C without
//! fused products gives the bits of [`machinist_model::evaluate`], as emitted Rust does.

use std::collections::BTreeSet;

use machinist_model::{Function, NodeId, Op, Tape};

use super::Real;
use super::expression::{Strength, Written, operation};
use super::names::Namer;
use crate::emit::EmitError;
use crate::emit::rust::batch::{Batch, Kind, Step, steps};
use crate::emit::rust::plan::{Place, plain};
use crate::emit::telling::{LONGEST_NAME, describe, is_temporary};

/// Names that a body may use.
#[derive(Clone, Copy)]
pub(super) struct Scope<'a> {
    /// The function, for messages.
    pub(super) function: &'a str,
    /// Number type.
    pub(super) real: Real,
    /// Variables that hold the entries of the state.
    pub(super) states: &'a [String],
    /// Expressions for the parameters.
    pub(super) parameters: &'a [Written],
    /// Members of the constants.
    pub(super) constants: &'a [String],
    /// Expressions for the results of the motion.
    pub(super) motion: &'a [String],
    /// Tables.
    pub(super) tables: &'a [String],
    /// Names that new variables must not take; includes those of the states.
    pub(super) namer: &'a Namer,
}

/// Arguments that a body reads.
#[derive(Debug, Default)]
#[allow(clippy::struct_excessive_bools, reason = "one for each argument of a function")]
pub(super) struct Reads {
    pub(super) time: bool,
    pub(super) parameters: bool,
    pub(super) constants: bool,
    pub(super) motion: bool,
    /// Entries of the state.
    pub(super) state: BTreeSet<usize>,
}

/// A body: statements, then one expression for each result.
pub(super) struct Body {
    pub(super) statements: Vec<String>,
    pub(super) results: Vec<String>,
    /// Number of statements that each result needs.
    pub(super) after: Vec<usize>,
    pub(super) reads: Reads,
}

/// Translates a tape to a body. With `spread_results`, results that are not leaves are variables.
pub(super) fn body(
    tape: &Tape,
    scope: &Scope<'_>,
    spread_results: bool,
) -> Result<Body, EmitError> {
    let steps = steps_of(tape, scope.real);
    let wide: Vec<Step> = wide_batches(&steps).cloned().map(Step::Batch).collect();
    let mut places = plain(tape, &wide, spread_results);
    let pairs = sine_cosine_pairs(tape, &mut places, (&wide, scope.real));
    let mut writer = Writer {
        tape,
        scope,
        places,
        names: vec![None; tape.nodes.len()],
        namer: scope.namer.clone(),
        temporaries: 0,
    };
    writer.name_from_spec();
    let mut statements = Vec::new();
    // Number of statements behind each node.
    let mut after = vec![0; tape.nodes.len()];
    for step in &steps {
        // In the order of the tape, in which the first of a pair comes first.
        let mut nodes: Vec<usize> = match step {
            Step::Node(index) => vec![*index],
            Step::Batch(batch) => batch.results().map(|id| id.0 as usize).collect(),
        };
        nodes.sort_unstable();
        match step {
            Step::Batch(batch) if is_wide(batch) => writer.batch(batch, &mut statements)?,
            _ => {
                for &index in &nodes {
                    writer.statement(index, pairs[index], &mut statements)?;
                }
            }
        }
        for index in nodes {
            let operands = tape.nodes[index].op.operands();
            after[index] = match writer.places[index] {
                Place::Statement => statements.len(),
                _ => operands.iter().map(|id| after[id.0 as usize]).max().unwrap_or(0),
            };
        }
    }
    let results = tape.results.iter().map(|&id| Ok(writer.operand(id)?.text));
    let results = results.collect::<Result<_, EmitError>>()?;
    let after = tape.results.iter().map(|id| after[id.0 as usize]).collect();
    let reads = reads(tape, &writer.places, scope);
    Ok(Body { statements, results, after, reads })
}

/// Number of arguments whose sines and cosines one call computes.
const WIDE: usize = 4;

fn is_wide(batch: &Batch) -> bool {
    batch.kind == Kind::SinCos && batch.members.len() >= WIDE
}

/// Returns the batches whose arguments one call takes.
pub(super) fn wide_batches(steps: &[Step]) -> impl Iterator<Item = &Batch> {
    steps.iter().filter_map(|step| match step {
        Step::Batch(batch) if is_wide(batch) => Some(batch),
        _ => None,
    })
}

/// Returns the needed nodes in the order of a body: that of the tape, unless several sines and
/// cosines are computed by one call.
pub(super) fn steps_of(tape: &Tape, real: Real) -> Vec<Step> {
    let grouped = if real == Real::Double { steps(tape) } else { Vec::new() };
    if wide_batches(&grouped).next().is_some() {
        return grouped;
    }
    (0..tape.nodes.len()).map(Step::Node).collect()
}

/// Returns the arguments that the written nodes read.
fn reads(tape: &Tape, places: &[Place], scope: &Scope<'_>) -> Reads {
    let mut reads = Reads::default();
    let written = tape.nodes.iter().zip(places).filter(|(_, place)| **place != Place::Nowhere);
    for (node, _) in written {
        match node.op {
            Op::Time => reads.time = true,
            Op::State(entry) => {
                reads.state.insert(entry as usize);
            }
            Op::Parameter(entry) => {
                reads.parameters |= scope.parameters[entry as usize].text.starts_with("p->");
            }
            Op::Constant(_) => reads.constants = true,
            Op::Motion(_) => reads.motion = true,
            _ => {}
        }
    }
    reads
}

/// Role of a node in a pair of sine and cosine of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pair {
    /// Computed by itself, or with several others.
    No,
    /// The first of the two on the tape, at which both are computed.
    First {
        sine: usize,
        cosine: usize,
    },
    Second,
}

/// Finds sines and cosines of the same argument, which one call computes, besides those of wide
/// batches. They become variables.
fn sine_cosine_pairs(
    tape: &Tape,
    places: &mut [Place],
    (wide, real): (&[Step], Real),
) -> Vec<Pair> {
    let mut pairs = vec![Pair::No; tape.nodes.len()];
    if real != Real::Double {
        return pairs;
    }
    let of = |index: usize| match tape.nodes[index].op {
        Op::Call(function @ (Function::Sin | Function::Cos), argument) => {
            Some((argument, function == Function::Sin))
        }
        _ => None,
    };
    let in_batches: BTreeSet<usize> =
        wide_batches(wide).flat_map(Batch::results).map(|id| id.0 as usize).collect();
    let is_open = |index: &usize| places[*index] != Place::Nowhere && !in_batches.contains(index);
    let mut open: Vec<(NodeId, bool, usize)> = Vec::new();
    for index in (0..tape.nodes.len()).filter(is_open) {
        let Some((argument, is_sine)) = of(index) else { continue };
        let other = open.iter().position(|&(of, sine, _)| of == argument && sine != is_sine);
        match other {
            None => open.push((argument, is_sine, index)),
            Some(other) => {
                let (_, _, first) = open.swap_remove(other);
                let (sine, cosine) = if is_sine { (index, first) } else { (first, index) };
                pairs[first] = Pair::First { sine, cosine };
                pairs[index] = Pair::Second;
            }
        }
    }
    for (place, pair) in places.iter_mut().zip(&pairs) {
        if *pair != Pair::No {
            *place = Place::Statement;
        }
    }
    pairs
}

struct Writer<'a> {
    tape: &'a Tape,
    scope: &'a Scope<'a>,
    places: Vec<Place>,
    names: Vec<Option<String>>,
    namer: Namer,
    temporaries: u32,
}

impl Writer<'_> {
    /// Claims the spec's names, before generated names can take them.
    fn name_from_spec(&mut self) {
        for (index, node) in self.tape.nodes.iter().enumerate() {
            if let (Some(name), Place::Statement) = (&node.name, self.places[index]) {
                self.names[index] = Some(self.namer.claim(name));
            }
        }
    }

    /// Adds the statement of a node, if it has one.
    fn statement(
        &mut self,
        index: usize,
        pair: Pair,
        statements: &mut Vec<String>,
    ) -> Result<(), EmitError> {
        if self.places[index] != Place::Statement {
            return Ok(());
        }
        let real = self.scope.real.name();
        match pair {
            Pair::No => {
                let value = self.node(index)?.text;
                let name = self.variable(index);
                statements.push(format!("const {real} {name} = {value};"));
            }
            Pair::First { sine, cosine } => {
                let argument = self.argument(index)?;
                let [sine, cosine] = [sine, cosine].map(|at| self.variable(at));
                statements.push(format!("{real} {sine}, {cosine};"));
                statements.push(format!("sine_and_cosine({argument}, &{sine}, &{cosine});"));
            }
            Pair::Second => {}
        }
        Ok(())
    }

    /// Adds the statements of calls for several sines and cosines, four each.
    fn batch(&mut self, batch: &Batch, statements: &mut Vec<String>) -> Result<(), EmitError> {
        let arguments = batch.members.iter().map(|member| Ok(self.operand(member.argument)?.text));
        let arguments = arguments.collect::<Result<Vec<_>, EmitError>>()?;
        let [angles, sines, cosines] =
            ["angles", "sines", "cosines"].map(|name| self.namer.claim(name));
        let (real, count) = (self.scope.real.name(), arguments.len());
        statements
            .push(format!("const {real} {angles}[{count}] = {{ {} }};", arguments.join(", ")));
        statements.push(format!("{real} {sines}[{count}], {cosines}[{count}];"));
        for first in (0..count).step_by(WIDE) {
            let group = first..count.min(first + WIDE);
            // Fewer are computed one by one: processors without vectors take no more for them.
            let (function, by, places) = match group.len() {
                WIDE => ("sines_and_cosines_of_four", "&", first..first + 1),
                _ => ("sine_and_cosine", "", group),
            };
            statements.extend(places.map(|k| {
                format!("{function}({by}{angles}[{k}], &{sines}[{k}], &{cosines}[{k}]);")
            }));
        }
        for (place, member) in batch.members.iter().enumerate() {
            for (result, from) in member.results.iter().zip([&sines, &cosines]) {
                let Some(id) = result else { continue };
                let name = self.variable(id.0 as usize);
                statements.push(format!("const {real} {name} = {from}[{place}];"));
            }
        }
        Ok(())
    }

    /// Returns the variable of a node, which is named on first use.
    fn variable(&mut self, index: usize) -> String {
        if let Some(name) = &self.names[index] {
            return name.clone();
        }
        let telling = describe(self.tape, &self.tape.nodes[index].op, |id| self.word(id));
        let telling = telling.filter(|name| name.len() <= LONGEST_NAME);
        let wanted = telling.unwrap_or_else(|| {
            self.temporaries += 1;
            format!("t{}", self.temporaries - 1)
        });
        let name = self.namer.claim(&wanted);
        self.names[index] = Some(name.clone());
        name
    }

    fn operand(&mut self, id: NodeId) -> Result<Written, EmitError> {
        let index = id.0 as usize;
        if self.places[index] == Place::Statement {
            return Ok(Written::call(self.variable(index)));
        }
        self.node(index)
    }

    /// Returns the expression of a node.
    fn node(&mut self, index: usize) -> Result<Written, EmitError> {
        let (op, scope) = (self.tape.nodes[index].op, self.scope);
        operation(&op, scope, &mut |id| self.operand(id))
    }

    /// Returns the argument of a call.
    fn argument(&mut self, index: usize) -> Result<String, EmitError> {
        match self.tape.nodes[index].op {
            Op::Call(_, argument) => Ok(self.operand(argument)?.at_least(Strength::Sum)),
            _ => Ok(self.node(index)?.text),
        }
    }

    /// Returns the name of an operand, if it is descriptive.
    fn word(&self, id: NodeId) -> Option<String> {
        let index = id.0 as usize;
        let telling = |name: &str| (!is_temporary(name)).then(|| name.to_owned());
        if let (Place::Statement, Some(name)) = (self.places[index], &self.names[index]) {
            return telling(name);
        }
        let op = &self.tape.nodes[index].op;
        match *op {
            Op::Time => Some("time".to_owned()),
            Op::State(entry) => Some(self.scope.states[entry as usize].clone()),
            Op::Parameter(entry) => {
                self.scope.parameters[entry as usize].text.strip_prefix("p->").and_then(telling)
            }
            Op::Constant(entry) => telling(&self.scope.constants[entry as usize]),
            _ if self.places[index] != Place::Statement => {
                describe(self.tape, op, |id| self.word(id))
            }
            _ => None,
        }
    }
}

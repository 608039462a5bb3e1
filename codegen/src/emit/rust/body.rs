//! One tape as the body of a function.
//!
//! Statements are in the tape's order except for batched calls ([`super::batch`]), and
//! expressions keep the tape's association. So emitted code and [`machinist_model::evaluate`]
//! agree bit for bit if the target has no fused products; see [`super::fuse`]. A body is one
//! function of any length; it could be split by cutting `statements` where few variables are
//! alive.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens as _, format_ident, quote};

use super::batch::{Batch, Kind, Step, steps};
use super::fuse::{Fused, fuse};
use super::names::{Namer, identifier};
use super::operation::{Expressions, Strength, Written};
use super::plan::{Place, plan};
use crate::emit::EmitError;
use crate::emit::telling::{LONGEST_NAME, describe, is_temporary};
use machinist_model::{NodeId, Op, Tape};

/// Names that a body may use.
pub(super) struct Scope<'a> {
    /// Local variables, one for each entry of the state.
    pub(super) states: &'a [Ident],
    /// Fields of `Parameters`: the machine's, those that fields of the machine set, and slots.
    pub(super) parameters: &'a [Ident],
    /// Number of fields that are the machine's.
    pub(super) own: usize,
    /// Values known before: fields of `Constants`, or variables if `is_in_loop`.
    pub(super) constants: &'a [Ident],
    /// Expressions for the results of the motion.
    pub(super) motion: &'a [TokenStream],
    /// Constants of the tables.
    pub(super) tables: &'a [Ident],
    /// True if it runs for many points in a loop, which compilers vectorize.
    pub(super) is_in_loop: bool,
    /// Names that new variables must not take; includes all of the above.
    pub(super) namer: &'a Namer,
}

impl Scope<'_> {
    /// Returns the name of a value that is an input of the run.
    pub(super) fn given(&self, op: &Op) -> Option<&Ident> {
        match *op {
            Op::Parameter(place) | Op::Held(place) => self.parameters.get(place as usize),
            Op::Handed(entry) => self.parameters.get(self.own + entry as usize),
            Op::Constant(entry) => self.constants.get(entry as usize),
            _ => None,
        }
    }
}

/// Arguments that a body reads.
#[derive(Default)]
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
    pub(super) statements: Vec<TokenStream>,
    pub(super) results: Vec<TokenStream>,
    pub(super) reads: Reads,
}

/// Names for results without a name in the spec.
#[derive(Default)]
pub(super) struct ResultNames {
    /// One name for each result, or none at all.
    pub(super) names: Vec<String>,
    /// True if every result that is more than a variable gets a `let`; false if only those used
    /// more than once.
    pub(super) spread: bool,
}

/// Translates a tape that [`super::check`] has passed to a body.
pub(super) fn body(
    function: &'static str,
    tape: &Tape,
    scope: &Scope<'_>,
    result_names: &ResultNames,
) -> Result<Body, EmitError> {
    let fused = fuse(tape);
    let steps = if scope.is_in_loop {
        (0..tape.nodes.len()).map(Step::Node).collect()
    } else {
        steps(tape)
    };
    let mut writer = Writer {
        function,
        tape,
        scope,
        places: plan(tape, &fused, &steps, result_names.spread),
        fused,
        names: vec![None; tape.nodes.len()],
        spare_names: vec![None; tape.nodes.len()],
        namer: scope.namer.clone(),
        temporaries: 0,
        reads: Reads::default(),
    };
    writer.name_from_spec()?;
    writer.name_results(result_names)?;
    let mut statements = Vec::new();
    for step in &steps {
        match step {
            Step::Node(index) if writer.places[*index] == Place::Statement => {
                let value = writer.node(*index)?.tokens;
                let name = writer.variable(*index);
                statements.push(quote!(let #name = #value;));
            }
            Step::Node(_) => {}
            Step::Batch(batch) => statements.push(writer.batch(batch)?),
        }
    }
    let results = tape.results.iter().map(|&id| Ok(writer.operand(id)?.tokens));
    let results = results.collect::<Result<_, EmitError>>()?;
    Ok(Body { statements, results, reads: writer.reads })
}

struct Writer<'a> {
    function: &'static str,
    tape: &'a Tape,
    scope: &'a Scope<'a>,
    places: Vec<Place>,
    fused: Vec<Option<Fused>>,
    /// Names of the variables: those of the spec and those generated so far.
    names: Vec<Option<Ident>>,
    /// Names for nodes without a more descriptive one.
    spare_names: Vec<Option<String>>,
    namer: Namer,
    temporaries: u32,
    reads: Reads,
}

impl Expressions for Writer<'_> {
    fn operand(&mut self, id: NodeId) -> Result<Written, EmitError> {
        let index = id.0 as usize;
        if self.places[index] == Place::Statement {
            let name = self.variable(index);
            return Ok(Written::call(quote!(#name)));
        }
        self.node(index)
    }

    fn scope(&self) -> &Scope<'_> {
        self.scope
    }

    fn reads(&mut self) -> &mut Reads {
        &mut self.reads
    }

    fn function(&self) -> &'static str {
        self.function
    }
}

impl Writer<'_> {
    /// Claims the spec's names, before generated names can take them.
    fn name_from_spec(&mut self) -> Result<(), EmitError> {
        for (index, node) in self.tape.nodes.iter().enumerate() {
            if let (Some(name), Place::Statement) = (&node.name, self.places[index]) {
                identifier(name)?;
                self.names[index] = Some(self.namer.claim(name));
            }
        }
        Ok(())
    }

    /// Names results. In an array, a result that other expressions use too (such as an inverse
    /// inertia) is preferably named by its meaning.
    fn name_results(&mut self, results: &ResultNames) -> Result<(), EmitError> {
        let operands = self.tape.nodes.iter().flat_map(|node| node.op.operands());
        let operands: BTreeSet<NodeId> = operands.collect();
        for (result, name) in self.tape.results.iter().zip(&results.names) {
            let index = result.0 as usize;
            if self.places[index] != Place::Statement || self.names[index].is_some() {
                continue;
            }
            identifier(name)?;
            if results.spread && operands.contains(result) {
                self.spare_names[index].get_or_insert_with(|| name.clone());
            } else {
                self.names[index] = Some(self.namer.claim(name));
            }
        }
        Ok(())
    }

    /// Returns the variable of a node, which is named on first use.
    fn variable(&mut self, index: usize) -> Ident {
        if let Some(name) = &self.names[index] {
            return name.clone();
        }
        let telling = describe(self.tape, &self.tape.nodes[index].op, |id| self.word(id));
        let telling = telling.filter(|name| name.len() <= LONGEST_NAME);
        let wanted = telling.or_else(|| self.spare_names[index].take()).unwrap_or_else(|| {
            self.temporaries += 1;
            format!("t{}", self.temporaries - 1)
        });
        let name = self.namer.claim(&wanted);
        self.names[index] = Some(name.clone());
        name
    }

    fn operand_at_least(&mut self, id: NodeId, least: Strength) -> Result<TokenStream, EmitError> {
        Ok(self.operand(id)?.at_least(least))
    }

    /// Returns the expression of a node.
    fn node(&mut self, index: usize) -> Result<Written, EmitError> {
        if let Some(fused) = self.fused[index] {
            return self.fused(&fused);
        }
        match self.tape.nodes[index].op {
            Op::Neg(a) => self.opposite(a),
            op => self.operation(&op),
        }
    }

    /// Returns one call for several arguments.
    fn batch(&mut self, batch: &Batch) -> Result<TokenStream, EmitError> {
        let arguments = batch.members.iter().map(|member| self.operand(member.argument));
        let arguments = arguments.collect::<Result<Vec<_>, _>>()?;
        let mut result = |id: Option<NodeId>| match id {
            Some(id) => self.variable(id.0 as usize),
            None => format_ident!("_"),
        };
        let results = batch.members.iter().map(|member| {
            let [first, second] = member.results;
            match batch.kind {
                Kind::Tanh => result(first).to_token_stream(),
                Kind::SinCos => {
                    let (sine, cosine) = (result(first), result(second));
                    quote!((#sine, #cosine))
                }
            }
        });
        let results: Vec<TokenStream> = results.collect();
        let method = match batch.kind {
            Kind::SinCos => "sin_cos",
            Kind::Tanh => "tanh",
        };
        if let [result] = results.as_slice() {
            let method = format_ident!("{method}");
            let argument = arguments.into_iter().map(|argument| argument.at_least(Strength::Call));
            return Ok(quote!(let #result = #(#argument)*.#method();));
        }
        let method = format_ident!("{method}_each");
        let arguments = arguments.into_iter().map(|argument| argument.tokens);
        Ok(quote!(let [#(#results),*] = R::#method([#(#arguments),*]);))
    }

    /// Returns a sum that contains a product.
    fn fused(&mut self, fused: &Fused) -> Result<Written, EmitError> {
        let summand = if fused.is_summand_negative {
            self.opposite(fused.summand)?.at_least(Strength::Call)
        } else {
            self.operand_at_least(fused.summand, Strength::Call)?
        };
        let [a, b] = fused.factors;
        let (a, b) = (self.operand(a)?.tokens, self.operand(b)?.tokens);
        let method = if fused.is_product_negative { "sub_product" } else { "add_product" };
        let method = format_ident!("{method}");
        Ok(Written::call(quote!(#summand.#method(#a, #b))))
    }

    /// Returns -a. Its sign is moved into a literal factor if there is one, at no cost.
    fn opposite(&mut self, id: NodeId) -> Result<Written, EmitError> {
        let index = id.0 as usize;
        let is_inline = self.places[index] == Place::Inline && self.fused[index].is_none();
        match self.tape.nodes[index].op {
            Op::Literal(value) => self.literal(-value),
            Op::Neg(a) if is_inline => self.operand(a),
            Op::Mul(a, b) if is_inline && self.has_literal(a) => {
                let a = self.opposite(a)?;
                Ok(a.times(self.operand(b)?))
            }
            _ => Ok(self.operand(id)?.minus()),
        }
    }

    /// Reports whether an expression is a literal or has one as its first factor.
    fn has_literal(&self, id: NodeId) -> bool {
        let index = id.0 as usize;
        match self.tape.nodes[index].op {
            Op::Literal(_) => true,
            Op::Mul(a, _) => {
                self.places[index] == Place::Inline
                    && self.fused[index].is_none()
                    && self.has_literal(a)
            }
            _ => false,
        }
    }

    /// Returns the name of an operand, if it is descriptive.
    fn word(&self, id: NodeId) -> Option<String> {
        let index = id.0 as usize;
        if let (Place::Statement, Some(name)) = (self.places[index], &self.names[index]) {
            let name = name.to_string();
            return (!is_temporary(&name)).then_some(name);
        }
        let op = &self.tape.nodes[index].op;
        match *op {
            Op::Time => Some("time".to_owned()),
            Op::State(entry) => Some(self.scope.states[entry as usize].to_string()),
            Op::Parameter(_) | Op::Handed(_) | Op::Held(_) | Op::Constant(_) => {
                let name = self.scope.given(op)?.to_string();
                (!is_temporary(&name)).then_some(name)
            }
            _ if self.places[index] != Place::Statement => {
                describe(self.tape, op, |id| self.word(id))
            }
            _ => None,
        }
    }
}

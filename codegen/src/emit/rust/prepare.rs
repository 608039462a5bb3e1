//! `prepare`: values that depend on parameters only, computed once a run.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::body::{ResultNames, Scope, body};
use super::functions::{derivatives, documentation};
use super::names::Namer;
use crate::emit::EmitError;
use machinist_model::hoist::Hoisted;
use machinist_model::{Model, NodeId, Op, Tape};

/// The constants of a scene, and its rate and Jacobians that read them.
pub(super) struct Prepare {
    pub(super) hoisted: Hoisted,
    /// Fields of `Constants`.
    pub(super) constants: Vec<Ident>,
    statements: Vec<TokenStream>,
}

impl Prepare {
    pub(super) fn new(
        model: &Model,
        states: &[Ident],
        parameters: &[Ident],
        tables: &[Ident],
        locals: &Namer,
    ) -> Result<Self, EmitError> {
        let mut hoisted = Hoisted::new(model);
        name_entries(&mut hoisted, model, states);
        let scope = Scope {
            states,
            parameters,
            own: model.parameters.len(),
            constants: &[],
            motion: &[],
            tables,
            is_in_loop: false,
            namer: locals,
        };
        let names = ResultNames { names: Vec::new(), spread: true };
        let body = body("prepare", &hoisted.constants, &scope, &names)?;
        // Every constant has a `let`, so its expression is a name.
        let constants = body.results.iter().map(|name| syn::parse2(name.clone()));
        let constants: Vec<Ident> = constants
            .collect::<Result<_, _>>()
            .map_err(|error| EmitError::Unparsable { reason: error.to_string() })?;
        Ok(Self { hoisted, constants, statements: body.statements })
    }

    /// Reports whether nothing is computed once a run.
    pub(super) fn is_empty(&self) -> bool {
        self.constants.is_empty()
    }

    /// Returns the function that computes them; `None` if there are none.
    pub(super) fn items(&self) -> Option<TokenStream> {
        let (constants, statements) = (&self.constants, &self.statements);
        let docs = documentation(
            "Returns the constants of `rate` and its Jacobians from the parameters.",
            self.hoisted.operations(),
        );
        (!self.is_empty()).then(|| {
            quote! {
                #docs
                #[must_use]
                #[inline]
                pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
                    #(#statements)*
                    Constants { #(#constants),* }
                }
            }
        })
    }
}

/// Names constants that are just an entry of the Jacobian after that entry.
fn name_entries(hoisted: &mut Hoisted, model: &Model, states: &[Ident]) {
    if model.rate_jacobian.solve.is_some() {
        return;
    }
    let rates: Vec<String> = states.iter().map(|state| format!("{state}_dot")).collect();
    let names = derivatives(&model.rate_jacobian.pattern, &rates, states);
    let (jacobian, rate) = (&hoisted.rate_jacobian, &hoisted.rate);
    let operands = |tape: &Tape| -> HashSet<NodeId> {
        tape.nodes.iter().flat_map(|node| node.op.operands()).collect()
    };
    let constant = |tape: &Tape, id: &NodeId| match tape[*id].op {
        Op::Constant(constant) => Some(constant),
        _ => None,
    };
    let read = |tape: &Tape| operands(tape).iter().filter_map(|id| constant(tape, id)).collect();
    let mut known: HashSet<u32> = read(jacobian);
    known.extend(read(rate));
    known.extend(rate.results.iter().filter_map(|id| constant(rate, id)));
    let parts = operands(&hoisted.constants);
    for (result, name) in jacobian.results.iter().zip(names) {
        let Some(constant) = constant(jacobian, result) else { continue };
        let id = hoisted.constants.results[constant as usize];
        let is_known = parts.contains(&id) || known.contains(&constant);
        let node = &mut hoisted.constants.nodes[id.0 as usize];
        if !is_known && node.name.is_none() {
            node.name = Some(name);
        }
    }
}

//! `Motion` and `motion`: values that several functions need, and solutions for matrices with its
//! factors.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::{ResultNames, Scope, body};
use super::functions::{destructure, documentation};
use super::names::{argument, constant_name};
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_contract::implicit::LANES;
use machinist_model::hoist::Hoisted;
use machinist_model::{Model, Solve, operations};

/// Names that bodies bind if there is a motion, which other variables must not take.
pub(super) const LOCALS: [&str; 3] = ["m", "motion", "x"];

/// Motion of a scene.
#[derive(Default)]
pub(super) struct Motion {
    /// Expression for each result where it is read.
    pub(super) results: Vec<TokenStream>,
    /// The struct and the function; `None` if functions are independent.
    pub(super) items: Option<TokenStream>,
}

impl Motion {
    /// Returns the motion; `scope` is that of functions with constants.
    pub(super) fn new(
        model: &Model,
        hoisted: &Hoisted,
        scope: &Scope<'_>,
    ) -> Result<Self, EmitError> {
        let Some(motion) = &model.motion else { return Ok(Self::default()) };
        let names = ResultNames { names: Vec::new(), spread: true };
        let body = body("motion", &hoisted.motion, scope, &names)?;
        let mut results = vec![TokenStream::new(); body.results.len()];
        let mut factors = Vec::new();
        for &factor in &motion.factors {
            let place = Literal::usize_unsuffixed(factors.len());
            results[factor as usize] = quote!(m.factors[#place]);
            factors.push(&body.results[factor as usize]);
        }
        // Every result that is not a factor is an operation, which has a `let` and so a name.
        let named = (0..results.len()).filter(|k| !motion.factors.contains(&(*k as u32)));
        let mut fields: Vec<Ident> = Vec::new();
        for result in named {
            let name: Ident = syn::parse2(body.results[result].clone())
                .map_err(|error| EmitError::Unparsable { reason: error.to_string() })?;
            results[result] = quote!(m.#name);
            fields.push(name);
        }
        let reads = &body.reads;
        let time = argument(reads.time, "time");
        let state = argument(!reads.state.is_empty(), "state");
        let p = argument(reads.parameters, "p");
        let destructured = destructure(scope.states, &reads.state);
        let constants = (!scope.constants.is_empty()).then(|| {
            let c = argument(reads.constants, "c");
            quote!(, #c: &Constants<R>)
        });
        let count = Literal::usize_unsuffixed(factors.len());
        let has_factors = !factors.is_empty();
        let factors_field = has_factors.then(|| quote!(pub factors: [R; #count],));
        let factors_value = has_factors.then(|| quote!(factors: [#(#factors),*],));
        let statements = &body.statements;
        let docs = documentation(
            "Accelerations, factors of the linear equations they solve, and whatever else several \
             functions need.",
            operations(&motion.tape),
        );
        let meaning =
            doc(["What several functions need of the motion; `motion` says what each is."]);
        let items = quote! {
            #meaning
            #[allow(missing_docs, reason = "`motion` says what each is")]
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct Motion<R> {
                #factors_field
                #(pub #fields: R,)*
            }
            #docs
            #[must_use]
            pub fn motion<R: Real>(
                #time: R,
                #state: &[R; STATES],
                #p: &Parameters<R>
                #constants
            ) -> Motion<R> {
                #destructured
                #(#statements)*
                Motion { #factors_value #(#fields),* }
            }
        };
        Ok(Self { results, items: Some(items) })
    }
}

/// Returns the name of the steps of a function that solves.
fn steps_name(function: &str) -> Ident {
    format_ident!("{}_STEPS", constant_name(function))
}

/// Returns the steps of a function that solves.
pub(super) fn statics(function: &str, solve: &Solve) -> TokenStream {
    let number = |value: u32| Literal::u32_unsuffixed(value);
    let pairs = |pairs: &[(u32, u32)]| {
        let pairs = pairs.iter().map(|&(a, b)| {
            let (a, b) = (number(a), number(b));
            quote!((#a, #b))
        });
        quote!(&[#(#pairs),*])
    };
    let steps = solve.steps.iter().map(|step| {
        let (row, terms) = (number(step.row), pairs(&step.terms));
        match step.scale {
            None => quote!(Step::less(#row, #terms)),
            Some(scale) => {
                let scale = number(scale);
                quote!(Step::scaled(#row, #scale, #terms))
            }
        }
    });
    let name = steps_name(function);
    quote! {
        static #name: &[Step<'static>] = &[#(#steps),*];
    }
}

/// Returns the end of a function that solves: right sides, solution, and its value.
pub(super) fn solved(function: &str, solve: &Solve, results: &[TokenStream]) -> TokenStream {
    let number = |value: u32| Literal::u32_unsuffixed(value);
    let steps = steps_name(function);
    // A few additional columns are cheaper than single columns.
    let padded = solve.columns.next_multiple_of(LANES as u32 / 2);
    let (rows, columns) = (number(solve.rows), number(padded));
    let (given, sides) = results.split_at(solve.given.len());
    let sides = solve.right_sides.iter().zip(sides).map(|(&(row, column), side)| {
        let (row, column) = (number(row), number(column));
        quote!(x[#row][#column] = #side;)
    });
    let given = solve.given.iter().zip(given).map(|(&entry, value)| (entry, value.clone()));
    let solved = solve.solved.iter().map(|&(entry, row, column)| {
        let (row, column) = (number(row), number(column));
        (entry, quote!(x[#row][#column]))
    });
    let mut values: Vec<(u32, TokenStream)> = given.chain(solved).collect();
    values.sort_by_key(|(entry, _)| *entry);
    let values = values.into_iter().map(|(_, value)| value);
    quote! {
        let mut x = [[R::literal(0.0); #columns]; #rows];
        #(#sides)*
        substitute(#steps.iter().copied(), &m.factors, &mut x);
        [#(#values),*]
    }
}

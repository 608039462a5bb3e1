//! Free functions of an emitted module, one for each tape.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{Body, ResultNames, body};
use super::items::phantom;
use super::layout::WIDTH;
use super::motion::{solved, statics as steps};
use super::names::argument;
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_model::functions::{FunctionId, FunctionRow, Gives, Reads};
use machinist_model::{SparsityPattern, Tape, operations};

/// Returns all functions, in the order of their table.
pub(super) fn functions(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let hoisted = &scene.prepare.hoisted;
    let functions = scene.model.functions().map(|row| match row.id {
        _ if scene.prepare.is_empty() => function(scene, row, None),
        FunctionId::Rate => function(scene, row, Some(&hoisted.rate)),
        FunctionId::RateJacobian => function(scene, row, Some(&hoisted.rate_jacobian)),
        FunctionId::ParameterJacobian if scene.gives_jacobians_at_once() => jacobians(scene),
        FunctionId::ParameterJacobian => function(scene, row, Some(&hoisted.parameter_jacobian)),
        _ => function(scene, row, None),
    });
    functions.collect()
}

/// Returns the function of a row. For a tape that reads constants it is the `prepared_` function,
/// from which the contract derives the other.
fn function(
    scene: &Scene<'_>,
    row: &FunctionRow,
    prepared: Option<&Tape>,
) -> Result<TokenStream, EmitError> {
    let is_prepared = prepared.is_some();
    let name = if is_prepared { row.prepared.unwrap_or(row.name) } else { row.name };
    let tape = prepared.unwrap_or_else(|| (row.tape)(scene.model));
    let solve = scene.model.solve(row.id);
    // Results of a solution have no names of their own.
    let names = solve.map_or_else(|| result_names(scene, row), |_| ResultNames::default());
    let Body { statements, results, reads } =
        body(row.name, tape, &scene.scope(&scene.prepare.constants), &names)?;
    let reads_motion = reads.motion || solve.is_some();
    let motion = reads_motion.then(|| motion_of(scene, is_prepared));
    let p = argument(reads.parameters || reads_motion, "p");
    let time = argument(reads.time || reads_motion, "time");
    let state = argument(!reads.state.is_empty() || reads_motion, "state");
    let c = argument(reads.constants || (reads_motion && is_prepared), "c");
    let constants = is_prepared.then(|| quote!(, #c: &Constants<R>));
    let state_and_time =
        (row.reads == Reads::Motion).then(|| quote!(#time: R, #state: &[R; STATES],));
    let (return_type, value) = match (solve, row.matrix) {
        (Some(solve), Some(matrix)) => {
            let length = Literal::usize_unsuffixed(matrix(scene.model).pattern.entries.len());
            (quote!([R; #length]), solved(row.name, solve, &results))
        }
        _ => returned(scene, row, &results),
    };
    let statics = solve.map(|solve| steps(row.name, solve));
    let destructured = destructure(&scene.states, &reads.state);
    let doc = if is_prepared {
        format!("As `{}`, with the constants of the parameters from `prepare`.", row.name)
    } else {
        row.doc.to_owned()
    };
    let docs = documentation(&doc, operations(tape));
    let inline = (row.id == FunctionId::Rate).then(|| quote!(#[inline]));
    let name = format_ident!("{name}");
    Ok(quote! {
        #docs
        #[must_use]
        #inline
        pub fn #name<R: Real>(#state_and_time #p: &Parameters<R> #constants) -> #return_type {
            #destructured
            #motion
            #(#statements)*
            #value
        }
        #statics
    })
}

/// Name of the function that computes both Jacobians at once.
pub(super) const JACOBIANS: &str = "prepared_jacobians";

/// Returns the function for dy'/dy and dy'/dp at once, given constants. The contract derives
/// dy'/dp alone from it.
fn jacobians(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let tape = &scene.prepare.hoisted.jacobians;
    let names = [FunctionId::RateJacobian, FunctionId::ParameterJacobian];
    let names = names.iter().flat_map(|id| result_names(scene, id.row()).names).collect();
    let names = ResultNames { names, spread: true };
    let Body { statements, results, reads } =
        body(JACOBIANS, tape, &scene.scope(&scene.prepare.constants), &names)?;
    let p = argument(reads.parameters, "p");
    let time = argument(reads.time, "time");
    let state = argument(!reads.state.is_empty(), "state");
    let c = argument(reads.constants, "c");
    let destructured = destructure(&scene.states, &reads.state);
    let docs = documentation(
        "`rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from \
         `prepare`.",
        operations(tape),
    );
    let (name, length) = (format_ident!("{JACOBIANS}"), Literal::usize_unsuffixed(results.len()));
    Ok(quote! {
        #docs
        #[must_use]
        pub fn #name<R: Real>(
            #time: R,
            #state: &[R; STATES],
            #p: &Parameters<R>,
            #c: &Constants<R>
        ) -> [R; #length] {
            #destructured
            #(#statements)*
            [#(#results),*]
        }
    })
}

/// Returns the statement that binds the motion as `m`.
fn motion_of(scene: &Scene<'_>, is_prepared: bool) -> TokenStream {
    let constants = match (scene.prepare.is_empty(), is_prepared) {
        (true, _) => quote!(),
        (false, true) => quote!(, c),
        (false, false) => quote!(, &prepare(p)),
    };
    quote!(let m = &motion(time, state, p #constants);)
}

/// Returns the type of a function's result, and the expression for it.
fn returned(
    scene: &Scene<'_>,
    row: &FunctionRow,
    results: &[TokenStream],
) -> (TokenStream, TokenStream) {
    let array = quote!([#(#results),*]);
    let structure = |name: &str, fields: &[Ident]| {
        let (name, phantom) = (format_ident!("{name}"), phantom(fields));
        let fields = fields.iter().zip(results).map(|(field, result)| field_of(field, result));
        (quote!(#name<R>), quote!(#name { #(#fields,)* #phantom }))
    };
    match row.gives {
        Gives::Numbers(length) => {
            let length = format_ident!("{length}");
            (quote!([R; #length]), array)
        }
        Gives::Matrix(_) => {
            let length = Literal::usize_unsuffixed(results.len());
            (quote!([R; #length]), array)
        }
        Gives::Record(name, _) => structure(name, &scene.outputs),
        Gives::Structure(name, fields) => {
            let fields: Vec<Ident> = fields.iter().map(|name| format_ident!("{name}")).collect();
            structure(name, &fields)
        }
    }
}

/// Returns `field: result`, or `field` if the result is a variable of that name.
fn field_of(field: &Ident, result: &TokenStream) -> TokenStream {
    if *field == result.to_string() { quote!(#field) } else { quote!(#field: #result) }
}

/// Returns the meaning of a function and its number of operations, in lines that fit.
pub(super) fn documentation(meaning: &str, operations: usize) -> TokenStream {
    let operations = match operations {
        0 => "No operations.".to_owned(),
        1 => "1 operation.".to_owned(),
        many => format!("{many} operations."),
    };
    let mut lines = vec![String::new()];
    for word in meaning.split(' ').chain(operations.split(' ')) {
        let line = lines.last_mut().expect("there is a line");
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= WIDTH - 4 {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(word.to_owned());
        }
    }
    doc(lines)
}

/// Binds the states that a body reads: by one pattern if they are many, one by one if they are
/// few among many.
pub(super) fn destructure(states: &[Ident], read: &BTreeSet<usize>) -> Option<TokenStream> {
    let span = read.last()? + 1;
    if span > 8 && read.len() * 3 < span {
        let lets = read.iter().map(|&index| {
            let (name, index) = (&states[index], Literal::usize_unsuffixed(index));
            quote!(let #name = state[#index];)
        });
        return Some(quote!(#(#lets)*));
    }
    let entries = (0..span).map(|index| {
        let name = &states[index];
        if read.contains(&index) { quote!(#name) } else { quote!(_) }
    });
    let rest = (span < states.len()).then(|| quote!(..));
    Some(quote!(let [#(#entries,)* #rest] = *state;))
}

/// Returns names for results that the spec does not name. If there are any, or if the results are
/// entries of an array, each gets a `let`, so that the array is a list of names.
fn result_names(scene: &Scene<'_>, row: &FunctionRow) -> ResultNames {
    let model = scene.model;
    let rates = || scene.states.iter().map(|state| format!("{state}_dot"));
    let derivatives = |of: &[Ident]| match row.pattern {
        Some(pattern) => derivatives(pattern(model), &rates().collect::<Vec<_>>(), of),
        None => vec![],
    };
    let of_events = |what: &str| {
        let events = model.events.iter();
        events.map(|event| format!("{}_{what}", event.name.ident)).collect()
    };
    let of_constraints = |what: &str| {
        let constraints = model.constraints.iter();
        constraints.map(|constraint| format!("{}_{what}", constraint.name.ident)).collect()
    };
    let of_kinks = |what: &str| {
        (1..=model.kink_guards.results.len()).map(|number| format!("{what}_{number}")).collect()
    };
    let names: Vec<String> = match row.id {
        FunctionId::InitialState
        | FunctionId::Discontinuities
        | FunctionId::MassMatrix
        | FunctionId::ConstraintMatrix => vec![],
        FunctionId::Rate => rates().collect(),
        FunctionId::Forcing => {
            let coordinates = model.coordinates.iter();
            coordinates.map(|c| format!("{}_forcing", c.position.name.ident)).collect()
        }
        FunctionId::RateJacobian => derivatives(&scene.states),
        FunctionId::ParameterJacobian => derivatives(&scene.parameters),
        FunctionId::TimeDerivative => rates().map(|rate| format!("{rate}_by_time")).collect(),
        FunctionId::Outputs => scene.outputs.iter().map(ToString::to_string).collect(),
        FunctionId::Energy | FunctionId::PowerBalance => match row.gives {
            Gives::Structure(_, fields) => fields.iter().map(|&name| name.to_owned()).collect(),
            _ => vec![],
        },
        FunctionId::Guards => of_events("guard"),
        FunctionId::GuardRates => of_events("guard_rate"),
        FunctionId::Resets => {
            let sets = model.events.iter().flat_map(|event| {
                let states = event.sets.iter().filter_map(|s| scene.states.get(*s as usize));
                states.map(|state| format!("{state}_after_{}", event.name.ident))
            });
            sets.collect()
        }
        FunctionId::ConstraintValues => of_constraints("value"),
        FunctionId::ConstraintRates => of_constraints("rate"),
        FunctionId::KinkGuards => of_kinks("kink"),
        FunctionId::KinkRates => of_kinks("kink_rate"),
        FunctionId::SaturatingArguments => (1..=model.saturating_arguments.results.len())
            .map(|number| format!("argument_{number}"))
            .collect(),
    };
    let is_array = matches!(row.gives, Gives::Numbers(_) | Gives::Matrix(_));
    ResultNames { spread: is_array && !names.is_empty(), names }
}

/// Returns `phi_dot_dot_by_phi` for every nonzero of a Jacobian.
pub(super) fn derivatives(
    pattern: &SparsityPattern,
    rows: &[String],
    columns: &[Ident],
) -> Vec<String> {
    let names = pattern.entries.iter().map(|&(row, column)| {
        let row = rows.get(row as usize).map_or("dot", String::as_str);
        let column = columns.get(column as usize).map_or("it".to_owned(), ToString::to_string);
        format!("{row}_by_{column}")
    });
    names.collect()
}

//! The free functions of an emitted module, one for each tape.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{Body, ResultNames, Scope, body};
use super::items::phantom;
use super::motion::{solved, statics as statics_of};
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_model::functions::{FunctionId, FunctionRow};
use machinist_model::{SparsityPattern, Tape, operations};

/// All functions, in the order of their table.
pub(super) fn functions(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let prepared = &scene.prepare.hoisted;
    let functions = scene.model.functions().map(|row| {
        let (name, tape) = (row, (row.tape)(scene.model));
        match row.id {
            _ if scene.prepare.is_empty() => function(scene, name, tape, false),
            FunctionId::Rate => in_two(scene, name, tape, &prepared.rate),
            FunctionId::RateJacobian => in_two(scene, name, tape, &prepared.rate_jacobian),
            _ => function(scene, name, tape, false),
        }
    });
    functions.collect()
}

/// A function whose constants `prepare` computes, and the one that goes by them.
fn in_two(
    scene: &Scene<'_>,
    row: &FunctionRow,
    tape: &Tape,
    prepared: &Tape,
) -> Result<TokenStream, EmitError> {
    let name = row.name;
    let Manner { doc: meaning, returns, .. } = manner(scene, name);
    let Returns::Array(length) = returns else { return function(scene, row, tape, false) };
    let operations = counted(operations(tape));
    let docs = doc([meaning.as_str(), "", operations.as_str()]);
    let rest = function(scene, row, prepared, true)?;
    let (name, prepared) = (format_ident!("{name}"), format_ident!("prepared_{name}"));
    Ok(quote! {
        #docs
        #[must_use]
        #[inline]
        pub fn #name<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; #length] {
            #prepared(time, state, p, &prepare(p))
        }
        #rest
    })
}

/// What a function gives back.
enum Returns {
    /// An array of a length.
    Array(TokenStream),
    /// A struct with these fields.
    Struct(TokenStream, Vec<Ident>),
}

/// How a function is presented.
struct Manner {
    /// Equation, shape and units.
    doc: String,
    returns: Returns,
    names: ResultNames,
    of_parameters_only: bool,
}

/// `is_prepared`: whether the tape reads constants, as `prepared_..`.
fn function(
    scene: &Scene<'_>,
    row: &FunctionRow,
    tape: &Tape,
    is_prepared: bool,
) -> Result<TokenStream, EmitError> {
    let name = row.name;
    let mut manner = manner(scene, name);
    if is_prepared {
        manner.doc = format!("As `{name}`, with the constants of the parameters from `prepare`.");
    }
    let scope = Scope {
        states: &scene.states,
        parameters: scene.own_parameters(),
        handed: scene.handed(),
        constants: &scene.prepare.constants,
        motion: &scene.motion.results,
        tables: &scene.tables,
        is_in_loop: false,
        namer: &scene.locals,
    };
    let solve = scene.model.solve(row.id);
    if solve.is_some() {
        // What is solved for has no names of its own.
        manner.names = ResultNames::default();
    }
    let Body { statements, results, mut reads } = body(name, tape, &scope, &manner.names)?;
    let reads_motion = reads.motion || solve.is_some();
    let motion = reads_motion.then(|| motion_of(scene, is_prepared));
    if reads_motion {
        (reads.time, reads.parameters, reads.constants) = (true, true, is_prepared);
    }
    let p = if reads.parameters { format_ident!("p") } else { format_ident!("_p") };
    let time = if reads.time { format_ident!("time") } else { format_ident!("_time") };
    let state = if reads.state.is_empty() && !reads_motion {
        format_ident!("_state")
    } else {
        format_ident!("state")
    };
    let c = if reads.constants { format_ident!("c") } else { format_ident!("_c") };
    let constants = is_prepared.then(|| quote!(, #c: &Constants<R>));
    let state_and_time =
        (!manner.of_parameters_only).then(|| quote!(#time: R, #state: &[R; STATES],));
    let (return_type, value) = match manner.returns {
        Returns::Array(length) => {
            let value = match solve {
                None => quote!([#(#results),*]),
                Some(solve) => solved(name, solve, &results),
            };
            (quote!([R; #length]), value)
        }
        Returns::Struct(name, fields) => {
            let phantom = phantom(&fields);
            let fields = fields.iter().zip(&results).map(|(field, result)| field_of(field, result));
            (quote!(#name<R>), quote!(#name { #(#fields,)* #phantom }))
        }
    };
    let destructured = destructure(&scene.states, &reads.state);
    let statics = solve.map(|solve| statics_of(name, solve));
    let operations = counted(operations(tape));
    let docs = doc([manner.doc.as_str(), "", operations.as_str()]);
    let inline = (name == "rate").then(|| quote!(#[inline]));
    let name = if is_prepared { format_ident!("prepared_{name}") } else { format_ident!("{name}") };
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

/// The motion, known as `m`.
fn motion_of(scene: &Scene<'_>, is_prepared: bool) -> TokenStream {
    let constants = match (scene.prepare.is_empty(), is_prepared) {
        (true, _) => quote!(),
        (false, true) => quote!(, c),
        (false, false) => quote!(, &prepare(p)),
    };
    quote!(let m = &motion(time, state, p #constants);)
}

/// `field: result`, or `field` where the result is a variable of that name.
fn field_of(field: &Ident, result: &TokenStream) -> TokenStream {
    if *field == result.to_string() { quote!(#field) } else { quote!(#field: #result) }
}

pub(super) fn counted(operations: usize) -> String {
    match operations {
        0 => "No operations.".to_owned(),
        1 => "1 operation.".to_owned(),
        many => format!("{many} operations."),
    }
}

/// Binds the states a body reads: by one pattern if they are many, one by one if
/// they are few among many.
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

/// A `let` for every result, so that an array of them is a list of names.
fn spread(names: Vec<String>) -> ResultNames {
    ResultNames { spread: !names.is_empty(), names }
}

fn manner(scene: &Scene<'_>, function: &str) -> Manner {
    let array = |length: &str, doc: &str, names: Vec<String>| {
        let length = format_ident!("{length}");
        let returns = Returns::Array(quote!(#length));
        Manner { doc: doc.to_owned(), returns, names: spread(names), of_parameters_only: false }
    };
    let matrix = |pattern: &SparsityPattern, doc: &str, names: Vec<String>| {
        let length = Literal::usize_unsuffixed(pattern.entries.len());
        let returns = Returns::Array(quote!(#length));
        Manner { doc: doc.to_owned(), returns, names: spread(names), of_parameters_only: false }
    };
    let structure = |name: &str, doc: &str, fields: Vec<Ident>| {
        let names = fields.iter().map(ToString::to_string).collect();
        let names = ResultNames { names, spread: false };
        let name = format_ident!("{name}");
        let returns = Returns::Struct(quote!(#name), fields);
        Manner { doc: doc.to_owned(), returns, names, of_parameters_only: false }
    };
    let fields = |names: [&str; 3]| names.map(|name| format_ident!("{name}")).to_vec();
    let rates: Vec<String> = scene.states.iter().map(|state| format!("{state}_dot")).collect();
    let events = |what: &str| {
        let events = scene.model.events.iter();
        events.map(|event| format!("{}_{what}", event.name.ident)).collect()
    };
    match function {
        "initial_state" => Manner {
            of_parameters_only: true,
            ..array("STATES", "State at the start of the run, in the units of the states.", vec![])
        },
        "discontinuities" => Manner {
            of_parameters_only: true,
            ..array("DISCONTINUITIES", "Times at which the right-hand side jumps \\[s\\].", vec![])
        },
        "rate" if scene.model.constraints.is_empty() => array(
            "STATES",
            "`y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.",
            rates,
        ),
        "rate" => array(
            "STATES",
            "`y'`: velocities, `q''` of `M q'' = f + G^T lambda` with `g'' = 0`, `h`; in the \
             units of the states per second.",
            rates,
        ),
        "mass_matrix" => {
            let pattern = &scene.model.mass_matrix.pattern;
            matrix(pattern, "`M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.", vec![])
        }
        "forcing" => {
            let names = scene.model.coordinates.iter();
            let names = names.map(|c| format!("{}_forcing", c.position.name.ident)).collect();
            array("COORDINATES", "`f` of `M q'' = f(q, q', z, t)`, one for each coordinate.", names)
        }
        "rate_jacobian" => {
            let pattern = &scene.model.rate_jacobian.pattern;
            let names = derivatives(pattern, &rates, &scene.states);
            matrix(pattern, "`dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.", names)
        }
        "parameter_jacobian" => {
            let pattern = &scene.model.parameter_jacobian.pattern;
            let names = derivatives(pattern, &rates, &scene.parameters);
            matrix(pattern, "`dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.", names)
        }
        "time_derivative" => {
            let names = rates.iter().map(|rate| format!("{rate}_by_time")).collect();
            array("STATES", "Partial derivative of `y'` with respect to time.", names)
        }
        "outputs" => structure("Outputs", "Wanted outputs.", scene.outputs.clone()),
        "guards" => array(
            "EVENTS",
            "What passes zero where an event happens, in the order of `EVENT_SHAPES`.",
            events("guard"),
        ),
        "guard_rates" => {
            array("EVENTS", "`dg/dt` of the guards along the motion.", events("guard_rate"))
        }
        "resets" => {
            let sets = scene.model.events.iter().flat_map(|event| {
                let states = event.sets.iter().filter_map(|s| scene.states.get(*s as usize));
                states.map(|state| format!("{state}_after_{}", event.name.ident))
            });
            let doc = "New values of the states that each event sets, event by event.";
            array("RESETS", doc, sets.collect())
        }
        "constraint_values" | "constraint_rates" | "constraint_matrix" => {
            of_constraints(scene, function)
        }
        "energy" => structure(
            "Energy",
            "T, V and the energy of first-order states \\[J\\].",
            fields(["kinetic", "potential", "stored"]),
        ),
        _ => structure(
            "PowerBalance",
            "`dE/dt`, power supplied and power dissipated \\[W\\].",
            fields(["stored_rate", "supplied", "dissipated"]),
        ),
    }
}

/// How the functions of constraints are presented.
fn of_constraints(scene: &Scene<'_>, function: &str) -> Manner {
    let (doc, what) = match function {
        "constraint_values" => {
            ("`g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.", "value")
        }
        "constraint_rates" => ("`g'`, zero on the constraints too.", "rate"),
        _ => ("`G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.", ""),
    };
    let (length, names) = if what.is_empty() {
        let entries = scene.model.constraint_matrix.pattern.entries.len();
        let length = Literal::usize_unsuffixed(entries);
        (quote!(#length), vec![])
    } else {
        let constraints = scene.model.constraints.iter();
        let names = constraints.map(|constraint| format!("{}_{what}", constraint.name.ident));
        (quote!(CONSTRAINTS), names.collect())
    };
    let returns = Returns::Array(length);
    Manner { doc: doc.to_owned(), returns, names: spread(names), of_parameters_only: false }
}

/// `phi_dot_dot_by_phi` for every nonzero of a Jacobian.
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

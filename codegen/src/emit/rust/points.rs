//! Loops over many points of a field with local forces. Values equal for all points are computed
//! before the loop.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, ResultNames, Scope, body};
use super::names::argument;
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_model::hoist::apart_from_state;
use machinist_model::{FieldModel, LocalForces, Tape, operations};

/// Names of arguments, which local variables must not take.
pub(super) const ARGUMENTS: [&str; 13] = [
    "at", "u", "u_t", "u_x", "u_xt", "force", "forces", "by_time", "by_u", "by_u_t", "by_u_x",
    "by_u_xt", "inertias",
];

/// A function over many points.
struct Loop<'a> {
    name: &'static str,
    doc: &'static str,
    tape: &'a Tape,
    takes_time: bool,
    /// Slices of the points: entry of the tape's state, and the argument's name.
    point: &'static [(usize, &'static str)],
    /// Slices of results. Variables of the loop have the same names.
    results: &'static [&'static str],
}

const ON_VALUE: &[(usize, &str)] = &[(4, "at"), (0, "u"), (2, "u_t")];
const ON_SLOPE: &[(usize, &str)] = &[(1, "u_x"), (3, "u_xt")];

fn loops(local: &LocalForces) -> [Loop<'_>; 5] {
    let of_value = |name, doc, tape, results| Loop {
        name,
        doc,
        tape,
        takes_time: true,
        point: ON_VALUE,
        results,
    };
    let of_slope = |name, doc, tape, results| Loop {
        name,
        doc,
        tape,
        takes_time: false,
        point: ON_SLOPE,
        results,
    };
    [
        of_value("on_value", "f_0 alone, at many points.", &local.on_value, &["force"]),
        of_value(
            "on_value_jacobian",
            "df_0/du and df_0/du_t, at many points.",
            &local.on_value_jacobian,
            &["by_u", "by_u_t"],
        ),
        of_value(
            "on_value_by_time",
            "df_0/dt, at many points.",
            &local.on_value_by_time,
            &["by_time"],
        ),
        of_slope("on_slope", "f_1 alone, at many points.", &local.on_slope, &["force"]),
        of_slope(
            "on_slope_jacobian",
            "df_1/du_x and df_1/du_xt, at many points.",
            &local.on_slope_jacobian,
            &["by_u_x", "by_u_xt"],
        ),
    ]
}

/// Returns the functions of a field's module; empty if its forces are not local.
pub(super) fn functions(
    field: &FieldModel,
    scope: &Scope<'_>,
) -> Result<Vec<TokenStream>, EmitError> {
    let local = field.local.as_ref().map(loops);
    let functions = local.iter().flatten().map(|of| function(of, scope));
    functions.collect()
}

fn function(of: &Loop<'_>, scope: &Scope<'_>) -> Result<TokenStream, EmitError> {
    let Loop { name, tape, .. } = *of;
    let (before, at_point) = apart_from_state(tape);
    let spread = ResultNames { spread: true, names: Vec::new() };
    let shared = body(name, &before, scope, &spread)?;
    // Each of them has a `let`, so its expression is a name.
    let known = shared.results.iter().map(|name| syn::parse2::<Ident>(name.clone()));
    let known: Vec<Ident> = known
        .collect::<Result<_, _>>()
        .map_err(|error| EmitError::Unparsable { reason: error.to_string() })?;
    let mut namer = scope.namer.clone();
    for name in &known {
        namer.reserve(&name.to_string());
    }
    let inner = Scope { constants: &known, is_in_loop: true, namer: &namer, ..*scope };
    let result_names = of.results.iter().map(|name| format!("{name}_here")).collect();
    let result_names = ResultNames { spread: false, names: result_names };
    let Body { statements, results, reads } = body(name, &at_point, &inner, &result_names)?;

    let time = argument(reads.time || shared.reads.time, "time");
    let time = of.takes_time.then(|| quote!(#time: R,));
    let p = argument(reads.parameters || shared.reads.parameters, "p");
    let slices: Vec<Ident> = of.point.iter().map(|(_, name)| format_ident!("{name}")).collect();
    let outputs: Vec<Ident> = of.results.iter().map(|name| format_ident!("{name}")).collect();
    let points = of.point.iter().map(|(entry, _)| {
        let name = &scope.states[*entry];
        if reads.state.contains(entry) { quote!(&#name) } else { quote!(_) }
    });
    let elements: Vec<TokenStream> =
        points.chain(outputs.iter().map(|name| quote!(#name))).collect();
    let (first, others) = elements.split_first().map_or((None, &[] as &[_]), |(a, b)| (Some(a), b));
    let pattern = others.iter().fold(quote!(#first), |tuple, next| quote!((#tuple, #next)));
    let (head, rest) = slices.split_first().map_or((None, &[] as &[_]), |(a, b)| (Some(a), b));
    let operations = format!(
        "{} operations for all points, {} for each.",
        operations(&before),
        operations(&at_point)
    );
    let docs = doc([of.doc, "", operations.as_str()]);
    let (ident, before) = (format_ident!("{name}"), &shared.statements);
    Ok(quote! {
        #docs
        pub fn #ident<R: Real>(
            #time #(#slices: &[R],)* #p: &Parameters<R>, #(#outputs: &mut [R],)*
        ) {
            #(#before)*
            for #pattern in #head.iter() #(.zip(#rest))* #(.zip(#outputs))* {
                #(#statements)*
                #(*#outputs = #results;)*
            }
        }
    })
}

//! What a linear machine is excited by, and its implementation of the contract.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{ResultNames, Scope, body};
use super::functions::counted;
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_model::{Excitation, operations};

/// Constants, functions and implementation; nothing for a machine that is not linear.
pub(super) fn items(scene: &Scene<'_>) -> Result<Option<TokenStream>, EmitError> {
    let Some(excitation) = &scene.model.excitation else { return Ok(None) };
    let terms = terms(excitation);
    let [values, switches] = functions(scene, excitation)?;
    let machine = &scene.machine;
    Ok(Some(quote! {
        #terms
        #values
        #switches
        impl<R: Real> LinearEquations<R> for #machine {
            fn excitation_terms(&self) -> &[(u32, u32)] { &EXCITATION_TERMS }
            fn excitation(&self, time: R, parameters: &[R], values: &mut [R]) {
                values.copy_from_slice(&excitation(time, &parameters_of(parameters)));
            }
            fn switches(&self) -> usize { SWITCHES }
            fn switch_times(&self, parameters: &[R], times: &mut [R]) {
                times.copy_from_slice(&switches(&parameters_of(parameters)));
            }
        }
    }))
}

fn terms(excitation: &Excitation) -> TokenStream {
    let count = Literal::usize_unsuffixed(excitation.terms.len());
    let switches = Literal::usize_unsuffixed(excitation.switches.results.len());
    let terms = excitation.terms.iter().map(|&(entry, power)| {
        let (entry, power) = (Literal::u32_unsuffixed(entry), Literal::u32_unsuffixed(power));
        quote!((#entry, #power))
    });
    let terms_doc = doc([
        "Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.",
    ]);
    let switches_doc = doc(["Times at which pieces of the excitation end."]);
    quote! {
        #terms_doc
        pub const EXCITATION_TERMS: [(u32, u32); #count] = [#(#terms),*];
        #switches_doc
        pub const SWITCHES: usize = #switches;
    }
}

/// `excitation` and `switches`.
fn functions(scene: &Scene<'_>, excitation: &Excitation) -> Result<[TokenStream; 2], EmitError> {
    let meanings = [
        "g, w, C and S of every term of the excitation, on the piece that holds `time`.",
        "Times at which pieces of the excitation end \\[s\\]; not finite where there is none.",
    ];
    let [values, switches] =
        [("excitation", &excitation.values), ("switches", &excitation.switches)];
    let length = Literal::usize_unsuffixed(excitation.values.results.len());
    Ok([
        function(scene, values, meanings[0], &quote!(#length))?,
        function(scene, switches, meanings[1], &quote!(SWITCHES))?,
    ])
}

fn function(
    scene: &Scene<'_>,
    (name, tape): (&'static str, &machinist_model::Tape),
    meaning: &str,
    length: &TokenStream,
) -> Result<TokenStream, EmitError> {
    let scope = Scope {
        states: &scene.states,
        parameters: scene.own_parameters(),
        handed: scene.handed(),
        constants: &[],
        motion: &[],
        tables: &scene.tables,
        is_in_loop: false,
        namer: &scene.locals,
    };
    let body = body(name, tape, &scope, &ResultNames::default())?;
    let (statements, results) = (&body.statements, &body.results);
    let p = if body.reads.parameters { format_ident!("p") } else { format_ident!("_p") };
    let time = if body.reads.time { quote!(time) } else { quote!(_time) };
    let time = (name == "excitation").then(|| quote!(#time: R,));
    let operations = counted(operations(tape));
    let docs = doc([meaning, "", operations.as_str()]);
    let name = format_ident!("{name}");
    Ok(quote! {
        #docs
        #[must_use]
        pub fn #name<R: Real>(#time #p: &Parameters<R>) -> [R; #length] {
            #(#statements)*
            [#(#results),*]
        }
    })
}

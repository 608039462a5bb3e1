//! Excitation of a linear machine.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{ResultNames, body};
use super::functions::{destructure, documentation};
use super::names::argument;
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_model::{Excitation, operations};

/// Returns constants and functions; `None` if the machine is not linear.
pub(super) fn items(scene: &Scene<'_>) -> Result<Option<TokenStream>, EmitError> {
    let Some(excitation) = &scene.model.excitation else { return Ok(None) };
    let terms = terms(excitation);
    let [values, switches] = functions(scene, excitation)?;
    Ok(Some(quote!(#terms #values #switches)))
}

fn terms(excitation: &Excitation) -> TokenStream {
    let count = Literal::usize_unsuffixed(excitation.terms.len());
    let switches = Literal::usize_unsuffixed(excitation.switches.results.len());
    let terms = excitation.terms.iter().map(|&(entry, power)| {
        let (entry, power) = (Literal::u32_unsuffixed(entry), Literal::u32_unsuffixed(power));
        quote!((#entry, #power))
    });
    let slopes = excitation.slopes.iter().map(|&(row, entry)| {
        let (row, entry) = (Literal::u32_unsuffixed(row), Literal::u32_unsuffixed(entry));
        quote!((#row, #entry))
    });
    let guards = Literal::usize_unsuffixed(excitation.slopes.len());
    let terms_doc = doc([
        "Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of \
         the state, then guards of events, then those of kinks.",
    ]);
    let slopes_doc =
        doc(["Row and entry of the state of each nonzero slope, if there are guards."]);
    let switches_doc = doc(["Times at which pieces of the excitation end."]);
    quote! {
        #terms_doc
        pub const EXCITATION_TERMS: [(u32, u32); #count] = [#(#terms),*];
        #slopes_doc
        pub const SLOPES: [(u32, u32); #guards] = [#(#slopes),*];
        #switches_doc
        pub const SWITCHES: usize = #switches;
    }
}

/// Returns `excitation` and `switches`.
fn functions(scene: &Scene<'_>, excitation: &Excitation) -> Result<[TokenStream; 2], EmitError> {
    let meanings = [
        "g, w, C and S of every term of the excitation, then the slopes, on the piece that \
         holds `time`, in the modes of a state.",
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
    let body = body(name, tape, &scene.scope(&[]), &ResultNames::default())?;
    let (statements, results) = (&body.statements, &body.results);
    let p = argument(body.reads.parameters, "p");
    let time = argument(body.reads.time, "time");
    let state = argument(!body.reads.state.is_empty(), "state");
    let destructured = destructure(&scene.states, &body.reads.state);
    let inputs = quote!(#time: R, #state: &[R; STATES],);
    let inputs = (name == "excitation").then_some(inputs);
    let docs = documentation(meaning, operations(tape));
    let name = format_ident!("{name}");
    Ok(quote! {
        #docs
        #[must_use]
        pub fn #name<R: Real>(#inputs #p: &Parameters<R>) -> [R; #length] {
            #destructured
            #(#statements)*
            [#(#results),*]
        }
    })
}

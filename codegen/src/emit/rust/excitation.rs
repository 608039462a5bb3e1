//! Excitation of a linear machine.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{ResultNames, body};
use super::functions::documentation;
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

/// Returns `excitation` and `switches`.
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
    let body = body(name, tape, &scene.scope(&[]), &ResultNames::default())?;
    let (statements, results) = (&body.statements, &body.results);
    let p = if body.reads.parameters { format_ident!("p") } else { format_ident!("_p") };
    let time = if body.reads.time { quote!(time) } else { quote!(_time) };
    let time = (name == "excitation").then(|| quote!(#time: R,));
    let docs = documentation(meaning, operations(tape));
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

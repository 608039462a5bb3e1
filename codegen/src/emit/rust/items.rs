//! Tables of an emitted module, and the module that lists the scenes.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use crate::emit::literal::literal;
use crate::emit::text::{doc, markdown_line};
use crate::emit::{EmitError, EmitOptions};
use machinist_model::Model;

/// Returns a field that uses the type parameter of a struct without numbers.
pub(super) fn phantom(fields: &[Ident]) -> Option<TokenStream> {
    fields.is_empty().then(|| quote!(real: core::marker::PhantomData,))
}

/// Returns the tables of the scene.
pub(super) fn tables(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let tables = scene.model.tables.iter().zip(&scene.tables).map(|(table, name)| {
        let number = |value: f64| {
            let place = || format!("table `{}`", table.name.path);
            literal(value).map_err(|_| EmitError::NotFinite { place: place(), value })
        };
        let knots = table.knots.iter().map(|&knot| number(knot)).collect::<Result<Vec<_>, _>>()?;
        let rows = table.coefficients.iter().map(|row| {
            let row = row.iter().map(|&value| number(value)).collect::<Result<Vec<_>, _>>()?;
            Ok(quote!([#(#row),*]))
        });
        let rows = rows.collect::<Result<Vec<_>, EmitError>>()?;
        let docs = doc([format!("Natural cubic spline {}.", markdown_line(&table.name.path))]);
        Ok(quote! {
            #docs
            pub static #name: CubicTable<'static> = CubicTable {
                knots: &[#(#knots),*],
                coefficients: &[#(#rows),*],
            };
        })
    });
    tables.collect()
}

/// Returns the module that lists the scenes.
pub(super) fn index(models: &[&Model], modules: &[Ident], options: &EmitOptions) -> TokenStream {
    let condition = |name: &str| options.scene_features.then(|| quote!(#[cfg(feature = #name)]));
    let declarations = models.iter().zip(modules).map(|(model, module)| {
        let title = markdown_line(&model.title);
        let docs = doc([if title.is_empty() { format!("The machine `{module}`.") } else { title }]);
        let condition = condition(&model.name);
        quote! {
            #docs
            #condition
            #[rustfmt::skip]
            #[allow(
                non_snake_case,
                clippy::approx_constant,
                clippy::struct_field_names,
                clippy::too_many_lines,
                reason = "the spec's own names and numbers, in bodies as long as its equations"
            )]
            pub mod #module;
        }
    });
    let with_fields = |wanted: bool| {
        let models = models.iter().zip(modules);
        models.filter(move |(model, _)| model.fields.is_empty() != wanted)
    };
    let arm = |(model, module): (&&Model, &Ident)| {
        let name = &model.name;
        let machine = format_ident!("{}", super::names::type_name(name));
        let condition = condition(name);
        quote!(#condition #name => Some(&#module::#machine),)
    };
    let listed = |(model, _): (&&Model, &Ident)| {
        let name = model.name.as_str();
        let condition = condition(name);
        quote!(#condition #name)
    };
    let names = with_fields(false).map(listed);
    let arms: Vec<TokenStream> = with_fields(false).map(arm).collect();
    let field_names = with_fields(true).map(listed);
    let field_names: Vec<TokenStream> = field_names.collect();
    let field_arms = with_fields(true).map(arm);
    let (field_names_doc, find_field_doc) = (
        doc(["Names of all scenes with fields, sorted."]),
        doc(["The scene with fields of a name, not yet cut into elements."]),
    );
    let of_fields = (!field_names.is_empty()).then(|| {
        let for_all = find_fields_for_all();
        quote! {
            #field_names_doc
            #[rustfmt::skip]
            pub const FIELD_NAMES: &[&str] = &[#(#field_names),*];
            #find_field_doc
            #[must_use]
            #[allow(clippy::match_single_binding, reason = "features may leave no scene")]
            pub fn find_field<R: Real>(name: &str) -> Option<&'static dyn FieldScene<R>> {
                match name {
                    #(#field_arms)*
                    _ => None,
                }
            }
            #for_all
        }
    });
    let field_import = (!field_names.is_empty()).then(|| quote!(, field::FieldScene));
    let dual_import = (!field_names.is_empty()).then(|| quote!(Dual,));
    let [inner, names_doc, find_doc] = index_docs(options);
    let (names_doc, find_doc) = (doc([names_doc]), doc([find_doc]));
    let inner = format!(" {inner}");
    let find = if arms.is_empty() {
        quote!(
            pub fn find<R: Real>(_name: &str) -> Option<&'static dyn Simulator<R>> {
                None
            }
        )
    } else {
        quote! {
            pub fn find<R: Real>(name: &str) -> Option<&'static dyn Simulator<R>> {
                match name {
                    #(#arms)*
                    _ => None,
                }
            }
        }
    };
    let find_f64 = find_f64();
    quote! {
        #![doc = #inner]
        use ::machinist_contract::{#dual_import Real, Simulator #field_import};
        #(#declarations)*
        #names_doc
        #[rustfmt::skip]
        pub const NAMES: &[&str] = &[#(#names),*];
        #find_doc
        #[must_use]
        #[allow(clippy::match_single_binding, reason = "features may leave no scene")]
        #[rustfmt::skip]
        #find
        #find_f64
        #of_fields
    }
}

/// Returns the lookup of scenes for runs in `f64`.
fn find_f64() -> TokenStream {
    let doc = doc([
        "The scene of a name in `f64`, compiled once and for all: who calls [`find`] compiles",
        "all scenes within a crate of its own.",
    ]);
    quote! {
        #doc
        #[must_use]
        pub fn find_f64(name: &str) -> Option<&'static dyn Simulator<f64>> {
            find(name)
        }
    }
}

/// Returns the lookups of scenes whose fields are to be divided into elements.
fn find_fields_for_all() -> TokenStream {
    let doc_f64 = doc(["The scene with fields of a name in `f64`, compiled once and for all."]);
    let doc_duals = doc(["It on numbers that carry derivatives, likewise."]);
    quote! {
        #doc_f64
        #[must_use]
        pub fn find_field_f64(name: &str) -> Option<&'static dyn FieldScene<f64>> {
            find_field(name)
        }
        #doc_duals
        #[must_use]
        pub fn find_field_duals(name: &str) -> Option<&'static dyn FieldScene<Dual>> {
            find_field(name)
        }
    }
}

/// Returns the docs of the index, of its list of names and of its lookup.
fn index_docs(options: &EmitOptions) -> [&'static str; 3] {
    if options.scene_features {
        [
            "Simulators emitted from the specs, one module and one feature a scene.",
            "Names of all scenes whose feature is on, sorted.",
            "The scene of a name, if its feature is on.",
        ]
    } else {
        [
            "Simulators emitted from the specs, one module a scene.",
            "Names of all scenes, sorted.",
            "The scene of a name, if there is one.",
        ]
    }
}

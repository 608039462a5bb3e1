//! Constants, types and tables of an emitted module.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::names::{Namer, constant_name};
use crate::emit::literal::literal;
use crate::emit::text::{doc, markdown, markdown_line};
use crate::emit::{EmitError, EmitOptions};
use machinist_model::{Model, Quantity, SparsityPattern};

/// Shapes and patterns.
pub(super) fn constants(scene: &Scene<'_>) -> TokenStream {
    let model = scene.model;
    let counts = [
        count("COORDINATES", model.coordinates.len(), "Generalized coordinates, n."),
        count("STATES", scene.model.states.len(), "Length of the state y."),
        count("PARAMETERS", model.all_parameters().count(), "Parameters."),
        count("OUTPUTS", model.wanted.len(), "Wanted outputs."),
        count(
            "DISCONTINUITIES",
            model.discontinuities.results.len(),
            "Times at which the right-hand side jumps.",
        ),
    ];
    let model = scene.model;
    let constraints = &model.constraints;
    let of_constraints = (!constraints.is_empty()).then(|| {
        let pattern = pattern(
            "CONSTRAINT_MATRIX_PATTERN",
            &model.constraint_matrix.pattern,
            "Nonzeros of G = dg'/dq'.",
        );
        let count = count("CONSTRAINTS", constraints.len(), "Constraints.");
        quote!(#count #pattern)
    });
    let counts = counts.into_iter().chain(event_counts(model));
    let patterns = [
        pattern(
            "MASS_MATRIX_PATTERN",
            &model.mass_matrix.pattern,
            "Nonzeros of M, both triangles.",
        ),
        pattern("RATE_JACOBIAN_PATTERN", &model.rate_jacobian.pattern, "Nonzeros of dy'/dy."),
        pattern(
            "PARAMETER_JACOBIAN_PATTERN",
            &model.parameter_jacobian.pattern,
            "Nonzeros of dy'/dp.",
        ),
    ];
    quote!(#(#counts)* #(#patterns)* #of_constraints)
}

fn count(name: &str, value: usize, meaning: &str) -> TokenStream {
    let name = format_ident!("{name}");
    let value = proc_macro2::Literal::usize_unsuffixed(value);
    let meaning = doc([meaning]);
    quote!(#meaning pub const #name: usize = #value;)
}

/// Nothing for a scene without events.
fn event_counts(model: &Model) -> Vec<TokenStream> {
    let resets = model.events.iter().map(|event| event.sets.len()).sum();
    let counts = [
        count("EVENTS", model.events.len(), "Events."),
        count("RESETS", resets, "States that events set, those of all events."),
    ];
    if model.events.is_empty() { vec![] } else { counts.into() }
}

fn pattern(name: &str, pattern: &SparsityPattern, meaning: &str) -> TokenStream {
    let name = format_ident!("{name}");
    let meaning = doc([meaning]);
    let number = |value: u32| proc_macro2::Literal::u32_unsuffixed(value);
    let size = |value: usize| proc_macro2::Literal::usize_unsuffixed(value);
    let entries = pattern.entries.iter().map(|&(row, column)| {
        let (row, column) = (number(row), number(column));
        quote!((#row, #column))
    });
    let (rows, columns) = (size(pattern.rows), size(pattern.columns));
    quote! {
        #meaning
        pub const #name: SparsityPattern<'static> = SparsityPattern {
            rows: #rows,
            columns: #columns,
            entries: &[#(#entries),*],
        };
    }
}

/// The unit struct that stands for the machine.
pub(super) fn machine(scene: &Scene<'_>) -> TokenStream {
    let model = scene.model;
    let mut lines = vec![markdown_line(&model.title), String::new()];
    lines.extend(markdown(&model.doc));
    if !model.source.trim().is_empty() {
        lines.push(String::new());
        lines.push(format!("Source: {}", markdown_line(&model.source)));
    }
    if lines[0].is_empty() {
        lines[0] = format!("The machine `{}`.", model.name);
    }
    while lines.last().is_some_and(String::is_empty) {
        lines.pop();
    }
    let docs = doc(lines);
    let machine = &scene.machine;
    quote! {
        #docs
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub struct #machine;
    }
}

/// `Parameters<R>` with the spec's values as default.
pub(super) fn parameters(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let parameters = scene.model.all_parameters();
    let values = parameters.clone().map(|parameter| {
        literal(parameter.value).map_err(|_| EmitError::NotFinite {
            place: format!("parameter `{}`", parameter.quantity.name.path),
            value: parameter.value,
        })
    });
    let values = values.collect::<Result<Vec<_>, _>>()?;
    let docs = parameters.clone().map(|parameter| {
        let default = parameter.value;
        doc([format!("{} In the spec: {default:?}.", meaning(&parameter.quantity))])
    });
    let names = &scene.parameters;
    let structure = record(
        &RecordNames { record: "Parameters", length: "PARAMETERS" },
        "Parameters, in SI units; the default holds the values of the spec.",
        names,
        docs,
    );
    let phantom = phantom(names);
    Ok(quote! {
        #structure
        impl<R: Real> Default for Parameters<R> {
            fn default() -> Self {
                Self { #(#names: R::literal(#values),)* #phantom }
            }
        }
    })
}

/// `Outputs<R>`.
pub(super) fn outputs(scene: &Scene<'_>) -> TokenStream {
    let outputs = &scene.model.wanted;
    let docs = outputs.iter().map(|output| doc([meaning(output)]));
    record(
        &RecordNames { record: "Outputs", length: "OUTPUTS" },
        "Wanted outputs, in SI units.",
        &scene.outputs,
        docs,
    )
}

pub(super) struct RecordNames {
    pub(super) record: &'static str,
    pub(super) length: &'static str,
}

/// A struct of numbers that converts from and to an array.
pub(super) fn record(
    names: &RecordNames,
    meaning: &str,
    fields: &[Ident],
    docs: impl Iterator<Item = TokenStream>,
) -> TokenStream {
    let (record, length) = (format_ident!("{}", names.record), format_ident!("{}", names.length));
    let meaning = doc([meaning]);
    let indices = (0..fields.len()).map(proc_macro2::Literal::usize_unsuffixed);
    let phantom = phantom(fields);
    let phantom_field = phantom.is_some().then(|| {
        let docs = doc(["Nothing; there are no numbers here."]);
        quote!(#docs pub real: core::marker::PhantomData<R>,)
    });
    let values = if fields.is_empty() { format_ident!("_values") } else { format_ident!("values") };
    let (from, to) =
        (doc(["From the numbers in their order."]), doc(["The numbers in their order."]));
    quote! {
        #meaning
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #record<R> {
            #(#docs pub #fields: R,)*
            #phantom_field
        }
        impl<R: Real> #record<R> {
            #from
            #[must_use]
            #[inline]
            pub fn from_array(#values: [R; #length]) -> Self {
                Self { #(#fields: values[#indices],)* #phantom }
            }
            #to
            #[must_use]
            #[inline]
            pub fn to_array(self) -> [R; #length] {
                [#(self.#fields),*]
            }
        }
    }
}

/// What gives a struct without numbers a use for its type parameter.
pub(super) fn phantom(fields: &[Ident]) -> Option<TokenStream> {
    fields.is_empty().then(|| quote!(real: core::marker::PhantomData,))
}

/// Meaning and unit of a quantity, one line of Markdown.
pub(super) fn meaning(quantity: &Quantity) -> String {
    let doc = markdown_line(&quantity.doc);
    let path = markdown_line(&quantity.name.path);
    let what = if doc.is_empty() { path } else { format!("{path}: {doc}") };
    format!("{what} \\[{}\\].", markdown_line(&quantity.unit))
}

/// `pub mod state` with the index of every state.
pub(super) fn state_indices(scene: &Scene<'_>) -> TokenStream {
    let mut namer = Namer::empty();
    let constants = scene.model.states.iter().map(|state| &state.quantity).enumerate().map(
        |(index, quantity)| {
            let name = namer.claim(&constant_name(&quantity.name.ident));
            let docs = doc([meaning(quantity)]);
            let index = proc_macro2::Literal::usize_unsuffixed(index);
            quote!(#docs pub const #name: usize = #index;)
        },
    );
    let constants: Vec<TokenStream> = constants.collect();
    let docs = doc(["Where to find what in the state."]);
    quote!(#docs pub mod state { #(#constants)* })
}

/// Tables of the scene.
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

/// The module that lists the scenes.
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
        }
    });
    let field_import = (!field_names.is_empty()).then(|| quote!(, field::FieldScene));
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
    quote! {
        #![doc = #inner]
        use ::machinist_contract::{Real, Simulator #field_import};
        #(#declarations)*
        #names_doc
        #[rustfmt::skip]
        pub const NAMES: &[&str] = &[#(#names),*];
        #find_doc
        #[must_use]
        #[allow(clippy::match_single_binding, reason = "features may leave no scene")]
        #[rustfmt::skip]
        #find
        #of_fields
    }
}

/// What the index says of itself, of its list of names and of its look-up.
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

//! The generic elements of a scene's fields: a module of point functions for each, and
//! `FieldScene` for the machine.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{Body, ResultNames, Scope, body};
use super::items::meaning;
use super::names::{Namer, argument, distinct};
use super::points;
use crate::emit::EmitError;
use crate::emit::literal::literal;
use crate::emit::text::doc;
use machinist_model::{FieldModel, Model, Place, Quantity, Tape, operations};

/// Modules of all fields and the implementation; nothing for a scene without fields.
pub(super) fn items(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let fields = &scene.model.fields;
    if fields.is_empty() {
        return Ok(TokenStream::new());
    }
    let idents = fields.iter().map(|field| field.quantities[0].name.ident.as_str());
    let modules = distinct(idents, "fields")?;
    let bodies = fields.iter().zip(&modules).map(|(field, name)| module(scene, field, name));
    let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
    let implementation = implementation(scene, &modules)?;
    Ok(quote!(#(#bodies)* #implementation))
}

/// Names to import from the contract's `field`.
pub(super) fn imports() -> TokenStream {
    quote!(field::{FieldAttachment, FieldDescription, FieldPlace, FieldPoint, FieldScene},)
}

/// How a point function is presented.
struct Manner {
    name: &'static str,
    doc: &'static str,
    /// Whether it takes time and the field at the point, or x only, or neither.
    of: Of,
    results: &'static [&'static str],
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Of {
    Motion,
    Place,
    Parameters,
}

fn functions(field: &FieldModel) -> [(Manner, &Tape); 9] {
    let manner = |name, of, doc, results| Manner { name, doc, of, results };
    [
        (manner("inertia", Of::Place, "m, the inertia a length.", &[] as &[_]), &field.inertia),
        (
            manner("inertia_gradient", Of::Place, "dm/dx, then dm/dp of `PARAMETERS`.", &[]),
            &field.inertia_gradient,
        ),
        (
            manner(
                "force",
                Of::Motion,
                "Forces a length: f_0 = dL/du - dD/du_t + Q on u, f_1 = dL/du_x - dD/du_xt on u_x.",
                &["on_value", "on_slope"],
            ),
            &field.force,
        ),
        (
            manner(
                "force_jacobian",
                Of::Motion,
                "Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.",
                &[],
            ),
            &field.force_jacobian,
        ),
        (
            manner(
                "force_gradient",
                Of::Motion,
                "Derivatives of f_0 and f_1 with respect to x, to t, then to `PARAMETERS`.",
                &[],
            ),
            &field.force_gradient,
        ),
        (
            manner("energy", Of::Motion, "T and V a length \\[J/m\\].", &["kinetic", "potential"]),
            &field.energy,
        ),
        (
            manner(
                "power",
                Of::Motion,
                "Rate of V, power supplied and power dissipated, a length \\[W/m\\].",
                &["stored", "supplied", "dissipated"],
            ),
            &field.power,
        ),
        (
            manner("places", Of::Parameters, "x of the attachments, then the length \\[m\\].", &[]),
            &field.places,
        ),
        (
            manner(
                "places_gradient",
                Of::Parameters,
                "Derivatives of `places` with respect to `PARAMETERS`, row by row.",
                &[],
            ),
            &field.places_gradient,
        ),
    ]
}

fn module(scene: &Scene<'_>, field: &FieldModel, name: &Ident) -> Result<TokenStream, EmitError> {
    let mut locals = Namer::for_locals();
    let reserved = ["x", "point", "R", "PARAMETERS", "places"].into_iter();
    reserved.chain(points::ARGUMENTS).for_each(|name| locals.reserve(name));
    for table in &scene.tables {
        locals.reserve(&table.to_string());
    }
    let instance = field.quantities[0].name.path.split('.').next().unwrap_or_default();
    let own = |quantity: &Quantity| {
        let path = quantity.name.path.as_str();
        path.strip_prefix(instance).and_then(|own| own.strip_prefix('.')).unwrap_or(path).to_owned()
    };
    // In the order of the tapes' state: u, u_x, u_t, u_xt.
    let mut states: Vec<Ident> =
        field.quantities[..4].iter().map(|quantity| locals.claim(&own(quantity))).collect();
    states.push(format_ident!("x"));
    for parameter in &scene.parameters {
        locals.reserve(&parameter.to_string());
    }
    let scope = Scope {
        states: &states,
        parameters: scene.own_parameters(),
        handed: scene.handed(),
        constants: &[],
        motion: &[],
        tables: &scene.tables,
        is_in_loop: false,
        namer: &locals,
    };
    let initial = Manner {
        name: "initial",
        doc: "u and u_t at the start.",
        of: Of::Place,
        results: &["value", "rate"],
    };
    let functions = functions(field).into_iter().chain([(initial, &field.initial)]);
    let functions = functions.map(|(manner, tape)| function(&manner, tape, &scope));
    let functions = functions.collect::<Result<Vec<_>, _>>()?;
    let loops = points::functions(field, &scope)?;
    let count = Literal::usize_unsuffixed(field.parameters.len());
    let parameters = field.parameters.iter().map(|id| Literal::u32_unsuffixed(*id));
    let title = format!("The field {}", meaning(&field.quantities[0]));
    let docs = doc([
        title.as_str(),
        "",
        "One generic element: what acts at a point with u, u_x, u_t, u_xt at x. The loops over \
         elements are the contract's.",
    ]);
    Ok(quote! {
        #docs
        pub mod #name {
            #[allow(clippy::wildcard_imports, unused_imports, reason = "what a field needs of it")]
            use super::*;
            /// Parameters that the field depends on.
            pub const PARAMETERS: [u32; #count] = [#(#parameters),*];
            #(#functions)*
            #(#loops)*
        }
    })
}

fn function(manner: &Manner, tape: &Tape, scope: &Scope<'_>) -> Result<TokenStream, EmitError> {
    let name = manner.name;
    let names = manner.results.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    let result_names = ResultNames { spread: false, names };
    let Body { statements, results, reads } = body(name, tape, scope, &result_names)?;
    let place = scope.states.len() - 1;
    let (time, x) = (argument(reads.time, "time"), argument(reads.state.contains(&place), "x"));
    let p = argument(reads.parameters, "p");
    let of_point: Vec<usize> = reads.state.iter().copied().filter(|entry| *entry < place).collect();
    let point = argument(!of_point.is_empty(), "point");
    let arguments = match manner.of {
        Of::Motion => quote!(#time: R, #x: R, #point: &FieldPoint<R>,),
        Of::Place => quote!(#x: R,),
        Of::Parameters => quote!(),
    };
    let states = (0..place).map(|entry| {
        let name = &scope.states[entry];
        if of_point.contains(&entry) { quote!(#name) } else { quote!(_) }
    });
    let destructured = (!of_point.is_empty()).then(|| quote!(let [#(#states),*] = *#point;));
    let operations = format!("{} operations.", operations(tape));
    let docs = doc([manner.doc, "", operations.as_str()]);
    let (length, ident) = (Literal::usize_unsuffixed(results.len()), format_ident!("{name}"));
    // The loop over points moves out what no point decides, if it sees it.
    let inline = if name == "inertia" { quote!(#[inline(always)]) } else { quote!(#[inline]) };
    Ok(quote! {
        #docs
        #[must_use]
        #inline
        pub fn #ident<R: Real>(#arguments #p: &Parameters<R>) -> [R; #length] {
            #destructured
            #(#statements)*
            [#(#results),*]
        }
    })
}

fn implementation(scene: &Scene<'_>, modules: &[Ident]) -> Result<TokenStream, EmitError> {
    let machine = &scene.machine;
    let fields = &scene.model.fields;
    let own = scene.model.parameters.len() as u32;
    let count = Literal::usize_unsuffixed(fields.len());
    let statics = fields.iter().zip(modules).map(|(field, module)| statics(field, module, own));
    let statics = statics.collect::<Result<Vec<_>, _>>()?;
    let numbers: Vec<Literal> = (0..fields.len()).map(Literal::usize_unsuffixed).collect();
    let names = modules.iter().map(constant).collect::<Vec<_>>();
    let arms = |call: &TokenStream| {
        quote! {
            match index {
                #(#numbers => #modules::#call,)*
                _ => no_field(index),
            }
        }
    };
    let motion = |name: &str, length: usize| {
        let (name, length) = (format_ident!("{name}"), Literal::usize_unsuffixed(length));
        let method = format_ident!("field_{name}");
        let arms = arms(&quote!(#name(time, x, point, &p)));
        quote! {
            fn #method(
                &self, index: usize, time: R, x: R, point: &FieldPoint<R>, parameters: &[R],
            ) -> [R; #length] {
                let p = parameters_of(parameters);
                #arms
            }
        }
    };
    let motions = [("force", 2), ("force_jacobian", 8), ("energy", 2), ("power", 3)]
        .map(|(name, length)| motion(name, length));
    let copied = |name: &str, arguments: &TokenStream, values: &TokenStream| {
        let (name, method) = (format_ident!("{name}"), format_ident!("field_{name}"));
        quote! {
            fn #method(&self, index: usize, #arguments parameters: &[R], values: &mut [R]) {
                let p = parameters_of(parameters);
                match index {
                    #(#numbers => values.copy_from_slice(&#modules::#name(#values &p)),)*
                    _ => no_field(index),
                }
            }
        }
    };
    let motion_arguments = quote!(time: R, x: R, point: &FieldPoint<R>,);
    let copied = [
        copied("inertia_gradient", &quote!(x: R,), &quote!(x,)),
        copied("force_gradient", &motion_arguments, &quote!(time, x, point,)),
        copied("places", &quote!(), &quote!()),
        copied("places_gradient", &quote!(), &quote!()),
    ];
    let structure = structure(scene.model);
    let many = points::methods(&numbers, modules, fields);
    let inertia = arms(&quote!(inertia(x, &p)));
    let initial = arms(&quote!(initial(x, &p)));
    Ok(quote! {
        impl<R: Real> FieldScene<R> for #machine {
            fn fields(&self) -> usize { #count }
            fn field(&self, index: usize) -> FieldDescription<'_> {
                match index {
                    #(#numbers => #names,)*
                    _ => no_field(index),
                }
            }
            fn field_inertia(&self, index: usize, x: R, parameters: &[R]) -> R {
                let p = parameters_of(parameters);
                let [inertia] = #inertia;
                inertia
            }
            fn field_initial(&self, index: usize, x: R, parameters: &[R]) -> [R; 2] {
                let p = parameters_of(parameters);
                #initial
            }
            #(#motions)*
            #(#copied)*
            #structure
            #many
        }
        #[cold]
        fn no_field(index: usize) -> ! {
            panic!("there is no field of number {index}")
        }
        #(#statics)*
    })
}

/// What is known of the forms of the densities, where it is more than nothing.
fn structure(model: &Model) -> TokenStream {
    let fields = &model.fields;
    let known = |name: &str, holds: &dyn Fn(&FieldModel) -> bool| {
        let numbers = (0..fields.len()).filter(|index| holds(&fields[*index]));
        let numbers: Vec<Literal> = numbers.map(Literal::usize_unsuffixed).collect();
        let name = format_ident!("field_is_{name}");
        (!numbers.is_empty()).then(|| {
            quote! {
                fn #name(&self, index: usize) -> bool {
                    matches!(index, #(#numbers)|*)
                }
            }
        })
    };
    let linear = known("linear", &|field| field.is_linear);
    let local = known("local", &|field| field.local.is_some());
    let reads_no_forces = (!model.jacobian_reads_forces()).then(|| {
        quote! {
            fn jacobian_reads_forces(&self) -> bool { false }
        }
    });
    quote!(#reads_no_forces #linear #local)
}

/// The static that describes a field.
fn constant(module: &Ident) -> Ident {
    format_ident!("{}_FIELD", module.to_string().to_ascii_uppercase())
}

/// `own` is the number of parameters before what fields hand over.
fn statics(field: &FieldModel, module: &Ident, own: u32) -> Result<TokenStream, EmitError> {
    let place = || format!("field `{module}`");
    let number =
        |value: f64| literal(value).map_err(|_| EmitError::NotFinite { place: place(), value });
    let quantity = |quantity: &Quantity| {
        let (name, unit, doc) = (&quantity.name.path, &quantity.unit, &quantity.doc);
        quote!(Quantity { name: #name, unit: #unit, doc: #doc })
    };
    let attachments = field.attachments.iter().map(|at| {
        let coordinate = at.coordinate.map(Literal::u32_unsuffixed);
        let coordinate = coordinate.map_or_else(|| quote!(None), |id| quote!(Some(#id)));
        let place = format_ident!(
            "{}",
            match at.place {
                Place::Start => "Start",
                Place::Inside => "Inside",
                Place::End => "End",
            }
        );
        let handed = Literal::u32_unsuffixed(own + at.handed);
        let x = number(at.x)?;
        Ok(quote!(FieldAttachment {
            coordinate: #coordinate, place: FieldPlace::#place, at: #x, handed: #handed,
        }))
    });
    let attachments = attachments.collect::<Result<Vec<_>, EmitError>>()?;
    let [value, slope, rate] = [0, 1, 2].map(|index| quantity(&field.quantities[index]));
    let scale = [number(field.scale[0])?, number(field.scale[1])?];
    let length = number(field.length)?;
    let fixed = field.fixed;
    let [elements, order] = [field.elements, field.order].map(Literal::usize_unsuffixed);
    let name = constant(module);
    Ok(quote! {
        static #name: FieldDescription<'static> = FieldDescription {
            value: #value,
            rate: #rate,
            slope: #slope,
            scale: [#(#scale),*],
            fixed: [#(#fixed),*],
            length: #length,
            attachments: &[#(#attachments),*],
            parameters: &#module::PARAMETERS,
            elements: #elements,
            order: #order,
        };
    })
}

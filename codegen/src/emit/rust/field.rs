//! The generic elements of a scene's fields: a module of point functions for each, and
//! `FieldScene` for the machine.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{Body, ResultNames, Scope, body};
use super::check::check_tape;
use super::items::meaning;
use super::names::{Namer, distinct};
use crate::emit::literal::literal;
use crate::emit::text::doc;
use crate::emit::{EmitError, tape_operations};
use crate::program::{FieldProgram, LocalForces, Program};
use crate::system::{Place, Quantity};
use crate::tape::Tape;

/// Modules of all fields and the implementation; nothing for a scene without fields.
pub(super) fn items(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let fields = &scene.program.fields;
    if fields.is_empty() {
        return Ok(TokenStream::new());
    }
    let idents = fields.iter().map(|field| field.field.quantities[0].name.ident.as_str());
    let modules = distinct(idents, "fields")?;
    let bodies = fields.iter().zip(&modules).map(|(field, name)| module(scene, field, name));
    let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
    let implementation = implementation(scene, &modules);
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

fn functions(field: &FieldProgram) -> [(Manner, &Tape); 9] {
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

fn local_functions(local: &LocalForces) -> [(Manner, &Tape); 5] {
    let manner = |name, doc| Manner { name, doc, of: Of::Motion, results: &[] };
    [
        (manner("on_value", "f_0 alone."), &local.on_value),
        (manner("on_value_jacobian", "df_0/du and df_0/du_t."), &local.on_value_jacobian),
        (manner("on_value_by_time", "df_0/dt."), &local.on_value_by_time),
        (manner("on_slope", "f_1 alone."), &local.on_slope),
        (manner("on_slope_jacobian", "df_1/du_x and df_1/du_xt."), &local.on_slope_jacobian),
    ]
}

fn module(scene: &Scene<'_>, field: &FieldProgram, name: &Ident) -> Result<TokenStream, EmitError> {
    let mut locals = Namer::for_locals();
    for reserved in ["x", "point", "R", "PARAMETERS", "places"] {
        locals.reserve(reserved);
    }
    for table in &scene.tables {
        locals.reserve(&table.to_string());
    }
    let instance = field.field.quantities[0].name.path.split('.').next().unwrap_or_default();
    let own = |quantity: &Quantity| {
        let path = quantity.name.path.as_str();
        path.strip_prefix(instance).and_then(|own| own.strip_prefix('.')).unwrap_or(path).to_owned()
    };
    // In the order of the tapes' state: u, u_x, u_t, u_xt.
    let mut states: Vec<Ident> =
        field.field.quantities[..4].iter().map(|quantity| locals.claim(&own(quantity))).collect();
    states.push(format_ident!("x"));
    for parameter in &scene.parameters {
        locals.reserve(&parameter.to_string());
    }
    let scope = Scope {
        states: &states,
        parameters: &scene.parameters,
        constants: &[],
        tables: &scene.tables,
        namer: &locals,
    };
    let initial = Manner {
        name: "initial",
        doc: "u and u_t at the start.",
        of: Of::Place,
        results: &["value", "rate"],
    };
    let functions = functions(field).into_iter().chain([(initial, &field.initial)]);
    let functions = functions.chain(field.local.as_ref().into_iter().flat_map(local_functions));
    let functions = functions.map(|(manner, tape)| function(scene, &manner, tape, &scope));
    let functions = functions.collect::<Result<Vec<_>, _>>()?;
    let count = Literal::usize_unsuffixed(field.parameters.len());
    let parameters = field.parameters.iter().map(|id| Literal::u32_unsuffixed(id.0));
    let title = format!("The field {}", meaning(&field.field.quantities[0]));
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
        }
    })
}

fn function(
    scene: &Scene<'_>,
    manner: &Manner,
    tape: &Tape,
    scope: &Scope<'_>,
) -> Result<TokenStream, EmitError> {
    let name = manner.name;
    check_tape(tape, scene.program, scope.states.len())
        .map_err(|reason| EmitError::Malformed { function: name, reason })?;
    let names = manner.results.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
    let result_names = ResultNames { spread: false, names };
    let Body { statements, results, reads } = body(name, tape, scope, &result_names)?;
    let place = scope.states.len() - 1;
    let binds = |read: bool, name: &str| {
        if read { format_ident!("{name}") } else { format_ident!("_{name}") }
    };
    let (time, x) = (binds(reads.time, "time"), binds(reads.state.contains(&place), "x"));
    let p = binds(reads.parameters, "p");
    let of_point: Vec<usize> = reads.state.iter().copied().filter(|entry| *entry < place).collect();
    let point = binds(!of_point.is_empty(), "point");
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
    let operations = format!("{} operations.", tape_operations(tape));
    let docs = doc([manner.doc, "", operations.as_str()]);
    let (length, ident) = (Literal::usize_unsuffixed(results.len()), format_ident!("{name}"));
    // Loops over points move out what no point decides, if they see it.
    let is_looped_over = name == "inertia" || name.starts_with("on_");
    let inline = if is_looped_over { quote!(#[inline(always)]) } else { quote!(#[inline]) };
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

fn implementation(scene: &Scene<'_>, modules: &[Ident]) -> TokenStream {
    let machine = &scene.machine;
    let fields = &scene.program.fields;
    let count = Literal::usize_unsuffixed(fields.len());
    let statics = fields.iter().zip(modules).map(|(field, module)| statics(field, module));
    let statics: Vec<TokenStream> = statics.collect();
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
    let structure = structure(scene.program);
    let many = many_points(&numbers, modules, fields);
    let inertia = arms(&quote!(inertia(x, &p)));
    let initial = arms(&quote!(initial(x, &p)));
    quote! {
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
    }
}

/// What is known of the forms of the densities, where it is more than nothing.
fn structure(program: &Program) -> TokenStream {
    let fields = &program.fields;
    let known = |name: &str, holds: &dyn Fn(&FieldProgram) -> bool| {
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
    let reads_no_forces = (!program.jacobian_reads_forces()).then(|| {
        quote! {
            fn jacobian_reads_forces(&self) -> bool { false }
        }
    });
    quote!(#reads_no_forces #linear #local)
}

/// The functions for many points at once of fields whose forces are local: loops over
/// the point functions, out of which goes what no point decides.
fn many_points(numbers: &[Literal], modules: &[Ident], fields: &[FieldProgram]) -> TokenStream {
    let arms = |body: &dyn Fn(&Ident) -> TokenStream| {
        let arms = numbers.iter().zip(modules).zip(fields);
        let arms = arms.filter(|(_, field)| field.local.is_some()).map(|((number, module), _)| {
            let body = body(module);
            quote!(#number => #body)
        });
        let arms: Vec<TokenStream> = arms.collect();
        quote! {
            let p = parameters_of(parameters);
            match index {
                #(#arms)*
                _ => no_field(index),
            }
        }
    };
    if !fields.iter().any(|field| field.local.is_some()) {
        return TokenStream::new();
    }
    let inertias = arms(&|module| {
        quote! {
            for (inertia, x) in inertias.iter_mut().zip(x) {
                [*inertia] = #module::inertia(*x, &p);
            }
        }
    });
    let zero = quote!(R::literal(0.0));
    let values = arms(&|module| {
        quote! {
            for (((force, x), u), u_t) in forces.iter_mut().zip(x).zip(u).zip(u_t) {
                [*force] = #module::on_value(time, *x, &[*u, #zero, *u_t, #zero], &p);
            }
        }
    });
    let values_jacobian = arms(&|module| {
        quote! {
            for (((x, u), u_t), by) in x.iter().zip(u).zip(u_t).zip(by_u.iter_mut().zip(by_u_t)) {
                let point = [*u, #zero, *u_t, #zero];
                [*by.0, *by.1] = #module::on_value_jacobian(time, *x, &point, &p);
            }
        }
    });
    let values_by_time = arms(&|module| {
        quote! {
            for (((by_time, x), u), u_t) in by_time.iter_mut().zip(x).zip(u).zip(u_t) {
                let point = [*u, #zero, *u_t, #zero];
                [*by_time] = #module::on_value_by_time(time, *x, &point, &p);
            }
        }
    });
    let slopes = arms(&|module| {
        quote! {
            for ((force, u_x), u_xt) in forces.iter_mut().zip(u_x).zip(u_xt) {
                let point = [#zero, *u_x, #zero, *u_xt];
                [*force] = #module::on_slope(#zero, #zero, &point, &p);
            }
        }
    });
    let slopes_jacobian = arms(&|module| {
        quote! {
            for ((u_x, u_xt), by) in u_x.iter().zip(u_xt).zip(by_u_x.iter_mut().zip(by_u_xt)) {
                let point = [#zero, *u_x, #zero, *u_xt];
                [*by.0, *by.1] = #module::on_slope_jacobian(#zero, #zero, &point, &p);
            }
        }
    });
    quote! {
        fn field_inertias(&self, index: usize, x: &[R], parameters: &[R], inertias: &mut [R]) {
            #inertias
        }
        fn field_forces_on_values(
            &self, index: usize, time: R, [x, u, u_t]: [&[R]; 3], parameters: &[R],
            forces: &mut [R],
        ) {
            #values
        }
        fn field_forces_on_values_jacobian(
            &self, index: usize, time: R, [x, u, u_t]: [&[R]; 3], parameters: &[R],
            [by_u, by_u_t]: [&mut [R]; 2],
        ) {
            #values_jacobian
        }
        fn field_forces_on_values_by_time(
            &self, index: usize, time: R, [x, u, u_t]: [&[R]; 3], parameters: &[R],
            (_, by_time): (&mut [R], &mut [R]),
        ) {
            #values_by_time
        }
        fn field_forces_on_slopes(
            &self, index: usize, [u_x, u_xt]: [&[R]; 2], parameters: &[R], forces: &mut [R],
        ) {
            #slopes
        }
        fn field_forces_on_slopes_jacobian(
            &self, index: usize, [u_x, u_xt]: [&[R]; 2], parameters: &[R],
            [by_u_x, by_u_xt]: [&mut [R]; 2],
        ) {
            #slopes_jacobian
        }
    }
}

/// The static that describes a field.
fn constant(module: &Ident) -> Ident {
    format_ident!("{}_FIELD", module.to_string().to_ascii_uppercase())
}

fn statics(program: &FieldProgram, module: &Ident) -> TokenStream {
    let field = &program.field;
    // What is in a spec was checked to be finite when it was read.
    let number = |value: f64| literal(value).unwrap_or_else(|_| quote!(0.0));
    let quantity = |quantity: &Quantity| {
        let (name, unit, doc) = (&quantity.name.path, &quantity.unit, &quantity.doc);
        quote!(Quantity { name: #name, unit: #unit, doc: #doc })
    };
    let attachments = field.attachments.iter().map(|at| {
        let coordinate = at.coordinate.map(|id| Literal::u32_unsuffixed(id.0));
        let coordinate = coordinate.map_or_else(|| quote!(None), |id| quote!(Some(#id)));
        let place = format_ident!(
            "{}",
            match at.place {
                Place::Start => "Start",
                Place::Inside => "Inside",
                Place::End => "End",
            }
        );
        let handed = Literal::u32_unsuffixed(at.handed.0);
        let x = number(at.x);
        quote!(FieldAttachment {
            coordinate: #coordinate, place: FieldPlace::#place, at: #x, handed: #handed,
        })
    });
    let [value, slope, rate] = [0, 1, 2].map(|index| quantity(&field.quantities[index]));
    let scale = field.scale.map(number);
    let length = number(field.length_value);
    let fixed = field.fixed;
    let [elements, order] = [field.elements, field.order].map(Literal::usize_unsuffixed);
    let name = constant(module);
    quote! {
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
    }
}

//! Generic elements of a scene's fields: a module of point functions for each field, and the rows
//! that define `FieldScene`.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::body::{Body, ResultNames, Scope, body};
use super::describe::{call, meaning, number, string};
use super::functions::documentation;
use super::layout::broken;
use super::names::{Namer, argument, distinct};
use super::points;
use crate::emit::EmitError;
use crate::emit::text::doc;
use machinist_contract::field::ForceStructure;
use machinist_model::{FieldModel, Place, Quantity, Tape, operations};

/// Returns the modules of all fields; empty for a scene without fields.
pub(super) fn items(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let fields = &scene.model.fields;
    if fields.is_empty() {
        return Ok(TokenStream::new());
    }
    let idents = fields.iter().map(|field| field.quantities[0].name.ident.as_str());
    let modules = distinct(idents, "fields")?;
    let bodies = fields.iter().zip(&modules).map(|(field, name)| module(scene, field, name));
    let bodies = bodies.collect::<Result<Vec<_>, _>>()?;
    Ok(quote!(#(#bodies)*))
}

/// Signature and documentation of a point function.
struct Manner {
    name: &'static str,
    doc: &'static str,
    /// Arguments: time and the field at the point, x only, or neither.
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
    let instance =
        field.quantities[0].name.path.rsplit_once('.').map_or("", |(instance, _)| instance);
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
        parameters: &scene.parameters,
        own: scene.model.parameters.len(),
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
    let docs = documentation(manner.doc, operations(tape));
    let (length, ident) = (Literal::usize_unsuffixed(results.len()), format_ident!("{name}"));
    // The loop over points hoists whatever is equal for all points, if the function is inlined.
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

/// Returns the rows of `field_scene!`; empty for a scene without fields.
pub(super) fn description(scene: &Scene<'_>) -> Result<String, EmitError> {
    let model = scene.model;
    if model.fields.is_empty() {
        return Ok(String::new());
    }
    let reads_forces = model.jacobian_reads_forces();
    let mut rows = vec![format!("{}: jacobian_reads_forces {reads_forces};", scene.machine)];
    for (index, field) in model.fields.iter().enumerate() {
        let place = format!("field `{}`", field.quantities[0].name.path);
        let number = |value: f64| number(&place, value);
        let [scale, scale_of_rate, length] =
            [field.scale[0], field.scale[1], field.length].map(number);
        let [start, end] = field.fixed;
        let ForceStructure { linear, local, forces, derivatives } = field.structure();
        let head = format!(
            "{index} {}: linear {linear}, local {local}, forces {forces:?}, \
             derivatives {derivatives:?}, scale [{}, {}], fixed [{start}, {end}], length {}, \
             elements {}, order {};",
            field.quantities[0].name.ident,
            scale?,
            scale_of_rate?,
            length?,
            field.elements,
            field.order,
        );
        rows.extend(broken(&head, 4).iter().map(|line| line[4..].to_owned()));
        for (what, index) in [("value", 0), ("rate", 2), ("slope", 1)] {
            let Quantity { name, unit, doc } = &field.quantities[index];
            rows.push(format!("{what} {}, {}, {};", string(unit), string(&name.path), string(doc)));
        }
        for at in &field.attachments {
            // After the machine's own parameters.
            let handed = model.parameters.len() as u32 + at.handed;
            let (coordinate, x) = (at.coordinate, number(at.x)?);
            let place = match at.place {
                Place::Start => "Start",
                Place::Inside => "Inside",
                Place::End => "End",
            };
            rows.push(format!("at {x} => {place}, coordinate {coordinate:?}, handed {handed};"));
        }
    }
    Ok(call("field_scene", &rows))
}

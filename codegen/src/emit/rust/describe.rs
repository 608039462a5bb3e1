//! `Describe` and `Simulator` for the machine of an emitted module.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::Scene;
use crate::emit::EmitError;
use crate::emit::literal::literal;
use crate::emit::text::doc;
use machinist_model::{Direction, Quantity, StateKind};

/// Both implementations and the statics they read.
pub(super) fn implementations(
    scene: &Scene<'_>,
    has_series: bool,
) -> Result<TokenStream, EmitError> {
    let statics = statics(scene)?;
    let describe = describe(scene);
    let simulator = simulator(scene, has_series);
    Ok(quote!(#describe #simulator #statics))
}

fn describe(scene: &Scene<'_>) -> TokenStream {
    let model = scene.model;
    let machine = &scene.machine;
    let (name, title) = (&model.name, &model.title);
    let count = proc_macro2::Literal::usize_unsuffixed;
    let positions = count(model.positions());
    let first_order = count(model.first_order());
    let quadratures = count(model.quadratures);
    let layout_methods = (!model.is_whole()).then(|| {
        quote!(
            fn state_kind(&self, index: usize) -> StateKind {
                STATE_KINDS[index]
            }
            fn coordinate(&self, index: usize) -> Quantity<'_> {
                COORDINATE_QUANTITIES[index]
            }
        )
    });
    let event_methods = (!scene.model.events.is_empty()).then(|| {
        quote!(
            fn events(&self) -> usize {
                EVENTS
            }
            fn event(&self, index: usize) -> Event<'_> {
                EVENT_SHAPES[index]
            }
        )
    });
    let modes = mode_places(scene);
    let is_mode = (!modes.is_empty()).then(|| {
        quote!(
            fn is_mode(&self, index: usize) -> bool {
                matches!(index, #(#modes)|*)
            }
        )
    });
    let constraint_methods = constraint_methods(scene);
    quote! {
        impl Describe for #machine {
            fn name(&self) -> &'static str { #name }
            fn title(&self) -> &'static str { #title }
            fn shape(&self) -> Shape {
                Shape {
                    coordinates: COORDINATES,
                    positions: #positions,
                    first_order: #first_order,
                    quadratures: #quadratures,
                    parameters: PARAMETERS,
                    outputs: OUTPUTS,
                    discontinuities: DISCONTINUITIES,
                }
            }
            fn state(&self, index: usize) -> Quantity<'_> { STATE_QUANTITIES[index] }
            #layout_methods
            fn state_scale(&self, index: usize) -> f64 { STATE_SCALES[index] }
            fn parameter(&self, index: usize) -> Quantity<'_> { PARAMETER_QUANTITIES[index] }
            fn parameter_default(&self, index: usize) -> f64 { PARAMETER_DEFAULTS[index] }
            fn output(&self, index: usize) -> Quantity<'_> { OUTPUT_QUANTITIES[index] }
            fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> { RATE_JACOBIAN_PATTERN }
            fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
                PARAMETER_JACOBIAN_PATTERN
            }
            fn mass_matrix_pattern(&self) -> SparsityPattern<'_> { MASS_MATRIX_PATTERN }
            fn run_defaults(&self) -> RunDefaults<'_> { RUN_DEFAULTS }
            #event_methods
            #is_mode
            #constraint_methods
        }
    }
}

/// Nothing for a scene without constraints.
fn constraint_methods(scene: &Scene<'_>) -> Option<TokenStream> {
    let model = scene.model;
    let given = model.states.iter().enumerate().filter(|(_, state)| state.is_given);
    let given = given.map(|(index, _)| proc_macro2::Literal::usize_unsuffixed(index));
    let given: Vec<_> = given.collect();
    let given = if given.is_empty() { quote!(false) } else { quote!(matches!(index, #(#given)|*)) };
    let is_any_given = model.states.iter().any(|state| state.is_given);
    let index = if is_any_given { quote!(index) } else { quote!(_index) };
    (!model.constraints.is_empty()).then(|| {
        quote!(
            fn constraints(&self) -> usize {
                CONSTRAINTS
            }
            fn constraint(&self, index: usize) -> Constraint<'_> {
                CONSTRAINT_SHAPES[index]
            }
            fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
                CONSTRAINT_MATRIX_PATTERN
            }
            fn is_given(&self, #index: usize) -> bool {
                #given
            }
        )
    })
}

/// What the scene's constraints are, if it has any.
fn constraint_shapes(scene: &Scene<'_>) -> Option<TokenStream> {
    let constraints = &scene.model.constraints;
    let shapes = constraints.iter().map(|constraint| {
        let (name, unit, doc) = (&constraint.name.path, &constraint.unit, &constraint.doc);
        let is_of_positions = constraint.is_of_positions;
        quote! {
            Constraint { name: #name, unit: #unit, doc: #doc, is_of_positions: #is_of_positions }
        }
    });
    let docs = doc(["What coordinates must fulfil."]);
    (!constraints.is_empty()).then(|| {
        quote! {
            #docs
            pub static CONSTRAINT_SHAPES: [Constraint<'static>; CONSTRAINTS] = [#(#shapes),*];
        }
    })
}

fn simulator(scene: &Scene<'_>, has_series: bool) -> TokenStream {
    let taylor = has_series.then(|| {
        quote!(
            fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
                Some(self)
            }
        )
    });
    let linear = scene.model.excitation.is_some().then(|| {
        quote!(
            fn linear(&self) -> Option<&dyn LinearEquations<R>> {
                Some(self)
            }
        )
    });
    let machine = &scene.machine;
    let of_parameters = ["initial_state", "discontinuities"].map(|name| {
        let name = format_ident!("{name}");
        quote! {
            fn #name(&self, parameters: &[R], values: &mut [R]) {
                *array_of(values) = #name(&parameters_of(parameters));
            }
        }
    });
    let delegate = |name: &str, to_array: Option<TokenStream>| {
        let name = format_ident!("{name}");
        quote! {
            fn #name(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
                *array_of(values) =
                    #name(time, state_of(state), &parameters_of(parameters)) #to_array;
            }
        }
    };
    let arrays = [
        "rate",
        "rate_jacobian",
        "parameter_jacobian",
        "time_derivative",
        "mass_matrix",
        "forcing",
    ]
    .map(|name| delegate(name, None));
    let event_functions: &[&str] = match scene.model.events.len() {
        0 => &[],
        _ => &["guards", "guard_rates", "resets"],
    };
    let event_functions = event_functions.iter().map(|name| delegate(name, None));
    let constraint_functions: &[&str] = match scene.model.constraints.len() {
        0 => &[],
        _ => &["constraint_values", "constraint_rates", "constraint_matrix"],
    };
    let constraint_functions = constraint_functions.iter().map(|name| delegate(name, None));
    let outputs = delegate("outputs", Some(quote!(.to_array())));
    let structs =
        [("energy", "Energy"), ("power_balance", "PowerBalance")].map(|(name, result)| {
            let (name, result) = (format_ident!("{name}"), format_ident!("{result}"));
            quote! {
                fn #name(&self, time: R, state: &[R], parameters: &[R]) -> #result<R> {
                    #name(time, state_of(state), &parameters_of(parameters))
                }
            }
        });
    let prepared = (!scene.prepare.is_empty()).then(prepared);
    let constants_of = prepared.is_some().then(|| {
        quote! {
            #[inline]
            fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
                let values: &[R; CONSTANTS] =
                    constants.try_into().expect("there are CONSTANTS constants");
                Constants::from_array(*values)
            }
        }
    });
    quote! {
        impl<R: Real> Simulator<R> for #machine {
            #prepared
            #(#of_parameters)*
            #(#arrays)*
            #outputs
            #(#structs)*
            #(#event_functions)*
            #(#constraint_functions)*
            #taylor
            #linear
        }
        #constants_of
        #[inline]
        fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
            values.try_into().expect("there is one place for each value")
        }
        #[inline]
        fn state_of<R>(state: &[R]) -> &[R; STATES] {
            state.try_into().expect("the state has STATES entries")
        }
        #[inline]
        fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
            let values: &[R; PARAMETERS] =
                parameters.try_into().expect("there are PARAMETERS parameters");
            Parameters::from_array(*values)
        }
    }
}

/// What a simulator with constants has instead of the defaults.
fn prepared() -> TokenStream {
    let functions = ["prepared_rate", "prepared_rate_jacobian"].map(|name| {
        let name = format_ident!("{name}");
        quote! {
            fn #name(
                &self,
                time: R,
                state: &[R],
                parameters: &[R],
                constants: &[R],
                values: &mut [R],
            ) {
                let (p, c) = (parameters_of(parameters), constants_of(constants));
                *array_of(values) = #name(time, state_of(state), &p, &c);
            }
        }
    });
    quote! {
        fn constants(&self) -> usize { CONSTANTS }
        fn prepare(&self, parameters: &[R], constants: &mut [R]) {
            *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
        }
        #(#functions)*
    }
}

fn statics(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let model = scene.model;
    let states = quantities(scene.model.states.iter().map(|state| &state.quantity));
    let parameters = quantities(model.all_parameters().map(|parameter| &parameter.quantity));
    let outputs = quantities(model.wanted.iter());
    let scales = numbers("scale of a state", scene.model.states.iter().map(|state| state.scale))?;
    let defaults = numbers("parameter", model.all_parameters().map(|p| p.value))?;
    let run = run_defaults(scene)?;
    let layout = layout_statics(scene);
    let events = event_shapes(scene)?;
    let constraints = constraint_shapes(scene);
    Ok(quote! {
        #layout
        static STATE_QUANTITIES: [Quantity<'static>; STATES] = [#(#states),*];
        static STATE_SCALES: [f64; STATES] = [#(#scales),*];
        static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [#(#parameters),*];
        static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [#(#defaults),*];
        static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [#(#outputs),*];
        #run
        #events
        #constraints
    })
}

/// What only a simulator says whose state is not \[q, q', z\].
fn layout_statics(scene: &Scene<'_>) -> Option<TokenStream> {
    let model = scene.model;
    if model.is_whole() {
        return None;
    }
    let kinds = model.states.iter().map(|state| match state.kind {
        StateKind::Position(_) => quote!(StateKind::Position),
        StateKind::Velocity(_) => quote!(StateKind::Velocity),
        StateKind::FirstOrder | StateKind::Mode => quote!(StateKind::FirstOrder),
    });
    let coordinates = quantities(model.coordinates.iter().map(|c| &c.position));
    Some(quote! {
        static STATE_KINDS: [StateKind; STATES] = [#(#kinds),*];
        static COORDINATE_QUANTITIES: [Quantity<'static>; COORDINATES] = [#(#coordinates),*];
    })
}

/// Entries of the state that are modes.
fn mode_places(scene: &Scene<'_>) -> Vec<proc_macro2::Literal> {
    let states = scene.model.states.iter().enumerate();
    let modes = states.filter(|(_, state)| state.kind == StateKind::Mode);
    modes.map(|(index, _)| proc_macro2::Literal::usize_unsuffixed(index)).collect()
}

/// What the scene's events are, if it has any.
fn event_shapes(scene: &Scene<'_>) -> Result<Option<TokenStream>, EmitError> {
    let events = &scene.model.events;
    if events.is_empty() {
        return Ok(None);
    }
    let entry = |entry: &u32| proc_macro2::Literal::u32_unsuffixed(*entry);
    let shapes = events.iter().map(|event| {
        let (name, doc) = (&event.name.path, &event.doc);
        let direction = match event.direction {
            Direction::Rising => quote!(Direction::Rising),
            Direction::Falling => quote!(Direction::Falling),
            Direction::Both => quote!(Direction::Both),
        };
        let values = numbers("mode of an event", event.when.iter().map(|(_, value)| *value))?;
        let modes = event.when.iter().map(|(mode, _)| entry(mode));
        let sets = event.sets.iter().map(entry);
        Ok(quote! {
            Event {
                name: #name,
                doc: #doc,
                direction: #direction,
                when: &[#((#modes, #values)),*],
                sets: &[#(#sets),*],
            }
        })
    });
    let shapes = shapes.collect::<Result<Vec<_>, EmitError>>()?;
    let docs = doc(["What happens where guards pass zero."]);
    Ok(Some(quote! {
        #docs
        pub static EVENT_SHAPES: [Event<'static>; EVENTS] = [#(#shapes),*];
    }))
}

fn quantities<'a>(quantities: impl Iterator<Item = &'a Quantity>) -> Vec<TokenStream> {
    let quantities = quantities.map(|quantity| {
        let (name, unit, doc) = (&quantity.name.path, &quantity.unit, &quantity.doc);
        quote!(Quantity { name: #name, unit: #unit, doc: #doc })
    });
    quantities.collect()
}

fn numbers(place: &str, values: impl Iterator<Item = f64>) -> Result<Vec<TokenStream>, EmitError> {
    let literals = values.map(|value| {
        literal(value).map_err(|_| EmitError::NotFinite { place: place.to_owned(), value })
    });
    literals.collect()
}

fn run_defaults(scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
    let run = &scene.model.run;
    let numbers = numbers("run", [run.from, run.until, run.rtol].into_iter())?;
    let [from, until, rtol] = [&numbers[0], &numbers[1], &numbers[2]];
    let points = proc_macro2::Literal::usize_unsuffixed(run.points);
    let method = &run.method;
    let docs = doc(["The run the spec asks for."]);
    Ok(quote! {
        #docs
        pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
            from: #from,
            until: #until,
            points: #points,
            rtol: #rtol,
            method: #method,
        };
    })
}

//! `Describe` and `Simulator` of an emitted module, from its descriptions and free functions.

/// Defines the unit struct of a machine with the traits of the contract. It uses the definitions
/// of `parameters!`, `outputs!`, `states!` and `patterns!`, and free functions named as in the
/// [table](crate::for_each_function):
///
/// ```text
/// simulator! {
///     /// Documentation.
///     Machine: "name", "title";
///     run from 0.0, until 2.0, points 2001, rtol 1e-8, method "taylor";
///     quadratures 0, discontinuities 0;
///     parts
/// }
/// ```
///
/// Parts are optional features of a machine, each followed by a semicolon: `coordinates` (see
/// `coordinates!`), `events`, `constraints`, `equilibrium`, `kinks COUNT`, `inertia_corners`,
/// `saturations COUNT`, `relations`, `prepared` (see `constants!`), `series LANES` (that many sums of
/// products per order) or `series LANES has_corners`, and `linear`. `prepared` takes `jacobians_at_once` if
/// `prepared_jacobians` computes both Jacobians, else `jacobians_apart`.
#[macro_export]
macro_rules! simulator {
    (
        $(#[$attribute:meta])*
        $machine:ident: $name:literal, $title:literal;
        run from $from:expr, until $until:expr, points $points:literal, rtol $rtol:expr,
            method $method:literal $(, times [$($time:expr),*])?;
        quadratures $quadratures:literal, discontinuities $discontinuities:literal;
        $($part:ident $($argument:literal $($corners:ident)?)?;)*
    ) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub struct $machine;

        /// Number of times at which the right-hand side is discontinuous.
        pub const DISCONTINUITIES: usize = $discontinuities;

        /// Default settings of the run.
        pub const RUN_DEFAULTS: $crate::RunDefaults<'static> = $crate::RunDefaults {
            from: $from,
            until: $until,
            points: $points,
            times: &[$($($time),*)?],
            rtol: $rtol,
            method: $method,
        };

        impl $crate::Describe for $machine {
            fn name(&self) -> &'static str {
                $name
            }
            fn title(&self) -> &'static str {
                $title
            }
            fn shape(&self) -> $crate::Shape {
                const SHAPE: $crate::Shape = $crate::Shape {
                    quadratures: $quadratures,
                    parameters: PARAMETERS,
                    outputs: OUTPUTS,
                    discontinuities: DISCONTINUITIES,
                    ..$crate::emitted::shape_of(STATE_ROWS)
                };
                SHAPE
            }
            fn state(&self, index: usize) -> $crate::Quantity<'_> {
                STATE_ROWS[index].quantity
            }
            fn state_kind(&self, index: usize) -> $crate::StateKind {
                STATE_ROWS[index].kind
            }
            fn state_scale(&self, index: usize) -> f64 {
                STATE_ROWS[index].scale
            }
            fn parameter(&self, index: usize) -> $crate::Quantity<'_> {
                PARAMETER_QUANTITIES[index]
            }
            fn parameter_default(&self, index: usize) -> f64 {
                PARAMETER_DEFAULTS[index]
            }
            fn output(&self, index: usize) -> $crate::Quantity<'_> {
                OUTPUT_QUANTITIES[index]
            }
            fn output_answers_at_once(&self, index: usize) -> bool {
                OUTPUTS_AT_ONCE[index]
            }
            fn rate_jacobian_pattern(&self) -> $crate::SparsityPattern<'_> {
                RATE_JACOBIAN_PATTERN
            }
            fn parameter_jacobian_pattern(&self) -> $crate::SparsityPattern<'_> {
                PARAMETER_JACOBIAN_PATTERN
            }
            fn mass_matrix_pattern(&self) -> $crate::SparsityPattern<'_> {
                MASS_MATRIX_PATTERN
            }
            fn run_defaults(&self) -> $crate::RunDefaults<'_> {
                RUN_DEFAULTS
            }
            fn is_mode(&self, index: usize) -> bool {
                STATE_ROWS[index].is_mode
            }
            fn is_given(&self, index: usize) -> bool {
                STATE_ROWS[index].is_given
            }
            $($crate::__describe_part! { $part })*
        }

        impl<R: $crate::Real> $crate::Simulator<R> for $machine {
            $crate::for_each_function! { [$crate::__delegate] every }
            $($crate::__simulate_part! { $part })*
            fn derivatives(&self) -> ::core::option::Option<&dyn $crate::Derivatives> {
                ::core::option::Option::Some(self)
            }
            fn ranges(&self) -> ::core::option::Option<&dyn $crate::Ranges> {
                ::core::option::Option::Some(self)
            }
        }

        $($crate::__part! { $machine $part $($argument $($corners)?)? })*
    };
}

/// Implements the methods of `Describe` for a part.
#[doc(hidden)]
#[macro_export]
macro_rules! __describe_part {
    (coordinates) => {
        fn coordinate(&self, index: usize) -> $crate::Quantity<'_> {
            COORDINATE_QUANTITIES[index]
        }
    };
    (events) => {
        fn events(&self) -> usize {
            EVENTS
        }
        fn event(&self, index: usize) -> $crate::Event<'_> {
            EVENT_SHAPES[index]
        }
    };
    (constraints) => {
        fn constraints(&self) -> usize {
            CONSTRAINTS
        }
        fn constraint(&self, index: usize) -> $crate::Constraint<'_> {
            CONSTRAINT_SHAPES[index]
        }
        fn constraint_matrix_pattern(&self) -> $crate::SparsityPattern<'_> {
            CONSTRAINT_MATRIX_PATTERN
        }
    };
    (kinks) => {
        fn kinks(&self) -> usize {
            KINKS
        }
    };
    (saturations) => {
        fn saturations(&self) -> usize {
            SATURATIONS
        }
    };
    (relations) => {
        fn relations(&self) -> usize {
            RELATION_ROWS.len()
        }
        fn relation(&self, index: usize) -> $crate::Relation<'_> {
            RELATION_ROWS[index]
        }
    };
    (inertia_corners) => {
        fn inertia_has_corners(&self) -> bool {
            true
        }
    };
    (equilibrium) => {
        fn starts_in_equilibrium(&self) -> bool {
            true
        }
    };
    ($other:ident) => {};
}

/// Implements the methods of `Simulator` for a part.
#[doc(hidden)]
#[macro_export]
macro_rules! __simulate_part {
    (events) => {
        $crate::for_each_function! { [$crate::__delegate] events }
    };
    (constraints) => {
        $crate::for_each_function! { [$crate::__delegate] constraints }
    };
    (kinks) => {
        $crate::for_each_function! { [$crate::__delegate] kinks }
    };
    (saturations) => {
        $crate::for_each_function! { [$crate::__delegate] saturations }
    };
    (prepared) => {
        fn constants(&self) -> usize {
            CONSTANTS
        }
        fn prepare(&self, parameters: &[R], constants: &mut [R]) {
            *$crate::emitted::places_of(constants) =
                prepare(&Parameters::from_slice(parameters)).to_array();
        }
        $crate::__simulate_part! { by_constants prepared_rate }
        $crate::__simulate_part! { by_constants prepared_rate_jacobian }
    };
    (jacobians_apart) => {
        $crate::__simulate_part! { by_constants prepared_parameter_jacobian }
    };
    (jacobians_at_once) => {
        $crate::__simulate_part! { by_constants prepared_jacobians }
        // Calls the method, as the free functions below do.
        fn prepared_parameter_jacobian(
            &self,
            time: R,
            state: &[R],
            parameters: &[R],
            constants: &[R],
            values: &mut [R],
        ) {
            const BY_STATE: usize = RATE_JACOBIAN_PATTERN.entries.len();
            const BOTH: usize = BY_STATE + PARAMETER_JACOBIAN_PATTERN.entries.len();
            let mut both = [R::literal(0.0); BOTH];
            $crate::Simulator::<R>::prepared_jacobians(
                self, time, state, parameters, constants, &mut both,
            );
            values.copy_from_slice(&both[BY_STATE..]);
        }
    };
    (by_constants $name:ident) => {
        fn $name(&self, time: R, state: &[R], parameters: &[R], constants: &[R], values: &mut [R]) {
            let (p, c) = (Parameters::from_slice(parameters), Constants::from_slice(constants));
            *$crate::emitted::places_of(values) =
                $name(time, $crate::emitted::array_of(state), &p, &c);
        }
    };
    (series) => {
        fn taylor(&self) -> ::core::option::Option<&dyn $crate::taylor::TaylorSeries<R>> {
            ::core::option::Option::Some(self)
        }
    };
    (linear) => {
        fn linear(&self) -> ::core::option::Option<&dyn $crate::linear::LinearEquations<R>> {
            ::core::option::Option::Some(self)
        }
    };
    ($other:ident) => {};
}

/// Defines further items for a part.
#[doc(hidden)]
#[macro_export]
macro_rules! __part {
    ($machine:ident prepared) => {
        $crate::__part! {
            by_constants $machine rate prepared_rate STATES;
            "`y'`: [`prepared_rate`] by constants that [`prepare`] computes on the way."
        }
        $crate::__part! {
            by_constants $machine rate_jacobian prepared_rate_jacobian
            RATE_JACOBIAN_PATTERN.entries.len();
            "`dy'/dy`: [`prepared_rate_jacobian`] by constants that [`prepare`] computes on the \
way."
        }
    };
    ($machine:ident jacobians_apart) => {
        $crate::__part! { $machine parameter_jacobian }
    };
    ($machine:ident jacobians_at_once) => {
        $crate::__part! { $machine parameter_jacobian }
    };
    ($machine:ident parameter_jacobian) => {
        $crate::__part! {
            by_constants $machine parameter_jacobian prepared_parameter_jacobian
            PARAMETER_JACOBIAN_PATTERN.entries.len();
            "`dy'/dp`, by constants that [`prepare`] computes on the way."
        }
    };
    // Calls the method, so that it is the only caller of the function. The function is then
    // inlined into it and reads parameters and constants in place.
    (
        by_constants $machine:ident $name:ident $prepared:ident $length:expr; $doc:literal
    ) => {
        #[doc = $doc]
        #[must_use]
        pub fn $name<R: $crate::Real>(
            time: R,
            state: &[R; STATES],
            p: &Parameters<R>,
        ) -> [R; $length] {
            let mut values = [R::literal(0.0); $length];
            let (parameters, constants) = (p.to_array(), prepare(p).to_array());
            $crate::Simulator::$prepared(
                &$machine,
                time,
                state,
                &parameters,
                &constants,
                &mut values,
            );
            values
        }
    };
    ($machine:ident series $lanes:literal $($corners:ident)?) => {
        impl<R: $crate::Real> $crate::taylor::TaylorSeries<R> for $machine {
            fn series_workspace(&self, order: usize) -> usize {
                $crate::taylor::Lanes::<R, $lanes>::workspace(order + 1)
            }
            fn series(
                &self,
                time: R,
                state: &[R],
                parameters: &[R],
                coefficients: &mut [R],
                workspace: &mut [R],
            ) {
                let (coefficients, rest) = coefficients.as_chunks_mut();
                assert!(rest.is_empty(), "every order has STATES coefficients");
                let p = Parameters::from_slice(parameters);
                let state = $crate::emitted::array_of(state);
                series(time, state, &p, coefficients, workspace);
            }
            $(
                fn $corners(&self) -> bool {
                    true
                }
            )?
        }
    };
    ($machine:ident linear) => {
        impl<R: $crate::Real> $crate::linear::LinearEquations<R> for $machine {
            fn excitation_terms(&self) -> &[(u32, u32)] {
                &EXCITATION_TERMS
            }
            fn slopes(&self) -> &[(u32, u32)] {
                &SLOPES
            }
            fn excitation(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
                let state = $crate::emitted::array_of(state);
                let p = Parameters::from_slice(parameters);
                values.copy_from_slice(&excitation(time, state, &p));
            }
            fn switches(&self) -> usize {
                SWITCHES
            }
            fn switch_times(&self, parameters: &[R], times: &mut [R]) {
                times.copy_from_slice(&switches(&Parameters::from_slice(parameters)));
            }
        }
    };
    ($machine:ident kinks $count:literal) => {
        /// Number of guards of switching surfaces of the rate.
        pub const KINKS: usize = $count;
    };
    ($machine:ident saturations $count:literal) => {
        /// Number of arguments of functions that saturate.
        pub const SATURATIONS: usize = $count;
    };
    ($machine:ident $other:ident) => {};
}

/// Defines methods that call the free functions of a group of the table.
#[doc(hidden)]
#[macro_export]
macro_rules! __delegate {
    ([every] every { $($row:tt)* } $($others:tt)*) => {
        $($crate::__delegate_function! $row)*
    };
    ([events] every $every:tt events { $($row:tt)* } $($others:tt)*) => {
        $($crate::__delegate_function! $row)*
    };
    (
        [constraints] every $every:tt events $events:tt constraints { $($row:tt)* } $($others:tt)*
    ) => {
        $($crate::__delegate_function! $row)*
    };
    (
        [kinks] every $every:tt events $events:tt constraints $constraints:tt
        kinks { $($row:tt)* } $($others:tt)*
    ) => {
        $($crate::__delegate_function! $row)*
    };
    (
        [saturations] every $every:tt events $events:tt constraints $constraints:tt kinks $kinks:tt
        saturations { $($row:tt)* }
    ) => {
        $($crate::__delegate_function! $row)*
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __delegate_function {
    ($id:ident $name:ident Parameters $result:tt [] $meaning:literal $doc:literal) => {
        fn $name(&self, parameters: &[R], values: &mut [R]) {
            *$crate::emitted::places_of(values) = $name(&Parameters::from_slice(parameters));
        }
    };
    (
        $id:ident $name:ident Motion [structure $structure:ident $($field:ident)*] []
        $meaning:literal $doc:literal
    ) => {
        fn $name(&self, time: R, state: &[R], parameters: &[R]) -> $crate::$structure<R> {
            let p = Parameters::from_slice(parameters);
            $name(time, $crate::emitted::array_of(state), &p)
        }
    };
    (
        $id:ident $name:ident Motion [record $structure:ident $length:ident] [] $meaning:literal
        $doc:literal
    ) => {
        fn $name(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
            let p = Parameters::from_slice(parameters);
            *$crate::emitted::places_of(values) =
                $name(time, $crate::emitted::array_of(state), &p).to_array();
        }
    };
    (
        $id:ident $name:ident Motion $result:tt [$($prepared:ident)?] $meaning:literal
        $doc:literal
    ) => {
        fn $name(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
            let p = Parameters::from_slice(parameters);
            *$crate::emitted::places_of(values) = $name(time, $crate::emitted::array_of(state), &p);
        }
    };
}

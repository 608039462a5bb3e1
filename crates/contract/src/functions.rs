//! The table of functions: everything that simulators compute, listed once.
//!
//! The methods of [`Simulator`](crate::Simulator), the rows of models, the methods of their
//! interpreters and compilers, and the signatures and docs of emitted code follow from this
//! table. A new function takes a row here and an implementation.

/// Calls a macro with the table of functions, after further arguments.
///
/// ```text
/// for_each_function! { [my_macro] arguments }
/// // becomes
/// my_macro! {
///     [arguments] every { ROWS } events { ROWS } constraints { ROWS } kinks { ROWS }
///     saturations { ROWS }
/// }
/// ```
///
/// Rows are grouped: functions of every simulator, of those with events, of those with
/// constraints, of those whose rate has switching surfaces, and of those whose rate has functions
/// that saturate. A row is
///
/// ```text
/// { Id name Reads [result] [prepared] "few signs" "documentation" }
/// ```
///
/// where `Reads` is `Parameters` or `Motion` (time, state and parameters). `prepared` is the name
/// of the same function with constants computed once a run, or empty. The result is
///
/// ```text
/// [numbers LENGTH]               as many numbers as the constant of that name says
/// [record Struct LENGTH]         likewise, a struct of them in emitted code
/// [matrix PATTERN]               values of the nonzeros of a pattern
/// [structure Struct fields ..]   a struct of the contract
/// ```
#[macro_export]
macro_rules! for_each_function {
    ([$($callback:tt)+] $($arguments:tt)*) => {
        $($callback)+! {
            [$($arguments)*]
            every {
                { InitialState initial_state Parameters [numbers STATES] [] "y at the start"
                    "State at the start of the run, in the units of the states." }
                { Discontinuities discontinuities Parameters [numbers DISCONTINUITIES] []
                    "times of jumps"
                    "Times of known jumps of the right-hand side \\[s\\], unsorted." }
                { Rate rate Motion [numbers STATES] [prepared_rate] "y' = [q', M^-1 f, z']"
                    "`y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of \
                     the states per second." }
                { MassMatrix mass_matrix Motion [matrix MASS_MATRIX_PATTERN] [] "M"
                    "`M = d2L/dq'2`, values in the order of its pattern." }
                { Forcing forcing Motion [numbers COORDINATES] [] "f"
                    "`f` of `M q'' = f + G^T lambda`, one for each coordinate." }
                { RateJacobian rate_jacobian Motion [matrix RATE_JACOBIAN_PATTERN]
                    [prepared_rate_jacobian] "dy'/dy"
                    "`dy'/dy`, values in the order of its pattern." }
                { ParameterJacobian parameter_jacobian Motion [matrix PARAMETER_JACOBIAN_PATTERN]
                    [prepared_parameter_jacobian] "dy'/dp"
                    "`dy'/dp`, values in the order of its pattern." }
                { TimeDerivative time_derivative Motion [numbers STATES]
                    [prepared_time_derivative] "partial y'/partial t"
                    "Partial derivative of `y'` with respect to time." }
                { Outputs outputs Motion [record Outputs OUTPUTS] [] "wanted outputs"
                    "Wanted outputs." }
                { Energy energy Motion [structure Energy kinetic potential stored] []
                    "T, V, stored"
                    "T, V and the energy of first-order states \\[J\\]." }
                { PowerBalance power_balance Motion
                    [structure PowerBalance stored_rate supplied dissipated] []
                    "dE/dt, supplied, dissipated"
                    "`dE/dt`, power supplied and power dissipated \\[W\\]." }
            }
            events {
                { Guards guards Motion [numbers EVENTS] [] "what passes zero"
                    "What passes zero where events happen, one for each event." }
                { GuardRates guard_rates Motion [numbers EVENTS] [] "rates of the guards"
                    "`dg/dt` of the guards along the motion." }
                { Resets resets Motion [numbers RESETS] [] "new values"
                    "New values of the entries that each event sets, computed from the state \
                     before it: those of the first event, in the order of its `sets`, then those \
                     of the second, and so on." }
            }
            constraints {
                { ConstraintValues constraint_values Motion [numbers CONSTRAINTS] [] "g"
                    "`g` of each constraint, zero for those of velocities alone." }
                { ConstraintRates constraint_rates Motion [numbers CONSTRAINTS] [] "g'"
                    "`g'` of each constraint." }
                { ConstraintMatrix constraint_matrix Motion [matrix CONSTRAINT_MATRIX_PATTERN] []
                    "G = dg'/dq'"
                    "`G = dg'/dq'`, values in the order of its pattern." }
            }
            kinks {
                { KinkGuards kink_guards Motion [numbers KINKS] [] "guards of switching surfaces"
                    "What passes zero where the rate has a kink or a jump: arguments of `abs` and \
                     `sign`, differences of what `min` and `max` compare, ends of tables." }
                { KinkRates kink_rates Motion [numbers KINKS] [] "rates of these"
                    "Rates along the motion of what passes zero at kinks." }
            }
            saturations {
                { SaturatingArguments saturating_arguments Motion [numbers SATURATIONS] []
                    "arguments of functions that saturate"
                    "Arguments of functions that are flat far from a place, such as `tanh` far \
                     from zero. Steps by series are checked where one passes zero or turns." }
            }
        }
    };
}

/// Defines the methods of [`Simulator`](crate::Simulator). Those of every simulator are required;
/// the others compute nothing by default.
macro_rules! methods {
    (
        []
        every { $($every:tt)* }
        events { $($events:tt)* }
        constraints { $($constraints:tt)* }
        kinks { $($kinks:tt)* }
        saturations { $($saturations:tt)* }
    ) => {
        $(crate::functions::method! { required $every })*
        $(crate::functions::method! { provided $events })*
        $(crate::functions::method! { provided $constraints })*
        $(crate::functions::method! { provided $kinks })*
        $(crate::functions::method! { provided $saturations })*
    };
}
pub(crate) use methods;

macro_rules! method {
    (required {
        $id:ident $name:ident Parameters $result:tt [] $meaning:literal $doc:literal
    }) => {
        #[doc = $doc]
        fn $name(&self, parameters: &[R], values: &mut [R]);
    };
    (required {
        $id:ident $name:ident Motion [structure $structure:ident $($field:ident)*] [] $meaning:literal
        $doc:literal
    }) => {
        #[doc = $doc]
        fn $name(&self, time: R, state: &[R], parameters: &[R]) -> crate::$structure<R>;
    };
    (required {
        $id:ident $name:ident Motion $result:tt [$($prepared:ident)?] $meaning:literal $doc:literal
    }) => {
        #[doc = $doc]
        fn $name(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]);
        $(
            #[doc = concat!(
                "As [`Simulator::", stringify!($name), "`], to the last bit, by constants that ",
                "[`Simulator::prepare`] has computed from the same parameters."
            )]
            fn $prepared(
                &self,
                time: R,
                state: &[R],
                parameters: &[R],
                _constants: &[R],
                values: &mut [R],
            ) {
                self.$name(time, state, parameters, values);
            }
        )?
    };
    (provided {
        $id:ident $name:ident Motion $result:tt [] $meaning:literal $doc:literal
    }) => {
        #[doc = $doc]
        fn $name(&self, _time: R, _state: &[R], _parameters: &[R], _values: &mut [R]) {}
    };
}
pub(crate) use method;

//! Building blocks of emitted modules: descriptions with one row per line, and the items that
//! follow from them.

use crate::{Event, Quantity, Shape, StateKind};

/// Description of an entry of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StateRow<'a> {
    /// Name, unit and meaning.
    pub quantity: Quantity<'a>,
    /// Kind of the entry.
    pub kind: StateKind,
    /// Typical size, which scales its absolute tolerance.
    pub scale: f64,
    /// True for a mode, a whole number that only events change.
    pub is_mode: bool,
    /// True if the initial value is given, so that constraints do not change it.
    pub is_given: bool,
}

impl<'a> StateRow<'a> {
    const fn of(kind: StateKind, scale: f64, quantity: Quantity<'a>) -> Self {
        Self { quantity, kind, scale, is_mode: false, is_given: true }
    }

    /// Returns the row of a position, or of the difference of two.
    #[must_use]
    pub const fn position(scale: f64, quantity: Quantity<'a>) -> Self {
        Self::of(StateKind::Position, scale, quantity)
    }

    /// Returns the row of a velocity.
    #[must_use]
    pub const fn velocity(scale: f64, quantity: Quantity<'a>) -> Self {
        Self::of(StateKind::Velocity, scale, quantity)
    }

    /// Returns the row of a first-order state.
    #[must_use]
    pub const fn first_order(scale: f64, quantity: Quantity<'a>) -> Self {
        Self::of(StateKind::FirstOrder, scale, quantity)
    }

    /// Returns the row of a mode.
    #[must_use]
    pub const fn mode(scale: f64, quantity: Quantity<'a>) -> Self {
        Self { is_mode: true, ..Self::first_order(scale, quantity) }
    }

    /// Returns the row with its initial value marked as a guess.
    #[must_use]
    pub const fn guess(self) -> Self {
        Self { is_given: false, ..self }
    }
}

/// Returns the shape, as far as the rows of the states determine it.
#[must_use]
pub const fn shape_of(states: &[StateRow<'_>]) -> Shape {
    let mut shape = Shape {
        coordinates: 0,
        positions: 0,
        first_order: 0,
        quadratures: 0,
        parameters: 0,
        outputs: 0,
        discontinuities: 0,
    };
    let mut index = 0;
    while index < states.len() {
        match states[index].kind {
            StateKind::Position => shape.positions += 1,
            StateKind::Velocity => shape.coordinates += 1,
            StateKind::FirstOrder => shape.first_order += 1,
        }
        index += 1;
    }
    shape
}

/// Returns the number of values that events reset.
#[must_use]
pub const fn resets_of(events: &[Event<'_>]) -> usize {
    let (mut resets, mut index) = (0, 0);
    while index < events.len() {
        resets += events[index].sets.len();
        index += 1;
    }
    resets
}

/// Returns a slice as an array of `N` numbers.
///
/// # Panics
/// If the slice has another length; likewise below.
#[inline]
#[must_use]
pub fn array_of<R, const N: usize>(values: &[R]) -> &[R; N] {
    values.try_into().expect("there are as many numbers as the simulator says")
}

/// Returns a mutable slice as an array of `N` numbers.
///
/// # Panics
/// As [`array_of`].
#[inline]
#[must_use]
pub fn places_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there are as many places as the simulator has numbers")
}

/// Defines `Parameters<R>`, whose default holds the values of the rows, their number
/// `PARAMETERS`, and what `simulator!` needs of them.
///
/// A row is
///
/// ```text
/// field: value, "unit", "spec.name", "meaning";
/// ```
///
/// followed by `as "documentation"` if name, meaning and unit are not valid Markdown. Slots of
/// relations follow, one per row, with the kind of the relation:
///
/// ```text
/// @ held_1: Branch;
/// ```
#[macro_export]
macro_rules! parameters {
    ($($name:ident: $value:expr, $unit:literal, $path:literal, $doc:literal $(as $markdown:literal)?;)*) => {
        $crate::__record! {
            Parameters PARAMETERS
            ["Parameters." "Parameters, in SI units; the default holds the values of the spec."]
            $($name [
                $crate::__meaning!($path, $unit, $doc $(, $markdown)?),
                " In the spec: ", stringify!($value), "."
            ])*
        }
        $crate::__from_slice! { Parameters }
        $crate::__parameter_rows! { $($name: $value, $unit, $path, $doc;)* }
    };
    (
        $($name:ident: $value:expr, $unit:literal, $path:literal, $doc:literal $(as $markdown:literal)?;)*
        $(@ $slot:ident: $kind:ident;)+
    ) => {
        $crate::__record! {
            Parameters PARAMETERS_AND_SLOTS
            ["Parameters and slots."
                "Parameters, in SI units; the default holds the values of the spec, and leaves \
                 relations live."]
            $($name [
                $crate::__meaning!($path, $unit, $doc $(, $markdown)?),
                " In the spec: ", stringify!($value), "."
            ])*
            $($slot ["Slot of a relation: see `Relation` of the contract."])+
        }
        /// Number of parameters, without slots.
        pub const PARAMETERS: usize = PARAMETER_DEFAULTS.len();
        impl<R: $crate::Real> Parameters<R> {
            /// Returns the struct made of a slice of the parameters in their order, with or without
            /// slots after them. Without slots, relations are live.
            ///
            /// # Panics
            /// If it has another length.
            #[must_use]
            #[inline]
            pub fn from_slice(values: &[R]) -> Self {
                if let Ok(all) = <&[R; PARAMETERS_AND_SLOTS]>::try_from(values) {
                    return Self::from_array(*all);
                }
                let mut all = Self::default().to_array();
                *$crate::emitted::places_of(&mut all[..PARAMETERS]) =
                    *$crate::emitted::array_of::<R, PARAMETERS>(values);
                Self::from_array(all)
            }
        }
        $crate::__parameter_rows! {
            $($name: $value, $unit, $path, $doc;)*
            $(@ $slot: $crate::RelationKind::$kind.live();)+
        }
    };
}

/// Defines what `simulator!` needs of parameters.
#[doc(hidden)]
#[macro_export]
macro_rules! __parameter_rows {
    (
        $($name:ident: $value:expr, $unit:literal, $path:literal, $doc:literal;)*
        $(@ $slot:ident: $live:expr;)*
    ) => {
        const PARAMETER_QUANTITIES: &[$crate::Quantity<'static>] =
            &[$($crate::Quantity { name: $path, unit: $unit, doc: $doc }),*];
        const PARAMETER_DEFAULTS: &[f64] = &[$($value),*];
        impl<R: $crate::Real> ::core::default::Default for Parameters<R> {
            fn default() -> Self {
                $crate::__new_record! {
                    $($name: <R as $crate::Real>::literal($value),)*
                    $($slot: <R as $crate::Real>::literal($live),)*
                }
            }
        }
    };
}

/// Defines `RELATION_ROWS`, the relations of a simulator.
///
/// A row is
///
/// ```text
/// Branch [Rate, Event(0)];
/// ```
#[macro_export]
macro_rules! relations {
    ($($kind:ident [$($reader:ident $(($index:literal))?),*];)*) => {
        /// Relations that steps hold.
        pub const RELATION_ROWS: &[$crate::Relation<'static>] = &[$($crate::Relation {
            kind: $crate::RelationKind::$kind,
            readers: &[$($crate::Reader::$reader $(($index))?),*],
        }),*];
    };
}

/// Defines `Outputs<R>`, their number `OUTPUTS`, and what `simulator!` needs of them.
///
/// A row is
///
/// ```text
/// field: "unit", "spec.name", "meaning";
/// ```
///
/// with `at_once` before the unit if the output has feedthrough by accelerations or constraint
/// forces.
#[macro_export]
macro_rules! outputs {
    ($(
        $name:ident: $($at_once:ident)? $unit:literal, $path:literal, $doc:literal
        $(as $markdown:literal)?;
    )*) => {
        $crate::__record! {
            Outputs OUTPUTS ["Wanted outputs." "Wanted outputs, in SI units."]
            $($name [$crate::__meaning!($path, $unit, $doc $(, $markdown)?)])*
        }
        $crate::__from_slice! { Outputs }
        const OUTPUT_QUANTITIES: &[$crate::Quantity<'static>] =
            &[$($crate::Quantity { name: $path, unit: $unit, doc: $doc }),*];
        const OUTPUTS_AT_ONCE: &[bool] = &[$(!stringify!($($at_once)?).is_empty()),*];
    };
}

/// Defines `Constants<R>`, which depend on parameters only, and their number `CONSTANTS`, from
/// names.
#[macro_export]
macro_rules! constants {
    ($($name:ident),+ $(,)?) => {
        $crate::__record! {
            Constants CONSTANTS
            ["Constants that `prepare` computes."
                "Constants computed from the parameters alone; see `prepare`."]
            $($name ["See `prepare`."])*
        }
        $crate::__from_slice! { Constants }
    };
}

/// Defines the length `STATES` of the state, the index of each of its entries in the module
/// `state`, and what `simulator!` needs of them.
///
/// A row is
///
/// ```text
/// INDEX: position, scale, "unit", "spec.name", "meaning";
/// ```
///
/// where `position` may be `velocity`, `first_order` or `mode`, followed by `guess` if the
/// initial value is not given.
#[macro_export]
macro_rules! states {
    ($(
        $name:ident: $kind:ident $($guess:ident)?, $scale:expr, $unit:literal, $path:literal,
        $doc:literal $(as $markdown:literal)?;
    )*) => {
        /// Length of the state y.
        pub const STATES: usize = STATE_ROWS.len();
        /// Number of generalized coordinates, n.
        pub const COORDINATES: usize = $crate::emitted::shape_of(STATE_ROWS).coordinates;
        /// Indices of the entries of the state.
        pub mod state {
            #[allow(clippy::upper_case_acronyms, non_camel_case_types, dead_code)]
            enum Place { $($name),* }
            $(
                #[doc = $crate::__meaning!($path, $unit, $doc $(, $markdown)?)]
                pub const $name: usize = Place::$name as usize;
            )*
        }
        const STATE_ROWS: &[$crate::emitted::StateRow<'static>] = &[$(
            $crate::emitted::StateRow::$kind(
                $scale,
                $crate::Quantity { name: $path, unit: $unit, doc: $doc },
            )$(.$guess())?
        ),*];
    };
}

/// Defines the generalized coordinates of a simulator whose state does not begin with them. A row
/// is
///
/// ```text
/// "spec.name", "unit", "meaning";
/// ```
#[macro_export]
macro_rules! coordinates {
    ($($path:literal, $unit:literal, $doc:literal;)*) => {
        const COORDINATE_QUANTITIES: [$crate::Quantity<'static>; COORDINATES] =
            [$($crate::Quantity { name: $path, unit: $unit, doc: $doc }),*];
    };
}

/// Defines the events `EVENT_SHAPES`, their number `EVENTS`, and the number of values they reset,
/// `RESETS`.
///
/// A row is
///
/// ```text
/// "spec.name": Rising, when [(mode, value), ..], sets [entry, ..], "meaning";
/// ```
///
/// with `Rising counts` for an event that only counts, and `Rising moves_guard` for one whose guard reads
/// a state that it sets.
#[macro_export]
macro_rules! events {
    (@flag counts counts) => { true };
    (@flag moves_guard moves_guard) => { true };
    (@flag $($other:ident)*) => { false };
    ($($path:literal: $direction:ident $($flag:ident)?, when [$($when:tt)*], sets [$($set:tt)*], $doc:literal;)*) => {
        /// Number of events.
        pub const EVENTS: usize = EVENT_SHAPES.len();
        /// Number of values that all events reset.
        pub const RESETS: usize = $crate::emitted::resets_of(EVENT_SHAPES);
        /// Description of the events.
        pub const EVENT_SHAPES: &[$crate::Event<'static>] = &[$($crate::Event {
            name: $path,
            doc: $doc,
            direction: $crate::Direction::$direction,
            when: &[$($when)*],
            sets: &[$($set)*],
            counts: $crate::events!(@flag counts $($flag)?),
            moves_guard: $crate::events!(@flag moves_guard $($flag)?),
        }),*];
    };
}

/// Defines the constraints `CONSTRAINT_SHAPES` and their number `CONSTRAINTS`.
///
/// A row is
///
/// ```text
/// "spec.name": of_positions, "unit", "meaning";
/// ```
///
/// where `of_positions` may be `of_velocities`, both with `_in_modes`, `of_friction(mode)`,
/// `of_friction_in_time(mode)` or `of_friction_at_places(mode)`.
#[macro_export]
macro_rules! constraints {
    ($($path:literal: $kind:ident $(($mode:literal))?, $unit:literal, $doc:literal;)*) => {
        /// Number of constraints.
        pub const CONSTRAINTS: usize = CONSTRAINT_SHAPES.len();
        /// Description of the constraints.
        pub const CONSTRAINT_SHAPES: &[$crate::Constraint<'static>] =
            &[$($crate::Constraint::$kind($($mode,)? $path, $unit, $doc)),*];
    };
}

/// Defines structural nonzeros, row by row.
///
/// ```text
/// /// Nonzeros of M.
/// MASS_MATRIX_PATTERN: rows by columns { row [column ..] row [column ..] }
/// ```
#[macro_export]
macro_rules! patterns {
    ($(
        $(#[$attribute:meta])*
        $name:ident: $rows:literal by $columns:literal { $($row:literal [$($column:literal)*])* }
    )*) => {$(
        $(#[$attribute])*
        pub const $name: $crate::SparsityPattern<'static> = $crate::SparsityPattern {
            rows: $rows,
            columns: $columns,
            entries: &[$($(($row, $column)),*),*],
        };
    )*};
}

/// Documents a quantity in Markdown.
#[doc(hidden)]
#[macro_export]
macro_rules! __meaning {
    ($path:literal, $unit:literal, "") => {
        concat!($path, " \\[", $unit, "\\].")
    };
    ($path:literal, $unit:literal, $doc:literal) => {
        concat!($path, ": ", $doc, " \\[", $unit, "\\].")
    };
    ($path:literal, $unit:literal, $doc:literal, $markdown:literal) => {
        $markdown
    };
}

/// Defines a struct of numbers that converts from and to an array.
#[doc(hidden)]
#[macro_export]
macro_rules! __record {
    ($record:ident $length:ident [$count:literal $meaning:literal] $($name:ident [$($doc:tt)*])+) => {
        #[doc = $meaning]
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $record<R> {
            $(#[doc = concat!($($doc)*)] pub $name: R,)*
        }
        $crate::__conversions! { $record $length $count $($name)* }
    };
    ($record:ident $length:ident [$count:literal $meaning:literal]) => {
        #[doc = $meaning]
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $record<R> {
            /// Marker of the number type; there are no numbers here.
            pub real: ::core::marker::PhantomData<R>,
        }
        $crate::__conversions! { $record $length $count }
    };
}

/// Returns a value of such a struct.
#[doc(hidden)]
#[macro_export]
macro_rules! __new_record {
    () => {
        Self { real: ::core::marker::PhantomData }
    };
    ($($field:ident: $value:expr),+ $(,)?) => {
        Self { $($field: $value),* }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __conversions {
    ($record:ident $length:ident $count:literal $($name:ident)*) => {
        #[doc = $count]
        pub const $length: usize = {
            const NAMES: &[&str] = &[$(stringify!($name)),*];
            NAMES.len()
        };
        impl<R: $crate::Real> $record<R> {
            /// Returns the struct made of the numbers in their order.
            #[must_use]
            #[inline]
            pub fn from_array(values: [R; $length]) -> Self {
                #[allow(non_camel_case_types, clippy::upper_case_acronyms)]
                enum Place { $($name),* }
                let _ = &values;
                $crate::__new_record! { $($name: values[Place::$name as usize]),* }
            }
            /// Returns the numbers in their order.
            #[must_use]
            #[inline]
            pub fn to_array(self) -> [R; $length] {
                [$(self.$name),*]
            }
        }
    };
}

/// Converts a slice of numbers to a struct of them.
#[doc(hidden)]
#[macro_export]
macro_rules! __from_slice {
    ($record:ident) => {
        impl<R: $crate::Real> $record<R> {
            /// Returns the struct made of a slice of the numbers in their order.
            ///
            /// # Panics
            /// If it has another length.
            #[must_use]
            #[inline]
            pub fn from_slice(values: &[R]) -> Self {
                Self::from_array(*$crate::emitted::array_of(values))
            }
        }
    };
}

//! Codes of errors in specs.

use strum::{IntoStaticStr, VariantNames};

/// Kind of an error in a spec. Its code is the variant's name after `spec::`, such as
/// `spec::unknown-name`, and never changes. The chapter "Error codes" of the book explains each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, IntoStaticStr, VariantNames)]
#[strum(prefix = "spec::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum Code {
    /// A file cannot be read, or is not text.
    UnreadableFile,
    /// A file is not TOML.
    InvalidToml,
    /// A table has a key that the language does not have there.
    UnknownKey,
    /// A required key is missing.
    MissingKey,
    /// Keys exclude each other, or one of several is required.
    ConflictingKeys,
    /// A value is not of the type that its key takes.
    WrongType,
    /// A number is outside the range of its key.
    OutOfRange,
    /// A text is not one of the values that its key takes.
    UnknownChoice,
    /// A name is not allowed.
    InvalidName,
    /// A name is given twice.
    DuplicateName,
    /// Nothing has this name.
    UnknownName,
    /// No instance has this name.
    UnknownInstance,
    /// No unit has this name.
    UnknownUnit,
    /// The unit has no such port.
    UnknownPort,
    /// The unit or scene has no such parameter.
    UnknownParameter,
    /// The unit has no such input.
    UnknownInput,
    /// No function has this name.
    UnknownFunction,
    /// A name is of another kind than needed.
    WrongKindOfName,
    /// A name with a dot stands where only own names are known.
    OutOfScope,
    /// An input of a unit has no expression.
    UnboundInput,
    /// A definition refers to itself.
    CyclicDefinition,
    /// An expression does not parse.
    Syntax,
    /// A function has the wrong arguments.
    WrongArguments,
    /// A unit of measure is unknown or not allowed.
    InvalidMeasure,
    /// A term has the wrong dimension.
    DimensionMismatch,
    /// A power or root has no dimension in SI units.
    NoDimension,
    /// A term of an energy is a torque.
    NotAnEnergy,
    /// An expression depends on something that is not allowed there.
    ForbiddenDependence,
    /// A value is not constant.
    NotConstant,
    /// A value is undefined or infinite.
    UndefinedValue,
    /// A derivative is unknown or too long.
    NoDerivative,
    /// A limit of size is exceeded.
    TooLarge,
    /// A vector is used as a number, or the reverse.
    InvalidVector,
    /// The data of a table cannot be used.
    InvalidTable,
    /// Ports cannot be joined like this.
    InvalidJoint,
    /// Joints close a loop.
    JointLoop,
    /// A frame is not connected with the world.
    UnconnectedFrame,
    /// All coordinates are fixed.
    NothingMoves,
    /// A part of the spec has no effect.
    NoEffect,
    /// A motion has no inertia.
    NoInertia,
    /// No body has this mass and inertia.
    InvalidInertia,
    /// An expression cannot be a constraint.
    InvalidConstraint,
    /// A force cannot act like this.
    InvalidForce,
    /// A guard never changes.
    InvalidGuard,
    /// A field cannot be used like this.
    InvalidField,
    /// An initial value cannot be given.
    InvalidStart,
    /// The settings of the run are invalid.
    InvalidRun,
    /// A distribution or correlation is invalid.
    InvalidDistribution,
}

impl Code {
    /// Returns the code as it is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.into()
    }
}

//! Errors as exceptions of the package `machinist`.

use machinist::SimulateError;
use machinist::field::FieldError;
use machinist::linear_analysis::LinearError;
use machinist::periodic::CycleError;
use machinist_model::file::FileError;
use pyo3::prelude::*;

/// Reason for the failure of a call.
#[derive(Debug)]
pub enum Failure {
    /// A run was rejected or stopped.
    Simulate(SimulateError),
    /// The linear analysis failed.
    Linear(LinearError),
    /// Fields cannot be discretized as requested.
    Field(FieldError),
    /// The bytes are not a model.
    File(FileError),
    /// An argument is invalid; class and message of the exception.
    Refused(&'static str, String),
    /// An exception raised by Python.
    Python(PyErr),
}

impl Failure {
    /// Invalid argument.
    pub fn input(message: impl Into<String>) -> Self {
        Self::Refused("InputError", message.into())
    }
}

impl From<SimulateError> for Failure {
    fn from(error: SimulateError) -> Self {
        Self::Simulate(error)
    }
}

impl From<LinearError> for Failure {
    fn from(error: LinearError) -> Self {
        match error {
            LinearError::Simulate(error) => Self::Simulate(error),
            error => Self::Linear(error),
        }
    }
}

impl From<CycleError> for Failure {
    fn from(error: CycleError) -> Self {
        let class = match error {
            CycleError::Simulate(error) => return Self::Simulate(error),
            CycleError::UnknownState { .. } => "UnknownNameError",
            CycleError::BadSetting(_)
            | CycleError::TooLarge { .. }
            | CycleError::NeedsPeriod { .. } => "InputError",
            _ => "AnalysisError",
        };
        Self::Refused(class, error.to_string())
    }
}

impl From<FieldError> for Failure {
    fn from(error: FieldError) -> Self {
        Self::Field(error)
    }
}

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        Self::File(error)
    }
}

impl From<PyErr> for Failure {
    fn from(error: PyErr) -> Self {
        Self::Python(error)
    }
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        let undifferentiable = match &failure {
            Failure::Simulate(SimulateError::NotDifferentiable { name, why }) => {
                Some((name.clone(), why.clone()))
            }
            _ => None,
        };
        let (class, message) = match failure {
            Failure::Python(error) => return error,
            Failure::Simulate(error) => (class_of(&error), error.to_string()),
            Failure::Linear(error) => (
                match error {
                    LinearError::Unknown { .. } => "UnknownNameError",
                    LinearError::Eigenvalues
                    | LinearError::NoEquilibrium { .. }
                    | LinearError::NoModes { .. }
                    | LinearError::LosesEquilibrium { .. }
                    | LinearError::Unsettled { .. }
                    | LinearError::Lost { .. }
                    | LinearError::Singular { .. } => "AnalysisError",
                    _ => "InputError",
                },
                error.to_string(),
            ),
            Failure::Field(error) => ("InputError", error.to_string()),
            Failure::File(error) => ("ModelFileError", error.to_string()),
            Failure::Refused(class, message) => (class, message),
        };
        Python::attach(|py| {
            let told = exception(py, class, &message).and_then(|error| {
                if let Some(pair) = undifferentiable {
                    error.value(py).setattr("undifferentiable", pair)?;
                }
                Ok(error)
            });
            told.unwrap_or_else(|error| error)
        })
    }
}

/// Exception class of an error.
fn class_of(error: &SimulateError) -> &'static str {
    match error {
        SimulateError::UnknownParameter { .. }
        | SimulateError::UnusedParameter { .. }
        | SimulateError::UnknownDirection { .. }
        | SimulateError::UnknownMethod(_) => "UnknownNameError",
        SimulateError::WrongLength { .. } => "ShapeError",
        SimulateError::Stopped { .. } => "StoppedError",
        _ => "InputError",
    }
}

/// Creates an exception of the package.
pub fn exception(py: Python<'_>, class: &str, message: &str) -> PyResult<PyErr> {
    let class = py.import("machinist.errors")?.getattr(class)?;
    Ok(PyErr::from_value(class.call1((message,))?))
}

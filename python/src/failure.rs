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
    /// Error of an analysis; class, code and message of the exception.
    Coded(&'static str, &'static str, String),
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
        Self::Coded(class, error.code(), error.to_string())
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
        let stopped = match &failure {
            Failure::Simulate(SimulateError::Stopped { time, .. }) => Some(*time),
            _ => None,
        };
        let (class, code, message) = match failure {
            Failure::Python(error) => return error,
            Failure::Simulate(error) => (class_of(&error), Some(error.code()), error.to_string()),
            Failure::Linear(error) => {
                (class_of_linear(&error), Some(error.code()), error.to_string())
            }
            Failure::Field(error) => ("InputError", Some(error.code()), error.to_string()),
            Failure::File(error) => ("ModelFileError", Some(error.code()), error.to_string()),
            Failure::Coded(class, code, message) => (class, Some(code), message),
            Failure::Refused(class, message) => (class, None, message),
        };
        Python::attach(|py| {
            let told = exception(py, class, code, &message).and_then(|error| {
                if let Some(pair) = undifferentiable {
                    error.value(py).setattr("undifferentiable", pair)?;
                }
                if let Some(time) = stopped {
                    error.value(py).setattr("time", time)?;
                }
                Ok(error)
            });
            told.unwrap_or_else(|error| error)
        })
    }
}

/// Exception class of an error of a linear analysis.
fn class_of_linear(error: &LinearError) -> &'static str {
    match error {
        LinearError::UnknownName { .. } => "UnknownNameError",
        LinearError::Eigenvalues
        | LinearError::NoEquilibrium { .. }
        | LinearError::NoModes { .. }
        | LinearError::LosesEquilibrium { .. }
        | LinearError::NotSmooth { .. }
        | LinearError::OffConstraint { .. }
        | LinearError::Singular { .. } => "AnalysisError",
        _ => "InputError",
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

/// Creates an exception of the package, with the code of its kind if it has one.
pub fn exception(
    py: Python<'_>,
    class: &str,
    code: Option<&str>,
    message: &str,
) -> PyResult<PyErr> {
    let class = py.import("machinist.errors")?.getattr(class)?;
    let error = PyErr::from_value(class.call1((message,))?);
    error.value(py).setattr("code", code)?;
    Ok(error)
}

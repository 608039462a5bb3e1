//! Failures of commands: the message and the exit code.

use std::fmt::Display;
use std::io;
use std::path::Path;

use crate::plot::PlotError;
use machinist::SimulateError;
use machinist::error::{UnknownMethod, nearest};
use machinist::estimator::EstimatorError;
use machinist::field::{FieldError, ModalError};
use machinist::fit::Unsolved;
use machinist::linear_analysis::{LinearError, RegulatorError};
use machinist::periodic::CycleError;
use machinist::scatter::ScatterError;
#[cfg(feature = "derive")]
use machinist_codegen::spec::diagnostic::{Diagnostic, Diagnostics, render};
#[cfg(feature = "derive")]
use machinist_codegen::write::WriteError;
#[cfg(feature = "derive")]
use machinist_fmu::variables::Unfit;
use machinist_model::file::FileError;
use machinist_studies::verify::{CheckFailure, VerifyError};
use miette::{MietteDiagnostic, Report};
#[cfg(feature = "derive")]
use serde::{Deserialize, Serialize};

/// Kind of a failure of the command line itself. Its code is the variant's name after `cli::`, and
/// never changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "cli::", serialize_all = "kebab-case")]
pub enum ErrorCode {
    /// An option or argument is invalid, missing, repeated, or does not go with another.
    InvalidArgument,
    /// Nothing has this name.
    UnknownName,
    /// A file cannot be read or written.
    File,
    /// The content of a file is not what the command reads.
    InvalidData,
    /// This build of the program lacks a feature.
    NotBuiltIn,
    /// The user interrupted the command.
    Interrupted,
    /// A check failed.
    CheckFailed,
    /// The command ended without the result asked for.
    Unsuccessful,
}

/// Message of a failure, with the code of its kind if it has one of its own.
pub trait Coded: Display {
    /// Returns the code.
    fn code(&self) -> Option<&'static str> {
        None
    }
}

impl Coded for String {}
impl Coded for str {}
impl Coded for std::str::EscapeDebug<'_> {}

impl<T: Coded + ?Sized> Coded for &T {
    fn code(&self) -> Option<&'static str> {
        (**self).code()
    }
}

impl Coded for io::Error {}
impl Coded for serde_json::Error {}

macro_rules! coded {
    ($($(#[$condition:meta])? $error:ty),* $(,)?) => {
        $($(#[$condition])? impl Coded for $error {
            fn code(&self) -> Option<&'static str> {
                Some(self.code())
            }
        })*
    };
}

coded!(
    CheckFailure,
    CycleError,
    EstimatorError,
    FieldError,
    FileError,
    LinearError,
    ModalError,
    PlotError,
    RegulatorError,
    ScatterError,
    SimulateError,
    UnknownMethod,
    Unsolved,
    VerifyError,
    #[cfg(feature = "derive")]
    crate::fields::DivideError,
    #[cfg(feature = "derive")]
    Unfit,
    #[cfg(feature = "derive")]
    WriteError,
);

/// Failure of a command.
#[derive(Debug)]
pub enum Failure {
    /// The input is invalid; exit code 2.
    Input(Vec<Report>),
    /// A check failed, a run stopped, or a file could not be written; exit code 1.
    Unsuccessful(Report),
}

impl Failure {
    /// Creates a failure of the input with a hint, which may be empty.
    pub fn input(message: impl Coded, help: impl Display) -> Self {
        let code = message.code().unwrap_or(ErrorCode::InvalidArgument.into());
        Self::Input(vec![report(code, &message, &help)])
    }

    /// Creates the failure of a name that is not among those known, with the nearest as a hint.
    pub fn unknown<'a>(
        message: impl Display,
        name: &str,
        known: impl Iterator<Item = &'a str> + Clone,
    ) -> Self {
        Self::coded(ErrorCode::UnknownName, message, did_you_mean(name, known))
    }

    /// Creates a failure of the input of another kind than [`ErrorCode::InvalidArgument`].
    pub fn coded(code: ErrorCode, message: impl Display, help: impl Display) -> Self {
        Self::Input(vec![report(code.into(), &message, &help)])
    }

    /// Creates a failure of the input at a place, such as a file, with a hint, which may be empty.
    pub fn at(place: impl Display, error: impl Coded, help: impl Display) -> Self {
        let code = error.code().unwrap_or(ErrorCode::InvalidArgument.into());
        Self::Input(vec![report(code, &format!("{place}: {error}"), &help)])
    }

    /// Creates an unsuccessful end with a hint, which may be empty.
    pub fn unsuccessful(message: impl Coded, help: impl Display) -> Self {
        let code = message.code().unwrap_or(ErrorCode::Unsuccessful.into());
        Self::Unsuccessful(report(code, &message, &help))
    }

    /// Creates an unsuccessful end of another kind than [`ErrorCode::Unsuccessful`].
    pub fn ended(code: ErrorCode, message: impl Display, help: impl Display) -> Self {
        Self::Unsuccessful(report(code.into(), &message, &help))
    }

    /// Creates the failure of a file that cannot be read or written.
    pub fn file(path: &Path, error: &io::Error) -> Self {
        let message = format!("{}: {error}", path.display());
        Self::ended(ErrorCode::File, message, "")
    }

    /// Prints the messages on standard error and returns the exit code.
    pub fn tell(&self) -> u8 {
        let (reports, code) = match self {
            Self::Input(reports) => (reports.as_slice(), 2),
            Self::Unsuccessful(report) => (std::slice::from_ref(report), 1),
        };
        for report in reports {
            eprintln!("{report:?}");
        }
        code
    }
}

/// Error or warning with its location, to be shown outside a terminal.
#[cfg(feature = "derive")]
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Trouble {
    /// Code of the kind of error, such as `spec::unknown-name`; empty for notes.
    pub code: String,
    /// Label of the file; empty if there is none.
    pub file: String,
    /// Line, from 1; 0 if there is none.
    pub line: usize,
    /// Column in characters, from 1; 0 if there is none.
    pub column: usize,
    /// Number of characters at fault; 0 if there is no location.
    pub length: usize,
    /// Message in one sentence.
    pub message: String,
    /// Hint for mending it; may be empty.
    pub help: String,
    /// Full text as commands print it, without colours.
    pub text: String,
    /// True if the machine runs all the same.
    pub is_warning: bool,
}

#[cfg(feature = "derive")]
impl Trouble {
    /// Returns a note on a machine that runs all the same.
    #[must_use]
    pub fn note(message: String) -> Self {
        let text = format!("  machinist: {message}");
        Self {
            code: String::new(),
            file: String::new(),
            line: 0,
            column: 0,
            length: 0,
            message,
            help: String::new(),
            text,
            is_warning: true,
        }
    }

    /// Returns the same as a warning.
    #[must_use]
    pub fn into_warning(self) -> Self {
        Self { is_warning: true, ..self }
    }
}

#[cfg(feature = "derive")]
impl From<&Diagnostic> for Trouble {
    fn from(of: &Diagnostic) -> Self {
        Self {
            code: of.code.to_owned(),
            file: of.file.to_string(),
            line: of.line,
            column: of.column,
            length: of.length(),
            message: of.message.clone(),
            help: of.help.clone().unwrap_or_default().into_string(),
            text: Diagnostics::from(of.clone()).render(),
            is_warning: of.is_warning,
        }
    }
}

#[cfg(feature = "derive")]
impl Failure {
    /// Returns the errors one by one.
    pub fn troubles(&self) -> Vec<Trouble> {
        let reports = match self {
            Self::Input(reports) => reports.as_slice(),
            Self::Unsuccessful(report) => std::slice::from_ref(report),
        };
        let of_report = |report: &Report| -> Vec<Trouble> {
            if let Some(diagnostics) = report.downcast_ref::<Diagnostics>() {
                return diagnostics.errors().iter().map(Trouble::from).collect();
            }
            let text = |part: Option<Box<dyn Display + '_>>| {
                part.map(|part| part.to_string()).unwrap_or_default()
            };
            vec![Trouble {
                code: text(report.code()),
                help: text(report.help()),
                text: render(report.as_ref()),
                is_warning: false,
                ..Trouble::note(report.to_string())
            }]
        };
        reports.iter().flat_map(of_report).collect()
    }
}

/// Applies a stage to every item. If any fail, returns all their errors together.
#[cfg(feature = "derive")]
pub fn all<I, T>(
    items: impl IntoIterator<Item = I>,
    stage: impl Fn(I) -> Result<T, Diagnostics>,
) -> Result<Vec<T>, Failure> {
    let (mut done, mut wrong) = (Vec::new(), Vec::new());
    for item in items {
        match stage(item) {
            Ok(result) => done.push(result),
            Err(diagnostics) => wrong.push(diagnostics.into()),
        }
    }
    if wrong.is_empty() { Ok(done) } else { Err(Failure::Input(wrong)) }
}

/// Returns a hint for an unknown name: the nearest known name, or all of them.
pub fn did_you_mean<'a>(name: &str, known: impl Iterator<Item = &'a str> + Clone) -> String {
    match nearest(name, known.clone()) {
        Some(nearest) => format!("did you mean `{nearest}`?"),
        None => match known.collect::<Vec<_>>().join(", ") {
            all if all.is_empty() => all,
            all => format!("known are {all}"),
        },
    }
}

fn report(code: &str, message: &dyn Display, help: &dyn Display) -> Report {
    let (problem, help) = (MietteDiagnostic::new(message.to_string()), help.to_string());
    let problem = problem.with_code(code);
    Report::new(if help.is_empty() { problem } else { problem.with_help(help) })
}

#[cfg(feature = "derive")]
impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Input(vec![diagnostics.into()])
    }
}

impl From<SimulateError> for Failure {
    fn from(error: SimulateError) -> Self {
        match error {
            SimulateError::Stopped { .. } => Self::unsuccessful(error, ""),
            _ => Self::input(error, ""),
        }
    }
}

impl From<LinearError> for Failure {
    fn from(error: LinearError) -> Self {
        let at = "`--at initial` and `--at t=SECONDS` linearize about states that are not steady";
        match error {
            LinearError::Simulate(error) => error.into(),
            LinearError::Eigenvalues => Self::unsuccessful(error, ""),
            LinearError::NoEquilibrium { .. } => Self::input(error, at),
            _ => Self::input(error, ""),
        }
    }
}

impl From<RegulatorError> for Failure {
    fn from(error: RegulatorError) -> Self {
        match error {
            RegulatorError::Linear(error) => error.into(),
            RegulatorError::Unsolved => Self::unsuccessful(error, ""),
            _ => Self::input(error, ""),
        }
    }
}

#[cfg(feature = "derive")]
impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        match error {
            WriteError::Emit { .. } => Self::input(error, ""),
            _ => Self::unsuccessful(error, ""),
        }
    }
}

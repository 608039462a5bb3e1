//! Codes of errors, and the sections of the book on them.

use machinist::error::{SimulateError, StopCause};
use machinist::estimator::EstimatorError;
use machinist::field::{FieldError, ModalError};
use machinist::fit::{FitError, Unsolved};
use machinist::improve::ExpressionError;
use machinist::linear_analysis::{LinearError, RegulatorError};
use machinist::method::BadChoice;
use machinist::periodic::CycleError;
use machinist::scatter::ScatterError;
use machinist_model::file::FileError;
use machinist_studies::verify::{CheckFailure, VerifyError};
use strum::VariantNames as _;

use crate::failure::ErrorCode;
use crate::plot::PlotError;

/// Chapter of the book with a section for each code.
const CHAPTER: &str = include_str!("../../docs/book/src/errors.md");
/// Start of the heading of a section.
const HEADING: &str = "\n### `";

/// Returns the codes of all errors that the program and its libraries report, sorted.
#[must_use]
pub fn codes() -> Vec<&'static str> {
    let enums = vec![
        ErrorCode::VARIANTS,
        BadChoice::VARIANTS,
        CheckFailure::VARIANTS,
        CycleError::VARIANTS,
        EstimatorError::VARIANTS,
        FieldError::VARIANTS,
        FileError::VARIANTS,
        FitError::VARIANTS,
        LinearError::VARIANTS,
        ModalError::VARIANTS,
        PlotError::VARIANTS,
        RegulatorError::VARIANTS,
        ScatterError::VARIANTS,
        SimulateError::VARIANTS,
        StopCause::VARIANTS,
        Unsolved::VARIANTS,
        VerifyError::VARIANTS,
        &[ExpressionError::CODE],
    ];
    #[cfg(feature = "derive")]
    let enums = [
        enums,
        vec![
            machinist_algebra::cas::CasError::VARIANTS,
            machinist_codegen::BuildError::VARIANTS,
            machinist_codegen::emit::EmitError::VARIANTS,
            machinist_codegen::mechanics::reduce::FreezeError::VARIANTS,
            machinist_codegen::spec::code::Code::VARIANTS,
            machinist_codegen::write::WriteError::VARIANTS,
            machinist_fmu::instance::Refusal::VARIANTS,
            machinist_fmu::resource::LoadError::VARIANTS,
            machinist_fmu::variables::Unfit::VARIANTS,
            crate::fields::DivideError::VARIANTS,
            crate::object::ObjectError::VARIANTS,
        ],
    ]
    .concat();
    let mut codes = enums.concat();
    // A variant that holds an error of another type has the code of that error.
    codes.retain(|code| !code.ends_with("::"));
    codes.sort_unstable();
    codes.dedup();
    codes
}

/// Returns the section of the book on a code, without its heading.
pub fn section(code: &str) -> Option<&'static str> {
    let mut sections = CHAPTER.split(HEADING).skip(1).filter_map(|text| text.split_once("`\n"));
    let (_, text) = sections.find(|(of, _)| *of == code)?;
    Some(text.split("\n## ").next().unwrap_or_default().trim())
}

//! Models whose fields are divided into elements.

use machinist::FieldSimulator;
use machinist::field::{Discretisation, FieldError};
use machinist::simulate::parameter_defaults;
use machinist_model::{Division, Model, ModelSimulator};

use crate::cli::scene::{refused, require_no_cut};
use crate::failure::Failure;

/// Reason why the fields of a model cannot be divided.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "field::", serialize_all = "kebab-case")]
pub enum DivideError {
    /// The division is out of range.
    #[strum(serialize = "")]
    #[error(transparent)]
    Range(#[from] FieldError),
    /// The reduction has left out coordinates.
    #[error("its fields are beside coordinates that are left out")]
    Reduced,
}

impl DivideError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Range(error) => error.code(),
            error @ Self::Reduced => error.into(),
        }
    }
}

/// Returns a model without fields: with every function, and its fields divided as asked for.
pub fn whole(model: Model, wanted: Discretisation) -> Result<Model, Failure> {
    if model.fields.is_empty() {
        require_no_cut(wanted, &model.name)?;
        return Ok(model);
    }
    divided(&model, wanted, Model::divided_completely).map_err(|error| match error {
        DivideError::Range(error) => refused(&error),
        DivideError::Reduced => Failure::at(format!("scene `{}`", model.name), error, ""),
    })
}

/// Divides the fields of a model, by [`Model::divided`] or [`Model::divided_completely`].
pub fn divided(
    model: &Model,
    wanted: Discretisation,
    by: impl FnOnce(&Model, &[Division<'_>]) -> Option<Model>,
) -> Result<Model, DivideError> {
    let simulator = ModelSimulator::interpreted(model.clone());
    let cut = FieldSimulator::new(simulator.with_fields(), wanted)?;
    by(model, &cut.divisions(&parameter_defaults(&cut))).ok_or(DivideError::Reduced)
}

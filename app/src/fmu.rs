//! Scenes as functional mock-up units: an archive of a description with the shared library of
//! `machinist-fmu` and the model that it runs, or with C99 sources.

mod archive;
mod description;
mod description2;
mod fixed_step;
mod library;
mod quantity;
mod source;
mod structure;
mod terminals;
mod xml;
mod zip;

pub use archive::{Archive, Content};
pub use library::Library;
pub use source::SourceSettings;
pub use zip::archive as zip_archive;

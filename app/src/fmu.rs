//! Scenes as functional mock-up units: an archive of a description, the shared library of
//! `machinist-fmu`, and the model that it runs.

mod archive;
mod description;
mod library;
mod quantity;
mod structure;
mod terminals;
mod xml;
mod zip;

pub use archive::Archive;
pub use library::Library;
pub use zip::archive as zip_archive;

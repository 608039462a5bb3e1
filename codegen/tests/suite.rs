//! Tests of the generator, one module per subject; `cargo test -p machinist-codegen --test suite
//! specs::` runs one.

mod common;
#[path = "../../tests/common/damaged_model.rs"]
mod damaged_model;
#[path = "../../tests/common/mutation.rs"]
mod mutation;
mod support;

#[cfg(feature = "symbolica")]
mod algebras;
mod build_script;
mod derivation;
mod derivation_limits;
mod emitted_files;
mod emitted_numbers;
mod emitted_text;
mod fuzz;
mod library;
mod limits;
mod pendulum;
mod readable_equations;
mod series;
mod specs;

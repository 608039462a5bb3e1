//! Native part of the Python package: machines with their functions, runs, linear analysis, fits
//! and chunks of sweeps. Names, documentation and everything non-numeric is in the Python package
//! `machinist`.
//!
//! Layers, from below:
//!
//! - [`failure`]: errors as exceptions of the package;
//! - [`arrays`]: numbers passed from Python;
//! - [`source`]: sources of simulators;
//! - [`derive`]: models of specs, and the commands of the program;
//! - [`settings`]: settings of a run, from keywords;
//! - [`patience`]: interruption of runs by Ctrl-C;
//! - [`machine`], [`run`], [`stepper`], [`linear`], [`cycle`], [`fit`], [`sweep`], [`scatter`]: the
//!   interface for Python.

#![allow(clippy::needless_pass_by_value, reason = "what Python hands over comes by value")]

mod arrays;
mod cycle;
mod derive;
mod describe;
mod failure;
mod fit;
mod linear;
mod machine;
mod patience;
mod run;
mod scatter;
mod settings;
mod source;
mod stepper;
mod sweep;
mod tunable;

use pyo3::prelude::*;

/// The native part of the package `machinist`.
#[pymodule]
mod _machinist {
    #[pymodule_export]
    use crate::cycle::branches;
    #[pymodule_export]
    use crate::cycle::cycle;
    #[pymodule_export]
    use crate::cycle::sections;
    #[pymodule_export]
    use crate::derive::derive;
    #[pymodule_export]
    use crate::derive::machine_names;
    #[pymodule_export]
    use crate::derive::program;
    #[pymodule_export]
    use crate::fit::fit;
    #[pymodule_export]
    use crate::linear::design;
    #[pymodule_export]
    use crate::linear::modes;
    #[pymodule_export]
    use crate::linear::pieces_along;
    #[pymodule_export]
    use crate::linear::response;
    #[pymodule_export]
    use crate::linear::state_space;
    #[pymodule_export]
    use crate::machine::Machine;
    #[pymodule_export]
    use crate::run::Run;
    #[pymodule_export]
    use crate::scatter::scatter_design;
    #[pymodule_export]
    use crate::scatter::scatter_effects;
    #[pymodule_export]
    use crate::scatter::scatter_linear;
    #[pymodule_export]
    use crate::scatter::scatter_paths;
    #[pymodule_export]
    use crate::scatter::scatter_piece;
    #[pymodule_export]
    use crate::scatter::scatter_results;
    #[pymodule_export]
    use crate::scatter::scatter_statistics;
    #[pymodule_export]
    use crate::stepper::Stepper;
    #[pymodule_export]
    use crate::sweep::negative_inertias;
    #[pymodule_export]
    use crate::sweep::sweep_piece;

    use machinist::Method;
    use machinist_model::file::{MARK, VERSION};
    use machinist_scenes::scenes::{FIELD_NAMES, NAMES};
    use pyo3::prelude::*;
    use pyo3::types::PyBytes;

    /// Names of the built-in scenes, sorted.
    #[pyfunction]
    fn built_in_names() -> Vec<&'static str> {
        let mut names: Vec<_> = NAMES.iter().chain(FIELD_NAMES).copied().collect();
        names.sort_unstable();
        names
    }

    /// Name, order, implicitness and description of every method.
    #[pyfunction]
    fn methods() -> Vec<(&'static str, u32, bool, &'static str)> {
        let row = |m: Method| (m.name(), m.order(), m.is_implicit(), m.doc());
        Method::compiled_in().map(row).collect()
    }

    /// Nearest known name as a question in parentheses, or an empty string.
    #[pyfunction]
    fn did_you_mean(name: &str, known: Vec<String>) -> String {
        machinist::error::did_you_mean(name, known.iter().map(String::as_str))
    }

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("MODEL_MARK", PyBytes::new(module.py(), MARK))?;
        module.add("MODEL_VERSION", VERSION)
    }
}

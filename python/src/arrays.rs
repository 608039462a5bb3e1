//! Numbers passed from Python: arrays without conversion, other sequences via an array.

use numpy::{PyArray1, PyReadonlyArray1, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::failure::Failure;

/// A vector of numbers, borrowed if it is contiguous.
pub enum Numbers<'py> {
    /// The memory of an array.
    Borrowed(PyReadonlyArray1<'py, f64>),
    /// A copy of values that are not contiguous.
    Owned(Vec<f64>),
}

impl Numbers<'_> {
    /// The numbers as a slice.
    pub fn as_slice(&self) -> &[f64] {
        match self {
            // Others were gathered.
            Self::Borrowed(array) => array.as_slice().unwrap_or_default(),
            Self::Owned(values) => values,
        }
    }
}

/// Numbers of a one-dimensional array or sequence, of the given length if any.
///
/// # Errors
/// `InputError` if a value is not a real number, `ShapeError` for a wrong shape.
pub fn numbers<'py>(
    what: &str,
    given: &Bound<'py, PyAny>,
    expected: Option<usize>,
) -> Result<Numbers<'py>, Failure> {
    let found = match given.extract::<PyReadonlyArray1<'py, f64>>() {
        Ok(array) => array,
        Err(_) => converted(what, given)?,
    };
    if let Some(expected) = expected
        && found.len() != expected
    {
        let found = found.len();
        let message = format!("{what} has {found} values, but must have {expected}");
        return Err(Failure::Refused("ShapeError", message));
    }
    Ok(match found.as_slice() {
        Ok(_) => Numbers::Borrowed(found),
        Err(_) => Numbers::Owned(found.as_array().to_vec()),
    })
}

/// Numbers of another type, converted to floats without loss.
fn converted<'py>(
    what: &str,
    given: &Bound<'py, PyAny>,
) -> Result<PyReadonlyArray1<'py, f64>, Failure> {
    let numpy = given.py().import("numpy")?;
    let no_numbers = |_| {
        let kind = given.get_type().name().map_or_else(|_| String::new(), |name| name.to_string());
        Failure::input(format!("{what} must be real numbers, and is no array of any: {kind}"))
    };
    let array = numpy.call_method1("asarray", (given,)).map_err(no_numbers)?;
    let untyped = array.cast::<PyUntypedArray>().map_err(PyErr::from)?;
    if untyped.ndim() != 1 {
        let shape = untyped.shape();
        let message = format!("{what} has the shape {shape:?}, but must have one dimension");
        return Err(Failure::Refused("ShapeError", message));
    }
    let kind = untyped.dtype();
    let refused = |_| {
        let message = format!("{what} has values of type {kind}, but must be real numbers");
        Failure::input(message)
    };
    // An empty list is one of floats.
    let floats = array.call_method1("astype", ("float64", "K", "safe")).map_err(refused)?;
    Ok(floats.extract()?)
}

/// Moves a vector into an array.
pub fn array(py: Python<'_>, values: Vec<f64>) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_vec(py, values)
}

//! Checks for values that are not finite.

#[cfg(feature = "implicit")]
use super::{Stretch, Trial};

/// Evaluates df/dy at a state, in pattern order.
///
/// # Errors
/// [`Trial::NotFinite`] if an entry is not finite.
#[cfg(feature = "implicit")]
pub(in crate::method) fn finite_jacobian(
    stretch: &Stretch<'_>,
    time: f64,
    state: &[f64],
    jacobian: &mut [f64],
) -> Result<(), Trial> {
    stretch.jacobian(time, state, jacobian);
    match first_not_finite(jacobian) {
        None => Ok(()),
        Some(entry) => {
            let (row, _) = stretch.system.jacobian_pattern().entries[entry];
            let what = "the Jacobian of the rate of";
            Err(Trial::NotFinite { what, index: row as usize })
        }
    }
}

/// Refuses values that are not finite.
///
/// # Errors
/// [`Trial::NotFinite`] with the first of them.
#[cfg(feature = "implicit")]
pub(in crate::method) fn require_finite(what: &'static str, values: &[f64]) -> Result<(), Trial> {
    match first_not_finite(values) {
        None => Ok(()),
        Some(index) => Err(Trial::NotFinite { what, index }),
    }
}

/// Returns the index of the first value that is not finite. It is searched for only if there is
/// one, which can be determined for all values at once.
pub(in crate::method) fn first_not_finite(values: &[f64]) -> Option<usize> {
    let is_wrong = values.iter().fold(false, |wrong, value| wrong | !value.is_finite());
    if is_wrong { values.iter().position(|value| !value.is_finite()) } else { None }
}

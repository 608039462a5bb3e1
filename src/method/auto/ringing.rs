//! Linear machines for which steps of any method are less accurate than closed forms.

use nalgebra::linalg::Schur;

use super::Stretch;
use crate::dense::{balance, dense};

/// Number of tolerances by which the rounding error of a closed form may be larger, if steps would
/// err by at least as much.
pub(super) const LENIENT: f64 = 100.0;
/// Number of states above which steps are preferable.
const MOST_STATES: usize = 200;
/// |h lambda| of the longest steps that can follow an oscillation.
const LONGEST: f64 = 8.0;
/// Rounding error of a closed form per radian of the motion.
const ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// Returns whether every motion for whose rounding a closed form was refused oscillates so long
/// that a stepping method would take more than [`LENIENT`] steps, each with an error of about a
/// tolerance.
pub(super) fn rings(stretch: &Stretch<'_>) -> bool {
    let system = stretch.system;
    let states = system.states();
    if system.simulator().linear().is_none() || states > MOST_STATES {
        return false;
    }
    let pattern = system.jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    stretch.jacobian(stretch.from, &vec![0.0; states], &mut values);
    let mut matrix = dense(pattern, &values);
    if matrix.iter().any(|value| !value.is_finite()) {
        return false;
    }
    balance(&mut matrix);
    let Some(schur) = Schur::try_new(matrix, f64::EPSILON, 10_000) else { return false };
    let span = stretch.until - stretch.from;
    schur.complex_eigenvalues().iter().all(|value| {
        let radians = value.norm() * span;
        if ROUNDINGS * radians <= stretch.rtol {
            return true;
        }
        let decay = stretch.rtol.ln().abs() / value.re.abs();
        value.norm() * span.min(decay) > LENIENT * LONGEST
    })
}

//! Linear machines: what their equations are excited by, as functions of time whose
//! response is known in closed form.

use crate::Real;

/// Numbers of each term: growth g, frequency w, cosine C and sine S.
pub const TERM_NUMBERS: usize = 4;

/// Equations that are linear with constant coefficients,
///
/// ```text
/// y' = A y + b(t)    b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
/// ```
///
/// on pieces of time between switches. A is the Jacobian of the rate at any state
/// and time of a piece.
pub trait LinearEquations<R: Real> {
    /// Entry of the state on whose rate a term of b acts, and its power k.
    fn excitation_terms(&self) -> &[(u32, u32)];

    /// g \[1/s\], w \[rad/s\], C and S \[the rate's unit over s^k\] of every term,
    /// [`TERM_NUMBERS`] each, on the piece that holds `time` in its inside.
    ///
    /// # Panics
    /// If a slice has another length than stated; likewise below.
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]);

    /// Number of switches.
    fn switches(&self) -> usize;

    /// Times \[s\] at which pieces end, unsorted; not finite where there is none.
    fn switch_times(&self, parameters: &[R], times: &mut [R]);
}

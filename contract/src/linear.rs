//! Linear machines: the excitation of their equations, as functions of time with a known response
//! in closed form.

use crate::Real;

/// Number of values of each term: growth g, frequency w, cosine C and sine S.
pub const TERM_NUMBERS: usize = 4;

/// Equations that are linear with constant coefficients,
///
/// ```text
/// y' = A y + b(t)    b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
/// ```
///
/// piecewise in time, between switches. A is the Jacobian of the rate at any state and time of a
/// piece.
pub trait LinearEquations<R: Real> {
    /// Returns, for each term of b, the entry of the state whose rate it contributes to, and its
    /// power k.
    fn excitation_terms(&self) -> &[(u32, u32)];

    /// Computes g \[1/s\], w \[rad/s\], C and S \[the rate's unit over s^k\] of every term,
    /// [`TERM_NUMBERS`] each, on the piece whose interior contains `time`.
    ///
    /// # Panics
    /// If a slice has another length than stated; likewise below.
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]);

    /// Returns the number of switches.
    fn switches(&self) -> usize;

    /// Computes the times \[s\] at which pieces end, unsorted; a time without a switch is not
    /// finite.
    fn switch_times(&self, parameters: &[R], times: &mut [R]);
}

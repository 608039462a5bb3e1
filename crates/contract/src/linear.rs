//! Linear machines: the excitation of their equations, as functions of time with a known response
//! in closed form.

use crate::Real;

/// Number of values of each term: growth g, frequency w, cosine C and sine S.
pub const TERM_NUMBERS: usize = 4;

/// Equations that are linear with constant coefficients while relations and modes are held,
///
/// ```text
/// y' = A y + b(t)    b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
/// ```
///
/// piecewise in time, between switches. Rows behind those of the state are the guards of events,
/// then those of kinks: `c y + d(t)`, with d of the same form. Without such rows A is the Jacobian
/// of the rate at any state and time of a piece.
pub trait LinearEquations<R: Real> {
    /// Returns, for each term of b and d, the row that it contributes to, and its power k.
    fn excitation_terms(&self) -> &[(u32, u32)];

    /// Returns the row and the entry of the state of each nonzero of A and c; none without guards.
    fn slopes(&self) -> &[(u32, u32)] {
        &[]
    }

    /// Computes g \[1/s\], w \[rad/s\], C and S \[the row's unit over s^k\] of every term,
    /// [`TERM_NUMBERS`] each, on the piece whose interior contains `time`, then the nonzeros of A and c.
    /// Relations are held by the slots behind the parameters. Of the state only modes are read.
    ///
    /// # Panics
    /// If a slice has another length than stated; likewise below.
    fn excitation(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]);

    /// Returns the number of switches.
    fn switches(&self) -> usize;

    /// Computes the times \[s\] at which pieces end, unsorted; a time without a switch is not
    /// finite.
    fn switch_times(&self, parameters: &[R], times: &mut [R]);
}

//! Excitation of a machine that is linear with constant coefficients.

use serde::{Deserialize, Serialize};

use crate::Tape;

/// b(t) of y' = A y + b(t), with
///
/// ```text
/// b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
/// ```
///
/// A is the Jacobian of the rate anywhere between switching times.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Excitation {
    /// (entry of the state on whose rate a term acts, power k of time) of every term.
    pub terms: Vec<(u32, u32)>,
    /// g, w, C and S of every term. Time only selects the piece: any time within a piece gives the
    /// same values.
    pub values: Tape,
    /// End times of the pieces, functions of parameters only; not finite where a piece has no end.
    pub switches: Tape,
}

impl Excitation {
    /// Highest power of time allowed, because a solver allocates memory for each.
    pub const HIGHEST_POWER: u32 = 64;
}

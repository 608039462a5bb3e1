//! Excitation of a machine that is linear with constant coefficients while modes and relations are
//! held.

use serde::{Deserialize, Serialize};

use crate::Tape;

/// b(t) of y' = A y + b(t), with
///
/// ```text
/// b(t) = sum of t^k e^(g t) (C cos(w t) + S sin(w t))
/// ```
///
/// Rows behind those of the state are guards of events, then guards of kinks: c y + d(t) with d of
/// the same form. Without such rows A is the Jacobian of the rate anywhere between switching times.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Excitation {
    /// (row on which a term acts, power k of time) of every term.
    pub terms: Vec<(u32, u32)>,
    /// (row, entry of the state) of every nonzero of A and c; none without guards.
    pub slopes: Vec<(u32, u32)>,
    /// g, w, C and S of every term, then the nonzeros of A and c. Time only selects the piece: any time
    /// within a piece gives the same values. Of the state only modes are read.
    pub values: Tape,
    /// End times of the pieces, functions of parameters only; not finite where a piece has no end.
    pub switches: Tape,
}

impl Excitation {
    /// Highest power of time allowed, because a solver allocates memory for each.
    pub const HIGHEST_POWER: u32 = 64;
}

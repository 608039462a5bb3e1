//! What excites a machine that is linear with constant coefficients.

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
    /// Entry of the state on whose rate a term acts, and its power k of time.
    pub terms: Vec<(u32, u32)>,
    /// g, w, C and S of every term. Time is read only to choose between pieces:
    /// any time of a piece gives the same values.
    pub values: Tape,
    /// Times at which pieces end, of parameters only; not finite where there is none.
    pub switches: Tape,
}

impl Excitation {
    /// Powers of time beyond which there is none: who solves for it takes room for each.
    pub const HIGHEST_POWER: u32 = 64;
}

//! Closed-form solution of linear machines, without steps: by eigenmodes or by the matrix
//! exponential.
//!
//! ```text
//! y' = A y + sum of c t^k e^(mu t)      mu = g + i w, c = C - i S, real parts
//! ```
//!
//! on pieces of a run between the switches of the excitation. A chain of masses, springs and
//! proportional dampers is solved by eigenmodes, each in closed form ([`modal`]); any other machine
//! by [`exponential`].
//!
//! A machine with events or relations has such equations while modes and relations are held. Its
//! closed form is summed as a power series over [`steps`], because guards may cross zero at any
//! time.

mod chain;
mod equations;
mod exponential;
mod flows;
mod forms;
mod modal;
mod piece;
mod response;
mod rows;
mod steps;
mod tangents;

use super::one_step::drive_all;
use super::taylor::quadrature::Gauss;
use super::{Integrator, Samples, Sealed, Stopped, Stretch, explicit};
use crate::error::StopCause;
pub(super) use equations::Known;
use equations::Refusal;
use exponential::Exponential;
use machinist_contract::linear::LinearEquations;
use modal::Modal;
use piece::Piece;
use steps::ExactSteps;

/// Closed-form solution of linear machines.
pub(super) struct Exact;

/// Note on a machine with switches.
const BETWEEN_SWITCHES: &str = "linear with constant coefficients between switches: solved in closed form from one to the next";

/// A solution on a piece.
trait Solution {
    /// Computes the state at a time of the piece, not before the last [`Solution::settle`].
    fn state_at(&mut self, time: f64, state: &mut [f64]);
    /// Declares that later requests are not before this time, whose state is given.
    fn settle(&mut self, time: f64, state: &[f64]);
}

impl Sealed for Exact {}

impl Integrator for Exact {
    fn integrate(
        &self,
        stretch: &Stretch<'_>,
        state: &mut [f64],
        samples: &mut Samples<'_>,
    ) -> Result<(), Stopped> {
        let refuse = |time, reason| Stopped { time, cause: StopCause::ClosedForm { reason } };
        let linear = stretch.system.simulator().linear();
        let linear = linear.ok_or(Stopped { time: stretch.from, cause: StopCause::NotLinear })?;
        let (system, has_guards) = (stretch.system, stretch.watch.is_some());
        if has_guards || system.constraints().is_some() || system.tangents().is_some() {
            return between_switches(stretch, linear, state, samples);
        }
        let ends = piece::ends(stretch, linear);
        for ends in ends.windows(2) {
            let piece = Piece::new(stretch, linear, (ends[0], ends[1]), state)
                .map_err(|reason| refuse(ends[0], reason))?;
            let mut solution =
                solution(&piece, stretch, state).map_err(|reason| refuse(piece.from, reason))?;
            carry(&piece, stretch, &mut *solution, state, samples)?;
            stretch.system.count(|work| work.steps += 1);
        }
        Ok(())
    }
}

/// Integrates a machine whose relations and modes change where guards cross zero.
fn between_switches(
    stretch: &Stretch<'_>,
    linear: &dyn LinearEquations<f64>,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    let mut steps = match ExactSteps::new(stretch, linear, state) {
        Ok(steps) => steps,
        Err(Refusal::Surface) => {
            stretch.system.note(
                "dop853 instead of exact along switching surfaces whose rates differ by more than a \
                 constant"
                    .to_owned(),
            );
            return explicit::Dop853.integrate(stretch, state, samples);
        }
        Err(Refusal::Reason(reason)) => {
            let cause = StopCause::ClosedForm { reason };
            return Err(Stopped { time: stretch.from, cause });
        }
    };
    stretch.system.note(BETWEEN_SWITCHES.to_owned());
    drive_all(&mut steps, stretch, state, samples).map_err(|stopped| match steps.refusal() {
        Some(Refusal::Reason(reason)) => {
            Stopped { cause: StopCause::ClosedForm { reason: reason.clone() }, ..stopped }
        }
        _ => stopped,
    })
}

/// Returns the solution by eigenmodes if the piece has them, otherwise by the exponential if it
/// meets the tolerance.
fn solution<'a>(
    piece: &'a Piece,
    stretch: &Stretch<'_>,
    state: &[f64],
) -> Result<Box<dyn Solution + 'a>, String> {
    let states = &state[..piece.states()];
    stretch.system.count(|work| work.factorizations += 1);
    if let Some(modal) = Modal::new(piece, stretch, states)? {
        let modes = match modal.modes() {
            1 => "mode".to_owned(),
            count => format!("{count} modes"),
        };
        stretch.system.note(format!(
            "linear with constant coefficients: solved by its {modes}, without steps"
        ));
        return Ok(Box::new(modal));
    }
    let exponential = Exponential::new(piece, stretch, states)?;
    stretch.system.note(
        "linear with constant coefficients: solved by the exponential of its matrix, without steps"
            .to_owned(),
    );
    Ok(Box::new(exponential))
}

/// Takes samples of a solution, and computes the state at the end of the piece.
fn carry(
    piece: &Piece,
    stretch: &Stretch<'_>,
    solution: &mut dyn Solution,
    state: &mut [f64],
    samples: &mut Samples<'_>,
) -> Result<(), Stopped> {
    let states = piece.states();
    let rule = (state.len() > states).then(|| Gauss::new(flows::POINTS));
    let mut reached = piece.from;
    let mut next = vec![0.0; states];
    loop {
        let sample = samples.next_until(piece.until);
        let time = sample.unwrap_or(piece.until);
        if time > reached {
            solution.state_at(time, &mut next);
            stretch
                .require_bounded(time, &next)
                .map_err(|stopped| Stopped { time: reached, ..stopped })?;
            if let Some(rule) = &rule {
                flows::carry(stretch, solution, rule, [reached, time], &mut state[states..]);
            }
            state[..states].copy_from_slice(&next);
            solution.settle(time, &next);
            reached = time;
        }
        if sample.is_none() {
            return Ok(());
        }
        samples.push(state);
        stretch.require_uninterrupted(reached)?;
    }
}

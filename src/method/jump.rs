//! Jumps of velocities: where prescribed motions have a kink in time, or constraints have a corner.
//!
//! The impulse of the constraint forces is determined by nothing else:
//!
//! ```text
//! M (v+ - v-) + G^T nu = 0,   g'(q, v+, t) = 0 after the jump
//! ```
//!
//! It is the limit of ever shorter ramps of a prescribed velocity, and its work is supplied. At a
//! corner, which the machine passes by itself, the impulse takes energy, which is reported.
//!
//! Dry friction that sticks has a finite force, so it sends no impulse and begins anew from the
//! speed behind the jump. Other constraints that hold in some modes only stop the run.

use machinist_contract::{Constraint, Shape};

use super::watch::is_beyond;
use super::{StepTolerance, Stopped, System};
use crate::constraints::Level;
use crate::error::StopCause;

/// Share of the tolerances below which a move is not a jump.
const NOTICED: f64 = 1e-3;
/// Factor of the move that a rate makes in the time between, below which a move is not a jump.
const MOMENTS: f64 = 64.0;
/// Share of an impulse below which it is rounding.
const PULLS: f64 = 1e-6;

/// Returns a time just after another, on a stretch up to some end.
pub(crate) fn just_behind(time: f64, until: f64) -> f64 {
    const ROUNDINGS: f64 = 4.0;
    let size = time.abs().max(until - time);
    (time + ROUNDINGS * f64::EPSILON * size).min(until)
}

impl System<'_> {
    /// Projects a state onto the constraints at a time just `behind` a jump, which do not hold at
    /// one in `front` of it. Returns whether it moved, or let friction go.
    ///
    /// # Errors
    /// [`StopCause::SpeedJumps`] if a constraint that holds in some modes only would have to pull
    /// along.
    pub(crate) fn take_up(
        &self,
        times: (f64, f64),
        allowed: &StepTolerance,
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        self.take_up_as(times, None, allowed, state)
    }

    /// Does the same after a change of relations, by time or because the machine went there.
    ///
    /// # Errors
    /// As [`System::take_up`].
    pub(crate) fn go_along(
        &self,
        time: f64,
        is_of_time: bool,
        allowed: &StepTolerance,
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        self.take_up_as((time, time), Some(!is_of_time), allowed, state)
    }

    /// Lets friction that sticks begin anew. Returns whether it does: a contact that cannot slide
    /// this way sticks on. Events that were just `applied` count as beyond zero, where their guards
    /// are but for rounding.
    pub(super) fn reopen(
        &self,
        mode: usize,
        (time, state): (f64, &mut [f64]),
        applied: &[usize],
    ) -> bool {
        let simulator = self.simulator();
        let stuck = std::mem::replace(&mut state[mode], Constraint::OPEN);
        let events = simulator.events();
        let mut guards = vec![0.0; events];
        simulator.guards(time, state, &self.held().all(), &mut guards);
        let sticks_again = |event: usize| {
            let of = simulator.event(event);
            of.when.iter().any(|(entry, _)| *entry as usize == mode)
                && self.is_armed(event, state)
                && (is_beyond(of.direction, guards[event]) || applied.contains(&event))
                && self.new_values(event, time, state).into_iter().any(|(entry, value)| {
                    // Modes are integers, but for rounding.
                    entry == mode && (value - stuck).abs() < 0.5
                })
        };
        let begins = !(0..events).any(sticks_again);
        if !begins {
            state[mode] = stuck;
        }
        begins
    }

    /// Lets the friction of a constraint begin anew from the speed to which the others move it.
    fn begins_anew(&self, row: usize, behind: f64, state: &mut [f64]) -> bool {
        let friction = self.simulator().constraint(row).friction;
        let Some((constraints, mode)) = self.constraints().zip(friction) else { return false };
        let mode = mode as usize;
        let mut there = state[..self.states()].to_vec();
        there[mode] = Constraint::OPEN;
        constraints.follow(&constraints.prescribed(behind, &there), behind, &mut there);
        there[mode] = state[mode];
        let begins = self.reopen(mode, (behind, &mut there), &[]);
        state[mode] = there[mode];
        begins
    }

    fn take_up_as(
        &self,
        (front, behind): (f64, f64),
        is_corner: Option<bool>,
        allowed: &StepTolerance,
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        let Some(constraints) = self.constraints() else { return Ok(false) };
        let states = self.states();
        let prescribed = constraints.prescribed(behind, &state[..states]);
        let mut after = state[..states].to_vec();
        constraints.follow(&prescribed, behind, &mut after);
        let StepTolerance { rtol, atol, .. } = allowed;
        let moved = |index: usize| (after[index] - state[index]).abs();
        let in_tolerances = |index: usize| moved(index) / (atol[index] + rtol * state[index].abs());
        let is_noticed = |index: usize| in_tolerances(index) > NOTICED;
        let is_jump = (0..states).any(|index| in_tolerances(index) > 1.0);
        if !(0..states).any(is_noticed) {
            return Ok(false);
        }
        let [mut rate, mut rate_behind] = [(); 2].map(|()| vec![0.0; states]);
        self.state_rate(front, &state[..states], &mut rate);
        self.state_rate(behind, &state[..states], &mut rate_behind);
        let passed =
            |index: usize| (behind - front) * rate[index].abs().max(rate_behind[index].abs());
        if !(0..states).any(|index| is_noticed(index) && moved(index) > MOMENTS * passed(index)) {
            return Ok(false);
        }
        let simulator = self.simulator();
        let Shape { positions, coordinates, .. } = simulator.shape();
        let velocities = positions..positions + coordinates;
        let moved: Vec<f64> = velocities.map(|entry| after[entry] - state[entry]).collect();
        let shares = constraints.shares_of_impulse(behind, &after, &moved);
        let is_jerked = |row: &usize| simulator.constraint(*row).in_modes && shares[*row] > PULLS;
        if let Some(row) = (0..shares.len()).find(is_jerked) {
            if self.begins_anew(row, behind, state) {
                self.take_up_as((front, behind), is_corner, allowed, state)?;
                return Ok(true);
            }
            let constraint = constraints.name(row).to_owned();
            return Err(Stopped {
                time: front.next_up(),
                cause: StopCause::SpeedJumps { constraint },
            });
        }
        let energy = |state: &[f64]| simulator.energy(behind, state, self.parameters()).total();
        let gained = energy(&after) - energy(&state[..states]);
        let is_corner = is_corner.unwrap_or_else(|| {
            let [now, earlier] = [behind, front]
                .map(|time| constraints.residual(Level::Velocities, time, &state[..states]));
            (&now - earlier).amax() < 0.5 * now.amax()
        });
        if is_corner && is_jump {
            self.note(
                "velocities jump at a corner of a constraint, which dissipates energy: round the \
                 corner to avoid this"
                    .to_owned(),
            );
        }
        if state.len() > states {
            // Supplied, or dissipated.
            state[states + usize::from(is_corner)] += if is_corner { -gained } else { gained };
            state[states + 2] += gained.abs();
        }
        state[..states].copy_from_slice(&after);
        Ok(true)
    }
}

//! Speeds that jump: where what constraints impose has a kink in time, or what holds has a corner.
//!
//! The constraints' own forces give the impulse, and nothing else does:
//!
//! ```text
//! M (v+ - v-) + G^T nu = 0,   g'(q, v+, t) = 0 behind the jump
//! ```
//!
//! so it is what ever shorter ramps of an imposed speed lead to, and its work is supplied. At a
//! corner, over which the machine goes by itself, it takes energy, which is told. What
//! holds in some modes only, such as friction that sticks, has not any force, and stops the run.

use super::{Stopped, Stretch, System};
use crate::constraints::Level;
use crate::error::StopCause;

/// What moves by a smaller share of the tolerances does not jump.
const NOTICED: f64 = 1e-3;
/// Nor does what so many times the time between would do.
const MOMENTS: f64 = 64.0;
/// A smaller share of an impulse is rounding.
const PULLS: f64 = 1e-6;

/// A time just behind another, on a stretch until some end.
pub(crate) fn just_behind(time: f64, until: f64) -> f64 {
    const ROUNDINGS: f64 = 4.0;
    let size = time.abs().max(until - time);
    (time + ROUNDINGS * f64::EPSILON * size).min(until)
}

impl System<'_> {
    /// Puts a state onto what constraints hold at a time just `behind` a jump, and did not at one
    /// in `front` of it; whether it moved.
    ///
    /// # Errors
    /// [`StopCause::Jerked`] if something that holds in some modes only would have to pull along.
    pub(crate) fn take_up(
        &self,
        (front, behind): (f64, f64),
        (rtol, atol): (f64, &[f64]),
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        let Some(constraints) = self.constraints() else { return Ok(false) };
        let states = self.states();
        let led = constraints.led(behind, &state[..states]);
        let mut after = state[..states].to_vec();
        constraints.follow(&led, behind, &mut after);
        let moved = |index: usize| (after[index] - state[index]).abs();
        let is_noticed =
            |index: usize| moved(index) > NOTICED * (atol[index] + rtol * state[index].abs());
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
        let n = simulator.shape().coordinates;
        let moved: Vec<f64> = (n..2 * n).map(|entry| after[entry] - state[entry]).collect();
        let shares = constraints.shares_of_impulse(behind, &after, &moved);
        let is_jerked = |row: &usize| simulator.constraint(*row).in_modes && shares[*row] > PULLS;
        if let Some(row) = (0..shares.len()).find(is_jerked) {
            let constraint = constraints.name(row).to_owned();
            return Err(Stopped { time: front.next_up(), cause: StopCause::Jerked { constraint } });
        }
        let energy = |state: &[f64]| simulator.energy(behind, state, self.parameters()).total();
        let gained = energy(&after) - energy(&state[..states]);
        let [now, earlier] = [behind, front]
            .map(|time| constraints.residual(Level::Velocities, time, &state[..states]));
        let is_corner = (&now - earlier).amax() < 0.5 * now.amax();
        if is_corner {
            self.note(
                "speeds jump at a corner of what constraints hold, which takes energy: round it \
                 if it should not"
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

impl Stretch<'_> {
    /// As [`System::take_up`], at times of this stretch.
    pub(super) fn take_up(
        &self,
        (front, behind): (f64, f64),
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        let times = (self.within(front), self.within(behind));
        self.system.take_up(times, (self.rtol, self.atol), state)
    }
}

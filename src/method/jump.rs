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

use nalgebra::DVector;

use super::{Stopped, Stretch, System};
use crate::constraints::Level;
use crate::dense::dense;
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

impl System<'_> {
    /// Lets velocities go on with their momentum where the kinetic energy jumps between two times:
    ///
    /// ```text
    /// dT/dv (v+, behind) + G^T nu = dT/dv (v-, front)
    /// ```
    ///
    /// whether they have moved. What the energy changes by is supplied.
    ///
    /// # Errors
    /// [`StopCause::InertiaJumps`] if sensitivities are carried.
    pub(crate) fn keep_momentum(
        &self,
        (front, behind): (f64, f64),
        state: &mut [f64],
    ) -> Result<bool, Stopped> {
        /// Momenta that differ by rounding do not jump.
        const ROUNDINGS: f64 = 1e3;
        let (simulator, states) = (self.simulator(), self.states());
        let shape = simulator.shape();
        let before = self.momentum(front, &state[..states]);
        let after = self.momentum(behind, &state[..states]);
        let size = before.iter().chain(&after).fold(0.0, |most: f64, p| most.max(p.abs()));
        let left: Vec<f64> = before.iter().zip(&after).map(|(a, b)| a - b).collect();
        if left.iter().all(|left| left.abs() <= ROUNDINGS * f64::EPSILON * size) {
            return Ok(false);
        }
        if self.tangents().is_some() {
            return Err(Stopped { time: behind, cause: StopCause::InertiaJumps });
        }
        let energy =
            |time: f64, state: &[f64]| simulator.energy(time, state, self.parameters()).total();
        let earlier = energy(front, &state[..states]);
        let pattern = simulator.mass_matrix_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        simulator.mass_matrix(behind, &state[..states], self.parameters(), &mut values);
        let mass = dense(pattern, &values);
        let Some(moved) = mass.lu().solve(&DVector::from_vec(left)) else { return Ok(false) };
        for (index, moved) in moved.iter().enumerate() {
            state[shape.positions + index] += moved;
        }
        self.constrain(behind, state)?;
        let gained = energy(behind, &state[..states]) - earlier;
        if state.len() > states {
            state[states] += gained;
            state[states + 2] += gained.abs();
        }
        Ok(true)
    }

    /// dT/dv, one for each coordinate: T is of second degree in velocities, of which central
    /// differences are exact.
    fn momentum(&self, time: f64, state: &[f64]) -> Vec<f64> {
        let shape = self.simulator().shape();
        let mut shifted = state.to_vec();
        (0..shape.coordinates)
            .map(|coordinate| {
                let entry = shape.positions + coordinate;
                let by = self.simulator().state_scale(entry).max(state[entry].abs());
                let mut kinetic = |by: f64| {
                    shifted[entry] = state[entry] + by;
                    let energy = self.simulator().energy(time, &shifted, self.parameters());
                    shifted[entry] = state[entry];
                    energy.kinetic
                };
                (kinetic(by) - kinetic(-by)) / (2.0 * by)
            })
            .collect()
    }
}

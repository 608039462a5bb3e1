//! The driven shaft and its reed as a row of rigid cells on torsion springs.
//!
//! ```text
//! m u_k'' = k (u_(k+1) - u_k) - k (u_k - u_(k-1)) - [C0 (u_0 - u0)] - [C1 (u_n - ur)]
//! Ir ur'' = C1 (u_n - ur) - C2 ur                 C2 max(ur, 0) for a fell that only pushes
//! m = rho Jp dx, half of it at both ends          k = G Jp/dx
//! ```
//!
//! Cells and time steps are uniform. The steps are those of the classical Runge-Kutta method, with
//! errors far below that of the cells. Nothing is shared with the elements of the scenes
//! `reed_beat_up` and `reed_beat_up_one_sided`, nor with the engine: the model is an independent
//! formulation of the study's machine, and the only one by hand that remains valid when the fell
//! lets go.
//!
//! Source: reed study, in its consistent reading; cells by hand.

use crate::closed_form::reed::{ReedMotion, ReedShaft};

/// Force law of the cloth fell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fell {
    /// Pushes and pulls: a spring in both directions.
    PushesAndPulls,
    /// Pushes only while the reed is beyond the fell's edge.
    OnlyPushes,
}

/// Model of the shaft as cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReedCells {
    /// Shaft, reed and fell.
    pub shaft: ReedShaft,
    /// Force law of the fell.
    pub fell: Fell,
    /// Number of cells, chosen so that the reed sits between two of them.
    pub cells: usize,
}

/// Cells with precomputed coefficients of their rates.
struct Row {
    reed_node: usize,
    node_inertia: f64,
    spring: f64,
    inertia: f64,
    fell: Fell,
    shaft: ReedShaft,
    drive: [f64; 2],
}

/// A state within a step, and the slopes of its four stages.
type Work = [Vec<f64>; 5];

/// Courant number h c/dx. Cells vibrate with up to 2 c/dx, and steps are stable up to h w = 2
/// sqrt(2).
const STEP_SHARE: f64 = 0.9;

impl ReedCells {
    /// Computes the motion from rest under the study's drive at ascending times \[s\].
    #[must_use]
    pub fn motion(&self, times: &[f64]) -> Vec<ReedMotion> {
        let row = self.row();
        let wave_speed = (self.shaft.shear_modulus() / self.shaft.density).sqrt();
        let largest = STEP_SHARE * self.width() / wave_speed;
        let mut state = vec![0.0; 2 * (self.cells + 2)];
        let mut work: Work = std::array::from_fn(|_| state.clone());
        let mut now = 0.0;
        let mut motion = Vec::with_capacity(times.len());
        for &time in times {
            let steps = ((time - now) / largest).ceil();
            let step = (time - now) / steps;
            for index in 0..steps as usize {
                row.advance(now + index as f64 * step, step, &mut state, &mut work);
            }
            now = time;
            motion.push(row.seen(now, &state));
        }
        motion
    }

    /// Returns dx \[m\].
    fn width(&self) -> f64 {
        self.shaft.length / self.cells as f64
    }

    fn row(&self) -> Row {
        let (shaft, width) = (self.shaft, self.width());
        Row {
            reed_node: (shaft.reed_position / width).round() as usize,
            node_inertia: shaft.density * shaft.polar_moment() * width,
            spring: shaft.shear_modulus() * shaft.polar_moment() / width,
            inertia: shaft.reed_inertia(),
            fell: self.fell,
            shaft,
            drive: [shaft.drive_amplitude(), shaft.drive_frequency()],
        }
    }
}

impl Row {
    /// Computes rates of the angles of nodes and, last, of the reed; then of their speeds.
    fn rate(&self, time: f64, state: &[f64], rate: &mut [f64]) {
        let (angles, speeds) = state.split_at(state.len() / 2);
        let (moving, accelerations) = rate.split_at_mut(speeds.len());
        moving.copy_from_slice(speeds);
        let (reed, last) = (angles.len() - 1, angles.len() - 2);
        for node in 0..=last {
            let before = if node > 0 { angles[node] - angles[node - 1] } else { 0.0 };
            let after = if node < last { angles[node + 1] - angles[node] } else { 0.0 };
            let share = if node == 0 || node == last { 0.5 } else { 1.0 };
            accelerations[node] = self.spring * (after - before) / (share * self.node_inertia);
        }
        let [amplitude, frequency] = self.drive;
        let drive = amplitude * (frequency * time).sin();
        accelerations[0] +=
            self.shaft.drive_stiffness * (drive - angles[0]) / (0.5 * self.node_inertia);
        let carried = self.shaft.reed_stiffness * (angles[self.reed_node] - angles[reed]);
        accelerations[self.reed_node] -= carried / self.node_inertia;
        let pressed = match self.fell {
            Fell::PushesAndPulls => angles[reed],
            Fell::OnlyPushes => angles[reed].max(0.0),
        };
        accelerations[reed] = (carried - self.shaft.contact_stiffness * pressed) / self.inertia;
    }

    fn advance(&self, time: f64, step: f64, state: &mut [f64], [there, slopes @ ..]: &mut Work) {
        for stage in 0..4 {
            let part = [0.0, 0.5, 0.5, 1.0][stage] * step;
            there.copy_from_slice(state);
            if stage > 0 {
                for (value, slope) in there.iter_mut().zip(&slopes[stage - 1]) {
                    *value += part * slope;
                }
            }
            self.rate(time + part, there, &mut slopes[stage]);
        }
        let [first, second, third, fourth] = slopes;
        for (index, value) in state.iter_mut().enumerate() {
            let middle = second[index] + third[index];
            *value += step / 6.0 * (first[index] + 2.0 * middle + fourth[index]);
        }
    }

    /// Returns angles and stresses. The section beside the reed balances half of its node's
    /// inertia.
    fn seen(&self, time: f64, state: &[f64]) -> ReedMotion {
        let mut rate = vec![0.0; state.len()];
        self.rate(time, state, &mut rate);
        let (node, reed) = (self.reed_node, state.len() / 2 - 1);
        let inertial = 0.5 * self.node_inertia * rate[state.len() / 2 + node];
        let before = self.spring * (state[node] - state[node - 1]) + inertial;
        let after = self.spring * (state[node + 1] - state[node]) - inertial;
        let stress = |torque: f64| torque * self.shaft.radius / self.shaft.polar_moment();
        ReedMotion {
            shaft_angle: state[node],
            reed_angle: state[reed],
            stress: [stress(before), stress(after)],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed_form::reed::{REED_STUDY, Reed, ReedTransient};

    fn touching() -> ReedShaft {
        ReedShaft { contact_stiffness: 0.5 * REED_STUDY.reed_stiffness, ..REED_STUDY }
    }

    #[test]
    fn cells_near_the_series_of_modes_as_they_are_refined() {
        let shaft = touching();
        let drive = [shaft.drive_amplitude(), shaft.drive_frequency()];
        let series = ReedTransient::new(&shaft, drive, Reed::Free, 3000);
        let times: Vec<f64> = (1..=40).map(|k| 1e-4 * f64::from(k)).collect();
        let error = |cells| {
            let model = ReedCells { shaft, fell: Fell::PushesAndPulls, cells };
            let off = times.iter().zip(model.motion(&times)).map(|(time, ours)| {
                let exact = series.at(*time);
                (ours.shaft_angle - exact.shaft_angle)
                    .abs()
                    .max((ours.reed_angle - exact.reed_angle).abs())
            });
            off.fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(70), error(140));
        // The error is of second order except for the kinks of waves.
        assert!(fine < 1e-5, "{fine:e}");
        assert!((1.4..2.4).contains(&(coarse / fine).log2()), "{coarse:e} {fine:e}");
    }

    #[test]
    fn before_the_reed_comes_back_a_fell_that_only_pushes_is_a_spring() {
        let times = [1e-3, 3e-3, 5e-3];
        let motion = |fell| ReedCells { shaft: touching(), fell, cells: 70 }.motion(&times);
        assert_eq!(motion(Fell::OnlyPushes), motion(Fell::PushesAndPulls));
    }

    #[test]
    fn behind_the_fell_the_reed_is_free() {
        let shaft = ReedShaft { contact_stiffness: 0.0, ..touching() };
        let times = [5e-3, 2e-2];
        let free = ReedCells { shaft, fell: Fell::OnlyPushes, cells: 70 }.motion(&times);
        let held = ReedCells { shaft, fell: Fell::PushesAndPulls, cells: 70 }.motion(&times);
        assert_eq!(free, held);
    }
}

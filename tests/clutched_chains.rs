//! Two rows of rotors on springs and dampers with a clutch between them, by hand:
//!
//! ```text
//! J w_k' = T_(k+1) - T_k + torque at k      T_k = K ((q_k - q_(k-1)) + d (w_k - w_(k-1)))
//! ```
//!
//! The clutch slips with its whole torque, or holds: then the two rotors beside it have one
//! acceleration. The classical Runge-Kutta method integrates both phases with uniform steps, and
//! bisection finds the ends of phases. No code is shared with elements, derivation or engine.

/// The rotors at the ends of the rows have half of the inertia of the others.
#[derive(Debug, Clone, Copy)]
pub struct ClutchedChains {
    /// Number of rotors less one of each row.
    pub elements: usize,
    /// Length of each shaft \[m\].
    pub length: f64,
    /// Moment of inertia per length \[kg m\].
    pub density: f64,
    /// Torsional stiffness times length \[N m^2\].
    pub stiffness: f64,
    /// Damping over stiffness \[s\].
    pub damping_time: f64,
    /// Amplitude \[N m\] and angular frequency \[rad/s\] of the cosine that drives the free end of
    /// the first row.
    pub drive: [f64; 2],
    /// Largest torque of the clutch \[N m\].
    pub capacity: f64,
    /// Damping of the free end of the second row \[N m s\].
    pub brake: f64,
}

/// Torque of a clutch that slips, positive on the second row, or a clutch that holds.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Clutch {
    Slips(f64),
    Holds,
}

/// Largest step \[s\]; the fastest decay of the stiffest chain of the tests is 15 000 1/s.
const STEP: f64 = 1e-4;

impl ClutchedChains {
    /// Computes the speeds \[rad/s\] of the ends of both rows, `[a_start, a_end, b_start, b_end]`,
    /// from rest at multiples of `interval` \[s\].
    pub fn speeds(&self, interval: f64, samples: usize) -> Vec<[f64; 4]> {
        let rotors = self.elements + 1;
        let mut state = vec![0.0; 4 * rotors];
        let mut clutch = self.next(0.0, &state);
        let steps = (interval / STEP).ceil();
        let mut speeds = Vec::new();
        for sample in 0..samples {
            let start = interval * sample as f64;
            let ends = [0, self.elements, rotors, rotors + self.elements];
            speeds.push(ends.map(|end| state[2 * rotors + end]));
            for step in 0..steps as usize {
                let time = start + interval * step as f64 / steps;
                self.advance(time, interval / steps, &mut state, &mut clutch);
            }
        }
        speeds
    }

    /// Makes one step, in parts where the clutch begins to hold or to slip.
    fn advance(&self, mut time: f64, step: f64, state: &mut Vec<f64>, clutch: &mut Clutch) {
        let mut rest = step;
        while rest > 0.0 {
            let end = self.stepped(time, rest, state, *clutch);
            if self.margin(time + rest, &end, *clutch) >= 0.0 {
                *state = end;
                return;
            }
            let (mut low, mut high) = (0.0, rest);
            while high - low > 1e-13 {
                let middle = f64::midpoint(low, high);
                let end = self.stepped(time, middle, state, *clutch);
                if self.margin(time + middle, &end, *clutch) >= 0.0 {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            *state = self.stepped(time, high, state, *clutch);
            (time, rest) = (time + high, rest - high);
            *clutch = self.next(time, state);
            if *clutch == Clutch::Holds {
                let [a, b] = self.beside(state.len());
                let speed = f64::midpoint(state[a], state[b]);
                (state[a], state[b]) = (speed, speed);
            }
        }
    }

    /// Returns a quantity that is negative once the phase has ended: the slip in its direction
    /// \[rad/s\], or what the clutch can carry beyond its torque \[N m\].
    fn margin(&self, time: f64, state: &[f64], clutch: Clutch) -> f64 {
        let [a, b] = self.beside(state.len());
        match clutch {
            Clutch::Slips(torque) => torque.signum() * (state[a] - state[b]),
            Clutch::Holds => self.capacity - self.held(time, state).abs(),
        }
    }

    /// Returns the phase that begins where the speeds beside the clutch are equal.
    fn next(&self, time: f64, state: &[f64]) -> Clutch {
        let held = self.held(time, state);
        if held.abs() < self.capacity {
            Clutch::Holds
        } else {
            Clutch::Slips(self.capacity.copysign(held))
        }
    }

    /// Returns the torque \[N m\] by which the clutch holds.
    fn held(&self, time: f64, state: &[f64]) -> f64 {
        let mut rate = vec![0.0; state.len()];
        self.rate(time, state, 0.0, &mut rate);
        let [a, b] = self.beside(state.len());
        self.end_inertia() * (rate[a] - rate[b]) / 2.0
    }

    /// Returns the places of the speeds beside the clutch.
    const fn beside(&self, states: usize) -> [usize; 2] {
        [states / 2 + self.elements, states / 2 + self.elements + 1]
    }

    fn end_inertia(&self) -> f64 {
        self.density * self.length / self.elements as f64 / 2.0
    }

    fn stepped(&self, time: f64, step: f64, state: &[f64], clutch: Clutch) -> Vec<f64> {
        let slope = |time: f64, state: &[f64]| {
            let mut rate = vec![0.0; state.len()];
            let torque = match clutch {
                Clutch::Slips(torque) => torque,
                Clutch::Holds => self.held(time, state),
            };
            self.rate(time, state, torque, &mut rate);
            rate
        };
        let moved = |slope: &[f64], share: f64| -> Vec<f64> {
            state.iter().zip(slope).map(|(state, slope)| state + share * step * slope).collect()
        };
        let first = slope(time, state);
        let second = slope(time + step / 2.0, &moved(&first, 0.5));
        let third = slope(time + step / 2.0, &moved(&second, 0.5));
        let fourth = slope(time + step, &moved(&third, 1.0));
        let mean = |k: usize| (first[k] + 2.0 * (second[k] + third[k]) + fourth[k]) / 6.0;
        (0..state.len()).map(|k| state[k] + step * mean(k)).collect()
    }

    /// Computes the rate of `[angles, speeds]` under a torque of the clutch.
    fn rate(&self, time: f64, state: &[f64], clutch: f64, rate: &mut [f64]) {
        let rotors = self.elements + 1;
        let (angles, speeds) = state.split_at(2 * rotors);
        let (turning, acceleration) = rate.split_at_mut(2 * rotors);
        turning.copy_from_slice(speeds);
        acceleration.fill(0.0);
        let spring = self.stiffness * self.elements as f64 / self.length;
        for row in [0, rotors] {
            for k in row..row + self.elements {
                let torque = spring
                    * (angles[k + 1] - angles[k] + self.damping_time * (speeds[k + 1] - speeds[k]));
                acceleration[k] += torque;
                acceleration[k + 1] -= torque;
            }
        }
        let [amplitude, frequency] = self.drive;
        acceleration[0] += amplitude * (frequency * time).cos();
        acceleration[self.elements] -= clutch;
        acceleration[rotors] += clutch;
        acceleration[rotors + self.elements] -= self.brake * speeds[rotors + self.elements];
        let inertia = self.end_inertia();
        for (k, acceleration) in acceleration.iter_mut().enumerate() {
            let is_end = k % rotors == 0 || k % rotors == self.elements;
            *acceleration /= if is_end { inertia } else { 2.0 * inertia };
        }
    }
}

//! Bobbin on a linear layer that only pushes: exact motions in contact and in flight, joined at the
//! transitions.
//!
//! ```text
//! contact:  m x'' + h (x' - Y') + c_p x + c (x - Y) = F
//! flight:   m x'' + c_p x + N0 = F         s = -N0/c + (s0 + N0/c) e^(-c t/h)
//! ```
//!
//! Contact ends when N = N0 + c (Y - x) + h (Y' - x') falls to zero. Then the layer recovers by
//! itself, with its compression s, until Y - x equals s again. Both motions are exact, as in
//! [`BobbinOscillator::motion`]; the times of the transitions are computed numerically.
//!
//! Source: by hand.

use super::winder::{BobbinOscillator, Deflection, Harmonic};

/// Bobbin, layer and spring, with pressure and disturbances.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BouncingBobbin {
    /// Bobbin in contact.
    pub bobbin: BobbinOscillator,
    /// N0, pressure at rest \[N\].
    pub preload: f64,
    /// F \[N\].
    pub force: Harmonic,
    /// Y \[m\].
    pub shape: Harmonic,
}

/// Motion at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounced {
    /// x and x'.
    pub deflection: Deflection,
    /// s \[m\]; in contact Y - x.
    pub surface: f64,
    /// N \[N\].
    pub pressure: f64,
}

impl BouncingBobbin {
    /// Returns the motion from rest in contact at t = 0, at ascending times \[s\], and the number
    /// of transitions until the last of them. Contacts and flights shorter than 0.1 ms may be
    /// missed.
    #[must_use]
    pub fn motion(&self, times: &[f64]) -> (Vec<Bounced>, usize) {
        let mut phase =
            Phase { from: 0.0, is_flight: false, start: Deflection::default(), surface: 0.0 };
        let mut until = self.end_of(&phase, times.last().copied().unwrap_or(0.0));
        let mut switches = 0;
        let mut motion = Vec::with_capacity(times.len());
        for time in times {
            while let Some(end) = until.filter(|end| end <= time) {
                let there = self.at(&phase, end);
                phase = Phase {
                    from: end,
                    is_flight: !phase.is_flight,
                    start: there.deflection,
                    surface: there.surface,
                };
                switches += 1;
                until = self.end_of(&phase, times.last().copied().unwrap_or(0.0));
            }
            motion.push(self.at(&phase, *time));
        }
        (motion, switches)
    }

    fn at(&self, phase: &Phase, time: f64) -> Bounced {
        let t = time - phase.from;
        let shape = self.shape.at(time);
        if phase.is_flight {
            let rest = -self.preload / self.bobbin.spring_stiffness;
            let free = BobbinOscillator { viscosity: 0.0, layer_stiffness: 0.0, ..self.bobbin };
            let start = Deflection { value: phase.start.value - rest, ..phase.start };
            let moved = free.motion(t, start, &[later(self.force, phase.from)], &[]);
            let deflection = Deflection { value: moved.value + rest, ..moved };
            let swollen = -self.preload / self.bobbin.layer_stiffness;
            let rate = self.bobbin.layer_stiffness / self.bobbin.viscosity;
            let surface = swollen + (phase.surface - swollen) * (-rate * t).exp();
            return Bounced { deflection, surface, pressure: 0.0 };
        }
        let (force, of_shape) = (later(self.force, phase.from), later(self.shape, phase.from));
        let deflection = self.bobbin.motion(t, phase.start, &[force], &[of_shape]);
        let surface = shape.value - deflection.value;
        let pressure = self.preload
            + self.bobbin.layer_stiffness * surface
            + self.bobbin.viscosity * (shape.rate - deflection.rate);
        Bounced { deflection, surface, pressure }
    }

    /// Returns the end of contact or flight, if it is before `last`; the function is positive while
    /// the phase lasts.
    fn end_of(&self, phase: &Phase, last: f64) -> Option<f64> {
        const STEP: f64 = 1e-4;
        let lasts = |time: f64| {
            let now = self.at(phase, time);
            let gap = now.surface - (self.shape.at(time).value - now.deflection.value);
            if phase.is_flight { gap } else { now.pressure }
        };
        // It starts at zero.
        let mut early = phase.from + STEP;
        while early < last {
            let mut late = early + STEP;
            if lasts(late) < 0.0 {
                for _ in 0..100 {
                    let middle = f64::midpoint(early, late);
                    if lasts(middle) < 0.0 { late = middle } else { early = middle }
                }
                return Some(late);
            }
            early = late;
        }
        None
    }
}

/// A phase of contact or of flight.
struct Phase {
    from: f64,
    is_flight: bool,
    start: Deflection,
    surface: f64,
}

/// Returns the harmonic with time counted from `time`.
fn later(harmonic: Harmonic, time: f64) -> Harmonic {
    Harmonic { phase: harmonic.phase + harmonic.frequency * time, ..harmonic }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed_form::winder::{BENCH_BOBBIN, BENCH_FORCE, BENCH_SHAPE};

    const BENCH: BouncingBobbin = BouncingBobbin {
        bobbin: BENCH_BOBBIN,
        preload: 40.0,
        force: BENCH_FORCE,
        shape: BENCH_SHAPE,
    };

    fn times() -> Vec<f64> {
        (0..4000).map(|step| 1e-4 * f64::from(step)).collect()
    }

    #[test]
    fn a_bobbin_pressed_hard_enough_stays_on_its_layer() {
        let hard = BouncingBobbin { preload: 200.0, ..BENCH };
        let (motion, switches) = hard.motion(&times());
        assert_eq!(switches, 0);
        let (start, time) = (Deflection::default(), 3999.0 * 1e-4);
        let exact = BENCH_BOBBIN.motion(time, start, &[BENCH_FORCE], &[BENCH_SHAPE]);
        assert_eq!(motion[3999].deflection, exact);
    }

    #[test]
    fn nothing_jumps_where_contact_ends_or_begins() {
        let (motion, switches) = BENCH.motion(&times());
        assert!(switches > 10, "{switches}");
        for pair in motion.windows(2) {
            let [before, after] = [&pair[0], &pair[1]];
            let mean = 0.5 * (before.deflection.rate + after.deflection.rate);
            let moved = after.deflection.value - before.deflection.value;
            assert!((moved - 1e-4 * mean).abs() < 2e-8, "{before:?} {after:?}");
            assert!((after.surface - before.surface).abs() < 1e-4);
            assert!(after.pressure >= -1e-9);
        }
    }
}

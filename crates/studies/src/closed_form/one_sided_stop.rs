//! Mass on a spring with an elastic stop on one side: sinusoids, joined at the times of contact and
//! separation.
//!
//! ```text
//! m x'' + k x + s max(x - d, 0) = 0
//! x = c + r cos(w t - a)     free: c = 0, w^2 = k/m; closed: c = s d/(k + s), w^2 = (k + s)/m
//! x = d where cos(w t - a) = (d - c)/r: on the way up before w t = a, down after it
//! ```
//!
//! Source: textbook.

use std::f64::consts::TAU;

/// Mass, spring and stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneSidedStop {
    /// m \[kg\], positive.
    pub mass: f64,
    /// k \[N/m\], positive.
    pub stiffness: f64,
    /// d \[m\], position of the stop.
    pub distance: f64,
    /// s \[N/m\], stiffness of the stop.
    pub stop: f64,
}

/// Motion at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stitched {
    /// Position \[m\].
    pub x: f64,
    /// Velocity \[m/s\].
    pub v: f64,
    /// Number of contacts and separations until then.
    pub switches: usize,
}

impl OneSidedStop {
    /// Returns the motion at time t \[s\] after release at `start` \[m\], in front of the stop.
    #[must_use]
    pub fn motion(&self, t: f64, start: f64) -> Stitched {
        let (mut x, mut v, mut left, mut switches) = (start, 0.0, t, 0);
        loop {
            let closed = switches % 2 == 1;
            let stop = if closed { self.stop } else { 0.0 };
            let stiffness = self.stiffness + stop;
            let centre = stop * self.distance / stiffness;
            let frequency = (stiffness / self.mass).sqrt();
            let (size, lag) =
                ((x - centre).hypot(v / frequency), (v / frequency).atan2(x - centre));
            let crossing = ((self.distance - centre) / size).acos();
            // On the way up at -crossing, on the way down at +crossing, after now.
            let phase = if closed { crossing } else { TAU - crossing };
            let until = (phase + lag).rem_euclid(TAU) / frequency;
            let is_last = crossing.is_nan() || left < until;
            let (sin, cos) = (frequency * if is_last { left } else { until } - lag).sin_cos();
            v = -size * frequency * sin;
            if is_last {
                return Stitched { x: centre + size * cos, v, switches };
            }
            (x, left, switches) = (self.distance, left - until, switches + 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::OneSidedStop;

    const STOP: OneSidedStop =
        OneSidedStop { mass: 1.0, stiffness: 400.0, distance: 0.005, stop: 1e4 };

    #[test]
    fn energy_stays_and_the_motion_repeats() {
        let energy = |t: f64| {
            let now = STOP.motion(t, -0.02);
            let compression = (now.x - 0.005).max(0.0);
            now.v * now.v / 2.0 + 200.0 * now.x * now.x + 5e3 * compression * compression
        };
        for step in 0..200 {
            let now = energy(0.01 * f64::from(step));
            assert!((now - 0.08).abs() < 1e-14, "{now} at {step}");
        }
    }

    #[test]
    fn a_stop_that_is_never_reached_changes_nothing() {
        let now = OneSidedStop { distance: 0.03, ..STOP }.motion(1.0, -0.02);
        assert!((now.x + 0.02 * 20.0_f64.cos()).abs() < 1e-15 && now.switches == 0);
    }

    #[test]
    fn a_stop_at_rest_is_met_half_the_time_of_each_oscillation() {
        let now = OneSidedStop { distance: 0.0, ..STOP }.motion(1.0, -0.02);
        let period = std::f64::consts::PI * (1.0 / 20.0 + 1.0 / 10_400.0_f64.sqrt());
        assert_eq!(now.switches, 2 * (1.0 / period).floor() as usize);
    }
}

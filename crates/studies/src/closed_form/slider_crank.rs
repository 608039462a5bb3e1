//! A slider-crank driven at constant speed: kinematics, and torque by virtual work.
//!
//! Crank r at the angle th from the line of the slider, and rod l at the angle b:
//!
//! ```text
//! l sin b = -r sin th          s = r cos th + l cos b
//! T = sum m a dr/dth + J b'' b' + sum m g dy/dth
//! ```
//!
//! with centres of mass in the middle of crank and rod. The slider does not rotate.
//!
//! Source: textbook; the derivation does not use multipliers.

/// Lengths, masses and the speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderCrank {
    /// r \[m\].
    pub crank: f64,
    /// l, above r \[m\].
    pub rod: f64,
    /// Mass of the crank \[kg\].
    pub crank_mass: f64,
    /// Mass of the rod \[kg\].
    pub rod_mass: f64,
    /// Moment of inertia of the rod about its centre of mass \[kg m^2\].
    pub rod_inertia: f64,
    /// Mass of the slider \[kg\].
    pub slider_mass: f64,
    /// g \[m/s^2\].
    pub gravity: f64,
    /// w, speed of the crank \[rad/s\].
    pub speed: f64,
}

/// Motion of the slider-crank at one angle of the crank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SliderCrankState {
    /// b \[rad\].
    pub rod_angle: f64,
    /// s \[m\].
    pub stroke: f64,
    /// s' \[m/s\].
    pub slider_speed: f64,
    /// s'' \[m/s^2\].
    pub slider_acceleration: f64,
    /// T on the crank \[N m\].
    pub torque: f64,
}

impl SliderCrank {
    /// Returns the motion where the crank is at `angle` \[rad\]; NaN if the rod is too short to
    /// reach.
    #[must_use]
    pub fn at(&self, angle: f64) -> SliderCrankState {
        let Self { crank: r, rod: l, gravity: g, speed: w, .. } = *self;
        let (sin, cos) = angle.sin_cos();
        let b = (-r * sin / l).asin();
        let (sin_b, cos_b) = b.sin_cos();
        // Derivatives with respect to the angle of the crank.
        let b_1 = -r * cos / (l * cos_b);
        let b_2 = (r * sin + l * sin_b * b_1 * b_1) / (l * cos_b);
        let along_1 = -sin_b * b_1;
        let along_2 = -cos_b * b_1 * b_1 - sin_b * b_2;
        let across_1 = cos_b * b_1;
        let across_2 = -sin_b * b_1 * b_1 + cos_b * b_2;
        let (s_1, s_2) = (-r * sin + l * along_1, -r * cos + l * along_2);
        let (x_1, x_2) = (-r * sin + 0.5 * l * along_1, -r * cos + 0.5 * l * along_2);
        let (y_1, y_2) = (r * cos + 0.5 * l * across_1, -r * sin + 0.5 * l * across_2);
        let inertial = self.rod_mass * (x_1 * x_2 + y_1 * y_2)
            + self.rod_inertia * b_1 * b_2
            + self.slider_mass * s_1 * s_2;
        let weight = g * (self.crank_mass * 0.5 * r * cos + self.rod_mass * y_1);
        SliderCrankState {
            rod_angle: b,
            stroke: r * cos + l * cos_b,
            slider_speed: w * s_1,
            slider_acceleration: w * w * s_2,
            torque: w * w * inertial + weight,
        }
    }
}

/// The machine of the scene `slider_crank`.
pub const SLIDER_CRANK: SliderCrank = SliderCrank {
    crank: 0.05,
    rod: 0.2,
    crank_mass: 0.8,
    rod_mass: 0.6,
    rod_inertia: 2e-3,
    slider_mass: 1.1,
    gravity: 9.81,
    speed: 30.0,
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slider_turns_round_at_the_dead_points() {
        for (angle, stroke) in [(0.0, 0.25), (std::f64::consts::PI, 0.15)] {
            let state = SLIDER_CRANK.at(angle);
            assert!((state.stroke - stroke).abs() < 1e-15);
            assert!(state.slider_speed.abs() < 1e-14);
        }
    }

    #[test]
    fn rates_are_differences_of_places() {
        for angle in [0.3, 2.0, 4.5] {
            let step = 1e-5;
            let [before, now, after] =
                [angle - step, angle, angle + step].map(|angle| SLIDER_CRANK.at(angle));
            let rate = 30.0 / (2.0 * step);
            let speed = rate * (after.stroke - before.stroke);
            assert!((speed - now.slider_speed).abs() < 1e-8);
            let acceleration = rate * (after.slider_speed - before.slider_speed);
            assert!((acceleration - now.slider_acceleration).abs() < 1e-6);
        }
    }

    #[test]
    fn the_torque_does_no_work_over_a_turn() {
        let turn = (0..720).map(|i| SLIDER_CRANK.at(f64::from(i) * std::f64::consts::TAU / 720.0));
        let work: f64 = turn.map(|state| state.torque).sum();
        assert!(work.abs() < 1e-9, "{work}");
    }
}

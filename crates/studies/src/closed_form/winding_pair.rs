//! Friction winding pair: growth of the package, adhesion, the range of pressures for stable
//! winding, and the mobility of its bobbin holder.
//!
//! A package of radius R, wound at constant thread speed, density and width, grows by the volume V'
//! per second: R^2 = Rmin^2 + V' t/(pi H).
//!
//! The drum, pressed on with N, drives the package by friction as long as
//!
//! ```text
//! N f R >= |Pn R + N fa r + N k + JA e|
//! ```
//!
//! with thread tension Pn, friction fa in supports of radius r, rolling friction k and angular
//! acceleration e; at steady speed Pn <= N (f - (fa r + k)/R). Practice also requires Pn <=
//! 0.9 N f. Vibration reduces the pressure by dN = B c~ (1 + delta) in the worst case (amplitude B,
//! dynamic stiffness c~ at the line of contact), so \[Nmin\] + dN <= N <= \[Nmax\] - dN, with
//! \[Nmin\] from both conditions and \[Nmax\] the largest pressure that the yarn withstands.
//!
//! Source: winder study, by hand.

use std::f64::consts::PI;

use super::winder::ReducedMass;

/// Largest share of N f for the thread tension in practice.
pub const DESIGN_SHARE: f64 = 0.9;

/// Friction between drum, package and support.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindingPair {
    /// f, coefficient between drum and package: 0.15 to 0.22.
    pub friction: f64,
    /// fa r, friction coefficient of the support times its radius \[m\]: 0.2e-3 to 0.6e-3.
    pub support_arm: f64,
    /// k, lever arm of rolling friction \[m\]: 0.2e-3 to 1e-3.
    pub rolling_arm: f64,
}

/// Range of pressures for stable winding \[N\]; empty if `least` exceeds `most`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureBand {
    /// \[Nmin\] + dN.
    pub least: f64,
    /// \[Nmax\] - dN.
    pub most: f64,
}

impl WindingPair {
    /// N f R - |Pn R + N fa r + N k + JA e| \[N m\]: adhesion holds if it is not negative. Tension
    /// Pn and pressure N are in N, radius R in m, inertia JA in kg m^2, and acceleration e in
    /// rad/s^2, negative when braking.
    #[must_use]
    pub fn adhesion_margin(
        &self,
        pressure: f64,
        tension: f64,
        radius: f64,
        inertia: f64,
        acceleration: f64,
    ) -> f64 {
        let resistance = pressure * (self.support_arm + self.rolling_arm);
        pressure * self.friction * radius
            - (tension * radius + resistance + inertia * acceleration).abs()
    }

    /// f - (fa r + k)/R: the tension that a pressure of 1 N can drive at steady speed, at a radius
    /// R \[m\].
    #[must_use]
    pub fn grip(&self, radius: f64) -> f64 {
        self.friction - (self.support_arm + self.rolling_arm) / radius
    }

    /// \[Nmin\], smallest pressure \[N\] that drives a package of radius R \[m\] at steady speed
    /// against tension Pn \[N\], by both conditions; infinite if f R does not exceed fa r + k.
    #[must_use]
    pub fn least_pressure(&self, tension: f64, radius: f64) -> f64 {
        let grip = self.grip(radius);
        if grip <= 0.0 {
            return f64::INFINITY;
        }
        tension / grip.min(DESIGN_SHARE * self.friction)
    }

    /// Returns the range for every radius between two \[m\], given \[Nmax\] and dN \[N\]. The
    /// smallest pressure falls as the package grows, so the smaller radius determines it.
    #[must_use]
    pub fn pressure_band(
        &self,
        tension: f64,
        radii: (f64, f64),
        most: f64,
        variation: f64,
    ) -> PressureBand {
        let least = self.least_pressure(tension, radii.0.min(radii.1));
        PressureBand { least: least + variation, most: most - variation }
    }
}

/// dN = B c~ (1 + delta) \[N\] for an amplitude B \[m\] and a dynamic stiffness c~ \[N/m\] known to
/// the share delta.
#[must_use]
pub fn pressure_variation(amplitude: f64, dynamic_stiffness: f64, spread: f64) -> f64 {
    amplitude * dynamic_stiffness * (1.0 + spread)
}

/// N(R) \[N\] of a bobbin that a spring presses onto its drum, equation (15) without thread; `rest`
/// is that of the empty bobbin. A package of radius R turns the lever by (R - Rmin)/h_N, which
/// stretches the spring on its arm h_F by h_F/h_N times as much. This adds c_p (R - Rmin) to the
/// pressure, with c_p = c_s (h_F/h_N)^2. For a bobbin above the drum, the weight of the package
/// adds to it.
#[must_use]
pub fn pressure_over_growth(rest: f64, spring: f64, mass: &ReducedMass, radius: f64) -> f64 {
    let weight = GRAVITY * (mass.as_printed(radius) - mass.as_printed(mass.bobbin_radius));
    rest + spring * (radius - mass.bobbin_radius) + weight
}

const GRAVITY: f64 = 9.81;

/// Radius \[m\] of a package after t \[s\]: sqrt(Rmin^2 + V' t/(pi H)), from Rmin \[m\], width H
/// \[m\] and volume V' of thread per second \[m^3/s\].
#[must_use]
pub fn package_radius(t: f64, least: f64, width: f64, volume_rate: f64) -> f64 {
    (least * least + volume_rate * t / (PI * width)).sqrt()
}

/// Angular speed \[rad/s\] of a package of radius R, w = w0 (R0/R) (1 - nu), driven by a drum of
/// radius R0 at w0 with slip nu.
#[must_use]
pub fn package_speed(drum_speed: f64, drum_radius: f64, radius: f64, slip: f64) -> f64 {
    drum_speed * drum_radius / radius * (1.0 - slip)
}

/// A position of the four-link bobbin holder, by its links and pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HolderPosition {
    /// Name of the operating state.
    pub name: &'static str,
    /// n, moving links.
    pub links: i32,
    /// p5, pairs with one degree of freedom (pivots, slides).
    pub lower_pairs: i32,
    /// p4, pairs with two degrees of freedom (contacts that roll and slide).
    pub higher_pairs: i32,
}

impl HolderPosition {
    /// Planar degrees of freedom by Gruebler's formula, W = 3 n - 2 p5 - p4.
    #[must_use]
    pub fn mobility(&self) -> i32 {
        3 * self.links - 2 * self.lower_pairs - self.higher_pairs
    }
}

/// The study's five positions of the holder.
pub const HOLDER_POSITIONS: [HolderPosition; 5] = [
    position("working, stable", 6, 7, 2),
    position("not winding, from working", 5, 6, 1),
    position("filling", 5, 6, 0),
    position("working, unstable", 6, 7, 1),
    position("not winding, from unstable", 5, 6, 0),
];

const fn position(
    name: &'static str,
    links: i32,
    lower_pairs: i32,
    higher_pairs: i32,
) -> HolderPosition {
    HolderPosition { name, links, lower_pairs, higher_pairs }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAIR: WindingPair =
        WindingPair { friction: 0.18, support_arm: 0.4e-3, rolling_arm: 0.6e-3 };

    #[test]
    fn adhesion_is_lost_at_the_least_pressure_and_held_above() {
        // At 20 mm, friction in the supports is decisive: f - 0.05 < 0.9 f.
        let (tension, radius) = (0.5, 0.02);
        let least = PAIR.least_pressure(tension, radius);
        assert!((least - 0.5 / 0.13).abs() < 1e-12);
        let margin = |pressure| PAIR.adhesion_margin(pressure, tension, radius, 0.0, 0.0);
        assert!(margin(least).abs() < 1e-15);
        assert!(margin(1.01 * least) > 0.0 && margin(0.99 * least) < 0.0);
    }

    #[test]
    fn a_large_package_is_held_by_the_rule_of_practice() {
        assert!((PAIR.least_pressure(0.5, 0.1) - 0.5 / 0.162).abs() < 1e-12);
    }

    #[test]
    fn acceleration_costs_adhesion_and_braking_beyond_resistance_too() {
        let margin = |e| PAIR.adhesion_margin(10.0, 0.5, 0.05, 1e-3, e);
        assert!(margin(50.0) < margin(0.0));
        // Pn R + N (fa r + k) = 0.035 N m: half of it is added, then subtracted again.
        assert!(margin(-35.0) > margin(0.0) && margin(-200.0) < margin(-35.0));
        assert!((margin(-35.0) - 0.09).abs() < 1e-15);
    }

    #[test]
    fn no_pressure_grips_a_package_that_friction_cannot_turn() {
        assert!(PAIR.least_pressure(0.5, 5e-3).is_infinite());
    }

    #[test]
    fn vibration_narrows_the_band_from_both_sides() {
        let variation = pressure_variation(1e-4, 42_000.0, 0.1);
        assert!((variation - 4.62).abs() < 1e-12);
        let band = PAIR.pressure_band(0.5, (0.02, 0.06), 25.0, variation);
        assert!((band.least - (0.5 / 0.13 + 4.62)).abs() < 1e-12);
        assert!((band.most - 20.38).abs() < 1e-12);
    }

    #[test]
    fn pressure_over_the_growth_of_a_package_is_the_balance_of_moments_about_the_lever() {
        use crate::closed_form::winder::BENCH_MASS;
        // Lever arms of spring and pressure, and the stiffness of the spring and its force at the
        // start.
        let (spring_arm, arm, spring, pull) = (0.06, 0.15, 23_750.0, 50.0);
        let at = |radius: f64| {
            let force = pull + spring * (radius - 0.03) * spring_arm / arm;
            let weights =
                9.81 * (1.5 + BENCH_MASS.as_printed(radius) - 2.1) * arm + 9.81 * 0.9 * 0.1;
            (force * spring_arm + weights) / arm
        };
        for radius in [0.03, 0.04, 0.06] {
            let ours = pressure_over_growth(at(0.03), 3800.0, &BENCH_MASS, radius);
            assert!((ours - at(radius)).abs() < 1e-12, "{ours}");
        }
    }

    #[test]
    fn a_turning_drum_speeds_up_and_slows_down_as_far_as_conditions_4_and_5_say() {
        // (4): P R >= Pn R + MA + Mk + JA e;  (5): P R >= JA e' - Pn R - MA - Mk, e' = -e.
        let (pressure, tension, radius, inertia) = (10.0, 0.5, 0.05, 1e-3);
        let resisting = tension * radius + pressure * 1e-3;
        let friction = pressure * 0.18 * radius;
        let faster = (friction - resisting) / inertia;
        let slower = -(friction + resisting) / inertia;
        let margin = |e: f64| PAIR.adhesion_margin(pressure, tension, radius, inertia, e);
        assert!(margin(faster).abs() < 1e-15 && margin(slower).abs() < 1e-15);
        assert!(margin(1.01 * faster) < 0.0 && margin(1.01 * slower) < 0.0);
        assert!(margin(0.99 * faster) > 0.0 && margin(0.99 * slower) > 0.0);
    }

    #[test]
    fn the_package_takes_up_the_thread_s_volume() {
        let (width, rate) = (0.15, 2e-8);
        let radius = package_radius(3600.0, 0.02, width, rate);
        let wound = PI * width * (radius * radius - 0.02 * 0.02);
        assert!((wound - 7.2e-5).abs() < 1e-18);
        assert!((package_speed(110.0, 0.05, 0.025, 0.04) - 211.2).abs() < 1e-12);
    }

    #[test]
    fn the_five_positions_have_the_mobility_of_the_study() {
        assert_eq!(HOLDER_POSITIONS.map(|position| position.mobility()), [2, 2, 3, 3, 3]);
    }
}

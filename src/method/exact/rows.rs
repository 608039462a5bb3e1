//! Functions that are affine in the state, with waves of time: rates and guards, their derivatives
//! along the motion, and rates along switching surfaces.

use nalgebra::{Complex, DMatrix};

use crate::method::sliding::{Order, Slide};

/// A wave (t - origin)^power e^(mu (t - origin)).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Kind {
    /// Origin of time \[s\].
    pub(super) origin: f64,
    pub(super) power: u32,
    pub(super) mu: Complex<f64>,
}

impl Kind {
    /// Returns whether the wave is constant.
    fn is_constant(&self) -> bool {
        self.power == 0 && self.mu == Complex::ZERO
    }
}

/// `sum of slope y_i + sum of Re(amplitude wave)`.
#[derive(Debug, Clone, Default)]
pub(super) struct Row {
    /// Slopes by entries of the state, each once.
    pub(super) slopes: Vec<(usize, f64)>,
    /// Amplitudes of waves, each kind once.
    pub(super) waves: Vec<(Kind, Complex<f64>)>,
}

impl Row {
    /// Adds a slope by an entry of the state.
    pub(super) fn add_slope(&mut self, entry: usize, slope: f64) {
        match self.slopes.iter_mut().find(|(known, _)| *known == entry) {
            Some((_, known)) => *known += slope,
            None => self.slopes.push((entry, slope)),
        }
    }

    /// Adds a wave.
    pub(super) fn add_wave(&mut self, kind: Kind, amplitude: Complex<f64>) {
        match self.waves.iter_mut().find(|(known, _)| *known == kind) {
            Some((_, known)) => *known += amplitude,
            None => self.waves.push((kind, amplitude)),
        }
    }

    /// Adds a multiple of another row.
    fn add(&mut self, other: &Row, factor: f64) {
        for (entry, slope) in &other.slopes {
            self.add_slope(*entry, factor * slope);
        }
        for (kind, amplitude) in &other.waves {
            self.add_wave(*kind, amplitude * factor);
        }
    }

    /// Returns the derivative by time along a motion with these rates.
    pub(super) fn along(&self, rates: &[Row]) -> Row {
        let mut derivative = Row::default();
        for (entry, slope) in &self.slopes {
            derivative.add(&rates[*entry], *slope);
        }
        for (kind, amplitude) in &self.waves {
            if kind.mu != Complex::ZERO {
                derivative.add_wave(*kind, amplitude * kind.mu);
            }
            if kind.power > 0 {
                let lower = Kind { power: kind.power - 1, ..*kind };
                derivative.add_wave(lower, amplitude * f64::from(kind.power));
            }
        }
        derivative
    }

    /// Returns the change by a step of the state.
    fn change(&self, step: &[f64]) -> f64 {
        self.slopes.iter().map(|(entry, slope)| slope * step[*entry]).sum()
    }

    /// Returns the value of a row that another one exceeds by a constant; `None` if the difference
    /// is none.
    fn constant_above(&self, below: &Row) -> Option<f64> {
        /// Roundings of a coefficient that differ between branches.
        const ROUNDINGS: f64 = 16.0;
        let mut difference = self.clone();
        difference.add(below, -1.0);
        let size = |row: &Row, entry: usize| {
            let found = row.slopes.iter().find(|(known, _)| *known == entry);
            found.map_or(0.0, |(_, slope)| slope.abs())
        };
        let is_flat = difference.slopes.iter().all(|(entry, slope)| {
            slope.abs() <= ROUNDINGS * f64::EPSILON * size(self, *entry).max(size(below, *entry))
        });
        let mut constant = 0.0;
        for (kind, amplitude) in &difference.waves {
            if kind.is_constant() {
                constant += amplitude.re;
                continue;
            }
            let of = |row: &Row| {
                let found = row.waves.iter().find(|(known, _)| known == kind);
                found.map_or(0.0, |(_, amplitude)| amplitude.norm())
            };
            if amplitude.norm() > ROUNDINGS * f64::EPSILON * of(self).max(of(below)) {
                return None;
            }
        }
        is_flat.then_some(constant)
    }
}

/// A motion along switching surfaces.
pub(super) struct Along {
    /// Rates of the states.
    pub(super) rates: Vec<Row>,
    /// Shares of the rates above.
    pub(super) shares: Vec<Row>,
}

/// Returns the motion along surfaces, from the rates below all of them, those above each, and
/// guards; `None` if it is not linear:
///
/// ```text
/// y' = f + B alpha,    alpha = -K^-1 (dr/dt along f),    K = R B
/// ```
///
/// where B holds the jumps of the rate, which must be constant, and R the slopes of r: the guards
/// (order 1) or their rates (order 2).
pub(super) fn along_surfaces(
    slides: &[Slide],
    below: Vec<Row>,
    above: &[Vec<Row>],
    guards: &[Row],
) -> Option<Along> {
    let jumps: Option<Vec<Vec<f64>>> = above
        .iter()
        .map(|above| above.iter().zip(&below).map(|(a, b)| a.constant_above(b)).collect())
        .collect();
    let jumps = jumps?;
    let held: Vec<Row> = slides
        .iter()
        .map(|slide| match slide.order {
            Order::First => guards[slide.relation].clone(),
            Order::Second => guards[slide.relation].along(&below),
        })
        .collect();
    let count = slides.len();
    let jump = DMatrix::from_fn(count, count, |row, column| held[row].change(&jumps[column]));
    let inverse = jump.try_inverse()?;
    let slopes: Vec<Row> = held.iter().map(|row| row.along(&below)).collect();
    let shares: Vec<Row> = (0..count)
        .map(|index| {
            let mut share = Row::default();
            for (column, slope) in slopes.iter().enumerate() {
                share.add(slope, -inverse[(index, column)]);
            }
            share
        })
        .collect();
    let mut rates = below;
    for (share, jump) in shares.iter().zip(&jumps) {
        for (rate, jump) in rates.iter_mut().zip(jump) {
            if *jump != 0.0 {
                rate.add(share, *jump);
            }
        }
    }
    Some(Along { rates, shares })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::sliding::{BELOW, Sides};

    const CONSTANT: Kind = Kind { origin: 0.0, power: 0, mu: Complex::ZERO };

    fn slide() -> Slide {
        Slide { relation: 0, sides: Sides::above_slot(BELOW), order: Order::First }
    }

    fn row(slopes: &[(usize, f64)], constant: f64) -> Row {
        let waves = vec![(CONSTANT, Complex::from(constant))];
        Row { slopes: slopes.to_vec(), waves }
    }

    /// x'' = -w^2 x - r sign(x' - u): while the mass sticks to the belt, x'' = 0 and the share
    /// above follows from the spring's force.
    #[test]
    fn a_mass_that_sticks_to_a_belt_moves_with_it() {
        let (stiffness, friction, speed) = (9.0, 2.0, 0.5);
        let rates =
            |side: f64| vec![row(&[(1, 1.0)], 0.0), row(&[(0, -stiffness)], -side * friction)];
        let guard = row(&[(1, 1.0)], -speed);
        let slide = slide();
        let along = along_surfaces(&[slide], rates(-1.0), &[rates(1.0)], &[guard]).expect("linear");
        let value = |row: &Row, state: [f64; 2]| {
            row.change(&state) + row.waves.iter().map(|(_, amplitude)| amplitude.re).sum::<f64>()
        };
        for x in [-0.1, 0.0, 0.2] {
            let state = [x, speed];
            assert!(value(&along.rates[1], state).abs() < 1e-15);
            let expected = 0.5 * (1.0 - stiffness * x / friction);
            assert!((value(&along.shares[0], state) - expected).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn a_jump_that_depends_on_the_state_makes_the_motion_nonlinear() {
        let below = vec![row(&[(0, -1.0)], 0.0)];
        let above = vec![row(&[(0, -2.0)], -1.0)];
        let slide = slide();
        assert!(along_surfaces(&[slide], below, &[above], &[row(&[(0, 1.0)], 0.0)]).is_none());
    }

    #[test]
    fn rows_are_differentiated_along_waves() {
        let mu = Complex::new(-0.5, 3.0);
        let kind = Kind { origin: 0.2, power: 2, mu };
        let row = Row { slopes: vec![], waves: vec![(kind, Complex::new(1.0, 0.4))] };
        let value = |row: &Row, t: f64| {
            let wave = |(kind, amplitude): &(Kind, Complex<f64>)| {
                let s = t - kind.origin;
                (amplitude * (kind.mu * s).exp() * s.powi(kind.power as i32)).re
            };
            row.waves.iter().map(wave).sum::<f64>()
        };
        let slope = (value(&row, 0.9 + 1e-5) - value(&row, 0.9 - 1e-5)) / 2e-5;
        assert!((value(&row.along(&[]), 0.9) - slope).abs() < 1e-8);
    }
}

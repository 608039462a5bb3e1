//! Check of the waves of a piece against the excitation of the machine, and correction.
//!
//! Polynomials are given by their coefficients of powers of t. Late in a run these cancel: in
//! `((t - 30)/0.01)^5` they are larger than 1e17. The waves are therefore compared with the rate of
//! the machine at rest, b(t) = f(t, 0), at times within the piece. Where they differ, the
//! polynomials are determined from b itself, in powers of the time since the start of the piece.

use nalgebra::{Complex, DMatrix, DVector};

use super::{Piece, Wave};
use crate::method::Stretch;

/// Deviation from b, relative to its largest value over a piece, that counts as rounding.
const ROUNDING: f64 = 1e-13;

impl Piece {
    /// Compares the waves with the rate, and corrects polynomials.
    ///
    /// # Errors
    /// The reason if the tolerance cannot be met.
    pub(super) fn judge(&mut self, stretch: &Stretch<'_>) -> Result<(), String> {
        if self.waves.iter().all(|wave| wave.power == 0) {
            return Ok(());
        }
        let highest = self.waves.iter().map(|wave| wave.power).max().unwrap_or(0) as usize;
        let times = self.nodes(2 * highest + 3);
        let rates = self.rates(stretch, &times);
        if self.misses(&times, &rates) <= ROUNDING {
            return Ok(());
        }
        self.take_polynomials_anew(stretch);
        let missed = self.misses(&times, &rates);
        // Deviations far below the tolerance are harmless.
        if missed <= (1e-2 * stretch.rtol).max(ROUNDING) {
            return Ok(());
        }
        Err(format!(
            "its excitation from {} s to {} s is known in closed form only to {missed:.0e}; try \
             the method `auto`",
            self.from, self.until
        ))
    }

    /// Returns times inside the piece, at Chebyshev nodes.
    fn nodes(&self, count: usize) -> Vec<f64> {
        let node = |index: usize| {
            let angle = std::f64::consts::PI * (index as f64 + 0.5) / count as f64;
            self.from + self.span() * (0.5 - 0.5 * angle.cos())
        };
        (0..count).map(node).collect()
    }

    /// Returns b at each time.
    fn rates(&self, stretch: &Stretch<'_>, times: &[f64]) -> Vec<Vec<f64>> {
        let rate = |time: &f64| {
            let mut rate = vec![0.0; self.states];
            stretch.system.rate_of_modes(stretch.within(*time), &self.rest, &mut rate);
            rate
        };
        times.iter().map(rate).collect()
    }

    /// Returns the deviation of the waves from b, relative to the largest value of each of its
    /// entries.
    fn misses(&self, times: &[f64], rates: &[Vec<f64>]) -> f64 {
        let mut largest = vec![0.0_f64; self.states];
        let mut missed = vec![0.0_f64; self.states];
        for (time, rate) in times.iter().zip(rates) {
            let mut rest = rate.clone();
            for wave in &self.waves {
                wave.subtract(*time, &mut rest);
            }
            for (entry, rest) in rest.iter().enumerate() {
                largest[entry] = largest[entry].max(rate[entry].abs());
                missed[entry] = missed[entry].max(rest.abs());
            }
        }
        let share = |(missed, largest): (&f64, &f64)| {
            if *missed == 0.0 { 0.0 } else { missed / largest }
        };
        // `max` alone would ignore NaN.
        missed.iter().zip(&largest).map(share).fold(0.0, |most: f64, share| {
            if share.is_nan() { f64::INFINITY } else { most.max(share) }
        })
    }

    /// Replaces polynomials by interpolation of b minus the other waves.
    fn take_polynomials_anew(&mut self, stretch: &Stretch<'_>) {
        let is_polynomial = |wave: &Wave| wave.mu == Complex::ZERO;
        let (polynomials, others): (Vec<Wave>, Vec<Wave>) =
            std::mem::take(&mut self.waves).into_iter().partition(is_polynomial);
        self.waves = others;
        let Some(degree) = polynomials.iter().map(|wave| wave.power as usize).max() else { return };
        let times = self.nodes(degree + 1);
        let mut rates = self.rates(stretch, &times);
        for (time, rate) in times.iter().zip(&mut rates) {
            for wave in &self.waves {
                wave.subtract(*time, rate);
            }
        }
        let span = self.span();
        let powers = DMatrix::from_fn(degree + 1, degree + 1, |row, power| {
            ((times[row] - self.from) / span).powi(power as i32)
        });
        let powers = powers.lu();
        let mut entries: Vec<usize> =
            polynomials.iter().flat_map(|wave| &wave.amplitudes).map(|(entry, _)| *entry).collect();
        entries.sort_unstable();
        entries.dedup();
        let mut amplitudes = vec![Vec::new(); degree + 1];
        for entry in entries {
            let values = DVector::from_iterator(times.len(), rates.iter().map(|rate| rate[entry]));
            let Some(coefficients) = powers.solve(&values) else { continue };
            for (power, coefficient) in coefficients.iter().enumerate() {
                let amplitude = Complex::from(coefficient / span.powi(power as i32));
                amplitudes[power].push((entry, amplitude));
            }
        }
        let origin = self.from;
        self.waves.extend(amplitudes.into_iter().enumerate().map(|(power, amplitudes)| Wave {
            origin,
            power: power as u32,
            mu: Complex::ZERO,
            amplitudes,
        }));
    }
}

impl Wave {
    /// Subtracts the wave at a time from b.
    fn subtract(&self, time: f64, rate: &mut [f64]) {
        let since = time - self.origin;
        let value = (self.mu * since).exp() * since.powi(self.power as i32);
        for (entry, amplitude) in &self.amplitudes {
            rate[*entry] -= (amplitude * value).re;
        }
    }
}

//! Largest frequency response within a range: a resonance may lie between two frequencies of a
//! table.

use std::f64::consts::TAU;

use num_complex::Complex64;
use serde::Serialize;

use super::response::Transfer;
use super::{LinearError, Linearization, Mode, ModeKind, Response};
use crate::sorting::sort_ascending;

/// Damping ratio below which damping is rounding.
const UNDAMPED: f64 = 1e-9;

/// Maximum of a frequency response.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Largest {
    /// Frequency \[rad/s\].
    pub frequency: f64,
    /// |H|; infinite at an undamped resonance.
    pub amplitude: f64,
    /// arg H \[rad\], continuous with the phase of the response; NaN where |H| is infinite.
    pub phase: f64,
}

impl Linearization<'_> {
    /// Returns the largest |H| between the lowest and the highest frequency of a response. It may
    /// be greater than at any of its frequencies.
    ///
    /// H is also evaluated at the resonances of eigenvalues -d +- j w: at w, and at sqrt(w^2 - d^2)
    /// for a single oscillator. Between the neighbours of the largest points the maximum is found
    /// by golden section search.
    ///
    /// # Errors
    /// As for [`Linearization::response`] and [`Linearization::modes`].
    pub fn largest(
        &self,
        from: &str,
        to: &str,
        response: &Response,
    ) -> Result<Option<Largest>, LinearError> {
        let transfer = self.transfer_of(from, to)?;
        let known = response.frequencies.iter().zip(&response.amplitudes);
        let mut points: Vec<(f64, f64)> = known.map(|(at, size)| (*at, *size)).collect();
        sort_ascending(&mut points, |(at, _)| *at);
        let [Some((low, _)), Some((high, _))] = [points.first(), points.last()] else {
            return Ok(None);
        };
        let (low, high) = (*low, *high);
        for mode in self.modes()?.iter().filter(|mode| mode.kind == ModeKind::Oscillation) {
            for frequency in resonances(mode).filter(|at| low < *at && *at < high) {
                if mode.damping_ratio().abs() <= UNDAMPED
                    && grows_without_bound(&transfer, frequency)
                {
                    let (amplitude, phase) = (f64::INFINITY, f64::NAN);
                    return Ok(Some(Largest { frequency, amplitude, phase }));
                }
                // H may not exist at an undamped resonance that is not excited.
                if let Ok(answer) = transfer.at(frequency) {
                    points.push((frequency, answer.norm()));
                }
            }
        }
        sort_ascending(&mut points, |(at, _)| *at);
        let frequency = greatest(&transfer, &points);
        let answer = transfer.at(frequency)?;
        let phase = continued(answer, frequency, response);
        Ok(Some(Largest { frequency, amplitude: answer.norm(), phase }))
    }
}

impl Response {
    /// Inserts a maximum into the table of frequencies, unless it is infinite.
    pub fn add(&mut self, largest: &Largest) {
        let place = self.frequencies.partition_point(|at| *at < largest.frequency);
        let is_known = self.frequencies.get(place) == Some(&largest.frequency);
        if largest.amplitude.is_finite() && !is_known {
            self.frequencies.insert(place, largest.frequency);
            self.amplitudes.insert(place, largest.amplitude);
            self.phases.insert(place, largest.phase);
        }
    }
}

/// Returns the frequencies at which an oscillation may resonate: that of its damped motion, and
/// that of a single oscillator under a harmonic force.
fn resonances(mode: &Mode) -> impl Iterator<Item = f64> {
    let of_force = (mode.imaginary.powi(2) - mode.real.powi(2)).sqrt();
    [mode.imaginary, of_force].into_iter().filter(|at| at.is_finite() && *at > 0.0)
}

/// Returns whether the response grows with the inverse distance from an undamped resonance.
fn grows_without_bound(transfer: &Transfer, frequency: f64) -> bool {
    let [near, nearer] = [1e-5, 1e-6]
        .map(|share| transfer.at(frequency * (1.0 + share)).map_or(f64::NAN, Complex64::norm));
    nearer > 5.0 * near
}

/// Returns the frequency of the largest response, given points in the order of frequency.
fn greatest(transfer: &Transfer, points: &[(f64, f64)]) -> f64 {
    /// Ratio to the largest point above which other points may be near a greater maximum.
    const NEARLY: f64 = 0.7;
    /// Maximum number of such points.
    const MOST: usize = 6;
    let size = |place: usize| points.get(place).map_or(0.0, |(_, size)| *size);
    let largest = points.iter().fold(0.0_f64, |most, (_, size)| most.max(*size));
    let is_top = |place: &usize| {
        let beside = size(place.wrapping_sub(1)).max(size(place + 1));
        size(*place) >= beside && size(*place) >= NEARLY * largest
    };
    let mut tops: Vec<usize> = (0..points.len()).filter(is_top).collect();
    sort_ascending(&mut tops, |place| -size(*place));
    let mut best = tops.first().map_or((f64::NAN, 0.0), |place| points[*place]);
    for place in tops.into_iter().take(MOST) {
        let (from, to) = (place.saturating_sub(1), (place + 1).min(points.len() - 1));
        let found = maximum(transfer, points[from].0, points[to].0);
        if found.1 > best.1 {
            best = found;
        }
    }
    best.0
}

/// Finds the maximum of the response between two frequencies by golden section search.
fn maximum(transfer: &Transfer, mut low: f64, mut high: f64) -> (f64, f64) {
    const SHARE: f64 = 0.618_033_988_749_894_9;
    /// Relative distance below which amplitudes differ only by rounding.
    const CLOSE: f64 = 1e-9;
    let at = |frequency: f64| (frequency, transfer.at(frequency).map_or(0.0, Complex64::norm));
    let mut inner = [at(high - SHARE * (high - low)), at(low + SHARE * (high - low))];
    while high - low > CLOSE * high {
        if inner[0].1 >= inner[1].1 {
            high = inner[1].0;
            inner = [at(high - SHARE * (high - low)), inner[0]];
        } else {
            low = inner[0].0;
            inner = [inner[1], at(low + SHARE * (high - low))];
        }
    }
    if inner[0].1 >= inner[1].1 { inner[0] } else { inner[1] }
}

/// Returns arg H, shifted by whole turns to be closest to that at the nearest frequency of a
/// response.
fn continued(answer: Complex64, frequency: f64, response: &Response) -> f64 {
    let known = response.frequencies.iter().zip(&response.phases);
    let apart = |at: f64| (at - frequency).abs();
    let nearest = known.min_by(|a, b| apart(*a.0).total_cmp(&apart(*b.0)));
    let near = nearest.map_or(0.0, |(_, phase)| *phase);
    let phase = answer.arg();
    phase + ((near - phase) / TAU).round() * TAU
}

//! Harmonic balance of the bobbin on a stiffening layer: its steady motion without integration.
//!
//! ```text
//! m x'' + h (x' - Y') + c_p x - c d - c3 d^3 = F,   d = Y - x
//! x = a_0 + sum_k a_k cos(k p t) + b_k sin(k p t)
//! ```
//!
//! where F and Y are harmonics of p too. The coefficients make the first 2 K + 1 components of the
//! residual's Fourier sum over [`SAMPLES`] equally spaced times vanish, by Newton's method. The
//! error decreases faster than any power of K.
//!
//! Source: textbook (alternating frequency and time domains).

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use crate::closed_form::winder::{BobbinOscillator, Harmonic};

/// K, number of harmonics of the drum's rotation.
pub const HARMONICS: usize = 16;
/// Number of times within a turn.
pub const SAMPLES: usize = 96;
const ITERATIONS: usize = 60;

/// Returns steady deflections \[m\] at [`SAMPLES`] equally spaced times over a turn 2 pi/p, under a
/// force and a shape whose frequencies are multiples of p \[rad/s\]; `None` if Newton's method
/// fails.
#[must_use]
pub fn steady(
    bobbin: &BobbinOscillator,
    cubic_stiffness: f64,
    turning: f64,
    (force, shape): (&Harmonic, &Harmonic),
) -> Option<Vec<f64>> {
    let times = (0..SAMPLES).map(|k| TAU / turning * k as f64 / SAMPLES as f64);
    let times: Vec<f64> = times.collect();
    let waves = waves(turning, &times);
    let impedance = impedance(bobbin, turning);
    let count = impedance.nrows();
    // Matrix from samples to coefficients.
    let mut analysis = waves.transpose() * (2.0 / SAMPLES as f64);
    analysis.row_mut(0).scale_mut(0.5);
    let shapes = DVector::from_fn(SAMPLES, |k, _| shape.at(times[k]).value);
    let driving = DVector::from_fn(SAMPLES, |k, _| {
        let moved = shape.at(times[k]);
        force.at(times[k]).value + bobbin.viscosity * moved.rate
    });
    let driving = &analysis * driving;
    let mut coefficients = DVector::zeros(count);
    for _ in 0..ITERATIONS {
        let compressions = &shapes - &waves * &coefficients;
        let pushes = compressions.map(|d| bobbin.layer_stiffness * d + cubic_stiffness * d * d * d);
        let slopes = compressions.map(|d| bobbin.layer_stiffness + 3.0 * cubic_stiffness * d * d);
        let residual = &impedance * &coefficients - &analysis * pushes - &driving;
        let bent =
            DMatrix::from_fn(SAMPLES, count, |row, column| slopes[row] * waves[(row, column)]);
        let change = (&impedance + &analysis * bent).lu().solve(&residual)?;
        coefficients -= &change;
        if change.amax() <= 1e-15 * coefficients.amax() {
            break;
        }
    }
    let samples = waves * coefficients;
    samples.iter().all(|value| value.is_finite()).then(|| samples.as_slice().to_vec())
}

/// Returns 1, cos p t, sin p t, cos 2 p t, ... at each time.
fn waves(turning: f64, times: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(times.len(), 2 * HARMONICS + 1, |row, column| {
        let angle = column.div_ceil(2) as f64 * turning * times[row];
        if column % 2 == 0 && column > 0 { angle.sin() } else { angle.cos() }
    })
}

/// Returns c_p - m w^2 of each wave, and h w between the two of one frequency.
fn impedance(bobbin: &BobbinOscillator, turning: f64) -> DMatrix<f64> {
    let count = 2 * HARMONICS + 1;
    let mut matrix = DMatrix::zeros(count, count);
    for column in 0..count {
        let frequency = column.div_ceil(2) as f64 * turning;
        matrix[(column, column)] = bobbin.spring_stiffness - bobbin.mass * frequency * frequency;
        if column > 0 {
            // (cos)' = -w sin, (sin)' = w cos.
            let is_sine = column % 2 == 0;
            let other = if is_sine { column - 1 } else { column + 1 };
            let sign = if is_sine { 1.0 } else { -1.0 };
            matrix[(other, column)] = sign * bobbin.viscosity * frequency;
        }
    }
    matrix
}

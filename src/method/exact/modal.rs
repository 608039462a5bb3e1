//! Solution by eigenmodes: M q'' + D q' + K q = f(t) with symmetric K and D that have the
//! eigenmodes of K in common, as without damping or with Rayleigh damping.

use nalgebra::{Complex, DMatrix};

use super::Solution;
use super::forms::{Forms, Modes};
use super::piece::Piece;
use super::response::responses;
use crate::method::Stretch;

/// Product of eigenvalue distance and span below which two eigenvalues count as equal in the response
/// to the excitation. The neglected term is of its square; the avoided loss of accuracy is of its
/// inverse.
const EQUAL: f64 = 1e-5;
/// Relative distance below which two unequal eigenvalues cost too many digits.
const CLOSE: f64 = 1e-3;

/// All eigenmodes of a piece with their initial values.
pub(super) struct Modal<'a> {
    piece: &'a Piece,
    /// Eigenmodes as columns, normalized by mass.
    shapes: DMatrix<f64>,
    modes: Vec<Mode>,
    /// Each wave in local time; see [`Piece::local`].
    locals: Vec<Vec<Complex<f64>>>,
}

/// Equation x'' + d x' + k x = f with its two eigenvalues.
struct Mode {
    eigenvalues: [Complex<f64>; 2],
    is_double: bool,
    /// Initial values of x and x'.
    start: [f64; 2],
    /// Amplitude of each wave on this eigenmode.
    amplitudes: Vec<Complex<f64>>,
}

impl<'a> Modal<'a> {
    /// Returns `None` if the machine has no such eigenmodes, or not to the last digits.
    ///
    /// # Errors
    /// The reason if they would not meet the tolerance.
    pub(super) fn new(
        piece: &'a Piece,
        stretch: &Stretch<'_>,
        state: &[f64],
    ) -> Result<Option<Self>, String> {
        let Some(forms) = Forms::of(piece, stretch) else { return Ok(None) };
        let Some(modes) = forms.modes(stretch.rtol) else { return Ok(None) };
        if modes.mixing > stretch.rtol {
            return Err(format!(
                "its eigenmodes are so close that rounding mixes them by {:.0e}, more than the \
                 tolerance; try the method `auto`",
                modes.mixing
            ));
        }
        Ok(Self::of(piece, &forms, modes, state))
    }

    /// Returns `None` if eigenvalues are too close to be distinguished without loss.
    fn of(piece: &'a Piece, forms: &Forms, modes: Modes, state: &[f64]) -> Option<Self> {
        let n = forms.mass.len();
        let Modes { stiffnesses, dampings, shapes, .. } = modes;
        let [position, velocity] = [&state[..n], &state[n..]].map(|vector| {
            let is_moved = vector.iter().any(|value| *value != 0.0);
            is_moved.then(|| shapes.tr_mul(&forms.mass.times(vector)))
        });
        let mut modes = Vec::with_capacity(n);
        for index in 0..n {
            let (eigenvalues, is_double) =
                eigenvalues(stiffnesses[index], dampings[index], piece.span())?;
            // f acts on accelerations as M^-1 f, so f is M times that.
            let shape = shapes.column(index);
            let force = |(entry, amplitude): &(usize, Complex<f64>)| {
                amplitude * forms.mass.row_times(entry - n, shape.as_slice())
            };
            let amplitudes =
                piece.waves.iter().map(|wave| wave.amplitudes.iter().map(force).sum()).collect();
            let start = [&position, &velocity];
            let start = start.map(|vector| vector.as_ref().map_or(0.0, |vector| vector[index]));
            modes.push(Mode { eigenvalues, is_double, start, amplitudes });
        }
        let locals = piece.waves.iter().map(|wave| piece.local(wave)).collect();
        Some(Modal { piece, shapes, modes, locals })
    }

    /// Returns the number of eigenmodes.
    pub(super) fn modes(&self) -> usize {
        self.modes.len()
    }
}

impl Solution for Modal<'_> {
    fn state_at(&mut self, time: f64, state: &mut [f64]) {
        let h = time - self.piece.from;
        let n = self.modes.len();
        let mut moved = DMatrix::zeros(n, 2);
        for (index, mode) in self.modes.iter().enumerate() {
            let [mut position, mut velocity] = mode.free(h);
            for ((wave, local), amplitude) in
                self.piece.waves.iter().zip(&self.locals).zip(&mode.amplitudes)
            {
                if *amplitude == Complex::ZERO {
                    continue;
                }
                let forced = mode.forced(wave.mu, h, local);
                position += (amplitude * forced[0]).re;
                velocity += (amplitude * forced[1]).re;
            }
            moved[(index, 0)] = position;
            moved[(index, 1)] = velocity;
        }
        state.copy_from_slice((&self.shapes * moved).as_slice());
    }

    // Each state is computed from the start.
    fn settle(&mut self, _time: f64, _state: &[f64]) {}
}

impl Mode {
    /// Returns x and x' at h after the start, without excitation.
    fn free(&self, h: f64) -> [f64; 2] {
        let [a, b] = self.eigenvalues;
        let [x, v] = self.start;
        let distance = a - b;
        // x = x_0 c + v_0 s, with s the response to an impulse and c = s' - (a + b) s.
        let (c, s, s_dot) = if distance.norm() * h <= 2.0 {
            // This form has no cancellation, however short the time.
            let (middle, half) = (0.5 * (a + b), 0.5 * distance * h);
            let of_middle = (middle * h).exp();
            let s = if half == Complex::ZERO { Complex::from(h) } else { half.sinh() / half * h };
            let (even, odd) = (half.cosh(), middle * s);
            (of_middle * (even - odd), of_middle * s, of_middle * (even + odd))
        } else {
            // Nor has this one, where one eigenvalue is far larger.
            let (of_a, of_b) = ((a * h).exp(), (b * h).exp());
            (
                (a * of_b - b * of_a) / distance,
                (of_a - of_b) / distance,
                (a * of_a - b * of_b) / distance,
            )
        };
        let c_dot = -(a * b) * s;
        [(c * x + s * v).re, (c_dot * x + s_dot * v).re]
    }

    /// Returns x and x' at h after rest, excited by `sum_j local_j s^j e^(mu s)`.
    fn forced(&self, mu: Complex<f64>, h: f64, local: &[Complex<f64>]) -> [Complex<f64>; 2] {
        let [a, b] = self.eigenvalues;
        let highest = local.len() as u32 - 1;
        let sum = |parts: &mut dyn Iterator<Item = Complex<f64>>| {
            local.iter().zip(parts).map(|(local, part)| local * part).sum::<Complex<f64>>()
        };
        if self.is_double {
            // The impulse response is (h - s) e^(a (h - s)).
            let a = 0.5 * (a + b);
            let of = responses(a, mu, h, highest + 1);
            let once = sum(&mut of.iter().copied());
            let twice = sum(&mut of.windows(2).map(|pair| pair[0] * h - pair[1]));
            return [twice, once + a * twice];
        }
        let [of_a, of_b] = [a, b].map(|eigenvalue| responses(eigenvalue, mu, h, highest));
        let [of_a, of_b] = [of_a, of_b].map(|of| sum(&mut of.iter().copied()));
        let distance = a - b;
        [(of_a - of_b) / distance, (a * of_a - b * of_b) / distance]
    }
}

/// Returns the roots of l^2 + d l + k, and whether they count as equal for the excitation; `None` if
/// they are too close to be distinguished without loss.
fn eigenvalues(stiffness: f64, damping: f64, span: f64) -> Option<([Complex<f64>; 2], bool)> {
    let middle = -0.5 * damping;
    let distance = Complex::new(0.25 * damping * damping - stiffness, 0.0).sqrt();
    let size = stiffness.abs().sqrt().max(damping.abs());
    let is_double = distance.norm() * span <= EQUAL
        && (size * span <= EQUAL || distance.norm() <= EQUAL * size);
    if !is_double && distance.norm() <= CLOSE * size {
        return None;
    }
    if distance.im != 0.0 || damping == 0.0 {
        return Some(([middle + distance, middle - distance], is_double));
    }
    // For real roots the smaller one follows by Vieta, without cancellation.
    let large = middle - distance.re.copysign(damping);
    let small = stiffness / large;
    Some(([Complex::new(small, 0.0), Complex::new(large, 0.0)], is_double))
}

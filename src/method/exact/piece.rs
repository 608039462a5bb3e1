//! A piece of a run without switches: A and the waves that excite the machine.

mod excitation;

use machinist_contract::linear::{LinearEquations, TERM_NUMBERS};
use nalgebra::{Complex, DMatrix};

use crate::method::{Stretch, cut};

/// A linear machine between two switches.
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) until: f64,
    /// Nonzeros of A, `states` by `states`.
    pub(super) entries: Vec<(usize, usize, f64)>,
    states: usize,
    /// Waves, each kind once.
    pub(super) waves: Vec<Wave>,
}

/// (t - origin)^power e^(mu (t - origin)) with its amplitudes.
pub(super) struct Wave {
    /// Origin of time: 0, or the start of the piece \[s\].
    origin: f64,
    pub(super) power: u32,
    pub(super) mu: Complex<f64>,
    /// Entries of the state with complex amplitudes; the real part acts.
    pub(super) amplitudes: Vec<(usize, Complex<f64>)>,
}

impl Piece {
    /// # Errors
    /// The reason if its waves are not the excitation of the machine.
    pub(super) fn new(
        stretch: &Stretch<'_>,
        linear: &dyn LinearEquations<f64>,
        from: f64,
        until: f64,
    ) -> Result<Self, String> {
        let system = stretch.system;
        let states = system.states();
        let middle = 0.5 * (from + until);
        let pattern = system.jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        system.jacobian(middle, &vec![0.0; states], &mut values);
        let entries = pattern.entries.iter().zip(values);
        let entries = entries.map(|(&(row, column), v)| (row as usize, column as usize, v));
        let entries = entries.collect();
        let terms = linear.excitation_terms();
        let mut numbers = vec![0.0; TERM_NUMBERS * terms.len()];
        linear.excitation(middle, system.parameters(), &mut numbers);
        let mut waves: Vec<Wave> = Vec::new();
        for (&(entry, power), numbers) in terms.iter().zip(numbers.chunks_exact(TERM_NUMBERS)) {
            let amplitude = Complex::new(numbers[2], -numbers[3]);
            if amplitude == Complex::ZERO {
                continue;
            }
            let mu = Complex::new(numbers[0], numbers[1]);
            let amplitude = (entry as usize, amplitude);
            match waves.iter_mut().find(|wave| wave.power == power && wave.mu == mu) {
                Some(wave) => wave.amplitudes.push(amplitude),
                None => {
                    waves.push(Wave { origin: 0.0, power, mu, amplitudes: vec![amplitude] });
                }
            }
        }
        let mut piece = Piece { from, until, entries, states, waves };
        piece.judge(stretch)?;
        Ok(piece)
    }

    /// Returns the length of the state.
    pub(super) fn states(&self) -> usize {
        self.states
    }

    /// Returns A.
    pub(super) fn matrix(&self) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.states, self.states);
        for &(row, column, value) in &self.entries {
            matrix[(row, column)] += value;
        }
        matrix
    }

    /// Returns the length of the piece \[s\].
    pub(super) fn span(&self) -> f64 {
        self.until - self.from
    }

    /// Returns a wave in local time s = t - from: the coefficients of s^j e^(mu s) for j up to the
    /// power, to be multiplied by an amplitude.
    pub(super) fn local(&self, wave: &Wave) -> Vec<Complex<f64>> {
        let from = self.from - wave.origin;
        let start = (wave.mu * from).exp();
        let mut binomial = 1.0;
        let powers = (0..=wave.power).map(|j| {
            let coefficient = start * binomial * from.powi((wave.power - j) as i32);
            binomial *= f64::from(wave.power - j) / f64::from(j + 1);
            coefficient
        });
        powers.collect()
    }
}

/// Returns the start of a segment, the switches strictly inside it in order and each once, and its
/// end.
pub(super) fn ends(stretch: &Stretch<'_>, linear: &dyn LinearEquations<f64>) -> Vec<f64> {
    let mut ends = vec![0.0; linear.switches()];
    linear.switch_times(stretch.system.parameters(), &mut ends);
    cut(stretch.from, stretch.until, ends)
}

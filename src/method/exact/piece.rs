//! A piece of a run without switches: A and the waves that excite the machine.

mod excitation;

use machinist_contract::linear::{LinearEquations, TERM_NUMBERS};
use nalgebra::{Complex, DMatrix};

use super::rows::{Kind, Row};
use crate::method::{Stretch, cut};

/// A linear machine between two switches, with relations and modes held.
pub(super) struct Piece {
    pub(super) from: f64,
    pub(super) until: f64,
    /// Nonzeros of A, `states` by `states`.
    pub(super) entries: Vec<(usize, usize, f64)>,
    states: usize,
    /// Waves, each kind once.
    pub(super) waves: Vec<Wave>,
    /// Guards of events, then of kinks.
    guards: Vec<Row>,
    /// The state at rest, with its modes.
    rest: Vec<f64>,
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
    /// Returns the piece in the modes of a state.
    ///
    /// # Errors
    /// The reason if its waves are not the excitation of the machine.
    pub(super) fn new(
        stretch: &Stretch<'_>,
        linear: &dyn LinearEquations<f64>,
        (from, until): (f64, f64),
        state: &[f64],
    ) -> Result<Self, String> {
        let system = stretch.system;
        let (states, simulator) = (system.states(), system.simulator());
        let middle = 0.5 * (from + until);
        let in_mode = |entry: usize| if simulator.is_mode(entry) { state[entry] } else { 0.0 };
        let rest: Vec<f64> = (0..states).map(in_mode).collect();
        let (terms, slopes) = (linear.excitation_terms(), linear.slopes());
        let mut numbers = vec![0.0; TERM_NUMBERS * terms.len() + slopes.len()];
        linear.excitation(middle, &rest, &system.held().all(), &mut numbers);
        let (numbers, slope_values) = numbers.split_at(TERM_NUMBERS * terms.len());
        let mut guards = vec![Row::default(); simulator.events() + simulator.kinks()];
        let mut entries = Vec::new();
        for (&(row, entry), value) in slopes.iter().zip(slope_values) {
            match (row as usize).checked_sub(states) {
                Some(guard) => guards[guard].add_slope(entry as usize, *value),
                None => entries.push((row as usize, entry as usize, *value)),
            }
        }
        if guards.is_empty() {
            let pattern = system.jacobian_pattern();
            let mut values = vec![0.0; pattern.entries.len()];
            system.jacobian(middle, &rest, &mut values);
            let nonzeros = pattern.entries.iter().zip(values);
            entries =
                nonzeros.map(|(&(row, column), v)| (row as usize, column as usize, v)).collect();
        }
        let mut waves: Vec<Wave> = Vec::new();
        for (&(entry, power), numbers) in terms.iter().zip(numbers.chunks_exact(TERM_NUMBERS)) {
            let amplitude = Complex::new(numbers[2], -numbers[3]);
            if amplitude == Complex::ZERO {
                continue;
            }
            let mu = Complex::new(numbers[0], numbers[1]);
            let entry = entry as usize;
            if let Some(guard) = entry.checked_sub(states) {
                guards[guard].add_wave(Kind { origin: 0.0, power, mu }, amplitude);
                continue;
            }
            let amplitude = (entry, amplitude);
            match waves.iter_mut().find(|wave| wave.power == power && wave.mu == mu) {
                Some(wave) => wave.amplitudes.push(amplitude),
                None => {
                    waves.push(Wave { origin: 0.0, power, mu, amplitudes: vec![amplitude] });
                }
            }
        }
        let mut piece = Piece { from, until, entries, states, waves, guards, rest };
        piece.judge(stretch)?;
        Ok(piece)
    }

    /// Returns the rates of the states, then the guards.
    pub(super) fn rows(&self) -> Vec<Row> {
        let mut rows = vec![Row::default(); self.states];
        for &(row, column, value) in &self.entries {
            rows[row].add_slope(column, value);
        }
        for wave in &self.waves {
            let kind = Kind { origin: wave.origin, power: wave.power, mu: wave.mu };
            for (entry, amplitude) in &wave.amplitudes {
                rows[*entry].add_wave(kind, *amplitude);
            }
        }
        rows.extend(self.guards.iter().cloned());
        rows
    }

    /// Returns whether powers of time excite it.
    pub(super) fn is_of_powers(&self) -> bool {
        self.waves.iter().any(|wave| wave.power > 0)
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

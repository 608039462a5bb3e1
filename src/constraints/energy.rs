//! Projection of states onto the energy of a conservative machine.
//!
//! A state is moved in the direction in which its energy changes fastest, in the norm of the mass
//! matrix with positions in units of a time tau,
//!
//! ```text
//! dq = -s tau^2 a,    dv = s v,    tau^2 = max(v^T M v)/max(a^T M a) over the run so far,
//! ```
//!
//! where v and a are the velocities and accelerations along the constraints. Each move is projected
//! onto the constraints, and s is found by the secant method. At a turning point v = 0, so positions
//! alone move; where a = 0, velocities alone do.

use std::cell::Cell;

use nalgebra::DVector;

use super::{Constraints, Level, Lost};

/// Energy that the states of a run keep.
#[derive(Debug, Default)]
pub(crate) struct EnergyLevel {
    /// T + V + stored \[J\]; `None` before the start.
    wanted: Cell<Option<f64>>,
    /// Largest v^T M v and a^T M a so far.
    largest: Cell<[f64; 2]>,
}

/// Moves of positions and velocities by which the energy grows, and its slope.
struct Ascent {
    positions: DVector<f64>,
    velocities: DVector<f64>,
    slope: f64,
}

impl EnergyLevel {
    /// Keeps the energy of a state from now on, unless another is kept already.
    pub(crate) fn begin(&self, constraints: &Constraints<'_>, time: f64, state: &[f64]) {
        if self.wanted.get().is_none() {
            self.wanted.set(Some(constraints.energy(time, state)));
        }
    }

    /// Keeps no energy until [`EnergyLevel::begin`] is called again.
    pub(crate) fn end(&self) {
        self.wanted.set(None);
    }
}

impl Constraints<'_> {
    /// Returns T + V + stored \[J\].
    fn energy(&self, time: f64, state: &[f64]) -> f64 {
        self.simulator.energy(time, state, &self.parameters.all()).total()
    }

    /// Moves a state on the constraints to the energy that a run keeps, as long as each move brings
    /// it nearer.
    pub(crate) fn put_onto_energy(&self, level: &EnergyLevel, time: f64, state: &mut [f64]) {
        const ROUNDS: usize = 6;
        let Some(wanted) = level.wanted.get() else { return };
        let state = &mut state[..self.simulator.shape().states()];
        let mut off = self.energy(time, state) - wanted;
        let Some(ascent) = self.ascent(level, time, state).filter(|_| off != 0.0) else { return };
        let start = state.to_vec();
        let mut before = (0.0, off);
        let mut share = -off / ascent.slope;
        for _ in 0..ROUNDS {
            let Ok(moved) = self.moved_along(&ascent, share, time, &start) else { return };
            let now = self.energy(time, &moved) - wanted;
            let is_nearer = now.abs() < off.abs();
            if !is_nearer {
                return;
            }
            state.copy_from_slice(&moved);
            off = now;
            let slope = (now - before.1) / (share - before.0);
            before = (share, now);
            share -= now / slope;
        }
    }

    /// Returns a state moved by a share of an ascent and projected onto the constraints.
    fn moved_along(
        &self,
        ascent: &Ascent,
        share: f64,
        time: f64,
        from: &[f64],
    ) -> Result<Vec<f64>, Lost> {
        let mut moved = from.to_vec();
        self.shift(Level::Positions, time, &mut moved, &(share * &ascent.positions));
        self.shift(Level::Velocities, time, &mut moved, &(share * &ascent.velocities));
        self.put_back(Level::Positions, time, &mut moved)?;
        self.put_back(Level::Velocities, time, &mut moved)?;
        Ok(moved)
    }

    /// Returns the ascent of the energy at a state; `None` at rest in an equilibrium.
    fn ascent(&self, level: &EnergyLevel, time: f64, state: &[f64]) -> Option<Ascent> {
        let (first, n) = (self.first(Level::Velocities), self.coordinates);
        let mut rate = vec![0.0; state.len()];
        self.simulator.rate(time, state, &self.parameters.all(), &mut rate);
        let velocities = DVector::from_column_slice(&state[first..first + n]);
        let whole = DVector::from_column_slice(&rate[first..first + n]);
        let slopes = self.slopes(time, state);
        let across = self.shortest(time, state, &slopes, &(self.filled(&slopes) * &whole))?;
        let along = whole - across.rows(0, n);
        let sizes = [&velocities, &along].map(|moves| self.inertia_of(moves, time, state));
        let mut largest = level.largest.get();
        for (largest, size) in largest.iter_mut().zip(sizes) {
            *largest = largest.max(size);
        }
        level.largest.set(largest);
        let tau_squared = if largest[1] > 0.0 { largest[0] / largest[1] } else { 0.0 };
        let slope = sizes[0] + tau_squared * sizes[1];
        let positions = -tau_squared * along;
        (slope.is_finite() && slope > 0.0).then_some(Ascent { positions, velocities, slope })
    }

    /// Returns x^T M x.
    fn inertia_of(&self, moves: &DVector<f64>, time: f64, state: &[f64]) -> f64 {
        let entries = self.simulator.mass_matrix_pattern().entries;
        let mut values = vec![0.0; entries.len()];
        self.simulator.mass_matrix(time, state, &self.parameters.all(), &mut values);
        let product = |((row, column), value): (&(u32, u32), &f64)| {
            moves[*row as usize] * value * moves[*column as usize]
        };
        entries.iter().zip(&values).map(product).sum()
    }
}

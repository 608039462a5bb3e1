//! Modal reduction of any simulator to its slowest eigenmodes.
//!
//! ```text
//! q = Phi eta        (Phi^T M Phi) eta'' = Phi^T f(Phi eta, Phi eta', z, t)
//! ```
//!
//! The columns of Phi are the eigenmodes of M and the stiffness at the start of the run, K Phi = M
//! Phi w^2, with the smallest w. f may be nonlinear (Galerkin); M must be constant. With all
//! eigenmodes the motion is that of the simulator itself.

use std::cell::RefCell;

use machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, RunDefaults, Shape, Simulator, SparsityPattern,
    StateKind,
};
use nalgebra::{DMatrix, DVector};

use crate::linear_analysis::{LinearError, Linearization, Point};
use crate::sorting::sort_ascending;

/// Reason why a simulator cannot be reduced.
#[derive(Debug, Clone, PartialEq, thiserror::Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "modal::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum ModalError {
    /// The number of eigenmodes is out of range.
    #[error("the number of eigenmodes is from 1 to {most}, not {found}")]
    ModeCount {
        /// Number of coordinates of the simulator.
        most: usize,
        /// Requested number.
        found: usize,
    },
    /// The mass matrix depends on the state.
    #[error("the mass matrix depends on the state, so there are no constant eigenmodes")]
    MovingMass,
    /// The simulator cannot be linearized at the start.
    #[strum(serialize = "")]
    #[error(transparent)]
    Linear(#[from] LinearError),
    /// Positions are left out of the state, so eigenmodes do not determine it.
    #[error("the scene was derived without some positions; derive it without reduction")]
    LeftOut,
    /// The machine has constraints, which a sum of eigenmodes would violate.
    #[error("the machine has constraints, which a sum of its eigenmodes would violate")]
    Constrained,
    /// The machine has events, whose states a sum of eigenmodes does not contain.
    #[error("the machine has events, which a sum of its eigenmodes cannot detect")]
    Events,
    /// M and K have no modes.
    #[error("the mass matrix is not positive definite, or the stiffness not finite")]
    NoModes,
}

impl ModalError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Linear(error) => error.code(),
            error => error.into(),
        }
    }
}

/// A simulator with given parameters, reduced to some of its eigenmodes. It has no parameters of
/// its own.
pub struct ModalSimulator<'a> {
    simulator: &'a dyn Simulator<f64>,
    parameters: Vec<f64>,
    /// Phi, with largest entries of 1 in each column.
    shapes: DMatrix<f64>,
    /// (Phi^T M Phi)^-1 Phi^T, and the same times M.
    of_forces: DMatrix<f64>,
    of_accelerations: DMatrix<f64>,
    /// Index of the coordinate with the largest entry in each shape.
    largest: Vec<usize>,
    names: [Vec<String>; 2],
    first_order: usize,
    jacobian: Vec<(u32, u32)>,
    mass: Vec<(u32, u32)>,
    masses: DVector<f64>,
    work: RefCell<[Vec<f64>; 2]>,
}

impl<'a> ModalSimulator<'a> {
    /// Reduces a simulator to its slowest `modes` eigenmodes about its start.
    ///
    /// # Errors
    /// [`ModalError`].
    pub fn new(
        simulator: &'a dyn Simulator<f64>,
        parameters: &[f64],
        modes: usize,
    ) -> Result<Self, ModalError> {
        let shape = simulator.shape();
        let n = shape.coordinates;
        if shape.positions != n {
            return Err(ModalError::LeftOut);
        }
        if simulator.constraints() > 0 {
            return Err(ModalError::Constrained);
        }
        if simulator.events() > 0 {
            return Err(ModalError::Events);
        }
        if !(1..=n).contains(&modes) {
            return Err(ModalError::ModeCount { most: n, found: modes });
        }
        let mut state = vec![0.0; shape.states()];
        simulator.initial_state(parameters, &mut state);
        let time = simulator.run_defaults().from;
        let point = Point { time, state: state.clone(), parameters: parameters.to_vec() };
        let system = Linearization::at(simulator, point)?.second_order()?;
        let mut masses = vec![0.0; simulator.mass_matrix_pattern().entries.len()];
        let mut moved = masses.clone();
        simulator.mass_matrix(time, &state, parameters, &mut masses);
        let elsewhere = state.iter().enumerate();
        let elsewhere: Vec<f64> = elsewhere
            .map(|(index, value)| {
                value + 0.3 * simulator.state_scale(index) * (index as f64 + 1.0).sin()
            })
            .collect();
        simulator.mass_matrix(time + 0.123, &elsewhere, parameters, &mut moved);
        if masses.iter().zip(&moved).any(|(a, b)| (a - b).abs() > 1e-12 * a.abs()) {
            return Err(ModalError::MovingMass);
        }
        let stiffness = (&system.stiffness + system.stiffness.transpose()) / 2.0;
        let shapes = slowest(&system.mass, &stiffness, modes).ok_or(ModalError::NoModes)?;
        let (shapes, largest) = scaled(shapes);
        let reduced = shapes.transpose() * &system.mass * &shapes;
        let inverse = reduced.clone().cholesky().ok_or(ModalError::NoModes)?.inverse();
        let of_forces = inverse * shapes.transpose();
        let (k, m) = (modes as u32, shape.first_order as u32);
        let mut jacobian: Vec<(u32, u32)> = (0..k).map(|row| (row, row + k)).collect();
        jacobian.extend((k..2 * k + m).flat_map(|row| (0..2 * k + m).map(move |c| (row, c))));
        let name = |suffix: &str| (1..=modes).map(|k| format!("mode[{k}]{suffix}")).collect();
        Ok(Self {
            simulator,
            parameters: parameters.to_vec(),
            of_accelerations: &of_forces * &system.mass,
            of_forces,
            largest,
            names: [name(""), name("_dot")],
            first_order: shape.first_order,
            jacobian,
            mass: (0..k).map(|index| (index, index)).collect(),
            masses: reduced.diagonal(),
            work: RefCell::new([vec![0.0; shape.states()], vec![0.0; shape.states()]]),
            shapes,
        })
    }

    fn modes(&self) -> usize {
        self.shapes.ncols()
    }

    fn coordinates(&self) -> usize {
        self.shapes.nrows()
    }

    /// Computes the simulator's own state.
    fn expand(&self, state: &[f64], whole: &mut [f64]) {
        let (k, n) = (self.modes(), self.coordinates());
        for (from, to) in [(0, 0), (k, n)] {
            let part = &self.shapes * DVector::from_column_slice(&state[from..from + k]);
            whole[to..to + n].copy_from_slice(part.as_slice());
        }
        whole[2 * n..].copy_from_slice(&state[2 * k..]);
    }

    fn with<T>(&self, state: &[f64], see: impl FnOnce(&[f64], &mut [f64]) -> T) -> T {
        let [whole, other] = &mut *self.work.borrow_mut();
        self.expand(state, whole);
        see(whole, other)
    }
}

/// Returns the columns of Phi with Phi^T M Phi = 1 and the smallest w.
fn slowest(mass: &DMatrix<f64>, stiffness: &DMatrix<f64>, modes: usize) -> Option<DMatrix<f64>> {
    if stiffness.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let inverse = mass.clone().cholesky()?.l().try_inverse()?;
    let eigen = (&inverse * stiffness * inverse.transpose()).symmetric_eigen();
    let mut order: Vec<usize> = (0..eigen.eigenvalues.len()).collect();
    sort_ascending(&mut order, |place| eigen.eigenvalues[*place]);
    order.truncate(modes);
    Some(inverse.transpose() * eigen.eigenvectors.select_columns(&order))
}

/// Scales columns so that their largest entry is 1, and returns its indices.
fn scaled(mut shapes: DMatrix<f64>) -> (DMatrix<f64>, Vec<usize>) {
    let mut largest = Vec::new();
    for mut column in shapes.column_iter_mut() {
        let place = column.icamax();
        let size = column[place];
        column /= size;
        largest.push(place);
    }
    (shapes, largest)
}

impl Describe for ModalSimulator<'_> {
    fn name(&self) -> &str {
        self.simulator.name()
    }
    fn title(&self) -> &str {
        self.simulator.title()
    }
    fn shape(&self) -> Shape {
        let (coordinates, positions) = (self.modes(), self.modes());
        Shape { coordinates, positions, quadratures: 0, parameters: 0, ..self.simulator.shape() }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        let (k, n) = (self.modes(), self.coordinates());
        let order = index / k;
        if order < 2 {
            let of_largest = self.simulator.state(order * n + self.largest[index % k]);
            return Quantity { name: &self.names[order][index % k], ..of_largest };
        }
        self.simulator.state(index - 2 * k + 2 * n)
    }
    fn state_kind(&self, index: usize) -> StateKind {
        match index / self.modes() {
            0 => StateKind::Position,
            1 => StateKind::Velocity,
            _ => StateKind::FirstOrder,
        }
    }
    fn state_scale(&self, index: usize) -> f64 {
        let (k, n) = (self.modes(), self.coordinates());
        match index / k {
            order @ 0..2 => self.simulator.state_scale(order * n + self.largest[index % k]),
            _ => self.simulator.state_scale(index - 2 * k + 2 * n),
        }
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        panic!("there is no parameter of number {index}")
    }
    fn parameter_default(&self, index: usize) -> f64 {
        panic!("there is no parameter of number {index}")
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        self.simulator.output(index)
    }
    fn output_answers_at_once(&self, index: usize) -> bool {
        self.simulator.output_answers_at_once(index)
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        let states = self.shape().states();
        SparsityPattern { rows: states, columns: states, entries: &self.jacobian }
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: self.shape().states(), columns: 0, entries: &[] }
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: self.modes(), columns: self.modes(), entries: &self.mass }
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        self.simulator.run_defaults()
    }
    fn starts_in_equilibrium(&self) -> bool {
        self.simulator.starts_in_equilibrium()
    }
}

impl Simulator<f64> for ModalSimulator<'_> {
    fn initial_state(&self, _: &[f64], state: &mut [f64]) {
        let (k, n) = (self.modes(), self.coordinates());
        let [whole, _] = &mut *self.work.borrow_mut();
        self.simulator.initial_state(&self.parameters, whole);
        for (from, to) in [(0, 0), (n, k)] {
            let part = DVector::from_column_slice(&whole[from..from + n]);
            state[to..to + k].copy_from_slice((&self.of_accelerations * part).as_slice());
        }
        state[2 * k..].copy_from_slice(&whole[2 * n..]);
    }

    fn discontinuities(&self, _: &[f64], times: &mut [f64]) {
        self.simulator.discontinuities(&self.parameters, times);
    }

    fn rate(&self, time: f64, state: &[f64], _: &[f64], rate: &mut [f64]) {
        let (k, n) = (self.modes(), self.coordinates());
        rate[..k].copy_from_slice(&state[k..2 * k]);
        self.with(state, |whole, other| {
            if self.first_order > 0 {
                self.simulator.rate(time, whole, &self.parameters, other);
                rate[2 * k..].copy_from_slice(&other[2 * n..]);
            }
            self.simulator.forcing(time, whole, &self.parameters, &mut other[..n]);
            let forces = DVector::from_column_slice(&other[..n]);
            rate[k..2 * k].copy_from_slice((&self.of_forces * forces).as_slice());
        });
    }

    fn rate_jacobian(&self, time: f64, state: &[f64], _: &[f64], values: &mut [f64]) {
        let (k, n, m) = (self.modes(), self.coordinates(), self.first_order);
        let pattern = self.simulator.rate_jacobian_pattern();
        let mut entries = vec![0.0; pattern.entries.len()];
        self.with(state, |whole, _| {
            self.simulator.rate_jacobian(time, whole, &self.parameters, &mut entries);
        });
        // Rows q'' and z' by eta, eta', z.
        let mut by_modes = DMatrix::zeros(n + m, 2 * k + m);
        for ((row, column), value) in pattern.entries.iter().zip(&entries) {
            let (row, column) = (*row as usize, *column as usize);
            let Some(row) = row.checked_sub(n) else { continue };
            if column >= 2 * n {
                by_modes[(row, column - 2 * n + 2 * k)] += *value;
                continue;
            }
            let (first, coordinate) = (column / n * k, column % n);
            for mode in 0..k {
                by_modes[(row, first + mode)] += value * self.shapes[(coordinate, mode)];
            }
        }
        let upper = &self.of_accelerations * by_modes.rows(0, n);
        values[..k].fill(1.0);
        let mut place = k;
        for row in 0..k + m {
            for column in 0..2 * k + m {
                values[place] =
                    if row < k { upper[(row, column)] } else { by_modes[(row - k + n, column)] };
                place += 1;
            }
        }
    }

    fn parameter_jacobian(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}

    fn time_derivative(&self, time: f64, state: &[f64], _: &[f64], derivative: &mut [f64]) {
        let (k, n) = (self.modes(), self.coordinates());
        derivative[..k].fill(0.0);
        self.with(state, |whole, other| {
            self.simulator.time_derivative(time, whole, &self.parameters, other);
            let part = DVector::from_column_slice(&other[n..2 * n]);
            derivative[k..2 * k].copy_from_slice((&self.of_accelerations * part).as_slice());
            derivative[2 * k..].copy_from_slice(&other[2 * n..]);
        });
    }

    fn mass_matrix(&self, _: f64, _: &[f64], _: &[f64], values: &mut [f64]) {
        values.copy_from_slice(self.masses.as_slice());
    }

    fn forcing(&self, time: f64, state: &[f64], _: &[f64], forcing: &mut [f64]) {
        let n = self.coordinates();
        self.with(state, |whole, other| {
            self.simulator.forcing(time, whole, &self.parameters, &mut other[..n]);
            let forces = DVector::from_column_slice(&other[..n]);
            forcing.copy_from_slice((self.shapes.transpose() * forces).as_slice());
        });
    }

    fn outputs(&self, time: f64, state: &[f64], _: &[f64], outputs: &mut [f64]) {
        self.with(state, |whole, _| {
            self.simulator.outputs(time, whole, &self.parameters, outputs);
        });
    }

    fn energy(&self, time: f64, state: &[f64], _: &[f64]) -> Energy<f64> {
        self.with(state, |whole, _| self.simulator.energy(time, whole, &self.parameters))
    }

    /// Returns the balance of the simulator: power along the eigenmodes is power of its forces.
    fn power_balance(&self, time: f64, state: &[f64], _: &[f64]) -> PowerBalance<f64> {
        self.with(state, |whole, _| self.simulator.power_balance(time, whole, &self.parameters))
    }
}

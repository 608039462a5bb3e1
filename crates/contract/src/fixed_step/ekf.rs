//! Extended Kalman filter on the fixed steps of a machine.

use super::carried::{self, Carried};
use super::{Clock, FixedMethod, FixedSteps, Room, Stepped};
use crate::{Dual, DualFunction, Real, Simulator};

/// Extended Kalman filter of a machine, in square-root form, without allocation.
///
/// It estimates x = (y, theta): the state y, and parameters theta that drift. Between measurements
/// the state advances by a fixed step F, disturbed by noise:
///
/// ```text
/// y[k+1] = F(y[k] + a, theta[k] + a, p + w)      theta[k+1] = theta[k] + a
///          a ~ N(0, q^2 h),  w ~ N(0, s^2/h)     intensities q and s, step h
/// z[k]   = outputs(y[k], p) + v                  v ~ N(0, r^2)
/// ```
///
/// A disturbance w of a parameter, such as a force or a voltage, is constant within a step: s^2 is
/// its spectral density.
///
/// The covariance is S S^T. The columns of S, and those of the noise, are carried by the exact
/// derivative of the step: of its method, of its events with their times (saltation), and of the
/// projection onto constraints. Householder reflections then make S triangular. Measurements are
/// processed one after another by Potter's update, about the same predicted state.
///
/// Source: Bierman: Factorization Methods for Discrete Sequential Estimation (1977), chapters II
/// and VII.
pub struct ExtendedKalmanFilter<'a> {
    /// The machine. It must have [`Simulator::derivatives`].
    pub simulator: &'a dyn Simulator<f64>,
    /// Method of the steps.
    pub method: FixedMethod<'a>,
    /// As [`FixedSteps::parts_a_step`].
    pub parts_a_step: usize,
    /// Indices of the measured outputs, with the standard deviations r of their noise, in the units
    /// of the outputs.
    pub measured: &'a [(usize, f64)],
    /// Indices of the parameters theta that are estimated.
    pub estimated: &'a [usize],
    /// Entries of x that diffuse, with intensities q in their unit per root of a second.
    pub diffusing: &'a [(usize, f64)],
    /// Indices of disturbed parameters, with intensities s in their unit times the root of a
    /// second.
    pub disturbed: &'a [(usize, f64)],
}

/// Lengths of the slices of [`FilterMemory`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FilterSizes {
    /// Entries of the state.
    pub state: usize,
    /// Parameters.
    pub parameters: usize,
    /// Constants.
    pub constants: usize,
    /// Entries of the root of the covariance.
    pub root: usize,
    /// Workspace of numbers.
    pub numbers: usize,
    /// Workspace of signs.
    pub signs: usize,
    /// Workspace of dual numbers.
    pub duals: usize,
}

/// Estimate and workspace of a filter.
pub struct FilterMemory<'w> {
    /// Time of the estimate.
    pub clock: Clock<f64>,
    /// Estimated state.
    pub state: &'w mut [f64],
    /// Parameters, with the estimated ones among them. After changing an input, call
    /// [`ExtendedKalmanFilter::prepare`].
    pub parameters: &'w mut [f64],
    /// Result of [`Simulator::prepare`].
    pub constants: &'w mut [f64],
    /// S, column by column.
    pub root: &'w mut [f64],
    /// Workspace.
    pub numbers: &'w mut [f64],
    /// Signs of guards, kept from step to step, and workspace.
    pub signs: &'w mut [i8],
    /// Workspace.
    pub duals: &'w mut [Dual],
}

/// Result of a measurement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Normalized innovation squared, `e^T (H P H^T + R)^-1 e`. For a consistent filter it has a
    /// chi-squared distribution.
    pub innovation: f64,
    /// Number of measured outputs, its degrees of freedom.
    pub count: usize,
}

impl ExtendedKalmanFilter<'_> {
    /// Returns the number of entries of x.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.simulator.shape().states() + self.estimated.len()
    }

    /// Returns the number of columns that a step carries.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.entries() + self.diffusing.len() + self.disturbed.len()
    }

    /// Returns the reason why the filter cannot run, if there is one.
    #[must_use]
    pub fn refusal(&self) -> Option<&'static str> {
        let has_derivatives = self.simulator.derivatives().is_some();
        (!has_derivatives).then_some("the machine has no functions on dual numbers")
    }

    /// Returns the sizes of [`FilterMemory`].
    #[must_use]
    pub fn sizes(&self) -> FilterSizes {
        let simulator = self.simulator;
        let shape = simulator.shape();
        let [step, signs] = self.steps(&[], &[]).room();
        let resets = self.steps(&[], &[]).resets();
        let implicit = match self.method {
            FixedMethod::Rosenbrock2(_) => {
                simulator.rate_jacobian_pattern().entries.len().max(shape.states())
            }
            FixedMethod::Heun | FixedMethod::RungeKutta4 => 0,
        };
        let counts = [shape.outputs, resets, simulator.events(), simulator.constraints()];
        let results = counts.into_iter().fold(implicit, usize::max);
        let outputs = shape.outputs + self.measured.len() * (self.entries() + 1) + self.entries();
        FilterSizes {
            state: shape.states(),
            parameters: shape.parameters,
            constants: simulator.constants(),
            root: self.columns() * self.entries(),
            numbers: step + carried::room(self) + outputs,
            signs,
            duals: shape.states() + shape.parameters + results,
        }
    }

    fn steps<'s>(&'s self, parameters: &'s [f64], constants: &'s [f64]) -> FixedSteps<'s, f64> {
        let (simulator, parts_a_step) = (self.simulator, self.parts_a_step);
        FixedSteps { simulator, parameters, constants, method: self.method, parts_a_step }
    }

    /// Returns the place of a parameter among those estimated.
    pub(super) fn slot(&self, parameter: usize) -> Option<usize> {
        self.estimated.iter().position(|estimated| *estimated == parameter)
    }

    /// Returns the parameter that a column disturbs, with its intensity.
    pub(super) fn disturbance(&self, column: usize) -> Option<(usize, f64)> {
        let first = self.entries() + self.diffusing.len();
        column.checked_sub(first).and_then(|index| self.disturbed.get(index).copied())
    }

    /// Reports whether derivatives by parameters are needed.
    pub(super) fn reads_parameters(&self) -> bool {
        !self.estimated.is_empty() || !self.disturbed.is_empty()
    }

    /// Computes the constants, after parameters have changed.
    pub fn prepare(&self, memory: &mut FilterMemory<'_>) {
        self.simulator.prepare(memory.parameters, memory.constants);
    }

    /// Begins with the state, parameters and time in memory. `deviations` are the standard
    /// deviations of the entries of x, taken as independent; constraints then reduce them.
    ///
    /// # Panics
    /// If slices are shorter than [`ExtendedKalmanFilter::sizes`], here and below.
    pub fn begin(&self, deviations: &[f64], memory: &mut FilterMemory<'_>) {
        self.prepare(memory);
        let size = self.entries();
        memory.root.fill(0.0);
        for (entry, deviation) in deviations.iter().enumerate().take(size) {
            memory.root[entry * size + entry] = *deviation;
        }
        self.settle(memory);
    }

    /// Puts the state onto the constraints, and corrects modes that contradict their guards. The
    /// covariance follows.
    fn settle(&self, memory: &mut FilterMemory<'_>) {
        let steps = self.steps(memory.parameters, memory.constants);
        let [step, _] = steps.room();
        let (numbers, rest) = memory.numbers.split_at_mut(step);
        let mut room = Room { numbers, signs: memory.signs };
        let columns = &mut memory.root[..self.entries() * self.entries()];
        let mut carried = Carried::new(self, (columns, rest, memory.duals), 0.0);
        let time = memory.clock.time();
        steps.restore((time, memory.state), &mut room, &mut carried);
        steps.settle_followed(time, memory.state, &mut room, &mut carried);
    }

    /// Advances the estimate by a step \[s\].
    pub fn predict(&self, step: f64, memory: &mut FilterMemory<'_>) -> Stepped {
        let size = self.entries();
        let root_of_step = Real::sqrt(step);
        for (index, &(entry, intensity)) in self.diffusing.iter().enumerate() {
            let column = &mut memory.root[(size + index) * size..(size + index + 1) * size];
            column.fill(0.0);
            column[entry] = intensity * root_of_step;
        }
        memory.root[(size + self.diffusing.len()) * size..self.columns() * size].fill(0.0);
        let steps = self.steps(memory.parameters, memory.constants);
        let [room, _] = steps.room();
        let (numbers, rest) = memory.numbers.split_at_mut(room);
        let mut room = Room { numbers, signs: memory.signs };
        let columns = &mut memory.root[..self.columns() * size];
        let mut carried = Carried::new(self, (columns, rest, memory.duals), 1.0 / root_of_step);
        let time = memory.clock.time();
        let stepped = steps.step_followed((time, step), memory.state, &mut room, &mut carried);
        memory.clock.pass(step);
        triangularize(columns, size);
        stepped
    }

    /// Corrects the estimate by measured outputs, in the order of `measured`. Values that are not a
    /// number are left out.
    pub fn correct(&self, values: &[f64], memory: &mut FilterMemory<'_>) -> Correction {
        let size = self.entries();
        let states = self.simulator.shape().states();
        let outputs = self.simulator.shape().outputs;
        let steps = self.steps(memory.parameters, memory.constants);
        let [room, _] = steps.room();
        let (_, rest) = memory.numbers.split_at_mut(room);
        let (numbers, rest) = rest.split_at_mut(carried::room(self));
        let (predicted, rest) = rest.split_at_mut(outputs);
        let (seen, rest) = rest.split_at_mut(self.measured.len() * size);
        let (innovations, rest) = rest.split_at_mut(self.measured.len());
        let change = &mut rest[..size];
        change.fill(0.0);
        let time = memory.clock.time();
        self.simulator.outputs(time, memory.state, memory.parameters, predicted);
        let root = &mut memory.root[..size * size];
        let mut carried = Carried::new(self, (root, numbers, memory.duals), 0.0);
        for (first, count) in carried.batches() {
            let (at, p) = ((time, &*memory.state), &*memory.parameters);
            carried.evaluate(DualFunction::Outputs, at, p, (first, outputs));
            for (row, &(output, _)) in self.measured.iter().enumerate() {
                for direction in 0..count {
                    seen[row * size + first + direction] = carried.along(output, direction);
                }
            }
        }
        for (row, &(output, _)) in self.measured.iter().enumerate() {
            innovations[row] = values[row] - predicted[output];
        }
        let mut update = Update { root: &mut *memory.root, seen, innovations, change };
        let mut correction = Correction { innovation: 0.0, count: 0 };
        for (row, &(_, deviation)) in self.measured.iter().enumerate() {
            update.process(row, deviation * deviation, &mut correction);
        }
        for (entry, change) in change.iter().enumerate() {
            if entry >= states {
                let parameter = &mut memory.parameters[self.estimated[entry - states]];
                *parameter += change;
            } else if !self.simulator.is_mode(entry) {
                memory.state[entry] += change;
            }
        }
        if !self.estimated.is_empty() {
            self.prepare(memory);
        }
        self.settle(memory);
        correction
    }

    /// Returns the covariance of two entries of x.
    #[must_use]
    pub fn covariance(&self, root: &[f64], row: usize, column: usize) -> f64 {
        let size = self.entries();
        let of = |entry: usize, index: usize| root_entry(root, size, index, entry);
        (0..size).fold(0.0, |sum, index| sum + of(row, index) * of(column, index))
    }
}

/// Measurements of one time, on their way into an estimate.
struct Update<'u> {
    /// S, column by column, and beyond it columns that are not read.
    root: &'u mut [f64],
    /// H S, row by row.
    seen: &'u mut [f64],
    innovations: &'u mut [f64],
    /// Change of x.
    change: &'u mut [f64],
}

impl Update<'_> {
    /// Processes a measurement with this variance of its noise, by Potter's update:
    ///
    /// ```text
    /// phi = S^T h,  a = phi^T phi + r,  x += S phi e/a,  S -= S phi phi^T/(a + sqrt(r a))
    /// ```
    ///
    /// The rows H S and innovations of later measurements are those after this one.
    fn process(&mut self, row: usize, noise: f64, correction: &mut Correction) {
        let size = self.change.len();
        let (own, later) = self.seen[row * size..].split_at_mut(size);
        let innovation = self.innovations[row];
        if innovation.is_nan() {
            return;
        }
        let variance = own.iter().fold(noise, |sum, entry| sum + entry * entry);
        let share = innovation / variance;
        let shrink = 1.0 / (variance + Real::sqrt(noise * variance));
        correction.innovation += innovation * share;
        correction.count += 1;
        let innovations = self.innovations[row + 1..].iter_mut();
        for (row, innovation) in later.chunks_exact_mut(size).zip(innovations) {
            let common = dot(row, own);
            *innovation -= common * share;
            let factor = shrink * common;
            for (entry, own) in row.iter_mut().zip(own.iter()) {
                *entry -= factor * own;
            }
        }
        for (entry, change) in self.change.iter_mut().enumerate() {
            let mut product = 0.0;
            for (column, own) in own.iter().enumerate() {
                product += root_entry(self.root, size, column, entry) * own;
            }
            *change += product * share;
            let factor = shrink * product;
            for (column, own) in own.iter().enumerate() {
                self.root[column * size + entry] -= factor * own;
            }
        }
    }
}

fn root_entry(root: &[f64], size: usize, column: usize, entry: usize) -> f64 {
    root[column * size + entry]
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// Makes the first columns lower triangular and the others zero, without changing the product of
/// the matrix and its transpose, by a Householder reflection for each row.
fn triangularize(columns: &mut [f64], size: usize) {
    let count = columns.len() / size;
    for row in 0..size.min(count) {
        let at = |column: usize, row: usize| column * size + row;
        let mut largest = 0.0;
        for column in row..count {
            let entry = Real::abs(columns[at(column, row)]);
            largest = if largest < entry { entry } else { largest };
        }
        if largest <= 0.0 {
            continue;
        }
        // The reflection is I - factor v v^T. Its row is divided by its largest entry, so that
        // squares neither vanish nor overflow.
        let mut square = 0.0;
        for column in row..count {
            let entry = columns[at(column, row)] / largest;
            columns[at(column, row)] = entry;
            square += entry * entry;
        }
        let norm = Real::sqrt(square);
        let first = columns[at(row, row)];
        let end = if first < 0.0 { norm } else { -norm };
        columns[at(row, row)] = first - end;
        let factor = 1.0 / (square - first * end);
        for below in row + 1..size {
            let mut product = 0.0;
            for column in row..count {
                product += columns[at(column, row)] * columns[at(column, below)];
            }
            product *= factor;
            for column in row..count {
                columns[at(column, below)] -= product * columns[at(column, row)];
            }
        }
        columns[at(row, row)] = largest * end;
        for column in row + 1..count {
            columns[at(column, row)] = 0.0;
        }
    }
}

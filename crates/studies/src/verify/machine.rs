//! A scene to be checked: its simulator in two number types, parameters, quantities by name, and
//! random states.

use std::cell::RefCell;

use machinist_contract::{Quantity, Simulator};
use machinist_scenes::scenes;
use nalgebra::{DMatrix, DVector};

use super::CheckFailure;
pub(crate) use super::random::SplitMix;
use machinist::complex_step::{self, ComplexStep, Values};
use machinist::constraints::{Constraints, Level};
use machinist::field::{Discretisation, FieldSimulator};
use machinist::linear_analysis::{Linearization, Place, Point as LinearPoint, operating_point};
use machinist::trajectory::ColumnKind;
use machinist::{Method, Simulation, Trajectory};

/// A verified scene, with overridden parameters if any.
#[derive(Clone)]
pub(crate) struct Machine {
    name: &'static str,
    /// The simulator in `f64`.
    pub(crate) real: &'static dyn Simulator<f64>,
    /// The same emitted code in complex-step numbers.
    pub(crate) complex: &'static dyn Values,
    overrides: Vec<(usize, f64)>,
}

/// Time, state and parameters of an evaluation.
#[derive(Clone)]
pub(crate) struct Point {
    pub(crate) time: f64,
    pub(crate) state: Vec<f64>,
    pub(crate) parameters: Vec<f64>,
}

/// Returns every verified scene, in the order of the report.
pub(crate) fn all() -> Vec<Machine> {
    vec![
        two_mass(),
        motor_run_up(),
        saw_gin(),
        saw_gin_as_printed(),
        motor_stationary_axes(),
        winder_linear(),
        winder_linear_as_printed(),
        winder_nonlinear(),
        winder_full(),
        pendulum_chain(),
        pendulum_relative(),
        pendulum_constrained(),
        slider_crank(),
        four_bar(),
        winder_linkage(),
        winder_holder_drop(),
        bouncing_mass(),
        coulomb_oscillator(),
        stick_slip(),
        stick_slip_smooth(),
        contact_oscillator(),
        contact_oscillator_smooth(),
        shaft_step_torque(),
        shaft_with_rotors(),
        reed_beat_up(),
        reed_beat_up_one_sided(),
        saw_gin_shaft(),
        loom_drive(),
    ]
}

/// Returns two rotors on a coupling.
pub(crate) fn two_mass() -> Machine {
    Machine::new(&scenes::two_mass::TwoMass)
}

/// The motor alone.
pub(crate) fn motor_run_up() -> Machine {
    Machine::new(&scenes::motor_run_up::MotorRunUp)
}

/// The saw gin in its consistent reading.
pub(crate) fn saw_gin() -> Machine {
    Machine::new(&scenes::saw_gin::SawGin)
}

/// The saw gin as printed.
pub(crate) fn saw_gin_as_printed() -> Machine {
    Machine::new(&scenes::saw_gin_as_printed::SawGinAsPrinted)
}

/// The motor alone, in charges.
pub(crate) fn motor_stationary_axes() -> Machine {
    Machine::new(&scenes::motor_stationary_axes::MotorStationaryAxes)
}

/// The bobbin on a linear layer.
pub(crate) fn winder_linear() -> Machine {
    Machine::new(&scenes::winder_linear::WinderLinear)
}

/// The bobbin by the equation as printed.
pub(crate) fn winder_linear_as_printed() -> Machine {
    Machine::new(&scenes::winder_linear_as_printed::WinderLinearAsPrinted)
}

/// The bobbin on a stiffening layer.
pub(crate) fn winder_nonlinear() -> Machine {
    Machine::new(&scenes::winder_nonlinear::WinderNonlinear)
}

/// The bobbin with all nonlinearities.
pub(crate) fn winder_full() -> Machine {
    Machine::new(&scenes::winder_full::WinderFull)
}

/// Three pendulums hanging on one another.
pub(crate) fn pendulum_chain() -> Machine {
    Machine::new(&scenes::pendulum_chain::PendulumChain)
}

/// The same by relative angles.
pub(crate) fn pendulum_relative() -> Machine {
    Machine::new(&scenes::pendulum_relative::PendulumRelative)
}

/// The same by constraints.
pub(crate) fn pendulum_constrained() -> Machine {
    Machine::new(&scenes::pendulum_constrained::PendulumConstrained)
}

/// A slider-crank turned at constant speed.
pub(crate) fn slider_crank() -> Machine {
    Machine::new(&scenes::slider_crank::SliderCrank)
}

/// A four-bar linkage under gravity.
pub(crate) fn four_bar() -> Machine {
    Machine::new(&scenes::four_bar::FourBar)
}

/// The four-link bobbin holder.
pub(crate) fn winder_linkage() -> Machine {
    Machine::new(&scenes::winder_linkage::WinderLinkage)
}

/// The holder let go, its contacts one-sided.
pub(crate) fn winder_holder_drop() -> Machine {
    Machine::new(&scenes::winder_holder_drop::WinderHolderDrop)
}

/// A mass bouncing on a shaken plate.
pub(crate) fn bouncing_mass() -> Machine {
    Machine::new(&scenes::bouncing_mass::BouncingMass)
}

/// An oscillator braked by dry friction.
pub(crate) fn coulomb_oscillator() -> Machine {
    Machine::new(&scenes::coulomb_oscillator::CoulombOscillator)
}

/// A mass that sticks to a belt and slips.
pub(crate) fn stick_slip() -> Machine {
    Machine::new(&scenes::stick_slip::StickSlip)
}

/// Its smooth twin.
pub(crate) fn stick_slip_smooth() -> Machine {
    Machine::new(&scenes::stick_slip_smooth::StickSlipSmooth)
}

/// An oscillator with a stop on one side.
pub(crate) fn contact_oscillator() -> Machine {
    Machine::new(&scenes::contact_oscillator::ContactOscillator)
}

/// Its smooth twin.
pub(crate) fn contact_oscillator_smooth() -> Machine {
    Machine::new(&scenes::contact_oscillator_smooth::ContactOscillatorSmooth)
}

/// The uniform shaft, cut coarsely: checks over refinements cut it anew.
pub(crate) fn shaft_step_torque() -> Machine {
    Machine::with_fields("shaft_step_torque")
}

/// The reed on its driven shaft, likewise.
pub(crate) fn reed_beat_up() -> Machine {
    Machine::with_fields("reed_beat_up")
}

/// The reed against a fell that only pushes, likewise.
pub(crate) fn reed_beat_up_one_sided() -> Machine {
    Machine::with_fields("reed_beat_up_one_sided")
}

/// The saw gin with a distributed shaft, likewise.
pub(crate) fn saw_gin_shaft() -> Machine {
    Machine::with_fields("saw_gin_shaft")
}

/// Motor, coupling, shaft and reed, likewise.
pub(crate) fn loom_drive() -> Machine {
    Machine::with_fields("loom_drive")
}

/// The shaft between rotors, likewise.
pub(crate) fn shaft_with_rotors() -> Machine {
    Machine::with_fields("shaft_with_rotors")
}

impl Machine {
    /// Returns a scene with fields, with few elements. The simulators are made once per thread and
    /// live as long as the program, like emitted ones.
    ///
    /// # Panics
    /// If no scene with fields of this name is built in.
    fn with_fields(name: &'static str) -> Self {
        type Cut = (&'static str, &'static dyn Simulator<f64>, &'static dyn Values);
        thread_local! {
            static CUT: RefCell<Vec<Cut>> = const { RefCell::new(Vec::new()) };
        }
        const FEW: Discretisation = Discretisation { elements: Some(4), order: Some(2) };
        CUT.with_borrow_mut(|known| {
            if let Some((_, real, complex)) = known.iter().find(|(other, ..)| *other == name) {
                return Self::of(name, *real, *complex);
            }
            let missing = "scenes that are verified are built in";
            let real = scenes::find_field_f64(name).expect(missing);
            let complex = scenes::find_field(name).expect(missing);
            let four = "every scene has fewer than four stretches between ports";
            let real: &'static FieldSimulator<'static, f64> =
                Box::leak(Box::new(FieldSimulator::new(real, FEW).expect(four)));
            let complex: &'static FieldSimulator<'static, ComplexStep> =
                Box::leak(Box::new(FieldSimulator::new(complex, FEW).expect(four)));
            known.push((name, real.single(), complex));
            Self::of(name, real.single(), complex)
        })
    }

    /// # Panics
    /// If the scene is not built in.
    fn new(scene: &'static impl Simulator<ComplexStep>) -> Self {
        let real = scenes::find_f64(scene.name()).expect("scenes that are verified are built in");
        Self::of(real.name(), real, scene)
    }

    fn of(
        name: &'static str,
        real: &'static dyn Simulator<f64>,
        complex: &'static dyn Values,
    ) -> Self {
        Self { name, real, complex, overrides: Vec::new() }
    }

    /// Returns the name of the scene.
    pub(crate) fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the simulator of the scene; that of a scene with fields has few elements.
    pub(crate) fn simulator(&self) -> &'static dyn Simulator<f64> {
        self.real
    }

    pub(crate) fn override_parameter(
        &mut self,
        name: &str,
        value: f64,
    ) -> Result<(), CheckFailure> {
        let index = self.parameter_index(name)?;
        self.overrides.push((index, value));
        Ok(())
    }

    /// Returns the spec's parameters, modified by `settings` and then by the overrides.
    pub(crate) fn parameters(&self, settings: &[(&str, f64)]) -> Result<Vec<f64>, CheckFailure> {
        let count = self.real.shape().parameters;
        let mut values: Vec<f64> =
            (0..count).map(|index| self.real.parameter_default(index)).collect();
        for (name, value) in settings {
            values[self.parameter_index(name)?] = *value;
        }
        for (index, value) in &self.overrides {
            values[*index] = *value;
        }
        Ok(values)
    }

    /// Returns the value of one parameter in the spec, or its override.
    pub(crate) fn value(&self, name: &str) -> Result<f64, CheckFailure> {
        Ok(self.parameters(&[])?[self.parameter_index(name)?])
    }

    /// Returns a run with these settings.
    pub(crate) fn simulation(
        &self,
        settings: &[(&str, f64)],
    ) -> Result<Simulation<'static>, CheckFailure> {
        Ok(Simulation::new(self.real).parameters(&self.parameters(settings)?))
    }

    /// Returns a run whose errors are near rounding: relative tolerance 1e-12 and absolute
    /// tolerances of 1e-13 in the unit of each state, by the explicit method.
    pub(crate) fn precise(
        &self,
        settings: &[(&str, f64)],
        until: f64,
    ) -> Result<Simulation<'static>, CheckFailure> {
        let atol = vec![1e-13; self.real.shape().states()];
        let run = self.simulation(settings)?.until(until).rtol(1e-12).atol(&atol);
        Ok(run.method(Method::Dop853))
    }

    /// Returns the linearization with these settings at a place.
    pub(crate) fn linearization(
        &self,
        settings: &[(&str, f64)],
        place: Place,
    ) -> Result<Linearization<'static>, CheckFailure> {
        let point = operating_point(&self.simulation(settings)?, place)?;
        Ok(Linearization::at(self.real, point)?)
    }

    /// Returns a column of one of this scene's runs.
    pub(crate) fn column<'t>(
        &self,
        trajectory: &'t Trajectory,
        name: &str,
    ) -> Result<&'t [f64], CheckFailure> {
        trajectory.column(name).ok_or_else(|| self.unknown("column", name))
    }

    /// Returns the last value of a column.
    pub(crate) fn last(&self, trajectory: &Trajectory, name: &str) -> Result<f64, CheckFailure> {
        trajectory.last(name).ok_or_else(|| self.unknown("column", name))
    }

    /// Returns the index of a parameter.
    pub(crate) fn parameter_index(&self, name: &str) -> Result<usize, CheckFailure> {
        let count = self.real.shape().parameters;
        self.position("parameter", name, count, |index| self.real.parameter(index))
    }

    /// Returns the index of a state.
    pub(crate) fn state_index(&self, name: &str) -> Result<usize, CheckFailure> {
        let count = self.real.shape().states();
        self.position("state", name, count, |index| self.real.state(index))
    }

    /// Returns the index of an output.
    pub(crate) fn output_index(&self, name: &str) -> Result<usize, CheckFailure> {
        let count = self.real.shape().outputs;
        self.position("output", name, count, |index| self.real.output(index))
    }

    fn position<'a>(
        &self,
        kind: &'static str,
        name: &str,
        count: usize,
        quantity: impl Fn(usize) -> Quantity<'a>,
    ) -> Result<usize, CheckFailure> {
        (0..count)
            .find(|index| quantity(*index).name == name)
            .ok_or_else(|| self.unknown(kind, name))
    }

    fn unknown(&self, kind: &'static str, name: &str) -> CheckFailure {
        CheckFailure::UnknownQuantity { scene: self.name, kind, name: name.to_owned() }
    }

    /// Returns y' at a point.
    pub(crate) fn rate(&self, point: &Point) -> Vec<f64> {
        let mut rate = vec![0.0; point.state.len()];
        self.real.rate(point.time, &point.state, &point.parameters, &mut rate);
        rate
    }

    /// Returns the emitted dy'/dy at a point as a dense matrix.
    pub(crate) fn rate_jacobian(&self, point: &Point) -> DMatrix<f64> {
        let pattern = self.real.rate_jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        self.real.rate_jacobian(point.time, &point.state, &point.parameters, &mut values);
        complex_step::dense(pattern, &values)
    }

    /// Returns the emitted dy'/dp at a point as a dense matrix.
    pub(crate) fn parameter_jacobian(&self, point: &Point) -> DMatrix<f64> {
        let pattern = self.real.parameter_jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        self.real.parameter_jacobian(point.time, &point.state, &point.parameters, &mut values);
        complex_step::dense(pattern, &values)
    }

    /// Returns the point about which a scene was linearized.
    pub(crate) fn point_of(linearization: &Linearization<'_>) -> Point {
        let LinearPoint { time, state, parameters } = linearization.point().clone();
        Point { time, state, parameters }
    }

    /// Returns an output at a point.
    pub(crate) fn output(&self, point: &Point, name: &str) -> Result<f64, CheckFailure> {
        let mut outputs = vec![0.0; self.real.shape().outputs];
        self.real.outputs(point.time, &point.state, &point.parameters, &mut outputs);
        Ok(outputs[self.output_index(name)?])
    }

    /// Returns the point at t = 0 with states from `settings`, and zero otherwise.
    pub(crate) fn point(
        &self,
        parameters: &[(&str, f64)],
        settings: &[(&str, f64)],
    ) -> Result<Point, CheckFailure> {
        let mut state = vec![0.0; self.real.shape().states()];
        for (name, value) in settings {
            state[self.state_index(name)?] = *value;
        }
        Ok(Point { time: 0.0, state, parameters: self.parameters(parameters)? })
    }

    /// Returns the point at t = 0 at which the states named `unknowns` are at rest. All other
    /// states are those of `settings` or zero.
    ///
    /// Makes one Newton step from zero with the emitted rates and Jacobian. It is exact where rates
    /// are linear in the unknowns, such as those of a motor in its flux linkages at given speed.
    pub(crate) fn steady_point(
        &self,
        parameters: &[(&str, f64)],
        settings: &[(&str, f64)],
        unknowns: &[&str],
    ) -> Result<Point, CheckFailure> {
        let mut point = self.point(parameters, settings)?;
        let places =
            unknowns.iter().map(|name| self.state_index(name)).collect::<Result<Vec<_>, _>>()?;
        let rate = self.rate(&point);
        let jacobian = self.rate_jacobian(&point).select_rows(&places).select_columns(&places);
        let rest = DVector::from_iterator(places.len(), places.iter().map(|place| -rate[*place]));
        let solution = jacobian.lu().solve(&rest).ok_or(CheckFailure::Singular)?;
        for (place, value) in places.iter().zip(solution.iter()) {
            point.state[*place] = *value;
        }
        Ok(point)
    }

    /// Returns reproducible points, drawn uniformly from the times of the scene's run and from
    /// states within their scales. Every fourth state is a hundredth as large, so that loads are
    /// evaluated near standstill too.
    ///
    /// For a machine with constraints, these are states of its run, moved by a tenth of their
    /// scales and projected onto the constraints: elsewhere it may be near a dead point.
    pub(crate) fn random_points(&self, count: usize) -> Result<Vec<Point>, CheckFailure> {
        let defaults = self.real.run_defaults();
        let parameters = self.parameters(&[])?;
        let mut random = SplitMix(0x5eed);
        let is_constrained = self.real.constraints() > 0;
        let visited = if is_constrained { self.visited(count)? } else { Vec::new() };
        let mut points = Vec::with_capacity(count);
        for number in 0..count {
            let size = if number % 4 == 3 { 0.01 } else { 1.0 };
            let states = 0..self.real.shape().states();
            let share = random.unit();
            let drawn = states.map(|index| size * self.real.state_scale(index) * random.signed());
            let mut state: Vec<f64> = drawn.collect();
            let mut time = defaults.from + (defaults.until - defaults.from) * share;
            if let Some((at, there)) = visited.get(number) {
                time = *at;
                for (index, (value, there)) in state.iter_mut().zip(there).enumerate() {
                    let shift = if self.real.is_mode(index) { 0.0 } else { 0.1 * *value };
                    *value = there + shift;
                }
            }
            let point = Point { time, state, parameters: parameters.clone() };
            points.push(self.on_constraints(&point));
        }
        Ok(points)
    }

    /// Returns states at equally spaced times of the run.
    fn visited(&self, count: usize) -> Result<Vec<(f64, Vec<f64>)>, CheckFailure> {
        let run = self.simulation(&[])?.points(count.max(2)).run()?;
        let columns: Vec<&[f64]> =
            run.of_kind(ColumnKind::State).map(|column| column.values.as_slice()).collect();
        let state = |sample: usize| columns.iter().map(|column| column[sample]).collect();
        Ok(run.times.iter().enumerate().map(|(sample, time)| (*time, state(sample))).collect())
    }

    /// Returns the point projected onto the constraints, if there are any; NaN if that fails.
    pub(crate) fn on_constraints(&self, point: &Point) -> Point {
        let Point { time, mut state, parameters } = point.clone();
        if let Some(constraints) = Constraints::of(self.real, &parameters) {
            let put = |level| constraints.put_back(level, time, &mut state);
            if [Level::Positions, Level::Velocities].into_iter().try_for_each(put).is_err() {
                state.fill(f64::NAN);
            }
        }
        Point { time, state, parameters }
    }
}

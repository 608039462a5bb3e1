//! Exact partial derivatives, from the Jacobians of the model and its functions of dual numbers.
//!
//! Unknowns are rates of states, outputs and event indicators; before the start also states that
//! are calculated. Knowns are continuous states, inputs and time; before the start also parameters.
//! The values calculated from a parameter at the start then change with it.

use machinist::hosted::{Hosted, Standing};
use machinist_contract::{Derivatives, Dual, DualFunction, SparsityPattern};

use super::values::{Type, require_count};
use super::{Instance, Phase, Refusal};
use crate::variables::{Causality, Initial, Kind};

/// Direction in the space of everything that a machine's functions read.
#[derive(Debug, Clone)]
struct Move {
    time: f64,
    state: Vec<f64>,
    parameters: Vec<f64>,
}

/// Derivatives of everything that a host may ask for, along up to [`Dual::DIRECTIONS`] directions.
struct Moved<'a> {
    instance: &'a Instance,
    exact: &'a dyn Derivatives,
    standing: &'a Standing,
    moves: [Move; Dual::DIRECTIONS],
    on_duals: [Vec<Dual>; 3],
    rates: Vec<[f64; Dual::DIRECTIONS]>,
}

/// Results that are asked for.
#[derive(Debug, Clone, Copy, Default)]
struct Asked {
    rates: bool,
    outputs: bool,
    indicators: bool,
}

impl Instance {
    /// Computes `sensitivity = (d unknowns / d knowns) seed`.
    ///
    /// # Errors
    /// [`Refusal`] for variables that are not unknowns or knowns at this time, and before the start
    /// if constraints or the search for an equilibrium determine the start.
    pub fn directional_derivative(
        &mut self,
        (unknowns, knowns): (&[u32], &[u32]),
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Refusal> {
        require_count(knowns.len(), seed.len())?;
        require_count(unknowns.len(), sensitivity.len())?;
        let (unknowns, knowns) = self.unknowns_and_knowns(unknowns, knowns)?;
        self.start()?;
        let (standing, exact) = (self.standing()?, self.exact()?);
        let mut along = self.still();
        for (known, seed) in knowns.iter().zip(seed) {
            self.add(exact, &mut along, *known, *seed);
        }
        let still = || self.still();
        let moves = [along, still(), still(), still()];
        let moved = Moved::new((self, exact), standing, moves, Asked::of(&unknowns));
        for (value, unknown) in sensitivity.iter_mut().zip(unknowns) {
            *value = moved.of(unknown)[0];
        }
        Ok(())
    }

    /// Computes `sensitivity^T = seed^T (d unknowns / d knowns)`.
    ///
    /// # Errors
    /// As [`Instance::directional_derivative`].
    pub fn adjoint_derivative(
        &mut self,
        (unknowns, knowns): (&[u32], &[u32]),
        seed: &[f64],
        sensitivity: &mut [f64],
    ) -> Result<(), Refusal> {
        require_count(unknowns.len(), seed.len())?;
        require_count(knowns.len(), sensitivity.len())?;
        let (unknowns, knowns) = self.unknowns_and_knowns(unknowns, knowns)?;
        self.start()?;
        let (standing, exact) = (self.standing()?, self.exact()?);
        let blocks = knowns.chunks(Dual::DIRECTIONS);
        for (knowns, into) in blocks.zip(sensitivity.chunks_mut(Dual::DIRECTIONS)) {
            let moves = std::array::from_fn(|direction| {
                let mut along = self.still();
                if let Some(known) = knowns.get(direction) {
                    self.add(exact, &mut along, *known, 1.0);
                }
                along
            });
            let moved = Moved::new((self, exact), standing, moves, Asked::of(&unknowns));
            into.fill(0.0);
            for (unknown, seed) in unknowns.iter().zip(seed) {
                for (value, slope) in into.iter_mut().zip(moved.of(*unknown)) {
                    *value += seed * slope;
                }
            }
        }
        Ok(())
    }

    /// Computes the rates of outputs along the motion, with constant inputs.
    ///
    /// # Errors
    /// [`Refusal`] for variables that are not outputs, for orders other than 1, and outside the
    /// modes of a run by Co-Simulation.
    pub fn output_derivatives(
        &mut self,
        references: &[u32],
        orders: &[i32],
        values: &mut [f64],
    ) -> Result<(), Refusal> {
        let call = "fmi3GetOutputDerivatives";
        self.require_simulation(call)?;
        self.require(call, &[Phase::Step, Phase::Intermediate, Phase::Event, Phase::Terminated])?;
        require_count(references.len(), orders.len())?;
        require_count(references.len(), values.len())?;
        let mut outputs = Vec::new();
        for (reference, order) in references.iter().zip(orders) {
            let variable = self.variable(*reference, Type::Float64)?;
            if variable.causality != Causality::Output || *order != 1 {
                let message =
                    format!("there is no derivative of order {order} of `{}`", variable.name);
                return Err(Refusal::Argument(message));
            }
            outputs.push(variable.kind);
        }
        let (standing, exact) = (self.standing()?, self.exact()?);
        let mut along = self.still();
        along.time = 1.0;
        along.state = self.rate(standing);
        let still = || self.still();
        let asked = Asked { outputs: true, ..Asked::default() };
        let moves = [along, still(), still(), still()];
        let moved = Moved::new((self, exact), standing, moves, asked);
        for (value, output) in values.iter_mut().zip(outputs) {
            *value = moved.of(output)[0];
        }
        Ok(())
    }

    /// Returns the machine's functions of dual numbers.
    fn exact(&self) -> Result<&dyn Derivatives, Refusal> {
        let missing = || Refusal::argument("a machine with fields has no exact derivatives");
        self.machine.simulator().derivatives().ok_or_else(missing)
    }

    fn unknowns_and_knowns(
        &self,
        unknowns: &[u32],
        knowns: &[u32],
    ) -> Result<(Vec<Kind>, Vec<Kind>), Refusal> {
        let phase = self.now.phase;
        if matches!(phase, Phase::Instantiated | Phase::Terminated) {
            return Err(Refusal::OutOfOrder { call: "derivatives", phase });
        }
        let is_before = phase == Phase::Initialization;
        let simulator = self.machine.simulator();
        if is_before && (simulator.constraints() > 0 || simulator.starts_in_equilibrium()) {
            let by = if simulator.starts_in_equilibrium() {
                "is an equilibrium found by a search"
            } else {
                "constraints determine"
            };
            let message = format!("there are no derivatives of a start that {by}");
            return Err(Refusal::Argument(message));
        }
        let each = |references: &[u32], may: &dyn Fn(Kind, Causality) -> bool, what: &str| {
            let kind = |reference: &u32| {
                let variable = self.variable(*reference, Type::Float64)?;
                if may(variable.kind, variable.causality) {
                    return Ok(variable.kind);
                }
                let message = format!("`{}` is no {what} in {phase:?} mode", variable.name);
                Err(Refusal::Argument(message))
            };
            references.iter().map(kind).collect::<Result<Vec<Kind>, Refusal>>()
        };
        let is_exact = |entry: usize| self.initial(entry) == Some(Initial::Exact);
        let is_unknown = |kind: Kind, causality: Causality| match kind {
            Kind::Derivative(_) | Kind::Output(_) | Kind::Indicator(_) => true,
            Kind::State(entry) => causality == Causality::Output || is_before && !is_exact(entry),
            _ => false,
        };
        let is_known = |kind: Kind, causality: Causality| match kind {
            Kind::Time => true,
            Kind::State(entry) => !is_before || is_exact(entry),
            Kind::Parameter(_) => is_before || causality == Causality::Input,
            _ => false,
        };
        Ok((each(unknowns, &is_unknown, "unknown")?, each(knowns, &is_known, "known")?))
    }

    fn still(&self) -> Move {
        let shape = self.machine.simulator().shape();
        let [state, parameters] = [shape.states(), shape.parameters].map(|count| vec![0.0; count]);
        Move { time: 0.0, state, parameters }
    }

    /// Adds a change of one known. Before the start, the values calculated from it change too.
    fn add(&self, exact: &dyn Derivatives, along: &mut Move, known: Kind, by: f64) {
        match known {
            Kind::Time => along.time += by,
            Kind::State(entry) => along.state[entry] += by,
            Kind::Parameter(index) => {
                along.parameters[index] += by;
                if self.now.phase == Phase::Initialization {
                    self.add_start(exact, along, index, by);
                }
            }
            _ => {}
        }
    }

    /// Adds the change of the start state with a parameter.
    fn add_start(&self, exact: &dyn Derivatives, along: &mut Move, parameter: usize, by: f64) {
        let mut parameters: Vec<Dual> =
            self.now.parameters.iter().map(|value| Dual::constant(*value)).collect();
        parameters[parameter].slopes[0] = by;
        let mut state = vec![Dual::constant(0.0); along.state.len()];
        let zero = Dual::constant(0.0);
        let function = DualFunction::InitialState;
        let still = state.clone();
        exact.on_duals(function, zero, &still, &parameters, &mut state);
        for (entry, value) in state.iter().enumerate() {
            if self.initial(entry) == Some(Initial::Calculated) {
                along.state[entry] += value.slopes[0];
            }
        }
    }
}

impl Asked {
    fn of(unknowns: &[Kind]) -> Self {
        let any = |is: fn(&Kind) -> bool| unknowns.iter().any(is);
        Self {
            rates: any(|kind| matches!(kind, Kind::Derivative(_))),
            outputs: any(|kind| matches!(kind, Kind::Output(_))),
            indicators: any(|kind| matches!(kind, Kind::Indicator(_))),
        }
    }
}

impl<'a> Moved<'a> {
    fn new(
        (instance, exact): (&'a Instance, &'a dyn Derivatives),
        standing: &'a Standing,
        moves: [Move; Dual::DIRECTIONS],
        asked: Asked,
    ) -> Self {
        let on_duals = [Vec::new(), Vec::new(), Vec::new()];
        let mut moved = Self { instance, exact, standing, moves, on_duals, rates: Vec::new() };
        let simulator = instance.machine.simulator();
        if asked.rates {
            moved.rates = moved.rates();
        }
        if asked.outputs {
            let count = simulator.shape().outputs;
            moved.on_duals[0] = moved.on_duals(DualFunction::Outputs, count);
        }
        if asked.indicators {
            let counts = [simulator.events(), simulator.kinks()];
            moved.on_duals[1] = moved.on_duals(DualFunction::Guards, counts[0]);
            moved.on_duals[2] = moved.on_duals(DualFunction::KinkGuards, counts[1]);
        }
        moved
    }

    /// Returns the derivatives of one variable.
    fn of(&self, unknown: Kind) -> [f64; Dual::DIRECTIONS] {
        match unknown {
            Kind::Derivative(entry) => self.rates[entry],
            Kind::State(entry) => std::array::from_fn(|k| self.moves[k].state[entry]),
            Kind::Output(index) => self.on_duals[0][index].slopes,
            Kind::Indicator(index)
                if self.standing.is_watched(self.instance.machine.simulator(), index) =>
            {
                let mut all = self.on_duals[1].iter().chain(&self.on_duals[2]);
                let simulator = self.instance.machine.simulator();
                let hosted = Hosted::new(simulator, &self.instance.now.parameters);
                all.nth(index).map_or([0.0; Dual::DIRECTIONS], |guard| {
                    let factor = hosted.indicator_slope(self.standing, index, guard.value);
                    guard.slopes.map(|slope| factor * slope)
                })
            }
            _ => [0.0; Dual::DIRECTIONS],
        }
    }

    /// Computes the derivatives of all rates: (dy'/dt) dt + (dy'/dy) dy + (dy'/dp) dp.
    fn rates(&self) -> Vec<[f64; Dual::DIRECTIONS]> {
        let Self { instance, standing, moves, .. } = self;
        let simulator = instance.machine.simulator();
        let (time, state) = (standing.within(standing.time), &standing.state[..]);
        let parameters = &standing.held_parameters(&instance.now.parameters)[..];
        let mut by_time = vec![0.0; state.len()];
        simulator.time_derivative(time, state, parameters, &mut by_time);
        let of_time = |slope: &f64| std::array::from_fn(|k| slope * moves[k].time);
        let mut rates: Vec<[f64; Dual::DIRECTIONS]> = by_time.iter().map(of_time).collect();
        let mut add = |pattern: SparsityPattern<'_>, values: &[f64], of: fn(&Move) -> &[f64]| {
            for ((row, column), value) in pattern.entries.iter().zip(values) {
                for (sum, along) in rates[*row as usize].iter_mut().zip(moves) {
                    let by = of(along)[*column as usize];
                    // An infinite slope contributes nothing along a zero direction.
                    *sum += if by == 0.0 { 0.0 } else { value * by };
                }
            }
        };
        let pattern = simulator.rate_jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        simulator.rate_jacobian(time, state, parameters, &mut values);
        add(pattern, &values, |along| &along.state);
        let pattern = simulator.parameter_jacobian_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        simulator.parameter_jacobian(time, state, parameters, &mut values);
        add(pattern, &values, |along| &along.parameters);
        rates
    }

    fn on_duals(&self, function: DualFunction, count: usize) -> Vec<Dual> {
        let Self { instance, exact, standing, moves, .. } = self;
        let mut values = vec![Dual::constant(0.0); count];
        if count == 0 {
            return values;
        }
        let dual = |value: f64, slope: &dyn Fn(&Move) -> f64| Dual {
            value,
            slopes: std::array::from_fn(|k| slope(&moves[k])),
        };
        let time = dual(standing.within(standing.time), &|along| along.time);
        let state = standing.state.iter().enumerate();
        let state: Vec<Dual> =
            state.map(|(entry, value)| dual(*value, &|along| along.state[entry])).collect();
        let parameters = standing.held_parameters(&instance.now.parameters);
        // Slots have zero slopes.
        let parameters: Vec<Dual> = (0..)
            .zip(&parameters)
            .map(|(index, value): (usize, _)| {
                dual(*value, &|along| along.parameters.get(index).copied().unwrap_or(0.0))
            })
            .collect();
        exact.on_duals(function, time, &state, &parameters, &mut values);
        values
    }
}

//! Comparison of a simulator with the second derivation of its scene.

use std::collections::BTreeMap;

use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Symbol};
use machinist_contract::{Real, Simulator};
use num_traits::ToPrimitive as _;

use super::formula::Formula;
use super::lift::Entries;
use super::motion::{Machine, Motion, Place};
use super::random::Random;
use super::rounded::Rounded;
use crate::scene::system::LagrangianSystem;

/// A point at which a simulator is evaluated.
#[derive(Debug, Clone, Copy)]
pub struct At<'a> {
    /// t \[s\].
    pub time: f64,
    /// y.
    pub state: &'a [f64],
    /// p.
    pub parameters: &'a [f64],
}

/// A name of a state, parameter or output of a simulator that its scene does not have.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the scene has nothing that is called `{0}`")]
pub struct Unlike(pub String);

/// The largest difference.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Deviation {
    /// |simulator - second derivation|, relative to the sum of the sizes of the number's terms.
    /// For an acceleration these are the effects of its forces one by one.
    pub error: f64,
    /// The quantity that differs, and the time.
    pub place: String,
    /// Number of comparisons.
    pub compared: usize,
}

impl Deviation {
    /// Returns the larger of two deviations.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        let compared = self.compared + other.compared;
        let worse = if other.error > self.error || other.error.is_nan() { other } else { self };
        Self { compared, ..worse }
    }

    fn take(&mut self, error: f64, place: impl FnOnce() -> String) {
        self.compared += 1;
        if error > self.error || (error.is_nan() && !self.error.is_nan()) {
            (self.error, self.place) = (error, place());
        }
    }
}

/// A simulator and the system it should agree with, whose formulas have numbers of type `R`.
pub struct Comparison<'a, R> {
    system: &'a LagrangianSystem,
    simulator: &'a dyn Simulator<f64>,
    machine: Machine<R>,
    entries: Entries,
    outputs: Vec<(String, Formula<Rounded<R>>)>,
    /// Guards and resets (entry of the state, new value), event by event.
    events: Vec<Happening<R>>,
    /// Constraint of the system for each of the simulator's.
    constraints: Vec<usize>,
}

struct Happening<R> {
    name: String,
    /// Modes (entries of the state) and the values at which the event is active.
    when: Vec<(usize, f64)>,
    guard: Formula<Rounded<R>>,
    sets: Vec<Formula<Rounded<R>>>,
}

impl<'a, R: Real> Comparison<'a, R> {
    /// Prepares the comparison of a system without fields with a simulator; `to_f64` returns the
    /// nearest `f64` of a number. Springs that the system freezes are rigid. For a simulator that
    /// keeps them, the system must freeze none.
    ///
    /// # Errors
    /// [`Unlike`] if the simulator is not of that system.
    pub fn new(
        system: &'a LagrangianSystem,
        simulator: &'a dyn Simulator<f64>,
        to_f64: fn(R) -> f64,
    ) -> Result<Self, Unlike> {
        let unlike = |name: &str| Unlike(name.to_owned());
        let entries = Entries::new(system, simulator)?;
        let mut outputs = Vec::new();
        for index in 0..simulator.shape().outputs {
            let name = simulator.output(index).name;
            let mut wanted = system.outputs.iter();
            let output = wanted.find(|output| output.quantity.name.path == name);
            let output = output.ok_or_else(|| unlike(name))?;
            outputs.push((name.to_owned(), Formula::new(&output.expr)));
        }
        let mut events = Vec::new();
        for index in 0..simulator.events() {
            let described = simulator.event(index);
            let mut known = system.events.iter();
            let event = known.find(|event| event.name.path == described.name);
            let event = event.ok_or_else(|| unlike(described.name))?;
            let mut sets = Vec::new();
            for entry in described.sets {
                let name = simulator.state(*entry as usize).name;
                let set = event.set.iter().find(|(symbol, _)| called(system, *symbol) == name);
                let (_, value) = set.ok_or_else(|| unlike(name))?;
                sets.push(Formula::new(value));
            }
            let when = described.when.iter().map(|(entry, value)| (*entry as usize, *value));
            events.push(Happening {
                name: described.name.to_owned(),
                when: when.collect(),
                guard: Formula::new(&event.guard),
                sets,
            });
        }
        let mut constraints = Vec::new();
        for index in 0..simulator.constraints() {
            let name = simulator.constraint(index).name;
            let mut known = system.constraints.iter();
            let found = known.position(|constraint| constraint.name.path == name);
            constraints.push(found.ok_or_else(|| unlike(name))?);
        }
        let machine = Machine::new(system, to_f64);
        Ok(Self { system, simulator, machine, entries, outputs, events, constraints })
    }

    /// Compares the initial state, its rate, outputs, guards with resets, and constraints.
    /// Returns the largest difference at `count` random places around the start, near and far.
    #[must_use]
    pub fn at_random(&self, count: usize, parameters: &[f64], seed: u64) -> Deviation {
        /// Distances relative to the scales of states.
        const DISTANCES: [f64; 4] = [1.0, 0.1, 0.5, 0.01];
        let mut random = Random(seed);
        let start = self.start(parameters);
        let modes = self.values_of_modes(&start);
        let run = &self.system.run;
        let mut found = self.at_start(parameters, &start);
        for index in 0..count {
            let distance = DISTANCES[index % DISTANCES.len()];
            let mut state = start.clone();
            for (entry, value) in state.iter_mut().enumerate() {
                match modes.get(&entry) {
                    Some(values) => *value = values[random.below(values.len())],
                    None => {
                        *value += distance * self.simulator.state_scale(entry) * random.signed();
                    }
                }
            }
            let time = run.from + (run.until - run.from) * random.unit();
            found = found.or(self.at(&At { time, state: &state, parameters }, &mut random));
        }
        found
    }

    /// Returns the largest difference at given places.
    #[must_use]
    pub fn at_places<'p>(&self, places: impl Iterator<Item = At<'p>>, seed: u64) -> Deviation {
        let mut random = Random(seed);
        places.map(|at| self.at(&at, &mut random)).fold(Deviation::default(), Deviation::or)
    }

    fn start(&self, parameters: &[f64]) -> Vec<f64> {
        let mut start = vec![0.0; self.simulator.shape().states()];
        self.simulator.initial_state(parameters, &mut start);
        start
    }

    /// Returns the initial values of modes, and those that events require or set.
    fn values_of_modes(&self, start: &[f64]) -> BTreeMap<usize, Vec<f64>> {
        let modes = self.entries.first_order.iter().filter(|(entry, _)| self.is_mode(*entry));
        let values = modes.map(|(entry, mode)| {
            let id = FirstOrderId(*mode as u32);
            let mut values = vec![start[*entry]];
            for event in &self.system.events {
                let asked = event.when.iter().filter(|(mode, _)| *mode == id);
                values.extend(asked.map(|(_, value)| f64::from(*value)));
                let set = event.set.iter().filter(|(set, _)| *set == Symbol::FirstOrder(id));
                values.extend(set.filter_map(|(_, value)| match value {
                    Expr::Number(number) => number.to_f64(),
                    _ => None,
                }));
            }
            (*entry, values)
        });
        values.collect()
    }

    fn is_mode(&self, entry: usize) -> bool {
        self.simulator.is_mode(entry)
    }

    /// Compares the initial y.
    fn at_start(&self, parameters: &[f64], start: &[f64]) -> Deviation {
        let mut found = Deviation::default();
        let all = self.entries.parameters::<R>(self.system, parameters);
        let place = Place::of_parameters(all);
        let value = |expr: &Expr| self.machine.value(&Formula::new(expr), &place, None);
        let coordinates = &self.system.coordinates;
        let q: Vec<Rounded<R>> = coordinates.iter().map(|q| value(&q.initial[0])).collect();
        let at = At { time: self.system.run.from, state: start, parameters };
        let n = coordinates.len();
        let rows = self.entries.positions_by_coordinates(self.simulator, &at, n);
        let positions = rows.iter().zip(&self.entries.positions);
        let mut positions: Vec<(usize, Rounded<R>)> =
            positions.map(|(row, entry)| (*entry, row_times(row, &q))).collect();
        if !self.system.orientations.is_empty() {
            let scalars = self.system.scalars.iter().map(|scalar| value(&scalar.initial));
            let all = q.iter().copied().chain(scalars);
            positions = self.entries.positions.iter().copied().zip(all).collect();
        }
        let positions = positions.into_iter();
        let velocities = self.entries.velocities.iter();
        let velocities = velocities.map(|(entry, i)| (*entry, value(&coordinates[*i].initial[1])));
        let first_order = self.entries.first_order.iter();
        let first_order =
            first_order.map(|(entry, k)| (*entry, value(&self.system.first_order[*k].initial)));
        for (entry, expected) in positions.chain(velocities).chain(first_order) {
            self.judge(&mut found, start[entry], expected, || {
                format!("{} at the start", self.simulator.state(entry).name)
            });
        }
        found
    }

    /// Compares everything at one place. If a machine starts on a switching surface, rounding
    /// decides on which side. A difference at a single point that vanishes beside it is due to
    /// that.
    fn at(&self, at: &At<'_>, random: &mut Random) -> Deviation {
        /// Distance relative to the scales of states.
        const ASIDE: f64 = 1e-6;
        const NEIGHBOURS: usize = 3;
        const AGREE: f64 = 1e-11;
        let found = self.exactly_at(at, random);
        if found.error <= AGREE {
            return found;
        }
        let beside = (0..NEIGHBOURS).map(|_| {
            let mut state = at.state.to_vec();
            for (entry, value) in state.iter_mut().enumerate() {
                if !self.is_mode(entry) {
                    *value += ASIDE * self.simulator.state_scale(entry) * random.signed();
                }
            }
            self.exactly_at(&At { state: &state, ..*at }, random)
        });
        let beside = beside.fold(Deviation::default(), Deviation::or);
        if beside.compared > 0 && beside.error <= AGREE { beside } else { found }
    }

    /// Compares at exactly this place; no comparison if the equations do not determine the
    /// motion.
    fn exactly_at(&self, at: &At<'_>, random: &mut Random) -> Deviation {
        let mut found = Deviation::default();
        let n = self.system.coordinates.len();
        let rows = self.entries.positions_by_coordinates(self.simulator, at, n);
        let place = self.entries.place(self.system, &self.machine, at, &rows, random);
        let Some(place) = place else { return found };
        let Some(motion) = self.machine.motion(&place) else { return found };
        self.rates(&mut found, at, &place, &motion, &rows);
        self.outputs(&mut found, at, &place, &motion);
        self.events(&mut found, at, &place, &motion);
        self.constraints(&mut found, at, &place);
        found
    }

    fn rates(
        &self,
        found: &mut Deviation,
        at: &At<'_>,
        place: &Place<R>,
        motion: &Motion<R>,
        rows: &[Vec<f64>],
    ) {
        let mut rate = vec![0.0; at.state.len()];
        self.simulator.rate(at.time, at.state, at.parameters, &mut rate);
        let positions = rows.iter().zip(&self.entries.positions);
        let v: Vec<Rounded<R>> = place.v.iter().map(|v| Rounded::new(*v)).collect();
        let has_quaternions = !self.system.orientations.is_empty();
        let positions = positions.enumerate().map(|(index, (row, entry))| {
            let quaternion = || self.machine.rate_of_position(index, place);
            (*entry, if has_quaternions { quaternion() } else { row_times(row, &v) })
        });
        let velocities = self.entries.velocities.iter();
        let velocities = velocities.map(|(entry, i)| (*entry, motion.accelerations[*i]));
        let first_order = self.entries.first_order.iter();
        let first_order = first_order.map(|(entry, k)| (*entry, motion.rates[*k]));
        let run = &self.system.run;
        for (entry, expected) in positions.chain(velocities).chain(first_order) {
            // At rest, rates are zero with 31 digits, and rounding errors with 16 digits.
            let least = NOTHING * self.simulator.state_scale(entry) / (run.until - run.from);
            let expected = Rounded { size: expected.size + R::literal(least), ..expected };
            self.judge(found, rate[entry], expected, || {
                format!("{}' at {} s", self.simulator.state(entry).name, at.time)
            });
        }
        // A position with a coordinate's own name moves with it, one to one.
        for (row, entry) in rows.iter().zip(&self.entries.positions) {
            let name = self.simulator.state(*entry).name;
            let mut all = self.system.coordinates.iter();
            let own = all.position(|coordinate| coordinate.position.name.path == name);
            let is_its_rate =
                |own: &usize| !self.system.orientations.contain(CoordinateId(*own as u32));
            if let Some(own) = own.filter(is_its_rate) {
                let one = Rounded::literal(1.0);
                self.judge(found, row[own], one, || format!("{name}' by its own velocity"));
            }
        }
    }

    fn outputs(&self, found: &mut Deviation, at: &At<'_>, place: &Place<R>, motion: &Motion<R>) {
        let mut values = vec![0.0; self.outputs.len()];
        self.simulator.outputs(at.time, at.state, at.parameters, &mut values);
        for ((name, formula), value) in self.outputs.iter().zip(values) {
            let expected = self.machine.value(formula, place, Some(motion));
            self.judge(found, value, expected, || format!("output {name} at {} s", at.time));
        }
    }

    fn events(&self, found: &mut Deviation, at: &At<'_>, place: &Place<R>, motion: &Motion<R>) {
        if self.events.is_empty() {
            return;
        }
        let mut guards = vec![0.0; self.events.len()];
        let mut resets = vec![0.0; self.events.iter().map(|event| event.sets.len()).sum()];
        self.simulator.guards(at.time, at.state, at.parameters, &mut guards);
        self.simulator.resets(at.time, at.state, at.parameters, &mut resets);
        let mut resets = resets.into_iter();
        for (event, guard) in self.events.iter().zip(guards) {
            let own: Vec<f64> = resets.by_ref().take(event.sets.len()).collect();
            // The guard of an inactive event may depend on the sign of a force that does not
            // exist.
            if event.when.iter().any(|(entry, mode)| (at.state[*entry] - mode).abs() >= 0.5) {
                continue;
            }
            let sets = own.into_iter().zip(&event.sets);
            for (value, formula) in std::iter::once((guard, &event.guard)).chain(sets) {
                let expected = self.machine.value(formula, place, Some(motion));
                self.judge(found, value, expected, || {
                    format!("event {} at {} s", event.name, at.time)
                });
            }
        }
    }

    fn constraints(&self, found: &mut Deviation, at: &At<'_>, place: &Place<R>) {
        let count = self.constraints.len();
        if count == 0 {
            return;
        }
        let (mut values, mut rates) = (vec![0.0; count], vec![0.0; count]);
        self.simulator.constraint_values(at.time, at.state, at.parameters, &mut values);
        self.simulator.constraint_rates(at.time, at.state, at.parameters, &mut rates);
        for (index, own) in self.constraints.iter().enumerate() {
            let Some(expected) = self.machine.held(*own, place) else { continue };
            for (value, expected) in [values[index], rates[index]].into_iter().zip(expected) {
                self.judge(found, value, expected, || {
                    let name = self.simulator.constraint(index).name;
                    format!("constraint {name} at {} s", at.time)
                });
            }
        }
    }

    /// Judges a difference. If the second derivation has no value, it is not counted.
    fn judge(
        &self,
        found: &mut Deviation,
        value: f64,
        expected: Rounded<R>,
        place: impl FnOnce() -> String,
    ) {
        let to_f64 = self.machine.to_f64;
        let [size, expects] = [expected.size, expected.value].map(to_f64);
        if !size.is_finite() || !expects.is_finite() {
            return;
        }
        let size = size.max(expects.abs());
        let off = to_f64(R::literal(value) - expected.value).abs();
        let error = if off == 0.0 { 0.0 } else { off / size };
        found.take(error, || format!("{}: {value:.9e} for {expects:.9e}", place()));
    }
}

/// Limit below which a rate counts as zero, as the change of a state within the run relative to
/// its scale.
const NOTHING: f64 = 1e-4;

/// Returns the product of a row of numbers and a column.
fn row_times<R: Real>(row: &[f64], column: &[Rounded<R>]) -> Rounded<R> {
    let entries = row.iter().zip(column).filter(|(factor, _)| **factor != 0.0);
    let products = entries.map(|(factor, part)| Rounded::literal(*factor) * *part);
    products.fold(Rounded::literal(0.0), |sum, part| sum + part)
}

/// Returns the name of a coordinate, velocity or first-order state.
fn called(system: &LagrangianSystem, symbol: Symbol) -> &str {
    let name = match symbol {
        Symbol::Coordinate(id) => &system.coordinates[id.0 as usize].position.name,
        Symbol::Velocity(id) => &system.coordinates[id.0 as usize].velocity.name,
        Symbol::FirstOrder(id) => &system.first_order[id.0 as usize].quantity.name,
        _ => return "",
    };
    &name.path
}

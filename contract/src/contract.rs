//! What every simulator offers: [`Describe`] (names, units, shapes, patterns)
//! and [`Simulator`] (the numbers).

use crate::Real;
use crate::dual::Derivatives;
use crate::linear::LinearEquations;
use crate::taylor::TaylorSeries;

/// Name, SI unit and meaning of one number of a simulator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity<'a> {
    /// The spec's own name, `instance.name`.
    pub name: &'a str,
    /// SI unit as the spec writes it; `1` for a pure number.
    pub unit: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
}

/// How many of everything a simulator has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shape {
    /// Generalized coordinates, n.
    pub coordinates: usize,
    /// Positions in the state: n, less those left out because nothing depends on
    /// them.
    pub positions: usize,
    /// First-order states, m.
    pub first_order: usize,
    /// How many of the last entries of the state are only integrated: no rate
    /// depends on them, so that an implicit method may leave them out of its
    /// iteration.
    pub quadratures: usize,
    /// Parameters.
    pub parameters: usize,
    /// Wanted outputs.
    pub outputs: usize,
    /// Times at which the right-hand side jumps.
    pub discontinuities: usize,
}

impl Shape {
    /// Length of the state: positions, velocities and first-order states.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.positions + self.coordinates + self.first_order
    }
}

/// What an entry of the state is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StateKind {
    /// A generalized coordinate, or the difference of two.
    Position,
    /// A generalized velocity; velocities stand in the order of the coordinates.
    Velocity,
    /// A first-order state.
    FirstOrder,
}

/// Structural nonzeros of a matrix, sorted by row, then by column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SparsityPattern<'a> {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// `(row, column)` of every entry, in the order in which values are stored.
    pub entries: &'a [(u32, u32)],
}

/// Which way a guard passes zero where its event happens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From below to above.
    Rising,
    /// From above to below.
    Falling,
    /// Either way.
    Both,
}

/// What happens where a guard, an expression of time and state, passes zero: some
/// entries of the state get new values at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event<'a> {
    /// The spec's own name, `instance.name`.
    pub name: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
    /// Which way the guard passes zero.
    pub direction: Direction,
    /// Entries of the state with the values that they must have for the event to be
    /// watched for; they are modes.
    pub when: &'a [(u32, f64)],
    /// Entries of the state that the event sets, in the order of
    /// [`Simulator::resets`].
    pub sets: &'a [u32],
}

/// What coordinates must fulfil: g(q, t) = 0, or a(q, t) q' + b(q, t) = 0. Its force on
/// the coordinates is G^T lambda.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Constraint<'a> {
    /// The spec's own name, `instance.name`.
    pub name: &'a str,
    /// SI unit of what is zero.
    pub unit: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
    /// Whether it is of positions; else it is of velocities alone.
    pub is_of_positions: bool,
    /// Whether it holds in some modes only: in others its row of G is zero.
    pub in_modes: bool,
}

impl<'a> Constraint<'a> {
    /// g(q, t) = 0.
    #[must_use]
    pub const fn of_positions(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self { name, unit, doc, is_of_positions: true, in_modes: false }
    }

    /// a(q, t) q' + b(q, t) = 0.
    #[must_use]
    pub const fn of_velocities(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self { name, unit, doc, is_of_positions: false, in_modes: false }
    }

    /// g(q, t) = 0 in some modes only.
    #[must_use]
    pub const fn of_positions_in_modes(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self { name, unit, doc, is_of_positions: true, in_modes: true }
    }

    /// a(q, t) q' + b(q, t) = 0 in some modes only.
    #[must_use]
    pub const fn of_velocities_in_modes(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self { name, unit, doc, is_of_positions: false, in_modes: true }
    }
}

/// The run a scene asks for unless told otherwise.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunDefaults<'a> {
    /// Start time \[s\].
    pub from: f64,
    /// End time \[s\].
    pub until: f64,
    /// Number of output times, both ends included; equally spaced unless `times` are given.
    pub points: usize,
    /// Output times \[s\] where they are not equally spaced, increasing; else empty.
    pub times: &'a [f64],
    /// Relative tolerance; the absolute one is this times the scale of the state.
    pub rtol: f64,
    /// Name of the method.
    pub method: &'a str,
}

/// Energy stored in a machine \[J\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy<R> {
    /// Kinetic energy T.
    pub kinetic: R,
    /// Potential energy V.
    pub potential: R,
    /// Energy of the first-order states, such as a motor's magnetic energy.
    pub stored: R,
}

impl<R: Real> Energy<R> {
    /// T + V + stored.
    #[must_use]
    pub fn total(&self) -> R {
        self.kinetic + self.potential + self.stored
    }
}

/// Power flows of a machine \[W\]; `stored_rate = supplied - dissipated`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerBalance<R> {
    /// dE/dt by the chain rule over the emitted energy and rate.
    pub stored_rate: R,
    /// Power of generalized forces, of supplies and of explicit time dependence.
    pub supplied: R,
    /// Power lost: q' dD/dq' and the losses of first-order states.
    pub dissipated: R,
}

impl<R: Real> PowerBalance<R> {
    /// dE/dt - supplied + dissipated; zero up to rounding.
    #[must_use]
    pub fn residual(&self) -> R {
        self.stored_rate - self.supplied + self.dissipated
    }
}

/// Why values of parameters make no machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refusal<'a> {
    /// The rule for the value: `the ratio of port \`gear.a\` is a number other than 0`.
    pub rule: &'a str,
    /// The value.
    pub value: f64,
}

/// Names, units, shapes and structure of a simulator.
pub trait Describe {
    /// The scene's name, a valid identifier.
    fn name(&self) -> &str;
    /// One line for people.
    fn title(&self) -> &str;
    /// Number of coordinates, states, parameters, outputs.
    fn shape(&self) -> Shape;
    /// The `index`-th state.
    ///
    /// # Panics
    /// If `index` is not below `shape().states()`; likewise below.
    fn state(&self, index: usize) -> Quantity<'_>;
    /// What the `index`-th state is. Positions come first, then velocities, then
    /// first-order states, unless a simulator says otherwise.
    fn state_kind(&self, index: usize) -> StateKind {
        let Shape { positions, coordinates, .. } = self.shape();
        match index {
            index if index < positions => StateKind::Position,
            index if index < positions + coordinates => StateKind::Velocity,
            _ => StateKind::FirstOrder,
        }
    }
    /// The `index`-th generalized coordinate, in the state or not. The `index`-th
    /// state unless a simulator, whose positions are fewer, says otherwise.
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        self.state(index)
    }
    /// Typical size of the `index`-th state, which scales its absolute tolerance.
    fn state_scale(&self, index: usize) -> f64;
    /// The `index`-th parameter.
    fn parameter(&self, index: usize) -> Quantity<'_>;
    /// Value of the `index`-th parameter in the spec.
    fn parameter_default(&self, index: usize) -> f64;
    /// The `index`-th output.
    fn output(&self, index: usize) -> Quantity<'_>;
    /// Whether the `index`-th output answers to a force at once: by accelerations or by forces of
    /// constraints.
    fn output_answers_at_once(&self, _index: usize) -> bool {
        false
    }
    /// Nonzeros of dy'/dy, `states` by `states`.
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_>;
    /// Nonzeros of dy'/dp, `states` by `parameters`.
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_>;
    /// Nonzeros of M, `coordinates` by `coordinates`, both triangles.
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_>;
    /// Entries of the state that may be coupled with any other, ascending, where the
    /// Jacobian of the rest is banded in the order of positions, velocities and
    /// first-order states; nothing where there is no such structure.
    fn border(&self) -> Option<&[u32]> {
        None
    }
    /// Run defaults of the spec.
    fn run_defaults(&self) -> RunDefaults<'_>;
    /// Number of events; none, unless a simulator says otherwise.
    fn events(&self) -> usize {
        0
    }
    /// The `index`-th event.
    fn event(&self, index: usize) -> Event<'_> {
        panic!("there is no event {index}")
    }
    /// Whether the `index`-th state is a mode: a whole number that only events
    /// change. Its rate is zero.
    fn is_mode(&self, _index: usize) -> bool {
        false
    }
    /// Number of guards of kinks: what passes zero where the rate, continuous or not, is not
    /// smooth, in state or time; none, unless a simulator says otherwise.
    fn kinks(&self) -> usize {
        0
    }
    /// Number of constraints, m; none, unless a simulator says otherwise. The state of
    /// a simulator with constraints holds all coordinates, in order.
    fn constraints(&self) -> usize {
        0
    }
    /// The `index`-th constraint.
    fn constraint(&self, index: usize) -> Constraint<'_> {
        panic!("there is no constraint {index}")
    }
    /// Nonzeros of G = dg'/dq', `constraints` by `coordinates`.
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 0, columns: self.shape().coordinates, entries: &[] }
    }
    /// Whether runs start in the equilibrium near the initial state, and not in that itself.
    fn starts_in_equilibrium(&self) -> bool {
        false
    }
    /// Why some values of the parameters make no machine, as the spec would be refused with them;
    /// nothing if they do, or if it is not known.
    fn refusal(&self, _parameters: &[f64]) -> Option<Refusal<'_>> {
        None
    }
    /// True if the spec has a parameter of this name on which nothing depends, so that the simulator
    /// has it not.
    fn is_unused(&self, _parameter: &str) -> bool {
        false
    }
    /// True if no power is supplied or dissipated at any state and time, for these parameters;
    /// nothing if it is not known. Events may change the energy all the same.
    fn conserves_energy(&self, _parameters: &[f64]) -> Option<bool> {
        None
    }
    /// Whether the initial value of the `index`-th state is given; if not, it is a guess
    /// from which one is looked for that fulfils the constraints.
    fn is_given(&self, _index: usize) -> bool {
        true
    }
}

/// What [`Simulator::prepared_jacobians`] gives, by the functions of the two.
#[inline]
pub fn jacobians_apart<R: Real>(
    simulator: &(impl Simulator<R> + ?Sized),
    time: R,
    state: &[R],
    parameters: &[R],
    constants: &[R],
    values: &mut [R],
) {
    let by_state = simulator.rate_jacobian_pattern().entries.len();
    let (by_state, by_parameters) = values.split_at_mut(by_state);
    simulator.prepared_rate_jacobian(time, state, parameters, constants, by_state);
    simulator.prepared_parameter_jacobian(time, state, parameters, constants, by_parameters);
}

/// The numbers of a simulator: the functions of their table
/// ([`for_each_function`](crate::for_each_function)), and what else there may be. Slices
/// have the lengths of [`Shape`] and of the patterns; every method writes all of its output
/// slice.
///
/// # Panics
/// Every method panics if a slice has another length than stated.
pub trait Simulator<R: Real>: Describe {
    crate::for_each_function! { [crate::functions::methods] }
    /// How many constants [`Simulator::prepare`] computes; 0 if it has none.
    fn constants(&self) -> usize {
        0
    }
    /// What rate and Jacobians need of the parameters, `constants` long: once a run, for
    /// [`Simulator::prepared_rate`], [`Simulator::prepared_rate_jacobian`],
    /// [`Simulator::prepared_parameter_jacobian`] and [`Simulator::prepared_jacobians`].
    fn prepare(&self, _parameters: &[R], _constants: &mut [R]) {}
    /// `dy'/dy` and `dy'/dp` by constants, values of the one behind those of the other, to the
    /// last bit as [`Simulator::prepared_rate_jacobian`] and
    /// [`Simulator::prepared_parameter_jacobian`] give them: for sensitivities, which need both at
    /// every state. What both need may be computed once.
    fn prepared_jacobians(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        jacobians_apart(self, time, state, parameters, constants, values);
    }
    /// Taylor series of the solution, where the simulator has them.
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        None
    }
    /// What its equations are excited by, if they are linear with constant
    /// coefficients.
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
        None
    }
    /// Its functions on dual numbers, for sensitivities along a run: `Some(self)` of a
    /// simulator on any [`Real`].
    fn derivatives(&self) -> Option<&dyn Derivatives> {
        None
    }
}

/// What variants side by side ask of their machine; all else is asked of it one variant at a time. Every
/// simulator has it, and who makes `&dyn SideBySide` of one compiles no more than this in lanes.
pub trait SideBySide<R: Real>: Describe {
    /// As [`Simulator::constants`].
    fn constants(&self) -> usize;
    /// As [`Simulator::prepare`].
    fn prepare(&self, parameters: &[R], constants: &mut [R]);
    /// As [`Simulator::prepared_rate`].
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        rate: &mut [R],
    );
    /// As [`Simulator::prepared_rate_jacobian`].
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    );
    /// As [`Simulator::taylor`].
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>>;
}

impl<R: Real, S: Simulator<R>> SideBySide<R> for S {
    fn constants(&self) -> usize {
        Simulator::constants(self)
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        Simulator::prepare(self, parameters, constants);
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        rate: &mut [R],
    ) {
        Simulator::prepared_rate(self, time, state, parameters, constants, rate);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        Simulator::prepared_rate_jacobian(self, time, state, parameters, constants, values);
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Simulator::taylor(self)
    }
}

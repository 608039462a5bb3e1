//! The traits of every simulator: [`Describe`] (names, units, shapes, patterns) and [`Simulator`]
//! (the numbers).

use crate::Real;
use crate::dual::Derivatives;
use crate::interval::Ranges;
use crate::linear::LinearEquations;
use crate::taylor::TaylorSeries;

/// Name, SI unit and meaning of a quantity of a simulator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Quantity<'a> {
    /// The name in the spec, `instance.name`.
    pub name: &'a str,
    /// SI unit as written in the spec; `1` if dimensionless.
    pub unit: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
}

/// Numbers of states, parameters, outputs and discontinuities of a simulator.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shape {
    /// Number of generalized coordinates, n.
    pub coordinates: usize,
    /// Number of positions in the state: n, without those that nothing depends on.
    pub positions: usize,
    /// Number of first-order states, m.
    pub first_order: usize,
    /// Number of quadratures, which are the last entries of the state. No rate depends on them,
    /// so an implicit method may leave them out of its iteration.
    pub quadratures: usize,
    /// Number of parameters.
    pub parameters: usize,
    /// Number of outputs.
    pub outputs: usize,
    /// Number of times at which the right-hand side is discontinuous.
    pub discontinuities: usize,
}

impl Shape {
    /// Returns the length of the state: positions, velocities and first-order states.
    #[must_use]
    pub const fn states(&self) -> usize {
        self.positions + self.coordinates + self.first_order
    }
}

/// Kind of an entry of the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StateKind {
    /// A generalized coordinate, or the difference of two.
    Position,
    /// A generalized velocity. Velocities have the order of the coordinates.
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

/// Direction in which a guard crosses zero to trigger its event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Direction {
    /// From negative to positive.
    Rising,
    /// From positive to negative.
    Falling,
    /// Both directions.
    Both,
}

/// An event: at a zero crossing of its guard, an expression of time and state, some entries of
/// the state are reset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Event<'a> {
    /// The name in the spec, `instance.name`.
    pub name: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
    /// Direction of the guard's zero crossing.
    pub direction: Direction,
    /// Modes (indices in the state) and the values they must have for the event to be active.
    pub when: &'a [(u32, f64)],
    /// Entries of the state that the event resets, in the order of [`Simulator::resets`].
    pub sets: &'a [u32],
    /// True if the event only counts: nothing that determines the motion or an event reads these
    /// entries, and their rates are zero. Such an event does not end a step.
    pub counts: bool,
    /// True if the guard or its rate reads one of these entries other than a mode: the event may bring
    /// its guard to rest at zero.
    pub moves_guard: bool,
}

/// The way in which a step holds a relation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RelationKind {
    /// `abs`, `sign`, `min`, `max` or a comparison: one of two branches, by the sign of the guard.
    Branch,
    /// `floor`, and with it `mod`: an integer n. The guard is the argument, between n and n + 1.
    Whole,
    /// A feature with an effect only near a place, such as a bell: its guard is positive there.
    /// Nothing is held, and nothing reads the slot. Steps end where the motion enters, is nearest
    /// and leaves.
    Zone,
}

impl RelationKind {
    /// Returns the slot value that leaves a relation live, so that its current values decide.
    #[must_use]
    pub const fn live(self) -> f64 {
        match self {
            Self::Branch | Self::Zone => 0.0,
            Self::Whole => f64::INFINITY,
        }
    }
}

/// A reader of a relation, which determines when the relation can have an effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reader {
    /// The rate, constraints or the mass matrix, in every mode.
    Rate,
    /// The guard of an event.
    Event(u32),
    /// The comparison of another relation.
    Relation(u32),
    /// The branch of another relation on which its guard is negative.
    Below(u32),
    /// The branch of another relation on which its guard is not negative.
    Above(u32),
}

/// A relation of the spec that steps hold: `abs`, `sign`, `min`, `max`, a comparison, or `floor`.
///
/// It has a *slot* after the parameters. A branch adds its slot to the guard before the comparison
/// with zero: minus or plus infinity holds the branch below or above, and zero leaves it live. For
/// an integer, the slot is its value; infinity leaves it live.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Relation<'a> {
    /// The way in which it is held.
    pub kind: RelationKind,
    /// Its readers.
    pub readers: &'a [Reader],
}

/// A constraint on the coordinates: g(q, t) = 0, or a(q, t) q' + b(q, t) = 0. Its force on the
/// coordinates is G^T lambda.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Constraint<'a> {
    /// The name in the spec, `instance.name`.
    pub name: &'a str,
    /// SI unit of the constrained expression.
    pub unit: &'a str,
    /// One sentence of meaning.
    pub doc: &'a str,
    /// True for a constraint on positions; false for one on velocities alone.
    pub is_of_positions: bool,
    /// True if the constraint holds in some modes only. In the others its row of G is zero.
    pub in_modes: bool,
    /// The mode of the dry friction that sticks by this constraint, as an entry of the state. It is
    /// [`Constraint::OPEN`] while it is not determined.
    pub friction: Option<u32>,
    /// Jumps of the speed of its friction.
    pub jumps: Jumps,
}

/// Jumps of the speed of dry friction, after which it begins anew: its force is finite.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub enum Jumps {
    /// Nowhere.
    #[default]
    Nowhere,
    /// In time, at discontinuities of the rate.
    InTime,
    /// At places, and perhaps in time.
    AtPlaces,
}

impl<'a> Constraint<'a> {
    /// Value of the mode of dry friction that is open, or not yet determined: its events determine
    /// it from the speed at once.
    pub const OPEN: f64 = 2.0;

    const fn of(
        name: &'a str,
        unit: &'a str,
        doc: &'a str,
        [is_of_positions, in_modes]: [bool; 2],
    ) -> Self {
        Self { name, unit, doc, is_of_positions, in_modes, friction: None, jumps: Jumps::Nowhere }
    }

    /// Returns the constraint g(q, t) = 0.
    #[must_use]
    pub const fn of_positions(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self::of(name, unit, doc, [true, false])
    }

    /// Returns the constraint a(q, t) q' + b(q, t) = 0.
    #[must_use]
    pub const fn of_velocities(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self::of(name, unit, doc, [false, false])
    }

    /// Returns the constraint g(q, t) = 0 that holds in some modes only.
    #[must_use]
    pub const fn of_positions_in_modes(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self::of(name, unit, doc, [true, true])
    }

    /// Returns the constraint a(q, t) q' + b(q, t) = 0 that holds in some modes only.
    #[must_use]
    pub const fn of_velocities_in_modes(name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self::of(name, unit, doc, [false, true])
    }

    /// Returns the constraint by which dry friction sticks in a value of the mode at an entry of the
    /// state.
    #[must_use]
    pub const fn of_friction(mode: u32, name: &'a str, unit: &'a str, doc: &'a str) -> Self {
        Self { friction: Some(mode), ..Self::of(name, unit, doc, [false, true]) }
    }

    /// Returns the same for friction whose speed may jump in time.
    #[must_use]
    pub const fn of_friction_in_time(
        mode: u32,
        name: &'a str,
        unit: &'a str,
        doc: &'a str,
    ) -> Self {
        Self { jumps: Jumps::InTime, ..Self::of_friction(mode, name, unit, doc) }
    }

    /// Returns the same for friction whose speed may jump at places.
    #[must_use]
    pub const fn of_friction_at_places(
        mode: u32,
        name: &'a str,
        unit: &'a str,
        doc: &'a str,
    ) -> Self {
        Self { jumps: Jumps::AtPlaces, ..Self::of_friction(mode, name, unit, doc) }
    }
}

/// Default settings of a scene's run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunDefaults<'a> {
    /// Start time \[s\].
    pub from: f64,
    /// End time \[s\].
    pub until: f64,
    /// Number of output times, both ends included. They are equally spaced unless `times` is
    /// given.
    pub points: usize,
    /// Output times \[s\], increasing, if they are not equally spaced; else empty.
    pub times: &'a [f64],
    /// Relative tolerance. The absolute tolerance is this times the scale of the state.
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
    /// Returns T + V + stored.
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
    /// Power of generalized forces, supplies and explicit time dependence.
    pub supplied: R,
    /// Power lost: q' dD/dq' and the losses of first-order states.
    pub dissipated: R,
}

impl<R: Real> PowerBalance<R> {
    /// Returns dE/dt - supplied + dissipated, which is zero up to rounding.
    #[must_use]
    pub fn residual(&self) -> R {
        self.stored_rate - self.supplied + self.dissipated
    }
}

/// Reason why parameter values do not describe a machine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refusal<'a> {
    /// The rule that the value breaks: `the ratio of port \`gear.a\` is a number other than 0`.
    pub rule: &'a str,
    /// The value.
    pub value: f64,
}

/// Names, units, shapes and structure of a simulator.
pub trait Describe {
    /// Returns the scene's name, a valid identifier.
    fn name(&self) -> &str;
    /// Returns a title of one line.
    fn title(&self) -> &str;
    /// Returns the numbers of coordinates, states, parameters and outputs.
    fn shape(&self) -> Shape;
    /// Returns the `index`-th state.
    ///
    /// # Panics
    /// If `index` is not below `shape().states()`; likewise below.
    fn state(&self, index: usize) -> Quantity<'_>;
    /// Returns the kind of the `index`-th state. By default positions come first, then
    /// velocities, then first-order states.
    fn state_kind(&self, index: usize) -> StateKind {
        let Shape { positions, coordinates, .. } = self.shape();
        match index {
            index if index < positions => StateKind::Position,
            index if index < positions + coordinates => StateKind::Velocity,
            _ => StateKind::FirstOrder,
        }
    }
    /// Returns the `index`-th generalized coordinate, in the state or not. By default it is the
    /// `index`-th state; simulators with fewer positions override this.
    fn coordinate(&self, index: usize) -> Quantity<'_> {
        self.state(index)
    }
    /// Returns the typical size of the `index`-th state, which scales its absolute tolerance.
    fn state_scale(&self, index: usize) -> f64;
    /// Returns the `index`-th parameter.
    fn parameter(&self, index: usize) -> Quantity<'_>;
    /// Returns the value of the `index`-th parameter in the spec.
    fn parameter_default(&self, index: usize) -> f64;
    /// Returns the `index`-th output.
    fn output(&self, index: usize) -> Quantity<'_>;
    /// Reports whether the `index`-th output has direct feedthrough of forces, by accelerations
    /// or constraint forces.
    fn output_answers_at_once(&self, _index: usize) -> bool {
        false
    }
    /// Returns the nonzeros of dy'/dy, `states` by `states`.
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_>;
    /// Returns the nonzeros of dy'/dp, `states` by `parameters`.
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_>;
    /// Returns the nonzeros of M, `coordinates` by `coordinates`, both triangles.
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_>;
    /// Returns the entries of the state that may be coupled with any other, ascending. Without
    /// them the Jacobian is banded in the order of positions, velocities and first-order states.
    /// `None` if there is no such structure.
    fn border(&self) -> Option<&[u32]> {
        None
    }
    /// Returns the default run settings of the spec.
    fn run_defaults(&self) -> RunDefaults<'_>;
    /// Returns the number of events, by default 0.
    fn events(&self) -> usize {
        0
    }
    /// Returns the `index`-th event.
    fn event(&self, index: usize) -> Event<'_> {
        panic!("there is no event {index}")
    }
    /// Reports whether the `index`-th state is a mode: a whole number that only events change.
    /// Its rate is zero.
    fn is_mode(&self, _index: usize) -> bool {
        false
    }
    /// Returns the number of guards of switching surfaces, by default 0. Such a guard crosses
    /// zero where the rate is not smooth in state or time, whether it is continuous there or not.
    fn kinks(&self) -> usize {
        0
    }
    /// Reports whether the kinetic energy may jump at kinks that are no relations, such as the
    /// corners of a table: by default not. Velocities jump there.
    fn inertia_has_corners(&self) -> bool {
        false
    }
    /// Returns the number of relations that steps hold, by default 0. Their guards are the first of
    /// the guards of kinks, each after those that it reads. Their slots may follow the parameters
    /// wherever parameters are taken.
    fn relations(&self) -> usize {
        0
    }
    /// Returns the `index`-th relation.
    fn relation(&self, index: usize) -> Relation<'_> {
        panic!("there is no relation {index}")
    }
    /// Returns the number of arguments of functions that saturate, by default 0: the rate contains
    /// such functions, whose series lose all coefficients to rounding where they are flat.
    fn saturations(&self) -> usize {
        0
    }
    /// Returns the number of constraints, m, by default 0. The state of a simulator with
    /// constraints holds all coordinates, in order.
    fn constraints(&self) -> usize {
        0
    }
    /// Returns the `index`-th constraint.
    fn constraint(&self, index: usize) -> Constraint<'_> {
        panic!("there is no constraint {index}")
    }
    /// Returns the nonzeros of G = dg'/dq', `constraints` by `coordinates`.
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        SparsityPattern { rows: 0, columns: self.shape().coordinates, entries: &[] }
    }
    /// Reports whether runs start in the equilibrium near the initial state instead of that
    /// state.
    fn starts_in_equilibrium(&self) -> bool {
        false
    }
    /// Returns the reason why the spec would be rejected with these parameter values. `None` if
    /// they are valid, or if this is unknown.
    fn refusal(&self, _parameters: &[f64]) -> Option<Refusal<'_>> {
        None
    }
    /// Reports whether the spec has a parameter of this name that nothing depends on, which the
    /// simulator therefore leaves out.
    fn is_unused(&self, _parameter: &str) -> bool {
        false
    }
    /// Reports whether no power is supplied or dissipated at any state and time, for these
    /// parameters. `None` if this is unknown. Events may change the energy nevertheless.
    fn conserves_energy(&self, _parameters: &[f64]) -> Option<bool> {
        None
    }
    /// Reports whether the initial value of the `index`-th state is given. If not, it is a guess
    /// from which values that fulfil the constraints are computed.
    fn is_given(&self, _index: usize) -> bool {
        true
    }
}

/// Computes [`Simulator::prepared_jacobians`] by separate calls for the two Jacobians.
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

/// Numerical functions of a simulator: those of the table
/// ([`for_each_function`](crate::for_each_function)), and optional ones. Slices have the lengths
/// of [`Shape`] and of the patterns. Every method writes all of its output slice.
///
/// # Panics
/// Every method panics if a slice has another length than stated.
pub trait Simulator<R: Real>: Describe {
    crate::for_each_function! { [crate::functions::methods] }
    /// Returns the number of constants that [`Simulator::prepare`] computes; 0 if there are none.
    fn constants(&self) -> usize {
        0
    }
    /// Computes the `constants` that rate and Jacobians need of the parameters. It is called once
    /// a run, for [`Simulator::prepared_rate`], [`Simulator::prepared_rate_jacobian`],
    /// [`Simulator::prepared_parameter_jacobian`] and [`Simulator::prepared_jacobians`].
    fn prepare(&self, _parameters: &[R], _constants: &mut [R]) {}
    /// Computes the values of `dy'/dy`, followed by those of `dy'/dp`, from constants. They are
    /// bitwise equal to the results of [`Simulator::prepared_rate_jacobian`] and
    /// [`Simulator::prepared_parameter_jacobian`]. Sensitivities need both at every state; common
    /// parts may be computed once.
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
    /// Returns the Taylor series of the solution, if the simulator has them.
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        None
    }
    /// Returns the excitation of the equations, if they are linear with constant coefficients.
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
        None
    }
    /// Returns the functions on dual numbers, for sensitivities along a run. It is `Some(self)`
    /// for a simulator on any [`Real`].
    fn derivatives(&self) -> Option<&dyn Derivatives> {
        None
    }
    /// Returns the ranges of the guards, with which steps far from all zeros skip the guards. It is
    /// `Some(self)` for a simulator on any [`Real`].
    fn ranges(&self) -> Option<&dyn Ranges> {
        None
    }
}

/// Functions that are evaluated for several variants side by side, in lanes. All others are
/// called one variant at a time. Every simulator implements this trait; through `&dyn SideBySide`
/// only these functions are compiled for lanes.
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
    /// As [`Simulator::saturating_arguments`].
    fn saturating_arguments(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]);
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
    fn saturating_arguments(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        Simulator::saturating_arguments(self, time, state, parameters, values);
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Simulator::taylor(self)
    }
}

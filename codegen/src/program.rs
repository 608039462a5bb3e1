//! A scene ready to be emitted or evaluated: one tape for each function.

use crate::expr::{CoordinateId, ParameterId};
use crate::linear::Excitation;
use crate::reduce::Reduction;
use crate::state::{Layout, Motion};
use crate::system::{Direction, Field, LagrangianSystem, Name};
use crate::tape::{Op, Tape};

/// Structural nonzeros, sorted by row, then by column.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SparsityPattern {
    /// Number of rows.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// (row, column) of every nonzero.
    pub entries: Vec<(u32, u32)>,
}

/// A matrix: the tape's results are its structural nonzeros in pattern order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MatrixTape {
    /// Where the nonzeros are.
    pub pattern: SparsityPattern,
    /// Their values.
    pub tape: Tape,
}

/// An event as a simulator describes it; what it computes is on tapes.
#[derive(Debug, Clone, PartialEq)]
pub struct EventShape {
    /// What it is called.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// Which way its guard passes zero.
    pub direction: Direction,
    /// (entry of the state, value) of the modes in which it is watched.
    pub when: Vec<(u32, f64)>,
    /// Entries of the state that it sets.
    pub sets: Vec<u32>,
}

/// A constraint as a simulator describes it; what it computes is on tapes.
#[derive(Debug, Clone, PartialEq)]
pub struct ConstraintShape {
    /// What it is called.
    pub name: Name,
    /// One sentence of meaning; may be empty.
    pub doc: String,
    /// SI unit of what is zero.
    pub unit: String,
    /// Whether it is of positions; else of velocities alone.
    pub is_of_positions: bool,
}

/// Everything a simulator computes; lengths as in the emitted contract.
#[derive(Debug, Clone, PartialEq)]
pub struct Program {
    /// Names, units, docs, tables, defaults.
    pub system: LagrangianSystem,
    /// The entries of the state, in order.
    pub layout: Layout,
    /// What has been left out.
    pub reduction: Reduction,
    /// `states` results.
    pub initial_state: Tape,
    /// One result for each discontinuity.
    pub discontinuities: Tape,
    /// `states` results.
    pub rate: Tape,
    /// dy'/dy.
    pub rate_jacobian: MatrixTape,
    /// dy'/dp.
    pub parameter_jacobian: MatrixTape,
    /// `states` results.
    pub time_derivative: Tape,
    /// M, both triangles.
    pub mass_matrix: MatrixTape,
    /// `coordinates` results.
    pub forcing: Tape,
    /// `outputs` results.
    pub outputs: Tape,
    /// Kinetic, potential, stored.
    pub energy: Tape,
    /// Rate of stored energy, power supplied, power dissipated.
    pub power_balance: Tape,
    /// b(t) of linear equations with constant coefficients, without events and
    /// constraints.
    pub excitation: Option<Excitation>,
    /// What happens where guards pass zero.
    pub events: Vec<EventShape>,
    /// One result for each event.
    pub guards: Tape,
    /// dg/dt along the motion, one result for each event.
    pub guard_rates: Tape,
    /// New values of the entries that events set, event by event.
    pub resets: Tape,
    /// What coordinates must fulfil.
    pub constraints: Vec<ConstraintShape>,
    /// g, one result for each constraint.
    pub constraint_values: Tape,
    /// g', likewise.
    pub constraint_rates: Tape,
    /// G = dg'/dq'.
    pub constraint_matrix: MatrixTape,
    /// The generic element of every field.
    pub fields: Vec<FieldProgram>,
}

impl Program {
    /// Whether dy'/dy or the time derivative depends on the forces of fields.
    #[must_use]
    pub fn jacobian_reads_forces(&self) -> bool {
        let attachments = self.fields.iter().flat_map(|field| &field.field.attachments);
        // Behind the inertia of the node.
        let forces: Vec<u32> = attachments.map(|at| at.handed.0 + 1).collect();
        let tapes = [&self.rate_jacobian.tape, &self.time_derivative];
        tapes
            .into_iter()
            .flat_map(|tape| &tape.nodes)
            .any(|node| matches!(node.op, Op::Parameter(index) if forces.contains(&index)))
    }

    /// Of each entry of the state, whether the spec gives its initial value, so that
    /// constraints may not move it.
    #[must_use]
    pub fn is_given(&self) -> Vec<bool> {
        let coordinate = |id: CoordinateId| &self.system.coordinates[id.0 as usize];
        let given = self.layout.states.iter().map(|state| match state.motion {
            Motion::Position { coordinate: id, .. } => coordinate(id).is_given[0],
            Motion::Velocity(id) => coordinate(id).is_given[1],
            Motion::FirstOrder(_) => true,
        });
        given.collect()
    }
}

/// f_0 and f_1 of a field where they have nothing in common.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalForces {
    /// f_0.
    pub on_value: Tape,
    /// df_0/du and df_0/du_t.
    pub on_value_jacobian: Tape,
    /// df_0/dt.
    pub on_value_by_time: Tape,
    /// f_1.
    pub on_slope: Tape,
    /// df_1/du_x and df_1/du_xt.
    pub on_slope_jacobian: Tape,
}

/// What is computed at a point of a field. The state of the tapes is \[u, u_x, u_t,
/// u_xt, x\]; forces come in twos, on u and on u_x.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldProgram {
    /// Names, attachments, defaults.
    pub field: Field,
    /// The entries of the state.
    pub layout: Layout,
    /// Parameters that the densities or the places on the field depend on.
    pub parameters: Vec<ParameterId>,
    /// m, of x.
    pub inertia: Tape,
    /// dm/dx, then dm/dp of `parameters`.
    pub inertia_gradient: Tape,
    /// Forces.
    pub force: Tape,
    /// Whether forces are linear in u, u_x, u_t and u_xt, without anything else, and
    /// the same at all times.
    pub is_linear: bool,
    /// Forces one by one, if f_0 depends on neither u_x nor u_xt, and f_1 on nothing but
    /// these and parameters.
    pub local: Option<LocalForces>,
    /// Their derivatives with respect to u, u_x, u_t, u_xt, row by row.
    pub force_jacobian: Tape,
    /// Twos of their derivatives with respect to x, t, and `parameters`.
    pub force_gradient: Tape,
    /// Kinetic, potential.
    pub energy: Tape,
    /// Rate of the potential, power supplied, power dissipated.
    pub power: Tape,
    /// x of the attachments, then the length.
    pub places: Tape,
    /// Their derivatives with respect to `parameters`, row by row.
    pub places_gradient: Tape,
    /// u and u_t at the start, of x.
    pub initial: Tape,
}

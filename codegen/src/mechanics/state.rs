//! State vector of a simulator: the entries of y, in order.
//!
//! Before reduction y = \[q, w, q', z\], with a part w of each quaternion among the coordinates. After it, positions that nothing depends on are gone,
//! others are relative, and entries that are only integrated for an output come last.

use crate::scene::system::LagrangianSystem;
use machinist_algebra::expr::{CoordinateId, Expr, FirstOrderId, Symbol};
use machinist_model::Quantity;

/// One entry of the state.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Name, unit and meaning.
    pub quantity: Quantity,
    /// Kind of the entry, which determines its rate.
    pub motion: Motion,
    /// Initial value; of parameters only.
    pub initial: Expr,
    /// Typical size, for absolute tolerance.
    pub scale: f64,
}

/// Kind of an entry of the state.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// A position, or a position relative to another. Its symbol is that of its coordinate.
    Position {
        /// The coordinate.
        coordinate: CoordinateId,
        /// Its rate, of velocities and parameters only, or of a quaternion's parts too.
        rate: Expr,
    },
    /// A generalized velocity; its rate is the acceleration.
    Velocity(CoordinateId),
    /// A first-order state z; its rate is h.
    FirstOrder(FirstOrderId),
}

/// The state of a scene and the order of its entries.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Layout {
    /// Positions, velocities, first-order states, then quadratures.
    pub states: Vec<State>,
    /// Number of quadratures, which are the last entries. No rate depends on them, so an implicit
    /// method may leave them out of its iteration.
    pub quadratures: usize,
}

impl Motion {
    /// Returns the entry's symbol in expressions.
    #[must_use]
    pub fn symbol(&self) -> Symbol {
        match *self {
            Motion::Position { coordinate, .. } => Symbol::Coordinate(coordinate),
            Motion::Velocity(id) => Symbol::Velocity(id),
            Motion::FirstOrder(id) => Symbol::FirstOrder(id),
        }
    }

    /// Returns the rate of a position.
    #[must_use]
    pub fn rate(&self) -> Option<&Expr> {
        match self {
            Motion::Position { rate, .. } => Some(rate),
            Motion::Velocity(_) | Motion::FirstOrder(_) => None,
        }
    }

    pub(crate) fn rate_mut(&mut self) -> Option<&mut Expr> {
        match self {
            Motion::Position { rate, .. } => Some(rate),
            Motion::Velocity(_) | Motion::FirstOrder(_) => None,
        }
    }
}

impl Layout {
    /// Returns the complete state \[q, q', z\] of a system.
    #[must_use]
    pub fn of_all(system: &LagrangianSystem) -> Self {
        let coordinates = || system.coordinates.iter().zip(0..);
        let positions = coordinates().map(|(coordinate, id)| State {
            quantity: coordinate.position.clone(),
            motion: Motion::Position {
                coordinate: CoordinateId(id),
                rate: system.orientations.rate(CoordinateId(id)),
            },
            initial: coordinate.initial[0].clone(),
            scale: coordinate.scale[0],
        });
        let ids = (system.coordinates.len() as u32..).map(CoordinateId);
        let scalars = system.scalars.iter().zip(ids).map(|(scalar, id)| State {
            quantity: scalar.quantity.clone(),
            motion: Motion::Position { coordinate: id, rate: system.orientations.rate(id) },
            initial: scalar.initial.clone(),
            scale: 1.0,
        });
        let velocities = coordinates().map(|(coordinate, id)| State {
            quantity: coordinate.velocity.clone(),
            motion: Motion::Velocity(CoordinateId(id)),
            initial: coordinate.initial[1].clone(),
            scale: coordinate.scale[1],
        });
        let first_order = system.first_order.iter().zip(0..).map(|(state, id)| State {
            quantity: state.quantity.clone(),
            motion: Motion::FirstOrder(FirstOrderId(id)),
            initial: state.initial.clone(),
            scale: state.scale,
        });
        let states = positions.chain(scalars).chain(velocities).chain(first_order).collect();
        Layout { states, quadratures: 0 }
    }

    /// Returns the number of entries.
    #[must_use]
    pub fn len(&self) -> usize {
        self.states.len()
    }

    /// Reports whether there is nothing to integrate.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.states.is_empty()
    }

    /// Returns the number of positions among the entries.
    #[must_use]
    pub fn positions(&self) -> usize {
        let is_position = |state: &&State| matches!(state.motion, Motion::Position { .. });
        self.states.iter().filter(is_position).count()
    }

    /// Reports whether the entries are \[q, q', z\] of a system, all coordinates in order.
    #[must_use]
    pub fn is_of_all(&self, system: &LagrangianSystem) -> bool {
        self.quantities().eq(Layout::of_all(system).quantities())
    }

    /// Iterates over the symbols of the entries, in order.
    pub fn symbols(&self) -> impl Iterator<Item = Symbol> {
        self.states.iter().map(|state| state.motion.symbol())
    }

    /// Iterates over the quantities, in order.
    pub fn quantities(&self) -> impl Iterator<Item = &Quantity> {
        self.states.iter().map(|state| &state.quantity)
    }
}

//! Orientations given by unit quaternions whose velocities are the rates of the body.
//!
//! ```text
//! q = w + x i + y j + z k        q' = q omega/2
//! ```
//!
//! omega is along the axes that q has turned. Its components are quasi-velocities: they are the
//! rates of no coordinates. A small rotation by the angles d about these axes changes q by q d/2.

use machinist_algebra::cas::arithmetic::{negative, product, sum};
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};
use num_rational::BigRational;

use super::vector::{Matrix3, of_quaternion};

/// A quaternion among the coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Orientation {
    /// x, y and z. Their velocities are the components of omega.
    pub vector: [CoordinateId; 3],
    /// w, which has no velocity of its own.
    pub scalar: CoordinateId,
}

impl Orientation {
    /// Returns the parts w, x, y, z.
    #[must_use]
    pub fn parts(&self) -> [Expr; 4] {
        let [x, y, z] = self.vector;
        [self.scalar, x, y, z].map(|id| Expr::Symbol(Symbol::Coordinate(id)))
    }

    /// Returns the matrix that changes components along the turned axes to those along the others.
    #[must_use]
    pub fn matrix(&self) -> Matrix3 {
        of_quaternion(&self.parts())
    }

    /// Returns the derivatives of w, x, y and z by a small rotation about a turned axis.
    #[must_use]
    pub fn moves(&self, axis: usize) -> [(CoordinateId, Expr); 4] {
        let [w, x, y, z] = self.parts();
        let signed = match axis {
            0 => [negative(&x), w, z, negative(&y)],
            1 => [negative(&y), negative(&z), w, x],
            _ => [negative(&z), y, negative(&x), w],
        };
        let half = Expr::Number(BigRational::new(1.into(), 2.into()));
        let ids = [self.scalar, self.vector[0], self.vector[1], self.vector[2]];
        let mut slopes = signed.into_iter().map(|part| product([half.clone(), part]));
        ids.map(|id| (id, slopes.next().unwrap_or_else(|| Expr::integer(0))))
    }
}

/// The coordinates of a system that are parts of orientations.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Orientations(Vec<Orientation>);

impl Orientations {
    /// Returns a set of orientations.
    #[must_use]
    pub fn new(all: Vec<Orientation>) -> Self {
        Self(all)
    }

    /// Iterates over them.
    pub fn iter(&self) -> impl Iterator<Item = &Orientation> {
        self.0.iter()
    }

    /// Reports whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the orientation of which a coordinate is a part.
    fn of(&self, id: CoordinateId) -> Option<&Orientation> {
        self.0.iter().find(|one| one.scalar == id || one.vector.contains(&id))
    }

    /// Reports whether a coordinate is a part of an orientation.
    #[must_use]
    pub fn contain(&self, id: CoordinateId) -> bool {
        self.of(id).is_some()
    }

    /// Returns the derivatives of coordinates by the motion that a velocity is the rate of: 1 for
    /// its own coordinate, or those of a quaternion by a small rotation.
    #[must_use]
    pub fn moves(&self, velocity: CoordinateId) -> Vec<(CoordinateId, Expr)> {
        let found = self.0.iter().find_map(|one| {
            let axis = one.vector.iter().position(|id| *id == velocity)?;
            Some(one.moves(axis).to_vec())
        });
        found.unwrap_or_else(|| vec![(velocity, Expr::integer(1))])
    }

    /// Returns the rate of a coordinate, of velocities and, for parts of a quaternion, positions.
    #[must_use]
    pub fn rate(&self, id: CoordinateId) -> Expr {
        let velocity = |id| Expr::Symbol(Symbol::Velocity(id));
        let Some(one) = self.of(id) else { return velocity(id) };
        let terms = (0..3).filter_map(|axis| {
            let moves = one.moves(axis);
            let (_, slope) = moves.into_iter().find(|(part, _)| *part == id)?;
            Some(product([slope, velocity(one.vector[axis])]))
        });
        sum(terms.collect::<Vec<_>>())
    }

    /// Returns the velocities that a coordinate's rate depends on.
    #[must_use]
    pub fn velocities(&self, id: CoordinateId) -> Vec<CoordinateId> {
        self.of(id).map_or_else(|| vec![id], |one| one.vector.to_vec())
    }
}

//! Equations of motion of a mechanism, by recursion along its tree.
//!
//! ```text
//! M q'' + b(q, q', t) = Q        b contains gravity
//! ```
//!
//! The left side follows from given accelerations by the recursive Newton-Euler algorithm, and M by
//! the composite-rigid-body algorithm: R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008,
//! sections 5.3 and 6.2. All components are along the axes of the joint that they belong to.

use std::collections::BTreeMap;

use machinist_algebra::cas::arithmetic::{negative, product, sum};
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};
use num_rational::BigRational;

use super::mechanism::{Frame, Freedom, Inertia, Joint, Kind, Mechanism};
use super::vector::{
    Matrix3, Vector, congruent, cross, dot, minus, of_moment, of_point, plus, scaled,
    symmetric_sum, times, total, transposed, zero,
};

/// A force and its torque about the origin of a joint.
#[derive(Debug, Clone)]
pub(super) struct Wrench {
    pub(super) force: Vector,
    pub(super) torque: Vector,
}

impl Wrench {
    pub(super) fn none() -> Self {
        Wrench { force: zero(), torque: zero() }
    }

    pub(super) fn times(&self, s: &Expr) -> Self {
        Wrench { force: scaled(s, &self.force), torque: scaled(s, &self.torque) }
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        Wrench { force: plus(&self.force, &other.force), torque: plus(&self.torque, &other.torque) }
    }

    /// Returns the same wrench about the origin of the joint that carries this one, along its axes.
    pub(super) fn on_parent_of(&self, joint: &Joint) -> Self {
        let back = transposed(&joint.orientation);
        let force = times(&back, &self.force);
        let torque = plus(&times(&back, &self.torque), &cross(&joint.displacement, &force));
        Wrench { force, torque }
    }

    /// Returns the part along an axis of a joint, the generalized force there.
    fn along(&self, joint: &Joint, freedom: &Freedom) -> Expr {
        match joint.kind {
            Kind::Turns => dot(&freedom.axis, &self.torque),
            Kind::Slides => dot(&freedom.axis, &self.force),
        }
    }
}

impl Mechanism {
    /// Returns the generalized forces M q'' + b for accelerations of the coordinates, `None` for
    /// zeros.
    #[must_use]
    pub fn inverse_dynamics(
        &self,
        acceleration: impl Fn(CoordinateId) -> Option<Expr>,
    ) -> BTreeMap<CoordinateId, Expr> {
        let mut accelerations: Vec<[Vector; 2]> = Vec::with_capacity(self.joints.len());
        let mut wrenches: Vec<Wrench> = Vec::with_capacity(self.joints.len());
        for joint in &self.joints {
            let own = joint.freedoms.iter().map(|freedom| {
                let terms = freedom.slopes.iter();
                let terms = terms
                    .filter_map(|(id, slope)| Some(product([slope.clone(), acceleration(*id)?])));
                scaled(&sum(terms.chain([freedom.bias.clone()])).shared(), &freedom.axis)
            });
            let own = total(&own.collect::<Vec<_>>().iter().collect::<Vec<_>>());
            let parent = joint.parent.map(|parent| &accelerations[parent]);
            let parent = parent.cloned().unwrap_or_else(|| [zero(), self.lift()]);
            let moved = self.accelerated(joint, &parent, &own);
            wrenches.push(match &joint.inertia {
                Some(inertia) => inertial(inertia, &joint.motion.omega, &moved),
                None => Wrench::none(),
            });
            accelerations.push(moved);
        }
        let mut forces: BTreeMap<CoordinateId, Vec<Expr>> = BTreeMap::new();
        for (index, joint) in self.joints.iter().enumerate().rev() {
            let wrench = wrenches[index].clone();
            for freedom in &joint.freedoms {
                let along = wrench.along(joint, freedom);
                for (id, slope) in &freedom.slopes {
                    forces.entry(*id).or_default().push(product([slope.clone(), along.clone()]));
                }
            }
            if let Some(parent) = joint.parent {
                wrenches[parent] = wrenches[parent].plus(&wrench.on_parent_of(joint));
            }
        }
        forces.into_iter().map(|(id, parts)| (id, sum(parts).shared())).collect()
    }

    /// Returns the generalized forces of a wrench, a force and a torque about a point, on what moves
    /// with a frame. All of it is along the world's axes.
    #[must_use]
    pub fn generalized(
        &self,
        frame: &Frame,
        point: &Vector,
        [force, torque]: &[Vector; 2],
    ) -> BTreeMap<CoordinateId, Expr> {
        let mut forces: BTreeMap<CoordinateId, Vec<Expr>> = BTreeMap::new();
        let Some(mut index) = frame.joint else { return BTreeMap::new() };
        let motion = &self.joints[index].motion;
        let arm = plus(point, &minus(&motion.position));
        let back = transposed(&motion.to_world);
        let mut wrench = Wrench {
            force: times(&back, force),
            torque: times(&back, &plus(torque, &cross(&arm, force))),
        };
        loop {
            let joint = &self.joints[index];
            for freedom in &joint.freedoms {
                let along = wrench.along(joint, freedom);
                for (id, slope) in freedom.slopes.iter().filter(|_| !along.is_zero()) {
                    forces.entry(*id).or_default().push(product([slope.clone(), along.clone()]));
                }
            }
            let Some(parent) = joint.parent else { break };
            wrench = wrench.on_parent_of(joint);
            index = parent;
        }
        forces.into_iter().map(|(id, parts)| (id, sum(parts).shared())).collect()
    }

    /// Returns angular acceleration, and acceleration of the origin less gravity, of a joint from
    /// those of its parent and its own, the sum of n s''.
    pub(super) fn accelerated(
        &self,
        joint: &Joint,
        parent: &[Vector; 2],
        own: &Vector,
    ) -> [Vector; 2] {
        let [turning, moving] = parent;
        let omega = joint.parent.map_or_else(zero, |p| self.joints[p].motion.omega.clone());
        let inward = times(&gradient(&omega, turning), &joint.displacement);
        let origin = plus(moving, &inward);
        let [turning, moving] = [turning, &origin].map(|a| times(&joint.orientation, a));
        let carried = times(&joint.orientation, &omega);
        let coriolis = cross(&carried, &joint.relative);
        match joint.kind {
            Kind::Turns => [total(&[&turning, own, &coriolis]), moving],
            Kind::Slides => [turning, total(&[&moving, own, &coriolis, &coriolis])],
        }
    }

    /// Returns the nonzeros of the lower triangle of M.
    #[must_use]
    pub fn mass_matrix(&self) -> BTreeMap<(CoordinateId, CoordinateId), Expr> {
        let composites = self.composites();
        let mut entries: BTreeMap<(CoordinateId, CoordinateId), Vec<Expr>> = BTreeMap::new();
        for (index, joint) in self.joints.iter().enumerate() {
            let Some(composite) = &composites[index] else { continue };
            for (number, freedom) in joint.freedoms.iter().enumerate() {
                if freedom.slopes.is_empty() {
                    continue;
                }
                let mut wrench = of_unit_acceleration(composite, joint.kind, &freedom.axis);
                for other in &joint.freedoms[..number] {
                    let along = wrench.along(joint, other);
                    add_products(&mut entries, freedom, other, &along, false);
                }
                let along = wrench.along(joint, freedom);
                add_products(&mut entries, freedom, freedom, &along, true);
                let mut place = index;
                while let Some(parent) = self.joints[place].parent {
                    wrench = wrench.on_parent_of(&self.joints[place]);
                    place = parent;
                    let at = &self.joints[place];
                    for other in &at.freedoms {
                        let along = wrench.along(at, other);
                        add_products(&mut entries, freedom, other, &along, false);
                    }
                }
            }
        }
        entries.into_iter().map(|(place, parts)| (place, sum(parts).shared())).collect()
    }

    /// Returns for each joint the inertia of everything that it carries.
    fn composites(&self) -> Vec<Option<Inertia>> {
        let mut all: Vec<Option<Inertia>> =
            self.joints.iter().map(|joint| joint.inertia.clone()).collect();
        for (index, joint) in self.joints.iter().enumerate().rev() {
            let (Some(own), Some(parent)) = (&all[index], joint.parent) else { continue };
            let carried = on_parent(own, joint);
            all[parent] = Some(match all[parent].take() {
                None => carried,
                Some(before) => Inertia {
                    mass: sum([before.mass, carried.mass]).shared(),
                    moment: plus(&before.moment, &carried.moment),
                    tensor: symmetric_sum(&[&before.tensor, &carried.tensor]),
                },
            });
        }
        all
    }
}

/// Returns A = \[omega'\]x + \[omega\]x \[omega\]x, the gradient of accelerations in a body: a point at r
/// from a point with the acceleration a has a + A r.
fn gradient(omega: &Vector, turning: &Vector) -> Matrix3 {
    let squares = omega.each_ref().map(|w| product([w.clone(), w.clone()]).shared());
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let [j, k] = [1, 2].map(|next| squares[(i + next) % 3].clone());
                return negative(&sum([j, k]).shared());
            }
            let k = 3 - i - j;
            let both = product([omega[i.min(j)].clone(), omega[i.max(j)].clone()]).shared();
            let own = if j == (i + 1) % 3 { negative(&turning[k]) } else { turning[k].clone() };
            sum([both, own]).shared()
        })
    })
}

/// Returns the wrench that accelerates bodies: force m a + A h, torque I omega' + omega x (I omega)
/// + h x a.
pub(super) fn inertial(inertia: &Inertia, omega: &Vector, moved: &[Vector; 2]) -> Wrench {
    let [turning, moving] = moved;
    let Inertia { mass, moment, tensor } = inertia;
    let gradient = gradient(omega, turning);
    let force = plus(&scaled(mass, moving), &times(&gradient, moment));
    let is_diagonal = (0..3).all(|i| (0..i).all(|j| tensor[i][j].is_zero()));
    let about_origin = if is_diagonal {
        plus(&times(tensor, turning), &cross(omega, &times(tensor, omega)))
    } else {
        moment_of(&gradient, tensor)
    };
    let torque = plus(&about_origin, &cross(moment, moving));
    Wrench { force, torque }
}

/// Returns the sum of r x A r dm over a body, of which the inertia is known: the same as I omega' +
/// omega x (I omega), with fewer operations unless I is diagonal. With S = (tr I/2) 1 - I, the sum of
/// r r^T dm, its component i is (A S)_kj - (A S)_jk.
fn moment_of(gradient: &Matrix3, tensor: &Matrix3) -> Vector {
    let half = Expr::Number(BigRational::new(1.into(), 2.into()));
    let second: Matrix3 = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i != j {
                return negative(&tensor[i][j]);
            }
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            let others = [tensor[j][j].clone(), tensor[k][k].clone(), negative(&tensor[i][i])];
            product([half.clone(), sum(others)]).shared()
        })
    });
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let ahead = (0..3).map(|l| product([gradient[k][l].clone(), second[l][j].clone()]));
        let behind =
            (0..3).map(|l| negative(&product([gradient[j][l].clone(), second[l][k].clone()])));
        sum(ahead.chain(behind)).shared()
    })
}

/// Returns the wrench that gives a composite body the acceleration s'' = 1 about or along an axis.
fn of_unit_acceleration(composite: &Inertia, kind: Kind, axis: &Vector) -> Wrench {
    let Inertia { mass, moment, tensor } = composite;
    match kind {
        Kind::Turns => Wrench { force: cross(axis, moment), torque: times(tensor, axis) },
        Kind::Slides => Wrench { force: scaled(mass, axis), torque: cross(moment, axis) },
    }
}

/// Returns an inertia about the origin of the parent, along its axes.
fn on_parent(inertia: &Inertia, joint: &Joint) -> Inertia {
    let r = &joint.displacement;
    let back: Matrix3 = transposed(&joint.orientation);
    let turned = times(&back, &inertia.moment);
    let tensor = congruent(&back, &inertia.tensor);
    let tensor = symmetric_sum(&[&tensor, &of_moment(&turned, r), &of_point(&inertia.mass, r)]);
    let moment = plus(&turned, &scaled(&inertia.mass, r));
    Inertia { mass: inertia.mass.clone(), moment, tensor }
}

/// Adds what the entry of M of two motions contributes to those of their coordinates.
fn add_products(
    entries: &mut BTreeMap<(CoordinateId, CoordinateId), Vec<Expr>>,
    one: &Freedom,
    other: &Freedom,
    entry: &Expr,
    is_same: bool,
) {
    for (i, a) in &one.slopes {
        for (j, b) in &other.slopes {
            if is_same && j > i {
                continue;
            }
            let part = product([a.clone(), b.clone(), entry.clone()]);
            // Two motions that follow one coordinate occur in both orders.
            let count = if i == j && !is_same { 2 } else { 1 };
            let part = product([Expr::integer(count), part]);
            if !part.is_zero() {
                entries.entry(((*i).max(*j), (*i).min(*j))).or_default().push(part);
            }
        }
    }
}

/// Returns the symbol of an acceleration.
#[must_use]
pub fn acceleration(id: CoordinateId) -> Option<Expr> {
    Some(Expr::Symbol(Symbol::Acceleration(id)))
}

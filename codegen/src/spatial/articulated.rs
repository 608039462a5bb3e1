//! Accelerations of a mechanism by recursion along its tree, without its mass matrix.
//!
//! ```text
//! force = M a + H^T alpha + p_f        torque = H a + I alpha + p_t
//! ```
//!
//! are the force and torque that give a joint, with everything it carries and may move, the
//! accelerations a and alpha: the articulated-body algorithm, R. Featherstone, Rigid Body Dynamics
//! Algorithms, Springer 2008, section 7.3. The number of operations is linear in that of joints.

use std::collections::{BTreeMap, BTreeSet};

use machinist_algebra::cas::arithmetic::{negative, normal_form, product, sum};
use machinist_algebra::expr::{CoordinateId, Expr};
use num_rational::BigRational;

use super::mechanism::{Inertia, Joint, Kind, Mechanism};
use super::recursion::{Wrench, inertial};
use super::vector::{
    Matrix3, Vector, congruent, cross, dot, multiplied, plus, scaled, skew, symmetric_sum, times,
    total, transposed, zero,
};

/// Inertia of a joint and of everything that it carries and may move.
#[derive(Clone)]
struct Articulated {
    /// M, symmetric.
    mass: Matrix3,
    /// H.
    coupling: Matrix3,
    /// I, symmetric.
    tensor: Matrix3,
}

/// A motion that has been eliminated.
struct Eliminated {
    coordinate: CoordinateId,
    kind: Kind,
    /// Acceleration per q''.
    axis: Vector,
    /// Force and torque per q''.
    unit: Wrench,
    /// Inverse of the inertia that q'' feels.
    inverse: Expr,
    /// Generalized force left for q''.
    force: Expr,
}

impl Mechanism {
    /// Returns q'' for generalized forces, with additional inertias of the coordinates. `None` if a
    /// coordinate moves several joints, if a joint follows several, or if a joint carries nothing.
    #[must_use]
    pub fn forward_dynamics(
        &self,
        force: impl Fn(CoordinateId) -> Expr,
        inertia: impl Fn(CoordinateId) -> Option<Expr>,
    ) -> Option<BTreeMap<CoordinateId, Expr>> {
        if !self.moves_each_joint_alone() {
            return None;
        }
        let mut bodies: Vec<Option<Articulated>> =
            self.joints.iter().map(|joint| joint.inertia.as_ref().map(Articulated::of)).collect();
        let mut wrenches: Vec<Wrench> = self.joints.iter().map(Mechanism::at_rest).collect();
        let biases: Vec<[Vector; 2]> =
            self.joints.iter().map(|joint| self.bias_acceleration(joint)).collect();
        let mut eliminated = Vec::with_capacity(self.joints.len());
        for (index, joint) in self.joints.iter().enumerate().rev() {
            let mut body = bodies[index].clone()?;
            let mut wrench = wrenches[index].clone();
            let mut motions = Vec::new();
            for freedom in &joint.freedoms {
                let Some((id, slope)) = freedom.slopes.first() else { continue };
                let axis = scaled(slope, &freedom.axis);
                let own = inertia(*id);
                let is_alone = own.is_none();
                let motion = body.motion(joint.kind, *id, axis, own, &wrench, force(*id));
                let taken = product([motion.inverse.clone(), motion.force.clone()]).shared();
                wrench = wrench.plus(&motion.unit.times(&taken));
                body = body.without(&motion, is_alone);
                motions.push(motion);
            }
            eliminated.push(motions);
            if let Some(parent) = joint.parent {
                let wrench = wrench.plus(&body.wrench(&biases[index]));
                wrenches[parent] = wrenches[parent].plus(&wrench.on_parent_of(joint));
                let carried = body.on_parent_of(joint);
                bodies[parent] = Some(match bodies[parent].take() {
                    None => carried,
                    Some(before) => before.plus(&carried),
                });
            }
        }
        eliminated.reverse();
        Some(self.accelerations(&biases, &eliminated))
    }

    /// Reports whether each coordinate moves one joint, and each joint's motions follow at most one
    /// coordinate each.
    fn moves_each_joint_alone(&self) -> bool {
        let mut known = BTreeSet::new();
        let mut freedoms = self.joints.iter().flat_map(|joint| &joint.freedoms);
        freedoms.all(|freedom| {
            freedom.slopes.len() <= 1 && freedom.slopes.iter().all(|(id, _)| known.insert(*id))
        })
    }

    /// Returns the wrench on the bodies of a joint that is not accelerated.
    fn at_rest(joint: &Joint) -> Wrench {
        let wrench = |inertia| inertial(inertia, &joint.motion.omega, &[zero(), zero()]);
        joint.inertia.as_ref().map_or_else(Wrench::none, wrench)
    }

    /// Returns the acceleration of a joint whose parent and coordinates are not accelerated.
    fn bias_acceleration(&self, joint: &Joint) -> [Vector; 2] {
        let own = joint.freedoms.iter().map(|freedom| scaled(&freedom.bias, &freedom.axis));
        let own = total(&own.collect::<Vec<_>>().iter().collect::<Vec<_>>());
        self.accelerated(joint, &[zero(), zero()], &own)
    }

    /// Returns q'', from the world outwards.
    fn accelerations(
        &self,
        biases: &[[Vector; 2]],
        eliminated: &[Vec<Eliminated>],
    ) -> BTreeMap<CoordinateId, Expr> {
        let mut all: Vec<[Vector; 2]> = Vec::with_capacity(self.joints.len());
        let mut found = BTreeMap::new();
        for ((joint, bias), motions) in self.joints.iter().zip(biases).zip(eliminated) {
            let parent = joint.parent.map(|parent| all[parent].clone());
            let [turning, moving] = parent.unwrap_or_else(|| [zero(), self.lift()]);
            let moving = plus(&moving, &cross(&turning, &joint.displacement));
            let carried = [turning, moving].map(|a| times(&joint.orientation, &a));
            let mut moved = [plus(&carried[0], &bias[0]), plus(&carried[1], &bias[1])];
            for motion in motions.iter().rev() {
                let taken =
                    sum([dot(&motion.unit.torque, &moved[0]), dot(&motion.unit.force, &moved[1])]);
                let left = sum([motion.force.clone(), negative(&taken)]).shared();
                let acceleration = product([motion.inverse.clone(), left]).shared();
                let own = scaled(&acceleration, &motion.axis);
                let place = usize::from(motion.kind == Kind::Slides);
                moved[place] = plus(&moved[place], &own);
                found.insert(motion.coordinate, acceleration);
            }
            all.push(moved);
        }
        found
    }
}

impl Articulated {
    fn of(inertia: &Inertia) -> Self {
        let Inertia { mass, moment, tensor } = inertia;
        let entry = |i: usize, j: usize| if i == j { mass.clone() } else { Expr::integer(0) };
        let mass = std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)));
        Articulated { mass, coupling: skew(moment), tensor: tensor.clone() }
    }

    /// Returns the wrench that gives accelerations.
    fn wrench(&self, [turning, moving]: &[Vector; 2]) -> Wrench {
        let back = transposed(&self.coupling);
        Wrench {
            force: plus(&times(&self.mass, moving), &times(&back, turning)),
            torque: plus(&times(&self.coupling, moving), &times(&self.tensor, turning)),
        }
    }

    /// Returns what eliminates a motion, which feels an inertia of its own besides.
    fn motion(
        &self,
        kind: Kind,
        coordinate: CoordinateId,
        axis: Vector,
        own: Option<Expr>,
        wrench: &Wrench,
        force: Expr,
    ) -> Eliminated {
        let along = |wrench: &Wrench| match kind {
            Kind::Turns => dot(&axis, &wrench.torque),
            Kind::Slides => dot(&axis, &wrench.force),
        };
        let unit = self.wrench(&match kind {
            Kind::Turns => [axis.clone(), zero()],
            Kind::Slides => [zero(), axis.clone()],
        });
        let inertia = sum([along(&unit)].into_iter().chain(own)).shared();
        let minus_one = Expr::Number(BigRational::from_integer((-1).into()));
        let inverse = normal_form(&Expr::Power(Box::new(inertia), Box::new(minus_one))).shared();
        let force = sum([force, negative(&along(wrench))]).shared();
        Eliminated { coordinate, kind, axis, unit, inverse, force }
    }

    /// Returns the inertia that is left where a motion yields. Without an inertia of its own, it
    /// offers no resistance along an axis of the joint.
    fn without(&self, motion: &Eliminated, is_alone: bool) -> Self {
        let Wrench { force, torque } = &motion.unit;
        let shares = [force, torque].map(|wrench| scaled(&motion.inverse, wrench));
        let less = |matrix: &Matrix3, a: &Vector, share: &Vector, is_symmetric: bool| {
            let entry = |i: usize, j: usize| {
                let part = product([a[i].clone(), share[j].clone()]);
                sum([matrix[i][j].clone(), negative(&part)]).shared()
            };
            let place = |i: usize, j: usize| {
                if is_symmetric { entry(i.max(j), i.min(j)) } else { entry(i, j) }
            };
            std::array::from_fn(|i| std::array::from_fn(|j| place(i, j)))
        };
        let mut left = Articulated {
            mass: less(&self.mass, force, &shares[0], true),
            coupling: less(&self.coupling, torque, &shares[0], false),
            tensor: less(&self.tensor, torque, &shares[1], true),
        };
        let others = motion.axis.iter().filter(|entry| !entry.is_zero()).count();
        let along = motion.axis.iter().position(|entry| !entry.is_zero());
        if let (true, 1, Some(axis)) = (is_alone, others, along) {
            let none = || Expr::integer(0);
            for k in 0..3 {
                let (row, matrix) = match motion.kind {
                    Kind::Turns => (&mut left.coupling[axis][k], &mut left.tensor),
                    Kind::Slides => (&mut left.coupling[k][axis], &mut left.mass),
                };
                *row = none();
                matrix[axis][k] = none();
                matrix[k][axis] = none();
            }
        }
        left
    }

    /// Returns the same inertia about the origin of the joint that carries this one.
    fn on_parent_of(&self, joint: &Joint) -> Self {
        let back = transposed(&joint.orientation);
        let [mass, tensor] = [&self.mass, &self.tensor].map(|matrix| congruent(&back, matrix));
        let coupling = multiplied(&multiplied(&back, &self.coupling), &joint.orientation);
        let arm = skew(&joint.displacement);
        let shifted = matrix_sum(&coupling, &multiplied(&arm, &mass));
        let outer = multiplied(&arm, &transposed(&shifted));
        // -H [r]x = H [r]x^T
        let inner = multiplied(&coupling, &transposed(&arm));
        let tensor = symmetric_sum(&[&tensor, &inner, &outer]);
        Articulated { mass, coupling: shifted, tensor }
    }

    fn plus(&self, other: &Self) -> Self {
        Articulated {
            mass: symmetric_sum(&[&self.mass, &other.mass]),
            coupling: matrix_sum(&self.coupling, &other.coupling),
            tensor: symmetric_sum(&[&self.tensor, &other.tensor]),
        }
    }
}

fn matrix_sum(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| plus(&a[i], &b[i]))
}

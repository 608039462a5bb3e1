//! A tree of elementary joints that carries bodies.
//!
//! Each joint turns or moves along one fixed axis, or turns freely. Universal, cylindrical and other
//! joints are several of them in a row, and whatever is fixed to a joint belongs to it.

use machinist_algebra::cas::arithmetic::{derivative, negative, normal_form, product, sum};
use machinist_algebra::expr::{CoordinateId, Expr, Symbol};
use num_rational::BigRational;

use super::orientation::Orientation;
use super::vector::{
    Matrix3, Vector, congruent, cross, dot, identity, minus, multiplied, of_point, plus, rotation,
    scaled, symmetric_sum, times, total, transposed, zero,
};

/// Kind of an elementary joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// It turns about its axes \[rad\].
    Turns,
    /// It moves along its axes \[m\].
    Slides,
}

/// A motion of a joint about or along one axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Freedom {
    /// Vector n of the axis, along the joint's own axes; constant there, or its rate is that of a
    /// vector fixed to the parent.
    pub axis: Vector,
    /// s', the rate of the angle or length.
    pub rate: Expr,
    /// ds'/dq' of each coordinate that s depends on.
    pub slopes: Vec<(CoordinateId, Expr)>,
    /// The part of s'' that does not depend on accelerations.
    pub bias: Expr,
}

/// A joint, with everything that is fixed to it. Components are along its own axes unless stated
/// otherwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Identifier of the frame that it moves, for names in emitted code.
    pub name: String,
    /// The joint that carries it; `None` for the world.
    pub parent: Option<usize>,
    /// Kind.
    pub kind: Kind,
    /// E, which changes components along the parent's axes to those along its own.
    pub orientation: Matrix3,
    /// r, the position of its origin relative to the parent's origin, along the parent's axes \[m\].
    pub displacement: Vector,
    /// Motions relative to the parent: one, or three of a joint that turns freely.
    pub freedoms: Vec<Freedom>,
    /// Relative angular velocity or velocity, the sum of n s'.
    pub relative: Vector,
    /// True if its motion depends on time explicitly.
    pub is_driven: bool,
    /// Inertia of everything fixed to it.
    pub inertia: Option<Inertia>,
    /// Kinematics.
    pub motion: Motion,
}

/// Inertia of bodies that are fixed to each other, about the origin of a joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Inertia {
    /// m \[kg\].
    pub mass: Expr,
    /// h, mass times centre \[kg m\].
    pub moment: Vector,
    /// I, the inertia about the origin \[kg m^2\].
    pub tensor: Matrix3,
}

/// Position and velocity of a joint's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// R, which changes components along its axes to those along the world's.
    pub to_world: Matrix3,
    /// p, the position of its origin, along the world's axes \[m\].
    pub position: Vector,
    /// Angular velocity, along its own axes \[rad/s\].
    pub omega: Vector,
    /// Velocity of its origin, along its own axes \[m/s\].
    pub velocity: Vector,
}

impl Motion {
    fn at_rest() -> Self {
        Motion { to_world: identity(), position: zero(), omega: zero(), velocity: zero() }
    }
}

/// A frame fixed to a joint, or to the world.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// The joint that moves it; `None` for the world.
    pub joint: Option<usize>,
    /// Changes components along its axes to those along the joint's.
    pub to_joint: Matrix3,
    /// Position of its origin relative to the joint's origin, along the joint's axes \[m\].
    pub offset: Vector,
}

/// Position, orientation and velocities of a frame, along the world's axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// Position of the origin \[m\].
    pub position: Vector,
    /// Velocity of the origin \[m/s\].
    pub velocity: Vector,
    /// Angular velocity \[rad/s\].
    pub omega: Vector,
    /// Columns are the frame's axes.
    pub rotation: Matrix3,
}

/// Mass, centre and inertia of a body, along the axes of its frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// m \[kg\].
    pub mass: Expr,
    /// Centre of mass, relative to the frame's origin \[m\].
    pub centre: Vector,
    /// Inertia about the centre \[kg m^2\].
    pub tensor: Matrix3,
    /// Changes components along the axes of `tensor` to those along the frame's.
    pub rotation: Matrix3,
}

/// Trees of joints in uniform gravity.
#[derive(Debug, Clone, PartialEq)]
pub struct Mechanism {
    /// Joints; each follows the one that carries it.
    pub joints: Vec<Joint>,
    /// Acceleration of free fall, along the world's axes \[m/s^2\].
    pub gravity: Vector,
}

impl Mechanism {
    /// Returns a mechanism without joints.
    #[must_use]
    pub fn new(gravity: Vector) -> Self {
        Mechanism { joints: Vec::new(), gravity }
    }

    /// Returns the frame of the world.
    #[must_use]
    pub fn world() -> Frame {
        Frame { joint: None, to_joint: identity(), offset: zero() }
    }

    fn motion(&self, joint: Option<usize>) -> Motion {
        joint.map_or_else(Motion::at_rest, |joint| self.joints[joint].motion.clone())
    }

    /// Returns the position of a frame and its axes as columns, along the world's axes.
    #[must_use]
    pub fn pose(&self, frame: &Frame) -> (Vector, Matrix3) {
        let Motion { to_world, position, .. } = self.motion(frame.joint);
        let position = plus(&position, &times(&to_world, &frame.offset));
        (position, multiplied(&to_world, &frame.to_joint))
    }

    /// Returns the position of a frame and its axes as columns, from the origin and along the axes of a
    /// joint that carries it.
    #[must_use]
    pub fn pose_on(&self, carrier: usize, frame: &Frame) -> (Vector, Matrix3) {
        let (mut position, mut turn) = (frame.offset.clone(), frame.to_joint.clone());
        for joint in self.carriers(frame).take_while(|joint| *joint != carrier) {
            let Joint { orientation, displacement, .. } = &self.joints[joint];
            let to_parent = transposed(orientation);
            position = plus(displacement, &times(&to_parent, &position));
            turn = multiplied(&to_parent, &turn);
        }
        (position, turn)
    }

    /// Returns the outermost joint that carries all of some frames; `None` for the world.
    #[must_use]
    pub fn common_carrier(&self, frames: &[&Frame]) -> Option<usize> {
        let (first, others) = frames.split_first()?;
        let carries = |joint: &usize, frame: &Frame| self.carriers(frame).any(|one| one == *joint);
        self.carriers(first).find(|joint| others.iter().all(|other| carries(joint, other)))
    }

    /// Returns the joints that carry a frame, inwards.
    fn carriers(&self, frame: &Frame) -> impl Iterator<Item = usize> {
        std::iter::successors(frame.joint, |joint| self.joints[*joint].parent)
    }

    /// Returns the world's view of a frame.
    #[must_use]
    pub fn placed(&self, frame: &Frame) -> Placed {
        let Motion { to_world, position, omega, velocity } = self.motion(frame.joint);
        let own = plus(&velocity, &cross(&omega, &frame.offset));
        Placed {
            position: plus(&position, &times(&to_world, &frame.offset)),
            velocity: times(&to_world, &own),
            omega: times(&to_world, &omega),
            rotation: multiplied(&to_world, &frame.to_joint),
        }
    }

    /// Adds a joint at a frame and returns the frame that it moves. `axis` is a unit vector along
    /// the frame's axes, `s` the angle or length, of coordinates, time and parameters.
    pub fn add(&mut self, name: &str, kind: Kind, at: &Frame, axis: &Vector, s: &Expr) -> Frame {
        let s = normal_form(s);
        let (rate, slopes, bias) = rates(&s);
        let freedoms = vec![Freedom { axis: axis.clone(), rate, slopes, bias }];
        let is_driven = s.mentions(|symbol| symbol == Symbol::Time);
        // The joint's own axes are those of the frame, turned by a revolute joint.
        let (to_parent, displacement) = match kind {
            Kind::Turns => (multiplied(&at.to_joint, &rotation(axis, &s)), at.offset.clone()),
            Kind::Slides => {
                let way = times(&at.to_joint, &scaled(&s, axis));
                (at.to_joint.clone(), plus(&at.offset, &way))
            }
        };
        self.push(name, at.joint, kind, freedoms, is_driven, (to_parent, displacement))
    }

    /// Adds a joint at a frame that turns freely and returns the frame that it moves. If not
    /// `forward`, the frame is the one that the orientation turns, and the other is returned.
    pub fn add_spherical(
        &mut self,
        name: &str,
        at: &Frame,
        by: &Orientation,
        forward: bool,
    ) -> Frame {
        let matrix = by.matrix();
        let columns = transposed(&matrix);
        let freedom = |axis: usize| Freedom {
            // Backwards, the axes are fixed to the parent: -R n, whose rate along the own axes is
            // that of the rotation about themselves.
            axis: if forward { identity()[axis].clone() } else { minus(&columns[axis]) },
            rate: Expr::Symbol(Symbol::Velocity(by.vector[axis])),
            slopes: vec![(by.vector[axis], Expr::integer(1))],
            bias: Expr::integer(0),
        };
        let freedoms = (0..3).map(freedom).collect();
        let turned = if forward { matrix } else { columns };
        let moved = (multiplied(&at.to_joint, &turned), at.offset.clone());
        self.push(name, at.joint, Kind::Turns, freedoms, false, moved)
    }

    /// Adds a joint whose axes and origin are given along those of its parent.
    fn push(
        &mut self,
        name: &str,
        parent: Option<usize>,
        kind: Kind,
        freedoms: Vec<Freedom>,
        is_driven: bool,
        (to_parent, displacement): (Matrix3, Vector),
    ) -> Frame {
        let carrier = self.motion(parent);
        let orientation = transposed(&to_parent);
        let carried = times(&orientation, &carrier.omega);
        let velocity =
            times(&orientation, &plus(&carrier.velocity, &cross(&carrier.omega, &displacement)));
        let own: Vec<Vector> =
            freedoms.iter().map(|freedom| scaled(&freedom.rate, &freedom.axis)).collect();
        let relative = total(&own.iter().collect::<Vec<_>>());
        let (omega, velocity) = match kind {
            Kind::Turns => (plus(&carried, &relative), velocity),
            Kind::Slides => (carried, plus(&velocity, &relative)),
        };
        let motion = Motion {
            to_world: multiplied(&carrier.to_world, &to_parent),
            position: plus(&carrier.position, &times(&carrier.to_world, &displacement)),
            omega: named(omega, name, "omega"),
            velocity: named(velocity, name, "velocity"),
        };
        self.joints.push(Joint {
            name: name.to_owned(),
            parent,
            kind,
            orientation,
            displacement,
            freedoms,
            relative,
            is_driven,
            inertia: None,
            motion,
        });
        let joint = Some(self.joints.len() - 1);
        Frame { joint, to_joint: identity(), offset: zero() }
    }

    /// Fixes a body to a frame. Bodies fixed to the world have no effect.
    pub fn attach(&mut self, frame: &Frame, body: &Body) {
        let Some(joint) = frame.joint else { return };
        let centre = plus(&frame.offset, &times(&frame.to_joint, &body.centre));
        let axes = multiplied(&frame.to_joint, &body.rotation);
        let about_centre = congruent(&axes, &body.tensor);
        let tensor = symmetric_sum(&[&about_centre, &of_point(&body.mass, &centre)]);
        let moment = scaled(&body.mass, &centre);
        let inertia = &mut self.joints[joint].inertia;
        *inertia = Some(match inertia.take() {
            None => Inertia { mass: body.mass.clone(), moment, tensor },
            Some(before) => Inertia {
                mass: sum([before.mass, body.mass.clone()]).shared(),
                moment: plus(&before.moment, &moment),
                tensor: symmetric_sum(&[&before.tensor, &tensor]),
            },
        });
    }

    /// Returns T = sum of m v.v/2 + v.(omega x h) + omega.(I omega)/2 over the joints \[J\].
    #[must_use]
    pub fn kinetic(&self) -> Expr {
        let half = Expr::Number(BigRational::new(1.into(), 2.into()));
        let terms = self.inertias().flat_map(|(joint, inertia)| {
            let Motion { omega, velocity, .. } = &joint.motion;
            let speed = dot(velocity, velocity);
            [
                product([half.clone(), inertia.mass.clone(), speed]),
                dot(velocity, &cross(omega, &inertia.moment)),
                product([half.clone(), dot(omega, &times(&inertia.tensor, omega))]),
            ]
        });
        sum(terms.collect::<Vec<_>>())
    }

    /// Returns V = -sum of g.(m p + R h) over the joints \[J\].
    #[must_use]
    pub fn potential(&self) -> Expr {
        let terms = self.inertias().map(|(joint, inertia)| {
            let Motion { to_world, position, .. } = &joint.motion;
            let moment = times(to_world, &inertia.moment);
            let moment = total(&[&scaled(&inertia.mass, position), &moment]);
            negative(&dot(&self.gravity, &moment))
        });
        sum(terms.collect::<Vec<_>>())
    }

    /// Reports whether T is not quadratic in the velocities, because joints are driven.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        self.joints.iter().any(|joint| joint.is_driven)
    }

    fn inertias(&self) -> impl Iterator<Item = (&Joint, &Inertia)> {
        self.joints.iter().filter_map(|joint| Some((joint, joint.inertia.as_ref()?)))
    }

    /// Returns -g, the acceleration of the world in a frame that falls freely.
    #[must_use]
    pub fn lift(&self) -> Vector {
        minus(&self.gravity)
    }
}

/// Returns s', ds/dq of each coordinate, and the part of s'' without accelerations, for s(q, t).
fn rates(s: &Expr) -> (Expr, Vec<(CoordinateId, Expr)>, Expr) {
    let coordinates = s.symbols().into_iter().filter_map(|symbol| match symbol {
        Symbol::Coordinate(id) => Some(id),
        _ => None,
    });
    let slopes: Vec<(CoordinateId, Expr)> =
        coordinates.map(|id| (id, derivative(s, Symbol::Coordinate(id)))).collect();
    let rate = along(s, &slopes);
    let by: Vec<(CoordinateId, Expr)> =
        slopes.iter().map(|(id, _)| (*id, derivative(&rate, Symbol::Coordinate(*id)))).collect();
    let bias = along(&rate, &by);
    let slopes = slopes.into_iter().map(|(id, slope)| (id, slope.shared())).collect();
    (rate.shared(), slopes, bias.shared())
}

/// Returns dx/dt without accelerations, given dx/dq.
fn along(x: &Expr, slopes: &[(CoordinateId, Expr)]) -> Expr {
    let by_coordinates = slopes
        .iter()
        .map(|(id, slope)| product([slope.clone(), Expr::Symbol(Symbol::Velocity(*id))]));
    sum(by_coordinates.chain([derivative(x, Symbol::Time)]))
}

/// Gives the components of a vector names for emitted code.
fn named(vector: Vector, joint: &str, what: &str) -> Vector {
    let mut axes = ["x", "y", "z"].into_iter();
    vector.map(|entry| match (entry, axes.next()) {
        (Expr::Shared(shared), Some(axis)) => {
            let name = format!("{joint}_{what}_{axis}");
            shared.definition().clone().shared_as(Some(name))
        }
        (entry, _) => entry,
    })
}

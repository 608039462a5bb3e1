//! Joints that move no inertia, alone or together with others.
//!
//! The mass matrix of a tree of joints is singular where the articulated inertia of a joint, with the
//! joints that it carries free to move, is zero along its motion (Featherstone, Rigid Body Dynamics
//! Algorithms, 2008, chapter 7). All quantities are about the origin of the world, in its axes.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::AddAssign;

use machinist_codegen::spec::ROUNDED_GYRATION;
use nalgebra::{
    DMatrix, DVector, Isometry3, Matrix3, Matrix6, SymmetricEigen, Translation3, Unit,
    UnitQuaternion, Vector3, Vector6,
};

use super::shapes::isometry;
use super::tree::{Inertial, Joint, Link, Motion, Robot, RobotError};

/// Number of positions at which joints have to move no inertia to do so everywhere.
const PLACES: usize = 4;

/// A joint at a position, with what it carries.
struct Moved {
    /// Index of the joint.
    joint: usize,
    /// Velocities of the link by the joint's coordinates: angular, then linear at the origin.
    motions: Vec<Vector6<f64>>,
    /// Articulated inertia along them, inverted where it is not zero.
    inverse: DMatrix<f64>,
    /// Articulated inertia times the motions.
    momenta: Vec<Vector6<f64>>,
    /// Motion of the joint's coordinates without articulated inertia, if there is one.
    free: Option<DVector<f64>>,
    /// True if there is none even with the joints that it carries held.
    is_bare: bool,
}

/// Articulated inertia of a link, and that with all joints that it carries held.
#[derive(Clone, Copy, Default)]
struct Carried {
    free: Matrix6<f64>,
    held: Matrix6<f64>,
}

impl AddAssign for Carried {
    fn add_assign(&mut self, other: Self) {
        self.free += other.free;
        self.held += other.held;
    }
}

impl Robot {
    /// Holds joints that move mass on their axis only, and refuses those that move nothing with inertia
    /// together with others at any position. Notes those that do so with all joints at zero.
    ///
    /// # Errors
    /// The first joint that moves no inertia.
    pub(super) fn check_motions(&mut self) -> Result<(), RobotError> {
        let (judged, held) = (self.judged(), self.held.len());
        let places: Vec<_> = (0..PLACES).map(|place| self.moved(place)).collect();
        let is_bare = |one: &Moved| {
            one.is_bare && matches!(self.joints[one.joint].motion, Motion::Turns | Motion::Slides)
        };
        let bare = places_where(&places, &judged, is_bare);
        for (joint, _) in bare.into_iter().filter(|(_, is_everywhere)| *is_everywhere) {
            self.joints[joint].motion = Motion::Fixed;
            self.held.push(self.joints[joint].name.clone());
        }
        let places: Vec<_> = (0..PLACES).map(|place| self.moved(place)).collect();
        let mut weak = Vec::new();
        for (joint, is_everywhere) in places_where(&places, &judged, |one| one.free.is_some()) {
            let Some(one) = places[0].iter().find(|one| one.joint == joint) else { continue };
            let (joints, link) = self.without_inertia(&places[0], one);
            if is_everywhere {
                let message = format!("{joints} at any position");
                let help =
                    format!("give link `{link}` its inertia about its centre, or fix a joint");
                return Err(RobotError::new(self.joints[joint].line, message, help));
            }
            weak.push(format!(
                "{joints} where all joints are at zero, so that no run can start there: link `{link}` has no \
                 inertia about its centre"
            ));
        }
        self.weak = weak;
        if self.held.len() > held && places[0].is_empty() {
            let name = self.held.last().cloned().unwrap_or_default();
            let message = format!("joint `{name}` moves no inertia, and nothing else moves");
            return Err(RobotError::new(0, message, "give its link an inertia about its axis"));
        }
        Ok(())
    }

    /// Returns the inertia that each joint feels with all joints at zero and the others free: the inverse of
    /// the mean entry of the inverted mass matrix on its diagonal. `None` if the matrix is singular.
    pub(super) fn felt(&self) -> Option<BTreeMap<String, f64>> {
        let carriers = self.carriers();
        let mut columns = BTreeMap::new();
        let mut armatures = Vec::new();
        for (at, joint) in self.joints.iter().enumerate() {
            let motions = joint.motions(&self.at_zero(&joint.child));
            columns.insert(at, armatures.len()..armatures.len() + motions.len());
            armatures.extend(motions.into_iter().map(|motion| (motion, joint.armature)));
        }
        let armature = armatures.iter().map(|(_, armature)| *armature);
        let mut mass = DMatrix::from_diagonal(&DVector::from_iterator(armatures.len(), armature));
        for link in self.links.iter().filter(|link| link.inertial.is_some()) {
            let inertia = link.inertia_about_origin(&self.at_zero(&link.name));
            let moved = self.above(&carriers, &link.name).into_iter();
            let moved: Vec<usize> = moved.flat_map(|at| columns[&at].clone()).collect();
            for i in &moved {
                let momentum = inertia * armatures[*i].0;
                for k in &moved {
                    mass[(*i, *k)] += momentum.dot(&armatures[*k].0);
                }
            }
        }
        let inverse = mass.cholesky()?.inverse();
        let felt = |range: std::ops::Range<usize>| {
            range.len() as f64 / range.map(|i| inverse[(i, i)]).sum::<f64>()
        };
        let moving = columns.into_iter().filter(|(_, range)| !range.is_empty());
        Some(moving.map(|(at, range)| (self.joints[at].name.clone(), felt(range))).collect())
    }

    /// Returns the joints whose motion inertia alone determines: neither do they carry a link in a loop,
    /// nor do others follow them.
    fn judged(&self) -> BTreeSet<usize> {
        let carriers = self.carriers();
        let ends = self.closures.iter().flat_map(|one| [&one.joint.parent, &one.joint.child]);
        let mut others: BTreeSet<usize> =
            ends.flat_map(|link| self.above(&carriers, link)).collect();
        let leaders: BTreeSet<&str> =
            self.joints.iter().filter_map(|joint| Some(&*joint.mimic.as_ref()?.joint)).collect();
        let leads = |at: &usize| leaders.contains(&*self.joints[*at].name);
        others.extend((0..self.joints.len()).filter(leads));
        (0..self.joints.len()).filter(|at| !others.contains(at)).collect()
    }

    /// Returns the joints that move at a position, each after those that it carries.
    fn moved(&self, place: usize) -> Vec<Moved> {
        let Some(root) = self.root() else { return Vec::new() };
        let (order, carriers) = (self.order(root), self.carriers());
        let mut poses: BTreeMap<&str, Isometry3<f64>> = BTreeMap::new();
        for link in &order {
            let pose = carriers.get(&*link.name).map(|at| {
                let joint = &self.joints[*at];
                poses[&*joint.parent] * isometry(&joint.origin) * joint.moved_at(place, *at)
            });
            poses.insert(&link.name, pose.unwrap_or_default());
        }
        let mut inertias: BTreeMap<&str, Carried> = BTreeMap::new();
        let mut all = Vec::new();
        for link in order.iter().rev() {
            let own = link.inertia_about_origin(&poses[&*link.name]);
            let mut carried = inertias.remove(&*link.name).unwrap_or_default();
            carried += Carried { free: own, held: own };
            let Some(at) = carriers.get(&*link.name) else { continue };
            let joint = &self.joints[*at];
            let motions = joint.motions(&poses[&*link.name]);
            if !motions.is_empty() {
                let moved = Moved::new(*at, joint, motions, &carried);
                let momenta = DMatrix::from_fn(6, moved.momenta.len(), |i, k| moved.momenta[k][i]);
                let taken = &momenta * &moved.inverse * momenta.transpose();
                carried.free -= Matrix6::from_fn(|i, k| taken[(i, k)]);
                all.push(moved);
            }
            *inertias.entry(&joint.parent).or_default() += carried;
        }
        all
    }

    /// Returns a phrase about the joints that move together without inertia, and the name of the heaviest
    /// link that they carry and that has no inertia about its centre.
    fn without_inertia(&self, all: &[Moved], first: &Moved) -> (String, String) {
        let carriers = self.carriers();
        let child = &self.joints[first.joint].child;
        let base = self.links.iter().find(|link| link.name == *child);
        let below = base.map(|base| self.order(base)).unwrap_or_default();
        let mut velocities: BTreeMap<&str, Vector6<f64>> = BTreeMap::new();
        let mut names = Vec::new();
        for link in &below {
            let Some(at) = carriers.get(&*link.name) else { continue };
            let joint = &self.joints[*at];
            let mut velocity = velocities.get(&*joint.parent).copied().unwrap_or_default();
            if let Some(moved) = all.iter().find(|moved| moved.joint == *at) {
                let free = moved.free.clone().filter(|_| *at == first.joint);
                let speeds = free.unwrap_or_else(|| moved.speeds(&velocity));
                if speeds.amax() > ROUNDED_GYRATION {
                    names.push(format!("`{}`", joint.name));
                }
                for (motion, speed) in moved.motions.iter().zip(speeds.iter()) {
                    velocity += motion * *speed;
                }
            }
            velocities.insert(&link.name, velocity);
        }
        let mass = |link: &&&Link| link.inertial.map_or(0.0, |inertial| inertial.mass);
        let is_point = |link: &&&Link| link.inertial.is_none_or(|inertial| inertial.is_point());
        let heaviest = |links: &mut dyn Iterator<Item = &&Link>| -> Option<String> {
            let heaviest = links.max_by(|a, b| mass(a).total_cmp(&mass(b)));
            heaviest.map(|link| link.name.clone())
        };
        let points = heaviest(&mut below.iter().filter(is_point));
        let link = points.or_else(|| heaviest(&mut below.iter())).unwrap_or_default();
        let joints = if names.len() == 1 {
            format!("joint {} moves no inertia", names[0])
        } else {
            format!("joints {} move no inertia together", names.join(", "))
        };
        (joints, link)
    }
}

impl Inertial {
    /// Reports whether the mass is in one point.
    fn is_point(&self) -> bool {
        self.inertia.iter().all(|entry| entry.abs() <= self.mass * ROUNDED_GYRATION.powi(2))
    }
}

impl Link {
    /// Returns the inertia about the origin of the world, given the pose of the link.
    fn inertia_about_origin(&self, pose: &Isometry3<f64>) -> Matrix6<f64> {
        let mut whole = Matrix6::zeros();
        let Some(Inertial { origin, mass, inertia }) = self.inertial else { return whole };
        let at = pose * isometry(&origin);
        let [xx, yy, zz, xy, xz, yz] = inertia;
        let turn = at.rotation.to_rotation_matrix();
        let own = turn * Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz) * turn.transpose();
        let arm = at.translation.vector.cross_matrix();
        whole.fixed_view_mut::<3, 3>(0, 0).copy_from(&(own + arm.transpose() * arm * mass));
        whole.fixed_view_mut::<3, 3>(0, 3).copy_from(&(arm * mass));
        whole.fixed_view_mut::<3, 3>(3, 0).copy_from(&(arm.transpose() * mass));
        whole.fixed_view_mut::<3, 3>(3, 3).fill_diagonal(mass);
        whole
    }
}

impl Joint {
    /// Returns the motion of the joint at a place, of which the first is zero.
    fn moved_at(&self, place: usize, index: usize) -> Isometry3<f64> {
        // Multiples of the golden section are spread evenly, and no two joints move alike.
        let spread = ((1 + index) as f64 * place as f64 * 0.618_034).fract() * 2.0 - 1.0;
        self.moved(if place == 0 { 0.0 } else { spread })
    }

    /// Returns the motion of the joint at a position.
    pub(super) fn moved(&self, share: f64) -> Isometry3<f64> {
        let axis = Unit::try_new(Vector3::from(self.axis), 0.0);
        let turned = |turn| Isometry3::from_parts(Translation3::identity(), turn);
        match (self.motion, axis) {
            (Motion::Turns, Some(axis)) => turned(UnitQuaternion::from_axis_angle(&axis, share)),
            (Motion::Slides, Some(axis)) => Translation3::from(*axis * share).into(),
            (Motion::Rolls, _) => {
                turned(UnitQuaternion::from_euler_angles(share, -share / 2.0, share / 3.0))
            }
            _ => Isometry3::identity(),
        }
    }

    /// Returns velocities of the link by the joint's coordinates, given its pose; none if the joint follows
    /// another.
    fn motions(&self, pose: &Isometry3<f64>) -> Vec<Vector6<f64>> {
        let turn = |axis: Vector3<f64>| {
            let linear = pose.translation.vector.cross(&axis);
            Vector6::new(axis.x, axis.y, axis.z, linear.x, linear.y, linear.z)
        };
        let slide = |axis: Vector3<f64>| Vector6::new(0.0, 0.0, 0.0, axis.x, axis.y, axis.z);
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let own = pose.rotation * Vector3::from(self.axis).normalize();
        match self.motion {
            _ if self.mimic.is_some() => Vec::new(),
            Motion::Fixed => Vec::new(),
            Motion::Turns => vec![turn(own)],
            Motion::Slides => vec![slide(own)],
            Motion::Rolls => axes.map(turn).to_vec(),
            Motion::Floats => axes.map(turn).into_iter().chain(axes.map(slide)).collect(),
        }
    }
}

/// Returns the joints, among some, for which a condition holds with all joints at zero, each with true if
/// it holds at the other places too.
fn places_where(
    places: &[Vec<Moved>],
    among: &BTreeSet<usize>,
    is_so: impl Fn(&Moved) -> bool,
) -> Vec<(usize, bool)> {
    let sets = places.iter().map(|place| {
        let joints = place.iter().filter(|one| is_so(one)).map(|one| one.joint);
        joints.filter(|joint| among.contains(joint)).collect::<BTreeSet<usize>>()
    });
    let sets: Vec<_> = sets.collect();
    let everywhere = |joint: usize| sets.iter().all(|set| set.contains(&joint));
    let at_zero = sets.first().into_iter().flatten();
    at_zero.map(|joint| (*joint, everywhere(*joint))).collect()
}

impl Moved {
    /// Returns a joint that carries an articulated inertia, and that with all joints held.
    fn new(
        at: usize,
        joint: &Joint,
        motions: Vec<Vector6<f64>>,
        Carried { free, held }: &Carried,
    ) -> Self {
        let count = motions.len();
        let along = |inertia: &Matrix6<f64>| {
            let entry = |i: usize, k: usize| motions[i].dot(&(inertia * motions[k]));
            let own = DMatrix::from_diagonal_element(count, count, joint.armature);
            DMatrix::from_fn(count, count, entry) + own
        };
        // For sliding joints, it is the same share of the mass at a reach of 1 m.
        let mass = held.fixed_view::<3, 3>(3, 3).trace() / 3.0;
        let nothing = mass * ROUNDED_GYRATION.powi(2);
        let is_nothing = |value: f64| value.abs() <= nothing;
        let SymmetricEigen { eigenvalues: values, eigenvectors: vectors } =
            along(free).symmetric_eigen();
        let is_bare = along(held).symmetric_eigenvalues().iter().any(|value| is_nothing(*value));
        let inverse = values.map(|value| if is_nothing(value) { 0.0 } else { value.recip() });
        let inverse = &vectors * DMatrix::from_diagonal(&inverse) * vectors.transpose();
        let momenta = motions.iter().map(|motion| free * motion).collect();
        let least = values.iter().position(|value| is_nothing(*value));
        let free = least.map(|least| vectors.column(least).into_owned());
        Moved { joint: at, motions, inverse, momenta, free, is_bare }
    }

    /// Returns the speeds of the joint without momentum along its motions, if the link that carries it
    /// has a velocity.
    fn speeds(&self, of_carrier: &Vector6<f64>) -> DVector<f64> {
        let momenta = self.momenta.iter().map(|momentum| -momentum.dot(of_carrier));
        &self.inverse * DVector::from_iterator(self.momenta.len(), momenta)
    }
}

//! Masses, centres and inertias of simple shapes, and of several of them together.

use std::f64::consts::PI;

use nalgebra::{Isometry3, Matrix3, Quaternion, Translation3, UnitQuaternion, Vector3};

use super::tree::{Inertial, Pose};

/// A shape about its middle, by half sizes \[m\]; those with an axis have it along z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// Radius.
    Sphere(f64),
    /// Half lengths along x, y and z.
    Box([f64; 3]),
    /// Half lengths along x, y and z.
    Ellipsoid([f64; 3]),
    /// Radius and half length.
    Cylinder(f64, f64),
    /// Radius, and half length of its cylinder.
    Capsule(f64, f64),
}

impl Shape {
    /// Reports whether all dimensions are positive.
    pub fn is_solid(self) -> bool {
        match self {
            Self::Sphere(r) => r > 0.0,
            Self::Box(half) | Self::Ellipsoid(half) => half.iter().all(|edge| *edge > 0.0),
            Self::Cylinder(r, h) => r > 0.0 && h > 0.0,
            Self::Capsule(r, h) => r > 0.0 && h >= 0.0,
        }
    }

    /// Returns the volume \[m^3\].
    pub fn volume(self) -> f64 {
        match self {
            Self::Sphere(r) => 4.0 / 3.0 * PI * r.powi(3),
            Self::Box([a, b, c]) => 8.0 * a * b * c,
            Self::Ellipsoid([a, b, c]) => 4.0 / 3.0 * PI * a * b * c,
            Self::Cylinder(r, h) => 2.0 * PI * r * r * h,
            Self::Capsule(r, h) => PI * r * r * (2.0 * h + 4.0 / 3.0 * r),
        }
    }

    /// Returns the principal moments of inertia per mass \[m^2\].
    fn gyration(self) -> [f64; 3] {
        let boxed = |share: f64, [a, b, c]: [f64; 3]| {
            [share * (b * b + c * c), share * (a * a + c * c), share * (a * a + b * b)]
        };
        match self {
            Self::Sphere(r) => [0.4 * r * r; 3],
            Self::Box(half) => boxed(1.0 / 3.0, half),
            Self::Ellipsoid(half) => boxed(0.2, half),
            Self::Cylinder(r, h) => {
                let across = r * r / 4.0 + h * h / 3.0;
                [across, across, r * r / 2.0]
            }
            Self::Capsule(r, h) => {
                // A cylinder and two half balls, whose centres are 3 r/8 beyond its ends.
                let whole = self.volume();
                let middle = Self::Cylinder(r, h).volume() / whole;
                let ends = 1.0 - middle;
                let across = middle * (r * r / 4.0 + h * h / 3.0)
                    + ends * (0.4 * r * r + h * h + 0.75 * h * r);
                [across, across, middle * r * r / 2.0 + ends * 0.4 * r * r]
            }
        }
    }

    /// Returns the inertia about the middle \[kg m^2\].
    pub fn inertia(self, mass: f64) -> Matrix3<f64> {
        Matrix3::from_diagonal(&(Vector3::from(self.gyration()) * mass))
    }
}

/// Returns the shortest rotation of the z axis into a direction.
pub fn turn_of_z(into: &Vector3<f64>) -> UnitQuaternion<f64> {
    turn_into(&Vector3::z(), &into.normalize())
}

/// Returns the shortest rotation of a unit vector into another that is not opposite, except of z. It is
/// accurate for small angles, unlike an arc cosine.
pub fn turn_into(from: &Vector3<f64>, into: &Vector3<f64>) -> UnitQuaternion<f64> {
    let twice = Quaternion::from_parts((from + into).norm_squared() / 2.0, from.cross(into));
    // The rotation into the opposite direction is not unique.
    let half_turn = || UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
    UnitQuaternion::try_new(twice, 0.0).unwrap_or_else(half_turn)
}

/// Returns a pose as a position and a rotation.
pub fn isometry(pose: &Pose) -> Isometry3<f64> {
    let [roll, pitch, yaw] = pose.rpy;
    let turn = UnitQuaternion::from_euler_angles(roll, pitch, yaw);
    Isometry3::from_parts(Translation3::from(Vector3::from(pose.xyz)), turn)
}

/// Returns a position and a rotation as a pose. It is accurate at pitches near a quarter turn too, unlike
/// an arc sine: yaw and pitch are those of the rotation that is left without roll.
pub fn pose(of: &Isometry3<f64>) -> Pose {
    let turn = of.rotation.to_rotation_matrix();
    let (sine, cosine) = (turn[(2, 1)], turn[(2, 2)]);
    // At a quarter turn, roll and yaw are about the same axis.
    let roll = if sine.hypot(cosine) > 4.0 * f64::EPSILON { sine.atan2(cosine) } else { 0.0 };
    let (sine, cosine) = roll.sin_cos();
    let pitch = (-turn[(2, 0)]).atan2(sine * turn[(2, 1)] + cosine * turn[(2, 2)]);
    let without = |row: usize| cosine * turn[(row, 1)] - sine * turn[(row, 2)];
    let yaw = (-without(0)).atan2(without(1));
    Pose { xyz: of.translation.vector.into(), rpy: [roll, pitch, yaw] }
}

/// Returns the inertia of several bodies that are fixed to each other: mass, pose of the centre and
/// axes, and inertia about the centre; `None` without mass.
pub fn together(parts: &[(f64, Isometry3<f64>, Matrix3<f64>)]) -> Option<Inertial> {
    let mass: f64 = parts.iter().map(|(mass, ..)| mass).sum();
    if mass <= 0.0 {
        return None;
    }
    let moment = parts.iter().map(|(mass, at, _)| at.translation.vector * *mass);
    let centre = moment.sum::<Vector3<f64>>() / mass;
    let mut whole = Matrix3::zeros();
    for (mass, at, inertia) in parts {
        let turn = at.rotation.to_rotation_matrix();
        let way = at.translation.vector - centre;
        let of_point = Matrix3::identity() * way.norm_squared() - way * way.transpose();
        whole += turn.matrix() * inertia * turn.matrix().transpose() + of_point * *mass;
    }
    let inertia = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|at| whole[at]);
    Some(Inertial { origin: Pose { xyz: centre.into(), rpy: [0.0; 3] }, mass, inertia })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use nalgebra::{Isometry3, UnitQuaternion, Vector3};

    use super::{isometry, pose, turn_into};

    #[test]
    fn rotations_are_kept_by_their_angles() {
        let offsets = [0.0, 1e-15, -3e-12, 2e-9, 1e-7, -4e-6, 1e-3];
        for pitch in [FRAC_PI_2, -FRAC_PI_2, 0.0, PI] {
            for (off, roll) in offsets.iter().flat_map(|off| offsets.map(|roll| (off, roll))) {
                for yaw in [0.0, 0.7, FRAC_PI_2, -2.0] {
                    let turn = UnitQuaternion::from_euler_angles(0.4 + roll, pitch + off, yaw);
                    let back =
                        isometry(&pose(&Isometry3::from_parts(Vector3::zeros().into(), turn)));
                    let error = (back.rotation.inverse() * turn).imag().norm();
                    assert!(error < 1e-15, "{pitch} {off} {roll} {yaw}: {error}");
                }
            }
        }
    }

    #[test]
    fn turns_are_accurate_and_those_of_z_up_to_half_turns() {
        let oblique = Vector3::new(0.3, -0.8, 0.1).normalize();
        for (from, largest) in [(oblique, 3.0), (Vector3::z(), PI)] {
            let across = from.cross(&Vector3::x()).normalize();
            for angle in [0.0_f64, 1e-13, 1e-9, 1e-4, 1.0, 3.0, PI - 1e-4, PI - 1e-9, PI] {
                let into = from * angle.cos() + across * angle.sin();
                let error = (turn_into(&from, &into) * from - into).norm();
                assert!(error < 2e-15 || angle > largest, "{angle}: {error}");
            }
        }
    }
}

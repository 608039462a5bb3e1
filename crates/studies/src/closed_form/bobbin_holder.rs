//! The four-link bobbin holder at rest in operation: N and Q from balances of moments.
//!
//! With D the pin of plate and strut, K the contact of bobbin and drum, T that of post
//! and stop, R the force of the strut on the plate, n along the centres from drum to
//! bobbin and t across,
//!
//! ```text
//! strut about E:               R_across = -g sum m x/L      R_along = push, less weight
//! plate and bobbin about C:    CD x R + weights + N CK x n + P CK x t = 0
//! post as well about O:        OD x R + weights + N OK x n + P OK x t + Q OT = 0
//! ```
//!
//! Source: study of a winding mechanism; dimensions are those of `winder_linkage`.

use std::f64::consts::FRAC_PI_2;

use super::roots::turning_point;

/// Dimensions and masses, as in the scene's spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BobbinHolder {
    /// Length of the post OC \[m\].
    pub post: f64,
    /// Length CD on the plate \[m\].
    pub plate: f64,
    /// A on the plate, from C towards D and to the right \[m\].
    pub axle: [f64; 2],
    /// B \[m\].
    pub drum: [f64; 2],
    /// E \[m\].
    pub foot: [f64; 2],
    /// T \[m\].
    pub stop: [f64; 2],
    /// Radii of package and drum \[m\].
    pub radii: [f64; 2],
    /// Length of cylinder and of rod, their centres of mass in the middle \[m\].
    pub strut: f64,
    /// Masses of post, plate, cylinder, rod, bobbin \[kg\].
    pub masses: [f64; 5],
    /// Stiffness \[N/m\] and free length \[m\] of the strut's spring.
    pub spring: [f64; 2],
    /// P, winding force at K \[N\].
    pub winding_force: f64,
}

/// The holder of the scene `winder_linkage`.
pub const HOLDER: BobbinHolder = BobbinHolder {
    post: 0.2,
    plate: 0.12,
    axle: [0.05, 0.10],
    drum: [0.328, 0.058],
    foot: [0.0, 0.28],
    stop: [0.143, 0.044],
    radii: [0.06, 0.04],
    strut: 0.12,
    masses: [0.8, 1.2, 0.3, 0.2, 0.7],
    spring: [2000.0, 0.116],
    winding_force: 0.0,
};

const GRAVITY: f64 = 9.81;
/// Upper bound of the angle at which the bobbin reaches the drum \[rad\].
const LARGEST_LIFT: f64 = 0.3;

impl BobbinHolder {
    /// Returns N and Q \[N\]; NaN if the package does not reach the drum.
    #[must_use]
    pub fn forces(&self) -> [f64; 2] {
        self.balances().forces(Drag { force: self.winding_force, ..Drag::default() })
    }

    /// Returns N and Q \[N\] where the drum drags the bobbin by a share of its pressure, P = share
    /// N: the friction f of a turning drum, or k/R of a bobbin that rolls at rest; positive to the
    /// left over the drum. Equations (11) to (14) of the study, whose force acts at K as on a bobbin
    /// that is held.
    #[must_use]
    pub fn forces_by_share(&self, share: f64) -> [f64; 2] {
        self.balances().forces(Drag { share, ..Drag::default() })
    }

    /// Returns N and Q \[N\] where the drum drags a bobbin that turns freely on its axle by force +
    /// share N, positive to the left over the drum. The force turns the bobbin and acts on the holder
    /// at A, unlike in equations (9) to (14), where it acts at K as on a bobbin that is held.
    /// Friction of the axle turns the plate by `-axle` N.
    #[must_use]
    pub fn forces_beside_turning_bobbin(&self, force: f64, share: f64, axle: f64) -> [f64; 2] {
        self.balances().forces(Drag { force, share, arm: self.radii[0], couple: -axle })
    }

    /// Returns the angle \[rad\] of [`unstable_lift`](Self::unstable_lift) where the drum drags a
    /// bobbin that turns freely.
    #[must_use]
    pub fn unstable_lift_beside_turning_bobbin(&self, force: f64, share: f64, axle: f64) -> f64 {
        turning_point(0.0, LARGEST_LIFT, |lift| {
            self.lifted(lift).forces_beside_turning_bobbin(force, share, axle)[1] > 0.0
        })
    }

    /// Returns the angle \[rad\] between the post and its stop in the unstable working position,
    /// with the bobbin on a drum that drags it by a share of its pressure. Below this angle the
    /// post falls onto its stop, above it lifts away. The post would rest there on a stop without
    /// pressing it.
    #[must_use]
    pub fn unstable_lift(&self, share: f64) -> f64 {
        turning_point(0.0, LARGEST_LIFT, |lift| self.lifted(lift).forces_by_share(share)[1] > 0.0)
    }

    /// Returns the holder with its stop moved up by this distance.
    #[must_use]
    pub fn lifted(&self, lift: f64) -> Self {
        let (sin, cos) = lift.sin_cos();
        let [x, y] = self.stop;
        Self { stop: [x * cos - y * sin, x * sin + y * cos], ..*self }
    }

    fn balances(&self) -> Balances {
        let [post_mass, plate_mass, cylinder_mass, rod_mass, bobbin_mass] = self.masses;
        let distance_t = self.stop[0].hypot(self.stop[1]);
        let along_post = [self.stop[0] / distance_t, self.stop[1] / distance_t];
        let c = along_post.map(|part| self.post * part);
        let a = self.axle_place(c);
        let (sin, cos) = self.working_angles()[1].sin_cos();
        let d = [c[0] + self.plate * cos, c[1] + self.plate * sin];
        let of_strut = self.strut_on_plate(d, cylinder_mass, rod_mass);
        let reach = self.radii[0] + self.radii[1];
        let n = [(a[0] - self.drum[0]) / reach, (a[1] - self.drum[1]) / reach];
        let t = [-n[1], n[0]];
        let k = [a[0] - self.radii[0] * n[0], a[1] - self.radii[0] * n[1]];
        let plate_x = 0.5 * (c[0] + d[0]);
        let weights = |x: f64| -GRAVITY * (plate_mass * (plate_x - x) + bobbin_mass * (a[0] - x));
        let o = [0.0, 0.0];
        let without = |point, x| moment(point, d, of_strut) + weights(x);
        Balances {
            about_c: [without(c, c[0]), moment(c, k, n), moment(c, k, t)],
            about_o: [
                without(o, 0.0) - GRAVITY * post_mass * 0.5 * c[0],
                moment(o, k, n),
                moment(o, k, t),
            ],
            stop_arm: distance_t,
        }
    }

    /// Returns the angles of post and plate \[rad\] where the post is on its stop and the package
    /// on the drum, without deflection.
    #[must_use]
    pub fn working_angles(&self) -> [f64; 2] {
        let post = self.stop[1].atan2(self.stop[0]);
        let c = [self.post * post.cos(), self.post * post.sin()];
        let a = self.axle_place(c);
        [post, (a[1] - c[1]).atan2(a[0] - c[0]) - (-self.axle[1]).atan2(self.axle[0])]
    }

    /// Centres of mass \[m\] of post, plate, cylinder, rod and bobbin where post and plate are at
    /// these angles \[rad\].
    #[must_use]
    pub fn centres(&self, [post, plate]: [f64; 2]) -> [[f64; 2]; 5] {
        let along = |from: [f64; 2], length: f64, angle: f64| {
            [from[0] + length * angle.cos(), from[1] + length * angle.sin()]
        };
        let c = along([0.0, 0.0], self.post, post);
        let d = along(c, self.plate, plate);
        let strut = (self.foot[1] - d[1]).atan2(self.foot[0] - d[0]);
        let [forwards, to_the_right] = self.axle;
        [
            along([0.0, 0.0], 0.5 * self.post, post),
            along(c, 0.5 * self.plate, plate),
            along(d, 0.5 * self.strut, strut),
            along(self.foot, -0.5 * self.strut, strut),
            along(along(c, forwards, plate), -to_the_right, plate + FRAC_PI_2),
        ]
    }

    /// Returns A, the intersection of the circles about C and B to the left of the direction from C
    /// to B.
    fn axle_place(&self, c: [f64; 2]) -> [f64; 2] {
        let to_c = self.axle[0].hypot(self.axle[1]);
        let to_b = self.radii[0] + self.radii[1];
        let (x, y) = (self.drum[0] - c[0], self.drum[1] - c[1]);
        let between = x.hypot(y);
        let along = (to_c * to_c - to_b * to_b + between * between) / (2.0 * between);
        let across = (to_c * to_c - along * along).sqrt();
        let (x, y) = (x / between, y / between);
        [c[0] + along * x - across * y, c[1] + along * y + across * x]
    }

    /// Returns the force of the strut on the plate at D.
    fn strut_on_plate(&self, d: [f64; 2], cylinder_mass: f64, rod_mass: f64) -> [f64; 2] {
        let (x, y) = (self.foot[0] - d[0], self.foot[1] - d[1]);
        let length = x.hypot(y);
        let (x, y) = (x / length, y / length);
        let [stiffness, free] = self.spring;
        let push = stiffness * (free - (length - self.strut));
        let half = 0.5 * self.strut;
        // Force of D on the strut: along it, from D to E, and across, to the left of that.
        let along = push + GRAVITY * cylinder_mass * y;
        let weights = cylinder_mass * (length - half) + rod_mass * half;
        let across = GRAVITY * weights * x / length;
        [-(along * x - across * y), -(along * y + across * x)]
    }
}

/// Moments of strut and weights, of N = 1 N and of P = 1 N, about C and about O, and the arm of Q.
struct Balances {
    about_c: [f64; 3],
    about_o: [f64; 3],
    stop_arm: f64,
}

/// Tangential force P = force + share N of the drum on the bobbin.
#[derive(Debug, Clone, Copy, Default)]
struct Drag {
    force: f64,
    share: f64,
    /// Distance of its line of action from K towards A \[m\].
    arm: f64,
    /// Moment on the plate over N \[m\].
    couple: f64,
}

impl Balances {
    /// Returns N and Q.
    fn forces(&self, Drag { force, share, arm, couple }: Drag) -> [f64; 2] {
        // n x t = 1.
        let [others, of_normal, of_winding] = self.about_c;
        let of_winding = of_winding + arm;
        let normal = -(others + force * of_winding) / (of_normal + share * of_winding + couple);
        let [others, of_normal, of_winding] = self.about_o;
        let moment = (force + share * normal) * (of_winding + arm);
        [normal, -(others + moment + normal * (of_normal + couple)) / self.stop_arm]
    }
}

/// Returns the moment about a point of a force at another.
fn moment(about: [f64; 2], at: [f64; 2], force: [f64; 2]) -> f64 {
    (at[0] - about[0]) * force[1] - (at[1] - about[1]) * force[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_holder_works_steadily_with_the_winding_force_either_way() {
        for winding_force in [-8.0, 0.0, 8.0] {
            let [normal, stop] = BobbinHolder { winding_force, ..HOLDER }.forces();
            assert!(normal > 0.0 && stop > 0.0, "{winding_force}: {normal} {stop}");
        }
    }

    #[test]
    fn the_law_of_the_winding_force_is_that_force() {
        for share in [-0.18, -0.02, 0.0, 0.02, 0.18] {
            let [normal, stop] = HOLDER.forces_by_share(share);
            let given = BobbinHolder { winding_force: share * normal, ..HOLDER }.forces();
            assert!((given[0] - normal).abs() < 1e-12 && (given[1] - stop).abs() < 1e-12);
        }
    }

    #[test]
    fn a_stiffer_spring_presses_bobbin_and_post_harder() {
        let stiff = BobbinHolder { spring: [2500.0, 0.116], ..HOLDER }.forces();
        let soft = HOLDER.forces();
        assert!(stiff[0] > soft[0] && stiff[1] > soft[1]);
    }
}

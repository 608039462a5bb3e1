//! Small oscillations of the four-link bobbin holder on its contacts, in the angles of post
//! and plate.
//!
//! A point of the plate is P = C(a) + p(b), C on the post and p turning with the plate, so that
//!
//! ```text
//! P_a = C rotated      P_aa = -C      P_b = p rotated      P_bb = -p      P_ab = 0
//! r = |P - Q|:   r_i = n P_i,   r_ij = n P_ij + (P_i P_j - r_i r_j)/r
//! e_y = (E_y - D_y)/s:   its slopes by those of s = |D - E|
//! M_ij = sum m G_i G_j + J th_i th_j     D_ij = sum d x_i x_j
//! V = sum m g y + sum k x^2/2:   V_ij = sum m g y_ij + k (x_i x_j + x x_ij)
//! ```
//!
//! with x the way of the strut's spring, the gap at the drum and that at the stop. At rest
//! V_i = 0, the balance of virtual works; about it M q'' + D q' + V_ij q = 0.
//!
//! Source: by hand.

use nalgebra::{Complex, Matrix2, Matrix4, Vector2};

use super::bobbin_holder::{BobbinHolder, HOLDER};

const GRAVITY: f64 = 9.81;

/// The holder with the additional data of its motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwingingHolder {
    /// Dimensions, masses and spring.
    pub holder: BobbinHolder,
    /// Moments of inertia of post, plate, cylinder, rod about their centres of mass
    /// \[kg m^2\].
    pub inertias: [f64; 4],
    /// Damping of the strut \[N s/m\].
    pub damping: f64,
    /// Stiffness of contact and stop, each \[N/m\].
    pub contact_stiffness: f64,
    /// Damping of contact and stop, each \[N s/m\].
    pub contact_damping: f64,
}

/// The machine of the scene `winder_holder_drop`, at rest.
pub const SWINGING_HOLDER: SwingingHolder = SwingingHolder {
    holder: HOLDER,
    inertias: [2.7e-3, 2.5e-3, 3.6e-4, 2.4e-4],
    damping: 400.0,
    contact_stiffness: 1e6,
    contact_damping: 1500.0,
};

/// A quantity with its first and second derivatives by both angles.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bent {
    pub value: f64,
    pub slopes: Vector2<f64>,
    bend: Matrix2<f64>,
}

/// A point with its derivatives by both angles, and second derivatives by each angle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub at: Vector2<f64>,
    pub slopes: [Vector2<f64>; 2],
    bends: [Vector2<f64>; 2],
}

/// Quantities that contacts do not change, at two angles.
pub(super) struct Ways {
    /// M.
    pub mass: Matrix2<f64>,
    /// Potential of the weights \[J\].
    pub weights: Bent,
    /// Elongation of the strut's spring \[m\].
    pub slide: Bent,
    /// Gap between bobbin and drum \[m\].
    pub gap: Bent,
    /// Gap between post and stop \[m\].
    pub stop_gap: Bent,
    /// Centre of the bobbin \[m\].
    pub bobbin: Place,
}

/// All quantities at two angles.
struct Position {
    mass: Matrix2<f64>,
    damping: Matrix2<f64>,
    potential: Bent,
}

impl SwingingHolder {
    /// Returns the angles of post and plate \[rad\] at rest on both contacts.
    #[must_use]
    pub fn rest(&self) -> [f64; 2] {
        let mut angles = self.holder.working_angles();
        for _ in 0..50 {
            let Bent { slopes, bend, .. } = self.position(angles).potential;
            let step = bend.lu().solve(&slopes).unwrap_or_else(|| Vector2::repeat(f64::NAN));
            angles = [angles[0] - step[0], angles[1] - step[1]];
        }
        angles
    }

    /// Returns both eigenvalues \[1/s\] with nonnegative imaginary part of small oscillations about
    /// rest, in ascending order of size.
    #[must_use]
    pub fn eigenvalues(&self) -> Vec<Complex<f64>> {
        let Position { mass, damping, potential } = self.position(self.rest());
        let inverse = mass.try_inverse().unwrap_or_else(|| Matrix2::repeat(f64::NAN));
        let mut matrix = Matrix4::zeros();
        matrix.fixed_view_mut::<2, 2>(0, 2).fill_with_identity();
        matrix.fixed_view_mut::<2, 2>(2, 0).copy_from(&-(inverse * potential.bend));
        matrix.fixed_view_mut::<2, 2>(2, 2).copy_from(&-(inverse * damping));
        let mut values: Vec<Complex<f64>> =
            matrix.complex_eigenvalues().iter().copied().filter(|value| value.im >= 0.0).collect();
        values.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
        values
    }

    fn position(&self, angles: [f64; 2]) -> Position {
        let Ways { slide, gap, stop_gap, weights: mut potential, mass, .. } = self.ways(angles);
        let contact = (self.contact_stiffness, self.contact_damping);
        let strut = (self.holder.spring[0], self.damping);
        let springs = [(strut, slide), (contact, gap), (contact, stop_gap)];
        let mut damping = Matrix2::zeros();
        for ((stiffness, damper), way) in springs {
            potential.add_spring(stiffness, &way);
            damping += damper * way.slopes * way.slopes.transpose();
        }
        Position { mass, damping, potential }
    }

    /// Returns M and all displacements where post and plate are at these angles \[rad\].
    pub(super) fn ways(&self, [post, plate]: [f64; 2]) -> Ways {
        let BobbinHolder { masses, axle, drum, foot, stop, radii, strut, spring, .. } = self.holder;
        let [post_mass, plate_mass, cylinder_mass, rod_mass, bobbin_mass] = masses;
        let on_plate = |along: f64, across: f64| self.place([post, plate], [along, across]);
        let (pin, middle) =
            (on_plate(self.holder.plate, 0.0), on_plate(0.5 * self.holder.plate, 0.0));
        let bobbin = on_plate(axle[0], axle[1]);
        let (sin, cos) = post.sin_cos();
        let half_post = 0.5 * self.holder.post;

        let length = distance(&pin, foot);
        let height = direction(&pin, foot, &length);
        let half = 0.5 * strut;
        let slide = Bent { value: length.value - strut - spring[1], ..length };
        let gap = distance(&bobbin, drum);
        let gap = Bent { value: gap.value - radii[0] - radii[1], ..gap };
        let open = stop[0] * sin - stop[1] * cos;
        let stop_gap = Bent {
            value: open,
            slopes: Vector2::new(stop[0] * cos + stop[1] * sin, 0.0),
            bend: Matrix2::new(-open, 0.0, 0.0, 0.0),
        };

        let mut weights = Bent { value: 0.0, slopes: Vector2::zeros(), bend: Matrix2::zeros() };
        for (weight, raised) in [
            (
                post_mass,
                Bent {
                    value: half_post * sin,
                    slopes: Vector2::new(half_post * cos, 0.0),
                    bend: Matrix2::new(-half_post * sin, 0.0, 0.0, 0.0),
                },
            ),
            (plate_mass, middle.height()),
            (bobbin_mass, bobbin.height()),
            (cylinder_mass, pin.height()),
            (half * (cylinder_mass - rod_mass), height),
        ] {
            weights.add(GRAVITY * weight, &raised);
        }
        let mass = self.mass(&pin, &middle, &bobbin, foot);
        Ways { mass, weights, slide, gap, stop_gap, bobbin }
    }

    /// Returns a point of the plate, given along the direction from C to D and to the right of it.
    fn place(&self, [post, plate]: [f64; 2], [along, across]: [f64; 2]) -> Place {
        let c = self.holder.post * Vector2::new(post.cos(), post.sin());
        let (sin, cos) = plate.sin_cos();
        let p = Vector2::new(along * cos + across * sin, along * sin - across * cos);
        Place { at: c + p, slopes: [turned(c), turned(p)], bends: [-c, -p] }
    }

    fn mass(&self, pin: &Place, middle: &Place, bobbin: &Place, foot: [f64; 2]) -> Matrix2<f64> {
        let [post_mass, plate_mass, cylinder_mass, rod_mass, bobbin_mass] = self.holder.masses;
        let [post, plate, cylinder, rod] = self.inertias;
        let way = Vector2::from(foot) - pin.at;
        let across = turned(way.normalize());
        // Rotation of the strut and motion of its halves, by each angle.
        let turns = pin.slopes.map(|slope| -across.dot(&slope) / way.norm());
        let half = 0.5 * self.holder.strut;
        let of_rod = turns.map(|turn| -half * turn * across);
        let of_cylinder = [0, 1].map(|i| pin.slopes[i] + half * turns[i] * across);
        let moving = [
            (plate_mass, middle.slopes),
            (bobbin_mass, bobbin.slopes),
            (cylinder_mass, of_cylinder),
            (rod_mass, of_rod),
        ];
        let post = post + post_mass * (0.5 * self.holder.post).powi(2);
        Matrix2::from_fn(|i, j| {
            let own = [[post, 0.0], [0.0, plate]][i][j];
            let strut = (cylinder + rod) * turns[i] * turns[j];
            let moved: f64 =
                moving.iter().map(|(mass, slopes)| mass * slopes[i].dot(&slopes[j])).sum();
            own + strut + moved
        })
    }
}

impl Place {
    fn height(&self) -> Bent {
        Bent {
            value: self.at.y,
            slopes: Vector2::new(self.slopes[0].y, self.slopes[1].y),
            bend: Matrix2::new(self.bends[0].y, 0.0, 0.0, self.bends[1].y),
        }
    }
}

impl Bent {
    fn add(&mut self, factor: f64, other: &Self) {
        self.value += factor * other.value;
        self.slopes += factor * other.slopes;
        self.bend += factor * other.bend;
    }

    /// Adds half the stiffness times the square of a displacement.
    fn add_spring(&mut self, stiffness: f64, way: &Self) {
        let Self { value, slopes, bend } = *way;
        self.value += 0.5 * stiffness * value * value;
        self.slopes += stiffness * value * slopes;
        self.bend += stiffness * (slopes * slopes.transpose() + value * bend);
    }
}

/// r.
fn distance(place: &Place, to: [f64; 2]) -> Bent {
    let way = place.at - Vector2::from(to);
    let (value, n) = (way.norm(), way.normalize());
    let slopes = Vector2::new(n.dot(&place.slopes[0]), n.dot(&place.slopes[1]));
    let bend = Matrix2::from_fn(|i, j| {
        let own = if i == j { n.dot(&place.bends[i]) } else { 0.0 };
        own + (place.slopes[i].dot(&place.slopes[j]) - slopes[i] * slopes[j]) / value
    });
    Bent { value, slopes, bend }
}

/// e_y, from the place to a point whose distance is given.
fn direction(place: &Place, to: [f64; 2], distance: &Bent) -> Bent {
    let (s, height) = (distance.value, place.height());
    let value = (to[1] - place.at.y) / s;
    let slopes = (-height.slopes - value * distance.slopes) / s;
    let crossed = slopes * distance.slopes.transpose();
    let bend = (-height.bend - crossed - crossed.transpose() - value * distance.bend) / s;
    Bent { value, slopes, bend }
}

fn turned(vector: Vector2<f64>) -> Vector2<f64> {
    Vector2::new(-vector.y, vector.x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_are_differences_of_the_potential() {
        let angles = SWINGING_HOLDER.holder.working_angles().map(|angle| angle + 0.02);
        let of = |shift: [f64; 2]| {
            SWINGING_HOLDER.position([angles[0] + shift[0], angles[1] + shift[1]]).potential
        };
        let (here, h) = (of([0.0, 0.0]), 1e-6);
        for i in 0..2 {
            let mut shift = [0.0, 0.0];
            shift[i] = h;
            let (ahead, behind) = (of(shift), of(shift.map(|part| -part)));
            let slope = (ahead.value - behind.value) / (2.0 * h);
            assert!((slope / here.slopes[i] - 1.0).abs() < 1e-6, "{slope}");
            let bend = (ahead.slopes - behind.slopes) / (2.0 * h);
            assert!((bend - here.bend.column(i)).norm() < 1e-5 * here.bend.norm(), "{bend}");
        }
    }

    #[test]
    fn it_rests_by_the_balances_of_moments() {
        // Much stiffer contacts deflect by less than a thousandth of a millimetre.
        let hard = SwingingHolder { contact_stiffness: 1e9, ..SWINGING_HOLDER };
        let [post, plate] = hard.rest();
        let bobbin = hard.place([post, plate], HOLDER.axle);
        let gap = (bobbin.at - Vector2::from(HOLDER.drum)).norm() - 0.1;
        let stop = HOLDER.stop[0] * post.sin() - HOLDER.stop[1] * post.cos();
        for (found, exact) in [gap, stop].iter().zip(HOLDER.forces()) {
            assert!((-1e9 * found / exact - 1.0).abs() < 1e-5, "{found} {exact}");
        }
    }
}

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   15aae97806f290d2a0c9e068e0de20b91e65e5561e986616897e05eee65d1c2e  scenes/winder_linkage.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//
// Four-link bobbin holder, at work
//
// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at
// A, and a strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The
// bobbin rests on the drum at K, the post on a stop at T. All six bodies are free in the
// plane and held by fourteen constraints of pins and slide and by the two of the contacts,
// whose forces are N and Q; the holder works steadily while both are above zero.
//
// The study gives no dimensions; these are plausible ones.
//
// Source:
//   Study of a winding mechanism; dimensions are ours.
//
// Shapes; all quantities are in SI units:
//   coordinates              18
//   first-order states        0
//   states                   36
//   parameters                5
//   outputs                   7
//   discontinuities           0
//   constraints              16
//
// State:
//     0  post.x          [m]      centre of mass, sideways
//     1  post.y          [m]      centre of mass, upwards
//     2  post.phi        [rad]    angle of the bar from sideways
//     3  plate.x         [m]      centre of mass, sideways
//     4  plate.y         [m]      centre of mass, upwards
//     5  plate.phi       [rad]    angle of the bar from sideways
//     6  cylinder.x      [m]      centre of mass, sideways
//     7  cylinder.y      [m]      centre of mass, upwards
//     8  cylinder.phi    [rad]    angle of the bar from sideways
//     9  rod.x           [m]      centre of mass, sideways
//    10  rod.y           [m]      centre of mass, upwards
//    11  rod.phi         [rad]    angle of the bar from sideways
//    12  bobbin.x        [m]      centre of mass, sideways
//    13  bobbin.y        [m]      centre of mass, upwards
//    14  bobbin.phi      [rad]    angle of the bar from sideways
//    15  drum.x          [m]      centre of mass, sideways
//    16  drum.y          [m]      centre of mass, upwards
//    17  drum.phi        [rad]    angle of the bar from sideways
//    18  post.v_x        [m/s]    rate of centre of mass, sideways
//    19  post.v_y        [m/s]    rate of centre of mass, upwards
//    20  post.omega      [rad/s]  rate of angle of the bar from sideways
//    21  plate.v_x       [m/s]    rate of centre of mass, sideways
//    22  plate.v_y       [m/s]    rate of centre of mass, upwards
//    23  plate.omega     [rad/s]  rate of angle of the bar from sideways
//    24  cylinder.v_x    [m/s]    rate of centre of mass, sideways
//    25  cylinder.v_y    [m/s]    rate of centre of mass, upwards
//    26  cylinder.omega  [rad/s]  rate of angle of the bar from sideways
//    27  rod.v_x         [m/s]    rate of centre of mass, sideways
//    28  rod.v_y         [m/s]    rate of centre of mass, upwards
//    29  rod.omega       [rad/s]  rate of angle of the bar from sideways
//    30  bobbin.v_x      [m/s]    rate of centre of mass, sideways
//    31  bobbin.v_y      [m/s]    rate of centre of mass, upwards
//    32  bobbin.omega    [rad/s]  rate of angle of the bar from sideways
//    33  drum.v_x        [m/s]    rate of centre of mass, sideways
//    34  drum.v_y        [m/s]    rate of centre of mass, upwards
//    35  drum.omega      [rad/s]  rate of angle of the bar from sideways
//
// Nonzeros:
//   mass_matrix              18 of 18 by 18
//   rate_jacobian           228 of 36 by 36
//   parameter_jacobian        0 of 36 by 5
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    462
//   mass_matrix               0
//   forcing                  51
//   rate_jacobian           390
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                 241
//   energy                   72
//   power_balance           110
//   constraint_values        62
//   constraint_rates         89
//   constraint_matrix        48
// Before those that read it:
//   motion                  473
// With constants of the parameters, prepared once a run:
//   prepare                   1
//   prepared_rate           461
//   prepared_rate_jacobian  390
//   motion                  472

use ::machinist_contract::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, implicit::{Step, substitute},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 18;

/// Length of the state y.
pub const STATES: usize = 36;

/// Parameters.
pub const PARAMETERS: usize = 5;

/// Wanted outputs.
pub const OUTPUTS: usize = 7;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 18,
    columns: 18,
    entries: &[
        (0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8), (9, 9), (10, 10),
        (11, 11), (12, 12), (13, 13), (14, 14), (15, 15), (16, 16), (17, 17),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 36,
    columns: 36,
    entries: &[
        (0, 18), (1, 19), (2, 20), (3, 21), (4, 22), (5, 23), (6, 24), (7, 25), (8, 26), (9, 27),
        (10, 28), (11, 29), (12, 30), (13, 31), (14, 32), (15, 33), (16, 34), (17, 35), (18, 2),
        (18, 20), (19, 2), (19, 20), (20, 2), (20, 20), (21, 2), (21, 5), (21, 12), (21, 13),
        (21, 15), (21, 16), (21, 20), (21, 23), (21, 30), (21, 31), (21, 33), (21, 34), (22, 2),
        (22, 5), (22, 12), (22, 13), (22, 15), (22, 16), (22, 20), (22, 23), (22, 30), (22, 31),
        (22, 33), (22, 34), (23, 2), (23, 5), (23, 12), (23, 13), (23, 15), (23, 16), (23, 20),
        (23, 23), (23, 30), (23, 31), (23, 33), (23, 34), (24, 2), (24, 5), (24, 6), (24, 7),
        (24, 8), (24, 9), (24, 10), (24, 11), (24, 12), (24, 13), (24, 15), (24, 16), (24, 20),
        (24, 23), (24, 24), (24, 25), (24, 26), (24, 27), (24, 28), (24, 29), (24, 30), (24, 31),
        (24, 33), (24, 34), (25, 2), (25, 5), (25, 6), (25, 7), (25, 8), (25, 9), (25, 10),
        (25, 11), (25, 12), (25, 13), (25, 15), (25, 16), (25, 20), (25, 23), (25, 24), (25, 25),
        (25, 26), (25, 27), (25, 28), (25, 29), (25, 30), (25, 31), (25, 33), (25, 34), (26, 2),
        (26, 5), (26, 6), (26, 7), (26, 8), (26, 9), (26, 10), (26, 11), (26, 12), (26, 13),
        (26, 15), (26, 16), (26, 20), (26, 23), (26, 24), (26, 25), (26, 26), (26, 27), (26, 28),
        (26, 29), (26, 30), (26, 31), (26, 33), (26, 34), (27, 2), (27, 5), (27, 6), (27, 7),
        (27, 8), (27, 9), (27, 10), (27, 11), (27, 12), (27, 13), (27, 15), (27, 16), (27, 20),
        (27, 23), (27, 24), (27, 25), (27, 26), (27, 27), (27, 28), (27, 29), (27, 30), (27, 31),
        (27, 33), (27, 34), (28, 2), (28, 5), (28, 6), (28, 7), (28, 8), (28, 9), (28, 10),
        (28, 11), (28, 12), (28, 13), (28, 15), (28, 16), (28, 20), (28, 23), (28, 24), (28, 25),
        (28, 26), (28, 27), (28, 28), (28, 29), (28, 30), (28, 31), (28, 33), (28, 34), (29, 2),
        (29, 5), (29, 6), (29, 7), (29, 8), (29, 9), (29, 10), (29, 11), (29, 12), (29, 13),
        (29, 15), (29, 16), (29, 20), (29, 23), (29, 24), (29, 25), (29, 26), (29, 27), (29, 28),
        (29, 29), (29, 30), (29, 31), (29, 33), (29, 34), (30, 2), (30, 5), (30, 12), (30, 13),
        (30, 15), (30, 16), (30, 20), (30, 23), (30, 30), (30, 31), (30, 33), (30, 34), (31, 2),
        (31, 5), (31, 12), (31, 13), (31, 15), (31, 16), (31, 20), (31, 23), (31, 30), (31, 31),
        (31, 33), (31, 34),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 36,
    columns: 5,
    entries: &[],
};

/// Constraints.
pub const CONSTRAINTS: usize = 16;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 18,
    entries: &[
        (0, 0), (0, 2), (1, 1), (1, 2), (2, 0), (2, 2), (2, 3), (2, 5), (3, 1), (3, 2), (3, 4),
        (3, 5), (4, 3), (4, 5), (4, 6), (4, 8), (5, 4), (5, 5), (5, 7), (5, 8), (6, 8), (6, 11),
        (7, 6), (7, 7), (7, 8), (7, 9), (7, 10), (8, 9), (8, 11), (9, 10), (9, 11), (10, 3),
        (10, 5), (10, 12), (11, 4), (11, 5), (11, 13), (12, 15), (13, 16), (14, 12), (14, 13),
        (14, 15), (14, 16), (15, 2),
    ],
};

/// Four-link bobbin holder, at work
///
/// The holder of a self-twist spinning machine: post OC, plate ACD that carries the bobbin at
/// A, and a strut D-S-E, a spring and an oil damper in a cylinder that slides on a rod. The
/// bobbin rests on the drum at K, the post on a stop at T. All six bodies are free in the
/// plane and held by fourteen constraints of pins and slide and by the two of the contacts,
/// whose forces are N and Q; the holder works steadily while both are above zero.
///
/// The study gives no dimensions; these are plausible ones.
///
/// Source: Study of a winding mechanism; dimensions are ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WinderLinkage;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// bobbin_radius: radius of the package on the bobbin \[m\]. In the spec: 0.06.
    pub bobbin_radius: R,
    /// winding_force: force of the drum on the bobbin along its surface, to the left over the drum \[N\]. In the spec: 0.0.
    pub winding_force: R,
    /// bobbin.mass: the mass \[kg\]. In the spec: 0.7.
    pub bobbin_mass: R,
    /// spring.stiffness: spring \[N/m\]. In the spec: 2000.0.
    pub spring_stiffness: R,
    /// spring.free_length: distance at which the spring is at rest \[m\]. In the spec: 0.116.
    pub spring_free_length: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            bobbin_radius: values[0],
            winding_force: values[1],
            bobbin_mass: values[2],
            spring_stiffness: values[3],
            spring_free_length: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.bobbin_radius,
            self.winding_force,
            self.bobbin_mass,
            self.spring_stiffness,
            self.spring_free_length,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            bobbin_radius: R::literal(0.06),
            winding_force: R::literal(0.0),
            bobbin_mass: R::literal(0.7),
            spring_stiffness: R::literal(2000.0),
            spring_free_length: R::literal(0.116),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// contact_force: N, force of the drum on the bobbin at K \[N\].
    pub contact_force: R,
    /// stop_force: Q, force of the stop on the post at T \[N\].
    pub stop_force: R,
    /// strut_push: force with which it pushes its ends apart \[N\].
    pub strut_push: R,
    /// post_angle: angle of the bar from sideways \[rad\].
    pub post_angle: R,
    /// plate_angle: angle of the bar from sideways \[rad\].
    pub plate_angle: R,
    /// bobbin_angle: angle of the bar from sideways \[rad\].
    pub bobbin_angle: R,
    /// drum_angle: angle of the bar from sideways \[rad\].
    pub drum_angle: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            contact_force: values[0],
            stop_force: values[1],
            strut_push: values[2],
            post_angle: values[3],
            plate_angle: values[4],
            bobbin_angle: values[5],
            drum_angle: values[6],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.contact_force,
            self.stop_force,
            self.strut_push,
            self.post_angle,
            self.plate_angle,
            self.bobbin_angle,
            self.drum_angle,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// post.x: centre of mass, sideways \[m\].
    pub const POST_X: usize = 0;
    /// post.y: centre of mass, upwards \[m\].
    pub const POST_Y: usize = 1;
    /// post.phi: angle of the bar from sideways \[rad\].
    pub const POST_PHI: usize = 2;
    /// plate.x: centre of mass, sideways \[m\].
    pub const PLATE_X: usize = 3;
    /// plate.y: centre of mass, upwards \[m\].
    pub const PLATE_Y: usize = 4;
    /// plate.phi: angle of the bar from sideways \[rad\].
    pub const PLATE_PHI: usize = 5;
    /// cylinder.x: centre of mass, sideways \[m\].
    pub const CYLINDER_X: usize = 6;
    /// cylinder.y: centre of mass, upwards \[m\].
    pub const CYLINDER_Y: usize = 7;
    /// cylinder.phi: angle of the bar from sideways \[rad\].
    pub const CYLINDER_PHI: usize = 8;
    /// rod.x: centre of mass, sideways \[m\].
    pub const ROD_X: usize = 9;
    /// rod.y: centre of mass, upwards \[m\].
    pub const ROD_Y: usize = 10;
    /// rod.phi: angle of the bar from sideways \[rad\].
    pub const ROD_PHI: usize = 11;
    /// bobbin.x: centre of mass, sideways \[m\].
    pub const BOBBIN_X: usize = 12;
    /// bobbin.y: centre of mass, upwards \[m\].
    pub const BOBBIN_Y: usize = 13;
    /// bobbin.phi: angle of the bar from sideways \[rad\].
    pub const BOBBIN_PHI: usize = 14;
    /// drum.x: centre of mass, sideways \[m\].
    pub const DRUM_X: usize = 15;
    /// drum.y: centre of mass, upwards \[m\].
    pub const DRUM_Y: usize = 16;
    /// drum.phi: angle of the bar from sideways \[rad\].
    pub const DRUM_PHI: usize = 17;
    /// post.v_x: rate of centre of mass, sideways \[m/s\].
    pub const POST_V_X: usize = 18;
    /// post.v_y: rate of centre of mass, upwards \[m/s\].
    pub const POST_V_Y: usize = 19;
    /// post.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const POST_OMEGA: usize = 20;
    /// plate.v_x: rate of centre of mass, sideways \[m/s\].
    pub const PLATE_V_X: usize = 21;
    /// plate.v_y: rate of centre of mass, upwards \[m/s\].
    pub const PLATE_V_Y: usize = 22;
    /// plate.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const PLATE_OMEGA: usize = 23;
    /// cylinder.v_x: rate of centre of mass, sideways \[m/s\].
    pub const CYLINDER_V_X: usize = 24;
    /// cylinder.v_y: rate of centre of mass, upwards \[m/s\].
    pub const CYLINDER_V_Y: usize = 25;
    /// cylinder.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 26;
    /// rod.v_x: rate of centre of mass, sideways \[m/s\].
    pub const ROD_V_X: usize = 27;
    /// rod.v_y: rate of centre of mass, upwards \[m/s\].
    pub const ROD_V_Y: usize = 28;
    /// rod.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const ROD_OMEGA: usize = 29;
    /// bobbin.v_x: rate of centre of mass, sideways \[m/s\].
    pub const BOBBIN_V_X: usize = 30;
    /// bobbin.v_y: rate of centre of mass, upwards \[m/s\].
    pub const BOBBIN_V_Y: usize = 31;
    /// bobbin.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const BOBBIN_OMEGA: usize = 32;
    /// drum.v_x: rate of centre of mass, sideways \[m/s\].
    pub const DRUM_V_X: usize = 33;
    /// drum.v_y: rate of centre of mass, upwards \[m/s\].
    pub const DRUM_V_Y: usize = 34;
    /// drum.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const DRUM_OMEGA: usize = 35;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 1;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_bobbin_mass: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_bobbin_mass: values[0],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [self.inverse_bobbin_mass]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    Constants { inverse_bobbin_mass }
}

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 58],
    pub cos_post_phi: R,
    pub sin_post_phi: R,
    pub cos_plate_phi: R,
    pub sin_plate_phi: R,
    pub cos_cylinder_phi: R,
    pub sin_cylinder_phi: R,
    pub cos_rod_phi: R,
    pub sin_rod_phi: R,
    pub bobbin_x_minus_drum_x_squared: R,
    pub bobbin_y_minus_drum_y_squared: R,
    pub between: R,
    pub slide: R,
    pub t8: R,
    pub t10: R,
    pub t11: R,
    pub t22: R,
    pub t24: R,
    pub t27: R,
    pub t33: R,
    pub t36: R,
    pub t37: R,
    pub t43: R,
    pub t62: R,
    pub t72: R,
    pub t75: R,
    pub t76: R,
    pub t95: R,
    pub t96: R,
    pub t98: R,
    pub t99: R,
    pub t109: R,
    pub post_v_x_dot: R,
    pub t112: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub plate_omega_dot: R,
    pub plate_v_y_dot: R,
    pub plate_v_x_dot: R,
    pub t131: R,
    pub t137: R,
    pub rod_omega_dot: R,
    pub rod_v_y_dot: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub cylinder_v_x_dot: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions need.
///
/// 473 operations.
#[must_use]
pub fn motion<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> Motion<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, _, _, post_omega, _, _,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let t1 = R::literal(0.1) * sin_post_phi;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t7 = -t0;
    let t8 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let t9 = -t2;
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = R::literal(-1.0) / t8;
    let t13 = R::literal(24.0) * sin_plate_phi;
    let t14 = R::literal(24.0) * cos_plate_phi;
    let t15 = -t14;
    let t16 = t10 * R::literal(400.0);
    let t17 = -t16;
    let t18 = t11 * R::literal(400.0);
    let t19 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t20 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t21 = R::literal(1.0)
        / R::literal(-0.833_333_333_333_333_4).sub_product(t13, t3);
    let t22 = t14 * t3;
    let t23 = t22 * t21;
    let t24 = t16 * t3;
    let t25 = R::literal(0.833_333_333_333_333_4) + t24;
    let t26 = t25 * t21;
    let t27 = t18 * t3;
    let t28 = t27 * t21;
    let t29 = -t28;
    let t30 = R::literal(1.0)
        / R::literal(-0.833_333_333_333_333_4)
            .sub_product(t14, t2)
            .sub_product(t23, t22);
    let t31 = (-(t16 * t2)).sub_product(t26, t22);
    let t32 = t31 * t30;
    let t33 = R::literal(0.833_333_333_333_333_4)
        .add_product(t18, t2)
        .add_product(t28, t22);
    let t34 = t33 * t30;
    let t35 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t10)
            - c.inverse_bobbin_mass)
            .sub_product(t26, t25)
            .sub_product(t32, t31);
    let t36 = (t18 * t10).add_product(t28, t25);
    let t37 = t34 * t31;
    let t38 = t36 - t37;
    let t39 = t38 * t35;
    let t40 = t19 * t35;
    let t41 = -t40;
    let t42 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t11)
            - c.inverse_bobbin_mass)
            .sub_product(t28, t27)
            .sub_product(t34, t33)
            .sub_product(t39, t38);
    let t43 = t40 * t38;
    let t44 = t43 - t20;
    let t45 = t44 * t42;
    let t46 = R::literal(1.0)
        / (-(t20 * bobbin_y_minus_drum_y_over_between))
            .sub_product(t19, bobbin_x_minus_drum_x_over_between)
            .sub_product(t40, t19)
            .sub_product(t45, t44);
    let t47 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t48 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t49 = -t48;
    let t50 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t51 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t52 = -t51;
    let t53 = slide * R::literal(2_777.777_777_777_778);
    let t54 = -t53;
    let t55 = sin_cylinder_phi * R::literal(5.0);
    let t56 = -t55;
    let t57 = cos_cylinder_phi * R::literal(5.0);
    let t58 = R::literal(250.0) * sin_rod_phi;
    let t59 = -t58;
    let t60 = R::literal(250.0) * cos_rod_phi;
    let t61 = R::literal(1.0)
        / R::literal(-3.333_333_333_333_333_5).sub_product(t50, t5);
    let t62 = t51 * t5;
    let t63 = t62 * t61;
    let t64 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t65 = t64 * t61;
    let t66 = -t65;
    let t67 = (-t47).add_product(t53, t5);
    let t68 = t67 * t61;
    let t69 = R::literal(1.0)
        / R::literal(-3.333_333_333_333_333_5)
            .sub_product(t51, t4)
            .sub_product(t63, t62);
    let t70 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t65, t62);
    let t71 = t70 * t69;
    let t72 = t48.sub_product(t53, t4).sub_product(t68, t62);
    let t73 = t72 * t69;
    let t74 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t65, t64).sub_product(t71, t70);
    let t75 = (-t53).add_product(t68, t64);
    let t76 = t73 * t70;
    let t77 = t75 - t76;
    let t78 = t77 * t74;
    let t79 = t58 * t74;
    let t80 = t60 * t74;
    let t81 = -t80;
    let t82 = R::literal(1.0)
        / (-(t48 * cos_cylinder_phi))
            .sub_product(t47, sin_cylinder_phi)
            .sub_product(t53, slide)
            .sub_product(t55, sin_cylinder_phi)
            .sub_product(t57, cos_cylinder_phi)
            .sub_product(t68, t67)
            .sub_product(t73, t72)
            .sub_product(t78, t77);
    let t83 = t55.sub_product(t79, t77);
    let t84 = t83 * t82;
    let t85 = (-t57).add_product(t80, t77);
    let t86 = t85 * t82;
    let t87 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t58, t6)
            .sub_product(t79, t58)
            .sub_product(t84, t83);
    let t88 = (t60 * t6).add_product(t80, t58).sub_product(t86, t83);
    let t89 = t88 * t87;
    let t90 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t60, R::literal(0.06) * cos_rod_phi)
            .sub_product(t80, t60)
            .sub_product(t86, t85)
            .sub_product(t89, t88);
    let post_omega_squared = post_omega * post_omega;
    let t91 = R::literal(0.1) * post_omega_squared;
    let t92 = t91 * cos_post_phi;
    let t93 = t91 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t94 = R::literal(0.06) * plate_omega_squared;
    let t95 = t94 * cos_plate_phi;
    let t96 = t94 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t97 = R::literal(0.06) * (rod_omega * rod_omega);
    let t98 = t97 * cos_rod_phi;
    let t99 = t97 * sin_rod_phi;
    let between_squared_times_between = between * between * between;
    let t100 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t101 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t102 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t103 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t104 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t105 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t106 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t107 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t108 = (bobbin_v_x
        * (bobbin_v_x_over_between + t102 + t103 - t100 - t101 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t106 + t107 - t104 - t105 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t100 + t101 + drum_v_x_over_between - bobbin_v_x_over_between - t102 - t103,
        )
        .add_product(
            drum_v_y,
            t104 + t105 + drum_v_y_over_between - bobbin_v_y_over_between - t106 - t107,
        );
    let t109 = t12
        * ((R::literal(0.143) * sin_post_phi)
            .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared);
    let t110 = t1 * t109;
    let post_v_x_dot = t110 - t92;
    let t111 = t0 * t109;
    let t112 = t111 + t93;
    let t113 = t110 - (t95 + t92) - (t92 - t110);
    let t114 = (-(t96 + t93) - t111 - t112).sub_product(t23, t113);
    let t115 = (t11 * plate_omega_squared).sub_product(t26, t113).sub_product(t32, t114);
    let t116 = (t10 * plate_omega_squared)
        .add_product(t28, t113)
        .sub_product(t34, t114)
        .sub_product(t39, t115);
    let t117 = (-t108).add_product(t40, t115).sub_product(t45, t116) * t46;
    let t118 = (t116 * t42).sub_product(t45, t117);
    let t119 = (t115 * t35).sub_product(t39, t118).add_product(t40, t117);
    let t120 = (t114 * t30).sub_product(t32, t119).sub_product(t34, t118);
    let t121 = (t113 * t21)
        .sub_product(t23, t120)
        .sub_product(t26, t119)
        .add_product(t28, t118);
    let bobbin_v_y_dot = (-(t20 * t117)).sub_product(c.inverse_bobbin_mass, t118);
    let bobbin_v_x_dot = (-(t19 * t117)).sub_product(c.inverse_bobbin_mass, t119);
    let plate_omega_dot = (t14 * t120)
        .sub_product(t13, t121)
        .add_product(t16, t119)
        .sub_product(t18, t118);
    let t122 = R::literal(0.833_333_333_333_333_4) * t120;
    let t123 = R::literal(-0.833_333_333_333_333_4) * t118;
    let plate_v_y_dot = -t122 - t123;
    let t124 = R::literal(0.833_333_333_333_333_4) * t121;
    let t125 = R::literal(-0.833_333_333_333_333_4) * t119;
    let plate_v_x_dot = -t124 - t125;
    let t126 = (-(t125 + t124))
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t3, plate_omega_dot);
    let t127 = (-(t123 + t122))
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        )
        .add_product(t2, plate_omega_dot)
        .sub_product(t63, t126);
    let t128 = (t65 * t126).sub_product(t71, t127);
    let t129 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t68, t126)
        .sub_product(t73, t127)
        .sub_product(t78, t128);
    let t130 = t98.sub_product(t79, t128).sub_product(t84, t129);
    let t131 = t99.add_product(t80, t128).sub_product(t86, t129).sub_product(t89, t130)
        * t90;
    let t132 = (t130 * t87).sub_product(t89, t131);
    let t133 = (t129 * t82).sub_product(t84, t132).sub_product(t86, t131);
    let t134 = (t128 * t74)
        .sub_product(t78, t133)
        .sub_product(t79, t132)
        .add_product(t80, t131);
    let t135 = (t127 * t69).sub_product(t71, t134).sub_product(t73, t133);
    let t136 = (t126 * t61)
        .sub_product(t63, t135)
        .add_product(t65, t134)
        .sub_product(t68, t133);
    let t137 = (t58 * t132).sub_product(R::literal(4_166.666_666_666_667), t134);
    let rod_omega_dot = t137.sub_product(t60, t131);
    let rod_v_y_dot = (-(R::literal(5.0) * t131)).sub_product(t57, t133);
    let rod_v_x_dot = (-(R::literal(5.0) * t132)).add_product(t55, t133);
    let cylinder_omega_dot = (t51 * t135)
        .sub_product(t50, t136)
        .sub_product(R::literal(-2_777.777_777_777_778), t134)
        .add_product(t53, t133);
    let cylinder_v_y_dot = (t48 * t133)
        .sub_product(R::literal(3.333_333_333_333_333_5), t135);
    let cylinder_v_x_dot = (-(t47 * t133))
        .sub_product(R::literal(3.333_333_333_333_333_5), t136);
    Motion {
        factors: [
            t12,
            t1,
            R::literal(-1.0),
            t7,
            t23,
            t26,
            t32,
            t29,
            t34,
            t39,
            t41,
            t45,
            t46,
            t42,
            t35,
            t30,
            t21,
            c.inverse_bobbin_mass,
            t20,
            t19,
            t13,
            t15,
            t17,
            t18,
            R::literal(0.833_333_333_333_333_4),
            R::literal(-0.833_333_333_333_333_4),
            t3,
            t9,
            t63,
            t66,
            t71,
            t68,
            t73,
            t78,
            t79,
            t84,
            t81,
            t86,
            t89,
            t90,
            t87,
            t82,
            t74,
            t69,
            t61,
            R::literal(4_166.666_666_666_667),
            t59,
            t60,
            t57,
            R::literal(5.0),
            t56,
            t50,
            t52,
            R::literal(-2_777.777_777_777_778),
            t54,
            R::literal(3.333_333_333_333_333_5),
            t49,
            t47,
        ],
        cos_post_phi,
        sin_post_phi,
        cos_plate_phi,
        sin_plate_phi,
        cos_cylinder_phi,
        sin_cylinder_phi,
        cos_rod_phi,
        sin_rod_phi,
        bobbin_x_minus_drum_x_squared,
        bobbin_y_minus_drum_y_squared,
        between,
        slide,
        t8,
        t10,
        t11,
        t22,
        t24,
        t27,
        t33,
        t36,
        t37,
        t43,
        t62,
        t72,
        t75,
        t76,
        t95,
        t96,
        t98,
        t99,
        t109,
        post_v_x_dot,
        t112,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        plate_omega_dot,
        plate_v_y_dot,
        plate_v_x_dot,
        t131,
        t137,
        rod_omega_dot,
        rod_v_y_dot,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        cylinder_v_x_dot,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.096),
        R::literal(0.03),
        R::literal(0.3),
        R::literal(0.172),
        R::literal(0.116),
        R::literal(1.9),
        R::literal(0.103),
        R::literal(0.207),
        R::literal(2.53),
        R::literal(0.049),
        R::literal(0.245),
        R::literal(2.53),
        R::literal(0.269),
        R::literal(0.139),
        R::literal(0.0),
        R::literal(0.328),
        R::literal(0.058),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(-20.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(30.0),
    ]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda` with `g'' = 0`, `h`; in the units of the states per second.
///
/// 462 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 461 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega,
    drum_v_x, drum_v_y, drum_omega] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.06) * cos_plate_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let t2 = R::literal(0.06) * cos_cylinder_phi;
    let t3 = R::literal(0.06) * sin_cylinder_phi;
    let t4 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t5 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t6 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t7 = R::literal(24.0) * sin_plate_phi;
    let t8 = R::literal(24.0) * cos_plate_phi;
    let t9 = t5 * R::literal(400.0);
    let t10 = t6 * R::literal(400.0);
    let t11 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t12 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
    let t13 = R::literal(1.0) / R::literal(-0.833_333_333_333_333_4).sub_product(t7, t1);
    let t14 = t8 * t1;
    let t15 = t14 * t13;
    let t16 = R::literal(0.833_333_333_333_333_4).add_product(t9, t1);
    let t17 = t16 * t13;
    let t18 = t10 * t1;
    let t19 = t18 * t13;
    let t20 = R::literal(1.0)
        / R::literal(-0.833_333_333_333_333_4).sub_product(t8, t0).sub_product(t15, t14);
    let t21 = (-(t9 * t0)).sub_product(t17, t14);
    let t22 = t21 * t20;
    let t23 = R::literal(0.833_333_333_333_333_4)
        .add_product(t10, t0)
        .add_product(t19, t14);
    let t24 = t23 * t20;
    let t25 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t9, t5)
            - c.inverse_bobbin_mass)
            .sub_product(t17, t16)
            .sub_product(t22, t21);
    let t26 = (t10 * t5).add_product(t19, t16).sub_product(t24, t21);
    let t27 = t26 * t25;
    let t28 = t11 * t25;
    let t29 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t10, t6)
            - c.inverse_bobbin_mass)
            .sub_product(t19, t18)
            .sub_product(t24, t23)
            .sub_product(t27, t26);
    let t30 = (-t12).add_product(t28, t26);
    let t31 = t30 * t29;
    let t32 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t33 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t34 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t35 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t36 = slide * R::literal(2_777.777_777_777_778);
    let t37 = sin_cylinder_phi * R::literal(5.0);
    let t38 = cos_cylinder_phi * R::literal(5.0);
    let t39 = R::literal(250.0) * sin_rod_phi;
    let t40 = R::literal(250.0) * cos_rod_phi;
    let t41 = R::literal(1.0)
        / R::literal(-3.333_333_333_333_333_5).sub_product(t34, t3);
    let t42 = t35 * t3;
    let t43 = t42 * t41;
    let t44 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t45 = t44 * t41;
    let t46 = (-t32).add_product(t36, t3);
    let t47 = t46 * t41;
    let t48 = R::literal(1.0)
        / R::literal(-3.333_333_333_333_333_5)
            .sub_product(t35, t2)
            .sub_product(t43, t42);
    let t49 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t45, t42);
    let t50 = t49 * t48;
    let t51 = t33.sub_product(t36, t2).sub_product(t47, t42);
    let t52 = t51 * t48;
    let t53 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t45, t44).sub_product(t50, t49);
    let t54 = (-t36).add_product(t47, t44).sub_product(t52, t49);
    let t55 = t54 * t53;
    let t56 = t39 * t53;
    let t57 = t40 * t53;
    let t58 = R::literal(1.0)
        / (-(t33 * cos_cylinder_phi))
            .sub_product(t32, sin_cylinder_phi)
            .sub_product(t36, slide)
            .sub_product(t37, sin_cylinder_phi)
            .sub_product(t38, cos_cylinder_phi)
            .sub_product(t47, t46)
            .sub_product(t52, t51)
            .sub_product(t55, t54);
    let t59 = t37.sub_product(t56, t54);
    let t60 = t59 * t58;
    let t61 = (-t38).add_product(t57, t54);
    let t62 = t61 * t58;
    let t63 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t39, t4)
            .sub_product(t56, t39)
            .sub_product(t60, t59);
    let t64 = (t40 * t4).add_product(t57, t39).sub_product(t62, t59);
    let t65 = t64 * t63;
    let post_omega_squared = post_omega * post_omega;
    let t66 = R::literal(0.1) * post_omega_squared;
    let t67 = t66 * cos_post_phi;
    let t68 = t66 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t69 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t70 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t71 = bobbin_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t72 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t73 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t74 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t75 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t76 = bobbin_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t77 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t78 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t79 = (bobbin_v_x
        * (bobbin_v_x_over_between + t73 + t74 - t71 - t72 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t77 + t78 - t75 - t76 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t71 + t72 + drum_v_x_over_between - bobbin_v_x_over_between - t73 - t74,
        )
        .add_product(
            drum_v_y,
            t75 + t76 + drum_v_y_over_between - bobbin_v_y_over_between - t77 - t78,
        );
    let t80 = R::literal(-1.0)
        / (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi)
        * ((R::literal(0.143) * sin_post_phi)
            .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared);
    let post_omega_dot = -t80;
    let t81 = R::literal(0.1) * sin_post_phi * t80;
    let post_v_x_dot = t81 - t67;
    let t82 = R::literal(0.1) * cos_post_phi * t80;
    let t83 = t82 + t68;
    let post_v_y_dot = -t83;
    let t84 = t81 - t67.add_product(t69, cos_plate_phi) - (t67 - t81);
    let t85 = (-t68.add_product(t69, sin_plate_phi) - t82 - t83).sub_product(t15, t84);
    let t86 = (t6 * plate_omega_squared).sub_product(t17, t84).sub_product(t22, t85);
    let t87 = (t5 * plate_omega_squared)
        .add_product(t19, t84)
        .sub_product(t24, t85)
        .sub_product(t27, t86);
    let t88 = (-t79).add_product(t28, t86).sub_product(t31, t87)
        * (R::literal(1.0)
            / (-(t12 * bobbin_y_minus_drum_y_over_between))
                .sub_product(t11, bobbin_x_minus_drum_x_over_between)
                .sub_product(t28, t11)
                .sub_product(t31, t30));
    let t89 = (t87 * t29).sub_product(t31, t88);
    let t90 = (t86 * t25).sub_product(t27, t89).add_product(t28, t88);
    let t91 = (t85 * t20).sub_product(t22, t90).sub_product(t24, t89);
    let t92 = (t84 * t13)
        .sub_product(t15, t91)
        .sub_product(t17, t90)
        .add_product(t19, t89);
    let bobbin_v_y_dot = (-(t12 * t88)).sub_product(c.inverse_bobbin_mass, t89);
    let bobbin_v_x_dot = (-(t11 * t88)).sub_product(c.inverse_bobbin_mass, t90);
    let plate_omega_dot = (t8 * t91)
        .sub_product(t7, t92)
        .add_product(t9, t90)
        .sub_product(t10, t89);
    let t93 = R::literal(0.833_333_333_333_333_4) * t91;
    let t94 = R::literal(-0.833_333_333_333_333_4) * t89;
    let plate_v_y_dot = -t93 - t94;
    let t95 = R::literal(0.833_333_333_333_333_4) * t92;
    let t96 = R::literal(-0.833_333_333_333_333_4) * t90;
    let plate_v_x_dot = -t95 - t96;
    let t97 = (-(t96 + t95))
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t1, plate_omega_dot);
    let t98 = (-(t94 + t93))
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        )
        .add_product(t0, plate_omega_dot)
        .sub_product(t43, t97);
    let t99 = (t45 * t97).sub_product(t50, t98);
    let t100 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t47, t97)
        .sub_product(t52, t98)
        .sub_product(t55, t99);
    let t101 = (t70 * cos_rod_phi).sub_product(t56, t99).sub_product(t60, t100);
    let t102 = (t70 * sin_rod_phi)
        .add_product(t57, t99)
        .sub_product(t62, t100)
        .sub_product(t65, t101)
        * (R::literal(1.0)
            / R::literal(-5.0)
                .sub_product(t40, R::literal(0.06) * cos_rod_phi)
                .sub_product(t57, t40)
                .sub_product(t62, t61)
                .sub_product(t65, t64));
    let t103 = (t101 * t63).sub_product(t65, t102);
    let t104 = (t100 * t58).sub_product(t60, t103).sub_product(t62, t102);
    let t105 = (t99 * t53)
        .sub_product(t55, t104)
        .sub_product(t56, t103)
        .add_product(t57, t102);
    let t106 = (t98 * t48).sub_product(t50, t105).sub_product(t52, t104);
    let t107 = (t97 * t41)
        .sub_product(t43, t106)
        .add_product(t45, t105)
        .sub_product(t47, t104);
    let rod_omega_dot = (t39 * t103)
        .sub_product(R::literal(4_166.666_666_666_667), t105)
        .sub_product(t40, t102);
    let rod_v_y_dot = (-(R::literal(5.0) * t102)).sub_product(t38, t104);
    let rod_v_x_dot = (-(R::literal(5.0) * t103)).add_product(t37, t104);
    let cylinder_omega_dot = (t35 * t106)
        .sub_product(t34, t107)
        .sub_product(R::literal(-2_777.777_777_777_778), t105)
        .add_product(t36, t104);
    let cylinder_v_y_dot = (t33 * t104)
        .sub_product(R::literal(3.333_333_333_333_333_5), t106);
    let cylinder_v_x_dot = (-(t32 * t104))
        .sub_product(R::literal(3.333_333_333_333_333_5), t107);
    [
        post_v_x,
        post_v_y,
        post_omega,
        plate_v_x,
        plate_v_y,
        plate_omega,
        cylinder_v_x,
        cylinder_v_y,
        cylinder_omega,
        rod_v_x,
        rod_v_y,
        rod_omega,
        bobbin_v_x,
        bobbin_v_y,
        bobbin_omega,
        drum_v_x,
        drum_v_y,
        drum_omega,
        post_v_x_dot,
        post_v_y_dot,
        post_omega_dot,
        plate_v_x_dot,
        plate_v_y_dot,
        plate_omega_dot,
        cylinder_v_x_dot,
        cylinder_v_y_dot,
        cylinder_omega_dot,
        rod_v_x_dot,
        rod_v_y_dot,
        rod_omega_dot,
        bobbin_v_x_dot,
        bobbin_v_y_dot,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 18] {
    [
        R::literal(0.8),
        R::literal(0.8),
        R::literal(0.0027),
        R::literal(1.2),
        R::literal(1.2),
        R::literal(0.0025),
        R::literal(0.3),
        R::literal(0.3),
        R::literal(0.00036),
        R::literal(0.2),
        R::literal(0.2),
        R::literal(0.00024),
        p.bobbin_mass,
        p.bobbin_mass,
        R::literal(0.0013),
        R::literal(1.5),
        R::literal(1.5),
        R::literal(0.0012),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 51 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _,
    bobbin_x, bobbin_y, _, drum_x, drum_y, _, _, _, _, _, _, _, cylinder_v_x,
    cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, ..] = *state;
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y)
        .sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t0 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t0)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let plate_phi_forcing = -(p.bobbin_radius * p.winding_force);
    let t1 = R::literal(50.0) * slide_rate;
    let t2 = t1 * cos_cylinder_phi;
    let t3 = p.spring_stiffness * (slide - p.spring_free_length);
    let t4 = t3 * cos_cylinder_phi;
    let cylinder_x_forcing = t2 + t4;
    let t5 = t3 * sin_cylinder_phi;
    let t6 = t1 * sin_cylinder_phi;
    let cylinder_y_forcing = t6 - (R::literal(2.943) - t5);
    let cylinder_phi_forcing = (-(t3 * t0)).sub_product(t1, t0);
    let rod_x_forcing = -t2 - t4;
    let rod_y_forcing = -t6 - (R::literal(1.962) + t5);
    let bobbin_x_forcing = -(p.winding_force * bobbin_y_minus_drum_y / between);
    let bobbin_y_forcing = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    [
        R::literal(0.0),
        R::literal(-7.848),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(-11.772),
        plate_phi_forcing,
        cylinder_x_forcing,
        cylinder_y_forcing,
        cylinder_phi_forcing,
        rod_x_forcing,
        rod_y_forcing,
        R::literal(0.0),
        bobbin_x_forcing,
        bobbin_y_forcing,
        R::literal(0.0),
        R::literal(0.0),
        R::literal(-14.715),
        R::literal(0.0),
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 390 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 228] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 390 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 228] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x,
    bobbin_y, _, drum_x, drum_y, _, _, _, post_omega, _, _, plate_omega, cylinder_v_x,
    cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _,
    drum_v_x, drum_v_y, ..] = *state;
    let m = &motion(time, state, p, c);
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t0 = cylinder_omega_squared * m.cos_cylinder_phi;
    let t1 = cylinder_omega_squared * m.sin_cylinder_phi;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t2 = m.between * m.between;
    let t3 = t2 * m.between;
    let t4 = m.t96.sub_product(R::literal(0.06) * m.cos_plate_phi, m.plate_omega_dot);
    let t5 = (-m.t95).sub_product(m.factors[26], m.plate_omega_dot);
    let t6 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t7 = m.sin_cylinder_phi * m.cylinder_omega_dot;
    let t8 = R::literal(0.06) * cylinder_omega_squared;
    let t9 = R::literal(3.0) * bobbin_v_x;
    let t10 = t9 * bobbin_x_minus_drum_x;
    let t11 = t10 / t3;
    let t12 = m.between.powi(5);
    let t13 = m.bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t14 = R::literal(3.0) * drum_v_x;
    let t15 = t14 * t13 / t12;
    let t16 = R::literal(3.0) * drum_v_y;
    let t17 = t16 * bobbin_y_minus_drum_y;
    let t18 = t17 * m.bobbin_x_minus_drum_x_squared / t12;
    let t19 = bobbin_v_y * bobbin_y_minus_drum_y / t3;
    let t20 = t9 * t13 / t12;
    let t21 = R::literal(3.0) * bobbin_v_y;
    let t22 = t21 * bobbin_y_minus_drum_y;
    let t23 = t22 * m.bobbin_x_minus_drum_x_squared / t12;
    let t24 = t14 * bobbin_x_minus_drum_x;
    let t25 = t24 / t3;
    let t26 = drum_v_y * bobbin_y_minus_drum_y / t3;
    let t27 = t20 + t23 + t25 + t26 - t11 - t15 - t18 - t19;
    let t28 = t14 * bobbin_y_minus_drum_y * m.bobbin_x_minus_drum_x_squared / t12;
    let t29 = t16 * bobbin_x_minus_drum_x * m.bobbin_y_minus_drum_y_squared / t12;
    let t30 = bobbin_v_x * bobbin_y_minus_drum_y / t3;
    let t31 = bobbin_v_y * bobbin_x_minus_drum_x / t3;
    let t32 = t9 * bobbin_y_minus_drum_y * m.bobbin_x_minus_drum_x_squared / t12;
    let t33 = t21 * bobbin_x_minus_drum_x * m.bobbin_y_minus_drum_y_squared / t12;
    let t34 = drum_v_x * bobbin_y_minus_drum_y / t3;
    let t35 = drum_v_y * bobbin_x_minus_drum_x / t3;
    let t36 = t32 + t33 + t34 + t35 - t28 - t29 - t30 - t31;
    let t37 = t11 + t15 + t18 + t19 - t20 - t23 - t25 - t26;
    let t38 = t28 + t29 + t30 + t31 - t32 - t33 - t34 - t35;
    let t39 = R::literal(1.0) / m.between;
    let t40 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y / t3;
    let t41 = t40 * m.bobbin_v_y_dot;
    let t42 = t22 / t3;
    let t43 = t24 * m.bobbin_y_minus_drum_y_squared / t12;
    let t44 = m.bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t45 = t16 * t44 / t12;
    let t46 = bobbin_v_x * bobbin_x_minus_drum_x / t3;
    let t47 = t10 * m.bobbin_y_minus_drum_y_squared / t12;
    let t48 = t21 * t44 / t12;
    let t49 = t17 / t3;
    let t50 = drum_v_x * bobbin_x_minus_drum_x / t3;
    let t51 = t47 + t48 + t49 + t50 - t42 - t43 - t45 - t46;
    let t52 = t42 + t43 + t45 + t46 - t47 - t48 - t49 - t50;
    let t53 = t40 * m.bobbin_v_x_dot;
    let t54 = R::literal(0.2) * post_omega;
    let t55 = -(t54 * m.cos_post_phi);
    let t56 = -(t54 * m.sin_post_phi);
    let t57 = R::literal(0.12) * plate_omega;
    let t58 = -(t57 * m.cos_plate_phi);
    let t59 = -(t57 * m.sin_plate_phi);
    let t60 = R::literal(2.0) * cylinder_omega;
    let t61 = t60 * m.cos_cylinder_phi;
    let t62 = t60 * m.sin_cylinder_phi;
    let t63 = R::literal(0.12) * cylinder_omega;
    let t64 = R::literal(0.12) * rod_omega;
    let t65 = R::literal(2.0) * bobbin_x * drum_x;
    let bobbin_x_times_bobbin_y = bobbin_x * bobbin_y;
    let bobbin_x_times_drum_y = bobbin_x * drum_y;
    let bobbin_y_times_drum_x = bobbin_y * drum_x;
    let drum_x_times_drum_y = drum_x * drum_y;
    let bobbin_x_squared = bobbin_x * bobbin_x;
    let drum_x_squared = drum_x * drum_x;
    let t66 = R::literal(2.0)
        * (bobbin_x_times_bobbin_y * bobbin_v_y)
            .add_product(t65, drum_v_x)
            .add_product(bobbin_x_times_drum_y, drum_v_y)
            .add_product(bobbin_y_times_drum_x, drum_v_y)
            .add_product(drum_x_times_drum_y, bobbin_v_y)
            .add_product(bobbin_v_x, bobbin_x_squared)
            .add_product(bobbin_v_x, drum_x_squared)
            .add_product(drum_v_x, t2)
            .sub_product(t65, bobbin_v_x)
            .sub_product(bobbin_x_times_bobbin_y, drum_v_y)
            .sub_product(bobbin_x_times_drum_y, bobbin_v_y)
            .sub_product(bobbin_y_times_drum_x, bobbin_v_y)
            .sub_product(drum_x_times_drum_y, drum_v_y)
            .sub_product(bobbin_v_x, t2)
            .sub_product(drum_v_x, bobbin_x_squared)
            .sub_product(drum_v_x, drum_x_squared) / t3;
    let t67 = R::literal(2.0) * bobbin_y * drum_y;
    let bobbin_y_squared = bobbin_y * bobbin_y;
    let drum_y_squared = drum_y * drum_y;
    let t68 = R::literal(2.0)
        * (bobbin_x_times_bobbin_y * bobbin_v_x)
            .add_product(t67, drum_v_y)
            .add_product(bobbin_x_times_drum_y, drum_v_x)
            .add_product(bobbin_y_times_drum_x, drum_v_x)
            .add_product(drum_x_times_drum_y, bobbin_v_x)
            .add_product(bobbin_v_y, bobbin_y_squared)
            .add_product(bobbin_v_y, drum_y_squared)
            .add_product(drum_v_y, t2)
            .sub_product(t67, bobbin_v_y)
            .sub_product(bobbin_x_times_bobbin_y, drum_v_x)
            .sub_product(bobbin_x_times_drum_y, bobbin_v_x)
            .sub_product(bobbin_y_times_drum_x, bobbin_v_x)
            .sub_product(drum_x_times_drum_y, drum_v_x)
            .sub_product(bobbin_v_y, t2)
            .sub_product(drum_v_y, bobbin_y_squared)
            .sub_product(drum_v_y, drum_y_squared) / t3;
    let mut x = [[R::literal(0.0); 24]; 34];
    x[18][0] = m.t112;
    x[19][0] = m.post_v_x_dot;
    x[20][0] = m.t112;
    x[21][0] = m.post_v_x_dot;
    x[33][0] = (m.t8 * (post_omega * post_omega))
        .add_product(
            (R::literal(0.044) * m.cos_post_phi)
                .sub_product(R::literal(0.143), m.sin_post_phi),
            m.t109,
        );
    x[20][1] = t4;
    x[21][1] = t5;
    x[22][1] = t4;
    x[23][1] = t5;
    x[28][1] = (-((R::literal(0.1) * m.sin_plate_phi)
        .sub_product(R::literal(0.01), m.cos_plate_phi) * m.plate_omega_dot))
        .add_product(
            (-(R::literal(0.01) * m.sin_plate_phi))
                .sub_product(R::literal(0.1), m.cos_plate_phi),
            plate_omega_squared,
        );
    x[29][1] = (m.t10 * m.plate_omega_dot).add_product(m.t11, plate_omega_squared);
    x[25][2] = t1 - t6;
    x[25][3] = -t0 - t7;
    x[22][4] = (-(R::literal(0.06) * m.cos_cylinder_phi * m.cylinder_omega_dot))
        .add_product(t8, m.sin_cylinder_phi);
    x[23][4] = (-(R::literal(0.06) * m.sin_cylinder_phi * m.cylinder_omega_dot))
        .sub_product(t8, m.cos_cylinder_phi);
    x[25][4] = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot))
        .add_product(
            cylinder_omega,
            (R::literal(2.0) * cylinder_v_x * m.sin_cylinder_phi)
                .add_product(R::literal(2.0) * rod_v_y, m.cos_cylinder_phi)
                .add_product(cylinder_x_times_cylinder_omega, m.cos_cylinder_phi)
                .add_product(cylinder_y_times_cylinder_omega, m.sin_cylinder_phi)
                .sub_product(R::literal(2.0) * cylinder_v_y, m.cos_cylinder_phi)
                .sub_product(R::literal(2.0) * rod_v_x, m.sin_cylinder_phi)
                .sub_product(rod_x_times_cylinder_omega, m.cos_cylinder_phi)
                .sub_product(rod_y_times_cylinder_omega, m.sin_cylinder_phi),
        )
        .sub_product(m.sin_cylinder_phi, m.cylinder_v_y_dot)
        .sub_product(
            ((rod_x - cylinder_x) * m.sin_cylinder_phi)
                .sub_product(rod_y - cylinder_y, m.cos_cylinder_phi),
            m.cylinder_omega_dot,
        )
        .add_product(m.cos_cylinder_phi, m.rod_v_x_dot)
        .add_product(m.sin_cylinder_phi, m.rod_v_y_dot);
    x[25][5] = t6 - t1;
    x[25][6] = t0 + t7;
    x[26][7] = (-m.t99).add_product(R::literal(0.06) * m.cos_rod_phi, m.rod_omega_dot);
    x[27][7] = m.t98.add_product(R::literal(0.06) * m.sin_rod_phi, m.rod_omega_dot);
    x[32][8] = (-(bobbin_v_x * t27)
        .add_product(bobbin_v_y, t36)
        .add_product(drum_v_x, t37)
        .add_product(drum_v_y, t38))
        .sub_product(t39 - m.bobbin_x_minus_drum_x_squared / t3, m.bobbin_v_x_dot) + t41;
    x[32][9] = (t53
        - (bobbin_v_x * t36)
            .add_product(bobbin_v_y, t51)
            .add_product(drum_v_x, t38)
            .add_product(drum_v_y, t52))
        .sub_product(t39 - m.bobbin_y_minus_drum_y_squared / t3, m.bobbin_v_y_dot);
    x[32][10] = (-(bobbin_v_x * t37)
        .add_product(bobbin_v_y, t38)
        .add_product(drum_v_x, t27)
        .add_product(drum_v_y, t36))
        .sub_product(
            (bobbin_x + m.between - drum_x) * (bobbin_x_minus_drum_x - m.between) / t3,
            m.bobbin_v_x_dot,
        ) - t41;
    x[32][11] = (-(bobbin_v_x * t38)
        .add_product(bobbin_v_y, t52)
        .add_product(drum_v_x, t36)
        .add_product(drum_v_y, t51) - t53)
        .sub_product(
            (bobbin_y + m.between - drum_y) * (bobbin_y_minus_drum_y - m.between) / t3,
            m.bobbin_v_y_dot,
        );
    x[18][12] = t55;
    x[19][12] = t56;
    x[20][12] = t55;
    x[21][12] = t56;
    x[33][12] = post_omega
        * (R::literal(0.286) * m.sin_post_phi)
            .sub_product(R::literal(0.088), m.cos_post_phi);
    x[20][13] = t58;
    x[21][13] = t59;
    x[22][13] = t58;
    x[23][13] = t59;
    x[28][13] = plate_omega
        * (R::literal(0.02) * m.cos_plate_phi)
            .sub_product(R::literal(0.2), m.sin_plate_phi);
    x[29][13] = plate_omega
        * (R::literal(0.02) * m.sin_plate_phi)
            .add_product(R::literal(0.2), m.cos_plate_phi);
    x[25][14] = -t61;
    x[25][15] = -t62;
    x[22][16] = -(t63 * m.cos_cylinder_phi);
    x[23][16] = -(t63 * m.sin_cylinder_phi);
    x[25][16] = R::literal(2.0)
        * (cylinder_x_times_cylinder_omega * m.sin_cylinder_phi)
            .add_product(rod_y_times_cylinder_omega, m.cos_cylinder_phi)
            .add_product(rod_v_x, m.cos_cylinder_phi)
            .add_product(rod_v_y, m.sin_cylinder_phi)
            .sub_product(cylinder_y_times_cylinder_omega, m.cos_cylinder_phi)
            .sub_product(rod_x_times_cylinder_omega, m.sin_cylinder_phi)
            .sub_product(cylinder_v_x, m.cos_cylinder_phi)
            .sub_product(cylinder_v_y, m.sin_cylinder_phi);
    x[25][17] = t61;
    x[25][18] = t62;
    x[26][19] = t64 * m.cos_rod_phi;
    x[27][19] = t64 * m.sin_rod_phi;
    x[32][20] = t66;
    x[32][21] = t68;
    x[32][22] = -t66;
    x[32][23] = -t68;
    substitute(RATE_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        x[0][0], x[0][12], x[1][0], x[1][12], x[2][0], x[2][12], x[3][0], x[3][1], x[3][8], x[3][9],
        x[3][10], x[3][11], x[3][12], x[3][13], x[3][20], x[3][21], x[3][22], x[3][23], x[4][0],
        x[4][1], x[4][8], x[4][9], x[4][10], x[4][11], x[4][12], x[4][13], x[4][20], x[4][21],
        x[4][22], x[4][23], x[5][0], x[5][1], x[5][8], x[5][9], x[5][10], x[5][11], x[5][12],
        x[5][13], x[5][20], x[5][21], x[5][22], x[5][23], x[6][0], x[6][1], x[6][2], x[6][3],
        x[6][4], x[6][5], x[6][6], x[6][7], x[6][8], x[6][9], x[6][10], x[6][11], x[6][12],
        x[6][13], x[6][14], x[6][15], x[6][16], x[6][17], x[6][18], x[6][19], x[6][20], x[6][21],
        x[6][22], x[6][23], x[7][0], x[7][1], x[7][2], x[7][3], x[7][4], x[7][5], x[7][6], x[7][7],
        x[7][8], x[7][9], x[7][10], x[7][11], x[7][12], x[7][13], x[7][14], x[7][15], x[7][16],
        x[7][17], x[7][18], x[7][19], x[7][20], x[7][21], x[7][22], x[7][23], x[8][0], x[8][1],
        x[8][2], x[8][3], x[8][4], x[8][5], x[8][6], x[8][7], x[8][8], x[8][9], x[8][10], x[8][11],
        x[8][12], x[8][13], x[8][14], x[8][15], x[8][16], x[8][17], x[8][18], x[8][19], x[8][20],
        x[8][21], x[8][22], x[8][23], x[9][0], x[9][1], x[9][2], x[9][3], x[9][4], x[9][5], x[9][6],
        x[9][7], x[9][8], x[9][9], x[9][10], x[9][11], x[9][12], x[9][13], x[9][14], x[9][15],
        x[9][16], x[9][17], x[9][18], x[9][19], x[9][20], x[9][21], x[9][22], x[9][23], x[10][0],
        x[10][1], x[10][2], x[10][3], x[10][4], x[10][5], x[10][6], x[10][7], x[10][8], x[10][9],
        x[10][10], x[10][11], x[10][12], x[10][13], x[10][14], x[10][15], x[10][16], x[10][17],
        x[10][18], x[10][19], x[10][20], x[10][21], x[10][22], x[10][23], x[11][0], x[11][1],
        x[11][2], x[11][3], x[11][4], x[11][5], x[11][6], x[11][7], x[11][8], x[11][9], x[11][10],
        x[11][11], x[11][12], x[11][13], x[11][14], x[11][15], x[11][16], x[11][17], x[11][18],
        x[11][19], x[11][20], x[11][21], x[11][22], x[11][23], x[12][0], x[12][1], x[12][8],
        x[12][9], x[12][10], x[12][11], x[12][12], x[12][13], x[12][20], x[12][21], x[12][22],
        x[12][23], x[13][0], x[13][1], x[13][8], x[13][9], x[13][10], x[13][11], x[13][12],
        x[13][13], x[13][20], x[13][21], x[13][22], x[13][23],
    ]
}

static RATE_JACOBIAN_STEPS: &[Step<'static>] = &[
    Step::less(2, &[(0, 33)]),
    Step::less(18, &[(1, 2)]),
    Step::less(0, &[(2, 18)]),
    Step::less(19, &[(3, 2)]),
    Step::less(1, &[(2, 19)]),
    Step::less(20, &[(1, 2), (2, 0)]),
    Step::less(21, &[(3, 2), (2, 1)]),
    Step::less(21, &[(4, 20)]),
    Step::less(28, &[(5, 20), (6, 21)]),
    Step::less(29, &[(7, 20), (8, 21), (9, 28)]),
    Step::less(32, &[(10, 28), (11, 29)]),
    Step::scaled(32, 12, &[]),
    Step::scaled(29, 13, &[(11, 32)]),
    Step::scaled(28, 14, &[(9, 29), (10, 32)]),
    Step::scaled(21, 15, &[(6, 28), (8, 29)]),
    Step::scaled(20, 16, &[(4, 21), (5, 28), (7, 29)]),
    Step::less(13, &[(17, 29), (18, 32)]),
    Step::less(12, &[(17, 28), (19, 32)]),
    Step::less(5, &[(20, 20), (21, 21), (22, 28), (23, 29)]),
    Step::less(4, &[(24, 21), (25, 29)]),
    Step::less(3, &[(24, 20), (25, 28)]),
    Step::less(22, &[(2, 3), (26, 5)]),
    Step::less(23, &[(2, 4), (27, 5)]),
    Step::less(23, &[(28, 22)]),
    Step::less(24, &[(29, 22), (30, 23)]),
    Step::less(25, &[(31, 22), (32, 23), (33, 24)]),
    Step::less(26, &[(34, 24), (35, 25)]),
    Step::less(27, &[(36, 24), (37, 25), (38, 26)]),
    Step::scaled(27, 39, &[]),
    Step::scaled(26, 40, &[(38, 27)]),
    Step::scaled(25, 41, &[(35, 26), (37, 27)]),
    Step::scaled(24, 42, &[(33, 25), (34, 26), (36, 27)]),
    Step::scaled(23, 43, &[(30, 24), (32, 25)]),
    Step::scaled(22, 44, &[(28, 23), (29, 24), (31, 25)]),
    Step::less(11, &[(45, 24), (46, 26), (47, 27)]),
    Step::less(10, &[(48, 25), (49, 27)]),
    Step::less(9, &[(50, 25), (49, 26)]),
    Step::less(8, &[(51, 22), (52, 23), (53, 24), (54, 25)]),
    Step::less(7, &[(55, 23), (56, 25)]),
    Step::less(6, &[(55, 22), (57, 25)]),
];

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time.
///
/// No operations.
#[must_use]
pub fn time_derivative<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
    ]
}

/// Wanted outputs.
///
/// 241 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, _, rod_x, rod_y, _,
    bobbin_x, bobbin_y, bobbin_phi, drum_x, drum_y, drum_phi, _, _, _, _, _, _,
    cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let t0 = R::literal(0.1) * m.cos_post_phi;
    let t1 = ((rod_y - cylinder_y) * m.cos_cylinder_phi)
        .sub_product(rod_x - cylinder_x, m.sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * m.cos_cylinder_phi)
        .add_product(cylinder_omega, t1)
        .add_product(rod_v_y - cylinder_v_y, m.sin_cylinder_phi);
    let t2 = m.t27 * m.factors[16];
    let t3 = m.factors[19] * m.factors[14];
    let t4 = R::literal(-166.666_666_666_666_66) * m.sin_cylinder_phi * m.factors[44];
    let t5 = m.factors[47] * m.factors[42];
    let t6 = R::literal(50.0) * slide_rate;
    let t7 = t6 * m.cos_cylinder_phi;
    let t8 = p.spring_stiffness * (m.slide - p.spring_free_length);
    let t9 = t8 * m.cos_cylinder_phi;
    let t10 = t8 * m.sin_cylinder_phi;
    let t11 = t6 * m.sin_cylinder_phi;
    let t12 = (t7 + t9).sub_product(R::literal(0.3), m.cylinder_v_x_dot);
    let t13 = (t11 - (R::literal(2.943) - t10))
        .sub_product(R::literal(0.3), m.cylinder_v_y_dot);
    let t14 = (-(t8 * t1))
        .sub_product(t6, t1)
        .sub_product(R::literal(0.00036), m.cylinder_omega_dot);
    let t15 = (-t7 - t9).sub_product(R::literal(0.2), m.rod_v_x_dot);
    let t16 = (-t11 - (R::literal(1.962) + t10))
        .sub_product(R::literal(0.2), m.rod_v_y_dot);
    let t17 = R::literal(0.00024) * m.rod_omega_dot;
    let t18 = (-(R::literal(3.333_333_333_333_333_5) * t12))
        .sub_product(m.factors[51], t14);
    let t19 = (-(R::literal(3.333_333_333_333_333_5) * t13))
        .add_product(R::literal(166.666_666_666_666_66) * m.cos_cylinder_phi, t14)
        .sub_product(m.factors[28], t18);
    let t20 = (-(-m.t137).add_product(m.factors[47], m.t131))
        .sub_product(R::literal(-2_777.777_777_777_778), t14)
        .add_product(t4, t18)
        .sub_product(m.factors[30], t19);
    let t21 = (m.cos_cylinder_phi * R::literal(3.333_333_333_333_333_5) * t13)
        .sub_product(m.factors[57], t12)
        .add_product(m.slide * R::literal(2_777.777_777_777_778), t14)
        .add_product(m.sin_cylinder_phi * R::literal(5.0), t15)
        .sub_product(m.factors[48], t16)
        .sub_product(m.factors[31], t18)
        .sub_product(m.factors[32], t19)
        .sub_product(m.factors[33], t20);
    let t22 = (-(R::literal(250.0) * m.sin_rod_phi * t17))
        .sub_product(R::literal(5.0), t15)
        .sub_product(m.factors[34], t20)
        .sub_product(m.factors[35], t21);
    let t23 = (m.factors[47] * t17)
        .sub_product(R::literal(5.0), t16)
        .add_product(t5, t20)
        .sub_product(m.factors[37], t21)
        .sub_product(m.factors[38], t22) * m.factors[39];
    let t24 = (t22 * m.factors[40]).sub_product(m.factors[38], t23);
    let t25 = (t21 * m.factors[41])
        .sub_product(m.factors[35], t24)
        .sub_product(m.factors[37], t23);
    let t26 = (t20 * m.factors[42])
        .sub_product(m.factors[33], t25)
        .sub_product(m.factors[34], t24)
        .add_product(t5, t23);
    let t27 = (t19 * m.factors[43]).sub_product(m.factors[30], t26);
    let t28 = m.factors[32] * t25;
    let t29 = t27 - t28;
    let t30 = (t18 * m.factors[44]).sub_product(m.factors[28], t29).add_product(t4, t26);
    let t31 = m.factors[31] * t25;
    let pin_d_x = t31 - t30;
    let t32 = (-pin_d_x).sub_product(R::literal(1.2), m.plate_v_x_dot);
    let pin_d_y = t28 - t27;
    let t33 = R::literal(-11.772).sub_product(R::literal(1.2), m.plate_v_y_dot)
        - pin_d_y;
    let t34 = (-(R::literal(0.0025) * m.plate_omega_dot))
        .sub_product(p.bobbin_radius, p.winding_force)
        .sub_product(m.factors[26], t30 - t31)
        .add_product(R::literal(0.06) * m.cos_plate_phi, t29);
    let t35 = (-(p.winding_force * (bobbin_y - drum_y) / m.between))
        .sub_product(p.bobbin_mass, m.bobbin_v_x_dot);
    let t36 = (p.winding_force * (bobbin_x - drum_x) / m.between)
        .sub_product(R::literal(9.81), p.bobbin_mass)
        .sub_product(p.bobbin_mass, m.bobbin_v_y_dot);
    let t37 = (-(R::literal(0.833_333_333_333_333_4) * t32))
        .sub_product(m.factors[20], t34);
    let t38 = (-(R::literal(0.833_333_333_333_333_4) * t33))
        .add_product(R::literal(24.0) * m.cos_plate_phi, t34)
        .sub_product(m.factors[4], t37);
    let t39 = (-(R::literal(-0.833_333_333_333_333_4) * t32))
        .add_product(m.t10 * R::literal(400.0), t34)
        .sub_product(m.factors[17], t35)
        .sub_product(m.factors[5], t37)
        .sub_product(m.factors[6], t38);
    let t40 = (-(R::literal(-0.833_333_333_333_333_4) * t33))
        .sub_product(m.factors[23], t34)
        .sub_product(m.factors[17], t36)
        .add_product(t2, t37)
        .sub_product(m.factors[8], t38)
        .sub_product(m.factors[9], t39);
    let t41 = (-(m.factors[18] * t36))
        .sub_product(m.factors[19], t35)
        .add_product(t3, t39)
        .sub_product(m.factors[11], t40) * m.factors[12];
    let t42 = (t40 * m.factors[13]).sub_product(m.factors[11], t41);
    let t43 = (t39 * m.factors[14]).sub_product(m.factors[9], t42).add_product(t3, t41);
    let t44 = (t38 * m.factors[15]).sub_product(m.factors[6], t43);
    let t45 = m.factors[8] * t42;
    let t46 = t44 - t45;
    let t47 = (t37 * m.factors[16])
        .sub_product(m.factors[4], t46)
        .sub_product(m.factors[5], t43)
        .add_product(t2, t42);
    let pin_c_y = t45 - t44;
    let stop = m.factors[0]
        * (R::literal(0.0027) * m.t109)
            .sub_product(m.factors[1], t47)
            .add_product(t0, t46)
            .add_product(
                t0,
                R::literal(-7.848).add_product(R::literal(0.8), m.t112) - pin_c_y,
            )
            .sub_product(m.factors[1], t47.sub_product(R::literal(0.8), m.post_v_x_dot));
    let contact = -t41;
    Outputs {
        contact_force: contact,
        stop_force: stop,
        strut_push: -t6 - t8,
        post_angle: post_phi,
        plate_angle: plate_phi,
        bobbin_angle: bobbin_phi,
        drum_angle: drum_phi,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 72 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, post_y, _, _, plate_y, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y,
    _, _, bobbin_y, _, _, drum_y, _, post_v_x, post_v_y, post_omega, plate_v_x,
    plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y,
    rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega, drum_v_x, drum_v_y, drum_omega] = *state;
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t0 = (R::literal(0.00012) * (rod_omega * rod_omega))
        .add_product(R::literal(0.00018), cylinder_omega * cylinder_omega)
        .add_product(R::literal(0.0006), drum_omega * drum_omega)
        .add_product(R::literal(0.00065), bobbin_omega * bobbin_omega)
        .add_product(R::literal(0.00125), plate_omega * plate_omega)
        .add_product(R::literal(0.00135), post_omega * post_omega)
        .add_product(R::literal(0.1), (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y))
        .add_product(
            R::literal(0.15),
            (cylinder_v_x * cylinder_v_x).add_product(cylinder_v_y, cylinder_v_y),
        )
        .add_product(
            R::literal(0.4),
            (post_v_x * post_v_x).add_product(post_v_y, post_v_y),
        );
    Energy {
        kinetic: t0
            .add_product(
                R::literal(0.5) * p.bobbin_mass,
                (bobbin_v_x * bobbin_v_x).add_product(bobbin_v_y, bobbin_v_y),
            )
            .add_product(
                R::literal(0.6),
                (plate_v_x * plate_v_x).add_product(plate_v_y, plate_v_y),
            )
            .add_product(
                R::literal(0.75),
                (drum_v_x * drum_v_x).add_product(drum_v_y, drum_v_y),
            ),
        potential: (R::literal(1.962) * rod_y)
            .add_product(
                R::literal(0.5) * p.spring_stiffness,
                slide_minus_spring_free_length * slide_minus_spring_free_length,
            )
            .add_product(R::literal(2.943), cylinder_y)
            .add_product(R::literal(7.848), post_y)
            .add_product(R::literal(9.81) * p.bobbin_mass, bobbin_y)
            .add_product(R::literal(11.772), plate_y)
            .add_product(R::literal(14.715), drum_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 110 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x,
    bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, _, _, drum_v_y, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let t0 = ((rod_y - cylinder_y) * m.cos_cylinder_phi)
        .sub_product(rod_x - cylinder_x, m.sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * m.cos_cylinder_phi)
        .add_product(cylinder_omega, t0)
        .add_product(rod_v_y - cylinder_v_y, m.sin_cylinder_phi);
    let t1 = p.spring_stiffness * (m.slide - p.spring_free_length);
    let t2 = t1 * m.cos_cylinder_phi;
    let t3 = t1 * m.sin_cylinder_phi;
    let t4 = (R::literal(7.848) * post_v_y)
        .add_product(R::literal(11.772), plate_v_y)
        .sub_product(t2, cylinder_v_x)
        .add_product(R::literal(2.943) - t3, cylinder_v_y)
        .add_product(t1 * t0, cylinder_omega)
        .add_product(t2, rod_v_x)
        .add_product(R::literal(1.962) + t3, rod_v_y)
        .add_product(R::literal(9.81) * p.bobbin_mass, bobbin_v_y)
        .add_product(R::literal(14.715), drum_v_y)
        .add_product(R::literal(0.8) * post_v_x, m.post_v_x_dot)
        .sub_product(R::literal(0.8) * post_v_y, m.t112)
        .sub_product(R::literal(0.0027) * post_omega, m.t109)
        .add_product(R::literal(1.2) * plate_v_x, m.plate_v_x_dot)
        .add_product(R::literal(1.2) * plate_v_y, m.plate_v_y_dot);
    PowerBalance {
        stored_rate: t4
            .add_product(R::literal(0.0025) * plate_omega, m.plate_omega_dot)
            .add_product(R::literal(0.3) * cylinder_v_x, m.cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, m.cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, m.cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot)
            .add_product(R::literal(0.2) * rod_v_y, m.rod_v_y_dot)
            .add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
            .add_product(p.bobbin_mass * bobbin_v_x, m.bobbin_v_x_dot)
            .add_product(p.bobbin_mass * bobbin_v_y, m.bobbin_v_y_dot),
        supplied: (p.winding_force * bobbin_v_y * (bobbin_x - drum_x) / m.between)
            .sub_product(p.bobbin_radius * p.winding_force, plate_omega)
            - p.winding_force * bobbin_v_x * (bobbin_y - drum_y) / m.between,
        dissipated: (R::literal(50.0) * cylinder_omega * slide_rate * t0)
            .add_product(R::literal(50.0) * rod_v_x * slide_rate, m.cos_cylinder_phi)
            .add_product(R::literal(50.0) * rod_v_y * slide_rate, m.sin_cylinder_phi)
            .sub_product(
                R::literal(50.0) * cylinder_v_x * slide_rate,
                m.cos_cylinder_phi,
            )
            .sub_product(
                R::literal(50.0) * cylinder_v_y * slide_rate,
                m.sin_cylinder_phi,
            ),
    }
}

/// `g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.
///
/// 62 operations.
#[must_use]
pub fn constraint_values<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [post_x, post_y, post_phi, plate_x, plate_y, plate_phi, cylinder_x, cylinder_y,
    cylinder_phi, rod_x, rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.1) * cos_post_phi;
    let post_start_x = post_x - t0;
    let t1 = R::literal(0.1) * sin_post_phi;
    let post_start_y = post_y - t1;
    let post_end_x = post_x + t0;
    let post_end_y = post_y + t1;
    let t2 = R::literal(0.06) * cos_plate_phi;
    let plate_start_x = plate_x - t2;
    let t3 = R::literal(0.06) * sin_plate_phi;
    let plate_start_y = plate_y - t3;
    let plate_end_x = plate_x + t2;
    let plate_end_y = plate_y + t3;
    let cylinder_start_x = cylinder_x.sub_product(R::literal(0.06), cos_cylinder_phi);
    let cylinder_start_y = cylinder_y.sub_product(R::literal(0.06), sin_cylinder_phi);
    let rod_end_x = rod_x.add_product(R::literal(0.06), cos_rod_phi);
    let rod_end_y = rod_y.add_product(R::literal(0.06), sin_rod_phi);
    let axle_x = plate_x
        .add_product(R::literal(0.1), sin_plate_phi)
        .sub_product(R::literal(0.01), cos_plate_phi);
    let axle_y = plate_y
        .sub_product(R::literal(0.1), cos_plate_phi)
        .sub_product(R::literal(0.01), sin_plate_phi);
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y)
        .sqrt();
    let slide_across_value = ((rod_y - cylinder_y) * cos_cylinder_phi)
        .sub_product(rod_x - cylinder_x, sin_cylinder_phi);
    let stop_value = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let pin_c_x_value = plate_start_x - post_end_x;
    let pin_c_y_value = plate_start_y - post_end_y;
    let pin_d_x_value = cylinder_start_x - plate_end_x;
    let pin_d_y_value = cylinder_start_y - plate_end_y;
    let slide_angle_value = rod_phi - cylinder_phi;
    let pin_e_y_value = rod_end_y - R::literal(0.28);
    let axle_a_x_value = bobbin_x - axle_x;
    let axle_a_y_value = bobbin_y - axle_y;
    let axle_b_x_value = drum_x - R::literal(0.328);
    let axle_b_y_value = drum_y - R::literal(0.058);
    let contact_value = between - R::literal(0.04) - p.bobbin_radius;
    [
        post_start_x,
        post_start_y,
        pin_c_x_value,
        pin_c_y_value,
        pin_d_x_value,
        pin_d_y_value,
        slide_angle_value,
        slide_across_value,
        rod_end_x,
        pin_e_y_value,
        axle_a_x_value,
        axle_a_y_value,
        axle_b_x_value,
        axle_b_y_value,
        contact_value,
        stop_value,
    ]
}

/// `g'`, zero on the constraints too.
///
/// 89 operations.
#[must_use]
pub fn constraint_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x,
    drum_v_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y)
        .sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t0 = R::literal(0.1) * post_omega;
    let t1 = t0 * sin_post_phi;
    let pin_o_x_rate = post_v_x + t1;
    let t2 = t0 * cos_post_phi;
    let pin_o_y_rate = post_v_y - t2;
    let t3 = R::literal(0.06) * plate_omega;
    let t4 = t3 * sin_plate_phi;
    let pin_c_x_rate = plate_v_x + t4 + t1 - post_v_x;
    let t5 = t3 * cos_plate_phi;
    let pin_c_y_rate = plate_v_y - post_v_y - t2 - t5;
    let t6 = R::literal(0.06) * cylinder_omega;
    let pin_d_x_rate = (cylinder_v_x + t4).add_product(t6, sin_cylinder_phi) - plate_v_x;
    let pin_d_y_rate = (cylinder_v_y - plate_v_y - t5).sub_product(t6, cos_cylinder_phi);
    let slide_angle_rate = rod_omega - cylinder_omega;
    let slide_across_rate = (cylinder_v_x * sin_cylinder_phi)
        .add_product(rod_v_y, cos_cylinder_phi)
        .sub_product(cylinder_v_y, cos_cylinder_phi)
        .sub_product(cylinder_omega, slide)
        .sub_product(rod_v_x, sin_cylinder_phi);
    let t7 = R::literal(0.06) * rod_omega;
    let pin_e_x_rate = rod_v_x.sub_product(t7, sin_rod_phi);
    let pin_e_y_rate = rod_v_y.add_product(t7, cos_rod_phi);
    let axle_a_x_rate = (bobbin_v_x - plate_v_x)
        .sub_product(
            plate_omega,
            (R::literal(0.01) * sin_plate_phi)
                .add_product(R::literal(0.1), cos_plate_phi),
        );
    let axle_a_y_rate = (bobbin_v_y - plate_v_y)
        .sub_product(
            plate_omega,
            (R::literal(0.1) * sin_plate_phi)
                .sub_product(R::literal(0.01), cos_plate_phi),
        );
    let contact_rate = (bobbin_x * bobbin_v_x)
        .add_product(bobbin_y, bobbin_v_y)
        .add_product(drum_x, drum_v_x)
        .add_product(drum_y, drum_v_y)
        .sub_product(bobbin_x, drum_v_x)
        .sub_product(bobbin_y, drum_v_y)
        .sub_product(drum_x, bobbin_v_x)
        .sub_product(drum_y, bobbin_v_y) / between;
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi)
            .add_product(R::literal(0.143), cos_post_phi);
    [
        pin_o_x_rate,
        pin_o_y_rate,
        pin_c_x_rate,
        pin_c_y_rate,
        pin_d_x_rate,
        pin_d_y_rate,
        slide_angle_rate,
        slide_across_rate,
        pin_e_x_rate,
        pin_e_y_rate,
        axle_a_x_rate,
        axle_a_y_rate,
        drum_v_x,
        drum_v_y,
        contact_rate,
        stop_rate,
    ]
}

/// `G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.
///
/// 48 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 44] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, ..] = *state;
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.1) * sin_post_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x)
        .add_product(bobbin_y_minus_drum_y, bobbin_y_minus_drum_y)
        .sqrt();
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t2 = -(R::literal(0.1) * cos_post_phi);
    let t3 = -(R::literal(0.06) * cos_plate_phi);
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    [
        R::literal(1.0),
        t0,
        R::literal(1.0),
        t2,
        R::literal(-1.0),
        t0,
        R::literal(1.0),
        t1,
        R::literal(-1.0),
        t2,
        R::literal(1.0),
        t3,
        R::literal(-1.0),
        t1,
        R::literal(1.0),
        R::literal(0.06) * sin_cylinder_phi,
        R::literal(-1.0),
        t3,
        R::literal(1.0),
        -(R::literal(0.06) * cos_cylinder_phi),
        R::literal(-1.0),
        R::literal(1.0),
        sin_cylinder_phi,
        -cos_cylinder_phi,
        -slide,
        -sin_cylinder_phi,
        cos_cylinder_phi,
        R::literal(1.0),
        -(R::literal(0.06) * sin_rod_phi),
        R::literal(1.0),
        R::literal(0.06) * cos_rod_phi,
        R::literal(-1.0),
        -(R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi),
        R::literal(1.0),
        R::literal(-1.0),
        (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        bobbin_x_minus_drum_x_over_between,
        bobbin_y_minus_drum_y_over_between,
        -bobbin_x_minus_drum_x_over_between,
        -bobbin_y_minus_drum_y_over_between,
        (R::literal(0.044) * sin_post_phi).add_product(R::literal(0.143), cos_post_phi),
    ]
}

impl Describe for WinderLinkage {
    fn name(&self) -> &'static str {
        "winder_linkage"
    }
    fn title(&self) -> &'static str {
        "Four-link bobbin holder, at work"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 18,
            first_order: 0,
            quadratures: 0,
            parameters: PARAMETERS,
            outputs: OUTPUTS,
            discontinuities: DISCONTINUITIES,
        }
    }
    fn state(&self, index: usize) -> Quantity<'_> {
        STATE_QUANTITIES[index]
    }
    fn state_scale(&self, index: usize) -> f64 {
        STATE_SCALES[index]
    }
    fn parameter(&self, index: usize) -> Quantity<'_> {
        PARAMETER_QUANTITIES[index]
    }
    fn parameter_default(&self, index: usize) -> f64 {
        PARAMETER_DEFAULTS[index]
    }
    fn output(&self, index: usize) -> Quantity<'_> {
        OUTPUT_QUANTITIES[index]
    }
    fn rate_jacobian_pattern(&self) -> SparsityPattern<'_> {
        RATE_JACOBIAN_PATTERN
    }
    fn parameter_jacobian_pattern(&self) -> SparsityPattern<'_> {
        PARAMETER_JACOBIAN_PATTERN
    }
    fn mass_matrix_pattern(&self) -> SparsityPattern<'_> {
        MASS_MATRIX_PATTERN
    }
    fn run_defaults(&self) -> RunDefaults<'_> {
        RUN_DEFAULTS
    }
    fn constraints(&self) -> usize {
        CONSTRAINTS
    }
    fn constraint(&self, index: usize) -> Constraint<'_> {
        CONSTRAINT_SHAPES[index]
    }
    fn constraint_matrix_pattern(&self) -> SparsityPattern<'_> {
        CONSTRAINT_MATRIX_PATTERN
    }
    fn is_given(&self, index: usize) -> bool {
        matches!(index, 32 | 35)
    }
}

impl<R: Real> Simulator<R> for WinderLinkage {
    fn constants(&self) -> usize {
        CONSTANTS
    }
    fn prepare(&self, parameters: &[R], constants: &mut [R]) {
        *array_of(constants) = prepare(&parameters_of(parameters)).to_array();
    }
    fn prepared_rate(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate(time, state_of(state), &p, &c);
    }
    fn prepared_rate_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        constants: &[R],
        values: &mut [R],
    ) {
        let (p, c) = (parameters_of(parameters), constants_of(constants));
        *array_of(values) = prepared_rate_jacobian(time, state_of(state), &p, &c);
    }
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = initial_state(&parameters_of(parameters));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        *array_of(values) = discontinuities(&parameters_of(parameters));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate(time, state_of(state), &parameters_of(parameters));
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = rate_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = time_derivative(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = mass_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = forcing(time, state_of(state), &parameters_of(parameters));
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = outputs(time, state_of(state), &parameters_of(parameters))
            .to_array();
    }
    fn energy(&self, time: R, state: &[R], parameters: &[R]) -> Energy<R> {
        energy(time, state_of(state), &parameters_of(parameters))
    }
    fn power_balance(&self, time: R, state: &[R], parameters: &[R]) -> PowerBalance<R> {
        power_balance(time, state_of(state), &parameters_of(parameters))
    }
    fn constraint_values(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_values(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_rates(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn constraint_matrix(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        *array_of(values) = constraint_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
}

#[inline]
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
}

#[inline]
fn array_of<R, const N: usize>(values: &mut [R]) -> &mut [R; N] {
    values.try_into().expect("there is one place for each value")
}

#[inline]
fn state_of<R>(state: &[R]) -> &[R; STATES] {
    state.try_into().expect("the state has STATES entries")
}

#[inline]
fn parameters_of<R: Real>(parameters: &[R]) -> Parameters<R> {
    let values: &[R; PARAMETERS] = parameters
        .try_into()
        .expect("there are PARAMETERS parameters");
    Parameters::from_array(*values)
}

static STATE_QUANTITIES: [Quantity<'static>; STATES] = [
    Quantity {
        name: "post.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "post.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "post.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "plate.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "plate.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "plate.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "cylinder.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "cylinder.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "cylinder.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "rod.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "rod.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "rod.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "bobbin.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "bobbin.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "bobbin.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "drum.x",
        unit: "m",
        doc: "centre of mass, sideways",
    },
    Quantity {
        name: "drum.y",
        unit: "m",
        doc: "centre of mass, upwards",
    },
    Quantity {
        name: "drum.phi",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "post.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "post.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "post.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "plate.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "plate.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "plate.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "cylinder.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "cylinder.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "cylinder.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "rod.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "rod.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "rod.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "bobbin.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "bobbin.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "bobbin.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
    Quantity {
        name: "drum.v_x",
        unit: "m/s",
        doc: "rate of centre of mass, sideways",
    },
    Quantity {
        name: "drum.v_y",
        unit: "m/s",
        doc: "rate of centre of mass, upwards",
    },
    Quantity {
        name: "drum.omega",
        unit: "rad/s",
        doc: "rate of angle of the bar from sideways",
    },
];

static STATE_SCALES: [f64; STATES] = [
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    0.1,
    0.1,
    1.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
    1.0,
    1.0,
    10.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "bobbin_radius",
        unit: "m",
        doc: "radius of the package on the bobbin",
    },
    Quantity {
        name: "winding_force",
        unit: "N",
        doc: "force of the drum on the bobbin along its surface, to the left over the drum",
    },
    Quantity {
        name: "bobbin.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "spring.stiffness",
        unit: "N/m",
        doc: "spring",
    },
    Quantity {
        name: "spring.free_length",
        unit: "m",
        doc: "distance at which the spring is at rest",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [0.06, 0.0, 0.7, 2000.0, 0.116];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "contact_force",
        unit: "N",
        doc: "N, force of the drum on the bobbin at K",
    },
    Quantity {
        name: "stop_force",
        unit: "N",
        doc: "Q, force of the stop on the post at T",
    },
    Quantity {
        name: "strut_push",
        unit: "N",
        doc: "force with which it pushes its ends apart",
    },
    Quantity {
        name: "post_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "plate_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "bobbin_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
    Quantity {
        name: "drum_angle",
        unit: "rad",
        doc: "angle of the bar from sideways",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 1.0,
    points: 101,
    rtol: 1e-8,
    method: "dop853",
};

/// What coordinates must fulfil.
pub static CONSTRAINT_SHAPES: [Constraint<'static>; CONSTRAINTS] = [
    Constraint {
        name: "pin_o_x",
        unit: "m",
        doc: "pin O in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_o_y",
        unit: "m",
        doc: "pin O in the frame, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_c_x",
        unit: "m",
        doc: "pin C of post and plate, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_c_y",
        unit: "m",
        doc: "pin C of post and plate, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_d_x",
        unit: "m",
        doc: "pin D of plate and cylinder, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_d_y",
        unit: "m",
        doc: "pin D of plate and cylinder, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "slide_angle",
        unit: "1",
        doc: "S: rod and cylinder are parallel",
        is_of_positions: true,
    },
    Constraint {
        name: "slide_across",
        unit: "m",
        doc: "S: and in line",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_e_x",
        unit: "m",
        doc: "pin E in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "pin_e_y",
        unit: "m",
        doc: "pin E in the frame, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "axle_a_x",
        unit: "m",
        doc: "axle A of the bobbin on the plate, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "axle_a_y",
        unit: "m",
        doc: "axle A of the bobbin on the plate, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "axle_b_x",
        unit: "m",
        doc: "axle B of the drum in the frame, sideways",
        is_of_positions: true,
    },
    Constraint {
        name: "axle_b_y",
        unit: "m",
        doc: "axle B of the drum in the frame, upwards",
        is_of_positions: true,
    },
    Constraint {
        name: "contact",
        unit: "m",
        doc: "K: the bobbin touches the drum",
        is_of_positions: true,
    },
    Constraint {
        name: "stop",
        unit: "m",
        doc: "T: the post touches its stop",
        is_of_positions: true,
    },
];

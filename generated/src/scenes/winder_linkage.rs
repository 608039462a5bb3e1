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
//   rate_jacobian           402 of 36 by 36
//   parameter_jacobian       80 of 36 by 5
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                   1010
//   mass_matrix               0
//   forcing                  51
//   rate_jacobian          7667
//   parameter_jacobian     2224
//   time_derivative           0
//   outputs                 804
//   energy                   72
//   power_balance          1103
//   constraint_values        62
//   constraint_rates         84
//   constraint_matrix        48

use crate::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{Lanes, TaylorSeries, order_and_inverse},
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
        (0, 0),
        (1, 1),
        (2, 2),
        (3, 3),
        (4, 4),
        (5, 5),
        (6, 6),
        (7, 7),
        (8, 8),
        (9, 9),
        (10, 10),
        (11, 11),
        (12, 12),
        (13, 13),
        (14, 14),
        (15, 15),
        (16, 16),
        (17, 17),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 36,
    columns: 36,
    entries: &[
        (0, 18),
        (1, 19),
        (2, 20),
        (3, 21),
        (4, 22),
        (5, 23),
        (6, 24),
        (7, 25),
        (8, 26),
        (9, 27),
        (10, 28),
        (11, 29),
        (12, 30),
        (13, 31),
        (14, 32),
        (15, 33),
        (16, 34),
        (17, 35),
        (18, 2),
        (18, 5),
        (18, 6),
        (18, 7),
        (18, 8),
        (18, 9),
        (18, 10),
        (18, 11),
        (18, 12),
        (18, 13),
        (18, 15),
        (18, 16),
        (18, 20),
        (18, 23),
        (18, 24),
        (18, 25),
        (18, 26),
        (18, 27),
        (18, 28),
        (18, 29),
        (18, 30),
        (18, 31),
        (18, 33),
        (18, 34),
        (19, 2),
        (19, 5),
        (19, 6),
        (19, 7),
        (19, 8),
        (19, 9),
        (19, 10),
        (19, 11),
        (19, 12),
        (19, 13),
        (19, 15),
        (19, 16),
        (19, 20),
        (19, 23),
        (19, 24),
        (19, 25),
        (19, 26),
        (19, 27),
        (19, 28),
        (19, 29),
        (19, 30),
        (19, 31),
        (19, 33),
        (19, 34),
        (20, 2),
        (20, 5),
        (20, 6),
        (20, 7),
        (20, 8),
        (20, 9),
        (20, 10),
        (20, 11),
        (20, 12),
        (20, 13),
        (20, 15),
        (20, 16),
        (20, 20),
        (20, 23),
        (20, 24),
        (20, 25),
        (20, 26),
        (20, 27),
        (20, 28),
        (20, 29),
        (20, 30),
        (20, 31),
        (20, 33),
        (20, 34),
        (21, 2),
        (21, 5),
        (21, 6),
        (21, 7),
        (21, 8),
        (21, 9),
        (21, 10),
        (21, 11),
        (21, 12),
        (21, 13),
        (21, 15),
        (21, 16),
        (21, 20),
        (21, 23),
        (21, 24),
        (21, 25),
        (21, 26),
        (21, 27),
        (21, 28),
        (21, 29),
        (21, 30),
        (21, 31),
        (21, 33),
        (21, 34),
        (22, 2),
        (22, 5),
        (22, 6),
        (22, 7),
        (22, 8),
        (22, 9),
        (22, 10),
        (22, 11),
        (22, 12),
        (22, 13),
        (22, 15),
        (22, 16),
        (22, 20),
        (22, 23),
        (22, 24),
        (22, 25),
        (22, 26),
        (22, 27),
        (22, 28),
        (22, 29),
        (22, 30),
        (22, 31),
        (22, 33),
        (22, 34),
        (23, 2),
        (23, 5),
        (23, 6),
        (23, 7),
        (23, 8),
        (23, 9),
        (23, 10),
        (23, 11),
        (23, 12),
        (23, 13),
        (23, 15),
        (23, 16),
        (23, 20),
        (23, 23),
        (23, 24),
        (23, 25),
        (23, 26),
        (23, 27),
        (23, 28),
        (23, 29),
        (23, 30),
        (23, 31),
        (23, 33),
        (23, 34),
        (24, 2),
        (24, 5),
        (24, 6),
        (24, 7),
        (24, 8),
        (24, 9),
        (24, 10),
        (24, 11),
        (24, 12),
        (24, 13),
        (24, 15),
        (24, 16),
        (24, 20),
        (24, 23),
        (24, 24),
        (24, 25),
        (24, 26),
        (24, 27),
        (24, 28),
        (24, 29),
        (24, 30),
        (24, 31),
        (24, 33),
        (24, 34),
        (25, 2),
        (25, 5),
        (25, 6),
        (25, 7),
        (25, 8),
        (25, 9),
        (25, 10),
        (25, 11),
        (25, 12),
        (25, 13),
        (25, 15),
        (25, 16),
        (25, 20),
        (25, 23),
        (25, 24),
        (25, 25),
        (25, 26),
        (25, 27),
        (25, 28),
        (25, 29),
        (25, 30),
        (25, 31),
        (25, 33),
        (25, 34),
        (26, 2),
        (26, 5),
        (26, 6),
        (26, 7),
        (26, 8),
        (26, 9),
        (26, 10),
        (26, 11),
        (26, 12),
        (26, 13),
        (26, 15),
        (26, 16),
        (26, 20),
        (26, 23),
        (26, 24),
        (26, 25),
        (26, 26),
        (26, 27),
        (26, 28),
        (26, 29),
        (26, 30),
        (26, 31),
        (26, 33),
        (26, 34),
        (27, 2),
        (27, 5),
        (27, 6),
        (27, 7),
        (27, 8),
        (27, 9),
        (27, 10),
        (27, 11),
        (27, 12),
        (27, 13),
        (27, 15),
        (27, 16),
        (27, 20),
        (27, 23),
        (27, 24),
        (27, 25),
        (27, 26),
        (27, 27),
        (27, 28),
        (27, 29),
        (27, 30),
        (27, 31),
        (27, 33),
        (27, 34),
        (28, 2),
        (28, 5),
        (28, 6),
        (28, 7),
        (28, 8),
        (28, 9),
        (28, 10),
        (28, 11),
        (28, 12),
        (28, 13),
        (28, 15),
        (28, 16),
        (28, 20),
        (28, 23),
        (28, 24),
        (28, 25),
        (28, 26),
        (28, 27),
        (28, 28),
        (28, 29),
        (28, 30),
        (28, 31),
        (28, 33),
        (28, 34),
        (29, 2),
        (29, 5),
        (29, 6),
        (29, 7),
        (29, 8),
        (29, 9),
        (29, 10),
        (29, 11),
        (29, 12),
        (29, 13),
        (29, 15),
        (29, 16),
        (29, 20),
        (29, 23),
        (29, 24),
        (29, 25),
        (29, 26),
        (29, 27),
        (29, 28),
        (29, 29),
        (29, 30),
        (29, 31),
        (29, 33),
        (29, 34),
        (30, 2),
        (30, 5),
        (30, 6),
        (30, 7),
        (30, 8),
        (30, 9),
        (30, 10),
        (30, 11),
        (30, 12),
        (30, 13),
        (30, 15),
        (30, 16),
        (30, 20),
        (30, 23),
        (30, 24),
        (30, 25),
        (30, 26),
        (30, 27),
        (30, 28),
        (30, 29),
        (30, 30),
        (30, 31),
        (30, 33),
        (30, 34),
        (31, 2),
        (31, 5),
        (31, 6),
        (31, 7),
        (31, 8),
        (31, 9),
        (31, 10),
        (31, 11),
        (31, 12),
        (31, 13),
        (31, 15),
        (31, 16),
        (31, 20),
        (31, 23),
        (31, 24),
        (31, 25),
        (31, 26),
        (31, 27),
        (31, 28),
        (31, 29),
        (31, 30),
        (31, 31),
        (31, 33),
        (31, 34),
        (33, 2),
        (33, 5),
        (33, 6),
        (33, 7),
        (33, 8),
        (33, 9),
        (33, 10),
        (33, 11),
        (33, 12),
        (33, 13),
        (33, 15),
        (33, 16),
        (33, 20),
        (33, 23),
        (33, 24),
        (33, 25),
        (33, 26),
        (33, 27),
        (33, 28),
        (33, 29),
        (33, 30),
        (33, 31),
        (33, 33),
        (33, 34),
        (34, 2),
        (34, 5),
        (34, 6),
        (34, 7),
        (34, 8),
        (34, 9),
        (34, 10),
        (34, 11),
        (34, 12),
        (34, 13),
        (34, 15),
        (34, 16),
        (34, 20),
        (34, 23),
        (34, 24),
        (34, 25),
        (34, 26),
        (34, 27),
        (34, 28),
        (34, 29),
        (34, 30),
        (34, 31),
        (34, 33),
        (34, 34),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 36,
    columns: 5,
    entries: &[
        (18, 0),
        (18, 1),
        (18, 2),
        (18, 3),
        (18, 4),
        (19, 0),
        (19, 1),
        (19, 2),
        (19, 3),
        (19, 4),
        (20, 0),
        (20, 1),
        (20, 2),
        (20, 3),
        (20, 4),
        (21, 0),
        (21, 1),
        (21, 2),
        (21, 3),
        (21, 4),
        (22, 0),
        (22, 1),
        (22, 2),
        (22, 3),
        (22, 4),
        (23, 0),
        (23, 1),
        (23, 2),
        (23, 3),
        (23, 4),
        (24, 0),
        (24, 1),
        (24, 2),
        (24, 3),
        (24, 4),
        (25, 0),
        (25, 1),
        (25, 2),
        (25, 3),
        (25, 4),
        (26, 0),
        (26, 1),
        (26, 2),
        (26, 3),
        (26, 4),
        (27, 0),
        (27, 1),
        (27, 2),
        (27, 3),
        (27, 4),
        (28, 0),
        (28, 1),
        (28, 2),
        (28, 3),
        (28, 4),
        (29, 0),
        (29, 1),
        (29, 2),
        (29, 3),
        (29, 4),
        (30, 0),
        (30, 1),
        (30, 2),
        (30, 3),
        (30, 4),
        (31, 0),
        (31, 1),
        (31, 2),
        (31, 3),
        (31, 4),
        (33, 0),
        (33, 1),
        (33, 2),
        (33, 3),
        (33, 4),
        (34, 0),
        (34, 1),
        (34, 2),
        (34, 3),
        (34, 4),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 16;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 18,
    entries: &[
        (0, 0),
        (0, 2),
        (1, 1),
        (1, 2),
        (2, 0),
        (2, 2),
        (2, 3),
        (2, 5),
        (3, 1),
        (3, 2),
        (3, 4),
        (3, 5),
        (4, 3),
        (4, 5),
        (4, 6),
        (4, 8),
        (5, 4),
        (5, 5),
        (5, 7),
        (5, 8),
        (6, 8),
        (6, 11),
        (7, 6),
        (7, 7),
        (7, 8),
        (7, 9),
        (7, 10),
        (8, 9),
        (8, 11),
        (9, 10),
        (9, 11),
        (10, 3),
        (10, 5),
        (10, 12),
        (11, 4),
        (11, 5),
        (11, 13),
        (12, 15),
        (13, 16),
        (14, 12),
        (14, 13),
        (14, 15),
        (14, 16),
        (15, 2),
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
/// 1010 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega,
    drum_v_x, drum_v_y, drum_omega] = *state;
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let cos_rod_phi = rod_phi.cos();
    let t6 = R::literal(0.06) * cos_rod_phi;
    let sin_rod_phi = rod_phi.sin();
    let t7 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t8 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t8 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let t9 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let t10 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = t1 * R::literal(370.370_370_370_370_3);
    let t13 = t0 * R::literal(370.370_370_370_370_3);
    let t14 = t9 * R::literal(370.370_370_370_370_3);
    let t15 = t3 * R::literal(400.0);
    let t16 = t2 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = t5 * R::literal(2_777.777_777_777_778);
    let t22 = t4 * R::literal(2_777.777_777_777_778);
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = t7 * R::literal(4_166.666_666_666_667);
    let t27 = t6 * R::literal(4_166.666_666_666_667);
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(-1.25) - t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(-1.25) - t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t42 - t43);
    let t45 = t12 * t0 - t38 * t35;
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = t14 * t0 + t40 * t35;
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51 - t38 * t37 - t46 * t45);
    let t53 = t16 * t3;
    let t54 = t35 + t53 - t36 * t37 - t48 * t45;
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t40 * t37 - t39 - t50 * t45;
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43 - t48 * t47
            - t55 * t54);
    let t68 = t15 * t2 - t57 * t54;
    let t69 = t68 * t67;
    let t70 = R::literal(0.833_333_333_333_333_4) - t66 - t58 * t54;
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72 - t61 * t54;
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = R::literal(0.833_333_333_333_333_4) + t75 + t63 * t54;
    let t77 = t76 * t67;
    let t78 = t49 - t50 * t47 - t65 * t54;
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5) - t21 * t5 - t57 * t56 - t69 * t68);
    let t81 = t53 + t22 * t5 - t58 * t56 - t71 * t68;
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = t23 * t5 - t19;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t59 - t61 * t56 - t74 * t68;
    let t88 = t87 * t80;
    let t89 = t63 * t56 - t62 - t77 * t68;
    let t90 = t89 * t80;
    let t91 = -(t65 * t56) - t79 * t68;
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5) - t22 * t4 - t58 * t53 - t71 * t70
            - t82 * t81);
    let t94 = R::literal(-2_777.777_777_777_778) * t4 + t84 * t81;
    let t95 = t94 * t93;
    let t96 = t20 - t23 * t4 - t86 * t81;
    let t97 = t96 * t93;
    let t98 = t72 - t61 * t53 - t74 * t70 - t88 * t81;
    let t99 = t98 * t93;
    let t100 = R::literal(-0.833_333_333_333_333_4) + t75 + t63 * t53 - t77 * t70
        - t90 * t81;
    let t101 = t100 * t93;
    let t102 = -(t65 * t53) - t79 * t70 - t92 * t81;
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t84 * t83 - t95 * t94);
    let t105 = t86 * t83 - t23 - t97 * t94;
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = t88 * t83 - t99 * t94;
    let t110 = t109 * t104;
    let t111 = t90 * t83 - t101 * t94;
    let t112 = t111 * t104;
    let t113 = t92 * t83 - t103 * t94;
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi) - t20 * cos_cylinder_phi - t23 * slide
            - t24 * sin_cylinder_phi - t25 * cos_cylinder_phi - t86 * t85 - t97 * t96
            - t106 * t105);
    let t116 = t24 - t107 * t105;
    let t117 = t116 * t115;
    let t118 = t108 * t105 - t25;
    let t119 = t118 * t115;
    let t120 = -(t88 * t85) - t99 * t96 - t110 * t105;
    let t121 = t120 * t115;
    let t122 = -(t90 * t85) - t101 * t96 - t112 * t105;
    let t123 = t122 * t115;
    let t124 = -(t92 * t85) - t103 * t96 - t114 * t105;
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / (R::literal(-5.0) - t26 * t7 - t107 * t26 - t117 * t116);
    let t127 = t27 * t7 + t108 * t26 - t119 * t116;
    let t128 = t127 * t126;
    let t129 = -(t110 * t26) - t121 * t116;
    let t130 = t129 * t126;
    let t131 = -(t112 * t26) - t123 * t116;
    let t132 = t131 * t126;
    let t133 = -(t114 * t26) - t125 * t116;
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / (R::literal(-5.0) - t27 * t6 - t108 * t27 - t119 * t118 - t128 * t127);
    let t136 = t110 * t27 - t121 * t118 - t130 * t127;
    let t137 = t136 * t135;
    let t138 = t112 * t27 - t123 * t118 - t132 * t127;
    let t139 = t138 * t135;
    let t140 = t114 * t27 - t125 * t118 - t134 * t127;
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t10 - inverse_bobbin_mass
            - t61 * t60 - t74 * t73 - t88 * t87 - t99 * t98 - t110 * t109 - t121 * t120
            - t130 * t129 - t137 * t136);
    let t143 = t18 * t10 + t63 * t60 - t77 * t73 - t90 * t87 - t101 * t98 - t112 * t109
        - t123 * t120 - t132 * t129 - t139 * t136;
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = -(t65 * t60) - t79 * t73 - t92 * t87 - t103 * t98 - t114 * t109
        - t125 * t120 - t134 * t129 - t141 * t136;
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t11 - inverse_bobbin_mass
            - t63 * t62 - t77 * t76 - t90 * t89 - t101 * t100 - t112 * t111 - t123 * t122
            - t132 * t131 - t139 * t138 - t144 * t143);
    let t149 = t145 * t143 - t29;
    let t150 = t149 * t148;
    let t151 = t65 * t62 - t79 * t76 - t92 * t89 - t103 * t100 - t114 * t111
        - t125 * t122 - t134 * t131 - t141 * t138 - t147 * t143;
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between)
            - t29 * bobbin_y_minus_drum_y_over_between
            - t30 * bobbin_x_minus_drum_x_over_between
            - t31 * bobbin_y_minus_drum_y_over_between - t145 * t28 - t150 * t149
            - t153 * t30 - t154 * t31);
    let t156 = t147 * t28 - t152 * t149;
    let t157 = t156 * t155;
    let t158 = -(t14 * t9) - t40 * t39 - t50 * t49 - t65 * t64 - t79 * t78 - t92 * t91
        - t103 * t102 - t114 * t113 - t125 * t124 - t134 * t133 - t141 * t140
        - t147 * t146;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t159 = R::literal(50.0) * slide_rate;
    let t160 = t159 * cos_cylinder_phi;
    let t161 = p.spring_stiffness * (slide - p.spring_free_length);
    let t162 = t161 * cos_cylinder_phi;
    let t163 = t160 + t162;
    let t164 = t161 * sin_cylinder_phi;
    let t165 = t159 * sin_cylinder_phi;
    let t166 = t165 - (R::literal(2.943) - t164);
    let t167 = -(t159 * t8) - t161 * t8;
    let t168 = -t160 - t162;
    let t169 = -t165 - (R::literal(1.962) + t164);
    let t170 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t171 = p.winding_force * bobbin_x_minus_drum_x / between
        - R::literal(9.81) * p.bobbin_mass;
    let post_omega_squared = post_omega * post_omega;
    let t172 = R::literal(0.1) * post_omega_squared;
    let t173 = t172 * cos_post_phi;
    let t174 = t172 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t175 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t176 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t177 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t178 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t179 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t180 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t181 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t182 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t183 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t184 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t185 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t186 = bobbin_v_x
        * (bobbin_v_x_over_between + t180 + t181 - t178 - t179 - drum_v_x_over_between)
        + bobbin_v_y
            * (bobbin_v_y_over_between + t184 + t185 - t182 - t183
                - drum_v_y_over_between)
        + drum_v_x
            * (t178 + t179 + drum_v_x_over_between - bobbin_v_x_over_between - t180
                - t181);
    let t187 = t36 * t173;
    let t188 = -t174 - R::literal(-9.81) + t187;
    let t189 = t15 * bobbin_radius_times_winding_force;
    let t190 = t189 - (t175 * cos_plate_phi + t173) + t38 * t173 - t46 * t188;
    let t191 = t16 * bobbin_radius_times_winding_force;
    let t192 = -(t175 * sin_plate_phi + t174) - R::literal(9.81) - R::literal(-9.81)
        - t191 + t187 - t48 * t188 - t55 * t190;
    let t193 = R::literal(3.333_333_333_333_333_5) * t163;
    let t194 = t189
        - R::literal(0.06)
            * (plate_omega_squared * cos_plate_phi
                + cylinder_omega_squared * cos_cylinder_phi) - t193 - t21 * t167
        - t57 * t190 - t69 * t192;
    let t195 = R::literal(3.333_333_333_333_333_5) * t166;
    let t196 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t191
        - t195 + t22 * t167 - t58 * t190 - t71 * t192 - t82 * t194;
    let t197 = t84 * t194 - R::literal(-2_777.777_777_777_778) * t167 - t95 * t196;
    let t198 = t176 - t19 * t163 + t20 * t166 + t23 * t167 + t24 * t168 - t25 * t169
        - t86 * t194 - t97 * t196 - t106 * t197;
    let t199 = R::literal(5.0) * t168;
    let t200 = t177 * cos_rod_phi - t199 - t107 * t197 - t117 * t198;
    let t201 = R::literal(5.0) * t169;
    let t202 = t177 * sin_rod_phi - t201 + t108 * t197 - t119 * t198 - t128 * t200;
    let t203 = inverse_bobbin_mass * t170;
    let t204 = t11 * plate_omega_squared - t17 * bobbin_radius_times_winding_force + t203
        - t61 * t190 - t74 * t192 - t88 * t194 - t99 * t196 - t110 * t197 - t121 * t198
        - t130 * t200 - t137 * t202;
    let t205 = inverse_bobbin_mass * t171;
    let t206 = t10 * plate_omega_squared - R::literal(9.81)
        + t18 * bobbin_radius_times_winding_force - t205 + t63 * t190 - t77 * t192
        - t90 * t194 - t101 * t196 - t112 * t197 - t123 * t198 - t132 * t200
        - t139 * t202 - t144 * t204;
    let t207 = t28 * t170
        - (t186
            + drum_v_y
                * (t182 + t183 + drum_v_y_over_between - bobbin_v_y_over_between - t184
                    - t185)) - t29 * t171 + t31 * R::literal(-14.715) + t145 * t204
        - t150 * t206 - t154 * R::literal(9.809_999_999_999_999);
    let t208 = (R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi)
        * post_omega_squared - t40 * t173 - t50 * t188 - t65 * t190 - t79 * t192
        - t92 * t194 - t103 * t196 - t114 * t197 - t125 * t198 - t134 * t200
        - t141 * t202;
    let t209 = (t208 - t147 * t204 - t152 * t206 - t157 * t207)
        * (R::literal(1.0) / (t158 - t152 * t151 - t157 * t156));
    let t210 = t207 * t155 - t157 * t209;
    let axle_b_x = t153 * t210;
    let t211 = t206 * t148 - t150 * t210 - t152 * t209;
    let t212 = t204 * t142 - t144 * t211 + t145 * t210 - t147 * t209;
    let t213 = t202 * t135 - t137 * t212 - t139 * t211 - t141 * t209;
    let t214 = t200 * t126 - t128 * t213 - t130 * t212 - t132 * t211 - t134 * t209;
    let t215 = t198 * t115 - t117 * t214 - t119 * t213 - t121 * t212 - t123 * t211
        - t125 * t209;
    let t216 = t197 * t104 - t106 * t215 - t107 * t214 + t108 * t213 - t110 * t212
        - t112 * t211 - t114 * t209;
    let t217 = t196 * t93 - t95 * t216 - t97 * t215 - t99 * t212 - t101 * t211
        - t103 * t209;
    let t218 = t194 * t80 - t82 * t217 + t84 * t216 - t86 * t215 - t88 * t212
        - t90 * t211 - t92 * t209;
    let t219 = t192 * t67 - t69 * t218 - t71 * t217 - t74 * t212 - t77 * t211
        - t79 * t209;
    let t220 = t190 * t52 - t55 * t219 - t57 * t218 - t58 * t217 - t61 * t212
        + t63 * t211 - t65 * t209;
    let t221 = t188 * t44 - t46 * t220 - t48 * t219 - t50 * t209;
    let t222 = -(t173 * t34) - t36 * t221 - t38 * t220 - t36 * t219 + t40 * t209;
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        - R::literal(0.666_666_666_666_666_6)
            * (R::literal(-14.714_999_999_999_998) - t154 * t210) + t31 * t210;
    let drum_v_x_dot = R::literal(0.666_666_666_666_666_6) * axle_b_x + t30 * t210;
    let bobbin_v_y_dot = t205 - inverse_bobbin_mass * t211 - t29 * t210;
    let bobbin_v_x_dot = -t203 - inverse_bobbin_mass * t212 - t28 * t210;
    let rod_omega_dot = t26 * t214 - R::literal(4_166.666_666_666_667) * t216
        - t27 * t213;
    let rod_v_y_dot = t201 - t25 * t215 - R::literal(5.0) * t213;
    let rod_v_x_dot = t199 + t24 * t215 - R::literal(5.0) * t214;
    let cylinder_omega_dot = t167 * R::literal(2_777.777_777_777_778) - t21 * t218
        + t22 * t217 - R::literal(-2_777.777_777_777_778) * t216 + t23 * t215;
    let cylinder_v_y_dot = t195 - R::literal(3.333_333_333_333_333_5) * t217
        + t20 * t215;
    let cylinder_v_x_dot = t193 - R::literal(3.333_333_333_333_333_5) * t218
        - t19 * t215;
    let plate_omega_dot = -(bobbin_radius_times_winding_force * R::literal(400.0))
        - t15 * t220 + t16 * t219 - t15 * t218 + t16 * t217 + t17 * t212 - t18 * t211;
    let plate_v_y_dot = R::literal(-9.81) - R::literal(0.833_333_333_333_333_4) * t219
        - R::literal(-0.833_333_333_333_333_4) * t217
        - R::literal(-0.833_333_333_333_333_4) * t211;
    let plate_v_x_dot = -(R::literal(0.833_333_333_333_333_4) * t220)
        - R::literal(-0.833_333_333_333_333_4) * t218
        - R::literal(-0.833_333_333_333_333_4) * t212;
    let post_omega_dot = t13 * t221 - t12 * t222 - t12 * t220 + t13 * t219 - t14 * t209;
    let post_v_y_dot = R::literal(-9.81) - R::literal(1.25) * t221
        - R::literal(-1.25) * t219;
    let post_v_x_dot = -(R::literal(1.25) * t222) - R::literal(-1.25) * t220;
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
        drum_v_x_dot,
        drum_v_y_dot,
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
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x
        + bobbin_y_minus_drum_y * bobbin_y_minus_drum_y)
        .sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t0 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t0 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let plate_phi_forcing = -(p.bobbin_radius * p.winding_force);
    let t1 = R::literal(50.0) * slide_rate;
    let t2 = t1 * cos_cylinder_phi;
    let t3 = p.spring_stiffness * (slide - p.spring_free_length);
    let t4 = t3 * cos_cylinder_phi;
    let cylinder_x_forcing = t2 + t4;
    let t5 = t3 * sin_cylinder_phi;
    let t6 = t1 * sin_cylinder_phi;
    let cylinder_y_forcing = t6 - (R::literal(2.943) - t5);
    let cylinder_phi_forcing = -(t1 * t0) - t3 * t0;
    let rod_x_forcing = -t2 - t4;
    let rod_y_forcing = -t6 - (R::literal(1.962) + t5);
    let bobbin_x_forcing = -(p.winding_force * bobbin_y_minus_drum_y / between);
    let bobbin_y_forcing = p.winding_force * bobbin_x_minus_drum_x / between
        - R::literal(9.81) * p.bobbin_mass;
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
/// 7667 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 402] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, _, _, post_omega, _, _,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let cos_rod_phi = rod_phi.cos();
    let t6 = R::literal(0.06) * cos_rod_phi;
    let sin_rod_phi = rod_phi.sin();
    let t7 = R::literal(0.06) * sin_rod_phi;
    let t8 = R::literal(0.01) * cos_plate_phi;
    let t9 = R::literal(0.1) * sin_plate_phi;
    let t10 = R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t12 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t13 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t14 = t13 - t12;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = cylinder_omega * t14 + rod_v_x_minus_cylinder_v_x * cos_cylinder_phi
        + rod_v_y_minus_cylinder_v_y * sin_cylinder_phi;
    let t15 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let t16 = t11 + t10;
    let t17 = t9 - t8;
    let t18 = t8 - t9;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t19 = t1 * R::literal(370.370_370_370_370_3);
    let t20 = t0 * R::literal(370.370_370_370_370_3);
    let t21 = t15 * R::literal(370.370_370_370_370_3);
    let t22 = t3 * R::literal(400.0);
    let t23 = t2 * R::literal(400.0);
    let t24 = t16 * R::literal(400.0);
    let t25 = t18 * R::literal(400.0);
    let t26 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t27 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t28 = t5 * R::literal(2_777.777_777_777_778);
    let t29 = t4 * R::literal(2_777.777_777_777_778);
    let t30 = slide * R::literal(2_777.777_777_777_778);
    let t31 = sin_cylinder_phi * R::literal(5.0);
    let t32 = cos_cylinder_phi * R::literal(5.0);
    let t33 = t7 * R::literal(4_166.666_666_666_667);
    let t34 = t6 * R::literal(4_166.666_666_666_667);
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t35 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t36 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t37 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t38 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t39 = t19 * t1;
    let t40 = R::literal(-1.25) - t39;
    let t41 = R::literal(1.0) / t40;
    let t42 = t20 * t1;
    let t43 = t42 * t41;
    let t44 = R::literal(1.25) - t39;
    let t45 = t44 * t41;
    let t46 = t21 * t1;
    let t47 = t46 * t41;
    let t48 = t20 * t0;
    let t49 = R::literal(-1.25) - t48;
    let t50 = t43 * t42;
    let t51 = R::literal(1.0) / (t49 - t50);
    let t52 = t19 * t0 - t45 * t42;
    let t53 = t52 * t51;
    let t54 = R::literal(1.25) - t48 - t50;
    let t55 = t54 * t51;
    let t56 = t21 * t0 + t47 * t42;
    let t57 = t56 * t51;
    let t58 = t22 * t3;
    let t59 = R::literal(1.0)
        / (t40 - R::literal(0.833_333_333_333_333_4) - t58 - t45 * t44 - t53 * t52);
    let t60 = t23 * t3;
    let t61 = t42 + t60 - t43 * t44 - t55 * t52;
    let t62 = t61 * t59;
    let t63 = R::literal(0.833_333_333_333_333_4) - t58;
    let t64 = t63 * t59;
    let t65 = t60 * t59;
    let t66 = t24 * t3;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66;
    let t68 = t67 * t59;
    let t69 = t25 * t3;
    let t70 = t69 * t59;
    let t71 = t47 * t44 - t46 - t57 * t52;
    let t72 = t71 * t59;
    let t73 = t23 * t2;
    let t74 = R::literal(1.0)
        / (t49 - R::literal(0.833_333_333_333_333_4) - t73 - t50 - t55 * t54
            - t62 * t61);
    let t75 = t22 * t2 - t64 * t61;
    let t76 = t75 * t74;
    let t77 = R::literal(0.833_333_333_333_333_4) - t73 - t65 * t61;
    let t78 = t77 * t74;
    let t79 = -(t24 * t2);
    let t80 = t79 - t68 * t61;
    let t81 = t80 * t74;
    let t82 = t25 * t2;
    let t83 = R::literal(0.833_333_333_333_333_4) + t82 + t70 * t61;
    let t84 = t83 * t74;
    let t85 = t56 - t57 * t54 - t72 * t61;
    let t86 = t85 * t74;
    let t87 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t58
            - R::literal(3.333_333_333_333_333_5) - t28 * t5 - t64 * t63 - t76 * t75);
    let t88 = t60 + t29 * t5 - t65 * t63 - t78 * t75;
    let t89 = t88 * t87;
    let t90 = R::literal(-2_777.777_777_777_778) * t5;
    let t91 = t90 * t87;
    let t92 = t30 * t5 - t26;
    let t93 = t92 * t87;
    let t94 = R::literal(-0.833_333_333_333_333_4) + t66 - t68 * t63 - t81 * t75;
    let t95 = t94 * t87;
    let t96 = t70 * t63 - t69 - t84 * t75;
    let t97 = t96 * t87;
    let t98 = -(t72 * t63) - t86 * t75;
    let t99 = t98 * t87;
    let t100 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t73
            - R::literal(3.333_333_333_333_333_5) - t29 * t4 - t65 * t60 - t78 * t77
            - t89 * t88);
    let t101 = R::literal(-2_777.777_777_777_778) * t4 + t91 * t88;
    let t102 = t101 * t100;
    let t103 = t27 - t30 * t4 - t93 * t88;
    let t104 = t103 * t100;
    let t105 = t79 - t68 * t60 - t81 * t77 - t95 * t88;
    let t106 = t105 * t100;
    let t107 = R::literal(-0.833_333_333_333_333_4) + t82 + t70 * t60 - t84 * t77
        - t97 * t88;
    let t108 = t107 * t100;
    let t109 = -(t72 * t60) - t86 * t77 - t99 * t88;
    let t110 = t109 * t100;
    let t111 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t91 * t90 - t102 * t101);
    let t112 = t93 * t90 - t30 - t104 * t101;
    let t113 = t112 * t111;
    let t114 = t33 * t111;
    let t115 = t34 * t111;
    let t116 = t95 * t90 - t106 * t101;
    let t117 = t116 * t111;
    let t118 = t97 * t90 - t108 * t101;
    let t119 = t118 * t111;
    let t120 = t99 * t90 - t110 * t101;
    let t121 = t120 * t111;
    let t122 = R::literal(1.0)
        / (-(t26 * sin_cylinder_phi) - t27 * cos_cylinder_phi - t30 * slide
            - t31 * sin_cylinder_phi - t32 * cos_cylinder_phi - t93 * t92 - t104 * t103
            - t113 * t112);
    let t123 = t31 - t114 * t112;
    let t124 = t123 * t122;
    let t125 = t115 * t112 - t32;
    let t126 = t125 * t122;
    let t127 = -(t95 * t92) - t106 * t103 - t117 * t112;
    let t128 = t127 * t122;
    let t129 = -(t97 * t92) - t108 * t103 - t119 * t112;
    let t130 = t129 * t122;
    let t131 = -(t99 * t92) - t110 * t103 - t121 * t112;
    let t132 = t131 * t122;
    let t133 = R::literal(1.0)
        / (R::literal(-5.0) - t33 * t7 - t114 * t33 - t124 * t123);
    let t134 = t34 * t7 + t115 * t33 - t126 * t123;
    let t135 = t134 * t133;
    let t136 = -(t117 * t33) - t128 * t123;
    let t137 = t136 * t133;
    let t138 = -(t119 * t33) - t130 * t123;
    let t139 = t138 * t133;
    let t140 = -(t121 * t33) - t132 * t123;
    let t141 = t140 * t133;
    let t142 = R::literal(1.0)
        / (R::literal(-5.0) - t34 * t6 - t115 * t34 - t126 * t125 - t135 * t134);
    let t143 = t117 * t34 - t128 * t125 - t137 * t134;
    let t144 = t143 * t142;
    let t145 = t119 * t34 - t130 * t125 - t139 * t134;
    let t146 = t145 * t142;
    let t147 = t121 * t34 - t132 * t125 - t141 * t134;
    let t148 = t147 * t142;
    let t149 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t24 * t16 - inverse_bobbin_mass
            - t68 * t67 - t81 * t80 - t95 * t94 - t106 * t105 - t117 * t116 - t128 * t127
            - t137 * t136 - t144 * t143);
    let t150 = t25 * t16 + t70 * t67 - t84 * t80 - t97 * t94 - t108 * t105 - t119 * t116
        - t130 * t127 - t139 * t136 - t146 * t143;
    let t151 = t150 * t149;
    let t152 = t35 * t149;
    let t153 = -(t72 * t67) - t86 * t80 - t99 * t94 - t110 * t105 - t121 * t116
        - t132 * t127 - t141 * t136 - t148 * t143;
    let t154 = t153 * t149;
    let t155 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t25 * t18 - inverse_bobbin_mass
            - t70 * t69 - t84 * t83 - t97 * t96 - t108 * t107 - t119 * t118 - t130 * t129
            - t139 * t138 - t146 * t145 - t151 * t150);
    let t156 = t152 * t150 - t36;
    let t157 = t156 * t155;
    let t158 = t72 * t69 - t86 * t83 - t99 * t96 - t110 * t107 - t121 * t118
        - t132 * t129 - t141 * t138 - t148 * t145 - t154 * t150;
    let t159 = t158 * t155;
    let t160 = t37 * R::literal(-1.5);
    let t161 = t38 * R::literal(-1.5);
    let t162 = R::literal(1.0)
        / (-(t35 * bobbin_x_minus_drum_x_over_between)
            - t36 * bobbin_y_minus_drum_y_over_between
            - t37 * bobbin_x_minus_drum_x_over_between
            - t38 * bobbin_y_minus_drum_y_over_between - t152 * t35 - t157 * t156
            - t160 * t37 - t161 * t38);
    let t163 = t154 * t35 - t159 * t156;
    let t164 = t163 * t162;
    let t165 = -(t21 * t15) - t47 * t46 - t57 * t56 - t72 * t71 - t86 * t85 - t99 * t98
        - t110 * t109 - t121 * t120 - t132 * t131 - t141 * t140 - t148 * t147
        - t154 * t153;
    let t166 = R::literal(1.0) / (t165 - t159 * t158 - t164 * t163);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t167 = R::literal(50.0) * slide_rate;
    let t168 = t167 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t169 = p.spring_stiffness * slide_minus_spring_free_length;
    let t170 = t169 * cos_cylinder_phi;
    let t171 = t168 + t170;
    let t172 = t169 * sin_cylinder_phi;
    let t173 = t167 * sin_cylinder_phi;
    let t174 = t173 - (R::literal(2.943) - t172);
    let t175 = -(t167 * t14) - t169 * t14;
    let t176 = -t168;
    let t177 = t176 - t170;
    let t178 = -t173 - (R::literal(1.962) + t172);
    let t179 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t180 = p.winding_force * bobbin_x_minus_drum_x;
    let t181 = t180 / between - R::literal(9.81) * p.bobbin_mass;
    let post_omega_squared = post_omega * post_omega;
    let t182 = R::literal(0.1) * post_omega_squared;
    let t183 = t182 * cos_post_phi;
    let t184 = t182 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t185 = R::literal(0.06) * plate_omega_squared;
    let t186 = t185 * cos_plate_phi;
    let t187 = t185 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t188 = cylinder_omega_squared * cos_cylinder_phi;
    let t189 = cylinder_omega_squared * sin_cylinder_phi;
    let t190 = R::literal(2.0) * cylinder_v_x;
    let t191 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t192 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t193 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t194 = R::literal(2.0) * rod_v_x;
    let t195 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t196 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t197 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t198 = R::literal(0.06) * (rod_omega * rod_omega);
    let t199 = t198 * cos_rod_phi;
    let t200 = t198 * sin_rod_phi;
    let t201 = t18 * plate_omega_squared;
    let between_squared_times_between = between * between * between;
    let t202 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t203 = bobbin_v_y * bobbin_x_minus_drum_x;
    let t204 = t203 * bobbin_y_minus_drum_y / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t205 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let drum_v_y_times_bobbin_x_minus_drum_x = drum_v_y * bobbin_x_minus_drum_x;
    let t206 = drum_v_y_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t207 = bobbin_v_x * bobbin_x_minus_drum_x;
    let t208 = t207 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t209 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let drum_v_x_times_bobbin_x_minus_drum_x = drum_v_x * bobbin_x_minus_drum_x;
    let t210 = drum_v_x_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t211 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t212 = bobbin_v_x
        * (bobbin_v_x_over_between + t205 + t206 - t202 - t204 - drum_v_x_over_between)
        + bobbin_v_y
            * (bobbin_v_y_over_between + t210 + t211 - t208 - t209
                - drum_v_y_over_between)
        + drum_v_x
            * (t202 + t204 + drum_v_x_over_between - bobbin_v_x_over_between - t205
                - t206);
    let t213 = R::literal(0.044) * cos_post_phi;
    let t214 = R::literal(0.143) * sin_post_phi;
    let t215 = t43 * t183;
    let t216 = -t184 - R::literal(-9.81) + t215;
    let t217 = t22 * bobbin_radius_times_winding_force;
    let t218 = t217 - (t186 + t183) + t45 * t183 - t53 * t216;
    let t219 = t23 * bobbin_radius_times_winding_force;
    let t220 = -(t187 + t184) - R::literal(9.81) - R::literal(-9.81) - t219 + t215
        - t55 * t216 - t62 * t218;
    let t221 = R::literal(3.333_333_333_333_333_5) * t171;
    let t222 = t217 - R::literal(0.06) * (plate_omega_squared * cos_plate_phi + t188)
        - t221 - t28 * t175 - t64 * t218 - t76 * t220;
    let t223 = R::literal(3.333_333_333_333_333_5) * t174;
    let t224 = -(R::literal(0.06) * (plate_omega_squared * sin_plate_phi + t189))
        - R::literal(9.81) - t219 - t223 + t29 * t175 - t65 * t218 - t78 * t220
        - t89 * t222;
    let t225 = t91 * t222 - R::literal(-2_777.777_777_777_778) * t175 - t102 * t224;
    let t226 = cylinder_omega
        * (t194 * cos_cylinder_phi + t195 * sin_cylinder_phi + t196 + t197
            - t190 * cos_cylinder_phi - t191 * sin_cylinder_phi - t192 - t193)
        - t26 * t171 + t27 * t174 + t30 * t175 + t31 * t177 - t32 * t178 - t93 * t222;
    let t227 = t226 - t104 * t224 - t113 * t225;
    let t228 = R::literal(5.0) * t177;
    let t229 = t199 - t228 - t114 * t225 - t124 * t227;
    let t230 = R::literal(5.0) * t178;
    let t231 = t200 - t230 + t115 * t225 - t126 * t227 - t135 * t229;
    let t232 = inverse_bobbin_mass * t179;
    let t233 = t201 - t24 * bobbin_radius_times_winding_force + t232 - t68 * t218
        - t81 * t220 - t95 * t222 - t106 * t224 - t117 * t225 - t128 * t227 - t137 * t229
        - t144 * t231;
    let t234 = inverse_bobbin_mass * t181;
    let t235 = t16 * plate_omega_squared - R::literal(9.81)
        + t25 * bobbin_radius_times_winding_force - t234 + t70 * t218 - t84 * t220
        - t97 * t222 - t108 * t224 - t119 * t225 - t130 * t227 - t139 * t229
        - t146 * t231 - t151 * t233;
    let t236 = t35 * t179
        - (t212
            + drum_v_y
                * (t208 + t209 + drum_v_y_over_between - bobbin_v_y_over_between - t210
                    - t211)) - t36 * t181 + t38 * R::literal(-14.715) + t152 * t233
        - t157 * t235 - t161 * R::literal(9.809_999_999_999_999);
    let t237 = (t214 - t213) * post_omega_squared - t47 * t183 - t57 * t216 - t72 * t218
        - t86 * t220 - t99 * t222 - t110 * t224 - t121 * t225 - t132 * t227 - t141 * t229
        - t148 * t231 - t154 * t233;
    let t238 = (t237 - t159 * t235 - t164 * t236) * t166;
    let t239 = t236 * t162 - t164 * t238;
    let axle_b_x = t160 * t239;
    let t240 = t235 * t155 - t157 * t239 - t159 * t238;
    let t241 = t233 * t149 - t151 * t240 + t152 * t239 - t154 * t238;
    let t242 = t231 * t142 - t144 * t241 - t146 * t240 - t148 * t238;
    let t243 = t229 * t133 - t135 * t242 - t137 * t241 - t139 * t240 - t141 * t238;
    let t244 = t227 * t122 - t124 * t243 - t126 * t242 - t128 * t241 - t130 * t240
        - t132 * t238;
    let t245 = t225 * t111 - t113 * t244 - t114 * t243 + t115 * t242 - t117 * t241
        - t119 * t240 - t121 * t238;
    let t246 = t224 * t100 - t102 * t245 - t104 * t244 - t106 * t241 - t108 * t240
        - t110 * t238;
    let t247 = t222 * t87 - t89 * t246 + t91 * t245 - t93 * t244 - t95 * t241
        - t97 * t240 - t99 * t238;
    let t248 = t220 * t74 - t76 * t247 - t78 * t246 - t81 * t241 - t84 * t240
        - t86 * t238;
    let t249 = t218 * t59 - t62 * t248 - t64 * t247 - t65 * t246 - t68 * t241
        + t70 * t240 - t72 * t238;
    let t250 = t216 * t51 - t53 * t249 - t55 * t248 - t57 * t238;
    let t251 = -(t183 * t41) - t43 * t250 - t45 * t249 - t43 * t248 + t47 * t238;
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        - R::literal(0.666_666_666_666_666_6)
            * (R::literal(-14.714_999_999_999_998) - t161 * t239) + t38 * t239;
    let drum_v_x_dot = R::literal(0.666_666_666_666_666_6) * axle_b_x + t37 * t239;
    let bobbin_v_y_dot = t234 - inverse_bobbin_mass * t240 - t36 * t239;
    let bobbin_v_x_dot = -t232 - inverse_bobbin_mass * t241 - t35 * t239;
    let rod_omega_dot = t33 * t243 - R::literal(4_166.666_666_666_667) * t245
        - t34 * t242;
    let rod_v_y_dot = t230 - t32 * t244 - R::literal(5.0) * t242;
    let rod_v_x_dot = t228 + t31 * t244 - R::literal(5.0) * t243;
    let cylinder_omega_dot = t175 * R::literal(2_777.777_777_777_778) - t28 * t247
        + t29 * t246 - R::literal(-2_777.777_777_777_778) * t245 + t30 * t244;
    let cylinder_v_y_dot = t223 - R::literal(3.333_333_333_333_333_5) * t246
        + t27 * t244;
    let cylinder_v_x_dot = t221 - R::literal(3.333_333_333_333_333_5) * t247
        - t26 * t244;
    let plate_omega_dot = -(bobbin_radius_times_winding_force * R::literal(400.0))
        - t22 * t249 + t23 * t248 - t22 * t247 + t23 * t246 + t24 * t241 - t25 * t240;
    let post_omega_dot = t20 * t250 - t19 * t251 - t19 * t249 + t20 * t248 - t21 * t238;
    let t252 = t213 - t214;
    let t253 = -(t0 * t251) - t1 * t250 - t0 * t249 - t1 * t248 - t252 * t238;
    let t254 = t184 - t0 * post_omega_dot - t19 * t253;
    let t255 = -t183 - t1 * post_omega_dot + t20 * t253 - t43 * t254;
    let t256 = t254 - t45 * t254 - t53 * t255;
    let t257 = t255 - t55 * t255 - t62 * t256;
    let t258 = -(t64 * t256) - t76 * t257;
    let t259 = -(t65 * t256) - t78 * t257 - t89 * t258;
    let t260 = t91 * t258 - t102 * t259;
    let t261 = -(t93 * t258) - t104 * t259 - t113 * t260;
    let t262 = -(t114 * t260) - t124 * t261;
    let t263 = t115 * t260 - t126 * t261 - t135 * t262;
    let t264 = -(t68 * t256) - t81 * t257 - t95 * t258 - t106 * t259 - t117 * t260
        - t128 * t261 - t137 * t262 - t144 * t263;
    let t265 = t70 * t256 - t84 * t257 - t97 * t258 - t108 * t259 - t119 * t260
        - t130 * t261 - t139 * t262 - t146 * t263 - t151 * t264;
    let t266 = t152 * t264 - t157 * t265;
    let t267 = t15 * post_omega_squared - t252 * post_omega_dot - t21 * t253 + t47 * t254
        - t57 * t255 - t72 * t256 - t86 * t257 - t99 * t258 - t110 * t259 - t121 * t260
        - t132 * t261 - t141 * t262;
    let t268 = (t267 - t148 * t263 - t154 * t264 - t159 * t265 - t164 * t266) * t166;
    let t269 = t266 * t162 - t164 * t268;
    let t270 = t265 * t155 - t157 * t269 - t159 * t268;
    let t271 = t264 * t149 - t151 * t270 + t152 * t269 - t154 * t268;
    let t272 = t263 * t142 - t144 * t271 - t146 * t270 - t148 * t268;
    let t273 = t262 * t133 - t135 * t272 - t137 * t271 - t139 * t270 - t141 * t268;
    let t274 = t261 * t122 - t124 * t273 - t126 * t272 - t128 * t271 - t130 * t270
        - t132 * t268;
    let t275 = t260 * t111 - t113 * t274 - t114 * t273 + t115 * t272 - t117 * t271
        - t119 * t270 - t121 * t268;
    let t276 = t259 * t100 - t102 * t275 - t104 * t274 - t106 * t271 - t108 * t270
        - t110 * t268;
    let t277 = t258 * t87 - t89 * t276 + t91 * t275 - t93 * t274 - t95 * t271
        - t97 * t270 - t99 * t268;
    let t278 = t257 * t74 - t76 * t277 - t78 * t276 - t81 * t271 - t84 * t270
        - t86 * t268;
    let t279 = t256 * t59 - t62 * t278 - t64 * t277 - t65 * t276 - t68 * t271
        + t70 * t270 - t72 * t268;
    let t280 = t255 * t51 - t53 * t279 - t55 * t278 - t57 * t268;
    let t281 = t254 * t41 - t43 * t280 - t45 * t279 - t43 * t278 + t47 * t268;
    let drum_v_y_dot_by_post_phi = R::literal(0.666_666_666_666_666_6) * (t161 * t269)
        + t38 * t269;
    let drum_v_x_dot_by_post_phi = R::literal(0.666_666_666_666_666_6) * (t160 * t269)
        + t37 * t269;
    let bobbin_v_y_dot_by_post_phi = -(inverse_bobbin_mass * t270) - t36 * t269;
    let bobbin_v_x_dot_by_post_phi = -(inverse_bobbin_mass * t271) - t35 * t269;
    let rod_omega_dot_by_post_phi = t33 * t273 - R::literal(4_166.666_666_666_667) * t275
        - t34 * t272;
    let rod_v_y_dot_by_post_phi = -(t32 * t274) - R::literal(5.0) * t272;
    let rod_v_x_dot_by_post_phi = t31 * t274 - R::literal(5.0) * t273;
    let cylinder_omega_dot_by_post_phi = t29 * t276 - t28 * t277
        - R::literal(-2_777.777_777_777_778) * t275 + t30 * t274;
    let cylinder_v_y_dot_by_post_phi = t27 * t274
        - R::literal(3.333_333_333_333_333_5) * t276;
    let cylinder_v_x_dot_by_post_phi = -(R::literal(3.333_333_333_333_333_5) * t277)
        - t26 * t274;
    let plate_omega_dot_by_post_phi = t23 * t278 - t22 * t279 - t22 * t277 + t23 * t276
        + t24 * t271 - t25 * t270;
    let plate_v_y_dot_by_post_phi = -(R::literal(0.833_333_333_333_333_4) * t278)
        - R::literal(-0.833_333_333_333_333_4) * t276
        - R::literal(-0.833_333_333_333_333_4) * t270;
    let plate_v_x_dot_by_post_phi = -(R::literal(0.833_333_333_333_333_4) * t279)
        - R::literal(-0.833_333_333_333_333_4) * t277
        - R::literal(-0.833_333_333_333_333_4) * t271;
    let post_omega_dot_by_post_phi = t253 * R::literal(370.370_370_370_370_3)
        - t19 * t281 + t20 * t280 - t19 * t279 + t20 * t278 - t21 * t268;
    let post_v_y_dot_by_post_phi = -(R::literal(1.25) * t280) - R::literal(-1.25) * t278;
    let post_v_x_dot_by_post_phi = -(R::literal(1.25) * t281) - R::literal(-1.25) * t279;
    let t282 = -(t2 * t249) - t3 * t248 - t2 * t247 - t3 * t246 - t17 * t241
        + t16 * t240;
    let t283 = t187 - t2 * plate_omega_dot - t22 * t282;
    let t284 = -t186 - t3 * plate_omega_dot + t23 * t282;
    let t285 = t284 - t62 * t283;
    let t286 = t283 - t64 * t283 - t76 * t285;
    let t287 = t284 - t65 * t283 - t78 * t285 - t89 * t286;
    let t288 = t91 * t286 - t102 * t287;
    let t289 = -(t93 * t286) - t104 * t287 - t113 * t288;
    let t290 = -(t114 * t288) - t124 * t289;
    let t291 = t115 * t288 - t126 * t289 - t135 * t290;
    let t292 = (-t10 - t11) * plate_omega_squared - t17 * plate_omega_dot + t24 * t282
        - t68 * t283 - t81 * t285 - t95 * t286 - t106 * t287 - t117 * t288 - t128 * t289
        - t137 * t290 - t144 * t291;
    let t293 = t201 + t16 * plate_omega_dot - t25 * t282 + t70 * t283 - t84 * t285
        - t97 * t286 - t108 * t287 - t119 * t288 - t130 * t289 - t139 * t290
        - t146 * t291 - t151 * t292;
    let t294 = t152 * t292 - t157 * t293;
    let t295 = (-(t72 * t283) - t86 * t285 - t99 * t286 - t110 * t287 - t121 * t288
        - t132 * t289 - t141 * t290 - t148 * t291 - t154 * t292 - t159 * t293
        - t164 * t294) * t166;
    let t296 = t294 * t162 - t164 * t295;
    let t297 = t293 * t155 - t157 * t296 - t159 * t295;
    let t298 = t292 * t149 - t151 * t297 + t152 * t296 - t154 * t295;
    let t299 = t291 * t142 - t144 * t298 - t146 * t297 - t148 * t295;
    let t300 = t290 * t133 - t135 * t299 - t137 * t298 - t139 * t297 - t141 * t295;
    let t301 = t289 * t122 - t124 * t300 - t126 * t299 - t128 * t298 - t130 * t297
        - t132 * t295;
    let t302 = t288 * t111 - t113 * t301 - t114 * t300 + t115 * t299 - t117 * t298
        - t119 * t297 - t121 * t295;
    let t303 = t287 * t100 - t102 * t302 - t104 * t301 - t106 * t298 - t108 * t297
        - t110 * t295;
    let t304 = t286 * t87 - t89 * t303 + t91 * t302 - t93 * t301 - t95 * t298
        - t97 * t297 - t99 * t295;
    let t305 = t285 * t74 - t76 * t304 - t78 * t303 - t81 * t298 - t84 * t297
        - t86 * t295;
    let t306 = t283 * t59 - t62 * t305 - t64 * t304 - t65 * t303 - t68 * t298
        + t70 * t297 - t72 * t295;
    let t307 = -(t53 * t306) - t55 * t305 - t57 * t295;
    let t308 = -(t43 * t307) - t45 * t306 - t43 * t305 + t47 * t295;
    let drum_v_y_dot_by_plate_phi = R::literal(0.666_666_666_666_666_6) * (t161 * t296)
        + t38 * t296;
    let drum_v_x_dot_by_plate_phi = R::literal(0.666_666_666_666_666_6) * (t160 * t296)
        + t37 * t296;
    let bobbin_v_y_dot_by_plate_phi = -(inverse_bobbin_mass * t297) - t36 * t296;
    let bobbin_v_x_dot_by_plate_phi = -(inverse_bobbin_mass * t298) - t35 * t296;
    let rod_omega_dot_by_plate_phi = t33 * t300
        - R::literal(4_166.666_666_666_667) * t302 - t34 * t299;
    let rod_v_y_dot_by_plate_phi = -(t32 * t301) - R::literal(5.0) * t299;
    let rod_v_x_dot_by_plate_phi = t31 * t301 - R::literal(5.0) * t300;
    let cylinder_omega_dot_by_plate_phi = t29 * t303 - t28 * t304
        - R::literal(-2_777.777_777_777_778) * t302 + t30 * t301;
    let cylinder_v_y_dot_by_plate_phi = t27 * t301
        - R::literal(3.333_333_333_333_333_5) * t303;
    let cylinder_v_x_dot_by_plate_phi = -(R::literal(3.333_333_333_333_333_5) * t304)
        - t26 * t301;
    let plate_omega_dot_by_plate_phi = t282 * R::literal(400.0) - t22 * t306 + t23 * t305
        - t22 * t304 + t23 * t303 + t24 * t298 - t25 * t297;
    let plate_v_y_dot_by_plate_phi = -(R::literal(0.833_333_333_333_333_4) * t305)
        - R::literal(-0.833_333_333_333_333_4) * t303
        - R::literal(-0.833_333_333_333_333_4) * t297;
    let plate_v_x_dot_by_plate_phi = -(R::literal(0.833_333_333_333_333_4) * t306)
        - R::literal(-0.833_333_333_333_333_4) * t304
        - R::literal(-0.833_333_333_333_333_4) * t298;
    let post_omega_dot_by_plate_phi = t20 * t307 - t19 * t308 - t19 * t306 + t20 * t305
        - t21 * t295;
    let post_v_y_dot_by_plate_phi = -(R::literal(1.25) * t307)
        - R::literal(-1.25) * t305;
    let post_v_x_dot_by_plate_phi = -(R::literal(1.25) * t308)
        - R::literal(-1.25) * t306;
    let t309 = p.spring_stiffness * cos_cylinder_phi;
    let t310 = R::literal(50.0) * cylinder_omega;
    let t311 = t310 * sin_cylinder_phi;
    let t312 = t311 - t309;
    let t313 = t312 * cos_cylinder_phi;
    let t314 = t312 * sin_cylinder_phi;
    let t315 = t310 * t14;
    let t316 = t315 * sin_cylinder_phi;
    let t317 = p.spring_stiffness * t14;
    let t318 = t317 * cos_cylinder_phi;
    let t319 = t309 - t311;
    let t320 = t319 * cos_cylinder_phi;
    let t321 = t319 * sin_cylinder_phi;
    let t322 = cos_cylinder_phi * t244;
    let t323 = t318 - t316 - t173 - t172 - t322;
    let t324 = cos_cylinder_phi * cylinder_omega_dot;
    let t325 = R::literal(3.333_333_333_333_333_5) * t313;
    let t326 = -t325 - t28 * t323;
    let t327 = R::literal(3.333_333_333_333_333_5) * t314;
    let t328 = t29 * t323 - t327 - t89 * t326;
    let t329 = t91 * t326 - R::literal(-2_777.777_777_777_778) * t323 - t102 * t328;
    let t330 = t189 - t324 - t26 * t313 + t27 * t314 + t30 * t323 + t31 * t320
        - t32 * t321 - t93 * t326 - t104 * t328 - t113 * t329;
    let t331 = R::literal(5.0) * t320;
    let t332 = -t331 - t114 * t329 - t124 * t330;
    let t333 = R::literal(5.0) * t321;
    let t334 = t115 * t329 - t333 - t126 * t330 - t135 * t332;
    let t335 = -(t95 * t326) - t106 * t328 - t117 * t329 - t128 * t330 - t137 * t332
        - t144 * t334;
    let t336 = -(t97 * t326) - t108 * t328 - t119 * t329 - t130 * t330 - t139 * t332
        - t146 * t334 - t151 * t335;
    let t337 = t152 * t335 - t157 * t336;
    let t338 = (-(t99 * t326) - t110 * t328 - t121 * t329 - t132 * t330 - t141 * t332
        - t148 * t334 - t154 * t335 - t159 * t336 - t164 * t337) * t166;
    let t339 = t337 * t162 - t164 * t338;
    let t340 = t336 * t155 - t157 * t339 - t159 * t338;
    let t341 = t335 * t149 - t151 * t340 + t152 * t339 - t154 * t338;
    let t342 = t334 * t142 - t144 * t341 - t146 * t340 - t148 * t338;
    let t343 = t332 * t133 - t135 * t342 - t137 * t341 - t139 * t340 - t141 * t338;
    let t344 = t330 * t122 - t124 * t343 - t126 * t342 - t128 * t341 - t130 * t340
        - t132 * t338;
    let t345 = t329 * t111 - t113 * t344 - t114 * t343 + t115 * t342 - t117 * t341
        - t119 * t340 - t121 * t338;
    let t346 = t328 * t100 - t102 * t345 - t104 * t344 - t106 * t341 - t108 * t340
        - t110 * t338;
    let t347 = t326 * t87 - t89 * t346 + t91 * t345 - t93 * t344 - t95 * t341
        - t97 * t340 - t99 * t338;
    let t348 = -(t76 * t347) - t78 * t346 - t81 * t341 - t84 * t340 - t86 * t338;
    let t349 = -(t62 * t348) - t64 * t347 - t65 * t346 - t68 * t341 + t70 * t340
        - t72 * t338;
    let t350 = -(t53 * t349) - t55 * t348 - t57 * t338;
    let t351 = -(t43 * t350) - t45 * t349 - t43 * t348 + t47 * t338;
    let drum_v_y_dot_by_cylinder_x = R::literal(0.666_666_666_666_666_6) * (t161 * t339)
        + t38 * t339;
    let drum_v_x_dot_by_cylinder_x = R::literal(0.666_666_666_666_666_6) * (t160 * t339)
        + t37 * t339;
    let bobbin_v_y_dot_by_cylinder_x = -(inverse_bobbin_mass * t340) - t36 * t339;
    let bobbin_v_x_dot_by_cylinder_x = -(inverse_bobbin_mass * t341) - t35 * t339;
    let rod_omega_dot_by_cylinder_x = t33 * t343
        - R::literal(4_166.666_666_666_667) * t345 - t34 * t342;
    let rod_v_y_dot_by_cylinder_x = t333 - t32 * t344 - R::literal(5.0) * t342;
    let rod_v_x_dot_by_cylinder_x = t331 + t31 * t344 - R::literal(5.0) * t343;
    let cylinder_omega_dot_by_cylinder_x = t323 * R::literal(2_777.777_777_777_778)
        - t28 * t347 + t29 * t346 - R::literal(-2_777.777_777_777_778) * t345
        + t30 * t344;
    let cylinder_v_y_dot_by_cylinder_x = t327
        - R::literal(3.333_333_333_333_333_5) * t346 + t27 * t344;
    let cylinder_v_x_dot_by_cylinder_x = t325
        - R::literal(3.333_333_333_333_333_5) * t347 - t26 * t344;
    let plate_omega_dot_by_cylinder_x = t23 * t348 - t22 * t349 - t22 * t347 + t23 * t346
        + t24 * t341 - t25 * t340;
    let plate_v_y_dot_by_cylinder_x = -(R::literal(0.833_333_333_333_333_4) * t348)
        - R::literal(-0.833_333_333_333_333_4) * t346
        - R::literal(-0.833_333_333_333_333_4) * t340;
    let plate_v_x_dot_by_cylinder_x = -(R::literal(0.833_333_333_333_333_4) * t349)
        - R::literal(-0.833_333_333_333_333_4) * t347
        - R::literal(-0.833_333_333_333_333_4) * t341;
    let post_omega_dot_by_cylinder_x = t20 * t350 - t19 * t351 - t19 * t349 + t20 * t348
        - t21 * t338;
    let post_v_y_dot_by_cylinder_x = -(R::literal(1.25) * t350)
        - R::literal(-1.25) * t348;
    let post_v_x_dot_by_cylinder_x = -(R::literal(1.25) * t351)
        - R::literal(-1.25) * t349;
    let t352 = t310 * cos_cylinder_phi;
    let t353 = p.spring_stiffness * sin_cylinder_phi;
    let t354 = -t352 - t353;
    let t355 = t354 * cos_cylinder_phi;
    let t356 = t354 * sin_cylinder_phi;
    let t357 = t315 * cos_cylinder_phi;
    let t358 = t317 * sin_cylinder_phi;
    let t359 = t352 + t353;
    let t360 = t359 * cos_cylinder_phi;
    let t361 = t359 * sin_cylinder_phi;
    let t362 = sin_cylinder_phi * t244;
    let t363 = t357 + t168 + t170 + t358 - t362;
    let t364 = sin_cylinder_phi * cylinder_omega_dot;
    let t365 = R::literal(3.333_333_333_333_333_5) * t355;
    let t366 = -t365 - t28 * t363;
    let t367 = R::literal(3.333_333_333_333_333_5) * t356;
    let t368 = t29 * t363 - t367 - t89 * t366;
    let t369 = t91 * t366 - R::literal(-2_777.777_777_777_778) * t363 - t102 * t368;
    let t370 = -t188 - t364 - t26 * t355 + t27 * t356 + t30 * t363 + t31 * t360
        - t32 * t361 - t93 * t366 - t104 * t368 - t113 * t369;
    let t371 = R::literal(5.0) * t360;
    let t372 = -t371 - t114 * t369 - t124 * t370;
    let t373 = R::literal(5.0) * t361;
    let t374 = t115 * t369 - t373 - t126 * t370 - t135 * t372;
    let t375 = -(t95 * t366) - t106 * t368 - t117 * t369 - t128 * t370 - t137 * t372
        - t144 * t374;
    let t376 = -(t97 * t366) - t108 * t368 - t119 * t369 - t130 * t370 - t139 * t372
        - t146 * t374 - t151 * t375;
    let t377 = t152 * t375 - t157 * t376;
    let t378 = (-(t99 * t366) - t110 * t368 - t121 * t369 - t132 * t370 - t141 * t372
        - t148 * t374 - t154 * t375 - t159 * t376 - t164 * t377) * t166;
    let t379 = t377 * t162 - t164 * t378;
    let t380 = t376 * t155 - t157 * t379 - t159 * t378;
    let t381 = t375 * t149 - t151 * t380 + t152 * t379 - t154 * t378;
    let t382 = t374 * t142 - t144 * t381 - t146 * t380 - t148 * t378;
    let t383 = t372 * t133 - t135 * t382 - t137 * t381 - t139 * t380 - t141 * t378;
    let t384 = t370 * t122 - t124 * t383 - t126 * t382 - t128 * t381 - t130 * t380
        - t132 * t378;
    let t385 = t369 * t111 - t113 * t384 - t114 * t383 + t115 * t382 - t117 * t381
        - t119 * t380 - t121 * t378;
    let t386 = t368 * t100 - t102 * t385 - t104 * t384 - t106 * t381 - t108 * t380
        - t110 * t378;
    let t387 = t366 * t87 - t89 * t386 + t91 * t385 - t93 * t384 - t95 * t381
        - t97 * t380 - t99 * t378;
    let t388 = -(t76 * t387) - t78 * t386 - t81 * t381 - t84 * t380 - t86 * t378;
    let t389 = -(t62 * t388) - t64 * t387 - t65 * t386 - t68 * t381 + t70 * t380
        - t72 * t378;
    let t390 = -(t53 * t389) - t55 * t388 - t57 * t378;
    let t391 = -(t43 * t390) - t45 * t389 - t43 * t388 + t47 * t378;
    let drum_v_y_dot_by_cylinder_y = R::literal(0.666_666_666_666_666_6) * (t161 * t379)
        + t38 * t379;
    let drum_v_x_dot_by_cylinder_y = R::literal(0.666_666_666_666_666_6) * (t160 * t379)
        + t37 * t379;
    let bobbin_v_y_dot_by_cylinder_y = -(inverse_bobbin_mass * t380) - t36 * t379;
    let bobbin_v_x_dot_by_cylinder_y = -(inverse_bobbin_mass * t381) - t35 * t379;
    let rod_omega_dot_by_cylinder_y = t33 * t383
        - R::literal(4_166.666_666_666_667) * t385 - t34 * t382;
    let rod_v_y_dot_by_cylinder_y = t373 - t32 * t384 - R::literal(5.0) * t382;
    let rod_v_x_dot_by_cylinder_y = t371 + t31 * t384 - R::literal(5.0) * t383;
    let cylinder_omega_dot_by_cylinder_y = t363 * R::literal(2_777.777_777_777_778)
        - t28 * t387 + t29 * t386 - R::literal(-2_777.777_777_777_778) * t385
        + t30 * t384;
    let cylinder_v_y_dot_by_cylinder_y = t367
        - R::literal(3.333_333_333_333_333_5) * t386 + t27 * t384;
    let cylinder_v_x_dot_by_cylinder_y = t365
        - R::literal(3.333_333_333_333_333_5) * t387 - t26 * t384;
    let plate_omega_dot_by_cylinder_y = t23 * t388 - t22 * t389 - t22 * t387 + t23 * t386
        + t24 * t381 - t25 * t380;
    let plate_v_y_dot_by_cylinder_y = -(R::literal(0.833_333_333_333_333_4) * t388)
        - R::literal(-0.833_333_333_333_333_4) * t386
        - R::literal(-0.833_333_333_333_333_4) * t380;
    let plate_v_x_dot_by_cylinder_y = -(R::literal(0.833_333_333_333_333_4) * t389)
        - R::literal(-0.833_333_333_333_333_4) * t387
        - R::literal(-0.833_333_333_333_333_4) * t381;
    let post_omega_dot_by_cylinder_y = t20 * t390 - t19 * t391 - t19 * t389 + t20 * t388
        - t21 * t378;
    let post_v_y_dot_by_cylinder_y = -(R::literal(1.25) * t390)
        - R::literal(-1.25) * t388;
    let post_v_x_dot_by_cylinder_y = -(R::literal(1.25) * t391)
        - R::literal(-1.25) * t389;
    let t392 = R::literal(50.0)
        * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi - cylinder_omega * slide
            - rod_v_x_minus_cylinder_v_x * sin_cylinder_phi);
    let t393 = t392 * cos_cylinder_phi;
    let t394 = t392 * sin_cylinder_phi;
    let t395 = t14 * t14;
    let t396 = R::literal(0.06) * cylinder_omega_squared;
    let t397 = t393 + t318 - t173 - t172 - t322;
    let t398 = t168 + t394 - (-t170 - t358) - t362;
    let t399 = t12 - t13;
    let t400 = R::literal(50.0) * slide * slide_rate
        + p.spring_stiffness * slide * slide_minus_spring_free_length - t392 * t14
        - p.spring_stiffness * t395 - t4 * t247 - t5 * t246 - t399 * t244;
    let t401 = t173 + t172 - t393 - t318 + t322;
    let t402 = cylinder_omega
        * (t190 * sin_cylinder_phi + t195 * cos_cylinder_phi
            + cylinder_x_times_cylinder_omega * cos_cylinder_phi
            + cylinder_y_times_cylinder_omega * sin_cylinder_phi
            - t191 * cos_cylinder_phi - t194 * sin_cylinder_phi
            - rod_x_times_cylinder_omega * cos_cylinder_phi
            - rod_y_times_cylinder_omega * sin_cylinder_phi)
        - cos_cylinder_phi * cylinder_v_x_dot - sin_cylinder_phi * cylinder_v_y_dot
        - t399 * cylinder_omega_dot + cos_cylinder_phi * rod_v_x_dot;
    let t403 = t176 - t394 - (t170 + t358) + t362;
    let t404 = R::literal(3.333_333_333_333_333_5) * t397;
    let t405 = t396 * sin_cylinder_phi - t4 * cylinder_omega_dot - t404 - t28 * t400;
    let t406 = R::literal(3.333_333_333_333_333_5) * t398;
    let t407 = -(t396 * cos_cylinder_phi) - t5 * cylinder_omega_dot - t406 + t29 * t400
        - t89 * t405;
    let t408 = t91 * t405 - R::literal(-2_777.777_777_777_778) * t400 - t102 * t407;
    let t409 = t402 + sin_cylinder_phi * rod_v_y_dot - t26 * t397 + t27 * t398
        + t30 * t400 + t31 * t401 - t32 * t403 - t93 * t405 - t104 * t407 - t113 * t408;
    let t410 = R::literal(5.0) * t401;
    let t411 = -t410 - t114 * t408 - t124 * t409;
    let t412 = R::literal(5.0) * t403;
    let t413 = t115 * t408 - t412 - t126 * t409 - t135 * t411;
    let t414 = -(t95 * t405) - t106 * t407 - t117 * t408 - t128 * t409 - t137 * t411
        - t144 * t413;
    let t415 = -(t97 * t405) - t108 * t407 - t119 * t408 - t130 * t409 - t139 * t411
        - t146 * t413 - t151 * t414;
    let t416 = t152 * t414 - t157 * t415;
    let t417 = (-(t99 * t405) - t110 * t407 - t121 * t408 - t132 * t409 - t141 * t411
        - t148 * t413 - t154 * t414 - t159 * t415 - t164 * t416) * t166;
    let t418 = t416 * t162 - t164 * t417;
    let t419 = t415 * t155 - t157 * t418 - t159 * t417;
    let t420 = t414 * t149 - t151 * t419 + t152 * t418 - t154 * t417;
    let t421 = t413 * t142 - t144 * t420 - t146 * t419 - t148 * t417;
    let t422 = t411 * t133 - t135 * t421 - t137 * t420 - t139 * t419 - t141 * t417;
    let t423 = t409 * t122 - t124 * t422 - t126 * t421 - t128 * t420 - t130 * t419
        - t132 * t417;
    let t424 = t408 * t111 - t113 * t423 - t114 * t422 + t115 * t421 - t117 * t420
        - t119 * t419 - t121 * t417;
    let t425 = t407 * t100 - t102 * t424 - t104 * t423 - t106 * t420 - t108 * t419
        - t110 * t417;
    let t426 = t405 * t87 - t89 * t425 + t91 * t424 - t93 * t423 - t95 * t420
        - t97 * t419 - t99 * t417;
    let t427 = -(t76 * t426) - t78 * t425 - t81 * t420 - t84 * t419 - t86 * t417;
    let t428 = -(t62 * t427) - t64 * t426 - t65 * t425 - t68 * t420 + t70 * t419
        - t72 * t417;
    let t429 = -(t53 * t428) - t55 * t427 - t57 * t417;
    let t430 = -(t43 * t429) - t45 * t428 - t43 * t427 + t47 * t417;
    let drum_v_y_dot_by_cylinder_phi = R::literal(0.666_666_666_666_666_6)
        * (t161 * t418) + t38 * t418;
    let drum_v_x_dot_by_cylinder_phi = R::literal(0.666_666_666_666_666_6)
        * (t160 * t418) + t37 * t418;
    let bobbin_v_y_dot_by_cylinder_phi = -(inverse_bobbin_mass * t419) - t36 * t418;
    let bobbin_v_x_dot_by_cylinder_phi = -(inverse_bobbin_mass * t420) - t35 * t418;
    let rod_omega_dot_by_cylinder_phi = t33 * t422
        - R::literal(4_166.666_666_666_667) * t424 - t34 * t421;
    let rod_v_y_dot_by_cylinder_phi = t412 - t32 * t423 - R::literal(5.0) * t421;
    let rod_v_x_dot_by_cylinder_phi = t410 + t31 * t423 - R::literal(5.0) * t422;
    let cylinder_omega_dot_by_cylinder_phi = t400 * R::literal(2_777.777_777_777_778)
        - t28 * t426 + t29 * t425 - R::literal(-2_777.777_777_777_778) * t424
        + t30 * t423;
    let cylinder_v_y_dot_by_cylinder_phi = t406
        - R::literal(3.333_333_333_333_333_5) * t425 + t27 * t423;
    let cylinder_v_x_dot_by_cylinder_phi = t404
        - R::literal(3.333_333_333_333_333_5) * t426 - t26 * t423;
    let plate_omega_dot_by_cylinder_phi = t23 * t427 - t22 * t428 - t22 * t426
        + t23 * t425 + t24 * t420 - t25 * t419;
    let plate_v_y_dot_by_cylinder_phi = -(R::literal(0.833_333_333_333_333_4) * t427)
        - R::literal(-0.833_333_333_333_333_4) * t425
        - R::literal(-0.833_333_333_333_333_4) * t419;
    let plate_v_x_dot_by_cylinder_phi = -(R::literal(0.833_333_333_333_333_4) * t428)
        - R::literal(-0.833_333_333_333_333_4) * t426
        - R::literal(-0.833_333_333_333_333_4) * t420;
    let post_omega_dot_by_cylinder_phi = t20 * t429 - t19 * t430 - t19 * t428
        + t20 * t427 - t21 * t417;
    let post_v_y_dot_by_cylinder_phi = -(R::literal(1.25) * t429)
        - R::literal(-1.25) * t427;
    let post_v_x_dot_by_cylinder_phi = -(R::literal(1.25) * t430)
        - R::literal(-1.25) * t428;
    let t431 = t316 + t173 + t172 - t318 + t322;
    let t432 = R::literal(3.333_333_333_333_333_5) * t320;
    let t433 = -t432 - t28 * t431;
    let t434 = R::literal(3.333_333_333_333_333_5) * t321;
    let t435 = t29 * t431 - t434 - t89 * t433;
    let t436 = t91 * t433 - R::literal(-2_777.777_777_777_778) * t431 - t102 * t435;
    let t437 = t324 - t189 - t26 * t320 + t27 * t321 + t30 * t431 + t31 * t313
        - t32 * t314 - t93 * t433 - t104 * t435 - t113 * t436;
    let t438 = R::literal(5.0) * t313;
    let t439 = -t438 - t114 * t436 - t124 * t437;
    let t440 = R::literal(5.0) * t314;
    let t441 = t115 * t436 - t440 - t126 * t437 - t135 * t439;
    let t442 = -(t95 * t433) - t106 * t435 - t117 * t436 - t128 * t437 - t137 * t439
        - t144 * t441;
    let t443 = -(t97 * t433) - t108 * t435 - t119 * t436 - t130 * t437 - t139 * t439
        - t146 * t441 - t151 * t442;
    let t444 = t152 * t442 - t157 * t443;
    let t445 = (-(t99 * t433) - t110 * t435 - t121 * t436 - t132 * t437 - t141 * t439
        - t148 * t441 - t154 * t442 - t159 * t443 - t164 * t444) * t166;
    let t446 = t444 * t162 - t164 * t445;
    let t447 = t443 * t155 - t157 * t446 - t159 * t445;
    let t448 = t442 * t149 - t151 * t447 + t152 * t446 - t154 * t445;
    let t449 = t441 * t142 - t144 * t448 - t146 * t447 - t148 * t445;
    let t450 = t439 * t133 - t135 * t449 - t137 * t448 - t139 * t447 - t141 * t445;
    let t451 = t437 * t122 - t124 * t450 - t126 * t449 - t128 * t448 - t130 * t447
        - t132 * t445;
    let t452 = t436 * t111 - t113 * t451 - t114 * t450 + t115 * t449 - t117 * t448
        - t119 * t447 - t121 * t445;
    let t453 = t435 * t100 - t102 * t452 - t104 * t451 - t106 * t448 - t108 * t447
        - t110 * t445;
    let t454 = t433 * t87 - t89 * t453 + t91 * t452 - t93 * t451 - t95 * t448
        - t97 * t447 - t99 * t445;
    let t455 = -(t76 * t454) - t78 * t453 - t81 * t448 - t84 * t447 - t86 * t445;
    let t456 = -(t62 * t455) - t64 * t454 - t65 * t453 - t68 * t448 + t70 * t447
        - t72 * t445;
    let t457 = -(t53 * t456) - t55 * t455 - t57 * t445;
    let t458 = -(t43 * t457) - t45 * t456 - t43 * t455 + t47 * t445;
    let drum_v_y_dot_by_rod_x = R::literal(0.666_666_666_666_666_6) * (t161 * t446)
        + t38 * t446;
    let drum_v_x_dot_by_rod_x = R::literal(0.666_666_666_666_666_6) * (t160 * t446)
        + t37 * t446;
    let bobbin_v_y_dot_by_rod_x = -(inverse_bobbin_mass * t447) - t36 * t446;
    let bobbin_v_x_dot_by_rod_x = -(inverse_bobbin_mass * t448) - t35 * t446;
    let rod_omega_dot_by_rod_x = t33 * t450 - R::literal(4_166.666_666_666_667) * t452
        - t34 * t449;
    let rod_v_y_dot_by_rod_x = t440 - t32 * t451 - R::literal(5.0) * t449;
    let rod_v_x_dot_by_rod_x = t438 + t31 * t451 - R::literal(5.0) * t450;
    let cylinder_omega_dot_by_rod_x = t431 * R::literal(2_777.777_777_777_778)
        - t28 * t454 + t29 * t453 - R::literal(-2_777.777_777_777_778) * t452
        + t30 * t451;
    let cylinder_v_y_dot_by_rod_x = t434 - R::literal(3.333_333_333_333_333_5) * t453
        + t27 * t451;
    let cylinder_v_x_dot_by_rod_x = t432 - R::literal(3.333_333_333_333_333_5) * t454
        - t26 * t451;
    let plate_omega_dot_by_rod_x = t23 * t455 - t22 * t456 - t22 * t454 + t23 * t453
        + t24 * t448 - t25 * t447;
    let plate_v_y_dot_by_rod_x = -(R::literal(0.833_333_333_333_333_4) * t455)
        - R::literal(-0.833_333_333_333_333_4) * t453
        - R::literal(-0.833_333_333_333_333_4) * t447;
    let plate_v_x_dot_by_rod_x = -(R::literal(0.833_333_333_333_333_4) * t456)
        - R::literal(-0.833_333_333_333_333_4) * t454
        - R::literal(-0.833_333_333_333_333_4) * t448;
    let post_omega_dot_by_rod_x = t20 * t457 - t19 * t458 - t19 * t456 + t20 * t455
        - t21 * t445;
    let post_v_y_dot_by_rod_x = -(R::literal(1.25) * t457) - R::literal(-1.25) * t455;
    let post_v_x_dot_by_rod_x = -(R::literal(1.25) * t458) - R::literal(-1.25) * t456;
    let t459 = -t357 - t168 - t170 - t358 + t362;
    let t460 = R::literal(3.333_333_333_333_333_5) * t360;
    let t461 = -t460 - t28 * t459;
    let t462 = R::literal(3.333_333_333_333_333_5) * t361;
    let t463 = t29 * t459 - t462 - t89 * t461;
    let t464 = t91 * t461 - R::literal(-2_777.777_777_777_778) * t459 - t102 * t463;
    let t465 = t188 + t364 - t26 * t360 + t27 * t361 + t30 * t459 + t31 * t355
        - t32 * t356 - t93 * t461 - t104 * t463 - t113 * t464;
    let t466 = R::literal(5.0) * t355;
    let t467 = -t466 - t114 * t464 - t124 * t465;
    let t468 = R::literal(5.0) * t356;
    let t469 = t115 * t464 - t468 - t126 * t465 - t135 * t467;
    let t470 = -(t95 * t461) - t106 * t463 - t117 * t464 - t128 * t465 - t137 * t467
        - t144 * t469;
    let t471 = -(t97 * t461) - t108 * t463 - t119 * t464 - t130 * t465 - t139 * t467
        - t146 * t469 - t151 * t470;
    let t472 = t152 * t470 - t157 * t471;
    let t473 = (-(t99 * t461) - t110 * t463 - t121 * t464 - t132 * t465 - t141 * t467
        - t148 * t469 - t154 * t470 - t159 * t471 - t164 * t472) * t166;
    let t474 = t472 * t162 - t164 * t473;
    let t475 = t471 * t155 - t157 * t474 - t159 * t473;
    let t476 = t470 * t149 - t151 * t475 + t152 * t474 - t154 * t473;
    let t477 = t469 * t142 - t144 * t476 - t146 * t475 - t148 * t473;
    let t478 = t467 * t133 - t135 * t477 - t137 * t476 - t139 * t475 - t141 * t473;
    let t479 = t465 * t122 - t124 * t478 - t126 * t477 - t128 * t476 - t130 * t475
        - t132 * t473;
    let t480 = t464 * t111 - t113 * t479 - t114 * t478 + t115 * t477 - t117 * t476
        - t119 * t475 - t121 * t473;
    let t481 = t463 * t100 - t102 * t480 - t104 * t479 - t106 * t476 - t108 * t475
        - t110 * t473;
    let t482 = t461 * t87 - t89 * t481 + t91 * t480 - t93 * t479 - t95 * t476
        - t97 * t475 - t99 * t473;
    let t483 = -(t76 * t482) - t78 * t481 - t81 * t476 - t84 * t475 - t86 * t473;
    let t484 = -(t62 * t483) - t64 * t482 - t65 * t481 - t68 * t476 + t70 * t475
        - t72 * t473;
    let t485 = -(t53 * t484) - t55 * t483 - t57 * t473;
    let t486 = -(t43 * t485) - t45 * t484 - t43 * t483 + t47 * t473;
    let drum_v_y_dot_by_rod_y = R::literal(0.666_666_666_666_666_6) * (t161 * t474)
        + t38 * t474;
    let drum_v_x_dot_by_rod_y = R::literal(0.666_666_666_666_666_6) * (t160 * t474)
        + t37 * t474;
    let bobbin_v_y_dot_by_rod_y = -(inverse_bobbin_mass * t475) - t36 * t474;
    let bobbin_v_x_dot_by_rod_y = -(inverse_bobbin_mass * t476) - t35 * t474;
    let rod_omega_dot_by_rod_y = t33 * t478 - R::literal(4_166.666_666_666_667) * t480
        - t34 * t477;
    let rod_v_y_dot_by_rod_y = t468 - t32 * t479 - R::literal(5.0) * t477;
    let rod_v_x_dot_by_rod_y = t466 + t31 * t479 - R::literal(5.0) * t478;
    let cylinder_omega_dot_by_rod_y = t459 * R::literal(2_777.777_777_777_778)
        - t28 * t482 + t29 * t481 - R::literal(-2_777.777_777_777_778) * t480
        + t30 * t479;
    let cylinder_v_y_dot_by_rod_y = t462 - R::literal(3.333_333_333_333_333_5) * t481
        + t27 * t479;
    let cylinder_v_x_dot_by_rod_y = t460 - R::literal(3.333_333_333_333_333_5) * t482
        - t26 * t479;
    let plate_omega_dot_by_rod_y = t23 * t483 - t22 * t484 - t22 * t482 + t23 * t481
        + t24 * t476 - t25 * t475;
    let plate_v_y_dot_by_rod_y = -(R::literal(0.833_333_333_333_333_4) * t483)
        - R::literal(-0.833_333_333_333_333_4) * t481
        - R::literal(-0.833_333_333_333_333_4) * t475;
    let plate_v_x_dot_by_rod_y = -(R::literal(0.833_333_333_333_333_4) * t484)
        - R::literal(-0.833_333_333_333_333_4) * t482
        - R::literal(-0.833_333_333_333_333_4) * t476;
    let post_omega_dot_by_rod_y = t20 * t485 - t19 * t486 - t19 * t484 + t20 * t483
        - t21 * t473;
    let post_v_y_dot_by_rod_y = -(R::literal(1.25) * t485) - R::literal(-1.25) * t483;
    let post_v_x_dot_by_rod_y = -(R::literal(1.25) * t486) - R::literal(-1.25) * t484;
    let t487 = t6 * t243 + t7 * t242;
    let t488 = R::literal(4_166.666_666_666_667) * t487;
    let t489 = t113 * t488;
    let t490 = t6 * rod_omega_dot - t200 + t33 * t487 + t114 * t488 - t124 * t489;
    let t491 = t199 + t7 * rod_omega_dot - t34 * t487 - t115 * t488 - t126 * t489
        - t135 * t490;
    let t492 = t117 * t488 - t128 * t489 - t137 * t490 - t144 * t491;
    let t493 = t119 * t488 - t130 * t489 - t139 * t490 - t146 * t491 - t151 * t492;
    let t494 = t152 * t492 - t157 * t493;
    let t495 = (t121 * t488 - t132 * t489 - t141 * t490 - t148 * t491 - t154 * t492
        - t159 * t493 - t164 * t494) * t166;
    let t496 = t494 * t162 - t164 * t495;
    let t497 = t493 * t155 - t157 * t496 - t159 * t495;
    let t498 = t492 * t149 - t151 * t497 + t152 * t496 - t154 * t495;
    let t499 = t491 * t142 - t144 * t498 - t146 * t497 - t148 * t495;
    let t500 = t490 * t133 - t135 * t499 - t137 * t498 - t139 * t497 - t141 * t495;
    let t501 = t489 * t122 - t124 * t500 - t126 * t499 - t128 * t498 - t130 * t497
        - t132 * t495;
    let t502 = -(t488 * t111) - t113 * t501 - t114 * t500 + t115 * t499 - t117 * t498
        - t119 * t497 - t121 * t495;
    let t503 = -(t102 * t502) - t104 * t501 - t106 * t498 - t108 * t497 - t110 * t495;
    let t504 = t91 * t502 - t89 * t503 - t93 * t501 - t95 * t498 - t97 * t497
        - t99 * t495;
    let t505 = -(t76 * t504) - t78 * t503 - t81 * t498 - t84 * t497 - t86 * t495;
    let t506 = -(t62 * t505) - t64 * t504 - t65 * t503 - t68 * t498 + t70 * t497
        - t72 * t495;
    let t507 = -(t53 * t506) - t55 * t505 - t57 * t495;
    let t508 = -(t43 * t507) - t45 * t506 - t43 * t505 + t47 * t495;
    let drum_v_y_dot_by_rod_phi = R::literal(0.666_666_666_666_666_6) * (t161 * t496)
        + t38 * t496;
    let drum_v_x_dot_by_rod_phi = R::literal(0.666_666_666_666_666_6) * (t160 * t496)
        + t37 * t496;
    let bobbin_v_y_dot_by_rod_phi = -(inverse_bobbin_mass * t497) - t36 * t496;
    let bobbin_v_x_dot_by_rod_phi = -(inverse_bobbin_mass * t498) - t35 * t496;
    let rod_omega_dot_by_rod_phi = t488 - R::literal(4_166.666_666_666_667) * t502
        + t33 * t500 - t34 * t499;
    let rod_v_y_dot_by_rod_phi = -(t32 * t501) - R::literal(5.0) * t499;
    let rod_v_x_dot_by_rod_phi = t31 * t501 - R::literal(5.0) * t500;
    let cylinder_omega_dot_by_rod_phi = t29 * t503 - t28 * t504
        - R::literal(-2_777.777_777_777_778) * t502 + t30 * t501;
    let cylinder_v_y_dot_by_rod_phi = t27 * t501
        - R::literal(3.333_333_333_333_333_5) * t503;
    let cylinder_v_x_dot_by_rod_phi = -(R::literal(3.333_333_333_333_333_5) * t504)
        - t26 * t501;
    let plate_omega_dot_by_rod_phi = t23 * t505 - t22 * t506 - t22 * t504 + t23 * t503
        + t24 * t498 - t25 * t497;
    let plate_v_y_dot_by_rod_phi = -(R::literal(0.833_333_333_333_333_4) * t505)
        - R::literal(-0.833_333_333_333_333_4) * t503
        - R::literal(-0.833_333_333_333_333_4) * t497;
    let plate_v_x_dot_by_rod_phi = -(R::literal(0.833_333_333_333_333_4) * t506)
        - R::literal(-0.833_333_333_333_333_4) * t504
        - R::literal(-0.833_333_333_333_333_4) * t498;
    let post_omega_dot_by_rod_phi = t20 * t507 - t19 * t508 - t19 * t506 + t20 * t505
        - t21 * t495;
    let post_v_y_dot_by_rod_phi = -(R::literal(1.25) * t507) - R::literal(-1.25) * t505;
    let post_v_x_dot_by_rod_phi = -(R::literal(1.25) * t508) - R::literal(-1.25) * t506;
    let t509 = t180 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t510 = p.winding_force * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let winding_force_over_between = p.winding_force / between;
    let t511 = R::literal(3.0) * bobbin_v_x;
    let t512 = t511 * bobbin_x_minus_drum_x;
    let t513 = t512 / between_squared_times_between;
    let t514 = between.powi(5);
    let t515 = bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t516 = R::literal(3.0) * drum_v_x;
    let t517 = t516 * t515 / t514;
    let t518 = R::literal(3.0) * drum_v_y;
    let t519 = t518 * bobbin_y_minus_drum_y;
    let t520 = t519 * bobbin_x_minus_drum_x_squared / t514;
    let t521 = bobbin_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t522 = t511 * t515 / t514;
    let t523 = R::literal(3.0) * bobbin_v_y;
    let t524 = t523 * bobbin_y_minus_drum_y;
    let t525 = t524 * bobbin_x_minus_drum_x_squared / t514;
    let t526 = t516 * bobbin_x_minus_drum_x;
    let t527 = t526 / between_squared_times_between;
    let t528 = drum_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t529 = t522 + t525 + t527 + t528 - t513 - t517 - t520 - t521;
    let t530 = t516 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t514;
    let t531 = t518 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t514;
    let t532 = bobbin_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t533 = t203 / between_squared_times_between;
    let t534 = t511 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t514;
    let t535 = t523 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t514;
    let t536 = drum_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t537 = drum_v_y_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t538 = t534 + t535 + t536 + t537 - t530 - t531 - t532 - t533;
    let t539 = t513 + t517 + t520 + t521 - t522 - t525 - t527 - t528;
    let t540 = t530 + t531 + t532 + t533 - t534 - t535 - t536 - t537;
    let t541 = bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let inverse_between = R::literal(1.0) / between;
    let t542 = inverse_between - t541;
    let t543 = t542 * t239;
    let t544 = t509 - t543;
    let t545 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t546 = t545 * t239;
    let t547 = winding_force_over_between - t510 + t546;
    let t548 = t545 * bobbin_v_y_dot;
    let t549 = t541 - inverse_between;
    let t550 = t549 * t239;
    let t551 = t545 * drum_v_y_dot;
    let t552 = inverse_bobbin_mass * t544;
    let t553 = inverse_bobbin_mass * t547;
    let t554 = t151 * t552 - t553;
    let t555 = R::literal(0.666_666_666_666_666_6) * t550;
    let t556 = R::literal(0.666_666_666_666_666_6) * t546;
    let t557 = -t556;
    let t558 = t38 * t546;
    let t559 = -(bobbin_v_x * t529 + bobbin_v_y * t538 + drum_v_x * t539
        + drum_v_y * t540) - t542 * bobbin_v_x_dot + t548 - t549 * drum_v_x_dot - t551
        - t35 * t544 - t36 * t547 - t37 * t550 - t558 - t152 * t552;
    let t560 = t161 * t556;
    let t561 = t559 - t157 * t554 - t160 * t555 - t560;
    let t562 = t556 * R::literal(-1.5);
    let t563 = (t154 * t552 - t159 * t554 - t164 * t561) * t166;
    let t564 = t561 * t162 - t164 * t563;
    let t565 = t554 * t155 - t157 * t564 - t159 * t563;
    let t566 = -(t552 * t149) - t151 * t565 + t152 * t564 - t154 * t563;
    let t567 = -(t144 * t566) - t146 * t565 - t148 * t563;
    let t568 = -(t135 * t567) - t137 * t566 - t139 * t565 - t141 * t563;
    let t569 = -(t124 * t568) - t126 * t567 - t128 * t566 - t130 * t565 - t132 * t563;
    let t570 = -(t113 * t569) - t114 * t568 + t115 * t567 - t117 * t566 - t119 * t565
        - t121 * t563;
    let t571 = -(t102 * t570) - t104 * t569 - t106 * t566 - t108 * t565 - t110 * t563;
    let t572 = t91 * t570 - t89 * t571 - t93 * t569 - t95 * t566 - t97 * t565
        - t99 * t563;
    let t573 = -(t76 * t572) - t78 * t571 - t81 * t566 - t84 * t565 - t86 * t563;
    let t574 = -(t62 * t573) - t64 * t572 - t65 * t571 - t68 * t566 + t70 * t565
        - t72 * t563;
    let t575 = -(t53 * t574) - t55 * t573 - t57 * t563;
    let t576 = -(t43 * t575) - t45 * t574 - t43 * t573 + t47 * t563;
    let drum_v_y_dot_by_bobbin_x = t557
        - R::literal(0.666_666_666_666_666_6) * (t562 - t161 * t564) + t38 * t564;
    let drum_v_x_dot_by_bobbin_x = -t555
        - R::literal(0.666_666_666_666_666_6) * (t555 * R::literal(-1.5) - t160 * t564)
        + t37 * t564;
    let bobbin_v_y_dot_by_bobbin_x = t553 - inverse_bobbin_mass * t565 - t36 * t564;
    let bobbin_v_x_dot_by_bobbin_x = t552 - inverse_bobbin_mass * t566 - t35 * t564;
    let rod_omega_dot_by_bobbin_x = t33 * t568 - R::literal(4_166.666_666_666_667) * t570
        - t34 * t567;
    let rod_v_y_dot_by_bobbin_x = -(t32 * t569) - R::literal(5.0) * t567;
    let rod_v_x_dot_by_bobbin_x = t31 * t569 - R::literal(5.0) * t568;
    let cylinder_omega_dot_by_bobbin_x = t29 * t571 - t28 * t572
        - R::literal(-2_777.777_777_777_778) * t570 + t30 * t569;
    let cylinder_v_y_dot_by_bobbin_x = t27 * t569
        - R::literal(3.333_333_333_333_333_5) * t571;
    let cylinder_v_x_dot_by_bobbin_x = -(R::literal(3.333_333_333_333_333_5) * t572)
        - t26 * t569;
    let plate_omega_dot_by_bobbin_x = t23 * t573 - t22 * t574 - t22 * t572 + t23 * t571
        + t24 * t566 - t25 * t565;
    let plate_v_y_dot_by_bobbin_x = -(R::literal(0.833_333_333_333_333_4) * t573)
        - R::literal(-0.833_333_333_333_333_4) * t571
        - R::literal(-0.833_333_333_333_333_4) * t565;
    let plate_v_x_dot_by_bobbin_x = -(R::literal(0.833_333_333_333_333_4) * t574)
        - R::literal(-0.833_333_333_333_333_4) * t572
        - R::literal(-0.833_333_333_333_333_4) * t566;
    let post_omega_dot_by_bobbin_x = t20 * t575 - t19 * t576 - t19 * t574 + t20 * t573
        - t21 * t563;
    let post_v_y_dot_by_bobbin_x = -(R::literal(1.25) * t575) - R::literal(-1.25) * t573;
    let post_v_x_dot_by_bobbin_x = -(R::literal(1.25) * t576) - R::literal(-1.25) * t574;
    let t577 = p.winding_force * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let t578 = -t509;
    let t579 = t524 / between_squared_times_between;
    let t580 = t526 * bobbin_y_minus_drum_y_squared / t514;
    let t581 = bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t582 = t518 * t581 / t514;
    let t583 = t207 / between_squared_times_between;
    let t584 = t512 * bobbin_y_minus_drum_y_squared / t514;
    let t585 = t523 * t581 / t514;
    let t586 = t519 / between_squared_times_between;
    let t587 = drum_v_x_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t588 = t584 + t585 + t586 + t587 - t579 - t580 - t582 - t583;
    let t589 = t579 + t580 + t582 + t583 - t584 - t585 - t586 - t587;
    let t590 = t577 - winding_force_over_between + t546;
    let t591 = t545 * bobbin_v_x_dot;
    let t592 = bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t593 = inverse_between - t592;
    let t594 = t593 * t239;
    let t595 = t578 - t594;
    let t596 = t545 * drum_v_x_dot;
    let t597 = t592 - inverse_between;
    let t598 = t597 * t239;
    let t599 = inverse_bobbin_mass * t590;
    let t600 = inverse_bobbin_mass * t595;
    let t601 = t151 * t599 - t600;
    let t602 = R::literal(0.666_666_666_666_666_6) * t598;
    let t603 = t37 * t546;
    let t604 = t591
        - (bobbin_v_x * t538 + bobbin_v_y * t588 + drum_v_x * t540 + drum_v_y * t589)
        - t593 * bobbin_v_y_dot - t596 - t597 * drum_v_y_dot - t35 * t590 - t36 * t595
        - t603 - t38 * t598 - t152 * t599 - t157 * t601;
    let t605 = t160 * t556;
    let t606 = t604 - t605 - t161 * t602;
    let t607 = (t154 * t599 - t159 * t601 - t164 * t606) * t166;
    let t608 = t606 * t162 - t164 * t607;
    let t609 = t601 * t155 - t157 * t608 - t159 * t607;
    let t610 = -(t599 * t149) - t151 * t609 + t152 * t608 - t154 * t607;
    let t611 = -(t144 * t610) - t146 * t609 - t148 * t607;
    let t612 = -(t135 * t611) - t137 * t610 - t139 * t609 - t141 * t607;
    let t613 = -(t124 * t612) - t126 * t611 - t128 * t610 - t130 * t609 - t132 * t607;
    let t614 = -(t113 * t613) - t114 * t612 + t115 * t611 - t117 * t610 - t119 * t609
        - t121 * t607;
    let t615 = -(t102 * t614) - t104 * t613 - t106 * t610 - t108 * t609 - t110 * t607;
    let t616 = t91 * t614 - t89 * t615 - t93 * t613 - t95 * t610 - t97 * t609
        - t99 * t607;
    let t617 = -(t76 * t616) - t78 * t615 - t81 * t610 - t84 * t609 - t86 * t607;
    let t618 = -(t62 * t617) - t64 * t616 - t65 * t615 - t68 * t610 + t70 * t609
        - t72 * t607;
    let t619 = -(t53 * t618) - t55 * t617 - t57 * t607;
    let t620 = -(t43 * t619) - t45 * t618 - t43 * t617 + t47 * t607;
    let drum_v_y_dot_by_bobbin_y = -t602
        - R::literal(0.666_666_666_666_666_6) * (t602 * R::literal(-1.5) - t161 * t608)
        + t38 * t608;
    let drum_v_x_dot_by_bobbin_y = t557
        - R::literal(0.666_666_666_666_666_6) * (t562 - t160 * t608) + t37 * t608;
    let bobbin_v_y_dot_by_bobbin_y = t600 - inverse_bobbin_mass * t609 - t36 * t608;
    let bobbin_v_x_dot_by_bobbin_y = t599 - inverse_bobbin_mass * t610 - t35 * t608;
    let rod_omega_dot_by_bobbin_y = t33 * t612 - R::literal(4_166.666_666_666_667) * t614
        - t34 * t611;
    let rod_v_y_dot_by_bobbin_y = -(t32 * t613) - R::literal(5.0) * t611;
    let rod_v_x_dot_by_bobbin_y = t31 * t613 - R::literal(5.0) * t612;
    let cylinder_omega_dot_by_bobbin_y = t29 * t615 - t28 * t616
        - R::literal(-2_777.777_777_777_778) * t614 + t30 * t613;
    let cylinder_v_y_dot_by_bobbin_y = t27 * t613
        - R::literal(3.333_333_333_333_333_5) * t615;
    let cylinder_v_x_dot_by_bobbin_y = -(R::literal(3.333_333_333_333_333_5) * t616)
        - t26 * t613;
    let plate_omega_dot_by_bobbin_y = t23 * t617 - t22 * t618 - t22 * t616 + t23 * t615
        + t24 * t610 - t25 * t609;
    let plate_v_y_dot_by_bobbin_y = -(R::literal(0.833_333_333_333_333_4) * t617)
        - R::literal(-0.833_333_333_333_333_4) * t615
        - R::literal(-0.833_333_333_333_333_4) * t609;
    let plate_v_x_dot_by_bobbin_y = -(R::literal(0.833_333_333_333_333_4) * t618)
        - R::literal(-0.833_333_333_333_333_4) * t616
        - R::literal(-0.833_333_333_333_333_4) * t610;
    let post_omega_dot_by_bobbin_y = t20 * t619 - t19 * t620 - t19 * t618 + t20 * t617
        - t21 * t607;
    let post_v_y_dot_by_bobbin_y = -(R::literal(1.25) * t619) - R::literal(-1.25) * t617;
    let post_v_x_dot_by_bobbin_y = -(R::literal(1.25) * t620) - R::literal(-1.25) * t618;
    let t621 = t578 - t550;
    let t622 = t510 - winding_force_over_between - t546;
    let t623 = inverse_bobbin_mass * t621;
    let t624 = inverse_bobbin_mass * t622;
    let t625 = t151 * t623 - t624;
    let t626 = R::literal(0.666_666_666_666_666_6) * t543;
    let t627 = -(bobbin_v_x * t539 + bobbin_v_y * t540 + drum_v_x * t529
        + drum_v_y * t538) - t549 * bobbin_v_x_dot - t548 - t542 * drum_v_x_dot + t551
        - t35 * t621 - t36 * t622 - t37 * t543 + t558 - t152 * t623;
    let t628 = t627 - t157 * t625 - t160 * t626 + t560;
    let t629 = -t562;
    let t630 = (t154 * t623 - t159 * t625 - t164 * t628) * t166;
    let t631 = t628 * t162 - t164 * t630;
    let t632 = t625 * t155 - t157 * t631 - t159 * t630;
    let t633 = -(t623 * t149) - t151 * t632 + t152 * t631 - t154 * t630;
    let t634 = -(t144 * t633) - t146 * t632 - t148 * t630;
    let t635 = -(t135 * t634) - t137 * t633 - t139 * t632 - t141 * t630;
    let t636 = -(t124 * t635) - t126 * t634 - t128 * t633 - t130 * t632 - t132 * t630;
    let t637 = -(t113 * t636) - t114 * t635 + t115 * t634 - t117 * t633 - t119 * t632
        - t121 * t630;
    let t638 = -(t102 * t637) - t104 * t636 - t106 * t633 - t108 * t632 - t110 * t630;
    let t639 = t91 * t637 - t89 * t638 - t93 * t636 - t95 * t633 - t97 * t632
        - t99 * t630;
    let t640 = -(t76 * t639) - t78 * t638 - t81 * t633 - t84 * t632 - t86 * t630;
    let t641 = -(t62 * t640) - t64 * t639 - t65 * t638 - t68 * t633 + t70 * t632
        - t72 * t630;
    let t642 = -(t53 * t641) - t55 * t640 - t57 * t630;
    let t643 = -(t43 * t642) - t45 * t641 - t43 * t640 + t47 * t630;
    let drum_v_y_dot_by_drum_x = t556
        - R::literal(0.666_666_666_666_666_6) * (t629 - t161 * t631) + t38 * t631;
    let drum_v_x_dot_by_drum_x = -t626
        - R::literal(0.666_666_666_666_666_6) * (t626 * R::literal(-1.5) - t160 * t631)
        + t37 * t631;
    let bobbin_v_y_dot_by_drum_x = t624 - inverse_bobbin_mass * t632 - t36 * t631;
    let bobbin_v_x_dot_by_drum_x = t623 - inverse_bobbin_mass * t633 - t35 * t631;
    let rod_omega_dot_by_drum_x = t33 * t635 - R::literal(4_166.666_666_666_667) * t637
        - t34 * t634;
    let rod_v_y_dot_by_drum_x = -(t32 * t636) - R::literal(5.0) * t634;
    let rod_v_x_dot_by_drum_x = t31 * t636 - R::literal(5.0) * t635;
    let cylinder_omega_dot_by_drum_x = t29 * t638 - t28 * t639
        - R::literal(-2_777.777_777_777_778) * t637 + t30 * t636;
    let cylinder_v_y_dot_by_drum_x = t27 * t636
        - R::literal(3.333_333_333_333_333_5) * t638;
    let cylinder_v_x_dot_by_drum_x = -(R::literal(3.333_333_333_333_333_5) * t639)
        - t26 * t636;
    let plate_omega_dot_by_drum_x = t23 * t640 - t22 * t641 - t22 * t639 + t23 * t638
        + t24 * t633 - t25 * t632;
    let plate_v_y_dot_by_drum_x = -(R::literal(0.833_333_333_333_333_4) * t640)
        - R::literal(-0.833_333_333_333_333_4) * t638
        - R::literal(-0.833_333_333_333_333_4) * t632;
    let plate_v_x_dot_by_drum_x = -(R::literal(0.833_333_333_333_333_4) * t641)
        - R::literal(-0.833_333_333_333_333_4) * t639
        - R::literal(-0.833_333_333_333_333_4) * t633;
    let post_omega_dot_by_drum_x = t20 * t642 - t19 * t643 - t19 * t641 + t20 * t640
        - t21 * t630;
    let post_v_y_dot_by_drum_x = -(R::literal(1.25) * t642) - R::literal(-1.25) * t640;
    let post_v_x_dot_by_drum_x = -(R::literal(1.25) * t643) - R::literal(-1.25) * t641;
    let t644 = winding_force_over_between - t577 - t546;
    let t645 = t509 - t598;
    let t646 = inverse_bobbin_mass * t644;
    let t647 = inverse_bobbin_mass * t645;
    let t648 = t151 * t646 - t647;
    let t649 = R::literal(0.666_666_666_666_666_6) * t594;
    let t650 = -(bobbin_v_x * t540 + bobbin_v_y * t589 + drum_v_x * t538
        + drum_v_y * t588) - t591 - t597 * bobbin_v_y_dot + t596 - t593 * drum_v_y_dot
        - t35 * t644 - t36 * t645 + t603 - t38 * t594 - t152 * t646;
    let t651 = t650 - t157 * t648 + t605 - t161 * t649;
    let t652 = (t154 * t646 - t159 * t648 - t164 * t651) * t166;
    let t653 = t651 * t162 - t164 * t652;
    let t654 = t648 * t155 - t157 * t653 - t159 * t652;
    let t655 = -(t646 * t149) - t151 * t654 + t152 * t653 - t154 * t652;
    let t656 = -(t144 * t655) - t146 * t654 - t148 * t652;
    let t657 = -(t135 * t656) - t137 * t655 - t139 * t654 - t141 * t652;
    let t658 = -(t124 * t657) - t126 * t656 - t128 * t655 - t130 * t654 - t132 * t652;
    let t659 = -(t113 * t658) - t114 * t657 + t115 * t656 - t117 * t655 - t119 * t654
        - t121 * t652;
    let t660 = -(t102 * t659) - t104 * t658 - t106 * t655 - t108 * t654 - t110 * t652;
    let t661 = t91 * t659 - t89 * t660 - t93 * t658 - t95 * t655 - t97 * t654
        - t99 * t652;
    let t662 = -(t76 * t661) - t78 * t660 - t81 * t655 - t84 * t654 - t86 * t652;
    let t663 = -(t62 * t662) - t64 * t661 - t65 * t660 - t68 * t655 + t70 * t654
        - t72 * t652;
    let t664 = -(t53 * t663) - t55 * t662 - t57 * t652;
    let t665 = -(t43 * t664) - t45 * t663 - t43 * t662 + t47 * t652;
    let drum_v_y_dot_by_drum_y = -t649
        - R::literal(0.666_666_666_666_666_6) * (t649 * R::literal(-1.5) - t161 * t653)
        + t38 * t653;
    let drum_v_x_dot_by_drum_y = t556
        - R::literal(0.666_666_666_666_666_6) * (t629 - t160 * t653) + t37 * t653;
    let bobbin_v_y_dot_by_drum_y = t647 - inverse_bobbin_mass * t654 - t36 * t653;
    let bobbin_v_x_dot_by_drum_y = t646 - inverse_bobbin_mass * t655 - t35 * t653;
    let rod_omega_dot_by_drum_y = t33 * t657 - R::literal(4_166.666_666_666_667) * t659
        - t34 * t656;
    let rod_v_y_dot_by_drum_y = -(t32 * t658) - R::literal(5.0) * t656;
    let rod_v_x_dot_by_drum_y = t31 * t658 - R::literal(5.0) * t657;
    let cylinder_omega_dot_by_drum_y = t29 * t660 - t28 * t661
        - R::literal(-2_777.777_777_777_778) * t659 + t30 * t658;
    let cylinder_v_y_dot_by_drum_y = t27 * t658
        - R::literal(3.333_333_333_333_333_5) * t660;
    let cylinder_v_x_dot_by_drum_y = -(R::literal(3.333_333_333_333_333_5) * t661)
        - t26 * t658;
    let plate_omega_dot_by_drum_y = t23 * t662 - t22 * t663 - t22 * t661 + t23 * t660
        + t24 * t655 - t25 * t654;
    let plate_v_y_dot_by_drum_y = -(R::literal(0.833_333_333_333_333_4) * t662)
        - R::literal(-0.833_333_333_333_333_4) * t660
        - R::literal(-0.833_333_333_333_333_4) * t654;
    let plate_v_x_dot_by_drum_y = -(R::literal(0.833_333_333_333_333_4) * t663)
        - R::literal(-0.833_333_333_333_333_4) * t661
        - R::literal(-0.833_333_333_333_333_4) * t655;
    let post_omega_dot_by_drum_y = t20 * t664 - t19 * t665 - t19 * t663 + t20 * t662
        - t21 * t652;
    let post_v_y_dot_by_drum_y = -(R::literal(1.25) * t664) - R::literal(-1.25) * t662;
    let post_v_x_dot_by_drum_y = -(R::literal(1.25) * t665) - R::literal(-1.25) * t663;
    let t666 = R::literal(0.2) * post_omega;
    let t667 = t666 * cos_post_phi;
    let t668 = t43 * t667 - t666 * sin_post_phi;
    let t669 = t45 * t667 - t667 - t53 * t668;
    let t670 = t668 - t55 * t668 - t62 * t669;
    let t671 = -(t64 * t669) - t76 * t670;
    let t672 = -(t65 * t669) - t78 * t670 - t89 * t671;
    let t673 = t91 * t671 - t102 * t672;
    let t674 = -(t93 * t671) - t104 * t672 - t113 * t673;
    let t675 = -(t114 * t673) - t124 * t674;
    let t676 = t115 * t673 - t126 * t674 - t135 * t675;
    let t677 = -(t68 * t669) - t81 * t670 - t95 * t671 - t106 * t672 - t117 * t673
        - t128 * t674 - t137 * t675 - t144 * t676;
    let t678 = t70 * t669 - t84 * t670 - t97 * t671 - t108 * t672 - t119 * t673
        - t130 * t674 - t139 * t675 - t146 * t676 - t151 * t677;
    let t679 = t152 * t677 - t157 * t678;
    let t680 = post_omega
        * (R::literal(0.286) * sin_post_phi - R::literal(0.088) * cos_post_phi)
        - t47 * t667 - t57 * t668 - t72 * t669 - t86 * t670 - t99 * t671 - t110 * t672
        - t121 * t673 - t132 * t674 - t141 * t675 - t148 * t676;
    let t681 = (t680 - t154 * t677 - t159 * t678 - t164 * t679) * t166;
    let t682 = t679 * t162 - t164 * t681;
    let t683 = t678 * t155 - t157 * t682 - t159 * t681;
    let t684 = t677 * t149 - t151 * t683 + t152 * t682 - t154 * t681;
    let t685 = t676 * t142 - t144 * t684 - t146 * t683 - t148 * t681;
    let t686 = t675 * t133 - t135 * t685 - t137 * t684 - t139 * t683 - t141 * t681;
    let t687 = t674 * t122 - t124 * t686 - t126 * t685 - t128 * t684 - t130 * t683
        - t132 * t681;
    let t688 = t673 * t111 - t113 * t687 - t114 * t686 + t115 * t685 - t117 * t684
        - t119 * t683 - t121 * t681;
    let t689 = t672 * t100 - t102 * t688 - t104 * t687 - t106 * t684 - t108 * t683
        - t110 * t681;
    let t690 = t671 * t87 - t89 * t689 + t91 * t688 - t93 * t687 - t95 * t684
        - t97 * t683 - t99 * t681;
    let t691 = t670 * t74 - t76 * t690 - t78 * t689 - t81 * t684 - t84 * t683
        - t86 * t681;
    let t692 = t669 * t59 - t62 * t691 - t64 * t690 - t65 * t689 - t68 * t684
        + t70 * t683 - t72 * t681;
    let t693 = t668 * t51 - t53 * t692 - t55 * t691 - t57 * t681;
    let t694 = -(t667 * t41) - t43 * t693 - t45 * t692 - t43 * t691 + t47 * t681;
    let drum_v_y_dot_by_post_omega = R::literal(0.666_666_666_666_666_6) * (t161 * t682)
        + t38 * t682;
    let drum_v_x_dot_by_post_omega = R::literal(0.666_666_666_666_666_6) * (t160 * t682)
        + t37 * t682;
    let bobbin_v_y_dot_by_post_omega = -(inverse_bobbin_mass * t683) - t36 * t682;
    let bobbin_v_x_dot_by_post_omega = -(inverse_bobbin_mass * t684) - t35 * t682;
    let rod_omega_dot_by_post_omega = t33 * t686
        - R::literal(4_166.666_666_666_667) * t688 - t34 * t685;
    let rod_v_y_dot_by_post_omega = -(t32 * t687) - R::literal(5.0) * t685;
    let rod_v_x_dot_by_post_omega = t31 * t687 - R::literal(5.0) * t686;
    let cylinder_omega_dot_by_post_omega = t29 * t689 - t28 * t690
        - R::literal(-2_777.777_777_777_778) * t688 + t30 * t687;
    let cylinder_v_y_dot_by_post_omega = t27 * t687
        - R::literal(3.333_333_333_333_333_5) * t689;
    let cylinder_v_x_dot_by_post_omega = -(R::literal(3.333_333_333_333_333_5) * t690)
        - t26 * t687;
    let plate_omega_dot_by_post_omega = t23 * t691 - t22 * t692 - t22 * t690 + t23 * t689
        + t24 * t684 - t25 * t683;
    let plate_v_y_dot_by_post_omega = -(R::literal(0.833_333_333_333_333_4) * t691)
        - R::literal(-0.833_333_333_333_333_4) * t689
        - R::literal(-0.833_333_333_333_333_4) * t683;
    let plate_v_x_dot_by_post_omega = -(R::literal(0.833_333_333_333_333_4) * t692)
        - R::literal(-0.833_333_333_333_333_4) * t690
        - R::literal(-0.833_333_333_333_333_4) * t684;
    let post_omega_dot_by_post_omega = t20 * t693 - t19 * t694 - t19 * t692 + t20 * t691
        - t21 * t681;
    let post_v_y_dot_by_post_omega = -(R::literal(1.25) * t693)
        - R::literal(-1.25) * t691;
    let post_v_x_dot_by_post_omega = -(R::literal(1.25) * t694)
        - R::literal(-1.25) * t692;
    let t695 = R::literal(0.12) * plate_omega;
    let t696 = t695 * cos_plate_phi;
    let t697 = t695 * sin_plate_phi;
    let t698 = t62 * t696 - t697;
    let t699 = t64 * t696 - t696 - t76 * t698;
    let t700 = t65 * t696 - t697 - t78 * t698 - t89 * t699;
    let t701 = t91 * t699 - t102 * t700;
    let t702 = -(t93 * t699) - t104 * t700 - t113 * t701;
    let t703 = -(t114 * t701) - t124 * t702;
    let t704 = t115 * t701 - t126 * t702 - t135 * t703;
    let t705 = plate_omega
        * (R::literal(0.02) * cos_plate_phi - R::literal(0.2) * sin_plate_phi)
        + t68 * t696 - t81 * t698 - t95 * t699 - t106 * t700 - t117 * t701 - t128 * t702
        - t137 * t703 - t144 * t704;
    let t706 = plate_omega
        * (R::literal(0.02) * sin_plate_phi + R::literal(0.2) * cos_plate_phi)
        - t70 * t696 - t84 * t698 - t97 * t699 - t108 * t700 - t119 * t701 - t130 * t702
        - t139 * t703 - t146 * t704 - t151 * t705;
    let t707 = t152 * t705 - t157 * t706;
    let t708 = (t72 * t696 - t86 * t698 - t99 * t699 - t110 * t700 - t121 * t701
        - t132 * t702 - t141 * t703 - t148 * t704 - t154 * t705 - t159 * t706
        - t164 * t707) * t166;
    let t709 = t707 * t162 - t164 * t708;
    let t710 = t706 * t155 - t157 * t709 - t159 * t708;
    let t711 = t705 * t149 - t151 * t710 + t152 * t709 - t154 * t708;
    let t712 = t704 * t142 - t144 * t711 - t146 * t710 - t148 * t708;
    let t713 = t703 * t133 - t135 * t712 - t137 * t711 - t139 * t710 - t141 * t708;
    let t714 = t702 * t122 - t124 * t713 - t126 * t712 - t128 * t711 - t130 * t710
        - t132 * t708;
    let t715 = t701 * t111 - t113 * t714 - t114 * t713 + t115 * t712 - t117 * t711
        - t119 * t710 - t121 * t708;
    let t716 = t700 * t100 - t102 * t715 - t104 * t714 - t106 * t711 - t108 * t710
        - t110 * t708;
    let t717 = t699 * t87 - t89 * t716 + t91 * t715 - t93 * t714 - t95 * t711
        - t97 * t710 - t99 * t708;
    let t718 = t698 * t74 - t76 * t717 - t78 * t716 - t81 * t711 - t84 * t710
        - t86 * t708;
    let t719 = -(t696 * t59) - t62 * t718 - t64 * t717 - t65 * t716 - t68 * t711
        + t70 * t710 - t72 * t708;
    let t720 = -(t53 * t719) - t55 * t718 - t57 * t708;
    let t721 = -(t43 * t720) - t45 * t719 - t43 * t718 + t47 * t708;
    let drum_v_y_dot_by_plate_omega = R::literal(0.666_666_666_666_666_6) * (t161 * t709)
        + t38 * t709;
    let drum_v_x_dot_by_plate_omega = R::literal(0.666_666_666_666_666_6) * (t160 * t709)
        + t37 * t709;
    let bobbin_v_y_dot_by_plate_omega = -(inverse_bobbin_mass * t710) - t36 * t709;
    let bobbin_v_x_dot_by_plate_omega = -(inverse_bobbin_mass * t711) - t35 * t709;
    let rod_omega_dot_by_plate_omega = t33 * t713
        - R::literal(4_166.666_666_666_667) * t715 - t34 * t712;
    let rod_v_y_dot_by_plate_omega = -(t32 * t714) - R::literal(5.0) * t712;
    let rod_v_x_dot_by_plate_omega = t31 * t714 - R::literal(5.0) * t713;
    let cylinder_omega_dot_by_plate_omega = t29 * t716 - t28 * t717
        - R::literal(-2_777.777_777_777_778) * t715 + t30 * t714;
    let cylinder_v_y_dot_by_plate_omega = t27 * t714
        - R::literal(3.333_333_333_333_333_5) * t716;
    let cylinder_v_x_dot_by_plate_omega = -(R::literal(3.333_333_333_333_333_5) * t717)
        - t26 * t714;
    let plate_omega_dot_by_plate_omega = t23 * t718 - t22 * t719 - t22 * t717
        + t23 * t716 + t24 * t711 - t25 * t710;
    let plate_v_y_dot_by_plate_omega = -(R::literal(0.833_333_333_333_333_4) * t718)
        - R::literal(-0.833_333_333_333_333_4) * t716
        - R::literal(-0.833_333_333_333_333_4) * t710;
    let plate_v_x_dot_by_plate_omega = -(R::literal(0.833_333_333_333_333_4) * t719)
        - R::literal(-0.833_333_333_333_333_4) * t717
        - R::literal(-0.833_333_333_333_333_4) * t711;
    let post_omega_dot_by_plate_omega = t20 * t720 - t19 * t721 - t19 * t719 + t20 * t718
        - t21 * t708;
    let post_v_y_dot_by_plate_omega = -(R::literal(1.25) * t720)
        - R::literal(-1.25) * t718;
    let post_v_x_dot_by_plate_omega = -(R::literal(1.25) * t721)
        - R::literal(-1.25) * t719;
    let t722 = R::literal(50.0) * (cos_cylinder_phi * cos_cylinder_phi);
    let t723 = R::literal(50.0) * sin_cylinder_phi * cos_cylinder_phi;
    let t724 = R::literal(50.0) * t14;
    let t725 = t724 * cos_cylinder_phi;
    let t726 = R::literal(2.0) * cylinder_omega;
    let t727 = t726 * cos_cylinder_phi;
    let t728 = R::literal(3.333_333_333_333_333_5) * t722;
    let t729 = t28 * t725;
    let t730 = t728 - t729;
    let t731 = R::literal(3.333_333_333_333_333_5) * t723;
    let t732 = -t731;
    let t733 = t29 * t725;
    let t734 = t731 + t733 - t89 * t730;
    let t735 = R::literal(-2_777.777_777_777_778) * t725;
    let t736 = t91 * t730 - t735 - t102 * t734;
    let t737 = t26 * t722;
    let t738 = t27 * t723;
    let t739 = t30 * t725;
    let t740 = t31 * t722;
    let t741 = t32 * t723;
    let t742 = t737 - t727 - t738 + t739 + t740 - t741 - t93 * t730 - t104 * t734
        - t113 * t736;
    let t743 = R::literal(5.0) * t722;
    let t744 = -t743 - t114 * t736 - t124 * t742;
    let t745 = R::literal(5.0) * t723;
    let t746 = -t745;
    let t747 = t115 * t736 - t745 - t126 * t742 - t135 * t744;
    let t748 = -(t95 * t730) - t106 * t734 - t117 * t736 - t128 * t742 - t137 * t744
        - t144 * t747;
    let t749 = -(t97 * t730) - t108 * t734 - t119 * t736 - t130 * t742 - t139 * t744
        - t146 * t747 - t151 * t748;
    let t750 = t152 * t748 - t157 * t749;
    let t751 = t725 * R::literal(2_777.777_777_777_778);
    let t752 = (-(t99 * t730) - t110 * t734 - t121 * t736 - t132 * t742 - t141 * t744
        - t148 * t747 - t154 * t748 - t159 * t749 - t164 * t750) * t166;
    let t753 = t750 * t162 - t164 * t752;
    let t754 = t749 * t155 - t157 * t753 - t159 * t752;
    let t755 = t748 * t149 - t151 * t754 + t152 * t753 - t154 * t752;
    let t756 = t747 * t142 - t144 * t755 - t146 * t754 - t148 * t752;
    let t757 = t744 * t133 - t135 * t756 - t137 * t755 - t139 * t754 - t141 * t752;
    let t758 = t742 * t122 - t124 * t757 - t126 * t756 - t128 * t755 - t130 * t754
        - t132 * t752;
    let t759 = t736 * t111 - t113 * t758 - t114 * t757 + t115 * t756 - t117 * t755
        - t119 * t754 - t121 * t752;
    let t760 = t734 * t100 - t102 * t759 - t104 * t758 - t106 * t755 - t108 * t754
        - t110 * t752;
    let t761 = t730 * t87 - t89 * t760 + t91 * t759 - t93 * t758 - t95 * t755
        - t97 * t754 - t99 * t752;
    let t762 = -(t76 * t761) - t78 * t760 - t81 * t755 - t84 * t754 - t86 * t752;
    let t763 = -(t62 * t762) - t64 * t761 - t65 * t760 - t68 * t755 + t70 * t754
        - t72 * t752;
    let t764 = -(t53 * t763) - t55 * t762 - t57 * t752;
    let t765 = -(t43 * t764) - t45 * t763 - t43 * t762 + t47 * t752;
    let drum_v_y_dot_by_cylinder_v_x = R::literal(0.666_666_666_666_666_6)
        * (t161 * t753) + t38 * t753;
    let drum_v_x_dot_by_cylinder_v_x = R::literal(0.666_666_666_666_666_6)
        * (t160 * t753) + t37 * t753;
    let bobbin_v_y_dot_by_cylinder_v_x = -(inverse_bobbin_mass * t754) - t36 * t753;
    let bobbin_v_x_dot_by_cylinder_v_x = -(inverse_bobbin_mass * t755) - t35 * t753;
    let rod_omega_dot_by_cylinder_v_x = t33 * t757
        - R::literal(4_166.666_666_666_667) * t759 - t34 * t756;
    let rod_v_y_dot_by_cylinder_v_x = t745 - t32 * t758 - R::literal(5.0) * t756;
    let rod_v_x_dot_by_cylinder_v_x = t743 + t31 * t758 - R::literal(5.0) * t757;
    let cylinder_omega_dot_by_cylinder_v_x = t751 - t28 * t761 + t29 * t760
        - R::literal(-2_777.777_777_777_778) * t759 + t30 * t758;
    let cylinder_v_y_dot_by_cylinder_v_x = t732
        - R::literal(3.333_333_333_333_333_5) * t760 + t27 * t758;
    let cylinder_v_x_dot_by_cylinder_v_x = -t728
        - R::literal(3.333_333_333_333_333_5) * t761 - t26 * t758;
    let plate_omega_dot_by_cylinder_v_x = t23 * t762 - t22 * t763 - t22 * t761
        + t23 * t760 + t24 * t755 - t25 * t754;
    let plate_v_y_dot_by_cylinder_v_x = -(R::literal(0.833_333_333_333_333_4) * t762)
        - R::literal(-0.833_333_333_333_333_4) * t760
        - R::literal(-0.833_333_333_333_333_4) * t754;
    let plate_v_x_dot_by_cylinder_v_x = -(R::literal(0.833_333_333_333_333_4) * t763)
        - R::literal(-0.833_333_333_333_333_4) * t761
        - R::literal(-0.833_333_333_333_333_4) * t755;
    let post_omega_dot_by_cylinder_v_x = t20 * t764 - t19 * t765 - t19 * t763
        + t20 * t762 - t21 * t752;
    let post_v_y_dot_by_cylinder_v_x = -(R::literal(1.25) * t764)
        - R::literal(-1.25) * t762;
    let post_v_x_dot_by_cylinder_v_x = -(R::literal(1.25) * t765)
        - R::literal(-1.25) * t763;
    let t766 = R::literal(50.0) * (sin_cylinder_phi * sin_cylinder_phi);
    let t767 = t724 * sin_cylinder_phi;
    let t768 = t726 * sin_cylinder_phi;
    let t769 = t28 * t767;
    let t770 = t731 - t769;
    let t771 = R::literal(3.333_333_333_333_333_5) * t766;
    let t772 = -t771;
    let t773 = t29 * t767;
    let t774 = t771 + t773 - t89 * t770;
    let t775 = R::literal(-2_777.777_777_777_778) * t767;
    let t776 = t91 * t770 - t775 - t102 * t774;
    let t777 = t26 * t723;
    let t778 = t27 * t766;
    let t779 = t30 * t767;
    let t780 = t31 * t723;
    let t781 = t32 * t766;
    let t782 = t777 - t768 - t778 + t779 + t780 - t781 - t93 * t770 - t104 * t774
        - t113 * t776;
    let t783 = t746 - t114 * t776 - t124 * t782;
    let t784 = R::literal(5.0) * t766;
    let t785 = t115 * t776 - t784 - t126 * t782 - t135 * t783;
    let t786 = -(t95 * t770) - t106 * t774 - t117 * t776 - t128 * t782 - t137 * t783
        - t144 * t785;
    let t787 = -(t97 * t770) - t108 * t774 - t119 * t776 - t130 * t782 - t139 * t783
        - t146 * t785 - t151 * t786;
    let t788 = t152 * t786 - t157 * t787;
    let t789 = t767 * R::literal(2_777.777_777_777_778);
    let t790 = (-(t99 * t770) - t110 * t774 - t121 * t776 - t132 * t782 - t141 * t783
        - t148 * t785 - t154 * t786 - t159 * t787 - t164 * t788) * t166;
    let t791 = t788 * t162 - t164 * t790;
    let t792 = t787 * t155 - t157 * t791 - t159 * t790;
    let t793 = t786 * t149 - t151 * t792 + t152 * t791 - t154 * t790;
    let t794 = t785 * t142 - t144 * t793 - t146 * t792 - t148 * t790;
    let t795 = t783 * t133 - t135 * t794 - t137 * t793 - t139 * t792 - t141 * t790;
    let t796 = t782 * t122 - t124 * t795 - t126 * t794 - t128 * t793 - t130 * t792
        - t132 * t790;
    let t797 = t776 * t111 - t113 * t796 - t114 * t795 + t115 * t794 - t117 * t793
        - t119 * t792 - t121 * t790;
    let t798 = t774 * t100 - t102 * t797 - t104 * t796 - t106 * t793 - t108 * t792
        - t110 * t790;
    let t799 = t770 * t87 - t89 * t798 + t91 * t797 - t93 * t796 - t95 * t793
        - t97 * t792 - t99 * t790;
    let t800 = -(t76 * t799) - t78 * t798 - t81 * t793 - t84 * t792 - t86 * t790;
    let t801 = -(t62 * t800) - t64 * t799 - t65 * t798 - t68 * t793 + t70 * t792
        - t72 * t790;
    let t802 = -(t53 * t801) - t55 * t800 - t57 * t790;
    let t803 = -(t43 * t802) - t45 * t801 - t43 * t800 + t47 * t790;
    let drum_v_y_dot_by_cylinder_v_y = R::literal(0.666_666_666_666_666_6)
        * (t161 * t791) + t38 * t791;
    let drum_v_x_dot_by_cylinder_v_y = R::literal(0.666_666_666_666_666_6)
        * (t160 * t791) + t37 * t791;
    let bobbin_v_y_dot_by_cylinder_v_y = -(inverse_bobbin_mass * t792) - t36 * t791;
    let bobbin_v_x_dot_by_cylinder_v_y = -(inverse_bobbin_mass * t793) - t35 * t791;
    let rod_omega_dot_by_cylinder_v_y = t33 * t795
        - R::literal(4_166.666_666_666_667) * t797 - t34 * t794;
    let rod_v_y_dot_by_cylinder_v_y = t784 - t32 * t796 - R::literal(5.0) * t794;
    let rod_v_x_dot_by_cylinder_v_y = t745 + t31 * t796 - R::literal(5.0) * t795;
    let cylinder_omega_dot_by_cylinder_v_y = t789 - t28 * t799 + t29 * t798
        - R::literal(-2_777.777_777_777_778) * t797 + t30 * t796;
    let cylinder_v_y_dot_by_cylinder_v_y = t772
        - R::literal(3.333_333_333_333_333_5) * t798 + t27 * t796;
    let cylinder_v_x_dot_by_cylinder_v_y = t732
        - R::literal(3.333_333_333_333_333_5) * t799 - t26 * t796;
    let plate_omega_dot_by_cylinder_v_y = t23 * t800 - t22 * t801 - t22 * t799
        + t23 * t798 + t24 * t793 - t25 * t792;
    let plate_v_y_dot_by_cylinder_v_y = -(R::literal(0.833_333_333_333_333_4) * t800)
        - R::literal(-0.833_333_333_333_333_4) * t798
        - R::literal(-0.833_333_333_333_333_4) * t792;
    let plate_v_x_dot_by_cylinder_v_y = -(R::literal(0.833_333_333_333_333_4) * t801)
        - R::literal(-0.833_333_333_333_333_4) * t799
        - R::literal(-0.833_333_333_333_333_4) * t793;
    let post_omega_dot_by_cylinder_v_y = t20 * t802 - t19 * t803 - t19 * t801
        + t20 * t800 - t21 * t790;
    let post_v_y_dot_by_cylinder_v_y = -(R::literal(1.25) * t802)
        - R::literal(-1.25) * t800;
    let post_v_x_dot_by_cylinder_v_y = -(R::literal(1.25) * t803)
        - R::literal(-1.25) * t801;
    let t804 = R::literal(50.0) * t395;
    let t805 = R::literal(0.12) * cylinder_omega;
    let t806 = R::literal(3.333_333_333_333_333_5) * t725;
    let t807 = -(t805 * cos_cylinder_phi) - t806 + t28 * t804;
    let t808 = R::literal(3.333_333_333_333_333_5) * t767;
    let t809 = -(t805 * sin_cylinder_phi) - t808 - t29 * t804 - t89 * t807;
    let t810 = R::literal(-2_777.777_777_777_778) * t804 + t91 * t807 - t102 * t809;
    let t811 = R::literal(2.0)
        * (t196 + t197 + rod_v_x * cos_cylinder_phi + rod_v_y * sin_cylinder_phi - t192
            - t193 - cylinder_v_x * cos_cylinder_phi - cylinder_v_y * sin_cylinder_phi)
        - t26 * t725 + t27 * t767 - t30 * t804 - t31 * t725 + t32 * t767 - t93 * t807;
    let t812 = t811 - t104 * t809 - t113 * t810;
    let t813 = R::literal(5.0) * t725;
    let t814 = t813 - t114 * t810 - t124 * t812;
    let t815 = R::literal(5.0) * t767;
    let t816 = t815 + t115 * t810 - t126 * t812 - t135 * t814;
    let t817 = -(t95 * t807) - t106 * t809 - t117 * t810 - t128 * t812 - t137 * t814
        - t144 * t816;
    let t818 = -(t97 * t807) - t108 * t809 - t119 * t810 - t130 * t812 - t139 * t814
        - t146 * t816 - t151 * t817;
    let t819 = t152 * t817 - t157 * t818;
    let t820 = (-(t99 * t807) - t110 * t809 - t121 * t810 - t132 * t812 - t141 * t814
        - t148 * t816 - t154 * t817 - t159 * t818 - t164 * t819) * t166;
    let t821 = t819 * t162 - t164 * t820;
    let t822 = t818 * t155 - t157 * t821 - t159 * t820;
    let t823 = t817 * t149 - t151 * t822 + t152 * t821 - t154 * t820;
    let t824 = t816 * t142 - t144 * t823 - t146 * t822 - t148 * t820;
    let t825 = t814 * t133 - t135 * t824 - t137 * t823 - t139 * t822 - t141 * t820;
    let t826 = t812 * t122 - t124 * t825 - t126 * t824 - t128 * t823 - t130 * t822
        - t132 * t820;
    let t827 = t810 * t111 - t113 * t826 - t114 * t825 + t115 * t824 - t117 * t823
        - t119 * t822 - t121 * t820;
    let t828 = t809 * t100 - t102 * t827 - t104 * t826 - t106 * t823 - t108 * t822
        - t110 * t820;
    let t829 = t807 * t87 - t89 * t828 + t91 * t827 - t93 * t826 - t95 * t823
        - t97 * t822 - t99 * t820;
    let t830 = -(t76 * t829) - t78 * t828 - t81 * t823 - t84 * t822 - t86 * t820;
    let t831 = -(t62 * t830) - t64 * t829 - t65 * t828 - t68 * t823 + t70 * t822
        - t72 * t820;
    let t832 = -(t53 * t831) - t55 * t830 - t57 * t820;
    let t833 = -(t43 * t832) - t45 * t831 - t43 * t830 + t47 * t820;
    let drum_v_y_dot_by_cylinder_omega = R::literal(0.666_666_666_666_666_6)
        * (t161 * t821) + t38 * t821;
    let drum_v_x_dot_by_cylinder_omega = R::literal(0.666_666_666_666_666_6)
        * (t160 * t821) + t37 * t821;
    let bobbin_v_y_dot_by_cylinder_omega = -(inverse_bobbin_mass * t822) - t36 * t821;
    let bobbin_v_x_dot_by_cylinder_omega = -(inverse_bobbin_mass * t823) - t35 * t821;
    let rod_omega_dot_by_cylinder_omega = t33 * t825
        - R::literal(4_166.666_666_666_667) * t827 - t34 * t824;
    let rod_v_y_dot_by_cylinder_omega = -t815 - t32 * t826 - R::literal(5.0) * t824;
    let rod_v_x_dot_by_cylinder_omega = t31 * t826 - t813 - R::literal(5.0) * t825;
    let cylinder_omega_dot_by_cylinder_omega = -(t804
        * R::literal(2_777.777_777_777_778)) - t28 * t829 + t29 * t828
        - R::literal(-2_777.777_777_777_778) * t827 + t30 * t826;
    let cylinder_v_y_dot_by_cylinder_omega = t808
        - R::literal(3.333_333_333_333_333_5) * t828 + t27 * t826;
    let cylinder_v_x_dot_by_cylinder_omega = t806
        - R::literal(3.333_333_333_333_333_5) * t829 - t26 * t826;
    let plate_omega_dot_by_cylinder_omega = t23 * t830 - t22 * t831 - t22 * t829
        + t23 * t828 + t24 * t823 - t25 * t822;
    let plate_v_y_dot_by_cylinder_omega = -(R::literal(0.833_333_333_333_333_4) * t830)
        - R::literal(-0.833_333_333_333_333_4) * t828
        - R::literal(-0.833_333_333_333_333_4) * t822;
    let plate_v_x_dot_by_cylinder_omega = -(R::literal(0.833_333_333_333_333_4) * t831)
        - R::literal(-0.833_333_333_333_333_4) * t829
        - R::literal(-0.833_333_333_333_333_4) * t823;
    let post_omega_dot_by_cylinder_omega = t20 * t832 - t19 * t833 - t19 * t831
        + t20 * t830 - t21 * t820;
    let post_v_y_dot_by_cylinder_omega = -(R::literal(1.25) * t832)
        - R::literal(-1.25) * t830;
    let post_v_x_dot_by_cylinder_omega = -(R::literal(1.25) * t833)
        - R::literal(-1.25) * t831;
    let t834 = t729 - t728;
    let t835 = t732 - t733 - t89 * t834;
    let t836 = t735 + t91 * t834 - t102 * t835;
    let t837 = t727 - t737 + t738 - t739 - t740 + t741 - t93 * t834 - t104 * t835
        - t113 * t836;
    let t838 = t743 - t114 * t836 - t124 * t837;
    let t839 = t745 + t115 * t836 - t126 * t837 - t135 * t838;
    let t840 = -(t95 * t834) - t106 * t835 - t117 * t836 - t128 * t837 - t137 * t838
        - t144 * t839;
    let t841 = -(t97 * t834) - t108 * t835 - t119 * t836 - t130 * t837 - t139 * t838
        - t146 * t839 - t151 * t840;
    let t842 = t152 * t840 - t157 * t841;
    let t843 = (-(t99 * t834) - t110 * t835 - t121 * t836 - t132 * t837 - t141 * t838
        - t148 * t839 - t154 * t840 - t159 * t841 - t164 * t842) * t166;
    let t844 = t842 * t162 - t164 * t843;
    let t845 = t841 * t155 - t157 * t844 - t159 * t843;
    let t846 = t840 * t149 - t151 * t845 + t152 * t844 - t154 * t843;
    let t847 = t839 * t142 - t144 * t846 - t146 * t845 - t148 * t843;
    let t848 = t838 * t133 - t135 * t847 - t137 * t846 - t139 * t845 - t141 * t843;
    let t849 = t837 * t122 - t124 * t848 - t126 * t847 - t128 * t846 - t130 * t845
        - t132 * t843;
    let t850 = t836 * t111 - t113 * t849 - t114 * t848 + t115 * t847 - t117 * t846
        - t119 * t845 - t121 * t843;
    let t851 = t835 * t100 - t102 * t850 - t104 * t849 - t106 * t846 - t108 * t845
        - t110 * t843;
    let t852 = t834 * t87 - t89 * t851 + t91 * t850 - t93 * t849 - t95 * t846
        - t97 * t845 - t99 * t843;
    let t853 = -(t76 * t852) - t78 * t851 - t81 * t846 - t84 * t845 - t86 * t843;
    let t854 = -(t62 * t853) - t64 * t852 - t65 * t851 - t68 * t846 + t70 * t845
        - t72 * t843;
    let t855 = -(t53 * t854) - t55 * t853 - t57 * t843;
    let t856 = -(t43 * t855) - t45 * t854 - t43 * t853 + t47 * t843;
    let drum_v_y_dot_by_rod_v_x = R::literal(0.666_666_666_666_666_6) * (t161 * t844)
        + t38 * t844;
    let drum_v_x_dot_by_rod_v_x = R::literal(0.666_666_666_666_666_6) * (t160 * t844)
        + t37 * t844;
    let bobbin_v_y_dot_by_rod_v_x = -(inverse_bobbin_mass * t845) - t36 * t844;
    let bobbin_v_x_dot_by_rod_v_x = -(inverse_bobbin_mass * t846) - t35 * t844;
    let rod_omega_dot_by_rod_v_x = t33 * t848 - R::literal(4_166.666_666_666_667) * t850
        - t34 * t847;
    let rod_v_y_dot_by_rod_v_x = t746 - t32 * t849 - R::literal(5.0) * t847;
    let rod_v_x_dot_by_rod_v_x = t31 * t849 - t743 - R::literal(5.0) * t848;
    let cylinder_omega_dot_by_rod_v_x = -t751 - t28 * t852 + t29 * t851
        - R::literal(-2_777.777_777_777_778) * t850 + t30 * t849;
    let cylinder_v_y_dot_by_rod_v_x = t731 - R::literal(3.333_333_333_333_333_5) * t851
        + t27 * t849;
    let cylinder_v_x_dot_by_rod_v_x = t728 - R::literal(3.333_333_333_333_333_5) * t852
        - t26 * t849;
    let plate_omega_dot_by_rod_v_x = t23 * t853 - t22 * t854 - t22 * t852 + t23 * t851
        + t24 * t846 - t25 * t845;
    let plate_v_y_dot_by_rod_v_x = -(R::literal(0.833_333_333_333_333_4) * t853)
        - R::literal(-0.833_333_333_333_333_4) * t851
        - R::literal(-0.833_333_333_333_333_4) * t845;
    let plate_v_x_dot_by_rod_v_x = -(R::literal(0.833_333_333_333_333_4) * t854)
        - R::literal(-0.833_333_333_333_333_4) * t852
        - R::literal(-0.833_333_333_333_333_4) * t846;
    let post_omega_dot_by_rod_v_x = t20 * t855 - t19 * t856 - t19 * t854 + t20 * t853
        - t21 * t843;
    let post_v_y_dot_by_rod_v_x = -(R::literal(1.25) * t855) - R::literal(-1.25) * t853;
    let post_v_x_dot_by_rod_v_x = -(R::literal(1.25) * t856) - R::literal(-1.25) * t854;
    let t857 = t769 - t731;
    let t858 = t772 - t773 - t89 * t857;
    let t859 = t775 + t91 * t857 - t102 * t858;
    let t860 = t768 - t777 + t778 - t779 - t780 + t781 - t93 * t857 - t104 * t858
        - t113 * t859;
    let t861 = t745 - t114 * t859 - t124 * t860;
    let t862 = t784 + t115 * t859 - t126 * t860 - t135 * t861;
    let t863 = -(t95 * t857) - t106 * t858 - t117 * t859 - t128 * t860 - t137 * t861
        - t144 * t862;
    let t864 = -(t97 * t857) - t108 * t858 - t119 * t859 - t130 * t860 - t139 * t861
        - t146 * t862 - t151 * t863;
    let t865 = t152 * t863 - t157 * t864;
    let t866 = (-(t99 * t857) - t110 * t858 - t121 * t859 - t132 * t860 - t141 * t861
        - t148 * t862 - t154 * t863 - t159 * t864 - t164 * t865) * t166;
    let t867 = t865 * t162 - t164 * t866;
    let t868 = t864 * t155 - t157 * t867 - t159 * t866;
    let t869 = t863 * t149 - t151 * t868 + t152 * t867 - t154 * t866;
    let t870 = t862 * t142 - t144 * t869 - t146 * t868 - t148 * t866;
    let t871 = t861 * t133 - t135 * t870 - t137 * t869 - t139 * t868 - t141 * t866;
    let t872 = t860 * t122 - t124 * t871 - t126 * t870 - t128 * t869 - t130 * t868
        - t132 * t866;
    let t873 = t859 * t111 - t113 * t872 - t114 * t871 + t115 * t870 - t117 * t869
        - t119 * t868 - t121 * t866;
    let t874 = t858 * t100 - t102 * t873 - t104 * t872 - t106 * t869 - t108 * t868
        - t110 * t866;
    let t875 = t857 * t87 - t89 * t874 + t91 * t873 - t93 * t872 - t95 * t869
        - t97 * t868 - t99 * t866;
    let t876 = -(t76 * t875) - t78 * t874 - t81 * t869 - t84 * t868 - t86 * t866;
    let t877 = -(t62 * t876) - t64 * t875 - t65 * t874 - t68 * t869 + t70 * t868
        - t72 * t866;
    let t878 = -(t53 * t877) - t55 * t876 - t57 * t866;
    let t879 = -(t43 * t878) - t45 * t877 - t43 * t876 + t47 * t866;
    let drum_v_y_dot_by_rod_v_y = R::literal(0.666_666_666_666_666_6) * (t161 * t867)
        + t38 * t867;
    let drum_v_x_dot_by_rod_v_y = R::literal(0.666_666_666_666_666_6) * (t160 * t867)
        + t37 * t867;
    let bobbin_v_y_dot_by_rod_v_y = -(inverse_bobbin_mass * t868) - t36 * t867;
    let bobbin_v_x_dot_by_rod_v_y = -(inverse_bobbin_mass * t869) - t35 * t867;
    let rod_omega_dot_by_rod_v_y = t33 * t871 - R::literal(4_166.666_666_666_667) * t873
        - t34 * t870;
    let rod_v_y_dot_by_rod_v_y = -t784 - t32 * t872 - R::literal(5.0) * t870;
    let rod_v_x_dot_by_rod_v_y = t31 * t872 - t745 - R::literal(5.0) * t871;
    let cylinder_omega_dot_by_rod_v_y = -t789 - t28 * t875 + t29 * t874
        - R::literal(-2_777.777_777_777_778) * t873 + t30 * t872;
    let cylinder_v_y_dot_by_rod_v_y = t771 - R::literal(3.333_333_333_333_333_5) * t874
        + t27 * t872;
    let cylinder_v_x_dot_by_rod_v_y = t731 - R::literal(3.333_333_333_333_333_5) * t875
        - t26 * t872;
    let plate_omega_dot_by_rod_v_y = t23 * t876 - t22 * t877 - t22 * t875 + t23 * t874
        + t24 * t869 - t25 * t868;
    let plate_v_y_dot_by_rod_v_y = -(R::literal(0.833_333_333_333_333_4) * t876)
        - R::literal(-0.833_333_333_333_333_4) * t874
        - R::literal(-0.833_333_333_333_333_4) * t868;
    let plate_v_x_dot_by_rod_v_y = -(R::literal(0.833_333_333_333_333_4) * t877)
        - R::literal(-0.833_333_333_333_333_4) * t875
        - R::literal(-0.833_333_333_333_333_4) * t869;
    let post_omega_dot_by_rod_v_y = t20 * t878 - t19 * t879 - t19 * t877 + t20 * t876
        - t21 * t866;
    let post_v_y_dot_by_rod_v_y = -(R::literal(1.25) * t878) - R::literal(-1.25) * t876;
    let post_v_x_dot_by_rod_v_y = -(R::literal(1.25) * t879) - R::literal(-1.25) * t877;
    let t880 = R::literal(0.12) * rod_omega;
    let t881 = t880 * cos_rod_phi;
    let t882 = t880 * sin_rod_phi - t135 * t881;
    let t883 = -(t137 * t881) - t144 * t882;
    let t884 = -(t139 * t881) - t146 * t882 - t151 * t883;
    let t885 = t152 * t883 - t157 * t884;
    let t886 = (-(t141 * t881) - t148 * t882 - t154 * t883 - t159 * t884 - t164 * t885)
        * t166;
    let t887 = t885 * t162 - t164 * t886;
    let t888 = t884 * t155 - t157 * t887 - t159 * t886;
    let t889 = t883 * t149 - t151 * t888 + t152 * t887 - t154 * t886;
    let t890 = t882 * t142 - t144 * t889 - t146 * t888 - t148 * t886;
    let t891 = t881 * t133 - t135 * t890 - t137 * t889 - t139 * t888 - t141 * t886;
    let t892 = -(t124 * t891) - t126 * t890 - t128 * t889 - t130 * t888 - t132 * t886;
    let t893 = -(t113 * t892) - t114 * t891 + t115 * t890 - t117 * t889 - t119 * t888
        - t121 * t886;
    let t894 = -(t102 * t893) - t104 * t892 - t106 * t889 - t108 * t888 - t110 * t886;
    let t895 = t91 * t893 - t89 * t894 - t93 * t892 - t95 * t889 - t97 * t888
        - t99 * t886;
    let t896 = -(t76 * t895) - t78 * t894 - t81 * t889 - t84 * t888 - t86 * t886;
    let t897 = -(t62 * t896) - t64 * t895 - t65 * t894 - t68 * t889 + t70 * t888
        - t72 * t886;
    let t898 = -(t53 * t897) - t55 * t896 - t57 * t886;
    let t899 = -(t43 * t898) - t45 * t897 - t43 * t896 + t47 * t886;
    let drum_v_y_dot_by_rod_omega = R::literal(0.666_666_666_666_666_6) * (t161 * t887)
        + t38 * t887;
    let drum_v_x_dot_by_rod_omega = R::literal(0.666_666_666_666_666_6) * (t160 * t887)
        + t37 * t887;
    let bobbin_v_y_dot_by_rod_omega = -(inverse_bobbin_mass * t888) - t36 * t887;
    let bobbin_v_x_dot_by_rod_omega = -(inverse_bobbin_mass * t889) - t35 * t887;
    let rod_omega_dot_by_rod_omega = t33 * t891
        - R::literal(4_166.666_666_666_667) * t893 - t34 * t890;
    let rod_v_y_dot_by_rod_omega = -(t32 * t892) - R::literal(5.0) * t890;
    let rod_v_x_dot_by_rod_omega = t31 * t892 - R::literal(5.0) * t891;
    let cylinder_omega_dot_by_rod_omega = t29 * t894 - t28 * t895
        - R::literal(-2_777.777_777_777_778) * t893 + t30 * t892;
    let cylinder_v_y_dot_by_rod_omega = t27 * t892
        - R::literal(3.333_333_333_333_333_5) * t894;
    let cylinder_v_x_dot_by_rod_omega = -(R::literal(3.333_333_333_333_333_5) * t895)
        - t26 * t892;
    let plate_omega_dot_by_rod_omega = t23 * t896 - t22 * t897 - t22 * t895 + t23 * t894
        + t24 * t889 - t25 * t888;
    let plate_v_y_dot_by_rod_omega = -(R::literal(0.833_333_333_333_333_4) * t896)
        - R::literal(-0.833_333_333_333_333_4) * t894
        - R::literal(-0.833_333_333_333_333_4) * t888;
    let plate_v_x_dot_by_rod_omega = -(R::literal(0.833_333_333_333_333_4) * t897)
        - R::literal(-0.833_333_333_333_333_4) * t895
        - R::literal(-0.833_333_333_333_333_4) * t889;
    let post_omega_dot_by_rod_omega = t20 * t898 - t19 * t899 - t19 * t897 + t20 * t896
        - t21 * t886;
    let post_v_y_dot_by_rod_omega = -(R::literal(1.25) * t898)
        - R::literal(-1.25) * t896;
    let post_v_x_dot_by_rod_omega = -(R::literal(1.25) * t899)
        - R::literal(-1.25) * t897;
    let t900 = R::literal(2.0) * bobbin_v_y * bobbin_x_minus_drum_x
        * bobbin_y_minus_drum_y / between_squared_times_between;
    let t901 = R::literal(2.0) * drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t902 = drum_v_x_over_between
        - (t901 + bobbin_v_x * t542 + bobbin_v_x_over_between + drum_v_x * t549 + t205
            - t900 - t202);
    let t903 = t164 * t902 * t166;
    let t904 = t902 * t162 + t164 * t903;
    let t905 = t159 * t903 - t157 * t904;
    let t906 = t152 * t904 - t151 * t905 + t154 * t903;
    let t907 = -(t144 * t906) - t146 * t905 + t148 * t903;
    let t908 = -(t135 * t907) - t137 * t906 - t139 * t905 + t141 * t903;
    let t909 = -(t124 * t908) - t126 * t907 - t128 * t906 - t130 * t905 + t132 * t903;
    let t910 = -(t113 * t909) - t114 * t908 + t115 * t907 - t117 * t906 - t119 * t905
        + t121 * t903;
    let t911 = -(t102 * t910) - t104 * t909 - t106 * t906 - t108 * t905 + t110 * t903;
    let t912 = t91 * t910 - t89 * t911 - t93 * t909 - t95 * t906 - t97 * t905
        + t99 * t903;
    let t913 = -(t76 * t912) - t78 * t911 - t81 * t906 - t84 * t905 + t86 * t903;
    let t914 = -(t62 * t913) - t64 * t912 - t65 * t911 - t68 * t906 + t70 * t905
        + t72 * t903;
    let t915 = -(t53 * t914) - t55 * t913 + t57 * t903;
    let t916 = -(t43 * t915) - t45 * t914 - t43 * t913 - t47 * t903;
    let drum_v_y_dot_by_bobbin_v_x = R::literal(0.666_666_666_666_666_6) * (t161 * t904)
        + t38 * t904;
    let drum_v_x_dot_by_bobbin_v_x = R::literal(0.666_666_666_666_666_6) * (t160 * t904)
        + t37 * t904;
    let bobbin_v_y_dot_by_bobbin_v_x = -(inverse_bobbin_mass * t905) - t36 * t904;
    let bobbin_v_x_dot_by_bobbin_v_x = -(inverse_bobbin_mass * t906) - t35 * t904;
    let rod_omega_dot_by_bobbin_v_x = t33 * t908
        - R::literal(4_166.666_666_666_667) * t910 - t34 * t907;
    let rod_v_y_dot_by_bobbin_v_x = -(t32 * t909) - R::literal(5.0) * t907;
    let rod_v_x_dot_by_bobbin_v_x = t31 * t909 - R::literal(5.0) * t908;
    let cylinder_omega_dot_by_bobbin_v_x = t29 * t911 - t28 * t912
        - R::literal(-2_777.777_777_777_778) * t910 + t30 * t909;
    let cylinder_v_y_dot_by_bobbin_v_x = t27 * t909
        - R::literal(3.333_333_333_333_333_5) * t911;
    let cylinder_v_x_dot_by_bobbin_v_x = -(R::literal(3.333_333_333_333_333_5) * t912)
        - t26 * t909;
    let plate_omega_dot_by_bobbin_v_x = t23 * t913 - t22 * t914 - t22 * t912 + t23 * t911
        + t24 * t906 - t25 * t905;
    let plate_v_y_dot_by_bobbin_v_x = -(R::literal(0.833_333_333_333_333_4) * t913)
        - R::literal(-0.833_333_333_333_333_4) * t911
        - R::literal(-0.833_333_333_333_333_4) * t905;
    let plate_v_x_dot_by_bobbin_v_x = -(R::literal(0.833_333_333_333_333_4) * t914)
        - R::literal(-0.833_333_333_333_333_4) * t912
        - R::literal(-0.833_333_333_333_333_4) * t906;
    let post_omega_dot_by_bobbin_v_x = t20 * t915 - t19 * t916 - t19 * t914 + t20 * t913
        + t21 * t903;
    let post_v_y_dot_by_bobbin_v_x = -(R::literal(1.25) * t915)
        - R::literal(-1.25) * t913;
    let post_v_x_dot_by_bobbin_v_x = -(R::literal(1.25) * t916)
        - R::literal(-1.25) * t914;
    let t917 = R::literal(2.0) * bobbin_v_x * bobbin_x_minus_drum_x
        * bobbin_y_minus_drum_y / between_squared_times_between;
    let t918 = R::literal(2.0) * drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t919 = drum_v_y_over_between
        - (t918 + bobbin_v_y * t593 + bobbin_v_y_over_between + drum_v_y * t597 + t211
            - t917 - t209);
    let t920 = t164 * t919 * t166;
    let t921 = t919 * t162 + t164 * t920;
    let t922 = t159 * t920 - t157 * t921;
    let t923 = t152 * t921 - t151 * t922 + t154 * t920;
    let t924 = -(t144 * t923) - t146 * t922 + t148 * t920;
    let t925 = -(t135 * t924) - t137 * t923 - t139 * t922 + t141 * t920;
    let t926 = -(t124 * t925) - t126 * t924 - t128 * t923 - t130 * t922 + t132 * t920;
    let t927 = -(t113 * t926) - t114 * t925 + t115 * t924 - t117 * t923 - t119 * t922
        + t121 * t920;
    let t928 = -(t102 * t927) - t104 * t926 - t106 * t923 - t108 * t922 + t110 * t920;
    let t929 = t91 * t927 - t89 * t928 - t93 * t926 - t95 * t923 - t97 * t922
        + t99 * t920;
    let t930 = -(t76 * t929) - t78 * t928 - t81 * t923 - t84 * t922 + t86 * t920;
    let t931 = -(t62 * t930) - t64 * t929 - t65 * t928 - t68 * t923 + t70 * t922
        + t72 * t920;
    let t932 = -(t53 * t931) - t55 * t930 + t57 * t920;
    let t933 = -(t43 * t932) - t45 * t931 - t43 * t930 - t47 * t920;
    let drum_v_y_dot_by_bobbin_v_y = R::literal(0.666_666_666_666_666_6) * (t161 * t921)
        + t38 * t921;
    let drum_v_x_dot_by_bobbin_v_y = R::literal(0.666_666_666_666_666_6) * (t160 * t921)
        + t37 * t921;
    let bobbin_v_y_dot_by_bobbin_v_y = -(inverse_bobbin_mass * t922) - t36 * t921;
    let bobbin_v_x_dot_by_bobbin_v_y = -(inverse_bobbin_mass * t923) - t35 * t921;
    let rod_omega_dot_by_bobbin_v_y = t33 * t925
        - R::literal(4_166.666_666_666_667) * t927 - t34 * t924;
    let rod_v_y_dot_by_bobbin_v_y = -(t32 * t926) - R::literal(5.0) * t924;
    let rod_v_x_dot_by_bobbin_v_y = t31 * t926 - R::literal(5.0) * t925;
    let cylinder_omega_dot_by_bobbin_v_y = t29 * t928 - t28 * t929
        - R::literal(-2_777.777_777_777_778) * t927 + t30 * t926;
    let cylinder_v_y_dot_by_bobbin_v_y = t27 * t926
        - R::literal(3.333_333_333_333_333_5) * t928;
    let cylinder_v_x_dot_by_bobbin_v_y = -(R::literal(3.333_333_333_333_333_5) * t929)
        - t26 * t926;
    let plate_omega_dot_by_bobbin_v_y = t23 * t930 - t22 * t931 - t22 * t929 + t23 * t928
        + t24 * t923 - t25 * t922;
    let plate_v_y_dot_by_bobbin_v_y = -(R::literal(0.833_333_333_333_333_4) * t930)
        - R::literal(-0.833_333_333_333_333_4) * t928
        - R::literal(-0.833_333_333_333_333_4) * t922;
    let plate_v_x_dot_by_bobbin_v_y = -(R::literal(0.833_333_333_333_333_4) * t931)
        - R::literal(-0.833_333_333_333_333_4) * t929
        - R::literal(-0.833_333_333_333_333_4) * t923;
    let post_omega_dot_by_bobbin_v_y = t20 * t932 - t19 * t933 - t19 * t931 + t20 * t930
        + t21 * t920;
    let post_v_y_dot_by_bobbin_v_y = -(R::literal(1.25) * t932)
        - R::literal(-1.25) * t930;
    let post_v_x_dot_by_bobbin_v_y = -(R::literal(1.25) * t933)
        - R::literal(-1.25) * t931;
    let t934 = t205
        - (t900 + bobbin_v_x * t549 + t202 + drum_v_x * t542 + drum_v_x_over_between
            - t901 - bobbin_v_x_over_between);
    let t935 = t164 * t934 * t166;
    let t936 = t934 * t162 + t164 * t935;
    let t937 = t159 * t935 - t157 * t936;
    let t938 = t152 * t936 - t151 * t937 + t154 * t935;
    let t939 = -(t144 * t938) - t146 * t937 + t148 * t935;
    let t940 = -(t135 * t939) - t137 * t938 - t139 * t937 + t141 * t935;
    let t941 = -(t124 * t940) - t126 * t939 - t128 * t938 - t130 * t937 + t132 * t935;
    let t942 = -(t113 * t941) - t114 * t940 + t115 * t939 - t117 * t938 - t119 * t937
        + t121 * t935;
    let t943 = -(t102 * t942) - t104 * t941 - t106 * t938 - t108 * t937 + t110 * t935;
    let t944 = t91 * t942 - t89 * t943 - t93 * t941 - t95 * t938 - t97 * t937
        + t99 * t935;
    let t945 = -(t76 * t944) - t78 * t943 - t81 * t938 - t84 * t937 + t86 * t935;
    let t946 = -(t62 * t945) - t64 * t944 - t65 * t943 - t68 * t938 + t70 * t937
        + t72 * t935;
    let t947 = -(t53 * t946) - t55 * t945 + t57 * t935;
    let t948 = -(t43 * t947) - t45 * t946 - t43 * t945 - t47 * t935;
    let drum_v_y_dot_by_drum_v_x = R::literal(0.666_666_666_666_666_6) * (t161 * t936)
        + t38 * t936;
    let drum_v_x_dot_by_drum_v_x = R::literal(0.666_666_666_666_666_6) * (t160 * t936)
        + t37 * t936;
    let bobbin_v_y_dot_by_drum_v_x = -(inverse_bobbin_mass * t937) - t36 * t936;
    let bobbin_v_x_dot_by_drum_v_x = -(inverse_bobbin_mass * t938) - t35 * t936;
    let rod_omega_dot_by_drum_v_x = t33 * t940 - R::literal(4_166.666_666_666_667) * t942
        - t34 * t939;
    let rod_v_y_dot_by_drum_v_x = -(t32 * t941) - R::literal(5.0) * t939;
    let rod_v_x_dot_by_drum_v_x = t31 * t941 - R::literal(5.0) * t940;
    let cylinder_omega_dot_by_drum_v_x = t29 * t943 - t28 * t944
        - R::literal(-2_777.777_777_777_778) * t942 + t30 * t941;
    let cylinder_v_y_dot_by_drum_v_x = t27 * t941
        - R::literal(3.333_333_333_333_333_5) * t943;
    let cylinder_v_x_dot_by_drum_v_x = -(R::literal(3.333_333_333_333_333_5) * t944)
        - t26 * t941;
    let plate_omega_dot_by_drum_v_x = t23 * t945 - t22 * t946 - t22 * t944 + t23 * t943
        + t24 * t938 - t25 * t937;
    let plate_v_y_dot_by_drum_v_x = -(R::literal(0.833_333_333_333_333_4) * t945)
        - R::literal(-0.833_333_333_333_333_4) * t943
        - R::literal(-0.833_333_333_333_333_4) * t937;
    let plate_v_x_dot_by_drum_v_x = -(R::literal(0.833_333_333_333_333_4) * t946)
        - R::literal(-0.833_333_333_333_333_4) * t944
        - R::literal(-0.833_333_333_333_333_4) * t938;
    let post_omega_dot_by_drum_v_x = t20 * t947 - t19 * t948 - t19 * t946 + t20 * t945
        + t21 * t935;
    let post_v_y_dot_by_drum_v_x = -(R::literal(1.25) * t947) - R::literal(-1.25) * t945;
    let post_v_x_dot_by_drum_v_x = -(R::literal(1.25) * t948) - R::literal(-1.25) * t946;
    let t949 = t211
        - (t917 + bobbin_v_y * t597 + t209 + drum_v_y * t593 + drum_v_y_over_between
            - t918 - bobbin_v_y_over_between);
    let t950 = t164 * t949 * t166;
    let t951 = t949 * t162 + t164 * t950;
    let t952 = t159 * t950 - t157 * t951;
    let t953 = t152 * t951 - t151 * t952 + t154 * t950;
    let t954 = -(t144 * t953) - t146 * t952 + t148 * t950;
    let t955 = -(t135 * t954) - t137 * t953 - t139 * t952 + t141 * t950;
    let t956 = -(t124 * t955) - t126 * t954 - t128 * t953 - t130 * t952 + t132 * t950;
    let t957 = -(t113 * t956) - t114 * t955 + t115 * t954 - t117 * t953 - t119 * t952
        + t121 * t950;
    let t958 = -(t102 * t957) - t104 * t956 - t106 * t953 - t108 * t952 + t110 * t950;
    let t959 = t91 * t957 - t89 * t958 - t93 * t956 - t95 * t953 - t97 * t952
        + t99 * t950;
    let t960 = -(t76 * t959) - t78 * t958 - t81 * t953 - t84 * t952 + t86 * t950;
    let t961 = -(t62 * t960) - t64 * t959 - t65 * t958 - t68 * t953 + t70 * t952
        + t72 * t950;
    let t962 = -(t53 * t961) - t55 * t960 + t57 * t950;
    let t963 = -(t43 * t962) - t45 * t961 - t43 * t960 - t47 * t950;
    let drum_v_y_dot_by_drum_v_y = R::literal(0.666_666_666_666_666_6) * (t161 * t951)
        + t38 * t951;
    let drum_v_x_dot_by_drum_v_y = R::literal(0.666_666_666_666_666_6) * (t160 * t951)
        + t37 * t951;
    let bobbin_v_y_dot_by_drum_v_y = -(inverse_bobbin_mass * t952) - t36 * t951;
    let bobbin_v_x_dot_by_drum_v_y = -(inverse_bobbin_mass * t953) - t35 * t951;
    let rod_omega_dot_by_drum_v_y = t33 * t955 - R::literal(4_166.666_666_666_667) * t957
        - t34 * t954;
    let rod_v_y_dot_by_drum_v_y = -(t32 * t956) - R::literal(5.0) * t954;
    let rod_v_x_dot_by_drum_v_y = t31 * t956 - R::literal(5.0) * t955;
    let cylinder_omega_dot_by_drum_v_y = t29 * t958 - t28 * t959
        - R::literal(-2_777.777_777_777_778) * t957 + t30 * t956;
    let cylinder_v_y_dot_by_drum_v_y = t27 * t956
        - R::literal(3.333_333_333_333_333_5) * t958;
    let cylinder_v_x_dot_by_drum_v_y = -(R::literal(3.333_333_333_333_333_5) * t959)
        - t26 * t956;
    let plate_omega_dot_by_drum_v_y = t23 * t960 - t22 * t961 - t22 * t959 + t23 * t958
        + t24 * t953 - t25 * t952;
    let plate_v_y_dot_by_drum_v_y = -(R::literal(0.833_333_333_333_333_4) * t960)
        - R::literal(-0.833_333_333_333_333_4) * t958
        - R::literal(-0.833_333_333_333_333_4) * t952;
    let plate_v_x_dot_by_drum_v_y = -(R::literal(0.833_333_333_333_333_4) * t961)
        - R::literal(-0.833_333_333_333_333_4) * t959
        - R::literal(-0.833_333_333_333_333_4) * t953;
    let post_omega_dot_by_drum_v_y = t20 * t962 - t19 * t963 - t19 * t961 + t20 * t960
        + t21 * t950;
    let post_v_y_dot_by_drum_v_y = -(R::literal(1.25) * t962) - R::literal(-1.25) * t960;
    let post_v_x_dot_by_drum_v_y = -(R::literal(1.25) * t963) - R::literal(-1.25) * t961;
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
        post_v_x_dot_by_post_phi,
        post_v_x_dot_by_plate_phi,
        post_v_x_dot_by_cylinder_x,
        post_v_x_dot_by_cylinder_y,
        post_v_x_dot_by_cylinder_phi,
        post_v_x_dot_by_rod_x,
        post_v_x_dot_by_rod_y,
        post_v_x_dot_by_rod_phi,
        post_v_x_dot_by_bobbin_x,
        post_v_x_dot_by_bobbin_y,
        post_v_x_dot_by_drum_x,
        post_v_x_dot_by_drum_y,
        post_v_x_dot_by_post_omega,
        post_v_x_dot_by_plate_omega,
        post_v_x_dot_by_cylinder_v_x,
        post_v_x_dot_by_cylinder_v_y,
        post_v_x_dot_by_cylinder_omega,
        post_v_x_dot_by_rod_v_x,
        post_v_x_dot_by_rod_v_y,
        post_v_x_dot_by_rod_omega,
        post_v_x_dot_by_bobbin_v_x,
        post_v_x_dot_by_bobbin_v_y,
        post_v_x_dot_by_drum_v_x,
        post_v_x_dot_by_drum_v_y,
        post_v_y_dot_by_post_phi,
        post_v_y_dot_by_plate_phi,
        post_v_y_dot_by_cylinder_x,
        post_v_y_dot_by_cylinder_y,
        post_v_y_dot_by_cylinder_phi,
        post_v_y_dot_by_rod_x,
        post_v_y_dot_by_rod_y,
        post_v_y_dot_by_rod_phi,
        post_v_y_dot_by_bobbin_x,
        post_v_y_dot_by_bobbin_y,
        post_v_y_dot_by_drum_x,
        post_v_y_dot_by_drum_y,
        post_v_y_dot_by_post_omega,
        post_v_y_dot_by_plate_omega,
        post_v_y_dot_by_cylinder_v_x,
        post_v_y_dot_by_cylinder_v_y,
        post_v_y_dot_by_cylinder_omega,
        post_v_y_dot_by_rod_v_x,
        post_v_y_dot_by_rod_v_y,
        post_v_y_dot_by_rod_omega,
        post_v_y_dot_by_bobbin_v_x,
        post_v_y_dot_by_bobbin_v_y,
        post_v_y_dot_by_drum_v_x,
        post_v_y_dot_by_drum_v_y,
        post_omega_dot_by_post_phi,
        post_omega_dot_by_plate_phi,
        post_omega_dot_by_cylinder_x,
        post_omega_dot_by_cylinder_y,
        post_omega_dot_by_cylinder_phi,
        post_omega_dot_by_rod_x,
        post_omega_dot_by_rod_y,
        post_omega_dot_by_rod_phi,
        post_omega_dot_by_bobbin_x,
        post_omega_dot_by_bobbin_y,
        post_omega_dot_by_drum_x,
        post_omega_dot_by_drum_y,
        post_omega_dot_by_post_omega,
        post_omega_dot_by_plate_omega,
        post_omega_dot_by_cylinder_v_x,
        post_omega_dot_by_cylinder_v_y,
        post_omega_dot_by_cylinder_omega,
        post_omega_dot_by_rod_v_x,
        post_omega_dot_by_rod_v_y,
        post_omega_dot_by_rod_omega,
        post_omega_dot_by_bobbin_v_x,
        post_omega_dot_by_bobbin_v_y,
        post_omega_dot_by_drum_v_x,
        post_omega_dot_by_drum_v_y,
        plate_v_x_dot_by_post_phi,
        plate_v_x_dot_by_plate_phi,
        plate_v_x_dot_by_cylinder_x,
        plate_v_x_dot_by_cylinder_y,
        plate_v_x_dot_by_cylinder_phi,
        plate_v_x_dot_by_rod_x,
        plate_v_x_dot_by_rod_y,
        plate_v_x_dot_by_rod_phi,
        plate_v_x_dot_by_bobbin_x,
        plate_v_x_dot_by_bobbin_y,
        plate_v_x_dot_by_drum_x,
        plate_v_x_dot_by_drum_y,
        plate_v_x_dot_by_post_omega,
        plate_v_x_dot_by_plate_omega,
        plate_v_x_dot_by_cylinder_v_x,
        plate_v_x_dot_by_cylinder_v_y,
        plate_v_x_dot_by_cylinder_omega,
        plate_v_x_dot_by_rod_v_x,
        plate_v_x_dot_by_rod_v_y,
        plate_v_x_dot_by_rod_omega,
        plate_v_x_dot_by_bobbin_v_x,
        plate_v_x_dot_by_bobbin_v_y,
        plate_v_x_dot_by_drum_v_x,
        plate_v_x_dot_by_drum_v_y,
        plate_v_y_dot_by_post_phi,
        plate_v_y_dot_by_plate_phi,
        plate_v_y_dot_by_cylinder_x,
        plate_v_y_dot_by_cylinder_y,
        plate_v_y_dot_by_cylinder_phi,
        plate_v_y_dot_by_rod_x,
        plate_v_y_dot_by_rod_y,
        plate_v_y_dot_by_rod_phi,
        plate_v_y_dot_by_bobbin_x,
        plate_v_y_dot_by_bobbin_y,
        plate_v_y_dot_by_drum_x,
        plate_v_y_dot_by_drum_y,
        plate_v_y_dot_by_post_omega,
        plate_v_y_dot_by_plate_omega,
        plate_v_y_dot_by_cylinder_v_x,
        plate_v_y_dot_by_cylinder_v_y,
        plate_v_y_dot_by_cylinder_omega,
        plate_v_y_dot_by_rod_v_x,
        plate_v_y_dot_by_rod_v_y,
        plate_v_y_dot_by_rod_omega,
        plate_v_y_dot_by_bobbin_v_x,
        plate_v_y_dot_by_bobbin_v_y,
        plate_v_y_dot_by_drum_v_x,
        plate_v_y_dot_by_drum_v_y,
        plate_omega_dot_by_post_phi,
        plate_omega_dot_by_plate_phi,
        plate_omega_dot_by_cylinder_x,
        plate_omega_dot_by_cylinder_y,
        plate_omega_dot_by_cylinder_phi,
        plate_omega_dot_by_rod_x,
        plate_omega_dot_by_rod_y,
        plate_omega_dot_by_rod_phi,
        plate_omega_dot_by_bobbin_x,
        plate_omega_dot_by_bobbin_y,
        plate_omega_dot_by_drum_x,
        plate_omega_dot_by_drum_y,
        plate_omega_dot_by_post_omega,
        plate_omega_dot_by_plate_omega,
        plate_omega_dot_by_cylinder_v_x,
        plate_omega_dot_by_cylinder_v_y,
        plate_omega_dot_by_cylinder_omega,
        plate_omega_dot_by_rod_v_x,
        plate_omega_dot_by_rod_v_y,
        plate_omega_dot_by_rod_omega,
        plate_omega_dot_by_bobbin_v_x,
        plate_omega_dot_by_bobbin_v_y,
        plate_omega_dot_by_drum_v_x,
        plate_omega_dot_by_drum_v_y,
        cylinder_v_x_dot_by_post_phi,
        cylinder_v_x_dot_by_plate_phi,
        cylinder_v_x_dot_by_cylinder_x,
        cylinder_v_x_dot_by_cylinder_y,
        cylinder_v_x_dot_by_cylinder_phi,
        cylinder_v_x_dot_by_rod_x,
        cylinder_v_x_dot_by_rod_y,
        cylinder_v_x_dot_by_rod_phi,
        cylinder_v_x_dot_by_bobbin_x,
        cylinder_v_x_dot_by_bobbin_y,
        cylinder_v_x_dot_by_drum_x,
        cylinder_v_x_dot_by_drum_y,
        cylinder_v_x_dot_by_post_omega,
        cylinder_v_x_dot_by_plate_omega,
        cylinder_v_x_dot_by_cylinder_v_x,
        cylinder_v_x_dot_by_cylinder_v_y,
        cylinder_v_x_dot_by_cylinder_omega,
        cylinder_v_x_dot_by_rod_v_x,
        cylinder_v_x_dot_by_rod_v_y,
        cylinder_v_x_dot_by_rod_omega,
        cylinder_v_x_dot_by_bobbin_v_x,
        cylinder_v_x_dot_by_bobbin_v_y,
        cylinder_v_x_dot_by_drum_v_x,
        cylinder_v_x_dot_by_drum_v_y,
        cylinder_v_y_dot_by_post_phi,
        cylinder_v_y_dot_by_plate_phi,
        cylinder_v_y_dot_by_cylinder_x,
        cylinder_v_y_dot_by_cylinder_y,
        cylinder_v_y_dot_by_cylinder_phi,
        cylinder_v_y_dot_by_rod_x,
        cylinder_v_y_dot_by_rod_y,
        cylinder_v_y_dot_by_rod_phi,
        cylinder_v_y_dot_by_bobbin_x,
        cylinder_v_y_dot_by_bobbin_y,
        cylinder_v_y_dot_by_drum_x,
        cylinder_v_y_dot_by_drum_y,
        cylinder_v_y_dot_by_post_omega,
        cylinder_v_y_dot_by_plate_omega,
        cylinder_v_y_dot_by_cylinder_v_x,
        cylinder_v_y_dot_by_cylinder_v_y,
        cylinder_v_y_dot_by_cylinder_omega,
        cylinder_v_y_dot_by_rod_v_x,
        cylinder_v_y_dot_by_rod_v_y,
        cylinder_v_y_dot_by_rod_omega,
        cylinder_v_y_dot_by_bobbin_v_x,
        cylinder_v_y_dot_by_bobbin_v_y,
        cylinder_v_y_dot_by_drum_v_x,
        cylinder_v_y_dot_by_drum_v_y,
        cylinder_omega_dot_by_post_phi,
        cylinder_omega_dot_by_plate_phi,
        cylinder_omega_dot_by_cylinder_x,
        cylinder_omega_dot_by_cylinder_y,
        cylinder_omega_dot_by_cylinder_phi,
        cylinder_omega_dot_by_rod_x,
        cylinder_omega_dot_by_rod_y,
        cylinder_omega_dot_by_rod_phi,
        cylinder_omega_dot_by_bobbin_x,
        cylinder_omega_dot_by_bobbin_y,
        cylinder_omega_dot_by_drum_x,
        cylinder_omega_dot_by_drum_y,
        cylinder_omega_dot_by_post_omega,
        cylinder_omega_dot_by_plate_omega,
        cylinder_omega_dot_by_cylinder_v_x,
        cylinder_omega_dot_by_cylinder_v_y,
        cylinder_omega_dot_by_cylinder_omega,
        cylinder_omega_dot_by_rod_v_x,
        cylinder_omega_dot_by_rod_v_y,
        cylinder_omega_dot_by_rod_omega,
        cylinder_omega_dot_by_bobbin_v_x,
        cylinder_omega_dot_by_bobbin_v_y,
        cylinder_omega_dot_by_drum_v_x,
        cylinder_omega_dot_by_drum_v_y,
        rod_v_x_dot_by_post_phi,
        rod_v_x_dot_by_plate_phi,
        rod_v_x_dot_by_cylinder_x,
        rod_v_x_dot_by_cylinder_y,
        rod_v_x_dot_by_cylinder_phi,
        rod_v_x_dot_by_rod_x,
        rod_v_x_dot_by_rod_y,
        rod_v_x_dot_by_rod_phi,
        rod_v_x_dot_by_bobbin_x,
        rod_v_x_dot_by_bobbin_y,
        rod_v_x_dot_by_drum_x,
        rod_v_x_dot_by_drum_y,
        rod_v_x_dot_by_post_omega,
        rod_v_x_dot_by_plate_omega,
        rod_v_x_dot_by_cylinder_v_x,
        rod_v_x_dot_by_cylinder_v_y,
        rod_v_x_dot_by_cylinder_omega,
        rod_v_x_dot_by_rod_v_x,
        rod_v_x_dot_by_rod_v_y,
        rod_v_x_dot_by_rod_omega,
        rod_v_x_dot_by_bobbin_v_x,
        rod_v_x_dot_by_bobbin_v_y,
        rod_v_x_dot_by_drum_v_x,
        rod_v_x_dot_by_drum_v_y,
        rod_v_y_dot_by_post_phi,
        rod_v_y_dot_by_plate_phi,
        rod_v_y_dot_by_cylinder_x,
        rod_v_y_dot_by_cylinder_y,
        rod_v_y_dot_by_cylinder_phi,
        rod_v_y_dot_by_rod_x,
        rod_v_y_dot_by_rod_y,
        rod_v_y_dot_by_rod_phi,
        rod_v_y_dot_by_bobbin_x,
        rod_v_y_dot_by_bobbin_y,
        rod_v_y_dot_by_drum_x,
        rod_v_y_dot_by_drum_y,
        rod_v_y_dot_by_post_omega,
        rod_v_y_dot_by_plate_omega,
        rod_v_y_dot_by_cylinder_v_x,
        rod_v_y_dot_by_cylinder_v_y,
        rod_v_y_dot_by_cylinder_omega,
        rod_v_y_dot_by_rod_v_x,
        rod_v_y_dot_by_rod_v_y,
        rod_v_y_dot_by_rod_omega,
        rod_v_y_dot_by_bobbin_v_x,
        rod_v_y_dot_by_bobbin_v_y,
        rod_v_y_dot_by_drum_v_x,
        rod_v_y_dot_by_drum_v_y,
        rod_omega_dot_by_post_phi,
        rod_omega_dot_by_plate_phi,
        rod_omega_dot_by_cylinder_x,
        rod_omega_dot_by_cylinder_y,
        rod_omega_dot_by_cylinder_phi,
        rod_omega_dot_by_rod_x,
        rod_omega_dot_by_rod_y,
        rod_omega_dot_by_rod_phi,
        rod_omega_dot_by_bobbin_x,
        rod_omega_dot_by_bobbin_y,
        rod_omega_dot_by_drum_x,
        rod_omega_dot_by_drum_y,
        rod_omega_dot_by_post_omega,
        rod_omega_dot_by_plate_omega,
        rod_omega_dot_by_cylinder_v_x,
        rod_omega_dot_by_cylinder_v_y,
        rod_omega_dot_by_cylinder_omega,
        rod_omega_dot_by_rod_v_x,
        rod_omega_dot_by_rod_v_y,
        rod_omega_dot_by_rod_omega,
        rod_omega_dot_by_bobbin_v_x,
        rod_omega_dot_by_bobbin_v_y,
        rod_omega_dot_by_drum_v_x,
        rod_omega_dot_by_drum_v_y,
        bobbin_v_x_dot_by_post_phi,
        bobbin_v_x_dot_by_plate_phi,
        bobbin_v_x_dot_by_cylinder_x,
        bobbin_v_x_dot_by_cylinder_y,
        bobbin_v_x_dot_by_cylinder_phi,
        bobbin_v_x_dot_by_rod_x,
        bobbin_v_x_dot_by_rod_y,
        bobbin_v_x_dot_by_rod_phi,
        bobbin_v_x_dot_by_bobbin_x,
        bobbin_v_x_dot_by_bobbin_y,
        bobbin_v_x_dot_by_drum_x,
        bobbin_v_x_dot_by_drum_y,
        bobbin_v_x_dot_by_post_omega,
        bobbin_v_x_dot_by_plate_omega,
        bobbin_v_x_dot_by_cylinder_v_x,
        bobbin_v_x_dot_by_cylinder_v_y,
        bobbin_v_x_dot_by_cylinder_omega,
        bobbin_v_x_dot_by_rod_v_x,
        bobbin_v_x_dot_by_rod_v_y,
        bobbin_v_x_dot_by_rod_omega,
        bobbin_v_x_dot_by_bobbin_v_x,
        bobbin_v_x_dot_by_bobbin_v_y,
        bobbin_v_x_dot_by_drum_v_x,
        bobbin_v_x_dot_by_drum_v_y,
        bobbin_v_y_dot_by_post_phi,
        bobbin_v_y_dot_by_plate_phi,
        bobbin_v_y_dot_by_cylinder_x,
        bobbin_v_y_dot_by_cylinder_y,
        bobbin_v_y_dot_by_cylinder_phi,
        bobbin_v_y_dot_by_rod_x,
        bobbin_v_y_dot_by_rod_y,
        bobbin_v_y_dot_by_rod_phi,
        bobbin_v_y_dot_by_bobbin_x,
        bobbin_v_y_dot_by_bobbin_y,
        bobbin_v_y_dot_by_drum_x,
        bobbin_v_y_dot_by_drum_y,
        bobbin_v_y_dot_by_post_omega,
        bobbin_v_y_dot_by_plate_omega,
        bobbin_v_y_dot_by_cylinder_v_x,
        bobbin_v_y_dot_by_cylinder_v_y,
        bobbin_v_y_dot_by_cylinder_omega,
        bobbin_v_y_dot_by_rod_v_x,
        bobbin_v_y_dot_by_rod_v_y,
        bobbin_v_y_dot_by_rod_omega,
        bobbin_v_y_dot_by_bobbin_v_x,
        bobbin_v_y_dot_by_bobbin_v_y,
        bobbin_v_y_dot_by_drum_v_x,
        bobbin_v_y_dot_by_drum_v_y,
        drum_v_x_dot_by_post_phi,
        drum_v_x_dot_by_plate_phi,
        drum_v_x_dot_by_cylinder_x,
        drum_v_x_dot_by_cylinder_y,
        drum_v_x_dot_by_cylinder_phi,
        drum_v_x_dot_by_rod_x,
        drum_v_x_dot_by_rod_y,
        drum_v_x_dot_by_rod_phi,
        drum_v_x_dot_by_bobbin_x,
        drum_v_x_dot_by_bobbin_y,
        drum_v_x_dot_by_drum_x,
        drum_v_x_dot_by_drum_y,
        drum_v_x_dot_by_post_omega,
        drum_v_x_dot_by_plate_omega,
        drum_v_x_dot_by_cylinder_v_x,
        drum_v_x_dot_by_cylinder_v_y,
        drum_v_x_dot_by_cylinder_omega,
        drum_v_x_dot_by_rod_v_x,
        drum_v_x_dot_by_rod_v_y,
        drum_v_x_dot_by_rod_omega,
        drum_v_x_dot_by_bobbin_v_x,
        drum_v_x_dot_by_bobbin_v_y,
        drum_v_x_dot_by_drum_v_x,
        drum_v_x_dot_by_drum_v_y,
        drum_v_y_dot_by_post_phi,
        drum_v_y_dot_by_plate_phi,
        drum_v_y_dot_by_cylinder_x,
        drum_v_y_dot_by_cylinder_y,
        drum_v_y_dot_by_cylinder_phi,
        drum_v_y_dot_by_rod_x,
        drum_v_y_dot_by_rod_y,
        drum_v_y_dot_by_rod_phi,
        drum_v_y_dot_by_bobbin_x,
        drum_v_y_dot_by_bobbin_y,
        drum_v_y_dot_by_drum_x,
        drum_v_y_dot_by_drum_y,
        drum_v_y_dot_by_post_omega,
        drum_v_y_dot_by_plate_omega,
        drum_v_y_dot_by_cylinder_v_x,
        drum_v_y_dot_by_cylinder_v_y,
        drum_v_y_dot_by_cylinder_omega,
        drum_v_y_dot_by_rod_v_x,
        drum_v_y_dot_by_rod_v_y,
        drum_v_y_dot_by_rod_omega,
        drum_v_y_dot_by_bobbin_v_x,
        drum_v_y_dot_by_bobbin_v_y,
        drum_v_y_dot_by_drum_v_x,
        drum_v_y_dot_by_drum_v_y,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 2224 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 80] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, _, _, post_omega, _, _,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let cos_rod_phi = rod_phi.cos();
    let t6 = R::literal(0.06) * cos_rod_phi;
    let sin_rod_phi = rod_phi.sin();
    let t7 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t8 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t8 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let t9 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let t10 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = t1 * R::literal(370.370_370_370_370_3);
    let t13 = t0 * R::literal(370.370_370_370_370_3);
    let t14 = t9 * R::literal(370.370_370_370_370_3);
    let t15 = t3 * R::literal(400.0);
    let t16 = t2 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = t5 * R::literal(2_777.777_777_777_778);
    let t22 = t4 * R::literal(2_777.777_777_777_778);
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = t7 * R::literal(4_166.666_666_666_667);
    let t27 = t6 * R::literal(4_166.666_666_666_667);
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(-1.25) - t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(-1.25) - t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t42 - t43);
    let t45 = t12 * t0 - t38 * t35;
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = t14 * t0 + t40 * t35;
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51 - t38 * t37 - t46 * t45);
    let t53 = t16 * t3;
    let t54 = t35 + t53 - t36 * t37 - t48 * t45;
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t40 * t37 - t39 - t50 * t45;
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43 - t48 * t47
            - t55 * t54);
    let t68 = t15 * t2 - t57 * t54;
    let t69 = t68 * t67;
    let t70 = R::literal(0.833_333_333_333_333_4) - t66 - t58 * t54;
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72 - t61 * t54;
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = R::literal(0.833_333_333_333_333_4) + t75 + t63 * t54;
    let t77 = t76 * t67;
    let t78 = t49 - t50 * t47 - t65 * t54;
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5) - t21 * t5 - t57 * t56 - t69 * t68);
    let t81 = t53 + t22 * t5 - t58 * t56 - t71 * t68;
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = t23 * t5 - t19;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t59 - t61 * t56 - t74 * t68;
    let t88 = t87 * t80;
    let t89 = t63 * t56 - t62 - t77 * t68;
    let t90 = t89 * t80;
    let t91 = -(t65 * t56) - t79 * t68;
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5) - t22 * t4 - t58 * t53 - t71 * t70
            - t82 * t81);
    let t94 = R::literal(-2_777.777_777_777_778) * t4 + t84 * t81;
    let t95 = t94 * t93;
    let t96 = t20 - t23 * t4 - t86 * t81;
    let t97 = t96 * t93;
    let t98 = t72 - t61 * t53 - t74 * t70 - t88 * t81;
    let t99 = t98 * t93;
    let t100 = R::literal(-0.833_333_333_333_333_4) + t75 + t63 * t53 - t77 * t70
        - t90 * t81;
    let t101 = t100 * t93;
    let t102 = -(t65 * t53) - t79 * t70 - t92 * t81;
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t84 * t83 - t95 * t94);
    let t105 = t86 * t83 - t23 - t97 * t94;
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = t88 * t83 - t99 * t94;
    let t110 = t109 * t104;
    let t111 = t90 * t83 - t101 * t94;
    let t112 = t111 * t104;
    let t113 = t92 * t83 - t103 * t94;
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi) - t20 * cos_cylinder_phi - t23 * slide
            - t24 * sin_cylinder_phi - t25 * cos_cylinder_phi - t86 * t85 - t97 * t96
            - t106 * t105);
    let t116 = t24 - t107 * t105;
    let t117 = t116 * t115;
    let t118 = t108 * t105 - t25;
    let t119 = t118 * t115;
    let t120 = -(t88 * t85) - t99 * t96 - t110 * t105;
    let t121 = t120 * t115;
    let t122 = -(t90 * t85) - t101 * t96 - t112 * t105;
    let t123 = t122 * t115;
    let t124 = -(t92 * t85) - t103 * t96 - t114 * t105;
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / (R::literal(-5.0) - t26 * t7 - t107 * t26 - t117 * t116);
    let t127 = t27 * t7 + t108 * t26 - t119 * t116;
    let t128 = t127 * t126;
    let t129 = -(t110 * t26) - t121 * t116;
    let t130 = t129 * t126;
    let t131 = -(t112 * t26) - t123 * t116;
    let t132 = t131 * t126;
    let t133 = -(t114 * t26) - t125 * t116;
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / (R::literal(-5.0) - t27 * t6 - t108 * t27 - t119 * t118 - t128 * t127);
    let t136 = t110 * t27 - t121 * t118 - t130 * t127;
    let t137 = t136 * t135;
    let t138 = t112 * t27 - t123 * t118 - t132 * t127;
    let t139 = t138 * t135;
    let t140 = t114 * t27 - t125 * t118 - t134 * t127;
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t10 - inverse_bobbin_mass
            - t61 * t60 - t74 * t73 - t88 * t87 - t99 * t98 - t110 * t109 - t121 * t120
            - t130 * t129 - t137 * t136);
    let t143 = t18 * t10 + t63 * t60 - t77 * t73 - t90 * t87 - t101 * t98 - t112 * t109
        - t123 * t120 - t132 * t129 - t139 * t136;
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = -(t65 * t60) - t79 * t73 - t92 * t87 - t103 * t98 - t114 * t109
        - t125 * t120 - t134 * t129 - t141 * t136;
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t11 - inverse_bobbin_mass
            - t63 * t62 - t77 * t76 - t90 * t89 - t101 * t100 - t112 * t111 - t123 * t122
            - t132 * t131 - t139 * t138 - t144 * t143);
    let t149 = t145 * t143 - t29;
    let t150 = t149 * t148;
    let t151 = t65 * t62 - t79 * t76 - t92 * t89 - t103 * t100 - t114 * t111
        - t125 * t122 - t134 * t131 - t141 * t138 - t147 * t143;
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between)
            - t29 * bobbin_y_minus_drum_y_over_between
            - t30 * bobbin_x_minus_drum_x_over_between
            - t31 * bobbin_y_minus_drum_y_over_between - t145 * t28 - t150 * t149
            - t153 * t30 - t154 * t31);
    let t156 = t147 * t28 - t152 * t149;
    let t157 = t156 * t155;
    let t158 = -(t14 * t9) - t40 * t39 - t50 * t49 - t65 * t64 - t79 * t78 - t92 * t91
        - t103 * t102 - t114 * t113 - t125 * t124 - t134 * t133 - t141 * t140
        - t147 * t146;
    let t159 = R::literal(1.0) / (t158 - t152 * t151 - t157 * t156);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t160 = R::literal(50.0) * slide_rate;
    let t161 = t160 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t162 = p.spring_stiffness * slide_minus_spring_free_length;
    let t163 = t162 * cos_cylinder_phi;
    let t164 = t161 + t163;
    let t165 = t162 * sin_cylinder_phi;
    let t166 = t160 * sin_cylinder_phi;
    let t167 = t166 - (R::literal(2.943) - t165);
    let t168 = -(t160 * t8) - t162 * t8;
    let t169 = -t161 - t163;
    let t170 = -t166 - (R::literal(1.962) + t165);
    let t171 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t172 = p.winding_force * bobbin_x_minus_drum_x / between
        - R::literal(9.81) * p.bobbin_mass;
    let post_omega_squared = post_omega * post_omega;
    let t173 = R::literal(0.1) * post_omega_squared;
    let t174 = t173 * cos_post_phi;
    let t175 = t173 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t176 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t177 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t178 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t179 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t180 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t181 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t182 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t183 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t184 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t185 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t186 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t187 = bobbin_v_x
        * (bobbin_v_x_over_between + t181 + t182 - t179 - t180 - drum_v_x_over_between)
        + bobbin_v_y
            * (bobbin_v_y_over_between + t185 + t186 - t183 - t184
                - drum_v_y_over_between)
        + drum_v_x
            * (t179 + t180 + drum_v_x_over_between - bobbin_v_x_over_between - t181
                - t182);
    let t188 = t36 * t174;
    let t189 = -t175 - R::literal(-9.81) + t188;
    let t190 = t15 * bobbin_radius_times_winding_force;
    let t191 = t190 - (t176 * cos_plate_phi + t174) + t38 * t174 - t46 * t189;
    let t192 = t16 * bobbin_radius_times_winding_force;
    let t193 = -(t176 * sin_plate_phi + t175) - R::literal(9.81) - R::literal(-9.81)
        - t192 + t188 - t48 * t189 - t55 * t191;
    let t194 = t190
        - R::literal(0.06)
            * (plate_omega_squared * cos_plate_phi
                + cylinder_omega_squared * cos_cylinder_phi)
        - R::literal(3.333_333_333_333_333_5) * t164 - t21 * t168 - t57 * t191
        - t69 * t193;
    let t195 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t192
        - R::literal(3.333_333_333_333_333_5) * t167 + t22 * t168 - t58 * t191
        - t71 * t193 - t82 * t194;
    let t196 = t84 * t194 - R::literal(-2_777.777_777_777_778) * t168 - t95 * t195;
    let t197 = t177 - t19 * t164 + t20 * t167 + t23 * t168 + t24 * t169 - t25 * t170
        - t86 * t194 - t97 * t195 - t106 * t196;
    let t198 = t178 * cos_rod_phi - R::literal(5.0) * t169 - t107 * t196 - t117 * t197;
    let t199 = t178 * sin_rod_phi - R::literal(5.0) * t170 + t108 * t196 - t119 * t197
        - t128 * t198;
    let t200 = inverse_bobbin_mass * t171;
    let t201 = t11 * plate_omega_squared - t17 * bobbin_radius_times_winding_force + t200
        - t61 * t191 - t74 * t193 - t88 * t194 - t99 * t195 - t110 * t196 - t121 * t197
        - t130 * t198 - t137 * t199;
    let t202 = inverse_bobbin_mass * t172;
    let t203 = t10 * plate_omega_squared - R::literal(9.81)
        + t18 * bobbin_radius_times_winding_force - t202 + t63 * t191 - t77 * t193
        - t90 * t194 - t101 * t195 - t112 * t196 - t123 * t197 - t132 * t198
        - t139 * t199 - t144 * t201;
    let t204 = t28 * t171
        - (t187
            + drum_v_y
                * (t183 + t184 + drum_v_y_over_between - bobbin_v_y_over_between - t185
                    - t186)) - t29 * t172 + t31 * R::literal(-14.715) + t145 * t201
        - t150 * t203 - t154 * R::literal(9.809_999_999_999_999);
    let t205 = (R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi)
        * post_omega_squared - t40 * t174 - t50 * t189 - t65 * t191 - t79 * t193
        - t92 * t194 - t103 * t195 - t114 * t196 - t125 * t197 - t134 * t198
        - t141 * t199;
    let t206 = (t205 - t147 * t201 - t152 * t203 - t157 * t204) * t159;
    let t207 = t204 * t155 - t157 * t206;
    let t208 = t203 * t148 - t150 * t207 - t152 * t206;
    let bobbin_v_y_dot = t202 - inverse_bobbin_mass * t208 - t29 * t207;
    let t209 = p.spring_stiffness * cos_cylinder_phi;
    let t210 = p.spring_stiffness * t8;
    let t211 = p.spring_stiffness * sin_cylinder_phi;
    let t212 = t15 * p.winding_force;
    let t213 = -(t16 * p.winding_force);
    let t214 = t213 - t55 * t212;
    let t215 = t212 - t57 * t212 - t69 * t214;
    let t216 = t213 - t58 * t212 - t71 * t214 - t82 * t215;
    let t217 = t84 * t215 - t95 * t216;
    let t218 = -(t86 * t215) - t97 * t216 - t106 * t217;
    let t219 = -(t107 * t217) - t117 * t218;
    let t220 = t108 * t217 - t119 * t218 - t128 * t219;
    let t221 = -(t17 * p.winding_force) - t61 * t212 - t74 * t214 - t88 * t215
        - t99 * t216 - t110 * t217 - t121 * t218 - t130 * t219 - t137 * t220;
    let t222 = t18 * p.winding_force + t63 * t212 - t77 * t214 - t90 * t215 - t101 * t216
        - t112 * t217 - t123 * t218 - t132 * t219 - t139 * t220 - t144 * t221;
    let t223 = t145 * t221 - t150 * t222;
    let t224 = (-(t65 * t212) - t79 * t214 - t92 * t215 - t103 * t216 - t114 * t217
        - t125 * t218 - t134 * t219 - t141 * t220 - t147 * t221 - t152 * t222
        - t157 * t223) * t159;
    let t225 = t223 * t155 - t157 * t224;
    let t226 = t222 * t148 - t150 * t225 - t152 * t224;
    let t227 = t221 * t142 - t144 * t226 + t145 * t225 - t147 * t224;
    let t228 = t220 * t135 - t137 * t227 - t139 * t226 - t141 * t224;
    let t229 = t219 * t126 - t128 * t228 - t130 * t227 - t132 * t226 - t134 * t224;
    let t230 = t218 * t115 - t117 * t229 - t119 * t228 - t121 * t227 - t123 * t226
        - t125 * t224;
    let t231 = t217 * t104 - t106 * t230 - t107 * t229 + t108 * t228 - t110 * t227
        - t112 * t226 - t114 * t224;
    let t232 = t216 * t93 - t95 * t231 - t97 * t230 - t99 * t227 - t101 * t226
        - t103 * t224;
    let t233 = t215 * t80 - t82 * t232 + t84 * t231 - t86 * t230 - t88 * t227
        - t90 * t226 - t92 * t224;
    let t234 = t214 * t67 - t69 * t233 - t71 * t232 - t74 * t227 - t77 * t226
        - t79 * t224;
    let t235 = t212 * t52 - t55 * t234 - t57 * t233 - t58 * t232 - t61 * t227
        + t63 * t226 - t65 * t224;
    let t236 = -(t46 * t235) - t48 * t234 - t50 * t224;
    let t237 = -(t36 * t236) - t38 * t235 - t36 * t234 + t40 * t224;
    let drum_v_y_dot_by_bobbin_radius = R::literal(0.666_666_666_666_666_6)
        * (t154 * t225) + t31 * t225;
    let drum_v_x_dot_by_bobbin_radius = R::literal(0.666_666_666_666_666_6)
        * (t153 * t225) + t30 * t225;
    let bobbin_v_y_dot_by_bobbin_radius = -(inverse_bobbin_mass * t226) - t29 * t225;
    let bobbin_v_x_dot_by_bobbin_radius = -(inverse_bobbin_mass * t227) - t28 * t225;
    let rod_omega_dot_by_bobbin_radius = t26 * t229
        - R::literal(4_166.666_666_666_667) * t231 - t27 * t228;
    let rod_v_y_dot_by_bobbin_radius = -(t25 * t230) - R::literal(5.0) * t228;
    let rod_v_x_dot_by_bobbin_radius = t24 * t230 - R::literal(5.0) * t229;
    let cylinder_omega_dot_by_bobbin_radius = t22 * t232 - t21 * t233
        - R::literal(-2_777.777_777_777_778) * t231 + t23 * t230;
    let cylinder_v_y_dot_by_bobbin_radius = t20 * t230
        - R::literal(3.333_333_333_333_333_5) * t232;
    let cylinder_v_x_dot_by_bobbin_radius = -(R::literal(3.333_333_333_333_333_5) * t233)
        - t19 * t230;
    let plate_omega_dot_by_bobbin_radius = -(p.winding_force * R::literal(400.0))
        - t15 * t235 + t16 * t234 - t15 * t233 + t16 * t232 + t17 * t227 - t18 * t226;
    let plate_v_y_dot_by_bobbin_radius = -(R::literal(0.833_333_333_333_333_4) * t234)
        - R::literal(-0.833_333_333_333_333_4) * t232
        - R::literal(-0.833_333_333_333_333_4) * t226;
    let plate_v_x_dot_by_bobbin_radius = -(R::literal(0.833_333_333_333_333_4) * t235)
        - R::literal(-0.833_333_333_333_333_4) * t233
        - R::literal(-0.833_333_333_333_333_4) * t227;
    let post_omega_dot_by_bobbin_radius = t13 * t236 - t12 * t237 - t12 * t235
        + t13 * t234 - t14 * t224;
    let post_v_y_dot_by_bobbin_radius = -(R::literal(1.25) * t236)
        - R::literal(-1.25) * t234;
    let post_v_x_dot_by_bobbin_radius = -(R::literal(1.25) * t237)
        - R::literal(-1.25) * t235;
    let t238 = t15 * p.bobbin_radius;
    let t239 = -(t16 * p.bobbin_radius);
    let t240 = t239 - t55 * t238;
    let t241 = t238 - t57 * t238 - t69 * t240;
    let t242 = t239 - t58 * t238 - t71 * t240 - t82 * t241;
    let t243 = t84 * t241 - t95 * t242;
    let t244 = -(t86 * t241) - t97 * t242 - t106 * t243;
    let t245 = -(t107 * t243) - t117 * t244;
    let t246 = t108 * t243 - t119 * t244 - t128 * t245;
    let t247 = t29 - t17 * p.bobbin_radius - t61 * t238 - t74 * t240 - t88 * t241
        - t99 * t242 - t110 * t243 - t121 * t244 - t130 * t245 - t137 * t246;
    let t248 = t18 * p.bobbin_radius - t28 + t63 * t238 - t77 * t240 - t90 * t241
        - t101 * t242 - t112 * t243 - t123 * t244 - t132 * t245 - t139 * t246
        - t144 * t247;
    let t249 = t28 * bobbin_y_minus_drum_y_over_between
        - t29 * bobbin_x_minus_drum_x_over_between + t145 * t247 - t150 * t248;
    let t250 = (-(t65 * t238) - t79 * t240 - t92 * t241 - t103 * t242 - t114 * t243
        - t125 * t244 - t134 * t245 - t141 * t246 - t147 * t247 - t152 * t248
        - t157 * t249) * t159;
    let t251 = t249 * t155 - t157 * t250;
    let t252 = t248 * t148 - t150 * t251 - t152 * t250;
    let t253 = t247 * t142 - t144 * t252 + t145 * t251 - t147 * t250;
    let t254 = t246 * t135 - t137 * t253 - t139 * t252 - t141 * t250;
    let t255 = t245 * t126 - t128 * t254 - t130 * t253 - t132 * t252 - t134 * t250;
    let t256 = t244 * t115 - t117 * t255 - t119 * t254 - t121 * t253 - t123 * t252
        - t125 * t250;
    let t257 = t243 * t104 - t106 * t256 - t107 * t255 + t108 * t254 - t110 * t253
        - t112 * t252 - t114 * t250;
    let t258 = t242 * t93 - t95 * t257 - t97 * t256 - t99 * t253 - t101 * t252
        - t103 * t250;
    let t259 = t241 * t80 - t82 * t258 + t84 * t257 - t86 * t256 - t88 * t253
        - t90 * t252 - t92 * t250;
    let t260 = t240 * t67 - t69 * t259 - t71 * t258 - t74 * t253 - t77 * t252
        - t79 * t250;
    let t261 = t238 * t52 - t55 * t260 - t57 * t259 - t58 * t258 - t61 * t253
        + t63 * t252 - t65 * t250;
    let t262 = -(t46 * t261) - t48 * t260 - t50 * t250;
    let t263 = -(t36 * t262) - t38 * t261 - t36 * t260 + t40 * t250;
    let drum_v_y_dot_by_winding_force = R::literal(0.666_666_666_666_666_6)
        * (t154 * t251) + t31 * t251;
    let drum_v_x_dot_by_winding_force = R::literal(0.666_666_666_666_666_6)
        * (t153 * t251) + t30 * t251;
    let bobbin_v_y_dot_by_winding_force = t28 - inverse_bobbin_mass * t252 - t29 * t251;
    let bobbin_v_x_dot_by_winding_force = -t29 - inverse_bobbin_mass * t253 - t28 * t251;
    let rod_omega_dot_by_winding_force = t26 * t255
        - R::literal(4_166.666_666_666_667) * t257 - t27 * t254;
    let rod_v_y_dot_by_winding_force = -(t25 * t256) - R::literal(5.0) * t254;
    let rod_v_x_dot_by_winding_force = t24 * t256 - R::literal(5.0) * t255;
    let cylinder_omega_dot_by_winding_force = t22 * t258 - t21 * t259
        - R::literal(-2_777.777_777_777_778) * t257 + t23 * t256;
    let cylinder_v_y_dot_by_winding_force = t20 * t256
        - R::literal(3.333_333_333_333_333_5) * t258;
    let cylinder_v_x_dot_by_winding_force = -(R::literal(3.333_333_333_333_333_5) * t259)
        - t19 * t256;
    let plate_omega_dot_by_winding_force = -(p.bobbin_radius * R::literal(400.0))
        - t15 * t261 + t16 * t260 - t15 * t259 + t16 * t258 + t17 * t253 - t18 * t252;
    let plate_v_y_dot_by_winding_force = -(R::literal(0.833_333_333_333_333_4) * t260)
        - R::literal(-0.833_333_333_333_333_4) * t258
        - R::literal(-0.833_333_333_333_333_4) * t252;
    let plate_v_x_dot_by_winding_force = -(R::literal(0.833_333_333_333_333_4) * t261)
        - R::literal(-0.833_333_333_333_333_4) * t259
        - R::literal(-0.833_333_333_333_333_4) * t253;
    let post_omega_dot_by_winding_force = t13 * t262 - t12 * t263 - t12 * t261
        + t13 * t260 - t14 * t250;
    let post_v_y_dot_by_winding_force = -(R::literal(1.25) * t262)
        - R::literal(-1.25) * t260;
    let post_v_x_dot_by_winding_force = -(R::literal(1.25) * t263)
        - R::literal(-1.25) * t261;
    let t264 = t28 * t207
        - (-t200
            - inverse_bobbin_mass
                * (t201 * t142 - t144 * t208 + t145 * t207 - t147 * t206));
    let t265 = R::literal(-9.81) - bobbin_v_y_dot;
    let t266 = inverse_bobbin_mass * t264;
    let t267 = inverse_bobbin_mass * t265;
    let t268 = t144 * t266 - t267;
    let t269 = -(t28 * t264) - t29 * t265 - t145 * t266 - t150 * t268;
    let t270 = (t147 * t266 - t152 * t268 - t157 * t269) * t159;
    let t271 = t269 * t155 - t157 * t270;
    let t272 = t268 * t148 - t150 * t271 - t152 * t270;
    let t273 = -(t266 * t142) - t144 * t272 + t145 * t271 - t147 * t270;
    let t274 = -(t137 * t273) - t139 * t272 - t141 * t270;
    let t275 = -(t128 * t274) - t130 * t273 - t132 * t272 - t134 * t270;
    let t276 = -(t117 * t275) - t119 * t274 - t121 * t273 - t123 * t272 - t125 * t270;
    let t277 = -(t106 * t276) - t107 * t275 + t108 * t274 - t110 * t273 - t112 * t272
        - t114 * t270;
    let t278 = -(t95 * t277) - t97 * t276 - t99 * t273 - t101 * t272 - t103 * t270;
    let t279 = t84 * t277 - t82 * t278 - t86 * t276 - t88 * t273 - t90 * t272
        - t92 * t270;
    let t280 = -(t69 * t279) - t71 * t278 - t74 * t273 - t77 * t272 - t79 * t270;
    let t281 = -(t55 * t280) - t57 * t279 - t58 * t278 - t61 * t273 + t63 * t272
        - t65 * t270;
    let t282 = -(t46 * t281) - t48 * t280 - t50 * t270;
    let t283 = -(t36 * t282) - t38 * t281 - t36 * t280 + t40 * t270;
    let drum_v_y_dot_by_bobbin_mass = R::literal(0.666_666_666_666_666_6) * (t154 * t271)
        + t31 * t271;
    let drum_v_x_dot_by_bobbin_mass = R::literal(0.666_666_666_666_666_6) * (t153 * t271)
        + t30 * t271;
    let bobbin_v_y_dot_by_bobbin_mass = t267 - inverse_bobbin_mass * t272 - t29 * t271;
    let bobbin_v_x_dot_by_bobbin_mass = t266 - inverse_bobbin_mass * t273 - t28 * t271;
    let rod_omega_dot_by_bobbin_mass = t26 * t275
        - R::literal(4_166.666_666_666_667) * t277 - t27 * t274;
    let rod_v_y_dot_by_bobbin_mass = -(t25 * t276) - R::literal(5.0) * t274;
    let rod_v_x_dot_by_bobbin_mass = t24 * t276 - R::literal(5.0) * t275;
    let cylinder_omega_dot_by_bobbin_mass = t22 * t278 - t21 * t279
        - R::literal(-2_777.777_777_777_778) * t277 + t23 * t276;
    let cylinder_v_y_dot_by_bobbin_mass = t20 * t276
        - R::literal(3.333_333_333_333_333_5) * t278;
    let cylinder_v_x_dot_by_bobbin_mass = -(R::literal(3.333_333_333_333_333_5) * t279)
        - t19 * t276;
    let plate_omega_dot_by_bobbin_mass = t16 * t280 - t15 * t281 - t15 * t279
        + t16 * t278 + t17 * t273 - t18 * t272;
    let plate_v_y_dot_by_bobbin_mass = -(R::literal(0.833_333_333_333_333_4) * t280)
        - R::literal(-0.833_333_333_333_333_4) * t278
        - R::literal(-0.833_333_333_333_333_4) * t272;
    let plate_v_x_dot_by_bobbin_mass = -(R::literal(0.833_333_333_333_333_4) * t281)
        - R::literal(-0.833_333_333_333_333_4) * t279
        - R::literal(-0.833_333_333_333_333_4) * t273;
    let post_omega_dot_by_bobbin_mass = t13 * t282 - t12 * t283 - t12 * t281 + t13 * t280
        - t14 * t270;
    let post_v_y_dot_by_bobbin_mass = -(R::literal(1.25) * t282)
        - R::literal(-1.25) * t280;
    let post_v_x_dot_by_bobbin_mass = -(R::literal(1.25) * t283)
        - R::literal(-1.25) * t281;
    let t284 = slide_minus_spring_free_length * cos_cylinder_phi;
    let t285 = slide_minus_spring_free_length * sin_cylinder_phi;
    let t286 = slide_minus_spring_free_length * t8;
    let t287 = R::literal(3.333_333_333_333_333_5) * t284;
    let t288 = t21 * t286 - t287;
    let t289 = R::literal(3.333_333_333_333_333_5) * t285;
    let t290 = -t289 - t22 * t286 - t82 * t288;
    let t291 = R::literal(-2_777.777_777_777_778) * t286 + t84 * t288 - t95 * t290;
    let t292 = t20 * t285 - t19 * t284 - t23 * t286 - t24 * t284 + t25 * t285
        - t86 * t288 - t97 * t290 - t106 * t291;
    let t293 = R::literal(5.0) * t284;
    let t294 = t293 - t107 * t291 - t117 * t292;
    let t295 = R::literal(5.0) * t285;
    let t296 = t295 + t108 * t291 - t119 * t292 - t128 * t294;
    let t297 = -(t88 * t288) - t99 * t290 - t110 * t291 - t121 * t292 - t130 * t294
        - t137 * t296;
    let t298 = -(t90 * t288) - t101 * t290 - t112 * t291 - t123 * t292 - t132 * t294
        - t139 * t296 - t144 * t297;
    let t299 = t145 * t297 - t150 * t298;
    let t300 = (-(t92 * t288) - t103 * t290 - t114 * t291 - t125 * t292 - t134 * t294
        - t141 * t296 - t147 * t297 - t152 * t298 - t157 * t299) * t159;
    let t301 = t299 * t155 - t157 * t300;
    let t302 = t298 * t148 - t150 * t301 - t152 * t300;
    let t303 = t297 * t142 - t144 * t302 + t145 * t301 - t147 * t300;
    let t304 = t296 * t135 - t137 * t303 - t139 * t302 - t141 * t300;
    let t305 = t294 * t126 - t128 * t304 - t130 * t303 - t132 * t302 - t134 * t300;
    let t306 = t292 * t115 - t117 * t305 - t119 * t304 - t121 * t303 - t123 * t302
        - t125 * t300;
    let t307 = t291 * t104 - t106 * t306 - t107 * t305 + t108 * t304 - t110 * t303
        - t112 * t302 - t114 * t300;
    let t308 = t290 * t93 - t95 * t307 - t97 * t306 - t99 * t303 - t101 * t302
        - t103 * t300;
    let t309 = t288 * t80 - t82 * t308 + t84 * t307 - t86 * t306 - t88 * t303
        - t90 * t302 - t92 * t300;
    let t310 = -(t69 * t309) - t71 * t308 - t74 * t303 - t77 * t302 - t79 * t300;
    let t311 = -(t55 * t310) - t57 * t309 - t58 * t308 - t61 * t303 + t63 * t302
        - t65 * t300;
    let t312 = -(t46 * t311) - t48 * t310 - t50 * t300;
    let t313 = -(t36 * t312) - t38 * t311 - t36 * t310 + t40 * t300;
    let drum_v_y_dot_by_spring_stiffness = R::literal(0.666_666_666_666_666_6)
        * (t154 * t301) + t31 * t301;
    let drum_v_x_dot_by_spring_stiffness = R::literal(0.666_666_666_666_666_6)
        * (t153 * t301) + t30 * t301;
    let bobbin_v_y_dot_by_spring_stiffness = -(inverse_bobbin_mass * t302) - t29 * t301;
    let bobbin_v_x_dot_by_spring_stiffness = -(inverse_bobbin_mass * t303) - t28 * t301;
    let rod_omega_dot_by_spring_stiffness = t26 * t305
        - R::literal(4_166.666_666_666_667) * t307 - t27 * t304;
    let rod_v_y_dot_by_spring_stiffness = -t295 - t25 * t306 - R::literal(5.0) * t304;
    let rod_v_x_dot_by_spring_stiffness = t24 * t306 - t293 - R::literal(5.0) * t305;
    let cylinder_omega_dot_by_spring_stiffness = -(t286
        * R::literal(2_777.777_777_777_778)) - t21 * t309 + t22 * t308
        - R::literal(-2_777.777_777_777_778) * t307 + t23 * t306;
    let cylinder_v_y_dot_by_spring_stiffness = t289
        - R::literal(3.333_333_333_333_333_5) * t308 + t20 * t306;
    let cylinder_v_x_dot_by_spring_stiffness = t287
        - R::literal(3.333_333_333_333_333_5) * t309 - t19 * t306;
    let plate_omega_dot_by_spring_stiffness = t16 * t310 - t15 * t311 - t15 * t309
        + t16 * t308 + t17 * t303 - t18 * t302;
    let plate_v_y_dot_by_spring_stiffness = -(R::literal(0.833_333_333_333_333_4) * t310)
        - R::literal(-0.833_333_333_333_333_4) * t308
        - R::literal(-0.833_333_333_333_333_4) * t302;
    let plate_v_x_dot_by_spring_stiffness = -(R::literal(0.833_333_333_333_333_4) * t311)
        - R::literal(-0.833_333_333_333_333_4) * t309
        - R::literal(-0.833_333_333_333_333_4) * t303;
    let post_omega_dot_by_spring_stiffness = t13 * t312 - t12 * t313 - t12 * t311
        + t13 * t310 - t14 * t300;
    let post_v_y_dot_by_spring_stiffness = -(R::literal(1.25) * t312)
        - R::literal(-1.25) * t310;
    let post_v_x_dot_by_spring_stiffness = -(R::literal(1.25) * t313)
        - R::literal(-1.25) * t311;
    let t314 = R::literal(3.333_333_333_333_333_5) * t209;
    let t315 = t314 - t21 * t210;
    let t316 = R::literal(3.333_333_333_333_333_5) * t211;
    let t317 = t316 + t22 * t210 - t82 * t315;
    let t318 = t84 * t315 - R::literal(-2_777.777_777_777_778) * t210 - t95 * t317;
    let t319 = t19 * t209 - t20 * t211 + t23 * t210 + t24 * t209 - t25 * t211
        - t86 * t315 - t97 * t317 - t106 * t318;
    let t320 = R::literal(5.0) * t209;
    let t321 = -t320 - t107 * t318 - t117 * t319;
    let t322 = R::literal(5.0) * t211;
    let t323 = t108 * t318 - t322 - t119 * t319 - t128 * t321;
    let t324 = -(t88 * t315) - t99 * t317 - t110 * t318 - t121 * t319 - t130 * t321
        - t137 * t323;
    let t325 = -(t90 * t315) - t101 * t317 - t112 * t318 - t123 * t319 - t132 * t321
        - t139 * t323 - t144 * t324;
    let t326 = t145 * t324 - t150 * t325;
    let t327 = (-(t92 * t315) - t103 * t317 - t114 * t318 - t125 * t319 - t134 * t321
        - t141 * t323 - t147 * t324 - t152 * t325 - t157 * t326) * t159;
    let t328 = t326 * t155 - t157 * t327;
    let t329 = t325 * t148 - t150 * t328 - t152 * t327;
    let t330 = t324 * t142 - t144 * t329 + t145 * t328 - t147 * t327;
    let t331 = t323 * t135 - t137 * t330 - t139 * t329 - t141 * t327;
    let t332 = t321 * t126 - t128 * t331 - t130 * t330 - t132 * t329 - t134 * t327;
    let t333 = t319 * t115 - t117 * t332 - t119 * t331 - t121 * t330 - t123 * t329
        - t125 * t327;
    let t334 = t318 * t104 - t106 * t333 - t107 * t332 + t108 * t331 - t110 * t330
        - t112 * t329 - t114 * t327;
    let t335 = t317 * t93 - t95 * t334 - t97 * t333 - t99 * t330 - t101 * t329
        - t103 * t327;
    let t336 = t315 * t80 - t82 * t335 + t84 * t334 - t86 * t333 - t88 * t330
        - t90 * t329 - t92 * t327;
    let t337 = -(t69 * t336) - t71 * t335 - t74 * t330 - t77 * t329 - t79 * t327;
    let t338 = -(t55 * t337) - t57 * t336 - t58 * t335 - t61 * t330 + t63 * t329
        - t65 * t327;
    let t339 = -(t46 * t338) - t48 * t337 - t50 * t327;
    let t340 = -(t36 * t339) - t38 * t338 - t36 * t337 + t40 * t327;
    let drum_v_y_dot_by_spring_free_length = R::literal(0.666_666_666_666_666_6)
        * (t154 * t328) + t31 * t328;
    let drum_v_x_dot_by_spring_free_length = R::literal(0.666_666_666_666_666_6)
        * (t153 * t328) + t30 * t328;
    let bobbin_v_y_dot_by_spring_free_length = -(inverse_bobbin_mass * t329)
        - t29 * t328;
    let bobbin_v_x_dot_by_spring_free_length = -(inverse_bobbin_mass * t330)
        - t28 * t328;
    let rod_omega_dot_by_spring_free_length = t26 * t332
        - R::literal(4_166.666_666_666_667) * t334 - t27 * t331;
    let rod_v_y_dot_by_spring_free_length = t322 - t25 * t333 - R::literal(5.0) * t331;
    let rod_v_x_dot_by_spring_free_length = t320 + t24 * t333 - R::literal(5.0) * t332;
    let cylinder_omega_dot_by_spring_free_length = t210
        * R::literal(2_777.777_777_777_778) - t21 * t336 + t22 * t335
        - R::literal(-2_777.777_777_777_778) * t334 + t23 * t333;
    let cylinder_v_y_dot_by_spring_free_length = -t316
        - R::literal(3.333_333_333_333_333_5) * t335 + t20 * t333;
    let cylinder_v_x_dot_by_spring_free_length = -t314
        - R::literal(3.333_333_333_333_333_5) * t336 - t19 * t333;
    let plate_omega_dot_by_spring_free_length = t16 * t337 - t15 * t338 - t15 * t336
        + t16 * t335 + t17 * t330 - t18 * t329;
    let plate_v_y_dot_by_spring_free_length = -(R::literal(0.833_333_333_333_333_4)
        * t337) - R::literal(-0.833_333_333_333_333_4) * t335
        - R::literal(-0.833_333_333_333_333_4) * t329;
    let plate_v_x_dot_by_spring_free_length = -(R::literal(0.833_333_333_333_333_4)
        * t338) - R::literal(-0.833_333_333_333_333_4) * t336
        - R::literal(-0.833_333_333_333_333_4) * t330;
    let post_omega_dot_by_spring_free_length = t13 * t339 - t12 * t340 - t12 * t338
        + t13 * t337 - t14 * t327;
    let post_v_y_dot_by_spring_free_length = -(R::literal(1.25) * t339)
        - R::literal(-1.25) * t337;
    let post_v_x_dot_by_spring_free_length = -(R::literal(1.25) * t340)
        - R::literal(-1.25) * t338;
    [
        post_v_x_dot_by_bobbin_radius,
        post_v_x_dot_by_winding_force,
        post_v_x_dot_by_bobbin_mass,
        post_v_x_dot_by_spring_stiffness,
        post_v_x_dot_by_spring_free_length,
        post_v_y_dot_by_bobbin_radius,
        post_v_y_dot_by_winding_force,
        post_v_y_dot_by_bobbin_mass,
        post_v_y_dot_by_spring_stiffness,
        post_v_y_dot_by_spring_free_length,
        post_omega_dot_by_bobbin_radius,
        post_omega_dot_by_winding_force,
        post_omega_dot_by_bobbin_mass,
        post_omega_dot_by_spring_stiffness,
        post_omega_dot_by_spring_free_length,
        plate_v_x_dot_by_bobbin_radius,
        plate_v_x_dot_by_winding_force,
        plate_v_x_dot_by_bobbin_mass,
        plate_v_x_dot_by_spring_stiffness,
        plate_v_x_dot_by_spring_free_length,
        plate_v_y_dot_by_bobbin_radius,
        plate_v_y_dot_by_winding_force,
        plate_v_y_dot_by_bobbin_mass,
        plate_v_y_dot_by_spring_stiffness,
        plate_v_y_dot_by_spring_free_length,
        plate_omega_dot_by_bobbin_radius,
        plate_omega_dot_by_winding_force,
        plate_omega_dot_by_bobbin_mass,
        plate_omega_dot_by_spring_stiffness,
        plate_omega_dot_by_spring_free_length,
        cylinder_v_x_dot_by_bobbin_radius,
        cylinder_v_x_dot_by_winding_force,
        cylinder_v_x_dot_by_bobbin_mass,
        cylinder_v_x_dot_by_spring_stiffness,
        cylinder_v_x_dot_by_spring_free_length,
        cylinder_v_y_dot_by_bobbin_radius,
        cylinder_v_y_dot_by_winding_force,
        cylinder_v_y_dot_by_bobbin_mass,
        cylinder_v_y_dot_by_spring_stiffness,
        cylinder_v_y_dot_by_spring_free_length,
        cylinder_omega_dot_by_bobbin_radius,
        cylinder_omega_dot_by_winding_force,
        cylinder_omega_dot_by_bobbin_mass,
        cylinder_omega_dot_by_spring_stiffness,
        cylinder_omega_dot_by_spring_free_length,
        rod_v_x_dot_by_bobbin_radius,
        rod_v_x_dot_by_winding_force,
        rod_v_x_dot_by_bobbin_mass,
        rod_v_x_dot_by_spring_stiffness,
        rod_v_x_dot_by_spring_free_length,
        rod_v_y_dot_by_bobbin_radius,
        rod_v_y_dot_by_winding_force,
        rod_v_y_dot_by_bobbin_mass,
        rod_v_y_dot_by_spring_stiffness,
        rod_v_y_dot_by_spring_free_length,
        rod_omega_dot_by_bobbin_radius,
        rod_omega_dot_by_winding_force,
        rod_omega_dot_by_bobbin_mass,
        rod_omega_dot_by_spring_stiffness,
        rod_omega_dot_by_spring_free_length,
        bobbin_v_x_dot_by_bobbin_radius,
        bobbin_v_x_dot_by_winding_force,
        bobbin_v_x_dot_by_bobbin_mass,
        bobbin_v_x_dot_by_spring_stiffness,
        bobbin_v_x_dot_by_spring_free_length,
        bobbin_v_y_dot_by_bobbin_radius,
        bobbin_v_y_dot_by_winding_force,
        bobbin_v_y_dot_by_bobbin_mass,
        bobbin_v_y_dot_by_spring_stiffness,
        bobbin_v_y_dot_by_spring_free_length,
        drum_v_x_dot_by_bobbin_radius,
        drum_v_x_dot_by_winding_force,
        drum_v_x_dot_by_bobbin_mass,
        drum_v_x_dot_by_spring_stiffness,
        drum_v_x_dot_by_spring_free_length,
        drum_v_y_dot_by_bobbin_radius,
        drum_v_y_dot_by_winding_force,
        drum_v_y_dot_by_bobbin_mass,
        drum_v_y_dot_by_spring_stiffness,
        drum_v_y_dot_by_spring_free_length,
    ]
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
/// 804 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, bobbin_phi, drum_x, drum_y, drum_phi, _, _,
    post_omega, _, _, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x,
    rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x, drum_v_y, ..] = *state;
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let cos_rod_phi = rod_phi.cos();
    let t6 = R::literal(0.06) * cos_rod_phi;
    let sin_rod_phi = rod_phi.sin();
    let t7 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t8 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t8 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let t9 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let t10 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = t1 * R::literal(370.370_370_370_370_3);
    let t13 = t0 * R::literal(370.370_370_370_370_3);
    let t14 = t9 * R::literal(370.370_370_370_370_3);
    let t15 = t3 * R::literal(400.0);
    let t16 = t2 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = t5 * R::literal(2_777.777_777_777_778);
    let t22 = t4 * R::literal(2_777.777_777_777_778);
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = t7 * R::literal(4_166.666_666_666_667);
    let t27 = t6 * R::literal(4_166.666_666_666_667);
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(-1.25) - t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(-1.25) - t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t42 - t43);
    let t45 = t12 * t0 - t38 * t35;
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = t14 * t0 + t40 * t35;
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51 - t38 * t37 - t46 * t45);
    let t53 = t16 * t3;
    let t54 = t35 + t53 - t36 * t37 - t48 * t45;
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t40 * t37 - t39 - t50 * t45;
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43 - t48 * t47
            - t55 * t54);
    let t68 = t15 * t2 - t57 * t54;
    let t69 = t68 * t67;
    let t70 = R::literal(0.833_333_333_333_333_4) - t66 - t58 * t54;
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72 - t61 * t54;
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = R::literal(0.833_333_333_333_333_4) + t75 + t63 * t54;
    let t77 = t76 * t67;
    let t78 = t49 - t50 * t47 - t65 * t54;
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5) - t21 * t5 - t57 * t56 - t69 * t68);
    let t81 = t53 + t22 * t5 - t58 * t56 - t71 * t68;
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = t23 * t5 - t19;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t59 - t61 * t56 - t74 * t68;
    let t88 = t87 * t80;
    let t89 = t63 * t56 - t62 - t77 * t68;
    let t90 = t89 * t80;
    let t91 = -(t65 * t56) - t79 * t68;
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5) - t22 * t4 - t58 * t53 - t71 * t70
            - t82 * t81);
    let t94 = R::literal(-2_777.777_777_777_778) * t4 + t84 * t81;
    let t95 = t94 * t93;
    let t96 = t20 - t23 * t4 - t86 * t81;
    let t97 = t96 * t93;
    let t98 = t72 - t61 * t53 - t74 * t70 - t88 * t81;
    let t99 = t98 * t93;
    let t100 = R::literal(-0.833_333_333_333_333_4) + t75 + t63 * t53 - t77 * t70
        - t90 * t81;
    let t101 = t100 * t93;
    let t102 = -(t65 * t53) - t79 * t70 - t92 * t81;
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t84 * t83 - t95 * t94);
    let t105 = t86 * t83 - t23 - t97 * t94;
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = t88 * t83 - t99 * t94;
    let t110 = t109 * t104;
    let t111 = t90 * t83 - t101 * t94;
    let t112 = t111 * t104;
    let t113 = t92 * t83 - t103 * t94;
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi) - t20 * cos_cylinder_phi - t23 * slide
            - t24 * sin_cylinder_phi - t25 * cos_cylinder_phi - t86 * t85 - t97 * t96
            - t106 * t105);
    let t116 = t24 - t107 * t105;
    let t117 = t116 * t115;
    let t118 = t108 * t105 - t25;
    let t119 = t118 * t115;
    let t120 = -(t88 * t85) - t99 * t96 - t110 * t105;
    let t121 = t120 * t115;
    let t122 = -(t90 * t85) - t101 * t96 - t112 * t105;
    let t123 = t122 * t115;
    let t124 = -(t92 * t85) - t103 * t96 - t114 * t105;
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / (R::literal(-5.0) - t26 * t7 - t107 * t26 - t117 * t116);
    let t127 = t27 * t7 + t108 * t26 - t119 * t116;
    let t128 = t127 * t126;
    let t129 = -(t110 * t26) - t121 * t116;
    let t130 = t129 * t126;
    let t131 = -(t112 * t26) - t123 * t116;
    let t132 = t131 * t126;
    let t133 = -(t114 * t26) - t125 * t116;
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / (R::literal(-5.0) - t27 * t6 - t108 * t27 - t119 * t118 - t128 * t127);
    let t136 = t110 * t27 - t121 * t118 - t130 * t127;
    let t137 = t136 * t135;
    let t138 = t112 * t27 - t123 * t118 - t132 * t127;
    let t139 = t138 * t135;
    let t140 = t114 * t27 - t125 * t118 - t134 * t127;
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t10 - inverse_bobbin_mass
            - t61 * t60 - t74 * t73 - t88 * t87 - t99 * t98 - t110 * t109 - t121 * t120
            - t130 * t129 - t137 * t136);
    let t143 = t18 * t10 + t63 * t60 - t77 * t73 - t90 * t87 - t101 * t98 - t112 * t109
        - t123 * t120 - t132 * t129 - t139 * t136;
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = -(t65 * t60) - t79 * t73 - t92 * t87 - t103 * t98 - t114 * t109
        - t125 * t120 - t134 * t129 - t141 * t136;
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t11 - inverse_bobbin_mass
            - t63 * t62 - t77 * t76 - t90 * t89 - t101 * t100 - t112 * t111 - t123 * t122
            - t132 * t131 - t139 * t138 - t144 * t143);
    let t149 = t145 * t143 - t29;
    let t150 = t149 * t148;
    let t151 = t65 * t62 - t79 * t76 - t92 * t89 - t103 * t100 - t114 * t111
        - t125 * t122 - t134 * t131 - t141 * t138 - t147 * t143;
    let t152 = t151 * t148;
    let t153 = t31 * R::literal(-1.5);
    let t154 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between)
            - t29 * bobbin_y_minus_drum_y_over_between
            - t30 * bobbin_x_minus_drum_x_over_between
            - t31 * bobbin_y_minus_drum_y_over_between - t145 * t28 - t150 * t149
            - t30 * R::literal(-1.5) * t30 - t153 * t31);
    let t155 = t147 * t28 - t152 * t149;
    let t156 = t155 * t154;
    let t157 = -(t14 * t9) - t40 * t39 - t50 * t49 - t65 * t64 - t79 * t78 - t92 * t91
        - t103 * t102 - t114 * t113 - t125 * t124 - t134 * t133 - t141 * t140
        - t147 * t146;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t158 = R::literal(50.0) * slide_rate;
    let t159 = t158 * cos_cylinder_phi;
    let t160 = p.spring_stiffness * (slide - p.spring_free_length);
    let t161 = t160 * cos_cylinder_phi;
    let t162 = t159 + t161;
    let t163 = t160 * sin_cylinder_phi;
    let t164 = t158 * sin_cylinder_phi;
    let t165 = t164 - (R::literal(2.943) - t163);
    let t166 = -(t158 * t8) - t160 * t8;
    let t167 = -t159 - t161;
    let t168 = -t164 - (R::literal(1.962) + t163);
    let t169 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t170 = p.winding_force * bobbin_x_minus_drum_x / between
        - R::literal(9.81) * p.bobbin_mass;
    let post_omega_squared = post_omega * post_omega;
    let t171 = R::literal(0.1) * post_omega_squared;
    let t172 = t171 * cos_post_phi;
    let t173 = t171 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t174 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t175 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t176 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t177 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t178 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t179 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t180 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t182 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t183 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t184 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t185 = bobbin_v_x
        * (bobbin_v_x_over_between + t179 + t180 - t177 - t178 - drum_v_x_over_between)
        + bobbin_v_y
            * (bobbin_v_y_over_between + t183 + t184 - t181 - t182
                - drum_v_y_over_between)
        + drum_v_x
            * (t177 + t178 + drum_v_x_over_between - bobbin_v_x_over_between - t179
                - t180);
    let t186 = t36 * t172;
    let t187 = -t173 - R::literal(-9.81) + t186;
    let t188 = t15 * bobbin_radius_times_winding_force;
    let t189 = t188 - (t174 * cos_plate_phi + t172) + t38 * t172 - t46 * t187;
    let t190 = t16 * bobbin_radius_times_winding_force;
    let t191 = -(t174 * sin_plate_phi + t173) - R::literal(9.81) - R::literal(-9.81)
        - t190 + t186 - t48 * t187 - t55 * t189;
    let t192 = t188
        - R::literal(0.06)
            * (plate_omega_squared * cos_plate_phi
                + cylinder_omega_squared * cos_cylinder_phi)
        - R::literal(3.333_333_333_333_333_5) * t162 - t21 * t166 - t57 * t189
        - t69 * t191;
    let t193 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t190
        - R::literal(3.333_333_333_333_333_5) * t165 + t22 * t166 - t58 * t189
        - t71 * t191 - t82 * t192;
    let t194 = t84 * t192 - R::literal(-2_777.777_777_777_778) * t166 - t95 * t193;
    let t195 = t175 - t19 * t162 + t20 * t165 + t23 * t166 + t24 * t167 - t25 * t168
        - t86 * t192 - t97 * t193 - t106 * t194;
    let t196 = t176 * cos_rod_phi - R::literal(5.0) * t167 - t107 * t194 - t117 * t195;
    let t197 = t176 * sin_rod_phi - R::literal(5.0) * t168 + t108 * t194 - t119 * t195
        - t128 * t196;
    let t198 = t11 * plate_omega_squared - t17 * bobbin_radius_times_winding_force
        + inverse_bobbin_mass * t169 - t61 * t189 - t74 * t191 - t88 * t192 - t99 * t193
        - t110 * t194 - t121 * t195 - t130 * t196 - t137 * t197;
    let t199 = t10 * plate_omega_squared - R::literal(9.81)
        + t18 * bobbin_radius_times_winding_force - inverse_bobbin_mass * t170
        + t63 * t189 - t77 * t191 - t90 * t192 - t101 * t193 - t112 * t194 - t123 * t195
        - t132 * t196 - t139 * t197 - t144 * t198;
    let t200 = t28 * t169
        - (t185
            + drum_v_y
                * (t181 + t182 + drum_v_y_over_between - bobbin_v_y_over_between - t183
                    - t184)) - t29 * t170 + t31 * R::literal(-14.715) + t145 * t198
        - t150 * t199 - t153 * R::literal(9.809_999_999_999_999);
    let t201 = (R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi)
        * post_omega_squared - t40 * t172 - t50 * t187 - t65 * t189 - t79 * t191
        - t92 * t192 - t103 * t193 - t114 * t194 - t125 * t195 - t134 * t196
        - t141 * t197;
    let t202 = (t201 - t147 * t198 - t152 * t199 - t156 * t200)
        * (R::literal(1.0) / (t157 - t152 * t151 - t156 * t155));
    let contact = t156 * t202 - t200 * t154;
    let stop = -t202;
    Outputs {
        contact_force: contact,
        stop_force: stop,
        strut_push: -t158 - t160,
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
    let slide = (rod_x - cylinder_x) * cylinder_phi.cos()
        + (rod_y - cylinder_y) * cylinder_phi.sin();
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t0 = R::literal(0.00012) * (rod_omega * rod_omega)
        + R::literal(0.00018) * (cylinder_omega * cylinder_omega)
        + R::literal(0.0006) * (drum_omega * drum_omega)
        + R::literal(0.00065) * (bobbin_omega * bobbin_omega)
        + R::literal(0.00125) * (plate_omega * plate_omega)
        + R::literal(0.00135) * (post_omega * post_omega)
        + R::literal(0.1) * (rod_v_x * rod_v_x + rod_v_y * rod_v_y);
    let t1 = t0
        + R::literal(0.15) * (cylinder_v_x * cylinder_v_x + cylinder_v_y * cylinder_v_y)
        + R::literal(0.4) * (post_v_x * post_v_x + post_v_y * post_v_y)
        + R::literal(0.5) * p.bobbin_mass
            * (bobbin_v_x * bobbin_v_x + bobbin_v_y * bobbin_v_y)
        + R::literal(0.6) * (plate_v_x * plate_v_x + plate_v_y * plate_v_y);
    Energy {
        kinetic: t1 + R::literal(0.75) * (drum_v_x * drum_v_x + drum_v_y * drum_v_y),
        potential: R::literal(0.5) * p.spring_stiffness
            * (slide_minus_spring_free_length * slide_minus_spring_free_length)
            + R::literal(1.962) * rod_y + R::literal(2.943) * cylinder_y
            + R::literal(7.848) * post_y + R::literal(9.81) * p.bobbin_mass * bobbin_y
            + R::literal(11.772) * plate_y + R::literal(14.715) * drum_y,
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 1103 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, _, drum_v_x,
    drum_v_y, ..] = *state;
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let cos_rod_phi = rod_phi.cos();
    let t6 = R::literal(0.06) * cos_rod_phi;
    let sin_rod_phi = rod_phi.sin();
    let t7 = R::literal(0.06) * sin_rod_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_x_minus_drum_x_squared = bobbin_x_minus_drum_x * bobbin_x_minus_drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let bobbin_y_minus_drum_y_squared = bobbin_y_minus_drum_y * bobbin_y_minus_drum_y;
    let between = (bobbin_x_minus_drum_x_squared + bobbin_y_minus_drum_y_squared).sqrt();
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let t8 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t8 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let t9 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let t10 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let bobbin_x_minus_drum_x_over_between = bobbin_x_minus_drum_x / between;
    let bobbin_y_minus_drum_y_over_between = bobbin_y_minus_drum_y / between;
    let t12 = t1 * R::literal(370.370_370_370_370_3);
    let t13 = t0 * R::literal(370.370_370_370_370_3);
    let t14 = t9 * R::literal(370.370_370_370_370_3);
    let t15 = t3 * R::literal(400.0);
    let t16 = t2 * R::literal(400.0);
    let t17 = t10 * R::literal(400.0);
    let t18 = t11 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = t5 * R::literal(2_777.777_777_777_778);
    let t22 = t4 * R::literal(2_777.777_777_777_778);
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = t7 * R::literal(4_166.666_666_666_667);
    let t27 = t6 * R::literal(4_166.666_666_666_667);
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let t28 = bobbin_x_minus_drum_x_over_between * inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * inverse_bobbin_mass;
    let t30 = bobbin_x_minus_drum_x_over_between * R::literal(0.666_666_666_666_666_6);
    let t31 = bobbin_y_minus_drum_y_over_between * R::literal(0.666_666_666_666_666_6);
    let t32 = t12 * t1;
    let t33 = R::literal(-1.25) - t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t13 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t14 * t1;
    let t40 = t39 * t34;
    let t41 = t13 * t0;
    let t42 = R::literal(-1.25) - t41;
    let t43 = t36 * t35;
    let t44 = R::literal(1.0) / (t42 - t43);
    let t45 = t12 * t0 - t38 * t35;
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = t14 * t0 + t40 * t35;
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51 - t38 * t37 - t46 * t45);
    let t53 = t16 * t3;
    let t54 = t35 + t53 - t36 * t37 - t48 * t45;
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = t40 * t37 - t39 - t50 * t45;
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43 - t48 * t47
            - t55 * t54);
    let t68 = t15 * t2 - t57 * t54;
    let t69 = t68 * t67;
    let t70 = R::literal(0.833_333_333_333_333_4) - t66 - t58 * t54;
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72 - t61 * t54;
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = R::literal(0.833_333_333_333_333_4) + t75 + t63 * t54;
    let t77 = t76 * t67;
    let t78 = t49 - t50 * t47 - t65 * t54;
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5) - t21 * t5 - t57 * t56 - t69 * t68);
    let t81 = t53 + t22 * t5 - t58 * t56 - t71 * t68;
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = t23 * t5 - t19;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t59 - t61 * t56 - t74 * t68;
    let t88 = t87 * t80;
    let t89 = t63 * t56 - t62 - t77 * t68;
    let t90 = t89 * t80;
    let t91 = -(t65 * t56) - t79 * t68;
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5) - t22 * t4 - t58 * t53 - t71 * t70
            - t82 * t81);
    let t94 = R::literal(-2_777.777_777_777_778) * t4 + t84 * t81;
    let t95 = t94 * t93;
    let t96 = t20 - t23 * t4 - t86 * t81;
    let t97 = t96 * t93;
    let t98 = t72 - t61 * t53 - t74 * t70 - t88 * t81;
    let t99 = t98 * t93;
    let t100 = R::literal(-0.833_333_333_333_333_4) + t75 + t63 * t53 - t77 * t70
        - t90 * t81;
    let t101 = t100 * t93;
    let t102 = -(t65 * t53) - t79 * t70 - t92 * t81;
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t84 * t83 - t95 * t94);
    let t105 = t86 * t83 - t23 - t97 * t94;
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = t88 * t83 - t99 * t94;
    let t110 = t109 * t104;
    let t111 = t90 * t83 - t101 * t94;
    let t112 = t111 * t104;
    let t113 = t92 * t83 - t103 * t94;
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi) - t20 * cos_cylinder_phi - t23 * slide
            - t24 * sin_cylinder_phi - t25 * cos_cylinder_phi - t86 * t85 - t97 * t96
            - t106 * t105);
    let t116 = t24 - t107 * t105;
    let t117 = t116 * t115;
    let t118 = t108 * t105 - t25;
    let t119 = t118 * t115;
    let t120 = -(t88 * t85) - t99 * t96 - t110 * t105;
    let t121 = t120 * t115;
    let t122 = -(t90 * t85) - t101 * t96 - t112 * t105;
    let t123 = t122 * t115;
    let t124 = -(t92 * t85) - t103 * t96 - t114 * t105;
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / (R::literal(-5.0) - t26 * t7 - t107 * t26 - t117 * t116);
    let t127 = t27 * t7 + t108 * t26 - t119 * t116;
    let t128 = t127 * t126;
    let t129 = -(t110 * t26) - t121 * t116;
    let t130 = t129 * t126;
    let t131 = -(t112 * t26) - t123 * t116;
    let t132 = t131 * t126;
    let t133 = -(t114 * t26) - t125 * t116;
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / (R::literal(-5.0) - t27 * t6 - t108 * t27 - t119 * t118 - t128 * t127);
    let t136 = t110 * t27 - t121 * t118 - t130 * t127;
    let t137 = t136 * t135;
    let t138 = t112 * t27 - t123 * t118 - t132 * t127;
    let t139 = t138 * t135;
    let t140 = t114 * t27 - t125 * t118 - t134 * t127;
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t10 - inverse_bobbin_mass
            - t61 * t60 - t74 * t73 - t88 * t87 - t99 * t98 - t110 * t109 - t121 * t120
            - t130 * t129 - t137 * t136);
    let t143 = t18 * t10 + t63 * t60 - t77 * t73 - t90 * t87 - t101 * t98 - t112 * t109
        - t123 * t120 - t132 * t129 - t139 * t136;
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = -(t65 * t60) - t79 * t73 - t92 * t87 - t103 * t98 - t114 * t109
        - t125 * t120 - t134 * t129 - t141 * t136;
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t11 - inverse_bobbin_mass
            - t63 * t62 - t77 * t76 - t90 * t89 - t101 * t100 - t112 * t111 - t123 * t122
            - t132 * t131 - t139 * t138 - t144 * t143);
    let t149 = t145 * t143 - t29;
    let t150 = t149 * t148;
    let t151 = t65 * t62 - t79 * t76 - t92 * t89 - t103 * t100 - t114 * t111
        - t125 * t122 - t134 * t131 - t141 * t138 - t147 * t143;
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between)
            - t29 * bobbin_y_minus_drum_y_over_between
            - t30 * bobbin_x_minus_drum_x_over_between
            - t31 * bobbin_y_minus_drum_y_over_between - t145 * t28 - t150 * t149
            - t153 * t30 - t154 * t31);
    let t156 = t147 * t28 - t152 * t149;
    let t157 = t156 * t155;
    let t158 = -(t14 * t9) - t40 * t39 - t50 * t49 - t65 * t64 - t79 * t78 - t92 * t91
        - t103 * t102 - t114 * t113 - t125 * t124 - t134 * t133 - t141 * t140
        - t147 * t146;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t159 = R::literal(50.0) * slide_rate;
    let t160 = t159 * cos_cylinder_phi;
    let t161 = p.spring_stiffness * (slide - p.spring_free_length);
    let t162 = t161 * cos_cylinder_phi;
    let t163 = t160 + t162;
    let t164 = t161 * sin_cylinder_phi;
    let t165 = R::literal(2.943) - t164;
    let t166 = t159 * sin_cylinder_phi;
    let t167 = t166 - t165;
    let t168 = t161 * t8;
    let t169 = -(t159 * t8) - t168;
    let t170 = -t160 - t162;
    let t171 = R::literal(1.962) + t164;
    let t172 = -t166 - t171;
    let t173 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t174 = R::literal(9.81) * p.bobbin_mass;
    let t175 = p.winding_force * bobbin_x_minus_drum_x / between - t174;
    let post_omega_squared = post_omega * post_omega;
    let t176 = R::literal(0.1) * post_omega_squared;
    let t177 = t176 * cos_post_phi;
    let t178 = t176 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t179 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t180 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t181 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t182 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t183 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t184 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t185 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t186 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t187 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t188 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t189 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t190 = bobbin_v_x
        * (bobbin_v_x_over_between + t184 + t185 - t182 - t183 - drum_v_x_over_between)
        + bobbin_v_y
            * (bobbin_v_y_over_between + t188 + t189 - t186 - t187
                - drum_v_y_over_between)
        + drum_v_x
            * (t182 + t183 + drum_v_x_over_between - bobbin_v_x_over_between - t184
                - t185);
    let t191 = t36 * t177;
    let t192 = -t178 - R::literal(-9.81) + t191;
    let t193 = t15 * bobbin_radius_times_winding_force;
    let t194 = t193 - (t179 * cos_plate_phi + t177) + t38 * t177 - t46 * t192;
    let t195 = t16 * bobbin_radius_times_winding_force;
    let t196 = -(t179 * sin_plate_phi + t178) - R::literal(9.81) - R::literal(-9.81)
        - t195 + t191 - t48 * t192 - t55 * t194;
    let t197 = R::literal(3.333_333_333_333_333_5) * t163;
    let t198 = t193
        - R::literal(0.06)
            * (plate_omega_squared * cos_plate_phi
                + cylinder_omega_squared * cos_cylinder_phi) - t197 - t21 * t169
        - t57 * t194 - t69 * t196;
    let t199 = R::literal(3.333_333_333_333_333_5) * t167;
    let t200 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t195
        - t199 + t22 * t169 - t58 * t194 - t71 * t196 - t82 * t198;
    let t201 = t84 * t198 - R::literal(-2_777.777_777_777_778) * t169 - t95 * t200;
    let t202 = t180 - t19 * t163 + t20 * t167 + t23 * t169 + t24 * t170 - t25 * t172
        - t86 * t198 - t97 * t200 - t106 * t201;
    let t203 = R::literal(5.0) * t170;
    let t204 = t181 * cos_rod_phi - t203 - t107 * t201 - t117 * t202;
    let t205 = R::literal(5.0) * t172;
    let t206 = t181 * sin_rod_phi - t205 + t108 * t201 - t119 * t202 - t128 * t204;
    let t207 = inverse_bobbin_mass * t173;
    let t208 = t11 * plate_omega_squared - t17 * bobbin_radius_times_winding_force + t207
        - t61 * t194 - t74 * t196 - t88 * t198 - t99 * t200 - t110 * t201 - t121 * t202
        - t130 * t204 - t137 * t206;
    let t209 = inverse_bobbin_mass * t175;
    let t210 = t10 * plate_omega_squared - R::literal(9.81)
        + t18 * bobbin_radius_times_winding_force - t209 + t63 * t194 - t77 * t196
        - t90 * t198 - t101 * t200 - t112 * t201 - t123 * t202 - t132 * t204
        - t139 * t206 - t144 * t208;
    let t211 = t28 * t173
        - (t190
            + drum_v_y
                * (t186 + t187 + drum_v_y_over_between - bobbin_v_y_over_between - t188
                    - t189)) - t29 * t175 + t31 * R::literal(-14.715) + t145 * t208
        - t150 * t210 - t154 * R::literal(9.809_999_999_999_999);
    let t212 = (R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi)
        * post_omega_squared - t40 * t177 - t50 * t192 - t65 * t194 - t79 * t196
        - t92 * t198 - t103 * t200 - t114 * t201 - t125 * t202 - t134 * t204
        - t141 * t206;
    let t213 = (t212 - t147 * t208 - t152 * t210 - t157 * t211)
        * (R::literal(1.0) / (t158 - t152 * t151 - t157 * t156));
    let t214 = t211 * t155 - t157 * t213;
    let axle_b_x = t153 * t214;
    let t215 = t210 * t148 - t150 * t214 - t152 * t213;
    let t216 = t208 * t142 - t144 * t215 + t145 * t214 - t147 * t213;
    let t217 = t206 * t135 - t137 * t216 - t139 * t215 - t141 * t213;
    let t218 = t204 * t126 - t128 * t217 - t130 * t216 - t132 * t215 - t134 * t213;
    let t219 = t202 * t115 - t117 * t218 - t119 * t217 - t121 * t216 - t123 * t215
        - t125 * t213;
    let t220 = t201 * t104 - t106 * t219 - t107 * t218 + t108 * t217 - t110 * t216
        - t112 * t215 - t114 * t213;
    let t221 = t200 * t93 - t95 * t220 - t97 * t219 - t99 * t216 - t101 * t215
        - t103 * t213;
    let t222 = t198 * t80 - t82 * t221 + t84 * t220 - t86 * t219 - t88 * t216
        - t90 * t215 - t92 * t213;
    let t223 = t196 * t67 - t69 * t222 - t71 * t221 - t74 * t216 - t77 * t215
        - t79 * t213;
    let t224 = t194 * t52 - t55 * t223 - t57 * t222 - t58 * t221 - t61 * t216
        + t63 * t215 - t65 * t213;
    let t225 = t192 * t44 - t46 * t224 - t48 * t223 - t50 * t213;
    let t226 = -(t177 * t34) - t36 * t225 - t38 * t224 - t36 * t223 + t40 * t213;
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        - R::literal(0.666_666_666_666_666_6)
            * (R::literal(-14.714_999_999_999_998) - t154 * t214) + t31 * t214;
    let drum_v_x_dot = R::literal(0.666_666_666_666_666_6) * axle_b_x + t30 * t214;
    let bobbin_v_y_dot = t209 - inverse_bobbin_mass * t215 - t29 * t214;
    let bobbin_v_x_dot = -t207 - inverse_bobbin_mass * t216 - t28 * t214;
    let rod_omega_dot = t26 * t218 - R::literal(4_166.666_666_666_667) * t220
        - t27 * t217;
    let rod_v_y_dot = t205 - t25 * t219 - R::literal(5.0) * t217;
    let rod_v_x_dot = t203 + t24 * t219 - R::literal(5.0) * t218;
    let cylinder_omega_dot = t169 * R::literal(2_777.777_777_777_778) - t21 * t222
        + t22 * t221 - R::literal(-2_777.777_777_777_778) * t220 + t23 * t219;
    let cylinder_v_y_dot = t199 - R::literal(3.333_333_333_333_333_5) * t221
        + t20 * t219;
    let cylinder_v_x_dot = t197 - R::literal(3.333_333_333_333_333_5) * t222
        - t19 * t219;
    let plate_omega_dot = -(bobbin_radius_times_winding_force * R::literal(400.0))
        - t15 * t224 + t16 * t223 - t15 * t222 + t16 * t221 + t17 * t216 - t18 * t215;
    let plate_v_y_dot = R::literal(-9.81) - R::literal(0.833_333_333_333_333_4) * t223
        - R::literal(-0.833_333_333_333_333_4) * t221
        - R::literal(-0.833_333_333_333_333_4) * t215;
    let plate_v_x_dot = -(R::literal(0.833_333_333_333_333_4) * t224)
        - R::literal(-0.833_333_333_333_333_4) * t222
        - R::literal(-0.833_333_333_333_333_4) * t216;
    let post_omega_dot = t13 * t225 - t12 * t226 - t12 * t224 + t13 * t223 - t14 * t213;
    let post_v_y_dot = R::literal(-9.81) - R::literal(1.25) * t225
        - R::literal(-1.25) * t223;
    let post_v_x_dot = -(R::literal(1.25) * t226) - R::literal(-1.25) * t224;
    let t227 = R::literal(7.848) * post_v_y + R::literal(11.772) * plate_v_y
        - t162 * cylinder_v_x + t165 * cylinder_v_y + t168 * cylinder_omega
        + t162 * rod_v_x + t171 * rod_v_y + t174 * bobbin_v_y
        + R::literal(14.715) * drum_v_y + R::literal(0.8) * post_v_x * post_v_x_dot
        + R::literal(0.8) * post_v_y * post_v_y_dot;
    let t228 = t227 + R::literal(0.0027) * post_omega * post_omega_dot
        + R::literal(1.2) * plate_v_x * plate_v_x_dot
        + R::literal(1.2) * plate_v_y * plate_v_y_dot
        + R::literal(0.0025) * plate_omega * plate_omega_dot
        + R::literal(0.3) * cylinder_v_x * cylinder_v_x_dot
        + R::literal(0.3) * cylinder_v_y * cylinder_v_y_dot
        + R::literal(0.00036) * cylinder_omega * cylinder_omega_dot
        + R::literal(0.2) * rod_v_x * rod_v_x_dot;
    PowerBalance {
        stored_rate: t228 + R::literal(0.2) * rod_v_y * rod_v_y_dot
            + R::literal(0.00024) * rod_omega * rod_omega_dot
            + p.bobbin_mass * bobbin_v_x * bobbin_v_x_dot
            + p.bobbin_mass * bobbin_v_y * bobbin_v_y_dot
            + R::literal(1.5) * drum_v_x * drum_v_x_dot
            + R::literal(1.5) * drum_v_y * drum_v_y_dot,
        supplied: p.winding_force * bobbin_v_y * bobbin_x_minus_drum_x / between
            - bobbin_radius_times_winding_force * plate_omega
            - p.winding_force * bobbin_v_x * bobbin_y_minus_drum_y / between,
        dissipated: R::literal(50.0) * cylinder_omega * slide_rate * t8
            + R::literal(50.0) * rod_v_x * slide_rate * cos_cylinder_phi
            + R::literal(50.0) * rod_v_y * slide_rate * sin_cylinder_phi
            - R::literal(50.0) * cylinder_v_x * slide_rate * cos_cylinder_phi
            - R::literal(50.0) * cylinder_v_y * slide_rate * sin_cylinder_phi,
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
    let cos_post_phi = post_phi.cos();
    let t0 = R::literal(0.1) * cos_post_phi;
    let post_start_x = post_x - t0;
    let sin_post_phi = post_phi.sin();
    let t1 = R::literal(0.1) * sin_post_phi;
    let post_start_y = post_y - t1;
    let post_end_x = post_x + t0;
    let post_end_y = post_y + t1;
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let plate_start_x = plate_x - t2;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let plate_start_y = plate_y - t3;
    let plate_end_x = plate_x + t2;
    let plate_end_y = plate_y + t3;
    let cos_cylinder_phi = cylinder_phi.cos();
    let cylinder_start_x = cylinder_x - R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let cylinder_start_y = cylinder_y - R::literal(0.06) * sin_cylinder_phi;
    let rod_end_x = rod_x + R::literal(0.06) * rod_phi.cos();
    let rod_end_y = rod_y + R::literal(0.06) * rod_phi.sin();
    let axle_x = plate_x + R::literal(0.1) * sin_plate_phi
        - R::literal(0.01) * cos_plate_phi;
    let axle_y = plate_y - R::literal(0.1) * cos_plate_phi
        - R::literal(0.01) * sin_plate_phi;
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x
        + bobbin_y_minus_drum_y * bobbin_y_minus_drum_y)
        .sqrt();
    let slide_across_value = (rod_y - cylinder_y) * cos_cylinder_phi
        - (rod_x - cylinder_x) * sin_cylinder_phi;
    let stop_value = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
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
/// 84 operations.
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
    let cos_post_phi = post_phi.cos();
    let sin_post_phi = post_phi.sin();
    let cos_plate_phi = plate_phi.cos();
    let sin_plate_phi = plate_phi.sin();
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x
        + bobbin_y_minus_drum_y * bobbin_y_minus_drum_y)
        .sqrt();
    let slide = (rod_x - cylinder_x) * cos_cylinder_phi
        + (rod_y - cylinder_y) * sin_cylinder_phi;
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
    let pin_d_x_rate = cylinder_v_x + t4 + t6 * sin_cylinder_phi - plate_v_x;
    let pin_d_y_rate = cylinder_v_y - plate_v_y - t5 - t6 * cos_cylinder_phi;
    let slide_angle_rate = rod_omega - cylinder_omega;
    let slide_across_rate = cylinder_v_x * sin_cylinder_phi + rod_v_y * cos_cylinder_phi
        - cylinder_v_y * cos_cylinder_phi - cylinder_omega * slide
        - rod_v_x * sin_cylinder_phi;
    let t7 = R::literal(0.06) * rod_omega;
    let pin_e_x_rate = rod_v_x - t7 * rod_phi.sin();
    let pin_e_y_rate = rod_v_y + t7 * rod_phi.cos();
    let axle_a_x_rate = bobbin_v_x - plate_v_x
        - plate_omega
            * (R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi);
    let axle_a_y_rate = bobbin_v_y - plate_v_y
        - plate_omega
            * (R::literal(0.1) * sin_plate_phi - R::literal(0.01) * cos_plate_phi);
    let contact_rate = bobbin_v_x * bobbin_x_minus_drum_x / between
        + bobbin_v_y * bobbin_y_minus_drum_y / between
        - drum_v_x * bobbin_x_minus_drum_x / between
        - drum_v_y * bobbin_y_minus_drum_y / between;
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi);
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
    let cos_post_phi = post_phi.cos();
    let sin_post_phi = post_phi.sin();
    let t0 = R::literal(0.1) * sin_post_phi;
    let cos_plate_phi = plate_phi.cos();
    let sin_plate_phi = plate_phi.sin();
    let t1 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let bobbin_x_minus_drum_x = bobbin_x - drum_x;
    let bobbin_y_minus_drum_y = bobbin_y - drum_y;
    let between = (bobbin_x_minus_drum_x * bobbin_x_minus_drum_x
        + bobbin_y_minus_drum_y * bobbin_y_minus_drum_y)
        .sqrt();
    let slide = (rod_x - cylinder_x) * cos_cylinder_phi
        + (rod_y - cylinder_y) * sin_cylinder_phi;
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
        -(R::literal(0.06) * rod_phi.sin()),
        R::literal(1.0),
        R::literal(0.06) * rod_phi.cos(),
        R::literal(-1.0),
        -(R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi),
        R::literal(1.0),
        R::literal(-1.0),
        R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi,
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        bobbin_x_minus_drum_x_over_between,
        bobbin_y_minus_drum_y_over_between,
        -bobbin_x_minus_drum_x_over_between,
        -bobbin_y_minus_drum_y_over_between,
        R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi,
    ]
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 1077 recurrences. 491 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
    let (mut lanes, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_7, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_8, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_9, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_10, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_11, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_12, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_13, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_14, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_15, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_16, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_17, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_18, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_19, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_20, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_21, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_22, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_23, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_24, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_25, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_26, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_27, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_28, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_29, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_30, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_31, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_32, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_33, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_34, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_35, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_36, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_37, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_38, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_39, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_40, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_41, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_42, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_43, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_44, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_45, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_46, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_47, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_48, workspace) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let (mut lanes_49, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, drum_x, drum_y, _, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, bobbin_omega,
    drum_v_x, drum_v_y, drum_omega] = *state;
    let sin_post_phi = post_phi.sin();
    let cos_post_phi = post_phi.cos();
    let t0 = cos_post_phi * R::literal(0.1);
    let t1 = sin_post_phi * R::literal(0.1);
    let sin_plate_phi = plate_phi.sin();
    let cos_plate_phi = plate_phi.cos();
    let t2 = cos_plate_phi * R::literal(0.06);
    let t3 = sin_plate_phi * R::literal(0.06);
    let sin_cylinder_phi = cylinder_phi.sin();
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = cos_cylinder_phi * R::literal(0.06);
    let t5 = sin_cylinder_phi * R::literal(0.06);
    let sin_rod_phi = rod_phi.sin();
    let cos_rod_phi = rod_phi.cos();
    let t6 = cos_rod_phi * R::literal(0.06);
    let t7 = sin_rod_phi * R::literal(0.06);
    let t8 = cos_plate_phi * R::literal(0.01);
    let t9 = sin_plate_phi * R::literal(0.1);
    let t10 = cos_plate_phi * R::literal(0.1);
    let t11 = sin_plate_phi * R::literal(0.01);
    let t12 = bobbin_x - drum_x;
    let t13 = t12 * t12;
    let t14 = bobbin_y - drum_y;
    let t15 = t14 * t14;
    let t16 = t13 + t15;
    let between = t16.sqrt();
    let t17 = rod_x - cylinder_x;
    let t18 = t17 * cos_cylinder_phi;
    let t19 = rod_y - cylinder_y;
    let t20 = t19 * sin_cylinder_phi;
    let slide = t18 + t20;
    let t21 = t17 * sin_cylinder_phi;
    let t22 = t19 * cos_cylinder_phi;
    let t23 = t22 - t21;
    let t24 = cylinder_omega * t23;
    let t25 = rod_v_x - cylinder_v_x;
    let t26 = t25 * cos_cylinder_phi;
    let t27 = rod_v_y - cylinder_v_y;
    let t28 = t27 * sin_cylinder_phi;
    let t29 = t24 + t26;
    let slide_rate = t29 + t28;
    let t30 = sin_post_phi * R::literal(0.044);
    let t31 = cos_post_phi * R::literal(0.143);
    let t32 = t30 + t31;
    let t33 = t11 + t10;
    let t34 = t8 - t9;
    let t35 = t12 / between;
    let t36 = t14 / between;
    let t37 = t1 * R::literal(370.370_370_370_370_3);
    let t38 = t0 * R::literal(370.370_370_370_370_3);
    let t39 = t32 * R::literal(370.370_370_370_370_3);
    let t40 = t3 * R::literal(400.0);
    let t41 = t2 * R::literal(400.0);
    let t42 = t33 * R::literal(400.0);
    let t43 = t34 * R::literal(400.0);
    let t44 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t45 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t46 = t5 * R::literal(2_777.777_777_777_778);
    let t47 = t4 * R::literal(2_777.777_777_777_778);
    let t48 = slide * R::literal(2_777.777_777_777_778);
    let t49 = sin_cylinder_phi * R::literal(5.0);
    let t50 = cos_cylinder_phi * R::literal(5.0);
    let t51 = t7 * R::literal(4_166.666_666_666_667);
    let t52 = t6 * R::literal(4_166.666_666_666_667);
    let t53 = R::literal(1.0) / p.bobbin_mass;
    let t54 = t35 * t53;
    let t55 = t36 * t53;
    let t56 = t35 * R::literal(0.666_666_666_666_666_6);
    let t57 = t36 * R::literal(0.666_666_666_666_666_6);
    let t58 = t37 * t1;
    let t59 = R::literal(-1.25) - t58;
    let t60 = R::literal(1.0) / t59;
    let t61 = t38 * t1;
    let t62 = t61 * t60;
    let t63 = R::literal(1.25) - t58;
    let t64 = t63 * t60;
    let t65 = t39 * t1;
    let t66 = t65 * t60;
    let t67 = t38 * t0;
    let t68 = R::literal(-1.25) - t67;
    let t69 = t62 * t61;
    let t70 = t68 - t69;
    let t71 = R::literal(1.0) / t70;
    let t72 = t37 * t0;
    let t73 = t64 * t61;
    let t74 = t72 - t73;
    let t75 = t74 * t71;
    let t76 = R::literal(1.25) - t67;
    let t77 = t76 - t69;
    let t78 = t77 * t71;
    let t79 = t39 * t0;
    let t80 = t66 * t61;
    let t81 = t79 + t80;
    let t82 = t81 * t71;
    let t83 = t59 - R::literal(0.833_333_333_333_333_4);
    let t84 = t40 * t3;
    let t85 = t83 - t84;
    let t86 = t64 * t63;
    let t87 = t85 - t86;
    let t88 = t75 * t74;
    let t89 = t87 - t88;
    let t90 = R::literal(1.0) / t89;
    let t91 = t41 * t3;
    let t92 = t61 + t91;
    let t93 = t62 * t63;
    let t94 = t92 - t93;
    let t95 = t78 * t74;
    let t96 = t94 - t95;
    let t97 = t96 * t90;
    let t98 = R::literal(0.833_333_333_333_333_4) - t84;
    let t99 = t98 * t90;
    let t100 = t91 * t90;
    let t101 = t42 * t3;
    let t102 = R::literal(0.833_333_333_333_333_4) + t101;
    let t103 = t102 * t90;
    let t104 = t43 * t3;
    let t105 = t104 * t90;
    let t106 = t66 * t63;
    let t107 = t106 - t65;
    let t108 = t82 * t74;
    let t109 = t107 - t108;
    let t110 = t109 * t90;
    let t111 = t68 - R::literal(0.833_333_333_333_333_4);
    let t112 = t41 * t2;
    let t113 = t111 - t112;
    let t114 = t113 - t69;
    let t115 = t78 * t77;
    let t116 = t114 - t115;
    let t117 = t97 * t96;
    let t118 = t116 - t117;
    let t119 = R::literal(1.0) / t118;
    let t120 = t40 * t2;
    let t121 = t99 * t96;
    let t122 = t120 - t121;
    let t123 = t122 * t119;
    let t124 = R::literal(0.833_333_333_333_333_4) - t112;
    let t125 = t100 * t96;
    let t126 = t124 - t125;
    let t127 = t126 * t119;
    let t128 = t42 * t2;
    let t129 = -t128;
    let t130 = t103 * t96;
    let t131 = t129 - t130;
    let t132 = t131 * t119;
    let t133 = t43 * t2;
    let t134 = R::literal(0.833_333_333_333_333_4) + t133;
    let t135 = t105 * t96;
    let t136 = t134 + t135;
    let t137 = t136 * t119;
    let t138 = t82 * t77;
    let t139 = t81 - t138;
    let t140 = t110 * t96;
    let t141 = t139 - t140;
    let t142 = t141 * t119;
    let t143 = R::literal(-0.833_333_333_333_333_4) - t84;
    let t144 = t143 - R::literal(3.333_333_333_333_333_5);
    let t145 = t46 * t5;
    let t146 = t144 - t145;
    let t147 = t99 * t98;
    let t148 = t146 - t147;
    let t149 = t123 * t122;
    let t150 = t148 - t149;
    let t151 = R::literal(1.0) / t150;
    let t152 = t47 * t5;
    let t153 = t91 + t152;
    let t154 = t100 * t98;
    let t155 = t153 - t154;
    let t156 = t127 * t122;
    let t157 = t155 - t156;
    let t158 = t157 * t151;
    let t159 = t5 * R::literal(-2_777.777_777_777_778);
    let t160 = t159 * t151;
    let t161 = t48 * t5;
    let t162 = t161 - t44;
    let t163 = t162 * t151;
    let t164 = R::literal(-0.833_333_333_333_333_4) + t101;
    let t165 = t103 * t98;
    let t166 = t164 - t165;
    let t167 = t132 * t122;
    let t168 = t166 - t167;
    let t169 = t168 * t151;
    let t170 = t105 * t98;
    let t171 = t170 - t104;
    let t172 = t137 * t122;
    let t173 = t171 - t172;
    let t174 = t173 * t151;
    let t175 = t110 * t98;
    let t176 = -t175;
    let t177 = t142 * t122;
    let t178 = t176 - t177;
    let t179 = t178 * t151;
    let t180 = R::literal(-0.833_333_333_333_333_4) - t112;
    let t181 = t180 - R::literal(3.333_333_333_333_333_5);
    let t182 = t47 * t4;
    let t183 = t181 - t182;
    let t184 = t100 * t91;
    let t185 = t183 - t184;
    let t186 = t127 * t126;
    let t187 = t185 - t186;
    let t188 = t158 * t157;
    let t189 = t187 - t188;
    let t190 = R::literal(1.0) / t189;
    let t191 = t4 * R::literal(-2_777.777_777_777_778);
    let t192 = t160 * t157;
    let t193 = t191 + t192;
    let t194 = t193 * t190;
    let t195 = t48 * t4;
    let t196 = t45 - t195;
    let t197 = t163 * t157;
    let t198 = t196 - t197;
    let t199 = t198 * t190;
    let t200 = t103 * t91;
    let t201 = t129 - t200;
    let t202 = t132 * t126;
    let t203 = t201 - t202;
    let t204 = t169 * t157;
    let t205 = t203 - t204;
    let t206 = t205 * t190;
    let t207 = R::literal(-0.833_333_333_333_333_4) + t133;
    let t208 = t105 * t91;
    let t209 = t207 + t208;
    let t210 = t137 * t126;
    let t211 = t209 - t210;
    let t212 = t174 * t157;
    let t213 = t211 - t212;
    let t214 = t213 * t190;
    let t215 = t110 * t91;
    let t216 = -t215;
    let t217 = t142 * t126;
    let t218 = t216 - t217;
    let t219 = t179 * t157;
    let t220 = t218 - t219;
    let t221 = t220 * t190;
    let t222 = t160 * t159;
    let t223 = R::literal(-6_944.444_444_444_445) - t222;
    let t224 = t194 * t193;
    let t225 = t223 - t224;
    let t226 = R::literal(1.0) / t225;
    let t227 = t163 * t159;
    let t228 = t227 - t48;
    let t229 = t199 * t193;
    let t230 = t228 - t229;
    let t231 = t230 * t226;
    let t232 = t51 * t226;
    let t233 = t52 * t226;
    let t234 = t169 * t159;
    let t235 = t206 * t193;
    let t236 = t234 - t235;
    let t237 = t236 * t226;
    let t238 = t174 * t159;
    let t239 = t214 * t193;
    let t240 = t238 - t239;
    let t241 = t240 * t226;
    let t242 = t179 * t159;
    let t243 = t221 * t193;
    let t244 = t242 - t243;
    let t245 = t244 * t226;
    let t246 = t44 * sin_cylinder_phi;
    let t247 = -t246;
    let t248 = t45 * cos_cylinder_phi;
    let t249 = t247 - t248;
    let t250 = t48 * slide;
    let t251 = t249 - t250;
    let t252 = t49 * sin_cylinder_phi;
    let t253 = t251 - t252;
    let t254 = t50 * cos_cylinder_phi;
    let t255 = t253 - t254;
    let t256 = t163 * t162;
    let t257 = t255 - t256;
    let t258 = t199 * t198;
    let t259 = t257 - t258;
    let t260 = t231 * t230;
    let t261 = t259 - t260;
    let t262 = R::literal(1.0) / t261;
    let t263 = t232 * t230;
    let t264 = t49 - t263;
    let t265 = t264 * t262;
    let t266 = t233 * t230;
    let t267 = t266 - t50;
    let t268 = t267 * t262;
    let t269 = t169 * t162;
    let t270 = -t269;
    let t271 = t206 * t198;
    let t272 = t270 - t271;
    let t273 = t237 * t230;
    let t274 = t272 - t273;
    let t275 = t274 * t262;
    let t276 = t174 * t162;
    let t277 = -t276;
    let t278 = t214 * t198;
    let t279 = t277 - t278;
    let t280 = t241 * t230;
    let t281 = t279 - t280;
    let t282 = t281 * t262;
    let t283 = t179 * t162;
    let t284 = -t283;
    let t285 = t221 * t198;
    let t286 = t284 - t285;
    let t287 = t245 * t230;
    let t288 = t286 - t287;
    let t289 = t288 * t262;
    let t290 = t51 * t7;
    let t291 = R::literal(-5.0) - t290;
    let t292 = t232 * t51;
    let t293 = t291 - t292;
    let t294 = t265 * t264;
    let t295 = t293 - t294;
    let t296 = R::literal(1.0) / t295;
    let t297 = t52 * t7;
    let t298 = t233 * t51;
    let t299 = t297 + t298;
    let t300 = t268 * t264;
    let t301 = t299 - t300;
    let t302 = t301 * t296;
    let t303 = t237 * t51;
    let t304 = -t303;
    let t305 = t275 * t264;
    let t306 = t304 - t305;
    let t307 = t306 * t296;
    let t308 = t241 * t51;
    let t309 = -t308;
    let t310 = t282 * t264;
    let t311 = t309 - t310;
    let t312 = t311 * t296;
    let t313 = t245 * t51;
    let t314 = -t313;
    let t315 = t289 * t264;
    let t316 = t314 - t315;
    let t317 = t316 * t296;
    let t318 = t52 * t6;
    let t319 = R::literal(-5.0) - t318;
    let t320 = t233 * t52;
    let t321 = t319 - t320;
    let t322 = t268 * t267;
    let t323 = t321 - t322;
    let t324 = t302 * t301;
    let t325 = t323 - t324;
    let t326 = R::literal(1.0) / t325;
    let t327 = t237 * t52;
    let t328 = t275 * t267;
    let t329 = t327 - t328;
    let t330 = t307 * t301;
    let t331 = t329 - t330;
    let t332 = t331 * t326;
    let t333 = t241 * t52;
    let t334 = t282 * t267;
    let t335 = t333 - t334;
    let t336 = t312 * t301;
    let t337 = t335 - t336;
    let t338 = t337 * t326;
    let t339 = t245 * t52;
    let t340 = t289 * t267;
    let t341 = t339 - t340;
    let t342 = t317 * t301;
    let t343 = t341 - t342;
    let t344 = t343 * t326;
    let t345 = t42 * t33;
    let t346 = R::literal(-0.833_333_333_333_333_4) - t345;
    let t347 = t346 - t53;
    let t348 = t103 * t102;
    let t349 = t347 - t348;
    let t350 = t132 * t131;
    let t351 = t349 - t350;
    let t352 = t169 * t168;
    let t353 = t351 - t352;
    let t354 = t206 * t205;
    let t355 = t353 - t354;
    let t356 = t237 * t236;
    let t357 = t355 - t356;
    let t358 = t275 * t274;
    let t359 = t357 - t358;
    let t360 = t307 * t306;
    let t361 = t359 - t360;
    let t362 = t332 * t331;
    let t363 = t361 - t362;
    let t364 = R::literal(1.0) / t363;
    let t365 = t43 * t33;
    let t366 = t105 * t102;
    let t367 = t365 + t366;
    let t368 = t137 * t131;
    let t369 = t367 - t368;
    let t370 = t174 * t168;
    let t371 = t369 - t370;
    let t372 = t214 * t205;
    let t373 = t371 - t372;
    let t374 = t241 * t236;
    let t375 = t373 - t374;
    let t376 = t282 * t274;
    let t377 = t375 - t376;
    let t378 = t312 * t306;
    let t379 = t377 - t378;
    let t380 = t338 * t331;
    let t381 = t379 - t380;
    let t382 = t381 * t364;
    let t383 = t54 * t364;
    let t384 = t110 * t102;
    let t385 = -t384;
    let t386 = t142 * t131;
    let t387 = t385 - t386;
    let t388 = t179 * t168;
    let t389 = t387 - t388;
    let t390 = t221 * t205;
    let t391 = t389 - t390;
    let t392 = t245 * t236;
    let t393 = t391 - t392;
    let t394 = t289 * t274;
    let t395 = t393 - t394;
    let t396 = t317 * t306;
    let t397 = t395 - t396;
    let t398 = t344 * t331;
    let t399 = t397 - t398;
    let t400 = t399 * t364;
    let t401 = t43 * t34;
    let t402 = R::literal(-0.833_333_333_333_333_4) - t401;
    let t403 = t402 - t53;
    let t404 = t105 * t104;
    let t405 = t403 - t404;
    let t406 = t137 * t136;
    let t407 = t405 - t406;
    let t408 = t174 * t173;
    let t409 = t407 - t408;
    let t410 = t214 * t213;
    let t411 = t409 - t410;
    let t412 = t241 * t240;
    let t413 = t411 - t412;
    let t414 = t282 * t281;
    let t415 = t413 - t414;
    let t416 = t312 * t311;
    let t417 = t415 - t416;
    let t418 = t338 * t337;
    let t419 = t417 - t418;
    let t420 = t382 * t381;
    let t421 = t419 - t420;
    let t422 = R::literal(1.0) / t421;
    let t423 = t383 * t381;
    let t424 = t423 - t55;
    let t425 = t424 * t422;
    let t426 = t110 * t104;
    let t427 = t142 * t136;
    let t428 = t426 - t427;
    let t429 = t179 * t173;
    let t430 = t428 - t429;
    let t431 = t221 * t213;
    let t432 = t430 - t431;
    let t433 = t245 * t240;
    let t434 = t432 - t433;
    let t435 = t289 * t281;
    let t436 = t434 - t435;
    let t437 = t317 * t311;
    let t438 = t436 - t437;
    let t439 = t344 * t337;
    let t440 = t438 - t439;
    let t441 = t400 * t381;
    let t442 = t440 - t441;
    let t443 = t442 * t422;
    let t444 = t56 * R::literal(-1.5);
    let t445 = t57 * R::literal(-1.5);
    let t446 = t54 * t35;
    let t447 = -t446;
    let t448 = t55 * t36;
    let t449 = t447 - t448;
    let t450 = t56 * t35;
    let t451 = t449 - t450;
    let t452 = t57 * t36;
    let t453 = t451 - t452;
    let t454 = t383 * t54;
    let t455 = t453 - t454;
    let t456 = t425 * t424;
    let t457 = t455 - t456;
    let t458 = t444 * t56;
    let t459 = t457 - t458;
    let t460 = t445 * t57;
    let t461 = t459 - t460;
    let t462 = R::literal(1.0) / t461;
    let t463 = t400 * t54;
    let t464 = t443 * t424;
    let t465 = t463 - t464;
    let t466 = t465 * t462;
    let t467 = t39 * t32;
    let t468 = -t467;
    let t469 = t66 * t65;
    let t470 = t468 - t469;
    let t471 = t82 * t81;
    let t472 = t470 - t471;
    let t473 = t110 * t109;
    let t474 = t472 - t473;
    let t475 = t142 * t141;
    let t476 = t474 - t475;
    let t477 = t179 * t178;
    let t478 = t476 - t477;
    let t479 = t221 * t220;
    let t480 = t478 - t479;
    let t481 = t245 * t244;
    let t482 = t480 - t481;
    let t483 = t289 * t288;
    let t484 = t482 - t483;
    let t485 = t317 * t316;
    let t486 = t484 - t485;
    let t487 = t344 * t343;
    let t488 = t486 - t487;
    let t489 = t400 * t399;
    let t490 = t488 - t489;
    let t491 = t443 * t442;
    let t492 = t490 - t491;
    let t493 = t466 * t465;
    let t494 = t492 - t493;
    let t495 = R::literal(1.0) / t494;
    let t496 = p.bobbin_radius * p.winding_force;
    let t497 = slide_rate * R::literal(50.0);
    let t498 = t497 * cos_cylinder_phi;
    let t499 = slide - p.spring_free_length;
    let t500 = t499 * p.spring_stiffness;
    let t501 = t500 * cos_cylinder_phi;
    let t502 = t498 + t501;
    let t503 = t500 * sin_cylinder_phi;
    let t504 = R::literal(2.943) - t503;
    let t505 = t497 * sin_cylinder_phi;
    let t506 = t505 - t504;
    let t507 = t497 * t23;
    let t508 = t500 * t23;
    let t509 = -t507;
    let t510 = t509 - t508;
    let t511 = -t498;
    let t512 = t511 - t501;
    let t513 = R::literal(1.962) + t503;
    let t514 = -t505;
    let t515 = t514 - t513;
    let t516 = t14 * p.winding_force;
    let t517 = t516 / between;
    let t518 = R::literal(9.81) * p.bobbin_mass;
    let t519 = t12 * p.winding_force;
    let t520 = t519 / between;
    let t521 = t520 - t518;
    let t522 = post_omega * post_omega;
    let t523 = t522 * R::literal(0.1);
    let t524 = t523 * cos_post_phi;
    let t525 = t523 * sin_post_phi;
    let t526 = -t525;
    let t527 = plate_omega * plate_omega;
    let t528 = t527 * R::literal(0.06);
    let t529 = t528 * cos_plate_phi;
    let t530 = t529 + t524;
    let t531 = t528 * sin_plate_phi;
    let t532 = t531 + t525;
    let t533 = -t532;
    let t534 = t527 * cos_plate_phi;
    let t535 = cylinder_omega * cylinder_omega;
    let t536 = t535 * cos_cylinder_phi;
    let t537 = t534 + t536;
    let t538 = t537 * R::literal(0.06);
    let t539 = t527 * sin_plate_phi;
    let t540 = t535 * sin_cylinder_phi;
    let t541 = t539 + t540;
    let t542 = t541 * R::literal(0.06);
    let t543 = -t542;
    let t544 = cylinder_v_x * R::literal(2.0);
    let t545 = t544 * cos_cylinder_phi;
    let t546 = cylinder_v_y * R::literal(2.0);
    let t547 = t546 * sin_cylinder_phi;
    let t548 = cylinder_y * cylinder_omega;
    let t549 = t548 * cos_cylinder_phi;
    let t550 = rod_x * cylinder_omega;
    let t551 = t550 * sin_cylinder_phi;
    let t552 = rod_v_x * R::literal(2.0);
    let t553 = t552 * cos_cylinder_phi;
    let t554 = rod_v_y * R::literal(2.0);
    let t555 = t554 * sin_cylinder_phi;
    let t556 = cylinder_x * cylinder_omega;
    let t557 = t556 * sin_cylinder_phi;
    let t558 = rod_y * cylinder_omega;
    let t559 = t558 * cos_cylinder_phi;
    let t560 = t553 + t555;
    let t561 = t560 + t557;
    let t562 = t561 + t559;
    let t563 = t562 - t545;
    let t564 = t563 - t547;
    let t565 = t564 - t549;
    let t566 = t565 - t551;
    let t567 = cylinder_omega * t566;
    let t568 = rod_omega * rod_omega;
    let t569 = t568 * R::literal(0.06);
    let t570 = t569 * cos_rod_phi;
    let t571 = t569 * sin_rod_phi;
    let t572 = t34 * t527;
    let t573 = t33 * t527;
    let t574 = between * between;
    let t575 = t574 * between;
    let t576 = bobbin_v_x * t13;
    let t577 = t576 / t575;
    let t578 = bobbin_v_y * t12;
    let t579 = t578 * t14;
    let t580 = t579 / t575;
    let t581 = drum_v_x / between;
    let t582 = bobbin_v_x / between;
    let t583 = drum_v_x * t13;
    let t584 = t583 / t575;
    let t585 = drum_v_y * t12;
    let t586 = t585 * t14;
    let t587 = t586 / t575;
    let t588 = t582 + t584;
    let t589 = t588 + t587;
    let t590 = t589 - t577;
    let t591 = t590 - t580;
    let t592 = t591 - t581;
    let t593 = bobbin_v_x * t592;
    let t594 = bobbin_v_x * t12;
    let t595 = t594 * t14;
    let t596 = t595 / t575;
    let t597 = bobbin_v_y * t15;
    let t598 = t597 / t575;
    let t599 = drum_v_y / between;
    let t600 = bobbin_v_y / between;
    let t601 = drum_v_x * t12;
    let t602 = t601 * t14;
    let t603 = t602 / t575;
    let t604 = drum_v_y * t15;
    let t605 = t604 / t575;
    let t606 = t600 + t603;
    let t607 = t606 + t605;
    let t608 = t607 - t596;
    let t609 = t608 - t598;
    let t610 = t609 - t599;
    let t611 = bobbin_v_y * t610;
    let t612 = t577 + t580;
    let t613 = t612 + t581;
    let t614 = t613 - t582;
    let t615 = t614 - t584;
    let t616 = t615 - t587;
    let t617 = drum_v_x * t616;
    let t618 = t596 + t598;
    let t619 = t618 + t599;
    let t620 = t619 - t600;
    let t621 = t620 - t603;
    let t622 = t621 - t605;
    let t623 = drum_v_y * t622;
    let t624 = t593 + t611;
    let t625 = t624 + t617;
    let t626 = t625 + t623;
    let t627 = cos_post_phi * R::literal(0.044);
    let t628 = sin_post_phi * R::literal(0.143);
    let t629 = t628 - t627;
    let t630 = t629 * t522;
    let t631 = t526 - R::literal(-9.81);
    let t632 = t62 * t524;
    let t633 = t631 + t632;
    let t634 = t40 * t496;
    let t635 = t634 - t530;
    let t636 = t64 * t524;
    let t637 = t635 + t636;
    let t638 = t75 * t633;
    let t639 = t637 - t638;
    let t640 = t533 - R::literal(9.81);
    let t641 = t640 - R::literal(-9.81);
    let t642 = t41 * t496;
    let t643 = t641 - t642;
    let t644 = t643 + t632;
    let t645 = t78 * t633;
    let t646 = t644 - t645;
    let t647 = t97 * t639;
    let t648 = t646 - t647;
    let t649 = t634 - t538;
    let t650 = t502 * R::literal(3.333_333_333_333_333_5);
    let t651 = t649 - t650;
    let t652 = t46 * t510;
    let t653 = t651 - t652;
    let t654 = t99 * t639;
    let t655 = t653 - t654;
    let t656 = t123 * t648;
    let t657 = t655 - t656;
    let t658 = t543 - R::literal(9.81);
    let t659 = t658 - t642;
    let t660 = t506 * R::literal(3.333_333_333_333_333_5);
    let t661 = t659 - t660;
    let t662 = t47 * t510;
    let t663 = t661 + t662;
    let t664 = t100 * t639;
    let t665 = t663 - t664;
    let t666 = t127 * t648;
    let t667 = t665 - t666;
    let t668 = t158 * t657;
    let t669 = t667 - t668;
    let t670 = t510 * R::literal(-2_777.777_777_777_778);
    let t671 = t160 * t657;
    let t672 = t671 - t670;
    let t673 = t194 * t669;
    let t674 = t672 - t673;
    let t675 = t44 * t502;
    let t676 = t567 - t675;
    let t677 = t45 * t506;
    let t678 = t676 + t677;
    let t679 = t48 * t510;
    let t680 = t678 + t679;
    let t681 = t49 * t512;
    let t682 = t680 + t681;
    let t683 = t50 * t515;
    let t684 = t682 - t683;
    let t685 = t163 * t657;
    let t686 = t684 - t685;
    let t687 = t199 * t669;
    let t688 = t686 - t687;
    let t689 = t231 * t674;
    let t690 = t688 - t689;
    let t691 = t512 * R::literal(5.0);
    let t692 = t570 - t691;
    let t693 = t232 * t674;
    let t694 = t692 - t693;
    let t695 = t265 * t690;
    let t696 = t694 - t695;
    let t697 = t515 * R::literal(5.0);
    let t698 = t571 - t697;
    let t699 = t233 * t674;
    let t700 = t698 + t699;
    let t701 = t268 * t690;
    let t702 = t700 - t701;
    let t703 = t302 * t696;
    let t704 = t702 - t703;
    let t705 = t42 * t496;
    let t706 = t572 - t705;
    let t707 = t517 * t53;
    let t708 = -t707;
    let t709 = t706 + t707;
    let t710 = t103 * t639;
    let t711 = t709 - t710;
    let t712 = t132 * t648;
    let t713 = t711 - t712;
    let t714 = t169 * t657;
    let t715 = t713 - t714;
    let t716 = t206 * t669;
    let t717 = t715 - t716;
    let t718 = t237 * t674;
    let t719 = t717 - t718;
    let t720 = t275 * t690;
    let t721 = t719 - t720;
    let t722 = t307 * t696;
    let t723 = t721 - t722;
    let t724 = t332 * t704;
    let t725 = t723 - t724;
    let t726 = t573 - R::literal(9.81);
    let t727 = t43 * t496;
    let t728 = t726 + t727;
    let t729 = t521 * t53;
    let t730 = t728 - t729;
    let t731 = t105 * t639;
    let t732 = t730 + t731;
    let t733 = t137 * t648;
    let t734 = t732 - t733;
    let t735 = t174 * t657;
    let t736 = t734 - t735;
    let t737 = t214 * t669;
    let t738 = t736 - t737;
    let t739 = t241 * t674;
    let t740 = t738 - t739;
    let t741 = t282 * t690;
    let t742 = t740 - t741;
    let t743 = t312 * t696;
    let t744 = t742 - t743;
    let t745 = t338 * t704;
    let t746 = t744 - t745;
    let t747 = t382 * t725;
    let t748 = t746 - t747;
    let t749 = t54 * t517;
    let t750 = t749 - t626;
    let t751 = t55 * t521;
    let t752 = t750 - t751;
    let t753 = t57 * R::literal(-14.715);
    let t754 = t752 + t753;
    let t755 = t383 * t725;
    let t756 = t754 + t755;
    let t757 = t425 * t748;
    let t758 = t756 - t757;
    let t759 = t445 * R::literal(9.809_999_999_999_999);
    let t760 = t758 - t759;
    let t761 = t66 * t524;
    let t762 = t630 - t761;
    let t763 = t82 * t633;
    let t764 = t762 - t763;
    let t765 = t110 * t639;
    let t766 = t764 - t765;
    let t767 = t142 * t648;
    let t768 = t766 - t767;
    let t769 = t179 * t657;
    let t770 = t768 - t769;
    let t771 = t221 * t669;
    let t772 = t770 - t771;
    let t773 = t245 * t674;
    let t774 = t772 - t773;
    let t775 = t289 * t690;
    let t776 = t774 - t775;
    let t777 = t317 * t696;
    let t778 = t776 - t777;
    let t779 = t344 * t704;
    let t780 = t778 - t779;
    let t781 = t400 * t725;
    let t782 = t780 - t781;
    let t783 = t443 * t748;
    let t784 = t782 - t783;
    let t785 = t466 * t760;
    let t786 = t784 - t785;
    let t787 = t496 * R::literal(400.0);
    let t788 = -t787;
    let t789 = t510 * R::literal(2_777.777_777_777_778);
    let t790 = t524 * t60;
    let t791 = -t790;
    let t792 = t633 * t71;
    let t793 = t639 * t90;
    let t794 = t648 * t119;
    let t795 = t657 * t151;
    let t796 = t669 * t190;
    let t797 = t674 * t226;
    let t798 = t690 * t262;
    let t799 = t696 * t296;
    let t800 = t704 * t326;
    let t801 = t725 * t364;
    let t802 = t748 * t422;
    let t803 = t760 * t462;
    let t804 = t786 * t495;
    let t805 = t466 * t804;
    let t806 = t803 - t805;
    let t807 = t445 * t806;
    let t808 = R::literal(-14.714_999_999_999_998) - t807;
    let axle_b_x = t444 * t806;
    let t809 = t425 * t806;
    let t810 = t802 - t809;
    let t811 = t443 * t804;
    let t812 = t810 - t811;
    let t813 = t382 * t812;
    let t814 = t801 - t813;
    let t815 = t383 * t806;
    let t816 = t814 + t815;
    let t817 = t400 * t804;
    let t818 = t816 - t817;
    let t819 = t332 * t818;
    let t820 = t800 - t819;
    let t821 = t338 * t812;
    let t822 = t820 - t821;
    let t823 = t344 * t804;
    let t824 = t822 - t823;
    let t825 = t302 * t824;
    let t826 = t799 - t825;
    let t827 = t307 * t818;
    let t828 = t826 - t827;
    let t829 = t312 * t812;
    let t830 = t828 - t829;
    let t831 = t317 * t804;
    let t832 = t830 - t831;
    let t833 = t265 * t832;
    let t834 = t798 - t833;
    let t835 = t268 * t824;
    let t836 = t834 - t835;
    let t837 = t275 * t818;
    let t838 = t836 - t837;
    let t839 = t282 * t812;
    let t840 = t838 - t839;
    let t841 = t289 * t804;
    let t842 = t840 - t841;
    let t843 = t231 * t842;
    let t844 = t797 - t843;
    let t845 = t232 * t832;
    let t846 = t844 - t845;
    let t847 = t233 * t824;
    let t848 = t846 + t847;
    let t849 = t237 * t818;
    let t850 = t848 - t849;
    let t851 = t241 * t812;
    let t852 = t850 - t851;
    let t853 = t245 * t804;
    let t854 = t852 - t853;
    let t855 = t194 * t854;
    let t856 = t796 - t855;
    let t857 = t199 * t842;
    let t858 = t856 - t857;
    let t859 = t206 * t818;
    let t860 = t858 - t859;
    let t861 = t214 * t812;
    let t862 = t860 - t861;
    let t863 = t221 * t804;
    let t864 = t862 - t863;
    let t865 = t158 * t864;
    let t866 = t795 - t865;
    let t867 = t160 * t854;
    let t868 = t866 + t867;
    let t869 = t163 * t842;
    let t870 = t868 - t869;
    let t871 = t169 * t818;
    let t872 = t870 - t871;
    let t873 = t174 * t812;
    let t874 = t872 - t873;
    let t875 = t179 * t804;
    let t876 = t874 - t875;
    let t877 = t123 * t876;
    let t878 = t794 - t877;
    let t879 = t127 * t864;
    let t880 = t878 - t879;
    let t881 = t132 * t818;
    let t882 = t880 - t881;
    let t883 = t137 * t812;
    let t884 = t882 - t883;
    let t885 = t142 * t804;
    let t886 = t884 - t885;
    let t887 = t97 * t886;
    let t888 = t793 - t887;
    let t889 = t99 * t876;
    let t890 = t888 - t889;
    let t891 = t100 * t864;
    let t892 = t890 - t891;
    let t893 = t103 * t818;
    let t894 = t892 - t893;
    let t895 = t105 * t812;
    let t896 = t894 + t895;
    let t897 = t110 * t804;
    let t898 = t896 - t897;
    let t899 = t75 * t898;
    let t900 = t792 - t899;
    let t901 = t78 * t886;
    let t902 = t900 - t901;
    let t903 = t82 * t804;
    let t904 = t902 - t903;
    let t905 = t62 * t904;
    let t906 = t791 - t905;
    let t907 = t64 * t898;
    let t908 = t906 - t907;
    let t909 = t62 * t886;
    let t910 = t908 - t909;
    let t911 = t66 * t804;
    let t912 = t910 + t911;
    let t913 = t808 * R::literal(0.666_666_666_666_666_6);
    let t914 = R::literal(-9.809_999_999_999_999) - t913;
    let t915 = t57 * t806;
    let drum_v_y_dot = t914 + t915;
    let t916 = axle_b_x * R::literal(0.666_666_666_666_666_6);
    let t917 = t56 * t806;
    let drum_v_x_dot = t916 + t917;
    let t918 = t812 * t53;
    let t919 = t729 - t918;
    let t920 = t55 * t806;
    let bobbin_v_y_dot = t919 - t920;
    let t921 = t818 * t53;
    let t922 = t708 - t921;
    let t923 = t54 * t806;
    let bobbin_v_x_dot = t922 - t923;
    let t924 = t854 * R::literal(4_166.666_666_666_667);
    let t925 = t51 * t832;
    let t926 = t925 - t924;
    let t927 = t52 * t824;
    let rod_omega_dot = t926 - t927;
    let t928 = t50 * t842;
    let t929 = t697 - t928;
    let t930 = t824 * R::literal(5.0);
    let rod_v_y_dot = t929 - t930;
    let t931 = t49 * t842;
    let t932 = t691 + t931;
    let t933 = t832 * R::literal(5.0);
    let rod_v_x_dot = t932 - t933;
    let t934 = t46 * t876;
    let t935 = t789 - t934;
    let t936 = t47 * t864;
    let t937 = t935 + t936;
    let t938 = t854 * R::literal(-2_777.777_777_777_778);
    let t939 = t937 - t938;
    let t940 = t48 * t842;
    let cylinder_omega_dot = t939 + t940;
    let t941 = t864 * R::literal(3.333_333_333_333_333_5);
    let t942 = t660 - t941;
    let t943 = t45 * t842;
    let cylinder_v_y_dot = t942 + t943;
    let t944 = t876 * R::literal(3.333_333_333_333_333_5);
    let t945 = t650 - t944;
    let t946 = t44 * t842;
    let cylinder_v_x_dot = t945 - t946;
    let t947 = t40 * t898;
    let t948 = t788 - t947;
    let t949 = t41 * t886;
    let t950 = t948 + t949;
    let t951 = t40 * t876;
    let t952 = t950 - t951;
    let t953 = t41 * t864;
    let t954 = t952 + t953;
    let t955 = t42 * t818;
    let t956 = t954 + t955;
    let t957 = t43 * t812;
    let plate_omega_dot = t956 - t957;
    let t958 = t886 * R::literal(0.833_333_333_333_333_4);
    let t959 = R::literal(-9.81) - t958;
    let t960 = t864 * R::literal(-0.833_333_333_333_333_4);
    let t961 = t959 - t960;
    let t962 = t812 * R::literal(-0.833_333_333_333_333_4);
    let plate_v_y_dot = t961 - t962;
    let t963 = t898 * R::literal(0.833_333_333_333_333_4);
    let t964 = -t963;
    let t965 = t876 * R::literal(-0.833_333_333_333_333_4);
    let t966 = t964 - t965;
    let t967 = t818 * R::literal(-0.833_333_333_333_333_4);
    let plate_v_x_dot = t966 - t967;
    let t968 = t37 * t912;
    let t969 = t38 * t904;
    let t970 = t969 - t968;
    let t971 = t37 * t898;
    let t972 = t970 - t971;
    let t973 = t38 * t886;
    let t974 = t972 + t973;
    let t975 = t39 * t804;
    let post_omega_dot = t974 - t975;
    let t976 = t904 * R::literal(1.25);
    let t977 = R::literal(-9.81) - t976;
    let t978 = t886 * R::literal(-1.25);
    let post_v_y_dot = t977 - t978;
    let t979 = t912 * R::literal(1.25);
    let t980 = -t979;
    let t981 = t898 * R::literal(-1.25);
    let post_v_x_dot = t980 - t981;
    let inverse_between = R::literal(1.0) / (between + between);
    let inverse_between_2 = R::literal(1.0) / between;
    let inverse_between_3 = R::literal(1.0) / between;
    let inverse_t59 = R::literal(1.0) / t59;
    let inverse_t70 = R::literal(1.0) / t70;
    let inverse_t89 = R::literal(1.0) / t89;
    let inverse_t118 = R::literal(1.0) / t118;
    let inverse_t150 = R::literal(1.0) / t150;
    let inverse_t189 = R::literal(1.0) / t189;
    let inverse_t225 = R::literal(1.0) / t225;
    let inverse_t261 = R::literal(1.0) / t261;
    let inverse_t295 = R::literal(1.0) / t295;
    let inverse_t325 = R::literal(1.0) / t325;
    let inverse_t363 = R::literal(1.0) / t363;
    let inverse_t421 = R::literal(1.0) / t421;
    let inverse_t461 = R::literal(1.0) / t461;
    let inverse_t494 = R::literal(1.0) / t494;
    let inverse_between_4 = R::literal(1.0) / between;
    let inverse_between_5 = R::literal(1.0) / between;
    let inverse_t575 = R::literal(1.0) / t575;
    let inverse_t575_2 = R::literal(1.0) / t575;
    let inverse_between_6 = R::literal(1.0) / between;
    let inverse_between_7 = R::literal(1.0) / between;
    let inverse_t575_3 = R::literal(1.0) / t575;
    let inverse_t575_4 = R::literal(1.0) / t575;
    let inverse_t575_5 = R::literal(1.0) / t575;
    let inverse_t575_6 = R::literal(1.0) / t575;
    let inverse_between_8 = R::literal(1.0) / between;
    let inverse_between_9 = R::literal(1.0) / between;
    let inverse_t575_7 = R::literal(1.0) / t575;
    let inverse_t575_8 = R::literal(1.0) / t575;
    let mut rates = [
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
        drum_v_x_dot,
        drum_v_y_dot,
        R::literal(0.0),
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [_, _, post_phi_k, _, _, plate_phi_k, cylinder_x_k, cylinder_y_k,
        cylinder_phi_k, rod_x_k, rod_y_k, rod_phi_k, bobbin_x_k, bobbin_y_k, _, drum_x_k,
        drum_y_k, _, post_v_x_k, post_v_y_k, post_omega_k, plate_v_x_k, plate_v_y_k,
        plate_omega_k, cylinder_v_x_k, cylinder_v_y_k, cylinder_omega_k, rod_v_x_k,
        rod_v_y_k, rod_omega_k, bobbin_v_x_k, bobbin_v_y_k, bobbin_omega_k, drum_v_x_k,
        drum_v_y_k, drum_omega_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let sums_7 = lanes_7.sums(order);
        let sums_8 = lanes_8.sums(order);
        let sums_9 = lanes_9.sums(order);
        let sums_10 = lanes_10.sums(order);
        let sums_11 = lanes_11.sums(order);
        let sums_12 = lanes_12.sums(order);
        let sums_13 = lanes_13.sums(order);
        let sums_14 = lanes_14.sums(order);
        let sums_15 = lanes_15.sums(order);
        let sums_16 = lanes_16.sums(order);
        let sums_17 = lanes_17.sums(order);
        let sums_18 = lanes_18.sums(order);
        let sums_19 = lanes_19.sums(order);
        let sums_20 = lanes_20.sums(order);
        let sums_21 = lanes_21.sums(order);
        let sums_22 = lanes_22.sums(order);
        let sums_23 = lanes_23.sums(order);
        let sums_24 = lanes_24.sums(order);
        let sums_25 = lanes_25.sums(order);
        let sums_26 = lanes_26.sums(order);
        let sums_27 = lanes_27.sums(order);
        let sums_28 = lanes_28.sums(order);
        let sums_29 = lanes_29.sums(order);
        let sums_30 = lanes_30.sums(order);
        let sums_31 = lanes_31.sums(order);
        let sums_32 = lanes_32.sums(order);
        let sums_33 = lanes_33.sums(order);
        let sums_34 = lanes_34.sums(order);
        let sums_35 = lanes_35.sums(order);
        let sums_36 = lanes_36.sums(order);
        let sums_37 = lanes_37.sums(order);
        let sums_38 = lanes_38.sums(order);
        let sums_39 = lanes_39.sums(order);
        let sums_40 = lanes_40.sums(order);
        let sums_41 = lanes_41.sums(order);
        let sums_42 = lanes_42.sums(order);
        let sums_43 = lanes_43.sums(order);
        let sums_44 = lanes_44.sums(order);
        let sums_45 = lanes_45.sums(order);
        let sums_46 = lanes_46.sums(order);
        let sums_47 = lanes_47.sums(order);
        let sums_48 = lanes_48.sums(order);
        let sums_49 = lanes_49.sums(order);
        let sin_post_phi_k = inverse * sums[0] + post_phi_k * cos_post_phi;
        let cos_post_phi_k = -(inverse * sums[1] + post_phi_k * sin_post_phi);
        let t0_k = cos_post_phi_k * R::literal(0.1);
        let t1_k = sin_post_phi_k * R::literal(0.1);
        let sin_plate_phi_k = inverse * sums[2] + plate_phi_k * cos_plate_phi;
        let cos_plate_phi_k = -(inverse * sums[3] + plate_phi_k * sin_plate_phi);
        let t2_k = cos_plate_phi_k * R::literal(0.06);
        let t3_k = sin_plate_phi_k * R::literal(0.06);
        let sin_cylinder_phi_k = inverse * sums[4] + cylinder_phi_k * cos_cylinder_phi;
        let cos_cylinder_phi_k = -(inverse * sums[5]
            + cylinder_phi_k * sin_cylinder_phi);
        let t4_k = cos_cylinder_phi_k * R::literal(0.06);
        let t5_k = sin_cylinder_phi_k * R::literal(0.06);
        let sin_rod_phi_k = inverse * sums[6] + rod_phi_k * cos_rod_phi;
        let cos_rod_phi_k = -(inverse * sums[7] + rod_phi_k * sin_rod_phi);
        let t6_k = cos_rod_phi_k * R::literal(0.06);
        let t7_k = sin_rod_phi_k * R::literal(0.06);
        let t8_k = cos_plate_phi_k * R::literal(0.01);
        let t9_k = sin_plate_phi_k * R::literal(0.1);
        let t10_k = cos_plate_phi_k * R::literal(0.1);
        let t11_k = sin_plate_phi_k * R::literal(0.01);
        let t12_k = bobbin_x_k - drum_x_k;
        let t13_k = sums[8] + t12 * t12_k + t12_k * t12;
        let t14_k = bobbin_y_k - drum_y_k;
        let t15_k = sums[9] + t14 * t14_k + t14_k * t14;
        let t16_k = t13_k + t15_k;
        let between_k = (t16_k - sums_1[0]) * inverse_between;
        let t17_k = rod_x_k - cylinder_x_k;
        let t18_k = sums_1[1] + t17 * cos_cylinder_phi_k + t17_k * cos_cylinder_phi;
        let t19_k = rod_y_k - cylinder_y_k;
        let t20_k = sums_1[2] + t19 * sin_cylinder_phi_k + t19_k * sin_cylinder_phi;
        let slide_k = t18_k + t20_k;
        let t21_k = sums_1[3] + t17 * sin_cylinder_phi_k + t17_k * sin_cylinder_phi;
        let t22_k = sums_1[4] + t19 * cos_cylinder_phi_k + t19_k * cos_cylinder_phi;
        let t23_k = t22_k - t21_k;
        let t24_k = sums_1[5] + cylinder_omega * t23_k + cylinder_omega_k * t23;
        let t25_k = rod_v_x_k - cylinder_v_x_k;
        let t26_k = sums_1[6] + t25 * cos_cylinder_phi_k + t25_k * cos_cylinder_phi;
        let t27_k = rod_v_y_k - cylinder_v_y_k;
        let t28_k = sums_1[7] + t27 * sin_cylinder_phi_k + t27_k * sin_cylinder_phi;
        let t29_k = t24_k + t26_k;
        let slide_rate_k = t29_k + t28_k;
        let t30_k = sin_post_phi_k * R::literal(0.044);
        let t31_k = cos_post_phi_k * R::literal(0.143);
        let t32_k = t30_k + t31_k;
        let t33_k = t11_k + t10_k;
        let t34_k = t8_k - t9_k;
        let t35_k = (t12_k - sums_1[8] - between_k * t35) * inverse_between_2;
        let t36_k = (t14_k - sums_1[9] - between_k * t36) * inverse_between_3;
        let t37_k = t1_k * R::literal(370.370_370_370_370_3);
        let t38_k = t0_k * R::literal(370.370_370_370_370_3);
        let t39_k = t32_k * R::literal(370.370_370_370_370_3);
        let t40_k = t3_k * R::literal(400.0);
        let t41_k = t2_k * R::literal(400.0);
        let t42_k = t33_k * R::literal(400.0);
        let t43_k = t34_k * R::literal(400.0);
        let t44_k = sin_cylinder_phi_k * R::literal(3.333_333_333_333_333_5);
        let t45_k = cos_cylinder_phi_k * R::literal(3.333_333_333_333_333_5);
        let t46_k = t5_k * R::literal(2_777.777_777_777_778);
        let t47_k = t4_k * R::literal(2_777.777_777_777_778);
        let t48_k = slide_k * R::literal(2_777.777_777_777_778);
        let t49_k = sin_cylinder_phi_k * R::literal(5.0);
        let t50_k = cos_cylinder_phi_k * R::literal(5.0);
        let t51_k = t7_k * R::literal(4_166.666_666_666_667);
        let t52_k = t6_k * R::literal(4_166.666_666_666_667);
        let t54_k = t35_k * t53;
        let t55_k = t36_k * t53;
        let t56_k = t35_k * R::literal(0.666_666_666_666_666_6);
        let t57_k = t36_k * R::literal(0.666_666_666_666_666_6);
        let t58_k = sums_2[0] + t37 * t1_k + t37_k * t1;
        let t59_k = -t58_k;
        let t60_k = -(sums_2[1] + t59_k * t60) * inverse_t59;
        let t61_k = sums_2[2] + t38 * t1_k + t38_k * t1;
        let t62_k = sums_2[3] + t61 * t60_k + t61_k * t60;
        let t63_k = -t58_k;
        let t64_k = sums_2[4] + t63 * t60_k + t63_k * t60;
        let t65_k = sums_2[5] + t39 * t1_k + t39_k * t1;
        let t66_k = sums_2[6] + t65 * t60_k + t65_k * t60;
        let t67_k = sums_2[7] + t38 * t0_k + t38_k * t0;
        let t68_k = -t67_k;
        let t69_k = sums_2[8] + t62 * t61_k + t62_k * t61;
        let t70_k = t68_k - t69_k;
        let t71_k = -(sums_2[9] + t70_k * t71) * inverse_t70;
        let t72_k = sums_3[0] + t37 * t0_k + t37_k * t0;
        let t73_k = sums_3[1] + t64 * t61_k + t64_k * t61;
        let t74_k = t72_k - t73_k;
        let t75_k = sums_3[2] + t74 * t71_k + t74_k * t71;
        let t76_k = -t67_k;
        let t77_k = t76_k - t69_k;
        let t78_k = sums_3[3] + t77 * t71_k + t77_k * t71;
        let t79_k = sums_3[4] + t39 * t0_k + t39_k * t0;
        let t80_k = sums_3[5] + t66 * t61_k + t66_k * t61;
        let t81_k = t79_k + t80_k;
        let t82_k = sums_3[6] + t81 * t71_k + t81_k * t71;
        let t84_k = sums_3[7] + t40 * t3_k + t40_k * t3;
        let t85_k = t59_k - t84_k;
        let t86_k = sums_3[8] + t64 * t63_k + t64_k * t63;
        let t87_k = t85_k - t86_k;
        let t88_k = sums_3[9] + t75 * t74_k + t75_k * t74;
        let t89_k = t87_k - t88_k;
        let t90_k = -(sums_4[0] + t89_k * t90) * inverse_t89;
        let t91_k = sums_4[1] + t41 * t3_k + t41_k * t3;
        let t92_k = t61_k + t91_k;
        let t93_k = sums_4[2] + t62 * t63_k + t62_k * t63;
        let t94_k = t92_k - t93_k;
        let t95_k = sums_4[3] + t78 * t74_k + t78_k * t74;
        let t96_k = t94_k - t95_k;
        let t97_k = sums_4[4] + t96 * t90_k + t96_k * t90;
        let t98_k = -t84_k;
        let t99_k = sums_4[5] + t98 * t90_k + t98_k * t90;
        let t100_k = sums_4[6] + t91 * t90_k + t91_k * t90;
        let t101_k = sums_4[7] + t42 * t3_k + t42_k * t3;
        let t103_k = sums_4[8] + t102 * t90_k + t101_k * t90;
        let t104_k = sums_4[9] + t43 * t3_k + t43_k * t3;
        let t105_k = sums_5[0] + t104 * t90_k + t104_k * t90;
        let t106_k = sums_5[1] + t66 * t63_k + t66_k * t63;
        let t107_k = t106_k - t65_k;
        let t108_k = sums_5[2] + t82 * t74_k + t82_k * t74;
        let t109_k = t107_k - t108_k;
        let t110_k = sums_5[3] + t109 * t90_k + t109_k * t90;
        let t112_k = sums_5[4] + t41 * t2_k + t41_k * t2;
        let t113_k = t68_k - t112_k;
        let t114_k = t113_k - t69_k;
        let t115_k = sums_5[5] + t78 * t77_k + t78_k * t77;
        let t116_k = t114_k - t115_k;
        let t117_k = sums_5[6] + t97 * t96_k + t97_k * t96;
        let t118_k = t116_k - t117_k;
        let t119_k = -(sums_5[7] + t118_k * t119) * inverse_t118;
        let t120_k = sums_5[8] + t40 * t2_k + t40_k * t2;
        let t121_k = sums_5[9] + t99 * t96_k + t99_k * t96;
        let t122_k = t120_k - t121_k;
        let t123_k = sums_6[0] + t122 * t119_k + t122_k * t119;
        let t124_k = -t112_k;
        let t125_k = sums_6[1] + t100 * t96_k + t100_k * t96;
        let t126_k = t124_k - t125_k;
        let t127_k = sums_6[2] + t126 * t119_k + t126_k * t119;
        let t128_k = sums_6[3] + t42 * t2_k + t42_k * t2;
        let t129_k = -t128_k;
        let t130_k = sums_6[4] + t103 * t96_k + t103_k * t96;
        let t131_k = t129_k - t130_k;
        let t132_k = sums_6[5] + t131 * t119_k + t131_k * t119;
        let t133_k = sums_6[6] + t43 * t2_k + t43_k * t2;
        let t135_k = sums_6[7] + t105 * t96_k + t105_k * t96;
        let t136_k = t133_k + t135_k;
        let t137_k = sums_6[8] + t136 * t119_k + t136_k * t119;
        let t138_k = sums_6[9] + t82 * t77_k + t82_k * t77;
        let t139_k = t81_k - t138_k;
        let t140_k = sums_7[0] + t110 * t96_k + t110_k * t96;
        let t141_k = t139_k - t140_k;
        let t142_k = sums_7[1] + t141 * t119_k + t141_k * t119;
        let t143_k = -t84_k;
        let t145_k = sums_7[2] + t46 * t5_k + t46_k * t5;
        let t146_k = t143_k - t145_k;
        let t147_k = sums_7[3] + t99 * t98_k + t99_k * t98;
        let t148_k = t146_k - t147_k;
        let t149_k = sums_7[4] + t123 * t122_k + t123_k * t122;
        let t150_k = t148_k - t149_k;
        let t151_k = -(sums_7[5] + t150_k * t151) * inverse_t150;
        let t152_k = sums_7[6] + t47 * t5_k + t47_k * t5;
        let t153_k = t91_k + t152_k;
        let t154_k = sums_7[7] + t100 * t98_k + t100_k * t98;
        let t155_k = t153_k - t154_k;
        let t156_k = sums_7[8] + t127 * t122_k + t127_k * t122;
        let t157_k = t155_k - t156_k;
        let t158_k = sums_7[9] + t157 * t151_k + t157_k * t151;
        let t159_k = t5_k * R::literal(-2_777.777_777_777_778);
        let t160_k = sums_8[0] + t159 * t151_k + t159_k * t151;
        let t161_k = sums_8[1] + t48 * t5_k + t48_k * t5;
        let t162_k = t161_k - t44_k;
        let t163_k = sums_8[2] + t162 * t151_k + t162_k * t151;
        let t165_k = sums_8[3] + t103 * t98_k + t103_k * t98;
        let t166_k = t101_k - t165_k;
        let t167_k = sums_8[4] + t132 * t122_k + t132_k * t122;
        let t168_k = t166_k - t167_k;
        let t169_k = sums_8[5] + t168 * t151_k + t168_k * t151;
        let t170_k = sums_8[6] + t105 * t98_k + t105_k * t98;
        let t171_k = t170_k - t104_k;
        let t172_k = sums_8[7] + t137 * t122_k + t137_k * t122;
        let t173_k = t171_k - t172_k;
        let t174_k = sums_8[8] + t173 * t151_k + t173_k * t151;
        let t175_k = sums_8[9] + t110 * t98_k + t110_k * t98;
        let t176_k = -t175_k;
        let t177_k = sums_9[0] + t142 * t122_k + t142_k * t122;
        let t178_k = t176_k - t177_k;
        let t179_k = sums_9[1] + t178 * t151_k + t178_k * t151;
        let t180_k = -t112_k;
        let t182_k = sums_9[2] + t47 * t4_k + t47_k * t4;
        let t183_k = t180_k - t182_k;
        let t184_k = sums_9[3] + t100 * t91_k + t100_k * t91;
        let t185_k = t183_k - t184_k;
        let t186_k = sums_9[4] + t127 * t126_k + t127_k * t126;
        let t187_k = t185_k - t186_k;
        let t188_k = sums_9[5] + t158 * t157_k + t158_k * t157;
        let t189_k = t187_k - t188_k;
        let t190_k = -(sums_9[6] + t189_k * t190) * inverse_t189;
        let t191_k = t4_k * R::literal(-2_777.777_777_777_778);
        let t192_k = sums_9[7] + t160 * t157_k + t160_k * t157;
        let t193_k = t191_k + t192_k;
        let t194_k = sums_9[8] + t193 * t190_k + t193_k * t190;
        let t195_k = sums_9[9] + t48 * t4_k + t48_k * t4;
        let t196_k = t45_k - t195_k;
        let t197_k = sums_10[0] + t163 * t157_k + t163_k * t157;
        let t198_k = t196_k - t197_k;
        let t199_k = sums_10[1] + t198 * t190_k + t198_k * t190;
        let t200_k = sums_10[2] + t103 * t91_k + t103_k * t91;
        let t201_k = t129_k - t200_k;
        let t202_k = sums_10[3] + t132 * t126_k + t132_k * t126;
        let t203_k = t201_k - t202_k;
        let t204_k = sums_10[4] + t169 * t157_k + t169_k * t157;
        let t205_k = t203_k - t204_k;
        let t206_k = sums_10[5] + t205 * t190_k + t205_k * t190;
        let t208_k = sums_10[6] + t105 * t91_k + t105_k * t91;
        let t209_k = t133_k + t208_k;
        let t210_k = sums_10[7] + t137 * t126_k + t137_k * t126;
        let t211_k = t209_k - t210_k;
        let t212_k = sums_10[8] + t174 * t157_k + t174_k * t157;
        let t213_k = t211_k - t212_k;
        let t214_k = sums_10[9] + t213 * t190_k + t213_k * t190;
        let t215_k = sums_11[0] + t110 * t91_k + t110_k * t91;
        let t216_k = -t215_k;
        let t217_k = sums_11[1] + t142 * t126_k + t142_k * t126;
        let t218_k = t216_k - t217_k;
        let t219_k = sums_11[2] + t179 * t157_k + t179_k * t157;
        let t220_k = t218_k - t219_k;
        let t221_k = sums_11[3] + t220 * t190_k + t220_k * t190;
        let t222_k = sums_11[4] + t160 * t159_k + t160_k * t159;
        let t223_k = -t222_k;
        let t224_k = sums_11[5] + t194 * t193_k + t194_k * t193;
        let t225_k = t223_k - t224_k;
        let t226_k = -(sums_11[6] + t225_k * t226) * inverse_t225;
        let t227_k = sums_11[7] + t163 * t159_k + t163_k * t159;
        let t228_k = t227_k - t48_k;
        let t229_k = sums_11[8] + t199 * t193_k + t199_k * t193;
        let t230_k = t228_k - t229_k;
        let t231_k = sums_11[9] + t230 * t226_k + t230_k * t226;
        let t232_k = sums_12[0] + t51 * t226_k + t51_k * t226;
        let t233_k = sums_12[1] + t52 * t226_k + t52_k * t226;
        let t234_k = sums_12[2] + t169 * t159_k + t169_k * t159;
        let t235_k = sums_12[3] + t206 * t193_k + t206_k * t193;
        let t236_k = t234_k - t235_k;
        let t237_k = sums_12[4] + t236 * t226_k + t236_k * t226;
        let t238_k = sums_12[5] + t174 * t159_k + t174_k * t159;
        let t239_k = sums_12[6] + t214 * t193_k + t214_k * t193;
        let t240_k = t238_k - t239_k;
        let t241_k = sums_12[7] + t240 * t226_k + t240_k * t226;
        let t242_k = sums_12[8] + t179 * t159_k + t179_k * t159;
        let t243_k = sums_12[9] + t221 * t193_k + t221_k * t193;
        let t244_k = t242_k - t243_k;
        let t245_k = sums_13[0] + t244 * t226_k + t244_k * t226;
        let t246_k = sums_13[1] + t44 * sin_cylinder_phi_k + t44_k * sin_cylinder_phi;
        let t247_k = -t246_k;
        let t248_k = sums_13[2] + t45 * cos_cylinder_phi_k + t45_k * cos_cylinder_phi;
        let t249_k = t247_k - t248_k;
        let t250_k = sums_13[3] + t48 * slide_k + t48_k * slide;
        let t251_k = t249_k - t250_k;
        let t252_k = sums_13[4] + t49 * sin_cylinder_phi_k + t49_k * sin_cylinder_phi;
        let t253_k = t251_k - t252_k;
        let t254_k = sums_13[5] + t50 * cos_cylinder_phi_k + t50_k * cos_cylinder_phi;
        let t255_k = t253_k - t254_k;
        let t256_k = sums_13[6] + t163 * t162_k + t163_k * t162;
        let t257_k = t255_k - t256_k;
        let t258_k = sums_13[7] + t199 * t198_k + t199_k * t198;
        let t259_k = t257_k - t258_k;
        let t260_k = sums_13[8] + t231 * t230_k + t231_k * t230;
        let t261_k = t259_k - t260_k;
        let t262_k = -(sums_13[9] + t261_k * t262) * inverse_t261;
        let t263_k = sums_14[0] + t232 * t230_k + t232_k * t230;
        let t264_k = t49_k - t263_k;
        let t265_k = sums_14[1] + t264 * t262_k + t264_k * t262;
        let t266_k = sums_14[2] + t233 * t230_k + t233_k * t230;
        let t267_k = t266_k - t50_k;
        let t268_k = sums_14[3] + t267 * t262_k + t267_k * t262;
        let t269_k = sums_14[4] + t169 * t162_k + t169_k * t162;
        let t270_k = -t269_k;
        let t271_k = sums_14[5] + t206 * t198_k + t206_k * t198;
        let t272_k = t270_k - t271_k;
        let t273_k = sums_14[6] + t237 * t230_k + t237_k * t230;
        let t274_k = t272_k - t273_k;
        let t275_k = sums_14[7] + t274 * t262_k + t274_k * t262;
        let t276_k = sums_14[8] + t174 * t162_k + t174_k * t162;
        let t277_k = -t276_k;
        let t278_k = sums_14[9] + t214 * t198_k + t214_k * t198;
        let t279_k = t277_k - t278_k;
        let t280_k = sums_15[0] + t241 * t230_k + t241_k * t230;
        let t281_k = t279_k - t280_k;
        let t282_k = sums_15[1] + t281 * t262_k + t281_k * t262;
        let t283_k = sums_15[2] + t179 * t162_k + t179_k * t162;
        let t284_k = -t283_k;
        let t285_k = sums_15[3] + t221 * t198_k + t221_k * t198;
        let t286_k = t284_k - t285_k;
        let t287_k = sums_15[4] + t245 * t230_k + t245_k * t230;
        let t288_k = t286_k - t287_k;
        let t289_k = sums_15[5] + t288 * t262_k + t288_k * t262;
        let t290_k = sums_15[6] + t51 * t7_k + t51_k * t7;
        let t291_k = -t290_k;
        let t292_k = sums_15[7] + t232 * t51_k + t232_k * t51;
        let t293_k = t291_k - t292_k;
        let t294_k = sums_15[8] + t265 * t264_k + t265_k * t264;
        let t295_k = t293_k - t294_k;
        let t296_k = -(sums_15[9] + t295_k * t296) * inverse_t295;
        let t297_k = sums_16[0] + t52 * t7_k + t52_k * t7;
        let t298_k = sums_16[1] + t233 * t51_k + t233_k * t51;
        let t299_k = t297_k + t298_k;
        let t300_k = sums_16[2] + t268 * t264_k + t268_k * t264;
        let t301_k = t299_k - t300_k;
        let t302_k = sums_16[3] + t301 * t296_k + t301_k * t296;
        let t303_k = sums_16[4] + t237 * t51_k + t237_k * t51;
        let t304_k = -t303_k;
        let t305_k = sums_16[5] + t275 * t264_k + t275_k * t264;
        let t306_k = t304_k - t305_k;
        let t307_k = sums_16[6] + t306 * t296_k + t306_k * t296;
        let t308_k = sums_16[7] + t241 * t51_k + t241_k * t51;
        let t309_k = -t308_k;
        let t310_k = sums_16[8] + t282 * t264_k + t282_k * t264;
        let t311_k = t309_k - t310_k;
        let t312_k = sums_16[9] + t311 * t296_k + t311_k * t296;
        let t313_k = sums_17[0] + t245 * t51_k + t245_k * t51;
        let t314_k = -t313_k;
        let t315_k = sums_17[1] + t289 * t264_k + t289_k * t264;
        let t316_k = t314_k - t315_k;
        let t317_k = sums_17[2] + t316 * t296_k + t316_k * t296;
        let t318_k = sums_17[3] + t52 * t6_k + t52_k * t6;
        let t319_k = -t318_k;
        let t320_k = sums_17[4] + t233 * t52_k + t233_k * t52;
        let t321_k = t319_k - t320_k;
        let t322_k = sums_17[5] + t268 * t267_k + t268_k * t267;
        let t323_k = t321_k - t322_k;
        let t324_k = sums_17[6] + t302 * t301_k + t302_k * t301;
        let t325_k = t323_k - t324_k;
        let t326_k = -(sums_17[7] + t325_k * t326) * inverse_t325;
        let t327_k = sums_17[8] + t237 * t52_k + t237_k * t52;
        let t328_k = sums_17[9] + t275 * t267_k + t275_k * t267;
        let t329_k = t327_k - t328_k;
        let t330_k = sums_18[0] + t307 * t301_k + t307_k * t301;
        let t331_k = t329_k - t330_k;
        let t332_k = sums_18[1] + t331 * t326_k + t331_k * t326;
        let t333_k = sums_18[2] + t241 * t52_k + t241_k * t52;
        let t334_k = sums_18[3] + t282 * t267_k + t282_k * t267;
        let t335_k = t333_k - t334_k;
        let t336_k = sums_18[4] + t312 * t301_k + t312_k * t301;
        let t337_k = t335_k - t336_k;
        let t338_k = sums_18[5] + t337 * t326_k + t337_k * t326;
        let t339_k = sums_18[6] + t245 * t52_k + t245_k * t52;
        let t340_k = sums_18[7] + t289 * t267_k + t289_k * t267;
        let t341_k = t339_k - t340_k;
        let t342_k = sums_18[8] + t317 * t301_k + t317_k * t301;
        let t343_k = t341_k - t342_k;
        let t344_k = sums_18[9] + t343 * t326_k + t343_k * t326;
        let t345_k = sums_19[0] + t42 * t33_k + t42_k * t33;
        let t346_k = -t345_k;
        let t348_k = sums_19[1] + t103 * t101_k + t103_k * t102;
        let t349_k = t346_k - t348_k;
        let t350_k = sums_19[2] + t132 * t131_k + t132_k * t131;
        let t351_k = t349_k - t350_k;
        let t352_k = sums_19[3] + t169 * t168_k + t169_k * t168;
        let t353_k = t351_k - t352_k;
        let t354_k = sums_19[4] + t206 * t205_k + t206_k * t205;
        let t355_k = t353_k - t354_k;
        let t356_k = sums_19[5] + t237 * t236_k + t237_k * t236;
        let t357_k = t355_k - t356_k;
        let t358_k = sums_19[6] + t275 * t274_k + t275_k * t274;
        let t359_k = t357_k - t358_k;
        let t360_k = sums_19[7] + t307 * t306_k + t307_k * t306;
        let t361_k = t359_k - t360_k;
        let t362_k = sums_19[8] + t332 * t331_k + t332_k * t331;
        let t363_k = t361_k - t362_k;
        let t364_k = -(sums_19[9] + t363_k * t364) * inverse_t363;
        let t365_k = sums_20[0] + t43 * t33_k + t43_k * t33;
        let t366_k = sums_20[1] + t105 * t101_k + t105_k * t102;
        let t367_k = t365_k + t366_k;
        let t368_k = sums_20[2] + t137 * t131_k + t137_k * t131;
        let t369_k = t367_k - t368_k;
        let t370_k = sums_20[3] + t174 * t168_k + t174_k * t168;
        let t371_k = t369_k - t370_k;
        let t372_k = sums_20[4] + t214 * t205_k + t214_k * t205;
        let t373_k = t371_k - t372_k;
        let t374_k = sums_20[5] + t241 * t236_k + t241_k * t236;
        let t375_k = t373_k - t374_k;
        let t376_k = sums_20[6] + t282 * t274_k + t282_k * t274;
        let t377_k = t375_k - t376_k;
        let t378_k = sums_20[7] + t312 * t306_k + t312_k * t306;
        let t379_k = t377_k - t378_k;
        let t380_k = sums_20[8] + t338 * t331_k + t338_k * t331;
        let t381_k = t379_k - t380_k;
        let t382_k = sums_20[9] + t381 * t364_k + t381_k * t364;
        let t383_k = sums_21[0] + t54 * t364_k + t54_k * t364;
        let t384_k = sums_21[1] + t110 * t101_k + t110_k * t102;
        let t385_k = -t384_k;
        let t386_k = sums_21[2] + t142 * t131_k + t142_k * t131;
        let t387_k = t385_k - t386_k;
        let t388_k = sums_21[3] + t179 * t168_k + t179_k * t168;
        let t389_k = t387_k - t388_k;
        let t390_k = sums_21[4] + t221 * t205_k + t221_k * t205;
        let t391_k = t389_k - t390_k;
        let t392_k = sums_21[5] + t245 * t236_k + t245_k * t236;
        let t393_k = t391_k - t392_k;
        let t394_k = sums_21[6] + t289 * t274_k + t289_k * t274;
        let t395_k = t393_k - t394_k;
        let t396_k = sums_21[7] + t317 * t306_k + t317_k * t306;
        let t397_k = t395_k - t396_k;
        let t398_k = sums_21[8] + t344 * t331_k + t344_k * t331;
        let t399_k = t397_k - t398_k;
        let t400_k = sums_21[9] + t399 * t364_k + t399_k * t364;
        let t401_k = sums_22[0] + t43 * t34_k + t43_k * t34;
        let t402_k = -t401_k;
        let t404_k = sums_22[1] + t105 * t104_k + t105_k * t104;
        let t405_k = t402_k - t404_k;
        let t406_k = sums_22[2] + t137 * t136_k + t137_k * t136;
        let t407_k = t405_k - t406_k;
        let t408_k = sums_22[3] + t174 * t173_k + t174_k * t173;
        let t409_k = t407_k - t408_k;
        let t410_k = sums_22[4] + t214 * t213_k + t214_k * t213;
        let t411_k = t409_k - t410_k;
        let t412_k = sums_22[5] + t241 * t240_k + t241_k * t240;
        let t413_k = t411_k - t412_k;
        let t414_k = sums_22[6] + t282 * t281_k + t282_k * t281;
        let t415_k = t413_k - t414_k;
        let t416_k = sums_22[7] + t312 * t311_k + t312_k * t311;
        let t417_k = t415_k - t416_k;
        let t418_k = sums_22[8] + t338 * t337_k + t338_k * t337;
        let t419_k = t417_k - t418_k;
        let t420_k = sums_22[9] + t382 * t381_k + t382_k * t381;
        let t421_k = t419_k - t420_k;
        let t422_k = -(sums_23[0] + t421_k * t422) * inverse_t421;
        let t423_k = sums_23[1] + t383 * t381_k + t383_k * t381;
        let t424_k = t423_k - t55_k;
        let t425_k = sums_23[2] + t424 * t422_k + t424_k * t422;
        let t426_k = sums_23[3] + t110 * t104_k + t110_k * t104;
        let t427_k = sums_23[4] + t142 * t136_k + t142_k * t136;
        let t428_k = t426_k - t427_k;
        let t429_k = sums_23[5] + t179 * t173_k + t179_k * t173;
        let t430_k = t428_k - t429_k;
        let t431_k = sums_23[6] + t221 * t213_k + t221_k * t213;
        let t432_k = t430_k - t431_k;
        let t433_k = sums_23[7] + t245 * t240_k + t245_k * t240;
        let t434_k = t432_k - t433_k;
        let t435_k = sums_23[8] + t289 * t281_k + t289_k * t281;
        let t436_k = t434_k - t435_k;
        let t437_k = sums_23[9] + t317 * t311_k + t317_k * t311;
        let t438_k = t436_k - t437_k;
        let t439_k = sums_24[0] + t344 * t337_k + t344_k * t337;
        let t440_k = t438_k - t439_k;
        let t441_k = sums_24[1] + t400 * t381_k + t400_k * t381;
        let t442_k = t440_k - t441_k;
        let t443_k = sums_24[2] + t442 * t422_k + t442_k * t422;
        let t444_k = t56_k * R::literal(-1.5);
        let t445_k = t57_k * R::literal(-1.5);
        let t446_k = sums_24[3] + t54 * t35_k + t54_k * t35;
        let t447_k = -t446_k;
        let t448_k = sums_24[4] + t55 * t36_k + t55_k * t36;
        let t449_k = t447_k - t448_k;
        let t450_k = sums_24[5] + t56 * t35_k + t56_k * t35;
        let t451_k = t449_k - t450_k;
        let t452_k = sums_24[6] + t57 * t36_k + t57_k * t36;
        let t453_k = t451_k - t452_k;
        let t454_k = sums_24[7] + t383 * t54_k + t383_k * t54;
        let t455_k = t453_k - t454_k;
        let t456_k = sums_24[8] + t425 * t424_k + t425_k * t424;
        let t457_k = t455_k - t456_k;
        let t458_k = sums_24[9] + t444 * t56_k + t444_k * t56;
        let t459_k = t457_k - t458_k;
        let t460_k = sums_25[0] + t445 * t57_k + t445_k * t57;
        let t461_k = t459_k - t460_k;
        let t462_k = -(sums_25[1] + t461_k * t462) * inverse_t461;
        let t463_k = sums_25[2] + t400 * t54_k + t400_k * t54;
        let t464_k = sums_25[3] + t443 * t424_k + t443_k * t424;
        let t465_k = t463_k - t464_k;
        let t466_k = sums_25[4] + t465 * t462_k + t465_k * t462;
        let t467_k = sums_25[5] + t39 * t32_k + t39_k * t32;
        let t468_k = -t467_k;
        let t469_k = sums_25[6] + t66 * t65_k + t66_k * t65;
        let t470_k = t468_k - t469_k;
        let t471_k = sums_25[7] + t82 * t81_k + t82_k * t81;
        let t472_k = t470_k - t471_k;
        let t473_k = sums_25[8] + t110 * t109_k + t110_k * t109;
        let t474_k = t472_k - t473_k;
        let t475_k = sums_25[9] + t142 * t141_k + t142_k * t141;
        let t476_k = t474_k - t475_k;
        let t477_k = sums_26[0] + t179 * t178_k + t179_k * t178;
        let t478_k = t476_k - t477_k;
        let t479_k = sums_26[1] + t221 * t220_k + t221_k * t220;
        let t480_k = t478_k - t479_k;
        let t481_k = sums_26[2] + t245 * t244_k + t245_k * t244;
        let t482_k = t480_k - t481_k;
        let t483_k = sums_26[3] + t289 * t288_k + t289_k * t288;
        let t484_k = t482_k - t483_k;
        let t485_k = sums_26[4] + t317 * t316_k + t317_k * t316;
        let t486_k = t484_k - t485_k;
        let t487_k = sums_26[5] + t344 * t343_k + t344_k * t343;
        let t488_k = t486_k - t487_k;
        let t489_k = sums_26[6] + t400 * t399_k + t400_k * t399;
        let t490_k = t488_k - t489_k;
        let t491_k = sums_26[7] + t443 * t442_k + t443_k * t442;
        let t492_k = t490_k - t491_k;
        let t493_k = sums_26[8] + t466 * t465_k + t466_k * t465;
        let t494_k = t492_k - t493_k;
        let t495_k = -(sums_26[9] + t494_k * t495) * inverse_t494;
        let t497_k = slide_rate_k * R::literal(50.0);
        let t498_k = sums_27[0] + t497 * cos_cylinder_phi_k + t497_k * cos_cylinder_phi;
        let t500_k = slide_k * p.spring_stiffness;
        let t501_k = sums_27[1] + t500 * cos_cylinder_phi_k + t500_k * cos_cylinder_phi;
        let t502_k = t498_k + t501_k;
        let t503_k = sums_27[2] + t500 * sin_cylinder_phi_k + t500_k * sin_cylinder_phi;
        let t504_k = -t503_k;
        let t505_k = sums_27[3] + t497 * sin_cylinder_phi_k + t497_k * sin_cylinder_phi;
        let t506_k = t505_k - t504_k;
        let t507_k = sums_27[4] + t497 * t23_k + t497_k * t23;
        let t508_k = sums_27[5] + t500 * t23_k + t500_k * t23;
        let t509_k = -t507_k;
        let t510_k = t509_k - t508_k;
        let t511_k = -t498_k;
        let t512_k = t511_k - t501_k;
        let t514_k = -t505_k;
        let t515_k = t514_k - t503_k;
        let t516_k = t14_k * p.winding_force;
        let t517_k = (t516_k - sums_27[6] - between_k * t517) * inverse_between_4;
        let t519_k = t12_k * p.winding_force;
        let t520_k = (t519_k - sums_27[7] - between_k * t520) * inverse_between_5;
        let t522_k = sums_27[8] + post_omega * post_omega_k + post_omega_k * post_omega;
        let t523_k = t522_k * R::literal(0.1);
        let t524_k = sums_27[9] + t523 * cos_post_phi_k + t523_k * cos_post_phi;
        let t525_k = sums_28[0] + t523 * sin_post_phi_k + t523_k * sin_post_phi;
        let t526_k = -t525_k;
        let t527_k = sums_28[1] + plate_omega * plate_omega_k
            + plate_omega_k * plate_omega;
        let t528_k = t527_k * R::literal(0.06);
        let t529_k = sums_28[2] + t528 * cos_plate_phi_k + t528_k * cos_plate_phi;
        let t530_k = t529_k + t524_k;
        let t531_k = sums_28[3] + t528 * sin_plate_phi_k + t528_k * sin_plate_phi;
        let t532_k = t531_k + t525_k;
        let t533_k = -t532_k;
        let t534_k = sums_28[4] + t527 * cos_plate_phi_k + t527_k * cos_plate_phi;
        let t535_k = sums_28[5] + cylinder_omega * cylinder_omega_k
            + cylinder_omega_k * cylinder_omega;
        let t536_k = sums_28[6] + t535 * cos_cylinder_phi_k + t535_k * cos_cylinder_phi;
        let t537_k = t534_k + t536_k;
        let t538_k = t537_k * R::literal(0.06);
        let t539_k = sums_28[7] + t527 * sin_plate_phi_k + t527_k * sin_plate_phi;
        let t540_k = sums_28[8] + t535 * sin_cylinder_phi_k + t535_k * sin_cylinder_phi;
        let t541_k = t539_k + t540_k;
        let t542_k = t541_k * R::literal(0.06);
        let t543_k = -t542_k;
        let t544_k = cylinder_v_x_k * R::literal(2.0);
        let t545_k = sums_28[9] + t544 * cos_cylinder_phi_k + t544_k * cos_cylinder_phi;
        let t546_k = cylinder_v_y_k * R::literal(2.0);
        let t547_k = sums_29[0] + t546 * sin_cylinder_phi_k + t546_k * sin_cylinder_phi;
        let t548_k = sums_29[1] + cylinder_y * cylinder_omega_k
            + cylinder_y_k * cylinder_omega;
        let t549_k = sums_29[2] + t548 * cos_cylinder_phi_k + t548_k * cos_cylinder_phi;
        let t550_k = sums_29[3] + rod_x * cylinder_omega_k + rod_x_k * cylinder_omega;
        let t551_k = sums_29[4] + t550 * sin_cylinder_phi_k + t550_k * sin_cylinder_phi;
        let t552_k = rod_v_x_k * R::literal(2.0);
        let t553_k = sums_29[5] + t552 * cos_cylinder_phi_k + t552_k * cos_cylinder_phi;
        let t554_k = rod_v_y_k * R::literal(2.0);
        let t555_k = sums_29[6] + t554 * sin_cylinder_phi_k + t554_k * sin_cylinder_phi;
        let t556_k = sums_29[7] + cylinder_x * cylinder_omega_k
            + cylinder_x_k * cylinder_omega;
        let t557_k = sums_29[8] + t556 * sin_cylinder_phi_k + t556_k * sin_cylinder_phi;
        let t558_k = sums_29[9] + rod_y * cylinder_omega_k + rod_y_k * cylinder_omega;
        let t559_k = sums_30[0] + t558 * cos_cylinder_phi_k + t558_k * cos_cylinder_phi;
        let t560_k = t553_k + t555_k;
        let t561_k = t560_k + t557_k;
        let t562_k = t561_k + t559_k;
        let t563_k = t562_k - t545_k;
        let t564_k = t563_k - t547_k;
        let t565_k = t564_k - t549_k;
        let t566_k = t565_k - t551_k;
        let t567_k = sums_30[1] + cylinder_omega * t566_k + cylinder_omega_k * t566;
        let t568_k = sums_30[2] + rod_omega * rod_omega_k + rod_omega_k * rod_omega;
        let t569_k = t568_k * R::literal(0.06);
        let t570_k = sums_30[3] + t569 * cos_rod_phi_k + t569_k * cos_rod_phi;
        let t571_k = sums_30[4] + t569 * sin_rod_phi_k + t569_k * sin_rod_phi;
        let t572_k = sums_30[5] + t34 * t527_k + t34_k * t527;
        let t573_k = sums_30[6] + t33 * t527_k + t33_k * t527;
        let t574_k = sums_1[0] + between * between_k + between_k * between;
        let t575_k = sums_30[7] + t574 * between_k + t574_k * between;
        let t576_k = sums_30[8] + bobbin_v_x * t13_k + bobbin_v_x_k * t13;
        let t577_k = (t576_k - sums_30[9] - t575_k * t577) * inverse_t575;
        let t578_k = sums_31[0] + bobbin_v_y * t12_k + bobbin_v_y_k * t12;
        let t579_k = sums_31[1] + t578 * t14_k + t578_k * t14;
        let t580_k = (t579_k - sums_31[2] - t575_k * t580) * inverse_t575_2;
        let t581_k = (drum_v_x_k - sums_31[3] - between_k * t581) * inverse_between_6;
        let t582_k = (bobbin_v_x_k - sums_31[4] - between_k * t582) * inverse_between_7;
        let t583_k = sums_31[5] + drum_v_x * t13_k + drum_v_x_k * t13;
        let t584_k = (t583_k - sums_31[6] - t575_k * t584) * inverse_t575_3;
        let t585_k = sums_31[7] + drum_v_y * t12_k + drum_v_y_k * t12;
        let t586_k = sums_31[8] + t585 * t14_k + t585_k * t14;
        let t587_k = (t586_k - sums_31[9] - t575_k * t587) * inverse_t575_4;
        let t588_k = t582_k + t584_k;
        let t589_k = t588_k + t587_k;
        let t590_k = t589_k - t577_k;
        let t591_k = t590_k - t580_k;
        let t592_k = t591_k - t581_k;
        let t593_k = sums_32[0] + bobbin_v_x * t592_k + bobbin_v_x_k * t592;
        let t594_k = sums_32[1] + bobbin_v_x * t12_k + bobbin_v_x_k * t12;
        let t595_k = sums_32[2] + t594 * t14_k + t594_k * t14;
        let t596_k = (t595_k - sums_32[3] - t575_k * t596) * inverse_t575_5;
        let t597_k = sums_32[4] + bobbin_v_y * t15_k + bobbin_v_y_k * t15;
        let t598_k = (t597_k - sums_32[5] - t575_k * t598) * inverse_t575_6;
        let t599_k = (drum_v_y_k - sums_32[6] - between_k * t599) * inverse_between_8;
        let t600_k = (bobbin_v_y_k - sums_32[7] - between_k * t600) * inverse_between_9;
        let t601_k = sums_32[8] + drum_v_x * t12_k + drum_v_x_k * t12;
        let t602_k = sums_32[9] + t601 * t14_k + t601_k * t14;
        let t603_k = (t602_k - sums_33[0] - t575_k * t603) * inverse_t575_7;
        let t604_k = sums_33[1] + drum_v_y * t15_k + drum_v_y_k * t15;
        let t605_k = (t604_k - sums_33[2] - t575_k * t605) * inverse_t575_8;
        let t606_k = t600_k + t603_k;
        let t607_k = t606_k + t605_k;
        let t608_k = t607_k - t596_k;
        let t609_k = t608_k - t598_k;
        let t610_k = t609_k - t599_k;
        let t611_k = sums_33[3] + bobbin_v_y * t610_k + bobbin_v_y_k * t610;
        let t612_k = t577_k + t580_k;
        let t613_k = t612_k + t581_k;
        let t614_k = t613_k - t582_k;
        let t615_k = t614_k - t584_k;
        let t616_k = t615_k - t587_k;
        let t617_k = sums_33[4] + drum_v_x * t616_k + drum_v_x_k * t616;
        let t618_k = t596_k + t598_k;
        let t619_k = t618_k + t599_k;
        let t620_k = t619_k - t600_k;
        let t621_k = t620_k - t603_k;
        let t622_k = t621_k - t605_k;
        let t623_k = sums_33[5] + drum_v_y * t622_k + drum_v_y_k * t622;
        let t624_k = t593_k + t611_k;
        let t625_k = t624_k + t617_k;
        let t626_k = t625_k + t623_k;
        let t627_k = cos_post_phi_k * R::literal(0.044);
        let t628_k = sin_post_phi_k * R::literal(0.143);
        let t629_k = t628_k - t627_k;
        let t630_k = sums_33[6] + t629 * t522_k + t629_k * t522;
        let t632_k = sums_33[7] + t62 * t524_k + t62_k * t524;
        let t633_k = t526_k + t632_k;
        let t634_k = t40_k * t496;
        let t635_k = t634_k - t530_k;
        let t636_k = sums_33[8] + t64 * t524_k + t64_k * t524;
        let t637_k = t635_k + t636_k;
        let t638_k = sums_33[9] + t75 * t633_k + t75_k * t633;
        let t639_k = t637_k - t638_k;
        let t642_k = t41_k * t496;
        let t643_k = t533_k - t642_k;
        let t644_k = t643_k + t632_k;
        let t645_k = sums_34[0] + t78 * t633_k + t78_k * t633;
        let t646_k = t644_k - t645_k;
        let t647_k = sums_34[1] + t97 * t639_k + t97_k * t639;
        let t648_k = t646_k - t647_k;
        let t649_k = t634_k - t538_k;
        let t650_k = t502_k * R::literal(3.333_333_333_333_333_5);
        let t651_k = t649_k - t650_k;
        let t652_k = sums_34[2] + t46 * t510_k + t46_k * t510;
        let t653_k = t651_k - t652_k;
        let t654_k = sums_34[3] + t99 * t639_k + t99_k * t639;
        let t655_k = t653_k - t654_k;
        let t656_k = sums_34[4] + t123 * t648_k + t123_k * t648;
        let t657_k = t655_k - t656_k;
        let t659_k = t543_k - t642_k;
        let t660_k = t506_k * R::literal(3.333_333_333_333_333_5);
        let t661_k = t659_k - t660_k;
        let t662_k = sums_34[5] + t47 * t510_k + t47_k * t510;
        let t663_k = t661_k + t662_k;
        let t664_k = sums_34[6] + t100 * t639_k + t100_k * t639;
        let t665_k = t663_k - t664_k;
        let t666_k = sums_34[7] + t127 * t648_k + t127_k * t648;
        let t667_k = t665_k - t666_k;
        let t668_k = sums_34[8] + t158 * t657_k + t158_k * t657;
        let t669_k = t667_k - t668_k;
        let t670_k = t510_k * R::literal(-2_777.777_777_777_778);
        let t671_k = sums_34[9] + t160 * t657_k + t160_k * t657;
        let t672_k = t671_k - t670_k;
        let t673_k = sums_35[0] + t194 * t669_k + t194_k * t669;
        let t674_k = t672_k - t673_k;
        let t675_k = sums_35[1] + t44 * t502_k + t44_k * t502;
        let t676_k = t567_k - t675_k;
        let t677_k = sums_35[2] + t45 * t506_k + t45_k * t506;
        let t678_k = t676_k + t677_k;
        let t679_k = sums_35[3] + t48 * t510_k + t48_k * t510;
        let t680_k = t678_k + t679_k;
        let t681_k = sums_35[4] + t49 * t512_k + t49_k * t512;
        let t682_k = t680_k + t681_k;
        let t683_k = sums_35[5] + t50 * t515_k + t50_k * t515;
        let t684_k = t682_k - t683_k;
        let t685_k = sums_35[6] + t163 * t657_k + t163_k * t657;
        let t686_k = t684_k - t685_k;
        let t687_k = sums_35[7] + t199 * t669_k + t199_k * t669;
        let t688_k = t686_k - t687_k;
        let t689_k = sums_35[8] + t231 * t674_k + t231_k * t674;
        let t690_k = t688_k - t689_k;
        let t691_k = t512_k * R::literal(5.0);
        let t692_k = t570_k - t691_k;
        let t693_k = sums_35[9] + t232 * t674_k + t232_k * t674;
        let t694_k = t692_k - t693_k;
        let t695_k = sums_36[0] + t265 * t690_k + t265_k * t690;
        let t696_k = t694_k - t695_k;
        let t697_k = t515_k * R::literal(5.0);
        let t698_k = t571_k - t697_k;
        let t699_k = sums_36[1] + t233 * t674_k + t233_k * t674;
        let t700_k = t698_k + t699_k;
        let t701_k = sums_36[2] + t268 * t690_k + t268_k * t690;
        let t702_k = t700_k - t701_k;
        let t703_k = sums_36[3] + t302 * t696_k + t302_k * t696;
        let t704_k = t702_k - t703_k;
        let t705_k = t42_k * t496;
        let t706_k = t572_k - t705_k;
        let t707_k = t517_k * t53;
        let t708_k = -t707_k;
        let t709_k = t706_k + t707_k;
        let t710_k = sums_36[4] + t103 * t639_k + t103_k * t639;
        let t711_k = t709_k - t710_k;
        let t712_k = sums_36[5] + t132 * t648_k + t132_k * t648;
        let t713_k = t711_k - t712_k;
        let t714_k = sums_36[6] + t169 * t657_k + t169_k * t657;
        let t715_k = t713_k - t714_k;
        let t716_k = sums_36[7] + t206 * t669_k + t206_k * t669;
        let t717_k = t715_k - t716_k;
        let t718_k = sums_36[8] + t237 * t674_k + t237_k * t674;
        let t719_k = t717_k - t718_k;
        let t720_k = sums_36[9] + t275 * t690_k + t275_k * t690;
        let t721_k = t719_k - t720_k;
        let t722_k = sums_37[0] + t307 * t696_k + t307_k * t696;
        let t723_k = t721_k - t722_k;
        let t724_k = sums_37[1] + t332 * t704_k + t332_k * t704;
        let t725_k = t723_k - t724_k;
        let t727_k = t43_k * t496;
        let t728_k = t573_k + t727_k;
        let t729_k = t520_k * t53;
        let t730_k = t728_k - t729_k;
        let t731_k = sums_37[2] + t105 * t639_k + t105_k * t639;
        let t732_k = t730_k + t731_k;
        let t733_k = sums_37[3] + t137 * t648_k + t137_k * t648;
        let t734_k = t732_k - t733_k;
        let t735_k = sums_37[4] + t174 * t657_k + t174_k * t657;
        let t736_k = t734_k - t735_k;
        let t737_k = sums_37[5] + t214 * t669_k + t214_k * t669;
        let t738_k = t736_k - t737_k;
        let t739_k = sums_37[6] + t241 * t674_k + t241_k * t674;
        let t740_k = t738_k - t739_k;
        let t741_k = sums_37[7] + t282 * t690_k + t282_k * t690;
        let t742_k = t740_k - t741_k;
        let t743_k = sums_37[8] + t312 * t696_k + t312_k * t696;
        let t744_k = t742_k - t743_k;
        let t745_k = sums_37[9] + t338 * t704_k + t338_k * t704;
        let t746_k = t744_k - t745_k;
        let t747_k = sums_38[0] + t382 * t725_k + t382_k * t725;
        let t748_k = t746_k - t747_k;
        let t749_k = sums_38[1] + t54 * t517_k + t54_k * t517;
        let t750_k = t749_k - t626_k;
        let t751_k = sums_38[2] + t55 * t520_k + t55_k * t521;
        let t752_k = t750_k - t751_k;
        let t753_k = t57_k * R::literal(-14.715);
        let t754_k = t752_k + t753_k;
        let t755_k = sums_38[3] + t383 * t725_k + t383_k * t725;
        let t756_k = t754_k + t755_k;
        let t757_k = sums_38[4] + t425 * t748_k + t425_k * t748;
        let t758_k = t756_k - t757_k;
        let t759_k = t445_k * R::literal(9.809_999_999_999_999);
        let t760_k = t758_k - t759_k;
        let t761_k = sums_38[5] + t66 * t524_k + t66_k * t524;
        let t762_k = t630_k - t761_k;
        let t763_k = sums_38[6] + t82 * t633_k + t82_k * t633;
        let t764_k = t762_k - t763_k;
        let t765_k = sums_38[7] + t110 * t639_k + t110_k * t639;
        let t766_k = t764_k - t765_k;
        let t767_k = sums_38[8] + t142 * t648_k + t142_k * t648;
        let t768_k = t766_k - t767_k;
        let t769_k = sums_38[9] + t179 * t657_k + t179_k * t657;
        let t770_k = t768_k - t769_k;
        let t771_k = sums_39[0] + t221 * t669_k + t221_k * t669;
        let t772_k = t770_k - t771_k;
        let t773_k = sums_39[1] + t245 * t674_k + t245_k * t674;
        let t774_k = t772_k - t773_k;
        let t775_k = sums_39[2] + t289 * t690_k + t289_k * t690;
        let t776_k = t774_k - t775_k;
        let t777_k = sums_39[3] + t317 * t696_k + t317_k * t696;
        let t778_k = t776_k - t777_k;
        let t779_k = sums_39[4] + t344 * t704_k + t344_k * t704;
        let t780_k = t778_k - t779_k;
        let t781_k = sums_39[5] + t400 * t725_k + t400_k * t725;
        let t782_k = t780_k - t781_k;
        let t783_k = sums_39[6] + t443 * t748_k + t443_k * t748;
        let t784_k = t782_k - t783_k;
        let t785_k = sums_39[7] + t466 * t760_k + t466_k * t760;
        let t786_k = t784_k - t785_k;
        let t789_k = t510_k * R::literal(2_777.777_777_777_778);
        let t790_k = sums_39[8] + t524 * t60_k + t524_k * t60;
        let t791_k = -t790_k;
        let t792_k = sums_39[9] + t633 * t71_k + t633_k * t71;
        let t793_k = sums_40[0] + t639 * t90_k + t639_k * t90;
        let t794_k = sums_40[1] + t648 * t119_k + t648_k * t119;
        let t795_k = sums_40[2] + t657 * t151_k + t657_k * t151;
        let t796_k = sums_40[3] + t669 * t190_k + t669_k * t190;
        let t797_k = sums_40[4] + t674 * t226_k + t674_k * t226;
        let t798_k = sums_40[5] + t690 * t262_k + t690_k * t262;
        let t799_k = sums_40[6] + t696 * t296_k + t696_k * t296;
        let t800_k = sums_40[7] + t704 * t326_k + t704_k * t326;
        let t801_k = sums_40[8] + t725 * t364_k + t725_k * t364;
        let t802_k = sums_40[9] + t748 * t422_k + t748_k * t422;
        let t803_k = sums_41[0] + t760 * t462_k + t760_k * t462;
        let t804_k = sums_41[1] + t786 * t495_k + t786_k * t495;
        let t805_k = sums_41[2] + t466 * t804_k + t466_k * t804;
        let t806_k = t803_k - t805_k;
        let t807_k = sums_41[3] + t445 * t806_k + t445_k * t806;
        let t808_k = -t807_k;
        let axle_b_x_k = sums_41[4] + t444 * t806_k + t444_k * t806;
        let t809_k = sums_41[5] + t425 * t806_k + t425_k * t806;
        let t810_k = t802_k - t809_k;
        let t811_k = sums_41[6] + t443 * t804_k + t443_k * t804;
        let t812_k = t810_k - t811_k;
        let t813_k = sums_41[7] + t382 * t812_k + t382_k * t812;
        let t814_k = t801_k - t813_k;
        let t815_k = sums_41[8] + t383 * t806_k + t383_k * t806;
        let t816_k = t814_k + t815_k;
        let t817_k = sums_41[9] + t400 * t804_k + t400_k * t804;
        let t818_k = t816_k - t817_k;
        let t819_k = sums_42[0] + t332 * t818_k + t332_k * t818;
        let t820_k = t800_k - t819_k;
        let t821_k = sums_42[1] + t338 * t812_k + t338_k * t812;
        let t822_k = t820_k - t821_k;
        let t823_k = sums_42[2] + t344 * t804_k + t344_k * t804;
        let t824_k = t822_k - t823_k;
        let t825_k = sums_42[3] + t302 * t824_k + t302_k * t824;
        let t826_k = t799_k - t825_k;
        let t827_k = sums_42[4] + t307 * t818_k + t307_k * t818;
        let t828_k = t826_k - t827_k;
        let t829_k = sums_42[5] + t312 * t812_k + t312_k * t812;
        let t830_k = t828_k - t829_k;
        let t831_k = sums_42[6] + t317 * t804_k + t317_k * t804;
        let t832_k = t830_k - t831_k;
        let t833_k = sums_42[7] + t265 * t832_k + t265_k * t832;
        let t834_k = t798_k - t833_k;
        let t835_k = sums_42[8] + t268 * t824_k + t268_k * t824;
        let t836_k = t834_k - t835_k;
        let t837_k = sums_42[9] + t275 * t818_k + t275_k * t818;
        let t838_k = t836_k - t837_k;
        let t839_k = sums_43[0] + t282 * t812_k + t282_k * t812;
        let t840_k = t838_k - t839_k;
        let t841_k = sums_43[1] + t289 * t804_k + t289_k * t804;
        let t842_k = t840_k - t841_k;
        let t843_k = sums_43[2] + t231 * t842_k + t231_k * t842;
        let t844_k = t797_k - t843_k;
        let t845_k = sums_43[3] + t232 * t832_k + t232_k * t832;
        let t846_k = t844_k - t845_k;
        let t847_k = sums_43[4] + t233 * t824_k + t233_k * t824;
        let t848_k = t846_k + t847_k;
        let t849_k = sums_43[5] + t237 * t818_k + t237_k * t818;
        let t850_k = t848_k - t849_k;
        let t851_k = sums_43[6] + t241 * t812_k + t241_k * t812;
        let t852_k = t850_k - t851_k;
        let t853_k = sums_43[7] + t245 * t804_k + t245_k * t804;
        let t854_k = t852_k - t853_k;
        let t855_k = sums_43[8] + t194 * t854_k + t194_k * t854;
        let t856_k = t796_k - t855_k;
        let t857_k = sums_43[9] + t199 * t842_k + t199_k * t842;
        let t858_k = t856_k - t857_k;
        let t859_k = sums_44[0] + t206 * t818_k + t206_k * t818;
        let t860_k = t858_k - t859_k;
        let t861_k = sums_44[1] + t214 * t812_k + t214_k * t812;
        let t862_k = t860_k - t861_k;
        let t863_k = sums_44[2] + t221 * t804_k + t221_k * t804;
        let t864_k = t862_k - t863_k;
        let t865_k = sums_44[3] + t158 * t864_k + t158_k * t864;
        let t866_k = t795_k - t865_k;
        let t867_k = sums_44[4] + t160 * t854_k + t160_k * t854;
        let t868_k = t866_k + t867_k;
        let t869_k = sums_44[5] + t163 * t842_k + t163_k * t842;
        let t870_k = t868_k - t869_k;
        let t871_k = sums_44[6] + t169 * t818_k + t169_k * t818;
        let t872_k = t870_k - t871_k;
        let t873_k = sums_44[7] + t174 * t812_k + t174_k * t812;
        let t874_k = t872_k - t873_k;
        let t875_k = sums_44[8] + t179 * t804_k + t179_k * t804;
        let t876_k = t874_k - t875_k;
        let t877_k = sums_44[9] + t123 * t876_k + t123_k * t876;
        let t878_k = t794_k - t877_k;
        let t879_k = sums_45[0] + t127 * t864_k + t127_k * t864;
        let t880_k = t878_k - t879_k;
        let t881_k = sums_45[1] + t132 * t818_k + t132_k * t818;
        let t882_k = t880_k - t881_k;
        let t883_k = sums_45[2] + t137 * t812_k + t137_k * t812;
        let t884_k = t882_k - t883_k;
        let t885_k = sums_45[3] + t142 * t804_k + t142_k * t804;
        let t886_k = t884_k - t885_k;
        let t887_k = sums_45[4] + t97 * t886_k + t97_k * t886;
        let t888_k = t793_k - t887_k;
        let t889_k = sums_45[5] + t99 * t876_k + t99_k * t876;
        let t890_k = t888_k - t889_k;
        let t891_k = sums_45[6] + t100 * t864_k + t100_k * t864;
        let t892_k = t890_k - t891_k;
        let t893_k = sums_45[7] + t103 * t818_k + t103_k * t818;
        let t894_k = t892_k - t893_k;
        let t895_k = sums_45[8] + t105 * t812_k + t105_k * t812;
        let t896_k = t894_k + t895_k;
        let t897_k = sums_45[9] + t110 * t804_k + t110_k * t804;
        let t898_k = t896_k - t897_k;
        let t899_k = sums_46[0] + t75 * t898_k + t75_k * t898;
        let t900_k = t792_k - t899_k;
        let t901_k = sums_46[1] + t78 * t886_k + t78_k * t886;
        let t902_k = t900_k - t901_k;
        let t903_k = sums_46[2] + t82 * t804_k + t82_k * t804;
        let t904_k = t902_k - t903_k;
        let t905_k = sums_46[3] + t62 * t904_k + t62_k * t904;
        let t906_k = t791_k - t905_k;
        let t907_k = sums_46[4] + t64 * t898_k + t64_k * t898;
        let t908_k = t906_k - t907_k;
        let t909_k = sums_46[5] + t62 * t886_k + t62_k * t886;
        let t910_k = t908_k - t909_k;
        let t911_k = sums_46[6] + t66 * t804_k + t66_k * t804;
        let t912_k = t910_k + t911_k;
        let t913_k = t808_k * R::literal(0.666_666_666_666_666_6);
        let t914_k = -t913_k;
        let t915_k = sums_46[7] + t57 * t806_k + t57_k * t806;
        let drum_v_y_dot_k = t914_k + t915_k;
        let t916_k = axle_b_x_k * R::literal(0.666_666_666_666_666_6);
        let t917_k = sums_46[8] + t56 * t806_k + t56_k * t806;
        let drum_v_x_dot_k = t916_k + t917_k;
        let t918_k = t812_k * t53;
        let t919_k = t729_k - t918_k;
        let t920_k = sums_46[9] + t55 * t806_k + t55_k * t806;
        let bobbin_v_y_dot_k = t919_k - t920_k;
        let t921_k = t818_k * t53;
        let t922_k = t708_k - t921_k;
        let t923_k = sums_47[0] + t54 * t806_k + t54_k * t806;
        let bobbin_v_x_dot_k = t922_k - t923_k;
        let t924_k = t854_k * R::literal(4_166.666_666_666_667);
        let t925_k = sums_47[1] + t51 * t832_k + t51_k * t832;
        let t926_k = t925_k - t924_k;
        let t927_k = sums_47[2] + t52 * t824_k + t52_k * t824;
        let rod_omega_dot_k = t926_k - t927_k;
        let t928_k = sums_47[3] + t50 * t842_k + t50_k * t842;
        let t929_k = t697_k - t928_k;
        let t930_k = t824_k * R::literal(5.0);
        let rod_v_y_dot_k = t929_k - t930_k;
        let t931_k = sums_47[4] + t49 * t842_k + t49_k * t842;
        let t932_k = t691_k + t931_k;
        let t933_k = t832_k * R::literal(5.0);
        let rod_v_x_dot_k = t932_k - t933_k;
        let t934_k = sums_47[5] + t46 * t876_k + t46_k * t876;
        let t935_k = t789_k - t934_k;
        let t936_k = sums_47[6] + t47 * t864_k + t47_k * t864;
        let t937_k = t935_k + t936_k;
        let t938_k = t854_k * R::literal(-2_777.777_777_777_778);
        let t939_k = t937_k - t938_k;
        let t940_k = sums_47[7] + t48 * t842_k + t48_k * t842;
        let cylinder_omega_dot_k = t939_k + t940_k;
        let t941_k = t864_k * R::literal(3.333_333_333_333_333_5);
        let t942_k = t660_k - t941_k;
        let t943_k = sums_47[8] + t45 * t842_k + t45_k * t842;
        let cylinder_v_y_dot_k = t942_k + t943_k;
        let t944_k = t876_k * R::literal(3.333_333_333_333_333_5);
        let t945_k = t650_k - t944_k;
        let t946_k = sums_47[9] + t44 * t842_k + t44_k * t842;
        let cylinder_v_x_dot_k = t945_k - t946_k;
        let t947_k = sums_48[0] + t40 * t898_k + t40_k * t898;
        let t948_k = -t947_k;
        let t949_k = sums_48[1] + t41 * t886_k + t41_k * t886;
        let t950_k = t948_k + t949_k;
        let t951_k = sums_48[2] + t40 * t876_k + t40_k * t876;
        let t952_k = t950_k - t951_k;
        let t953_k = sums_48[3] + t41 * t864_k + t41_k * t864;
        let t954_k = t952_k + t953_k;
        let t955_k = sums_48[4] + t42 * t818_k + t42_k * t818;
        let t956_k = t954_k + t955_k;
        let t957_k = sums_48[5] + t43 * t812_k + t43_k * t812;
        let plate_omega_dot_k = t956_k - t957_k;
        let t958_k = t886_k * R::literal(0.833_333_333_333_333_4);
        let t959_k = -t958_k;
        let t960_k = t864_k * R::literal(-0.833_333_333_333_333_4);
        let t961_k = t959_k - t960_k;
        let t962_k = t812_k * R::literal(-0.833_333_333_333_333_4);
        let plate_v_y_dot_k = t961_k - t962_k;
        let t963_k = t898_k * R::literal(0.833_333_333_333_333_4);
        let t964_k = -t963_k;
        let t965_k = t876_k * R::literal(-0.833_333_333_333_333_4);
        let t966_k = t964_k - t965_k;
        let t967_k = t818_k * R::literal(-0.833_333_333_333_333_4);
        let plate_v_x_dot_k = t966_k - t967_k;
        let t968_k = sums_48[6] + t37 * t912_k + t37_k * t912;
        let t969_k = sums_48[7] + t38 * t904_k + t38_k * t904;
        let t970_k = t969_k - t968_k;
        let t971_k = sums_48[8] + t37 * t898_k + t37_k * t898;
        let t972_k = t970_k - t971_k;
        let t973_k = sums_48[9] + t38 * t886_k + t38_k * t886;
        let t974_k = t972_k + t973_k;
        let t975_k = sums_49[0] + t39 * t804_k + t39_k * t804;
        let post_omega_dot_k = t974_k - t975_k;
        let t976_k = t904_k * R::literal(1.25);
        let t977_k = -t976_k;
        let t978_k = t886_k * R::literal(-1.25);
        let post_v_y_dot_k = t977_k - t978_k;
        let t979_k = t912_k * R::literal(1.25);
        let t980_k = -t979_k;
        let t981_k = t898_k * R::literal(-1.25);
        let post_v_x_dot_k = t980_k - t981_k;
        lanes
            .set(
                order,
                [
                    k * post_phi_k,
                    k * post_phi_k,
                    k * plate_phi_k,
                    k * plate_phi_k,
                    k * cylinder_phi_k,
                    k * cylinder_phi_k,
                    k * rod_phi_k,
                    k * rod_phi_k,
                    t12_k,
                    t14_k,
                ],
                [
                    cos_post_phi_k,
                    sin_post_phi_k,
                    cos_plate_phi_k,
                    sin_plate_phi_k,
                    cos_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    cos_rod_phi_k,
                    sin_rod_phi_k,
                    t12_k,
                    t14_k,
                ],
            );
        lanes_1
            .set(
                order,
                [
                    between_k,
                    cos_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    cos_cylinder_phi_k,
                    cylinder_omega_k,
                    cos_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    between_k,
                    between_k,
                ],
                [
                    between_k,
                    t17_k,
                    t19_k,
                    t17_k,
                    t19_k,
                    t23_k,
                    t25_k,
                    t27_k,
                    t35_k,
                    t36_k,
                ],
            );
        lanes_2
            .set(
                order,
                [t1_k, t59_k, t1_k, t60_k, t60_k, t1_k, t60_k, t0_k, t61_k, t70_k],
                [t37_k, t60_k, t38_k, t61_k, t63_k, t39_k, t65_k, t38_k, t62_k, t71_k],
            );
        lanes_3
            .set(
                order,
                [t0_k, t61_k, t71_k, t71_k, t0_k, t61_k, t71_k, t3_k, t63_k, t74_k],
                [t37_k, t64_k, t74_k, t77_k, t39_k, t66_k, t81_k, t40_k, t64_k, t75_k],
            );
        lanes_4
            .set(
                order,
                [t89_k, t3_k, t62_k, t74_k, t90_k, t90_k, t90_k, t3_k, t90_k, t3_k],
                [t90_k, t41_k, t63_k, t78_k, t96_k, t98_k, t91_k, t42_k, t101_k, t43_k],
            );
        lanes_5
            .set(
                order,
                [t90_k, t63_k, t74_k, t90_k, t2_k, t77_k, t96_k, t118_k, t2_k, t96_k],
                [t104_k, t66_k, t82_k, t109_k, t41_k, t78_k, t97_k, t119_k, t40_k, t99_k],
            );
        lanes_6
            .set(
                order,
                [t119_k, t96_k, t119_k, t2_k, t96_k, t119_k, t2_k, t96_k, t119_k, t77_k],
                [
                    t122_k,
                    t100_k,
                    t126_k,
                    t42_k,
                    t103_k,
                    t131_k,
                    t43_k,
                    t105_k,
                    t136_k,
                    t82_k,
                ],
            );
        lanes_7
            .set(
                order,
                [
                    t96_k,
                    t119_k,
                    t5_k,
                    t98_k,
                    t122_k,
                    t150_k,
                    t5_k,
                    t98_k,
                    t122_k,
                    t151_k,
                ],
                [
                    t110_k,
                    t141_k,
                    t46_k,
                    t99_k,
                    t123_k,
                    t151_k,
                    t47_k,
                    t100_k,
                    t127_k,
                    t157_k,
                ],
            );
        lanes_8
            .set(
                order,
                [
                    t151_k,
                    t5_k,
                    t151_k,
                    t98_k,
                    t122_k,
                    t151_k,
                    t98_k,
                    t122_k,
                    t151_k,
                    t98_k,
                ],
                [
                    t159_k,
                    t48_k,
                    t162_k,
                    t103_k,
                    t132_k,
                    t168_k,
                    t105_k,
                    t137_k,
                    t173_k,
                    t110_k,
                ],
            );
        lanes_9
            .set(
                order,
                [
                    t122_k,
                    t151_k,
                    t4_k,
                    t91_k,
                    t126_k,
                    t157_k,
                    t189_k,
                    t157_k,
                    t190_k,
                    t4_k,
                ],
                [
                    t142_k,
                    t178_k,
                    t47_k,
                    t100_k,
                    t127_k,
                    t158_k,
                    t190_k,
                    t160_k,
                    t193_k,
                    t48_k,
                ],
            );
        lanes_10
            .set(
                order,
                [
                    t157_k,
                    t190_k,
                    t91_k,
                    t126_k,
                    t157_k,
                    t190_k,
                    t91_k,
                    t126_k,
                    t157_k,
                    t190_k,
                ],
                [
                    t163_k,
                    t198_k,
                    t103_k,
                    t132_k,
                    t169_k,
                    t205_k,
                    t105_k,
                    t137_k,
                    t174_k,
                    t213_k,
                ],
            );
        lanes_11
            .set(
                order,
                [
                    t91_k,
                    t126_k,
                    t157_k,
                    t190_k,
                    t159_k,
                    t193_k,
                    t225_k,
                    t159_k,
                    t193_k,
                    t226_k,
                ],
                [
                    t110_k,
                    t142_k,
                    t179_k,
                    t220_k,
                    t160_k,
                    t194_k,
                    t226_k,
                    t163_k,
                    t199_k,
                    t230_k,
                ],
            );
        lanes_12
            .set(
                order,
                [
                    t51_k,
                    t52_k,
                    t159_k,
                    t193_k,
                    t226_k,
                    t159_k,
                    t193_k,
                    t226_k,
                    t159_k,
                    t193_k,
                ],
                [
                    t226_k,
                    t226_k,
                    t169_k,
                    t206_k,
                    t236_k,
                    t174_k,
                    t214_k,
                    t240_k,
                    t179_k,
                    t221_k,
                ],
            );
        lanes_13
            .set(
                order,
                [
                    t226_k,
                    sin_cylinder_phi_k,
                    cos_cylinder_phi_k,
                    slide_k,
                    sin_cylinder_phi_k,
                    cos_cylinder_phi_k,
                    t162_k,
                    t198_k,
                    t230_k,
                    t261_k,
                ],
                [
                    t244_k,
                    t44_k,
                    t45_k,
                    t48_k,
                    t49_k,
                    t50_k,
                    t163_k,
                    t199_k,
                    t231_k,
                    t262_k,
                ],
            );
        lanes_14
            .set(
                order,
                [
                    t230_k,
                    t262_k,
                    t230_k,
                    t262_k,
                    t162_k,
                    t198_k,
                    t230_k,
                    t262_k,
                    t162_k,
                    t198_k,
                ],
                [
                    t232_k,
                    t264_k,
                    t233_k,
                    t267_k,
                    t169_k,
                    t206_k,
                    t237_k,
                    t274_k,
                    t174_k,
                    t214_k,
                ],
            );
        lanes_15
            .set(
                order,
                [
                    t230_k,
                    t262_k,
                    t162_k,
                    t198_k,
                    t230_k,
                    t262_k,
                    t7_k,
                    t51_k,
                    t264_k,
                    t295_k,
                ],
                [
                    t241_k,
                    t281_k,
                    t179_k,
                    t221_k,
                    t245_k,
                    t288_k,
                    t51_k,
                    t232_k,
                    t265_k,
                    t296_k,
                ],
            );
        lanes_16
            .set(
                order,
                [
                    t7_k,
                    t51_k,
                    t264_k,
                    t296_k,
                    t51_k,
                    t264_k,
                    t296_k,
                    t51_k,
                    t264_k,
                    t296_k,
                ],
                [
                    t52_k,
                    t233_k,
                    t268_k,
                    t301_k,
                    t237_k,
                    t275_k,
                    t306_k,
                    t241_k,
                    t282_k,
                    t311_k,
                ],
            );
        lanes_17
            .set(
                order,
                [
                    t51_k,
                    t264_k,
                    t296_k,
                    t6_k,
                    t52_k,
                    t267_k,
                    t301_k,
                    t325_k,
                    t52_k,
                    t267_k,
                ],
                [
                    t245_k,
                    t289_k,
                    t316_k,
                    t52_k,
                    t233_k,
                    t268_k,
                    t302_k,
                    t326_k,
                    t237_k,
                    t275_k,
                ],
            );
        lanes_18
            .set(
                order,
                [
                    t301_k,
                    t326_k,
                    t52_k,
                    t267_k,
                    t301_k,
                    t326_k,
                    t52_k,
                    t267_k,
                    t301_k,
                    t326_k,
                ],
                [
                    t307_k,
                    t331_k,
                    t241_k,
                    t282_k,
                    t312_k,
                    t337_k,
                    t245_k,
                    t289_k,
                    t317_k,
                    t343_k,
                ],
            );
        lanes_19
            .set(
                order,
                [
                    t33_k,
                    t101_k,
                    t131_k,
                    t168_k,
                    t205_k,
                    t236_k,
                    t274_k,
                    t306_k,
                    t331_k,
                    t363_k,
                ],
                [
                    t42_k,
                    t103_k,
                    t132_k,
                    t169_k,
                    t206_k,
                    t237_k,
                    t275_k,
                    t307_k,
                    t332_k,
                    t364_k,
                ],
            );
        lanes_20
            .set(
                order,
                [
                    t33_k,
                    t101_k,
                    t131_k,
                    t168_k,
                    t205_k,
                    t236_k,
                    t274_k,
                    t306_k,
                    t331_k,
                    t364_k,
                ],
                [
                    t43_k,
                    t105_k,
                    t137_k,
                    t174_k,
                    t214_k,
                    t241_k,
                    t282_k,
                    t312_k,
                    t338_k,
                    t381_k,
                ],
            );
        lanes_21
            .set(
                order,
                [
                    t54_k,
                    t101_k,
                    t131_k,
                    t168_k,
                    t205_k,
                    t236_k,
                    t274_k,
                    t306_k,
                    t331_k,
                    t364_k,
                ],
                [
                    t364_k,
                    t110_k,
                    t142_k,
                    t179_k,
                    t221_k,
                    t245_k,
                    t289_k,
                    t317_k,
                    t344_k,
                    t399_k,
                ],
            );
        lanes_22
            .set(
                order,
                [
                    t34_k,
                    t104_k,
                    t136_k,
                    t173_k,
                    t213_k,
                    t240_k,
                    t281_k,
                    t311_k,
                    t337_k,
                    t381_k,
                ],
                [
                    t43_k,
                    t105_k,
                    t137_k,
                    t174_k,
                    t214_k,
                    t241_k,
                    t282_k,
                    t312_k,
                    t338_k,
                    t382_k,
                ],
            );
        lanes_23
            .set(
                order,
                [
                    t421_k,
                    t381_k,
                    t422_k,
                    t104_k,
                    t136_k,
                    t173_k,
                    t213_k,
                    t240_k,
                    t281_k,
                    t311_k,
                ],
                [
                    t422_k,
                    t383_k,
                    t424_k,
                    t110_k,
                    t142_k,
                    t179_k,
                    t221_k,
                    t245_k,
                    t289_k,
                    t317_k,
                ],
            );
        lanes_24
            .set(
                order,
                [
                    t337_k,
                    t381_k,
                    t422_k,
                    t35_k,
                    t36_k,
                    t35_k,
                    t36_k,
                    t54_k,
                    t424_k,
                    t56_k,
                ],
                [
                    t344_k,
                    t400_k,
                    t442_k,
                    t54_k,
                    t55_k,
                    t56_k,
                    t57_k,
                    t383_k,
                    t425_k,
                    t444_k,
                ],
            );
        lanes_25
            .set(
                order,
                [
                    t57_k,
                    t461_k,
                    t54_k,
                    t424_k,
                    t462_k,
                    t32_k,
                    t65_k,
                    t81_k,
                    t109_k,
                    t141_k,
                ],
                [
                    t445_k,
                    t462_k,
                    t400_k,
                    t443_k,
                    t465_k,
                    t39_k,
                    t66_k,
                    t82_k,
                    t110_k,
                    t142_k,
                ],
            );
        lanes_26
            .set(
                order,
                [
                    t178_k,
                    t220_k,
                    t244_k,
                    t288_k,
                    t316_k,
                    t343_k,
                    t399_k,
                    t442_k,
                    t465_k,
                    t494_k,
                ],
                [
                    t179_k,
                    t221_k,
                    t245_k,
                    t289_k,
                    t317_k,
                    t344_k,
                    t400_k,
                    t443_k,
                    t466_k,
                    t495_k,
                ],
            );
        lanes_27
            .set(
                order,
                [
                    cos_cylinder_phi_k,
                    cos_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    t23_k,
                    t23_k,
                    between_k,
                    between_k,
                    post_omega_k,
                    cos_post_phi_k,
                ],
                [
                    t497_k,
                    t500_k,
                    t500_k,
                    t497_k,
                    t497_k,
                    t500_k,
                    t517_k,
                    t520_k,
                    post_omega_k,
                    t523_k,
                ],
            );
        lanes_28
            .set(
                order,
                [
                    sin_post_phi_k,
                    plate_omega_k,
                    cos_plate_phi_k,
                    sin_plate_phi_k,
                    cos_plate_phi_k,
                    cylinder_omega_k,
                    cos_cylinder_phi_k,
                    sin_plate_phi_k,
                    sin_cylinder_phi_k,
                    cos_cylinder_phi_k,
                ],
                [
                    t523_k,
                    plate_omega_k,
                    t528_k,
                    t528_k,
                    t527_k,
                    cylinder_omega_k,
                    t535_k,
                    t527_k,
                    t535_k,
                    t544_k,
                ],
            );
        lanes_29
            .set(
                order,
                [
                    sin_cylinder_phi_k,
                    cylinder_y_k,
                    cos_cylinder_phi_k,
                    rod_x_k,
                    sin_cylinder_phi_k,
                    cos_cylinder_phi_k,
                    sin_cylinder_phi_k,
                    cylinder_x_k,
                    sin_cylinder_phi_k,
                    rod_y_k,
                ],
                [
                    t546_k,
                    cylinder_omega_k,
                    t548_k,
                    cylinder_omega_k,
                    t550_k,
                    t552_k,
                    t554_k,
                    cylinder_omega_k,
                    t556_k,
                    cylinder_omega_k,
                ],
            );
        lanes_30
            .set(
                order,
                [
                    cos_cylinder_phi_k,
                    cylinder_omega_k,
                    rod_omega_k,
                    cos_rod_phi_k,
                    sin_rod_phi_k,
                    t34_k,
                    t33_k,
                    between_k,
                    t13_k,
                    t575_k,
                ],
                [
                    t558_k,
                    t566_k,
                    rod_omega_k,
                    t569_k,
                    t569_k,
                    t527_k,
                    t527_k,
                    t574_k,
                    bobbin_v_x_k,
                    t577_k,
                ],
            );
        lanes_31
            .set(
                order,
                [
                    t12_k,
                    t14_k,
                    t575_k,
                    between_k,
                    between_k,
                    t13_k,
                    t575_k,
                    t12_k,
                    t14_k,
                    t575_k,
                ],
                [
                    bobbin_v_y_k,
                    t578_k,
                    t580_k,
                    t581_k,
                    t582_k,
                    drum_v_x_k,
                    t584_k,
                    drum_v_y_k,
                    t585_k,
                    t587_k,
                ],
            );
        lanes_32
            .set(
                order,
                [
                    bobbin_v_x_k,
                    t12_k,
                    t14_k,
                    t575_k,
                    t15_k,
                    t575_k,
                    between_k,
                    between_k,
                    t12_k,
                    t14_k,
                ],
                [
                    t592_k,
                    bobbin_v_x_k,
                    t594_k,
                    t596_k,
                    bobbin_v_y_k,
                    t598_k,
                    t599_k,
                    t600_k,
                    drum_v_x_k,
                    t601_k,
                ],
            );
        lanes_33
            .set(
                order,
                [
                    t575_k,
                    t15_k,
                    t575_k,
                    bobbin_v_y_k,
                    drum_v_x_k,
                    drum_v_y_k,
                    t522_k,
                    t62_k,
                    t64_k,
                    t75_k,
                ],
                [
                    t603_k,
                    drum_v_y_k,
                    t605_k,
                    t610_k,
                    t616_k,
                    t622_k,
                    t629_k,
                    t524_k,
                    t524_k,
                    t633_k,
                ],
            );
        lanes_34
            .set(
                order,
                [
                    t78_k,
                    t97_k,
                    t46_k,
                    t99_k,
                    t123_k,
                    t47_k,
                    t100_k,
                    t127_k,
                    t158_k,
                    t160_k,
                ],
                [
                    t633_k,
                    t639_k,
                    t510_k,
                    t639_k,
                    t648_k,
                    t510_k,
                    t639_k,
                    t648_k,
                    t657_k,
                    t657_k,
                ],
            );
        lanes_35
            .set(
                order,
                [
                    t194_k,
                    t44_k,
                    t45_k,
                    t48_k,
                    t49_k,
                    t50_k,
                    t163_k,
                    t199_k,
                    t231_k,
                    t232_k,
                ],
                [
                    t669_k,
                    t502_k,
                    t506_k,
                    t510_k,
                    t512_k,
                    t515_k,
                    t657_k,
                    t669_k,
                    t674_k,
                    t674_k,
                ],
            );
        lanes_36
            .set(
                order,
                [
                    t265_k,
                    t233_k,
                    t268_k,
                    t302_k,
                    t103_k,
                    t132_k,
                    t169_k,
                    t206_k,
                    t237_k,
                    t275_k,
                ],
                [
                    t690_k,
                    t674_k,
                    t690_k,
                    t696_k,
                    t639_k,
                    t648_k,
                    t657_k,
                    t669_k,
                    t674_k,
                    t690_k,
                ],
            );
        lanes_37
            .set(
                order,
                [
                    t307_k,
                    t332_k,
                    t105_k,
                    t137_k,
                    t174_k,
                    t214_k,
                    t241_k,
                    t282_k,
                    t312_k,
                    t338_k,
                ],
                [
                    t696_k,
                    t704_k,
                    t639_k,
                    t648_k,
                    t657_k,
                    t669_k,
                    t674_k,
                    t690_k,
                    t696_k,
                    t704_k,
                ],
            );
        lanes_38
            .set(
                order,
                [
                    t382_k,
                    t54_k,
                    t55_k,
                    t383_k,
                    t425_k,
                    t66_k,
                    t82_k,
                    t110_k,
                    t142_k,
                    t179_k,
                ],
                [
                    t725_k,
                    t517_k,
                    t520_k,
                    t725_k,
                    t748_k,
                    t524_k,
                    t633_k,
                    t639_k,
                    t648_k,
                    t657_k,
                ],
            );
        lanes_39
            .set(
                order,
                [
                    t221_k,
                    t245_k,
                    t289_k,
                    t317_k,
                    t344_k,
                    t400_k,
                    t443_k,
                    t466_k,
                    t60_k,
                    t71_k,
                ],
                [
                    t669_k,
                    t674_k,
                    t690_k,
                    t696_k,
                    t704_k,
                    t725_k,
                    t748_k,
                    t760_k,
                    t524_k,
                    t633_k,
                ],
            );
        lanes_40
            .set(
                order,
                [
                    t90_k,
                    t119_k,
                    t151_k,
                    t190_k,
                    t226_k,
                    t262_k,
                    t296_k,
                    t326_k,
                    t364_k,
                    t422_k,
                ],
                [
                    t639_k,
                    t648_k,
                    t657_k,
                    t669_k,
                    t674_k,
                    t690_k,
                    t696_k,
                    t704_k,
                    t725_k,
                    t748_k,
                ],
            );
        lanes_41
            .set(
                order,
                [
                    t462_k,
                    t495_k,
                    t466_k,
                    t445_k,
                    t444_k,
                    t425_k,
                    t443_k,
                    t382_k,
                    t383_k,
                    t400_k,
                ],
                [
                    t760_k,
                    t786_k,
                    t804_k,
                    t806_k,
                    t806_k,
                    t806_k,
                    t804_k,
                    t812_k,
                    t806_k,
                    t804_k,
                ],
            );
        lanes_42
            .set(
                order,
                [
                    t332_k,
                    t338_k,
                    t344_k,
                    t302_k,
                    t307_k,
                    t312_k,
                    t317_k,
                    t265_k,
                    t268_k,
                    t275_k,
                ],
                [
                    t818_k,
                    t812_k,
                    t804_k,
                    t824_k,
                    t818_k,
                    t812_k,
                    t804_k,
                    t832_k,
                    t824_k,
                    t818_k,
                ],
            );
        lanes_43
            .set(
                order,
                [
                    t282_k,
                    t289_k,
                    t231_k,
                    t232_k,
                    t233_k,
                    t237_k,
                    t241_k,
                    t245_k,
                    t194_k,
                    t199_k,
                ],
                [
                    t812_k,
                    t804_k,
                    t842_k,
                    t832_k,
                    t824_k,
                    t818_k,
                    t812_k,
                    t804_k,
                    t854_k,
                    t842_k,
                ],
            );
        lanes_44
            .set(
                order,
                [
                    t206_k,
                    t214_k,
                    t221_k,
                    t158_k,
                    t160_k,
                    t163_k,
                    t169_k,
                    t174_k,
                    t179_k,
                    t123_k,
                ],
                [
                    t818_k,
                    t812_k,
                    t804_k,
                    t864_k,
                    t854_k,
                    t842_k,
                    t818_k,
                    t812_k,
                    t804_k,
                    t876_k,
                ],
            );
        lanes_45
            .set(
                order,
                [
                    t127_k,
                    t132_k,
                    t137_k,
                    t142_k,
                    t97_k,
                    t99_k,
                    t100_k,
                    t103_k,
                    t105_k,
                    t110_k,
                ],
                [
                    t864_k,
                    t818_k,
                    t812_k,
                    t804_k,
                    t886_k,
                    t876_k,
                    t864_k,
                    t818_k,
                    t812_k,
                    t804_k,
                ],
            );
        lanes_46
            .set(
                order,
                [t75_k, t78_k, t82_k, t62_k, t64_k, t62_k, t66_k, t57_k, t56_k, t55_k],
                [
                    t898_k,
                    t886_k,
                    t804_k,
                    t904_k,
                    t898_k,
                    t886_k,
                    t804_k,
                    t806_k,
                    t806_k,
                    t806_k,
                ],
            );
        lanes_47
            .set(
                order,
                [t54_k, t51_k, t52_k, t50_k, t49_k, t46_k, t47_k, t48_k, t45_k, t44_k],
                [
                    t806_k,
                    t832_k,
                    t824_k,
                    t842_k,
                    t842_k,
                    t876_k,
                    t864_k,
                    t842_k,
                    t842_k,
                    t842_k,
                ],
            );
        lanes_48
            .set(
                order,
                [t40_k, t41_k, t40_k, t41_k, t42_k, t43_k, t37_k, t38_k, t37_k, t38_k],
                [
                    t898_k,
                    t886_k,
                    t876_k,
                    t864_k,
                    t818_k,
                    t812_k,
                    t912_k,
                    t904_k,
                    t898_k,
                    t886_k,
                ],
            );
        lanes_49.set(order, [t39_k], [t804_k]);
        rates = [
            post_v_x_k,
            post_v_y_k,
            post_omega_k,
            plate_v_x_k,
            plate_v_y_k,
            plate_omega_k,
            cylinder_v_x_k,
            cylinder_v_y_k,
            cylinder_omega_k,
            rod_v_x_k,
            rod_v_y_k,
            rod_omega_k,
            bobbin_v_x_k,
            bobbin_v_y_k,
            bobbin_omega_k,
            drum_v_x_k,
            drum_v_y_k,
            drum_omega_k,
            post_v_x_dot_k,
            post_v_y_dot_k,
            post_omega_dot_k,
            plate_v_x_dot_k,
            plate_v_y_dot_k,
            plate_omega_dot_k,
            cylinder_v_x_dot_k,
            cylinder_v_y_dot_k,
            cylinder_omega_dot_k,
            rod_v_x_dot_k,
            rod_v_y_dot_k,
            rod_omega_dot_k,
            bobbin_v_x_dot_k,
            bobbin_v_y_dot_k,
            R::literal(0.0),
            drum_v_x_dot_k,
            drum_v_y_dot_k,
            R::literal(0.0),
        ];
    }
}

impl<R: Real> TaylorSeries<R> for WinderLinkage {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 1>::workspace(order + 1)
    }
    fn series(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        coefficients: &mut [R],
        workspace: &mut [R],
    ) {
        let (coefficients, rest) = coefficients.as_chunks_mut();
        assert!(rest.is_empty(), "every order has STATES coefficients");
        let p = parameters_of(parameters);
        series(time, state_of(state), &p, coefficients, workspace);
    }
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
    fn initial_state(&self, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&initial_state(&parameters_of(parameters)));
    }
    fn discontinuities(&self, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&discontinuities(&parameters_of(parameters)));
    }
    fn rate(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = rate(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn rate_jacobian(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = rate_jacobian(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn parameter_jacobian(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        let result = parameter_jacobian(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
        values.copy_from_slice(&result);
    }
    fn time_derivative(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = time_derivative(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn mass_matrix(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = mass_matrix(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn forcing(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = forcing(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn outputs(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = outputs(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result.to_array());
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
        let result = constraint_values(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
        values.copy_from_slice(&result);
    }
    fn constraint_rates(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        let result = constraint_rates(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn constraint_matrix(
        &self,
        time: R,
        state: &[R],
        parameters: &[R],
        values: &mut [R],
    ) {
        let result = constraint_matrix(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
        values.copy_from_slice(&result);
    }
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
    }
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

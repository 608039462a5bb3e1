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
// With constants of the parameters, prepared once a run:
//   prepare                   5
//   prepared_rate          1005
//   prepared_rate_jacobian 7662

use crate::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern,
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

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 4;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_bobbin_mass: R,
    pub bobbin_radius_times_winding_force: R,
    pub t0: R,
    pub t1: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_bobbin_mass: values[0],
            bobbin_radius_times_winding_force: values[1],
            t0: values[2],
            t1: values[3],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_bobbin_mass,
            self.bobbin_radius_times_winding_force,
            self.t0,
            self.t1,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 5 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_bobbin_mass = R::literal(1.0) / p.bobbin_mass;
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t0 = R::literal(9.81) * p.bobbin_mass;
    let t1 = -(bobbin_radius_times_winding_force * R::literal(400.0));
    Constants {
        inverse_bobbin_mass,
        bobbin_radius_times_winding_force,
        t0,
        t1,
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
/// 1010 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 1005 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
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
    let t28 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t29 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
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
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t10 - c.inverse_bobbin_mass
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
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t11 - c.inverse_bobbin_mass
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
    let t171 = p.winding_force * bobbin_x_minus_drum_x / between - c.t0;
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
    let t189 = t15 * c.bobbin_radius_times_winding_force;
    let t190 = t189 - (t175 * cos_plate_phi + t173) + t38 * t173 - t46 * t188;
    let t191 = t16 * c.bobbin_radius_times_winding_force;
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
    let t203 = c.inverse_bobbin_mass * t170;
    let t204 = t11 * plate_omega_squared - t17 * c.bobbin_radius_times_winding_force
        + t203 - t61 * t190 - t74 * t192 - t88 * t194 - t99 * t196 - t110 * t197
        - t121 * t198 - t130 * t200 - t137 * t202;
    let t205 = c.inverse_bobbin_mass * t171;
    let t206 = t10 * plate_omega_squared - R::literal(9.81)
        + t18 * c.bobbin_radius_times_winding_force - t205 + t63 * t190 - t77 * t192
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
    let bobbin_v_y_dot = t205 - c.inverse_bobbin_mass * t211 - t29 * t210;
    let bobbin_v_x_dot = -t203 - c.inverse_bobbin_mass * t212 - t28 * t210;
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
    let plate_omega_dot = c.t1 - t15 * t220 + t16 * t219 - t15 * t218 + t16 * t217
        + t17 * t212 - t18 * t211;
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
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 402] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 7662 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
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
    let t35 = bobbin_x_minus_drum_x_over_between * c.inverse_bobbin_mass;
    let t36 = bobbin_y_minus_drum_y_over_between * c.inverse_bobbin_mass;
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
        / (R::literal(-0.833_333_333_333_333_4) - t24 * t16 - c.inverse_bobbin_mass
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
        / (R::literal(-0.833_333_333_333_333_4) - t25 * t18 - c.inverse_bobbin_mass
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
    let t181 = t180 / between - c.t0;
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
    let t217 = t22 * c.bobbin_radius_times_winding_force;
    let t218 = t217 - (t186 + t183) + t45 * t183 - t53 * t216;
    let t219 = t23 * c.bobbin_radius_times_winding_force;
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
    let t232 = c.inverse_bobbin_mass * t179;
    let t233 = t201 - t24 * c.bobbin_radius_times_winding_force + t232 - t68 * t218
        - t81 * t220 - t95 * t222 - t106 * t224 - t117 * t225 - t128 * t227 - t137 * t229
        - t144 * t231;
    let t234 = c.inverse_bobbin_mass * t181;
    let t235 = t16 * plate_omega_squared - R::literal(9.81)
        + t25 * c.bobbin_radius_times_winding_force - t234 + t70 * t218 - t84 * t220
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
    let bobbin_v_y_dot = t234 - c.inverse_bobbin_mass * t240 - t36 * t239;
    let bobbin_v_x_dot = -t232 - c.inverse_bobbin_mass * t241 - t35 * t239;
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
    let plate_omega_dot = c.t1 - t22 * t249 + t23 * t248 - t22 * t247 + t23 * t246
        + t24 * t241 - t25 * t240;
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
    let bobbin_v_y_dot_by_post_phi = -(c.inverse_bobbin_mass * t270) - t36 * t269;
    let bobbin_v_x_dot_by_post_phi = -(c.inverse_bobbin_mass * t271) - t35 * t269;
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
    let bobbin_v_y_dot_by_plate_phi = -(c.inverse_bobbin_mass * t297) - t36 * t296;
    let bobbin_v_x_dot_by_plate_phi = -(c.inverse_bobbin_mass * t298) - t35 * t296;
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
    let bobbin_v_y_dot_by_cylinder_x = -(c.inverse_bobbin_mass * t340) - t36 * t339;
    let bobbin_v_x_dot_by_cylinder_x = -(c.inverse_bobbin_mass * t341) - t35 * t339;
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
    let bobbin_v_y_dot_by_cylinder_y = -(c.inverse_bobbin_mass * t380) - t36 * t379;
    let bobbin_v_x_dot_by_cylinder_y = -(c.inverse_bobbin_mass * t381) - t35 * t379;
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
    let bobbin_v_y_dot_by_cylinder_phi = -(c.inverse_bobbin_mass * t419) - t36 * t418;
    let bobbin_v_x_dot_by_cylinder_phi = -(c.inverse_bobbin_mass * t420) - t35 * t418;
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
    let bobbin_v_y_dot_by_rod_x = -(c.inverse_bobbin_mass * t447) - t36 * t446;
    let bobbin_v_x_dot_by_rod_x = -(c.inverse_bobbin_mass * t448) - t35 * t446;
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
    let bobbin_v_y_dot_by_rod_y = -(c.inverse_bobbin_mass * t475) - t36 * t474;
    let bobbin_v_x_dot_by_rod_y = -(c.inverse_bobbin_mass * t476) - t35 * t474;
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
    let bobbin_v_y_dot_by_rod_phi = -(c.inverse_bobbin_mass * t497) - t36 * t496;
    let bobbin_v_x_dot_by_rod_phi = -(c.inverse_bobbin_mass * t498) - t35 * t496;
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
    let t552 = c.inverse_bobbin_mass * t544;
    let t553 = c.inverse_bobbin_mass * t547;
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
    let bobbin_v_y_dot_by_bobbin_x = t553 - c.inverse_bobbin_mass * t565 - t36 * t564;
    let bobbin_v_x_dot_by_bobbin_x = t552 - c.inverse_bobbin_mass * t566 - t35 * t564;
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
    let t599 = c.inverse_bobbin_mass * t590;
    let t600 = c.inverse_bobbin_mass * t595;
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
    let bobbin_v_y_dot_by_bobbin_y = t600 - c.inverse_bobbin_mass * t609 - t36 * t608;
    let bobbin_v_x_dot_by_bobbin_y = t599 - c.inverse_bobbin_mass * t610 - t35 * t608;
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
    let t623 = c.inverse_bobbin_mass * t621;
    let t624 = c.inverse_bobbin_mass * t622;
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
    let bobbin_v_y_dot_by_drum_x = t624 - c.inverse_bobbin_mass * t632 - t36 * t631;
    let bobbin_v_x_dot_by_drum_x = t623 - c.inverse_bobbin_mass * t633 - t35 * t631;
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
    let t646 = c.inverse_bobbin_mass * t644;
    let t647 = c.inverse_bobbin_mass * t645;
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
    let bobbin_v_y_dot_by_drum_y = t647 - c.inverse_bobbin_mass * t654 - t36 * t653;
    let bobbin_v_x_dot_by_drum_y = t646 - c.inverse_bobbin_mass * t655 - t35 * t653;
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
    let bobbin_v_y_dot_by_post_omega = -(c.inverse_bobbin_mass * t683) - t36 * t682;
    let bobbin_v_x_dot_by_post_omega = -(c.inverse_bobbin_mass * t684) - t35 * t682;
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
    let bobbin_v_y_dot_by_plate_omega = -(c.inverse_bobbin_mass * t710) - t36 * t709;
    let bobbin_v_x_dot_by_plate_omega = -(c.inverse_bobbin_mass * t711) - t35 * t709;
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
    let bobbin_v_y_dot_by_cylinder_v_x = -(c.inverse_bobbin_mass * t754) - t36 * t753;
    let bobbin_v_x_dot_by_cylinder_v_x = -(c.inverse_bobbin_mass * t755) - t35 * t753;
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
    let bobbin_v_y_dot_by_cylinder_v_y = -(c.inverse_bobbin_mass * t792) - t36 * t791;
    let bobbin_v_x_dot_by_cylinder_v_y = -(c.inverse_bobbin_mass * t793) - t35 * t791;
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
    let bobbin_v_y_dot_by_cylinder_omega = -(c.inverse_bobbin_mass * t822) - t36 * t821;
    let bobbin_v_x_dot_by_cylinder_omega = -(c.inverse_bobbin_mass * t823) - t35 * t821;
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
    let bobbin_v_y_dot_by_rod_v_x = -(c.inverse_bobbin_mass * t845) - t36 * t844;
    let bobbin_v_x_dot_by_rod_v_x = -(c.inverse_bobbin_mass * t846) - t35 * t844;
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
    let bobbin_v_y_dot_by_rod_v_y = -(c.inverse_bobbin_mass * t868) - t36 * t867;
    let bobbin_v_x_dot_by_rod_v_y = -(c.inverse_bobbin_mass * t869) - t35 * t867;
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
    let bobbin_v_y_dot_by_rod_omega = -(c.inverse_bobbin_mass * t888) - t36 * t887;
    let bobbin_v_x_dot_by_rod_omega = -(c.inverse_bobbin_mass * t889) - t35 * t887;
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
    let bobbin_v_y_dot_by_bobbin_v_x = -(c.inverse_bobbin_mass * t905) - t36 * t904;
    let bobbin_v_x_dot_by_bobbin_v_x = -(c.inverse_bobbin_mass * t906) - t35 * t904;
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
    let bobbin_v_y_dot_by_bobbin_v_y = -(c.inverse_bobbin_mass * t922) - t36 * t921;
    let bobbin_v_x_dot_by_bobbin_v_y = -(c.inverse_bobbin_mass * t923) - t35 * t921;
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
    let bobbin_v_y_dot_by_drum_v_x = -(c.inverse_bobbin_mass * t937) - t36 * t936;
    let bobbin_v_x_dot_by_drum_v_x = -(c.inverse_bobbin_mass * t938) - t35 * t936;
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
    let bobbin_v_y_dot_by_drum_v_y = -(c.inverse_bobbin_mass * t952) - t36 * t951;
    let bobbin_v_x_dot_by_drum_v_y = -(c.inverse_bobbin_mass * t953) - t35 * t951;
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
        constants.copy_from_slice(&prepare(&parameters_of(parameters)).to_array());
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
        values.copy_from_slice(&prepared_rate(time, state_of(state), &p, &c));
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
        values.copy_from_slice(&prepared_rate_jacobian(time, state_of(state), &p, &c));
    }
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
}

#[inline]
fn constants_of<R: Real>(constants: &[R]) -> Constants<R> {
    let values: &[R; CONSTANTS] = constants
        .try_into()
        .expect("there are CONSTANTS constants");
    Constants::from_array(*values)
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

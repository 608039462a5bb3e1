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
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t8 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t8)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t9 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
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
    let t45 = (t12 * t0).sub_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).add_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51)
            .sub_product(t38, t37)
            .sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).sub_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = (-t39).add_product(t40, t37).sub_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43)
            .sub_product(t48, t47)
            .sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72.sub_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).sub_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t57, t56)
            .sub_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = (-t19).add_product(t23, t5);
    let t86 = t85 * t80;
    let t87 = (R::literal(-0.833_333_333_333_333_4) + t59)
        .sub_product(t61, t56)
        .sub_product(t74, t68);
    let t88 = t87 * t80;
    let t89 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t90 = t89 * t80;
    let t91 = (-(t65 * t56)).sub_product(t79, t68);
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t58, t53)
            .sub_product(t71, t70)
            .sub_product(t82, t81);
    let t94 = (R::literal(-2_777.777_777_777_778) * t4).add_product(t84, t81);
    let t95 = t94 * t93;
    let t96 = t20.sub_product(t23, t4).sub_product(t86, t81);
    let t97 = t96 * t93;
    let t98 = t72.sub_product(t61, t53).sub_product(t74, t70).sub_product(t88, t81);
    let t99 = t98 * t93;
    let t100 = (R::literal(-0.833_333_333_333_333_4) + t75)
        .add_product(t63, t53)
        .sub_product(t77, t70)
        .sub_product(t90, t81);
    let t101 = t100 * t93;
    let t102 = (-(t65 * t53)).sub_product(t79, t70).sub_product(t92, t81);
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t84, t83).sub_product(t95, t94);
    let t105 = (-t23).add_product(t86, t83).sub_product(t97, t94);
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = (t88 * t83).sub_product(t99, t94);
    let t110 = t109 * t104;
    let t111 = (t90 * t83).sub_product(t101, t94);
    let t112 = t111 * t104;
    let t113 = (t92 * t83).sub_product(t103, t94);
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi))
            .sub_product(t20, cos_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t86, t85)
            .sub_product(t97, t96)
            .sub_product(t106, t105);
    let t116 = t24.sub_product(t107, t105);
    let t117 = t116 * t115;
    let t118 = (-t25).add_product(t108, t105);
    let t119 = t118 * t115;
    let t120 = (-(t88 * t85)).sub_product(t99, t96).sub_product(t110, t105);
    let t121 = t120 * t115;
    let t122 = (-(t90 * t85)).sub_product(t101, t96).sub_product(t112, t105);
    let t123 = t122 * t115;
    let t124 = (-(t92 * t85)).sub_product(t103, t96).sub_product(t114, t105);
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t7)
            .sub_product(t107, t26)
            .sub_product(t117, t116);
    let t127 = (t27 * t7).add_product(t108, t26).sub_product(t119, t116);
    let t128 = t127 * t126;
    let t129 = (-(t110 * t26)).sub_product(t121, t116);
    let t130 = t129 * t126;
    let t131 = (-(t112 * t26)).sub_product(t123, t116);
    let t132 = t131 * t126;
    let t133 = (-(t114 * t26)).sub_product(t125, t116);
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, t6)
            .sub_product(t108, t27)
            .sub_product(t119, t118)
            .sub_product(t128, t127);
    let t136 = (t110 * t27).sub_product(t121, t118).sub_product(t130, t127);
    let t137 = t136 * t135;
    let t138 = (t112 * t27).sub_product(t123, t118).sub_product(t132, t127);
    let t139 = t138 * t135;
    let t140 = (t114 * t27).sub_product(t125, t118).sub_product(t134, t127);
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
            - c.inverse_bobbin_mass)
            .sub_product(t61, t60)
            .sub_product(t74, t73)
            .sub_product(t88, t87)
            .sub_product(t99, t98)
            .sub_product(t110, t109)
            .sub_product(t121, t120)
            .sub_product(t130, t129)
            .sub_product(t137, t136);
    let t143 = (t18 * t10)
        .add_product(t63, t60)
        .sub_product(t77, t73)
        .sub_product(t90, t87)
        .sub_product(t101, t98)
        .sub_product(t112, t109)
        .sub_product(t123, t120)
        .sub_product(t132, t129)
        .sub_product(t139, t136);
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = (-(t65 * t60))
        .sub_product(t79, t73)
        .sub_product(t92, t87)
        .sub_product(t103, t98)
        .sub_product(t114, t109)
        .sub_product(t125, t120)
        .sub_product(t134, t129)
        .sub_product(t141, t136);
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t11)
            - c.inverse_bobbin_mass)
            .sub_product(t63, t62)
            .sub_product(t77, t76)
            .sub_product(t90, t89)
            .sub_product(t101, t100)
            .sub_product(t112, t111)
            .sub_product(t123, t122)
            .sub_product(t132, t131)
            .sub_product(t139, t138)
            .sub_product(t144, t143);
    let t149 = (-t29).add_product(t145, t143);
    let t150 = t149 * t148;
    let t151 = (t65 * t62)
        .sub_product(t79, t76)
        .sub_product(t92, t89)
        .sub_product(t103, t100)
        .sub_product(t114, t111)
        .sub_product(t125, t122)
        .sub_product(t134, t131)
        .sub_product(t141, t138)
        .sub_product(t147, t143);
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between))
            .sub_product(t29, bobbin_y_minus_drum_y_over_between)
            .sub_product(t30, bobbin_x_minus_drum_x_over_between)
            .sub_product(t31, bobbin_y_minus_drum_y_over_between)
            .sub_product(t145, t28)
            .sub_product(t150, t149)
            .sub_product(t153, t30)
            .sub_product(t154, t31);
    let t156 = (t147 * t28).sub_product(t152, t149);
    let t157 = t156 * t155;
    let t158 = R::literal(1.0)
        / (-(t14 * t9))
            .sub_product(t40, t39)
            .sub_product(t50, t49)
            .sub_product(t65, t64)
            .sub_product(t79, t78)
            .sub_product(t92, t91)
            .sub_product(t103, t102)
            .sub_product(t114, t113)
            .sub_product(t125, t124)
            .sub_product(t134, t133)
            .sub_product(t141, t140)
            .sub_product(t147, t146)
            .sub_product(t152, t151)
            .sub_product(t157, t156);
    let t159 = R::literal(50.0) * slide_rate;
    let t160 = t159 * cos_cylinder_phi;
    let t161 = p.spring_stiffness * (slide - p.spring_free_length);
    let t162 = t161 * cos_cylinder_phi;
    let t163 = t160 + t162;
    let t164 = t161 * sin_cylinder_phi;
    let t165 = t159 * sin_cylinder_phi;
    let t166 = t165 - (R::literal(2.943) - t164);
    let t167 = (-(t161 * t8)).sub_product(t159, t8);
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
    let t185 = (bobbin_v_x
        * (bobbin_v_x_over_between + t179 + t180 - t177 - t178 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t183 + t184 - t181 - t182 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t177 + t178 + drum_v_x_over_between - bobbin_v_x_over_between - t179 - t180,
        )
        .add_product(
            drum_v_y,
            t181 + t182 + drum_v_y_over_between - bobbin_v_y_over_between - t183 - t184,
        );
    let t186 = t36 * t173;
    let t187 = -t174 - R::literal(-9.81) + t186;
    let t188 = t15 * c.bobbin_radius_times_winding_force;
    let t189 = (t188 - t173.add_product(t175, cos_plate_phi))
        .add_product(t38, t173)
        .sub_product(t46, t187);
    let t190 = t16 * c.bobbin_radius_times_winding_force;
    let t191 = (-t174.add_product(t175, sin_plate_phi) - R::literal(9.81)
        - R::literal(-9.81) - t190 + t186)
        .sub_product(t48, t187)
        .sub_product(t55, t189);
    let t192 = R::literal(3.333_333_333_333_333_5) * t163;
    let t193 = (t188
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        ) - t192)
        .sub_product(t21, t167)
        .sub_product(t57, t189)
        .sub_product(t69, t191);
    let t194 = R::literal(3.333_333_333_333_333_5) * t166;
    let t195 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t190 - t194)
        .add_product(t22, t167)
        .sub_product(t58, t189)
        .sub_product(t71, t191)
        .sub_product(t82, t193);
    let t196 = (-(R::literal(-2_777.777_777_777_778) * t167))
        .add_product(t84, t193)
        .sub_product(t95, t195);
    let t197 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t163)
        .add_product(t20, t166)
        .add_product(t23, t167)
        .add_product(t24, t168)
        .sub_product(t25, t169)
        .sub_product(t86, t193)
        .sub_product(t97, t195);
    let t198 = t197.sub_product(t106, t196);
    let t199 = R::literal(5.0) * t168;
    let t200 = (-t199)
        .add_product(t176, cos_rod_phi)
        .sub_product(t107, t196)
        .sub_product(t117, t198);
    let t201 = R::literal(5.0) * t169;
    let t202 = (-t201)
        .add_product(t176, sin_rod_phi)
        .add_product(t108, t196)
        .sub_product(t119, t198)
        .sub_product(t128, t200);
    let t203 = c.inverse_bobbin_mass * t170;
    let t204 = ((t11 * plate_omega_squared)
        .sub_product(t17, c.bobbin_radius_times_winding_force) + t203)
        .sub_product(t61, t189)
        .sub_product(t74, t191)
        .sub_product(t88, t193)
        .sub_product(t99, t195)
        .sub_product(t110, t196)
        .sub_product(t121, t198)
        .sub_product(t130, t200)
        .sub_product(t137, t202);
    let t205 = c.inverse_bobbin_mass * t171;
    let t206 = (R::literal(-9.81)
        .add_product(t10, plate_omega_squared)
        .add_product(t18, c.bobbin_radius_times_winding_force) - t205)
        .add_product(t63, t189)
        .sub_product(t77, t191)
        .sub_product(t90, t193)
        .sub_product(t101, t195)
        .sub_product(t112, t196)
        .sub_product(t123, t198)
        .sub_product(t132, t200)
        .sub_product(t139, t202)
        .sub_product(t144, t204);
    let t207 = (-t185)
        .add_product(t28, t170)
        .sub_product(t29, t171)
        .add_product(t31, R::literal(-14.715))
        .add_product(t145, t204)
        .sub_product(t150, t206)
        .sub_product(t154, R::literal(9.809_999_999_999_999));
    let t208 = ((R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared)
        .sub_product(t40, t173)
        .sub_product(t50, t187)
        .sub_product(t65, t189)
        .sub_product(t79, t191)
        .sub_product(t92, t193)
        .sub_product(t103, t195)
        .sub_product(t114, t196)
        .sub_product(t125, t198)
        .sub_product(t134, t200)
        .sub_product(t141, t202)
        .sub_product(t147, t204)
        .sub_product(t152, t206)
        .sub_product(t157, t207) * t158;
    let t209 = (t207 * t155).sub_product(t157, t208);
    let axle_b_x = t153 * t209;
    let t210 = (t206 * t148).sub_product(t150, t209).sub_product(t152, t208);
    let t211 = (t204 * t142)
        .sub_product(t144, t210)
        .add_product(t145, t209)
        .sub_product(t147, t208);
    let t212 = (t202 * t135)
        .sub_product(t137, t211)
        .sub_product(t139, t210)
        .sub_product(t141, t208);
    let t213 = (t200 * t126)
        .sub_product(t128, t212)
        .sub_product(t130, t211)
        .sub_product(t132, t210)
        .sub_product(t134, t208);
    let t214 = (t198 * t115)
        .sub_product(t117, t213)
        .sub_product(t119, t212)
        .sub_product(t121, t211)
        .sub_product(t123, t210)
        .sub_product(t125, t208);
    let t215 = (t196 * t104)
        .sub_product(t106, t214)
        .sub_product(t107, t213)
        .add_product(t108, t212)
        .sub_product(t110, t211)
        .sub_product(t112, t210)
        .sub_product(t114, t208);
    let t216 = (t195 * t93)
        .sub_product(t95, t215)
        .sub_product(t97, t214)
        .sub_product(t99, t211)
        .sub_product(t101, t210)
        .sub_product(t103, t208);
    let t217 = (t193 * t80)
        .sub_product(t82, t216)
        .add_product(t84, t215)
        .sub_product(t86, t214)
        .sub_product(t88, t211)
        .sub_product(t90, t210)
        .sub_product(t92, t208);
    let t218 = (t191 * t67)
        .sub_product(t69, t217)
        .sub_product(t71, t216)
        .sub_product(t74, t211)
        .sub_product(t77, t210)
        .sub_product(t79, t208);
    let t219 = (t189 * t52)
        .sub_product(t55, t218)
        .sub_product(t57, t217)
        .sub_product(t58, t216)
        .sub_product(t61, t211)
        .add_product(t63, t210)
        .sub_product(t65, t208);
    let t220 = (t187 * t44)
        .sub_product(t46, t219)
        .sub_product(t48, t218)
        .sub_product(t50, t208);
    let t221 = (-(t173 * t34))
        .sub_product(t36, t220)
        .sub_product(t38, t219)
        .sub_product(t36, t218)
        .add_product(t40, t208);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            R::literal(-14.714_999_999_999_998).sub_product(t154, t209),
        )
        .add_product(t31, t209);
    let drum_v_x_dot = (t30 * t209)
        .add_product(R::literal(0.666_666_666_666_666_6), axle_b_x);
    let bobbin_v_y_dot = t205
        .sub_product(c.inverse_bobbin_mass, t210)
        .sub_product(t29, t209);
    let bobbin_v_x_dot = (-t203)
        .sub_product(c.inverse_bobbin_mass, t211)
        .sub_product(t28, t209);
    let rod_omega_dot = (t26 * t213)
        .sub_product(R::literal(4_166.666_666_666_667), t215)
        .sub_product(t27, t212);
    let rod_v_y_dot = t201.sub_product(t25, t214).sub_product(R::literal(5.0), t212);
    let rod_v_x_dot = t199.add_product(t24, t214).sub_product(R::literal(5.0), t213);
    let cylinder_omega_dot = (t167 * R::literal(2_777.777_777_777_778))
        .sub_product(t21, t217)
        .add_product(t22, t216)
        .sub_product(R::literal(-2_777.777_777_777_778), t215)
        .add_product(t23, t214);
    let cylinder_v_y_dot = t194
        .sub_product(R::literal(3.333_333_333_333_333_5), t216)
        .add_product(t20, t214);
    let cylinder_v_x_dot = t192
        .sub_product(R::literal(3.333_333_333_333_333_5), t217)
        .sub_product(t19, t214);
    let plate_omega_dot = c
        .t1
        .sub_product(t15, t219)
        .add_product(t16, t218)
        .sub_product(t15, t217)
        .add_product(t16, t216)
        .add_product(t17, t211)
        .sub_product(t18, t210);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t218)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t216)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t210);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t217))
        .sub_product(R::literal(0.833_333_333_333_333_4), t219)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t211);
    let post_omega_dot = (t13 * t220)
        .sub_product(t12, t221)
        .sub_product(t12, t219)
        .add_product(t13, t218)
        .sub_product(t14, t208);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t220)
        .sub_product(R::literal(-1.25), t218);
    let post_v_x_dot = (-(R::literal(-1.25) * t219)).sub_product(R::literal(1.25), t221);
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
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t12 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t13 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t14 = t13 - t12;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi)
        .add_product(cylinder_omega, t14)
        .add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let t15 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
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
    let t52 = (t19 * t0).sub_product(t45, t42);
    let t53 = t52 * t51;
    let t54 = R::literal(1.25) - t48 - t50;
    let t55 = t54 * t51;
    let t56 = (t21 * t0).add_product(t47, t42);
    let t57 = t56 * t51;
    let t58 = t22 * t3;
    let t59 = R::literal(1.0)
        / (t40 - R::literal(0.833_333_333_333_333_4) - t58)
            .sub_product(t45, t44)
            .sub_product(t53, t52);
    let t60 = t23 * t3;
    let t61 = (t42 + t60).sub_product(t43, t44).sub_product(t55, t52);
    let t62 = t61 * t59;
    let t63 = R::literal(0.833_333_333_333_333_4) - t58;
    let t64 = t63 * t59;
    let t65 = t60 * t59;
    let t66 = t24 * t3;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66;
    let t68 = t67 * t59;
    let t69 = t25 * t3;
    let t70 = t69 * t59;
    let t71 = (-t46).add_product(t47, t44).sub_product(t57, t52);
    let t72 = t71 * t59;
    let t73 = t23 * t2;
    let t74 = R::literal(1.0)
        / (t49 - R::literal(0.833_333_333_333_333_4) - t73 - t50)
            .sub_product(t55, t54)
            .sub_product(t62, t61);
    let t75 = (t22 * t2).sub_product(t64, t61);
    let t76 = t75 * t74;
    let t77 = (R::literal(0.833_333_333_333_333_4) - t73).sub_product(t65, t61);
    let t78 = t77 * t74;
    let t79 = -(t24 * t2);
    let t80 = t79.sub_product(t68, t61);
    let t81 = t80 * t74;
    let t82 = t25 * t2;
    let t83 = (R::literal(0.833_333_333_333_333_4) + t82).add_product(t70, t61);
    let t84 = t83 * t74;
    let t85 = t56.sub_product(t57, t54).sub_product(t72, t61);
    let t86 = t85 * t74;
    let t87 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t58
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t28, t5)
            .sub_product(t64, t63)
            .sub_product(t76, t75);
    let t88 = t60.add_product(t29, t5).sub_product(t65, t63).sub_product(t78, t75);
    let t89 = t88 * t87;
    let t90 = R::literal(-2_777.777_777_777_778) * t5;
    let t91 = t90 * t87;
    let t92 = (-t26).add_product(t30, t5);
    let t93 = t92 * t87;
    let t94 = (R::literal(-0.833_333_333_333_333_4) + t66)
        .sub_product(t68, t63)
        .sub_product(t81, t75);
    let t95 = t94 * t87;
    let t96 = (-t69).add_product(t70, t63).sub_product(t84, t75);
    let t97 = t96 * t87;
    let t98 = (-(t72 * t63)).sub_product(t86, t75);
    let t99 = t98 * t87;
    let t100 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t73
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t29, t4)
            .sub_product(t65, t60)
            .sub_product(t78, t77)
            .sub_product(t89, t88);
    let t101 = (R::literal(-2_777.777_777_777_778) * t4).add_product(t91, t88);
    let t102 = t101 * t100;
    let t103 = t27.sub_product(t30, t4).sub_product(t93, t88);
    let t104 = t103 * t100;
    let t105 = t79.sub_product(t68, t60).sub_product(t81, t77).sub_product(t95, t88);
    let t106 = t105 * t100;
    let t107 = (R::literal(-0.833_333_333_333_333_4) + t82)
        .add_product(t70, t60)
        .sub_product(t84, t77)
        .sub_product(t97, t88);
    let t108 = t107 * t100;
    let t109 = (-(t72 * t60)).sub_product(t86, t77).sub_product(t99, t88);
    let t110 = t109 * t100;
    let t111 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445)
            .sub_product(t91, t90)
            .sub_product(t102, t101);
    let t112 = (-t30).add_product(t93, t90).sub_product(t104, t101);
    let t113 = t112 * t111;
    let t114 = t33 * t111;
    let t115 = t34 * t111;
    let t116 = (t95 * t90).sub_product(t106, t101);
    let t117 = t116 * t111;
    let t118 = (t97 * t90).sub_product(t108, t101);
    let t119 = t118 * t111;
    let t120 = (t99 * t90).sub_product(t110, t101);
    let t121 = t120 * t111;
    let t122 = R::literal(1.0)
        / (-(t26 * sin_cylinder_phi))
            .sub_product(t27, cos_cylinder_phi)
            .sub_product(t30, slide)
            .sub_product(t31, sin_cylinder_phi)
            .sub_product(t32, cos_cylinder_phi)
            .sub_product(t93, t92)
            .sub_product(t104, t103)
            .sub_product(t113, t112);
    let t123 = t31.sub_product(t114, t112);
    let t124 = t123 * t122;
    let t125 = (-t32).add_product(t115, t112);
    let t126 = t125 * t122;
    let t127 = (-(t95 * t92)).sub_product(t106, t103).sub_product(t117, t112);
    let t128 = t127 * t122;
    let t129 = (-(t97 * t92)).sub_product(t108, t103).sub_product(t119, t112);
    let t130 = t129 * t122;
    let t131 = (-(t99 * t92)).sub_product(t110, t103).sub_product(t121, t112);
    let t132 = t131 * t122;
    let t133 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t33, t7)
            .sub_product(t114, t33)
            .sub_product(t124, t123);
    let t134 = (t34 * t7).add_product(t115, t33).sub_product(t126, t123);
    let t135 = t134 * t133;
    let t136 = (-(t117 * t33)).sub_product(t128, t123);
    let t137 = t136 * t133;
    let t138 = (-(t119 * t33)).sub_product(t130, t123);
    let t139 = t138 * t133;
    let t140 = (-(t121 * t33)).sub_product(t132, t123);
    let t141 = t140 * t133;
    let t142 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t34, t6)
            .sub_product(t115, t34)
            .sub_product(t126, t125)
            .sub_product(t135, t134);
    let t143 = (t117 * t34).sub_product(t128, t125).sub_product(t137, t134);
    let t144 = t143 * t142;
    let t145 = (t119 * t34).sub_product(t130, t125).sub_product(t139, t134);
    let t146 = t145 * t142;
    let t147 = (t121 * t34).sub_product(t132, t125).sub_product(t141, t134);
    let t148 = t147 * t142;
    let t149 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t24, t16)
            - c.inverse_bobbin_mass)
            .sub_product(t68, t67)
            .sub_product(t81, t80)
            .sub_product(t95, t94)
            .sub_product(t106, t105)
            .sub_product(t117, t116)
            .sub_product(t128, t127)
            .sub_product(t137, t136)
            .sub_product(t144, t143);
    let t150 = (t25 * t16)
        .add_product(t70, t67)
        .sub_product(t84, t80)
        .sub_product(t97, t94)
        .sub_product(t108, t105)
        .sub_product(t119, t116)
        .sub_product(t130, t127)
        .sub_product(t139, t136)
        .sub_product(t146, t143);
    let t151 = t150 * t149;
    let t152 = t35 * t149;
    let t153 = (-(t72 * t67))
        .sub_product(t86, t80)
        .sub_product(t99, t94)
        .sub_product(t110, t105)
        .sub_product(t121, t116)
        .sub_product(t132, t127)
        .sub_product(t141, t136)
        .sub_product(t148, t143);
    let t154 = t153 * t149;
    let t155 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t25, t18)
            - c.inverse_bobbin_mass)
            .sub_product(t70, t69)
            .sub_product(t84, t83)
            .sub_product(t97, t96)
            .sub_product(t108, t107)
            .sub_product(t119, t118)
            .sub_product(t130, t129)
            .sub_product(t139, t138)
            .sub_product(t146, t145)
            .sub_product(t151, t150);
    let t156 = (-t36).add_product(t152, t150);
    let t157 = t156 * t155;
    let t158 = (t72 * t69)
        .sub_product(t86, t83)
        .sub_product(t99, t96)
        .sub_product(t110, t107)
        .sub_product(t121, t118)
        .sub_product(t132, t129)
        .sub_product(t141, t138)
        .sub_product(t148, t145)
        .sub_product(t154, t150);
    let t159 = t158 * t155;
    let t160 = t37 * R::literal(-1.5);
    let t161 = t38 * R::literal(-1.5);
    let t162 = R::literal(1.0)
        / (-(t35 * bobbin_x_minus_drum_x_over_between))
            .sub_product(t36, bobbin_y_minus_drum_y_over_between)
            .sub_product(t37, bobbin_x_minus_drum_x_over_between)
            .sub_product(t38, bobbin_y_minus_drum_y_over_between)
            .sub_product(t152, t35)
            .sub_product(t157, t156)
            .sub_product(t160, t37)
            .sub_product(t161, t38);
    let t163 = (t154 * t35).sub_product(t159, t156);
    let t164 = t163 * t162;
    let t165 = R::literal(1.0)
        / (-(t21 * t15))
            .sub_product(t47, t46)
            .sub_product(t57, t56)
            .sub_product(t72, t71)
            .sub_product(t86, t85)
            .sub_product(t99, t98)
            .sub_product(t110, t109)
            .sub_product(t121, t120)
            .sub_product(t132, t131)
            .sub_product(t141, t140)
            .sub_product(t148, t147)
            .sub_product(t154, t153)
            .sub_product(t159, t158)
            .sub_product(t164, t163);
    let t166 = R::literal(50.0) * slide_rate;
    let t167 = t166 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t168 = p.spring_stiffness * slide_minus_spring_free_length;
    let t169 = t168 * cos_cylinder_phi;
    let t170 = t167 + t169;
    let t171 = t168 * sin_cylinder_phi;
    let t172 = t166 * sin_cylinder_phi;
    let t173 = t172 - (R::literal(2.943) - t171);
    let t174 = (-(t168 * t14)).sub_product(t166, t14);
    let t175 = -t167;
    let t176 = t175 - t169;
    let t177 = -t172 - (R::literal(1.962) + t171);
    let t178 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t179 = p.winding_force * bobbin_x_minus_drum_x;
    let t180 = t179 / between - c.t0;
    let post_omega_squared = post_omega * post_omega;
    let t181 = R::literal(0.1) * post_omega_squared;
    let t182 = t181 * cos_post_phi;
    let t183 = t181 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t184 = R::literal(0.06) * plate_omega_squared;
    let t185 = t184 * cos_plate_phi;
    let t186 = t184 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t187 = cylinder_omega_squared * cos_cylinder_phi;
    let t188 = cylinder_omega_squared * sin_cylinder_phi;
    let t189 = R::literal(2.0) * cylinder_v_x;
    let t190 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t191 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t192 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t193 = R::literal(2.0) * rod_v_x;
    let t194 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t195 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t196 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t197 = R::literal(0.06) * (rod_omega * rod_omega);
    let t198 = t197 * cos_rod_phi;
    let t199 = t197 * sin_rod_phi;
    let t200 = t18 * plate_omega_squared;
    let between_squared_times_between = between * between * between;
    let t201 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t202 = bobbin_v_y * bobbin_x_minus_drum_x;
    let t203 = t202 * bobbin_y_minus_drum_y / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t204 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let drum_v_y_times_bobbin_x_minus_drum_x = drum_v_y * bobbin_x_minus_drum_x;
    let t205 = drum_v_y_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t206 = bobbin_v_x * bobbin_x_minus_drum_x;
    let t207 = t206 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t208 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let drum_v_x_times_bobbin_x_minus_drum_x = drum_v_x * bobbin_x_minus_drum_x;
    let t209 = drum_v_x_times_bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t210 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t211 = (bobbin_v_x
        * (bobbin_v_x_over_between + t204 + t205 - t201 - t203 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t209 + t210 - t207 - t208 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t201 + t203 + drum_v_x_over_between - bobbin_v_x_over_between - t204 - t205,
        )
        .add_product(
            drum_v_y,
            t207 + t208 + drum_v_y_over_between - bobbin_v_y_over_between - t209 - t210,
        );
    let t212 = R::literal(0.044) * cos_post_phi;
    let t213 = R::literal(0.143) * sin_post_phi;
    let t214 = t43 * t182;
    let t215 = -t183 - R::literal(-9.81) + t214;
    let t216 = t22 * c.bobbin_radius_times_winding_force;
    let t217 = (t216 - (t185 + t182)).add_product(t45, t182).sub_product(t53, t215);
    let t218 = t23 * c.bobbin_radius_times_winding_force;
    let t219 = (-(t186 + t183) - R::literal(9.81) - R::literal(-9.81) - t218 + t214)
        .sub_product(t55, t215)
        .sub_product(t62, t217);
    let t220 = R::literal(3.333_333_333_333_333_5) * t170;
    let t221 = (t216
        .sub_product(
            R::literal(0.06),
            t187.add_product(plate_omega_squared, cos_plate_phi),
        ) - t220)
        .sub_product(t28, t174)
        .sub_product(t64, t217)
        .sub_product(t76, t219);
    let t222 = R::literal(3.333_333_333_333_333_5) * t173;
    let t223 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            t188.add_product(plate_omega_squared, sin_plate_phi),
        ) - t218 - t222)
        .add_product(t29, t174)
        .sub_product(t65, t217)
        .sub_product(t78, t219)
        .sub_product(t89, t221);
    let t224 = (-(R::literal(-2_777.777_777_777_778) * t174))
        .add_product(t91, t221)
        .sub_product(t102, t223);
    let t225 = (cylinder_omega
        * (((t193 * cos_cylinder_phi).add_product(t194, sin_cylinder_phi) + t195 + t196)
            .sub_product(t189, cos_cylinder_phi)
            .sub_product(t190, sin_cylinder_phi) - t191 - t192))
        .sub_product(t26, t170)
        .add_product(t27, t173)
        .add_product(t30, t174)
        .add_product(t31, t176)
        .sub_product(t32, t177)
        .sub_product(t93, t221)
        .sub_product(t104, t223)
        .sub_product(t113, t224);
    let t226 = R::literal(5.0) * t176;
    let t227 = (t198 - t226).sub_product(t114, t224).sub_product(t124, t225);
    let t228 = R::literal(5.0) * t177;
    let t229 = (t199 - t228)
        .add_product(t115, t224)
        .sub_product(t126, t225)
        .sub_product(t135, t227);
    let t230 = c.inverse_bobbin_mass * t178;
    let t231 = (t200.sub_product(t24, c.bobbin_radius_times_winding_force) + t230)
        .sub_product(t68, t217)
        .sub_product(t81, t219)
        .sub_product(t95, t221)
        .sub_product(t106, t223)
        .sub_product(t117, t224)
        .sub_product(t128, t225)
        .sub_product(t137, t227)
        .sub_product(t144, t229);
    let t232 = c.inverse_bobbin_mass * t180;
    let t233 = (R::literal(-9.81)
        .add_product(t16, plate_omega_squared)
        .add_product(t25, c.bobbin_radius_times_winding_force) - t232)
        .add_product(t70, t217)
        .sub_product(t84, t219)
        .sub_product(t97, t221)
        .sub_product(t108, t223)
        .sub_product(t119, t224)
        .sub_product(t130, t225)
        .sub_product(t139, t227)
        .sub_product(t146, t229)
        .sub_product(t151, t231);
    let t234 = (-t211)
        .add_product(t35, t178)
        .sub_product(t36, t180)
        .add_product(t38, R::literal(-14.715))
        .add_product(t152, t231)
        .sub_product(t157, t233)
        .sub_product(t161, R::literal(9.809_999_999_999_999));
    let t235 = ((t213 - t212) * post_omega_squared)
        .sub_product(t47, t182)
        .sub_product(t57, t215)
        .sub_product(t72, t217)
        .sub_product(t86, t219)
        .sub_product(t99, t221)
        .sub_product(t110, t223)
        .sub_product(t121, t224)
        .sub_product(t132, t225)
        .sub_product(t141, t227)
        .sub_product(t148, t229)
        .sub_product(t154, t231)
        .sub_product(t159, t233)
        .sub_product(t164, t234) * t165;
    let t236 = (t234 * t162).sub_product(t164, t235);
    let axle_b_x = t160 * t236;
    let t237 = (t233 * t155).sub_product(t157, t236).sub_product(t159, t235);
    let t238 = (t231 * t149)
        .sub_product(t151, t237)
        .add_product(t152, t236)
        .sub_product(t154, t235);
    let t239 = (t229 * t142)
        .sub_product(t144, t238)
        .sub_product(t146, t237)
        .sub_product(t148, t235);
    let t240 = (t227 * t133)
        .sub_product(t135, t239)
        .sub_product(t137, t238)
        .sub_product(t139, t237)
        .sub_product(t141, t235);
    let t241 = (t225 * t122)
        .sub_product(t124, t240)
        .sub_product(t126, t239)
        .sub_product(t128, t238)
        .sub_product(t130, t237)
        .sub_product(t132, t235);
    let t242 = (t224 * t111)
        .sub_product(t113, t241)
        .sub_product(t114, t240)
        .add_product(t115, t239)
        .sub_product(t117, t238)
        .sub_product(t119, t237)
        .sub_product(t121, t235);
    let t243 = (t223 * t100)
        .sub_product(t102, t242)
        .sub_product(t104, t241)
        .sub_product(t106, t238)
        .sub_product(t108, t237)
        .sub_product(t110, t235);
    let t244 = (t221 * t87)
        .sub_product(t89, t243)
        .add_product(t91, t242)
        .sub_product(t93, t241)
        .sub_product(t95, t238)
        .sub_product(t97, t237)
        .sub_product(t99, t235);
    let t245 = (t219 * t74)
        .sub_product(t76, t244)
        .sub_product(t78, t243)
        .sub_product(t81, t238)
        .sub_product(t84, t237)
        .sub_product(t86, t235);
    let t246 = (t217 * t59)
        .sub_product(t62, t245)
        .sub_product(t64, t244)
        .sub_product(t65, t243)
        .sub_product(t68, t238)
        .add_product(t70, t237)
        .sub_product(t72, t235);
    let t247 = (t215 * t51)
        .sub_product(t53, t246)
        .sub_product(t55, t245)
        .sub_product(t57, t235);
    let t248 = (-(t182 * t41))
        .sub_product(t43, t247)
        .sub_product(t45, t246)
        .sub_product(t43, t245)
        .add_product(t47, t235);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            R::literal(-14.714_999_999_999_998).sub_product(t161, t236),
        )
        .add_product(t38, t236);
    let drum_v_x_dot = (t37 * t236)
        .add_product(R::literal(0.666_666_666_666_666_6), axle_b_x);
    let bobbin_v_y_dot = t232
        .sub_product(c.inverse_bobbin_mass, t237)
        .sub_product(t36, t236);
    let bobbin_v_x_dot = (-t230)
        .sub_product(c.inverse_bobbin_mass, t238)
        .sub_product(t35, t236);
    let rod_omega_dot = (t33 * t240)
        .sub_product(R::literal(4_166.666_666_666_667), t242)
        .sub_product(t34, t239);
    let rod_v_y_dot = t228.sub_product(t32, t241).sub_product(R::literal(5.0), t239);
    let rod_v_x_dot = t226.add_product(t31, t241).sub_product(R::literal(5.0), t240);
    let cylinder_omega_dot = (t174 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t244)
        .add_product(t29, t243)
        .sub_product(R::literal(-2_777.777_777_777_778), t242)
        .add_product(t30, t241);
    let cylinder_v_y_dot = t222
        .sub_product(R::literal(3.333_333_333_333_333_5), t243)
        .add_product(t27, t241);
    let cylinder_v_x_dot = t220
        .sub_product(R::literal(3.333_333_333_333_333_5), t244)
        .sub_product(t26, t241);
    let plate_omega_dot = c
        .t1
        .sub_product(t22, t246)
        .add_product(t23, t245)
        .sub_product(t22, t244)
        .add_product(t23, t243)
        .add_product(t24, t238)
        .sub_product(t25, t237);
    let post_omega_dot = (t20 * t247)
        .sub_product(t19, t248)
        .sub_product(t19, t246)
        .add_product(t20, t245)
        .sub_product(t21, t235);
    let t249 = t212 - t213;
    let t250 = (-(t1 * t247))
        .sub_product(t0, t248)
        .sub_product(t0, t246)
        .sub_product(t1, t245)
        .sub_product(t249, t235);
    let t251 = t183.sub_product(t0, post_omega_dot).sub_product(t19, t250);
    let t252 = (-t182)
        .sub_product(t1, post_omega_dot)
        .add_product(t20, t250)
        .sub_product(t43, t251);
    let t253 = t251.sub_product(t45, t251).sub_product(t53, t252);
    let t254 = t252.sub_product(t55, t252).sub_product(t62, t253);
    let t255 = (-(t64 * t253)).sub_product(t76, t254);
    let t256 = (-(t65 * t253)).sub_product(t78, t254).sub_product(t89, t255);
    let t257 = (t91 * t255).sub_product(t102, t256);
    let t258 = (-(t93 * t255)).sub_product(t104, t256).sub_product(t113, t257);
    let t259 = (-(t114 * t257)).sub_product(t124, t258);
    let t260 = (t115 * t257).sub_product(t126, t258).sub_product(t135, t259);
    let t261 = (-(t68 * t253))
        .sub_product(t81, t254)
        .sub_product(t95, t255)
        .sub_product(t106, t256)
        .sub_product(t117, t257)
        .sub_product(t128, t258)
        .sub_product(t137, t259)
        .sub_product(t144, t260);
    let t262 = (t70 * t253)
        .sub_product(t84, t254)
        .sub_product(t97, t255)
        .sub_product(t108, t256)
        .sub_product(t119, t257)
        .sub_product(t130, t258)
        .sub_product(t139, t259)
        .sub_product(t146, t260)
        .sub_product(t151, t261);
    let t263 = (t152 * t261).sub_product(t157, t262);
    let t264 = (t15 * post_omega_squared)
        .sub_product(t249, post_omega_dot)
        .sub_product(t21, t250)
        .add_product(t47, t251)
        .sub_product(t57, t252)
        .sub_product(t72, t253)
        .sub_product(t86, t254)
        .sub_product(t99, t255)
        .sub_product(t110, t256)
        .sub_product(t121, t257)
        .sub_product(t132, t258)
        .sub_product(t141, t259)
        .sub_product(t148, t260)
        .sub_product(t154, t261)
        .sub_product(t159, t262)
        .sub_product(t164, t263) * t165;
    let t265 = (t263 * t162).sub_product(t164, t264);
    let t266 = (t262 * t155).sub_product(t157, t265).sub_product(t159, t264);
    let t267 = (t261 * t149)
        .sub_product(t151, t266)
        .add_product(t152, t265)
        .sub_product(t154, t264);
    let t268 = (t260 * t142)
        .sub_product(t144, t267)
        .sub_product(t146, t266)
        .sub_product(t148, t264);
    let t269 = (t259 * t133)
        .sub_product(t135, t268)
        .sub_product(t137, t267)
        .sub_product(t139, t266)
        .sub_product(t141, t264);
    let t270 = (t258 * t122)
        .sub_product(t124, t269)
        .sub_product(t126, t268)
        .sub_product(t128, t267)
        .sub_product(t130, t266)
        .sub_product(t132, t264);
    let t271 = (t257 * t111)
        .sub_product(t113, t270)
        .sub_product(t114, t269)
        .add_product(t115, t268)
        .sub_product(t117, t267)
        .sub_product(t119, t266)
        .sub_product(t121, t264);
    let t272 = (t256 * t100)
        .sub_product(t102, t271)
        .sub_product(t104, t270)
        .sub_product(t106, t267)
        .sub_product(t108, t266)
        .sub_product(t110, t264);
    let t273 = (t255 * t87)
        .sub_product(t89, t272)
        .add_product(t91, t271)
        .sub_product(t93, t270)
        .sub_product(t95, t267)
        .sub_product(t97, t266)
        .sub_product(t99, t264);
    let t274 = (t254 * t74)
        .sub_product(t76, t273)
        .sub_product(t78, t272)
        .sub_product(t81, t267)
        .sub_product(t84, t266)
        .sub_product(t86, t264);
    let t275 = (t253 * t59)
        .sub_product(t62, t274)
        .sub_product(t64, t273)
        .sub_product(t65, t272)
        .sub_product(t68, t267)
        .add_product(t70, t266)
        .sub_product(t72, t264);
    let t276 = (t252 * t51)
        .sub_product(t53, t275)
        .sub_product(t55, t274)
        .sub_product(t57, t264);
    let t277 = (t251 * t41)
        .sub_product(t43, t276)
        .sub_product(t45, t275)
        .sub_product(t43, t274)
        .add_product(t47, t264);
    let drum_v_y_dot_by_post_phi = (t38 * t265)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t265);
    let drum_v_x_dot_by_post_phi = (t37 * t265)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t265);
    let bobbin_v_y_dot_by_post_phi = (-(t36 * t265))
        .sub_product(c.inverse_bobbin_mass, t266);
    let bobbin_v_x_dot_by_post_phi = (-(t35 * t265))
        .sub_product(c.inverse_bobbin_mass, t267);
    let rod_omega_dot_by_post_phi = (t33 * t269)
        .sub_product(R::literal(4_166.666_666_666_667), t271)
        .sub_product(t34, t268);
    let rod_v_y_dot_by_post_phi = (-(R::literal(5.0) * t268)).sub_product(t32, t270);
    let rod_v_x_dot_by_post_phi = (-(R::literal(5.0) * t269)).add_product(t31, t270);
    let cylinder_omega_dot_by_post_phi = (t29 * t272)
        .sub_product(t28, t273)
        .sub_product(R::literal(-2_777.777_777_777_778), t271)
        .add_product(t30, t270);
    let cylinder_v_y_dot_by_post_phi = (t27 * t270)
        .sub_product(R::literal(3.333_333_333_333_333_5), t272);
    let cylinder_v_x_dot_by_post_phi = (-(t26 * t270))
        .sub_product(R::literal(3.333_333_333_333_333_5), t273);
    let plate_omega_dot_by_post_phi = (t23 * t274)
        .sub_product(t22, t275)
        .sub_product(t22, t273)
        .add_product(t23, t272)
        .add_product(t24, t267)
        .sub_product(t25, t266);
    let plate_v_y_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t272))
        .sub_product(R::literal(0.833_333_333_333_333_4), t274)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t266);
    let plate_v_x_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t273))
        .sub_product(R::literal(0.833_333_333_333_333_4), t275)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t267);
    let post_omega_dot_by_post_phi = (t250 * R::literal(370.370_370_370_370_3))
        .sub_product(t19, t277)
        .add_product(t20, t276)
        .sub_product(t19, t275)
        .add_product(t20, t274)
        .sub_product(t21, t264);
    let post_v_y_dot_by_post_phi = (-(R::literal(-1.25) * t274))
        .sub_product(R::literal(1.25), t276);
    let post_v_x_dot_by_post_phi = (-(R::literal(-1.25) * t275))
        .sub_product(R::literal(1.25), t277);
    let t278 = (-(t3 * t245))
        .sub_product(t2, t246)
        .sub_product(t2, t244)
        .sub_product(t3, t243)
        .sub_product(t17, t238)
        .add_product(t16, t237);
    let t279 = t186.sub_product(t2, plate_omega_dot).sub_product(t22, t278);
    let t280 = (-t185).sub_product(t3, plate_omega_dot).add_product(t23, t278);
    let t281 = t280.sub_product(t62, t279);
    let t282 = t279.sub_product(t64, t279).sub_product(t76, t281);
    let t283 = t280.sub_product(t65, t279).sub_product(t78, t281).sub_product(t89, t282);
    let t284 = (t91 * t282).sub_product(t102, t283);
    let t285 = (-(t93 * t282)).sub_product(t104, t283).sub_product(t113, t284);
    let t286 = (-(t114 * t284)).sub_product(t124, t285);
    let t287 = (t115 * t284).sub_product(t126, t285).sub_product(t135, t286);
    let t288 = ((-t10 - t11) * plate_omega_squared)
        .sub_product(t17, plate_omega_dot)
        .add_product(t24, t278)
        .sub_product(t68, t279)
        .sub_product(t81, t281)
        .sub_product(t95, t282)
        .sub_product(t106, t283)
        .sub_product(t117, t284)
        .sub_product(t128, t285)
        .sub_product(t137, t286)
        .sub_product(t144, t287);
    let t289 = t200
        .add_product(t16, plate_omega_dot)
        .sub_product(t25, t278)
        .add_product(t70, t279)
        .sub_product(t84, t281)
        .sub_product(t97, t282)
        .sub_product(t108, t283)
        .sub_product(t119, t284)
        .sub_product(t130, t285)
        .sub_product(t139, t286)
        .sub_product(t146, t287)
        .sub_product(t151, t288);
    let t290 = (t152 * t288).sub_product(t157, t289);
    let t291 = (-(t72 * t279))
        .sub_product(t86, t281)
        .sub_product(t99, t282)
        .sub_product(t110, t283)
        .sub_product(t121, t284)
        .sub_product(t132, t285)
        .sub_product(t141, t286)
        .sub_product(t148, t287)
        .sub_product(t154, t288)
        .sub_product(t159, t289)
        .sub_product(t164, t290) * t165;
    let t292 = (t290 * t162).sub_product(t164, t291);
    let t293 = (t289 * t155).sub_product(t157, t292).sub_product(t159, t291);
    let t294 = (t288 * t149)
        .sub_product(t151, t293)
        .add_product(t152, t292)
        .sub_product(t154, t291);
    let t295 = (t287 * t142)
        .sub_product(t144, t294)
        .sub_product(t146, t293)
        .sub_product(t148, t291);
    let t296 = (t286 * t133)
        .sub_product(t135, t295)
        .sub_product(t137, t294)
        .sub_product(t139, t293)
        .sub_product(t141, t291);
    let t297 = (t285 * t122)
        .sub_product(t124, t296)
        .sub_product(t126, t295)
        .sub_product(t128, t294)
        .sub_product(t130, t293)
        .sub_product(t132, t291);
    let t298 = (t284 * t111)
        .sub_product(t113, t297)
        .sub_product(t114, t296)
        .add_product(t115, t295)
        .sub_product(t117, t294)
        .sub_product(t119, t293)
        .sub_product(t121, t291);
    let t299 = (t283 * t100)
        .sub_product(t102, t298)
        .sub_product(t104, t297)
        .sub_product(t106, t294)
        .sub_product(t108, t293)
        .sub_product(t110, t291);
    let t300 = (t282 * t87)
        .sub_product(t89, t299)
        .add_product(t91, t298)
        .sub_product(t93, t297)
        .sub_product(t95, t294)
        .sub_product(t97, t293)
        .sub_product(t99, t291);
    let t301 = (t281 * t74)
        .sub_product(t76, t300)
        .sub_product(t78, t299)
        .sub_product(t81, t294)
        .sub_product(t84, t293)
        .sub_product(t86, t291);
    let t302 = (t279 * t59)
        .sub_product(t62, t301)
        .sub_product(t64, t300)
        .sub_product(t65, t299)
        .sub_product(t68, t294)
        .add_product(t70, t293)
        .sub_product(t72, t291);
    let t303 = (-(t55 * t301)).sub_product(t53, t302).sub_product(t57, t291);
    let t304 = (-(t45 * t302))
        .sub_product(t43, t303)
        .sub_product(t43, t301)
        .add_product(t47, t291);
    let drum_v_y_dot_by_plate_phi = (t38 * t292)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t292);
    let drum_v_x_dot_by_plate_phi = (t37 * t292)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t292);
    let bobbin_v_y_dot_by_plate_phi = (-(t36 * t292))
        .sub_product(c.inverse_bobbin_mass, t293);
    let bobbin_v_x_dot_by_plate_phi = (-(t35 * t292))
        .sub_product(c.inverse_bobbin_mass, t294);
    let rod_omega_dot_by_plate_phi = (t33 * t296)
        .sub_product(R::literal(4_166.666_666_666_667), t298)
        .sub_product(t34, t295);
    let rod_v_y_dot_by_plate_phi = (-(R::literal(5.0) * t295)).sub_product(t32, t297);
    let rod_v_x_dot_by_plate_phi = (-(R::literal(5.0) * t296)).add_product(t31, t297);
    let cylinder_omega_dot_by_plate_phi = (t29 * t299)
        .sub_product(t28, t300)
        .sub_product(R::literal(-2_777.777_777_777_778), t298)
        .add_product(t30, t297);
    let cylinder_v_y_dot_by_plate_phi = (t27 * t297)
        .sub_product(R::literal(3.333_333_333_333_333_5), t299);
    let cylinder_v_x_dot_by_plate_phi = (-(t26 * t297))
        .sub_product(R::literal(3.333_333_333_333_333_5), t300);
    let plate_omega_dot_by_plate_phi = (t278 * R::literal(400.0))
        .sub_product(t22, t302)
        .add_product(t23, t301)
        .sub_product(t22, t300)
        .add_product(t23, t299)
        .add_product(t24, t294)
        .sub_product(t25, t293);
    let plate_v_y_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t299))
        .sub_product(R::literal(0.833_333_333_333_333_4), t301)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t293);
    let plate_v_x_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t300))
        .sub_product(R::literal(0.833_333_333_333_333_4), t302)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t294);
    let post_omega_dot_by_plate_phi = (t20 * t303)
        .sub_product(t19, t304)
        .sub_product(t19, t302)
        .add_product(t20, t301)
        .sub_product(t21, t291);
    let post_v_y_dot_by_plate_phi = (-(R::literal(-1.25) * t301))
        .sub_product(R::literal(1.25), t303);
    let post_v_x_dot_by_plate_phi = (-(R::literal(-1.25) * t302))
        .sub_product(R::literal(1.25), t304);
    let t305 = p.spring_stiffness * cos_cylinder_phi;
    let t306 = R::literal(50.0) * cylinder_omega;
    let t307 = t306 * sin_cylinder_phi;
    let t308 = t307 - t305;
    let t309 = t308 * cos_cylinder_phi;
    let t310 = t308 * sin_cylinder_phi;
    let t311 = t306 * t14;
    let t312 = t311 * sin_cylinder_phi;
    let t313 = p.spring_stiffness * t14;
    let t314 = t313 * cos_cylinder_phi;
    let t315 = t305 - t307;
    let t316 = t315 * cos_cylinder_phi;
    let t317 = t315 * sin_cylinder_phi;
    let t318 = cos_cylinder_phi * t241;
    let t319 = t314 - t312 - t172 - t171 - t318;
    let t320 = cos_cylinder_phi * cylinder_omega_dot;
    let t321 = R::literal(3.333_333_333_333_333_5) * t309;
    let t322 = (-t321).sub_product(t28, t319);
    let t323 = R::literal(3.333_333_333_333_333_5) * t310;
    let t324 = (-t323).add_product(t29, t319).sub_product(t89, t322);
    let t325 = (-(R::literal(-2_777.777_777_777_778) * t319))
        .add_product(t91, t322)
        .sub_product(t102, t324);
    let t326 = (t188 - t320)
        .sub_product(t26, t309)
        .add_product(t27, t310)
        .add_product(t30, t319)
        .add_product(t31, t316)
        .sub_product(t32, t317)
        .sub_product(t93, t322)
        .sub_product(t104, t324)
        .sub_product(t113, t325);
    let t327 = R::literal(5.0) * t316;
    let t328 = (-t327).sub_product(t114, t325).sub_product(t124, t326);
    let t329 = R::literal(5.0) * t317;
    let t330 = (-t329)
        .add_product(t115, t325)
        .sub_product(t126, t326)
        .sub_product(t135, t328);
    let t331 = (-(t95 * t322))
        .sub_product(t106, t324)
        .sub_product(t117, t325)
        .sub_product(t128, t326)
        .sub_product(t137, t328)
        .sub_product(t144, t330);
    let t332 = (-(t97 * t322))
        .sub_product(t108, t324)
        .sub_product(t119, t325)
        .sub_product(t130, t326)
        .sub_product(t139, t328)
        .sub_product(t146, t330)
        .sub_product(t151, t331);
    let t333 = (t152 * t331).sub_product(t157, t332);
    let t334 = (-(t99 * t322))
        .sub_product(t110, t324)
        .sub_product(t121, t325)
        .sub_product(t132, t326)
        .sub_product(t141, t328)
        .sub_product(t148, t330)
        .sub_product(t154, t331)
        .sub_product(t159, t332)
        .sub_product(t164, t333) * t165;
    let t335 = (t333 * t162).sub_product(t164, t334);
    let t336 = (t332 * t155).sub_product(t157, t335).sub_product(t159, t334);
    let t337 = (t331 * t149)
        .sub_product(t151, t336)
        .add_product(t152, t335)
        .sub_product(t154, t334);
    let t338 = (t330 * t142)
        .sub_product(t144, t337)
        .sub_product(t146, t336)
        .sub_product(t148, t334);
    let t339 = (t328 * t133)
        .sub_product(t135, t338)
        .sub_product(t137, t337)
        .sub_product(t139, t336)
        .sub_product(t141, t334);
    let t340 = (t326 * t122)
        .sub_product(t124, t339)
        .sub_product(t126, t338)
        .sub_product(t128, t337)
        .sub_product(t130, t336)
        .sub_product(t132, t334);
    let t341 = (t325 * t111)
        .sub_product(t113, t340)
        .sub_product(t114, t339)
        .add_product(t115, t338)
        .sub_product(t117, t337)
        .sub_product(t119, t336)
        .sub_product(t121, t334);
    let t342 = (t324 * t100)
        .sub_product(t102, t341)
        .sub_product(t104, t340)
        .sub_product(t106, t337)
        .sub_product(t108, t336)
        .sub_product(t110, t334);
    let t343 = (t322 * t87)
        .sub_product(t89, t342)
        .add_product(t91, t341)
        .sub_product(t93, t340)
        .sub_product(t95, t337)
        .sub_product(t97, t336)
        .sub_product(t99, t334);
    let t344 = (-(t78 * t342))
        .sub_product(t76, t343)
        .sub_product(t81, t337)
        .sub_product(t84, t336)
        .sub_product(t86, t334);
    let t345 = (-(t64 * t343))
        .sub_product(t62, t344)
        .sub_product(t65, t342)
        .sub_product(t68, t337)
        .add_product(t70, t336)
        .sub_product(t72, t334);
    let t346 = (-(t55 * t344)).sub_product(t53, t345).sub_product(t57, t334);
    let t347 = (-(t45 * t345))
        .sub_product(t43, t346)
        .sub_product(t43, t344)
        .add_product(t47, t334);
    let drum_v_y_dot_by_cylinder_x = (t38 * t335)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t335);
    let drum_v_x_dot_by_cylinder_x = (t37 * t335)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t335);
    let bobbin_v_y_dot_by_cylinder_x = (-(t36 * t335))
        .sub_product(c.inverse_bobbin_mass, t336);
    let bobbin_v_x_dot_by_cylinder_x = (-(t35 * t335))
        .sub_product(c.inverse_bobbin_mass, t337);
    let rod_omega_dot_by_cylinder_x = (t33 * t339)
        .sub_product(R::literal(4_166.666_666_666_667), t341)
        .sub_product(t34, t338);
    let rod_v_y_dot_by_cylinder_x = t329
        .sub_product(t32, t340)
        .sub_product(R::literal(5.0), t338);
    let rod_v_x_dot_by_cylinder_x = t327
        .add_product(t31, t340)
        .sub_product(R::literal(5.0), t339);
    let cylinder_omega_dot_by_cylinder_x = (t319 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t343)
        .add_product(t29, t342)
        .sub_product(R::literal(-2_777.777_777_777_778), t341)
        .add_product(t30, t340);
    let cylinder_v_y_dot_by_cylinder_x = t323
        .sub_product(R::literal(3.333_333_333_333_333_5), t342)
        .add_product(t27, t340);
    let cylinder_v_x_dot_by_cylinder_x = t321
        .sub_product(R::literal(3.333_333_333_333_333_5), t343)
        .sub_product(t26, t340);
    let plate_omega_dot_by_cylinder_x = (t23 * t344)
        .sub_product(t22, t345)
        .sub_product(t22, t343)
        .add_product(t23, t342)
        .add_product(t24, t337)
        .sub_product(t25, t336);
    let plate_v_y_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t342))
        .sub_product(R::literal(0.833_333_333_333_333_4), t344)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t336);
    let plate_v_x_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t343))
        .sub_product(R::literal(0.833_333_333_333_333_4), t345)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t337);
    let post_omega_dot_by_cylinder_x = (t20 * t346)
        .sub_product(t19, t347)
        .sub_product(t19, t345)
        .add_product(t20, t344)
        .sub_product(t21, t334);
    let post_v_y_dot_by_cylinder_x = (-(R::literal(-1.25) * t344))
        .sub_product(R::literal(1.25), t346);
    let post_v_x_dot_by_cylinder_x = (-(R::literal(-1.25) * t345))
        .sub_product(R::literal(1.25), t347);
    let t348 = t306 * cos_cylinder_phi;
    let t349 = p.spring_stiffness * sin_cylinder_phi;
    let t350 = -t348 - t349;
    let t351 = t350 * cos_cylinder_phi;
    let t352 = t350 * sin_cylinder_phi;
    let t353 = t311 * cos_cylinder_phi;
    let t354 = t313 * sin_cylinder_phi;
    let t355 = t348 + t349;
    let t356 = t355 * cos_cylinder_phi;
    let t357 = t355 * sin_cylinder_phi;
    let t358 = sin_cylinder_phi * t241;
    let t359 = t353 + t167 + t169 + t354 - t358;
    let t360 = sin_cylinder_phi * cylinder_omega_dot;
    let t361 = R::literal(3.333_333_333_333_333_5) * t351;
    let t362 = (-t361).sub_product(t28, t359);
    let t363 = R::literal(3.333_333_333_333_333_5) * t352;
    let t364 = (-t363).add_product(t29, t359).sub_product(t89, t362);
    let t365 = (-(R::literal(-2_777.777_777_777_778) * t359))
        .add_product(t91, t362)
        .sub_product(t102, t364);
    let t366 = (-t187 - t360)
        .sub_product(t26, t351)
        .add_product(t27, t352)
        .add_product(t30, t359)
        .add_product(t31, t356)
        .sub_product(t32, t357)
        .sub_product(t93, t362)
        .sub_product(t104, t364)
        .sub_product(t113, t365);
    let t367 = R::literal(5.0) * t356;
    let t368 = (-t367).sub_product(t114, t365).sub_product(t124, t366);
    let t369 = R::literal(5.0) * t357;
    let t370 = (-t369)
        .add_product(t115, t365)
        .sub_product(t126, t366)
        .sub_product(t135, t368);
    let t371 = (-(t95 * t362))
        .sub_product(t106, t364)
        .sub_product(t117, t365)
        .sub_product(t128, t366)
        .sub_product(t137, t368)
        .sub_product(t144, t370);
    let t372 = (-(t97 * t362))
        .sub_product(t108, t364)
        .sub_product(t119, t365)
        .sub_product(t130, t366)
        .sub_product(t139, t368)
        .sub_product(t146, t370)
        .sub_product(t151, t371);
    let t373 = (t152 * t371).sub_product(t157, t372);
    let t374 = (-(t99 * t362))
        .sub_product(t110, t364)
        .sub_product(t121, t365)
        .sub_product(t132, t366)
        .sub_product(t141, t368)
        .sub_product(t148, t370)
        .sub_product(t154, t371)
        .sub_product(t159, t372)
        .sub_product(t164, t373) * t165;
    let t375 = (t373 * t162).sub_product(t164, t374);
    let t376 = (t372 * t155).sub_product(t157, t375).sub_product(t159, t374);
    let t377 = (t371 * t149)
        .sub_product(t151, t376)
        .add_product(t152, t375)
        .sub_product(t154, t374);
    let t378 = (t370 * t142)
        .sub_product(t144, t377)
        .sub_product(t146, t376)
        .sub_product(t148, t374);
    let t379 = (t368 * t133)
        .sub_product(t135, t378)
        .sub_product(t137, t377)
        .sub_product(t139, t376)
        .sub_product(t141, t374);
    let t380 = (t366 * t122)
        .sub_product(t124, t379)
        .sub_product(t126, t378)
        .sub_product(t128, t377)
        .sub_product(t130, t376)
        .sub_product(t132, t374);
    let t381 = (t365 * t111)
        .sub_product(t113, t380)
        .sub_product(t114, t379)
        .add_product(t115, t378)
        .sub_product(t117, t377)
        .sub_product(t119, t376)
        .sub_product(t121, t374);
    let t382 = (t364 * t100)
        .sub_product(t102, t381)
        .sub_product(t104, t380)
        .sub_product(t106, t377)
        .sub_product(t108, t376)
        .sub_product(t110, t374);
    let t383 = (t362 * t87)
        .sub_product(t89, t382)
        .add_product(t91, t381)
        .sub_product(t93, t380)
        .sub_product(t95, t377)
        .sub_product(t97, t376)
        .sub_product(t99, t374);
    let t384 = (-(t78 * t382))
        .sub_product(t76, t383)
        .sub_product(t81, t377)
        .sub_product(t84, t376)
        .sub_product(t86, t374);
    let t385 = (-(t64 * t383))
        .sub_product(t62, t384)
        .sub_product(t65, t382)
        .sub_product(t68, t377)
        .add_product(t70, t376)
        .sub_product(t72, t374);
    let t386 = (-(t55 * t384)).sub_product(t53, t385).sub_product(t57, t374);
    let t387 = (-(t45 * t385))
        .sub_product(t43, t386)
        .sub_product(t43, t384)
        .add_product(t47, t374);
    let drum_v_y_dot_by_cylinder_y = (t38 * t375)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t375);
    let drum_v_x_dot_by_cylinder_y = (t37 * t375)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t375);
    let bobbin_v_y_dot_by_cylinder_y = (-(t36 * t375))
        .sub_product(c.inverse_bobbin_mass, t376);
    let bobbin_v_x_dot_by_cylinder_y = (-(t35 * t375))
        .sub_product(c.inverse_bobbin_mass, t377);
    let rod_omega_dot_by_cylinder_y = (t33 * t379)
        .sub_product(R::literal(4_166.666_666_666_667), t381)
        .sub_product(t34, t378);
    let rod_v_y_dot_by_cylinder_y = t369
        .sub_product(t32, t380)
        .sub_product(R::literal(5.0), t378);
    let rod_v_x_dot_by_cylinder_y = t367
        .add_product(t31, t380)
        .sub_product(R::literal(5.0), t379);
    let cylinder_omega_dot_by_cylinder_y = (t359 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t383)
        .add_product(t29, t382)
        .sub_product(R::literal(-2_777.777_777_777_778), t381)
        .add_product(t30, t380);
    let cylinder_v_y_dot_by_cylinder_y = t363
        .sub_product(R::literal(3.333_333_333_333_333_5), t382)
        .add_product(t27, t380);
    let cylinder_v_x_dot_by_cylinder_y = t361
        .sub_product(R::literal(3.333_333_333_333_333_5), t383)
        .sub_product(t26, t380);
    let plate_omega_dot_by_cylinder_y = (t23 * t384)
        .sub_product(t22, t385)
        .sub_product(t22, t383)
        .add_product(t23, t382)
        .add_product(t24, t377)
        .sub_product(t25, t376);
    let plate_v_y_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t382))
        .sub_product(R::literal(0.833_333_333_333_333_4), t384)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t376);
    let plate_v_x_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t383))
        .sub_product(R::literal(0.833_333_333_333_333_4), t385)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t377);
    let post_omega_dot_by_cylinder_y = (t20 * t386)
        .sub_product(t19, t387)
        .sub_product(t19, t385)
        .add_product(t20, t384)
        .sub_product(t21, t374);
    let post_v_y_dot_by_cylinder_y = (-(R::literal(-1.25) * t384))
        .sub_product(R::literal(1.25), t386);
    let post_v_x_dot_by_cylinder_y = (-(R::literal(-1.25) * t385))
        .sub_product(R::literal(1.25), t387);
    let t388 = R::literal(50.0)
        * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
            .sub_product(cylinder_omega, slide)
            .sub_product(rod_v_x_minus_cylinder_v_x, sin_cylinder_phi);
    let t389 = t388 * cos_cylinder_phi;
    let t390 = t388 * sin_cylinder_phi;
    let t391 = t14 * t14;
    let t392 = R::literal(0.06) * cylinder_omega_squared;
    let t393 = t389 + t314 - t172 - t171 - t318;
    let t394 = t167 + t390 - (-t169 - t354) - t358;
    let t395 = t12 - t13;
    let t396 = (p.spring_stiffness * slide * slide_minus_spring_free_length)
        .add_product(R::literal(50.0) * slide, slide_rate)
        .sub_product(t388, t14)
        .sub_product(p.spring_stiffness, t391)
        .sub_product(t4, t244)
        .sub_product(t5, t243)
        .sub_product(t395, t241);
    let t397 = t172 + t171 - t389 - t314 + t318;
    let t398 = t175 - t390 - (t169 + t354) + t358;
    let t399 = R::literal(3.333_333_333_333_333_5) * t393;
    let t400 = ((t392 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t399)
        .sub_product(t28, t396);
    let t401 = R::literal(3.333_333_333_333_333_5) * t394;
    let t402 = ((-(t392 * cos_cylinder_phi)).sub_product(t5, cylinder_omega_dot) - t401)
        .add_product(t29, t396)
        .sub_product(t89, t400);
    let t403 = (-(R::literal(-2_777.777_777_777_778) * t396))
        .add_product(t91, t400)
        .sub_product(t102, t402);
    let t404 = (cylinder_omega
        * (t189 * sin_cylinder_phi)
            .add_product(t194, cos_cylinder_phi)
            .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
            .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi)
            .sub_product(t190, cos_cylinder_phi)
            .sub_product(t193, sin_cylinder_phi)
            .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi))
        .sub_product(cos_cylinder_phi, cylinder_v_x_dot)
        .sub_product(sin_cylinder_phi, cylinder_v_y_dot)
        .sub_product(t395, cylinder_omega_dot)
        .add_product(cos_cylinder_phi, rod_v_x_dot)
        .add_product(sin_cylinder_phi, rod_v_y_dot)
        .sub_product(t26, t393)
        .add_product(t27, t394)
        .add_product(t30, t396)
        .add_product(t31, t397)
        .sub_product(t32, t398)
        .sub_product(t93, t400)
        .sub_product(t104, t402)
        .sub_product(t113, t403);
    let t405 = R::literal(5.0) * t397;
    let t406 = (-t405).sub_product(t114, t403).sub_product(t124, t404);
    let t407 = R::literal(5.0) * t398;
    let t408 = (-t407)
        .add_product(t115, t403)
        .sub_product(t126, t404)
        .sub_product(t135, t406);
    let t409 = (-(t95 * t400))
        .sub_product(t106, t402)
        .sub_product(t117, t403)
        .sub_product(t128, t404)
        .sub_product(t137, t406)
        .sub_product(t144, t408);
    let t410 = (-(t97 * t400))
        .sub_product(t108, t402)
        .sub_product(t119, t403)
        .sub_product(t130, t404)
        .sub_product(t139, t406)
        .sub_product(t146, t408)
        .sub_product(t151, t409);
    let t411 = (t152 * t409).sub_product(t157, t410);
    let t412 = (-(t99 * t400))
        .sub_product(t110, t402)
        .sub_product(t121, t403)
        .sub_product(t132, t404)
        .sub_product(t141, t406)
        .sub_product(t148, t408)
        .sub_product(t154, t409)
        .sub_product(t159, t410)
        .sub_product(t164, t411) * t165;
    let t413 = (t411 * t162).sub_product(t164, t412);
    let t414 = (t410 * t155).sub_product(t157, t413).sub_product(t159, t412);
    let t415 = (t409 * t149)
        .sub_product(t151, t414)
        .add_product(t152, t413)
        .sub_product(t154, t412);
    let t416 = (t408 * t142)
        .sub_product(t144, t415)
        .sub_product(t146, t414)
        .sub_product(t148, t412);
    let t417 = (t406 * t133)
        .sub_product(t135, t416)
        .sub_product(t137, t415)
        .sub_product(t139, t414)
        .sub_product(t141, t412);
    let t418 = (t404 * t122)
        .sub_product(t124, t417)
        .sub_product(t126, t416)
        .sub_product(t128, t415)
        .sub_product(t130, t414)
        .sub_product(t132, t412);
    let t419 = (t403 * t111)
        .sub_product(t113, t418)
        .sub_product(t114, t417)
        .add_product(t115, t416)
        .sub_product(t117, t415)
        .sub_product(t119, t414)
        .sub_product(t121, t412);
    let t420 = (t402 * t100)
        .sub_product(t102, t419)
        .sub_product(t104, t418)
        .sub_product(t106, t415)
        .sub_product(t108, t414)
        .sub_product(t110, t412);
    let t421 = (t400 * t87)
        .sub_product(t89, t420)
        .add_product(t91, t419)
        .sub_product(t93, t418)
        .sub_product(t95, t415)
        .sub_product(t97, t414)
        .sub_product(t99, t412);
    let t422 = (-(t78 * t420))
        .sub_product(t76, t421)
        .sub_product(t81, t415)
        .sub_product(t84, t414)
        .sub_product(t86, t412);
    let t423 = (-(t64 * t421))
        .sub_product(t62, t422)
        .sub_product(t65, t420)
        .sub_product(t68, t415)
        .add_product(t70, t414)
        .sub_product(t72, t412);
    let t424 = (-(t55 * t422)).sub_product(t53, t423).sub_product(t57, t412);
    let t425 = (-(t45 * t423))
        .sub_product(t43, t424)
        .sub_product(t43, t422)
        .add_product(t47, t412);
    let drum_v_y_dot_by_cylinder_phi = (t38 * t413)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t413);
    let drum_v_x_dot_by_cylinder_phi = (t37 * t413)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t413);
    let bobbin_v_y_dot_by_cylinder_phi = (-(t36 * t413))
        .sub_product(c.inverse_bobbin_mass, t414);
    let bobbin_v_x_dot_by_cylinder_phi = (-(t35 * t413))
        .sub_product(c.inverse_bobbin_mass, t415);
    let rod_omega_dot_by_cylinder_phi = (t33 * t417)
        .sub_product(R::literal(4_166.666_666_666_667), t419)
        .sub_product(t34, t416);
    let rod_v_y_dot_by_cylinder_phi = t407
        .sub_product(t32, t418)
        .sub_product(R::literal(5.0), t416);
    let rod_v_x_dot_by_cylinder_phi = t405
        .add_product(t31, t418)
        .sub_product(R::literal(5.0), t417);
    let cylinder_omega_dot_by_cylinder_phi = (t396 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t421)
        .add_product(t29, t420)
        .sub_product(R::literal(-2_777.777_777_777_778), t419)
        .add_product(t30, t418);
    let cylinder_v_y_dot_by_cylinder_phi = t401
        .sub_product(R::literal(3.333_333_333_333_333_5), t420)
        .add_product(t27, t418);
    let cylinder_v_x_dot_by_cylinder_phi = t399
        .sub_product(R::literal(3.333_333_333_333_333_5), t421)
        .sub_product(t26, t418);
    let plate_omega_dot_by_cylinder_phi = (t23 * t422)
        .sub_product(t22, t423)
        .sub_product(t22, t421)
        .add_product(t23, t420)
        .add_product(t24, t415)
        .sub_product(t25, t414);
    let plate_v_y_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t420))
        .sub_product(R::literal(0.833_333_333_333_333_4), t422)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t414);
    let plate_v_x_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t421))
        .sub_product(R::literal(0.833_333_333_333_333_4), t423)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t415);
    let post_omega_dot_by_cylinder_phi = (t20 * t424)
        .sub_product(t19, t425)
        .sub_product(t19, t423)
        .add_product(t20, t422)
        .sub_product(t21, t412);
    let post_v_y_dot_by_cylinder_phi = (-(R::literal(-1.25) * t422))
        .sub_product(R::literal(1.25), t424);
    let post_v_x_dot_by_cylinder_phi = (-(R::literal(-1.25) * t423))
        .sub_product(R::literal(1.25), t425);
    let t426 = t312 + t172 + t171 - t314 + t318;
    let t427 = R::literal(3.333_333_333_333_333_5) * t316;
    let t428 = (-t427).sub_product(t28, t426);
    let t429 = R::literal(3.333_333_333_333_333_5) * t317;
    let t430 = (-t429).add_product(t29, t426).sub_product(t89, t428);
    let t431 = (-(R::literal(-2_777.777_777_777_778) * t426))
        .add_product(t91, t428)
        .sub_product(t102, t430);
    let t432 = (t320 - t188)
        .sub_product(t26, t316)
        .add_product(t27, t317)
        .add_product(t30, t426)
        .add_product(t31, t309)
        .sub_product(t32, t310)
        .sub_product(t93, t428)
        .sub_product(t104, t430)
        .sub_product(t113, t431);
    let t433 = R::literal(5.0) * t309;
    let t434 = (-t433).sub_product(t114, t431).sub_product(t124, t432);
    let t435 = R::literal(5.0) * t310;
    let t436 = (-t435)
        .add_product(t115, t431)
        .sub_product(t126, t432)
        .sub_product(t135, t434);
    let t437 = (-(t95 * t428))
        .sub_product(t106, t430)
        .sub_product(t117, t431)
        .sub_product(t128, t432)
        .sub_product(t137, t434)
        .sub_product(t144, t436);
    let t438 = (-(t97 * t428))
        .sub_product(t108, t430)
        .sub_product(t119, t431)
        .sub_product(t130, t432)
        .sub_product(t139, t434)
        .sub_product(t146, t436)
        .sub_product(t151, t437);
    let t439 = (t152 * t437).sub_product(t157, t438);
    let t440 = (-(t99 * t428))
        .sub_product(t110, t430)
        .sub_product(t121, t431)
        .sub_product(t132, t432)
        .sub_product(t141, t434)
        .sub_product(t148, t436)
        .sub_product(t154, t437)
        .sub_product(t159, t438)
        .sub_product(t164, t439) * t165;
    let t441 = (t439 * t162).sub_product(t164, t440);
    let t442 = (t438 * t155).sub_product(t157, t441).sub_product(t159, t440);
    let t443 = (t437 * t149)
        .sub_product(t151, t442)
        .add_product(t152, t441)
        .sub_product(t154, t440);
    let t444 = (t436 * t142)
        .sub_product(t144, t443)
        .sub_product(t146, t442)
        .sub_product(t148, t440);
    let t445 = (t434 * t133)
        .sub_product(t135, t444)
        .sub_product(t137, t443)
        .sub_product(t139, t442)
        .sub_product(t141, t440);
    let t446 = (t432 * t122)
        .sub_product(t124, t445)
        .sub_product(t126, t444)
        .sub_product(t128, t443)
        .sub_product(t130, t442)
        .sub_product(t132, t440);
    let t447 = (t431 * t111)
        .sub_product(t113, t446)
        .sub_product(t114, t445)
        .add_product(t115, t444)
        .sub_product(t117, t443)
        .sub_product(t119, t442)
        .sub_product(t121, t440);
    let t448 = (t430 * t100)
        .sub_product(t102, t447)
        .sub_product(t104, t446)
        .sub_product(t106, t443)
        .sub_product(t108, t442)
        .sub_product(t110, t440);
    let t449 = (t428 * t87)
        .sub_product(t89, t448)
        .add_product(t91, t447)
        .sub_product(t93, t446)
        .sub_product(t95, t443)
        .sub_product(t97, t442)
        .sub_product(t99, t440);
    let t450 = (-(t78 * t448))
        .sub_product(t76, t449)
        .sub_product(t81, t443)
        .sub_product(t84, t442)
        .sub_product(t86, t440);
    let t451 = (-(t64 * t449))
        .sub_product(t62, t450)
        .sub_product(t65, t448)
        .sub_product(t68, t443)
        .add_product(t70, t442)
        .sub_product(t72, t440);
    let t452 = (-(t55 * t450)).sub_product(t53, t451).sub_product(t57, t440);
    let t453 = (-(t45 * t451))
        .sub_product(t43, t452)
        .sub_product(t43, t450)
        .add_product(t47, t440);
    let drum_v_y_dot_by_rod_x = (t38 * t441)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t441);
    let drum_v_x_dot_by_rod_x = (t37 * t441)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t441);
    let bobbin_v_y_dot_by_rod_x = (-(t36 * t441))
        .sub_product(c.inverse_bobbin_mass, t442);
    let bobbin_v_x_dot_by_rod_x = (-(t35 * t441))
        .sub_product(c.inverse_bobbin_mass, t443);
    let rod_omega_dot_by_rod_x = (t33 * t445)
        .sub_product(R::literal(4_166.666_666_666_667), t447)
        .sub_product(t34, t444);
    let rod_v_y_dot_by_rod_x = t435
        .sub_product(t32, t446)
        .sub_product(R::literal(5.0), t444);
    let rod_v_x_dot_by_rod_x = t433
        .add_product(t31, t446)
        .sub_product(R::literal(5.0), t445);
    let cylinder_omega_dot_by_rod_x = (t426 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t449)
        .add_product(t29, t448)
        .sub_product(R::literal(-2_777.777_777_777_778), t447)
        .add_product(t30, t446);
    let cylinder_v_y_dot_by_rod_x = t429
        .sub_product(R::literal(3.333_333_333_333_333_5), t448)
        .add_product(t27, t446);
    let cylinder_v_x_dot_by_rod_x = t427
        .sub_product(R::literal(3.333_333_333_333_333_5), t449)
        .sub_product(t26, t446);
    let plate_omega_dot_by_rod_x = (t23 * t450)
        .sub_product(t22, t451)
        .sub_product(t22, t449)
        .add_product(t23, t448)
        .add_product(t24, t443)
        .sub_product(t25, t442);
    let plate_v_y_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t448))
        .sub_product(R::literal(0.833_333_333_333_333_4), t450)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t442);
    let plate_v_x_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t449))
        .sub_product(R::literal(0.833_333_333_333_333_4), t451)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t443);
    let post_omega_dot_by_rod_x = (t20 * t452)
        .sub_product(t19, t453)
        .sub_product(t19, t451)
        .add_product(t20, t450)
        .sub_product(t21, t440);
    let post_v_y_dot_by_rod_x = (-(R::literal(-1.25) * t450))
        .sub_product(R::literal(1.25), t452);
    let post_v_x_dot_by_rod_x = (-(R::literal(-1.25) * t451))
        .sub_product(R::literal(1.25), t453);
    let t454 = -t353 - t167 - t169 - t354 + t358;
    let t455 = R::literal(3.333_333_333_333_333_5) * t356;
    let t456 = (-t455).sub_product(t28, t454);
    let t457 = R::literal(3.333_333_333_333_333_5) * t357;
    let t458 = (-t457).add_product(t29, t454).sub_product(t89, t456);
    let t459 = (-(R::literal(-2_777.777_777_777_778) * t454))
        .add_product(t91, t456)
        .sub_product(t102, t458);
    let t460 = (t187 + t360)
        .sub_product(t26, t356)
        .add_product(t27, t357)
        .add_product(t30, t454)
        .add_product(t31, t351)
        .sub_product(t32, t352)
        .sub_product(t93, t456)
        .sub_product(t104, t458)
        .sub_product(t113, t459);
    let t461 = R::literal(5.0) * t351;
    let t462 = (-t461).sub_product(t114, t459).sub_product(t124, t460);
    let t463 = R::literal(5.0) * t352;
    let t464 = (-t463)
        .add_product(t115, t459)
        .sub_product(t126, t460)
        .sub_product(t135, t462);
    let t465 = (-(t95 * t456))
        .sub_product(t106, t458)
        .sub_product(t117, t459)
        .sub_product(t128, t460)
        .sub_product(t137, t462)
        .sub_product(t144, t464);
    let t466 = (-(t97 * t456))
        .sub_product(t108, t458)
        .sub_product(t119, t459)
        .sub_product(t130, t460)
        .sub_product(t139, t462)
        .sub_product(t146, t464)
        .sub_product(t151, t465);
    let t467 = (t152 * t465).sub_product(t157, t466);
    let t468 = (-(t99 * t456))
        .sub_product(t110, t458)
        .sub_product(t121, t459)
        .sub_product(t132, t460)
        .sub_product(t141, t462)
        .sub_product(t148, t464)
        .sub_product(t154, t465)
        .sub_product(t159, t466)
        .sub_product(t164, t467) * t165;
    let t469 = (t467 * t162).sub_product(t164, t468);
    let t470 = (t466 * t155).sub_product(t157, t469).sub_product(t159, t468);
    let t471 = (t465 * t149)
        .sub_product(t151, t470)
        .add_product(t152, t469)
        .sub_product(t154, t468);
    let t472 = (t464 * t142)
        .sub_product(t144, t471)
        .sub_product(t146, t470)
        .sub_product(t148, t468);
    let t473 = (t462 * t133)
        .sub_product(t135, t472)
        .sub_product(t137, t471)
        .sub_product(t139, t470)
        .sub_product(t141, t468);
    let t474 = (t460 * t122)
        .sub_product(t124, t473)
        .sub_product(t126, t472)
        .sub_product(t128, t471)
        .sub_product(t130, t470)
        .sub_product(t132, t468);
    let t475 = (t459 * t111)
        .sub_product(t113, t474)
        .sub_product(t114, t473)
        .add_product(t115, t472)
        .sub_product(t117, t471)
        .sub_product(t119, t470)
        .sub_product(t121, t468);
    let t476 = (t458 * t100)
        .sub_product(t102, t475)
        .sub_product(t104, t474)
        .sub_product(t106, t471)
        .sub_product(t108, t470)
        .sub_product(t110, t468);
    let t477 = (t456 * t87)
        .sub_product(t89, t476)
        .add_product(t91, t475)
        .sub_product(t93, t474)
        .sub_product(t95, t471)
        .sub_product(t97, t470)
        .sub_product(t99, t468);
    let t478 = (-(t78 * t476))
        .sub_product(t76, t477)
        .sub_product(t81, t471)
        .sub_product(t84, t470)
        .sub_product(t86, t468);
    let t479 = (-(t64 * t477))
        .sub_product(t62, t478)
        .sub_product(t65, t476)
        .sub_product(t68, t471)
        .add_product(t70, t470)
        .sub_product(t72, t468);
    let t480 = (-(t55 * t478)).sub_product(t53, t479).sub_product(t57, t468);
    let t481 = (-(t45 * t479))
        .sub_product(t43, t480)
        .sub_product(t43, t478)
        .add_product(t47, t468);
    let drum_v_y_dot_by_rod_y = (t38 * t469)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t469);
    let drum_v_x_dot_by_rod_y = (t37 * t469)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t469);
    let bobbin_v_y_dot_by_rod_y = (-(t36 * t469))
        .sub_product(c.inverse_bobbin_mass, t470);
    let bobbin_v_x_dot_by_rod_y = (-(t35 * t469))
        .sub_product(c.inverse_bobbin_mass, t471);
    let rod_omega_dot_by_rod_y = (t33 * t473)
        .sub_product(R::literal(4_166.666_666_666_667), t475)
        .sub_product(t34, t472);
    let rod_v_y_dot_by_rod_y = t463
        .sub_product(t32, t474)
        .sub_product(R::literal(5.0), t472);
    let rod_v_x_dot_by_rod_y = t461
        .add_product(t31, t474)
        .sub_product(R::literal(5.0), t473);
    let cylinder_omega_dot_by_rod_y = (t454 * R::literal(2_777.777_777_777_778))
        .sub_product(t28, t477)
        .add_product(t29, t476)
        .sub_product(R::literal(-2_777.777_777_777_778), t475)
        .add_product(t30, t474);
    let cylinder_v_y_dot_by_rod_y = t457
        .sub_product(R::literal(3.333_333_333_333_333_5), t476)
        .add_product(t27, t474);
    let cylinder_v_x_dot_by_rod_y = t455
        .sub_product(R::literal(3.333_333_333_333_333_5), t477)
        .sub_product(t26, t474);
    let plate_omega_dot_by_rod_y = (t23 * t478)
        .sub_product(t22, t479)
        .sub_product(t22, t477)
        .add_product(t23, t476)
        .add_product(t24, t471)
        .sub_product(t25, t470);
    let plate_v_y_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t476))
        .sub_product(R::literal(0.833_333_333_333_333_4), t478)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t470);
    let plate_v_x_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t477))
        .sub_product(R::literal(0.833_333_333_333_333_4), t479)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t471);
    let post_omega_dot_by_rod_y = (t20 * t480)
        .sub_product(t19, t481)
        .sub_product(t19, t479)
        .add_product(t20, t478)
        .sub_product(t21, t468);
    let post_v_y_dot_by_rod_y = (-(R::literal(-1.25) * t478))
        .sub_product(R::literal(1.25), t480);
    let post_v_x_dot_by_rod_y = (-(R::literal(-1.25) * t479))
        .sub_product(R::literal(1.25), t481);
    let t482 = (t7 * t239).add_product(t6, t240);
    let t483 = R::literal(4_166.666_666_666_667) * t482;
    let t484 = t113 * t483;
    let t485 = (-t199)
        .add_product(t6, rod_omega_dot)
        .add_product(t33, t482)
        .add_product(t114, t483)
        .sub_product(t124, t484);
    let t486 = t198
        .add_product(t7, rod_omega_dot)
        .sub_product(t34, t482)
        .sub_product(t115, t483)
        .sub_product(t126, t484)
        .sub_product(t135, t485);
    let t487 = (t117 * t483)
        .sub_product(t128, t484)
        .sub_product(t137, t485)
        .sub_product(t144, t486);
    let t488 = (t119 * t483)
        .sub_product(t130, t484)
        .sub_product(t139, t485)
        .sub_product(t146, t486)
        .sub_product(t151, t487);
    let t489 = (t152 * t487).sub_product(t157, t488);
    let t490 = (t121 * t483)
        .sub_product(t132, t484)
        .sub_product(t141, t485)
        .sub_product(t148, t486)
        .sub_product(t154, t487)
        .sub_product(t159, t488)
        .sub_product(t164, t489) * t165;
    let t491 = (t489 * t162).sub_product(t164, t490);
    let t492 = (t488 * t155).sub_product(t157, t491).sub_product(t159, t490);
    let t493 = (t487 * t149)
        .sub_product(t151, t492)
        .add_product(t152, t491)
        .sub_product(t154, t490);
    let t494 = (t486 * t142)
        .sub_product(t144, t493)
        .sub_product(t146, t492)
        .sub_product(t148, t490);
    let t495 = (t485 * t133)
        .sub_product(t135, t494)
        .sub_product(t137, t493)
        .sub_product(t139, t492)
        .sub_product(t141, t490);
    let t496 = (t484 * t122)
        .sub_product(t124, t495)
        .sub_product(t126, t494)
        .sub_product(t128, t493)
        .sub_product(t130, t492)
        .sub_product(t132, t490);
    let t497 = (-(t483 * t111))
        .sub_product(t113, t496)
        .sub_product(t114, t495)
        .add_product(t115, t494)
        .sub_product(t117, t493)
        .sub_product(t119, t492)
        .sub_product(t121, t490);
    let t498 = (-(t104 * t496))
        .sub_product(t102, t497)
        .sub_product(t106, t493)
        .sub_product(t108, t492)
        .sub_product(t110, t490);
    let t499 = (t91 * t497)
        .sub_product(t89, t498)
        .sub_product(t93, t496)
        .sub_product(t95, t493)
        .sub_product(t97, t492)
        .sub_product(t99, t490);
    let t500 = (-(t78 * t498))
        .sub_product(t76, t499)
        .sub_product(t81, t493)
        .sub_product(t84, t492)
        .sub_product(t86, t490);
    let t501 = (-(t64 * t499))
        .sub_product(t62, t500)
        .sub_product(t65, t498)
        .sub_product(t68, t493)
        .add_product(t70, t492)
        .sub_product(t72, t490);
    let t502 = (-(t55 * t500)).sub_product(t53, t501).sub_product(t57, t490);
    let t503 = (-(t45 * t501))
        .sub_product(t43, t502)
        .sub_product(t43, t500)
        .add_product(t47, t490);
    let drum_v_y_dot_by_rod_phi = (t38 * t491)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t491);
    let drum_v_x_dot_by_rod_phi = (t37 * t491)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t491);
    let bobbin_v_y_dot_by_rod_phi = (-(t36 * t491))
        .sub_product(c.inverse_bobbin_mass, t492);
    let bobbin_v_x_dot_by_rod_phi = (-(t35 * t491))
        .sub_product(c.inverse_bobbin_mass, t493);
    let rod_omega_dot_by_rod_phi = t483
        .sub_product(R::literal(4_166.666_666_666_667), t497)
        .add_product(t33, t495)
        .sub_product(t34, t494);
    let rod_v_y_dot_by_rod_phi = (-(R::literal(5.0) * t494)).sub_product(t32, t496);
    let rod_v_x_dot_by_rod_phi = (-(R::literal(5.0) * t495)).add_product(t31, t496);
    let cylinder_omega_dot_by_rod_phi = (t29 * t498)
        .sub_product(t28, t499)
        .sub_product(R::literal(-2_777.777_777_777_778), t497)
        .add_product(t30, t496);
    let cylinder_v_y_dot_by_rod_phi = (t27 * t496)
        .sub_product(R::literal(3.333_333_333_333_333_5), t498);
    let cylinder_v_x_dot_by_rod_phi = (-(t26 * t496))
        .sub_product(R::literal(3.333_333_333_333_333_5), t499);
    let plate_omega_dot_by_rod_phi = (t23 * t500)
        .sub_product(t22, t501)
        .sub_product(t22, t499)
        .add_product(t23, t498)
        .add_product(t24, t493)
        .sub_product(t25, t492);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t498))
        .sub_product(R::literal(0.833_333_333_333_333_4), t500)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t492);
    let plate_v_x_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t499))
        .sub_product(R::literal(0.833_333_333_333_333_4), t501)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t493);
    let post_omega_dot_by_rod_phi = (t20 * t502)
        .sub_product(t19, t503)
        .sub_product(t19, t501)
        .add_product(t20, t500)
        .sub_product(t21, t490);
    let post_v_y_dot_by_rod_phi = (-(R::literal(-1.25) * t500))
        .sub_product(R::literal(1.25), t502);
    let post_v_x_dot_by_rod_phi = (-(R::literal(-1.25) * t501))
        .sub_product(R::literal(1.25), t503);
    let t504 = t179 * bobbin_y_minus_drum_y / between_squared_times_between;
    let t505 = p.winding_force * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let winding_force_over_between = p.winding_force / between;
    let t506 = R::literal(3.0) * bobbin_v_x;
    let t507 = t506 * bobbin_x_minus_drum_x;
    let t508 = t507 / between_squared_times_between;
    let t509 = between.powi(5);
    let t510 = bobbin_x_minus_drum_x_squared * bobbin_x_minus_drum_x;
    let t511 = R::literal(3.0) * drum_v_x;
    let t512 = t511 * t510 / t509;
    let t513 = R::literal(3.0) * drum_v_y;
    let t514 = t513 * bobbin_y_minus_drum_y;
    let t515 = t514 * bobbin_x_minus_drum_x_squared / t509;
    let t516 = bobbin_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t517 = t506 * t510 / t509;
    let t518 = R::literal(3.0) * bobbin_v_y;
    let t519 = t518 * bobbin_y_minus_drum_y;
    let t520 = t519 * bobbin_x_minus_drum_x_squared / t509;
    let t521 = t511 * bobbin_x_minus_drum_x;
    let t522 = t521 / between_squared_times_between;
    let t523 = drum_v_y * bobbin_y_minus_drum_y / between_squared_times_between;
    let t524 = t517 + t520 + t522 + t523 - t508 - t512 - t515 - t516;
    let t525 = t511 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t509;
    let t526 = t513 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t509;
    let t527 = bobbin_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t528 = t202 / between_squared_times_between;
    let t529 = t506 * bobbin_y_minus_drum_y * bobbin_x_minus_drum_x_squared / t509;
    let t530 = t518 * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y_squared / t509;
    let t531 = drum_v_x * bobbin_y_minus_drum_y / between_squared_times_between;
    let t532 = drum_v_y_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t533 = t529 + t530 + t531 + t532 - t525 - t526 - t527 - t528;
    let t534 = t508 + t512 + t515 + t516 - t517 - t520 - t522 - t523;
    let t535 = t525 + t526 + t527 + t528 - t529 - t530 - t531 - t532;
    let t536 = bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let inverse_between = R::literal(1.0) / between;
    let t537 = inverse_between - t536;
    let t538 = t537 * t236;
    let t539 = t504 - t538;
    let t540 = bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t541 = t540 * t236;
    let t542 = winding_force_over_between - t505 + t541;
    let t543 = t540 * bobbin_v_y_dot;
    let t544 = t536 - inverse_between;
    let t545 = t544 * t236;
    let t546 = t540 * drum_v_y_dot;
    let t547 = c.inverse_bobbin_mass * t539;
    let t548 = c.inverse_bobbin_mass * t542;
    let t549 = (-t548).add_product(t151, t547);
    let t550 = R::literal(0.666_666_666_666_666_6) * t545;
    let t551 = R::literal(0.666_666_666_666_666_6) * t541;
    let t552 = -t551;
    let t553 = t38 * t541;
    let t554 = t161 * t551;
    let t555 = ((((-(bobbin_v_x * t524)
        .add_product(bobbin_v_y, t533)
        .add_product(drum_v_x, t534)
        .add_product(drum_v_y, t535))
        .sub_product(t537, bobbin_v_x_dot) + t543)
        .sub_product(t544, drum_v_x_dot) - t546)
        .sub_product(t35, t539)
        .sub_product(t36, t542)
        .sub_product(t37, t545) - t553)
        .sub_product(t152, t547)
        .sub_product(t157, t549)
        .sub_product(t160, t550) - t554;
    let t556 = t551 * R::literal(-1.5);
    let t557 = (t154 * t547).sub_product(t159, t549).sub_product(t164, t555) * t165;
    let t558 = (t555 * t162).sub_product(t164, t557);
    let t559 = (t549 * t155).sub_product(t157, t558).sub_product(t159, t557);
    let t560 = (-(t547 * t149))
        .sub_product(t151, t559)
        .add_product(t152, t558)
        .sub_product(t154, t557);
    let t561 = (-(t146 * t559)).sub_product(t144, t560).sub_product(t148, t557);
    let t562 = (-(t137 * t560))
        .sub_product(t135, t561)
        .sub_product(t139, t559)
        .sub_product(t141, t557);
    let t563 = (-(t126 * t561))
        .sub_product(t124, t562)
        .sub_product(t128, t560)
        .sub_product(t130, t559)
        .sub_product(t132, t557);
    let t564 = (-(t114 * t562))
        .sub_product(t113, t563)
        .add_product(t115, t561)
        .sub_product(t117, t560)
        .sub_product(t119, t559)
        .sub_product(t121, t557);
    let t565 = (-(t104 * t563))
        .sub_product(t102, t564)
        .sub_product(t106, t560)
        .sub_product(t108, t559)
        .sub_product(t110, t557);
    let t566 = (t91 * t564)
        .sub_product(t89, t565)
        .sub_product(t93, t563)
        .sub_product(t95, t560)
        .sub_product(t97, t559)
        .sub_product(t99, t557);
    let t567 = (-(t78 * t565))
        .sub_product(t76, t566)
        .sub_product(t81, t560)
        .sub_product(t84, t559)
        .sub_product(t86, t557);
    let t568 = (-(t64 * t566))
        .sub_product(t62, t567)
        .sub_product(t65, t565)
        .sub_product(t68, t560)
        .add_product(t70, t559)
        .sub_product(t72, t557);
    let t569 = (-(t55 * t567)).sub_product(t53, t568).sub_product(t57, t557);
    let t570 = (-(t45 * t568))
        .sub_product(t43, t569)
        .sub_product(t43, t567)
        .add_product(t47, t557);
    let drum_v_y_dot_by_bobbin_x = t552
        .sub_product(R::literal(0.666_666_666_666_666_6), t556.sub_product(t161, t558))
        .add_product(t38, t558);
    let drum_v_x_dot_by_bobbin_x = (-t550)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            (t550 * R::literal(-1.5)).sub_product(t160, t558),
        )
        .add_product(t37, t558);
    let bobbin_v_y_dot_by_bobbin_x = t548
        .sub_product(c.inverse_bobbin_mass, t559)
        .sub_product(t36, t558);
    let bobbin_v_x_dot_by_bobbin_x = t547
        .sub_product(c.inverse_bobbin_mass, t560)
        .sub_product(t35, t558);
    let rod_omega_dot_by_bobbin_x = (t33 * t562)
        .sub_product(R::literal(4_166.666_666_666_667), t564)
        .sub_product(t34, t561);
    let rod_v_y_dot_by_bobbin_x = (-(R::literal(5.0) * t561)).sub_product(t32, t563);
    let rod_v_x_dot_by_bobbin_x = (-(R::literal(5.0) * t562)).add_product(t31, t563);
    let cylinder_omega_dot_by_bobbin_x = (t29 * t565)
        .sub_product(t28, t566)
        .sub_product(R::literal(-2_777.777_777_777_778), t564)
        .add_product(t30, t563);
    let cylinder_v_y_dot_by_bobbin_x = (t27 * t563)
        .sub_product(R::literal(3.333_333_333_333_333_5), t565);
    let cylinder_v_x_dot_by_bobbin_x = (-(t26 * t563))
        .sub_product(R::literal(3.333_333_333_333_333_5), t566);
    let plate_omega_dot_by_bobbin_x = (t23 * t567)
        .sub_product(t22, t568)
        .sub_product(t22, t566)
        .add_product(t23, t565)
        .add_product(t24, t560)
        .sub_product(t25, t559);
    let plate_v_y_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t565))
        .sub_product(R::literal(0.833_333_333_333_333_4), t567)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t559);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t566))
        .sub_product(R::literal(0.833_333_333_333_333_4), t568)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t560);
    let post_omega_dot_by_bobbin_x = (t20 * t569)
        .sub_product(t19, t570)
        .sub_product(t19, t568)
        .add_product(t20, t567)
        .sub_product(t21, t557);
    let post_v_y_dot_by_bobbin_x = (-(R::literal(-1.25) * t567))
        .sub_product(R::literal(1.25), t569);
    let post_v_x_dot_by_bobbin_x = (-(R::literal(-1.25) * t568))
        .sub_product(R::literal(1.25), t570);
    let t571 = p.winding_force * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let t572 = -t504;
    let t573 = t519 / between_squared_times_between;
    let t574 = t521 * bobbin_y_minus_drum_y_squared / t509;
    let t575 = bobbin_y_minus_drum_y_squared * bobbin_y_minus_drum_y;
    let t576 = t513 * t575 / t509;
    let t577 = t206 / between_squared_times_between;
    let t578 = t507 * bobbin_y_minus_drum_y_squared / t509;
    let t579 = t518 * t575 / t509;
    let t580 = t514 / between_squared_times_between;
    let t581 = drum_v_x_times_bobbin_x_minus_drum_x / between_squared_times_between;
    let t582 = t578 + t579 + t580 + t581 - t573 - t574 - t576 - t577;
    let t583 = t573 + t574 + t576 + t577 - t578 - t579 - t580 - t581;
    let t584 = t571 - winding_force_over_between + t541;
    let t585 = t540 * bobbin_v_x_dot;
    let t586 = bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t587 = inverse_between - t586;
    let t588 = t587 * t236;
    let t589 = t572 - t588;
    let t590 = t540 * drum_v_x_dot;
    let t591 = t586 - inverse_between;
    let t592 = t591 * t236;
    let t593 = c.inverse_bobbin_mass * t584;
    let t594 = c.inverse_bobbin_mass * t589;
    let t595 = (-t594).add_product(t151, t593);
    let t596 = R::literal(0.666_666_666_666_666_6) * t592;
    let t597 = t37 * t541;
    let t598 = t160 * t551;
    let t599 = ((((t585
        - (bobbin_v_x * t533)
            .add_product(bobbin_v_y, t582)
            .add_product(drum_v_x, t535)
            .add_product(drum_v_y, t583))
        .sub_product(t587, bobbin_v_y_dot) - t590)
        .sub_product(t591, drum_v_y_dot)
        .sub_product(t35, t584)
        .sub_product(t36, t589) - t597)
        .sub_product(t38, t592)
        .sub_product(t152, t593)
        .sub_product(t157, t595) - t598)
        .sub_product(t161, t596);
    let t600 = (t154 * t593).sub_product(t159, t595).sub_product(t164, t599) * t165;
    let t601 = (t599 * t162).sub_product(t164, t600);
    let t602 = (t595 * t155).sub_product(t157, t601).sub_product(t159, t600);
    let t603 = (-(t593 * t149))
        .sub_product(t151, t602)
        .add_product(t152, t601)
        .sub_product(t154, t600);
    let t604 = (-(t146 * t602)).sub_product(t144, t603).sub_product(t148, t600);
    let t605 = (-(t137 * t603))
        .sub_product(t135, t604)
        .sub_product(t139, t602)
        .sub_product(t141, t600);
    let t606 = (-(t126 * t604))
        .sub_product(t124, t605)
        .sub_product(t128, t603)
        .sub_product(t130, t602)
        .sub_product(t132, t600);
    let t607 = (-(t114 * t605))
        .sub_product(t113, t606)
        .add_product(t115, t604)
        .sub_product(t117, t603)
        .sub_product(t119, t602)
        .sub_product(t121, t600);
    let t608 = (-(t104 * t606))
        .sub_product(t102, t607)
        .sub_product(t106, t603)
        .sub_product(t108, t602)
        .sub_product(t110, t600);
    let t609 = (t91 * t607)
        .sub_product(t89, t608)
        .sub_product(t93, t606)
        .sub_product(t95, t603)
        .sub_product(t97, t602)
        .sub_product(t99, t600);
    let t610 = (-(t78 * t608))
        .sub_product(t76, t609)
        .sub_product(t81, t603)
        .sub_product(t84, t602)
        .sub_product(t86, t600);
    let t611 = (-(t64 * t609))
        .sub_product(t62, t610)
        .sub_product(t65, t608)
        .sub_product(t68, t603)
        .add_product(t70, t602)
        .sub_product(t72, t600);
    let t612 = (-(t55 * t610)).sub_product(t53, t611).sub_product(t57, t600);
    let t613 = (-(t45 * t611))
        .sub_product(t43, t612)
        .sub_product(t43, t610)
        .add_product(t47, t600);
    let drum_v_y_dot_by_bobbin_y = (-t596)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            (t596 * R::literal(-1.5)).sub_product(t161, t601),
        )
        .add_product(t38, t601);
    let drum_v_x_dot_by_bobbin_y = t552
        .sub_product(R::literal(0.666_666_666_666_666_6), t556.sub_product(t160, t601))
        .add_product(t37, t601);
    let bobbin_v_y_dot_by_bobbin_y = t594
        .sub_product(c.inverse_bobbin_mass, t602)
        .sub_product(t36, t601);
    let bobbin_v_x_dot_by_bobbin_y = t593
        .sub_product(c.inverse_bobbin_mass, t603)
        .sub_product(t35, t601);
    let rod_omega_dot_by_bobbin_y = (t33 * t605)
        .sub_product(R::literal(4_166.666_666_666_667), t607)
        .sub_product(t34, t604);
    let rod_v_y_dot_by_bobbin_y = (-(R::literal(5.0) * t604)).sub_product(t32, t606);
    let rod_v_x_dot_by_bobbin_y = (-(R::literal(5.0) * t605)).add_product(t31, t606);
    let cylinder_omega_dot_by_bobbin_y = (t29 * t608)
        .sub_product(t28, t609)
        .sub_product(R::literal(-2_777.777_777_777_778), t607)
        .add_product(t30, t606);
    let cylinder_v_y_dot_by_bobbin_y = (t27 * t606)
        .sub_product(R::literal(3.333_333_333_333_333_5), t608);
    let cylinder_v_x_dot_by_bobbin_y = (-(t26 * t606))
        .sub_product(R::literal(3.333_333_333_333_333_5), t609);
    let plate_omega_dot_by_bobbin_y = (t23 * t610)
        .sub_product(t22, t611)
        .sub_product(t22, t609)
        .add_product(t23, t608)
        .add_product(t24, t603)
        .sub_product(t25, t602);
    let plate_v_y_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t608))
        .sub_product(R::literal(0.833_333_333_333_333_4), t610)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t602);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t609))
        .sub_product(R::literal(0.833_333_333_333_333_4), t611)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t603);
    let post_omega_dot_by_bobbin_y = (t20 * t612)
        .sub_product(t19, t613)
        .sub_product(t19, t611)
        .add_product(t20, t610)
        .sub_product(t21, t600);
    let post_v_y_dot_by_bobbin_y = (-(R::literal(-1.25) * t610))
        .sub_product(R::literal(1.25), t612);
    let post_v_x_dot_by_bobbin_y = (-(R::literal(-1.25) * t611))
        .sub_product(R::literal(1.25), t613);
    let t614 = t572 - t545;
    let t615 = t505 - winding_force_over_between - t541;
    let t616 = c.inverse_bobbin_mass * t614;
    let t617 = c.inverse_bobbin_mass * t615;
    let t618 = (-t617).add_product(t151, t616);
    let t619 = R::literal(0.666_666_666_666_666_6) * t538;
    let t620 = ((((-(bobbin_v_y * t535)
        .add_product(bobbin_v_x, t534)
        .add_product(drum_v_x, t524)
        .add_product(drum_v_y, t533))
        .sub_product(t544, bobbin_v_x_dot) - t543)
        .sub_product(t537, drum_v_x_dot) + t546)
        .sub_product(t35, t614)
        .sub_product(t36, t615)
        .sub_product(t37, t538) + t553)
        .sub_product(t152, t616)
        .sub_product(t157, t618)
        .sub_product(t160, t619) + t554;
    let t621 = -t556;
    let t622 = (t154 * t616).sub_product(t159, t618).sub_product(t164, t620) * t165;
    let t623 = (t620 * t162).sub_product(t164, t622);
    let t624 = (t618 * t155).sub_product(t157, t623).sub_product(t159, t622);
    let t625 = (-(t616 * t149))
        .sub_product(t151, t624)
        .add_product(t152, t623)
        .sub_product(t154, t622);
    let t626 = (-(t146 * t624)).sub_product(t144, t625).sub_product(t148, t622);
    let t627 = (-(t137 * t625))
        .sub_product(t135, t626)
        .sub_product(t139, t624)
        .sub_product(t141, t622);
    let t628 = (-(t126 * t626))
        .sub_product(t124, t627)
        .sub_product(t128, t625)
        .sub_product(t130, t624)
        .sub_product(t132, t622);
    let t629 = (-(t114 * t627))
        .sub_product(t113, t628)
        .add_product(t115, t626)
        .sub_product(t117, t625)
        .sub_product(t119, t624)
        .sub_product(t121, t622);
    let t630 = (-(t104 * t628))
        .sub_product(t102, t629)
        .sub_product(t106, t625)
        .sub_product(t108, t624)
        .sub_product(t110, t622);
    let t631 = (t91 * t629)
        .sub_product(t89, t630)
        .sub_product(t93, t628)
        .sub_product(t95, t625)
        .sub_product(t97, t624)
        .sub_product(t99, t622);
    let t632 = (-(t78 * t630))
        .sub_product(t76, t631)
        .sub_product(t81, t625)
        .sub_product(t84, t624)
        .sub_product(t86, t622);
    let t633 = (-(t64 * t631))
        .sub_product(t62, t632)
        .sub_product(t65, t630)
        .sub_product(t68, t625)
        .add_product(t70, t624)
        .sub_product(t72, t622);
    let t634 = (-(t55 * t632)).sub_product(t53, t633).sub_product(t57, t622);
    let t635 = (-(t45 * t633))
        .sub_product(t43, t634)
        .sub_product(t43, t632)
        .add_product(t47, t622);
    let drum_v_y_dot_by_drum_x = t551
        .sub_product(R::literal(0.666_666_666_666_666_6), t621.sub_product(t161, t623))
        .add_product(t38, t623);
    let drum_v_x_dot_by_drum_x = (-t619)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            (t619 * R::literal(-1.5)).sub_product(t160, t623),
        )
        .add_product(t37, t623);
    let bobbin_v_y_dot_by_drum_x = t617
        .sub_product(c.inverse_bobbin_mass, t624)
        .sub_product(t36, t623);
    let bobbin_v_x_dot_by_drum_x = t616
        .sub_product(c.inverse_bobbin_mass, t625)
        .sub_product(t35, t623);
    let rod_omega_dot_by_drum_x = (t33 * t627)
        .sub_product(R::literal(4_166.666_666_666_667), t629)
        .sub_product(t34, t626);
    let rod_v_y_dot_by_drum_x = (-(R::literal(5.0) * t626)).sub_product(t32, t628);
    let rod_v_x_dot_by_drum_x = (-(R::literal(5.0) * t627)).add_product(t31, t628);
    let cylinder_omega_dot_by_drum_x = (t29 * t630)
        .sub_product(t28, t631)
        .sub_product(R::literal(-2_777.777_777_777_778), t629)
        .add_product(t30, t628);
    let cylinder_v_y_dot_by_drum_x = (t27 * t628)
        .sub_product(R::literal(3.333_333_333_333_333_5), t630);
    let cylinder_v_x_dot_by_drum_x = (-(t26 * t628))
        .sub_product(R::literal(3.333_333_333_333_333_5), t631);
    let plate_omega_dot_by_drum_x = (t23 * t632)
        .sub_product(t22, t633)
        .sub_product(t22, t631)
        .add_product(t23, t630)
        .add_product(t24, t625)
        .sub_product(t25, t624);
    let plate_v_y_dot_by_drum_x = (-(R::literal(-0.833_333_333_333_333_4) * t630))
        .sub_product(R::literal(0.833_333_333_333_333_4), t632)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t624);
    let plate_v_x_dot_by_drum_x = (-(R::literal(-0.833_333_333_333_333_4) * t631))
        .sub_product(R::literal(0.833_333_333_333_333_4), t633)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t625);
    let post_omega_dot_by_drum_x = (t20 * t634)
        .sub_product(t19, t635)
        .sub_product(t19, t633)
        .add_product(t20, t632)
        .sub_product(t21, t622);
    let post_v_y_dot_by_drum_x = (-(R::literal(-1.25) * t632))
        .sub_product(R::literal(1.25), t634);
    let post_v_x_dot_by_drum_x = (-(R::literal(-1.25) * t633))
        .sub_product(R::literal(1.25), t635);
    let t636 = winding_force_over_between - t571 - t541;
    let t637 = t504 - t592;
    let t638 = c.inverse_bobbin_mass * t636;
    let t639 = c.inverse_bobbin_mass * t637;
    let t640 = (-t639).add_product(t151, t638);
    let t641 = R::literal(0.666_666_666_666_666_6) * t588;
    let t642 = ((((-(bobbin_v_x * t535)
        .add_product(bobbin_v_y, t583)
        .add_product(drum_v_x, t533)
        .add_product(drum_v_y, t582) - t585)
        .sub_product(t591, bobbin_v_y_dot) + t590)
        .sub_product(t587, drum_v_y_dot)
        .sub_product(t35, t636)
        .sub_product(t36, t637) + t597)
        .sub_product(t38, t588)
        .sub_product(t152, t638)
        .sub_product(t157, t640) + t598)
        .sub_product(t161, t641);
    let t643 = (t154 * t638).sub_product(t159, t640).sub_product(t164, t642) * t165;
    let t644 = (t642 * t162).sub_product(t164, t643);
    let t645 = (t640 * t155).sub_product(t157, t644).sub_product(t159, t643);
    let t646 = (-(t638 * t149))
        .sub_product(t151, t645)
        .add_product(t152, t644)
        .sub_product(t154, t643);
    let t647 = (-(t146 * t645)).sub_product(t144, t646).sub_product(t148, t643);
    let t648 = (-(t137 * t646))
        .sub_product(t135, t647)
        .sub_product(t139, t645)
        .sub_product(t141, t643);
    let t649 = (-(t126 * t647))
        .sub_product(t124, t648)
        .sub_product(t128, t646)
        .sub_product(t130, t645)
        .sub_product(t132, t643);
    let t650 = (-(t114 * t648))
        .sub_product(t113, t649)
        .add_product(t115, t647)
        .sub_product(t117, t646)
        .sub_product(t119, t645)
        .sub_product(t121, t643);
    let t651 = (-(t104 * t649))
        .sub_product(t102, t650)
        .sub_product(t106, t646)
        .sub_product(t108, t645)
        .sub_product(t110, t643);
    let t652 = (t91 * t650)
        .sub_product(t89, t651)
        .sub_product(t93, t649)
        .sub_product(t95, t646)
        .sub_product(t97, t645)
        .sub_product(t99, t643);
    let t653 = (-(t78 * t651))
        .sub_product(t76, t652)
        .sub_product(t81, t646)
        .sub_product(t84, t645)
        .sub_product(t86, t643);
    let t654 = (-(t64 * t652))
        .sub_product(t62, t653)
        .sub_product(t65, t651)
        .sub_product(t68, t646)
        .add_product(t70, t645)
        .sub_product(t72, t643);
    let t655 = (-(t55 * t653)).sub_product(t53, t654).sub_product(t57, t643);
    let t656 = (-(t45 * t654))
        .sub_product(t43, t655)
        .sub_product(t43, t653)
        .add_product(t47, t643);
    let drum_v_y_dot_by_drum_y = (-t641)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            (t641 * R::literal(-1.5)).sub_product(t161, t644),
        )
        .add_product(t38, t644);
    let drum_v_x_dot_by_drum_y = t551
        .sub_product(R::literal(0.666_666_666_666_666_6), t621.sub_product(t160, t644))
        .add_product(t37, t644);
    let bobbin_v_y_dot_by_drum_y = t639
        .sub_product(c.inverse_bobbin_mass, t645)
        .sub_product(t36, t644);
    let bobbin_v_x_dot_by_drum_y = t638
        .sub_product(c.inverse_bobbin_mass, t646)
        .sub_product(t35, t644);
    let rod_omega_dot_by_drum_y = (t33 * t648)
        .sub_product(R::literal(4_166.666_666_666_667), t650)
        .sub_product(t34, t647);
    let rod_v_y_dot_by_drum_y = (-(R::literal(5.0) * t647)).sub_product(t32, t649);
    let rod_v_x_dot_by_drum_y = (-(R::literal(5.0) * t648)).add_product(t31, t649);
    let cylinder_omega_dot_by_drum_y = (t29 * t651)
        .sub_product(t28, t652)
        .sub_product(R::literal(-2_777.777_777_777_778), t650)
        .add_product(t30, t649);
    let cylinder_v_y_dot_by_drum_y = (t27 * t649)
        .sub_product(R::literal(3.333_333_333_333_333_5), t651);
    let cylinder_v_x_dot_by_drum_y = (-(t26 * t649))
        .sub_product(R::literal(3.333_333_333_333_333_5), t652);
    let plate_omega_dot_by_drum_y = (t23 * t653)
        .sub_product(t22, t654)
        .sub_product(t22, t652)
        .add_product(t23, t651)
        .add_product(t24, t646)
        .sub_product(t25, t645);
    let plate_v_y_dot_by_drum_y = (-(R::literal(-0.833_333_333_333_333_4) * t651))
        .sub_product(R::literal(0.833_333_333_333_333_4), t653)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t645);
    let plate_v_x_dot_by_drum_y = (-(R::literal(-0.833_333_333_333_333_4) * t652))
        .sub_product(R::literal(0.833_333_333_333_333_4), t654)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t646);
    let post_omega_dot_by_drum_y = (t20 * t655)
        .sub_product(t19, t656)
        .sub_product(t19, t654)
        .add_product(t20, t653)
        .sub_product(t21, t643);
    let post_v_y_dot_by_drum_y = (-(R::literal(-1.25) * t653))
        .sub_product(R::literal(1.25), t655);
    let post_v_x_dot_by_drum_y = (-(R::literal(-1.25) * t654))
        .sub_product(R::literal(1.25), t656);
    let t657 = R::literal(0.2) * post_omega;
    let t658 = t657 * cos_post_phi;
    let t659 = (-(t657 * sin_post_phi)).add_product(t43, t658);
    let t660 = (-t658).add_product(t45, t658).sub_product(t53, t659);
    let t661 = t659.sub_product(t55, t659).sub_product(t62, t660);
    let t662 = (-(t64 * t660)).sub_product(t76, t661);
    let t663 = (-(t65 * t660)).sub_product(t78, t661).sub_product(t89, t662);
    let t664 = (t91 * t662).sub_product(t102, t663);
    let t665 = (-(t93 * t662)).sub_product(t104, t663).sub_product(t113, t664);
    let t666 = (-(t114 * t664)).sub_product(t124, t665);
    let t667 = (t115 * t664).sub_product(t126, t665).sub_product(t135, t666);
    let t668 = (-(t68 * t660))
        .sub_product(t81, t661)
        .sub_product(t95, t662)
        .sub_product(t106, t663)
        .sub_product(t117, t664)
        .sub_product(t128, t665)
        .sub_product(t137, t666)
        .sub_product(t144, t667);
    let t669 = (t70 * t660)
        .sub_product(t84, t661)
        .sub_product(t97, t662)
        .sub_product(t108, t663)
        .sub_product(t119, t664)
        .sub_product(t130, t665)
        .sub_product(t139, t666)
        .sub_product(t146, t667)
        .sub_product(t151, t668);
    let t670 = (t152 * t668).sub_product(t157, t669);
    let t671 = (post_omega
        * (R::literal(0.286) * sin_post_phi)
            .sub_product(R::literal(0.088), cos_post_phi))
        .sub_product(t47, t658)
        .sub_product(t57, t659)
        .sub_product(t72, t660)
        .sub_product(t86, t661)
        .sub_product(t99, t662)
        .sub_product(t110, t663)
        .sub_product(t121, t664)
        .sub_product(t132, t665)
        .sub_product(t141, t666)
        .sub_product(t148, t667)
        .sub_product(t154, t668)
        .sub_product(t159, t669)
        .sub_product(t164, t670) * t165;
    let t672 = (t670 * t162).sub_product(t164, t671);
    let t673 = (t669 * t155).sub_product(t157, t672).sub_product(t159, t671);
    let t674 = (t668 * t149)
        .sub_product(t151, t673)
        .add_product(t152, t672)
        .sub_product(t154, t671);
    let t675 = (t667 * t142)
        .sub_product(t144, t674)
        .sub_product(t146, t673)
        .sub_product(t148, t671);
    let t676 = (t666 * t133)
        .sub_product(t135, t675)
        .sub_product(t137, t674)
        .sub_product(t139, t673)
        .sub_product(t141, t671);
    let t677 = (t665 * t122)
        .sub_product(t124, t676)
        .sub_product(t126, t675)
        .sub_product(t128, t674)
        .sub_product(t130, t673)
        .sub_product(t132, t671);
    let t678 = (t664 * t111)
        .sub_product(t113, t677)
        .sub_product(t114, t676)
        .add_product(t115, t675)
        .sub_product(t117, t674)
        .sub_product(t119, t673)
        .sub_product(t121, t671);
    let t679 = (t663 * t100)
        .sub_product(t102, t678)
        .sub_product(t104, t677)
        .sub_product(t106, t674)
        .sub_product(t108, t673)
        .sub_product(t110, t671);
    let t680 = (t662 * t87)
        .sub_product(t89, t679)
        .add_product(t91, t678)
        .sub_product(t93, t677)
        .sub_product(t95, t674)
        .sub_product(t97, t673)
        .sub_product(t99, t671);
    let t681 = (t661 * t74)
        .sub_product(t76, t680)
        .sub_product(t78, t679)
        .sub_product(t81, t674)
        .sub_product(t84, t673)
        .sub_product(t86, t671);
    let t682 = (t660 * t59)
        .sub_product(t62, t681)
        .sub_product(t64, t680)
        .sub_product(t65, t679)
        .sub_product(t68, t674)
        .add_product(t70, t673)
        .sub_product(t72, t671);
    let t683 = (t659 * t51)
        .sub_product(t53, t682)
        .sub_product(t55, t681)
        .sub_product(t57, t671);
    let t684 = (-(t658 * t41))
        .sub_product(t43, t683)
        .sub_product(t45, t682)
        .sub_product(t43, t681)
        .add_product(t47, t671);
    let drum_v_y_dot_by_post_omega = (t38 * t672)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t672);
    let drum_v_x_dot_by_post_omega = (t37 * t672)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t672);
    let bobbin_v_y_dot_by_post_omega = (-(t36 * t672))
        .sub_product(c.inverse_bobbin_mass, t673);
    let bobbin_v_x_dot_by_post_omega = (-(t35 * t672))
        .sub_product(c.inverse_bobbin_mass, t674);
    let rod_omega_dot_by_post_omega = (t33 * t676)
        .sub_product(R::literal(4_166.666_666_666_667), t678)
        .sub_product(t34, t675);
    let rod_v_y_dot_by_post_omega = (-(R::literal(5.0) * t675)).sub_product(t32, t677);
    let rod_v_x_dot_by_post_omega = (-(R::literal(5.0) * t676)).add_product(t31, t677);
    let cylinder_omega_dot_by_post_omega = (t29 * t679)
        .sub_product(t28, t680)
        .sub_product(R::literal(-2_777.777_777_777_778), t678)
        .add_product(t30, t677);
    let cylinder_v_y_dot_by_post_omega = (t27 * t677)
        .sub_product(R::literal(3.333_333_333_333_333_5), t679);
    let cylinder_v_x_dot_by_post_omega = (-(t26 * t677))
        .sub_product(R::literal(3.333_333_333_333_333_5), t680);
    let plate_omega_dot_by_post_omega = (t23 * t681)
        .sub_product(t22, t682)
        .sub_product(t22, t680)
        .add_product(t23, t679)
        .add_product(t24, t674)
        .sub_product(t25, t673);
    let plate_v_y_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t679))
        .sub_product(R::literal(0.833_333_333_333_333_4), t681)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t673);
    let plate_v_x_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t680))
        .sub_product(R::literal(0.833_333_333_333_333_4), t682)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t674);
    let post_omega_dot_by_post_omega = (t20 * t683)
        .sub_product(t19, t684)
        .sub_product(t19, t682)
        .add_product(t20, t681)
        .sub_product(t21, t671);
    let post_v_y_dot_by_post_omega = (-(R::literal(-1.25) * t681))
        .sub_product(R::literal(1.25), t683);
    let post_v_x_dot_by_post_omega = (-(R::literal(-1.25) * t682))
        .sub_product(R::literal(1.25), t684);
    let t685 = R::literal(0.12) * plate_omega;
    let t686 = t685 * cos_plate_phi;
    let t687 = t685 * sin_plate_phi;
    let t688 = (-t687).add_product(t62, t686);
    let t689 = (-t686).add_product(t64, t686).sub_product(t76, t688);
    let t690 = (-t687)
        .add_product(t65, t686)
        .sub_product(t78, t688)
        .sub_product(t89, t689);
    let t691 = (t91 * t689).sub_product(t102, t690);
    let t692 = (-(t93 * t689)).sub_product(t104, t690).sub_product(t113, t691);
    let t693 = (-(t114 * t691)).sub_product(t124, t692);
    let t694 = (t115 * t691).sub_product(t126, t692).sub_product(t135, t693);
    let t695 = (plate_omega
        * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2), sin_plate_phi))
        .add_product(t68, t686)
        .sub_product(t81, t688)
        .sub_product(t95, t689)
        .sub_product(t106, t690)
        .sub_product(t117, t691)
        .sub_product(t128, t692)
        .sub_product(t137, t693)
        .sub_product(t144, t694);
    let t696 = (plate_omega
        * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2), cos_plate_phi))
        .sub_product(t70, t686)
        .sub_product(t84, t688)
        .sub_product(t97, t689)
        .sub_product(t108, t690)
        .sub_product(t119, t691)
        .sub_product(t130, t692)
        .sub_product(t139, t693)
        .sub_product(t146, t694)
        .sub_product(t151, t695);
    let t697 = (t152 * t695).sub_product(t157, t696);
    let t698 = (t72 * t686)
        .sub_product(t86, t688)
        .sub_product(t99, t689)
        .sub_product(t110, t690)
        .sub_product(t121, t691)
        .sub_product(t132, t692)
        .sub_product(t141, t693)
        .sub_product(t148, t694)
        .sub_product(t154, t695)
        .sub_product(t159, t696)
        .sub_product(t164, t697) * t165;
    let t699 = (t697 * t162).sub_product(t164, t698);
    let t700 = (t696 * t155).sub_product(t157, t699).sub_product(t159, t698);
    let t701 = (t695 * t149)
        .sub_product(t151, t700)
        .add_product(t152, t699)
        .sub_product(t154, t698);
    let t702 = (t694 * t142)
        .sub_product(t144, t701)
        .sub_product(t146, t700)
        .sub_product(t148, t698);
    let t703 = (t693 * t133)
        .sub_product(t135, t702)
        .sub_product(t137, t701)
        .sub_product(t139, t700)
        .sub_product(t141, t698);
    let t704 = (t692 * t122)
        .sub_product(t124, t703)
        .sub_product(t126, t702)
        .sub_product(t128, t701)
        .sub_product(t130, t700)
        .sub_product(t132, t698);
    let t705 = (t691 * t111)
        .sub_product(t113, t704)
        .sub_product(t114, t703)
        .add_product(t115, t702)
        .sub_product(t117, t701)
        .sub_product(t119, t700)
        .sub_product(t121, t698);
    let t706 = (t690 * t100)
        .sub_product(t102, t705)
        .sub_product(t104, t704)
        .sub_product(t106, t701)
        .sub_product(t108, t700)
        .sub_product(t110, t698);
    let t707 = (t689 * t87)
        .sub_product(t89, t706)
        .add_product(t91, t705)
        .sub_product(t93, t704)
        .sub_product(t95, t701)
        .sub_product(t97, t700)
        .sub_product(t99, t698);
    let t708 = (t688 * t74)
        .sub_product(t76, t707)
        .sub_product(t78, t706)
        .sub_product(t81, t701)
        .sub_product(t84, t700)
        .sub_product(t86, t698);
    let t709 = (-(t686 * t59))
        .sub_product(t62, t708)
        .sub_product(t64, t707)
        .sub_product(t65, t706)
        .sub_product(t68, t701)
        .add_product(t70, t700)
        .sub_product(t72, t698);
    let t710 = (-(t55 * t708)).sub_product(t53, t709).sub_product(t57, t698);
    let t711 = (-(t45 * t709))
        .sub_product(t43, t710)
        .sub_product(t43, t708)
        .add_product(t47, t698);
    let drum_v_y_dot_by_plate_omega = (t38 * t699)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t699);
    let drum_v_x_dot_by_plate_omega = (t37 * t699)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t699);
    let bobbin_v_y_dot_by_plate_omega = (-(t36 * t699))
        .sub_product(c.inverse_bobbin_mass, t700);
    let bobbin_v_x_dot_by_plate_omega = (-(t35 * t699))
        .sub_product(c.inverse_bobbin_mass, t701);
    let rod_omega_dot_by_plate_omega = (t33 * t703)
        .sub_product(R::literal(4_166.666_666_666_667), t705)
        .sub_product(t34, t702);
    let rod_v_y_dot_by_plate_omega = (-(R::literal(5.0) * t702)).sub_product(t32, t704);
    let rod_v_x_dot_by_plate_omega = (-(R::literal(5.0) * t703)).add_product(t31, t704);
    let cylinder_omega_dot_by_plate_omega = (t29 * t706)
        .sub_product(t28, t707)
        .sub_product(R::literal(-2_777.777_777_777_778), t705)
        .add_product(t30, t704);
    let cylinder_v_y_dot_by_plate_omega = (t27 * t704)
        .sub_product(R::literal(3.333_333_333_333_333_5), t706);
    let cylinder_v_x_dot_by_plate_omega = (-(t26 * t704))
        .sub_product(R::literal(3.333_333_333_333_333_5), t707);
    let plate_omega_dot_by_plate_omega = (t23 * t708)
        .sub_product(t22, t709)
        .sub_product(t22, t707)
        .add_product(t23, t706)
        .add_product(t24, t701)
        .sub_product(t25, t700);
    let plate_v_y_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t706))
        .sub_product(R::literal(0.833_333_333_333_333_4), t708)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t700);
    let plate_v_x_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t707))
        .sub_product(R::literal(0.833_333_333_333_333_4), t709)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t701);
    let post_omega_dot_by_plate_omega = (t20 * t710)
        .sub_product(t19, t711)
        .sub_product(t19, t709)
        .add_product(t20, t708)
        .sub_product(t21, t698);
    let post_v_y_dot_by_plate_omega = (-(R::literal(-1.25) * t708))
        .sub_product(R::literal(1.25), t710);
    let post_v_x_dot_by_plate_omega = (-(R::literal(-1.25) * t709))
        .sub_product(R::literal(1.25), t711);
    let t712 = R::literal(50.0) * (cos_cylinder_phi * cos_cylinder_phi);
    let t713 = R::literal(50.0) * sin_cylinder_phi * cos_cylinder_phi;
    let t714 = R::literal(50.0) * t14;
    let t715 = t714 * cos_cylinder_phi;
    let t716 = R::literal(2.0) * cylinder_omega;
    let t717 = t716 * cos_cylinder_phi;
    let t718 = R::literal(3.333_333_333_333_333_5) * t712;
    let t719 = t28 * t715;
    let t720 = t718 - t719;
    let t721 = R::literal(3.333_333_333_333_333_5) * t713;
    let t722 = -t721;
    let t723 = t29 * t715;
    let t724 = (t721 + t723).sub_product(t89, t720);
    let t725 = R::literal(-2_777.777_777_777_778) * t715;
    let t726 = (-t725).add_product(t91, t720).sub_product(t102, t724);
    let t727 = t26 * t712;
    let t728 = t27 * t713;
    let t729 = t30 * t715;
    let t730 = t31 * t712;
    let t731 = t32 * t713;
    let t732 = (t727 - t717 - t728 + t729 + t730 - t731)
        .sub_product(t93, t720)
        .sub_product(t104, t724)
        .sub_product(t113, t726);
    let t733 = R::literal(5.0) * t712;
    let t734 = (-t733).sub_product(t114, t726).sub_product(t124, t732);
    let t735 = R::literal(5.0) * t713;
    let t736 = -t735;
    let t737 = (-t735)
        .add_product(t115, t726)
        .sub_product(t126, t732)
        .sub_product(t135, t734);
    let t738 = (-(t95 * t720))
        .sub_product(t106, t724)
        .sub_product(t117, t726)
        .sub_product(t128, t732)
        .sub_product(t137, t734)
        .sub_product(t144, t737);
    let t739 = (-(t97 * t720))
        .sub_product(t108, t724)
        .sub_product(t119, t726)
        .sub_product(t130, t732)
        .sub_product(t139, t734)
        .sub_product(t146, t737)
        .sub_product(t151, t738);
    let t740 = (t152 * t738).sub_product(t157, t739);
    let t741 = t715 * R::literal(2_777.777_777_777_778);
    let t742 = (-(t99 * t720))
        .sub_product(t110, t724)
        .sub_product(t121, t726)
        .sub_product(t132, t732)
        .sub_product(t141, t734)
        .sub_product(t148, t737)
        .sub_product(t154, t738)
        .sub_product(t159, t739)
        .sub_product(t164, t740) * t165;
    let t743 = (t740 * t162).sub_product(t164, t742);
    let t744 = (t739 * t155).sub_product(t157, t743).sub_product(t159, t742);
    let t745 = (t738 * t149)
        .sub_product(t151, t744)
        .add_product(t152, t743)
        .sub_product(t154, t742);
    let t746 = (t737 * t142)
        .sub_product(t144, t745)
        .sub_product(t146, t744)
        .sub_product(t148, t742);
    let t747 = (t734 * t133)
        .sub_product(t135, t746)
        .sub_product(t137, t745)
        .sub_product(t139, t744)
        .sub_product(t141, t742);
    let t748 = (t732 * t122)
        .sub_product(t124, t747)
        .sub_product(t126, t746)
        .sub_product(t128, t745)
        .sub_product(t130, t744)
        .sub_product(t132, t742);
    let t749 = (t726 * t111)
        .sub_product(t113, t748)
        .sub_product(t114, t747)
        .add_product(t115, t746)
        .sub_product(t117, t745)
        .sub_product(t119, t744)
        .sub_product(t121, t742);
    let t750 = (t724 * t100)
        .sub_product(t102, t749)
        .sub_product(t104, t748)
        .sub_product(t106, t745)
        .sub_product(t108, t744)
        .sub_product(t110, t742);
    let t751 = (t720 * t87)
        .sub_product(t89, t750)
        .add_product(t91, t749)
        .sub_product(t93, t748)
        .sub_product(t95, t745)
        .sub_product(t97, t744)
        .sub_product(t99, t742);
    let t752 = (-(t78 * t750))
        .sub_product(t76, t751)
        .sub_product(t81, t745)
        .sub_product(t84, t744)
        .sub_product(t86, t742);
    let t753 = (-(t64 * t751))
        .sub_product(t62, t752)
        .sub_product(t65, t750)
        .sub_product(t68, t745)
        .add_product(t70, t744)
        .sub_product(t72, t742);
    let t754 = (-(t55 * t752)).sub_product(t53, t753).sub_product(t57, t742);
    let t755 = (-(t45 * t753))
        .sub_product(t43, t754)
        .sub_product(t43, t752)
        .add_product(t47, t742);
    let drum_v_y_dot_by_cylinder_v_x = (t38 * t743)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t743);
    let drum_v_x_dot_by_cylinder_v_x = (t37 * t743)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t743);
    let bobbin_v_y_dot_by_cylinder_v_x = (-(t36 * t743))
        .sub_product(c.inverse_bobbin_mass, t744);
    let bobbin_v_x_dot_by_cylinder_v_x = (-(t35 * t743))
        .sub_product(c.inverse_bobbin_mass, t745);
    let rod_omega_dot_by_cylinder_v_x = (t33 * t747)
        .sub_product(R::literal(4_166.666_666_666_667), t749)
        .sub_product(t34, t746);
    let rod_v_y_dot_by_cylinder_v_x = t735
        .sub_product(t32, t748)
        .sub_product(R::literal(5.0), t746);
    let rod_v_x_dot_by_cylinder_v_x = t733
        .add_product(t31, t748)
        .sub_product(R::literal(5.0), t747);
    let cylinder_omega_dot_by_cylinder_v_x = t741
        .sub_product(t28, t751)
        .add_product(t29, t750)
        .sub_product(R::literal(-2_777.777_777_777_778), t749)
        .add_product(t30, t748);
    let cylinder_v_y_dot_by_cylinder_v_x = t722
        .sub_product(R::literal(3.333_333_333_333_333_5), t750)
        .add_product(t27, t748);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t718)
        .sub_product(R::literal(3.333_333_333_333_333_5), t751)
        .sub_product(t26, t748);
    let plate_omega_dot_by_cylinder_v_x = (t23 * t752)
        .sub_product(t22, t753)
        .sub_product(t22, t751)
        .add_product(t23, t750)
        .add_product(t24, t745)
        .sub_product(t25, t744);
    let plate_v_y_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t750))
        .sub_product(R::literal(0.833_333_333_333_333_4), t752)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t744);
    let plate_v_x_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t751))
        .sub_product(R::literal(0.833_333_333_333_333_4), t753)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t745);
    let post_omega_dot_by_cylinder_v_x = (t20 * t754)
        .sub_product(t19, t755)
        .sub_product(t19, t753)
        .add_product(t20, t752)
        .sub_product(t21, t742);
    let post_v_y_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t752))
        .sub_product(R::literal(1.25), t754);
    let post_v_x_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t753))
        .sub_product(R::literal(1.25), t755);
    let t756 = R::literal(50.0) * (sin_cylinder_phi * sin_cylinder_phi);
    let t757 = t714 * sin_cylinder_phi;
    let t758 = t716 * sin_cylinder_phi;
    let t759 = t28 * t757;
    let t760 = t721 - t759;
    let t761 = R::literal(3.333_333_333_333_333_5) * t756;
    let t762 = -t761;
    let t763 = t29 * t757;
    let t764 = (t761 + t763).sub_product(t89, t760);
    let t765 = R::literal(-2_777.777_777_777_778) * t757;
    let t766 = (-t765).add_product(t91, t760).sub_product(t102, t764);
    let t767 = t26 * t713;
    let t768 = t27 * t756;
    let t769 = t30 * t757;
    let t770 = t31 * t713;
    let t771 = t32 * t756;
    let t772 = (t767 - t758 - t768 + t769 + t770 - t771)
        .sub_product(t93, t760)
        .sub_product(t104, t764)
        .sub_product(t113, t766);
    let t773 = t736.sub_product(t114, t766).sub_product(t124, t772);
    let t774 = R::literal(5.0) * t756;
    let t775 = (-t774)
        .add_product(t115, t766)
        .sub_product(t126, t772)
        .sub_product(t135, t773);
    let t776 = (-(t95 * t760))
        .sub_product(t106, t764)
        .sub_product(t117, t766)
        .sub_product(t128, t772)
        .sub_product(t137, t773)
        .sub_product(t144, t775);
    let t777 = (-(t97 * t760))
        .sub_product(t108, t764)
        .sub_product(t119, t766)
        .sub_product(t130, t772)
        .sub_product(t139, t773)
        .sub_product(t146, t775)
        .sub_product(t151, t776);
    let t778 = (t152 * t776).sub_product(t157, t777);
    let t779 = t757 * R::literal(2_777.777_777_777_778);
    let t780 = (-(t99 * t760))
        .sub_product(t110, t764)
        .sub_product(t121, t766)
        .sub_product(t132, t772)
        .sub_product(t141, t773)
        .sub_product(t148, t775)
        .sub_product(t154, t776)
        .sub_product(t159, t777)
        .sub_product(t164, t778) * t165;
    let t781 = (t778 * t162).sub_product(t164, t780);
    let t782 = (t777 * t155).sub_product(t157, t781).sub_product(t159, t780);
    let t783 = (t776 * t149)
        .sub_product(t151, t782)
        .add_product(t152, t781)
        .sub_product(t154, t780);
    let t784 = (t775 * t142)
        .sub_product(t144, t783)
        .sub_product(t146, t782)
        .sub_product(t148, t780);
    let t785 = (t773 * t133)
        .sub_product(t135, t784)
        .sub_product(t137, t783)
        .sub_product(t139, t782)
        .sub_product(t141, t780);
    let t786 = (t772 * t122)
        .sub_product(t124, t785)
        .sub_product(t126, t784)
        .sub_product(t128, t783)
        .sub_product(t130, t782)
        .sub_product(t132, t780);
    let t787 = (t766 * t111)
        .sub_product(t113, t786)
        .sub_product(t114, t785)
        .add_product(t115, t784)
        .sub_product(t117, t783)
        .sub_product(t119, t782)
        .sub_product(t121, t780);
    let t788 = (t764 * t100)
        .sub_product(t102, t787)
        .sub_product(t104, t786)
        .sub_product(t106, t783)
        .sub_product(t108, t782)
        .sub_product(t110, t780);
    let t789 = (t760 * t87)
        .sub_product(t89, t788)
        .add_product(t91, t787)
        .sub_product(t93, t786)
        .sub_product(t95, t783)
        .sub_product(t97, t782)
        .sub_product(t99, t780);
    let t790 = (-(t78 * t788))
        .sub_product(t76, t789)
        .sub_product(t81, t783)
        .sub_product(t84, t782)
        .sub_product(t86, t780);
    let t791 = (-(t64 * t789))
        .sub_product(t62, t790)
        .sub_product(t65, t788)
        .sub_product(t68, t783)
        .add_product(t70, t782)
        .sub_product(t72, t780);
    let t792 = (-(t55 * t790)).sub_product(t53, t791).sub_product(t57, t780);
    let t793 = (-(t45 * t791))
        .sub_product(t43, t792)
        .sub_product(t43, t790)
        .add_product(t47, t780);
    let drum_v_y_dot_by_cylinder_v_y = (t38 * t781)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t781);
    let drum_v_x_dot_by_cylinder_v_y = (t37 * t781)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t781);
    let bobbin_v_y_dot_by_cylinder_v_y = (-(t36 * t781))
        .sub_product(c.inverse_bobbin_mass, t782);
    let bobbin_v_x_dot_by_cylinder_v_y = (-(t35 * t781))
        .sub_product(c.inverse_bobbin_mass, t783);
    let rod_omega_dot_by_cylinder_v_y = (t33 * t785)
        .sub_product(R::literal(4_166.666_666_666_667), t787)
        .sub_product(t34, t784);
    let rod_v_y_dot_by_cylinder_v_y = t774
        .sub_product(t32, t786)
        .sub_product(R::literal(5.0), t784);
    let rod_v_x_dot_by_cylinder_v_y = t735
        .add_product(t31, t786)
        .sub_product(R::literal(5.0), t785);
    let cylinder_omega_dot_by_cylinder_v_y = t779
        .sub_product(t28, t789)
        .add_product(t29, t788)
        .sub_product(R::literal(-2_777.777_777_777_778), t787)
        .add_product(t30, t786);
    let cylinder_v_y_dot_by_cylinder_v_y = t762
        .sub_product(R::literal(3.333_333_333_333_333_5), t788)
        .add_product(t27, t786);
    let cylinder_v_x_dot_by_cylinder_v_y = t722
        .sub_product(R::literal(3.333_333_333_333_333_5), t789)
        .sub_product(t26, t786);
    let plate_omega_dot_by_cylinder_v_y = (t23 * t790)
        .sub_product(t22, t791)
        .sub_product(t22, t789)
        .add_product(t23, t788)
        .add_product(t24, t783)
        .sub_product(t25, t782);
    let plate_v_y_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t788))
        .sub_product(R::literal(0.833_333_333_333_333_4), t790)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t782);
    let plate_v_x_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t789))
        .sub_product(R::literal(0.833_333_333_333_333_4), t791)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t783);
    let post_omega_dot_by_cylinder_v_y = (t20 * t792)
        .sub_product(t19, t793)
        .sub_product(t19, t791)
        .add_product(t20, t790)
        .sub_product(t21, t780);
    let post_v_y_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t790))
        .sub_product(R::literal(1.25), t792);
    let post_v_x_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t791))
        .sub_product(R::literal(1.25), t793);
    let t794 = R::literal(50.0) * t391;
    let t795 = R::literal(0.12) * cylinder_omega;
    let t796 = R::literal(3.333_333_333_333_333_5) * t715;
    let t797 = (-t796).sub_product(t795, cos_cylinder_phi).add_product(t28, t794);
    let t798 = R::literal(3.333_333_333_333_333_5) * t757;
    let t799 = (-t798)
        .sub_product(t795, sin_cylinder_phi)
        .sub_product(t29, t794)
        .sub_product(t89, t797);
    let t800 = (R::literal(-2_777.777_777_777_778) * t794)
        .add_product(t91, t797)
        .sub_product(t102, t799);
    let t801 = (-(t26 * t715))
        .add_product(
            R::literal(2.0),
            ((t195 + t196)
                .add_product(rod_v_x, cos_cylinder_phi)
                .add_product(rod_v_y, sin_cylinder_phi) - t191 - t192)
                .sub_product(cylinder_v_x, cos_cylinder_phi)
                .sub_product(cylinder_v_y, sin_cylinder_phi),
        )
        .add_product(t27, t757)
        .sub_product(t30, t794)
        .sub_product(t31, t715)
        .add_product(t32, t757)
        .sub_product(t93, t797)
        .sub_product(t104, t799)
        .sub_product(t113, t800);
    let t802 = R::literal(5.0) * t715;
    let t803 = t802.sub_product(t114, t800).sub_product(t124, t801);
    let t804 = R::literal(5.0) * t757;
    let t805 = t804
        .add_product(t115, t800)
        .sub_product(t126, t801)
        .sub_product(t135, t803);
    let t806 = (-(t95 * t797))
        .sub_product(t106, t799)
        .sub_product(t117, t800)
        .sub_product(t128, t801)
        .sub_product(t137, t803)
        .sub_product(t144, t805);
    let t807 = (-(t97 * t797))
        .sub_product(t108, t799)
        .sub_product(t119, t800)
        .sub_product(t130, t801)
        .sub_product(t139, t803)
        .sub_product(t146, t805)
        .sub_product(t151, t806);
    let t808 = (t152 * t806).sub_product(t157, t807);
    let t809 = (-(t99 * t797))
        .sub_product(t110, t799)
        .sub_product(t121, t800)
        .sub_product(t132, t801)
        .sub_product(t141, t803)
        .sub_product(t148, t805)
        .sub_product(t154, t806)
        .sub_product(t159, t807)
        .sub_product(t164, t808) * t165;
    let t810 = (t808 * t162).sub_product(t164, t809);
    let t811 = (t807 * t155).sub_product(t157, t810).sub_product(t159, t809);
    let t812 = (t806 * t149)
        .sub_product(t151, t811)
        .add_product(t152, t810)
        .sub_product(t154, t809);
    let t813 = (t805 * t142)
        .sub_product(t144, t812)
        .sub_product(t146, t811)
        .sub_product(t148, t809);
    let t814 = (t803 * t133)
        .sub_product(t135, t813)
        .sub_product(t137, t812)
        .sub_product(t139, t811)
        .sub_product(t141, t809);
    let t815 = (t801 * t122)
        .sub_product(t124, t814)
        .sub_product(t126, t813)
        .sub_product(t128, t812)
        .sub_product(t130, t811)
        .sub_product(t132, t809);
    let t816 = (t800 * t111)
        .sub_product(t113, t815)
        .sub_product(t114, t814)
        .add_product(t115, t813)
        .sub_product(t117, t812)
        .sub_product(t119, t811)
        .sub_product(t121, t809);
    let t817 = (t799 * t100)
        .sub_product(t102, t816)
        .sub_product(t104, t815)
        .sub_product(t106, t812)
        .sub_product(t108, t811)
        .sub_product(t110, t809);
    let t818 = (t797 * t87)
        .sub_product(t89, t817)
        .add_product(t91, t816)
        .sub_product(t93, t815)
        .sub_product(t95, t812)
        .sub_product(t97, t811)
        .sub_product(t99, t809);
    let t819 = (-(t78 * t817))
        .sub_product(t76, t818)
        .sub_product(t81, t812)
        .sub_product(t84, t811)
        .sub_product(t86, t809);
    let t820 = (-(t64 * t818))
        .sub_product(t62, t819)
        .sub_product(t65, t817)
        .sub_product(t68, t812)
        .add_product(t70, t811)
        .sub_product(t72, t809);
    let t821 = (-(t55 * t819)).sub_product(t53, t820).sub_product(t57, t809);
    let t822 = (-(t45 * t820))
        .sub_product(t43, t821)
        .sub_product(t43, t819)
        .add_product(t47, t809);
    let drum_v_y_dot_by_cylinder_omega = (t38 * t810)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t810);
    let drum_v_x_dot_by_cylinder_omega = (t37 * t810)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t810);
    let bobbin_v_y_dot_by_cylinder_omega = (-(t36 * t810))
        .sub_product(c.inverse_bobbin_mass, t811);
    let bobbin_v_x_dot_by_cylinder_omega = (-(t35 * t810))
        .sub_product(c.inverse_bobbin_mass, t812);
    let rod_omega_dot_by_cylinder_omega = (t33 * t814)
        .sub_product(R::literal(4_166.666_666_666_667), t816)
        .sub_product(t34, t813);
    let rod_v_y_dot_by_cylinder_omega = (-t804)
        .sub_product(t32, t815)
        .sub_product(R::literal(5.0), t813);
    let rod_v_x_dot_by_cylinder_omega = (-t802)
        .add_product(t31, t815)
        .sub_product(R::literal(5.0), t814);
    let cylinder_omega_dot_by_cylinder_omega = (-(t794
        * R::literal(2_777.777_777_777_778)))
        .sub_product(t28, t818)
        .add_product(t29, t817)
        .sub_product(R::literal(-2_777.777_777_777_778), t816)
        .add_product(t30, t815);
    let cylinder_v_y_dot_by_cylinder_omega = t798
        .sub_product(R::literal(3.333_333_333_333_333_5), t817)
        .add_product(t27, t815);
    let cylinder_v_x_dot_by_cylinder_omega = t796
        .sub_product(R::literal(3.333_333_333_333_333_5), t818)
        .sub_product(t26, t815);
    let plate_omega_dot_by_cylinder_omega = (t23 * t819)
        .sub_product(t22, t820)
        .sub_product(t22, t818)
        .add_product(t23, t817)
        .add_product(t24, t812)
        .sub_product(t25, t811);
    let plate_v_y_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t817))
        .sub_product(R::literal(0.833_333_333_333_333_4), t819)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t811);
    let plate_v_x_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t818))
        .sub_product(R::literal(0.833_333_333_333_333_4), t820)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t812);
    let post_omega_dot_by_cylinder_omega = (t20 * t821)
        .sub_product(t19, t822)
        .sub_product(t19, t820)
        .add_product(t20, t819)
        .sub_product(t21, t809);
    let post_v_y_dot_by_cylinder_omega = (-(R::literal(-1.25) * t819))
        .sub_product(R::literal(1.25), t821);
    let post_v_x_dot_by_cylinder_omega = (-(R::literal(-1.25) * t820))
        .sub_product(R::literal(1.25), t822);
    let t823 = t719 - t718;
    let t824 = (t722 - t723).sub_product(t89, t823);
    let t825 = t725.add_product(t91, t823).sub_product(t102, t824);
    let t826 = (t717 - t727 + t728 - t729 - t730 + t731)
        .sub_product(t93, t823)
        .sub_product(t104, t824)
        .sub_product(t113, t825);
    let t827 = t733.sub_product(t114, t825).sub_product(t124, t826);
    let t828 = t735
        .add_product(t115, t825)
        .sub_product(t126, t826)
        .sub_product(t135, t827);
    let t829 = (-(t95 * t823))
        .sub_product(t106, t824)
        .sub_product(t117, t825)
        .sub_product(t128, t826)
        .sub_product(t137, t827)
        .sub_product(t144, t828);
    let t830 = (-(t97 * t823))
        .sub_product(t108, t824)
        .sub_product(t119, t825)
        .sub_product(t130, t826)
        .sub_product(t139, t827)
        .sub_product(t146, t828)
        .sub_product(t151, t829);
    let t831 = (t152 * t829).sub_product(t157, t830);
    let t832 = (-(t99 * t823))
        .sub_product(t110, t824)
        .sub_product(t121, t825)
        .sub_product(t132, t826)
        .sub_product(t141, t827)
        .sub_product(t148, t828)
        .sub_product(t154, t829)
        .sub_product(t159, t830)
        .sub_product(t164, t831) * t165;
    let t833 = (t831 * t162).sub_product(t164, t832);
    let t834 = (t830 * t155).sub_product(t157, t833).sub_product(t159, t832);
    let t835 = (t829 * t149)
        .sub_product(t151, t834)
        .add_product(t152, t833)
        .sub_product(t154, t832);
    let t836 = (t828 * t142)
        .sub_product(t144, t835)
        .sub_product(t146, t834)
        .sub_product(t148, t832);
    let t837 = (t827 * t133)
        .sub_product(t135, t836)
        .sub_product(t137, t835)
        .sub_product(t139, t834)
        .sub_product(t141, t832);
    let t838 = (t826 * t122)
        .sub_product(t124, t837)
        .sub_product(t126, t836)
        .sub_product(t128, t835)
        .sub_product(t130, t834)
        .sub_product(t132, t832);
    let t839 = (t825 * t111)
        .sub_product(t113, t838)
        .sub_product(t114, t837)
        .add_product(t115, t836)
        .sub_product(t117, t835)
        .sub_product(t119, t834)
        .sub_product(t121, t832);
    let t840 = (t824 * t100)
        .sub_product(t102, t839)
        .sub_product(t104, t838)
        .sub_product(t106, t835)
        .sub_product(t108, t834)
        .sub_product(t110, t832);
    let t841 = (t823 * t87)
        .sub_product(t89, t840)
        .add_product(t91, t839)
        .sub_product(t93, t838)
        .sub_product(t95, t835)
        .sub_product(t97, t834)
        .sub_product(t99, t832);
    let t842 = (-(t78 * t840))
        .sub_product(t76, t841)
        .sub_product(t81, t835)
        .sub_product(t84, t834)
        .sub_product(t86, t832);
    let t843 = (-(t64 * t841))
        .sub_product(t62, t842)
        .sub_product(t65, t840)
        .sub_product(t68, t835)
        .add_product(t70, t834)
        .sub_product(t72, t832);
    let t844 = (-(t55 * t842)).sub_product(t53, t843).sub_product(t57, t832);
    let t845 = (-(t45 * t843))
        .sub_product(t43, t844)
        .sub_product(t43, t842)
        .add_product(t47, t832);
    let drum_v_y_dot_by_rod_v_x = (t38 * t833)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t833);
    let drum_v_x_dot_by_rod_v_x = (t37 * t833)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t833);
    let bobbin_v_y_dot_by_rod_v_x = (-(t36 * t833))
        .sub_product(c.inverse_bobbin_mass, t834);
    let bobbin_v_x_dot_by_rod_v_x = (-(t35 * t833))
        .sub_product(c.inverse_bobbin_mass, t835);
    let rod_omega_dot_by_rod_v_x = (t33 * t837)
        .sub_product(R::literal(4_166.666_666_666_667), t839)
        .sub_product(t34, t836);
    let rod_v_y_dot_by_rod_v_x = t736
        .sub_product(t32, t838)
        .sub_product(R::literal(5.0), t836);
    let rod_v_x_dot_by_rod_v_x = (-t733)
        .add_product(t31, t838)
        .sub_product(R::literal(5.0), t837);
    let cylinder_omega_dot_by_rod_v_x = (-t741)
        .sub_product(t28, t841)
        .add_product(t29, t840)
        .sub_product(R::literal(-2_777.777_777_777_778), t839)
        .add_product(t30, t838);
    let cylinder_v_y_dot_by_rod_v_x = t721
        .sub_product(R::literal(3.333_333_333_333_333_5), t840)
        .add_product(t27, t838);
    let cylinder_v_x_dot_by_rod_v_x = t718
        .sub_product(R::literal(3.333_333_333_333_333_5), t841)
        .sub_product(t26, t838);
    let plate_omega_dot_by_rod_v_x = (t23 * t842)
        .sub_product(t22, t843)
        .sub_product(t22, t841)
        .add_product(t23, t840)
        .add_product(t24, t835)
        .sub_product(t25, t834);
    let plate_v_y_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t840))
        .sub_product(R::literal(0.833_333_333_333_333_4), t842)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t834);
    let plate_v_x_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t841))
        .sub_product(R::literal(0.833_333_333_333_333_4), t843)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t835);
    let post_omega_dot_by_rod_v_x = (t20 * t844)
        .sub_product(t19, t845)
        .sub_product(t19, t843)
        .add_product(t20, t842)
        .sub_product(t21, t832);
    let post_v_y_dot_by_rod_v_x = (-(R::literal(-1.25) * t842))
        .sub_product(R::literal(1.25), t844);
    let post_v_x_dot_by_rod_v_x = (-(R::literal(-1.25) * t843))
        .sub_product(R::literal(1.25), t845);
    let t846 = t759 - t721;
    let t847 = (t762 - t763).sub_product(t89, t846);
    let t848 = t765.add_product(t91, t846).sub_product(t102, t847);
    let t849 = (t758 - t767 + t768 - t769 - t770 + t771)
        .sub_product(t93, t846)
        .sub_product(t104, t847)
        .sub_product(t113, t848);
    let t850 = t735.sub_product(t114, t848).sub_product(t124, t849);
    let t851 = t774
        .add_product(t115, t848)
        .sub_product(t126, t849)
        .sub_product(t135, t850);
    let t852 = (-(t95 * t846))
        .sub_product(t106, t847)
        .sub_product(t117, t848)
        .sub_product(t128, t849)
        .sub_product(t137, t850)
        .sub_product(t144, t851);
    let t853 = (-(t97 * t846))
        .sub_product(t108, t847)
        .sub_product(t119, t848)
        .sub_product(t130, t849)
        .sub_product(t139, t850)
        .sub_product(t146, t851)
        .sub_product(t151, t852);
    let t854 = (t152 * t852).sub_product(t157, t853);
    let t855 = (-(t99 * t846))
        .sub_product(t110, t847)
        .sub_product(t121, t848)
        .sub_product(t132, t849)
        .sub_product(t141, t850)
        .sub_product(t148, t851)
        .sub_product(t154, t852)
        .sub_product(t159, t853)
        .sub_product(t164, t854) * t165;
    let t856 = (t854 * t162).sub_product(t164, t855);
    let t857 = (t853 * t155).sub_product(t157, t856).sub_product(t159, t855);
    let t858 = (t852 * t149)
        .sub_product(t151, t857)
        .add_product(t152, t856)
        .sub_product(t154, t855);
    let t859 = (t851 * t142)
        .sub_product(t144, t858)
        .sub_product(t146, t857)
        .sub_product(t148, t855);
    let t860 = (t850 * t133)
        .sub_product(t135, t859)
        .sub_product(t137, t858)
        .sub_product(t139, t857)
        .sub_product(t141, t855);
    let t861 = (t849 * t122)
        .sub_product(t124, t860)
        .sub_product(t126, t859)
        .sub_product(t128, t858)
        .sub_product(t130, t857)
        .sub_product(t132, t855);
    let t862 = (t848 * t111)
        .sub_product(t113, t861)
        .sub_product(t114, t860)
        .add_product(t115, t859)
        .sub_product(t117, t858)
        .sub_product(t119, t857)
        .sub_product(t121, t855);
    let t863 = (t847 * t100)
        .sub_product(t102, t862)
        .sub_product(t104, t861)
        .sub_product(t106, t858)
        .sub_product(t108, t857)
        .sub_product(t110, t855);
    let t864 = (t846 * t87)
        .sub_product(t89, t863)
        .add_product(t91, t862)
        .sub_product(t93, t861)
        .sub_product(t95, t858)
        .sub_product(t97, t857)
        .sub_product(t99, t855);
    let t865 = (-(t78 * t863))
        .sub_product(t76, t864)
        .sub_product(t81, t858)
        .sub_product(t84, t857)
        .sub_product(t86, t855);
    let t866 = (-(t64 * t864))
        .sub_product(t62, t865)
        .sub_product(t65, t863)
        .sub_product(t68, t858)
        .add_product(t70, t857)
        .sub_product(t72, t855);
    let t867 = (-(t55 * t865)).sub_product(t53, t866).sub_product(t57, t855);
    let t868 = (-(t45 * t866))
        .sub_product(t43, t867)
        .sub_product(t43, t865)
        .add_product(t47, t855);
    let drum_v_y_dot_by_rod_v_y = (t38 * t856)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t856);
    let drum_v_x_dot_by_rod_v_y = (t37 * t856)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t856);
    let bobbin_v_y_dot_by_rod_v_y = (-(t36 * t856))
        .sub_product(c.inverse_bobbin_mass, t857);
    let bobbin_v_x_dot_by_rod_v_y = (-(t35 * t856))
        .sub_product(c.inverse_bobbin_mass, t858);
    let rod_omega_dot_by_rod_v_y = (t33 * t860)
        .sub_product(R::literal(4_166.666_666_666_667), t862)
        .sub_product(t34, t859);
    let rod_v_y_dot_by_rod_v_y = (-t774)
        .sub_product(t32, t861)
        .sub_product(R::literal(5.0), t859);
    let rod_v_x_dot_by_rod_v_y = (-t735)
        .add_product(t31, t861)
        .sub_product(R::literal(5.0), t860);
    let cylinder_omega_dot_by_rod_v_y = (-t779)
        .sub_product(t28, t864)
        .add_product(t29, t863)
        .sub_product(R::literal(-2_777.777_777_777_778), t862)
        .add_product(t30, t861);
    let cylinder_v_y_dot_by_rod_v_y = t761
        .sub_product(R::literal(3.333_333_333_333_333_5), t863)
        .add_product(t27, t861);
    let cylinder_v_x_dot_by_rod_v_y = t721
        .sub_product(R::literal(3.333_333_333_333_333_5), t864)
        .sub_product(t26, t861);
    let plate_omega_dot_by_rod_v_y = (t23 * t865)
        .sub_product(t22, t866)
        .sub_product(t22, t864)
        .add_product(t23, t863)
        .add_product(t24, t858)
        .sub_product(t25, t857);
    let plate_v_y_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t863))
        .sub_product(R::literal(0.833_333_333_333_333_4), t865)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t857);
    let plate_v_x_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t864))
        .sub_product(R::literal(0.833_333_333_333_333_4), t866)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t858);
    let post_omega_dot_by_rod_v_y = (t20 * t867)
        .sub_product(t19, t868)
        .sub_product(t19, t866)
        .add_product(t20, t865)
        .sub_product(t21, t855);
    let post_v_y_dot_by_rod_v_y = (-(R::literal(-1.25) * t865))
        .sub_product(R::literal(1.25), t867);
    let post_v_x_dot_by_rod_v_y = (-(R::literal(-1.25) * t866))
        .sub_product(R::literal(1.25), t868);
    let t869 = R::literal(0.12) * rod_omega;
    let t870 = t869 * cos_rod_phi;
    let t871 = (t869 * sin_rod_phi).sub_product(t135, t870);
    let t872 = (-(t137 * t870)).sub_product(t144, t871);
    let t873 = (-(t139 * t870)).sub_product(t146, t871).sub_product(t151, t872);
    let t874 = (t152 * t872).sub_product(t157, t873);
    let t875 = (-(t141 * t870))
        .sub_product(t148, t871)
        .sub_product(t154, t872)
        .sub_product(t159, t873)
        .sub_product(t164, t874) * t165;
    let t876 = (t874 * t162).sub_product(t164, t875);
    let t877 = (t873 * t155).sub_product(t157, t876).sub_product(t159, t875);
    let t878 = (t872 * t149)
        .sub_product(t151, t877)
        .add_product(t152, t876)
        .sub_product(t154, t875);
    let t879 = (t871 * t142)
        .sub_product(t144, t878)
        .sub_product(t146, t877)
        .sub_product(t148, t875);
    let t880 = (t870 * t133)
        .sub_product(t135, t879)
        .sub_product(t137, t878)
        .sub_product(t139, t877)
        .sub_product(t141, t875);
    let t881 = (-(t126 * t879))
        .sub_product(t124, t880)
        .sub_product(t128, t878)
        .sub_product(t130, t877)
        .sub_product(t132, t875);
    let t882 = (-(t114 * t880))
        .sub_product(t113, t881)
        .add_product(t115, t879)
        .sub_product(t117, t878)
        .sub_product(t119, t877)
        .sub_product(t121, t875);
    let t883 = (-(t104 * t881))
        .sub_product(t102, t882)
        .sub_product(t106, t878)
        .sub_product(t108, t877)
        .sub_product(t110, t875);
    let t884 = (t91 * t882)
        .sub_product(t89, t883)
        .sub_product(t93, t881)
        .sub_product(t95, t878)
        .sub_product(t97, t877)
        .sub_product(t99, t875);
    let t885 = (-(t78 * t883))
        .sub_product(t76, t884)
        .sub_product(t81, t878)
        .sub_product(t84, t877)
        .sub_product(t86, t875);
    let t886 = (-(t64 * t884))
        .sub_product(t62, t885)
        .sub_product(t65, t883)
        .sub_product(t68, t878)
        .add_product(t70, t877)
        .sub_product(t72, t875);
    let t887 = (-(t55 * t885)).sub_product(t53, t886).sub_product(t57, t875);
    let t888 = (-(t45 * t886))
        .sub_product(t43, t887)
        .sub_product(t43, t885)
        .add_product(t47, t875);
    let drum_v_y_dot_by_rod_omega = (t38 * t876)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t876);
    let drum_v_x_dot_by_rod_omega = (t37 * t876)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t876);
    let bobbin_v_y_dot_by_rod_omega = (-(t36 * t876))
        .sub_product(c.inverse_bobbin_mass, t877);
    let bobbin_v_x_dot_by_rod_omega = (-(t35 * t876))
        .sub_product(c.inverse_bobbin_mass, t878);
    let rod_omega_dot_by_rod_omega = (t33 * t880)
        .sub_product(R::literal(4_166.666_666_666_667), t882)
        .sub_product(t34, t879);
    let rod_v_y_dot_by_rod_omega = (-(R::literal(5.0) * t879)).sub_product(t32, t881);
    let rod_v_x_dot_by_rod_omega = (-(R::literal(5.0) * t880)).add_product(t31, t881);
    let cylinder_omega_dot_by_rod_omega = (t29 * t883)
        .sub_product(t28, t884)
        .sub_product(R::literal(-2_777.777_777_777_778), t882)
        .add_product(t30, t881);
    let cylinder_v_y_dot_by_rod_omega = (t27 * t881)
        .sub_product(R::literal(3.333_333_333_333_333_5), t883);
    let cylinder_v_x_dot_by_rod_omega = (-(t26 * t881))
        .sub_product(R::literal(3.333_333_333_333_333_5), t884);
    let plate_omega_dot_by_rod_omega = (t23 * t885)
        .sub_product(t22, t886)
        .sub_product(t22, t884)
        .add_product(t23, t883)
        .add_product(t24, t878)
        .sub_product(t25, t877);
    let plate_v_y_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t883))
        .sub_product(R::literal(0.833_333_333_333_333_4), t885)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t877);
    let plate_v_x_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t884))
        .sub_product(R::literal(0.833_333_333_333_333_4), t886)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t878);
    let post_omega_dot_by_rod_omega = (t20 * t887)
        .sub_product(t19, t888)
        .sub_product(t19, t886)
        .add_product(t20, t885)
        .sub_product(t21, t875);
    let post_v_y_dot_by_rod_omega = (-(R::literal(-1.25) * t885))
        .sub_product(R::literal(1.25), t887);
    let post_v_x_dot_by_rod_omega = (-(R::literal(-1.25) * t886))
        .sub_product(R::literal(1.25), t888);
    let t889 = R::literal(2.0) * bobbin_v_y * bobbin_x_minus_drum_x
        * bobbin_y_minus_drum_y / between_squared_times_between;
    let t890 = R::literal(2.0) * drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t891 = drum_v_x_over_between
        - ((t890.add_product(bobbin_v_x, t537) + bobbin_v_x_over_between)
            .add_product(drum_v_x, t544) + t204 - t889 - t201);
    let t892 = t164 * t891 * t165;
    let t893 = (t891 * t162).add_product(t164, t892);
    let t894 = (t159 * t892).sub_product(t157, t893);
    let t895 = (t152 * t893).sub_product(t151, t894).add_product(t154, t892);
    let t896 = (-(t146 * t894)).sub_product(t144, t895).add_product(t148, t892);
    let t897 = (-(t137 * t895))
        .sub_product(t135, t896)
        .sub_product(t139, t894)
        .add_product(t141, t892);
    let t898 = (-(t126 * t896))
        .sub_product(t124, t897)
        .sub_product(t128, t895)
        .sub_product(t130, t894)
        .add_product(t132, t892);
    let t899 = (-(t114 * t897))
        .sub_product(t113, t898)
        .add_product(t115, t896)
        .sub_product(t117, t895)
        .sub_product(t119, t894)
        .add_product(t121, t892);
    let t900 = (-(t104 * t898))
        .sub_product(t102, t899)
        .sub_product(t106, t895)
        .sub_product(t108, t894)
        .add_product(t110, t892);
    let t901 = (t91 * t899)
        .sub_product(t89, t900)
        .sub_product(t93, t898)
        .sub_product(t95, t895)
        .sub_product(t97, t894)
        .add_product(t99, t892);
    let t902 = (-(t78 * t900))
        .sub_product(t76, t901)
        .sub_product(t81, t895)
        .sub_product(t84, t894)
        .add_product(t86, t892);
    let t903 = (-(t64 * t901))
        .sub_product(t62, t902)
        .sub_product(t65, t900)
        .sub_product(t68, t895)
        .add_product(t70, t894)
        .add_product(t72, t892);
    let t904 = (-(t55 * t902)).sub_product(t53, t903).add_product(t57, t892);
    let t905 = (-(t45 * t903))
        .sub_product(t43, t904)
        .sub_product(t43, t902)
        .sub_product(t47, t892);
    let drum_v_y_dot_by_bobbin_v_x = (t38 * t893)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t893);
    let drum_v_x_dot_by_bobbin_v_x = (t37 * t893)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t893);
    let bobbin_v_y_dot_by_bobbin_v_x = (-(t36 * t893))
        .sub_product(c.inverse_bobbin_mass, t894);
    let bobbin_v_x_dot_by_bobbin_v_x = (-(t35 * t893))
        .sub_product(c.inverse_bobbin_mass, t895);
    let rod_omega_dot_by_bobbin_v_x = (t33 * t897)
        .sub_product(R::literal(4_166.666_666_666_667), t899)
        .sub_product(t34, t896);
    let rod_v_y_dot_by_bobbin_v_x = (-(R::literal(5.0) * t896)).sub_product(t32, t898);
    let rod_v_x_dot_by_bobbin_v_x = (-(R::literal(5.0) * t897)).add_product(t31, t898);
    let cylinder_omega_dot_by_bobbin_v_x = (t29 * t900)
        .sub_product(t28, t901)
        .sub_product(R::literal(-2_777.777_777_777_778), t899)
        .add_product(t30, t898);
    let cylinder_v_y_dot_by_bobbin_v_x = (t27 * t898)
        .sub_product(R::literal(3.333_333_333_333_333_5), t900);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(t26 * t898))
        .sub_product(R::literal(3.333_333_333_333_333_5), t901);
    let plate_omega_dot_by_bobbin_v_x = (t23 * t902)
        .sub_product(t22, t903)
        .sub_product(t22, t901)
        .add_product(t23, t900)
        .add_product(t24, t895)
        .sub_product(t25, t894);
    let plate_v_y_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t900))
        .sub_product(R::literal(0.833_333_333_333_333_4), t902)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t894);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t901))
        .sub_product(R::literal(0.833_333_333_333_333_4), t903)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t895);
    let post_omega_dot_by_bobbin_v_x = (t20 * t904)
        .sub_product(t19, t905)
        .sub_product(t19, t903)
        .add_product(t20, t902)
        .add_product(t21, t892);
    let post_v_y_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t902))
        .sub_product(R::literal(1.25), t904);
    let post_v_x_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t903))
        .sub_product(R::literal(1.25), t905);
    let t906 = R::literal(2.0) * bobbin_v_x * bobbin_x_minus_drum_x
        * bobbin_y_minus_drum_y / between_squared_times_between;
    let t907 = R::literal(2.0) * drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t908 = drum_v_y_over_between
        - ((t907.add_product(bobbin_v_y, t587) + bobbin_v_y_over_between)
            .add_product(drum_v_y, t591) + t210 - t906 - t208);
    let t909 = t164 * t908 * t165;
    let t910 = (t908 * t162).add_product(t164, t909);
    let t911 = (t159 * t909).sub_product(t157, t910);
    let t912 = (t152 * t910).sub_product(t151, t911).add_product(t154, t909);
    let t913 = (-(t146 * t911)).sub_product(t144, t912).add_product(t148, t909);
    let t914 = (-(t137 * t912))
        .sub_product(t135, t913)
        .sub_product(t139, t911)
        .add_product(t141, t909);
    let t915 = (-(t126 * t913))
        .sub_product(t124, t914)
        .sub_product(t128, t912)
        .sub_product(t130, t911)
        .add_product(t132, t909);
    let t916 = (-(t114 * t914))
        .sub_product(t113, t915)
        .add_product(t115, t913)
        .sub_product(t117, t912)
        .sub_product(t119, t911)
        .add_product(t121, t909);
    let t917 = (-(t104 * t915))
        .sub_product(t102, t916)
        .sub_product(t106, t912)
        .sub_product(t108, t911)
        .add_product(t110, t909);
    let t918 = (t91 * t916)
        .sub_product(t89, t917)
        .sub_product(t93, t915)
        .sub_product(t95, t912)
        .sub_product(t97, t911)
        .add_product(t99, t909);
    let t919 = (-(t78 * t917))
        .sub_product(t76, t918)
        .sub_product(t81, t912)
        .sub_product(t84, t911)
        .add_product(t86, t909);
    let t920 = (-(t64 * t918))
        .sub_product(t62, t919)
        .sub_product(t65, t917)
        .sub_product(t68, t912)
        .add_product(t70, t911)
        .add_product(t72, t909);
    let t921 = (-(t55 * t919)).sub_product(t53, t920).add_product(t57, t909);
    let t922 = (-(t45 * t920))
        .sub_product(t43, t921)
        .sub_product(t43, t919)
        .sub_product(t47, t909);
    let drum_v_y_dot_by_bobbin_v_y = (t38 * t910)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t910);
    let drum_v_x_dot_by_bobbin_v_y = (t37 * t910)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t910);
    let bobbin_v_y_dot_by_bobbin_v_y = (-(t36 * t910))
        .sub_product(c.inverse_bobbin_mass, t911);
    let bobbin_v_x_dot_by_bobbin_v_y = (-(t35 * t910))
        .sub_product(c.inverse_bobbin_mass, t912);
    let rod_omega_dot_by_bobbin_v_y = (t33 * t914)
        .sub_product(R::literal(4_166.666_666_666_667), t916)
        .sub_product(t34, t913);
    let rod_v_y_dot_by_bobbin_v_y = (-(R::literal(5.0) * t913)).sub_product(t32, t915);
    let rod_v_x_dot_by_bobbin_v_y = (-(R::literal(5.0) * t914)).add_product(t31, t915);
    let cylinder_omega_dot_by_bobbin_v_y = (t29 * t917)
        .sub_product(t28, t918)
        .sub_product(R::literal(-2_777.777_777_777_778), t916)
        .add_product(t30, t915);
    let cylinder_v_y_dot_by_bobbin_v_y = (t27 * t915)
        .sub_product(R::literal(3.333_333_333_333_333_5), t917);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(t26 * t915))
        .sub_product(R::literal(3.333_333_333_333_333_5), t918);
    let plate_omega_dot_by_bobbin_v_y = (t23 * t919)
        .sub_product(t22, t920)
        .sub_product(t22, t918)
        .add_product(t23, t917)
        .add_product(t24, t912)
        .sub_product(t25, t911);
    let plate_v_y_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t917))
        .sub_product(R::literal(0.833_333_333_333_333_4), t919)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t911);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t918))
        .sub_product(R::literal(0.833_333_333_333_333_4), t920)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t912);
    let post_omega_dot_by_bobbin_v_y = (t20 * t921)
        .sub_product(t19, t922)
        .sub_product(t19, t920)
        .add_product(t20, t919)
        .add_product(t21, t909);
    let post_v_y_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t919))
        .sub_product(R::literal(1.25), t921);
    let post_v_x_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t920))
        .sub_product(R::literal(1.25), t922);
    let t923 = t204
        - ((t889.add_product(bobbin_v_x, t544) + t201).add_product(drum_v_x, t537)
            + drum_v_x_over_between - t890 - bobbin_v_x_over_between);
    let t924 = t164 * t923 * t165;
    let t925 = (t923 * t162).add_product(t164, t924);
    let t926 = (t159 * t924).sub_product(t157, t925);
    let t927 = (t152 * t925).sub_product(t151, t926).add_product(t154, t924);
    let t928 = (-(t146 * t926)).sub_product(t144, t927).add_product(t148, t924);
    let t929 = (-(t137 * t927))
        .sub_product(t135, t928)
        .sub_product(t139, t926)
        .add_product(t141, t924);
    let t930 = (-(t126 * t928))
        .sub_product(t124, t929)
        .sub_product(t128, t927)
        .sub_product(t130, t926)
        .add_product(t132, t924);
    let t931 = (-(t114 * t929))
        .sub_product(t113, t930)
        .add_product(t115, t928)
        .sub_product(t117, t927)
        .sub_product(t119, t926)
        .add_product(t121, t924);
    let t932 = (-(t104 * t930))
        .sub_product(t102, t931)
        .sub_product(t106, t927)
        .sub_product(t108, t926)
        .add_product(t110, t924);
    let t933 = (t91 * t931)
        .sub_product(t89, t932)
        .sub_product(t93, t930)
        .sub_product(t95, t927)
        .sub_product(t97, t926)
        .add_product(t99, t924);
    let t934 = (-(t78 * t932))
        .sub_product(t76, t933)
        .sub_product(t81, t927)
        .sub_product(t84, t926)
        .add_product(t86, t924);
    let t935 = (-(t64 * t933))
        .sub_product(t62, t934)
        .sub_product(t65, t932)
        .sub_product(t68, t927)
        .add_product(t70, t926)
        .add_product(t72, t924);
    let t936 = (-(t55 * t934)).sub_product(t53, t935).add_product(t57, t924);
    let t937 = (-(t45 * t935))
        .sub_product(t43, t936)
        .sub_product(t43, t934)
        .sub_product(t47, t924);
    let drum_v_y_dot_by_drum_v_x = (t38 * t925)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t925);
    let drum_v_x_dot_by_drum_v_x = (t37 * t925)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t925);
    let bobbin_v_y_dot_by_drum_v_x = (-(t36 * t925))
        .sub_product(c.inverse_bobbin_mass, t926);
    let bobbin_v_x_dot_by_drum_v_x = (-(t35 * t925))
        .sub_product(c.inverse_bobbin_mass, t927);
    let rod_omega_dot_by_drum_v_x = (t33 * t929)
        .sub_product(R::literal(4_166.666_666_666_667), t931)
        .sub_product(t34, t928);
    let rod_v_y_dot_by_drum_v_x = (-(R::literal(5.0) * t928)).sub_product(t32, t930);
    let rod_v_x_dot_by_drum_v_x = (-(R::literal(5.0) * t929)).add_product(t31, t930);
    let cylinder_omega_dot_by_drum_v_x = (t29 * t932)
        .sub_product(t28, t933)
        .sub_product(R::literal(-2_777.777_777_777_778), t931)
        .add_product(t30, t930);
    let cylinder_v_y_dot_by_drum_v_x = (t27 * t930)
        .sub_product(R::literal(3.333_333_333_333_333_5), t932);
    let cylinder_v_x_dot_by_drum_v_x = (-(t26 * t930))
        .sub_product(R::literal(3.333_333_333_333_333_5), t933);
    let plate_omega_dot_by_drum_v_x = (t23 * t934)
        .sub_product(t22, t935)
        .sub_product(t22, t933)
        .add_product(t23, t932)
        .add_product(t24, t927)
        .sub_product(t25, t926);
    let plate_v_y_dot_by_drum_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t932))
        .sub_product(R::literal(0.833_333_333_333_333_4), t934)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t926);
    let plate_v_x_dot_by_drum_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t933))
        .sub_product(R::literal(0.833_333_333_333_333_4), t935)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t927);
    let post_omega_dot_by_drum_v_x = (t20 * t936)
        .sub_product(t19, t937)
        .sub_product(t19, t935)
        .add_product(t20, t934)
        .add_product(t21, t924);
    let post_v_y_dot_by_drum_v_x = (-(R::literal(-1.25) * t934))
        .sub_product(R::literal(1.25), t936);
    let post_v_x_dot_by_drum_v_x = (-(R::literal(-1.25) * t935))
        .sub_product(R::literal(1.25), t937);
    let t938 = t210
        - ((t906.add_product(bobbin_v_y, t591) + t208).add_product(drum_v_y, t587)
            + drum_v_y_over_between - t907 - bobbin_v_y_over_between);
    let t939 = t164 * t938 * t165;
    let t940 = (t938 * t162).add_product(t164, t939);
    let t941 = (t159 * t939).sub_product(t157, t940);
    let t942 = (t152 * t940).sub_product(t151, t941).add_product(t154, t939);
    let t943 = (-(t146 * t941)).sub_product(t144, t942).add_product(t148, t939);
    let t944 = (-(t137 * t942))
        .sub_product(t135, t943)
        .sub_product(t139, t941)
        .add_product(t141, t939);
    let t945 = (-(t126 * t943))
        .sub_product(t124, t944)
        .sub_product(t128, t942)
        .sub_product(t130, t941)
        .add_product(t132, t939);
    let t946 = (-(t114 * t944))
        .sub_product(t113, t945)
        .add_product(t115, t943)
        .sub_product(t117, t942)
        .sub_product(t119, t941)
        .add_product(t121, t939);
    let t947 = (-(t104 * t945))
        .sub_product(t102, t946)
        .sub_product(t106, t942)
        .sub_product(t108, t941)
        .add_product(t110, t939);
    let t948 = (t91 * t946)
        .sub_product(t89, t947)
        .sub_product(t93, t945)
        .sub_product(t95, t942)
        .sub_product(t97, t941)
        .add_product(t99, t939);
    let t949 = (-(t78 * t947))
        .sub_product(t76, t948)
        .sub_product(t81, t942)
        .sub_product(t84, t941)
        .add_product(t86, t939);
    let t950 = (-(t64 * t948))
        .sub_product(t62, t949)
        .sub_product(t65, t947)
        .sub_product(t68, t942)
        .add_product(t70, t941)
        .add_product(t72, t939);
    let t951 = (-(t55 * t949)).sub_product(t53, t950).add_product(t57, t939);
    let t952 = (-(t45 * t950))
        .sub_product(t43, t951)
        .sub_product(t43, t949)
        .sub_product(t47, t939);
    let drum_v_y_dot_by_drum_v_y = (t38 * t940)
        .add_product(R::literal(0.666_666_666_666_666_6), t161 * t940);
    let drum_v_x_dot_by_drum_v_y = (t37 * t940)
        .add_product(R::literal(0.666_666_666_666_666_6), t160 * t940);
    let bobbin_v_y_dot_by_drum_v_y = (-(t36 * t940))
        .sub_product(c.inverse_bobbin_mass, t941);
    let bobbin_v_x_dot_by_drum_v_y = (-(t35 * t940))
        .sub_product(c.inverse_bobbin_mass, t942);
    let rod_omega_dot_by_drum_v_y = (t33 * t944)
        .sub_product(R::literal(4_166.666_666_666_667), t946)
        .sub_product(t34, t943);
    let rod_v_y_dot_by_drum_v_y = (-(R::literal(5.0) * t943)).sub_product(t32, t945);
    let rod_v_x_dot_by_drum_v_y = (-(R::literal(5.0) * t944)).add_product(t31, t945);
    let cylinder_omega_dot_by_drum_v_y = (t29 * t947)
        .sub_product(t28, t948)
        .sub_product(R::literal(-2_777.777_777_777_778), t946)
        .add_product(t30, t945);
    let cylinder_v_y_dot_by_drum_v_y = (t27 * t945)
        .sub_product(R::literal(3.333_333_333_333_333_5), t947);
    let cylinder_v_x_dot_by_drum_v_y = (-(t26 * t945))
        .sub_product(R::literal(3.333_333_333_333_333_5), t948);
    let plate_omega_dot_by_drum_v_y = (t23 * t949)
        .sub_product(t22, t950)
        .sub_product(t22, t948)
        .add_product(t23, t947)
        .add_product(t24, t942)
        .sub_product(t25, t941);
    let plate_v_y_dot_by_drum_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t947))
        .sub_product(R::literal(0.833_333_333_333_333_4), t949)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t941);
    let plate_v_x_dot_by_drum_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t948))
        .sub_product(R::literal(0.833_333_333_333_333_4), t950)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t942);
    let post_omega_dot_by_drum_v_y = (t20 * t951)
        .sub_product(t19, t952)
        .sub_product(t19, t950)
        .add_product(t20, t949)
        .add_product(t21, t939);
    let post_v_y_dot_by_drum_v_y = (-(R::literal(-1.25) * t949))
        .sub_product(R::literal(1.25), t951);
    let post_v_x_dot_by_drum_v_y = (-(R::literal(-1.25) * t950))
        .sub_product(R::literal(1.25), t952);
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
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t8 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t8)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t9 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
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
    let t45 = (t12 * t0).sub_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).add_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51)
            .sub_product(t38, t37)
            .sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).sub_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = (-t39).add_product(t40, t37).sub_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43)
            .sub_product(t48, t47)
            .sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72.sub_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).sub_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t57, t56)
            .sub_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = (-t19).add_product(t23, t5);
    let t86 = t85 * t80;
    let t87 = (R::literal(-0.833_333_333_333_333_4) + t59)
        .sub_product(t61, t56)
        .sub_product(t74, t68);
    let t88 = t87 * t80;
    let t89 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t90 = t89 * t80;
    let t91 = (-(t65 * t56)).sub_product(t79, t68);
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t58, t53)
            .sub_product(t71, t70)
            .sub_product(t82, t81);
    let t94 = (R::literal(-2_777.777_777_777_778) * t4).add_product(t84, t81);
    let t95 = t94 * t93;
    let t96 = t20.sub_product(t23, t4).sub_product(t86, t81);
    let t97 = t96 * t93;
    let t98 = t72.sub_product(t61, t53).sub_product(t74, t70).sub_product(t88, t81);
    let t99 = t98 * t93;
    let t100 = (R::literal(-0.833_333_333_333_333_4) + t75)
        .add_product(t63, t53)
        .sub_product(t77, t70)
        .sub_product(t90, t81);
    let t101 = t100 * t93;
    let t102 = (-(t65 * t53)).sub_product(t79, t70).sub_product(t92, t81);
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t84, t83).sub_product(t95, t94);
    let t105 = (-t23).add_product(t86, t83).sub_product(t97, t94);
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = (t88 * t83).sub_product(t99, t94);
    let t110 = t109 * t104;
    let t111 = (t90 * t83).sub_product(t101, t94);
    let t112 = t111 * t104;
    let t113 = (t92 * t83).sub_product(t103, t94);
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi))
            .sub_product(t20, cos_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t86, t85)
            .sub_product(t97, t96)
            .sub_product(t106, t105);
    let t116 = t24.sub_product(t107, t105);
    let t117 = t116 * t115;
    let t118 = (-t25).add_product(t108, t105);
    let t119 = t118 * t115;
    let t120 = (-(t88 * t85)).sub_product(t99, t96).sub_product(t110, t105);
    let t121 = t120 * t115;
    let t122 = (-(t90 * t85)).sub_product(t101, t96).sub_product(t112, t105);
    let t123 = t122 * t115;
    let t124 = (-(t92 * t85)).sub_product(t103, t96).sub_product(t114, t105);
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t7)
            .sub_product(t107, t26)
            .sub_product(t117, t116);
    let t127 = (t27 * t7).add_product(t108, t26).sub_product(t119, t116);
    let t128 = t127 * t126;
    let t129 = (-(t110 * t26)).sub_product(t121, t116);
    let t130 = t129 * t126;
    let t131 = (-(t112 * t26)).sub_product(t123, t116);
    let t132 = t131 * t126;
    let t133 = (-(t114 * t26)).sub_product(t125, t116);
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, t6)
            .sub_product(t108, t27)
            .sub_product(t119, t118)
            .sub_product(t128, t127);
    let t136 = (t110 * t27).sub_product(t121, t118).sub_product(t130, t127);
    let t137 = t136 * t135;
    let t138 = (t112 * t27).sub_product(t123, t118).sub_product(t132, t127);
    let t139 = t138 * t135;
    let t140 = (t114 * t27).sub_product(t125, t118).sub_product(t134, t127);
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
            - inverse_bobbin_mass)
            .sub_product(t61, t60)
            .sub_product(t74, t73)
            .sub_product(t88, t87)
            .sub_product(t99, t98)
            .sub_product(t110, t109)
            .sub_product(t121, t120)
            .sub_product(t130, t129)
            .sub_product(t137, t136);
    let t143 = (t18 * t10)
        .add_product(t63, t60)
        .sub_product(t77, t73)
        .sub_product(t90, t87)
        .sub_product(t101, t98)
        .sub_product(t112, t109)
        .sub_product(t123, t120)
        .sub_product(t132, t129)
        .sub_product(t139, t136);
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = (-(t65 * t60))
        .sub_product(t79, t73)
        .sub_product(t92, t87)
        .sub_product(t103, t98)
        .sub_product(t114, t109)
        .sub_product(t125, t120)
        .sub_product(t134, t129)
        .sub_product(t141, t136);
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t11)
            - inverse_bobbin_mass)
            .sub_product(t63, t62)
            .sub_product(t77, t76)
            .sub_product(t90, t89)
            .sub_product(t101, t100)
            .sub_product(t112, t111)
            .sub_product(t123, t122)
            .sub_product(t132, t131)
            .sub_product(t139, t138)
            .sub_product(t144, t143);
    let t149 = (-t29).add_product(t145, t143);
    let t150 = t149 * t148;
    let t151 = (t65 * t62)
        .sub_product(t79, t76)
        .sub_product(t92, t89)
        .sub_product(t103, t100)
        .sub_product(t114, t111)
        .sub_product(t125, t122)
        .sub_product(t134, t131)
        .sub_product(t141, t138)
        .sub_product(t147, t143);
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between))
            .sub_product(t29, bobbin_y_minus_drum_y_over_between)
            .sub_product(t30, bobbin_x_minus_drum_x_over_between)
            .sub_product(t31, bobbin_y_minus_drum_y_over_between)
            .sub_product(t145, t28)
            .sub_product(t150, t149)
            .sub_product(t153, t30)
            .sub_product(t154, t31);
    let t156 = (t147 * t28).sub_product(t152, t149);
    let t157 = t156 * t155;
    let t158 = R::literal(1.0)
        / (-(t14 * t9))
            .sub_product(t40, t39)
            .sub_product(t50, t49)
            .sub_product(t65, t64)
            .sub_product(t79, t78)
            .sub_product(t92, t91)
            .sub_product(t103, t102)
            .sub_product(t114, t113)
            .sub_product(t125, t124)
            .sub_product(t134, t133)
            .sub_product(t141, t140)
            .sub_product(t147, t146)
            .sub_product(t152, t151)
            .sub_product(t157, t156);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t159 = R::literal(50.0) * slide_rate;
    let t160 = t159 * cos_cylinder_phi;
    let slide_minus_spring_free_length = slide - p.spring_free_length;
    let t161 = p.spring_stiffness * slide_minus_spring_free_length;
    let t162 = t161 * cos_cylinder_phi;
    let t163 = t160 + t162;
    let t164 = t161 * sin_cylinder_phi;
    let t165 = t159 * sin_cylinder_phi;
    let t166 = t165 - (R::literal(2.943) - t164);
    let t167 = (-(t161 * t8)).sub_product(t159, t8);
    let t168 = -t160 - t162;
    let t169 = -t165 - (R::literal(1.962) + t164);
    let t170 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t171 = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t172 = R::literal(0.1) * post_omega_squared;
    let t173 = t172 * cos_post_phi;
    let t174 = t172 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t175 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
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
    let t185 = (bobbin_v_x
        * (bobbin_v_x_over_between + t179 + t180 - t177 - t178 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t183 + t184 - t181 - t182 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t177 + t178 + drum_v_x_over_between - bobbin_v_x_over_between - t179 - t180,
        )
        .add_product(
            drum_v_y,
            t181 + t182 + drum_v_y_over_between - bobbin_v_y_over_between - t183 - t184,
        );
    let t186 = t36 * t173;
    let t187 = -t174 - R::literal(-9.81) + t186;
    let t188 = t15 * bobbin_radius_times_winding_force;
    let t189 = (t188 - t173.add_product(t175, cos_plate_phi))
        .add_product(t38, t173)
        .sub_product(t46, t187);
    let t190 = t16 * bobbin_radius_times_winding_force;
    let t191 = (-t174.add_product(t175, sin_plate_phi) - R::literal(9.81)
        - R::literal(-9.81) - t190 + t186)
        .sub_product(t48, t187)
        .sub_product(t55, t189);
    let t192 = t188
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(R::literal(3.333_333_333_333_333_5), t163)
        .sub_product(t21, t167)
        .sub_product(t57, t189)
        .sub_product(t69, t191);
    let t193 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t190)
        .sub_product(R::literal(3.333_333_333_333_333_5), t166)
        .add_product(t22, t167)
        .sub_product(t58, t189)
        .sub_product(t71, t191)
        .sub_product(t82, t192);
    let t194 = (-(R::literal(-2_777.777_777_777_778) * t167))
        .add_product(t84, t192)
        .sub_product(t95, t193);
    let t195 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t163)
        .add_product(t20, t166)
        .add_product(t23, t167)
        .add_product(t24, t168)
        .sub_product(t25, t169)
        .sub_product(t86, t192)
        .sub_product(t97, t193);
    let t196 = t195.sub_product(t106, t194);
    let t197 = (t176 * cos_rod_phi)
        .sub_product(R::literal(5.0), t168)
        .sub_product(t107, t194)
        .sub_product(t117, t196);
    let t198 = (t176 * sin_rod_phi)
        .sub_product(R::literal(5.0), t169)
        .add_product(t108, t194)
        .sub_product(t119, t196)
        .sub_product(t128, t197);
    let t199 = inverse_bobbin_mass * t170;
    let t200 = ((t11 * plate_omega_squared)
        .sub_product(t17, bobbin_radius_times_winding_force) + t199)
        .sub_product(t61, t189)
        .sub_product(t74, t191)
        .sub_product(t88, t192)
        .sub_product(t99, t193)
        .sub_product(t110, t194)
        .sub_product(t121, t196)
        .sub_product(t130, t197)
        .sub_product(t137, t198);
    let t201 = inverse_bobbin_mass * t171;
    let t202 = (R::literal(-9.81)
        .add_product(t10, plate_omega_squared)
        .add_product(t18, bobbin_radius_times_winding_force) - t201)
        .add_product(t63, t189)
        .sub_product(t77, t191)
        .sub_product(t90, t192)
        .sub_product(t101, t193)
        .sub_product(t112, t194)
        .sub_product(t123, t196)
        .sub_product(t132, t197)
        .sub_product(t139, t198)
        .sub_product(t144, t200);
    let t203 = (-t185)
        .add_product(t28, t170)
        .sub_product(t29, t171)
        .add_product(t31, R::literal(-14.715))
        .add_product(t145, t200)
        .sub_product(t150, t202)
        .sub_product(t154, R::literal(9.809_999_999_999_999));
    let t204 = ((R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared)
        .sub_product(t40, t173)
        .sub_product(t50, t187)
        .sub_product(t65, t189)
        .sub_product(t79, t191)
        .sub_product(t92, t192)
        .sub_product(t103, t193)
        .sub_product(t114, t194)
        .sub_product(t125, t196)
        .sub_product(t134, t197)
        .sub_product(t141, t198)
        .sub_product(t147, t200)
        .sub_product(t152, t202)
        .sub_product(t157, t203) * t158;
    let t205 = (t203 * t155).sub_product(t157, t204);
    let t206 = (t202 * t148).sub_product(t150, t205).sub_product(t152, t204);
    let bobbin_v_y_dot = t201
        .sub_product(inverse_bobbin_mass, t206)
        .sub_product(t29, t205);
    let t207 = p.spring_stiffness * cos_cylinder_phi;
    let t208 = p.spring_stiffness * t8;
    let t209 = p.spring_stiffness * sin_cylinder_phi;
    let t210 = t15 * p.winding_force;
    let t211 = -(t16 * p.winding_force);
    let t212 = t211.sub_product(t55, t210);
    let t213 = t210.sub_product(t57, t210).sub_product(t69, t212);
    let t214 = t211.sub_product(t58, t210).sub_product(t71, t212).sub_product(t82, t213);
    let t215 = (t84 * t213).sub_product(t95, t214);
    let t216 = (-(t86 * t213)).sub_product(t97, t214).sub_product(t106, t215);
    let t217 = (-(t107 * t215)).sub_product(t117, t216);
    let t218 = (t108 * t215).sub_product(t119, t216).sub_product(t128, t217);
    let t219 = (-(t17 * p.winding_force))
        .sub_product(t61, t210)
        .sub_product(t74, t212)
        .sub_product(t88, t213)
        .sub_product(t99, t214)
        .sub_product(t110, t215)
        .sub_product(t121, t216)
        .sub_product(t130, t217)
        .sub_product(t137, t218);
    let t220 = (t18 * p.winding_force)
        .add_product(t63, t210)
        .sub_product(t77, t212)
        .sub_product(t90, t213)
        .sub_product(t101, t214)
        .sub_product(t112, t215)
        .sub_product(t123, t216)
        .sub_product(t132, t217)
        .sub_product(t139, t218)
        .sub_product(t144, t219);
    let t221 = (t145 * t219).sub_product(t150, t220);
    let t222 = (-(t65 * t210))
        .sub_product(t79, t212)
        .sub_product(t92, t213)
        .sub_product(t103, t214)
        .sub_product(t114, t215)
        .sub_product(t125, t216)
        .sub_product(t134, t217)
        .sub_product(t141, t218)
        .sub_product(t147, t219)
        .sub_product(t152, t220)
        .sub_product(t157, t221) * t158;
    let t223 = (t221 * t155).sub_product(t157, t222);
    let t224 = (t220 * t148).sub_product(t150, t223).sub_product(t152, t222);
    let t225 = (t219 * t142)
        .sub_product(t144, t224)
        .add_product(t145, t223)
        .sub_product(t147, t222);
    let t226 = (t218 * t135)
        .sub_product(t137, t225)
        .sub_product(t139, t224)
        .sub_product(t141, t222);
    let t227 = (t217 * t126)
        .sub_product(t128, t226)
        .sub_product(t130, t225)
        .sub_product(t132, t224)
        .sub_product(t134, t222);
    let t228 = (t216 * t115)
        .sub_product(t117, t227)
        .sub_product(t119, t226)
        .sub_product(t121, t225)
        .sub_product(t123, t224)
        .sub_product(t125, t222);
    let t229 = (t215 * t104)
        .sub_product(t106, t228)
        .sub_product(t107, t227)
        .add_product(t108, t226)
        .sub_product(t110, t225)
        .sub_product(t112, t224)
        .sub_product(t114, t222);
    let t230 = (t214 * t93)
        .sub_product(t95, t229)
        .sub_product(t97, t228)
        .sub_product(t99, t225)
        .sub_product(t101, t224)
        .sub_product(t103, t222);
    let t231 = (t213 * t80)
        .sub_product(t82, t230)
        .add_product(t84, t229)
        .sub_product(t86, t228)
        .sub_product(t88, t225)
        .sub_product(t90, t224)
        .sub_product(t92, t222);
    let t232 = (t212 * t67)
        .sub_product(t69, t231)
        .sub_product(t71, t230)
        .sub_product(t74, t225)
        .sub_product(t77, t224)
        .sub_product(t79, t222);
    let t233 = (t210 * t52)
        .sub_product(t55, t232)
        .sub_product(t57, t231)
        .sub_product(t58, t230)
        .sub_product(t61, t225)
        .add_product(t63, t224)
        .sub_product(t65, t222);
    let t234 = (-(t48 * t232)).sub_product(t46, t233).sub_product(t50, t222);
    let t235 = (-(t38 * t233))
        .sub_product(t36, t234)
        .sub_product(t36, t232)
        .add_product(t40, t222);
    let drum_v_y_dot_by_bobbin_radius = (t31 * t223)
        .add_product(R::literal(0.666_666_666_666_666_6), t154 * t223);
    let drum_v_x_dot_by_bobbin_radius = (t30 * t223)
        .add_product(R::literal(0.666_666_666_666_666_6), t153 * t223);
    let bobbin_v_y_dot_by_bobbin_radius = (-(t29 * t223))
        .sub_product(inverse_bobbin_mass, t224);
    let bobbin_v_x_dot_by_bobbin_radius = (-(t28 * t223))
        .sub_product(inverse_bobbin_mass, t225);
    let rod_omega_dot_by_bobbin_radius = (t26 * t227)
        .sub_product(R::literal(4_166.666_666_666_667), t229)
        .sub_product(t27, t226);
    let rod_v_y_dot_by_bobbin_radius = (-(R::literal(5.0) * t226))
        .sub_product(t25, t228);
    let rod_v_x_dot_by_bobbin_radius = (-(R::literal(5.0) * t227))
        .add_product(t24, t228);
    let cylinder_omega_dot_by_bobbin_radius = (t22 * t230)
        .sub_product(t21, t231)
        .sub_product(R::literal(-2_777.777_777_777_778), t229)
        .add_product(t23, t228);
    let cylinder_v_y_dot_by_bobbin_radius = (t20 * t228)
        .sub_product(R::literal(3.333_333_333_333_333_5), t230);
    let cylinder_v_x_dot_by_bobbin_radius = (-(t19 * t228))
        .sub_product(R::literal(3.333_333_333_333_333_5), t231);
    let plate_omega_dot_by_bobbin_radius = (-(p.winding_force * R::literal(400.0)))
        .sub_product(t15, t233)
        .add_product(t16, t232)
        .sub_product(t15, t231)
        .add_product(t16, t230)
        .add_product(t17, t225)
        .sub_product(t18, t224);
    let plate_v_y_dot_by_bobbin_radius = (-(R::literal(-0.833_333_333_333_333_4) * t230))
        .sub_product(R::literal(0.833_333_333_333_333_4), t232)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t224);
    let plate_v_x_dot_by_bobbin_radius = (-(R::literal(-0.833_333_333_333_333_4) * t231))
        .sub_product(R::literal(0.833_333_333_333_333_4), t233)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t225);
    let post_omega_dot_by_bobbin_radius = (t13 * t234)
        .sub_product(t12, t235)
        .sub_product(t12, t233)
        .add_product(t13, t232)
        .sub_product(t14, t222);
    let post_v_y_dot_by_bobbin_radius = (-(R::literal(-1.25) * t232))
        .sub_product(R::literal(1.25), t234);
    let post_v_x_dot_by_bobbin_radius = (-(R::literal(-1.25) * t233))
        .sub_product(R::literal(1.25), t235);
    let t236 = t15 * p.bobbin_radius;
    let t237 = -(t16 * p.bobbin_radius);
    let t238 = t237.sub_product(t55, t236);
    let t239 = t236.sub_product(t57, t236).sub_product(t69, t238);
    let t240 = t237.sub_product(t58, t236).sub_product(t71, t238).sub_product(t82, t239);
    let t241 = (t84 * t239).sub_product(t95, t240);
    let t242 = (-(t86 * t239)).sub_product(t97, t240).sub_product(t106, t241);
    let t243 = (-(t107 * t241)).sub_product(t117, t242);
    let t244 = (t108 * t241).sub_product(t119, t242).sub_product(t128, t243);
    let t245 = t29
        .sub_product(t17, p.bobbin_radius)
        .sub_product(t61, t236)
        .sub_product(t74, t238)
        .sub_product(t88, t239)
        .sub_product(t99, t240)
        .sub_product(t110, t241)
        .sub_product(t121, t242)
        .sub_product(t130, t243)
        .sub_product(t137, t244);
    let t246 = (-t28)
        .add_product(t18, p.bobbin_radius)
        .add_product(t63, t236)
        .sub_product(t77, t238)
        .sub_product(t90, t239)
        .sub_product(t101, t240)
        .sub_product(t112, t241)
        .sub_product(t123, t242)
        .sub_product(t132, t243)
        .sub_product(t139, t244)
        .sub_product(t144, t245);
    let t247 = (t28 * bobbin_y_minus_drum_y_over_between)
        .sub_product(t29, bobbin_x_minus_drum_x_over_between)
        .add_product(t145, t245)
        .sub_product(t150, t246);
    let t248 = (-(t65 * t236))
        .sub_product(t79, t238)
        .sub_product(t92, t239)
        .sub_product(t103, t240)
        .sub_product(t114, t241)
        .sub_product(t125, t242)
        .sub_product(t134, t243)
        .sub_product(t141, t244)
        .sub_product(t147, t245)
        .sub_product(t152, t246)
        .sub_product(t157, t247) * t158;
    let t249 = (t247 * t155).sub_product(t157, t248);
    let t250 = (t246 * t148).sub_product(t150, t249).sub_product(t152, t248);
    let t251 = (t245 * t142)
        .sub_product(t144, t250)
        .add_product(t145, t249)
        .sub_product(t147, t248);
    let t252 = (t244 * t135)
        .sub_product(t137, t251)
        .sub_product(t139, t250)
        .sub_product(t141, t248);
    let t253 = (t243 * t126)
        .sub_product(t128, t252)
        .sub_product(t130, t251)
        .sub_product(t132, t250)
        .sub_product(t134, t248);
    let t254 = (t242 * t115)
        .sub_product(t117, t253)
        .sub_product(t119, t252)
        .sub_product(t121, t251)
        .sub_product(t123, t250)
        .sub_product(t125, t248);
    let t255 = (t241 * t104)
        .sub_product(t106, t254)
        .sub_product(t107, t253)
        .add_product(t108, t252)
        .sub_product(t110, t251)
        .sub_product(t112, t250)
        .sub_product(t114, t248);
    let t256 = (t240 * t93)
        .sub_product(t95, t255)
        .sub_product(t97, t254)
        .sub_product(t99, t251)
        .sub_product(t101, t250)
        .sub_product(t103, t248);
    let t257 = (t239 * t80)
        .sub_product(t82, t256)
        .add_product(t84, t255)
        .sub_product(t86, t254)
        .sub_product(t88, t251)
        .sub_product(t90, t250)
        .sub_product(t92, t248);
    let t258 = (t238 * t67)
        .sub_product(t69, t257)
        .sub_product(t71, t256)
        .sub_product(t74, t251)
        .sub_product(t77, t250)
        .sub_product(t79, t248);
    let t259 = (t236 * t52)
        .sub_product(t55, t258)
        .sub_product(t57, t257)
        .sub_product(t58, t256)
        .sub_product(t61, t251)
        .add_product(t63, t250)
        .sub_product(t65, t248);
    let t260 = (-(t48 * t258)).sub_product(t46, t259).sub_product(t50, t248);
    let t261 = (-(t38 * t259))
        .sub_product(t36, t260)
        .sub_product(t36, t258)
        .add_product(t40, t248);
    let drum_v_y_dot_by_winding_force = (t31 * t249)
        .add_product(R::literal(0.666_666_666_666_666_6), t154 * t249);
    let drum_v_x_dot_by_winding_force = (t30 * t249)
        .add_product(R::literal(0.666_666_666_666_666_6), t153 * t249);
    let bobbin_v_y_dot_by_winding_force = t28
        .sub_product(inverse_bobbin_mass, t250)
        .sub_product(t29, t249);
    let bobbin_v_x_dot_by_winding_force = (-t29)
        .sub_product(inverse_bobbin_mass, t251)
        .sub_product(t28, t249);
    let rod_omega_dot_by_winding_force = (t26 * t253)
        .sub_product(R::literal(4_166.666_666_666_667), t255)
        .sub_product(t27, t252);
    let rod_v_y_dot_by_winding_force = (-(R::literal(5.0) * t252))
        .sub_product(t25, t254);
    let rod_v_x_dot_by_winding_force = (-(R::literal(5.0) * t253))
        .add_product(t24, t254);
    let cylinder_omega_dot_by_winding_force = (t22 * t256)
        .sub_product(t21, t257)
        .sub_product(R::literal(-2_777.777_777_777_778), t255)
        .add_product(t23, t254);
    let cylinder_v_y_dot_by_winding_force = (t20 * t254)
        .sub_product(R::literal(3.333_333_333_333_333_5), t256);
    let cylinder_v_x_dot_by_winding_force = (-(t19 * t254))
        .sub_product(R::literal(3.333_333_333_333_333_5), t257);
    let plate_omega_dot_by_winding_force = (-(p.bobbin_radius * R::literal(400.0)))
        .sub_product(t15, t259)
        .add_product(t16, t258)
        .sub_product(t15, t257)
        .add_product(t16, t256)
        .add_product(t17, t251)
        .sub_product(t18, t250);
    let plate_v_y_dot_by_winding_force = (-(R::literal(-0.833_333_333_333_333_4) * t256))
        .sub_product(R::literal(0.833_333_333_333_333_4), t258)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t250);
    let plate_v_x_dot_by_winding_force = (-(R::literal(-0.833_333_333_333_333_4) * t257))
        .sub_product(R::literal(0.833_333_333_333_333_4), t259)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t251);
    let post_omega_dot_by_winding_force = (t13 * t260)
        .sub_product(t12, t261)
        .sub_product(t12, t259)
        .add_product(t13, t258)
        .sub_product(t14, t248);
    let post_v_y_dot_by_winding_force = (-(R::literal(-1.25) * t258))
        .sub_product(R::literal(1.25), t260);
    let post_v_x_dot_by_winding_force = (-(R::literal(-1.25) * t259))
        .sub_product(R::literal(1.25), t261);
    let t262 = (-(-t199)
        .sub_product(
            inverse_bobbin_mass,
            (t200 * t142)
                .sub_product(t144, t206)
                .add_product(t145, t205)
                .sub_product(t147, t204),
        ))
        .add_product(t28, t205);
    let t263 = R::literal(-9.81) - bobbin_v_y_dot;
    let t264 = inverse_bobbin_mass * t262;
    let t265 = inverse_bobbin_mass * t263;
    let t266 = (-t265).add_product(t144, t264);
    let t267 = (-(t29 * t263))
        .sub_product(t28, t262)
        .sub_product(t145, t264)
        .sub_product(t150, t266);
    let t268 = (t147 * t264).sub_product(t152, t266).sub_product(t157, t267) * t158;
    let t269 = (t267 * t155).sub_product(t157, t268);
    let t270 = (t266 * t148).sub_product(t150, t269).sub_product(t152, t268);
    let t271 = (-(t264 * t142))
        .sub_product(t144, t270)
        .add_product(t145, t269)
        .sub_product(t147, t268);
    let t272 = (-(t139 * t270)).sub_product(t137, t271).sub_product(t141, t268);
    let t273 = (-(t130 * t271))
        .sub_product(t128, t272)
        .sub_product(t132, t270)
        .sub_product(t134, t268);
    let t274 = (-(t119 * t272))
        .sub_product(t117, t273)
        .sub_product(t121, t271)
        .sub_product(t123, t270)
        .sub_product(t125, t268);
    let t275 = (-(t107 * t273))
        .sub_product(t106, t274)
        .add_product(t108, t272)
        .sub_product(t110, t271)
        .sub_product(t112, t270)
        .sub_product(t114, t268);
    let t276 = (-(t97 * t274))
        .sub_product(t95, t275)
        .sub_product(t99, t271)
        .sub_product(t101, t270)
        .sub_product(t103, t268);
    let t277 = (t84 * t275)
        .sub_product(t82, t276)
        .sub_product(t86, t274)
        .sub_product(t88, t271)
        .sub_product(t90, t270)
        .sub_product(t92, t268);
    let t278 = (-(t71 * t276))
        .sub_product(t69, t277)
        .sub_product(t74, t271)
        .sub_product(t77, t270)
        .sub_product(t79, t268);
    let t279 = (-(t57 * t277))
        .sub_product(t55, t278)
        .sub_product(t58, t276)
        .sub_product(t61, t271)
        .add_product(t63, t270)
        .sub_product(t65, t268);
    let t280 = (-(t48 * t278)).sub_product(t46, t279).sub_product(t50, t268);
    let t281 = (-(t38 * t279))
        .sub_product(t36, t280)
        .sub_product(t36, t278)
        .add_product(t40, t268);
    let drum_v_y_dot_by_bobbin_mass = (t31 * t269)
        .add_product(R::literal(0.666_666_666_666_666_6), t154 * t269);
    let drum_v_x_dot_by_bobbin_mass = (t30 * t269)
        .add_product(R::literal(0.666_666_666_666_666_6), t153 * t269);
    let bobbin_v_y_dot_by_bobbin_mass = t265
        .sub_product(inverse_bobbin_mass, t270)
        .sub_product(t29, t269);
    let bobbin_v_x_dot_by_bobbin_mass = t264
        .sub_product(inverse_bobbin_mass, t271)
        .sub_product(t28, t269);
    let rod_omega_dot_by_bobbin_mass = (t26 * t273)
        .sub_product(R::literal(4_166.666_666_666_667), t275)
        .sub_product(t27, t272);
    let rod_v_y_dot_by_bobbin_mass = (-(R::literal(5.0) * t272)).sub_product(t25, t274);
    let rod_v_x_dot_by_bobbin_mass = (-(R::literal(5.0) * t273)).add_product(t24, t274);
    let cylinder_omega_dot_by_bobbin_mass = (t22 * t276)
        .sub_product(t21, t277)
        .sub_product(R::literal(-2_777.777_777_777_778), t275)
        .add_product(t23, t274);
    let cylinder_v_y_dot_by_bobbin_mass = (t20 * t274)
        .sub_product(R::literal(3.333_333_333_333_333_5), t276);
    let cylinder_v_x_dot_by_bobbin_mass = (-(t19 * t274))
        .sub_product(R::literal(3.333_333_333_333_333_5), t277);
    let plate_omega_dot_by_bobbin_mass = (t16 * t278)
        .sub_product(t15, t279)
        .sub_product(t15, t277)
        .add_product(t16, t276)
        .add_product(t17, t271)
        .sub_product(t18, t270);
    let plate_v_y_dot_by_bobbin_mass = (-(R::literal(-0.833_333_333_333_333_4) * t276))
        .sub_product(R::literal(0.833_333_333_333_333_4), t278)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t270);
    let plate_v_x_dot_by_bobbin_mass = (-(R::literal(-0.833_333_333_333_333_4) * t277))
        .sub_product(R::literal(0.833_333_333_333_333_4), t279)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t271);
    let post_omega_dot_by_bobbin_mass = (t13 * t280)
        .sub_product(t12, t281)
        .sub_product(t12, t279)
        .add_product(t13, t278)
        .sub_product(t14, t268);
    let post_v_y_dot_by_bobbin_mass = (-(R::literal(-1.25) * t278))
        .sub_product(R::literal(1.25), t280);
    let post_v_x_dot_by_bobbin_mass = (-(R::literal(-1.25) * t279))
        .sub_product(R::literal(1.25), t281);
    let t282 = slide_minus_spring_free_length * cos_cylinder_phi;
    let t283 = slide_minus_spring_free_length * sin_cylinder_phi;
    let t284 = slide_minus_spring_free_length * t8;
    let t285 = R::literal(3.333_333_333_333_333_5) * t282;
    let t286 = (-t285).add_product(t21, t284);
    let t287 = R::literal(3.333_333_333_333_333_5) * t283;
    let t288 = (-t287).sub_product(t22, t284).sub_product(t82, t286);
    let t289 = (R::literal(-2_777.777_777_777_778) * t284)
        .add_product(t84, t286)
        .sub_product(t95, t288);
    let t290 = (t20 * t283)
        .sub_product(t19, t282)
        .sub_product(t23, t284)
        .sub_product(t24, t282)
        .add_product(t25, t283)
        .sub_product(t86, t286)
        .sub_product(t97, t288)
        .sub_product(t106, t289);
    let t291 = R::literal(5.0) * t282;
    let t292 = t291.sub_product(t107, t289).sub_product(t117, t290);
    let t293 = R::literal(5.0) * t283;
    let t294 = t293
        .add_product(t108, t289)
        .sub_product(t119, t290)
        .sub_product(t128, t292);
    let t295 = (-(t88 * t286))
        .sub_product(t99, t288)
        .sub_product(t110, t289)
        .sub_product(t121, t290)
        .sub_product(t130, t292)
        .sub_product(t137, t294);
    let t296 = (-(t90 * t286))
        .sub_product(t101, t288)
        .sub_product(t112, t289)
        .sub_product(t123, t290)
        .sub_product(t132, t292)
        .sub_product(t139, t294)
        .sub_product(t144, t295);
    let t297 = (t145 * t295).sub_product(t150, t296);
    let t298 = (-(t92 * t286))
        .sub_product(t103, t288)
        .sub_product(t114, t289)
        .sub_product(t125, t290)
        .sub_product(t134, t292)
        .sub_product(t141, t294)
        .sub_product(t147, t295)
        .sub_product(t152, t296)
        .sub_product(t157, t297) * t158;
    let t299 = (t297 * t155).sub_product(t157, t298);
    let t300 = (t296 * t148).sub_product(t150, t299).sub_product(t152, t298);
    let t301 = (t295 * t142)
        .sub_product(t144, t300)
        .add_product(t145, t299)
        .sub_product(t147, t298);
    let t302 = (t294 * t135)
        .sub_product(t137, t301)
        .sub_product(t139, t300)
        .sub_product(t141, t298);
    let t303 = (t292 * t126)
        .sub_product(t128, t302)
        .sub_product(t130, t301)
        .sub_product(t132, t300)
        .sub_product(t134, t298);
    let t304 = (t290 * t115)
        .sub_product(t117, t303)
        .sub_product(t119, t302)
        .sub_product(t121, t301)
        .sub_product(t123, t300)
        .sub_product(t125, t298);
    let t305 = (t289 * t104)
        .sub_product(t106, t304)
        .sub_product(t107, t303)
        .add_product(t108, t302)
        .sub_product(t110, t301)
        .sub_product(t112, t300)
        .sub_product(t114, t298);
    let t306 = (t288 * t93)
        .sub_product(t95, t305)
        .sub_product(t97, t304)
        .sub_product(t99, t301)
        .sub_product(t101, t300)
        .sub_product(t103, t298);
    let t307 = (t286 * t80)
        .sub_product(t82, t306)
        .add_product(t84, t305)
        .sub_product(t86, t304)
        .sub_product(t88, t301)
        .sub_product(t90, t300)
        .sub_product(t92, t298);
    let t308 = (-(t71 * t306))
        .sub_product(t69, t307)
        .sub_product(t74, t301)
        .sub_product(t77, t300)
        .sub_product(t79, t298);
    let t309 = (-(t57 * t307))
        .sub_product(t55, t308)
        .sub_product(t58, t306)
        .sub_product(t61, t301)
        .add_product(t63, t300)
        .sub_product(t65, t298);
    let t310 = (-(t48 * t308)).sub_product(t46, t309).sub_product(t50, t298);
    let t311 = (-(t38 * t309))
        .sub_product(t36, t310)
        .sub_product(t36, t308)
        .add_product(t40, t298);
    let drum_v_y_dot_by_spring_stiffness = (t31 * t299)
        .add_product(R::literal(0.666_666_666_666_666_6), t154 * t299);
    let drum_v_x_dot_by_spring_stiffness = (t30 * t299)
        .add_product(R::literal(0.666_666_666_666_666_6), t153 * t299);
    let bobbin_v_y_dot_by_spring_stiffness = (-(t29 * t299))
        .sub_product(inverse_bobbin_mass, t300);
    let bobbin_v_x_dot_by_spring_stiffness = (-(t28 * t299))
        .sub_product(inverse_bobbin_mass, t301);
    let rod_omega_dot_by_spring_stiffness = (t26 * t303)
        .sub_product(R::literal(4_166.666_666_666_667), t305)
        .sub_product(t27, t302);
    let rod_v_y_dot_by_spring_stiffness = (-t293)
        .sub_product(t25, t304)
        .sub_product(R::literal(5.0), t302);
    let rod_v_x_dot_by_spring_stiffness = (-t291)
        .add_product(t24, t304)
        .sub_product(R::literal(5.0), t303);
    let cylinder_omega_dot_by_spring_stiffness = (-(t284
        * R::literal(2_777.777_777_777_778)))
        .sub_product(t21, t307)
        .add_product(t22, t306)
        .sub_product(R::literal(-2_777.777_777_777_778), t305)
        .add_product(t23, t304);
    let cylinder_v_y_dot_by_spring_stiffness = t287
        .sub_product(R::literal(3.333_333_333_333_333_5), t306)
        .add_product(t20, t304);
    let cylinder_v_x_dot_by_spring_stiffness = t285
        .sub_product(R::literal(3.333_333_333_333_333_5), t307)
        .sub_product(t19, t304);
    let plate_omega_dot_by_spring_stiffness = (t16 * t308)
        .sub_product(t15, t309)
        .sub_product(t15, t307)
        .add_product(t16, t306)
        .add_product(t17, t301)
        .sub_product(t18, t300);
    let plate_v_y_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t306))
        .sub_product(R::literal(0.833_333_333_333_333_4), t308)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t300);
    let plate_v_x_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t307))
        .sub_product(R::literal(0.833_333_333_333_333_4), t309)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t301);
    let post_omega_dot_by_spring_stiffness = (t13 * t310)
        .sub_product(t12, t311)
        .sub_product(t12, t309)
        .add_product(t13, t308)
        .sub_product(t14, t298);
    let post_v_y_dot_by_spring_stiffness = (-(R::literal(-1.25) * t308))
        .sub_product(R::literal(1.25), t310);
    let post_v_x_dot_by_spring_stiffness = (-(R::literal(-1.25) * t309))
        .sub_product(R::literal(1.25), t311);
    let t312 = R::literal(3.333_333_333_333_333_5) * t207;
    let t313 = t312.sub_product(t21, t208);
    let t314 = R::literal(3.333_333_333_333_333_5) * t209;
    let t315 = t314.add_product(t22, t208).sub_product(t82, t313);
    let t316 = (-(R::literal(-2_777.777_777_777_778) * t208))
        .add_product(t84, t313)
        .sub_product(t95, t315);
    let t317 = (t19 * t207)
        .sub_product(t20, t209)
        .add_product(t23, t208)
        .add_product(t24, t207)
        .sub_product(t25, t209)
        .sub_product(t86, t313)
        .sub_product(t97, t315)
        .sub_product(t106, t316);
    let t318 = R::literal(5.0) * t207;
    let t319 = (-t318).sub_product(t107, t316).sub_product(t117, t317);
    let t320 = R::literal(5.0) * t209;
    let t321 = (-t320)
        .add_product(t108, t316)
        .sub_product(t119, t317)
        .sub_product(t128, t319);
    let t322 = (-(t88 * t313))
        .sub_product(t99, t315)
        .sub_product(t110, t316)
        .sub_product(t121, t317)
        .sub_product(t130, t319)
        .sub_product(t137, t321);
    let t323 = (-(t90 * t313))
        .sub_product(t101, t315)
        .sub_product(t112, t316)
        .sub_product(t123, t317)
        .sub_product(t132, t319)
        .sub_product(t139, t321)
        .sub_product(t144, t322);
    let t324 = (t145 * t322).sub_product(t150, t323);
    let t325 = (-(t92 * t313))
        .sub_product(t103, t315)
        .sub_product(t114, t316)
        .sub_product(t125, t317)
        .sub_product(t134, t319)
        .sub_product(t141, t321)
        .sub_product(t147, t322)
        .sub_product(t152, t323)
        .sub_product(t157, t324) * t158;
    let t326 = (t324 * t155).sub_product(t157, t325);
    let t327 = (t323 * t148).sub_product(t150, t326).sub_product(t152, t325);
    let t328 = (t322 * t142)
        .sub_product(t144, t327)
        .add_product(t145, t326)
        .sub_product(t147, t325);
    let t329 = (t321 * t135)
        .sub_product(t137, t328)
        .sub_product(t139, t327)
        .sub_product(t141, t325);
    let t330 = (t319 * t126)
        .sub_product(t128, t329)
        .sub_product(t130, t328)
        .sub_product(t132, t327)
        .sub_product(t134, t325);
    let t331 = (t317 * t115)
        .sub_product(t117, t330)
        .sub_product(t119, t329)
        .sub_product(t121, t328)
        .sub_product(t123, t327)
        .sub_product(t125, t325);
    let t332 = (t316 * t104)
        .sub_product(t106, t331)
        .sub_product(t107, t330)
        .add_product(t108, t329)
        .sub_product(t110, t328)
        .sub_product(t112, t327)
        .sub_product(t114, t325);
    let t333 = (t315 * t93)
        .sub_product(t95, t332)
        .sub_product(t97, t331)
        .sub_product(t99, t328)
        .sub_product(t101, t327)
        .sub_product(t103, t325);
    let t334 = (t313 * t80)
        .sub_product(t82, t333)
        .add_product(t84, t332)
        .sub_product(t86, t331)
        .sub_product(t88, t328)
        .sub_product(t90, t327)
        .sub_product(t92, t325);
    let t335 = (-(t71 * t333))
        .sub_product(t69, t334)
        .sub_product(t74, t328)
        .sub_product(t77, t327)
        .sub_product(t79, t325);
    let t336 = (-(t57 * t334))
        .sub_product(t55, t335)
        .sub_product(t58, t333)
        .sub_product(t61, t328)
        .add_product(t63, t327)
        .sub_product(t65, t325);
    let t337 = (-(t48 * t335)).sub_product(t46, t336).sub_product(t50, t325);
    let t338 = (-(t38 * t336))
        .sub_product(t36, t337)
        .sub_product(t36, t335)
        .add_product(t40, t325);
    let drum_v_y_dot_by_spring_free_length = (t31 * t326)
        .add_product(R::literal(0.666_666_666_666_666_6), t154 * t326);
    let drum_v_x_dot_by_spring_free_length = (t30 * t326)
        .add_product(R::literal(0.666_666_666_666_666_6), t153 * t326);
    let bobbin_v_y_dot_by_spring_free_length = (-(t29 * t326))
        .sub_product(inverse_bobbin_mass, t327);
    let bobbin_v_x_dot_by_spring_free_length = (-(t28 * t326))
        .sub_product(inverse_bobbin_mass, t328);
    let rod_omega_dot_by_spring_free_length = (t26 * t330)
        .sub_product(R::literal(4_166.666_666_666_667), t332)
        .sub_product(t27, t329);
    let rod_v_y_dot_by_spring_free_length = t320
        .sub_product(t25, t331)
        .sub_product(R::literal(5.0), t329);
    let rod_v_x_dot_by_spring_free_length = t318
        .add_product(t24, t331)
        .sub_product(R::literal(5.0), t330);
    let cylinder_omega_dot_by_spring_free_length = (t208
        * R::literal(2_777.777_777_777_778))
        .sub_product(t21, t334)
        .add_product(t22, t333)
        .sub_product(R::literal(-2_777.777_777_777_778), t332)
        .add_product(t23, t331);
    let cylinder_v_y_dot_by_spring_free_length = (-t314)
        .sub_product(R::literal(3.333_333_333_333_333_5), t333)
        .add_product(t20, t331);
    let cylinder_v_x_dot_by_spring_free_length = (-t312)
        .sub_product(R::literal(3.333_333_333_333_333_5), t334)
        .sub_product(t19, t331);
    let plate_omega_dot_by_spring_free_length = (t16 * t335)
        .sub_product(t15, t336)
        .sub_product(t15, t334)
        .add_product(t16, t333)
        .add_product(t17, t328)
        .sub_product(t18, t327);
    let plate_v_y_dot_by_spring_free_length = (-(R::literal(-0.833_333_333_333_333_4)
        * t333))
        .sub_product(R::literal(0.833_333_333_333_333_4), t335)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t327);
    let plate_v_x_dot_by_spring_free_length = (-(R::literal(-0.833_333_333_333_333_4)
        * t334))
        .sub_product(R::literal(0.833_333_333_333_333_4), t336)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t328);
    let post_omega_dot_by_spring_free_length = (t13 * t337)
        .sub_product(t12, t338)
        .sub_product(t12, t336)
        .add_product(t13, t335)
        .sub_product(t14, t325);
    let post_v_y_dot_by_spring_free_length = (-(R::literal(-1.25) * t335))
        .sub_product(R::literal(1.25), t337);
    let post_v_x_dot_by_spring_free_length = (-(R::literal(-1.25) * t336))
        .sub_product(R::literal(1.25), t338);
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
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t8 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t8)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t9 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
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
    let t45 = (t12 * t0).sub_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).add_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51)
            .sub_product(t38, t37)
            .sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).sub_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = (-t39).add_product(t40, t37).sub_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43)
            .sub_product(t48, t47)
            .sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72.sub_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).sub_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t57, t56)
            .sub_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = (-t19).add_product(t23, t5);
    let t86 = t85 * t80;
    let t87 = (R::literal(-0.833_333_333_333_333_4) + t59)
        .sub_product(t61, t56)
        .sub_product(t74, t68);
    let t88 = t87 * t80;
    let t89 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t90 = t89 * t80;
    let t91 = (-(t65 * t56)).sub_product(t79, t68);
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t58, t53)
            .sub_product(t71, t70)
            .sub_product(t82, t81);
    let t94 = (R::literal(-2_777.777_777_777_778) * t4).add_product(t84, t81);
    let t95 = t94 * t93;
    let t96 = t20.sub_product(t23, t4).sub_product(t86, t81);
    let t97 = t96 * t93;
    let t98 = t72.sub_product(t61, t53).sub_product(t74, t70).sub_product(t88, t81);
    let t99 = t98 * t93;
    let t100 = (R::literal(-0.833_333_333_333_333_4) + t75)
        .add_product(t63, t53)
        .sub_product(t77, t70)
        .sub_product(t90, t81);
    let t101 = t100 * t93;
    let t102 = (-(t65 * t53)).sub_product(t79, t70).sub_product(t92, t81);
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t84, t83).sub_product(t95, t94);
    let t105 = (-t23).add_product(t86, t83).sub_product(t97, t94);
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = (t88 * t83).sub_product(t99, t94);
    let t110 = t109 * t104;
    let t111 = (t90 * t83).sub_product(t101, t94);
    let t112 = t111 * t104;
    let t113 = (t92 * t83).sub_product(t103, t94);
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi))
            .sub_product(t20, cos_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t86, t85)
            .sub_product(t97, t96)
            .sub_product(t106, t105);
    let t116 = t24.sub_product(t107, t105);
    let t117 = t116 * t115;
    let t118 = (-t25).add_product(t108, t105);
    let t119 = t118 * t115;
    let t120 = (-(t88 * t85)).sub_product(t99, t96).sub_product(t110, t105);
    let t121 = t120 * t115;
    let t122 = (-(t90 * t85)).sub_product(t101, t96).sub_product(t112, t105);
    let t123 = t122 * t115;
    let t124 = (-(t92 * t85)).sub_product(t103, t96).sub_product(t114, t105);
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t7)
            .sub_product(t107, t26)
            .sub_product(t117, t116);
    let t127 = (t27 * t7).add_product(t108, t26).sub_product(t119, t116);
    let t128 = t127 * t126;
    let t129 = (-(t110 * t26)).sub_product(t121, t116);
    let t130 = t129 * t126;
    let t131 = (-(t112 * t26)).sub_product(t123, t116);
    let t132 = t131 * t126;
    let t133 = (-(t114 * t26)).sub_product(t125, t116);
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, t6)
            .sub_product(t108, t27)
            .sub_product(t119, t118)
            .sub_product(t128, t127);
    let t136 = (t110 * t27).sub_product(t121, t118).sub_product(t130, t127);
    let t137 = t136 * t135;
    let t138 = (t112 * t27).sub_product(t123, t118).sub_product(t132, t127);
    let t139 = t138 * t135;
    let t140 = (t114 * t27).sub_product(t125, t118).sub_product(t134, t127);
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
            - inverse_bobbin_mass)
            .sub_product(t61, t60)
            .sub_product(t74, t73)
            .sub_product(t88, t87)
            .sub_product(t99, t98)
            .sub_product(t110, t109)
            .sub_product(t121, t120)
            .sub_product(t130, t129)
            .sub_product(t137, t136);
    let t143 = (t18 * t10)
        .add_product(t63, t60)
        .sub_product(t77, t73)
        .sub_product(t90, t87)
        .sub_product(t101, t98)
        .sub_product(t112, t109)
        .sub_product(t123, t120)
        .sub_product(t132, t129)
        .sub_product(t139, t136);
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = (-(t65 * t60))
        .sub_product(t79, t73)
        .sub_product(t92, t87)
        .sub_product(t103, t98)
        .sub_product(t114, t109)
        .sub_product(t125, t120)
        .sub_product(t134, t129)
        .sub_product(t141, t136);
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t11)
            - inverse_bobbin_mass)
            .sub_product(t63, t62)
            .sub_product(t77, t76)
            .sub_product(t90, t89)
            .sub_product(t101, t100)
            .sub_product(t112, t111)
            .sub_product(t123, t122)
            .sub_product(t132, t131)
            .sub_product(t139, t138)
            .sub_product(t144, t143);
    let t149 = (-t29).add_product(t145, t143);
    let t150 = t149 * t148;
    let t151 = (t65 * t62)
        .sub_product(t79, t76)
        .sub_product(t92, t89)
        .sub_product(t103, t100)
        .sub_product(t114, t111)
        .sub_product(t125, t122)
        .sub_product(t134, t131)
        .sub_product(t141, t138)
        .sub_product(t147, t143);
    let t152 = t151 * t148;
    let t153 = t31 * R::literal(-1.5);
    let t154 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between))
            .sub_product(t29, bobbin_y_minus_drum_y_over_between)
            .sub_product(t30, bobbin_x_minus_drum_x_over_between)
            .sub_product(t31, bobbin_y_minus_drum_y_over_between)
            .sub_product(t145, t28)
            .sub_product(t150, t149)
            .sub_product(t30 * R::literal(-1.5), t30)
            .sub_product(t153, t31);
    let t155 = (t147 * t28).sub_product(t152, t149);
    let t156 = t155 * t154;
    let t157 = R::literal(1.0)
        / (-(t14 * t9))
            .sub_product(t40, t39)
            .sub_product(t50, t49)
            .sub_product(t65, t64)
            .sub_product(t79, t78)
            .sub_product(t92, t91)
            .sub_product(t103, t102)
            .sub_product(t114, t113)
            .sub_product(t125, t124)
            .sub_product(t134, t133)
            .sub_product(t141, t140)
            .sub_product(t147, t146)
            .sub_product(t152, t151)
            .sub_product(t156, t155);
    let bobbin_radius_times_winding_force = p.bobbin_radius * p.winding_force;
    let t158 = R::literal(50.0) * slide_rate;
    let t159 = t158 * cos_cylinder_phi;
    let t160 = p.spring_stiffness * (slide - p.spring_free_length);
    let t161 = t160 * cos_cylinder_phi;
    let t162 = t159 + t161;
    let t163 = t160 * sin_cylinder_phi;
    let t164 = t158 * sin_cylinder_phi;
    let t165 = t164 - (R::literal(2.943) - t163);
    let t166 = (-(t160 * t8)).sub_product(t158, t8);
    let t167 = -t159 - t161;
    let t168 = -t164 - (R::literal(1.962) + t163);
    let t169 = p.winding_force * bobbin_y_minus_drum_y / between;
    let t170 = (p.winding_force * bobbin_x_minus_drum_x / between)
        .sub_product(R::literal(9.81), p.bobbin_mass);
    let post_omega_squared = post_omega * post_omega;
    let t171 = R::literal(0.1) * post_omega_squared;
    let t172 = t171 * cos_post_phi;
    let t173 = t171 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t174 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t175 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t176 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t177 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t178 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t179 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t180 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t181 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t182 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t183 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t184 = (bobbin_v_x
        * (bobbin_v_x_over_between + t178 + t179 - t176 - t177 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t182 + t183 - t180 - t181 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t176 + t177 + drum_v_x_over_between - bobbin_v_x_over_between - t178 - t179,
        )
        .add_product(
            drum_v_y,
            t180 + t181 + drum_v_y_over_between - bobbin_v_y_over_between - t182 - t183,
        );
    let t185 = t36 * t172;
    let t186 = -t173 - R::literal(-9.81) + t185;
    let t187 = t15 * bobbin_radius_times_winding_force;
    let t188 = (t187 - t172.add_product(t174, cos_plate_phi))
        .add_product(t38, t172)
        .sub_product(t46, t186);
    let t189 = t16 * bobbin_radius_times_winding_force;
    let t190 = (-t173.add_product(t174, sin_plate_phi) - R::literal(9.81)
        - R::literal(-9.81) - t189 + t185)
        .sub_product(t48, t186)
        .sub_product(t55, t188);
    let t191 = t187
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(R::literal(3.333_333_333_333_333_5), t162)
        .sub_product(t21, t166)
        .sub_product(t57, t188)
        .sub_product(t69, t190);
    let t192 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t189)
        .sub_product(R::literal(3.333_333_333_333_333_5), t165)
        .add_product(t22, t166)
        .sub_product(t58, t188)
        .sub_product(t71, t190)
        .sub_product(t82, t191);
    let t193 = (-(R::literal(-2_777.777_777_777_778) * t166))
        .add_product(t84, t191)
        .sub_product(t95, t192);
    let t194 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t162)
        .add_product(t20, t165)
        .add_product(t23, t166)
        .add_product(t24, t167)
        .sub_product(t25, t168)
        .sub_product(t86, t191)
        .sub_product(t97, t192);
    let t195 = t194.sub_product(t106, t193);
    let t196 = (t175 * cos_rod_phi)
        .sub_product(R::literal(5.0), t167)
        .sub_product(t107, t193)
        .sub_product(t117, t195);
    let t197 = (t175 * sin_rod_phi)
        .sub_product(R::literal(5.0), t168)
        .add_product(t108, t193)
        .sub_product(t119, t195)
        .sub_product(t128, t196);
    let t198 = (t11 * plate_omega_squared)
        .sub_product(t17, bobbin_radius_times_winding_force)
        .add_product(inverse_bobbin_mass, t169)
        .sub_product(t61, t188)
        .sub_product(t74, t190)
        .sub_product(t88, t191)
        .sub_product(t99, t192)
        .sub_product(t110, t193)
        .sub_product(t121, t195)
        .sub_product(t130, t196)
        .sub_product(t137, t197);
    let t199 = R::literal(-9.81)
        .add_product(t10, plate_omega_squared)
        .add_product(t18, bobbin_radius_times_winding_force)
        .sub_product(inverse_bobbin_mass, t170)
        .add_product(t63, t188)
        .sub_product(t77, t190)
        .sub_product(t90, t191)
        .sub_product(t101, t192)
        .sub_product(t112, t193)
        .sub_product(t123, t195)
        .sub_product(t132, t196)
        .sub_product(t139, t197)
        .sub_product(t144, t198);
    let t200 = (-t184)
        .add_product(t28, t169)
        .sub_product(t29, t170)
        .add_product(t31, R::literal(-14.715))
        .add_product(t145, t198)
        .sub_product(t150, t199)
        .sub_product(t153, R::literal(9.809_999_999_999_999));
    let t201 = ((R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared)
        .sub_product(t40, t172)
        .sub_product(t50, t186)
        .sub_product(t65, t188)
        .sub_product(t79, t190)
        .sub_product(t92, t191)
        .sub_product(t103, t192)
        .sub_product(t114, t193)
        .sub_product(t125, t195)
        .sub_product(t134, t196)
        .sub_product(t141, t197)
        .sub_product(t147, t198)
        .sub_product(t152, t199)
        .sub_product(t156, t200) * t157;
    let contact = (-(t200 * t154)).add_product(t156, t201);
    let stop = -t201;
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
    let slide = ((rod_x - cylinder_x) * cylinder_phi.cos())
        .add_product(rod_y - cylinder_y, cylinder_phi.sin());
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
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t8 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t8)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t9 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
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
    let t45 = (t12 * t0).sub_product(t38, t35);
    let t46 = t45 * t44;
    let t47 = R::literal(1.25) - t41 - t43;
    let t48 = t47 * t44;
    let t49 = (t14 * t0).add_product(t40, t35);
    let t50 = t49 * t44;
    let t51 = t15 * t3;
    let t52 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t51)
            .sub_product(t38, t37)
            .sub_product(t46, t45);
    let t53 = t16 * t3;
    let t54 = (t35 + t53).sub_product(t36, t37).sub_product(t48, t45);
    let t55 = t54 * t52;
    let t56 = R::literal(0.833_333_333_333_333_4) - t51;
    let t57 = t56 * t52;
    let t58 = t53 * t52;
    let t59 = t17 * t3;
    let t60 = R::literal(0.833_333_333_333_333_4) + t59;
    let t61 = t60 * t52;
    let t62 = t18 * t3;
    let t63 = t62 * t52;
    let t64 = (-t39).add_product(t40, t37).sub_product(t50, t45);
    let t65 = t64 * t52;
    let t66 = t16 * t2;
    let t67 = R::literal(1.0)
        / (t42 - R::literal(0.833_333_333_333_333_4) - t66 - t43)
            .sub_product(t48, t47)
            .sub_product(t55, t54);
    let t68 = (t15 * t2).sub_product(t57, t54);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t58, t54);
    let t71 = t70 * t67;
    let t72 = -(t17 * t2);
    let t73 = t72.sub_product(t61, t54);
    let t74 = t73 * t67;
    let t75 = t18 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t63, t54);
    let t77 = t76 * t67;
    let t78 = t49.sub_product(t50, t47).sub_product(t65, t54);
    let t79 = t78 * t67;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t51
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t57, t56)
            .sub_product(t69, t68);
    let t81 = t53.add_product(t22, t5).sub_product(t58, t56).sub_product(t71, t68);
    let t82 = t81 * t80;
    let t83 = R::literal(-2_777.777_777_777_778) * t5;
    let t84 = t83 * t80;
    let t85 = (-t19).add_product(t23, t5);
    let t86 = t85 * t80;
    let t87 = (R::literal(-0.833_333_333_333_333_4) + t59)
        .sub_product(t61, t56)
        .sub_product(t74, t68);
    let t88 = t87 * t80;
    let t89 = (-t62).add_product(t63, t56).sub_product(t77, t68);
    let t90 = t89 * t80;
    let t91 = (-(t65 * t56)).sub_product(t79, t68);
    let t92 = t91 * t80;
    let t93 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t58, t53)
            .sub_product(t71, t70)
            .sub_product(t82, t81);
    let t94 = (R::literal(-2_777.777_777_777_778) * t4).add_product(t84, t81);
    let t95 = t94 * t93;
    let t96 = t20.sub_product(t23, t4).sub_product(t86, t81);
    let t97 = t96 * t93;
    let t98 = t72.sub_product(t61, t53).sub_product(t74, t70).sub_product(t88, t81);
    let t99 = t98 * t93;
    let t100 = (R::literal(-0.833_333_333_333_333_4) + t75)
        .add_product(t63, t53)
        .sub_product(t77, t70)
        .sub_product(t90, t81);
    let t101 = t100 * t93;
    let t102 = (-(t65 * t53)).sub_product(t79, t70).sub_product(t92, t81);
    let t103 = t102 * t93;
    let t104 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t84, t83).sub_product(t95, t94);
    let t105 = (-t23).add_product(t86, t83).sub_product(t97, t94);
    let t106 = t105 * t104;
    let t107 = t26 * t104;
    let t108 = t27 * t104;
    let t109 = (t88 * t83).sub_product(t99, t94);
    let t110 = t109 * t104;
    let t111 = (t90 * t83).sub_product(t101, t94);
    let t112 = t111 * t104;
    let t113 = (t92 * t83).sub_product(t103, t94);
    let t114 = t113 * t104;
    let t115 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi))
            .sub_product(t20, cos_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t86, t85)
            .sub_product(t97, t96)
            .sub_product(t106, t105);
    let t116 = t24.sub_product(t107, t105);
    let t117 = t116 * t115;
    let t118 = (-t25).add_product(t108, t105);
    let t119 = t118 * t115;
    let t120 = (-(t88 * t85)).sub_product(t99, t96).sub_product(t110, t105);
    let t121 = t120 * t115;
    let t122 = (-(t90 * t85)).sub_product(t101, t96).sub_product(t112, t105);
    let t123 = t122 * t115;
    let t124 = (-(t92 * t85)).sub_product(t103, t96).sub_product(t114, t105);
    let t125 = t124 * t115;
    let t126 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t7)
            .sub_product(t107, t26)
            .sub_product(t117, t116);
    let t127 = (t27 * t7).add_product(t108, t26).sub_product(t119, t116);
    let t128 = t127 * t126;
    let t129 = (-(t110 * t26)).sub_product(t121, t116);
    let t130 = t129 * t126;
    let t131 = (-(t112 * t26)).sub_product(t123, t116);
    let t132 = t131 * t126;
    let t133 = (-(t114 * t26)).sub_product(t125, t116);
    let t134 = t133 * t126;
    let t135 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, t6)
            .sub_product(t108, t27)
            .sub_product(t119, t118)
            .sub_product(t128, t127);
    let t136 = (t110 * t27).sub_product(t121, t118).sub_product(t130, t127);
    let t137 = t136 * t135;
    let t138 = (t112 * t27).sub_product(t123, t118).sub_product(t132, t127);
    let t139 = t138 * t135;
    let t140 = (t114 * t27).sub_product(t125, t118).sub_product(t134, t127);
    let t141 = t140 * t135;
    let t142 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t10)
            - inverse_bobbin_mass)
            .sub_product(t61, t60)
            .sub_product(t74, t73)
            .sub_product(t88, t87)
            .sub_product(t99, t98)
            .sub_product(t110, t109)
            .sub_product(t121, t120)
            .sub_product(t130, t129)
            .sub_product(t137, t136);
    let t143 = (t18 * t10)
        .add_product(t63, t60)
        .sub_product(t77, t73)
        .sub_product(t90, t87)
        .sub_product(t101, t98)
        .sub_product(t112, t109)
        .sub_product(t123, t120)
        .sub_product(t132, t129)
        .sub_product(t139, t136);
    let t144 = t143 * t142;
    let t145 = t28 * t142;
    let t146 = (-(t65 * t60))
        .sub_product(t79, t73)
        .sub_product(t92, t87)
        .sub_product(t103, t98)
        .sub_product(t114, t109)
        .sub_product(t125, t120)
        .sub_product(t134, t129)
        .sub_product(t141, t136);
    let t147 = t146 * t142;
    let t148 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t11)
            - inverse_bobbin_mass)
            .sub_product(t63, t62)
            .sub_product(t77, t76)
            .sub_product(t90, t89)
            .sub_product(t101, t100)
            .sub_product(t112, t111)
            .sub_product(t123, t122)
            .sub_product(t132, t131)
            .sub_product(t139, t138)
            .sub_product(t144, t143);
    let t149 = (-t29).add_product(t145, t143);
    let t150 = t149 * t148;
    let t151 = (t65 * t62)
        .sub_product(t79, t76)
        .sub_product(t92, t89)
        .sub_product(t103, t100)
        .sub_product(t114, t111)
        .sub_product(t125, t122)
        .sub_product(t134, t131)
        .sub_product(t141, t138)
        .sub_product(t147, t143);
    let t152 = t151 * t148;
    let t153 = t30 * R::literal(-1.5);
    let t154 = t31 * R::literal(-1.5);
    let t155 = R::literal(1.0)
        / (-(t28 * bobbin_x_minus_drum_x_over_between))
            .sub_product(t29, bobbin_y_minus_drum_y_over_between)
            .sub_product(t30, bobbin_x_minus_drum_x_over_between)
            .sub_product(t31, bobbin_y_minus_drum_y_over_between)
            .sub_product(t145, t28)
            .sub_product(t150, t149)
            .sub_product(t153, t30)
            .sub_product(t154, t31);
    let t156 = (t147 * t28).sub_product(t152, t149);
    let t157 = t156 * t155;
    let t158 = R::literal(1.0)
        / (-(t14 * t9))
            .sub_product(t40, t39)
            .sub_product(t50, t49)
            .sub_product(t65, t64)
            .sub_product(t79, t78)
            .sub_product(t92, t91)
            .sub_product(t103, t102)
            .sub_product(t114, t113)
            .sub_product(t125, t124)
            .sub_product(t134, t133)
            .sub_product(t141, t140)
            .sub_product(t147, t146)
            .sub_product(t152, t151)
            .sub_product(t157, t156);
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
    let t169 = (-t168).sub_product(t159, t8);
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
    let t180 = R::literal(0.06) * (rod_omega * rod_omega);
    let between_squared_times_between = between * between * between;
    let t181 = bobbin_v_x * bobbin_x_minus_drum_x_squared
        / between_squared_times_between;
    let t182 = bobbin_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let drum_v_x_over_between = drum_v_x / between;
    let bobbin_v_x_over_between = bobbin_v_x / between;
    let t183 = drum_v_x * bobbin_x_minus_drum_x_squared / between_squared_times_between;
    let t184 = drum_v_y * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t185 = bobbin_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t186 = bobbin_v_y * bobbin_y_minus_drum_y_squared
        / between_squared_times_between;
    let drum_v_y_over_between = drum_v_y / between;
    let bobbin_v_y_over_between = bobbin_v_y / between;
    let t187 = drum_v_x * bobbin_x_minus_drum_x * bobbin_y_minus_drum_y
        / between_squared_times_between;
    let t188 = drum_v_y * bobbin_y_minus_drum_y_squared / between_squared_times_between;
    let t189 = (bobbin_v_x
        * (bobbin_v_x_over_between + t183 + t184 - t181 - t182 - drum_v_x_over_between))
        .add_product(
            bobbin_v_y,
            bobbin_v_y_over_between + t187 + t188 - t185 - t186 - drum_v_y_over_between,
        )
        .add_product(
            drum_v_x,
            t181 + t182 + drum_v_x_over_between - bobbin_v_x_over_between - t183 - t184,
        )
        .add_product(
            drum_v_y,
            t185 + t186 + drum_v_y_over_between - bobbin_v_y_over_between - t187 - t188,
        );
    let t190 = t36 * t177;
    let t191 = -t178 - R::literal(-9.81) + t190;
    let t192 = t15 * bobbin_radius_times_winding_force;
    let t193 = (t192 - t177.add_product(t179, cos_plate_phi))
        .add_product(t38, t177)
        .sub_product(t46, t191);
    let t194 = t16 * bobbin_radius_times_winding_force;
    let t195 = (-t178.add_product(t179, sin_plate_phi) - R::literal(9.81)
        - R::literal(-9.81) - t194 + t190)
        .sub_product(t48, t191)
        .sub_product(t55, t193);
    let t196 = R::literal(3.333_333_333_333_333_5) * t163;
    let t197 = (t192
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        ) - t196)
        .sub_product(t21, t169)
        .sub_product(t57, t193)
        .sub_product(t69, t195);
    let t198 = R::literal(3.333_333_333_333_333_5) * t167;
    let t199 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t194 - t198)
        .add_product(t22, t169)
        .sub_product(t58, t193)
        .sub_product(t71, t195)
        .sub_product(t82, t197);
    let t200 = (-(R::literal(-2_777.777_777_777_778) * t169))
        .add_product(t84, t197)
        .sub_product(t95, t199);
    let t201 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t163)
        .add_product(t20, t167)
        .add_product(t23, t169)
        .add_product(t24, t170)
        .sub_product(t25, t172)
        .sub_product(t86, t197)
        .sub_product(t97, t199);
    let t202 = t201.sub_product(t106, t200);
    let t203 = R::literal(5.0) * t170;
    let t204 = (-t203)
        .add_product(t180, cos_rod_phi)
        .sub_product(t107, t200)
        .sub_product(t117, t202);
    let t205 = R::literal(5.0) * t172;
    let t206 = (-t205)
        .add_product(t180, sin_rod_phi)
        .add_product(t108, t200)
        .sub_product(t119, t202)
        .sub_product(t128, t204);
    let t207 = inverse_bobbin_mass * t173;
    let t208 = ((t11 * plate_omega_squared)
        .sub_product(t17, bobbin_radius_times_winding_force) + t207)
        .sub_product(t61, t193)
        .sub_product(t74, t195)
        .sub_product(t88, t197)
        .sub_product(t99, t199)
        .sub_product(t110, t200)
        .sub_product(t121, t202)
        .sub_product(t130, t204)
        .sub_product(t137, t206);
    let t209 = inverse_bobbin_mass * t175;
    let t210 = (R::literal(-9.81)
        .add_product(t10, plate_omega_squared)
        .add_product(t18, bobbin_radius_times_winding_force) - t209)
        .add_product(t63, t193)
        .sub_product(t77, t195)
        .sub_product(t90, t197)
        .sub_product(t101, t199)
        .sub_product(t112, t200)
        .sub_product(t123, t202)
        .sub_product(t132, t204)
        .sub_product(t139, t206)
        .sub_product(t144, t208);
    let t211 = (-t189)
        .add_product(t28, t173)
        .sub_product(t29, t175)
        .add_product(t31, R::literal(-14.715))
        .add_product(t145, t208)
        .sub_product(t150, t210)
        .sub_product(t154, R::literal(9.809_999_999_999_999));
    let t212 = ((R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi) * post_omega_squared)
        .sub_product(t40, t177)
        .sub_product(t50, t191)
        .sub_product(t65, t193)
        .sub_product(t79, t195)
        .sub_product(t92, t197)
        .sub_product(t103, t199)
        .sub_product(t114, t200)
        .sub_product(t125, t202)
        .sub_product(t134, t204)
        .sub_product(t141, t206)
        .sub_product(t147, t208)
        .sub_product(t152, t210)
        .sub_product(t157, t211) * t158;
    let t213 = (t211 * t155).sub_product(t157, t212);
    let axle_b_x = t153 * t213;
    let t214 = (t210 * t148).sub_product(t150, t213).sub_product(t152, t212);
    let t215 = (t208 * t142)
        .sub_product(t144, t214)
        .add_product(t145, t213)
        .sub_product(t147, t212);
    let t216 = (t206 * t135)
        .sub_product(t137, t215)
        .sub_product(t139, t214)
        .sub_product(t141, t212);
    let t217 = (t204 * t126)
        .sub_product(t128, t216)
        .sub_product(t130, t215)
        .sub_product(t132, t214)
        .sub_product(t134, t212);
    let t218 = (t202 * t115)
        .sub_product(t117, t217)
        .sub_product(t119, t216)
        .sub_product(t121, t215)
        .sub_product(t123, t214)
        .sub_product(t125, t212);
    let t219 = (t200 * t104)
        .sub_product(t106, t218)
        .sub_product(t107, t217)
        .add_product(t108, t216)
        .sub_product(t110, t215)
        .sub_product(t112, t214)
        .sub_product(t114, t212);
    let t220 = (t199 * t93)
        .sub_product(t95, t219)
        .sub_product(t97, t218)
        .sub_product(t99, t215)
        .sub_product(t101, t214)
        .sub_product(t103, t212);
    let t221 = (t197 * t80)
        .sub_product(t82, t220)
        .add_product(t84, t219)
        .sub_product(t86, t218)
        .sub_product(t88, t215)
        .sub_product(t90, t214)
        .sub_product(t92, t212);
    let t222 = (t195 * t67)
        .sub_product(t69, t221)
        .sub_product(t71, t220)
        .sub_product(t74, t215)
        .sub_product(t77, t214)
        .sub_product(t79, t212);
    let t223 = (t193 * t52)
        .sub_product(t55, t222)
        .sub_product(t57, t221)
        .sub_product(t58, t220)
        .sub_product(t61, t215)
        .add_product(t63, t214)
        .sub_product(t65, t212);
    let t224 = (t191 * t44)
        .sub_product(t46, t223)
        .sub_product(t48, t222)
        .sub_product(t50, t212);
    let t225 = (-(t177 * t34))
        .sub_product(t36, t224)
        .sub_product(t38, t223)
        .sub_product(t36, t222)
        .add_product(t40, t212);
    let drum_v_y_dot = R::literal(-9.809_999_999_999_999)
        .sub_product(
            R::literal(0.666_666_666_666_666_6),
            R::literal(-14.714_999_999_999_998).sub_product(t154, t213),
        )
        .add_product(t31, t213);
    let drum_v_x_dot = (t30 * t213)
        .add_product(R::literal(0.666_666_666_666_666_6), axle_b_x);
    let bobbin_v_y_dot = t209
        .sub_product(inverse_bobbin_mass, t214)
        .sub_product(t29, t213);
    let bobbin_v_x_dot = (-t207)
        .sub_product(inverse_bobbin_mass, t215)
        .sub_product(t28, t213);
    let rod_omega_dot = (t26 * t217)
        .sub_product(R::literal(4_166.666_666_666_667), t219)
        .sub_product(t27, t216);
    let rod_v_y_dot = t205.sub_product(t25, t218).sub_product(R::literal(5.0), t216);
    let rod_v_x_dot = t203.add_product(t24, t218).sub_product(R::literal(5.0), t217);
    let cylinder_omega_dot = (t169 * R::literal(2_777.777_777_777_778))
        .sub_product(t21, t221)
        .add_product(t22, t220)
        .sub_product(R::literal(-2_777.777_777_777_778), t219)
        .add_product(t23, t218);
    let cylinder_v_y_dot = t198
        .sub_product(R::literal(3.333_333_333_333_333_5), t220)
        .add_product(t20, t218);
    let cylinder_v_x_dot = t196
        .sub_product(R::literal(3.333_333_333_333_333_5), t221)
        .sub_product(t19, t218);
    let plate_omega_dot = (-(bobbin_radius_times_winding_force * R::literal(400.0)))
        .sub_product(t15, t223)
        .add_product(t16, t222)
        .sub_product(t15, t221)
        .add_product(t16, t220)
        .add_product(t17, t215)
        .sub_product(t18, t214);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t222)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t220)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t214);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t221))
        .sub_product(R::literal(0.833_333_333_333_333_4), t223)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t215);
    let post_omega_dot = (t13 * t224)
        .sub_product(t12, t225)
        .sub_product(t12, t223)
        .add_product(t13, t222)
        .sub_product(t14, t212);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t224)
        .sub_product(R::literal(-1.25), t222);
    let post_v_x_dot = (-(R::literal(-1.25) * t223)).sub_product(R::literal(1.25), t225);
    let t226 = (R::literal(7.848) * post_v_y)
        .add_product(R::literal(11.772), plate_v_y)
        .sub_product(t162, cylinder_v_x)
        .add_product(t165, cylinder_v_y)
        .add_product(t168, cylinder_omega)
        .add_product(t162, rod_v_x)
        .add_product(t171, rod_v_y)
        .add_product(t174, bobbin_v_y)
        .add_product(R::literal(14.715), drum_v_y)
        .add_product(R::literal(0.8) * post_v_x, post_v_x_dot)
        .add_product(R::literal(0.8) * post_v_y, post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, post_omega_dot)
        .add_product(R::literal(1.2) * plate_v_x, plate_v_x_dot)
        .add_product(R::literal(1.2) * plate_v_y, plate_v_y_dot)
        .add_product(R::literal(0.0025) * plate_omega, plate_omega_dot)
        .add_product(R::literal(0.3) * cylinder_v_x, cylinder_v_x_dot);
    PowerBalance {
        stored_rate: t226
            .add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot)
            .add_product(R::literal(0.2) * rod_v_y, rod_v_y_dot)
            .add_product(R::literal(0.00024) * rod_omega, rod_omega_dot)
            .add_product(p.bobbin_mass * bobbin_v_x, bobbin_v_x_dot)
            .add_product(p.bobbin_mass * bobbin_v_y, bobbin_v_y_dot)
            .add_product(R::literal(1.5) * drum_v_x, drum_v_x_dot)
            .add_product(R::literal(1.5) * drum_v_y, drum_v_y_dot),
        supplied: (p.winding_force * bobbin_v_y * bobbin_x_minus_drum_x / between)
            .sub_product(bobbin_radius_times_winding_force, plate_omega)
            - p.winding_force * bobbin_v_x * bobbin_y_minus_drum_y / between,
        dissipated: (R::literal(50.0) * cylinder_omega * slide_rate * t8)
            .add_product(R::literal(50.0) * rod_v_x * slide_rate, cos_cylinder_phi)
            .add_product(R::literal(50.0) * rod_v_y * slide_rate, sin_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_x * slide_rate, cos_cylinder_phi)
            .sub_product(R::literal(50.0) * cylinder_v_y * slide_rate, sin_cylinder_phi),
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
    let cylinder_start_x = cylinder_x.sub_product(R::literal(0.06), cos_cylinder_phi);
    let sin_cylinder_phi = cylinder_phi.sin();
    let cylinder_start_y = cylinder_y.sub_product(R::literal(0.06), sin_cylinder_phi);
    let rod_end_x = rod_x.add_product(R::literal(0.06), rod_phi.cos());
    let rod_end_y = rod_y.add_product(R::literal(0.06), rod_phi.sin());
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
    let pin_e_x_rate = rod_v_x.sub_product(t7, rod_phi.sin());
    let pin_e_y_rate = rod_v_y.add_product(t7, rod_phi.cos());
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
    let contact_rate = bobbin_v_x * bobbin_x_minus_drum_x / between
        + bobbin_v_y * bobbin_y_minus_drum_y / between
        - drum_v_x * bobbin_x_minus_drum_x / between
        - drum_v_y * bobbin_y_minus_drum_y / between;
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
        -(R::literal(0.06) * rod_phi.sin()),
        R::literal(1.0),
        R::literal(0.06) * rod_phi.cos(),
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

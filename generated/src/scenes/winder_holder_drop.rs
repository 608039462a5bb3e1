// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   044e0f4a1f2bab23afeb6e3d262a47321342ed9c5c3cc52995c00ca78c21b7a4  scenes/winder_holder_drop.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//   3a06aa48a56961be277bb8748bfcb9b7930fe7d6c621790a5198dd36ddd4f5c6  units/one_sided_contact.toml
//
// Four-link bobbin holder, let go
//
// The holder of `winder_linkage` with package and post lifted: it falls until the bobbin meets
// the drum and the post its stop, bounces, and settles at work. Drum and stop only push: both
// contacts are springs and dampers that open and close by events. The drum stands still.
//
// Source:
//   Study of a winding mechanism; dimensions are ours.
//
// Shapes; all quantities are in SI units:
//   coordinates              14
//   first-order states        2
//   states                   30
//   parameters                5
//   outputs                   7
//   discontinuities           0
//   events                    4
//   constraints              12
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
//    14  post.v_x        [m/s]    rate of centre of mass, sideways
//    15  post.v_y        [m/s]    rate of centre of mass, upwards
//    16  post.omega      [rad/s]  rate of angle of the bar from sideways
//    17  plate.v_x       [m/s]    rate of centre of mass, sideways
//    18  plate.v_y       [m/s]    rate of centre of mass, upwards
//    19  plate.omega     [rad/s]  rate of angle of the bar from sideways
//    20  cylinder.v_x    [m/s]    rate of centre of mass, sideways
//    21  cylinder.v_y    [m/s]    rate of centre of mass, upwards
//    22  cylinder.omega  [rad/s]  rate of angle of the bar from sideways
//    23  rod.v_x         [m/s]    rate of centre of mass, sideways
//    24  rod.v_y         [m/s]    rate of centre of mass, upwards
//    25  rod.omega       [rad/s]  rate of angle of the bar from sideways
//    26  bobbin.v_x      [m/s]    rate of centre of mass, sideways
//    27  bobbin.v_y      [m/s]    rate of centre of mass, upwards
//    28  contact.closed  [1]      1 while there is contact
//    29  stop.closed     [1]      1 while there is contact
//
// Nonzeros:
//   mass_matrix              14 of 14 by 14
//   rate_jacobian           294 of 30 by 30
//   parameter_jacobian       56 of 30 by 5
//
// Operations:
//   initial_state             1
//   discontinuities           0
//   rate                    741
//   mass_matrix               0
//   forcing                  81
//   rate_jacobian          5083
//   parameter_jacobian     1133
//   time_derivative           0
//   outputs                  52
//   energy                   78
//   power_balance           838
//   guards                   28
//   guard_rates             727
//   resets                    0
//   constraint_values        49
//   constraint_rates         63
//   constraint_matrix        35
// With constants of the parameters, prepared once a run:
//   prepare                   1
//   prepared_rate           741
//   prepared_rate_jacobian 5082

use crate::{
    Constraint, Describe, Direction, Event, Energy, PowerBalance, Quantity, Real,
    RunDefaults, Shape, Simulator, SparsityPattern,
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 14;

/// Length of the state y.
pub const STATES: usize = 30;

/// Parameters.
pub const PARAMETERS: usize = 5;

/// Wanted outputs.
pub const OUTPUTS: usize = 7;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Events.
pub const EVENTS: usize = 4;

/// States that events set, those of all events.
pub const RESETS: usize = 4;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 14,
    columns: 14,
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
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 30,
    columns: 30,
    entries: &[
        (0, 14),
        (1, 15),
        (2, 16),
        (3, 17),
        (4, 18),
        (5, 19),
        (6, 20),
        (7, 21),
        (8, 22),
        (9, 23),
        (10, 24),
        (11, 25),
        (12, 26),
        (13, 27),
        (14, 2),
        (14, 5),
        (14, 6),
        (14, 7),
        (14, 8),
        (14, 9),
        (14, 10),
        (14, 11),
        (14, 12),
        (14, 13),
        (14, 16),
        (14, 19),
        (14, 20),
        (14, 21),
        (14, 22),
        (14, 23),
        (14, 24),
        (14, 25),
        (14, 26),
        (14, 27),
        (15, 2),
        (15, 5),
        (15, 6),
        (15, 7),
        (15, 8),
        (15, 9),
        (15, 10),
        (15, 11),
        (15, 12),
        (15, 13),
        (15, 16),
        (15, 19),
        (15, 20),
        (15, 21),
        (15, 22),
        (15, 23),
        (15, 24),
        (15, 25),
        (15, 26),
        (15, 27),
        (16, 2),
        (16, 5),
        (16, 6),
        (16, 7),
        (16, 8),
        (16, 9),
        (16, 10),
        (16, 11),
        (16, 12),
        (16, 13),
        (16, 16),
        (16, 19),
        (16, 20),
        (16, 21),
        (16, 22),
        (16, 23),
        (16, 24),
        (16, 25),
        (16, 26),
        (16, 27),
        (17, 2),
        (17, 5),
        (17, 6),
        (17, 7),
        (17, 8),
        (17, 9),
        (17, 10),
        (17, 11),
        (17, 12),
        (17, 13),
        (17, 16),
        (17, 19),
        (17, 20),
        (17, 21),
        (17, 22),
        (17, 23),
        (17, 24),
        (17, 25),
        (17, 26),
        (17, 27),
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
        (18, 16),
        (18, 19),
        (18, 20),
        (18, 21),
        (18, 22),
        (18, 23),
        (18, 24),
        (18, 25),
        (18, 26),
        (18, 27),
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
        (19, 16),
        (19, 19),
        (19, 20),
        (19, 21),
        (19, 22),
        (19, 23),
        (19, 24),
        (19, 25),
        (19, 26),
        (19, 27),
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
        (20, 16),
        (20, 19),
        (20, 20),
        (20, 21),
        (20, 22),
        (20, 23),
        (20, 24),
        (20, 25),
        (20, 26),
        (20, 27),
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
        (21, 16),
        (21, 19),
        (21, 20),
        (21, 21),
        (21, 22),
        (21, 23),
        (21, 24),
        (21, 25),
        (21, 26),
        (21, 27),
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
        (22, 16),
        (22, 19),
        (22, 20),
        (22, 21),
        (22, 22),
        (22, 23),
        (22, 24),
        (22, 25),
        (22, 26),
        (22, 27),
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
        (23, 16),
        (23, 19),
        (23, 20),
        (23, 21),
        (23, 22),
        (23, 23),
        (23, 24),
        (23, 25),
        (23, 26),
        (23, 27),
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
        (24, 16),
        (24, 19),
        (24, 20),
        (24, 21),
        (24, 22),
        (24, 23),
        (24, 24),
        (24, 25),
        (24, 26),
        (24, 27),
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
        (25, 16),
        (25, 19),
        (25, 20),
        (25, 21),
        (25, 22),
        (25, 23),
        (25, 24),
        (25, 25),
        (25, 26),
        (25, 27),
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
        (26, 16),
        (26, 19),
        (26, 20),
        (26, 21),
        (26, 22),
        (26, 23),
        (26, 24),
        (26, 25),
        (26, 26),
        (26, 27),
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
        (27, 16),
        (27, 19),
        (27, 20),
        (27, 21),
        (27, 22),
        (27, 23),
        (27, 24),
        (27, 25),
        (27, 26),
        (27, 27),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 30,
    columns: 5,
    entries: &[
        (14, 1),
        (14, 2),
        (14, 3),
        (14, 4),
        (15, 1),
        (15, 2),
        (15, 3),
        (15, 4),
        (16, 1),
        (16, 2),
        (16, 3),
        (16, 4),
        (17, 1),
        (17, 2),
        (17, 3),
        (17, 4),
        (18, 1),
        (18, 2),
        (18, 3),
        (18, 4),
        (19, 1),
        (19, 2),
        (19, 3),
        (19, 4),
        (20, 1),
        (20, 2),
        (20, 3),
        (20, 4),
        (21, 1),
        (21, 2),
        (21, 3),
        (21, 4),
        (22, 1),
        (22, 2),
        (22, 3),
        (22, 4),
        (23, 1),
        (23, 2),
        (23, 3),
        (23, 4),
        (24, 1),
        (24, 2),
        (24, 3),
        (24, 4),
        (25, 1),
        (25, 2),
        (25, 3),
        (25, 4),
        (26, 1),
        (26, 2),
        (26, 3),
        (26, 4),
        (27, 1),
        (27, 2),
        (27, 3),
        (27, 4),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 12;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 12,
    columns: 14,
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
    ],
};

/// Four-link bobbin holder, let go
///
/// The holder of \`winder_linkage\` with package and post lifted: it falls until the bobbin meets
/// the drum and the post its stop, bounces, and settles at work. Drum and stop only push: both
/// contacts are springs and dampers that open and close by events. The drum stands still.
///
/// Source: Study of a winding mechanism; dimensions are ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct WinderHolderDrop;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// lift: angle of the post over its stop at the start \[rad\]. In the spec: 0.03.
    pub lift: R,
    /// spring.stiffness: spring \[N/m\]. In the spec: 2000.0.
    pub spring_stiffness: R,
    /// spring.damping: damper \[N s/m\]. In the spec: 400.0.
    pub spring_damping: R,
    /// contact.stiffness: spring of the contact \[N/m\]. In the spec: 1000000.0.
    pub contact_stiffness: R,
    /// contact.damping: damper of the contact \[N s/m\]. In the spec: 1500.0.
    pub contact_damping: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            lift: values[0],
            spring_stiffness: values[1],
            spring_damping: values[2],
            contact_stiffness: values[3],
            contact_damping: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.lift,
            self.spring_stiffness,
            self.spring_damping,
            self.contact_stiffness,
            self.contact_damping,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            lift: R::literal(0.03),
            spring_stiffness: R::literal(2000.0),
            spring_damping: R::literal(400.0),
            contact_stiffness: R::literal(1_000_000.0),
            contact_damping: R::literal(1500.0),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// contact_force: force of the contact \[N\].
    pub contact_force: R,
    /// stop_force: force of the contact \[N\].
    pub stop_force: R,
    /// contact_gap: gap between bobbin and drum at K \[m\].
    pub contact_gap: R,
    /// stop_gap: gap between post and stop at T \[m\].
    pub stop_gap: R,
    /// strut_push: force with which it pushes its ends apart \[N\].
    pub strut_push: R,
    /// post_angle: angle of the bar from sideways \[rad\].
    pub post_angle: R,
    /// plate_angle: angle of the bar from sideways \[rad\].
    pub plate_angle: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            contact_force: values[0],
            stop_force: values[1],
            contact_gap: values[2],
            stop_gap: values[3],
            strut_push: values[4],
            post_angle: values[5],
            plate_angle: values[6],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.contact_force,
            self.stop_force,
            self.contact_gap,
            self.stop_gap,
            self.strut_push,
            self.post_angle,
            self.plate_angle,
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
    /// post.v_x: rate of centre of mass, sideways \[m/s\].
    pub const POST_V_X: usize = 14;
    /// post.v_y: rate of centre of mass, upwards \[m/s\].
    pub const POST_V_Y: usize = 15;
    /// post.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const POST_OMEGA: usize = 16;
    /// plate.v_x: rate of centre of mass, sideways \[m/s\].
    pub const PLATE_V_X: usize = 17;
    /// plate.v_y: rate of centre of mass, upwards \[m/s\].
    pub const PLATE_V_Y: usize = 18;
    /// plate.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const PLATE_OMEGA: usize = 19;
    /// cylinder.v_x: rate of centre of mass, sideways \[m/s\].
    pub const CYLINDER_V_X: usize = 20;
    /// cylinder.v_y: rate of centre of mass, upwards \[m/s\].
    pub const CYLINDER_V_Y: usize = 21;
    /// cylinder.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const CYLINDER_OMEGA: usize = 22;
    /// rod.v_x: rate of centre of mass, sideways \[m/s\].
    pub const ROD_V_X: usize = 23;
    /// rod.v_y: rate of centre of mass, upwards \[m/s\].
    pub const ROD_V_Y: usize = 24;
    /// rod.omega: rate of angle of the bar from sideways \[rad/s\].
    pub const ROD_OMEGA: usize = 25;
    /// bobbin.v_x: rate of centre of mass, sideways \[m/s\].
    pub const BOBBIN_V_X: usize = 26;
    /// bobbin.v_y: rate of centre of mass, upwards \[m/s\].
    pub const BOBBIN_V_Y: usize = 27;
    /// contact.closed: 1 while there is contact \[1\].
    pub const CONTACT_CLOSED: usize = 28;
    /// stop.closed: 1 while there is contact \[1\].
    pub const STOP_CLOSED: usize = 29;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 1;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self { t0: values[0] }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [self.t0]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 1 operation.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.contact_damping;
    Constants { t0 }
}

/// State at the start of the run, in the units of the states.
///
/// 1 operation.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.096),
        R::literal(0.03),
        p.lift + R::literal(0.298_498_931_586_179_3),
        R::literal(0.172),
        R::literal(0.116),
        R::literal(1.95),
        R::literal(0.103),
        R::literal(0.207),
        R::literal(2.53),
        R::literal(0.049),
        R::literal(0.245),
        R::literal(2.53),
        R::literal(0.269),
        R::literal(0.139),
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

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda` with `g'' = 0`, `h`; in the units of the states per second.
///
/// 741 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 741 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    _c: &Constants<R>,
) -> [R; STATES] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x,
    plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y,
    rod_omega, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
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
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let t8 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let stop_rate = post_omega * t8;
    let t9 = bobbin_x - R::literal(0.328);
    let t10 = bobbin_y - R::literal(0.058);
    let between = (t9 * t9 + t10 * t10).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t9 + bobbin_v_y * t10) / between;
    let t11 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t11 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t12 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t13 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let t14 = t1 * R::literal(370.370_370_370_370_3);
    let t15 = t0 * R::literal(370.370_370_370_370_3);
    let t16 = t3 * R::literal(400.0);
    let t17 = t2 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = t5 * R::literal(2_777.777_777_777_778);
    let t23 = t4 * R::literal(2_777.777_777_777_778);
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = t7 * R::literal(4_166.666_666_666_667);
    let t28 = t6 * R::literal(4_166.666_666_666_667);
    let t29 = t14 * t1;
    let t30 = R::literal(-1.25) - t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(-1.25) - t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t37 - t38);
    let t40 = t14 * t0 - t35 * t32;
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 - t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0)
        / (t30 - R::literal(0.833_333_333_333_333_4) - t44 - t35 * t34 - t41 * t40);
    let t46 = t17 * t3;
    let t47 = t32 + t46 - t33 * t34 - t43 * t40;
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0)
        / (t37 - R::literal(0.833_333_333_333_333_4) - t57 - t38 - t43 * t42
            - t48 * t47);
    let t59 = t16 * t2 - t50 * t47;
    let t60 = t59 * t58;
    let t61 = R::literal(0.833_333_333_333_333_4) - t57 - t51 * t47;
    let t62 = t61 * t58;
    let t63 = -(t18 * t2);
    let t64 = t63 - t54 * t47;
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66 + t56 * t47;
    let t68 = t67 * t58;
    let t69 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t44
            - R::literal(3.333_333_333_333_333_5) - t22 * t5 - t50 * t49 - t60 * t59);
    let t70 = t46 + t23 * t5 - t51 * t49 - t62 * t59;
    let t71 = t70 * t69;
    let t72 = R::literal(-2_777.777_777_777_778) * t5;
    let t73 = t72 * t69;
    let t74 = t24 * t5 - t20;
    let t75 = t74 * t69;
    let t76 = R::literal(-0.833_333_333_333_333_4) + t52 - t54 * t49 - t65 * t59;
    let t77 = t76 * t69;
    let t78 = t56 * t49 - t55 - t68 * t59;
    let t79 = t78 * t69;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t57
            - R::literal(3.333_333_333_333_333_5) - t23 * t4 - t51 * t46 - t62 * t61
            - t71 * t70);
    let t81 = R::literal(-2_777.777_777_777_778) * t4 + t73 * t70;
    let t82 = t81 * t80;
    let t83 = t21 - t24 * t4 - t75 * t70;
    let t84 = t83 * t80;
    let t85 = t63 - t54 * t46 - t65 * t61 - t77 * t70;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t66 + t56 * t46 - t68 * t61
        - t79 * t70;
    let t88 = t87 * t80;
    let t89 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t73 * t72 - t82 * t81);
    let t90 = t75 * t72 - t24 - t84 * t81;
    let t91 = t90 * t89;
    let t92 = t27 * t89;
    let t93 = t28 * t89;
    let t94 = t77 * t72 - t86 * t81;
    let t95 = t94 * t89;
    let t96 = t79 * t72 - t88 * t81;
    let t97 = t96 * t89;
    let t98 = R::literal(1.0)
        / (-(t20 * sin_cylinder_phi) - t21 * cos_cylinder_phi - t24 * slide
            - t25 * sin_cylinder_phi - t26 * cos_cylinder_phi - t75 * t74 - t84 * t83
            - t91 * t90);
    let t99 = t25 - t92 * t90;
    let t100 = t99 * t98;
    let t101 = t93 * t90 - t26;
    let t102 = t101 * t98;
    let t103 = -(t77 * t74) - t86 * t83 - t95 * t90;
    let t104 = t103 * t98;
    let t105 = -(t79 * t74) - t88 * t83 - t97 * t90;
    let t106 = t105 * t98;
    let t107 = R::literal(1.0) / (R::literal(-5.0) - t27 * t7 - t92 * t27 - t100 * t99);
    let t108 = t28 * t7 + t93 * t27 - t102 * t99;
    let t109 = t108 * t107;
    let t110 = -(t95 * t27) - t104 * t99;
    let t111 = t110 * t107;
    let t112 = -(t97 * t27) - t106 * t99;
    let t113 = t112 * t107;
    let t114 = R::literal(1.0)
        / (R::literal(-5.0) - t28 * t6 - t93 * t28 - t102 * t101 - t109 * t108);
    let t115 = t95 * t28 - t104 * t101 - t111 * t108;
    let t116 = t115 * t114;
    let t117 = t97 * t28 - t106 * t101 - t113 * t108;
    let t118 = t117 * t114;
    let t119 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t12
            - R::literal(1.428_571_428_571_428_6) - t54 * t53 - t65 * t64 - t77 * t76
            - t86 * t85 - t95 * t94 - t104 * t103 - t111 * t110 - t116 * t115);
    let t120 = t19 * t12 + t56 * t53 - t68 * t64 - t79 * t76 - t88 * t85 - t97 * t94
        - t106 * t103 - t113 * t110 - t118 * t115;
    let t121 = t120 * t119;
    let t122 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t19 * t13
            - R::literal(1.428_571_428_571_428_6) - t56 * t55 - t68 * t67 - t79 * t78
            - t88 * t87 - t97 * t96 - t106 * t105 - t113 * t112 - t118 * t117
            - t121 * t120);
    let t123 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t8) - R::literal(1500.0) * stop_rate * t8,
    );
    let t124 = p.spring_stiffness * (slide - R::literal(0.116));
    let t125 = t124 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t126 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t127 = t125 + t126;
    let t128 = t124 * sin_cylinder_phi;
    let t129 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t130 = t129 - (R::literal(2.943) - t128);
    let t131 = -(t124 * t11) - spring_damping_times_slide_rate * t11;
    let t132 = -t125 - t126;
    let t133 = -t129 - (R::literal(1.962) + t128);
    let t134 = R::literal(0.1) * (post_omega * post_omega);
    let t135 = t134 * cos_post_phi;
    let t136 = t134 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t137 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t138 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t139 = R::literal(0.06) * (rod_omega * rod_omega);
    let t140 = t14 * t123;
    let t141 = -t135 - t140;
    let t142 = t15 * t123;
    let t143 = t33 * t141;
    let t144 = -t136 - R::literal(-9.81) + t142 - t143;
    let t145 = -(t137 * cos_plate_phi + t135) - t140 - t35 * t141 - t41 * t144;
    let t146 = -(t137 * sin_plate_phi + t136) - R::literal(9.81) + t142
        - R::literal(-9.81) - t143 - t43 * t144 - t48 * t145;
    let t147 = R::literal(3.333_333_333_333_333_5) * t127;
    let t148 = -(R::literal(0.06)
        * (plate_omega_squared * cos_plate_phi
            + cylinder_omega_squared * cos_cylinder_phi)) - t147 - t22 * t131
        - t50 * t145 - t60 * t146;
    let t149 = R::literal(3.333_333_333_333_333_5) * t130;
    let t150 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t149
        + t23 * t131 - t51 * t145 - t62 * t146 - t71 * t148;
    let t151 = t73 * t148 - R::literal(-2_777.777_777_777_778) * t131 - t82 * t150;
    let t152 = t138 - t20 * t127 + t21 * t130 + t24 * t131 + t25 * t132 - t26 * t133
        - t75 * t148 - t84 * t150 - t91 * t151;
    let t153 = R::literal(5.0) * t132;
    let t154 = t139 * cos_rod_phi - t153 - t92 * t151 - t100 * t152;
    let t155 = R::literal(5.0) * t133;
    let t156 = t139 * sin_rod_phi - t155 + t93 * t151 - t102 * t152 - t109 * t154;
    let t157 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_stiffness_times_contact_gap * t9 / between)
                - contact_damping_times_contact_rate * t9 / between,
        );
    let t158 = t13 * plate_omega_squared - t157 - t54 * t145 - t65 * t146 - t77 * t148
        - t86 * t150 - t95 * t151 - t104 * t152 - t111 * t154 - t116 * t156;
    let t159 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_damping_times_contact_rate * t10 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    contact_stiffness_times_contact_gap * t10 / between,
                )));
    let t160 = (t12 * plate_omega_squared - R::literal(9.81) - t159 + t56 * t145
        - t68 * t146 - t79 * t148 - t88 * t150 - t97 * t151 - t106 * t152 - t113 * t154
        - t118 * t156 - t121 * t158) * t122;
    let t161 = t158 * t119 - t121 * t160;
    let t162 = t156 * t114 - t116 * t161 - t118 * t160;
    let t163 = t154 * t107 - t109 * t162 - t111 * t161 - t113 * t160;
    let t164 = t152 * t98 - t100 * t163 - t102 * t162 - t104 * t161 - t106 * t160;
    let t165 = t151 * t89 - t91 * t164 - t92 * t163 + t93 * t162 - t95 * t161
        - t97 * t160;
    let t166 = t150 * t80 - t82 * t165 - t84 * t164 - t86 * t161 - t88 * t160;
    let t167 = t148 * t69 - t71 * t166 + t73 * t165 - t75 * t164 - t77 * t161
        - t79 * t160;
    let t168 = t146 * t58 - t60 * t167 - t62 * t166 - t65 * t161 - t68 * t160;
    let t169 = t145 * t45 - t48 * t168 - t50 * t167 - t51 * t166 - t54 * t161
        + t56 * t160;
    let t170 = t144 * t39 - t41 * t169 - t43 * t168;
    let t171 = t141 * t31 - t33 * t170 - t35 * t169 - t33 * t168;
    let bobbin_v_y_dot = t159 - R::literal(1.428_571_428_571_428_6) * t160;
    let bobbin_v_x_dot = t157 - R::literal(1.428_571_428_571_428_6) * t161;
    let rod_omega_dot = t27 * t163 - R::literal(4_166.666_666_666_667) * t165
        - t28 * t162;
    let rod_v_y_dot = t155 - t26 * t164 - R::literal(5.0) * t162;
    let rod_v_x_dot = t153 + t25 * t164 - R::literal(5.0) * t163;
    let cylinder_omega_dot = t131 * R::literal(2_777.777_777_777_778) - t22 * t167
        + t23 * t166 - R::literal(-2_777.777_777_777_778) * t165 + t24 * t164;
    let cylinder_v_y_dot = t149 - R::literal(3.333_333_333_333_333_5) * t166
        + t21 * t164;
    let cylinder_v_x_dot = t147 - R::literal(3.333_333_333_333_333_5) * t167
        - t20 * t164;
    let plate_omega_dot = t17 * t168 - t16 * t169 - t16 * t167 + t17 * t166 + t18 * t161
        - t19 * t160;
    let plate_v_y_dot = R::literal(-9.81) - R::literal(0.833_333_333_333_333_4) * t168
        - R::literal(-0.833_333_333_333_333_4) * t166
        - R::literal(-0.833_333_333_333_333_4) * t160;
    let plate_v_x_dot = -(R::literal(0.833_333_333_333_333_4) * t169)
        - R::literal(-0.833_333_333_333_333_4) * t167
        - R::literal(-0.833_333_333_333_333_4) * t161;
    let post_omega_dot = t123 * R::literal(370.370_370_370_370_3) - t14 * t171
        + t15 * t170 - t14 * t169 + t15 * t168;
    let post_v_y_dot = R::literal(-9.81) - R::literal(1.25) * t170
        - R::literal(-1.25) * t168;
    let post_v_x_dot = -(R::literal(1.25) * t171) - R::literal(-1.25) * t169;
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
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// No operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 14] {
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
        R::literal(0.7),
        R::literal(0.7),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 81 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [_, _, post_phi, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _,
    bobbin_x, bobbin_y, _, _, post_omega, _, _, _, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed,
    stop_closed] = *state;
    let cos_post_phi = post_phi.cos();
    let sin_post_phi = post_phi.sin();
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let t0 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let stop_rate = post_omega * t0;
    let t1 = bobbin_x - R::literal(0.328);
    let t2 = bobbin_y - R::literal(0.058);
    let between = (t1 * t1 + t2 * t2).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t1 + bobbin_v_y * t2) / between;
    let t3 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t3 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let post_phi_forcing = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t0) - R::literal(1500.0) * stop_rate * t0,
    );
    let t4 = p.spring_stiffness * (slide - R::literal(0.116));
    let t5 = t4 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t6 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let cylinder_x_forcing = t5 + t6;
    let t7 = t4 * sin_cylinder_phi;
    let t8 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let cylinder_y_forcing = t8 - (R::literal(2.943) - t7);
    let cylinder_phi_forcing = -(t4 * t3) - spring_damping_times_slide_rate * t3;
    let rod_x_forcing = -t5 - t6;
    let rod_y_forcing = -t8 - (R::literal(1.962) + t7);
    let bobbin_x_forcing = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_stiffness_times_contact_gap * t1 / between)
            - contact_damping_times_contact_rate * t1 / between,
    );
    let bobbin_y_forcing = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_damping_times_contact_rate * t2 / between),
    )
        - (R::literal(6.867)
            + R::select_less(
                contact_closed,
                R::literal(0.5),
                R::literal(0.0),
                contact_stiffness_times_contact_gap * t2 / between,
            ));
    [
        R::literal(0.0),
        R::literal(-7.848),
        post_phi_forcing,
        R::literal(0.0),
        R::literal(-11.772),
        R::literal(0.0),
        cylinder_x_forcing,
        cylinder_y_forcing,
        cylinder_phi_forcing,
        rod_x_forcing,
        rod_y_forcing,
        R::literal(0.0),
        bobbin_x_forcing,
        bobbin_y_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 5083 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 294] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 5082 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 294] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, _, post_omega, _, _, plate_omega,
    cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
    bobbin_v_y, contact_closed, stop_closed] = *state;
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
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let t8 = R::literal(0.01) * cos_plate_phi;
    let t9 = R::literal(0.1) * sin_plate_phi;
    let t10 = R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * sin_plate_phi;
    let t12 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let stop_rate = post_omega * t12;
    let t13 = bobbin_x - R::literal(0.328);
    let t14 = t13 * t13;
    let t15 = bobbin_y - R::literal(0.058);
    let t16 = t15 * t15;
    let between = (t14 + t16).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t13 + bobbin_v_y * t15) / between;
    let t17 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t18 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t19 = t18 - t17;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = cylinder_omega * t19 + rod_v_x_minus_cylinder_v_x * cos_cylinder_phi
        + rod_v_y_minus_cylinder_v_y * sin_cylinder_phi;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t20 = t11 + t10;
    let t21 = t9 - t8;
    let t22 = t8 - t9;
    let t23 = t1 * R::literal(370.370_370_370_370_3);
    let t24 = t0 * R::literal(370.370_370_370_370_3);
    let t25 = t3 * R::literal(400.0);
    let t26 = t2 * R::literal(400.0);
    let t27 = t20 * R::literal(400.0);
    let t28 = t22 * R::literal(400.0);
    let t29 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t30 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t31 = t5 * R::literal(2_777.777_777_777_778);
    let t32 = t4 * R::literal(2_777.777_777_777_778);
    let t33 = slide * R::literal(2_777.777_777_777_778);
    let t34 = sin_cylinder_phi * R::literal(5.0);
    let t35 = cos_cylinder_phi * R::literal(5.0);
    let t36 = t7 * R::literal(4_166.666_666_666_667);
    let t37 = t6 * R::literal(4_166.666_666_666_667);
    let t38 = t23 * t1;
    let t39 = R::literal(-1.25) - t38;
    let t40 = R::literal(1.0) / t39;
    let t41 = t24 * t1;
    let t42 = t41 * t40;
    let t43 = R::literal(1.25) - t38;
    let t44 = t43 * t40;
    let t45 = t24 * t0;
    let t46 = R::literal(-1.25) - t45;
    let t47 = t42 * t41;
    let t48 = R::literal(1.0) / (t46 - t47);
    let t49 = t23 * t0 - t44 * t41;
    let t50 = t49 * t48;
    let t51 = R::literal(1.25) - t45 - t47;
    let t52 = t51 * t48;
    let t53 = t25 * t3;
    let t54 = R::literal(1.0)
        / (t39 - R::literal(0.833_333_333_333_333_4) - t53 - t44 * t43 - t50 * t49);
    let t55 = t26 * t3;
    let t56 = t41 + t55 - t42 * t43 - t52 * t49;
    let t57 = t56 * t54;
    let t58 = R::literal(0.833_333_333_333_333_4) - t53;
    let t59 = t58 * t54;
    let t60 = t55 * t54;
    let t61 = t27 * t3;
    let t62 = R::literal(0.833_333_333_333_333_4) + t61;
    let t63 = t62 * t54;
    let t64 = t28 * t3;
    let t65 = t64 * t54;
    let t66 = t26 * t2;
    let t67 = R::literal(1.0)
        / (t46 - R::literal(0.833_333_333_333_333_4) - t66 - t47 - t52 * t51
            - t57 * t56);
    let t68 = t25 * t2 - t59 * t56;
    let t69 = t68 * t67;
    let t70 = R::literal(0.833_333_333_333_333_4) - t66 - t60 * t56;
    let t71 = t70 * t67;
    let t72 = -(t27 * t2);
    let t73 = t72 - t63 * t56;
    let t74 = t73 * t67;
    let t75 = t28 * t2;
    let t76 = R::literal(0.833_333_333_333_333_4) + t75 + t65 * t56;
    let t77 = t76 * t67;
    let t78 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t53
            - R::literal(3.333_333_333_333_333_5) - t31 * t5 - t59 * t58 - t69 * t68);
    let t79 = t55 + t32 * t5 - t60 * t58 - t71 * t68;
    let t80 = t79 * t78;
    let t81 = R::literal(-2_777.777_777_777_778) * t5;
    let t82 = t81 * t78;
    let t83 = t33 * t5 - t29;
    let t84 = t83 * t78;
    let t85 = R::literal(-0.833_333_333_333_333_4) + t61 - t63 * t58 - t74 * t68;
    let t86 = t85 * t78;
    let t87 = t65 * t58 - t64 - t77 * t68;
    let t88 = t87 * t78;
    let t89 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5) - t32 * t4 - t60 * t55 - t71 * t70
            - t80 * t79);
    let t90 = R::literal(-2_777.777_777_777_778) * t4 + t82 * t79;
    let t91 = t90 * t89;
    let t92 = t30 - t33 * t4 - t84 * t79;
    let t93 = t92 * t89;
    let t94 = t72 - t63 * t55 - t74 * t70 - t86 * t79;
    let t95 = t94 * t89;
    let t96 = R::literal(-0.833_333_333_333_333_4) + t75 + t65 * t55 - t77 * t70
        - t88 * t79;
    let t97 = t96 * t89;
    let t98 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t82 * t81 - t91 * t90);
    let t99 = t84 * t81 - t33 - t93 * t90;
    let t100 = t99 * t98;
    let t101 = t36 * t98;
    let t102 = t37 * t98;
    let t103 = t86 * t81 - t95 * t90;
    let t104 = t103 * t98;
    let t105 = t88 * t81 - t97 * t90;
    let t106 = t105 * t98;
    let t107 = R::literal(1.0)
        / (-(t29 * sin_cylinder_phi) - t30 * cos_cylinder_phi - t33 * slide
            - t34 * sin_cylinder_phi - t35 * cos_cylinder_phi - t84 * t83 - t93 * t92
            - t100 * t99);
    let t108 = t34 - t101 * t99;
    let t109 = t108 * t107;
    let t110 = t102 * t99 - t35;
    let t111 = t110 * t107;
    let t112 = -(t86 * t83) - t95 * t92 - t104 * t99;
    let t113 = t112 * t107;
    let t114 = -(t88 * t83) - t97 * t92 - t106 * t99;
    let t115 = t114 * t107;
    let t116 = R::literal(1.0)
        / (R::literal(-5.0) - t36 * t7 - t101 * t36 - t109 * t108);
    let t117 = t37 * t7 + t102 * t36 - t111 * t108;
    let t118 = t117 * t116;
    let t119 = -(t104 * t36) - t113 * t108;
    let t120 = t119 * t116;
    let t121 = -(t106 * t36) - t115 * t108;
    let t122 = t121 * t116;
    let t123 = R::literal(1.0)
        / (R::literal(-5.0) - t37 * t6 - t102 * t37 - t111 * t110 - t118 * t117);
    let t124 = t104 * t37 - t113 * t110 - t120 * t117;
    let t125 = t124 * t123;
    let t126 = t106 * t37 - t115 * t110 - t122 * t117;
    let t127 = t126 * t123;
    let t128 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t27 * t20
            - R::literal(1.428_571_428_571_428_6) - t63 * t62 - t74 * t73 - t86 * t85
            - t95 * t94 - t104 * t103 - t113 * t112 - t120 * t119 - t125 * t124);
    let t129 = t28 * t20 + t65 * t62 - t77 * t73 - t88 * t85 - t97 * t94 - t106 * t103
        - t115 * t112 - t122 * t119 - t127 * t124;
    let t130 = t129 * t128;
    let t131 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t28 * t22
            - R::literal(1.428_571_428_571_428_6) - t65 * t64 - t77 * t76 - t88 * t87
            - t97 * t96 - t106 * t105 - t115 * t114 - t122 * t121 - t127 * t126
            - t130 * t129);
    let t132 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t12)
            - R::literal(1500.0) * stop_rate * t12,
    );
    let t133 = slide - R::literal(0.116);
    let t134 = p.spring_stiffness * t133;
    let t135 = t134 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t136 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t137 = t135 + t136;
    let t138 = t134 * sin_cylinder_phi;
    let t139 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t140 = t139 - (R::literal(2.943) - t138);
    let t141 = -(t134 * t19) - spring_damping_times_slide_rate * t19;
    let t142 = -t135;
    let t143 = t142 - t136;
    let t144 = -t139 - (R::literal(1.962) + t138);
    let t145 = contact_stiffness_times_contact_gap * t13;
    let t146 = R::literal(0.1) * (post_omega * post_omega);
    let t147 = t146 * cos_post_phi;
    let t148 = -t147;
    let t149 = t146 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t150 = R::literal(0.06) * plate_omega_squared;
    let t151 = t150 * cos_plate_phi;
    let t152 = t150 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t153 = cylinder_omega_squared * cos_cylinder_phi;
    let t154 = cylinder_omega_squared * sin_cylinder_phi;
    let t155 = R::literal(2.0) * cylinder_v_x;
    let t156 = R::literal(2.0) * cylinder_v_y;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let t157 = cylinder_y_times_cylinder_omega * cos_cylinder_phi;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let t158 = rod_x_times_cylinder_omega * sin_cylinder_phi;
    let t159 = R::literal(2.0) * rod_v_x;
    let t160 = R::literal(2.0) * rod_v_y;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let t161 = cylinder_x_times_cylinder_omega * sin_cylinder_phi;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t162 = rod_y_times_cylinder_omega * cos_cylinder_phi;
    let t163 = R::literal(0.06) * (rod_omega * rod_omega);
    let t164 = t163 * cos_rod_phi;
    let t165 = t163 * sin_rod_phi;
    let t166 = t22 * plate_omega_squared;
    let t167 = t23 * t132;
    let t168 = t148 - t167;
    let t169 = t24 * t132;
    let t170 = t42 * t168;
    let t171 = -t149 - R::literal(-9.81) + t169 - t170;
    let t172 = -(t151 + t147) - t167 - t44 * t168 - t50 * t171;
    let t173 = -(t152 + t149) - R::literal(9.81) + t169 - R::literal(-9.81) - t170
        - t52 * t171 - t57 * t172;
    let t174 = R::literal(3.333_333_333_333_333_5) * t137;
    let t175 = -(R::literal(0.06) * (plate_omega_squared * cos_plate_phi + t153)) - t174
        - t31 * t141 - t59 * t172 - t69 * t173;
    let t176 = R::literal(3.333_333_333_333_333_5) * t140;
    let t177 = -(R::literal(0.06) * (plate_omega_squared * sin_plate_phi + t154))
        - R::literal(9.81) - t176 + t32 * t141 - t60 * t172 - t71 * t173 - t80 * t175;
    let t178 = t82 * t175 - R::literal(-2_777.777_777_777_778) * t141 - t91 * t177;
    let t179 = cylinder_omega
        * (t159 * cos_cylinder_phi + t160 * sin_cylinder_phi + t161 + t162
            - t155 * cos_cylinder_phi - t156 * sin_cylinder_phi - t157 - t158)
        - t29 * t137 + t30 * t140 + t33 * t141 + t34 * t143 - t35 * t144 - t84 * t175;
    let t180 = t179 - t93 * t177 - t100 * t178;
    let t181 = R::literal(5.0) * t143;
    let t182 = t164 - t181 - t101 * t178 - t109 * t180;
    let t183 = R::literal(5.0) * t144;
    let t184 = t165 - t183 + t102 * t178 - t111 * t180 - t118 * t182;
    let t185 = t166
        - R::literal(1.428_571_428_571_428_6)
            * R::select_less(
                contact_closed,
                R::literal(0.5),
                R::literal(0.0),
                -(t145 / between) - contact_damping_times_contact_rate * t13 / between,
            ) - t63 * t172 - t74 * t173 - t86 * t175 - t95 * t177 - t104 * t178
        - t113 * t180 - t120 * t182 - t125 * t184;
    let t186 = t20 * plate_omega_squared - R::literal(9.81)
        - R::literal(1.428_571_428_571_428_6)
            * (R::select_less(
                contact_closed,
                R::literal(0.5),
                R::literal(0.0),
                -(contact_damping_times_contact_rate * t15 / between),
            )
                - (R::literal(6.867)
                    + R::select_less(
                        contact_closed,
                        R::literal(0.5),
                        R::literal(0.0),
                        contact_stiffness_times_contact_gap * t15 / between,
                    ))) + t65 * t172 - t77 * t173 - t88 * t175 - t97 * t177
        - t106 * t178;
    let t187 = (t186 - t115 * t180 - t122 * t182 - t127 * t184 - t130 * t185) * t131;
    let t188 = t185 * t128 - t130 * t187;
    let t189 = t184 * t123 - t125 * t188 - t127 * t187;
    let t190 = t182 * t116 - t118 * t189 - t120 * t188 - t122 * t187;
    let t191 = t180 * t107 - t109 * t190 - t111 * t189 - t113 * t188 - t115 * t187;
    let t192 = t178 * t98 - t100 * t191 - t101 * t190 + t102 * t189 - t104 * t188
        - t106 * t187;
    let t193 = t177 * t89 - t91 * t192 - t93 * t191 - t95 * t188 - t97 * t187;
    let t194 = t175 * t78 - t80 * t193 + t82 * t192 - t84 * t191 - t86 * t188
        - t88 * t187;
    let t195 = t173 * t67 - t69 * t194 - t71 * t193 - t74 * t188 - t77 * t187;
    let t196 = t172 * t54 - t57 * t195 - t59 * t194 - t60 * t193 - t63 * t188
        + t65 * t187;
    let t197 = t171 * t48 - t50 * t196 - t52 * t195;
    let t198 = t168 * t40 - t42 * t197 - t44 * t196 - t42 * t195;
    let rod_omega_dot = t36 * t190 - R::literal(4_166.666_666_666_667) * t192
        - t37 * t189;
    let rod_v_y_dot = t183 - t35 * t191 - R::literal(5.0) * t189;
    let rod_v_x_dot = t181 + t34 * t191 - R::literal(5.0) * t190;
    let cylinder_omega_dot = t141 * R::literal(2_777.777_777_777_778) - t31 * t194
        + t32 * t193 - R::literal(-2_777.777_777_777_778) * t192 + t33 * t191;
    let cylinder_v_y_dot = t176 - R::literal(3.333_333_333_333_333_5) * t193
        + t30 * t191;
    let cylinder_v_x_dot = t174 - R::literal(3.333_333_333_333_333_5) * t194
        - t29 * t191;
    let plate_omega_dot = t26 * t195 - t25 * t196 - t25 * t194 + t26 * t193 + t27 * t188
        - t28 * t187;
    let post_omega_dot = t132 * R::literal(370.370_370_370_370_3) - t23 * t198
        + t24 * t197 - t23 * t196 + t24 * t195;
    let t199 = t12 * t12;
    let t200 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        R::literal(3000.0) * stop_gap * stop_rate
            + R::literal(1_000_000.0) * (stop_gap * stop_gap)
            - R::literal(1_000_000.0) * t199,
    ) - t0 * t198 - t1 * t197 - t0 * t196 - t1 * t195;
    let t201 = t149 - t0 * post_omega_dot - t23 * t200;
    let t202 = t148 - t1 * post_omega_dot + t24 * t200 - t42 * t201;
    let t203 = t201 - t44 * t201 - t50 * t202;
    let t204 = t202 - t52 * t202 - t57 * t203;
    let t205 = -(t59 * t203) - t69 * t204;
    let t206 = -(t60 * t203) - t71 * t204 - t80 * t205;
    let t207 = t82 * t205 - t91 * t206;
    let t208 = -(t84 * t205) - t93 * t206 - t100 * t207;
    let t209 = -(t101 * t207) - t109 * t208;
    let t210 = t102 * t207 - t111 * t208 - t118 * t209;
    let t211 = -(t63 * t203) - t74 * t204 - t86 * t205 - t95 * t206 - t104 * t207
        - t113 * t208 - t120 * t209 - t125 * t210;
    let t212 = (t65 * t203 - t77 * t204 - t88 * t205 - t97 * t206 - t106 * t207
        - t115 * t208 - t122 * t209 - t127 * t210 - t130 * t211) * t131;
    let t213 = t211 * t128 - t130 * t212;
    let t214 = t210 * t123 - t125 * t213 - t127 * t212;
    let t215 = t209 * t116 - t118 * t214 - t120 * t213 - t122 * t212;
    let t216 = t208 * t107 - t109 * t215 - t111 * t214 - t113 * t213 - t115 * t212;
    let t217 = t207 * t98 - t100 * t216 - t101 * t215 + t102 * t214 - t104 * t213
        - t106 * t212;
    let t218 = t206 * t89 - t91 * t217 - t93 * t216 - t95 * t213 - t97 * t212;
    let t219 = t205 * t78 - t80 * t218 + t82 * t217 - t84 * t216 - t86 * t213
        - t88 * t212;
    let t220 = t204 * t67 - t69 * t219 - t71 * t218 - t74 * t213 - t77 * t212;
    let t221 = t203 * t54 - t57 * t220 - t59 * t219 - t60 * t218 - t63 * t213
        + t65 * t212;
    let t222 = t202 * t48 - t50 * t221 - t52 * t220;
    let t223 = t201 * t40 - t42 * t222 - t44 * t221 - t42 * t220;
    let bobbin_v_y_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t212);
    let bobbin_v_x_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t213);
    let rod_omega_dot_by_post_phi = t36 * t215 - R::literal(4_166.666_666_666_667) * t217
        - t37 * t214;
    let rod_v_y_dot_by_post_phi = -(t35 * t216) - R::literal(5.0) * t214;
    let rod_v_x_dot_by_post_phi = t34 * t216 - R::literal(5.0) * t215;
    let cylinder_omega_dot_by_post_phi = t32 * t218 - t31 * t219
        - R::literal(-2_777.777_777_777_778) * t217 + t33 * t216;
    let cylinder_v_y_dot_by_post_phi = t30 * t216
        - R::literal(3.333_333_333_333_333_5) * t218;
    let cylinder_v_x_dot_by_post_phi = -(R::literal(3.333_333_333_333_333_5) * t219)
        - t29 * t216;
    let plate_omega_dot_by_post_phi = t26 * t220 - t25 * t221 - t25 * t219 + t26 * t218
        + t27 * t213 - t28 * t212;
    let plate_v_y_dot_by_post_phi = -(R::literal(0.833_333_333_333_333_4) * t220)
        - R::literal(-0.833_333_333_333_333_4) * t218
        - R::literal(-0.833_333_333_333_333_4) * t212;
    let plate_v_x_dot_by_post_phi = -(R::literal(0.833_333_333_333_333_4) * t221)
        - R::literal(-0.833_333_333_333_333_4) * t219
        - R::literal(-0.833_333_333_333_333_4) * t213;
    let post_omega_dot_by_post_phi = t200 * R::literal(370.370_370_370_370_3)
        - t23 * t223 + t24 * t222 - t23 * t221 + t24 * t220;
    let post_v_y_dot_by_post_phi = -(R::literal(1.25) * t222) - R::literal(-1.25) * t220;
    let post_v_x_dot_by_post_phi = -(R::literal(1.25) * t223) - R::literal(-1.25) * t221;
    let t224 = -(t2 * t196) - t3 * t195 - t2 * t194 - t3 * t193 - t21 * t188
        + t20 * t187;
    let t225 = t152 - t2 * plate_omega_dot - t25 * t224;
    let t226 = -t151 - t3 * plate_omega_dot + t26 * t224;
    let t227 = t226 - t57 * t225;
    let t228 = t225 - t59 * t225 - t69 * t227;
    let t229 = t226 - t60 * t225 - t71 * t227 - t80 * t228;
    let t230 = t82 * t228 - t91 * t229;
    let t231 = -(t84 * t228) - t93 * t229 - t100 * t230;
    let t232 = -(t101 * t230) - t109 * t231;
    let t233 = t102 * t230 - t111 * t231 - t118 * t232;
    let t234 = (-t10 - t11) * plate_omega_squared - t21 * plate_omega_dot + t27 * t224
        - t63 * t225 - t74 * t227 - t86 * t228 - t95 * t229 - t104 * t230 - t113 * t231
        - t120 * t232 - t125 * t233;
    let t235 = (t166 + t20 * plate_omega_dot - t28 * t224 + t65 * t225 - t77 * t227
        - t88 * t228 - t97 * t229 - t106 * t230 - t115 * t231 - t122 * t232 - t127 * t233
        - t130 * t234) * t131;
    let t236 = t234 * t128 - t130 * t235;
    let t237 = t233 * t123 - t125 * t236 - t127 * t235;
    let t238 = t232 * t116 - t118 * t237 - t120 * t236 - t122 * t235;
    let t239 = t231 * t107 - t109 * t238 - t111 * t237 - t113 * t236 - t115 * t235;
    let t240 = t230 * t98 - t100 * t239 - t101 * t238 + t102 * t237 - t104 * t236
        - t106 * t235;
    let t241 = t229 * t89 - t91 * t240 - t93 * t239 - t95 * t236 - t97 * t235;
    let t242 = t228 * t78 - t80 * t241 + t82 * t240 - t84 * t239 - t86 * t236
        - t88 * t235;
    let t243 = t227 * t67 - t69 * t242 - t71 * t241 - t74 * t236 - t77 * t235;
    let t244 = t225 * t54 - t57 * t243 - t59 * t242 - t60 * t241 - t63 * t236
        + t65 * t235;
    let t245 = -(t50 * t244) - t52 * t243;
    let t246 = -(t42 * t245) - t44 * t244 - t42 * t243;
    let bobbin_v_y_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t235);
    let bobbin_v_x_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t236);
    let rod_omega_dot_by_plate_phi = t36 * t238
        - R::literal(4_166.666_666_666_667) * t240 - t37 * t237;
    let rod_v_y_dot_by_plate_phi = -(t35 * t239) - R::literal(5.0) * t237;
    let rod_v_x_dot_by_plate_phi = t34 * t239 - R::literal(5.0) * t238;
    let cylinder_omega_dot_by_plate_phi = t32 * t241 - t31 * t242
        - R::literal(-2_777.777_777_777_778) * t240 + t33 * t239;
    let cylinder_v_y_dot_by_plate_phi = t30 * t239
        - R::literal(3.333_333_333_333_333_5) * t241;
    let cylinder_v_x_dot_by_plate_phi = -(R::literal(3.333_333_333_333_333_5) * t242)
        - t29 * t239;
    let plate_omega_dot_by_plate_phi = t224 * R::literal(400.0) - t25 * t244 + t26 * t243
        - t25 * t242 + t26 * t241 + t27 * t236 - t28 * t235;
    let plate_v_y_dot_by_plate_phi = -(R::literal(0.833_333_333_333_333_4) * t243)
        - R::literal(-0.833_333_333_333_333_4) * t241
        - R::literal(-0.833_333_333_333_333_4) * t235;
    let plate_v_x_dot_by_plate_phi = -(R::literal(0.833_333_333_333_333_4) * t244)
        - R::literal(-0.833_333_333_333_333_4) * t242
        - R::literal(-0.833_333_333_333_333_4) * t236;
    let post_omega_dot_by_plate_phi = t24 * t245 - t23 * t246 - t23 * t244 + t24 * t243;
    let post_v_y_dot_by_plate_phi = -(R::literal(1.25) * t245)
        - R::literal(-1.25) * t243;
    let post_v_x_dot_by_plate_phi = -(R::literal(1.25) * t246)
        - R::literal(-1.25) * t244;
    let t247 = p.spring_stiffness * cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t248 = spring_damping_times_cylinder_omega * sin_cylinder_phi;
    let t249 = t248 - t247;
    let t250 = t249 * cos_cylinder_phi;
    let t251 = t249 * sin_cylinder_phi;
    let t252 = spring_damping_times_cylinder_omega * t19;
    let t253 = t252 * sin_cylinder_phi;
    let t254 = p.spring_stiffness * t19;
    let t255 = t254 * cos_cylinder_phi;
    let t256 = t247 - t248;
    let t257 = t256 * cos_cylinder_phi;
    let t258 = t256 * sin_cylinder_phi;
    let t259 = cos_cylinder_phi * t191;
    let t260 = t255 - t253 - t138 - t139 - t259;
    let t261 = cos_cylinder_phi * cylinder_omega_dot;
    let t262 = R::literal(3.333_333_333_333_333_5) * t250;
    let t263 = -t262 - t31 * t260;
    let t264 = R::literal(3.333_333_333_333_333_5) * t251;
    let t265 = t32 * t260 - t264 - t80 * t263;
    let t266 = t82 * t263 - R::literal(-2_777.777_777_777_778) * t260 - t91 * t265;
    let t267 = t154 - t261 - t29 * t250 + t30 * t251 + t33 * t260 + t34 * t257
        - t35 * t258 - t84 * t263 - t93 * t265 - t100 * t266;
    let t268 = R::literal(5.0) * t257;
    let t269 = -t268 - t101 * t266 - t109 * t267;
    let t270 = R::literal(5.0) * t258;
    let t271 = t102 * t266 - t270 - t111 * t267 - t118 * t269;
    let t272 = -(t86 * t263) - t95 * t265 - t104 * t266 - t113 * t267 - t120 * t269
        - t125 * t271;
    let t273 = (-(t88 * t263) - t97 * t265 - t106 * t266 - t115 * t267 - t122 * t269
        - t127 * t271 - t130 * t272) * t131;
    let t274 = t272 * t128 - t130 * t273;
    let t275 = t271 * t123 - t125 * t274 - t127 * t273;
    let t276 = t269 * t116 - t118 * t275 - t120 * t274 - t122 * t273;
    let t277 = t267 * t107 - t109 * t276 - t111 * t275 - t113 * t274 - t115 * t273;
    let t278 = t266 * t98 - t100 * t277 - t101 * t276 + t102 * t275 - t104 * t274
        - t106 * t273;
    let t279 = t265 * t89 - t91 * t278 - t93 * t277 - t95 * t274 - t97 * t273;
    let t280 = t263 * t78 - t80 * t279 + t82 * t278 - t84 * t277 - t86 * t274
        - t88 * t273;
    let t281 = -(t69 * t280) - t71 * t279 - t74 * t274 - t77 * t273;
    let t282 = -(t57 * t281) - t59 * t280 - t60 * t279 - t63 * t274 + t65 * t273;
    let t283 = -(t50 * t282) - t52 * t281;
    let t284 = -(t42 * t283) - t44 * t282 - t42 * t281;
    let bobbin_v_y_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t273);
    let bobbin_v_x_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t274);
    let rod_omega_dot_by_cylinder_x = t36 * t276
        - R::literal(4_166.666_666_666_667) * t278 - t37 * t275;
    let rod_v_y_dot_by_cylinder_x = t270 - t35 * t277 - R::literal(5.0) * t275;
    let rod_v_x_dot_by_cylinder_x = t268 + t34 * t277 - R::literal(5.0) * t276;
    let cylinder_omega_dot_by_cylinder_x = t260 * R::literal(2_777.777_777_777_778)
        - t31 * t280 + t32 * t279 - R::literal(-2_777.777_777_777_778) * t278
        + t33 * t277;
    let cylinder_v_y_dot_by_cylinder_x = t264
        - R::literal(3.333_333_333_333_333_5) * t279 + t30 * t277;
    let cylinder_v_x_dot_by_cylinder_x = t262
        - R::literal(3.333_333_333_333_333_5) * t280 - t29 * t277;
    let plate_omega_dot_by_cylinder_x = t26 * t281 - t25 * t282 - t25 * t280 + t26 * t279
        + t27 * t274 - t28 * t273;
    let plate_v_y_dot_by_cylinder_x = -(R::literal(0.833_333_333_333_333_4) * t281)
        - R::literal(-0.833_333_333_333_333_4) * t279
        - R::literal(-0.833_333_333_333_333_4) * t273;
    let plate_v_x_dot_by_cylinder_x = -(R::literal(0.833_333_333_333_333_4) * t282)
        - R::literal(-0.833_333_333_333_333_4) * t280
        - R::literal(-0.833_333_333_333_333_4) * t274;
    let post_omega_dot_by_cylinder_x = t24 * t283 - t23 * t284 - t23 * t282 + t24 * t281;
    let post_v_y_dot_by_cylinder_x = -(R::literal(1.25) * t283)
        - R::literal(-1.25) * t281;
    let post_v_x_dot_by_cylinder_x = -(R::literal(1.25) * t284)
        - R::literal(-1.25) * t282;
    let t285 = spring_damping_times_cylinder_omega * cos_cylinder_phi
        + p.spring_stiffness * sin_cylinder_phi;
    let t286 = t285 * cos_cylinder_phi;
    let t287 = t285 * sin_cylinder_phi;
    let t288 = t252 * cos_cylinder_phi;
    let t289 = t254 * sin_cylinder_phi;
    let t290 = sin_cylinder_phi * t191;
    let t291 = t288 + t135 + t289 + t136 - t290;
    let t292 = sin_cylinder_phi * cylinder_omega_dot;
    let t293 = R::literal(3.333_333_333_333_333_5) * t286;
    let t294 = -t293;
    let t295 = t293 - t31 * t291;
    let t296 = R::literal(3.333_333_333_333_333_5) * t287;
    let t297 = t296 + t32 * t291 - t80 * t295;
    let t298 = t82 * t295 - R::literal(-2_777.777_777_777_778) * t291 - t91 * t297;
    let t299 = t29 * t286;
    let t300 = t30 * t287;
    let t301 = t34 * t286;
    let t302 = t35 * t287;
    let t303 = -t153 - t292 + t299 - t300 + t33 * t291 + t301 - t302 - t84 * t295
        - t93 * t297 - t100 * t298;
    let t304 = R::literal(5.0) * t286;
    let t305 = -t304 - t101 * t298 - t109 * t303;
    let t306 = R::literal(5.0) * t287;
    let t307 = t102 * t298 - t306 - t111 * t303 - t118 * t305;
    let t308 = -(t86 * t295) - t95 * t297 - t104 * t298 - t113 * t303 - t120 * t305
        - t125 * t307;
    let t309 = (-(t88 * t295) - t97 * t297 - t106 * t298 - t115 * t303 - t122 * t305
        - t127 * t307 - t130 * t308) * t131;
    let t310 = t308 * t128 - t130 * t309;
    let t311 = t307 * t123 - t125 * t310 - t127 * t309;
    let t312 = t305 * t116 - t118 * t311 - t120 * t310 - t122 * t309;
    let t313 = t303 * t107 - t109 * t312 - t111 * t311 - t113 * t310 - t115 * t309;
    let t314 = t298 * t98 - t100 * t313 - t101 * t312 + t102 * t311 - t104 * t310
        - t106 * t309;
    let t315 = t297 * t89 - t91 * t314 - t93 * t313 - t95 * t310 - t97 * t309;
    let t316 = t295 * t78 - t80 * t315 + t82 * t314 - t84 * t313 - t86 * t310
        - t88 * t309;
    let t317 = -(t69 * t316) - t71 * t315 - t74 * t310 - t77 * t309;
    let t318 = -(t57 * t317) - t59 * t316 - t60 * t315 - t63 * t310 + t65 * t309;
    let t319 = -(t50 * t318) - t52 * t317;
    let t320 = -(t42 * t319) - t44 * t318 - t42 * t317;
    let bobbin_v_y_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t309);
    let bobbin_v_x_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t310);
    let rod_omega_dot_by_cylinder_y = t36 * t312
        - R::literal(4_166.666_666_666_667) * t314 - t37 * t311;
    let rod_v_y_dot_by_cylinder_y = t306 - t35 * t313 - R::literal(5.0) * t311;
    let rod_v_x_dot_by_cylinder_y = t304 + t34 * t313 - R::literal(5.0) * t312;
    let cylinder_omega_dot_by_cylinder_y = t291 * R::literal(2_777.777_777_777_778)
        - t31 * t316 + t32 * t315 - R::literal(-2_777.777_777_777_778) * t314
        + t33 * t313;
    let cylinder_v_y_dot_by_cylinder_y = -t296
        - R::literal(3.333_333_333_333_333_5) * t315 + t30 * t313;
    let cylinder_v_x_dot_by_cylinder_y = t294
        - R::literal(3.333_333_333_333_333_5) * t316 - t29 * t313;
    let plate_omega_dot_by_cylinder_y = t26 * t317 - t25 * t318 - t25 * t316 + t26 * t315
        + t27 * t310 - t28 * t309;
    let plate_v_y_dot_by_cylinder_y = -(R::literal(0.833_333_333_333_333_4) * t317)
        - R::literal(-0.833_333_333_333_333_4) * t315
        - R::literal(-0.833_333_333_333_333_4) * t309;
    let plate_v_x_dot_by_cylinder_y = -(R::literal(0.833_333_333_333_333_4) * t318)
        - R::literal(-0.833_333_333_333_333_4) * t316
        - R::literal(-0.833_333_333_333_333_4) * t310;
    let post_omega_dot_by_cylinder_y = t24 * t319 - t23 * t320 - t23 * t318 + t24 * t317;
    let post_v_y_dot_by_cylinder_y = -(R::literal(1.25) * t319)
        - R::literal(-1.25) * t317;
    let post_v_x_dot_by_cylinder_y = -(R::literal(1.25) * t320)
        - R::literal(-1.25) * t318;
    let t321 = p.spring_damping
        * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi - cylinder_omega * slide
            - rod_v_x_minus_cylinder_v_x * sin_cylinder_phi);
    let t322 = t321 * cos_cylinder_phi;
    let t323 = t321 * sin_cylinder_phi;
    let t324 = t19 * t19;
    let t325 = R::literal(0.06) * cylinder_omega_squared;
    let t326 = t255 + t322 - t138 - t139 - t259;
    let t327 = t136 + t323 - (t142 - t289) - t290;
    let t328 = t17 - t18;
    let t329 = p.spring_stiffness * slide * t133 + p.spring_damping * slide * slide_rate
        - p.spring_stiffness * t324 - t321 * t19 - t4 * t194 - t5 * t193 - t328 * t191;
    let t330 = t138 + t139 - t255 - t322 + t259;
    let t331 = cylinder_omega
        * (t155 * sin_cylinder_phi + t160 * cos_cylinder_phi
            + cylinder_x_times_cylinder_omega * cos_cylinder_phi
            + cylinder_y_times_cylinder_omega * sin_cylinder_phi
            - t156 * cos_cylinder_phi - t159 * sin_cylinder_phi
            - rod_x_times_cylinder_omega * cos_cylinder_phi
            - rod_y_times_cylinder_omega * sin_cylinder_phi)
        - cos_cylinder_phi * cylinder_v_x_dot - sin_cylinder_phi * cylinder_v_y_dot
        - t328 * cylinder_omega_dot + cos_cylinder_phi * rod_v_x_dot;
    let t332 = -t136 - t323 - (t135 + t289) + t290;
    let t333 = R::literal(3.333_333_333_333_333_5) * t326;
    let t334 = t325 * sin_cylinder_phi - t4 * cylinder_omega_dot - t333 - t31 * t329;
    let t335 = R::literal(3.333_333_333_333_333_5) * t327;
    let t336 = -(t325 * cos_cylinder_phi) - t5 * cylinder_omega_dot - t335 + t32 * t329
        - t80 * t334;
    let t337 = t82 * t334 - R::literal(-2_777.777_777_777_778) * t329 - t91 * t336;
    let t338 = t331 + sin_cylinder_phi * rod_v_y_dot - t29 * t326 + t30 * t327
        + t33 * t329 + t34 * t330 - t35 * t332 - t84 * t334 - t93 * t336 - t100 * t337;
    let t339 = R::literal(5.0) * t330;
    let t340 = -t339 - t101 * t337 - t109 * t338;
    let t341 = R::literal(5.0) * t332;
    let t342 = t102 * t337 - t341 - t111 * t338 - t118 * t340;
    let t343 = -(t86 * t334) - t95 * t336 - t104 * t337 - t113 * t338 - t120 * t340
        - t125 * t342;
    let t344 = (-(t88 * t334) - t97 * t336 - t106 * t337 - t115 * t338 - t122 * t340
        - t127 * t342 - t130 * t343) * t131;
    let t345 = t343 * t128 - t130 * t344;
    let t346 = t342 * t123 - t125 * t345 - t127 * t344;
    let t347 = t340 * t116 - t118 * t346 - t120 * t345 - t122 * t344;
    let t348 = t338 * t107 - t109 * t347 - t111 * t346 - t113 * t345 - t115 * t344;
    let t349 = t337 * t98 - t100 * t348 - t101 * t347 + t102 * t346 - t104 * t345
        - t106 * t344;
    let t350 = t336 * t89 - t91 * t349 - t93 * t348 - t95 * t345 - t97 * t344;
    let t351 = t334 * t78 - t80 * t350 + t82 * t349 - t84 * t348 - t86 * t345
        - t88 * t344;
    let t352 = -(t69 * t351) - t71 * t350 - t74 * t345 - t77 * t344;
    let t353 = -(t57 * t352) - t59 * t351 - t60 * t350 - t63 * t345 + t65 * t344;
    let t354 = -(t50 * t353) - t52 * t352;
    let t355 = -(t42 * t354) - t44 * t353 - t42 * t352;
    let bobbin_v_y_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t344);
    let bobbin_v_x_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t345);
    let rod_omega_dot_by_cylinder_phi = t36 * t347
        - R::literal(4_166.666_666_666_667) * t349 - t37 * t346;
    let rod_v_y_dot_by_cylinder_phi = t341 - t35 * t348 - R::literal(5.0) * t346;
    let rod_v_x_dot_by_cylinder_phi = t339 + t34 * t348 - R::literal(5.0) * t347;
    let cylinder_omega_dot_by_cylinder_phi = t329 * R::literal(2_777.777_777_777_778)
        - t31 * t351 + t32 * t350 - R::literal(-2_777.777_777_777_778) * t349
        + t33 * t348;
    let cylinder_v_y_dot_by_cylinder_phi = t335
        - R::literal(3.333_333_333_333_333_5) * t350 + t30 * t348;
    let cylinder_v_x_dot_by_cylinder_phi = t333
        - R::literal(3.333_333_333_333_333_5) * t351 - t29 * t348;
    let plate_omega_dot_by_cylinder_phi = t26 * t352 - t25 * t353 - t25 * t351
        + t26 * t350 + t27 * t345 - t28 * t344;
    let plate_v_y_dot_by_cylinder_phi = -(R::literal(0.833_333_333_333_333_4) * t352)
        - R::literal(-0.833_333_333_333_333_4) * t350
        - R::literal(-0.833_333_333_333_333_4) * t344;
    let plate_v_x_dot_by_cylinder_phi = -(R::literal(0.833_333_333_333_333_4) * t353)
        - R::literal(-0.833_333_333_333_333_4) * t351
        - R::literal(-0.833_333_333_333_333_4) * t345;
    let post_omega_dot_by_cylinder_phi = t24 * t354 - t23 * t355 - t23 * t353
        + t24 * t352;
    let post_v_y_dot_by_cylinder_phi = -(R::literal(1.25) * t354)
        - R::literal(-1.25) * t352;
    let post_v_x_dot_by_cylinder_phi = -(R::literal(1.25) * t355)
        - R::literal(-1.25) * t353;
    let t356 = t253 + t138 + t139 - t255 + t259;
    let t357 = R::literal(3.333_333_333_333_333_5) * t257;
    let t358 = -t357 - t31 * t356;
    let t359 = R::literal(3.333_333_333_333_333_5) * t258;
    let t360 = t32 * t356 - t359 - t80 * t358;
    let t361 = t82 * t358 - R::literal(-2_777.777_777_777_778) * t356 - t91 * t360;
    let t362 = t261 - t154 - t29 * t257 + t30 * t258 + t33 * t356 + t34 * t250
        - t35 * t251 - t84 * t358 - t93 * t360 - t100 * t361;
    let t363 = R::literal(5.0) * t250;
    let t364 = -t363 - t101 * t361 - t109 * t362;
    let t365 = R::literal(5.0) * t251;
    let t366 = t102 * t361 - t365 - t111 * t362 - t118 * t364;
    let t367 = -(t86 * t358) - t95 * t360 - t104 * t361 - t113 * t362 - t120 * t364
        - t125 * t366;
    let t368 = (-(t88 * t358) - t97 * t360 - t106 * t361 - t115 * t362 - t122 * t364
        - t127 * t366 - t130 * t367) * t131;
    let t369 = t367 * t128 - t130 * t368;
    let t370 = t366 * t123 - t125 * t369 - t127 * t368;
    let t371 = t364 * t116 - t118 * t370 - t120 * t369 - t122 * t368;
    let t372 = t362 * t107 - t109 * t371 - t111 * t370 - t113 * t369 - t115 * t368;
    let t373 = t361 * t98 - t100 * t372 - t101 * t371 + t102 * t370 - t104 * t369
        - t106 * t368;
    let t374 = t360 * t89 - t91 * t373 - t93 * t372 - t95 * t369 - t97 * t368;
    let t375 = t358 * t78 - t80 * t374 + t82 * t373 - t84 * t372 - t86 * t369
        - t88 * t368;
    let t376 = -(t69 * t375) - t71 * t374 - t74 * t369 - t77 * t368;
    let t377 = -(t57 * t376) - t59 * t375 - t60 * t374 - t63 * t369 + t65 * t368;
    let t378 = -(t50 * t377) - t52 * t376;
    let t379 = -(t42 * t378) - t44 * t377 - t42 * t376;
    let bobbin_v_y_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t368);
    let bobbin_v_x_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t369);
    let rod_omega_dot_by_rod_x = t36 * t371 - R::literal(4_166.666_666_666_667) * t373
        - t37 * t370;
    let rod_v_y_dot_by_rod_x = t365 - t35 * t372 - R::literal(5.0) * t370;
    let rod_v_x_dot_by_rod_x = t363 + t34 * t372 - R::literal(5.0) * t371;
    let cylinder_omega_dot_by_rod_x = t356 * R::literal(2_777.777_777_777_778)
        - t31 * t375 + t32 * t374 - R::literal(-2_777.777_777_777_778) * t373
        + t33 * t372;
    let cylinder_v_y_dot_by_rod_x = t359 - R::literal(3.333_333_333_333_333_5) * t374
        + t30 * t372;
    let cylinder_v_x_dot_by_rod_x = t357 - R::literal(3.333_333_333_333_333_5) * t375
        - t29 * t372;
    let plate_omega_dot_by_rod_x = t26 * t376 - t25 * t377 - t25 * t375 + t26 * t374
        + t27 * t369 - t28 * t368;
    let plate_v_y_dot_by_rod_x = -(R::literal(0.833_333_333_333_333_4) * t376)
        - R::literal(-0.833_333_333_333_333_4) * t374
        - R::literal(-0.833_333_333_333_333_4) * t368;
    let plate_v_x_dot_by_rod_x = -(R::literal(0.833_333_333_333_333_4) * t377)
        - R::literal(-0.833_333_333_333_333_4) * t375
        - R::literal(-0.833_333_333_333_333_4) * t369;
    let post_omega_dot_by_rod_x = t24 * t378 - t23 * t379 - t23 * t377 + t24 * t376;
    let post_v_y_dot_by_rod_x = -(R::literal(1.25) * t378) - R::literal(-1.25) * t376;
    let post_v_x_dot_by_rod_x = -(R::literal(1.25) * t379) - R::literal(-1.25) * t377;
    let t380 = -t288 - t135 - t289 - t136 + t290;
    let t381 = t294 - t31 * t380;
    let t382 = t32 * t380 - t296 - t80 * t381;
    let t383 = t82 * t381 - R::literal(-2_777.777_777_777_778) * t380 - t91 * t382;
    let t384 = t153 + t292 - t299 + t300 + t33 * t380 - t301 + t302 - t84 * t381
        - t93 * t382 - t100 * t383;
    let t385 = t304 - t101 * t383 - t109 * t384;
    let t386 = t306 + t102 * t383 - t111 * t384 - t118 * t385;
    let t387 = -(t86 * t381) - t95 * t382 - t104 * t383 - t113 * t384 - t120 * t385
        - t125 * t386;
    let t388 = (-(t88 * t381) - t97 * t382 - t106 * t383 - t115 * t384 - t122 * t385
        - t127 * t386 - t130 * t387) * t131;
    let t389 = t387 * t128 - t130 * t388;
    let t390 = t386 * t123 - t125 * t389 - t127 * t388;
    let t391 = t385 * t116 - t118 * t390 - t120 * t389 - t122 * t388;
    let t392 = t384 * t107 - t109 * t391 - t111 * t390 - t113 * t389 - t115 * t388;
    let t393 = t383 * t98 - t100 * t392 - t101 * t391 + t102 * t390 - t104 * t389
        - t106 * t388;
    let t394 = t382 * t89 - t91 * t393 - t93 * t392 - t95 * t389 - t97 * t388;
    let t395 = t381 * t78 - t80 * t394 + t82 * t393 - t84 * t392 - t86 * t389
        - t88 * t388;
    let t396 = -(t69 * t395) - t71 * t394 - t74 * t389 - t77 * t388;
    let t397 = -(t57 * t396) - t59 * t395 - t60 * t394 - t63 * t389 + t65 * t388;
    let t398 = -(t50 * t397) - t52 * t396;
    let t399 = -(t42 * t398) - t44 * t397 - t42 * t396;
    let bobbin_v_y_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t388);
    let bobbin_v_x_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t389);
    let rod_omega_dot_by_rod_y = t36 * t391 - R::literal(4_166.666_666_666_667) * t393
        - t37 * t390;
    let rod_v_y_dot_by_rod_y = -t306 - t35 * t392 - R::literal(5.0) * t390;
    let rod_v_x_dot_by_rod_y = t34 * t392 - t304 - R::literal(5.0) * t391;
    let cylinder_omega_dot_by_rod_y = t380 * R::literal(2_777.777_777_777_778)
        - t31 * t395 + t32 * t394 - R::literal(-2_777.777_777_777_778) * t393
        + t33 * t392;
    let cylinder_v_y_dot_by_rod_y = t296 - R::literal(3.333_333_333_333_333_5) * t394
        + t30 * t392;
    let cylinder_v_x_dot_by_rod_y = t293 - R::literal(3.333_333_333_333_333_5) * t395
        - t29 * t392;
    let plate_omega_dot_by_rod_y = t26 * t396 - t25 * t397 - t25 * t395 + t26 * t394
        + t27 * t389 - t28 * t388;
    let plate_v_y_dot_by_rod_y = -(R::literal(0.833_333_333_333_333_4) * t396)
        - R::literal(-0.833_333_333_333_333_4) * t394
        - R::literal(-0.833_333_333_333_333_4) * t388;
    let plate_v_x_dot_by_rod_y = -(R::literal(0.833_333_333_333_333_4) * t397)
        - R::literal(-0.833_333_333_333_333_4) * t395
        - R::literal(-0.833_333_333_333_333_4) * t389;
    let post_omega_dot_by_rod_y = t24 * t398 - t23 * t399 - t23 * t397 + t24 * t396;
    let post_v_y_dot_by_rod_y = -(R::literal(1.25) * t398) - R::literal(-1.25) * t396;
    let post_v_x_dot_by_rod_y = -(R::literal(1.25) * t399) - R::literal(-1.25) * t397;
    let t400 = t6 * t190 + t7 * t189;
    let t401 = R::literal(4_166.666_666_666_667) * t400;
    let t402 = t100 * t401;
    let t403 = t6 * rod_omega_dot - t165 + t36 * t400 + t101 * t401 - t109 * t402;
    let t404 = t164 + t7 * rod_omega_dot - t37 * t400 - t102 * t401 - t111 * t402
        - t118 * t403;
    let t405 = t104 * t401 - t113 * t402 - t120 * t403 - t125 * t404;
    let t406 = (t106 * t401 - t115 * t402 - t122 * t403 - t127 * t404 - t130 * t405)
        * t131;
    let t407 = t405 * t128 - t130 * t406;
    let t408 = t404 * t123 - t125 * t407 - t127 * t406;
    let t409 = t403 * t116 - t118 * t408 - t120 * t407 - t122 * t406;
    let t410 = t402 * t107 - t109 * t409 - t111 * t408 - t113 * t407 - t115 * t406;
    let t411 = -(t401 * t98) - t100 * t410 - t101 * t409 + t102 * t408 - t104 * t407
        - t106 * t406;
    let t412 = -(t91 * t411) - t93 * t410 - t95 * t407 - t97 * t406;
    let t413 = t82 * t411 - t80 * t412 - t84 * t410 - t86 * t407 - t88 * t406;
    let t414 = -(t69 * t413) - t71 * t412 - t74 * t407 - t77 * t406;
    let t415 = -(t57 * t414) - t59 * t413 - t60 * t412 - t63 * t407 + t65 * t406;
    let t416 = -(t50 * t415) - t52 * t414;
    let t417 = -(t42 * t416) - t44 * t415 - t42 * t414;
    let bobbin_v_y_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t406);
    let bobbin_v_x_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t407);
    let rod_omega_dot_by_rod_phi = t401 - R::literal(4_166.666_666_666_667) * t411
        + t36 * t409 - t37 * t408;
    let rod_v_y_dot_by_rod_phi = -(t35 * t410) - R::literal(5.0) * t408;
    let rod_v_x_dot_by_rod_phi = t34 * t410 - R::literal(5.0) * t409;
    let cylinder_omega_dot_by_rod_phi = t32 * t412 - t31 * t413
        - R::literal(-2_777.777_777_777_778) * t411 + t33 * t410;
    let cylinder_v_y_dot_by_rod_phi = t30 * t410
        - R::literal(3.333_333_333_333_333_5) * t412;
    let cylinder_v_x_dot_by_rod_phi = -(R::literal(3.333_333_333_333_333_5) * t413)
        - t29 * t410;
    let plate_omega_dot_by_rod_phi = t26 * t414 - t25 * t415 - t25 * t413 + t26 * t412
        + t27 * t407 - t28 * t406;
    let plate_v_y_dot_by_rod_phi = -(R::literal(0.833_333_333_333_333_4) * t414)
        - R::literal(-0.833_333_333_333_333_4) * t412
        - R::literal(-0.833_333_333_333_333_4) * t406;
    let plate_v_x_dot_by_rod_phi = -(R::literal(0.833_333_333_333_333_4) * t415)
        - R::literal(-0.833_333_333_333_333_4) * t413
        - R::literal(-0.833_333_333_333_333_4) * t407;
    let post_omega_dot_by_rod_phi = t24 * t416 - t23 * t417 - t23 * t415 + t24 * t414;
    let post_v_y_dot_by_rod_phi = -(R::literal(1.25) * t416) - R::literal(-1.25) * t414;
    let post_v_x_dot_by_rod_phi = -(R::literal(1.25) * t417) - R::literal(-1.25) * t415;
    let between_squared = between * between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t418 = contact_stiffness_times_contact_gap / between;
    let t419 = contact_damping_times_contact_rate / between;
    let between_squared_times_between = between_squared * between;
    let t420 = c.t0 * contact_rate;
    let t421 = t420 * t13 * t15 / between_squared_times_between;
    let t422 = t145 * t15 / between_squared_times_between;
    let t423 = p.contact_stiffness * t13 * t15 / between_squared;
    let t424 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t420 * t14 / between_squared_times_between
                + contact_stiffness_times_contact_gap * t14
                    / between_squared_times_between
                - contact_damping_times_bobbin_v_x * t13 / between_squared - t418
                - p.contact_stiffness * t14 / between_squared - t419,
        );
    let t425 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t421 - contact_damping_times_bobbin_v_x * t15 / between_squared
                - (t423 - t422),
        );
    let t426 = (t130 * t424 - t425) * t131;
    let t427 = -(t424 * t128) - t130 * t426;
    let t428 = -(t125 * t427) - t127 * t426;
    let t429 = -(t118 * t428) - t120 * t427 - t122 * t426;
    let t430 = -(t109 * t429) - t111 * t428 - t113 * t427 - t115 * t426;
    let t431 = -(t100 * t430) - t101 * t429 + t102 * t428 - t104 * t427 - t106 * t426;
    let t432 = -(t91 * t431) - t93 * t430 - t95 * t427 - t97 * t426;
    let t433 = t82 * t431 - t80 * t432 - t84 * t430 - t86 * t427 - t88 * t426;
    let t434 = -(t69 * t433) - t71 * t432 - t74 * t427 - t77 * t426;
    let t435 = -(t57 * t434) - t59 * t433 - t60 * t432 - t63 * t427 + t65 * t426;
    let t436 = -(t50 * t435) - t52 * t434;
    let t437 = -(t42 * t436) - t44 * t435 - t42 * t434;
    let bobbin_v_y_dot_by_bobbin_x = t425 - R::literal(1.428_571_428_571_428_6) * t426;
    let bobbin_v_x_dot_by_bobbin_x = t424 - R::literal(1.428_571_428_571_428_6) * t427;
    let rod_omega_dot_by_bobbin_x = t36 * t429 - R::literal(4_166.666_666_666_667) * t431
        - t37 * t428;
    let rod_v_y_dot_by_bobbin_x = -(t35 * t430) - R::literal(5.0) * t428;
    let rod_v_x_dot_by_bobbin_x = t34 * t430 - R::literal(5.0) * t429;
    let cylinder_omega_dot_by_bobbin_x = t32 * t432 - t31 * t433
        - R::literal(-2_777.777_777_777_778) * t431 + t33 * t430;
    let cylinder_v_y_dot_by_bobbin_x = t30 * t430
        - R::literal(3.333_333_333_333_333_5) * t432;
    let cylinder_v_x_dot_by_bobbin_x = -(R::literal(3.333_333_333_333_333_5) * t433)
        - t29 * t430;
    let plate_omega_dot_by_bobbin_x = t26 * t434 - t25 * t435 - t25 * t433 + t26 * t432
        + t27 * t427 - t28 * t426;
    let plate_v_y_dot_by_bobbin_x = -(R::literal(0.833_333_333_333_333_4) * t434)
        - R::literal(-0.833_333_333_333_333_4) * t432
        - R::literal(-0.833_333_333_333_333_4) * t426;
    let plate_v_x_dot_by_bobbin_x = -(R::literal(0.833_333_333_333_333_4) * t435)
        - R::literal(-0.833_333_333_333_333_4) * t433
        - R::literal(-0.833_333_333_333_333_4) * t427;
    let post_omega_dot_by_bobbin_x = t24 * t436 - t23 * t437 - t23 * t435 + t24 * t434;
    let post_v_y_dot_by_bobbin_x = -(R::literal(1.25) * t436) - R::literal(-1.25) * t434;
    let post_v_x_dot_by_bobbin_x = -(R::literal(1.25) * t437) - R::literal(-1.25) * t435;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t438 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t421 + t422 - contact_damping_times_bobbin_v_y * t13 / between_squared - t423,
        );
    let t439 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t420 * t16 / between_squared_times_between
                - contact_damping_times_bobbin_v_y * t15 / between_squared - t419
                - (t418 + p.contact_stiffness * t16 / between_squared
                    - contact_stiffness_times_contact_gap * t16
                        / between_squared_times_between),
        );
    let t440 = (t130 * t438 - t439) * t131;
    let t441 = -(t438 * t128) - t130 * t440;
    let t442 = -(t125 * t441) - t127 * t440;
    let t443 = -(t118 * t442) - t120 * t441 - t122 * t440;
    let t444 = -(t109 * t443) - t111 * t442 - t113 * t441 - t115 * t440;
    let t445 = -(t100 * t444) - t101 * t443 + t102 * t442 - t104 * t441 - t106 * t440;
    let t446 = -(t91 * t445) - t93 * t444 - t95 * t441 - t97 * t440;
    let t447 = t82 * t445 - t80 * t446 - t84 * t444 - t86 * t441 - t88 * t440;
    let t448 = -(t69 * t447) - t71 * t446 - t74 * t441 - t77 * t440;
    let t449 = -(t57 * t448) - t59 * t447 - t60 * t446 - t63 * t441 + t65 * t440;
    let t450 = -(t50 * t449) - t52 * t448;
    let t451 = -(t42 * t450) - t44 * t449 - t42 * t448;
    let bobbin_v_y_dot_by_bobbin_y = t439 - R::literal(1.428_571_428_571_428_6) * t440;
    let bobbin_v_x_dot_by_bobbin_y = t438 - R::literal(1.428_571_428_571_428_6) * t441;
    let rod_omega_dot_by_bobbin_y = t36 * t443 - R::literal(4_166.666_666_666_667) * t445
        - t37 * t442;
    let rod_v_y_dot_by_bobbin_y = -(t35 * t444) - R::literal(5.0) * t442;
    let rod_v_x_dot_by_bobbin_y = t34 * t444 - R::literal(5.0) * t443;
    let cylinder_omega_dot_by_bobbin_y = t32 * t446 - t31 * t447
        - R::literal(-2_777.777_777_777_778) * t445 + t33 * t444;
    let cylinder_v_y_dot_by_bobbin_y = t30 * t444
        - R::literal(3.333_333_333_333_333_5) * t446;
    let cylinder_v_x_dot_by_bobbin_y = -(R::literal(3.333_333_333_333_333_5) * t447)
        - t29 * t444;
    let plate_omega_dot_by_bobbin_y = t26 * t448 - t25 * t449 - t25 * t447 + t26 * t446
        + t27 * t441 - t28 * t440;
    let plate_v_y_dot_by_bobbin_y = -(R::literal(0.833_333_333_333_333_4) * t448)
        - R::literal(-0.833_333_333_333_333_4) * t446
        - R::literal(-0.833_333_333_333_333_4) * t440;
    let plate_v_x_dot_by_bobbin_y = -(R::literal(0.833_333_333_333_333_4) * t449)
        - R::literal(-0.833_333_333_333_333_4) * t447
        - R::literal(-0.833_333_333_333_333_4) * t441;
    let post_omega_dot_by_bobbin_y = t24 * t450 - t23 * t451 - t23 * t449 + t24 * t448;
    let post_v_y_dot_by_bobbin_y = -(R::literal(1.25) * t450) - R::literal(-1.25) * t448;
    let post_v_x_dot_by_bobbin_y = -(R::literal(1.25) * t451) - R::literal(-1.25) * t449;
    let t452 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1500.0) * t199),
    );
    let t453 = R::literal(0.2) * post_omega;
    let t454 = -(t453 * cos_post_phi) - t23 * t452;
    let t455 = t24 * t452 - t453 * sin_post_phi - t42 * t454;
    let t456 = t454 - t44 * t454 - t50 * t455;
    let t457 = t455 - t52 * t455 - t57 * t456;
    let t458 = -(t59 * t456) - t69 * t457;
    let t459 = -(t60 * t456) - t71 * t457 - t80 * t458;
    let t460 = t82 * t458 - t91 * t459;
    let t461 = -(t84 * t458) - t93 * t459 - t100 * t460;
    let t462 = -(t101 * t460) - t109 * t461;
    let t463 = t102 * t460 - t111 * t461 - t118 * t462;
    let t464 = -(t63 * t456) - t74 * t457 - t86 * t458 - t95 * t459 - t104 * t460
        - t113 * t461 - t120 * t462 - t125 * t463;
    let t465 = (t65 * t456 - t77 * t457 - t88 * t458 - t97 * t459 - t106 * t460
        - t115 * t461 - t122 * t462 - t127 * t463 - t130 * t464) * t131;
    let t466 = t464 * t128 - t130 * t465;
    let t467 = t463 * t123 - t125 * t466 - t127 * t465;
    let t468 = t462 * t116 - t118 * t467 - t120 * t466 - t122 * t465;
    let t469 = t461 * t107 - t109 * t468 - t111 * t467 - t113 * t466 - t115 * t465;
    let t470 = t460 * t98 - t100 * t469 - t101 * t468 + t102 * t467 - t104 * t466
        - t106 * t465;
    let t471 = t459 * t89 - t91 * t470 - t93 * t469 - t95 * t466 - t97 * t465;
    let t472 = t458 * t78 - t80 * t471 + t82 * t470 - t84 * t469 - t86 * t466
        - t88 * t465;
    let t473 = t457 * t67 - t69 * t472 - t71 * t471 - t74 * t466 - t77 * t465;
    let t474 = t456 * t54 - t57 * t473 - t59 * t472 - t60 * t471 - t63 * t466
        + t65 * t465;
    let t475 = t455 * t48 - t50 * t474 - t52 * t473;
    let t476 = t454 * t40 - t42 * t475 - t44 * t474 - t42 * t473;
    let bobbin_v_y_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t465);
    let bobbin_v_x_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t466);
    let rod_omega_dot_by_post_omega = t36 * t468
        - R::literal(4_166.666_666_666_667) * t470 - t37 * t467;
    let rod_v_y_dot_by_post_omega = -(t35 * t469) - R::literal(5.0) * t467;
    let rod_v_x_dot_by_post_omega = t34 * t469 - R::literal(5.0) * t468;
    let cylinder_omega_dot_by_post_omega = t32 * t471 - t31 * t472
        - R::literal(-2_777.777_777_777_778) * t470 + t33 * t469;
    let cylinder_v_y_dot_by_post_omega = t30 * t469
        - R::literal(3.333_333_333_333_333_5) * t471;
    let cylinder_v_x_dot_by_post_omega = -(R::literal(3.333_333_333_333_333_5) * t472)
        - t29 * t469;
    let plate_omega_dot_by_post_omega = t26 * t473 - t25 * t474 - t25 * t472 + t26 * t471
        + t27 * t466 - t28 * t465;
    let plate_v_y_dot_by_post_omega = -(R::literal(0.833_333_333_333_333_4) * t473)
        - R::literal(-0.833_333_333_333_333_4) * t471
        - R::literal(-0.833_333_333_333_333_4) * t465;
    let plate_v_x_dot_by_post_omega = -(R::literal(0.833_333_333_333_333_4) * t474)
        - R::literal(-0.833_333_333_333_333_4) * t472
        - R::literal(-0.833_333_333_333_333_4) * t466;
    let post_omega_dot_by_post_omega = t452 * R::literal(370.370_370_370_370_3)
        - t23 * t476 + t24 * t475 - t23 * t474 + t24 * t473;
    let post_v_y_dot_by_post_omega = -(R::literal(1.25) * t475)
        - R::literal(-1.25) * t473;
    let post_v_x_dot_by_post_omega = -(R::literal(1.25) * t476)
        - R::literal(-1.25) * t474;
    let t477 = R::literal(0.12) * plate_omega;
    let t478 = t477 * cos_plate_phi;
    let t479 = t477 * sin_plate_phi;
    let t480 = t57 * t478 - t479;
    let t481 = t59 * t478 - t478 - t69 * t480;
    let t482 = t60 * t478 - t479 - t71 * t480 - t80 * t481;
    let t483 = t82 * t481 - t91 * t482;
    let t484 = -(t84 * t481) - t93 * t482 - t100 * t483;
    let t485 = -(t101 * t483) - t109 * t484;
    let t486 = t102 * t483 - t111 * t484 - t118 * t485;
    let t487 = plate_omega
        * (R::literal(0.02) * cos_plate_phi - R::literal(0.2) * sin_plate_phi)
        + t63 * t478 - t74 * t480 - t86 * t481 - t95 * t482 - t104 * t483 - t113 * t484
        - t120 * t485 - t125 * t486;
    let t488 = (plate_omega
        * (R::literal(0.02) * sin_plate_phi + R::literal(0.2) * cos_plate_phi)
        - t65 * t478 - t77 * t480 - t88 * t481 - t97 * t482 - t106 * t483 - t115 * t484
        - t122 * t485 - t127 * t486 - t130 * t487) * t131;
    let t489 = t487 * t128 - t130 * t488;
    let t490 = t486 * t123 - t125 * t489 - t127 * t488;
    let t491 = t485 * t116 - t118 * t490 - t120 * t489 - t122 * t488;
    let t492 = t484 * t107 - t109 * t491 - t111 * t490 - t113 * t489 - t115 * t488;
    let t493 = t483 * t98 - t100 * t492 - t101 * t491 + t102 * t490 - t104 * t489
        - t106 * t488;
    let t494 = t482 * t89 - t91 * t493 - t93 * t492 - t95 * t489 - t97 * t488;
    let t495 = t481 * t78 - t80 * t494 + t82 * t493 - t84 * t492 - t86 * t489
        - t88 * t488;
    let t496 = t480 * t67 - t69 * t495 - t71 * t494 - t74 * t489 - t77 * t488;
    let t497 = -(t478 * t54) - t57 * t496 - t59 * t495 - t60 * t494 - t63 * t489
        + t65 * t488;
    let t498 = -(t50 * t497) - t52 * t496;
    let t499 = -(t42 * t498) - t44 * t497 - t42 * t496;
    let bobbin_v_y_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t488);
    let bobbin_v_x_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t489);
    let rod_omega_dot_by_plate_omega = t36 * t491
        - R::literal(4_166.666_666_666_667) * t493 - t37 * t490;
    let rod_v_y_dot_by_plate_omega = -(t35 * t492) - R::literal(5.0) * t490;
    let rod_v_x_dot_by_plate_omega = t34 * t492 - R::literal(5.0) * t491;
    let cylinder_omega_dot_by_plate_omega = t32 * t494 - t31 * t495
        - R::literal(-2_777.777_777_777_778) * t493 + t33 * t492;
    let cylinder_v_y_dot_by_plate_omega = t30 * t492
        - R::literal(3.333_333_333_333_333_5) * t494;
    let cylinder_v_x_dot_by_plate_omega = -(R::literal(3.333_333_333_333_333_5) * t495)
        - t29 * t492;
    let plate_omega_dot_by_plate_omega = t26 * t496 - t25 * t497 - t25 * t495
        + t26 * t494 + t27 * t489 - t28 * t488;
    let plate_v_y_dot_by_plate_omega = -(R::literal(0.833_333_333_333_333_4) * t496)
        - R::literal(-0.833_333_333_333_333_4) * t494
        - R::literal(-0.833_333_333_333_333_4) * t488;
    let plate_v_x_dot_by_plate_omega = -(R::literal(0.833_333_333_333_333_4) * t497)
        - R::literal(-0.833_333_333_333_333_4) * t495
        - R::literal(-0.833_333_333_333_333_4) * t489;
    let post_omega_dot_by_plate_omega = t24 * t498 - t23 * t499 - t23 * t497
        + t24 * t496;
    let post_v_y_dot_by_plate_omega = -(R::literal(1.25) * t498)
        - R::literal(-1.25) * t496;
    let post_v_x_dot_by_plate_omega = -(R::literal(1.25) * t499)
        - R::literal(-1.25) * t497;
    let t500 = p.spring_damping * (cos_cylinder_phi * cos_cylinder_phi);
    let t501 = p.spring_damping * sin_cylinder_phi * cos_cylinder_phi;
    let t502 = p.spring_damping * t19;
    let t503 = t502 * cos_cylinder_phi;
    let t504 = R::literal(2.0) * cylinder_omega;
    let t505 = t504 * cos_cylinder_phi;
    let t506 = R::literal(3.333_333_333_333_333_5) * t500;
    let t507 = t31 * t503;
    let t508 = t506 - t507;
    let t509 = R::literal(3.333_333_333_333_333_5) * t501;
    let t510 = -t509;
    let t511 = t32 * t503;
    let t512 = t509 + t511 - t80 * t508;
    let t513 = R::literal(-2_777.777_777_777_778) * t503;
    let t514 = t82 * t508 - t513 - t91 * t512;
    let t515 = t29 * t500;
    let t516 = t30 * t501;
    let t517 = t33 * t503;
    let t518 = t34 * t500;
    let t519 = t35 * t501;
    let t520 = t515 - t505 - t516 + t517 + t518 - t519 - t84 * t508 - t93 * t512
        - t100 * t514;
    let t521 = R::literal(5.0) * t500;
    let t522 = -t521 - t101 * t514 - t109 * t520;
    let t523 = R::literal(5.0) * t501;
    let t524 = -t523;
    let t525 = t102 * t514 - t523 - t111 * t520 - t118 * t522;
    let t526 = -(t86 * t508) - t95 * t512 - t104 * t514 - t113 * t520 - t120 * t522
        - t125 * t525;
    let t527 = t503 * R::literal(2_777.777_777_777_778);
    let t528 = (-(t88 * t508) - t97 * t512 - t106 * t514 - t115 * t520 - t122 * t522
        - t127 * t525 - t130 * t526) * t131;
    let t529 = t526 * t128 - t130 * t528;
    let t530 = t525 * t123 - t125 * t529 - t127 * t528;
    let t531 = t522 * t116 - t118 * t530 - t120 * t529 - t122 * t528;
    let t532 = t520 * t107 - t109 * t531 - t111 * t530 - t113 * t529 - t115 * t528;
    let t533 = t514 * t98 - t100 * t532 - t101 * t531 + t102 * t530 - t104 * t529
        - t106 * t528;
    let t534 = t512 * t89 - t91 * t533 - t93 * t532 - t95 * t529 - t97 * t528;
    let t535 = t508 * t78 - t80 * t534 + t82 * t533 - t84 * t532 - t86 * t529
        - t88 * t528;
    let t536 = -(t69 * t535) - t71 * t534 - t74 * t529 - t77 * t528;
    let t537 = -(t57 * t536) - t59 * t535 - t60 * t534 - t63 * t529 + t65 * t528;
    let t538 = -(t50 * t537) - t52 * t536;
    let t539 = -(t42 * t538) - t44 * t537 - t42 * t536;
    let bobbin_v_y_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t528);
    let bobbin_v_x_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t529);
    let rod_omega_dot_by_cylinder_v_x = t36 * t531
        - R::literal(4_166.666_666_666_667) * t533 - t37 * t530;
    let rod_v_y_dot_by_cylinder_v_x = t523 - t35 * t532 - R::literal(5.0) * t530;
    let rod_v_x_dot_by_cylinder_v_x = t521 + t34 * t532 - R::literal(5.0) * t531;
    let cylinder_omega_dot_by_cylinder_v_x = t527 - t31 * t535 + t32 * t534
        - R::literal(-2_777.777_777_777_778) * t533 + t33 * t532;
    let cylinder_v_y_dot_by_cylinder_v_x = t510
        - R::literal(3.333_333_333_333_333_5) * t534 + t30 * t532;
    let cylinder_v_x_dot_by_cylinder_v_x = -t506
        - R::literal(3.333_333_333_333_333_5) * t535 - t29 * t532;
    let plate_omega_dot_by_cylinder_v_x = t26 * t536 - t25 * t537 - t25 * t535
        + t26 * t534 + t27 * t529 - t28 * t528;
    let plate_v_y_dot_by_cylinder_v_x = -(R::literal(0.833_333_333_333_333_4) * t536)
        - R::literal(-0.833_333_333_333_333_4) * t534
        - R::literal(-0.833_333_333_333_333_4) * t528;
    let plate_v_x_dot_by_cylinder_v_x = -(R::literal(0.833_333_333_333_333_4) * t537)
        - R::literal(-0.833_333_333_333_333_4) * t535
        - R::literal(-0.833_333_333_333_333_4) * t529;
    let post_omega_dot_by_cylinder_v_x = t24 * t538 - t23 * t539 - t23 * t537
        + t24 * t536;
    let post_v_y_dot_by_cylinder_v_x = -(R::literal(1.25) * t538)
        - R::literal(-1.25) * t536;
    let post_v_x_dot_by_cylinder_v_x = -(R::literal(1.25) * t539)
        - R::literal(-1.25) * t537;
    let t540 = p.spring_damping * (sin_cylinder_phi * sin_cylinder_phi);
    let t541 = t502 * sin_cylinder_phi;
    let t542 = t504 * sin_cylinder_phi;
    let t543 = t31 * t541;
    let t544 = t509 - t543;
    let t545 = R::literal(3.333_333_333_333_333_5) * t540;
    let t546 = -t545;
    let t547 = t32 * t541;
    let t548 = t545 + t547 - t80 * t544;
    let t549 = R::literal(-2_777.777_777_777_778) * t541;
    let t550 = t82 * t544 - t549 - t91 * t548;
    let t551 = t29 * t501;
    let t552 = t30 * t540;
    let t553 = t33 * t541;
    let t554 = t34 * t501;
    let t555 = t35 * t540;
    let t556 = t551 - t542 - t552 + t553 + t554 - t555 - t84 * t544 - t93 * t548
        - t100 * t550;
    let t557 = t524 - t101 * t550 - t109 * t556;
    let t558 = R::literal(5.0) * t540;
    let t559 = t102 * t550 - t558 - t111 * t556 - t118 * t557;
    let t560 = -(t86 * t544) - t95 * t548 - t104 * t550 - t113 * t556 - t120 * t557
        - t125 * t559;
    let t561 = t541 * R::literal(2_777.777_777_777_778);
    let t562 = (-(t88 * t544) - t97 * t548 - t106 * t550 - t115 * t556 - t122 * t557
        - t127 * t559 - t130 * t560) * t131;
    let t563 = t560 * t128 - t130 * t562;
    let t564 = t559 * t123 - t125 * t563 - t127 * t562;
    let t565 = t557 * t116 - t118 * t564 - t120 * t563 - t122 * t562;
    let t566 = t556 * t107 - t109 * t565 - t111 * t564 - t113 * t563 - t115 * t562;
    let t567 = t550 * t98 - t100 * t566 - t101 * t565 + t102 * t564 - t104 * t563
        - t106 * t562;
    let t568 = t548 * t89 - t91 * t567 - t93 * t566 - t95 * t563 - t97 * t562;
    let t569 = t544 * t78 - t80 * t568 + t82 * t567 - t84 * t566 - t86 * t563
        - t88 * t562;
    let t570 = -(t69 * t569) - t71 * t568 - t74 * t563 - t77 * t562;
    let t571 = -(t57 * t570) - t59 * t569 - t60 * t568 - t63 * t563 + t65 * t562;
    let t572 = -(t50 * t571) - t52 * t570;
    let t573 = -(t42 * t572) - t44 * t571 - t42 * t570;
    let bobbin_v_y_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t562);
    let bobbin_v_x_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t563);
    let rod_omega_dot_by_cylinder_v_y = t36 * t565
        - R::literal(4_166.666_666_666_667) * t567 - t37 * t564;
    let rod_v_y_dot_by_cylinder_v_y = t558 - t35 * t566 - R::literal(5.0) * t564;
    let rod_v_x_dot_by_cylinder_v_y = t523 + t34 * t566 - R::literal(5.0) * t565;
    let cylinder_omega_dot_by_cylinder_v_y = t561 - t31 * t569 + t32 * t568
        - R::literal(-2_777.777_777_777_778) * t567 + t33 * t566;
    let cylinder_v_y_dot_by_cylinder_v_y = t546
        - R::literal(3.333_333_333_333_333_5) * t568 + t30 * t566;
    let cylinder_v_x_dot_by_cylinder_v_y = t510
        - R::literal(3.333_333_333_333_333_5) * t569 - t29 * t566;
    let plate_omega_dot_by_cylinder_v_y = t26 * t570 - t25 * t571 - t25 * t569
        + t26 * t568 + t27 * t563 - t28 * t562;
    let plate_v_y_dot_by_cylinder_v_y = -(R::literal(0.833_333_333_333_333_4) * t570)
        - R::literal(-0.833_333_333_333_333_4) * t568
        - R::literal(-0.833_333_333_333_333_4) * t562;
    let plate_v_x_dot_by_cylinder_v_y = -(R::literal(0.833_333_333_333_333_4) * t571)
        - R::literal(-0.833_333_333_333_333_4) * t569
        - R::literal(-0.833_333_333_333_333_4) * t563;
    let post_omega_dot_by_cylinder_v_y = t24 * t572 - t23 * t573 - t23 * t571
        + t24 * t570;
    let post_v_y_dot_by_cylinder_v_y = -(R::literal(1.25) * t572)
        - R::literal(-1.25) * t570;
    let post_v_x_dot_by_cylinder_v_y = -(R::literal(1.25) * t573)
        - R::literal(-1.25) * t571;
    let t574 = p.spring_damping * t324;
    let t575 = R::literal(0.12) * cylinder_omega;
    let t576 = R::literal(3.333_333_333_333_333_5) * t503;
    let t577 = -(t575 * cos_cylinder_phi) - t576 + t31 * t574;
    let t578 = R::literal(3.333_333_333_333_333_5) * t541;
    let t579 = -(t575 * sin_cylinder_phi) - t578 - t32 * t574 - t80 * t577;
    let t580 = R::literal(-2_777.777_777_777_778) * t574 + t82 * t577 - t91 * t579;
    let t581 = R::literal(2.0)
        * (t161 + t162 + rod_v_x * cos_cylinder_phi + rod_v_y * sin_cylinder_phi - t157
            - t158 - cylinder_v_x * cos_cylinder_phi - cylinder_v_y * sin_cylinder_phi)
        - t29 * t503 + t30 * t541 - t33 * t574 - t34 * t503 + t35 * t541 - t84 * t577;
    let t582 = t581 - t93 * t579 - t100 * t580;
    let t583 = R::literal(5.0) * t503;
    let t584 = t583 - t101 * t580 - t109 * t582;
    let t585 = R::literal(5.0) * t541;
    let t586 = t585 + t102 * t580 - t111 * t582 - t118 * t584;
    let t587 = -(t86 * t577) - t95 * t579 - t104 * t580 - t113 * t582 - t120 * t584
        - t125 * t586;
    let t588 = (-(t88 * t577) - t97 * t579 - t106 * t580 - t115 * t582 - t122 * t584
        - t127 * t586 - t130 * t587) * t131;
    let t589 = t587 * t128 - t130 * t588;
    let t590 = t586 * t123 - t125 * t589 - t127 * t588;
    let t591 = t584 * t116 - t118 * t590 - t120 * t589 - t122 * t588;
    let t592 = t582 * t107 - t109 * t591 - t111 * t590 - t113 * t589 - t115 * t588;
    let t593 = t580 * t98 - t100 * t592 - t101 * t591 + t102 * t590 - t104 * t589
        - t106 * t588;
    let t594 = t579 * t89 - t91 * t593 - t93 * t592 - t95 * t589 - t97 * t588;
    let t595 = t577 * t78 - t80 * t594 + t82 * t593 - t84 * t592 - t86 * t589
        - t88 * t588;
    let t596 = -(t69 * t595) - t71 * t594 - t74 * t589 - t77 * t588;
    let t597 = -(t57 * t596) - t59 * t595 - t60 * t594 - t63 * t589 + t65 * t588;
    let t598 = -(t50 * t597) - t52 * t596;
    let t599 = -(t42 * t598) - t44 * t597 - t42 * t596;
    let bobbin_v_y_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t588);
    let bobbin_v_x_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t589);
    let rod_omega_dot_by_cylinder_omega = t36 * t591
        - R::literal(4_166.666_666_666_667) * t593 - t37 * t590;
    let rod_v_y_dot_by_cylinder_omega = -t585 - t35 * t592 - R::literal(5.0) * t590;
    let rod_v_x_dot_by_cylinder_omega = t34 * t592 - t583 - R::literal(5.0) * t591;
    let cylinder_omega_dot_by_cylinder_omega = -(t574
        * R::literal(2_777.777_777_777_778)) - t31 * t595 + t32 * t594
        - R::literal(-2_777.777_777_777_778) * t593 + t33 * t592;
    let cylinder_v_y_dot_by_cylinder_omega = t578
        - R::literal(3.333_333_333_333_333_5) * t594 + t30 * t592;
    let cylinder_v_x_dot_by_cylinder_omega = t576
        - R::literal(3.333_333_333_333_333_5) * t595 - t29 * t592;
    let plate_omega_dot_by_cylinder_omega = t26 * t596 - t25 * t597 - t25 * t595
        + t26 * t594 + t27 * t589 - t28 * t588;
    let plate_v_y_dot_by_cylinder_omega = -(R::literal(0.833_333_333_333_333_4) * t596)
        - R::literal(-0.833_333_333_333_333_4) * t594
        - R::literal(-0.833_333_333_333_333_4) * t588;
    let plate_v_x_dot_by_cylinder_omega = -(R::literal(0.833_333_333_333_333_4) * t597)
        - R::literal(-0.833_333_333_333_333_4) * t595
        - R::literal(-0.833_333_333_333_333_4) * t589;
    let post_omega_dot_by_cylinder_omega = t24 * t598 - t23 * t599 - t23 * t597
        + t24 * t596;
    let post_v_y_dot_by_cylinder_omega = -(R::literal(1.25) * t598)
        - R::literal(-1.25) * t596;
    let post_v_x_dot_by_cylinder_omega = -(R::literal(1.25) * t599)
        - R::literal(-1.25) * t597;
    let t600 = t507 - t506;
    let t601 = t510 - t511 - t80 * t600;
    let t602 = t513 + t82 * t600 - t91 * t601;
    let t603 = t505 - t515 + t516 - t517 - t518 + t519 - t84 * t600 - t93 * t601
        - t100 * t602;
    let t604 = t521 - t101 * t602 - t109 * t603;
    let t605 = t523 + t102 * t602 - t111 * t603 - t118 * t604;
    let t606 = -(t86 * t600) - t95 * t601 - t104 * t602 - t113 * t603 - t120 * t604
        - t125 * t605;
    let t607 = (-(t88 * t600) - t97 * t601 - t106 * t602 - t115 * t603 - t122 * t604
        - t127 * t605 - t130 * t606) * t131;
    let t608 = t606 * t128 - t130 * t607;
    let t609 = t605 * t123 - t125 * t608 - t127 * t607;
    let t610 = t604 * t116 - t118 * t609 - t120 * t608 - t122 * t607;
    let t611 = t603 * t107 - t109 * t610 - t111 * t609 - t113 * t608 - t115 * t607;
    let t612 = t602 * t98 - t100 * t611 - t101 * t610 + t102 * t609 - t104 * t608
        - t106 * t607;
    let t613 = t601 * t89 - t91 * t612 - t93 * t611 - t95 * t608 - t97 * t607;
    let t614 = t600 * t78 - t80 * t613 + t82 * t612 - t84 * t611 - t86 * t608
        - t88 * t607;
    let t615 = -(t69 * t614) - t71 * t613 - t74 * t608 - t77 * t607;
    let t616 = -(t57 * t615) - t59 * t614 - t60 * t613 - t63 * t608 + t65 * t607;
    let t617 = -(t50 * t616) - t52 * t615;
    let t618 = -(t42 * t617) - t44 * t616 - t42 * t615;
    let bobbin_v_y_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t607);
    let bobbin_v_x_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t608);
    let rod_omega_dot_by_rod_v_x = t36 * t610 - R::literal(4_166.666_666_666_667) * t612
        - t37 * t609;
    let rod_v_y_dot_by_rod_v_x = t524 - t35 * t611 - R::literal(5.0) * t609;
    let rod_v_x_dot_by_rod_v_x = t34 * t611 - t521 - R::literal(5.0) * t610;
    let cylinder_omega_dot_by_rod_v_x = -t527 - t31 * t614 + t32 * t613
        - R::literal(-2_777.777_777_777_778) * t612 + t33 * t611;
    let cylinder_v_y_dot_by_rod_v_x = t509 - R::literal(3.333_333_333_333_333_5) * t613
        + t30 * t611;
    let cylinder_v_x_dot_by_rod_v_x = t506 - R::literal(3.333_333_333_333_333_5) * t614
        - t29 * t611;
    let plate_omega_dot_by_rod_v_x = t26 * t615 - t25 * t616 - t25 * t614 + t26 * t613
        + t27 * t608 - t28 * t607;
    let plate_v_y_dot_by_rod_v_x = -(R::literal(0.833_333_333_333_333_4) * t615)
        - R::literal(-0.833_333_333_333_333_4) * t613
        - R::literal(-0.833_333_333_333_333_4) * t607;
    let plate_v_x_dot_by_rod_v_x = -(R::literal(0.833_333_333_333_333_4) * t616)
        - R::literal(-0.833_333_333_333_333_4) * t614
        - R::literal(-0.833_333_333_333_333_4) * t608;
    let post_omega_dot_by_rod_v_x = t24 * t617 - t23 * t618 - t23 * t616 + t24 * t615;
    let post_v_y_dot_by_rod_v_x = -(R::literal(1.25) * t617) - R::literal(-1.25) * t615;
    let post_v_x_dot_by_rod_v_x = -(R::literal(1.25) * t618) - R::literal(-1.25) * t616;
    let t619 = t543 - t509;
    let t620 = t546 - t547 - t80 * t619;
    let t621 = t549 + t82 * t619 - t91 * t620;
    let t622 = t542 - t551 + t552 - t553 - t554 + t555 - t84 * t619 - t93 * t620
        - t100 * t621;
    let t623 = t523 - t101 * t621 - t109 * t622;
    let t624 = t558 + t102 * t621 - t111 * t622 - t118 * t623;
    let t625 = -(t86 * t619) - t95 * t620 - t104 * t621 - t113 * t622 - t120 * t623
        - t125 * t624;
    let t626 = (-(t88 * t619) - t97 * t620 - t106 * t621 - t115 * t622 - t122 * t623
        - t127 * t624 - t130 * t625) * t131;
    let t627 = t625 * t128 - t130 * t626;
    let t628 = t624 * t123 - t125 * t627 - t127 * t626;
    let t629 = t623 * t116 - t118 * t628 - t120 * t627 - t122 * t626;
    let t630 = t622 * t107 - t109 * t629 - t111 * t628 - t113 * t627 - t115 * t626;
    let t631 = t621 * t98 - t100 * t630 - t101 * t629 + t102 * t628 - t104 * t627
        - t106 * t626;
    let t632 = t620 * t89 - t91 * t631 - t93 * t630 - t95 * t627 - t97 * t626;
    let t633 = t619 * t78 - t80 * t632 + t82 * t631 - t84 * t630 - t86 * t627
        - t88 * t626;
    let t634 = -(t69 * t633) - t71 * t632 - t74 * t627 - t77 * t626;
    let t635 = -(t57 * t634) - t59 * t633 - t60 * t632 - t63 * t627 + t65 * t626;
    let t636 = -(t50 * t635) - t52 * t634;
    let t637 = -(t42 * t636) - t44 * t635 - t42 * t634;
    let bobbin_v_y_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t626);
    let bobbin_v_x_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t627);
    let rod_omega_dot_by_rod_v_y = t36 * t629 - R::literal(4_166.666_666_666_667) * t631
        - t37 * t628;
    let rod_v_y_dot_by_rod_v_y = -t558 - t35 * t630 - R::literal(5.0) * t628;
    let rod_v_x_dot_by_rod_v_y = t34 * t630 - t523 - R::literal(5.0) * t629;
    let cylinder_omega_dot_by_rod_v_y = -t561 - t31 * t633 + t32 * t632
        - R::literal(-2_777.777_777_777_778) * t631 + t33 * t630;
    let cylinder_v_y_dot_by_rod_v_y = t545 - R::literal(3.333_333_333_333_333_5) * t632
        + t30 * t630;
    let cylinder_v_x_dot_by_rod_v_y = t509 - R::literal(3.333_333_333_333_333_5) * t633
        - t29 * t630;
    let plate_omega_dot_by_rod_v_y = t26 * t634 - t25 * t635 - t25 * t633 + t26 * t632
        + t27 * t627 - t28 * t626;
    let plate_v_y_dot_by_rod_v_y = -(R::literal(0.833_333_333_333_333_4) * t634)
        - R::literal(-0.833_333_333_333_333_4) * t632
        - R::literal(-0.833_333_333_333_333_4) * t626;
    let plate_v_x_dot_by_rod_v_y = -(R::literal(0.833_333_333_333_333_4) * t635)
        - R::literal(-0.833_333_333_333_333_4) * t633
        - R::literal(-0.833_333_333_333_333_4) * t627;
    let post_omega_dot_by_rod_v_y = t24 * t636 - t23 * t637 - t23 * t635 + t24 * t634;
    let post_v_y_dot_by_rod_v_y = -(R::literal(1.25) * t636) - R::literal(-1.25) * t634;
    let post_v_x_dot_by_rod_v_y = -(R::literal(1.25) * t637) - R::literal(-1.25) * t635;
    let t638 = R::literal(0.12) * rod_omega;
    let t639 = t638 * cos_rod_phi;
    let t640 = t638 * sin_rod_phi - t118 * t639;
    let t641 = -(t120 * t639) - t125 * t640;
    let t642 = (-(t122 * t639) - t127 * t640 - t130 * t641) * t131;
    let t643 = t641 * t128 - t130 * t642;
    let t644 = t640 * t123 - t125 * t643 - t127 * t642;
    let t645 = t639 * t116 - t118 * t644 - t120 * t643 - t122 * t642;
    let t646 = -(t109 * t645) - t111 * t644 - t113 * t643 - t115 * t642;
    let t647 = -(t100 * t646) - t101 * t645 + t102 * t644 - t104 * t643 - t106 * t642;
    let t648 = -(t91 * t647) - t93 * t646 - t95 * t643 - t97 * t642;
    let t649 = t82 * t647 - t80 * t648 - t84 * t646 - t86 * t643 - t88 * t642;
    let t650 = -(t69 * t649) - t71 * t648 - t74 * t643 - t77 * t642;
    let t651 = -(t57 * t650) - t59 * t649 - t60 * t648 - t63 * t643 + t65 * t642;
    let t652 = -(t50 * t651) - t52 * t650;
    let t653 = -(t42 * t652) - t44 * t651 - t42 * t650;
    let bobbin_v_y_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t642);
    let bobbin_v_x_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t643);
    let rod_omega_dot_by_rod_omega = t36 * t645
        - R::literal(4_166.666_666_666_667) * t647 - t37 * t644;
    let rod_v_y_dot_by_rod_omega = -(t35 * t646) - R::literal(5.0) * t644;
    let rod_v_x_dot_by_rod_omega = t34 * t646 - R::literal(5.0) * t645;
    let cylinder_omega_dot_by_rod_omega = t32 * t648 - t31 * t649
        - R::literal(-2_777.777_777_777_778) * t647 + t33 * t646;
    let cylinder_v_y_dot_by_rod_omega = t30 * t646
        - R::literal(3.333_333_333_333_333_5) * t648;
    let cylinder_v_x_dot_by_rod_omega = -(R::literal(3.333_333_333_333_333_5) * t649)
        - t29 * t646;
    let plate_omega_dot_by_rod_omega = t26 * t650 - t25 * t651 - t25 * t649 + t26 * t648
        + t27 * t643 - t28 * t642;
    let plate_v_y_dot_by_rod_omega = -(R::literal(0.833_333_333_333_333_4) * t650)
        - R::literal(-0.833_333_333_333_333_4) * t648
        - R::literal(-0.833_333_333_333_333_4) * t642;
    let plate_v_x_dot_by_rod_omega = -(R::literal(0.833_333_333_333_333_4) * t651)
        - R::literal(-0.833_333_333_333_333_4) * t649
        - R::literal(-0.833_333_333_333_333_4) * t643;
    let post_omega_dot_by_rod_omega = t24 * t652 - t23 * t653 - t23 * t651 + t24 * t650;
    let post_v_y_dot_by_rod_omega = -(R::literal(1.25) * t652)
        - R::literal(-1.25) * t650;
    let post_v_x_dot_by_rod_omega = -(R::literal(1.25) * t653)
        - R::literal(-1.25) * t651;
    let t654 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t14 / between_squared),
        );
    let t655 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t13 * t15 / between_squared),
        );
    let t656 = (t130 * t654 - t655) * t131;
    let t657 = -(t654 * t128) - t130 * t656;
    let t658 = -(t125 * t657) - t127 * t656;
    let t659 = -(t118 * t658) - t120 * t657 - t122 * t656;
    let t660 = -(t109 * t659) - t111 * t658 - t113 * t657 - t115 * t656;
    let t661 = -(t100 * t660) - t101 * t659 + t102 * t658 - t104 * t657 - t106 * t656;
    let t662 = -(t91 * t661) - t93 * t660 - t95 * t657 - t97 * t656;
    let t663 = t82 * t661 - t80 * t662 - t84 * t660 - t86 * t657 - t88 * t656;
    let t664 = -(t69 * t663) - t71 * t662 - t74 * t657 - t77 * t656;
    let t665 = -(t57 * t664) - t59 * t663 - t60 * t662 - t63 * t657 + t65 * t656;
    let t666 = -(t50 * t665) - t52 * t664;
    let t667 = -(t42 * t666) - t44 * t665 - t42 * t664;
    let bobbin_v_y_dot_by_bobbin_v_x = t655 - R::literal(1.428_571_428_571_428_6) * t656;
    let bobbin_v_x_dot_by_bobbin_v_x = t654 - R::literal(1.428_571_428_571_428_6) * t657;
    let rod_omega_dot_by_bobbin_v_x = t36 * t659
        - R::literal(4_166.666_666_666_667) * t661 - t37 * t658;
    let rod_v_y_dot_by_bobbin_v_x = -(t35 * t660) - R::literal(5.0) * t658;
    let rod_v_x_dot_by_bobbin_v_x = t34 * t660 - R::literal(5.0) * t659;
    let cylinder_omega_dot_by_bobbin_v_x = t32 * t662 - t31 * t663
        - R::literal(-2_777.777_777_777_778) * t661 + t33 * t660;
    let cylinder_v_y_dot_by_bobbin_v_x = t30 * t660
        - R::literal(3.333_333_333_333_333_5) * t662;
    let cylinder_v_x_dot_by_bobbin_v_x = -(R::literal(3.333_333_333_333_333_5) * t663)
        - t29 * t660;
    let plate_omega_dot_by_bobbin_v_x = t26 * t664 - t25 * t665 - t25 * t663 + t26 * t662
        + t27 * t657 - t28 * t656;
    let plate_v_y_dot_by_bobbin_v_x = -(R::literal(0.833_333_333_333_333_4) * t664)
        - R::literal(-0.833_333_333_333_333_4) * t662
        - R::literal(-0.833_333_333_333_333_4) * t656;
    let plate_v_x_dot_by_bobbin_v_x = -(R::literal(0.833_333_333_333_333_4) * t665)
        - R::literal(-0.833_333_333_333_333_4) * t663
        - R::literal(-0.833_333_333_333_333_4) * t657;
    let post_omega_dot_by_bobbin_v_x = t24 * t666 - t23 * t667 - t23 * t665 + t24 * t664;
    let post_v_y_dot_by_bobbin_v_x = -(R::literal(1.25) * t666)
        - R::literal(-1.25) * t664;
    let post_v_x_dot_by_bobbin_v_x = -(R::literal(1.25) * t667)
        - R::literal(-1.25) * t665;
    let t668 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t16 / between_squared),
        );
    let t669 = (t130 * t655 - t668) * t131;
    let t670 = -(t655 * t128) - t130 * t669;
    let t671 = -(t125 * t670) - t127 * t669;
    let t672 = -(t118 * t671) - t120 * t670 - t122 * t669;
    let t673 = -(t109 * t672) - t111 * t671 - t113 * t670 - t115 * t669;
    let t674 = -(t100 * t673) - t101 * t672 + t102 * t671 - t104 * t670 - t106 * t669;
    let t675 = -(t91 * t674) - t93 * t673 - t95 * t670 - t97 * t669;
    let t676 = t82 * t674 - t80 * t675 - t84 * t673 - t86 * t670 - t88 * t669;
    let t677 = -(t69 * t676) - t71 * t675 - t74 * t670 - t77 * t669;
    let t678 = -(t57 * t677) - t59 * t676 - t60 * t675 - t63 * t670 + t65 * t669;
    let t679 = -(t50 * t678) - t52 * t677;
    let t680 = -(t42 * t679) - t44 * t678 - t42 * t677;
    let bobbin_v_y_dot_by_bobbin_v_y = t668 - R::literal(1.428_571_428_571_428_6) * t669;
    let bobbin_v_x_dot_by_bobbin_v_y = t655 - R::literal(1.428_571_428_571_428_6) * t670;
    let rod_omega_dot_by_bobbin_v_y = t36 * t672
        - R::literal(4_166.666_666_666_667) * t674 - t37 * t671;
    let rod_v_y_dot_by_bobbin_v_y = -(t35 * t673) - R::literal(5.0) * t671;
    let rod_v_x_dot_by_bobbin_v_y = t34 * t673 - R::literal(5.0) * t672;
    let cylinder_omega_dot_by_bobbin_v_y = t32 * t675 - t31 * t676
        - R::literal(-2_777.777_777_777_778) * t674 + t33 * t673;
    let cylinder_v_y_dot_by_bobbin_v_y = t30 * t673
        - R::literal(3.333_333_333_333_333_5) * t675;
    let cylinder_v_x_dot_by_bobbin_v_y = -(R::literal(3.333_333_333_333_333_5) * t676)
        - t29 * t673;
    let plate_omega_dot_by_bobbin_v_y = t26 * t677 - t25 * t678 - t25 * t676 + t26 * t675
        + t27 * t670 - t28 * t669;
    let plate_v_y_dot_by_bobbin_v_y = -(R::literal(0.833_333_333_333_333_4) * t677)
        - R::literal(-0.833_333_333_333_333_4) * t675
        - R::literal(-0.833_333_333_333_333_4) * t669;
    let plate_v_x_dot_by_bobbin_v_y = -(R::literal(0.833_333_333_333_333_4) * t678)
        - R::literal(-0.833_333_333_333_333_4) * t676
        - R::literal(-0.833_333_333_333_333_4) * t670;
    let post_omega_dot_by_bobbin_v_y = t24 * t679 - t23 * t680 - t23 * t678 + t24 * t677;
    let post_v_y_dot_by_bobbin_v_y = -(R::literal(1.25) * t679)
        - R::literal(-1.25) * t677;
    let post_v_x_dot_by_bobbin_v_y = -(R::literal(1.25) * t680)
        - R::literal(-1.25) * t678;
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
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 1133 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 56] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed, ..] = *state;
    let t0 = R::literal(0.1) * post_phi.cos();
    let t1 = R::literal(0.1) * post_phi.sin();
    let cos_plate_phi = plate_phi.cos();
    let t2 = R::literal(0.06) * cos_plate_phi;
    let sin_plate_phi = plate_phi.sin();
    let t3 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let t4 = R::literal(0.06) * cos_cylinder_phi;
    let sin_cylinder_phi = cylinder_phi.sin();
    let t5 = R::literal(0.06) * sin_cylinder_phi;
    let t6 = R::literal(0.06) * rod_phi.cos();
    let t7 = R::literal(0.06) * rod_phi.sin();
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8 + t9 * t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t8 + bobbin_v_y * t9) / between;
    let t10 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t10 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let t11 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t12 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let t13 = t1 * R::literal(370.370_370_370_370_3);
    let t14 = t0 * R::literal(370.370_370_370_370_3);
    let t15 = t3 * R::literal(400.0);
    let t16 = t2 * R::literal(400.0);
    let t17 = t11 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = t5 * R::literal(2_777.777_777_777_778);
    let t22 = t4 * R::literal(2_777.777_777_777_778);
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = t7 * R::literal(4_166.666_666_666_667);
    let t27 = t6 * R::literal(4_166.666_666_666_667);
    let t28 = t13 * t1;
    let t29 = R::literal(-1.25) - t28;
    let t30 = R::literal(1.0) / t29;
    let t31 = t14 * t1;
    let t32 = t31 * t30;
    let t33 = R::literal(1.25) - t28;
    let t34 = t33 * t30;
    let t35 = t14 * t0;
    let t36 = R::literal(-1.25) - t35;
    let t37 = t32 * t31;
    let t38 = R::literal(1.0) / (t36 - t37);
    let t39 = t13 * t0 - t34 * t31;
    let t40 = t39 * t38;
    let t41 = R::literal(1.25) - t35 - t37;
    let t42 = t41 * t38;
    let t43 = t15 * t3;
    let t44 = R::literal(1.0)
        / (t29 - R::literal(0.833_333_333_333_333_4) - t43 - t34 * t33 - t40 * t39);
    let t45 = t16 * t3;
    let t46 = t31 + t45 - t32 * t33 - t42 * t39;
    let t47 = t46 * t44;
    let t48 = R::literal(0.833_333_333_333_333_4) - t43;
    let t49 = t48 * t44;
    let t50 = t45 * t44;
    let t51 = t17 * t3;
    let t52 = R::literal(0.833_333_333_333_333_4) + t51;
    let t53 = t52 * t44;
    let t54 = t18 * t3;
    let t55 = t54 * t44;
    let t56 = t16 * t2;
    let t57 = R::literal(1.0)
        / (t36 - R::literal(0.833_333_333_333_333_4) - t56 - t37 - t42 * t41
            - t47 * t46);
    let t58 = t15 * t2 - t49 * t46;
    let t59 = t58 * t57;
    let t60 = R::literal(0.833_333_333_333_333_4) - t56 - t50 * t46;
    let t61 = t60 * t57;
    let t62 = -(t17 * t2);
    let t63 = t62 - t53 * t46;
    let t64 = t63 * t57;
    let t65 = t18 * t2;
    let t66 = R::literal(0.833_333_333_333_333_4) + t65 + t55 * t46;
    let t67 = t66 * t57;
    let t68 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t43
            - R::literal(3.333_333_333_333_333_5) - t21 * t5 - t49 * t48 - t59 * t58);
    let t69 = t45 + t22 * t5 - t50 * t48 - t61 * t58;
    let t70 = t69 * t68;
    let t71 = R::literal(-2_777.777_777_777_778) * t5;
    let t72 = t71 * t68;
    let t73 = t23 * t5 - t19;
    let t74 = t73 * t68;
    let t75 = R::literal(-0.833_333_333_333_333_4) + t51 - t53 * t48 - t64 * t58;
    let t76 = t75 * t68;
    let t77 = t55 * t48 - t54 - t67 * t58;
    let t78 = t77 * t68;
    let t79 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t56
            - R::literal(3.333_333_333_333_333_5) - t22 * t4 - t50 * t45 - t61 * t60
            - t70 * t69);
    let t80 = R::literal(-2_777.777_777_777_778) * t4 + t72 * t69;
    let t81 = t80 * t79;
    let t82 = t20 - t23 * t4 - t74 * t69;
    let t83 = t82 * t79;
    let t84 = t62 - t53 * t45 - t64 * t60 - t76 * t69;
    let t85 = t84 * t79;
    let t86 = R::literal(-0.833_333_333_333_333_4) + t65 + t55 * t45 - t67 * t60
        - t78 * t69;
    let t87 = t86 * t79;
    let t88 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t72 * t71 - t81 * t80);
    let t89 = t74 * t71 - t23 - t83 * t80;
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = t76 * t71 - t85 * t80;
    let t94 = t93 * t88;
    let t95 = t78 * t71 - t87 * t80;
    let t96 = t95 * t88;
    let t97 = R::literal(1.0)
        / (-(t19 * sin_cylinder_phi) - t20 * cos_cylinder_phi - t23 * slide
            - t24 * sin_cylinder_phi - t25 * cos_cylinder_phi - t74 * t73 - t83 * t82
            - t90 * t89);
    let t98 = t24 - t91 * t89;
    let t99 = t98 * t97;
    let t100 = t92 * t89 - t25;
    let t101 = t100 * t97;
    let t102 = -(t76 * t73) - t85 * t82 - t94 * t89;
    let t103 = t102 * t97;
    let t104 = -(t78 * t73) - t87 * t82 - t96 * t89;
    let t105 = t104 * t97;
    let t106 = R::literal(1.0) / (R::literal(-5.0) - t26 * t7 - t91 * t26 - t99 * t98);
    let t107 = t27 * t7 + t92 * t26 - t101 * t98;
    let t108 = t107 * t106;
    let t109 = -(t94 * t26) - t103 * t98;
    let t110 = t109 * t106;
    let t111 = -(t96 * t26) - t105 * t98;
    let t112 = t111 * t106;
    let t113 = R::literal(1.0)
        / (R::literal(-5.0) - t27 * t6 - t92 * t27 - t101 * t100 - t108 * t107);
    let t114 = t94 * t27 - t103 * t100 - t110 * t107;
    let t115 = t114 * t113;
    let t116 = t96 * t27 - t105 * t100 - t112 * t107;
    let t117 = t116 * t113;
    let t118 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t17 * t11
            - R::literal(1.428_571_428_571_428_6) - t53 * t52 - t64 * t63 - t76 * t75
            - t85 * t84 - t94 * t93 - t103 * t102 - t110 * t109 - t115 * t114);
    let t119 = t18 * t11 + t55 * t52 - t67 * t63 - t78 * t75 - t87 * t84 - t96 * t93
        - t105 * t102 - t112 * t109 - t117 * t114;
    let t120 = t119 * t118;
    let t121 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t12
            - R::literal(1.428_571_428_571_428_6) - t55 * t54 - t67 * t66 - t78 * t77
            - t87 * t86 - t96 * t95 - t105 * t104 - t112 * t111 - t117 * t116
            - t120 * t119);
    let t122 = slide - R::literal(0.116);
    let t123 = t122 * cos_cylinder_phi;
    let t124 = t122 * sin_cylinder_phi;
    let t125 = t122 * t10;
    let t126 = R::literal(3.333_333_333_333_333_5) * t123;
    let t127 = t21 * t125 - t126;
    let t128 = R::literal(3.333_333_333_333_333_5) * t124;
    let t129 = -t128 - t22 * t125 - t70 * t127;
    let t130 = R::literal(-2_777.777_777_777_778) * t125 + t72 * t127 - t81 * t129;
    let t131 = t20 * t124 - t19 * t123 - t23 * t125 - t24 * t123 + t25 * t124
        - t74 * t127 - t83 * t129 - t90 * t130;
    let t132 = R::literal(5.0) * t123;
    let t133 = t132 - t91 * t130 - t99 * t131;
    let t134 = R::literal(5.0) * t124;
    let t135 = t134 + t92 * t130 - t101 * t131 - t108 * t133;
    let t136 = -(t76 * t127) - t85 * t129 - t94 * t130 - t103 * t131 - t110 * t133
        - t115 * t135;
    let t137 = (-(t78 * t127) - t87 * t129 - t96 * t130 - t105 * t131 - t112 * t133
        - t117 * t135 - t120 * t136) * t121;
    let t138 = t136 * t118 - t120 * t137;
    let t139 = t135 * t113 - t115 * t138 - t117 * t137;
    let t140 = t133 * t106 - t108 * t139 - t110 * t138 - t112 * t137;
    let t141 = t131 * t97 - t99 * t140 - t101 * t139 - t103 * t138 - t105 * t137;
    let t142 = t130 * t88 - t90 * t141 - t91 * t140 + t92 * t139 - t94 * t138
        - t96 * t137;
    let t143 = t129 * t79 - t81 * t142 - t83 * t141 - t85 * t138 - t87 * t137;
    let t144 = t127 * t68 - t70 * t143 + t72 * t142 - t74 * t141 - t76 * t138
        - t78 * t137;
    let t145 = -(t59 * t144) - t61 * t143 - t64 * t138 - t67 * t137;
    let t146 = -(t47 * t145) - t49 * t144 - t50 * t143 - t53 * t138 + t55 * t137;
    let t147 = -(t40 * t146) - t42 * t145;
    let t148 = -(t32 * t147) - t34 * t146 - t32 * t145;
    let bobbin_v_y_dot_by_spring_stiffness = -(R::literal(1.428_571_428_571_428_6)
        * t137);
    let bobbin_v_x_dot_by_spring_stiffness = -(R::literal(1.428_571_428_571_428_6)
        * t138);
    let rod_omega_dot_by_spring_stiffness = t26 * t140
        - R::literal(4_166.666_666_666_667) * t142 - t27 * t139;
    let rod_v_y_dot_by_spring_stiffness = -t134 - t25 * t141 - R::literal(5.0) * t139;
    let rod_v_x_dot_by_spring_stiffness = t24 * t141 - t132 - R::literal(5.0) * t140;
    let cylinder_omega_dot_by_spring_stiffness = -(t125
        * R::literal(2_777.777_777_777_778)) - t21 * t144 + t22 * t143
        - R::literal(-2_777.777_777_777_778) * t142 + t23 * t141;
    let cylinder_v_y_dot_by_spring_stiffness = t128
        - R::literal(3.333_333_333_333_333_5) * t143 + t20 * t141;
    let cylinder_v_x_dot_by_spring_stiffness = t126
        - R::literal(3.333_333_333_333_333_5) * t144 - t19 * t141;
    let plate_omega_dot_by_spring_stiffness = t16 * t145 - t15 * t146 - t15 * t144
        + t16 * t143 + t17 * t138 - t18 * t137;
    let plate_v_y_dot_by_spring_stiffness = -(R::literal(0.833_333_333_333_333_4) * t145)
        - R::literal(-0.833_333_333_333_333_4) * t143
        - R::literal(-0.833_333_333_333_333_4) * t137;
    let plate_v_x_dot_by_spring_stiffness = -(R::literal(0.833_333_333_333_333_4) * t146)
        - R::literal(-0.833_333_333_333_333_4) * t144
        - R::literal(-0.833_333_333_333_333_4) * t138;
    let post_omega_dot_by_spring_stiffness = t14 * t147 - t13 * t148 - t13 * t146
        + t14 * t145;
    let post_v_y_dot_by_spring_stiffness = -(R::literal(1.25) * t147)
        - R::literal(-1.25) * t145;
    let post_v_x_dot_by_spring_stiffness = -(R::literal(1.25) * t148)
        - R::literal(-1.25) * t146;
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let t149 = slide_rate * t10;
    let t150 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_cos_cylinder_phi;
    let t151 = t21 * t149 - t150;
    let t152 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_sin_cylinder_phi;
    let t153 = -t152 - t22 * t149 - t70 * t151;
    let t154 = R::literal(-2_777.777_777_777_778) * t149 + t72 * t151 - t81 * t153;
    let t155 = t20 * slide_rate_times_sin_cylinder_phi
        - t19 * slide_rate_times_cos_cylinder_phi - t23 * t149
        - t24 * slide_rate_times_cos_cylinder_phi
        + t25 * slide_rate_times_sin_cylinder_phi - t74 * t151 - t83 * t153 - t90 * t154;
    let t156 = R::literal(5.0) * slide_rate_times_cos_cylinder_phi;
    let t157 = t156 - t91 * t154 - t99 * t155;
    let t158 = R::literal(5.0) * slide_rate_times_sin_cylinder_phi;
    let t159 = t158 + t92 * t154 - t101 * t155 - t108 * t157;
    let t160 = -(t76 * t151) - t85 * t153 - t94 * t154 - t103 * t155 - t110 * t157
        - t115 * t159;
    let t161 = (-(t78 * t151) - t87 * t153 - t96 * t154 - t105 * t155 - t112 * t157
        - t117 * t159 - t120 * t160) * t121;
    let t162 = t160 * t118 - t120 * t161;
    let t163 = t159 * t113 - t115 * t162 - t117 * t161;
    let t164 = t157 * t106 - t108 * t163 - t110 * t162 - t112 * t161;
    let t165 = t155 * t97 - t99 * t164 - t101 * t163 - t103 * t162 - t105 * t161;
    let t166 = t154 * t88 - t90 * t165 - t91 * t164 + t92 * t163 - t94 * t162
        - t96 * t161;
    let t167 = t153 * t79 - t81 * t166 - t83 * t165 - t85 * t162 - t87 * t161;
    let t168 = t151 * t68 - t70 * t167 + t72 * t166 - t74 * t165 - t76 * t162
        - t78 * t161;
    let t169 = -(t59 * t168) - t61 * t167 - t64 * t162 - t67 * t161;
    let t170 = -(t47 * t169) - t49 * t168 - t50 * t167 - t53 * t162 + t55 * t161;
    let t171 = -(t40 * t170) - t42 * t169;
    let t172 = -(t32 * t171) - t34 * t170 - t32 * t169;
    let bobbin_v_y_dot_by_spring_damping = -(R::literal(1.428_571_428_571_428_6) * t161);
    let bobbin_v_x_dot_by_spring_damping = -(R::literal(1.428_571_428_571_428_6) * t162);
    let rod_omega_dot_by_spring_damping = t26 * t164
        - R::literal(4_166.666_666_666_667) * t166 - t27 * t163;
    let rod_v_y_dot_by_spring_damping = -t158 - t25 * t165 - R::literal(5.0) * t163;
    let rod_v_x_dot_by_spring_damping = t24 * t165 - t156 - R::literal(5.0) * t164;
    let cylinder_omega_dot_by_spring_damping = -(t149
        * R::literal(2_777.777_777_777_778)) - t21 * t168 + t22 * t167
        - R::literal(-2_777.777_777_777_778) * t166 + t23 * t165;
    let cylinder_v_y_dot_by_spring_damping = t152
        - R::literal(3.333_333_333_333_333_5) * t167 + t20 * t165;
    let cylinder_v_x_dot_by_spring_damping = t150
        - R::literal(3.333_333_333_333_333_5) * t168 - t19 * t165;
    let plate_omega_dot_by_spring_damping = t16 * t169 - t15 * t170 - t15 * t168
        + t16 * t167 + t17 * t162 - t18 * t161;
    let plate_v_y_dot_by_spring_damping = -(R::literal(0.833_333_333_333_333_4) * t169)
        - R::literal(-0.833_333_333_333_333_4) * t167
        - R::literal(-0.833_333_333_333_333_4) * t161;
    let plate_v_x_dot_by_spring_damping = -(R::literal(0.833_333_333_333_333_4) * t170)
        - R::literal(-0.833_333_333_333_333_4) * t168
        - R::literal(-0.833_333_333_333_333_4) * t162;
    let post_omega_dot_by_spring_damping = t14 * t171 - t13 * t172 - t13 * t170
        + t14 * t169;
    let post_v_y_dot_by_spring_damping = -(R::literal(1.25) * t171)
        - R::literal(-1.25) * t169;
    let post_v_x_dot_by_spring_damping = -(R::literal(1.25) * t172)
        - R::literal(-1.25) * t170;
    let t173 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_gap * t8 / between),
        );
    let t174 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_gap * t9 / between),
        );
    let t175 = (t120 * t173 - t174) * t121;
    let t176 = -(t173 * t118) - t120 * t175;
    let t177 = -(t115 * t176) - t117 * t175;
    let t178 = -(t108 * t177) - t110 * t176 - t112 * t175;
    let t179 = -(t99 * t178) - t101 * t177 - t103 * t176 - t105 * t175;
    let t180 = -(t90 * t179) - t91 * t178 + t92 * t177 - t94 * t176 - t96 * t175;
    let t181 = -(t81 * t180) - t83 * t179 - t85 * t176 - t87 * t175;
    let t182 = t72 * t180 - t70 * t181 - t74 * t179 - t76 * t176 - t78 * t175;
    let t183 = -(t59 * t182) - t61 * t181 - t64 * t176 - t67 * t175;
    let t184 = -(t47 * t183) - t49 * t182 - t50 * t181 - t53 * t176 + t55 * t175;
    let t185 = -(t40 * t184) - t42 * t183;
    let t186 = -(t32 * t185) - t34 * t184 - t32 * t183;
    let bobbin_v_y_dot_by_contact_stiffness = t174
        - R::literal(1.428_571_428_571_428_6) * t175;
    let bobbin_v_x_dot_by_contact_stiffness = t173
        - R::literal(1.428_571_428_571_428_6) * t176;
    let rod_omega_dot_by_contact_stiffness = t26 * t178
        - R::literal(4_166.666_666_666_667) * t180 - t27 * t177;
    let rod_v_y_dot_by_contact_stiffness = -(t25 * t179) - R::literal(5.0) * t177;
    let rod_v_x_dot_by_contact_stiffness = t24 * t179 - R::literal(5.0) * t178;
    let cylinder_omega_dot_by_contact_stiffness = t22 * t181 - t21 * t182
        - R::literal(-2_777.777_777_777_778) * t180 + t23 * t179;
    let cylinder_v_y_dot_by_contact_stiffness = t20 * t179
        - R::literal(3.333_333_333_333_333_5) * t181;
    let cylinder_v_x_dot_by_contact_stiffness = -(R::literal(3.333_333_333_333_333_5)
        * t182) - t19 * t179;
    let plate_omega_dot_by_contact_stiffness = t16 * t183 - t15 * t184 - t15 * t182
        + t16 * t181 + t17 * t176 - t18 * t175;
    let plate_v_y_dot_by_contact_stiffness = -(R::literal(0.833_333_333_333_333_4)
        * t183) - R::literal(-0.833_333_333_333_333_4) * t181
        - R::literal(-0.833_333_333_333_333_4) * t175;
    let plate_v_x_dot_by_contact_stiffness = -(R::literal(0.833_333_333_333_333_4)
        * t184) - R::literal(-0.833_333_333_333_333_4) * t182
        - R::literal(-0.833_333_333_333_333_4) * t176;
    let post_omega_dot_by_contact_stiffness = t14 * t185 - t13 * t186 - t13 * t184
        + t14 * t183;
    let post_v_y_dot_by_contact_stiffness = -(R::literal(1.25) * t185)
        - R::literal(-1.25) * t183;
    let post_v_x_dot_by_contact_stiffness = -(R::literal(1.25) * t186)
        - R::literal(-1.25) * t184;
    let t187 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_rate * t8 / between),
        );
    let t188 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_rate * t9 / between),
        );
    let t189 = (t120 * t187 - t188) * t121;
    let t190 = -(t187 * t118) - t120 * t189;
    let t191 = -(t115 * t190) - t117 * t189;
    let t192 = -(t108 * t191) - t110 * t190 - t112 * t189;
    let t193 = -(t99 * t192) - t101 * t191 - t103 * t190 - t105 * t189;
    let t194 = -(t90 * t193) - t91 * t192 + t92 * t191 - t94 * t190 - t96 * t189;
    let t195 = -(t81 * t194) - t83 * t193 - t85 * t190 - t87 * t189;
    let t196 = t72 * t194 - t70 * t195 - t74 * t193 - t76 * t190 - t78 * t189;
    let t197 = -(t59 * t196) - t61 * t195 - t64 * t190 - t67 * t189;
    let t198 = -(t47 * t197) - t49 * t196 - t50 * t195 - t53 * t190 + t55 * t189;
    let t199 = -(t40 * t198) - t42 * t197;
    let t200 = -(t32 * t199) - t34 * t198 - t32 * t197;
    let bobbin_v_y_dot_by_contact_damping = t188
        - R::literal(1.428_571_428_571_428_6) * t189;
    let bobbin_v_x_dot_by_contact_damping = t187
        - R::literal(1.428_571_428_571_428_6) * t190;
    let rod_omega_dot_by_contact_damping = t26 * t192
        - R::literal(4_166.666_666_666_667) * t194 - t27 * t191;
    let rod_v_y_dot_by_contact_damping = -(t25 * t193) - R::literal(5.0) * t191;
    let rod_v_x_dot_by_contact_damping = t24 * t193 - R::literal(5.0) * t192;
    let cylinder_omega_dot_by_contact_damping = t22 * t195 - t21 * t196
        - R::literal(-2_777.777_777_777_778) * t194 + t23 * t193;
    let cylinder_v_y_dot_by_contact_damping = t20 * t193
        - R::literal(3.333_333_333_333_333_5) * t195;
    let cylinder_v_x_dot_by_contact_damping = -(R::literal(3.333_333_333_333_333_5)
        * t196) - t19 * t193;
    let plate_omega_dot_by_contact_damping = t16 * t197 - t15 * t198 - t15 * t196
        + t16 * t195 + t17 * t190 - t18 * t189;
    let plate_v_y_dot_by_contact_damping = -(R::literal(0.833_333_333_333_333_4) * t197)
        - R::literal(-0.833_333_333_333_333_4) * t195
        - R::literal(-0.833_333_333_333_333_4) * t189;
    let plate_v_x_dot_by_contact_damping = -(R::literal(0.833_333_333_333_333_4) * t198)
        - R::literal(-0.833_333_333_333_333_4) * t196
        - R::literal(-0.833_333_333_333_333_4) * t190;
    let post_omega_dot_by_contact_damping = t14 * t199 - t13 * t200 - t13 * t198
        + t14 * t197;
    let post_v_y_dot_by_contact_damping = -(R::literal(1.25) * t199)
        - R::literal(-1.25) * t197;
    let post_v_x_dot_by_contact_damping = -(R::literal(1.25) * t200)
        - R::literal(-1.25) * t198;
    [
        post_v_x_dot_by_spring_stiffness,
        post_v_x_dot_by_spring_damping,
        post_v_x_dot_by_contact_stiffness,
        post_v_x_dot_by_contact_damping,
        post_v_y_dot_by_spring_stiffness,
        post_v_y_dot_by_spring_damping,
        post_v_y_dot_by_contact_stiffness,
        post_v_y_dot_by_contact_damping,
        post_omega_dot_by_spring_stiffness,
        post_omega_dot_by_spring_damping,
        post_omega_dot_by_contact_stiffness,
        post_omega_dot_by_contact_damping,
        plate_v_x_dot_by_spring_stiffness,
        plate_v_x_dot_by_spring_damping,
        plate_v_x_dot_by_contact_stiffness,
        plate_v_x_dot_by_contact_damping,
        plate_v_y_dot_by_spring_stiffness,
        plate_v_y_dot_by_spring_damping,
        plate_v_y_dot_by_contact_stiffness,
        plate_v_y_dot_by_contact_damping,
        plate_omega_dot_by_spring_stiffness,
        plate_omega_dot_by_spring_damping,
        plate_omega_dot_by_contact_stiffness,
        plate_omega_dot_by_contact_damping,
        cylinder_v_x_dot_by_spring_stiffness,
        cylinder_v_x_dot_by_spring_damping,
        cylinder_v_x_dot_by_contact_stiffness,
        cylinder_v_x_dot_by_contact_damping,
        cylinder_v_y_dot_by_spring_stiffness,
        cylinder_v_y_dot_by_spring_damping,
        cylinder_v_y_dot_by_contact_stiffness,
        cylinder_v_y_dot_by_contact_damping,
        cylinder_omega_dot_by_spring_stiffness,
        cylinder_omega_dot_by_spring_damping,
        cylinder_omega_dot_by_contact_stiffness,
        cylinder_omega_dot_by_contact_damping,
        rod_v_x_dot_by_spring_stiffness,
        rod_v_x_dot_by_spring_damping,
        rod_v_x_dot_by_contact_stiffness,
        rod_v_x_dot_by_contact_damping,
        rod_v_y_dot_by_spring_stiffness,
        rod_v_y_dot_by_spring_damping,
        rod_v_y_dot_by_contact_stiffness,
        rod_v_y_dot_by_contact_damping,
        rod_omega_dot_by_spring_stiffness,
        rod_omega_dot_by_spring_damping,
        rod_omega_dot_by_contact_stiffness,
        rod_omega_dot_by_contact_damping,
        bobbin_v_x_dot_by_spring_stiffness,
        bobbin_v_x_dot_by_spring_damping,
        bobbin_v_x_dot_by_contact_stiffness,
        bobbin_v_x_dot_by_contact_damping,
        bobbin_v_y_dot_by_spring_stiffness,
        bobbin_v_y_dot_by_spring_damping,
        bobbin_v_y_dot_by_contact_stiffness,
        bobbin_v_y_dot_by_contact_damping,
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
    ]
}

/// Wanted outputs.
///
/// 52 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, _, bobbin_x, bobbin_y, _, _, post_omega, _, _, _, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed,
    stop_closed] = *state;
    let cos_post_phi = post_phi.cos();
    let sin_post_phi = post_phi.sin();
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0 + t1 * t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let stop_push = -(R::literal(1_000_000.0) * stop_gap)
        - R::literal(1500.0) * stop_rate;
    let contact_rate = (bobbin_v_x * t0 + bobbin_v_y * t1) / between;
    let slide_rate = cylinder_omega
        * (rod_y_minus_cylinder_y * cos_cylinder_phi
            - rod_x_minus_cylinder_x * sin_cylinder_phi)
        + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let contact_push = -(p.contact_stiffness * contact_gap)
        - p.contact_damping * contact_rate;
    Outputs {
        contact_force: R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            contact_push,
        ),
        stop_force: R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            stop_push,
        ),
        contact_gap,
        stop_gap,
        strut_push: -(p.spring_stiffness * (slide - R::literal(0.116)))
            - p.spring_damping * slide_rate,
        post_angle: post_phi,
        plate_angle: plate_phi,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 78 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, post_y, post_phi, _, plate_y, _, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, _, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
    let stop_gap = R::literal(0.143) * post_phi.sin()
        - R::literal(0.044) * post_phi.cos();
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0 + t1 * t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let slide = (rod_x - cylinder_x) * cylinder_phi.cos()
        + (rod_y - cylinder_y) * cylinder_phi.sin();
    let t2 = slide - R::literal(0.116);
    let t3 = R::literal(0.00012) * (rod_omega * rod_omega)
        + R::literal(0.00018) * (cylinder_omega * cylinder_omega)
        + R::literal(0.00125) * (plate_omega * plate_omega)
        + R::literal(0.00135) * (post_omega * post_omega)
        + R::literal(0.1) * (rod_v_x * rod_v_x + rod_v_y * rod_v_y)
        + R::literal(0.15) * (cylinder_v_x * cylinder_v_x + cylinder_v_y * cylinder_v_y);
    Energy {
        kinetic: t3
            + R::literal(0.35) * (bobbin_v_x * bobbin_v_x + bobbin_v_y * bobbin_v_y)
            + R::literal(0.4) * (post_v_x * post_v_x + post_v_y * post_v_y)
            + R::literal(0.6) * (plate_v_x * plate_v_x + plate_v_y * plate_v_y),
        potential: R::literal(0.5) * p.spring_stiffness * (t2 * t2)
            + R::literal(1.962) * rod_y + R::literal(2.943) * cylinder_y
            + R::literal(6.867) * bobbin_y + R::literal(7.848) * post_y
            + R::literal(11.772) * plate_y
            + R::select_less(
                contact_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(0.5) * p.contact_stiffness * (contact_gap * contact_gap),
            )
            + R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(500_000.0) * (stop_gap * stop_gap),
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 838 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, post_v_x, post_v_y, post_omega, plate_v_x,
    plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y,
    rod_omega, bobbin_v_x, bobbin_v_y, contact_closed, stop_closed] = *state;
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
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let t8 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let stop_rate = post_omega * t8;
    let t9 = bobbin_x - R::literal(0.328);
    let t10 = bobbin_y - R::literal(0.058);
    let between = (t9 * t9 + t10 * t10).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t9 + bobbin_v_y * t10) / between;
    let t11 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t11 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t12 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t13 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let t14 = t1 * R::literal(370.370_370_370_370_3);
    let t15 = t0 * R::literal(370.370_370_370_370_3);
    let t16 = t3 * R::literal(400.0);
    let t17 = t2 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = t5 * R::literal(2_777.777_777_777_778);
    let t23 = t4 * R::literal(2_777.777_777_777_778);
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = t7 * R::literal(4_166.666_666_666_667);
    let t28 = t6 * R::literal(4_166.666_666_666_667);
    let t29 = t14 * t1;
    let t30 = R::literal(-1.25) - t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(-1.25) - t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t37 - t38);
    let t40 = t14 * t0 - t35 * t32;
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 - t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0)
        / (t30 - R::literal(0.833_333_333_333_333_4) - t44 - t35 * t34 - t41 * t40);
    let t46 = t17 * t3;
    let t47 = t32 + t46 - t33 * t34 - t43 * t40;
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0)
        / (t37 - R::literal(0.833_333_333_333_333_4) - t57 - t38 - t43 * t42
            - t48 * t47);
    let t59 = t16 * t2 - t50 * t47;
    let t60 = t59 * t58;
    let t61 = R::literal(0.833_333_333_333_333_4) - t57 - t51 * t47;
    let t62 = t61 * t58;
    let t63 = -(t18 * t2);
    let t64 = t63 - t54 * t47;
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66 + t56 * t47;
    let t68 = t67 * t58;
    let t69 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t44
            - R::literal(3.333_333_333_333_333_5) - t22 * t5 - t50 * t49 - t60 * t59);
    let t70 = t46 + t23 * t5 - t51 * t49 - t62 * t59;
    let t71 = t70 * t69;
    let t72 = R::literal(-2_777.777_777_777_778) * t5;
    let t73 = t72 * t69;
    let t74 = t24 * t5 - t20;
    let t75 = t74 * t69;
    let t76 = R::literal(-0.833_333_333_333_333_4) + t52 - t54 * t49 - t65 * t59;
    let t77 = t76 * t69;
    let t78 = t56 * t49 - t55 - t68 * t59;
    let t79 = t78 * t69;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t57
            - R::literal(3.333_333_333_333_333_5) - t23 * t4 - t51 * t46 - t62 * t61
            - t71 * t70);
    let t81 = R::literal(-2_777.777_777_777_778) * t4 + t73 * t70;
    let t82 = t81 * t80;
    let t83 = t21 - t24 * t4 - t75 * t70;
    let t84 = t83 * t80;
    let t85 = t63 - t54 * t46 - t65 * t61 - t77 * t70;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t66 + t56 * t46 - t68 * t61
        - t79 * t70;
    let t88 = t87 * t80;
    let t89 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t73 * t72 - t82 * t81);
    let t90 = t75 * t72 - t24 - t84 * t81;
    let t91 = t90 * t89;
    let t92 = t27 * t89;
    let t93 = t28 * t89;
    let t94 = t77 * t72 - t86 * t81;
    let t95 = t94 * t89;
    let t96 = t79 * t72 - t88 * t81;
    let t97 = t96 * t89;
    let t98 = R::literal(1.0)
        / (-(t20 * sin_cylinder_phi) - t21 * cos_cylinder_phi - t24 * slide
            - t25 * sin_cylinder_phi - t26 * cos_cylinder_phi - t75 * t74 - t84 * t83
            - t91 * t90);
    let t99 = t25 - t92 * t90;
    let t100 = t99 * t98;
    let t101 = t93 * t90 - t26;
    let t102 = t101 * t98;
    let t103 = -(t77 * t74) - t86 * t83 - t95 * t90;
    let t104 = t103 * t98;
    let t105 = -(t79 * t74) - t88 * t83 - t97 * t90;
    let t106 = t105 * t98;
    let t107 = R::literal(1.0) / (R::literal(-5.0) - t27 * t7 - t92 * t27 - t100 * t99);
    let t108 = t28 * t7 + t93 * t27 - t102 * t99;
    let t109 = t108 * t107;
    let t110 = -(t95 * t27) - t104 * t99;
    let t111 = t110 * t107;
    let t112 = -(t97 * t27) - t106 * t99;
    let t113 = t112 * t107;
    let t114 = R::literal(1.0)
        / (R::literal(-5.0) - t28 * t6 - t93 * t28 - t102 * t101 - t109 * t108);
    let t115 = t95 * t28 - t104 * t101 - t111 * t108;
    let t116 = t115 * t114;
    let t117 = t97 * t28 - t106 * t101 - t113 * t108;
    let t118 = t117 * t114;
    let t119 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t12
            - R::literal(1.428_571_428_571_428_6) - t54 * t53 - t65 * t64 - t77 * t76
            - t86 * t85 - t95 * t94 - t104 * t103 - t111 * t110 - t116 * t115);
    let t120 = t19 * t12 + t56 * t53 - t68 * t64 - t79 * t76 - t88 * t85 - t97 * t94
        - t106 * t103 - t113 * t110 - t118 * t115;
    let t121 = t120 * t119;
    let t122 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t19 * t13
            - R::literal(1.428_571_428_571_428_6) - t56 * t55 - t68 * t67 - t79 * t78
            - t88 * t87 - t97 * t96 - t106 * t105 - t113 * t112 - t118 * t117
            - t121 * t120);
    let t123 = R::literal(1_000_000.0) * stop_gap * t8;
    let t124 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -t123 - R::literal(1500.0) * stop_rate * t8,
    );
    let t125 = p.spring_stiffness * (slide - R::literal(0.116));
    let t126 = t125 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t127 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t128 = t126 + t127;
    let t129 = t125 * sin_cylinder_phi;
    let t130 = R::literal(2.943) - t129;
    let t131 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t132 = t131 - t130;
    let t133 = t125 * t11;
    let t134 = -t133 - spring_damping_times_slide_rate * t11;
    let t135 = -t126 - t127;
    let t136 = R::literal(1.962) + t129;
    let t137 = -t131 - t136;
    let t138 = contact_stiffness_times_contact_gap * t9 / between;
    let t139 = R::literal(6.867)
        + R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            contact_stiffness_times_contact_gap * t10 / between,
        );
    let t140 = R::literal(0.1) * (post_omega * post_omega);
    let t141 = t140 * cos_post_phi;
    let t142 = t140 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t143 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t144 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t145 = R::literal(0.06) * (rod_omega * rod_omega);
    let t146 = t14 * t124;
    let t147 = -t141 - t146;
    let t148 = t15 * t124;
    let t149 = t33 * t147;
    let t150 = -t142 - R::literal(-9.81) + t148 - t149;
    let t151 = -(t143 * cos_plate_phi + t141) - t146 - t35 * t147 - t41 * t150;
    let t152 = -(t143 * sin_plate_phi + t142) - R::literal(9.81) + t148
        - R::literal(-9.81) - t149 - t43 * t150 - t48 * t151;
    let t153 = R::literal(3.333_333_333_333_333_5) * t128;
    let t154 = -(R::literal(0.06)
        * (plate_omega_squared * cos_plate_phi
            + cylinder_omega_squared * cos_cylinder_phi)) - t153 - t22 * t134
        - t50 * t151 - t60 * t152;
    let t155 = R::literal(3.333_333_333_333_333_5) * t132;
    let t156 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81) - t155
        + t23 * t134 - t51 * t151 - t62 * t152 - t71 * t154;
    let t157 = t73 * t154 - R::literal(-2_777.777_777_777_778) * t134 - t82 * t156;
    let t158 = t144 - t20 * t128 + t21 * t132 + t24 * t134 + t25 * t135 - t26 * t137
        - t75 * t154 - t84 * t156 - t91 * t157;
    let t159 = R::literal(5.0) * t135;
    let t160 = t145 * cos_rod_phi - t159 - t92 * t157 - t100 * t158;
    let t161 = R::literal(5.0) * t137;
    let t162 = t145 * sin_rod_phi - t161 + t93 * t157 - t102 * t158 - t109 * t160;
    let t163 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -t138 - contact_damping_times_contact_rate * t9 / between,
        );
    let t164 = t13 * plate_omega_squared - t163 - t54 * t151 - t65 * t152 - t77 * t154
        - t86 * t156 - t95 * t157 - t104 * t158 - t111 * t160 - t116 * t162;
    let t165 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_damping_times_contact_rate * t10 / between),
        ) - t139);
    let t166 = (t12 * plate_omega_squared - R::literal(9.81) - t165 + t56 * t151
        - t68 * t152 - t79 * t154 - t88 * t156 - t97 * t157 - t106 * t158 - t113 * t160
        - t118 * t162 - t121 * t164) * t122;
    let t167 = t164 * t119 - t121 * t166;
    let t168 = t162 * t114 - t116 * t167 - t118 * t166;
    let t169 = t160 * t107 - t109 * t168 - t111 * t167 - t113 * t166;
    let t170 = t158 * t98 - t100 * t169 - t102 * t168 - t104 * t167 - t106 * t166;
    let t171 = t157 * t89 - t91 * t170 - t92 * t169 + t93 * t168 - t95 * t167
        - t97 * t166;
    let t172 = t156 * t80 - t82 * t171 - t84 * t170 - t86 * t167 - t88 * t166;
    let t173 = t154 * t69 - t71 * t172 + t73 * t171 - t75 * t170 - t77 * t167
        - t79 * t166;
    let t174 = t152 * t58 - t60 * t173 - t62 * t172 - t65 * t167 - t68 * t166;
    let t175 = t151 * t45 - t48 * t174 - t50 * t173 - t51 * t172 - t54 * t167
        + t56 * t166;
    let t176 = t150 * t39 - t41 * t175 - t43 * t174;
    let t177 = t147 * t31 - t33 * t176 - t35 * t175 - t33 * t174;
    let bobbin_v_y_dot = t165 - R::literal(1.428_571_428_571_428_6) * t166;
    let bobbin_v_x_dot = t163 - R::literal(1.428_571_428_571_428_6) * t167;
    let rod_omega_dot = t27 * t169 - R::literal(4_166.666_666_666_667) * t171
        - t28 * t168;
    let rod_v_y_dot = t161 - t26 * t170 - R::literal(5.0) * t168;
    let rod_v_x_dot = t159 + t25 * t170 - R::literal(5.0) * t169;
    let cylinder_omega_dot = t134 * R::literal(2_777.777_777_777_778) - t22 * t173
        + t23 * t172 - R::literal(-2_777.777_777_777_778) * t171 + t24 * t170;
    let cylinder_v_y_dot = t155 - R::literal(3.333_333_333_333_333_5) * t172
        + t21 * t170;
    let cylinder_v_x_dot = t153 - R::literal(3.333_333_333_333_333_5) * t173
        - t20 * t170;
    let plate_omega_dot = t17 * t174 - t16 * t175 - t16 * t173 + t17 * t172 + t18 * t167
        - t19 * t166;
    let plate_v_y_dot = R::literal(-9.81) - R::literal(0.833_333_333_333_333_4) * t174
        - R::literal(-0.833_333_333_333_333_4) * t172
        - R::literal(-0.833_333_333_333_333_4) * t166;
    let plate_v_x_dot = -(R::literal(0.833_333_333_333_333_4) * t175)
        - R::literal(-0.833_333_333_333_333_4) * t173
        - R::literal(-0.833_333_333_333_333_4) * t167;
    let post_omega_dot = t124 * R::literal(370.370_370_370_370_3) - t14 * t177
        + t15 * t176 - t14 * t175 + t15 * t174;
    let post_v_y_dot = R::literal(-9.81) - R::literal(1.25) * t176
        - R::literal(-1.25) * t174;
    let post_v_x_dot = -(R::literal(1.25) * t177) - R::literal(-1.25) * t175;
    let t178 = R::literal(7.848) * post_v_y
        + R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), t123)
            * post_omega + R::literal(11.772) * plate_v_y - t126 * cylinder_v_x
        + t130 * cylinder_v_y + t133 * cylinder_omega + t126 * rod_v_x + t136 * rod_v_y
        + R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t138)
            * bobbin_v_x + t139 * bobbin_v_y + R::literal(0.8) * post_v_x * post_v_x_dot;
    let t179 = t178 + R::literal(0.8) * post_v_y * post_v_y_dot
        + R::literal(0.0027) * post_omega * post_omega_dot
        + R::literal(1.2) * plate_v_x * plate_v_x_dot
        + R::literal(1.2) * plate_v_y * plate_v_y_dot
        + R::literal(0.0025) * plate_omega * plate_omega_dot
        + R::literal(0.3) * cylinder_v_x * cylinder_v_x_dot
        + R::literal(0.3) * cylinder_v_y * cylinder_v_y_dot
        + R::literal(0.00036) * cylinder_omega * cylinder_omega_dot;
    let t180 = p.spring_damping * cylinder_omega * slide_rate * t11
        + p.spring_damping * rod_v_x * slide_rate * cos_cylinder_phi
        + p.spring_damping * rod_v_y * slide_rate * sin_cylinder_phi
        + R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            p.contact_damping * bobbin_v_x * contact_rate * t9 / between
                + p.contact_damping * bobbin_v_y * contact_rate * t10 / between,
        );
    PowerBalance {
        stored_rate: t179 + R::literal(0.2) * rod_v_x * rod_v_x_dot
            + R::literal(0.2) * rod_v_y * rod_v_y_dot
            + R::literal(0.00024) * rod_omega * rod_omega_dot
            + R::literal(0.7) * bobbin_v_x * bobbin_v_x_dot
            + R::literal(0.7) * bobbin_v_y * bobbin_v_y_dot,
        supplied: R::literal(0.0),
        dissipated: t180
            + R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(1500.0) * (stop_rate * stop_rate),
            ) - p.spring_damping * cylinder_v_x * slide_rate * cos_cylinder_phi
            - p.spring_damping * cylinder_v_y * slide_rate * sin_cylinder_phi,
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 28 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let post_phi = state[2];
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let cos_post_phi = post_phi.cos();
    let sin_post_phi = post_phi.sin();
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0 + t1 * t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let stop_push = -(R::literal(1_000_000.0) * stop_gap)
        - R::literal(1500.0) * stop_rate;
    let contact_rate = (bobbin_v_x * t0 + bobbin_v_y * t1) / between;
    let contact_push = -(p.contact_stiffness * contact_gap)
        - p.contact_damping * contact_rate;
    [contact_gap, contact_push, stop_gap, stop_push]
}

/// `dg/dt` of the guards along the motion.
///
/// 727 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, bobbin_x, bobbin_y, _, _, post_omega, _, _, plate_omega,
    cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x,
    bobbin_v_y, contact_closed, stop_closed] = *state;
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
    let stop_gap = R::literal(0.143) * sin_post_phi - R::literal(0.044) * cos_post_phi;
    let t8 = R::literal(0.044) * sin_post_phi + R::literal(0.143) * cos_post_phi;
    let stop_rate = post_omega * t8;
    let t9 = bobbin_x - R::literal(0.328);
    let t10 = bobbin_y - R::literal(0.058);
    let between = (t9 * t9 + t10 * t10).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = rod_x_minus_cylinder_x * cos_cylinder_phi
        + rod_y_minus_cylinder_y * sin_cylinder_phi;
    let contact_rate = (bobbin_v_x * t9 + bobbin_v_y * t10) / between;
    let t11 = rod_y_minus_cylinder_y * cos_cylinder_phi
        - rod_x_minus_cylinder_x * sin_cylinder_phi;
    let slide_rate = cylinder_omega * t11 + (rod_v_x - cylinder_v_x) * cos_cylinder_phi
        + (rod_v_y - cylinder_v_y) * sin_cylinder_phi;
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t12 = R::literal(0.01) * sin_plate_phi + R::literal(0.1) * cos_plate_phi;
    let t13 = R::literal(0.01) * cos_plate_phi - R::literal(0.1) * sin_plate_phi;
    let t14 = t1 * R::literal(370.370_370_370_370_3);
    let t15 = t0 * R::literal(370.370_370_370_370_3);
    let t16 = t3 * R::literal(400.0);
    let t17 = t2 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = t13 * R::literal(400.0);
    let t20 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t22 = t5 * R::literal(2_777.777_777_777_778);
    let t23 = t4 * R::literal(2_777.777_777_777_778);
    let t24 = slide * R::literal(2_777.777_777_777_778);
    let t25 = sin_cylinder_phi * R::literal(5.0);
    let t26 = cos_cylinder_phi * R::literal(5.0);
    let t27 = t7 * R::literal(4_166.666_666_666_667);
    let t28 = t6 * R::literal(4_166.666_666_666_667);
    let t29 = t14 * t1;
    let t30 = R::literal(-1.25) - t29;
    let t31 = R::literal(1.0) / t30;
    let t32 = t15 * t1;
    let t33 = t32 * t31;
    let t34 = R::literal(1.25) - t29;
    let t35 = t34 * t31;
    let t36 = t15 * t0;
    let t37 = R::literal(-1.25) - t36;
    let t38 = t33 * t32;
    let t39 = R::literal(1.0) / (t37 - t38);
    let t40 = t14 * t0 - t35 * t32;
    let t41 = t40 * t39;
    let t42 = R::literal(1.25) - t36 - t38;
    let t43 = t42 * t39;
    let t44 = t16 * t3;
    let t45 = R::literal(1.0)
        / (t30 - R::literal(0.833_333_333_333_333_4) - t44 - t35 * t34 - t41 * t40);
    let t46 = t17 * t3;
    let t47 = t32 + t46 - t33 * t34 - t43 * t40;
    let t48 = t47 * t45;
    let t49 = R::literal(0.833_333_333_333_333_4) - t44;
    let t50 = t49 * t45;
    let t51 = t46 * t45;
    let t52 = t18 * t3;
    let t53 = R::literal(0.833_333_333_333_333_4) + t52;
    let t54 = t53 * t45;
    let t55 = t19 * t3;
    let t56 = t55 * t45;
    let t57 = t17 * t2;
    let t58 = R::literal(1.0)
        / (t37 - R::literal(0.833_333_333_333_333_4) - t57 - t38 - t43 * t42
            - t48 * t47);
    let t59 = t16 * t2 - t50 * t47;
    let t60 = t59 * t58;
    let t61 = R::literal(0.833_333_333_333_333_4) - t57 - t51 * t47;
    let t62 = t61 * t58;
    let t63 = -(t18 * t2);
    let t64 = t63 - t54 * t47;
    let t65 = t64 * t58;
    let t66 = t19 * t2;
    let t67 = R::literal(0.833_333_333_333_333_4) + t66 + t56 * t47;
    let t68 = t67 * t58;
    let t69 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t44
            - R::literal(3.333_333_333_333_333_5) - t22 * t5 - t50 * t49 - t60 * t59);
    let t70 = t46 + t23 * t5 - t51 * t49 - t62 * t59;
    let t71 = t70 * t69;
    let t72 = R::literal(-2_777.777_777_777_778) * t5;
    let t73 = t72 * t69;
    let t74 = t24 * t5 - t20;
    let t75 = t74 * t69;
    let t76 = R::literal(-0.833_333_333_333_333_4) + t52 - t54 * t49 - t65 * t59;
    let t77 = t76 * t69;
    let t78 = t56 * t49 - t55 - t68 * t59;
    let t79 = t78 * t69;
    let t80 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t57
            - R::literal(3.333_333_333_333_333_5) - t23 * t4 - t51 * t46 - t62 * t61
            - t71 * t70);
    let t81 = R::literal(-2_777.777_777_777_778) * t4 + t73 * t70;
    let t82 = t81 * t80;
    let t83 = t21 - t24 * t4 - t75 * t70;
    let t84 = t83 * t80;
    let t85 = t63 - t54 * t46 - t65 * t61 - t77 * t70;
    let t86 = t85 * t80;
    let t87 = R::literal(-0.833_333_333_333_333_4) + t66 + t56 * t46 - t68 * t61
        - t79 * t70;
    let t88 = t87 * t80;
    let t89 = R::literal(1.0)
        / (R::literal(-6_944.444_444_444_445) - t73 * t72 - t82 * t81);
    let t90 = t75 * t72 - t24 - t84 * t81;
    let t91 = t90 * t89;
    let t92 = t27 * t89;
    let t93 = t28 * t89;
    let t94 = t77 * t72 - t86 * t81;
    let t95 = t94 * t89;
    let t96 = t79 * t72 - t88 * t81;
    let t97 = t96 * t89;
    let t98 = R::literal(1.0)
        / (-(t20 * sin_cylinder_phi) - t21 * cos_cylinder_phi - t24 * slide
            - t25 * sin_cylinder_phi - t26 * cos_cylinder_phi - t75 * t74 - t84 * t83
            - t91 * t90);
    let t99 = t25 - t92 * t90;
    let t100 = t99 * t98;
    let t101 = t93 * t90 - t26;
    let t102 = t101 * t98;
    let t103 = -(t77 * t74) - t86 * t83 - t95 * t90;
    let t104 = t103 * t98;
    let t105 = -(t79 * t74) - t88 * t83 - t97 * t90;
    let t106 = t105 * t98;
    let t107 = R::literal(1.0) / (R::literal(-5.0) - t27 * t7 - t92 * t27 - t100 * t99);
    let t108 = t28 * t7 + t93 * t27 - t102 * t99;
    let t109 = t108 * t107;
    let t110 = -(t95 * t27) - t104 * t99;
    let t111 = t110 * t107;
    let t112 = -(t97 * t27) - t106 * t99;
    let t113 = t112 * t107;
    let t114 = R::literal(1.0)
        / (R::literal(-5.0) - t28 * t6 - t93 * t28 - t102 * t101 - t109 * t108);
    let t115 = t95 * t28 - t104 * t101 - t111 * t108;
    let t116 = t115 * t114;
    let t117 = t97 * t28 - t106 * t101 - t113 * t108;
    let t118 = t117 * t114;
    let t119 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t18 * t12
            - R::literal(1.428_571_428_571_428_6) - t54 * t53 - t65 * t64 - t77 * t76
            - t86 * t85 - t95 * t94 - t104 * t103 - t111 * t110 - t116 * t115);
    let t120 = t19 * t12 + t56 * t53 - t68 * t64 - t79 * t76 - t88 * t85 - t97 * t94
        - t106 * t103 - t113 * t110 - t118 * t115;
    let t121 = t120 * t119;
    let t122 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t19 * t13
            - R::literal(1.428_571_428_571_428_6) - t56 * t55 - t68 * t67 - t79 * t78
            - t88 * t87 - t97 * t96 - t106 * t105 - t113 * t112 - t118 * t117
            - t121 * t120);
    let t123 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1_000_000.0) * stop_gap * t8) - R::literal(1500.0) * stop_rate * t8,
    );
    let t124 = p.spring_stiffness * (slide - R::literal(0.116));
    let t125 = t124 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t126 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t127 = t125 + t126;
    let t128 = t124 * sin_cylinder_phi;
    let t129 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t130 = t129 - (R::literal(2.943) - t128);
    let t131 = -(t124 * t11) - spring_damping_times_slide_rate * t11;
    let t132 = -t125 - t126;
    let t133 = -t129 - (R::literal(1.962) + t128);
    let t134 = contact_damping_times_contact_rate * t9;
    let t135 = contact_damping_times_contact_rate * t10;
    let t136 = R::literal(0.1) * (post_omega * post_omega);
    let t137 = t136 * cos_post_phi;
    let t138 = t136 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t139 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t140 = cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi
            + R::literal(2.0) * rod_v_y * sin_cylinder_phi
            + cylinder_x * cylinder_omega * sin_cylinder_phi
            + rod_y * cylinder_omega * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_x * cos_cylinder_phi
            - R::literal(2.0) * cylinder_v_y * sin_cylinder_phi
            - cylinder_y * cylinder_omega * cos_cylinder_phi
            - rod_x * cylinder_omega * sin_cylinder_phi);
    let t141 = R::literal(0.06) * (rod_omega * rod_omega);
    let t142 = t14 * t123;
    let t143 = -t137 - t142;
    let t144 = t15 * t123;
    let t145 = t33 * t143;
    let t146 = -t138 - R::literal(-9.81) + t144 - t145;
    let t147 = -(t139 * cos_plate_phi + t137) - t142 - t35 * t143 - t41 * t146;
    let t148 = -(t139 * sin_plate_phi + t138) - R::literal(9.81) + t144
        - R::literal(-9.81) - t145 - t43 * t146 - t48 * t147;
    let t149 = -(R::literal(0.06)
        * (plate_omega_squared * cos_plate_phi
            + cylinder_omega_squared * cos_cylinder_phi))
        - R::literal(3.333_333_333_333_333_5) * t127 - t22 * t131 - t50 * t147
        - t60 * t148;
    let t150 = -(R::literal(0.06)
        * (plate_omega_squared * sin_plate_phi
            + cylinder_omega_squared * sin_cylinder_phi)) - R::literal(9.81)
        - R::literal(3.333_333_333_333_333_5) * t130 + t23 * t131 - t51 * t147
        - t62 * t148 - t71 * t149;
    let t151 = t73 * t149 - R::literal(-2_777.777_777_777_778) * t131 - t82 * t150;
    let t152 = t140 - t20 * t127 + t21 * t130 + t24 * t131 + t25 * t132 - t26 * t133
        - t75 * t149 - t84 * t150 - t91 * t151;
    let t153 = t141 * cos_rod_phi - R::literal(5.0) * t132 - t92 * t151 - t100 * t152;
    let t154 = t141 * sin_rod_phi - R::literal(5.0) * t133 + t93 * t151 - t102 * t152
        - t109 * t153;
    let t155 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_stiffness_times_contact_gap * t9 / between) - t134 / between,
        );
    let t156 = t13 * plate_omega_squared - t155 - t54 * t147 - t65 * t148 - t77 * t149
        - t86 * t150 - t95 * t151 - t104 * t152 - t111 * t153 - t116 * t154;
    let t157 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(t135 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    contact_stiffness_times_contact_gap * t10 / between,
                )));
    let t158 = (t12 * plate_omega_squared - R::literal(9.81) - t157 + t56 * t147
        - t68 * t148 - t79 * t149 - t88 * t150 - t97 * t151 - t106 * t152 - t113 * t153
        - t118 * t154 - t121 * t156) * t122;
    let t159 = t156 * t119 - t121 * t158;
    let t160 = t154 * t114 - t116 * t159 - t118 * t158;
    let t161 = t153 * t107 - t109 * t160 - t111 * t159 - t113 * t158;
    let t162 = t152 * t98 - t100 * t161 - t102 * t160 - t104 * t159 - t106 * t158;
    let t163 = t151 * t89 - t91 * t162 - t92 * t161 + t93 * t160 - t95 * t159
        - t97 * t158;
    let t164 = t150 * t80 - t82 * t163 - t84 * t162 - t86 * t159 - t88 * t158;
    let t165 = t149 * t69 - t71 * t164 + t73 * t163 - t75 * t162 - t77 * t159
        - t79 * t158;
    let t166 = t148 * t58 - t60 * t165 - t62 * t164 - t65 * t159 - t68 * t158;
    let t167 = t147 * t45 - t48 * t166 - t50 * t165 - t51 * t164 - t54 * t159
        + t56 * t158;
    let t168 = t146 * t39 - t41 * t167 - t43 * t166;
    let bobbin_v_y_dot = t157 - R::literal(1.428_571_428_571_428_6) * t158;
    let bobbin_v_x_dot = t155 - R::literal(1.428_571_428_571_428_6) * t159;
    let post_omega_dot = t123 * R::literal(370.370_370_370_370_3)
        - t14 * (t143 * t31 - t33 * t168 - t35 * t167 - t33 * t166) + t15 * t168
        - t14 * t167 + t15 * t166;
    let between_squared = between * between;
    let contact_touches_guard_rate = t9 / between * bobbin_v_x
        + t10 / between * bobbin_v_y;
    let t169 = (t134 / between_squared - p.contact_damping * bobbin_v_x / between
        - p.contact_stiffness * t9 / between) * bobbin_v_x
        + (t135 / between_squared - p.contact_damping * bobbin_v_y / between
            - p.contact_stiffness * t10 / between) * bobbin_v_y
        - p.contact_damping * t9 / between * bobbin_v_x_dot;
    let contact_opens_guard_rate = t169
        - p.contact_damping * t10 / between * bobbin_v_y_dot;
    let stop_opens_guard_rate = (R::literal(214.5) * post_omega * sin_post_phi
        - R::literal(143_000.0) * cos_post_phi - R::literal(44000.0) * sin_post_phi
        - R::literal(66.0) * post_omega * cos_post_phi) * post_omega
        + (-(R::literal(214.5) * cos_post_phi) - R::literal(66.0) * sin_post_phi)
            * post_omega_dot;
    [
        contact_touches_guard_rate,
        contact_opens_guard_rate,
        stop_rate,
        stop_opens_guard_rate,
    ]
}

/// New values of the states that each event sets, event by event.
///
/// No operations.
#[must_use]
pub fn resets<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; RESETS] {
    [R::literal(1.0), R::literal(0.0), R::literal(1.0), R::literal(0.0)]
}

/// `g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.
///
/// 49 operations.
#[must_use]
pub fn constraint_values<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [post_x, post_y, post_phi, plate_x, plate_y, plate_phi, cylinder_x, cylinder_y,
    cylinder_phi, rod_x, rod_y, rod_phi, bobbin_x, bobbin_y, ..] = *state;
    let t0 = R::literal(0.1) * post_phi.cos();
    let post_start_x = post_x - t0;
    let t1 = R::literal(0.1) * post_phi.sin();
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
    let slide_across_value = (rod_y - cylinder_y) * cos_cylinder_phi
        - (rod_x - cylinder_x) * sin_cylinder_phi;
    let pin_c_x_value = plate_start_x - post_end_x;
    let pin_c_y_value = plate_start_y - post_end_y;
    let pin_d_x_value = cylinder_start_x - plate_end_x;
    let pin_d_y_value = cylinder_start_y - plate_end_y;
    let slide_angle_value = rod_phi - cylinder_phi;
    let pin_e_y_value = rod_end_y - R::literal(0.28);
    let axle_a_x_value = bobbin_x - axle_x;
    let axle_a_y_value = bobbin_y - axle_y;
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
    ]
}

/// `g'`, zero on the constraints too.
///
/// 63 operations.
#[must_use]
pub fn constraint_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, _, _, post_v_x, post_v_y, post_omega, plate_v_x, plate_v_y,
    plate_omega, cylinder_v_x, cylinder_v_y, cylinder_omega, rod_v_x, rod_v_y, rod_omega,
    bobbin_v_x, bobbin_v_y, ..] = *state;
    let cos_plate_phi = plate_phi.cos();
    let sin_plate_phi = plate_phi.sin();
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let slide = (rod_x - cylinder_x) * cos_cylinder_phi
        + (rod_y - cylinder_y) * sin_cylinder_phi;
    let t0 = R::literal(0.1) * post_omega;
    let t1 = t0 * post_phi.sin();
    let pin_o_x_rate = post_v_x + t1;
    let t2 = t0 * post_phi.cos();
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
    ]
}

/// `G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.
///
/// 35 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 37] {
    let [_, _, post_phi, _, _, plate_phi, cylinder_x, cylinder_y, cylinder_phi, rod_x,
    rod_y, rod_phi, ..] = *state;
    let t0 = R::literal(0.1) * post_phi.sin();
    let cos_plate_phi = plate_phi.cos();
    let sin_plate_phi = plate_phi.sin();
    let t1 = R::literal(0.06) * sin_plate_phi;
    let cos_cylinder_phi = cylinder_phi.cos();
    let sin_cylinder_phi = cylinder_phi.sin();
    let slide = (rod_x - cylinder_x) * cos_cylinder_phi
        + (rod_y - cylinder_y) * sin_cylinder_phi;
    let t2 = -(R::literal(0.1) * post_phi.cos());
    let t3 = -(R::literal(0.06) * cos_plate_phi);
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
    ]
}

impl Describe for WinderHolderDrop {
    fn name(&self) -> &'static str {
        "winder_holder_drop"
    }
    fn title(&self) -> &'static str {
        "Four-link bobbin holder, let go"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 14,
            first_order: 2,
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
    fn events(&self) -> usize {
        EVENTS
    }
    fn event(&self, index: usize) -> Event<'_> {
        EVENT_SHAPES[index]
    }
    fn is_mode(&self, index: usize) -> bool {
        matches!(index, 28 | 29)
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
        matches!(index, 2 | 5 | 16 | 19 | 28 | 29)
    }
}

impl<R: Real> Simulator<R> for WinderHolderDrop {
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
    fn guards(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = guards(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn guard_rates(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = guard_rates(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
    }
    fn resets(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        let result = resets(time, state_of(state), &parameters_of(parameters));
        values.copy_from_slice(&result);
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
        name: "contact.closed",
        unit: "1",
        doc: "1 while there is contact",
    },
    Quantity {
        name: "stop.closed",
        unit: "1",
        doc: "1 while there is contact",
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
    1.0,
    1.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "lift",
        unit: "rad",
        doc: "angle of the post over its stop at the start",
    },
    Quantity {
        name: "spring.stiffness",
        unit: "N/m",
        doc: "spring",
    },
    Quantity {
        name: "spring.damping",
        unit: "N s/m",
        doc: "damper",
    },
    Quantity {
        name: "contact.stiffness",
        unit: "N/m",
        doc: "spring of the contact",
    },
    Quantity {
        name: "contact.damping",
        unit: "N s/m",
        doc: "damper of the contact",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    0.03,
    2000.0,
    400.0,
    1_000_000.0,
    1500.0,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "contact_force",
        unit: "N",
        doc: "force of the contact",
    },
    Quantity {
        name: "stop_force",
        unit: "N",
        doc: "force of the contact",
    },
    Quantity {
        name: "contact_gap",
        unit: "m",
        doc: "gap between bobbin and drum at K",
    },
    Quantity {
        name: "stop_gap",
        unit: "m",
        doc: "gap between post and stop at T",
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
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 1.0,
    points: 1001,
    rtol: 1e-7,
    method: "auto",
};

/// What happens where guards pass zero.
pub static EVENT_SHAPES: [Event<'static>; EVENTS] = [
    Event {
        name: "contact.touches",
        doc: "contact begins",
        direction: Direction::Falling,
        when: &[(28, 0.0)],
        sets: &[28],
    },
    Event {
        name: "contact.opens",
        doc: "the contact would pull",
        direction: Direction::Falling,
        when: &[(28, 1.0)],
        sets: &[28],
    },
    Event {
        name: "stop.touches",
        doc: "contact begins",
        direction: Direction::Falling,
        when: &[(29, 0.0)],
        sets: &[29],
    },
    Event {
        name: "stop.opens",
        doc: "the contact would pull",
        direction: Direction::Falling,
        when: &[(29, 1.0)],
        sets: &[29],
    },
];

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
];

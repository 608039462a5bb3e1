// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   044e0f4a1f2bab23afeb6e3d262a47321342ed9c5c3cc52995c00ca78c21b7a4  scenes/winder_holder_drop.toml
//   fa69a391ab85c57533a93c32c47f18b29da038e678b6c6fe99931f82ce4979fa  units/planar_body.toml
//   aa0e8a999f462eeff001756527f878c9e91be49559e9f536983ca628c62c89a6  units/spring_damper.toml
//   a7990db08476f2615903f9423a5b29997fa55f4feedd941579cf9c2628578a55  units/one_sided_contact.toml
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
//   guards                   30
//   guard_rates             730
//   resets                    0
//   constraint_values        49
//   constraint_rates         63
//   constraint_matrix        35
// With constants of the parameters, prepared once a run:
//   prepare                   1
//   prepared_rate           741
//   prepared_rate_jacobian 5082

use ::machinist_contract::{
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
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t10 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t10)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t11 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t12 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = t11 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
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
    let t39 = (t13 * t0).sub_product(t34, t31);
    let t40 = t39 * t38;
    let t41 = R::literal(1.25) - t35 - t37;
    let t42 = t41 * t38;
    let t43 = t15 * t3;
    let t44 = R::literal(1.0)
        / (t29 - R::literal(0.833_333_333_333_333_4) - t43)
            .sub_product(t34, t33)
            .sub_product(t40, t39);
    let t45 = t16 * t3;
    let t46 = (t31 + t45).sub_product(t32, t33).sub_product(t42, t39);
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
        / (t36 - R::literal(0.833_333_333_333_333_4) - t56 - t37)
            .sub_product(t42, t41)
            .sub_product(t47, t46);
    let t58 = (t15 * t2).sub_product(t49, t46);
    let t59 = t58 * t57;
    let t60 = (R::literal(0.833_333_333_333_333_4) - t56).sub_product(t50, t46);
    let t61 = t60 * t57;
    let t62 = -(t17 * t2);
    let t63 = t62.sub_product(t53, t46);
    let t64 = t63 * t57;
    let t65 = t18 * t2;
    let t66 = (R::literal(0.833_333_333_333_333_4) + t65).add_product(t55, t46);
    let t67 = t66 * t57;
    let t68 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t43
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t49, t48)
            .sub_product(t59, t58);
    let t69 = t45.add_product(t22, t5).sub_product(t50, t48).sub_product(t61, t58);
    let t70 = t69 * t68;
    let t71 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t72 = t71 * t68;
    let t73 = (-t19).add_product(t23, t5);
    let t74 = t73 * t68;
    let t75 = (R::literal(-0.833_333_333_333_333_4) + t51)
        .sub_product(t53, t48)
        .sub_product(t64, t58);
    let t76 = t75 * t68;
    let t77 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t56
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t50, t45)
            .sub_product(t61, t60)
            .sub_product(t70, t69);
    let t80 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = t20.sub_product(t23, t4).sub_product(t74, t69);
    let t83 = t82 * t79;
    let t84 = t62.sub_product(t53, t45).sub_product(t64, t60).sub_product(t76, t69);
    let t85 = t84 * t79;
    let t86 = (R::literal(-0.833_333_333_333_333_4) + t65)
        .add_product(t55, t45)
        .sub_product(t67, t60)
        .sub_product(t78, t69);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t72, t71).sub_product(t81, t80);
    let t89 = (-t23).add_product(t74, t71).sub_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = (t76 * t71).sub_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t71).sub_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0)
        / (-(t20 * cos_cylinder_phi))
            .sub_product(t19, sin_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t74, t73)
            .sub_product(t83, t82)
            .sub_product(t90, t89);
    let t98 = t24.sub_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = (-t25).add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (-(t76 * t73)).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (-(t78 * t73)).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t6)
            .sub_product(t91, t26)
            .sub_product(t99, t98);
    let t107 = (t27 * t6).add_product(t92, t26).sub_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (-(t94 * t26)).sub_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (-(t96 * t26)).sub_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, R::literal(0.06) * cos_rod_phi)
            .sub_product(t92, t27)
            .sub_product(t101, t100)
            .sub_product(t108, t107);
    let t114 = (t94 * t27).sub_product(t103, t100).sub_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (t96 * t27).sub_product(t105, t100).sub_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t11)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t53, t52)
            .sub_product(t64, t63)
            .sub_product(t76, t75)
            .sub_product(t85, t84)
            .sub_product(t94, t93)
            .sub_product(t103, t102)
            .sub_product(t110, t109)
            .sub_product(t115, t114);
    let t119 = (t18 * t11)
        .add_product(t55, t52)
        .sub_product(t67, t63)
        .sub_product(t78, t75)
        .sub_product(t87, t84)
        .sub_product(t96, t93)
        .sub_product(t105, t102)
        .sub_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(R::literal(1_000_000.0) * stop_gap * t7))
            .sub_product(R::literal(1500.0) * stop_rate, t7),
    );
    let t122 = p.spring_stiffness * (slide - R::literal(0.116));
    let t123 = t122 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t124 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t125 = t123 + t124;
    let t126 = t122 * sin_cylinder_phi;
    let t127 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t128 = t127 - (R::literal(2.943) - t126);
    let t129 = (-(t122 * t10)).sub_product(spring_damping_times_slide_rate, t10);
    let t130 = -t123 - t124;
    let t131 = -t127 - (R::literal(1.962) + t126);
    let t132 = R::literal(0.1) * (post_omega * post_omega);
    let t133 = t132 * cos_post_phi;
    let t134 = t132 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t135 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t136 = R::literal(0.06) * (rod_omega * rod_omega);
    let t137 = t13 * t121;
    let t138 = -t133 - t137;
    let t139 = t14 * t121;
    let t140 = t32 * t138;
    let t141 = -t134 - R::literal(-9.81) + t139 - t140;
    let t142 = (-t133.add_product(t135, cos_plate_phi) - t137)
        .sub_product(t34, t138)
        .sub_product(t40, t141);
    let t143 = (-t134.add_product(t135, sin_plate_phi) - R::literal(9.81) + t139
        - R::literal(-9.81) - t140)
        .sub_product(t42, t141)
        .sub_product(t47, t142);
    let t144 = R::literal(3.333_333_333_333_333_5) * t125;
    let t145 = (-t144)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t21, t129)
        .sub_product(t49, t142)
        .sub_product(t59, t143);
    let t146 = R::literal(3.333_333_333_333_333_5) * t128;
    let t147 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t146)
        .add_product(t22, t129)
        .sub_product(t50, t142)
        .sub_product(t61, t143)
        .sub_product(t70, t145);
    let t148 = (-(R::literal(-2_777.777_777_777_778) * t129))
        .add_product(t72, t145)
        .sub_product(t81, t147);
    let t149 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t125)
        .add_product(t20, t128)
        .add_product(t23, t129)
        .add_product(t24, t130)
        .sub_product(t25, t131)
        .sub_product(t74, t145)
        .sub_product(t83, t147);
    let t150 = t149.sub_product(t90, t148);
    let t151 = R::literal(5.0) * t130;
    let t152 = (-t151)
        .add_product(t136, cos_rod_phi)
        .sub_product(t91, t148)
        .sub_product(t99, t150);
    let t153 = R::literal(5.0) * t131;
    let t154 = (-t153)
        .add_product(t136, sin_rod_phi)
        .add_product(t92, t148)
        .sub_product(t101, t150)
        .sub_product(t108, t152);
    let t155 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_stiffness_times_contact_gap * t8 / between)
                - contact_damping_times_contact_rate * t8 / between,
        );
    let t156 = (-t155)
        .add_product(t12, plate_omega_squared)
        .sub_product(t53, t142)
        .sub_product(t64, t143)
        .sub_product(t76, t145)
        .sub_product(t85, t147)
        .sub_product(t94, t148)
        .sub_product(t103, t150)
        .sub_product(t110, t152)
        .sub_product(t115, t154);
    let t157 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_damping_times_contact_rate * t9 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    contact_stiffness_times_contact_gap * t9 / between,
                )));
    let t158 = (R::literal(-9.81).add_product(t11, plate_omega_squared) - t157)
        .add_product(t55, t142)
        .sub_product(t67, t143)
        .sub_product(t78, t145)
        .sub_product(t87, t147)
        .sub_product(t96, t148)
        .sub_product(t105, t150)
        .sub_product(t112, t152)
        .sub_product(t117, t154)
        .sub_product(t120, t156)
        * (R::literal(1.0)
            / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t12)
                - R::literal(1.428_571_428_571_428_6))
                .sub_product(t55, t54)
                .sub_product(t67, t66)
                .sub_product(t78, t77)
                .sub_product(t87, t86)
                .sub_product(t96, t95)
                .sub_product(t105, t104)
                .sub_product(t112, t111)
                .sub_product(t117, t116)
                .sub_product(t120, t119));
    let t159 = (t156 * t118).sub_product(t120, t158);
    let t160 = (t154 * t113).sub_product(t115, t159).sub_product(t117, t158);
    let t161 = (t152 * t106)
        .sub_product(t108, t160)
        .sub_product(t110, t159)
        .sub_product(t112, t158);
    let t162 = (t150 * t97)
        .sub_product(t99, t161)
        .sub_product(t101, t160)
        .sub_product(t103, t159)
        .sub_product(t105, t158);
    let t163 = (t148 * t88)
        .sub_product(t90, t162)
        .sub_product(t91, t161)
        .add_product(t92, t160)
        .sub_product(t94, t159)
        .sub_product(t96, t158);
    let t164 = (t147 * t79)
        .sub_product(t81, t163)
        .sub_product(t83, t162)
        .sub_product(t85, t159)
        .sub_product(t87, t158);
    let t165 = (t145 * t68)
        .sub_product(t70, t164)
        .add_product(t72, t163)
        .sub_product(t74, t162)
        .sub_product(t76, t159)
        .sub_product(t78, t158);
    let t166 = (t143 * t57)
        .sub_product(t59, t165)
        .sub_product(t61, t164)
        .sub_product(t64, t159)
        .sub_product(t67, t158);
    let t167 = (t142 * t44)
        .sub_product(t47, t166)
        .sub_product(t49, t165)
        .sub_product(t50, t164)
        .sub_product(t53, t159)
        .add_product(t55, t158);
    let t168 = (t141 * t38).sub_product(t40, t167).sub_product(t42, t166);
    let t169 = (t138 * t30)
        .sub_product(t32, t168)
        .sub_product(t34, t167)
        .sub_product(t32, t166);
    let bobbin_v_y_dot = t157.sub_product(R::literal(1.428_571_428_571_428_6), t158);
    let bobbin_v_x_dot = t155.sub_product(R::literal(1.428_571_428_571_428_6), t159);
    let rod_omega_dot = (t26 * t161)
        .sub_product(R::literal(4_166.666_666_666_667), t163)
        .sub_product(t27, t160);
    let rod_v_y_dot = t153.sub_product(t25, t162).sub_product(R::literal(5.0), t160);
    let rod_v_x_dot = t151.add_product(t24, t162).sub_product(R::literal(5.0), t161);
    let cylinder_omega_dot = (t129 * R::literal(2_777.777_777_777_778))
        .sub_product(t21, t165)
        .add_product(t22, t164)
        .sub_product(R::literal(-2_777.777_777_777_778), t163)
        .add_product(t23, t162);
    let cylinder_v_y_dot = t146
        .sub_product(R::literal(3.333_333_333_333_333_5), t164)
        .add_product(t20, t162);
    let cylinder_v_x_dot = t144
        .sub_product(R::literal(3.333_333_333_333_333_5), t165)
        .sub_product(t19, t162);
    let plate_omega_dot = (t16 * t166)
        .sub_product(t15, t167)
        .sub_product(t15, t165)
        .add_product(t16, t164)
        .add_product(t17, t159)
        .sub_product(t18, t158);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t166)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t164)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t158);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t165))
        .sub_product(R::literal(0.833_333_333_333_333_4), t167)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t159);
    let post_omega_dot = (t121 * R::literal(370.370_370_370_370_3))
        .sub_product(t13, t169)
        .add_product(t14, t168)
        .sub_product(t13, t167)
        .add_product(t14, t166);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t168)
        .sub_product(R::literal(-1.25), t166);
    let post_v_x_dot = (-(R::literal(-1.25) * t167)).sub_product(R::literal(1.25), t169);
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
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)] = R::sin_cos_each([
        post_phi,
        cylinder_phi,
    ]);
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t0 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t0;
    let t1 = bobbin_x - R::literal(0.328);
    let t2 = bobbin_y - R::literal(0.058);
    let between = (t1 * t1).add_product(t2, t2).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t1).add_product(bobbin_v_y, t2) / between;
    let t3 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t3)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let post_phi_forcing = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(R::literal(1_000_000.0) * stop_gap * t0))
            .sub_product(R::literal(1500.0) * stop_rate, t0),
    );
    let t4 = p.spring_stiffness * (slide - R::literal(0.116));
    let t5 = t4 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t6 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let cylinder_x_forcing = t5 + t6;
    let t7 = t4 * sin_cylinder_phi;
    let t8 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let cylinder_y_forcing = t8 - (R::literal(2.943) - t7);
    let cylinder_phi_forcing = (-(t4 * t3))
        .sub_product(spring_damping_times_slide_rate, t3);
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
    let t6 = R::literal(0.06) * cos_rod_phi;
    let t7 = R::literal(0.06) * sin_rod_phi;
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t8 = R::literal(0.01) * cos_plate_phi;
    let t9 = R::literal(0.1) * sin_plate_phi;
    let t10 = R::literal(0.1) * cos_plate_phi;
    let t11 = R::literal(0.01) * sin_plate_phi;
    let t12 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t12;
    let t13 = bobbin_x - R::literal(0.328);
    let t14 = t13 * t13;
    let t15 = bobbin_y - R::literal(0.058);
    let t16 = t15 * t15;
    let between = (t14 + t16).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t13).add_product(bobbin_v_y, t15) / between;
    let t17 = rod_x_minus_cylinder_x * sin_cylinder_phi;
    let t18 = rod_y_minus_cylinder_y * cos_cylinder_phi;
    let t19 = t18 - t17;
    let rod_v_x_minus_cylinder_v_x = rod_v_x - cylinder_v_x;
    let rod_v_y_minus_cylinder_v_y = rod_v_y - cylinder_v_y;
    let slide_rate = (rod_v_x_minus_cylinder_v_x * cos_cylinder_phi)
        .add_product(cylinder_omega, t19)
        .add_product(rod_v_y_minus_cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t20 = t11 + t10;
    let t21 = t9 - t8;
    let t22 = t8 - t9;
    let t23 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t24 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t25 = R::literal(24.0) * sin_plate_phi;
    let t26 = R::literal(24.0) * cos_plate_phi;
    let t27 = t20 * R::literal(400.0);
    let t28 = t22 * R::literal(400.0);
    let t29 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t30 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t31 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t32 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t33 = slide * R::literal(2_777.777_777_777_778);
    let t34 = sin_cylinder_phi * R::literal(5.0);
    let t35 = cos_cylinder_phi * R::literal(5.0);
    let t36 = R::literal(250.0) * sin_rod_phi;
    let t37 = R::literal(250.0) * cos_rod_phi;
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
    let t49 = (t23 * t0).sub_product(t44, t41);
    let t50 = t49 * t48;
    let t51 = R::literal(1.25) - t45 - t47;
    let t52 = t51 * t48;
    let t53 = t25 * t3;
    let t54 = R::literal(1.0)
        / (t39 - R::literal(0.833_333_333_333_333_4) - t53)
            .sub_product(t44, t43)
            .sub_product(t50, t49);
    let t55 = t26 * t3;
    let t56 = (t41 + t55).sub_product(t42, t43).sub_product(t52, t49);
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
        / (t46 - R::literal(0.833_333_333_333_333_4) - t66 - t47)
            .sub_product(t52, t51)
            .sub_product(t57, t56);
    let t68 = (t25 * t2).sub_product(t59, t56);
    let t69 = t68 * t67;
    let t70 = (R::literal(0.833_333_333_333_333_4) - t66).sub_product(t60, t56);
    let t71 = t70 * t67;
    let t72 = -(t27 * t2);
    let t73 = t72.sub_product(t63, t56);
    let t74 = t73 * t67;
    let t75 = t28 * t2;
    let t76 = (R::literal(0.833_333_333_333_333_4) + t75).add_product(t65, t56);
    let t77 = t76 * t67;
    let t78 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t53
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t31, t5)
            .sub_product(t59, t58)
            .sub_product(t69, t68);
    let t79 = t55.add_product(t32, t5).sub_product(t60, t58).sub_product(t71, t68);
    let t80 = t79 * t78;
    let t81 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t82 = t81 * t78;
    let t83 = (-t29).add_product(t33, t5);
    let t84 = t83 * t78;
    let t85 = (R::literal(-0.833_333_333_333_333_4) + t61)
        .sub_product(t63, t58)
        .sub_product(t74, t68);
    let t86 = t85 * t78;
    let t87 = (-t64).add_product(t65, t58).sub_product(t77, t68);
    let t88 = t87 * t78;
    let t89 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t66
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t32, t4)
            .sub_product(t60, t55)
            .sub_product(t71, t70)
            .sub_product(t80, t79);
    let t90 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t82, t79);
    let t91 = t90 * t89;
    let t92 = t30.sub_product(t33, t4).sub_product(t84, t79);
    let t93 = t92 * t89;
    let t94 = t72.sub_product(t63, t55).sub_product(t74, t70).sub_product(t86, t79);
    let t95 = t94 * t89;
    let t96 = (R::literal(-0.833_333_333_333_333_4) + t75)
        .add_product(t65, t55)
        .sub_product(t77, t70)
        .sub_product(t88, t79);
    let t97 = t96 * t89;
    let t98 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t82, t81).sub_product(t91, t90);
    let t99 = (-t33).add_product(t84, t81).sub_product(t93, t90);
    let t100 = t99 * t98;
    let t101 = t36 * t98;
    let t102 = t37 * t98;
    let t103 = (t86 * t81).sub_product(t95, t90);
    let t104 = t103 * t98;
    let t105 = (t88 * t81).sub_product(t97, t90);
    let t106 = t105 * t98;
    let t107 = R::literal(1.0)
        / (-(t30 * cos_cylinder_phi))
            .sub_product(t29, sin_cylinder_phi)
            .sub_product(t33, slide)
            .sub_product(t34, sin_cylinder_phi)
            .sub_product(t35, cos_cylinder_phi)
            .sub_product(t84, t83)
            .sub_product(t93, t92)
            .sub_product(t100, t99);
    let t108 = t34.sub_product(t101, t99);
    let t109 = t108 * t107;
    let t110 = (-t35).add_product(t102, t99);
    let t111 = t110 * t107;
    let t112 = (-(t86 * t83)).sub_product(t95, t92).sub_product(t104, t99);
    let t113 = t112 * t107;
    let t114 = (-(t88 * t83)).sub_product(t97, t92).sub_product(t106, t99);
    let t115 = t114 * t107;
    let t116 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t36, t7)
            .sub_product(t101, t36)
            .sub_product(t109, t108);
    let t117 = (t37 * t7).add_product(t102, t36).sub_product(t111, t108);
    let t118 = t117 * t116;
    let t119 = (-(t104 * t36)).sub_product(t113, t108);
    let t120 = t119 * t116;
    let t121 = (-(t106 * t36)).sub_product(t115, t108);
    let t122 = t121 * t116;
    let t123 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t37, t6)
            .sub_product(t102, t37)
            .sub_product(t111, t110)
            .sub_product(t118, t117);
    let t124 = (t104 * t37).sub_product(t113, t110).sub_product(t120, t117);
    let t125 = t124 * t123;
    let t126 = (t106 * t37).sub_product(t115, t110).sub_product(t122, t117);
    let t127 = t126 * t123;
    let t128 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t27, t20)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t63, t62)
            .sub_product(t74, t73)
            .sub_product(t86, t85)
            .sub_product(t95, t94)
            .sub_product(t104, t103)
            .sub_product(t113, t112)
            .sub_product(t120, t119)
            .sub_product(t125, t124);
    let t129 = (t28 * t20)
        .add_product(t65, t62)
        .sub_product(t77, t73)
        .sub_product(t88, t85)
        .sub_product(t97, t94)
        .sub_product(t106, t103)
        .sub_product(t115, t112)
        .sub_product(t122, t119)
        .sub_product(t127, t124);
    let t130 = t129 * t128;
    let t131 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t28, t22)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t65, t64)
            .sub_product(t77, t76)
            .sub_product(t88, t87)
            .sub_product(t97, t96)
            .sub_product(t106, t105)
            .sub_product(t115, t114)
            .sub_product(t122, t121)
            .sub_product(t127, t126)
            .sub_product(t130, t129);
    let t132 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(R::literal(1_000_000.0) * stop_gap * t12))
            .sub_product(R::literal(1500.0) * stop_rate, t12),
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
    let t141 = (-(t134 * t19)).sub_product(spring_damping_times_slide_rate, t19);
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
    let t172 = (-(t151 + t147) - t167).sub_product(t44, t168).sub_product(t50, t171);
    let t173 = (-(t152 + t149) - R::literal(9.81) + t169 - R::literal(-9.81) - t170)
        .sub_product(t52, t171)
        .sub_product(t57, t172);
    let t174 = R::literal(3.333_333_333_333_333_5) * t137;
    let t175 = (-t174)
        .sub_product(
            R::literal(0.06),
            t153.add_product(plate_omega_squared, cos_plate_phi),
        )
        .sub_product(t31, t141)
        .sub_product(t59, t172)
        .sub_product(t69, t173);
    let t176 = R::literal(3.333_333_333_333_333_5) * t140;
    let t177 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            t154.add_product(plate_omega_squared, sin_plate_phi),
        ) - t176)
        .add_product(t32, t141)
        .sub_product(t60, t172)
        .sub_product(t71, t173)
        .sub_product(t80, t175);
    let t178 = (-(R::literal(-2_777.777_777_777_778) * t141))
        .add_product(t82, t175)
        .sub_product(t91, t177);
    let t179 = (cylinder_omega
        * (((t159 * cos_cylinder_phi).add_product(t160, sin_cylinder_phi) + t161 + t162)
            .sub_product(t155, cos_cylinder_phi)
            .sub_product(t156, sin_cylinder_phi) - t157 - t158))
        .sub_product(t29, t137)
        .add_product(t30, t140)
        .add_product(t33, t141)
        .add_product(t34, t143)
        .sub_product(t35, t144)
        .sub_product(t84, t175)
        .sub_product(t93, t177)
        .sub_product(t100, t178);
    let t180 = R::literal(5.0) * t143;
    let t181 = (t164 - t180).sub_product(t101, t178).sub_product(t109, t179);
    let t182 = R::literal(5.0) * t144;
    let t183 = (t165 - t182)
        .add_product(t102, t178)
        .sub_product(t111, t179)
        .sub_product(t118, t181);
    let t184 = t166
        .sub_product(
            R::literal(1.428_571_428_571_428_6),
            R::select_less(
                contact_closed,
                R::literal(0.5),
                R::literal(0.0),
                -(t145 / between) - contact_damping_times_contact_rate * t13 / between,
            ),
        )
        .sub_product(t63, t172)
        .sub_product(t74, t173)
        .sub_product(t86, t175)
        .sub_product(t95, t177)
        .sub_product(t104, t178)
        .sub_product(t113, t179)
        .sub_product(t120, t181)
        .sub_product(t125, t183);
    let t185 = R::literal(-9.81)
        .add_product(t20, plate_omega_squared)
        .sub_product(
            R::literal(1.428_571_428_571_428_6),
            R::select_less(
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
                    )),
        )
        .add_product(t65, t172)
        .sub_product(t77, t173)
        .sub_product(t88, t175)
        .sub_product(t97, t177)
        .sub_product(t106, t178)
        .sub_product(t115, t179)
        .sub_product(t122, t181)
        .sub_product(t127, t183)
        .sub_product(t130, t184) * t131;
    let t186 = (t184 * t128).sub_product(t130, t185);
    let t187 = (t183 * t123).sub_product(t125, t186).sub_product(t127, t185);
    let t188 = (t181 * t116)
        .sub_product(t118, t187)
        .sub_product(t120, t186)
        .sub_product(t122, t185);
    let t189 = (t179 * t107)
        .sub_product(t109, t188)
        .sub_product(t111, t187)
        .sub_product(t113, t186)
        .sub_product(t115, t185);
    let t190 = (t178 * t98)
        .sub_product(t100, t189)
        .sub_product(t101, t188)
        .add_product(t102, t187)
        .sub_product(t104, t186)
        .sub_product(t106, t185);
    let t191 = (t177 * t89)
        .sub_product(t91, t190)
        .sub_product(t93, t189)
        .sub_product(t95, t186)
        .sub_product(t97, t185);
    let t192 = (t175 * t78)
        .sub_product(t80, t191)
        .add_product(t82, t190)
        .sub_product(t84, t189)
        .sub_product(t86, t186)
        .sub_product(t88, t185);
    let t193 = (t173 * t67)
        .sub_product(t69, t192)
        .sub_product(t71, t191)
        .sub_product(t74, t186)
        .sub_product(t77, t185);
    let t194 = (t172 * t54)
        .sub_product(t57, t193)
        .sub_product(t59, t192)
        .sub_product(t60, t191)
        .sub_product(t63, t186)
        .add_product(t65, t185);
    let t195 = (t171 * t48).sub_product(t50, t194).sub_product(t52, t193);
    let t196 = (t168 * t40)
        .sub_product(t42, t195)
        .sub_product(t44, t194)
        .sub_product(t42, t193);
    let rod_omega_dot = (t36 * t188)
        .sub_product(R::literal(4_166.666_666_666_667), t190)
        .sub_product(t37, t187);
    let rod_v_y_dot = t182.sub_product(t35, t189).sub_product(R::literal(5.0), t187);
    let rod_v_x_dot = t180.add_product(t34, t189).sub_product(R::literal(5.0), t188);
    let cylinder_omega_dot = (t141 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t192)
        .add_product(t32, t191)
        .sub_product(R::literal(-2_777.777_777_777_778), t190)
        .add_product(t33, t189);
    let cylinder_v_y_dot = t176
        .sub_product(R::literal(3.333_333_333_333_333_5), t191)
        .add_product(t30, t189);
    let cylinder_v_x_dot = t174
        .sub_product(R::literal(3.333_333_333_333_333_5), t192)
        .sub_product(t29, t189);
    let plate_omega_dot = (t26 * t193)
        .sub_product(t25, t194)
        .sub_product(t25, t192)
        .add_product(t26, t191)
        .add_product(t27, t186)
        .sub_product(t28, t185);
    let post_omega_dot = (t132 * R::literal(370.370_370_370_370_3))
        .sub_product(t23, t196)
        .add_product(t24, t195)
        .sub_product(t23, t194)
        .add_product(t24, t193);
    let t197 = t12 * t12;
    let t198 = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (R::literal(3000.0) * stop_gap * stop_rate)
                .add_product(R::literal(1_000_000.0), stop_gap * stop_gap)
                .sub_product(R::literal(1_000_000.0), t197),
        )
        .sub_product(t0, t196)
        .sub_product(t1, t195)
        .sub_product(t0, t194)
        .sub_product(t1, t193);
    let t199 = t149.sub_product(t0, post_omega_dot).sub_product(t23, t198);
    let t200 = t148
        .sub_product(t1, post_omega_dot)
        .add_product(t24, t198)
        .sub_product(t42, t199);
    let t201 = t199.sub_product(t44, t199).sub_product(t50, t200);
    let t202 = t200.sub_product(t52, t200).sub_product(t57, t201);
    let t203 = (-(t59 * t201)).sub_product(t69, t202);
    let t204 = (-(t60 * t201)).sub_product(t71, t202).sub_product(t80, t203);
    let t205 = (t82 * t203).sub_product(t91, t204);
    let t206 = (-(t84 * t203)).sub_product(t93, t204).sub_product(t100, t205);
    let t207 = (-(t101 * t205)).sub_product(t109, t206);
    let t208 = (t102 * t205).sub_product(t111, t206).sub_product(t118, t207);
    let t209 = (-(t63 * t201))
        .sub_product(t74, t202)
        .sub_product(t86, t203)
        .sub_product(t95, t204)
        .sub_product(t104, t205)
        .sub_product(t113, t206)
        .sub_product(t120, t207)
        .sub_product(t125, t208);
    let t210 = (t65 * t201)
        .sub_product(t77, t202)
        .sub_product(t88, t203)
        .sub_product(t97, t204)
        .sub_product(t106, t205)
        .sub_product(t115, t206)
        .sub_product(t122, t207)
        .sub_product(t127, t208)
        .sub_product(t130, t209) * t131;
    let t211 = (t209 * t128).sub_product(t130, t210);
    let t212 = (t208 * t123).sub_product(t125, t211).sub_product(t127, t210);
    let t213 = (t207 * t116)
        .sub_product(t118, t212)
        .sub_product(t120, t211)
        .sub_product(t122, t210);
    let t214 = (t206 * t107)
        .sub_product(t109, t213)
        .sub_product(t111, t212)
        .sub_product(t113, t211)
        .sub_product(t115, t210);
    let t215 = (t205 * t98)
        .sub_product(t100, t214)
        .sub_product(t101, t213)
        .add_product(t102, t212)
        .sub_product(t104, t211)
        .sub_product(t106, t210);
    let t216 = (t204 * t89)
        .sub_product(t91, t215)
        .sub_product(t93, t214)
        .sub_product(t95, t211)
        .sub_product(t97, t210);
    let t217 = (t203 * t78)
        .sub_product(t80, t216)
        .add_product(t82, t215)
        .sub_product(t84, t214)
        .sub_product(t86, t211)
        .sub_product(t88, t210);
    let t218 = (t202 * t67)
        .sub_product(t69, t217)
        .sub_product(t71, t216)
        .sub_product(t74, t211)
        .sub_product(t77, t210);
    let t219 = (t201 * t54)
        .sub_product(t57, t218)
        .sub_product(t59, t217)
        .sub_product(t60, t216)
        .sub_product(t63, t211)
        .add_product(t65, t210);
    let t220 = (t200 * t48).sub_product(t50, t219).sub_product(t52, t218);
    let t221 = (t199 * t40)
        .sub_product(t42, t220)
        .sub_product(t44, t219)
        .sub_product(t42, t218);
    let bobbin_v_y_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t210);
    let bobbin_v_x_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t211);
    let rod_omega_dot_by_post_phi = (t36 * t213)
        .sub_product(R::literal(4_166.666_666_666_667), t215)
        .sub_product(t37, t212);
    let rod_v_y_dot_by_post_phi = (-(R::literal(5.0) * t212)).sub_product(t35, t214);
    let rod_v_x_dot_by_post_phi = (-(R::literal(5.0) * t213)).add_product(t34, t214);
    let cylinder_omega_dot_by_post_phi = (t32 * t216)
        .sub_product(t31, t217)
        .sub_product(R::literal(-2_777.777_777_777_778), t215)
        .add_product(t33, t214);
    let cylinder_v_y_dot_by_post_phi = (t30 * t214)
        .sub_product(R::literal(3.333_333_333_333_333_5), t216);
    let cylinder_v_x_dot_by_post_phi = (-(t29 * t214))
        .sub_product(R::literal(3.333_333_333_333_333_5), t217);
    let plate_omega_dot_by_post_phi = (t26 * t218)
        .sub_product(t25, t219)
        .sub_product(t25, t217)
        .add_product(t26, t216)
        .add_product(t27, t211)
        .sub_product(t28, t210);
    let plate_v_y_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t216))
        .sub_product(R::literal(0.833_333_333_333_333_4), t218)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t210);
    let plate_v_x_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t217))
        .sub_product(R::literal(0.833_333_333_333_333_4), t219)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t211);
    let post_omega_dot_by_post_phi = (t198 * R::literal(370.370_370_370_370_3))
        .sub_product(t23, t221)
        .add_product(t24, t220)
        .sub_product(t23, t219)
        .add_product(t24, t218);
    let post_v_y_dot_by_post_phi = (-(R::literal(-1.25) * t218))
        .sub_product(R::literal(1.25), t220);
    let post_v_x_dot_by_post_phi = (-(R::literal(-1.25) * t219))
        .sub_product(R::literal(1.25), t221);
    let t222 = (-(t3 * t193))
        .sub_product(t2, t194)
        .sub_product(t2, t192)
        .sub_product(t3, t191)
        .sub_product(t21, t186)
        .add_product(t20, t185);
    let t223 = t152.sub_product(t2, plate_omega_dot).sub_product(t25, t222);
    let t224 = (-t151).sub_product(t3, plate_omega_dot).add_product(t26, t222);
    let t225 = t224.sub_product(t57, t223);
    let t226 = t223.sub_product(t59, t223).sub_product(t69, t225);
    let t227 = t224.sub_product(t60, t223).sub_product(t71, t225).sub_product(t80, t226);
    let t228 = (t82 * t226).sub_product(t91, t227);
    let t229 = (-(t84 * t226)).sub_product(t93, t227).sub_product(t100, t228);
    let t230 = (-(t101 * t228)).sub_product(t109, t229);
    let t231 = (t102 * t228).sub_product(t111, t229).sub_product(t118, t230);
    let t232 = ((-t10 - t11) * plate_omega_squared)
        .sub_product(t21, plate_omega_dot)
        .add_product(t27, t222)
        .sub_product(t63, t223)
        .sub_product(t74, t225)
        .sub_product(t86, t226)
        .sub_product(t95, t227)
        .sub_product(t104, t228)
        .sub_product(t113, t229)
        .sub_product(t120, t230)
        .sub_product(t125, t231);
    let t233 = t166
        .add_product(t20, plate_omega_dot)
        .sub_product(t28, t222)
        .add_product(t65, t223)
        .sub_product(t77, t225)
        .sub_product(t88, t226)
        .sub_product(t97, t227)
        .sub_product(t106, t228)
        .sub_product(t115, t229)
        .sub_product(t122, t230)
        .sub_product(t127, t231)
        .sub_product(t130, t232) * t131;
    let t234 = (t232 * t128).sub_product(t130, t233);
    let t235 = (t231 * t123).sub_product(t125, t234).sub_product(t127, t233);
    let t236 = (t230 * t116)
        .sub_product(t118, t235)
        .sub_product(t120, t234)
        .sub_product(t122, t233);
    let t237 = (t229 * t107)
        .sub_product(t109, t236)
        .sub_product(t111, t235)
        .sub_product(t113, t234)
        .sub_product(t115, t233);
    let t238 = (t228 * t98)
        .sub_product(t100, t237)
        .sub_product(t101, t236)
        .add_product(t102, t235)
        .sub_product(t104, t234)
        .sub_product(t106, t233);
    let t239 = (t227 * t89)
        .sub_product(t91, t238)
        .sub_product(t93, t237)
        .sub_product(t95, t234)
        .sub_product(t97, t233);
    let t240 = (t226 * t78)
        .sub_product(t80, t239)
        .add_product(t82, t238)
        .sub_product(t84, t237)
        .sub_product(t86, t234)
        .sub_product(t88, t233);
    let t241 = (t225 * t67)
        .sub_product(t69, t240)
        .sub_product(t71, t239)
        .sub_product(t74, t234)
        .sub_product(t77, t233);
    let t242 = (t223 * t54)
        .sub_product(t57, t241)
        .sub_product(t59, t240)
        .sub_product(t60, t239)
        .sub_product(t63, t234)
        .add_product(t65, t233);
    let t243 = (-(t52 * t241)).sub_product(t50, t242);
    let t244 = (-(t44 * t242)).sub_product(t42, t243).sub_product(t42, t241);
    let bobbin_v_y_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t233);
    let bobbin_v_x_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t234);
    let rod_omega_dot_by_plate_phi = (t36 * t236)
        .sub_product(R::literal(4_166.666_666_666_667), t238)
        .sub_product(t37, t235);
    let rod_v_y_dot_by_plate_phi = (-(R::literal(5.0) * t235)).sub_product(t35, t237);
    let rod_v_x_dot_by_plate_phi = (-(R::literal(5.0) * t236)).add_product(t34, t237);
    let cylinder_omega_dot_by_plate_phi = (t32 * t239)
        .sub_product(t31, t240)
        .sub_product(R::literal(-2_777.777_777_777_778), t238)
        .add_product(t33, t237);
    let cylinder_v_y_dot_by_plate_phi = (t30 * t237)
        .sub_product(R::literal(3.333_333_333_333_333_5), t239);
    let cylinder_v_x_dot_by_plate_phi = (-(t29 * t237))
        .sub_product(R::literal(3.333_333_333_333_333_5), t240);
    let plate_omega_dot_by_plate_phi = (t222 * R::literal(400.0))
        .sub_product(t25, t242)
        .add_product(t26, t241)
        .sub_product(t25, t240)
        .add_product(t26, t239)
        .add_product(t27, t234)
        .sub_product(t28, t233);
    let plate_v_y_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t239))
        .sub_product(R::literal(0.833_333_333_333_333_4), t241)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t233);
    let plate_v_x_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t240))
        .sub_product(R::literal(0.833_333_333_333_333_4), t242)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t234);
    let post_omega_dot_by_plate_phi = (t24 * t243)
        .sub_product(t23, t244)
        .sub_product(t23, t242)
        .add_product(t24, t241);
    let post_v_y_dot_by_plate_phi = (-(R::literal(-1.25) * t241))
        .sub_product(R::literal(1.25), t243);
    let post_v_x_dot_by_plate_phi = (-(R::literal(-1.25) * t242))
        .sub_product(R::literal(1.25), t244);
    let t245 = p.spring_stiffness * cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t246 = spring_damping_times_cylinder_omega * sin_cylinder_phi;
    let t247 = t246 - t245;
    let t248 = t247 * cos_cylinder_phi;
    let t249 = t247 * sin_cylinder_phi;
    let t250 = spring_damping_times_cylinder_omega * t19;
    let t251 = t250 * sin_cylinder_phi;
    let t252 = p.spring_stiffness * t19;
    let t253 = t252 * cos_cylinder_phi;
    let t254 = t245 - t246;
    let t255 = t254 * cos_cylinder_phi;
    let t256 = t254 * sin_cylinder_phi;
    let t257 = cos_cylinder_phi * t189;
    let t258 = t253 - t251 - t138 - t139 - t257;
    let t259 = cos_cylinder_phi * cylinder_omega_dot;
    let t260 = R::literal(3.333_333_333_333_333_5) * t248;
    let t261 = (-t260).sub_product(t31, t258);
    let t262 = R::literal(3.333_333_333_333_333_5) * t249;
    let t263 = (-t262).add_product(t32, t258).sub_product(t80, t261);
    let t264 = (-(R::literal(-2_777.777_777_777_778) * t258))
        .add_product(t82, t261)
        .sub_product(t91, t263);
    let t265 = (t154 - t259)
        .sub_product(t29, t248)
        .add_product(t30, t249)
        .add_product(t33, t258)
        .add_product(t34, t255)
        .sub_product(t35, t256)
        .sub_product(t84, t261)
        .sub_product(t93, t263)
        .sub_product(t100, t264);
    let t266 = R::literal(5.0) * t255;
    let t267 = (-t266).sub_product(t101, t264).sub_product(t109, t265);
    let t268 = R::literal(5.0) * t256;
    let t269 = (-t268)
        .add_product(t102, t264)
        .sub_product(t111, t265)
        .sub_product(t118, t267);
    let t270 = (-(t86 * t261))
        .sub_product(t95, t263)
        .sub_product(t104, t264)
        .sub_product(t113, t265)
        .sub_product(t120, t267)
        .sub_product(t125, t269);
    let t271 = (-(t88 * t261))
        .sub_product(t97, t263)
        .sub_product(t106, t264)
        .sub_product(t115, t265)
        .sub_product(t122, t267)
        .sub_product(t127, t269)
        .sub_product(t130, t270) * t131;
    let t272 = (t270 * t128).sub_product(t130, t271);
    let t273 = (t269 * t123).sub_product(t125, t272).sub_product(t127, t271);
    let t274 = (t267 * t116)
        .sub_product(t118, t273)
        .sub_product(t120, t272)
        .sub_product(t122, t271);
    let t275 = (t265 * t107)
        .sub_product(t109, t274)
        .sub_product(t111, t273)
        .sub_product(t113, t272)
        .sub_product(t115, t271);
    let t276 = (t264 * t98)
        .sub_product(t100, t275)
        .sub_product(t101, t274)
        .add_product(t102, t273)
        .sub_product(t104, t272)
        .sub_product(t106, t271);
    let t277 = (t263 * t89)
        .sub_product(t91, t276)
        .sub_product(t93, t275)
        .sub_product(t95, t272)
        .sub_product(t97, t271);
    let t278 = (t261 * t78)
        .sub_product(t80, t277)
        .add_product(t82, t276)
        .sub_product(t84, t275)
        .sub_product(t86, t272)
        .sub_product(t88, t271);
    let t279 = (-(t71 * t277))
        .sub_product(t69, t278)
        .sub_product(t74, t272)
        .sub_product(t77, t271);
    let t280 = (-(t59 * t278))
        .sub_product(t57, t279)
        .sub_product(t60, t277)
        .sub_product(t63, t272)
        .add_product(t65, t271);
    let t281 = (-(t52 * t279)).sub_product(t50, t280);
    let t282 = (-(t44 * t280)).sub_product(t42, t281).sub_product(t42, t279);
    let bobbin_v_y_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t271);
    let bobbin_v_x_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t272);
    let rod_omega_dot_by_cylinder_x = (t36 * t274)
        .sub_product(R::literal(4_166.666_666_666_667), t276)
        .sub_product(t37, t273);
    let rod_v_y_dot_by_cylinder_x = t268
        .sub_product(t35, t275)
        .sub_product(R::literal(5.0), t273);
    let rod_v_x_dot_by_cylinder_x = t266
        .add_product(t34, t275)
        .sub_product(R::literal(5.0), t274);
    let cylinder_omega_dot_by_cylinder_x = (t258 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t278)
        .add_product(t32, t277)
        .sub_product(R::literal(-2_777.777_777_777_778), t276)
        .add_product(t33, t275);
    let cylinder_v_y_dot_by_cylinder_x = t262
        .sub_product(R::literal(3.333_333_333_333_333_5), t277)
        .add_product(t30, t275);
    let cylinder_v_x_dot_by_cylinder_x = t260
        .sub_product(R::literal(3.333_333_333_333_333_5), t278)
        .sub_product(t29, t275);
    let plate_omega_dot_by_cylinder_x = (t26 * t279)
        .sub_product(t25, t280)
        .sub_product(t25, t278)
        .add_product(t26, t277)
        .add_product(t27, t272)
        .sub_product(t28, t271);
    let plate_v_y_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t277))
        .sub_product(R::literal(0.833_333_333_333_333_4), t279)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t271);
    let plate_v_x_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t278))
        .sub_product(R::literal(0.833_333_333_333_333_4), t280)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t272);
    let post_omega_dot_by_cylinder_x = (t24 * t281)
        .sub_product(t23, t282)
        .sub_product(t23, t280)
        .add_product(t24, t279);
    let post_v_y_dot_by_cylinder_x = (-(R::literal(-1.25) * t279))
        .sub_product(R::literal(1.25), t281);
    let post_v_x_dot_by_cylinder_x = (-(R::literal(-1.25) * t280))
        .sub_product(R::literal(1.25), t282);
    let t283 = (spring_damping_times_cylinder_omega * cos_cylinder_phi)
        .add_product(p.spring_stiffness, sin_cylinder_phi);
    let t284 = t283 * cos_cylinder_phi;
    let t285 = t283 * sin_cylinder_phi;
    let t286 = t250 * cos_cylinder_phi;
    let t287 = t252 * sin_cylinder_phi;
    let t288 = sin_cylinder_phi * t189;
    let t289 = t286 + t135 + t287 + t136 - t288;
    let t290 = sin_cylinder_phi * cylinder_omega_dot;
    let t291 = R::literal(3.333_333_333_333_333_5) * t284;
    let t292 = -t291;
    let t293 = t291.sub_product(t31, t289);
    let t294 = R::literal(3.333_333_333_333_333_5) * t285;
    let t295 = t294.add_product(t32, t289).sub_product(t80, t293);
    let t296 = (-(R::literal(-2_777.777_777_777_778) * t289))
        .add_product(t82, t293)
        .sub_product(t91, t295);
    let t297 = t29 * t284;
    let t298 = t30 * t285;
    let t299 = t34 * t284;
    let t300 = t35 * t285;
    let t301 = ((-t153 - t290 + t297 - t298).add_product(t33, t289) + t299 - t300)
        .sub_product(t84, t293)
        .sub_product(t93, t295)
        .sub_product(t100, t296);
    let t302 = R::literal(5.0) * t284;
    let t303 = (-t302).sub_product(t101, t296).sub_product(t109, t301);
    let t304 = R::literal(5.0) * t285;
    let t305 = (-t304)
        .add_product(t102, t296)
        .sub_product(t111, t301)
        .sub_product(t118, t303);
    let t306 = (-(t86 * t293))
        .sub_product(t95, t295)
        .sub_product(t104, t296)
        .sub_product(t113, t301)
        .sub_product(t120, t303)
        .sub_product(t125, t305);
    let t307 = (-(t88 * t293))
        .sub_product(t97, t295)
        .sub_product(t106, t296)
        .sub_product(t115, t301)
        .sub_product(t122, t303)
        .sub_product(t127, t305)
        .sub_product(t130, t306) * t131;
    let t308 = (t306 * t128).sub_product(t130, t307);
    let t309 = (t305 * t123).sub_product(t125, t308).sub_product(t127, t307);
    let t310 = (t303 * t116)
        .sub_product(t118, t309)
        .sub_product(t120, t308)
        .sub_product(t122, t307);
    let t311 = (t301 * t107)
        .sub_product(t109, t310)
        .sub_product(t111, t309)
        .sub_product(t113, t308)
        .sub_product(t115, t307);
    let t312 = (t296 * t98)
        .sub_product(t100, t311)
        .sub_product(t101, t310)
        .add_product(t102, t309)
        .sub_product(t104, t308)
        .sub_product(t106, t307);
    let t313 = (t295 * t89)
        .sub_product(t91, t312)
        .sub_product(t93, t311)
        .sub_product(t95, t308)
        .sub_product(t97, t307);
    let t314 = (t293 * t78)
        .sub_product(t80, t313)
        .add_product(t82, t312)
        .sub_product(t84, t311)
        .sub_product(t86, t308)
        .sub_product(t88, t307);
    let t315 = (-(t71 * t313))
        .sub_product(t69, t314)
        .sub_product(t74, t308)
        .sub_product(t77, t307);
    let t316 = (-(t59 * t314))
        .sub_product(t57, t315)
        .sub_product(t60, t313)
        .sub_product(t63, t308)
        .add_product(t65, t307);
    let t317 = (-(t52 * t315)).sub_product(t50, t316);
    let t318 = (-(t44 * t316)).sub_product(t42, t317).sub_product(t42, t315);
    let bobbin_v_y_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t307);
    let bobbin_v_x_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t308);
    let rod_omega_dot_by_cylinder_y = (t36 * t310)
        .sub_product(R::literal(4_166.666_666_666_667), t312)
        .sub_product(t37, t309);
    let rod_v_y_dot_by_cylinder_y = t304
        .sub_product(t35, t311)
        .sub_product(R::literal(5.0), t309);
    let rod_v_x_dot_by_cylinder_y = t302
        .add_product(t34, t311)
        .sub_product(R::literal(5.0), t310);
    let cylinder_omega_dot_by_cylinder_y = (t289 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t314)
        .add_product(t32, t313)
        .sub_product(R::literal(-2_777.777_777_777_778), t312)
        .add_product(t33, t311);
    let cylinder_v_y_dot_by_cylinder_y = (-t294)
        .sub_product(R::literal(3.333_333_333_333_333_5), t313)
        .add_product(t30, t311);
    let cylinder_v_x_dot_by_cylinder_y = t292
        .sub_product(R::literal(3.333_333_333_333_333_5), t314)
        .sub_product(t29, t311);
    let plate_omega_dot_by_cylinder_y = (t26 * t315)
        .sub_product(t25, t316)
        .sub_product(t25, t314)
        .add_product(t26, t313)
        .add_product(t27, t308)
        .sub_product(t28, t307);
    let plate_v_y_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t313))
        .sub_product(R::literal(0.833_333_333_333_333_4), t315)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t307);
    let plate_v_x_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t314))
        .sub_product(R::literal(0.833_333_333_333_333_4), t316)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t308);
    let post_omega_dot_by_cylinder_y = (t24 * t317)
        .sub_product(t23, t318)
        .sub_product(t23, t316)
        .add_product(t24, t315);
    let post_v_y_dot_by_cylinder_y = (-(R::literal(-1.25) * t315))
        .sub_product(R::literal(1.25), t317);
    let post_v_x_dot_by_cylinder_y = (-(R::literal(-1.25) * t316))
        .sub_product(R::literal(1.25), t318);
    let t319 = p.spring_damping
        * (rod_v_y_minus_cylinder_v_y * cos_cylinder_phi)
            .sub_product(cylinder_omega, slide)
            .sub_product(rod_v_x_minus_cylinder_v_x, sin_cylinder_phi);
    let t320 = t319 * cos_cylinder_phi;
    let t321 = t319 * sin_cylinder_phi;
    let t322 = t19 * t19;
    let t323 = R::literal(0.06) * cylinder_omega_squared;
    let t324 = t253 + t320 - t138 - t139 - t257;
    let t325 = t136 + t321 - (t142 - t287) - t288;
    let t326 = t17 - t18;
    let t327 = (p.spring_stiffness * slide * t133)
        .add_product(p.spring_damping * slide, slide_rate)
        .sub_product(p.spring_stiffness, t322)
        .sub_product(t319, t19)
        .sub_product(t4, t192)
        .sub_product(t5, t191)
        .sub_product(t326, t189);
    let t328 = t138 + t139 - t253 - t320 + t257;
    let t329 = -t136 - t321 - (t135 + t287) + t288;
    let t330 = R::literal(3.333_333_333_333_333_5) * t324;
    let t331 = ((t323 * sin_cylinder_phi).sub_product(t4, cylinder_omega_dot) - t330)
        .sub_product(t31, t327);
    let t332 = R::literal(3.333_333_333_333_333_5) * t325;
    let t333 = ((-(t323 * cos_cylinder_phi)).sub_product(t5, cylinder_omega_dot) - t332)
        .add_product(t32, t327)
        .sub_product(t80, t331);
    let t334 = (-(R::literal(-2_777.777_777_777_778) * t327))
        .add_product(t82, t331)
        .sub_product(t91, t333);
    let t335 = (cylinder_omega
        * (t155 * sin_cylinder_phi)
            .add_product(t160, cos_cylinder_phi)
            .add_product(cylinder_x_times_cylinder_omega, cos_cylinder_phi)
            .add_product(cylinder_y_times_cylinder_omega, sin_cylinder_phi)
            .sub_product(t156, cos_cylinder_phi)
            .sub_product(t159, sin_cylinder_phi)
            .sub_product(rod_x_times_cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_y_times_cylinder_omega, sin_cylinder_phi))
        .sub_product(cos_cylinder_phi, cylinder_v_x_dot)
        .sub_product(sin_cylinder_phi, cylinder_v_y_dot)
        .sub_product(t326, cylinder_omega_dot)
        .add_product(cos_cylinder_phi, rod_v_x_dot)
        .add_product(sin_cylinder_phi, rod_v_y_dot)
        .sub_product(t29, t324)
        .add_product(t30, t325)
        .add_product(t33, t327)
        .add_product(t34, t328)
        .sub_product(t35, t329)
        .sub_product(t84, t331)
        .sub_product(t93, t333)
        .sub_product(t100, t334);
    let t336 = R::literal(5.0) * t328;
    let t337 = (-t336).sub_product(t101, t334).sub_product(t109, t335);
    let t338 = R::literal(5.0) * t329;
    let t339 = (-t338)
        .add_product(t102, t334)
        .sub_product(t111, t335)
        .sub_product(t118, t337);
    let t340 = (-(t86 * t331))
        .sub_product(t95, t333)
        .sub_product(t104, t334)
        .sub_product(t113, t335)
        .sub_product(t120, t337)
        .sub_product(t125, t339);
    let t341 = (-(t88 * t331))
        .sub_product(t97, t333)
        .sub_product(t106, t334)
        .sub_product(t115, t335)
        .sub_product(t122, t337)
        .sub_product(t127, t339)
        .sub_product(t130, t340) * t131;
    let t342 = (t340 * t128).sub_product(t130, t341);
    let t343 = (t339 * t123).sub_product(t125, t342).sub_product(t127, t341);
    let t344 = (t337 * t116)
        .sub_product(t118, t343)
        .sub_product(t120, t342)
        .sub_product(t122, t341);
    let t345 = (t335 * t107)
        .sub_product(t109, t344)
        .sub_product(t111, t343)
        .sub_product(t113, t342)
        .sub_product(t115, t341);
    let t346 = (t334 * t98)
        .sub_product(t100, t345)
        .sub_product(t101, t344)
        .add_product(t102, t343)
        .sub_product(t104, t342)
        .sub_product(t106, t341);
    let t347 = (t333 * t89)
        .sub_product(t91, t346)
        .sub_product(t93, t345)
        .sub_product(t95, t342)
        .sub_product(t97, t341);
    let t348 = (t331 * t78)
        .sub_product(t80, t347)
        .add_product(t82, t346)
        .sub_product(t84, t345)
        .sub_product(t86, t342)
        .sub_product(t88, t341);
    let t349 = (-(t71 * t347))
        .sub_product(t69, t348)
        .sub_product(t74, t342)
        .sub_product(t77, t341);
    let t350 = (-(t59 * t348))
        .sub_product(t57, t349)
        .sub_product(t60, t347)
        .sub_product(t63, t342)
        .add_product(t65, t341);
    let t351 = (-(t52 * t349)).sub_product(t50, t350);
    let t352 = (-(t44 * t350)).sub_product(t42, t351).sub_product(t42, t349);
    let bobbin_v_y_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t341);
    let bobbin_v_x_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t342);
    let rod_omega_dot_by_cylinder_phi = (t36 * t344)
        .sub_product(R::literal(4_166.666_666_666_667), t346)
        .sub_product(t37, t343);
    let rod_v_y_dot_by_cylinder_phi = t338
        .sub_product(t35, t345)
        .sub_product(R::literal(5.0), t343);
    let rod_v_x_dot_by_cylinder_phi = t336
        .add_product(t34, t345)
        .sub_product(R::literal(5.0), t344);
    let cylinder_omega_dot_by_cylinder_phi = (t327 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t348)
        .add_product(t32, t347)
        .sub_product(R::literal(-2_777.777_777_777_778), t346)
        .add_product(t33, t345);
    let cylinder_v_y_dot_by_cylinder_phi = t332
        .sub_product(R::literal(3.333_333_333_333_333_5), t347)
        .add_product(t30, t345);
    let cylinder_v_x_dot_by_cylinder_phi = t330
        .sub_product(R::literal(3.333_333_333_333_333_5), t348)
        .sub_product(t29, t345);
    let plate_omega_dot_by_cylinder_phi = (t26 * t349)
        .sub_product(t25, t350)
        .sub_product(t25, t348)
        .add_product(t26, t347)
        .add_product(t27, t342)
        .sub_product(t28, t341);
    let plate_v_y_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t347))
        .sub_product(R::literal(0.833_333_333_333_333_4), t349)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t341);
    let plate_v_x_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t348))
        .sub_product(R::literal(0.833_333_333_333_333_4), t350)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t342);
    let post_omega_dot_by_cylinder_phi = (t24 * t351)
        .sub_product(t23, t352)
        .sub_product(t23, t350)
        .add_product(t24, t349);
    let post_v_y_dot_by_cylinder_phi = (-(R::literal(-1.25) * t349))
        .sub_product(R::literal(1.25), t351);
    let post_v_x_dot_by_cylinder_phi = (-(R::literal(-1.25) * t350))
        .sub_product(R::literal(1.25), t352);
    let t353 = t251 + t138 + t139 - t253 + t257;
    let t354 = R::literal(3.333_333_333_333_333_5) * t255;
    let t355 = (-t354).sub_product(t31, t353);
    let t356 = R::literal(3.333_333_333_333_333_5) * t256;
    let t357 = (-t356).add_product(t32, t353).sub_product(t80, t355);
    let t358 = (-(R::literal(-2_777.777_777_777_778) * t353))
        .add_product(t82, t355)
        .sub_product(t91, t357);
    let t359 = (t259 - t154)
        .sub_product(t29, t255)
        .add_product(t30, t256)
        .add_product(t33, t353)
        .add_product(t34, t248)
        .sub_product(t35, t249)
        .sub_product(t84, t355)
        .sub_product(t93, t357)
        .sub_product(t100, t358);
    let t360 = R::literal(5.0) * t248;
    let t361 = (-t360).sub_product(t101, t358).sub_product(t109, t359);
    let t362 = R::literal(5.0) * t249;
    let t363 = (-t362)
        .add_product(t102, t358)
        .sub_product(t111, t359)
        .sub_product(t118, t361);
    let t364 = (-(t86 * t355))
        .sub_product(t95, t357)
        .sub_product(t104, t358)
        .sub_product(t113, t359)
        .sub_product(t120, t361)
        .sub_product(t125, t363);
    let t365 = (-(t88 * t355))
        .sub_product(t97, t357)
        .sub_product(t106, t358)
        .sub_product(t115, t359)
        .sub_product(t122, t361)
        .sub_product(t127, t363)
        .sub_product(t130, t364) * t131;
    let t366 = (t364 * t128).sub_product(t130, t365);
    let t367 = (t363 * t123).sub_product(t125, t366).sub_product(t127, t365);
    let t368 = (t361 * t116)
        .sub_product(t118, t367)
        .sub_product(t120, t366)
        .sub_product(t122, t365);
    let t369 = (t359 * t107)
        .sub_product(t109, t368)
        .sub_product(t111, t367)
        .sub_product(t113, t366)
        .sub_product(t115, t365);
    let t370 = (t358 * t98)
        .sub_product(t100, t369)
        .sub_product(t101, t368)
        .add_product(t102, t367)
        .sub_product(t104, t366)
        .sub_product(t106, t365);
    let t371 = (t357 * t89)
        .sub_product(t91, t370)
        .sub_product(t93, t369)
        .sub_product(t95, t366)
        .sub_product(t97, t365);
    let t372 = (t355 * t78)
        .sub_product(t80, t371)
        .add_product(t82, t370)
        .sub_product(t84, t369)
        .sub_product(t86, t366)
        .sub_product(t88, t365);
    let t373 = (-(t71 * t371))
        .sub_product(t69, t372)
        .sub_product(t74, t366)
        .sub_product(t77, t365);
    let t374 = (-(t59 * t372))
        .sub_product(t57, t373)
        .sub_product(t60, t371)
        .sub_product(t63, t366)
        .add_product(t65, t365);
    let t375 = (-(t52 * t373)).sub_product(t50, t374);
    let t376 = (-(t44 * t374)).sub_product(t42, t375).sub_product(t42, t373);
    let bobbin_v_y_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t365);
    let bobbin_v_x_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t366);
    let rod_omega_dot_by_rod_x = (t36 * t368)
        .sub_product(R::literal(4_166.666_666_666_667), t370)
        .sub_product(t37, t367);
    let rod_v_y_dot_by_rod_x = t362
        .sub_product(t35, t369)
        .sub_product(R::literal(5.0), t367);
    let rod_v_x_dot_by_rod_x = t360
        .add_product(t34, t369)
        .sub_product(R::literal(5.0), t368);
    let cylinder_omega_dot_by_rod_x = (t353 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t372)
        .add_product(t32, t371)
        .sub_product(R::literal(-2_777.777_777_777_778), t370)
        .add_product(t33, t369);
    let cylinder_v_y_dot_by_rod_x = t356
        .sub_product(R::literal(3.333_333_333_333_333_5), t371)
        .add_product(t30, t369);
    let cylinder_v_x_dot_by_rod_x = t354
        .sub_product(R::literal(3.333_333_333_333_333_5), t372)
        .sub_product(t29, t369);
    let plate_omega_dot_by_rod_x = (t26 * t373)
        .sub_product(t25, t374)
        .sub_product(t25, t372)
        .add_product(t26, t371)
        .add_product(t27, t366)
        .sub_product(t28, t365);
    let plate_v_y_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t371))
        .sub_product(R::literal(0.833_333_333_333_333_4), t373)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t365);
    let plate_v_x_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t372))
        .sub_product(R::literal(0.833_333_333_333_333_4), t374)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t366);
    let post_omega_dot_by_rod_x = (t24 * t375)
        .sub_product(t23, t376)
        .sub_product(t23, t374)
        .add_product(t24, t373);
    let post_v_y_dot_by_rod_x = (-(R::literal(-1.25) * t373))
        .sub_product(R::literal(1.25), t375);
    let post_v_x_dot_by_rod_x = (-(R::literal(-1.25) * t374))
        .sub_product(R::literal(1.25), t376);
    let t377 = -t286 - t135 - t287 - t136 + t288;
    let t378 = t292.sub_product(t31, t377);
    let t379 = (-t294).add_product(t32, t377).sub_product(t80, t378);
    let t380 = (-(R::literal(-2_777.777_777_777_778) * t377))
        .add_product(t82, t378)
        .sub_product(t91, t379);
    let t381 = ((t153 + t290 - t297 + t298).add_product(t33, t377) - t299 + t300)
        .sub_product(t84, t378)
        .sub_product(t93, t379)
        .sub_product(t100, t380);
    let t382 = t302.sub_product(t101, t380).sub_product(t109, t381);
    let t383 = t304
        .add_product(t102, t380)
        .sub_product(t111, t381)
        .sub_product(t118, t382);
    let t384 = (-(t86 * t378))
        .sub_product(t95, t379)
        .sub_product(t104, t380)
        .sub_product(t113, t381)
        .sub_product(t120, t382)
        .sub_product(t125, t383);
    let t385 = (-(t88 * t378))
        .sub_product(t97, t379)
        .sub_product(t106, t380)
        .sub_product(t115, t381)
        .sub_product(t122, t382)
        .sub_product(t127, t383)
        .sub_product(t130, t384) * t131;
    let t386 = (t384 * t128).sub_product(t130, t385);
    let t387 = (t383 * t123).sub_product(t125, t386).sub_product(t127, t385);
    let t388 = (t382 * t116)
        .sub_product(t118, t387)
        .sub_product(t120, t386)
        .sub_product(t122, t385);
    let t389 = (t381 * t107)
        .sub_product(t109, t388)
        .sub_product(t111, t387)
        .sub_product(t113, t386)
        .sub_product(t115, t385);
    let t390 = (t380 * t98)
        .sub_product(t100, t389)
        .sub_product(t101, t388)
        .add_product(t102, t387)
        .sub_product(t104, t386)
        .sub_product(t106, t385);
    let t391 = (t379 * t89)
        .sub_product(t91, t390)
        .sub_product(t93, t389)
        .sub_product(t95, t386)
        .sub_product(t97, t385);
    let t392 = (t378 * t78)
        .sub_product(t80, t391)
        .add_product(t82, t390)
        .sub_product(t84, t389)
        .sub_product(t86, t386)
        .sub_product(t88, t385);
    let t393 = (-(t71 * t391))
        .sub_product(t69, t392)
        .sub_product(t74, t386)
        .sub_product(t77, t385);
    let t394 = (-(t59 * t392))
        .sub_product(t57, t393)
        .sub_product(t60, t391)
        .sub_product(t63, t386)
        .add_product(t65, t385);
    let t395 = (-(t52 * t393)).sub_product(t50, t394);
    let t396 = (-(t44 * t394)).sub_product(t42, t395).sub_product(t42, t393);
    let bobbin_v_y_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t385);
    let bobbin_v_x_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t386);
    let rod_omega_dot_by_rod_y = (t36 * t388)
        .sub_product(R::literal(4_166.666_666_666_667), t390)
        .sub_product(t37, t387);
    let rod_v_y_dot_by_rod_y = (-t304)
        .sub_product(t35, t389)
        .sub_product(R::literal(5.0), t387);
    let rod_v_x_dot_by_rod_y = (-t302)
        .add_product(t34, t389)
        .sub_product(R::literal(5.0), t388);
    let cylinder_omega_dot_by_rod_y = (t377 * R::literal(2_777.777_777_777_778))
        .sub_product(t31, t392)
        .add_product(t32, t391)
        .sub_product(R::literal(-2_777.777_777_777_778), t390)
        .add_product(t33, t389);
    let cylinder_v_y_dot_by_rod_y = t294
        .sub_product(R::literal(3.333_333_333_333_333_5), t391)
        .add_product(t30, t389);
    let cylinder_v_x_dot_by_rod_y = t291
        .sub_product(R::literal(3.333_333_333_333_333_5), t392)
        .sub_product(t29, t389);
    let plate_omega_dot_by_rod_y = (t26 * t393)
        .sub_product(t25, t394)
        .sub_product(t25, t392)
        .add_product(t26, t391)
        .add_product(t27, t386)
        .sub_product(t28, t385);
    let plate_v_y_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t391))
        .sub_product(R::literal(0.833_333_333_333_333_4), t393)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t385);
    let plate_v_x_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t392))
        .sub_product(R::literal(0.833_333_333_333_333_4), t394)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t386);
    let post_omega_dot_by_rod_y = (t24 * t395)
        .sub_product(t23, t396)
        .sub_product(t23, t394)
        .add_product(t24, t393);
    let post_v_y_dot_by_rod_y = (-(R::literal(-1.25) * t393))
        .sub_product(R::literal(1.25), t395);
    let post_v_x_dot_by_rod_y = (-(R::literal(-1.25) * t394))
        .sub_product(R::literal(1.25), t396);
    let t397 = (t7 * t187).add_product(t6, t188);
    let t398 = R::literal(4_166.666_666_666_667) * t397;
    let t399 = t100 * t398;
    let t400 = (-t165)
        .add_product(t6, rod_omega_dot)
        .add_product(t36, t397)
        .add_product(t101, t398)
        .sub_product(t109, t399);
    let t401 = t164
        .add_product(t7, rod_omega_dot)
        .sub_product(t37, t397)
        .sub_product(t102, t398)
        .sub_product(t111, t399)
        .sub_product(t118, t400);
    let t402 = (t104 * t398)
        .sub_product(t113, t399)
        .sub_product(t120, t400)
        .sub_product(t125, t401);
    let t403 = (t106 * t398)
        .sub_product(t115, t399)
        .sub_product(t122, t400)
        .sub_product(t127, t401)
        .sub_product(t130, t402) * t131;
    let t404 = (t402 * t128).sub_product(t130, t403);
    let t405 = (t401 * t123).sub_product(t125, t404).sub_product(t127, t403);
    let t406 = (t400 * t116)
        .sub_product(t118, t405)
        .sub_product(t120, t404)
        .sub_product(t122, t403);
    let t407 = (t399 * t107)
        .sub_product(t109, t406)
        .sub_product(t111, t405)
        .sub_product(t113, t404)
        .sub_product(t115, t403);
    let t408 = (-(t398 * t98))
        .sub_product(t100, t407)
        .sub_product(t101, t406)
        .add_product(t102, t405)
        .sub_product(t104, t404)
        .sub_product(t106, t403);
    let t409 = (-(t93 * t407))
        .sub_product(t91, t408)
        .sub_product(t95, t404)
        .sub_product(t97, t403);
    let t410 = (t82 * t408)
        .sub_product(t80, t409)
        .sub_product(t84, t407)
        .sub_product(t86, t404)
        .sub_product(t88, t403);
    let t411 = (-(t71 * t409))
        .sub_product(t69, t410)
        .sub_product(t74, t404)
        .sub_product(t77, t403);
    let t412 = (-(t59 * t410))
        .sub_product(t57, t411)
        .sub_product(t60, t409)
        .sub_product(t63, t404)
        .add_product(t65, t403);
    let t413 = (-(t52 * t411)).sub_product(t50, t412);
    let t414 = (-(t44 * t412)).sub_product(t42, t413).sub_product(t42, t411);
    let bobbin_v_y_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t403);
    let bobbin_v_x_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t404);
    let rod_omega_dot_by_rod_phi = t398
        .sub_product(R::literal(4_166.666_666_666_667), t408)
        .add_product(t36, t406)
        .sub_product(t37, t405);
    let rod_v_y_dot_by_rod_phi = (-(R::literal(5.0) * t405)).sub_product(t35, t407);
    let rod_v_x_dot_by_rod_phi = (-(R::literal(5.0) * t406)).add_product(t34, t407);
    let cylinder_omega_dot_by_rod_phi = (t32 * t409)
        .sub_product(t31, t410)
        .sub_product(R::literal(-2_777.777_777_777_778), t408)
        .add_product(t33, t407);
    let cylinder_v_y_dot_by_rod_phi = (t30 * t407)
        .sub_product(R::literal(3.333_333_333_333_333_5), t409);
    let cylinder_v_x_dot_by_rod_phi = (-(t29 * t407))
        .sub_product(R::literal(3.333_333_333_333_333_5), t410);
    let plate_omega_dot_by_rod_phi = (t26 * t411)
        .sub_product(t25, t412)
        .sub_product(t25, t410)
        .add_product(t26, t409)
        .add_product(t27, t404)
        .sub_product(t28, t403);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t409))
        .sub_product(R::literal(0.833_333_333_333_333_4), t411)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t403);
    let plate_v_x_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t410))
        .sub_product(R::literal(0.833_333_333_333_333_4), t412)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t404);
    let post_omega_dot_by_rod_phi = (t24 * t413)
        .sub_product(t23, t414)
        .sub_product(t23, t412)
        .add_product(t24, t411);
    let post_v_y_dot_by_rod_phi = (-(R::literal(-1.25) * t411))
        .sub_product(R::literal(1.25), t413);
    let post_v_x_dot_by_rod_phi = (-(R::literal(-1.25) * t412))
        .sub_product(R::literal(1.25), t414);
    let between_squared = between * between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t415 = contact_stiffness_times_contact_gap / between;
    let t416 = contact_damping_times_contact_rate / between;
    let between_squared_times_between = between_squared * between;
    let t417 = c.t0 * contact_rate;
    let t418 = t417 * t13 * t15 / between_squared_times_between;
    let t419 = t145 * t15 / between_squared_times_between;
    let t420 = p.contact_stiffness * t13 * t15 / between_squared;
    let t421 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t417 * t14 / between_squared_times_between
                + contact_stiffness_times_contact_gap * t14
                    / between_squared_times_between
                - contact_damping_times_bobbin_v_x * t13 / between_squared - t415
                - p.contact_stiffness * t14 / between_squared - t416,
        );
    let t422 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t418 - contact_damping_times_bobbin_v_x * t15 / between_squared
                - (t420 - t419),
        );
    let t423 = (-t422).add_product(t130, t421) * t131;
    let t424 = (-(t421 * t128)).sub_product(t130, t423);
    let t425 = (-(t127 * t423)).sub_product(t125, t424);
    let t426 = (-(t120 * t424)).sub_product(t118, t425).sub_product(t122, t423);
    let t427 = (-(t111 * t425))
        .sub_product(t109, t426)
        .sub_product(t113, t424)
        .sub_product(t115, t423);
    let t428 = (-(t101 * t426))
        .sub_product(t100, t427)
        .add_product(t102, t425)
        .sub_product(t104, t424)
        .sub_product(t106, t423);
    let t429 = (-(t93 * t427))
        .sub_product(t91, t428)
        .sub_product(t95, t424)
        .sub_product(t97, t423);
    let t430 = (t82 * t428)
        .sub_product(t80, t429)
        .sub_product(t84, t427)
        .sub_product(t86, t424)
        .sub_product(t88, t423);
    let t431 = (-(t71 * t429))
        .sub_product(t69, t430)
        .sub_product(t74, t424)
        .sub_product(t77, t423);
    let t432 = (-(t59 * t430))
        .sub_product(t57, t431)
        .sub_product(t60, t429)
        .sub_product(t63, t424)
        .add_product(t65, t423);
    let t433 = (-(t52 * t431)).sub_product(t50, t432);
    let t434 = (-(t44 * t432)).sub_product(t42, t433).sub_product(t42, t431);
    let bobbin_v_y_dot_by_bobbin_x = t422
        .sub_product(R::literal(1.428_571_428_571_428_6), t423);
    let bobbin_v_x_dot_by_bobbin_x = t421
        .sub_product(R::literal(1.428_571_428_571_428_6), t424);
    let rod_omega_dot_by_bobbin_x = (t36 * t426)
        .sub_product(R::literal(4_166.666_666_666_667), t428)
        .sub_product(t37, t425);
    let rod_v_y_dot_by_bobbin_x = (-(R::literal(5.0) * t425)).sub_product(t35, t427);
    let rod_v_x_dot_by_bobbin_x = (-(R::literal(5.0) * t426)).add_product(t34, t427);
    let cylinder_omega_dot_by_bobbin_x = (t32 * t429)
        .sub_product(t31, t430)
        .sub_product(R::literal(-2_777.777_777_777_778), t428)
        .add_product(t33, t427);
    let cylinder_v_y_dot_by_bobbin_x = (t30 * t427)
        .sub_product(R::literal(3.333_333_333_333_333_5), t429);
    let cylinder_v_x_dot_by_bobbin_x = (-(t29 * t427))
        .sub_product(R::literal(3.333_333_333_333_333_5), t430);
    let plate_omega_dot_by_bobbin_x = (t26 * t431)
        .sub_product(t25, t432)
        .sub_product(t25, t430)
        .add_product(t26, t429)
        .add_product(t27, t424)
        .sub_product(t28, t423);
    let plate_v_y_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t429))
        .sub_product(R::literal(0.833_333_333_333_333_4), t431)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t423);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t430))
        .sub_product(R::literal(0.833_333_333_333_333_4), t432)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t424);
    let post_omega_dot_by_bobbin_x = (t24 * t433)
        .sub_product(t23, t434)
        .sub_product(t23, t432)
        .add_product(t24, t431);
    let post_v_y_dot_by_bobbin_x = (-(R::literal(-1.25) * t431))
        .sub_product(R::literal(1.25), t433);
    let post_v_x_dot_by_bobbin_x = (-(R::literal(-1.25) * t432))
        .sub_product(R::literal(1.25), t434);
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t435 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t418 + t419 - contact_damping_times_bobbin_v_y * t13 / between_squared - t420,
        );
    let t436 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t417 * t16 / between_squared_times_between
                - contact_damping_times_bobbin_v_y * t15 / between_squared - t416
                - (t415 + p.contact_stiffness * t16 / between_squared
                    - contact_stiffness_times_contact_gap * t16
                        / between_squared_times_between),
        );
    let t437 = (-t436).add_product(t130, t435) * t131;
    let t438 = (-(t435 * t128)).sub_product(t130, t437);
    let t439 = (-(t127 * t437)).sub_product(t125, t438);
    let t440 = (-(t120 * t438)).sub_product(t118, t439).sub_product(t122, t437);
    let t441 = (-(t111 * t439))
        .sub_product(t109, t440)
        .sub_product(t113, t438)
        .sub_product(t115, t437);
    let t442 = (-(t101 * t440))
        .sub_product(t100, t441)
        .add_product(t102, t439)
        .sub_product(t104, t438)
        .sub_product(t106, t437);
    let t443 = (-(t93 * t441))
        .sub_product(t91, t442)
        .sub_product(t95, t438)
        .sub_product(t97, t437);
    let t444 = (t82 * t442)
        .sub_product(t80, t443)
        .sub_product(t84, t441)
        .sub_product(t86, t438)
        .sub_product(t88, t437);
    let t445 = (-(t71 * t443))
        .sub_product(t69, t444)
        .sub_product(t74, t438)
        .sub_product(t77, t437);
    let t446 = (-(t59 * t444))
        .sub_product(t57, t445)
        .sub_product(t60, t443)
        .sub_product(t63, t438)
        .add_product(t65, t437);
    let t447 = (-(t52 * t445)).sub_product(t50, t446);
    let t448 = (-(t44 * t446)).sub_product(t42, t447).sub_product(t42, t445);
    let bobbin_v_y_dot_by_bobbin_y = t436
        .sub_product(R::literal(1.428_571_428_571_428_6), t437);
    let bobbin_v_x_dot_by_bobbin_y = t435
        .sub_product(R::literal(1.428_571_428_571_428_6), t438);
    let rod_omega_dot_by_bobbin_y = (t36 * t440)
        .sub_product(R::literal(4_166.666_666_666_667), t442)
        .sub_product(t37, t439);
    let rod_v_y_dot_by_bobbin_y = (-(R::literal(5.0) * t439)).sub_product(t35, t441);
    let rod_v_x_dot_by_bobbin_y = (-(R::literal(5.0) * t440)).add_product(t34, t441);
    let cylinder_omega_dot_by_bobbin_y = (t32 * t443)
        .sub_product(t31, t444)
        .sub_product(R::literal(-2_777.777_777_777_778), t442)
        .add_product(t33, t441);
    let cylinder_v_y_dot_by_bobbin_y = (t30 * t441)
        .sub_product(R::literal(3.333_333_333_333_333_5), t443);
    let cylinder_v_x_dot_by_bobbin_y = (-(t29 * t441))
        .sub_product(R::literal(3.333_333_333_333_333_5), t444);
    let plate_omega_dot_by_bobbin_y = (t26 * t445)
        .sub_product(t25, t446)
        .sub_product(t25, t444)
        .add_product(t26, t443)
        .add_product(t27, t438)
        .sub_product(t28, t437);
    let plate_v_y_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t443))
        .sub_product(R::literal(0.833_333_333_333_333_4), t445)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t437);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t444))
        .sub_product(R::literal(0.833_333_333_333_333_4), t446)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t438);
    let post_omega_dot_by_bobbin_y = (t24 * t447)
        .sub_product(t23, t448)
        .sub_product(t23, t446)
        .add_product(t24, t445);
    let post_v_y_dot_by_bobbin_y = (-(R::literal(-1.25) * t445))
        .sub_product(R::literal(1.25), t447);
    let post_v_x_dot_by_bobbin_y = (-(R::literal(-1.25) * t446))
        .sub_product(R::literal(1.25), t448);
    let t449 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1500.0) * t197),
    );
    let t450 = R::literal(0.2) * post_omega;
    let t451 = (-(t450 * cos_post_phi)).sub_product(t23, t449);
    let t452 = (-(t450 * sin_post_phi)).add_product(t24, t449).sub_product(t42, t451);
    let t453 = t451.sub_product(t44, t451).sub_product(t50, t452);
    let t454 = t452.sub_product(t52, t452).sub_product(t57, t453);
    let t455 = (-(t59 * t453)).sub_product(t69, t454);
    let t456 = (-(t60 * t453)).sub_product(t71, t454).sub_product(t80, t455);
    let t457 = (t82 * t455).sub_product(t91, t456);
    let t458 = (-(t84 * t455)).sub_product(t93, t456).sub_product(t100, t457);
    let t459 = (-(t101 * t457)).sub_product(t109, t458);
    let t460 = (t102 * t457).sub_product(t111, t458).sub_product(t118, t459);
    let t461 = (-(t63 * t453))
        .sub_product(t74, t454)
        .sub_product(t86, t455)
        .sub_product(t95, t456)
        .sub_product(t104, t457)
        .sub_product(t113, t458)
        .sub_product(t120, t459)
        .sub_product(t125, t460);
    let t462 = (t65 * t453)
        .sub_product(t77, t454)
        .sub_product(t88, t455)
        .sub_product(t97, t456)
        .sub_product(t106, t457)
        .sub_product(t115, t458)
        .sub_product(t122, t459)
        .sub_product(t127, t460)
        .sub_product(t130, t461) * t131;
    let t463 = (t461 * t128).sub_product(t130, t462);
    let t464 = (t460 * t123).sub_product(t125, t463).sub_product(t127, t462);
    let t465 = (t459 * t116)
        .sub_product(t118, t464)
        .sub_product(t120, t463)
        .sub_product(t122, t462);
    let t466 = (t458 * t107)
        .sub_product(t109, t465)
        .sub_product(t111, t464)
        .sub_product(t113, t463)
        .sub_product(t115, t462);
    let t467 = (t457 * t98)
        .sub_product(t100, t466)
        .sub_product(t101, t465)
        .add_product(t102, t464)
        .sub_product(t104, t463)
        .sub_product(t106, t462);
    let t468 = (t456 * t89)
        .sub_product(t91, t467)
        .sub_product(t93, t466)
        .sub_product(t95, t463)
        .sub_product(t97, t462);
    let t469 = (t455 * t78)
        .sub_product(t80, t468)
        .add_product(t82, t467)
        .sub_product(t84, t466)
        .sub_product(t86, t463)
        .sub_product(t88, t462);
    let t470 = (t454 * t67)
        .sub_product(t69, t469)
        .sub_product(t71, t468)
        .sub_product(t74, t463)
        .sub_product(t77, t462);
    let t471 = (t453 * t54)
        .sub_product(t57, t470)
        .sub_product(t59, t469)
        .sub_product(t60, t468)
        .sub_product(t63, t463)
        .add_product(t65, t462);
    let t472 = (t452 * t48).sub_product(t50, t471).sub_product(t52, t470);
    let t473 = (t451 * t40)
        .sub_product(t42, t472)
        .sub_product(t44, t471)
        .sub_product(t42, t470);
    let bobbin_v_y_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t462);
    let bobbin_v_x_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t463);
    let rod_omega_dot_by_post_omega = (t36 * t465)
        .sub_product(R::literal(4_166.666_666_666_667), t467)
        .sub_product(t37, t464);
    let rod_v_y_dot_by_post_omega = (-(R::literal(5.0) * t464)).sub_product(t35, t466);
    let rod_v_x_dot_by_post_omega = (-(R::literal(5.0) * t465)).add_product(t34, t466);
    let cylinder_omega_dot_by_post_omega = (t32 * t468)
        .sub_product(t31, t469)
        .sub_product(R::literal(-2_777.777_777_777_778), t467)
        .add_product(t33, t466);
    let cylinder_v_y_dot_by_post_omega = (t30 * t466)
        .sub_product(R::literal(3.333_333_333_333_333_5), t468);
    let cylinder_v_x_dot_by_post_omega = (-(t29 * t466))
        .sub_product(R::literal(3.333_333_333_333_333_5), t469);
    let plate_omega_dot_by_post_omega = (t26 * t470)
        .sub_product(t25, t471)
        .sub_product(t25, t469)
        .add_product(t26, t468)
        .add_product(t27, t463)
        .sub_product(t28, t462);
    let plate_v_y_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t468))
        .sub_product(R::literal(0.833_333_333_333_333_4), t470)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t462);
    let plate_v_x_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t469))
        .sub_product(R::literal(0.833_333_333_333_333_4), t471)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t463);
    let post_omega_dot_by_post_omega = (t449 * R::literal(370.370_370_370_370_3))
        .sub_product(t23, t473)
        .add_product(t24, t472)
        .sub_product(t23, t471)
        .add_product(t24, t470);
    let post_v_y_dot_by_post_omega = (-(R::literal(-1.25) * t470))
        .sub_product(R::literal(1.25), t472);
    let post_v_x_dot_by_post_omega = (-(R::literal(-1.25) * t471))
        .sub_product(R::literal(1.25), t473);
    let t474 = R::literal(0.12) * plate_omega;
    let t475 = t474 * cos_plate_phi;
    let t476 = t474 * sin_plate_phi;
    let t477 = (-t476).add_product(t57, t475);
    let t478 = (-t475).add_product(t59, t475).sub_product(t69, t477);
    let t479 = (-t476)
        .add_product(t60, t475)
        .sub_product(t71, t477)
        .sub_product(t80, t478);
    let t480 = (t82 * t478).sub_product(t91, t479);
    let t481 = (-(t84 * t478)).sub_product(t93, t479).sub_product(t100, t480);
    let t482 = (-(t101 * t480)).sub_product(t109, t481);
    let t483 = (t102 * t480).sub_product(t111, t481).sub_product(t118, t482);
    let t484 = (plate_omega
        * (R::literal(0.02) * cos_plate_phi).sub_product(R::literal(0.2), sin_plate_phi))
        .add_product(t63, t475)
        .sub_product(t74, t477)
        .sub_product(t86, t478)
        .sub_product(t95, t479)
        .sub_product(t104, t480)
        .sub_product(t113, t481)
        .sub_product(t120, t482)
        .sub_product(t125, t483);
    let t485 = (plate_omega
        * (R::literal(0.02) * sin_plate_phi).add_product(R::literal(0.2), cos_plate_phi))
        .sub_product(t65, t475)
        .sub_product(t77, t477)
        .sub_product(t88, t478)
        .sub_product(t97, t479)
        .sub_product(t106, t480)
        .sub_product(t115, t481)
        .sub_product(t122, t482)
        .sub_product(t127, t483)
        .sub_product(t130, t484) * t131;
    let t486 = (t484 * t128).sub_product(t130, t485);
    let t487 = (t483 * t123).sub_product(t125, t486).sub_product(t127, t485);
    let t488 = (t482 * t116)
        .sub_product(t118, t487)
        .sub_product(t120, t486)
        .sub_product(t122, t485);
    let t489 = (t481 * t107)
        .sub_product(t109, t488)
        .sub_product(t111, t487)
        .sub_product(t113, t486)
        .sub_product(t115, t485);
    let t490 = (t480 * t98)
        .sub_product(t100, t489)
        .sub_product(t101, t488)
        .add_product(t102, t487)
        .sub_product(t104, t486)
        .sub_product(t106, t485);
    let t491 = (t479 * t89)
        .sub_product(t91, t490)
        .sub_product(t93, t489)
        .sub_product(t95, t486)
        .sub_product(t97, t485);
    let t492 = (t478 * t78)
        .sub_product(t80, t491)
        .add_product(t82, t490)
        .sub_product(t84, t489)
        .sub_product(t86, t486)
        .sub_product(t88, t485);
    let t493 = (t477 * t67)
        .sub_product(t69, t492)
        .sub_product(t71, t491)
        .sub_product(t74, t486)
        .sub_product(t77, t485);
    let t494 = (-(t475 * t54))
        .sub_product(t57, t493)
        .sub_product(t59, t492)
        .sub_product(t60, t491)
        .sub_product(t63, t486)
        .add_product(t65, t485);
    let t495 = (-(t52 * t493)).sub_product(t50, t494);
    let t496 = (-(t44 * t494)).sub_product(t42, t495).sub_product(t42, t493);
    let bobbin_v_y_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t485);
    let bobbin_v_x_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t486);
    let rod_omega_dot_by_plate_omega = (t36 * t488)
        .sub_product(R::literal(4_166.666_666_666_667), t490)
        .sub_product(t37, t487);
    let rod_v_y_dot_by_plate_omega = (-(R::literal(5.0) * t487)).sub_product(t35, t489);
    let rod_v_x_dot_by_plate_omega = (-(R::literal(5.0) * t488)).add_product(t34, t489);
    let cylinder_omega_dot_by_plate_omega = (t32 * t491)
        .sub_product(t31, t492)
        .sub_product(R::literal(-2_777.777_777_777_778), t490)
        .add_product(t33, t489);
    let cylinder_v_y_dot_by_plate_omega = (t30 * t489)
        .sub_product(R::literal(3.333_333_333_333_333_5), t491);
    let cylinder_v_x_dot_by_plate_omega = (-(t29 * t489))
        .sub_product(R::literal(3.333_333_333_333_333_5), t492);
    let plate_omega_dot_by_plate_omega = (t26 * t493)
        .sub_product(t25, t494)
        .sub_product(t25, t492)
        .add_product(t26, t491)
        .add_product(t27, t486)
        .sub_product(t28, t485);
    let plate_v_y_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t491))
        .sub_product(R::literal(0.833_333_333_333_333_4), t493)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t485);
    let plate_v_x_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t492))
        .sub_product(R::literal(0.833_333_333_333_333_4), t494)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t486);
    let post_omega_dot_by_plate_omega = (t24 * t495)
        .sub_product(t23, t496)
        .sub_product(t23, t494)
        .add_product(t24, t493);
    let post_v_y_dot_by_plate_omega = (-(R::literal(-1.25) * t493))
        .sub_product(R::literal(1.25), t495);
    let post_v_x_dot_by_plate_omega = (-(R::literal(-1.25) * t494))
        .sub_product(R::literal(1.25), t496);
    let t497 = p.spring_damping * (cos_cylinder_phi * cos_cylinder_phi);
    let t498 = p.spring_damping * sin_cylinder_phi * cos_cylinder_phi;
    let t499 = p.spring_damping * t19;
    let t500 = t499 * cos_cylinder_phi;
    let t501 = R::literal(2.0) * cylinder_omega;
    let t502 = t501 * cos_cylinder_phi;
    let t503 = R::literal(3.333_333_333_333_333_5) * t497;
    let t504 = t31 * t500;
    let t505 = t503 - t504;
    let t506 = R::literal(3.333_333_333_333_333_5) * t498;
    let t507 = -t506;
    let t508 = t32 * t500;
    let t509 = (t506 + t508).sub_product(t80, t505);
    let t510 = R::literal(-2_777.777_777_777_778) * t500;
    let t511 = (-t510).add_product(t82, t505).sub_product(t91, t509);
    let t512 = t29 * t497;
    let t513 = t30 * t498;
    let t514 = t33 * t500;
    let t515 = t34 * t497;
    let t516 = t35 * t498;
    let t517 = (t512 - t502 - t513 + t514 + t515 - t516)
        .sub_product(t84, t505)
        .sub_product(t93, t509)
        .sub_product(t100, t511);
    let t518 = R::literal(5.0) * t497;
    let t519 = (-t518).sub_product(t101, t511).sub_product(t109, t517);
    let t520 = R::literal(5.0) * t498;
    let t521 = -t520;
    let t522 = (-t520)
        .add_product(t102, t511)
        .sub_product(t111, t517)
        .sub_product(t118, t519);
    let t523 = (-(t86 * t505))
        .sub_product(t95, t509)
        .sub_product(t104, t511)
        .sub_product(t113, t517)
        .sub_product(t120, t519)
        .sub_product(t125, t522);
    let t524 = t500 * R::literal(2_777.777_777_777_778);
    let t525 = (-(t88 * t505))
        .sub_product(t97, t509)
        .sub_product(t106, t511)
        .sub_product(t115, t517)
        .sub_product(t122, t519)
        .sub_product(t127, t522)
        .sub_product(t130, t523) * t131;
    let t526 = (t523 * t128).sub_product(t130, t525);
    let t527 = (t522 * t123).sub_product(t125, t526).sub_product(t127, t525);
    let t528 = (t519 * t116)
        .sub_product(t118, t527)
        .sub_product(t120, t526)
        .sub_product(t122, t525);
    let t529 = (t517 * t107)
        .sub_product(t109, t528)
        .sub_product(t111, t527)
        .sub_product(t113, t526)
        .sub_product(t115, t525);
    let t530 = (t511 * t98)
        .sub_product(t100, t529)
        .sub_product(t101, t528)
        .add_product(t102, t527)
        .sub_product(t104, t526)
        .sub_product(t106, t525);
    let t531 = (t509 * t89)
        .sub_product(t91, t530)
        .sub_product(t93, t529)
        .sub_product(t95, t526)
        .sub_product(t97, t525);
    let t532 = (t505 * t78)
        .sub_product(t80, t531)
        .add_product(t82, t530)
        .sub_product(t84, t529)
        .sub_product(t86, t526)
        .sub_product(t88, t525);
    let t533 = (-(t71 * t531))
        .sub_product(t69, t532)
        .sub_product(t74, t526)
        .sub_product(t77, t525);
    let t534 = (-(t59 * t532))
        .sub_product(t57, t533)
        .sub_product(t60, t531)
        .sub_product(t63, t526)
        .add_product(t65, t525);
    let t535 = (-(t52 * t533)).sub_product(t50, t534);
    let t536 = (-(t44 * t534)).sub_product(t42, t535).sub_product(t42, t533);
    let bobbin_v_y_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t525);
    let bobbin_v_x_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t526);
    let rod_omega_dot_by_cylinder_v_x = (t36 * t528)
        .sub_product(R::literal(4_166.666_666_666_667), t530)
        .sub_product(t37, t527);
    let rod_v_y_dot_by_cylinder_v_x = t520
        .sub_product(t35, t529)
        .sub_product(R::literal(5.0), t527);
    let rod_v_x_dot_by_cylinder_v_x = t518
        .add_product(t34, t529)
        .sub_product(R::literal(5.0), t528);
    let cylinder_omega_dot_by_cylinder_v_x = t524
        .sub_product(t31, t532)
        .add_product(t32, t531)
        .sub_product(R::literal(-2_777.777_777_777_778), t530)
        .add_product(t33, t529);
    let cylinder_v_y_dot_by_cylinder_v_x = t507
        .sub_product(R::literal(3.333_333_333_333_333_5), t531)
        .add_product(t30, t529);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t503)
        .sub_product(R::literal(3.333_333_333_333_333_5), t532)
        .sub_product(t29, t529);
    let plate_omega_dot_by_cylinder_v_x = (t26 * t533)
        .sub_product(t25, t534)
        .sub_product(t25, t532)
        .add_product(t26, t531)
        .add_product(t27, t526)
        .sub_product(t28, t525);
    let plate_v_y_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t531))
        .sub_product(R::literal(0.833_333_333_333_333_4), t533)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t525);
    let plate_v_x_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t532))
        .sub_product(R::literal(0.833_333_333_333_333_4), t534)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t526);
    let post_omega_dot_by_cylinder_v_x = (t24 * t535)
        .sub_product(t23, t536)
        .sub_product(t23, t534)
        .add_product(t24, t533);
    let post_v_y_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t533))
        .sub_product(R::literal(1.25), t535);
    let post_v_x_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t534))
        .sub_product(R::literal(1.25), t536);
    let t537 = p.spring_damping * (sin_cylinder_phi * sin_cylinder_phi);
    let t538 = t499 * sin_cylinder_phi;
    let t539 = t501 * sin_cylinder_phi;
    let t540 = t31 * t538;
    let t541 = t506 - t540;
    let t542 = R::literal(3.333_333_333_333_333_5) * t537;
    let t543 = -t542;
    let t544 = t32 * t538;
    let t545 = (t542 + t544).sub_product(t80, t541);
    let t546 = R::literal(-2_777.777_777_777_778) * t538;
    let t547 = (-t546).add_product(t82, t541).sub_product(t91, t545);
    let t548 = t29 * t498;
    let t549 = t30 * t537;
    let t550 = t33 * t538;
    let t551 = t34 * t498;
    let t552 = t35 * t537;
    let t553 = (t548 - t539 - t549 + t550 + t551 - t552)
        .sub_product(t84, t541)
        .sub_product(t93, t545)
        .sub_product(t100, t547);
    let t554 = t521.sub_product(t101, t547).sub_product(t109, t553);
    let t555 = R::literal(5.0) * t537;
    let t556 = (-t555)
        .add_product(t102, t547)
        .sub_product(t111, t553)
        .sub_product(t118, t554);
    let t557 = (-(t86 * t541))
        .sub_product(t95, t545)
        .sub_product(t104, t547)
        .sub_product(t113, t553)
        .sub_product(t120, t554)
        .sub_product(t125, t556);
    let t558 = t538 * R::literal(2_777.777_777_777_778);
    let t559 = (-(t88 * t541))
        .sub_product(t97, t545)
        .sub_product(t106, t547)
        .sub_product(t115, t553)
        .sub_product(t122, t554)
        .sub_product(t127, t556)
        .sub_product(t130, t557) * t131;
    let t560 = (t557 * t128).sub_product(t130, t559);
    let t561 = (t556 * t123).sub_product(t125, t560).sub_product(t127, t559);
    let t562 = (t554 * t116)
        .sub_product(t118, t561)
        .sub_product(t120, t560)
        .sub_product(t122, t559);
    let t563 = (t553 * t107)
        .sub_product(t109, t562)
        .sub_product(t111, t561)
        .sub_product(t113, t560)
        .sub_product(t115, t559);
    let t564 = (t547 * t98)
        .sub_product(t100, t563)
        .sub_product(t101, t562)
        .add_product(t102, t561)
        .sub_product(t104, t560)
        .sub_product(t106, t559);
    let t565 = (t545 * t89)
        .sub_product(t91, t564)
        .sub_product(t93, t563)
        .sub_product(t95, t560)
        .sub_product(t97, t559);
    let t566 = (t541 * t78)
        .sub_product(t80, t565)
        .add_product(t82, t564)
        .sub_product(t84, t563)
        .sub_product(t86, t560)
        .sub_product(t88, t559);
    let t567 = (-(t71 * t565))
        .sub_product(t69, t566)
        .sub_product(t74, t560)
        .sub_product(t77, t559);
    let t568 = (-(t59 * t566))
        .sub_product(t57, t567)
        .sub_product(t60, t565)
        .sub_product(t63, t560)
        .add_product(t65, t559);
    let t569 = (-(t52 * t567)).sub_product(t50, t568);
    let t570 = (-(t44 * t568)).sub_product(t42, t569).sub_product(t42, t567);
    let bobbin_v_y_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t559);
    let bobbin_v_x_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t560);
    let rod_omega_dot_by_cylinder_v_y = (t36 * t562)
        .sub_product(R::literal(4_166.666_666_666_667), t564)
        .sub_product(t37, t561);
    let rod_v_y_dot_by_cylinder_v_y = t555
        .sub_product(t35, t563)
        .sub_product(R::literal(5.0), t561);
    let rod_v_x_dot_by_cylinder_v_y = t520
        .add_product(t34, t563)
        .sub_product(R::literal(5.0), t562);
    let cylinder_omega_dot_by_cylinder_v_y = t558
        .sub_product(t31, t566)
        .add_product(t32, t565)
        .sub_product(R::literal(-2_777.777_777_777_778), t564)
        .add_product(t33, t563);
    let cylinder_v_y_dot_by_cylinder_v_y = t543
        .sub_product(R::literal(3.333_333_333_333_333_5), t565)
        .add_product(t30, t563);
    let cylinder_v_x_dot_by_cylinder_v_y = t507
        .sub_product(R::literal(3.333_333_333_333_333_5), t566)
        .sub_product(t29, t563);
    let plate_omega_dot_by_cylinder_v_y = (t26 * t567)
        .sub_product(t25, t568)
        .sub_product(t25, t566)
        .add_product(t26, t565)
        .add_product(t27, t560)
        .sub_product(t28, t559);
    let plate_v_y_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t565))
        .sub_product(R::literal(0.833_333_333_333_333_4), t567)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t559);
    let plate_v_x_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t566))
        .sub_product(R::literal(0.833_333_333_333_333_4), t568)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t560);
    let post_omega_dot_by_cylinder_v_y = (t24 * t569)
        .sub_product(t23, t570)
        .sub_product(t23, t568)
        .add_product(t24, t567);
    let post_v_y_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t567))
        .sub_product(R::literal(1.25), t569);
    let post_v_x_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t568))
        .sub_product(R::literal(1.25), t570);
    let t571 = p.spring_damping * t322;
    let t572 = R::literal(0.12) * cylinder_omega;
    let t573 = R::literal(3.333_333_333_333_333_5) * t500;
    let t574 = (-t573).sub_product(t572, cos_cylinder_phi).add_product(t31, t571);
    let t575 = R::literal(3.333_333_333_333_333_5) * t538;
    let t576 = (-t575)
        .sub_product(t572, sin_cylinder_phi)
        .sub_product(t32, t571)
        .sub_product(t80, t574);
    let t577 = (R::literal(-2_777.777_777_777_778) * t571)
        .add_product(t82, t574)
        .sub_product(t91, t576);
    let t578 = (-(t29 * t500))
        .add_product(
            R::literal(2.0),
            ((t161 + t162)
                .add_product(rod_v_x, cos_cylinder_phi)
                .add_product(rod_v_y, sin_cylinder_phi) - t157 - t158)
                .sub_product(cylinder_v_x, cos_cylinder_phi)
                .sub_product(cylinder_v_y, sin_cylinder_phi),
        )
        .add_product(t30, t538)
        .sub_product(t33, t571)
        .sub_product(t34, t500)
        .add_product(t35, t538)
        .sub_product(t84, t574)
        .sub_product(t93, t576)
        .sub_product(t100, t577);
    let t579 = R::literal(5.0) * t500;
    let t580 = t579.sub_product(t101, t577).sub_product(t109, t578);
    let t581 = R::literal(5.0) * t538;
    let t582 = t581
        .add_product(t102, t577)
        .sub_product(t111, t578)
        .sub_product(t118, t580);
    let t583 = (-(t86 * t574))
        .sub_product(t95, t576)
        .sub_product(t104, t577)
        .sub_product(t113, t578)
        .sub_product(t120, t580)
        .sub_product(t125, t582);
    let t584 = (-(t88 * t574))
        .sub_product(t97, t576)
        .sub_product(t106, t577)
        .sub_product(t115, t578)
        .sub_product(t122, t580)
        .sub_product(t127, t582)
        .sub_product(t130, t583) * t131;
    let t585 = (t583 * t128).sub_product(t130, t584);
    let t586 = (t582 * t123).sub_product(t125, t585).sub_product(t127, t584);
    let t587 = (t580 * t116)
        .sub_product(t118, t586)
        .sub_product(t120, t585)
        .sub_product(t122, t584);
    let t588 = (t578 * t107)
        .sub_product(t109, t587)
        .sub_product(t111, t586)
        .sub_product(t113, t585)
        .sub_product(t115, t584);
    let t589 = (t577 * t98)
        .sub_product(t100, t588)
        .sub_product(t101, t587)
        .add_product(t102, t586)
        .sub_product(t104, t585)
        .sub_product(t106, t584);
    let t590 = (t576 * t89)
        .sub_product(t91, t589)
        .sub_product(t93, t588)
        .sub_product(t95, t585)
        .sub_product(t97, t584);
    let t591 = (t574 * t78)
        .sub_product(t80, t590)
        .add_product(t82, t589)
        .sub_product(t84, t588)
        .sub_product(t86, t585)
        .sub_product(t88, t584);
    let t592 = (-(t71 * t590))
        .sub_product(t69, t591)
        .sub_product(t74, t585)
        .sub_product(t77, t584);
    let t593 = (-(t59 * t591))
        .sub_product(t57, t592)
        .sub_product(t60, t590)
        .sub_product(t63, t585)
        .add_product(t65, t584);
    let t594 = (-(t52 * t592)).sub_product(t50, t593);
    let t595 = (-(t44 * t593)).sub_product(t42, t594).sub_product(t42, t592);
    let bobbin_v_y_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t584);
    let bobbin_v_x_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t585);
    let rod_omega_dot_by_cylinder_omega = (t36 * t587)
        .sub_product(R::literal(4_166.666_666_666_667), t589)
        .sub_product(t37, t586);
    let rod_v_y_dot_by_cylinder_omega = (-t581)
        .sub_product(t35, t588)
        .sub_product(R::literal(5.0), t586);
    let rod_v_x_dot_by_cylinder_omega = (-t579)
        .add_product(t34, t588)
        .sub_product(R::literal(5.0), t587);
    let cylinder_omega_dot_by_cylinder_omega = (-(t571
        * R::literal(2_777.777_777_777_778)))
        .sub_product(t31, t591)
        .add_product(t32, t590)
        .sub_product(R::literal(-2_777.777_777_777_778), t589)
        .add_product(t33, t588);
    let cylinder_v_y_dot_by_cylinder_omega = t575
        .sub_product(R::literal(3.333_333_333_333_333_5), t590)
        .add_product(t30, t588);
    let cylinder_v_x_dot_by_cylinder_omega = t573
        .sub_product(R::literal(3.333_333_333_333_333_5), t591)
        .sub_product(t29, t588);
    let plate_omega_dot_by_cylinder_omega = (t26 * t592)
        .sub_product(t25, t593)
        .sub_product(t25, t591)
        .add_product(t26, t590)
        .add_product(t27, t585)
        .sub_product(t28, t584);
    let plate_v_y_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t590))
        .sub_product(R::literal(0.833_333_333_333_333_4), t592)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t584);
    let plate_v_x_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t591))
        .sub_product(R::literal(0.833_333_333_333_333_4), t593)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t585);
    let post_omega_dot_by_cylinder_omega = (t24 * t594)
        .sub_product(t23, t595)
        .sub_product(t23, t593)
        .add_product(t24, t592);
    let post_v_y_dot_by_cylinder_omega = (-(R::literal(-1.25) * t592))
        .sub_product(R::literal(1.25), t594);
    let post_v_x_dot_by_cylinder_omega = (-(R::literal(-1.25) * t593))
        .sub_product(R::literal(1.25), t595);
    let t596 = t504 - t503;
    let t597 = (t507 - t508).sub_product(t80, t596);
    let t598 = t510.add_product(t82, t596).sub_product(t91, t597);
    let t599 = (t502 - t512 + t513 - t514 - t515 + t516)
        .sub_product(t84, t596)
        .sub_product(t93, t597)
        .sub_product(t100, t598);
    let t600 = t518.sub_product(t101, t598).sub_product(t109, t599);
    let t601 = t520
        .add_product(t102, t598)
        .sub_product(t111, t599)
        .sub_product(t118, t600);
    let t602 = (-(t86 * t596))
        .sub_product(t95, t597)
        .sub_product(t104, t598)
        .sub_product(t113, t599)
        .sub_product(t120, t600)
        .sub_product(t125, t601);
    let t603 = (-(t88 * t596))
        .sub_product(t97, t597)
        .sub_product(t106, t598)
        .sub_product(t115, t599)
        .sub_product(t122, t600)
        .sub_product(t127, t601)
        .sub_product(t130, t602) * t131;
    let t604 = (t602 * t128).sub_product(t130, t603);
    let t605 = (t601 * t123).sub_product(t125, t604).sub_product(t127, t603);
    let t606 = (t600 * t116)
        .sub_product(t118, t605)
        .sub_product(t120, t604)
        .sub_product(t122, t603);
    let t607 = (t599 * t107)
        .sub_product(t109, t606)
        .sub_product(t111, t605)
        .sub_product(t113, t604)
        .sub_product(t115, t603);
    let t608 = (t598 * t98)
        .sub_product(t100, t607)
        .sub_product(t101, t606)
        .add_product(t102, t605)
        .sub_product(t104, t604)
        .sub_product(t106, t603);
    let t609 = (t597 * t89)
        .sub_product(t91, t608)
        .sub_product(t93, t607)
        .sub_product(t95, t604)
        .sub_product(t97, t603);
    let t610 = (t596 * t78)
        .sub_product(t80, t609)
        .add_product(t82, t608)
        .sub_product(t84, t607)
        .sub_product(t86, t604)
        .sub_product(t88, t603);
    let t611 = (-(t71 * t609))
        .sub_product(t69, t610)
        .sub_product(t74, t604)
        .sub_product(t77, t603);
    let t612 = (-(t59 * t610))
        .sub_product(t57, t611)
        .sub_product(t60, t609)
        .sub_product(t63, t604)
        .add_product(t65, t603);
    let t613 = (-(t52 * t611)).sub_product(t50, t612);
    let t614 = (-(t44 * t612)).sub_product(t42, t613).sub_product(t42, t611);
    let bobbin_v_y_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t603);
    let bobbin_v_x_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t604);
    let rod_omega_dot_by_rod_v_x = (t36 * t606)
        .sub_product(R::literal(4_166.666_666_666_667), t608)
        .sub_product(t37, t605);
    let rod_v_y_dot_by_rod_v_x = t521
        .sub_product(t35, t607)
        .sub_product(R::literal(5.0), t605);
    let rod_v_x_dot_by_rod_v_x = (-t518)
        .add_product(t34, t607)
        .sub_product(R::literal(5.0), t606);
    let cylinder_omega_dot_by_rod_v_x = (-t524)
        .sub_product(t31, t610)
        .add_product(t32, t609)
        .sub_product(R::literal(-2_777.777_777_777_778), t608)
        .add_product(t33, t607);
    let cylinder_v_y_dot_by_rod_v_x = t506
        .sub_product(R::literal(3.333_333_333_333_333_5), t609)
        .add_product(t30, t607);
    let cylinder_v_x_dot_by_rod_v_x = t503
        .sub_product(R::literal(3.333_333_333_333_333_5), t610)
        .sub_product(t29, t607);
    let plate_omega_dot_by_rod_v_x = (t26 * t611)
        .sub_product(t25, t612)
        .sub_product(t25, t610)
        .add_product(t26, t609)
        .add_product(t27, t604)
        .sub_product(t28, t603);
    let plate_v_y_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t609))
        .sub_product(R::literal(0.833_333_333_333_333_4), t611)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t603);
    let plate_v_x_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t610))
        .sub_product(R::literal(0.833_333_333_333_333_4), t612)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t604);
    let post_omega_dot_by_rod_v_x = (t24 * t613)
        .sub_product(t23, t614)
        .sub_product(t23, t612)
        .add_product(t24, t611);
    let post_v_y_dot_by_rod_v_x = (-(R::literal(-1.25) * t611))
        .sub_product(R::literal(1.25), t613);
    let post_v_x_dot_by_rod_v_x = (-(R::literal(-1.25) * t612))
        .sub_product(R::literal(1.25), t614);
    let t615 = t540 - t506;
    let t616 = (t543 - t544).sub_product(t80, t615);
    let t617 = t546.add_product(t82, t615).sub_product(t91, t616);
    let t618 = (t539 - t548 + t549 - t550 - t551 + t552)
        .sub_product(t84, t615)
        .sub_product(t93, t616)
        .sub_product(t100, t617);
    let t619 = t520.sub_product(t101, t617).sub_product(t109, t618);
    let t620 = t555
        .add_product(t102, t617)
        .sub_product(t111, t618)
        .sub_product(t118, t619);
    let t621 = (-(t86 * t615))
        .sub_product(t95, t616)
        .sub_product(t104, t617)
        .sub_product(t113, t618)
        .sub_product(t120, t619)
        .sub_product(t125, t620);
    let t622 = (-(t88 * t615))
        .sub_product(t97, t616)
        .sub_product(t106, t617)
        .sub_product(t115, t618)
        .sub_product(t122, t619)
        .sub_product(t127, t620)
        .sub_product(t130, t621) * t131;
    let t623 = (t621 * t128).sub_product(t130, t622);
    let t624 = (t620 * t123).sub_product(t125, t623).sub_product(t127, t622);
    let t625 = (t619 * t116)
        .sub_product(t118, t624)
        .sub_product(t120, t623)
        .sub_product(t122, t622);
    let t626 = (t618 * t107)
        .sub_product(t109, t625)
        .sub_product(t111, t624)
        .sub_product(t113, t623)
        .sub_product(t115, t622);
    let t627 = (t617 * t98)
        .sub_product(t100, t626)
        .sub_product(t101, t625)
        .add_product(t102, t624)
        .sub_product(t104, t623)
        .sub_product(t106, t622);
    let t628 = (t616 * t89)
        .sub_product(t91, t627)
        .sub_product(t93, t626)
        .sub_product(t95, t623)
        .sub_product(t97, t622);
    let t629 = (t615 * t78)
        .sub_product(t80, t628)
        .add_product(t82, t627)
        .sub_product(t84, t626)
        .sub_product(t86, t623)
        .sub_product(t88, t622);
    let t630 = (-(t71 * t628))
        .sub_product(t69, t629)
        .sub_product(t74, t623)
        .sub_product(t77, t622);
    let t631 = (-(t59 * t629))
        .sub_product(t57, t630)
        .sub_product(t60, t628)
        .sub_product(t63, t623)
        .add_product(t65, t622);
    let t632 = (-(t52 * t630)).sub_product(t50, t631);
    let t633 = (-(t44 * t631)).sub_product(t42, t632).sub_product(t42, t630);
    let bobbin_v_y_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t622);
    let bobbin_v_x_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t623);
    let rod_omega_dot_by_rod_v_y = (t36 * t625)
        .sub_product(R::literal(4_166.666_666_666_667), t627)
        .sub_product(t37, t624);
    let rod_v_y_dot_by_rod_v_y = (-t555)
        .sub_product(t35, t626)
        .sub_product(R::literal(5.0), t624);
    let rod_v_x_dot_by_rod_v_y = (-t520)
        .add_product(t34, t626)
        .sub_product(R::literal(5.0), t625);
    let cylinder_omega_dot_by_rod_v_y = (-t558)
        .sub_product(t31, t629)
        .add_product(t32, t628)
        .sub_product(R::literal(-2_777.777_777_777_778), t627)
        .add_product(t33, t626);
    let cylinder_v_y_dot_by_rod_v_y = t542
        .sub_product(R::literal(3.333_333_333_333_333_5), t628)
        .add_product(t30, t626);
    let cylinder_v_x_dot_by_rod_v_y = t506
        .sub_product(R::literal(3.333_333_333_333_333_5), t629)
        .sub_product(t29, t626);
    let plate_omega_dot_by_rod_v_y = (t26 * t630)
        .sub_product(t25, t631)
        .sub_product(t25, t629)
        .add_product(t26, t628)
        .add_product(t27, t623)
        .sub_product(t28, t622);
    let plate_v_y_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t628))
        .sub_product(R::literal(0.833_333_333_333_333_4), t630)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t622);
    let plate_v_x_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t629))
        .sub_product(R::literal(0.833_333_333_333_333_4), t631)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t623);
    let post_omega_dot_by_rod_v_y = (t24 * t632)
        .sub_product(t23, t633)
        .sub_product(t23, t631)
        .add_product(t24, t630);
    let post_v_y_dot_by_rod_v_y = (-(R::literal(-1.25) * t630))
        .sub_product(R::literal(1.25), t632);
    let post_v_x_dot_by_rod_v_y = (-(R::literal(-1.25) * t631))
        .sub_product(R::literal(1.25), t633);
    let t634 = R::literal(0.12) * rod_omega;
    let t635 = t634 * cos_rod_phi;
    let t636 = (t634 * sin_rod_phi).sub_product(t118, t635);
    let t637 = (-(t120 * t635)).sub_product(t125, t636);
    let t638 = (-(t122 * t635)).sub_product(t127, t636).sub_product(t130, t637) * t131;
    let t639 = (t637 * t128).sub_product(t130, t638);
    let t640 = (t636 * t123).sub_product(t125, t639).sub_product(t127, t638);
    let t641 = (t635 * t116)
        .sub_product(t118, t640)
        .sub_product(t120, t639)
        .sub_product(t122, t638);
    let t642 = (-(t111 * t640))
        .sub_product(t109, t641)
        .sub_product(t113, t639)
        .sub_product(t115, t638);
    let t643 = (-(t101 * t641))
        .sub_product(t100, t642)
        .add_product(t102, t640)
        .sub_product(t104, t639)
        .sub_product(t106, t638);
    let t644 = (-(t93 * t642))
        .sub_product(t91, t643)
        .sub_product(t95, t639)
        .sub_product(t97, t638);
    let t645 = (t82 * t643)
        .sub_product(t80, t644)
        .sub_product(t84, t642)
        .sub_product(t86, t639)
        .sub_product(t88, t638);
    let t646 = (-(t71 * t644))
        .sub_product(t69, t645)
        .sub_product(t74, t639)
        .sub_product(t77, t638);
    let t647 = (-(t59 * t645))
        .sub_product(t57, t646)
        .sub_product(t60, t644)
        .sub_product(t63, t639)
        .add_product(t65, t638);
    let t648 = (-(t52 * t646)).sub_product(t50, t647);
    let t649 = (-(t44 * t647)).sub_product(t42, t648).sub_product(t42, t646);
    let bobbin_v_y_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t638);
    let bobbin_v_x_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t639);
    let rod_omega_dot_by_rod_omega = (t36 * t641)
        .sub_product(R::literal(4_166.666_666_666_667), t643)
        .sub_product(t37, t640);
    let rod_v_y_dot_by_rod_omega = (-(R::literal(5.0) * t640)).sub_product(t35, t642);
    let rod_v_x_dot_by_rod_omega = (-(R::literal(5.0) * t641)).add_product(t34, t642);
    let cylinder_omega_dot_by_rod_omega = (t32 * t644)
        .sub_product(t31, t645)
        .sub_product(R::literal(-2_777.777_777_777_778), t643)
        .add_product(t33, t642);
    let cylinder_v_y_dot_by_rod_omega = (t30 * t642)
        .sub_product(R::literal(3.333_333_333_333_333_5), t644);
    let cylinder_v_x_dot_by_rod_omega = (-(t29 * t642))
        .sub_product(R::literal(3.333_333_333_333_333_5), t645);
    let plate_omega_dot_by_rod_omega = (t26 * t646)
        .sub_product(t25, t647)
        .sub_product(t25, t645)
        .add_product(t26, t644)
        .add_product(t27, t639)
        .sub_product(t28, t638);
    let plate_v_y_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t644))
        .sub_product(R::literal(0.833_333_333_333_333_4), t646)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t638);
    let plate_v_x_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t645))
        .sub_product(R::literal(0.833_333_333_333_333_4), t647)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t639);
    let post_omega_dot_by_rod_omega = (t24 * t648)
        .sub_product(t23, t649)
        .sub_product(t23, t647)
        .add_product(t24, t646);
    let post_v_y_dot_by_rod_omega = (-(R::literal(-1.25) * t646))
        .sub_product(R::literal(1.25), t648);
    let post_v_x_dot_by_rod_omega = (-(R::literal(-1.25) * t647))
        .sub_product(R::literal(1.25), t649);
    let t650 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t14 / between_squared),
        );
    let t651 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t13 * t15 / between_squared),
        );
    let t652 = (-t651).add_product(t130, t650) * t131;
    let t653 = (-(t650 * t128)).sub_product(t130, t652);
    let t654 = (-(t127 * t652)).sub_product(t125, t653);
    let t655 = (-(t120 * t653)).sub_product(t118, t654).sub_product(t122, t652);
    let t656 = (-(t111 * t654))
        .sub_product(t109, t655)
        .sub_product(t113, t653)
        .sub_product(t115, t652);
    let t657 = (-(t101 * t655))
        .sub_product(t100, t656)
        .add_product(t102, t654)
        .sub_product(t104, t653)
        .sub_product(t106, t652);
    let t658 = (-(t93 * t656))
        .sub_product(t91, t657)
        .sub_product(t95, t653)
        .sub_product(t97, t652);
    let t659 = (t82 * t657)
        .sub_product(t80, t658)
        .sub_product(t84, t656)
        .sub_product(t86, t653)
        .sub_product(t88, t652);
    let t660 = (-(t71 * t658))
        .sub_product(t69, t659)
        .sub_product(t74, t653)
        .sub_product(t77, t652);
    let t661 = (-(t59 * t659))
        .sub_product(t57, t660)
        .sub_product(t60, t658)
        .sub_product(t63, t653)
        .add_product(t65, t652);
    let t662 = (-(t52 * t660)).sub_product(t50, t661);
    let t663 = (-(t44 * t661)).sub_product(t42, t662).sub_product(t42, t660);
    let bobbin_v_y_dot_by_bobbin_v_x = t651
        .sub_product(R::literal(1.428_571_428_571_428_6), t652);
    let bobbin_v_x_dot_by_bobbin_v_x = t650
        .sub_product(R::literal(1.428_571_428_571_428_6), t653);
    let rod_omega_dot_by_bobbin_v_x = (t36 * t655)
        .sub_product(R::literal(4_166.666_666_666_667), t657)
        .sub_product(t37, t654);
    let rod_v_y_dot_by_bobbin_v_x = (-(R::literal(5.0) * t654)).sub_product(t35, t656);
    let rod_v_x_dot_by_bobbin_v_x = (-(R::literal(5.0) * t655)).add_product(t34, t656);
    let cylinder_omega_dot_by_bobbin_v_x = (t32 * t658)
        .sub_product(t31, t659)
        .sub_product(R::literal(-2_777.777_777_777_778), t657)
        .add_product(t33, t656);
    let cylinder_v_y_dot_by_bobbin_v_x = (t30 * t656)
        .sub_product(R::literal(3.333_333_333_333_333_5), t658);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(t29 * t656))
        .sub_product(R::literal(3.333_333_333_333_333_5), t659);
    let plate_omega_dot_by_bobbin_v_x = (t26 * t660)
        .sub_product(t25, t661)
        .sub_product(t25, t659)
        .add_product(t26, t658)
        .add_product(t27, t653)
        .sub_product(t28, t652);
    let plate_v_y_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t658))
        .sub_product(R::literal(0.833_333_333_333_333_4), t660)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t652);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t659))
        .sub_product(R::literal(0.833_333_333_333_333_4), t661)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t653);
    let post_omega_dot_by_bobbin_v_x = (t24 * t662)
        .sub_product(t23, t663)
        .sub_product(t23, t661)
        .add_product(t24, t660);
    let post_v_y_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t660))
        .sub_product(R::literal(1.25), t662);
    let post_v_x_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t661))
        .sub_product(R::literal(1.25), t663);
    let t664 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t16 / between_squared),
        );
    let t665 = (-t664).add_product(t130, t651) * t131;
    let t666 = (-(t651 * t128)).sub_product(t130, t665);
    let t667 = (-(t127 * t665)).sub_product(t125, t666);
    let t668 = (-(t120 * t666)).sub_product(t118, t667).sub_product(t122, t665);
    let t669 = (-(t111 * t667))
        .sub_product(t109, t668)
        .sub_product(t113, t666)
        .sub_product(t115, t665);
    let t670 = (-(t101 * t668))
        .sub_product(t100, t669)
        .add_product(t102, t667)
        .sub_product(t104, t666)
        .sub_product(t106, t665);
    let t671 = (-(t93 * t669))
        .sub_product(t91, t670)
        .sub_product(t95, t666)
        .sub_product(t97, t665);
    let t672 = (t82 * t670)
        .sub_product(t80, t671)
        .sub_product(t84, t669)
        .sub_product(t86, t666)
        .sub_product(t88, t665);
    let t673 = (-(t71 * t671))
        .sub_product(t69, t672)
        .sub_product(t74, t666)
        .sub_product(t77, t665);
    let t674 = (-(t59 * t672))
        .sub_product(t57, t673)
        .sub_product(t60, t671)
        .sub_product(t63, t666)
        .add_product(t65, t665);
    let t675 = (-(t52 * t673)).sub_product(t50, t674);
    let t676 = (-(t44 * t674)).sub_product(t42, t675).sub_product(t42, t673);
    let bobbin_v_y_dot_by_bobbin_v_y = t664
        .sub_product(R::literal(1.428_571_428_571_428_6), t665);
    let bobbin_v_x_dot_by_bobbin_v_y = t651
        .sub_product(R::literal(1.428_571_428_571_428_6), t666);
    let rod_omega_dot_by_bobbin_v_y = (t36 * t668)
        .sub_product(R::literal(4_166.666_666_666_667), t670)
        .sub_product(t37, t667);
    let rod_v_y_dot_by_bobbin_v_y = (-(R::literal(5.0) * t667)).sub_product(t35, t669);
    let rod_v_x_dot_by_bobbin_v_y = (-(R::literal(5.0) * t668)).add_product(t34, t669);
    let cylinder_omega_dot_by_bobbin_v_y = (t32 * t671)
        .sub_product(t31, t672)
        .sub_product(R::literal(-2_777.777_777_777_778), t670)
        .add_product(t33, t669);
    let cylinder_v_y_dot_by_bobbin_v_y = (t30 * t669)
        .sub_product(R::literal(3.333_333_333_333_333_5), t671);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(t29 * t669))
        .sub_product(R::literal(3.333_333_333_333_333_5), t672);
    let plate_omega_dot_by_bobbin_v_y = (t26 * t673)
        .sub_product(t25, t674)
        .sub_product(t25, t672)
        .add_product(t26, t671)
        .add_product(t27, t666)
        .sub_product(t28, t665);
    let plate_v_y_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t671))
        .sub_product(R::literal(0.833_333_333_333_333_4), t673)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t665);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t672))
        .sub_product(R::literal(0.833_333_333_333_333_4), t674)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t666);
    let post_omega_dot_by_bobbin_v_y = (t24 * t675)
        .sub_product(t23, t676)
        .sub_product(t23, t674)
        .add_product(t24, t673);
    let post_v_y_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t673))
        .sub_product(R::literal(1.25), t675);
    let post_v_x_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t674))
        .sub_product(R::literal(1.25), t676);
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
    let t7 = bobbin_x - R::literal(0.328);
    let t8 = bobbin_y - R::literal(0.058);
    let between = (t7 * t7).add_product(t8, t8).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t7).add_product(bobbin_v_y, t8) / between;
    let t9 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t9)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t10 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t11 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let t12 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t13 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t14 = R::literal(24.0) * sin_plate_phi;
    let t15 = R::literal(24.0) * cos_plate_phi;
    let t16 = t10 * R::literal(400.0);
    let t17 = t11 * R::literal(400.0);
    let t18 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t19 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t21 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t22 = slide * R::literal(2_777.777_777_777_778);
    let t23 = sin_cylinder_phi * R::literal(5.0);
    let t24 = cos_cylinder_phi * R::literal(5.0);
    let t25 = R::literal(250.0) * sin_rod_phi;
    let t26 = R::literal(250.0) * cos_rod_phi;
    let t27 = t12 * t1;
    let t28 = R::literal(-1.25) - t27;
    let t29 = R::literal(1.0) / t28;
    let t30 = t13 * t1;
    let t31 = t30 * t29;
    let t32 = R::literal(1.25) - t27;
    let t33 = t32 * t29;
    let t34 = t13 * t0;
    let t35 = R::literal(-1.25) - t34;
    let t36 = t31 * t30;
    let t37 = R::literal(1.0) / (t35 - t36);
    let t38 = (t12 * t0).sub_product(t33, t30);
    let t39 = t38 * t37;
    let t40 = R::literal(1.25) - t34 - t36;
    let t41 = t40 * t37;
    let t42 = t14 * t3;
    let t43 = R::literal(1.0)
        / (t28 - R::literal(0.833_333_333_333_333_4) - t42)
            .sub_product(t33, t32)
            .sub_product(t39, t38);
    let t44 = t15 * t3;
    let t45 = (t30 + t44).sub_product(t31, t32).sub_product(t41, t38);
    let t46 = t45 * t43;
    let t47 = R::literal(0.833_333_333_333_333_4) - t42;
    let t48 = t47 * t43;
    let t49 = t44 * t43;
    let t50 = t16 * t3;
    let t51 = R::literal(0.833_333_333_333_333_4) + t50;
    let t52 = t51 * t43;
    let t53 = t17 * t3;
    let t54 = t53 * t43;
    let t55 = t15 * t2;
    let t56 = R::literal(1.0)
        / (t35 - R::literal(0.833_333_333_333_333_4) - t55 - t36)
            .sub_product(t41, t40)
            .sub_product(t46, t45);
    let t57 = (t14 * t2).sub_product(t48, t45);
    let t58 = t57 * t56;
    let t59 = (R::literal(0.833_333_333_333_333_4) - t55).sub_product(t49, t45);
    let t60 = t59 * t56;
    let t61 = -(t16 * t2);
    let t62 = t61.sub_product(t52, t45);
    let t63 = t62 * t56;
    let t64 = t17 * t2;
    let t65 = (R::literal(0.833_333_333_333_333_4) + t64).add_product(t54, t45);
    let t66 = t65 * t56;
    let t67 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t42
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t20, t5)
            .sub_product(t48, t47)
            .sub_product(t58, t57);
    let t68 = t44.add_product(t21, t5).sub_product(t49, t47).sub_product(t60, t57);
    let t69 = t68 * t67;
    let t70 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t71 = t70 * t67;
    let t72 = (-t18).add_product(t22, t5);
    let t73 = t72 * t67;
    let t74 = (R::literal(-0.833_333_333_333_333_4) + t50)
        .sub_product(t52, t47)
        .sub_product(t63, t57);
    let t75 = t74 * t67;
    let t76 = (-t53).add_product(t54, t47).sub_product(t66, t57);
    let t77 = t76 * t67;
    let t78 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t55
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t4)
            .sub_product(t49, t44)
            .sub_product(t60, t59)
            .sub_product(t69, t68);
    let t79 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t71, t68);
    let t80 = t79 * t78;
    let t81 = t19.sub_product(t22, t4).sub_product(t73, t68);
    let t82 = t81 * t78;
    let t83 = t61.sub_product(t52, t44).sub_product(t63, t59).sub_product(t75, t68);
    let t84 = t83 * t78;
    let t85 = (R::literal(-0.833_333_333_333_333_4) + t64)
        .add_product(t54, t44)
        .sub_product(t66, t59)
        .sub_product(t77, t68);
    let t86 = t85 * t78;
    let t87 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t71, t70).sub_product(t80, t79);
    let t88 = (-t22).add_product(t73, t70).sub_product(t82, t79);
    let t89 = t88 * t87;
    let t90 = t25 * t87;
    let t91 = t26 * t87;
    let t92 = (t75 * t70).sub_product(t84, t79);
    let t93 = t92 * t87;
    let t94 = (t77 * t70).sub_product(t86, t79);
    let t95 = t94 * t87;
    let t96 = R::literal(1.0)
        / (-(t19 * cos_cylinder_phi))
            .sub_product(t18, sin_cylinder_phi)
            .sub_product(t22, slide)
            .sub_product(t23, sin_cylinder_phi)
            .sub_product(t24, cos_cylinder_phi)
            .sub_product(t73, t72)
            .sub_product(t82, t81)
            .sub_product(t89, t88);
    let t97 = t23.sub_product(t90, t88);
    let t98 = t97 * t96;
    let t99 = (-t24).add_product(t91, t88);
    let t100 = t99 * t96;
    let t101 = (-(t75 * t72)).sub_product(t84, t81).sub_product(t93, t88);
    let t102 = t101 * t96;
    let t103 = (-(t77 * t72)).sub_product(t86, t81).sub_product(t95, t88);
    let t104 = t103 * t96;
    let t105 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t25, t6)
            .sub_product(t90, t25)
            .sub_product(t98, t97);
    let t106 = (t26 * t6).add_product(t91, t25).sub_product(t100, t97);
    let t107 = t106 * t105;
    let t108 = (-(t93 * t25)).sub_product(t102, t97);
    let t109 = t108 * t105;
    let t110 = (-(t95 * t25)).sub_product(t104, t97);
    let t111 = t110 * t105;
    let t112 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, R::literal(0.06) * cos_rod_phi)
            .sub_product(t91, t26)
            .sub_product(t100, t99)
            .sub_product(t107, t106);
    let t113 = (t93 * t26).sub_product(t102, t99).sub_product(t109, t106);
    let t114 = t113 * t112;
    let t115 = (t95 * t26).sub_product(t104, t99).sub_product(t111, t106);
    let t116 = t115 * t112;
    let t117 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t16, t10)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t52, t51)
            .sub_product(t63, t62)
            .sub_product(t75, t74)
            .sub_product(t84, t83)
            .sub_product(t93, t92)
            .sub_product(t102, t101)
            .sub_product(t109, t108)
            .sub_product(t114, t113);
    let t118 = (t17 * t10)
        .add_product(t54, t51)
        .sub_product(t66, t62)
        .sub_product(t77, t74)
        .sub_product(t86, t83)
        .sub_product(t95, t92)
        .sub_product(t104, t101)
        .sub_product(t111, t108)
        .sub_product(t116, t113);
    let t119 = t118 * t117;
    let t120 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t11)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t54, t53)
            .sub_product(t66, t65)
            .sub_product(t77, t76)
            .sub_product(t86, t85)
            .sub_product(t95, t94)
            .sub_product(t104, t103)
            .sub_product(t111, t110)
            .sub_product(t116, t115)
            .sub_product(t119, t118);
    let t121 = slide - R::literal(0.116);
    let t122 = t121 * cos_cylinder_phi;
    let t123 = t121 * sin_cylinder_phi;
    let t124 = t121 * t9;
    let t125 = R::literal(3.333_333_333_333_333_5) * t122;
    let t126 = (-t125).add_product(t20, t124);
    let t127 = R::literal(3.333_333_333_333_333_5) * t123;
    let t128 = (-t127).sub_product(t21, t124).sub_product(t69, t126);
    let t129 = (R::literal(-2_777.777_777_777_778) * t124)
        .add_product(t71, t126)
        .sub_product(t80, t128);
    let t130 = (t19 * t123)
        .sub_product(t18, t122)
        .sub_product(t22, t124)
        .sub_product(t23, t122)
        .add_product(t24, t123)
        .sub_product(t73, t126)
        .sub_product(t82, t128)
        .sub_product(t89, t129);
    let t131 = R::literal(5.0) * t122;
    let t132 = t131.sub_product(t90, t129).sub_product(t98, t130);
    let t133 = R::literal(5.0) * t123;
    let t134 = t133
        .add_product(t91, t129)
        .sub_product(t100, t130)
        .sub_product(t107, t132);
    let t135 = (-(t75 * t126))
        .sub_product(t84, t128)
        .sub_product(t93, t129)
        .sub_product(t102, t130)
        .sub_product(t109, t132)
        .sub_product(t114, t134);
    let t136 = (-(t77 * t126))
        .sub_product(t86, t128)
        .sub_product(t95, t129)
        .sub_product(t104, t130)
        .sub_product(t111, t132)
        .sub_product(t116, t134)
        .sub_product(t119, t135) * t120;
    let t137 = (t135 * t117).sub_product(t119, t136);
    let t138 = (t134 * t112).sub_product(t114, t137).sub_product(t116, t136);
    let t139 = (t132 * t105)
        .sub_product(t107, t138)
        .sub_product(t109, t137)
        .sub_product(t111, t136);
    let t140 = (t130 * t96)
        .sub_product(t98, t139)
        .sub_product(t100, t138)
        .sub_product(t102, t137)
        .sub_product(t104, t136);
    let t141 = (t129 * t87)
        .sub_product(t89, t140)
        .sub_product(t90, t139)
        .add_product(t91, t138)
        .sub_product(t93, t137)
        .sub_product(t95, t136);
    let t142 = (t128 * t78)
        .sub_product(t80, t141)
        .sub_product(t82, t140)
        .sub_product(t84, t137)
        .sub_product(t86, t136);
    let t143 = (t126 * t67)
        .sub_product(t69, t142)
        .add_product(t71, t141)
        .sub_product(t73, t140)
        .sub_product(t75, t137)
        .sub_product(t77, t136);
    let t144 = (-(t60 * t142))
        .sub_product(t58, t143)
        .sub_product(t63, t137)
        .sub_product(t66, t136);
    let t145 = (-(t48 * t143))
        .sub_product(t46, t144)
        .sub_product(t49, t142)
        .sub_product(t52, t137)
        .add_product(t54, t136);
    let t146 = (-(t41 * t144)).sub_product(t39, t145);
    let t147 = (-(t33 * t145)).sub_product(t31, t146).sub_product(t31, t144);
    let bobbin_v_y_dot_by_spring_stiffness = -(R::literal(1.428_571_428_571_428_6)
        * t136);
    let bobbin_v_x_dot_by_spring_stiffness = -(R::literal(1.428_571_428_571_428_6)
        * t137);
    let rod_omega_dot_by_spring_stiffness = (t25 * t139)
        .sub_product(R::literal(4_166.666_666_666_667), t141)
        .sub_product(t26, t138);
    let rod_v_y_dot_by_spring_stiffness = (-t133)
        .sub_product(t24, t140)
        .sub_product(R::literal(5.0), t138);
    let rod_v_x_dot_by_spring_stiffness = (-t131)
        .add_product(t23, t140)
        .sub_product(R::literal(5.0), t139);
    let cylinder_omega_dot_by_spring_stiffness = (-(t124
        * R::literal(2_777.777_777_777_778)))
        .sub_product(t20, t143)
        .add_product(t21, t142)
        .sub_product(R::literal(-2_777.777_777_777_778), t141)
        .add_product(t22, t140);
    let cylinder_v_y_dot_by_spring_stiffness = t127
        .sub_product(R::literal(3.333_333_333_333_333_5), t142)
        .add_product(t19, t140);
    let cylinder_v_x_dot_by_spring_stiffness = t125
        .sub_product(R::literal(3.333_333_333_333_333_5), t143)
        .sub_product(t18, t140);
    let plate_omega_dot_by_spring_stiffness = (t15 * t144)
        .sub_product(t14, t145)
        .sub_product(t14, t143)
        .add_product(t15, t142)
        .add_product(t16, t137)
        .sub_product(t17, t136);
    let plate_v_y_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t142))
        .sub_product(R::literal(0.833_333_333_333_333_4), t144)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t136);
    let plate_v_x_dot_by_spring_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t143))
        .sub_product(R::literal(0.833_333_333_333_333_4), t145)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t137);
    let post_omega_dot_by_spring_stiffness = (t13 * t146)
        .sub_product(t12, t147)
        .sub_product(t12, t145)
        .add_product(t13, t144);
    let post_v_y_dot_by_spring_stiffness = (-(R::literal(-1.25) * t144))
        .sub_product(R::literal(1.25), t146);
    let post_v_x_dot_by_spring_stiffness = (-(R::literal(-1.25) * t145))
        .sub_product(R::literal(1.25), t147);
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let t148 = slide_rate * t9;
    let t149 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_cos_cylinder_phi;
    let t150 = (-t149).add_product(t20, t148);
    let t151 = R::literal(3.333_333_333_333_333_5) * slide_rate_times_sin_cylinder_phi;
    let t152 = (-t151).sub_product(t21, t148).sub_product(t69, t150);
    let t153 = (R::literal(-2_777.777_777_777_778) * t148)
        .add_product(t71, t150)
        .sub_product(t80, t152);
    let t154 = (t19 * slide_rate_times_sin_cylinder_phi)
        .sub_product(t18, slide_rate_times_cos_cylinder_phi)
        .sub_product(t22, t148)
        .sub_product(t23, slide_rate_times_cos_cylinder_phi)
        .add_product(t24, slide_rate_times_sin_cylinder_phi)
        .sub_product(t73, t150)
        .sub_product(t82, t152)
        .sub_product(t89, t153);
    let t155 = R::literal(5.0) * slide_rate_times_cos_cylinder_phi;
    let t156 = t155.sub_product(t90, t153).sub_product(t98, t154);
    let t157 = R::literal(5.0) * slide_rate_times_sin_cylinder_phi;
    let t158 = t157
        .add_product(t91, t153)
        .sub_product(t100, t154)
        .sub_product(t107, t156);
    let t159 = (-(t75 * t150))
        .sub_product(t84, t152)
        .sub_product(t93, t153)
        .sub_product(t102, t154)
        .sub_product(t109, t156)
        .sub_product(t114, t158);
    let t160 = (-(t77 * t150))
        .sub_product(t86, t152)
        .sub_product(t95, t153)
        .sub_product(t104, t154)
        .sub_product(t111, t156)
        .sub_product(t116, t158)
        .sub_product(t119, t159) * t120;
    let t161 = (t159 * t117).sub_product(t119, t160);
    let t162 = (t158 * t112).sub_product(t114, t161).sub_product(t116, t160);
    let t163 = (t156 * t105)
        .sub_product(t107, t162)
        .sub_product(t109, t161)
        .sub_product(t111, t160);
    let t164 = (t154 * t96)
        .sub_product(t98, t163)
        .sub_product(t100, t162)
        .sub_product(t102, t161)
        .sub_product(t104, t160);
    let t165 = (t153 * t87)
        .sub_product(t89, t164)
        .sub_product(t90, t163)
        .add_product(t91, t162)
        .sub_product(t93, t161)
        .sub_product(t95, t160);
    let t166 = (t152 * t78)
        .sub_product(t80, t165)
        .sub_product(t82, t164)
        .sub_product(t84, t161)
        .sub_product(t86, t160);
    let t167 = (t150 * t67)
        .sub_product(t69, t166)
        .add_product(t71, t165)
        .sub_product(t73, t164)
        .sub_product(t75, t161)
        .sub_product(t77, t160);
    let t168 = (-(t60 * t166))
        .sub_product(t58, t167)
        .sub_product(t63, t161)
        .sub_product(t66, t160);
    let t169 = (-(t48 * t167))
        .sub_product(t46, t168)
        .sub_product(t49, t166)
        .sub_product(t52, t161)
        .add_product(t54, t160);
    let t170 = (-(t41 * t168)).sub_product(t39, t169);
    let t171 = (-(t33 * t169)).sub_product(t31, t170).sub_product(t31, t168);
    let bobbin_v_y_dot_by_spring_damping = -(R::literal(1.428_571_428_571_428_6) * t160);
    let bobbin_v_x_dot_by_spring_damping = -(R::literal(1.428_571_428_571_428_6) * t161);
    let rod_omega_dot_by_spring_damping = (t25 * t163)
        .sub_product(R::literal(4_166.666_666_666_667), t165)
        .sub_product(t26, t162);
    let rod_v_y_dot_by_spring_damping = (-t157)
        .sub_product(t24, t164)
        .sub_product(R::literal(5.0), t162);
    let rod_v_x_dot_by_spring_damping = (-t155)
        .add_product(t23, t164)
        .sub_product(R::literal(5.0), t163);
    let cylinder_omega_dot_by_spring_damping = (-(t148
        * R::literal(2_777.777_777_777_778)))
        .sub_product(t20, t167)
        .add_product(t21, t166)
        .sub_product(R::literal(-2_777.777_777_777_778), t165)
        .add_product(t22, t164);
    let cylinder_v_y_dot_by_spring_damping = t151
        .sub_product(R::literal(3.333_333_333_333_333_5), t166)
        .add_product(t19, t164);
    let cylinder_v_x_dot_by_spring_damping = t149
        .sub_product(R::literal(3.333_333_333_333_333_5), t167)
        .sub_product(t18, t164);
    let plate_omega_dot_by_spring_damping = (t15 * t168)
        .sub_product(t14, t169)
        .sub_product(t14, t167)
        .add_product(t15, t166)
        .add_product(t16, t161)
        .sub_product(t17, t160);
    let plate_v_y_dot_by_spring_damping = (-(R::literal(-0.833_333_333_333_333_4)
        * t166))
        .sub_product(R::literal(0.833_333_333_333_333_4), t168)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t160);
    let plate_v_x_dot_by_spring_damping = (-(R::literal(-0.833_333_333_333_333_4)
        * t167))
        .sub_product(R::literal(0.833_333_333_333_333_4), t169)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t161);
    let post_omega_dot_by_spring_damping = (t13 * t170)
        .sub_product(t12, t171)
        .sub_product(t12, t169)
        .add_product(t13, t168);
    let post_v_y_dot_by_spring_damping = (-(R::literal(-1.25) * t168))
        .sub_product(R::literal(1.25), t170);
    let post_v_x_dot_by_spring_damping = (-(R::literal(-1.25) * t169))
        .sub_product(R::literal(1.25), t171);
    let t172 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_gap * t7 / between),
        );
    let t173 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_gap * t8 / between),
        );
    let t174 = (-t173).add_product(t119, t172) * t120;
    let t175 = (-(t172 * t117)).sub_product(t119, t174);
    let t176 = (-(t116 * t174)).sub_product(t114, t175);
    let t177 = (-(t109 * t175)).sub_product(t107, t176).sub_product(t111, t174);
    let t178 = (-(t100 * t176))
        .sub_product(t98, t177)
        .sub_product(t102, t175)
        .sub_product(t104, t174);
    let t179 = (-(t90 * t177))
        .sub_product(t89, t178)
        .add_product(t91, t176)
        .sub_product(t93, t175)
        .sub_product(t95, t174);
    let t180 = (-(t82 * t178))
        .sub_product(t80, t179)
        .sub_product(t84, t175)
        .sub_product(t86, t174);
    let t181 = (t71 * t179)
        .sub_product(t69, t180)
        .sub_product(t73, t178)
        .sub_product(t75, t175)
        .sub_product(t77, t174);
    let t182 = (-(t60 * t180))
        .sub_product(t58, t181)
        .sub_product(t63, t175)
        .sub_product(t66, t174);
    let t183 = (-(t48 * t181))
        .sub_product(t46, t182)
        .sub_product(t49, t180)
        .sub_product(t52, t175)
        .add_product(t54, t174);
    let t184 = (-(t41 * t182)).sub_product(t39, t183);
    let t185 = (-(t33 * t183)).sub_product(t31, t184).sub_product(t31, t182);
    let bobbin_v_y_dot_by_contact_stiffness = t173
        .sub_product(R::literal(1.428_571_428_571_428_6), t174);
    let bobbin_v_x_dot_by_contact_stiffness = t172
        .sub_product(R::literal(1.428_571_428_571_428_6), t175);
    let rod_omega_dot_by_contact_stiffness = (t25 * t177)
        .sub_product(R::literal(4_166.666_666_666_667), t179)
        .sub_product(t26, t176);
    let rod_v_y_dot_by_contact_stiffness = (-(R::literal(5.0) * t176))
        .sub_product(t24, t178);
    let rod_v_x_dot_by_contact_stiffness = (-(R::literal(5.0) * t177))
        .add_product(t23, t178);
    let cylinder_omega_dot_by_contact_stiffness = (t21 * t180)
        .sub_product(t20, t181)
        .sub_product(R::literal(-2_777.777_777_777_778), t179)
        .add_product(t22, t178);
    let cylinder_v_y_dot_by_contact_stiffness = (t19 * t178)
        .sub_product(R::literal(3.333_333_333_333_333_5), t180);
    let cylinder_v_x_dot_by_contact_stiffness = (-(t18 * t178))
        .sub_product(R::literal(3.333_333_333_333_333_5), t181);
    let plate_omega_dot_by_contact_stiffness = (t15 * t182)
        .sub_product(t14, t183)
        .sub_product(t14, t181)
        .add_product(t15, t180)
        .add_product(t16, t175)
        .sub_product(t17, t174);
    let plate_v_y_dot_by_contact_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t180))
        .sub_product(R::literal(0.833_333_333_333_333_4), t182)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t174);
    let plate_v_x_dot_by_contact_stiffness = (-(R::literal(-0.833_333_333_333_333_4)
        * t181))
        .sub_product(R::literal(0.833_333_333_333_333_4), t183)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t175);
    let post_omega_dot_by_contact_stiffness = (t13 * t184)
        .sub_product(t12, t185)
        .sub_product(t12, t183)
        .add_product(t13, t182);
    let post_v_y_dot_by_contact_stiffness = (-(R::literal(-1.25) * t182))
        .sub_product(R::literal(1.25), t184);
    let post_v_x_dot_by_contact_stiffness = (-(R::literal(-1.25) * t183))
        .sub_product(R::literal(1.25), t185);
    let t186 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_rate * t7 / between),
        );
    let t187 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_rate * t8 / between),
        );
    let t188 = (-t187).add_product(t119, t186) * t120;
    let t189 = (-(t186 * t117)).sub_product(t119, t188);
    let t190 = (-(t116 * t188)).sub_product(t114, t189);
    let t191 = (-(t109 * t189)).sub_product(t107, t190).sub_product(t111, t188);
    let t192 = (-(t100 * t190))
        .sub_product(t98, t191)
        .sub_product(t102, t189)
        .sub_product(t104, t188);
    let t193 = (-(t90 * t191))
        .sub_product(t89, t192)
        .add_product(t91, t190)
        .sub_product(t93, t189)
        .sub_product(t95, t188);
    let t194 = (-(t82 * t192))
        .sub_product(t80, t193)
        .sub_product(t84, t189)
        .sub_product(t86, t188);
    let t195 = (t71 * t193)
        .sub_product(t69, t194)
        .sub_product(t73, t192)
        .sub_product(t75, t189)
        .sub_product(t77, t188);
    let t196 = (-(t60 * t194))
        .sub_product(t58, t195)
        .sub_product(t63, t189)
        .sub_product(t66, t188);
    let t197 = (-(t48 * t195))
        .sub_product(t46, t196)
        .sub_product(t49, t194)
        .sub_product(t52, t189)
        .add_product(t54, t188);
    let t198 = (-(t41 * t196)).sub_product(t39, t197);
    let t199 = (-(t33 * t197)).sub_product(t31, t198).sub_product(t31, t196);
    let bobbin_v_y_dot_by_contact_damping = t187
        .sub_product(R::literal(1.428_571_428_571_428_6), t188);
    let bobbin_v_x_dot_by_contact_damping = t186
        .sub_product(R::literal(1.428_571_428_571_428_6), t189);
    let rod_omega_dot_by_contact_damping = (t25 * t191)
        .sub_product(R::literal(4_166.666_666_666_667), t193)
        .sub_product(t26, t190);
    let rod_v_y_dot_by_contact_damping = (-(R::literal(5.0) * t190))
        .sub_product(t24, t192);
    let rod_v_x_dot_by_contact_damping = (-(R::literal(5.0) * t191))
        .add_product(t23, t192);
    let cylinder_omega_dot_by_contact_damping = (t21 * t194)
        .sub_product(t20, t195)
        .sub_product(R::literal(-2_777.777_777_777_778), t193)
        .add_product(t22, t192);
    let cylinder_v_y_dot_by_contact_damping = (t19 * t192)
        .sub_product(R::literal(3.333_333_333_333_333_5), t194);
    let cylinder_v_x_dot_by_contact_damping = (-(t18 * t192))
        .sub_product(R::literal(3.333_333_333_333_333_5), t195);
    let plate_omega_dot_by_contact_damping = (t15 * t196)
        .sub_product(t14, t197)
        .sub_product(t14, t195)
        .add_product(t15, t194)
        .add_product(t16, t189)
        .sub_product(t17, t188);
    let plate_v_y_dot_by_contact_damping = (-(R::literal(-0.833_333_333_333_333_4)
        * t194))
        .sub_product(R::literal(0.833_333_333_333_333_4), t196)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t188);
    let plate_v_x_dot_by_contact_damping = (-(R::literal(-0.833_333_333_333_333_4)
        * t195))
        .sub_product(R::literal(0.833_333_333_333_333_4), t197)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t189);
    let post_omega_dot_by_contact_damping = (t13 * t198)
        .sub_product(t12, t199)
        .sub_product(t12, t197)
        .add_product(t13, t196);
    let post_v_y_dot_by_contact_damping = (-(R::literal(-1.25) * t196))
        .sub_product(R::literal(1.25), t198);
    let post_v_x_dot_by_contact_damping = (-(R::literal(-1.25) * t197))
        .sub_product(R::literal(1.25), t199);
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
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)] = R::sin_cos_each([
        post_phi,
        cylinder_phi,
    ]);
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi)
            .add_product(R::literal(0.143), cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let stop_push = (-(R::literal(1_000_000.0) * stop_gap))
        .sub_product(R::literal(1500.0), stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(
            cylinder_omega,
            (rod_y_minus_cylinder_y * cos_cylinder_phi)
                .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi),
        )
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_push = (-(p.contact_stiffness * contact_gap))
        .sub_product(p.contact_damping, contact_rate);
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
        strut_push: (-(p.spring_stiffness * (slide - R::literal(0.116))))
            .sub_product(p.spring_damping, slide_rate),
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
    let [(sin_post_phi, cos_post_phi), (sin_cylinder_phi, cos_cylinder_phi)] = R::sin_cos_each([
        post_phi,
        cylinder_phi,
    ]);
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t2 = slide - R::literal(0.116);
    Energy {
        kinetic: (R::literal(0.00012) * (rod_omega * rod_omega))
            .add_product(R::literal(0.00018), cylinder_omega * cylinder_omega)
            .add_product(R::literal(0.00125), plate_omega * plate_omega)
            .add_product(R::literal(0.00135), post_omega * post_omega)
            .add_product(
                R::literal(0.1),
                (rod_v_x * rod_v_x).add_product(rod_v_y, rod_v_y),
            )
            .add_product(
                R::literal(0.15),
                (cylinder_v_x * cylinder_v_x).add_product(cylinder_v_y, cylinder_v_y),
            )
            .add_product(
                R::literal(0.35),
                (bobbin_v_x * bobbin_v_x).add_product(bobbin_v_y, bobbin_v_y),
            )
            .add_product(
                R::literal(0.4),
                (post_v_x * post_v_x).add_product(post_v_y, post_v_y),
            )
            .add_product(
                R::literal(0.6),
                (plate_v_x * plate_v_x).add_product(plate_v_y, plate_v_y),
            ),
        potential: (R::literal(1.962) * rod_y)
            .add_product(R::literal(0.5) * p.spring_stiffness, t2 * t2)
            .add_product(R::literal(2.943), cylinder_y)
            .add_product(R::literal(6.867), bobbin_y)
            .add_product(R::literal(7.848), post_y)
            .add_product(R::literal(11.772), plate_y)
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
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t10 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t10)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t11 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t12 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let t13 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t14 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t15 = R::literal(24.0) * sin_plate_phi;
    let t16 = R::literal(24.0) * cos_plate_phi;
    let t17 = t11 * R::literal(400.0);
    let t18 = t12 * R::literal(400.0);
    let t19 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t20 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t21 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t22 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t23 = slide * R::literal(2_777.777_777_777_778);
    let t24 = sin_cylinder_phi * R::literal(5.0);
    let t25 = cos_cylinder_phi * R::literal(5.0);
    let t26 = R::literal(250.0) * sin_rod_phi;
    let t27 = R::literal(250.0) * cos_rod_phi;
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
    let t39 = (t13 * t0).sub_product(t34, t31);
    let t40 = t39 * t38;
    let t41 = R::literal(1.25) - t35 - t37;
    let t42 = t41 * t38;
    let t43 = t15 * t3;
    let t44 = R::literal(1.0)
        / (t29 - R::literal(0.833_333_333_333_333_4) - t43)
            .sub_product(t34, t33)
            .sub_product(t40, t39);
    let t45 = t16 * t3;
    let t46 = (t31 + t45).sub_product(t32, t33).sub_product(t42, t39);
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
        / (t36 - R::literal(0.833_333_333_333_333_4) - t56 - t37)
            .sub_product(t42, t41)
            .sub_product(t47, t46);
    let t58 = (t15 * t2).sub_product(t49, t46);
    let t59 = t58 * t57;
    let t60 = (R::literal(0.833_333_333_333_333_4) - t56).sub_product(t50, t46);
    let t61 = t60 * t57;
    let t62 = -(t17 * t2);
    let t63 = t62.sub_product(t53, t46);
    let t64 = t63 * t57;
    let t65 = t18 * t2;
    let t66 = (R::literal(0.833_333_333_333_333_4) + t65).add_product(t55, t46);
    let t67 = t66 * t57;
    let t68 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t43
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t21, t5)
            .sub_product(t49, t48)
            .sub_product(t59, t58);
    let t69 = t45.add_product(t22, t5).sub_product(t50, t48).sub_product(t61, t58);
    let t70 = t69 * t68;
    let t71 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t72 = t71 * t68;
    let t73 = (-t19).add_product(t23, t5);
    let t74 = t73 * t68;
    let t75 = (R::literal(-0.833_333_333_333_333_4) + t51)
        .sub_product(t53, t48)
        .sub_product(t64, t58);
    let t76 = t75 * t68;
    let t77 = (-t54).add_product(t55, t48).sub_product(t67, t58);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t56
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t22, t4)
            .sub_product(t50, t45)
            .sub_product(t61, t60)
            .sub_product(t70, t69);
    let t80 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = t20.sub_product(t23, t4).sub_product(t74, t69);
    let t83 = t82 * t79;
    let t84 = t62.sub_product(t53, t45).sub_product(t64, t60).sub_product(t76, t69);
    let t85 = t84 * t79;
    let t86 = (R::literal(-0.833_333_333_333_333_4) + t65)
        .add_product(t55, t45)
        .sub_product(t67, t60)
        .sub_product(t78, t69);
    let t87 = t86 * t79;
    let t88 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t72, t71).sub_product(t81, t80);
    let t89 = (-t23).add_product(t74, t71).sub_product(t83, t80);
    let t90 = t89 * t88;
    let t91 = t26 * t88;
    let t92 = t27 * t88;
    let t93 = (t76 * t71).sub_product(t85, t80);
    let t94 = t93 * t88;
    let t95 = (t78 * t71).sub_product(t87, t80);
    let t96 = t95 * t88;
    let t97 = R::literal(1.0)
        / (-(t20 * cos_cylinder_phi))
            .sub_product(t19, sin_cylinder_phi)
            .sub_product(t23, slide)
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t25, cos_cylinder_phi)
            .sub_product(t74, t73)
            .sub_product(t83, t82)
            .sub_product(t90, t89);
    let t98 = t24.sub_product(t91, t89);
    let t99 = t98 * t97;
    let t100 = (-t25).add_product(t92, t89);
    let t101 = t100 * t97;
    let t102 = (-(t76 * t73)).sub_product(t85, t82).sub_product(t94, t89);
    let t103 = t102 * t97;
    let t104 = (-(t78 * t73)).sub_product(t87, t82).sub_product(t96, t89);
    let t105 = t104 * t97;
    let t106 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t26, t6)
            .sub_product(t91, t26)
            .sub_product(t99, t98);
    let t107 = (t27 * t6).add_product(t92, t26).sub_product(t101, t98);
    let t108 = t107 * t106;
    let t109 = (-(t94 * t26)).sub_product(t103, t98);
    let t110 = t109 * t106;
    let t111 = (-(t96 * t26)).sub_product(t105, t98);
    let t112 = t111 * t106;
    let t113 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t27, R::literal(0.06) * cos_rod_phi)
            .sub_product(t92, t27)
            .sub_product(t101, t100)
            .sub_product(t108, t107);
    let t114 = (t94 * t27).sub_product(t103, t100).sub_product(t110, t107);
    let t115 = t114 * t113;
    let t116 = (t96 * t27).sub_product(t105, t100).sub_product(t112, t107);
    let t117 = t116 * t113;
    let t118 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t17, t11)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t53, t52)
            .sub_product(t64, t63)
            .sub_product(t76, t75)
            .sub_product(t85, t84)
            .sub_product(t94, t93)
            .sub_product(t103, t102)
            .sub_product(t110, t109)
            .sub_product(t115, t114);
    let t119 = (t18 * t11)
        .add_product(t55, t52)
        .sub_product(t67, t63)
        .sub_product(t78, t75)
        .sub_product(t87, t84)
        .sub_product(t96, t93)
        .sub_product(t105, t102)
        .sub_product(t112, t109)
        .sub_product(t117, t114);
    let t120 = t119 * t118;
    let t121 = R::literal(1_000_000.0) * stop_gap * t7;
    let t122 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-t121).sub_product(R::literal(1500.0) * stop_rate, t7),
    );
    let t123 = p.spring_stiffness * (slide - R::literal(0.116));
    let t124 = t123 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t125 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t126 = t124 + t125;
    let t127 = t123 * sin_cylinder_phi;
    let t128 = R::literal(2.943) - t127;
    let t129 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t130 = t129 - t128;
    let t131 = t123 * t10;
    let t132 = (-t131).sub_product(spring_damping_times_slide_rate, t10);
    let t133 = -t124 - t125;
    let t134 = R::literal(1.962) + t127;
    let t135 = -t129 - t134;
    let t136 = contact_stiffness_times_contact_gap * t8 / between;
    let t137 = R::literal(6.867)
        + R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            contact_stiffness_times_contact_gap * t9 / between,
        );
    let t138 = R::literal(0.1) * (post_omega * post_omega);
    let t139 = t138 * cos_post_phi;
    let t140 = t138 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t141 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t142 = R::literal(0.06) * (rod_omega * rod_omega);
    let t143 = t13 * t122;
    let t144 = -t139 - t143;
    let t145 = t14 * t122;
    let t146 = t32 * t144;
    let t147 = -t140 - R::literal(-9.81) + t145 - t146;
    let t148 = (-t139.add_product(t141, cos_plate_phi) - t143)
        .sub_product(t34, t144)
        .sub_product(t40, t147);
    let t149 = (-t140.add_product(t141, sin_plate_phi) - R::literal(9.81) + t145
        - R::literal(-9.81) - t146)
        .sub_product(t42, t147)
        .sub_product(t47, t148);
    let t150 = R::literal(3.333_333_333_333_333_5) * t126;
    let t151 = (-t150)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t21, t132)
        .sub_product(t49, t148)
        .sub_product(t59, t149);
    let t152 = R::literal(3.333_333_333_333_333_5) * t130;
    let t153 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t152)
        .add_product(t22, t132)
        .sub_product(t50, t148)
        .sub_product(t61, t149)
        .sub_product(t70, t151);
    let t154 = (-(R::literal(-2_777.777_777_777_778) * t132))
        .add_product(t72, t151)
        .sub_product(t81, t153);
    let t155 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t19, t126)
        .add_product(t20, t130)
        .add_product(t23, t132)
        .add_product(t24, t133)
        .sub_product(t25, t135)
        .sub_product(t74, t151)
        .sub_product(t83, t153);
    let t156 = t155.sub_product(t90, t154);
    let t157 = R::literal(5.0) * t133;
    let t158 = (-t157)
        .add_product(t142, cos_rod_phi)
        .sub_product(t91, t154)
        .sub_product(t99, t156);
    let t159 = R::literal(5.0) * t135;
    let t160 = (-t159)
        .add_product(t142, sin_rod_phi)
        .add_product(t92, t154)
        .sub_product(t101, t156)
        .sub_product(t108, t158);
    let t161 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -t136 - contact_damping_times_contact_rate * t8 / between,
        );
    let t162 = (-t161)
        .add_product(t12, plate_omega_squared)
        .sub_product(t53, t148)
        .sub_product(t64, t149)
        .sub_product(t76, t151)
        .sub_product(t85, t153)
        .sub_product(t94, t154)
        .sub_product(t103, t156)
        .sub_product(t110, t158)
        .sub_product(t115, t160);
    let t163 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_damping_times_contact_rate * t9 / between),
        ) - t137);
    let t164 = (R::literal(-9.81).add_product(t11, plate_omega_squared) - t163)
        .add_product(t55, t148)
        .sub_product(t67, t149)
        .sub_product(t78, t151)
        .sub_product(t87, t153)
        .sub_product(t96, t154)
        .sub_product(t105, t156)
        .sub_product(t112, t158)
        .sub_product(t117, t160)
        .sub_product(t120, t162)
        * (R::literal(1.0)
            / (R::literal(-0.833_333_333_333_333_4).sub_product(t18, t12)
                - R::literal(1.428_571_428_571_428_6))
                .sub_product(t55, t54)
                .sub_product(t67, t66)
                .sub_product(t78, t77)
                .sub_product(t87, t86)
                .sub_product(t96, t95)
                .sub_product(t105, t104)
                .sub_product(t112, t111)
                .sub_product(t117, t116)
                .sub_product(t120, t119));
    let t165 = (t162 * t118).sub_product(t120, t164);
    let t166 = (t160 * t113).sub_product(t115, t165).sub_product(t117, t164);
    let t167 = (t158 * t106)
        .sub_product(t108, t166)
        .sub_product(t110, t165)
        .sub_product(t112, t164);
    let t168 = (t156 * t97)
        .sub_product(t99, t167)
        .sub_product(t101, t166)
        .sub_product(t103, t165)
        .sub_product(t105, t164);
    let t169 = (t154 * t88)
        .sub_product(t90, t168)
        .sub_product(t91, t167)
        .add_product(t92, t166)
        .sub_product(t94, t165)
        .sub_product(t96, t164);
    let t170 = (t153 * t79)
        .sub_product(t81, t169)
        .sub_product(t83, t168)
        .sub_product(t85, t165)
        .sub_product(t87, t164);
    let t171 = (t151 * t68)
        .sub_product(t70, t170)
        .add_product(t72, t169)
        .sub_product(t74, t168)
        .sub_product(t76, t165)
        .sub_product(t78, t164);
    let t172 = (t149 * t57)
        .sub_product(t59, t171)
        .sub_product(t61, t170)
        .sub_product(t64, t165)
        .sub_product(t67, t164);
    let t173 = (t148 * t44)
        .sub_product(t47, t172)
        .sub_product(t49, t171)
        .sub_product(t50, t170)
        .sub_product(t53, t165)
        .add_product(t55, t164);
    let t174 = (t147 * t38).sub_product(t40, t173).sub_product(t42, t172);
    let t175 = (t144 * t30)
        .sub_product(t32, t174)
        .sub_product(t34, t173)
        .sub_product(t32, t172);
    let bobbin_v_y_dot = t163.sub_product(R::literal(1.428_571_428_571_428_6), t164);
    let bobbin_v_x_dot = t161.sub_product(R::literal(1.428_571_428_571_428_6), t165);
    let rod_omega_dot = (t26 * t167)
        .sub_product(R::literal(4_166.666_666_666_667), t169)
        .sub_product(t27, t166);
    let rod_v_y_dot = t159.sub_product(t25, t168).sub_product(R::literal(5.0), t166);
    let rod_v_x_dot = t157.add_product(t24, t168).sub_product(R::literal(5.0), t167);
    let cylinder_omega_dot = (t132 * R::literal(2_777.777_777_777_778))
        .sub_product(t21, t171)
        .add_product(t22, t170)
        .sub_product(R::literal(-2_777.777_777_777_778), t169)
        .add_product(t23, t168);
    let cylinder_v_y_dot = t152
        .sub_product(R::literal(3.333_333_333_333_333_5), t170)
        .add_product(t20, t168);
    let cylinder_v_x_dot = t150
        .sub_product(R::literal(3.333_333_333_333_333_5), t171)
        .sub_product(t19, t168);
    let plate_omega_dot = (t16 * t172)
        .sub_product(t15, t173)
        .sub_product(t15, t171)
        .add_product(t16, t170)
        .add_product(t17, t165)
        .sub_product(t18, t164);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t172)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t170)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t164);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t171))
        .sub_product(R::literal(0.833_333_333_333_333_4), t173)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t165);
    let post_omega_dot = (t122 * R::literal(370.370_370_370_370_3))
        .sub_product(t13, t175)
        .add_product(t14, t174)
        .sub_product(t13, t173)
        .add_product(t14, t172);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t174)
        .sub_product(R::literal(-1.25), t172);
    let post_v_x_dot = (-(R::literal(-1.25) * t173)).sub_product(R::literal(1.25), t175);
    let t176 = (R::literal(7.848) * post_v_y)
        .add_product(
            R::select_less(stop_closed, R::literal(0.5), R::literal(0.0), t121),
            post_omega,
        )
        .add_product(R::literal(11.772), plate_v_y)
        .sub_product(t124, cylinder_v_x)
        .add_product(t128, cylinder_v_y)
        .add_product(t131, cylinder_omega)
        .add_product(t124, rod_v_x)
        .add_product(t134, rod_v_y)
        .add_product(
            R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), t136),
            bobbin_v_x,
        )
        .add_product(t137, bobbin_v_y)
        .add_product(R::literal(0.8) * post_v_x, post_v_x_dot)
        .add_product(R::literal(0.8) * post_v_y, post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, post_omega_dot)
        .add_product(R::literal(1.2) * plate_v_x, plate_v_x_dot)
        .add_product(R::literal(1.2) * plate_v_y, plate_v_y_dot)
        .add_product(R::literal(0.0025) * plate_omega, plate_omega_dot);
    let t177 = (p.spring_damping * cylinder_omega * slide_rate * t10)
        .add_product(p.spring_damping * rod_v_x * slide_rate, cos_cylinder_phi)
        .add_product(p.spring_damping * rod_v_y * slide_rate, sin_cylinder_phi)
        + R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            p.contact_damping * bobbin_v_x * contact_rate * t8 / between
                + p.contact_damping * bobbin_v_y * contact_rate * t9 / between,
        )
        + R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            R::literal(1500.0) * (stop_rate * stop_rate),
        );
    PowerBalance {
        stored_rate: t176
            .add_product(R::literal(0.3) * cylinder_v_x, cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, rod_v_x_dot)
            .add_product(R::literal(0.2) * rod_v_y, rod_v_y_dot)
            .add_product(R::literal(0.00024) * rod_omega, rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, bobbin_v_x_dot)
            .add_product(R::literal(0.7) * bobbin_v_y, bobbin_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: t177
            .sub_product(p.spring_damping * cylinder_v_x * slide_rate, cos_cylinder_phi)
            .sub_product(p.spring_damping * cylinder_v_y * slide_rate, sin_cylinder_phi),
    }
}

/// What passes zero where an event happens, in the order of `EVENT_SHAPES`.
///
/// 30 operations.
#[must_use]
pub fn guards<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; EVENTS] {
    let post_phi = state[2];
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let (sin_post_phi, cos_post_phi) = post_phi.sin_cos();
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let stop_rate = post_omega
        * (R::literal(0.044) * sin_post_phi)
            .add_product(R::literal(0.143), cos_post_phi);
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let t2 = -(R::literal(1_000_000.0) * stop_gap);
    let stop_push = t2.sub_product(R::literal(1500.0), stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let t3 = -(p.contact_stiffness * contact_gap);
    let contact_push = t3.sub_product(p.contact_damping, contact_rate);
    let stop_contact = R::select_less(t2, stop_push, t2, stop_push);
    let contact_contact = R::select_less(t3, contact_push, t3, contact_push);
    [contact_contact, contact_contact, stop_contact, stop_contact]
}

/// `dg/dt` of the guards along the motion.
///
/// 730 operations.
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
    let stop_gap = (R::literal(0.143) * sin_post_phi)
        .sub_product(R::literal(0.044), cos_post_phi);
    let t7 = (R::literal(0.044) * sin_post_phi)
        .add_product(R::literal(0.143), cos_post_phi);
    let stop_rate = post_omega * t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let between = (t8 * t8).add_product(t9, t9).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let t10 = R::literal(1_000_000.0) * stop_gap;
    let t11 = R::literal(1500.0) * stop_rate;
    let t12 = -t10;
    let stop_push = t12 - t11;
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t9) / between;
    let t13 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t13)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t14 = -contact_stiffness_times_contact_gap;
    let contact_push = t14 - contact_damping_times_contact_rate;
    let t15 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t16 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let t17 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t18 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t19 = R::literal(24.0) * sin_plate_phi;
    let t20 = R::literal(24.0) * cos_plate_phi;
    let t21 = t15 * R::literal(400.0);
    let t22 = t16 * R::literal(400.0);
    let t23 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t24 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t25 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t26 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t27 = slide * R::literal(2_777.777_777_777_778);
    let t28 = sin_cylinder_phi * R::literal(5.0);
    let t29 = cos_cylinder_phi * R::literal(5.0);
    let t30 = R::literal(250.0) * sin_rod_phi;
    let t31 = R::literal(250.0) * cos_rod_phi;
    let t32 = t17 * t1;
    let t33 = R::literal(-1.25) - t32;
    let t34 = R::literal(1.0) / t33;
    let t35 = t18 * t1;
    let t36 = t35 * t34;
    let t37 = R::literal(1.25) - t32;
    let t38 = t37 * t34;
    let t39 = t18 * t0;
    let t40 = R::literal(-1.25) - t39;
    let t41 = t36 * t35;
    let t42 = R::literal(1.0) / (t40 - t41);
    let t43 = (t17 * t0).sub_product(t38, t35);
    let t44 = t43 * t42;
    let t45 = R::literal(1.25) - t39 - t41;
    let t46 = t45 * t42;
    let t47 = t19 * t3;
    let t48 = R::literal(1.0)
        / (t33 - R::literal(0.833_333_333_333_333_4) - t47)
            .sub_product(t38, t37)
            .sub_product(t44, t43);
    let t49 = t20 * t3;
    let t50 = (t35 + t49).sub_product(t36, t37).sub_product(t46, t43);
    let t51 = t50 * t48;
    let t52 = R::literal(0.833_333_333_333_333_4) - t47;
    let t53 = t52 * t48;
    let t54 = t49 * t48;
    let t55 = t21 * t3;
    let t56 = R::literal(0.833_333_333_333_333_4) + t55;
    let t57 = t56 * t48;
    let t58 = t22 * t3;
    let t59 = t58 * t48;
    let t60 = t20 * t2;
    let t61 = R::literal(1.0)
        / (t40 - R::literal(0.833_333_333_333_333_4) - t60 - t41)
            .sub_product(t46, t45)
            .sub_product(t51, t50);
    let t62 = (t19 * t2).sub_product(t53, t50);
    let t63 = t62 * t61;
    let t64 = (R::literal(0.833_333_333_333_333_4) - t60).sub_product(t54, t50);
    let t65 = t64 * t61;
    let t66 = -(t21 * t2);
    let t67 = t66.sub_product(t57, t50);
    let t68 = t67 * t61;
    let t69 = t22 * t2;
    let t70 = (R::literal(0.833_333_333_333_333_4) + t69).add_product(t59, t50);
    let t71 = t70 * t61;
    let t72 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t47
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t25, t5)
            .sub_product(t53, t52)
            .sub_product(t63, t62);
    let t73 = t49.add_product(t26, t5).sub_product(t54, t52).sub_product(t65, t62);
    let t74 = t73 * t72;
    let t75 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t76 = t75 * t72;
    let t77 = (-t23).add_product(t27, t5);
    let t78 = t77 * t72;
    let t79 = (R::literal(-0.833_333_333_333_333_4) + t55)
        .sub_product(t57, t52)
        .sub_product(t68, t62);
    let t80 = t79 * t72;
    let t81 = (-t58).add_product(t59, t52).sub_product(t71, t62);
    let t82 = t81 * t72;
    let t83 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t60
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t26, t4)
            .sub_product(t54, t49)
            .sub_product(t65, t64)
            .sub_product(t74, t73);
    let t84 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t76, t73);
    let t85 = t84 * t83;
    let t86 = t24.sub_product(t27, t4).sub_product(t78, t73);
    let t87 = t86 * t83;
    let t88 = t66.sub_product(t57, t49).sub_product(t68, t64).sub_product(t80, t73);
    let t89 = t88 * t83;
    let t90 = (R::literal(-0.833_333_333_333_333_4) + t69)
        .add_product(t59, t49)
        .sub_product(t71, t64)
        .sub_product(t82, t73);
    let t91 = t90 * t83;
    let t92 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t76, t75).sub_product(t85, t84);
    let t93 = (-t27).add_product(t78, t75).sub_product(t87, t84);
    let t94 = t93 * t92;
    let t95 = t30 * t92;
    let t96 = t31 * t92;
    let t97 = (t80 * t75).sub_product(t89, t84);
    let t98 = t97 * t92;
    let t99 = (t82 * t75).sub_product(t91, t84);
    let t100 = t99 * t92;
    let t101 = R::literal(1.0)
        / (-(t24 * cos_cylinder_phi))
            .sub_product(t23, sin_cylinder_phi)
            .sub_product(t27, slide)
            .sub_product(t28, sin_cylinder_phi)
            .sub_product(t29, cos_cylinder_phi)
            .sub_product(t78, t77)
            .sub_product(t87, t86)
            .sub_product(t94, t93);
    let t102 = t28.sub_product(t95, t93);
    let t103 = t102 * t101;
    let t104 = (-t29).add_product(t96, t93);
    let t105 = t104 * t101;
    let t106 = (-(t80 * t77)).sub_product(t89, t86).sub_product(t98, t93);
    let t107 = t106 * t101;
    let t108 = (-(t82 * t77)).sub_product(t91, t86).sub_product(t100, t93);
    let t109 = t108 * t101;
    let t110 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t30, t6)
            .sub_product(t95, t30)
            .sub_product(t103, t102);
    let t111 = (t31 * t6).add_product(t96, t30).sub_product(t105, t102);
    let t112 = t111 * t110;
    let t113 = (-(t98 * t30)).sub_product(t107, t102);
    let t114 = t113 * t110;
    let t115 = (-(t100 * t30)).sub_product(t109, t102);
    let t116 = t115 * t110;
    let t117 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t31, R::literal(0.06) * cos_rod_phi)
            .sub_product(t96, t31)
            .sub_product(t105, t104)
            .sub_product(t112, t111);
    let t118 = (t98 * t31).sub_product(t107, t104).sub_product(t114, t111);
    let t119 = t118 * t117;
    let t120 = (t100 * t31).sub_product(t109, t104).sub_product(t116, t111);
    let t121 = t120 * t117;
    let t122 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t21, t15)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t57, t56)
            .sub_product(t68, t67)
            .sub_product(t80, t79)
            .sub_product(t89, t88)
            .sub_product(t98, t97)
            .sub_product(t107, t106)
            .sub_product(t114, t113)
            .sub_product(t119, t118);
    let t123 = (t22 * t15)
        .add_product(t59, t56)
        .sub_product(t71, t67)
        .sub_product(t82, t79)
        .sub_product(t91, t88)
        .sub_product(t100, t97)
        .sub_product(t109, t106)
        .sub_product(t116, t113)
        .sub_product(t121, t118);
    let t124 = t123 * t122;
    let t125 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(t10 * t7)).sub_product(t11, t7),
    );
    let t126 = p.spring_stiffness * (slide - R::literal(0.116));
    let t127 = t126 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t128 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t129 = t127 + t128;
    let t130 = t126 * sin_cylinder_phi;
    let t131 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t132 = t131 - (R::literal(2.943) - t130);
    let t133 = (-(t126 * t13)).sub_product(spring_damping_times_slide_rate, t13);
    let t134 = -t127 - t128;
    let t135 = -t131 - (R::literal(1.962) + t130);
    let t136 = contact_damping_times_contact_rate * t8;
    let t137 = contact_damping_times_contact_rate * t9;
    let t138 = R::literal(0.1) * (post_omega * post_omega);
    let t139 = t138 * cos_post_phi;
    let t140 = t138 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t141 = R::literal(0.06) * plate_omega_squared;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t142 = R::literal(0.06) * (rod_omega * rod_omega);
    let t143 = t17 * t125;
    let t144 = -t139 - t143;
    let t145 = t18 * t125;
    let t146 = t36 * t144;
    let t147 = -t140 - R::literal(-9.81) + t145 - t146;
    let t148 = (-t139.add_product(t141, cos_plate_phi) - t143)
        .sub_product(t38, t144)
        .sub_product(t44, t147);
    let t149 = (-t140.add_product(t141, sin_plate_phi) - R::literal(9.81) + t145
        - R::literal(-9.81) - t146)
        .sub_product(t46, t147)
        .sub_product(t51, t148);
    let t150 = (-(R::literal(0.06)
        * (plate_omega_squared * cos_plate_phi)
            .add_product(cylinder_omega_squared, cos_cylinder_phi)))
        .sub_product(R::literal(3.333_333_333_333_333_5), t129)
        .sub_product(t25, t133)
        .sub_product(t53, t148)
        .sub_product(t63, t149);
    let t151 = R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        )
        .sub_product(R::literal(3.333_333_333_333_333_5), t132)
        .add_product(t26, t133)
        .sub_product(t54, t148)
        .sub_product(t65, t149)
        .sub_product(t74, t150);
    let t152 = (-(R::literal(-2_777.777_777_777_778) * t133))
        .add_product(t76, t150)
        .sub_product(t85, t151);
    let t153 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t23, t129)
        .add_product(t24, t132)
        .add_product(t27, t133)
        .add_product(t28, t134)
        .sub_product(t29, t135)
        .sub_product(t78, t150)
        .sub_product(t87, t151);
    let t154 = t153.sub_product(t94, t152);
    let t155 = (t142 * cos_rod_phi)
        .sub_product(R::literal(5.0), t134)
        .sub_product(t95, t152)
        .sub_product(t103, t154);
    let t156 = (t142 * sin_rod_phi)
        .sub_product(R::literal(5.0), t135)
        .add_product(t96, t152)
        .sub_product(t105, t154)
        .sub_product(t112, t155);
    let t157 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(contact_stiffness_times_contact_gap * t8 / between) - t136 / between,
        );
    let t158 = (-t157)
        .add_product(t16, plate_omega_squared)
        .sub_product(t57, t148)
        .sub_product(t68, t149)
        .sub_product(t80, t150)
        .sub_product(t89, t151)
        .sub_product(t98, t152)
        .sub_product(t107, t154)
        .sub_product(t114, t155)
        .sub_product(t119, t156);
    let t159 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(t137 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    contact_stiffness_times_contact_gap * t9 / between,
                )));
    let t160 = (R::literal(-9.81).add_product(t15, plate_omega_squared) - t159)
        .add_product(t59, t148)
        .sub_product(t71, t149)
        .sub_product(t82, t150)
        .sub_product(t91, t151)
        .sub_product(t100, t152)
        .sub_product(t109, t154)
        .sub_product(t116, t155)
        .sub_product(t121, t156)
        .sub_product(t124, t158)
        * (R::literal(1.0)
            / (R::literal(-0.833_333_333_333_333_4).sub_product(t22, t16)
                - R::literal(1.428_571_428_571_428_6))
                .sub_product(t59, t58)
                .sub_product(t71, t70)
                .sub_product(t82, t81)
                .sub_product(t91, t90)
                .sub_product(t100, t99)
                .sub_product(t109, t108)
                .sub_product(t116, t115)
                .sub_product(t121, t120)
                .sub_product(t124, t123));
    let t161 = (t158 * t122).sub_product(t124, t160);
    let t162 = (t156 * t117).sub_product(t119, t161).sub_product(t121, t160);
    let t163 = (t155 * t110)
        .sub_product(t112, t162)
        .sub_product(t114, t161)
        .sub_product(t116, t160);
    let t164 = (t154 * t101)
        .sub_product(t103, t163)
        .sub_product(t105, t162)
        .sub_product(t107, t161)
        .sub_product(t109, t160);
    let t165 = (t152 * t92)
        .sub_product(t94, t164)
        .sub_product(t95, t163)
        .add_product(t96, t162)
        .sub_product(t98, t161)
        .sub_product(t100, t160);
    let t166 = (t151 * t83)
        .sub_product(t85, t165)
        .sub_product(t87, t164)
        .sub_product(t89, t161)
        .sub_product(t91, t160);
    let t167 = (t150 * t72)
        .sub_product(t74, t166)
        .add_product(t76, t165)
        .sub_product(t78, t164)
        .sub_product(t80, t161)
        .sub_product(t82, t160);
    let t168 = (t149 * t61)
        .sub_product(t63, t167)
        .sub_product(t65, t166)
        .sub_product(t68, t161)
        .sub_product(t71, t160);
    let t169 = (t148 * t48)
        .sub_product(t51, t168)
        .sub_product(t53, t167)
        .sub_product(t54, t166)
        .sub_product(t57, t161)
        .add_product(t59, t160);
    let t170 = (t147 * t42).sub_product(t44, t169).sub_product(t46, t168);
    let bobbin_v_y_dot = t159.sub_product(R::literal(1.428_571_428_571_428_6), t160);
    let bobbin_v_x_dot = t157.sub_product(R::literal(1.428_571_428_571_428_6), t161);
    let post_omega_dot = (t125 * R::literal(370.370_370_370_370_3))
        .sub_product(
            t17,
            (t144 * t34)
                .sub_product(t36, t170)
                .sub_product(t38, t169)
                .sub_product(t36, t168),
        )
        .add_product(t18, t170)
        .sub_product(t17, t169)
        .add_product(t18, t168);
    let between_squared = between * between;
    let t171 = p.contact_stiffness * t8 / between;
    let t172 = p.contact_stiffness * t9 / between;
    let t173 = (R::select_less(
        t14,
        contact_push,
        -t171,
        t136 / between_squared - p.contact_damping * bobbin_v_x / between - t171,
    ) * bobbin_v_x)
        .add_product(
            R::select_less(
                t14,
                contact_push,
                -t172,
                t137 / between_squared - p.contact_damping * bobbin_v_y / between - t172,
            ),
            bobbin_v_y,
        )
        .add_product(
            R::select_less(
                t14,
                contact_push,
                R::literal(0.0),
                -(p.contact_damping * t8 / between),
            ),
            bobbin_v_x_dot,
        );
    let contact_touches_guard_rate = t173
        .add_product(
            R::select_less(
                t14,
                contact_push,
                R::literal(0.0),
                -(p.contact_damping * t9 / between),
            ),
            bobbin_v_y_dot,
        );
    let t174 = R::literal(1_000_000.0) * t7;
    let stop_touches_guard_rate = (R::select_less(
        t12,
        stop_push,
        -t174,
        (-t174).add_product(R::literal(1500.0) * post_omega, stop_gap),
    ) * post_omega)
        .add_product(
            R::select_less(t12, stop_push, R::literal(0.0), -(R::literal(1500.0) * t7)),
            post_omega_dot,
        );
    [
        contact_touches_guard_rate,
        contact_touches_guard_rate,
        stop_touches_guard_rate,
        stop_touches_guard_rate,
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
    let slide_across_value = ((rod_y - cylinder_y) * cos_cylinder_phi)
        .sub_product(rod_x - cylinder_x, sin_cylinder_phi);
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
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
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
    let [(sin_post_phi, cos_post_phi), (sin_plate_phi, cos_plate_phi),
    (sin_cylinder_phi, cos_cylinder_phi), (sin_rod_phi, cos_rod_phi)] = R::sin_cos_each([
        post_phi,
        plate_phi,
        cylinder_phi,
        rod_phi,
    ]);
    let t0 = R::literal(0.1) * sin_post_phi;
    let t1 = R::literal(0.06) * sin_plate_phi;
    let slide = ((rod_x - cylinder_x) * cos_cylinder_phi)
        .add_product(rod_y - cylinder_y, sin_cylinder_phi);
    let t2 = -(R::literal(0.1) * cos_post_phi);
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
        -(R::literal(0.06) * sin_rod_phi),
        R::literal(1.0),
        R::literal(0.06) * cos_rod_phi,
        R::literal(-1.0),
        -(R::literal(0.01) * sin_plate_phi).add_product(R::literal(0.1), cos_plate_phi),
        R::literal(1.0),
        R::literal(-1.0),
        (R::literal(0.01) * cos_plate_phi).sub_product(R::literal(0.1), sin_plate_phi),
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
    fn guards(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guards(time, state_of(state), &parameters_of(parameters));
    }
    fn guard_rates(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = guard_rates(
            time,
            state_of(state),
            &parameters_of(parameters),
        );
    }
    fn resets(&self, time: R, state: &[R], parameters: &[R], values: &mut [R]) {
        *array_of(values) = resets(time, state_of(state), &parameters_of(parameters));
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
        direction: Direction::Rising,
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
        direction: Direction::Rising,
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

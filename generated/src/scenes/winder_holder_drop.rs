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
//   rate_jacobian          4430
//   parameter_jacobian       57
//   time_derivative           0
//   outputs                  52
//   energy                   78
//   power_balance           106
//   guards                   28
//   guard_rates              50
//   resets                    0
//   constraint_values        49
//   constraint_rates         63
//   constraint_matrix        35
// Before those that read it:
//   motion                  752
// With constants of the parameters, prepared once a run:
//   prepare                   1
//   prepared_rate           741
//   prepared_rate_jacobian 4429
//   motion                  752

use ::machinist_contract::{
    Constraint, Describe, Direction, Event, Energy, PowerBalance, Quantity, Real,
    RunDefaults, Shape, Simulator, SparsityPattern, implicit::{Step, substitute},
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
        (0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7), (8, 8), (9, 9), (10, 10),
        (11, 11), (12, 12), (13, 13),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 30,
    columns: 30,
    entries: &[
        (0, 14), (1, 15), (2, 16), (3, 17), (4, 18), (5, 19), (6, 20), (7, 21), (8, 22), (9, 23),
        (10, 24), (11, 25), (12, 26), (13, 27), (14, 2), (14, 5), (14, 6), (14, 7), (14, 8),
        (14, 9), (14, 10), (14, 11), (14, 12), (14, 13), (14, 16), (14, 19), (14, 20), (14, 21),
        (14, 22), (14, 23), (14, 24), (14, 25), (14, 26), (14, 27), (15, 2), (15, 5), (15, 6),
        (15, 7), (15, 8), (15, 9), (15, 10), (15, 11), (15, 12), (15, 13), (15, 16), (15, 19),
        (15, 20), (15, 21), (15, 22), (15, 23), (15, 24), (15, 25), (15, 26), (15, 27), (16, 2),
        (16, 5), (16, 6), (16, 7), (16, 8), (16, 9), (16, 10), (16, 11), (16, 12), (16, 13),
        (16, 16), (16, 19), (16, 20), (16, 21), (16, 22), (16, 23), (16, 24), (16, 25), (16, 26),
        (16, 27), (17, 2), (17, 5), (17, 6), (17, 7), (17, 8), (17, 9), (17, 10), (17, 11),
        (17, 12), (17, 13), (17, 16), (17, 19), (17, 20), (17, 21), (17, 22), (17, 23), (17, 24),
        (17, 25), (17, 26), (17, 27), (18, 2), (18, 5), (18, 6), (18, 7), (18, 8), (18, 9),
        (18, 10), (18, 11), (18, 12), (18, 13), (18, 16), (18, 19), (18, 20), (18, 21), (18, 22),
        (18, 23), (18, 24), (18, 25), (18, 26), (18, 27), (19, 2), (19, 5), (19, 6), (19, 7),
        (19, 8), (19, 9), (19, 10), (19, 11), (19, 12), (19, 13), (19, 16), (19, 19), (19, 20),
        (19, 21), (19, 22), (19, 23), (19, 24), (19, 25), (19, 26), (19, 27), (20, 2), (20, 5),
        (20, 6), (20, 7), (20, 8), (20, 9), (20, 10), (20, 11), (20, 12), (20, 13), (20, 16),
        (20, 19), (20, 20), (20, 21), (20, 22), (20, 23), (20, 24), (20, 25), (20, 26), (20, 27),
        (21, 2), (21, 5), (21, 6), (21, 7), (21, 8), (21, 9), (21, 10), (21, 11), (21, 12),
        (21, 13), (21, 16), (21, 19), (21, 20), (21, 21), (21, 22), (21, 23), (21, 24), (21, 25),
        (21, 26), (21, 27), (22, 2), (22, 5), (22, 6), (22, 7), (22, 8), (22, 9), (22, 10),
        (22, 11), (22, 12), (22, 13), (22, 16), (22, 19), (22, 20), (22, 21), (22, 22), (22, 23),
        (22, 24), (22, 25), (22, 26), (22, 27), (23, 2), (23, 5), (23, 6), (23, 7), (23, 8),
        (23, 9), (23, 10), (23, 11), (23, 12), (23, 13), (23, 16), (23, 19), (23, 20), (23, 21),
        (23, 22), (23, 23), (23, 24), (23, 25), (23, 26), (23, 27), (24, 2), (24, 5), (24, 6),
        (24, 7), (24, 8), (24, 9), (24, 10), (24, 11), (24, 12), (24, 13), (24, 16), (24, 19),
        (24, 20), (24, 21), (24, 22), (24, 23), (24, 24), (24, 25), (24, 26), (24, 27), (25, 2),
        (25, 5), (25, 6), (25, 7), (25, 8), (25, 9), (25, 10), (25, 11), (25, 12), (25, 13),
        (25, 16), (25, 19), (25, 20), (25, 21), (25, 22), (25, 23), (25, 24), (25, 25), (25, 26),
        (25, 27), (26, 2), (26, 5), (26, 6), (26, 7), (26, 8), (26, 9), (26, 10), (26, 11),
        (26, 12), (26, 13), (26, 16), (26, 19), (26, 20), (26, 21), (26, 22), (26, 23), (26, 24),
        (26, 25), (26, 26), (26, 27), (27, 2), (27, 5), (27, 6), (27, 7), (27, 8), (27, 9),
        (27, 10), (27, 11), (27, 12), (27, 13), (27, 16), (27, 19), (27, 20), (27, 21), (27, 22),
        (27, 23), (27, 24), (27, 25), (27, 26), (27, 27),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 30,
    columns: 5,
    entries: &[
        (14, 1), (14, 2), (14, 3), (14, 4), (15, 1), (15, 2), (15, 3), (15, 4), (16, 1), (16, 2),
        (16, 3), (16, 4), (17, 1), (17, 2), (17, 3), (17, 4), (18, 1), (18, 2), (18, 3), (18, 4),
        (19, 1), (19, 2), (19, 3), (19, 4), (20, 1), (20, 2), (20, 3), (20, 4), (21, 1), (21, 2),
        (21, 3), (21, 4), (22, 1), (22, 2), (22, 3), (22, 4), (23, 1), (23, 2), (23, 3), (23, 4),
        (24, 1), (24, 2), (24, 3), (24, 4), (25, 1), (25, 2), (25, 3), (25, 4), (26, 1), (26, 2),
        (26, 3), (26, 4), (27, 1), (27, 2), (27, 3), (27, 4),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 12;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 12,
    columns: 14,
    entries: &[
        (0, 0), (0, 2), (1, 1), (1, 2), (2, 0), (2, 2), (2, 3), (2, 5), (3, 1), (3, 2), (3, 4),
        (3, 5), (4, 3), (4, 5), (4, 6), (4, 8), (5, 4), (5, 5), (5, 7), (5, 8), (6, 8), (6, 11),
        (7, 6), (7, 7), (7, 8), (7, 9), (7, 10), (8, 9), (8, 11), (9, 10), (9, 11), (10, 3),
        (10, 5), (10, 12), (11, 4), (11, 5), (11, 13),
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

/// What several functions need of the motion; `motion` says what each is.
#[allow(missing_docs, reason = "`motion` says what each is")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<R> {
    pub factors: [R; 70],
    pub cos_post_phi: R,
    pub sin_post_phi: R,
    pub cos_plate_phi: R,
    pub sin_plate_phi: R,
    pub cos_cylinder_phi: R,
    pub sin_cylinder_phi: R,
    pub cos_rod_phi: R,
    pub sin_rod_phi: R,
    pub stop_gap: R,
    pub t7: R,
    pub t9: R,
    pub t11: R,
    pub between: R,
    pub slide: R,
    pub contact_rate: R,
    pub t12: R,
    pub slide_rate: R,
    pub t13: R,
    pub t14: R,
    pub t38: R,
    pub t40: R,
    pub t41: R,
    pub t48: R,
    pub t49: R,
    pub t50: R,
    pub t53: R,
    pub t55: R,
    pub t56: R,
    pub t57: R,
    pub t58: R,
    pub t63: R,
    pub t66: R,
    pub t70: R,
    pub t71: R,
    pub t72: R,
    pub t75: R,
    pub t81: R,
    pub t84: R,
    pub t91: R,
    pub t98: R,
    pub t100: R,
    pub t105: R,
    pub t106: R,
    pub t112: R,
    pub t113: R,
    pub t116: R,
    pub t123: R,
    pub t124: R,
    pub t127: R,
    pub t128: R,
    pub t144: R,
    pub t149: R,
    pub t152: R,
    pub t155: R,
    pub t159: R,
    pub t160: R,
    pub t161: R,
    pub t162: R,
    pub t163: R,
    pub t165: R,
    pub t166: R,
    pub t168: R,
    pub t169: R,
    pub t171: R,
    pub t172: R,
    pub t194: R,
    pub t195: R,
    pub t196: R,
    pub t197: R,
    pub t198: R,
    pub t199: R,
    pub t202: R,
    pub t204: R,
    pub t206: R,
    pub t207: R,
    pub t208: R,
    pub t209: R,
    pub bobbin_v_y_dot: R,
    pub bobbin_v_x_dot: R,
    pub rod_omega_dot: R,
    pub rod_v_y_dot: R,
    pub rod_v_x_dot: R,
    pub cylinder_omega_dot: R,
    pub cylinder_v_y_dot: R,
    pub cylinder_v_x_dot: R,
    pub plate_omega_dot: R,
    pub plate_v_y_dot: R,
    pub plate_v_x_dot: R,
    pub post_omega_dot: R,
    pub post_v_y_dot: R,
    pub post_v_x_dot: R,
}

/// Accelerations, factors of the linear equations they solve, and whatever else several functions need.
///
/// 752 operations.
#[must_use]
pub fn motion<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    _c: &Constants<R>,
) -> Motion<R> {
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
    let t9 = t8 * t8;
    let t10 = bobbin_y - R::literal(0.058);
    let t11 = t10 * t10;
    let between = (t9 + t11).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t8).add_product(bobbin_v_y, t10) / between;
    let t12 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t12)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let contact_damping_times_contact_rate = p.contact_damping * contact_rate;
    let t13 = (R::literal(0.01) * sin_plate_phi)
        .add_product(R::literal(0.1), cos_plate_phi);
    let t14 = (R::literal(0.01) * cos_plate_phi)
        .sub_product(R::literal(0.1), sin_plate_phi);
    let t15 = R::literal(37.037_037_037_037_03) * sin_post_phi;
    let t16 = R::literal(37.037_037_037_037_03) * cos_post_phi;
    let t17 = -t16;
    let t18 = R::literal(24.0) * sin_plate_phi;
    let t19 = R::literal(24.0) * cos_plate_phi;
    let t20 = -t19;
    let t21 = t13 * R::literal(400.0);
    let t22 = -t21;
    let t23 = t14 * R::literal(400.0);
    let t24 = sin_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t25 = cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t26 = -t25;
    let t27 = R::literal(166.666_666_666_666_66) * sin_cylinder_phi;
    let t28 = R::literal(166.666_666_666_666_66) * cos_cylinder_phi;
    let t29 = -t28;
    let t30 = slide * R::literal(2_777.777_777_777_778);
    let t31 = -t30;
    let t32 = sin_cylinder_phi * R::literal(5.0);
    let t33 = -t32;
    let t34 = cos_cylinder_phi * R::literal(5.0);
    let t35 = R::literal(250.0) * sin_rod_phi;
    let t36 = -t35;
    let t37 = R::literal(250.0) * cos_rod_phi;
    let t38 = t15 * t1;
    let t39 = R::literal(-1.25) - t38;
    let t40 = R::literal(1.0) / t39;
    let t41 = t16 * t1;
    let t42 = t41 * t40;
    let t43 = R::literal(1.25) - t38;
    let t44 = t43 * t40;
    let t45 = t16 * t0;
    let t46 = R::literal(-1.25) - t45;
    let t47 = t42 * t41;
    let t48 = R::literal(1.0) / (t46 - t47);
    let t49 = t15 * t0;
    let t50 = t44 * t41;
    let t51 = t49 - t50;
    let t52 = t51 * t48;
    let t53 = R::literal(1.25) - t45 - t47;
    let t54 = t53 * t48;
    let t55 = t18 * t3;
    let t56 = R::literal(1.0)
        / (t39 - R::literal(0.833_333_333_333_333_4) - t55)
            .sub_product(t44, t43)
            .sub_product(t52, t51);
    let t57 = t19 * t3;
    let t58 = (t41 + t57).sub_product(t42, t43).sub_product(t54, t51);
    let t59 = t58 * t56;
    let t60 = R::literal(0.833_333_333_333_333_4) - t55;
    let t61 = t60 * t56;
    let t62 = t57 * t56;
    let t63 = t21 * t3;
    let t64 = R::literal(0.833_333_333_333_333_4) + t63;
    let t65 = t64 * t56;
    let t66 = t23 * t3;
    let t67 = t66 * t56;
    let t68 = -t67;
    let t69 = t19 * t2;
    let t70 = R::literal(1.0)
        / (t46 - R::literal(0.833_333_333_333_333_4) - t69 - t47)
            .sub_product(t54, t53)
            .sub_product(t59, t58);
    let t71 = t18 * t2;
    let t72 = t61 * t58;
    let t73 = t71 - t72;
    let t74 = t73 * t70;
    let t75 = (R::literal(0.833_333_333_333_333_4) - t69).sub_product(t62, t58);
    let t76 = t75 * t70;
    let t77 = -(t21 * t2);
    let t78 = t77.sub_product(t65, t58);
    let t79 = t78 * t70;
    let t80 = t23 * t2;
    let t81 = (R::literal(0.833_333_333_333_333_4) + t80).add_product(t67, t58);
    let t82 = t81 * t70;
    let t83 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t55
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t27, t5)
            .sub_product(t61, t60)
            .sub_product(t74, t73);
    let t84 = t57.add_product(t28, t5).sub_product(t62, t60).sub_product(t76, t73);
    let t85 = t84 * t83;
    let t86 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t87 = t86 * t83;
    let t88 = -t87;
    let t89 = (-t24).add_product(t30, t5);
    let t90 = t89 * t83;
    let t91 = (R::literal(-0.833_333_333_333_333_4) + t63)
        .sub_product(t65, t60)
        .sub_product(t79, t73);
    let t92 = t91 * t83;
    let t93 = (-t66).add_product(t67, t60).sub_product(t82, t73);
    let t94 = t93 * t83;
    let t95 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t69
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t28, t4)
            .sub_product(t62, t57)
            .sub_product(t76, t75)
            .sub_product(t85, t84);
    let t96 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t87, t84);
    let t97 = t96 * t95;
    let t98 = t25.sub_product(t30, t4).sub_product(t90, t84);
    let t99 = t98 * t95;
    let t100 = t77.sub_product(t65, t57).sub_product(t79, t75).sub_product(t92, t84);
    let t101 = t100 * t95;
    let t102 = (R::literal(-0.833_333_333_333_333_4) + t80)
        .add_product(t67, t57)
        .sub_product(t82, t75)
        .sub_product(t94, t84);
    let t103 = t102 * t95;
    let t104 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t87, t86).sub_product(t97, t96);
    let t105 = (-t30).add_product(t90, t86);
    let t106 = t99 * t96;
    let t107 = t105 - t106;
    let t108 = t107 * t104;
    let t109 = t35 * t104;
    let t110 = t37 * t104;
    let t111 = -t110;
    let t112 = t92 * t86;
    let t113 = t101 * t96;
    let t114 = t112 - t113;
    let t115 = t114 * t104;
    let t116 = (t94 * t86).sub_product(t103, t96);
    let t117 = t116 * t104;
    let t118 = R::literal(1.0)
        / (-(t25 * cos_cylinder_phi))
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t30, slide)
            .sub_product(t32, sin_cylinder_phi)
            .sub_product(t34, cos_cylinder_phi)
            .sub_product(t90, t89)
            .sub_product(t99, t98)
            .sub_product(t108, t107);
    let t119 = t32.sub_product(t109, t107);
    let t120 = t119 * t118;
    let t121 = (-t34).add_product(t110, t107);
    let t122 = t121 * t118;
    let t123 = (-(t92 * t89)).sub_product(t101, t98);
    let t124 = t115 * t107;
    let t125 = t123 - t124;
    let t126 = t125 * t118;
    let t127 = (-(t94 * t89)).sub_product(t103, t98);
    let t128 = t117 * t107;
    let t129 = t127 - t128;
    let t130 = t129 * t118;
    let t131 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t35, t6)
            .sub_product(t109, t35)
            .sub_product(t120, t119);
    let t132 = (t37 * t6).add_product(t110, t35).sub_product(t122, t119);
    let t133 = t132 * t131;
    let t134 = (-(t115 * t35)).sub_product(t126, t119);
    let t135 = t134 * t131;
    let t136 = (-(t117 * t35)).sub_product(t130, t119);
    let t137 = t136 * t131;
    let t138 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t37, R::literal(0.06) * cos_rod_phi)
            .sub_product(t110, t37)
            .sub_product(t122, t121)
            .sub_product(t133, t132);
    let t139 = (t115 * t37).sub_product(t126, t121).sub_product(t135, t132);
    let t140 = t139 * t138;
    let t141 = (t117 * t37).sub_product(t130, t121).sub_product(t137, t132);
    let t142 = t141 * t138;
    let t143 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t21, t13)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t65, t64)
            .sub_product(t79, t78)
            .sub_product(t92, t91)
            .sub_product(t101, t100)
            .sub_product(t115, t114)
            .sub_product(t126, t125)
            .sub_product(t135, t134)
            .sub_product(t140, t139);
    let t144 = (t23 * t13)
        .add_product(t67, t64)
        .sub_product(t82, t78)
        .sub_product(t94, t91)
        .sub_product(t103, t100)
        .sub_product(t117, t114)
        .sub_product(t130, t125)
        .sub_product(t137, t134)
        .sub_product(t142, t139);
    let t145 = t144 * t143;
    let t146 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t23, t14)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t67, t66)
            .sub_product(t82, t81)
            .sub_product(t94, t93)
            .sub_product(t103, t102)
            .sub_product(t117, t116)
            .sub_product(t130, t129)
            .sub_product(t137, t136)
            .sub_product(t142, t141)
            .sub_product(t145, t144);
    let t147 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(R::literal(1_000_000.0) * stop_gap * t7))
            .sub_product(R::literal(1500.0) * stop_rate, t7),
    );
    let t148 = p.spring_stiffness * (slide - R::literal(0.116));
    let t149 = t148 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t150 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t151 = t149 + t150;
    let t152 = t148 * sin_cylinder_phi;
    let t153 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t154 = t153 - (R::literal(2.943) - t152);
    let t155 = t148 * t12;
    let t156 = (-t155).sub_product(spring_damping_times_slide_rate, t12);
    let t157 = -t149 - t150;
    let t158 = -t153 - (R::literal(1.962) + t152);
    let t159 = contact_stiffness_times_contact_gap * t8;
    let t160 = t159 / between;
    let t161 = contact_damping_times_contact_rate * t8;
    let t162 = contact_stiffness_times_contact_gap * t10 / between;
    let t163 = contact_damping_times_contact_rate * t10;
    let t164 = R::literal(0.1) * (post_omega * post_omega);
    let t165 = t164 * cos_post_phi;
    let t166 = t164 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t167 = R::literal(0.06) * plate_omega_squared;
    let t168 = t167 * cos_plate_phi;
    let t169 = t167 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t170 = R::literal(0.06) * (rod_omega * rod_omega);
    let t171 = t170 * cos_rod_phi;
    let t172 = t170 * sin_rod_phi;
    let t173 = t15 * t147;
    let t174 = -t165 - t173;
    let t175 = t16 * t147;
    let t176 = t42 * t174;
    let t177 = -t166 - R::literal(-9.81) + t175 - t176;
    let t178 = (-(t168 + t165) - t173).sub_product(t44, t174).sub_product(t52, t177);
    let t179 = (-(t169 + t166) - R::literal(9.81) + t175 - R::literal(-9.81) - t176)
        .sub_product(t54, t177)
        .sub_product(t59, t178);
    let t180 = R::literal(3.333_333_333_333_333_5) * t151;
    let t181 = (-t180)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t27, t156)
        .sub_product(t61, t178)
        .sub_product(t74, t179);
    let t182 = R::literal(3.333_333_333_333_333_5) * t154;
    let t183 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t182)
        .add_product(t28, t156)
        .sub_product(t62, t178)
        .sub_product(t76, t179)
        .sub_product(t85, t181);
    let t184 = (-(R::literal(-2_777.777_777_777_778) * t156))
        .add_product(t87, t181)
        .sub_product(t97, t183);
    let t185 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t24, t151)
        .add_product(t25, t154)
        .add_product(t30, t156)
        .add_product(t32, t157)
        .sub_product(t34, t158)
        .sub_product(t90, t181)
        .sub_product(t99, t183);
    let t186 = t185.sub_product(t108, t184);
    let t187 = R::literal(5.0) * t157;
    let t188 = (t171 - t187).sub_product(t109, t184).sub_product(t120, t186);
    let t189 = R::literal(5.0) * t158;
    let t190 = (t172 - t189)
        .add_product(t110, t184)
        .sub_product(t122, t186)
        .sub_product(t133, t188);
    let t191 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -t160 - t161 / between,
        );
    let t192 = (-t191)
        .add_product(t14, plate_omega_squared)
        .sub_product(t65, t178)
        .sub_product(t79, t179)
        .sub_product(t92, t181)
        .sub_product(t101, t183)
        .sub_product(t115, t184)
        .sub_product(t126, t186)
        .sub_product(t135, t188)
        .sub_product(t140, t190);
    let t193 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(t163 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    t162,
                )));
    let t194 = (R::literal(-9.81).add_product(t13, plate_omega_squared) - t193)
        .add_product(t67, t178)
        .sub_product(t82, t179)
        .sub_product(t94, t181)
        .sub_product(t103, t183)
        .sub_product(t117, t184)
        .sub_product(t130, t186)
        .sub_product(t137, t188)
        .sub_product(t142, t190)
        .sub_product(t145, t192) * t146;
    let t195 = (t192 * t143).sub_product(t145, t194);
    let t196 = (t190 * t138).sub_product(t140, t195).sub_product(t142, t194);
    let t197 = (t188 * t131)
        .sub_product(t133, t196)
        .sub_product(t135, t195)
        .sub_product(t137, t194);
    let t198 = (t186 * t118)
        .sub_product(t120, t197)
        .sub_product(t122, t196)
        .sub_product(t126, t195);
    let t199 = t130 * t194;
    let t200 = t198 - t199;
    let t201 = (t184 * t104)
        .sub_product(t108, t200)
        .sub_product(t109, t197)
        .add_product(t110, t196)
        .sub_product(t115, t195)
        .sub_product(t117, t194);
    let t202 = (t183 * t95)
        .sub_product(t97, t201)
        .sub_product(t99, t200)
        .sub_product(t101, t195);
    let t203 = t202.sub_product(t103, t194);
    let t204 = (t181 * t83)
        .sub_product(t85, t203)
        .add_product(t87, t201)
        .sub_product(t90, t200)
        .sub_product(t92, t195);
    let t205 = t204.sub_product(t94, t194);
    let t206 = (t179 * t70)
        .sub_product(t74, t205)
        .sub_product(t76, t203)
        .sub_product(t79, t195)
        .sub_product(t82, t194);
    let t207 = (t178 * t56)
        .sub_product(t59, t206)
        .sub_product(t61, t205)
        .sub_product(t62, t203)
        .sub_product(t65, t195)
        .add_product(t67, t194);
    let t208 = (t177 * t48).sub_product(t52, t207).sub_product(t54, t206);
    let t209 = (t174 * t40)
        .sub_product(t42, t208)
        .sub_product(t44, t207)
        .sub_product(t42, t206);
    let bobbin_v_y_dot = t193.sub_product(R::literal(1.428_571_428_571_428_6), t194);
    let bobbin_v_x_dot = t191.sub_product(R::literal(1.428_571_428_571_428_6), t195);
    let rod_omega_dot = (t35 * t197)
        .sub_product(R::literal(4_166.666_666_666_667), t201)
        .sub_product(t37, t196);
    let rod_v_y_dot = t189.sub_product(t34, t200).sub_product(R::literal(5.0), t196);
    let rod_v_x_dot = t187.add_product(t32, t200).sub_product(R::literal(5.0), t197);
    let cylinder_omega_dot = (t156 * R::literal(2_777.777_777_777_778))
        .sub_product(t27, t205)
        .add_product(t28, t203)
        .sub_product(R::literal(-2_777.777_777_777_778), t201)
        .add_product(t30, t200);
    let cylinder_v_y_dot = t182
        .sub_product(R::literal(3.333_333_333_333_333_5), t203)
        .add_product(t25, t200);
    let cylinder_v_x_dot = t180
        .sub_product(R::literal(3.333_333_333_333_333_5), t205)
        .sub_product(t24, t200);
    let plate_omega_dot = (t19 * t206)
        .sub_product(t18, t207)
        .sub_product(t18, t205)
        .add_product(t19, t203)
        .add_product(t21, t195)
        .sub_product(t23, t194);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t206)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t203)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t194);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t205))
        .sub_product(R::literal(0.833_333_333_333_333_4), t207)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t195);
    let post_omega_dot = (t147 * R::literal(370.370_370_370_370_3))
        .sub_product(t15, t209)
        .add_product(t16, t208)
        .sub_product(t15, t207)
        .add_product(t16, t206);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t208)
        .sub_product(R::literal(-1.25), t206);
    let post_v_x_dot = (-(R::literal(-1.25) * t207)).sub_product(R::literal(1.25), t209);
    Motion {
        factors: [
            R::literal(3.333_333_333_333_333_5),
            t27,
            t29,
            t85,
            R::literal(-2_777.777_777_777_778),
            t88,
            t97,
            t24,
            t26,
            t31,
            t33,
            t34,
            t90,
            t99,
            t108,
            R::literal(5.0),
            t109,
            t120,
            t111,
            t122,
            t133,
            R::literal(1.428_571_428_571_428_6),
            t92,
            t101,
            t115,
            t126,
            t135,
            t140,
            t94,
            t103,
            t117,
            t130,
            t137,
            t142,
            t145,
            t146,
            t143,
            t138,
            t131,
            t118,
            t104,
            t95,
            t83,
            t74,
            t76,
            t79,
            t82,
            t59,
            t61,
            t62,
            t65,
            t68,
            t52,
            t54,
            t42,
            t44,
            R::literal(4_166.666_666_666_667),
            t36,
            t37,
            R::literal(2_777.777_777_777_778),
            t18,
            t20,
            t22,
            t23,
            R::literal(0.833_333_333_333_333_4),
            R::literal(-0.833_333_333_333_333_4),
            t15,
            t17,
            R::literal(1.25),
            R::literal(-1.25),
        ],
        cos_post_phi,
        sin_post_phi,
        cos_plate_phi,
        sin_plate_phi,
        cos_cylinder_phi,
        sin_cylinder_phi,
        cos_rod_phi,
        sin_rod_phi,
        stop_gap,
        t7,
        t9,
        t11,
        between,
        slide,
        contact_rate,
        t12,
        slide_rate,
        t13,
        t14,
        t38,
        t40,
        t41,
        t48,
        t49,
        t50,
        t53,
        t55,
        t56,
        t57,
        t58,
        t63,
        t66,
        t70,
        t71,
        t72,
        t75,
        t81,
        t84,
        t91,
        t98,
        t100,
        t105,
        t106,
        t112,
        t113,
        t116,
        t123,
        t124,
        t127,
        t128,
        t144,
        t149,
        t152,
        t155,
        t159,
        t160,
        t161,
        t162,
        t163,
        t165,
        t166,
        t168,
        t169,
        t171,
        t172,
        t194,
        t195,
        t196,
        t197,
        t198,
        t199,
        t202,
        t204,
        t206,
        t207,
        t208,
        t209,
        bobbin_v_y_dot,
        bobbin_v_x_dot,
        rod_omega_dot,
        rod_v_y_dot,
        rod_v_x_dot,
        cylinder_omega_dot,
        cylinder_v_y_dot,
        cylinder_v_x_dot,
        plate_omega_dot,
        plate_v_y_dot,
        plate_v_x_dot,
        post_omega_dot,
        post_v_y_dot,
        post_v_x_dot,
    }
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
/// 4430 operations.
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
/// 4429 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 294] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, _, rod_x, rod_y, _, bobbin_x,
    bobbin_y, _, _, post_omega, _, _, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, contact_closed,
    stop_closed] = *state;
    let m = &motion(time, state, p, c);
    let t0 = R::literal(0.1) * m.cos_post_phi;
    let t1 = R::literal(0.1) * m.sin_post_phi;
    let t2 = R::literal(0.06) * m.cos_plate_phi;
    let t3 = R::literal(0.06) * m.sin_plate_phi;
    let t4 = R::literal(0.06) * m.cos_cylinder_phi;
    let t5 = R::literal(0.06) * m.sin_cylinder_phi;
    let t6 = R::literal(0.06) * m.cos_rod_phi;
    let t7 = R::literal(0.06) * m.sin_rod_phi;
    let stop_rate = post_omega * m.t7;
    let t8 = bobbin_x - R::literal(0.328);
    let t9 = bobbin_y - R::literal(0.058);
    let contact_gap = m.between - R::literal(0.1);
    let contact_stiffness_times_contact_gap = p.contact_stiffness * contact_gap;
    let t10 = (R::literal(0.1) * m.sin_plate_phi)
        .sub_product(R::literal(0.01), m.cos_plate_phi);
    let t11 = R::literal(37.037_037_037_037_03) * m.cos_post_phi;
    let t12 = R::literal(24.0) * m.cos_plate_phi;
    let t13 = m.t13 * R::literal(400.0);
    let t14 = m.cos_cylinder_phi * R::literal(3.333_333_333_333_333_5);
    let t15 = R::literal(166.666_666_666_666_66) * m.cos_cylinder_phi;
    let t16 = m.slide * R::literal(2_777.777_777_777_778);
    let t17 = m.sin_cylinder_phi * R::literal(5.0);
    let t18 = R::literal(250.0) * m.sin_rod_phi;
    let t19 = m.t66 * m.t56;
    let t20 = R::literal(-166.666_666_666_666_66) * m.sin_cylinder_phi * m.factors[42];
    let t21 = m.factors[58] * m.factors[40];
    let t22 = p.spring_damping * m.slide_rate;
    let t23 = t22 * m.cos_cylinder_phi;
    let t24 = t22 * m.sin_cylinder_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t25 = cylinder_omega_squared * m.cos_cylinder_phi;
    let t26 = cylinder_omega_squared * m.sin_cylinder_phi;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t27 = m.t198 - m.t199;
    let t28 = m.t202.sub_product(m.factors[29], m.t194);
    let t29 = m.t204.sub_product(m.factors[28], m.t194);
    let t30 = m.t7 * m.t7;
    let t31 = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (R::literal(3000.0) * m.stop_gap * stop_rate)
                .add_product(R::literal(1_000_000.0), m.stop_gap * m.stop_gap)
                .sub_product(R::literal(1_000_000.0), t30),
        )
        .sub_product(t0, m.t209)
        .sub_product(t1, m.t208)
        .sub_product(t0, m.t207)
        .sub_product(t1, m.t206);
    let t32 = (-(t3 * m.t206))
        .sub_product(t2, m.t207)
        .sub_product(t2, t29)
        .sub_product(t3, t28)
        .sub_product(t10, m.t195)
        .add_product(m.t13, m.t194);
    let t33 = p.spring_stiffness * m.cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t34 = spring_damping_times_cylinder_omega * m.sin_cylinder_phi;
    let t35 = t34 - t33;
    let t36 = t35 * m.cos_cylinder_phi;
    let t37 = t35 * m.sin_cylinder_phi;
    let t38 = spring_damping_times_cylinder_omega * m.t12;
    let t39 = t38 * m.sin_cylinder_phi;
    let t40 = p.spring_stiffness * m.t12;
    let t41 = t40 * m.cos_cylinder_phi;
    let t42 = t33 - t34;
    let t43 = t42 * m.cos_cylinder_phi;
    let t44 = t42 * m.sin_cylinder_phi;
    let t45 = m.cos_cylinder_phi * t27;
    let t46 = t41 - t39 - m.t152 - t24 - t45;
    let t47 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t48 = (p.spring_stiffness * m.sin_cylinder_phi)
        .add_product(spring_damping_times_cylinder_omega, m.cos_cylinder_phi);
    let t49 = t48 * m.cos_cylinder_phi;
    let t50 = t48 * m.sin_cylinder_phi;
    let t51 = t38 * m.cos_cylinder_phi;
    let t52 = t40 * m.sin_cylinder_phi;
    let t53 = m.sin_cylinder_phi * t27;
    let t54 = t51 + m.t149 + t52 + t23 - t53;
    let t55 = m.sin_cylinder_phi * m.cylinder_omega_dot;
    let t56 = p.spring_damping
        * (-(cylinder_omega * m.slide))
            .add_product(rod_v_y - cylinder_v_y, m.cos_cylinder_phi)
            .sub_product(rod_v_x - cylinder_v_x, m.sin_cylinder_phi);
    let t57 = t56 * m.cos_cylinder_phi;
    let t58 = t56 * m.sin_cylinder_phi;
    let t59 = m.t12 * m.t12;
    let t60 = R::literal(0.06) * cylinder_omega_squared;
    let t61 = t41 + t57 - m.t152 - t24 - t45;
    let t62 = t23 + t58 - (-m.t149 - t52) - t53;
    let t63 = ((rod_x - cylinder_x) * m.sin_cylinder_phi)
        .sub_product(rod_y - cylinder_y, m.cos_cylinder_phi);
    let t64 = (p.spring_stiffness * m.slide * (m.slide - R::literal(0.116)))
        .add_product(p.spring_damping * m.slide, m.slide_rate)
        .sub_product(p.spring_stiffness, t59)
        .sub_product(t56, m.t12)
        .sub_product(t4, t29)
        .sub_product(t5, t28)
        .sub_product(t63, t27);
    let t65 = m.t152 + t24 - t41 - t57 + t45;
    let t66 = -t23 - t58 - (m.t149 + t52) + t53;
    let t67 = t39 + m.t152 + t24 - t41 + t45;
    let t68 = -t51 - m.t149 - t52 - t23 + t53;
    let t69 = (t6 * m.t197).add_product(t7, m.t196);
    let t70 = m.between * m.between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t71 = contact_stiffness_times_contact_gap / m.between;
    let t72 = p.contact_damping * m.contact_rate / m.between;
    let t73 = t70 * m.between;
    let t74 = c.t0 * m.contact_rate;
    let t75 = t74 * t8 * t9 / t73;
    let t76 = m.t159 * t9 / t73;
    let t77 = p.contact_stiffness * t8 * t9 / t70;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t78 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1500.0) * t30),
    );
    let t79 = R::literal(0.2) * post_omega;
    let t80 = R::literal(0.12) * plate_omega;
    let t81 = t80 * m.cos_plate_phi;
    let t82 = t80 * m.sin_plate_phi;
    let t83 = p.spring_damping * (m.cos_cylinder_phi * m.cos_cylinder_phi);
    let t84 = p.spring_damping * m.sin_cylinder_phi * m.cos_cylinder_phi;
    let t85 = p.spring_damping * m.t12;
    let t86 = t85 * m.cos_cylinder_phi;
    let t87 = R::literal(2.0) * cylinder_omega;
    let t88 = t87 * m.cos_cylinder_phi;
    let t89 = p.spring_damping * (m.sin_cylinder_phi * m.sin_cylinder_phi);
    let t90 = t85 * m.sin_cylinder_phi;
    let t91 = t87 * m.sin_cylinder_phi;
    let t92 = p.spring_damping * t59;
    let t93 = R::literal(0.12) * cylinder_omega;
    let t94 = R::literal(0.12) * rod_omega;
    let t95 = t94 * m.cos_rod_phi;
    let t96 = m.t166.sub_product(t0, m.post_omega_dot).sub_product(m.factors[66], t31);
    let t97 = (-m.t165)
        .sub_product(t1, m.post_omega_dot)
        .add_product(t11, t31)
        .sub_product(m.factors[54], t96);
    let t98 = t96.sub_product(m.factors[55], t96).sub_product(m.factors[52], t97);
    let t99 = t97.sub_product(m.factors[53], t97).sub_product(m.factors[47], t98);
    let t100 = (-(m.factors[48] * t98)).sub_product(m.factors[43], t99);
    let t101 = (-(m.factors[49] * t98))
        .sub_product(m.factors[44], t99)
        .sub_product(m.factors[3], t100);
    let t102 = (t20 * t100).sub_product(m.factors[6], t101);
    let t103 = (-(m.factors[12] * t100))
        .sub_product(m.factors[13], t101)
        .sub_product(m.factors[14], t102);
    let t104 = (-(m.factors[16] * t102)).sub_product(m.factors[17], t103);
    let t105 = (t21 * t102)
        .sub_product(m.factors[19], t103)
        .sub_product(m.factors[20], t104);
    let t106 = (-(m.factors[50] * t98))
        .sub_product(m.factors[45], t99)
        .sub_product(m.factors[22], t100)
        .sub_product(m.factors[23], t101)
        .sub_product(m.factors[24], t102)
        .sub_product(m.factors[25], t103)
        .sub_product(m.factors[26], t104)
        .sub_product(m.factors[27], t105);
    let t107 = (t19 * t98)
        .sub_product(m.factors[46], t99)
        .sub_product(m.factors[28], t100)
        .sub_product(m.factors[29], t101)
        .sub_product(m.factors[30], t102)
        .sub_product(m.factors[31], t103)
        .sub_product(m.factors[32], t104)
        .sub_product(m.factors[33], t105)
        .sub_product(m.factors[34], t106) * m.factors[35];
    let t108 = (t106 * m.factors[36]).sub_product(m.factors[34], t107);
    let t109 = (t105 * m.factors[37])
        .sub_product(m.factors[27], t108)
        .sub_product(m.factors[33], t107);
    let t110 = (t104 * m.factors[38])
        .sub_product(m.factors[20], t109)
        .sub_product(m.factors[26], t108)
        .sub_product(m.factors[32], t107);
    let t111 = (t103 * m.factors[39])
        .sub_product(m.factors[17], t110)
        .sub_product(m.factors[19], t109)
        .sub_product(m.factors[25], t108)
        .sub_product(m.factors[31], t107);
    let t112 = (t102 * m.factors[40])
        .sub_product(m.factors[14], t111)
        .sub_product(m.factors[16], t110)
        .add_product(t21, t109)
        .sub_product(m.factors[24], t108)
        .sub_product(m.factors[30], t107);
    let t113 = (t101 * m.factors[41])
        .sub_product(m.factors[6], t112)
        .sub_product(m.factors[13], t111)
        .sub_product(m.factors[23], t108)
        .sub_product(m.factors[29], t107);
    let t114 = (t100 * m.factors[42])
        .sub_product(m.factors[3], t113)
        .add_product(t20, t112)
        .sub_product(m.factors[12], t111)
        .sub_product(m.factors[22], t108)
        .sub_product(m.factors[28], t107);
    let t115 = (t99 * m.t70)
        .sub_product(m.factors[43], t114)
        .sub_product(m.factors[44], t113)
        .sub_product(m.factors[45], t108)
        .sub_product(m.factors[46], t107);
    let t116 = (t98 * m.t56)
        .sub_product(m.factors[47], t115)
        .sub_product(m.factors[48], t114)
        .sub_product(m.factors[49], t113)
        .sub_product(m.factors[50], t108)
        .add_product(t19, t107);
    let t117 = (t97 * m.t48)
        .sub_product(m.factors[52], t116)
        .sub_product(m.factors[53], t115);
    let t118 = (t96 * m.t40)
        .sub_product(m.factors[54], t117)
        .sub_product(m.factors[55], t116)
        .sub_product(m.factors[54], t115);
    let bobbin_v_y_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t107);
    let bobbin_v_x_dot_by_post_phi = -(R::literal(1.428_571_428_571_428_6) * t108);
    let rod_omega_dot_by_post_phi = (t18 * t110)
        .sub_product(R::literal(4_166.666_666_666_667), t112)
        .sub_product(m.factors[58], t109);
    let rod_v_y_dot_by_post_phi = (-(R::literal(5.0) * t109))
        .sub_product(m.factors[11], t111);
    let rod_v_x_dot_by_post_phi = (-(R::literal(5.0) * t110)).add_product(t17, t111);
    let cylinder_omega_dot_by_post_phi = (t15 * t113)
        .sub_product(m.factors[1], t114)
        .sub_product(R::literal(-2_777.777_777_777_778), t112)
        .add_product(t16, t111);
    let cylinder_v_y_dot_by_post_phi = (t14 * t111)
        .sub_product(R::literal(3.333_333_333_333_333_5), t113);
    let cylinder_v_x_dot_by_post_phi = (-(m.factors[7] * t111))
        .sub_product(R::literal(3.333_333_333_333_333_5), t114);
    let plate_omega_dot_by_post_phi = (t12 * t115)
        .sub_product(m.factors[60], t116)
        .sub_product(m.factors[60], t114)
        .add_product(t12, t113)
        .add_product(t13, t108)
        .sub_product(m.factors[63], t107);
    let plate_v_y_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t113))
        .sub_product(R::literal(0.833_333_333_333_333_4), t115)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t107);
    let plate_v_x_dot_by_post_phi = (-(R::literal(-0.833_333_333_333_333_4) * t114))
        .sub_product(R::literal(0.833_333_333_333_333_4), t116)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t108);
    let post_omega_dot_by_post_phi = (t31 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[66], t118)
        .add_product(t11, t117)
        .sub_product(m.factors[66], t116)
        .add_product(t11, t115);
    let post_v_y_dot_by_post_phi = (-(R::literal(-1.25) * t115))
        .sub_product(R::literal(1.25), t117);
    let post_v_x_dot_by_post_phi = (-(R::literal(-1.25) * t116))
        .sub_product(R::literal(1.25), t118);
    let t119 = m.t169.sub_product(t2, m.plate_omega_dot).sub_product(m.factors[60], t32);
    let t120 = (-m.t168).sub_product(t3, m.plate_omega_dot).add_product(t12, t32);
    let t121 = t120.sub_product(m.factors[47], t119);
    let t122 = t119.sub_product(m.factors[48], t119).sub_product(m.factors[43], t121);
    let t123 = t120
        .sub_product(m.factors[49], t119)
        .sub_product(m.factors[44], t121)
        .sub_product(m.factors[3], t122);
    let t124 = (t20 * t122).sub_product(m.factors[6], t123);
    let t125 = (-(m.factors[12] * t122))
        .sub_product(m.factors[13], t123)
        .sub_product(m.factors[14], t124);
    let t126 = (-(m.factors[16] * t124)).sub_product(m.factors[17], t125);
    let t127 = (t21 * t124)
        .sub_product(m.factors[19], t125)
        .sub_product(m.factors[20], t126);
    let t128 = (-(t10 * m.plate_omega_dot))
        .add_product(
            (-(R::literal(0.01) * m.sin_plate_phi))
                .sub_product(R::literal(0.1), m.cos_plate_phi),
            plate_omega_squared,
        )
        .add_product(t13, t32)
        .sub_product(m.factors[50], t119)
        .sub_product(m.factors[45], t121)
        .sub_product(m.factors[22], t122)
        .sub_product(m.factors[23], t123)
        .sub_product(m.factors[24], t124)
        .sub_product(m.factors[25], t125)
        .sub_product(m.factors[26], t126)
        .sub_product(m.factors[27], t127);
    let t129 = (m.t13 * m.plate_omega_dot)
        .add_product(m.t14, plate_omega_squared)
        .sub_product(m.factors[63], t32)
        .add_product(t19, t119)
        .sub_product(m.factors[46], t121)
        .sub_product(m.factors[28], t122)
        .sub_product(m.factors[29], t123)
        .sub_product(m.factors[30], t124)
        .sub_product(m.factors[31], t125)
        .sub_product(m.factors[32], t126)
        .sub_product(m.factors[33], t127)
        .sub_product(m.factors[34], t128) * m.factors[35];
    let t130 = (t128 * m.factors[36]).sub_product(m.factors[34], t129);
    let t131 = (t127 * m.factors[37])
        .sub_product(m.factors[27], t130)
        .sub_product(m.factors[33], t129);
    let t132 = (t126 * m.factors[38])
        .sub_product(m.factors[20], t131)
        .sub_product(m.factors[26], t130)
        .sub_product(m.factors[32], t129);
    let t133 = (t125 * m.factors[39])
        .sub_product(m.factors[17], t132)
        .sub_product(m.factors[19], t131)
        .sub_product(m.factors[25], t130)
        .sub_product(m.factors[31], t129);
    let t134 = (t124 * m.factors[40])
        .sub_product(m.factors[14], t133)
        .sub_product(m.factors[16], t132)
        .add_product(t21, t131)
        .sub_product(m.factors[24], t130)
        .sub_product(m.factors[30], t129);
    let t135 = (t123 * m.factors[41])
        .sub_product(m.factors[6], t134)
        .sub_product(m.factors[13], t133)
        .sub_product(m.factors[23], t130)
        .sub_product(m.factors[29], t129);
    let t136 = (t122 * m.factors[42])
        .sub_product(m.factors[3], t135)
        .add_product(t20, t134)
        .sub_product(m.factors[12], t133)
        .sub_product(m.factors[22], t130)
        .sub_product(m.factors[28], t129);
    let t137 = (t121 * m.t70)
        .sub_product(m.factors[43], t136)
        .sub_product(m.factors[44], t135)
        .sub_product(m.factors[45], t130)
        .sub_product(m.factors[46], t129);
    let t138 = (t119 * m.t56)
        .sub_product(m.factors[47], t137)
        .sub_product(m.factors[48], t136)
        .sub_product(m.factors[49], t135)
        .sub_product(m.factors[50], t130)
        .add_product(t19, t129);
    let t139 = (-(m.factors[53] * t137)).sub_product(m.factors[52], t138);
    let t140 = (-(m.factors[55] * t138))
        .sub_product(m.factors[54], t139)
        .sub_product(m.factors[54], t137);
    let bobbin_v_y_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t129);
    let bobbin_v_x_dot_by_plate_phi = -(R::literal(1.428_571_428_571_428_6) * t130);
    let rod_omega_dot_by_plate_phi = (t18 * t132)
        .sub_product(R::literal(4_166.666_666_666_667), t134)
        .sub_product(m.factors[58], t131);
    let rod_v_y_dot_by_plate_phi = (-(R::literal(5.0) * t131))
        .sub_product(m.factors[11], t133);
    let rod_v_x_dot_by_plate_phi = (-(R::literal(5.0) * t132)).add_product(t17, t133);
    let cylinder_omega_dot_by_plate_phi = (t15 * t135)
        .sub_product(m.factors[1], t136)
        .sub_product(R::literal(-2_777.777_777_777_778), t134)
        .add_product(t16, t133);
    let cylinder_v_y_dot_by_plate_phi = (t14 * t133)
        .sub_product(R::literal(3.333_333_333_333_333_5), t135);
    let cylinder_v_x_dot_by_plate_phi = (-(m.factors[7] * t133))
        .sub_product(R::literal(3.333_333_333_333_333_5), t136);
    let plate_omega_dot_by_plate_phi = (t32 * R::literal(400.0))
        .sub_product(m.factors[60], t138)
        .add_product(t12, t137)
        .sub_product(m.factors[60], t136)
        .add_product(t12, t135)
        .add_product(t13, t130)
        .sub_product(m.factors[63], t129);
    let plate_v_y_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t135))
        .sub_product(R::literal(0.833_333_333_333_333_4), t137)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t129);
    let plate_v_x_dot_by_plate_phi = (-(R::literal(-0.833_333_333_333_333_4) * t136))
        .sub_product(R::literal(0.833_333_333_333_333_4), t138)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t130);
    let post_omega_dot_by_plate_phi = (t11 * t139)
        .sub_product(m.factors[66], t140)
        .sub_product(m.factors[66], t138)
        .add_product(t11, t137);
    let post_v_y_dot_by_plate_phi = (-(R::literal(-1.25) * t137))
        .sub_product(R::literal(1.25), t139);
    let post_v_x_dot_by_plate_phi = (-(R::literal(-1.25) * t138))
        .sub_product(R::literal(1.25), t140);
    let t141 = R::literal(3.333_333_333_333_333_5) * t36;
    let t142 = (-t141).sub_product(m.factors[1], t46);
    let t143 = R::literal(3.333_333_333_333_333_5) * t37;
    let t144 = (-t143).add_product(t15, t46).sub_product(m.factors[3], t142);
    let t145 = (-(R::literal(-2_777.777_777_777_778) * t46))
        .add_product(t20, t142)
        .sub_product(m.factors[6], t144);
    let t146 = (t26 - t47)
        .sub_product(m.factors[7], t36)
        .add_product(t14, t37)
        .add_product(t16, t46)
        .add_product(t17, t43)
        .sub_product(m.factors[11], t44)
        .sub_product(m.factors[12], t142)
        .sub_product(m.factors[13], t144)
        .sub_product(m.factors[14], t145);
    let t147 = R::literal(5.0) * t43;
    let t148 = (-t147).sub_product(m.factors[16], t145).sub_product(m.factors[17], t146);
    let t149 = R::literal(5.0) * t44;
    let t150 = (-t149)
        .add_product(t21, t145)
        .sub_product(m.factors[19], t146)
        .sub_product(m.factors[20], t148);
    let t151 = (-(m.factors[22] * t142))
        .sub_product(m.factors[23], t144)
        .sub_product(m.factors[24], t145)
        .sub_product(m.factors[25], t146)
        .sub_product(m.factors[26], t148)
        .sub_product(m.factors[27], t150);
    let t152 = (-(m.factors[28] * t142))
        .sub_product(m.factors[29], t144)
        .sub_product(m.factors[30], t145)
        .sub_product(m.factors[31], t146)
        .sub_product(m.factors[32], t148)
        .sub_product(m.factors[33], t150)
        .sub_product(m.factors[34], t151) * m.factors[35];
    let t153 = (t151 * m.factors[36]).sub_product(m.factors[34], t152);
    let t154 = (t150 * m.factors[37])
        .sub_product(m.factors[27], t153)
        .sub_product(m.factors[33], t152);
    let t155 = (t148 * m.factors[38])
        .sub_product(m.factors[20], t154)
        .sub_product(m.factors[26], t153)
        .sub_product(m.factors[32], t152);
    let t156 = (t146 * m.factors[39])
        .sub_product(m.factors[17], t155)
        .sub_product(m.factors[19], t154)
        .sub_product(m.factors[25], t153)
        .sub_product(m.factors[31], t152);
    let t157 = (t145 * m.factors[40])
        .sub_product(m.factors[14], t156)
        .sub_product(m.factors[16], t155)
        .add_product(t21, t154)
        .sub_product(m.factors[24], t153)
        .sub_product(m.factors[30], t152);
    let t158 = (t144 * m.factors[41])
        .sub_product(m.factors[6], t157)
        .sub_product(m.factors[13], t156)
        .sub_product(m.factors[23], t153)
        .sub_product(m.factors[29], t152);
    let t159 = (t142 * m.factors[42])
        .sub_product(m.factors[3], t158)
        .add_product(t20, t157)
        .sub_product(m.factors[12], t156)
        .sub_product(m.factors[22], t153)
        .sub_product(m.factors[28], t152);
    let t160 = (-(m.factors[44] * t158))
        .sub_product(m.factors[43], t159)
        .sub_product(m.factors[45], t153)
        .sub_product(m.factors[46], t152);
    let t161 = (-(m.factors[48] * t159))
        .sub_product(m.factors[47], t160)
        .sub_product(m.factors[49], t158)
        .sub_product(m.factors[50], t153)
        .add_product(t19, t152);
    let t162 = (-(m.factors[53] * t160)).sub_product(m.factors[52], t161);
    let t163 = (-(m.factors[55] * t161))
        .sub_product(m.factors[54], t162)
        .sub_product(m.factors[54], t160);
    let bobbin_v_y_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t152);
    let bobbin_v_x_dot_by_cylinder_x = -(R::literal(1.428_571_428_571_428_6) * t153);
    let rod_omega_dot_by_cylinder_x = (t18 * t155)
        .sub_product(R::literal(4_166.666_666_666_667), t157)
        .sub_product(m.factors[58], t154);
    let rod_v_y_dot_by_cylinder_x = t149
        .sub_product(m.factors[11], t156)
        .sub_product(R::literal(5.0), t154);
    let rod_v_x_dot_by_cylinder_x = t147
        .add_product(t17, t156)
        .sub_product(R::literal(5.0), t155);
    let cylinder_omega_dot_by_cylinder_x = (t46 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t159)
        .add_product(t15, t158)
        .sub_product(R::literal(-2_777.777_777_777_778), t157)
        .add_product(t16, t156);
    let cylinder_v_y_dot_by_cylinder_x = t143
        .sub_product(R::literal(3.333_333_333_333_333_5), t158)
        .add_product(t14, t156);
    let cylinder_v_x_dot_by_cylinder_x = t141
        .sub_product(R::literal(3.333_333_333_333_333_5), t159)
        .sub_product(m.factors[7], t156);
    let plate_omega_dot_by_cylinder_x = (t12 * t160)
        .sub_product(m.factors[60], t161)
        .sub_product(m.factors[60], t159)
        .add_product(t12, t158)
        .add_product(t13, t153)
        .sub_product(m.factors[63], t152);
    let plate_v_y_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t158))
        .sub_product(R::literal(0.833_333_333_333_333_4), t160)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t152);
    let plate_v_x_dot_by_cylinder_x = (-(R::literal(-0.833_333_333_333_333_4) * t159))
        .sub_product(R::literal(0.833_333_333_333_333_4), t161)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t153);
    let post_omega_dot_by_cylinder_x = (t11 * t162)
        .sub_product(m.factors[66], t163)
        .sub_product(m.factors[66], t161)
        .add_product(t11, t160);
    let post_v_y_dot_by_cylinder_x = (-(R::literal(-1.25) * t160))
        .sub_product(R::literal(1.25), t162);
    let post_v_x_dot_by_cylinder_x = (-(R::literal(-1.25) * t161))
        .sub_product(R::literal(1.25), t163);
    let t164 = R::literal(3.333_333_333_333_333_5) * t49;
    let t165 = -t164;
    let t166 = t164.sub_product(m.factors[1], t54);
    let t167 = R::literal(3.333_333_333_333_333_5) * t50;
    let t168 = t167.add_product(t15, t54).sub_product(m.factors[3], t166);
    let t169 = (-(R::literal(-2_777.777_777_777_778) * t54))
        .add_product(t20, t166)
        .sub_product(m.factors[6], t168);
    let t170 = m.factors[7] * t49;
    let t171 = t14 * t50;
    let t172 = t17 * t49;
    let t173 = m.factors[11] * t50;
    let t174 = ((-t25 - t55 + t170 - t171).add_product(t16, t54) + t172 - t173)
        .sub_product(m.factors[12], t166)
        .sub_product(m.factors[13], t168)
        .sub_product(m.factors[14], t169);
    let t175 = R::literal(5.0) * t49;
    let t176 = (-t175).sub_product(m.factors[16], t169).sub_product(m.factors[17], t174);
    let t177 = R::literal(5.0) * t50;
    let t178 = (-t177)
        .add_product(t21, t169)
        .sub_product(m.factors[19], t174)
        .sub_product(m.factors[20], t176);
    let t179 = (-(m.factors[22] * t166))
        .sub_product(m.factors[23], t168)
        .sub_product(m.factors[24], t169)
        .sub_product(m.factors[25], t174)
        .sub_product(m.factors[26], t176)
        .sub_product(m.factors[27], t178);
    let t180 = (-(m.factors[28] * t166))
        .sub_product(m.factors[29], t168)
        .sub_product(m.factors[30], t169)
        .sub_product(m.factors[31], t174)
        .sub_product(m.factors[32], t176)
        .sub_product(m.factors[33], t178)
        .sub_product(m.factors[34], t179) * m.factors[35];
    let t181 = (t179 * m.factors[36]).sub_product(m.factors[34], t180);
    let t182 = (t178 * m.factors[37])
        .sub_product(m.factors[27], t181)
        .sub_product(m.factors[33], t180);
    let t183 = (t176 * m.factors[38])
        .sub_product(m.factors[20], t182)
        .sub_product(m.factors[26], t181)
        .sub_product(m.factors[32], t180);
    let t184 = (t174 * m.factors[39])
        .sub_product(m.factors[17], t183)
        .sub_product(m.factors[19], t182)
        .sub_product(m.factors[25], t181)
        .sub_product(m.factors[31], t180);
    let t185 = (t169 * m.factors[40])
        .sub_product(m.factors[14], t184)
        .sub_product(m.factors[16], t183)
        .add_product(t21, t182)
        .sub_product(m.factors[24], t181)
        .sub_product(m.factors[30], t180);
    let t186 = (t168 * m.factors[41])
        .sub_product(m.factors[6], t185)
        .sub_product(m.factors[13], t184)
        .sub_product(m.factors[23], t181)
        .sub_product(m.factors[29], t180);
    let t187 = (t166 * m.factors[42])
        .sub_product(m.factors[3], t186)
        .add_product(t20, t185)
        .sub_product(m.factors[12], t184)
        .sub_product(m.factors[22], t181)
        .sub_product(m.factors[28], t180);
    let t188 = (-(m.factors[44] * t186))
        .sub_product(m.factors[43], t187)
        .sub_product(m.factors[45], t181)
        .sub_product(m.factors[46], t180);
    let t189 = (-(m.factors[48] * t187))
        .sub_product(m.factors[47], t188)
        .sub_product(m.factors[49], t186)
        .sub_product(m.factors[50], t181)
        .add_product(t19, t180);
    let t190 = (-(m.factors[53] * t188)).sub_product(m.factors[52], t189);
    let t191 = (-(m.factors[55] * t189))
        .sub_product(m.factors[54], t190)
        .sub_product(m.factors[54], t188);
    let bobbin_v_y_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t180);
    let bobbin_v_x_dot_by_cylinder_y = -(R::literal(1.428_571_428_571_428_6) * t181);
    let rod_omega_dot_by_cylinder_y = (t18 * t183)
        .sub_product(R::literal(4_166.666_666_666_667), t185)
        .sub_product(m.factors[58], t182);
    let rod_v_y_dot_by_cylinder_y = t177
        .sub_product(m.factors[11], t184)
        .sub_product(R::literal(5.0), t182);
    let rod_v_x_dot_by_cylinder_y = t175
        .add_product(t17, t184)
        .sub_product(R::literal(5.0), t183);
    let cylinder_omega_dot_by_cylinder_y = (t54 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t187)
        .add_product(t15, t186)
        .sub_product(R::literal(-2_777.777_777_777_778), t185)
        .add_product(t16, t184);
    let cylinder_v_y_dot_by_cylinder_y = (-t167)
        .sub_product(R::literal(3.333_333_333_333_333_5), t186)
        .add_product(t14, t184);
    let cylinder_v_x_dot_by_cylinder_y = t165
        .sub_product(R::literal(3.333_333_333_333_333_5), t187)
        .sub_product(m.factors[7], t184);
    let plate_omega_dot_by_cylinder_y = (t12 * t188)
        .sub_product(m.factors[60], t189)
        .sub_product(m.factors[60], t187)
        .add_product(t12, t186)
        .add_product(t13, t181)
        .sub_product(m.factors[63], t180);
    let plate_v_y_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t186))
        .sub_product(R::literal(0.833_333_333_333_333_4), t188)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t180);
    let plate_v_x_dot_by_cylinder_y = (-(R::literal(-0.833_333_333_333_333_4) * t187))
        .sub_product(R::literal(0.833_333_333_333_333_4), t189)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t181);
    let post_omega_dot_by_cylinder_y = (t11 * t190)
        .sub_product(m.factors[66], t191)
        .sub_product(m.factors[66], t189)
        .add_product(t11, t188);
    let post_v_y_dot_by_cylinder_y = (-(R::literal(-1.25) * t188))
        .sub_product(R::literal(1.25), t190);
    let post_v_x_dot_by_cylinder_y = (-(R::literal(-1.25) * t189))
        .sub_product(R::literal(1.25), t191);
    let t192 = R::literal(3.333_333_333_333_333_5) * t61;
    let t193 = ((-(t4 * m.cylinder_omega_dot)).add_product(t60, m.sin_cylinder_phi)
        - t192)
        .sub_product(m.factors[1], t64);
    let t194 = R::literal(3.333_333_333_333_333_5) * t62;
    let t195 = ((-(t5 * m.cylinder_omega_dot)).sub_product(t60, m.cos_cylinder_phi)
        - t194)
        .add_product(t15, t64)
        .sub_product(m.factors[3], t193);
    let t196 = (-(R::literal(-2_777.777_777_777_778) * t64))
        .add_product(t20, t193)
        .sub_product(m.factors[6], t195);
    let t197 = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot))
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
        .sub_product(t63, m.cylinder_omega_dot)
        .add_product(m.cos_cylinder_phi, m.rod_v_x_dot)
        .add_product(m.sin_cylinder_phi, m.rod_v_y_dot)
        .sub_product(m.factors[7], t61)
        .add_product(t14, t62)
        .add_product(t16, t64)
        .add_product(t17, t65)
        .sub_product(m.factors[11], t66)
        .sub_product(m.factors[12], t193);
    let t198 = t197.sub_product(m.factors[13], t195).sub_product(m.factors[14], t196);
    let t199 = R::literal(5.0) * t65;
    let t200 = (-t199).sub_product(m.factors[16], t196).sub_product(m.factors[17], t198);
    let t201 = R::literal(5.0) * t66;
    let t202 = (-t201)
        .add_product(t21, t196)
        .sub_product(m.factors[19], t198)
        .sub_product(m.factors[20], t200);
    let t203 = (-(m.factors[22] * t193))
        .sub_product(m.factors[23], t195)
        .sub_product(m.factors[24], t196)
        .sub_product(m.factors[25], t198)
        .sub_product(m.factors[26], t200)
        .sub_product(m.factors[27], t202);
    let t204 = (-(m.factors[28] * t193))
        .sub_product(m.factors[29], t195)
        .sub_product(m.factors[30], t196)
        .sub_product(m.factors[31], t198)
        .sub_product(m.factors[32], t200)
        .sub_product(m.factors[33], t202)
        .sub_product(m.factors[34], t203) * m.factors[35];
    let t205 = (t203 * m.factors[36]).sub_product(m.factors[34], t204);
    let t206 = (t202 * m.factors[37])
        .sub_product(m.factors[27], t205)
        .sub_product(m.factors[33], t204);
    let t207 = (t200 * m.factors[38])
        .sub_product(m.factors[20], t206)
        .sub_product(m.factors[26], t205)
        .sub_product(m.factors[32], t204);
    let t208 = (t198 * m.factors[39])
        .sub_product(m.factors[17], t207)
        .sub_product(m.factors[19], t206)
        .sub_product(m.factors[25], t205)
        .sub_product(m.factors[31], t204);
    let t209 = (t196 * m.factors[40])
        .sub_product(m.factors[14], t208)
        .sub_product(m.factors[16], t207)
        .add_product(t21, t206)
        .sub_product(m.factors[24], t205)
        .sub_product(m.factors[30], t204);
    let t210 = (t195 * m.factors[41])
        .sub_product(m.factors[6], t209)
        .sub_product(m.factors[13], t208)
        .sub_product(m.factors[23], t205)
        .sub_product(m.factors[29], t204);
    let t211 = (t193 * m.factors[42])
        .sub_product(m.factors[3], t210)
        .add_product(t20, t209)
        .sub_product(m.factors[12], t208)
        .sub_product(m.factors[22], t205)
        .sub_product(m.factors[28], t204);
    let t212 = (-(m.factors[44] * t210))
        .sub_product(m.factors[43], t211)
        .sub_product(m.factors[45], t205)
        .sub_product(m.factors[46], t204);
    let t213 = (-(m.factors[48] * t211))
        .sub_product(m.factors[47], t212)
        .sub_product(m.factors[49], t210)
        .sub_product(m.factors[50], t205)
        .add_product(t19, t204);
    let t214 = (-(m.factors[53] * t212)).sub_product(m.factors[52], t213);
    let t215 = (-(m.factors[55] * t213))
        .sub_product(m.factors[54], t214)
        .sub_product(m.factors[54], t212);
    let bobbin_v_y_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t204);
    let bobbin_v_x_dot_by_cylinder_phi = -(R::literal(1.428_571_428_571_428_6) * t205);
    let rod_omega_dot_by_cylinder_phi = (t18 * t207)
        .sub_product(R::literal(4_166.666_666_666_667), t209)
        .sub_product(m.factors[58], t206);
    let rod_v_y_dot_by_cylinder_phi = t201
        .sub_product(m.factors[11], t208)
        .sub_product(R::literal(5.0), t206);
    let rod_v_x_dot_by_cylinder_phi = t199
        .add_product(t17, t208)
        .sub_product(R::literal(5.0), t207);
    let cylinder_omega_dot_by_cylinder_phi = (t64 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t211)
        .add_product(t15, t210)
        .sub_product(R::literal(-2_777.777_777_777_778), t209)
        .add_product(t16, t208);
    let cylinder_v_y_dot_by_cylinder_phi = t194
        .sub_product(R::literal(3.333_333_333_333_333_5), t210)
        .add_product(t14, t208);
    let cylinder_v_x_dot_by_cylinder_phi = t192
        .sub_product(R::literal(3.333_333_333_333_333_5), t211)
        .sub_product(m.factors[7], t208);
    let plate_omega_dot_by_cylinder_phi = (t12 * t212)
        .sub_product(m.factors[60], t213)
        .sub_product(m.factors[60], t211)
        .add_product(t12, t210)
        .add_product(t13, t205)
        .sub_product(m.factors[63], t204);
    let plate_v_y_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t210))
        .sub_product(R::literal(0.833_333_333_333_333_4), t212)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t204);
    let plate_v_x_dot_by_cylinder_phi = (-(R::literal(-0.833_333_333_333_333_4) * t211))
        .sub_product(R::literal(0.833_333_333_333_333_4), t213)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t205);
    let post_omega_dot_by_cylinder_phi = (t11 * t214)
        .sub_product(m.factors[66], t215)
        .sub_product(m.factors[66], t213)
        .add_product(t11, t212);
    let post_v_y_dot_by_cylinder_phi = (-(R::literal(-1.25) * t212))
        .sub_product(R::literal(1.25), t214);
    let post_v_x_dot_by_cylinder_phi = (-(R::literal(-1.25) * t213))
        .sub_product(R::literal(1.25), t215);
    let t216 = R::literal(3.333_333_333_333_333_5) * t43;
    let t217 = (-t216).sub_product(m.factors[1], t67);
    let t218 = R::literal(3.333_333_333_333_333_5) * t44;
    let t219 = (-t218).add_product(t15, t67).sub_product(m.factors[3], t217);
    let t220 = (-(R::literal(-2_777.777_777_777_778) * t67))
        .add_product(t20, t217)
        .sub_product(m.factors[6], t219);
    let t221 = (t47 - t26)
        .sub_product(m.factors[7], t43)
        .add_product(t14, t44)
        .add_product(t16, t67)
        .add_product(t17, t36)
        .sub_product(m.factors[11], t37)
        .sub_product(m.factors[12], t217)
        .sub_product(m.factors[13], t219)
        .sub_product(m.factors[14], t220);
    let t222 = R::literal(5.0) * t36;
    let t223 = (-t222).sub_product(m.factors[16], t220).sub_product(m.factors[17], t221);
    let t224 = R::literal(5.0) * t37;
    let t225 = (-t224)
        .add_product(t21, t220)
        .sub_product(m.factors[19], t221)
        .sub_product(m.factors[20], t223);
    let t226 = (-(m.factors[22] * t217))
        .sub_product(m.factors[23], t219)
        .sub_product(m.factors[24], t220)
        .sub_product(m.factors[25], t221)
        .sub_product(m.factors[26], t223)
        .sub_product(m.factors[27], t225);
    let t227 = (-(m.factors[28] * t217))
        .sub_product(m.factors[29], t219)
        .sub_product(m.factors[30], t220)
        .sub_product(m.factors[31], t221)
        .sub_product(m.factors[32], t223)
        .sub_product(m.factors[33], t225)
        .sub_product(m.factors[34], t226) * m.factors[35];
    let t228 = (t226 * m.factors[36]).sub_product(m.factors[34], t227);
    let t229 = (t225 * m.factors[37])
        .sub_product(m.factors[27], t228)
        .sub_product(m.factors[33], t227);
    let t230 = (t223 * m.factors[38])
        .sub_product(m.factors[20], t229)
        .sub_product(m.factors[26], t228)
        .sub_product(m.factors[32], t227);
    let t231 = (t221 * m.factors[39])
        .sub_product(m.factors[17], t230)
        .sub_product(m.factors[19], t229)
        .sub_product(m.factors[25], t228)
        .sub_product(m.factors[31], t227);
    let t232 = (t220 * m.factors[40])
        .sub_product(m.factors[14], t231)
        .sub_product(m.factors[16], t230)
        .add_product(t21, t229)
        .sub_product(m.factors[24], t228)
        .sub_product(m.factors[30], t227);
    let t233 = (t219 * m.factors[41])
        .sub_product(m.factors[6], t232)
        .sub_product(m.factors[13], t231)
        .sub_product(m.factors[23], t228)
        .sub_product(m.factors[29], t227);
    let t234 = (t217 * m.factors[42])
        .sub_product(m.factors[3], t233)
        .add_product(t20, t232)
        .sub_product(m.factors[12], t231)
        .sub_product(m.factors[22], t228)
        .sub_product(m.factors[28], t227);
    let t235 = (-(m.factors[44] * t233))
        .sub_product(m.factors[43], t234)
        .sub_product(m.factors[45], t228)
        .sub_product(m.factors[46], t227);
    let t236 = (-(m.factors[48] * t234))
        .sub_product(m.factors[47], t235)
        .sub_product(m.factors[49], t233)
        .sub_product(m.factors[50], t228)
        .add_product(t19, t227);
    let t237 = (-(m.factors[53] * t235)).sub_product(m.factors[52], t236);
    let t238 = (-(m.factors[55] * t236))
        .sub_product(m.factors[54], t237)
        .sub_product(m.factors[54], t235);
    let bobbin_v_y_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t227);
    let bobbin_v_x_dot_by_rod_x = -(R::literal(1.428_571_428_571_428_6) * t228);
    let rod_omega_dot_by_rod_x = (t18 * t230)
        .sub_product(R::literal(4_166.666_666_666_667), t232)
        .sub_product(m.factors[58], t229);
    let rod_v_y_dot_by_rod_x = t224
        .sub_product(m.factors[11], t231)
        .sub_product(R::literal(5.0), t229);
    let rod_v_x_dot_by_rod_x = t222
        .add_product(t17, t231)
        .sub_product(R::literal(5.0), t230);
    let cylinder_omega_dot_by_rod_x = (t67 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t234)
        .add_product(t15, t233)
        .sub_product(R::literal(-2_777.777_777_777_778), t232)
        .add_product(t16, t231);
    let cylinder_v_y_dot_by_rod_x = t218
        .sub_product(R::literal(3.333_333_333_333_333_5), t233)
        .add_product(t14, t231);
    let cylinder_v_x_dot_by_rod_x = t216
        .sub_product(R::literal(3.333_333_333_333_333_5), t234)
        .sub_product(m.factors[7], t231);
    let plate_omega_dot_by_rod_x = (t12 * t235)
        .sub_product(m.factors[60], t236)
        .sub_product(m.factors[60], t234)
        .add_product(t12, t233)
        .add_product(t13, t228)
        .sub_product(m.factors[63], t227);
    let plate_v_y_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t233))
        .sub_product(R::literal(0.833_333_333_333_333_4), t235)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t227);
    let plate_v_x_dot_by_rod_x = (-(R::literal(-0.833_333_333_333_333_4) * t234))
        .sub_product(R::literal(0.833_333_333_333_333_4), t236)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t228);
    let post_omega_dot_by_rod_x = (t11 * t237)
        .sub_product(m.factors[66], t238)
        .sub_product(m.factors[66], t236)
        .add_product(t11, t235);
    let post_v_y_dot_by_rod_x = (-(R::literal(-1.25) * t235))
        .sub_product(R::literal(1.25), t237);
    let post_v_x_dot_by_rod_x = (-(R::literal(-1.25) * t236))
        .sub_product(R::literal(1.25), t238);
    let t239 = t165.sub_product(m.factors[1], t68);
    let t240 = (-t167).add_product(t15, t68).sub_product(m.factors[3], t239);
    let t241 = (-(R::literal(-2_777.777_777_777_778) * t68))
        .add_product(t20, t239)
        .sub_product(m.factors[6], t240);
    let t242 = ((t25 + t55 - t170 + t171).add_product(t16, t68) - t172 + t173)
        .sub_product(m.factors[12], t239)
        .sub_product(m.factors[13], t240)
        .sub_product(m.factors[14], t241);
    let t243 = t175.sub_product(m.factors[16], t241).sub_product(m.factors[17], t242);
    let t244 = t177
        .add_product(t21, t241)
        .sub_product(m.factors[19], t242)
        .sub_product(m.factors[20], t243);
    let t245 = (-(m.factors[22] * t239))
        .sub_product(m.factors[23], t240)
        .sub_product(m.factors[24], t241)
        .sub_product(m.factors[25], t242)
        .sub_product(m.factors[26], t243)
        .sub_product(m.factors[27], t244);
    let t246 = (-(m.factors[28] * t239))
        .sub_product(m.factors[29], t240)
        .sub_product(m.factors[30], t241)
        .sub_product(m.factors[31], t242)
        .sub_product(m.factors[32], t243)
        .sub_product(m.factors[33], t244)
        .sub_product(m.factors[34], t245) * m.factors[35];
    let t247 = (t245 * m.factors[36]).sub_product(m.factors[34], t246);
    let t248 = (t244 * m.factors[37])
        .sub_product(m.factors[27], t247)
        .sub_product(m.factors[33], t246);
    let t249 = (t243 * m.factors[38])
        .sub_product(m.factors[20], t248)
        .sub_product(m.factors[26], t247)
        .sub_product(m.factors[32], t246);
    let t250 = (t242 * m.factors[39])
        .sub_product(m.factors[17], t249)
        .sub_product(m.factors[19], t248)
        .sub_product(m.factors[25], t247)
        .sub_product(m.factors[31], t246);
    let t251 = (t241 * m.factors[40])
        .sub_product(m.factors[14], t250)
        .sub_product(m.factors[16], t249)
        .add_product(t21, t248)
        .sub_product(m.factors[24], t247)
        .sub_product(m.factors[30], t246);
    let t252 = (t240 * m.factors[41])
        .sub_product(m.factors[6], t251)
        .sub_product(m.factors[13], t250)
        .sub_product(m.factors[23], t247)
        .sub_product(m.factors[29], t246);
    let t253 = (t239 * m.factors[42])
        .sub_product(m.factors[3], t252)
        .add_product(t20, t251)
        .sub_product(m.factors[12], t250)
        .sub_product(m.factors[22], t247)
        .sub_product(m.factors[28], t246);
    let t254 = (-(m.factors[44] * t252))
        .sub_product(m.factors[43], t253)
        .sub_product(m.factors[45], t247)
        .sub_product(m.factors[46], t246);
    let t255 = (-(m.factors[48] * t253))
        .sub_product(m.factors[47], t254)
        .sub_product(m.factors[49], t252)
        .sub_product(m.factors[50], t247)
        .add_product(t19, t246);
    let t256 = (-(m.factors[53] * t254)).sub_product(m.factors[52], t255);
    let t257 = (-(m.factors[55] * t255))
        .sub_product(m.factors[54], t256)
        .sub_product(m.factors[54], t254);
    let bobbin_v_y_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t246);
    let bobbin_v_x_dot_by_rod_y = -(R::literal(1.428_571_428_571_428_6) * t247);
    let rod_omega_dot_by_rod_y = (t18 * t249)
        .sub_product(R::literal(4_166.666_666_666_667), t251)
        .sub_product(m.factors[58], t248);
    let rod_v_y_dot_by_rod_y = (-t177)
        .sub_product(m.factors[11], t250)
        .sub_product(R::literal(5.0), t248);
    let rod_v_x_dot_by_rod_y = (-t175)
        .add_product(t17, t250)
        .sub_product(R::literal(5.0), t249);
    let cylinder_omega_dot_by_rod_y = (t68 * R::literal(2_777.777_777_777_778))
        .sub_product(m.factors[1], t253)
        .add_product(t15, t252)
        .sub_product(R::literal(-2_777.777_777_777_778), t251)
        .add_product(t16, t250);
    let cylinder_v_y_dot_by_rod_y = t167
        .sub_product(R::literal(3.333_333_333_333_333_5), t252)
        .add_product(t14, t250);
    let cylinder_v_x_dot_by_rod_y = t164
        .sub_product(R::literal(3.333_333_333_333_333_5), t253)
        .sub_product(m.factors[7], t250);
    let plate_omega_dot_by_rod_y = (t12 * t254)
        .sub_product(m.factors[60], t255)
        .sub_product(m.factors[60], t253)
        .add_product(t12, t252)
        .add_product(t13, t247)
        .sub_product(m.factors[63], t246);
    let plate_v_y_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t252))
        .sub_product(R::literal(0.833_333_333_333_333_4), t254)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t246);
    let plate_v_x_dot_by_rod_y = (-(R::literal(-0.833_333_333_333_333_4) * t253))
        .sub_product(R::literal(0.833_333_333_333_333_4), t255)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t247);
    let post_omega_dot_by_rod_y = (t11 * t256)
        .sub_product(m.factors[66], t257)
        .sub_product(m.factors[66], t255)
        .add_product(t11, t254);
    let post_v_y_dot_by_rod_y = (-(R::literal(-1.25) * t254))
        .sub_product(R::literal(1.25), t256);
    let post_v_x_dot_by_rod_y = (-(R::literal(-1.25) * t255))
        .sub_product(R::literal(1.25), t257);
    let t258 = R::literal(4_166.666_666_666_667) * t69;
    let t259 = m.factors[14] * t258;
    let t260 = (-m.t172)
        .add_product(t6, m.rod_omega_dot)
        .add_product(t18, t69)
        .add_product(m.factors[16], t258)
        .sub_product(m.factors[17], t259);
    let t261 = m
        .t171
        .add_product(t7, m.rod_omega_dot)
        .sub_product(m.factors[58], t69)
        .sub_product(t21, t258)
        .sub_product(m.factors[19], t259)
        .sub_product(m.factors[20], t260);
    let t262 = (m.factors[24] * t258)
        .sub_product(m.factors[25], t259)
        .sub_product(m.factors[26], t260)
        .sub_product(m.factors[27], t261);
    let t263 = (m.factors[30] * t258)
        .sub_product(m.factors[31], t259)
        .sub_product(m.factors[32], t260)
        .sub_product(m.factors[33], t261)
        .sub_product(m.factors[34], t262) * m.factors[35];
    let t264 = (t262 * m.factors[36]).sub_product(m.factors[34], t263);
    let t265 = (t261 * m.factors[37])
        .sub_product(m.factors[27], t264)
        .sub_product(m.factors[33], t263);
    let t266 = (t260 * m.factors[38])
        .sub_product(m.factors[20], t265)
        .sub_product(m.factors[26], t264)
        .sub_product(m.factors[32], t263);
    let t267 = (t259 * m.factors[39])
        .sub_product(m.factors[17], t266)
        .sub_product(m.factors[19], t265)
        .sub_product(m.factors[25], t264)
        .sub_product(m.factors[31], t263);
    let t268 = (-(t258 * m.factors[40]))
        .sub_product(m.factors[14], t267)
        .sub_product(m.factors[16], t266)
        .add_product(t21, t265)
        .sub_product(m.factors[24], t264)
        .sub_product(m.factors[30], t263);
    let t269 = (-(m.factors[13] * t267))
        .sub_product(m.factors[6], t268)
        .sub_product(m.factors[23], t264)
        .sub_product(m.factors[29], t263);
    let t270 = (t20 * t268)
        .sub_product(m.factors[3], t269)
        .sub_product(m.factors[12], t267)
        .sub_product(m.factors[22], t264)
        .sub_product(m.factors[28], t263);
    let t271 = (-(m.factors[44] * t269))
        .sub_product(m.factors[43], t270)
        .sub_product(m.factors[45], t264)
        .sub_product(m.factors[46], t263);
    let t272 = (-(m.factors[48] * t270))
        .sub_product(m.factors[47], t271)
        .sub_product(m.factors[49], t269)
        .sub_product(m.factors[50], t264)
        .add_product(t19, t263);
    let t273 = (-(m.factors[53] * t271)).sub_product(m.factors[52], t272);
    let t274 = (-(m.factors[55] * t272))
        .sub_product(m.factors[54], t273)
        .sub_product(m.factors[54], t271);
    let bobbin_v_y_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t263);
    let bobbin_v_x_dot_by_rod_phi = -(R::literal(1.428_571_428_571_428_6) * t264);
    let rod_omega_dot_by_rod_phi = t258
        .sub_product(R::literal(4_166.666_666_666_667), t268)
        .add_product(t18, t266)
        .sub_product(m.factors[58], t265);
    let rod_v_y_dot_by_rod_phi = (-(R::literal(5.0) * t265))
        .sub_product(m.factors[11], t267);
    let rod_v_x_dot_by_rod_phi = (-(R::literal(5.0) * t266)).add_product(t17, t267);
    let cylinder_omega_dot_by_rod_phi = (t15 * t269)
        .sub_product(m.factors[1], t270)
        .sub_product(R::literal(-2_777.777_777_777_778), t268)
        .add_product(t16, t267);
    let cylinder_v_y_dot_by_rod_phi = (t14 * t267)
        .sub_product(R::literal(3.333_333_333_333_333_5), t269);
    let cylinder_v_x_dot_by_rod_phi = (-(m.factors[7] * t267))
        .sub_product(R::literal(3.333_333_333_333_333_5), t270);
    let plate_omega_dot_by_rod_phi = (t12 * t271)
        .sub_product(m.factors[60], t272)
        .sub_product(m.factors[60], t270)
        .add_product(t12, t269)
        .add_product(t13, t264)
        .sub_product(m.factors[63], t263);
    let plate_v_y_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t269))
        .sub_product(R::literal(0.833_333_333_333_333_4), t271)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t263);
    let plate_v_x_dot_by_rod_phi = (-(R::literal(-0.833_333_333_333_333_4) * t270))
        .sub_product(R::literal(0.833_333_333_333_333_4), t272)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t264);
    let post_omega_dot_by_rod_phi = (t11 * t273)
        .sub_product(m.factors[66], t274)
        .sub_product(m.factors[66], t272)
        .add_product(t11, t271);
    let post_v_y_dot_by_rod_phi = (-(R::literal(-1.25) * t271))
        .sub_product(R::literal(1.25), t273);
    let post_v_x_dot_by_rod_phi = (-(R::literal(-1.25) * t272))
        .sub_product(R::literal(1.25), t274);
    let t275 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t74 * m.t9 / t73 + contact_stiffness_times_contact_gap * m.t9 / t73
                - contact_damping_times_bobbin_v_x * t8 / t70 - t71
                - p.contact_stiffness * m.t9 / t70 - t72,
        );
    let t276 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t75 - contact_damping_times_bobbin_v_x * t9 / t70 - (t77 - t76),
        );
    let t277 = (-t276).add_product(m.factors[34], t275) * m.factors[35];
    let t278 = (-(t275 * m.factors[36])).sub_product(m.factors[34], t277);
    let t279 = (-(m.factors[33] * t277)).sub_product(m.factors[27], t278);
    let t280 = (-(m.factors[26] * t278))
        .sub_product(m.factors[20], t279)
        .sub_product(m.factors[32], t277);
    let t281 = (-(m.factors[19] * t279))
        .sub_product(m.factors[17], t280)
        .sub_product(m.factors[25], t278)
        .sub_product(m.factors[31], t277);
    let t282 = (-(m.factors[16] * t280))
        .sub_product(m.factors[14], t281)
        .add_product(t21, t279)
        .sub_product(m.factors[24], t278)
        .sub_product(m.factors[30], t277);
    let t283 = (-(m.factors[13] * t281))
        .sub_product(m.factors[6], t282)
        .sub_product(m.factors[23], t278)
        .sub_product(m.factors[29], t277);
    let t284 = (t20 * t282)
        .sub_product(m.factors[3], t283)
        .sub_product(m.factors[12], t281)
        .sub_product(m.factors[22], t278)
        .sub_product(m.factors[28], t277);
    let t285 = (-(m.factors[44] * t283))
        .sub_product(m.factors[43], t284)
        .sub_product(m.factors[45], t278)
        .sub_product(m.factors[46], t277);
    let t286 = (-(m.factors[48] * t284))
        .sub_product(m.factors[47], t285)
        .sub_product(m.factors[49], t283)
        .sub_product(m.factors[50], t278)
        .add_product(t19, t277);
    let t287 = (-(m.factors[53] * t285)).sub_product(m.factors[52], t286);
    let t288 = (-(m.factors[55] * t286))
        .sub_product(m.factors[54], t287)
        .sub_product(m.factors[54], t285);
    let bobbin_v_y_dot_by_bobbin_x = t276
        .sub_product(R::literal(1.428_571_428_571_428_6), t277);
    let bobbin_v_x_dot_by_bobbin_x = t275
        .sub_product(R::literal(1.428_571_428_571_428_6), t278);
    let rod_omega_dot_by_bobbin_x = (t18 * t280)
        .sub_product(R::literal(4_166.666_666_666_667), t282)
        .sub_product(m.factors[58], t279);
    let rod_v_y_dot_by_bobbin_x = (-(R::literal(5.0) * t279))
        .sub_product(m.factors[11], t281);
    let rod_v_x_dot_by_bobbin_x = (-(R::literal(5.0) * t280)).add_product(t17, t281);
    let cylinder_omega_dot_by_bobbin_x = (t15 * t283)
        .sub_product(m.factors[1], t284)
        .sub_product(R::literal(-2_777.777_777_777_778), t282)
        .add_product(t16, t281);
    let cylinder_v_y_dot_by_bobbin_x = (t14 * t281)
        .sub_product(R::literal(3.333_333_333_333_333_5), t283);
    let cylinder_v_x_dot_by_bobbin_x = (-(m.factors[7] * t281))
        .sub_product(R::literal(3.333_333_333_333_333_5), t284);
    let plate_omega_dot_by_bobbin_x = (t12 * t285)
        .sub_product(m.factors[60], t286)
        .sub_product(m.factors[60], t284)
        .add_product(t12, t283)
        .add_product(t13, t278)
        .sub_product(m.factors[63], t277);
    let plate_v_y_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t283))
        .sub_product(R::literal(0.833_333_333_333_333_4), t285)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t277);
    let plate_v_x_dot_by_bobbin_x = (-(R::literal(-0.833_333_333_333_333_4) * t284))
        .sub_product(R::literal(0.833_333_333_333_333_4), t286)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t278);
    let post_omega_dot_by_bobbin_x = (t11 * t287)
        .sub_product(m.factors[66], t288)
        .sub_product(m.factors[66], t286)
        .add_product(t11, t285);
    let post_v_y_dot_by_bobbin_x = (-(R::literal(-1.25) * t285))
        .sub_product(R::literal(1.25), t287);
    let post_v_x_dot_by_bobbin_x = (-(R::literal(-1.25) * t286))
        .sub_product(R::literal(1.25), t288);
    let t289 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t75 + t76 - contact_damping_times_bobbin_v_y * t8 / t70 - t77,
        );
    let t290 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            t74 * m.t11 / t73 - contact_damping_times_bobbin_v_y * t9 / t70 - t72
                - (t71 + p.contact_stiffness * m.t11 / t70
                    - contact_stiffness_times_contact_gap * m.t11 / t73),
        );
    let t291 = (-t290).add_product(m.factors[34], t289) * m.factors[35];
    let t292 = (-(t289 * m.factors[36])).sub_product(m.factors[34], t291);
    let t293 = (-(m.factors[33] * t291)).sub_product(m.factors[27], t292);
    let t294 = (-(m.factors[26] * t292))
        .sub_product(m.factors[20], t293)
        .sub_product(m.factors[32], t291);
    let t295 = (-(m.factors[19] * t293))
        .sub_product(m.factors[17], t294)
        .sub_product(m.factors[25], t292)
        .sub_product(m.factors[31], t291);
    let t296 = (-(m.factors[16] * t294))
        .sub_product(m.factors[14], t295)
        .add_product(t21, t293)
        .sub_product(m.factors[24], t292)
        .sub_product(m.factors[30], t291);
    let t297 = (-(m.factors[13] * t295))
        .sub_product(m.factors[6], t296)
        .sub_product(m.factors[23], t292)
        .sub_product(m.factors[29], t291);
    let t298 = (t20 * t296)
        .sub_product(m.factors[3], t297)
        .sub_product(m.factors[12], t295)
        .sub_product(m.factors[22], t292)
        .sub_product(m.factors[28], t291);
    let t299 = (-(m.factors[44] * t297))
        .sub_product(m.factors[43], t298)
        .sub_product(m.factors[45], t292)
        .sub_product(m.factors[46], t291);
    let t300 = (-(m.factors[48] * t298))
        .sub_product(m.factors[47], t299)
        .sub_product(m.factors[49], t297)
        .sub_product(m.factors[50], t292)
        .add_product(t19, t291);
    let t301 = (-(m.factors[53] * t299)).sub_product(m.factors[52], t300);
    let t302 = (-(m.factors[55] * t300))
        .sub_product(m.factors[54], t301)
        .sub_product(m.factors[54], t299);
    let bobbin_v_y_dot_by_bobbin_y = t290
        .sub_product(R::literal(1.428_571_428_571_428_6), t291);
    let bobbin_v_x_dot_by_bobbin_y = t289
        .sub_product(R::literal(1.428_571_428_571_428_6), t292);
    let rod_omega_dot_by_bobbin_y = (t18 * t294)
        .sub_product(R::literal(4_166.666_666_666_667), t296)
        .sub_product(m.factors[58], t293);
    let rod_v_y_dot_by_bobbin_y = (-(R::literal(5.0) * t293))
        .sub_product(m.factors[11], t295);
    let rod_v_x_dot_by_bobbin_y = (-(R::literal(5.0) * t294)).add_product(t17, t295);
    let cylinder_omega_dot_by_bobbin_y = (t15 * t297)
        .sub_product(m.factors[1], t298)
        .sub_product(R::literal(-2_777.777_777_777_778), t296)
        .add_product(t16, t295);
    let cylinder_v_y_dot_by_bobbin_y = (t14 * t295)
        .sub_product(R::literal(3.333_333_333_333_333_5), t297);
    let cylinder_v_x_dot_by_bobbin_y = (-(m.factors[7] * t295))
        .sub_product(R::literal(3.333_333_333_333_333_5), t298);
    let plate_omega_dot_by_bobbin_y = (t12 * t299)
        .sub_product(m.factors[60], t300)
        .sub_product(m.factors[60], t298)
        .add_product(t12, t297)
        .add_product(t13, t292)
        .sub_product(m.factors[63], t291);
    let plate_v_y_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t297))
        .sub_product(R::literal(0.833_333_333_333_333_4), t299)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t291);
    let plate_v_x_dot_by_bobbin_y = (-(R::literal(-0.833_333_333_333_333_4) * t298))
        .sub_product(R::literal(0.833_333_333_333_333_4), t300)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t292);
    let post_omega_dot_by_bobbin_y = (t11 * t301)
        .sub_product(m.factors[66], t302)
        .sub_product(m.factors[66], t300)
        .add_product(t11, t299);
    let post_v_y_dot_by_bobbin_y = (-(R::literal(-1.25) * t299))
        .sub_product(R::literal(1.25), t301);
    let post_v_x_dot_by_bobbin_y = (-(R::literal(-1.25) * t300))
        .sub_product(R::literal(1.25), t302);
    let t303 = (-(t79 * m.cos_post_phi)).sub_product(m.factors[66], t78);
    let t304 = (-(t79 * m.sin_post_phi))
        .add_product(t11, t78)
        .sub_product(m.factors[54], t303);
    let t305 = t303.sub_product(m.factors[55], t303).sub_product(m.factors[52], t304);
    let t306 = t304.sub_product(m.factors[53], t304).sub_product(m.factors[47], t305);
    let t307 = (-(m.factors[48] * t305)).sub_product(m.factors[43], t306);
    let t308 = (-(m.factors[49] * t305))
        .sub_product(m.factors[44], t306)
        .sub_product(m.factors[3], t307);
    let t309 = (t20 * t307).sub_product(m.factors[6], t308);
    let t310 = (-(m.factors[12] * t307))
        .sub_product(m.factors[13], t308)
        .sub_product(m.factors[14], t309);
    let t311 = (-(m.factors[16] * t309)).sub_product(m.factors[17], t310);
    let t312 = (t21 * t309)
        .sub_product(m.factors[19], t310)
        .sub_product(m.factors[20], t311);
    let t313 = (-(m.factors[50] * t305))
        .sub_product(m.factors[45], t306)
        .sub_product(m.factors[22], t307)
        .sub_product(m.factors[23], t308)
        .sub_product(m.factors[24], t309)
        .sub_product(m.factors[25], t310)
        .sub_product(m.factors[26], t311)
        .sub_product(m.factors[27], t312);
    let t314 = (t19 * t305)
        .sub_product(m.factors[46], t306)
        .sub_product(m.factors[28], t307)
        .sub_product(m.factors[29], t308)
        .sub_product(m.factors[30], t309)
        .sub_product(m.factors[31], t310)
        .sub_product(m.factors[32], t311)
        .sub_product(m.factors[33], t312)
        .sub_product(m.factors[34], t313) * m.factors[35];
    let t315 = (t313 * m.factors[36]).sub_product(m.factors[34], t314);
    let t316 = (t312 * m.factors[37])
        .sub_product(m.factors[27], t315)
        .sub_product(m.factors[33], t314);
    let t317 = (t311 * m.factors[38])
        .sub_product(m.factors[20], t316)
        .sub_product(m.factors[26], t315)
        .sub_product(m.factors[32], t314);
    let t318 = (t310 * m.factors[39])
        .sub_product(m.factors[17], t317)
        .sub_product(m.factors[19], t316)
        .sub_product(m.factors[25], t315)
        .sub_product(m.factors[31], t314);
    let t319 = (t309 * m.factors[40])
        .sub_product(m.factors[14], t318)
        .sub_product(m.factors[16], t317)
        .add_product(t21, t316)
        .sub_product(m.factors[24], t315)
        .sub_product(m.factors[30], t314);
    let t320 = (t308 * m.factors[41])
        .sub_product(m.factors[6], t319)
        .sub_product(m.factors[13], t318)
        .sub_product(m.factors[23], t315)
        .sub_product(m.factors[29], t314);
    let t321 = (t307 * m.factors[42])
        .sub_product(m.factors[3], t320)
        .add_product(t20, t319)
        .sub_product(m.factors[12], t318)
        .sub_product(m.factors[22], t315)
        .sub_product(m.factors[28], t314);
    let t322 = (t306 * m.t70)
        .sub_product(m.factors[43], t321)
        .sub_product(m.factors[44], t320)
        .sub_product(m.factors[45], t315)
        .sub_product(m.factors[46], t314);
    let t323 = (t305 * m.t56)
        .sub_product(m.factors[47], t322)
        .sub_product(m.factors[48], t321)
        .sub_product(m.factors[49], t320)
        .sub_product(m.factors[50], t315)
        .add_product(t19, t314);
    let t324 = (t304 * m.t48)
        .sub_product(m.factors[52], t323)
        .sub_product(m.factors[53], t322);
    let t325 = (t303 * m.t40)
        .sub_product(m.factors[54], t324)
        .sub_product(m.factors[55], t323)
        .sub_product(m.factors[54], t322);
    let bobbin_v_y_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t314);
    let bobbin_v_x_dot_by_post_omega = -(R::literal(1.428_571_428_571_428_6) * t315);
    let rod_omega_dot_by_post_omega = (t18 * t317)
        .sub_product(R::literal(4_166.666_666_666_667), t319)
        .sub_product(m.factors[58], t316);
    let rod_v_y_dot_by_post_omega = (-(R::literal(5.0) * t316))
        .sub_product(m.factors[11], t318);
    let rod_v_x_dot_by_post_omega = (-(R::literal(5.0) * t317)).add_product(t17, t318);
    let cylinder_omega_dot_by_post_omega = (t15 * t320)
        .sub_product(m.factors[1], t321)
        .sub_product(R::literal(-2_777.777_777_777_778), t319)
        .add_product(t16, t318);
    let cylinder_v_y_dot_by_post_omega = (t14 * t318)
        .sub_product(R::literal(3.333_333_333_333_333_5), t320);
    let cylinder_v_x_dot_by_post_omega = (-(m.factors[7] * t318))
        .sub_product(R::literal(3.333_333_333_333_333_5), t321);
    let plate_omega_dot_by_post_omega = (t12 * t322)
        .sub_product(m.factors[60], t323)
        .sub_product(m.factors[60], t321)
        .add_product(t12, t320)
        .add_product(t13, t315)
        .sub_product(m.factors[63], t314);
    let plate_v_y_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t320))
        .sub_product(R::literal(0.833_333_333_333_333_4), t322)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t314);
    let plate_v_x_dot_by_post_omega = (-(R::literal(-0.833_333_333_333_333_4) * t321))
        .sub_product(R::literal(0.833_333_333_333_333_4), t323)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t315);
    let post_omega_dot_by_post_omega = (t78 * R::literal(370.370_370_370_370_3))
        .sub_product(m.factors[66], t325)
        .add_product(t11, t324)
        .sub_product(m.factors[66], t323)
        .add_product(t11, t322);
    let post_v_y_dot_by_post_omega = (-(R::literal(-1.25) * t322))
        .sub_product(R::literal(1.25), t324);
    let post_v_x_dot_by_post_omega = (-(R::literal(-1.25) * t323))
        .sub_product(R::literal(1.25), t325);
    let t326 = (-t82).add_product(m.factors[47], t81);
    let t327 = (-t81).add_product(m.factors[48], t81).sub_product(m.factors[43], t326);
    let t328 = (-t82)
        .add_product(m.factors[49], t81)
        .sub_product(m.factors[44], t326)
        .sub_product(m.factors[3], t327);
    let t329 = (t20 * t327).sub_product(m.factors[6], t328);
    let t330 = (-(m.factors[12] * t327))
        .sub_product(m.factors[13], t328)
        .sub_product(m.factors[14], t329);
    let t331 = (-(m.factors[16] * t329)).sub_product(m.factors[17], t330);
    let t332 = (t21 * t329)
        .sub_product(m.factors[19], t330)
        .sub_product(m.factors[20], t331);
    let t333 = (plate_omega
        * (R::literal(0.02) * m.cos_plate_phi)
            .sub_product(R::literal(0.2), m.sin_plate_phi))
        .add_product(m.factors[50], t81)
        .sub_product(m.factors[45], t326)
        .sub_product(m.factors[22], t327)
        .sub_product(m.factors[23], t328)
        .sub_product(m.factors[24], t329)
        .sub_product(m.factors[25], t330)
        .sub_product(m.factors[26], t331)
        .sub_product(m.factors[27], t332);
    let t334 = (plate_omega
        * (R::literal(0.02) * m.sin_plate_phi)
            .add_product(R::literal(0.2), m.cos_plate_phi))
        .sub_product(t19, t81)
        .sub_product(m.factors[46], t326)
        .sub_product(m.factors[28], t327)
        .sub_product(m.factors[29], t328)
        .sub_product(m.factors[30], t329)
        .sub_product(m.factors[31], t330)
        .sub_product(m.factors[32], t331)
        .sub_product(m.factors[33], t332)
        .sub_product(m.factors[34], t333) * m.factors[35];
    let t335 = (t333 * m.factors[36]).sub_product(m.factors[34], t334);
    let t336 = (t332 * m.factors[37])
        .sub_product(m.factors[27], t335)
        .sub_product(m.factors[33], t334);
    let t337 = (t331 * m.factors[38])
        .sub_product(m.factors[20], t336)
        .sub_product(m.factors[26], t335)
        .sub_product(m.factors[32], t334);
    let t338 = (t330 * m.factors[39])
        .sub_product(m.factors[17], t337)
        .sub_product(m.factors[19], t336)
        .sub_product(m.factors[25], t335)
        .sub_product(m.factors[31], t334);
    let t339 = (t329 * m.factors[40])
        .sub_product(m.factors[14], t338)
        .sub_product(m.factors[16], t337)
        .add_product(t21, t336)
        .sub_product(m.factors[24], t335)
        .sub_product(m.factors[30], t334);
    let t340 = (t328 * m.factors[41])
        .sub_product(m.factors[6], t339)
        .sub_product(m.factors[13], t338)
        .sub_product(m.factors[23], t335)
        .sub_product(m.factors[29], t334);
    let t341 = (t327 * m.factors[42])
        .sub_product(m.factors[3], t340)
        .add_product(t20, t339)
        .sub_product(m.factors[12], t338)
        .sub_product(m.factors[22], t335)
        .sub_product(m.factors[28], t334);
    let t342 = (t326 * m.t70)
        .sub_product(m.factors[43], t341)
        .sub_product(m.factors[44], t340)
        .sub_product(m.factors[45], t335)
        .sub_product(m.factors[46], t334);
    let t343 = (-(t81 * m.t56))
        .sub_product(m.factors[47], t342)
        .sub_product(m.factors[48], t341)
        .sub_product(m.factors[49], t340)
        .sub_product(m.factors[50], t335)
        .add_product(t19, t334);
    let t344 = (-(m.factors[53] * t342)).sub_product(m.factors[52], t343);
    let t345 = (-(m.factors[55] * t343))
        .sub_product(m.factors[54], t344)
        .sub_product(m.factors[54], t342);
    let bobbin_v_y_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t334);
    let bobbin_v_x_dot_by_plate_omega = -(R::literal(1.428_571_428_571_428_6) * t335);
    let rod_omega_dot_by_plate_omega = (t18 * t337)
        .sub_product(R::literal(4_166.666_666_666_667), t339)
        .sub_product(m.factors[58], t336);
    let rod_v_y_dot_by_plate_omega = (-(R::literal(5.0) * t336))
        .sub_product(m.factors[11], t338);
    let rod_v_x_dot_by_plate_omega = (-(R::literal(5.0) * t337)).add_product(t17, t338);
    let cylinder_omega_dot_by_plate_omega = (t15 * t340)
        .sub_product(m.factors[1], t341)
        .sub_product(R::literal(-2_777.777_777_777_778), t339)
        .add_product(t16, t338);
    let cylinder_v_y_dot_by_plate_omega = (t14 * t338)
        .sub_product(R::literal(3.333_333_333_333_333_5), t340);
    let cylinder_v_x_dot_by_plate_omega = (-(m.factors[7] * t338))
        .sub_product(R::literal(3.333_333_333_333_333_5), t341);
    let plate_omega_dot_by_plate_omega = (t12 * t342)
        .sub_product(m.factors[60], t343)
        .sub_product(m.factors[60], t341)
        .add_product(t12, t340)
        .add_product(t13, t335)
        .sub_product(m.factors[63], t334);
    let plate_v_y_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t340))
        .sub_product(R::literal(0.833_333_333_333_333_4), t342)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t334);
    let plate_v_x_dot_by_plate_omega = (-(R::literal(-0.833_333_333_333_333_4) * t341))
        .sub_product(R::literal(0.833_333_333_333_333_4), t343)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t335);
    let post_omega_dot_by_plate_omega = (t11 * t344)
        .sub_product(m.factors[66], t345)
        .sub_product(m.factors[66], t343)
        .add_product(t11, t342);
    let post_v_y_dot_by_plate_omega = (-(R::literal(-1.25) * t342))
        .sub_product(R::literal(1.25), t344);
    let post_v_x_dot_by_plate_omega = (-(R::literal(-1.25) * t343))
        .sub_product(R::literal(1.25), t345);
    let t346 = R::literal(3.333_333_333_333_333_5) * t83;
    let t347 = m.factors[1] * t86;
    let t348 = t346 - t347;
    let t349 = R::literal(3.333_333_333_333_333_5) * t84;
    let t350 = -t349;
    let t351 = t15 * t86;
    let t352 = (t349 + t351).sub_product(m.factors[3], t348);
    let t353 = R::literal(-2_777.777_777_777_778) * t86;
    let t354 = (-t353).add_product(t20, t348).sub_product(m.factors[6], t352);
    let t355 = m.factors[7] * t83;
    let t356 = t14 * t84;
    let t357 = t16 * t86;
    let t358 = t17 * t83;
    let t359 = m.factors[11] * t84;
    let t360 = (t355 - t88 - t356 + t357 + t358 - t359)
        .sub_product(m.factors[12], t348)
        .sub_product(m.factors[13], t352)
        .sub_product(m.factors[14], t354);
    let t361 = R::literal(5.0) * t83;
    let t362 = (-t361).sub_product(m.factors[16], t354).sub_product(m.factors[17], t360);
    let t363 = R::literal(5.0) * t84;
    let t364 = -t363;
    let t365 = (-t363)
        .add_product(t21, t354)
        .sub_product(m.factors[19], t360)
        .sub_product(m.factors[20], t362);
    let t366 = (-(m.factors[22] * t348))
        .sub_product(m.factors[23], t352)
        .sub_product(m.factors[24], t354)
        .sub_product(m.factors[25], t360)
        .sub_product(m.factors[26], t362)
        .sub_product(m.factors[27], t365);
    let t367 = (-(m.factors[28] * t348))
        .sub_product(m.factors[29], t352)
        .sub_product(m.factors[30], t354)
        .sub_product(m.factors[31], t360)
        .sub_product(m.factors[32], t362)
        .sub_product(m.factors[33], t365)
        .sub_product(m.factors[34], t366) * m.factors[35];
    let t368 = (t366 * m.factors[36]).sub_product(m.factors[34], t367);
    let t369 = (t365 * m.factors[37])
        .sub_product(m.factors[27], t368)
        .sub_product(m.factors[33], t367);
    let t370 = (t362 * m.factors[38])
        .sub_product(m.factors[20], t369)
        .sub_product(m.factors[26], t368)
        .sub_product(m.factors[32], t367);
    let t371 = (t360 * m.factors[39])
        .sub_product(m.factors[17], t370)
        .sub_product(m.factors[19], t369)
        .sub_product(m.factors[25], t368)
        .sub_product(m.factors[31], t367);
    let t372 = (t354 * m.factors[40])
        .sub_product(m.factors[14], t371)
        .sub_product(m.factors[16], t370)
        .add_product(t21, t369)
        .sub_product(m.factors[24], t368)
        .sub_product(m.factors[30], t367);
    let t373 = (t352 * m.factors[41])
        .sub_product(m.factors[6], t372)
        .sub_product(m.factors[13], t371)
        .sub_product(m.factors[23], t368)
        .sub_product(m.factors[29], t367);
    let t374 = (t348 * m.factors[42])
        .sub_product(m.factors[3], t373)
        .add_product(t20, t372)
        .sub_product(m.factors[12], t371)
        .sub_product(m.factors[22], t368)
        .sub_product(m.factors[28], t367);
    let t375 = (-(m.factors[44] * t373))
        .sub_product(m.factors[43], t374)
        .sub_product(m.factors[45], t368)
        .sub_product(m.factors[46], t367);
    let t376 = (-(m.factors[48] * t374))
        .sub_product(m.factors[47], t375)
        .sub_product(m.factors[49], t373)
        .sub_product(m.factors[50], t368)
        .add_product(t19, t367);
    let t377 = (-(m.factors[53] * t375)).sub_product(m.factors[52], t376);
    let t378 = (-(m.factors[55] * t376))
        .sub_product(m.factors[54], t377)
        .sub_product(m.factors[54], t375);
    let bobbin_v_y_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t367);
    let bobbin_v_x_dot_by_cylinder_v_x = -(R::literal(1.428_571_428_571_428_6) * t368);
    let rod_omega_dot_by_cylinder_v_x = (t18 * t370)
        .sub_product(R::literal(4_166.666_666_666_667), t372)
        .sub_product(m.factors[58], t369);
    let rod_v_y_dot_by_cylinder_v_x = t363
        .sub_product(m.factors[11], t371)
        .sub_product(R::literal(5.0), t369);
    let rod_v_x_dot_by_cylinder_v_x = t361
        .add_product(t17, t371)
        .sub_product(R::literal(5.0), t370);
    let t379 = t86 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_x = t379
        .sub_product(m.factors[1], t374)
        .add_product(t15, t373)
        .sub_product(R::literal(-2_777.777_777_777_778), t372)
        .add_product(t16, t371);
    let cylinder_v_y_dot_by_cylinder_v_x = t350
        .sub_product(R::literal(3.333_333_333_333_333_5), t373)
        .add_product(t14, t371);
    let cylinder_v_x_dot_by_cylinder_v_x = (-t346)
        .sub_product(R::literal(3.333_333_333_333_333_5), t374)
        .sub_product(m.factors[7], t371);
    let plate_omega_dot_by_cylinder_v_x = (t12 * t375)
        .sub_product(m.factors[60], t376)
        .sub_product(m.factors[60], t374)
        .add_product(t12, t373)
        .add_product(t13, t368)
        .sub_product(m.factors[63], t367);
    let plate_v_y_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t373))
        .sub_product(R::literal(0.833_333_333_333_333_4), t375)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t367);
    let plate_v_x_dot_by_cylinder_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t374))
        .sub_product(R::literal(0.833_333_333_333_333_4), t376)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t368);
    let post_omega_dot_by_cylinder_v_x = (t11 * t377)
        .sub_product(m.factors[66], t378)
        .sub_product(m.factors[66], t376)
        .add_product(t11, t375);
    let post_v_y_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t375))
        .sub_product(R::literal(1.25), t377);
    let post_v_x_dot_by_cylinder_v_x = (-(R::literal(-1.25) * t376))
        .sub_product(R::literal(1.25), t378);
    let t380 = m.factors[1] * t90;
    let t381 = t349 - t380;
    let t382 = R::literal(3.333_333_333_333_333_5) * t89;
    let t383 = -t382;
    let t384 = t15 * t90;
    let t385 = (t382 + t384).sub_product(m.factors[3], t381);
    let t386 = R::literal(-2_777.777_777_777_778) * t90;
    let t387 = (-t386).add_product(t20, t381).sub_product(m.factors[6], t385);
    let t388 = m.factors[7] * t84;
    let t389 = t14 * t89;
    let t390 = t16 * t90;
    let t391 = t17 * t84;
    let t392 = m.factors[11] * t89;
    let t393 = (t388 - t91 - t389 + t390 + t391 - t392)
        .sub_product(m.factors[12], t381)
        .sub_product(m.factors[13], t385)
        .sub_product(m.factors[14], t387);
    let t394 = t364.sub_product(m.factors[16], t387).sub_product(m.factors[17], t393);
    let t395 = R::literal(5.0) * t89;
    let t396 = (-t395)
        .add_product(t21, t387)
        .sub_product(m.factors[19], t393)
        .sub_product(m.factors[20], t394);
    let t397 = (-(m.factors[22] * t381))
        .sub_product(m.factors[23], t385)
        .sub_product(m.factors[24], t387)
        .sub_product(m.factors[25], t393)
        .sub_product(m.factors[26], t394)
        .sub_product(m.factors[27], t396);
    let t398 = (-(m.factors[28] * t381))
        .sub_product(m.factors[29], t385)
        .sub_product(m.factors[30], t387)
        .sub_product(m.factors[31], t393)
        .sub_product(m.factors[32], t394)
        .sub_product(m.factors[33], t396)
        .sub_product(m.factors[34], t397) * m.factors[35];
    let t399 = (t397 * m.factors[36]).sub_product(m.factors[34], t398);
    let t400 = (t396 * m.factors[37])
        .sub_product(m.factors[27], t399)
        .sub_product(m.factors[33], t398);
    let t401 = (t394 * m.factors[38])
        .sub_product(m.factors[20], t400)
        .sub_product(m.factors[26], t399)
        .sub_product(m.factors[32], t398);
    let t402 = (t393 * m.factors[39])
        .sub_product(m.factors[17], t401)
        .sub_product(m.factors[19], t400)
        .sub_product(m.factors[25], t399)
        .sub_product(m.factors[31], t398);
    let t403 = (t387 * m.factors[40])
        .sub_product(m.factors[14], t402)
        .sub_product(m.factors[16], t401)
        .add_product(t21, t400)
        .sub_product(m.factors[24], t399)
        .sub_product(m.factors[30], t398);
    let t404 = (t385 * m.factors[41])
        .sub_product(m.factors[6], t403)
        .sub_product(m.factors[13], t402)
        .sub_product(m.factors[23], t399)
        .sub_product(m.factors[29], t398);
    let t405 = (t381 * m.factors[42])
        .sub_product(m.factors[3], t404)
        .add_product(t20, t403)
        .sub_product(m.factors[12], t402)
        .sub_product(m.factors[22], t399)
        .sub_product(m.factors[28], t398);
    let t406 = (-(m.factors[44] * t404))
        .sub_product(m.factors[43], t405)
        .sub_product(m.factors[45], t399)
        .sub_product(m.factors[46], t398);
    let t407 = (-(m.factors[48] * t405))
        .sub_product(m.factors[47], t406)
        .sub_product(m.factors[49], t404)
        .sub_product(m.factors[50], t399)
        .add_product(t19, t398);
    let t408 = (-(m.factors[53] * t406)).sub_product(m.factors[52], t407);
    let t409 = (-(m.factors[55] * t407))
        .sub_product(m.factors[54], t408)
        .sub_product(m.factors[54], t406);
    let bobbin_v_y_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t398);
    let bobbin_v_x_dot_by_cylinder_v_y = -(R::literal(1.428_571_428_571_428_6) * t399);
    let rod_omega_dot_by_cylinder_v_y = (t18 * t401)
        .sub_product(R::literal(4_166.666_666_666_667), t403)
        .sub_product(m.factors[58], t400);
    let rod_v_y_dot_by_cylinder_v_y = t395
        .sub_product(m.factors[11], t402)
        .sub_product(R::literal(5.0), t400);
    let rod_v_x_dot_by_cylinder_v_y = t363
        .add_product(t17, t402)
        .sub_product(R::literal(5.0), t401);
    let t410 = t90 * R::literal(2_777.777_777_777_778);
    let cylinder_omega_dot_by_cylinder_v_y = t410
        .sub_product(m.factors[1], t405)
        .add_product(t15, t404)
        .sub_product(R::literal(-2_777.777_777_777_778), t403)
        .add_product(t16, t402);
    let cylinder_v_y_dot_by_cylinder_v_y = t383
        .sub_product(R::literal(3.333_333_333_333_333_5), t404)
        .add_product(t14, t402);
    let cylinder_v_x_dot_by_cylinder_v_y = t350
        .sub_product(R::literal(3.333_333_333_333_333_5), t405)
        .sub_product(m.factors[7], t402);
    let plate_omega_dot_by_cylinder_v_y = (t12 * t406)
        .sub_product(m.factors[60], t407)
        .sub_product(m.factors[60], t405)
        .add_product(t12, t404)
        .add_product(t13, t399)
        .sub_product(m.factors[63], t398);
    let plate_v_y_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t404))
        .sub_product(R::literal(0.833_333_333_333_333_4), t406)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t398);
    let plate_v_x_dot_by_cylinder_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t405))
        .sub_product(R::literal(0.833_333_333_333_333_4), t407)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t399);
    let post_omega_dot_by_cylinder_v_y = (t11 * t408)
        .sub_product(m.factors[66], t409)
        .sub_product(m.factors[66], t407)
        .add_product(t11, t406);
    let post_v_y_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t406))
        .sub_product(R::literal(1.25), t408);
    let post_v_x_dot_by_cylinder_v_y = (-(R::literal(-1.25) * t407))
        .sub_product(R::literal(1.25), t409);
    let t411 = R::literal(3.333_333_333_333_333_5) * t86;
    let t412 = (-t411)
        .sub_product(t93, m.cos_cylinder_phi)
        .add_product(m.factors[1], t92);
    let t413 = R::literal(3.333_333_333_333_333_5) * t90;
    let t414 = (-t413)
        .sub_product(t93, m.sin_cylinder_phi)
        .sub_product(t15, t92)
        .sub_product(m.factors[3], t412);
    let t415 = (R::literal(-2_777.777_777_777_778) * t92)
        .add_product(t20, t412)
        .sub_product(m.factors[6], t414);
    let t416 = (-(m.factors[7] * t86))
        .add_product(
            R::literal(2.0),
            (cylinder_x_times_cylinder_omega * m.sin_cylinder_phi)
                .add_product(rod_y_times_cylinder_omega, m.cos_cylinder_phi)
                .add_product(rod_v_x, m.cos_cylinder_phi)
                .add_product(rod_v_y, m.sin_cylinder_phi)
                .sub_product(cylinder_y_times_cylinder_omega, m.cos_cylinder_phi)
                .sub_product(rod_x_times_cylinder_omega, m.sin_cylinder_phi)
                .sub_product(cylinder_v_x, m.cos_cylinder_phi)
                .sub_product(cylinder_v_y, m.sin_cylinder_phi),
        )
        .add_product(t14, t90)
        .sub_product(t16, t92)
        .sub_product(t17, t86)
        .add_product(m.factors[11], t90)
        .sub_product(m.factors[12], t412)
        .sub_product(m.factors[13], t414)
        .sub_product(m.factors[14], t415);
    let t417 = R::literal(5.0) * t86;
    let t418 = t417.sub_product(m.factors[16], t415).sub_product(m.factors[17], t416);
    let t419 = R::literal(5.0) * t90;
    let t420 = t419
        .add_product(t21, t415)
        .sub_product(m.factors[19], t416)
        .sub_product(m.factors[20], t418);
    let t421 = (-(m.factors[22] * t412))
        .sub_product(m.factors[23], t414)
        .sub_product(m.factors[24], t415)
        .sub_product(m.factors[25], t416)
        .sub_product(m.factors[26], t418)
        .sub_product(m.factors[27], t420);
    let t422 = (-(m.factors[28] * t412))
        .sub_product(m.factors[29], t414)
        .sub_product(m.factors[30], t415)
        .sub_product(m.factors[31], t416)
        .sub_product(m.factors[32], t418)
        .sub_product(m.factors[33], t420)
        .sub_product(m.factors[34], t421) * m.factors[35];
    let t423 = (t421 * m.factors[36]).sub_product(m.factors[34], t422);
    let t424 = (t420 * m.factors[37])
        .sub_product(m.factors[27], t423)
        .sub_product(m.factors[33], t422);
    let t425 = (t418 * m.factors[38])
        .sub_product(m.factors[20], t424)
        .sub_product(m.factors[26], t423)
        .sub_product(m.factors[32], t422);
    let t426 = (t416 * m.factors[39])
        .sub_product(m.factors[17], t425)
        .sub_product(m.factors[19], t424)
        .sub_product(m.factors[25], t423)
        .sub_product(m.factors[31], t422);
    let t427 = (t415 * m.factors[40])
        .sub_product(m.factors[14], t426)
        .sub_product(m.factors[16], t425)
        .add_product(t21, t424)
        .sub_product(m.factors[24], t423)
        .sub_product(m.factors[30], t422);
    let t428 = (t414 * m.factors[41])
        .sub_product(m.factors[6], t427)
        .sub_product(m.factors[13], t426)
        .sub_product(m.factors[23], t423)
        .sub_product(m.factors[29], t422);
    let t429 = (t412 * m.factors[42])
        .sub_product(m.factors[3], t428)
        .add_product(t20, t427)
        .sub_product(m.factors[12], t426)
        .sub_product(m.factors[22], t423)
        .sub_product(m.factors[28], t422);
    let t430 = (-(m.factors[44] * t428))
        .sub_product(m.factors[43], t429)
        .sub_product(m.factors[45], t423)
        .sub_product(m.factors[46], t422);
    let t431 = (-(m.factors[48] * t429))
        .sub_product(m.factors[47], t430)
        .sub_product(m.factors[49], t428)
        .sub_product(m.factors[50], t423)
        .add_product(t19, t422);
    let t432 = (-(m.factors[53] * t430)).sub_product(m.factors[52], t431);
    let t433 = (-(m.factors[55] * t431))
        .sub_product(m.factors[54], t432)
        .sub_product(m.factors[54], t430);
    let bobbin_v_y_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t422);
    let bobbin_v_x_dot_by_cylinder_omega = -(R::literal(1.428_571_428_571_428_6) * t423);
    let rod_omega_dot_by_cylinder_omega = (t18 * t425)
        .sub_product(R::literal(4_166.666_666_666_667), t427)
        .sub_product(m.factors[58], t424);
    let rod_v_y_dot_by_cylinder_omega = (-t419)
        .sub_product(m.factors[11], t426)
        .sub_product(R::literal(5.0), t424);
    let rod_v_x_dot_by_cylinder_omega = (-t417)
        .add_product(t17, t426)
        .sub_product(R::literal(5.0), t425);
    let cylinder_omega_dot_by_cylinder_omega = (-(t92
        * R::literal(2_777.777_777_777_778)))
        .sub_product(m.factors[1], t429)
        .add_product(t15, t428)
        .sub_product(R::literal(-2_777.777_777_777_778), t427)
        .add_product(t16, t426);
    let cylinder_v_y_dot_by_cylinder_omega = t413
        .sub_product(R::literal(3.333_333_333_333_333_5), t428)
        .add_product(t14, t426);
    let cylinder_v_x_dot_by_cylinder_omega = t411
        .sub_product(R::literal(3.333_333_333_333_333_5), t429)
        .sub_product(m.factors[7], t426);
    let plate_omega_dot_by_cylinder_omega = (t12 * t430)
        .sub_product(m.factors[60], t431)
        .sub_product(m.factors[60], t429)
        .add_product(t12, t428)
        .add_product(t13, t423)
        .sub_product(m.factors[63], t422);
    let plate_v_y_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t428))
        .sub_product(R::literal(0.833_333_333_333_333_4), t430)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t422);
    let plate_v_x_dot_by_cylinder_omega = (-(R::literal(-0.833_333_333_333_333_4)
        * t429))
        .sub_product(R::literal(0.833_333_333_333_333_4), t431)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t423);
    let post_omega_dot_by_cylinder_omega = (t11 * t432)
        .sub_product(m.factors[66], t433)
        .sub_product(m.factors[66], t431)
        .add_product(t11, t430);
    let post_v_y_dot_by_cylinder_omega = (-(R::literal(-1.25) * t430))
        .sub_product(R::literal(1.25), t432);
    let post_v_x_dot_by_cylinder_omega = (-(R::literal(-1.25) * t431))
        .sub_product(R::literal(1.25), t433);
    let t434 = t347 - t346;
    let t435 = (t350 - t351).sub_product(m.factors[3], t434);
    let t436 = t353.add_product(t20, t434).sub_product(m.factors[6], t435);
    let t437 = (t88 - t355 + t356 - t357 - t358 + t359)
        .sub_product(m.factors[12], t434)
        .sub_product(m.factors[13], t435)
        .sub_product(m.factors[14], t436);
    let t438 = t361.sub_product(m.factors[16], t436).sub_product(m.factors[17], t437);
    let t439 = t363
        .add_product(t21, t436)
        .sub_product(m.factors[19], t437)
        .sub_product(m.factors[20], t438);
    let t440 = (-(m.factors[22] * t434))
        .sub_product(m.factors[23], t435)
        .sub_product(m.factors[24], t436)
        .sub_product(m.factors[25], t437)
        .sub_product(m.factors[26], t438)
        .sub_product(m.factors[27], t439);
    let t441 = (-(m.factors[28] * t434))
        .sub_product(m.factors[29], t435)
        .sub_product(m.factors[30], t436)
        .sub_product(m.factors[31], t437)
        .sub_product(m.factors[32], t438)
        .sub_product(m.factors[33], t439)
        .sub_product(m.factors[34], t440) * m.factors[35];
    let t442 = (t440 * m.factors[36]).sub_product(m.factors[34], t441);
    let t443 = (t439 * m.factors[37])
        .sub_product(m.factors[27], t442)
        .sub_product(m.factors[33], t441);
    let t444 = (t438 * m.factors[38])
        .sub_product(m.factors[20], t443)
        .sub_product(m.factors[26], t442)
        .sub_product(m.factors[32], t441);
    let t445 = (t437 * m.factors[39])
        .sub_product(m.factors[17], t444)
        .sub_product(m.factors[19], t443)
        .sub_product(m.factors[25], t442)
        .sub_product(m.factors[31], t441);
    let t446 = (t436 * m.factors[40])
        .sub_product(m.factors[14], t445)
        .sub_product(m.factors[16], t444)
        .add_product(t21, t443)
        .sub_product(m.factors[24], t442)
        .sub_product(m.factors[30], t441);
    let t447 = (t435 * m.factors[41])
        .sub_product(m.factors[6], t446)
        .sub_product(m.factors[13], t445)
        .sub_product(m.factors[23], t442)
        .sub_product(m.factors[29], t441);
    let t448 = (t434 * m.factors[42])
        .sub_product(m.factors[3], t447)
        .add_product(t20, t446)
        .sub_product(m.factors[12], t445)
        .sub_product(m.factors[22], t442)
        .sub_product(m.factors[28], t441);
    let t449 = (-(m.factors[44] * t447))
        .sub_product(m.factors[43], t448)
        .sub_product(m.factors[45], t442)
        .sub_product(m.factors[46], t441);
    let t450 = (-(m.factors[48] * t448))
        .sub_product(m.factors[47], t449)
        .sub_product(m.factors[49], t447)
        .sub_product(m.factors[50], t442)
        .add_product(t19, t441);
    let t451 = (-(m.factors[53] * t449)).sub_product(m.factors[52], t450);
    let t452 = (-(m.factors[55] * t450))
        .sub_product(m.factors[54], t451)
        .sub_product(m.factors[54], t449);
    let bobbin_v_y_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t441);
    let bobbin_v_x_dot_by_rod_v_x = -(R::literal(1.428_571_428_571_428_6) * t442);
    let rod_omega_dot_by_rod_v_x = (t18 * t444)
        .sub_product(R::literal(4_166.666_666_666_667), t446)
        .sub_product(m.factors[58], t443);
    let rod_v_y_dot_by_rod_v_x = t364
        .sub_product(m.factors[11], t445)
        .sub_product(R::literal(5.0), t443);
    let rod_v_x_dot_by_rod_v_x = (-t361)
        .add_product(t17, t445)
        .sub_product(R::literal(5.0), t444);
    let cylinder_omega_dot_by_rod_v_x = (-t379)
        .sub_product(m.factors[1], t448)
        .add_product(t15, t447)
        .sub_product(R::literal(-2_777.777_777_777_778), t446)
        .add_product(t16, t445);
    let cylinder_v_y_dot_by_rod_v_x = t349
        .sub_product(R::literal(3.333_333_333_333_333_5), t447)
        .add_product(t14, t445);
    let cylinder_v_x_dot_by_rod_v_x = t346
        .sub_product(R::literal(3.333_333_333_333_333_5), t448)
        .sub_product(m.factors[7], t445);
    let plate_omega_dot_by_rod_v_x = (t12 * t449)
        .sub_product(m.factors[60], t450)
        .sub_product(m.factors[60], t448)
        .add_product(t12, t447)
        .add_product(t13, t442)
        .sub_product(m.factors[63], t441);
    let plate_v_y_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t447))
        .sub_product(R::literal(0.833_333_333_333_333_4), t449)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t441);
    let plate_v_x_dot_by_rod_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t448))
        .sub_product(R::literal(0.833_333_333_333_333_4), t450)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t442);
    let post_omega_dot_by_rod_v_x = (t11 * t451)
        .sub_product(m.factors[66], t452)
        .sub_product(m.factors[66], t450)
        .add_product(t11, t449);
    let post_v_y_dot_by_rod_v_x = (-(R::literal(-1.25) * t449))
        .sub_product(R::literal(1.25), t451);
    let post_v_x_dot_by_rod_v_x = (-(R::literal(-1.25) * t450))
        .sub_product(R::literal(1.25), t452);
    let t453 = t380 - t349;
    let t454 = (t383 - t384).sub_product(m.factors[3], t453);
    let t455 = t386.add_product(t20, t453).sub_product(m.factors[6], t454);
    let t456 = (t91 - t388 + t389 - t390 - t391 + t392)
        .sub_product(m.factors[12], t453)
        .sub_product(m.factors[13], t454)
        .sub_product(m.factors[14], t455);
    let t457 = t363.sub_product(m.factors[16], t455).sub_product(m.factors[17], t456);
    let t458 = t395
        .add_product(t21, t455)
        .sub_product(m.factors[19], t456)
        .sub_product(m.factors[20], t457);
    let t459 = (-(m.factors[22] * t453))
        .sub_product(m.factors[23], t454)
        .sub_product(m.factors[24], t455)
        .sub_product(m.factors[25], t456)
        .sub_product(m.factors[26], t457)
        .sub_product(m.factors[27], t458);
    let t460 = (-(m.factors[28] * t453))
        .sub_product(m.factors[29], t454)
        .sub_product(m.factors[30], t455)
        .sub_product(m.factors[31], t456)
        .sub_product(m.factors[32], t457)
        .sub_product(m.factors[33], t458)
        .sub_product(m.factors[34], t459) * m.factors[35];
    let t461 = (t459 * m.factors[36]).sub_product(m.factors[34], t460);
    let t462 = (t458 * m.factors[37])
        .sub_product(m.factors[27], t461)
        .sub_product(m.factors[33], t460);
    let t463 = (t457 * m.factors[38])
        .sub_product(m.factors[20], t462)
        .sub_product(m.factors[26], t461)
        .sub_product(m.factors[32], t460);
    let t464 = (t456 * m.factors[39])
        .sub_product(m.factors[17], t463)
        .sub_product(m.factors[19], t462)
        .sub_product(m.factors[25], t461)
        .sub_product(m.factors[31], t460);
    let t465 = (t455 * m.factors[40])
        .sub_product(m.factors[14], t464)
        .sub_product(m.factors[16], t463)
        .add_product(t21, t462)
        .sub_product(m.factors[24], t461)
        .sub_product(m.factors[30], t460);
    let t466 = (t454 * m.factors[41])
        .sub_product(m.factors[6], t465)
        .sub_product(m.factors[13], t464)
        .sub_product(m.factors[23], t461)
        .sub_product(m.factors[29], t460);
    let t467 = (t453 * m.factors[42])
        .sub_product(m.factors[3], t466)
        .add_product(t20, t465)
        .sub_product(m.factors[12], t464)
        .sub_product(m.factors[22], t461)
        .sub_product(m.factors[28], t460);
    let t468 = (-(m.factors[44] * t466))
        .sub_product(m.factors[43], t467)
        .sub_product(m.factors[45], t461)
        .sub_product(m.factors[46], t460);
    let t469 = (-(m.factors[48] * t467))
        .sub_product(m.factors[47], t468)
        .sub_product(m.factors[49], t466)
        .sub_product(m.factors[50], t461)
        .add_product(t19, t460);
    let t470 = (-(m.factors[53] * t468)).sub_product(m.factors[52], t469);
    let t471 = (-(m.factors[55] * t469))
        .sub_product(m.factors[54], t470)
        .sub_product(m.factors[54], t468);
    let bobbin_v_y_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t460);
    let bobbin_v_x_dot_by_rod_v_y = -(R::literal(1.428_571_428_571_428_6) * t461);
    let rod_omega_dot_by_rod_v_y = (t18 * t463)
        .sub_product(R::literal(4_166.666_666_666_667), t465)
        .sub_product(m.factors[58], t462);
    let rod_v_y_dot_by_rod_v_y = (-t395)
        .sub_product(m.factors[11], t464)
        .sub_product(R::literal(5.0), t462);
    let rod_v_x_dot_by_rod_v_y = (-t363)
        .add_product(t17, t464)
        .sub_product(R::literal(5.0), t463);
    let cylinder_omega_dot_by_rod_v_y = (-t410)
        .sub_product(m.factors[1], t467)
        .add_product(t15, t466)
        .sub_product(R::literal(-2_777.777_777_777_778), t465)
        .add_product(t16, t464);
    let cylinder_v_y_dot_by_rod_v_y = t382
        .sub_product(R::literal(3.333_333_333_333_333_5), t466)
        .add_product(t14, t464);
    let cylinder_v_x_dot_by_rod_v_y = t349
        .sub_product(R::literal(3.333_333_333_333_333_5), t467)
        .sub_product(m.factors[7], t464);
    let plate_omega_dot_by_rod_v_y = (t12 * t468)
        .sub_product(m.factors[60], t469)
        .sub_product(m.factors[60], t467)
        .add_product(t12, t466)
        .add_product(t13, t461)
        .sub_product(m.factors[63], t460);
    let plate_v_y_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t466))
        .sub_product(R::literal(0.833_333_333_333_333_4), t468)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t460);
    let plate_v_x_dot_by_rod_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t467))
        .sub_product(R::literal(0.833_333_333_333_333_4), t469)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t461);
    let post_omega_dot_by_rod_v_y = (t11 * t470)
        .sub_product(m.factors[66], t471)
        .sub_product(m.factors[66], t469)
        .add_product(t11, t468);
    let post_v_y_dot_by_rod_v_y = (-(R::literal(-1.25) * t468))
        .sub_product(R::literal(1.25), t470);
    let post_v_x_dot_by_rod_v_y = (-(R::literal(-1.25) * t469))
        .sub_product(R::literal(1.25), t471);
    let t472 = (t94 * m.sin_rod_phi).sub_product(m.factors[20], t95);
    let t473 = (-(m.factors[26] * t95)).sub_product(m.factors[27], t472);
    let t474 = (-(m.factors[32] * t95))
        .sub_product(m.factors[33], t472)
        .sub_product(m.factors[34], t473) * m.factors[35];
    let t475 = (t473 * m.factors[36]).sub_product(m.factors[34], t474);
    let t476 = (t472 * m.factors[37])
        .sub_product(m.factors[27], t475)
        .sub_product(m.factors[33], t474);
    let t477 = (t95 * m.factors[38])
        .sub_product(m.factors[20], t476)
        .sub_product(m.factors[26], t475)
        .sub_product(m.factors[32], t474);
    let t478 = (-(m.factors[19] * t476))
        .sub_product(m.factors[17], t477)
        .sub_product(m.factors[25], t475)
        .sub_product(m.factors[31], t474);
    let t479 = (-(m.factors[16] * t477))
        .sub_product(m.factors[14], t478)
        .add_product(t21, t476)
        .sub_product(m.factors[24], t475)
        .sub_product(m.factors[30], t474);
    let t480 = (-(m.factors[13] * t478))
        .sub_product(m.factors[6], t479)
        .sub_product(m.factors[23], t475)
        .sub_product(m.factors[29], t474);
    let t481 = (t20 * t479)
        .sub_product(m.factors[3], t480)
        .sub_product(m.factors[12], t478)
        .sub_product(m.factors[22], t475)
        .sub_product(m.factors[28], t474);
    let t482 = (-(m.factors[44] * t480))
        .sub_product(m.factors[43], t481)
        .sub_product(m.factors[45], t475)
        .sub_product(m.factors[46], t474);
    let t483 = (-(m.factors[48] * t481))
        .sub_product(m.factors[47], t482)
        .sub_product(m.factors[49], t480)
        .sub_product(m.factors[50], t475)
        .add_product(t19, t474);
    let t484 = (-(m.factors[53] * t482)).sub_product(m.factors[52], t483);
    let t485 = (-(m.factors[55] * t483))
        .sub_product(m.factors[54], t484)
        .sub_product(m.factors[54], t482);
    let bobbin_v_y_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t474);
    let bobbin_v_x_dot_by_rod_omega = -(R::literal(1.428_571_428_571_428_6) * t475);
    let rod_omega_dot_by_rod_omega = (t18 * t477)
        .sub_product(R::literal(4_166.666_666_666_667), t479)
        .sub_product(m.factors[58], t476);
    let rod_v_y_dot_by_rod_omega = (-(R::literal(5.0) * t476))
        .sub_product(m.factors[11], t478);
    let rod_v_x_dot_by_rod_omega = (-(R::literal(5.0) * t477)).add_product(t17, t478);
    let cylinder_omega_dot_by_rod_omega = (t15 * t480)
        .sub_product(m.factors[1], t481)
        .sub_product(R::literal(-2_777.777_777_777_778), t479)
        .add_product(t16, t478);
    let cylinder_v_y_dot_by_rod_omega = (t14 * t478)
        .sub_product(R::literal(3.333_333_333_333_333_5), t480);
    let cylinder_v_x_dot_by_rod_omega = (-(m.factors[7] * t478))
        .sub_product(R::literal(3.333_333_333_333_333_5), t481);
    let plate_omega_dot_by_rod_omega = (t12 * t482)
        .sub_product(m.factors[60], t483)
        .sub_product(m.factors[60], t481)
        .add_product(t12, t480)
        .add_product(t13, t475)
        .sub_product(m.factors[63], t474);
    let plate_v_y_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t480))
        .sub_product(R::literal(0.833_333_333_333_333_4), t482)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t474);
    let plate_v_x_dot_by_rod_omega = (-(R::literal(-0.833_333_333_333_333_4) * t481))
        .sub_product(R::literal(0.833_333_333_333_333_4), t483)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t475);
    let post_omega_dot_by_rod_omega = (t11 * t484)
        .sub_product(m.factors[66], t485)
        .sub_product(m.factors[66], t483)
        .add_product(t11, t482);
    let post_v_y_dot_by_rod_omega = (-(R::literal(-1.25) * t482))
        .sub_product(R::literal(1.25), t484);
    let post_v_x_dot_by_rod_omega = (-(R::literal(-1.25) * t483))
        .sub_product(R::literal(1.25), t485);
    let t486 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * m.t9 / t70),
        );
    let t487 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * t8 * t9 / t70),
        );
    let t488 = (-t487).add_product(m.factors[34], t486) * m.factors[35];
    let t489 = (-(t486 * m.factors[36])).sub_product(m.factors[34], t488);
    let t490 = (-(m.factors[33] * t488)).sub_product(m.factors[27], t489);
    let t491 = (-(m.factors[26] * t489))
        .sub_product(m.factors[20], t490)
        .sub_product(m.factors[32], t488);
    let t492 = (-(m.factors[19] * t490))
        .sub_product(m.factors[17], t491)
        .sub_product(m.factors[25], t489)
        .sub_product(m.factors[31], t488);
    let t493 = (-(m.factors[16] * t491))
        .sub_product(m.factors[14], t492)
        .add_product(t21, t490)
        .sub_product(m.factors[24], t489)
        .sub_product(m.factors[30], t488);
    let t494 = (-(m.factors[13] * t492))
        .sub_product(m.factors[6], t493)
        .sub_product(m.factors[23], t489)
        .sub_product(m.factors[29], t488);
    let t495 = (t20 * t493)
        .sub_product(m.factors[3], t494)
        .sub_product(m.factors[12], t492)
        .sub_product(m.factors[22], t489)
        .sub_product(m.factors[28], t488);
    let t496 = (-(m.factors[44] * t494))
        .sub_product(m.factors[43], t495)
        .sub_product(m.factors[45], t489)
        .sub_product(m.factors[46], t488);
    let t497 = (-(m.factors[48] * t495))
        .sub_product(m.factors[47], t496)
        .sub_product(m.factors[49], t494)
        .sub_product(m.factors[50], t489)
        .add_product(t19, t488);
    let t498 = (-(m.factors[53] * t496)).sub_product(m.factors[52], t497);
    let t499 = (-(m.factors[55] * t497))
        .sub_product(m.factors[54], t498)
        .sub_product(m.factors[54], t496);
    let bobbin_v_y_dot_by_bobbin_v_x = t487
        .sub_product(R::literal(1.428_571_428_571_428_6), t488);
    let bobbin_v_x_dot_by_bobbin_v_x = t486
        .sub_product(R::literal(1.428_571_428_571_428_6), t489);
    let rod_omega_dot_by_bobbin_v_x = (t18 * t491)
        .sub_product(R::literal(4_166.666_666_666_667), t493)
        .sub_product(m.factors[58], t490);
    let rod_v_y_dot_by_bobbin_v_x = (-(R::literal(5.0) * t490))
        .sub_product(m.factors[11], t492);
    let rod_v_x_dot_by_bobbin_v_x = (-(R::literal(5.0) * t491)).add_product(t17, t492);
    let cylinder_omega_dot_by_bobbin_v_x = (t15 * t494)
        .sub_product(m.factors[1], t495)
        .sub_product(R::literal(-2_777.777_777_777_778), t493)
        .add_product(t16, t492);
    let cylinder_v_y_dot_by_bobbin_v_x = (t14 * t492)
        .sub_product(R::literal(3.333_333_333_333_333_5), t494);
    let cylinder_v_x_dot_by_bobbin_v_x = (-(m.factors[7] * t492))
        .sub_product(R::literal(3.333_333_333_333_333_5), t495);
    let plate_omega_dot_by_bobbin_v_x = (t12 * t496)
        .sub_product(m.factors[60], t497)
        .sub_product(m.factors[60], t495)
        .add_product(t12, t494)
        .add_product(t13, t489)
        .sub_product(m.factors[63], t488);
    let plate_v_y_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t494))
        .sub_product(R::literal(0.833_333_333_333_333_4), t496)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t488);
    let plate_v_x_dot_by_bobbin_v_x = (-(R::literal(-0.833_333_333_333_333_4) * t495))
        .sub_product(R::literal(0.833_333_333_333_333_4), t497)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t489);
    let post_omega_dot_by_bobbin_v_x = (t11 * t498)
        .sub_product(m.factors[66], t499)
        .sub_product(m.factors[66], t497)
        .add_product(t11, t496);
    let post_v_y_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t496))
        .sub_product(R::literal(1.25), t498);
    let post_v_x_dot_by_bobbin_v_x = (-(R::literal(-1.25) * t497))
        .sub_product(R::literal(1.25), t499);
    let t500 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(p.contact_damping * m.t11 / t70),
        );
    let t501 = (-t500).add_product(m.factors[34], t487) * m.factors[35];
    let t502 = (-(t487 * m.factors[36])).sub_product(m.factors[34], t501);
    let t503 = (-(m.factors[33] * t501)).sub_product(m.factors[27], t502);
    let t504 = (-(m.factors[26] * t502))
        .sub_product(m.factors[20], t503)
        .sub_product(m.factors[32], t501);
    let t505 = (-(m.factors[19] * t503))
        .sub_product(m.factors[17], t504)
        .sub_product(m.factors[25], t502)
        .sub_product(m.factors[31], t501);
    let t506 = (-(m.factors[16] * t504))
        .sub_product(m.factors[14], t505)
        .add_product(t21, t503)
        .sub_product(m.factors[24], t502)
        .sub_product(m.factors[30], t501);
    let t507 = (-(m.factors[13] * t505))
        .sub_product(m.factors[6], t506)
        .sub_product(m.factors[23], t502)
        .sub_product(m.factors[29], t501);
    let t508 = (t20 * t506)
        .sub_product(m.factors[3], t507)
        .sub_product(m.factors[12], t505)
        .sub_product(m.factors[22], t502)
        .sub_product(m.factors[28], t501);
    let t509 = (-(m.factors[44] * t507))
        .sub_product(m.factors[43], t508)
        .sub_product(m.factors[45], t502)
        .sub_product(m.factors[46], t501);
    let t510 = (-(m.factors[48] * t508))
        .sub_product(m.factors[47], t509)
        .sub_product(m.factors[49], t507)
        .sub_product(m.factors[50], t502)
        .add_product(t19, t501);
    let t511 = (-(m.factors[53] * t509)).sub_product(m.factors[52], t510);
    let t512 = (-(m.factors[55] * t510))
        .sub_product(m.factors[54], t511)
        .sub_product(m.factors[54], t509);
    let bobbin_v_y_dot_by_bobbin_v_y = t500
        .sub_product(R::literal(1.428_571_428_571_428_6), t501);
    let bobbin_v_x_dot_by_bobbin_v_y = t487
        .sub_product(R::literal(1.428_571_428_571_428_6), t502);
    let rod_omega_dot_by_bobbin_v_y = (t18 * t504)
        .sub_product(R::literal(4_166.666_666_666_667), t506)
        .sub_product(m.factors[58], t503);
    let rod_v_y_dot_by_bobbin_v_y = (-(R::literal(5.0) * t503))
        .sub_product(m.factors[11], t505);
    let rod_v_x_dot_by_bobbin_v_y = (-(R::literal(5.0) * t504)).add_product(t17, t505);
    let cylinder_omega_dot_by_bobbin_v_y = (t15 * t507)
        .sub_product(m.factors[1], t508)
        .sub_product(R::literal(-2_777.777_777_777_778), t506)
        .add_product(t16, t505);
    let cylinder_v_y_dot_by_bobbin_v_y = (t14 * t505)
        .sub_product(R::literal(3.333_333_333_333_333_5), t507);
    let cylinder_v_x_dot_by_bobbin_v_y = (-(m.factors[7] * t505))
        .sub_product(R::literal(3.333_333_333_333_333_5), t508);
    let plate_omega_dot_by_bobbin_v_y = (t12 * t509)
        .sub_product(m.factors[60], t510)
        .sub_product(m.factors[60], t508)
        .add_product(t12, t507)
        .add_product(t13, t502)
        .sub_product(m.factors[63], t501);
    let plate_v_y_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t507))
        .sub_product(R::literal(0.833_333_333_333_333_4), t509)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t501);
    let plate_v_x_dot_by_bobbin_v_y = (-(R::literal(-0.833_333_333_333_333_4) * t508))
        .sub_product(R::literal(0.833_333_333_333_333_4), t510)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t502);
    let post_omega_dot_by_bobbin_v_y = (t11 * t511)
        .sub_product(m.factors[66], t512)
        .sub_product(m.factors[66], t510)
        .add_product(t11, t509);
    let post_v_y_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t509))
        .sub_product(R::literal(1.25), t511);
    let post_v_x_dot_by_bobbin_v_y = (-(R::literal(-1.25) * t510))
        .sub_product(R::literal(1.25), t512);
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
/// 57 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 56] {
    let [_, _, _, _, _, _, cylinder_x, cylinder_y, cylinder_phi, rod_x, rod_y, _,
    bobbin_x, bobbin_y, _, _, _, _, _, _, cylinder_v_x, cylinder_v_y, cylinder_omega,
    rod_v_x, rod_v_y, _, bobbin_v_x, bobbin_v_y, contact_closed, ..] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let (sin_cylinder_phi, cos_cylinder_phi) = cylinder_phi.sin_cos();
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let between = (t0 * t0).add_product(t1, t1).sqrt();
    let contact_gap = between - R::literal(0.1);
    let rod_x_minus_cylinder_x = rod_x - cylinder_x;
    let rod_y_minus_cylinder_y = rod_y - cylinder_y;
    let slide = (rod_x_minus_cylinder_x * cos_cylinder_phi)
        .add_product(rod_y_minus_cylinder_y, sin_cylinder_phi);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let t2 = (rod_y_minus_cylinder_y * cos_cylinder_phi)
        .sub_product(rod_x_minus_cylinder_x, sin_cylinder_phi);
    let slide_rate = ((rod_v_x - cylinder_v_x) * cos_cylinder_phi)
        .add_product(cylinder_omega, t2)
        .add_product(rod_v_y - cylinder_v_y, sin_cylinder_phi);
    let t3 = slide - R::literal(0.116);
    let t4 = t3 * cos_cylinder_phi;
    let t5 = t3 * sin_cylinder_phi;
    let slide_rate_times_cos_cylinder_phi = slide_rate * cos_cylinder_phi;
    let slide_rate_times_sin_cylinder_phi = slide_rate * sin_cylinder_phi;
    let mut x = [[R::literal(0.0); 4]; 26];
    x[6][0] = t4;
    x[7][0] = t5;
    x[8][0] = -(t3 * t2);
    x[9][0] = -t4;
    x[10][0] = -t5;
    x[6][1] = slide_rate_times_cos_cylinder_phi;
    x[7][1] = slide_rate_times_sin_cylinder_phi;
    x[8][1] = -(slide_rate * t2);
    x[9][1] = -slide_rate_times_cos_cylinder_phi;
    x[10][1] = -slide_rate_times_sin_cylinder_phi;
    x[12][2] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_gap * t0 / between),
    );
    x[13][2] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_gap * t1 / between),
    );
    x[12][3] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_rate * t0 / between),
    );
    x[13][3] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(contact_rate * t1 / between),
    );
    substitute(PARAMETER_JACOBIAN_STEPS.iter().copied(), &m.factors, &mut x);
    [
        x[0][0], x[0][1], x[0][2], x[0][3], x[1][0], x[1][1], x[1][2], x[1][3], x[2][0], x[2][1],
        x[2][2], x[2][3], x[3][0], x[3][1], x[3][2], x[3][3], x[4][0], x[4][1], x[4][2], x[4][3],
        x[5][0], x[5][1], x[5][2], x[5][3], x[6][0], x[6][1], x[6][2], x[6][3], x[7][0], x[7][1],
        x[7][2], x[7][3], x[8][0], x[8][1], x[8][2], x[8][3], x[9][0], x[9][1], x[9][2], x[9][3],
        x[10][0], x[10][1], x[10][2], x[10][3], x[11][0], x[11][1], x[11][2], x[11][3], x[12][0],
        x[12][1], x[12][2], x[12][3], x[13][0], x[13][1], x[13][2], x[13][3],
    ]
}

static PARAMETER_JACOBIAN_STEPS: &[Step<'static>] = &[
    Step::less(18, &[(0, 6), (1, 8)]),
    Step::less(19, &[(0, 7), (2, 8), (3, 18)]),
    Step::less(20, &[(4, 8), (5, 18), (6, 19)]),
    Step::less(
        21,
        &[(7, 6), (8, 7), (9, 8), (10, 9), (11, 10), (12, 18), (13, 19), (14, 20)],
    ),
    Step::less(22, &[(15, 9), (16, 20), (17, 21)]),
    Step::less(23, &[(15, 10), (18, 20), (19, 21), (20, 22)]),
    Step::less(
        24,
        &[(21, 12), (22, 18), (23, 19), (24, 20), (25, 21), (26, 22), (27, 23)],
    ),
    Step::less(
        25,
        &[(21, 13), (28, 18), (29, 19), (30, 20), (31, 21), (32, 22), (33, 23), (34, 24)],
    ),
    Step::scaled(25, 35, &[]),
    Step::scaled(24, 36, &[(34, 25)]),
    Step::scaled(23, 37, &[(27, 24), (33, 25)]),
    Step::scaled(22, 38, &[(20, 23), (26, 24), (32, 25)]),
    Step::scaled(21, 39, &[(17, 22), (19, 23), (25, 24), (31, 25)]),
    Step::scaled(20, 40, &[(14, 21), (16, 22), (18, 23), (24, 24), (30, 25)]),
    Step::scaled(19, 41, &[(6, 20), (13, 21), (23, 24), (29, 25)]),
    Step::scaled(18, 42, &[(3, 19), (5, 20), (12, 21), (22, 24), (28, 25)]),
    Step::less(17, &[(43, 18), (44, 19), (45, 24), (46, 25)]),
    Step::less(16, &[(47, 17), (48, 18), (49, 19), (50, 24), (51, 25)]),
    Step::less(15, &[(52, 16), (53, 17)]),
    Step::less(14, &[(54, 15), (55, 16), (54, 17)]),
    Step::scaled(13, 21, &[(21, 25)]),
    Step::scaled(12, 21, &[(21, 24)]),
    Step::less(11, &[(56, 20), (57, 22), (58, 23)]),
    Step::scaled(10, 15, &[(11, 21), (15, 23)]),
    Step::scaled(9, 15, &[(10, 21), (15, 22)]),
    Step::scaled(8, 59, &[(1, 18), (2, 19), (4, 20), (9, 21)]),
    Step::scaled(7, 0, &[(0, 19), (8, 21)]),
    Step::scaled(6, 0, &[(0, 18), (7, 21)]),
    Step::less(5, &[(60, 16), (61, 17), (60, 18), (61, 19), (62, 24), (63, 25)]),
    Step::less(4, &[(64, 17), (65, 19), (65, 25)]),
    Step::less(3, &[(64, 16), (65, 18), (65, 24)]),
    Step::less(2, &[(66, 14), (67, 15), (66, 16), (67, 17)]),
    Step::less(1, &[(68, 15), (69, 17)]),
    Step::less(0, &[(68, 14), (69, 16)]),
];

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
/// 106 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [_, _, _, _, _, _, _, _, _, _, _, _, bobbin_x, bobbin_y, post_v_x, post_v_y,
    post_omega, plate_v_x, plate_v_y, plate_omega, cylinder_v_x, cylinder_v_y,
    cylinder_omega, rod_v_x, rod_v_y, rod_omega, bobbin_v_x, bobbin_v_y, contact_closed,
    stop_closed] = *state;
    let m = &motion(time, state, p, &prepare(p));
    let stop_rate = post_omega * m.t7;
    let t0 = (R::literal(7.848) * post_v_y)
        .add_product(
            R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(1_000_000.0) * m.stop_gap * m.t7,
            ),
            post_omega,
        )
        .add_product(R::literal(11.772), plate_v_y)
        .sub_product(m.t149, cylinder_v_x)
        .add_product(R::literal(2.943) - m.t152, cylinder_v_y)
        .add_product(m.t155, cylinder_omega)
        .add_product(m.t149, rod_v_x)
        .add_product(R::literal(1.962) + m.t152, rod_v_y)
        .add_product(
            R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t160),
            bobbin_v_x,
        )
        .add_product(
            R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    m.t162,
                ),
            bobbin_v_y,
        )
        .add_product(R::literal(0.8) * post_v_x, m.post_v_x_dot)
        .add_product(R::literal(0.8) * post_v_y, m.post_v_y_dot)
        .add_product(R::literal(0.0027) * post_omega, m.post_omega_dot);
    let t1 = (p.spring_damping * cylinder_omega * m.slide_rate * m.t12)
        .add_product(p.spring_damping * rod_v_x * m.slide_rate, m.cos_cylinder_phi)
        .add_product(p.spring_damping * rod_v_y * m.slide_rate, m.sin_cylinder_phi)
        + R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            p.contact_damping * bobbin_v_x * m.contact_rate
                * (bobbin_x - R::literal(0.328)) / m.between
                + p.contact_damping * bobbin_v_y * m.contact_rate
                    * (bobbin_y - R::literal(0.058)) / m.between,
        );
    PowerBalance {
        stored_rate: t0
            .add_product(R::literal(1.2) * plate_v_x, m.plate_v_x_dot)
            .add_product(R::literal(1.2) * plate_v_y, m.plate_v_y_dot)
            .add_product(R::literal(0.0025) * plate_omega, m.plate_omega_dot)
            .add_product(R::literal(0.3) * cylinder_v_x, m.cylinder_v_x_dot)
            .add_product(R::literal(0.3) * cylinder_v_y, m.cylinder_v_y_dot)
            .add_product(R::literal(0.00036) * cylinder_omega, m.cylinder_omega_dot)
            .add_product(R::literal(0.2) * rod_v_x, m.rod_v_x_dot)
            .add_product(R::literal(0.2) * rod_v_y, m.rod_v_y_dot)
            .add_product(R::literal(0.00024) * rod_omega, m.rod_omega_dot)
            .add_product(R::literal(0.7) * bobbin_v_x, m.bobbin_v_x_dot)
            .add_product(R::literal(0.7) * bobbin_v_y, m.bobbin_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: (t1
            + R::select_less(
                stop_closed,
                R::literal(0.5),
                R::literal(0.0),
                R::literal(1500.0) * (stop_rate * stop_rate),
            ))
            .sub_product(
                p.spring_damping * cylinder_v_x * m.slide_rate,
                m.cos_cylinder_phi,
            )
            .sub_product(
                p.spring_damping * cylinder_v_y * m.slide_rate,
                m.sin_cylinder_phi,
            ),
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
    let stop_push = (-(R::literal(1_000_000.0) * stop_gap))
        .sub_product(R::literal(1500.0), stop_rate);
    let contact_rate = (bobbin_v_x * t0).add_product(bobbin_v_y, t1) / between;
    let contact_push = (-(p.contact_stiffness * contact_gap))
        .sub_product(p.contact_damping, contact_rate);
    [contact_gap, contact_push, stop_gap, stop_push]
}

/// `dg/dt` of the guards along the motion.
///
/// 50 operations.
#[must_use]
pub fn guard_rates<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; EVENTS] {
    let bobbin_x = state[12];
    let bobbin_y = state[13];
    let post_omega = state[16];
    let bobbin_v_x = state[26];
    let bobbin_v_y = state[27];
    let m = &motion(time, state, p, &prepare(p));
    let stop_rate = post_omega * m.t7;
    let t0 = bobbin_x - R::literal(0.328);
    let t1 = bobbin_y - R::literal(0.058);
    let t2 = m.between * m.between;
    let contact_touches_guard_rate = (t0 / m.between * bobbin_v_x)
        .add_product(t1 / m.between, bobbin_v_y);
    let contact_opens_guard_rate = ((m.t161 / t2
        - p.contact_damping * bobbin_v_x / m.between
        - p.contact_stiffness * t0 / m.between) * bobbin_v_x)
        .add_product(
            m.t163 / t2 - p.contact_damping * bobbin_v_y / m.between
                - p.contact_stiffness * t1 / m.between,
            bobbin_v_y,
        )
        .sub_product(p.contact_damping * t0 / m.between, m.bobbin_v_x_dot)
        .sub_product(p.contact_damping * t1 / m.between, m.bobbin_v_y_dot);
    let stop_opens_guard_rate = ((-(R::literal(66.0) * m.sin_post_phi))
        .sub_product(R::literal(214.5), m.cos_post_phi) * m.post_omega_dot)
        .add_product(
            (-(R::literal(143_000.0) * m.cos_post_phi))
                .add_product(R::literal(214.5) * post_omega, m.sin_post_phi)
                .sub_product(R::literal(44000.0), m.sin_post_phi)
                .sub_product(R::literal(66.0) * post_omega, m.cos_post_phi),
            post_omega,
        );
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

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
//   rate_jacobian           360
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
//   prepared_rate_jacobian  359
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
    pub factors: [R; 76],
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
    pub t137: R,
    pub t140: R,
    pub t143: R,
    pub t147: R,
    pub t148: R,
    pub t149: R,
    pub t150: R,
    pub t151: R,
    pub t153: R,
    pub t154: R,
    pub t156: R,
    pub t157: R,
    pub t159: R,
    pub t160: R,
    pub t182: R,
    pub t183: R,
    pub t184: R,
    pub t185: R,
    pub t186: R,
    pub t187: R,
    pub t190: R,
    pub t192: R,
    pub t194: R,
    pub t195: R,
    pub t196: R,
    pub t197: R,
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
    let t49 = (t15 * t0).sub_product(t44, t41);
    let t50 = t49 * t48;
    let t51 = R::literal(1.25) - t45 - t47;
    let t52 = t51 * t48;
    let t53 = t18 * t3;
    let t54 = R::literal(1.0)
        / (t39 - R::literal(0.833_333_333_333_333_4) - t53)
            .sub_product(t44, t43)
            .sub_product(t50, t49);
    let t55 = t19 * t3;
    let t56 = (t41 + t55).sub_product(t42, t43).sub_product(t52, t49);
    let t57 = t56 * t54;
    let t58 = R::literal(0.833_333_333_333_333_4) - t53;
    let t59 = t58 * t54;
    let t60 = t55 * t54;
    let t61 = t21 * t3;
    let t62 = R::literal(0.833_333_333_333_333_4) + t61;
    let t63 = t62 * t54;
    let t64 = t23 * t3;
    let t65 = t64 * t54;
    let t66 = -t65;
    let t67 = t19 * t2;
    let t68 = R::literal(1.0)
        / (t46 - R::literal(0.833_333_333_333_333_4) - t67 - t47)
            .sub_product(t52, t51)
            .sub_product(t57, t56);
    let t69 = (t18 * t2).sub_product(t59, t56);
    let t70 = t69 * t68;
    let t71 = (R::literal(0.833_333_333_333_333_4) - t67).sub_product(t60, t56);
    let t72 = t71 * t68;
    let t73 = -(t21 * t2);
    let t74 = t73.sub_product(t63, t56);
    let t75 = t74 * t68;
    let t76 = t23 * t2;
    let t77 = (R::literal(0.833_333_333_333_333_4) + t76).add_product(t65, t56);
    let t78 = t77 * t68;
    let t79 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t53
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t27, t5)
            .sub_product(t59, t58)
            .sub_product(t70, t69);
    let t80 = t55.add_product(t28, t5).sub_product(t60, t58).sub_product(t72, t69);
    let t81 = t80 * t79;
    let t82 = R::literal(-166.666_666_666_666_66) * sin_cylinder_phi;
    let t83 = t82 * t79;
    let t84 = -t83;
    let t85 = (-t24).add_product(t30, t5);
    let t86 = t85 * t79;
    let t87 = (R::literal(-0.833_333_333_333_333_4) + t61)
        .sub_product(t63, t58)
        .sub_product(t75, t69);
    let t88 = t87 * t79;
    let t89 = (-t64).add_product(t65, t58).sub_product(t78, t69);
    let t90 = t89 * t79;
    let t91 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4) - t67
            - R::literal(3.333_333_333_333_333_5))
            .sub_product(t28, t4)
            .sub_product(t60, t55)
            .sub_product(t72, t71)
            .sub_product(t81, t80);
    let t92 = (R::literal(-166.666_666_666_666_66) * cos_cylinder_phi)
        .add_product(t83, t80);
    let t93 = t92 * t91;
    let t94 = t25.sub_product(t30, t4).sub_product(t86, t80);
    let t95 = t94 * t91;
    let t96 = t73.sub_product(t63, t55).sub_product(t75, t71).sub_product(t88, t80);
    let t97 = t96 * t91;
    let t98 = (R::literal(-0.833_333_333_333_333_4) + t76)
        .add_product(t65, t55)
        .sub_product(t78, t71)
        .sub_product(t90, t80);
    let t99 = t98 * t91;
    let t100 = R::literal(1.0)
        / R::literal(-6_944.444_444_444_445).sub_product(t83, t82).sub_product(t93, t92);
    let t101 = (-t30).add_product(t86, t82).sub_product(t95, t92);
    let t102 = t101 * t100;
    let t103 = t35 * t100;
    let t104 = t37 * t100;
    let t105 = -t104;
    let t106 = (t88 * t82).sub_product(t97, t92);
    let t107 = t106 * t100;
    let t108 = (t90 * t82).sub_product(t99, t92);
    let t109 = t108 * t100;
    let t110 = R::literal(1.0)
        / (-(t25 * cos_cylinder_phi))
            .sub_product(t24, sin_cylinder_phi)
            .sub_product(t30, slide)
            .sub_product(t32, sin_cylinder_phi)
            .sub_product(t34, cos_cylinder_phi)
            .sub_product(t86, t85)
            .sub_product(t95, t94)
            .sub_product(t102, t101);
    let t111 = t32.sub_product(t103, t101);
    let t112 = t111 * t110;
    let t113 = (-t34).add_product(t104, t101);
    let t114 = t113 * t110;
    let t115 = (-(t88 * t85)).sub_product(t97, t94).sub_product(t107, t101);
    let t116 = t115 * t110;
    let t117 = (-(t90 * t85)).sub_product(t99, t94).sub_product(t109, t101);
    let t118 = t117 * t110;
    let t119 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t35, t6)
            .sub_product(t103, t35)
            .sub_product(t112, t111);
    let t120 = (t37 * t6).add_product(t104, t35).sub_product(t114, t111);
    let t121 = t120 * t119;
    let t122 = (-(t107 * t35)).sub_product(t116, t111);
    let t123 = t122 * t119;
    let t124 = (-(t109 * t35)).sub_product(t118, t111);
    let t125 = t124 * t119;
    let t126 = R::literal(1.0)
        / R::literal(-5.0)
            .sub_product(t37, R::literal(0.06) * cos_rod_phi)
            .sub_product(t104, t37)
            .sub_product(t114, t113)
            .sub_product(t121, t120);
    let t127 = (t107 * t37).sub_product(t116, t113).sub_product(t123, t120);
    let t128 = t127 * t126;
    let t129 = (t109 * t37).sub_product(t118, t113).sub_product(t125, t120);
    let t130 = t129 * t126;
    let t131 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t21, t13)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t63, t62)
            .sub_product(t75, t74)
            .sub_product(t88, t87)
            .sub_product(t97, t96)
            .sub_product(t107, t106)
            .sub_product(t116, t115)
            .sub_product(t123, t122)
            .sub_product(t128, t127);
    let t132 = (t23 * t13)
        .add_product(t65, t62)
        .sub_product(t78, t74)
        .sub_product(t90, t87)
        .sub_product(t99, t96)
        .sub_product(t109, t106)
        .sub_product(t118, t115)
        .sub_product(t125, t122)
        .sub_product(t130, t127);
    let t133 = t132 * t131;
    let t134 = R::literal(1.0)
        / (R::literal(-0.833_333_333_333_333_4).sub_product(t23, t14)
            - R::literal(1.428_571_428_571_428_6))
            .sub_product(t65, t64)
            .sub_product(t78, t77)
            .sub_product(t90, t89)
            .sub_product(t99, t98)
            .sub_product(t109, t108)
            .sub_product(t118, t117)
            .sub_product(t125, t124)
            .sub_product(t130, t129)
            .sub_product(t133, t132);
    let t135 = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        (-(R::literal(1_000_000.0) * stop_gap * t7))
            .sub_product(R::literal(1500.0) * stop_rate, t7),
    );
    let t136 = p.spring_stiffness * (slide - R::literal(0.116));
    let t137 = t136 * cos_cylinder_phi;
    let spring_damping_times_slide_rate = p.spring_damping * slide_rate;
    let t138 = spring_damping_times_slide_rate * cos_cylinder_phi;
    let t139 = t137 + t138;
    let t140 = t136 * sin_cylinder_phi;
    let t141 = spring_damping_times_slide_rate * sin_cylinder_phi;
    let t142 = t141 - (R::literal(2.943) - t140);
    let t143 = t136 * t12;
    let t144 = (-t143).sub_product(spring_damping_times_slide_rate, t12);
    let t145 = -t137 - t138;
    let t146 = -t141 - (R::literal(1.962) + t140);
    let t147 = contact_stiffness_times_contact_gap * t8;
    let t148 = t147 / between;
    let t149 = contact_damping_times_contact_rate * t8;
    let t150 = contact_stiffness_times_contact_gap * t10 / between;
    let t151 = contact_damping_times_contact_rate * t10;
    let t152 = R::literal(0.1) * (post_omega * post_omega);
    let t153 = t152 * cos_post_phi;
    let t154 = t152 * sin_post_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let t155 = R::literal(0.06) * plate_omega_squared;
    let t156 = t155 * cos_plate_phi;
    let t157 = t155 * sin_plate_phi;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t158 = R::literal(0.06) * (rod_omega * rod_omega);
    let t159 = t158 * cos_rod_phi;
    let t160 = t158 * sin_rod_phi;
    let t161 = t15 * t135;
    let t162 = -t153 - t161;
    let t163 = t16 * t135;
    let t164 = t42 * t162;
    let t165 = -t154 - R::literal(-9.81) + t163 - t164;
    let t166 = (-(t156 + t153) - t161).sub_product(t44, t162).sub_product(t50, t165);
    let t167 = (-(t157 + t154) - R::literal(9.81) + t163 - R::literal(-9.81) - t164)
        .sub_product(t52, t165)
        .sub_product(t57, t166);
    let t168 = R::literal(3.333_333_333_333_333_5) * t139;
    let t169 = (-t168)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * cos_plate_phi)
                .add_product(cylinder_omega_squared, cos_cylinder_phi),
        )
        .sub_product(t27, t144)
        .sub_product(t59, t166)
        .sub_product(t70, t167);
    let t170 = R::literal(3.333_333_333_333_333_5) * t142;
    let t171 = (R::literal(-9.81)
        .sub_product(
            R::literal(0.06),
            (plate_omega_squared * sin_plate_phi)
                .add_product(cylinder_omega_squared, sin_cylinder_phi),
        ) - t170)
        .add_product(t28, t144)
        .sub_product(t60, t166)
        .sub_product(t72, t167)
        .sub_product(t81, t169);
    let t172 = (-(R::literal(-2_777.777_777_777_778) * t144))
        .add_product(t83, t169)
        .sub_product(t93, t171);
    let t173 = (cylinder_omega
        * (R::literal(2.0) * rod_v_x * cos_cylinder_phi)
            .add_product(R::literal(2.0) * rod_v_y, sin_cylinder_phi)
            .add_product(cylinder_x * cylinder_omega, sin_cylinder_phi)
            .add_product(rod_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_x, cos_cylinder_phi)
            .sub_product(R::literal(2.0) * cylinder_v_y, sin_cylinder_phi)
            .sub_product(cylinder_y * cylinder_omega, cos_cylinder_phi)
            .sub_product(rod_x * cylinder_omega, sin_cylinder_phi))
        .sub_product(t24, t139)
        .add_product(t25, t142)
        .add_product(t30, t144)
        .add_product(t32, t145)
        .sub_product(t34, t146)
        .sub_product(t86, t169)
        .sub_product(t95, t171);
    let t174 = t173.sub_product(t102, t172);
    let t175 = R::literal(5.0) * t145;
    let t176 = (t159 - t175).sub_product(t103, t172).sub_product(t112, t174);
    let t177 = R::literal(5.0) * t146;
    let t178 = (t160 - t177)
        .add_product(t104, t172)
        .sub_product(t114, t174)
        .sub_product(t121, t176);
    let t179 = R::literal(1.428_571_428_571_428_6)
        * R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -t148 - t149 / between,
        );
    let t180 = (-t179)
        .add_product(t14, plate_omega_squared)
        .sub_product(t63, t166)
        .sub_product(t75, t167)
        .sub_product(t88, t169)
        .sub_product(t97, t171)
        .sub_product(t107, t172)
        .sub_product(t116, t174)
        .sub_product(t123, t176)
        .sub_product(t128, t178);
    let t181 = R::literal(1.428_571_428_571_428_6)
        * (R::select_less(
            contact_closed,
            R::literal(0.5),
            R::literal(0.0),
            -(t151 / between),
        )
            - (R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    t150,
                )));
    let t182 = (R::literal(-9.81).add_product(t13, plate_omega_squared) - t181)
        .add_product(t65, t166)
        .sub_product(t78, t167)
        .sub_product(t90, t169)
        .sub_product(t99, t171)
        .sub_product(t109, t172)
        .sub_product(t118, t174)
        .sub_product(t125, t176)
        .sub_product(t130, t178)
        .sub_product(t133, t180) * t134;
    let t183 = (t180 * t131).sub_product(t133, t182);
    let t184 = (t178 * t126).sub_product(t128, t183).sub_product(t130, t182);
    let t185 = (t176 * t119)
        .sub_product(t121, t184)
        .sub_product(t123, t183)
        .sub_product(t125, t182);
    let t186 = (t174 * t110)
        .sub_product(t112, t185)
        .sub_product(t114, t184)
        .sub_product(t116, t183);
    let t187 = t118 * t182;
    let t188 = t186 - t187;
    let t189 = (t172 * t100)
        .sub_product(t102, t188)
        .sub_product(t103, t185)
        .add_product(t104, t184)
        .sub_product(t107, t183)
        .sub_product(t109, t182);
    let t190 = (t171 * t91)
        .sub_product(t93, t189)
        .sub_product(t95, t188)
        .sub_product(t97, t183);
    let t191 = t190.sub_product(t99, t182);
    let t192 = (t169 * t79)
        .sub_product(t81, t191)
        .add_product(t83, t189)
        .sub_product(t86, t188)
        .sub_product(t88, t183);
    let t193 = t192.sub_product(t90, t182);
    let t194 = (t167 * t68)
        .sub_product(t70, t193)
        .sub_product(t72, t191)
        .sub_product(t75, t183)
        .sub_product(t78, t182);
    let t195 = (t166 * t54)
        .sub_product(t57, t194)
        .sub_product(t59, t193)
        .sub_product(t60, t191)
        .sub_product(t63, t183)
        .add_product(t65, t182);
    let t196 = (t165 * t48).sub_product(t50, t195).sub_product(t52, t194);
    let t197 = (t162 * t40)
        .sub_product(t42, t196)
        .sub_product(t44, t195)
        .sub_product(t42, t194);
    let bobbin_v_y_dot = t181.sub_product(R::literal(1.428_571_428_571_428_6), t182);
    let bobbin_v_x_dot = t179.sub_product(R::literal(1.428_571_428_571_428_6), t183);
    let rod_omega_dot = (t35 * t185)
        .sub_product(R::literal(4_166.666_666_666_667), t189)
        .sub_product(t37, t184);
    let rod_v_y_dot = t177.sub_product(t34, t188).sub_product(R::literal(5.0), t184);
    let rod_v_x_dot = t175.add_product(t32, t188).sub_product(R::literal(5.0), t185);
    let cylinder_omega_dot = (t144 * R::literal(2_777.777_777_777_778))
        .sub_product(t27, t193)
        .add_product(t28, t191)
        .sub_product(R::literal(-2_777.777_777_777_778), t189)
        .add_product(t30, t188);
    let cylinder_v_y_dot = t170
        .sub_product(R::literal(3.333_333_333_333_333_5), t191)
        .add_product(t25, t188);
    let cylinder_v_x_dot = t168
        .sub_product(R::literal(3.333_333_333_333_333_5), t193)
        .sub_product(t24, t188);
    let plate_omega_dot = (t19 * t194)
        .sub_product(t18, t195)
        .sub_product(t18, t193)
        .add_product(t19, t191)
        .add_product(t21, t183)
        .sub_product(t23, t182);
    let plate_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(0.833_333_333_333_333_4), t194)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t191)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t182);
    let plate_v_x_dot = (-(R::literal(-0.833_333_333_333_333_4) * t193))
        .sub_product(R::literal(0.833_333_333_333_333_4), t195)
        .sub_product(R::literal(-0.833_333_333_333_333_4), t183);
    let post_omega_dot = (t135 * R::literal(370.370_370_370_370_3))
        .sub_product(t15, t197)
        .add_product(t16, t196)
        .sub_product(t15, t195)
        .add_product(t16, t194);
    let post_v_y_dot = R::literal(-9.81)
        .sub_product(R::literal(1.25), t196)
        .sub_product(R::literal(-1.25), t194);
    let post_v_x_dot = (-(R::literal(-1.25) * t195)).sub_product(R::literal(1.25), t197);
    Motion {
        factors: [
            t15,
            t17,
            t42,
            t18,
            t44,
            t50,
            t20,
            t52,
            t57,
            R::literal(3.333_333_333_333_333_5),
            t27,
            t59,
            t70,
            t29,
            t60,
            t72,
            t81,
            R::literal(-2_777.777_777_777_778),
            R::literal(4_166.666_666_666_667),
            t84,
            t93,
            t24,
            t26,
            t31,
            t33,
            t34,
            t86,
            t95,
            t102,
            R::literal(5.0),
            t36,
            t103,
            t112,
            t37,
            t105,
            t114,
            t121,
            t22,
            R::literal(1.428_571_428_571_428_6),
            t63,
            t75,
            t88,
            t97,
            t107,
            t116,
            t123,
            t128,
            t23,
            t66,
            t78,
            t90,
            t99,
            t109,
            t118,
            t125,
            t130,
            t133,
            t134,
            t131,
            t126,
            t119,
            t110,
            t100,
            t91,
            t79,
            t68,
            t54,
            t48,
            t40,
            R::literal(2_777.777_777_777_778),
            R::literal(400.0),
            R::literal(0.833_333_333_333_333_4),
            R::literal(-0.833_333_333_333_333_4),
            R::literal(370.370_370_370_370_3),
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
        t137,
        t140,
        t143,
        t147,
        t148,
        t149,
        t150,
        t151,
        t153,
        t154,
        t156,
        t157,
        t159,
        t160,
        t182,
        t183,
        t184,
        t185,
        t186,
        t187,
        t190,
        t192,
        t194,
        t195,
        t196,
        t197,
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
/// 360 operations.
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
/// 359 operations.
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
    let t11 = p.spring_damping * m.slide_rate;
    let t12 = t11 * m.cos_cylinder_phi;
    let t13 = t11 * m.sin_cylinder_phi;
    let plate_omega_squared = plate_omega * plate_omega;
    let cylinder_omega_squared = cylinder_omega * cylinder_omega;
    let t14 = cylinder_omega_squared * m.cos_cylinder_phi;
    let t15 = cylinder_omega_squared * m.sin_cylinder_phi;
    let cylinder_y_times_cylinder_omega = cylinder_y * cylinder_omega;
    let rod_x_times_cylinder_omega = rod_x * cylinder_omega;
    let cylinder_x_times_cylinder_omega = cylinder_x * cylinder_omega;
    let rod_y_times_cylinder_omega = rod_y * cylinder_omega;
    let t16 = m.t186 - m.t187;
    let t17 = m.t190.sub_product(m.factors[51], m.t182);
    let t18 = m.t192.sub_product(m.factors[50], m.t182);
    let t19 = m.t7 * m.t7;
    let t20 = m.t154.sub_product(t0, m.post_omega_dot);
    let t21 = (-m.t153).sub_product(t1, m.post_omega_dot);
    let t22 = m.t157.sub_product(t2, m.plate_omega_dot);
    let t23 = (-m.t156).sub_product(t3, m.plate_omega_dot);
    let t24 = p.spring_stiffness * m.cos_cylinder_phi;
    let spring_damping_times_cylinder_omega = p.spring_damping * cylinder_omega;
    let t25 = spring_damping_times_cylinder_omega * m.sin_cylinder_phi;
    let t26 = t25 - t24;
    let t27 = t26 * m.cos_cylinder_phi;
    let t28 = t26 * m.sin_cylinder_phi;
    let t29 = spring_damping_times_cylinder_omega * m.t12;
    let t30 = t29 * m.sin_cylinder_phi;
    let t31 = p.spring_stiffness * m.t12;
    let t32 = t31 * m.cos_cylinder_phi;
    let t33 = t24 - t25;
    let t34 = t33 * m.cos_cylinder_phi;
    let t35 = t33 * m.sin_cylinder_phi;
    let t36 = m.cos_cylinder_phi * t16;
    let t37 = m.cos_cylinder_phi * m.cylinder_omega_dot;
    let t38 = (p.spring_stiffness * m.sin_cylinder_phi)
        .add_product(spring_damping_times_cylinder_omega, m.cos_cylinder_phi);
    let t39 = t38 * m.cos_cylinder_phi;
    let t40 = -t39;
    let t41 = t38 * m.sin_cylinder_phi;
    let t42 = -t41;
    let t43 = t29 * m.cos_cylinder_phi;
    let t44 = t31 * m.sin_cylinder_phi;
    let t45 = m.sin_cylinder_phi * t16;
    let t46 = m.sin_cylinder_phi * m.cylinder_omega_dot;
    let t47 = p.spring_damping
        * (-(cylinder_omega * m.slide))
            .add_product(rod_v_y - cylinder_v_y, m.cos_cylinder_phi)
            .sub_product(rod_v_x - cylinder_v_x, m.sin_cylinder_phi);
    let t48 = t47 * m.cos_cylinder_phi;
    let t49 = t47 * m.sin_cylinder_phi;
    let t50 = m.t12 * m.t12;
    let t51 = R::literal(0.06) * cylinder_omega_squared;
    let t52 = ((rod_x - cylinder_x) * m.sin_cylinder_phi)
        .sub_product(rod_y - cylinder_y, m.cos_cylinder_phi);
    let t53 = m.between * m.between;
    let contact_damping_times_bobbin_v_x = p.contact_damping * bobbin_v_x;
    let t54 = contact_stiffness_times_contact_gap / m.between;
    let t55 = p.contact_damping * m.contact_rate / m.between;
    let t56 = t53 * m.between;
    let t57 = c.t0 * m.contact_rate;
    let t58 = t57 * t8 * t9 / t56;
    let t59 = m.t147 * t9 / t56;
    let t60 = p.contact_stiffness * t8 * t9 / t53;
    let contact_damping_times_bobbin_v_y = p.contact_damping * bobbin_v_y;
    let t61 = R::literal(0.2) * post_omega;
    let t62 = -(t61 * m.cos_post_phi);
    let t63 = -(t61 * m.sin_post_phi);
    let t64 = R::literal(0.12) * plate_omega;
    let t65 = -(t64 * m.cos_plate_phi);
    let t66 = -(t64 * m.sin_plate_phi);
    let t67 = p.spring_damping * (m.cos_cylinder_phi * m.cos_cylinder_phi);
    let t68 = -t67;
    let t69 = p.spring_damping * m.sin_cylinder_phi * m.cos_cylinder_phi;
    let t70 = -t69;
    let t71 = p.spring_damping * m.t12;
    let t72 = t71 * m.cos_cylinder_phi;
    let t73 = R::literal(2.0) * cylinder_omega;
    let t74 = t73 * m.cos_cylinder_phi;
    let t75 = p.spring_damping * (m.sin_cylinder_phi * m.sin_cylinder_phi);
    let t76 = -t75;
    let t77 = t71 * m.sin_cylinder_phi;
    let t78 = t73 * m.sin_cylinder_phi;
    let t79 = -t72;
    let t80 = -t77;
    let t81 = R::literal(0.12) * cylinder_omega;
    let t82 = R::literal(0.12) * rod_omega;
    let t83 = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(p.contact_damping * t8 * t9 / t53),
    );
    let mut x = [[R::literal(0.0); 20]; 26];
    x[2][0] = R::select_less(
            stop_closed,
            R::literal(0.5),
            R::literal(0.0),
            (R::literal(3000.0) * m.stop_gap * stop_rate)
                .add_product(R::literal(1_000_000.0), m.stop_gap * m.stop_gap)
                .sub_product(R::literal(1_000_000.0), t19),
        )
        .sub_product(t0, m.t197)
        .sub_product(t1, m.t196)
        .sub_product(t0, m.t195)
        .sub_product(t1, m.t194);
    x[14][0] = t20;
    x[15][0] = t21;
    x[16][0] = t20;
    x[17][0] = t21;
    x[5][1] = (-(t3 * m.t194))
        .sub_product(t2, m.t195)
        .sub_product(t2, t18)
        .sub_product(t3, t17)
        .sub_product(t10, m.t183)
        .add_product(m.t13, m.t182);
    x[16][1] = t22;
    x[17][1] = t23;
    x[18][1] = t22;
    x[19][1] = t23;
    x[24][1] = (-(t10 * m.plate_omega_dot))
        .add_product(
            (-(R::literal(0.01) * m.sin_plate_phi))
                .sub_product(R::literal(0.1), m.cos_plate_phi),
            plate_omega_squared,
        );
    x[25][1] = (m.t13 * m.plate_omega_dot).add_product(m.t14, plate_omega_squared);
    x[6][2] = t27;
    x[7][2] = t28;
    x[8][2] = t32 - t30 - m.t140 - t13 - t36;
    x[9][2] = t34;
    x[10][2] = t35;
    x[21][2] = t15 - t37;
    x[6][3] = t40;
    x[7][3] = t42;
    x[8][3] = t43 + m.t137 + t44 + t12 - t45;
    x[9][3] = t39;
    x[10][3] = t41;
    x[21][3] = -t14 - t46;
    x[6][4] = t32 + t48 - m.t140 - t13 - t36;
    x[7][4] = t12 + t49 - (-m.t137 - t44) - t45;
    x[8][4] = (p.spring_stiffness * m.slide * (m.slide - R::literal(0.116)))
        .add_product(p.spring_damping * m.slide, m.slide_rate)
        .sub_product(p.spring_stiffness, t50)
        .sub_product(t47, m.t12)
        .sub_product(t4, t18)
        .sub_product(t5, t17)
        .sub_product(t52, t16);
    x[9][4] = m.t140 + t13 - t32 - t48 + t36;
    x[10][4] = -t12 - t49 - (m.t137 + t44) + t45;
    x[18][4] = (-(t4 * m.cylinder_omega_dot)).add_product(t51, m.sin_cylinder_phi);
    x[19][4] = (-(t5 * m.cylinder_omega_dot)).sub_product(t51, m.cos_cylinder_phi);
    x[21][4] = (-(m.cos_cylinder_phi * m.cylinder_v_x_dot))
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
        .sub_product(t52, m.cylinder_omega_dot)
        .add_product(m.cos_cylinder_phi, m.rod_v_x_dot)
        .add_product(m.sin_cylinder_phi, m.rod_v_y_dot);
    x[6][5] = t34;
    x[7][5] = t35;
    x[8][5] = t30 + m.t140 + t13 - t32 + t36;
    x[9][5] = t27;
    x[10][5] = t28;
    x[21][5] = t37 - t15;
    x[6][6] = t39;
    x[7][6] = t41;
    x[8][6] = -t43 - m.t137 - t44 - t12 + t45;
    x[9][6] = t40;
    x[10][6] = t42;
    x[21][6] = t14 + t46;
    x[11][7] = (t6 * m.t185).add_product(t7, m.t184);
    x[22][7] = (-m.t160).add_product(t6, m.rod_omega_dot);
    x[23][7] = m.t159.add_product(t7, m.rod_omega_dot);
    x[12][8] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        t57 * m.t9 / t56 + contact_stiffness_times_contact_gap * m.t9 / t56
            - contact_damping_times_bobbin_v_x * t8 / t53 - t54
            - p.contact_stiffness * m.t9 / t53 - t55,
    );
    x[13][8] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        t58 - contact_damping_times_bobbin_v_x * t9 / t53 - (t60 - t59),
    );
    x[12][9] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        t58 + t59 - contact_damping_times_bobbin_v_y * t8 / t53 - t60,
    );
    x[13][9] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        t57 * m.t11 / t56 - contact_damping_times_bobbin_v_y * t9 / t53 - t55
            - (t54 + p.contact_stiffness * m.t11 / t53
                - contact_stiffness_times_contact_gap * m.t11 / t56),
    );
    x[2][10] = R::select_less(
        stop_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(R::literal(1500.0) * t19),
    );
    x[14][10] = t62;
    x[15][10] = t63;
    x[16][10] = t62;
    x[17][10] = t63;
    x[16][11] = t65;
    x[17][11] = t66;
    x[18][11] = t65;
    x[19][11] = t66;
    x[24][11] = plate_omega
        * (R::literal(0.02) * m.cos_plate_phi)
            .sub_product(R::literal(0.2), m.sin_plate_phi);
    x[25][11] = plate_omega
        * (R::literal(0.02) * m.sin_plate_phi)
            .add_product(R::literal(0.2), m.cos_plate_phi);
    x[6][12] = t68;
    x[7][12] = t70;
    x[8][12] = t72;
    x[9][12] = t67;
    x[10][12] = t69;
    x[21][12] = -t74;
    x[6][13] = t70;
    x[7][13] = t76;
    x[8][13] = t77;
    x[9][13] = t69;
    x[10][13] = t75;
    x[21][13] = -t78;
    x[6][14] = t72;
    x[7][14] = t77;
    x[8][14] = -(p.spring_damping * t50);
    x[9][14] = t79;
    x[10][14] = t80;
    x[18][14] = -(t81 * m.cos_cylinder_phi);
    x[19][14] = -(t81 * m.sin_cylinder_phi);
    x[21][14] = R::literal(2.0)
        * (cylinder_x_times_cylinder_omega * m.sin_cylinder_phi)
            .add_product(rod_y_times_cylinder_omega, m.cos_cylinder_phi)
            .add_product(rod_v_x, m.cos_cylinder_phi)
            .add_product(rod_v_y, m.sin_cylinder_phi)
            .sub_product(cylinder_y_times_cylinder_omega, m.cos_cylinder_phi)
            .sub_product(rod_x_times_cylinder_omega, m.sin_cylinder_phi)
            .sub_product(cylinder_v_x, m.cos_cylinder_phi)
            .sub_product(cylinder_v_y, m.sin_cylinder_phi);
    x[6][15] = t67;
    x[7][15] = t69;
    x[8][15] = t79;
    x[9][15] = t68;
    x[10][15] = t70;
    x[21][15] = t74;
    x[6][16] = t69;
    x[7][16] = t75;
    x[8][16] = t80;
    x[9][16] = t70;
    x[10][16] = t76;
    x[21][16] = t78;
    x[22][17] = t82 * m.cos_rod_phi;
    x[23][17] = t82 * m.sin_rod_phi;
    x[12][18] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(p.contact_damping * m.t9 / t53),
    );
    x[13][18] = t83;
    x[12][19] = t83;
    x[13][19] = R::select_less(
        contact_closed,
        R::literal(0.5),
        R::literal(0.0),
        -(p.contact_damping * m.t11 / t53),
    );
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
        x[0][0], x[0][1], x[0][2], x[0][3], x[0][4], x[0][5], x[0][6], x[0][7], x[0][8], x[0][9],
        x[0][10], x[0][11], x[0][12], x[0][13], x[0][14], x[0][15], x[0][16], x[0][17], x[0][18],
        x[0][19], x[1][0], x[1][1], x[1][2], x[1][3], x[1][4], x[1][5], x[1][6], x[1][7], x[1][8],
        x[1][9], x[1][10], x[1][11], x[1][12], x[1][13], x[1][14], x[1][15], x[1][16], x[1][17],
        x[1][18], x[1][19], x[2][0], x[2][1], x[2][2], x[2][3], x[2][4], x[2][5], x[2][6], x[2][7],
        x[2][8], x[2][9], x[2][10], x[2][11], x[2][12], x[2][13], x[2][14], x[2][15], x[2][16],
        x[2][17], x[2][18], x[2][19], x[3][0], x[3][1], x[3][2], x[3][3], x[3][4], x[3][5], x[3][6],
        x[3][7], x[3][8], x[3][9], x[3][10], x[3][11], x[3][12], x[3][13], x[3][14], x[3][15],
        x[3][16], x[3][17], x[3][18], x[3][19], x[4][0], x[4][1], x[4][2], x[4][3], x[4][4],
        x[4][5], x[4][6], x[4][7], x[4][8], x[4][9], x[4][10], x[4][11], x[4][12], x[4][13],
        x[4][14], x[4][15], x[4][16], x[4][17], x[4][18], x[4][19], x[5][0], x[5][1], x[5][2],
        x[5][3], x[5][4], x[5][5], x[5][6], x[5][7], x[5][8], x[5][9], x[5][10], x[5][11], x[5][12],
        x[5][13], x[5][14], x[5][15], x[5][16], x[5][17], x[5][18], x[5][19], x[6][0], x[6][1],
        x[6][2], x[6][3], x[6][4], x[6][5], x[6][6], x[6][7], x[6][8], x[6][9], x[6][10], x[6][11],
        x[6][12], x[6][13], x[6][14], x[6][15], x[6][16], x[6][17], x[6][18], x[6][19], x[7][0],
        x[7][1], x[7][2], x[7][3], x[7][4], x[7][5], x[7][6], x[7][7], x[7][8], x[7][9], x[7][10],
        x[7][11], x[7][12], x[7][13], x[7][14], x[7][15], x[7][16], x[7][17], x[7][18], x[7][19],
        x[8][0], x[8][1], x[8][2], x[8][3], x[8][4], x[8][5], x[8][6], x[8][7], x[8][8], x[8][9],
        x[8][10], x[8][11], x[8][12], x[8][13], x[8][14], x[8][15], x[8][16], x[8][17], x[8][18],
        x[8][19], x[9][0], x[9][1], x[9][2], x[9][3], x[9][4], x[9][5], x[9][6], x[9][7], x[9][8],
        x[9][9], x[9][10], x[9][11], x[9][12], x[9][13], x[9][14], x[9][15], x[9][16], x[9][17],
        x[9][18], x[9][19], x[10][0], x[10][1], x[10][2], x[10][3], x[10][4], x[10][5], x[10][6],
        x[10][7], x[10][8], x[10][9], x[10][10], x[10][11], x[10][12], x[10][13], x[10][14],
        x[10][15], x[10][16], x[10][17], x[10][18], x[10][19], x[11][0], x[11][1], x[11][2],
        x[11][3], x[11][4], x[11][5], x[11][6], x[11][7], x[11][8], x[11][9], x[11][10], x[11][11],
        x[11][12], x[11][13], x[11][14], x[11][15], x[11][16], x[11][17], x[11][18], x[11][19],
        x[12][0], x[12][1], x[12][2], x[12][3], x[12][4], x[12][5], x[12][6], x[12][7], x[12][8],
        x[12][9], x[12][10], x[12][11], x[12][12], x[12][13], x[12][14], x[12][15], x[12][16],
        x[12][17], x[12][18], x[12][19], x[13][0], x[13][1], x[13][2], x[13][3], x[13][4], x[13][5],
        x[13][6], x[13][7], x[13][8], x[13][9], x[13][10], x[13][11], x[13][12], x[13][13],
        x[13][14], x[13][15], x[13][16], x[13][17], x[13][18], x[13][19],
    ]
}

static RATE_JACOBIAN_STEPS: &[Step<'static>] = &[
    Step::less(14, &[(0, 2)]),
    Step::less(15, &[(1, 2), (2, 14)]),
    Step::less(16, &[(0, 2), (3, 5), (4, 14), (5, 15)]),
    Step::less(17, &[(1, 2), (6, 5), (2, 14), (7, 15), (8, 16)]),
    Step::less(18, &[(3, 5), (9, 6), (10, 8), (11, 16), (12, 17)]),
    Step::less(19, &[(6, 5), (9, 7), (13, 8), (14, 16), (15, 17), (16, 18)]),
    Step::less(20, &[(17, 8), (18, 11), (19, 18), (20, 19)]),
    Step::less(
        21,
        &[(21, 6), (22, 7), (23, 8), (24, 9), (25, 10), (26, 18), (27, 19), (28, 20)],
    ),
    Step::less(22, &[(29, 9), (30, 11), (31, 20), (32, 21)]),
    Step::less(23, &[(29, 10), (33, 11), (34, 20), (35, 21), (36, 22)]),
    Step::less(
        24,
        &[
            (37, 5), (38, 12), (39, 16), (40, 17), (41, 18), (42, 19), (43, 20), (44, 21), (45, 22),
            (46, 23),
        ],
    ),
    Step::less(
        25,
        &[
            (47, 5), (38, 13), (48, 16), (49, 17), (50, 18), (51, 19), (52, 20), (53, 21), (54, 22),
            (55, 23), (56, 24),
        ],
    ),
    Step::scaled(25, 57, &[]),
    Step::scaled(24, 58, &[(56, 25)]),
    Step::scaled(23, 59, &[(46, 24), (55, 25)]),
    Step::scaled(22, 60, &[(36, 23), (45, 24), (54, 25)]),
    Step::scaled(21, 61, &[(32, 22), (35, 23), (44, 24), (53, 25)]),
    Step::scaled(20, 62, &[(28, 21), (31, 22), (34, 23), (43, 24), (52, 25)]),
    Step::scaled(19, 63, &[(20, 20), (27, 21), (42, 24), (51, 25)]),
    Step::scaled(18, 64, &[(16, 19), (19, 20), (26, 21), (41, 24), (50, 25)]),
    Step::scaled(17, 65, &[(12, 18), (15, 19), (40, 24), (49, 25)]),
    Step::scaled(16, 66, &[(8, 17), (11, 18), (14, 19), (39, 24), (48, 25)]),
    Step::scaled(15, 67, &[(5, 16), (7, 17)]),
    Step::scaled(14, 68, &[(2, 15), (4, 16), (2, 17)]),
    Step::scaled(13, 38, &[(38, 25)]),
    Step::scaled(12, 38, &[(38, 24)]),
    Step::scaled(11, 18, &[(18, 20), (30, 22), (33, 23)]),
    Step::scaled(10, 29, &[(25, 21), (29, 23)]),
    Step::scaled(9, 29, &[(24, 21), (29, 22)]),
    Step::scaled(8, 69, &[(10, 18), (13, 19), (17, 20), (23, 21)]),
    Step::scaled(7, 9, &[(9, 19), (22, 21)]),
    Step::scaled(6, 9, &[(9, 18), (21, 21)]),
    Step::scaled(5, 70, &[(3, 16), (6, 17), (3, 18), (6, 19), (37, 24), (47, 25)]),
    Step::less(4, &[(71, 17), (72, 19), (72, 25)]),
    Step::less(3, &[(71, 16), (72, 18), (72, 24)]),
    Step::scaled(2, 73, &[(0, 14), (1, 15), (0, 16), (1, 17)]),
    Step::less(1, &[(74, 15), (75, 17)]),
    Step::less(0, &[(74, 14), (75, 16)]),
];

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
    Step::less(18, &[(9, 6), (10, 8)]),
    Step::less(19, &[(9, 7), (13, 8), (16, 18)]),
    Step::less(20, &[(17, 8), (19, 18), (20, 19)]),
    Step::less(
        21,
        &[(21, 6), (22, 7), (23, 8), (24, 9), (25, 10), (26, 18), (27, 19), (28, 20)],
    ),
    Step::less(22, &[(29, 9), (31, 20), (32, 21)]),
    Step::less(23, &[(29, 10), (34, 20), (35, 21), (36, 22)]),
    Step::less(
        24,
        &[(38, 12), (41, 18), (42, 19), (43, 20), (44, 21), (45, 22), (46, 23)],
    ),
    Step::less(
        25,
        &[(38, 13), (50, 18), (51, 19), (52, 20), (53, 21), (54, 22), (55, 23), (56, 24)],
    ),
    Step::scaled(25, 57, &[]),
    Step::scaled(24, 58, &[(56, 25)]),
    Step::scaled(23, 59, &[(46, 24), (55, 25)]),
    Step::scaled(22, 60, &[(36, 23), (45, 24), (54, 25)]),
    Step::scaled(21, 61, &[(32, 22), (35, 23), (44, 24), (53, 25)]),
    Step::scaled(20, 62, &[(28, 21), (31, 22), (34, 23), (43, 24), (52, 25)]),
    Step::scaled(19, 63, &[(20, 20), (27, 21), (42, 24), (51, 25)]),
    Step::scaled(18, 64, &[(16, 19), (19, 20), (26, 21), (41, 24), (50, 25)]),
    Step::less(17, &[(12, 18), (15, 19), (40, 24), (49, 25)]),
    Step::less(16, &[(8, 17), (11, 18), (14, 19), (39, 24), (48, 25)]),
    Step::less(15, &[(5, 16), (7, 17)]),
    Step::less(14, &[(2, 15), (4, 16), (2, 17)]),
    Step::scaled(13, 38, &[(38, 25)]),
    Step::scaled(12, 38, &[(38, 24)]),
    Step::less(11, &[(18, 20), (30, 22), (33, 23)]),
    Step::scaled(10, 29, &[(25, 21), (29, 23)]),
    Step::scaled(9, 29, &[(24, 21), (29, 22)]),
    Step::scaled(8, 69, &[(10, 18), (13, 19), (17, 20), (23, 21)]),
    Step::scaled(7, 9, &[(9, 19), (22, 21)]),
    Step::scaled(6, 9, &[(9, 18), (21, 21)]),
    Step::less(5, &[(3, 16), (6, 17), (3, 18), (6, 19), (37, 24), (47, 25)]),
    Step::less(4, &[(71, 17), (72, 19), (72, 25)]),
    Step::less(3, &[(71, 16), (72, 18), (72, 24)]),
    Step::less(2, &[(0, 14), (1, 15), (0, 16), (1, 17)]),
    Step::less(1, &[(74, 15), (75, 17)]),
    Step::less(0, &[(74, 14), (75, 16)]),
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
        .sub_product(m.t137, cylinder_v_x)
        .add_product(R::literal(2.943) - m.t140, cylinder_v_y)
        .add_product(m.t143, cylinder_omega)
        .add_product(m.t137, rod_v_x)
        .add_product(R::literal(1.962) + m.t140, rod_v_y)
        .add_product(
            R::select_less(contact_closed, R::literal(0.5), R::literal(0.0), m.t148),
            bobbin_v_x,
        )
        .add_product(
            R::literal(6.867)
                + R::select_less(
                    contact_closed,
                    R::literal(0.5),
                    R::literal(0.0),
                    m.t150,
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
    let contact_opens_guard_rate = ((m.t149 / t2
        - p.contact_damping * bobbin_v_x / m.between
        - p.contact_stiffness * t0 / m.between) * bobbin_v_x)
        .add_product(
            m.t151 / t2 - p.contact_damping * bobbin_v_y / m.between
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

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   5b7ba03a7b8c7607f85575b24543e580d5eb9c851c7ddafd50b456286de295fe  scenes/pendulum_constrained.toml
//   4c8ee37f2c8ba7febb53cb3d6b92bd44186fef63303e4ee1f9467038bf69e830  units/point_mass.toml
//
// Chain of three pendulums, by constraints
//
// The chain of `pendulum_chain` once more: three point masses in a plane, each held at its
// distance from the one above. The forces of the constraints are those in the links.
//
// Source:
//   Textbook.
//
// Shapes; all quantities are in SI units:
//   coordinates               6
//   first-order states        0
//   states                   12
//   parameters               12
//   outputs                   5
//   discontinuities           0
//   constraints               3
//
// State:
//     0  first.x     [m]    place, sideways
//     1  first.y     [m]    place, upwards
//     2  second.x    [m]    place, sideways
//     3  second.y    [m]    place, upwards
//     4  third.x     [m]    place, sideways
//     5  third.y     [m]    place, upwards
//     6  first.v_x   [m/s]  rate of place, sideways
//     7  first.v_y   [m/s]  rate of place, upwards
//     8  second.v_x  [m/s]  rate of place, sideways
//     9  second.v_y  [m/s]  rate of place, upwards
//    10  third.v_x   [m/s]  rate of place, sideways
//    11  third.v_y   [m/s]  rate of place, upwards
//
// Nonzeros:
//   mass_matrix               6 of 6 by 6
//   rate_jacobian            78 of 12 by 12
//   parameter_jacobian       54 of 12 by 12
//
// Operations:
//   initial_state             8
//   discontinuities           0
//   rate                    149
//   mass_matrix               0
//   forcing                   6
//   rate_jacobian           560
//   parameter_jacobian      524
//   time_derivative           0
//   outputs                 125
//   energy                   25
//   power_balance           171
//   constraint_values        25
//   constraint_rates         33
//   constraint_matrix        21
// With constants of the parameters, prepared once a run:
//   prepare                  18
//   prepared_rate           134
//   prepared_rate_jacobian  542

use ::machinist_contract::{
    Constraint, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern,
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 6;

/// Length of the state y.
pub const STATES: usize = 12;

/// Parameters.
pub const PARAMETERS: usize = 12;

/// Wanted outputs.
pub const OUTPUTS: usize = 5;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 6,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 12,
    columns: 12,
    entries: &[
        (0, 6), (1, 7), (2, 8), (3, 9), (4, 10), (5, 11), (6, 0), (6, 1), (6, 2), (6, 3), (6, 4),
        (6, 5), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 0), (7, 1), (7, 2), (7, 3),
        (7, 4), (7, 5), (7, 6), (7, 7), (7, 8), (7, 9), (7, 10), (7, 11), (8, 0), (8, 1), (8, 2),
        (8, 3), (8, 4), (8, 5), (8, 6), (8, 7), (8, 8), (8, 9), (8, 10), (8, 11), (9, 0), (9, 1),
        (9, 2), (9, 3), (9, 4), (9, 5), (9, 6), (9, 7), (9, 8), (9, 9), (9, 10), (9, 11), (10, 0),
        (10, 1), (10, 2), (10, 3), (10, 4), (10, 5), (10, 6), (10, 7), (10, 8), (10, 9), (10, 10),
        (10, 11), (11, 0), (11, 1), (11, 2), (11, 3), (11, 4), (11, 5), (11, 6), (11, 7), (11, 8),
        (11, 9), (11, 10), (11, 11),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 12,
    columns: 12,
    entries: &[
        (6, 0), (6, 1), (6, 2), (6, 6), (6, 7), (6, 8), (6, 9), (6, 10), (6, 11), (7, 0), (7, 1),
        (7, 2), (7, 6), (7, 7), (7, 8), (7, 9), (7, 10), (7, 11), (8, 0), (8, 1), (8, 2), (8, 6),
        (8, 7), (8, 8), (8, 9), (8, 10), (8, 11), (9, 0), (9, 1), (9, 2), (9, 6), (9, 7), (9, 8),
        (9, 9), (9, 10), (9, 11), (10, 0), (10, 1), (10, 2), (10, 6), (10, 7), (10, 8), (10, 9),
        (10, 10), (10, 11), (11, 0), (11, 1), (11, 2), (11, 6), (11, 7), (11, 8), (11, 9), (11, 10),
        (11, 11),
    ],
};

/// Constraints.
pub const CONSTRAINTS: usize = 3;

/// Nonzeros of G = dg'/dq'.
pub const CONSTRAINT_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 6,
    entries: &[
        (0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (2, 4), (2, 5),
    ],
};

/// Chain of three pendulums, by constraints
///
/// The chain of \`pendulum_chain\` once more: three point masses in a plane, each held at its
/// distance from the one above. The forces of the constraints are those in the links.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PendulumConstrained;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// l_1: length of the first link \[m\]. In the spec: 1.0.
    pub l_1: R,
    /// l_2: length of the second link \[m\]. In the spec: 0.7.
    pub l_2: R,
    /// l_3: length of the third link \[m\]. In the spec: 0.4.
    pub l_3: R,
    /// th_1: angle of the first link at the start \[rad\]. In the spec: 0.9.
    pub th_1: R,
    /// th_2: angle of the second link at the start \[rad\]. In the spec: 1.1.
    pub th_2: R,
    /// th_3: angle of the third link at the start \[rad\]. In the spec: 1.4.
    pub th_3: R,
    /// first.mass: the mass \[kg\]. In the spec: 1.0.
    pub first_mass: R,
    /// first.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub first_gravity: R,
    /// second.mass: the mass \[kg\]. In the spec: 0.8.
    pub second_mass: R,
    /// second.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub second_gravity: R,
    /// third.mass: the mass \[kg\]. In the spec: 0.5.
    pub third_mass: R,
    /// third.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub third_gravity: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            l_1: values[0],
            l_2: values[1],
            l_3: values[2],
            th_1: values[3],
            th_2: values[4],
            th_3: values[5],
            first_mass: values[6],
            first_gravity: values[7],
            second_mass: values[8],
            second_gravity: values[9],
            third_mass: values[10],
            third_gravity: values[11],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.l_1,
            self.l_2,
            self.l_3,
            self.th_1,
            self.th_2,
            self.th_3,
            self.first_mass,
            self.first_gravity,
            self.second_mass,
            self.second_gravity,
            self.third_mass,
            self.third_gravity,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            l_1: R::literal(1.0),
            l_2: R::literal(0.7),
            l_3: R::literal(0.4),
            th_1: R::literal(0.9),
            th_2: R::literal(1.1),
            th_3: R::literal(1.4),
            first_mass: R::literal(1.0),
            first_gravity: R::literal(9.81),
            second_mass: R::literal(0.8),
            second_gravity: R::literal(9.81),
            third_mass: R::literal(0.5),
            third_gravity: R::literal(9.81),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// end_x: place, sideways \[m\].
    pub end_x: R,
    /// end_y: place, upwards \[m\].
    pub end_y: R,
    /// force_1: force in the first link, pushing \[N\].
    pub force_1: R,
    /// force_2: force in the second link, pushing \[N\].
    pub force_2: R,
    /// force_3: force in the third link, pushing \[N\].
    pub force_3: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            end_x: values[0],
            end_y: values[1],
            force_1: values[2],
            force_2: values[3],
            force_3: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.end_x, self.end_y, self.force_1, self.force_2, self.force_3]
    }
}

/// Where to find what in the state.
pub mod state {
    /// first.x: place, sideways \[m\].
    pub const FIRST_X: usize = 0;
    /// first.y: place, upwards \[m\].
    pub const FIRST_Y: usize = 1;
    /// second.x: place, sideways \[m\].
    pub const SECOND_X: usize = 2;
    /// second.y: place, upwards \[m\].
    pub const SECOND_Y: usize = 3;
    /// third.x: place, sideways \[m\].
    pub const THIRD_X: usize = 4;
    /// third.y: place, upwards \[m\].
    pub const THIRD_Y: usize = 5;
    /// first.v_x: rate of place, sideways \[m/s\].
    pub const FIRST_V_X: usize = 6;
    /// first.v_y: rate of place, upwards \[m/s\].
    pub const FIRST_V_Y: usize = 7;
    /// second.v_x: rate of place, sideways \[m/s\].
    pub const SECOND_V_X: usize = 8;
    /// second.v_y: rate of place, upwards \[m/s\].
    pub const SECOND_V_Y: usize = 9;
    /// third.v_x: rate of place, sideways \[m/s\].
    pub const THIRD_V_X: usize = 10;
    /// third.v_y: rate of place, upwards \[m/s\].
    pub const THIRD_V_Y: usize = 11;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 15;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub inverse_l_1: R,
    pub inverse_l_2: R,
    pub inverse_l_3: R,
    pub inverse_first_mass: R,
    pub inverse_second_mass: R,
    pub inverse_third_mass: R,
    pub first_mass_times_first_gravity: R,
    pub second_mass_times_second_gravity: R,
    pub third_mass_times_third_gravity: R,
    pub t0: R,
    pub t1: R,
    pub t2: R,
    pub t3: R,
    pub t4: R,
    pub t5: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            inverse_l_1: values[0],
            inverse_l_2: values[1],
            inverse_l_3: values[2],
            inverse_first_mass: values[3],
            inverse_second_mass: values[4],
            inverse_third_mass: values[5],
            first_mass_times_first_gravity: values[6],
            second_mass_times_second_gravity: values[7],
            third_mass_times_third_gravity: values[8],
            t0: values[9],
            t1: values[10],
            t2: values[11],
            t3: values[12],
            t4: values[13],
            t5: values[14],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.inverse_l_1,
            self.inverse_l_2,
            self.inverse_l_3,
            self.inverse_first_mass,
            self.inverse_second_mass,
            self.inverse_third_mass,
            self.first_mass_times_first_gravity,
            self.second_mass_times_second_gravity,
            self.third_mass_times_third_gravity,
            self.t0,
            self.t1,
            self.t2,
            self.t3,
            self.t4,
            self.t5,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 18 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let t0 = -(third_mass_times_third_gravity * inverse_third_mass);
    let t1 = -(second_mass_times_second_gravity * inverse_second_mass);
    let t2 = -(first_mass_times_first_gravity * inverse_first_mass);
    let t3 = R::literal(2.0) / p.l_1;
    let t4 = R::literal(2.0) / p.l_2;
    let t5 = R::literal(2.0) / p.l_3;
    Constants {
        inverse_l_1,
        inverse_l_2,
        inverse_l_3,
        inverse_first_mass,
        inverse_second_mass,
        inverse_third_mass,
        first_mass_times_first_gravity,
        second_mass_times_second_gravity,
        third_mass_times_third_gravity,
        t0,
        t1,
        t2,
        t3,
        t4,
        t5,
    }
}

/// State at the start of the run, in the units of the states.
///
/// 8 operations.
#[must_use]
pub fn initial_state<R: Real>(p: &Parameters<R>) -> [R; STATES] {
    let [(sin_th_1, _), (sin_th_2, _), (sin_th_3, _)] = R::sin_cos_each([
        p.th_1,
        p.th_2,
        p.th_3,
    ]);
    let l_1_times_sin_th_1 = p.l_1 * sin_th_1;
    let t0 = l_1_times_sin_th_1.add_product(p.l_2, sin_th_2);
    [
        l_1_times_sin_th_1,
        R::literal(-0.5),
        t0,
        R::literal(-1.0),
        t0.add_product(p.l_3, sin_th_3),
        R::literal(-1.1),
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
/// 149 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 134 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (first_y - second_y);
    let t2 = c.inverse_l_2 * (second_x - first_x);
    let t3 = c.inverse_l_3 * (second_x - third_x);
    let t4 = c.inverse_l_2 * (second_y - first_y);
    let t5 = c.inverse_l_3 * (second_y - third_y);
    let t6 = c.inverse_l_3 * (third_x - second_x);
    let t7 = c.inverse_l_3 * (third_y - second_y);
    let t8 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t9 = t0 * c.inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t11 = t1 * c.inverse_first_mass;
    let t12 = t2 * c.inverse_second_mass;
    let t13 = t3 * c.inverse_second_mass;
    let t14 = t4 * c.inverse_second_mass;
    let t15 = t5 * c.inverse_second_mass;
    let t16 = t6 * c.inverse_third_mass;
    let t17 = t7 * c.inverse_third_mass;
    let t18 = R::literal(1.0)
        / (-(t10 * inverse_l_1_times_first_y))
            .sub_product(t8, inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y))
        .sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0)
        / (-(t11 * t1))
            .sub_product(t9, t0)
            .sub_product(t12, t2)
            .sub_product(t14, t4)
            .sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t24 = (t10 * c.first_mass_times_first_gravity)
        .sub_product(c.inverse_l_1, first_v_x_squared + first_v_y_squared);
    let t25 = (t11 * c.first_mass_times_first_gravity)
        .add_product(
            c.inverse_l_2,
            (R::literal(2.0) * first_v_x * second_v_x)
                .add_product(R::literal(2.0) * first_v_y, second_v_y) - first_v_x_squared
                - first_v_y_squared - second_v_x_squared - second_v_y_squared,
        )
        .add_product(t14, c.second_mass_times_second_gravity)
        .sub_product(t20, t24);
    let t26 = (t15 * c.second_mass_times_second_gravity)
        .add_product(
            c.inverse_l_3,
            ((R::literal(2.0) * second_v_x * third_v_x)
                .add_product(R::literal(2.0) * second_v_y, third_v_y)
                - second_v_x_squared - second_v_y_squared)
                .sub_product(third_v_x, third_v_x)
                .sub_product(third_v_y, third_v_y),
        )
        .add_product(t17, c.third_mass_times_third_gravity)
        .sub_product(t23, t25)
        * (R::literal(1.0)
            / (-(t15 * t5))
                .sub_product(t13, t3)
                .sub_product(t16, t6)
                .sub_product(t17, t7)
                .sub_product(t23, t22));
    let t27 = (t25 * t21).sub_product(t23, t26);
    let t28 = (t24 * t18).sub_product(t20, t27);
    let third_v_y_dot = c.t0.sub_product(t17, t26);
    let third_v_x_dot = -(t16 * t26);
    let second_v_y_dot = c.t1.sub_product(t14, t27).sub_product(t15, t26);
    let second_v_x_dot = (-(t13 * t26)).sub_product(t12, t27);
    let first_v_y_dot = c.t2.sub_product(t10, t28).sub_product(t11, t27);
    let first_v_x_dot = (-(t9 * t27)).sub_product(t8, t28);
    [
        first_v_x,
        first_v_y,
        second_v_x,
        second_v_y,
        third_v_x,
        third_v_y,
        first_v_x_dot,
        first_v_y_dot,
        second_v_x_dot,
        second_v_y_dot,
        third_v_x_dot,
        third_v_y_dot,
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
) -> [R; 6] {
    [
        p.first_mass,
        p.first_mass,
        p.second_mass,
        p.second_mass,
        p.third_mass,
        p.third_mass,
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 6 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let first_y_forcing = -(p.first_mass * p.first_gravity);
    let second_y_forcing = -(p.second_mass * p.second_gravity);
    let third_y_forcing = -(p.third_mass * p.third_gravity);
    [
        R::literal(0.0),
        first_y_forcing,
        R::literal(0.0),
        second_y_forcing,
        R::literal(0.0),
        third_y_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 560 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 78] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 542 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 78] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1_times_first_x = c.inverse_l_1 * first_x;
    let t0 = c.inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = c.inverse_l_1 * first_y;
    let t1 = c.inverse_l_2 * (first_y - second_y);
    let t2 = c.inverse_l_2 * (second_x - first_x);
    let t3 = c.inverse_l_3 * (second_x - third_x);
    let t4 = c.inverse_l_2 * (second_y - first_y);
    let t5 = c.inverse_l_3 * (second_y - third_y);
    let t6 = c.inverse_l_3 * (third_x - second_x);
    let t7 = c.inverse_l_3 * (third_y - second_y);
    let t8 = inverse_l_1_times_first_x * c.inverse_first_mass;
    let t9 = t0 * c.inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * c.inverse_first_mass;
    let t11 = t1 * c.inverse_first_mass;
    let t12 = t2 * c.inverse_second_mass;
    let t13 = t3 * c.inverse_second_mass;
    let t14 = t4 * c.inverse_second_mass;
    let t15 = t5 * c.inverse_second_mass;
    let t16 = t6 * c.inverse_third_mass;
    let t17 = t7 * c.inverse_third_mass;
    let t18 = R::literal(1.0)
        / (-(t10 * inverse_l_1_times_first_y))
            .sub_product(t8, inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y))
        .sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0)
        / (-(t11 * t1))
            .sub_product(t9, t0)
            .sub_product(t12, t2)
            .sub_product(t14, t4)
            .sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let t24 = R::literal(1.0)
        / (-(t15 * t5))
            .sub_product(t13, t3)
            .sub_product(t16, t6)
            .sub_product(t17, t7)
            .sub_product(t23, t22);
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t25 = (t10 * c.first_mass_times_first_gravity)
        .sub_product(c.inverse_l_1, first_v_x_squared + first_v_y_squared);
    let t26 = (t11 * c.first_mass_times_first_gravity)
        .add_product(
            c.inverse_l_2,
            (R::literal(2.0) * first_v_x * second_v_x)
                .add_product(R::literal(2.0) * first_v_y, second_v_y) - first_v_x_squared
                - first_v_y_squared - second_v_x_squared - second_v_y_squared,
        )
        .add_product(t14, c.second_mass_times_second_gravity)
        .sub_product(t20, t25);
    let t27 = (t15 * c.second_mass_times_second_gravity)
        .add_product(
            c.inverse_l_3,
            ((R::literal(2.0) * second_v_x * third_v_x)
                .add_product(R::literal(2.0) * second_v_y, third_v_y)
                - second_v_x_squared - second_v_y_squared)
                .sub_product(third_v_x, third_v_x)
                .sub_product(third_v_y, third_v_y),
        )
        .add_product(t17, c.third_mass_times_third_gravity)
        .sub_product(t23, t26) * t24;
    let t28 = (t26 * t21).sub_product(t23, t27);
    let t29 = (t25 * t18).sub_product(t20, t28);
    let third_v_y_dot = c.t0.sub_product(t17, t27);
    let second_v_y_dot = c.t1.sub_product(t14, t28).sub_product(t15, t27);
    let second_v_x_dot = (-(t13 * t27)).sub_product(t12, t28);
    let first_v_y_dot = c.t2.sub_product(t10, t29).sub_product(t11, t28);
    let first_v_x_dot = (-(t9 * t28)).sub_product(t8, t29);
    let t30 = c.inverse_l_2 * t28;
    let t31 = (-t30).sub_product(c.inverse_l_1, t29);
    let inverse_l_2_times_first_v_x_dot = c.inverse_l_2 * first_v_x_dot;
    let inverse_l_2_times_second_v_x_dot = c.inverse_l_2 * second_v_x_dot;
    let t32 = (-(t8 * t31)).sub_product(c.inverse_l_1, first_v_x_dot);
    let t33 = (inverse_l_2_times_second_v_x_dot - inverse_l_2_times_first_v_x_dot)
        .sub_product(t9, t31)
        .sub_product(t12, t30)
        .sub_product(t20, t32);
    let t34 = (-(t13 * t30)).sub_product(t23, t33) * t24;
    let t35 = (t33 * t21).sub_product(t23, t34);
    let t36 = (t32 * t18).sub_product(t20, t35);
    let third_v_y_dot_by_first_x = -(t17 * t34);
    let third_v_x_dot_by_first_x = -(t16 * t34);
    let second_v_y_dot_by_first_x = (-(t15 * t34)).sub_product(t14, t35);
    let t37 = t30 * c.inverse_second_mass;
    let second_v_x_dot_by_first_x = t37.sub_product(t12, t35).sub_product(t13, t34);
    let first_v_y_dot_by_first_x = (-(t11 * t35)).sub_product(t10, t36);
    let t38 = t31 * c.inverse_first_mass;
    let first_v_x_dot_by_first_x = t38.sub_product(t8, t36).sub_product(t9, t35);
    let inverse_l_2_times_first_v_y_dot = c.inverse_l_2 * first_v_y_dot;
    let inverse_l_2_times_second_v_y_dot = c.inverse_l_2 * second_v_y_dot;
    let t39 = (-(t10 * t31)).sub_product(c.inverse_l_1, first_v_y_dot);
    let t40 = (inverse_l_2_times_second_v_y_dot - inverse_l_2_times_first_v_y_dot)
        .sub_product(t11, t31)
        .sub_product(t14, t30)
        .sub_product(t20, t39);
    let t41 = (-(t15 * t30)).sub_product(t23, t40) * t24;
    let t42 = (t40 * t21).sub_product(t23, t41);
    let t43 = (t39 * t18).sub_product(t20, t42);
    let third_v_y_dot_by_first_y = -(t17 * t41);
    let third_v_x_dot_by_first_y = -(t16 * t41);
    let second_v_y_dot_by_first_y = t37.sub_product(t14, t42).sub_product(t15, t41);
    let second_v_x_dot_by_first_y = (-(t13 * t41)).sub_product(t12, t42);
    let first_v_y_dot_by_first_y = t38.sub_product(t10, t43).sub_product(t11, t42);
    let first_v_x_dot_by_first_y = (-(t9 * t42)).sub_product(t8, t43);
    let t44 = c.inverse_l_3 * t27;
    let t45 = -t30 - t44;
    let inverse_l_3_times_second_v_x_dot = c.inverse_l_3 * second_v_x_dot;
    let t46 = c.inverse_l_3 * (t16 * t27);
    let t47 = t8 * t30;
    let t48 = (inverse_l_2_times_first_v_x_dot - inverse_l_2_times_second_v_x_dot)
        .sub_product(t9, t30)
        .sub_product(t12, t45)
        .add_product(t20, t47);
    let t49 = t16 * t44;
    let t50 = ((-inverse_l_3_times_second_v_x_dot - t46).sub_product(t13, t45) - t49)
        .sub_product(t23, t48) * t24;
    let t51 = (t48 * t21).sub_product(t23, t50);
    let t52 = (-(t47 * t18)).sub_product(t20, t51);
    let third_v_y_dot_by_second_x = -(t17 * t50);
    let t53 = t44 * c.inverse_third_mass;
    let third_v_x_dot_by_second_x = t53.sub_product(t16, t50);
    let second_v_y_dot_by_second_x = (-(t15 * t50)).sub_product(t14, t51);
    let t54 = t45 * c.inverse_second_mass;
    let second_v_x_dot_by_second_x = t54.sub_product(t12, t51).sub_product(t13, t50);
    let first_v_y_dot_by_second_x = (-(t11 * t51)).sub_product(t10, t52);
    let t55 = t30 * c.inverse_first_mass;
    let first_v_x_dot_by_second_x = t55.sub_product(t8, t52).sub_product(t9, t51);
    let inverse_l_3_times_second_v_y_dot = c.inverse_l_3 * second_v_y_dot;
    let inverse_l_3_times_third_v_y_dot = c.inverse_l_3 * third_v_y_dot;
    let t56 = t10 * t30;
    let t57 = (inverse_l_2_times_first_v_y_dot - inverse_l_2_times_second_v_y_dot)
        .sub_product(t11, t30)
        .sub_product(t14, t45)
        .add_product(t20, t56);
    let t58 = t17 * t44;
    let t59 = ((inverse_l_3_times_third_v_y_dot - inverse_l_3_times_second_v_y_dot)
        .sub_product(t15, t45) - t58)
        .sub_product(t23, t57) * t24;
    let t60 = (t57 * t21).sub_product(t23, t59);
    let t61 = (-(t56 * t18)).sub_product(t20, t60);
    let third_v_y_dot_by_second_y = t53.sub_product(t17, t59);
    let third_v_x_dot_by_second_y = -(t16 * t59);
    let second_v_y_dot_by_second_y = t54.sub_product(t14, t60).sub_product(t15, t59);
    let second_v_x_dot_by_second_y = (-(t13 * t59)).sub_product(t12, t60);
    let first_v_y_dot_by_second_y = t55.sub_product(t10, t61).sub_product(t11, t60);
    let first_v_x_dot_by_second_y = (-(t9 * t60)).sub_product(t8, t61);
    let t62 = t12 * t44;
    let t63 = ((inverse_l_3_times_second_v_x_dot + t46).sub_product(t13, t44) + t49)
        .add_product(t23, t62) * t24;
    let t64 = (-(t62 * t21)).sub_product(t23, t63);
    let t65 = t20 * t64;
    let third_v_y_dot_by_third_x = -(t17 * t63);
    let t66 = -t53;
    let third_v_x_dot_by_third_x = t66.sub_product(t16, t63);
    let second_v_y_dot_by_third_x = (-(t15 * t63)).sub_product(t14, t64);
    let t67 = t44 * c.inverse_second_mass;
    let second_v_x_dot_by_third_x = t67.sub_product(t12, t64).sub_product(t13, t63);
    let first_v_y_dot_by_third_x = (-(t11 * t64)).add_product(t10, t65);
    let first_v_x_dot_by_third_x = (-(t9 * t64)).add_product(t8, t65);
    let t68 = t14 * t44;
    let t69 = ((inverse_l_3_times_second_v_y_dot - inverse_l_3_times_third_v_y_dot)
        .sub_product(t15, t44) + t58)
        .add_product(t23, t68) * t24;
    let t70 = (-(t68 * t21)).sub_product(t23, t69);
    let t71 = t20 * t70;
    let third_v_y_dot_by_third_y = t66.sub_product(t17, t69);
    let third_v_x_dot_by_third_y = -(t16 * t69);
    let second_v_y_dot_by_third_y = t67.sub_product(t14, t70).sub_product(t15, t69);
    let second_v_x_dot_by_third_y = (-(t13 * t69)).sub_product(t12, t70);
    let first_v_y_dot_by_third_y = (-(t11 * t70)).add_product(t10, t71);
    let first_v_x_dot_by_third_y = (-(t9 * t70)).add_product(t8, t71);
    let t72 = c.t3 * first_v_x;
    let t73 = c.t4 * (first_v_x - second_v_x);
    let t74 = (-t73).add_product(t20, t72);
    let t75 = t23 * t74 * t24;
    let t76 = (t74 * t21).add_product(t23, t75);
    let t77 = (-(t72 * t18)).sub_product(t20, t76);
    let third_v_y_dot_by_first_v_x = t17 * t75;
    let third_v_x_dot_by_first_v_x = t16 * t75;
    let second_v_y_dot_by_first_v_x = (t15 * t75).sub_product(t14, t76);
    let second_v_x_dot_by_first_v_x = (t13 * t75).sub_product(t12, t76);
    let first_v_y_dot_by_first_v_x = (-(t11 * t76)).sub_product(t10, t77);
    let first_v_x_dot_by_first_v_x = (-(t9 * t76)).sub_product(t8, t77);
    let t78 = c.t3 * first_v_y;
    let t79 = c.t4 * (first_v_y - second_v_y);
    let t80 = (-t79).add_product(t20, t78);
    let t81 = t23 * t80 * t24;
    let t82 = (t80 * t21).add_product(t23, t81);
    let t83 = (-(t78 * t18)).sub_product(t20, t82);
    let third_v_y_dot_by_first_v_y = t17 * t81;
    let third_v_x_dot_by_first_v_y = t16 * t81;
    let second_v_y_dot_by_first_v_y = (t15 * t81).sub_product(t14, t82);
    let second_v_x_dot_by_first_v_y = (t13 * t81).sub_product(t12, t82);
    let first_v_y_dot_by_first_v_y = (-(t11 * t82)).sub_product(t10, t83);
    let first_v_x_dot_by_first_v_y = (-(t9 * t82)).sub_product(t8, t83);
    let t84 = c.t5 * (second_v_x - third_v_x);
    let t85 = (-t84).sub_product(t23, t73) * t24;
    let t86 = (t73 * t21).sub_product(t23, t85);
    let t87 = t20 * t86;
    let third_v_y_dot_by_second_v_x = -(t17 * t85);
    let third_v_x_dot_by_second_v_x = -(t16 * t85);
    let second_v_y_dot_by_second_v_x = (-(t15 * t85)).sub_product(t14, t86);
    let second_v_x_dot_by_second_v_x = (-(t13 * t85)).sub_product(t12, t86);
    let first_v_y_dot_by_second_v_x = (-(t11 * t86)).add_product(t10, t87);
    let first_v_x_dot_by_second_v_x = (-(t9 * t86)).add_product(t8, t87);
    let t88 = c.t5 * (second_v_y - third_v_y);
    let t89 = (-t88).sub_product(t23, t79) * t24;
    let t90 = (t79 * t21).sub_product(t23, t89);
    let t91 = t20 * t90;
    let third_v_y_dot_by_second_v_y = -(t17 * t89);
    let third_v_x_dot_by_second_v_y = -(t16 * t89);
    let second_v_y_dot_by_second_v_y = (-(t15 * t89)).sub_product(t14, t90);
    let second_v_x_dot_by_second_v_y = (-(t13 * t89)).sub_product(t12, t90);
    let first_v_y_dot_by_second_v_y = (-(t11 * t90)).add_product(t10, t91);
    let first_v_x_dot_by_second_v_y = (-(t9 * t90)).add_product(t8, t91);
    let t92 = t84 * t24;
    let t93 = t23 * t92;
    let t94 = t20 * t93;
    let third_v_y_dot_by_third_v_x = -(t17 * t92);
    let third_v_x_dot_by_third_v_x = -(t16 * t92);
    let second_v_y_dot_by_third_v_x = (-(t15 * t92)).add_product(t14, t93);
    let second_v_x_dot_by_third_v_x = (-(t13 * t92)).add_product(t12, t93);
    let first_v_y_dot_by_third_v_x = (t11 * t93).sub_product(t10, t94);
    let first_v_x_dot_by_third_v_x = (t9 * t93).sub_product(t8, t94);
    let t95 = t88 * t24;
    let t96 = t23 * t95;
    let t97 = t20 * t96;
    let third_v_y_dot_by_third_v_y = -(t17 * t95);
    let third_v_x_dot_by_third_v_y = -(t16 * t95);
    let second_v_y_dot_by_third_v_y = (-(t15 * t95)).add_product(t14, t96);
    let second_v_x_dot_by_third_v_y = (-(t13 * t95)).add_product(t12, t96);
    let first_v_y_dot_by_third_v_y = (t11 * t96).sub_product(t10, t97);
    let first_v_x_dot_by_third_v_y = (t9 * t96).sub_product(t8, t97);
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        first_v_x_dot_by_first_x,
        first_v_x_dot_by_first_y,
        first_v_x_dot_by_second_x,
        first_v_x_dot_by_second_y,
        first_v_x_dot_by_third_x,
        first_v_x_dot_by_third_y,
        first_v_x_dot_by_first_v_x,
        first_v_x_dot_by_first_v_y,
        first_v_x_dot_by_second_v_x,
        first_v_x_dot_by_second_v_y,
        first_v_x_dot_by_third_v_x,
        first_v_x_dot_by_third_v_y,
        first_v_y_dot_by_first_x,
        first_v_y_dot_by_first_y,
        first_v_y_dot_by_second_x,
        first_v_y_dot_by_second_y,
        first_v_y_dot_by_third_x,
        first_v_y_dot_by_third_y,
        first_v_y_dot_by_first_v_x,
        first_v_y_dot_by_first_v_y,
        first_v_y_dot_by_second_v_x,
        first_v_y_dot_by_second_v_y,
        first_v_y_dot_by_third_v_x,
        first_v_y_dot_by_third_v_y,
        second_v_x_dot_by_first_x,
        second_v_x_dot_by_first_y,
        second_v_x_dot_by_second_x,
        second_v_x_dot_by_second_y,
        second_v_x_dot_by_third_x,
        second_v_x_dot_by_third_y,
        second_v_x_dot_by_first_v_x,
        second_v_x_dot_by_first_v_y,
        second_v_x_dot_by_second_v_x,
        second_v_x_dot_by_second_v_y,
        second_v_x_dot_by_third_v_x,
        second_v_x_dot_by_third_v_y,
        second_v_y_dot_by_first_x,
        second_v_y_dot_by_first_y,
        second_v_y_dot_by_second_x,
        second_v_y_dot_by_second_y,
        second_v_y_dot_by_third_x,
        second_v_y_dot_by_third_y,
        second_v_y_dot_by_first_v_x,
        second_v_y_dot_by_first_v_y,
        second_v_y_dot_by_second_v_x,
        second_v_y_dot_by_second_v_y,
        second_v_y_dot_by_third_v_x,
        second_v_y_dot_by_third_v_y,
        third_v_x_dot_by_first_x,
        third_v_x_dot_by_first_y,
        third_v_x_dot_by_second_x,
        third_v_x_dot_by_second_y,
        third_v_x_dot_by_third_x,
        third_v_x_dot_by_third_y,
        third_v_x_dot_by_first_v_x,
        third_v_x_dot_by_first_v_y,
        third_v_x_dot_by_second_v_x,
        third_v_x_dot_by_second_v_y,
        third_v_x_dot_by_third_v_x,
        third_v_x_dot_by_third_v_y,
        third_v_y_dot_by_first_x,
        third_v_y_dot_by_first_y,
        third_v_y_dot_by_second_x,
        third_v_y_dot_by_second_y,
        third_v_y_dot_by_third_x,
        third_v_y_dot_by_third_y,
        third_v_y_dot_by_first_v_x,
        third_v_y_dot_by_first_v_y,
        third_v_y_dot_by_second_v_x,
        third_v_y_dot_by_second_v_y,
        third_v_y_dot_by_third_v_x,
        third_v_y_dot_by_third_v_y,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 524 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 54] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let first_x_minus_second_x = first_x - second_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * first_x_minus_second_x;
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let first_y_minus_second_y = first_y - second_y;
    let t1 = inverse_l_2 * first_y_minus_second_y;
    let second_x_minus_first_x = second_x - first_x;
    let t2 = inverse_l_2 * second_x_minus_first_x;
    let second_x_minus_third_x = second_x - third_x;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * second_x_minus_third_x;
    let second_y_minus_first_y = second_y - first_y;
    let t4 = inverse_l_2 * second_y_minus_first_y;
    let second_y_minus_third_y = second_y - third_y;
    let t5 = inverse_l_3 * second_y_minus_third_y;
    let third_x_minus_second_x = third_x - second_x;
    let t6 = inverse_l_3 * third_x_minus_second_x;
    let third_y_minus_second_y = third_y - second_y;
    let t7 = inverse_l_3 * third_y_minus_second_y;
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = inverse_l_1_times_first_x * inverse_first_mass;
    let t9 = t0 * inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * inverse_first_mass;
    let t11 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t12 = t2 * inverse_second_mass;
    let t13 = t3 * inverse_second_mass;
    let t14 = t4 * inverse_second_mass;
    let t15 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t16 = t6 * inverse_third_mass;
    let t17 = t7 * inverse_third_mass;
    let t18 = R::literal(1.0)
        / (-(t10 * inverse_l_1_times_first_y))
            .sub_product(t8, inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y))
        .sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0)
        / (-(t11 * t1))
            .sub_product(t9, t0)
            .sub_product(t12, t2)
            .sub_product(t14, t4)
            .sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let t24 = R::literal(1.0)
        / (-(t15 * t5))
            .sub_product(t13, t3)
            .sub_product(t16, t6)
            .sub_product(t17, t7)
            .sub_product(t23, t22);
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let t25 = first_v_x_squared + first_v_y_squared;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t26 = R::literal(2.0) * first_v_x * second_v_x;
    let t27 = R::literal(2.0) * first_v_y * second_v_y;
    let third_v_x_squared = third_v_x * third_v_x;
    let third_v_y_squared = third_v_y * third_v_y;
    let t28 = R::literal(2.0) * second_v_x * third_v_x;
    let t29 = R::literal(2.0) * second_v_y * third_v_y;
    let t30 = (-(inverse_l_1 * t25)).add_product(t10, first_mass_times_first_gravity);
    let t31 = (t11 * first_mass_times_first_gravity)
        .add_product(
            inverse_l_2,
            t26 + t27 - first_v_x_squared - first_v_y_squared - second_v_x_squared
                - second_v_y_squared,
        )
        .add_product(t14, second_mass_times_second_gravity)
        .sub_product(t20, t30);
    let t32 = (t15 * second_mass_times_second_gravity)
        .add_product(
            inverse_l_3,
            t28 + t29 - second_v_x_squared - second_v_y_squared - third_v_x_squared
                - third_v_y_squared,
        )
        .add_product(t17, third_mass_times_third_gravity)
        .sub_product(t23, t31) * t24;
    let t33 = (t31 * t21).sub_product(t23, t32);
    let t34 = (t30 * t18).sub_product(t20, t33);
    let third_v_y_dot = (-(third_mass_times_third_gravity * inverse_third_mass))
        .sub_product(t17, t32);
    let t35 = t16 * t32;
    let second_v_y_dot = (-(second_mass_times_second_gravity * inverse_second_mass))
        .sub_product(t14, t33)
        .sub_product(t15, t32);
    let t36 = t12 * t33;
    let t37 = t13 * t32;
    let second_v_x_dot = -t36 - t37;
    let first_v_y_dot = (-(first_mass_times_first_gravity * inverse_first_mass))
        .sub_product(t10, t34)
        .sub_product(t11, t33);
    let t38 = t8 * t34;
    let t39 = t9 * t33;
    let first_v_x_dot = -t38 - t39;
    let inverse_l_1_squared = R::literal(1.0) / (p.l_1 * p.l_1);
    let inverse_l_1_squared_times_first_x = inverse_l_1_squared * first_x;
    let t40 = inverse_l_1_squared_times_first_x * t34;
    let inverse_l_1_squared_times_first_y = inverse_l_1_squared * first_y;
    let t41 = inverse_l_1_squared_times_first_y * t34;
    let t42 = (inverse_l_1_squared * t25)
        .add_product(inverse_l_1_squared_times_first_x, first_v_x_dot)
        .add_product(inverse_l_1_squared_times_first_y, first_v_y_dot)
        .sub_product(t8, t40)
        .sub_product(t10, t41);
    let t43 = (-(t11 * t41)).sub_product(t9, t40).sub_product(t20, t42);
    let t44 = t23 * t43 * t24;
    let t45 = (t43 * t21).add_product(t23, t44);
    let t46 = (t42 * t18).sub_product(t20, t45);
    let third_v_y_dot_by_l_1 = t17 * t44;
    let third_v_x_dot_by_l_1 = t16 * t44;
    let second_v_y_dot_by_l_1 = (t15 * t44).sub_product(t14, t45);
    let second_v_x_dot_by_l_1 = (t13 * t44).sub_product(t12, t45);
    let first_v_y_dot_by_l_1 = (t41 * inverse_first_mass)
        .sub_product(t10, t46)
        .sub_product(t11, t45);
    let first_v_x_dot_by_l_1 = (t40 * inverse_first_mass)
        .sub_product(t8, t46)
        .sub_product(t9, t45);
    let inverse_l_2_squared = R::literal(1.0) / (p.l_2 * p.l_2);
    let t47 = inverse_l_2_squared * second_x_minus_first_x;
    let t48 = t47 * t33;
    let t49 = inverse_l_2_squared * second_y_minus_first_y;
    let t50 = t49 * t33;
    let t51 = inverse_l_2_squared * first_x_minus_second_x;
    let t52 = t51 * t33;
    let t53 = inverse_l_2_squared * first_y_minus_second_y;
    let t54 = t53 * t33;
    let t55 = (t8 * t48).add_product(t10, t50);
    let t56 = (inverse_l_2_squared
        * (t25 + second_v_x_squared + second_v_y_squared - t26 - t27))
        .sub_product(t47, first_v_x_dot)
        .sub_product(t49, first_v_y_dot)
        .sub_product(t51, second_v_x_dot)
        .sub_product(t53, second_v_y_dot)
        .add_product(t9, t48)
        .add_product(t11, t50)
        .add_product(t12, t52)
        .add_product(t14, t54)
        .sub_product(t20, t55);
    let t57 = (t13 * t52).add_product(t15, t54).sub_product(t23, t56) * t24;
    let t58 = (t56 * t21).sub_product(t23, t57);
    let t59 = (t55 * t18).sub_product(t20, t58);
    let third_v_y_dot_by_l_2 = -(t17 * t57);
    let third_v_x_dot_by_l_2 = -(t16 * t57);
    let second_v_y_dot_by_l_2 = (-(t54 * inverse_second_mass))
        .sub_product(t14, t58)
        .sub_product(t15, t57);
    let second_v_x_dot_by_l_2 = (-(t52 * inverse_second_mass))
        .sub_product(t12, t58)
        .sub_product(t13, t57);
    let first_v_y_dot_by_l_2 = (-(t50 * inverse_first_mass))
        .sub_product(t10, t59)
        .sub_product(t11, t58);
    let first_v_x_dot_by_l_2 = (-(t48 * inverse_first_mass))
        .sub_product(t8, t59)
        .sub_product(t9, t58);
    let inverse_l_3_squared = R::literal(1.0) / (p.l_3 * p.l_3);
    let t60 = inverse_l_3_squared * third_x_minus_second_x;
    let t61 = t60 * t32;
    let t62 = inverse_l_3_squared * third_y_minus_second_y;
    let t63 = t62 * t32;
    let t64 = inverse_l_3_squared * second_x_minus_third_x;
    let t65 = t64 * t32;
    let t66 = inverse_l_3_squared * second_y_minus_third_y;
    let t67 = t66 * t32;
    let t68 = (t12 * t61).add_product(t14, t63);
    let t69 = (inverse_l_3_squared
        * (second_v_x_squared + second_v_y_squared + third_v_x_squared
            + third_v_y_squared - t28 - t29))
        .sub_product(t60, second_v_x_dot)
        .sub_product(t62, second_v_y_dot)
        .add_product(t64, t35)
        .sub_product(t66, third_v_y_dot)
        .add_product(t13, t61)
        .add_product(t15, t63)
        .add_product(t16, t65)
        .add_product(t17, t67)
        .sub_product(t23, t68) * t24;
    let t70 = (t68 * t21).sub_product(t23, t69);
    let t71 = t20 * t70;
    let third_v_y_dot_by_l_3 = (-(t67 * inverse_third_mass)).sub_product(t17, t69);
    let third_v_x_dot_by_l_3 = (-(t65 * inverse_third_mass)).sub_product(t16, t69);
    let second_v_y_dot_by_l_3 = (-(t63 * inverse_second_mass))
        .sub_product(t14, t70)
        .sub_product(t15, t69);
    let second_v_x_dot_by_l_3 = (-(t61 * inverse_second_mass))
        .sub_product(t12, t70)
        .sub_product(t13, t69);
    let first_v_y_dot_by_l_3 = (-(t11 * t70)).add_product(t10, t71);
    let first_v_x_dot_by_l_3 = (-(t9 * t70)).add_product(t8, t71);
    let t72 = t39 + t38;
    let t73 = -p.first_gravity - first_v_y_dot;
    let t74 = (-(t8 * t72)).sub_product(t10, t73);
    let t75 = (-(t9 * t72)).sub_product(t11, t73).sub_product(t20, t74);
    let t76 = t23 * t75 * t24;
    let t77 = (t75 * t21).add_product(t23, t76);
    let t78 = (t74 * t18).sub_product(t20, t77);
    let third_v_y_dot_by_first_mass = t17 * t76;
    let third_v_x_dot_by_first_mass = t16 * t76;
    let second_v_y_dot_by_first_mass = (t15 * t76).sub_product(t14, t77);
    let second_v_x_dot_by_first_mass = (t13 * t76).sub_product(t12, t77);
    let first_v_y_dot_by_first_mass = (t73 * inverse_first_mass)
        .sub_product(t10, t78)
        .sub_product(t11, t77);
    let first_v_x_dot_by_first_mass = (t72 * inverse_first_mass)
        .sub_product(t8, t78)
        .sub_product(t9, t77);
    let t79 = t10 * p.first_mass;
    let t80 = (t11 * p.first_mass).sub_product(t20, t79);
    let t81 = t23 * t80 * t24;
    let t82 = (t80 * t21).add_product(t23, t81);
    let t83 = (t79 * t18).sub_product(t20, t82);
    let third_v_y_dot_by_first_gravity = t17 * t81;
    let third_v_x_dot_by_first_gravity = t16 * t81;
    let second_v_y_dot_by_first_gravity = (t15 * t81).sub_product(t14, t82);
    let second_v_x_dot_by_first_gravity = (t13 * t81).sub_product(t12, t82);
    let first_v_y_dot_by_first_gravity = (-(p.first_mass * inverse_first_mass))
        .sub_product(t10, t83)
        .sub_product(t11, t82);
    let first_v_x_dot_by_first_gravity = (-(t9 * t82)).sub_product(t8, t83);
    let t84 = t37 + t36;
    let t85 = -p.second_gravity - second_v_y_dot;
    let t86 = (-(t12 * t84)).sub_product(t14, t85);
    let t87 = (-(t13 * t84)).sub_product(t15, t85).sub_product(t23, t86) * t24;
    let t88 = (t86 * t21).sub_product(t23, t87);
    let t89 = t20 * t88;
    let third_v_y_dot_by_second_mass = -(t17 * t87);
    let third_v_x_dot_by_second_mass = -(t16 * t87);
    let second_v_y_dot_by_second_mass = (t85 * inverse_second_mass)
        .sub_product(t14, t88)
        .sub_product(t15, t87);
    let second_v_x_dot_by_second_mass = (t84 * inverse_second_mass)
        .sub_product(t12, t88)
        .sub_product(t13, t87);
    let first_v_y_dot_by_second_mass = (-(t11 * t88)).add_product(t10, t89);
    let first_v_x_dot_by_second_mass = (-(t9 * t88)).add_product(t8, t89);
    let t90 = t14 * p.second_mass;
    let t91 = (t15 * p.second_mass).sub_product(t23, t90) * t24;
    let t92 = (t90 * t21).sub_product(t23, t91);
    let t93 = t20 * t92;
    let third_v_y_dot_by_second_gravity = -(t17 * t91);
    let third_v_x_dot_by_second_gravity = -(t16 * t91);
    let second_v_y_dot_by_second_gravity = (-(p.second_mass * inverse_second_mass))
        .sub_product(t14, t92)
        .sub_product(t15, t91);
    let second_v_x_dot_by_second_gravity = (-(t13 * t91)).sub_product(t12, t92);
    let first_v_y_dot_by_second_gravity = (-(t11 * t92)).add_product(t10, t93);
    let first_v_x_dot_by_second_gravity = (-(t9 * t92)).add_product(t8, t93);
    let t94 = -p.third_gravity - third_v_y_dot;
    let t95 = (-(t16 * t35)).sub_product(t17, t94) * t24;
    let t96 = t23 * t95;
    let t97 = t20 * t96;
    let third_v_y_dot_by_third_mass = (t94 * inverse_third_mass).sub_product(t17, t95);
    let third_v_x_dot_by_third_mass = (t35 * inverse_third_mass).sub_product(t16, t95);
    let second_v_y_dot_by_third_mass = (-(t15 * t95)).add_product(t14, t96);
    let second_v_x_dot_by_third_mass = (-(t13 * t95)).add_product(t12, t96);
    let first_v_y_dot_by_third_mass = (t11 * t96).sub_product(t10, t97);
    let first_v_x_dot_by_third_mass = (t9 * t96).sub_product(t8, t97);
    let t98 = t17 * p.third_mass * t24;
    let t99 = t23 * t98;
    let t100 = t20 * t99;
    let third_v_y_dot_by_third_gravity = (-(p.third_mass * inverse_third_mass))
        .sub_product(t17, t98);
    let third_v_x_dot_by_third_gravity = -(t16 * t98);
    let second_v_y_dot_by_third_gravity = (-(t15 * t98)).add_product(t14, t99);
    let second_v_x_dot_by_third_gravity = (-(t13 * t98)).add_product(t12, t99);
    let first_v_y_dot_by_third_gravity = (t11 * t99).sub_product(t10, t100);
    let first_v_x_dot_by_third_gravity = (t9 * t99).sub_product(t8, t100);
    [
        first_v_x_dot_by_l_1,
        first_v_x_dot_by_l_2,
        first_v_x_dot_by_l_3,
        first_v_x_dot_by_first_mass,
        first_v_x_dot_by_first_gravity,
        first_v_x_dot_by_second_mass,
        first_v_x_dot_by_second_gravity,
        first_v_x_dot_by_third_mass,
        first_v_x_dot_by_third_gravity,
        first_v_y_dot_by_l_1,
        first_v_y_dot_by_l_2,
        first_v_y_dot_by_l_3,
        first_v_y_dot_by_first_mass,
        first_v_y_dot_by_first_gravity,
        first_v_y_dot_by_second_mass,
        first_v_y_dot_by_second_gravity,
        first_v_y_dot_by_third_mass,
        first_v_y_dot_by_third_gravity,
        second_v_x_dot_by_l_1,
        second_v_x_dot_by_l_2,
        second_v_x_dot_by_l_3,
        second_v_x_dot_by_first_mass,
        second_v_x_dot_by_first_gravity,
        second_v_x_dot_by_second_mass,
        second_v_x_dot_by_second_gravity,
        second_v_x_dot_by_third_mass,
        second_v_x_dot_by_third_gravity,
        second_v_y_dot_by_l_1,
        second_v_y_dot_by_l_2,
        second_v_y_dot_by_l_3,
        second_v_y_dot_by_first_mass,
        second_v_y_dot_by_first_gravity,
        second_v_y_dot_by_second_mass,
        second_v_y_dot_by_second_gravity,
        second_v_y_dot_by_third_mass,
        second_v_y_dot_by_third_gravity,
        third_v_x_dot_by_l_1,
        third_v_x_dot_by_l_2,
        third_v_x_dot_by_l_3,
        third_v_x_dot_by_first_mass,
        third_v_x_dot_by_first_gravity,
        third_v_x_dot_by_second_mass,
        third_v_x_dot_by_second_gravity,
        third_v_x_dot_by_third_mass,
        third_v_x_dot_by_third_gravity,
        third_v_y_dot_by_l_1,
        third_v_y_dot_by_l_2,
        third_v_y_dot_by_l_3,
        third_v_y_dot_by_first_mass,
        third_v_y_dot_by_first_gravity,
        third_v_y_dot_by_second_mass,
        third_v_y_dot_by_second_gravity,
        third_v_y_dot_by_third_mass,
        third_v_y_dot_by_third_gravity,
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
    ]
}

/// Wanted outputs.
///
/// 125 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (first_y - second_y);
    let t2 = inverse_l_2 * (second_x - first_x);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * (second_x - third_x);
    let t4 = inverse_l_2 * (second_y - first_y);
    let t5 = inverse_l_3 * (second_y - third_y);
    let t6 = inverse_l_3 * (third_x - second_x);
    let t7 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = t0 * inverse_first_mass;
    let t9 = inverse_l_1_times_first_y * inverse_first_mass;
    let t10 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t11 = t3 * inverse_second_mass;
    let t12 = t4 * inverse_second_mass;
    let t13 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t14 = t7 * inverse_third_mass;
    let t15 = R::literal(1.0)
        / (-(t9 * inverse_l_1_times_first_y))
            .sub_product(
                inverse_l_1_times_first_x * inverse_first_mass,
                inverse_l_1_times_first_x,
            );
    let t16 = (-(t10 * inverse_l_1_times_first_y))
        .sub_product(t8, inverse_l_1_times_first_x);
    let t17 = t16 * t15;
    let t18 = R::literal(1.0)
        / (-(t10 * t1))
            .sub_product(t8, t0)
            .sub_product(t2 * inverse_second_mass, t2)
            .sub_product(t12, t4)
            .sub_product(t17, t16);
    let t19 = (-(t13 * t4)).sub_product(t11, t2);
    let t20 = t19 * t18;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t21 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared)))
        .add_product(t9, first_mass_times_first_gravity);
    let t22 = (t10 * first_mass_times_first_gravity)
        .add_product(
            inverse_l_2,
            (R::literal(2.0) * first_v_x * second_v_x)
                .add_product(R::literal(2.0) * first_v_y, second_v_y) - first_v_x_squared
                - first_v_y_squared - second_v_x_squared - second_v_y_squared,
        )
        .add_product(t12, second_mass_times_second_gravity)
        .sub_product(t17, t21);
    let t23 = (t13 * second_mass_times_second_gravity)
        .add_product(
            inverse_l_3,
            ((R::literal(2.0) * second_v_x * third_v_x)
                .add_product(R::literal(2.0) * second_v_y, third_v_y)
                - second_v_x_squared - second_v_y_squared)
                .sub_product(third_v_x, third_v_x)
                .sub_product(third_v_y, third_v_y),
        )
        .add_product(t14, p.third_mass * p.third_gravity)
        .sub_product(t20, t22)
        * (R::literal(1.0)
            / (-(t13 * t5))
                .sub_product(t11, t3)
                .sub_product(t6 * inverse_third_mass, t6)
                .sub_product(t14, t7)
                .sub_product(t20, t19));
    let t24 = t22 * t18;
    let t25 = t20 * t23;
    let link_1 = (-(t21 * t15)).add_product(t17, t24 - t25);
    let link_2 = t25 - t24;
    let link_3 = -t23;
    Outputs {
        end_x: third_x,
        end_y: third_y,
        force_1: link_1,
        force_2: link_2,
        force_3: link_3,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 25 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [_, first_y, _, second_y, _, third_y, first_v_x, first_v_y, second_v_x,
    second_v_y, third_v_x, third_v_y] = *state;
    Energy {
        kinetic: (R::literal(0.5) * p.first_mass
            * (first_v_x * first_v_x).add_product(first_v_y, first_v_y))
            .add_product(
                R::literal(0.5) * p.second_mass,
                (second_v_x * second_v_x).add_product(second_v_y, second_v_y),
            )
            .add_product(
                R::literal(0.5) * p.third_mass,
                (third_v_x * third_v_x).add_product(third_v_y, third_v_y),
            ),
        potential: (p.first_mass * p.first_gravity * first_y)
            .add_product(p.second_mass * p.second_gravity, second_y)
            .add_product(p.third_mass * p.third_gravity, third_y),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 171 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_1_times_first_x = inverse_l_1 * first_x;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let t0 = inverse_l_2 * (first_x - second_x);
    let inverse_l_1_times_first_y = inverse_l_1 * first_y;
    let t1 = inverse_l_2 * (first_y - second_y);
    let t2 = inverse_l_2 * (second_x - first_x);
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let t3 = inverse_l_3 * (second_x - third_x);
    let t4 = inverse_l_2 * (second_y - first_y);
    let t5 = inverse_l_3 * (second_y - third_y);
    let t6 = inverse_l_3 * (third_x - second_x);
    let t7 = inverse_l_3 * (third_y - second_y);
    let inverse_first_mass = R::literal(1.0) / p.first_mass;
    let t8 = inverse_l_1_times_first_x * inverse_first_mass;
    let t9 = t0 * inverse_first_mass;
    let t10 = inverse_l_1_times_first_y * inverse_first_mass;
    let t11 = t1 * inverse_first_mass;
    let inverse_second_mass = R::literal(1.0) / p.second_mass;
    let t12 = t2 * inverse_second_mass;
    let t13 = t3 * inverse_second_mass;
    let t14 = t4 * inverse_second_mass;
    let t15 = t5 * inverse_second_mass;
    let inverse_third_mass = R::literal(1.0) / p.third_mass;
    let t16 = t6 * inverse_third_mass;
    let t17 = t7 * inverse_third_mass;
    let t18 = R::literal(1.0)
        / (-(t10 * inverse_l_1_times_first_y))
            .sub_product(t8, inverse_l_1_times_first_x);
    let t19 = (-(t11 * inverse_l_1_times_first_y))
        .sub_product(t9, inverse_l_1_times_first_x);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0)
        / (-(t11 * t1))
            .sub_product(t9, t0)
            .sub_product(t12, t2)
            .sub_product(t14, t4)
            .sub_product(t20, t19);
    let t22 = (-(t15 * t4)).sub_product(t13, t2);
    let t23 = t22 * t21;
    let first_mass_times_first_gravity = p.first_mass * p.first_gravity;
    let second_mass_times_second_gravity = p.second_mass * p.second_gravity;
    let third_mass_times_third_gravity = p.third_mass * p.third_gravity;
    let first_v_x_squared = first_v_x * first_v_x;
    let first_v_y_squared = first_v_y * first_v_y;
    let second_v_x_squared = second_v_x * second_v_x;
    let second_v_y_squared = second_v_y * second_v_y;
    let t24 = (-(inverse_l_1 * (first_v_x_squared + first_v_y_squared)))
        .add_product(t10, first_mass_times_first_gravity);
    let t25 = (t11 * first_mass_times_first_gravity)
        .add_product(
            inverse_l_2,
            (R::literal(2.0) * first_v_x * second_v_x)
                .add_product(R::literal(2.0) * first_v_y, second_v_y) - first_v_x_squared
                - first_v_y_squared - second_v_x_squared - second_v_y_squared,
        )
        .add_product(t14, second_mass_times_second_gravity)
        .sub_product(t20, t24);
    let t26 = (t15 * second_mass_times_second_gravity)
        .add_product(
            inverse_l_3,
            ((R::literal(2.0) * second_v_x * third_v_x)
                .add_product(R::literal(2.0) * second_v_y, third_v_y)
                - second_v_x_squared - second_v_y_squared)
                .sub_product(third_v_x, third_v_x)
                .sub_product(third_v_y, third_v_y),
        )
        .add_product(t17, third_mass_times_third_gravity)
        .sub_product(t23, t25)
        * (R::literal(1.0)
            / (-(t15 * t5))
                .sub_product(t13, t3)
                .sub_product(t16, t6)
                .sub_product(t17, t7)
                .sub_product(t23, t22));
    let t27 = (t25 * t21).sub_product(t23, t26);
    let t28 = (t24 * t18).sub_product(t20, t27);
    let third_v_y_dot = (-(third_mass_times_third_gravity * inverse_third_mass))
        .sub_product(t17, t26);
    let second_v_y_dot = (-(second_mass_times_second_gravity * inverse_second_mass))
        .sub_product(t14, t27)
        .sub_product(t15, t26);
    let second_v_x_dot = (-(t13 * t26)).sub_product(t12, t27);
    let first_v_y_dot = (-(first_mass_times_first_gravity * inverse_first_mass))
        .sub_product(t10, t28)
        .sub_product(t11, t27);
    let first_v_x_dot = (-(t9 * t27)).sub_product(t8, t28);
    PowerBalance {
        stored_rate: (first_mass_times_first_gravity * first_v_y)
            .add_product(second_mass_times_second_gravity, second_v_y)
            .add_product(third_mass_times_third_gravity, third_v_y)
            .add_product(p.first_mass * first_v_x, first_v_x_dot)
            .add_product(p.first_mass * first_v_y, first_v_y_dot)
            .add_product(p.second_mass * second_v_x, second_v_x_dot)
            .add_product(p.second_mass * second_v_y, second_v_y_dot)
            .sub_product(p.third_mass * third_v_x, t16 * t26)
            .add_product(p.third_mass * third_v_y, third_v_y_dot),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// `g`, zero on the constraints, in the order of `CONSTRAINT_SHAPES`.
///
/// 25 operations.
#[must_use]
pub fn constraint_values<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, ..] = *state;
    let second_x_minus_first_x = second_x - first_x;
    let second_y_minus_first_y = second_y - first_y;
    let third_x_minus_second_x = third_x - second_x;
    let third_y_minus_second_y = third_y - second_y;
    let link_1_value = R::literal(0.5) / p.l_1
        * (first_x * first_x).sub_product(p.l_1, p.l_1).add_product(first_y, first_y);
    let link_2_value = R::literal(0.5) / p.l_2
        * (-(p.l_2 * p.l_2))
            .add_product(second_x_minus_first_x, second_x_minus_first_x)
            .add_product(second_y_minus_first_y, second_y_minus_first_y);
    let link_3_value = R::literal(0.5) / p.l_3
        * (-(p.l_3 * p.l_3))
            .add_product(third_x_minus_second_x, third_x_minus_second_x)
            .add_product(third_y_minus_second_y, third_y_minus_second_y);
    [link_1_value, link_2_value, link_3_value]
}

/// `g'`, zero on the constraints too.
///
/// 33 operations.
#[must_use]
pub fn constraint_rates<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; CONSTRAINTS] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, first_v_x, first_v_y,
    second_v_x, second_v_y, third_v_x, third_v_y] = *state;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let second_x_minus_first_x = second_x - first_x;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    let second_y_minus_first_y = second_y - first_y;
    let third_x_minus_second_x = third_x - second_x;
    let third_y_minus_second_y = third_y - second_y;
    let link_1_rate = R::literal(1.0) / p.l_1
        * (first_x * first_v_x).add_product(first_y, first_v_y);
    let link_2_rate = (inverse_l_2 * second_v_x * second_x_minus_first_x)
        .add_product(inverse_l_2 * second_v_y, second_y_minus_first_y)
        .sub_product(inverse_l_2 * first_v_x, second_x_minus_first_x)
        .sub_product(inverse_l_2 * first_v_y, second_y_minus_first_y);
    let link_3_rate = (inverse_l_3 * third_v_x * third_x_minus_second_x)
        .add_product(inverse_l_3 * third_v_y, third_y_minus_second_y)
        .sub_product(inverse_l_3 * second_v_x, third_x_minus_second_x)
        .sub_product(inverse_l_3 * second_v_y, third_y_minus_second_y);
    [link_1_rate, link_2_rate, link_3_rate]
}

/// `G = dg'/dq'`, values in the order of `CONSTRAINT_MATRIX_PATTERN`.
///
/// 21 operations.
#[must_use]
pub fn constraint_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 10] {
    let [first_x, first_y, second_x, second_y, third_x, third_y, ..] = *state;
    let inverse_l_1 = R::literal(1.0) / p.l_1;
    let inverse_l_2 = R::literal(1.0) / p.l_2;
    let inverse_l_3 = R::literal(1.0) / p.l_3;
    [
        inverse_l_1 * first_x,
        inverse_l_1 * first_y,
        inverse_l_2 * (first_x - second_x),
        inverse_l_2 * (first_y - second_y),
        inverse_l_2 * (second_x - first_x),
        inverse_l_2 * (second_y - first_y),
        inverse_l_3 * (second_x - third_x),
        inverse_l_3 * (second_y - third_y),
        inverse_l_3 * (third_x - second_x),
        inverse_l_3 * (third_y - second_y),
    ]
}

impl Describe for PendulumConstrained {
    fn name(&self) -> &'static str {
        "pendulum_constrained"
    }
    fn title(&self) -> &'static str {
        "Chain of three pendulums, by constraints"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 6,
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
        matches!(index, 0 | 2 | 4)
    }
}

impl<R: Real> Simulator<R> for PendulumConstrained {
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
        name: "first.x",
        unit: "m",
        doc: "place, sideways",
    },
    Quantity {
        name: "first.y",
        unit: "m",
        doc: "place, upwards",
    },
    Quantity {
        name: "second.x",
        unit: "m",
        doc: "place, sideways",
    },
    Quantity {
        name: "second.y",
        unit: "m",
        doc: "place, upwards",
    },
    Quantity {
        name: "third.x",
        unit: "m",
        doc: "place, sideways",
    },
    Quantity {
        name: "third.y",
        unit: "m",
        doc: "place, upwards",
    },
    Quantity {
        name: "first.v_x",
        unit: "m/s",
        doc: "rate of place, sideways",
    },
    Quantity {
        name: "first.v_y",
        unit: "m/s",
        doc: "rate of place, upwards",
    },
    Quantity {
        name: "second.v_x",
        unit: "m/s",
        doc: "rate of place, sideways",
    },
    Quantity {
        name: "second.v_y",
        unit: "m/s",
        doc: "rate of place, upwards",
    },
    Quantity {
        name: "third.v_x",
        unit: "m/s",
        doc: "rate of place, sideways",
    },
    Quantity {
        name: "third.v_y",
        unit: "m/s",
        doc: "rate of place, upwards",
    },
];

static STATE_SCALES: [f64; STATES] = [
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
    1.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "l_1",
        unit: "m",
        doc: "length of the first link",
    },
    Quantity {
        name: "l_2",
        unit: "m",
        doc: "length of the second link",
    },
    Quantity {
        name: "l_3",
        unit: "m",
        doc: "length of the third link",
    },
    Quantity {
        name: "th_1",
        unit: "rad",
        doc: "angle of the first link at the start",
    },
    Quantity {
        name: "th_2",
        unit: "rad",
        doc: "angle of the second link at the start",
    },
    Quantity {
        name: "th_3",
        unit: "rad",
        doc: "angle of the third link at the start",
    },
    Quantity {
        name: "first.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "first.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "second.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "second.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "third.mass",
        unit: "kg",
        doc: "the mass",
    },
    Quantity {
        name: "third.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    1.0,
    0.7,
    0.4,
    0.9,
    1.1,
    1.4,
    1.0,
    9.81,
    0.8,
    9.81,
    0.5,
    9.81,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "end_x",
        unit: "m",
        doc: "place, sideways",
    },
    Quantity {
        name: "end_y",
        unit: "m",
        doc: "place, upwards",
    },
    Quantity {
        name: "force_1",
        unit: "N",
        doc: "force in the first link, pushing",
    },
    Quantity {
        name: "force_2",
        unit: "N",
        doc: "force in the second link, pushing",
    },
    Quantity {
        name: "force_3",
        unit: "N",
        doc: "force in the third link, pushing",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 1001,
    rtol: 1e-8,
    method: "dop853",
};

/// What coordinates must fulfil.
pub static CONSTRAINT_SHAPES: [Constraint<'static>; CONSTRAINTS] = [
    Constraint {
        name: "link_1",
        unit: "m",
        doc: "length of the first link",
        is_of_positions: true,
    },
    Constraint {
        name: "link_2",
        unit: "m",
        doc: "length of the second link",
        is_of_positions: true,
    },
    Constraint {
        name: "link_3",
        unit: "m",
        doc: "length of the third link",
        is_of_positions: true,
    },
];

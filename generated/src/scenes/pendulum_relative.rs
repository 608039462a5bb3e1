// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0ef43e66537a3898084c7eff67a00d42ce3331b678823244e9fb34c025087a6a  scenes/pendulum_relative.toml
//   2dff14c7fde2a579d8be25941f9964c4fb4a70b3507b299bd5e949c6b9d9de6d  units/three_pendulums_relative.toml
//
// Chain of three pendulums, by relative angles
//
// The chain of `pendulum_chain` once more, in the angles of its joints.
//
// Source:
//   Textbook.
//
// Shapes; all quantities are in SI units:
//   coordinates               3
//   first-order states        0
//   states                    6
//   parameters                7
//   outputs                   2
//   discontinuities           0
//
// State:
//     0  chain.th_1  [rad]    angle of the first link
//     1  chain.th_2  [rad]    angle of the second link from the one above
//     2  chain.th_3  [rad]    angle of the third link from the one above
//     3  chain.w_1   [rad/s]  rate of angle of the first link
//     4  chain.w_2   [rad/s]  rate of angle of the second link from the one above
//     5  chain.w_3   [rad/s]  rate of angle of the third link from the one above
//
// Nonzeros:
//   mass_matrix               9 of 3 by 3
//   rate_jacobian            21 of 6 by 6
//   parameter_jacobian       21 of 6 by 7
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    219
//   mass_matrix              61
//   forcing                 127
//   rate_jacobian           506
//   parameter_jacobian      642
//   time_derivative           0
//   outputs                  19
//   energy                   52
//   power_balance           314
// With constants of the parameters, prepared once a run:
//   prepare                  43
//   prepared_rate           178
//   prepared_rate_jacobian  463

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 3;

/// Length of the state y.
pub const STATES: usize = 6;

/// Parameters.
pub const PARAMETERS: usize = 7;

/// Wanted outputs.
pub const OUTPUTS: usize = 2;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 6,
    entries: &[
        (0, 3), (1, 4), (2, 5), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (4, 0), (4, 1),
        (4, 2), (4, 3), (4, 4), (4, 5), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 6,
    columns: 7,
    entries: &[
        (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (3, 5), (3, 6), (4, 0), (4, 1), (4, 2), (4, 3),
        (4, 4), (4, 5), (4, 6), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5), (5, 6),
    ],
};

/// Chain of three pendulums, by relative angles
///
/// The chain of \`pendulum_chain\` once more, in the angles of its joints.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PendulumRelative;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// chain.m_1: mass at the end of the first link \[kg\]. In the spec: 1.0.
    pub chain_m_1: R,
    /// chain.m_2: mass at the end of the second link \[kg\]. In the spec: 0.8.
    pub chain_m_2: R,
    /// chain.m_3: mass at the end of the third link \[kg\]. In the spec: 0.5.
    pub chain_m_3: R,
    /// chain.l_1: length of the first link \[m\]. In the spec: 1.0.
    pub chain_l_1: R,
    /// chain.l_2: length of the second link \[m\]. In the spec: 0.7.
    pub chain_l_2: R,
    /// chain.l_3: length of the third link \[m\]. In the spec: 0.4.
    pub chain_l_3: R,
    /// chain.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.81.
    pub chain_gravity: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            chain_m_1: values[0],
            chain_m_2: values[1],
            chain_m_3: values[2],
            chain_l_1: values[3],
            chain_l_2: values[4],
            chain_l_3: values[5],
            chain_gravity: values[6],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.chain_m_1,
            self.chain_m_2,
            self.chain_m_3,
            self.chain_l_1,
            self.chain_l_2,
            self.chain_l_3,
            self.chain_gravity,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            chain_m_1: R::literal(1.0),
            chain_m_2: R::literal(0.8),
            chain_m_3: R::literal(0.5),
            chain_l_1: R::literal(1.0),
            chain_l_2: R::literal(0.7),
            chain_l_3: R::literal(0.4),
            chain_gravity: R::literal(9.81),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// end_x: third mass, sideways \[m\].
    pub end_x: R,
    /// end_y: third mass, upwards \[m\].
    pub end_y: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            end_x: values[0],
            end_y: values[1],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [self.end_x, self.end_y]
    }
}

/// Where to find what in the state.
pub mod state {
    /// chain.th_1: angle of the first link \[rad\].
    pub const CHAIN_TH_1: usize = 0;
    /// chain.th_2: angle of the second link from the one above \[rad\].
    pub const CHAIN_TH_2: usize = 1;
    /// chain.th_3: angle of the third link from the one above \[rad\].
    pub const CHAIN_TH_3: usize = 2;
    /// chain.w_1: rate of angle of the first link \[rad/s\].
    pub const CHAIN_W_1: usize = 3;
    /// chain.w_2: rate of angle of the second link from the one above \[rad/s\].
    pub const CHAIN_W_2: usize = 4;
    /// chain.w_3: rate of angle of the third link from the one above \[rad/s\].
    pub const CHAIN_W_3: usize = 5;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 23;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub t3: R,
    pub t4: R,
    pub t5: R,
    pub chain_m_3_times_chain_l_3_squared: R,
    pub t6: R,
    pub t7: R,
    pub t8: R,
    pub t9: R,
    pub t10: R,
    pub chain_m_3_times_chain_l_3: R,
    pub chain_m_1_times_chain_gravity: R,
    pub t11: R,
    pub chain_m_2_times_chain_gravity: R,
    pub t12: R,
    pub t13: R,
    pub t14: R,
    pub chain_m_3_times_chain_gravity: R,
    pub t15: R,
    pub chain_m_2_times_chain_l_2: R,
    pub chain_m_3_times_chain_l_2: R,
    pub t16: R,
    pub t17: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            t3: values[1],
            t4: values[2],
            t5: values[3],
            chain_m_3_times_chain_l_3_squared: values[4],
            t6: values[5],
            t7: values[6],
            t8: values[7],
            t9: values[8],
            t10: values[9],
            chain_m_3_times_chain_l_3: values[10],
            chain_m_1_times_chain_gravity: values[11],
            t11: values[12],
            chain_m_2_times_chain_gravity: values[13],
            t12: values[14],
            t13: values[15],
            t14: values[16],
            chain_m_3_times_chain_gravity: values[17],
            t15: values[18],
            chain_m_2_times_chain_l_2: values[19],
            chain_m_3_times_chain_l_2: values[20],
            t16: values[21],
            t17: values[22],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.t3,
            self.t4,
            self.t5,
            self.chain_m_3_times_chain_l_3_squared,
            self.t6,
            self.t7,
            self.t8,
            self.t9,
            self.t10,
            self.chain_m_3_times_chain_l_3,
            self.chain_m_1_times_chain_gravity,
            self.t11,
            self.chain_m_2_times_chain_gravity,
            self.t12,
            self.t13,
            self.t14,
            self.chain_m_3_times_chain_gravity,
            self.t15,
            self.chain_m_2_times_chain_l_2,
            self.chain_m_3_times_chain_l_2,
            self.t16,
            self.t17,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 43 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let t0 = R::literal(2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let t1 = R::literal(2.0) * p.chain_m_3;
    let t2 = t1 * p.chain_l_1;
    let t3 = t2 * p.chain_l_2;
    let t4 = t2 * p.chain_l_3;
    let t5 = t1 * p.chain_l_2 * p.chain_l_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let t6 = ((p.chain_m_1 * chain_l_1_squared)
        .add_product(p.chain_m_2, chain_l_1_squared) + chain_m_2_times_chain_l_2_squared)
        .add_product(p.chain_m_3, chain_l_1_squared) + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared;
    let t7 = p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t8 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t9 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t10 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let chain_m_1_times_chain_gravity = p.chain_m_1 * p.chain_gravity;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let t11 = chain_m_2_times_chain_l_2 * p.chain_gravity;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t12 = chain_m_3_times_chain_l_2 * p.chain_l_3;
    let t13 = chain_m_3_times_chain_l_2 * p.chain_gravity;
    let t14 = chain_m_3_times_chain_l_3 * p.chain_gravity;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t15 = R::literal(2.0) * p.chain_l_2;
    let t16 = R::literal(2.0) * p.chain_l_1;
    let t17 = t1 * p.chain_l_3;
    Constants {
        t0,
        t3,
        t4,
        t5,
        chain_m_3_times_chain_l_3_squared,
        t6,
        t7,
        t8,
        t9,
        t10,
        chain_m_3_times_chain_l_3,
        chain_m_1_times_chain_gravity,
        t11,
        chain_m_2_times_chain_gravity,
        t12,
        t13,
        t14,
        chain_m_3_times_chain_gravity,
        t15,
        chain_m_2_times_chain_l_2,
        chain_m_3_times_chain_l_2,
        t16,
        t17,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.9),
        R::literal(0.200_000_000_000_000_07),
        R::literal(0.299_999_999_999_999_8),
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

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 219 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 178 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2),
    (sin_chain_th_3, cos_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = (sin_chain_th_1 * cos_chain_th_2)
        .add_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2)
        .sub_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_3 * t1).add_product(cos_chain_th_3, t0);
    let t3 = (cos_chain_th_3 * t1).sub_product(sin_chain_th_3, t0);
    let t4 = (sin_chain_th_1 * t1).sub_product(cos_chain_th_1, t0);
    let t5 = (cos_chain_th_1 * t1).add_product(sin_chain_th_1, t0);
    let t6 = (sin_chain_th_1 * t3).sub_product(cos_chain_th_1, t2);
    let t7 = (cos_chain_th_1 * t3).add_product(sin_chain_th_1, t2);
    let t8 = (t0 * t3).sub_product(t1, t2);
    let t9 = (t1 * t3).add_product(t0, t2);
    let t10 = c.t5 * t9;
    let t11 = c.t10 + t10;
    let t12 = t11.add_product(c.t7, t5).add_product(c.t8, t5).add_product(c.t9, t7);
    let t13 = p.chain_l_2 * t9;
    let t14 = c.chain_m_3_times_chain_l_3
        * (p.chain_l_3.add_product(p.chain_l_1, t7) + t13);
    let t15 = R::literal(1.0)
        / (c.t6.add_product(c.t0, t5).add_product(c.t3, t5).add_product(c.t4, t7) + t10);
    let t16 = t12 * t15;
    let t17 = t14 * t15;
    let t18 = R::literal(1.0) / t11.sub_product(t16, t12);
    let t19 = (c.chain_m_3_times_chain_l_3 * (p.chain_l_3 + t13)).sub_product(t17, t12);
    let t20 = t19 * t18;
    let t21 = c.t4 * chain_w_1;
    let t22 = c.t5 * chain_w_1 * chain_w_3 * t8;
    let t23 = c.t5 * chain_w_2 * chain_w_3 * t8;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t24 = c.t11 * t0;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t25 = c.t12 * chain_w_3_squared * t8;
    let t26 = c.t13 * t0;
    let t27 = c.t14 * t2;
    let t28 = ((((-(c.t3 * chain_w_1 * chain_w_2 * t4))
        .sub_product(c.t0 * chain_w_1 * chain_w_2, t4)
        .sub_product(t21 * chain_w_2, t6)
        .sub_product(t21 * chain_w_3, t6) - t22)
        .sub_product(c.t4 * chain_w_2 * chain_w_3, t6) - t23)
        .sub_product(c.chain_m_1_times_chain_gravity, chain_x_1)
        .sub_product(c.t7 * chain_w_2_squared, t4) - t24)
        .sub_product(c.chain_m_2_times_chain_gravity, chain_x_1)
        .sub_product(c.t8 * chain_w_2_squared, t4)
        .sub_product(c.t9 * chain_w_2_squared, t6);
    let t29 = (t28.sub_product(c.t9 * chain_w_3_squared, t6) - t25 - t26 - t27)
        .sub_product(c.chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t30 = (sin_chain_th_2 * cos_chain_th_3)
        .add_product(cos_chain_th_2, sin_chain_th_3);
    let t31 = (((-t22 - t23).sub_product(c.t7 * chain_w_1_squared, sin_chain_th_2) - t24)
        .sub_product(c.t8 * chain_w_1_squared, sin_chain_th_2)
        .sub_product(c.t9 * chain_w_1_squared, t30) - t25 - t26 - t27)
        .sub_product(t16, t29);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3
        * (-(p.chain_l_1 * chain_w_1_squared * t30))
            .add_product(c.t15 * chain_w_1 * chain_w_2, t8)
            .add_product(p.chain_l_2 * chain_w_1_squared, t8)
            .add_product(p.chain_l_2 * chain_w_2_squared, t8)
            .sub_product(p.chain_gravity, t2))
        .sub_product(t17, t29)
        .sub_product(t20, t31)
        * (R::literal(1.0)
            / c
                .chain_m_3_times_chain_l_3_squared
                .sub_product(t17, t14)
                .sub_product(t20, t19));
    let chain_w_2_dot = (t31 * t18).sub_product(t20, chain_w_3_dot);
    let chain_w_1_dot = (t29 * t15)
        .sub_product(t16, chain_w_2_dot)
        .sub_product(t17, chain_w_3_dot);
    [chain_w_1, chain_w_2, chain_w_3, chain_w_1_dot, chain_w_2_dot, chain_w_3_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 61 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 9] {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(_, cos_chain_th_1_minus_chain_a_2), (_, cos_chain_th_1_minus_chain_a_3),
    (_, cos_chain_a_2_minus_chain_a_3)] = R::sin_cos_each([
        chain_th_1 - chain_a_2,
        chain_th_1 - chain_a_3,
        chain_a_2 - chain_a_3,
    ]);
    let t0 = R::literal(2.0) * p.chain_m_3;
    let t1 = t0 * p.chain_l_1;
    let t2 = t0 * p.chain_l_2 * p.chain_l_3 * cos_chain_a_2_minus_chain_a_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t3 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared + t2;
    let t4 = t3
        .add_product(
            p.chain_m_2 * p.chain_l_1 * p.chain_l_2,
            cos_chain_th_1_minus_chain_a_2,
        )
        .add_product(
            chain_m_3_times_chain_l_1 * p.chain_l_2,
            cos_chain_th_1_minus_chain_a_2,
        )
        .add_product(
            chain_m_3_times_chain_l_1 * p.chain_l_3,
            cos_chain_th_1_minus_chain_a_3,
        );
    let t5 = p.chain_l_2 * cos_chain_a_2_minus_chain_a_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t6 = chain_m_3_times_chain_l_3
        * (p.chain_l_3.add_product(p.chain_l_1, cos_chain_th_1_minus_chain_a_3) + t5);
    let t7 = chain_m_3_times_chain_l_3 * (p.chain_l_3 + t5);
    [
        (((p.chain_m_1 * chain_l_1_squared).add_product(p.chain_m_2, chain_l_1_squared)
            + chain_m_2_times_chain_l_2_squared)
            .add_product(p.chain_m_3, chain_l_1_squared)
            + chain_m_3_times_chain_l_2_squared + chain_m_3_times_chain_l_3_squared)
            .add_product(
                R::literal(2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2,
                cos_chain_th_1_minus_chain_a_2,
            )
            .add_product(t1 * p.chain_l_2, cos_chain_th_1_minus_chain_a_2)
            .add_product(t1 * p.chain_l_3, cos_chain_th_1_minus_chain_a_3) + t2,
        t4,
        t6,
        t4,
        t3,
        t7,
        t6,
        t7,
        chain_m_3_times_chain_l_3_squared,
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 127 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, _), (sin_chain_a_2, _), (sin_chain_a_3, _),
    (sin_chain_th_1_minus_chain_a_2, _), (sin_chain_th_1_minus_chain_a_3, _),
    (sin_chain_a_2_minus_chain_a_3, _), (sin_chain_th_2, _),
    (sin_chain_th_2_plus_chain_th_3, _)] = R::sin_cos_each([
        chain_th_1,
        chain_a_2,
        chain_a_3,
        chain_th_1 - chain_a_2,
        chain_th_1 - chain_a_3,
        chain_a_2 - chain_a_3,
        chain_th_2,
        chain_th_2 + chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = R::literal(2.0) * p.chain_m_3;
    let t1 = t0 * p.chain_l_1;
    let t2 = t1 * p.chain_l_3;
    let t3 = t0 * p.chain_l_2 * p.chain_l_3;
    let t4 = p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t5 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t6 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t7 = t2 * chain_w_1;
    let t8 = t3 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t9 = t3 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t10 = p.chain_m_2 * p.chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t11 = chain_m_3_times_chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t12 = chain_m_3_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t13 = chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let t14 = (((-(t1 * p.chain_l_2 * chain_w_1 * chain_w_2
        * sin_chain_th_1_minus_chain_a_2))
        .sub_product(
            R::literal(2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2 * chain_w_1
                * chain_w_2,
            sin_chain_th_1_minus_chain_a_2,
        )
        .sub_product(t7 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t7 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t8)
        .sub_product(t2 * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t9)
        .sub_product(p.chain_m_1 * p.chain_gravity, chain_x_1)
        .sub_product(t4 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2) - t10;
    let chain_th_1_forcing = (t14
        .sub_product(p.chain_m_2 * p.chain_gravity, chain_x_1)
        .sub_product(t5 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2)
        .sub_product(t6 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t6 * chain_w_3_squared, sin_chain_th_1_minus_chain_a_3) - t11 - t12
        - t13)
        .sub_product(p.chain_m_3 * p.chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let chain_th_2_forcing = ((-t8 - t9)
        .sub_product(t4 * chain_w_1_squared, sin_chain_th_2) - t10)
        .sub_product(t5 * chain_w_1_squared, sin_chain_th_2)
        .sub_product(t6 * chain_w_1_squared, sin_chain_th_2_plus_chain_th_3) - t11 - t12
        - t13;
    let chain_th_3_forcing = chain_m_3_times_chain_l_3
        * (-(p.chain_l_1 * chain_w_1_squared * sin_chain_th_2_plus_chain_th_3))
            .add_product(
                R::literal(2.0) * p.chain_l_2 * chain_w_1 * chain_w_2,
                sin_chain_a_2_minus_chain_a_3,
            )
            .add_product(p.chain_l_2 * chain_w_1_squared, sin_chain_a_2_minus_chain_a_3)
            .add_product(p.chain_l_2 * chain_w_2_squared, sin_chain_a_2_minus_chain_a_3)
            .sub_product(p.chain_gravity, sin_chain_a_3);
    [chain_th_1_forcing, chain_th_2_forcing, chain_th_3_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 506 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 21] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 463 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 21] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2),
    (sin_chain_th_3, cos_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
    ]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let t0 = (sin_chain_th_1 * cos_chain_th_2)
        .add_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2)
        .sub_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_3 * t1).add_product(cos_chain_th_3, t0);
    let t3 = (cos_chain_th_3 * t1).sub_product(sin_chain_th_3, t0);
    let t4 = (sin_chain_th_1 * t1).sub_product(cos_chain_th_1, t0);
    let t5 = (cos_chain_th_1 * t1).add_product(sin_chain_th_1, t0);
    let t6 = (sin_chain_th_1 * t3).sub_product(cos_chain_th_1, t2);
    let t7 = (cos_chain_th_1 * t3).add_product(sin_chain_th_1, t2);
    let t8 = (t0 * t3).sub_product(t1, t2);
    let t9 = (t1 * t3).add_product(t0, t2);
    let t10 = c.t5 * t9;
    let t11 = c.t10 + t10;
    let t12 = t11.add_product(c.t7, t5).add_product(c.t8, t5).add_product(c.t9, t7);
    let t13 = p.chain_l_2 * t9;
    let t14 = c.chain_m_3_times_chain_l_3
        * (p.chain_l_3.add_product(p.chain_l_1, t7) + t13);
    let t15 = R::literal(1.0)
        / (c.t6.add_product(c.t0, t5).add_product(c.t3, t5).add_product(c.t4, t7) + t10);
    let t16 = t12 * t15;
    let t17 = t14 * t15;
    let t18 = R::literal(1.0) / t11.sub_product(t16, t12);
    let t19 = (c.chain_m_3_times_chain_l_3 * (p.chain_l_3 + t13)).sub_product(t17, t12);
    let t20 = t19 * t18;
    let t21 = R::literal(1.0)
        / c
            .chain_m_3_times_chain_l_3_squared
            .sub_product(t17, t14)
            .sub_product(t20, t19);
    let t22 = c.t0 * chain_w_1 * chain_w_2;
    let t23 = c.t3 * chain_w_1 * chain_w_2;
    let t24 = c.t4 * chain_w_1;
    let t25 = t24 * chain_w_2;
    let t26 = t24 * chain_w_3;
    let t27 = c.t5 * chain_w_1 * chain_w_3 * t8;
    let t28 = c.t4 * chain_w_2 * chain_w_3;
    let t29 = c.t5 * chain_w_2 * chain_w_3 * t8;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t30 = c.t7 * chain_w_2_squared;
    let t31 = c.t11 * t0;
    let t32 = c.t8 * chain_w_2_squared;
    let t33 = c.t9 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t34 = c.t9 * chain_w_3_squared;
    let t35 = c.t12 * chain_w_3_squared * t8;
    let t36 = c.t13 * t0;
    let t37 = c.t14 * t2;
    let t38 = (((((-(t23 * t4))
        .sub_product(t22, t4)
        .sub_product(t25, t6)
        .sub_product(t26, t6) - t27)
        .sub_product(t28, t6) - t29)
        .sub_product(c.chain_m_1_times_chain_gravity, chain_x_1)
        .sub_product(t30, t4) - t31)
        .sub_product(c.chain_m_2_times_chain_gravity, chain_x_1)
        .sub_product(t32, t4)
        .sub_product(t33, t6)
        .sub_product(t34, t6) - t35 - t36 - t37)
        .sub_product(c.chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t39 = c.t7 * chain_w_1_squared;
    let t40 = c.t8 * chain_w_1_squared;
    let t41 = (sin_chain_th_2 * cos_chain_th_3)
        .add_product(cos_chain_th_2, sin_chain_th_3);
    let t42 = (cos_chain_th_2 * cos_chain_th_3)
        .sub_product(sin_chain_th_2, sin_chain_th_3);
    let t43 = c.t9 * chain_w_1_squared;
    let t44 = c.t15 * chain_w_1;
    let t45 = t44 * chain_w_2;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_1_squared = p.chain_l_2 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t46 = (((-t27 - t29).sub_product(t39, sin_chain_th_2) - t31)
        .sub_product(t40, sin_chain_th_2)
        .sub_product(t43, t41) - t35 - t36 - t37)
        .sub_product(t16, t38);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3
        * (-(chain_l_1_times_chain_w_1_squared * t41))
            .add_product(t45, t8)
            .add_product(chain_l_2_times_chain_w_1_squared, t8)
            .add_product(chain_l_2_times_chain_w_2_squared, t8)
            .sub_product(p.chain_gravity, t2))
        .sub_product(t17, t38)
        .sub_product(t20, t46) * t21;
    let chain_w_2_dot = (t46 * t18).sub_product(t20, chain_w_3_dot);
    let chain_w_1_dot = (t38 * t15)
        .sub_product(t16, chain_w_2_dot)
        .sub_product(t17, chain_w_3_dot);
    let t47 = (c.chain_m_2_times_chain_l_2 * t1)
        .add_product(c.chain_m_3_times_chain_l_2, t1)
        .add_product(c.chain_m_3_times_chain_l_3, t3);
    let t48 = p.chain_gravity
        * t47
            .add_product(p.chain_m_1, chain_l_1_times_cos_chain_th_1)
            .add_product(p.chain_m_2, chain_l_1_times_cos_chain_th_1)
            .add_product(p.chain_m_3, chain_l_1_times_cos_chain_th_1);
    let t49 = c.t14 * t3;
    let t50 = (-(p.chain_gravity * t47)).add_product(t16, t48);
    let chain_w_3_dot_by_chain_th_1 = (-t49).add_product(t17, t48).sub_product(t20, t50)
        * t21;
    let chain_w_2_dot_by_chain_th_1 = (t50 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = (-(t48 * t15))
        .sub_product(t16, chain_w_2_dot_by_chain_th_1)
        .sub_product(t17, chain_w_3_dot_by_chain_th_1);
    let t51 = c.t11 * t1;
    let t52 = c.t13 * t1;
    let t53 = chain_l_1_times_chain_w_1_squared * t42;
    let t54 = p.chain_gravity * t3;
    let t55 = (c.chain_m_2_times_chain_l_2 * t4)
        .add_product(c.chain_m_3_times_chain_l_2, t4)
        .add_product(c.chain_m_3_times_chain_l_3, t6);
    let t56 = p.chain_l_1 * t55;
    let t57 = c.t9 * t6;
    let t58 = ((t22 * t5)
        .add_product(t23, t5)
        .add_product(t25, t7)
        .add_product(t26, t7)
        .add_product(t28, t7)
        .add_product(t30, t5)
        .add_product(t32, t5)
        .add_product(t33, t7)
        .add_product(t34, t7) - t51 - t52 - t49)
        .sub_product(c.t16 * t55, chain_w_1_dot)
        .sub_product(t56, chain_w_2_dot)
        .sub_product(t57, chain_w_3_dot);
    let t59 = ((-t51)
        .sub_product(t39, cos_chain_th_2)
        .sub_product(t40, cos_chain_th_2)
        .sub_product(t43, t42) - t52 - t49)
        .sub_product(t56, chain_w_1_dot)
        .sub_product(t16, t58);
    let chain_w_3_dot_by_chain_th_2 = (c.chain_m_3_times_chain_l_3 * (-t53 - t54))
        .sub_product(t57, chain_w_1_dot)
        .sub_product(t17, t58)
        .sub_product(t20, t59) * t21;
    let chain_w_2_dot_by_chain_th_2 = (t59 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t58 * t15)
        .sub_product(t16, chain_w_2_dot_by_chain_th_2)
        .sub_product(t17, chain_w_3_dot_by_chain_th_2);
    let t60 = c.t16 * chain_w_1;
    let t61 = t44 * chain_w_3 * t9;
    let t62 = c.t15 * chain_w_2;
    let t63 = t62 * chain_w_3 * t9;
    let t64 = p.chain_l_2 * chain_w_3_squared * t9;
    let t65 = p.chain_l_1 * t6;
    let t66 = t65.add_product(p.chain_l_2, t8);
    let t67 = c.chain_m_3_times_chain_l_3 * t65.add_product(c.t15, t8);
    let t68 = c.chain_m_3_times_chain_l_3 * t66;
    let t69 = (c.chain_m_3_times_chain_l_3
        * ((((t60 * chain_w_2 * t7).add_product(t60 * chain_w_3, t7) + t61)
            .add_product(c.t16 * chain_w_2 * chain_w_3, t7) + t63)
            .add_product(p.chain_l_1 * chain_w_2_squared, t7)
            .add_product(p.chain_l_1 * chain_w_3_squared, t7) + t64 - t54))
        .sub_product(c.t17 * t66, chain_w_1_dot)
        .sub_product(t67, chain_w_2_dot)
        .sub_product(t68, chain_w_3_dot);
    let t70 = c.t12 * t8;
    let t71 = (c.chain_m_3_times_chain_l_3 * (t61 + t63 + t64 - t53 - t54))
        .sub_product(t67, chain_w_1_dot)
        .sub_product(c.t5 * t8, chain_w_2_dot)
        .sub_product(t70, chain_w_3_dot)
        .sub_product(t16, t69);
    let chain_w_3_dot_by_chain_th_3 = (c.chain_m_3_times_chain_l_3
        * ((-t53)
            .sub_product(t45, t9)
            .sub_product(chain_l_2_times_chain_w_1_squared, t9)
            .sub_product(chain_l_2_times_chain_w_2_squared, t9) - t54))
        .sub_product(t68, chain_w_1_dot)
        .sub_product(t70, chain_w_2_dot)
        .sub_product(t17, t69)
        .sub_product(t20, t71) * t21;
    let chain_w_2_dot_by_chain_th_3 = (t71 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t69 * t15)
        .sub_product(t16, chain_w_2_dot_by_chain_th_3)
        .sub_product(t17, chain_w_3_dot_by_chain_th_3);
    let t72 = c.t7 * chain_w_2 * t4;
    let t73 = c.t8 * chain_w_2 * t4;
    let t74 = c.t9 * chain_w_2 * t6;
    let t75 = c.t9 * chain_w_3 * t6;
    let t76 = c.t12 * chain_w_3 * t8;
    let t77 = R::literal(2.0) * (t72 + t73 + t74 + t75 + t76);
    let t78 = c.t7 * chain_w_1;
    let t79 = c.t8 * chain_w_1;
    let t80 = c.t9 * chain_w_1;
    let t81 = (-(R::literal(2.0)
        * ((t78 * sin_chain_th_2).add_product(t79, sin_chain_th_2).add_product(t80, t41)
            + t76)))
        .add_product(t16, t77);
    let chain_w_3_dot_by_chain_w_1 = (c.chain_m_3_times_chain_l_3
        * (-(t60 * t41)).add_product(t44, t8).add_product(t62, t8))
        .add_product(t17, t77)
        .sub_product(t20, t81) * t21;
    let chain_w_2_dot_by_chain_w_1 = (t81 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = (-(t77 * t15))
        .sub_product(t16, chain_w_2_dot_by_chain_w_1)
        .sub_product(t17, chain_w_3_dot_by_chain_w_1);
    let t82 = R::literal(2.0)
        * ((t78 * t4).add_product(t79, t4).add_product(t80, t6) + t72 + t73 + t74 + t75
            + t76);
    let t83 = (-(c.t5 * chain_w_3 * t8)).add_product(t16, t82);
    let chain_w_3_dot_by_chain_w_2 = (c.t5 * chain_s_2 * t8)
        .add_product(t17, t82)
        .sub_product(t20, t83) * t21;
    let chain_w_2_dot_by_chain_w_2 = (t83 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = (-(t82 * t15))
        .sub_product(t16, chain_w_2_dot_by_chain_w_2)
        .sub_product(t17, chain_w_3_dot_by_chain_w_2);
    let t84 = c.t17 * chain_s_3 * t66;
    let t85 = (-(c.t5 * chain_s_3 * t8)).add_product(t16, t84);
    let chain_w_3_dot_by_chain_w_3 = (t17 * t84).sub_product(t20, t85) * t21;
    let chain_w_2_dot_by_chain_w_3 = (t85 * t18)
        .sub_product(t20, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = (-(t84 * t15))
        .sub_product(t16, chain_w_2_dot_by_chain_w_3)
        .sub_product(t17, chain_w_3_dot_by_chain_w_3);
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        chain_w_1_dot_by_chain_th_1,
        chain_w_1_dot_by_chain_th_2,
        chain_w_1_dot_by_chain_th_3,
        chain_w_1_dot_by_chain_w_1,
        chain_w_1_dot_by_chain_w_2,
        chain_w_1_dot_by_chain_w_3,
        chain_w_2_dot_by_chain_th_1,
        chain_w_2_dot_by_chain_th_2,
        chain_w_2_dot_by_chain_th_3,
        chain_w_2_dot_by_chain_w_1,
        chain_w_2_dot_by_chain_w_2,
        chain_w_2_dot_by_chain_w_3,
        chain_w_3_dot_by_chain_th_1,
        chain_w_3_dot_by_chain_th_2,
        chain_w_3_dot_by_chain_th_3,
        chain_w_3_dot_by_chain_w_1,
        chain_w_3_dot_by_chain_w_2,
        chain_w_3_dot_by_chain_w_3,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 642 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 21] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let chain_th_1_minus_chain_a_2 = chain_th_1 - chain_a_2;
    let chain_th_1_minus_chain_a_3 = chain_th_1 - chain_a_3;
    let chain_a_2_minus_chain_a_3 = chain_a_2 - chain_a_3;
    let [(sin_chain_th_1, _), (sin_chain_a_2, _), (sin_chain_a_3, _),
    (sin_chain_th_1_minus_chain_a_2, cos_chain_th_1_minus_chain_a_2),
    (sin_chain_th_1_minus_chain_a_3, cos_chain_th_1_minus_chain_a_3),
    (sin_chain_a_2_minus_chain_a_3, cos_chain_a_2_minus_chain_a_3), (sin_chain_th_2, _),
    (sin_chain_th_2_plus_chain_th_3, _)] = R::sin_cos_each([
        chain_th_1,
        chain_a_2,
        chain_a_3,
        chain_th_1_minus_chain_a_2,
        chain_th_1_minus_chain_a_3,
        chain_a_2_minus_chain_a_3,
        chain_th_2,
        chain_th_2 + chain_th_3,
    ]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = R::literal(2.0) * p.chain_m_2;
    let t1 = t0 * p.chain_l_1;
    let t2 = t1 * p.chain_l_2;
    let t3 = R::literal(2.0) * p.chain_m_3;
    let t4 = t3 * p.chain_l_1;
    let t5 = t4 * p.chain_l_2;
    let t6 = t4 * p.chain_l_3;
    let t7 = t3 * p.chain_l_2;
    let t8 = t7 * p.chain_l_3;
    let t9 = t8 * cos_chain_a_2_minus_chain_a_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_l_3_squared = p.chain_l_3 * p.chain_l_3;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * chain_l_3_squared;
    let chain_m_2_times_chain_l_1 = p.chain_m_2 * p.chain_l_1;
    let t10 = chain_m_2_times_chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t11 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t12 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t13 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared + t9;
    let t14 = t13
        .add_product(t10, cos_chain_th_1_minus_chain_a_2)
        .add_product(t11, cos_chain_th_1_minus_chain_a_2)
        .add_product(t12, cos_chain_th_1_minus_chain_a_3);
    let t15 = p.chain_l_1 * cos_chain_th_1_minus_chain_a_3;
    let t16 = p.chain_l_2 * cos_chain_a_2_minus_chain_a_3;
    let t17 = p.chain_l_3 + t15 + t16;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t18 = chain_m_3_times_chain_l_3 * t17;
    let t19 = p.chain_l_3 + t16;
    let t20 = R::literal(1.0)
        / ((((p.chain_m_1 * chain_l_1_squared)
            .add_product(p.chain_m_2, chain_l_1_squared)
            + chain_m_2_times_chain_l_2_squared)
            .add_product(p.chain_m_3, chain_l_1_squared)
            + chain_m_3_times_chain_l_2_squared + chain_m_3_times_chain_l_3_squared)
            .add_product(t2, cos_chain_th_1_minus_chain_a_2)
            .add_product(t5, cos_chain_th_1_minus_chain_a_2)
            .add_product(t6, cos_chain_th_1_minus_chain_a_3) + t9);
    let t21 = t14 * t20;
    let t22 = t18 * t20;
    let t23 = R::literal(1.0) / t13.sub_product(t21, t14);
    let t24 = (chain_m_3_times_chain_l_3 * t19).sub_product(t22, t14);
    let t25 = t24 * t23;
    let t26 = R::literal(1.0)
        / chain_m_3_times_chain_l_3_squared.sub_product(t22, t18).sub_product(t25, t24);
    let t27 = t6 * chain_w_1;
    let t28 = t8 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t29 = t8 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_m_1_times_chain_gravity = p.chain_m_1 * p.chain_gravity;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let t30 = chain_m_2_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t31 = chain_m_3_times_chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t32 = chain_m_3_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t33 = chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t34 = ((((-(t5 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2))
        .sub_product(t2 * chain_w_1 * chain_w_2, sin_chain_th_1_minus_chain_a_2)
        .sub_product(t27 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t27 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t28)
        .sub_product(t6 * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t29)
        .sub_product(chain_m_1_times_chain_gravity, chain_x_1)
        .sub_product(t10 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2) - t30)
        .sub_product(chain_m_2_times_chain_gravity, chain_x_1)
        .sub_product(t11 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2)
        .sub_product(t12 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3);
    let t35 = (t34.sub_product(t12 * chain_w_3_squared, sin_chain_th_1_minus_chain_a_3)
        - t31 - t32 - t33)
        .sub_product(chain_m_3_times_chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t36 = R::literal(2.0) * p.chain_l_2;
    let t37 = t36 * chain_w_1;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let t38 = chain_l_1_times_chain_w_1_squared * sin_chain_th_2_plus_chain_th_3;
    let chain_gravity_times_sin_chain_a_3 = p.chain_gravity * sin_chain_a_3;
    let t39 = (-t38)
        .add_product(t37 * chain_w_2, sin_chain_a_2_minus_chain_a_3)
        .add_product(p.chain_l_2 * chain_w_1_squared, sin_chain_a_2_minus_chain_a_3)
        .add_product(p.chain_l_2 * chain_w_2_squared, sin_chain_a_2_minus_chain_a_3)
        - chain_gravity_times_sin_chain_a_3;
    let t40 = (((-t28 - t29).sub_product(t10 * chain_w_1_squared, sin_chain_th_2) - t30)
        .sub_product(t11 * chain_w_1_squared, sin_chain_th_2)
        .sub_product(t12 * chain_w_1_squared, sin_chain_th_2_plus_chain_th_3) - t31 - t32
        - t33)
        .sub_product(t21, t35);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3 * t39)
        .sub_product(t22, t35)
        .sub_product(t25, t40) * t26;
    let chain_w_2_dot = (t40 * t23).sub_product(t25, chain_w_3_dot);
    let chain_w_1_dot = (t35 * t20)
        .sub_product(t21, chain_w_2_dot)
        .sub_product(t22, chain_w_3_dot);
    let t41 = R::literal(2.0) * p.chain_l_1;
    let t42 = t41 * chain_w_1;
    let t43 = t3 * p.chain_l_3;
    let chain_gravity_times_chain_x_1 = p.chain_gravity * chain_x_1;
    let t44 = (-chain_gravity_times_chain_x_1)
        .sub_product(chain_l_1_squared, chain_w_1_dot);
    let t45 = t21 * t44;
    let chain_w_3_dot_by_chain_m_1 = (-(t22 * t44)).add_product(t25, t45) * t26;
    let chain_w_2_dot_by_chain_m_1 = (-(t45 * t23))
        .sub_product(t25, chain_w_3_dot_by_chain_m_1);
    let chain_w_1_dot_by_chain_m_1 = (t44 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_m_1)
        .sub_product(t22, chain_w_3_dot_by_chain_m_1);
    let t46 = t41 * p.chain_l_2;
    let chain_l_1_times_chain_l_2 = p.chain_l_1 * p.chain_l_2;
    let t47 = chain_l_1_times_chain_l_2 * chain_w_2_squared
        * sin_chain_th_1_minus_chain_a_2;
    let t48 = p.chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t49 = -(t46 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2);
    let t50 = t46 * cos_chain_th_1_minus_chain_a_2;
    let t51 = chain_l_1_squared + chain_l_2_squared;
    let t52 = p.chain_l_2
        * p.chain_l_2.add_product(p.chain_l_1, cos_chain_th_1_minus_chain_a_2);
    let t53 = (t49 - t47 - t48 - chain_gravity_times_chain_x_1)
        .sub_product(t51 + t50, chain_w_1_dot)
        .sub_product(t52, chain_w_2_dot);
    let t54 = (-(p.chain_l_2
        * (chain_l_1_times_chain_w_1_squared * sin_chain_th_2)
            .add_product(p.chain_gravity, sin_chain_a_2)))
        .sub_product(t52, chain_w_1_dot)
        .sub_product(chain_l_2_squared, chain_w_2_dot)
        .sub_product(t21, t53);
    let chain_w_3_dot_by_chain_m_2 = (-(t22 * t53)).sub_product(t25, t54) * t26;
    let chain_w_2_dot_by_chain_m_2 = (t54 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_m_2);
    let chain_w_1_dot_by_chain_m_2 = (t53 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_m_2)
        .sub_product(t22, chain_w_3_dot_by_chain_m_2);
    let t55 = t41 * p.chain_l_3;
    let t56 = t55 * chain_w_1;
    let t57 = t36 * p.chain_l_3;
    let t58 = t57 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t59 = t57 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_l_1_times_chain_l_3 = p.chain_l_1 * p.chain_l_3;
    let t60 = p.chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t61 = p.chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let t62 = t57 * cos_chain_a_2_minus_chain_a_3;
    let t63 = chain_l_2_squared + chain_l_3_squared + t62;
    let t64 = t63
        .add_product(chain_l_1_times_chain_l_2, cos_chain_th_1_minus_chain_a_2)
        .add_product(chain_l_1_times_chain_l_3, cos_chain_th_1_minus_chain_a_3);
    let t65 = (((t49
        .sub_product(t56 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t56 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t58)
        .sub_product(t55 * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t59
        - t47)
        .sub_product(
            chain_l_1_times_chain_l_3 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_3,
        )
        .sub_product(
            chain_l_1_times_chain_l_3 * chain_w_3_squared,
            sin_chain_th_1_minus_chain_a_3,
        ) - t60 - t48 - t61 - chain_gravity_times_chain_x_1)
        .sub_product(
            (t51 + chain_l_3_squared + t50)
                .add_product(t55, cos_chain_th_1_minus_chain_a_3) + t62,
            chain_w_1_dot,
        )
        .sub_product(t64, chain_w_2_dot);
    let t66 = p.chain_l_3 * t17;
    let t67 = t65.sub_product(t66, chain_w_3_dot);
    let t68 = p.chain_l_3 * t19;
    let t69 = ((-t58 - t59)
        .sub_product(chain_l_1_times_chain_l_2 * chain_w_1_squared, sin_chain_th_2)
        .sub_product(
            chain_l_1_times_chain_l_3 * chain_w_1_squared,
            sin_chain_th_2_plus_chain_th_3,
        ) - t60 - t48 - t61)
        .sub_product(t64, chain_w_1_dot)
        .sub_product(t63, chain_w_2_dot)
        .sub_product(t68, chain_w_3_dot)
        .sub_product(t21, t67);
    let chain_w_3_dot_by_chain_m_3 = (p.chain_l_3 * t39)
        .sub_product(t66, chain_w_1_dot)
        .sub_product(t68, chain_w_2_dot)
        .sub_product(chain_l_3_squared, chain_w_3_dot)
        .sub_product(t22, t67)
        .sub_product(t25, t69) * t26;
    let chain_w_2_dot_by_chain_m_3 = (t69 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_m_3);
    let chain_w_1_dot_by_chain_m_3 = (t67 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_m_3)
        .sub_product(t22, chain_w_3_dot_by_chain_m_3);
    let t70 = t0 * p.chain_l_2;
    let t71 = t43 * chain_w_1;
    let t72 = t71 * chain_w_3;
    let t73 = t43 * chain_w_2 * chain_w_3;
    let t74 = chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let t75 = (-(t7 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2))
        .sub_product(t70 * chain_w_1 * chain_w_2, sin_chain_th_1_minus_chain_a_2)
        .sub_product(t71 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t72, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t73, sin_chain_th_1_minus_chain_a_3)
        .sub_product(chain_m_1_times_chain_gravity, sin_chain_th_1)
        .sub_product(
            chain_m_2_times_chain_l_2 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_2,
        )
        .sub_product(chain_m_2_times_chain_gravity, sin_chain_th_1)
        .sub_product(
            chain_m_3_times_chain_l_2 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_2,
        )
        .sub_product(
            chain_m_3_times_chain_l_3 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_3,
        )
        .sub_product(t74, sin_chain_th_1_minus_chain_a_3)
        .sub_product(chain_m_3_times_chain_gravity, sin_chain_th_1);
    let t76 = chain_m_2_times_chain_l_2 * cos_chain_th_1_minus_chain_a_2;
    let t77 = chain_m_3_times_chain_l_2 * cos_chain_th_1_minus_chain_a_2;
    let t78 = chain_m_3_times_chain_l_3 * cos_chain_th_1_minus_chain_a_3;
    let t79 = t76 + t77 + t78;
    let t80 = t75
        .sub_product(
            R::literal(2.0)
                * (chain_m_2_times_chain_l_1.add_product(p.chain_m_1, p.chain_l_1)
                    + chain_m_3_times_chain_l_1 + t76 + t77 + t78),
            chain_w_1_dot,
        )
        .sub_product(t79, chain_w_2_dot)
        .sub_product(t78, chain_w_3_dot);
    let t81 = (-((chain_m_2_times_chain_l_2 * sin_chain_th_2)
        .add_product(chain_m_3_times_chain_l_2, sin_chain_th_2)
        .add_product(chain_m_3_times_chain_l_3, sin_chain_th_2_plus_chain_th_3)
        * chain_w_1_squared))
        .sub_product(t79, chain_w_1_dot)
        .sub_product(t21, t80);
    let chain_w_3_dot_by_chain_l_1 = (-(chain_m_3_times_chain_l_3 * chain_w_1_squared
        * sin_chain_th_2_plus_chain_th_3))
        .sub_product(t78, chain_w_1_dot)
        .sub_product(t22, t80)
        .sub_product(t25, t81) * t26;
    let chain_w_2_dot_by_chain_l_1 = (t81 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_l_1);
    let chain_w_1_dot_by_chain_l_1 = (t80 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_l_1)
        .sub_product(t22, chain_w_3_dot_by_chain_l_1);
    let t82 = t72 * sin_chain_a_2_minus_chain_a_3;
    let t83 = t73 * sin_chain_a_2_minus_chain_a_3;
    let t84 = chain_m_2_times_chain_gravity * sin_chain_a_2;
    let t85 = t74 * sin_chain_a_2_minus_chain_a_3;
    let t86 = chain_m_3_times_chain_gravity * sin_chain_a_2;
    let t87 = chain_m_2_times_chain_l_1 * cos_chain_th_1_minus_chain_a_2;
    let t88 = chain_m_3_times_chain_l_1 * cos_chain_th_1_minus_chain_a_2;
    let t89 = chain_m_3_times_chain_l_3 * cos_chain_a_2_minus_chain_a_3;
    let t90 = chain_m_2_times_chain_l_2 + chain_m_3_times_chain_l_2;
    let t91 = (t70 + t7).add_product(t43, cos_chain_a_2_minus_chain_a_3) + t87 + t88;
    let t92 = t89 * chain_w_3_dot;
    let t93 = ((((-(t4 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2))
        .sub_product(t1 * chain_w_1 * chain_w_2, sin_chain_th_1_minus_chain_a_2) - t82
        - t83)
        .sub_product(
            chain_m_2_times_chain_l_1 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_2,
        ) - t84)
        .sub_product(
            chain_m_3_times_chain_l_1 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_a_2,
        ) - t85 - t86)
        .sub_product(R::literal(2.0) * (t90 + t87 + t88 + t89), chain_w_1_dot)
        .sub_product(t91, chain_w_2_dot) - t92;
    let t94 = ((((-t82 - t83)
        .sub_product(chain_m_2_times_chain_l_1 * chain_w_1_squared, sin_chain_th_2)
        - t84)
        .sub_product(chain_m_3_times_chain_l_1 * chain_w_1_squared, sin_chain_th_2) - t85
        - t86)
        .sub_product(t91, chain_w_1_dot)
        .sub_product(R::literal(2.0) * (t90 + t89), chain_w_2_dot) - t92)
        .sub_product(t21, t93);
    let chain_w_3_dot_by_chain_l_2 = (chain_m_3_times_chain_l_3 * (chain_s_2 * chain_s_2)
        * sin_chain_a_2_minus_chain_a_3)
        .sub_product(t89, chain_w_1_dot)
        .sub_product(t89, chain_w_2_dot)
        .sub_product(t22, t93)
        .sub_product(t25, t94) * t26;
    let chain_w_2_dot_by_chain_l_2 = (t94 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_l_2);
    let chain_w_1_dot_by_chain_l_2 = (t93 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_l_2)
        .sub_product(t22, chain_w_3_dot_by_chain_l_2);
    let t95 = t37 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t96 = t36 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t97 = p.chain_l_2 * chain_w_3_squared * sin_chain_a_2_minus_chain_a_3;
    let t98 = R::literal(2.0) * p.chain_l_3;
    let t99 = p.chain_m_3 * (t98.add_product(t36, cos_chain_a_2_minus_chain_a_3) + t15);
    let t100 = p.chain_m_3 * (t98 + t15 + t16);
    let t101 = (p.chain_m_3
        * ((((-(t42 * chain_w_3 * sin_chain_th_1_minus_chain_a_3))
            .sub_product(t42 * chain_w_2, sin_chain_th_1_minus_chain_a_3) - t95)
            .sub_product(t41 * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3)
            - t96)
            .sub_product(p.chain_l_1 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3)
            .sub_product(p.chain_l_1 * chain_w_3_squared, sin_chain_th_1_minus_chain_a_3)
            - t97 - chain_gravity_times_sin_chain_a_3))
        .sub_product(t3 * t17, chain_w_1_dot)
        .sub_product(t99, chain_w_2_dot)
        .sub_product(t100, chain_w_3_dot);
    let t102 = p.chain_m_3 * (t98 + t16);
    let t103 = (p.chain_m_3
        * (-t95 - t96 - t38 - t97 - chain_gravity_times_sin_chain_a_3))
        .sub_product(t99, chain_w_1_dot)
        .sub_product(t3 * t19, chain_w_2_dot)
        .sub_product(t102, chain_w_3_dot)
        .sub_product(t21, t101);
    let chain_w_3_dot_by_chain_l_3 = (p.chain_m_3 * t39)
        .sub_product(t100, chain_w_1_dot)
        .sub_product(t102, chain_w_2_dot)
        .sub_product(t43, chain_w_3_dot)
        .sub_product(t22, t101)
        .sub_product(t25, t103) * t26;
    let chain_w_2_dot_by_chain_l_3 = (t103 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_l_3);
    let chain_w_1_dot_by_chain_l_3 = (t101 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_l_3)
        .sub_product(t22, chain_w_3_dot_by_chain_l_3);
    let t104 = chain_m_2_times_chain_l_2 * sin_chain_a_2;
    let t105 = chain_m_3_times_chain_l_2 * sin_chain_a_2;
    let t106 = chain_m_3_times_chain_l_3 * sin_chain_a_3;
    let t107 = ((-t104)
        .sub_product(p.chain_m_1, chain_x_1)
        .sub_product(p.chain_m_2, chain_x_1) - t105 - t106)
        .sub_product(p.chain_m_3, chain_x_1);
    let t108 = (-t104 - t105 - t106).sub_product(t21, t107);
    let chain_w_3_dot_by_chain_gravity = (-t106)
        .sub_product(t22, t107)
        .sub_product(t25, t108) * t26;
    let chain_w_2_dot_by_chain_gravity = (t108 * t23)
        .sub_product(t25, chain_w_3_dot_by_chain_gravity);
    let chain_w_1_dot_by_chain_gravity = (t107 * t20)
        .sub_product(t21, chain_w_2_dot_by_chain_gravity)
        .sub_product(t22, chain_w_3_dot_by_chain_gravity);
    [
        chain_w_1_dot_by_chain_m_1,
        chain_w_1_dot_by_chain_m_2,
        chain_w_1_dot_by_chain_m_3,
        chain_w_1_dot_by_chain_l_1,
        chain_w_1_dot_by_chain_l_2,
        chain_w_1_dot_by_chain_l_3,
        chain_w_1_dot_by_chain_gravity,
        chain_w_2_dot_by_chain_m_1,
        chain_w_2_dot_by_chain_m_2,
        chain_w_2_dot_by_chain_m_3,
        chain_w_2_dot_by_chain_l_1,
        chain_w_2_dot_by_chain_l_2,
        chain_w_2_dot_by_chain_l_3,
        chain_w_2_dot_by_chain_gravity,
        chain_w_3_dot_by_chain_m_1,
        chain_w_3_dot_by_chain_m_2,
        chain_w_3_dot_by_chain_m_3,
        chain_w_3_dot_by_chain_l_1,
        chain_w_3_dot_by_chain_l_2,
        chain_w_3_dot_by_chain_l_3,
        chain_w_3_dot_by_chain_gravity,
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
    ]
}

/// Wanted outputs.
///
/// 19 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2),
    (sin_chain_a_3, cos_chain_a_3)] = R::sin_cos_each([
        chain_th_1,
        chain_a_2,
        chain_a_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_y_1 = -(p.chain_l_1 * cos_chain_th_1);
    let chain_x_2 = chain_x_1.add_product(p.chain_l_2, sin_chain_a_2);
    let chain_y_2 = chain_y_1.sub_product(p.chain_l_2, cos_chain_a_2);
    let chain_x_3 = chain_x_2.add_product(p.chain_l_3, sin_chain_a_3);
    let chain_y_3 = chain_y_2.sub_product(p.chain_l_3, cos_chain_a_3);
    Outputs {
        end_x: chain_x_3,
        end_y: chain_y_3,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 52 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2),
    (sin_chain_a_3, cos_chain_a_3)] = R::sin_cos_each([
        chain_th_1,
        chain_a_2,
        chain_a_3,
    ]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_y_1 = -chain_l_1_times_cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_y_2 = chain_y_1.sub_product(p.chain_l_2, cos_chain_a_2);
    let chain_l_2_times_chain_s_2 = p.chain_l_2 * chain_s_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_s_2, cos_chain_a_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_s_2, sin_chain_a_2);
    let chain_y_3 = chain_y_2.sub_product(p.chain_l_3, cos_chain_a_3);
    let chain_l_3_times_chain_s_3 = p.chain_l_3 * chain_s_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_s_3, cos_chain_a_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_s_3, sin_chain_a_3);
    Energy {
        kinetic: (R::literal(0.5) * p.chain_m_1
            * (chain_vx_1 * chain_vx_1).add_product(chain_vy_1, chain_vy_1))
            .add_product(
                R::literal(0.5) * p.chain_m_2,
                (chain_vx_2 * chain_vx_2).add_product(chain_vy_2, chain_vy_2),
            )
            .add_product(
                R::literal(0.5) * p.chain_m_3,
                (chain_vx_3 * chain_vx_3).add_product(chain_vy_3, chain_vy_3),
            ),
        potential: p.chain_gravity
            * (-(p.chain_m_1 * chain_l_1_times_cos_chain_th_1))
                .add_product(p.chain_m_2, chain_y_2)
                .add_product(p.chain_m_3, chain_y_3),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 314 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let chain_th_1_minus_chain_a_2 = chain_th_1 - chain_a_2;
    let chain_th_1_minus_chain_a_3 = chain_th_1 - chain_a_3;
    let chain_a_2_minus_chain_a_3 = chain_a_2 - chain_a_3;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_a_2, cos_chain_a_2),
    (sin_chain_a_3, cos_chain_a_3),
    (sin_chain_th_1_minus_chain_a_2, cos_chain_th_1_minus_chain_a_2),
    (sin_chain_th_1_minus_chain_a_3, cos_chain_th_1_minus_chain_a_3),
    (sin_chain_a_2_minus_chain_a_3, cos_chain_a_2_minus_chain_a_3), (sin_chain_th_2, _),
    (sin_chain_th_2_plus_chain_th_3, _)] = R::sin_cos_each([
        chain_th_1,
        chain_a_2,
        chain_a_3,
        chain_th_1_minus_chain_a_2,
        chain_th_1_minus_chain_a_3,
        chain_a_2_minus_chain_a_3,
        chain_th_2,
        chain_th_2 + chain_th_3,
    ]);
    let chain_s_2 = chain_w_1 + chain_w_2;
    let chain_s_3 = chain_w_3 + chain_s_2;
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_y_1 = -chain_l_1_times_cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_l_2_times_sin_chain_a_2 = p.chain_l_2 * sin_chain_a_2;
    let chain_x_2 = chain_x_1 + chain_l_2_times_sin_chain_a_2;
    let chain_l_2_times_cos_chain_a_2 = p.chain_l_2 * cos_chain_a_2;
    let chain_y_2 = chain_y_1 - chain_l_2_times_cos_chain_a_2;
    let chain_l_2_times_chain_s_2 = p.chain_l_2 * chain_s_2;
    let t0 = chain_l_2_times_chain_s_2 * cos_chain_a_2;
    let chain_vx_2 = chain_vx_1 + t0;
    let t1 = chain_l_2_times_chain_s_2 * sin_chain_a_2;
    let chain_vy_2 = chain_vy_1 + t1;
    let chain_l_3_times_sin_chain_a_3 = p.chain_l_3 * sin_chain_a_3;
    let chain_x_3 = chain_x_2 + chain_l_3_times_sin_chain_a_3;
    let chain_l_3_times_cos_chain_a_3 = p.chain_l_3 * cos_chain_a_3;
    let chain_y_3 = chain_y_2 - chain_l_3_times_cos_chain_a_3;
    let chain_l_3_times_chain_s_3 = p.chain_l_3 * chain_s_3;
    let t2 = chain_l_3_times_chain_s_3 * cos_chain_a_3;
    let chain_vx_3 = chain_vx_2 + t2;
    let t3 = chain_l_3_times_chain_s_3 * sin_chain_a_3;
    let chain_vy_3 = chain_vy_2 + t3;
    let t4 = R::literal(2.0) * p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let t5 = R::literal(2.0) * p.chain_m_3;
    let t6 = t5 * p.chain_l_1;
    let t7 = t6 * p.chain_l_2;
    let t8 = t6 * p.chain_l_3;
    let t9 = t5 * p.chain_l_2 * p.chain_l_3;
    let t10 = t9 * cos_chain_a_2_minus_chain_a_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_2_times_chain_l_2_squared = p.chain_m_2 * chain_l_2_squared;
    let chain_m_3_times_chain_l_2_squared = p.chain_m_3 * chain_l_2_squared;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let t11 = p.chain_m_2 * p.chain_l_1 * p.chain_l_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t12 = chain_m_3_times_chain_l_1 * p.chain_l_2;
    let t13 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t14 = chain_m_2_times_chain_l_2_squared + chain_m_3_times_chain_l_2_squared
        + chain_m_3_times_chain_l_3_squared + t10;
    let t15 = t14
        .add_product(t11, cos_chain_th_1_minus_chain_a_2)
        .add_product(t12, cos_chain_th_1_minus_chain_a_2)
        .add_product(t13, cos_chain_th_1_minus_chain_a_3);
    let t16 = p.chain_l_2 * cos_chain_a_2_minus_chain_a_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t17 = chain_m_3_times_chain_l_3
        * (p.chain_l_3.add_product(p.chain_l_1, cos_chain_th_1_minus_chain_a_3) + t16);
    let t18 = R::literal(1.0)
        / ((((p.chain_m_1 * chain_l_1_squared)
            .add_product(p.chain_m_2, chain_l_1_squared)
            + chain_m_2_times_chain_l_2_squared)
            .add_product(p.chain_m_3, chain_l_1_squared)
            + chain_m_3_times_chain_l_2_squared + chain_m_3_times_chain_l_3_squared)
            .add_product(t4, cos_chain_th_1_minus_chain_a_2)
            .add_product(t7, cos_chain_th_1_minus_chain_a_2)
            .add_product(t8, cos_chain_th_1_minus_chain_a_3) + t10);
    let t19 = t15 * t18;
    let t20 = t17 * t18;
    let t21 = R::literal(1.0) / t14.sub_product(t19, t15);
    let t22 = (chain_m_3_times_chain_l_3 * (p.chain_l_3 + t16)).sub_product(t20, t15);
    let t23 = t22 * t21;
    let t24 = t8 * chain_w_1;
    let t25 = t9 * chain_w_1 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let t26 = t9 * chain_w_2 * chain_w_3 * sin_chain_a_2_minus_chain_a_3;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let t27 = chain_m_2_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t28 = chain_m_3_times_chain_l_2 * p.chain_l_3 * chain_w_3_squared
        * sin_chain_a_2_minus_chain_a_3;
    let t29 = chain_m_3_times_chain_l_2 * p.chain_gravity * sin_chain_a_2;
    let t30 = chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_a_3;
    let t31 = ((((-(t7 * chain_w_1 * chain_w_2 * sin_chain_th_1_minus_chain_a_2))
        .sub_product(t4 * chain_w_1 * chain_w_2, sin_chain_th_1_minus_chain_a_2)
        .sub_product(t24 * chain_w_2, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t24 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t25)
        .sub_product(t8 * chain_w_2 * chain_w_3, sin_chain_th_1_minus_chain_a_3) - t26)
        .sub_product(p.chain_m_1 * p.chain_gravity, chain_x_1)
        .sub_product(t11 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2) - t27)
        .sub_product(p.chain_m_2 * p.chain_gravity, chain_x_1)
        .sub_product(t12 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_2);
    let t32 = (t31
        .sub_product(t13 * chain_w_2_squared, sin_chain_th_1_minus_chain_a_3)
        .sub_product(t13 * chain_w_3_squared, sin_chain_th_1_minus_chain_a_3) - t28 - t29
        - t30)
        .sub_product(p.chain_m_3 * p.chain_gravity, chain_x_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t33 = R::literal(2.0) * p.chain_l_2;
    let t34 = (((-t25 - t26).sub_product(t11 * chain_w_1_squared, sin_chain_th_2) - t27)
        .sub_product(t12 * chain_w_1_squared, sin_chain_th_2)
        .sub_product(t13 * chain_w_1_squared, sin_chain_th_2_plus_chain_th_3) - t28 - t29
        - t30)
        .sub_product(t19, t32);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3
        * (-(p.chain_l_1 * chain_w_1_squared * sin_chain_th_2_plus_chain_th_3))
            .add_product(t33 * chain_w_1 * chain_w_2, sin_chain_a_2_minus_chain_a_3)
            .add_product(p.chain_l_2 * chain_w_1_squared, sin_chain_a_2_minus_chain_a_3)
            .add_product(p.chain_l_2 * chain_w_2_squared, sin_chain_a_2_minus_chain_a_3)
            .sub_product(p.chain_gravity, sin_chain_a_3))
        .sub_product(t20, t32)
        .sub_product(t23, t34)
        * (R::literal(1.0)
            / chain_m_3_times_chain_l_3_squared
                .sub_product(t20, t17)
                .sub_product(t23, t22));
    let chain_w_2_dot = (t34 * t21).sub_product(t23, chain_w_3_dot);
    let chain_w_1_dot = (t32 * t18)
        .sub_product(t19, chain_w_2_dot)
        .sub_product(t20, chain_w_3_dot);
    let t35 = R::literal(2.0) * p.chain_l_3;
    let t36 = R::literal(0.5) * p.chain_m_2;
    let t37 = R::literal(0.5) * p.chain_m_3;
    let t38 = R::literal(2.0) * chain_vx_3;
    let t39 = t33 * chain_s_2;
    let t40 = R::literal(2.0) * chain_vy_3;
    let t41 = chain_l_2_times_sin_chain_a_2 + chain_l_3_times_sin_chain_a_3;
    let t42 = (p.chain_gravity
        * (p.chain_m_1 * chain_x_1)
            .add_product(p.chain_m_2, chain_x_2)
            .add_product(p.chain_m_3, chain_x_3) * chain_w_1)
        .add_product(
            (t36
                * (t39 * chain_vy_2 * cos_chain_a_2)
                    .sub_product(t39 * chain_vx_2, sin_chain_a_2))
                .add_product(t37, (t38 * (-t1 - t3)).add_product(t40, t0 + t2))
                .add_product(
                    p.chain_gravity,
                    (chain_m_2_times_chain_l_2 * sin_chain_a_2)
                        .add_product(p.chain_m_3, t41),
                ),
            chain_w_2,
        );
    let t43 = t35 * chain_s_3;
    let t44 = t42
        .add_product(
            t30
                .add_product(
                    t37,
                    (t43 * chain_vy_3 * cos_chain_a_3)
                        .sub_product(t43 * chain_vx_3, sin_chain_a_3),
                ),
            chain_w_3,
        )
        .add_product(
            (R::literal(0.5) * p.chain_m_1
                * (R::literal(2.0) * chain_x_1 * chain_vy_1)
                    .add_product(
                        R::literal(2.0) * chain_l_1_times_cos_chain_th_1,
                        chain_vx_1,
                    ))
                .add_product(
                    t36,
                    (R::literal(2.0) * chain_x_2 * chain_vy_2)
                        .sub_product(R::literal(2.0) * chain_y_2, chain_vx_2),
                )
                .add_product(
                    t37,
                    (R::literal(2.0) * chain_x_3 * chain_vy_3)
                        .sub_product(R::literal(2.0) * chain_y_3, chain_vx_3),
                ),
            chain_w_1_dot,
        );
    PowerBalance {
        stored_rate: t44
            .add_product(
                (t36
                    * (t33 * chain_vx_2 * cos_chain_a_2)
                        .add_product(t33 * chain_vy_2, sin_chain_a_2))
                    .add_product(
                        t37,
                        (t38
                            * (chain_l_2_times_cos_chain_a_2
                                + chain_l_3_times_cos_chain_a_3))
                            .add_product(t40, t41),
                    ),
                chain_w_2_dot,
            )
            .add_product(
                t37
                    * (t35 * chain_vx_3 * cos_chain_a_3)
                        .add_product(t35 * chain_vy_3, sin_chain_a_3),
                chain_w_3_dot,
            ),
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 208 recurrences. 54 sums of products an order.
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
    let (mut lanes, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_1, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_2, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_3, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_4, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_5, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_6, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_7, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_8, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_9, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_10, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_11, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_12, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_13, _) = Lanes::<R, 2>::new(workspace, coefficients.len());
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_a_2 = chain_th_1 + chain_th_2;
    let chain_a_3 = chain_th_3 + chain_a_2;
    let t0 = chain_th_1 - chain_a_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = R::literal(2.0) * p.chain_m_2;
    let t4 = t3 * p.chain_l_1;
    let t5 = t4 * p.chain_l_2;
    let t6 = t2 * t5;
    let t7 = R::literal(2.0) * p.chain_m_3;
    let t8 = t7 * p.chain_l_1;
    let t9 = t8 * p.chain_l_2;
    let t10 = t2 * t9;
    let t11 = chain_th_1 - chain_a_3;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = t8 * p.chain_l_3;
    let t15 = t13 * t14;
    let t16 = chain_a_2 - chain_a_3;
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t7 * p.chain_l_2;
    let t20 = t19 * p.chain_l_3;
    let t21 = t18 * t20;
    let t22 = p.chain_l_1 * p.chain_l_1;
    let t23 = p.chain_m_1 * t22;
    let t24 = p.chain_m_2 * t22;
    let t25 = p.chain_l_2 * p.chain_l_2;
    let t26 = p.chain_m_2 * t25;
    let t27 = p.chain_m_3 * t22;
    let t28 = p.chain_m_3 * t25;
    let t29 = p.chain_l_3 * p.chain_l_3;
    let t30 = p.chain_m_3 * t29;
    let t31 = t23 + t24;
    let t32 = t31 + t26;
    let t33 = t32 + t27;
    let t34 = t33 + t28;
    let t35 = t34 + t30;
    let t36 = t35 + t6;
    let t37 = t36 + t10;
    let t38 = t37 + t15;
    let t39 = t38 + t21;
    let t40 = p.chain_m_2 * p.chain_l_1;
    let t41 = t40 * p.chain_l_2;
    let t42 = t2 * t41;
    let t43 = p.chain_m_3 * p.chain_l_1;
    let t44 = t43 * p.chain_l_2;
    let t45 = t2 * t44;
    let t46 = t43 * p.chain_l_3;
    let t47 = t13 * t46;
    let t48 = t26 + t28;
    let t49 = t48 + t30;
    let t50 = t49 + t21;
    let t51 = t50 + t42;
    let t52 = t51 + t45;
    let t53 = t52 + t47;
    let t54 = t13 * p.chain_l_1;
    let t55 = t18 * p.chain_l_2;
    let t56 = p.chain_l_3 + t54;
    let t57 = t56 + t55;
    let t58 = p.chain_m_3 * p.chain_l_3;
    let t59 = t57 * t58;
    let t60 = p.chain_l_3 + t55;
    let t61 = t60 * t58;
    let sin_chain_th_1 = chain_th_1.sin();
    let cos_chain_th_1 = chain_th_1.cos();
    let sin_chain_a_2 = chain_a_2.sin();
    let cos_chain_a_2 = chain_a_2.cos();
    let sin_chain_a_3 = chain_a_3.sin();
    let cos_chain_a_3 = chain_a_3.cos();
    let t62 = chain_w_1 * t5;
    let t63 = t62 * chain_w_2;
    let t64 = t63 * t1;
    let t65 = chain_w_1 * t9;
    let t66 = t65 * chain_w_2;
    let t67 = t66 * t1;
    let t68 = chain_w_1 * t14;
    let t69 = t68 * chain_w_2;
    let t70 = t69 * t12;
    let t71 = t68 * chain_w_3;
    let t72 = t71 * t12;
    let t73 = chain_w_1 * t20;
    let t74 = t73 * chain_w_3;
    let t75 = t74 * t17;
    let t76 = chain_w_2 * t14;
    let t77 = t76 * chain_w_3;
    let t78 = t77 * t12;
    let t79 = chain_w_2 * t20;
    let t80 = t79 * chain_w_3;
    let t81 = t80 * t17;
    let t82 = p.chain_m_1 * p.chain_gravity;
    let t83 = p.chain_l_1 * t82;
    let t84 = sin_chain_th_1 * t83;
    let t85 = chain_w_2 * chain_w_2;
    let t86 = t85 * t41;
    let t87 = t86 * t1;
    let t88 = p.chain_m_2 * p.chain_l_2;
    let t89 = t88 * p.chain_gravity;
    let t90 = sin_chain_a_2 * t89;
    let t91 = p.chain_m_2 * p.chain_gravity;
    let t92 = p.chain_l_1 * t91;
    let t93 = sin_chain_th_1 * t92;
    let t94 = t85 * t44;
    let t95 = t94 * t1;
    let t96 = t85 * t46;
    let t97 = t96 * t12;
    let t98 = chain_w_3 * chain_w_3;
    let t99 = t98 * t46;
    let t100 = t99 * t12;
    let t101 = p.chain_m_3 * p.chain_l_2;
    let t102 = t101 * p.chain_l_3;
    let t103 = t98 * t102;
    let t104 = t103 * t17;
    let t105 = t101 * p.chain_gravity;
    let t106 = sin_chain_a_2 * t105;
    let t107 = t58 * p.chain_gravity;
    let t108 = sin_chain_a_3 * t107;
    let t109 = p.chain_m_3 * p.chain_gravity;
    let t110 = p.chain_l_1 * t109;
    let t111 = sin_chain_th_1 * t110;
    let t112 = -t64;
    let t113 = t112 - t67;
    let t114 = t113 - t70;
    let t115 = t114 - t72;
    let t116 = t115 - t75;
    let t117 = t116 - t78;
    let t118 = t117 - t81;
    let t119 = t118 - t84;
    let t120 = t119 - t87;
    let t121 = t120 - t90;
    let t122 = t121 - t93;
    let t123 = t122 - t95;
    let t124 = t123 - t97;
    let t125 = t124 - t100;
    let t126 = t125 - t104;
    let t127 = t126 - t106;
    let t128 = t127 - t108;
    let t129 = t128 - t111;
    let t130 = chain_w_1 * chain_w_1;
    let sin_chain_th_2 = chain_th_2.sin();
    let cos_chain_th_2 = chain_th_2.cos();
    let t131 = t130 * t41;
    let t132 = t131 * sin_chain_th_2;
    let t133 = t130 * t44;
    let t134 = t133 * sin_chain_th_2;
    let t135 = chain_th_2 + chain_th_3;
    let t136 = t135.sin();
    let t137 = t135.cos();
    let t138 = t130 * t46;
    let t139 = t138 * t136;
    let t140 = -t75;
    let t141 = t140 - t81;
    let t142 = t141 - t132;
    let t143 = t142 - t90;
    let t144 = t143 - t134;
    let t145 = t144 - t139;
    let t146 = t145 - t104;
    let t147 = t146 - t106;
    let t148 = t147 - t108;
    let t149 = R::literal(2.0) * p.chain_l_2;
    let t150 = chain_w_1 * t149;
    let t151 = t150 * chain_w_2;
    let t152 = t151 * t17;
    let t153 = t130 * p.chain_l_1;
    let t154 = t153 * t136;
    let t155 = t130 * p.chain_l_2;
    let t156 = t155 * t17;
    let t157 = t85 * p.chain_l_2;
    let t158 = t157 * t17;
    let t159 = sin_chain_a_3 * p.chain_gravity;
    let t160 = t152 - t154;
    let t161 = t160 + t156;
    let t162 = t161 + t158;
    let t163 = t162 - t159;
    let t164 = t163 * t58;
    let factored = Factored::new([
        [t39, R::literal(0.0), R::literal(0.0)],
        [t53, t50, R::literal(0.0)],
        [t59, t61, t30],
    ]);
    let [chain_w_1_dot, chain_w_2_dot, chain_w_3_dot] = factored
        .solve([t129, t148, t164]);
    let mut rates = [
        chain_w_1,
        chain_w_2,
        chain_w_3,
        chain_w_1_dot,
        chain_w_2_dot,
        chain_w_3_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_th_1_k, chain_th_2_k, chain_th_3_k, chain_w_1_k, chain_w_2_k,
        chain_w_3_k] = *state_k;
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
        let chain_a_2_k = chain_th_1_k + chain_th_2_k;
        let chain_a_3_k = chain_th_3_k + chain_a_2_k;
        let t0_k = chain_th_1_k - chain_a_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_5[3]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_6[0]);
        let t11_k = chain_th_1_k - chain_a_3_k;
        let t12_k = t11_k.mul_add(t13, inverse * sums_7[3]);
        let t13_k = -t11_k.mul_add(t12, inverse * sums_8[0]);
        let t16_k = chain_a_2_k - chain_a_3_k;
        let t17_k = t16_k.mul_add(t18, inverse * sums_8[1]);
        let t18_k = -t16_k.mul_add(t17, inverse * sums_8[2]);
        let t21_k = t18_k * t20;
        let t37_k = t2_k.mul_add(t9, t2_k * t5);
        let t38_k = t13_k.mul_add(t14, t37_k);
        let t39_k = t38_k + t21_k;
        let t51_k = t2_k.mul_add(t41, t21_k);
        let t52_k = t2_k.mul_add(t44, t51_k);
        let t53_k = t13_k.mul_add(t46, t52_k);
        let t55_k = t18_k * p.chain_l_2;
        let t57_k = t13_k * p.chain_l_1 + t55_k;
        let t59_k = t57_k * t58;
        let t61_k = t55_k * t58;
        let sin_chain_th_1_k = chain_th_1_k.mul_add(cos_chain_th_1, inverse * sums[3]);
        let cos_chain_th_1_k = -chain_th_1_k
            .mul_add(sin_chain_th_1, inverse * sums_1[0]);
        let sin_chain_a_2_k = chain_a_2_k.mul_add(cos_chain_a_2, inverse * sums_3[3]);
        let cos_chain_a_2_k = -chain_a_2_k.mul_add(sin_chain_a_2, inverse * sums_4[0]);
        let sin_chain_a_3_k = chain_a_3_k.mul_add(cos_chain_a_3, inverse * sums_6[1]);
        let cos_chain_a_3_k = -chain_a_3_k.mul_add(sin_chain_a_3, inverse * sums_6[2]);
        let t62_k = chain_w_1_k * t5;
        let t63_k = chain_w_2.mul_add(t62_k, t62.mul_add(chain_w_2_k, sums_1[1]));
        let t64_k = t63.mul_add(t1_k, t1.mul_add(t63_k, sums_6[3]));
        let t65_k = chain_w_1_k * t9;
        let t66_k = chain_w_2.mul_add(t65_k, t65.mul_add(chain_w_2_k, sums_1[2]));
        let t67_k = t66.mul_add(t1_k, t1.mul_add(t66_k, sums_7[0]));
        let t68_k = chain_w_1_k * t14;
        let t69_k = chain_w_2.mul_add(t68_k, t68.mul_add(chain_w_2_k, sums_1[3]));
        let t70_k = t69.mul_add(t12_k, t12.mul_add(t69_k, sums_8[3]));
        let t71_k = chain_w_3.mul_add(t68_k, t68.mul_add(chain_w_3_k, sums_2[0]));
        let t72_k = t71.mul_add(t12_k, t12.mul_add(t71_k, sums_9[0]));
        let t73_k = chain_w_1_k * t20;
        let t74_k = chain_w_3.mul_add(t73_k, t73.mul_add(chain_w_3_k, sums_2[1]));
        let t75_k = t74.mul_add(t17_k, t17.mul_add(t74_k, sums_9[1]));
        let t76_k = chain_w_2_k * t14;
        let t77_k = chain_w_3.mul_add(t76_k, t76.mul_add(chain_w_3_k, sums_2[2]));
        let t78_k = t77.mul_add(t12_k, t12.mul_add(t77_k, sums_9[2]));
        let t79_k = chain_w_2_k * t20;
        let t80_k = chain_w_3.mul_add(t79_k, t79.mul_add(chain_w_3_k, sums_2[3]));
        let t81_k = t80.mul_add(t17_k, t17.mul_add(t80_k, sums_9[3]));
        let t85_k = (chain_w_2 + chain_w_2).mul_add(chain_w_2_k, sums[0]);
        let t86_k = t85_k * t41;
        let t87_k = t86.mul_add(t1_k, t1.mul_add(t86_k, sums_7[1]));
        let t90_k = sin_chain_a_2_k * t89;
        let t94_k = t85_k * t44;
        let t95_k = t94.mul_add(t1_k, t1.mul_add(t94_k, sums_7[2]));
        let t96_k = t85_k * t46;
        let t97_k = t96.mul_add(t12_k, t12.mul_add(t96_k, sums_10[0]));
        let t98_k = (chain_w_3 + chain_w_3).mul_add(chain_w_3_k, sums[1]);
        let t99_k = t98_k * t46;
        let t100_k = t99.mul_add(t12_k, t12.mul_add(t99_k, sums_10[1]));
        let t103_k = t98_k * t102;
        let t104_k = t103.mul_add(t17_k, t17.mul_add(t103_k, sums_10[2]));
        let t106_k = sin_chain_a_2_k * t105;
        let t108_k = sin_chain_a_3_k * t107;
        let t112_k = -t64_k;
        let t113_k = t112_k - t67_k;
        let t114_k = t113_k - t70_k;
        let t115_k = t114_k - t72_k;
        let t116_k = t115_k - t75_k;
        let t117_k = t116_k - t78_k;
        let t118_k = t117_k - t81_k;
        let t119_k = (-sin_chain_th_1_k).mul_add(t83, t118_k);
        let t120_k = t119_k - t87_k;
        let t121_k = t120_k - t90_k;
        let t122_k = (-sin_chain_th_1_k).mul_add(t92, t121_k);
        let t123_k = t122_k - t95_k;
        let t124_k = t123_k - t97_k;
        let t125_k = t124_k - t100_k;
        let t126_k = t125_k - t104_k;
        let t127_k = t126_k - t106_k;
        let t128_k = t127_k - t108_k;
        let t129_k = (-sin_chain_th_1_k).mul_add(t110, t128_k);
        let t130_k = (chain_w_1 + chain_w_1).mul_add(chain_w_1_k, sums[2]);
        let sin_chain_th_2_k = chain_th_2_k.mul_add(cos_chain_th_2, inverse * sums_3[0]);
        let cos_chain_th_2_k = -chain_th_2_k
            .mul_add(sin_chain_th_2, inverse * sums_3[1]);
        let t131_k = t130_k * t41;
        let t132_k = sin_chain_th_2
            .mul_add(t131_k, t131.mul_add(sin_chain_th_2_k, sums_4[1]));
        let t133_k = t130_k * t44;
        let t134_k = sin_chain_th_2
            .mul_add(t133_k, t133.mul_add(sin_chain_th_2_k, sums_4[2]));
        let t135_k = chain_th_2_k + chain_th_3_k;
        let t136_k = t135_k.mul_add(t137, inverse * sums_4[3]);
        let t137_k = -t135_k.mul_add(t136, inverse * sums_5[0]);
        let t138_k = t130_k * t46;
        let t139_k = t138.mul_add(t136_k, t136.mul_add(t138_k, sums_5[1]));
        let t140_k = -t75_k;
        let t141_k = t140_k - t81_k;
        let t142_k = t141_k - t132_k;
        let t143_k = t142_k - t90_k;
        let t144_k = t143_k - t134_k;
        let t145_k = t144_k - t139_k;
        let t146_k = t145_k - t104_k;
        let t147_k = t146_k - t106_k;
        let t148_k = t147_k - t108_k;
        let t150_k = chain_w_1_k * t149;
        let t151_k = chain_w_2.mul_add(t150_k, t150.mul_add(chain_w_2_k, sums_3[2]));
        let t152_k = t151.mul_add(t17_k, t17.mul_add(t151_k, sums_10[3]));
        let t153_k = t130_k * p.chain_l_1;
        let t154_k = t153.mul_add(t136_k, t136.mul_add(t153_k, sums_5[2]));
        let t155_k = t130_k * p.chain_l_2;
        let t156_k = t155.mul_add(t17_k, t17.mul_add(t155_k, sums_11[0]));
        let t157_k = t85_k * p.chain_l_2;
        let t158_k = t157.mul_add(t17_k, t17.mul_add(t157_k, sums_11[1]));
        let t160_k = t152_k - t154_k;
        let t161_k = t160_k + t156_k;
        let t162_k = t161_k + t158_k;
        let t163_k = (-sin_chain_a_3_k).mul_add(p.chain_gravity, t162_k);
        let n192_k = t39_k.mul_add(chain_w_1_dot, sums_11[2]);
        let n193_k = t53_k.mul_add(chain_w_2_dot, sums_11[3]);
        let n194_k = t59_k.mul_add(chain_w_3_dot, sums_12[0]);
        let n195_k = t53_k.mul_add(chain_w_1_dot, sums_12[1]);
        let n196_k = t21_k.mul_add(chain_w_2_dot, sums_12[2]);
        let n197_k = t61_k.mul_add(chain_w_3_dot, sums_12[3]);
        let n198_k = t59_k.mul_add(chain_w_1_dot, sums_13[0]);
        let n199_k = t61_k.mul_add(chain_w_2_dot, sums_13[1]);
        let n200_k = n193_k + n194_k;
        let n201_k = n192_k + n200_k;
        let t129_k_2 = t129_k - n201_k;
        let n203_k = n196_k + n197_k;
        let n204_k = n195_k + n203_k;
        let t148_k_2 = t148_k - n204_k;
        let n206_k = n198_k + n199_k;
        let t164_k = t163_k.mul_add(t58, -n206_k);
        let [chain_w_1_dot_k, chain_w_2_dot_k, chain_w_3_dot_k] = factored
            .solve([t129_k_2, t148_k_2, t164_k]);
        lanes
            .set(
                order,
                [chain_w_2_k, chain_w_3_k, chain_w_1_k, k * chain_th_1_k],
                [chain_w_2_k, chain_w_3_k, chain_w_1_k, cos_chain_th_1_k],
            );
        lanes_1
            .set(
                order,
                [k * chain_th_1_k, chain_w_2_k, chain_w_2_k, chain_w_2_k],
                [sin_chain_th_1_k, t62_k, t65_k, t68_k],
            );
        lanes_2
            .set(
                order,
                [chain_w_3_k, chain_w_3_k, chain_w_3_k, chain_w_3_k],
                [t68_k, t73_k, t76_k, t79_k],
            );
        lanes_3
            .set(
                order,
                [k * chain_th_2_k, k * chain_th_2_k, chain_w_2_k, k * chain_a_2_k],
                [cos_chain_th_2_k, sin_chain_th_2_k, t150_k, cos_chain_a_2_k],
            );
        lanes_4
            .set(
                order,
                [k * chain_a_2_k, sin_chain_th_2_k, sin_chain_th_2_k, k * t135_k],
                [sin_chain_a_2_k, t131_k, t133_k, t137_k],
            );
        lanes_5
            .set(
                order,
                [k * t135_k, t136_k, t136_k, k * t0_k],
                [t136_k, t138_k, t153_k, t2_k],
            );
        lanes_6
            .set(
                order,
                [k * t0_k, k * chain_a_3_k, k * chain_a_3_k, t1_k],
                [t1_k, cos_chain_a_3_k, sin_chain_a_3_k, t63_k],
            );
        lanes_7.set(order, [t1_k, t1_k, t1_k, k * t11_k], [t66_k, t86_k, t94_k, t13_k]);
        lanes_8
            .set(
                order,
                [k * t11_k, k * t16_k, k * t16_k, t12_k],
                [t12_k, t18_k, t17_k, t69_k],
            );
        lanes_9.set(order, [t12_k, t17_k, t12_k, t17_k], [t71_k, t74_k, t77_k, t80_k]);
        lanes_10
            .set(order, [t12_k, t12_k, t17_k, t17_k], [t96_k, t99_k, t103_k, t151_k]);
        lanes_11
            .set(
                order,
                [t17_k, t17_k, t39_k, t53_k],
                [t155_k, t157_k, chain_w_1_dot_k, chain_w_2_dot_k],
            );
        lanes_12
            .set(
                order,
                [t59_k, t53_k, t21_k, t61_k],
                [chain_w_3_dot_k, chain_w_1_dot_k, chain_w_2_dot_k, chain_w_3_dot_k],
            );
        lanes_13.set(order, [t59_k, t61_k], [chain_w_1_dot_k, chain_w_2_dot_k]);
        rates = [
            chain_w_1_k,
            chain_w_2_k,
            chain_w_3_k,
            chain_w_1_dot_k,
            chain_w_2_dot_k,
            chain_w_3_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for PendulumRelative {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 2>::workspace(order + 1)
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

impl Describe for PendulumRelative {
    fn name(&self) -> &'static str {
        "pendulum_relative"
    }
    fn title(&self) -> &'static str {
        "Chain of three pendulums, by relative angles"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 3,
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
}

impl<R: Real> Simulator<R> for PendulumRelative {
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
    fn taylor(&self) -> Option<&dyn TaylorSeries<R>> {
        Some(self)
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
        name: "chain.th_1",
        unit: "rad",
        doc: "angle of the first link",
    },
    Quantity {
        name: "chain.th_2",
        unit: "rad",
        doc: "angle of the second link from the one above",
    },
    Quantity {
        name: "chain.th_3",
        unit: "rad",
        doc: "angle of the third link from the one above",
    },
    Quantity {
        name: "chain.w_1",
        unit: "rad/s",
        doc: "rate of angle of the first link",
    },
    Quantity {
        name: "chain.w_2",
        unit: "rad/s",
        doc: "rate of angle of the second link from the one above",
    },
    Quantity {
        name: "chain.w_3",
        unit: "rad/s",
        doc: "rate of angle of the third link from the one above",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 1.0, 5.0, 5.0, 5.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "chain.m_1",
        unit: "kg",
        doc: "mass at the end of the first link",
    },
    Quantity {
        name: "chain.m_2",
        unit: "kg",
        doc: "mass at the end of the second link",
    },
    Quantity {
        name: "chain.m_3",
        unit: "kg",
        doc: "mass at the end of the third link",
    },
    Quantity {
        name: "chain.l_1",
        unit: "m",
        doc: "length of the first link",
    },
    Quantity {
        name: "chain.l_2",
        unit: "m",
        doc: "length of the second link",
    },
    Quantity {
        name: "chain.l_3",
        unit: "m",
        doc: "length of the third link",
    },
    Quantity {
        name: "chain.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [1.0, 0.8, 0.5, 1.0, 0.7, 0.4, 9.81];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "end_x",
        unit: "m",
        doc: "third mass, sideways",
    },
    Quantity {
        name: "end_y",
        unit: "m",
        doc: "third mass, upwards",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 1001,
    rtol: 1e-8,
    method: "tsit45",
};

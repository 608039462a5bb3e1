// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   c02cb12d2b09b1ef614d114dc34181b68d27d0240de63b453c85dcf0f0091503  scenes/pendulum_chain.toml
//   0cffc4a4ddaf5edfd00f248740ed9408fe25ba00e6486e49d46fc843757b7a78  units/three_pendulums.toml
//
// Chain of three pendulums
//
// Let go from one side; nothing drives or brakes it, so that its energy stays.
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
//     1  chain.th_2  [rad]    angle of the second link
//     2  chain.th_3  [rad]    angle of the third link
//     3  chain.w_1   [rad/s]  rate of angle of the first link
//     4  chain.w_2   [rad/s]  rate of angle of the second link
//     5  chain.w_3   [rad/s]  rate of angle of the third link
//
// Nonzeros:
//   mass_matrix               9 of 3 by 3
//   rate_jacobian            21 of 6 by 6
//   parameter_jacobian       21 of 6 by 7
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    116
//   mass_matrix              24
//   forcing                  56
//   rate_jacobian           284
//   parameter_jacobian      328
//   time_derivative           0
//   outputs                  17
//   energy                   48
//   power_balance           220
// With constants of the parameters, prepared once a run:
//   prepare                  30
//   prepared_rate            94
//   prepared_rate_jacobian  254

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

/// Chain of three pendulums
///
/// Let go from one side; nothing drives or brakes it, so that its energy stays.
///
/// Source: Textbook.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PendulumChain;

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
    /// chain.th_2: angle of the second link \[rad\].
    pub const CHAIN_TH_2: usize = 1;
    /// chain.th_3: angle of the third link \[rad\].
    pub const CHAIN_TH_3: usize = 2;
    /// chain.w_1: rate of angle of the first link \[rad/s\].
    pub const CHAIN_W_1: usize = 3;
    /// chain.w_2: rate of angle of the second link \[rad/s\].
    pub const CHAIN_W_2: usize = 4;
    /// chain.w_3: rate of angle of the third link \[rad/s\].
    pub const CHAIN_W_3: usize = 5;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 17;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub t0: R,
    pub chain_m_3_times_chain_l_1: R,
    pub t1: R,
    pub t2: R,
    pub chain_m_3_times_chain_l_2: R,
    pub t3: R,
    pub chain_m_3_times_chain_l_3_squared: R,
    pub t4: R,
    pub chain_m_1_times_chain_gravity: R,
    pub chain_m_2_times_chain_l_2: R,
    pub chain_m_2_times_chain_gravity: R,
    pub chain_m_3_times_chain_l_3: R,
    pub chain_m_3_times_chain_gravity: R,
    pub chain_m_2_times_chain_l_1: R,
    pub t5: R,
    pub t7: R,
    pub t8: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            t0: values[0],
            chain_m_3_times_chain_l_1: values[1],
            t1: values[2],
            t2: values[3],
            chain_m_3_times_chain_l_2: values[4],
            t3: values[5],
            chain_m_3_times_chain_l_3_squared: values[6],
            t4: values[7],
            chain_m_1_times_chain_gravity: values[8],
            chain_m_2_times_chain_l_2: values[9],
            chain_m_2_times_chain_gravity: values[10],
            chain_m_3_times_chain_l_3: values[11],
            chain_m_3_times_chain_gravity: values[12],
            chain_m_2_times_chain_l_1: values[13],
            t5: values[14],
            t7: values[15],
            t8: values[16],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.t0,
            self.chain_m_3_times_chain_l_1,
            self.t1,
            self.t2,
            self.chain_m_3_times_chain_l_2,
            self.t3,
            self.chain_m_3_times_chain_l_3_squared,
            self.t4,
            self.chain_m_1_times_chain_gravity,
            self.chain_m_2_times_chain_l_2,
            self.chain_m_2_times_chain_gravity,
            self.chain_m_3_times_chain_l_3,
            self.chain_m_3_times_chain_gravity,
            self.chain_m_2_times_chain_l_1,
            self.t5,
            self.t7,
            self.t8,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 30 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let t0 = p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t1 = chain_m_3_times_chain_l_1 * p.chain_l_3;
    let t2 = chain_m_2_plus_chain_m_3 * (p.chain_l_2 * p.chain_l_2);
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t3 = chain_m_3_times_chain_l_2 * p.chain_l_3;
    let chain_m_3_times_chain_l_3_squared = p.chain_m_3 * (p.chain_l_3 * p.chain_l_3);
    let t4 = R::literal(1.0)
        / ((p.chain_m_1 + p.chain_m_2 + p.chain_m_3) * (p.chain_l_1 * p.chain_l_1));
    let chain_m_1_times_chain_gravity = p.chain_m_1 * p.chain_gravity;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let chain_m_2_times_chain_l_1 = p.chain_m_2 * p.chain_l_1;
    let t5 = R::literal(2.0) * p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let t6 = R::literal(2.0) * p.chain_m_3;
    let t7 = t6 * p.chain_l_1 * p.chain_l_3;
    let t8 = t6 * p.chain_l_2 * p.chain_l_3;
    Constants {
        t0,
        chain_m_3_times_chain_l_1,
        t1,
        t2,
        chain_m_3_times_chain_l_2,
        t3,
        chain_m_3_times_chain_l_3_squared,
        t4,
        chain_m_1_times_chain_gravity,
        chain_m_2_times_chain_l_2,
        chain_m_2_times_chain_gravity,
        chain_m_3_times_chain_l_3,
        chain_m_3_times_chain_gravity,
        chain_m_2_times_chain_l_1,
        t5,
        t7,
        t8,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(0.9),
        R::literal(1.1),
        R::literal(1.4),
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
/// 116 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 94 operations.
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
    let t0 = (sin_chain_th_1 * cos_chain_th_2)
        .sub_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = c.t0
        * (cos_chain_th_1 * cos_chain_th_2).add_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = (sin_chain_th_1 * cos_chain_th_3)
        .sub_product(cos_chain_th_1, sin_chain_th_3);
    let t3 = c.t1
        * (cos_chain_th_1 * cos_chain_th_3).add_product(sin_chain_th_1, sin_chain_th_3);
    let t4 = (sin_chain_th_2 * cos_chain_th_3)
        .sub_product(cos_chain_th_2, sin_chain_th_3);
    let t5 = t1 * c.t4;
    let t6 = t3 * c.t4;
    let t7 = R::literal(1.0) / c.t2.sub_product(t5, t1);
    let t8 = (c.t3
        * (cos_chain_th_2 * cos_chain_th_3).add_product(sin_chain_th_2, sin_chain_th_3))
        .sub_product(t6, t1);
    let t9 = t8 * t7;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t10 = c.chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let t11 = p.chain_l_1
        * (c.chain_m_1_times_chain_gravity * sin_chain_th_1)
            .add_product(c.chain_m_2_times_chain_l_2 * chain_w_2_squared, t0)
            .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1)
            .add_product(c.chain_m_3_times_chain_l_2 * chain_w_2_squared, t0)
            .add_product(t10, t2)
            .add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t12 = (p.chain_l_2
        * (c.chain_m_2_times_chain_l_1 * chain_w_1_squared * t0)
            .add_product(c.chain_m_3_times_chain_l_1 * chain_w_1_squared, t0)
            .sub_product(c.chain_m_2_times_chain_gravity, sin_chain_th_2)
            .sub_product(t10, t4)
            .sub_product(c.chain_m_3_times_chain_gravity, sin_chain_th_2))
        .add_product(t5, t11);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3
        * (p.chain_l_1 * chain_w_1_squared * t2)
            .add_product(p.chain_l_2 * chain_w_2_squared, t4)
            .sub_product(p.chain_gravity, sin_chain_th_3))
        .add_product(t6, t11)
        .sub_product(t9, t12)
        * (R::literal(1.0)
            / c
                .chain_m_3_times_chain_l_3_squared
                .sub_product(t6, t3)
                .sub_product(t9, t8));
    let chain_w_2_dot = (t12 * t7).sub_product(t9, chain_w_3_dot);
    let chain_w_1_dot = (-(t11 * c.t4))
        .sub_product(t5, chain_w_2_dot)
        .sub_product(t6, chain_w_3_dot);
    [chain_w_1, chain_w_2, chain_w_3, chain_w_1_dot, chain_w_2_dot, chain_w_3_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 24 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; 9] {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let [(_, cos_chain_th_1_minus_chain_th_2), (_, cos_chain_th_1_minus_chain_th_3),
    (_, cos_chain_th_2_minus_chain_th_3)] = R::sin_cos_each([
        chain_th_1 - chain_th_2,
        chain_th_1 - chain_th_3,
        chain_th_2 - chain_th_3,
    ]);
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let t0 = p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3
        * cos_chain_th_1_minus_chain_th_2;
    let t1 = p.chain_m_3 * p.chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let t2 = p.chain_m_3 * p.chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3;
    [
        (p.chain_m_1 + p.chain_m_2 + p.chain_m_3) * (p.chain_l_1 * p.chain_l_1),
        t0,
        t1,
        t0,
        chain_m_2_plus_chain_m_3 * (p.chain_l_2 * p.chain_l_2),
        t2,
        t1,
        t2,
        p.chain_m_3 * (p.chain_l_3 * p.chain_l_3),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 56 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, _), (sin_chain_th_2, _), (sin_chain_th_3, _),
    (sin_chain_th_1_minus_chain_th_2, _), (sin_chain_th_1_minus_chain_th_3, _),
    (sin_chain_th_2_minus_chain_th_3, _)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
        chain_th_1 - chain_th_2,
        chain_th_1 - chain_th_3,
        chain_th_2 - chain_th_3,
    ]);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t0 = chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let chain_th_1_forcing = -(p.chain_l_1
        * (p.chain_m_1 * p.chain_gravity * sin_chain_th_1)
            .add_product(
                p.chain_m_2 * p.chain_l_2 * chain_w_2_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .add_product(chain_m_2_times_chain_gravity, sin_chain_th_1)
            .add_product(
                p.chain_m_3 * p.chain_l_2 * chain_w_2_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .add_product(t0, sin_chain_th_1_minus_chain_th_3)
            .add_product(chain_m_3_times_chain_gravity, sin_chain_th_1));
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let chain_th_2_forcing = p.chain_l_2
        * (p.chain_m_2 * p.chain_l_1 * chain_w_1_squared
            * sin_chain_th_1_minus_chain_th_2)
            .add_product(
                p.chain_m_3 * p.chain_l_1 * chain_w_1_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .sub_product(chain_m_2_times_chain_gravity, sin_chain_th_2)
            .sub_product(t0, sin_chain_th_2_minus_chain_th_3)
            .sub_product(chain_m_3_times_chain_gravity, sin_chain_th_2);
    let chain_th_3_forcing = chain_m_3_times_chain_l_3
        * (p.chain_l_1 * chain_w_1_squared * sin_chain_th_1_minus_chain_th_3)
            .add_product(
                p.chain_l_2 * chain_w_2_squared,
                sin_chain_th_2_minus_chain_th_3,
            )
            .sub_product(p.chain_gravity, sin_chain_th_3);
    [chain_th_1_forcing, chain_th_2_forcing, chain_th_3_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 284 operations.
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
/// 254 operations.
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
    let t0 = (sin_chain_th_1 * cos_chain_th_2)
        .sub_product(cos_chain_th_1, sin_chain_th_2);
    let t1 = (cos_chain_th_1 * cos_chain_th_2)
        .add_product(sin_chain_th_1, sin_chain_th_2);
    let t2 = c.t0 * t1;
    let t3 = (sin_chain_th_1 * cos_chain_th_3)
        .sub_product(cos_chain_th_1, sin_chain_th_3);
    let t4 = (cos_chain_th_1 * cos_chain_th_3)
        .add_product(sin_chain_th_1, sin_chain_th_3);
    let t5 = c.t1 * t4;
    let t6 = (sin_chain_th_2 * cos_chain_th_3)
        .sub_product(cos_chain_th_2, sin_chain_th_3);
    let t7 = (cos_chain_th_2 * cos_chain_th_3)
        .add_product(sin_chain_th_2, sin_chain_th_3);
    let t8 = t2 * c.t4;
    let t9 = t5 * c.t4;
    let t10 = R::literal(1.0) / c.t2.sub_product(t8, t2);
    let t11 = (c.t3 * t7).sub_product(t9, t2);
    let t12 = t11 * t10;
    let t13 = R::literal(1.0)
        / c.chain_m_3_times_chain_l_3_squared.sub_product(t9, t5).sub_product(t12, t11);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let t14 = c.chain_m_2_times_chain_l_2 * chain_w_2_squared;
    let t15 = c.chain_m_3_times_chain_l_2 * chain_w_2_squared;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let t16 = c.chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let t17 = p.chain_l_1
        * (c.chain_m_1_times_chain_gravity * sin_chain_th_1)
            .add_product(t14, t0)
            .add_product(c.chain_m_2_times_chain_gravity, sin_chain_th_1)
            .add_product(t15, t0)
            .add_product(t16, t3)
            .add_product(c.chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t18 = c.chain_m_2_times_chain_l_1 * chain_w_1_squared;
    let t19 = c.chain_m_3_times_chain_l_1 * chain_w_1_squared;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t20 = (p.chain_l_2
        * (t18 * t0)
            .add_product(t19, t0)
            .sub_product(c.chain_m_2_times_chain_gravity, sin_chain_th_2)
            .sub_product(t16, t6)
            .sub_product(c.chain_m_3_times_chain_gravity, sin_chain_th_2))
        .add_product(t8, t17);
    let chain_w_3_dot = (c.chain_m_3_times_chain_l_3
        * (chain_l_1_times_chain_w_1_squared * t3)
            .add_product(chain_l_2_times_chain_w_2_squared, t6)
            .sub_product(p.chain_gravity, sin_chain_th_3))
        .add_product(t9, t17)
        .sub_product(t12, t20) * t13;
    let chain_w_2_dot = (t20 * t10).sub_product(t12, chain_w_3_dot);
    let chain_w_1_dot = (-(t17 * c.t4))
        .sub_product(t8, chain_w_2_dot)
        .sub_product(t9, chain_w_3_dot);
    let t21 = c.t0 * t0;
    let t22 = t21 * chain_w_2_dot;
    let t23 = t21 * chain_w_1_dot;
    let t24 = c.t1 * t3;
    let t25 = t24 * chain_w_3_dot;
    let t26 = t22
        .sub_product(
            p.chain_l_1,
            (c.chain_m_1_times_chain_gravity * cos_chain_th_1)
                .add_product(t14, t1)
                .add_product(c.chain_m_2_times_chain_gravity, cos_chain_th_1)
                .add_product(t15, t1)
                .add_product(t16, t4)
                .add_product(c.chain_m_3_times_chain_gravity, cos_chain_th_1),
        ) + t25;
    let t27 = t24 * chain_w_1_dot;
    let t28 = t23.add_product(c.t0 * chain_w_1_squared, t1).sub_product(t8, t26);
    let chain_w_3_dot_by_chain_th_1 = t27
        .add_product(c.t1 * chain_w_1_squared, t4)
        .sub_product(t9, t26)
        .sub_product(t12, t28) * t13;
    let chain_w_2_dot_by_chain_th_1 = (t28 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_th_1);
    let chain_w_1_dot_by_chain_th_1 = (t26 * c.t4)
        .sub_product(t8, chain_w_2_dot_by_chain_th_1)
        .sub_product(t9, chain_w_3_dot_by_chain_th_1);
    let t29 = (-t22).add_product(c.t0 * chain_w_2_squared, t1);
    let t30 = c.t3 * t6;
    let t31 = t30 * chain_w_3_dot;
    let t32 = t30 * chain_w_2_dot;
    let t33 = ((-t23)
        .add_product(
            p.chain_l_2,
            (-(c.chain_m_2_times_chain_gravity * cos_chain_th_2))
                .sub_product(t18, t1)
                .sub_product(t19, t1)
                .sub_product(t16, t7)
                .sub_product(c.chain_m_3_times_chain_gravity, cos_chain_th_2),
        ) + t31)
        .sub_product(t8, t29);
    let chain_w_3_dot_by_chain_th_2 = t32
        .add_product(c.t3 * chain_w_2_squared, t7)
        .sub_product(t9, t29)
        .sub_product(t12, t33) * t13;
    let chain_w_2_dot_by_chain_th_2 = (t33 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_th_2);
    let chain_w_1_dot_by_chain_th_2 = (t29 * c.t4)
        .sub_product(t8, chain_w_2_dot_by_chain_th_2)
        .sub_product(t9, chain_w_3_dot_by_chain_th_2);
    let t34 = (-t25).add_product(c.t1 * chain_w_3_squared, t4);
    let t35 = (-t31).add_product(c.t3 * chain_w_3_squared, t7).sub_product(t8, t34);
    let chain_w_3_dot_by_chain_th_3 = ((-t27)
        .add_product(
            c.chain_m_3_times_chain_l_3,
            (-(chain_l_2_times_chain_w_2_squared * t7))
                .sub_product(chain_l_1_times_chain_w_1_squared, t4)
                .sub_product(p.chain_gravity, cos_chain_th_3),
        ) - t32)
        .sub_product(t9, t34)
        .sub_product(t12, t35) * t13;
    let chain_w_2_dot_by_chain_th_3 = (t35 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_th_3);
    let chain_w_1_dot_by_chain_th_3 = (t34 * c.t4)
        .sub_product(t8, chain_w_2_dot_by_chain_th_3)
        .sub_product(t9, chain_w_3_dot_by_chain_th_3);
    let t36 = c.t5 * chain_w_1 * t0;
    let chain_w_3_dot_by_chain_w_1 = (c.t7 * chain_w_1 * t3).sub_product(t12, t36) * t13;
    let chain_w_2_dot_by_chain_w_1 = (t36 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_w_1);
    let chain_w_1_dot_by_chain_w_1 = (-(t9 * chain_w_3_dot_by_chain_w_1))
        .sub_product(t8, chain_w_2_dot_by_chain_w_1);
    let t37 = c.t5 * chain_w_2 * t0;
    let t38 = t8 * t37;
    let chain_w_3_dot_by_chain_w_2 = (c.t8 * chain_w_2 * t6)
        .add_product(t9, t37)
        .sub_product(t12, t38) * t13;
    let chain_w_2_dot_by_chain_w_2 = (t38 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_w_2);
    let chain_w_1_dot_by_chain_w_2 = (-(t37 * c.t4))
        .sub_product(t8, chain_w_2_dot_by_chain_w_2)
        .sub_product(t9, chain_w_3_dot_by_chain_w_2);
    let t39 = c.t7 * chain_w_3 * t3;
    let t40 = (-(c.t8 * chain_w_3 * t6)).add_product(t8, t39);
    let chain_w_3_dot_by_chain_w_3 = (t9 * t39).sub_product(t12, t40) * t13;
    let chain_w_2_dot_by_chain_w_3 = (t40 * t10)
        .sub_product(t12, chain_w_3_dot_by_chain_w_3);
    let chain_w_1_dot_by_chain_w_3 = (-(t39 * c.t4))
        .sub_product(t8, chain_w_2_dot_by_chain_w_3)
        .sub_product(t9, chain_w_3_dot_by_chain_w_3);
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
/// 328 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 21] {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_th_1_minus_chain_th_2 = chain_th_1 - chain_th_2;
    let chain_th_1_minus_chain_th_3 = chain_th_1 - chain_th_3;
    let chain_th_2_minus_chain_th_3 = chain_th_2 - chain_th_3;
    let [(sin_chain_th_1, _), (sin_chain_th_2, _), (sin_chain_th_3, _),
    (sin_chain_th_1_minus_chain_th_2, cos_chain_th_1_minus_chain_th_2),
    (sin_chain_th_1_minus_chain_th_3, cos_chain_th_1_minus_chain_th_3),
    (sin_chain_th_2_minus_chain_th_3, cos_chain_th_2_minus_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
        chain_th_1_minus_chain_th_2,
        chain_th_1_minus_chain_th_3,
        chain_th_2_minus_chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let t0 = p.chain_m_1 + p.chain_m_2 + p.chain_m_3;
    let chain_l_1_squared = p.chain_l_1 * p.chain_l_1;
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let chain_l_1_times_chain_l_2 = p.chain_l_1 * p.chain_l_2;
    let t1 = chain_l_1_times_chain_l_2 * chain_m_2_plus_chain_m_3
        * cos_chain_th_1_minus_chain_th_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t2 = chain_m_3_times_chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let chain_l_2_squared = p.chain_l_2 * p.chain_l_2;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let chain_l_3_squared = p.chain_l_3 * p.chain_l_3;
    let t3 = R::literal(1.0) / (t0 * chain_l_1_squared);
    let t4 = t1 * t3;
    let t5 = t2 * t3;
    let t6 = R::literal(1.0)
        / (chain_m_2_plus_chain_m_3 * chain_l_2_squared).sub_product(t4, t1);
    let t7 = (chain_m_3_times_chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3)
        .sub_product(t5, t1);
    let t8 = t7 * t6;
    let t9 = R::literal(1.0)
        / (p.chain_m_3 * chain_l_3_squared).sub_product(t5, t2).sub_product(t8, t7);
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_w_3_squared = chain_w_3 * chain_w_3;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t10 = chain_m_3_times_chain_l_3 * chain_w_3_squared;
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t11 = (p.chain_m_1 * p.chain_gravity * sin_chain_th_1)
        .add_product(
            p.chain_m_2 * p.chain_l_2 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_th_2,
        )
        .add_product(chain_m_2_times_chain_gravity, sin_chain_th_1)
        .add_product(
            chain_m_3_times_chain_l_2 * chain_w_2_squared,
            sin_chain_th_1_minus_chain_th_2,
        )
        .add_product(t10, sin_chain_th_1_minus_chain_th_3)
        .add_product(chain_m_3_times_chain_gravity, sin_chain_th_1);
    let t12 = p.chain_l_1 * t11;
    let t13 = chain_m_2_times_chain_gravity * sin_chain_th_2;
    let t14 = t10 * sin_chain_th_2_minus_chain_th_3;
    let t15 = chain_m_3_times_chain_gravity * sin_chain_th_2;
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t16 = p.chain_m_2 * p.chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_2;
    let t17 = chain_m_3_times_chain_l_1 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_2;
    let chain_l_1_times_chain_w_1_squared = p.chain_l_1 * chain_w_1_squared;
    let chain_l_2_times_chain_w_2_squared = p.chain_l_2 * chain_w_2_squared;
    let t18 = (chain_l_1_times_chain_w_1_squared * sin_chain_th_1_minus_chain_th_3)
        .add_product(chain_l_2_times_chain_w_2_squared, sin_chain_th_2_minus_chain_th_3)
        .sub_product(p.chain_gravity, sin_chain_th_3);
    let t19 = (p.chain_l_2 * (t16 + t17 - t13 - t14 - t15)).add_product(t4, t12);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3 * t18)
        .add_product(t5, t12)
        .sub_product(t8, t19) * t9;
    let chain_w_2_dot = (t19 * t6).sub_product(t8, chain_w_3_dot);
    let chain_w_1_dot = (-(t12 * t3))
        .sub_product(t4, chain_w_2_dot)
        .sub_product(t5, chain_w_3_dot);
    let t20 = chain_l_1_squared * chain_w_1_dot;
    let t21 = (-t20).sub_product(p.chain_gravity, chain_x_1);
    let t22 = t4 * t21;
    let chain_w_3_dot_by_chain_m_1 = (-(t5 * t21)).add_product(t8, t22) * t9;
    let chain_w_2_dot_by_chain_m_1 = (-(t22 * t6))
        .sub_product(t8, chain_w_3_dot_by_chain_m_1);
    let chain_w_1_dot_by_chain_m_1 = (t21 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_m_1)
        .sub_product(t5, chain_w_3_dot_by_chain_m_1);
    let t23 = chain_l_2_times_chain_w_2_squared * sin_chain_th_1_minus_chain_th_2;
    let chain_gravity_times_sin_chain_th_1 = p.chain_gravity * sin_chain_th_1;
    let chain_gravity_times_sin_chain_th_2 = p.chain_gravity * sin_chain_th_2;
    let t24 = chain_l_1_times_chain_w_1_squared * sin_chain_th_1_minus_chain_th_2;
    let t25 = chain_l_1_times_chain_l_2 * cos_chain_th_1_minus_chain_th_2;
    let t26 = t25 * chain_w_2_dot;
    let t27 = (-t20).sub_product(p.chain_l_1, t23 + chain_gravity_times_sin_chain_th_1)
        - t26;
    let t28 = t25 * chain_w_1_dot;
    let t29 = chain_l_2_squared * chain_w_2_dot;
    let t30 = ((-t28).add_product(p.chain_l_2, t24 - chain_gravity_times_sin_chain_th_2)
        - t29)
        .sub_product(t4, t27);
    let chain_w_3_dot_by_chain_m_2 = (-(t5 * t27)).sub_product(t8, t30) * t9;
    let chain_w_2_dot_by_chain_m_2 = (t30 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_m_2);
    let chain_w_1_dot_by_chain_m_2 = (t27 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_m_2)
        .sub_product(t5, chain_w_3_dot_by_chain_m_2);
    let chain_l_3_times_chain_w_3_squared = p.chain_l_3 * chain_w_3_squared;
    let t31 = p.chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let t32 = ((-t20)
        .sub_product(
            p.chain_l_1,
            t23
                .add_product(
                    chain_l_3_times_chain_w_3_squared,
                    sin_chain_th_1_minus_chain_th_3,
                ) + chain_gravity_times_sin_chain_th_1,
        ) - t26)
        .sub_product(t31, chain_w_3_dot);
    let t33 = p.chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3;
    let t34 = ((-t28)
        .add_product(
            p.chain_l_2,
            t24
                .sub_product(
                    chain_l_3_times_chain_w_3_squared,
                    sin_chain_th_2_minus_chain_th_3,
                ) - chain_gravity_times_sin_chain_th_2,
        ) - t29)
        .sub_product(t33, chain_w_3_dot)
        .sub_product(t4, t32);
    let chain_w_3_dot_by_chain_m_3 = (p.chain_l_3 * t18)
        .sub_product(t31, chain_w_1_dot)
        .sub_product(t33, chain_w_2_dot)
        .sub_product(chain_l_3_squared, chain_w_3_dot)
        .sub_product(t5, t32)
        .sub_product(t8, t34) * t9;
    let chain_w_2_dot_by_chain_m_3 = (t34 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_m_3);
    let chain_w_1_dot_by_chain_m_3 = (t32 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_m_3)
        .sub_product(t5, chain_w_3_dot_by_chain_m_3);
    let t35 = p.chain_l_2 * chain_m_2_plus_chain_m_3;
    let t36 = t35 * cos_chain_th_1_minus_chain_th_2;
    let t37 = chain_m_3_times_chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let t38 = (-t11)
        .sub_product(R::literal(2.0) * p.chain_l_1 * t0, chain_w_1_dot)
        .sub_product(t36, chain_w_2_dot)
        .sub_product(t37, chain_w_3_dot);
    let t39 = (t35 * chain_w_1_squared * sin_chain_th_1_minus_chain_th_2)
        .sub_product(t36, chain_w_1_dot)
        .sub_product(t4, t38);
    let chain_w_3_dot_by_chain_l_1 = (chain_m_3_times_chain_l_3 * chain_w_1_squared
        * sin_chain_th_1_minus_chain_th_3)
        .sub_product(t37, chain_w_1_dot)
        .sub_product(t5, t38)
        .sub_product(t8, t39) * t9;
    let chain_w_2_dot_by_chain_l_1 = (t39 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_l_1);
    let chain_w_1_dot_by_chain_l_1 = (t38 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_l_1)
        .sub_product(t5, chain_w_3_dot_by_chain_l_1);
    let t40 = p.chain_l_1 * chain_m_2_plus_chain_m_3;
    let t41 = t40 * cos_chain_th_1_minus_chain_th_2;
    let t42 = (-(t40 * chain_w_2_squared * sin_chain_th_1_minus_chain_th_2))
        .sub_product(t41, chain_w_2_dot);
    let t43 = chain_m_3_times_chain_l_3 * cos_chain_th_2_minus_chain_th_3;
    let t44 = (t17 - (t13 + t14 + t15 - t16))
        .sub_product(t41, chain_w_1_dot)
        .sub_product(
            R::literal(2.0) * p.chain_l_2 * chain_m_2_plus_chain_m_3,
            chain_w_2_dot,
        )
        .sub_product(t43, chain_w_3_dot)
        .sub_product(t4, t42);
    let chain_w_3_dot_by_chain_l_2 = (chain_m_3_times_chain_l_3 * chain_w_2_squared
        * sin_chain_th_2_minus_chain_th_3)
        .sub_product(t43, chain_w_2_dot)
        .sub_product(t5, t42)
        .sub_product(t8, t44) * t9;
    let chain_w_2_dot_by_chain_l_2 = (t44 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_l_2);
    let chain_w_1_dot_by_chain_l_2 = (t42 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_l_2)
        .sub_product(t5, chain_w_3_dot_by_chain_l_2);
    let t45 = chain_m_3_times_chain_l_1 * cos_chain_th_1_minus_chain_th_3;
    let t46 = (-(chain_m_3_times_chain_l_1 * chain_w_3_squared
        * sin_chain_th_1_minus_chain_th_3))
        .sub_product(t45, chain_w_3_dot);
    let t47 = chain_m_3_times_chain_l_2 * cos_chain_th_2_minus_chain_th_3;
    let t48 = (-(chain_m_3_times_chain_l_2 * chain_w_3_squared
        * sin_chain_th_2_minus_chain_th_3))
        .sub_product(t47, chain_w_3_dot)
        .sub_product(t4, t46);
    let chain_w_3_dot_by_chain_l_3 = (p.chain_m_3 * t18)
        .sub_product(t45, chain_w_1_dot)
        .sub_product(t47, chain_w_2_dot)
        .sub_product(R::literal(2.0) * p.chain_m_3 * p.chain_l_3, chain_w_3_dot)
        .sub_product(t5, t46)
        .sub_product(t8, t48) * t9;
    let chain_w_2_dot_by_chain_l_3 = (t48 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_l_3);
    let chain_w_1_dot_by_chain_l_3 = (t46 * t3)
        .sub_product(t4, chain_w_2_dot_by_chain_l_3)
        .sub_product(t5, chain_w_3_dot_by_chain_l_3);
    let t49 = t0 * chain_x_1;
    let t50 = (-(t35 * sin_chain_th_2)).add_product(t4, t49);
    let chain_w_3_dot_by_chain_gravity = (-(chain_m_3_times_chain_l_3 * sin_chain_th_3))
        .add_product(t5, t49)
        .sub_product(t8, t50) * t9;
    let chain_w_2_dot_by_chain_gravity = (t50 * t6)
        .sub_product(t8, chain_w_3_dot_by_chain_gravity);
    let chain_w_1_dot_by_chain_gravity = (-(t49 * t3))
        .sub_product(t4, chain_w_2_dot_by_chain_gravity)
        .sub_product(t5, chain_w_3_dot_by_chain_gravity);
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
/// 17 operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [chain_th_1, chain_th_2, chain_th_3, ..] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2),
    (sin_chain_th_3, cos_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_y_1 = -(p.chain_l_1 * cos_chain_th_1);
    let chain_x_2 = chain_x_1.add_product(p.chain_l_2, sin_chain_th_2);
    let chain_y_2 = chain_y_1.sub_product(p.chain_l_2, cos_chain_th_2);
    let chain_x_3 = chain_x_2.add_product(p.chain_l_3, sin_chain_th_3);
    let chain_y_3 = chain_y_2.sub_product(p.chain_l_3, cos_chain_th_3);
    Outputs {
        end_x: chain_x_3,
        end_y: chain_y_3,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 48 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2),
    (sin_chain_th_3, cos_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_y_1 = -chain_l_1_times_cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_y_2 = chain_y_1.sub_product(p.chain_l_2, cos_chain_th_2);
    let chain_l_2_times_chain_w_2 = p.chain_l_2 * chain_w_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_w_2, cos_chain_th_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_w_2, sin_chain_th_2);
    let chain_y_3 = chain_y_2.sub_product(p.chain_l_3, cos_chain_th_3);
    let chain_l_3_times_chain_w_3 = p.chain_l_3 * chain_w_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_w_3, cos_chain_th_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_w_3, sin_chain_th_3);
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
/// 220 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let chain_th_1_minus_chain_th_2 = chain_th_1 - chain_th_2;
    let chain_th_1_minus_chain_th_3 = chain_th_1 - chain_th_3;
    let chain_th_2_minus_chain_th_3 = chain_th_2 - chain_th_3;
    let [(sin_chain_th_1, cos_chain_th_1), (sin_chain_th_2, cos_chain_th_2),
    (sin_chain_th_3, cos_chain_th_3),
    (sin_chain_th_1_minus_chain_th_2, cos_chain_th_1_minus_chain_th_2),
    (sin_chain_th_1_minus_chain_th_3, cos_chain_th_1_minus_chain_th_3),
    (sin_chain_th_2_minus_chain_th_3, cos_chain_th_2_minus_chain_th_3)] = R::sin_cos_each([
        chain_th_1,
        chain_th_2,
        chain_th_3,
        chain_th_1_minus_chain_th_2,
        chain_th_1_minus_chain_th_3,
        chain_th_2_minus_chain_th_3,
    ]);
    let chain_x_1 = p.chain_l_1 * sin_chain_th_1;
    let chain_l_1_times_cos_chain_th_1 = p.chain_l_1 * cos_chain_th_1;
    let chain_vx_1 = chain_w_1 * chain_l_1_times_cos_chain_th_1;
    let chain_vy_1 = chain_w_1 * chain_x_1;
    let chain_l_2_times_chain_w_2 = p.chain_l_2 * chain_w_2;
    let chain_vx_2 = chain_vx_1.add_product(chain_l_2_times_chain_w_2, cos_chain_th_2);
    let chain_vy_2 = chain_vy_1.add_product(chain_l_2_times_chain_w_2, sin_chain_th_2);
    let chain_l_3_times_chain_w_3 = p.chain_l_3 * chain_w_3;
    let chain_vx_3 = chain_vx_2.add_product(chain_l_3_times_chain_w_3, cos_chain_th_3);
    let chain_vy_3 = chain_vy_2.add_product(chain_l_3_times_chain_w_3, sin_chain_th_3);
    let chain_m_2_plus_chain_m_3 = p.chain_m_2 + p.chain_m_3;
    let t0 = p.chain_l_1 * p.chain_l_2 * chain_m_2_plus_chain_m_3
        * cos_chain_th_1_minus_chain_th_2;
    let chain_m_3_times_chain_l_1 = p.chain_m_3 * p.chain_l_1;
    let t1 = chain_m_3_times_chain_l_1 * p.chain_l_3 * cos_chain_th_1_minus_chain_th_3;
    let chain_m_3_times_chain_l_2 = p.chain_m_3 * p.chain_l_2;
    let t2 = R::literal(1.0)
        / ((p.chain_m_1 + p.chain_m_2 + p.chain_m_3) * (p.chain_l_1 * p.chain_l_1));
    let t3 = t0 * t2;
    let t4 = t1 * t2;
    let t5 = R::literal(1.0)
        / (chain_m_2_plus_chain_m_3 * (p.chain_l_2 * p.chain_l_2)).sub_product(t3, t0);
    let t6 = (chain_m_3_times_chain_l_2 * p.chain_l_3 * cos_chain_th_2_minus_chain_th_3)
        .sub_product(t4, t0);
    let t7 = t6 * t5;
    let chain_w_2_squared = chain_w_2 * chain_w_2;
    let chain_m_2_times_chain_l_2 = p.chain_m_2 * p.chain_l_2;
    let chain_m_2_times_chain_gravity = p.chain_m_2 * p.chain_gravity;
    let chain_m_3_times_chain_l_3 = p.chain_m_3 * p.chain_l_3;
    let t8 = chain_m_3_times_chain_l_3 * (chain_w_3 * chain_w_3);
    let chain_m_3_times_chain_gravity = p.chain_m_3 * p.chain_gravity;
    let t9 = p.chain_l_1
        * (p.chain_m_1 * p.chain_gravity * sin_chain_th_1)
            .add_product(
                chain_m_2_times_chain_l_2 * chain_w_2_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .add_product(chain_m_2_times_chain_gravity, sin_chain_th_1)
            .add_product(
                chain_m_3_times_chain_l_2 * chain_w_2_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .add_product(t8, sin_chain_th_1_minus_chain_th_3)
            .add_product(chain_m_3_times_chain_gravity, sin_chain_th_1);
    let chain_w_1_squared = chain_w_1 * chain_w_1;
    let t10 = (p.chain_l_2
        * (p.chain_m_2 * p.chain_l_1 * chain_w_1_squared
            * sin_chain_th_1_minus_chain_th_2)
            .add_product(
                chain_m_3_times_chain_l_1 * chain_w_1_squared,
                sin_chain_th_1_minus_chain_th_2,
            )
            .sub_product(chain_m_2_times_chain_gravity, sin_chain_th_2)
            .sub_product(t8, sin_chain_th_2_minus_chain_th_3)
            .sub_product(chain_m_3_times_chain_gravity, sin_chain_th_2))
        .add_product(t3, t9);
    let chain_w_3_dot = (chain_m_3_times_chain_l_3
        * (p.chain_l_1 * chain_w_1_squared * sin_chain_th_1_minus_chain_th_3)
            .add_product(
                p.chain_l_2 * chain_w_2_squared,
                sin_chain_th_2_minus_chain_th_3,
            )
            .sub_product(p.chain_gravity, sin_chain_th_3))
        .add_product(t4, t9)
        .sub_product(t7, t10)
        * (R::literal(1.0)
            / (p.chain_m_3 * (p.chain_l_3 * p.chain_l_3))
                .sub_product(t4, t1)
                .sub_product(t7, t6));
    let chain_w_2_dot = (t10 * t5).sub_product(t7, chain_w_3_dot);
    let chain_w_1_dot = (-(t9 * t2))
        .sub_product(t3, chain_w_2_dot)
        .sub_product(t4, chain_w_3_dot);
    let t11 = R::literal(2.0) * p.chain_l_2;
    let t12 = R::literal(0.5) * p.chain_m_2;
    let t13 = R::literal(0.5) * p.chain_m_3;
    let t14 = R::literal(2.0) * chain_vx_1;
    let t15 = t11 * chain_w_2;
    let t16 = (t12
        * (t15 * chain_vy_2 * cos_chain_th_2)
            .sub_product(t15 * chain_vx_2, sin_chain_th_2))
        .add_product(
            t13,
            (t15 * chain_vy_3 * cos_chain_th_2)
                .sub_product(t15 * chain_vx_3, sin_chain_th_2),
        )
        .add_product(
            p.chain_gravity,
            (chain_m_2_times_chain_l_2 * sin_chain_th_2)
                .add_product(chain_m_3_times_chain_l_2, sin_chain_th_2),
        );
    let t17 = R::literal(2.0) * p.chain_l_3;
    let t18 = t17 * chain_w_3;
    let t19 = ((t12
        * (t14 * chain_vy_2).sub_product(R::literal(2.0) * chain_vx_2, chain_vy_1))
        .add_product(
            t13,
            (t14 * chain_vy_3).sub_product(R::literal(2.0) * chain_vx_3, chain_vy_1),
        )
        .add_product(
            p.chain_gravity,
            (p.chain_m_1 * chain_x_1)
                .add_product(p.chain_m_2, chain_x_1)
                .add_product(p.chain_m_3, chain_x_1),
        ) * chain_w_1)
        .add_product(t16, chain_w_2)
        .add_product(
            (chain_m_3_times_chain_l_3 * p.chain_gravity * sin_chain_th_3)
                .add_product(
                    t13,
                    (t18 * chain_vy_3 * cos_chain_th_3)
                        .sub_product(t18 * chain_vx_3, sin_chain_th_3),
                ),
            chain_w_3,
        );
    let t20 = R::literal(2.0) * chain_l_1_times_cos_chain_th_1;
    let t21 = R::literal(2.0) * chain_x_1;
    let t22 = t19
        .add_product(
            (R::literal(0.5) * p.chain_m_1
                * (t21 * chain_vy_1).add_product(t20, chain_vx_1))
                .add_product(t12, (t21 * chain_vy_2).add_product(t20, chain_vx_2))
                .add_product(t13, (t21 * chain_vy_3).add_product(t20, chain_vx_3)),
            chain_w_1_dot,
        )
        .add_product(
            (t12
                * (t11 * chain_vx_2 * cos_chain_th_2)
                    .add_product(t11 * chain_vy_2, sin_chain_th_2))
                .add_product(
                    t13,
                    (t11 * chain_vx_3 * cos_chain_th_2)
                        .add_product(t11 * chain_vy_3, sin_chain_th_2),
                ),
            chain_w_2_dot,
        );
    PowerBalance {
        stored_rate: t22
            .add_product(
                t13
                    * (t17 * chain_vx_3 * cos_chain_th_3)
                        .add_product(t17 * chain_vy_3, sin_chain_th_3),
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
/// 106 recurrences. 29 sums of products an order.
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
    let (mut lanes_7, _) = Lanes::<R, 1>::new(workspace, coefficients.len());
    let [chain_th_1, chain_th_2, chain_th_3, chain_w_1, chain_w_2, chain_w_3] = *state;
    let t0 = p.chain_m_1 + p.chain_m_2;
    let t1 = t0 + p.chain_m_3;
    let t2 = p.chain_l_1 * p.chain_l_1;
    let t3 = t1 * t2;
    let t4 = p.chain_m_2 + p.chain_m_3;
    let t5 = chain_th_1 - chain_th_2;
    let t6 = t5.sin();
    let t7 = t5.cos();
    let t8 = p.chain_l_1 * p.chain_l_2;
    let t9 = t8 * t4;
    let t10 = t7 * t9;
    let t11 = chain_th_1 - chain_th_3;
    let t12 = t11.sin();
    let t13 = t11.cos();
    let t14 = p.chain_m_3 * p.chain_l_1;
    let t15 = t14 * p.chain_l_3;
    let t16 = t13 * t15;
    let t17 = p.chain_l_2 * p.chain_l_2;
    let t18 = t4 * t17;
    let t19 = chain_th_2 - chain_th_3;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = p.chain_m_3 * p.chain_l_2;
    let t23 = t22 * p.chain_l_3;
    let t24 = t21 * t23;
    let t25 = p.chain_l_3 * p.chain_l_3;
    let t26 = p.chain_m_3 * t25;
    let sin_chain_th_1 = chain_th_1.sin();
    let cos_chain_th_1 = chain_th_1.cos();
    let sin_chain_th_2 = chain_th_2.sin();
    let cos_chain_th_2 = chain_th_2.cos();
    let sin_chain_th_3 = chain_th_3.sin();
    let cos_chain_th_3 = chain_th_3.cos();
    let t27 = p.chain_m_1 * p.chain_gravity;
    let t28 = sin_chain_th_1 * t27;
    let t29 = chain_w_2 * chain_w_2;
    let t30 = p.chain_m_2 * p.chain_l_2;
    let t31 = t29 * t30;
    let t32 = t31 * t6;
    let t33 = p.chain_m_2 * p.chain_gravity;
    let t34 = sin_chain_th_1 * t33;
    let t35 = t29 * t22;
    let t36 = t35 * t6;
    let t37 = chain_w_3 * chain_w_3;
    let t38 = p.chain_m_3 * p.chain_l_3;
    let t39 = t37 * t38;
    let t40 = t39 * t12;
    let t41 = p.chain_m_3 * p.chain_gravity;
    let t42 = sin_chain_th_1 * t41;
    let t43 = t28 + t32;
    let t44 = t43 + t34;
    let t45 = t44 + t36;
    let t46 = t45 + t40;
    let t47 = t46 + t42;
    let t48 = t47 * p.chain_l_1;
    let t49 = -t48;
    let t50 = sin_chain_th_2 * t33;
    let t51 = t39 * t20;
    let t52 = sin_chain_th_2 * t41;
    let t53 = chain_w_1 * chain_w_1;
    let t54 = p.chain_m_2 * p.chain_l_1;
    let t55 = t53 * t54;
    let t56 = t55 * t6;
    let t57 = t53 * t14;
    let t58 = t57 * t6;
    let t59 = t56 + t58;
    let t60 = t59 - t50;
    let t61 = t60 - t51;
    let t62 = t61 - t52;
    let t63 = t62 * p.chain_l_2;
    let t64 = sin_chain_th_3 * p.chain_gravity;
    let t65 = t53 * p.chain_l_1;
    let t66 = t65 * t12;
    let t67 = t29 * p.chain_l_2;
    let t68 = t67 * t20;
    let t69 = t66 + t68;
    let t70 = t69 - t64;
    let t71 = t70 * t38;
    let factored = Factored::new([
        [t3, R::literal(0.0), R::literal(0.0)],
        [t10, t18, R::literal(0.0)],
        [t16, t24, t26],
    ]);
    let [chain_w_1_dot, chain_w_2_dot, chain_w_3_dot] = factored.solve([t49, t63, t71]);
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
        let t5_k = chain_th_1_k - chain_th_2_k;
        let t6_k = t5_k.mul_add(t7, inverse * sums_2[1]);
        let t7_k = -t5_k.mul_add(t6, inverse * sums_2[2]);
        let t10_k = t7_k * t9;
        let t11_k = chain_th_1_k - chain_th_3_k;
        let t12_k = t11_k.mul_add(t13, inverse * sums_2[3]);
        let t13_k = -t11_k.mul_add(t12, inverse * sums_3[0]);
        let t16_k = t13_k * t15;
        let t19_k = chain_th_2_k - chain_th_3_k;
        let t20_k = t19_k.mul_add(t21, inverse * sums_3[1]);
        let t21_k = -t19_k.mul_add(t20, inverse * sums_3[2]);
        let t24_k = t21_k * t23;
        let sin_chain_th_1_k = chain_th_1_k.mul_add(cos_chain_th_1, inverse * sums[3]);
        let cos_chain_th_1_k = -chain_th_1_k
            .mul_add(sin_chain_th_1, inverse * sums_1[0]);
        let sin_chain_th_2_k = chain_th_2_k.mul_add(cos_chain_th_2, inverse * sums_1[1]);
        let cos_chain_th_2_k = -chain_th_2_k
            .mul_add(sin_chain_th_2, inverse * sums_1[2]);
        let sin_chain_th_3_k = chain_th_3_k.mul_add(cos_chain_th_3, inverse * sums_1[3]);
        let cos_chain_th_3_k = -chain_th_3_k
            .mul_add(sin_chain_th_3, inverse * sums_2[0]);
        let t29_k = (chain_w_2 + chain_w_2).mul_add(chain_w_2_k, sums[0]);
        let t31_k = t29_k * t30;
        let t32_k = t31.mul_add(t6_k, t6.mul_add(t31_k, sums_3[3]));
        let t35_k = t29_k * t22;
        let t36_k = t35.mul_add(t6_k, t6.mul_add(t35_k, sums_4[0]));
        let t37_k = (chain_w_3 + chain_w_3).mul_add(chain_w_3_k, sums[1]);
        let t39_k = t37_k * t38;
        let t40_k = t39.mul_add(t12_k, t12.mul_add(t39_k, sums_4[1]));
        let t43_k = sin_chain_th_1_k.mul_add(t27, t32_k);
        let t44_k = sin_chain_th_1_k.mul_add(t33, t43_k);
        let t45_k = t44_k + t36_k;
        let t46_k = t45_k + t40_k;
        let t47_k = sin_chain_th_1_k.mul_add(t41, t46_k);
        let t48_k = t47_k * p.chain_l_1;
        let t49_k = -t48_k;
        let t51_k = t39.mul_add(t20_k, t20.mul_add(t39_k, sums_4[2]));
        let t53_k = (chain_w_1 + chain_w_1).mul_add(chain_w_1_k, sums[2]);
        let t55_k = t53_k * t54;
        let t56_k = t55.mul_add(t6_k, t6.mul_add(t55_k, sums_4[3]));
        let t57_k = t53_k * t14;
        let t58_k = t57.mul_add(t6_k, t6.mul_add(t57_k, sums_5[0]));
        let t59_k = t56_k + t58_k;
        let t60_k = (-sin_chain_th_2_k).mul_add(t33, t59_k);
        let t61_k = t60_k - t51_k;
        let t62_k = (-sin_chain_th_2_k).mul_add(t41, t61_k);
        let t65_k = t53_k * p.chain_l_1;
        let t66_k = t65.mul_add(t12_k, t12.mul_add(t65_k, sums_5[1]));
        let t67_k = t29_k * p.chain_l_2;
        let t68_k = t67.mul_add(t20_k, t20.mul_add(t67_k, sums_5[2]));
        let t69_k = t66_k + t68_k;
        let t70_k = (-sin_chain_th_3_k).mul_add(p.chain_gravity, t69_k);
        let n94_k = t10_k.mul_add(chain_w_2_dot, sums_5[3]);
        let n95_k = t16_k.mul_add(chain_w_3_dot, sums_6[0]);
        let n96_k = t10_k.mul_add(chain_w_1_dot, sums_6[1]);
        let n97_k = t24_k.mul_add(chain_w_3_dot, sums_6[2]);
        let n98_k = t16_k.mul_add(chain_w_1_dot, sums_6[3]);
        let n99_k = t24_k.mul_add(chain_w_2_dot, sums_7[0]);
        let n100_k = n94_k + n95_k;
        let t49_k_2 = t49_k - n100_k;
        let n102_k = n96_k + n97_k;
        let t63_k = t62_k.mul_add(p.chain_l_2, -n102_k);
        let n104_k = n98_k + n99_k;
        let t71_k = t70_k.mul_add(t38, -n104_k);
        let [chain_w_1_dot_k, chain_w_2_dot_k, chain_w_3_dot_k] = factored
            .solve([t49_k_2, t63_k, t71_k]);
        lanes
            .set(
                order,
                [chain_w_2_k, chain_w_3_k, chain_w_1_k, k * chain_th_1_k],
                [chain_w_2_k, chain_w_3_k, chain_w_1_k, cos_chain_th_1_k],
            );
        lanes_1
            .set(
                order,
                [k * chain_th_1_k, k * chain_th_2_k, k * chain_th_2_k, k * chain_th_3_k],
                [sin_chain_th_1_k, cos_chain_th_2_k, sin_chain_th_2_k, cos_chain_th_3_k],
            );
        lanes_2
            .set(
                order,
                [k * chain_th_3_k, k * t5_k, k * t5_k, k * t11_k],
                [sin_chain_th_3_k, t7_k, t6_k, t13_k],
            );
        lanes_3
            .set(
                order,
                [k * t11_k, k * t19_k, k * t19_k, t6_k],
                [t12_k, t21_k, t20_k, t31_k],
            );
        lanes_4.set(order, [t6_k, t12_k, t20_k, t6_k], [t35_k, t39_k, t39_k, t55_k]);
        lanes_5
            .set(
                order,
                [t6_k, t12_k, t20_k, t10_k],
                [t57_k, t65_k, t67_k, chain_w_2_dot_k],
            );
        lanes_6
            .set(
                order,
                [t16_k, t10_k, t24_k, t16_k],
                [chain_w_3_dot_k, chain_w_1_dot_k, chain_w_3_dot_k, chain_w_1_dot_k],
            );
        lanes_7.set(order, [t24_k], [chain_w_2_dot_k]);
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

impl<R: Real> TaylorSeries<R> for PendulumChain {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 1>::workspace(order + 1)
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

impl Describe for PendulumChain {
    fn name(&self) -> &'static str {
        "pendulum_chain"
    }
    fn title(&self) -> &'static str {
        "Chain of three pendulums"
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

impl<R: Real> Simulator<R> for PendulumChain {
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
        doc: "angle of the second link",
    },
    Quantity {
        name: "chain.th_3",
        unit: "rad",
        doc: "angle of the third link",
    },
    Quantity {
        name: "chain.w_1",
        unit: "rad/s",
        doc: "rate of angle of the first link",
    },
    Quantity {
        name: "chain.w_2",
        unit: "rad/s",
        doc: "rate of angle of the second link",
    },
    Quantity {
        name: "chain.w_3",
        unit: "rad/s",
        doc: "rate of angle of the third link",
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

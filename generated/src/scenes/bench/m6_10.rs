// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   2e35ab6f628f0218103c231b2d83ea7c67c3e75ae6f0cb3daa42c48e707ec4e6  bench/m6_10.toml
//
// Benchmark M6: planar pendulum of 10 links
//
// Point masses on 10 massless links, angles from the downward vertical, released
// horizontal and at rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates              10
//   first-order states        0
//   states                   20
//   parameters                0
//   outputs                  20
//   discontinuities           0
//
// State:
//     0  chain.theta_1   [rad]    angle of link 1 from the vertical
//     1  chain.theta_2   [rad]    angle of link 2 from the vertical
//     2  chain.theta_3   [rad]    angle of link 3 from the vertical
//     3  chain.theta_4   [rad]    angle of link 4 from the vertical
//     4  chain.theta_5   [rad]    angle of link 5 from the vertical
//     5  chain.theta_6   [rad]    angle of link 6 from the vertical
//     6  chain.theta_7   [rad]    angle of link 7 from the vertical
//     7  chain.theta_8   [rad]    angle of link 8 from the vertical
//     8  chain.theta_9   [rad]    angle of link 9 from the vertical
//     9  chain.theta_10  [rad]    angle of link 10 from the vertical
//    10  chain.omega_1   [rad/s]  rate of angle of link 1 from the vertical
//    11  chain.omega_2   [rad/s]  rate of angle of link 2 from the vertical
//    12  chain.omega_3   [rad/s]  rate of angle of link 3 from the vertical
//    13  chain.omega_4   [rad/s]  rate of angle of link 4 from the vertical
//    14  chain.omega_5   [rad/s]  rate of angle of link 5 from the vertical
//    15  chain.omega_6   [rad/s]  rate of angle of link 6 from the vertical
//    16  chain.omega_7   [rad/s]  rate of angle of link 7 from the vertical
//    17  chain.omega_8   [rad/s]  rate of angle of link 8 from the vertical
//    18  chain.omega_9   [rad/s]  rate of angle of link 9 from the vertical
//    19  chain.omega_10  [rad/s]  rate of angle of link 10 from the vertical
//
// Nonzeros:
//   mass_matrix             100 of 10 by 10
//   rate_jacobian           210 of 20 by 20
//   parameter_jacobian        0 of 20 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                   1099
//   mass_matrix             126
//   forcing                 444
//   rate_jacobian          5586
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                  118
//   power_balance          1751

use crate::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 10;

/// Length of the state y.
pub const STATES: usize = 20;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 20;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 10,
    entries: &[
        (0, 0),
        (0, 1),
        (0, 2),
        (0, 3),
        (0, 4),
        (0, 5),
        (0, 6),
        (0, 7),
        (0, 8),
        (0, 9),
        (1, 0),
        (1, 1),
        (1, 2),
        (1, 3),
        (1, 4),
        (1, 5),
        (1, 6),
        (1, 7),
        (1, 8),
        (1, 9),
        (2, 0),
        (2, 1),
        (2, 2),
        (2, 3),
        (2, 4),
        (2, 5),
        (2, 6),
        (2, 7),
        (2, 8),
        (2, 9),
        (3, 0),
        (3, 1),
        (3, 2),
        (3, 3),
        (3, 4),
        (3, 5),
        (3, 6),
        (3, 7),
        (3, 8),
        (3, 9),
        (4, 0),
        (4, 1),
        (4, 2),
        (4, 3),
        (4, 4),
        (4, 5),
        (4, 6),
        (4, 7),
        (4, 8),
        (4, 9),
        (5, 0),
        (5, 1),
        (5, 2),
        (5, 3),
        (5, 4),
        (5, 5),
        (5, 6),
        (5, 7),
        (5, 8),
        (5, 9),
        (6, 0),
        (6, 1),
        (6, 2),
        (6, 3),
        (6, 4),
        (6, 5),
        (6, 6),
        (6, 7),
        (6, 8),
        (6, 9),
        (7, 0),
        (7, 1),
        (7, 2),
        (7, 3),
        (7, 4),
        (7, 5),
        (7, 6),
        (7, 7),
        (7, 8),
        (7, 9),
        (8, 0),
        (8, 1),
        (8, 2),
        (8, 3),
        (8, 4),
        (8, 5),
        (8, 6),
        (8, 7),
        (8, 8),
        (8, 9),
        (9, 0),
        (9, 1),
        (9, 2),
        (9, 3),
        (9, 4),
        (9, 5),
        (9, 6),
        (9, 7),
        (9, 8),
        (9, 9),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 20,
    columns: 20,
    entries: &[
        (0, 10),
        (1, 11),
        (2, 12),
        (3, 13),
        (4, 14),
        (5, 15),
        (6, 16),
        (7, 17),
        (8, 18),
        (9, 19),
        (10, 0),
        (10, 1),
        (10, 2),
        (10, 3),
        (10, 4),
        (10, 5),
        (10, 6),
        (10, 7),
        (10, 8),
        (10, 9),
        (10, 10),
        (10, 11),
        (10, 12),
        (10, 13),
        (10, 14),
        (10, 15),
        (10, 16),
        (10, 17),
        (10, 18),
        (10, 19),
        (11, 0),
        (11, 1),
        (11, 2),
        (11, 3),
        (11, 4),
        (11, 5),
        (11, 6),
        (11, 7),
        (11, 8),
        (11, 9),
        (11, 10),
        (11, 11),
        (11, 12),
        (11, 13),
        (11, 14),
        (11, 15),
        (11, 16),
        (11, 17),
        (11, 18),
        (11, 19),
        (12, 0),
        (12, 1),
        (12, 2),
        (12, 3),
        (12, 4),
        (12, 5),
        (12, 6),
        (12, 7),
        (12, 8),
        (12, 9),
        (12, 10),
        (12, 11),
        (12, 12),
        (12, 13),
        (12, 14),
        (12, 15),
        (12, 16),
        (12, 17),
        (12, 18),
        (12, 19),
        (13, 0),
        (13, 1),
        (13, 2),
        (13, 3),
        (13, 4),
        (13, 5),
        (13, 6),
        (13, 7),
        (13, 8),
        (13, 9),
        (13, 10),
        (13, 11),
        (13, 12),
        (13, 13),
        (13, 14),
        (13, 15),
        (13, 16),
        (13, 17),
        (13, 18),
        (13, 19),
        (14, 0),
        (14, 1),
        (14, 2),
        (14, 3),
        (14, 4),
        (14, 5),
        (14, 6),
        (14, 7),
        (14, 8),
        (14, 9),
        (14, 10),
        (14, 11),
        (14, 12),
        (14, 13),
        (14, 14),
        (14, 15),
        (14, 16),
        (14, 17),
        (14, 18),
        (14, 19),
        (15, 0),
        (15, 1),
        (15, 2),
        (15, 3),
        (15, 4),
        (15, 5),
        (15, 6),
        (15, 7),
        (15, 8),
        (15, 9),
        (15, 10),
        (15, 11),
        (15, 12),
        (15, 13),
        (15, 14),
        (15, 15),
        (15, 16),
        (15, 17),
        (15, 18),
        (15, 19),
        (16, 0),
        (16, 1),
        (16, 2),
        (16, 3),
        (16, 4),
        (16, 5),
        (16, 6),
        (16, 7),
        (16, 8),
        (16, 9),
        (16, 10),
        (16, 11),
        (16, 12),
        (16, 13),
        (16, 14),
        (16, 15),
        (16, 16),
        (16, 17),
        (16, 18),
        (16, 19),
        (17, 0),
        (17, 1),
        (17, 2),
        (17, 3),
        (17, 4),
        (17, 5),
        (17, 6),
        (17, 7),
        (17, 8),
        (17, 9),
        (17, 10),
        (17, 11),
        (17, 12),
        (17, 13),
        (17, 14),
        (17, 15),
        (17, 16),
        (17, 17),
        (17, 18),
        (17, 19),
        (18, 0),
        (18, 1),
        (18, 2),
        (18, 3),
        (18, 4),
        (18, 5),
        (18, 6),
        (18, 7),
        (18, 8),
        (18, 9),
        (18, 10),
        (18, 11),
        (18, 12),
        (18, 13),
        (18, 14),
        (18, 15),
        (18, 16),
        (18, 17),
        (18, 18),
        (18, 19),
        (19, 0),
        (19, 1),
        (19, 2),
        (19, 3),
        (19, 4),
        (19, 5),
        (19, 6),
        (19, 7),
        (19, 8),
        (19, 9),
        (19, 10),
        (19, 11),
        (19, 12),
        (19, 13),
        (19, 14),
        (19, 15),
        (19, 16),
        (19, 17),
        (19, 18),
        (19, 19),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 20,
    columns: 0,
    entries: &[],
};

/// Benchmark M6: planar pendulum of 10 links
///
/// Point masses on 10 massless links, angles from the downward vertical, released
/// horizontal and at rest.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M610;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// Nothing; there are no numbers here.
    pub real: core::marker::PhantomData<R>,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(_values: [R; PARAMETERS]) -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        []
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            real: core::marker::PhantomData,
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// theta_1: angle of link 1 from the vertical \[rad\].
    pub theta_1: R,
    /// theta_2: angle of link 2 from the vertical \[rad\].
    pub theta_2: R,
    /// theta_3: angle of link 3 from the vertical \[rad\].
    pub theta_3: R,
    /// theta_4: angle of link 4 from the vertical \[rad\].
    pub theta_4: R,
    /// theta_5: angle of link 5 from the vertical \[rad\].
    pub theta_5: R,
    /// theta_6: angle of link 6 from the vertical \[rad\].
    pub theta_6: R,
    /// theta_7: angle of link 7 from the vertical \[rad\].
    pub theta_7: R,
    /// theta_8: angle of link 8 from the vertical \[rad\].
    pub theta_8: R,
    /// theta_9: angle of link 9 from the vertical \[rad\].
    pub theta_9: R,
    /// theta_10: angle of link 10 from the vertical \[rad\].
    pub theta_10: R,
    /// omega_1: rate of angle of link 1 from the vertical \[rad/s\].
    pub omega_1: R,
    /// omega_2: rate of angle of link 2 from the vertical \[rad/s\].
    pub omega_2: R,
    /// omega_3: rate of angle of link 3 from the vertical \[rad/s\].
    pub omega_3: R,
    /// omega_4: rate of angle of link 4 from the vertical \[rad/s\].
    pub omega_4: R,
    /// omega_5: rate of angle of link 5 from the vertical \[rad/s\].
    pub omega_5: R,
    /// omega_6: rate of angle of link 6 from the vertical \[rad/s\].
    pub omega_6: R,
    /// omega_7: rate of angle of link 7 from the vertical \[rad/s\].
    pub omega_7: R,
    /// omega_8: rate of angle of link 8 from the vertical \[rad/s\].
    pub omega_8: R,
    /// omega_9: rate of angle of link 9 from the vertical \[rad/s\].
    pub omega_9: R,
    /// omega_10: rate of angle of link 10 from the vertical \[rad/s\].
    pub omega_10: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            theta_1: values[0],
            theta_2: values[1],
            theta_3: values[2],
            theta_4: values[3],
            theta_5: values[4],
            theta_6: values[5],
            theta_7: values[6],
            theta_8: values[7],
            theta_9: values[8],
            theta_10: values[9],
            omega_1: values[10],
            omega_2: values[11],
            omega_3: values[12],
            omega_4: values[13],
            omega_5: values[14],
            omega_6: values[15],
            omega_7: values[16],
            omega_8: values[17],
            omega_9: values[18],
            omega_10: values[19],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.theta_1,
            self.theta_2,
            self.theta_3,
            self.theta_4,
            self.theta_5,
            self.theta_6,
            self.theta_7,
            self.theta_8,
            self.theta_9,
            self.theta_10,
            self.omega_1,
            self.omega_2,
            self.omega_3,
            self.omega_4,
            self.omega_5,
            self.omega_6,
            self.omega_7,
            self.omega_8,
            self.omega_9,
            self.omega_10,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// chain.theta_1: angle of link 1 from the vertical \[rad\].
    pub const CHAIN_THETA_1: usize = 0;
    /// chain.theta_2: angle of link 2 from the vertical \[rad\].
    pub const CHAIN_THETA_2: usize = 1;
    /// chain.theta_3: angle of link 3 from the vertical \[rad\].
    pub const CHAIN_THETA_3: usize = 2;
    /// chain.theta_4: angle of link 4 from the vertical \[rad\].
    pub const CHAIN_THETA_4: usize = 3;
    /// chain.theta_5: angle of link 5 from the vertical \[rad\].
    pub const CHAIN_THETA_5: usize = 4;
    /// chain.theta_6: angle of link 6 from the vertical \[rad\].
    pub const CHAIN_THETA_6: usize = 5;
    /// chain.theta_7: angle of link 7 from the vertical \[rad\].
    pub const CHAIN_THETA_7: usize = 6;
    /// chain.theta_8: angle of link 8 from the vertical \[rad\].
    pub const CHAIN_THETA_8: usize = 7;
    /// chain.theta_9: angle of link 9 from the vertical \[rad\].
    pub const CHAIN_THETA_9: usize = 8;
    /// chain.theta_10: angle of link 10 from the vertical \[rad\].
    pub const CHAIN_THETA_10: usize = 9;
    /// chain.omega_1: rate of angle of link 1 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_1: usize = 10;
    /// chain.omega_2: rate of angle of link 2 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_2: usize = 11;
    /// chain.omega_3: rate of angle of link 3 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_3: usize = 12;
    /// chain.omega_4: rate of angle of link 4 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_4: usize = 13;
    /// chain.omega_5: rate of angle of link 5 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_5: usize = 14;
    /// chain.omega_6: rate of angle of link 6 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_6: usize = 15;
    /// chain.omega_7: rate of angle of link 7 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_7: usize = 16;
    /// chain.omega_8: rate of angle of link 8 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_8: usize = 17;
    /// chain.omega_9: rate of angle of link 9 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_9: usize = 18;
    /// chain.omega_10: rate of angle of link 10 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_10: usize = 19;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
        R::literal(core::f64::consts::FRAC_PI_2),
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

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 1099 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = R::literal(9.0) * chain_theta_1_minus_chain_theta_2.cos();
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t1 = R::literal(8.0) * chain_theta_1_minus_chain_theta_3.cos();
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t2 = R::literal(7.0) * chain_theta_1_minus_chain_theta_4.cos();
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t3 = R::literal(6.0) * chain_theta_1_minus_chain_theta_5.cos();
    let chain_theta_1_minus_chain_theta_6 = chain_theta_1 - chain_theta_6;
    let t4 = R::literal(5.0) * chain_theta_1_minus_chain_theta_6.cos();
    let chain_theta_1_minus_chain_theta_7 = chain_theta_1 - chain_theta_7;
    let t5 = R::literal(4.0) * chain_theta_1_minus_chain_theta_7.cos();
    let chain_theta_1_minus_chain_theta_8 = chain_theta_1 - chain_theta_8;
    let t6 = R::literal(3.0) * chain_theta_1_minus_chain_theta_8.cos();
    let chain_theta_1_minus_chain_theta_9 = chain_theta_1 - chain_theta_9;
    let t7 = R::literal(2.0) * chain_theta_1_minus_chain_theta_9.cos();
    let chain_theta_1_minus_chain_theta_10 = chain_theta_1 - chain_theta_10;
    let t8 = chain_theta_1_minus_chain_theta_10.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_2_minus_chain_theta_6 = chain_theta_2 - chain_theta_6;
    let chain_theta_2_minus_chain_theta_7 = chain_theta_2 - chain_theta_7;
    let chain_theta_2_minus_chain_theta_8 = chain_theta_2 - chain_theta_8;
    let chain_theta_2_minus_chain_theta_9 = chain_theta_2 - chain_theta_9;
    let chain_theta_2_minus_chain_theta_10 = chain_theta_2 - chain_theta_10;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_6 = chain_theta_3 - chain_theta_6;
    let chain_theta_3_minus_chain_theta_7 = chain_theta_3 - chain_theta_7;
    let chain_theta_3_minus_chain_theta_8 = chain_theta_3 - chain_theta_8;
    let chain_theta_3_minus_chain_theta_9 = chain_theta_3 - chain_theta_9;
    let chain_theta_3_minus_chain_theta_10 = chain_theta_3 - chain_theta_10;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_6 = chain_theta_4 - chain_theta_6;
    let chain_theta_4_minus_chain_theta_7 = chain_theta_4 - chain_theta_7;
    let chain_theta_4_minus_chain_theta_8 = chain_theta_4 - chain_theta_8;
    let chain_theta_4_minus_chain_theta_9 = chain_theta_4 - chain_theta_9;
    let chain_theta_4_minus_chain_theta_10 = chain_theta_4 - chain_theta_10;
    let chain_theta_5_minus_chain_theta_6 = chain_theta_5 - chain_theta_6;
    let chain_theta_5_minus_chain_theta_7 = chain_theta_5 - chain_theta_7;
    let chain_theta_5_minus_chain_theta_8 = chain_theta_5 - chain_theta_8;
    let chain_theta_5_minus_chain_theta_9 = chain_theta_5 - chain_theta_9;
    let chain_theta_5_minus_chain_theta_10 = chain_theta_5 - chain_theta_10;
    let chain_theta_6_minus_chain_theta_7 = chain_theta_6 - chain_theta_7;
    let chain_theta_6_minus_chain_theta_8 = chain_theta_6 - chain_theta_8;
    let chain_theta_6_minus_chain_theta_9 = chain_theta_6 - chain_theta_9;
    let chain_theta_6_minus_chain_theta_10 = chain_theta_6 - chain_theta_10;
    let chain_theta_7_minus_chain_theta_8 = chain_theta_7 - chain_theta_8;
    let chain_theta_7_minus_chain_theta_9 = chain_theta_7 - chain_theta_9;
    let chain_theta_7_minus_chain_theta_10 = chain_theta_7 - chain_theta_10;
    let chain_theta_8_minus_chain_theta_9 = chain_theta_8 - chain_theta_9;
    let chain_theta_8_minus_chain_theta_10 = chain_theta_8 - chain_theta_10;
    let chain_theta_9_minus_chain_theta_10 = chain_theta_9 - chain_theta_10;
    let t9 = t0 * R::literal(0.1);
    let t10 = t1 * R::literal(0.1);
    let t11 = t2 * R::literal(0.1);
    let t12 = t3 * R::literal(0.1);
    let t13 = t4 * R::literal(0.1);
    let t14 = t5 * R::literal(0.1);
    let t15 = t6 * R::literal(0.1);
    let t16 = t7 * R::literal(0.1);
    let t17 = t8 * R::literal(0.1);
    let t18 = R::literal(1.0) / (R::literal(9.0) - t9 * t0);
    let t19 = R::literal(8.0) * chain_theta_2_minus_chain_theta_3.cos() - t10 * t0;
    let t20 = t19 * t18;
    let t21 = R::literal(7.0) * chain_theta_2_minus_chain_theta_4.cos() - t11 * t0;
    let t22 = t21 * t18;
    let t23 = R::literal(6.0) * chain_theta_2_minus_chain_theta_5.cos() - t12 * t0;
    let t24 = t23 * t18;
    let t25 = R::literal(5.0) * chain_theta_2_minus_chain_theta_6.cos() - t13 * t0;
    let t26 = t25 * t18;
    let t27 = R::literal(4.0) * chain_theta_2_minus_chain_theta_7.cos() - t14 * t0;
    let t28 = t27 * t18;
    let t29 = R::literal(3.0) * chain_theta_2_minus_chain_theta_8.cos() - t15 * t0;
    let t30 = t29 * t18;
    let t31 = R::literal(2.0) * chain_theta_2_minus_chain_theta_9.cos() - t16 * t0;
    let t32 = t31 * t18;
    let t33 = chain_theta_2_minus_chain_theta_10.cos() - t17 * t0;
    let t34 = t33 * t18;
    let t35 = R::literal(1.0) / (R::literal(8.0) - t10 * t1 - t20 * t19);
    let t36 = R::literal(7.0) * chain_theta_3_minus_chain_theta_4.cos() - t11 * t1
        - t22 * t19;
    let t37 = t36 * t35;
    let t38 = R::literal(6.0) * chain_theta_3_minus_chain_theta_5.cos() - t12 * t1
        - t24 * t19;
    let t39 = t38 * t35;
    let t40 = R::literal(5.0) * chain_theta_3_minus_chain_theta_6.cos() - t13 * t1
        - t26 * t19;
    let t41 = t40 * t35;
    let t42 = R::literal(4.0) * chain_theta_3_minus_chain_theta_7.cos() - t14 * t1
        - t28 * t19;
    let t43 = t42 * t35;
    let t44 = R::literal(3.0) * chain_theta_3_minus_chain_theta_8.cos() - t15 * t1
        - t30 * t19;
    let t45 = t44 * t35;
    let t46 = R::literal(2.0) * chain_theta_3_minus_chain_theta_9.cos() - t16 * t1
        - t32 * t19;
    let t47 = t46 * t35;
    let t48 = chain_theta_3_minus_chain_theta_10.cos() - t17 * t1 - t34 * t19;
    let t49 = t48 * t35;
    let t50 = R::literal(1.0) / (R::literal(7.0) - t11 * t2 - t22 * t21 - t37 * t36);
    let t51 = R::literal(6.0) * chain_theta_4_minus_chain_theta_5.cos() - t12 * t2
        - t24 * t21 - t39 * t36;
    let t52 = t51 * t50;
    let t53 = R::literal(5.0) * chain_theta_4_minus_chain_theta_6.cos() - t13 * t2
        - t26 * t21 - t41 * t36;
    let t54 = t53 * t50;
    let t55 = R::literal(4.0) * chain_theta_4_minus_chain_theta_7.cos() - t14 * t2
        - t28 * t21 - t43 * t36;
    let t56 = t55 * t50;
    let t57 = R::literal(3.0) * chain_theta_4_minus_chain_theta_8.cos() - t15 * t2
        - t30 * t21 - t45 * t36;
    let t58 = t57 * t50;
    let t59 = R::literal(2.0) * chain_theta_4_minus_chain_theta_9.cos() - t16 * t2
        - t32 * t21 - t47 * t36;
    let t60 = t59 * t50;
    let t61 = chain_theta_4_minus_chain_theta_10.cos() - t17 * t2 - t34 * t21
        - t49 * t36;
    let t62 = t61 * t50;
    let t63 = R::literal(1.0)
        / (R::literal(6.0) - t12 * t3 - t24 * t23 - t39 * t38 - t52 * t51);
    let t64 = R::literal(5.0) * chain_theta_5_minus_chain_theta_6.cos() - t13 * t3
        - t26 * t23 - t41 * t38 - t54 * t51;
    let t65 = t64 * t63;
    let t66 = R::literal(4.0) * chain_theta_5_minus_chain_theta_7.cos() - t14 * t3
        - t28 * t23 - t43 * t38 - t56 * t51;
    let t67 = t66 * t63;
    let t68 = R::literal(3.0) * chain_theta_5_minus_chain_theta_8.cos() - t15 * t3
        - t30 * t23 - t45 * t38 - t58 * t51;
    let t69 = t68 * t63;
    let t70 = R::literal(2.0) * chain_theta_5_minus_chain_theta_9.cos() - t16 * t3
        - t32 * t23 - t47 * t38 - t60 * t51;
    let t71 = t70 * t63;
    let t72 = chain_theta_5_minus_chain_theta_10.cos() - t17 * t3 - t34 * t23 - t49 * t38
        - t62 * t51;
    let t73 = t72 * t63;
    let t74 = R::literal(1.0)
        / (R::literal(5.0) - t13 * t4 - t26 * t25 - t41 * t40 - t54 * t53 - t65 * t64);
    let t75 = R::literal(4.0) * chain_theta_6_minus_chain_theta_7.cos() - t14 * t4
        - t28 * t25 - t43 * t40 - t56 * t53 - t67 * t64;
    let t76 = t75 * t74;
    let t77 = R::literal(3.0) * chain_theta_6_minus_chain_theta_8.cos() - t15 * t4
        - t30 * t25 - t45 * t40 - t58 * t53 - t69 * t64;
    let t78 = t77 * t74;
    let t79 = R::literal(2.0) * chain_theta_6_minus_chain_theta_9.cos() - t16 * t4
        - t32 * t25 - t47 * t40 - t60 * t53 - t71 * t64;
    let t80 = t79 * t74;
    let t81 = chain_theta_6_minus_chain_theta_10.cos() - t17 * t4 - t34 * t25 - t49 * t40
        - t62 * t53 - t73 * t64;
    let t82 = t81 * t74;
    let t83 = R::literal(1.0)
        / (R::literal(4.0) - t14 * t5 - t28 * t27 - t43 * t42 - t56 * t55 - t67 * t66
            - t76 * t75);
    let t84 = R::literal(3.0) * chain_theta_7_minus_chain_theta_8.cos() - t15 * t5
        - t30 * t27 - t45 * t42 - t58 * t55 - t69 * t66 - t78 * t75;
    let t85 = t84 * t83;
    let t86 = R::literal(2.0) * chain_theta_7_minus_chain_theta_9.cos() - t16 * t5
        - t32 * t27 - t47 * t42 - t60 * t55 - t71 * t66 - t80 * t75;
    let t87 = t86 * t83;
    let t88 = chain_theta_7_minus_chain_theta_10.cos() - t17 * t5 - t34 * t27 - t49 * t42
        - t62 * t55 - t73 * t66 - t82 * t75;
    let t89 = t88 * t83;
    let t90 = R::literal(1.0)
        / (R::literal(3.0) - t15 * t6 - t30 * t29 - t45 * t44 - t58 * t57 - t69 * t68
            - t78 * t77 - t85 * t84);
    let t91 = R::literal(2.0) * chain_theta_8_minus_chain_theta_9.cos() - t16 * t6
        - t32 * t29 - t47 * t44 - t60 * t57 - t71 * t68 - t80 * t77 - t87 * t84;
    let t92 = t91 * t90;
    let t93 = chain_theta_8_minus_chain_theta_10.cos() - t17 * t6 - t34 * t29 - t49 * t44
        - t62 * t57 - t73 * t68 - t82 * t77 - t89 * t84;
    let t94 = t93 * t90;
    let t95 = R::literal(1.0)
        / (R::literal(2.0) - t16 * t7 - t32 * t31 - t47 * t46 - t60 * t59 - t71 * t70
            - t80 * t79 - t87 * t86 - t92 * t91);
    let t96 = chain_theta_9_minus_chain_theta_10.cos() - t17 * t7 - t34 * t31 - t49 * t46
        - t62 * t59 - t73 * t70 - t82 * t79 - t89 * t86 - t94 * t91;
    let t97 = t96 * t95;
    let t98 = R::literal(1.0)
        / (R::literal(1.0) - t17 * t8 - t34 * t33 - t49 * t48 - t62 * t61 - t73 * t72
            - t82 * t81 - t89 * t88 - t94 * t93 - t97 * t96);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t99 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t100 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t101 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t102 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t103 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t104 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t105 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t106 = -(R::literal(98.1) * chain_theta_1.sin())
        - R::literal(9.0) * chain_omega_2_squared
            * chain_theta_1_minus_chain_theta_2.sin()
        - t99 * chain_theta_1_minus_chain_theta_3.sin()
        - t100 * chain_theta_1_minus_chain_theta_4.sin()
        - t101 * chain_theta_1_minus_chain_theta_5.sin()
        - t102 * chain_theta_1_minus_chain_theta_6.sin()
        - t103 * chain_theta_1_minus_chain_theta_7.sin();
    let t107 = t106 - t104 * chain_theta_1_minus_chain_theta_8.sin()
        - t105 * chain_theta_1_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_1_minus_chain_theta_10.sin();
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t108 = -(R::literal(88.29) * chain_theta_2.sin())
        - R::literal(9.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t99 * chain_theta_2_minus_chain_theta_3.sin()
        - t100 * chain_theta_2_minus_chain_theta_4.sin()
        - t101 * chain_theta_2_minus_chain_theta_5.sin()
        - t102 * chain_theta_2_minus_chain_theta_6.sin()
        - t103 * chain_theta_2_minus_chain_theta_7.sin();
    let t109 = -(R::literal(78.48) * chain_theta_3.sin())
        - R::literal(8.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(8.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t100 * chain_theta_3_minus_chain_theta_4.sin()
        - t101 * chain_theta_3_minus_chain_theta_5.sin()
        - t102 * chain_theta_3_minus_chain_theta_6.sin();
    let t110 = -(R::literal(68.67) * chain_theta_4.sin())
        - R::literal(7.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(7.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(7.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - t101 * chain_theta_4_minus_chain_theta_5.sin()
        - t102 * chain_theta_4_minus_chain_theta_6.sin();
    let t111 = -(R::literal(58.86) * chain_theta_5.sin())
        - R::literal(6.0) * chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - R::literal(6.0) * chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - R::literal(6.0) * chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - R::literal(6.0) * chain_omega_4_squared
            * (chain_theta_5 - chain_theta_4).sin();
    let t112 = -(R::literal(49.05) * chain_theta_6.sin())
        - R::literal(5.0) * chain_omega_1_squared * (chain_theta_6 - chain_theta_1).sin()
        - R::literal(5.0) * chain_omega_2_squared * (chain_theta_6 - chain_theta_2).sin()
        - R::literal(5.0) * chain_omega_3_squared * (chain_theta_6 - chain_theta_3).sin()
        - R::literal(5.0) * chain_omega_4_squared
            * (chain_theta_6 - chain_theta_4).sin();
    let t113 = -(R::literal(39.24) * chain_theta_7.sin())
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_7 - chain_theta_1).sin()
        - R::literal(4.0) * chain_omega_2_squared * (chain_theta_7 - chain_theta_2).sin()
        - R::literal(4.0) * chain_omega_3_squared * (chain_theta_7 - chain_theta_3).sin()
        - R::literal(4.0) * chain_omega_4_squared
            * (chain_theta_7 - chain_theta_4).sin();
    let t114 = -(R::literal(29.43) * chain_theta_8.sin())
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_8 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_8 - chain_theta_2).sin()
        - R::literal(3.0) * chain_omega_3_squared * (chain_theta_8 - chain_theta_3).sin()
        - R::literal(3.0) * chain_omega_4_squared
            * (chain_theta_8 - chain_theta_4).sin();
    let t115 = -(R::literal(19.62) * chain_theta_9.sin())
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_9 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_9 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_9 - chain_theta_3).sin()
        - R::literal(2.0) * chain_omega_4_squared
            * (chain_theta_9 - chain_theta_4).sin();
    let t116 = t115
        - R::literal(2.0) * chain_omega_5_squared * (chain_theta_9 - chain_theta_5).sin()
        - R::literal(2.0) * chain_omega_6_squared * (chain_theta_9 - chain_theta_6).sin()
        - R::literal(2.0) * chain_omega_7_squared * (chain_theta_9 - chain_theta_7).sin()
        - R::literal(2.0) * chain_omega_8_squared * (chain_theta_9 - chain_theta_8).sin()
        - chain_omega_10_squared * chain_theta_9_minus_chain_theta_10.sin();
    let t117 = -(R::literal(9.81) * chain_theta_10.sin())
        - chain_omega_1_squared * (chain_theta_10 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_10 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_10 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_10 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_10 - chain_theta_5).sin();
    let t118 = t108 - t104 * chain_theta_2_minus_chain_theta_8.sin()
        - t105 * chain_theta_2_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_2_minus_chain_theta_10.sin() - t9 * t107;
    let t119 = t109 - t103 * chain_theta_3_minus_chain_theta_7.sin()
        - t104 * chain_theta_3_minus_chain_theta_8.sin()
        - t105 * chain_theta_3_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_3_minus_chain_theta_10.sin() - t10 * t107
        - t20 * t118;
    let t120 = t110 - t103 * chain_theta_4_minus_chain_theta_7.sin()
        - t104 * chain_theta_4_minus_chain_theta_8.sin()
        - t105 * chain_theta_4_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_4_minus_chain_theta_10.sin() - t11 * t107
        - t22 * t118 - t37 * t119;
    let t121 = t111 - t102 * chain_theta_5_minus_chain_theta_6.sin()
        - t103 * chain_theta_5_minus_chain_theta_7.sin()
        - t104 * chain_theta_5_minus_chain_theta_8.sin()
        - t105 * chain_theta_5_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_5_minus_chain_theta_10.sin() - t12 * t107
        - t24 * t118 - t39 * t119 - t52 * t120;
    let t122 = t112
        - R::literal(5.0) * chain_omega_5_squared * (chain_theta_6 - chain_theta_5).sin()
        - t103 * chain_theta_6_minus_chain_theta_7.sin()
        - t104 * chain_theta_6_minus_chain_theta_8.sin()
        - t105 * chain_theta_6_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_6_minus_chain_theta_10.sin() - t13 * t107
        - t26 * t118 - t41 * t119;
    let t123 = t122 - t54 * t120 - t65 * t121;
    let t124 = t113
        - R::literal(4.0) * chain_omega_5_squared * (chain_theta_7 - chain_theta_5).sin()
        - R::literal(4.0) * chain_omega_6_squared * (chain_theta_7 - chain_theta_6).sin()
        - t104 * chain_theta_7_minus_chain_theta_8.sin()
        - t105 * chain_theta_7_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_7_minus_chain_theta_10.sin() - t14 * t107
        - t28 * t118;
    let t125 = t124 - t43 * t119 - t56 * t120 - t67 * t121 - t76 * t123;
    let t126 = t114
        - R::literal(3.0) * chain_omega_5_squared * (chain_theta_8 - chain_theta_5).sin()
        - R::literal(3.0) * chain_omega_6_squared * (chain_theta_8 - chain_theta_6).sin()
        - R::literal(3.0) * chain_omega_7_squared * (chain_theta_8 - chain_theta_7).sin()
        - t105 * chain_theta_8_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_8_minus_chain_theta_10.sin() - t15 * t107;
    let t127 = t126 - t30 * t118 - t45 * t119 - t58 * t120 - t69 * t121 - t78 * t123
        - t85 * t125;
    let t128 = t116 - t16 * t107 - t32 * t118 - t47 * t119 - t60 * t120 - t71 * t121
        - t80 * t123 - t87 * t125 - t92 * t127;
    let t129 = t117 - chain_omega_6_squared * (chain_theta_10 - chain_theta_6).sin()
        - chain_omega_7_squared * (chain_theta_10 - chain_theta_7).sin()
        - chain_omega_8_squared * (chain_theta_10 - chain_theta_8).sin()
        - chain_omega_9_squared * (chain_theta_10 - chain_theta_9).sin() - t17 * t107
        - t34 * t118 - t49 * t119 - t62 * t120;
    let chain_omega_10_dot = (t129 - t73 * t121 - t82 * t123 - t89 * t125 - t94 * t127
        - t97 * t128) * t98;
    let chain_omega_9_dot = t128 * t95 - t97 * chain_omega_10_dot;
    let chain_omega_8_dot = t127 * t90 - t92 * chain_omega_9_dot
        - t94 * chain_omega_10_dot;
    let chain_omega_7_dot = t125 * t83 - t85 * chain_omega_8_dot
        - t87 * chain_omega_9_dot - t89 * chain_omega_10_dot;
    let chain_omega_6_dot = t123 * t74 - t76 * chain_omega_7_dot
        - t78 * chain_omega_8_dot - t80 * chain_omega_9_dot - t82 * chain_omega_10_dot;
    let chain_omega_5_dot = t121 * t63 - t65 * chain_omega_6_dot
        - t67 * chain_omega_7_dot - t69 * chain_omega_8_dot - t71 * chain_omega_9_dot
        - t73 * chain_omega_10_dot;
    let chain_omega_4_dot = t120 * t50 - t52 * chain_omega_5_dot
        - t54 * chain_omega_6_dot - t56 * chain_omega_7_dot - t58 * chain_omega_8_dot
        - t60 * chain_omega_9_dot - t62 * chain_omega_10_dot;
    let chain_omega_3_dot = t119 * t35 - t37 * chain_omega_4_dot
        - t39 * chain_omega_5_dot - t41 * chain_omega_6_dot - t43 * chain_omega_7_dot
        - t45 * chain_omega_8_dot - t47 * chain_omega_9_dot - t49 * chain_omega_10_dot;
    let chain_omega_2_dot = t118 * t18 - t20 * chain_omega_3_dot
        - t22 * chain_omega_4_dot - t24 * chain_omega_5_dot - t26 * chain_omega_6_dot
        - t28 * chain_omega_7_dot - t30 * chain_omega_8_dot - t32 * chain_omega_9_dot
        - t34 * chain_omega_10_dot;
    let chain_omega_1_dot = t107 * R::literal(0.1) - t9 * chain_omega_2_dot
        - t10 * chain_omega_3_dot - t11 * chain_omega_4_dot - t12 * chain_omega_5_dot
        - t13 * chain_omega_6_dot - t14 * chain_omega_7_dot - t15 * chain_omega_8_dot
        - t16 * chain_omega_9_dot - t17 * chain_omega_10_dot;
    [
        chain_omega_1,
        chain_omega_2,
        chain_omega_3,
        chain_omega_4,
        chain_omega_5,
        chain_omega_6,
        chain_omega_7,
        chain_omega_8,
        chain_omega_9,
        chain_omega_10,
        chain_omega_1_dot,
        chain_omega_2_dot,
        chain_omega_3_dot,
        chain_omega_4_dot,
        chain_omega_5_dot,
        chain_omega_6_dot,
        chain_omega_7_dot,
        chain_omega_8_dot,
        chain_omega_9_dot,
        chain_omega_10_dot,
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 126 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 100] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10, ..] = *state;
    let t0 = R::literal(9.0) * (chain_theta_1 - chain_theta_2).cos();
    let t1 = R::literal(8.0) * (chain_theta_1 - chain_theta_3).cos();
    let t2 = R::literal(7.0) * (chain_theta_1 - chain_theta_4).cos();
    let t3 = R::literal(6.0) * (chain_theta_1 - chain_theta_5).cos();
    let t4 = R::literal(5.0) * (chain_theta_1 - chain_theta_6).cos();
    let t5 = R::literal(4.0) * (chain_theta_1 - chain_theta_7).cos();
    let t6 = R::literal(3.0) * (chain_theta_1 - chain_theta_8).cos();
    let t7 = R::literal(2.0) * (chain_theta_1 - chain_theta_9).cos();
    let t8 = (chain_theta_1 - chain_theta_10).cos();
    let t9 = R::literal(8.0) * (chain_theta_2 - chain_theta_3).cos();
    let t10 = R::literal(7.0) * (chain_theta_2 - chain_theta_4).cos();
    let t11 = R::literal(6.0) * (chain_theta_2 - chain_theta_5).cos();
    let t12 = R::literal(5.0) * (chain_theta_2 - chain_theta_6).cos();
    let t13 = R::literal(4.0) * (chain_theta_2 - chain_theta_7).cos();
    let t14 = R::literal(3.0) * (chain_theta_2 - chain_theta_8).cos();
    let t15 = R::literal(2.0) * (chain_theta_2 - chain_theta_9).cos();
    let t16 = (chain_theta_2 - chain_theta_10).cos();
    let t17 = R::literal(7.0) * (chain_theta_3 - chain_theta_4).cos();
    let t18 = R::literal(6.0) * (chain_theta_3 - chain_theta_5).cos();
    let t19 = R::literal(5.0) * (chain_theta_3 - chain_theta_6).cos();
    let t20 = R::literal(4.0) * (chain_theta_3 - chain_theta_7).cos();
    let t21 = R::literal(3.0) * (chain_theta_3 - chain_theta_8).cos();
    let t22 = R::literal(2.0) * (chain_theta_3 - chain_theta_9).cos();
    let t23 = (chain_theta_3 - chain_theta_10).cos();
    let t24 = R::literal(6.0) * (chain_theta_4 - chain_theta_5).cos();
    let t25 = R::literal(5.0) * (chain_theta_4 - chain_theta_6).cos();
    let t26 = R::literal(4.0) * (chain_theta_4 - chain_theta_7).cos();
    let t27 = R::literal(3.0) * (chain_theta_4 - chain_theta_8).cos();
    let t28 = R::literal(2.0) * (chain_theta_4 - chain_theta_9).cos();
    let t29 = (chain_theta_4 - chain_theta_10).cos();
    let t30 = R::literal(5.0) * (chain_theta_5 - chain_theta_6).cos();
    let t31 = R::literal(4.0) * (chain_theta_5 - chain_theta_7).cos();
    let t32 = R::literal(3.0) * (chain_theta_5 - chain_theta_8).cos();
    let t33 = R::literal(2.0) * (chain_theta_5 - chain_theta_9).cos();
    let t34 = (chain_theta_5 - chain_theta_10).cos();
    let t35 = R::literal(4.0) * (chain_theta_6 - chain_theta_7).cos();
    let t36 = R::literal(3.0) * (chain_theta_6 - chain_theta_8).cos();
    let t37 = R::literal(2.0) * (chain_theta_6 - chain_theta_9).cos();
    let t38 = (chain_theta_6 - chain_theta_10).cos();
    let t39 = R::literal(3.0) * (chain_theta_7 - chain_theta_8).cos();
    let t40 = R::literal(2.0) * (chain_theta_7 - chain_theta_9).cos();
    let t41 = (chain_theta_7 - chain_theta_10).cos();
    let t42 = R::literal(2.0) * (chain_theta_8 - chain_theta_9).cos();
    let t43 = (chain_theta_8 - chain_theta_10).cos();
    let t44 = (chain_theta_9 - chain_theta_10).cos();
    [
        R::literal(10.0),
        t0,
        t1,
        t2,
        t3,
        t4,
        t5,
        t6,
        t7,
        t8,
        t0,
        R::literal(9.0),
        t9,
        t10,
        t11,
        t12,
        t13,
        t14,
        t15,
        t16,
        t1,
        t9,
        R::literal(8.0),
        t17,
        t18,
        t19,
        t20,
        t21,
        t22,
        t23,
        t2,
        t10,
        t17,
        R::literal(7.0),
        t24,
        t25,
        t26,
        t27,
        t28,
        t29,
        t3,
        t11,
        t18,
        t24,
        R::literal(6.0),
        t30,
        t31,
        t32,
        t33,
        t34,
        t4,
        t12,
        t19,
        t25,
        t30,
        R::literal(5.0),
        t35,
        t36,
        t37,
        t38,
        t5,
        t13,
        t20,
        t26,
        t31,
        t35,
        R::literal(4.0),
        t39,
        t40,
        t41,
        t6,
        t14,
        t21,
        t27,
        t32,
        t36,
        t39,
        R::literal(3.0),
        t42,
        t43,
        t7,
        t15,
        t22,
        t28,
        t33,
        t37,
        t40,
        t42,
        R::literal(2.0),
        t44,
        t8,
        t16,
        t23,
        t29,
        t34,
        t38,
        t41,
        t43,
        t44,
        R::literal(1.0),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 444 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t0 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t1 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t2 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t3 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t4 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t5 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t6 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t7 = -(R::literal(98.1) * chain_theta_1.sin())
        - R::literal(9.0) * chain_omega_2_squared * (chain_theta_1 - chain_theta_2).sin()
        - t0 * (chain_theta_1 - chain_theta_3).sin()
        - t1 * (chain_theta_1 - chain_theta_4).sin()
        - t2 * (chain_theta_1 - chain_theta_5).sin()
        - t3 * (chain_theta_1 - chain_theta_6).sin();
    let chain_theta_1_forcing = t7 - t4 * (chain_theta_1 - chain_theta_7).sin()
        - t5 * (chain_theta_1 - chain_theta_8).sin()
        - t6 * (chain_theta_1 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_1 - chain_theta_10).sin();
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t8 = -(R::literal(88.29) * chain_theta_2.sin())
        - R::literal(9.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t0 * (chain_theta_2 - chain_theta_3).sin()
        - t1 * (chain_theta_2 - chain_theta_4).sin()
        - t2 * (chain_theta_2 - chain_theta_5).sin()
        - t3 * (chain_theta_2 - chain_theta_6).sin();
    let chain_theta_2_forcing = t8 - t4 * (chain_theta_2 - chain_theta_7).sin()
        - t5 * (chain_theta_2 - chain_theta_8).sin()
        - t6 * (chain_theta_2 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_2 - chain_theta_10).sin();
    let t9 = -(R::literal(78.48) * chain_theta_3.sin())
        - R::literal(8.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(8.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t1 * (chain_theta_3 - chain_theta_4).sin()
        - t2 * (chain_theta_3 - chain_theta_5).sin();
    let chain_theta_3_forcing = t9 - t3 * (chain_theta_3 - chain_theta_6).sin()
        - t4 * (chain_theta_3 - chain_theta_7).sin()
        - t5 * (chain_theta_3 - chain_theta_8).sin()
        - t6 * (chain_theta_3 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_3 - chain_theta_10).sin();
    let t10 = -(R::literal(68.67) * chain_theta_4.sin())
        - R::literal(7.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(7.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(7.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - t2 * (chain_theta_4 - chain_theta_5).sin();
    let chain_theta_4_forcing = t10 - t3 * (chain_theta_4 - chain_theta_6).sin()
        - t4 * (chain_theta_4 - chain_theta_7).sin()
        - t5 * (chain_theta_4 - chain_theta_8).sin()
        - t6 * (chain_theta_4 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_4 - chain_theta_10).sin();
    let t11 = -(R::literal(58.86) * chain_theta_5.sin())
        - R::literal(6.0) * chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - R::literal(6.0) * chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - R::literal(6.0) * chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - R::literal(6.0) * chain_omega_4_squared
            * (chain_theta_5 - chain_theta_4).sin();
    let chain_theta_5_forcing = t11 - t3 * (chain_theta_5 - chain_theta_6).sin()
        - t4 * (chain_theta_5 - chain_theta_7).sin()
        - t5 * (chain_theta_5 - chain_theta_8).sin()
        - t6 * (chain_theta_5 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_5 - chain_theta_10).sin();
    let t12 = -(R::literal(49.05) * chain_theta_6.sin())
        - R::literal(5.0) * chain_omega_1_squared * (chain_theta_6 - chain_theta_1).sin()
        - R::literal(5.0) * chain_omega_2_squared * (chain_theta_6 - chain_theta_2).sin()
        - R::literal(5.0) * chain_omega_3_squared * (chain_theta_6 - chain_theta_3).sin()
        - R::literal(5.0) * chain_omega_4_squared
            * (chain_theta_6 - chain_theta_4).sin();
    let chain_theta_6_forcing = t12
        - R::literal(5.0) * chain_omega_5_squared * (chain_theta_6 - chain_theta_5).sin()
        - t4 * (chain_theta_6 - chain_theta_7).sin()
        - t5 * (chain_theta_6 - chain_theta_8).sin()
        - t6 * (chain_theta_6 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_6 - chain_theta_10).sin();
    let t13 = -(R::literal(39.24) * chain_theta_7.sin())
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_7 - chain_theta_1).sin()
        - R::literal(4.0) * chain_omega_2_squared * (chain_theta_7 - chain_theta_2).sin()
        - R::literal(4.0) * chain_omega_3_squared * (chain_theta_7 - chain_theta_3).sin()
        - R::literal(4.0) * chain_omega_4_squared
            * (chain_theta_7 - chain_theta_4).sin();
    let chain_theta_7_forcing = t13
        - R::literal(4.0) * chain_omega_5_squared * (chain_theta_7 - chain_theta_5).sin()
        - R::literal(4.0) * chain_omega_6_squared * (chain_theta_7 - chain_theta_6).sin()
        - t5 * (chain_theta_7 - chain_theta_8).sin()
        - t6 * (chain_theta_7 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_7 - chain_theta_10).sin();
    let t14 = -(R::literal(29.43) * chain_theta_8.sin())
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_8 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_8 - chain_theta_2).sin()
        - R::literal(3.0) * chain_omega_3_squared * (chain_theta_8 - chain_theta_3).sin()
        - R::literal(3.0) * chain_omega_4_squared
            * (chain_theta_8 - chain_theta_4).sin();
    let chain_theta_8_forcing = t14
        - R::literal(3.0) * chain_omega_5_squared * (chain_theta_8 - chain_theta_5).sin()
        - R::literal(3.0) * chain_omega_6_squared * (chain_theta_8 - chain_theta_6).sin()
        - R::literal(3.0) * chain_omega_7_squared * (chain_theta_8 - chain_theta_7).sin()
        - t6 * (chain_theta_8 - chain_theta_9).sin()
        - chain_omega_10_squared * (chain_theta_8 - chain_theta_10).sin();
    let t15 = -(R::literal(19.62) * chain_theta_9.sin())
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_9 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_9 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_9 - chain_theta_3).sin()
        - R::literal(2.0) * chain_omega_4_squared
            * (chain_theta_9 - chain_theta_4).sin();
    let chain_theta_9_forcing = t15
        - R::literal(2.0) * chain_omega_5_squared * (chain_theta_9 - chain_theta_5).sin()
        - R::literal(2.0) * chain_omega_6_squared * (chain_theta_9 - chain_theta_6).sin()
        - R::literal(2.0) * chain_omega_7_squared * (chain_theta_9 - chain_theta_7).sin()
        - R::literal(2.0) * chain_omega_8_squared * (chain_theta_9 - chain_theta_8).sin()
        - chain_omega_10_squared * (chain_theta_9 - chain_theta_10).sin();
    let t16 = -(R::literal(9.81) * chain_theta_10.sin())
        - chain_omega_1_squared * (chain_theta_10 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_10 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_10 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_10 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_10 - chain_theta_5).sin();
    let chain_theta_10_forcing = t16
        - chain_omega_6_squared * (chain_theta_10 - chain_theta_6).sin()
        - chain_omega_7_squared * (chain_theta_10 - chain_theta_7).sin()
        - chain_omega_8_squared * (chain_theta_10 - chain_theta_8).sin()
        - chain_omega_9_squared * (chain_theta_10 - chain_theta_9).sin();
    [
        chain_theta_1_forcing,
        chain_theta_2_forcing,
        chain_theta_3_forcing,
        chain_theta_4_forcing,
        chain_theta_5_forcing,
        chain_theta_6_forcing,
        chain_theta_7_forcing,
        chain_theta_8_forcing,
        chain_theta_9_forcing,
        chain_theta_10_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 5586 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 210] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = chain_theta_1_minus_chain_theta_2.cos();
    let t1 = R::literal(9.0) * t0;
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t2 = chain_theta_1_minus_chain_theta_3.cos();
    let t3 = R::literal(8.0) * t2;
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t4 = chain_theta_1_minus_chain_theta_4.cos();
    let t5 = R::literal(7.0) * t4;
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t6 = chain_theta_1_minus_chain_theta_5.cos();
    let t7 = R::literal(6.0) * t6;
    let chain_theta_1_minus_chain_theta_6 = chain_theta_1 - chain_theta_6;
    let t8 = chain_theta_1_minus_chain_theta_6.cos();
    let t9 = R::literal(5.0) * t8;
    let chain_theta_1_minus_chain_theta_7 = chain_theta_1 - chain_theta_7;
    let t10 = chain_theta_1_minus_chain_theta_7.cos();
    let t11 = R::literal(4.0) * t10;
    let chain_theta_1_minus_chain_theta_8 = chain_theta_1 - chain_theta_8;
    let t12 = chain_theta_1_minus_chain_theta_8.cos();
    let t13 = R::literal(3.0) * t12;
    let chain_theta_1_minus_chain_theta_9 = chain_theta_1 - chain_theta_9;
    let t14 = chain_theta_1_minus_chain_theta_9.cos();
    let t15 = R::literal(2.0) * t14;
    let chain_theta_1_minus_chain_theta_10 = chain_theta_1 - chain_theta_10;
    let t16 = chain_theta_1_minus_chain_theta_10.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let t17 = chain_theta_2_minus_chain_theta_3.cos();
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let t18 = chain_theta_2_minus_chain_theta_4.cos();
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let t19 = chain_theta_2_minus_chain_theta_5.cos();
    let chain_theta_2_minus_chain_theta_6 = chain_theta_2 - chain_theta_6;
    let t20 = chain_theta_2_minus_chain_theta_6.cos();
    let chain_theta_2_minus_chain_theta_7 = chain_theta_2 - chain_theta_7;
    let t21 = chain_theta_2_minus_chain_theta_7.cos();
    let chain_theta_2_minus_chain_theta_8 = chain_theta_2 - chain_theta_8;
    let t22 = chain_theta_2_minus_chain_theta_8.cos();
    let chain_theta_2_minus_chain_theta_9 = chain_theta_2 - chain_theta_9;
    let t23 = chain_theta_2_minus_chain_theta_9.cos();
    let chain_theta_2_minus_chain_theta_10 = chain_theta_2 - chain_theta_10;
    let t24 = chain_theta_2_minus_chain_theta_10.cos();
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let t25 = chain_theta_3_minus_chain_theta_4.cos();
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let t26 = chain_theta_3_minus_chain_theta_5.cos();
    let chain_theta_3_minus_chain_theta_6 = chain_theta_3 - chain_theta_6;
    let t27 = chain_theta_3_minus_chain_theta_6.cos();
    let chain_theta_3_minus_chain_theta_7 = chain_theta_3 - chain_theta_7;
    let t28 = chain_theta_3_minus_chain_theta_7.cos();
    let chain_theta_3_minus_chain_theta_8 = chain_theta_3 - chain_theta_8;
    let t29 = chain_theta_3_minus_chain_theta_8.cos();
    let chain_theta_3_minus_chain_theta_9 = chain_theta_3 - chain_theta_9;
    let t30 = chain_theta_3_minus_chain_theta_9.cos();
    let chain_theta_3_minus_chain_theta_10 = chain_theta_3 - chain_theta_10;
    let t31 = chain_theta_3_minus_chain_theta_10.cos();
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let t32 = chain_theta_4_minus_chain_theta_5.cos();
    let chain_theta_4_minus_chain_theta_6 = chain_theta_4 - chain_theta_6;
    let t33 = chain_theta_4_minus_chain_theta_6.cos();
    let chain_theta_4_minus_chain_theta_7 = chain_theta_4 - chain_theta_7;
    let t34 = chain_theta_4_minus_chain_theta_7.cos();
    let chain_theta_4_minus_chain_theta_8 = chain_theta_4 - chain_theta_8;
    let t35 = chain_theta_4_minus_chain_theta_8.cos();
    let chain_theta_4_minus_chain_theta_9 = chain_theta_4 - chain_theta_9;
    let t36 = chain_theta_4_minus_chain_theta_9.cos();
    let chain_theta_4_minus_chain_theta_10 = chain_theta_4 - chain_theta_10;
    let t37 = chain_theta_4_minus_chain_theta_10.cos();
    let chain_theta_5_minus_chain_theta_6 = chain_theta_5 - chain_theta_6;
    let t38 = chain_theta_5_minus_chain_theta_6.cos();
    let chain_theta_5_minus_chain_theta_7 = chain_theta_5 - chain_theta_7;
    let t39 = chain_theta_5_minus_chain_theta_7.cos();
    let chain_theta_5_minus_chain_theta_8 = chain_theta_5 - chain_theta_8;
    let t40 = chain_theta_5_minus_chain_theta_8.cos();
    let chain_theta_5_minus_chain_theta_9 = chain_theta_5 - chain_theta_9;
    let t41 = chain_theta_5_minus_chain_theta_9.cos();
    let chain_theta_5_minus_chain_theta_10 = chain_theta_5 - chain_theta_10;
    let t42 = chain_theta_5_minus_chain_theta_10.cos();
    let chain_theta_6_minus_chain_theta_7 = chain_theta_6 - chain_theta_7;
    let t43 = chain_theta_6_minus_chain_theta_7.cos();
    let chain_theta_6_minus_chain_theta_8 = chain_theta_6 - chain_theta_8;
    let t44 = chain_theta_6_minus_chain_theta_8.cos();
    let chain_theta_6_minus_chain_theta_9 = chain_theta_6 - chain_theta_9;
    let t45 = chain_theta_6_minus_chain_theta_9.cos();
    let chain_theta_6_minus_chain_theta_10 = chain_theta_6 - chain_theta_10;
    let t46 = chain_theta_6_minus_chain_theta_10.cos();
    let chain_theta_7_minus_chain_theta_8 = chain_theta_7 - chain_theta_8;
    let t47 = chain_theta_7_minus_chain_theta_8.cos();
    let chain_theta_7_minus_chain_theta_9 = chain_theta_7 - chain_theta_9;
    let t48 = chain_theta_7_minus_chain_theta_9.cos();
    let chain_theta_7_minus_chain_theta_10 = chain_theta_7 - chain_theta_10;
    let t49 = chain_theta_7_minus_chain_theta_10.cos();
    let chain_theta_8_minus_chain_theta_9 = chain_theta_8 - chain_theta_9;
    let t50 = chain_theta_8_minus_chain_theta_9.cos();
    let chain_theta_8_minus_chain_theta_10 = chain_theta_8 - chain_theta_10;
    let t51 = chain_theta_8_minus_chain_theta_10.cos();
    let chain_theta_9_minus_chain_theta_10 = chain_theta_9 - chain_theta_10;
    let t52 = chain_theta_9_minus_chain_theta_10.cos();
    let t53 = t1 * R::literal(0.1);
    let t54 = t3 * R::literal(0.1);
    let t55 = t5 * R::literal(0.1);
    let t56 = t7 * R::literal(0.1);
    let t57 = t9 * R::literal(0.1);
    let t58 = t11 * R::literal(0.1);
    let t59 = t13 * R::literal(0.1);
    let t60 = t15 * R::literal(0.1);
    let t61 = t16 * R::literal(0.1);
    let t62 = R::literal(1.0) / (R::literal(9.0) - t53 * t1);
    let t63 = R::literal(8.0) * t17 - t54 * t1;
    let t64 = t63 * t62;
    let t65 = R::literal(7.0) * t18 - t55 * t1;
    let t66 = t65 * t62;
    let t67 = R::literal(6.0) * t19 - t56 * t1;
    let t68 = t67 * t62;
    let t69 = R::literal(5.0) * t20 - t57 * t1;
    let t70 = t69 * t62;
    let t71 = R::literal(4.0) * t21 - t58 * t1;
    let t72 = t71 * t62;
    let t73 = R::literal(3.0) * t22 - t59 * t1;
    let t74 = t73 * t62;
    let t75 = R::literal(2.0) * t23 - t60 * t1;
    let t76 = t75 * t62;
    let t77 = t24 - t61 * t1;
    let t78 = t77 * t62;
    let t79 = R::literal(1.0) / (R::literal(8.0) - t54 * t3 - t64 * t63);
    let t80 = R::literal(7.0) * t25 - t55 * t3 - t66 * t63;
    let t81 = t80 * t79;
    let t82 = R::literal(6.0) * t26 - t56 * t3 - t68 * t63;
    let t83 = t82 * t79;
    let t84 = R::literal(5.0) * t27 - t57 * t3 - t70 * t63;
    let t85 = t84 * t79;
    let t86 = R::literal(4.0) * t28 - t58 * t3 - t72 * t63;
    let t87 = t86 * t79;
    let t88 = R::literal(3.0) * t29 - t59 * t3 - t74 * t63;
    let t89 = t88 * t79;
    let t90 = R::literal(2.0) * t30 - t60 * t3 - t76 * t63;
    let t91 = t90 * t79;
    let t92 = t31 - t61 * t3 - t78 * t63;
    let t93 = t92 * t79;
    let t94 = R::literal(1.0) / (R::literal(7.0) - t55 * t5 - t66 * t65 - t81 * t80);
    let t95 = R::literal(6.0) * t32 - t56 * t5 - t68 * t65 - t83 * t80;
    let t96 = t95 * t94;
    let t97 = R::literal(5.0) * t33 - t57 * t5 - t70 * t65 - t85 * t80;
    let t98 = t97 * t94;
    let t99 = R::literal(4.0) * t34 - t58 * t5 - t72 * t65 - t87 * t80;
    let t100 = t99 * t94;
    let t101 = R::literal(3.0) * t35 - t59 * t5 - t74 * t65 - t89 * t80;
    let t102 = t101 * t94;
    let t103 = R::literal(2.0) * t36 - t60 * t5 - t76 * t65 - t91 * t80;
    let t104 = t103 * t94;
    let t105 = t37 - t61 * t5 - t78 * t65 - t93 * t80;
    let t106 = t105 * t94;
    let t107 = R::literal(1.0)
        / (R::literal(6.0) - t56 * t7 - t68 * t67 - t83 * t82 - t96 * t95);
    let t108 = R::literal(5.0) * t38 - t57 * t7 - t70 * t67 - t85 * t82 - t98 * t95;
    let t109 = t108 * t107;
    let t110 = R::literal(4.0) * t39 - t58 * t7 - t72 * t67 - t87 * t82 - t100 * t95;
    let t111 = t110 * t107;
    let t112 = R::literal(3.0) * t40 - t59 * t7 - t74 * t67 - t89 * t82 - t102 * t95;
    let t113 = t112 * t107;
    let t114 = R::literal(2.0) * t41 - t60 * t7 - t76 * t67 - t91 * t82 - t104 * t95;
    let t115 = t114 * t107;
    let t116 = t42 - t61 * t7 - t78 * t67 - t93 * t82 - t106 * t95;
    let t117 = t116 * t107;
    let t118 = R::literal(1.0)
        / (R::literal(5.0) - t57 * t9 - t70 * t69 - t85 * t84 - t98 * t97 - t109 * t108);
    let t119 = R::literal(4.0) * t43 - t58 * t9 - t72 * t69 - t87 * t84 - t100 * t97
        - t111 * t108;
    let t120 = t119 * t118;
    let t121 = R::literal(3.0) * t44 - t59 * t9 - t74 * t69 - t89 * t84 - t102 * t97
        - t113 * t108;
    let t122 = t121 * t118;
    let t123 = R::literal(2.0) * t45 - t60 * t9 - t76 * t69 - t91 * t84 - t104 * t97
        - t115 * t108;
    let t124 = t123 * t118;
    let t125 = t46 - t61 * t9 - t78 * t69 - t93 * t84 - t106 * t97 - t117 * t108;
    let t126 = t125 * t118;
    let t127 = R::literal(1.0)
        / (R::literal(4.0) - t58 * t11 - t72 * t71 - t87 * t86 - t100 * t99 - t111 * t110
            - t120 * t119);
    let t128 = R::literal(3.0) * t47 - t59 * t11 - t74 * t71 - t89 * t86 - t102 * t99
        - t113 * t110 - t122 * t119;
    let t129 = t128 * t127;
    let t130 = R::literal(2.0) * t48 - t60 * t11 - t76 * t71 - t91 * t86 - t104 * t99
        - t115 * t110 - t124 * t119;
    let t131 = t130 * t127;
    let t132 = t49 - t61 * t11 - t78 * t71 - t93 * t86 - t106 * t99 - t117 * t110
        - t126 * t119;
    let t133 = t132 * t127;
    let t134 = R::literal(1.0)
        / (R::literal(3.0) - t59 * t13 - t74 * t73 - t89 * t88 - t102 * t101
            - t113 * t112 - t122 * t121 - t129 * t128);
    let t135 = R::literal(2.0) * t50 - t60 * t13 - t76 * t73 - t91 * t88 - t104 * t101
        - t115 * t112 - t124 * t121 - t131 * t128;
    let t136 = t135 * t134;
    let t137 = t51 - t61 * t13 - t78 * t73 - t93 * t88 - t106 * t101 - t117 * t112
        - t126 * t121 - t133 * t128;
    let t138 = t137 * t134;
    let t139 = R::literal(1.0)
        / (R::literal(2.0) - t60 * t15 - t76 * t75 - t91 * t90 - t104 * t103
            - t115 * t114 - t124 * t123 - t131 * t130 - t136 * t135);
    let t140 = t52 - t61 * t15 - t78 * t75 - t93 * t90 - t106 * t103 - t117 * t114
        - t126 * t123 - t133 * t130 - t138 * t135;
    let t141 = t140 * t139;
    let t142 = R::literal(1.0)
        / (R::literal(1.0) - t61 * t16 - t78 * t77 - t93 * t92 - t106 * t105
            - t117 * t116 - t126 * t125 - t133 * t132 - t138 * t137 - t141 * t140);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t143 = chain_theta_1_minus_chain_theta_2.sin();
    let t144 = R::literal(9.0) * chain_omega_2_squared;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t145 = chain_theta_1_minus_chain_theta_3.sin();
    let t146 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t147 = chain_theta_1_minus_chain_theta_4.sin();
    let t148 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t149 = chain_theta_1_minus_chain_theta_5.sin();
    let t150 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t151 = chain_theta_1_minus_chain_theta_6.sin();
    let t152 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t153 = chain_theta_1_minus_chain_theta_7.sin();
    let t154 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t155 = chain_theta_1_minus_chain_theta_8.sin();
    let t156 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t157 = chain_theta_1_minus_chain_theta_9.sin();
    let t158 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t159 = chain_theta_1_minus_chain_theta_10.sin();
    let t160 = -(R::literal(98.1) * chain_theta_1.sin()) - t144 * t143 - t146 * t145
        - t148 * t147 - t150 * t149 - t152 * t151 - t154 * t153 - t156 * t155
        - t158 * t157 - chain_omega_10_squared * t159;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_minus_chain_theta_1 = chain_theta_2 - chain_theta_1;
    let t161 = chain_theta_2_minus_chain_theta_1.sin();
    let t162 = R::literal(9.0) * chain_omega_1_squared;
    let t163 = chain_theta_2_minus_chain_theta_3.sin();
    let t164 = chain_theta_2_minus_chain_theta_4.sin();
    let t165 = chain_theta_2_minus_chain_theta_5.sin();
    let t166 = chain_theta_2_minus_chain_theta_6.sin();
    let t167 = chain_theta_2_minus_chain_theta_7.sin();
    let t168 = chain_theta_2_minus_chain_theta_8.sin();
    let t169 = chain_theta_2_minus_chain_theta_9.sin();
    let t170 = chain_theta_2_minus_chain_theta_10.sin();
    let chain_theta_3_minus_chain_theta_1 = chain_theta_3 - chain_theta_1;
    let t171 = chain_theta_3_minus_chain_theta_1.sin();
    let t172 = R::literal(8.0) * chain_omega_1_squared;
    let chain_theta_3_minus_chain_theta_2 = chain_theta_3 - chain_theta_2;
    let t173 = chain_theta_3_minus_chain_theta_2.sin();
    let t174 = R::literal(8.0) * chain_omega_2_squared;
    let t175 = chain_theta_3_minus_chain_theta_4.sin();
    let t176 = chain_theta_3_minus_chain_theta_5.sin();
    let t177 = chain_theta_3_minus_chain_theta_6.sin();
    let t178 = chain_theta_3_minus_chain_theta_7.sin();
    let t179 = chain_theta_3_minus_chain_theta_8.sin();
    let t180 = chain_theta_3_minus_chain_theta_9.sin();
    let t181 = chain_theta_3_minus_chain_theta_10.sin();
    let chain_theta_4_minus_chain_theta_1 = chain_theta_4 - chain_theta_1;
    let t182 = chain_theta_4_minus_chain_theta_1.sin();
    let t183 = R::literal(7.0) * chain_omega_1_squared;
    let chain_theta_4_minus_chain_theta_2 = chain_theta_4 - chain_theta_2;
    let t184 = chain_theta_4_minus_chain_theta_2.sin();
    let t185 = R::literal(7.0) * chain_omega_2_squared;
    let chain_theta_4_minus_chain_theta_3 = chain_theta_4 - chain_theta_3;
    let t186 = chain_theta_4_minus_chain_theta_3.sin();
    let t187 = R::literal(7.0) * chain_omega_3_squared;
    let t188 = chain_theta_4_minus_chain_theta_5.sin();
    let t189 = chain_theta_4_minus_chain_theta_6.sin();
    let t190 = chain_theta_4_minus_chain_theta_7.sin();
    let t191 = chain_theta_4_minus_chain_theta_8.sin();
    let t192 = chain_theta_4_minus_chain_theta_9.sin();
    let t193 = chain_theta_4_minus_chain_theta_10.sin();
    let chain_theta_5_minus_chain_theta_1 = chain_theta_5 - chain_theta_1;
    let t194 = chain_theta_5_minus_chain_theta_1.sin();
    let t195 = R::literal(6.0) * chain_omega_1_squared;
    let chain_theta_5_minus_chain_theta_2 = chain_theta_5 - chain_theta_2;
    let t196 = chain_theta_5_minus_chain_theta_2.sin();
    let t197 = R::literal(6.0) * chain_omega_2_squared;
    let chain_theta_5_minus_chain_theta_3 = chain_theta_5 - chain_theta_3;
    let t198 = chain_theta_5_minus_chain_theta_3.sin();
    let t199 = R::literal(6.0) * chain_omega_3_squared;
    let chain_theta_5_minus_chain_theta_4 = chain_theta_5 - chain_theta_4;
    let t200 = chain_theta_5_minus_chain_theta_4.sin();
    let t201 = R::literal(6.0) * chain_omega_4_squared;
    let t202 = chain_theta_5_minus_chain_theta_6.sin();
    let t203 = chain_theta_5_minus_chain_theta_7.sin();
    let t204 = chain_theta_5_minus_chain_theta_8.sin();
    let t205 = chain_theta_5_minus_chain_theta_9.sin();
    let t206 = chain_theta_5_minus_chain_theta_10.sin();
    let chain_theta_6_minus_chain_theta_1 = chain_theta_6 - chain_theta_1;
    let t207 = chain_theta_6_minus_chain_theta_1.sin();
    let t208 = R::literal(5.0) * chain_omega_1_squared;
    let chain_theta_6_minus_chain_theta_2 = chain_theta_6 - chain_theta_2;
    let t209 = chain_theta_6_minus_chain_theta_2.sin();
    let t210 = R::literal(5.0) * chain_omega_2_squared;
    let chain_theta_6_minus_chain_theta_3 = chain_theta_6 - chain_theta_3;
    let t211 = chain_theta_6_minus_chain_theta_3.sin();
    let t212 = R::literal(5.0) * chain_omega_3_squared;
    let chain_theta_6_minus_chain_theta_4 = chain_theta_6 - chain_theta_4;
    let t213 = chain_theta_6_minus_chain_theta_4.sin();
    let t214 = R::literal(5.0) * chain_omega_4_squared;
    let chain_theta_6_minus_chain_theta_5 = chain_theta_6 - chain_theta_5;
    let t215 = chain_theta_6_minus_chain_theta_5.sin();
    let t216 = R::literal(5.0) * chain_omega_5_squared;
    let t217 = chain_theta_6_minus_chain_theta_7.sin();
    let t218 = chain_theta_6_minus_chain_theta_8.sin();
    let t219 = chain_theta_6_minus_chain_theta_9.sin();
    let t220 = chain_theta_6_minus_chain_theta_10.sin();
    let chain_theta_7_minus_chain_theta_1 = chain_theta_7 - chain_theta_1;
    let t221 = chain_theta_7_minus_chain_theta_1.sin();
    let t222 = R::literal(4.0) * chain_omega_1_squared;
    let chain_theta_7_minus_chain_theta_2 = chain_theta_7 - chain_theta_2;
    let t223 = chain_theta_7_minus_chain_theta_2.sin();
    let t224 = R::literal(4.0) * chain_omega_2_squared;
    let chain_theta_7_minus_chain_theta_3 = chain_theta_7 - chain_theta_3;
    let t225 = chain_theta_7_minus_chain_theta_3.sin();
    let t226 = R::literal(4.0) * chain_omega_3_squared;
    let chain_theta_7_minus_chain_theta_4 = chain_theta_7 - chain_theta_4;
    let t227 = chain_theta_7_minus_chain_theta_4.sin();
    let t228 = R::literal(4.0) * chain_omega_4_squared;
    let chain_theta_7_minus_chain_theta_5 = chain_theta_7 - chain_theta_5;
    let t229 = chain_theta_7_minus_chain_theta_5.sin();
    let t230 = R::literal(4.0) * chain_omega_5_squared;
    let chain_theta_7_minus_chain_theta_6 = chain_theta_7 - chain_theta_6;
    let t231 = chain_theta_7_minus_chain_theta_6.sin();
    let t232 = R::literal(4.0) * chain_omega_6_squared;
    let t233 = chain_theta_7_minus_chain_theta_8.sin();
    let t234 = chain_theta_7_minus_chain_theta_9.sin();
    let t235 = chain_theta_7_minus_chain_theta_10.sin();
    let chain_theta_8_minus_chain_theta_1 = chain_theta_8 - chain_theta_1;
    let t236 = chain_theta_8_minus_chain_theta_1.sin();
    let t237 = R::literal(3.0) * chain_omega_1_squared;
    let chain_theta_8_minus_chain_theta_2 = chain_theta_8 - chain_theta_2;
    let t238 = chain_theta_8_minus_chain_theta_2.sin();
    let t239 = R::literal(3.0) * chain_omega_2_squared;
    let chain_theta_8_minus_chain_theta_3 = chain_theta_8 - chain_theta_3;
    let t240 = chain_theta_8_minus_chain_theta_3.sin();
    let t241 = R::literal(3.0) * chain_omega_3_squared;
    let chain_theta_8_minus_chain_theta_4 = chain_theta_8 - chain_theta_4;
    let t242 = chain_theta_8_minus_chain_theta_4.sin();
    let t243 = R::literal(3.0) * chain_omega_4_squared;
    let chain_theta_8_minus_chain_theta_5 = chain_theta_8 - chain_theta_5;
    let t244 = chain_theta_8_minus_chain_theta_5.sin();
    let t245 = R::literal(3.0) * chain_omega_5_squared;
    let chain_theta_8_minus_chain_theta_6 = chain_theta_8 - chain_theta_6;
    let t246 = chain_theta_8_minus_chain_theta_6.sin();
    let t247 = R::literal(3.0) * chain_omega_6_squared;
    let chain_theta_8_minus_chain_theta_7 = chain_theta_8 - chain_theta_7;
    let t248 = chain_theta_8_minus_chain_theta_7.sin();
    let t249 = R::literal(3.0) * chain_omega_7_squared;
    let t250 = chain_theta_8_minus_chain_theta_9.sin();
    let t251 = chain_theta_8_minus_chain_theta_10.sin();
    let chain_theta_9_minus_chain_theta_1 = chain_theta_9 - chain_theta_1;
    let t252 = chain_theta_9_minus_chain_theta_1.sin();
    let t253 = R::literal(2.0) * chain_omega_1_squared;
    let chain_theta_9_minus_chain_theta_2 = chain_theta_9 - chain_theta_2;
    let t254 = chain_theta_9_minus_chain_theta_2.sin();
    let t255 = R::literal(2.0) * chain_omega_2_squared;
    let chain_theta_9_minus_chain_theta_3 = chain_theta_9 - chain_theta_3;
    let t256 = chain_theta_9_minus_chain_theta_3.sin();
    let t257 = R::literal(2.0) * chain_omega_3_squared;
    let chain_theta_9_minus_chain_theta_4 = chain_theta_9 - chain_theta_4;
    let t258 = chain_theta_9_minus_chain_theta_4.sin();
    let t259 = R::literal(2.0) * chain_omega_4_squared;
    let chain_theta_9_minus_chain_theta_5 = chain_theta_9 - chain_theta_5;
    let t260 = chain_theta_9_minus_chain_theta_5.sin();
    let t261 = R::literal(2.0) * chain_omega_5_squared;
    let chain_theta_9_minus_chain_theta_6 = chain_theta_9 - chain_theta_6;
    let t262 = chain_theta_9_minus_chain_theta_6.sin();
    let t263 = R::literal(2.0) * chain_omega_6_squared;
    let chain_theta_9_minus_chain_theta_7 = chain_theta_9 - chain_theta_7;
    let t264 = chain_theta_9_minus_chain_theta_7.sin();
    let t265 = R::literal(2.0) * chain_omega_7_squared;
    let chain_theta_9_minus_chain_theta_8 = chain_theta_9 - chain_theta_8;
    let t266 = chain_theta_9_minus_chain_theta_8.sin();
    let t267 = R::literal(2.0) * chain_omega_8_squared;
    let t268 = chain_theta_9_minus_chain_theta_10.sin();
    let chain_theta_10_minus_chain_theta_1 = chain_theta_10 - chain_theta_1;
    let t269 = chain_theta_10_minus_chain_theta_1.sin();
    let chain_theta_10_minus_chain_theta_2 = chain_theta_10 - chain_theta_2;
    let t270 = chain_theta_10_minus_chain_theta_2.sin();
    let chain_theta_10_minus_chain_theta_3 = chain_theta_10 - chain_theta_3;
    let t271 = chain_theta_10_minus_chain_theta_3.sin();
    let chain_theta_10_minus_chain_theta_4 = chain_theta_10 - chain_theta_4;
    let t272 = chain_theta_10_minus_chain_theta_4.sin();
    let chain_theta_10_minus_chain_theta_5 = chain_theta_10 - chain_theta_5;
    let t273 = chain_theta_10_minus_chain_theta_5.sin();
    let chain_theta_10_minus_chain_theta_6 = chain_theta_10 - chain_theta_6;
    let t274 = chain_theta_10_minus_chain_theta_6.sin();
    let chain_theta_10_minus_chain_theta_7 = chain_theta_10 - chain_theta_7;
    let t275 = chain_theta_10_minus_chain_theta_7.sin();
    let chain_theta_10_minus_chain_theta_8 = chain_theta_10 - chain_theta_8;
    let t276 = chain_theta_10_minus_chain_theta_8.sin();
    let chain_theta_10_minus_chain_theta_9 = chain_theta_10 - chain_theta_9;
    let t277 = chain_theta_10_minus_chain_theta_9.sin();
    let t278 = -(R::literal(88.29) * chain_theta_2.sin()) - t162 * t161 - t146 * t163
        - t148 * t164 - t150 * t165 - t152 * t166 - t154 * t167 - t156 * t168
        - t158 * t169 - chain_omega_10_squared * t170 - t53 * t160;
    let t279 = -(R::literal(78.48) * chain_theta_3.sin()) - t172 * t171 - t174 * t173
        - t148 * t175 - t150 * t176 - t152 * t177 - t154 * t178 - t156 * t179
        - t158 * t180 - chain_omega_10_squared * t181 - t54 * t160;
    let t280 = t279 - t64 * t278;
    let t281 = -(R::literal(68.67) * chain_theta_4.sin()) - t183 * t182 - t185 * t184
        - t187 * t186 - t150 * t188 - t152 * t189 - t154 * t190 - t156 * t191
        - t158 * t192 - chain_omega_10_squared * t193 - t55 * t160;
    let t282 = t281 - t66 * t278 - t81 * t280;
    let t283 = -(R::literal(58.86) * chain_theta_5.sin()) - t195 * t194 - t197 * t196
        - t199 * t198 - t201 * t200 - t152 * t202 - t154 * t203 - t156 * t204
        - t158 * t205 - chain_omega_10_squared * t206 - t56 * t160;
    let t284 = t283 - t68 * t278 - t83 * t280 - t96 * t282;
    let t285 = -(R::literal(49.05) * chain_theta_6.sin()) - t208 * t207 - t210 * t209
        - t212 * t211 - t214 * t213 - t216 * t215 - t154 * t217 - t156 * t218
        - t158 * t219 - chain_omega_10_squared * t220 - t57 * t160;
    let t286 = t285 - t70 * t278 - t85 * t280 - t98 * t282 - t109 * t284;
    let t287 = -(R::literal(39.24) * chain_theta_7.sin()) - t222 * t221 - t224 * t223
        - t226 * t225 - t228 * t227 - t230 * t229 - t232 * t231 - t156 * t233
        - t158 * t234 - chain_omega_10_squared * t235 - t58 * t160;
    let t288 = t287 - t72 * t278 - t87 * t280 - t100 * t282 - t111 * t284 - t120 * t286;
    let t289 = -(R::literal(29.43) * chain_theta_8.sin()) - t237 * t236 - t239 * t238
        - t241 * t240 - t243 * t242 - t245 * t244 - t247 * t246 - t249 * t248
        - t158 * t250 - chain_omega_10_squared * t251 - t59 * t160;
    let t290 = t289 - t74 * t278 - t89 * t280 - t102 * t282 - t113 * t284 - t122 * t286
        - t129 * t288;
    let t291 = -(R::literal(19.62) * chain_theta_9.sin()) - t253 * t252 - t255 * t254
        - t257 * t256 - t259 * t258 - t261 * t260 - t263 * t262 - t265 * t264
        - t267 * t266 - chain_omega_10_squared * t268 - t60 * t160;
    let t292 = t291 - t76 * t278 - t91 * t280 - t104 * t282 - t115 * t284 - t124 * t286
        - t131 * t288 - t136 * t290;
    let t293 = -(R::literal(9.81) * chain_theta_10.sin()) - chain_omega_1_squared * t269
        - chain_omega_2_squared * t270 - chain_omega_3_squared * t271
        - chain_omega_4_squared * t272 - chain_omega_5_squared * t273
        - chain_omega_6_squared * t274 - chain_omega_7_squared * t275
        - chain_omega_8_squared * t276 - chain_omega_9_squared * t277 - t61 * t160;
    let chain_omega_10_dot = (t293 - t78 * t278 - t93 * t280 - t106 * t282 - t117 * t284
        - t126 * t286 - t133 * t288 - t138 * t290 - t141 * t292) * t142;
    let chain_omega_9_dot = t292 * t139 - t141 * chain_omega_10_dot;
    let chain_omega_8_dot = t290 * t134 - t136 * chain_omega_9_dot
        - t138 * chain_omega_10_dot;
    let chain_omega_7_dot = t288 * t127 - t129 * chain_omega_8_dot
        - t131 * chain_omega_9_dot - t133 * chain_omega_10_dot;
    let chain_omega_6_dot = t286 * t118 - t120 * chain_omega_7_dot
        - t122 * chain_omega_8_dot - t124 * chain_omega_9_dot
        - t126 * chain_omega_10_dot;
    let chain_omega_5_dot = t284 * t107 - t109 * chain_omega_6_dot
        - t111 * chain_omega_7_dot - t113 * chain_omega_8_dot - t115 * chain_omega_9_dot
        - t117 * chain_omega_10_dot;
    let chain_omega_4_dot = t282 * t94 - t96 * chain_omega_5_dot
        - t98 * chain_omega_6_dot - t100 * chain_omega_7_dot - t102 * chain_omega_8_dot
        - t104 * chain_omega_9_dot - t106 * chain_omega_10_dot;
    let chain_omega_3_dot = t280 * t79 - t81 * chain_omega_4_dot
        - t83 * chain_omega_5_dot - t85 * chain_omega_6_dot - t87 * chain_omega_7_dot
        - t89 * chain_omega_8_dot - t91 * chain_omega_9_dot - t93 * chain_omega_10_dot;
    let chain_omega_2_dot = t278 * t62 - t64 * chain_omega_3_dot
        - t66 * chain_omega_4_dot - t68 * chain_omega_5_dot - t70 * chain_omega_6_dot
        - t72 * chain_omega_7_dot - t74 * chain_omega_8_dot - t76 * chain_omega_9_dot
        - t78 * chain_omega_10_dot;
    let chain_omega_1_dot = t160 * R::literal(0.1) - t53 * chain_omega_2_dot
        - t54 * chain_omega_3_dot - t55 * chain_omega_4_dot - t56 * chain_omega_5_dot
        - t57 * chain_omega_6_dot - t58 * chain_omega_7_dot - t59 * chain_omega_8_dot
        - t60 * chain_omega_9_dot - t61 * chain_omega_10_dot;
    let t294 = t144 * t0;
    let t295 = t146 * t2;
    let t296 = t148 * t4;
    let t297 = t150 * t6;
    let t298 = t152 * t8;
    let t299 = t154 * t10;
    let t300 = t156 * t12;
    let t301 = t158 * t14;
    let t302 = chain_omega_10_squared * t16;
    let t303 = t162 * chain_theta_2_minus_chain_theta_1.cos();
    let t304 = t172 * chain_theta_3_minus_chain_theta_1.cos();
    let t305 = t183 * chain_theta_4_minus_chain_theta_1.cos();
    let t306 = t195 * chain_theta_5_minus_chain_theta_1.cos();
    let t307 = t208 * chain_theta_6_minus_chain_theta_1.cos();
    let t308 = t222 * chain_theta_7_minus_chain_theta_1.cos();
    let t309 = t237 * chain_theta_8_minus_chain_theta_1.cos();
    let t310 = t253 * chain_theta_9_minus_chain_theta_1.cos();
    let t311 = chain_omega_1_squared * chain_theta_10_minus_chain_theta_1.cos();
    let t312 = R::literal(9.0) * t143;
    let t313 = t312 * chain_omega_2_dot;
    let t314 = t312 * chain_omega_1_dot;
    let t315 = R::literal(8.0) * t145;
    let t316 = t315 * chain_omega_3_dot;
    let t317 = t315 * chain_omega_1_dot;
    let t318 = R::literal(7.0) * t147;
    let t319 = t318 * chain_omega_4_dot;
    let t320 = t318 * chain_omega_1_dot;
    let t321 = R::literal(6.0) * t149;
    let t322 = t321 * chain_omega_5_dot;
    let t323 = t321 * chain_omega_1_dot;
    let t324 = R::literal(5.0) * t151;
    let t325 = t324 * chain_omega_6_dot;
    let t326 = t324 * chain_omega_1_dot;
    let t327 = R::literal(4.0) * t153;
    let t328 = t327 * chain_omega_7_dot;
    let t329 = t327 * chain_omega_1_dot;
    let t330 = R::literal(3.0) * t155;
    let t331 = t330 * chain_omega_8_dot;
    let t332 = t330 * chain_omega_1_dot;
    let t333 = R::literal(2.0) * t157;
    let t334 = t333 * chain_omega_9_dot;
    let t335 = t333 * chain_omega_1_dot;
    let t336 = t159 * chain_omega_10_dot;
    let t337 = -(R::literal(98.1) * chain_theta_1.cos()) - t294 - t295 - t296 - t297
        - t298 - t299 - t300 - t301 - t302 + t313 + t316 + t319 + t322 + t325 + t328
        + t331 + t334 + t336;
    let t338 = t159 * chain_omega_1_dot;
    let t339 = t303 + t314 - t53 * t337;
    let t340 = t304 + t317 - t54 * t337 - t64 * t339;
    let t341 = t305 + t320 - t55 * t337 - t66 * t339 - t81 * t340;
    let t342 = t306 + t323 - t56 * t337 - t68 * t339 - t83 * t340 - t96 * t341;
    let t343 = t307 + t326 - t57 * t337 - t70 * t339 - t85 * t340 - t98 * t341
        - t109 * t342;
    let t344 = t308 + t329 - t58 * t337 - t72 * t339 - t87 * t340 - t100 * t341
        - t111 * t342 - t120 * t343;
    let t345 = t309 + t332 - t59 * t337 - t74 * t339 - t89 * t340 - t102 * t341
        - t113 * t342 - t122 * t343 - t129 * t344;
    let t346 = t310 + t335 - t60 * t337 - t76 * t339 - t91 * t340 - t104 * t341
        - t115 * t342 - t124 * t343 - t131 * t344 - t136 * t345;
    let chain_omega_10_dot_by_chain_theta_1 = (t311 + t338 - t61 * t337 - t78 * t339
        - t93 * t340 - t106 * t341 - t117 * t342 - t126 * t343 - t133 * t344
        - t138 * t345 - t141 * t346) * t142;
    let chain_omega_9_dot_by_chain_theta_1 = t346 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_8_dot_by_chain_theta_1 = t345 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_1
        - t138 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_7_dot_by_chain_theta_1 = t344 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_1
        - t131 * chain_omega_9_dot_by_chain_theta_1
        - t133 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_6_dot_by_chain_theta_1 = t343 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_1
        - t122 * chain_omega_8_dot_by_chain_theta_1
        - t124 * chain_omega_9_dot_by_chain_theta_1
        - t126 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_5_dot_by_chain_theta_1 = t342 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_1
        - t111 * chain_omega_7_dot_by_chain_theta_1
        - t113 * chain_omega_8_dot_by_chain_theta_1
        - t115 * chain_omega_9_dot_by_chain_theta_1
        - t117 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_4_dot_by_chain_theta_1 = t341 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_1
        - t98 * chain_omega_6_dot_by_chain_theta_1
        - t100 * chain_omega_7_dot_by_chain_theta_1
        - t102 * chain_omega_8_dot_by_chain_theta_1
        - t104 * chain_omega_9_dot_by_chain_theta_1
        - t106 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_3_dot_by_chain_theta_1 = t340 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_1
        - t83 * chain_omega_5_dot_by_chain_theta_1
        - t85 * chain_omega_6_dot_by_chain_theta_1
        - t87 * chain_omega_7_dot_by_chain_theta_1
        - t89 * chain_omega_8_dot_by_chain_theta_1
        - t91 * chain_omega_9_dot_by_chain_theta_1
        - t93 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_2_dot_by_chain_theta_1 = t339 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_1
        - t66 * chain_omega_4_dot_by_chain_theta_1
        - t68 * chain_omega_5_dot_by_chain_theta_1
        - t70 * chain_omega_6_dot_by_chain_theta_1
        - t72 * chain_omega_7_dot_by_chain_theta_1
        - t74 * chain_omega_8_dot_by_chain_theta_1
        - t76 * chain_omega_9_dot_by_chain_theta_1
        - t78 * chain_omega_10_dot_by_chain_theta_1;
    let chain_omega_1_dot_by_chain_theta_1 = t337 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_1
        - t54 * chain_omega_3_dot_by_chain_theta_1
        - t55 * chain_omega_4_dot_by_chain_theta_1
        - t56 * chain_omega_5_dot_by_chain_theta_1
        - t57 * chain_omega_6_dot_by_chain_theta_1
        - t58 * chain_omega_7_dot_by_chain_theta_1
        - t59 * chain_omega_8_dot_by_chain_theta_1
        - t60 * chain_omega_9_dot_by_chain_theta_1
        - t61 * chain_omega_10_dot_by_chain_theta_1;
    let t347 = t146 * t17;
    let t348 = t148 * t18;
    let t349 = t150 * t19;
    let t350 = t152 * t20;
    let t351 = t154 * t21;
    let t352 = t156 * t22;
    let t353 = t158 * t23;
    let t354 = chain_omega_10_squared * t24;
    let t355 = t174 * chain_theta_3_minus_chain_theta_2.cos();
    let t356 = t185 * chain_theta_4_minus_chain_theta_2.cos();
    let t357 = t197 * chain_theta_5_minus_chain_theta_2.cos();
    let t358 = t210 * chain_theta_6_minus_chain_theta_2.cos();
    let t359 = t224 * chain_theta_7_minus_chain_theta_2.cos();
    let t360 = t239 * chain_theta_8_minus_chain_theta_2.cos();
    let t361 = t255 * chain_theta_9_minus_chain_theta_2.cos();
    let t362 = chain_omega_2_squared * chain_theta_10_minus_chain_theta_2.cos();
    let t363 = t294 - t313;
    let t364 = R::literal(8.0) * t163;
    let t365 = t364 * chain_omega_3_dot;
    let t366 = t364 * chain_omega_2_dot;
    let t367 = R::literal(7.0) * t164;
    let t368 = t367 * chain_omega_4_dot;
    let t369 = t367 * chain_omega_2_dot;
    let t370 = R::literal(6.0) * t165;
    let t371 = t370 * chain_omega_5_dot;
    let t372 = t370 * chain_omega_2_dot;
    let t373 = R::literal(5.0) * t166;
    let t374 = t373 * chain_omega_6_dot;
    let t375 = t373 * chain_omega_2_dot;
    let t376 = R::literal(4.0) * t167;
    let t377 = t376 * chain_omega_7_dot;
    let t378 = t376 * chain_omega_2_dot;
    let t379 = R::literal(3.0) * t168;
    let t380 = t379 * chain_omega_8_dot;
    let t381 = t379 * chain_omega_2_dot;
    let t382 = R::literal(2.0) * t169;
    let t383 = t382 * chain_omega_9_dot;
    let t384 = t382 * chain_omega_2_dot;
    let t385 = t170 * chain_omega_10_dot;
    let t386 = t170 * chain_omega_2_dot;
    let t387 = -(R::literal(88.29) * chain_theta_2.cos()) - t303 - t347 - t348 - t349
        - t350 - t351 - t352 - t353 - t354 - t314 + t365 + t368 + t371 + t374 + t377
        + t380 + t383 + t385 - t53 * t363;
    let t388 = t355 + t366 - t54 * t363 - t64 * t387;
    let t389 = t356 + t369 - t55 * t363 - t66 * t387 - t81 * t388;
    let t390 = t357 + t372 - t56 * t363 - t68 * t387 - t83 * t388 - t96 * t389;
    let t391 = t358 + t375 - t57 * t363 - t70 * t387 - t85 * t388 - t98 * t389
        - t109 * t390;
    let t392 = t359 + t378 - t58 * t363 - t72 * t387 - t87 * t388 - t100 * t389
        - t111 * t390 - t120 * t391;
    let t393 = t360 + t381 - t59 * t363 - t74 * t387 - t89 * t388 - t102 * t389
        - t113 * t390 - t122 * t391 - t129 * t392;
    let t394 = t361 + t384 - t60 * t363 - t76 * t387 - t91 * t388 - t104 * t389
        - t115 * t390 - t124 * t391 - t131 * t392 - t136 * t393;
    let chain_omega_10_dot_by_chain_theta_2 = (t362 + t386 - t61 * t363 - t78 * t387
        - t93 * t388 - t106 * t389 - t117 * t390 - t126 * t391 - t133 * t392
        - t138 * t393 - t141 * t394) * t142;
    let chain_omega_9_dot_by_chain_theta_2 = t394 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_8_dot_by_chain_theta_2 = t393 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_2
        - t138 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_7_dot_by_chain_theta_2 = t392 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_2
        - t131 * chain_omega_9_dot_by_chain_theta_2
        - t133 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_6_dot_by_chain_theta_2 = t391 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_2
        - t122 * chain_omega_8_dot_by_chain_theta_2
        - t124 * chain_omega_9_dot_by_chain_theta_2
        - t126 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_5_dot_by_chain_theta_2 = t390 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_2
        - t111 * chain_omega_7_dot_by_chain_theta_2
        - t113 * chain_omega_8_dot_by_chain_theta_2
        - t115 * chain_omega_9_dot_by_chain_theta_2
        - t117 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_4_dot_by_chain_theta_2 = t389 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_2
        - t98 * chain_omega_6_dot_by_chain_theta_2
        - t100 * chain_omega_7_dot_by_chain_theta_2
        - t102 * chain_omega_8_dot_by_chain_theta_2
        - t104 * chain_omega_9_dot_by_chain_theta_2
        - t106 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_3_dot_by_chain_theta_2 = t388 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_2
        - t83 * chain_omega_5_dot_by_chain_theta_2
        - t85 * chain_omega_6_dot_by_chain_theta_2
        - t87 * chain_omega_7_dot_by_chain_theta_2
        - t89 * chain_omega_8_dot_by_chain_theta_2
        - t91 * chain_omega_9_dot_by_chain_theta_2
        - t93 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_2_dot_by_chain_theta_2 = t387 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_2
        - t66 * chain_omega_4_dot_by_chain_theta_2
        - t68 * chain_omega_5_dot_by_chain_theta_2
        - t70 * chain_omega_6_dot_by_chain_theta_2
        - t72 * chain_omega_7_dot_by_chain_theta_2
        - t74 * chain_omega_8_dot_by_chain_theta_2
        - t76 * chain_omega_9_dot_by_chain_theta_2
        - t78 * chain_omega_10_dot_by_chain_theta_2;
    let chain_omega_1_dot_by_chain_theta_2 = t363 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_2
        - t54 * chain_omega_3_dot_by_chain_theta_2
        - t55 * chain_omega_4_dot_by_chain_theta_2
        - t56 * chain_omega_5_dot_by_chain_theta_2
        - t57 * chain_omega_6_dot_by_chain_theta_2
        - t58 * chain_omega_7_dot_by_chain_theta_2
        - t59 * chain_omega_8_dot_by_chain_theta_2
        - t60 * chain_omega_9_dot_by_chain_theta_2
        - t61 * chain_omega_10_dot_by_chain_theta_2;
    let t395 = t148 * t25;
    let t396 = t150 * t26;
    let t397 = t152 * t27;
    let t398 = t154 * t28;
    let t399 = t156 * t29;
    let t400 = t158 * t30;
    let t401 = chain_omega_10_squared * t31;
    let t402 = t187 * chain_theta_4_minus_chain_theta_3.cos();
    let t403 = t199 * chain_theta_5_minus_chain_theta_3.cos();
    let t404 = t212 * chain_theta_6_minus_chain_theta_3.cos();
    let t405 = t226 * chain_theta_7_minus_chain_theta_3.cos();
    let t406 = t241 * chain_theta_8_minus_chain_theta_3.cos();
    let t407 = t257 * chain_theta_9_minus_chain_theta_3.cos();
    let t408 = chain_omega_3_squared * chain_theta_10_minus_chain_theta_3.cos();
    let t409 = t295 - t316;
    let t410 = R::literal(7.0) * t175;
    let t411 = t410 * chain_omega_4_dot;
    let t412 = t410 * chain_omega_3_dot;
    let t413 = R::literal(6.0) * t176;
    let t414 = t413 * chain_omega_5_dot;
    let t415 = t413 * chain_omega_3_dot;
    let t416 = R::literal(5.0) * t177;
    let t417 = t416 * chain_omega_6_dot;
    let t418 = t416 * chain_omega_3_dot;
    let t419 = R::literal(4.0) * t178;
    let t420 = t419 * chain_omega_7_dot;
    let t421 = t419 * chain_omega_3_dot;
    let t422 = R::literal(3.0) * t179;
    let t423 = t422 * chain_omega_8_dot;
    let t424 = t422 * chain_omega_3_dot;
    let t425 = R::literal(2.0) * t180;
    let t426 = t425 * chain_omega_9_dot;
    let t427 = t425 * chain_omega_3_dot;
    let t428 = t181 * chain_omega_10_dot;
    let t429 = t181 * chain_omega_3_dot;
    let t430 = t347 - t365 - t53 * t409;
    let t431 = -(R::literal(78.48) * chain_theta_3.cos()) - t304 - t355 - t395 - t396
        - t397 - t398 - t399 - t400 - t401 - t317 - t366 + t411 + t414 + t417 + t420
        + t423 + t426 + t428 - t54 * t409;
    let t432 = t431 - t64 * t430;
    let t433 = t402 + t412 - t55 * t409 - t66 * t430 - t81 * t432;
    let t434 = t403 + t415 - t56 * t409 - t68 * t430 - t83 * t432 - t96 * t433;
    let t435 = t404 + t418 - t57 * t409 - t70 * t430 - t85 * t432 - t98 * t433
        - t109 * t434;
    let t436 = t405 + t421 - t58 * t409 - t72 * t430 - t87 * t432 - t100 * t433
        - t111 * t434 - t120 * t435;
    let t437 = t406 + t424 - t59 * t409 - t74 * t430 - t89 * t432 - t102 * t433
        - t113 * t434 - t122 * t435 - t129 * t436;
    let t438 = t407 + t427 - t60 * t409 - t76 * t430 - t91 * t432 - t104 * t433
        - t115 * t434 - t124 * t435 - t131 * t436 - t136 * t437;
    let chain_omega_10_dot_by_chain_theta_3 = (t408 + t429 - t61 * t409 - t78 * t430
        - t93 * t432 - t106 * t433 - t117 * t434 - t126 * t435 - t133 * t436
        - t138 * t437 - t141 * t438) * t142;
    let chain_omega_9_dot_by_chain_theta_3 = t438 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_8_dot_by_chain_theta_3 = t437 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_3
        - t138 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_7_dot_by_chain_theta_3 = t436 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_3
        - t131 * chain_omega_9_dot_by_chain_theta_3
        - t133 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_6_dot_by_chain_theta_3 = t435 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_3
        - t122 * chain_omega_8_dot_by_chain_theta_3
        - t124 * chain_omega_9_dot_by_chain_theta_3
        - t126 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_5_dot_by_chain_theta_3 = t434 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_3
        - t111 * chain_omega_7_dot_by_chain_theta_3
        - t113 * chain_omega_8_dot_by_chain_theta_3
        - t115 * chain_omega_9_dot_by_chain_theta_3
        - t117 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_4_dot_by_chain_theta_3 = t433 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_3
        - t98 * chain_omega_6_dot_by_chain_theta_3
        - t100 * chain_omega_7_dot_by_chain_theta_3
        - t102 * chain_omega_8_dot_by_chain_theta_3
        - t104 * chain_omega_9_dot_by_chain_theta_3
        - t106 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_3_dot_by_chain_theta_3 = t432 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_3
        - t83 * chain_omega_5_dot_by_chain_theta_3
        - t85 * chain_omega_6_dot_by_chain_theta_3
        - t87 * chain_omega_7_dot_by_chain_theta_3
        - t89 * chain_omega_8_dot_by_chain_theta_3
        - t91 * chain_omega_9_dot_by_chain_theta_3
        - t93 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_2_dot_by_chain_theta_3 = t430 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_3
        - t66 * chain_omega_4_dot_by_chain_theta_3
        - t68 * chain_omega_5_dot_by_chain_theta_3
        - t70 * chain_omega_6_dot_by_chain_theta_3
        - t72 * chain_omega_7_dot_by_chain_theta_3
        - t74 * chain_omega_8_dot_by_chain_theta_3
        - t76 * chain_omega_9_dot_by_chain_theta_3
        - t78 * chain_omega_10_dot_by_chain_theta_3;
    let chain_omega_1_dot_by_chain_theta_3 = t409 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_3
        - t54 * chain_omega_3_dot_by_chain_theta_3
        - t55 * chain_omega_4_dot_by_chain_theta_3
        - t56 * chain_omega_5_dot_by_chain_theta_3
        - t57 * chain_omega_6_dot_by_chain_theta_3
        - t58 * chain_omega_7_dot_by_chain_theta_3
        - t59 * chain_omega_8_dot_by_chain_theta_3
        - t60 * chain_omega_9_dot_by_chain_theta_3
        - t61 * chain_omega_10_dot_by_chain_theta_3;
    let t439 = t150 * t32;
    let t440 = t152 * t33;
    let t441 = t154 * t34;
    let t442 = t156 * t35;
    let t443 = t158 * t36;
    let t444 = chain_omega_10_squared * t37;
    let t445 = t201 * chain_theta_5_minus_chain_theta_4.cos();
    let t446 = t214 * chain_theta_6_minus_chain_theta_4.cos();
    let t447 = t228 * chain_theta_7_minus_chain_theta_4.cos();
    let t448 = t243 * chain_theta_8_minus_chain_theta_4.cos();
    let t449 = t259 * chain_theta_9_minus_chain_theta_4.cos();
    let t450 = chain_omega_4_squared * chain_theta_10_minus_chain_theta_4.cos();
    let t451 = t296 - t319;
    let t452 = R::literal(6.0) * t188;
    let t453 = t452 * chain_omega_5_dot;
    let t454 = t452 * chain_omega_4_dot;
    let t455 = R::literal(5.0) * t189;
    let t456 = t455 * chain_omega_6_dot;
    let t457 = t455 * chain_omega_4_dot;
    let t458 = R::literal(4.0) * t190;
    let t459 = t458 * chain_omega_7_dot;
    let t460 = t458 * chain_omega_4_dot;
    let t461 = R::literal(3.0) * t191;
    let t462 = t461 * chain_omega_8_dot;
    let t463 = t461 * chain_omega_4_dot;
    let t464 = R::literal(2.0) * t192;
    let t465 = t464 * chain_omega_9_dot;
    let t466 = t464 * chain_omega_4_dot;
    let t467 = t193 * chain_omega_10_dot;
    let t468 = t193 * chain_omega_4_dot;
    let t469 = t348 - t368 - t53 * t451;
    let t470 = t395 - t411 - t54 * t451 - t64 * t469;
    let t471 = -(R::literal(68.67) * chain_theta_4.cos()) - t305 - t356 - t402 - t439
        - t440 - t441 - t442 - t443 - t444 - t320 - t369 - t412 + t453 + t456 + t459
        + t462 + t465 + t467 - t55 * t451;
    let t472 = t471 - t66 * t469 - t81 * t470;
    let t473 = t445 + t454 - t56 * t451 - t68 * t469 - t83 * t470 - t96 * t472;
    let t474 = t446 + t457 - t57 * t451 - t70 * t469 - t85 * t470 - t98 * t472
        - t109 * t473;
    let t475 = t447 + t460 - t58 * t451 - t72 * t469 - t87 * t470 - t100 * t472
        - t111 * t473 - t120 * t474;
    let t476 = t448 + t463 - t59 * t451 - t74 * t469 - t89 * t470 - t102 * t472
        - t113 * t473 - t122 * t474 - t129 * t475;
    let t477 = t449 + t466 - t60 * t451 - t76 * t469 - t91 * t470 - t104 * t472
        - t115 * t473 - t124 * t474 - t131 * t475 - t136 * t476;
    let chain_omega_10_dot_by_chain_theta_4 = (t450 + t468 - t61 * t451 - t78 * t469
        - t93 * t470 - t106 * t472 - t117 * t473 - t126 * t474 - t133 * t475
        - t138 * t476 - t141 * t477) * t142;
    let chain_omega_9_dot_by_chain_theta_4 = t477 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_8_dot_by_chain_theta_4 = t476 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_4
        - t138 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_7_dot_by_chain_theta_4 = t475 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_4
        - t131 * chain_omega_9_dot_by_chain_theta_4
        - t133 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_6_dot_by_chain_theta_4 = t474 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_4
        - t122 * chain_omega_8_dot_by_chain_theta_4
        - t124 * chain_omega_9_dot_by_chain_theta_4
        - t126 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_5_dot_by_chain_theta_4 = t473 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_4
        - t111 * chain_omega_7_dot_by_chain_theta_4
        - t113 * chain_omega_8_dot_by_chain_theta_4
        - t115 * chain_omega_9_dot_by_chain_theta_4
        - t117 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_4_dot_by_chain_theta_4 = t472 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_4
        - t98 * chain_omega_6_dot_by_chain_theta_4
        - t100 * chain_omega_7_dot_by_chain_theta_4
        - t102 * chain_omega_8_dot_by_chain_theta_4
        - t104 * chain_omega_9_dot_by_chain_theta_4
        - t106 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_3_dot_by_chain_theta_4 = t470 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_4
        - t83 * chain_omega_5_dot_by_chain_theta_4
        - t85 * chain_omega_6_dot_by_chain_theta_4
        - t87 * chain_omega_7_dot_by_chain_theta_4
        - t89 * chain_omega_8_dot_by_chain_theta_4
        - t91 * chain_omega_9_dot_by_chain_theta_4
        - t93 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_2_dot_by_chain_theta_4 = t469 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_4
        - t66 * chain_omega_4_dot_by_chain_theta_4
        - t68 * chain_omega_5_dot_by_chain_theta_4
        - t70 * chain_omega_6_dot_by_chain_theta_4
        - t72 * chain_omega_7_dot_by_chain_theta_4
        - t74 * chain_omega_8_dot_by_chain_theta_4
        - t76 * chain_omega_9_dot_by_chain_theta_4
        - t78 * chain_omega_10_dot_by_chain_theta_4;
    let chain_omega_1_dot_by_chain_theta_4 = t451 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_4
        - t54 * chain_omega_3_dot_by_chain_theta_4
        - t55 * chain_omega_4_dot_by_chain_theta_4
        - t56 * chain_omega_5_dot_by_chain_theta_4
        - t57 * chain_omega_6_dot_by_chain_theta_4
        - t58 * chain_omega_7_dot_by_chain_theta_4
        - t59 * chain_omega_8_dot_by_chain_theta_4
        - t60 * chain_omega_9_dot_by_chain_theta_4
        - t61 * chain_omega_10_dot_by_chain_theta_4;
    let t478 = t152 * t38;
    let t479 = t154 * t39;
    let t480 = t156 * t40;
    let t481 = t158 * t41;
    let t482 = chain_omega_10_squared * t42;
    let t483 = t216 * chain_theta_6_minus_chain_theta_5.cos();
    let t484 = t230 * chain_theta_7_minus_chain_theta_5.cos();
    let t485 = t245 * chain_theta_8_minus_chain_theta_5.cos();
    let t486 = t261 * chain_theta_9_minus_chain_theta_5.cos();
    let t487 = chain_omega_5_squared * chain_theta_10_minus_chain_theta_5.cos();
    let t488 = t297 - t322;
    let t489 = R::literal(5.0) * t202;
    let t490 = t489 * chain_omega_6_dot;
    let t491 = t489 * chain_omega_5_dot;
    let t492 = R::literal(4.0) * t203;
    let t493 = t492 * chain_omega_7_dot;
    let t494 = t492 * chain_omega_5_dot;
    let t495 = R::literal(3.0) * t204;
    let t496 = t495 * chain_omega_8_dot;
    let t497 = t495 * chain_omega_5_dot;
    let t498 = R::literal(2.0) * t205;
    let t499 = t498 * chain_omega_9_dot;
    let t500 = t498 * chain_omega_5_dot;
    let t501 = t206 * chain_omega_10_dot;
    let t502 = t206 * chain_omega_5_dot;
    let t503 = t349 - t371 - t53 * t488;
    let t504 = t396 - t414 - t54 * t488 - t64 * t503;
    let t505 = t439 - t453 - t55 * t488 - t66 * t503 - t81 * t504;
    let t506 = -(R::literal(58.86) * chain_theta_5.cos()) - t306 - t357 - t403 - t445
        - t478 - t479 - t480 - t481 - t482 - t323 - t372 - t415 - t454 + t490 + t493
        + t496 + t499 + t501 - t56 * t488;
    let t507 = t506 - t68 * t503 - t83 * t504 - t96 * t505;
    let t508 = t483 + t491 - t57 * t488 - t70 * t503 - t85 * t504 - t98 * t505
        - t109 * t507;
    let t509 = t484 + t494 - t58 * t488 - t72 * t503 - t87 * t504 - t100 * t505
        - t111 * t507 - t120 * t508;
    let t510 = t485 + t497 - t59 * t488 - t74 * t503 - t89 * t504 - t102 * t505
        - t113 * t507 - t122 * t508 - t129 * t509;
    let t511 = t486 + t500 - t60 * t488 - t76 * t503 - t91 * t504 - t104 * t505
        - t115 * t507 - t124 * t508 - t131 * t509 - t136 * t510;
    let chain_omega_10_dot_by_chain_theta_5 = (t487 + t502 - t61 * t488 - t78 * t503
        - t93 * t504 - t106 * t505 - t117 * t507 - t126 * t508 - t133 * t509
        - t138 * t510 - t141 * t511) * t142;
    let chain_omega_9_dot_by_chain_theta_5 = t511 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_8_dot_by_chain_theta_5 = t510 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_5
        - t138 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_7_dot_by_chain_theta_5 = t509 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_5
        - t131 * chain_omega_9_dot_by_chain_theta_5
        - t133 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_6_dot_by_chain_theta_5 = t508 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_5
        - t122 * chain_omega_8_dot_by_chain_theta_5
        - t124 * chain_omega_9_dot_by_chain_theta_5
        - t126 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_5_dot_by_chain_theta_5 = t507 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_5
        - t111 * chain_omega_7_dot_by_chain_theta_5
        - t113 * chain_omega_8_dot_by_chain_theta_5
        - t115 * chain_omega_9_dot_by_chain_theta_5
        - t117 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_4_dot_by_chain_theta_5 = t505 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_5
        - t98 * chain_omega_6_dot_by_chain_theta_5
        - t100 * chain_omega_7_dot_by_chain_theta_5
        - t102 * chain_omega_8_dot_by_chain_theta_5
        - t104 * chain_omega_9_dot_by_chain_theta_5
        - t106 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_3_dot_by_chain_theta_5 = t504 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_5
        - t83 * chain_omega_5_dot_by_chain_theta_5
        - t85 * chain_omega_6_dot_by_chain_theta_5
        - t87 * chain_omega_7_dot_by_chain_theta_5
        - t89 * chain_omega_8_dot_by_chain_theta_5
        - t91 * chain_omega_9_dot_by_chain_theta_5
        - t93 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_2_dot_by_chain_theta_5 = t503 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_5
        - t66 * chain_omega_4_dot_by_chain_theta_5
        - t68 * chain_omega_5_dot_by_chain_theta_5
        - t70 * chain_omega_6_dot_by_chain_theta_5
        - t72 * chain_omega_7_dot_by_chain_theta_5
        - t74 * chain_omega_8_dot_by_chain_theta_5
        - t76 * chain_omega_9_dot_by_chain_theta_5
        - t78 * chain_omega_10_dot_by_chain_theta_5;
    let chain_omega_1_dot_by_chain_theta_5 = t488 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_5
        - t54 * chain_omega_3_dot_by_chain_theta_5
        - t55 * chain_omega_4_dot_by_chain_theta_5
        - t56 * chain_omega_5_dot_by_chain_theta_5
        - t57 * chain_omega_6_dot_by_chain_theta_5
        - t58 * chain_omega_7_dot_by_chain_theta_5
        - t59 * chain_omega_8_dot_by_chain_theta_5
        - t60 * chain_omega_9_dot_by_chain_theta_5
        - t61 * chain_omega_10_dot_by_chain_theta_5;
    let t512 = t154 * t43;
    let t513 = t156 * t44;
    let t514 = t158 * t45;
    let t515 = chain_omega_10_squared * t46;
    let t516 = t232 * chain_theta_7_minus_chain_theta_6.cos();
    let t517 = t247 * chain_theta_8_minus_chain_theta_6.cos();
    let t518 = t263 * chain_theta_9_minus_chain_theta_6.cos();
    let t519 = chain_omega_6_squared * chain_theta_10_minus_chain_theta_6.cos();
    let t520 = t298 - t325;
    let t521 = R::literal(4.0) * t217;
    let t522 = t521 * chain_omega_7_dot;
    let t523 = t521 * chain_omega_6_dot;
    let t524 = R::literal(3.0) * t218;
    let t525 = t524 * chain_omega_8_dot;
    let t526 = t524 * chain_omega_6_dot;
    let t527 = R::literal(2.0) * t219;
    let t528 = t527 * chain_omega_9_dot;
    let t529 = t527 * chain_omega_6_dot;
    let t530 = t220 * chain_omega_10_dot;
    let t531 = t220 * chain_omega_6_dot;
    let t532 = t350 - t374 - t53 * t520;
    let t533 = t397 - t417 - t54 * t520 - t64 * t532;
    let t534 = t440 - t456 - t55 * t520 - t66 * t532 - t81 * t533;
    let t535 = t478 - t490 - t56 * t520 - t68 * t532 - t83 * t533 - t96 * t534;
    let t536 = -(R::literal(49.05) * chain_theta_6.cos()) - t307 - t358 - t404 - t446
        - t483 - t512 - t513 - t514 - t515 - t326 - t375 - t418 - t457 - t491 + t522
        + t525 + t528 + t530 - t57 * t520;
    let t537 = t536 - t70 * t532 - t85 * t533 - t98 * t534 - t109 * t535;
    let t538 = t516 + t523 - t58 * t520 - t72 * t532 - t87 * t533 - t100 * t534
        - t111 * t535 - t120 * t537;
    let t539 = t517 + t526 - t59 * t520 - t74 * t532 - t89 * t533 - t102 * t534
        - t113 * t535 - t122 * t537 - t129 * t538;
    let t540 = t518 + t529 - t60 * t520 - t76 * t532 - t91 * t533 - t104 * t534
        - t115 * t535 - t124 * t537 - t131 * t538 - t136 * t539;
    let chain_omega_10_dot_by_chain_theta_6 = (t519 + t531 - t61 * t520 - t78 * t532
        - t93 * t533 - t106 * t534 - t117 * t535 - t126 * t537 - t133 * t538
        - t138 * t539 - t141 * t540) * t142;
    let chain_omega_9_dot_by_chain_theta_6 = t540 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_8_dot_by_chain_theta_6 = t539 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_6
        - t138 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_7_dot_by_chain_theta_6 = t538 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_6
        - t131 * chain_omega_9_dot_by_chain_theta_6
        - t133 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_6_dot_by_chain_theta_6 = t537 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_6
        - t122 * chain_omega_8_dot_by_chain_theta_6
        - t124 * chain_omega_9_dot_by_chain_theta_6
        - t126 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_5_dot_by_chain_theta_6 = t535 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_6
        - t111 * chain_omega_7_dot_by_chain_theta_6
        - t113 * chain_omega_8_dot_by_chain_theta_6
        - t115 * chain_omega_9_dot_by_chain_theta_6
        - t117 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_4_dot_by_chain_theta_6 = t534 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_6
        - t98 * chain_omega_6_dot_by_chain_theta_6
        - t100 * chain_omega_7_dot_by_chain_theta_6
        - t102 * chain_omega_8_dot_by_chain_theta_6
        - t104 * chain_omega_9_dot_by_chain_theta_6
        - t106 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_3_dot_by_chain_theta_6 = t533 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_6
        - t83 * chain_omega_5_dot_by_chain_theta_6
        - t85 * chain_omega_6_dot_by_chain_theta_6
        - t87 * chain_omega_7_dot_by_chain_theta_6
        - t89 * chain_omega_8_dot_by_chain_theta_6
        - t91 * chain_omega_9_dot_by_chain_theta_6
        - t93 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_2_dot_by_chain_theta_6 = t532 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_6
        - t66 * chain_omega_4_dot_by_chain_theta_6
        - t68 * chain_omega_5_dot_by_chain_theta_6
        - t70 * chain_omega_6_dot_by_chain_theta_6
        - t72 * chain_omega_7_dot_by_chain_theta_6
        - t74 * chain_omega_8_dot_by_chain_theta_6
        - t76 * chain_omega_9_dot_by_chain_theta_6
        - t78 * chain_omega_10_dot_by_chain_theta_6;
    let chain_omega_1_dot_by_chain_theta_6 = t520 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_6
        - t54 * chain_omega_3_dot_by_chain_theta_6
        - t55 * chain_omega_4_dot_by_chain_theta_6
        - t56 * chain_omega_5_dot_by_chain_theta_6
        - t57 * chain_omega_6_dot_by_chain_theta_6
        - t58 * chain_omega_7_dot_by_chain_theta_6
        - t59 * chain_omega_8_dot_by_chain_theta_6
        - t60 * chain_omega_9_dot_by_chain_theta_6
        - t61 * chain_omega_10_dot_by_chain_theta_6;
    let t541 = t156 * t47;
    let t542 = t158 * t48;
    let t543 = chain_omega_10_squared * t49;
    let t544 = t249 * chain_theta_8_minus_chain_theta_7.cos();
    let t545 = t265 * chain_theta_9_minus_chain_theta_7.cos();
    let t546 = chain_omega_7_squared * chain_theta_10_minus_chain_theta_7.cos();
    let t547 = t299 - t328;
    let t548 = R::literal(3.0) * t233;
    let t549 = t548 * chain_omega_8_dot;
    let t550 = t548 * chain_omega_7_dot;
    let t551 = R::literal(2.0) * t234;
    let t552 = t551 * chain_omega_9_dot;
    let t553 = t551 * chain_omega_7_dot;
    let t554 = t235 * chain_omega_10_dot;
    let t555 = t235 * chain_omega_7_dot;
    let t556 = t351 - t377 - t53 * t547;
    let t557 = t398 - t420 - t54 * t547 - t64 * t556;
    let t558 = t441 - t459 - t55 * t547 - t66 * t556 - t81 * t557;
    let t559 = t479 - t493 - t56 * t547 - t68 * t556 - t83 * t557 - t96 * t558;
    let t560 = t512 - t522 - t57 * t547 - t70 * t556 - t85 * t557 - t98 * t558
        - t109 * t559;
    let t561 = -(R::literal(39.24) * chain_theta_7.cos()) - t308 - t359 - t405 - t447
        - t484 - t516 - t541 - t542 - t543 - t329 - t378 - t421 - t460 - t494 - t523
        + t549 + t552 + t554 - t58 * t547;
    let t562 = t561 - t72 * t556 - t87 * t557 - t100 * t558 - t111 * t559 - t120 * t560;
    let t563 = t544 + t550 - t59 * t547 - t74 * t556 - t89 * t557 - t102 * t558
        - t113 * t559 - t122 * t560 - t129 * t562;
    let t564 = t545 + t553 - t60 * t547 - t76 * t556 - t91 * t557 - t104 * t558
        - t115 * t559 - t124 * t560 - t131 * t562 - t136 * t563;
    let chain_omega_10_dot_by_chain_theta_7 = (t546 + t555 - t61 * t547 - t78 * t556
        - t93 * t557 - t106 * t558 - t117 * t559 - t126 * t560 - t133 * t562
        - t138 * t563 - t141 * t564) * t142;
    let chain_omega_9_dot_by_chain_theta_7 = t564 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_8_dot_by_chain_theta_7 = t563 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_7
        - t138 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_7_dot_by_chain_theta_7 = t562 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_7
        - t131 * chain_omega_9_dot_by_chain_theta_7
        - t133 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_6_dot_by_chain_theta_7 = t560 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_7
        - t122 * chain_omega_8_dot_by_chain_theta_7
        - t124 * chain_omega_9_dot_by_chain_theta_7
        - t126 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_5_dot_by_chain_theta_7 = t559 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_7
        - t111 * chain_omega_7_dot_by_chain_theta_7
        - t113 * chain_omega_8_dot_by_chain_theta_7
        - t115 * chain_omega_9_dot_by_chain_theta_7
        - t117 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_4_dot_by_chain_theta_7 = t558 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_7
        - t98 * chain_omega_6_dot_by_chain_theta_7
        - t100 * chain_omega_7_dot_by_chain_theta_7
        - t102 * chain_omega_8_dot_by_chain_theta_7
        - t104 * chain_omega_9_dot_by_chain_theta_7
        - t106 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_3_dot_by_chain_theta_7 = t557 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_7
        - t83 * chain_omega_5_dot_by_chain_theta_7
        - t85 * chain_omega_6_dot_by_chain_theta_7
        - t87 * chain_omega_7_dot_by_chain_theta_7
        - t89 * chain_omega_8_dot_by_chain_theta_7
        - t91 * chain_omega_9_dot_by_chain_theta_7
        - t93 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_2_dot_by_chain_theta_7 = t556 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_7
        - t66 * chain_omega_4_dot_by_chain_theta_7
        - t68 * chain_omega_5_dot_by_chain_theta_7
        - t70 * chain_omega_6_dot_by_chain_theta_7
        - t72 * chain_omega_7_dot_by_chain_theta_7
        - t74 * chain_omega_8_dot_by_chain_theta_7
        - t76 * chain_omega_9_dot_by_chain_theta_7
        - t78 * chain_omega_10_dot_by_chain_theta_7;
    let chain_omega_1_dot_by_chain_theta_7 = t547 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_7
        - t54 * chain_omega_3_dot_by_chain_theta_7
        - t55 * chain_omega_4_dot_by_chain_theta_7
        - t56 * chain_omega_5_dot_by_chain_theta_7
        - t57 * chain_omega_6_dot_by_chain_theta_7
        - t58 * chain_omega_7_dot_by_chain_theta_7
        - t59 * chain_omega_8_dot_by_chain_theta_7
        - t60 * chain_omega_9_dot_by_chain_theta_7
        - t61 * chain_omega_10_dot_by_chain_theta_7;
    let t565 = t158 * t50;
    let t566 = chain_omega_10_squared * t51;
    let t567 = t267 * chain_theta_9_minus_chain_theta_8.cos();
    let t568 = chain_omega_8_squared * chain_theta_10_minus_chain_theta_8.cos();
    let t569 = t300 - t331;
    let t570 = R::literal(2.0) * t250;
    let t571 = t570 * chain_omega_9_dot;
    let t572 = t570 * chain_omega_8_dot;
    let t573 = t251 * chain_omega_10_dot;
    let t574 = t251 * chain_omega_8_dot;
    let t575 = t352 - t380 - t53 * t569;
    let t576 = t399 - t423 - t54 * t569 - t64 * t575;
    let t577 = t442 - t462 - t55 * t569 - t66 * t575 - t81 * t576;
    let t578 = t480 - t496 - t56 * t569 - t68 * t575 - t83 * t576 - t96 * t577;
    let t579 = t513 - t525 - t57 * t569 - t70 * t575 - t85 * t576 - t98 * t577
        - t109 * t578;
    let t580 = t541 - t549 - t58 * t569 - t72 * t575 - t87 * t576 - t100 * t577
        - t111 * t578 - t120 * t579;
    let t581 = -(R::literal(29.43) * chain_theta_8.cos()) - t309 - t360 - t406 - t448
        - t485 - t517 - t544 - t565 - t566 - t332 - t381 - t424 - t463 - t497 - t526
        - t550 + t571 + t573 - t59 * t569;
    let t582 = t581 - t74 * t575 - t89 * t576 - t102 * t577 - t113 * t578 - t122 * t579
        - t129 * t580;
    let t583 = t567 + t572 - t60 * t569 - t76 * t575 - t91 * t576 - t104 * t577
        - t115 * t578 - t124 * t579 - t131 * t580 - t136 * t582;
    let chain_omega_10_dot_by_chain_theta_8 = (t568 + t574 - t61 * t569 - t78 * t575
        - t93 * t576 - t106 * t577 - t117 * t578 - t126 * t579 - t133 * t580
        - t138 * t582 - t141 * t583) * t142;
    let chain_omega_9_dot_by_chain_theta_8 = t583 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_8_dot_by_chain_theta_8 = t582 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_8
        - t138 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_7_dot_by_chain_theta_8 = t580 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_8
        - t131 * chain_omega_9_dot_by_chain_theta_8
        - t133 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_6_dot_by_chain_theta_8 = t579 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_8
        - t122 * chain_omega_8_dot_by_chain_theta_8
        - t124 * chain_omega_9_dot_by_chain_theta_8
        - t126 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_5_dot_by_chain_theta_8 = t578 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_8
        - t111 * chain_omega_7_dot_by_chain_theta_8
        - t113 * chain_omega_8_dot_by_chain_theta_8
        - t115 * chain_omega_9_dot_by_chain_theta_8
        - t117 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_4_dot_by_chain_theta_8 = t577 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_8
        - t98 * chain_omega_6_dot_by_chain_theta_8
        - t100 * chain_omega_7_dot_by_chain_theta_8
        - t102 * chain_omega_8_dot_by_chain_theta_8
        - t104 * chain_omega_9_dot_by_chain_theta_8
        - t106 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_3_dot_by_chain_theta_8 = t576 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_8
        - t83 * chain_omega_5_dot_by_chain_theta_8
        - t85 * chain_omega_6_dot_by_chain_theta_8
        - t87 * chain_omega_7_dot_by_chain_theta_8
        - t89 * chain_omega_8_dot_by_chain_theta_8
        - t91 * chain_omega_9_dot_by_chain_theta_8
        - t93 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_2_dot_by_chain_theta_8 = t575 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_8
        - t66 * chain_omega_4_dot_by_chain_theta_8
        - t68 * chain_omega_5_dot_by_chain_theta_8
        - t70 * chain_omega_6_dot_by_chain_theta_8
        - t72 * chain_omega_7_dot_by_chain_theta_8
        - t74 * chain_omega_8_dot_by_chain_theta_8
        - t76 * chain_omega_9_dot_by_chain_theta_8
        - t78 * chain_omega_10_dot_by_chain_theta_8;
    let chain_omega_1_dot_by_chain_theta_8 = t569 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_8
        - t54 * chain_omega_3_dot_by_chain_theta_8
        - t55 * chain_omega_4_dot_by_chain_theta_8
        - t56 * chain_omega_5_dot_by_chain_theta_8
        - t57 * chain_omega_6_dot_by_chain_theta_8
        - t58 * chain_omega_7_dot_by_chain_theta_8
        - t59 * chain_omega_8_dot_by_chain_theta_8
        - t60 * chain_omega_9_dot_by_chain_theta_8
        - t61 * chain_omega_10_dot_by_chain_theta_8;
    let t584 = chain_omega_10_squared * t52;
    let t585 = chain_omega_9_squared * chain_theta_10_minus_chain_theta_9.cos();
    let t586 = t301 - t334;
    let t587 = t268 * chain_omega_10_dot;
    let t588 = t268 * chain_omega_9_dot;
    let t589 = t353 - t383 - t53 * t586;
    let t590 = t400 - t426 - t54 * t586 - t64 * t589;
    let t591 = t443 - t465 - t55 * t586 - t66 * t589 - t81 * t590;
    let t592 = t481 - t499 - t56 * t586 - t68 * t589 - t83 * t590 - t96 * t591;
    let t593 = t514 - t528 - t57 * t586 - t70 * t589 - t85 * t590 - t98 * t591
        - t109 * t592;
    let t594 = t542 - t552 - t58 * t586 - t72 * t589 - t87 * t590 - t100 * t591
        - t111 * t592 - t120 * t593;
    let t595 = t565 - t571 - t59 * t586 - t74 * t589 - t89 * t590 - t102 * t591
        - t113 * t592 - t122 * t593 - t129 * t594;
    let t596 = -(R::literal(19.62) * chain_theta_9.cos()) - t310 - t361 - t407 - t449
        - t486 - t518 - t545 - t567 - t584 - t335 - t384 - t427 - t466 - t500 - t529
        - t553 - t572 + t587 - t60 * t586;
    let t597 = t596 - t76 * t589 - t91 * t590 - t104 * t591 - t115 * t592 - t124 * t593
        - t131 * t594 - t136 * t595;
    let chain_omega_10_dot_by_chain_theta_9 = (t585 + t588 - t61 * t586 - t78 * t589
        - t93 * t590 - t106 * t591 - t117 * t592 - t126 * t593 - t133 * t594
        - t138 * t595 - t141 * t597) * t142;
    let chain_omega_9_dot_by_chain_theta_9 = t597 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_8_dot_by_chain_theta_9 = t595 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_9
        - t138 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_7_dot_by_chain_theta_9 = t594 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_9
        - t131 * chain_omega_9_dot_by_chain_theta_9
        - t133 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_6_dot_by_chain_theta_9 = t593 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_9
        - t122 * chain_omega_8_dot_by_chain_theta_9
        - t124 * chain_omega_9_dot_by_chain_theta_9
        - t126 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_5_dot_by_chain_theta_9 = t592 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_9
        - t111 * chain_omega_7_dot_by_chain_theta_9
        - t113 * chain_omega_8_dot_by_chain_theta_9
        - t115 * chain_omega_9_dot_by_chain_theta_9
        - t117 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_4_dot_by_chain_theta_9 = t591 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_9
        - t98 * chain_omega_6_dot_by_chain_theta_9
        - t100 * chain_omega_7_dot_by_chain_theta_9
        - t102 * chain_omega_8_dot_by_chain_theta_9
        - t104 * chain_omega_9_dot_by_chain_theta_9
        - t106 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_3_dot_by_chain_theta_9 = t590 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_9
        - t83 * chain_omega_5_dot_by_chain_theta_9
        - t85 * chain_omega_6_dot_by_chain_theta_9
        - t87 * chain_omega_7_dot_by_chain_theta_9
        - t89 * chain_omega_8_dot_by_chain_theta_9
        - t91 * chain_omega_9_dot_by_chain_theta_9
        - t93 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_2_dot_by_chain_theta_9 = t589 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_9
        - t66 * chain_omega_4_dot_by_chain_theta_9
        - t68 * chain_omega_5_dot_by_chain_theta_9
        - t70 * chain_omega_6_dot_by_chain_theta_9
        - t72 * chain_omega_7_dot_by_chain_theta_9
        - t74 * chain_omega_8_dot_by_chain_theta_9
        - t76 * chain_omega_9_dot_by_chain_theta_9
        - t78 * chain_omega_10_dot_by_chain_theta_9;
    let chain_omega_1_dot_by_chain_theta_9 = t586 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_9
        - t54 * chain_omega_3_dot_by_chain_theta_9
        - t55 * chain_omega_4_dot_by_chain_theta_9
        - t56 * chain_omega_5_dot_by_chain_theta_9
        - t57 * chain_omega_6_dot_by_chain_theta_9
        - t58 * chain_omega_7_dot_by_chain_theta_9
        - t59 * chain_omega_8_dot_by_chain_theta_9
        - t60 * chain_omega_9_dot_by_chain_theta_9
        - t61 * chain_omega_10_dot_by_chain_theta_9;
    let t598 = t302 - t336;
    let t599 = t354 - t385 - t53 * t598;
    let t600 = t401 - t428 - t54 * t598 - t64 * t599;
    let t601 = t444 - t467 - t55 * t598 - t66 * t599 - t81 * t600;
    let t602 = t482 - t501 - t56 * t598 - t68 * t599 - t83 * t600 - t96 * t601;
    let t603 = t515 - t530 - t57 * t598 - t70 * t599 - t85 * t600 - t98 * t601
        - t109 * t602;
    let t604 = t543 - t554 - t58 * t598 - t72 * t599 - t87 * t600 - t100 * t601
        - t111 * t602 - t120 * t603;
    let t605 = t566 - t573 - t59 * t598 - t74 * t599 - t89 * t600 - t102 * t601
        - t113 * t602 - t122 * t603 - t129 * t604;
    let t606 = t584 - t587 - t60 * t598 - t76 * t599 - t91 * t600 - t104 * t601
        - t115 * t602 - t124 * t603 - t131 * t604 - t136 * t605;
    let t607 = -(R::literal(9.81) * chain_theta_10.cos()) - t311 - t362 - t408 - t450
        - t487 - t519 - t546 - t568 - t585 - t338 - t386 - t429 - t468 - t502 - t531
        - t555 - t574 - t588 - t61 * t598;
    let chain_omega_10_dot_by_chain_theta_10 = (t607 - t78 * t599 - t93 * t600
        - t106 * t601 - t117 * t602 - t126 * t603 - t133 * t604 - t138 * t605
        - t141 * t606) * t142;
    let chain_omega_9_dot_by_chain_theta_10 = t606 * t139
        - t141 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_8_dot_by_chain_theta_10 = t605 * t134
        - t136 * chain_omega_9_dot_by_chain_theta_10
        - t138 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_7_dot_by_chain_theta_10 = t604 * t127
        - t129 * chain_omega_8_dot_by_chain_theta_10
        - t131 * chain_omega_9_dot_by_chain_theta_10
        - t133 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_6_dot_by_chain_theta_10 = t603 * t118
        - t120 * chain_omega_7_dot_by_chain_theta_10
        - t122 * chain_omega_8_dot_by_chain_theta_10
        - t124 * chain_omega_9_dot_by_chain_theta_10
        - t126 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_5_dot_by_chain_theta_10 = t602 * t107
        - t109 * chain_omega_6_dot_by_chain_theta_10
        - t111 * chain_omega_7_dot_by_chain_theta_10
        - t113 * chain_omega_8_dot_by_chain_theta_10
        - t115 * chain_omega_9_dot_by_chain_theta_10
        - t117 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_4_dot_by_chain_theta_10 = t601 * t94
        - t96 * chain_omega_5_dot_by_chain_theta_10
        - t98 * chain_omega_6_dot_by_chain_theta_10
        - t100 * chain_omega_7_dot_by_chain_theta_10
        - t102 * chain_omega_8_dot_by_chain_theta_10
        - t104 * chain_omega_9_dot_by_chain_theta_10
        - t106 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_3_dot_by_chain_theta_10 = t600 * t79
        - t81 * chain_omega_4_dot_by_chain_theta_10
        - t83 * chain_omega_5_dot_by_chain_theta_10
        - t85 * chain_omega_6_dot_by_chain_theta_10
        - t87 * chain_omega_7_dot_by_chain_theta_10
        - t89 * chain_omega_8_dot_by_chain_theta_10
        - t91 * chain_omega_9_dot_by_chain_theta_10
        - t93 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_2_dot_by_chain_theta_10 = t599 * t62
        - t64 * chain_omega_3_dot_by_chain_theta_10
        - t66 * chain_omega_4_dot_by_chain_theta_10
        - t68 * chain_omega_5_dot_by_chain_theta_10
        - t70 * chain_omega_6_dot_by_chain_theta_10
        - t72 * chain_omega_7_dot_by_chain_theta_10
        - t74 * chain_omega_8_dot_by_chain_theta_10
        - t76 * chain_omega_9_dot_by_chain_theta_10
        - t78 * chain_omega_10_dot_by_chain_theta_10;
    let chain_omega_1_dot_by_chain_theta_10 = t598 * R::literal(0.1)
        - t53 * chain_omega_2_dot_by_chain_theta_10
        - t54 * chain_omega_3_dot_by_chain_theta_10
        - t55 * chain_omega_4_dot_by_chain_theta_10
        - t56 * chain_omega_5_dot_by_chain_theta_10
        - t57 * chain_omega_6_dot_by_chain_theta_10
        - t58 * chain_omega_7_dot_by_chain_theta_10
        - t59 * chain_omega_8_dot_by_chain_theta_10
        - t60 * chain_omega_9_dot_by_chain_theta_10
        - t61 * chain_omega_10_dot_by_chain_theta_10;
    let t608 = R::literal(18.0) * chain_omega_1 * t161;
    let t609 = t64 * t608 - R::literal(16.0) * chain_omega_1 * t171;
    let t610 = t66 * t608 - R::literal(14.0) * chain_omega_1 * t182 - t81 * t609;
    let t611 = t68 * t608 - R::literal(12.0) * chain_omega_1 * t194 - t83 * t609
        - t96 * t610;
    let t612 = t70 * t608 - R::literal(10.0) * chain_omega_1 * t207 - t85 * t609
        - t98 * t610 - t109 * t611;
    let t613 = t72 * t608 - R::literal(8.0) * chain_omega_1 * t221 - t87 * t609
        - t100 * t610 - t111 * t611 - t120 * t612;
    let t614 = t74 * t608 - R::literal(6.0) * chain_omega_1 * t236 - t89 * t609
        - t102 * t610 - t113 * t611 - t122 * t612 - t129 * t613;
    let t615 = t76 * t608 - R::literal(4.0) * chain_omega_1 * t252 - t91 * t609
        - t104 * t610 - t115 * t611 - t124 * t612 - t131 * t613 - t136 * t614;
    let chain_omega_10_dot_by_chain_omega_1 = (t78 * t608
        - R::literal(2.0) * chain_omega_1 * t269 - t93 * t609 - t106 * t610 - t117 * t611
        - t126 * t612 - t133 * t613 - t138 * t614 - t141 * t615) * t142;
    let chain_omega_9_dot_by_chain_omega_1 = t615 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_8_dot_by_chain_omega_1 = t614 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_1
        - t138 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_7_dot_by_chain_omega_1 = t613 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_1
        - t131 * chain_omega_9_dot_by_chain_omega_1
        - t133 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_6_dot_by_chain_omega_1 = t612 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_1
        - t122 * chain_omega_8_dot_by_chain_omega_1
        - t124 * chain_omega_9_dot_by_chain_omega_1
        - t126 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_5_dot_by_chain_omega_1 = t611 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_1
        - t111 * chain_omega_7_dot_by_chain_omega_1
        - t113 * chain_omega_8_dot_by_chain_omega_1
        - t115 * chain_omega_9_dot_by_chain_omega_1
        - t117 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_4_dot_by_chain_omega_1 = t610 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_1
        - t98 * chain_omega_6_dot_by_chain_omega_1
        - t100 * chain_omega_7_dot_by_chain_omega_1
        - t102 * chain_omega_8_dot_by_chain_omega_1
        - t104 * chain_omega_9_dot_by_chain_omega_1
        - t106 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_3_dot_by_chain_omega_1 = t609 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_1
        - t83 * chain_omega_5_dot_by_chain_omega_1
        - t85 * chain_omega_6_dot_by_chain_omega_1
        - t87 * chain_omega_7_dot_by_chain_omega_1
        - t89 * chain_omega_8_dot_by_chain_omega_1
        - t91 * chain_omega_9_dot_by_chain_omega_1
        - t93 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_2_dot_by_chain_omega_1 = -(t608 * t62)
        - t64 * chain_omega_3_dot_by_chain_omega_1
        - t66 * chain_omega_4_dot_by_chain_omega_1
        - t68 * chain_omega_5_dot_by_chain_omega_1
        - t70 * chain_omega_6_dot_by_chain_omega_1
        - t72 * chain_omega_7_dot_by_chain_omega_1
        - t74 * chain_omega_8_dot_by_chain_omega_1
        - t76 * chain_omega_9_dot_by_chain_omega_1
        - t78 * chain_omega_10_dot_by_chain_omega_1;
    let chain_omega_1_dot_by_chain_omega_1 = -(t53 * chain_omega_2_dot_by_chain_omega_1)
        - t54 * chain_omega_3_dot_by_chain_omega_1
        - t55 * chain_omega_4_dot_by_chain_omega_1
        - t56 * chain_omega_5_dot_by_chain_omega_1
        - t57 * chain_omega_6_dot_by_chain_omega_1
        - t58 * chain_omega_7_dot_by_chain_omega_1
        - t59 * chain_omega_8_dot_by_chain_omega_1
        - t60 * chain_omega_9_dot_by_chain_omega_1
        - t61 * chain_omega_10_dot_by_chain_omega_1;
    let t616 = R::literal(18.0) * chain_omega_2 * t143;
    let t617 = t53 * t616;
    let t618 = t54 * t616 - R::literal(16.0) * chain_omega_2 * t173 - t64 * t617;
    let t619 = t55 * t616 - R::literal(14.0) * chain_omega_2 * t184 - t66 * t617
        - t81 * t618;
    let t620 = t56 * t616 - R::literal(12.0) * chain_omega_2 * t196 - t68 * t617
        - t83 * t618 - t96 * t619;
    let t621 = t57 * t616 - R::literal(10.0) * chain_omega_2 * t209 - t70 * t617
        - t85 * t618 - t98 * t619 - t109 * t620;
    let t622 = t58 * t616 - R::literal(8.0) * chain_omega_2 * t223 - t72 * t617
        - t87 * t618 - t100 * t619 - t111 * t620 - t120 * t621;
    let t623 = t59 * t616 - R::literal(6.0) * chain_omega_2 * t238 - t74 * t617
        - t89 * t618 - t102 * t619 - t113 * t620 - t122 * t621 - t129 * t622;
    let t624 = t60 * t616 - R::literal(4.0) * chain_omega_2 * t254 - t76 * t617
        - t91 * t618 - t104 * t619 - t115 * t620 - t124 * t621 - t131 * t622
        - t136 * t623;
    let chain_omega_10_dot_by_chain_omega_2 = (t61 * t616
        - R::literal(2.0) * chain_omega_2 * t270 - t78 * t617 - t93 * t618 - t106 * t619
        - t117 * t620 - t126 * t621 - t133 * t622 - t138 * t623 - t141 * t624) * t142;
    let chain_omega_9_dot_by_chain_omega_2 = t624 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_8_dot_by_chain_omega_2 = t623 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_2
        - t138 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_7_dot_by_chain_omega_2 = t622 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_2
        - t131 * chain_omega_9_dot_by_chain_omega_2
        - t133 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_6_dot_by_chain_omega_2 = t621 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_2
        - t122 * chain_omega_8_dot_by_chain_omega_2
        - t124 * chain_omega_9_dot_by_chain_omega_2
        - t126 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_5_dot_by_chain_omega_2 = t620 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_2
        - t111 * chain_omega_7_dot_by_chain_omega_2
        - t113 * chain_omega_8_dot_by_chain_omega_2
        - t115 * chain_omega_9_dot_by_chain_omega_2
        - t117 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_4_dot_by_chain_omega_2 = t619 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_2
        - t98 * chain_omega_6_dot_by_chain_omega_2
        - t100 * chain_omega_7_dot_by_chain_omega_2
        - t102 * chain_omega_8_dot_by_chain_omega_2
        - t104 * chain_omega_9_dot_by_chain_omega_2
        - t106 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_3_dot_by_chain_omega_2 = t618 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_2
        - t83 * chain_omega_5_dot_by_chain_omega_2
        - t85 * chain_omega_6_dot_by_chain_omega_2
        - t87 * chain_omega_7_dot_by_chain_omega_2
        - t89 * chain_omega_8_dot_by_chain_omega_2
        - t91 * chain_omega_9_dot_by_chain_omega_2
        - t93 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_2_dot_by_chain_omega_2 = t617 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_2
        - t66 * chain_omega_4_dot_by_chain_omega_2
        - t68 * chain_omega_5_dot_by_chain_omega_2
        - t70 * chain_omega_6_dot_by_chain_omega_2
        - t72 * chain_omega_7_dot_by_chain_omega_2
        - t74 * chain_omega_8_dot_by_chain_omega_2
        - t76 * chain_omega_9_dot_by_chain_omega_2
        - t78 * chain_omega_10_dot_by_chain_omega_2;
    let chain_omega_1_dot_by_chain_omega_2 = -(t616 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_2
        - t54 * chain_omega_3_dot_by_chain_omega_2
        - t55 * chain_omega_4_dot_by_chain_omega_2
        - t56 * chain_omega_5_dot_by_chain_omega_2
        - t57 * chain_omega_6_dot_by_chain_omega_2
        - t58 * chain_omega_7_dot_by_chain_omega_2
        - t59 * chain_omega_8_dot_by_chain_omega_2
        - t60 * chain_omega_9_dot_by_chain_omega_2
        - t61 * chain_omega_10_dot_by_chain_omega_2;
    let t625 = R::literal(16.0) * chain_omega_3;
    let t626 = t625 * t145;
    let t627 = t53 * t626 - t625 * t163;
    let t628 = t54 * t626 - t64 * t627;
    let t629 = t55 * t626 - R::literal(14.0) * chain_omega_3 * t186 - t66 * t627
        - t81 * t628;
    let t630 = t56 * t626 - R::literal(12.0) * chain_omega_3 * t198 - t68 * t627
        - t83 * t628 - t96 * t629;
    let t631 = t57 * t626 - R::literal(10.0) * chain_omega_3 * t211 - t70 * t627
        - t85 * t628 - t98 * t629 - t109 * t630;
    let t632 = t58 * t626 - R::literal(8.0) * chain_omega_3 * t225 - t72 * t627
        - t87 * t628 - t100 * t629 - t111 * t630 - t120 * t631;
    let t633 = t59 * t626 - R::literal(6.0) * chain_omega_3 * t240 - t74 * t627
        - t89 * t628 - t102 * t629 - t113 * t630 - t122 * t631 - t129 * t632;
    let t634 = t60 * t626 - R::literal(4.0) * chain_omega_3 * t256 - t76 * t627
        - t91 * t628 - t104 * t629 - t115 * t630 - t124 * t631 - t131 * t632
        - t136 * t633;
    let chain_omega_10_dot_by_chain_omega_3 = (t61 * t626
        - R::literal(2.0) * chain_omega_3 * t271 - t78 * t627 - t93 * t628 - t106 * t629
        - t117 * t630 - t126 * t631 - t133 * t632 - t138 * t633 - t141 * t634) * t142;
    let chain_omega_9_dot_by_chain_omega_3 = t634 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_8_dot_by_chain_omega_3 = t633 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_3
        - t138 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_7_dot_by_chain_omega_3 = t632 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_3
        - t131 * chain_omega_9_dot_by_chain_omega_3
        - t133 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_6_dot_by_chain_omega_3 = t631 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_3
        - t122 * chain_omega_8_dot_by_chain_omega_3
        - t124 * chain_omega_9_dot_by_chain_omega_3
        - t126 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_5_dot_by_chain_omega_3 = t630 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_3
        - t111 * chain_omega_7_dot_by_chain_omega_3
        - t113 * chain_omega_8_dot_by_chain_omega_3
        - t115 * chain_omega_9_dot_by_chain_omega_3
        - t117 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_4_dot_by_chain_omega_3 = t629 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_3
        - t98 * chain_omega_6_dot_by_chain_omega_3
        - t100 * chain_omega_7_dot_by_chain_omega_3
        - t102 * chain_omega_8_dot_by_chain_omega_3
        - t104 * chain_omega_9_dot_by_chain_omega_3
        - t106 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_3_dot_by_chain_omega_3 = t628 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_3
        - t83 * chain_omega_5_dot_by_chain_omega_3
        - t85 * chain_omega_6_dot_by_chain_omega_3
        - t87 * chain_omega_7_dot_by_chain_omega_3
        - t89 * chain_omega_8_dot_by_chain_omega_3
        - t91 * chain_omega_9_dot_by_chain_omega_3
        - t93 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_2_dot_by_chain_omega_3 = t627 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_3
        - t66 * chain_omega_4_dot_by_chain_omega_3
        - t68 * chain_omega_5_dot_by_chain_omega_3
        - t70 * chain_omega_6_dot_by_chain_omega_3
        - t72 * chain_omega_7_dot_by_chain_omega_3
        - t74 * chain_omega_8_dot_by_chain_omega_3
        - t76 * chain_omega_9_dot_by_chain_omega_3
        - t78 * chain_omega_10_dot_by_chain_omega_3;
    let chain_omega_1_dot_by_chain_omega_3 = -(t626 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_3
        - t54 * chain_omega_3_dot_by_chain_omega_3
        - t55 * chain_omega_4_dot_by_chain_omega_3
        - t56 * chain_omega_5_dot_by_chain_omega_3
        - t57 * chain_omega_6_dot_by_chain_omega_3
        - t58 * chain_omega_7_dot_by_chain_omega_3
        - t59 * chain_omega_8_dot_by_chain_omega_3
        - t60 * chain_omega_9_dot_by_chain_omega_3
        - t61 * chain_omega_10_dot_by_chain_omega_3;
    let t635 = R::literal(14.0) * chain_omega_4;
    let t636 = t635 * t147;
    let t637 = t53 * t636 - t635 * t164;
    let t638 = t54 * t636 - t635 * t175 - t64 * t637;
    let t639 = t55 * t636 - t66 * t637 - t81 * t638;
    let t640 = t56 * t636 - R::literal(12.0) * chain_omega_4 * t200 - t68 * t637
        - t83 * t638 - t96 * t639;
    let t641 = t57 * t636 - R::literal(10.0) * chain_omega_4 * t213 - t70 * t637
        - t85 * t638 - t98 * t639 - t109 * t640;
    let t642 = t58 * t636 - R::literal(8.0) * chain_omega_4 * t227 - t72 * t637
        - t87 * t638 - t100 * t639 - t111 * t640 - t120 * t641;
    let t643 = t59 * t636 - R::literal(6.0) * chain_omega_4 * t242 - t74 * t637
        - t89 * t638 - t102 * t639 - t113 * t640 - t122 * t641 - t129 * t642;
    let t644 = t60 * t636 - R::literal(4.0) * chain_omega_4 * t258 - t76 * t637
        - t91 * t638 - t104 * t639 - t115 * t640 - t124 * t641 - t131 * t642
        - t136 * t643;
    let chain_omega_10_dot_by_chain_omega_4 = (t61 * t636
        - R::literal(2.0) * chain_omega_4 * t272 - t78 * t637 - t93 * t638 - t106 * t639
        - t117 * t640 - t126 * t641 - t133 * t642 - t138 * t643 - t141 * t644) * t142;
    let chain_omega_9_dot_by_chain_omega_4 = t644 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_8_dot_by_chain_omega_4 = t643 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_4
        - t138 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_7_dot_by_chain_omega_4 = t642 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_4
        - t131 * chain_omega_9_dot_by_chain_omega_4
        - t133 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_6_dot_by_chain_omega_4 = t641 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_4
        - t122 * chain_omega_8_dot_by_chain_omega_4
        - t124 * chain_omega_9_dot_by_chain_omega_4
        - t126 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_5_dot_by_chain_omega_4 = t640 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_4
        - t111 * chain_omega_7_dot_by_chain_omega_4
        - t113 * chain_omega_8_dot_by_chain_omega_4
        - t115 * chain_omega_9_dot_by_chain_omega_4
        - t117 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_4_dot_by_chain_omega_4 = t639 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_4
        - t98 * chain_omega_6_dot_by_chain_omega_4
        - t100 * chain_omega_7_dot_by_chain_omega_4
        - t102 * chain_omega_8_dot_by_chain_omega_4
        - t104 * chain_omega_9_dot_by_chain_omega_4
        - t106 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_3_dot_by_chain_omega_4 = t638 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_4
        - t83 * chain_omega_5_dot_by_chain_omega_4
        - t85 * chain_omega_6_dot_by_chain_omega_4
        - t87 * chain_omega_7_dot_by_chain_omega_4
        - t89 * chain_omega_8_dot_by_chain_omega_4
        - t91 * chain_omega_9_dot_by_chain_omega_4
        - t93 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_2_dot_by_chain_omega_4 = t637 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_4
        - t66 * chain_omega_4_dot_by_chain_omega_4
        - t68 * chain_omega_5_dot_by_chain_omega_4
        - t70 * chain_omega_6_dot_by_chain_omega_4
        - t72 * chain_omega_7_dot_by_chain_omega_4
        - t74 * chain_omega_8_dot_by_chain_omega_4
        - t76 * chain_omega_9_dot_by_chain_omega_4
        - t78 * chain_omega_10_dot_by_chain_omega_4;
    let chain_omega_1_dot_by_chain_omega_4 = -(t636 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_4
        - t54 * chain_omega_3_dot_by_chain_omega_4
        - t55 * chain_omega_4_dot_by_chain_omega_4
        - t56 * chain_omega_5_dot_by_chain_omega_4
        - t57 * chain_omega_6_dot_by_chain_omega_4
        - t58 * chain_omega_7_dot_by_chain_omega_4
        - t59 * chain_omega_8_dot_by_chain_omega_4
        - t60 * chain_omega_9_dot_by_chain_omega_4
        - t61 * chain_omega_10_dot_by_chain_omega_4;
    let t645 = R::literal(12.0) * chain_omega_5;
    let t646 = t645 * t149;
    let t647 = t53 * t646 - t645 * t165;
    let t648 = t54 * t646 - t645 * t176 - t64 * t647;
    let t649 = t55 * t646 - t645 * t188 - t66 * t647 - t81 * t648;
    let t650 = t56 * t646 - t68 * t647 - t83 * t648 - t96 * t649;
    let t651 = t57 * t646 - R::literal(10.0) * chain_omega_5 * t215 - t70 * t647
        - t85 * t648 - t98 * t649 - t109 * t650;
    let t652 = t58 * t646 - R::literal(8.0) * chain_omega_5 * t229 - t72 * t647
        - t87 * t648 - t100 * t649 - t111 * t650 - t120 * t651;
    let t653 = t59 * t646 - R::literal(6.0) * chain_omega_5 * t244 - t74 * t647
        - t89 * t648 - t102 * t649 - t113 * t650 - t122 * t651 - t129 * t652;
    let t654 = t60 * t646 - R::literal(4.0) * chain_omega_5 * t260 - t76 * t647
        - t91 * t648 - t104 * t649 - t115 * t650 - t124 * t651 - t131 * t652
        - t136 * t653;
    let chain_omega_10_dot_by_chain_omega_5 = (t61 * t646
        - R::literal(2.0) * chain_omega_5 * t273 - t78 * t647 - t93 * t648 - t106 * t649
        - t117 * t650 - t126 * t651 - t133 * t652 - t138 * t653 - t141 * t654) * t142;
    let chain_omega_9_dot_by_chain_omega_5 = t654 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_8_dot_by_chain_omega_5 = t653 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_5
        - t138 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_7_dot_by_chain_omega_5 = t652 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_5
        - t131 * chain_omega_9_dot_by_chain_omega_5
        - t133 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_6_dot_by_chain_omega_5 = t651 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_5
        - t122 * chain_omega_8_dot_by_chain_omega_5
        - t124 * chain_omega_9_dot_by_chain_omega_5
        - t126 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_5_dot_by_chain_omega_5 = t650 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_5
        - t111 * chain_omega_7_dot_by_chain_omega_5
        - t113 * chain_omega_8_dot_by_chain_omega_5
        - t115 * chain_omega_9_dot_by_chain_omega_5
        - t117 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_4_dot_by_chain_omega_5 = t649 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_5
        - t98 * chain_omega_6_dot_by_chain_omega_5
        - t100 * chain_omega_7_dot_by_chain_omega_5
        - t102 * chain_omega_8_dot_by_chain_omega_5
        - t104 * chain_omega_9_dot_by_chain_omega_5
        - t106 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_3_dot_by_chain_omega_5 = t648 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_5
        - t83 * chain_omega_5_dot_by_chain_omega_5
        - t85 * chain_omega_6_dot_by_chain_omega_5
        - t87 * chain_omega_7_dot_by_chain_omega_5
        - t89 * chain_omega_8_dot_by_chain_omega_5
        - t91 * chain_omega_9_dot_by_chain_omega_5
        - t93 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_2_dot_by_chain_omega_5 = t647 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_5
        - t66 * chain_omega_4_dot_by_chain_omega_5
        - t68 * chain_omega_5_dot_by_chain_omega_5
        - t70 * chain_omega_6_dot_by_chain_omega_5
        - t72 * chain_omega_7_dot_by_chain_omega_5
        - t74 * chain_omega_8_dot_by_chain_omega_5
        - t76 * chain_omega_9_dot_by_chain_omega_5
        - t78 * chain_omega_10_dot_by_chain_omega_5;
    let chain_omega_1_dot_by_chain_omega_5 = -(t646 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_5
        - t54 * chain_omega_3_dot_by_chain_omega_5
        - t55 * chain_omega_4_dot_by_chain_omega_5
        - t56 * chain_omega_5_dot_by_chain_omega_5
        - t57 * chain_omega_6_dot_by_chain_omega_5
        - t58 * chain_omega_7_dot_by_chain_omega_5
        - t59 * chain_omega_8_dot_by_chain_omega_5
        - t60 * chain_omega_9_dot_by_chain_omega_5
        - t61 * chain_omega_10_dot_by_chain_omega_5;
    let t655 = R::literal(10.0) * chain_omega_6;
    let t656 = t655 * t151;
    let t657 = t53 * t656 - t655 * t166;
    let t658 = t54 * t656 - t655 * t177 - t64 * t657;
    let t659 = t55 * t656 - t655 * t189 - t66 * t657 - t81 * t658;
    let t660 = t56 * t656 - t655 * t202 - t68 * t657 - t83 * t658 - t96 * t659;
    let t661 = t57 * t656 - t70 * t657 - t85 * t658 - t98 * t659 - t109 * t660;
    let t662 = t58 * t656 - R::literal(8.0) * chain_omega_6 * t231 - t72 * t657
        - t87 * t658 - t100 * t659 - t111 * t660 - t120 * t661;
    let t663 = t59 * t656 - R::literal(6.0) * chain_omega_6 * t246 - t74 * t657
        - t89 * t658 - t102 * t659 - t113 * t660 - t122 * t661 - t129 * t662;
    let t664 = t60 * t656 - R::literal(4.0) * chain_omega_6 * t262 - t76 * t657
        - t91 * t658 - t104 * t659 - t115 * t660 - t124 * t661 - t131 * t662
        - t136 * t663;
    let chain_omega_10_dot_by_chain_omega_6 = (t61 * t656
        - R::literal(2.0) * chain_omega_6 * t274 - t78 * t657 - t93 * t658 - t106 * t659
        - t117 * t660 - t126 * t661 - t133 * t662 - t138 * t663 - t141 * t664) * t142;
    let chain_omega_9_dot_by_chain_omega_6 = t664 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_8_dot_by_chain_omega_6 = t663 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_6
        - t138 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_7_dot_by_chain_omega_6 = t662 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_6
        - t131 * chain_omega_9_dot_by_chain_omega_6
        - t133 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_6_dot_by_chain_omega_6 = t661 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_6
        - t122 * chain_omega_8_dot_by_chain_omega_6
        - t124 * chain_omega_9_dot_by_chain_omega_6
        - t126 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_5_dot_by_chain_omega_6 = t660 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_6
        - t111 * chain_omega_7_dot_by_chain_omega_6
        - t113 * chain_omega_8_dot_by_chain_omega_6
        - t115 * chain_omega_9_dot_by_chain_omega_6
        - t117 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_4_dot_by_chain_omega_6 = t659 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_6
        - t98 * chain_omega_6_dot_by_chain_omega_6
        - t100 * chain_omega_7_dot_by_chain_omega_6
        - t102 * chain_omega_8_dot_by_chain_omega_6
        - t104 * chain_omega_9_dot_by_chain_omega_6
        - t106 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_3_dot_by_chain_omega_6 = t658 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_6
        - t83 * chain_omega_5_dot_by_chain_omega_6
        - t85 * chain_omega_6_dot_by_chain_omega_6
        - t87 * chain_omega_7_dot_by_chain_omega_6
        - t89 * chain_omega_8_dot_by_chain_omega_6
        - t91 * chain_omega_9_dot_by_chain_omega_6
        - t93 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_2_dot_by_chain_omega_6 = t657 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_6
        - t66 * chain_omega_4_dot_by_chain_omega_6
        - t68 * chain_omega_5_dot_by_chain_omega_6
        - t70 * chain_omega_6_dot_by_chain_omega_6
        - t72 * chain_omega_7_dot_by_chain_omega_6
        - t74 * chain_omega_8_dot_by_chain_omega_6
        - t76 * chain_omega_9_dot_by_chain_omega_6
        - t78 * chain_omega_10_dot_by_chain_omega_6;
    let chain_omega_1_dot_by_chain_omega_6 = -(t656 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_6
        - t54 * chain_omega_3_dot_by_chain_omega_6
        - t55 * chain_omega_4_dot_by_chain_omega_6
        - t56 * chain_omega_5_dot_by_chain_omega_6
        - t57 * chain_omega_6_dot_by_chain_omega_6
        - t58 * chain_omega_7_dot_by_chain_omega_6
        - t59 * chain_omega_8_dot_by_chain_omega_6
        - t60 * chain_omega_9_dot_by_chain_omega_6
        - t61 * chain_omega_10_dot_by_chain_omega_6;
    let t665 = R::literal(8.0) * chain_omega_7;
    let t666 = t665 * t153;
    let t667 = t53 * t666 - t665 * t167;
    let t668 = t54 * t666 - t665 * t178 - t64 * t667;
    let t669 = t55 * t666 - t665 * t190 - t66 * t667 - t81 * t668;
    let t670 = t56 * t666 - t665 * t203 - t68 * t667 - t83 * t668 - t96 * t669;
    let t671 = t57 * t666 - t665 * t217 - t70 * t667 - t85 * t668 - t98 * t669
        - t109 * t670;
    let t672 = t58 * t666 - t72 * t667 - t87 * t668 - t100 * t669 - t111 * t670
        - t120 * t671;
    let t673 = t59 * t666 - R::literal(6.0) * chain_omega_7 * t248 - t74 * t667
        - t89 * t668 - t102 * t669 - t113 * t670 - t122 * t671 - t129 * t672;
    let t674 = t60 * t666 - R::literal(4.0) * chain_omega_7 * t264 - t76 * t667
        - t91 * t668 - t104 * t669 - t115 * t670 - t124 * t671 - t131 * t672
        - t136 * t673;
    let chain_omega_10_dot_by_chain_omega_7 = (t61 * t666
        - R::literal(2.0) * chain_omega_7 * t275 - t78 * t667 - t93 * t668 - t106 * t669
        - t117 * t670 - t126 * t671 - t133 * t672 - t138 * t673 - t141 * t674) * t142;
    let chain_omega_9_dot_by_chain_omega_7 = t674 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_8_dot_by_chain_omega_7 = t673 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_7
        - t138 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_7_dot_by_chain_omega_7 = t672 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_7
        - t131 * chain_omega_9_dot_by_chain_omega_7
        - t133 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_6_dot_by_chain_omega_7 = t671 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_7
        - t122 * chain_omega_8_dot_by_chain_omega_7
        - t124 * chain_omega_9_dot_by_chain_omega_7
        - t126 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_5_dot_by_chain_omega_7 = t670 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_7
        - t111 * chain_omega_7_dot_by_chain_omega_7
        - t113 * chain_omega_8_dot_by_chain_omega_7
        - t115 * chain_omega_9_dot_by_chain_omega_7
        - t117 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_4_dot_by_chain_omega_7 = t669 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_7
        - t98 * chain_omega_6_dot_by_chain_omega_7
        - t100 * chain_omega_7_dot_by_chain_omega_7
        - t102 * chain_omega_8_dot_by_chain_omega_7
        - t104 * chain_omega_9_dot_by_chain_omega_7
        - t106 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_3_dot_by_chain_omega_7 = t668 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_7
        - t83 * chain_omega_5_dot_by_chain_omega_7
        - t85 * chain_omega_6_dot_by_chain_omega_7
        - t87 * chain_omega_7_dot_by_chain_omega_7
        - t89 * chain_omega_8_dot_by_chain_omega_7
        - t91 * chain_omega_9_dot_by_chain_omega_7
        - t93 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_2_dot_by_chain_omega_7 = t667 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_7
        - t66 * chain_omega_4_dot_by_chain_omega_7
        - t68 * chain_omega_5_dot_by_chain_omega_7
        - t70 * chain_omega_6_dot_by_chain_omega_7
        - t72 * chain_omega_7_dot_by_chain_omega_7
        - t74 * chain_omega_8_dot_by_chain_omega_7
        - t76 * chain_omega_9_dot_by_chain_omega_7
        - t78 * chain_omega_10_dot_by_chain_omega_7;
    let chain_omega_1_dot_by_chain_omega_7 = -(t666 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_7
        - t54 * chain_omega_3_dot_by_chain_omega_7
        - t55 * chain_omega_4_dot_by_chain_omega_7
        - t56 * chain_omega_5_dot_by_chain_omega_7
        - t57 * chain_omega_6_dot_by_chain_omega_7
        - t58 * chain_omega_7_dot_by_chain_omega_7
        - t59 * chain_omega_8_dot_by_chain_omega_7
        - t60 * chain_omega_9_dot_by_chain_omega_7
        - t61 * chain_omega_10_dot_by_chain_omega_7;
    let t675 = R::literal(6.0) * chain_omega_8;
    let t676 = t675 * t155;
    let t677 = t53 * t676 - t675 * t168;
    let t678 = t54 * t676 - t675 * t179 - t64 * t677;
    let t679 = t55 * t676 - t675 * t191 - t66 * t677 - t81 * t678;
    let t680 = t56 * t676 - t675 * t204 - t68 * t677 - t83 * t678 - t96 * t679;
    let t681 = t57 * t676 - t675 * t218 - t70 * t677 - t85 * t678 - t98 * t679
        - t109 * t680;
    let t682 = t58 * t676 - t675 * t233 - t72 * t677 - t87 * t678 - t100 * t679
        - t111 * t680 - t120 * t681;
    let t683 = t59 * t676 - t74 * t677 - t89 * t678 - t102 * t679 - t113 * t680
        - t122 * t681 - t129 * t682;
    let t684 = t60 * t676 - R::literal(4.0) * chain_omega_8 * t266 - t76 * t677
        - t91 * t678 - t104 * t679 - t115 * t680 - t124 * t681 - t131 * t682
        - t136 * t683;
    let chain_omega_10_dot_by_chain_omega_8 = (t61 * t676
        - R::literal(2.0) * chain_omega_8 * t276 - t78 * t677 - t93 * t678 - t106 * t679
        - t117 * t680 - t126 * t681 - t133 * t682 - t138 * t683 - t141 * t684) * t142;
    let chain_omega_9_dot_by_chain_omega_8 = t684 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_8_dot_by_chain_omega_8 = t683 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_8
        - t138 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_7_dot_by_chain_omega_8 = t682 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_8
        - t131 * chain_omega_9_dot_by_chain_omega_8
        - t133 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_6_dot_by_chain_omega_8 = t681 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_8
        - t122 * chain_omega_8_dot_by_chain_omega_8
        - t124 * chain_omega_9_dot_by_chain_omega_8
        - t126 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_5_dot_by_chain_omega_8 = t680 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_8
        - t111 * chain_omega_7_dot_by_chain_omega_8
        - t113 * chain_omega_8_dot_by_chain_omega_8
        - t115 * chain_omega_9_dot_by_chain_omega_8
        - t117 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_4_dot_by_chain_omega_8 = t679 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_8
        - t98 * chain_omega_6_dot_by_chain_omega_8
        - t100 * chain_omega_7_dot_by_chain_omega_8
        - t102 * chain_omega_8_dot_by_chain_omega_8
        - t104 * chain_omega_9_dot_by_chain_omega_8
        - t106 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_3_dot_by_chain_omega_8 = t678 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_8
        - t83 * chain_omega_5_dot_by_chain_omega_8
        - t85 * chain_omega_6_dot_by_chain_omega_8
        - t87 * chain_omega_7_dot_by_chain_omega_8
        - t89 * chain_omega_8_dot_by_chain_omega_8
        - t91 * chain_omega_9_dot_by_chain_omega_8
        - t93 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_2_dot_by_chain_omega_8 = t677 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_8
        - t66 * chain_omega_4_dot_by_chain_omega_8
        - t68 * chain_omega_5_dot_by_chain_omega_8
        - t70 * chain_omega_6_dot_by_chain_omega_8
        - t72 * chain_omega_7_dot_by_chain_omega_8
        - t74 * chain_omega_8_dot_by_chain_omega_8
        - t76 * chain_omega_9_dot_by_chain_omega_8
        - t78 * chain_omega_10_dot_by_chain_omega_8;
    let chain_omega_1_dot_by_chain_omega_8 = -(t676 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_8
        - t54 * chain_omega_3_dot_by_chain_omega_8
        - t55 * chain_omega_4_dot_by_chain_omega_8
        - t56 * chain_omega_5_dot_by_chain_omega_8
        - t57 * chain_omega_6_dot_by_chain_omega_8
        - t58 * chain_omega_7_dot_by_chain_omega_8
        - t59 * chain_omega_8_dot_by_chain_omega_8
        - t60 * chain_omega_9_dot_by_chain_omega_8
        - t61 * chain_omega_10_dot_by_chain_omega_8;
    let t685 = R::literal(4.0) * chain_omega_9;
    let t686 = t685 * t157;
    let t687 = t53 * t686 - t685 * t169;
    let t688 = t54 * t686 - t685 * t180 - t64 * t687;
    let t689 = t55 * t686 - t685 * t192 - t66 * t687 - t81 * t688;
    let t690 = t56 * t686 - t685 * t205 - t68 * t687 - t83 * t688 - t96 * t689;
    let t691 = t57 * t686 - t685 * t219 - t70 * t687 - t85 * t688 - t98 * t689
        - t109 * t690;
    let t692 = t58 * t686 - t685 * t234 - t72 * t687 - t87 * t688 - t100 * t689
        - t111 * t690 - t120 * t691;
    let t693 = t59 * t686 - t685 * t250 - t74 * t687 - t89 * t688 - t102 * t689
        - t113 * t690 - t122 * t691 - t129 * t692;
    let t694 = t60 * t686 - t76 * t687 - t91 * t688 - t104 * t689 - t115 * t690
        - t124 * t691 - t131 * t692 - t136 * t693;
    let chain_omega_10_dot_by_chain_omega_9 = (t61 * t686
        - R::literal(2.0) * chain_omega_9 * t277 - t78 * t687 - t93 * t688 - t106 * t689
        - t117 * t690 - t126 * t691 - t133 * t692 - t138 * t693 - t141 * t694) * t142;
    let chain_omega_9_dot_by_chain_omega_9 = t694 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_8_dot_by_chain_omega_9 = t693 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_9
        - t138 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_7_dot_by_chain_omega_9 = t692 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_9
        - t131 * chain_omega_9_dot_by_chain_omega_9
        - t133 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_6_dot_by_chain_omega_9 = t691 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_9
        - t122 * chain_omega_8_dot_by_chain_omega_9
        - t124 * chain_omega_9_dot_by_chain_omega_9
        - t126 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_5_dot_by_chain_omega_9 = t690 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_9
        - t111 * chain_omega_7_dot_by_chain_omega_9
        - t113 * chain_omega_8_dot_by_chain_omega_9
        - t115 * chain_omega_9_dot_by_chain_omega_9
        - t117 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_4_dot_by_chain_omega_9 = t689 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_9
        - t98 * chain_omega_6_dot_by_chain_omega_9
        - t100 * chain_omega_7_dot_by_chain_omega_9
        - t102 * chain_omega_8_dot_by_chain_omega_9
        - t104 * chain_omega_9_dot_by_chain_omega_9
        - t106 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_3_dot_by_chain_omega_9 = t688 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_9
        - t83 * chain_omega_5_dot_by_chain_omega_9
        - t85 * chain_omega_6_dot_by_chain_omega_9
        - t87 * chain_omega_7_dot_by_chain_omega_9
        - t89 * chain_omega_8_dot_by_chain_omega_9
        - t91 * chain_omega_9_dot_by_chain_omega_9
        - t93 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_2_dot_by_chain_omega_9 = t687 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_9
        - t66 * chain_omega_4_dot_by_chain_omega_9
        - t68 * chain_omega_5_dot_by_chain_omega_9
        - t70 * chain_omega_6_dot_by_chain_omega_9
        - t72 * chain_omega_7_dot_by_chain_omega_9
        - t74 * chain_omega_8_dot_by_chain_omega_9
        - t76 * chain_omega_9_dot_by_chain_omega_9
        - t78 * chain_omega_10_dot_by_chain_omega_9;
    let chain_omega_1_dot_by_chain_omega_9 = -(t686 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_9
        - t54 * chain_omega_3_dot_by_chain_omega_9
        - t55 * chain_omega_4_dot_by_chain_omega_9
        - t56 * chain_omega_5_dot_by_chain_omega_9
        - t57 * chain_omega_6_dot_by_chain_omega_9
        - t58 * chain_omega_7_dot_by_chain_omega_9
        - t59 * chain_omega_8_dot_by_chain_omega_9
        - t60 * chain_omega_9_dot_by_chain_omega_9
        - t61 * chain_omega_10_dot_by_chain_omega_9;
    let t695 = R::literal(2.0) * chain_omega_10;
    let t696 = t695 * t159;
    let t697 = t53 * t696 - t695 * t170;
    let t698 = t54 * t696 - t695 * t181 - t64 * t697;
    let t699 = t55 * t696 - t695 * t193 - t66 * t697 - t81 * t698;
    let t700 = t56 * t696 - t695 * t206 - t68 * t697 - t83 * t698 - t96 * t699;
    let t701 = t57 * t696 - t695 * t220 - t70 * t697 - t85 * t698 - t98 * t699
        - t109 * t700;
    let t702 = t58 * t696 - t695 * t235 - t72 * t697 - t87 * t698 - t100 * t699
        - t111 * t700 - t120 * t701;
    let t703 = t59 * t696 - t695 * t251 - t74 * t697 - t89 * t698 - t102 * t699
        - t113 * t700 - t122 * t701 - t129 * t702;
    let t704 = t60 * t696 - t695 * t268 - t76 * t697 - t91 * t698 - t104 * t699
        - t115 * t700 - t124 * t701 - t131 * t702 - t136 * t703;
    let chain_omega_10_dot_by_chain_omega_10 = (t61 * t696 - t78 * t697 - t93 * t698
        - t106 * t699 - t117 * t700 - t126 * t701 - t133 * t702 - t138 * t703
        - t141 * t704) * t142;
    let chain_omega_9_dot_by_chain_omega_10 = t704 * t139
        - t141 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_8_dot_by_chain_omega_10 = t703 * t134
        - t136 * chain_omega_9_dot_by_chain_omega_10
        - t138 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_7_dot_by_chain_omega_10 = t702 * t127
        - t129 * chain_omega_8_dot_by_chain_omega_10
        - t131 * chain_omega_9_dot_by_chain_omega_10
        - t133 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_6_dot_by_chain_omega_10 = t701 * t118
        - t120 * chain_omega_7_dot_by_chain_omega_10
        - t122 * chain_omega_8_dot_by_chain_omega_10
        - t124 * chain_omega_9_dot_by_chain_omega_10
        - t126 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_5_dot_by_chain_omega_10 = t700 * t107
        - t109 * chain_omega_6_dot_by_chain_omega_10
        - t111 * chain_omega_7_dot_by_chain_omega_10
        - t113 * chain_omega_8_dot_by_chain_omega_10
        - t115 * chain_omega_9_dot_by_chain_omega_10
        - t117 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_4_dot_by_chain_omega_10 = t699 * t94
        - t96 * chain_omega_5_dot_by_chain_omega_10
        - t98 * chain_omega_6_dot_by_chain_omega_10
        - t100 * chain_omega_7_dot_by_chain_omega_10
        - t102 * chain_omega_8_dot_by_chain_omega_10
        - t104 * chain_omega_9_dot_by_chain_omega_10
        - t106 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_3_dot_by_chain_omega_10 = t698 * t79
        - t81 * chain_omega_4_dot_by_chain_omega_10
        - t83 * chain_omega_5_dot_by_chain_omega_10
        - t85 * chain_omega_6_dot_by_chain_omega_10
        - t87 * chain_omega_7_dot_by_chain_omega_10
        - t89 * chain_omega_8_dot_by_chain_omega_10
        - t91 * chain_omega_9_dot_by_chain_omega_10
        - t93 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_2_dot_by_chain_omega_10 = t697 * t62
        - t64 * chain_omega_3_dot_by_chain_omega_10
        - t66 * chain_omega_4_dot_by_chain_omega_10
        - t68 * chain_omega_5_dot_by_chain_omega_10
        - t70 * chain_omega_6_dot_by_chain_omega_10
        - t72 * chain_omega_7_dot_by_chain_omega_10
        - t74 * chain_omega_8_dot_by_chain_omega_10
        - t76 * chain_omega_9_dot_by_chain_omega_10
        - t78 * chain_omega_10_dot_by_chain_omega_10;
    let chain_omega_1_dot_by_chain_omega_10 = -(t696 * R::literal(0.1))
        - t53 * chain_omega_2_dot_by_chain_omega_10
        - t54 * chain_omega_3_dot_by_chain_omega_10
        - t55 * chain_omega_4_dot_by_chain_omega_10
        - t56 * chain_omega_5_dot_by_chain_omega_10
        - t57 * chain_omega_6_dot_by_chain_omega_10
        - t58 * chain_omega_7_dot_by_chain_omega_10
        - t59 * chain_omega_8_dot_by_chain_omega_10
        - t60 * chain_omega_9_dot_by_chain_omega_10
        - t61 * chain_omega_10_dot_by_chain_omega_10;
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
        chain_omega_1_dot_by_chain_theta_1,
        chain_omega_1_dot_by_chain_theta_2,
        chain_omega_1_dot_by_chain_theta_3,
        chain_omega_1_dot_by_chain_theta_4,
        chain_omega_1_dot_by_chain_theta_5,
        chain_omega_1_dot_by_chain_theta_6,
        chain_omega_1_dot_by_chain_theta_7,
        chain_omega_1_dot_by_chain_theta_8,
        chain_omega_1_dot_by_chain_theta_9,
        chain_omega_1_dot_by_chain_theta_10,
        chain_omega_1_dot_by_chain_omega_1,
        chain_omega_1_dot_by_chain_omega_2,
        chain_omega_1_dot_by_chain_omega_3,
        chain_omega_1_dot_by_chain_omega_4,
        chain_omega_1_dot_by_chain_omega_5,
        chain_omega_1_dot_by_chain_omega_6,
        chain_omega_1_dot_by_chain_omega_7,
        chain_omega_1_dot_by_chain_omega_8,
        chain_omega_1_dot_by_chain_omega_9,
        chain_omega_1_dot_by_chain_omega_10,
        chain_omega_2_dot_by_chain_theta_1,
        chain_omega_2_dot_by_chain_theta_2,
        chain_omega_2_dot_by_chain_theta_3,
        chain_omega_2_dot_by_chain_theta_4,
        chain_omega_2_dot_by_chain_theta_5,
        chain_omega_2_dot_by_chain_theta_6,
        chain_omega_2_dot_by_chain_theta_7,
        chain_omega_2_dot_by_chain_theta_8,
        chain_omega_2_dot_by_chain_theta_9,
        chain_omega_2_dot_by_chain_theta_10,
        chain_omega_2_dot_by_chain_omega_1,
        chain_omega_2_dot_by_chain_omega_2,
        chain_omega_2_dot_by_chain_omega_3,
        chain_omega_2_dot_by_chain_omega_4,
        chain_omega_2_dot_by_chain_omega_5,
        chain_omega_2_dot_by_chain_omega_6,
        chain_omega_2_dot_by_chain_omega_7,
        chain_omega_2_dot_by_chain_omega_8,
        chain_omega_2_dot_by_chain_omega_9,
        chain_omega_2_dot_by_chain_omega_10,
        chain_omega_3_dot_by_chain_theta_1,
        chain_omega_3_dot_by_chain_theta_2,
        chain_omega_3_dot_by_chain_theta_3,
        chain_omega_3_dot_by_chain_theta_4,
        chain_omega_3_dot_by_chain_theta_5,
        chain_omega_3_dot_by_chain_theta_6,
        chain_omega_3_dot_by_chain_theta_7,
        chain_omega_3_dot_by_chain_theta_8,
        chain_omega_3_dot_by_chain_theta_9,
        chain_omega_3_dot_by_chain_theta_10,
        chain_omega_3_dot_by_chain_omega_1,
        chain_omega_3_dot_by_chain_omega_2,
        chain_omega_3_dot_by_chain_omega_3,
        chain_omega_3_dot_by_chain_omega_4,
        chain_omega_3_dot_by_chain_omega_5,
        chain_omega_3_dot_by_chain_omega_6,
        chain_omega_3_dot_by_chain_omega_7,
        chain_omega_3_dot_by_chain_omega_8,
        chain_omega_3_dot_by_chain_omega_9,
        chain_omega_3_dot_by_chain_omega_10,
        chain_omega_4_dot_by_chain_theta_1,
        chain_omega_4_dot_by_chain_theta_2,
        chain_omega_4_dot_by_chain_theta_3,
        chain_omega_4_dot_by_chain_theta_4,
        chain_omega_4_dot_by_chain_theta_5,
        chain_omega_4_dot_by_chain_theta_6,
        chain_omega_4_dot_by_chain_theta_7,
        chain_omega_4_dot_by_chain_theta_8,
        chain_omega_4_dot_by_chain_theta_9,
        chain_omega_4_dot_by_chain_theta_10,
        chain_omega_4_dot_by_chain_omega_1,
        chain_omega_4_dot_by_chain_omega_2,
        chain_omega_4_dot_by_chain_omega_3,
        chain_omega_4_dot_by_chain_omega_4,
        chain_omega_4_dot_by_chain_omega_5,
        chain_omega_4_dot_by_chain_omega_6,
        chain_omega_4_dot_by_chain_omega_7,
        chain_omega_4_dot_by_chain_omega_8,
        chain_omega_4_dot_by_chain_omega_9,
        chain_omega_4_dot_by_chain_omega_10,
        chain_omega_5_dot_by_chain_theta_1,
        chain_omega_5_dot_by_chain_theta_2,
        chain_omega_5_dot_by_chain_theta_3,
        chain_omega_5_dot_by_chain_theta_4,
        chain_omega_5_dot_by_chain_theta_5,
        chain_omega_5_dot_by_chain_theta_6,
        chain_omega_5_dot_by_chain_theta_7,
        chain_omega_5_dot_by_chain_theta_8,
        chain_omega_5_dot_by_chain_theta_9,
        chain_omega_5_dot_by_chain_theta_10,
        chain_omega_5_dot_by_chain_omega_1,
        chain_omega_5_dot_by_chain_omega_2,
        chain_omega_5_dot_by_chain_omega_3,
        chain_omega_5_dot_by_chain_omega_4,
        chain_omega_5_dot_by_chain_omega_5,
        chain_omega_5_dot_by_chain_omega_6,
        chain_omega_5_dot_by_chain_omega_7,
        chain_omega_5_dot_by_chain_omega_8,
        chain_omega_5_dot_by_chain_omega_9,
        chain_omega_5_dot_by_chain_omega_10,
        chain_omega_6_dot_by_chain_theta_1,
        chain_omega_6_dot_by_chain_theta_2,
        chain_omega_6_dot_by_chain_theta_3,
        chain_omega_6_dot_by_chain_theta_4,
        chain_omega_6_dot_by_chain_theta_5,
        chain_omega_6_dot_by_chain_theta_6,
        chain_omega_6_dot_by_chain_theta_7,
        chain_omega_6_dot_by_chain_theta_8,
        chain_omega_6_dot_by_chain_theta_9,
        chain_omega_6_dot_by_chain_theta_10,
        chain_omega_6_dot_by_chain_omega_1,
        chain_omega_6_dot_by_chain_omega_2,
        chain_omega_6_dot_by_chain_omega_3,
        chain_omega_6_dot_by_chain_omega_4,
        chain_omega_6_dot_by_chain_omega_5,
        chain_omega_6_dot_by_chain_omega_6,
        chain_omega_6_dot_by_chain_omega_7,
        chain_omega_6_dot_by_chain_omega_8,
        chain_omega_6_dot_by_chain_omega_9,
        chain_omega_6_dot_by_chain_omega_10,
        chain_omega_7_dot_by_chain_theta_1,
        chain_omega_7_dot_by_chain_theta_2,
        chain_omega_7_dot_by_chain_theta_3,
        chain_omega_7_dot_by_chain_theta_4,
        chain_omega_7_dot_by_chain_theta_5,
        chain_omega_7_dot_by_chain_theta_6,
        chain_omega_7_dot_by_chain_theta_7,
        chain_omega_7_dot_by_chain_theta_8,
        chain_omega_7_dot_by_chain_theta_9,
        chain_omega_7_dot_by_chain_theta_10,
        chain_omega_7_dot_by_chain_omega_1,
        chain_omega_7_dot_by_chain_omega_2,
        chain_omega_7_dot_by_chain_omega_3,
        chain_omega_7_dot_by_chain_omega_4,
        chain_omega_7_dot_by_chain_omega_5,
        chain_omega_7_dot_by_chain_omega_6,
        chain_omega_7_dot_by_chain_omega_7,
        chain_omega_7_dot_by_chain_omega_8,
        chain_omega_7_dot_by_chain_omega_9,
        chain_omega_7_dot_by_chain_omega_10,
        chain_omega_8_dot_by_chain_theta_1,
        chain_omega_8_dot_by_chain_theta_2,
        chain_omega_8_dot_by_chain_theta_3,
        chain_omega_8_dot_by_chain_theta_4,
        chain_omega_8_dot_by_chain_theta_5,
        chain_omega_8_dot_by_chain_theta_6,
        chain_omega_8_dot_by_chain_theta_7,
        chain_omega_8_dot_by_chain_theta_8,
        chain_omega_8_dot_by_chain_theta_9,
        chain_omega_8_dot_by_chain_theta_10,
        chain_omega_8_dot_by_chain_omega_1,
        chain_omega_8_dot_by_chain_omega_2,
        chain_omega_8_dot_by_chain_omega_3,
        chain_omega_8_dot_by_chain_omega_4,
        chain_omega_8_dot_by_chain_omega_5,
        chain_omega_8_dot_by_chain_omega_6,
        chain_omega_8_dot_by_chain_omega_7,
        chain_omega_8_dot_by_chain_omega_8,
        chain_omega_8_dot_by_chain_omega_9,
        chain_omega_8_dot_by_chain_omega_10,
        chain_omega_9_dot_by_chain_theta_1,
        chain_omega_9_dot_by_chain_theta_2,
        chain_omega_9_dot_by_chain_theta_3,
        chain_omega_9_dot_by_chain_theta_4,
        chain_omega_9_dot_by_chain_theta_5,
        chain_omega_9_dot_by_chain_theta_6,
        chain_omega_9_dot_by_chain_theta_7,
        chain_omega_9_dot_by_chain_theta_8,
        chain_omega_9_dot_by_chain_theta_9,
        chain_omega_9_dot_by_chain_theta_10,
        chain_omega_9_dot_by_chain_omega_1,
        chain_omega_9_dot_by_chain_omega_2,
        chain_omega_9_dot_by_chain_omega_3,
        chain_omega_9_dot_by_chain_omega_4,
        chain_omega_9_dot_by_chain_omega_5,
        chain_omega_9_dot_by_chain_omega_6,
        chain_omega_9_dot_by_chain_omega_7,
        chain_omega_9_dot_by_chain_omega_8,
        chain_omega_9_dot_by_chain_omega_9,
        chain_omega_9_dot_by_chain_omega_10,
        chain_omega_10_dot_by_chain_theta_1,
        chain_omega_10_dot_by_chain_theta_2,
        chain_omega_10_dot_by_chain_theta_3,
        chain_omega_10_dot_by_chain_theta_4,
        chain_omega_10_dot_by_chain_theta_5,
        chain_omega_10_dot_by_chain_theta_6,
        chain_omega_10_dot_by_chain_theta_7,
        chain_omega_10_dot_by_chain_theta_8,
        chain_omega_10_dot_by_chain_theta_9,
        chain_omega_10_dot_by_chain_theta_10,
        chain_omega_10_dot_by_chain_omega_1,
        chain_omega_10_dot_by_chain_omega_2,
        chain_omega_10_dot_by_chain_omega_3,
        chain_omega_10_dot_by_chain_omega_4,
        chain_omega_10_dot_by_chain_omega_5,
        chain_omega_10_dot_by_chain_omega_6,
        chain_omega_10_dot_by_chain_omega_7,
        chain_omega_10_dot_by_chain_omega_8,
        chain_omega_10_dot_by_chain_omega_9,
        chain_omega_10_dot_by_chain_omega_10,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 0] {
    []
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
    ]
}

/// Wanted outputs.
///
/// No operations.
#[must_use]
pub fn outputs<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> Outputs<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        theta_3: chain_theta_3,
        theta_4: chain_theta_4,
        theta_5: chain_theta_5,
        theta_6: chain_theta_6,
        theta_7: chain_theta_7,
        theta_8: chain_theta_8,
        theta_9: chain_theta_9,
        theta_10: chain_theta_10,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
        omega_3: chain_omega_3,
        omega_4: chain_omega_4,
        omega_5: chain_omega_5,
        omega_6: chain_omega_6,
        omega_7: chain_omega_7,
        omega_8: chain_omega_8,
        omega_9: chain_omega_9,
        omega_10: chain_omega_10,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 118 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let cos_chain_theta_1 = chain_theta_1.cos();
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * chain_theta_1.sin();
    let cos_chain_theta_2 = chain_theta_2.cos();
    let chain_u_2 = chain_u_1 + chain_omega_2 * cos_chain_theta_2;
    let chain_v_2 = chain_v_1 + chain_omega_2 * chain_theta_2.sin();
    let cos_chain_theta_3 = chain_theta_3.cos();
    let chain_u_3 = chain_u_2 + chain_omega_3 * cos_chain_theta_3;
    let chain_v_3 = chain_v_2 + chain_omega_3 * chain_theta_3.sin();
    let cos_chain_theta_4 = chain_theta_4.cos();
    let chain_u_4 = chain_u_3 + chain_omega_4 * cos_chain_theta_4;
    let chain_v_4 = chain_v_3 + chain_omega_4 * chain_theta_4.sin();
    let cos_chain_theta_5 = chain_theta_5.cos();
    let chain_u_5 = chain_u_4 + chain_omega_5 * cos_chain_theta_5;
    let chain_v_5 = chain_v_4 + chain_omega_5 * chain_theta_5.sin();
    let cos_chain_theta_6 = chain_theta_6.cos();
    let chain_u_6 = chain_u_5 + chain_omega_6 * cos_chain_theta_6;
    let chain_v_6 = chain_v_5 + chain_omega_6 * chain_theta_6.sin();
    let cos_chain_theta_7 = chain_theta_7.cos();
    let chain_u_7 = chain_u_6 + chain_omega_7 * cos_chain_theta_7;
    let chain_v_7 = chain_v_6 + chain_omega_7 * chain_theta_7.sin();
    let cos_chain_theta_8 = chain_theta_8.cos();
    let chain_u_8 = chain_u_7 + chain_omega_8 * cos_chain_theta_8;
    let chain_v_8 = chain_v_7 + chain_omega_8 * chain_theta_8.sin();
    let cos_chain_theta_9 = chain_theta_9.cos();
    let chain_u_9 = chain_u_8 + chain_omega_9 * cos_chain_theta_9;
    let chain_v_9 = chain_v_8 + chain_omega_9 * chain_theta_9.sin();
    let cos_chain_theta_10 = chain_theta_10.cos();
    let chain_u_10 = chain_u_9 + chain_omega_10 * cos_chain_theta_10;
    let chain_v_10 = chain_v_9 + chain_omega_10 * chain_theta_10.sin();
    let t0 = chain_u_1 * chain_u_1 + chain_v_1 * chain_v_1 + chain_u_2 * chain_u_2
        + chain_v_2 * chain_v_2 + chain_u_3 * chain_u_3 + chain_v_3 * chain_v_3
        + chain_u_4 * chain_u_4 + chain_v_4 * chain_v_4 + chain_u_5 * chain_u_5
        + chain_v_5 * chain_v_5 + chain_u_6 * chain_u_6 + chain_v_6 * chain_v_6;
    Energy {
        kinetic: R::literal(0.5)
            * (t0 + chain_u_7 * chain_u_7 + chain_v_7 * chain_v_7 + chain_u_8 * chain_u_8
                + chain_v_8 * chain_v_8 + chain_u_9 * chain_u_9 + chain_v_9 * chain_v_9
                + chain_u_10 * chain_u_10 + chain_v_10 * chain_v_10),
        potential: R::literal(9.81)
            * (-(R::literal(10.0) * cos_chain_theta_1)
                - R::literal(9.0) * cos_chain_theta_2
                - R::literal(8.0) * cos_chain_theta_3
                - R::literal(7.0) * cos_chain_theta_4
                - R::literal(6.0) * cos_chain_theta_5
                - R::literal(5.0) * cos_chain_theta_6
                - R::literal(4.0) * cos_chain_theta_7
                - R::literal(3.0) * cos_chain_theta_8
                - R::literal(2.0) * cos_chain_theta_9 - cos_chain_theta_10),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 1751 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let cos_chain_theta_1 = chain_theta_1.cos();
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let sin_chain_theta_1 = chain_theta_1.sin();
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let cos_chain_theta_2 = chain_theta_2.cos();
    let chain_u_2 = chain_u_1 + chain_omega_2 * cos_chain_theta_2;
    let sin_chain_theta_2 = chain_theta_2.sin();
    let chain_v_2 = chain_v_1 + chain_omega_2 * sin_chain_theta_2;
    let cos_chain_theta_3 = chain_theta_3.cos();
    let chain_u_3 = chain_u_2 + chain_omega_3 * cos_chain_theta_3;
    let sin_chain_theta_3 = chain_theta_3.sin();
    let chain_v_3 = chain_v_2 + chain_omega_3 * sin_chain_theta_3;
    let cos_chain_theta_4 = chain_theta_4.cos();
    let chain_u_4 = chain_u_3 + chain_omega_4 * cos_chain_theta_4;
    let sin_chain_theta_4 = chain_theta_4.sin();
    let chain_v_4 = chain_v_3 + chain_omega_4 * sin_chain_theta_4;
    let cos_chain_theta_5 = chain_theta_5.cos();
    let chain_u_5 = chain_u_4 + chain_omega_5 * cos_chain_theta_5;
    let sin_chain_theta_5 = chain_theta_5.sin();
    let chain_v_5 = chain_v_4 + chain_omega_5 * sin_chain_theta_5;
    let cos_chain_theta_6 = chain_theta_6.cos();
    let chain_u_6 = chain_u_5 + chain_omega_6 * cos_chain_theta_6;
    let sin_chain_theta_6 = chain_theta_6.sin();
    let chain_v_6 = chain_v_5 + chain_omega_6 * sin_chain_theta_6;
    let cos_chain_theta_7 = chain_theta_7.cos();
    let chain_u_7 = chain_u_6 + chain_omega_7 * cos_chain_theta_7;
    let sin_chain_theta_7 = chain_theta_7.sin();
    let chain_v_7 = chain_v_6 + chain_omega_7 * sin_chain_theta_7;
    let cos_chain_theta_8 = chain_theta_8.cos();
    let chain_u_8 = chain_u_7 + chain_omega_8 * cos_chain_theta_8;
    let sin_chain_theta_8 = chain_theta_8.sin();
    let chain_v_8 = chain_v_7 + chain_omega_8 * sin_chain_theta_8;
    let cos_chain_theta_9 = chain_theta_9.cos();
    let chain_u_9 = chain_u_8 + chain_omega_9 * cos_chain_theta_9;
    let sin_chain_theta_9 = chain_theta_9.sin();
    let chain_v_9 = chain_v_8 + chain_omega_9 * sin_chain_theta_9;
    let cos_chain_theta_10 = chain_theta_10.cos();
    let chain_u_10 = chain_u_9 + chain_omega_10 * cos_chain_theta_10;
    let sin_chain_theta_10 = chain_theta_10.sin();
    let chain_v_10 = chain_v_9 + chain_omega_10 * sin_chain_theta_10;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = R::literal(9.0) * chain_theta_1_minus_chain_theta_2.cos();
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t1 = R::literal(8.0) * chain_theta_1_minus_chain_theta_3.cos();
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t2 = R::literal(7.0) * chain_theta_1_minus_chain_theta_4.cos();
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t3 = R::literal(6.0) * chain_theta_1_minus_chain_theta_5.cos();
    let chain_theta_1_minus_chain_theta_6 = chain_theta_1 - chain_theta_6;
    let t4 = R::literal(5.0) * chain_theta_1_minus_chain_theta_6.cos();
    let chain_theta_1_minus_chain_theta_7 = chain_theta_1 - chain_theta_7;
    let t5 = R::literal(4.0) * chain_theta_1_minus_chain_theta_7.cos();
    let chain_theta_1_minus_chain_theta_8 = chain_theta_1 - chain_theta_8;
    let t6 = R::literal(3.0) * chain_theta_1_minus_chain_theta_8.cos();
    let chain_theta_1_minus_chain_theta_9 = chain_theta_1 - chain_theta_9;
    let t7 = R::literal(2.0) * chain_theta_1_minus_chain_theta_9.cos();
    let chain_theta_1_minus_chain_theta_10 = chain_theta_1 - chain_theta_10;
    let t8 = chain_theta_1_minus_chain_theta_10.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_2_minus_chain_theta_6 = chain_theta_2 - chain_theta_6;
    let chain_theta_2_minus_chain_theta_7 = chain_theta_2 - chain_theta_7;
    let chain_theta_2_minus_chain_theta_8 = chain_theta_2 - chain_theta_8;
    let chain_theta_2_minus_chain_theta_9 = chain_theta_2 - chain_theta_9;
    let chain_theta_2_minus_chain_theta_10 = chain_theta_2 - chain_theta_10;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_6 = chain_theta_3 - chain_theta_6;
    let chain_theta_3_minus_chain_theta_7 = chain_theta_3 - chain_theta_7;
    let chain_theta_3_minus_chain_theta_8 = chain_theta_3 - chain_theta_8;
    let chain_theta_3_minus_chain_theta_9 = chain_theta_3 - chain_theta_9;
    let chain_theta_3_minus_chain_theta_10 = chain_theta_3 - chain_theta_10;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_6 = chain_theta_4 - chain_theta_6;
    let chain_theta_4_minus_chain_theta_7 = chain_theta_4 - chain_theta_7;
    let chain_theta_4_minus_chain_theta_8 = chain_theta_4 - chain_theta_8;
    let chain_theta_4_minus_chain_theta_9 = chain_theta_4 - chain_theta_9;
    let chain_theta_4_minus_chain_theta_10 = chain_theta_4 - chain_theta_10;
    let chain_theta_5_minus_chain_theta_6 = chain_theta_5 - chain_theta_6;
    let chain_theta_5_minus_chain_theta_7 = chain_theta_5 - chain_theta_7;
    let chain_theta_5_minus_chain_theta_8 = chain_theta_5 - chain_theta_8;
    let chain_theta_5_minus_chain_theta_9 = chain_theta_5 - chain_theta_9;
    let chain_theta_5_minus_chain_theta_10 = chain_theta_5 - chain_theta_10;
    let chain_theta_6_minus_chain_theta_7 = chain_theta_6 - chain_theta_7;
    let chain_theta_6_minus_chain_theta_8 = chain_theta_6 - chain_theta_8;
    let chain_theta_6_minus_chain_theta_9 = chain_theta_6 - chain_theta_9;
    let chain_theta_6_minus_chain_theta_10 = chain_theta_6 - chain_theta_10;
    let chain_theta_7_minus_chain_theta_8 = chain_theta_7 - chain_theta_8;
    let chain_theta_7_minus_chain_theta_9 = chain_theta_7 - chain_theta_9;
    let chain_theta_7_minus_chain_theta_10 = chain_theta_7 - chain_theta_10;
    let chain_theta_8_minus_chain_theta_9 = chain_theta_8 - chain_theta_9;
    let chain_theta_8_minus_chain_theta_10 = chain_theta_8 - chain_theta_10;
    let chain_theta_9_minus_chain_theta_10 = chain_theta_9 - chain_theta_10;
    let t9 = t0 * R::literal(0.1);
    let t10 = t1 * R::literal(0.1);
    let t11 = t2 * R::literal(0.1);
    let t12 = t3 * R::literal(0.1);
    let t13 = t4 * R::literal(0.1);
    let t14 = t5 * R::literal(0.1);
    let t15 = t6 * R::literal(0.1);
    let t16 = t7 * R::literal(0.1);
    let t17 = t8 * R::literal(0.1);
    let t18 = R::literal(1.0) / (R::literal(9.0) - t9 * t0);
    let t19 = R::literal(8.0) * chain_theta_2_minus_chain_theta_3.cos() - t10 * t0;
    let t20 = t19 * t18;
    let t21 = R::literal(7.0) * chain_theta_2_minus_chain_theta_4.cos() - t11 * t0;
    let t22 = t21 * t18;
    let t23 = R::literal(6.0) * chain_theta_2_minus_chain_theta_5.cos() - t12 * t0;
    let t24 = t23 * t18;
    let t25 = R::literal(5.0) * chain_theta_2_minus_chain_theta_6.cos() - t13 * t0;
    let t26 = t25 * t18;
    let t27 = R::literal(4.0) * chain_theta_2_minus_chain_theta_7.cos() - t14 * t0;
    let t28 = t27 * t18;
    let t29 = R::literal(3.0) * chain_theta_2_minus_chain_theta_8.cos() - t15 * t0;
    let t30 = t29 * t18;
    let t31 = R::literal(2.0) * chain_theta_2_minus_chain_theta_9.cos() - t16 * t0;
    let t32 = t31 * t18;
    let t33 = chain_theta_2_minus_chain_theta_10.cos() - t17 * t0;
    let t34 = t33 * t18;
    let t35 = R::literal(1.0) / (R::literal(8.0) - t10 * t1 - t20 * t19);
    let t36 = R::literal(7.0) * chain_theta_3_minus_chain_theta_4.cos() - t11 * t1
        - t22 * t19;
    let t37 = t36 * t35;
    let t38 = R::literal(6.0) * chain_theta_3_minus_chain_theta_5.cos() - t12 * t1
        - t24 * t19;
    let t39 = t38 * t35;
    let t40 = R::literal(5.0) * chain_theta_3_minus_chain_theta_6.cos() - t13 * t1
        - t26 * t19;
    let t41 = t40 * t35;
    let t42 = R::literal(4.0) * chain_theta_3_minus_chain_theta_7.cos() - t14 * t1
        - t28 * t19;
    let t43 = t42 * t35;
    let t44 = R::literal(3.0) * chain_theta_3_minus_chain_theta_8.cos() - t15 * t1
        - t30 * t19;
    let t45 = t44 * t35;
    let t46 = R::literal(2.0) * chain_theta_3_minus_chain_theta_9.cos() - t16 * t1
        - t32 * t19;
    let t47 = t46 * t35;
    let t48 = chain_theta_3_minus_chain_theta_10.cos() - t17 * t1 - t34 * t19;
    let t49 = t48 * t35;
    let t50 = R::literal(1.0) / (R::literal(7.0) - t11 * t2 - t22 * t21 - t37 * t36);
    let t51 = R::literal(6.0) * chain_theta_4_minus_chain_theta_5.cos() - t12 * t2
        - t24 * t21 - t39 * t36;
    let t52 = t51 * t50;
    let t53 = R::literal(5.0) * chain_theta_4_minus_chain_theta_6.cos() - t13 * t2
        - t26 * t21 - t41 * t36;
    let t54 = t53 * t50;
    let t55 = R::literal(4.0) * chain_theta_4_minus_chain_theta_7.cos() - t14 * t2
        - t28 * t21 - t43 * t36;
    let t56 = t55 * t50;
    let t57 = R::literal(3.0) * chain_theta_4_minus_chain_theta_8.cos() - t15 * t2
        - t30 * t21 - t45 * t36;
    let t58 = t57 * t50;
    let t59 = R::literal(2.0) * chain_theta_4_minus_chain_theta_9.cos() - t16 * t2
        - t32 * t21 - t47 * t36;
    let t60 = t59 * t50;
    let t61 = chain_theta_4_minus_chain_theta_10.cos() - t17 * t2 - t34 * t21
        - t49 * t36;
    let t62 = t61 * t50;
    let t63 = R::literal(1.0)
        / (R::literal(6.0) - t12 * t3 - t24 * t23 - t39 * t38 - t52 * t51);
    let t64 = R::literal(5.0) * chain_theta_5_minus_chain_theta_6.cos() - t13 * t3
        - t26 * t23 - t41 * t38 - t54 * t51;
    let t65 = t64 * t63;
    let t66 = R::literal(4.0) * chain_theta_5_minus_chain_theta_7.cos() - t14 * t3
        - t28 * t23 - t43 * t38 - t56 * t51;
    let t67 = t66 * t63;
    let t68 = R::literal(3.0) * chain_theta_5_minus_chain_theta_8.cos() - t15 * t3
        - t30 * t23 - t45 * t38 - t58 * t51;
    let t69 = t68 * t63;
    let t70 = R::literal(2.0) * chain_theta_5_minus_chain_theta_9.cos() - t16 * t3
        - t32 * t23 - t47 * t38 - t60 * t51;
    let t71 = t70 * t63;
    let t72 = chain_theta_5_minus_chain_theta_10.cos() - t17 * t3 - t34 * t23 - t49 * t38
        - t62 * t51;
    let t73 = t72 * t63;
    let t74 = R::literal(1.0)
        / (R::literal(5.0) - t13 * t4 - t26 * t25 - t41 * t40 - t54 * t53 - t65 * t64);
    let t75 = R::literal(4.0) * chain_theta_6_minus_chain_theta_7.cos() - t14 * t4
        - t28 * t25 - t43 * t40 - t56 * t53 - t67 * t64;
    let t76 = t75 * t74;
    let t77 = R::literal(3.0) * chain_theta_6_minus_chain_theta_8.cos() - t15 * t4
        - t30 * t25 - t45 * t40 - t58 * t53 - t69 * t64;
    let t78 = t77 * t74;
    let t79 = R::literal(2.0) * chain_theta_6_minus_chain_theta_9.cos() - t16 * t4
        - t32 * t25 - t47 * t40 - t60 * t53 - t71 * t64;
    let t80 = t79 * t74;
    let t81 = chain_theta_6_minus_chain_theta_10.cos() - t17 * t4 - t34 * t25 - t49 * t40
        - t62 * t53 - t73 * t64;
    let t82 = t81 * t74;
    let t83 = R::literal(1.0)
        / (R::literal(4.0) - t14 * t5 - t28 * t27 - t43 * t42 - t56 * t55 - t67 * t66
            - t76 * t75);
    let t84 = R::literal(3.0) * chain_theta_7_minus_chain_theta_8.cos() - t15 * t5
        - t30 * t27 - t45 * t42 - t58 * t55 - t69 * t66 - t78 * t75;
    let t85 = t84 * t83;
    let t86 = R::literal(2.0) * chain_theta_7_minus_chain_theta_9.cos() - t16 * t5
        - t32 * t27 - t47 * t42 - t60 * t55 - t71 * t66 - t80 * t75;
    let t87 = t86 * t83;
    let t88 = chain_theta_7_minus_chain_theta_10.cos() - t17 * t5 - t34 * t27 - t49 * t42
        - t62 * t55 - t73 * t66 - t82 * t75;
    let t89 = t88 * t83;
    let t90 = R::literal(1.0)
        / (R::literal(3.0) - t15 * t6 - t30 * t29 - t45 * t44 - t58 * t57 - t69 * t68
            - t78 * t77 - t85 * t84);
    let t91 = R::literal(2.0) * chain_theta_8_minus_chain_theta_9.cos() - t16 * t6
        - t32 * t29 - t47 * t44 - t60 * t57 - t71 * t68 - t80 * t77 - t87 * t84;
    let t92 = t91 * t90;
    let t93 = chain_theta_8_minus_chain_theta_10.cos() - t17 * t6 - t34 * t29 - t49 * t44
        - t62 * t57 - t73 * t68 - t82 * t77 - t89 * t84;
    let t94 = t93 * t90;
    let t95 = R::literal(1.0)
        / (R::literal(2.0) - t16 * t7 - t32 * t31 - t47 * t46 - t60 * t59 - t71 * t70
            - t80 * t79 - t87 * t86 - t92 * t91);
    let t96 = chain_theta_9_minus_chain_theta_10.cos() - t17 * t7 - t34 * t31 - t49 * t46
        - t62 * t59 - t73 * t70 - t82 * t79 - t89 * t86 - t94 * t91;
    let t97 = t96 * t95;
    let t98 = R::literal(1.0)
        / (R::literal(1.0) - t17 * t8 - t34 * t33 - t49 * t48 - t62 * t61 - t73 * t72
            - t82 * t81 - t89 * t88 - t94 * t93 - t97 * t96);
    let t99 = R::literal(98.1) * sin_chain_theta_1;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t100 = R::literal(8.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t101 = R::literal(7.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t102 = R::literal(6.0) * chain_omega_5_squared;
    let chain_omega_6_squared = chain_omega_6 * chain_omega_6;
    let t103 = R::literal(5.0) * chain_omega_6_squared;
    let chain_omega_7_squared = chain_omega_7 * chain_omega_7;
    let t104 = R::literal(4.0) * chain_omega_7_squared;
    let chain_omega_8_squared = chain_omega_8 * chain_omega_8;
    let t105 = R::literal(3.0) * chain_omega_8_squared;
    let chain_omega_9_squared = chain_omega_9 * chain_omega_9;
    let t106 = R::literal(2.0) * chain_omega_9_squared;
    let chain_omega_10_squared = chain_omega_10 * chain_omega_10;
    let t107 = -t99
        - R::literal(9.0) * chain_omega_2_squared
            * chain_theta_1_minus_chain_theta_2.sin()
        - t100 * chain_theta_1_minus_chain_theta_3.sin()
        - t101 * chain_theta_1_minus_chain_theta_4.sin()
        - t102 * chain_theta_1_minus_chain_theta_5.sin()
        - t103 * chain_theta_1_minus_chain_theta_6.sin()
        - t104 * chain_theta_1_minus_chain_theta_7.sin()
        - t105 * chain_theta_1_minus_chain_theta_8.sin();
    let t108 = t107 - t106 * chain_theta_1_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_1_minus_chain_theta_10.sin();
    let t109 = R::literal(88.29) * sin_chain_theta_2;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t110 = -t109
        - R::literal(9.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t100 * chain_theta_2_minus_chain_theta_3.sin()
        - t101 * chain_theta_2_minus_chain_theta_4.sin()
        - t102 * chain_theta_2_minus_chain_theta_5.sin()
        - t103 * chain_theta_2_minus_chain_theta_6.sin()
        - t104 * chain_theta_2_minus_chain_theta_7.sin()
        - t105 * chain_theta_2_minus_chain_theta_8.sin();
    let t111 = R::literal(78.48) * sin_chain_theta_3;
    let t112 = -t111
        - R::literal(8.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(8.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t101 * chain_theta_3_minus_chain_theta_4.sin()
        - t102 * chain_theta_3_minus_chain_theta_5.sin()
        - t103 * chain_theta_3_minus_chain_theta_6.sin()
        - t104 * chain_theta_3_minus_chain_theta_7.sin();
    let t113 = R::literal(68.67) * sin_chain_theta_4;
    let t114 = -t113
        - R::literal(7.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(7.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(7.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - t102 * chain_theta_4_minus_chain_theta_5.sin()
        - t103 * chain_theta_4_minus_chain_theta_6.sin();
    let t115 = R::literal(58.86) * sin_chain_theta_5;
    let t116 = -t115
        - R::literal(6.0) * chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - R::literal(6.0) * chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - R::literal(6.0) * chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - R::literal(6.0) * chain_omega_4_squared * (chain_theta_5 - chain_theta_4).sin()
        - t103 * chain_theta_5_minus_chain_theta_6.sin();
    let t117 = R::literal(49.05) * sin_chain_theta_6;
    let t118 = -t117
        - R::literal(5.0) * chain_omega_1_squared * (chain_theta_6 - chain_theta_1).sin()
        - R::literal(5.0) * chain_omega_2_squared * (chain_theta_6 - chain_theta_2).sin()
        - R::literal(5.0) * chain_omega_3_squared * (chain_theta_6 - chain_theta_3).sin()
        - R::literal(5.0) * chain_omega_4_squared
            * (chain_theta_6 - chain_theta_4).sin();
    let t119 = R::literal(39.24) * sin_chain_theta_7;
    let t120 = -t119
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_7 - chain_theta_1).sin()
        - R::literal(4.0) * chain_omega_2_squared * (chain_theta_7 - chain_theta_2).sin()
        - R::literal(4.0) * chain_omega_3_squared * (chain_theta_7 - chain_theta_3).sin()
        - R::literal(4.0) * chain_omega_4_squared
            * (chain_theta_7 - chain_theta_4).sin();
    let t121 = R::literal(29.43) * sin_chain_theta_8;
    let t122 = -t121
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_8 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_8 - chain_theta_2).sin()
        - R::literal(3.0) * chain_omega_3_squared * (chain_theta_8 - chain_theta_3).sin()
        - R::literal(3.0) * chain_omega_4_squared
            * (chain_theta_8 - chain_theta_4).sin();
    let t123 = R::literal(19.62) * sin_chain_theta_9;
    let t124 = -t123
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_9 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_9 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_9 - chain_theta_3).sin()
        - R::literal(2.0) * chain_omega_4_squared
            * (chain_theta_9 - chain_theta_4).sin();
    let t125 = t124
        - R::literal(2.0) * chain_omega_5_squared * (chain_theta_9 - chain_theta_5).sin()
        - R::literal(2.0) * chain_omega_6_squared * (chain_theta_9 - chain_theta_6).sin()
        - R::literal(2.0) * chain_omega_7_squared * (chain_theta_9 - chain_theta_7).sin()
        - R::literal(2.0) * chain_omega_8_squared * (chain_theta_9 - chain_theta_8).sin()
        - chain_omega_10_squared * chain_theta_9_minus_chain_theta_10.sin();
    let t126 = R::literal(9.81) * sin_chain_theta_10;
    let t127 = -t126 - chain_omega_1_squared * (chain_theta_10 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_10 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_10 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_10 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_10 - chain_theta_5).sin();
    let t128 = t110 - t106 * chain_theta_2_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_2_minus_chain_theta_10.sin() - t9 * t108;
    let t129 = t112 - t105 * chain_theta_3_minus_chain_theta_8.sin()
        - t106 * chain_theta_3_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_3_minus_chain_theta_10.sin() - t10 * t108
        - t20 * t128;
    let t130 = t114 - t104 * chain_theta_4_minus_chain_theta_7.sin()
        - t105 * chain_theta_4_minus_chain_theta_8.sin()
        - t106 * chain_theta_4_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_4_minus_chain_theta_10.sin() - t11 * t108
        - t22 * t128 - t37 * t129;
    let t131 = t116 - t104 * chain_theta_5_minus_chain_theta_7.sin()
        - t105 * chain_theta_5_minus_chain_theta_8.sin()
        - t106 * chain_theta_5_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_5_minus_chain_theta_10.sin() - t12 * t108
        - t24 * t128 - t39 * t129 - t52 * t130;
    let t132 = t118
        - R::literal(5.0) * chain_omega_5_squared * (chain_theta_6 - chain_theta_5).sin()
        - t104 * chain_theta_6_minus_chain_theta_7.sin()
        - t105 * chain_theta_6_minus_chain_theta_8.sin()
        - t106 * chain_theta_6_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_6_minus_chain_theta_10.sin() - t13 * t108
        - t26 * t128 - t41 * t129;
    let t133 = t132 - t54 * t130 - t65 * t131;
    let t134 = t120
        - R::literal(4.0) * chain_omega_5_squared * (chain_theta_7 - chain_theta_5).sin()
        - R::literal(4.0) * chain_omega_6_squared * (chain_theta_7 - chain_theta_6).sin()
        - t105 * chain_theta_7_minus_chain_theta_8.sin()
        - t106 * chain_theta_7_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_7_minus_chain_theta_10.sin() - t14 * t108
        - t28 * t128;
    let t135 = t134 - t43 * t129 - t56 * t130 - t67 * t131 - t76 * t133;
    let t136 = t122
        - R::literal(3.0) * chain_omega_5_squared * (chain_theta_8 - chain_theta_5).sin()
        - R::literal(3.0) * chain_omega_6_squared * (chain_theta_8 - chain_theta_6).sin()
        - R::literal(3.0) * chain_omega_7_squared * (chain_theta_8 - chain_theta_7).sin()
        - t106 * chain_theta_8_minus_chain_theta_9.sin()
        - chain_omega_10_squared * chain_theta_8_minus_chain_theta_10.sin() - t15 * t108;
    let t137 = t136 - t30 * t128 - t45 * t129 - t58 * t130 - t69 * t131 - t78 * t133
        - t85 * t135;
    let t138 = t125 - t16 * t108 - t32 * t128 - t47 * t129 - t60 * t130 - t71 * t131
        - t80 * t133 - t87 * t135 - t92 * t137;
    let t139 = t127 - chain_omega_6_squared * (chain_theta_10 - chain_theta_6).sin()
        - chain_omega_7_squared * (chain_theta_10 - chain_theta_7).sin()
        - chain_omega_8_squared * (chain_theta_10 - chain_theta_8).sin()
        - chain_omega_9_squared * (chain_theta_10 - chain_theta_9).sin() - t17 * t108
        - t34 * t128 - t49 * t129 - t62 * t130;
    let chain_omega_10_dot = (t139 - t73 * t131 - t82 * t133 - t89 * t135 - t94 * t137
        - t97 * t138) * t98;
    let chain_omega_9_dot = t138 * t95 - t97 * chain_omega_10_dot;
    let chain_omega_8_dot = t137 * t90 - t92 * chain_omega_9_dot
        - t94 * chain_omega_10_dot;
    let chain_omega_7_dot = t135 * t83 - t85 * chain_omega_8_dot
        - t87 * chain_omega_9_dot - t89 * chain_omega_10_dot;
    let chain_omega_6_dot = t133 * t74 - t76 * chain_omega_7_dot
        - t78 * chain_omega_8_dot - t80 * chain_omega_9_dot - t82 * chain_omega_10_dot;
    let chain_omega_5_dot = t131 * t63 - t65 * chain_omega_6_dot
        - t67 * chain_omega_7_dot - t69 * chain_omega_8_dot - t71 * chain_omega_9_dot
        - t73 * chain_omega_10_dot;
    let chain_omega_4_dot = t130 * t50 - t52 * chain_omega_5_dot
        - t54 * chain_omega_6_dot - t56 * chain_omega_7_dot - t58 * chain_omega_8_dot
        - t60 * chain_omega_9_dot - t62 * chain_omega_10_dot;
    let chain_omega_3_dot = t129 * t35 - t37 * chain_omega_4_dot
        - t39 * chain_omega_5_dot - t41 * chain_omega_6_dot - t43 * chain_omega_7_dot
        - t45 * chain_omega_8_dot - t47 * chain_omega_9_dot - t49 * chain_omega_10_dot;
    let chain_omega_2_dot = t128 * t18 - t20 * chain_omega_3_dot
        - t22 * chain_omega_4_dot - t24 * chain_omega_5_dot - t26 * chain_omega_6_dot
        - t28 * chain_omega_7_dot - t30 * chain_omega_8_dot - t32 * chain_omega_9_dot
        - t34 * chain_omega_10_dot;
    let chain_omega_1_dot = t108 * R::literal(0.1) - t9 * chain_omega_2_dot
        - t10 * chain_omega_3_dot - t11 * chain_omega_4_dot - t12 * chain_omega_5_dot
        - t13 * chain_omega_6_dot - t14 * chain_omega_7_dot - t15 * chain_omega_8_dot
        - t16 * chain_omega_9_dot - t17 * chain_omega_10_dot;
    let t140 = R::literal(2.0) * chain_omega_2;
    let t141 = R::literal(2.0) * chain_omega_3;
    let t142 = R::literal(2.0) * chain_omega_4;
    let t143 = R::literal(2.0) * chain_omega_5;
    let t144 = R::literal(2.0) * chain_omega_6;
    let t145 = R::literal(2.0) * chain_omega_7;
    let t146 = R::literal(2.0) * chain_omega_8;
    let t147 = R::literal(2.0) * chain_omega_9;
    let t148 = R::literal(2.0) * chain_omega_10;
    let t149 = R::literal(2.0) * chain_v_1;
    let t150 = R::literal(2.0) * chain_u_1;
    let t151 = t150 * chain_v_2 + t150 * chain_v_3 + t150 * chain_v_4 + t150 * chain_v_5
        + t150 * chain_v_6 + t150 * chain_v_7 + t150 * chain_v_8 + t150 * chain_v_9
        + t150 * chain_v_10 - t149 * chain_u_2 - t149 * chain_u_3 - t149 * chain_u_4;
    let t152 = (R::literal(0.5)
        * (t151 - t149 * chain_u_5 - t149 * chain_u_6 - t149 * chain_u_7
            - t149 * chain_u_8 - t149 * chain_u_9 - t149 * chain_u_10) + t99)
        * chain_omega_1;
    let t153 = t140 * chain_v_2 * cos_chain_theta_2
        + t140 * chain_v_3 * cos_chain_theta_2 + t140 * chain_v_4 * cos_chain_theta_2
        + t140 * chain_v_5 * cos_chain_theta_2 + t140 * chain_v_6 * cos_chain_theta_2
        + t140 * chain_v_7 * cos_chain_theta_2 + t140 * chain_v_8 * cos_chain_theta_2
        + t140 * chain_v_9 * cos_chain_theta_2;
    let t154 = t153 + t140 * chain_v_10 * cos_chain_theta_2
        - t140 * chain_u_2 * sin_chain_theta_2 - t140 * chain_u_3 * sin_chain_theta_2
        - t140 * chain_u_4 * sin_chain_theta_2 - t140 * chain_u_5 * sin_chain_theta_2
        - t140 * chain_u_6 * sin_chain_theta_2 - t140 * chain_u_7 * sin_chain_theta_2
        - t140 * chain_u_8 * sin_chain_theta_2;
    let t155 = t141 * chain_v_3 * cos_chain_theta_3
        + t141 * chain_v_4 * cos_chain_theta_3 + t141 * chain_v_5 * cos_chain_theta_3
        + t141 * chain_v_6 * cos_chain_theta_3 + t141 * chain_v_7 * cos_chain_theta_3
        + t141 * chain_v_8 * cos_chain_theta_3 + t141 * chain_v_9 * cos_chain_theta_3
        + t141 * chain_v_10 * cos_chain_theta_3;
    let t156 = t155 - t141 * chain_u_3 * sin_chain_theta_3
        - t141 * chain_u_4 * sin_chain_theta_3 - t141 * chain_u_5 * sin_chain_theta_3
        - t141 * chain_u_6 * sin_chain_theta_3 - t141 * chain_u_7 * sin_chain_theta_3
        - t141 * chain_u_8 * sin_chain_theta_3 - t141 * chain_u_9 * sin_chain_theta_3
        - t141 * chain_u_10 * sin_chain_theta_3;
    let t157 = t142 * chain_v_4 * cos_chain_theta_4
        + t142 * chain_v_5 * cos_chain_theta_4 + t142 * chain_v_6 * cos_chain_theta_4
        + t142 * chain_v_7 * cos_chain_theta_4 + t142 * chain_v_8 * cos_chain_theta_4
        + t142 * chain_v_9 * cos_chain_theta_4 + t142 * chain_v_10 * cos_chain_theta_4
        - t142 * chain_u_4 * sin_chain_theta_4;
    let t158 = (R::literal(0.5)
        * (t157 - t142 * chain_u_5 * sin_chain_theta_4
            - t142 * chain_u_6 * sin_chain_theta_4 - t142 * chain_u_7 * sin_chain_theta_4
            - t142 * chain_u_8 * sin_chain_theta_4 - t142 * chain_u_9 * sin_chain_theta_4
            - t142 * chain_u_10 * sin_chain_theta_4) + t113) * chain_omega_4;
    let t159 = t143 * chain_v_5 * cos_chain_theta_5
        + t143 * chain_v_6 * cos_chain_theta_5 + t143 * chain_v_7 * cos_chain_theta_5
        + t143 * chain_v_8 * cos_chain_theta_5 + t143 * chain_v_9 * cos_chain_theta_5
        + t143 * chain_v_10 * cos_chain_theta_5 - t143 * chain_u_5 * sin_chain_theta_5
        - t143 * chain_u_6 * sin_chain_theta_5;
    let t160 = (R::literal(0.5)
        * (t159 - t143 * chain_u_7 * sin_chain_theta_5
            - t143 * chain_u_8 * sin_chain_theta_5 - t143 * chain_u_9 * sin_chain_theta_5
            - t143 * chain_u_10 * sin_chain_theta_5) + t115) * chain_omega_5;
    let t161 = t152
        + (R::literal(0.5)
            * (t154 - t140 * chain_u_9 * sin_chain_theta_2
                - t140 * chain_u_10 * sin_chain_theta_2) + t109) * chain_omega_2
        + (R::literal(0.5) * t156 + t111) * chain_omega_3 + t158 + t160;
    let t162 = t144 * chain_v_6 * cos_chain_theta_6
        + t144 * chain_v_7 * cos_chain_theta_6 + t144 * chain_v_8 * cos_chain_theta_6
        + t144 * chain_v_9 * cos_chain_theta_6 + t144 * chain_v_10 * cos_chain_theta_6
        - t144 * chain_u_6 * sin_chain_theta_6 - t144 * chain_u_7 * sin_chain_theta_6
        - t144 * chain_u_8 * sin_chain_theta_6;
    let t163 = R::literal(0.5)
        * (t145 * chain_v_7 * cos_chain_theta_7 + t145 * chain_v_8 * cos_chain_theta_7
            + t145 * chain_v_9 * cos_chain_theta_7
            + t145 * chain_v_10 * cos_chain_theta_7
            - t145 * chain_u_7 * sin_chain_theta_7 - t145 * chain_u_8 * sin_chain_theta_7
            - t145 * chain_u_9 * sin_chain_theta_7
            - t145 * chain_u_10 * sin_chain_theta_7);
    let t164 = (R::literal(0.5)
        * (t146 * chain_v_8 * cos_chain_theta_8 + t146 * chain_v_9 * cos_chain_theta_8
            + t146 * chain_v_10 * cos_chain_theta_8
            - t146 * chain_u_8 * sin_chain_theta_8 - t146 * chain_u_9 * sin_chain_theta_8
            - t146 * chain_u_10 * sin_chain_theta_8) + t121) * chain_omega_8;
    let t165 = (R::literal(0.5)
        * (t147 * chain_v_9 * cos_chain_theta_9 + t147 * chain_v_10 * cos_chain_theta_9
            - t147 * chain_u_9 * sin_chain_theta_9
            - t147 * chain_u_10 * sin_chain_theta_9) + t123) * chain_omega_9;
    let t166 = t161
        + (R::literal(0.5)
            * (t162 - t144 * chain_u_9 * sin_chain_theta_6
                - t144 * chain_u_10 * sin_chain_theta_6) + t117) * chain_omega_6
        + (t163 + t119) * chain_omega_7 + t164 + t165
        + (R::literal(0.5)
            * (t148 * chain_v_10 * cos_chain_theta_10
                - t148 * chain_u_10 * sin_chain_theta_10) + t126) * chain_omega_10;
    let t167 = R::literal(2.0) * chain_u_2;
    let t168 = R::literal(2.0) * chain_v_2;
    let t169 = R::literal(2.0) * chain_u_3;
    let t170 = R::literal(2.0) * chain_v_3;
    let t171 = R::literal(2.0) * chain_u_4;
    let t172 = R::literal(2.0) * chain_v_4;
    let t173 = R::literal(2.0) * chain_u_5;
    let t174 = R::literal(2.0) * chain_v_5;
    let t175 = R::literal(2.0) * chain_u_6;
    let t176 = R::literal(2.0) * chain_v_6;
    let t177 = R::literal(2.0) * chain_u_7;
    let t178 = R::literal(2.0) * chain_v_7;
    let t179 = R::literal(2.0) * chain_u_8;
    let t180 = R::literal(2.0) * chain_v_8;
    let t181 = R::literal(2.0) * chain_u_9;
    let t182 = R::literal(2.0) * chain_v_9;
    let t183 = R::literal(2.0) * chain_u_10;
    let t184 = R::literal(2.0) * chain_v_10;
    let t185 = t150 * cos_chain_theta_1 + t149 * sin_chain_theta_1
        + t167 * cos_chain_theta_1 + t168 * sin_chain_theta_1 + t169 * cos_chain_theta_1
        + t170 * sin_chain_theta_1 + t171 * cos_chain_theta_1 + t172 * sin_chain_theta_1
        + t173 * cos_chain_theta_1 + t174 * sin_chain_theta_1 + t175 * cos_chain_theta_1
        + t176 * sin_chain_theta_1;
    let t186 = t166
        + R::literal(0.5)
            * (t185 + t177 * cos_chain_theta_1 + t178 * sin_chain_theta_1
                + t179 * cos_chain_theta_1 + t180 * sin_chain_theta_1
                + t181 * cos_chain_theta_1 + t182 * sin_chain_theta_1
                + t183 * cos_chain_theta_1 + t184 * sin_chain_theta_1)
            * chain_omega_1_dot;
    let t187 = t167 * cos_chain_theta_2 + t168 * sin_chain_theta_2
        + t169 * cos_chain_theta_2 + t170 * sin_chain_theta_2 + t171 * cos_chain_theta_2
        + t172 * sin_chain_theta_2 + t173 * cos_chain_theta_2 + t174 * sin_chain_theta_2
        + t175 * cos_chain_theta_2 + t176 * sin_chain_theta_2 + t177 * cos_chain_theta_2
        + t178 * sin_chain_theta_2;
    let t188 = t186
        + R::literal(0.5)
            * (t187 + t179 * cos_chain_theta_2 + t180 * sin_chain_theta_2
                + t181 * cos_chain_theta_2 + t182 * sin_chain_theta_2
                + t183 * cos_chain_theta_2 + t184 * sin_chain_theta_2)
            * chain_omega_2_dot;
    let t189 = t169 * cos_chain_theta_3 + t170 * sin_chain_theta_3
        + t171 * cos_chain_theta_3 + t172 * sin_chain_theta_3 + t173 * cos_chain_theta_3
        + t174 * sin_chain_theta_3 + t175 * cos_chain_theta_3 + t176 * sin_chain_theta_3
        + t177 * cos_chain_theta_3 + t178 * sin_chain_theta_3 + t179 * cos_chain_theta_3
        + t180 * sin_chain_theta_3;
    let t190 = t171 * cos_chain_theta_4 + t172 * sin_chain_theta_4
        + t173 * cos_chain_theta_4 + t174 * sin_chain_theta_4 + t175 * cos_chain_theta_4
        + t176 * sin_chain_theta_4 + t177 * cos_chain_theta_4 + t178 * sin_chain_theta_4
        + t179 * cos_chain_theta_4 + t180 * sin_chain_theta_4 + t181 * cos_chain_theta_4
        + t182 * sin_chain_theta_4;
    let t191 = R::literal(0.5)
        * (t173 * cos_chain_theta_5 + t174 * sin_chain_theta_5 + t175 * cos_chain_theta_5
            + t176 * sin_chain_theta_5 + t177 * cos_chain_theta_5
            + t178 * sin_chain_theta_5 + t179 * cos_chain_theta_5
            + t180 * sin_chain_theta_5 + t181 * cos_chain_theta_5
            + t182 * sin_chain_theta_5 + t183 * cos_chain_theta_5
            + t184 * sin_chain_theta_5);
    let t192 = R::literal(0.5)
        * (t175 * cos_chain_theta_6 + t176 * sin_chain_theta_6 + t177 * cos_chain_theta_6
            + t178 * sin_chain_theta_6 + t179 * cos_chain_theta_6
            + t180 * sin_chain_theta_6 + t181 * cos_chain_theta_6
            + t182 * sin_chain_theta_6 + t183 * cos_chain_theta_6
            + t184 * sin_chain_theta_6) * chain_omega_6_dot;
    let t193 = t188
        + R::literal(0.5)
            * (t189 + t181 * cos_chain_theta_3 + t182 * sin_chain_theta_3
                + t183 * cos_chain_theta_3 + t184 * sin_chain_theta_3)
            * chain_omega_3_dot
        + R::literal(0.5) * (t190 + t183 * cos_chain_theta_4 + t184 * sin_chain_theta_4)
            * chain_omega_4_dot + t191 * chain_omega_5_dot + t192;
    let t194 = t193
        + R::literal(0.5)
            * (t177 * cos_chain_theta_7 + t178 * sin_chain_theta_7
                + t179 * cos_chain_theta_7 + t180 * sin_chain_theta_7
                + t181 * cos_chain_theta_7 + t182 * sin_chain_theta_7
                + t183 * cos_chain_theta_7 + t184 * sin_chain_theta_7)
            * chain_omega_7_dot;
    let t195 = t194
        + R::literal(0.5)
            * (t179 * cos_chain_theta_8 + t180 * sin_chain_theta_8
                + t181 * cos_chain_theta_8 + t182 * sin_chain_theta_8
                + t183 * cos_chain_theta_8 + t184 * sin_chain_theta_8)
            * chain_omega_8_dot
        + R::literal(0.5)
            * (t181 * cos_chain_theta_9 + t182 * sin_chain_theta_9
                + t183 * cos_chain_theta_9 + t184 * sin_chain_theta_9)
            * chain_omega_9_dot;
    PowerBalance {
        stored_rate: t195
            + R::literal(0.5) * (t183 * cos_chain_theta_10 + t184 * sin_chain_theta_10)
                * chain_omega_10_dot,
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 720 recurrences. 300 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
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
    let (mut lanes_29, _) = Lanes::<R, 10>::new(workspace, coefficients.len());
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_theta_6, chain_theta_7, chain_theta_8, chain_theta_9, chain_theta_10,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5,
    chain_omega_6, chain_omega_7, chain_omega_8, chain_omega_9, chain_omega_10] = *state;
    let t0 = chain_theta_1 - chain_theta_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = t2 * R::literal(9.0);
    let t4 = chain_theta_1 - chain_theta_3;
    let t5 = t4.sin();
    let t6 = t4.cos();
    let t7 = t6 * R::literal(8.0);
    let t8 = chain_theta_1 - chain_theta_4;
    let t9 = t8.sin();
    let t10 = t8.cos();
    let t11 = t10 * R::literal(7.0);
    let t12 = chain_theta_1 - chain_theta_5;
    let t13 = t12.sin();
    let t14 = t12.cos();
    let t15 = t14 * R::literal(6.0);
    let t16 = chain_theta_1 - chain_theta_6;
    let t17 = t16.sin();
    let t18 = t16.cos();
    let t19 = t18 * R::literal(5.0);
    let t20 = chain_theta_1 - chain_theta_7;
    let t21 = t20.sin();
    let t22 = t20.cos();
    let t23 = t22 * R::literal(4.0);
    let t24 = chain_theta_1 - chain_theta_8;
    let t25 = t24.sin();
    let t26 = t24.cos();
    let t27 = t26 * R::literal(3.0);
    let t28 = chain_theta_1 - chain_theta_9;
    let t29 = t28.sin();
    let t30 = t28.cos();
    let t31 = t30 * R::literal(2.0);
    let t32 = chain_theta_1 - chain_theta_10;
    let t33 = t32.sin();
    let t34 = t32.cos();
    let t35 = chain_theta_2 - chain_theta_3;
    let t36 = t35.sin();
    let t37 = t35.cos();
    let t38 = t37 * R::literal(8.0);
    let t39 = chain_theta_2 - chain_theta_4;
    let t40 = t39.sin();
    let t41 = t39.cos();
    let t42 = t41 * R::literal(7.0);
    let t43 = chain_theta_2 - chain_theta_5;
    let t44 = t43.sin();
    let t45 = t43.cos();
    let t46 = t45 * R::literal(6.0);
    let t47 = chain_theta_2 - chain_theta_6;
    let t48 = t47.sin();
    let t49 = t47.cos();
    let t50 = t49 * R::literal(5.0);
    let t51 = chain_theta_2 - chain_theta_7;
    let t52 = t51.sin();
    let t53 = t51.cos();
    let t54 = t53 * R::literal(4.0);
    let t55 = chain_theta_2 - chain_theta_8;
    let t56 = t55.sin();
    let t57 = t55.cos();
    let t58 = t57 * R::literal(3.0);
    let t59 = chain_theta_2 - chain_theta_9;
    let t60 = t59.sin();
    let t61 = t59.cos();
    let t62 = t61 * R::literal(2.0);
    let t63 = chain_theta_2 - chain_theta_10;
    let t64 = t63.sin();
    let t65 = t63.cos();
    let t66 = chain_theta_3 - chain_theta_4;
    let t67 = t66.sin();
    let t68 = t66.cos();
    let t69 = t68 * R::literal(7.0);
    let t70 = chain_theta_3 - chain_theta_5;
    let t71 = t70.sin();
    let t72 = t70.cos();
    let t73 = t72 * R::literal(6.0);
    let t74 = chain_theta_3 - chain_theta_6;
    let t75 = t74.sin();
    let t76 = t74.cos();
    let t77 = t76 * R::literal(5.0);
    let t78 = chain_theta_3 - chain_theta_7;
    let t79 = t78.sin();
    let t80 = t78.cos();
    let t81 = t80 * R::literal(4.0);
    let t82 = chain_theta_3 - chain_theta_8;
    let t83 = t82.sin();
    let t84 = t82.cos();
    let t85 = t84 * R::literal(3.0);
    let t86 = chain_theta_3 - chain_theta_9;
    let t87 = t86.sin();
    let t88 = t86.cos();
    let t89 = t88 * R::literal(2.0);
    let t90 = chain_theta_3 - chain_theta_10;
    let t91 = t90.sin();
    let t92 = t90.cos();
    let t93 = chain_theta_4 - chain_theta_5;
    let t94 = t93.sin();
    let t95 = t93.cos();
    let t96 = t95 * R::literal(6.0);
    let t97 = chain_theta_4 - chain_theta_6;
    let t98 = t97.sin();
    let t99 = t97.cos();
    let t100 = t99 * R::literal(5.0);
    let t101 = chain_theta_4 - chain_theta_7;
    let t102 = t101.sin();
    let t103 = t101.cos();
    let t104 = t103 * R::literal(4.0);
    let t105 = chain_theta_4 - chain_theta_8;
    let t106 = t105.sin();
    let t107 = t105.cos();
    let t108 = t107 * R::literal(3.0);
    let t109 = chain_theta_4 - chain_theta_9;
    let t110 = t109.sin();
    let t111 = t109.cos();
    let t112 = t111 * R::literal(2.0);
    let t113 = chain_theta_4 - chain_theta_10;
    let t114 = t113.sin();
    let t115 = t113.cos();
    let t116 = chain_theta_5 - chain_theta_6;
    let t117 = t116.sin();
    let t118 = t116.cos();
    let t119 = t118 * R::literal(5.0);
    let t120 = chain_theta_5 - chain_theta_7;
    let t121 = t120.sin();
    let t122 = t120.cos();
    let t123 = t122 * R::literal(4.0);
    let t124 = chain_theta_5 - chain_theta_8;
    let t125 = t124.sin();
    let t126 = t124.cos();
    let t127 = t126 * R::literal(3.0);
    let t128 = chain_theta_5 - chain_theta_9;
    let t129 = t128.sin();
    let t130 = t128.cos();
    let t131 = t130 * R::literal(2.0);
    let t132 = chain_theta_5 - chain_theta_10;
    let t133 = t132.sin();
    let t134 = t132.cos();
    let t135 = chain_theta_6 - chain_theta_7;
    let t136 = t135.sin();
    let t137 = t135.cos();
    let t138 = t137 * R::literal(4.0);
    let t139 = chain_theta_6 - chain_theta_8;
    let t140 = t139.sin();
    let t141 = t139.cos();
    let t142 = t141 * R::literal(3.0);
    let t143 = chain_theta_6 - chain_theta_9;
    let t144 = t143.sin();
    let t145 = t143.cos();
    let t146 = t145 * R::literal(2.0);
    let t147 = chain_theta_6 - chain_theta_10;
    let t148 = t147.sin();
    let t149 = t147.cos();
    let t150 = chain_theta_7 - chain_theta_8;
    let t151 = t150.sin();
    let t152 = t150.cos();
    let t153 = t152 * R::literal(3.0);
    let t154 = chain_theta_7 - chain_theta_9;
    let t155 = t154.sin();
    let t156 = t154.cos();
    let t157 = t156 * R::literal(2.0);
    let t158 = chain_theta_7 - chain_theta_10;
    let t159 = t158.sin();
    let t160 = t158.cos();
    let t161 = chain_theta_8 - chain_theta_9;
    let t162 = t161.sin();
    let t163 = t161.cos();
    let t164 = t163 * R::literal(2.0);
    let t165 = chain_theta_8 - chain_theta_10;
    let t166 = t165.sin();
    let t167 = t165.cos();
    let t168 = chain_theta_9 - chain_theta_10;
    let t169 = t168.sin();
    let t170 = t168.cos();
    let sin_chain_theta_1 = chain_theta_1.sin();
    let cos_chain_theta_1 = chain_theta_1.cos();
    let sin_chain_theta_2 = chain_theta_2.sin();
    let cos_chain_theta_2 = chain_theta_2.cos();
    let sin_chain_theta_3 = chain_theta_3.sin();
    let cos_chain_theta_3 = chain_theta_3.cos();
    let sin_chain_theta_4 = chain_theta_4.sin();
    let cos_chain_theta_4 = chain_theta_4.cos();
    let sin_chain_theta_5 = chain_theta_5.sin();
    let cos_chain_theta_5 = chain_theta_5.cos();
    let sin_chain_theta_6 = chain_theta_6.sin();
    let cos_chain_theta_6 = chain_theta_6.cos();
    let sin_chain_theta_7 = chain_theta_7.sin();
    let cos_chain_theta_7 = chain_theta_7.cos();
    let sin_chain_theta_8 = chain_theta_8.sin();
    let cos_chain_theta_8 = chain_theta_8.cos();
    let sin_chain_theta_9 = chain_theta_9.sin();
    let cos_chain_theta_9 = chain_theta_9.cos();
    let sin_chain_theta_10 = chain_theta_10.sin();
    let cos_chain_theta_10 = chain_theta_10.cos();
    let t171 = sin_chain_theta_1 * R::literal(98.1);
    let t172 = chain_omega_2 * chain_omega_2;
    let t173 = t172 * R::literal(9.0);
    let t174 = t173 * t1;
    let t175 = chain_omega_3 * chain_omega_3;
    let t176 = t175 * R::literal(8.0);
    let t177 = t176 * t5;
    let t178 = chain_omega_4 * chain_omega_4;
    let t179 = t178 * R::literal(7.0);
    let t180 = t179 * t9;
    let t181 = chain_omega_5 * chain_omega_5;
    let t182 = t181 * R::literal(6.0);
    let t183 = t182 * t13;
    let t184 = chain_omega_6 * chain_omega_6;
    let t185 = t184 * R::literal(5.0);
    let t186 = t185 * t17;
    let t187 = chain_omega_7 * chain_omega_7;
    let t188 = t187 * R::literal(4.0);
    let t189 = t188 * t21;
    let t190 = chain_omega_8 * chain_omega_8;
    let t191 = t190 * R::literal(3.0);
    let t192 = t191 * t25;
    let t193 = chain_omega_9 * chain_omega_9;
    let t194 = t193 * R::literal(2.0);
    let t195 = t194 * t29;
    let t196 = chain_omega_10 * chain_omega_10;
    let t197 = t196 * t33;
    let t198 = -t171;
    let t199 = t198 - t174;
    let t200 = t199 - t177;
    let t201 = t200 - t180;
    let t202 = t201 - t183;
    let t203 = t202 - t186;
    let t204 = t203 - t189;
    let t205 = t204 - t192;
    let t206 = t205 - t195;
    let t207 = t206 - t197;
    let t208 = sin_chain_theta_2 * R::literal(88.29);
    let t209 = chain_omega_1 * chain_omega_1;
    let t210 = -t1;
    let t211 = t209 * R::literal(9.0);
    let t212 = t211 * t210;
    let t213 = t176 * t36;
    let t214 = t179 * t40;
    let t215 = t182 * t44;
    let t216 = t185 * t48;
    let t217 = t188 * t52;
    let t218 = t191 * t56;
    let t219 = t194 * t60;
    let t220 = t196 * t64;
    let t221 = -t208;
    let t222 = t221 - t212;
    let t223 = t222 - t213;
    let t224 = t223 - t214;
    let t225 = t224 - t215;
    let t226 = t225 - t216;
    let t227 = t226 - t217;
    let t228 = t227 - t218;
    let t229 = t228 - t219;
    let t230 = t229 - t220;
    let t231 = sin_chain_theta_3 * R::literal(78.48);
    let t232 = -t5;
    let t233 = t209 * R::literal(8.0);
    let t234 = t233 * t232;
    let t235 = -t36;
    let t236 = t172 * R::literal(8.0);
    let t237 = t236 * t235;
    let t238 = t179 * t67;
    let t239 = t182 * t71;
    let t240 = t185 * t75;
    let t241 = t188 * t79;
    let t242 = t191 * t83;
    let t243 = t194 * t87;
    let t244 = t196 * t91;
    let t245 = -t231;
    let t246 = t245 - t234;
    let t247 = t246 - t237;
    let t248 = t247 - t238;
    let t249 = t248 - t239;
    let t250 = t249 - t240;
    let t251 = t250 - t241;
    let t252 = t251 - t242;
    let t253 = t252 - t243;
    let t254 = t253 - t244;
    let t255 = sin_chain_theta_4 * R::literal(68.67);
    let t256 = -t9;
    let t257 = t209 * R::literal(7.0);
    let t258 = t257 * t256;
    let t259 = -t40;
    let t260 = t172 * R::literal(7.0);
    let t261 = t260 * t259;
    let t262 = -t67;
    let t263 = t175 * R::literal(7.0);
    let t264 = t263 * t262;
    let t265 = t182 * t94;
    let t266 = t185 * t98;
    let t267 = t188 * t102;
    let t268 = t191 * t106;
    let t269 = t194 * t110;
    let t270 = t196 * t114;
    let t271 = -t255;
    let t272 = t271 - t258;
    let t273 = t272 - t261;
    let t274 = t273 - t264;
    let t275 = t274 - t265;
    let t276 = t275 - t266;
    let t277 = t276 - t267;
    let t278 = t277 - t268;
    let t279 = t278 - t269;
    let t280 = t279 - t270;
    let t281 = sin_chain_theta_5 * R::literal(58.86);
    let t282 = -t13;
    let t283 = t209 * R::literal(6.0);
    let t284 = t283 * t282;
    let t285 = -t44;
    let t286 = t172 * R::literal(6.0);
    let t287 = t286 * t285;
    let t288 = -t71;
    let t289 = t175 * R::literal(6.0);
    let t290 = t289 * t288;
    let t291 = -t94;
    let t292 = t178 * R::literal(6.0);
    let t293 = t292 * t291;
    let t294 = t185 * t117;
    let t295 = t188 * t121;
    let t296 = t191 * t125;
    let t297 = t194 * t129;
    let t298 = t196 * t133;
    let t299 = -t281;
    let t300 = t299 - t284;
    let t301 = t300 - t287;
    let t302 = t301 - t290;
    let t303 = t302 - t293;
    let t304 = t303 - t294;
    let t305 = t304 - t295;
    let t306 = t305 - t296;
    let t307 = t306 - t297;
    let t308 = t307 - t298;
    let t309 = sin_chain_theta_6 * R::literal(49.05);
    let t310 = -t17;
    let t311 = t209 * R::literal(5.0);
    let t312 = t311 * t310;
    let t313 = -t48;
    let t314 = t172 * R::literal(5.0);
    let t315 = t314 * t313;
    let t316 = -t75;
    let t317 = t175 * R::literal(5.0);
    let t318 = t317 * t316;
    let t319 = -t98;
    let t320 = t178 * R::literal(5.0);
    let t321 = t320 * t319;
    let t322 = -t117;
    let t323 = t181 * R::literal(5.0);
    let t324 = t323 * t322;
    let t325 = t188 * t136;
    let t326 = t191 * t140;
    let t327 = t194 * t144;
    let t328 = t196 * t148;
    let t329 = -t309;
    let t330 = t329 - t312;
    let t331 = t330 - t315;
    let t332 = t331 - t318;
    let t333 = t332 - t321;
    let t334 = t333 - t324;
    let t335 = t334 - t325;
    let t336 = t335 - t326;
    let t337 = t336 - t327;
    let t338 = t337 - t328;
    let t339 = sin_chain_theta_7 * R::literal(39.24);
    let t340 = -t21;
    let t341 = t209 * R::literal(4.0);
    let t342 = t341 * t340;
    let t343 = -t52;
    let t344 = t172 * R::literal(4.0);
    let t345 = t344 * t343;
    let t346 = -t79;
    let t347 = t175 * R::literal(4.0);
    let t348 = t347 * t346;
    let t349 = -t102;
    let t350 = t178 * R::literal(4.0);
    let t351 = t350 * t349;
    let t352 = -t121;
    let t353 = t181 * R::literal(4.0);
    let t354 = t353 * t352;
    let t355 = -t136;
    let t356 = t184 * R::literal(4.0);
    let t357 = t356 * t355;
    let t358 = t191 * t151;
    let t359 = t194 * t155;
    let t360 = t196 * t159;
    let t361 = -t339;
    let t362 = t361 - t342;
    let t363 = t362 - t345;
    let t364 = t363 - t348;
    let t365 = t364 - t351;
    let t366 = t365 - t354;
    let t367 = t366 - t357;
    let t368 = t367 - t358;
    let t369 = t368 - t359;
    let t370 = t369 - t360;
    let t371 = sin_chain_theta_8 * R::literal(29.43);
    let t372 = -t25;
    let t373 = t209 * R::literal(3.0);
    let t374 = t373 * t372;
    let t375 = -t56;
    let t376 = t172 * R::literal(3.0);
    let t377 = t376 * t375;
    let t378 = -t83;
    let t379 = t175 * R::literal(3.0);
    let t380 = t379 * t378;
    let t381 = -t106;
    let t382 = t178 * R::literal(3.0);
    let t383 = t382 * t381;
    let t384 = -t125;
    let t385 = t181 * R::literal(3.0);
    let t386 = t385 * t384;
    let t387 = -t140;
    let t388 = t184 * R::literal(3.0);
    let t389 = t388 * t387;
    let t390 = -t151;
    let t391 = t187 * R::literal(3.0);
    let t392 = t391 * t390;
    let t393 = t194 * t162;
    let t394 = t196 * t166;
    let t395 = -t371;
    let t396 = t395 - t374;
    let t397 = t396 - t377;
    let t398 = t397 - t380;
    let t399 = t398 - t383;
    let t400 = t399 - t386;
    let t401 = t400 - t389;
    let t402 = t401 - t392;
    let t403 = t402 - t393;
    let t404 = t403 - t394;
    let t405 = sin_chain_theta_9 * R::literal(19.62);
    let t406 = -t29;
    let t407 = t209 * R::literal(2.0);
    let t408 = t407 * t406;
    let t409 = -t60;
    let t410 = t172 * R::literal(2.0);
    let t411 = t410 * t409;
    let t412 = -t87;
    let t413 = t175 * R::literal(2.0);
    let t414 = t413 * t412;
    let t415 = -t110;
    let t416 = t178 * R::literal(2.0);
    let t417 = t416 * t415;
    let t418 = -t129;
    let t419 = t181 * R::literal(2.0);
    let t420 = t419 * t418;
    let t421 = -t144;
    let t422 = t184 * R::literal(2.0);
    let t423 = t422 * t421;
    let t424 = -t155;
    let t425 = t187 * R::literal(2.0);
    let t426 = t425 * t424;
    let t427 = -t162;
    let t428 = t190 * R::literal(2.0);
    let t429 = t428 * t427;
    let t430 = t196 * t169;
    let t431 = -t405;
    let t432 = t431 - t408;
    let t433 = t432 - t411;
    let t434 = t433 - t414;
    let t435 = t434 - t417;
    let t436 = t435 - t420;
    let t437 = t436 - t423;
    let t438 = t437 - t426;
    let t439 = t438 - t429;
    let t440 = t439 - t430;
    let t441 = sin_chain_theta_10 * R::literal(9.81);
    let t442 = -t33;
    let t443 = t209 * t442;
    let t444 = -t64;
    let t445 = t172 * t444;
    let t446 = -t91;
    let t447 = t175 * t446;
    let t448 = -t114;
    let t449 = t178 * t448;
    let t450 = -t133;
    let t451 = t181 * t450;
    let t452 = -t148;
    let t453 = t184 * t452;
    let t454 = -t159;
    let t455 = t187 * t454;
    let t456 = -t166;
    let t457 = t190 * t456;
    let t458 = -t169;
    let t459 = t193 * t458;
    let t460 = -t441;
    let t461 = t460 - t443;
    let t462 = t461 - t445;
    let t463 = t462 - t447;
    let t464 = t463 - t449;
    let t465 = t464 - t451;
    let t466 = t465 - t453;
    let t467 = t466 - t455;
    let t468 = t467 - t457;
    let t469 = t468 - t459;
    let factored = Factored::new([
        [
            R::literal(10.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t3,
            R::literal(9.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t7,
            t38,
            R::literal(8.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t11,
            t42,
            t69,
            R::literal(7.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t15,
            t46,
            t73,
            t96,
            R::literal(6.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t19,
            t50,
            t77,
            t100,
            t119,
            R::literal(5.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t23,
            t54,
            t81,
            t104,
            t123,
            t138,
            R::literal(4.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [
            t27,
            t58,
            t85,
            t108,
            t127,
            t142,
            t153,
            R::literal(3.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [t31, t62, t89, t112, t131, t146, t157, t164, R::literal(2.0), R::literal(0.0)],
        [t34, t65, t92, t115, t134, t149, t160, t167, t170, R::literal(1.0)],
    ]);
    let [chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
    chain_omega_5_dot, chain_omega_6_dot, chain_omega_7_dot, chain_omega_8_dot,
    chain_omega_9_dot, chain_omega_10_dot] = factored
        .solve([t207, t230, t254, t280, t308, t338, t370, t404, t440, t469]);
    let mut rates = [
        chain_omega_1,
        chain_omega_2,
        chain_omega_3,
        chain_omega_4,
        chain_omega_5,
        chain_omega_6,
        chain_omega_7,
        chain_omega_8,
        chain_omega_9,
        chain_omega_10,
        chain_omega_1_dot,
        chain_omega_2_dot,
        chain_omega_3_dot,
        chain_omega_4_dot,
        chain_omega_5_dot,
        chain_omega_6_dot,
        chain_omega_7_dot,
        chain_omega_8_dot,
        chain_omega_9_dot,
        chain_omega_10_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [chain_theta_1_k, chain_theta_2_k, chain_theta_3_k, chain_theta_4_k,
        chain_theta_5_k, chain_theta_6_k, chain_theta_7_k, chain_theta_8_k,
        chain_theta_9_k, chain_theta_10_k, chain_omega_1_k, chain_omega_2_k,
        chain_omega_3_k, chain_omega_4_k, chain_omega_5_k, chain_omega_6_k,
        chain_omega_7_k, chain_omega_8_k, chain_omega_9_k, chain_omega_10_k] = *state_k;
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
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = inverse * sums[0] + t0_k * t2;
        let t2_k = -(inverse * sums[1] + t0_k * t1);
        let t3_k = t2_k * R::literal(9.0);
        let t4_k = chain_theta_1_k - chain_theta_3_k;
        let t5_k = inverse * sums[2] + t4_k * t6;
        let t6_k = -(inverse * sums[3] + t4_k * t5);
        let t7_k = t6_k * R::literal(8.0);
        let t8_k = chain_theta_1_k - chain_theta_4_k;
        let t9_k = inverse * sums[4] + t8_k * t10;
        let t10_k = -(inverse * sums[5] + t8_k * t9);
        let t11_k = t10_k * R::literal(7.0);
        let t12_k = chain_theta_1_k - chain_theta_5_k;
        let t13_k = inverse * sums[6] + t12_k * t14;
        let t14_k = -(inverse * sums[7] + t12_k * t13);
        let t15_k = t14_k * R::literal(6.0);
        let t16_k = chain_theta_1_k - chain_theta_6_k;
        let t17_k = inverse * sums[8] + t16_k * t18;
        let t18_k = -(inverse * sums[9] + t16_k * t17);
        let t19_k = t18_k * R::literal(5.0);
        let t20_k = chain_theta_1_k - chain_theta_7_k;
        let t21_k = inverse * sums_1[0] + t20_k * t22;
        let t22_k = -(inverse * sums_1[1] + t20_k * t21);
        let t23_k = t22_k * R::literal(4.0);
        let t24_k = chain_theta_1_k - chain_theta_8_k;
        let t25_k = inverse * sums_1[2] + t24_k * t26;
        let t26_k = -(inverse * sums_1[3] + t24_k * t25);
        let t27_k = t26_k * R::literal(3.0);
        let t28_k = chain_theta_1_k - chain_theta_9_k;
        let t29_k = inverse * sums_1[4] + t28_k * t30;
        let t30_k = -(inverse * sums_1[5] + t28_k * t29);
        let t31_k = t30_k * R::literal(2.0);
        let t32_k = chain_theta_1_k - chain_theta_10_k;
        let t33_k = inverse * sums_1[6] + t32_k * t34;
        let t34_k = -(inverse * sums_1[7] + t32_k * t33);
        let t35_k = chain_theta_2_k - chain_theta_3_k;
        let t36_k = inverse * sums_1[8] + t35_k * t37;
        let t37_k = -(inverse * sums_1[9] + t35_k * t36);
        let t38_k = t37_k * R::literal(8.0);
        let t39_k = chain_theta_2_k - chain_theta_4_k;
        let t40_k = inverse * sums_2[0] + t39_k * t41;
        let t41_k = -(inverse * sums_2[1] + t39_k * t40);
        let t42_k = t41_k * R::literal(7.0);
        let t43_k = chain_theta_2_k - chain_theta_5_k;
        let t44_k = inverse * sums_2[2] + t43_k * t45;
        let t45_k = -(inverse * sums_2[3] + t43_k * t44);
        let t46_k = t45_k * R::literal(6.0);
        let t47_k = chain_theta_2_k - chain_theta_6_k;
        let t48_k = inverse * sums_2[4] + t47_k * t49;
        let t49_k = -(inverse * sums_2[5] + t47_k * t48);
        let t50_k = t49_k * R::literal(5.0);
        let t51_k = chain_theta_2_k - chain_theta_7_k;
        let t52_k = inverse * sums_2[6] + t51_k * t53;
        let t53_k = -(inverse * sums_2[7] + t51_k * t52);
        let t54_k = t53_k * R::literal(4.0);
        let t55_k = chain_theta_2_k - chain_theta_8_k;
        let t56_k = inverse * sums_2[8] + t55_k * t57;
        let t57_k = -(inverse * sums_2[9] + t55_k * t56);
        let t58_k = t57_k * R::literal(3.0);
        let t59_k = chain_theta_2_k - chain_theta_9_k;
        let t60_k = inverse * sums_3[0] + t59_k * t61;
        let t61_k = -(inverse * sums_3[1] + t59_k * t60);
        let t62_k = t61_k * R::literal(2.0);
        let t63_k = chain_theta_2_k - chain_theta_10_k;
        let t64_k = inverse * sums_3[2] + t63_k * t65;
        let t65_k = -(inverse * sums_3[3] + t63_k * t64);
        let t66_k = chain_theta_3_k - chain_theta_4_k;
        let t67_k = inverse * sums_3[4] + t66_k * t68;
        let t68_k = -(inverse * sums_3[5] + t66_k * t67);
        let t69_k = t68_k * R::literal(7.0);
        let t70_k = chain_theta_3_k - chain_theta_5_k;
        let t71_k = inverse * sums_3[6] + t70_k * t72;
        let t72_k = -(inverse * sums_3[7] + t70_k * t71);
        let t73_k = t72_k * R::literal(6.0);
        let t74_k = chain_theta_3_k - chain_theta_6_k;
        let t75_k = inverse * sums_3[8] + t74_k * t76;
        let t76_k = -(inverse * sums_3[9] + t74_k * t75);
        let t77_k = t76_k * R::literal(5.0);
        let t78_k = chain_theta_3_k - chain_theta_7_k;
        let t79_k = inverse * sums_4[0] + t78_k * t80;
        let t80_k = -(inverse * sums_4[1] + t78_k * t79);
        let t81_k = t80_k * R::literal(4.0);
        let t82_k = chain_theta_3_k - chain_theta_8_k;
        let t83_k = inverse * sums_4[2] + t82_k * t84;
        let t84_k = -(inverse * sums_4[3] + t82_k * t83);
        let t85_k = t84_k * R::literal(3.0);
        let t86_k = chain_theta_3_k - chain_theta_9_k;
        let t87_k = inverse * sums_4[4] + t86_k * t88;
        let t88_k = -(inverse * sums_4[5] + t86_k * t87);
        let t89_k = t88_k * R::literal(2.0);
        let t90_k = chain_theta_3_k - chain_theta_10_k;
        let t91_k = inverse * sums_4[6] + t90_k * t92;
        let t92_k = -(inverse * sums_4[7] + t90_k * t91);
        let t93_k = chain_theta_4_k - chain_theta_5_k;
        let t94_k = inverse * sums_4[8] + t93_k * t95;
        let t95_k = -(inverse * sums_4[9] + t93_k * t94);
        let t96_k = t95_k * R::literal(6.0);
        let t97_k = chain_theta_4_k - chain_theta_6_k;
        let t98_k = inverse * sums_5[0] + t97_k * t99;
        let t99_k = -(inverse * sums_5[1] + t97_k * t98);
        let t100_k = t99_k * R::literal(5.0);
        let t101_k = chain_theta_4_k - chain_theta_7_k;
        let t102_k = inverse * sums_5[2] + t101_k * t103;
        let t103_k = -(inverse * sums_5[3] + t101_k * t102);
        let t104_k = t103_k * R::literal(4.0);
        let t105_k = chain_theta_4_k - chain_theta_8_k;
        let t106_k = inverse * sums_5[4] + t105_k * t107;
        let t107_k = -(inverse * sums_5[5] + t105_k * t106);
        let t108_k = t107_k * R::literal(3.0);
        let t109_k = chain_theta_4_k - chain_theta_9_k;
        let t110_k = inverse * sums_5[6] + t109_k * t111;
        let t111_k = -(inverse * sums_5[7] + t109_k * t110);
        let t112_k = t111_k * R::literal(2.0);
        let t113_k = chain_theta_4_k - chain_theta_10_k;
        let t114_k = inverse * sums_5[8] + t113_k * t115;
        let t115_k = -(inverse * sums_5[9] + t113_k * t114);
        let t116_k = chain_theta_5_k - chain_theta_6_k;
        let t117_k = inverse * sums_6[0] + t116_k * t118;
        let t118_k = -(inverse * sums_6[1] + t116_k * t117);
        let t119_k = t118_k * R::literal(5.0);
        let t120_k = chain_theta_5_k - chain_theta_7_k;
        let t121_k = inverse * sums_6[2] + t120_k * t122;
        let t122_k = -(inverse * sums_6[3] + t120_k * t121);
        let t123_k = t122_k * R::literal(4.0);
        let t124_k = chain_theta_5_k - chain_theta_8_k;
        let t125_k = inverse * sums_6[4] + t124_k * t126;
        let t126_k = -(inverse * sums_6[5] + t124_k * t125);
        let t127_k = t126_k * R::literal(3.0);
        let t128_k = chain_theta_5_k - chain_theta_9_k;
        let t129_k = inverse * sums_6[6] + t128_k * t130;
        let t130_k = -(inverse * sums_6[7] + t128_k * t129);
        let t131_k = t130_k * R::literal(2.0);
        let t132_k = chain_theta_5_k - chain_theta_10_k;
        let t133_k = inverse * sums_6[8] + t132_k * t134;
        let t134_k = -(inverse * sums_6[9] + t132_k * t133);
        let t135_k = chain_theta_6_k - chain_theta_7_k;
        let t136_k = inverse * sums_7[0] + t135_k * t137;
        let t137_k = -(inverse * sums_7[1] + t135_k * t136);
        let t138_k = t137_k * R::literal(4.0);
        let t139_k = chain_theta_6_k - chain_theta_8_k;
        let t140_k = inverse * sums_7[2] + t139_k * t141;
        let t141_k = -(inverse * sums_7[3] + t139_k * t140);
        let t142_k = t141_k * R::literal(3.0);
        let t143_k = chain_theta_6_k - chain_theta_9_k;
        let t144_k = inverse * sums_7[4] + t143_k * t145;
        let t145_k = -(inverse * sums_7[5] + t143_k * t144);
        let t146_k = t145_k * R::literal(2.0);
        let t147_k = chain_theta_6_k - chain_theta_10_k;
        let t148_k = inverse * sums_7[6] + t147_k * t149;
        let t149_k = -(inverse * sums_7[7] + t147_k * t148);
        let t150_k = chain_theta_7_k - chain_theta_8_k;
        let t151_k = inverse * sums_7[8] + t150_k * t152;
        let t152_k = -(inverse * sums_7[9] + t150_k * t151);
        let t153_k = t152_k * R::literal(3.0);
        let t154_k = chain_theta_7_k - chain_theta_9_k;
        let t155_k = inverse * sums_8[0] + t154_k * t156;
        let t156_k = -(inverse * sums_8[1] + t154_k * t155);
        let t157_k = t156_k * R::literal(2.0);
        let t158_k = chain_theta_7_k - chain_theta_10_k;
        let t159_k = inverse * sums_8[2] + t158_k * t160;
        let t160_k = -(inverse * sums_8[3] + t158_k * t159);
        let t161_k = chain_theta_8_k - chain_theta_9_k;
        let t162_k = inverse * sums_8[4] + t161_k * t163;
        let t163_k = -(inverse * sums_8[5] + t161_k * t162);
        let t164_k = t163_k * R::literal(2.0);
        let t165_k = chain_theta_8_k - chain_theta_10_k;
        let t166_k = inverse * sums_8[6] + t165_k * t167;
        let t167_k = -(inverse * sums_8[7] + t165_k * t166);
        let t168_k = chain_theta_9_k - chain_theta_10_k;
        let t169_k = inverse * sums_8[8] + t168_k * t170;
        let t170_k = -(inverse * sums_8[9] + t168_k * t169);
        let sin_chain_theta_1_k = inverse * sums_9[0]
            + chain_theta_1_k * cos_chain_theta_1;
        let cos_chain_theta_1_k = -(inverse * sums_9[1]
            + chain_theta_1_k * sin_chain_theta_1);
        let sin_chain_theta_2_k = inverse * sums_9[2]
            + chain_theta_2_k * cos_chain_theta_2;
        let cos_chain_theta_2_k = -(inverse * sums_9[3]
            + chain_theta_2_k * sin_chain_theta_2);
        let sin_chain_theta_3_k = inverse * sums_9[4]
            + chain_theta_3_k * cos_chain_theta_3;
        let cos_chain_theta_3_k = -(inverse * sums_9[5]
            + chain_theta_3_k * sin_chain_theta_3);
        let sin_chain_theta_4_k = inverse * sums_9[6]
            + chain_theta_4_k * cos_chain_theta_4;
        let cos_chain_theta_4_k = -(inverse * sums_9[7]
            + chain_theta_4_k * sin_chain_theta_4);
        let sin_chain_theta_5_k = inverse * sums_9[8]
            + chain_theta_5_k * cos_chain_theta_5;
        let cos_chain_theta_5_k = -(inverse * sums_9[9]
            + chain_theta_5_k * sin_chain_theta_5);
        let sin_chain_theta_6_k = inverse * sums_10[0]
            + chain_theta_6_k * cos_chain_theta_6;
        let cos_chain_theta_6_k = -(inverse * sums_10[1]
            + chain_theta_6_k * sin_chain_theta_6);
        let sin_chain_theta_7_k = inverse * sums_10[2]
            + chain_theta_7_k * cos_chain_theta_7;
        let cos_chain_theta_7_k = -(inverse * sums_10[3]
            + chain_theta_7_k * sin_chain_theta_7);
        let sin_chain_theta_8_k = inverse * sums_10[4]
            + chain_theta_8_k * cos_chain_theta_8;
        let cos_chain_theta_8_k = -(inverse * sums_10[5]
            + chain_theta_8_k * sin_chain_theta_8);
        let sin_chain_theta_9_k = inverse * sums_10[6]
            + chain_theta_9_k * cos_chain_theta_9;
        let cos_chain_theta_9_k = -(inverse * sums_10[7]
            + chain_theta_9_k * sin_chain_theta_9);
        let sin_chain_theta_10_k = inverse * sums_10[8]
            + chain_theta_10_k * cos_chain_theta_10;
        let cos_chain_theta_10_k = -(inverse * sums_10[9]
            + chain_theta_10_k * sin_chain_theta_10);
        let t171_k = sin_chain_theta_1_k * R::literal(98.1);
        let t172_k = sums_11[0] + chain_omega_2 * chain_omega_2_k
            + chain_omega_2_k * chain_omega_2;
        let t173_k = t172_k * R::literal(9.0);
        let t174_k = sums_11[1] + t173 * t1_k + t173_k * t1;
        let t175_k = sums_11[2] + chain_omega_3 * chain_omega_3_k
            + chain_omega_3_k * chain_omega_3;
        let t176_k = t175_k * R::literal(8.0);
        let t177_k = sums_11[3] + t176 * t5_k + t176_k * t5;
        let t178_k = sums_11[4] + chain_omega_4 * chain_omega_4_k
            + chain_omega_4_k * chain_omega_4;
        let t179_k = t178_k * R::literal(7.0);
        let t180_k = sums_11[5] + t179 * t9_k + t179_k * t9;
        let t181_k = sums_11[6] + chain_omega_5 * chain_omega_5_k
            + chain_omega_5_k * chain_omega_5;
        let t182_k = t181_k * R::literal(6.0);
        let t183_k = sums_11[7] + t182 * t13_k + t182_k * t13;
        let t184_k = sums_11[8] + chain_omega_6 * chain_omega_6_k
            + chain_omega_6_k * chain_omega_6;
        let t185_k = t184_k * R::literal(5.0);
        let t186_k = sums_11[9] + t185 * t17_k + t185_k * t17;
        let t187_k = sums_12[0] + chain_omega_7 * chain_omega_7_k
            + chain_omega_7_k * chain_omega_7;
        let t188_k = t187_k * R::literal(4.0);
        let t189_k = sums_12[1] + t188 * t21_k + t188_k * t21;
        let t190_k = sums_12[2] + chain_omega_8 * chain_omega_8_k
            + chain_omega_8_k * chain_omega_8;
        let t191_k = t190_k * R::literal(3.0);
        let t192_k = sums_12[3] + t191 * t25_k + t191_k * t25;
        let t193_k = sums_12[4] + chain_omega_9 * chain_omega_9_k
            + chain_omega_9_k * chain_omega_9;
        let t194_k = t193_k * R::literal(2.0);
        let t195_k = sums_12[5] + t194 * t29_k + t194_k * t29;
        let t196_k = sums_12[6] + chain_omega_10 * chain_omega_10_k
            + chain_omega_10_k * chain_omega_10;
        let t197_k = sums_12[7] + t196 * t33_k + t196_k * t33;
        let t198_k = -t171_k;
        let t199_k = t198_k - t174_k;
        let t200_k = t199_k - t177_k;
        let t201_k = t200_k - t180_k;
        let t202_k = t201_k - t183_k;
        let t203_k = t202_k - t186_k;
        let t204_k = t203_k - t189_k;
        let t205_k = t204_k - t192_k;
        let t206_k = t205_k - t195_k;
        let t207_k = t206_k - t197_k;
        let t208_k = sin_chain_theta_2_k * R::literal(88.29);
        let t209_k = sums_12[8] + chain_omega_1 * chain_omega_1_k
            + chain_omega_1_k * chain_omega_1;
        let t210_k = -t1_k;
        let t211_k = t209_k * R::literal(9.0);
        let t212_k = sums_12[9] + t211 * t210_k + t211_k * t210;
        let t213_k = sums_13[0] + t176 * t36_k + t176_k * t36;
        let t214_k = sums_13[1] + t179 * t40_k + t179_k * t40;
        let t215_k = sums_13[2] + t182 * t44_k + t182_k * t44;
        let t216_k = sums_13[3] + t185 * t48_k + t185_k * t48;
        let t217_k = sums_13[4] + t188 * t52_k + t188_k * t52;
        let t218_k = sums_13[5] + t191 * t56_k + t191_k * t56;
        let t219_k = sums_13[6] + t194 * t60_k + t194_k * t60;
        let t220_k = sums_13[7] + t196 * t64_k + t196_k * t64;
        let t221_k = -t208_k;
        let t222_k = t221_k - t212_k;
        let t223_k = t222_k - t213_k;
        let t224_k = t223_k - t214_k;
        let t225_k = t224_k - t215_k;
        let t226_k = t225_k - t216_k;
        let t227_k = t226_k - t217_k;
        let t228_k = t227_k - t218_k;
        let t229_k = t228_k - t219_k;
        let t230_k = t229_k - t220_k;
        let t231_k = sin_chain_theta_3_k * R::literal(78.48);
        let t232_k = -t5_k;
        let t233_k = t209_k * R::literal(8.0);
        let t234_k = sums_13[8] + t233 * t232_k + t233_k * t232;
        let t235_k = -t36_k;
        let t236_k = t172_k * R::literal(8.0);
        let t237_k = sums_13[9] + t236 * t235_k + t236_k * t235;
        let t238_k = sums_14[0] + t179 * t67_k + t179_k * t67;
        let t239_k = sums_14[1] + t182 * t71_k + t182_k * t71;
        let t240_k = sums_14[2] + t185 * t75_k + t185_k * t75;
        let t241_k = sums_14[3] + t188 * t79_k + t188_k * t79;
        let t242_k = sums_14[4] + t191 * t83_k + t191_k * t83;
        let t243_k = sums_14[5] + t194 * t87_k + t194_k * t87;
        let t244_k = sums_14[6] + t196 * t91_k + t196_k * t91;
        let t245_k = -t231_k;
        let t246_k = t245_k - t234_k;
        let t247_k = t246_k - t237_k;
        let t248_k = t247_k - t238_k;
        let t249_k = t248_k - t239_k;
        let t250_k = t249_k - t240_k;
        let t251_k = t250_k - t241_k;
        let t252_k = t251_k - t242_k;
        let t253_k = t252_k - t243_k;
        let t254_k = t253_k - t244_k;
        let t255_k = sin_chain_theta_4_k * R::literal(68.67);
        let t256_k = -t9_k;
        let t257_k = t209_k * R::literal(7.0);
        let t258_k = sums_14[7] + t257 * t256_k + t257_k * t256;
        let t259_k = -t40_k;
        let t260_k = t172_k * R::literal(7.0);
        let t261_k = sums_14[8] + t260 * t259_k + t260_k * t259;
        let t262_k = -t67_k;
        let t263_k = t175_k * R::literal(7.0);
        let t264_k = sums_14[9] + t263 * t262_k + t263_k * t262;
        let t265_k = sums_15[0] + t182 * t94_k + t182_k * t94;
        let t266_k = sums_15[1] + t185 * t98_k + t185_k * t98;
        let t267_k = sums_15[2] + t188 * t102_k + t188_k * t102;
        let t268_k = sums_15[3] + t191 * t106_k + t191_k * t106;
        let t269_k = sums_15[4] + t194 * t110_k + t194_k * t110;
        let t270_k = sums_15[5] + t196 * t114_k + t196_k * t114;
        let t271_k = -t255_k;
        let t272_k = t271_k - t258_k;
        let t273_k = t272_k - t261_k;
        let t274_k = t273_k - t264_k;
        let t275_k = t274_k - t265_k;
        let t276_k = t275_k - t266_k;
        let t277_k = t276_k - t267_k;
        let t278_k = t277_k - t268_k;
        let t279_k = t278_k - t269_k;
        let t280_k = t279_k - t270_k;
        let t281_k = sin_chain_theta_5_k * R::literal(58.86);
        let t282_k = -t13_k;
        let t283_k = t209_k * R::literal(6.0);
        let t284_k = sums_15[6] + t283 * t282_k + t283_k * t282;
        let t285_k = -t44_k;
        let t286_k = t172_k * R::literal(6.0);
        let t287_k = sums_15[7] + t286 * t285_k + t286_k * t285;
        let t288_k = -t71_k;
        let t289_k = t175_k * R::literal(6.0);
        let t290_k = sums_15[8] + t289 * t288_k + t289_k * t288;
        let t291_k = -t94_k;
        let t292_k = t178_k * R::literal(6.0);
        let t293_k = sums_15[9] + t292 * t291_k + t292_k * t291;
        let t294_k = sums_16[0] + t185 * t117_k + t185_k * t117;
        let t295_k = sums_16[1] + t188 * t121_k + t188_k * t121;
        let t296_k = sums_16[2] + t191 * t125_k + t191_k * t125;
        let t297_k = sums_16[3] + t194 * t129_k + t194_k * t129;
        let t298_k = sums_16[4] + t196 * t133_k + t196_k * t133;
        let t299_k = -t281_k;
        let t300_k = t299_k - t284_k;
        let t301_k = t300_k - t287_k;
        let t302_k = t301_k - t290_k;
        let t303_k = t302_k - t293_k;
        let t304_k = t303_k - t294_k;
        let t305_k = t304_k - t295_k;
        let t306_k = t305_k - t296_k;
        let t307_k = t306_k - t297_k;
        let t308_k = t307_k - t298_k;
        let t309_k = sin_chain_theta_6_k * R::literal(49.05);
        let t310_k = -t17_k;
        let t311_k = t209_k * R::literal(5.0);
        let t312_k = sums_16[5] + t311 * t310_k + t311_k * t310;
        let t313_k = -t48_k;
        let t314_k = t172_k * R::literal(5.0);
        let t315_k = sums_16[6] + t314 * t313_k + t314_k * t313;
        let t316_k = -t75_k;
        let t317_k = t175_k * R::literal(5.0);
        let t318_k = sums_16[7] + t317 * t316_k + t317_k * t316;
        let t319_k = -t98_k;
        let t320_k = t178_k * R::literal(5.0);
        let t321_k = sums_16[8] + t320 * t319_k + t320_k * t319;
        let t322_k = -t117_k;
        let t323_k = t181_k * R::literal(5.0);
        let t324_k = sums_16[9] + t323 * t322_k + t323_k * t322;
        let t325_k = sums_17[0] + t188 * t136_k + t188_k * t136;
        let t326_k = sums_17[1] + t191 * t140_k + t191_k * t140;
        let t327_k = sums_17[2] + t194 * t144_k + t194_k * t144;
        let t328_k = sums_17[3] + t196 * t148_k + t196_k * t148;
        let t329_k = -t309_k;
        let t330_k = t329_k - t312_k;
        let t331_k = t330_k - t315_k;
        let t332_k = t331_k - t318_k;
        let t333_k = t332_k - t321_k;
        let t334_k = t333_k - t324_k;
        let t335_k = t334_k - t325_k;
        let t336_k = t335_k - t326_k;
        let t337_k = t336_k - t327_k;
        let t338_k = t337_k - t328_k;
        let t339_k = sin_chain_theta_7_k * R::literal(39.24);
        let t340_k = -t21_k;
        let t341_k = t209_k * R::literal(4.0);
        let t342_k = sums_17[4] + t341 * t340_k + t341_k * t340;
        let t343_k = -t52_k;
        let t344_k = t172_k * R::literal(4.0);
        let t345_k = sums_17[5] + t344 * t343_k + t344_k * t343;
        let t346_k = -t79_k;
        let t347_k = t175_k * R::literal(4.0);
        let t348_k = sums_17[6] + t347 * t346_k + t347_k * t346;
        let t349_k = -t102_k;
        let t350_k = t178_k * R::literal(4.0);
        let t351_k = sums_17[7] + t350 * t349_k + t350_k * t349;
        let t352_k = -t121_k;
        let t353_k = t181_k * R::literal(4.0);
        let t354_k = sums_17[8] + t353 * t352_k + t353_k * t352;
        let t355_k = -t136_k;
        let t356_k = t184_k * R::literal(4.0);
        let t357_k = sums_17[9] + t356 * t355_k + t356_k * t355;
        let t358_k = sums_18[0] + t191 * t151_k + t191_k * t151;
        let t359_k = sums_18[1] + t194 * t155_k + t194_k * t155;
        let t360_k = sums_18[2] + t196 * t159_k + t196_k * t159;
        let t361_k = -t339_k;
        let t362_k = t361_k - t342_k;
        let t363_k = t362_k - t345_k;
        let t364_k = t363_k - t348_k;
        let t365_k = t364_k - t351_k;
        let t366_k = t365_k - t354_k;
        let t367_k = t366_k - t357_k;
        let t368_k = t367_k - t358_k;
        let t369_k = t368_k - t359_k;
        let t370_k = t369_k - t360_k;
        let t371_k = sin_chain_theta_8_k * R::literal(29.43);
        let t372_k = -t25_k;
        let t373_k = t209_k * R::literal(3.0);
        let t374_k = sums_18[3] + t373 * t372_k + t373_k * t372;
        let t375_k = -t56_k;
        let t376_k = t172_k * R::literal(3.0);
        let t377_k = sums_18[4] + t376 * t375_k + t376_k * t375;
        let t378_k = -t83_k;
        let t379_k = t175_k * R::literal(3.0);
        let t380_k = sums_18[5] + t379 * t378_k + t379_k * t378;
        let t381_k = -t106_k;
        let t382_k = t178_k * R::literal(3.0);
        let t383_k = sums_18[6] + t382 * t381_k + t382_k * t381;
        let t384_k = -t125_k;
        let t385_k = t181_k * R::literal(3.0);
        let t386_k = sums_18[7] + t385 * t384_k + t385_k * t384;
        let t387_k = -t140_k;
        let t388_k = t184_k * R::literal(3.0);
        let t389_k = sums_18[8] + t388 * t387_k + t388_k * t387;
        let t390_k = -t151_k;
        let t391_k = t187_k * R::literal(3.0);
        let t392_k = sums_18[9] + t391 * t390_k + t391_k * t390;
        let t393_k = sums_19[0] + t194 * t162_k + t194_k * t162;
        let t394_k = sums_19[1] + t196 * t166_k + t196_k * t166;
        let t395_k = -t371_k;
        let t396_k = t395_k - t374_k;
        let t397_k = t396_k - t377_k;
        let t398_k = t397_k - t380_k;
        let t399_k = t398_k - t383_k;
        let t400_k = t399_k - t386_k;
        let t401_k = t400_k - t389_k;
        let t402_k = t401_k - t392_k;
        let t403_k = t402_k - t393_k;
        let t404_k = t403_k - t394_k;
        let t405_k = sin_chain_theta_9_k * R::literal(19.62);
        let t406_k = -t29_k;
        let t407_k = t209_k * R::literal(2.0);
        let t408_k = sums_19[2] + t407 * t406_k + t407_k * t406;
        let t409_k = -t60_k;
        let t410_k = t172_k * R::literal(2.0);
        let t411_k = sums_19[3] + t410 * t409_k + t410_k * t409;
        let t412_k = -t87_k;
        let t413_k = t175_k * R::literal(2.0);
        let t414_k = sums_19[4] + t413 * t412_k + t413_k * t412;
        let t415_k = -t110_k;
        let t416_k = t178_k * R::literal(2.0);
        let t417_k = sums_19[5] + t416 * t415_k + t416_k * t415;
        let t418_k = -t129_k;
        let t419_k = t181_k * R::literal(2.0);
        let t420_k = sums_19[6] + t419 * t418_k + t419_k * t418;
        let t421_k = -t144_k;
        let t422_k = t184_k * R::literal(2.0);
        let t423_k = sums_19[7] + t422 * t421_k + t422_k * t421;
        let t424_k = -t155_k;
        let t425_k = t187_k * R::literal(2.0);
        let t426_k = sums_19[8] + t425 * t424_k + t425_k * t424;
        let t427_k = -t162_k;
        let t428_k = t190_k * R::literal(2.0);
        let t429_k = sums_19[9] + t428 * t427_k + t428_k * t427;
        let t430_k = sums_20[0] + t196 * t169_k + t196_k * t169;
        let t431_k = -t405_k;
        let t432_k = t431_k - t408_k;
        let t433_k = t432_k - t411_k;
        let t434_k = t433_k - t414_k;
        let t435_k = t434_k - t417_k;
        let t436_k = t435_k - t420_k;
        let t437_k = t436_k - t423_k;
        let t438_k = t437_k - t426_k;
        let t439_k = t438_k - t429_k;
        let t440_k = t439_k - t430_k;
        let t441_k = sin_chain_theta_10_k * R::literal(9.81);
        let t442_k = -t33_k;
        let t443_k = sums_20[1] + t209 * t442_k + t209_k * t442;
        let t444_k = -t64_k;
        let t445_k = sums_20[2] + t172 * t444_k + t172_k * t444;
        let t446_k = -t91_k;
        let t447_k = sums_20[3] + t175 * t446_k + t175_k * t446;
        let t448_k = -t114_k;
        let t449_k = sums_20[4] + t178 * t448_k + t178_k * t448;
        let t450_k = -t133_k;
        let t451_k = sums_20[5] + t181 * t450_k + t181_k * t450;
        let t452_k = -t148_k;
        let t453_k = sums_20[6] + t184 * t452_k + t184_k * t452;
        let t454_k = -t159_k;
        let t455_k = sums_20[7] + t187 * t454_k + t187_k * t454;
        let t456_k = -t166_k;
        let t457_k = sums_20[8] + t190 * t456_k + t190_k * t456;
        let t458_k = -t169_k;
        let t459_k = sums_20[9] + t193 * t458_k + t193_k * t458;
        let t460_k = -t441_k;
        let t461_k = t460_k - t443_k;
        let t462_k = t461_k - t445_k;
        let t463_k = t462_k - t447_k;
        let t464_k = t463_k - t449_k;
        let t465_k = t464_k - t451_k;
        let t466_k = t465_k - t453_k;
        let t467_k = t466_k - t455_k;
        let t468_k = t467_k - t457_k;
        let t469_k = t468_k - t459_k;
        let n540_k = sums_21[0] + t3_k * chain_omega_2_dot;
        let n541_k = sums_21[1] + t7_k * chain_omega_3_dot;
        let n542_k = sums_21[2] + t11_k * chain_omega_4_dot;
        let n543_k = sums_21[3] + t15_k * chain_omega_5_dot;
        let n544_k = sums_21[4] + t19_k * chain_omega_6_dot;
        let n545_k = sums_21[5] + t23_k * chain_omega_7_dot;
        let n546_k = sums_21[6] + t27_k * chain_omega_8_dot;
        let n547_k = sums_21[7] + t31_k * chain_omega_9_dot;
        let n548_k = sums_21[8] + t34_k * chain_omega_10_dot;
        let n549_k = sums_21[9] + t3_k * chain_omega_1_dot;
        let n550_k = sums_22[0] + t38_k * chain_omega_3_dot;
        let n551_k = sums_22[1] + t42_k * chain_omega_4_dot;
        let n552_k = sums_22[2] + t46_k * chain_omega_5_dot;
        let n553_k = sums_22[3] + t50_k * chain_omega_6_dot;
        let n554_k = sums_22[4] + t54_k * chain_omega_7_dot;
        let n555_k = sums_22[5] + t58_k * chain_omega_8_dot;
        let n556_k = sums_22[6] + t62_k * chain_omega_9_dot;
        let n557_k = sums_22[7] + t65_k * chain_omega_10_dot;
        let n558_k = sums_22[8] + t7_k * chain_omega_1_dot;
        let n559_k = sums_22[9] + t38_k * chain_omega_2_dot;
        let n560_k = sums_23[0] + t69_k * chain_omega_4_dot;
        let n561_k = sums_23[1] + t73_k * chain_omega_5_dot;
        let n562_k = sums_23[2] + t77_k * chain_omega_6_dot;
        let n563_k = sums_23[3] + t81_k * chain_omega_7_dot;
        let n564_k = sums_23[4] + t85_k * chain_omega_8_dot;
        let n565_k = sums_23[5] + t89_k * chain_omega_9_dot;
        let n566_k = sums_23[6] + t92_k * chain_omega_10_dot;
        let n567_k = sums_23[7] + t11_k * chain_omega_1_dot;
        let n568_k = sums_23[8] + t42_k * chain_omega_2_dot;
        let n569_k = sums_23[9] + t69_k * chain_omega_3_dot;
        let n570_k = sums_24[0] + t96_k * chain_omega_5_dot;
        let n571_k = sums_24[1] + t100_k * chain_omega_6_dot;
        let n572_k = sums_24[2] + t104_k * chain_omega_7_dot;
        let n573_k = sums_24[3] + t108_k * chain_omega_8_dot;
        let n574_k = sums_24[4] + t112_k * chain_omega_9_dot;
        let n575_k = sums_24[5] + t115_k * chain_omega_10_dot;
        let n576_k = sums_24[6] + t15_k * chain_omega_1_dot;
        let n577_k = sums_24[7] + t46_k * chain_omega_2_dot;
        let n578_k = sums_24[8] + t73_k * chain_omega_3_dot;
        let n579_k = sums_24[9] + t96_k * chain_omega_4_dot;
        let n580_k = sums_25[0] + t119_k * chain_omega_6_dot;
        let n581_k = sums_25[1] + t123_k * chain_omega_7_dot;
        let n582_k = sums_25[2] + t127_k * chain_omega_8_dot;
        let n583_k = sums_25[3] + t131_k * chain_omega_9_dot;
        let n584_k = sums_25[4] + t134_k * chain_omega_10_dot;
        let n585_k = sums_25[5] + t19_k * chain_omega_1_dot;
        let n586_k = sums_25[6] + t50_k * chain_omega_2_dot;
        let n587_k = sums_25[7] + t77_k * chain_omega_3_dot;
        let n588_k = sums_25[8] + t100_k * chain_omega_4_dot;
        let n589_k = sums_25[9] + t119_k * chain_omega_5_dot;
        let n590_k = sums_26[0] + t138_k * chain_omega_7_dot;
        let n591_k = sums_26[1] + t142_k * chain_omega_8_dot;
        let n592_k = sums_26[2] + t146_k * chain_omega_9_dot;
        let n593_k = sums_26[3] + t149_k * chain_omega_10_dot;
        let n594_k = sums_26[4] + t23_k * chain_omega_1_dot;
        let n595_k = sums_26[5] + t54_k * chain_omega_2_dot;
        let n596_k = sums_26[6] + t81_k * chain_omega_3_dot;
        let n597_k = sums_26[7] + t104_k * chain_omega_4_dot;
        let n598_k = sums_26[8] + t123_k * chain_omega_5_dot;
        let n599_k = sums_26[9] + t138_k * chain_omega_6_dot;
        let n600_k = sums_27[0] + t153_k * chain_omega_8_dot;
        let n601_k = sums_27[1] + t157_k * chain_omega_9_dot;
        let n602_k = sums_27[2] + t160_k * chain_omega_10_dot;
        let n603_k = sums_27[3] + t27_k * chain_omega_1_dot;
        let n604_k = sums_27[4] + t58_k * chain_omega_2_dot;
        let n605_k = sums_27[5] + t85_k * chain_omega_3_dot;
        let n606_k = sums_27[6] + t108_k * chain_omega_4_dot;
        let n607_k = sums_27[7] + t127_k * chain_omega_5_dot;
        let n608_k = sums_27[8] + t142_k * chain_omega_6_dot;
        let n609_k = sums_27[9] + t153_k * chain_omega_7_dot;
        let n610_k = sums_28[0] + t164_k * chain_omega_9_dot;
        let n611_k = sums_28[1] + t167_k * chain_omega_10_dot;
        let n612_k = sums_28[2] + t31_k * chain_omega_1_dot;
        let n613_k = sums_28[3] + t62_k * chain_omega_2_dot;
        let n614_k = sums_28[4] + t89_k * chain_omega_3_dot;
        let n615_k = sums_28[5] + t112_k * chain_omega_4_dot;
        let n616_k = sums_28[6] + t131_k * chain_omega_5_dot;
        let n617_k = sums_28[7] + t146_k * chain_omega_6_dot;
        let n618_k = sums_28[8] + t157_k * chain_omega_7_dot;
        let n619_k = sums_28[9] + t164_k * chain_omega_8_dot;
        let n620_k = sums_29[0] + t170_k * chain_omega_10_dot;
        let n621_k = sums_29[1] + t34_k * chain_omega_1_dot;
        let n622_k = sums_29[2] + t65_k * chain_omega_2_dot;
        let n623_k = sums_29[3] + t92_k * chain_omega_3_dot;
        let n624_k = sums_29[4] + t115_k * chain_omega_4_dot;
        let n625_k = sums_29[5] + t134_k * chain_omega_5_dot;
        let n626_k = sums_29[6] + t149_k * chain_omega_6_dot;
        let n627_k = sums_29[7] + t160_k * chain_omega_7_dot;
        let n628_k = sums_29[8] + t167_k * chain_omega_8_dot;
        let n629_k = sums_29[9] + t170_k * chain_omega_9_dot;
        let n630_k = n540_k + n541_k;
        let n631_k = n542_k + n543_k;
        let n632_k = n630_k + n631_k;
        let n633_k = n544_k + n545_k;
        let n634_k = n547_k + n548_k;
        let n635_k = n546_k + n634_k;
        let n636_k = n633_k + n635_k;
        let n637_k = n632_k + n636_k;
        let t207_k_2 = t207_k - n637_k;
        let n639_k = n549_k + n550_k;
        let n640_k = n551_k + n552_k;
        let n641_k = n639_k + n640_k;
        let n642_k = n553_k + n554_k;
        let n643_k = n556_k + n557_k;
        let n644_k = n555_k + n643_k;
        let n645_k = n642_k + n644_k;
        let n646_k = n641_k + n645_k;
        let t230_k_2 = t230_k - n646_k;
        let n648_k = n558_k + n559_k;
        let n649_k = n560_k + n561_k;
        let n650_k = n648_k + n649_k;
        let n651_k = n562_k + n563_k;
        let n652_k = n565_k + n566_k;
        let n653_k = n564_k + n652_k;
        let n654_k = n651_k + n653_k;
        let n655_k = n650_k + n654_k;
        let t254_k_2 = t254_k - n655_k;
        let n657_k = n567_k + n568_k;
        let n658_k = n569_k + n570_k;
        let n659_k = n657_k + n658_k;
        let n660_k = n571_k + n572_k;
        let n661_k = n574_k + n575_k;
        let n662_k = n573_k + n661_k;
        let n663_k = n660_k + n662_k;
        let n664_k = n659_k + n663_k;
        let t280_k_2 = t280_k - n664_k;
        let n666_k = n576_k + n577_k;
        let n667_k = n578_k + n579_k;
        let n668_k = n666_k + n667_k;
        let n669_k = n580_k + n581_k;
        let n670_k = n583_k + n584_k;
        let n671_k = n582_k + n670_k;
        let n672_k = n669_k + n671_k;
        let n673_k = n668_k + n672_k;
        let t308_k_2 = t308_k - n673_k;
        let n675_k = n585_k + n586_k;
        let n676_k = n587_k + n588_k;
        let n677_k = n675_k + n676_k;
        let n678_k = n589_k + n590_k;
        let n679_k = n592_k + n593_k;
        let n680_k = n591_k + n679_k;
        let n681_k = n678_k + n680_k;
        let n682_k = n677_k + n681_k;
        let t338_k_2 = t338_k - n682_k;
        let n684_k = n594_k + n595_k;
        let n685_k = n596_k + n597_k;
        let n686_k = n684_k + n685_k;
        let n687_k = n598_k + n599_k;
        let n688_k = n601_k + n602_k;
        let n689_k = n600_k + n688_k;
        let n690_k = n687_k + n689_k;
        let n691_k = n686_k + n690_k;
        let t370_k_2 = t370_k - n691_k;
        let n693_k = n603_k + n604_k;
        let n694_k = n605_k + n606_k;
        let n695_k = n693_k + n694_k;
        let n696_k = n607_k + n608_k;
        let n697_k = n610_k + n611_k;
        let n698_k = n609_k + n697_k;
        let n699_k = n696_k + n698_k;
        let n700_k = n695_k + n699_k;
        let t404_k_2 = t404_k - n700_k;
        let n702_k = n612_k + n613_k;
        let n703_k = n614_k + n615_k;
        let n704_k = n702_k + n703_k;
        let n705_k = n616_k + n617_k;
        let n706_k = n619_k + n620_k;
        let n707_k = n618_k + n706_k;
        let n708_k = n705_k + n707_k;
        let n709_k = n704_k + n708_k;
        let t440_k_2 = t440_k - n709_k;
        let n711_k = n621_k + n622_k;
        let n712_k = n623_k + n624_k;
        let n713_k = n711_k + n712_k;
        let n714_k = n625_k + n626_k;
        let n715_k = n628_k + n629_k;
        let n716_k = n627_k + n715_k;
        let n717_k = n714_k + n716_k;
        let n718_k = n713_k + n717_k;
        let t469_k_2 = t469_k - n718_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k,
        chain_omega_4_dot_k, chain_omega_5_dot_k, chain_omega_6_dot_k,
        chain_omega_7_dot_k, chain_omega_8_dot_k, chain_omega_9_dot_k,
        chain_omega_10_dot_k] = factored
            .solve([
                t207_k_2,
                t230_k_2,
                t254_k_2,
                t280_k_2,
                t308_k_2,
                t338_k_2,
                t370_k_2,
                t404_k_2,
                t440_k_2,
                t469_k_2,
            ]);
        lanes
            .set(
                order,
                [
                    k * t0_k,
                    k * t0_k,
                    k * t4_k,
                    k * t4_k,
                    k * t8_k,
                    k * t8_k,
                    k * t12_k,
                    k * t12_k,
                    k * t16_k,
                    k * t16_k,
                ],
                [t2_k, t1_k, t6_k, t5_k, t10_k, t9_k, t14_k, t13_k, t18_k, t17_k],
            );
        lanes_1
            .set(
                order,
                [
                    k * t20_k,
                    k * t20_k,
                    k * t24_k,
                    k * t24_k,
                    k * t28_k,
                    k * t28_k,
                    k * t32_k,
                    k * t32_k,
                    k * t35_k,
                    k * t35_k,
                ],
                [t22_k, t21_k, t26_k, t25_k, t30_k, t29_k, t34_k, t33_k, t37_k, t36_k],
            );
        lanes_2
            .set(
                order,
                [
                    k * t39_k,
                    k * t39_k,
                    k * t43_k,
                    k * t43_k,
                    k * t47_k,
                    k * t47_k,
                    k * t51_k,
                    k * t51_k,
                    k * t55_k,
                    k * t55_k,
                ],
                [t41_k, t40_k, t45_k, t44_k, t49_k, t48_k, t53_k, t52_k, t57_k, t56_k],
            );
        lanes_3
            .set(
                order,
                [
                    k * t59_k,
                    k * t59_k,
                    k * t63_k,
                    k * t63_k,
                    k * t66_k,
                    k * t66_k,
                    k * t70_k,
                    k * t70_k,
                    k * t74_k,
                    k * t74_k,
                ],
                [t61_k, t60_k, t65_k, t64_k, t68_k, t67_k, t72_k, t71_k, t76_k, t75_k],
            );
        lanes_4
            .set(
                order,
                [
                    k * t78_k,
                    k * t78_k,
                    k * t82_k,
                    k * t82_k,
                    k * t86_k,
                    k * t86_k,
                    k * t90_k,
                    k * t90_k,
                    k * t93_k,
                    k * t93_k,
                ],
                [t80_k, t79_k, t84_k, t83_k, t88_k, t87_k, t92_k, t91_k, t95_k, t94_k],
            );
        lanes_5
            .set(
                order,
                [
                    k * t97_k,
                    k * t97_k,
                    k * t101_k,
                    k * t101_k,
                    k * t105_k,
                    k * t105_k,
                    k * t109_k,
                    k * t109_k,
                    k * t113_k,
                    k * t113_k,
                ],
                [
                    t99_k,
                    t98_k,
                    t103_k,
                    t102_k,
                    t107_k,
                    t106_k,
                    t111_k,
                    t110_k,
                    t115_k,
                    t114_k,
                ],
            );
        lanes_6
            .set(
                order,
                [
                    k * t116_k,
                    k * t116_k,
                    k * t120_k,
                    k * t120_k,
                    k * t124_k,
                    k * t124_k,
                    k * t128_k,
                    k * t128_k,
                    k * t132_k,
                    k * t132_k,
                ],
                [
                    t118_k,
                    t117_k,
                    t122_k,
                    t121_k,
                    t126_k,
                    t125_k,
                    t130_k,
                    t129_k,
                    t134_k,
                    t133_k,
                ],
            );
        lanes_7
            .set(
                order,
                [
                    k * t135_k,
                    k * t135_k,
                    k * t139_k,
                    k * t139_k,
                    k * t143_k,
                    k * t143_k,
                    k * t147_k,
                    k * t147_k,
                    k * t150_k,
                    k * t150_k,
                ],
                [
                    t137_k,
                    t136_k,
                    t141_k,
                    t140_k,
                    t145_k,
                    t144_k,
                    t149_k,
                    t148_k,
                    t152_k,
                    t151_k,
                ],
            );
        lanes_8
            .set(
                order,
                [
                    k * t154_k,
                    k * t154_k,
                    k * t158_k,
                    k * t158_k,
                    k * t161_k,
                    k * t161_k,
                    k * t165_k,
                    k * t165_k,
                    k * t168_k,
                    k * t168_k,
                ],
                [
                    t156_k,
                    t155_k,
                    t160_k,
                    t159_k,
                    t163_k,
                    t162_k,
                    t167_k,
                    t166_k,
                    t170_k,
                    t169_k,
                ],
            );
        lanes_9
            .set(
                order,
                [
                    k * chain_theta_1_k,
                    k * chain_theta_1_k,
                    k * chain_theta_2_k,
                    k * chain_theta_2_k,
                    k * chain_theta_3_k,
                    k * chain_theta_3_k,
                    k * chain_theta_4_k,
                    k * chain_theta_4_k,
                    k * chain_theta_5_k,
                    k * chain_theta_5_k,
                ],
                [
                    cos_chain_theta_1_k,
                    sin_chain_theta_1_k,
                    cos_chain_theta_2_k,
                    sin_chain_theta_2_k,
                    cos_chain_theta_3_k,
                    sin_chain_theta_3_k,
                    cos_chain_theta_4_k,
                    sin_chain_theta_4_k,
                    cos_chain_theta_5_k,
                    sin_chain_theta_5_k,
                ],
            );
        lanes_10
            .set(
                order,
                [
                    k * chain_theta_6_k,
                    k * chain_theta_6_k,
                    k * chain_theta_7_k,
                    k * chain_theta_7_k,
                    k * chain_theta_8_k,
                    k * chain_theta_8_k,
                    k * chain_theta_9_k,
                    k * chain_theta_9_k,
                    k * chain_theta_10_k,
                    k * chain_theta_10_k,
                ],
                [
                    cos_chain_theta_6_k,
                    sin_chain_theta_6_k,
                    cos_chain_theta_7_k,
                    sin_chain_theta_7_k,
                    cos_chain_theta_8_k,
                    sin_chain_theta_8_k,
                    cos_chain_theta_9_k,
                    sin_chain_theta_9_k,
                    cos_chain_theta_10_k,
                    sin_chain_theta_10_k,
                ],
            );
        lanes_11
            .set(
                order,
                [
                    chain_omega_2_k,
                    t1_k,
                    chain_omega_3_k,
                    t5_k,
                    chain_omega_4_k,
                    t9_k,
                    chain_omega_5_k,
                    t13_k,
                    chain_omega_6_k,
                    t17_k,
                ],
                [
                    chain_omega_2_k,
                    t173_k,
                    chain_omega_3_k,
                    t176_k,
                    chain_omega_4_k,
                    t179_k,
                    chain_omega_5_k,
                    t182_k,
                    chain_omega_6_k,
                    t185_k,
                ],
            );
        lanes_12
            .set(
                order,
                [
                    chain_omega_7_k,
                    t21_k,
                    chain_omega_8_k,
                    t25_k,
                    chain_omega_9_k,
                    t29_k,
                    chain_omega_10_k,
                    t33_k,
                    chain_omega_1_k,
                    t210_k,
                ],
                [
                    chain_omega_7_k,
                    t188_k,
                    chain_omega_8_k,
                    t191_k,
                    chain_omega_9_k,
                    t194_k,
                    chain_omega_10_k,
                    t196_k,
                    chain_omega_1_k,
                    t211_k,
                ],
            );
        lanes_13
            .set(
                order,
                [t36_k, t40_k, t44_k, t48_k, t52_k, t56_k, t60_k, t64_k, t232_k, t235_k],
                [
                    t176_k,
                    t179_k,
                    t182_k,
                    t185_k,
                    t188_k,
                    t191_k,
                    t194_k,
                    t196_k,
                    t233_k,
                    t236_k,
                ],
            );
        lanes_14
            .set(
                order,
                [
                    t67_k,
                    t71_k,
                    t75_k,
                    t79_k,
                    t83_k,
                    t87_k,
                    t91_k,
                    t256_k,
                    t259_k,
                    t262_k,
                ],
                [
                    t179_k,
                    t182_k,
                    t185_k,
                    t188_k,
                    t191_k,
                    t194_k,
                    t196_k,
                    t257_k,
                    t260_k,
                    t263_k,
                ],
            );
        lanes_15
            .set(
                order,
                [
                    t94_k,
                    t98_k,
                    t102_k,
                    t106_k,
                    t110_k,
                    t114_k,
                    t282_k,
                    t285_k,
                    t288_k,
                    t291_k,
                ],
                [
                    t182_k,
                    t185_k,
                    t188_k,
                    t191_k,
                    t194_k,
                    t196_k,
                    t283_k,
                    t286_k,
                    t289_k,
                    t292_k,
                ],
            );
        lanes_16
            .set(
                order,
                [
                    t117_k,
                    t121_k,
                    t125_k,
                    t129_k,
                    t133_k,
                    t310_k,
                    t313_k,
                    t316_k,
                    t319_k,
                    t322_k,
                ],
                [
                    t185_k,
                    t188_k,
                    t191_k,
                    t194_k,
                    t196_k,
                    t311_k,
                    t314_k,
                    t317_k,
                    t320_k,
                    t323_k,
                ],
            );
        lanes_17
            .set(
                order,
                [
                    t136_k,
                    t140_k,
                    t144_k,
                    t148_k,
                    t340_k,
                    t343_k,
                    t346_k,
                    t349_k,
                    t352_k,
                    t355_k,
                ],
                [
                    t188_k,
                    t191_k,
                    t194_k,
                    t196_k,
                    t341_k,
                    t344_k,
                    t347_k,
                    t350_k,
                    t353_k,
                    t356_k,
                ],
            );
        lanes_18
            .set(
                order,
                [
                    t151_k,
                    t155_k,
                    t159_k,
                    t372_k,
                    t375_k,
                    t378_k,
                    t381_k,
                    t384_k,
                    t387_k,
                    t390_k,
                ],
                [
                    t191_k,
                    t194_k,
                    t196_k,
                    t373_k,
                    t376_k,
                    t379_k,
                    t382_k,
                    t385_k,
                    t388_k,
                    t391_k,
                ],
            );
        lanes_19
            .set(
                order,
                [
                    t162_k,
                    t166_k,
                    t406_k,
                    t409_k,
                    t412_k,
                    t415_k,
                    t418_k,
                    t421_k,
                    t424_k,
                    t427_k,
                ],
                [
                    t194_k,
                    t196_k,
                    t407_k,
                    t410_k,
                    t413_k,
                    t416_k,
                    t419_k,
                    t422_k,
                    t425_k,
                    t428_k,
                ],
            );
        lanes_20
            .set(
                order,
                [
                    t169_k,
                    t209_k,
                    t172_k,
                    t175_k,
                    t178_k,
                    t181_k,
                    t184_k,
                    t187_k,
                    t190_k,
                    t193_k,
                ],
                [
                    t196_k,
                    t442_k,
                    t444_k,
                    t446_k,
                    t448_k,
                    t450_k,
                    t452_k,
                    t454_k,
                    t456_k,
                    t458_k,
                ],
            );
        lanes_21
            .set(
                order,
                [t3_k, t7_k, t11_k, t15_k, t19_k, t23_k, t27_k, t31_k, t34_k, t3_k],
                [
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_22
            .set(
                order,
                [t38_k, t42_k, t46_k, t50_k, t54_k, t58_k, t62_k, t65_k, t7_k, t38_k],
                [
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                ],
            );
        lanes_23
            .set(
                order,
                [t69_k, t73_k, t77_k, t81_k, t85_k, t89_k, t92_k, t11_k, t42_k, t69_k],
                [
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                ],
            );
        lanes_24
            .set(
                order,
                [
                    t96_k,
                    t100_k,
                    t104_k,
                    t108_k,
                    t112_k,
                    t115_k,
                    t15_k,
                    t46_k,
                    t73_k,
                    t96_k,
                ],
                [
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                ],
            );
        lanes_25
            .set(
                order,
                [
                    t119_k,
                    t123_k,
                    t127_k,
                    t131_k,
                    t134_k,
                    t19_k,
                    t50_k,
                    t77_k,
                    t100_k,
                    t119_k,
                ],
                [
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                ],
            );
        lanes_26
            .set(
                order,
                [
                    t138_k,
                    t142_k,
                    t146_k,
                    t149_k,
                    t23_k,
                    t54_k,
                    t81_k,
                    t104_k,
                    t123_k,
                    t138_k,
                ],
                [
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                ],
            );
        lanes_27
            .set(
                order,
                [
                    t153_k,
                    t157_k,
                    t160_k,
                    t27_k,
                    t58_k,
                    t85_k,
                    t108_k,
                    t127_k,
                    t142_k,
                    t153_k,
                ],
                [
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                ],
            );
        lanes_28
            .set(
                order,
                [
                    t164_k,
                    t167_k,
                    t31_k,
                    t62_k,
                    t89_k,
                    t112_k,
                    t131_k,
                    t146_k,
                    t157_k,
                    t164_k,
                ],
                [
                    chain_omega_9_dot_k,
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                ],
            );
        lanes_29
            .set(
                order,
                [
                    t170_k,
                    t34_k,
                    t65_k,
                    t92_k,
                    t115_k,
                    t134_k,
                    t149_k,
                    t160_k,
                    t167_k,
                    t170_k,
                ],
                [
                    chain_omega_10_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_6_dot_k,
                    chain_omega_7_dot_k,
                    chain_omega_8_dot_k,
                    chain_omega_9_dot_k,
                ],
            );
        rates = [
            chain_omega_1_k,
            chain_omega_2_k,
            chain_omega_3_k,
            chain_omega_4_k,
            chain_omega_5_k,
            chain_omega_6_k,
            chain_omega_7_k,
            chain_omega_8_k,
            chain_omega_9_k,
            chain_omega_10_k,
            chain_omega_1_dot_k,
            chain_omega_2_dot_k,
            chain_omega_3_dot_k,
            chain_omega_4_dot_k,
            chain_omega_5_dot_k,
            chain_omega_6_dot_k,
            chain_omega_7_dot_k,
            chain_omega_8_dot_k,
            chain_omega_9_dot_k,
            chain_omega_10_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M610 {
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

impl Describe for M610 {
    fn name(&self) -> &'static str {
        "m6_10"
    }
    fn title(&self) -> &'static str {
        "Benchmark M6: planar pendulum of 10 links"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 10,
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

impl<R: Real> Simulator<R> for M610 {
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
        name: "chain.theta_1",
        unit: "rad",
        doc: "angle of link 1 from the vertical",
    },
    Quantity {
        name: "chain.theta_2",
        unit: "rad",
        doc: "angle of link 2 from the vertical",
    },
    Quantity {
        name: "chain.theta_3",
        unit: "rad",
        doc: "angle of link 3 from the vertical",
    },
    Quantity {
        name: "chain.theta_4",
        unit: "rad",
        doc: "angle of link 4 from the vertical",
    },
    Quantity {
        name: "chain.theta_5",
        unit: "rad",
        doc: "angle of link 5 from the vertical",
    },
    Quantity {
        name: "chain.theta_6",
        unit: "rad",
        doc: "angle of link 6 from the vertical",
    },
    Quantity {
        name: "chain.theta_7",
        unit: "rad",
        doc: "angle of link 7 from the vertical",
    },
    Quantity {
        name: "chain.theta_8",
        unit: "rad",
        doc: "angle of link 8 from the vertical",
    },
    Quantity {
        name: "chain.theta_9",
        unit: "rad",
        doc: "angle of link 9 from the vertical",
    },
    Quantity {
        name: "chain.theta_10",
        unit: "rad",
        doc: "angle of link 10 from the vertical",
    },
    Quantity {
        name: "chain.omega_1",
        unit: "rad/s",
        doc: "rate of angle of link 1 from the vertical",
    },
    Quantity {
        name: "chain.omega_2",
        unit: "rad/s",
        doc: "rate of angle of link 2 from the vertical",
    },
    Quantity {
        name: "chain.omega_3",
        unit: "rad/s",
        doc: "rate of angle of link 3 from the vertical",
    },
    Quantity {
        name: "chain.omega_4",
        unit: "rad/s",
        doc: "rate of angle of link 4 from the vertical",
    },
    Quantity {
        name: "chain.omega_5",
        unit: "rad/s",
        doc: "rate of angle of link 5 from the vertical",
    },
    Quantity {
        name: "chain.omega_6",
        unit: "rad/s",
        doc: "rate of angle of link 6 from the vertical",
    },
    Quantity {
        name: "chain.omega_7",
        unit: "rad/s",
        doc: "rate of angle of link 7 from the vertical",
    },
    Quantity {
        name: "chain.omega_8",
        unit: "rad/s",
        doc: "rate of angle of link 8 from the vertical",
    },
    Quantity {
        name: "chain.omega_9",
        unit: "rad/s",
        doc: "rate of angle of link 9 from the vertical",
    },
    Quantity {
        name: "chain.omega_10",
        unit: "rad/s",
        doc: "rate of angle of link 10 from the vertical",
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
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
    5.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "theta_1",
        unit: "rad",
        doc: "angle of link 1 from the vertical",
    },
    Quantity {
        name: "theta_2",
        unit: "rad",
        doc: "angle of link 2 from the vertical",
    },
    Quantity {
        name: "theta_3",
        unit: "rad",
        doc: "angle of link 3 from the vertical",
    },
    Quantity {
        name: "theta_4",
        unit: "rad",
        doc: "angle of link 4 from the vertical",
    },
    Quantity {
        name: "theta_5",
        unit: "rad",
        doc: "angle of link 5 from the vertical",
    },
    Quantity {
        name: "theta_6",
        unit: "rad",
        doc: "angle of link 6 from the vertical",
    },
    Quantity {
        name: "theta_7",
        unit: "rad",
        doc: "angle of link 7 from the vertical",
    },
    Quantity {
        name: "theta_8",
        unit: "rad",
        doc: "angle of link 8 from the vertical",
    },
    Quantity {
        name: "theta_9",
        unit: "rad",
        doc: "angle of link 9 from the vertical",
    },
    Quantity {
        name: "theta_10",
        unit: "rad",
        doc: "angle of link 10 from the vertical",
    },
    Quantity {
        name: "omega_1",
        unit: "rad/s",
        doc: "rate of angle of link 1 from the vertical",
    },
    Quantity {
        name: "omega_2",
        unit: "rad/s",
        doc: "rate of angle of link 2 from the vertical",
    },
    Quantity {
        name: "omega_3",
        unit: "rad/s",
        doc: "rate of angle of link 3 from the vertical",
    },
    Quantity {
        name: "omega_4",
        unit: "rad/s",
        doc: "rate of angle of link 4 from the vertical",
    },
    Quantity {
        name: "omega_5",
        unit: "rad/s",
        doc: "rate of angle of link 5 from the vertical",
    },
    Quantity {
        name: "omega_6",
        unit: "rad/s",
        doc: "rate of angle of link 6 from the vertical",
    },
    Quantity {
        name: "omega_7",
        unit: "rad/s",
        doc: "rate of angle of link 7 from the vertical",
    },
    Quantity {
        name: "omega_8",
        unit: "rad/s",
        doc: "rate of angle of link 8 from the vertical",
    },
    Quantity {
        name: "omega_9",
        unit: "rad/s",
        doc: "rate of angle of link 9 from the vertical",
    },
    Quantity {
        name: "omega_10",
        unit: "rad/s",
        doc: "rate of angle of link 10 from the vertical",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   d39c80783dc5ff7e561aa73abbd9fd2d18960c4b83666920e978777a5061c01a  bench/m6_5.toml
//
// Benchmark M6: planar pendulum of 5 links
//
// Point masses on 5 massless links, angles from the downward vertical, released
// horizontal and at rest.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               5
//   first-order states        0
//   states                   10
//   parameters                0
//   outputs                  10
//   discontinuities           0
//
// State:
//     0  chain.theta_1  [rad]    angle of link 1 from the vertical
//     1  chain.theta_2  [rad]    angle of link 2 from the vertical
//     2  chain.theta_3  [rad]    angle of link 3 from the vertical
//     3  chain.theta_4  [rad]    angle of link 4 from the vertical
//     4  chain.theta_5  [rad]    angle of link 5 from the vertical
//     5  chain.omega_1  [rad/s]  rate of angle of link 1 from the vertical
//     6  chain.omega_2  [rad/s]  rate of angle of link 2 from the vertical
//     7  chain.omega_3  [rad/s]  rate of angle of link 3 from the vertical
//     8  chain.omega_4  [rad/s]  rate of angle of link 4 from the vertical
//     9  chain.omega_5  [rad/s]  rate of angle of link 5 from the vertical
//
// Nonzeros:
//   mass_matrix              25 of 5 by 5
//   rate_jacobian            55 of 10 by 10
//   parameter_jacobian        0 of 10 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                    224
//   mass_matrix              26
//   forcing                 109
//   rate_jacobian           831
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                   58
//   power_balance           421

use crate::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, taylor::{Factored, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 5;

/// Length of the state y.
pub const STATES: usize = 10;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 10;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 5,
    columns: 5,
    entries: &[
        (0, 0),
        (0, 1),
        (0, 2),
        (0, 3),
        (0, 4),
        (1, 0),
        (1, 1),
        (1, 2),
        (1, 3),
        (1, 4),
        (2, 0),
        (2, 1),
        (2, 2),
        (2, 3),
        (2, 4),
        (3, 0),
        (3, 1),
        (3, 2),
        (3, 3),
        (3, 4),
        (4, 0),
        (4, 1),
        (4, 2),
        (4, 3),
        (4, 4),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 10,
    entries: &[
        (0, 5),
        (1, 6),
        (2, 7),
        (3, 8),
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

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 0,
    entries: &[],
};

/// Benchmark M6: planar pendulum of 5 links
///
/// Point masses on 5 massless links, angles from the downward vertical, released
/// horizontal and at rest.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M65;

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
            omega_1: values[5],
            omega_2: values[6],
            omega_3: values[7],
            omega_4: values[8],
            omega_5: values[9],
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
            self.omega_1,
            self.omega_2,
            self.omega_3,
            self.omega_4,
            self.omega_5,
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
    /// chain.omega_1: rate of angle of link 1 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_1: usize = 5;
    /// chain.omega_2: rate of angle of link 2 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_2: usize = 6;
    /// chain.omega_3: rate of angle of link 3 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_3: usize = 7;
    /// chain.omega_4: rate of angle of link 4 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_4: usize = 8;
    /// chain.omega_5: rate of angle of link 5 from the vertical \[rad/s\].
    pub const CHAIN_OMEGA_5: usize = 9;
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
/// 224 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = R::literal(4.0) * chain_theta_1_minus_chain_theta_2.cos();
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t1 = R::literal(3.0) * chain_theta_1_minus_chain_theta_3.cos();
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t2 = R::literal(2.0) * chain_theta_1_minus_chain_theta_4.cos();
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t3 = chain_theta_1_minus_chain_theta_5.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let t4 = t0 * R::literal(0.2);
    let t5 = t1 * R::literal(0.2);
    let t6 = t2 * R::literal(0.2);
    let t7 = t3 * R::literal(0.2);
    let t8 = R::literal(1.0) / (R::literal(4.0) - t4 * t0);
    let t9 = R::literal(3.0) * chain_theta_2_minus_chain_theta_3.cos() - t5 * t0;
    let t10 = t9 * t8;
    let t11 = R::literal(2.0) * chain_theta_2_minus_chain_theta_4.cos() - t6 * t0;
    let t12 = t11 * t8;
    let t13 = chain_theta_2_minus_chain_theta_5.cos() - t7 * t0;
    let t14 = t13 * t8;
    let t15 = R::literal(1.0) / (R::literal(3.0) - t5 * t1 - t10 * t9);
    let t16 = R::literal(2.0) * chain_theta_3_minus_chain_theta_4.cos() - t6 * t1
        - t12 * t9;
    let t17 = t16 * t15;
    let t18 = chain_theta_3_minus_chain_theta_5.cos() - t7 * t1 - t14 * t9;
    let t19 = t18 * t15;
    let t20 = R::literal(1.0) / (R::literal(2.0) - t6 * t2 - t12 * t11 - t17 * t16);
    let t21 = chain_theta_4_minus_chain_theta_5.cos() - t7 * t2 - t14 * t11 - t19 * t16;
    let t22 = t21 * t20;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t23 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t24 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t25 = -(R::literal(49.05) * chain_theta_1.sin())
        - R::literal(4.0) * chain_omega_2_squared
            * chain_theta_1_minus_chain_theta_2.sin()
        - t23 * chain_theta_1_minus_chain_theta_3.sin()
        - t24 * chain_theta_1_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_1_minus_chain_theta_5.sin();
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t26 = -(R::literal(39.24) * chain_theta_2.sin())
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t23 * chain_theta_2_minus_chain_theta_3.sin()
        - t24 * chain_theta_2_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_2_minus_chain_theta_5.sin() - t4 * t25;
    let t27 = -(R::literal(29.43) * chain_theta_3.sin())
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t24 * chain_theta_3_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_3_minus_chain_theta_5.sin() - t5 * t25
        - t10 * t26;
    let t28 = -(R::literal(19.62) * chain_theta_4.sin())
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - chain_omega_5_squared * chain_theta_4_minus_chain_theta_5.sin() - t6 * t25;
    let t29 = t28 - t12 * t26 - t17 * t27;
    let t30 = -(R::literal(9.81) * chain_theta_5.sin())
        - chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_5 - chain_theta_4).sin() - t7 * t25
        - t14 * t26;
    let chain_omega_5_dot = (t30 - t19 * t27 - t22 * t29)
        * (R::literal(1.0)
            / (R::literal(1.0) - t7 * t3 - t14 * t13 - t19 * t18 - t22 * t21));
    let chain_omega_4_dot = t29 * t20 - t22 * chain_omega_5_dot;
    let chain_omega_3_dot = t27 * t15 - t17 * chain_omega_4_dot
        - t19 * chain_omega_5_dot;
    let chain_omega_2_dot = t26 * t8 - t10 * chain_omega_3_dot - t12 * chain_omega_4_dot
        - t14 * chain_omega_5_dot;
    let chain_omega_1_dot = t25 * R::literal(0.2) - t4 * chain_omega_2_dot
        - t5 * chain_omega_3_dot - t6 * chain_omega_4_dot - t7 * chain_omega_5_dot;
    [
        chain_omega_1,
        chain_omega_2,
        chain_omega_3,
        chain_omega_4,
        chain_omega_5,
        chain_omega_1_dot,
        chain_omega_2_dot,
        chain_omega_3_dot,
        chain_omega_4_dot,
        chain_omega_5_dot,
    ]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 26 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 25] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5, ..,
    ] = *state;
    let t0 = R::literal(4.0) * (chain_theta_1 - chain_theta_2).cos();
    let t1 = R::literal(3.0) * (chain_theta_1 - chain_theta_3).cos();
    let t2 = R::literal(2.0) * (chain_theta_1 - chain_theta_4).cos();
    let t3 = (chain_theta_1 - chain_theta_5).cos();
    let t4 = R::literal(3.0) * (chain_theta_2 - chain_theta_3).cos();
    let t5 = R::literal(2.0) * (chain_theta_2 - chain_theta_4).cos();
    let t6 = (chain_theta_2 - chain_theta_5).cos();
    let t7 = R::literal(2.0) * (chain_theta_3 - chain_theta_4).cos();
    let t8 = (chain_theta_3 - chain_theta_5).cos();
    let t9 = (chain_theta_4 - chain_theta_5).cos();
    [
        R::literal(5.0),
        t0,
        t1,
        t2,
        t3,
        t0,
        R::literal(4.0),
        t4,
        t5,
        t6,
        t1,
        t4,
        R::literal(3.0),
        t7,
        t8,
        t2,
        t5,
        t7,
        R::literal(2.0),
        t9,
        t3,
        t6,
        t8,
        t9,
        R::literal(1.0),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 109 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t0 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t1 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let chain_theta_1_forcing = -(R::literal(49.05) * chain_theta_1.sin())
        - R::literal(4.0) * chain_omega_2_squared * (chain_theta_1 - chain_theta_2).sin()
        - t0 * (chain_theta_1 - chain_theta_3).sin()
        - t1 * (chain_theta_1 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_1 - chain_theta_5).sin();
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_forcing = -(R::literal(39.24) * chain_theta_2.sin())
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t0 * (chain_theta_2 - chain_theta_3).sin()
        - t1 * (chain_theta_2 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_2 - chain_theta_5).sin();
    let chain_theta_3_forcing = -(R::literal(29.43) * chain_theta_3.sin())
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t1 * (chain_theta_3 - chain_theta_4).sin()
        - chain_omega_5_squared * (chain_theta_3 - chain_theta_5).sin();
    let chain_theta_4_forcing = -(R::literal(19.62) * chain_theta_4.sin())
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - chain_omega_5_squared * (chain_theta_4 - chain_theta_5).sin();
    let chain_theta_5_forcing = -(R::literal(9.81) * chain_theta_5.sin())
        - chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_5 - chain_theta_4).sin();
    [
        chain_theta_1_forcing,
        chain_theta_2_forcing,
        chain_theta_3_forcing,
        chain_theta_4_forcing,
        chain_theta_5_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 831 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 55] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = chain_theta_1_minus_chain_theta_2.cos();
    let t1 = R::literal(4.0) * t0;
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t2 = chain_theta_1_minus_chain_theta_3.cos();
    let t3 = R::literal(3.0) * t2;
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t4 = chain_theta_1_minus_chain_theta_4.cos();
    let t5 = R::literal(2.0) * t4;
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t6 = chain_theta_1_minus_chain_theta_5.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let t7 = chain_theta_2_minus_chain_theta_3.cos();
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let t8 = chain_theta_2_minus_chain_theta_4.cos();
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let t9 = chain_theta_2_minus_chain_theta_5.cos();
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let t10 = chain_theta_3_minus_chain_theta_4.cos();
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let t11 = chain_theta_3_minus_chain_theta_5.cos();
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let t12 = chain_theta_4_minus_chain_theta_5.cos();
    let t13 = t1 * R::literal(0.2);
    let t14 = t3 * R::literal(0.2);
    let t15 = t5 * R::literal(0.2);
    let t16 = t6 * R::literal(0.2);
    let t17 = R::literal(1.0) / (R::literal(4.0) - t13 * t1);
    let t18 = R::literal(3.0) * t7 - t14 * t1;
    let t19 = t18 * t17;
    let t20 = R::literal(2.0) * t8 - t15 * t1;
    let t21 = t20 * t17;
    let t22 = t9 - t16 * t1;
    let t23 = t22 * t17;
    let t24 = R::literal(1.0) / (R::literal(3.0) - t14 * t3 - t19 * t18);
    let t25 = R::literal(2.0) * t10 - t15 * t3 - t21 * t18;
    let t26 = t25 * t24;
    let t27 = t11 - t16 * t3 - t23 * t18;
    let t28 = t27 * t24;
    let t29 = R::literal(1.0) / (R::literal(2.0) - t15 * t5 - t21 * t20 - t26 * t25);
    let t30 = t12 - t16 * t5 - t23 * t20 - t28 * t25;
    let t31 = t30 * t29;
    let t32 = R::literal(1.0)
        / (R::literal(1.0) - t16 * t6 - t23 * t22 - t28 * t27 - t31 * t30);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t33 = chain_theta_1_minus_chain_theta_2.sin();
    let t34 = R::literal(4.0) * chain_omega_2_squared;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t35 = chain_theta_1_minus_chain_theta_3.sin();
    let t36 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t37 = chain_theta_1_minus_chain_theta_4.sin();
    let t38 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t39 = chain_theta_1_minus_chain_theta_5.sin();
    let t40 = -(R::literal(49.05) * chain_theta_1.sin()) - t34 * t33 - t36 * t35
        - t38 * t37 - chain_omega_5_squared * t39;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_minus_chain_theta_1 = chain_theta_2 - chain_theta_1;
    let t41 = chain_theta_2_minus_chain_theta_1.sin();
    let t42 = R::literal(4.0) * chain_omega_1_squared;
    let t43 = chain_theta_2_minus_chain_theta_3.sin();
    let t44 = chain_theta_2_minus_chain_theta_4.sin();
    let t45 = chain_theta_2_minus_chain_theta_5.sin();
    let chain_theta_3_minus_chain_theta_1 = chain_theta_3 - chain_theta_1;
    let t46 = chain_theta_3_minus_chain_theta_1.sin();
    let t47 = R::literal(3.0) * chain_omega_1_squared;
    let chain_theta_3_minus_chain_theta_2 = chain_theta_3 - chain_theta_2;
    let t48 = chain_theta_3_minus_chain_theta_2.sin();
    let t49 = R::literal(3.0) * chain_omega_2_squared;
    let t50 = chain_theta_3_minus_chain_theta_4.sin();
    let t51 = chain_theta_3_minus_chain_theta_5.sin();
    let chain_theta_4_minus_chain_theta_1 = chain_theta_4 - chain_theta_1;
    let t52 = chain_theta_4_minus_chain_theta_1.sin();
    let t53 = R::literal(2.0) * chain_omega_1_squared;
    let chain_theta_4_minus_chain_theta_2 = chain_theta_4 - chain_theta_2;
    let t54 = chain_theta_4_minus_chain_theta_2.sin();
    let t55 = R::literal(2.0) * chain_omega_2_squared;
    let chain_theta_4_minus_chain_theta_3 = chain_theta_4 - chain_theta_3;
    let t56 = chain_theta_4_minus_chain_theta_3.sin();
    let t57 = R::literal(2.0) * chain_omega_3_squared;
    let t58 = chain_theta_4_minus_chain_theta_5.sin();
    let chain_theta_5_minus_chain_theta_1 = chain_theta_5 - chain_theta_1;
    let t59 = chain_theta_5_minus_chain_theta_1.sin();
    let chain_theta_5_minus_chain_theta_2 = chain_theta_5 - chain_theta_2;
    let t60 = chain_theta_5_minus_chain_theta_2.sin();
    let chain_theta_5_minus_chain_theta_3 = chain_theta_5 - chain_theta_3;
    let t61 = chain_theta_5_minus_chain_theta_3.sin();
    let chain_theta_5_minus_chain_theta_4 = chain_theta_5 - chain_theta_4;
    let t62 = chain_theta_5_minus_chain_theta_4.sin();
    let t63 = -(R::literal(39.24) * chain_theta_2.sin()) - t42 * t41 - t36 * t43
        - t38 * t44 - chain_omega_5_squared * t45 - t13 * t40;
    let t64 = -(R::literal(29.43) * chain_theta_3.sin()) - t47 * t46 - t49 * t48
        - t38 * t50 - chain_omega_5_squared * t51 - t14 * t40 - t19 * t63;
    let t65 = -(R::literal(19.62) * chain_theta_4.sin()) - t53 * t52 - t55 * t54
        - t57 * t56 - chain_omega_5_squared * t58 - t15 * t40 - t21 * t63 - t26 * t64;
    let chain_omega_5_dot = (-(R::literal(9.81) * chain_theta_5.sin())
        - chain_omega_1_squared * t59 - chain_omega_2_squared * t60
        - chain_omega_3_squared * t61 - chain_omega_4_squared * t62 - t16 * t40
        - t23 * t63 - t28 * t64 - t31 * t65) * t32;
    let chain_omega_4_dot = t65 * t29 - t31 * chain_omega_5_dot;
    let chain_omega_3_dot = t64 * t24 - t26 * chain_omega_4_dot
        - t28 * chain_omega_5_dot;
    let chain_omega_2_dot = t63 * t17 - t19 * chain_omega_3_dot - t21 * chain_omega_4_dot
        - t23 * chain_omega_5_dot;
    let chain_omega_1_dot = t40 * R::literal(0.2) - t13 * chain_omega_2_dot
        - t14 * chain_omega_3_dot - t15 * chain_omega_4_dot - t16 * chain_omega_5_dot;
    let t66 = t34 * t0;
    let t67 = t36 * t2;
    let t68 = t38 * t4;
    let t69 = chain_omega_5_squared * t6;
    let t70 = t42 * chain_theta_2_minus_chain_theta_1.cos();
    let t71 = t47 * chain_theta_3_minus_chain_theta_1.cos();
    let t72 = t53 * chain_theta_4_minus_chain_theta_1.cos();
    let t73 = chain_omega_1_squared * chain_theta_5_minus_chain_theta_1.cos();
    let t74 = R::literal(4.0) * t33;
    let t75 = t74 * chain_omega_2_dot;
    let t76 = t74 * chain_omega_1_dot;
    let t77 = R::literal(3.0) * t35;
    let t78 = t77 * chain_omega_3_dot;
    let t79 = t77 * chain_omega_1_dot;
    let t80 = R::literal(2.0) * t37;
    let t81 = t80 * chain_omega_4_dot;
    let t82 = t80 * chain_omega_1_dot;
    let t83 = t39 * chain_omega_5_dot;
    let t84 = -(R::literal(49.05) * chain_theta_1.cos()) - t66 - t67 - t68 - t69 + t75
        + t78 + t81 + t83;
    let t85 = t39 * chain_omega_1_dot;
    let t86 = t70 + t76 - t13 * t84;
    let t87 = t71 + t79 - t14 * t84 - t19 * t86;
    let t88 = t72 + t82 - t15 * t84 - t21 * t86 - t26 * t87;
    let chain_omega_5_dot_by_chain_theta_1 = (t73 + t85 - t16 * t84 - t23 * t86
        - t28 * t87 - t31 * t88) * t32;
    let chain_omega_4_dot_by_chain_theta_1 = t88 * t29
        - t31 * chain_omega_5_dot_by_chain_theta_1;
    let chain_omega_3_dot_by_chain_theta_1 = t87 * t24
        - t26 * chain_omega_4_dot_by_chain_theta_1
        - t28 * chain_omega_5_dot_by_chain_theta_1;
    let chain_omega_2_dot_by_chain_theta_1 = t86 * t17
        - t19 * chain_omega_3_dot_by_chain_theta_1
        - t21 * chain_omega_4_dot_by_chain_theta_1
        - t23 * chain_omega_5_dot_by_chain_theta_1;
    let chain_omega_1_dot_by_chain_theta_1 = t84 * R::literal(0.2)
        - t13 * chain_omega_2_dot_by_chain_theta_1
        - t14 * chain_omega_3_dot_by_chain_theta_1
        - t15 * chain_omega_4_dot_by_chain_theta_1
        - t16 * chain_omega_5_dot_by_chain_theta_1;
    let t89 = t36 * t7;
    let t90 = t38 * t8;
    let t91 = chain_omega_5_squared * t9;
    let t92 = t49 * chain_theta_3_minus_chain_theta_2.cos();
    let t93 = t55 * chain_theta_4_minus_chain_theta_2.cos();
    let t94 = chain_omega_2_squared * chain_theta_5_minus_chain_theta_2.cos();
    let t95 = t66 - t75;
    let t96 = R::literal(3.0) * t43;
    let t97 = t96 * chain_omega_3_dot;
    let t98 = t96 * chain_omega_2_dot;
    let t99 = R::literal(2.0) * t44;
    let t100 = t99 * chain_omega_4_dot;
    let t101 = t99 * chain_omega_2_dot;
    let t102 = t45 * chain_omega_5_dot;
    let t103 = t45 * chain_omega_2_dot;
    let t104 = -(R::literal(39.24) * chain_theta_2.cos()) - t70 - t89 - t90 - t91 - t76
        + t97 + t100 + t102 - t13 * t95;
    let t105 = t92 + t98 - t14 * t95 - t19 * t104;
    let t106 = t93 + t101 - t15 * t95 - t21 * t104 - t26 * t105;
    let chain_omega_5_dot_by_chain_theta_2 = (t94 + t103 - t16 * t95 - t23 * t104
        - t28 * t105 - t31 * t106) * t32;
    let chain_omega_4_dot_by_chain_theta_2 = t106 * t29
        - t31 * chain_omega_5_dot_by_chain_theta_2;
    let chain_omega_3_dot_by_chain_theta_2 = t105 * t24
        - t26 * chain_omega_4_dot_by_chain_theta_2
        - t28 * chain_omega_5_dot_by_chain_theta_2;
    let chain_omega_2_dot_by_chain_theta_2 = t104 * t17
        - t19 * chain_omega_3_dot_by_chain_theta_2
        - t21 * chain_omega_4_dot_by_chain_theta_2
        - t23 * chain_omega_5_dot_by_chain_theta_2;
    let chain_omega_1_dot_by_chain_theta_2 = t95 * R::literal(0.2)
        - t13 * chain_omega_2_dot_by_chain_theta_2
        - t14 * chain_omega_3_dot_by_chain_theta_2
        - t15 * chain_omega_4_dot_by_chain_theta_2
        - t16 * chain_omega_5_dot_by_chain_theta_2;
    let t107 = t38 * t10;
    let t108 = chain_omega_5_squared * t11;
    let t109 = t57 * chain_theta_4_minus_chain_theta_3.cos();
    let t110 = chain_omega_3_squared * chain_theta_5_minus_chain_theta_3.cos();
    let t111 = t67 - t78;
    let t112 = R::literal(2.0) * t50;
    let t113 = t112 * chain_omega_4_dot;
    let t114 = t112 * chain_omega_3_dot;
    let t115 = t51 * chain_omega_5_dot;
    let t116 = t51 * chain_omega_3_dot;
    let t117 = t89 - t97 - t13 * t111;
    let t118 = -(R::literal(29.43) * chain_theta_3.cos()) - t71 - t92 - t107 - t108 - t79
        - t98 + t113 + t115 - t14 * t111 - t19 * t117;
    let t119 = t109 + t114 - t15 * t111 - t21 * t117 - t26 * t118;
    let chain_omega_5_dot_by_chain_theta_3 = (t110 + t116 - t16 * t111 - t23 * t117
        - t28 * t118 - t31 * t119) * t32;
    let chain_omega_4_dot_by_chain_theta_3 = t119 * t29
        - t31 * chain_omega_5_dot_by_chain_theta_3;
    let chain_omega_3_dot_by_chain_theta_3 = t118 * t24
        - t26 * chain_omega_4_dot_by_chain_theta_3
        - t28 * chain_omega_5_dot_by_chain_theta_3;
    let chain_omega_2_dot_by_chain_theta_3 = t117 * t17
        - t19 * chain_omega_3_dot_by_chain_theta_3
        - t21 * chain_omega_4_dot_by_chain_theta_3
        - t23 * chain_omega_5_dot_by_chain_theta_3;
    let chain_omega_1_dot_by_chain_theta_3 = t111 * R::literal(0.2)
        - t13 * chain_omega_2_dot_by_chain_theta_3
        - t14 * chain_omega_3_dot_by_chain_theta_3
        - t15 * chain_omega_4_dot_by_chain_theta_3
        - t16 * chain_omega_5_dot_by_chain_theta_3;
    let t120 = chain_omega_5_squared * t12;
    let t121 = chain_omega_4_squared * chain_theta_5_minus_chain_theta_4.cos();
    let t122 = t68 - t81;
    let t123 = t58 * chain_omega_5_dot;
    let t124 = t58 * chain_omega_4_dot;
    let t125 = t90 - t100 - t13 * t122;
    let t126 = t107 - t113 - t14 * t122 - t19 * t125;
    let t127 = -(R::literal(19.62) * chain_theta_4.cos()) - t72 - t93 - t109 - t120 - t82
        - t101 - t114 + t123 - t15 * t122 - t21 * t125 - t26 * t126;
    let chain_omega_5_dot_by_chain_theta_4 = (t121 + t124 - t16 * t122 - t23 * t125
        - t28 * t126 - t31 * t127) * t32;
    let chain_omega_4_dot_by_chain_theta_4 = t127 * t29
        - t31 * chain_omega_5_dot_by_chain_theta_4;
    let chain_omega_3_dot_by_chain_theta_4 = t126 * t24
        - t26 * chain_omega_4_dot_by_chain_theta_4
        - t28 * chain_omega_5_dot_by_chain_theta_4;
    let chain_omega_2_dot_by_chain_theta_4 = t125 * t17
        - t19 * chain_omega_3_dot_by_chain_theta_4
        - t21 * chain_omega_4_dot_by_chain_theta_4
        - t23 * chain_omega_5_dot_by_chain_theta_4;
    let chain_omega_1_dot_by_chain_theta_4 = t122 * R::literal(0.2)
        - t13 * chain_omega_2_dot_by_chain_theta_4
        - t14 * chain_omega_3_dot_by_chain_theta_4
        - t15 * chain_omega_4_dot_by_chain_theta_4
        - t16 * chain_omega_5_dot_by_chain_theta_4;
    let t128 = t69 - t83;
    let t129 = t91 - t102 - t13 * t128;
    let t130 = t108 - t115 - t14 * t128 - t19 * t129;
    let t131 = t120 - t123 - t15 * t128 - t21 * t129 - t26 * t130;
    let chain_omega_5_dot_by_chain_theta_5 = (-(R::literal(9.81) * chain_theta_5.cos())
        - t73 - t94 - t110 - t121 - t85 - t103 - t116 - t124 - t16 * t128 - t23 * t129
        - t28 * t130 - t31 * t131) * t32;
    let chain_omega_4_dot_by_chain_theta_5 = t131 * t29
        - t31 * chain_omega_5_dot_by_chain_theta_5;
    let chain_omega_3_dot_by_chain_theta_5 = t130 * t24
        - t26 * chain_omega_4_dot_by_chain_theta_5
        - t28 * chain_omega_5_dot_by_chain_theta_5;
    let chain_omega_2_dot_by_chain_theta_5 = t129 * t17
        - t19 * chain_omega_3_dot_by_chain_theta_5
        - t21 * chain_omega_4_dot_by_chain_theta_5
        - t23 * chain_omega_5_dot_by_chain_theta_5;
    let chain_omega_1_dot_by_chain_theta_5 = t128 * R::literal(0.2)
        - t13 * chain_omega_2_dot_by_chain_theta_5
        - t14 * chain_omega_3_dot_by_chain_theta_5
        - t15 * chain_omega_4_dot_by_chain_theta_5
        - t16 * chain_omega_5_dot_by_chain_theta_5;
    let t132 = R::literal(8.0) * chain_omega_1 * t41;
    let t133 = t19 * t132 - R::literal(6.0) * chain_omega_1 * t46;
    let t134 = t21 * t132 - R::literal(4.0) * chain_omega_1 * t52 - t26 * t133;
    let chain_omega_5_dot_by_chain_omega_1 = (t23 * t132
        - R::literal(2.0) * chain_omega_1 * t59 - t28 * t133 - t31 * t134) * t32;
    let chain_omega_4_dot_by_chain_omega_1 = t134 * t29
        - t31 * chain_omega_5_dot_by_chain_omega_1;
    let chain_omega_3_dot_by_chain_omega_1 = t133 * t24
        - t26 * chain_omega_4_dot_by_chain_omega_1
        - t28 * chain_omega_5_dot_by_chain_omega_1;
    let chain_omega_2_dot_by_chain_omega_1 = -(t132 * t17)
        - t19 * chain_omega_3_dot_by_chain_omega_1
        - t21 * chain_omega_4_dot_by_chain_omega_1
        - t23 * chain_omega_5_dot_by_chain_omega_1;
    let chain_omega_1_dot_by_chain_omega_1 = -(t13 * chain_omega_2_dot_by_chain_omega_1)
        - t14 * chain_omega_3_dot_by_chain_omega_1
        - t15 * chain_omega_4_dot_by_chain_omega_1
        - t16 * chain_omega_5_dot_by_chain_omega_1;
    let t135 = R::literal(8.0) * chain_omega_2 * t33;
    let t136 = t13 * t135;
    let t137 = t14 * t135 - R::literal(6.0) * chain_omega_2 * t48 - t19 * t136;
    let t138 = t15 * t135 - R::literal(4.0) * chain_omega_2 * t54 - t21 * t136
        - t26 * t137;
    let chain_omega_5_dot_by_chain_omega_2 = (t16 * t135
        - R::literal(2.0) * chain_omega_2 * t60 - t23 * t136 - t28 * t137 - t31 * t138)
        * t32;
    let chain_omega_4_dot_by_chain_omega_2 = t138 * t29
        - t31 * chain_omega_5_dot_by_chain_omega_2;
    let chain_omega_3_dot_by_chain_omega_2 = t137 * t24
        - t26 * chain_omega_4_dot_by_chain_omega_2
        - t28 * chain_omega_5_dot_by_chain_omega_2;
    let chain_omega_2_dot_by_chain_omega_2 = t136 * t17
        - t19 * chain_omega_3_dot_by_chain_omega_2
        - t21 * chain_omega_4_dot_by_chain_omega_2
        - t23 * chain_omega_5_dot_by_chain_omega_2;
    let chain_omega_1_dot_by_chain_omega_2 = -(t135 * R::literal(0.2))
        - t13 * chain_omega_2_dot_by_chain_omega_2
        - t14 * chain_omega_3_dot_by_chain_omega_2
        - t15 * chain_omega_4_dot_by_chain_omega_2
        - t16 * chain_omega_5_dot_by_chain_omega_2;
    let t139 = R::literal(6.0) * chain_omega_3;
    let t140 = t139 * t35;
    let t141 = t13 * t140 - t139 * t43;
    let t142 = t14 * t140 - t19 * t141;
    let t143 = t15 * t140 - R::literal(4.0) * chain_omega_3 * t56 - t21 * t141
        - t26 * t142;
    let chain_omega_5_dot_by_chain_omega_3 = (t16 * t140
        - R::literal(2.0) * chain_omega_3 * t61 - t23 * t141 - t28 * t142 - t31 * t143)
        * t32;
    let chain_omega_4_dot_by_chain_omega_3 = t143 * t29
        - t31 * chain_omega_5_dot_by_chain_omega_3;
    let chain_omega_3_dot_by_chain_omega_3 = t142 * t24
        - t26 * chain_omega_4_dot_by_chain_omega_3
        - t28 * chain_omega_5_dot_by_chain_omega_3;
    let chain_omega_2_dot_by_chain_omega_3 = t141 * t17
        - t19 * chain_omega_3_dot_by_chain_omega_3
        - t21 * chain_omega_4_dot_by_chain_omega_3
        - t23 * chain_omega_5_dot_by_chain_omega_3;
    let chain_omega_1_dot_by_chain_omega_3 = -(t140 * R::literal(0.2))
        - t13 * chain_omega_2_dot_by_chain_omega_3
        - t14 * chain_omega_3_dot_by_chain_omega_3
        - t15 * chain_omega_4_dot_by_chain_omega_3
        - t16 * chain_omega_5_dot_by_chain_omega_3;
    let t144 = R::literal(4.0) * chain_omega_4;
    let t145 = t144 * t37;
    let t146 = t13 * t145 - t144 * t44;
    let t147 = t14 * t145 - t144 * t50 - t19 * t146;
    let t148 = t15 * t145 - t21 * t146 - t26 * t147;
    let chain_omega_5_dot_by_chain_omega_4 = (t16 * t145
        - R::literal(2.0) * chain_omega_4 * t62 - t23 * t146 - t28 * t147 - t31 * t148)
        * t32;
    let chain_omega_4_dot_by_chain_omega_4 = t148 * t29
        - t31 * chain_omega_5_dot_by_chain_omega_4;
    let chain_omega_3_dot_by_chain_omega_4 = t147 * t24
        - t26 * chain_omega_4_dot_by_chain_omega_4
        - t28 * chain_omega_5_dot_by_chain_omega_4;
    let chain_omega_2_dot_by_chain_omega_4 = t146 * t17
        - t19 * chain_omega_3_dot_by_chain_omega_4
        - t21 * chain_omega_4_dot_by_chain_omega_4
        - t23 * chain_omega_5_dot_by_chain_omega_4;
    let chain_omega_1_dot_by_chain_omega_4 = -(t145 * R::literal(0.2))
        - t13 * chain_omega_2_dot_by_chain_omega_4
        - t14 * chain_omega_3_dot_by_chain_omega_4
        - t15 * chain_omega_4_dot_by_chain_omega_4
        - t16 * chain_omega_5_dot_by_chain_omega_4;
    let t149 = R::literal(2.0) * chain_omega_5;
    let t150 = t149 * t39;
    let t151 = t13 * t150 - t149 * t45;
    let t152 = t14 * t150 - t149 * t51 - t19 * t151;
    let t153 = t15 * t150 - t149 * t58 - t21 * t151 - t26 * t152;
    let chain_omega_5_dot_by_chain_omega_5 = (t16 * t150 - t23 * t151 - t28 * t152
        - t31 * t153) * t32;
    let chain_omega_4_dot_by_chain_omega_5 = t153 * t29
        - t31 * chain_omega_5_dot_by_chain_omega_5;
    let chain_omega_3_dot_by_chain_omega_5 = t152 * t24
        - t26 * chain_omega_4_dot_by_chain_omega_5
        - t28 * chain_omega_5_dot_by_chain_omega_5;
    let chain_omega_2_dot_by_chain_omega_5 = t151 * t17
        - t19 * chain_omega_3_dot_by_chain_omega_5
        - t21 * chain_omega_4_dot_by_chain_omega_5
        - t23 * chain_omega_5_dot_by_chain_omega_5;
    let chain_omega_1_dot_by_chain_omega_5 = -(t150 * R::literal(0.2))
        - t13 * chain_omega_2_dot_by_chain_omega_5
        - t14 * chain_omega_3_dot_by_chain_omega_5
        - t15 * chain_omega_4_dot_by_chain_omega_5
        - t16 * chain_omega_5_dot_by_chain_omega_5;
    [
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
        chain_omega_1_dot_by_chain_omega_1,
        chain_omega_1_dot_by_chain_omega_2,
        chain_omega_1_dot_by_chain_omega_3,
        chain_omega_1_dot_by_chain_omega_4,
        chain_omega_1_dot_by_chain_omega_5,
        chain_omega_2_dot_by_chain_theta_1,
        chain_omega_2_dot_by_chain_theta_2,
        chain_omega_2_dot_by_chain_theta_3,
        chain_omega_2_dot_by_chain_theta_4,
        chain_omega_2_dot_by_chain_theta_5,
        chain_omega_2_dot_by_chain_omega_1,
        chain_omega_2_dot_by_chain_omega_2,
        chain_omega_2_dot_by_chain_omega_3,
        chain_omega_2_dot_by_chain_omega_4,
        chain_omega_2_dot_by_chain_omega_5,
        chain_omega_3_dot_by_chain_theta_1,
        chain_omega_3_dot_by_chain_theta_2,
        chain_omega_3_dot_by_chain_theta_3,
        chain_omega_3_dot_by_chain_theta_4,
        chain_omega_3_dot_by_chain_theta_5,
        chain_omega_3_dot_by_chain_omega_1,
        chain_omega_3_dot_by_chain_omega_2,
        chain_omega_3_dot_by_chain_omega_3,
        chain_omega_3_dot_by_chain_omega_4,
        chain_omega_3_dot_by_chain_omega_5,
        chain_omega_4_dot_by_chain_theta_1,
        chain_omega_4_dot_by_chain_theta_2,
        chain_omega_4_dot_by_chain_theta_3,
        chain_omega_4_dot_by_chain_theta_4,
        chain_omega_4_dot_by_chain_theta_5,
        chain_omega_4_dot_by_chain_omega_1,
        chain_omega_4_dot_by_chain_omega_2,
        chain_omega_4_dot_by_chain_omega_3,
        chain_omega_4_dot_by_chain_omega_4,
        chain_omega_4_dot_by_chain_omega_5,
        chain_omega_5_dot_by_chain_theta_1,
        chain_omega_5_dot_by_chain_theta_2,
        chain_omega_5_dot_by_chain_theta_3,
        chain_omega_5_dot_by_chain_theta_4,
        chain_omega_5_dot_by_chain_theta_5,
        chain_omega_5_dot_by_chain_omega_1,
        chain_omega_5_dot_by_chain_omega_2,
        chain_omega_5_dot_by_chain_omega_3,
        chain_omega_5_dot_by_chain_omega_4,
        chain_omega_5_dot_by_chain_omega_5,
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
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    Outputs {
        theta_1: chain_theta_1,
        theta_2: chain_theta_2,
        theta_3: chain_theta_3,
        theta_4: chain_theta_4,
        theta_5: chain_theta_5,
        omega_1: chain_omega_1,
        omega_2: chain_omega_2,
        omega_3: chain_omega_3,
        omega_4: chain_omega_4,
        omega_5: chain_omega_5,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 58 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
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
    Energy {
        kinetic: R::literal(0.5)
            * (chain_u_1 * chain_u_1 + chain_v_1 * chain_v_1 + chain_u_2 * chain_u_2
                + chain_v_2 * chain_v_2 + chain_u_3 * chain_u_3 + chain_v_3 * chain_v_3
                + chain_u_4 * chain_u_4 + chain_v_4 * chain_v_4 + chain_u_5 * chain_u_5
                + chain_v_5 * chain_v_5),
        potential: R::literal(9.81)
            * (-(R::literal(5.0) * cos_chain_theta_1)
                - R::literal(4.0) * cos_chain_theta_2
                - R::literal(3.0) * cos_chain_theta_3
                - R::literal(2.0) * cos_chain_theta_4 - cos_chain_theta_5),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 421 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
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
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let t0 = R::literal(4.0) * chain_theta_1_minus_chain_theta_2.cos();
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let t1 = R::literal(3.0) * chain_theta_1_minus_chain_theta_3.cos();
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let t2 = R::literal(2.0) * chain_theta_1_minus_chain_theta_4.cos();
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let t3 = chain_theta_1_minus_chain_theta_5.cos();
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let t4 = t0 * R::literal(0.2);
    let t5 = t1 * R::literal(0.2);
    let t6 = t2 * R::literal(0.2);
    let t7 = t3 * R::literal(0.2);
    let t8 = R::literal(1.0) / (R::literal(4.0) - t4 * t0);
    let t9 = R::literal(3.0) * chain_theta_2_minus_chain_theta_3.cos() - t5 * t0;
    let t10 = t9 * t8;
    let t11 = R::literal(2.0) * chain_theta_2_minus_chain_theta_4.cos() - t6 * t0;
    let t12 = t11 * t8;
    let t13 = chain_theta_2_minus_chain_theta_5.cos() - t7 * t0;
    let t14 = t13 * t8;
    let t15 = R::literal(1.0) / (R::literal(3.0) - t5 * t1 - t10 * t9);
    let t16 = R::literal(2.0) * chain_theta_3_minus_chain_theta_4.cos() - t6 * t1
        - t12 * t9;
    let t17 = t16 * t15;
    let t18 = chain_theta_3_minus_chain_theta_5.cos() - t7 * t1 - t14 * t9;
    let t19 = t18 * t15;
    let t20 = R::literal(1.0) / (R::literal(2.0) - t6 * t2 - t12 * t11 - t17 * t16);
    let t21 = chain_theta_4_minus_chain_theta_5.cos() - t7 * t2 - t14 * t11 - t19 * t16;
    let t22 = t21 * t20;
    let t23 = R::literal(49.05) * sin_chain_theta_1;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t24 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t25 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t26 = -t23
        - R::literal(4.0) * chain_omega_2_squared
            * chain_theta_1_minus_chain_theta_2.sin()
        - t24 * chain_theta_1_minus_chain_theta_3.sin()
        - t25 * chain_theta_1_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_1_minus_chain_theta_5.sin();
    let t27 = R::literal(39.24) * sin_chain_theta_2;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t28 = R::literal(29.43) * sin_chain_theta_3;
    let t29 = R::literal(19.62) * sin_chain_theta_4;
    let t30 = R::literal(9.81) * sin_chain_theta_5;
    let t31 = -t27
        - R::literal(4.0) * chain_omega_1_squared * (chain_theta_2 - chain_theta_1).sin()
        - t24 * chain_theta_2_minus_chain_theta_3.sin()
        - t25 * chain_theta_2_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_2_minus_chain_theta_5.sin() - t4 * t26;
    let t32 = -t28
        - R::literal(3.0) * chain_omega_1_squared * (chain_theta_3 - chain_theta_1).sin()
        - R::literal(3.0) * chain_omega_2_squared * (chain_theta_3 - chain_theta_2).sin()
        - t25 * chain_theta_3_minus_chain_theta_4.sin()
        - chain_omega_5_squared * chain_theta_3_minus_chain_theta_5.sin() - t5 * t26
        - t10 * t31;
    let t33 = -t29
        - R::literal(2.0) * chain_omega_1_squared * (chain_theta_4 - chain_theta_1).sin()
        - R::literal(2.0) * chain_omega_2_squared * (chain_theta_4 - chain_theta_2).sin()
        - R::literal(2.0) * chain_omega_3_squared * (chain_theta_4 - chain_theta_3).sin()
        - chain_omega_5_squared * chain_theta_4_minus_chain_theta_5.sin() - t6 * t26
        - t12 * t31;
    let t34 = t33 - t17 * t32;
    let t35 = -t30 - chain_omega_1_squared * (chain_theta_5 - chain_theta_1).sin()
        - chain_omega_2_squared * (chain_theta_5 - chain_theta_2).sin()
        - chain_omega_3_squared * (chain_theta_5 - chain_theta_3).sin()
        - chain_omega_4_squared * (chain_theta_5 - chain_theta_4).sin() - t7 * t26
        - t14 * t31 - t19 * t32;
    let chain_omega_5_dot = (t35 - t22 * t34)
        * (R::literal(1.0)
            / (R::literal(1.0) - t7 * t3 - t14 * t13 - t19 * t18 - t22 * t21));
    let chain_omega_4_dot = t34 * t20 - t22 * chain_omega_5_dot;
    let chain_omega_3_dot = t32 * t15 - t17 * chain_omega_4_dot
        - t19 * chain_omega_5_dot;
    let chain_omega_2_dot = t31 * t8 - t10 * chain_omega_3_dot - t12 * chain_omega_4_dot
        - t14 * chain_omega_5_dot;
    let chain_omega_1_dot = t26 * R::literal(0.2) - t4 * chain_omega_2_dot
        - t5 * chain_omega_3_dot - t6 * chain_omega_4_dot - t7 * chain_omega_5_dot;
    let t36 = R::literal(2.0) * chain_omega_2;
    let t37 = R::literal(2.0) * chain_omega_3;
    let t38 = R::literal(2.0) * chain_omega_4;
    let t39 = R::literal(2.0) * chain_omega_5;
    let t40 = R::literal(2.0) * chain_v_1;
    let t41 = R::literal(2.0) * chain_u_1;
    let t42 = R::literal(0.5)
        * (t36 * chain_v_2 * cos_chain_theta_2 + t36 * chain_v_3 * cos_chain_theta_2
            + t36 * chain_v_4 * cos_chain_theta_2 + t36 * chain_v_5 * cos_chain_theta_2
            - t36 * chain_u_2 * sin_chain_theta_2 - t36 * chain_u_3 * sin_chain_theta_2
            - t36 * chain_u_4 * sin_chain_theta_2 - t36 * chain_u_5 * sin_chain_theta_2);
    let t43 = (R::literal(0.5)
        * (t41 * chain_v_2 + t41 * chain_v_3 + t41 * chain_v_4 + t41 * chain_v_5
            - t40 * chain_u_2 - t40 * chain_u_3 - t40 * chain_u_4 - t40 * chain_u_5)
        + t23) * chain_omega_1 + (t42 + t27) * chain_omega_2;
    let t44 = t43
        + (R::literal(0.5)
            * (t37 * chain_v_3 * cos_chain_theta_3 + t37 * chain_v_4 * cos_chain_theta_3
                + t37 * chain_v_5 * cos_chain_theta_3
                - t37 * chain_u_3 * sin_chain_theta_3
                - t37 * chain_u_4 * sin_chain_theta_3
                - t37 * chain_u_5 * sin_chain_theta_3) + t28) * chain_omega_3;
    let t45 = t44
        + (R::literal(0.5)
            * (t38 * chain_v_4 * cos_chain_theta_4 + t38 * chain_v_5 * cos_chain_theta_4
                - t38 * chain_u_4 * sin_chain_theta_4
                - t38 * chain_u_5 * sin_chain_theta_4) + t29) * chain_omega_4
        + (R::literal(0.5)
            * (t39 * chain_v_5 * cos_chain_theta_5 - t39 * chain_u_5 * sin_chain_theta_5)
            + t30) * chain_omega_5;
    let t46 = R::literal(2.0) * chain_u_2;
    let t47 = R::literal(2.0) * chain_v_2;
    let t48 = R::literal(2.0) * chain_u_3;
    let t49 = R::literal(2.0) * chain_v_3;
    let t50 = R::literal(2.0) * chain_u_4;
    let t51 = R::literal(2.0) * chain_v_4;
    let t52 = R::literal(2.0) * chain_u_5;
    let t53 = R::literal(2.0) * chain_v_5;
    let t54 = t45
        + R::literal(0.5)
            * (t41 * cos_chain_theta_1 + t40 * sin_chain_theta_1
                + t46 * cos_chain_theta_1 + t47 * sin_chain_theta_1
                + t48 * cos_chain_theta_1 + t49 * sin_chain_theta_1
                + t50 * cos_chain_theta_1 + t51 * sin_chain_theta_1
                + t52 * cos_chain_theta_1 + t53 * sin_chain_theta_1) * chain_omega_1_dot;
    let t55 = t54
        + R::literal(0.5)
            * (t46 * cos_chain_theta_2 + t47 * sin_chain_theta_2
                + t48 * cos_chain_theta_2 + t49 * sin_chain_theta_2
                + t50 * cos_chain_theta_2 + t51 * sin_chain_theta_2
                + t52 * cos_chain_theta_2 + t53 * sin_chain_theta_2) * chain_omega_2_dot;
    let t56 = t55
        + R::literal(0.5)
            * (t48 * cos_chain_theta_3 + t49 * sin_chain_theta_3
                + t50 * cos_chain_theta_3 + t51 * sin_chain_theta_3
                + t52 * cos_chain_theta_3 + t53 * sin_chain_theta_3) * chain_omega_3_dot
        + R::literal(0.5)
            * (t50 * cos_chain_theta_4 + t51 * sin_chain_theta_4
                + t52 * cos_chain_theta_4 + t53 * sin_chain_theta_4) * chain_omega_4_dot;
    PowerBalance {
        stored_rate: t56
            + R::literal(0.5) * (t52 * cos_chain_theta_5 + t53 * sin_chain_theta_5)
                * chain_omega_5_dot,
        supplied: R::literal(0.0),
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 185 recurrences. 75 sums of products an order.
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
    let (mut lanes_7, _) = Lanes::<R, 5>::new(workspace, coefficients.len());
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let t0 = chain_theta_1 - chain_theta_2;
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = t2 * R::literal(4.0);
    let t4 = chain_theta_1 - chain_theta_3;
    let t5 = t4.sin();
    let t6 = t4.cos();
    let t7 = t6 * R::literal(3.0);
    let t8 = chain_theta_1 - chain_theta_4;
    let t9 = t8.sin();
    let t10 = t8.cos();
    let t11 = t10 * R::literal(2.0);
    let t12 = chain_theta_1 - chain_theta_5;
    let t13 = t12.sin();
    let t14 = t12.cos();
    let t15 = chain_theta_2 - chain_theta_3;
    let t16 = t15.sin();
    let t17 = t15.cos();
    let t18 = t17 * R::literal(3.0);
    let t19 = chain_theta_2 - chain_theta_4;
    let t20 = t19.sin();
    let t21 = t19.cos();
    let t22 = t21 * R::literal(2.0);
    let t23 = chain_theta_2 - chain_theta_5;
    let t24 = t23.sin();
    let t25 = t23.cos();
    let t26 = chain_theta_3 - chain_theta_4;
    let t27 = t26.sin();
    let t28 = t26.cos();
    let t29 = t28 * R::literal(2.0);
    let t30 = chain_theta_3 - chain_theta_5;
    let t31 = t30.sin();
    let t32 = t30.cos();
    let t33 = chain_theta_4 - chain_theta_5;
    let t34 = t33.sin();
    let t35 = t33.cos();
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
    let t36 = sin_chain_theta_1 * R::literal(49.05);
    let t37 = chain_omega_2 * chain_omega_2;
    let t38 = t37 * R::literal(4.0);
    let t39 = t38 * t1;
    let t40 = chain_omega_3 * chain_omega_3;
    let t41 = t40 * R::literal(3.0);
    let t42 = t41 * t5;
    let t43 = chain_omega_4 * chain_omega_4;
    let t44 = t43 * R::literal(2.0);
    let t45 = t44 * t9;
    let t46 = chain_omega_5 * chain_omega_5;
    let t47 = t46 * t13;
    let t48 = -t36;
    let t49 = t48 - t39;
    let t50 = t49 - t42;
    let t51 = t50 - t45;
    let t52 = t51 - t47;
    let t53 = sin_chain_theta_2 * R::literal(39.24);
    let t54 = chain_omega_1 * chain_omega_1;
    let t55 = -t1;
    let t56 = t54 * R::literal(4.0);
    let t57 = t56 * t55;
    let t58 = t41 * t16;
    let t59 = t44 * t20;
    let t60 = t46 * t24;
    let t61 = -t53;
    let t62 = t61 - t57;
    let t63 = t62 - t58;
    let t64 = t63 - t59;
    let t65 = t64 - t60;
    let t66 = sin_chain_theta_3 * R::literal(29.43);
    let t67 = -t5;
    let t68 = t54 * R::literal(3.0);
    let t69 = t68 * t67;
    let t70 = -t16;
    let t71 = t37 * R::literal(3.0);
    let t72 = t71 * t70;
    let t73 = t44 * t27;
    let t74 = t46 * t31;
    let t75 = -t66;
    let t76 = t75 - t69;
    let t77 = t76 - t72;
    let t78 = t77 - t73;
    let t79 = t78 - t74;
    let t80 = sin_chain_theta_4 * R::literal(19.62);
    let t81 = -t9;
    let t82 = t54 * R::literal(2.0);
    let t83 = t82 * t81;
    let t84 = -t20;
    let t85 = t37 * R::literal(2.0);
    let t86 = t85 * t84;
    let t87 = -t27;
    let t88 = t40 * R::literal(2.0);
    let t89 = t88 * t87;
    let t90 = t46 * t34;
    let t91 = -t80;
    let t92 = t91 - t83;
    let t93 = t92 - t86;
    let t94 = t93 - t89;
    let t95 = t94 - t90;
    let t96 = sin_chain_theta_5 * R::literal(9.81);
    let t97 = -t13;
    let t98 = t54 * t97;
    let t99 = -t24;
    let t100 = t37 * t99;
    let t101 = -t31;
    let t102 = t40 * t101;
    let t103 = -t34;
    let t104 = t43 * t103;
    let t105 = -t96;
    let t106 = t105 - t98;
    let t107 = t106 - t100;
    let t108 = t107 - t102;
    let t109 = t108 - t104;
    let factored = Factored::new([
        [
            R::literal(5.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
            R::literal(0.0),
        ],
        [t3, R::literal(4.0), R::literal(0.0), R::literal(0.0), R::literal(0.0)],
        [t7, t18, R::literal(3.0), R::literal(0.0), R::literal(0.0)],
        [t11, t22, t29, R::literal(2.0), R::literal(0.0)],
        [t14, t25, t32, t35, R::literal(1.0)],
    ]);
    let [chain_omega_1_dot, chain_omega_2_dot, chain_omega_3_dot, chain_omega_4_dot,
    chain_omega_5_dot] = factored.solve([t52, t65, t79, t95, t109]);
    let mut rates = [
        chain_omega_1,
        chain_omega_2,
        chain_omega_3,
        chain_omega_4,
        chain_omega_5,
        chain_omega_1_dot,
        chain_omega_2_dot,
        chain_omega_3_dot,
        chain_omega_4_dot,
        chain_omega_5_dot,
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
        chain_theta_5_k, chain_omega_1_k, chain_omega_2_k, chain_omega_3_k,
        chain_omega_4_k, chain_omega_5_k] = *state_k;
        let sums = lanes.sums(order);
        let sums_1 = lanes_1.sums(order);
        let sums_2 = lanes_2.sums(order);
        let sums_3 = lanes_3.sums(order);
        let sums_4 = lanes_4.sums(order);
        let sums_5 = lanes_5.sums(order);
        let sums_6 = lanes_6.sums(order);
        let sums_7 = lanes_7.sums(order);
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = inverse * sums[0] + t0_k * t2;
        let t2_k = -(inverse * sums[1] + t0_k * t1);
        let t3_k = t2_k * R::literal(4.0);
        let t4_k = chain_theta_1_k - chain_theta_3_k;
        let t5_k = inverse * sums[2] + t4_k * t6;
        let t6_k = -(inverse * sums[3] + t4_k * t5);
        let t7_k = t6_k * R::literal(3.0);
        let t8_k = chain_theta_1_k - chain_theta_4_k;
        let t9_k = inverse * sums[4] + t8_k * t10;
        let t10_k = -(inverse * sums[5] + t8_k * t9);
        let t11_k = t10_k * R::literal(2.0);
        let t12_k = chain_theta_1_k - chain_theta_5_k;
        let t13_k = inverse * sums[6] + t12_k * t14;
        let t14_k = -(inverse * sums[7] + t12_k * t13);
        let t15_k = chain_theta_2_k - chain_theta_3_k;
        let t16_k = inverse * sums[8] + t15_k * t17;
        let t17_k = -(inverse * sums[9] + t15_k * t16);
        let t18_k = t17_k * R::literal(3.0);
        let t19_k = chain_theta_2_k - chain_theta_4_k;
        let t20_k = inverse * sums_1[0] + t19_k * t21;
        let t21_k = -(inverse * sums_1[1] + t19_k * t20);
        let t22_k = t21_k * R::literal(2.0);
        let t23_k = chain_theta_2_k - chain_theta_5_k;
        let t24_k = inverse * sums_1[2] + t23_k * t25;
        let t25_k = -(inverse * sums_1[3] + t23_k * t24);
        let t26_k = chain_theta_3_k - chain_theta_4_k;
        let t27_k = inverse * sums_1[4] + t26_k * t28;
        let t28_k = -(inverse * sums_1[5] + t26_k * t27);
        let t29_k = t28_k * R::literal(2.0);
        let t30_k = chain_theta_3_k - chain_theta_5_k;
        let t31_k = inverse * sums_1[6] + t30_k * t32;
        let t32_k = -(inverse * sums_1[7] + t30_k * t31);
        let t33_k = chain_theta_4_k - chain_theta_5_k;
        let t34_k = inverse * sums_1[8] + t33_k * t35;
        let t35_k = -(inverse * sums_1[9] + t33_k * t34);
        let sin_chain_theta_1_k = inverse * sums_2[0]
            + chain_theta_1_k * cos_chain_theta_1;
        let cos_chain_theta_1_k = -(inverse * sums_2[1]
            + chain_theta_1_k * sin_chain_theta_1);
        let sin_chain_theta_2_k = inverse * sums_2[2]
            + chain_theta_2_k * cos_chain_theta_2;
        let cos_chain_theta_2_k = -(inverse * sums_2[3]
            + chain_theta_2_k * sin_chain_theta_2);
        let sin_chain_theta_3_k = inverse * sums_2[4]
            + chain_theta_3_k * cos_chain_theta_3;
        let cos_chain_theta_3_k = -(inverse * sums_2[5]
            + chain_theta_3_k * sin_chain_theta_3);
        let sin_chain_theta_4_k = inverse * sums_2[6]
            + chain_theta_4_k * cos_chain_theta_4;
        let cos_chain_theta_4_k = -(inverse * sums_2[7]
            + chain_theta_4_k * sin_chain_theta_4);
        let sin_chain_theta_5_k = inverse * sums_2[8]
            + chain_theta_5_k * cos_chain_theta_5;
        let cos_chain_theta_5_k = -(inverse * sums_2[9]
            + chain_theta_5_k * sin_chain_theta_5);
        let t36_k = sin_chain_theta_1_k * R::literal(49.05);
        let t37_k = sums_3[0] + chain_omega_2 * chain_omega_2_k
            + chain_omega_2_k * chain_omega_2;
        let t38_k = t37_k * R::literal(4.0);
        let t39_k = sums_3[1] + t38 * t1_k + t38_k * t1;
        let t40_k = sums_3[2] + chain_omega_3 * chain_omega_3_k
            + chain_omega_3_k * chain_omega_3;
        let t41_k = t40_k * R::literal(3.0);
        let t42_k = sums_3[3] + t41 * t5_k + t41_k * t5;
        let t43_k = sums_3[4] + chain_omega_4 * chain_omega_4_k
            + chain_omega_4_k * chain_omega_4;
        let t44_k = t43_k * R::literal(2.0);
        let t45_k = sums_3[5] + t44 * t9_k + t44_k * t9;
        let t46_k = sums_3[6] + chain_omega_5 * chain_omega_5_k
            + chain_omega_5_k * chain_omega_5;
        let t47_k = sums_3[7] + t46 * t13_k + t46_k * t13;
        let t48_k = -t36_k;
        let t49_k = t48_k - t39_k;
        let t50_k = t49_k - t42_k;
        let t51_k = t50_k - t45_k;
        let t52_k = t51_k - t47_k;
        let t53_k = sin_chain_theta_2_k * R::literal(39.24);
        let t54_k = sums_3[8] + chain_omega_1 * chain_omega_1_k
            + chain_omega_1_k * chain_omega_1;
        let t55_k = -t1_k;
        let t56_k = t54_k * R::literal(4.0);
        let t57_k = sums_3[9] + t56 * t55_k + t56_k * t55;
        let t58_k = sums_4[0] + t41 * t16_k + t41_k * t16;
        let t59_k = sums_4[1] + t44 * t20_k + t44_k * t20;
        let t60_k = sums_4[2] + t46 * t24_k + t46_k * t24;
        let t61_k = -t53_k;
        let t62_k = t61_k - t57_k;
        let t63_k = t62_k - t58_k;
        let t64_k = t63_k - t59_k;
        let t65_k = t64_k - t60_k;
        let t66_k = sin_chain_theta_3_k * R::literal(29.43);
        let t67_k = -t5_k;
        let t68_k = t54_k * R::literal(3.0);
        let t69_k = sums_4[3] + t68 * t67_k + t68_k * t67;
        let t70_k = -t16_k;
        let t71_k = t37_k * R::literal(3.0);
        let t72_k = sums_4[4] + t71 * t70_k + t71_k * t70;
        let t73_k = sums_4[5] + t44 * t27_k + t44_k * t27;
        let t74_k = sums_4[6] + t46 * t31_k + t46_k * t31;
        let t75_k = -t66_k;
        let t76_k = t75_k - t69_k;
        let t77_k = t76_k - t72_k;
        let t78_k = t77_k - t73_k;
        let t79_k = t78_k - t74_k;
        let t80_k = sin_chain_theta_4_k * R::literal(19.62);
        let t81_k = -t9_k;
        let t82_k = t54_k * R::literal(2.0);
        let t83_k = sums_4[7] + t82 * t81_k + t82_k * t81;
        let t84_k = -t20_k;
        let t85_k = t37_k * R::literal(2.0);
        let t86_k = sums_4[8] + t85 * t84_k + t85_k * t84;
        let t87_k = -t27_k;
        let t88_k = t40_k * R::literal(2.0);
        let t89_k = sums_4[9] + t88 * t87_k + t88_k * t87;
        let t90_k = sums_5[0] + t46 * t34_k + t46_k * t34;
        let t91_k = -t80_k;
        let t92_k = t91_k - t83_k;
        let t93_k = t92_k - t86_k;
        let t94_k = t93_k - t89_k;
        let t95_k = t94_k - t90_k;
        let t96_k = sin_chain_theta_5_k * R::literal(9.81);
        let t97_k = -t13_k;
        let t98_k = sums_5[1] + t54 * t97_k + t54_k * t97;
        let t99_k = -t24_k;
        let t100_k = sums_5[2] + t37 * t99_k + t37_k * t99;
        let t101_k = -t31_k;
        let t102_k = sums_5[3] + t40 * t101_k + t40_k * t101;
        let t103_k = -t34_k;
        let t104_k = sums_5[4] + t43 * t103_k + t43_k * t103;
        let t105_k = -t96_k;
        let t106_k = t105_k - t98_k;
        let t107_k = t106_k - t100_k;
        let t108_k = t107_k - t102_k;
        let t109_k = t108_k - t104_k;
        let n145_k = sums_5[5] + t3_k * chain_omega_2_dot;
        let n146_k = sums_5[6] + t7_k * chain_omega_3_dot;
        let n147_k = sums_5[7] + t11_k * chain_omega_4_dot;
        let n148_k = sums_5[8] + t14_k * chain_omega_5_dot;
        let n149_k = sums_5[9] + t3_k * chain_omega_1_dot;
        let n150_k = sums_6[0] + t18_k * chain_omega_3_dot;
        let n151_k = sums_6[1] + t22_k * chain_omega_4_dot;
        let n152_k = sums_6[2] + t25_k * chain_omega_5_dot;
        let n153_k = sums_6[3] + t7_k * chain_omega_1_dot;
        let n154_k = sums_6[4] + t18_k * chain_omega_2_dot;
        let n155_k = sums_6[5] + t29_k * chain_omega_4_dot;
        let n156_k = sums_6[6] + t32_k * chain_omega_5_dot;
        let n157_k = sums_6[7] + t11_k * chain_omega_1_dot;
        let n158_k = sums_6[8] + t22_k * chain_omega_2_dot;
        let n159_k = sums_6[9] + t29_k * chain_omega_3_dot;
        let n160_k = sums_7[0] + t35_k * chain_omega_5_dot;
        let n161_k = sums_7[1] + t14_k * chain_omega_1_dot;
        let n162_k = sums_7[2] + t25_k * chain_omega_2_dot;
        let n163_k = sums_7[3] + t32_k * chain_omega_3_dot;
        let n164_k = sums_7[4] + t35_k * chain_omega_4_dot;
        let n165_k = n145_k + n146_k;
        let n166_k = n147_k + n148_k;
        let n167_k = n165_k + n166_k;
        let t52_k_2 = t52_k - n167_k;
        let n169_k = n149_k + n150_k;
        let n170_k = n151_k + n152_k;
        let n171_k = n169_k + n170_k;
        let t65_k_2 = t65_k - n171_k;
        let n173_k = n153_k + n154_k;
        let n174_k = n155_k + n156_k;
        let n175_k = n173_k + n174_k;
        let t79_k_2 = t79_k - n175_k;
        let n177_k = n157_k + n158_k;
        let n178_k = n159_k + n160_k;
        let n179_k = n177_k + n178_k;
        let t95_k_2 = t95_k - n179_k;
        let n181_k = n161_k + n162_k;
        let n182_k = n163_k + n164_k;
        let n183_k = n181_k + n182_k;
        let t109_k_2 = t109_k - n183_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k,
        chain_omega_4_dot_k, chain_omega_5_dot_k] = factored
            .solve([t52_k_2, t65_k_2, t79_k_2, t95_k_2, t109_k_2]);
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
                    k * t15_k,
                    k * t15_k,
                ],
                [t2_k, t1_k, t6_k, t5_k, t10_k, t9_k, t14_k, t13_k, t17_k, t16_k],
            );
        lanes_1
            .set(
                order,
                [
                    k * t19_k,
                    k * t19_k,
                    k * t23_k,
                    k * t23_k,
                    k * t26_k,
                    k * t26_k,
                    k * t30_k,
                    k * t30_k,
                    k * t33_k,
                    k * t33_k,
                ],
                [t21_k, t20_k, t25_k, t24_k, t28_k, t27_k, t32_k, t31_k, t35_k, t34_k],
            );
        lanes_2
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
        lanes_3
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
                    chain_omega_1_k,
                    t55_k,
                ],
                [
                    chain_omega_2_k,
                    t38_k,
                    chain_omega_3_k,
                    t41_k,
                    chain_omega_4_k,
                    t44_k,
                    chain_omega_5_k,
                    t46_k,
                    chain_omega_1_k,
                    t56_k,
                ],
            );
        lanes_4
            .set(
                order,
                [t16_k, t20_k, t24_k, t67_k, t70_k, t27_k, t31_k, t81_k, t84_k, t87_k],
                [t41_k, t44_k, t46_k, t68_k, t71_k, t44_k, t46_k, t82_k, t85_k, t88_k],
            );
        lanes_5
            .set(
                order,
                [t34_k, t54_k, t37_k, t40_k, t43_k, t3_k, t7_k, t11_k, t14_k, t3_k],
                [
                    t46_k,
                    t97_k,
                    t99_k,
                    t101_k,
                    t103_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_6
            .set(
                order,
                [t18_k, t22_k, t25_k, t7_k, t18_k, t29_k, t32_k, t11_k, t22_k, t29_k],
                [
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                ],
            );
        lanes_7
            .set(
                order,
                [t35_k, t14_k, t25_k, t32_k, t35_k],
                [
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                ],
            );
        rates = [
            chain_omega_1_k,
            chain_omega_2_k,
            chain_omega_3_k,
            chain_omega_4_k,
            chain_omega_5_k,
            chain_omega_1_dot_k,
            chain_omega_2_dot_k,
            chain_omega_3_dot_k,
            chain_omega_4_dot_k,
            chain_omega_5_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M65 {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 10>::workspace(order + 1)
            + Lanes::<R, 10>::workspace(order + 1) + Lanes::<R, 5>::workspace(order + 1)
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

impl Describe for M65 {
    fn name(&self) -> &'static str {
        "m6_5"
    }
    fn title(&self) -> &'static str {
        "Benchmark M6: planar pendulum of 5 links"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 5,
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

impl<R: Real> Simulator<R> for M65 {
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
];

static STATE_SCALES: [f64; STATES] = [1.0, 1.0, 1.0, 1.0, 1.0, 5.0, 5.0, 5.0, 5.0, 5.0];

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
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 5.0,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

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
//   rate                    235
//   mass_matrix              26
//   forcing                  85
//   rate_jacobian           826
//   parameter_jacobian        0
//   time_derivative           0
//   outputs                   0
//   energy                   58
//   power_balance           397

use ::machinist_contract::{
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
        (0, 0), (0, 1), (0, 2), (0, 3), (0, 4), (1, 0), (1, 1), (1, 2), (1, 3), (1, 4), (2, 0),
        (2, 1), (2, 2), (2, 3), (2, 4), (3, 0), (3, 1), (3, 2), (3, 3), (3, 4), (4, 0), (4, 1),
        (4, 2), (4, 3), (4, 4),
    ],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 10,
    columns: 10,
    entries: &[
        (0, 5), (1, 6), (2, 7), (3, 8), (4, 9), (5, 0), (5, 1), (5, 2), (5, 3), (5, 4), (5, 5),
        (5, 6), (5, 7), (5, 8), (5, 9), (6, 0), (6, 1), (6, 2), (6, 3), (6, 4), (6, 5), (6, 6),
        (6, 7), (6, 8), (6, 9), (7, 0), (7, 1), (7, 2), (7, 3), (7, 4), (7, 5), (7, 6), (7, 7),
        (7, 8), (7, 9), (8, 0), (8, 1), (8, 2), (8, 3), (8, 4), (8, 5), (8, 6), (8, 7), (8, 8),
        (8, 9), (9, 0), (9, 1), (9, 2), (9, 3), (9, 4), (9, 5), (9, 6), (9, 7), (9, 8), (9, 9),
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
/// 235 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
    (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_3,
        chain_theta_4,
        chain_theta_5,
    ]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2)
        .sub_product(cos_chain_theta_1, sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2)
        .add_product(sin_chain_theta_1, sin_chain_theta_2);
    let t2 = R::literal(4.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3)
        .sub_product(cos_chain_theta_1, sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3)
        .add_product(sin_chain_theta_1, sin_chain_theta_3);
    let t5 = R::literal(3.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_1, sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4)
        .add_product(sin_chain_theta_1, sin_chain_theta_4);
    let t8 = R::literal(2.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_1, sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5)
        .add_product(sin_chain_theta_1, sin_chain_theta_5);
    let t11 = (sin_chain_theta_2 * cos_chain_theta_3)
        .sub_product(cos_chain_theta_2, sin_chain_theta_3);
    let t12 = (sin_chain_theta_2 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_2, sin_chain_theta_4);
    let t13 = (sin_chain_theta_2 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_2, sin_chain_theta_5);
    let t14 = (sin_chain_theta_3 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_3, sin_chain_theta_4);
    let t15 = (sin_chain_theta_3 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_3, sin_chain_theta_5);
    let t16 = (sin_chain_theta_4 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_4, sin_chain_theta_5);
    let t17 = R::literal(0.8) * t1;
    let t18 = R::literal(0.600_000_000_000_000_1) * t4;
    let t19 = R::literal(0.4) * t7;
    let t20 = t10 * R::literal(0.2);
    let t21 = R::literal(1.0) / R::literal(4.0).sub_product(t17, t2);
    let t22 = (R::literal(3.0)
        * (cos_chain_theta_2 * cos_chain_theta_3)
            .add_product(sin_chain_theta_2, sin_chain_theta_3))
        .sub_product(t18, t2);
    let t23 = t22 * t21;
    let t24 = (R::literal(2.0)
        * (cos_chain_theta_2 * cos_chain_theta_4)
            .add_product(sin_chain_theta_2, sin_chain_theta_4))
        .sub_product(t19, t2);
    let t25 = t24 * t21;
    let t26 = (cos_chain_theta_2 * cos_chain_theta_5)
        .add_product(sin_chain_theta_2, sin_chain_theta_5)
        .sub_product(t20, t2);
    let t27 = t26 * t21;
    let t28 = R::literal(1.0)
        / R::literal(3.0).sub_product(t18, t5).sub_product(t23, t22);
    let t29 = (R::literal(2.0)
        * (cos_chain_theta_3 * cos_chain_theta_4)
            .add_product(sin_chain_theta_3, sin_chain_theta_4))
        .sub_product(t19, t5)
        .sub_product(t25, t22);
    let t30 = t29 * t28;
    let t31 = (cos_chain_theta_3 * cos_chain_theta_5)
        .add_product(sin_chain_theta_3, sin_chain_theta_5)
        .sub_product(t20, t5)
        .sub_product(t27, t22);
    let t32 = t31 * t28;
    let t33 = R::literal(1.0)
        / R::literal(2.0)
            .sub_product(t19, t8)
            .sub_product(t25, t24)
            .sub_product(t30, t29);
    let t34 = (cos_chain_theta_4 * cos_chain_theta_5)
        .add_product(sin_chain_theta_4, sin_chain_theta_5)
        .sub_product(t20, t8)
        .sub_product(t27, t24)
        .sub_product(t32, t29);
    let t35 = t34 * t33;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t36 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t37 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t38 = (-(R::literal(49.05) * sin_chain_theta_1))
        .sub_product(R::literal(4.0) * chain_omega_2_squared, t0)
        .sub_product(t36, t3)
        .sub_product(t37, t6)
        .sub_product(chain_omega_5_squared, t9);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t39 = (-(R::literal(39.24) * sin_chain_theta_2))
        .add_product(R::literal(4.0) * chain_omega_1_squared, t0)
        .sub_product(t36, t11)
        .sub_product(t37, t12)
        .sub_product(chain_omega_5_squared, t13)
        .sub_product(t17, t38);
    let t40 = (R::literal(3.0) * chain_omega_1_squared * t3)
        .add_product(R::literal(3.0) * chain_omega_2_squared, t11)
        .sub_product(R::literal(29.43), sin_chain_theta_3)
        .sub_product(t37, t14)
        .sub_product(chain_omega_5_squared, t15)
        .sub_product(t18, t38)
        .sub_product(t23, t39);
    let t41 = (R::literal(2.0) * chain_omega_1_squared * t6)
        .add_product(R::literal(2.0) * chain_omega_2_squared, t12)
        .add_product(R::literal(2.0) * chain_omega_3_squared, t14)
        .sub_product(R::literal(19.62), sin_chain_theta_4)
        .sub_product(chain_omega_5_squared, t16)
        .sub_product(t19, t38)
        .sub_product(t25, t39)
        .sub_product(t30, t40);
    let chain_omega_5_dot = (chain_omega_1_squared * t9)
        .add_product(chain_omega_2_squared, t13)
        .add_product(chain_omega_3_squared, t15)
        .add_product(chain_omega_4_squared, t16)
        .sub_product(R::literal(9.81), sin_chain_theta_5)
        .sub_product(t20, t38)
        .sub_product(t27, t39)
        .sub_product(t32, t40)
        .sub_product(t35, t41)
        * (R::literal(1.0)
            / R::literal(1.0)
                .sub_product(t20, t10)
                .sub_product(t27, t26)
                .sub_product(t32, t31)
                .sub_product(t35, t34));
    let chain_omega_4_dot = (t41 * t33).sub_product(t35, chain_omega_5_dot);
    let chain_omega_3_dot = (t40 * t28)
        .sub_product(t30, chain_omega_4_dot)
        .sub_product(t32, chain_omega_5_dot);
    let chain_omega_2_dot = (t39 * t21)
        .sub_product(t23, chain_omega_3_dot)
        .sub_product(t25, chain_omega_4_dot)
        .sub_product(t27, chain_omega_5_dot);
    let chain_omega_1_dot = (t38 * R::literal(0.2))
        .sub_product(t17, chain_omega_2_dot)
        .sub_product(t18, chain_omega_3_dot)
        .sub_product(t19, chain_omega_4_dot)
        .sub_product(t20, chain_omega_5_dot);
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
    let [(_, t0), (_, t1), (_, t2), (_, t3), (_, t4), (_, t5), (_, t6), (_, t7), (_, t8),
    (_, t9)] = R::sin_cos_each([
        chain_theta_1 - chain_theta_2,
        chain_theta_1 - chain_theta_3,
        chain_theta_1 - chain_theta_4,
        chain_theta_1 - chain_theta_5,
        chain_theta_2 - chain_theta_3,
        chain_theta_2 - chain_theta_4,
        chain_theta_2 - chain_theta_5,
        chain_theta_3 - chain_theta_4,
        chain_theta_3 - chain_theta_5,
        chain_theta_4 - chain_theta_5,
    ]);
    let t10 = R::literal(4.0) * t0;
    let t11 = R::literal(3.0) * t1;
    let t12 = R::literal(2.0) * t2;
    let t13 = R::literal(3.0) * t4;
    let t14 = R::literal(2.0) * t5;
    let t15 = R::literal(2.0) * t7;
    [
        R::literal(5.0),
        t10,
        t11,
        t12,
        t3,
        t10,
        R::literal(4.0),
        t13,
        t14,
        t6,
        t11,
        t13,
        R::literal(3.0),
        t15,
        t8,
        t12,
        t14,
        t15,
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
/// 85 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, _), (sin_chain_theta_2, _), (sin_chain_theta_3, _),
    (sin_chain_theta_4, _), (sin_chain_theta_5, _), (t0, _), (t1, _), (t2, _), (t3, _),
    (t4, _), (t5, _), (t6, _), (t7, _), (t8, _), (t9, _)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_3,
        chain_theta_4,
        chain_theta_5,
        chain_theta_1 - chain_theta_2,
        chain_theta_1 - chain_theta_3,
        chain_theta_1 - chain_theta_4,
        chain_theta_1 - chain_theta_5,
        chain_theta_2 - chain_theta_3,
        chain_theta_2 - chain_theta_4,
        chain_theta_2 - chain_theta_5,
        chain_theta_3 - chain_theta_4,
        chain_theta_3 - chain_theta_5,
        chain_theta_4 - chain_theta_5,
    ]);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t10 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t11 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let chain_theta_1_forcing = (-(R::literal(49.05) * sin_chain_theta_1))
        .sub_product(R::literal(4.0) * chain_omega_2_squared, t0)
        .sub_product(t10, t1)
        .sub_product(t11, t2)
        .sub_product(chain_omega_5_squared, t3);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let chain_theta_2_forcing = (-(R::literal(39.24) * sin_chain_theta_2))
        .add_product(R::literal(4.0) * chain_omega_1_squared, t0)
        .sub_product(t10, t4)
        .sub_product(t11, t5)
        .sub_product(chain_omega_5_squared, t6);
    let chain_theta_3_forcing = (R::literal(3.0) * chain_omega_1_squared * t1)
        .add_product(R::literal(3.0) * chain_omega_2_squared, t4)
        .sub_product(R::literal(29.43), sin_chain_theta_3)
        .sub_product(t11, t7)
        .sub_product(chain_omega_5_squared, t8);
    let chain_theta_4_forcing = (R::literal(2.0) * chain_omega_1_squared * t2)
        .add_product(R::literal(2.0) * chain_omega_2_squared, t5)
        .add_product(R::literal(2.0) * chain_omega_3_squared, t7)
        .sub_product(R::literal(19.62), sin_chain_theta_4)
        .sub_product(chain_omega_5_squared, t9);
    let chain_theta_5_forcing = (chain_omega_1_squared * t3)
        .add_product(chain_omega_2_squared, t6)
        .add_product(chain_omega_3_squared, t8)
        .add_product(chain_omega_4_squared, t9)
        .sub_product(R::literal(9.81), sin_chain_theta_5);
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
/// 826 operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 55] {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
    (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_3,
        chain_theta_4,
        chain_theta_5,
    ]);
    let t0 = (sin_chain_theta_1 * cos_chain_theta_2)
        .sub_product(cos_chain_theta_1, sin_chain_theta_2);
    let t1 = (cos_chain_theta_1 * cos_chain_theta_2)
        .add_product(sin_chain_theta_1, sin_chain_theta_2);
    let t2 = R::literal(4.0) * t1;
    let t3 = (sin_chain_theta_1 * cos_chain_theta_3)
        .sub_product(cos_chain_theta_1, sin_chain_theta_3);
    let t4 = (cos_chain_theta_1 * cos_chain_theta_3)
        .add_product(sin_chain_theta_1, sin_chain_theta_3);
    let t5 = R::literal(3.0) * t4;
    let t6 = (sin_chain_theta_1 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_1, sin_chain_theta_4);
    let t7 = (cos_chain_theta_1 * cos_chain_theta_4)
        .add_product(sin_chain_theta_1, sin_chain_theta_4);
    let t8 = R::literal(2.0) * t7;
    let t9 = (sin_chain_theta_1 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_1, sin_chain_theta_5);
    let t10 = (cos_chain_theta_1 * cos_chain_theta_5)
        .add_product(sin_chain_theta_1, sin_chain_theta_5);
    let t11 = (sin_chain_theta_2 * cos_chain_theta_3)
        .sub_product(cos_chain_theta_2, sin_chain_theta_3);
    let t12 = (cos_chain_theta_2 * cos_chain_theta_3)
        .add_product(sin_chain_theta_2, sin_chain_theta_3);
    let t13 = (sin_chain_theta_2 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_2, sin_chain_theta_4);
    let t14 = (cos_chain_theta_2 * cos_chain_theta_4)
        .add_product(sin_chain_theta_2, sin_chain_theta_4);
    let t15 = (sin_chain_theta_2 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_2, sin_chain_theta_5);
    let t16 = (cos_chain_theta_2 * cos_chain_theta_5)
        .add_product(sin_chain_theta_2, sin_chain_theta_5);
    let t17 = (sin_chain_theta_3 * cos_chain_theta_4)
        .sub_product(cos_chain_theta_3, sin_chain_theta_4);
    let t18 = (cos_chain_theta_3 * cos_chain_theta_4)
        .add_product(sin_chain_theta_3, sin_chain_theta_4);
    let t19 = (sin_chain_theta_3 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_3, sin_chain_theta_5);
    let t20 = (cos_chain_theta_3 * cos_chain_theta_5)
        .add_product(sin_chain_theta_3, sin_chain_theta_5);
    let t21 = (sin_chain_theta_4 * cos_chain_theta_5)
        .sub_product(cos_chain_theta_4, sin_chain_theta_5);
    let t22 = (cos_chain_theta_4 * cos_chain_theta_5)
        .add_product(sin_chain_theta_4, sin_chain_theta_5);
    let t23 = R::literal(0.8) * t1;
    let t24 = R::literal(0.600_000_000_000_000_1) * t4;
    let t25 = R::literal(0.4) * t7;
    let t26 = t10 * R::literal(0.2);
    let t27 = R::literal(1.0) / R::literal(4.0).sub_product(t23, t2);
    let t28 = (R::literal(3.0) * t12).sub_product(t24, t2);
    let t29 = t28 * t27;
    let t30 = (R::literal(2.0) * t14).sub_product(t25, t2);
    let t31 = t30 * t27;
    let t32 = t16.sub_product(t26, t2);
    let t33 = t32 * t27;
    let t34 = R::literal(1.0)
        / R::literal(3.0).sub_product(t24, t5).sub_product(t29, t28);
    let t35 = (R::literal(2.0) * t18).sub_product(t25, t5).sub_product(t31, t28);
    let t36 = t35 * t34;
    let t37 = t20.sub_product(t26, t5).sub_product(t33, t28);
    let t38 = t37 * t34;
    let t39 = R::literal(1.0)
        / R::literal(2.0)
            .sub_product(t25, t8)
            .sub_product(t31, t30)
            .sub_product(t36, t35);
    let t40 = t22.sub_product(t26, t8).sub_product(t33, t30).sub_product(t38, t35);
    let t41 = t40 * t39;
    let t42 = R::literal(1.0)
        / R::literal(1.0)
            .sub_product(t26, t10)
            .sub_product(t33, t32)
            .sub_product(t38, t37)
            .sub_product(t41, t40);
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let t43 = R::literal(4.0) * chain_omega_2_squared;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t44 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t45 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t46 = (-(R::literal(49.05) * sin_chain_theta_1))
        .sub_product(t43, t0)
        .sub_product(t44, t3)
        .sub_product(t45, t6)
        .sub_product(chain_omega_5_squared, t9);
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t47 = R::literal(4.0) * chain_omega_1_squared;
    let t48 = R::literal(3.0) * chain_omega_1_squared;
    let t49 = R::literal(3.0) * chain_omega_2_squared;
    let t50 = R::literal(2.0) * chain_omega_1_squared;
    let t51 = R::literal(2.0) * chain_omega_2_squared;
    let t52 = R::literal(2.0) * chain_omega_3_squared;
    let t53 = (-(R::literal(39.24) * sin_chain_theta_2))
        .add_product(t47, t0)
        .sub_product(t44, t11)
        .sub_product(t45, t13)
        .sub_product(chain_omega_5_squared, t15)
        .sub_product(t23, t46);
    let t54 = (t48 * t3)
        .add_product(t49, t11)
        .sub_product(R::literal(29.43), sin_chain_theta_3)
        .sub_product(t45, t17)
        .sub_product(chain_omega_5_squared, t19)
        .sub_product(t24, t46)
        .sub_product(t29, t53);
    let t55 = (t50 * t6)
        .add_product(t51, t13)
        .add_product(t52, t17)
        .sub_product(R::literal(19.62), sin_chain_theta_4)
        .sub_product(chain_omega_5_squared, t21)
        .sub_product(t25, t46)
        .sub_product(t31, t53)
        .sub_product(t36, t54);
    let chain_omega_5_dot = (chain_omega_1_squared * t9)
        .add_product(chain_omega_2_squared, t15)
        .add_product(chain_omega_3_squared, t19)
        .add_product(chain_omega_4_squared, t21)
        .sub_product(R::literal(9.81), sin_chain_theta_5)
        .sub_product(t26, t46)
        .sub_product(t33, t53)
        .sub_product(t38, t54)
        .sub_product(t41, t55) * t42;
    let chain_omega_4_dot = (t55 * t39).sub_product(t41, chain_omega_5_dot);
    let chain_omega_3_dot = (t54 * t34)
        .sub_product(t36, chain_omega_4_dot)
        .sub_product(t38, chain_omega_5_dot);
    let chain_omega_2_dot = (t53 * t27)
        .sub_product(t29, chain_omega_3_dot)
        .sub_product(t31, chain_omega_4_dot)
        .sub_product(t33, chain_omega_5_dot);
    let chain_omega_1_dot = (t46 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot)
        .sub_product(t24, chain_omega_3_dot)
        .sub_product(t25, chain_omega_4_dot)
        .sub_product(t26, chain_omega_5_dot);
    let t56 = t43 * t1;
    let t57 = t44 * t4;
    let t58 = t45 * t7;
    let t59 = chain_omega_5_squared * t10;
    let t60 = t47 * t1;
    let t61 = t48 * t4;
    let t62 = t50 * t7;
    let t63 = chain_omega_1_squared * t10;
    let t64 = R::literal(4.0) * t0;
    let t65 = t64 * chain_omega_2_dot;
    let t66 = t64 * chain_omega_1_dot;
    let t67 = R::literal(3.0) * t3;
    let t68 = t67 * chain_omega_3_dot;
    let t69 = t67 * chain_omega_1_dot;
    let t70 = R::literal(2.0) * t6;
    let t71 = t70 * chain_omega_4_dot;
    let t72 = t70 * chain_omega_1_dot;
    let t73 = t9 * chain_omega_5_dot;
    let t74 = (-t56).sub_product(R::literal(49.05), cos_chain_theta_1) - t57 - t58 - t59
        + t65 + t68 + t71 + t73;
    let t75 = t9 * chain_omega_1_dot;
    let t76 = (t60 + t66).sub_product(t23, t74);
    let t77 = (t61 + t69).sub_product(t24, t74).sub_product(t29, t76);
    let t78 = (t62 + t72)
        .sub_product(t25, t74)
        .sub_product(t31, t76)
        .sub_product(t36, t77);
    let chain_omega_5_dot_by_chain_theta_1 = (t63 + t75)
        .sub_product(t26, t74)
        .sub_product(t33, t76)
        .sub_product(t38, t77)
        .sub_product(t41, t78) * t42;
    let chain_omega_4_dot_by_chain_theta_1 = (t78 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_3_dot_by_chain_theta_1 = (t77 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_theta_1)
        .sub_product(t38, chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_2_dot_by_chain_theta_1 = (t76 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_theta_1)
        .sub_product(t31, chain_omega_4_dot_by_chain_theta_1)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_1);
    let chain_omega_1_dot_by_chain_theta_1 = (t74 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot_by_chain_theta_1)
        .sub_product(t24, chain_omega_3_dot_by_chain_theta_1)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_1)
        .sub_product(t26, chain_omega_5_dot_by_chain_theta_1);
    let t79 = t44 * t12;
    let t80 = t45 * t14;
    let t81 = chain_omega_5_squared * t16;
    let t82 = t49 * t12;
    let t83 = t51 * t14;
    let t84 = chain_omega_2_squared * t16;
    let t85 = t56 - t65;
    let t86 = R::literal(3.0) * t11;
    let t87 = t86 * chain_omega_3_dot;
    let t88 = t86 * chain_omega_2_dot;
    let t89 = R::literal(2.0) * t13;
    let t90 = t89 * chain_omega_4_dot;
    let t91 = t89 * chain_omega_2_dot;
    let t92 = t15 * chain_omega_5_dot;
    let t93 = t15 * chain_omega_2_dot;
    let t94 = ((-t60).sub_product(R::literal(39.24), cos_chain_theta_2) - t79 - t80 - t81
        - t66 + t87 + t90 + t92)
        .sub_product(t23, t85);
    let t95 = (t82 + t88).sub_product(t24, t85).sub_product(t29, t94);
    let t96 = (t83 + t91)
        .sub_product(t25, t85)
        .sub_product(t31, t94)
        .sub_product(t36, t95);
    let chain_omega_5_dot_by_chain_theta_2 = (t84 + t93)
        .sub_product(t26, t85)
        .sub_product(t33, t94)
        .sub_product(t38, t95)
        .sub_product(t41, t96) * t42;
    let chain_omega_4_dot_by_chain_theta_2 = (t96 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_3_dot_by_chain_theta_2 = (t95 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_theta_2)
        .sub_product(t38, chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_2_dot_by_chain_theta_2 = (t94 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_theta_2)
        .sub_product(t31, chain_omega_4_dot_by_chain_theta_2)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_2);
    let chain_omega_1_dot_by_chain_theta_2 = (t85 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot_by_chain_theta_2)
        .sub_product(t24, chain_omega_3_dot_by_chain_theta_2)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_2)
        .sub_product(t26, chain_omega_5_dot_by_chain_theta_2);
    let t97 = t45 * t18;
    let t98 = chain_omega_5_squared * t20;
    let t99 = t52 * t18;
    let t100 = chain_omega_3_squared * t20;
    let t101 = t57 - t68;
    let t102 = R::literal(2.0) * t17;
    let t103 = t102 * chain_omega_4_dot;
    let t104 = t102 * chain_omega_3_dot;
    let t105 = t19 * chain_omega_5_dot;
    let t106 = t19 * chain_omega_3_dot;
    let t107 = (t79 - t87).sub_product(t23, t101);
    let t108 = ((-t61).sub_product(R::literal(29.43), cos_chain_theta_3) - t82 - t97
        - t98 - t69 - t88 + t103 + t105)
        .sub_product(t24, t101)
        .sub_product(t29, t107);
    let t109 = (t99 + t104)
        .sub_product(t25, t101)
        .sub_product(t31, t107)
        .sub_product(t36, t108);
    let chain_omega_5_dot_by_chain_theta_3 = (t100 + t106)
        .sub_product(t26, t101)
        .sub_product(t33, t107)
        .sub_product(t38, t108)
        .sub_product(t41, t109) * t42;
    let chain_omega_4_dot_by_chain_theta_3 = (t109 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_3_dot_by_chain_theta_3 = (t108 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_theta_3)
        .sub_product(t38, chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_2_dot_by_chain_theta_3 = (t107 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_theta_3)
        .sub_product(t31, chain_omega_4_dot_by_chain_theta_3)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_3);
    let chain_omega_1_dot_by_chain_theta_3 = (t101 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot_by_chain_theta_3)
        .sub_product(t24, chain_omega_3_dot_by_chain_theta_3)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_3)
        .sub_product(t26, chain_omega_5_dot_by_chain_theta_3);
    let t110 = chain_omega_5_squared * t22;
    let t111 = chain_omega_4_squared * t22;
    let t112 = t58 - t71;
    let t113 = t21 * chain_omega_5_dot;
    let t114 = t21 * chain_omega_4_dot;
    let t115 = (t80 - t90).sub_product(t23, t112);
    let t116 = (t97 - t103).sub_product(t24, t112).sub_product(t29, t115);
    let t117 = ((-t62).sub_product(R::literal(19.62), cos_chain_theta_4) - t83 - t99
        - t110 - t72 - t91 - t104 + t113)
        .sub_product(t25, t112)
        .sub_product(t31, t115)
        .sub_product(t36, t116);
    let chain_omega_5_dot_by_chain_theta_4 = (t111 + t114)
        .sub_product(t26, t112)
        .sub_product(t33, t115)
        .sub_product(t38, t116)
        .sub_product(t41, t117) * t42;
    let chain_omega_4_dot_by_chain_theta_4 = (t117 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_3_dot_by_chain_theta_4 = (t116 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_theta_4)
        .sub_product(t38, chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_2_dot_by_chain_theta_4 = (t115 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_theta_4)
        .sub_product(t31, chain_omega_4_dot_by_chain_theta_4)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_4);
    let chain_omega_1_dot_by_chain_theta_4 = (t112 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot_by_chain_theta_4)
        .sub_product(t24, chain_omega_3_dot_by_chain_theta_4)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_4)
        .sub_product(t26, chain_omega_5_dot_by_chain_theta_4);
    let t118 = t59 - t73;
    let t119 = (t81 - t92).sub_product(t23, t118);
    let t120 = (t98 - t105).sub_product(t24, t118).sub_product(t29, t119);
    let t121 = (t110 - t113)
        .sub_product(t25, t118)
        .sub_product(t31, t119)
        .sub_product(t36, t120);
    let chain_omega_5_dot_by_chain_theta_5 = ((-t63)
        .sub_product(R::literal(9.81), cos_chain_theta_5) - t84 - t100 - t111 - t75 - t93
        - t106 - t114)
        .sub_product(t26, t118)
        .sub_product(t33, t119)
        .sub_product(t38, t120)
        .sub_product(t41, t121) * t42;
    let chain_omega_4_dot_by_chain_theta_5 = (t121 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_3_dot_by_chain_theta_5 = (t120 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_theta_5)
        .sub_product(t38, chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_2_dot_by_chain_theta_5 = (t119 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_theta_5)
        .sub_product(t31, chain_omega_4_dot_by_chain_theta_5)
        .sub_product(t33, chain_omega_5_dot_by_chain_theta_5);
    let chain_omega_1_dot_by_chain_theta_5 = (t118 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot_by_chain_theta_5)
        .sub_product(t24, chain_omega_3_dot_by_chain_theta_5)
        .sub_product(t25, chain_omega_4_dot_by_chain_theta_5)
        .sub_product(t26, chain_omega_5_dot_by_chain_theta_5);
    let t122 = R::literal(8.0) * chain_omega_1 * t0;
    let t123 = (R::literal(6.0) * chain_omega_1 * t3).sub_product(t29, t122);
    let t124 = (R::literal(4.0) * chain_omega_1 * t6)
        .sub_product(t31, t122)
        .sub_product(t36, t123);
    let chain_omega_5_dot_by_chain_omega_1 = (R::literal(2.0) * chain_omega_1 * t9)
        .sub_product(t33, t122)
        .sub_product(t38, t123)
        .sub_product(t41, t124) * t42;
    let chain_omega_4_dot_by_chain_omega_1 = (t124 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_3_dot_by_chain_omega_1 = (t123 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_omega_1)
        .sub_product(t38, chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_2_dot_by_chain_omega_1 = (t122 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_omega_1)
        .sub_product(t31, chain_omega_4_dot_by_chain_omega_1)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_1);
    let chain_omega_1_dot_by_chain_omega_1 = (-(t24
        * chain_omega_3_dot_by_chain_omega_1))
        .sub_product(t23, chain_omega_2_dot_by_chain_omega_1)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_1)
        .sub_product(t26, chain_omega_5_dot_by_chain_omega_1);
    let t125 = R::literal(8.0) * chain_omega_2 * t0;
    let t126 = t23 * t125;
    let t127 = (R::literal(6.0) * chain_omega_2 * t11)
        .add_product(t24, t125)
        .sub_product(t29, t126);
    let t128 = (R::literal(4.0) * chain_omega_2 * t13)
        .add_product(t25, t125)
        .sub_product(t31, t126)
        .sub_product(t36, t127);
    let chain_omega_5_dot_by_chain_omega_2 = (R::literal(2.0) * chain_omega_2 * t15)
        .add_product(t26, t125)
        .sub_product(t33, t126)
        .sub_product(t38, t127)
        .sub_product(t41, t128) * t42;
    let chain_omega_4_dot_by_chain_omega_2 = (t128 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_3_dot_by_chain_omega_2 = (t127 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_omega_2)
        .sub_product(t38, chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_2_dot_by_chain_omega_2 = (t126 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_omega_2)
        .sub_product(t31, chain_omega_4_dot_by_chain_omega_2)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_2);
    let chain_omega_1_dot_by_chain_omega_2 = (-(t125 * R::literal(0.2)))
        .sub_product(t23, chain_omega_2_dot_by_chain_omega_2)
        .sub_product(t24, chain_omega_3_dot_by_chain_omega_2)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_2)
        .sub_product(t26, chain_omega_5_dot_by_chain_omega_2);
    let t129 = R::literal(6.0) * chain_omega_3;
    let t130 = t129 * t3;
    let t131 = (-(t129 * t11)).add_product(t23, t130);
    let t132 = (t24 * t130).sub_product(t29, t131);
    let t133 = (R::literal(4.0) * chain_omega_3 * t17)
        .add_product(t25, t130)
        .sub_product(t31, t131)
        .sub_product(t36, t132);
    let chain_omega_5_dot_by_chain_omega_3 = (R::literal(2.0) * chain_omega_3 * t19)
        .add_product(t26, t130)
        .sub_product(t33, t131)
        .sub_product(t38, t132)
        .sub_product(t41, t133) * t42;
    let chain_omega_4_dot_by_chain_omega_3 = (t133 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_3_dot_by_chain_omega_3 = (t132 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_omega_3)
        .sub_product(t38, chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_2_dot_by_chain_omega_3 = (t131 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_omega_3)
        .sub_product(t31, chain_omega_4_dot_by_chain_omega_3)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_3);
    let chain_omega_1_dot_by_chain_omega_3 = (-(t130 * R::literal(0.2)))
        .sub_product(t23, chain_omega_2_dot_by_chain_omega_3)
        .sub_product(t24, chain_omega_3_dot_by_chain_omega_3)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_3)
        .sub_product(t26, chain_omega_5_dot_by_chain_omega_3);
    let t134 = R::literal(4.0) * chain_omega_4;
    let t135 = t134 * t6;
    let t136 = (-(t134 * t13)).add_product(t23, t135);
    let t137 = (-(t134 * t17)).add_product(t24, t135).sub_product(t29, t136);
    let t138 = (t25 * t135).sub_product(t31, t136).sub_product(t36, t137);
    let chain_omega_5_dot_by_chain_omega_4 = (R::literal(2.0) * chain_omega_4 * t21)
        .add_product(t26, t135)
        .sub_product(t33, t136)
        .sub_product(t38, t137)
        .sub_product(t41, t138) * t42;
    let chain_omega_4_dot_by_chain_omega_4 = (t138 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_3_dot_by_chain_omega_4 = (t137 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_omega_4)
        .sub_product(t38, chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_2_dot_by_chain_omega_4 = (t136 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_omega_4)
        .sub_product(t31, chain_omega_4_dot_by_chain_omega_4)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_4);
    let chain_omega_1_dot_by_chain_omega_4 = (-(t135 * R::literal(0.2)))
        .sub_product(t23, chain_omega_2_dot_by_chain_omega_4)
        .sub_product(t24, chain_omega_3_dot_by_chain_omega_4)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_4)
        .sub_product(t26, chain_omega_5_dot_by_chain_omega_4);
    let t139 = R::literal(2.0) * chain_omega_5;
    let t140 = t139 * t9;
    let t141 = (-(t139 * t15)).add_product(t23, t140);
    let t142 = (-(t139 * t19)).add_product(t24, t140).sub_product(t29, t141);
    let t143 = (-(t139 * t21))
        .add_product(t25, t140)
        .sub_product(t31, t141)
        .sub_product(t36, t142);
    let chain_omega_5_dot_by_chain_omega_5 = (t26 * t140)
        .sub_product(t33, t141)
        .sub_product(t38, t142)
        .sub_product(t41, t143) * t42;
    let chain_omega_4_dot_by_chain_omega_5 = (t143 * t39)
        .sub_product(t41, chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_3_dot_by_chain_omega_5 = (t142 * t34)
        .sub_product(t36, chain_omega_4_dot_by_chain_omega_5)
        .sub_product(t38, chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_2_dot_by_chain_omega_5 = (t141 * t27)
        .sub_product(t29, chain_omega_3_dot_by_chain_omega_5)
        .sub_product(t31, chain_omega_4_dot_by_chain_omega_5)
        .sub_product(t33, chain_omega_5_dot_by_chain_omega_5);
    let chain_omega_1_dot_by_chain_omega_5 = (-(t140 * R::literal(0.2)))
        .sub_product(t23, chain_omega_2_dot_by_chain_omega_5)
        .sub_product(t24, chain_omega_3_dot_by_chain_omega_5)
        .sub_product(t25, chain_omega_4_dot_by_chain_omega_5)
        .sub_product(t26, chain_omega_5_dot_by_chain_omega_5);
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
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
    (sin_chain_theta_5, cos_chain_theta_5)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_3,
        chain_theta_4,
        chain_theta_5,
    ]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let chain_u_3 = chain_u_2.add_product(chain_omega_3, cos_chain_theta_3);
    let chain_v_3 = chain_v_2.add_product(chain_omega_3, sin_chain_theta_3);
    let chain_u_4 = chain_u_3.add_product(chain_omega_4, cos_chain_theta_4);
    let chain_v_4 = chain_v_3.add_product(chain_omega_4, sin_chain_theta_4);
    let chain_u_5 = chain_u_4.add_product(chain_omega_5, cos_chain_theta_5);
    let chain_v_5 = chain_v_4.add_product(chain_omega_5, sin_chain_theta_5);
    Energy {
        kinetic: R::literal(0.5)
            * (chain_u_1 * chain_u_1)
                .add_product(chain_v_1, chain_v_1)
                .add_product(chain_u_2, chain_u_2)
                .add_product(chain_v_2, chain_v_2)
                .add_product(chain_u_3, chain_u_3)
                .add_product(chain_v_3, chain_v_3)
                .add_product(chain_u_4, chain_u_4)
                .add_product(chain_v_4, chain_v_4)
                .add_product(chain_u_5, chain_u_5)
                .add_product(chain_v_5, chain_v_5),
        potential: R::literal(9.81)
            * ((-(R::literal(4.0) * cos_chain_theta_2))
                .sub_product(R::literal(5.0), cos_chain_theta_1)
                .sub_product(R::literal(3.0), cos_chain_theta_3)
                .sub_product(R::literal(2.0), cos_chain_theta_4) - cos_chain_theta_5),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 397 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [chain_theta_1, chain_theta_2, chain_theta_3, chain_theta_4, chain_theta_5,
    chain_omega_1, chain_omega_2, chain_omega_3, chain_omega_4, chain_omega_5] = *state;
    let chain_theta_1_minus_chain_theta_2 = chain_theta_1 - chain_theta_2;
    let chain_theta_1_minus_chain_theta_3 = chain_theta_1 - chain_theta_3;
    let chain_theta_1_minus_chain_theta_4 = chain_theta_1 - chain_theta_4;
    let chain_theta_1_minus_chain_theta_5 = chain_theta_1 - chain_theta_5;
    let chain_theta_2_minus_chain_theta_3 = chain_theta_2 - chain_theta_3;
    let chain_theta_2_minus_chain_theta_4 = chain_theta_2 - chain_theta_4;
    let chain_theta_2_minus_chain_theta_5 = chain_theta_2 - chain_theta_5;
    let chain_theta_3_minus_chain_theta_4 = chain_theta_3 - chain_theta_4;
    let chain_theta_3_minus_chain_theta_5 = chain_theta_3 - chain_theta_5;
    let chain_theta_4_minus_chain_theta_5 = chain_theta_4 - chain_theta_5;
    let [(sin_chain_theta_1, cos_chain_theta_1), (sin_chain_theta_2, cos_chain_theta_2),
    (sin_chain_theta_3, cos_chain_theta_3), (sin_chain_theta_4, cos_chain_theta_4),
    (sin_chain_theta_5, cos_chain_theta_5), (t0, t1), (t2, t3), (t4, t5), (t6, t7),
    (t8, t9), (t10, t11), (t12, t13), (t14, t15), (t16, t17), (t18, t19)] = R::sin_cos_each([
        chain_theta_1,
        chain_theta_2,
        chain_theta_3,
        chain_theta_4,
        chain_theta_5,
        chain_theta_1_minus_chain_theta_2,
        chain_theta_1_minus_chain_theta_3,
        chain_theta_1_minus_chain_theta_4,
        chain_theta_1_minus_chain_theta_5,
        chain_theta_2_minus_chain_theta_3,
        chain_theta_2_minus_chain_theta_4,
        chain_theta_2_minus_chain_theta_5,
        chain_theta_3_minus_chain_theta_4,
        chain_theta_3_minus_chain_theta_5,
        chain_theta_4_minus_chain_theta_5,
    ]);
    let chain_u_1 = chain_omega_1 * cos_chain_theta_1;
    let chain_v_1 = chain_omega_1 * sin_chain_theta_1;
    let chain_u_2 = chain_u_1.add_product(chain_omega_2, cos_chain_theta_2);
    let chain_v_2 = chain_v_1.add_product(chain_omega_2, sin_chain_theta_2);
    let chain_u_3 = chain_u_2.add_product(chain_omega_3, cos_chain_theta_3);
    let chain_v_3 = chain_v_2.add_product(chain_omega_3, sin_chain_theta_3);
    let chain_u_4 = chain_u_3.add_product(chain_omega_4, cos_chain_theta_4);
    let chain_v_4 = chain_v_3.add_product(chain_omega_4, sin_chain_theta_4);
    let chain_u_5 = chain_u_4.add_product(chain_omega_5, cos_chain_theta_5);
    let chain_v_5 = chain_v_4.add_product(chain_omega_5, sin_chain_theta_5);
    let t20 = R::literal(4.0) * t1;
    let t21 = R::literal(3.0) * t3;
    let t22 = R::literal(2.0) * t5;
    let t23 = R::literal(0.8) * t1;
    let t24 = R::literal(0.600_000_000_000_000_1) * t3;
    let t25 = R::literal(0.4) * t5;
    let t26 = t7 * R::literal(0.2);
    let t27 = R::literal(1.0) / R::literal(4.0).sub_product(t23, t20);
    let t28 = (R::literal(3.0) * t9).sub_product(t24, t20);
    let t29 = t28 * t27;
    let t30 = (R::literal(2.0) * t11).sub_product(t25, t20);
    let t31 = t30 * t27;
    let t32 = t13.sub_product(t26, t20);
    let t33 = t32 * t27;
    let t34 = R::literal(1.0)
        / R::literal(3.0).sub_product(t24, t21).sub_product(t29, t28);
    let t35 = (R::literal(2.0) * t15).sub_product(t25, t21).sub_product(t31, t28);
    let t36 = t35 * t34;
    let t37 = t17.sub_product(t26, t21).sub_product(t33, t28);
    let t38 = t37 * t34;
    let t39 = R::literal(1.0)
        / R::literal(2.0)
            .sub_product(t25, t22)
            .sub_product(t31, t30)
            .sub_product(t36, t35);
    let t40 = t19.sub_product(t26, t22).sub_product(t33, t30).sub_product(t38, t35);
    let t41 = t40 * t39;
    let t42 = R::literal(49.05) * sin_chain_theta_1;
    let chain_omega_2_squared = chain_omega_2 * chain_omega_2;
    let chain_omega_3_squared = chain_omega_3 * chain_omega_3;
    let t43 = R::literal(3.0) * chain_omega_3_squared;
    let chain_omega_4_squared = chain_omega_4 * chain_omega_4;
    let t44 = R::literal(2.0) * chain_omega_4_squared;
    let chain_omega_5_squared = chain_omega_5 * chain_omega_5;
    let t45 = (-t42)
        .sub_product(R::literal(4.0) * chain_omega_2_squared, t0)
        .sub_product(t43, t2)
        .sub_product(t44, t4)
        .sub_product(chain_omega_5_squared, t6);
    let t46 = R::literal(39.24) * sin_chain_theta_2;
    let chain_omega_1_squared = chain_omega_1 * chain_omega_1;
    let t47 = R::literal(29.43) * sin_chain_theta_3;
    let t48 = R::literal(19.62) * sin_chain_theta_4;
    let t49 = R::literal(9.81) * sin_chain_theta_5;
    let t50 = (-t46)
        .add_product(R::literal(4.0) * chain_omega_1_squared, t0)
        .sub_product(t43, t8)
        .sub_product(t44, t10)
        .sub_product(chain_omega_5_squared, t12)
        .sub_product(t23, t45);
    let t51 = ((R::literal(3.0) * chain_omega_1_squared * t2)
        .add_product(R::literal(3.0) * chain_omega_2_squared, t8) - t47)
        .sub_product(t44, t14)
        .sub_product(chain_omega_5_squared, t16)
        .sub_product(t24, t45)
        .sub_product(t29, t50);
    let t52 = ((R::literal(2.0) * chain_omega_1_squared * t4)
        .add_product(R::literal(2.0) * chain_omega_2_squared, t10)
        .add_product(R::literal(2.0) * chain_omega_3_squared, t14) - t48)
        .sub_product(chain_omega_5_squared, t18)
        .sub_product(t25, t45)
        .sub_product(t31, t50)
        .sub_product(t36, t51);
    let chain_omega_5_dot = ((chain_omega_1_squared * t6)
        .add_product(chain_omega_2_squared, t12)
        .add_product(chain_omega_3_squared, t16)
        .add_product(chain_omega_4_squared, t18) - t49)
        .sub_product(t26, t45)
        .sub_product(t33, t50)
        .sub_product(t38, t51)
        .sub_product(t41, t52)
        * (R::literal(1.0)
            / R::literal(1.0)
                .sub_product(t26, t7)
                .sub_product(t33, t32)
                .sub_product(t38, t37)
                .sub_product(t41, t40));
    let chain_omega_4_dot = (t52 * t39).sub_product(t41, chain_omega_5_dot);
    let chain_omega_3_dot = (t51 * t34)
        .sub_product(t36, chain_omega_4_dot)
        .sub_product(t38, chain_omega_5_dot);
    let chain_omega_2_dot = (t50 * t27)
        .sub_product(t29, chain_omega_3_dot)
        .sub_product(t31, chain_omega_4_dot)
        .sub_product(t33, chain_omega_5_dot);
    let chain_omega_1_dot = (t45 * R::literal(0.2))
        .sub_product(t23, chain_omega_2_dot)
        .sub_product(t24, chain_omega_3_dot)
        .sub_product(t25, chain_omega_4_dot)
        .sub_product(t26, chain_omega_5_dot);
    let t53 = R::literal(2.0) * chain_omega_2;
    let t54 = R::literal(2.0) * chain_omega_3;
    let t55 = R::literal(2.0) * chain_omega_4;
    let t56 = R::literal(2.0) * chain_omega_5;
    let t57 = R::literal(2.0) * chain_v_1;
    let t58 = R::literal(2.0) * chain_u_1;
    let t59 = t46
        .add_product(
            R::literal(0.5),
            (t53 * chain_v_2 * cos_chain_theta_2)
                .add_product(t53 * chain_v_3, cos_chain_theta_2)
                .add_product(t53 * chain_v_4, cos_chain_theta_2)
                .add_product(t53 * chain_v_5, cos_chain_theta_2)
                .sub_product(t53 * chain_u_2, sin_chain_theta_2)
                .sub_product(t53 * chain_u_3, sin_chain_theta_2)
                .sub_product(t53 * chain_u_4, sin_chain_theta_2)
                .sub_product(t53 * chain_u_5, sin_chain_theta_2),
        );
    let t60 = t47
        .add_product(
            R::literal(0.5),
            (t54 * chain_v_3 * cos_chain_theta_3)
                .add_product(t54 * chain_v_4, cos_chain_theta_3)
                .add_product(t54 * chain_v_5, cos_chain_theta_3)
                .sub_product(t54 * chain_u_3, sin_chain_theta_3)
                .sub_product(t54 * chain_u_4, sin_chain_theta_3)
                .sub_product(t54 * chain_u_5, sin_chain_theta_3),
        );
    let t61 = (t42
        .add_product(
            R::literal(0.5),
            (t58 * chain_v_2)
                .add_product(t58, chain_v_3)
                .add_product(t58, chain_v_4)
                .add_product(t58, chain_v_5)
                .sub_product(t57, chain_u_2)
                .sub_product(t57, chain_u_3)
                .sub_product(t57, chain_u_4)
                .sub_product(t57, chain_u_5),
        ) * chain_omega_1)
        .add_product(t59, chain_omega_2)
        .add_product(t60, chain_omega_3)
        .add_product(
            t48
                .add_product(
                    R::literal(0.5),
                    (t55 * chain_v_4 * cos_chain_theta_4)
                        .add_product(t55 * chain_v_5, cos_chain_theta_4)
                        .sub_product(t55 * chain_u_4, sin_chain_theta_4)
                        .sub_product(t55 * chain_u_5, sin_chain_theta_4),
                ),
            chain_omega_4,
        );
    let t62 = R::literal(2.0) * chain_u_2;
    let t63 = R::literal(2.0) * chain_v_2;
    let t64 = R::literal(2.0) * chain_u_3;
    let t65 = R::literal(2.0) * chain_v_3;
    let t66 = R::literal(2.0) * chain_u_4;
    let t67 = R::literal(2.0) * chain_v_4;
    let t68 = R::literal(2.0) * chain_u_5;
    let t69 = R::literal(2.0) * chain_v_5;
    let t70 = t61
        .add_product(
            t49
                .add_product(
                    R::literal(0.5),
                    (t56 * chain_v_5 * cos_chain_theta_5)
                        .sub_product(t56 * chain_u_5, sin_chain_theta_5),
                ),
            chain_omega_5,
        )
        .add_product(
            R::literal(0.5)
                * (t58 * cos_chain_theta_1)
                    .add_product(t57, sin_chain_theta_1)
                    .add_product(t62, cos_chain_theta_1)
                    .add_product(t63, sin_chain_theta_1)
                    .add_product(t64, cos_chain_theta_1)
                    .add_product(t65, sin_chain_theta_1)
                    .add_product(t66, cos_chain_theta_1)
                    .add_product(t67, sin_chain_theta_1)
                    .add_product(t68, cos_chain_theta_1)
                    .add_product(t69, sin_chain_theta_1),
            chain_omega_1_dot,
        );
    let t71 = t70
        .add_product(
            R::literal(0.5)
                * (t62 * cos_chain_theta_2)
                    .add_product(t63, sin_chain_theta_2)
                    .add_product(t64, cos_chain_theta_2)
                    .add_product(t65, sin_chain_theta_2)
                    .add_product(t66, cos_chain_theta_2)
                    .add_product(t67, sin_chain_theta_2)
                    .add_product(t68, cos_chain_theta_2)
                    .add_product(t69, sin_chain_theta_2),
            chain_omega_2_dot,
        )
        .add_product(
            R::literal(0.5)
                * (t64 * cos_chain_theta_3)
                    .add_product(t65, sin_chain_theta_3)
                    .add_product(t66, cos_chain_theta_3)
                    .add_product(t67, sin_chain_theta_3)
                    .add_product(t68, cos_chain_theta_3)
                    .add_product(t69, sin_chain_theta_3),
            chain_omega_3_dot,
        )
        .add_product(
            R::literal(0.5)
                * (t66 * cos_chain_theta_4)
                    .add_product(t67, sin_chain_theta_4)
                    .add_product(t68, cos_chain_theta_4)
                    .add_product(t69, sin_chain_theta_4),
            chain_omega_4_dot,
        );
    PowerBalance {
        stored_rate: t71
            .add_product(
                R::literal(0.5)
                    * (t68 * cos_chain_theta_5).add_product(t69, sin_chain_theta_5),
                chain_omega_5_dot,
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
/// 171 recurrences. 75 sums of products an order.
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
    let (mut lanes_13, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_14, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_15, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_16, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_17, workspace) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let (mut lanes_18, _) = Lanes::<R, 3>::new(workspace, coefficients.len());
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
    let t54 = t41 * t16;
    let t55 = t44 * t20;
    let t56 = t46 * t24;
    let t57 = chain_omega_1 * chain_omega_1;
    let t58 = t57 * R::literal(4.0);
    let t59 = t58 * t1;
    let t60 = t59 - t53;
    let t61 = t60 - t54;
    let t62 = t61 - t55;
    let t63 = t62 - t56;
    let t64 = sin_chain_theta_3 * R::literal(29.43);
    let t65 = t44 * t27;
    let t66 = t46 * t31;
    let t67 = t57 * R::literal(3.0);
    let t68 = t67 * t5;
    let t69 = t37 * R::literal(3.0);
    let t70 = t69 * t16;
    let t71 = t68 + t70;
    let t72 = t71 - t64;
    let t73 = t72 - t65;
    let t74 = t73 - t66;
    let t75 = sin_chain_theta_4 * R::literal(19.62);
    let t76 = t46 * t34;
    let t77 = t57 * R::literal(2.0);
    let t78 = t77 * t9;
    let t79 = t37 * R::literal(2.0);
    let t80 = t79 * t20;
    let t81 = t40 * R::literal(2.0);
    let t82 = t81 * t27;
    let t83 = t78 + t80;
    let t84 = t83 + t82;
    let t85 = t84 - t75;
    let t86 = t85 - t76;
    let t87 = sin_chain_theta_5 * R::literal(9.81);
    let t88 = t57 * t13;
    let t89 = t37 * t24;
    let t90 = t40 * t31;
    let t91 = t43 * t34;
    let t92 = t88 + t89;
    let t93 = t92 + t90;
    let t94 = t93 + t91;
    let t95 = t94 - t87;
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
    chain_omega_5_dot] = factored.solve([t52, t63, t74, t86, t95]);
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
        let t0_k = chain_theta_1_k - chain_theta_2_k;
        let t1_k = t0_k.mul_add(t2, inverse * sums_3[3]);
        let t2_k = -t0_k.mul_add(t1, inverse * sums_4[0]);
        let t3_k = t2_k * R::literal(4.0);
        let t4_k = chain_theta_1_k - chain_theta_3_k;
        let t5_k = t4_k.mul_add(t6, inverse * sums_4[1]);
        let t6_k = -t4_k.mul_add(t5, inverse * sums_4[2]);
        let t7_k = t6_k * R::literal(3.0);
        let t8_k = chain_theta_1_k - chain_theta_4_k;
        let t9_k = t8_k.mul_add(t10, inverse * sums_4[3]);
        let t10_k = -t8_k.mul_add(t9, inverse * sums_5[0]);
        let t11_k = t10_k * R::literal(2.0);
        let t12_k = chain_theta_1_k - chain_theta_5_k;
        let t13_k = t12_k.mul_add(t14, inverse * sums_5[1]);
        let t14_k = -t12_k.mul_add(t13, inverse * sums_5[2]);
        let t15_k = chain_theta_2_k - chain_theta_3_k;
        let t16_k = t15_k.mul_add(t17, inverse * sums_5[3]);
        let t17_k = -t15_k.mul_add(t16, inverse * sums_6[0]);
        let t18_k = t17_k * R::literal(3.0);
        let t19_k = chain_theta_2_k - chain_theta_4_k;
        let t20_k = t19_k.mul_add(t21, inverse * sums_6[1]);
        let t21_k = -t19_k.mul_add(t20, inverse * sums_6[2]);
        let t22_k = t21_k * R::literal(2.0);
        let t23_k = chain_theta_2_k - chain_theta_5_k;
        let t24_k = t23_k.mul_add(t25, inverse * sums_6[3]);
        let t25_k = -t23_k.mul_add(t24, inverse * sums_7[0]);
        let t26_k = chain_theta_3_k - chain_theta_4_k;
        let t27_k = t26_k.mul_add(t28, inverse * sums_7[1]);
        let t28_k = -t26_k.mul_add(t27, inverse * sums_7[2]);
        let t29_k = t28_k * R::literal(2.0);
        let t30_k = chain_theta_3_k - chain_theta_5_k;
        let t31_k = t30_k.mul_add(t32, inverse * sums_7[3]);
        let t32_k = -t30_k.mul_add(t31, inverse * sums_8[0]);
        let t33_k = chain_theta_4_k - chain_theta_5_k;
        let t34_k = t33_k.mul_add(t35, inverse * sums_8[1]);
        let t35_k = -t33_k.mul_add(t34, inverse * sums_8[2]);
        let sin_chain_theta_1_k = chain_theta_1_k
            .mul_add(cos_chain_theta_1, inverse * sums_1[1]);
        let cos_chain_theta_1_k = -chain_theta_1_k
            .mul_add(sin_chain_theta_1, inverse * sums_1[2]);
        let sin_chain_theta_2_k = chain_theta_2_k
            .mul_add(cos_chain_theta_2, inverse * sums_1[3]);
        let cos_chain_theta_2_k = -chain_theta_2_k
            .mul_add(sin_chain_theta_2, inverse * sums_2[0]);
        let sin_chain_theta_3_k = chain_theta_3_k
            .mul_add(cos_chain_theta_3, inverse * sums_2[1]);
        let cos_chain_theta_3_k = -chain_theta_3_k
            .mul_add(sin_chain_theta_3, inverse * sums_2[2]);
        let sin_chain_theta_4_k = chain_theta_4_k
            .mul_add(cos_chain_theta_4, inverse * sums_2[3]);
        let cos_chain_theta_4_k = -chain_theta_4_k
            .mul_add(sin_chain_theta_4, inverse * sums_3[0]);
        let sin_chain_theta_5_k = chain_theta_5_k
            .mul_add(cos_chain_theta_5, inverse * sums_3[1]);
        let cos_chain_theta_5_k = -chain_theta_5_k
            .mul_add(sin_chain_theta_5, inverse * sums_3[2]);
        let t36_k = sin_chain_theta_1_k * R::literal(49.05);
        let t37_k = (chain_omega_2 + chain_omega_2).mul_add(chain_omega_2_k, sums[0]);
        let t38_k = t37_k * R::literal(4.0);
        let t39_k = t38.mul_add(t1_k, t1.mul_add(t38_k, sums_8[3]));
        let t40_k = (chain_omega_3 + chain_omega_3).mul_add(chain_omega_3_k, sums[1]);
        let t41_k = t40_k * R::literal(3.0);
        let t42_k = t41.mul_add(t5_k, t5.mul_add(t41_k, sums_9[0]));
        let t43_k = (chain_omega_4 + chain_omega_4).mul_add(chain_omega_4_k, sums[2]);
        let t44_k = t43_k * R::literal(2.0);
        let t45_k = t44.mul_add(t9_k, t9.mul_add(t44_k, sums_9[1]));
        let t46_k = (chain_omega_5 + chain_omega_5).mul_add(chain_omega_5_k, sums[3]);
        let t47_k = t46.mul_add(t13_k, t13.mul_add(t46_k, sums_9[2]));
        let t48_k = -t36_k;
        let t49_k = t48_k - t39_k;
        let t50_k = t49_k - t42_k;
        let t51_k = t50_k - t45_k;
        let t52_k = t51_k - t47_k;
        let t54_k = t41.mul_add(t16_k, t16.mul_add(t41_k, sums_9[3]));
        let t55_k = t44.mul_add(t20_k, t20.mul_add(t44_k, sums_10[0]));
        let t56_k = t46.mul_add(t24_k, t24.mul_add(t46_k, sums_10[1]));
        let t57_k = (chain_omega_1 + chain_omega_1).mul_add(chain_omega_1_k, sums_1[0]);
        let t58_k = t57_k * R::literal(4.0);
        let t59_k = t58.mul_add(t1_k, t1.mul_add(t58_k, sums_10[2]));
        let t60_k = (-sin_chain_theta_2_k).mul_add(R::literal(39.24), t59_k);
        let t61_k = t60_k - t54_k;
        let t62_k = t61_k - t55_k;
        let t63_k = t62_k - t56_k;
        let t65_k = t44.mul_add(t27_k, t27.mul_add(t44_k, sums_10[3]));
        let t66_k = t46.mul_add(t31_k, t31.mul_add(t46_k, sums_11[0]));
        let t67_k = t57_k * R::literal(3.0);
        let t68_k = t67.mul_add(t5_k, t5.mul_add(t67_k, sums_11[1]));
        let t69_k = t37_k * R::literal(3.0);
        let t70_k = t69.mul_add(t16_k, t16.mul_add(t69_k, sums_11[2]));
        let t71_k = t68_k + t70_k;
        let t72_k = (-sin_chain_theta_3_k).mul_add(R::literal(29.43), t71_k);
        let t73_k = t72_k - t65_k;
        let t74_k = t73_k - t66_k;
        let t76_k = t46.mul_add(t34_k, t34.mul_add(t46_k, sums_11[3]));
        let t77_k = t57_k * R::literal(2.0);
        let t78_k = t77.mul_add(t9_k, t9.mul_add(t77_k, sums_12[0]));
        let t79_k = t37_k * R::literal(2.0);
        let t80_k = t79.mul_add(t20_k, t20.mul_add(t79_k, sums_12[1]));
        let t81_k = t40_k * R::literal(2.0);
        let t82_k = t81.mul_add(t27_k, t27.mul_add(t81_k, sums_12[2]));
        let t83_k = t78_k + t80_k;
        let t84_k = t83_k + t82_k;
        let t85_k = (-sin_chain_theta_4_k).mul_add(R::literal(19.62), t84_k);
        let t86_k = t85_k - t76_k;
        let t88_k = t57.mul_add(t13_k, t13.mul_add(t57_k, sums_12[3]));
        let t89_k = t37.mul_add(t24_k, t24.mul_add(t37_k, sums_13[0]));
        let t90_k = t40.mul_add(t31_k, t31.mul_add(t40_k, sums_13[1]));
        let t91_k = t43.mul_add(t34_k, t34.mul_add(t43_k, sums_13[2]));
        let t92_k = t88_k + t89_k;
        let t93_k = t92_k + t90_k;
        let t94_k = t93_k + t91_k;
        let t95_k = (-sin_chain_theta_5_k).mul_add(R::literal(9.81), t94_k);
        let n131_k = t3_k.mul_add(chain_omega_2_dot, sums_13[3]);
        let n132_k = t7_k.mul_add(chain_omega_3_dot, sums_14[0]);
        let n133_k = t11_k.mul_add(chain_omega_4_dot, sums_14[1]);
        let n134_k = t14_k.mul_add(chain_omega_5_dot, sums_14[2]);
        let n135_k = t3_k.mul_add(chain_omega_1_dot, sums_14[3]);
        let n136_k = t18_k.mul_add(chain_omega_3_dot, sums_15[0]);
        let n137_k = t22_k.mul_add(chain_omega_4_dot, sums_15[1]);
        let n138_k = t25_k.mul_add(chain_omega_5_dot, sums_15[2]);
        let n139_k = t7_k.mul_add(chain_omega_1_dot, sums_15[3]);
        let n140_k = t18_k.mul_add(chain_omega_2_dot, sums_16[0]);
        let n141_k = t29_k.mul_add(chain_omega_4_dot, sums_16[1]);
        let n142_k = t32_k.mul_add(chain_omega_5_dot, sums_16[2]);
        let n143_k = t11_k.mul_add(chain_omega_1_dot, sums_16[3]);
        let n144_k = t22_k.mul_add(chain_omega_2_dot, sums_17[0]);
        let n145_k = t29_k.mul_add(chain_omega_3_dot, sums_17[1]);
        let n146_k = t35_k.mul_add(chain_omega_5_dot, sums_17[2]);
        let n147_k = t14_k.mul_add(chain_omega_1_dot, sums_17[3]);
        let n148_k = t25_k.mul_add(chain_omega_2_dot, sums_18[0]);
        let n149_k = t32_k.mul_add(chain_omega_3_dot, sums_18[1]);
        let n150_k = t35_k.mul_add(chain_omega_4_dot, sums_18[2]);
        let n151_k = n131_k + n132_k;
        let n152_k = n133_k + n134_k;
        let n153_k = n151_k + n152_k;
        let t52_k_2 = t52_k - n153_k;
        let n155_k = n135_k + n136_k;
        let n156_k = n137_k + n138_k;
        let n157_k = n155_k + n156_k;
        let t63_k_2 = t63_k - n157_k;
        let n159_k = n139_k + n140_k;
        let n160_k = n141_k + n142_k;
        let n161_k = n159_k + n160_k;
        let t74_k_2 = t74_k - n161_k;
        let n163_k = n143_k + n144_k;
        let n164_k = n145_k + n146_k;
        let n165_k = n163_k + n164_k;
        let t86_k_2 = t86_k - n165_k;
        let n167_k = n147_k + n148_k;
        let n168_k = n149_k + n150_k;
        let n169_k = n167_k + n168_k;
        let t95_k_2 = t95_k - n169_k;
        let [chain_omega_1_dot_k, chain_omega_2_dot_k, chain_omega_3_dot_k,
        chain_omega_4_dot_k, chain_omega_5_dot_k] = factored
            .solve([t52_k_2, t63_k_2, t74_k_2, t86_k_2, t95_k_2]);
        lanes
            .set(
                order,
                [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k],
                [chain_omega_2_k, chain_omega_3_k, chain_omega_4_k, chain_omega_5_k],
            );
        lanes_1
            .set(
                order,
                [
                    chain_omega_1_k,
                    k * chain_theta_1_k,
                    k * chain_theta_1_k,
                    k * chain_theta_2_k,
                ],
                [
                    chain_omega_1_k,
                    cos_chain_theta_1_k,
                    sin_chain_theta_1_k,
                    cos_chain_theta_2_k,
                ],
            );
        lanes_2
            .set(
                order,
                [
                    k * chain_theta_2_k,
                    k * chain_theta_3_k,
                    k * chain_theta_3_k,
                    k * chain_theta_4_k,
                ],
                [
                    sin_chain_theta_2_k,
                    cos_chain_theta_3_k,
                    sin_chain_theta_3_k,
                    cos_chain_theta_4_k,
                ],
            );
        lanes_3
            .set(
                order,
                [
                    k * chain_theta_4_k,
                    k * chain_theta_5_k,
                    k * chain_theta_5_k,
                    k * t0_k,
                ],
                [sin_chain_theta_4_k, cos_chain_theta_5_k, sin_chain_theta_5_k, t2_k],
            );
        lanes_4
            .set(
                order,
                [k * t0_k, k * t4_k, k * t4_k, k * t8_k],
                [t1_k, t6_k, t5_k, t10_k],
            );
        lanes_5
            .set(
                order,
                [k * t8_k, k * t12_k, k * t12_k, k * t15_k],
                [t9_k, t14_k, t13_k, t17_k],
            );
        lanes_6
            .set(
                order,
                [k * t15_k, k * t19_k, k * t19_k, k * t23_k],
                [t16_k, t21_k, t20_k, t25_k],
            );
        lanes_7
            .set(
                order,
                [k * t23_k, k * t26_k, k * t26_k, k * t30_k],
                [t24_k, t28_k, t27_k, t32_k],
            );
        lanes_8
            .set(
                order,
                [k * t30_k, k * t33_k, k * t33_k, t1_k],
                [t31_k, t35_k, t34_k, t38_k],
            );
        lanes_9.set(order, [t5_k, t9_k, t13_k, t16_k], [t41_k, t44_k, t46_k, t41_k]);
        lanes_10.set(order, [t20_k, t24_k, t1_k, t27_k], [t44_k, t46_k, t58_k, t44_k]);
        lanes_11.set(order, [t31_k, t5_k, t16_k, t34_k], [t46_k, t67_k, t69_k, t46_k]);
        lanes_12.set(order, [t9_k, t20_k, t27_k, t13_k], [t77_k, t79_k, t81_k, t57_k]);
        lanes_13
            .set(
                order,
                [t24_k, t31_k, t34_k, t3_k],
                [t37_k, t40_k, t43_k, chain_omega_2_dot_k],
            );
        lanes_14
            .set(
                order,
                [t7_k, t11_k, t14_k, t3_k],
                [
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_15
            .set(
                order,
                [t18_k, t22_k, t25_k, t7_k],
                [
                    chain_omega_3_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_16
            .set(
                order,
                [t18_k, t29_k, t32_k, t11_k],
                [
                    chain_omega_2_dot_k,
                    chain_omega_4_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_17
            .set(
                order,
                [t22_k, t29_k, t35_k, t14_k],
                [
                    chain_omega_2_dot_k,
                    chain_omega_3_dot_k,
                    chain_omega_5_dot_k,
                    chain_omega_1_dot_k,
                ],
            );
        lanes_18
            .set(
                order,
                [t25_k, t32_k, t35_k],
                [chain_omega_2_dot_k, chain_omega_3_dot_k, chain_omega_4_dot_k],
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
        Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 4>::workspace(order + 1) + Lanes::<R, 4>::workspace(order + 1)
            + Lanes::<R, 3>::workspace(order + 1)
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

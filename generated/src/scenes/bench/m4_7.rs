// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   c1171a9dc7a86b66e9a0824c3f5672ed858e516c636e7100a9f7fc62f3529fdb  bench/m4_7.toml
//
// Benchmark M4: reed as a torsional shaft of 7 pieces
//
// An undamped shaft driven by a spring at one end, with the reed and a spring to
// ground at four sevenths of its length.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// Shapes; all quantities are in SI units:
//   coordinates               8
//   first-order states        0
//   states                   16
//   parameters                0
//   outputs                  16
//   discontinuities           0
//
// State:
//     0  node_0.theta  [rad]    angle
//     1  node_1.theta  [rad]    angle
//     2  node_2.theta  [rad]    angle
//     3  node_3.theta  [rad]    angle
//     4  node_4.theta  [rad]    angle
//     5  node_5.theta  [rad]    angle
//     6  node_6.theta  [rad]    angle
//     7  node_7.theta  [rad]    angle
//     8  node_0.omega  [rad/s]  rate of angle
//     9  node_1.omega  [rad/s]  rate of angle
//    10  node_2.omega  [rad/s]  rate of angle
//    11  node_3.omega  [rad/s]  rate of angle
//    12  node_4.omega  [rad/s]  rate of angle
//    13  node_5.omega  [rad/s]  rate of angle
//    14  node_6.omega  [rad/s]  rate of angle
//    15  node_7.omega  [rad/s]  rate of angle
//
// Nonzeros:
//   mass_matrix               8 of 8 by 8
//   rate_jacobian            30 of 16 by 16
//   parameter_jacobian        0 of 16 by 0
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     40
//   mass_matrix               0
//   forcing                  38
//   rate_jacobian             0
//   parameter_jacobian        0
//   time_derivative           3
//   outputs                   0
//   energy                   60
//   power_balance            96

use ::machinist_contract::{
    Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape, Simulator,
    SparsityPattern, linear::LinearEquations, taylor::{TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 8;

/// Length of the state y.
pub const STATES: usize = 16;

/// Parameters.
pub const PARAMETERS: usize = 0;

/// Wanted outputs.
pub const OUTPUTS: usize = 16;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 0;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 8,
    columns: 8,
    entries: &[(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (6, 6), (7, 7)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 16,
    entries: &[
        (0, 8), (1, 9), (2, 10), (3, 11), (4, 12), (5, 13), (6, 14), (7, 15), (8, 0), (8, 1),
        (9, 0), (9, 1), (9, 2), (10, 1), (10, 2), (10, 3), (11, 2), (11, 3), (11, 4), (12, 3),
        (12, 4), (12, 5), (13, 4), (13, 5), (13, 6), (14, 5), (14, 6), (14, 7), (15, 6), (15, 7),
    ],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 16,
    columns: 0,
    entries: &[],
};

/// Benchmark M4: reed as a torsional shaft of 7 pieces
///
/// An undamped shaft driven by a spring at one end, with the reed and a spring to
/// ground at four sevenths of its length.
///
/// Source: Benchmark models of textile-machine dynamics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct M47;

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
    /// theta_0: angle \[rad\].
    pub theta_0: R,
    /// omega_0: rate of angle \[rad/s\].
    pub omega_0: R,
    /// theta_1: angle \[rad\].
    pub theta_1: R,
    /// omega_1: rate of angle \[rad/s\].
    pub omega_1: R,
    /// theta_2: angle \[rad\].
    pub theta_2: R,
    /// omega_2: rate of angle \[rad/s\].
    pub omega_2: R,
    /// theta_3: angle \[rad\].
    pub theta_3: R,
    /// omega_3: rate of angle \[rad/s\].
    pub omega_3: R,
    /// theta_4: angle \[rad\].
    pub theta_4: R,
    /// omega_4: rate of angle \[rad/s\].
    pub omega_4: R,
    /// theta_5: angle \[rad\].
    pub theta_5: R,
    /// omega_5: rate of angle \[rad/s\].
    pub omega_5: R,
    /// theta_6: angle \[rad\].
    pub theta_6: R,
    /// omega_6: rate of angle \[rad/s\].
    pub omega_6: R,
    /// theta_7: angle \[rad\].
    pub theta_7: R,
    /// omega_7: rate of angle \[rad/s\].
    pub omega_7: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            theta_0: values[0],
            omega_0: values[1],
            theta_1: values[2],
            omega_1: values[3],
            theta_2: values[4],
            omega_2: values[5],
            theta_3: values[6],
            omega_3: values[7],
            theta_4: values[8],
            omega_4: values[9],
            theta_5: values[10],
            omega_5: values[11],
            theta_6: values[12],
            omega_6: values[13],
            theta_7: values[14],
            omega_7: values[15],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.theta_0,
            self.omega_0,
            self.theta_1,
            self.omega_1,
            self.theta_2,
            self.omega_2,
            self.theta_3,
            self.omega_3,
            self.theta_4,
            self.omega_4,
            self.theta_5,
            self.omega_5,
            self.theta_6,
            self.omega_6,
            self.theta_7,
            self.omega_7,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// node_0.theta: angle \[rad\].
    pub const NODE_0_THETA: usize = 0;
    /// node_1.theta: angle \[rad\].
    pub const NODE_1_THETA: usize = 1;
    /// node_2.theta: angle \[rad\].
    pub const NODE_2_THETA: usize = 2;
    /// node_3.theta: angle \[rad\].
    pub const NODE_3_THETA: usize = 3;
    /// node_4.theta: angle \[rad\].
    pub const NODE_4_THETA: usize = 4;
    /// node_5.theta: angle \[rad\].
    pub const NODE_5_THETA: usize = 5;
    /// node_6.theta: angle \[rad\].
    pub const NODE_6_THETA: usize = 6;
    /// node_7.theta: angle \[rad\].
    pub const NODE_7_THETA: usize = 7;
    /// node_0.omega: rate of angle \[rad/s\].
    pub const NODE_0_OMEGA: usize = 8;
    /// node_1.omega: rate of angle \[rad/s\].
    pub const NODE_1_OMEGA: usize = 9;
    /// node_2.omega: rate of angle \[rad/s\].
    pub const NODE_2_OMEGA: usize = 10;
    /// node_3.omega: rate of angle \[rad/s\].
    pub const NODE_3_OMEGA: usize = 11;
    /// node_4.omega: rate of angle \[rad/s\].
    pub const NODE_4_OMEGA: usize = 12;
    /// node_5.omega: rate of angle \[rad/s\].
    pub const NODE_5_OMEGA: usize = 13;
    /// node_6.omega: rate of angle \[rad/s\].
    pub const NODE_6_OMEGA: usize = 14;
    /// node_7.omega: rate of angle \[rad/s\].
    pub const NODE_7_OMEGA: usize = 15;
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
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
/// 40 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega,
    node_3_omega, node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let node_7_omega_dot = R::literal(321_391_625.739_451_8)
        * (node_6_theta - node_7_theta);
    let node_6_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_5_theta + node_7_theta).sub_product(R::literal(2.0), node_6_theta);
    let node_5_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_4_theta + node_6_theta).sub_product(R::literal(2.0), node_5_theta);
    let node_4_omega_dot = (-(R::literal(15600.0) * node_4_theta)
        .add_product(R::literal(188_797.635_432_078_9), node_4_theta - node_5_theta))
        .add_product(R::literal(188_797.635_432_078_9), node_3_theta - node_4_theta)
        * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_2_theta + node_4_theta).sub_product(R::literal(2.0), node_3_theta);
    let node_2_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_1_theta + node_3_theta).sub_product(R::literal(2.0), node_2_theta);
    let node_1_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_0_theta + node_2_theta).sub_product(R::literal(2.0), node_1_theta);
    let node_0_omega_dot = -((R::literal(188_797.635_432_078_9)
        * (node_0_theta - node_1_theta))
        .add_product(R::literal(45200.0), node_0_theta - drive)
        * R::literal(1_702.307_473_310_885));
    [
        node_0_omega,
        node_1_omega,
        node_2_omega,
        node_3_omega,
        node_4_omega,
        node_5_omega,
        node_6_omega,
        node_7_omega,
        node_0_omega_dot,
        node_1_omega_dot,
        node_2_omega_dot,
        node_3_omega_dot,
        node_4_omega_dot,
        node_5_omega_dot,
        node_6_omega_dot,
        node_7_omega_dot,
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
) -> [R; 8] {
    [
        R::literal(0.000_587_437_942_720_806_3),
        R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.052_438_875_885_441_61),
        R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.000_587_437_942_720_806_3),
    ]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 38 operations.
#[must_use]
pub fn forcing<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, ..] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let node_0_theta_forcing = -(R::literal(188_797.635_432_078_9)
        * (node_0_theta - node_1_theta))
        .add_product(R::literal(45200.0), node_0_theta - drive);
    let node_1_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_0_theta + node_2_theta).sub_product(R::literal(2.0), node_1_theta);
    let node_2_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_1_theta + node_3_theta).sub_product(R::literal(2.0), node_2_theta);
    let node_3_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_2_theta + node_4_theta).sub_product(R::literal(2.0), node_3_theta);
    let node_4_theta_forcing = (-(R::literal(15600.0) * node_4_theta)
        .add_product(R::literal(188_797.635_432_078_9), node_4_theta - node_5_theta))
        .add_product(R::literal(188_797.635_432_078_9), node_3_theta - node_4_theta);
    let node_5_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_4_theta + node_6_theta).sub_product(R::literal(2.0), node_5_theta);
    let node_6_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_5_theta + node_7_theta).sub_product(R::literal(2.0), node_6_theta);
    let node_7_theta_forcing = R::literal(188_797.635_432_078_9)
        * (node_6_theta - node_7_theta);
    [
        node_0_theta_forcing,
        node_1_theta_forcing,
        node_2_theta_forcing,
        node_3_theta_forcing,
        node_4_theta_forcing,
        node_5_theta_forcing,
        node_6_theta_forcing,
        node_7_theta_forcing,
    ]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// No operations.
#[must_use]
pub fn rate_jacobian<R: Real>(
    _time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; 30] {
    [
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(1.0),
        R::literal(-398_335_923.533_103_8),
        R::literal(321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(3_600_337.197_245_184),
        R::literal(-7_498_163.609_058_579),
        R::literal(3_600_337.197_245_184),
        R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9),
        R::literal(321_391_625.739_451_8),
        R::literal(-321_391_625.739_451_8),
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
/// 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    _p: &Parameters<R>,
) -> [R; STATES] {
    let node_0_omega_dot_by_time = R::literal(232_058_535.056_795_92)
        * (R::literal(8.0 * core::f64::consts::PI) * time).cos();
    [
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        R::literal(0.0),
        node_0_omega_dot_by_time,
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
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega,
    node_3_omega, node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    Outputs {
        theta_0: node_0_theta,
        omega_0: node_0_omega,
        theta_1: node_1_theta,
        omega_1: node_1_omega,
        theta_2: node_2_theta,
        omega_2: node_2_omega,
        theta_3: node_3_theta,
        omega_3: node_3_omega,
        theta_4: node_4_theta,
        omega_4: node_4_omega,
        theta_5: node_5_theta,
        omega_5: node_5_omega,
        theta_6: node_6_theta,
        omega_6: node_6_omega,
        theta_7: node_7_theta,
        omega_7: node_7_omega,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 60 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega,
    node_3_omega, node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let drive = R::literal(0.12)
        * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let node_0_theta_minus_drive = node_0_theta - drive;
    let node_0_theta_minus_node_1_theta = node_0_theta - node_1_theta;
    let node_3_theta_minus_node_4_theta = node_3_theta - node_4_theta;
    let node_4_theta_minus_node_5_theta = node_4_theta - node_5_theta;
    let node_6_theta_minus_node_7_theta = node_6_theta - node_7_theta;
    let node_1_theta_minus_node_2_theta = node_1_theta - node_2_theta;
    let node_2_theta_minus_node_3_theta = node_2_theta - node_3_theta;
    let node_5_theta_minus_node_6_theta = node_5_theta - node_6_theta;
    Energy {
        kinetic: (R::literal(0.000_293_718_971_360_403_13)
            * (node_0_omega * node_0_omega))
            .add_product(
                R::literal(0.000_293_718_971_360_403_13),
                node_7_omega * node_7_omega,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3),
                node_1_omega * node_1_omega,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3),
                node_2_omega * node_2_omega,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3),
                node_3_omega * node_3_omega,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3),
                node_5_omega * node_5_omega,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3),
                node_6_omega * node_6_omega,
            )
            .add_product(
                R::literal(0.026_219_437_942_720_806),
                node_4_omega * node_4_omega,
            ),
        potential: (R::literal(7800.0) * (node_4_theta * node_4_theta))
            .add_product(
                R::literal(22600.0),
                node_0_theta_minus_drive * node_0_theta_minus_drive,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_0_theta_minus_node_1_theta * node_0_theta_minus_node_1_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_1_theta_minus_node_2_theta * node_1_theta_minus_node_2_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_2_theta_minus_node_3_theta * node_2_theta_minus_node_3_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_3_theta_minus_node_4_theta * node_3_theta_minus_node_4_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_4_theta_minus_node_5_theta * node_4_theta_minus_node_5_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_5_theta_minus_node_6_theta * node_5_theta_minus_node_6_theta,
            )
            .add_product(
                R::literal(94_398.817_716_039_46),
                node_6_theta_minus_node_7_theta * node_6_theta_minus_node_7_theta,
            ),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 96 operations.
#[must_use]
pub fn power_balance<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
) -> PowerBalance<R> {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega,
    node_3_omega, node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let t0 = R::literal(8.0 * core::f64::consts::PI) * time;
    let (t1, t2) = t0.sin_cos();
    let drive = R::literal(0.12) * t1;
    let node_0_theta_minus_drive = node_0_theta - drive;
    let t3 = R::literal(188_797.635_432_078_9) * (node_0_theta - node_1_theta);
    let t4 = t3.add_product(R::literal(45200.0), node_0_theta_minus_drive);
    let t5 = R::literal(188_797.635_432_078_9) * (node_3_theta - node_4_theta);
    let t6 = R::literal(188_797.635_432_078_9) * (node_4_theta - node_5_theta);
    let t7 = t6.add_product(R::literal(15600.0), node_4_theta);
    let node_6_theta_minus_node_7_theta = node_6_theta - node_7_theta;
    let t8 = R::literal(188_797.635_432_078_9) * node_6_theta_minus_node_7_theta;
    let node_7_omega_dot = R::literal(321_391_625.739_451_8)
        * node_6_theta_minus_node_7_theta;
    let node_6_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_5_theta + node_7_theta).sub_product(R::literal(2.0), node_6_theta);
    let node_5_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_4_theta + node_6_theta).sub_product(R::literal(2.0), node_5_theta);
    let node_4_omega_dot = (t5 - t7) * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_2_theta + node_4_theta).sub_product(R::literal(2.0), node_3_theta);
    let node_2_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_1_theta + node_3_theta).sub_product(R::literal(2.0), node_2_theta);
    let node_1_omega_dot = R::literal(160_695_812.869_725_9)
        * (node_0_theta + node_2_theta).sub_product(R::literal(2.0), node_1_theta);
    let t9 = R::literal(136_319.988_424_568_3) * node_0_theta_minus_drive * t2;
    let t10 = R::literal(188_797.635_432_078_9) * (node_1_theta - node_2_theta);
    let t11 = R::literal(188_797.635_432_078_9) * (node_2_theta - node_3_theta);
    let t12 = R::literal(188_797.635_432_078_9) * (node_5_theta - node_6_theta);
    let t13 = (-t9)
        .add_product(t4, node_0_omega)
        .add_product(t10 - t3, node_1_omega)
        .add_product(t11 - t10, node_2_omega)
        .add_product(t5 - t11, node_3_omega)
        .add_product(t7 - t5, node_4_omega)
        .add_product(t12 - t6, node_5_omega)
        .add_product(t8 - t12, node_6_omega)
        .sub_product(t8, node_7_omega)
        .sub_product(
            R::literal(0.000_587_437_942_720_806_3) * node_0_omega,
            t4 * R::literal(1_702.307_473_310_885),
        )
        .add_product(
            R::literal(0.001_174_875_885_441_612_5) * node_1_omega,
            node_1_omega_dot,
        )
        .add_product(
            R::literal(0.001_174_875_885_441_612_5) * node_2_omega,
            node_2_omega_dot,
        )
        .add_product(
            R::literal(0.001_174_875_885_441_612_5) * node_3_omega,
            node_3_omega_dot,
        );
    PowerBalance {
        stored_rate: t13
            .add_product(
                R::literal(0.052_438_875_885_441_61) * node_4_omega,
                node_4_omega_dot,
            )
            .add_product(
                R::literal(0.001_174_875_885_441_612_5) * node_5_omega,
                node_5_omega_dot,
            )
            .add_product(
                R::literal(0.001_174_875_885_441_612_5) * node_6_omega,
                node_6_omega_dot,
            )
            .add_product(
                R::literal(0.000_587_437_942_720_806_3) * node_7_omega,
                node_7_omega_dot,
            ),
        supplied: -t9,
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 68 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    _workspace: &mut [R],
) {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta,
    node_5_theta, node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega,
    node_3_omega, node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let t0 = time * R::literal(8.0 * core::f64::consts::PI);
    let t1 = t0.sin();
    let t2 = t0.cos();
    let drive = t1 * R::literal(0.12);
    let t3 = node_0_theta - drive;
    let t4 = t3 * R::literal(45200.0);
    let t5 = node_0_theta - node_1_theta;
    let t6 = t5 * R::literal(188_797.635_432_078_9);
    let t7 = t4 + t6;
    let t8 = node_1_theta * R::literal(2.0);
    let t9 = node_0_theta + node_2_theta;
    let t10 = t9 - t8;
    let t11 = node_2_theta * R::literal(2.0);
    let t12 = node_1_theta + node_3_theta;
    let t13 = t12 - t11;
    let t14 = node_3_theta * R::literal(2.0);
    let t15 = node_2_theta + node_4_theta;
    let t16 = t15 - t14;
    let t17 = node_3_theta - node_4_theta;
    let t18 = t17 * R::literal(188_797.635_432_078_9);
    let t19 = node_4_theta * R::literal(15600.0);
    let t20 = node_4_theta - node_5_theta;
    let t21 = t20 * R::literal(188_797.635_432_078_9);
    let t22 = t19 + t21;
    let t23 = t18 - t22;
    let t24 = node_5_theta * R::literal(2.0);
    let t25 = node_4_theta + node_6_theta;
    let t26 = t25 - t24;
    let t27 = node_6_theta * R::literal(2.0);
    let t28 = node_5_theta + node_7_theta;
    let t29 = t28 - t27;
    let t30 = node_6_theta - node_7_theta;
    let node_7_omega_dot = t30 * R::literal(321_391_625.739_451_8);
    let node_6_omega_dot = t29 * R::literal(160_695_812.869_725_9);
    let node_5_omega_dot = t26 * R::literal(160_695_812.869_725_9);
    let node_4_omega_dot = t23 * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = t16 * R::literal(160_695_812.869_725_9);
    let node_2_omega_dot = t13 * R::literal(160_695_812.869_725_9);
    let node_1_omega_dot = t10 * R::literal(160_695_812.869_725_9);
    let t31 = t7 * R::literal(1_702.307_473_310_885);
    let node_0_omega_dot = -t31;
    let mut t1_before = t1;
    let mut t2_before = t2;
    let mut rates = [
        node_0_omega,
        node_1_omega,
        node_2_omega,
        node_3_omega,
        node_4_omega,
        node_5_omega,
        node_6_omega,
        node_7_omega,
        node_0_omega_dot,
        node_1_omega_dot,
        node_2_omega_dot,
        node_3_omega_dot,
        node_4_omega_dot,
        node_5_omega_dot,
        node_6_omega_dot,
        node_7_omega_dot,
    ];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [node_0_theta_k, node_1_theta_k, node_2_theta_k, node_3_theta_k,
        node_4_theta_k, node_5_theta_k, node_6_theta_k, node_7_theta_k, node_0_omega_k,
        node_1_omega_k, node_2_omega_k, node_3_omega_k, node_4_omega_k, node_5_omega_k,
        node_6_omega_k, node_7_omega_k] = *state_k;
        let t1_k = inverse * R::literal(8.0 * core::f64::consts::PI) * t2_before;
        let t2_k = -inverse * R::literal(8.0 * core::f64::consts::PI) * t1_before;
        let t3_k = (-t1_k).mul_add(R::literal(0.12), node_0_theta_k);
        let t5_k = node_0_theta_k - node_1_theta_k;
        let t7_k = t5_k
            .mul_add(R::literal(188_797.635_432_078_9), t3_k * R::literal(45200.0));
        let t9_k = node_0_theta_k + node_2_theta_k;
        let t10_k = (-node_1_theta_k).mul_add(R::literal(2.0), t9_k);
        let t12_k = node_1_theta_k + node_3_theta_k;
        let t13_k = (-node_2_theta_k).mul_add(R::literal(2.0), t12_k);
        let t15_k = node_2_theta_k + node_4_theta_k;
        let t16_k = (-node_3_theta_k).mul_add(R::literal(2.0), t15_k);
        let t17_k = node_3_theta_k - node_4_theta_k;
        let t20_k = node_4_theta_k - node_5_theta_k;
        let t22_k = t20_k
            .mul_add(
                R::literal(188_797.635_432_078_9),
                node_4_theta_k * R::literal(15600.0),
            );
        let t23_k = t17_k.mul_add(R::literal(188_797.635_432_078_9), -t22_k);
        let t25_k = node_4_theta_k + node_6_theta_k;
        let t26_k = (-node_5_theta_k).mul_add(R::literal(2.0), t25_k);
        let t28_k = node_5_theta_k + node_7_theta_k;
        let t29_k = (-node_6_theta_k).mul_add(R::literal(2.0), t28_k);
        let t30_k = node_6_theta_k - node_7_theta_k;
        let node_7_omega_dot_k = t30_k * R::literal(321_391_625.739_451_8);
        let node_6_omega_dot_k = t29_k * R::literal(160_695_812.869_725_9);
        let node_5_omega_dot_k = t26_k * R::literal(160_695_812.869_725_9);
        let node_4_omega_dot_k = t23_k * R::literal(19.069_821_446_680_283);
        let node_3_omega_dot_k = t16_k * R::literal(160_695_812.869_725_9);
        let node_2_omega_dot_k = t13_k * R::literal(160_695_812.869_725_9);
        let node_1_omega_dot_k = t10_k * R::literal(160_695_812.869_725_9);
        let t31_k = t7_k * R::literal(1_702.307_473_310_885);
        let node_0_omega_dot_k = -t31_k;
        t1_before = t1_k;
        t2_before = t2_k;
        rates = [
            node_0_omega_k,
            node_1_omega_k,
            node_2_omega_k,
            node_3_omega_k,
            node_4_omega_k,
            node_5_omega_k,
            node_6_omega_k,
            node_7_omega_k,
            node_0_omega_dot_k,
            node_1_omega_dot_k,
            node_2_omega_dot_k,
            node_3_omega_dot_k,
            node_4_omega_dot_k,
            node_5_omega_dot_k,
            node_6_omega_dot_k,
            node_7_omega_dot_k,
        ];
    }
}

impl<R: Real> TaylorSeries<R> for M47 {
    fn series_workspace(&self, _order: usize) -> usize {
        0
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

/// Entry of the state on whose rate a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k.
pub const EXCITATION_TERMS: [(u32, u32); 1] = [(8, 0)];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, on the piece that holds `time`.
///
/// No operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _p: &Parameters<R>) -> [R; 4] {
    [
        R::literal(0.0),
        R::literal(8.0 * core::f64::consts::PI),
        R::literal(0.0),
        R::literal(9_233_315.735_238_24),
    ]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none.
///
/// No operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

impl<R: Real> LinearEquations<R> for M47 {
    fn excitation_terms(&self) -> &[(u32, u32)] {
        &EXCITATION_TERMS
    }
    fn excitation(&self, time: R, parameters: &[R], values: &mut [R]) {
        values.copy_from_slice(&excitation(time, &parameters_of(parameters)));
    }
    fn switches(&self) -> usize {
        SWITCHES
    }
    fn switch_times(&self, parameters: &[R], times: &mut [R]) {
        times.copy_from_slice(&switches(&parameters_of(parameters)));
    }
}

impl Describe for M47 {
    fn name(&self) -> &'static str {
        "m4_7"
    }
    fn title(&self) -> &'static str {
        "Benchmark M4: reed as a torsional shaft of 7 pieces"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 8,
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

impl<R: Real> Simulator<R> for M47 {
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
    fn linear(&self) -> Option<&dyn LinearEquations<R>> {
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
        name: "node_0.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_1.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_2.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_3.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_4.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_5.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_6.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_7.theta",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "node_0.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_1.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_2.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_3.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_4.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_5.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_6.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "node_7.omega",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

static STATE_SCALES: [f64; STATES] = [
    0.12,
    0.12,
    0.12,
    0.12,
    0.12,
    0.12,
    0.12,
    0.12,
    3.0,
    3.0,
    3.0,
    3.0,
    3.0,
    3.0,
    3.0,
    3.0,
];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "theta_0",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_0",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_1",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_1",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_2",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_2",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_3",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_3",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_4",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_4",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_5",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_5",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_6",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_6",
        unit: "rad/s",
        doc: "rate of angle",
    },
    Quantity {
        name: "theta_7",
        unit: "rad",
        doc: "angle",
    },
    Quantity {
        name: "omega_7",
        unit: "rad/s",
        doc: "rate of angle",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 0.5,
    points: 501,
    rtol: 1e-8,
    method: "auto",
};

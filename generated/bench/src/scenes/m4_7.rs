// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   0390d7ccbdf5d22cab1afb0e2611bfa04238f8fae12458bea6b641beb10677a7  bench/m4_7.toml
//
// Benchmark M4: reed as a torsional shaft of 7 pieces
//
// An undamped shaft is driven by a spring at one end. The reed and a spring to ground act at four
// sevenths of its length.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 8, states 16, outputs 16.
// Nonzeros: mass_matrix 8 of 8 by 8, rate_jacobian 30 of 16 by 16, parameter_jacobian 0 of 16 by 0.
// Operations: rate 36, forcing 28, time_derivative 3, energy 60, power_balance 86.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Benchmark M4: reed as a torsional shaft of 7 pieces
    ///
    /// An undamped shaft is driven by a spring at one end. The reed and a spring to ground act at four
    /// sevenths of its length.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M47: "m4_7", "Benchmark M4: reed as a torsional shaft of 7 pieces";
    run from 0.0, until 0.5, points 501, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    linear; series 0;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    theta_0: "rad", "theta_0", "angle";
    omega_0: "rad/s", "omega_0", "rate of angle";
    theta_1: "rad", "theta_1", "angle";
    omega_1: "rad/s", "omega_1", "rate of angle";
    theta_2: "rad", "theta_2", "angle";
    omega_2: "rad/s", "omega_2", "rate of angle";
    theta_3: "rad", "theta_3", "angle";
    omega_3: "rad/s", "omega_3", "rate of angle";
    theta_4: "rad", "theta_4", "angle";
    omega_4: "rad/s", "omega_4", "rate of angle";
    theta_5: "rad", "theta_5", "angle";
    omega_5: "rad/s", "omega_5", "rate of angle";
    theta_6: "rad", "theta_6", "angle";
    omega_6: "rad/s", "omega_6", "rate of angle";
    theta_7: "rad", "theta_7", "angle";
    omega_7: "rad/s", "omega_7", "rate of angle";
}

::machinist_contract::states! {
    NODE_0_THETA: position, 0.12, "rad", "node_0.theta", "angle";
    NODE_1_THETA: position, 0.12, "rad", "node_1.theta", "angle";
    NODE_2_THETA: position, 0.12, "rad", "node_2.theta", "angle";
    NODE_3_THETA: position, 0.12, "rad", "node_3.theta", "angle";
    NODE_4_THETA: position, 0.12, "rad", "node_4.theta", "angle";
    NODE_5_THETA: position, 0.12, "rad", "node_5.theta", "angle";
    NODE_6_THETA: position, 0.12, "rad", "node_6.theta", "angle";
    NODE_7_THETA: position, 0.12, "rad", "node_7.theta", "angle";
    NODE_0_OMEGA: velocity, 3.0, "rad/s", "node_0.omega", "rate of angle";
    NODE_1_OMEGA: velocity, 3.0, "rad/s", "node_1.omega", "rate of angle";
    NODE_2_OMEGA: velocity, 3.0, "rad/s", "node_2.omega", "rate of angle";
    NODE_3_OMEGA: velocity, 3.0, "rad/s", "node_3.omega", "rate of angle";
    NODE_4_OMEGA: velocity, 3.0, "rad/s", "node_4.omega", "rate of angle";
    NODE_5_OMEGA: velocity, 3.0, "rad/s", "node_5.omega", "rate of angle";
    NODE_6_OMEGA: velocity, 3.0, "rad/s", "node_6.omega", "rate of angle";
    NODE_7_OMEGA: velocity, 3.0, "rad/s", "node_7.omega", "rate of angle";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 8 by 8 { 0 [0] 1 [1] 2 [2] 3 [3] 4 [4] 5 [5] 6 [6] 7 [7] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 16 by 16 { 0 [8] 1 [9] 2 [10] 3 [11] 4 [12] 5 [13] 6 [14] 7 [15] 8 [0 1]
        9 [0 1 2] 10 [1 2 3] 11 [2 3 4] 12 [3 4 5] 13 [4 5 6] 14 [5 6 7] 15 [6 7] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 16 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 36 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega, node_3_omega,
        node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let t0 = R::literal(188_797.635_432_078_9) * (node_0_theta - node_1_theta);
    let t1 = R::literal(188_797.635_432_078_9) * (node_1_theta - node_2_theta);
    let t2 = R::literal(188_797.635_432_078_9) * (node_2_theta - node_3_theta);
    let t3 = R::literal(188_797.635_432_078_9) * (node_3_theta - node_4_theta);
    let t4 = R::literal(188_797.635_432_078_9) * (node_4_theta - node_5_theta);
    let t5 = R::literal(188_797.635_432_078_9) * (node_5_theta - node_6_theta);
    let node_6_theta_minus_node_7_theta = node_6_theta - node_7_theta;
    let node_7_omega_dot = R::literal(321_391_625.739_451_8) * node_6_theta_minus_node_7_theta;
    let node_6_omega_dot = t5.sub_product(R::literal(188_797.635_432_078_9),
        node_6_theta_minus_node_7_theta) * R::literal(851.153_736_655_442_5);
    let node_5_omega_dot = (t4 - t5) * R::literal(851.153_736_655_442_5);
    let node_4_omega_dot = (t3 - t4.add_product(R::literal(15600.0), node_4_theta))
        * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = (t2 - t3) * R::literal(851.153_736_655_442_5);
    let node_2_omega_dot = (t1 - t2) * R::literal(851.153_736_655_442_5);
    let node_1_omega_dot = (t0 - t1) * R::literal(851.153_736_655_442_5);
    let node_0_omega_dot = (-t0).add_product(R::literal(-45200.0), node_0_theta - drive)
        * R::literal(1_702.307_473_310_885);
    [node_0_omega, node_1_omega, node_2_omega, node_3_omega, node_4_omega, node_5_omega,
        node_6_omega, node_7_omega, node_0_omega_dot, node_1_omega_dot, node_2_omega_dot,
        node_3_omega_dot, node_4_omega_dot, node_5_omega_dot, node_6_omega_dot, node_7_omega_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 8] {
    [R::literal(0.000_587_437_942_720_806_3), R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.001_174_875_885_441_612_5), R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.052_438_875_885_441_61), R::literal(0.001_174_875_885_441_612_5),
        R::literal(0.001_174_875_885_441_612_5), R::literal(0.000_587_437_942_720_806_3)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 28 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, ..] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let t0 = R::literal(188_797.635_432_078_9) * (node_0_theta - node_1_theta);
    let node_0_theta_forcing = (-t0).add_product(R::literal(-45200.0), node_0_theta - drive);
    let t1 = R::literal(188_797.635_432_078_9) * (node_1_theta - node_2_theta);
    let node_1_theta_forcing = t0 - t1;
    let t2 = R::literal(188_797.635_432_078_9) * (node_2_theta - node_3_theta);
    let node_2_theta_forcing = t1 - t2;
    let t3 = R::literal(188_797.635_432_078_9) * (node_3_theta - node_4_theta);
    let node_3_theta_forcing = t2 - t3;
    let t4 = R::literal(188_797.635_432_078_9) * (node_4_theta - node_5_theta);
    let node_4_theta_forcing = t3 - t4.add_product(R::literal(15600.0), node_4_theta);
    let t5 = R::literal(188_797.635_432_078_9) * (node_5_theta - node_6_theta);
    let node_5_theta_forcing = t4 - t5;
    let node_7_theta_forcing = R::literal(188_797.635_432_078_9) * (node_6_theta - node_7_theta);
    let node_6_theta_forcing = t5 - node_7_theta_forcing;
    [node_0_theta_forcing, node_1_theta_forcing, node_2_theta_forcing, node_3_theta_forcing,
        node_4_theta_forcing, node_5_theta_forcing, node_6_theta_forcing, node_7_theta_forcing]
}

/// `dy'/dy`, values in the order of its pattern. No operations.
#[must_use]
pub fn rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 30] {
    [R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(1.0),
        R::literal(1.0), R::literal(1.0), R::literal(1.0), R::literal(-398_335_923.533_103_8),
        R::literal(321_391_625.739_451_8), R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8), R::literal(160_695_812.869_725_9),
        R::literal(160_695_812.869_725_9), R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9), R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8), R::literal(160_695_812.869_725_9),
        R::literal(3_600_337.197_245_184), R::literal(-7_498_163.609_058_579),
        R::literal(3_600_337.197_245_184), R::literal(160_695_812.869_725_9),
        R::literal(-321_391_625.739_451_8), R::literal(160_695_812.869_725_9),
        R::literal(160_695_812.869_725_9), R::literal(-321_391_625.739_451_8),
        R::literal(160_695_812.869_725_9), R::literal(321_391_625.739_451_8),
        R::literal(-321_391_625.739_451_8)]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let node_0_omega_dot_by_time = R::literal(232_058_535.056_795_92)
        * (R::literal(8.0 * core::f64::consts::PI) * time).cos();
    [R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0), R::literal(0.0), node_0_omega_dot_by_time,
        R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0), R::literal(0.0),
        R::literal(0.0), R::literal(0.0)]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega, node_3_omega,
        node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
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

/// T, V and the energy of first-order states \[J\]. 60 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega, node_3_omega,
        node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let drive = R::literal(0.12) * (R::literal(8.0 * core::f64::consts::PI) * time).sin();
    let node_0_theta_minus_drive = node_0_theta - drive;
    let node_0_theta_minus_node_1_theta = node_0_theta - node_1_theta;
    let node_1_theta_minus_node_2_theta = node_1_theta - node_2_theta;
    let node_2_theta_minus_node_3_theta = node_2_theta - node_3_theta;
    let node_3_theta_minus_node_4_theta = node_3_theta - node_4_theta;
    let node_4_theta_minus_node_5_theta = node_4_theta - node_5_theta;
    let node_5_theta_minus_node_6_theta = node_5_theta - node_6_theta;
    let node_6_theta_minus_node_7_theta = node_6_theta - node_7_theta;
    Energy {
        kinetic: (R::literal(0.000_293_718_971_360_403_13) * (node_0_omega * node_0_omega))
            .add_product(R::literal(0.000_293_718_971_360_403_13), node_7_omega * node_7_omega)
            .add_product(R::literal(0.000_587_437_942_720_806_3), node_1_omega * node_1_omega)
            .add_product(R::literal(0.000_587_437_942_720_806_3), node_2_omega * node_2_omega)
            .add_product(R::literal(0.000_587_437_942_720_806_3), node_3_omega * node_3_omega)
            .add_product(R::literal(0.000_587_437_942_720_806_3), node_5_omega * node_5_omega)
            .add_product(R::literal(0.000_587_437_942_720_806_3), node_6_omega * node_6_omega)
            .add_product(R::literal(0.026_219_437_942_720_806), node_4_omega * node_4_omega),
        potential: (R::literal(7800.0) * (node_4_theta * node_4_theta))
            .add_product(R::literal(22600.0), node_0_theta_minus_drive * node_0_theta_minus_drive)
            .add_product(R::literal(94_398.817_716_039_46), node_0_theta_minus_node_1_theta
            * node_0_theta_minus_node_1_theta).add_product(R::literal(94_398.817_716_039_46),
            node_1_theta_minus_node_2_theta * node_1_theta_minus_node_2_theta)
            .add_product(R::literal(94_398.817_716_039_46), node_2_theta_minus_node_3_theta
            * node_2_theta_minus_node_3_theta).add_product(R::literal(94_398.817_716_039_46),
            node_3_theta_minus_node_4_theta * node_3_theta_minus_node_4_theta)
            .add_product(R::literal(94_398.817_716_039_46), node_4_theta_minus_node_5_theta
            * node_4_theta_minus_node_5_theta).add_product(R::literal(94_398.817_716_039_46),
            node_5_theta_minus_node_6_theta * node_5_theta_minus_node_6_theta)
            .add_product(R::literal(94_398.817_716_039_46), node_6_theta_minus_node_7_theta
            * node_6_theta_minus_node_7_theta),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 86 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> PowerBalance<R> {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega, node_3_omega,
        node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let t0 = R::literal(8.0 * core::f64::consts::PI) * time;
    let (t1, t2) = t0.sin_cos();
    let drive = R::literal(0.12) * t1;
    let node_0_theta_minus_drive = node_0_theta - drive;
    let t3 = R::literal(188_797.635_432_078_9) * (node_0_theta - node_1_theta);
    let t4 = t3.add_product(R::literal(45200.0), node_0_theta_minus_drive);
    let t5 = R::literal(188_797.635_432_078_9) * (node_1_theta - node_2_theta);
    let t6 = R::literal(188_797.635_432_078_9) * (node_2_theta - node_3_theta);
    let t7 = R::literal(188_797.635_432_078_9) * (node_3_theta - node_4_theta);
    let t8 = R::literal(188_797.635_432_078_9) * (node_4_theta - node_5_theta);
    let t9 = t8.add_product(R::literal(15600.0), node_4_theta);
    let t10 = R::literal(188_797.635_432_078_9) * (node_5_theta - node_6_theta);
    let node_6_theta_minus_node_7_theta = node_6_theta - node_7_theta;
    let t11 = R::literal(188_797.635_432_078_9) * node_6_theta_minus_node_7_theta;
    let node_7_omega_dot = R::literal(321_391_625.739_451_8) * node_6_theta_minus_node_7_theta;
    let node_6_omega_dot = (t10 - t11) * R::literal(851.153_736_655_442_5);
    let node_5_omega_dot = (t8 - t10) * R::literal(851.153_736_655_442_5);
    let node_4_omega_dot = (t7 - t9) * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = (t6 - t7) * R::literal(851.153_736_655_442_5);
    let node_2_omega_dot = (t5 - t6) * R::literal(851.153_736_655_442_5);
    let node_1_omega_dot = (t3 - t5) * R::literal(851.153_736_655_442_5);
    let t12 = R::literal(136_319.988_424_568_3) * node_0_theta_minus_drive * t2;
    let t13 = (-t12).add_product(t4, node_0_omega).add_product(t5 - t3, node_1_omega)
        .add_product(t6 - t5, node_2_omega).add_product(t7 - t6, node_3_omega).add_product(t9 - t7,
        node_4_omega).add_product(t10 - t8, node_5_omega).add_product(t11 - t10, node_6_omega)
        .sub_product(t11, node_7_omega).sub_product(R::literal(0.000_587_437_942_720_806_3)
        * node_0_omega, t4 * R::literal(1_702.307_473_310_885))
        .add_product(R::literal(0.001_174_875_885_441_612_5) * node_1_omega, node_1_omega_dot)
        .add_product(R::literal(0.001_174_875_885_441_612_5) * node_2_omega, node_2_omega_dot)
        .add_product(R::literal(0.001_174_875_885_441_612_5) * node_3_omega, node_3_omega_dot);
    PowerBalance {
        stored_rate: t13.add_product(R::literal(0.052_438_875_885_441_61) * node_4_omega,
            node_4_omega_dot).add_product(R::literal(0.001_174_875_885_441_612_5) * node_5_omega,
            node_5_omega_dot).add_product(R::literal(0.001_174_875_885_441_612_5) * node_6_omega,
            node_6_omega_dot).add_product(R::literal(0.000_587_437_942_720_806_3) * node_7_omega,
            node_7_omega_dot),
        supplied: -t12,
        dissipated: R::literal(0.0),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 63 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
    let [node_0_theta, node_1_theta, node_2_theta, node_3_theta, node_4_theta, node_5_theta,
        node_6_theta, node_7_theta, node_0_omega, node_1_omega, node_2_omega, node_3_omega,
        node_4_omega, node_5_omega, node_6_omega, node_7_omega] = *state;
    let t0 = time * R::literal(8.0 * core::f64::consts::PI);
    let t1 = t0.sin();
    let t2 = t0.cos();
    let drive = t1 * R::literal(0.12);
    let t3 = node_0_theta - drive;
    let t4 = node_0_theta - node_1_theta;
    let t5 = t4 * R::literal(188_797.635_432_078_9);
    let t6 = node_1_theta - node_2_theta;
    let t7 = t6 * R::literal(188_797.635_432_078_9);
    let t8 = t5 - t7;
    let t9 = node_2_theta - node_3_theta;
    let t10 = t9 * R::literal(188_797.635_432_078_9);
    let t11 = t7 - t10;
    let t12 = node_3_theta - node_4_theta;
    let t13 = t12 * R::literal(188_797.635_432_078_9);
    let t14 = t10 - t13;
    let t15 = node_4_theta * R::literal(15600.0);
    let t16 = node_4_theta - node_5_theta;
    let t17 = t16 * R::literal(188_797.635_432_078_9);
    let t18 = t15 + t17;
    let t19 = t13 - t18;
    let t20 = node_5_theta - node_6_theta;
    let t21 = t20 * R::literal(188_797.635_432_078_9);
    let t22 = t17 - t21;
    let t23 = node_6_theta - node_7_theta;
    let t24 = t23 * R::literal(188_797.635_432_078_9);
    let t25 = t21 - t24;
    let node_7_omega_dot = t23 * R::literal(321_391_625.739_451_8);
    let node_6_omega_dot = t25 * R::literal(851.153_736_655_442_5);
    let node_5_omega_dot = t22 * R::literal(851.153_736_655_442_5);
    let node_4_omega_dot = t19 * R::literal(19.069_821_446_680_283);
    let node_3_omega_dot = t14 * R::literal(851.153_736_655_442_5);
    let node_2_omega_dot = t11 * R::literal(851.153_736_655_442_5);
    let node_1_omega_dot = t8 * R::literal(851.153_736_655_442_5);
    let t26 = t3 * R::literal(-45200.0);
    let t27 = t26 - t5;
    let node_0_omega_dot = t27 * R::literal(1_702.307_473_310_885);
    let mut t1_before = t1;
    let mut t2_before = t2;
    let mut rates = [node_0_omega, node_1_omega, node_2_omega, node_3_omega, node_4_omega,
        node_5_omega, node_6_omega, node_7_omega, node_0_omega_dot, node_1_omega_dot,
        node_2_omega_dot, node_3_omega_dot, node_4_omega_dot, node_5_omega_dot, node_6_omega_dot,
        node_7_omega_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [node_0_theta_k, node_1_theta_k, node_2_theta_k, node_3_theta_k, node_4_theta_k,
            node_5_theta_k, node_6_theta_k, node_7_theta_k, node_0_omega_k, node_1_omega_k,
            node_2_omega_k, node_3_omega_k, node_4_omega_k, node_5_omega_k, node_6_omega_k,
            node_7_omega_k] = *state_k;
        let t1_k = inverse * R::literal(8.0 * core::f64::consts::PI) * t2_before;
        let t2_k = -inverse * R::literal(8.0 * core::f64::consts::PI) * t1_before;
        let t3_k = (-t1_k).mul_add(R::literal(0.12), node_0_theta_k);
        let t4_k = node_0_theta_k - node_1_theta_k;
        let t5_k = t4_k * R::literal(188_797.635_432_078_9);
        let t6_k = node_1_theta_k - node_2_theta_k;
        let t7_k = t6_k * R::literal(188_797.635_432_078_9);
        let t8_k = t5_k - t7_k;
        let t9_k = node_2_theta_k - node_3_theta_k;
        let t10_k = t9_k * R::literal(188_797.635_432_078_9);
        let t11_k = t7_k - t10_k;
        let t12_k = node_3_theta_k - node_4_theta_k;
        let t13_k = t12_k * R::literal(188_797.635_432_078_9);
        let t14_k = t10_k - t13_k;
        let t16_k = node_4_theta_k - node_5_theta_k;
        let t17_k = t16_k * R::literal(188_797.635_432_078_9);
        let t18_k = node_4_theta_k.mul_add(R::literal(15600.0), t17_k);
        let t19_k = t13_k - t18_k;
        let t20_k = node_5_theta_k - node_6_theta_k;
        let t21_k = t20_k * R::literal(188_797.635_432_078_9);
        let t22_k = t17_k - t21_k;
        let t23_k = node_6_theta_k - node_7_theta_k;
        let t25_k = (-t23_k).mul_add(R::literal(188_797.635_432_078_9), t21_k);
        let node_7_omega_dot_k = t23_k * R::literal(321_391_625.739_451_8);
        let node_6_omega_dot_k = t25_k * R::literal(851.153_736_655_442_5);
        let node_5_omega_dot_k = t22_k * R::literal(851.153_736_655_442_5);
        let node_4_omega_dot_k = t19_k * R::literal(19.069_821_446_680_283);
        let node_3_omega_dot_k = t14_k * R::literal(851.153_736_655_442_5);
        let node_2_omega_dot_k = t11_k * R::literal(851.153_736_655_442_5);
        let node_1_omega_dot_k = t8_k * R::literal(851.153_736_655_442_5);
        let t27_k = t3_k.mul_add(R::literal(-45200.0), -t5_k);
        let node_0_omega_dot_k = t27_k * R::literal(1_702.307_473_310_885);
        t1_before = t1_k;
        t2_before = t2_k;
        rates = [node_0_omega_k, node_1_omega_k, node_2_omega_k, node_3_omega_k, node_4_omega_k,
            node_5_omega_k, node_6_omega_k, node_7_omega_k, node_0_omega_dot_k, node_1_omega_dot_k,
            node_2_omega_dot_k, node_3_omega_dot_k, node_4_omega_dot_k, node_5_omega_dot_k,
            node_6_omega_dot_k, node_7_omega_dot_k];
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 1] = [(8, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. No operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 4] {
    [R::literal(0.0), R::literal(8.0 * core::f64::consts::PI), R::literal(0.0),
        R::literal(9_233_315.735_238_24)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

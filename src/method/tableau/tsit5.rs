//! The pair of orders 5 and 4 by Tsitouras, with a dense output of order 4.
//!
//! Ch. Tsitouras: Runge-Kutta pairs of order 5(4) satisfying only the first
//! column simplifying assumption, Computers & Mathematics with Applications 62
//! (2011) 770-775.
// Published to sixteen digits.
#![allow(clippy::unreadable_literal)]

use super::{Dense, Pair, Row};

/// Coefficients; the seventh stage is the rate at the end of the step.
pub(in crate::method) static TSIT5: Pair = Pair {
    order: 5,
    nodes: &[0.0, 0.161, 0.327, 0.9, 0.9800255409045097, 1.0, 1.0],
    rows: &ROWS,
    estimates: &[ESTIMATE],
    estimate_order: 4,
    dense: Dense { extra: &[], weights: dense_weights },
    stability: 3.4,
};

const ROWS: [Row; 7] = [
    &[],
    &[(0, 0.161)],
    &[(0, -0.008480655492356989), (1, 0.335480655492357)],
    &[(0, 2.8971530571054935), (1, -6.359448489975075), (2, 4.3622954328695815)],
    &[
        (0, 5.325864828439257),
        (1, -11.748883564062828),
        (2, 7.4955393428898365),
        (3, -0.09249506636175525),
    ],
    &[
        (0, 5.86145544294642),
        (1, -12.92096931784711),
        (2, 8.159367898576159),
        (3, -0.071584973281401),
        (4, -0.028269050394068383),
    ],
    &[
        (0, 0.09646076681806523),
        (1, 0.01),
        (2, 0.4798896504144996),
        (3, 1.379008574103742),
        (4, -3.290069515436081),
        (5, 2.324710524099774),
    ],
];

/// b minus the weights of the embedded formula of order 4.
const ESTIMATE: Row = &[
    (0, -0.001780011052225777),
    (1, -0.0008164344596567469),
    (2, 0.007880878010261995),
    (3, -0.1447110071732629),
    (4, 0.5823571654525552),
    (5, -0.45808210592918697),
    (6, 0.015151515151515152),
];

/// Coefficients of theta^2, theta^3, theta^4 in b_i(theta); theta itself occurs only in b_1.
const DENSE: [[f64; 3]; 7] = [
    [-2.763706197274826, 2.9132554618219126, -1.0530884977290216],
    [0.1317, -0.2234, 0.1017],
    [3.9302962368947516, -5.941033872131505, 2.490627285651253],
    [-12.411077166933676, 30.33818863028232, -16.548102889244902],
    [37.50931341651104, -88.1789048947664, 47.37952196281928],
    [-27.896526289197286, 65.09189467479366, -34.87065786149661],
    [1.5, -4.0, 2.5],
];

/// Computes b_i(theta) of y(t + theta h) = y + h sum b_i(theta) k_i.
fn dense_weights(theta: f64, weights: &mut [f64]) {
    for (weight, [second, third, fourth]) in weights.iter_mut().zip(DENSE) {
        *weight = theta * theta * (second + theta * (third + theta * fourth));
    }
    weights[0] += theta;
}

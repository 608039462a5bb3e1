// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo run --release -- gen
//
// Sources, with SHA-256:
//   30a0b19f7c11ee986913e2eee136a038a72344987d5fa4cd17daf5bcdc746420  bench/m5.toml
//
// Benchmark M5: winder
//
// One degree of freedom, excited by a force and a moving support at two frequencies.
//
// Source:
//   Benchmark models of textile-machine dynamics.
//
// All quantities are in SI units.
// Shapes: coordinates 1, states 2, outputs 2.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 3 of 2 by 2, parameter_jacobian 0 of 2 by 0.
// Operations: rate 12, forcing 11, time_derivative 8, energy 11, power_balance 30.

use ::machinist_contract::{Energy, PowerBalance, Real, taylor::order_and_inverse};

::machinist_contract::simulator! {
    /// Benchmark M5: winder
    ///
    /// One degree of freedom, excited by a force and a moving support at two frequencies.
    ///
    /// Source: Benchmark models of textile-machine dynamics.
    M5: "m5", "Benchmark M5: winder";
    run from 0.0, until 5.0, points 2001, rtol 1e-8, method "auto";
    quadratures 0, discontinuities 0;
    linear; series 0;
}

::machinist_contract::parameters! {}

::machinist_contract::outputs! {
    q: "m", "q", "displacement of the lever";
    v: "m/s", "v", "rate of displacement of the lever";
}

::machinist_contract::states! {
    WINDER_Q: position, 0.001, "m", "winder.q", "displacement of the lever";
    WINDER_V: velocity, 0.1, "m/s", "winder.v", "rate of displacement of the lever";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 2 by 2 { 0 [1] 1 [0 1] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 2 by 0 {  }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(_p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    []
}

/// `y'`: velocities, `q''` of `M q'' = f + G^T lambda`, `h`; in the units of the states per second.
/// 12 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [winder_q, winder_v] = *state;
    let [(t0, _), (t1, _)] = R::sin_cos_each([R::literal(220.0) * time, R::literal(110.0) * time]);
    let winder_v_dot = (R::literal(8.4) * t0).add_product(R::literal(25.0), t1)
        .sub_product(R::literal(45800.0), winder_q).sub_product(R::literal(95.0), winder_v)
        * R::literal(0.476_190_476_190_476_16);
    [winder_v, winder_v_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. No operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 1] {
    [R::literal(2.1)]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 11 operations.
#[must_use]
pub fn forcing<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> [R; COORDINATES] {
    let [winder_q, winder_v] = *state;
    let [(t0, _), (t1, _)] = R::sin_cos_each([R::literal(220.0) * time, R::literal(110.0) * time]);
    let winder_q_forcing = (R::literal(8.4) * t0).add_product(R::literal(25.0), t1)
        .sub_product(R::literal(45800.0), winder_q).sub_product(R::literal(95.0), winder_v);
    [winder_q_forcing]
}

/// `dy'/dy`, values in the order of its pattern. No operations.
#[must_use]
pub fn rate_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 3] {
    [R::literal(1.0), R::literal(-21_809.523_809_523_81), R::literal(-45.238_095_238_095_234)]
}

/// `dy'/dp`, values in the order of its pattern. No operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 0] {
    []
}

/// Partial derivative of `y'` with respect to time. 8 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; STATES] {
    let [(_, t0), (_, t1)] = R::sin_cos_each([R::literal(220.0) * time, R::literal(110.0) * time]);
    let winder_v_dot_by_time = (R::literal(1848.0) * t0).add_product(R::literal(2750.0), t1)
        * R::literal(0.476_190_476_190_476_16);
    [R::literal(0.0), winder_v_dot_by_time]
}

/// Wanted outputs. No operations.
#[must_use]
pub fn outputs<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>) -> Outputs<R> {
    let [winder_q, winder_v] = *state;
    Outputs {
        q: winder_q,
        v: winder_v,
    }
}

/// T, V and the energy of first-order states \[J\]. 11 operations.
#[must_use]
pub fn energy<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> Energy<R> {
    let [winder_q, winder_v] = *state;
    let winder_surface = R::literal(0.0002) * (R::literal(220.0) * time).sin();
    let winder_q_minus_winder_surface = winder_q - winder_surface;
    Energy {
        kinetic: R::literal(1.05) * (winder_v * winder_v),
        potential: (R::literal(1900.0) * (winder_q * winder_q)).add_product(R::literal(21000.0),
            winder_q_minus_winder_surface * winder_q_minus_winder_surface),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 30 operations.
#[must_use]
pub fn power_balance<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>) -> PowerBalance<R> {
    let [winder_q, winder_v] = *state;
    let t0 = R::literal(220.0) * time;
    let [(t1, t2), (t3, _)] = R::sin_cos_each([t0, R::literal(110.0) * time]);
    let winder_surface = R::literal(0.0002) * t1;
    let winder_v_dot = (R::literal(8.4) * t1).add_product(R::literal(25.0), t3)
        .sub_product(R::literal(45800.0), winder_q).sub_product(R::literal(95.0), winder_v)
        * R::literal(0.476_190_476_190_476_16);
    let winder_q_minus_winder_surface = winder_q - winder_surface;
    let t4 = R::literal(1848.0) * winder_q_minus_winder_surface * t2;
    PowerBalance {
        stored_rate: (-t4).add_product((R::literal(3800.0) * winder_q)
            .add_product(R::literal(42000.0), winder_q_minus_winder_surface), winder_v)
            .add_product(R::literal(2.1) * winder_v, winder_v_dot),
        supplied: (-t4).add_product(R::literal(25.0) * winder_v, t3),
        dissipated: R::literal(95.0) * (winder_v * winder_v),
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 24 recurrences. No sums of products.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], _p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], _workspace: &mut [R]) {
    let [winder_q, winder_v] = *state;
    let t0 = time * R::literal(220.0);
    let t1 = t0.sin();
    let t2 = t0.cos();
    let t3 = winder_q * R::literal(45800.0);
    let t4 = winder_v * R::literal(95.0);
    let t5 = t1 * R::literal(8.4);
    let t6 = time * R::literal(110.0);
    let t7 = t6.sin();
    let t8 = t6.cos();
    let t9 = t7 * R::literal(25.0);
    let t10 = t5 + t9;
    let t11 = t10 - t3;
    let t12 = t11 - t4;
    let winder_v_dot = t12 * R::literal(0.476_190_476_190_476_16);
    let mut t1_before = t1;
    let mut t2_before = t2;
    let mut t7_before = t7;
    let mut t8_before = t8;
    let mut rates = [winder_v, winder_v_dot];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (_, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [winder_q_k, winder_v_k] = *state_k;
        let t1_k = inverse * R::literal(220.0) * t2_before;
        let t2_k = -inverse * R::literal(220.0) * t1_before;
        let t7_k = inverse * R::literal(110.0) * t8_before;
        let t8_k = -inverse * R::literal(110.0) * t7_before;
        let t10_k = t7_k.mul_add(R::literal(25.0), t1_k * R::literal(8.4));
        let t11_k = (-winder_q_k).mul_add(R::literal(45800.0), t10_k);
        let t12_k = (-winder_v_k).mul_add(R::literal(95.0), t11_k);
        let winder_v_dot_k = t12_k * R::literal(0.476_190_476_190_476_16);
        t1_before = t1_k;
        t2_before = t2_k;
        t7_before = t7_k;
        t8_before = t8_k;
        rates = [winder_v_k, winder_v_dot_k];
    }
}

/// Row on which a term `t^k e^(g t) (C cos(w t) + S sin(w t))` acts, and k. Rows are rates of the state, then guards of events, then those of kinks.
pub const EXCITATION_TERMS: [(u32, u32); 2] = [(1, 0), (1, 0)];

/// Row and entry of the state of each nonzero slope, if there are guards.
pub const SLOPES: [(u32, u32); 0] = [];

/// Times at which pieces of the excitation end.
pub const SWITCHES: usize = 0;

/// g, w, C and S of every term of the excitation, then the slopes, on the piece that holds `time`,
/// in the modes of a state. No operations.
#[must_use]
pub fn excitation<R: Real>(_time: R, _state: &[R; STATES], _p: &Parameters<R>) -> [R; 8] {
    [R::literal(0.0), R::literal(220.0), R::literal(0.0), R::literal(4.0), R::literal(0.0),
        R::literal(110.0), R::literal(0.0), R::literal(11.904_761_904_761_903)]
}

/// Times at which pieces of the excitation end \[s\]; not finite where there is none. No
/// operations.
#[must_use]
pub fn switches<R: Real>(_p: &Parameters<R>) -> [R; SWITCHES] {
    []
}

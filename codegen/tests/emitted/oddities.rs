// Emitted by Machinist 0.1.0; do not edit. To make it again:
//
//     cargo build
//
// Sources, with SHA-256:
//   e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  scenes/oddities.toml
//
// */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e} let code = 1; # [`x`] ``` let y;
//
// */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e}
// let code = 1;
// # [`x`]
// ```
// let y;
//
// Source:
//   */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e}
//   let code = 1;
//   # [`x`]
//   ```
//   let y;
//
// All quantities are in SI units.
// Shapes: coordinates 1, first-order states 1, states 3, parameters 6, outputs 35, discontinuities 1.
// Nonzeros: mass_matrix 1 of 1 by 1, rate_jacobian 5 of 3 by 3, parameter_jacobian 2 of 3 by 6.
// Operations: rate 14, mass_matrix 2, forcing 7, rate_jacobian 13, parameter_jacobian 7,
//     time_derivative 3, outputs 167, energy 10, power_balance 4, prepare 9, prepared_rate 10,
//     prepared_rate_jacobian 4, prepared_jacobians 9.

use ::machinist_contract::{
    CubicTable, Energy, PowerBalance, Real, taylor::{Lanes, order_and_inverse},
};

::machinist_contract::simulator! {
    /// \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y;
    ///
    /// \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e}
    /// let code = 1;
    /// \# \[\`x\`\]
    /// \`\`\`
    /// let y;
    ///
    /// Source: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y;
    Oddities: "oddities", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;";
    run from 0.0, until 2.0, points 3, rtol 1e-8, method "bdf", times [0.0, 0.001, 2.0];
    quadratures 0, discontinuities 1;
    equilibrium; prepared; jacobians_at_once; series 4 has_corners;
}

::machinist_contract::parameters! {
    STATES: 4.2, "kg", "STATES", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "STATES: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[kg\\].";
    time: 0.75, "m", "time", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "time: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[m\\].";
    arm_gravity: 9.80665, "m/s^2", "arm.gravity", "acceleration of free fall";
    arm_damping: 0.128_534_6, "N m s/rad", "arm.damping", "viscous damping of the pivot";
    drive_lag: 0.01, "s", "drive.lag", "time constant of the drive";
    start: 0.1, "s", "start", "time at which the drive starts";
}

::machinist_contract::outputs! {
    output_0: "1", "output_0", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_0: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_1: "1", "output_1", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_1: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_2: "1", "output_2", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_2: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_3: "1", "output_3", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_3: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_4: "1", "output_4", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_4: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_5: "1", "output_5", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_5: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_6: "1", "output_6", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_6: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_7: "1", "output_7", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_7: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_8: "1", "output_8", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_8: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_9: "1", "output_9", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_9: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_10: "1", "output_10", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_10: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_11: "1", "output_11", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_11: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_12: "1", "output_12", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_12: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_13: "1", "output_13", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_13: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_14: "1", "output_14", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_14: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_15: "1", "output_15", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_15: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_16: "1", "output_16", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_16: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_17: "1", "output_17", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_17: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_18: "1", "output_18", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_18: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_19: "1", "output_19", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_19: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_20: "1", "output_20", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_20: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_21: "1", "output_21", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_21: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_22: "1", "output_22", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_22: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_23: "1", "output_23", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_23: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_24: "1", "output_24", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_24: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_25: "1", "output_25", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_25: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_26: "1", "output_26", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_26: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_27: "1", "output_27", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_27: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_28: "1", "output_28", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_28: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_29: "1", "output_29", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_29: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_30: "1", "output_30", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_30: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_31: "1", "output_31", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_31: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_32: "1", "output_32", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_32: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_33: "1", "output_33", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_33: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
    output_34: "1", "output_34", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "output_34: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[1\\].";
}

::machinist_contract::states! {
    STATE: position, 1.0, "rad", "state", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "state: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[rad\\].";
    STATES: velocity, 10.0, "rad/s", "STATES", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "STATES: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[rad/s\\].";
    P: first_order, 100.0, "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;", "p", "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;" as "p: \\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y; \\[\\*/ } fn main() {} /\\* \\` \\[main\\](x) \\<b\\> \"; // \\\\ \\\\u{202e} let code = 1; \\# \\[\\`x\\`\\] \\`\\`\\` let y;\\].";
}

::machinist_contract::patterns! {
    /// Nonzeros of M.
    MASS_MATRIX_PATTERN: 1 by 1 { 0 [0] }
    /// Nonzeros of dy'/dy.
    RATE_JACOBIAN_PATTERN: 3 by 3 { 0 [1] 1 [0 1 2] 2 [2] }
    /// Nonzeros of dy'/dp.
    PARAMETER_JACOBIAN_PATTERN: 3 by 6 { 1 [2 3] }
}

::machinist_contract::constants! {
    STATES_times_arm_gravity_times_time, inertia, STATES_2_dot_by_STATES_2, STATES_2_dot_by_p_2,
    p_2_dot_by_p_2
}

/// Returns the constants of `rate` and its Jacobians from the parameters. 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let STATES_times_arm_gravity_times_time = p.STATES * p.arm_gravity * p.time;
    let inertia = p.STATES * p.time.powi(2);
    let STATES_2_dot_by_STATES_2 = -(p.arm_damping / inertia);
    let STATES_2_dot_by_p_2 = R::literal(1.0) / inertia;
    let p_2_dot_by_p_2 = -(R::literal(1.0) / p.drive_lag);
    Constants { STATES_times_arm_gravity_times_time, inertia, STATES_2_dot_by_STATES_2,
        STATES_2_dot_by_p_2, p_2_dot_by_p_2 }
}

/// State at the start of the run, in the units of the states. No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.5), R::literal(0.0), R::literal(0.0)]
}

/// Times of known jumps of the right-hand side \[s\], unsorted. No operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    [p.start]
}

/// As `rate`, with the constants of the parameters from `prepare`. 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; STATES] {
    let [state_2, STATES_2, p_2] = *state;
    let STATES_2_dot = p_2.sub_product(p.arm_damping, STATES_2)
        .sub_product(c.STATES_times_arm_gravity_times_time, state_2.sin()) / c.inertia;
    let load = R::select_less(time, p.start, R::literal(0.0), R::interpolate(&DRIVE_LOAD_TABLE, 0,
        time));
    let p_2_dot = (load - p_2) / p.drive_lag;
    [STATES_2, STATES_2_dot, p_2_dot]
}

/// `M = d2L/dq'2`, values in the order of its pattern. 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(_time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; 1] {
    let inertia = p.STATES * p.time.powi(2);
    [inertia]
}

/// `f` of `M q'' = f + G^T lambda`, one for each coordinate. 7 operations.
#[must_use]
pub fn forcing<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; COORDINATES] {
    let [state_2, STATES_2, p_2] = *state;
    let state_forcing = p_2.sub_product(p.arm_damping, STATES_2).sub_product(p.STATES
        * p.arm_gravity * p.time, state_2.sin());
    [state_forcing]
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`. 4 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(_time: R, state: &[R; STATES], _p: &Parameters<R>,
        c: &Constants<R>) -> [R; 5] {
    let [state_2, ..] = *state;
    let STATES_2_dot_by_state_2 = -(c.STATES_times_arm_gravity_times_time * state_2.cos()
        / c.inertia);
    [R::literal(1.0), STATES_2_dot_by_state_2, c.STATES_2_dot_by_STATES_2, c.STATES_2_dot_by_p_2,
        c.p_2_dot_by_p_2]
}

/// `rate_jacobian`, then `parameter_jacobian`, with the constants of the parameters from `prepare`.
/// 9 operations.
#[must_use]
pub fn prepared_jacobians<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>,
        c: &Constants<R>) -> [R; 7] {
    let [state_2, STATES_2, ..] = *state;
    let (sin_state_2, cos_state_2) = state_2.sin_cos();
    let STATES_2_dot_by_state_2 = -(c.STATES_times_arm_gravity_times_time * cos_state_2
        / c.inertia);
    let STATES_2_dot_by_arm_gravity = -(sin_state_2 / p.time);
    let STATES_2_dot_by_arm_damping = -(STATES_2 / c.inertia);
    [R::literal(1.0), STATES_2_dot_by_state_2, c.STATES_2_dot_by_STATES_2, c.STATES_2_dot_by_p_2,
        c.p_2_dot_by_p_2, STATES_2_dot_by_arm_gravity, STATES_2_dot_by_arm_damping]
}

/// Partial derivative of `y'` with respect to time. 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(time: R, _state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    let p_2_dot_by_time = R::select_less(time, p.start, R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 1, time)) / p.drive_lag;
    [R::literal(0.0), R::literal(0.0), p_2_dot_by_time]
}

/// Wanted outputs. 167 operations.
#[must_use]
pub fn outputs<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> Outputs<R> {
    let [state_2, STATES_2, p_2] = *state;
    let (output_5, output_6) = state_2.sin_cos();
    let t0 = R::literal(1.0) + state_2.abs();
    let t1 = state_2 / t0;
    let STATES_2_plus_p_2 = STATES_2 + p_2;
    let STATES_2_over_p_2 = STATES_2 / p_2;
    let minus_STATES_2_plus_p_2 = -STATES_2_plus_p_2;
    let minus_STATES_2 = -STATES_2;
    let t2 = (-(-(-(-(-(-(-(R::literal(0.1) * state_2).sub_product(state_2, STATES_2)
        .add_product(R::literal(0.47), STATES_2).add_product(R::literal(0.84), state_2))
        .add_product(R::literal(1.21), STATES_2).add_product(R::literal(1.58), state_2)
        .add_product(R::literal(1.950_000_000_000_000_2), STATES_2)).add_product(R::literal(2.32),
        state_2).add_product(R::literal(2.69), STATES_2).add_product(R::literal(3.06), state_2))
        .add_product(R::literal(3.43), STATES_2).add_product(R::literal(3.800_000_000_000_000_3),
        state_2).add_product(R::literal(4.17), STATES_2))
        .add_product(R::literal(4.539_999_999_999_999), state_2)
        .add_product(R::literal(4.909_999_999_999_999), STATES_2)
        .add_product(R::literal(5.279_999_999_999_999), state_2))
        .add_product(R::literal(5.649_999_999_999_999_5), STATES_2).add_product(R::literal(6.02),
        state_2).add_product(R::literal(6.39), STATES_2)).add_product(R::literal(6.76), state_2)
        .add_product(R::literal(7.13), STATES_2).add_product(R::literal(7.5), state_2))
        .add_product(R::literal(7.869_999_999_999_999), STATES_2).add_product(R::literal(8.24),
        state_2);
    let t3 = (-(-(-(-(-(-(-(-t2.add_product(R::literal(8.61), STATES_2))
        .add_product(R::literal(8.979_999_999_999_999), state_2).add_product(R::literal(9.35),
        STATES_2).add_product(R::literal(9.719_999_999_999_999), state_2))
        .add_product(R::literal(10.09), STATES_2).add_product(R::literal(10.459_999_999_999_999),
        state_2).add_product(R::literal(10.83), STATES_2)).add_product(R::literal(11.2), state_2)
        .add_product(R::literal(11.57), STATES_2).add_product(R::literal(11.94), state_2))
        .add_product(R::literal(12.309_999_999_999_999), STATES_2).add_product(R::literal(12.68),
        state_2).add_product(R::literal(13.049_999_999_999_999), STATES_2))
        .add_product(R::literal(13.42), state_2).add_product(R::literal(13.79), STATES_2)
        .add_product(R::literal(14.16), state_2)).add_product(R::literal(14.53), STATES_2)
        .add_product(R::literal(14.9), state_2).add_product(R::literal(15.27), STATES_2))
        .add_product(R::literal(15.639_999_999_999_999), state_2).add_product(R::literal(16.01),
        STATES_2).add_product(R::literal(16.380_000_000_000_003), state_2))
        .add_product(R::literal(16.75), STATES_2).add_product(R::literal(17.12), state_2);
    Outputs {
        output_0: t0.sqrt(),
        output_1: t0.ln(),
        output_2: t1.asin(),
        output_3: t1.acos(),
        output_4: state_2.exp(),
        output_5,
        output_6,
        output_7: state_2.tan(),
        output_8: state_2.atan(),
        output_9: state_2.sinh(),
        output_10: state_2.cosh(),
        output_11: state_2.tanh(),
        output_12: state_2 + STATES_2 + p_2,
        output_13: state_2 + STATES_2_plus_p_2,
        output_14: state_2 - (STATES_2 - p_2),
        output_15: state_2 * (STATES_2 * p_2),
        output_16: state_2 / STATES_2_over_p_2,
        output_17: state_2 * STATES_2_over_p_2,
        output_18: minus_STATES_2_plus_p_2 * p.time,
        output_19: minus_STATES_2_plus_p_2,
        output_20: minus_STATES_2.powi(-3),
        output_21: minus_STATES_2.powi(-1),
        output_22: minus_STATES_2.powi(0),
        output_23: minus_STATES_2.powi(1),
        output_24: minus_STATES_2.powi(2),
        output_25: minus_STATES_2.powi(3),
        output_26: minus_STATES_2.powi(7),
        output_27: STATES_2.abs().powf(R::literal(-2.5)),
        output_28: R::select_less(state_2, STATES_2, p_2, time),
        output_29: R::interpolate(&DRIVE_LOAD_TABLE, 0, p_2),
        output_30: R::interpolate(&DRIVE_LOAD_TABLE, 1, p_2),
        output_31: R::interpolate(&DRIVE_LOAD_TABLE, 2, p_2),
        output_32: R::interpolate(&DRIVE_LOAD_TABLE, 3, p_2),
        output_33: (-(-(-(-t3.add_product(R::literal(17.490_000_000_000_002), STATES_2))
            .add_product(R::literal(17.86), state_2).add_product(R::literal(18.23), STATES_2)
            .add_product(R::literal(18.6), state_2))
            .add_product(R::literal(18.970_000_000_000_002), STATES_2)
            .add_product(R::literal(19.34), state_2).add_product(R::literal(19.71), STATES_2))
            .add_product(R::literal(20.080_000_000_000_002), state_2)
            .add_product(R::literal(20.450_000_000_000_003), STATES_2)
            .add_product(R::literal(20.82), state_2)).add_product(R::literal(21.19), STATES_2)
            .add_product(R::literal(21.560_000_000_000_002), state_2)
            .add_product(R::literal(21.93), STATES_2),
        output_34: R::literal(core::f64::consts::TAU) * time,
    }
}

/// T, V and the energy of first-order states \[J\]. 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [state_2, STATES_2, ..] = *state;
    let inertia = p.STATES * p.time.powi(2);
    Energy {
        kinetic: inertia * STATES_2.powi(2) / R::literal(2.0),
        potential: p.STATES * p.arm_gravity * (p.time * (R::literal(1.0) - state_2.cos())),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\]. 4 operations.
#[must_use]
pub fn power_balance<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> PowerBalance<R> {
    let [_, STATES_2, p_2] = *state;
    let supplied = p_2 * STATES_2;
    let dissipated = p.arm_damping * STATES_2.powi(2);
    PowerBalance {
        stored_rate: supplied - dissipated,
        supplied,
        dissipated,
    }
}

/// Normalized Taylor coefficients of the solution through `state`, order after order.
///
/// `_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are
/// zeroth coefficients. The workspace is as `series_workspace` says.
///
/// 31 recurrences. 4 sums of products an order.
///
/// # Panics
/// If there is no room for the zeroth coefficients, or the workspace is too short.
pub fn series<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>,
        coefficients: &mut [[R; STATES]], workspace: &mut [R]) {
    let (mut lanes, _) = Lanes::<R, 4>::new(workspace, coefficients.len());
    let [state_2, STATES_2, p_2] = *state;
    let t0 = STATES_2 * p.arm_damping;
    let t1 = p_2 - t0;
    let sin_state_2 = state_2.sin();
    let cos_state_2 = state_2.cos();
    let t2 = p.STATES * p.arm_gravity;
    let t3 = t2 * p.time;
    let t4 = sin_state_2 * t3;
    let t5 = t1 - t4;
    let t6 = p.time.powi(2);
    let inertia = p.STATES * t6;
    let t7 = R::literal(1.0) / inertia;
    let t8 = t5 * t7;
    let t9 = R::interpolate(&DRIVE_LOAD_TABLE, 0, time);
    let load = R::select_less(time, p.start, R::literal(0.0), t9);
    let t10 = load - p_2;
    let t11 = R::literal(1.0) / p.drive_lag;
    let t12 = t10 * t11;
    let t9_first = R::interpolate(&DRIVE_LOAD_TABLE, 1, time);
    let t9_second = R::literal(0.5) * R::interpolate(&DRIVE_LOAD_TABLE, 2, time);
    let t9_third = R::literal(1.0 / 6.0) * R::interpolate(&DRIVE_LOAD_TABLE, 3, time);
    let mut rates = [STATES_2, t8, t12];
    coefficients[0] = *state;
    let highest = coefficients.len() - 1;
    for (order, state_k) in coefficients.iter_mut().enumerate().skip(1) {
        let (k, inverse) = order_and_inverse::<R>(order);
        *state_k = rates.map(|rate| rate * inverse);
        if order == highest {
            break;
        }
        let [state_2_k, STATES_2_k, p_2_k] = *state_k;
        let sums = lanes.sums(order);
        let t1_k = (-STATES_2_k).mul_add(p.arm_damping, p_2_k);
        let sin_state_2_k = state_2_k.mul_add(cos_state_2, inverse * sums[1]);
        let cos_state_2_k = -state_2_k.mul_add(sin_state_2, inverse * sums[2]);
        let t5_k = (-sin_state_2_k).mul_add(t3, t1_k);
        let t8_k = t5_k * t7;
        let time_k = R::literal(if order == 1 { 1.0 } else { 0.0 });
        let t9_k = t9_first * time_k + t9_second * sums[0] + t9_third * sums[3];
        let load_k = R::select_less(time, p.start, R::literal(0.0), t9_k);
        let t10_k = load_k - p_2_k;
        let t12_k = t10_k * t11;
        lanes.set(order, [time_k, k * state_2_k, k * state_2_k, time_k], [time_k, cos_state_2_k,
            sin_state_2_k, sums[0]]);
        rates = [STATES_2_k, t8_k, t12_k];
    }
}

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

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
// Shapes; all quantities are in SI units:
//   coordinates               1
//   first-order states        1
//   states                    3
//   parameters                6
//   outputs                  35
//   discontinuities           1
//
// State:
//     0  state   [rad]                                                                                   */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e} let code = 1; # [`x`] ``` let y;
//     1  STATES  [rad/s]                                                                                 */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e} let code = 1; # [`x`] ``` let y;
//     2  p       [*/ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e} let code = 1; # [`x`] ``` let y;]  */ } fn main() {} /* ` [main](x) <b> "; // \ \u{202e} let code = 1; # [`x`] ``` let y;
//
// Nonzeros:
//   mass_matrix               1 of 1 by 1
//   rate_jacobian             5 of 3 by 3
//   parameter_jacobian        2 of 3 by 6
//
// Operations:
//   initial_state             0
//   discontinuities           0
//   rate                     14
//   mass_matrix               2
//   forcing                   7
//   rate_jacobian            13
//   parameter_jacobian        7
//   time_derivative           3
//   outputs                 167
//   energy                   10
//   power_balance             4
// With constants of the parameters, prepared once a run:
//   prepare                   9
//   prepared_rate            10
//   prepared_rate_jacobian    4

use ::machinist_contract::{
    CubicTable, Describe, Energy, PowerBalance, Quantity, Real, RunDefaults, Shape,
    Simulator, SparsityPattern, taylor::{Bends, Lanes, TaylorSeries, order_and_inverse},
};

/// Generalized coordinates, n.
pub const COORDINATES: usize = 1;

/// Length of the state y.
pub const STATES: usize = 3;

/// Parameters.
pub const PARAMETERS: usize = 6;

/// Wanted outputs.
pub const OUTPUTS: usize = 35;

/// Times at which the right-hand side jumps.
pub const DISCONTINUITIES: usize = 1;

/// Nonzeros of M, both triangles.
pub const MASS_MATRIX_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 1,
    columns: 1,
    entries: &[(0, 0)],
};

/// Nonzeros of dy'/dy.
pub const RATE_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 3,
    entries: &[(0, 1), (1, 0), (1, 1), (1, 2), (2, 2)],
};

/// Nonzeros of dy'/dp.
pub const PARAMETER_JACOBIAN_PATTERN: SparsityPattern<'static> = SparsityPattern {
    rows: 3,
    columns: 6,
    entries: &[(1, 2), (1, 3)],
};

/// \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y;
///
/// \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e}
/// let code = 1;
/// \# \[\`x\`\]
/// \`\`\`
/// let y;
///
/// Source: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y;
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Oddities;

/// Parameters, in SI units; the default holds the values of the spec.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters<R> {
    /// STATES: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[kg\]. In the spec: 4.2.
    pub STATES: R,
    /// time: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[m\]. In the spec: 0.75.
    pub time: R,
    /// arm.gravity: acceleration of free fall \[m/s^2\]. In the spec: 9.80665.
    pub arm_gravity: R,
    /// arm.damping: viscous damping of the pivot \[N m s/rad\]. In the spec: 0.1285346.
    pub arm_damping: R,
    /// drive.lag: time constant of the drive \[s\]. In the spec: 0.01.
    pub drive_lag: R,
    /// start: time at which the drive starts \[s\]. In the spec: 0.1.
    pub start: R,
}

impl<R: Real> Parameters<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; PARAMETERS]) -> Self {
        Self {
            STATES: values[0],
            time: values[1],
            arm_gravity: values[2],
            arm_damping: values[3],
            drive_lag: values[4],
            start: values[5],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; PARAMETERS] {
        [
            self.STATES,
            self.time,
            self.arm_gravity,
            self.arm_damping,
            self.drive_lag,
            self.start,
        ]
    }
}

impl<R: Real> Default for Parameters<R> {
    fn default() -> Self {
        Self {
            STATES: R::literal(4.2),
            time: R::literal(0.75),
            arm_gravity: R::literal(9.80665),
            arm_damping: R::literal(0.128_534_6),
            drive_lag: R::literal(0.01),
            start: R::literal(0.1),
        }
    }
}

/// Wanted outputs, in SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outputs<R> {
    /// output_0: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_0: R,
    /// output_1: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_1: R,
    /// output_2: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_2: R,
    /// output_3: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_3: R,
    /// output_4: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_4: R,
    /// output_5: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_5: R,
    /// output_6: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_6: R,
    /// output_7: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_7: R,
    /// output_8: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_8: R,
    /// output_9: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_9: R,
    /// output_10: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_10: R,
    /// output_11: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_11: R,
    /// output_12: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_12: R,
    /// output_13: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_13: R,
    /// output_14: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_14: R,
    /// output_15: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_15: R,
    /// output_16: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_16: R,
    /// output_17: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_17: R,
    /// output_18: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_18: R,
    /// output_19: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_19: R,
    /// output_20: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_20: R,
    /// output_21: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_21: R,
    /// output_22: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_22: R,
    /// output_23: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_23: R,
    /// output_24: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_24: R,
    /// output_25: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_25: R,
    /// output_26: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_26: R,
    /// output_27: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_27: R,
    /// output_28: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_28: R,
    /// output_29: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_29: R,
    /// output_30: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_30: R,
    /// output_31: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_31: R,
    /// output_32: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_32: R,
    /// output_33: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_33: R,
    /// output_34: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[1\].
    pub output_34: R,
}

impl<R: Real> Outputs<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; OUTPUTS]) -> Self {
        Self {
            output_0: values[0],
            output_1: values[1],
            output_2: values[2],
            output_3: values[3],
            output_4: values[4],
            output_5: values[5],
            output_6: values[6],
            output_7: values[7],
            output_8: values[8],
            output_9: values[9],
            output_10: values[10],
            output_11: values[11],
            output_12: values[12],
            output_13: values[13],
            output_14: values[14],
            output_15: values[15],
            output_16: values[16],
            output_17: values[17],
            output_18: values[18],
            output_19: values[19],
            output_20: values[20],
            output_21: values[21],
            output_22: values[22],
            output_23: values[23],
            output_24: values[24],
            output_25: values[25],
            output_26: values[26],
            output_27: values[27],
            output_28: values[28],
            output_29: values[29],
            output_30: values[30],
            output_31: values[31],
            output_32: values[32],
            output_33: values[33],
            output_34: values[34],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; OUTPUTS] {
        [
            self.output_0,
            self.output_1,
            self.output_2,
            self.output_3,
            self.output_4,
            self.output_5,
            self.output_6,
            self.output_7,
            self.output_8,
            self.output_9,
            self.output_10,
            self.output_11,
            self.output_12,
            self.output_13,
            self.output_14,
            self.output_15,
            self.output_16,
            self.output_17,
            self.output_18,
            self.output_19,
            self.output_20,
            self.output_21,
            self.output_22,
            self.output_23,
            self.output_24,
            self.output_25,
            self.output_26,
            self.output_27,
            self.output_28,
            self.output_29,
            self.output_30,
            self.output_31,
            self.output_32,
            self.output_33,
            self.output_34,
        ]
    }
}

/// Where to find what in the state.
pub mod state {
    /// state: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[rad\].
    pub const STATE: usize = 0;
    /// STATES: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[rad/s\].
    pub const STATES: usize = 1;
    /// p: \*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y; \[\*/ } fn main() {} /\* \` \[main\](x) \<b\> "; // \\ \\u{202e} let code = 1; \# \[\`x\`\] \`\`\` let y;\].
    pub const P: usize = 2;
}

/// Constants that `prepare` computes.
pub const CONSTANTS: usize = 5;

#[allow(missing_docs, reason = "`prepare` says what each is")]
/// What parameters alone decide; `prepare` says what each is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Constants<R> {
    pub STATES_times_arm_gravity_times_time: R,
    pub inertia: R,
    pub STATES_2_dot_by_STATES_2: R,
    pub STATES_2_dot_by_p_2: R,
    pub p_2_dot_by_p_2: R,
}

impl<R: Real> Constants<R> {
    /// From the numbers in their order.
    #[must_use]
    #[inline]
    pub fn from_array(values: [R; CONSTANTS]) -> Self {
        Self {
            STATES_times_arm_gravity_times_time: values[0],
            inertia: values[1],
            STATES_2_dot_by_STATES_2: values[2],
            STATES_2_dot_by_p_2: values[3],
            p_2_dot_by_p_2: values[4],
        }
    }
    /// The numbers in their order.
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [R; CONSTANTS] {
        [
            self.STATES_times_arm_gravity_times_time,
            self.inertia,
            self.STATES_2_dot_by_STATES_2,
            self.STATES_2_dot_by_p_2,
            self.p_2_dot_by_p_2,
        ]
    }
}

/// What `rate` and `rate_jacobian` need of the parameters, once a run.
///
/// 9 operations.
#[must_use]
#[inline]
pub fn prepare<R: Real>(p: &Parameters<R>) -> Constants<R> {
    let STATES_times_arm_gravity_times_time = p.STATES * p.arm_gravity * p.time;
    let inertia = p.STATES * p.time.powi(2);
    let STATES_2_dot_by_STATES_2 = -(p.arm_damping / inertia);
    let STATES_2_dot_by_p_2 = R::literal(1.0) / inertia;
    let p_2_dot_by_p_2 = -(R::literal(1.0) / p.drive_lag);
    Constants {
        STATES_times_arm_gravity_times_time,
        inertia,
        STATES_2_dot_by_STATES_2,
        STATES_2_dot_by_p_2,
        p_2_dot_by_p_2,
    }
}

/// State at the start of the run, in the units of the states.
///
/// No operations.
#[must_use]
pub fn initial_state<R: Real>(_p: &Parameters<R>) -> [R; STATES] {
    [R::literal(0.5), R::literal(0.0), R::literal(0.0)]
}

/// Times at which the right-hand side jumps \[s\].
///
/// No operations.
#[must_use]
pub fn discontinuities<R: Real>(p: &Parameters<R>) -> [R; DISCONTINUITIES] {
    [p.start]
}

/// `y'`: velocities, `M^-1 f`, `h`; in the units of the states per second.
///
/// 14 operations.
#[must_use]
#[inline]
pub fn rate<R: Real>(time: R, state: &[R; STATES], p: &Parameters<R>) -> [R; STATES] {
    prepared_rate(time, state, p, &prepare(p))
}

/// As `rate`, with the constants of the parameters from `prepare`.
///
/// 10 operations.
#[must_use]
#[inline]
pub fn prepared_rate<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; STATES] {
    let [state_2, STATES_2, p_2] = *state;
    let STATES_2_dot = p_2
        .sub_product(p.arm_damping, STATES_2)
        .sub_product(c.STATES_times_arm_gravity_times_time, state_2.sin()) / c.inertia;
    let load = R::select_less(
        time,
        p.start,
        R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 0, time),
    );
    let p_2_dot = (load - p_2) / p.drive_lag;
    [STATES_2, STATES_2_dot, p_2_dot]
}

/// `M = d2L/dq'2`, values in the order of `MASS_MATRIX_PATTERN`.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<R: Real>(
    _time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 1] {
    let inertia = p.STATES * p.time.powi(2);
    [inertia]
}

/// `f` of `M q'' = f(q, q', z, t)`, one for each coordinate.
///
/// 7 operations.
#[must_use]
pub fn forcing<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; COORDINATES] {
    let [state_2, STATES_2, p_2] = *state;
    let state_forcing = p_2
        .sub_product(p.arm_damping, STATES_2)
        .sub_product(p.STATES * p.arm_gravity * p.time, state_2.sin());
    [state_forcing]
}

/// `dy'/dy`, values in the order of `RATE_JACOBIAN_PATTERN`.
///
/// 13 operations.
#[must_use]
#[inline]
pub fn rate_jacobian<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 5] {
    prepared_rate_jacobian(time, state, p, &prepare(p))
}

/// As `rate_jacobian`, with the constants of the parameters from `prepare`.
///
/// 4 operations.
#[must_use]
pub fn prepared_rate_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    _p: &Parameters<R>,
    c: &Constants<R>,
) -> [R; 5] {
    let [state_2, ..] = *state;
    let STATES_2_dot_by_state_2 = -(c.STATES_times_arm_gravity_times_time * state_2.cos()
        / c.inertia);
    [
        R::literal(1.0),
        STATES_2_dot_by_state_2,
        c.STATES_2_dot_by_STATES_2,
        c.STATES_2_dot_by_p_2,
        c.p_2_dot_by_p_2,
    ]
}

/// `dy'/dp`, values in the order of `PARAMETER_JACOBIAN_PATTERN`.
///
/// 7 operations.
#[must_use]
pub fn parameter_jacobian<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; 2] {
    let [state_2, STATES_2, ..] = *state;
    let STATES_2_dot_by_arm_gravity = -(state_2.sin() / p.time);
    let inertia = p.STATES * p.time.powi(2);
    let STATES_2_dot_by_arm_damping = -(STATES_2 / inertia);
    [STATES_2_dot_by_arm_gravity, STATES_2_dot_by_arm_damping]
}

/// Partial derivative of `y'` with respect to time.
///
/// 3 operations.
#[must_use]
pub fn time_derivative<R: Real>(
    time: R,
    _state: &[R; STATES],
    p: &Parameters<R>,
) -> [R; STATES] {
    let p_2_dot_by_time = R::select_less(
        time,
        p.start,
        R::literal(0.0),
        R::interpolate(&DRIVE_LOAD_TABLE, 1, time),
    ) / p.drive_lag;
    [R::literal(0.0), R::literal(0.0), p_2_dot_by_time]
}

/// Wanted outputs.
///
/// 167 operations.
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
    let t2 = (-(-(-(-(-(-(-(R::literal(0.1) * state_2)
        .sub_product(state_2, STATES_2)
        .add_product(R::literal(0.47), STATES_2)
        .add_product(R::literal(0.84), state_2))
        .add_product(R::literal(1.21), STATES_2)
        .add_product(R::literal(1.58), state_2)
        .add_product(R::literal(1.950_000_000_000_000_2), STATES_2))
        .add_product(R::literal(2.32), state_2)
        .add_product(R::literal(2.69), STATES_2)
        .add_product(R::literal(3.06), state_2))
        .add_product(R::literal(3.43), STATES_2)
        .add_product(R::literal(3.800_000_000_000_000_3), state_2)
        .add_product(R::literal(4.17), STATES_2))
        .add_product(R::literal(4.539_999_999_999_999), state_2)
        .add_product(R::literal(4.909_999_999_999_999), STATES_2)
        .add_product(R::literal(5.279_999_999_999_999), state_2))
        .add_product(R::literal(5.649_999_999_999_999_5), STATES_2)
        .add_product(R::literal(6.02), state_2)
        .add_product(R::literal(6.39), STATES_2))
        .add_product(R::literal(6.76), state_2)
        .add_product(R::literal(7.13), STATES_2)
        .add_product(R::literal(7.5), state_2))
        .add_product(R::literal(7.869_999_999_999_999), STATES_2)
        .add_product(R::literal(8.24), state_2);
    let t3 = (-(-(-(-(-(-(-(-t2.add_product(R::literal(8.61), STATES_2))
        .add_product(R::literal(8.979_999_999_999_999), state_2)
        .add_product(R::literal(9.35), STATES_2)
        .add_product(R::literal(9.719_999_999_999_999), state_2))
        .add_product(R::literal(10.09), STATES_2)
        .add_product(R::literal(10.459_999_999_999_999), state_2)
        .add_product(R::literal(10.83), STATES_2))
        .add_product(R::literal(11.2), state_2)
        .add_product(R::literal(11.57), STATES_2)
        .add_product(R::literal(11.94), state_2))
        .add_product(R::literal(12.309_999_999_999_999), STATES_2)
        .add_product(R::literal(12.68), state_2)
        .add_product(R::literal(13.049_999_999_999_999), STATES_2))
        .add_product(R::literal(13.42), state_2)
        .add_product(R::literal(13.79), STATES_2)
        .add_product(R::literal(14.16), state_2))
        .add_product(R::literal(14.53), STATES_2)
        .add_product(R::literal(14.9), state_2)
        .add_product(R::literal(15.27), STATES_2))
        .add_product(R::literal(15.639_999_999_999_999), state_2)
        .add_product(R::literal(16.01), STATES_2)
        .add_product(R::literal(16.380_000_000_000_003), state_2))
        .add_product(R::literal(16.75), STATES_2)
        .add_product(R::literal(17.12), state_2);
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
        output_19: -(-minus_STATES_2_plus_p_2),
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
            .add_product(R::literal(17.86), state_2)
            .add_product(R::literal(18.23), STATES_2)
            .add_product(R::literal(18.6), state_2))
            .add_product(R::literal(18.970_000_000_000_002), STATES_2)
            .add_product(R::literal(19.34), state_2)
            .add_product(R::literal(19.71), STATES_2))
            .add_product(R::literal(20.080_000_000_000_002), state_2)
            .add_product(R::literal(20.450_000_000_000_003), STATES_2)
            .add_product(R::literal(20.82), state_2))
            .add_product(R::literal(21.19), STATES_2)
            .add_product(R::literal(21.560_000_000_000_002), state_2)
            .add_product(R::literal(21.93), STATES_2),
        output_34: R::literal(core::f64::consts::TAU) * time,
    }
}

/// T, V and the energy of first-order states \[J\].
///
/// 10 operations.
#[must_use]
pub fn energy<R: Real>(_time: R, state: &[R; STATES], p: &Parameters<R>) -> Energy<R> {
    let [state_2, STATES_2, ..] = *state;
    let inertia = p.STATES * p.time.powi(2);
    Energy {
        kinetic: inertia * STATES_2.powi(2) / R::literal(2.0),
        potential: p.STATES * p.arm_gravity
            * (p.time * (R::literal(1.0) - state_2.cos())),
        stored: R::literal(0.0),
    }
}

/// `dE/dt`, power supplied and power dissipated \[W\].
///
/// 4 operations.
#[must_use]
pub fn power_balance<R: Real>(
    _time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
) -> PowerBalance<R> {
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
pub fn series<R: Real>(
    time: R,
    state: &[R; STATES],
    p: &Parameters<R>,
    coefficients: &mut [[R; STATES]],
    workspace: &mut [R],
) {
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
        lanes
            .set(
                order,
                [time_k, k * state_2_k, k * state_2_k, time_k],
                [time_k, cos_state_2_k, sin_state_2_k, sums[0]],
            );
        rates = [STATES_2_k, t8_k, t12_k];
    }
}

impl<R: Real> TaylorSeries<R> for Oddities {
    fn series_workspace(&self, order: usize) -> usize {
        Lanes::<R, 4>::workspace(order + 1)
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
    fn bends(&self) -> Bends {
        Bends::Corners
    }
}

impl Describe for Oddities {
    fn name(&self) -> &'static str {
        "oddities"
    }
    fn title(&self) -> &'static str {
        "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;"
    }
    fn shape(&self) -> Shape {
        Shape {
            coordinates: COORDINATES,
            positions: 1,
            first_order: 1,
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

impl<R: Real> Simulator<R> for Oddities {
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
        name: "state",
        unit: "rad",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "STATES",
        unit: "rad/s",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "p",
        unit: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
];

static STATE_SCALES: [f64; STATES] = [1.0, 10.0, 100.0];

static PARAMETER_QUANTITIES: [Quantity<'static>; PARAMETERS] = [
    Quantity {
        name: "STATES",
        unit: "kg",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "time",
        unit: "m",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "arm.gravity",
        unit: "m/s^2",
        doc: "acceleration of free fall",
    },
    Quantity {
        name: "arm.damping",
        unit: "N m s/rad",
        doc: "viscous damping of the pivot",
    },
    Quantity {
        name: "drive.lag",
        unit: "s",
        doc: "time constant of the drive",
    },
    Quantity {
        name: "start",
        unit: "s",
        doc: "time at which the drive starts",
    },
];

static PARAMETER_DEFAULTS: [f64; PARAMETERS] = [
    4.2,
    0.75,
    9.80665,
    0.128_534_6,
    0.01,
    0.1,
];

static OUTPUT_QUANTITIES: [Quantity<'static>; OUTPUTS] = [
    Quantity {
        name: "output_0",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_1",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_2",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_3",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_4",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_5",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_6",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_7",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_8",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_9",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_10",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_11",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_12",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_13",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_14",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_15",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_16",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_17",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_18",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_19",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_20",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_21",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_22",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_23",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_24",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_25",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_26",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_27",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_28",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_29",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_30",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_31",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_32",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_33",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
    Quantity {
        name: "output_34",
        unit: "1",
        doc: "*/ } fn main() {} /* ` [main](x) <b> \"; // \\ \u{202e}\r\n    let code = 1;\n# [`x`]\n```\nlet y;",
    },
];

/// The run the spec asks for.
pub const RUN_DEFAULTS: RunDefaults<'static> = RunDefaults {
    from: 0.0,
    until: 2.0,
    points: 1001,
    rtol: 1e-8,
    method: "bdf",
};

/// Natural cubic spline drive.load.
pub static DRIVE_LOAD_TABLE: CubicTable<'static> = CubicTable {
    knots: &[0.0, 1.0, 3.0],
    coefficients: &[[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
};

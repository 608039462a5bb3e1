//! Compares the simulators with independent knowledge: closed forms, converged references,
//! hand-written equations, complex-step derivatives and the energy balance.
//!
//! The checks of a scene are a table in `src/verify/<scene>.rs`, those of every scene are in
//! `src/verify/every_scene.rs`. To add a check, write a function from a `Machine` to a `Measured`
//! and add a row to its table.
//!
//! References do not follow overridden parameters: they belong to the published numbers, so a wrong
//! parameter makes rows fail.

pub mod automatic;
mod bouncing_mass;
mod contact_oscillator;
mod coulomb_oscillator;
mod every_scene;
mod linkages;
mod loom_drive;
pub(crate) mod machine;
mod matrix;
pub(crate) mod motor_run_up;
mod motor_stationary_axes;
mod pendulum_chain;
mod power;
mod random;
mod reed_beat_up;
mod reed_one_sided;
mod reference;
mod saw_gin;
pub(crate) mod saw_gin_as_printed;
mod saw_gin_shaft;
mod sensitivities;
mod shaft_step_torque;
mod shaft_with_rotors;
mod stick_slip;
mod two_mass;
mod winder_full;
pub(crate) mod winder_linear;
mod winder_linkage;
mod winder_nonlinear;

use std::borrow::Cow;

use comfy_table::{Table, presets};
use serde::Serialize;
use thiserror::Error;

use machine::Machine;
use machinist::error::SimulateError;
use machinist::field::{FieldError, ModalError};
use machinist::linear_analysis::LinearError;
use machinist::periodic::CycleError;

/// Settings of the checks.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct VerifyOptions {
    /// Overridden parameters, as `scene.parameter` and SI value: `two_mass.coupling.stiffness`.
    /// They take precedence over settings of checks.
    pub overrides: Vec<(String, f64)>,
    /// Text that `scene: check` must contain, if given.
    pub only: Option<String>,
    /// Names of the scenes to check, if given.
    pub scenes: Option<Vec<String>>,
}

impl VerifyOptions {
    fn want(&self, machine: &Machine, check: &Check) -> bool {
        let name = || format!("{}: {}", machine.name(), check.name);
        let is_of = |scenes: &Vec<String>| scenes.iter().any(|scene| scene == machine.name());
        self.scenes.as_ref().is_none_or(is_of)
            && self.only.as_ref().is_none_or(|text| name().contains(text.as_str()))
    }
}

/// Result of one check.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// Name of the scene.
    pub scene: String,
    /// Subject of the check, in a few words.
    pub check: Cow<'static, str>,
    /// Reference of the comparison.
    pub reference: Cow<'static, str>,
    /// Error, in the measure that the reference states; `null` in JSON if the check could not be
    /// done.
    pub error: f64,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Justification of the tolerance.
    pub reason: Cow<'static, str>,
    /// True if the error is at most the tolerance; also true for a row that is left out. A row that
    /// was not checked does not pass.
    pub pass: bool,
    /// Value found, for checks of one number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<f64>,
    /// Expected value, for checks of one number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub expected: Option<f64>,
    /// Reason why the check could not be done, or consequence of its failure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// Reason why the check does not apply to this machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub skipped: Option<String>,
    /// Reason why the check applies but was not done: a run that it needs stopped.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unchecked: Option<String>,
}

impl Verdict {
    /// Creates a verdict without descriptions; `failure` is the reason of a failure.
    fn judged(scene: &str, error: f64, tolerance: f64, failure: Option<String>) -> Self {
        Self {
            scene: scene.to_owned(),
            check: Cow::Borrowed(""),
            reference: Cow::Borrowed(""),
            error,
            tolerance,
            reason: Cow::Borrowed(""),
            pass: failure.is_none(),
            value: None,
            expected: None,
            failure,
            skipped: None,
            unchecked: None,
        }
    }

    /// Creates a row that is left out.
    fn skipped(scene: &str, why: String) -> Self {
        Self { skipped: Some(why), ..Self::judged(scene, f64::NAN, 0.0, None) }
    }

    /// Creates a row that applies but was not checked.
    fn unchecked(scene: &str, why: String) -> Self {
        let pass = false;
        Self { unchecked: Some(why), pass, ..Self::judged(scene, f64::NAN, 0.0, None) }
    }
}

/// Numbers of rows by result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Tally {
    /// Number of checked rows, passed or failed.
    pub checked: usize,
    /// Number of rows that passed.
    pub passed: usize,
    /// Number of rows that do not apply.
    pub left_out: usize,
    /// Number of rows that apply but were not checked, so that nothing is known of them.
    pub unchecked: usize,
}

impl Tally {
    /// Counts rows.
    #[must_use]
    pub fn of(verdicts: &[Verdict]) -> Self {
        let left_out = verdicts.iter().filter(|verdict| verdict.skipped.is_some()).count();
        let unchecked = verdicts.iter().filter(|verdict| verdict.unchecked.is_some()).count();
        let passes = |verdict: &&Verdict| verdict.pass && verdict.skipped.is_none();
        let passed = verdicts.iter().filter(passes).count();
        Self { checked: verdicts.len() - left_out - unchecked, passed, left_out, unchecked }
    }

    /// Returns whether no row failed.
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.passed == self.checked
    }
}

/// Reason why nothing was checked.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "verify::", serialize_all = "kebab-case")]
pub enum VerifyError {
    /// An override does not name a parameter of a verified scene.
    #[error("override `{0}`: no verified scene has this parameter; it is written scene.parameter")]
    UnknownOverride(String),
    /// An override is not a finite number.
    #[error("override `{name}` is {value}, but must be a finite number")]
    OverrideNotFinite {
        /// Name of the parameter.
        name: String,
        /// Value of the override.
        value: f64,
    },
}

impl VerifyError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Runs every selected check, scene by scene, in the order of the tables.
///
/// # Errors
/// [`VerifyError`] if an override is invalid. A check that cannot be done, for example because its
/// run stops, is a failing verdict with the reason.
pub fn verify_all(options: &VerifyOptions) -> Result<Vec<Verdict>, VerifyError> {
    let mut machines = machine::all();
    for (name, value) in &options.overrides {
        override_parameter(&mut machines, name, *value)?;
    }
    let checks = |machine: &Machine| own_checks(machine.name()).iter().chain(every_scene::CHECKS);
    let verdicts = machines.iter().flat_map(|machine| {
        let wanted = checks(machine).filter(|check| options.want(machine, check));
        wanted.map(|check| check.verdict(machine))
    });
    Ok(verdicts.collect())
}

/// Returns the table of checks that only this scene has.
fn own_checks(scene: &str) -> &'static [Check] {
    match scene {
        "two_mass" => two_mass::CHECKS,
        "motor_run_up" => motor_run_up::CHECKS,
        "saw_gin" => saw_gin::CHECKS,
        "saw_gin_as_printed" => saw_gin_as_printed::CHECKS,
        "motor_stationary_axes" => motor_stationary_axes::CHECKS,
        "winder_linear" => winder_linear::CHECKS,
        "winder_linear_as_printed" => winder_linear::PRINTED_CHECKS,
        "winder_nonlinear" => winder_nonlinear::CHECKS,
        "winder_full" => winder_full::CHECKS,
        "pendulum_chain" => pendulum_chain::CHECKS,
        "pendulum_relative" => linkages::RELATIVE_CHECKS,
        "pendulum_constrained" => linkages::PENDULUM_CHECKS,
        "slider_crank" => linkages::SLIDER_CRANK_CHECKS,
        "four_bar" => linkages::FOUR_BAR_CHECKS,
        "winder_linkage" => winder_linkage::CHECKS,
        "winder_holder_drop" => winder_linkage::DROP_CHECKS,
        "bouncing_mass" => bouncing_mass::CHECKS,
        "coulomb_oscillator" => coulomb_oscillator::CHECKS,
        "stick_slip" => stick_slip::CHECKS,
        "stick_slip_smooth" => stick_slip::SMOOTH_CHECKS,
        "contact_oscillator" => contact_oscillator::CHECKS,
        "contact_oscillator_smooth" => contact_oscillator::SMOOTH_CHECKS,
        "shaft_step_torque" => shaft_step_torque::CHECKS,
        "shaft_with_rotors" => shaft_with_rotors::CHECKS,
        "reed_beat_up" => reed_beat_up::CHECKS,
        "reed_beat_up_one_sided" => reed_one_sided::CHECKS,
        "saw_gin_shaft" => saw_gin_shaft::CHECKS,
        "loom_drive" => loom_drive::CHECKS,
        _ => &[],
    }
}

/// Returns the names of the checks of every scene, as `scene: check`.
#[cfg(test)]
pub(crate) fn check_names() -> Vec<String> {
    let names = |machine: &Machine| {
        let checks = own_checks(machine.name()).iter().chain(every_scene::CHECKS);
        let scene = machine.name();
        checks.map(|check| format!("{scene}: {}", check.name)).collect::<Vec<_>>()
    };
    machine::all().iter().flat_map(names).collect()
}

fn override_parameter(machines: &mut [Machine], name: &str, value: f64) -> Result<(), VerifyError> {
    if !value.is_finite() {
        return Err(VerifyError::OverrideNotFinite { name: name.to_owned(), value });
    }
    let unknown = || VerifyError::UnknownOverride(name.to_owned());
    let (scene, parameter) = name.split_once('.').ok_or_else(unknown)?;
    let machine =
        machines.iter_mut().find(|machine| machine.name() == scene).ok_or_else(unknown)?;
    machine.override_parameter(parameter, value).map_err(|_| unknown())
}

/// Returns the verdicts as aligned text: one row per check, and a last line with the counts.
#[must_use]
pub fn render_table(verdicts: &[Verdict]) -> String {
    let cells = verdicts.iter().map(|verdict| {
        [
            outcome(verdict).to_owned(),
            verdict.scene.clone(),
            verdict.check.clone().into_owned(),
            number(verdict, verdict.error),
            number(verdict, verdict.tolerance),
            because(verdict).to_owned(),
            verdict.reference.clone().into_owned(),
        ]
    });
    let header = ["", "scene", "check", "error", "tolerance", "because", "against"];
    format!("{}\n{}\n", text_table(header, cells), tally_line(verdicts))
}

/// Returns a line with the counts of checks, and the names of those that were not done.
#[must_use]
pub fn tally_line(verdicts: &[Verdict]) -> String {
    let Tally { checked, passed, left_out, unchecked } = Tally::of(verdicts);
    let failed = checked - passed;
    let more = [(left_out, "left out"), (unchecked, "not checked")].into_iter();
    let more =
        more.filter(|(count, _)| *count > 0).map(|(count, what)| format!(", {count} {what}"));
    let names = verdicts.iter().filter(|verdict| verdict.unchecked.is_some());
    let names: Vec<String> = names.map(|row| format!("{} of {}", row.check, row.scene)).collect();
    let names = if names.is_empty() { String::new() } else { format!(": {}", names.join("; ")) };
    let more: String = more.chain([names]).collect();
    format!("{checked} checks, {failed} failed{more}")
}

/// Returns the outcome of a check in a word.
#[must_use]
pub fn outcome(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict { skipped: Some(_), .. } => "skip",
        Verdict { unchecked: Some(_), .. } => "open",
        Verdict { pass: true, .. } => "pass",
        _ => "FAIL",
    }
}

/// Formats an error or a tolerance; empty if the check was not done.
#[must_use]
pub fn number(verdict: &Verdict, value: f64) -> String {
    let is_asked = verdict.skipped.is_none() && verdict.unchecked.is_none();
    if is_asked { format!("{value:.1e}") } else { String::new() }
}

/// Returns why a check failed, was left out or was not done; otherwise the justification of its
/// tolerance.
#[must_use]
pub fn because(verdict: &Verdict) -> &str {
    let Verdict { failure, skipped, unchecked, reason, .. } = verdict;
    let other = [failure, skipped, unchecked].into_iter().find_map(Option::as_deref);
    other.unwrap_or(reason)
}

/// Formats aligned text: a header, a rule, and one line per row.
pub(crate) fn text_table<const N: usize>(
    header: [&str; N],
    rows: impl Iterator<Item = [String; N]>,
) -> String {
    let mut table = Table::new();
    table.load_preset(presets::ASCII_MARKDOWN).set_header(header).add_rows(rows);
    table.trim_fmt()
}

/// One row of a table of checks.
struct Check {
    name: &'static str,
    reference: &'static str,
    tolerance: f64,
    reason: &'static str,
    measure: fn(&Machine) -> Result<Measured, CheckFailure>,
}

/// Result of a measurement.
struct Measured {
    error: f64,
    value: Option<f64>,
    expected: Option<f64>,
}

/// Reason why a check, or a row of the ledger, could not be done.
#[derive(Debug, Clone, PartialEq, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "verify::", serialize_all = "kebab-case")]
pub enum CheckFailure {
    /// Its run was refused or stopped.
    #[strum(serialize = "")]
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    /// Its linear analysis was refused or failed.
    #[strum(serialize = "")]
    #[error(transparent)]
    Linear(#[from] LinearError),
    /// Its fields cannot be divided into elements as requested.
    #[strum(serialize = "")]
    #[error(transparent)]
    Field(#[from] FieldError),
    /// Its modal reduction failed.
    #[strum(serialize = "")]
    #[error(transparent)]
    Modal(#[from] ModalError),
    /// No periodic motion was found.
    #[strum(serialize = "")]
    #[error(transparent)]
    Cycle(#[from] CycleError),
    /// The scene lacks a quantity.
    #[error("scene `{scene}` has no {kind} `{name}`")]
    UnknownQuantity {
        /// Name of the scene.
        scene: &'static str,
        /// Kind: parameter, state, output or column.
        kind: &'static str,
        /// Requested name.
        name: String,
    },
    /// A machine that should oscillate does not.
    #[error("the linearized scene does not oscillate")]
    NoOscillation,
    /// The motor has no single steady state.
    #[error("the equations of the steady state are singular")]
    Singular,
}

impl CheckFailure {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Simulate(error) => error.code(),
            Self::Linear(error) => error.code(),
            Self::Field(error) => error.code(),
            Self::Modal(error) => error.code(),
            Self::Cycle(error) => error.code(),
            error => error.into(),
        }
    }
}

impl Check {
    fn verdict(&self, machine: &Machine) -> Verdict {
        let (measured, failure) = match (self.measure)(machine) {
            Ok(measured) => (measured, None),
            Err(failure) => (Measured::error(f64::INFINITY), Some(failure.to_string())),
        };
        Verdict {
            check: Cow::Borrowed(self.name),
            reference: Cow::Borrowed(self.reference),
            reason: Cow::Borrowed(self.reason),
            // NaN must not pass.
            pass: measured.error <= self.tolerance,
            value: measured.value,
            expected: measured.expected,
            ..Verdict::judged(machine.name(), measured.error, self.tolerance, failure)
        }
    }
}

impl Measured {
    fn error(error: f64) -> Self {
        Self { error, value: None, expected: None }
    }

    /// Returns |value - expected|.
    fn absolute(value: f64, expected: f64) -> Self {
        Self { error: (value - expected).abs(), value: Some(value), expected: Some(expected) }
    }

    /// Returns |value - expected|/|expected|.
    fn relative(value: f64, expected: f64) -> Self {
        let error = ((value - expected) / expected).abs();
        Self { error, value: Some(value), expected: Some(expected) }
    }
}

/// Compares two counts; the error is their difference.
fn counted(found: u64, expected: usize) -> Measured {
    Measured::absolute(found as f64, expected as f64)
}

/// Measures the convergence of a smooth twin to the machine with events: log2 of the ratio of its
/// errors at a width and at half of it. The error of the check is the deficit against `order`.
fn convergence([coarse, fine]: [f64; 2], order: f64) -> Measured {
    let found = (coarse / fine).log2();
    let error = if found.is_nan() { f64::NAN } else { (order - found).max(0.0) };
    Measured { error, value: Some(found), expected: Some(order) }
}

/// Returns the larger of two errors; NaN if one is NaN.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

/// Returns the largest absolute value.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// Returns max |ours - reference|, divided by max |reference|; NaN if the lengths differ.
fn relative_distance(ours: &[f64], reference: &[f64]) -> f64 {
    if ours.len() != reference.len() {
        return f64::NAN;
    }
    let distance = ours.iter().zip(reference).fold(0.0, |most, (a, b)| worse(most, (a - b).abs()));
    distance / reference.iter().fold(0.0, |most, value| worse(most, value.abs()))
}

#[cfg(test)]
#[path = "verify/tests.rs"]
mod tests;

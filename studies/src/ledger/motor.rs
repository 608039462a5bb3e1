//! Figures of the motor and the coupling at constant speed.

use super::{LedgerRow, compare, digits, reproduced};
use crate::closed_form::induction_motor::NAMEPLATE_4A280M8;
use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, motor_run_up, saw_gin, saw_gin_as_printed};
use crate::verify::motor_run_up::{maximum, torque_at_slip};
use crate::verify::saw_gin_as_printed::torque_at_slip as printed_torque_at_slip;

/// Mean load of the study \[N m\].
const LOAD: f64 = 843.72;

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows = number_rows()?;
    rows.extend(torque_rows()?);
    rows.push(frequency_row()?);
    Ok(rows)
}

/// Numbers that follow from parameters alone.
fn number_rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let (consistent, as_printed) = (motor_run_up(), saw_gin_as_printed());
    let electrical = 2.0 * std::f64::consts::PI * consistent.value("motor.supply_frequency")?;
    let speed = electrical / consistent.value("motor.pole_pairs")?;
    let leakage = |machine: &Machine| -> Result<f64, CheckFailure> {
        Ok(1.0 - machine.value("motor.k_s")? * machine.value("motor.k_r")?)
    };
    let sigma = leakage(&consistent)?;
    Ok(vec![
        LedgerRow {
            figure: "synchronous speed",
            unit: "rad/s",
            printed: Some(78.54),
            as_printed: Some(as_printed.value("motor.omega_0")?),
            consistent: Some(speed),
            verdict: format!(
                "{}, but the study also puts it where the electrical speed {} rad/s belongs",
                reproduced(78.54, speed, 5e-3),
                digits(electrical)
            ),
        },
        LedgerRow {
            figure: "leakage factor 1 - Ks Kr",
            unit: "1",
            printed: Some(0.0896),
            as_printed: Some(leakage(&as_printed)?),
            consistent: Some(sigma),
            verdict: format!(
                "{} by its own factors ({})",
                reproduced(0.0896, sigma, 5e-5),
                compare(0.0896, sigma)
            ),
        },
    ])
}

/// Steady torques. The printed equations have a steady state only with the speed
/// where the angle is printed, so that reading stands in the column as printed.
fn torque_rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let (consistent, as_printed) = (motor_run_up(), saw_gin_as_printed());
    let ours = |slip| torque_at_slip(&consistent, slip);
    let literal = |slip| printed_torque_at_slip(&as_printed, slip);
    let (slip, torque) = maximum(0.01, 0.5, ours)?;
    let (printed_slip, printed_torque) = maximum(0.01, 0.5, literal)?;
    let plate = NAMEPLATE_4A280M8;
    let row = |figure, unit, printed: f64, as_printed: f64, consistent: f64| LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!(
            "consistent {}; as printed, with speed for angle, {}",
            compare(printed, consistent),
            compare(printed, as_printed)
        ),
    };
    // The study states the multiple of the rated torque: 2.
    let mut starting = row(
        "starting torque, twice the rated",
        "N m",
        2.0 * plate.torque,
        literal(1.0)?,
        ours(1.0)?,
    );
    let side = if LOAD > ours(1.0)? { "exceeds" } else { "is below" };
    let load = format!("; the load of {} N m {side} the consistent one", digits(LOAD));
    starting.verdict.push_str(&load);
    Ok(vec![
        row("torque at slip 0.02", "N m", plate.torque, literal(plate.slip)?, ours(plate.slip)?),
        row("breakdown torque", "N m", plate.breakdown_torque, printed_torque, torque),
        row("breakdown slip", "1", plate.breakdown_slip, printed_slip, slip),
        starting,
    ])
}

fn frequency_row() -> Result<LedgerRow, CheckFailure> {
    Ok(LedgerRow {
        figure: "natural frequency on the coupling",
        unit: "rad/s",
        printed: None,
        as_printed: Some(natural_frequency(&saw_gin_as_printed())?),
        consistent: Some(natural_frequency(&saw_gin())?),
        verdict: "not printed; both readings share coupling and inertias".to_owned(),
    })
}

/// Undamped natural frequency on the coupling, from the emitted rate Jacobian at
/// rest: sqrt of minus d(w_d' - w_2')/d(phi_d) \[rad/s\]; a twist changes as phi_d does.
fn natural_frequency(machine: &Machine) -> Result<f64, CheckFailure> {
    let point = machine.point(&[], &[])?;
    let jacobian = machine.rate_jacobian(&point);
    let angle =
        machine.state_index("coupling.twist").or_else(|_| machine.state_index("motor.phi"))?;
    let row = |name| machine.state_index(name).map(|index| jacobian[(index, angle)]);
    Ok((row("cylinder.omega")? - row("motor.omega")?).sqrt())
}

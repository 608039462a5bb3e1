//! Figures of the motor and the coupling at constant speed.

use super::{Held, LedgerRow, Study, compare, digits, digits_of, reproduced};
use crate::closed_form::induction_motor::{MOTOR_4A280M8, NAMEPLATE_4A280M8};
use crate::closed_form::two_mass::SAW_GIN;
use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, motor_run_up, saw_gin, saw_gin_as_printed};
use crate::verify::motor_run_up::{maximum, torque_at_slip};
use crate::verify::saw_gin_as_printed::torque_at_slip as printed_torque_at_slip;

/// Mean load of the study \[N m\].
const LOAD: f64 = 843.72;

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows = number_rows()?;
    rows.extend(derived_rows());
    rows.extend(torque_rows()?);
    rows.extend(rated_rows());
    rows.push(frequency_row()?);
    rows.extend(gain_rows());
    Ok(rows)
}

const NO_LOAD: Held = Held::Verify("motor_run_up: no-load speed after 3 s");
const CURVE: Held = Held::Verify("motor_run_up: torque-speed curve at 50 slips");
const RATED: Held = Held::Verify("motor_run_up: current, power factor and efficiency at slip 0.02");

fn plate(place: &'static str, held: Held) -> LedgerRow {
    LedgerRow::of(Study::SawGin, "4.1", place, held)
}

/// Returns numbers of the data sheet that follow from others of it.
fn derived_rows() -> Vec<LedgerRow> {
    let (mutual, stator, rotor) = (3.957, 4.14, 4.155);
    let sigma = MOTOR_4A280M8.leakage();
    let pi = std::f64::consts::PI;
    [
        ("rated speed", "rad/s", 76.97, 735.0 * pi / 30.0, "735/min", 5e-3),
        ("rated torque", "N m", 974.4, 75_000.0 * 30.0 / (735.0 * pi), "75 kW at 735/min", 5e-2),
        ("rated torque from the breakdown torque", "N m", 974.4, 1948.8 / 2.0, "MK/2", 5e-2),
        ("rated slip", "1", 0.02, 1.0 - 735.0 / 750.0, "735 of 750/min", 5e-3),
        (
            "magnetizing reactance",
            "ohm",
            mutual,
            MOTOR_4A280M8.k_s * MOTOR_4A280M8.x_s,
            "Ks xs",
            5e-4,
        ),
        ("stator reactance from its leakage", "ohm", stator, mutual + 0.1826, "x_mu + x1", 5e-3),
        ("rotor reactance from its leakage", "ohm", rotor, mutual + 0.1979, "x_mu + x2", 5e-4),
        ("alpha_s", "1", 0.0103, 0.043 / stator, "r1/xs", 5e-5),
        ("alpha_r", "1", 0.0077, 0.032 / rotor, "r2/xr", 5e-5),
        ("alpha_s' from resistance", "1", 0.115, 0.043 / (stator * sigma), "r1/(sigma xs)", 5e-4),
        ("alpha_r' from resistance", "1", 0.0858, 0.032 / (rotor * sigma), "r2/(sigma xr)", 5e-5),
        (
            "stator resistance r1",
            "ohm",
            0.043,
            MOTOR_4A280M8.alpha_s * sigma * MOTOR_4A280M8.x_s,
            "alpha_s' sigma xs",
            5e-4,
        ),
        (
            "rotor resistance r2",
            "ohm",
            0.032,
            MOTOR_4A280M8.alpha_r * sigma * rotor,
            "alpha_r' sigma xr",
            5e-4,
        ),
        (
            "stator leakage reactance x1",
            "ohm",
            0.1826,
            (1.0 - MOTOR_4A280M8.k_s) * MOTOR_4A280M8.x_s,
            "(1 - Ks) xs",
            5e-5,
        ),
        (
            "rotor leakage reactance x2",
            "ohm",
            0.1979,
            (1.0 - MOTOR_4A280M8.k_r) * rotor,
            "(1 - Kr) xr",
            5e-5,
        ),
    ]
    .map(|(figure, unit, printed, ours, from, half_digit)| LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        as_printed: Some(printed),
        consistent: Some(ours),
        verdict: match reproduced(printed, ours, half_digit) {
            "reproduced" => format!("reproduced from {from}"),
            other => format!("{other} from {from} ({})", compare(printed, ours)),
        },
        ..plate("`closed_form::induction_motor`", CURVE)
    })
    .into()
}

/// Returns current, power factor and efficiency at the rated slip.
fn rated_rows() -> Vec<LedgerRow> {
    let stated = NAMEPLATE_4A280M8;
    let ours = MOTOR_4A280M8.load_point(stated.slip);
    let supplied = stated.power / stated.efficiency;
    let row = |figure, unit, printed: f64, consistent: f64, why: String| LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        consistent: Some(consistent),
        verdict: format!("{}; {why}", compare(printed, consistent)),
        ..plate("`motor_run_up`; `closed_form::induction_motor`", RATED)
    };
    let kilowatts = |watts: f64| digits_of(1e-3 * watts, 3);
    let missing = (supplied - stated.power) - (ours.supplied - ours.shaft_power);
    vec![
        row(
            "phase current at rated slip",
            "A",
            stated.current,
            ours.current,
            "the equivalent circuit models the windings only and gives less power at this slip"
                .to_owned(),
        ),
        row(
            "power factor at rated slip",
            "1",
            stated.power_factor,
            ours.power_factor,
            "as above".to_owned(),
        ),
        row(
            "efficiency at rated slip",
            "1",
            stated.efficiency,
            ours.efficiency(),
            format!(
                "copper losses are {} kW; the data sheet's {} kW leave {} kW for iron, friction \
                 and fan losses, which the equations omit",
                kilowatts(ours.supplied - ours.shaft_power),
                kilowatts(supplied - stated.power),
                kilowatts(missing)
            ),
        ),
        row(
            "power at the shaft at rated slip",
            "W",
            stated.power,
            ours.shaft_power,
            "electromagnetic torque times speed".to_owned(),
        ),
    ]
}

/// Returns the effect of each printed form of the load on the coupling.
fn gain_rows() -> Vec<LedgerRow> {
    let rated = 735.0 * std::f64::consts::PI / 30.0;
    [
        ("ratio of coupling torque to load torque, sin(w2 t)", "(1)", rated),
        (
            "ratio of coupling torque to load torque, sin(pi w2 t)",
            "4.1",
            std::f64::consts::PI * rated,
        ),
        (
            "ratio of coupling torque to load torque, cos(pi w2 t)",
            "(9)",
            std::f64::consts::PI * rated,
        ),
    ]
    .map(|(figure, at, frequency)| LedgerRow {
        figure,
        unit: "1",
        consistent: Some(SAW_GIN.load_gain(frequency)),
        verdict: format!(
            "not printed; at {} rad/s; sine and cosine differ only by a shift of a quarter period",
            digits_of(frequency, 4)
        ),
        ..LedgerRow::of(
            Study::SawGin,
            at,
            "`two_mass`; unit `technological_load`",
            Held::Verify("two_mass: frequency response of the twist to the load"),
        )
    })
    .into()
}

/// Returns numbers that follow from parameters alone.
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
                "{}; the study also uses it in place of the electrical speed {} rad/s",
                reproduced(78.54, speed, 5e-3),
                digits(electrical)
            ),
            ..plate("unit `induction_motor`", NO_LOAD)
        },
        LedgerRow {
            figure: "leakage factor 1 - Ks Kr",
            unit: "1",
            printed: Some(0.0896),
            as_printed: Some(leakage(&as_printed)?),
            consistent: Some(sigma),
            verdict: format!(
                "{} from its own factors ({})",
                reproduced(0.0896, sigma, 5e-5),
                compare(0.0896, sigma)
            ),
            ..plate("unit `induction_motor`", CURVE)
        },
    ])
}

/// Returns steady torques. The printed equations have a steady state only with the speed in place
/// of the angle, so that reading is in the column as printed.
fn torque_rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let (consistent, as_printed) = (motor_run_up(), saw_gin_as_printed());
    let ours = |slip| torque_at_slip(&consistent, slip);
    let literal = |slip| printed_torque_at_slip(&as_printed, slip);
    let (slip, torque) = maximum(0.01, 0.5, ours)?;
    let (printed_slip, printed_torque) = maximum(0.01, 0.5, literal)?;
    let stated = NAMEPLATE_4A280M8;
    let row = |figure, unit, printed: f64, as_printed: f64, consistent: f64| LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!(
            "consistent: {}; as printed, with speed instead of angle: {}",
            compare(printed, consistent),
            compare(printed, as_printed)
        ),
        ..plate("`motor_run_up`", CURVE)
    };
    // The study states the multiple of the rated torque: 2.
    let mut starting = row(
        "starting torque, twice the rated",
        "N m",
        2.0 * stated.torque,
        literal(1.0)?,
        ours(1.0)?,
    );
    let side = if LOAD > ours(1.0)? { "exceeds" } else { "is below" };
    let load = format!("; the load of {} N m {side} the consistent torque", digits(LOAD));
    starting.verdict.push_str(&load);
    Ok(vec![
        row("torque at slip 0.02", "N m", stated.torque, literal(stated.slip)?, ours(stated.slip)?),
        row("breakdown torque", "N m", stated.breakdown_torque, printed_torque, torque),
        row("breakdown slip", "1", stated.breakdown_slip, printed_slip, slip),
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
        verdict: "not printed; both readings share the coupling and the inertias".to_owned(),
        ..LedgerRow::of(
            Study::SawGin,
            "(1)",
            "`two_mass`, `saw_gin`",
            Held::Verify("two_mass: natural frequency of the coupling"),
        )
    })
}

/// Returns the undamped natural frequency on the coupling, from the emitted rate Jacobian at rest:
/// sqrt of minus d(w_d' - w_2')/d(phi_d) \[rad/s\]; a twist changes like phi_d.
fn natural_frequency(machine: &Machine) -> Result<f64, CheckFailure> {
    let point = machine.point(&[], &[])?;
    let jacobian = machine.rate_jacobian(&point);
    let angle =
        machine.state_index("coupling.twist").or_else(|_| machine.state_index("motor.phi"))?;
    let row = |name| machine.state_index(name).map(|index| jacobian[(index, angle)]);
    Ok((row("cylinder.omega")? - row("motor.omega")?).sqrt())
}

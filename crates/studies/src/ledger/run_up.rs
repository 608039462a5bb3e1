//! Figures of the run-up, from runs of the scenes in every reading.

use super::{Held, LedgerRow, Study, compare, digits_of, reproduced};
use crate::closed_form::printed_laws::{PEAK_ACCELERATION_TIME, acceleration};
use crate::verify::CheckFailure;
use crate::verify::machine::{Machine, saw_gin, saw_gin_as_printed};

const UNTIL: f64 = 5.0;
/// Number of output times, every 0.1 ms: these resolve the peak of a vibration of 314 rad/s to
/// 1e-4.
const POINTS: usize = 50_001;
const SYNCHRONOUS: f64 = 78.54;
/// Printed maximum of the cylinder's acceleration \[rad/s^2\].
const ACCELERATION: f64 = 8739.828;
const EMPTY: [(&str, f64); 2] = [("load.mean", 0.0), ("load.amplitude", 0.0)];

/// Runs of the figures, all from rest over 5 s.
pub(super) struct Runs {
    /// Consistent reading, without load.
    empty: Outcome,
    /// As printed, literally with the rotor's angle, without load.
    angle: Result<Outcome, CheckFailure>,
    /// As printed, with the rotor's speed in place of its angle, without load.
    speed: Result<Outcome, CheckFailure>,
}

/// Results of a run.
pub(super) struct Outcome {
    /// Largest absolute torque of the motor \[N m\].
    peak_torque: f64,
    /// Largest absolute acceleration of the cylinder \[rad/s^2\], and its time \[s\].
    peak_acceleration: (f64, f64),
    /// Least and largest speed of the motor \[rad/s\].
    speeds: (f64, f64),
    /// Speed of the motor at the end \[rad/s\].
    end_speed: f64,
    /// Time from which on the speed stays within 1 % of the synchronous one \[s\].
    settled: Option<f64>,
}

pub(super) fn rows(runs: &Runs) -> Vec<LedgerRow> {
    let mut rows = vec![
        runs.row("speed 5 s after an empty start", "rad/s", SYNCHRONOUS, |run| Some(run.end_speed)),
        runs.row("largest motor torque in an empty run-up", "N m", 40_000.0, |run| {
            Some(run.peak_torque)
        }),
        runs.row("time until speed stays within 1 % of synchronous", "s", 3.0, |run| run.settled),
        runs.row("largest cylinder acceleration", "rad/s^2", ACCELERATION, |run| {
            Some(run.peak_acceleration.0)
        }),
        runs.row("time of the largest cylinder acceleration", "s", PEAK_ACCELERATION_TIME, |run| {
            Some(run.peak_acceleration.1)
        }),
    ];
    if let (Ok(run), Some(speed)) = (&runs.angle, rows.first_mut()) {
        let (low, high) = (digits_of(run.speeds.0, 3), digits_of(run.speeds.1, 3));
        let swing =
            format!("; with the printed angle, the speed ranges from {low} to {high} rad/s");
        speed.verdict.push_str(&swing);
    }
    rows.push(law_row());
    rows.push(rounded_row());
    rows
}

/// Returns the printed law at the printed time, and the time at which it has the printed value: it
/// decreases from 1.8435 s to 1.8445 s.
fn law_row() -> LedgerRow {
    let law = acceleration(PEAK_ACCELERATION_TIME);
    let (mut low, mut high) = (1.8435, 1.8445);
    while high - low > 1e-9 {
        let middle = f64::midpoint(low, high);
        if acceleration(middle) > ACCELERATION {
            low = middle;
        } else {
            high = middle;
        }
    }
    LedgerRow {
        figure: "printed law of acceleration at 1.844 s",
        unit: "rad/s^2",
        printed: Some(ACCELERATION),
        as_printed: Some(law),
        consistent: None,
        verdict: format!(
            "{}: the law has the printed value at {} s ({}) and grows without bound",
            reproduced(PEAK_ACCELERATION_TIME, low, 5e-4),
            digits_of(low, 6),
            compare(ACCELERATION, law)
        ),
        ..of_law()
    }
}

fn of_law() -> LedgerRow {
    LedgerRow::of(
        Study::SawGin,
        "(3)",
        "`closed_form::printed_laws`",
        Held::Verify("saw_gin_as_printed: printed law of acceleration at 1.844 s"),
    )
}

/// Returns the peak of the discussion, which differs from that of the results.
fn rounded_row() -> LedgerRow {
    let (peak, time) = (9000.0, 1.8);
    LedgerRow {
        figure: "largest cylinder acceleration at 1.8 s",
        unit: "rad/s^2",
        printed: Some(peak),
        as_printed: Some(acceleration(time).abs()),
        consistent: None,
        verdict: format!(
            "the discussion rounds {} rad/s^2 at 1.844 s; the law gives {} at 1.8 s",
            digits_of(ACCELERATION, 7),
            digits_of(acceleration(time), 5)
        ),
        ..LedgerRow { at: "section 5", ..of_law() }
    }
}

impl Runs {
    pub(super) fn new() -> Result<Self, CheckFailure> {
        let printed = |literal| {
            let settings = [EMPTY[0], EMPTY[1], ("motor.literal", literal)];
            Outcome::of(&saw_gin_as_printed(), &settings)
        };
        Ok(Self {
            empty: Outcome::of(&saw_gin(), &EMPTY)?,
            angle: printed(1.0),
            speed: printed(0.0),
        })
    }

    /// Returns a row of one figure of the runs without load. The literal reading is in the column
    /// as printed; the verdict also reports the other one.
    fn row(
        &self,
        figure: &'static str,
        unit: &'static str,
        printed: f64,
        value: impl Fn(&Outcome) -> Option<f64>,
    ) -> LedgerRow {
        let consistent = value(&self.empty);
        let tell = |value: Option<f64>| match value {
            Some(value) => format!("{} ({})", digits_of(value, 5), compare(printed, value)),
            None => "never".to_owned(),
        };
        let literal = match &self.angle {
            Ok(run) => tell(value(run)),
            Err(failure) => format!("nothing, since the run fails: {failure}"),
        };
        let other = match &self.speed {
            Ok(run) => tell(value(run)),
            Err(failure) => format!("nothing, since the run fails: {failure}"),
        };
        LedgerRow {
            figure,
            unit,
            printed: Some(printed),
            as_printed: self.angle.as_ref().ok().and_then(&value),
            consistent,
            verdict: format!(
                "consistent: {}; as printed: {literal}; with speed instead of angle: {other}",
                tell(consistent)
            ),
            ..LedgerRow::of(
                Study::SawGin,
                "figure 3",
                "`saw_gin`, `saw_gin_as_printed`",
                Held::Verify("saw_gin: run-up and loading, state after 2 s"),
            )
        }
    }
}

impl Outcome {
    fn of(machine: &Machine, settings: &[(&str, f64)]) -> Result<Self, CheckFailure> {
        let run = machine.simulation(settings)?.until(UNTIL).points(POINTS).run()?;
        let column = |name| machine.column(&run, name);
        let speed = column("motor_speed")?;
        let off = |speed: &&f64| (**speed / SYNCHRONOUS - 1.0).abs() > 0.01;
        let last_off = speed.iter().rposition(|speed| off(&speed));
        let settled = last_off.map_or(Some(0), |last| Some(last + 1));
        Ok(Self {
            peak_torque: peak(&run.times, column("motor_torque")?).0,
            peak_acceleration: peak(&run.times, column("cylinder_acceleration")?),
            speeds: speed.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), speed| {
                (low.min(*speed), high.max(*speed))
            }),
            end_speed: machine.last(&run, "motor_speed")?,
            settled: settled.and_then(|index| run.times.get(index).copied()),
        })
    }
}

/// Returns the largest absolute value of a column, and its time.
fn peak(times: &[f64], values: &[f64]) -> (f64, f64) {
    times.iter().zip(values).fold((0.0, 0.0), |(largest, at), (time, value)| {
        if value.abs() > largest { (value.abs(), *time) } else { (largest, at) }
    })
}

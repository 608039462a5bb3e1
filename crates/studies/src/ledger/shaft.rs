//! Figures of the shaft of the saw cylinder and of the load spread over it.

use super::{Held, LedgerRow, Study, compare, digits, reproduced};
use crate::closed_form::printed_laws::{Reading, SAW_GIN_SHAFT, TWIST_TIME};
use crate::verify::machine::saw_gin_shaft;
use crate::verify::{CheckFailure, largest};
use machinist::Method;

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let shaft = SAW_GIN_SHAFT;
    let at_end = |reading| shaft.slope(TWIST_TIME, shaft.length, reading).to_degrees().abs();
    let figures = at_end(Reading::OfTheFigures);
    let angle = shaft.angle(TWIST_TIME, shaft.length, Reading::AsPrinted).to_degrees().abs();
    let run = run()?;
    let integral = shaft.load_density_integral();
    Ok(vec![
        LedgerRow {
            figure: "largest relative twist of the shaft",
            unit: "deg/m",
            printed: Some(1.89),
            as_printed: Some(at_end(Reading::AsPrinted)),
            consistent: Some(run.slope),
            verdict: format!(
                "at 1.8 s as printed: {}; {} ({} deg/m) with density J instead of J/l and half \
                 the load term; consistent: largest slope at the driven end in a run of 2 s",
                compare(1.89, at_end(Reading::AsPrinted)),
                reproduced(1.89, figures, 5e-3),
                digits(figures)
            ),
            ..of("figure 5, (14)")
        },
        LedgerRow {
            figure: "largest twist of the shaft",
            unit: "deg",
            printed: Some(4.39),
            as_printed: Some(angle),
            consistent: Some(run.twist),
            verdict: format!(
                "at 1.8 s as printed: {}; {} ({} deg) as that relative twist times the length; \
                 consistent: largest value in a run of 2 s",
                compare(4.39, angle),
                reproduced(4.39, figures * shaft.length, 5e-3),
                digits(figures * shaft.length)
            ),
            ..of("figure 6, (15)")
        },
        LedgerRow {
            figure: "largest speed difference between the shaft's ends",
            unit: "rad/s",
            printed: None,
            as_printed: Some(0.0),
            consistent: Some(run.difference),
            verdict: "not printed; by (3) all sections move alike; the consistent shaft twists"
                .to_owned(),
            ..of("figure 4")
        },
        LedgerRow {
            figure: "mean load, from its density along the shaft",
            unit: "N m",
            printed: Some(shaft.load_mean),
            as_printed: Some(integral),
            consistent: Some(shaft.load_mean),
            verdict: format!(
                "the printed density q x gives a load {}; M/l or 2 M x/l^2 gives the printed mean",
                compare(shaft.load_mean, integral)
            ),
            ..LedgerRow {
                held: Held::Verify(
                    "saw_gin_shaft: integrals of the even and the growing load density",
                ),
                ..of("(9)")
            }
        },
        number("radius of the saw discs R", "m", 0.16, shaft.disc_radius),
        number("working arc of the discs", "rad", std::f64::consts::FRAC_PI_3, shaft.arc),
    ])
}

fn of(at: &'static str) -> LedgerRow {
    LedgerRow::of(
        Study::SawGin,
        at,
        "`saw_gin_shaft`; `closed_form::printed_laws`",
        Held::Verify("saw_gin_shaft: twist of the shaft under both steady loads"),
    )
}

/// Returns a number that only the printed density of the load uses.
fn number(figure: &'static str, unit: &'static str, printed: f64, ours: f64) -> LedgerRow {
    LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        as_printed: Some(ours),
        consistent: None,
        verdict: "used by the printed load density only".to_owned(),
        ..LedgerRow {
            held: Held::Test("printed_load_density_is_not_balanced"),
            place: "`closed_form::printed_laws`",
            ..of("(9)")
        }
    }
}

/// Largest absolute values over the run of the scene with the distributed shaft.
struct Run {
    /// Slope at the driven end \[deg/m\].
    slope: f64,
    /// Twist of the whole shaft \[deg\].
    twist: f64,
    /// Difference of the speeds of both ends \[rad/s\].
    difference: f64,
}

fn run() -> Result<Run, CheckFailure> {
    let machine = saw_gin_shaft();
    let run = machine.simulation(&[])?.until(2.0).points(4001).rtol(1e-6);
    let run = run.method(Method::Rodas5p).run()?;
    let (driven, end) = (machine.column(&run, "driven_speed")?, machine.column(&run, "end_speed")?);
    let difference: Vec<f64> = driven.iter().zip(end).map(|(a, b)| a - b).collect();
    Ok(Run {
        slope: largest(machine.column(&run, "slope")?).to_degrees(),
        twist: largest(machine.column(&run, "twist")?).to_degrees(),
        difference: largest(&difference),
    })
}

//! Figures of the shaft of the saw cylinder and of the load spread over it.

use super::run_up::Runs;
use super::{LedgerRow, compare, digits, reproduced};
use crate::closed_form::printed_laws::{Reading, SAW_GIN_SHAFT, TWIST_TIME};

pub(super) fn rows(runs: &Runs) -> Vec<LedgerRow> {
    let shaft = SAW_GIN_SHAFT;
    let at_end = |reading| shaft.slope(TWIST_TIME, shaft.length, reading).to_degrees().abs();
    let figures = at_end(Reading::OfTheFigures);
    let angle = shaft.angle(TWIST_TIME, shaft.length, Reading::AsPrinted).to_degrees().abs();
    // The shaft's lowest frequency, 819 rad/s, lies far above that of the coupling,
    // 155 rad/s: it follows the torque that the coupling hands it, which falls from
    // the driven end to nothing at the free one, about evenly for loads and inertia
    // spread evenly.
    let slope = (runs.loaded.peak_coupling_torque / shaft.rigidity()).to_degrees();
    let integral = shaft.load_density_integral();
    vec![
        LedgerRow {
            figure: "largest relative twist of the shaft",
            unit: "deg/m",
            printed: Some(1.89),
            as_printed: Some(at_end(Reading::AsPrinted)),
            consistent: Some(slope),
            verdict: format!(
                "at 1.8 s as printed {}; {} ({} deg/m) with density J for J/l and the load term \
                 halved; consistent: largest torque of the coupling over G I",
                compare(1.89, at_end(Reading::AsPrinted)),
                reproduced(1.89, figures, 5e-3),
                digits(figures)
            ),
        },
        LedgerRow {
            figure: "largest twist of the shaft",
            unit: "deg",
            printed: Some(4.39),
            as_printed: Some(angle),
            consistent: Some(slope * shaft.length / 2.0),
            verdict: format!(
                "at 1.8 s as printed {}; {} ({} deg) as that relative twist times the length; consistent: half of slope times length, for an even load",
                compare(4.39, angle),
                reproduced(4.39, figures * shaft.length, 5e-3),
                digits(figures * shaft.length)
            ),
        },
        LedgerRow {
            figure: "mean load, from its density along the shaft",
            unit: "N m",
            printed: Some(shaft.load_mean),
            as_printed: Some(integral),
            consistent: Some(shaft.load_mean),
            verdict: format!(
                "the printed density q x gives a load {}; a balanced one is M/l or 2 M x/l^2",
                compare(shaft.load_mean, integral)
            ),
        },
    ]
}

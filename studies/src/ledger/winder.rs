//! Figures of the winder study: amplitudes of the bobbin and mobility of its holder.

use super::{LedgerRow, compare, reproduced};
use crate::closed_form::winder::{BENCH_M5, FORCE_M5, SHAPE_M5};
use crate::closed_form::winding_pair::HOLDER_POSITIONS;
use crate::verify::winder_linear::PRINTED_MOBILITY;

pub(super) fn rows() -> Vec<LedgerRow> {
    let layer = BENCH_M5.layer_stiffness;
    let force = amplitude(
        "amplitude of the bobbin under force, bench model M5",
        BENCH_M5.amplitude_as_printed(FORCE_M5.amplitude, FORCE_M5.frequency),
        BENCH_M5.answer_to_force(&FORCE_M5).amplitude,
        "the printed h^2 m^2 p^2 belongs to a damping term h m q'",
    );
    let shape = amplitude(
        "amplitude of the bobbin over the drum's shape, bench model M5",
        BENCH_M5.amplitude_as_printed(layer * SHAPE_M5.amplitude, SHAPE_M5.frequency),
        BENCH_M5.answer_to_shape(&SHAPE_M5).amplitude,
        "besides, the layer's viscosity carries the shape's rate",
    );
    [force, shape].into_iter().chain(mobility()).collect()
}

fn amplitude(figure: &'static str, as_printed: f64, consistent: f64, why: &str) -> LedgerRow {
    LedgerRow {
        figure,
        unit: "m",
        printed: None,
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!(
            "not printed; the consistent one is {}: {why}",
            compare(as_printed, consistent)
        ),
    }
}

/// The printed formula has a minus where 2 p5 is meant, and so gives no number.
fn mobility() -> impl Iterator<Item = LedgerRow> {
    HOLDER_POSITIONS.iter().zip(MOBILITY_FIGURES).zip(PRINTED_MOBILITY).map(
        |((position, figure), printed)| {
            let (printed, ours) = (f64::from(printed), f64::from(position.mobility()));
            LedgerRow {
                figure,
                unit: "1",
                printed: Some(printed),
                as_printed: None,
                consistent: Some(ours),
                verdict: format!(
                    "{} by 3 n - 2 p5 - p4; the formula is printed with minus signs for its \
                     multiplications",
                    reproduced(printed, ours, 0.0)
                ),
            }
        },
    )
}

/// In the order of [`HOLDER_POSITIONS`].
const MOBILITY_FIGURES: [&str; 5] = [
    "mobility of the bobbin holder, working, stable",
    "mobility of the bobbin holder, not winding, from working",
    "mobility of the bobbin holder, filling",
    "mobility of the bobbin holder, working, unstable",
    "mobility of the bobbin holder, not winding, from unstable",
];

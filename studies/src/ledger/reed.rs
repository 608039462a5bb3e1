//! Figures of the reed on its driven shaft.

use super::{LedgerRow, compare, digits};
use crate::closed_form::reed::{REED_STUDY, Reed, ReedShaft};

const ROOTS: [&str; 3] = [
    "first root of the reed's frequency equation",
    "second root of the reed's frequency equation",
    "third root of the reed's frequency equation",
];

pub(super) fn rows() -> Vec<LedgerRow> {
    let as_printed = REED_STUDY.printed_frequencies(3);
    let mut rows: Vec<LedgerRow> = (1..)
        .zip(ROOTS)
        .zip(as_printed)
        .map(|((k, figure), as_printed)| {
            let consistent = REED_STUDY.frequency(k, Reed::Held);
            LedgerRow {
                figure,
                unit: "1",
                printed: None,
                as_printed: Some(as_printed),
                consistent: Some(consistent),
                verdict: format!(
                    "equation (15) as printed has xi1 for xi0 in its first bracket: {}; the scene's \
                     elements agree with the consistent one",
                    compare(consistent, as_printed)
                ),
            }
        })
        .collect();
    rows.push(conclusion());
    rows
}

/// Steady amplitudes under the study's drive, with C2 = C1/2 and C1.
fn conclusion() -> LedgerRow {
    let answer = |share: f64| {
        let contact_stiffness = share * REED_STUDY.reed_stiffness;
        let shaft = ReedShaft { contact_stiffness, ..REED_STUDY };
        let [amplitude, frequency] = [shaft.drive_amplitude(), shaft.drive_frequency()];
        let answer = shaft.harmonic_response(amplitude, frequency, Reed::Free);
        [answer.angle(shaft.reed_position), answer.reed_angle(), answer.stress_beside_reed()[0]]
    };
    let (soft, stiff) = (answer(0.5), answer(1.0));
    let [shaft, reed, stress] =
        [0, 1, 2].map(|index: usize| 100.0 * (stiff[index] / soft[index] - 1.0));
    LedgerRow {
        figure: "change of stress at the reed as the contact stiffens from C1/2 to C1",
        unit: "%",
        printed: None,
        as_printed: None,
        consistent: Some(stress),
        verdict: format!(
            "concluded: motion little, stress markedly; steady, the shaft's angle changes by {} % and \
             the reed's by {} %: true of the shaft, not of the reed",
            digits(shaft.round()),
            digits(reed.round())
        ),
    }
}

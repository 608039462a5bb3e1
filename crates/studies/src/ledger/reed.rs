//! Numbers of the reed on its driven shaft.

use super::{Held, LedgerRow, Study, compare, digits_of};
use crate::closed_form::reed::{DRIVE_HALF_PERIOD, DRIVE_SPEED, REED_STUDY, Reed};
use crate::reed_cells::Fell;
use crate::reed_study::{Beat, beats};
use crate::verify::CheckFailure;

const ROOTS: [&str; 3] = [
    "first root of the reed's frequency equation",
    "second root of the reed's frequency equation",
    "third root of the reed's frequency equation",
];
const SCALES: Held = Held::Test("scales_are_those_of_the_study");

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows = scales();
    rows.extend(drive());
    rows.extend(roots());
    rows.extend(conclusion()?);
    Ok(rows)
}

fn of(at: &'static str, place: &'static str, held: Held) -> LedgerRow {
    LedgerRow::of(Study::Reed, at, place, held)
}

/// Returns the printed scales, which have dimensions, and the consistent ones.
fn scales() -> Vec<LedgerRow> {
    let shaft = REED_STUDY;
    let [xi, tau, alpha] = shaft.printed_scales();
    let unscaled = "the printed scale has a dimension";
    let row = |figure, unit, as_printed: f64, consistent: f64, why: &str| LedgerRow {
        figure,
        unit,
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!("not printed; {why}"),
        ..of("before (6)", "`closed_form::reed`", SCALES)
    };
    vec![
        row(
            "xi over x",
            "1/m",
            xi,
            1.0 / shaft.length_scale(),
            "the printed factor is dimensionless, so xi is a length",
        ),
        row(
            "tau over t",
            "1/s",
            tau,
            1.0 / shaft.time_scale(),
            "the printed factor is a speed, so tau is a length",
        ),
        row("alpha", "1", alpha, shaft.alpha(), &format!("{unscaled}, 1/m")),
        row("beta = C1/C0", "1", shaft.beta(), shaft.beta(), "same in both readings"),
        LedgerRow {
            at: "after (10)",
            ..row(
                "xi0, position of the reed",
                "1",
                xi * shaft.reed_position,
                shaft.reed_place(),
                unscaled,
            )
        },
        LedgerRow {
            at: "after (10)",
            ..row(
                "xi1, end of the shaft",
                "1",
                xi * shaft.reed_position,
                shaft.end_place(),
                "defined with l0, as xi0, instead of l",
            )
        },
    ]
}

/// Returns the law of the drive.
fn drive() -> Vec<LedgerRow> {
    let shaft = REED_STUDY;
    let row = |figure, unit, printed, as_printed, consistent: f64, verdict: &str, held| LedgerRow {
        figure,
        unit,
        printed,
        as_printed,
        consistent: Some(consistent),
        verdict: verdict.to_owned(),
        ..of("results", "unit `imposed_drive`", held)
    };
    let steady = Held::Verify(
        "reed_beat_up: steady answer at 1, 3 and 10 times the drive's frequency, 10 elements of order 8",
    );
    vec![
        row(
            "speed v0 of the drive",
            "rad/s",
            Some(30.0),
            Some(30.0),
            DRIVE_SPEED,
            "as printed",
            steady,
        ),
        row(
            "half period tau0 of the drive",
            "1",
            Some(80.0),
            Some(80.0),
            DRIVE_HALF_PERIOD,
            "as printed",
            steady,
        ),
        row(
            "amplitude of the drive, v0 tau0/pi",
            "rad",
            None,
            Some(DRIVE_SPEED * DRIVE_HALF_PERIOD / std::f64::consts::PI),
            shaft.drive_amplitude(),
            "not printed; tau0 is dimensionless, so the amplitude needs the factor T",
            SCALES,
        ),
        LedgerRow {
            place: "unit `loom_shaft`",
            ..row(
                "shear modulus from E = 2e11 Pa and nu = 0.3",
                "Pa",
                None,
                Some(2e11 / 2.6),
                shaft.shear_modulus(),
                "not printed; E/(2 (1 + nu))",
                SCALES,
            )
        },
    ]
}

fn roots() -> Vec<LedgerRow> {
    let as_printed = REED_STUDY.printed_frequencies(3);
    let rows = (1..).zip(ROOTS).zip(as_printed).map(|((k, figure), as_printed)| {
        let consistent = REED_STUDY.frequency(k, Reed::Held);
        LedgerRow {
            figure,
            unit: "1",
            printed: None,
            as_printed: Some(as_printed),
            consistent: Some(consistent),
            verdict: format!(
                "not printed; (15) has xi1 instead of xi0 in its first bracket: {}; the scene's \
                 finite elements agree with the consistent root",
                compare(consistent, as_printed)
            ),
            ..of(
                "(15)",
                "`closed_form::reed`; `reed_beat_up`",
                Held::Verify(
                    "reed_beat_up: first three frequencies with the reed held, 10 elements of order 8",
                ),
            )
        }
    });
    rows.collect()
}

/// Returns the changes by a stiffer fell, for one that only pushes and, as printed, for one that
/// also pulls.
fn conclusion() -> Result<Vec<LedgerRow>, CheckFailure> {
    let [_, soft, stiff] = &beats(Fell::PushesAndPulls)?;
    let [_, one_soft, one_stiff] = &beats(Fell::OnlyPushes)?;
    let held = Held::Verify(
        "reed_beat_up_one_sided: largest angles and stress before the reed, C2 = C1/2 and C1",
    );
    let row = |at, figure, unit, as_printed: f64, consistent: f64, verdict: String| LedgerRow {
        figure,
        unit,
        printed: None,
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict,
        ..of(at, "`reed_beat_up_one_sided`; pulling fell: `reed_beat_up`", held)
    };
    let mut rows = Vec::new();
    let figures = [
        [
            "largest angle of the shaft at the reed, C2 = C1/2",
            "largest angle of the shaft at the reed, C2 = C1",
        ],
        ["largest angle of the reed, C2 = C1/2", "largest angle of the reed, C2 = C1"],
        ["largest stress before the reed, C2 = C1/2", "largest stress before the reed, C2 = C1"],
        ["largest stress after the reed, C2 = C1/2", "largest stress after the reed, C2 = C1"],
    ];
    for (index, ([first, second], (at, unit))) in figures
        .into_iter()
        .zip([("figure 2", "rad"), ("figure 2", "rad"), ("figure 3", "Pa"), ("figure 3", "Pa")])
        .enumerate()
    {
        for (figure, linear, machine) in [(first, soft, one_soft), (second, stiff, one_stiff)] {
            let [as_printed, consistent] = [linear, machine].map(|beat| beat.largest()[index]);
            let words = "plotted without numbers; over one period of the drive".to_owned();
            rows.push(row(at, figure, unit, as_printed, consistent, words));
        }
    }
    let [printed, ours] = [soft.change_to(stiff), one_soft.change_to(one_stiff)];
    let told = |value: f64| format!("{} %", digits_of(value, 2));
    let changes = [
        "change of the shaft's largest angle as the contact stiffens from C1/2 to C1",
        "change of the reed's largest angle as the contact stiffens from C1/2 to C1",
        "change of stress at the reed as the contact stiffens from C1/2 to C1",
    ];
    for (index, figure) in changes.into_iter().enumerate() {
        rows.push(row(
            "conclusion",
            figure,
            "%",
            printed[index],
            ours[index],
            format!(
                "concluded: the motion changes little, the stress markedly; true for a fell that \
                 only pushes: shaft {}, reed {}, stress {}; with a fell that also pulls the reed \
                 changes by {}",
                told(ours[0]),
                told(ours[1]),
                told(ours[2]),
                told(printed[1])
            ),
        ));
    }
    let forward = |soft: &Beat, stiff: &Beat| 100.0 * (stiff.forward() / soft.forward() - 1.0);
    rows.push(row(
        "conclusion",
        "change of the reed's travel into the fell as the contact stiffens from C1/2 to C1",
        "%",
        forward(soft, stiff),
        forward(one_soft, one_stiff),
        "not printed; the largest angle occurs on the way back, where nothing touches the reed"
            .to_owned(),
    ));
    Ok(rows)
}

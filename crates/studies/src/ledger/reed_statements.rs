//! The reed's equations, figures and parameters.

use super::{Held, LedgerRow, Parameter, Statement, Study};
use crate::verify::CheckFailure;
use crate::verify::machine::reed_beat_up;

const STEADY: Held = Held::Verify(
    "reed_beat_up: steady answer at 1, 3 and 10 times the drive's frequency, 10 elements of order 8",
);
const SCALED: Held = Held::Verify(
    "reed_beat_up: angles over a period of the drive by equations (6) and (7), 6 elements of order 4",
);
const SHAPES: Held = Held::Test("mode_shapes_satisfy_the_equations_of_motion");
const CELLS: Held = Held::Verify(
    "reed_beat_up_one_sided: angles over a period of the drive, C2 = C1/2 and C1, 24 elements of order 4",
);
const STRESSES: Held = Held::Verify(
    "reed_beat_up_one_sided: stresses over a period of the drive, C2 = C1/2 and C1, 24 elements of order 4",
);

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows: Vec<LedgerRow> = STATEMENTS.iter().map(|told| told.row(Study::Reed)).collect();
    let machine = reed_beat_up();
    for parameter in PARAMETERS {
        rows.push(parameter.row(Study::Reed, &machine)?);
    }
    Ok(rows)
}

const STATEMENTS: &[Statement] = &[
    Statement {
        at: "figure 1",
        figure: "half of the shaft, its drive and its reed",
        verdict: "consistent; x = l is the middle of a symmetric shaft",
        place: "`reed_beat_up`, drawn on its report page",
        held: STEADY,
    },
    Statement {
        at: "introduction",
        figure: "combined bending and torsion, named as the example",
        verdict: "the study derives torsion only, and the scene models torsion only: a density of \
                  the field language has one field with u_x and u_t; a beam in bending needs u_xx \
                  or, by Timoshenko, two fields",
        place: "`reed_beat_up`, torsion",
        held: STEADY,
    },
    Statement {
        at: "(1), (2)",
        figure: "shaft and reed",
        verdict: "printed: rotational stiffnesses times R, whose dimensions disagree, Cp and b \
                  instead of C0 and l0, and no C2; consistent: no R, and the fell's torque acts on \
                  the reed",
        place: "`reed_beat_up`; units `loom_shaft`, `reed`",
        held: STEADY,
    },
    Statement {
        at: "(3)",
        figure: "initial state at rest",
        verdict: "same in both readings",
        place: "`reed_beat_up`",
        held: Held::Verify("reed_beat_up: angles from rest over 4 ms, 24 elements of order 4"),
    },
    Statement {
        at: "(4), (9)",
        figure: "no torque at x = -0",
        verdict: "same in both readings: the drive's spring acts at x = 0 itself",
        place: "unit `loom_shaft`, port `driven`",
        held: STEADY,
    },
    Statement {
        at: "(5), (10)",
        figure: "u = 0 at x = l",
        verdict: "printed, as is phi(xi1) = 0 below (12); but A follows from phi'(xi1) = 0, which \
                  symmetry requires; consistent: u_x = 0",
        place: "unit `loom_shaft`, a free end",
        held: SHAPES,
    },
    Statement {
        at: "(6), (7)",
        figure: "dimensionless equations",
        verdict: "consistent with L = G Jp/C0, T = L sqrt(rho/G), alpha = Ir/(T^2 C0): the same \
                  machine as in SI; the printed scales are not dimensionally consistent, numbers \
                  below",
        place: "`reed_beat_up` with parameters of 1, beta, alpha, b2",
        held: SCALED,
    },
    Statement {
        at: "(8)",
        figure: "initial state at rest, scaled",
        verdict: "same in both readings",
        place: "`reed_beat_up`",
        held: SCALED,
    },
    Statement {
        at: "(11), (12)",
        figure: "separation of variables",
        verdict: "same in both readings for a reed held still; a moving reed is a \
                  frequency-dependent support",
        place: "`closed_form::reed`",
        held: SHAPES,
    },
    Statement {
        at: "(13), (14)",
        figure: "mode shapes on both sides of the reed",
        verdict: "same in both readings; the study's A once has B instead of beta",
        place: "`closed_form::reed`",
        held: Held::Test("mode_shapes_are_orthogonal"),
    },
    Statement {
        at: "after (15)",
        figure: "orthogonality of the shapes",
        verdict: "printed: from 0 to 1, the norm from 0 to xi1; consistent: to xi1, with alpha \
                  ur_i ur_k for a moving reed; the norm is a square, and xi in v_i is a \
                  differential",
        place: "`closed_form::reed`",
        held: Held::Test("mode_shapes_are_orthogonal"),
    },
    Statement {
        at: "(16)",
        figure: "equations of the modal amplitudes",
        verdict: "printed: lambda_i instead of lambda_i^2, and the reed's acceleration instead of \
                  the drive's",
        place: "`closed_form::reed`, `ReedTransient`",
        held: Held::Verify("reed_beat_up: angles from rest over 4 ms, 24 elements of order 4"),
    },
    Statement {
        at: "(17)",
        figure: "equation of the reed",
        verdict: "printed: phi_i(xi1) instead of phi_i(xi0), -u0 instead of +u0, and no C2",
        place: "`reed_beat_up`; `closed_form::reed`",
        held: Held::Verify("reed_beat_up: angles from rest over 4 ms, 24 elements of order 4"),
    },
    Statement {
        at: "results",
        figure: "method of truncation",
        verdict: "consistent: an option sets the number of eigenmodes",
        place: "`machinist run --modes`",
        held: Held::Verify(
            "reed_beat_up: angles by 57 of 66 modes against 8 elements of order 8, over 3 ms",
        ),
    },
    Statement {
        at: "figure 2",
        figure: "angles of reed and shaft for C2 = 0.5 C1 and C1",
        verdict: "plotted for a fell that only pushes and for one that also pulls; numbers below",
        place: "the report's studies page; `reed_beat_up_one_sided`, `reed_beat_up`",
        held: CELLS,
    },
    Statement {
        at: "figure 3",
        figure: "stress on both sides of the reed, torque over section modulus",
        verdict: "plotted likewise; the section modulus is Jp/R",
        place: "outputs `stress_before`, `stress_after`",
        held: STRESSES,
    },
];

const fn number(
    figure: &'static str,
    unit: &'static str,
    printed: f64,
    name: &'static str,
    place: &'static str,
) -> Parameter {
    Parameter { at: "results", figure, unit, printed, name, place, held: STEADY }
}

const PARAMETERS: &[Parameter] = &[
    number("position of the reed l0", "m", 1.0, "shaft.reed_position", "unit `loom_shaft`"),
    number("half of the shaft's length l1", "m", 1.75, "shaft.length", "unit `loom_shaft`"),
    number(
        "stiffness of the drive C0",
        "N m/rad",
        45_200.0,
        "drive.stiffness",
        "unit `imposed_drive`",
    ),
    number("stiffness of the reed C1", "N m/rad", 15_600.0, "reed.stiffness", "unit `reed`"),
    number("radius of the shaft R", "m", 0.025, "shaft.radius", "unit `loom_shaft`"),
    number("density rho", "kg/m^3", 7659.0, "shaft.density", "unit `loom_shaft`"),
    number("mass of the reed M", "kg", 3.56, "reed.mass", "unit `reed`"),
    number("arm of that mass, R in (2)", "m", 0.025, "reed.arm", "unit `reed`"),
];

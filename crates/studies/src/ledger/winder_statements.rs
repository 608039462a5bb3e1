//! The winder's equations, figures and ranges.

use super::{Held, LedgerRow, Statement, Study, digits};
use crate::closed_form::winding_pair::DESIGN_SHARE;
use crate::verify::CheckFailure;
use crate::verify::machine::winder_full;
use crate::winder_walk::{layer, spectrum};

const HOLDER: Held =
    Held::Verify("winder_linkage: forces at contact and stop, winding force -8, 0 and 8 N");
const LAWS: Held = Held::Verify(
    "winder_holder_drop: forces at contact and stop once it has settled, P = N f and N k/R either way",
);
const SPEEDING: Held = Held::Verify(
    "winder_full: drum that speeds up and brakes, packages of 30 to 60 mm, to a millionth",
);
const LEAST: Held =
    Held::Verify("winder_full: least pressure that turns packages of 25 to 60 mm, to a millionth");
const GROWTH: Held = Held::Verify(
    "winder_full: radius and speed of the package from empty to full, thread as thick as a rope",
);
const ELASTIC: Held = Held::Verify(
    "winder_full: elastic slip at constant pressure, of packages of 30 to 60 mm, to its limit and \
     beyond",
);
const CONDITIONS: Held = Held::Test("each_condition_fails_where_it_does_by_hand");
const BAND: Held = Held::Test("the_band_of_the_closed_form_is_where_the_map_is_stable");

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows: Vec<LedgerRow> = STATEMENTS.iter().map(|told| told.row(Study::Winder)).collect();
    rows.extend(ranges()?);
    rows.push(tenth()?);
    rows.extend(stated()?);
    for (figure, printed, ours, test) in [
        ("factor to resonances that is enough for stage 1", 2.0, spectrum::ENOUGH, SLOW),
        ("factor to resonances that is enough for stage 2", 1.4, layer::ENOUGH, FASTER),
    ] {
        rows.push(LedgerRow {
            figure,
            unit: "1",
            printed: Some(printed),
            as_printed: Some(printed),
            consistent: Some(ours),
            verdict: "as printed; every operating frequency must keep it while the package grows"
                .to_owned(),
            ..LedgerRow::of(Study::Winder, "stages", "`machinist studies walk`", Held::Test(test))
        });
    }
    Ok(rows)
}

const SLOW: &str = "a_slow_winder_needs_no_more_than_the_linear_model";
const FASTER: &str = "a_faster_winder_needs_the_stiffening_layer";

/// Returns the ranges of friction, with our values within them.
fn ranges() -> Result<Vec<LedgerRow>, CheckFailure> {
    let machine = winder_full();
    let row = |figure, unit, [low, high]: [f64; 2], name| -> Result<LedgerRow, CheckFailure> {
        let ours = machine.value(name)?;
        let side = if (low..=high).contains(&ours) { "within" } else { "outside of" };
        Ok(LedgerRow {
            figure,
            unit,
            consistent: Some(ours),
            verdict: if high.is_finite() {
                format!("ours, {side} the printed range {} to {}", digits(low), digits(high))
            } else {
                format!("ours, {side} the printed range from {} up", digits(low))
            },
            ..LedgerRow::of(Study::Winder, "before (7)", "unit `winding_pair`", LEAST)
        })
    };
    Ok(vec![
        row("friction f between drum and package", "1", [0.15, 0.22], "pair.friction")?,
        row("arm k of rolling friction", "m", [2e-4, 1e-3], "pair.rolling_arm")?,
        row("friction of the support, fA r", "m", [2e-4, 6e-4], "pair.support_arm")?,
        row("least radius of a cartridge", "m", [0.02, f64::INFINITY], "pair.bobbin_radius")?,
    ])
}

/// Returns (fA r + k)/R over f, which the study neglects.
fn tenth() -> Result<LedgerRow, CheckFailure> {
    let machine = winder_full();
    let arms = machine.value("pair.support_arm")? + machine.value("pair.rolling_arm")?;
    let share = arms / machine.value("pair.bobbin_radius")? / machine.value("pair.friction")?;
    let [least, most] = [4e-4 / 0.02 / 0.22, 1.6e-3 / 0.02 / 0.15].map(|part: f64| 100.0 * part);
    Ok(LedgerRow {
        figure: "largest share of f used by support and rolling friction",
        unit: "1",
        printed: Some(1.0 - DESIGN_SHARE),
        as_printed: Some(1.6e-3 / 0.02 / 0.15),
        consistent: Some(share),
        verdict: format!(
            "by the study's own ranges {} to {} % at R = 20 mm, so (8) can allow more tension \
             than (7); the map tests both",
            digits((10.0 * least).round() / 10.0),
            digits((10.0 * most).round() / 10.0)
        ),
        ..LedgerRow::of(Study::Winder, "(7), (8)", "`winder_walk::map`", CONDITIONS)
    })
}

/// Returns the other numbers that the study states about the winding pair.
fn stated() -> Result<Vec<LedgerRow>, CheckFailure> {
    let tension = winder_full().value("pair.tension")?;
    let of = |at, figure, unit, printed: f64, as_printed, verdict, place, held| LedgerRow {
        figure,
        unit,
        printed: Some(printed),
        as_printed,
        verdict,
        ..LedgerRow::of(Study::Winder, at, place, held)
    };
    let arms = "the ends of both ranges give the printed range of fA r, 0.2 to 0.6 mm".to_owned();
    let arm = |figure, friction: f64, radius: f64| {
        let place = "unit `winding_pair`";
        of("before (7)", figure, "m", 6e-4, Some(friction * radius), arms.clone(), place, LEAST)
    };
    let slip = of(
        "after (3)",
        "greatest elastic slip nu",
        "1",
        0.04,
        Some(0.04),
        "as printed; a package lags behind where its resistance exceeds f N".to_owned(),
        "`machinist studies walk --slip 0.04`; `winder_full`, `pair.greatest_slip`",
        ELASTIC,
    );
    Ok(vec![
        LedgerRow { consistent: Some(0.04), ..slip },
        of(
            "before (7)",
            "greatest tension over the breaking load of the thread",
            "1",
            0.4,
            None,
            format!(
                "not reproduced: the study gives no breaking load; a tension of {} N is ours",
                digits(tension)
            ),
            "unit `winding_pair`",
            LEAST,
        ),
        arm("greatest fA r of trunnions, fA = 0.1 to 0.15, r = 2 to 4 mm", 0.15, 4e-3),
        arm("greatest fA r of rolling bearings, fA = 0.02 to 0.03, r = 10 to 20 mm", 0.03, 0.02),
    ])
}

const STATEMENTS: &[Statement] = &[
    Statement {
        at: "(1), (2)",
        figure: "equilibrium of forces and moments",
        verdict: "same in both readings",
        place: "equilibrium of every scene; `winder_linkage`",
        held: HOLDER,
    },
    Statement {
        at: "figure 1",
        figure: "friction winding pair, layer b = R - Rmin",
        verdict: "same in both readings; R is a state that grows with every turn",
        place: "`winder_full`, unit `winding_pair`",
        held: GROWTH,
    },
    Statement {
        at: "(3)",
        figure: "speed of the package, w0 (R0/R) (1 - nu)",
        verdict: "same in both readings; the study gives no law for the elastic slip nu; ours is \
                  proportional to the share of f N in use, in stage 3 with `--slip` and in \
                  `winder_elastic_slip`; without it a package sticks or slides",
        place: "`machinist studies walk --slip`; `winder_full`, `drives/winder_elastic_slip`, \
                outputs `slip`",
        held: GROWTH,
    },
    Statement {
        at: "(4), (5), (6)",
        figure: "adhesion while the drum accelerates and brakes",
        verdict: "same in both readings; the magnitude of Pn R + MA + Mk + JA e replaces the two \
                  signs of (6); the list of symbols has Jk instead of JA",
        place: "`winder_full`, parameter `acceleration`; `closed_form::winding_pair`",
        held: SPEEDING,
    },
    Statement {
        at: "before (7)",
        figure: "P = N f, Mk = N k, MA = N fA r",
        verdict: "laws, not parameters, in both readings; one product is printed as N:f",
        place: "unit `winding_pair`",
        held: LEAST,
    },
    Statement {
        at: "before (7)",
        figure: "deliberate slip against rope winding",
        verdict: "accelerations beyond (6) trigger an event: the package slips",
        place: "`winder_full`, parameter `acceleration`",
        held: SPEEDING,
    },
    Statement {
        at: "(7)",
        figure: "tension that a pressure sustains at constant speed",
        verdict: "same in both readings",
        place: "`winder_full`; `closed_form::winding_pair`",
        held: LEAST,
    },
    Statement {
        at: "(8)",
        figure: "rule of practice, Pn <= 0.9 N f",
        verdict: "same in both readings; the share of one tenth is examined below",
        place: "`winder_walk::map`",
        held: Held::Test("a_large_package_is_held_by_the_rule_of_practice"),
    },
    Statement {
        at: "figures 2, 3, 4",
        figure: "holder at work, filling, and at work in an unstable position",
        verdict: "consistent; the study gives no dimensions, so all are ours",
        place: "`winder_linkage`, `winder_holder_drop`, `drives/winder_turning_drum`",
        held: Held::Verify(
            "winder_linkage: places of post, plate, cylinder, rod and bobbin along the run",
        ),
    },
    Statement {
        at: "(9)",
        figure: "mobility of the mechanism",
        verdict: "printed with minus signs instead of multiplications; two equations have the \
                  number (9)",
        place: "`closed_form::winding_pair`",
        held: Held::Verify(
            "winder_linkage: mobility of five positions, by rank and by Gruebler's count",
        ),
    },
    Statement {
        at: "section 3",
        figure: "vibration can move the mechanism out of its working position",
        verdict: "consistent: with the disturbances at 5.5 m/s the bobbin leaves the drum; \
                  without them it stays",
        place: "`winder_full`",
        held: Held::Verify("winder_full: losses of contact and touches in that time"),
    },
    Statement {
        at: "section 3",
        figure: "irregular shape or mounting of the bobbin as a disturbance",
        verdict: "consistent: a force once per package turn, besides the drum's once and twice \
                  per turn",
        place: "parameter `package_force` of the scenes; `machinist studies walk --package`",
        held: Held::Test("an_irregular_package_shakes_every_stage_once_a_turn_of_its_own"),
    },
    Statement {
        at: "section 3",
        figure: "a turning drum pulls the mechanism into its stable position",
        verdict: "consistent: the drum drags the bobbin by friction, which acts at the axle of a \
                  bobbin that turns; to the left, as printed, it pulls a post that lifts off on a \
                  drum at rest onto its stop, to the right it lifts a post off (numbers below)",
        place: "`drives/winder_turning_drum`, parameters `lift`, `direction`",
        held: Held::Test("a_drum_that_begins_to_turn_pulls_the_post_onto_its_stop"),
    },
    Statement {
        at: "(9), (10)",
        figure: "moments about O at rest and at work",
        verdict: "printed with several signs at once; consistent: the positions of the forces \
                  determine the signs; the rack's weight is Gc in the equations and Go in the list",
        place: "`closed_form::bobbin_holder`",
        held: HOLDER,
    },
    Statement {
        at: "after (10)",
        figure: "P = N k/R at rest, P = N f at work",
        verdict: "laws in both readings",
        place: "`winder_holder_drop`, parameter `grip`",
        held: LAWS,
    },
    Statement {
        at: "(11), (12)",
        figure: "reaction Q of the stop, MO of weights and spring",
        verdict: "(11) divides the moments of N and P twice by hO, the arm of Q; (13), (14) \
                  divide once, which is consistent; numbers below",
        place: "`closed_form::bobbin_holder`",
        held: LAWS,
    },
    Statement {
        at: "figures 5, 6",
        figure: "simple mechanisms, bobbin above and below the drum",
        verdict: "consistent; one lever about C; only the sign of the weights differs",
        place: "`closed_form::winding_pair`; units `bobbin_holder`, `pressed_bobbin`",
        held: Held::Test(
            "pressure_over_the_growth_of_a_package_is_the_balance_of_moments_about_the_lever",
        ),
    },
    Statement {
        at: "(15)",
        figure: "pressure N from the spring, the thread and the weights",
        verdict: "the arm of F is printed hp, that of P; N grows with R as the package lifts the \
                  lever, numbers below; `studies walk` keeps N constant without `--growth`",
        place: "`winder_linear`, `winder_nonlinear`, output `contact_force`; `winder_full`, \
                `winder_linkage`; `machinist studies walk --growth`",
        held: Held::Verify(
            "winder_linkage: forces at contact and stop while the package grows from 30 to 60 mm",
        ),
    },
    Statement {
        at: "(16)",
        figure: "weight reduced to the bobbin's axis; the mass is taken from it",
        verdict: "a reduced weight is linear in lbc/lab; a mass that preserves the kinetic energy \
                  is quadratic; numbers below",
        place: "units `bobbin_holder`, `bobbin_holder_as_printed`",
        held: Held::Test("the_mass_by_weights_is_not_the_mass_by_kinetic_energy"),
    },
    Statement {
        at: "(17)",
        figure: "no equation",
        verdict: "the study prints no equation with this number",
        place: "nowhere",
        held: Held::Test("every_row_is_whole_and_is_held_by_what_there_is"),
    },
    Statement {
        at: "figure 7, (18)",
        figure: "one mass on layer and spring under F(t) and Y(t)",
        verdict: "printed: the layer's viscosity acts on q' alone; consistent: on q' - Y', since \
                  the layer lies between bobbin and drum",
        place: "`winder_linear`; printed `winder_linear_as_printed`",
        held: Held::Verify(
            "winder_linear_as_printed: transient under force and drum shape, as printed",
        ),
    },
    Statement {
        at: "(19)",
        figure: "motion as a sum of harmonics",
        verdict: "same in both readings for the steady part; the motion also has transients",
        place: "`closed_form::winder`",
        held: Held::Verify("winder_linear: transient under force and drum shape"),
    },
    Statement {
        at: "after (21)",
        figure: "largest amplitude as the sum of all amplitudes",
        verdict: "same in both readings; some phases attain this bound",
        place: "`closed_form::winder`",
        held: Held::Test("no_phases_exceed_the_sum_of_amplitudes_and_some_reach_it"),
    },
    Statement {
        at: "(23), (24)",
        figure: "conditions of tension with N - dN",
        verdict: "same in both readings",
        place: "`winder_walk::map`",
        held: CONDITIONS,
    },
    Statement {
        at: "(25)",
        figure: "shift of the equilibrium, factor 1 + delta",
        verdict: "the study says that delta grows with load and speed, without numbers; here 10 \
                  %, ours",
        place: "`winder_walk::map`",
        held: Held::Test("vibration_narrows_the_band_from_both_sides"),
    },
    Statement {
        at: "(26), figure 8",
        figure: "window [Nmin] + dN <= N <= [Nmax] - dN over R",
        verdict: "same in both readings; plotted for the bench winder on the report's studies page",
        place: "`winder_walk::map`; `studies::conclusions`",
        held: BAND,
    },
    Statement {
        at: "stages",
        figure: "third stage: all nonlinearities",
        verdict: "consistent: loss of contact, stick-slip friction, growth of the package",
        place: "`winder_full`",
        held: Held::Test("the_bench_speed_needs_the_full_model_which_finds_contact_lost"),
    },
    Statement {
        at: "section 5",
        figure: "conclusion: keep clear of resonances, never lose contact",
        verdict: "consistent: the report's studies page gives the speed and pressures that \
                  satisfy it",
        place: "`studies::conclusions`; `machinist studies walk`",
        held: Held::Test(
            "where_the_map_is_stable_the_full_model_neither_leaves_the_drum_nor_slips",
        ),
    },
];

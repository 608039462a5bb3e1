//! The winder's equations, figures and ranges.

use super::{Held, LedgerRow, Study, Told, digits};
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
const CONDITIONS: Held = Held::Test("each_condition_fails_where_it_does_by_hand");
const BAND: Held = Held::Test("the_band_of_the_closed_form_is_where_the_map_is_stable");

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows: Vec<LedgerRow> = TOLD.iter().map(|told| told.row(Study::Winder)).collect();
    rows.extend(ranges()?);
    rows.push(tenth()?);
    for (figure, printed, ours, test) in [
        ("factor to resonances that ends stage 1", 2.0, spectrum::ENOUGH, SLOW),
        ("factor to resonances that ends stage 2", 1.4, layer::ENOUGH, FASTER),
    ] {
        rows.push(LedgerRow {
            figure,
            unit: "1",
            printed: Some(printed),
            as_printed: Some(printed),
            consistent: Some(ours),
            verdict: "as printed; what it means of a range of frequencies is that every operating \
                      frequency keeps it while the package grows"
                .to_owned(),
            ..LedgerRow::of(Study::Winder, "stages", "`machinist walk`", Held::Test(test))
        });
    }
    Ok(rows)
}

const SLOW: &str = "a_slow_winder_needs_no_more_than_the_linear_model";
const FASTER: &str = "a_faster_winder_needs_the_stiffening_layer";

/// Ranges of friction, and ours within them.
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
        row("friction f of drum and package", "1", [0.15, 0.22], "pair.friction")?,
        row("arm k of rolling friction", "m", [2e-4, 1e-3], "pair.rolling_arm")?,
        row("friction of the support, fA r", "m", [2e-4, 6e-4], "pair.support_arm")?,
        row("least radius of a cartridge", "m", [0.02, f64::INFINITY], "pair.bobbin_radius")?,
    ])
}

/// (fA r + k)/R over f, which the study neglects.
fn tenth() -> Result<LedgerRow, CheckFailure> {
    let machine = winder_full();
    let arms = machine.value("pair.support_arm")? + machine.value("pair.rolling_arm")?;
    let share = arms / machine.value("pair.bobbin_radius")? / machine.value("pair.friction")?;
    let [least, most] = [4e-4 / 0.02 / 0.22, 1.6e-3 / 0.02 / 0.15].map(|part: f64| 100.0 * part);
    Ok(LedgerRow {
        figure: "largest share of f that support and rolling take",
        unit: "1",
        printed: Some(1.0 - DESIGN_SHARE),
        as_printed: Some(1.6e-3 / 0.02 / 0.15),
        consistent: Some(share),
        verdict: format!(
            "by the study's own ranges {} to {} % at R = 20 mm, so that (8) may promise more than (7) \
             holds; the map asks both",
            digits((10.0 * least).round() / 10.0),
            digits((10.0 * most).round() / 10.0)
        ),
        ..LedgerRow::of(Study::Winder, "(7), (8)", "`winder_walk::map`", CONDITIONS)
    })
}

const TOLD: &[Told] = &[
    Told {
        at: "(1), (2)",
        figure: "equilibrium of forces and moments",
        verdict: "printed and consistent alike",
        place: "equilibrium of every scene; `winder_linkage`",
        held: HOLDER,
    },
    Told {
        at: "figure 1",
        figure: "friction winding pair, layer b = R - Rmin",
        verdict: "printed and consistent alike; R is a state that every turn winds",
        place: "`winder_full`, unit `winding_pair`",
        held: GROWTH,
    },
    Told {
        at: "(3)",
        figure: "speed of the package, w0 (R0/R) (1 - nu)",
        verdict: "printed and consistent alike; elastic slip nu up to 0.04 is no law of the study: a \
                  package of stage 3 sticks, nu = 0, or slides",
        place: "`winder_full`, output `slip`; `closed_form::winding_pair`",
        held: GROWTH,
    },
    Told {
        at: "(4), (5), (6)",
        figure: "adhesion while the drum speeds up and brakes",
        verdict: "printed and consistent alike, by the size of Pn R + MA + Mk + JA e, \
                  for which (6) has two signs",
        place: "`winder_full`, parameter `acceleration`; `closed_form::winding_pair`",
        held: SPEEDING,
    },
    Told {
        at: "before (7)",
        figure: "P = N f, Mk = N k, MA = N fA r",
        verdict: "laws, not parameters, in both readings; one sign is printed as N:f",
        place: "unit `winding_pair`",
        held: LEAST,
    },
    Told {
        at: "before (7)",
        figure: "slipping on purpose, against rope winding",
        verdict: "accelerations beyond (6): the package slips, by events",
        place: "`winder_full`, parameter `acceleration`",
        held: SPEEDING,
    },
    Told {
        at: "(7)",
        figure: "tension that a pressure holds at steady speed",
        verdict: "printed and consistent alike",
        place: "`winder_full`; `closed_form::winding_pair`",
        held: LEAST,
    },
    Told {
        at: "(8)",
        figure: "rule of practice, Pn <= 0.9 N f",
        verdict: "printed and consistent alike; see the tenth below",
        place: "`winder_walk::map`",
        held: Held::Test("a_large_package_is_held_by_the_rule_of_practice"),
    },
    Told {
        at: "figures 2, 3, 4",
        figure: "holder at work, filling, and at work unstably",
        verdict: "consistent; the study gives no dimensions, all are ours",
        place: "`winder_linkage`, `winder_holder_drop`",
        held: Held::Verify(
            "winder_linkage: places of post, plate, cylinder, rod and bobbin along the run",
        ),
    },
    Told {
        at: "(9)",
        figure: "mobility of the mechanism",
        verdict: "printed with minus signs for multiplications; the number (9) stands twice",
        place: "`closed_form::winding_pair`",
        held: Held::Verify(
            "winder_linkage: mobility of five positions, by rank and by Gruebler's count",
        ),
    },
    Told {
        at: "section 3",
        figure: "vibration may take the mechanism out of its working position",
        verdict: "consistent: with disturbances of 5.5 m/s the bobbin leaves the drum; without it stays",
        place: "`winder_full`",
        held: Held::Verify("winder_full: losses of contact and touches in that time"),
    },
    Told {
        at: "section 3",
        figure: "irregular shape or fitting of the bobbin, a disturbance",
        verdict: "consistent: a force once a turn of the package, beside the drum's once and twice a turn",
        place: "parameter `package_force` of the scenes; `machinist walk --package`",
        held: Held::Test("an_irregular_package_shakes_every_stage_once_a_turn_of_its_own"),
    },
    Told {
        at: "section 3",
        figure: "a turning drum pulls the mechanism into its stable position",
        verdict: "consistent: between the unstable positions of a drum at rest and of one that drags \
                  the bobbin, numbers below, the post lifts away at rest and falls onto its stop under \
                  the turning drum; which way drags it there depends on the dimensions",
        place: "`winder_holder_drop`, parameters `lift`, `plate_angle`, `grip`",
        held: Held::Verify(
            "winder_holder_drop: where the post goes from 0.02 rad below and above its unstable position",
        ),
    },
    Told {
        at: "(9), (10)",
        figure: "moments about O at rest and at work",
        verdict: "printed with several signs at once; consistent signs follow from the places of the \
                  forces; weight of the rack is named Gc in them and Go in the list",
        place: "`closed_form::bobbin_holder`",
        held: HOLDER,
    },
    Told {
        at: "after (10)",
        figure: "P = N k/R at rest, P = N f at work",
        verdict: "laws in both readings",
        place: "`winder_holder_drop`, parameter `grip`",
        held: LAWS,
    },
    Told {
        at: "(11), (12)",
        figure: "reaction Q of the stop, MO of weights and spring",
        verdict: "(11) divides the moments of N and P by the arm of Q, called hO, twice; (13), (14) do \
                  so once, which is consistent; numbers below",
        place: "`closed_form::bobbin_holder`",
        held: LAWS,
    },
    Told {
        at: "figures 5, 6",
        figure: "simple mechanisms, bobbin above and below the drum",
        verdict: "consistent; one lever about C, the sign of the weights apart",
        place: "`closed_form::winding_pair`; units `bobbin_holder`, `pressed_bobbin`",
        held: Held::Test(
            "pressure_over_the_growth_of_a_package_is_the_balance_of_moments_about_the_lever",
        ),
    },
    Told {
        at: "(15)",
        figure: "pressure N from the spring, the thread and the weights",
        verdict: "printed and consistent alike: N grows with R as the package lifts the lever, numbers \
                  below; `walk` holds it unless told its growth",
        place: "`closed_form::winding_pair`; `machinist walk --growth`; `winder_linkage`",
        held: Held::Verify(
            "winder_linkage: forces at contact and stop while the package grows from 30 to 60 mm",
        ),
    },
    Told {
        at: "(16)",
        figure: "weight reduced to the bobbin's axis; the mass is taken from it",
        verdict: "weights are linear in lbc/lab; a kinetic energy takes the square; numbers below",
        place: "units `bobbin_holder`, `bobbin_holder_as_printed`",
        held: Held::Test("the_mass_by_weights_is_not_the_mass_by_kinetic_energy"),
    },
    Told {
        at: "(17)",
        figure: "no equation",
        verdict: "the study prints no equation of this number",
        place: "nowhere",
        held: Held::Test("every_row_is_whole_and_is_held_by_what_there_is"),
    },
    Told {
        at: "figure 7, (18)",
        figure: "one mass on layer and spring under F(t) and Y(t)",
        verdict: "printed: the layer's viscosity acts on q' alone; consistent: on q' - Y', for the layer \
                  lies between both",
        place: "`winder_linear`; printed `winder_linear_as_printed`",
        held: Held::Verify(
            "winder_linear_as_printed: transient under force and drum shape, as printed",
        ),
    },
    Told {
        at: "(19)",
        figure: "motion as a sum of harmonics",
        verdict: "printed and consistent alike for the steady part; transients beside it",
        place: "`closed_form::winder`",
        held: Held::Verify("winder_linear: transient under force and drum shape"),
    },
    Told {
        at: "after (21)",
        figure: "largest amplitude as the plain sum of all",
        verdict: "printed and consistent alike: a bound that some phases reach",
        place: "`closed_form::winder`",
        held: Held::Test("no_phases_exceed_the_sum_of_amplitudes_and_some_reach_it"),
    },
    Told {
        at: "(23), (24)",
        figure: "conditions of tension with N - dN",
        verdict: "printed and consistent alike",
        place: "`winder_walk::map`",
        held: CONDITIONS,
    },
    Told {
        at: "(25)",
        figure: "shift of the equilibrium, factor 1 + delta",
        verdict: "delta is said to grow with load and speed, without numbers; here a share of 10 %, ours",
        place: "`winder_walk::map`",
        held: Held::Test("vibration_narrows_the_band_from_both_sides"),
    },
    Told {
        at: "(26), figure 8",
        figure: "window [Nmin] + dN <= N <= [Nmax] - dN over R",
        verdict: "printed and consistent alike; drawn for the bench winder on the report's page of studies",
        place: "`winder_walk::map`; `studies::conclusions`",
        held: BAND,
    },
    Told {
        at: "stages",
        figure: "third stage: all nonlinearities",
        verdict: "consistent: loss of contact, friction that sticks and slips, growth of the package",
        place: "`winder_full`",
        held: Held::Test("the_bench_speed_needs_the_full_model_which_finds_contact_lost"),
    },
    Told {
        at: "section 5",
        figure: "conclusion: keep clear of resonances, never lose contact",
        verdict: "consistent: on the report's page of studies, with the speed and pressures that do",
        place: "`studies::conclusions`; `machinist walk`",
        held: Held::Test(
            "where_the_map_is_stable_the_full_model_neither_leaves_the_drum_nor_slips",
        ),
    },
];

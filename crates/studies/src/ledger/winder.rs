//! Numbers of the winder study: mobility of its holder, reactions, pressures, masses, amplitudes.
//! The study gives only the mobilities; where a number needs parameters, they are ours.

use super::{Held, LedgerRow, Study, compare, digits_of, reproduced};
use crate::closed_form::bobbin_holder::{BobbinHolder, HOLDER};
use crate::closed_form::winder::{BENCH_BOBBIN, BENCH_FORCE, BENCH_MASS, BENCH_SHAPE};
use crate::closed_form::winding_pair::{HOLDER_POSITIONS, pressure_over_growth};
use crate::verify::CheckFailure;
use crate::verify::machine::{winder_full, winder_linear, winder_linear_as_printed};
use crate::verify::winder_linear::{PRINTED_MOBILITY, natural_frequency};

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows: Vec<LedgerRow> = mobility().collect();
    rows.extend(reactions()?);
    rows.extend(pressures()?);
    rows.extend(masses()?);
    rows.extend(amplitudes());
    rows.extend(phases());
    rows.push(variation());
    Ok(rows)
}

fn of(at: &'static str, place: &'static str, held: Held) -> LedgerRow {
    LedgerRow::of(Study::Winder, at, place, held)
}

/// Returns (13) and (14) with P = N f, and at rest with P = N k/R, then the same forces on a bobbin
/// that turns freely, and the unstable positions of both.
fn reactions() -> Result<Vec<LedgerRow>, CheckFailure> {
    let machine = winder_full();
    let friction = machine.value("pair.friction")?;
    let rolling = machine.value("pair.rolling_arm")? / HOLDER.radii[0];
    let slipping = Slipping {
        friction,
        tension: machine.value("pair.tension")?,
        support_arm: machine.value("pair.support_arm")?,
    };
    let at_rest = "lift of the post in the unstable position, drum at rest";
    Ok(vec![
        reaction("(13)", "reaction Q of the stop, P = N f to the left", friction),
        reaction("(14)", "reaction Q of the stop, P = N f to the right", -friction),
        reaction("(9)", "reaction Q of the stop at rest, P = N k/R to the left", rolling),
        reaction("(9)", "reaction Q of the stop at rest, P = N k/R to the right", -rolling),
        slipping.reaction("(13)", "reaction Q while the bobbin slips, P = N f to the left", 1.0),
        slipping.reaction("(14)", "reaction Q while the bobbin slips, P = N f to the right", -1.0),
        lift(at_rest, HOLDER.unstable_lift(0.0), BALANCED),
        lift(
            "lift of the post in the unstable position, P = N f to the left",
            HOLDER.unstable_lift(friction),
            BALANCED,
        ),
        lift(
            "lift of the post in the unstable position, P = N f to the right",
            HOLDER.unstable_lift(-friction),
            BALANCED,
        ),
        slipping.lift("lift of the post while the bobbin slips, P = N f to the left", 1.0),
        slipping.lift("lift of the post while the bobbin slips, P = N f to the right", -1.0),
    ])
}

fn reaction(at: &'static str, figure: &'static str, share: f64) -> LedgerRow {
    let [pressure, reaction] = HOLDER.forces_by_share(share);
    LedgerRow {
        figure,
        unit: "N",
        consistent: Some(reaction),
        verdict: format!(
            "not printed; {}, with N = {} N and P = {} N at K as on a bobbin that is held; for \
             our holder Q is then larger with P to the right",
            if reaction > 0.0 { "Q > 0, a stable position" } else { "the post lifts" },
            digits_of(pressure, 4),
            digits_of(share * pressure, 3)
        ),
        ..of(
            at,
            "`winder_holder_drop`, parameter `grip`; `closed_form::bobbin_holder`",
            Held::Verify(
                "winder_holder_drop: forces at contact and stop once it has settled, P = N f and N k/R either way",
            ),
        )
    }
}

/// A bobbin on a drum that turns faster: friction and thread turn it, and act on the holder at its
/// axle.
struct Slipping {
    friction: f64,
    tension: f64,
    support_arm: f64,
}

impl Slipping {
    /// Returns Q with P to the left for 1, to the right for -1.
    fn reaction(&self, at: &'static str, figure: &'static str, direction: f64) -> LedgerRow {
        let [pressure, reaction] = HOLDER.forces_beside_turning_bobbin(
            -direction * self.tension,
            direction * self.friction,
            direction * self.support_arm,
        );
        LedgerRow {
            figure,
            unit: "N",
            consistent: Some(reaction),
            verdict: format!(
                "not printed; (13), (14) have P at K, but P turns a free bobbin and acts on the \
                 holder at A: with N = {} N, Q is larger with P to the left, as the study says",
                digits_of(pressure, 4)
            ),
            ..of(at, TURNING, Held::Test("forces_on_a_turning_bobbin_are_balances_of_moments"))
        }
    }

    fn lift(&self, figure: &'static str, direction: f64) -> LedgerRow {
        let lifted = HOLDER.unstable_lift_beside_turning_bobbin(
            -direction * self.tension,
            direction * self.friction,
            direction * self.support_arm,
        );
        LedgerRow {
            place: TURNING,
            held: Held::Test("a_drum_that_begins_to_turn_pulls_the_post_onto_its_stop"),
            ..lift(
                figure,
                lifted,
                "not printed; the bobbin turns freely, and P acts at its axle: to the left it \
                 pulls the post onto its stop",
            )
        }
    }
}

const TURNING: &str = "`drives/winder_turning_drum`; `closed_form::turning_drum`";
const BALANCED: &str = "not printed; below it the post falls onto its stop, above it the post lifts off; with P at K, \
     as on a bobbin that is held, P to the right raises it";

/// Returns figure 4: the position in which the post balances off its stop.
fn lift(figure: &'static str, lifted: f64, verdict: &str) -> LedgerRow {
    LedgerRow {
        figure,
        unit: "rad",
        consistent: Some(lifted),
        verdict: verdict.to_owned(),
        ..of(
            "figure 4",
            "`winder_holder_drop`; `closed_form::bobbin_holder`",
            Held::Verify(
                "winder_holder_drop: where the post goes from 0.02 rad below and above its unstable position",
            ),
        )
    }
}

/// Returns (15) over the growth of the package.
fn pressures() -> Result<Vec<LedgerRow>, CheckFailure> {
    let machine = winder_full();
    let rest = machine.value("holder.preload")?;
    let spring = machine.value("holder.stiffness")?;
    let holder = |radius| BobbinHolder { radii: [radius, HOLDER.radii[1]], ..HOLDER }.forces()[0];
    let row = |figure, ours: f64, words: &str, place, held| LedgerRow {
        figure,
        unit: "N",
        consistent: Some(ours),
        verdict: format!("not printed; {words}"),
        ..of("(15), figure 8", place, held)
    };
    let linkage = Held::Verify(
        "winder_linkage: forces at contact and stop while the package grows from 30 to 60 mm",
    );
    let full = Held::Verify("winder_full: pressure on the package from empty to full");
    let (place, words) = ("`winder_linkage`", "the strut's spring yields as the package grows");
    Ok(vec![
        row("pressure N of the four-link holder, R = 30 mm", holder(0.03), words, place, linkage),
        row("pressure N of the four-link holder, R = 60 mm", holder(0.06), words, place, linkage),
        row(
            "pressure N of the bench winder, R = 60 mm",
            pressure_over_growth(rest, spring, &BENCH_MASS, 0.06),
            &format!(
                "{} N with the empty bobbin; the package's growth fully deflects the spring of {} \
                 N/m; scenes take it by default, `holder.spring_share` sets less",
                digits_of(rest, 3),
                digits_of(spring, 4)
            ),
            "`closed_form::winding_pair`; `winder_full`, `winder_linear`, `winder_nonlinear`",
            full,
        ),
    ])
}

/// Returns the masses by (16), and the resulting resonances.
fn masses() -> Result<Vec<LedgerRow>, CheckFailure> {
    let held =
        Held::Verify("winder_linear_as_printed: reduced mass of a package of 50 mm, as printed");
    let why = "(16) reduces weights, linear in lbc/lab; a mass that preserves the kinetic energy \
               is quadratic";
    let row = |at, figure, unit, as_printed, consistent, held| LedgerRow {
        figure,
        unit,
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!("not printed; {why}; masses and arms are ours"),
        ..of(at, "`winder_linear`, `winder_linear_as_printed`", held)
    };
    let mass = |figure, radius| {
        row("(16)", figure, "kg", BENCH_MASS.as_printed(radius), BENCH_MASS.at(radius), held)
    };
    Ok(vec![
        mass("reduced mass of the bench winder, empty bobbin", 0.03),
        mass("reduced mass of the bench winder, R = 60 mm", 0.06),
        row(
            "(18)",
            "natural frequency of the bench winder, empty bobbin",
            "rad/s",
            natural_frequency(&winder_linear_as_printed())?,
            natural_frequency(&winder_linear())?,
            Held::Verify("winder_linear_as_printed: undamped natural frequency, as printed"),
        ),
    ])
}

/// Returns (20): the printed formula with the consistent mass, so that only its damping differs.
fn amplitudes() -> [LedgerRow; 2] {
    let layer = BENCH_BOBBIN.layer_stiffness;
    let row = |figure, as_printed: f64, consistent: f64, why, held| LedgerRow {
        figure,
        unit: "m",
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!(
            "not printed; the consistent value is {}: {why}",
            compare(as_printed, consistent)
        ),
        ..of("(20)", "`winder_linear`; `closed_form::winder`", held)
    };
    [
        row(
            "amplitude of the bench winder's bobbin under force",
            BENCH_BOBBIN.amplitude_as_printed(BENCH_FORCE.amplitude, BENCH_FORCE.frequency),
            BENCH_BOBBIN.answer_to_force(&BENCH_FORCE).amplitude,
            "the printed h^2 m^2 p^2 belongs to a damping term h m q', not to (18)",
            Held::Verify("winder_linear: amplitude of the steady answer to force"),
        ),
        row(
            "amplitude of the bench winder's bobbin under the drum's shape",
            BENCH_BOBBIN.amplitude_as_printed(layer * BENCH_SHAPE.amplitude, BENCH_SHAPE.frequency),
            BENCH_BOBBIN.answer_to_shape(&BENCH_SHAPE).amplitude,
            "in addition, the layer's viscosity transmits the rate of the shape",
            Held::Verify("winder_linear: amplitude of the steady answer to drum shape"),
        ),
    ]
}

/// Returns (21): the printed phase is added to that of the forcing, and so leads where the motion
/// lags.
fn phases() -> [LedgerRow; 2] {
    let row = |figure, as_printed: f64, consistent: f64, held| LedgerRow {
        figure,
        unit: "rad",
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict:
            "not printed; (21) has h m instead of h, an arctangent that loses the quadrant beyond \
             resonance, and a phase lead instead of a lag"
                .to_owned(),
        ..of("(21)", "`winder_linear`; `closed_form::winder`", held)
    };
    [
        row(
            "phase of the bench winder's bobbin under force",
            BENCH_BOBBIN.phase_as_printed(BENCH_FORCE.frequency),
            BENCH_BOBBIN.answer_to_force(&BENCH_FORCE).phase,
            Held::Verify("winder_linear: phase of the steady answer to force"),
        ),
        row(
            "phase of the bench winder's bobbin under the drum's shape",
            BENCH_BOBBIN.phase_as_printed(BENCH_SHAPE.frequency),
            BENCH_BOBBIN.answer_to_shape(&BENCH_SHAPE).phase,
            Held::Verify("winder_linear: phase of the steady answer to drum shape"),
        ),
    ]
}

/// Returns (22): with a shaken drum the pressure follows from the layer's compression, not from the
/// bobbin's own motion.
fn variation() -> LedgerRow {
    let by_bobbin = |harmonic: &crate::closed_form::winder::Harmonic, amplitude: f64| {
        amplitude * BENCH_BOBBIN.dynamic_layer_stiffness(harmonic.frequency)
    };
    let (force, shape) = (BENCH_FORCE, BENCH_SHAPE);
    let as_printed = by_bobbin(&force, BENCH_BOBBIN.answer_to_force(&force).amplitude)
        + by_bobbin(&shape, BENCH_BOBBIN.answer_to_shape(&shape).amplitude);
    let consistent = BENCH_BOBBIN.pressure_variation(&[force], &[shape]);
    LedgerRow {
        figure: "variation dN of the bench winder's pressure, delta = 0",
        unit: "N",
        as_printed: Some(as_printed),
        consistent: Some(consistent),
        verdict: format!(
            "not printed; the consistent B is the amplitude of the layer's compression; the \
             printed one, that of the bobbin, omits the drum's motion: {}",
            compare(as_printed, consistent)
        ),
        ..of(
            "(22)",
            "`winder_walk::map`; `closed_form::winder`",
            Held::Test("the_pressure_varies_as_evaluated_by_hand"),
        )
    }
}

/// Returns the mobilities. The printed formula has a minus where 2 p5 is meant, and so gives no
/// number.
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
                    "{} by 3 n - 2 p5 - p4 with n = {}, p5 = {}, p4 = {}; the printed formula has \
                     minus signs instead of multiplications",
                    reproduced(printed, ours, 0.0),
                    position.links,
                    position.lower_pairs,
                    position.higher_pairs
                ),
                ..of(
                    "table, (9)",
                    "`closed_form::winding_pair`; `winder_linkage`",
                    Held::Verify("winder_linkage: mobility of five positions, by rank and by Gruebler's count"),
                )
            }
        },
    )
}

/// Titles in the order of [`HOLDER_POSITIONS`].
const MOBILITY_FIGURES: [&str; 5] = [
    "mobility of the bobbin holder, working, stable",
    "mobility of the bobbin holder, not winding, from working",
    "mobility of the bobbin holder, filling",
    "mobility of the bobbin holder, working, unstable",
    "mobility of the bobbin holder, not winding, from unstable",
];

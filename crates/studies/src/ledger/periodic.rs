//! Periodic motions of the studies' machines and their stability, by Floquet multipliers.

use machinist::periodic::{BranchSettings, Cycle, CycleSettings, Period, branch, cycle};
use machinist::{Method, Simulation};
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::winder_linear::WinderLinear;

use super::{Held, LedgerRow, Study, digits_of};
use crate::verify::CheckFailure;

/// Relative tolerance of the runs: multipliers then have about eight digits.
const RTOL: f64 = 1e-10;

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    Ok(vec![gin_under_load()?, winder_over_growth()?])
}

/// Returns the largest modulus of the multipliers.
fn modulus(cycle: &Cycle) -> f64 {
    cycle.nontrivial().map(|multiplier| multiplier.modulus).fold(0.0, f64::max)
}

fn settings(period: f64, settle: f64) -> CycleSettings {
    CycleSettings { period: Period::Given(period), settle, points: 101, ..CycleSettings::default() }
}

/// The gin after its run-up, under the load of 735 rpm.
fn gin_under_load() -> Result<LedgerRow, CheckFailure> {
    let run = Simulation::new(&SawGin).rtol(RTOL).method(Method::Dop853);
    let period = 60.0 / 735.0;
    let found = cycle(&run, &settings(period, 2.0))?;
    let largest = modulus(&found);
    Ok(LedgerRow {
        figure: "largest Floquet multiplier of the gin under load",
        unit: "1",
        consistent: Some(largest),
        verdict: format!(
            "not printed; stable: in a period of the load, {} s, disturbances of the motion decay \
             to {} %",
            digits_of(period, 3),
            digits_of(100.0 * largest, 3)
        ),
        ..LedgerRow::of(
            Study::SawGin,
            "section 5",
            "`saw_gin`; `machinist cycle`",
            Held::Test("the_gin_under_load_is_as_stable_as_its_linearization"),
        )
    })
}

/// The bench winder while its package grows.
fn winder_over_growth() -> Result<LedgerRow, CheckFailure> {
    let run = Simulation::new(&WinderLinear).rtol(RTOL).method(Method::Dop853);
    let speed = |name: &str| -> Result<f64, CheckFailure> {
        let names = run.parameter_values().iter().enumerate();
        let mut all = names.map(|(at, value)| (run.simulator().parameter(at).name, *value));
        let found = all.find(|(known, _)| *known == name);
        found.map(|(_, value)| value).ok_or_else(|| CheckFailure::Unknown {
            scene: "winder_linear",
            kind: "parameter",
            name: name.to_owned(),
        })
    };
    let period = std::f64::consts::TAU * speed("drum_radius")? / speed("winding_speed")?;
    let settings = BranchSettings {
        cycle: settings(period, 2.0),
        parameter: "holder.package_radius".to_owned(),
        from: 0.03,
        to: 0.06,
        longest_step: 0.1,
        max_points: 100,
    };
    let found = branch(&run, &settings)?;
    let ends = [found.points.first(), found.points.last()];
    let [empty, full] = ends.map(|point| point.map_or(f64::NAN, |point| modulus(&point.cycle)));
    let count = found.bifurcations().count();
    Ok(LedgerRow {
        figure: "largest Floquet multiplier of the bench winder with a full package",
        unit: "1",
        consistent: Some(full),
        verdict: format!(
            "not printed; the motion over a turn of the drum is followed from R = 30 to 60 mm, with \
             {count} bifurcations: disturbances decay to {} % in a turn with the empty bobbin and \
             to {} % with the full one",
            digits_of(100.0 * empty, 3),
            digits_of(100.0 * full, 3)
        ),
        ..LedgerRow::of(
            Study::Winder,
            "section 5",
            "`winder_linear`; `machinist cycle --over holder.package_radius=0.03..0.06`",
            Held::Test("the_winder_decays_over_its_growth_as_its_closed_form"),
        )
    })
}

//! Periodic motions of the studies' machines and their stability, by Floquet multipliers.

use machinist::periodic::{BranchSettings, Cycle, CycleSettings, Period, branch, cycle};
use machinist::trajectory::Trajectory;
use machinist::{Method, Simulation};
use machinist_contract::Simulator;
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::winder_linear::WinderLinear;
use machinist_scenes::scenes::winder_nonlinear::WinderNonlinear;
use num_complex::Complex64;

use super::{Held, LedgerRow, Study, digits_of};
use crate::verify::CheckFailure;

/// Relative tolerance of the runs: multipliers then have about eight digits.
const RTOL: f64 = 1e-10;

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let [stability, order] = gin_under_load()?;
    let linear = winder_over_growth(
        &WinderLinear,
        "`winder_linear`; `machinist cycle --over holder.package_radius=0.03..0.06`",
        "largest Floquet multiplier of the bench winder with a full package",
    )?;
    let stiffening = winder_over_growth(
        &WinderNonlinear,
        "`winder_nonlinear`; `machinist cycle --over holder.package_radius=0.03..0.06`",
        "largest Floquet multiplier with a full package on a stiffening layer",
    )?;
    Ok(vec![stability, order, linear, stiffening])
}

/// Returns the largest modulus of the multipliers.
fn modulus(cycle: &Cycle) -> f64 {
    cycle.nontrivial().map(|multiplier| multiplier.modulus).fold(0.0, f64::max)
}

fn settings(period: f64, settle: f64) -> CycleSettings {
    CycleSettings { period: Period::Fixed(period), settle, points: 101, ..CycleSettings::default() }
}

/// The gin after its run-up, under a load that varies as sin(pi w2 t).
fn gin_under_load() -> Result<[LedgerRow; 2], CheckFailure> {
    let run = Simulation::new(&SawGin).rtol(RTOL).method(Method::Dop853);
    let frequency = std::f64::consts::PI * (735.0 * std::f64::consts::PI / 30.0);
    let period = std::f64::consts::TAU / frequency;
    let found = cycle(&run, &settings(period, 2.0))?;
    let largest = modulus(&found);
    let row = |held: &'static str| {
        let place = "`saw_gin`; `machinist cycle`, `machinist spectrum --over cylinder_speed`";
        LedgerRow::of(Study::SawGin, "section 5", place, Held::Test(held))
    };
    let stability = LedgerRow {
        figure: "largest Floquet multiplier of the gin under load",
        unit: "1",
        consistent: Some(largest),
        verdict: format!(
            "not printed; stable: in a period of the load, {} s, disturbances of the motion decay \
             to {} %",
            digits_of(period, 3),
            digits_of(100.0 * largest, 3)
        ),
        ..row("the_gin_under_load_is_as_stable_as_its_linearization")
    };
    let harmonic = |name| harmonics(&found.motion, name);
    let order = frequency / harmonic("cylinder_speed")?.0;
    let (torque, load) = (harmonic("coupling_torque")?.1, harmonic("load_torque")?.1);
    let order = LedgerRow {
        figure: "order of the coupling torque's vibration under load",
        unit: "1",
        consistent: Some(order),
        verdict: format!(
            "not printed; with sin(pi w2 t) of 4.1, the load varies {} times in a turn of the \
             cylinder, with sin(w2 t) of (1) once; the amplitude is {} N m, {} of that of the load",
            digits_of(order, 3),
            digits_of(torque.norm(), 4),
            digits_of((torque / load).norm(), 3)
        ),
        ..row("the_loaded_gin_vibrates_as_two_masses_with_the_order_of_its_load")
    };
    Ok([stability, order])
}

/// Returns mean and first harmonic of a column over a period.
fn harmonics(motion: &Trajectory, name: &str) -> Result<(f64, Complex64), CheckFailure> {
    let values = motion.column(name).ok_or_else(|| CheckFailure::UnknownQuantity {
        scene: "saw_gin",
        kind: "output",
        name: name.to_owned(),
    })?;
    // The end repeats the start.
    let values = &values[1..];
    let count = values.len() as f64;
    let turned = |(index, value): (usize, &f64)| {
        Complex64::from_polar(*value, -std::f64::consts::TAU * index as f64 / count)
    };
    let first: Complex64 = values.iter().enumerate().map(turned).sum();
    Ok((values.iter().sum::<f64>() / count, first * 2.0 / count))
}

/// The bench winder while its package grows.
fn winder_over_growth(
    scene: &'static dyn Simulator<f64>,
    place: &'static str,
    figure: &'static str,
) -> Result<LedgerRow, CheckFailure> {
    let run = Simulation::new(scene).rtol(RTOL).method(Method::Dop853);
    let speed = |name: &str| -> Result<f64, CheckFailure> {
        let names = run.parameter_values().iter().enumerate();
        let mut all = names.map(|(at, value)| (run.simulator().parameter(at).name, *value));
        let found = all.find(|(known, _)| *known == name);
        found.map(|(_, value)| value).ok_or_else(|| CheckFailure::UnknownQuantity {
            scene: scene.name(),
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
        figure,
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
            place,
            Held::Test("the_winder_decays_over_its_growth_as_its_closed_form"),
        )
    })
}

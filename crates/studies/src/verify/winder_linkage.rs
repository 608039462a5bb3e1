//! Checks of the bobbin holder: mobility, contact forces at rest, positions.

use nalgebra::DMatrix;

use super::{Check, CheckFailure, Machine, Measured, worse};
use crate::closed_form::bobbin_holder::{BobbinHolder, HOLDER};
use crate::closed_form::holder_oscillation::SWINGING_HOLDER;
use crate::closed_form::winding_pair::HOLDER_POSITIONS;
use machinist::constraints::start;
use machinist::linear_analysis::{Mode, ModeKind, Place};
use machinist::{Method, Trajectory};

pub(super) const CHECKS: &[Check] = &[
    Check {
        name: "mobility of five positions, by rank and by Gruebler's count",
        reference: "the study's table; positions that differ",
        tolerance: 0.0,
        reason: "a count",
        measure: mobility,
    },
    Check {
        name: "forces at contact and stop, winding force -8, 0 and 8 N",
        reference: "balances of moments, relative to the larger",
        tolerance: 1e-8,
        reason: "at rest; rounding, grown by sixteen constraints solved together",
        measure: forces,
    },
    Check {
        name: "forces at contact and stop while the package grows from 30 to 60 mm",
        reference: "equation (15): balances of moments, relative to the larger",
        tolerance: 1e-8,
        reason: "at rest; rounding, grown by sixteen constraints solved together",
        measure: growing,
    },
    Check {
        name: "places of post, plate, cylinder, rod and bobbin along the run",
        reference: "where circles meet, over the shortest link",
        tolerance: 1e-12,
        reason: "every state is put back onto the constraints; rounding is left",
        measure: |machine| places(machine, |_, _| Ok(HOLDER.working_angles())),
    },
];

pub(super) const DROP_CHECKS: &[Check] = &[
    Check {
        name: "forces at contact and stop once it has settled",
        reference: "balances of moments with both contacts pressed, relative to the larger",
        tolerance: 1e-6,
        reason: "what is left of its swinging after 3 s, and second orders of contacts that give",
        measure: settled,
    },
    Check {
        name: "forces at contact and stop once it has settled, P = N f and N k/R either way",
        reference: "equations (11) to (14): balances of moments, relative to the larger",
        tolerance: 1e-6,
        reason: "as above",
        measure: settled_under_friction,
    },
    Check {
        name: "where the post goes from 0.02 rad below and above its unstable position",
        reference: "closed form of that position, drum at rest and dragging either way, wrong ends",
        tolerance: 0.0,
        reason: "a count",
        measure: falling,
    },
    Check {
        name: "frequencies and dampings of small oscillations at work, on both contacts",
        reference: "M, D and V'' in the angles of post and plate by hand, relative",
        tolerance: 1e-9,
        reason: "both are algebra; rounding, grown by twelve constraints and stiff contacts",
        measure: oscillations,
    },
    Check {
        name: "places of post, plate, cylinder, rod and bobbin along the run",
        reference: "trigonometry at the angles of post and plate, over the shortest link",
        tolerance: 1e-12,
        reason: "every state is put back onto the constraints, at impacts too; rounding is left",
        measure: |machine| {
            places(machine, |run, sample| {
                let [post, plate] = ["post_angle", "plate_angle"];
                Ok([machine.column(run, post)?[sample], machine.column(run, plate)?[sample]])
            })
        },
    },
];

/// Prefixes of coordinates and constraints that each position lacks relative to the first.
const LACKING: [&[&str]; 5] = [
    &[],
    &["drum.", "axle_b_", "contact"],
    &["drum.", "axle_b_", "contact", "stop"],
    &["stop"],
    &["drum.", "axle_b_", "contact", "stop"],
];

fn mobility(machine: &Machine) -> Result<Measured, CheckFailure> {
    let parameters = machine.parameters(&[])?;
    let simulator = machine.real;
    let state = start(simulator, &parameters, 0.0)?;
    let pattern = simulator.constraint_matrix_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    simulator.constraint_matrix(0.0, &state, &parameters, &mut values);
    let whole = machinist::complex_step::dense(pattern, &values);
    let mut differing = 0;
    for (position, lacking) in HOLDER_POSITIONS.iter().zip(LACKING) {
        let has = |name: &str| lacking.iter().all(|start| !name.starts_with(start));
        let columns: Vec<usize> = (0..simulator.shape().coordinates)
            .filter(|index| has(simulator.coordinate(*index).name))
            .collect();
        let rows: Vec<usize> = (0..simulator.constraints())
            .filter(|index| has(simulator.constraint(*index).name))
            .collect();
        let matrix: DMatrix<f64> = whole.select_rows(&rows).select_columns(&columns);
        let by_rank = columns.len() as i32 - matrix.rank(1e-9) as i32;
        let by_count = columns.len() as i32 - rows.len() as i32;
        let agrees = [by_rank, by_count] == [position.mobility(); 2]
            && columns.len() as i32 == 3 * position.links;
        differing += u64::from(!agrees);
    }
    Ok(super::counted(differing, 0))
}

fn forces(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for winding_force in [-8.0, 0.0, 8.0] {
        let run = machine.simulation(&[("winding_force", winding_force)])?.until(0.1).points(2);
        let run = run.method(Method::Dop853).run()?;
        let [normal, stop] = BobbinHolder { winding_force, ..HOLDER }.forces();
        let largest = worse(normal.abs(), stop.abs());
        for (name, exact) in [("contact_force", normal), ("stop_force", stop)] {
            let found = machine.column(&run, name)?[0];
            error = worse(error, (found - exact).abs() / largest);
        }
    }
    Ok(Measured::error(error))
}

/// Returns the largest distance of a body from the position given by the angles of post and plate
/// at each sample, relative to the length of the plate.
fn places(
    machine: &Machine,
    angles: impl Fn(&Trajectory, usize) -> Result<[f64; 2], CheckFailure>,
) -> Result<Measured, CheckFailure> {
    let run = machine.simulation(&[])?.rtol(1e-10).method(Method::Dop853).run()?;
    let mut error: f64 = 0.0;
    for sample in 0..run.times.len() {
        let centres = HOLDER.centres(angles(&run, sample)?);
        for (body, centre) in ["post", "plate", "cylinder", "rod", "bobbin"].iter().zip(centres) {
            let x = machine.column(&run, &format!("{body}.x"))?[sample];
            let y = machine.column(&run, &format!("{body}.y"))?[sample];
            error = worse(error, (x - centre[0]).hypot(y - centre[1]) / HOLDER.plate);
        }
    }
    Ok(Measured::error(error))
}

/// Does the same with P = N f in both directions, and with P = N k/R as a law in the scene.
fn settled_under_friction(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for share in [-0.18, -0.01, 0.01, 0.18] {
        error = worse(error, settled_with(machine, share)?.error);
    }
    Ok(Measured::error(error))
}

/// Falls onto its stop from below the unstable position, and away from above it; a drum that drags
/// the bobbin shifts that position.
fn falling(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut wrong = 0;
    for share in [-0.18, 0.0, 0.18] {
        for off in [-0.02, 0.02] {
            let lift = HOLDER.unstable_lift(share) + off;
            let [_, plate] = HOLDER.lifted(lift).working_angles();
            let settings = [("lift", lift), ("plate_angle", plate), ("grip", share)];
            let run = machine.simulation(&settings)?.until(3.0).points(2).rtol(1e-7);
            let run = run.method(Method::Auto).run()?;
            let is_at_stop = machine.last(&run, "stop_force")? > 0.0;
            wrong += u64::from(is_at_stop != (off < 0.0));
        }
    }
    Ok(super::counted(wrong, 0))
}

/// Compares N over the growth of the package, which lifts the plate against its spring.
fn growing(machine: &Machine) -> Result<Measured, CheckFailure> {
    let mut error = 0.0;
    for radius in [0.03, 0.04, 0.05, 0.06] {
        let run = machine.simulation(&[("bobbin_radius", radius)])?.until(0.01).points(2);
        let run = run.method(Method::Dop853).run()?;
        let holder = BobbinHolder { radii: [radius, HOLDER.radii[1]], ..HOLDER };
        let [normal, stop] = holder.forces();
        for (name, exact) in [("contact_force", normal), ("stop_force", stop)] {
            let found = machine.column(&run, name)?[0];
            error = worse(error, (found - exact).abs() / worse(normal.abs(), stop.abs()));
        }
    }
    Ok(Measured::error(error))
}

fn settled(machine: &Machine) -> Result<Measured, CheckFailure> {
    settled_with(machine, 0.0)
}

/// Compares forces after 3 s with those of a rigid holder whose package and stop are displaced by
/// the deflections of the contacts.
fn settled_with(machine: &Machine, share: f64) -> Result<Measured, CheckFailure> {
    let stiffness = machine.value("contact.stiffness")?;
    let run = machine
        .simulation(&[("grip", share)])?
        .until(3.0)
        .points(2)
        .rtol(1e-9)
        .method(Method::Auto);
    let run = run.run()?;
    let (mut holder, mut forces) = (HOLDER, [0.0, 0.0]);
    for _ in 0..20 {
        forces = holder.forces_by_share(share);
        holder.radii[0] = HOLDER.radii[0] - forces[0] / stiffness;
        // The stop deflects along the post's circle.
        let [x, y] = HOLDER.stop;
        let arm = x.hypot(y);
        let angle = y.atan2(x) - (forces[1] / stiffness / arm).asin();
        holder.stop = [arm * angle.cos(), arm * angle.sin()];
    }
    let mut error = 0.0;
    for (name, exact) in [("contact_force", forces[0]), ("stop_force", forces[1])] {
        let found = machine.last(&run, name)?;
        error = worse(error, (found - exact).abs() / worse(forces[0], forces[1]));
    }
    Ok(Measured::error(error))
}

/// Compares eigenvalues at the equilibrium near the end of the run.
fn oscillations(machine: &Machine) -> Result<Measured, CheckFailure> {
    let modes = machine.linearization(&[], Place::Equilibrium)?.modes()?;
    let found = modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation);
    let found: Vec<_> = found.map(Mode::eigenvalue).collect();
    let exact = SWINGING_HOLDER.eigenvalues();
    if found.len() != exact.len() {
        return Ok(Measured::error(f64::NAN));
    }
    let off = found.iter().zip(&exact).map(|(found, exact)| (found - exact).norm() / exact.norm());
    Ok(Measured::error(off.fold(0.0, worse)))
}

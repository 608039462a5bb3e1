//! The bobbin holder of the winder study over a drum that turns, compared with equations and
//! balances by hand.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;
use machinist_studies::closed_form::bobbin_holder::{BobbinHolder, HOLDER};
use machinist_studies::closed_form::turning_drum::{TURNING_DRUM, TurningDrum};

use crate::own_scene::of_specs;

fn holder() -> ModelSimulator {
    of_specs("drives/winder_turning_drum", Keep::Needed)
}

fn run(
    simulator: &ModelSimulator,
    settings: &[(&str, f64)],
    (method, rtol, until, points): (Method, f64, f64, usize),
) -> Trajectory {
    let base = Simulation::new(simulator.single()).method(method).rtol(rtol);
    let run = settings
        .iter()
        .fold(base, |run, (name, value)| run.parameter(name, *value).expect("a parameter"))
        .until(until)
        .points(points);
    run.run().unwrap_or_else(|error| panic!("{method} {settings:?}: {error}"))
}

/// Slips, follows the drum, falls onto the stop and bounces, or lifts off.
#[test]
fn a_turning_drum_moves_the_holder_as_equations_by_hand_do() {
    let simulator = holder();
    for (direction, lift, speed, tension) in [
        (1.0, 0.145, 3.75, 0.6),
        (-1.0, 0.145, 3.75, 0.6),
        (1.0, 0.02, 3.75, 0.6),
        (-1.0, 0.11, 12.0, 0.6),
        (1.0, 0.14, 3.75, 14.0),
    ] {
        let by_hand = TurningDrum { direction, speed, tension, ..TURNING_DRUM };
        let by_hand = by_hand.motion(lift, 0.01, 31);
        for method in [Method::Dop853, Method::Rodas5p, Method::Auto] {
            let settings = [
                ("direction", direction),
                ("lift", lift),
                ("drum_speed", speed),
                ("tension", tension),
            ];
            let found = run(&simulator, &settings, (method, 1e-9, 0.3, 31));
            for (name, place, size) in
                [("post_angle", 0, 1.0), ("plate_angle", 1, 1.0), ("bobbin_speed", 2, 60.0)]
            {
                let column = found.column(name).expect("a column");
                for (row, (found, exact)) in column.iter().zip(&by_hand).enumerate() {
                    let exact = exact[place];
                    assert!(
                        (found - exact).abs() < 1e-7 * size,
                        "{method} {settings:?} {name} {row}: {found} and not {exact}"
                    );
                }
            }
        }
    }
}

/// Returns N and Q \[N\] where contact and stop yield under them.
fn settled(forces: impl Fn(&BobbinHolder) -> [f64; 2]) -> [f64; 2] {
    let (mut holder, mut found) = (HOLDER, [0.0, 0.0]);
    for _ in 0..20 {
        found = forces(&holder);
        holder.radii[0] = HOLDER.radii[0] - found[0] / 1e6;
        let [x, y] = HOLDER.stop;
        let arm = x.hypot(y);
        let angle = y.atan2(x) - (found[1] / 1e6 / arm).asin();
        holder.stop = [arm * angle.cos(), arm * angle.sin()];
    }
    found
}

/// A bobbin that follows the drum turns with its speed, and is dragged by its resistances. One that
/// the thread pulls back with more than f N slips under friction for ever.
#[test]
fn forces_on_a_turning_bobbin_are_balances_of_moments() {
    let simulator = holder();
    for (direction, tension) in
        [(1.0, 0.6), (-1.0, 0.6), (1.0, 0.0), (-1.0, 6.0), (1.0, 20.0), (-1.0, 20.0)]
    {
        let settings = [("direction", direction), ("lift", 0.05), ("tension", tension)];
        let found = run(&simulator, &settings, (Method::Auto, 1e-9, 3.0, 4));
        let last = |name: &str| found.column(name).expect("a column")[3];
        let slips = tension > 12.0;
        let [normal, stop] = settled(|holder| {
            let (force, share) = if slips {
                (-direction * tension, direction * 0.18)
            } else {
                (0.0, direction * 1e-3 / holder.radii[0])
            };
            holder.forces_beside_turning_bobbin(force, share, direction * 4e-4)
        });
        let radius = HOLDER.radii[0] - normal / 1e6;
        for (name, exact) in [("contact_force", normal), ("stop_force", stop)] {
            let found = last(name);
            assert!((found / exact - 1.0).abs() < 1e-6, "{settings:?} {name}: {found} {exact}");
        }
        let speed = last("bobbin_speed");
        let follows = (-direction * speed * radius / 3.75 - 1.0).abs() < 1e-6;
        assert_eq!(follows, !slips, "{settings:?}: {speed}");
    }
}

/// On a drum at rest the post lifts off above its unstable position. Where the drum drags to the
/// left, it falls onto its stop from slightly above; where it drags to the right, it lifts off from
/// below.
#[test]
fn a_drum_that_begins_to_turn_pulls_the_post_onto_its_stop() {
    let simulator = holder();
    let rest = HOLDER.unstable_lift(0.0);
    let slipping = |direction: f64| {
        HOLDER.unstable_lift_beside_turning_bobbin(
            -direction * 0.6,
            direction * 0.18,
            direction * 4e-4,
        )
    };
    let [left, right] = [1.0, -1.0].map(slipping);
    assert!(right < rest && rest < left, "{right} {rest} {left}");
    for (direction, lift, is_at_stop) in [
        (0.0, rest - 2e-3, true),
        (0.0, rest + 2e-3, false),
        (1.0, rest + 5e-3, true),
        (1.0, left + 2e-3, false),
        (-1.0, rest - 5e-3, false),
        (-1.0, right - 2e-3, true),
    ] {
        for method in [Method::Dop853, Method::Auto] {
            let settings = [("direction", direction), ("lift", lift)];
            let found = run(&simulator, &settings, (method, 1e-7, 3.0, 4));
            let force = found.column("stop_force").expect("a column")[3];
            assert_eq!(force > 0.0, is_at_stop, "{method} {settings:?}: {force}");
        }
    }
}

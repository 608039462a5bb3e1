//! Derivatives of eigenmodes by parameters: compared with closed forms, and with differences of
//! eigenmodes at new equilibria.

use machinist::Simulation;
use machinist::linear_analysis::{
    LinearError, Linearization, Mode, ModeKind, ModeSlope, NoSlope, Place, Point, PointSlopes,
    equilibrium, operating_point,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::two_mass::TwoMass;

use crate::constraints::{slider_crank_let_go, start_of};
use crate::own_scene::of_text;

type Slopes = Vec<Result<Vec<ModeSlope>, NoSlope>>;

fn slopes(run: &Simulation<'_>, place: Place, by: &[&str]) -> (Vec<Mode>, Slopes) {
    let point = operating_point(run, place).expect("a point");
    slopes_at(run, place, point, by)
}

fn slopes_at(run: &Simulation<'_>, place: Place, point: Point, by: &[&str]) -> (Vec<Mode>, Slopes) {
    let moving = PointSlopes::of(run, place, &point, by).expect("it moves");
    let linearization = Linearization::at(run.simulator(), point).expect("it is regular");
    let modes = linearization.modes().expect("eigenvalues");
    let slopes = linearization.mode_slopes(&modes, &moving).expect("dual numbers");
    (modes, slopes)
}

/// Returns the largest error of all eigenmodes' derivatives by all parameters, relative to the
/// eigenvalue's size over the parameter's, against differences of sixth order of `modes_at`.
fn off_differences(
    values: &[f64],
    (modes, slopes): (&[Mode], &Slopes),
    modes_at: &dyn Fn(usize, f64) -> Vec<Mode>,
    step: impl Fn(usize) -> f64,
) -> f64 {
    let mut worst = 0.0_f64;
    for (column, value) in values.iter().enumerate() {
        let size = if *value == 0.0 { 1.0 } else { value.abs() };
        let step = step(column);
        let weights = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];
        let rows = weights.map(|(times, weight)| {
            let at = |sign: f64| modes_at(column, value + sign * times * step * size);
            (at(1.0), at(-1.0), weight / (60.0 * step * size))
        });
        for (number, (mode, found)) in modes.iter().zip(slopes).enumerate() {
            let Ok(found) = found else {
                assert_eq!(mode.kind, ModeKind::Free, "{found:?}");
                continue;
            };
            let found = found[column];
            let difference = |of: &dyn Fn(&Mode) -> f64| -> f64 {
                rows.iter().map(|(a, b, weight)| weight * (of(&a[number]) - of(&b[number]))).sum()
            };
            let natural = mode.natural_frequency();
            for (own, of, scale) in [
                (found.real, &(|mode: &Mode| mode.real) as &dyn Fn(&Mode) -> f64, natural),
                (found.imaginary, &|mode: &Mode| mode.imaginary, natural),
                (found.natural_frequency, &Mode::natural_frequency, natural),
                (found.damping_ratio, &Mode::damping_ratio, 1.0),
            ] {
                let off = (own - difference(of)).abs() * size / scale;
                assert!(off < 1e-4, "mode {number} by {column}: {own} for {}", difference(of));
                worst = worst.max(off);
            }
        }
    }
    worst
}

#[test]
fn two_masses_have_the_slopes_of_their_closed_form() {
    // w = sqrt(c (1/J1 + 1/J2)), ratio = b w/(2 c), at stiffnesses from soft to stiff.
    let by = ["coupling.stiffness", "coupling.damping", "driver.inertia", "cylinder.inertia"];
    for stiffness in [3e2, 5e3, 23_065.2, 4e5, 1e7] {
        for damping in [0.0, 1.0, 30.0] {
            let run = Simulation::new(&TwoMass).parameter("drive_torque", 843.72);
            let run = run.and_then(|run| run.parameter("coupling.stiffness", stiffness));
            let run = run.and_then(|run| run.parameter("coupling.damping", damping));
            let (modes, slopes) = slopes(&run.expect("known"), Place::Equilibrium, &by);
            let place = modes.iter().position(|mode| mode.kind == ModeKind::Oscillation);
            let place = place.expect("it swings");
            let (j1, j2) = (4.2_f64, 1.244_f64);
            let inverse = 1.0 / j1 + 1.0 / j2;
            let w = (stiffness * inverse).sqrt();
            let found = slopes[place].as_ref().expect("it is simple");
            let by_w = [
                w / (2.0 * stiffness),
                0.0,
                -stiffness / (2.0 * w * j1 * j1),
                -stiffness / (2.0 * w * j2 * j2),
            ];
            let by_ratio = [
                -damping * w / (4.0 * stiffness * stiffness),
                w / (2.0 * stiffness),
                damping / (2.0 * stiffness) * by_w[2],
                damping / (2.0 * stiffness) * by_w[3],
            ];
            let sizes = [stiffness, damping.max(1.0), j1, j2];
            for k in 0..4 {
                let off_w = (found[k].natural_frequency - by_w[k]).abs() * sizes[k] / w;
                let off_ratio = (found[k].damping_ratio - by_ratio[k]).abs() * sizes[k];
                assert!(off_w < 1e-12 && off_ratio < 1e-12, "{}: {off_w} {off_ratio}", by[k]);
            }
            let free = slopes.iter().filter(|slopes| **slopes == Err(NoSlope::Free));
            assert_eq!(free.count(), 2);
        }
    }
}

/// Returns a mass on a hardening spring under a constant force.
fn hard_spring() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "hard"
        [units.mass]
        unit = "mass"
        [run]
        until = 1e-3
        points = 2
        rtol = 1e-8
        method = "dop853"
        [outputs]
        x = "mass.x"
        [define.mass.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.mass.parameters]
        mass = { value = 2.0, unit = "kg" }
        soft = { value = 300.0, unit = "N/m" }
        hard = { value = 5e3, unit = "N/m^3" }
        damping = { value = 3.0, unit = "N s/m" }
        force = { value = 40.0, unit = "N" }
        [define.mass.energy]
        kinetic = "mass*v^2/2"
        potential = "soft*x^2/2 + hard*x^4/4 - force*x"
        dissipation = "damping*v^2/2"
        "#,
        Keep::Needed,
    )
}

#[test]
fn an_equilibrium_that_moves_takes_its_frequencies_along() {
    // m w^2 = c + 3 h x^2 where c x + h x^3 = F.
    let scene = hard_spring();
    for force in [-90.0, -1.0, 0.5, 40.0, 700.0] {
        let run = Simulation::new(&scene).parameter("mass.force", force).expect("known");
        let by = ["mass.force", "mass.soft", "mass.hard", "mass.mass", "mass.damping"];
        let (modes, slopes) = slopes(&run, Place::Equilibrium, &by);
        let point = operating_point(&run, Place::Equilibrium).expect("it rests");
        let (x, m, c, h, b) = (point.state[0], 2.0, 300.0, 5e3, 3.0);
        let tangent = c + 3.0 * h * x * x;
        let w = (tangent / m).sqrt();
        assert!((modes[0].natural_frequency() / w - 1.0).abs() < 1e-13);
        // dx by F, c, h.
        let moves = [1.0 / tangent, -x / tangent, -x * x * x / tangent];
        let of_tangent = [
            6.0 * h * x * moves[0],
            1.0 + 6.0 * h * x * moves[1],
            3.0 * x * x + 6.0 * h * x * moves[2],
        ];
        let found = slopes[0].as_ref().expect("simple");
        for k in 0..3 {
            let wanted = of_tangent[k] / (2.0 * w * m);
            let off = (found[k].natural_frequency - wanted).abs() / wanted.abs();
            assert!(off < 1e-9, "{}: {off}", by[k]);
            let wanted = -b / (2.0 * m * w * w) * wanted;
            assert!((found[k].damping_ratio / wanted - 1.0).abs() < 1e-9, "{}", by[k]);
        }
        assert!((found[3].natural_frequency / (-w / (2.0 * m)) - 1.0).abs() < 1e-12);
        assert!((found[4].damping_ratio * 2.0 * m * w - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_gin_that_runs_agrees_with_differences_of_its_modes_by_every_parameter() {
    let names: Vec<&str> = (0..SawGin.shape().parameters)
        .map(|index| SawGin.parameter(index).name)
        // The load turns with time, which is held.
        .filter(|name| *name != "motor.supply_phase")
        .collect();
    for (stiffness, load, ratio) in [(23_065.2, 843.72, 1.0), (4e3, 500.0, 1.3), (2e5, 60.0, 0.6)] {
        let base = Simulation::new(&SawGin)
            .parameter("coupling.stiffness", stiffness)
            .and_then(|run| run.parameter("load.mean", load))
            .and_then(|run| run.parameter("coupling.ratio", ratio))
            .expect("known");
        let point = operating_point(&base, Place::Equilibrium).expect("it runs");
        let (modes, slopes) = slopes_at(&base, Place::Equilibrium, point.clone(), &names);
        let place = |name: &str| {
            let mut places = 0..SawGin.shape().parameters;
            let is_it = |index: &usize| SawGin.parameter(*index).name == name;
            places.find(is_it).expect("known")
        };
        let values: Vec<f64> = names.iter().map(|name| point.parameters[place(name)]).collect();
        let modes_at = |column: usize, value: f64| {
            let mut guess = point.clone();
            guess.parameters[place(names[column])] = value;
            let point = equilibrium(&SawGin, &guess).expect("it runs");
            Linearization::at(&SawGin, point).expect("regular").modes().expect("eigenvalues")
        };
        // At 2 s the load has turned by hundreds of radians.
        let step = |column: usize| if names[column] == "load.speed" { 2e-5 } else { 1e-3 };
        let off = off_differences(&values, (&modes, &slopes), &modes_at, step);
        assert!(off < 1e-8, "{off}");
    }
}

#[test]
fn within_constraints_they_agree_with_differences_and_closed_forms() {
    let scene = slider_crank_let_go();
    let shape = scene.shape();
    let quantity = |index: usize| scene.parameter(index);
    let names: Vec<&str> = (0..shape.parameters).map(|index| quantity(index).name).collect();
    let run = Simulation::new(&scene);
    let parameters = (0..shape.parameters).map(|index| scene.parameter_default(index));
    let parameters: Vec<f64> = parameters.collect();
    let state = start_of(&scene).expect("it starts");
    let guess = Point { time: 0.0, state, parameters: parameters.clone() };
    let point = equilibrium(&scene, &guess).expect("it rests");
    let (modes, slopes) = slopes_at(&run, Place::Equilibrium, point.clone(), &names);
    let modes_at = |column: usize, value: f64| {
        let mut guess = point.clone();
        guess.parameters[column] = value;
        let point = equilibrium(&scene, &guess).expect("it rests");
        Linearization::at(&scene, point).expect("regular").modes().expect("eigenvalues")
    };
    let off = off_differences(&parameters, (&modes, &slopes), &modes_at, |_| 1e-3);
    assert!(off < 1e-8, "{off}");
    // w is proportional to the root of gravity, for all bodies together.
    let swing = modes.iter().position(|mode| mode.kind == ModeKind::Oscillation).expect("one");
    let found = slopes[swing].as_ref().expect("simple");
    let of_gravity = names.iter().zip(found).filter(|(name, _)| name.ends_with("gravity"));
    let share = of_gravity.map(|(_, slope)| slope.natural_frequency);
    let gravity = names.iter().position(|name| name.ends_with("gravity")).expect("it falls");
    let (found, wanted) =
        (share.sum::<f64>(), modes[swing].natural_frequency() / (2.0 * parameters[gravity]));
    assert!((found / wanted - 1.0).abs() < 1e-9, "{found} for {wanted}");
}

#[test]
fn along_a_run_they_agree_with_differences_of_the_run() {
    let names = ["motor.inertia", "motor.phase_voltage", "coupling.damping"];
    for place in [Place::Time(0.3), Place::Initial] {
        let run = |changed: Option<(usize, f64)>| {
            let run = Simulation::new(&SawGin).rtol(1e-12);
            match changed {
                Some((column, value)) => run.parameter(names[column], value).expect("known"),
                None => run,
            }
        };
        let (modes, slopes) = slopes(&run(None), place, &names);
        let modes_at = |column: usize, value: f64| {
            let run = run(Some((column, value)));
            let point = operating_point(&run, place).expect("a point");
            Linearization::at(&SawGin, point).expect("regular").modes().expect("eigenvalues")
        };
        let values = [4.2, 220.0, 128.5346];
        let off = off_differences(&values, (&modes, &slopes), &modes_at, |_| 3e-3);
        assert!(off < 1e-7, "{place:?}: {off}");
    }
}

/// Returns two masses, each on a separate spring.
fn two_springs() -> ModelSimulator {
    of_text(
        r#"
        [scene]
        name = "two"
        [units.a]
        unit = "mass"
        [units.b]
        unit = "mass"
        [run]
        until = 1e-3
        points = 2
        rtol = 1e-8
        method = "dop853"
        [outputs]
        a = "a.x"
        b = "b.x"
        [define.mass.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.mass.parameters]
        mass = { value = 2.0, unit = "kg" }
        stiffness = { value = 50.0, unit = "N/m" }
        damping = { value = 0.0, unit = "N s/m" }
        load = { value = 0.0, unit = "N" }
        [define.mass.energy]
        kinetic = "mass*v^2/2"
        potential = "stiffness*x^2/2 - load*x"
        dissipation = "damping*v^2/2"
        "#,
        Keep::Needed,
    )
}

#[test]
fn eigenvalues_that_are_not_alone_are_told_and_not_differentiated() {
    let scene = two_springs();
    let run = Simulation::new(&scene);
    let (_, same) = slopes(&run, Place::Equilibrium, &["a.stiffness"]);
    assert_eq!(same, [Err(NoSlope::Repeated(vec![1])), Err(NoSlope::Repeated(vec![0]))]);
    // With a difference of a millionth they are separate.
    let apart = run.clone().parameter("a.stiffness", 50.0 * (1.0 + 1e-6)).expect("known");
    let (modes, apart) = slopes(&apart, Place::Equilibrium, &["a.stiffness"]);
    let wanted = modes[1].natural_frequency() / (2.0 * 50.0 * (1.0 + 1e-6));
    let found = apart[1].as_ref().expect("simple")[0].natural_frequency;
    assert!((found / wanted - 1.0).abs() < 1e-8, "{found} for {wanted}");
    // Critical damping, 2 sqrt(k m) = 20.
    let critical = run.parameter("a.damping", 20.0).expect("known");
    let (modes, critical) = slopes(&critical, Place::Equilibrium, &["a.stiffness"]);
    for (mode, slopes) in modes.iter().zip(&critical) {
        // The eigenvalue -5 is double: one very slow oscillation, or two decays.
        if (mode.real + 5.0).abs() < 1e-3 {
            assert!(matches!(slopes, Err(NoSlope::Defective | NoSlope::Repeated(_))), "{slopes:?}");
        } else {
            assert!(slopes.is_ok());
        }
    }
}

#[test]
fn what_cannot_be_told_is_refused_by_name() {
    let run = Simulation::new(&TwoMass).parameter("drive_torque", 843.72).expect("known");
    let point = operating_point(&run, Place::Equilibrium).expect("in balance");
    let of = |by: &str| PointSlopes::of(&run, Place::Equilibrium, &point, &[by]).expect_err("none");
    let error = of("coupling.stifness").to_string();
    assert!(error.contains("did you mean `coupling.stiffness`"), "{error}");
    // With one more torque, two masses accelerate for ever.
    let error = of("drive_torque");
    assert!(matches!(error, LinearError::LosesEquilibrium { .. }), "{error}");
}

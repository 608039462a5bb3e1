//! Motions that do not depend on the algebra that derives them.
//!
//! These tests have a process of their own: one that has used Symbolica must not start others, as
//! tests of the suite do, which compile C (see `machinist_algebra::cas::session`).

#[path = "cycles/specs.rs"]
mod specs;

use machinist::Simulation;
use machinist::periodic::{Cycle, CycleSettings, Period, cycle};
use machinist::trajectory::Trajectory;
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_model::ModelSimulator;

/// Runs at a tolerance of 1e-12.
fn run(simulator: &ModelSimulator) -> Trajectory {
    let run = Simulation::new(simulator).rtol(1e-12).run();
    run.unwrap_or_else(|error| panic!("{error}"))
}

/// Returns a spatial four-bar: a crank about z, a rocker about y, and a rod with two balls.
fn rod_with_two_balls(length: f64) -> LagrangianSystem {
    let text = format!(
        r#"
        [scene]
        name = "rssr"
        [units.linkage]
        unit = "linkage"
        [initial]
        "linkage.a_dot" = 10.0
        [guess]
        "linkage.b" = 1.2
        [outputs]
        b = "linkage.b"
        force = {{ expression = "linkage.rod", unit = "N" }}
        [run]
        until = 2.0
        points = 41
        rtol = 1e-9
        method = "auto"
        [define.linkage.coordinates]
        a = {{ unit = "rad" }}
        b = {{ unit = "rad" }}
        [define.linkage.parameters]
        r = {{ value = 0.1, unit = "m" }}
        s = {{ value = 0.3, unit = "m" }}
        l = {{ value = {length}, unit = "m" }}
        px = {{ value = 0.3, unit = "m" }}
        py = {{ value = 0.2, unit = "m" }}
        j_a = {{ value = 0.02, unit = "kg m^2" }}
        j_b = {{ value = 0.03, unit = "kg m^2" }}
        m = {{ value = 0.8, unit = "kg" }}
        [define.linkage.helpers]
        ax = {{ expression = "r*cos(a)", unit = "m" }}
        ay = {{ expression = "r*sin(a)", unit = "m" }}
        bx = {{ expression = "px + s*cos(b)", unit = "m" }}
        bz = {{ expression = "s*sin(b)", unit = "m" }}
        [define.linkage.energy]
        kinetic = "j_a*a_dot^2/2 + j_b*b_dot^2/2 + m*(der(ax)^2 + der(ay)^2 + der(ax)*der(bx) + der(bx)^2 + der(bz)^2)/6"
        potential = "m*9.81 [m/s^2]*bz/2"
        [define.linkage.constraints.rod]
        expression = "sqrt((ax - bx)^2 + (ay - py)^2 + bz^2) - l"
        "#
    );
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("the scene is written");
    pipeline::check(&path).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

#[test]
fn a_smooth_linkage_is_smooth_by_every_algebra() {
    for length in [0.38, 0.42, 0.45, 0.5] {
        let system = rod_with_two_balls(length);
        let [own, other] = [Algebra::Plain, Algebra::Symbolica].map(|algebra| {
            let model = pipeline::compile_by(algebra, system.clone(), Keep::Needed);
            let model = model.unwrap_or_else(|errors| panic!("{}", errors.render()));
            assert!(model.kink_guards.results.is_empty(), "{algebra:?}, {length} m");
            run(&ModelSimulator::new(model))
        });
        for (a, b) in own.columns.iter().zip(&other.columns) {
            let size = b.values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
            for (x, y) in a.values.iter().zip(&b.values) {
                assert!((x - y).abs() <= 1e-8 * size, "{length} m: {} {x:e} {y:e}", a.name);
            }
        }
    }
}

/// Checks the spec in a text.
fn checked(text: &str) -> LagrangianSystem {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).expect("the scene is written");
    pipeline::check(&path).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

/// Checks a spec of the folder `specs/scenes`.
fn of_specs(name: &str) -> LagrangianSystem {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let path = folder.join(format!("{name}.toml"));
    pipeline::check(&path).unwrap_or_else(|errors| panic!("{}", errors.render()))
}

/// Teeth with backlash, driven by their transmission error, as in the book's chapter on cycles.
fn rattling() -> LagrangianSystem {
    let chapter = include_str!("../docs/book/src/cycles.md");
    let (_, rest) = chapter.split_once("```toml,file=rattle.toml\n").expect("the spec");
    checked(rest.split_once("```").expect("its end").0)
}

/// A machine, values of its parameters, and the search for its motion.
struct Searched {
    system: LagrangianSystem,
    parameters: &'static [(&'static str, f64)],
    settings: CycleSettings,
}

/// Multipliers of the machines whose cycles the suite compares with references.
#[test]
fn multipliers_do_not_depend_on_the_algebra() {
    let forced = |name: &str, settle: f64| {
        let period = Period::Parameter(name.to_owned());
        CycleSettings { period, settle, ..CycleSettings::default() }
    };
    let own = |settle: f64| CycleSettings { settle, ..CycleSettings::default() };
    let all = [
        Searched {
            system: checked(specs::DUFFING),
            parameters: &[("block.frequency", 1.6)],
            settings: forced("block.frequency", 200.0),
        },
        Searched {
            system: of_specs("classics/van_der_pol"),
            parameters: &[("oscillator.damping", 1.0)],
            settings: own(30.0),
        },
        Searched {
            system: checked(&specs::rubbing(specs::BY_MODES)),
            parameters: &[("block.friction", 0.7), ("block.frequency", 0.4)],
            settings: forced("block.frequency", 60.0),
        },
        Searched {
            system: checked(&specs::rubbing(specs::BY_SIGN)),
            parameters: &[("block.friction", 0.7), ("block.frequency", 0.4)],
            settings: forced("block.frequency", 60.0),
        },
        Searched {
            system: checked(specs::STOPPED),
            parameters: &[("block.force", 5.5), ("block.frequency", 2.2)],
            settings: forced("block.frequency", 300.0),
        },
        Searched {
            system: checked(&specs::rotor(specs::JEFFCOTT)),
            parameters: &[("disc.speed", 0.95)],
            settings: forced("disc.speed", 400.0),
        },
        Searched {
            system: rattling(),
            parameters: &[("pair.tooth", 0.75)],
            settings: forced("pair.tooth", 300.0),
        },
        Searched { system: of_specs("stick_slip"), parameters: &[], settings: own(5.0) },
        Searched {
            system: of_specs("bouncing_mass"),
            parameters: &[("amplitude", 1.8e-3)],
            settings: forced("frequency", 2.0),
        },
    ];
    for Searched { system, parameters, settings } in all {
        let by = |algebra: Algebra| -> Cycle {
            let model = pipeline::compile_by(algebra, system.clone(), Keep::Needed);
            let model = model.unwrap_or_else(|errors| panic!("{}", errors.render()));
            let simulator = ModelSimulator::new(model);
            let run = Simulation::new(simulator.single()).rtol(1e-11);
            let run = parameters
                .iter()
                .fold(run, |run, (name, value)| run.parameter(name, *value).expect("a parameter"));
            let found = cycle(&run.method(machinist::Method::Dop853), &settings);
            found.unwrap_or_else(|error| panic!("{algebra:?}: {error}"))
        };
        let [own, other] = [Algebra::Plain, Algebra::Symbolica].map(by);
        let scene = &own.scene;
        assert!(!own.multipliers.is_empty(), "{scene}");
        assert_eq!(own.multipliers.len(), other.multipliers.len(), "{scene}");
        assert!((own.period / other.period - 1.0).abs() < 1e-9, "{scene}");
        for (a, b) in own.multipliers.iter().zip(&other.multipliers) {
            let off = (a.real - b.real).hypot(a.imaginary - b.imaginary);
            assert!(off < 1e-8, "{scene}: {off:e}, {a:?} {b:?}");
        }
    }
}

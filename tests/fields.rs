//! Scenes with fields, divided into elements: comparison of methods, of emitted and interpreted
//! code, and refused numbers.

use machinist::error::StopCause;
use machinist::field::{Discretisation, FieldError, FieldSimulator, MAX_ELEMENTS};
use machinist::{Method, SimulateError, Simulation, Trajectory};
use machinist_contract::{Describe as _, Simulator};
use machinist_scenes::scenes::shaft_with_rotors::ShaftWithRotors;

fn cut(elements: usize, order: usize) -> FieldSimulator<'static, f64> {
    let wanted = Discretisation { elements: Some(elements), order: Some(order) };
    FieldSimulator::new(&ShaftWithRotors, wanted).unwrap()
}

fn run(simulator: &dyn Simulator<f64>, method: Method) -> Result<Trajectory, SimulateError> {
    Simulation::new(simulator).until(0.004).points(5).rtol(1e-7).method(method).run()
}

#[test]
fn implicit_methods_agree_with_explicit_ones_on_a_field_with_a_border() {
    let simulator = cut(6, 3);
    assert!(simulator.border().is_some());
    let reference = run(&simulator, Method::Dop853).unwrap();
    for method in [Method::Rodas5p, Method::Radau, Method::Auto, Method::Bdf] {
        let run = run(&simulator, method).unwrap();
        for name in ["start_angle", "end_angle", "shaft.phi[7]"] {
            let [ours, known] = [&run, &reference].map(|run| run.column(name).unwrap());
            let error = ours.iter().zip(known).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let limit = if method == Method::Bdf { 1e-5 } else { 1e-7 };
            assert!(error < limit, "{method}, {name}: {error:e}");
        }
    }
}

#[test]
fn methods_with_full_matrices_refuse_what_is_too_large_for_them() {
    let simulator = cut(3000, 1);
    let error = run(&simulator, Method::Bdf).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("6002 states, more than 4000"), "{text}");
    assert!(matches!(error, SimulateError::Stopped { cause: StopCause::TooLarge { .. }, .. }));
}

#[test]
fn numbers_of_elements_and_orders_out_of_range_are_refused() {
    let with = |elements, order| {
        let wanted = Discretisation { elements: Some(elements), order: Some(order) };
        FieldSimulator::<f64>::new(&ShaftWithRotors, wanted).err()
    };
    for found in [0, MAX_ELEMENTS + 1, 1_000_000_000_000] {
        let error = with(found, 2).unwrap();
        assert!(matches!(error, FieldError::ElementCount { found: told, .. } if told == found));
    }
    for order in [0, 17] {
        assert_eq!(with(4, order), Some(FieldError::Order(order)));
    }
}

mod emitted {
    use std::path::Path;
    use std::time::{Duration, Instant};

    use machinist_codegen::emit::{EmitOptions, rust::emit};
    use machinist_codegen::mechanics::reduce::Keep;
    use machinist_codegen::pipeline;

    /// Returns the emitted scene with a number of elements, without the hash of its spec and with
    /// the number restored, and the time that took.
    fn emitted(elements: &str) -> (String, Duration) {
        let specs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs");
        let spec = std::fs::read_to_string(specs.join("scenes/shaft_with_rotors.toml")).unwrap();
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join("scenes")).unwrap();
        std::fs::create_dir_all(folder.path().join("units")).unwrap();
        for unit in ["shaft.toml", "rotor.toml"] {
            let to = folder.path().join("units").join(unit);
            std::fs::copy(specs.join("units").join(unit), to).unwrap();
        }
        let file = folder.path().join("scenes/shaft_with_rotors.toml");
        let spec = spec.replace("elements = 16", &format!("elements = {elements}"));
        assert!(spec.contains(elements));
        std::fs::write(&file, spec).unwrap();
        let start = Instant::now();
        let program = pipeline::generate(&file, Keep::Needed).unwrap();
        let text = emit(&program, &EmitOptions::for_scenes()).unwrap();
        let elapsed = start.elapsed();
        let lines = text.lines().filter(|line| !line.contains("scenes/shaft_with_rotors.toml"));
        let lines: Vec<&str> = lines.collect();
        let text = lines.join("\n");
        let default = |number: &str| format!("elements {number},");
        assert!(text.contains(&default(elements)), "{text}");
        (text.replace(&default(elements), &default("10")), elapsed)
    }

    #[test]
    fn ten_elements_and_a_hundred_thousand_are_the_same_emitted_text_and_work() {
        let (few, _) = emitted("10");
        let (many, many_time) = emitted("100000");
        let (_, few_time) = emitted("10");
        assert_eq!(few, many);
        println!("{few_time:?} and {many_time:?}");
        // The machine may be busy with something else; unrolled it would be 10 000 times.
        assert!(many_time < 10 * few_time + Duration::from_secs(5));
    }
}

/// A port may be anywhere on its field. Beyond it there is no machine, and the result is NaN.
#[test]
fn a_port_beyond_the_end_of_its_field_is_refused() {
    let text = r#"
        [scene]
        name = "shaft_line"
        [units]
        bar = { unit = "bar", fields = { phi = { elements = 6, order = 4 } } }
        disk = { unit = "rotational/inertia", parameters = { inertia = 1.5 } }
        [[joints]]
        connect = ["disk.a", "bar.mid"]
        [initial]
        "bar.phi" = "0.001 [rad]*x/bar.length"
        [run]
        until = 0.01
        points = 2
        [define.bar.parameters]
        length = { value = 12, unit = "m" }
        place = { value = 4, unit = "m" }
        [define.bar.fields.phi]
        unit = "rad"
        over = "length"
        kinetic = "0.08 [kg m]*phi_dot^2/2"
        potential = "8e5 [N m^2]*phi_x^2/2"
        [define.bar.ports]
        left = { kind = "rotational", field = "phi", at = "0 [m]" }
        mid = { kind = "rotational", field = "phi", at = "place" }
        right = { kind = "rotational", field = "phi", at = "length" }
    "#;
    let scene = crate::own_scene::of_text(text, machinist_codegen::mechanics::reduce::Keep::All);
    let wanted = Discretisation { elements: Some(6), order: Some(4) };
    let simulator = FieldSimulator::new(scene.with_fields(), wanted).expect("elements");
    for place in [0.5, 4.0, 11.5, 13.0, -1.0] {
        for method in [Method::Auto, Method::Dop853, Method::Radau] {
            let run = Simulation::new(&simulator).method(method).parameter("bar.place", place);
            let run = run.expect("a parameter").run();
            assert_eq!(run.is_ok(), (0.0..=12.0).contains(&place), "{place}, {method}");
        }
    }
}

//! Constructs of specs, each compared with a closed form or the same machine written out.

use machinist::{Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::{of_files, of_text, refusal};

/// Returns a scene of a unit `s`, with text for the scene in dotted keys, and text for the unit.
fn scene(scene: &str, unit: &str, run: &str) -> String {
    let own = if scene.contains("units.s =") { "" } else { "units.s = { unit = \"s\" }\n" };
    format!("{own}{scene}\n[scene]\nname = \"own\"\n[run]\n{run}\n[define.s]\n{unit}")
}

const RUN: &str = "until = 1.0\npoints = 101\nrtol = 1e-10\nmethod = \"auto\"";

/// Returns a mass pushed by a force of the unit.
fn pushed(force: &str, outputs: &str) -> String {
    let unit = format!(
        "coordinates.x = {{ unit = \"m\", velocity = \"v\" }}\n\
         energy.kinetic = \"1 [kg]*v^2/2\"\n\
         forces = [{{ coordinate = \"x\", expression = \"{force}\" }}]\n"
    );
    scene(&format!("outputs = {{ {outputs} }}\ninitial.\"s.x\" = -1"), &unit, RUN)
}

fn run(scene: &ModelSimulator, set: &[(&str, f64)]) -> Trajectory {
    let mut simulation = Simulation::new(scene);
    for (name, value) in set {
        simulation = simulation.parameter(name, *value).expect("a parameter");
    }
    simulation.run().expect("it runs")
}

/// Returns the largest distance of a column from a function of time.
fn off(run: &Trajectory, name: &str, exact: impl Fn(f64) -> f64) -> f64 {
    let values = run.times.iter().zip(column(run, name));
    values.map(|(t, value)| (value - exact(*t)).abs()).fold(0.0, f64::max)
}

fn parameters(scene: &ModelSimulator) -> Vec<&str> {
    (0..scene.shape().parameters).map(|index| scene.parameter(index).name).collect()
}

#[test]
fn numbers_may_be_in_any_unit_and_outputs_are_shown_in_theirs() {
    let text = scene(
        "outputs.speed = { expression = \"s.w\", unit = \"rpm\" }\n\
         outputs.turned = { expression = \"s.a\", unit = \"rev\" }\n\
         outputs.path = { expression = \"radius*s.a\", unit = \"mm\" }\n\
         outputs.plain = \"radius\"\n\
         parameters.radius = { value = 40, unit = \"mm\" }\n\
         initial.\"s.w\" = \"1500 [rpm]\"\n\
         checks.speed.of = \"speed\"\n\
         checks.speed.expression = \"1500 [rpm] + 0.5 [1/s^2]*t\"\n\
         checks.speed.tolerance = 1e-9\nchecks.speed.source = \"uniform acceleration\"",
        "coordinates.a = { unit = \"rad\", velocity = \"w\" }\n\
         parameters.inertia = { value = \"20 [g]*(1 [m])^2\", unit = \"kg m^2\" }\n\
         energy.kinetic = \"inertia*w^2/2\"\n\
         forces = [{ coordinate = \"a\", expression = \"10 [N mm]\" }]",
        "until = \"1 [min]/30\"\npoints = 41\nrtol = 1e-10\nmethod = \"auto\"",
    );
    let scene = of_text(&text, Keep::Needed);
    let run = run(&scene, &[]);
    let start = 50.0 * std::f64::consts::PI;
    let angle = |t: f64| start * t + 0.25 * t * t;
    let turn = 2.0 * std::f64::consts::PI;
    assert!((run.times[40] - 2.0).abs() < 1e-15);
    assert!(off(&run, "speed", |t| (start + 0.5 * t) * 60.0 / turn) < 1e-8);
    assert!(off(&run, "turned", |t| angle(t) / turn) < 1e-8);
    assert!(off(&run, "path", |t| 40.0 * angle(t)) < 1e-5);
    assert!(off(&run, "plain", |_| 0.04) < 1e-16, "parameters are in SI units");
    assert_eq!(scene.output(0).unit, "rpm");
    let radius = (0..scene.shape().parameters).find(|k| scene.parameter(*k).name == "radius");
    let radius = radius.expect("a parameter");
    assert_eq!((scene.parameter(radius).unit, scene.parameter_default(radius)), ("m", 0.04));
    let check = &scene.model().checks[0];
    assert_eq!(check.unit, "rpm");
}

#[test]
fn a_number_in_another_unit_is_a_parameter_that_runs_may_change() {
    let text = scene(
        "units.s = { unit = \"s\", parameters = { mass = \"2000 [g]\" } }\n\
         outputs.x = \"s.x\"\noutputs.turned = \"s.turned\"\ninitial.\"s.x\" = 1",
        "coordinates.x = { unit = \"m\", velocity = \"v\" }\n\
         parameters.mass = { value = 1, unit = \"kg\" }\n\
         parameters.stiffness = { value = \"0.018 [kN/m]\", unit = \"N/m\" }\n\
         parameters.speed = { value = \"-300 [rpm]\", unit = \"rad/s\" }\n\
         outputs.turned = { expression = \"speed*t\", unit = \"rad\" }\n\
         energy = { kinetic = \"mass*v^2/2\", potential = \"stiffness*x^2/2\" }",
        RUN,
    );
    let scene = of_text(&text, Keep::Needed);
    assert_eq!(parameters(&scene), ["s.mass", "s.stiffness", "s.speed"]);
    for (index, value) in [(0, 2.0), (1, 18.0), (2, -10.0 * std::f64::consts::PI)] {
        assert!((scene.parameter_default(index) - value).abs() < 1e-14);
    }
    assert!(off(&run(&scene, &[("s.speed", 2.0)]), "turned", |t| 2.0 * t) < 1e-14);
    assert!(off(&run(&scene, &[]), "x", |t| (3.0 * t).cos()) < 1e-8);
    assert!(off(&run(&scene, &[("s.mass", 8.0)]), "x", |t| (1.5 * t).cos()) < 1e-8);
    let wrong = text.replace("2000 [g]", "2000 [N]");
    assert!(refusal(&wrong).contains("mass"), "{}", refusal(&wrong));
}

#[test]
fn a_quantity_that_moves_is_declared_in_a_coherent_unit() {
    let text = scene("", "coordinates.x = { unit = \"mm\" }", RUN);
    let said = refusal(&text);
    assert!(said.contains("\"mm\" is not a coherent SI unit"), "{said}");
    assert!(said.contains("declare it in m;"), "{said}");
}

#[test]
fn parameters_may_follow_others() {
    let disc = "coordinates.a = { unit = \"rad\", velocity = \"w\" }\n\
                parameters.mass = { value = 2, unit = \"kg\" }\n\
                parameters.radius = { value = 0.1, unit = \"m\" }\n\
                parameters.inertia = { value = \"mass*radius^2/2\", unit = \"kg m^2\" }\n\
                parameters.stiffness = { value = 1, unit = \"N m/rad\" }\n\
                energy.kinetic = \"inertia*w^2/2\"\n\
                energy.potential = \"stiffness*a^2/2\"";
    let text = scene(
        "outputs.first = \"s.a\"\noutputs.second = \"r.a\"\noutputs.inertia = \"r.inertia\"\n\
         parameters.frequency = { value = 3, unit = \"Hz\" }\n\
         parameters.omega = { value = \"2*pi*frequency\", unit = \"rad/s\" }\n\
         initial.\"s.a\" = 0.1\ninitial.\"r.a\" = 0.2\n\
         units.s = { unit = \"s\", parameters = { stiffness = \"s.inertia*omega^2\" } }\n\
         units.r = { unit = \"s\", parameters = { mass = \"3*s.mass\", \
         stiffness = \"r.inertia*(2*omega)^2\" } }",
        disc,
        RUN,
    );
    let scene = of_text(&text, Keep::Needed);
    let names = parameters(&scene);
    assert!(names.iter().all(|name| !name.contains("stiffness") && !name.contains("inertia")));
    assert!(names.contains(&"frequency") && names.contains(&"s.mass"), "{names:?}");
    assert!(!names.contains(&"r.mass") && !names.contains(&"omega"), "{names:?}");
    for (frequency, mass) in [(3.0, 2.0), (0.2, 17.0), (9.0, 1e-3)] {
        let run = run(&scene, &[("frequency", frequency), ("s.mass", mass)]);
        let omega = 2.0 * std::f64::consts::PI * frequency;
        assert!(off(&run, "first", |t| 0.1 * (omega * t).cos()) < 1e-7, "{frequency}");
        assert!(off(&run, "second", |t| 0.2 * (2.0 * omega * t).cos()) < 1e-7, "{frequency}");
        assert!(off(&run, "inertia", |_| 3.0 * mass * 0.005) < 1e-12 * mass);
    }
}

#[test]
fn parameters_that_follow_what_they_may_not_are_refused() {
    let disc = |value: &str| {
        scene(
            "",
            &format!(
                "coordinates.a = {{ unit = \"rad\" }}\n\
                 parameters.inertia = {{ value = \"{value}\", unit = \"kg m^2\" }}\n\
                 energy.kinetic = \"inertia*a_dot^2/2\""
            ),
            RUN,
        )
    };
    for (value, message) in [
        ("2*inertia", "this definition refers to itself"),
        ("2 [kg]", "parameter `inertia` is in kg m^2, but this term is in kg"),
        ("1 [kg m^2]*a", "depends on a coordinate or state"),
        ("1 [kg m^2]*t/(1 [s])", "depends on time"),
        ("1 [kg m^2]*sqrt(-1)", "not a finite number"),
        ("1 [kg m^2]*unknown", "unknown name `unknown`"),
    ] {
        let said = refusal(&disc(value));
        assert!(said.contains(message), "{value}: {said}");
    }
    let listed = disc("1 [kg m^2] + 1 [kg m^2]")
        .replace("[run]", "[tunable]\nparameters = [\"s.inertia\"]\n[run]");
    assert!(refusal(&listed).contains("`s.inertia` is given by an expression"));
}

#[test]
fn angles_of_directions_are_those_of_atan2() {
    let text = scene(
        "outputs.turned = \"s.turned\"\noutputs.scaled = \"s.scaled\"",
        "coordinates.a = { unit = \"rad\", velocity = \"w\" }\n\
         parameters.start = { value = 0, unit = \"rad\" }\n\
         parameters.size = { value = 1, unit = \"m\" }\n\
         states.clock = { unit = \"rad\", rate = \"20 [rad/s]\", initial = \"start\" }\n\
         energy.kinetic = \"1 [kg m^2]*w^2/2\"\n\
         outputs.turned = { expression = \"atan2(size*sin(clock), size*cos(clock))\", unit = \"rad\" }\n\
         outputs.scaled = { expression = \"atan2(3*sin(clock), -0.5*cos(clock))\", unit = \"rad\" }",
        RUN,
    );
    let scene = of_text(&text, Keep::Needed);
    for (start, size) in [(0.0, 1.0), (1.0, 1e-6), (-3.0, 1e6), (0.5, 40.0)] {
        let run = run(&scene, &[("s.start", start), ("s.size", size)]);
        let angle = |t: f64| start + 20.0 * t;
        assert!(
            off(&run, "turned", |t| (size * angle(t).sin()).atan2(size * angle(t).cos())) < 1e-8
        );
        assert!(
            off(&run, "scaled", |t| (3.0 * angle(t).sin()).atan2(-0.5 * angle(t).cos())) < 1e-7
        );
    }
}

#[test]
fn a_pendulum_held_by_an_angle_of_its_place_is_one_of_that_angle() {
    // V(phi) of phi = atan2(y, x): the slopes of atan2 in the equations of motion.
    let text = |potential: &str| {
        scene(
            "outputs.x = \"s.x\"\noutputs.y = \"s.y\"\ninitial.\"s.x\" = -1\ninitial.\"s.y\" = 0.3\n\
             initial.\"s.x_dot\" = 0.4",
            &format!(
                "coordinates.x = {{ unit = \"m\" }}\ncoordinates.y = {{ unit = \"m\" }}\n\
                 energy.kinetic = \"1 [kg]*(x_dot^2 + y_dot^2)/2\"\n\
                 energy.potential = \"{potential} + 8 [N/m]*(x^2 + y^2)/2\""
            ),
            RUN,
        )
    };
    let by_angle = of_text(&text("2 [J]*cos(2*atan2(y, x))"), Keep::Needed);
    let by_place = of_text(&text("2 [J]*(x^2 - y^2)/(x^2 + y^2)"), Keep::Needed);
    let (by_angle, by_place) = (run(&by_angle, &[]), run(&by_place, &[]));
    for name in ["x", "y"] {
        let pairs = column(&by_angle, name).iter().zip(column(&by_place, name));
        let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-7, "{name}: {off}");
    }
}

#[test]
fn cube_roots_are_those_of_negative_numbers_too() {
    let scene = of_text(
        &pushed(
            "1 [N]",
            "root = { expression = \"cbrt(s.x - 0.1 [m] - 1 [m/s]*t)*1 [m^(2/3)]\", unit = \"m\" }, x = \"s.x\"",
        ),
        Keep::Needed,
    );
    let run = run(&scene, &[]);
    assert!(off(&run, "x", |t| -1.0 + t * t / 2.0) < 1e-9);
    assert!(off(&run, "root", |t| (-1.1 + t * t / 2.0 - t).cbrt()) < 1e-8);
}

#[test]
fn quantities_may_be_raised_to_fractions() {
    let unit = "coordinates.x = { unit = \"m\", velocity = \"v\" }\n\
                parameters.k = { value = 3, unit = \"N/m^(4/3)\" }\n\
                energy.kinetic = \"1 [kg]*v^2/2\"\n\
                energy.potential = \"3/7*k*x^(7/3)\"";
    let text = scene(
        "outputs.x = \"s.x\"\noutputs.v = \"s.v\"\ninitial.\"s.x\" = 2\n",
        unit,
        &RUN.replace("1.0", "0.5"),
    );
    let run = run(&of_text(&text, Keep::Needed), &[]);
    let energy = |x: f64, v: f64| v * v / 2.0 + 9.0 / 7.0 * x.powf(7.0 / 3.0);
    let all = column(&run, "x").iter().zip(column(&run, "v")).map(|(x, v)| energy(*x, *v));
    let start = energy(2.0, 0.0);
    assert!(all.map(|now| (now / start - 1.0).abs()).fold(0.0, f64::max) < 1e-9);
    assert!(refusal(&text.replace("x^(7/3)", "x^(7/9)")).contains("no dimension in SI units"));
}

#[test]
fn a_spring_of_two_stiffnesses_swings_half_and_half() {
    let unit = |law: &str| {
        format!(
            "coordinates.x = {{ unit = \"m\", velocity = \"v\" }}\n\
             energy.kinetic = \"1 [kg]*v^2/2\"\n{law}"
        )
    };
    let laws = [
        "forces = [{ coordinate = \"x\", expression = \"-piecewise(x < 0, 400 [N/m]*x, 100 [N/m]*x)\" }]",
        "energy.potential = \"piecewise(x < 0, 400 [N/m], 100 [N/m])*x^2/2\"",
        "energy.potential = \"piecewise(0 < -x, 400 [N/m], 100 [N/m])*x^2/2\"",
    ];
    // x is sin(10 t)/10, then -sin(20 t)/20, a period of pi (1/10 + 1/20).
    let half = std::f64::consts::PI / 10.0;
    let exact = |t: f64| {
        let t = t % (1.5 * half);
        if t < half { (10.0 * t).sin() / 10.0 } else { -(20.0 * (t - half)).sin() / 20.0 }
    };
    for law in laws {
        for method in ["auto", "dop853", "tsit5", "radau", "rodas5p"] {
            let settings = format!("until = 5.0\npoints = 201\nrtol = 1e-8\nmethod = \"{method}\"");
            let text = scene("outputs.x = \"s.x\"\ninitial.\"s.v\" = 1\n", &unit(law), &settings);
            let run = run(&of_text(&text, Keep::Needed), &[]);
            let off = off(&run, "x", exact);
            assert!(off < 3e-6, "{law} {method}: {off}");
        }
    }
}

#[test]
fn tables_go_by_lines_or_keep_rising_where_they_are_told() {
    let csv = "x [mm],f [N]\n-1000,-4\n0,0\n500,0\n1000,1\n2000,9\n";
    let text = |course: &str, f: &str| {
        pushed(
            &format!("-table('law.csv', 'f', x{course}){f}"),
            "x = \"s.x\", f = { expression = \"table('law.csv', 'f', s.x)\", unit = \"N\" }",
        )
        .replace("s.x)\", unit", &format!("s.x{course})\", unit"))
        .replace("until = 1.0", "until = 4.0")
    };
    let of = |text: &str| of_files(&[("scene.toml", text), ("law.csv", csv)], Keep::Needed);
    let straight = of(&text(", 'linear'", " + 0.5 [N]"));
    let written = "-piecewise(x < 0, 4 [N/m]*x, x < 0.5 [m], 0, x < 1 [m], 2 [N/m]*(x - 0.5 [m]), 1 [N] + 8 [N/m]*(x - 1 [m])) + 0.5 [N]";
    let written = of_text(
        &pushed(written, "x = \"s.x\"").replace("until = 1.0", "until = 4.0"),
        Keep::Needed,
    );
    let (straight, written) = (run(&straight, &[]), run(&written, &[]));
    let pairs = column(&straight, "x").iter().zip(column(&written, "x"));
    let difference = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-7, "{difference}");
    // Slopes of SciPy's PchipInterpolator at these knots: 20/3, 0, 0, 3, 12.
    let monotone = run(&of(&text(", 'monotone'", " + 0.5 [N]")), &[]);
    let pchip = |x: f64| {
        let knots = [-1.0, 0.0, 0.5, 1.0, 2.0];
        let (values, slopes) = ([-4.0, 0.0, 0.0, 1.0, 9.0], [20.0 / 3.0, 0.0, 0.0, 3.0, 12.0]);
        let k = knots[1..4].iter().filter(|knot| **knot <= x).count();
        let (h, s) = (knots[k + 1] - knots[k], (x - knots[k]) / (knots[k + 1] - knots[k]));
        values[k] * (1.0 + 2.0 * s) * (1.0 - s).powi(2)
            + h * slopes[k] * s * (1.0 - s).powi(2)
            + values[k + 1] * s * s * (3.0 - 2.0 * s)
            + h * slopes[k + 1] * s * s * (s - 1.0)
    };
    let both = column(&monotone, "x").iter().zip(column(&monotone, "f"));
    let off = both.map(|(x, f)| (f - pchip(*x)).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12, "{off}");
}

#[test]
fn what_holds_between_instances_is_an_energy_of_the_scene() {
    let mass = "coordinates.x = { unit = \"m\", velocity = \"v\" }\n\
                energy.kinetic = \"1 [kg]*v^2/2\"";
    let text = scene(
        "outputs.a = \"s.x\"\noutputs.b = \"r.x\"\ninitial.\"s.x\" = 1\n\
         energy.potential = \"50 [N/m]*(s.x - r.x)^2/2\"\n\
         energy.dissipation = \"2 [N s/m]*(s.v - r.v)^2/2\"\n\
         energy.kinetic = \"3 [kg]*(s.v + r.v)^2/2\"\n\
         units.s = { unit = \"s\" }\nunits.r = { unit = \"s\" }",
        mass,
        RUN,
    );
    let run = run(&of_text(&text, Keep::Needed), &[]);
    // The difference d of both: d'' = -2 (50 d + 2 d'), the sum rests.
    let frequency = (100.0_f64 - 4.0).sqrt();
    let d = |t: f64| {
        (-2.0 * t).exp() * ((frequency * t).cos() + 2.0 / frequency * (frequency * t).sin())
    };
    assert!(off(&run, "a", |t| 0.5 + 0.5 * d(t)) < 1e-8);
    assert!(off(&run, "b", |t| 0.5 - 0.5 * d(t)) < 1e-8);
}

#[test]
fn a_run_may_last_as_long_as_parameters_say() {
    let mass = "coordinates.x = { unit = \"m\" }\nenergy.kinetic = \"1 [kg]*x_dot^2/2\"";
    let text = |until: &str| {
        let run = format!(
            "from = \"-1/frequency\"\nuntil = \"{until}\"\npoints = 3\nrtol = 1e-6\nmethod = \"auto\""
        );
        scene("parameters.frequency = { value = 4, unit = \"Hz\" }", mass, &run)
    };
    let run = run(&of_text(&text("10/frequency"), Keep::Needed), &[]);
    assert_eq!(run.times, [-0.25, 1.125, 2.5]);
    assert!(refusal(&text("-2/frequency")).contains("it goes from -0.25 s to -0.5 s"));
    assert!(refusal(&text("10*frequency")).contains("the end of the run is in s"));
    assert!(refusal(&text("s.x/(1 [m/s])")).contains("a coordinate or state"));
}

const MASS: &str = "coordinates.x = { unit = \"m\", velocity = \"v\" }\n\
    ports.a = { kind = \"translational\", coordinate = \"x\" }\n\
    parameters.m = { value = 1, unit = \"kg\" }\nenergy.kinetic = \"m*v^2/2\"";
const SPRING: &str = "[define.r]\n\
    coordinates.from = { unit = \"m\" }\ncoordinates.to = { unit = \"m\" }\n\
    ports.a = { kind = \"translational\", coordinate = \"from\" }\n\
    ports.b = { kind = \"translational\", coordinate = \"to\" }\n\
    parameters.k = { value = 1, unit = \"N/m\" }\n\
    inputs.free = { unit = \"m\" }\n\
    energy.potential = \"k*(to - from - free)^2/2\"";

/// Returns five masses between four springs, as rows.
fn rows() -> String {
    let outputs = (1..=5).map(|i| format!("outputs.x{i} = \"mass[{i}].x\""));
    let scene = [
        "units.s = { unit = \"s\" }",
        "units.mass = { unit = \"s\", count = 5, parameters = { m = \"0.2 [kg]*i\" } }",
        "units.spring = { unit = \"r\", count = 4, parameters = { k = \"40 [N/m]/i\" }, \
         inputs = { free = \"0.01 [m]*sin(i*t/(1 [s])) + 0.001*mass[i].x\" } }",
        "joints = [{ connect = [\"mass[i].a\", \"spring[i].a\"] }, \
         { connect = [\"spring[i].b\", \"mass[i+1].a\"] }]",
        "forces = [{ port = \"mass[i].a\", expression = \"-i*0.5 [N s/m]*mass[i].v\" }]",
        "initial.\"mass[i].x\" = \"0.1 [m]*i^2\"",
    ];
    scene.map(str::to_owned).into_iter().chain(outputs).collect::<Vec<_>>().join("\n")
}

/// Returns the same machine with each mass and spring by itself.
fn written_out() -> String {
    let mut lines = vec!["units.s = { unit = \"s\" }".to_owned()];
    let (mut joints, mut forces) = (Vec::new(), Vec::new());
    for i in 1..=5 {
        let (mass, start) = (0.2 * f64::from(i), 0.1 * f64::from(i * i));
        lines.push(format!("units.mass_{i} = {{ unit = \"s\", parameters = {{ m = {mass} }} }}"));
        lines.push(format!("initial.\"mass_{i}.x\" = {start}"));
        lines.push(format!("outputs.x{i} = \"mass_{i}.x\""));
        let force = format!("-{i}*0.5 [N s/m]*mass_{i}.v");
        forces.push(format!("{{ port = \"mass_{i}.a\", expression = \"{force}\" }}"));
    }
    for i in 1..=4 {
        let stiffness = 40.0 / f64::from(i);
        lines.push(format!(
            "units.spring_{i} = {{ unit = \"r\", parameters = {{ k = {stiffness} }}, inputs = \
             {{ free = \"0.01 [m]*sin({i}*t/(1 [s])) + 0.001*mass_{i}.x\" }} }}"
        ));
        let next = i + 1;
        joints.push(format!("{{ connect = [\"mass_{i}.a\", \"spring_{i}.a\"] }}"));
        joints.push(format!("{{ connect = [\"spring_{i}.b\", \"mass_{next}.a\"] }}"));
    }
    lines.push(format!("joints = [{}]\nforces = [{}]", joints.join(", "), forces.join(", ")));
    lines.join("\n")
}

fn of_masses(top: &str) -> String {
    format!("{}\n{SPRING}", scene(top, MASS, RUN))
}

#[test]
fn a_row_of_instances_is_each_of_them_written_out() {
    let [row, whole] =
        [rows(), written_out()].map(|top| run(&of_text(&of_masses(&top), Keep::Needed), &[]));
    for name in ["x1", "x2", "x3", "x4", "x5"] {
        let pairs = column(&row, name).iter().zip(column(&whole, name));
        let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-12, "{name}: {off}");
    }
}

#[test]
fn rows_that_are_not_there_are_refused() {
    let own = "units.s = { unit = \"s\" }";
    for (from, to, said) in [
        ("count = 4", "count = 0", "`count` must be an integer from 1"),
        ("count = 4", "count = 2.5", "`count` must be an integer from 1"),
        ("count = 4", "count = 1e9", "`count` must be an integer from 1"),
        ("mass[i+1].a", "mass[i+9].a", "no index `i` is valid for all of these rows"),
        ("mass[i+1].a", "masses[i+1].a", "`masses` is not a row of instances"),
        ("mass[5]", "mass[6]", "unknown instance `mass_6`"),
        (own, &format!("{own}\nunits.mass_2 = {{ unit = \"s\" }}"), "two instances `mass_2`"),
        (
            own,
            &format!("{own}\nparameters.i = {{ value = 1, unit = \"1\" }}"),
            "`i` is reserved for the index of rows",
        ),
    ] {
        let text = of_masses(&rows().replace(from, to));
        assert!(text.contains(to));
        let told = refusal(&text);
        assert!(told.contains(said), "{to}: {told}");
    }
}

//! Coordinates without inertia that constraints determine: the machine is as regular as without
//! these coordinates, for any sizes and units.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_text, refusal};

const METHODS: [Method; 4] = [Method::Dop853, Method::Rodas5p, Method::Radau, Method::Auto];

/// Returns a crank with inertia, a rod without mass, a slider with mass; both equations of the loop
/// are scaled by `scale`.
fn slider_crank(scale: f64) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "slider_crank"
        [units.s]
        unit = "s"
        [initial]
        "s.phi" = 0.3
        "s.phi_dot" = 5.0
        [guess]
        "s.psi" = -0.1
        "s.x" = 0.4
        [outputs]
        phi = "s.phi"
        psi = "s.psi"
        x = "s.x"
        [run]
        until = 4.0
        points = 41
        rtol = 1e-9
        method = "auto"
        [define.s.coordinates]
        phi = {{ unit = "rad" }}
        psi = {{ unit = "rad" }}
        x = {{ unit = "m" }}
        [define.s.parameters]
        inertia = {{ value = 0.02, unit = "kg m^2" }}
        mass = {{ value = 1.5, unit = "kg" }}
        crank = {{ value = 0.1, unit = "m" }}
        rod = {{ value = 0.3, unit = "m" }}
        [define.s.energy]
        kinetic = "inertia*phi_dot^2/2 + mass*x_dot^2/2"
        [define.s.constraints.along]
        expression = "{scale}*(x - crank*cos(phi) - rod*cos(psi))"
        [define.s.constraints.across]
        expression = "{scale}*(crank*sin(phi) + rod*sin(psi))"
        "#
    );
    of_text(&text, Keep::Needed)
}

/// Largest error of the crank's speed, relative to its own: by the energy, which the crank's
/// angle decides all of; and of the rod and the slider, by the loop.
fn error_of_the_crank(run: &Simulation<'_>, [inertia, mass, crank, rod]: [f64; 4]) -> f64 {
    let run = run.run().expect("it turns");
    let column = |name| run.column(name).expect("a column");
    let [phi, psi, x, speed] = ["phi", "psi", "x", "s.phi_dot"].map(column);
    // x = a cos(phi) + sqrt(b^2 - a^2 sin(phi)^2)
    let slide = |phi: f64| {
        let (sine, cosine) = phi.sin_cos();
        let along = (rod * rod - crank * crank * sine * sine).sqrt();
        [crank * cosine + along, -crank * sine * (1.0 + crank * cosine / along)]
    };
    let carried = |phi: f64| inertia + mass * slide(phi)[1].powi(2);
    let errors = (0..run.times.len()).map(|row| {
        let exact = speed[0] * (carried(phi[0]) / carried(phi[row])).sqrt();
        let of_speed = (speed[row] / exact - 1.0).abs();
        let of_slider = (x[row] - slide(phi[row])[0]).abs() / crank;
        let of_rod = (psi[row].sin() + crank / rod * phi[row].sin()).abs();
        of_speed.max(of_slider).max(of_rod)
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_rod_without_mass_turns_with_its_crank_by_the_energy_alone() {
    let sizes = [
        [0.02, 1.5, 0.1, 0.3],
        [2e-8, 1.5, 0.1, 0.3],
        [0.02, 1e-6, 0.1, 0.3],
        [2e5, 3e-3, 0.1, 0.101],
        [2e-11, 1.5e-6, 1e-4, 4e-4],
    ];
    for scale in [1.0, 1e-7, 1e6] {
        let scene = slider_crank(scale);
        for values in sizes {
            for method in METHODS {
                let mut run = Simulation::new(&scene).method(method).rtol(1e-9);
                for (name, value) in ["inertia", "mass", "crank", "rod"].into_iter().zip(values) {
                    run = run.parameter(&format!("s.{name}"), value).expect("known");
                }
                let error = error_of_the_crank(&run, values);
                assert!(error < 1e-6, "{method:?} {values:?} {scale}: {error:e}");
            }
        }
    }
}

/// Returns a machine of coordinates x and y, in m, with a kinetic energy, a potential and
/// constraints.
fn of_two(kinetic: &str, potential: &str, constraints: &str) -> String {
    format!(
        r#"
        [scene]
        name = "of_two"
        [units.s]
        unit = "s"
        [initial]
        "s.y" = 0.2
        [outputs]
        x = "s.x"
        y = "s.y"
        [run]
        until = 10.0
        points = 51
        rtol = 1e-10
        method = "auto"
        [define.s.coordinates]
        x = {{ unit = "m" }}
        y = {{ unit = "m" }}
        [define.s.parameters]
        mass = {{ value = 2.0, unit = "kg" }}
        none = {{ value = 0, unit = "kg" }}
        stiffness = {{ value = 5.0, unit = "N/m" }}
        [define.s.energy]
        kinetic = "{kinetic}"
        potential = "{potential}"
        {constraints}
        "#
    )
}

/// Returns the largest difference of x and y from their exact values.
fn error_of_two(text: &str, exact: impl Fn(f64) -> [f64; 2]) -> f64 {
    let scene = of_text(text, Keep::Needed);
    let run = Simulation::new(&scene).run().expect("it swings");
    let column = |name| run.column(name).expect("a column");
    let found = ["x", "y"].map(column);
    let errors = run.times.iter().enumerate().flat_map(|(row, time)| {
        let exact = exact(*time);
        found.map(|values| values[row]).into_iter().zip(exact).map(|(a, b)| (a - b).abs())
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_lever_of_one_mass_at_the_sum_of_its_ends_swings_as_by_hand() {
    // x = 2 y: T = m (3 y')^2/2, V = k (2 y)^2/2.
    let text = of_two(
        "mass*(x_dot + y_dot)^2/2",
        "stiffness*x^2/2",
        "[define.s.constraints.lever]\nexpression = \"x - 2*y\"",
    );
    let speed = (4.0 * 5.0 / (9.0 * 2.0_f64)).sqrt();
    let error = error_of_two(&text, |t| [0.4, 0.2].map(|start| start * (speed * t).cos()));
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn a_mass_of_zero_in_the_spec_is_none() {
    // A pendulum of y alone: x = 3 y has a mass that the spec sets to zero.
    let with = |constraints: &str| {
        of_two("mass*y_dot^2/2 + none*x_dot^2/2", "stiffness*x^2/2", constraints)
    };
    let held = with("[define.s.constraints.lever]\nexpression = \"x - 3*y\"");
    let speed = (9.0 * 5.0 / 2.0_f64).sqrt();
    let error = error_of_two(&held, |t| [0.6, 0.2].map(|start| start * (speed * t).cos()));
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn a_place_without_mass_that_is_moved_drives_what_hangs_on_it() {
    // y'' = -w^2 (y - a sin(u t)), from y = 0.2 at rest.
    let text = of_two(
        "mass*y_dot^2/2",
        "stiffness*(x - y)^2/2",
        "[define.s.constraints.shaken]\nexpression = \"x - 0.1 [m]*sin(3 [rad/s]*t)\"",
    );
    let (square, moved) = (5.0 / 2.0_f64, 3.0_f64);
    let own = square.sqrt();
    let forced = 0.1 * square / (square - moved * moved);
    let error = error_of_two(&text, |t| {
        let free = 0.2 * (own * t).cos() - forced * moved / own * (own * t).sin();
        [0.1 * (moved * t).sin(), free + forced * (moved * t).sin()]
    });
    assert!(error < 1e-7, "{error:e}");
}

#[test]
fn a_motion_that_neither_inertia_nor_constraint_nor_force_decides_is_refused_by_name() {
    let apart = of_two(
        "mass*x_dot^2/2",
        "stiffness*x^2/2",
        "[define.s.constraints.fixed]\nexpression = \"x\"",
    );
    let said = refusal(&apart);
    assert!(said.contains("coordinate `s.y` has no inertia: no force depends on"), "{said}");
    let none = of_two("mass*y_dot^2/2 + none*x_dot^2/2", "stiffness*y^2/2", "");
    let said = refusal(&none);
    assert!(said.contains("coordinate `s.x` has no inertia: no force depends on"), "{said}");
    // T depends on x and y alike, and a constraint does not distinguish them.
    let together = of_two(
        "mass*(x_dot + y_dot)^2/2",
        "stiffness*x^2/2",
        "[define.s.constraints.sum]\nexpression = \"x + y\"",
    );
    let said = refusal(&together);
    assert!(said.contains("`s.x`, `s.y` can move without kinetic energy"), "{said}");
    // The constraint holds during a mode.
    let while_stuck = of_two(
        "mass*x_dot^2/2",
        "stiffness*(x - y)^2/2",
        "[define.s.constraints.held]\nexpression = \"y\"\nwhen = { stuck = 1 }\n\
         [define.s.modes.stuck]\ninitial = 1",
    );
    let said = refusal(&while_stuck);
    assert!(said.contains("coordinate `s.y` has no inertia"), "{said}");
    let bent = of_two("mass*x_dot^2/2", "stiffness*(x - y)^2/2 + stiffness*y^4/(4 [m^2])", "");
    let said = refusal(&bent);
    assert!(said.contains("coordinate `s.y` has no inertia: the balance of forces"), "{said}");
    assert!(said.contains("not linear"), "{said}");
}

#[test]
fn a_mass_of_zero_stays_zero_where_forces_alone_determine_a_place() {
    // Two springs in series, 5 N/m each.
    let text =
        of_two("mass*y_dot^2/2 + none*x_dot^2/2", "stiffness*(x - y)^2/2 + stiffness*x^2/2", "");
    let speed = (2.5 / 2.0_f64).sqrt();
    let error = error_of_two(&text, |t| [0.1, 0.2].map(|start| start * (speed * t).cos()));
    assert!(error < 1e-7, "{error:e}");
    let scene = of_text(&text, Keep::All);
    let changed = Simulation::new(&scene).parameter("s.none", 1.0).and_then(|run| run.run());
    let said = changed.expect_err("it has no inertia").to_string();
    assert!(said.contains("`s.none` is 0"), "{said}");
}

#[test]
fn a_port_without_inertia_that_is_joined_to_nothing_is_refused() {
    let text = r#"
        [scene]
        name = "open"
        [units.mass]
        unit = "translational/mass"
        [units.damper]
        unit = "translational/damper"
        [[joints]]
        connect = ["mass.a", "damper.a"]
        [run]
        until = 1
    "#;
    let said = refusal(text);
    assert!(said.contains("coordinate `damper.x_b` has no inertia: nothing is joined"), "{said}");
}

#[test]
fn a_check_of_a_place_that_forces_determine_is_an_output() {
    let springs = |more: &str| {
        let potential = "stiffness*(x - y)^2/2 + stiffness*x^2/2";
        let text = of_two("mass*y_dot^2/2", potential, more);
        text.replace("[outputs]\n", "").replace("x = \"s.x\"\n", "").replace("y = \"s.y\"\n", "")
    };
    let names = |more: &str| -> Vec<String> {
        let scene = of_text(&springs(more), Keep::All);
        (0..scene.shape().outputs).map(|index| scene.output(index).name.to_owned()).collect()
    };
    let place = "[checks.place]\nof = \"s.x\"\nsource = \"by hand\"\n\
                 expression = \"0.1 [m]\"\ntolerance = 1\n";
    let speed = "[checks.speed]\nof = \"s.y_dot\"\nsource = \"by hand\"\n\
                 expression = \"0 [m/s]\"\ntolerance = 1\n";
    // States need no output, until there is one.
    assert!(names("").is_empty());
    assert!(names(speed).is_empty());
    assert_eq!(names(&format!("{place}{speed}")), ["s.x", "s.y_dot"]);
}

/// Axes z, y and z of gimbals, of which the first and the last coincide at the angle zero of the second. The
/// inertia of both together, beside what each has alone, is half the square of that angle times a ratio.
#[test]
fn a_start_at_which_gimbals_lock_is_refused_or_noted_by_name() {
    let text = r#"
        [scene]
        name = "gimbals"
        [units.g]
        unit = "g"
        [run]
        until = 0.1
        points = 3
        rtol = 1e-9
        [define.g.coordinates]
        a = { unit = "rad" }
        b = { unit = "rad" }
        c = { unit = "rad" }
        [define.g.frames]
        a = { revolute = { axis = [0, 0, 1], angle = "a" } }
        b = { parent = "a", revolute = { axis = [0, 1, 0], angle = "b" } }
        c = { parent = "b", revolute = { axis = [0, 0, 1], angle = "c" } }
        [define.g.bodies.c]
        frame = "c"
        mass = 1
        inertia = { xx = 0.2, yy = 0.2, zz = 0.1 }
        "#;
    let machine = of_text(text, Keep::All);
    let from =
        |angle: f64| Simulation::new(&machine).initial_value("g.b", angle).expect("its name").run();
    let refused = from(0.0).expect_err("no start").to_string();
    assert!(
        refused.contains("`g.a`, `g.c` move together with no inertia at the start"),
        "{refused}"
    );
    let noted = from(1e-5).expect("it runs").notes.join(" ");
    // 0.2/0.1*1e-5^2/2.
    let wanted = "`g.a`, `g.c` move together with little inertia at the start, 1e-10 of what they";
    assert!(noted.contains(wanted), "{noted}");
    let quiet = from(0.3).expect("it runs").notes.join(" ");
    assert!(!quiet.contains("inertia"), "{quiet}");
}
